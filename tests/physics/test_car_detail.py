"""Reactions of joints of a car on 3-D corners: those of its corners alone, of load cases, and in balance."""

from __future__ import annotations

import numpy as np
import pytest
from car_at_rest import at_rest, body_centre, force, kept_level, loaded, place, without_weights

import jounce as jn
from jounce.kinematics.load_cases import _of_wheel as of_wheel
from jounce.kinematics.load_cases import from_across

FS = jn.load("formula-student-car")
PICKUPS = {  # joints by the hardpoints that load cases give their forces at
    "lower_arm": ("lower_arm_front", "lower_arm_rear"),
    "upper_arm": ("upper_arm_front", "upper_arm_rear"),
    "lower_ball_joint": ("lower_ball_joint",),
    "upper_ball_joint": ("upper_ball_joint",),
    "tie_rod": ("tie_rod_outer",),
    "rocker": ("rocker_pivot",),
}


def torque(run, name: str) -> np.ndarray:
    return np.array([float(run[f"{name}.t{axis}"]) for axis in "xyz"])


def reactions(run, prefix: str = "") -> dict[str, float]:
    ends = tuple(f".{kind}{axis}" for kind in "ft" for axis in "xyz")
    return {
        n.removeprefix(prefix): float(run[n])
        for n in run
        if n.startswith(prefix) and n.endswith(ends)
    }


def test_a_run_shows_them():
    """All that a corner shows of itself, each car's corner shows under its name, from the first sample on."""
    trial = jn.Trial(road=jn.Flat(), speed=10.0, duration=0.01, lateral_acceleration=3.0)
    run = jn.simulate(FS, trial, detail=True)
    alone = jn.simulate(
        FS.front.corner, jn.Trial(road=jn.Flat(), speed=10.0, duration=0.01), detail=True
    )
    own = {
        name for name in alone if not name.startswith(("sprung", "energy", "constraint", "guide"))
    }
    assert len(own) > 80
    for which in FS.corners:
        assert {f"{which}.{name}" for name in own} <= set(run)
    rest = at_rest(FS, lateral_acceleration=3.0)
    for name in reactions(rest):
        assert float(run[name][0]) == pytest.approx(rest[name], abs=1e-6), name
        assert run[name].attrs["units"] == ("N" if name[-2] == "f" else "N*m")
    shown = jn.simulate(FS, trial)
    assert "front_left.lower_arm.fx" not in shown
    assert {"energy.kinetic", "energy.weight"} <= set(run)


def test_a_level_car_has_the_reactions_of_its_corner():
    """On a guide, under as much weight as the car puts on a wheel: every force, torque and place of a joint."""
    car = FS.with_changes({f"{end}.anti_roll_bar_rate": 0.0 for end in ("front", "rear")})
    _, run = kept_level(car)
    corner = car.front.corner
    weight = sum(body.mass for body in corner.body_masses().values())
    changes = {
        "sprung.mass": run["front_left.tyre.force"] / car.gravity - weight,
        "tyre.law": "radial",
    }
    alone = jn.simulate(
        corner.with_changes(changes),
        jn.Trial(road=jn.Flat(), speed=1.0, duration=0.001),
        detail=True,
    ).isel(time=0)
    assert float(alone["tyre.force"]) == pytest.approx(run["front_left.tyre.force"], rel=1e-12)
    own = reactions(run, "front_left.")
    assert len(own) >= 6 * 7
    size = max(map(abs, own.values()))
    assert size > 500.0
    for name, value in own.items():
        assert float(alone[name]) == pytest.approx(value, abs=1e-9 * size), name


U_BAR = {
    "hardpoints.arb_pivot": [-0.08, 0.15, 0.36],
    "hardpoints.arb_arm_end": [-0.15, 0.15, 0.44],
    "hardpoints.arb_link_end": [0.0, 0.22, 0.43],
    "anti_roll_bar": {"stiffness": 900.0, "on": "rocker"},
}
T_BAR = {
    "hardpoints.arb_pivot": [-0.10, 0.0, 0.30],
    "hardpoints.arb_axis": [-0.08, 0.0, 0.45],
    "hardpoints.arb_arm_end": [-0.08, 0.16, 0.45],
    "hardpoints.arb_link_end": [0.0, 0.20, 0.44],
    "anti_roll_bar": {"stiffness": 400.0, "on": "rocker", "kind": "t"},
}
Z_BAR = {
    "hardpoints.arb_pivot": [0.0, 0.2, 0.12],
    "hardpoints.arb_arm_end": [0.1, 0.3, 0.12],
    "hardpoints.arb_link_end": [0.1, 0.32, 0.18],
    "anti_roll_bar": {"stiffness": 900.0, "on": "lower_arm", "kind": "z"},
}
THIRD = {
    "third_spring": {"on": "upper_arm", "spring": {"rate": 30e3, "preload": 150.0}},
    "hardpoints.third_spring_end": [0.02, 0.41, 0.32],
}
ACROSS = {"nothing": {}, "U-bar": U_BAR, "T-bar": T_BAR, "Z-bar": Z_BAR, "third spring": THIRD}


