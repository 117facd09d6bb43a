"""Clearances against dense samples and closed forms; lengths of links against sweeps."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.kinematics.clearances import PosedCorner
from jounce.kinematics.model import kinematic_model

RIG = "formula-student-front"


@pytest.fixture(scope="module")
def rig():
    return jn.load(RIG)


def samples(found, names, index) -> np.ndarray:
    ends = [np.array([float(found[f"{name}.{axis}"][index]) for axis in "xyz"]) for name in names]
    share = np.linspace(0.0, 1.0, 1201)[:, None]
    return ends[0] + share * (ends[1] - ends[0])


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (("pushrod_outer", "pushrod_inner"), ("upper_arm_front", "upper_ball_joint")),  # they cross
        (
            ("pushrod_outer", "pushrod_inner"),
            ("lower_arm_front", "lower_arm_rear"),
        ),  # nearest at an end
        (("tie_rod_inner", "tie_rod_outer"), ("lower_arm_front", "lower_ball_joint")),
        (("wheel_centre", "wheel_centre"), ("tie_rod_inner", "tie_rod_outer")),  # a sphere
    ],
)
def test_bars_are_as_far_apart_as_their_samples(rig, one, other) -> None:
    travel = [-0.02, 0.0, 0.025]
    points = one[:1] if one[0] == one[1] else one
    pair = jn.Solid(points=points, radius="6 mm"), jn.Solid(points=other, radius="9 mm")
    found = jn.clearances(rig, {"a": pair, "b": pair[::-1]}, travel)
    swept = jn.sweep_travel(rig, travel, points=True)
    for k in range(3):
        a, b = samples(swept, one, k), samples(swept, other, k)
        apart = min(float(np.linalg.norm(b - place, axis=1).min()) for place in a[::3])
        assert float(found["a"][k, 0]) == pytest.approx(apart - 0.015, abs=2e-6)
        assert float(found["b"][k, 0]) == pytest.approx(float(found["a"][k, 0]), abs=1e-12)


def test_a_bar_along_several_points_and_parallel_bars(rig) -> None:
    arm = jn.Solid(points=("upper_arm_front", "upper_ball_joint", "upper_arm_rear"))
    rod = jn.Solid(points=("pushrod_outer", "pushrod_inner"))
    legs = [jn.Solid(points=(f"upper_arm_{end}", "upper_ball_joint")) for end in ("front", "rear")]
    found = jn.clearances(rig, {"arm": (arm, rod), "front": (legs[0], rod), "rear": (legs[1], rod)})
    assert float(found["arm"][0, 0]) == min(float(found[leg][0, 0]) for leg in ("front", "rear"))
    rear = np.add(rig.hardpoints.lower_arm_rear, [0.0, 0.0, 0.05]).tolist()
    front = np.add(rig.hardpoints.lower_arm_front, [0.0, 0.0, 0.05]).tolist()
    moved = rig.with_changes(
        {"hardpoints.rocker_pivot": rear, "hardpoints.rocker_axis": front}
    )  # both on the body
    axes = [
        jn.Solid(points=points)
        for points in (("rocker_pivot", "rocker_axis"), ("lower_arm_rear", "lower_arm_front"))
    ]
    span = np.subtract(front, rear)
    height = 0.05 * np.sqrt(1.0 - (span[2] / np.linalg.norm(span)) ** 2)
    assert float(jn.clearances(moved, {"a": tuple(axes)})["a"][0, 0]) == pytest.approx(
        height, abs=1e-12
    )


@pytest.mark.parametrize("side", ["left", "right"])
def test_a_rod_in_the_rim_as_its_samples(rig, side: str) -> None:
    corner = rig if side == "left" else rig.mirrored()
    rim, rod = (
        jn.Rim(radius="120 mm", inner="-80 mm", outer="30 mm"),
        ("tie_rod_inner", "tie_rod_outer"),
    )
    ball = jn.Solid(points=("upper_ball_joint",), radius="10 mm")
    found = jn.clearances(
        corner, {"rod": (jn.Solid(points=rod), rim), "ball": (rim, ball)}, [0.0, 0.02], [-0.02, 0.0]
    )
    assert found["rod"].sizes == {"wheel_travel": 2, "rack_travel": 2}
    for i, travel in enumerate((0.0, 0.02)):
        for j, rack in enumerate((-0.02, 0.0)):
            swept = jn.sweep_path(corner, travel, rack, points=True)
            y = 1.0 if side == "left" else -1.0
            camber, steer = float(swept["camber"][0]), float(swept["steer"][0])
            axis = np.array([-y * np.sin(steer), y * np.cos(steer), -np.tan(camber)])
            axis = axis / np.linalg.norm(axis)
            centre = np.array([float(swept[f"wheel_centre.{a}"][0]) for a in "xyz"])
            for name, points in (
                ("rod", samples(swept, rod, 0)),
                ("ball", samples(swept, ("upper_ball_joint",) * 2, 0)),
            ):
                along = (points - centre) @ axis
                out = np.linalg.norm(points - centre - np.outer(along, axis), axis=1)
                past = np.clip(along, -0.08, 0.03) - along
                apart = np.hypot(out - 0.12, past).min() - (0.01 if name == "ball" else 0.0)
                assert float(found[name][i, j]) == pytest.approx(apart, abs=3e-6), (
                    name,
                    travel,
                    rack,
                )


@pytest.mark.parametrize("side", ["left", "right"])
def test_slopes_of_clearances_are_those_of_whole_sweeps(rig, side: str) -> None:
    """Bars that cross, that are nearest at an end, a frame tube, a sphere, a rod in the rim: against differences."""
    corner = rig if side == "left" else rig.mirrored()
    y, rim = corner.sign, jn.Rim(radius="120 mm", inner="-80 mm", outer="30 mm")
    rods = {
        "crossing": (("pushrod_outer", "pushrod_inner"), ("upper_arm_front", "upper_ball_joint")),
        "end": (("pushrod_outer", "pushrod_inner"), ("lower_arm_front", "lower_arm_rear")),
        "sphere": (("wheel_centre",), ("tie_rod_inner", "tie_rod_outer")),
        "arm": (
            ("upper_arm_front", "upper_ball_joint", "upper_arm_rear"),
            ("pushrod_outer", "pushrod_inner"),
        ),
    }
    pairs = {
        name: tuple(jn.Solid(points=one, radius=0.006) for one in pair)
        for name, pair in rods.items()
    }
    rod = jn.Solid(points=("tie_rod_inner", "tie_rod_outer"))
    pairs["tube"] = rod, jn.Solid(places=[(0.065, y * 0.245, 0.1), (0.065, y * 0.245, 0.2)])
    pairs["rim"] = rod, rim
    pairs["ball in the rim"] = rim, jn.Solid(points=("lower_ball_joint",))
    model = kinematic_model(corner)
    numbers = model.parameter_values(corner)
    paths = [
        i for i, path in enumerate(model.parameters) if path.startswith(("hardpoints.", "wheel."))
    ]
    directions = np.zeros((2 + len(numbers), len(paths)))
    directions[2 + np.array(paths), np.arange(len(paths))] = 1.0
    poses = np.array([-0.02, 0.0, 0.02]), y * np.array([0.0, 0.0, 0.012])
    names = set(corner.hardpoints.given())
    exact = PosedCorner.along(corner, names, poses, numbers, directions)
    found = {name: exact.distance(*pair)[1] for name, pair in pairs.items()}
    for j, i in enumerate(paths):
        ends = []
        for sign in (1.0, -1.0):
            moved = numbers.copy()
            moved[i] += sign * 1e-6
            ends.append(PosedCorner.along(corner, names, poses, moved))
        for name, pair in pairs.items():
            one, other = (end.distance(*pair)[0] for end in ends)
            assert found[name][j] == pytest.approx((one - other) / 2e-6, abs=2e-6), (
                name,
                model.parameters[i],
            )
    assert all(np.abs(slope).max() > 0.2 for slope in found.values())


def test_lengths_of_links_are_kept_by_a_sweep(rig) -> None:
    lengths = jn.link_lengths(rig)
    swept = jn.sweep_travel(rig, [0.02], points=True)
    assert {"upper_arm_rear - upper_ball_joint", "pushrod_inner - pushrod_outer"} <= set(lengths)
    for name, length in lengths.items():
        a, b = (
            np.array([float(swept[f"{end}.{axis}"][0]) for axis in "xyz"])
            for end in name.split(" - ")
        )
        if name == "strut_bottom - strut_top":
            assert abs(np.linalg.norm(a - b) - length) > 1e-3
        else:
            assert np.linalg.norm(a - b) == pytest.approx(length, abs=1e-12), name


@pytest.mark.parametrize(
    ("pairs", "message"),
    [
        ({}, "nothing to measure"),
        ({"a": (jn.Rim(radius=0.1, inner=0.0, outer=0.1),) * 2}, "invalid pair of bodies"),
        (
            {"a": (jn.Solid(points=("tie_rod_iner",)), jn.Solid(points=("wheel_centre",)))},
            "tie_rod_inner",
        ),
    ],
)
def test_bad_pairs_are_refused(rig, pairs, message: str) -> None:
    with pytest.raises(jn.DescriptionError, match=message):
        jn.clearances(rig, pairs)
    with pytest.raises(jn.DescriptionError, match="inboard of outer"):
        jn.Rim(radius=0.1, inner=0.2, outer=0.1)
