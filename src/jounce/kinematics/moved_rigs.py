"""A corner in a different pose as a new description: points and bodies moved, spring and stops unchanged."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, TypeVar

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.types import Array
from jounce.kinematics import sweep_travel
from jounce.kinematics.loads import bump_axis
from jounce.parts import Corner
from jounce.parts.advice import BODY_POINTS
from jounce.parts.bodies import INERTIA_ELEMENTS, Triple, distance
from jounce.parts.leverage import AXES

C = TypeVar("C", bound=Corner)
_STRAIGHT = 1e-6
"""Size of the second extent of a group of points, relative to the first, below which they lie on one line."""


def rigs_along(rig: Corner, travels: Sequence[float]) -> list[Corner]:
    """Return the rig at each wheel travel (m, ascending, body fixed), with that pose as its new design."""
    sweep = sweep_travel(rig, list(travels), points=True)
    if sweep.sizes["wheel_travel"] < len(travels):
        raise DescriptionError("out of reach", where="wheel travel", found=sweep.attrs["stopped"])
    names = rig.hardpoints.given()

    def place(name: str, i: int) -> tuple[float, float, float]:
        x, y, z = (float(sweep[f"{name}.{axis}"][i]) for axis in "xyz")
        return x, y, z

    return [
        rig_with_hardpoints(rig, {name: place(name, i) for name in names})
        for i in range(len(travels))
    ]


Motion = tuple[Array, Array]
"""Rotation (3, 3) and shift (3,) of a body, m."""


def rig_with_hardpoints(rig: C, places: Mapping[str, Triple], upright: Motion | None = None) -> C:
    """Return the rig with some hardpoints moved to ``places`` (m), as it would be described there.

    Bodies follow their hardpoints as rigid ones, but for an ``upright`` whose motion is given because its points move
    on it; the wheel's camber and toe follow the body that carries it. The springs keep their free length, as do dampers
    with a stiffness, and the stops their places: preload, offset and gaps count from the new design length; a damper's
    ``displacement_coupling``, which has no offset of its own, sees the stroke from there. A torsion bar has wound up by
    as much as its arm has turned. A Z-bar carries no torque in the new design, as in the old one.
    """
    table: dict[str, Any] = rig.model_dump(by_alias=True, exclude_none=True)
    before = rig.hardpoints.given()
    after = {name: places.get(name, point) for name, point in before.items()}
    table["hardpoints"] = {name: tuple(map(float, point)) for name, point in after.items()}
    known = {} if upright is None else {"upright": upright, "wheel": upright}
    for name, body in () if "bodies" in rig.without else rig.body_masses().items():
        turn, shift = known.get(name) or _body_motion(rig, name, before, after)
        inertia = turn @ body.inertia.tensor @ turn.T
        table["bodies"][name] |= {
            "centre_of_mass": tuple(map(float, turn @ np.array(body.centre_of_mass) + shift)),
            "inertia": {element: float(inertia[at]) for element, at in INERTIA_ELEMENTS.items()},
        }
    turn, _ = known.get("upright") or _body_motion(rig, "upright", before, after)
    camber, toe = wheel_angles(rig, turn @ spin_axis(rig))
    table["wheel"] |= {"camber": camber, "toe": toe}
    if rig.has_strut:
        _keep_spring(table["strut"], _length(before, "spring"), _length(after, "spring"))
        _keep_damper(
            table["strut"].get("damper", {}), _length(before, "damper"), _length(after, "damper")
        )
    if rig.third_spring is not None:
        lengths = [2.0 * abs(points["third_spring_end"][1]) for points in (before, after)]
        _keep_spring(table["third_spring"], *lengths)
        _keep_damper(table["third_spring"].get("damper", {}), *lengths)
    if rig.torsion_bar is not None:
        table["torsion_bar"]["preload"] += rig.torsion_bar.stiffness * _turn_about_axis(
            rig, rig.torsion_bar.on, before, after
        )
    return type(rig).from_table(table)


def spin_axis(rig: Corner) -> Array:
    """Axis of the wheel at design, pointing outboard, shape (3,)."""
    camber, toe = rig.wheel.camber, rig.wheel.toe
    return np.array(
        [np.sin(toe) * np.cos(camber), rig.sign * np.cos(toe) * np.cos(camber), -np.sin(camber)],
        dtype=float,
    )


def wheel_angles(rig: Corner, axis: Array) -> tuple[float, float]:
    """Return camber (top outward) and toe (toe-in) in rad of a wheel with a given axis."""
    return float(-np.arcsin(axis[2])), float(np.arctan2(axis[0], rig.sign * axis[1]))


def rigid_motion(before: Array, after: Array) -> tuple[Array, Array]:
    """Fit rotation (3, 3) and shift (3,) between point sets (n, 3); for collinear points, the smallest rotation."""
    centre, target = before.mean(axis=0), after.mean(axis=0)
    first, second = before - centre, after - target
    sizes = np.linalg.svd(first, compute_uv=False)
    if sizes[0] == 0.0:
        turn = np.eye(3)
    elif sizes[1] < _STRAIGHT * sizes[0]:
        far = int(np.argmax(np.linalg.norm(first, axis=1)))
        turn = _least_turn(first[far], second[far])
    else:
        left, _, right = np.linalg.svd(second.T @ first)
        turn = left @ np.diag([1.0, 1.0, np.sign(np.linalg.det(left @ right))]) @ right
    return turn, target - turn @ centre


def _least_turn(start: Array, end: Array) -> Array:
    """Shortest rotation from one direction to another."""
    a, b = start / np.linalg.norm(start), end / np.linalg.norm(end)
    axis, cosine = np.cross(a, b), float(a @ b)
    skew = np.array([[0.0, -axis[2], axis[1]], [axis[2], 0.0, -axis[0]], [-axis[1], axis[0], 0.0]])
    return np.asarray(np.eye(3) + skew + skew @ skew / (1.0 + cosine))


def _body_motion(
    rig: Corner, body: str, before: Mapping[str, Triple], after: Mapping[str, Triple]
) -> tuple[Array, Array]:
    names = [name for name in BODY_POINTS.get(body, rig.hardpoints.outer) if name in before]
    if body in (
        "upright",
        "wheel",
        "strut",
    ):  # the sliding part of a McPherson turns with the upright
        names = [
            name for name in (*rig.hardpoints.outer, "arm_inner", "arm_outer") if name in before
        ]
    turn, shift = rigid_motion(
        np.array([before[n] for n in names]), np.array([after[n] for n in names])
    )
    if body == "strut":  # and hangs on the car's body
        shift = np.array(after["strut_top"]) - turn @ np.array(before["strut_top"])
    return turn, shift


def _turn_about_axis(
    rig: Corner, body: str, before: Mapping[str, Triple], after: Mapping[str, Triple]
) -> float:
    """Return the rotation (rad) of an arm or the rocker about its axis, positive in bump."""
    levers = []
    for points in (before, after):
        start, end, tip = (np.array(points[name]) for name in AXES[body])
        axis = (end - start) / np.linalg.norm(end - start)
        levers.append(tip - start - ((tip - start) @ axis) * axis)
    return float(np.arctan2(np.cross(*levers) @ bump_axis(rig, body), levers[0] @ levers[1]))


def _length(points: Mapping[str, Triple], element: str) -> float:
    bottom, top = (
        points.get(f"{element}_{end}", points[f"strut_{end}"]) for end in ("bottom", "top")
    )
    return distance(bottom, top)


def _keep_spring(strut: dict[str, Any], before: float, after: float) -> None:
    """Keep spring and stops unchanged while the design length (m) changes."""
    spring = strut.get("spring")
    if spring is not None and "free_length" not in spring:
        preload = spring.pop("preload", 0.0)
        if "rate" in spring:
            spring["preload"] = preload - spring["rate"] * (after - before)
        elif preload == 0.0:
            spring["free_length"] = before
        elif after != before:
            raise DescriptionError(
                "a nonlinear spring with a preload cannot be moved to a different length",
                where="strut.spring",
                hint="Give free_length instead of preload.",
            )
        else:
            spring["preload"] = preload
    for name, sign in (("bump_stop", 1.0), ("rebound_stop", -1.0)):
        if name in strut:
            strut[name]["gap"] += sign * (after - before)


def _keep_damper(damper: dict[str, Any], before: float, after: float) -> None:
    """Keep a damper's law over its stroke unchanged while the design length (m) changes."""
    if "stiffness" in damper:
        damper["offset"] += damper["stiffness"] * (before - after)
