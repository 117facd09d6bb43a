"""Common parts of all 3-D suspensions: body on its guide, hardpoint parameters, wheel, steering; templates add arms."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import casadi as ca

from jounce.mechanics import Mechanism, System
from jounce.mechanics.bodies import Body
from jounce.mechanics.bushings import Curves, Deflection, ElasticJoint, add_elastic_rod
from jounce.mechanics.elements import bushing_curve, bushing_slope
from jounce.mechanics.frames import Carrier, Moving
from jounce.mechanics.loads import ForceBetween
from jounce.mechanics.rotations import normals, unit
from jounce.parts.bushings import DIRECTIONS, REVERSED
from jounce.parts.corners import Corner


class DescribedSuspension(ABC):
    """A suspension as seen by its force laws: the parameters of its description, and quantities of its pose."""

    rig: Corner  # only its structure matters, its numbers are parameters
    mechanism: System
    ahead: ca.SX | float = 0.0  # shift of the whole corner along x, m
    turned: ca.SX | float = 1.0  # -1 for a suspension on the side opposite to its description

    @abstractmethod
    def of_pose(self, name: str, formula: Callable[[Linkage], ca.SX]) -> ca.SX:
        """Return a quantity of the pose relative to the car's body, by its formula or by its name.

        Forces and channels access the pose only through this method.
        """

    def of_wheel(self, name: str, formula: Callable[[Suspension], ca.SX]) -> ca.SX:
        """Return a quantity of the wheel's axis and centre and the ground, which may depend on body attitude."""
        return self.of_pose(name, formula)

    @abstractmethod
    def press(self, reached: Reached, force: ca.SX) -> None:
        """Apply a force (N, N m) that increases a quantity, between its point and the car's body."""

    @property
    def side(self) -> ca.SX | float:
        """1 for a left suspension, -1 for a right one."""
        return self.rig.sign * self.turned

    def hardpoint(self, name: str) -> ca.SX:
        """Return the design position of a hardpoint, m."""
        return self.place(f"hardpoints.{name}")

    def place(self, path: str) -> ca.SX:
        """Return the design position of a point of the description, m, shifted forward, on the suspension's side."""
        x, y, z = ca.vertsplit(self.triple(path))
        return ca.vertcat(x + self.ahead, self.turned * y, z)

    def end_of(self, element: str, end: str) -> ca.SX:
        """Return the design position of the ``bottom`` or ``top`` of spring or damper; by default the strut's."""
        own = f"{element}_{end}"
        return self.hardpoint(
            own if getattr(self.rig.hardpoints, own) is not None else f"strut_{end}"
        )

    def design_length(self, element: str) -> ca.SX:
        """Return the length of ``"spring"`` or ``"damper"`` at design, m."""
        design = self.end_of(element, "top") - self.end_of(element, "bottom")
        return ca.sqrt(ca.dot(design, design))

    @property
    def damper_stands_apart(self) -> bool:
        """Whether the damper's ends differ from the spring's."""
        ends = (f"{element}_{end}" for element in ("spring", "damper") for end in ("bottom", "top"))
        return any(getattr(self.rig.hardpoints, name) is not None for name in ends)

    def triple(self, path: str) -> ca.SX:
        """Return the three parameters ``path[0]`` to ``path[2]``."""
        return ca.vertcat(*(self.mechanism.parameter(f"{path}[{i}]") for i in range(3)))

    def number(self, path: str) -> ca.SX:
        """A parameter."""
        return self.mechanism.parameter(path)


@dataclass(frozen=True)
class Reached:
    """A quantity of the pose that depends on one point: a hardpoint of the body called ``on``.

    ``formula`` computes it from that point's position (m) in the axes of the car's body, as in the design pose.
    """

    name: str
    on: str
    point: str
    formula: Callable[[DescribedSuspension, ca.SX], ca.SX]

    def value(self, linkage: DescribedSuspension) -> ca.SX:
        """The quantity."""

        def formula(whole: Linkage) -> ca.SX:
            return self.formula(whole, whole.seen_from_body(self.end(whole).value))

        return linkage.of_pose(self.name, formula)

    def end(self, linkage: Linkage) -> Moving:
        """Its point."""
        return linkage.carriers[self.on].frame.point(linkage.hardpoint(self.point))


