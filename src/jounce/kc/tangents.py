"""Slopes of the equilibria of a K&C test by parameters of the description: motions, forces and all quantities.

The kernel gives the slopes at given targets and slipped deflections. Targets depend on the parameters, too (the height
and the load at which a test begins), and so does friction that has slipped. Their effects are further columns of the
same solution: wheels on the ground whose height moves the targets, and forces in place of friction.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from jounce.axles.assembly import GROUND, STEP, Element, Numbers
from jounce.axles.builder import SIDES
from jounce.axles.dependent import build_axle
from jounce.axles.wheels import caster_of, wheel_quantities
from jounce.core.types import Array
from jounce.kc.laboratory import Handwheel, Held, Laboratory
from jounce.kc.tests import KCTest
from jounce.kernel import equilibrium as eq
from jounce.kinematics.column import handwheel_angle, pinion_angle, pinion_curvature
from jounce.parts.elements import Steering

_FORCE_ROW = 1e-6  # m/N: weight of a height in a row of forces; the kernel weighs heights in N/m by its inverse
_SMALL = 1e-4  # rad: rotation below which a series is exact
DIRECTIONS = ("force_x", "force_y", "force_z", "torque_x", "torque_y", "torque_z")


@dataclass(frozen=True)
class Tangent:
    """Equilibria along a path, with slopes by parameters.

    ``motions`` (steps, bodies, 6, m) are displacements and rotations of bodies about the ground's origin, ``rows``
    (steps, n, m) the slopes of multipliers and forces of controls, ``slips`` (steps, frictions, m) those of slipped
    deflections; ``sticks`` (steps, frictions) says which frictions stick.
    """

    settled: eq.Settled
    motions: Array
    rows: Array
    slips: Array
    sticks: Array

    @property
    def places(self) -> Array:
        """Poses, shape (steps, bodies, 12)."""
        return self.settled.poses.reshape(len(self.settled.poses), -1, 12)

    def point(self, body: int, point: Numbers) -> Numbers:
        """Return a point of the design (3, m) moved with a body, shape (steps, m, 3)."""
        return self._moved(body, point, 1.0)

    def direction(self, body: int, direction: Numbers) -> Numbers:
        """Return a direction of the design (3, m) turned with a body, shape (steps, m, 3)."""
        return self._moved(body, direction, 0.0)

    def _moved(self, body: int, vector: Numbers, is_point: float) -> Numbers:
        own = vector.T
        if body == GROUND:
            return np.broadcast_to(own, (len(self.motions), *own.shape))
        pose, motion = self.places[:, body], self.motions[:, body].transpose(0, 2, 1)
        rotation = pose[:, 3:].reshape(-1, 3, 3)
        now = own[0].real @ rotation.transpose(0, 2, 1) + is_point * pose[:, :3]
        slope = own.imag @ rotation.transpose(0, 2, 1)
        slope = slope + STEP * (
            is_point * motion[..., :3] + _turned_by(motion[..., 3:], now[:, None])
        )
        return np.asarray(now[:, None] + 1j * slope)

    def at(self, places: Array) -> Tangent:
        """Return the steps at given places."""
        settled = self.settled._replace(
            **{name: getattr(self.settled, name)[places] for name in SETTLED}
        )
        return Tangent(settled, *(getattr(self, name)[places] for name in _SLOPES))

    def joined(self, other: Tangent) -> Tangent:
        """Return these steps followed by others."""
        settled = self.settled._replace(
            **{
                name: np.concatenate([getattr(self.settled, name), getattr(other.settled, name)])
                for name in SETTLED
            }
        )
        both = [(getattr(self, name), getattr(other, name)) for name in _SLOPES]
        return Tangent(settled, *(np.concatenate(pair) for pair in both))


SETTLED = ("poses", "multipliers", "forces", "outcome")
_SLOPES = ("motions", "rows", "slips", "sticks")


class Tangents:
    """A laboratory whose axle depends on parameters."""

    def __init__(self, laboratory: Laboratory, parameters: Sequence[str]) -> None:
        self.laboratory, self.count = laboratory, len(parameters)
        self.parameters = tuple(parameters)
        self.axle = build_axle(laboratory.rig, parameters)
        assembly, controls = self.axle.assembly, len(laboratory.controls)
        self.frictions = [
            (i, k)
            for i, element in enumerate(assembly.elements)
            for k, hold in enumerate(_holds(element))
            if hold > 0.0
        ]
        self._arrays = self._extended(laboratory.arrays, controls)
        own = assembly.seeds()
        rubbing = {i for i, _ in self.frictions if assembly.elements[i].kind == eq.LINE}
        own.changes[np.isin(own.places[:, 0], list(rubbing)), eq.LENGTH] = 0.0  # only laws have it
        places, changes = [own.places], [own.changes]
        for j in range(controls):
            height = np.zeros((1, eq.WIDTH))
            height[0, 2] = 1.0
            places.append(np.array([[-1 - len(SIDES) - j, self.count + j]]))
            changes.append(height)
        for j, (i, k) in enumerate(self.frictions):
            change = np.zeros((1, eq.WIDTH))
            is_line = assembly.elements[i].kind == eq.LINE
            change[0, eq.PRELOAD if is_line else eq.F + k] = 1.0
            places.append(np.array([[i, self.count + controls + j]]))
            changes.append(change)
        self._seeds = eq.Seeds(np.concatenate(places), np.concatenate(changes))
        self.design = np.stack(
            [_height(wheel.centre, wheel.axis, wheel.radius) for wheel in assembly.wheels]
        )
        self._begin()

    @staticmethod
    def _extended(arrays: eq.Assembly, controls: int) -> eq.Assembly:
        """Add a wheel on the ground for each control."""
        wheels = np.zeros((controls, eq.WHEEL))
        wheels[:, 4] = 1.0
        first = len(arrays.carriers)
        added = np.array([[0, first + j] for j in range(controls)], dtype=np.int64)
        return arrays._replace(
            carriers=np.concatenate([arrays.carriers, np.full(controls, GROUND)]),
            wheels=np.concatenate([arrays.wheels, wheels]),
            controls=np.concatenate([arrays.controls, added.reshape(-1, 2)]),
        )

    def _begin(self) -> None:
        """Find the slopes of the state in which tests begin."""
        laboratory, state = self.laboratory, self.laboratory.state
        design = np.array([float(row[0].real) for row in self.design])
        path = laboratory.approach(state.heights - design, state.rack)
        targets = np.zeros((len(path.targets), len(laboratory.controls), self.count))
        at = self._contacts()
        targets[:, at] = (self.design.imag / STEP)[None]
        slips = np.zeros((len(self.frictions), self.count))
        for j, (i, _) in enumerate(self.frictions):
            if laboratory.axle.assembly.elements[i].kind == eq.LINE:
                data = self.axle.assembly.elements[i].data
                reach = data[eq.Q : eq.Q + 3] - data[eq.P : eq.P + 3]
                slips[j] = np.sqrt((reach * reach).sum(axis=0)).imag / STEP
        tangent = self.follow(path, targets, laboratory.at_design(), slips)
        self.heights = targets[-1, at]
        self.slips = tangent.slips[-1]
        self.forces = tangent.rows[-1, laboratory.multipliers :]

    def _contacts(self) -> list[int]:
        return [self.laboratory.controls.index(f"{side}.contact") for side in SIDES]

    # tests -----------------------------------------------------------------------------------------------------------

    def run(
        self, test: KCTest, inputs: Array, held: Held, handwheel: Handwheel, trail: float
    ) -> tuple[Tangent, NDArray[np.int_]]:
        """Follow a test with slopes; return its steps, and which of them each sample is.

        Without friction, each input is settled once; with it, the second of two loops is kept, as in `Laboratory.run`.
        """
        if self.frictions:
            twice = np.concatenate([inputs, inputs])
            tangent = self._follow_test(test, twice, held, handwheel, trail)
            return tangent, len(inputs) + np.arange(len(inputs))
        reached = np.unique(np.round(inputs, 15))
        ahead, back = reached[reached > 0.0], reached[reached < 0.0][::-1]
        branches = [np.append(0.0, branch) for branch in (ahead, back)]  # each from the start
        parts = [self._follow_test(test, branch, held, handwheel, trail) for branch in branches]
        away = np.abs(np.concatenate(branches) - inputs[:, None])
        whole = parts[0].joined(parts[1])
        return whole, np.argmin(away, axis=1)

    def _follow_test(
        self, test: KCTest, inputs: Array, held: Held, handwheel: Handwheel, trail: float
    ) -> Tangent:
        laboratory = self.laboratory
        path = laboratory.path(test, inputs, held, handwheel, trail)
        targets = np.zeros((len(inputs), len(laboratory.controls), self.count))
        left, right = at = self._contacts()
        targets[:, at] = self.heights
        if self.axle.steered and handwheel == "free" and test.kind != "rack":
            rack = laboratory.controls.index("rack")
            targets[:, rack] = self.forces[rack]
        if test.kind == "roll":
            wide = (self.axle.assembly.wheels[0].centre - self.axle.assembly.wheels[1].centre)[1]
            change = wide.imag / STEP
            targets[:, left] = self.heights[0] - self.heights[1] + np.tan(inputs)[:, None] * change
            targets[:, right] = self.forces[left] + self.forces[right]
        elif test.kind != "heights" and held == "load":
            targets[:, at] = self.forces[at]
        return self.follow(path, targets, laboratory.state.start, self.slips)

    # equilibria ------------------------------------------------------------------------------------------------------

    def follow(
        self,
        path: eq.Path,
        targets: Array,
        start: tuple[Array, Array, Array],
        slips: Array,
    ) -> Tangent:
        """Follow a path whose targets have slopes (steps, controls, m), from a start with slopes of what slipped."""
        laboratory, steps = self.laboratory, len(path.targets)
        columns = self.count + len(laboratory.controls) + len(self.frictions)
        path, begin = self._with_ground(path), self._start(start)
        if self.frictions:
            settled, raw, sticks = self._rubbed(path, begin, columns)
        else:
            settled, _ = eq.settle(
                self._arrays, path, self._seeds, laboratory.bodies, laboratory.multipliers,
                columns, begin,
            )  # fmt: skip
            raw = settled.slopes
            raw[settled.outcome != eq.SETTLED] = np.nan
            sticks = np.zeros((steps, 0), dtype=bool)
        m, controls = self.count, len(laboratory.controls)
        total = raw[:, :, :m] - raw[:, :, m : m + controls] @ targets
        history = np.zeros((steps, len(self.frictions), m))
        last = 6 * laboratory.bodies
        rows = slice(last, last + laboratory.multipliers + controls)
        holds = np.array([self._hold(j) for j in range(len(self.frictions))])

        def tangent(part: slice) -> Tangent:
            motions = total[part, :last].reshape(-1, laboratory.bodies, 6, m)
            own = settled._replace(**{name: getattr(settled, name)[part] for name in SETTLED})
            return Tangent(own, motions, total[part, rows], history[part], sticks[part])

        if (
            self.frictions
        ):  # deflections are linear in motions, so that only sums are left to do step by step
            moved = self._deflections(tangent(slice(None)), self._elements).imag / STEP
            pushed = self._by_forces(settled, raw[:, :, m + controls :])
            for step in range(steps):
                held = np.where(sticks[step], holds, 0.0)[:, None] * slips
                total[step] += raw[step, :, m + controls :] @ held
                moves = moved[step] + pushed[step] @ held
                slips = np.where(sticks[step][:, None], slips, moves)
                history[step] = slips
        return tangent(slice(None))

    def _start(self, start: tuple[Array, Array, Array]) -> tuple[Array, Array, Array]:
        pose, multipliers, slipped = start
        added = np.zeros(len(self.laboratory.controls))
        return pose, np.concatenate([multipliers, added]), slipped

    def _with_ground(self, path: eq.Path) -> eq.Path:
        """Add the wheels on the ground: each moves the target of one control."""
        steps, n = path.targets.shape
        values, forces = (part.reshape(steps, n, n) for part in (path.values, path.forces))
        is_force = ~values.any(axis=2)
        weight = np.where(is_force, _FORCE_ROW, 1.0)
        more_values, more_forces = np.zeros((2, steps, 2 * n, 2 * n))
        more_values[:, :n, :n], more_forces[:, :n, :n] = values, forces
        own = np.arange(n)
        more_values[:, own, n + own] = weight
        more_forces[:, n + own, n + own] = 1.0
        targets = np.concatenate([weight * path.targets, np.zeros((steps, n))], axis=1)
        loads = np.concatenate([path.loads, np.zeros((steps, n * eq.LOADS))], axis=1)
        return eq.Path(
            more_values.reshape(steps, -1), more_forces.reshape(steps, -1), targets, loads
        )

    # friction --------------------------------------------------------------------------------------------------------

    def _hold(self, j: int) -> float:
        i, k = self.frictions[j]
        return _holds(self.axle.assembly.elements[i])[k]

    @property
    def _elements(self) -> dict[int, Element]:
        """Elements with friction, by their place."""
        return {i: self.axle.assembly.elements[i] for i, _ in self.frictions}

    def _deflections(self, tangent: Tangent, elements: Mapping[int, Element]) -> Numbers:
        """Return the deflections of all frictions, shape (steps, frictions, m)."""
        moves = {
            i: [line_length(element, tangent)]
            if element.kind == eq.LINE
            else bushing_deflections(element, tangent)
            for i, element in elements.items()
        }
        return np.stack([moves[i][k] for i, k in self.frictions], axis=1)

    def _by_forces(self, settled: eq.Settled, raw: Array) -> Array:
        """Return the change of all deflections by a force in each friction, shape (steps, frictions, frictions)."""
        steps, bodies, count = len(raw), self.laboratory.bodies, len(self.frictions)
        empty = np.zeros((steps, 0, 0))
        motions = raw[:, : 6 * bodies].reshape(steps, bodies, 6, count)
        pushed = Tangent(settled, motions, empty, empty, np.zeros((steps, 0)))
        fixed = {
            i: replace(element, data=np.repeat(element.data[:, :1].real, count, axis=1))
            for i, element in self._elements.items()
        }
        return np.asarray(self._deflections(pushed, fixed).imag / STEP)

    def _rubbed(
        self, path: eq.Path, start: tuple[Array, Array, Array], columns: int
    ) -> tuple[eq.Settled, Array, Array]:
        """Follow a path with friction, then find slopes at each step with friction that slips as a force."""
        laboratory, steps = self.laboratory, len(path.targets)
        none = eq.Seeds(np.zeros((0, 2), dtype=np.int64), np.zeros((0, eq.WIDTH)))
        size = laboratory.bodies, laboratory.multipliers
        settled, _ = eq.settle(self._arrays, path, none, *size, 0, start)
        empty = np.zeros((steps, 0, 0))
        resting = np.zeros((steps, laboratory.bodies, 6, self.count))
        path_taken = Tangent(settled, resting, empty, empty, np.zeros((steps, 0)))
        moves = self._deflections(path_taken, self._elements)[..., 0].real
        slipped = start[2].copy()
        sticks = np.zeros((steps, len(self.frictions)), dtype=bool)
        raw = np.full((steps, settled.multipliers.shape[1] + 6 * size[0], columns), np.nan)
        for step in np.flatnonzero(settled.outcome == eq.SETTLED):
            data = self._arrays.data.copy()
            for j, (i, k) in enumerate(self.frictions):
                is_line = self.axle.assembly.elements[i].kind == eq.LINE
                load = data[i, eq.SLIP if is_line else eq.S + k]
                apart = moves[step, j] - slipped[i, k]
                sticks[step, j] = abs(apart) * self._hold(j) < load
                if not sticks[step, j]:
                    sign = np.copysign(1.0, apart)
                    data[i, eq.PRELOAD if is_line else eq.F + k] -= sign * load
                    data[i, eq.HOLD if is_line else eq.B + k] = 0.0
                    slipped[i, k] = moves[step, j] - sign * load / self._hold(j)
            here = eq.Path(*(part[step : step + 1] for part in path))
            begin = path_taken.places[step].copy(), settled.multipliers[step].copy(), slipped.copy()
            at, _ = eq.settle(
                self._arrays._replace(data=data), here, self._seeds, *size, columns, begin
            )
            raw[step] = at.slopes[0]
        return settled, raw, sticks

    # quantities ------------------------------------------------------------------------------------------------------

    def slopes(self, tangent: Tangent, wanted: Sequence[str] | None = None) -> dict[str, Array]:
        """Return the slopes of quantities by parameters, shape (steps, m); of all or those wanted."""
        assembly, laboratory = self.axle.assembly, self.laboratory
        out: dict[str, Array] = {}
        for k, side in enumerate(SIDES):
            out |= {f"{side}.{name}": rows for name, rows in self._wheel(k, tangent).items()}
            if side in self.axle.steering_axis:
                ends = [tangent.point(body, point) for body, point in self.axle.steering_axis[side]]
                out[f"{side}.caster"] = caster_of(*ends).imag / STEP
            contact = laboratory.multipliers + laboratory.controls.index(f"{side}.contact")
            out[f"{side}.vertical_force"] = tangent.rows[:, contact]
            none = np.zeros(tangent.rows[:, contact].shape)
            for name in ("longitudinal_force", "lateral_force", "aligning_moment"):
                out[f"{side}.{name}"] = none
        if self.axle.steered:
            out |= self._rack(tangent)
        wanted_elements = {name.rpartition(".")[0] for name in wanted or ()}
        for i, element in enumerate(assembly.elements):
            if wanted is None or element.name in wanted_elements:
                out |= self._element(i, element, tangent)
        return out if wanted is None else {name: out[name] for name in wanted if name in out}

    def _wheel(self, k: int, tangent: Tangent) -> dict[str, Array]:
        """Return slopes of angles and displacements: by motions of the wheel's body and by its own numbers."""
        wheel = self.axle.assembly.wheels[k]
        pose = tangent.places[:, wheel.body]
        own = np.concatenate([wheel.centre, wheel.axis, np.atleast_2d(wheel.radius)])
        moves = np.zeros((len(pose), 1, 6, 13))
        moves[:, 0, :, :6] = np.eye(6)
        one = _posed(pose, moves[:, 0])
        numbers = own[:, 0].real + 1j * STEP * np.vstack([np.zeros((6, 7)), np.eye(7)])
        sign = 1.0 if k == 0 else -1.0
        parts = wheel_quantities(one, numbers[:, :3], numbers[:, 3:6], numbers[:, 6], sign)
        changes = np.concatenate(
            [
                tangent.motions[:, wheel.body],
                np.broadcast_to(own.imag / STEP, (len(pose), *own.shape)),
            ],
            axis=1,
        )
        slopes = np.stack([np.broadcast_to(part.imag, one.shape[:2]) for part in parts.values()])
        return dict(
            zip(
                parts, np.einsum("qsk,skm->qsm", slopes / STEP, changes, optimize=True), strict=True
            )
        )

    def _rack(self, tangent: Tangent) -> dict[str, Array]:
        element = next(e for e in self.axle.assembly.elements if e.is_control)
        place = self.laboratory.multipliers + self.laboratory.controls.index("rack")
        own = {
            "rack_travel": self._travel(element, self.axle.bodies["rack"], tangent).imag / STEP,
            "rack_force": tangent.rows[:, place],
        }
        steering = getattr(self.laboratory.rig, "steering", None)
        if steering is None or steering.rack_ratio is None:
            return own
        driven = self._travel(element, element.second, tangent)
        force = tangent.settled.multipliers[:, place]
        return own | self._handwheel(steering, driven, force, own["rack_force"])

    def _travel(self, element: Element, body: int, tangent: Tangent) -> Numbers:
        """Return the travel of a body along a control's line in the axes of its first body, shape (steps, m)."""
        at, along = element.data[:3], element.data[eq.ALONG : eq.ALONG + 3]
        apart = tangent.point(body, at) - tangent.point(element.first, at)
        return np.asarray((apart * tangent.direction(element.first, along)).sum(axis=-1))

    def _handwheel(
        self, steering: Steering, driven: Numbers, force: Array, force_slope: Array
    ) -> dict[str, Array]:
        """Return slopes of its angle and torque, for a travel of what it drives and a force on it."""
        assert steering.rack_ratio is not None
        ratio, share = steering.rack_ratio, 1.0 / (1.0 + (steering.assistance or 0.0))
        own = [
            np.array([float(path == f"steering.{name}") for path in self.parameters])
            for name in ("rack_ratio", "assistance")
        ]
        travel = driven[:, :1].real
        reached = np.where(np.isfinite(travel), travel, 0.0)
        angle = handwheel_angle(steering, reached)
        gear, bent = pinion_angle(steering, angle)[1], pinion_curvature(steering, angle)
        turned = (driven.imag / STEP - travel / ratio * own[0]) / (ratio * gear)
        carried = force_slope - share * force[:, None] * own[1]
        torque = carried * ratio * gear + force[:, None] * (own[0] * gear + ratio * bent * turned)
        return {"handwheel_angle": turned, "handwheel_torque": share * torque}

    def _element(self, i: int, element: Element, tangent: Tangent) -> dict[str, Array]:
        name, data = element.name, element.data
        if element.kind == eq.LINE:
            long = line_length(element, tangent)
            sign, law = data[eq.SIGN], element.laws[0]
            away = sign * (data[eq.LENGTH] - long)
            force = data[eq.PRELOAD] + sign * self._by_law(
                law, away, data[eq.RATE], data[eq.FACTOR]
            )
            slope = force.imag / STEP + self._dry(i, 0, long, tangent)
            return {f"{name}.force": slope, f"{name}.length": long.imag / STEP}
        if element.kind == eq.TWIST:
            angle = twist_angle(element, tangent)
            torque = data[eq.RATE] * (angle - data[eq.LENGTH]) - data[eq.PRELOAD]
            return {
                f"{name}.torque": torque.imag / STEP,
                f"{name}.twist": (angle - data[eq.LENGTH]).imag / STEP,
            }
        if element.kind == eq.DISTANCE:
            row = self.axle.assembly.order()[i]
            return {f"{name}.force": tangent.rows[:, row]}
        if element.kind != eq.BUSHING:
            return {}
        out = {}
        for k, move in enumerate(bushing_deflections(element, tangent)):
            bare = self._by_law(element.laws[k], move, data[eq.K + k], data[eq.C + k])
            slope = (data[eq.F + k] - bare).imag / STEP + self._dry(i, k, move, tangent)
            out[f"{name}.{DIRECTIONS[k]}"] = slope
        return out

    def _dry(self, i: int, k: int, move: Numbers, tangent: Tangent) -> Array:
        """Return the slope of friction: of a spring while it sticks, else none."""
        if (i, k) not in self.frictions:
            return np.zeros(move.shape)
        j = self.frictions.index((i, k))
        held = -self._hold(j) * (move.imag / STEP - tangent.slips[:, j])
        return np.where(tangent.sticks[:, j, None], held, 0.0)

    @staticmethod
    def _by_law(law: object, x: Numbers, linear: Numbers, factor: Numbers) -> Numbers:
        """Return a law's force with its slope; values of curves are left out, as only slopes are wanted."""
        if law is None:
            return np.asarray(linear * x)
        return np.asarray(1j * factor.real * law_slope(law, x.real) * x.imag)


