"""Hardpoints pasted from a spreadsheet: separators, names, units, axes, and rows that are wrong."""

from __future__ import annotations

import numpy as np
import pytest

from jounce.core.errors import DescriptionError
from jounce.parts import load
from jounce.parts.importers.pasted import read_pasted_points

RIG = load("kart-double-wishbone")
POINTS = RIG.hardpoints.given()
THEIRS = {
    "lower_arm_front": "LCA front", "lower_arm_rear": "LCA rear", "lower_ball_joint": "LBJ",
    "upper_arm_front": "UCA front", "upper_arm_rear": "UCA rear", "upper_ball_joint": "UBJ",
    "tie_rod_inner": "Tie rod inner", "tie_rod_outer": "tie rod outer", "wheel_centre": "wheel center",
}  # fmt: skip
"""Names of these points in a table by hand."""


def table(
    mark: str = "\t",
    head: str = "point|x [mm]|y [mm]|z [mm]",
    factor: float = 1e3,
    turn: np.ndarray | None = None,
) -> str:
    rows = [head.replace("|", mark)] if head else []
    for ours, theirs in THEIRS.items():
        place = (np.eye(3) if turn is None else turn) @ np.array(POINTS[ours]) * factor
        numbers = [f"{value:.6f}".replace(".", "," if mark != "," else ".") for value in place]
        rows.append(mark.join([theirs, *numbers]))
    return "\n".join(rows) + "\n"


@pytest.mark.parametrize("mark", ["\t", ";", ","])
def test_the_same_points_change_nothing(mark: str) -> None:
    found = read_pasted_points(RIG, table(mark))
    assert {point.name for point in found.points} == set(THEIRS)
    assert found.changes == {}
    assert (found.unit, found.axes, found.is_unit_stated) == ("mm", "x,y,z", True)
    assert dict(found.unknown) == {}
    assert set(found.absent) == set(POINTS) - set(THEIRS)


@pytest.mark.parametrize(
    ("unit", "factor"), [("mm", 1e3), ("m", 1.0), ("cm", 1e2), ("inch", 1 / 0.0254)]
)
@pytest.mark.parametrize("head", ["point|x|y|z", ""])
def test_the_unit_is_found_by_the_points(unit: str, factor: float, head: str) -> None:
    found = read_pasted_points(RIG, table(head=head, factor=factor))
    assert (found.unit, found.is_unit_stated) == (unit, False)
    assert all(point.distance < 1e-6 for point in found.points)


@pytest.mark.parametrize(
    ("axes", "turn"),
    [
        ("-x,-y,z", np.diag([-1.0, -1.0, 1.0])),
        ("x,-y,z", np.diag([1.0, -1.0, 1.0])),
        ("y,-x,z", np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])),
    ],
)
def test_other_axes_are_proposed_and_can_be_said(axes: str, turn: np.ndarray) -> None:
    found = read_pasted_points(RIG, table(turn=turn))
    assert found.axes == axes
    assert all(point.distance < 1e-6 for point in found.points)
    said = read_pasted_points(RIG, table(turn=turn), axes=axes)
    assert said.points == found.points


def test_a_right_corner_is_mirrored_where_its_axes_are_said() -> None:
    found = read_pasted_points(RIG, table(turn=np.diag([1.0, -1.0, 1.0])), axes="x,y,z")
    assert found.is_mirrored
    assert all(point.distance < 1e-6 for point in found.points)


def test_only_what_moved_is_changed() -> None:
    height = 1e3 * POINTS["tie_rod_inner"][2]
    before, row, after = table().partition("Tie rod inner")
    old, new = (f"{value:.6f}".replace(".", ",") for value in (height, height + 5.0))
    text = before + row + after.replace(old, new, 1)
    found = read_pasted_points(RIG, text)
    assert found.changes == {
        "hardpoints.tie_rod_inner[2]": pytest.approx(POINTS["tie_rod_inner"][2] + 5e-3)
    }
    moved = RIG.with_changes(found.changes)
    assert moved.hardpoints.given()["tie_rod_inner"][2] == pytest.approx((height + 5) / 1e3)


def test_a_row_too_many_is_named_and_can_be_assigned() -> None:
    text = table().replace("LBJ", "kingpin low")
    found = read_pasted_points(RIG, text)
    assert dict(found.unknown) == {"kingpin low": "table, line 4"}
    assert "lower_ball_joint" in found.absent
    named = read_pasted_points(RIG, text, names={"kingpin low": "lower_ball_joint"})
    assert dict(named.unknown) == {}
    assert "lower_ball_joint" in {point.name for point in named.points}


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("LBJ\tx\t1\t2\n", "line 1.*|no points"),
        (table().replace("LBJ\t", "LBJ\tabout ", 1), "line 4"),
        (table() + "LBJ\t1\t2\t3\n", "lower_ball_joint is given twice"),
        ("a\t1\t2\t3\n", "no hardpoint of this rig"),
        ("hello", "the file contains no points"),
        ("point\tx [mm]\ty [mm]\tz [m]\nLBJ\t1\t2\t3\n", "columns in different units"),
    ],
)
def test_a_wrong_table_is_refused_with_its_row(text: str, said: str) -> None:
    with pytest.raises(DescriptionError, match=said):
        read_pasted_points(RIG, text)
