"""Symbolic view of a corner: positions and velocities in the axes of a left wheel, derivatives by travel.

Right-hand corners are mirrored in y first; every formula is written once, for a left wheel; ``side`` converts
back to ground axes. All expressions are functions of the pose alone once the model is bound.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

import casadi as ca

from jounce.mechanics import Track
from jounce.mechanics.contact import towards_road
from jounce.mechanics.driven import Quasistatic
from jounce.mechanics.elements import curve_force, damper_force
from jounce.mechanics.frames import Moving
from jounce.mechanics.rotations import rotate, unit
from jounce.models.attachments import (
    bar_angle,
    bar_axis,
    bar_stiffness,
    link_end,
    spring_law,
    still_third_law,
    stop_law,
    third_damper_law,
    third_end,
    third_law,
    torsion_law,
    undeformed_radius,
    winding,
)
from jounce.models.linkage import Line, Linkage

_UP = ca.SX([0.0, 0.0, 1.0])
_TINY = 1e-12  # m/s: on either side of rest, for one-sided slopes


@dataclass(frozen=True)
class Axis:
    """A line: a point, and its direction (pointing up)."""

    point: ca.SX
    along: ca.SX

    def at_height(self, z: ca.SX) -> ca.SX:
        """Point of the line at a height."""
        return self.point + self.along * ((z - self.point[2]) / self.along[2])

    def leads(self, point: ca.SX) -> ca.SX:
        """Horizontal offset of the line from a point at its height: ahead (x) and inboard (-y), shape (2,)."""
        return (self.at_height(point[2]) - point)[:2]


@dataclass(frozen=True)
class ScrewMotion:
    """A motion of the upright: its angular velocity, and the velocity of the wheel centre."""

    turn: ca.SX
    speed: ca.SX

    def with_share(self, share: ca.SX, other: ScrewMotion) -> ScrewMotion:
        """Return the motion plus a share of a different one."""
        return ScrewMotion(self.turn + share * other.turn, self.speed + share * other.speed)

    @property
    def pitch(self) -> ca.SX:
        """Motion along the axis over the turn about it, m/rad."""
        return ca.dot(self.turn, self.speed) / ca.dot(self.turn, self.turn)

    def axis(self, centre: ca.SX) -> Axis:
        """Axis of the motion, for a given wheel centre."""
        point = centre + ca.cross(self.turn, self.speed) / ca.dot(self.turn, self.turn)
        return Axis(point, self.turn * ca.sign(self.turn[2]))


@dataclass(frozen=True)
class Elastic:
    """An element along a line: force (N, compression positive) and stiffness (N/m) at its length."""

    force: ca.SX
    stiffness: ca.SX


def steering_screw(rack: ScrewMotion, travel: ScrewMotion) -> ScrewMotion:
    """Combine rack and travel to a pure rotation (of two, the one with less travel), or else a screw of least pitch.

    With a share t of travel, the numerator of the pitch is a t^2 + b t + c. Its root of smaller magnitude is the
    rotation about the ball joints, if the corner has them. Without a real root, the pitch is minimal at one of its
    extrema, which are the roots of (aB - bA) t^2 + 2 (aC - cA) t + (bC - cB), with the denominator A t^2 + B t + C.
    """

    def turn(screw: ScrewMotion) -> ca.SX:
        return screw.turn

    def speed(screw: ScrewMotion) -> ca.SX:
        return screw.speed

    def products(other: Callable[[ScrewMotion], ca.SX]) -> tuple[ca.SX, ca.SX, ca.SX]:
        mixed = ca.dot(rack.turn, other(travel)) + ca.dot(travel.turn, other(rack))
        return ca.dot(travel.turn, other(travel)), mixed, ca.dot(rack.turn, other(rack))

    a, b, c = products(speed)
    square, mixed, free = products(turn)
    under = b**2 - 4.0 * a * c
    pure = _smaller_root(b, c, ca.fmax(under, 0.0))
    steep, level, flat = a * mixed - b * square, a * free - c * square, b * free - c * mixed
    first = _smaller_root(2.0 * level, flat, ca.fmax(4.0 * (level**2 - steep * flat), 0.0))
    second = -2.0 * level / steep - first
    first_pitch, second_pitch = (
        rack.with_share(share, travel).pitch ** 2 for share in (first, second)
    )
    least = ca.if_else(second_pitch < first_pitch, second, first)
    return rack.with_share(ca.if_else(under >= 0.0, pure, least), travel)


def caster_of(axis: Axis) -> ca.SX:
    """Caster angle of a line, rad."""
    return ca.atan2(-axis.along[0], axis.along[2])


def _slope_at_rest(force: ca.SX, velocity: ca.SX) -> ca.SX:
    """Return the slope of a damper's force at rest, the mean of both directions."""
    slope = ca.jacobian(force, velocity)
    return 0.5 * (
        ca.substitute(slope, velocity, ca.SX(-_TINY)) + ca.substitute(slope, velocity, ca.SX(_TINY))
    )