def law_slope(law: object, x: Array) -> Array:
    """Return the slope of a law at deflections, in its unit of force over that of deflection."""
    numbers = np.array(law.numbers)  # type: ignore[attr-defined]
    kind, count = law.kind, law.count  # type: ignore[attr-defined]
    if kind == eq.POLYNOMIAL:
        powers = np.arange(1, count + 1)
        return np.asarray((numbers * powers * x[..., None] ** (powers - 1)).sum(axis=-1))
    if kind == eq.POWER:
        pressed = np.maximum(x, 0.0)
        return np.where(x > 0.0, numbers[0] * numbers[1] * pressed ** (numbers[1] - 1.0), 0.0)
    if kind == eq.TABLE:
        at, force = numbers[:count], numbers[count:]
        i = np.clip(np.searchsorted(at, x, side="left") - 1, 0, count - 2)
        return np.asarray((force[i + 1] - force[i]) / (at[i + 1] - at[i]))
    past = np.maximum(x - numbers[0], 0.0)
    return np.where(past > 0.0, numbers[1] + 3.0 * numbers[2] * past**2, 0.0)


# geometry of elements with slopes -------------------------------------------------------------------------------------


def _holds(element: Element) -> tuple[float, ...]:
    """Return the stiffness of each friction of an element before it slips; 0 without friction."""
    if element.kind == eq.LINE:
        return (float(element.data[eq.HOLD, 0].real),)
    if element.kind == eq.BUSHING:
        return tuple(float(value) for value in element.data[eq.B : eq.B + 6, 0].real)
    return ()


