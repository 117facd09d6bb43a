"""What all axles on the K&C rig are built from: bushings, joints, links, springs, wheels and the anti-roll bar."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import Any

import numpy as np

from jounce.axles.assembly import GROUND, STEP, Assembly, Law, Numbers, across, cross, length, unit
from jounce.kernel import equilibrium as eq
from jounce.parts import Corner
from jounce.parts.axles import DependentAxle
from jounce.parts.elements import AntiRollBar, CoilSpring

SIDES = ("left", "right")
LEFT = np.array([[0.0], [1.0], [0.0]])
_UP = np.array([[0.0], [0.0], [1.0]])
_GAS = np.linspace(-0.15, 0.15, 61)  # m: deflections at which a damper's force at rest is tabulated


class AxleBuilder(ABC):
    """An axle under construction: numbers by path, bodies by name, joints, links, springs and wheels of both sides.

    ``varied`` are the parameters of the columns, none for the values themselves.
    """

    def __init__(self, rig: Corner | DependentAxle, varied: Sequence[str] = ()) -> None:
        self.rig = rig
        self.values = rig.parameters()
        self.column = {path: i for i, path in enumerate(varied)}
        self.assembly = Assembly(max(1, len(varied)))
        self.bodies: dict[str, int] = {}
        self.carried: dict[str, int] = {}  # body of each hardpoint; others stay with the car's body
        self.upright: dict[str, int] = {}
        self.steering_axis: dict[str, tuple[tuple[int, Numbers], tuple[int, Numbers]]] = {}
        self.bar_tilt = (
            0.0  # rad, of the axes of a bar's halves: its law is exact for small angles then
        )
        self.side = "left"
        self.steered = False
        self.read: dict[str, None] = {}  # paths of all numbers that the axle is built from
        self._build()

    # numbers ---------------------------------------------------------------------------------------------------------

    def number(self, path: str) -> Numbers:
        """Return a parameter, shape (m,)."""
        self.read[path] = None
        out = np.full(self.assembly.columns, complex(self.values[path]))
        if path in self.column:
            out[self.column[path]] += 1j * STEP
        return out

    def vector(self, path: str) -> Numbers:
        """Return three parameters, mirrored for the side that is not the description's, shape (3, m)."""
        out = np.stack([self.number(f"{path}[{i}]") for i in range(3)])
        return np.asarray(out * self.mirror)

    @property
    def mirror(self) -> Any:
        """Signs of x, y, z, shape (3, 1)."""
        return np.array([[1.0], [1.0 if self.side == self.rig.side else -1.0], [1.0]])

    def point(self, name: str) -> Numbers:
        """Return a hardpoint; ends of spring and damper default to those of the strut."""
        element, _, end = name.partition("_")
        if element in ("spring", "damper") and getattr(self.rig.hardpoints, name) is None:
            name = f"strut_{end}"
        return self.vector(f"hardpoints.{name}")

    def has(self, name: str) -> bool:
        """Whether the description has a hardpoint."""
        return getattr(self.rig.hardpoints, name, None) is not None

    def is_soft(self, name: str) -> bool:
        """Whether there is a bushing at a hardpoint."""
        return getattr(self.rig.bushings, name, None) is not None

    # bodies ----------------------------------------------------------------------------------------------------------

    def own(self, name: str) -> int:
        """Return the body of this side with a name, added if it is new."""
        return self.shared(f"{self.side}.{name}")

    def shared(self, name: str) -> int:
        """Return a body by its whole name, added if it is new."""
        if name not in self.bodies:
            self.bodies[name] = self.assembly.body(name)
        return self.bodies[name]

    def holder(self, point: str) -> int:
        """Return the body that carries a hardpoint of the car's side: the ground or the subframe."""
        frame = self.rig.subframe
        return self.shared("subframe") if frame is not None and point in frame.carries else GROUND

    def called(self, name: str) -> str:
        """Return the name of a part of this side."""
        return f"{self.side}.{name}"

    def carry(self, body: int, *points: str) -> None:
        """Note that hardpoints of this side move with a body."""
        for point in points:
            self.carried.setdefault(self.called(point), body)

    # joints ----------------------------------------------------------------------------------------------------------

    def soft(
        self, path: str, bushing: Any, name: str, first: int, second: int, at: Numbers
    ) -> None:
        """Add a bushing of the description between two bodies."""
        six = [self.number(f"{path}.stiffness[{i}]") for i in range(3)]
        six += [self.number(f"{path}.rotational_stiffness[{i}]") for i in range(3)]
        zero = 0.0 * six[0]
        preload = [zero] * 6
        for first_row, key in ((0, "preload"), (3, "rotational_preload")):
            if getattr(bushing, key) is not None:
                for i in range(3):
                    preload[first_row + i] = self.number(f"{path}.{key}[{i}]")
        laws = tuple(None if curve is None else _law(curve) for curve in bushing.curve_of_each)
        # One set of axes is the mirror image of the other: what holds along them holds on both sides.
        axes = (bushing.axes.T[:, :, None] + 0.0j) * self.mirror[None]
        slip, hold = bushing.slip_loads, bushing.slip_stiffnesses
        self.assembly.bushing(
            name,
            first,
            second,
            at,
            stiffness=np.stack(six),
            axes=np.broadcast_to(axes, (3, 3, self.assembly.columns)),
            preload=np.stack(preload),
            slip=slip[:, None],
            hold=hold[:, None],
            laws=laws,
        )

    def joint(self, point: str, first: int, second: int) -> None:
        """Join two bodies at a hardpoint by its bushing, or by a ball joint."""
        at, name = self.point(point), self.called(point)
        self.carry(second, point)
        if self.is_soft(point):
            bushing = getattr(self.rig.bushings, point)
            self.soft(f"bushings.{point}", bushing, name, first, second, at)
        else:
            self.assembly.ball(name, first, second, at)

    def turning(self, name: str, body: int, ends: tuple[str, str]) -> None:
        """Let an arm turn about its axis: a hinge between ideal ends, bushings and a ball joint otherwise."""
        soft = [end for end in ends if self.is_soft(end)]
        self.carry(body, *ends)
        if soft:
            for end in ends:
                self.joint(end, self.holder(end), body)
            return
        holders = self.holder(ends[0]), self.holder(ends[1])
        self.assembly.hinge(
            self.called(name), holders, body, (self.point(ends[0]), self.point(ends[1]))
        )

    def rod(self, name: str, ends: tuple[str, str], bodies: tuple[int, int]) -> None:
        """Connect two hardpoints of two bodies by a link, with the bushings and the stiffness that it has."""
        points, label = (self.point(ends[0]), self.point(ends[1])), self.called(name)
        link = getattr(self.rig.links, name, None)
        soft = [self.is_soft(end) for end in ends]
        for end, body in zip(ends, bodies, strict=True):
            self.carry(body, end)
        rate = None if link is None else self.number(f"links.{name}.stiffness")
        if not any(soft) and name not in self._loaded:
            if rate is None:
                self.assembly.distance(label, *bodies, points)
            else:
                self.assembly.line(label, *bodies, points, rate=rate)
            return
        inner = self.own(name)
        outer = inner
        if rate is not None:  # two halves that slide in each other against a spring
            outer = self.own(f"{name}.outer")
            self.assembly.slide(label, inner, outer, points[0], points[1] - points[0])
            self.assembly.line(label, inner, outer, points, rate=rate)
        self.joint(ends[0], bodies[0], inner)
        self.joint(ends[1], outer, bodies[1])
        if not any(self._holds_turns(end) for end in ends):
            one, other = across(points[1] - points[0])  # as the universal joint of a run has them
            self.assembly.align(f"{label}.turn", bodies[0], inner, other, one)

    @property
    def _loaded(self) -> set[str]:
        """Bodies that carry a strut or an anti-roll bar's link."""
        rig = self.rig
        bars = [part.on for part in (rig.anti_roll_bar, rig.third_spring) if part is not None]
        return {rig.strut.on, getattr(rig.strut, "pushrod_on", "upright"), *bars}

    def _holds_turns(self, end: str) -> bool:
        return self.is_soft(end) and bool(
            np.all(getattr(self.rig.bushings, end).tangents[3:] > 0.0)
        )

    def eye(self, point: str, body: int) -> int:
        """Return the body to which an end of spring or damper is attached: a bushing's eye, or the body itself.

        The force along the line has no moment about the eye, which therefore only shifts on its bushing.
        """
        guides = getattr(self.rig, "model", "") == "mcpherson" and point == "strut_top"
        if guides or not self.is_soft(point):  # the top mount of a McPherson strut is its joint
            return body
        name = self.called(f"{point}.eye")
        if name in self.bodies:
            return self.bodies[name]
        eye = self.shared(name)
        bushing = getattr(self.rig.bushings, point)
        self.soft(f"bushings.{point}", bushing, self.called(point), body, eye, self.point(point))
        self.assembly.parallel(self.called(f"{point}.eye"), body, eye)
        return eye

    @abstractmethod
    def _build(self) -> None:
        """Add all bodies and elements."""

    # parts of every axle ---------------------------------------------------------------------------------------------

    @abstractmethod
    def carrier(self, name: str) -> int:
        """Return the body of this side with a name used in descriptions."""

    def add_strut(self) -> None:
        """Add spring, stops, gas and friction between the ends of the strut."""
        rig = self.rig
        if not rig.has_strut:
            return
        on, strut = self.carrier(rig.strut.on), rig.strut
        spring, damper = (self._ends(element, on) for element in ("spring", "damper"))
        points = self.point("spring_bottom"), self.point("spring_top")
        if "spring" not in rig.without:
            self._add_coil(self.called("spring"), strut.spring, "strut.spring", spring, points)
        for name, sign in (("bump_stop", 1.0), ("rebound_stop", -1.0)):
            stop = getattr(strut, name)
            if stop is not None:
                gap = Law(eq.STOP, (stop.gap, stop.rate, stop.progression), 3)
                self.assembly.line(self.called(name), *spring, points, sign=sign, law=gap)
        self._add_damper(damper)

    def _ends(self, element: str, on: int) -> tuple[int, int]:
        """Return the bodies at the lower and upper end of spring or damper."""
        lower, upper = (
            f"{element}_{end}" if self.has(f"{element}_{end}") else f"strut_{end}"
            for end in ("bottom", "top")
        )
        eyes = self.eye(lower, on), self.eye(upper, self.holder(upper))
        for end, body in zip((lower, upper), eyes, strict=True):
            self.carry(body, end)
        return eyes

    def _add_damper(self, at: tuple[int, int]) -> None:
        """Add what the damper does at rest, and the friction along it."""
        points = self.point("damper_bottom"), self.point("damper_top")
        strut = self.rig.strut
        design = float(length(points[1] - points[0])[0].real)
        forces = [strut.damper.at_length(design - d).at_rest(float(d))[0] for d in _GAS]
        if "damper" not in self.rig.without and any(forces):
            law = Law(eq.TABLE, (*_GAS, *forces), len(_GAS))
            self.assembly.line(self.called("damper"), *at, points, law=law)
        friction = strut.friction
        if friction is not None and friction.force > 0.0:
            travel = friction.presliding_distance or 1e-4
            self.assembly.line(
                self.called("friction"),
                *at,
                points,
                slip=friction.force,
                hold=friction.force / travel,
            )

    def add_wheel(self) -> None:
        """Add the wheel of this side, on its bearing if that yields."""
        camber, toe = self.number("wheel.camber"), self.number("wheel.toe")
        outward = 1.0 if self.side == "left" else -1.0
        axis = np.stack(
            [
                np.sin(toe) * np.cos(camber),
                outward * np.cos(toe) * np.cos(camber),
                -np.sin(camber),
            ]
        )
        body, centre = self.upright[self.side], self.point("wheel_centre")
        self.carry(body, "wheel_centre")
        bearing = self.rig.bearing
        if bearing is not None:
            body = self._add_bearing(bearing, body, centre, axis)
        self.assembly.wheel(self.called("contact"), body, centre, axis, self.number("wheel.radius"))

    def _add_bearing(self, bearing: Any, upright: int, centre: Numbers, axis: Numbers) -> int:
        """Add the wheel on its bearing; what has no stiffness is rigid."""
        wheel, label = self.own("wheel"), self.called("bearing")
        up = unit(_UP - axis * axis[2])
        ahead = cross(axis, up) * (1.0 if self.side == "left" else -1.0)
        zero = 0.0 * axis[0]
        six = [zero] * 6
        for first, key in ((0, "stiffness"), (3, "rotational_stiffness")):
            if getattr(bearing, key) is not None:
                for i in range(3):
                    if (first, i) != (3, 1):  # the wheel's spin is held
                        six[first + i] = self.number(f"bearing.{key}[{i}]")
        # On both sides outward: one is the mirror image of the other.
        axes = np.stack([ahead, axis, up])
        self.assembly.bushing(label, upright, wheel, centre, stiffness=np.stack(six), axes=axes)
        if bearing.stiffness is None:
            self.assembly.ball(label, upright, wheel, centre)
        if bearing.rotational_stiffness is None:
            self.assembly.parallel(label, upright, wheel)
        else:
            self.assembly.align(f"{label}.spin", upright, wheel, ahead, up)
        return wheel

    def add_bar(self) -> None:
        """Add the anti-roll bar: two halves about their axes and a link on each side, or the stem of a T-bar."""
        bar = self.rig.anti_roll_bar
        if bar is None:
            return
        if bar.kind == "t":
            self._add_stem(bar)
            return
        halves, tilt = [], 1.0 + 0.0 * self.number("anti_roll_bar.stiffness")
        for side in SIDES:
            self.side = side
            half, pivot = self.own("arb"), self.point("arb_pivot")
            self.carry(half, "arb_pivot", "arb_axis")
            axis, holder = self._bar_axis(pivot), self.holder("arb_pivot")
            if self.is_soft("arb_pivot"):
                self.joint("arb_pivot", holder, half)
            else:
                self.assembly.hinge(
                    self.called("arb"), (holder, holder), half, (pivot, pivot + 0.1 * axis)
                )
                tilt = axis[1]
                self.bar_tilt = float(np.arccos(min(axis[1, 0].real, 1.0)))
            self.rod("arb_link", ("arb_arm_end", "arb_link_end"), (half, self.carrier(bar.on)))
            halves.append(half)
        left, right = halves
        middle = self.point("arb_pivot") * np.array([[1.0], [0.0], [1.0]])
        if self.is_soft("arb_pivot"):
            self.assembly.hinge("arb", (left, left), right, (middle, middle + 0.1 * LEFT))
        # The twist of halves on tilted axes is seen across the car: smaller by the cosine of the tilt, as its torque.
        stiffness = self._bar_stiffness() / tilt**2
        across = LEFT + 0.0 * middle
        if bar.kind == "z":  # (a + b)^2 = 2 a^2 + 2 b^2 - (a - b)^2
            holder = self.holder("arb_pivot")
            for side, half in zip(SIDES, halves, strict=True):
                self.assembly.twist(f"_{side}.arb", holder, half, across, 2.0 * stiffness)
            stiffness = -stiffness
        self.assembly.twist("_arb" if bar.kind == "z" else "arb", left, right, across, stiffness)

    def _bar_axis(self, pivot: Numbers) -> Numbers:
        """Return the axis of this side's half, pointing to the left."""
        if not self.has("arb_axis"):
            return LEFT + 0.0 * pivot
        axis = unit(self.point("arb_axis") - pivot)
        return np.asarray(axis * np.sign(axis[1].real))

    def _add_stem(self, bar: AntiRollBar) -> None:
        """Add a T-bar: a stem on a hinge across the car, twisted by the crossbar at its other end."""
        self.side = self.rig.side
        pivot, end = self.point("arb_pivot"), self.point("arb_axis")
        stem, crossbar, holder = (
            self.shared("arb_stem"),
            self.shared("arb"),
            self.holder("arb_pivot"),
        )
        if self.is_soft("arb_pivot"):
            self.joint("arb_pivot", holder, stem)
        else:
            hinge = pivot, pivot + 0.1 * LEFT
            self.assembly.hinge("arb_stem", (holder, holder), stem, hinge)
        self.assembly.hinge("arb", (stem, stem), crossbar, (pivot, end))
        for side in SIDES:
            self.side = side
            self.carry(stem, "arb_pivot", "arb_axis")
            ends = "arb_arm_end", "arb_link_end"
            self.rod("arb_link", ends, (crossbar, self.carrier(bar.on)))
        self.assembly.twist("arb", stem, crossbar, end - pivot, self._bar_stiffness())

    def add_third_spring(self) -> None:
        """Add the third spring and the force of its damper at rest between both sides."""
        third = self.rig.third_spring
        if third is None:
            return
        bodies, points = [], []
        for side in SIDES:
            self.side = side
            bodies.append(self.carrier(third.on))
            points.append(self.point("third_spring_end"))
            self.carry(bodies[-1], "third_spring_end")
        left, right = bodies
        self._add_coil(
            "third_spring",
            third.spring,
            "third_spring.spring",
            (left, right),
            (points[0], points[1]),
        )
        if third.damper is not None:
            forces = [third.damper.at_rest(float(d))[0] for d in _GAS]
            if any(forces):
                law = Law(eq.TABLE, (*_GAS, *forces), len(_GAS))
                self.assembly.line("third_damper", left, right, (points[0], points[1]), law=law)

    def _add_coil(
        self,
        name: str,
        law: CoilSpring,
        path: str,
        bodies: tuple[int, int],
        points: tuple[Numbers, Numbers],
    ) -> None:
        design = length(points[1] - points[0])
        self.assembly.line(
            name,
            *bodies,
            points,
            rate=0.0 if law.rate is None else self.number(f"{path}.rate"),
            zero=design if law.free_length is None else self.number(f"{path}.free_length"),
            preload=0.0 if law.preload is None else self.number(f"{path}.preload"),
            law=None if law.curve is None else _law(law.curve),
        )

    def _bar_stiffness(self) -> Numbers:
        """Return the stiffness of the bar with its blades in series, N m/rad of twist."""
        stiffness, bar = self.number("anti_roll_bar.stiffness"), self.rig.anti_roll_bar
        if bar is None or bar.blade is None:
            return stiffness
        width, thickness, angle, modulus = (
            self.number(f"anti_roll_bar.blade.{name}")
            for name in ("width", "thickness", "angle", "youngs_modulus")
        )
        pivot = self.point("arb_pivot")
        arm, axis = self.point("arb_arm_end") - pivot, self._bar_axis(pivot)
        if bar.kind == "t":
            axis = unit(self.point("arb_axis") - pivot)
        out = arm - axis * np.sum(axis * arm, axis=0)
        flat, edge = width * thickness**3 / 12.0, thickness * width**3 / 12.0
        bent = np.cos(angle) ** 2 / flat + np.sin(angle) ** 2 / edge
        count = 0.5 if bar.kind == "t" else 2.0  # arms that bend for its twist
        return np.asarray(1.0 / (1.0 / stiffness + count * length(out) / (3.0 * modulus) * bent))


def _law(curve: Any) -> Law:
    """Return a curve of a description as a law."""
    if curve.kind == "polynomial":
        return Law(eq.POLYNOMIAL, tuple(curve.coefficients), len(curve.coefficients))
    if curve.kind == "power":
        return Law(eq.POWER, (curve.coefficient, curve.exponent), 2)
    if hasattr(curve, "deflection"):
        return Law(eq.TABLE, (*curve.deflection, *curve.force), len(curve.deflection))
    return Law(eq.TABLE, (*curve.angle, *curve.torque), len(curve.angle))
