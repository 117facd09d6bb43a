"""A call that fails names the argument of another kind; what works, and what fails otherwise, is left alone."""

from __future__ import annotations

import inspect
import pickle
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, Literal

import numpy as np
import pandas as pd
import pytest
import xarray as xr
from numpy.typing import ArrayLike, NDArray

import jounce as jn
from jounce.core.arguments import _hints, fits, guard_arguments, misfit

RIG = jn.load("kart-quarter-car")
TRIAL = jn.Trial(road=jn.Step(height="10 mm"), speed="3 m/s", duration="0.2 s")
RUN = jn.simulate(RIG, TRIAL)
NUMBERS = np.array([1.0, 2.0])
X = np.arange(0.0, 50.0, 0.1)


@pytest.mark.parametrize(
    ("hint", "fitting", "others"),
    [
        (
            float,
            [1, 2.5, True, np.float64(1.0), np.array(1.0), float("nan")],
            ["1", None, [1.0], NUMBERS, 1j, 10**400],
        ),
        (int, [1, np.int64(2)], [1.5, "1", None, 10**400]),
        (bool, [True, np.True_, 1], [2, "yes", None, NUMBERS]),
        (str, ["a"], [1, b"a", None, Path("a")]),
        (Path | str, ["a", Path("a")], [1, None, RUN]),
        (Literal["a", 2], ["a", 2], ["b", 3, None, pd.Series([1])]),
        (
            ArrayLike,
            [NUMBERS, [1, 2], pd.Series([1.0]), 3.0],
            ["a", None, RUN, RIG, {}, [[1.0], [1.0, 2.0]]],
        ),
        (ArrayLike | None, [NUMBERS, None], ["a", RUN]),
        (NDArray[np.float64], [NUMBERS], ["a", None]),
        (
            Sequence[str],
            [["a"], ("a",), [], np.array(["a"])],
            ["a", [1], {"a": 1}, None, {"a"}, RIG, RUN[["time"]]],
        ),
        (Sequence[float], [[1.0], NUMBERS, pd.Series([1.0])], ["ab", ["a"], np.ones((2, 2)), 1.0]),
        (Iterable[str], [{"a"}, iter(["a"])], ["a", 1]),
        (tuple[float, float], [(1.0, 2.0), [1.0, 2.0]], [(1.0,), pd.Series([1.0, 2.0]), 1.0]),
        (
            Mapping[str, float],
            [{"a": 1.0}, {}],
            [{"a": "b"}, {1: 1.0}, [("a", 1.0)], pd.DataFrame({"a": [1.0]})],
        ),
        (Callable[[str], None], [print, jn.Trial], ["print", None]),
        (jn.Rig, [RIG], [TRIAL, "kart-quarter-car", None]),
        (xr.Dataset, [RUN], [RUN["tyre.force"], pd.DataFrame(), None]),
        (Any, [None, RIG], []),
    ],
    ids=lambda value: None if isinstance(value, list) else str(value),
)
def test_what_fits_an_annotation(hint: Any, fitting: list[Any], others: list[Any]) -> None:
    assert [value for value in fitting if not fits(value, hint)] == []
    assert [value for value in others if fits(value, hint)] == []


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: jn.simulate(RIG, TRIAL.road), r"simulate: trial: a Step was given; allowed: a trial or what holds on"),
        (lambda: jn.gradient(RIG, RUN, ["tyre.stiffness"], TRIAL), r"trial: a Dataset .*'objective': are the argum"),
        (lambda: jn.update_model([RUN], {"sprung.mass": 0.1}), r"trials\[0\]: a Dataset was given.*jn.FitTrial\(name"),
        (lambda: jn.update_model([jn.FitTrial("a", RIG, RIG, RUN)], {"sprung.mass": 0.1}), r"trial: a QuarterCar"),
        (lambda: jn.load(RIG), r"load: name: a QuarterCar was given; allowed: a text or a path"),
        (lambda: jn.estimate_roughness(X, X, band=(0.1, None)), r"band\[1\]: invalid physical value; found 'None'"),
    ],
)  # fmt: skip
def test_the_message_names_the_argument(call: Callable[[], object], message: str) -> None:
    with pytest.raises(jn.DescriptionError, match=message):
        call()


def test_other_failures_are_left_alone() -> None:
    def inverse(of: float) -> float:
        return 1.0 / of

    call = guard_arguments(inverse, "inverse")
    assert call(2.0) == 0.5
    assert call(NUMBERS)[1] == 0.5, "what works is not refused"
    for wrong, kind in ((0.0, ZeroDivisionError), ([1.0], jn.DescriptionError)):
        with pytest.raises(kind):
            call(wrong)
    with pytest.raises(TypeError, match="missing 1 required"):
        call()


def test_a_text_is_no_flag(tmp_path: Path) -> None:
    file = jn.save(RIG, tmp_path / "rig.toml")
    with pytest.raises(
        jn.DescriptionError, match="save: force: 'no' was given; allowed: True or False"
    ):
        jn.save(RIG, file, force="no")
    assert jn.save(RIG, file, force=1) == file


def test_an_error_of_the_function_is_no_misfit() -> None:
    def inverse(of: float) -> float:
        return 1.0 / of

    assert misfit(inverse, (0.0,), {}) is None


PUBLIC = [name for name in jn.__all__ if inspect.isfunction(getattr(jn, name))]


def test_public_functions_are_guarded_and_found_where_they_say() -> None:
    assert len(PUBLIC) > 100
    assert [
        name
        for name in PUBLIC
        if pickle.loads(pickle.dumps(getattr(jn, name))) is not getattr(jn, name)
    ] == []
    for name in PUBLIC:
        function = inspect.unwrap(getattr(jn, name))
        named = [
            p.name
            for p in inspect.signature(function).parameters.values()
            if p.kind is not p.VAR_KEYWORD
        ]
        assert set(named) <= _hints(function).keys(), (
            f"{name}: an annotation that cannot be looked up"
        )