def _height(centre: Numbers, axis: Numbers, radius: Numbers) -> Numbers:
    """Return the height of a wheel's lowest point at design, shape (m,)."""
    return np.asarray(centre[2] - radius * np.sqrt(1.0 - axis[2] ** 2))


def _posed(places: Array, motions: Array) -> Numbers:
    """Return poses (steps, k, 12) whose imaginary parts are slopes by motions (steps, 6, k), times `STEP`."""
    moves = motions.transpose(0, 2, 1)
    shift, turn = moves[..., :3], moves[..., 3:]
    changes = np.empty((*moves.shape[:2], 12))
    changes[..., :3] = shift + _turned_by(turn, places[:, None, :3])
    for j in range(3):  # columns of the rotation
        changes[..., 3 + j :: 3] = _turned_by(turn, places[:, None, 3 + j :: 3])
    return np.asarray(places[:, None] + 1j * STEP * changes)


def _turned_by(turn: Array, v: Array) -> Array:
    parts = [
        turn[..., (i + 1) % 3] * v[..., (i + 2) % 3] - turn[..., (i + 2) % 3] * v[..., (i + 1) % 3]
        for i in range(3)
    ]
    return np.stack(parts, axis=-1)


def line_length(element: Element, tangent: Tangent) -> Numbers:
    """Return the distance of the ends of a line, m, shape (steps, m)."""
    ends = (
        tangent.point(body, element.data[place : place + 3])
        for body, place in ((element.second, eq.Q), (element.first, eq.P))
    )
    reach = next(ends) - next(ends)
    return np.asarray(np.sqrt((reach * reach).sum(axis=-1)))