def _angle(first: ca.SX, second: ca.SX) -> ca.SX:
    """Angle between two directions, rad."""
    across = ca.cross(first, second)
    return ca.atan2(ca.sqrt(ca.dot(across, across)), ca.dot(first, second))


def _smaller_root(b: ca.SX, c: ca.SX, discriminant: ca.SX) -> ca.SX:
    """Return the root of smaller magnitude of a quadratic with the last coefficients b and c, free of cancellation."""
    half = b + ca.copysign(ca.sqrt(discriminant), b)
    return ca.if_else(c == 0.0, 0.0, -2.0 * c / half)


class CornerView:
    """Positions (m) and their rates for a unit rate of travel, in the axes of a left wheel.

    The suspension's body is fixed. ``steered`` replaces the speeds in an expression by those for a unit rate of the
    rack; ``steered`` and ``rack`` are None without a rack.
    """

    def __init__(
        self,
        mechanism: Quasistatic,
        linkage: Linkage,
        travel: Track,
        rack: Track | None,
        steered: Callable[[ca.SX], ca.SX] | None,
    ) -> None:
        self.mechanism, self.linkage, self.travel, self.rack = mechanism, linkage, travel, rack
        self.side = linkage.rig.sign
        self._steered = steered
        self._mirror = ca.SX([1.0, self.side, 1.0])

    # derivatives -----------------------------------------------------------------------------------------------

    def slope(self, expression: ca.SX) -> ca.SX:
        """Derivative by travel, also of derivatives."""
        return self.mechanism.derivative(expression)

    def by_rack(self, expression: ca.SX) -> ca.SX:
        """Derivative by rack travel, at constant height of the wheel centre."""
        assert self._steered is not None
        return self._steered(self.mechanism.rate_of(expression))

    # wheel -----------------------------------------------------------------------------------------------------

    @cached_property
    def centre(self) -> Moving:
        """Wheel centre."""
        return self._reflect(self.linkage.wheel_centre)

    @cached_property
    def axis(self) -> ca.SX:
        """Unit vector along the wheel's axis, pointing outboard."""
        return self._reflect(self.linkage.spin_direction).value

    @cached_property
    def spin(self) -> ca.SX:
        """Angular velocity of the upright; mirroring reverses its components across y."""
        return self._reflect_spin(self.linkage.upright.spin)

    @cached_property
    def radius(self) -> ca.SX:
        """Distance of the ground from the wheel centre in the wheel's plane."""
        return self.linkage.number("wheel.radius")

    @cached_property
    def reach(self) -> ca.SX:
        """From the wheel centre to the contact point."""
        return self.radius * ca.vertcat(*towards_road(self.axis, _UP)[0])

    @cached_property
    def contact(self) -> ca.SX:
        """Contact point."""
        return self.centre.value + self.reach

    @cached_property
    def patch(self) -> ca.SX:
        """Velocity of the contact patch, fixed to the upright (locked wheel)."""
        return self.centre.rate + ca.cross(self.spin, self.reach)

    @cached_property
    def design_contact(self) -> ca.SX:
        """Contact point in the design pose."""
        axis = self._mirror * self.linkage.spin_axis
        reach = self.radius * ca.vertcat(*towards_road(axis, _UP)[0])
        return self._mirror * self.linkage.hardpoint("wheel_centre") + reach

    @cached_property
    def camber(self) -> ca.SX:
        """Camber angle, rad."""
        return -ca.asin(self.axis[2])

    @cached_property
    def toe_out(self) -> ca.SX:
        """Steer angle of a left wheel, rad."""
        return ca.atan2(-self.axis[0], self.axis[1])

    # steering axis ---------------------------------------------------------------------------------------------

    @property
    def steers(self) -> bool:
        """Whether the wheel has a steering axis."""
        return self._steered is not None

    @cached_property
    def steering_axis(self) -> Axis:
        """Axis through the ball joints; without them, that of the rotation by combined rack and travel."""
        if hasattr(self.linkage, "steering_axis"):
            lower, upper = (self._mirror * point.value for point in self.linkage.steering_axis)
            return Axis(lower, upper - lower)
        return self._turning.axis(self.centre.value)

    @property
    def steering_pitch(self) -> ca.SX:
        """Motion along the steering axis over the turn about it, m/rad: 0 for a pure turn."""
        return ca.SX(0.0) if hasattr(self.linkage, "steering_axis") else self._turning.pitch

    @cached_property
    def held_axis(self) -> Axis:
        """Screw axis of the motion due to the rack at constant spring length."""
        share = self.by_rack(self.spring.length) / self.motion_ratio
        return self._by_rack.with_share(share, self._by_travel).axis(self.centre.value)

    @property
    def _by_travel(self) -> ScrewMotion:
        return ScrewMotion(self.spin, self.centre.rate)

    @property
    def _by_rack(self) -> ScrewMotion:
        assert self._steered is not None
        return ScrewMotion(self._steered(self.spin), self._steered(self.centre.rate))

    @cached_property
    def _turning(self) -> ScrewMotion:
        return steering_screw(self._by_rack, self._by_travel)

    @cached_property
    def caster(self) -> ca.SX:
        """Caster angle, rad."""
        return caster_of(self.steering_axis)

    # elements --------------------------------------------------------------------------------------------------

    @cached_property
    def spring(self) -> Line:
        """Line of the spring."""
        return self.linkage.line("spring")

    @cached_property
    def damper(self) -> Line:
        """Line of the damper."""
        return self.linkage.line("damper")

    @cached_property
    def springs(self) -> Elastic:
        """The spring alone."""
        return self._elastic(spring_law, self.spring)

    @cached_property
    def stops(self) -> Elastic:
        """Bump and rebound stops, which act along the spring."""
        return self._elastic(stop_law, self.spring)

    @cached_property
    def damping_coefficient(self) -> ca.SX:
        """Slope of the damper's force at rest (N s/m), the mean of both directions; without friction."""
        velocity = ca.SX.sym("damper velocity")
        return _slope_at_rest(self._damper_force(self.damper, velocity), velocity)

    @cached_property
    def still_damper(self) -> Elastic:
        """The damper at rest: its gas, and the stroke-dependent part of its law."""
        return self._elastic(lambda _, line: self._damper_force(line, ca.SX(0.0)), self.damper)

    def _damper_force(self, line: Line, velocity: ca.SX) -> ca.SX:
        law = self.linkage.rig.strut.damper
        return damper_force(
            self.mechanism, law, "strut.damper", line.deflection, velocity, length=line.length
        )

    @cached_property
    def motion_ratio(self) -> ca.SX:
        """Shortening of the spring for a rise of the wheel centre."""
        return -self.slope(self.spring.length)

    @cached_property
    def contact_ratio(self) -> ca.SX:
        """Shortening of the spring for a rise of the contact patch."""
        return self.motion_ratio / self.patch[2]

    @cached_property
    def damper_ratio(self) -> ca.SX:
        """Shortening of the damper for a rise of the wheel centre."""
        return -self.slope(self.damper.length)

    @cached_property
    def tyre_deflection(self) -> ca.SX:
        """Undeformed radius minus the distance of the ground in the wheel's plane."""
        return undeformed_radius(self.linkage) - self.radius

    @property
    def has_tyre_stiffness(self) -> bool:
        """Whether the tyre has a constant stiffness, or a curve and a known deflection."""
        tyre = self.linkage.rig.tyre
        return tyre.curve is None or tyre.undeformed_radius is not None

    @cached_property
    def tyre_stiffness(self) -> ca.SX:
        """Slope of the tyre's force at its deflection, N/m."""
        curve = self.linkage.rig.tyre.curve
        if curve is None:
            return self.mechanism.parameter("tyre.stiffness")
        deflection = ca.SX.sym("tyre deflection")
        force = curve_force(self.mechanism, curve, "tyre.curve", deflection)
        return ca.substitute(ca.jacobian(force, deflection), deflection, self.tyre_deflection)

    @cached_property
    def bar_angle(self) -> ca.SX:
        """Rotation of the anti-roll bar's end about its axis, which points to the left, rad, 0 at design."""
        return bar_angle(self.linkage).value(self.linkage)

    @property
    def bar_points(self) -> dict[str, ca.SX]:
        """Moving points of the anti-roll bar, ground axes."""
        hardpoint, angle, axis = self.linkage.hardpoint, self.bar_angle, bar_axis(self.linkage)
        pivot = hardpoint("arb_pivot")
        arm = hardpoint("arb_arm_end") - pivot
        points = {
            "arb_arm_end": pivot + rotate(arm, axis, angle),
            "arb_link_end": link_end(self.linkage).value,
        }
        if self._is_t_bar:
            stem = hardpoint("arb_axis") - pivot
            points["arb_axis"] = pivot + self._stem * ca.sqrt(ca.dot(stem, stem))
        return points

    @cached_property
    def bar_twist_ratio(self) -> ca.SX:
        """Twist of the bar per rise of this wheel and equal fall of the other one, rad/m, where both are alike.

        Both ends twist a U-bar; the stem of a T-bar lets the ends of its bar move against each other.
        """
        bar = self.linkage.rig.anti_roll_bar
        assert bar is not None
        if bar.kind == "z":
            return ca.SX(0.0)
        if bar.kind == "u":
            return 2.0 * self.slope(self.bar_angle)
        link, moving = self._bar_link, link_end(self.linkage)
        lever = self.bar_points["arb_arm_end"] - self.linkage.hardpoint("arb_pivot")
        return ca.dot(link, moving.rate) / ca.dot(link, ca.cross(self._stem, lever))

    @cached_property
    def bar_heave_ratio(self) -> ca.SX:
        """Twist of a Z-bar per equal rise of both wheels, rad/m."""
        return 2.0 * self.slope(self.bar_angle)

    @property
    def _stem(self) -> ca.SX:
        """Direction of a T-bar's stem, hinged with the bar."""
        design = unit(self.linkage.hardpoint("arb_axis") - self.linkage.hardpoint("arb_pivot"))
        return rotate(design, bar_axis(self.linkage), self.bar_angle)

    @property
    def _bar_link(self) -> ca.SX:
        """From the end of the bar's arm to the other end of its link."""
        points = self.bar_points
        return points["arb_link_end"] - points["arb_arm_end"]

    @cached_property
    def bar_arm_angle(self) -> ca.SX:
        """Angle between the bar's arm and its link, rad: most effective at a right angle."""
        arm = self.bar_points["arb_arm_end"] - self.linkage.hardpoint("arb_pivot")
        axis = self._stem if self._is_t_bar else bar_axis(self.linkage)
        return _angle(arm - ca.dot(axis, arm) * axis, self._bar_link)

    @property
    def _is_t_bar(self) -> bool:
        bar = self.linkage.rig.anti_roll_bar
        return bar is not None and bar.kind == "t"

    @cached_property
    def bar_stiffness(self) -> ca.SX:
        """Stiffness of the bar with its blades in series, N m/rad of twist."""
        return bar_stiffness(self.linkage)

    # torsion bar, third spring, rocker and arms ----------------------------------------------------------------

    def turn_of(self, body: str) -> ca.SX:
        """Rotation of an arm, or the rocker, about its axis from design, rad, positive in bump."""
        return winding(self.linkage, body)

    @cached_property
    def torsion_angle(self) -> ca.SX:
        """Rotation of the torsion bar from design, rad, positive in bump."""
        assert self.linkage.rig.torsion_bar is not None
        return self.turn_of(self.linkage.rig.torsion_bar.on)

    @cached_property
    def torsion_torque(self) -> ca.SX:
        """Torque of the torsion bar, N m, positive against bump."""
        return torsion_law(self.linkage, self.torsion_angle)

    @cached_property
    def third_length(self) -> ca.SX:
        """Length of the third spring when both wheels move in parallel, m."""
        return 2.0 * self.side * third_end(self.linkage).value[1]

    @cached_property
    def third_ratio(self) -> ca.SX:
        """Shortening of the third spring for a rise of both wheel centres."""
        return -self.slope(self.third_length)

    @property
    def across(self) -> ca.SX:
        """Position, and derivative by travel, of the ends of a T-bar's link and of the third spring, if any.

        In the axes of a left wheel, shape (6,) or (12,).
        """
        ends = []
        if self._is_t_bar:
            ends.append(link_end(self.linkage))
        if self.linkage.rig.third_spring is not None:
            ends.append(third_end(self.linkage))
        mirrored = [self._reflect(end) for end in ends]
        return ca.vertcat(*(part for end in mirrored for part in (end.value, end.rate)))

    @cached_property
    def third(self) -> Elastic:
        """The third spring alone."""
        return self._along_third(lambda length: third_law(self.linkage, length))

    @cached_property
    def still_third_damper(self) -> Elastic:
        """The third damper at rest."""
        return self._along_third(lambda length: still_third_law(self.linkage, length))

    def _along_third(self, law: Callable[[ca.SX], ca.SX]) -> Elastic:
        length = ca.SX.sym("third length")
        force = ca.SX(law(length))
        parts = (
            ca.substitute(part, length, self.third_length)
            for part in (force, -ca.jacobian(force, length))
        )
        return Elastic(*parts)

    @cached_property
    def third_damping_coefficient(self) -> ca.SX:
        """Slope of the third damper's force at rest (N s/m), the mean of both directions."""
        velocity = ca.SX.sym("third velocity")
        design = 2.0 * self.side * self.linkage.hardpoint("third_spring_end")[1]
        return _slope_at_rest(
            third_damper_law(self.linkage, design - self.third_length, velocity), velocity
        )

    @cached_property
    def pushrod_angle(self) -> ca.SX:
        """Angle between the push rod and the rocker's arm to it, rad."""
        return self._at_rocker(
            self._place("pushrod_inner") - self._place("pushrod_outer"), "pushrod_inner"
        )

    @cached_property
    def strut_angle(self) -> ca.SX:
        """Angle between the spring and the rocker's arm to it, rad."""
        spring = self.spring
        return self._at_rocker(
            spring.bottom.value - spring.top.value, "strut_bottom", spring.bottom.value
        )

    def _at_rocker(self, line: ca.SX, name: str, place: ca.SX | None = None) -> ca.SX:
        pivot = self._place("rocker_pivot")
        axis = unit(self._place("rocker_axis") - pivot)
        arm = (self._place(name) if place is None else place) - pivot
        return _angle(arm - ca.dot(axis, arm) * axis, -line)

    def _place(self, name: str) -> ca.SX:
        return self.linkage.owners[name].frame.point(self.linkage.hardpoint(name)).value

    # pieces ----------------------------------------------------------------------------------------------------

    def _elastic(self, law: Callable[[Linkage, Line], ca.SX], line: Line) -> Elastic:
        length = ca.SX.sym("length")
        force = law(self.linkage, replace(line, length=length))
        stiffness = -ca.jacobian(force, length)
        return Elastic(
            *(ca.substitute(part, length, line.length) for part in (ca.SX(force), stiffness))
        )

    def _reflect(self, moving: Moving) -> Moving:
        mirror = self._mirror
        return Moving(mirror * moving.value, mirror * moving.rate, mirror * moving.bias)

    def _reflect_spin(self, spin: ca.SX) -> ca.SX:
        return ca.SX([self.side, 1.0, self.side]) * spin
