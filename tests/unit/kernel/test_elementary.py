"""Sine, cosine and their inverses of vectors, held against the library's."""

import casadi as ca
import numpy as np
import pytest

from jounce.core.errors import SimulationError
from jounce.kernel import machine
from jounce.kernel.lowering import Wide
from jounce.kernel.native import compile_functions

WIDE = 8
LIBRARY = {
    "sin": np.sin,
    "cos": np.cos,
    "asin": np.arcsin,
    "acos": np.arccos,
    "atan": np.arctan,
    "atan2": np.arctan2,
}


@pytest.fixture(scope="module", params=["", *machine.LEVELS])
def processor(request):
    """Make code for this processor, then for those without vectors of four, without fused products."""
    if request.param not in ("", *machine.levels()):
        pytest.skip("this processor is below that level")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("JOUNCE_PROCESSOR", request.param)
        forget_processor()
        yield
    forget_processor()


def forget_processor():
    machine.processor.cache_clear()
    machine.features.cache_clear()


@pytest.fixture(scope="module")
def native(processor):
    """Each function of eight systems, of one or two states."""
    x = ca.SX.sym("x", 2)
    none = [ca.SX.sym(name, 0) for name in "upm"]
    values = {name: getattr(ca, name)(x[0]) for name in LIBRARY if name != "atan2"} | {
        "atan2": ca.atan2(x[0], x[1])
    }
    return compile_functions(
        {name: Wide(ca.Function(name, [x, *none], [value]), WIDE) for name, value in values.items()}
    )


def evaluated(native, name, x, y=None):
    y = np.zeros_like(x) if y is None else y
    blocks = np.stack([x.reshape(-1, WIDE), y.reshape(-1, WIDE)], axis=1)
    none = np.zeros(0)
    return np.concatenate(
        [native.evaluate(name, (WIDE,), block.ravel(), none, none, none) for block in blocks]
    )


def units_off(found, expected):
    """Difference in units in the last place."""
    return np.abs(found - expected) / np.spacing(np.maximum(np.abs(expected), 1e-300))


@pytest.mark.parametrize(("name", "size"), [("sin", 4.0), ("cos", 4.0), ("sin", 1e6), ("cos", 1e6)])
def test_of_angles(native, name, size):
    x = np.random.default_rng(1).uniform(-size, size, 8000)
    assert np.max(np.abs(evaluated(native, name, x) - LIBRARY[name](x))) < 2.5e-16
    assert np.max(units_off(evaluated(native, "sin", x * 1e-9), np.sin(x * 1e-9))) <= 1.0


@pytest.mark.parametrize("name", ["asin", "acos", "atan"])
def test_of_ratios(native, name):
    x = np.append(
        np.random.default_rng(2).uniform(-1.0, 1.0, 7990),
        [0.0, -0.0, 1.0, -1.0, 0.5, -0.5, 1e-9, -1e-9, 0.66, 0.67],
    )
    assert np.max(units_off(evaluated(native, name, x), LIBRARY[name](x))) <= 3.0


def test_of_points_in_all_quarters_and_on_the_axes(native):
    turn = np.random.default_rng(3).uniform(-np.pi, np.pi, 8000)
    size = 10.0 ** np.random.default_rng(4).uniform(-6, 6, 8000)
    y, x = size * np.sin(turn), size * np.cos(turn)
    y[:8], x[:8] = (
        [0.0, 1.0, 0.0, -1.0, 0.0, -0.0, 2.0, -2.0],
        [1.0, 0.0, -1.0, 0.0, 0.0, -1.0, 2.0, -2.0],
    )
    assert np.max(units_off(evaluated(native, "atan2", y, x), np.arctan2(y, x))) <= 3.0
    y, x = (
        np.array([0.0, -0.0, 0.0, -0.0, 1.0, -1.0, 1.0, -1.0]),
        np.array([0.0, 0.0, -0.0, -0.0, 0.0, 0.0, -0.0, -0.0]),
    )
    found = evaluated(native, "atan2", y, x)
    assert np.max(units_off(found, np.arctan2(y, x))) <= 1.0
    assert np.array_equal(np.signbit(found), np.signbit(y))


def test_what_is_no_number_stays_none(native):
    x = np.array([np.nan, np.inf, -np.inf, 1.5, -1.5, 0.0, 1.0, 0.5])
    with np.errstate(invalid="ignore"):
        for name in ("sin", "cos", "asin", "acos"):
            assert np.array_equal(
                np.isnan(evaluated(native, name, x)), np.isnan(LIBRARY[name](x))
            ), name
    assert np.isnan(evaluated(native, "atan2", x, np.ones(8))[0])


@pytest.mark.parametrize("level", ["x86-64-v9", "haswell"])
def test_a_level_that_is_none_or_not_reached_is_refused(monkeypatch, level):
    monkeypatch.setenv("JOUNCE_PROCESSOR", level)
    forget_processor()
    with pytest.raises(
        SimulationError, match=f"JOUNCE_PROCESSOR.*found '{level}'; allowed: .*Unset it"
    ):
        machine.this_machine()
    forget_processor()