def twist_angle(element: Element, tangent: Tangent) -> Numbers:
    """Return the rotation of the second body about the axis of a torsion spring, rad, shape (steps, m)."""
    axis, mark = element.data[eq.P : eq.P + 3], element.data[eq.Q : eq.Q + 3]
    now = tangent.direction(element.second, mark)
    other = np.stack(
        [
            axis[(i + 1) % 3] * mark[(i + 2) % 3] - axis[(i + 2) % 3] * mark[(i + 1) % 3]
            for i in range(3)
        ]
    )
    sine = (now * tangent.direction(element.first, other)).sum(axis=-1)
    cosine = (now * tangent.direction(element.first, mark)).sum(axis=-1)
    return _angle(sine, cosine)


def _angle(sine: Numbers, cosine: Numbers) -> Numbers:
    square = sine.real**2 + cosine.real**2
    slope = (cosine.real * sine.imag - sine.real * cosine.imag) / square
    return np.asarray(np.arctan2(sine.real, cosine.real) + 1j * slope)


def bushing_deflections(element: Element, tangent: Tangent) -> list[Numbers]:
    """Return the six deflections of a bushing along and about its axes, m and rad, each (steps, m)."""
    data = element.data
    point = data[eq.P : eq.P + 3]
    gap = tangent.point(element.second, point) - tangent.point(element.first, point)
    axes = [data[eq.A + 3 * i : eq.A + 3 * i + 3] for i in range(3)]
    volume = float(np.linalg.det(np.array([axis[:, 0].real for axis in axes])))
    hand = 1.0 if volume > 0.0 else -1.0
    units = [np.broadcast_to(one[:, None], point.shape) for one in np.eye(3)]
    first = [tangent.direction(element.first, one) for one in units]
    second = [tangent.direction(element.second, one) for one in units]
    inner = [[(first[i] * second[j]).sum(axis=-1) for j in range(3)] for i in range(3)]
    sine = [
        0.5 * (inner[2][1] - inner[1][2]),
        0.5 * (inner[0][2] - inner[2][0]),
        0.5 * (inner[1][0] - inner[0][1]),
    ]
    square = sine[0] * sine[0] + sine[1] * sine[1] + sine[2] * sine[2]
    tiny = square.real < _SMALL**2
    size = np.sqrt(np.where(tiny, 1.0, square))
    cosine = 0.5 * (inner[0][0] + inner[1][1] + inner[2][2] - 1.0)
    stretch = np.where(tiny, 1.0 + square / 6.0, _angle(size, cosine) / size)
    theta = [stretch * part for part in sine]
    along = [(tangent.direction(element.first, axis) * gap).sum(axis=-1) for axis in axes]
    about = [hand * sum(axis[i] * theta[i] for i in range(3)) for axis in axes]
    return [*along, *about]