@dataclass(frozen=True)
class ElementLength:
    """Length of an element, its rate, and the length at design."""

    length: ca.SX
    rate: ca.SX
    design: ca.SX

    @property
    def deflection(self) -> ca.SX:
        """Design length minus length, m."""
        return self.design - self.length


@dataclass(frozen=True)
class Line(ElementLength):
    """The line between the two ends of an element."""

    bottom: Moving
    top: Moving


class Suspension(DescribedSuspension):
    """A suspension whose points are given in the axes of its carrier."""

    mechanism: Mechanism
    chassis: Body  # the car's
    upright: Body  # carries the wheel

    @abstractmethod
    def moving(self, name: str, formula: Callable[[Linkage], Moving]) -> Moving:
        """Return a point or a direction, by its formula or by its name."""

    @abstractmethod
    def line(self, element: str) -> ElementLength:
        """Return the length of ``"spring"`` or ``"damper"``."""

    @abstractmethod
    def push(self, line: ElementLength, force: ca.SX) -> None:
        """Apply a force (N) that pushes the ends of an element apart."""

    def push_off(self, name: str, on: str, point: Moving, force: ca.SX) -> None:
        """Apply a force (N, axes of the carrier) to a point of a body, and its opposite to the car's body."""
        self.mechanism.act(ForceBetween(name, self.chassis, self.carrier_of(on), point, force))

    @abstractmethod
    def carrier_of(self, name: str) -> Body:
        """Return the body with a name used in descriptions, or its substitute for loads."""

    @property
    @abstractmethod
    def mass(self) -> ca.SX:
        """Total mass of its bodies, kg."""

    @property
    @abstractmethod
    def carrier(self) -> Carrier:
        """Carrier of the suspension's axes: the ground, or the car's body."""

    @property
    def spin_axis(self) -> ca.SX:
        """Axis of the wheel at design, pointing outboard."""
        camber, toe = self.number("wheel.camber"), self.number("wheel.toe")
        level = ca.cos(camber)
        return ca.vertcat(ca.sin(toe) * level, self.side * ca.cos(toe) * level, -ca.sin(camber))

    @property
    def wheel_centre(self) -> Moving:
        """The wheel's centre."""
        return self.moving(
            "wheel_centre", lambda whole: whole.upright.frame.point(whole.hardpoint("wheel_centre"))
        )

    @property
    def spin_direction(self) -> Moving:
        """The wheel's axis, pointing outboard, moving with the upright."""
        return self.moving(
            "spin_direction", lambda whole: whole.upright.frame.direction(whole.spin_axis)
        )


