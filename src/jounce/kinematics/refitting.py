"""Linkages reassembled with changed rod lengths, supports and shims; all other parts follow.

The wheel centre keeps its height. The upright moves as a rigid body, arms, links and the rocker rotate about their
supports, and the links of push rod and anti-roll bar keep their lengths.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import TypeVar, cast

import casadi as ca
import numpy as np

from jounce.core.errors import AssemblyError
from jounce.core.types import Array
from jounce.kinematics.moved_rigs import rig_with_hardpoints, rigid_motion
from jounce.mechanics import Mechanism, Model, assemble
from jounce.parts import Corner
from jounce.parts.advice import BODY_POINTS
from jounce.parts.bodies import Triple, distance
from jounce.parts.corners import Hardpoints, McPhersonHardpoints

C = TypeVar("C", bound=Corner)


@dataclass(frozen=True)
class Changes:
    """Changes: positions of points on the car's body (m), lengths of rods (m) by their inner points, shims (m).

    ``shims`` has displacements of points relative to the upright; ``pushrod`` is the lengthening of the push rod (m).
    """

    inner: Mapping[str, Triple] = field(default_factory=dict)
    lengths: Mapping[str, float] = field(default_factory=dict)
    shims: Mapping[str, Array] = field(default_factory=dict)
    pushrod: float = 0.0


def refit(rig: C, changes: Changes) -> C:
    """Return the rig reassembled with some changes; an ``AssemblyError`` if they do not fit together."""
    given = rig.hardpoints.given()
    shimmed = dict(given) | {
        name: triple(np.array(given[name]) + shift) for name, shift in changes.shims.items()
    }
    places: dict[str, Triple] = {**shimmed, **changes.inner}
    if rods(rig):
        places |= _upright_places(rig, places, changes.lengths)
        outer = _outer(rig)
        turn, shift = rigid_motion(
            *(np.array([points[name] for name in outer]) for points in (shimmed, places))
        )
        carried = points_on(rig, "upright")
    else:
        turn, shift = _arm_motion(given, places)
        carried = ["arm_inner", "arm_outer", "wheel_centre", *points_on(rig, "arm")]
    places |= {name: triple(turn @ np.array(given[name]) + shift) for name in carried}
    for body, names in BODY_POINTS.items():
        if body.endswith("_arm") or body.startswith("link_"):
            places |= _carry_points(rig, body, names, given, places)
    if has_rocker(rig):
        places |= _rocker_places(rig, given, places, changes.pushrod)
    if rig.anti_roll_bar is not None:
        places |= _bar_places(rig, given, places)
    return rig_with_hardpoints(rig, places, (turn, shift) if changes.shims else None)


def has_rocker(rig: Corner) -> bool:
    """Return whether a push rod and a rocker actuate the strut."""
    return getattr(rig.hardpoints, "rocker_pivot", None) is not None


def rods(rig: Corner) -> dict[str, str]:
    """Rods that hold the upright: inner point to outer point."""
    return {inner: outer for outer, inner in rig.hardpoints.rods}


def rod_lengths(rig: Corner) -> dict[str, float]:
    """Lengths of the rods that hold the upright, m, by their inner points."""
    given = rig.hardpoints.given()
    return {inner: distance(given[inner], given[outer]) for inner, outer in rods(rig).items()}


def points_on(rig: Corner, body: str) -> list[str]:
    """Points besides its joints that move with a body."""
    names = []
    if rig.strut.on == body:
        names += ["strut_bottom", "spring_bottom", "damper_bottom"]
    for name, element in (
        ("arb_link_end", rig.anti_roll_bar),
        ("third_spring_end", rig.third_spring),
    ):
        if element is not None and element.on == body:
            names.append(name)
    if has_rocker(rig) and getattr(rig.strut, "pushrod_on", "upright") == body:
        names.append("pushrod_outer")
    return [
        name
        for name in names
        if getattr(rig.hardpoints, name) is not None and name not in rig.hardpoints.outer
    ]


def triple(place: Array) -> Triple:
    """Return a position (m, shape (3,)) in the form used by descriptions."""
    x, y, z = (float(value) for value in place)
    return x, y, z


# the upright on its rods ----------------------------------------------------------------------------------------------


def _outer(rig: Corner) -> tuple[str, ...]:
    """Joints of the upright and the wheel centre, which is the last."""
    return (*(name for name in rig.hardpoints.outer if name != "wheel_centre"), "wheel_centre")


@cache
def _upright_on_rods(kind: type[Hardpoints]) -> tuple[Model, ca.Function, dict[str, float]]:
    """Return the model of a free upright on its rods with fixed wheel-centre height, its points, and its values.

    The line of a McPherson strut is fixed to it and passes the strut's top.
    """
    mechanism = Mechanism()
    origin = (0.0, 0.0, 0.0)
    upright = mechanism.body("upright", 1.0, origin, (1.0, 1.0, 1.0))
    mechanism.free("upright", upright)
    names = (*(name for name in kind.outer if name != "wheel_centre"), "wheel_centre")
    points = {name: mechanism.vector(name, origin) for name in names}
    for outer, inner in kind.rods:
        mechanism.rod(inner, mechanism.ground, upright, origin, points[outer], length=1.0)
    if issubclass(kind, McPhersonHardpoints):
        top = mechanism.vector("strut_top", origin)
        away = top - upright.frame.point(points["strut_bottom"]).value
        for k in range(2):
            across = upright.frame.direction(mechanism.vector(f"across_{k}", origin)).value
            mechanism.condition(f"strut_line_{k}", ca.dot(across, away))
    places = [upright.frame.point(points[name]).value for name in names]
    mechanism.condition("wheel_centre_height", places[-1][2] - mechanism.number("height", 0.0))
    model = mechanism.finish()
    return model, ca.Function("places", [model.x, model.p], [ca.horzcat(*places)]), mechanism.values


def _upright_places(
    rig: Corner, places: Mapping[str, Triple], lengths: Mapping[str, float]
) -> dict[str, Triple]:
    """Return positions of the upright's points with all rods assembled and the wheel centre at its height."""
    model, function, known = _upright_on_rods(type(rig.hardpoints))
    values = {**known, "height": places["wheel_centre"][2]}
    for name, length in {**rod_lengths(rig), **lengths}.items():
        values[f"{name}.length"] = length
        values |= {f"{name}.at[{i}]": places[name][i] for i in range(3)}
    vectors: dict[str, Triple] = {name: places[name] for name in _outer(rig)}
    if isinstance(rig.hardpoints, McPhersonHardpoints):
        vectors["strut_top"] = places["strut_top"]
        line = np.subtract(rig.hardpoints.strut_top, rig.hardpoints.strut_bottom)
        vectors |= {
            f"across_{k}": triple(row) for k, row in enumerate(np.linalg.svd(line[None, :])[2][1:])
        }
    values |= {
        f"{name}[{i}]": value for name, vector in vectors.items() for i, value in enumerate(vector)
    }
    p = np.array([values[path] for path in model.parameters])
    try:
        pose = assemble(model, p, np.zeros(model.u.shape[0]))
    except AssemblyError as error:
        raise AssemblyError(
            "the linkage cannot be assembled with these settings",
            where=error.where,
            found=error.found,
            hint="Make smaller changes.",
        ) from None
    positions = function(pose.x, p).full()
    return {name: triple(positions[:, i]) for i, name in enumerate(_outer(rig))}


