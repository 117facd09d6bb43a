"""What reaches over to the other wheel is drawn: bars, third springs, and torsion bars on their axes."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.plots.mechanisms.scene import poses_of, scene_of
from jounce.report.live import PosedRig, mechanism_data

U_BAR = {
    "hardpoints.arb_pivot": [-0.08, 0.15, 0.36],
    "hardpoints.arb_arm_end": [-0.15, 0.15, 0.44],
    "hardpoints.arb_link_end": [0.0, 0.22, 0.43],
    "anti_roll_bar": {"stiffness": 900.0, "on": "rocker", "kind": "z"},
}
BESIDE = {
    "third_spring": {"spring": {"rate": 30e3}},
    "hardpoints.third_spring_end": [0.02, 0.21, 0.42],
    "torsion_bar": {"stiffness": 1900.0, "on": "lower_arm"},
}
T_BAR = {
    "hardpoints.arb_pivot": [-0.10, 0.0, 0.30],
    "hardpoints.arb_axis": [-0.08, 0.0, 0.45],
    "hardpoints.arb_arm_end": [-0.08, 0.16, 0.45],
    "hardpoints.arb_link_end": [0.0, 0.20, 0.44],
    "anti_roll_bar": {"stiffness": 400.0, "on": "rocker", "kind": "t"},
}


def parts_of(rig) -> dict[str, tuple[str, ...]]:
    return {part.name: part.points for part in scene_of(rig).parts}


@pytest.mark.parametrize("side", ["left", "right"])
def test_bars_third_springs_and_torsion_bars_are_parts(side: str) -> None:
    rig = jn.load("formula-student-front").with_changes({**U_BAR, **BESIDE})
    rig = rig if side == "left" else rig.mirrored()
    scene, parts = scene_of(rig), parts_of(rig)
    assert parts["anti_roll_bar"] == ("arb_middle", "arb_pivot", "arb_arm_end", "arb_link_end")
    assert parts["third_spring"] == ("third_spring_end", "third_spring_middle")
    assert parts["torsion_bar"] == ("lower_arm_front", "lower_arm_rear")
    assert {"arb_middle", "arb_pivot"} <= scene.on_body
    poses = poses_of(rig, scene, jn.sweep_travel(rig, [-0.01, 0.0, 0.02], points=True))
    for end, middle in (("third_spring_end", "third_spring_middle"), ("arb_pivot", "arb_middle")):
        assert poses.points[middle][:, 1] == pytest.approx(0.0)
        assert np.allclose(poses.points[middle][:, [0, 2]], poses.points[end][:, [0, 2]])
    assert np.ptp(poses.points["third_spring_middle"][:, 2]) > 1e-4


def test_bars_with_an_axis_are_drawn_along_it() -> None:
    rig = jn.load("formula-student-front")
    given = rig.with_changes({**U_BAR, "hardpoints.arb_axis": [-0.1, 0.02, 0.38]})
    assert parts_of(given)["anti_roll_bar"] == (
        "arb_axis",
        "arb_pivot",
        "arb_arm_end",
        "arb_link_end",
    )
    assert "arb_middle" not in scene_of(given).design.points
    stem = scene_of(rig.with_changes(T_BAR))
    assert {part.name: part.points for part in stem.parts}["anti_roll_bar"] == (
        "arb_pivot", "arb_axis", "arb_arm_end", "arb_link_end"
    )  # fmt: skip
    assert "arb_axis" not in stem.on_body


def test_third_springs_are_springs_in_the_viewer() -> None:
    rig = jn.load("formula-student-front").with_changes({**U_BAR, **BESIDE})
    scene = scene_of(rig)
    poses = poses_of(rig, scene, jn.sweep_travel(rig, [0.0], points=True))
    parts = {part["name"]: part for part in mechanism_data(PosedRig(scene, poses))["parts"]}
    assert [name for name, part in parts.items() if part["coil"]] == ["third_spring"]
    assert len(parts["third_spring"]["points"]) == 2
