"""The prototype's double wishbone on its obstacle, against converged references of two other formulations.

``tests/files/prototype/README.md`` says where they come from: one came with the model (two free coordinates), the other
is made by ``tests/twins/double_wishbone_twin.py`` (absolute coordinates). They agree to 1.3e-13 of each range. Here
jounce meets them, for both tyres and three speeds, to what was asked of it and to almost all digits.
"""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import jounce as jn

pytestmark = pytest.mark.source(
    kind="computed",
    of="suspension kinematics",
    key="quarter-car-prototype",
    where="its double wishbone in two other formulations, tests/files/prototype; they agree to 1.3e-13",
    tolerance="1e-11 of the largest value, 1e-5 at the default tolerance",
)

ROOT = Path(__file__).parents[1]
FILES = ROOT / "files" / "prototype"
CHANNELS = {
    "zs": "sprung.z",
    "zu": "unsprung.z",
    "as": "sprung.az",
    "au": "unsprung.az",
    "tyre_force": "tyre.force",
    "strut_force": "strut.force",
}
TYRES = ("bilateral", "unilateral")
SPEEDS = (1.95, 2.86, 3.79)


def rig(tyre: str):
    described = jn.load(str(ROOT / "files" / "prototype-double-wishbone.toml"))
    return described.with_changes({"tyre.lift_off": tyre == "unilateral"})


def trial(speed: float):
    """10 mm high and 100 mm long half-sine, met 0.2 s after the start."""
    road = jn.HalfSine(height="10 mm", length="100 mm", start=0.2 * speed)
    return jn.Trial(road=road, speed=speed, duration="3 s")


def reference(tyre: str, speed: float) -> dict[str, np.ndarray]:
    with np.load(FILES / f"double_wishbone_{tyre}_{speed}.npz") as stored:
        return {name: stored[name] for name in stored}


def errors(run, expected) -> dict[str, float]:
    """Largest difference over the largest value, channel by channel."""
    assert np.allclose(run["time"], expected["time"], rtol=0.0, atol=1e-12)
    return {
        name: float(
            np.abs(run[channel].values - expected[name]).max() / np.abs(expected[name]).max()
        )
        for name, channel in CHANNELS.items()
    }


def test_rig_file_holds_the_numbers_of_the_model() -> None:
    model = json.loads((FILES / "double_wishbone.json").read_text(encoding="utf-8"))
    ours, points = rig("bilateral"), model["hardpoints"]
    names = {
        "lower_ball_joint": "BJ_L",
        "upper_ball_joint": "BJ_U",
        "tie_rod_inner": "T_C",
        "tie_rod_outer": "T_U",
    }
    names |= {"wheel_centre": "W", "strut_bottom": "S_A", "strut_top": "S_C"}
    for name, other in names.items():
        assert getattr(ours.hardpoints, name) == pytest.approx(points[other], abs=1e-15)
    for arm, other in (("lower", "P_L"), ("upper", "P_U")):
        ends = [np.array(getattr(ours.hardpoints, f"{arm}_arm_{end}")) for end in ("front", "rear")]
        assert np.sum(ends, axis=0) / 2.0 == pytest.approx(np.array(points[other]), abs=1e-15)
        assert np.cross(ends[0] - ends[1], [1.0, 0.0, 0.0]) == pytest.approx(np.zeros(3), abs=1e-15)
    assert ours.strut.spring.rate == model["strut"]["k"]
    assert ours.tyre.stiffness == model["tyre"]["k"]


def test_design_is_the_static_equilibrium() -> None:
    """Static values of the model's file: design position, 207.972 N on the tyre, 322.3716 N in the strut."""
    found = jn.equilibrium(rig("unilateral"))
    static = json.loads((FILES / "double_wishbone.json").read_text(encoding="utf-8"))["static"]
    assert found["tyre.force"] == pytest.approx(static["tyre_force"], rel=1e-10)
    assert found["strut.force"] == pytest.approx(static["strut_force"], rel=1e-10)
    assert found["sprung.z"] == pytest.approx(0.0, abs=1e-13)
    assert found["unsprung.z"] == pytest.approx(0.0, abs=1e-13)


@pytest.mark.parametrize("speed", SPEEDS)
@pytest.mark.parametrize("tyre", TYRES)
def test_displacements_meet_the_default_tolerance(tyre: str, speed: float) -> None:
    found = errors(jn.simulate(rig(tyre), trial(speed)), reference(tyre, speed))
    assert max(found["zs"], found["zu"]) == pytest.approx(0.0, abs=1e-5)


@pytest.mark.parametrize("speed", SPEEDS)
@pytest.mark.parametrize("tyre", TYRES)
def test_all_channels_converge_to_the_reference(tyre: str, speed: float) -> None:
    """At a tight tolerance every channel, accelerations and forces too, to 1e-11 (found: 2e-12)."""
    run = jn.simulate(rig(tyre), trial(speed), tolerance=1e-10)
    assert max(errors(run, reference(tyre, speed)).values()) == pytest.approx(0.0, abs=1e-11)
    assert run.attrs["events"] == (10 if tyre == "unilateral" else 0)


@pytest.mark.parametrize("tyre", TYRES)
def test_reference_that_came_with_the_model(tyre: str) -> None:
    with np.load(FILES / "double_wishbone_reference.npz") as stored:
        prefix = "lin_1.95_" if tyre == "bilateral" else "uni_1.95_"
        expected = {
            name: stored[prefix + {"tyre_force": "Ftyre", "strut_force": "Fstrut"}.get(name, name)]
            for name in CHANNELS
        }
        expected["time"] = stored["t"]
    found = errors(jn.simulate(rig(tyre), trial(1.95), tolerance=1e-10), expected)
    assert max(found.values()) == pytest.approx(0.0, abs=1e-11)


@pytest.mark.no_source
@pytest.mark.parametrize("tyre", TYRES)
def test_loops_stay_closed(tyre: str) -> None:
    run = jn.simulate(rig(tyre), trial(3.79), tolerance=1e-4, detail=True)
    assert float(run["constraint.residual"].max()) < 1e-9


@pytest.mark.no_source
def test_another_tyre_would_be_noticed() -> None:
    """The two tyres differ by far more than the tolerances: lift-off is at work."""
    run = jn.simulate(rig("bilateral"), trial(1.95))
    assert errors(run, reference("unilateral", 1.95))["zs"] > 0.5


@pytest.mark.no_source
@pytest.mark.slow
@pytest.mark.parametrize("tyre", TYRES)
def test_twin_made_the_references(tyre: str) -> None:
    """The stored references are what the twin gives today."""
    import double_wishbone_twin as twin

    model = json.loads((FILES / "double_wishbone.json").read_text(encoding="utf-8"))
    expected = reference(tyre, 2.86)
    count = 601  # to 0.6 s: all contact events
    corner = twin.prototype(model, unilateral=tyre == "unilateral")
    found = corner.run(
        twin.Obstacle(0.01, 0.1, 2.86), expected["time"][:count], rtol=1e-11, atol=1e-13
    )
    for name in CHANNELS:
        assert np.abs(found[name] - expected[name][:count]).max() < 1e-11 * np.ptp(expected[name])
