"""What looks wrong with a vehicle is told with its number; shipped vehicles are sound."""

from __future__ import annotations

import pytest

import jounce as jn
from jounce import parts

FULL = jn.load("audi-a6-full-car")
TABLE = {"velocity": [-1.0, 0.0, 1.0], "force": [1000.0, 0.0, -1000.0]}
CASES = {
    "front.distance": ({"front.distance": 1290.0}, "millimetres given as metres?", 1290.0),
    "rear.track": ({"rear.track": 1540.0}, "millimetres given as metres?", 1540.0),
    "body.height": ({"body.height": 550.0}, "millimetres given as metres?", 550.0),
    "body.pitch_inertia": (
        {"body.pitch_inertia": 250.0},
        "dynamic index",
        250.0 / (1636.0 * 1.29 * 1.62),
    ),
    "front.spring_rate": ({"front.spring_rate": "28 N/m"}, "would bounce at 0.0395 Hz", 0.039462),
    "rear.damping_coefficient": (
        {"rear.damping_coefficient": "2500 N*s/mm"},
        "damping ratio of 453",
        453.0,
    ),
    "front.unsprung_mass": (
        {"front.unsprung_mass": 450.0},
        "more than half of the 455.4 kg",
        450.0,
    ),
    "front.bump_stop.gap": (
        {"front.bump_stop": {"gap": 0.02, "rate": 1e5}},
        "closed at rest.*159.5 mm",
        0.02,
    ),
    "rear.rebound_stop.gap": (
        {"rear.rebound_stop": {"gap": -0.2, "rate": 1e5}},
        "closed at rest.*169.4 mm",
        -0.2,
    ),
    "front.roll_centre_height": ({"front.roll_centre_height": 0.7}, "leans into the turn", 0.7),
    "front.damper.force": (
        {"front.damping_coefficient": None, "front.damper": TABLE},
        "drives the motion",
        1000.0,
    ),
}


@pytest.mark.parametrize(
    "name", [name for name in parts.library() if isinstance(jn.load(name), jn.Vehicle)]
)
def test_shipped_vehicles_are_sound(name):
    assert parts.rig_findings(jn.load(name)) == []


@pytest.mark.parametrize("place", CASES)
def test_findings(place):
    changes, message, value = CASES[place]
    (found,) = parts.rig_findings(FULL.with_changes(changes), "car.toml")
    assert found.place == f"car.toml: {place}"
    assert found.severity == "warning"
    assert found.value == pytest.approx(value, rel=2e-3)
    with pytest.raises(AssertionError, match=message):
        raise AssertionError(found.message)


def test_stops_that_are_open_at_rest_are_fine():
    stops = {
        "front.bump_stop": {"gap": 0.2, "rate": 1e5},
        "front.rebound_stop": {"gap": -0.1, "rate": 1e5},
    }
    assert parts.rig_findings(FULL.with_changes(stops)) == []


def test_estimated_values_that_do_not_exist():
    (found,) = parts.rig_findings(
        FULL.model_copy(update={"estimated": ("body.heigth", "front.tyre", "body.mass")})
    )
    assert found.severity == "note"
    assert "'body.heigth' is neither a parameter" in found.message
