"""A full car with one coordinate per corner: its body moves freely; with fixed racks, a wheel has only travel.

The car is built by :func:`jounce.models.full_car_3d.full_car_3d`. Each linkage is replaced by polynomials of the
wheel's travel, in the axes of the body: lengths, points of application of forces, direction of the wheel's axis, and
the mass properties that :class:`jounce.mechanics.carrier.TravellingMasses` requires. :func:`sampled_suspension`
computes them for driven poses. The equations are exact for these functions.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import NamedTuple

import casadi as ca

from jounce.mechanics import Mechanism, Model
from jounce.mechanics.bodies import Body
from jounce.mechanics.carrier import MovingCarrier, Shifting, TravellingMasses
from jounce.mechanics.driven import DrivenMechanism, Quasistatic
from jounce.mechanics.facts import HALF, MIDDLE, REACH, of_travel
from jounce.mechanics.frames import Frame, Moving, Orientation
from jounce.mechanics.rotations import skew
from jounce.models.attachments import bar_angle, link_end, third_end
from jounce.models.corner import add_torsion_bar, build_linkage
from jounce.models.full_car_3d import full_car_3d
from jounce.models.linkage import ElementLength, Linkage, Reached, Suspension
from jounce.models.reduced import INERTIA, MASS, SampledCorner, Watched, sampling_functions
from jounce.parts.corners import Corner
from jounce.parts.vehicles import FullCar3D

MOMENT, ANGULAR, TENSOR, TURNING = "moment", "angular", "tensor", "turning"
"""First moment, angular momentum and inertia about the origin of the body's axes; upright rotation per travel."""
AHEAD, TURNED, ORIGIN = "ahead", "turned", "origin"
"""Parameters of a sampled suspension that its position on the car determines: a linkage's, and the axes' origin."""
_AXES, _PAIRS = "xyz", ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))


def sampled_suspension(rig: Corner) -> SampledCorner:
    """Return the pose quantities that a car needs; the values in ``rig`` matter only through its structure."""
    mechanism = Quasistatic(gravity=ca.SX(0.0))
    number, travel = mechanism.parameter, mechanism.track("travel")
    rack = mechanism.track("rack") if getattr(rig, "steering", None) is not None else None
    place = {"ahead": number(AHEAD), "turned": number(TURNED)}
    linkage = build_linkage(rig, mechanism, mechanism.ground, rack=rack, kind=_Seen, **place)
    rise = linkage.wheel_centre.value[2] - linkage.number("hardpoints.wheel_centre[2]")
    mechanism.condition("wheel_travel", rise - travel.value)
    driven = DrivenMechanism(mechanism, [travel] if rack is None else [travel, rack])
    linkage.see()
    origin = ca.vertcat(*(number(f"{ORIGIN}[{i}]") for i in range(3)))
    return sampling_functions(mechanism, driven, _masses(linkage, origin) | linkage.seen)


class _Seen(Watched):
    """A linkage that also records requested points and directions."""

    def moving(self, name: str, formula: Callable[[Linkage], Moving]) -> Moving:
        """Return a point or a direction by its formula."""
        result = formula(self)
        self.seen.update(zip(_parts(name), ca.vertsplit(result.value), strict=True))
        return result

    def see(self) -> None:
        """Request all quantities that a car needs."""
        for element in ("spring", "damper") if self.damper_stands_apart else ("spring",):
            self.line(element)
        add_torsion_bar(self)
        bar = self.rig.anti_roll_bar
        if bar is not None and bar.kind == "t":
            link_end(self)
        elif bar is not None:
            bar_angle(self).value(self)
        if self.rig.third_spring is not None:
            third_end(self)
        for _ in (self.wheel_centre, self.spin_direction):
            pass
        self.seen.update(
            zip(
                _parts(TURNING),
                ca.vertsplit(self.upright.frame.orientation.ground_spin),
                strict=True,
            )
        )


