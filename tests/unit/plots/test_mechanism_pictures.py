"""Drawings of 3-D rigs: every model and side, names that can be read, poses where the data say."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import numpy as np
import pytest
import xarray as xr

import jounce as jn
from jounce.core.errors import DescriptionError, JounceError, RecordingError
from jounce.parts.files import RIGS
from jounce.plots import figure_of, mechanism, render_figure
from jounce.plots.display import kinematic_value
from jounce.plots.labels import spread
from jounce.plots.mechanisms.drawing import coil, outline, tyre
from jounce.plots.mechanisms.geometry import _Centres
from jounce.plots.mechanisms.scene import poses_of, scene_of, spin_axes

INERTIA = {"xx": 0.1, "yy": 0.1, "zz": 0.1}
STRUT = {"spring": {"rate": 30e3, "preload": 3000.0}, "damper": {"coefficient": 2000.0}}
MCPHERSON = {
    "lower_arm_front": (0.2, 0.36, 0.2),
    "lower_arm_rear": (-0.18, 0.35, 0.19),
    "lower_ball_joint": (0.0, 0.7, 0.18),
    "tie_rod_inner": (-0.15, 0.34, 0.25),
    "tie_rod_outer": (-0.13, 0.68, 0.24),
    "wheel_centre": (0.0, 0.75, 0.31),
    "strut_bottom": (-0.005, 0.62, 0.36),
    "strut_top": (-0.03, 0.55, 0.85),
}
FIVE_LINK = {
    **{
        f"link_{i}_inner": (x, y, z)
        for i, x, y, z in ((1, 0.15, 0.38, 0.18), (2, -0.2, 0.37, 0.17), (3, 0.13, 0.42, 0.45))
    },
    **{
        f"link_{i}_outer": (x, y, z)
        for i, x, y, z in ((1, 0.02, 0.7, 0.17), (2, -0.03, 0.69, 0.16), (3, 0.01, 0.66, 0.46))
    },
    "link_4_inner": (-0.16, 0.43, 0.44),
    "link_4_outer": (-0.02, 0.65, 0.47),
    "link_5_inner": (-0.2, 0.4, 0.26),
    "link_5_outer": (-0.14, 0.7, 0.25),
    "wheel_centre": (0.0, 0.75, 0.31),
    "pushrod_outer": (0.0, 0.62, 0.2),
    "pushrod_inner": (0.0, 0.36, 0.56),
    "rocker_pivot": (0.0, 0.33, 0.5),
    "rocker_axis": (0.1, 0.33, 0.5),
    "strut_bottom": (0.0, 0.27, 0.55),
    "strut_top": (0.0, 0.05, 0.6),
}
TRAILING_ARM = {
    "arm_inner": (0.45, 0.3, 0.32),
    "arm_outer": (0.4, 0.6, 0.33),
    "wheel_centre": (0.0, 0.72, 0.31),
    "strut_bottom": (-0.02, 0.55, 0.25),
    "strut_top": (0.0, 0.53, 0.65),
    "spring_bottom": (0.12, 0.52, 0.26),
    "spring_top": (0.12, 0.5, 0.5),
}
MODELS: dict[str, tuple[dict[str, Any], tuple[str, ...], dict[str, Any]]] = {
    "mcpherson": (MCPHERSON, ("lower_arm", "upright"), {}),
    "five-link": (FIVE_LINK, ("upright", "rocker"), {"on": "rocker"}),
    "trailing-arm": (TRAILING_ARM, ("arm",), {}),
}


def rig_of(model: str, side: str = "left") -> Any:
    """A rig of any model; a right one is the left one in the mirror."""
    if model == "double-wishbone":
        left = jn.load("reference-double-wishbone")
        points, bodies, strut = left.hardpoints.given(), ("lower_arm", "upper_arm", "upright"), {}
    else:
        points, bodies, strut = MODELS[model]
    sign = 1.0 if side == "left" else -1.0
    body = {"mass": 5.0, "centre_of_mass": (0.0, 0.6 * sign, 0.3), "inertia": INERTIA}
    return RIGS[model].from_table(
        {
            "schema": "jounce.rig/1",
            "model": model,
            "side": side,
            "wheel": {"radius": 0.31, "camber": -0.01, "toe": 0.002},
            "sprung": {"mass": 300.0},
            "tyre": {"stiffness": 200e3},
            "strut": {**STRUT, **strut},
            "hardpoints": {name: (x, sign * y, z) for name, (x, y, z) in points.items()},
            "bodies": dict.fromkeys(bodies, body),
        }
    )


def lifted(
    rig: Any, heights: np.ndarray, dimension: str = "wheel_travel", units: str = "m"
) -> xr.Dataset:
    """Poses in which everything that is not on the body rises by ``heights``."""
    scene = scene_of(rig)
    rise = np.zeros((len(heights), 3))
    rise[:, 2] = heights
    data = xr.Dataset(coords={dimension: (dimension, heights, {"units": units})})
    for name, place in scene.design.points.items():
        track = np.array(place) + (0.0 if name in scene.on_body else 1.0) * rise
        for i, letter in enumerate("xyz"):
            data[f"{name}.{letter}"] = (dimension, track[:, i], {"units": "m"})
    data["camber"] = (dimension, np.full(len(heights), -0.02), {"units": "rad"})
    data["steer"] = (dimension, np.zeros(len(heights)), {"units": "rad"})
    return data


ALL = ("double-wishbone", *MODELS)


@pytest.mark.parametrize("side", ["left", "right"])
@pytest.mark.parametrize("model", ALL)
def test_every_hardpoint_is_named_once_in_every_view(model: str, side: str) -> None:
    rig = rig_of(model, side)
    figure = mechanism(rig)
    assert [axes.get_label() for axes in figure.axes] == ["front", "side", "top", "space"]
    wanted = sorted([*rig.hardpoints.given(), "contact point"])
    for axes in figure.axes[:3]:
        assert sorted(text.get_text() for text in axes.texts) == wanted
    assert (
        sorted(
            text.get_text()
            for text in figure.axes[3].texts
            if text.get_text() not in ("", "x", "y", "z")
        )
        == wanted
    )


@pytest.mark.parametrize("model", ALL)
def test_no_name_covers_another_or_leaves_the_sheet(model: str) -> None:
    figure = mechanism(rig_of(model))
    figure.draw_without_rendering()
    for axes in figure.axes:
        boxes = [text.get_window_extent() for text in axes.texts if text.get_text()]
        for one, other in combinations(boxes, 2):
            assert not one.overlaps(other)
        frame = axes.get_window_extent()
        assert all(frame.x0 <= box.x0 and box.x1 <= frame.x1 for box in boxes)
        assert all(frame.y0 <= box.y0 and box.y1 <= frame.y1 for box in boxes)
    legend = figure.legends[0].get_window_extent()
    assert legend.x0 >= 0.0
    assert legend.x1 <= figure.bbox.x1
    assert legend.y1 < figure.axes[2].xaxis.label.get_window_extent().y0


@pytest.mark.parametrize("model", ALL)
def test_no_name_covers_a_hardpoint(model: str) -> None:
    figure = mechanism(rig_of(model))
    figure.draw_without_rendering()
    for axes in figure.axes:
        boxes = [text.get_window_extent() for text in axes.texts if len(text.get_text()) > 1]
        marks = [line for line in axes.lines if line.get_marker() in ("s", "o", "+", "^")]
        for line in marks:
            for x, y in axes.transData.transform(line.get_xydata()):
                assert not any(box.contains(x, y) for box in boxes)


def test_scale_is_the_same_in_all_directions_and_in_the_three_views() -> None:
    figure = mechanism(rig_of("double-wishbone"))
    size = figure.get_size_inches()
    scales = []
    for axes in figure.axes:
        box = axes.get_position()
        width, height = np.ptp(axes.get_xlim()), np.ptp(axes.get_ylim())
        assert width / (box.width * size[0]) == pytest.approx(
            height / (box.height * size[1]), rel=1e-9
        )
        scales.append(width / box.width)
    assert scales[0] == pytest.approx(scales[1], rel=1e-9)
    assert scales[0] == pytest.approx(scales[2], rel=1e-9)
    front, side, top, _ = figure.axes
    assert front.get_ylim() == pytest.approx(side.get_ylim())
    assert front.get_xlim() == pytest.approx(top.get_xlim())


def mark(axes: Any, marker: str) -> np.ndarray:
    return np.vstack([line.get_xydata() for line in axes.lines if line.get_marker() == marker])


def test_views_show_mm_where_the_points_are() -> None:
    rig = rig_of("double-wishbone")
    front, side, top, _ = mechanism(rig).axes
    x, y, z = (1e3 * value for value in rig.hardpoints.wheel_centre)
    assert mark(front, "+")[0] == pytest.approx([y, z])
    assert mark(side, "+")[0] == pytest.approx([-x, z])  # seen from the left, ahead is on the left
    assert mark(top, "+")[0] == pytest.approx([y, -x])
    x, y, z = (1e3 * value for value in rig.hardpoints.tie_rod_inner)
    assert np.abs(mark(front, "s") - [y, z]).max(axis=1).min() < 1e-9
    assert np.abs(mark(side, "s") - [-x, z]).max(axis=1).min() < 1e-9
    assert side.xaxis.get_major_formatter()(-100.0, 0) == "100"
    assert side.xaxis.get_major_formatter()(100.0, 0) == "−100"
    assert front.get_xlabel() == "y [mm]"


def test_left_and_right_are_mirror_images_from_the_front() -> None:
    left, right = (mechanism(rig_of("double-wishbone", side)).axes for side in ("left", "right"))
    for marker in "so+^":
        mirrored = mark(right[0], marker) * [-1.0, 1.0]
        assert mirrored == pytest.approx(mark(left[0], marker))
        assert mark(right[1], marker) * [-1.0, 1.0] == pytest.approx(
            mark(left[1], marker)
        )  # each from outside


def test_parts_join_the_hardpoints_that_the_model_joins() -> None:
    scene = scene_of(rig_of("double-wishbone"))
    parts = {part.name: part.points for part in scene.parts}
    assert parts["lower_arm"] == ("lower_arm_front", "lower_ball_joint", "lower_arm_rear")
    assert parts["tie_rod"] == ("tie_rod_inner", "tie_rod_outer")
    assert scene.on_body == {
        *(
            "lower_arm_front",
            "lower_arm_rear",
            "upper_arm_front",
            "upper_arm_rear",
            "tie_rod_inner",
            "strut_top",
        ),
    }
    held = {bracket.point: (bracket.first, bracket.second) for bracket in scene.brackets}
    assert set(held) == {"strut_bottom"}  # stands on the arm, beside its lines
    five = scene_of(rig_of("five-link"))
    assert {bracket.point for bracket in five.brackets} == {
        "wheel_centre",
        "pushrod_outer",
        "rocker_axis",
    }
    assert five.steering_axis is None


def test_wheel_stands_on_the_ground_with_its_camber() -> None:
    rig = rig_of("double-wishbone").with_changes({"wheel.camber": "-3 deg", "wheel.toe": "1 deg"})
    pose = scene_of(rig).design
    assert np.linalg.norm(pose.spin_axis) == pytest.approx(1.0)
    assert -np.degrees(np.arcsin(pose.spin_axis[2])) == pytest.approx(-3.0)
    assert pose.spin_axis[0] > 0.0  # toe-in: the axis of a left wheel points forward
    assert np.linalg.norm(pose.contact - pose.points["wheel_centre"]) == pytest.approx(0.31)
    assert (pose.contact - pose.points["wheel_centre"]) @ pose.spin_axis == pytest.approx(
        0.0, abs=1e-12
    )


def test_overlay_draws_poses_ways_and_says_so() -> None:
    rig = rig_of("double-wishbone")
    data = lifted(rig, np.linspace(-0.04, 0.04, 9))
    figure = mechanism(rig, data, at=["-40 mm", 0.02])
    words = [text.get_text() for text in figure.legends[0].get_texts()]
    assert words[:3] == ["design position", "wheel travel −40 mm", "wheel travel +20 mm"]
    lines = [line.get_xydata() for line in figure.axes[0].lines]
    _, y, z = (1e3 * value for value in rig.hardpoints.upper_ball_joint)
    for rise in (-40.0, 20.0):
        assert any(np.abs(line - [y, z + rise]).max(axis=1).min() < 1e-9 for line in lines)
    assert not any(np.abs(line - [y, z + 30.0]).max(axis=1).min() < 1e-9 for line in lines)
    ends = mechanism(rig, data).legends[0].get_texts()
    assert [text.get_text() for text in ends][1:3] == ["wheel travel −40 mm", "wheel travel +40 mm"]


def test_a_pose_out_of_reach_is_refused() -> None:
    rig = rig_of("double-wishbone")
    data = lifted(rig, np.linspace(-0.04, 0.04, 9))
    with pytest.raises(DescriptionError, match=r"50\.00 mm.*−40\.00 mm to 40\.00 mm"):
        mechanism(rig, data, at=["50 mm"])


def test_poses_that_say_too_little_are_refused() -> None:
    rig = rig_of("double-wishbone")
    data = lifted(rig, np.linspace(-0.04, 0.04, 9))
    with pytest.raises(RecordingError, match="points=True"):
        mechanism(rig, data[["camber", "steer"]])
    with pytest.raises(RecordingError, match="tie_rod_outer"):
        mechanism(rig, data.drop_vars([f"tie_rod_outer.{i}" for i in "xyz"]))
    with pytest.raises(RecordingError, match="camber"):
        mechanism(rig, data.drop_vars("camber"))
    with pytest.raises(RecordingError, match="one dimension"):
        mechanism(rig, data.expand_dims(rack_travel=[0.0, 0.01]))
    with pytest.raises(RecordingError, match="to a different rig"):
        mechanism(rig_of("mcpherson"), data.drop_vars([f"strut_bottom.{i}" for i in "xyz"]))


def test_points_on_a_still_body_may_be_left_out_and_gaps_are() -> None:
    rig = rig_of("double-wishbone")
    data = lifted(rig, np.linspace(-0.04, 0.04, 9)).drop_vars([f"strut_top.{i}" for i in "xyz"])
    data["wheel_centre.z"][-1] = np.nan
    poses = poses_of(rig, scene_of(rig), data)
    assert len(poses) == 8
    assert poses.points["strut_top"][3] == pytest.approx(rig.hardpoints.strut_top)
    assert poses.label(0) == "wheel travel −40 mm"


def test_real_sweep_and_run_are_drawn() -> None:
    rig = jn.load("kart-double-wishbone")
    sweep = jn.sweep_travel(rig, np.linspace(-0.02, 0.02, 5), points=True)
    poses = poses_of(rig, scene_of(rig), sweep)
    assert poses.contact[:, 1] == pytest.approx(sweep["contact_point_y"].to_numpy(), abs=1e-12)
    assert poses.points["wheel_centre"][:, 2] - rig.hardpoints.wheel_centre[2] == pytest.approx(
        poses.over, abs=1e-9
    )
    axis = spin_axes(sweep["camber"].to_numpy(), sweep["steer"].to_numpy(), 1.0)
    # the helper's own lowest point of the wheel is where the kinematics say that it touches
    down = axis * axis[:, 2:] - [0.0, 0.0, 1.0]
    lowest = poses.points["wheel_centre"] + rig.wheel.radius * down / np.linalg.norm(
        down, axis=1, keepdims=True
    )
    assert lowest == pytest.approx(poses.contact, abs=1e-9)
    assert mechanism(rig, sweep).legends


def test_show_draws_a_rig_and_a_lumped_one_is_refused() -> None:
    assert figure_of(rig_of("trailing-arm"), names=False).axes[0].texts[:] == []
    with pytest.raises(JounceError, match="there is no figure for this type"):
        figure_of(jn.load("kart-quarter-car"))
    with pytest.raises(DescriptionError, match="only a 3-D rig of one corner can be drawn"):
        mechanism(jn.load("kart-quarter-car"))  # type: ignore[arg-type]


def test_same_rig_same_bytes() -> None:
    first, second = (render_figure(mechanism(rig_of("five-link"), title="five")) for _ in range(2))
    assert first == second
    assert b"link_3_outer" in first[".svg"]


def test_names_are_spread_without_leaving_their_column() -> None:
    wanted = np.array([0.0, 0.0, 0.0, 9.0, 10.0])
    found = spread(wanted, 0.0, 10.0, 1.0)
    assert np.diff(found).min() >= 1.0 - 1e-12
    assert found[0] >= 0.0
    assert found[-1] <= 10.0
    assert found[3:] == pytest.approx([9.0, 10.0])
    crowded = spread(wanted, 0.0, 2.0, 1.0)
    assert crowded == pytest.approx([0.0, 0.5, 1.0, 1.5, 2.0])


def test_shapes() -> None:
    centre, axis = np.array([0.0, 1.0, 0.3]), np.array([0.0, 1.0, 0.0])
    free = tyre(centre, axis, 0.31, 0.2)
    assert free[..., 2].min() == pytest.approx(-0.01, abs=1e-12)
    assert np.ptp(free[..., 1]) == pytest.approx(0.2)
    pressed = tyre(centre, axis, 0.31, 0.2, 0.0)
    assert pressed[..., 2].min() == 0.0
    assert pressed[..., 2].max() == pytest.approx(0.61)
    turns = coil(np.zeros(3), np.array([0.0, 0.0, 0.4]), 0.05)
    assert turns[0] == pytest.approx([0.0, 0.0, 0.0])
    assert turns[-1] == pytest.approx([0.0, 0.0, 0.4])
    assert np.hypot(turns[:, 0], turns[:, 1]).max() == pytest.approx(0.05)
    assert np.all(np.diff(turns[:, 2]) > 0.0)
    assert outline(free[..., 1:]).shape[1] == 2


def test_a_centre_that_lies_nowhere_has_no_height() -> None:
    rows = {"side_instant_centre_x": 3e6, "side_instant_centre_z": -0.48, "instant_centre_y": -1.5}
    centres = _Centres(
        scene_of(jn.load("formula-student-front")),
        {**rows, "instant_centre_z": 0.1, "camber": 0.02},
        {},
    )
    assert (
        kinematic_value(
            "side_instant_centre_z", centres.value_to_show("side_instant_centre_z"), "m"
        )
        == "parallel"
    )
    assert [
        centres.value_to_show(name) for name in ("instant_centre_z", "instant_centre_y", "camber")
    ] == [
        0.1,
        -1.5,
        0.02,
    ]