@dataclass
class Linkage(Suspension):
    """A suspension under construction: the mechanism, its bodies by name, and their roles."""

    rig: Corner
    mechanism: Mechanism
    chassis: Body
    rack: Body  # carries the inner end of the tie rod along y
    upright: Body = field(init=False)  # carries the wheel
    steering_axis: tuple[Moving, Moving] = field(init=False)  # its lower and upper point
    carriers: dict[str, Body] = field(
        default_factory=dict
    )  # bodies by the names that descriptions use
    owners: dict[str, Body] = field(default_factory=dict)  # body to which each hardpoint is fixed
    lines: dict[str, tuple[str, ...]] = field(
        default_factory=dict
    )  # what to draw: hardpoints along each part
    bushings: dict[str, tuple[ca.SX, ca.SX]] = field(
        default_factory=dict
    )  # force (N, ground axes) and power (W)
    ahead: ca.SX | float = 0.0
    turned: ca.SX | float = 1.0

    def of_pose(self, name: str, formula: Callable[[Linkage], ca.SX]) -> ca.SX:  # noqa: ARG002 - it has a pose
        """Return a quantity of the pose by its formula."""
        return formula(self)

    def moving(self, name: str, formula: Callable[[Linkage], Moving]) -> Moving:  # noqa: ARG002
        """Return a point or a direction by its formula."""
        return formula(self)

    def line(self, element: str) -> Line:
        """Return the line of ``"spring"`` or ``"damper"``."""
        bottom, top = self.end_of(element, "bottom"), self.end_of(element, "top")
        lower, upper = (
            self.carriers[self.rig.strut.on].frame.point(bottom),
            self.chassis.frame.point(top),
        )
        reach = upper - lower
        length = self.of_pose(
            f"{element}.length", lambda _: ca.sqrt(ca.dot(reach.value, reach.value))
        )
        return Line(
            length,
            ca.dot(reach.value, reach.rate) / length,
            self.design_length(element),
            lower,
            upper,
        )

    def push(self, line: ElementLength, force: ca.SX) -> None:
        """Apply a force (N) that pushes the ends of an element apart."""
        assert isinstance(line, Line)
        body = self.carriers[self.rig.strut.on]
        self.mechanism.push_apart(self.chassis, body, line.top, line.bottom, force)

    def press(self, reached: Reached, force: ca.SX) -> None:
        """Apply a force (N, N m) that increases a quantity, between its point and the car's body."""
        end, place = reached.end(self), ca.SX.sym("place", 3)
        pushed = force * ca.gradient(reached.formula(self, place), place)
        pushed = ca.substitute(pushed, place, self.seen_from_body(end.value))
        self.push_off(reached.name, reached.on, end, self.chassis.frame.orientation.rotate(pushed))

    def seen_from_body(self, place: ca.SX) -> ca.SX:
        """Return a position in the axes of the car's body, m, as in the design pose."""
        frame = self.chassis.frame
        return frame.orientation.unrotate(place - frame.point(ca.SX(3, 1)).value)

    def carrier_of(self, name: str) -> Body:
        """Return the body with a name used in descriptions."""
        return self.carriers[name]

    @property
    def mass(self) -> ca.SX:
        """Total mass of its bodies, kg."""
        bodies = {body.name: body.mass_properties for body in self.carriers.values()}
        return sum((each.mass for each in bodies.values() if each is not None), ca.SX(0.0))

    def body(self, name: str, path: str | None = None) -> Body:
        """Add a body of the description's ``bodies``."""
        path = path or f"bodies.{name}"
        xx, yy, zz, xy, xz, yz = (
            self.number(f"{path}.inertia.{e}") for e in ("xx", "yy", "zz", "xy", "xz", "yz")
        )
        xy, yz = self.turned * xy, self.turned * yz
        tensor = ca.vertcat(ca.horzcat(xx, xy, xz), ca.horzcat(xy, yy, yz), ca.horzcat(xz, yz, zz))
        body = self.mechanism.body(
            name, self.number(f"{path}.mass"), self.place(f"{path}.centre_of_mass"), tensor
        )
        self.carriers[name] = body
        return body

    def carry(self, name: str, body: Body) -> None:
        """Set the body that carries the upright's parts, and add a separate wheel to it."""
        self.upright = self.owners["wheel_centre"] = body
        self.carriers["upright"] = self.carriers[name] = body
        if getattr(self.rig.bodies, "wheel", None) is not None:
            self.mechanism.fixed("wheel", body, self.body("wheel"))

    def arm(self, name: str) -> Body:
        """Add an arm that rotates about its axis through ``<name>_front`` and ``<name>_rear``."""
        arm = self.body(name)
        ball = name.replace("arm", "ball_joint")
        self.lines[name] = (f"{name}_front", ball, f"{name}_rear")
        self.owners.update({f"{name}_front": self.chassis, f"{name}_rear": self.chassis, ball: arm})
        self.pivot(name, arm, (f"{name}_front", f"{name}_rear"))
        return arm

    def pivot(self, name: str, arm: Body, ends: tuple[str, str]) -> None:
        """Connect an arm to the body at two hardpoints: by a hinge, or by bushings at hardpoints that have them."""
        soft = [end for end in ends if self.has_bushing(end)]
        ideal = [self.hardpoint(end) for end in ends if end not in soft]
        if not soft:
            self.mechanism.revolute(name, self.chassis, arm, at=ideal[0], axis=ideal[0] - ideal[1])
        elif ideal:
            self.mechanism.spherical(name, self.chassis, arm, at=ideal[0])
        else:
            self.mechanism.free(name, arm, moving_frame=self.moving_frame)
        for end in soft:
            self.cushion(end, self.chassis, arm)

    def cushion(self, point: str, first: Body, second: Body) -> None:
        """Add the bushing at a hardpoint between two bodies."""
        names = ("stiffness", "damping", "rotational_stiffness")
        given = {name: self.triple(f"bushings.{point}.{name}") for name in names}
        for name, directions in (
            ("preload", DIRECTIONS[:3]),
            ("rotational_preload", DIRECTIONS[3:]),
        ):
            if getattr(self.bushing(point), name) is not None:
                signs = ca.vertcat(*(self.sign_of(direction) for direction in directions))
                given[name] = signs * self.triple(f"bushings.{point}.{name}")
        law = ElasticJoint(
            point,
            first,
            second,
            self.hardpoint(point),
            rotational_damping=ca.SX(3, 1),
            axes=self.bushing_axes(point),
            curves=self.bushing_curves(point),
            **given,
        )
        bushing = Deflection(*self.mechanism.act(law).shown)
        self.bushings[point] = first.frame.orientation.rotate(bushing.force), bushing.power

    def has_bushing(self, point: str) -> bool:
        """Whether the description has a bushing at a hardpoint."""
        return self.bushing(point) is not None

    def bushing(self, point: str) -> Any:
        """Return the description of the bushing at a hardpoint, None without one."""
        return getattr(getattr(self.rig, "bushings", None), point, None)

    def sign_of(self, direction: str) -> ca.SX | float:
        """-1 if the suspension is on the other side and a reflection reverses this direction of a bushing, else 1."""
        return self.turned if direction in REVERSED else 1.0

    def bushing_axes(self, point: str) -> ca.SX | None:
        """Return a bushing's own axes as columns, on the suspension's side; None for those of the design pose."""
        bushing = self.bushing(point)
        if bushing.x_axis is None and bushing.z_axis is None:
            return None

        def axis(name: str, default: tuple[float, float, float]) -> ca.SX:
            given = getattr(bushing, name) is not None
            x, y, z = ca.vertsplit(
                self.triple(f"bushings.{point}.{name}") if given else ca.SX(default)
            )
            return ca.vertcat(x, self.turned * y, z)

        x, z = axis("x_axis", (1.0, 0.0, 0.0)), axis("z_axis", (0.0, 0.0, 1.0))
        if bushing.x_axis is None:
            z = unit(z)
            x = x - ca.dot(x, z) * z
        x = unit(x)
        z = unit(z - ca.dot(z, x) * x)
        return ca.horzcat(x, ca.cross(z, x), z)

    def bushing_curves(self, point: str) -> Curves | None:
        """Return the curves of a bushing on the suspension's side, None without any."""
        described = self.bushing(point).curves
        if described is None:
            return None

        def curves(direction: int, displacement: ca.SX) -> tuple[ca.SX, ca.SX] | None:
            name = DIRECTIONS[direction]
            curve, sign = getattr(described, name), self.sign_of(name)
            if curve is None:
                return None
            path = f"bushings.{point}.curves.{name}"
            load, energy = bushing_curve(self.mechanism, curve, path, sign * displacement)
            return sign * load, energy

        return curves

    def linear_bushing(self, point: str) -> dict[str, Any]:
        """Return stiffness at design, damping and axes of a bushing, for laws that take no curves."""
        described, path = self.bushing(point).curves, f"bushings.{point}"
        stiffness = self.triple(f"{path}.stiffness")
        for i, name in enumerate(DIRECTIONS[:3]):
            curve = getattr(described, name, None)
            if curve is not None:
                stiffness[i] = bushing_slope(self.mechanism, curve, f"{path}.curves.{name}")
        damping = self.triple(f"{path}.damping")
        return {"stiffness": stiffness, "damping": damping, "axes": self.bushing_axes(point)}

    def rod(
        self, name: str, inner: str, outer: str, carrier: Body, *, steered: bool = False
    ) -> None:
        """Connect a point of a carrier to a point of the chassis by a rod; a steered rod's inner end is on the rack."""
        start, end = self.hardpoint(inner), self.hardpoint(outer)
        holder = self.rack if steered else self.chassis
        self.lines[name] = (inner, outer)
        self.owners.update({inner: holder, outer: carrier})
        massless, soft = getattr(self.rig.bodies, name, None) is None, self.has_bushing(inner)
        if massless and soft:
            law = self.linear_bushing(inner)
            ends = carrier.frame.point(end) - holder.frame.point(start)
            tension, power = add_elastic_rod(
                self.mechanism, name, holder, carrier, start, end, **law
            )
            self.bushings[inner] = -tension * unit(ends.value), power
            return
        if massless:
            self.mechanism.rod(name, holder, carrier, start, end)
            return
        link = self.body(name)
        first, second = normals(unit(end - start))
        if soft:
            self.mechanism.spherical(f"{name}_outer", carrier, link, end)
            self.mechanism.perpendicular(
                f"{name}_spin", holder, link, first, second
            )  # as at the ideal joint
            self.cushion(inner, holder, link)
            return
        self.mechanism.universal(f"{name}_inner", holder, link, start, first, second)
        self.mechanism.coincident(f"{name}_outer", link, carrier, end)

    @property
    def moving_frame(self) -> Body | None:
        """The moving frame that carries the suspension; None on the ground."""
        return self.chassis if self.carrier.moves else None

    @property
    def carrier(self) -> Carrier:
        """Carrier of the suspension's axes: the ground, or the car's body."""
        return self.chassis.carrier


