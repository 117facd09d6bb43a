"""Leverage of a corner at design position: motion of spring, damper and bodies as the wheel rises, and statics.

First order only: velocities follow from the joint equations at the design hardpoints. The kinematics package computes
other positions.
"""

from __future__ import annotations

from typing import cast

import numpy as np

from jounce.core.types import Array
from jounce.parts.bodies import Triple
from jounce.parts.corners import Corner, Hardpoints, McPhersonHardpoints, TrailingArmHardpoints
from jounce.parts.curves import Curve, PolynomialCurve, PowerCurve
from jounce.parts.elements import BumpStop, CoilSpring, Tyre
from jounce.parts.tables import on_lines

AXES = {
    "lower_arm": ("lower_arm_front", "lower_arm_rear", "lower_ball_joint"),
    "upper_arm": ("upper_arm_front", "upper_arm_rear", "upper_ball_joint"),
    "rocker": ("rocker_pivot", "rocker_axis", "pushrod_inner"),
    "arm": ("arm_inner", "arm_outer", "wheel_centre"),
}
"""Triples for bodies that rotate on the car's body: two points on the axis, and a point that moves."""
_THIRD = "third_spring_end"

Twist = tuple[Array, Array]
"""Velocity of the body-fixed point at the origin, and angular velocity, each of shape (3,)."""


def motion_ratio(rig: Corner, element: str = "spring") -> float:
    """Return shortening of ``"spring"`` or ``"damper"`` per rise of the wheel centre at design, positive in bump.

    >>> from jounce.parts import load
    >>> round(motion_ratio(load("reference-double-wishbone")), 4)
    0.6985
    """
    points = rig.hardpoints
    bottom, top = _at(points, f"{element}_bottom"), _at(points, f"{element}_top")
    along = (top - bottom) / np.linalg.norm(top - bottom)
    return float(along @ _velocity(_twist(rig, rig.strut.on), bottom))


def body_motion(rig: Corner, body: str) -> Twist:
    """Return the motion of a suspension body at design while the wheel centre rises at 1 m/s; the car's body is fixed.

    Returns the velocity (m/s) of the body-fixed point at the origin, and the angular velocity (rad/s).

    >>> from jounce.parts import load
    >>> rig = load("reference-double-wishbone")
    >>> velocity, turn = body_motion(rig, "upright")
    >>> bool(abs((velocity + np.cross(turn, rig.hardpoints.wheel_centre))[2] - 1.0) < 1e-12)
    True
    """
    twist = _twist(rig, body)
    if body != "strut":
        return twist
    top = np.array(
        rig.hardpoints.strut_top
    )  # where the sliding part of a McPherson strut is attached to the car's body
    return -np.cross(twist[1], top), twist[1]


def torsion_ratio(rig: Corner) -> float:
    """Return the rotation of the torsion bar per rise of the wheel centre at design, rad/m, positive in bump."""
    assert rig.torsion_bar is not None
    axis = np.subtract(*(_at(rig.hardpoints, name) for name in AXES[rig.torsion_bar.on][:2]))
    return float(abs(_twist(rig, rig.torsion_bar.on)[1] @ axis) / np.linalg.norm(axis))


def third_ratio(rig: Corner) -> float:
    """Return the shortening of the third spring per rise of both wheel centres at design, positive in bump."""
    assert rig.third_spring is not None
    return float(
        -2.0
        * rig.sign
        * _velocity(_twist(rig, rig.third_spring.on), _at(rig.hardpoints, _THIRD))[1]
    )


def carried_beside_spring(rig: Corner, travel: float = 0.0) -> float:
    """Return the static force (N) of torsion bar, third spring and dampers at the wheel centre.

    A Z-bar is untwisted at design. At nonzero ``travel`` (m), the levers of the design position are used.
    """
    force, bar, third = 0.0, rig.torsion_bar, rig.third_spring
    if bar is not None:
        force += (bar.preload + bar.stiffness * torsion_ratio(rig) * travel) * torsion_ratio(rig)
    if third is not None:
        length, ratio = 2.0 * abs(_at(rig.hardpoints, _THIRD)[1]), third_ratio(rig)
        gas = 0.0 if third.damper is None else third.damper.at_rest(ratio * travel)[0]
        force += 0.5 * (_coil_force(third.spring, length, ratio * travel) + gas) * ratio
    if rig.strut.damper.pushes_at_rest:
        moved = motion_ratio(rig, "damper") * travel
        law = rig.strut.damper.at_length(rig.hardpoints.length("damper") - moved)
        force += law.at_rest(moved)[0] * motion_ratio(rig, "damper")
    return force


def static_load(rig: Corner) -> float:
    """Return the force (N) at the wheel centre that carries the sprung mass and part of the arms' mass at design."""
    load = 0.0 if rig.sprung is None else rig.sprung.mass
    for name, body in rig.body_masses().items():
        rise = _velocity(_twist(rig, name), np.array(body.centre_of_mass))[2]
        load += body.mass * (1.0 - rise)
    return float(rig.gravity * load)


def static_spring_force(rig: Corner) -> float:
    """Return the spring force (N) that carries the sprung mass and part of the arms' mass at design, wheel on the road.

    Loads carried by torsion bar, third spring and damper gas are subtracted.
    """
    return float((static_load(rig) - carried_beside_spring(rig)) / motion_ratio(rig))


def static_tyre_deflection(rig: Corner) -> float:
    """Return the tyre deflection (m) under the weight of the corner; curves use their slope at zero deflection."""
    mass = (0.0 if rig.sprung is None else rig.sprung.mass) + sum(
        body.mass for body in rig.body_masses().values()
    )
    return static_deflection(rig.tyre, rig.gravity * mass)