def _arm_motion(before: Mapping[str, Triple], after: Mapping[str, Triple]) -> tuple[Array, Array]:
    """Return rotation and shift of a trailing arm with a moved axis; the wheel centre keeps its height."""
    pivots = [np.array([points["arm_inner"], points["arm_outer"]]) for points in (before, after)]
    turn, shift = rigid_motion(*pivots)
    middle, axis = pivots[1].mean(axis=0), pivots[1][1] - pivots[1][0]
    axis = axis / np.linalg.norm(axis)
    away = turn @ np.array(before["wheel_centre"]) + shift - middle
    along = (away @ axis) * axis
    height = before["wheel_centre"][2] - middle[2] - along[2]
    angle = _least_angle(float((away - along)[2]), float(np.cross(axis, away)[2]), float(height))
    if angle is None:
        raise AssemblyError(
            "the arm does not reach the height of its wheel centre", where="hardpoints.arm_inner"
        )
    about = np.array([_turn(direction, axis, angle) for direction in np.eye(3)]).T
    return about @ turn, middle + about @ (shift - middle)


# parts attached to the upright ----------------------------------------------------------------------------------------


def _carry_points(
    rig: Corner,
    body: str,
    names: tuple[str, ...],
    before: Mapping[str, Triple],
    after: Mapping[str, Triple],
) -> dict[str, Triple]:
    """Move points on an arm or link with it, keeping their distance from its outer end."""
    own = points_on(rig, body)
    if not own:
        return {}
    turn, _ = rigid_motion(
        *(np.array([points[name] for name in names]) for points in (before, after))
    )
    old, new = (np.array(points[names[-1]]) for points in (before, after))
    return {name: triple(new + turn @ (np.array(before[name]) - old)) for name in own}