def hang_on_guide(mechanism: Mechanism, guide: str) -> Body:
    """Connect the car's body to its guide: fixed, free to heave, or free to heave and rotate about a joint."""
    if guide == "fixed":
        return mechanism.ground
    chassis = mechanism.body(
        "sprung", mechanism.parameter("sprung.mass"), *_sprung_inertia(guide, mechanism)
    )
    if guide == "vertical":
        mechanism.prismatic("sprung", mechanism.ground, chassis, axis=ca.SX([0.0, 0.0, 1.0]))
        return chassis
    carriage = mechanism.body("carriage")
    mechanism.prismatic("sprung", mechanism.ground, carriage, axis=ca.SX([0.0, 0.0, 1.0]))
    joint = ca.vertcat(*(mechanism.parameter(f"sprung.joint[{i}]") for i in range(3)))
    mechanism.spherical("guide_joint", carriage, chassis, at=joint)
    return chassis


def _sprung_inertia(guide: str, mechanism: Mechanism) -> tuple[ca.SX, ca.SX]:
    """Return centre of mass and inertia of the body; not needed if it only heaves."""
    if guide == "vertical":
        return ca.SX(3, 1), ca.SX(3, 3)
    number = mechanism.parameter
    centre = ca.vertcat(*(number(f"sprung.centre_of_mass[{i}]") for i in range(3)))
    xx, yy, zz, xy, xz, yz = (
        number(f"sprung.inertia.{e}") for e in ("xx", "yy", "zz", "xy", "xz", "yz")
    )
    return centre, ca.vertcat(
        ca.horzcat(xx, xy, xz), ca.horzcat(xy, yy, yz), ca.horzcat(xz, yz, zz)
    )