@pytest.mark.parametrize(  # each is a model of its own, which takes seconds to make
    "name",
    [
        pytest.param(name, marks=[pytest.mark.slow] if name in ("U-bar", "Z-bar") else [])
        for name in ACROSS
    ],
)
def test_reactions_are_those_of_load_cases(name):
    """In a bend on a road that is higher on the left, with the body level, as load cases have it; tie rods, too.

    Bars and third springs reach over to the other wheel; load cases put their forces on the parts by themselves.
    """
    changes = {
        f"{end}.corner.{path}": value
        for end in ("front", "rear")
        for path, value in ACROSS[name].items()
    }
    roads = {
        f"{end}_{side}.road.z": 0.015 * (side == "left")
        for end in ("front", "rear")
        for side in ("left", "right")
    }
    car = without_weights(FS).with_changes(changes)
    turned, run = kept_level(car, **roads)
    assert abs(turned) > 1.0
    sides = {which: loaded(car, run, which) for which in ("front_left", "front_right")}
    travels = tuple(travel for _, travel, _, _ in sides.values())
    across = from_across(sides["front_left"][0], travels) if ACROSS[name] else (None, None)
    for (which, (corner, travel, normal, held)), other in zip(sides.items(), across, strict=True):
        load = jn.ContactLoad(lateral_force=turned * held, vertical_force=normal)
        case = of_wheel(corner, load, travel, other)
        size = max(abs(value) for value, unit, _ in case.values() if unit == "N")
        assert size > 500.0
        for joint, points in PICKUPS.items():
            # there on the part nearer to the body, here on the one nearer to the wheel
            expected = [-sum(case[f"{point}.f{axis}"][0] for point in points) for axis in "xyz"]
            assert force(run, f"{which}.{joint}") == pytest.approx(expected, abs=1e-6 * size), joint
        pushed = [case[f"pushrod_inner.f{axis}"][0] for axis in "xyz"]  # of both on the rocker
        assert force(run, f"{which}.pushrod") == pytest.approx(pushed, abs=1e-6 * size)
    reached = [
        abs(run[name])
        for name in run
        if name.endswith(("anti_roll_bar.torque", "third_spring.force"))
    ]
    assert bool(reached) == bool(ACROSS[name])
    assert min(reached, default=10.0) > 1.0


@pytest.mark.parametrize("load", [{"lateral_acceleration": 5.0}, {"deceleration": 4.0}], ids=str)
def test_uprights_and_body_are_in_balance(load):
    """By hand: weights, inertia, road, struts and all joints on an upright with its wheel, and on the leaning body."""
    car = FS.with_changes({f"{end}.anti_roll_bar_rate": 0.0 for end in ("front", "rear")})
    run = at_rest(car, **load)
    field = np.array(
        [load.get("deceleration", 0.0), -load.get("lateral_acceleration", 0.0), -car.gravity]
    )
    loads = {which: run[f"{which}.tyre.force"] for which in car.corners}
    masses = {name: body.mass for name, body in car.front.corner.body_masses().items()}
    total = car.body.mass + 4.0 * sum(masses.values())
    on_body = [(car.body.mass * field, body_centre(car, run))]
    for which in car.corners:
        grip = -total * field * [1.0, 1.0, 0.0] * loads[which] / sum(loads.values())
        road = grip + loads[which] * np.array([0.0, 0.0, 1.0])
        held = sum(
            force(run, f"{which}.{name}")
            for name in ("lower_ball_joint", "upper_ball_joint", "tie_rod")
        )
        assert np.abs(road + masses["upright"] * field + held).max() < 1e-6
        for name, point in (
            ("lower_arm", "lower_arm_front"),
            ("upper_arm", "upper_arm_front"),
            ("rocker", "rocker_pivot"),
        ):
            on_body.append(
                (
                    -force(run, f"{which}.{name}"),
                    place(run, f"{which}.{point}"),
                    -torque(run, f"{which}.{name}"),
                )
            )
        on_body.append((-force(run, f"{which}.tie_rod"), place(run, f"{which}.tie_rod_inner")))
        strut = place(run, f"{which}.strut_top") - place(run, f"{which}.strut_bottom")
        push = run[f"{which}.strut.force"] * strut / np.linalg.norm(strut)
        on_body.append((push, place(run, f"{which}.strut_top")))
    assert np.abs(sum(push for push, *_ in on_body)).max() < 1e-6
    about = sum(np.cross(where, push) + sum(free, np.zeros(3)) for push, where, *free in on_body)
    assert np.abs(about + torque(run, "attitude")).max() < 1e-6


@pytest.mark.parametrize("name", ["Z-bar", "third spring"])
def test_reactions_of_a_single_corner_are_those_of_load_cases(name):
    """With the other wheel moving alike: both push at the ends of their links, not at the joints of the parts."""
    corner = without_weights(FS).front.corner.with_changes({**ACROSS[name], "tyre.law": "radial"})
    run = jn.simulate(
        corner, jn.Trial(road=jn.Flat(), speed=1.0, duration=0.001), detail=True
    ).isel(time=0)
    radius = float(np.linalg.norm(place(run, "contact_point") - place(run, "wheel_centre")))
    loaded_corner = corner.with_changes(
        {"wheel.radius": radius, "tyre.undeformed_radius": corner.undeformed_radius}
    )
    travel = float(run["unsprung.z"] - run["sprung.z"])
    load = jn.ContactLoad(vertical_force=float(run["tyre.force"]))
    case = of_wheel(loaded_corner, load, travel, from_across(loaded_corner, (travel, travel))[0])
    size = max(abs(value) for value, unit, _ in case.values() if unit == "N")
    for joint, points in PICKUPS.items():
        expected = [-sum(case[f"{point}.f{axis}"][0] for point in points) for axis in "xyz"]
        assert force(run, joint) == pytest.approx(expected, abs=1e-6 * size), joint
