"""Static equilibrium by Newton's method: where it is found, and where it is not."""

from __future__ import annotations

import numpy as np
import pytest

from jounce import parts
from jounce.core.errors import SimulationError
from jounce.models import build
from jounce.simulation import equilibrium, linearise, modes
from jounce.simulation.compiled import compile_model
from jounce.simulation.statics import find_equilibrium

KART = parts.load("kart-quarter-car")
POINTS = [0.0, 0.001, 0.002, 0.004, 0.01]
HARD = {
    "stop closed": {"strut.bump_stop": {"gap": 0.005, "rate": 6e4, "progression": 3e8}},
    "hard stop": {"strut.bump_stop": {"gap": 0.001, "rate": 1e7}},
    "stop always closed": {"strut.bump_stop": {"gap": -0.02, "rate": 6e6, "progression": 3e10}},
    "preload above the weight": {"strut.spring.preload": 400.0},
    "preload far above": {"strut.spring.preload": 4e4},
    "tyre with a dead zone": {
        "tyre.stiffness": None,
        "tyre.curve": {
            "kind": "table",
            "deflection": POINTS,
            "force": [0.0, 0.0, 150.0, 420.0, 1400.0],
        },
    },
    "tyre with a plateau": {
        "tyre.stiffness": None,
        "tyre.curve": {
            "kind": "table",
            "deflection": POINTS,
            "force": [0.0, 60.0, 60.0, 420.0, 1400.0],
        },
    },
    "digressive tyre": {
        "tyre.stiffness": None,
        "tyre.curve": {
            "kind": "table",
            "deflection": POINTS,
            "force": [0.0, 60.0, 150.0, 180.0, 190.0],
        },
    },
    "cubic tyre": {
        "tyre.stiffness": None,
        "tyre.curve": {"kind": "polynomial", "coefficients": [1.0, 0.0, 1e10]},
    },
    "cubic spring": {
        "strut.spring": {
            "rate": None,
            "curve": {"kind": "polynomial", "coefficients": [10.0, 0.0, 2e7]},
        }
    },
    "spring with play": {
        "strut.spring": {
            "rate": None,
            "curve": {
                "kind": "table",
                "deflection": [-0.02, 0.0, 0.01, 0.02],
                "force": [0.0, 0.0, 0.0, 340.0],
            },
        }
    },
    "damper with an offset": {
        "strut.damper": {"velocity": [-1.0, -0.2, 0.05, 1.0], "force": [-120.0, -60.0, -30.0, 30.0]}
    },
    "very soft": {"strut.spring.rate": 20.0},
    "very hard": {"strut.spring.rate": 1e8, "tyre.stiffness": 1e9},
    "quadratic spring": {
        "strut.spring": {"rate": None, "curve": {"kind": "polynomial", "coefficients": [0.0, 2e6]}}
    },
}
POWER = {"kind": "power", "coefficient": 1.5e6, "exponent": 1.4}
LEVEL = {"kind": "table", "deflection": [0.0, 0.1]}
QUADRATIC = {"kind": "polynomial", "coefficients": [0.0, 2e7]}


def check(changes, height=0.0):
    rig = KART.with_changes(changes)
    found = equilibrium(rig, road_height=height)
    assert found["tyre.force"] == pytest.approx(206.01, rel=1e-9)
    assert found["strut.force"] * np.cos(rig.strut.angle) == pytest.approx(156.96, rel=1e-9)
    assert found["sprung.az"] == pytest.approx(0.0, abs=1e-9)
    assert found["unsprung.az"] == pytest.approx(0.0, abs=1e-7)
    assert found["sprung.vz"] == found["unsprung.vz"] == 0.0


@pytest.mark.parametrize("name", HARD)
def test_weights_are_carried(name):
    check(HARD[name])


@pytest.mark.parametrize("height", [-0.3, 2.0])
@pytest.mark.parametrize("name", [name for name in HARD if name != "cubic tyre"])
def test_weights_are_carried_on_any_height(name, height):
    check(HARD[name], height)


def test_progressive_tyre_on_a_low_road():
    check(HARD["cubic tyre"], -0.3)


@pytest.mark.parametrize(
    "changes",
    [
        {"tyre.stiffness": None, "tyre.curve": POWER},
        {"tyre.stiffness": None, "tyre.curve": {**POWER, "exponent": 1.0}},
        {"tyre.stiffness": None, "tyre.curve": {**POWER, "coefficient": 1.5e4, "exponent": 0.8}},
        {"tyre.stiffness": None, "tyre.curve": QUADRATIC},
        {"strut.spring": {"rate": None, "curve": POWER}},
    ],
    ids=["power tyre", "exponent 1", "exponent 0.8", "quadratic tyre", "power spring"],
)
def test_laws_that_start_flat(changes):
    check(changes)


def test_hysteresis_is_not_wound_up_at_rest():
    damper = {
        "kind": "bouc-wen",
        "coefficient": 80.0,
        "hysteretic_force": 20.0,
        "rate": 800.0,
        "sigma": 0.8,
        "exponent": 2.0,
    }
    rig = KART.with_changes({"strut.damper": damper})
    compiled = compile_model(build(rig))
    rest = find_equilibrium(compiled, compiled.parameter_values(rig.parameters()), np.zeros(2))
    assert abs(rest.x[4]) < 1e-12


@pytest.mark.parametrize(
    "changes",
    [
        {"strut.spring": {"rate": None, "curve": {**LEVEL, "force": [0.0, 0.0]}}},
        {"strut.spring": {"rate": None, "curve": {**LEVEL, "force": [100.0, 100.0]}}},
        {"gravity": -9.81},
    ],
    ids=["no spring", "constant force", "the world upside down"],
)
def test_weights_that_nothing_carries(changes):
    with pytest.raises(SimulationError, match=r"no static equilibrium.*carry the weight"):
        equilibrium(KART.with_changes(changes))


def test_without_gravity_nothing_is_deflected():
    found = equilibrium(KART.with_changes({"gravity": 0.0}))
    assert found["sprung.z"] == found["unsprung.z"] == found["tyre.force"] == 0.0


def test_modes_are_plain_numbers():
    """Results serialise and print as numbers."""
    for mode in modes(KART):
        assert 0.0 < mode.damping_ratio < 1.0
        assert mode.damped_frequency_hz == pytest.approx(
            mode.frequency_hz * np.sqrt(1.0 - mode.damping_ratio**2), rel=1e-9
        )
        assert max(abs(complex(*shape)) for shape in mode.shape.values()) == pytest.approx(1.0)


def test_states_are_called_as_the_channels_are():
    """No speed has two names: what moves in a lumped vehicle is shown under the name of its state."""
    for name in ("kart-quarter-car", "audi-a6-half-car", "audi-a6-full-car"):
        rig = parts.load(name)
        model = linearise(rig)
        assert set(model.states) <= set(model.outputs)
        assert not any(" " in key for key in equilibrium(rig))
    half = linearise(parts.load("audi-a6-half-car"))
    assert half.states == ("body.z", "body.pitch", "body.vz", "body.pitch_rate")