def _parts(name: str) -> list[str]:
    return [f"{name}.{axis}" for axis in _AXES]


def _elements(name: str) -> list[str]:
    return [f"{name}.{_AXES[i]}{_AXES[k]}" for i, k in _PAIRS]


def _masses(linkage: Linkage, origin: ca.SX) -> dict[str, ca.SX]:
    """Return mass, moments and momenta of all bodies of a suspension, with rates in the momenta."""
    moment, angular, tensor, energy = ca.SX(3, 1), ca.SX(3, 1), ca.SX(3, 3), ca.SX(0.0)
    for body in linkage.mechanism.bodies.values():
        if (properties := body.mass_properties) is None:
            continue
        centre, orientation = body.frame.point(properties.centre), body.frame.orientation
        arm, own, spin = (
            centre.value - origin,
            orientation.turned(properties.inertia),
            orientation.ground_spin,
        )
        moment += properties.mass * arm
        angular += properties.mass * ca.cross(arm, centre.rate) + own @ spin
        tensor += own - properties.mass * skew(arm) @ skew(arm)
        energy += properties.mass * ca.dot(centre.rate, centre.rate) + ca.dot(spin, own @ spin)
    masses = {MASS: linkage.mass, INERTIA: energy}
    masses |= dict(zip(_parts(MOMENT), ca.vertsplit(moment), strict=True))
    masses |= dict(zip(_parts(ANGULAR), ca.vertsplit(angular), strict=True))
    return masses | dict(zip(_elements(TENSOR), (tensor[i, k] for i, k in _PAIRS), strict=True))


class _Curve(NamedTuple):
    """A quantity of travel and its first two derivatives."""

    value: ca.SX
    slope: ca.SX
    bend: ca.SX

    @classmethod
    def of(cls, curves: Sequence[_Curve]) -> _Curve:
        """Combine several quantities into one."""
        return cls(*(ca.vertcat(*parts) for parts in zip(*curves, strict=True)))

    def moving(self, rate: ca.SX) -> Moving:
        """Return the quantity with its time derivatives."""
        return Moving(self.value, self.slope * rate, self.bend * rate**2)