def _rocker_places(
    rig: Corner, before: Mapping[str, Triple], after: Mapping[str, Triple], longer: float
) -> dict[str, Triple]:
    """Return positions of the rocker's points for which the push rod fits."""
    pivot, end, inner = (
        np.array(before[name]) for name in ("rocker_pivot", "rocker_axis", "pushrod_inner")
    )
    length = distance(before["pushrod_outer"], before["pushrod_inner"]) + longer
    turn = _turn_to(inner - pivot, end - pivot, np.array(after["pushrod_outer"]) - pivot, length)
    if turn is None:
        change = f"{1e3 * longer:.4g} mm"
        raise AssemblyError(
            "rocker and push rod cannot be assembled", where="pushrod_length", found=change
        )
    names = ("pushrod_inner", *points_on(rig, "rocker"))
    return {
        name: triple(pivot + _turn(np.array(before[name]) - pivot, end - pivot, turn))
        for name in names
    }


def _bar_places(
    rig: Corner, before: Mapping[str, Triple], after: Mapping[str, Triple]
) -> dict[str, Triple]:
    """Return positions of the anti-roll bar's arm (and a T-bar's stem) for which its link keeps its length."""
    bar = rig.anti_roll_bar
    pivot, arm_end, link_end = (
        np.array(before[f"arb_{name}"]) for name in ("pivot", "arm_end", "link_end")
    )
    stem = bar is not None and bar.kind == "t"
    axis = np.array([0.0, 1.0, 0.0])
    if "arb_axis" in before and not stem:
        axis = np.array(before["arb_axis"]) - pivot
    length = float(np.linalg.norm(link_end - arm_end))
    turn = _turn_to(arm_end - pivot, axis, np.array(after["arb_link_end"]) - pivot, length)
    if turn is None:
        raise AssemblyError(
            "the link of the anti-roll bar does not reach its arm", where="hardpoints.arb_arm_end"
        )
    names = ("arb_arm_end", *(("arb_axis",) if stem else ()))
    return {
        name: triple(pivot + _turn(np.array(before[name]) - pivot, axis, turn)) for name in names
    }


def _turn_to(arm: Array, axis: Array, end: Array, length: float) -> float | None:
    """Find the smallest rotation (rad) that brings an arm to a given distance from a point; None if impossible."""
    axis = axis / np.linalg.norm(axis)
    along = (arm @ axis) * axis
    flat = arm - along
    # |arm turned - end| = length is a cos(turn) + b sin(turn) = needed
    a, b = float(flat @ end), float(np.cross(axis, flat) @ end)
    needed = 0.5 * float(arm @ arm + end @ end - length**2) - float(along @ end)
    return _least_angle(a, b, needed)


def _least_angle(a: float, b: float, needed: float) -> float | None:
    """Find the smallest angle (rad) with a cos + b sin = needed; None if there is no solution."""
    size = float(np.hypot(a, b))
    if abs(needed) > size:
        return None
    middle, half = np.arctan2(b, a), np.arccos(needed / size)
    turns = [(middle + sign * half + np.pi) % (2.0 * np.pi) - np.pi for sign in (1.0, -1.0)]
    return cast(float, min(turns, key=abs))


def _turn(away: Array, axis: Array, turn: float) -> Array:
    """Rotate a vector about an axis (rad)."""
    axis = axis / np.linalg.norm(axis)
    along = (away @ axis) * axis
    rest = away - along
    return np.asarray(along + rest * np.cos(turn) + np.cross(axis, rest) * np.sin(turn))