def static_deflection(tyre: Tyre, weight: float) -> float:
    """Return the deflection (m) of a tyre under a weight (N); curves use their slope at zero deflection."""
    stiffness = tyre.stiffness if tyre.curve is None else force_at(tyre.curve, 1e-3) / 1e-3
    return weight / cast(float, stiffness)


def spring_force(rig: Corner, deflection: float = 0.0) -> float:
    """Return the force of spring and stops in N, compression positive, at a ``deflection`` from design length in m."""
    force = 0.0
    if "spring" not in rig.without:
        force = _coil_force(rig.strut.spring, rig.hardpoints.length("spring"), deflection)
    return (
        force + _stop(rig.strut.bump_stop, deflection) - _stop(rig.strut.rebound_stop, -deflection)
    )


def _coil_force(spring: CoilSpring, length: float, deflection: float = 0.0) -> float:
    """Return the force of a spring (N) at a ``deflection`` from its design ``length`` (m)."""
    own = deflection if spring.free_length is None else spring.free_length - length + deflection
    elastic = (
        spring.rate * own if spring.rate is not None else force_at(cast(Curve, spring.curve), own)
    )
    return (spring.preload or 0.0) + elastic


def force_at(curve: Curve, x: float) -> float:
    """Return the force of a curve in N at ``x`` in m; tables are extrapolated."""
    if isinstance(curve, PolynomialCurve):
        return float(sum(c * x ** (i + 1) for i, c in enumerate(curve.coefficients)))
    if isinstance(curve, PowerCurve):
        return curve.coefficient * x**curve.exponent if x > 0.0 else 0.0
    return float(on_lines(curve.deflection, curve.force, x))


def _stop(stop: BumpStop | None, deflection: float) -> float:
    if stop is None or deflection <= stop.gap:
        return 0.0
    depth = deflection - stop.gap
    return stop.rate * depth + stop.progression * depth**3


def _at(points: Hardpoints, name: str) -> Array:
    return np.array(cast(Triple, points.at(name)))


def _velocity(twist: Twist, point: Array) -> Array:
    return np.asarray(twist[0] + np.cross(twist[1], point))


def _turn(axis: Array, through: Array) -> Twist:
    """Return the twist of a rotation about an axis (angular velocity, rad/s) through a point."""
    return -np.cross(axis, through), axis


def _twist(rig: Corner, body: str) -> Twist:
    """Return the twist of a body while the wheel centre rises at 1 m/s and the car's body is fixed."""
    points = rig.hardpoints
    if body in ("lower_arm", "upper_arm"):
        return _arm(points, body.removesuffix("_arm"), _carrier(points))
    if body.startswith("link_") or body == "tie_rod":
        return _link(_at(points, f"{body}_inner"), _at(points, f"{body}_outer"), _carrier(points))
    if body == "rocker":
        return _rocker(rig)
    return _carrier(points)


def _carrier(points: Hardpoints) -> Twist:
    """Return the twist of the wheel carrier; the sliding part of a McPherson strut has the same angular velocity."""
    centre = np.array(points.wheel_centre)
    if isinstance(points, TrailingArmHardpoints):
        through = np.array(points.arm_inner)
        twist = _turn(np.array(points.arm_outer) - through, through)
        rise = _velocity(twist, centre)[2]
        if abs(rise) < 1e-9:
            raise np.linalg.LinAlgError("the arm's axis is vertical or passes the wheel centre")
        return twist[0] / rise, twist[1] / rise
    rows = [*_constraint_directions(points), (np.array([0.0, 0.0, 1.0]), centre)]
    matrix = np.array([np.concatenate([along, np.cross(point, along)]) for along, point in rows])
    solved = np.linalg.solve(matrix, np.array([0.0] * 5 + [1.0]))
    return solved[:3], solved[3:]


def _constraint_directions(points: Hardpoints) -> list[tuple[Array, Array]]:
    """Return the five constraints of the upright: (direction, point), where the point cannot move in the direction."""
    directions = [
        (_at(points, inner) - _at(points, outer), _at(points, outer))
        for outer, inner in points.rods
    ]
    if isinstance(points, McPhersonHardpoints):  # the strut's line passes through a fixed point
        top = np.array(points.strut_top)
        line = top - np.array(points.strut_bottom)
        across = np.linalg.svd(line[np.newaxis])[2][1:]
        directions += [(direction, top) for direction in across]
    return directions


def _arm(points: Hardpoints, which: str, carrier: Twist) -> Twist:
    front, joint = _at(points, f"{which}_arm_front"), _at(points, f"{which}_ball_joint")
    axis = front - _at(points, f"{which}_arm_rear")
    lever = np.cross(axis, joint - front)
    return _turn(axis * (_velocity(carrier, joint) @ lever) / (lever @ lever), front)


def _link(inner: Array, outer: Array, carrier: Twist) -> Twist:
    """Return the twist of a link that does not spin about its own axis."""
    along = outer - inner
    return _turn(np.cross(along, _velocity(carrier, outer)) / (along @ along), inner)


def _rocker(rig: Corner) -> Twist:
    points = rig.hardpoints
    outer, inner, pivot = (
        _at(points, name) for name in ("pushrod_outer", "pushrod_inner", "rocker_pivot")
    )
    axis, rod = _at(points, "rocker_axis") - pivot, inner - outer
    push = rod @ _velocity(_twist(rig, str(getattr(rig.strut, "pushrod_on"))), outer)  # noqa: B009 - only rigs with rockers
    return _turn(axis * push / (rod @ np.cross(axis, inner - pivot)), pivot)