class _Travelling(Suspension):
    """A suspension described completely by polynomials of its travel."""

    def __init__(
        self,
        rig: Corner,
        mechanism: Mechanism,
        chassis: Body,
        *,
        degree: int,
        ahead: ca.SX | float = 0.0,
        turned: ca.SX | float = 1.0,
    ) -> None:
        self.rig, self.mechanism, self.chassis, self.degree = rig, mechanism, chassis, degree
        self.ahead, self.turned = ahead, turned
        self.travel = mechanism.coordinate("travel")
        self.rate = mechanism.rate_of(self.travel)
        self._place = mechanism.name_at_place("")
        self._half = self._own(HALF)
        self._x = (self.travel - self._own(MIDDLE)) / self._half
        self.upright = mechanism.body("upright")
        # Only its rotation is needed, not its orientation.
        spin = Orientation(ca.SX.eye(3), self._curves(TURNING).value * self.rate, ca.SX(3, 1))
        frame = Frame(self.hardpoint("wheel_centre"), self.wheel_centre, spin, self.carrier)
        mechanism.poses.frames[self.upright.name] = frame
        mechanism.inertia(self._masses())

    def _own(self, name: str) -> ca.SX:
        """Return a parameter of this corner alone; those of its description belong to the axle."""
        return self.mechanism.parameter_at(f"{self._place}{name}")

    def _masses(self) -> TravellingMasses:
        moment, angular, inertia = self._curves(MOMENT), self._curves(ANGULAR), self._curve(INERTIA)
        values = dict(zip(_PAIRS, (self._curve(name) for name in _elements(TENSOR)), strict=True))
        tensor = (
            ca.vertcat(
                *(
                    ca.horzcat(*(values[min(i, k), max(i, k)][part] for k in range(3)))
                    for i in range(3)
                )
            )
            for part in range(2)
        )
        return TravellingMasses(
            self.carrier,
            self.rate,
            self.mass,
            Shifting(moment.value, moment.slope),
            Shifting(moment.slope, moment.bend),
            Shifting(angular.value, angular.slope),
            Shifting(*tensor),
            Shifting(inertia.value, inertia.slope),
        )

    def _curve(self, name: str) -> _Curve:
        """Return the polynomial of a quantity and the polynomials of its derivatives."""
        given = [self._own(path) for path in of_travel(name, self.degree)]
        slopes = [k * number / self._half for k, number in enumerate(given)][1:]
        bends = [k * number / self._half for k, number in enumerate(slopes)][1:]
        return _Curve(*map(self._sum, (given, slopes, bends)))

    def _curves(self, name: str) -> _Curve:
        return _Curve.of([self._curve(part) for part in _parts(name)])

    def _sum(self, coefficients: Sequence[ca.SX]) -> ca.SX:
        """Sum even and odd powers separately, which lets the processor compute two sums in parallel."""
        square, sums = self._x * self._x, [ca.SX(0.0), ca.SX(0.0)]
        for odd in (0, 1):
            for number in reversed(coefficients[odd::2]):
                sums[odd] = sums[odd] * square + number
        return sums[0] + self._x * sums[1]

    @property
    def carrier(self) -> MovingCarrier:
        """The body's axes."""
        assert isinstance(self.chassis.carrier, MovingCarrier)
        return self.chassis.carrier

    @property
    def mass(self) -> ca.SX:
        """Total mass of its bodies, kg; zero beyond the range of the polynomials."""
        there = ca.fabs(self._x) <= self._own(REACH)
        return ca.if_else(there, self._own(of_travel(MASS, 0)[0]), ca.SX.nan())

    @property
    def wheel_centre(self) -> Moving:
        """The wheel's centre; its height is the travel."""
        x, y = (self._curve(name) for name in _parts("wheel_centre")[:2])
        height = self.hardpoint("wheel_centre")[2] + self.travel
        return _Curve.of([x, y, _Curve(height, ca.SX(1.0), ca.SX(0.0))]).moving(self.rate)

    def moving(self, name: str, formula: Callable[[Linkage], Moving]) -> Moving:  # noqa: ARG002 - it has no pose
        """Return a point or a direction by its name."""
        return self._curves(name).moving(self.rate)

    def of_pose(self, name: str, formula: Callable[[Linkage], ca.SX]) -> ca.SX:  # noqa: ARG002
        """Return the polynomial."""
        return self._curve(name).value

    def of_wheel(self, name: str, formula: Callable[[Suspension], ca.SX]) -> ca.SX:  # noqa: ARG002
        """Return a quantity that also depends on the body's attitude, by its formula."""
        return formula(self)

    def line(self, element: str) -> ElementLength:
        """Return the length of the spring or the damper."""
        length = self._curve(f"{element if self.damper_stands_apart else 'spring'}.length")
        return ElementLength(length.value, length.slope * self.rate, self.design_length(element))

    def carrier_of(self, name: str) -> Body:  # noqa: ARG002 - points do not depend on the body
        """Return the substitute for all bodies of the suspension in loads."""
        return self.upright

    def press(self, reached: Reached, force: ca.SX) -> None:
        """Apply a force (N, N m) that increases a quantity."""
        self.mechanism.force(reached.value(self), force)

    def push(self, line: ElementLength, force: ca.SX) -> None:
        """Apply a force (N) that pushes the ends of an element apart."""
        self.mechanism.load(line.rate, force)


def reduced_car(vehicle: FullCar3D, degree: int) -> Model:
    """Write the equations of a car with polynomials of travel of a degree; channels are those of the full car."""
    return full_car_3d(vehicle, hang=partial(_Travelling, degree=degree))
