"""Static equilibrium of rigid bodies on elastic joints from energies: the oracle of kinematics and compliance.

It shares nothing with jounce. A mechanism is plain data: bodies with a reference point, joints, elastic parts, wheels
and a rack. Unknowns are a displacement and modified Rodrigues parameters of each body, counted from the design pose.
Elastic parts and springs are energies; joints are conditions with multipliers; loads do virtual work on points that are
frozen to their bodies; the road pushes up at the lowest point of each wheel. CasADi differentiates, Newton solves.

Points and directions are given in the design pose, in axes of the ground; units are SI.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import casadi as ca
import numpy as np

GROUND = "ground"
_MICRO = 1e-6  # m/N: makes a condition on a force as large as a condition on a length
_SERIES = 0.05  # squared Rodrigues parameters below which the rotation vector is a series
_LOADS = {  # name of a wheel's load: where it acts
    "patch_x": "patch", "patch_y": "patch", "centre_x": "centre", "centre_y": "centre",
    "moment_x": "moment", "moment_y": "moment", "moment_z": "moment",
}  # fmt: skip


# --- plain data -------------------------------------------------------------------------------------------------------


@dataclass
class Wheel:
    """A thin disc on a body: centre, axis (outboard), radius, and trail: the road's force acts that far behind."""

    body: str
    centre: Sequence[float]
    axis: Sequence[float]
    radius: float


@dataclass
class Data:
    """A mechanism: ``joints`` and ``elastic`` are dictionaries with their ``kind`` and ``name``."""

    bodies: dict[str, Sequence[float]] = field(default_factory=dict)  # name: reference point
    joints: list[dict] = field(default_factory=list)
    elastic: list[dict] = field(default_factory=list)
    wheels: dict[str, Wheel] = field(default_factory=dict)
    rack: dict | None = None  # {"first", "second", "axis"}: the second slides in the first


# --- laws -------------------------------------------------------------------------------------------------------------


def energy_of(law: Mapping, x):
    """Integral of a force over its deflection from 0: ``rate``, ``preload``, ``polynomial``, ``table`` or ``stop``."""
    total = law.get("preload", 0.0) * x + 0.5 * law.get("rate", 0.0) * x**2
    for power, factor in enumerate(law.get("polynomial", ()), start=2):
        total += factor * x**power / power
    if "table" in law:
        xs, forces = (np.asarray(each, dtype=float) for each in law["table"])
        slopes = np.diff(forces) / np.diff(xs)
        total += forces[0] * x + 0.5 * slopes[0] * ((x - xs[0]) ** 2 - xs[0] ** 2)
        for knot, change in zip(xs[1:-1], np.diff(slopes), strict=True):
            total += 0.5 * change * (ca.fmax(x - knot, 0.0) ** 2 - max(-knot, 0.0) ** 2)
    for stop, sign in ((law.get("bump_stop"), 1.0), (law.get("rebound_stop"), -1.0)):
        if stop:
            into = ca.fmax(sign * x - stop["gap"], 0.0)
            total += 0.5 * stop["rate"] * into**2 + 0.25 * stop.get("progression", 0.0) * into**4
    if "power" in law:
        factor, exponent = law["power"]
        total += factor * ca.fmax(x, 0.0) ** (exponent + 1.0) / (exponent + 1.0)
    return total


def friction_energy(friction: Mapping, x, slipped):
    """Energy of a spring of stiffness ``hold`` that slips at a ``force``, from where it slipped to before."""
    away, reach = x - slipped, friction["force"] / friction["hold"]
    beyond = ca.fmax(away - reach, 0.0) ** 2 + ca.fmax(-away - reach, 0.0) ** 2
    return 0.5 * friction["hold"] * (away**2 - beyond)


def _laws(element: Mapping) -> list[Mapping]:
    """Laws of a bushing in its six directions: a curve replaces the stiffness."""
    stiffness = (*element["stiffness"], *element.get("rotational_stiffness", (0.0, 0.0, 0.0)))
    preload = element.get("preload", (0.0,) * 6)
    curves = element.get("curves", {})
    names = ("x", "y", "z", "rx", "ry", "rz")
    return [
        {**(curves.get(name) or {"rate": rate}), "preload": -load}
        for name, rate, load in zip(names, stiffness, preload, strict=True)
    ]


# --- rotations --------------------------------------------------------------------------------------------------------


def _cross(a, b):
    return ca.vertcat(
        a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
    )


def _across(direction: Sequence[float]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A unit vector along a direction, and two across it."""
    along = np.asarray(direction, dtype=float) / np.linalg.norm(direction)
    other = np.cross(along, np.eye(3)[np.argmin(np.abs(along))])
    other /= np.linalg.norm(other)
    return along, other, np.cross(along, other)


class _Pose:
    """A body as symbols: ``u`` moves its reference point, ``m`` (axis times tan(angle/4)) turns it."""

    def __init__(self, name: str, reference: Sequence[float]) -> None:
        self.moves = name != GROUND
        make = ca.SX.sym if self.moves else (lambda _, n: ca.SX.zeros(n))
        self.u, self.m = make(f"{name}.u", 3), make(f"{name}.m", 3)
        self.reference = ca.DM(np.asarray(reference, dtype=float))
        self.size = ca.dot(self.m, self.m)

    def turn(self, v):
        """A direction after the rotation."""
        once = _cross(self.m, v)
        twice = _cross(self.m, once)
        return v + (4.0 * (1.0 - self.size) * once + 8.0 * twice) / (1.0 + self.size) ** 2

    def back(self, v):
        """A direction of now in the axes of the body."""
        once = _cross(self.m, v)
        twice = _cross(self.m, once)
        return v + (-4.0 * (1.0 - self.size) * once + 8.0 * twice) / (1.0 + self.size) ** 2

    def place(self, point):
        """Where a point of the body is now."""
        return self.reference + self.u + self.turn(ca.DM(np.asarray(point)) - self.reference)

    @property
    def quaternion(self):
        return (1.0 - self.size) / (1.0 + self.size), 2.0 * self.m / (1.0 + self.size)


def _relative(first: _Pose, second: _Pose):
    """Modified Rodrigues parameters of the second body in the axes of the first."""
    (a, u), (b, v) = first.quaternion, second.quaternion
    scalar, vector = a * b + ca.dot(u, v), a * v - b * u - _cross(u, v)
    return vector / (1.0 + scalar)


def _rotation_vector(m):
    """Axis times angle of modified Rodrigues parameters."""
    s = ca.dot(m, m)
    series = sum((-s) ** k / (2 * k + 1) for k in range(14))
    root = ca.sqrt(ca.if_else(s < _SERIES, 1.0, s))
    return 4.0 * m * ca.if_else(s < _SERIES, series, ca.atan(root) / root)


# --- equations --------------------------------------------------------------------------------------------------------


@dataclass
class State:
    """A solved pose: unknowns and multipliers, with what they mean."""

    x: np.ndarray
    inputs: dict[str, float]
    oracle: Oracle

    def place(self, body: str, point: Sequence[float]) -> np.ndarray:
        """Position now of a point given in the design pose."""
        return self._place(self.x, body, np.asarray(point, dtype=float))

    def turn(self, body: str) -> np.ndarray:
        """Rotation matrix of a body from design, shape (3, 3)."""
        return self._pose(self.x, body)[2]

    def design(self, body: str, place: Sequence[float]) -> np.ndarray:
        """Where a point of a body that is at a place now is in the design pose."""
        reference, u, turn = self._pose(self.x, body)
        return reference + turn.T @ (np.asarray(place) - reference - u)

    def speed(self, body: str, point: Sequence[float], of: str) -> np.ndarray:
        """Slope of a point's position (given in the design pose) by an input, the point fixed to its body."""
        moved = self.x + 1e-30j * self._by(of)[0]
        return self._place(moved, body, np.asarray(point, dtype=float)).imag / 1e-30

    def _place(self, x: np.ndarray, body: str, point: np.ndarray) -> np.ndarray:
        reference, u, turn = self._pose(x, body)
        return reference + u + turn @ (point - reference)

    def _pose(self, x: np.ndarray, body: str) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        if body == GROUND:
            return np.zeros(3), np.zeros(3), np.eye(3)
        start = 6 * list(self.oracle.data.bodies).index(body)
        u, m = x[start : start + 3], x[start + 3 : start + 6]
        skew, s = np.array([[0, -m[2], m[1]], [m[2], 0, -m[0]], [-m[1], m[0], 0]]), m @ m
        turn = np.eye(3) + (4.0 * (1.0 - s) * skew + 8.0 * skew @ skew) / (1.0 + s) ** 2
        return np.asarray(self.oracle.data.bodies[body], dtype=float), u, turn

    @cached_property
    def shown(self) -> dict[str, np.ndarray]:
        """Deflections of elastic parts, forces of joints, contact points and forces by name."""
        values = self.oracle.show(self.x, self.oracle.vector(self.inputs))
        return dict(zip(self.oracle.names, (each.full()[:, 0] for each in values), strict=True))

    @property
    def slipped(self) -> dict[str, float]:
        """Where friction has slipped to, as inputs of the next step."""
        after = {}
        for name, reach in self.oracle.slipping.items():
            now, before = self.shown[f"{name}.dry"][0], self.inputs.get(f"{name}.slipped", 0.0)
            after[f"{name}.slipped"] = now - np.clip(now - before, -reach, reach)
        return after

    def slopes(self, of: str) -> dict[str, np.ndarray]:
        """Slopes of all that is shown by an input: exact derivatives at the equilibrium."""
        dx, column = self._by(of)
        p = self.oracle.vector(self.inputs)
        by_x, by_p = (each.full() for each in self.oracle.show_slopes(self.x, p))
        rows = by_x @ dx + by_p[:, column]
        sizes = np.cumsum([len(each) for each in self.shown.values()])[:-1]
        return dict(zip(self.shown, np.split(rows, sizes), strict=True))

    def _by(self, of: str) -> tuple[np.ndarray, int]:
        """Slope of the unknowns by an input, and the input's place."""
        p, column = self.oracle.vector(self.inputs), list(self.oracle.inputs).index(of)
        slope = self.oracle.residual(self.x, p)[1].full()
        return _solve(slope, -self.oracle.by_inputs(self.x, p).full()[:, column]), column


def _solve(matrix: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Solve linear equations after scaling rows and columns."""
    rows = 1.0 / np.maximum(np.abs(matrix).max(axis=1), 1e-300)
    columns = 1.0 / np.maximum(np.abs(matrix * rows[:, None]).max(axis=0), 1e-300)
    scaled = matrix * rows[:, None] * columns
    step = np.linalg.solve(scaled, right * rows)
    step += np.linalg.solve(scaled, right * rows - scaled @ step)
    return step * columns


class Oracle:
    """Equations of a mechanism. Inputs (SI) have names; those that are not given are zero.

    For each wheel: ``<wheel>.held`` (1: the height of its contact point is held, 0: its load), ``<wheel>.height``
    (m, of the contact point), ``<wheel>.load`` (N, up), and loads ``patch_x``, ``patch_y``, ``centre_x``,
    ``centre_y`` (N), ``moment_x``, ``moment_y``, ``moment_z`` (N m), ``trail`` (m behind the contact point,
    against the wheel's heading).
    With ``roll`` 1 the difference of two contact points' heights is ``roll.difference`` (m), the sum of loads
    ``roll.load`` (N). Directions with friction have ``<name>.slipped``, which `solve` continues from its start.
    For the rack: ``rack.held``, ``rack.travel`` (m), ``rack.force`` (N).
    """

    def __init__(self, data: Data) -> None:
        self.data = data
        self.poses = {name: _Pose(name, reference) for name, reference in data.bodies.items()}
        self.poses[GROUND] = _Pose(GROUND, (0.0, 0.0, 0.0))
        self.inputs: dict[str, ca.SX] = {}
        self._energy, self._virtual = ca.SX(0.0), []
        self._conditions: list[tuple[str, ca.SX]] = []
        self._unknowns: list[ca.SX] = []
        self._closing: list[ca.SX] = []
        self._road: list[tuple[str, ca.SX, ca.SX]] = []
        self._show: dict[str, ca.SX] = {}
        self.slipping: dict[
            str, float
        ] = {}  # directions with friction: deflection before they slip
        for element in data.elastic:
            getattr(self, f"_{element['kind'].replace(' ', '_')}")(element)
        for joint in data.joints:
            conditions = ca.vertcat(*getattr(self, f"_{joint['kind'].replace(' ', '_')}")(joint))
            self._conditions.append((joint["name"], conditions))
        if data.rack:
            self._add_rack(data.rack)
        for name, wheel in data.wheels.items():
            self._add_wheel(name, wheel)
        self._close_road()
        self._finish()

    def vector(self, inputs: Mapping[str, float]) -> np.ndarray:
        """Inputs in the order of the equations."""
        unknown = set(inputs) - set(self.inputs)
        assert not unknown, f"unknown inputs {unknown}"
        return np.array([inputs.get(name, 0.0) for name in self.inputs], dtype=float)

    def input(self, name: str) -> ca.SX:
        """Symbol of an input."""
        return self.inputs.setdefault(name, ca.SX.sym(name))

    def solve(self, inputs: Mapping[str, float], start: State | None = None) -> State:
        """Equilibrium at inputs, reached from an equilibrium at others (by default from the design pose)."""
        inputs = {**(start.slipped if start else {}), **inputs}
        target = self.vector(inputs)
        x = np.zeros(self.size) if start is None else start.x
        known = target if start is None else self.vector(start.inputs)
        share, step = 0.0, 1.0
        while share < 1.0:
            step = min(step, 1.0 - share)
            tried = self._newton(x, known + (share + step) * (target - known))
            if tried is not None:
                x, share, step = tried, share + step, 2.0 * step
                continue
            step *= 0.5
            if step < 1e-4:
                raise ArithmeticError(f"no equilibrium at {dict(inputs)}")
        return State(x, dict(inputs), self)

    def follow(self, path: Iterable[Mapping[str, float]], start: State) -> list[State]:
        """Equilibria along a path of inputs."""
        states = []
        for inputs in path:
            start = self.solve(inputs, start)
            states.append(start)
        return states

    def _newton(self, x: np.ndarray, p: np.ndarray) -> np.ndarray | None:
        poses, last = slice(0, 6 * len(self.data.bodies)), np.inf
        for _ in range(30):
            residual, slope = self.residual(x, p)
            try:
                step = _solve(slope.full(), -residual.full()[:, 0])
            except np.linalg.LinAlgError:
                return None
            size = np.abs(step[poses]).max(initial=0.0)
            if not np.isfinite(size):
                return None
            x = x + step * min(1.0, 0.2 / max(size, 1e-300))
            if size < 1e-13 or (size < 1e-11 and size >= 0.5 * last):
                return x
            last = size
        return None

    # elastic parts -------------------------------------------------------------------------------------------------

    def _ends(self, row: Mapping) -> tuple[_Pose, _Pose]:
        return self.poses[row["first"]], self.poses[row["second"]]

    def _bushing(self, row: Mapping) -> None:
        """Second body's point against the first's, and the rotation vector, in the axes of the first."""
        first, second = self._ends(row)
        axes = ca.DM(np.asarray(row.get("axes", np.eye(3)), dtype=float)).T  # rows: x, y, z
        gap = first.back(second.place(row["at"]) - first.place(row["at"]))
        rotation, mirror = _rotation_vector(_relative(first, second)), ca.DM.eye(3)
        if row.get("mirrored"):  # it is what a mirror at y = 0 shows; rotations turn the other way
            mirror = ca.diag(ca.DM([1.0, -1.0, 1.0]))
            rotation = -rotation
        axes = mirror @ axes
        deflection = ca.vertcat(axes.T @ gap, axes.T @ rotation)
        laws, names = _laws(row), ("x", "y", "z", "rx", "ry", "rz")
        dry = [self._slips(f"{row['name']}.{each}", row, each) for each in names]
        probe = ca.SX.sym("probe", 6)
        energy = sum((energy_of(law, probe[i]) for i, law in enumerate(laws)), ca.SX(0.0))
        for i, each in enumerate(dry):
            energy += each(probe[i])
        self._energy += ca.substitute(energy, probe, deflection)
        force = -ca.substitute(ca.gradient(energy, probe), probe, deflection)
        self._show[f"{row['name']}.deflection"] = deflection
        self._show[f"{row['name']}.force"] = force  # on the second body, axes of the bushing
        self._show[f"{row['name']}.force_ground"] = first.turn(axes @ force[:3])
        for i, each in enumerate(names):
            self._note(f"{row['name']}.{each}", row, each, deflection[i])

    def _slips(self, name: str, row: Mapping, direction: str):
        """Energy of the friction in a direction, with its slipped deflection as an input."""
        friction = row.get("friction", {}).get(direction)
        if not friction:
            return lambda _: 0.0
        slipped = self.input(f"{name}.slipped")
        return lambda x: friction_energy(friction, x, slipped)

    def _note(self, name: str, row: Mapping, direction: str, deflection) -> None:
        """Remember a direction that slips: its deflection is needed after each step."""
        friction = row.get("friction", {}).get(direction)
        if friction:
            self._show[f"{name}.dry"] = deflection
            self.slipping[name] = friction["force"] / friction["hold"]

    def _spring(self, row: Mapping) -> None:
        """Along a line: the law's deflection is a ``length`` (m, by default that of design) less the line's."""
        first, second = self._ends(row)
        reach = second.place(row["end"]) - first.place(row["at"])
        length = ca.sqrt(ca.dot(reach, reach))
        design = float(np.linalg.norm(np.subtract(row["end"], row["at"])))
        probe = ca.SX.sym("probe")
        energy = energy_of(row["law"], probe) + self._slips(row["name"], row, "x")(probe)
        deflection = row.get("length", design) - length
        self._energy += ca.substitute(energy, probe, deflection)
        force = ca.substitute(ca.gradient(energy, probe), probe, deflection)
        self._show[f"{row['name']}.force"] = force  # compression positive
        self._show[f"{row['name']}.length"] = length
        self._note(row["name"], row, "x", deflection)

    def _twist(self, row: Mapping) -> None:
        """Turn of the second body against the first about a common axis."""
        first, second = self._ends(row)
        along = ca.DM(_across(row["axis"])[0])
        angle = ca.dot(along, _rotation_vector(_relative(first, second)))
        self._energy += energy_of(row["law"], angle)
        self._show[f"{row['name']}.angle"] = angle
        probe = ca.SX.sym("probe")
        torque = ca.gradient(energy_of(row["law"], probe), probe)
        self._show[f"{row['name']}.torque"] = ca.substitute(torque, probe, angle)

    def _bar(self, row: Mapping) -> None:
        """A bar between two halves, each turned about its axis on the holder; ``sign`` -1 takes their difference."""
        holder = self.poses[row["holder"]]
        left, right = (
            ca.dot(ca.DM(axis), _rotation_vector(_relative(holder, self.poses[half])))
            for axis, half in zip(row["axes"], row["halves"], strict=True)
        )
        twist = right + row["sign"] * left
        self._energy += energy_of(row["law"], twist)
        self._show[f"{row['name']}.angle"] = twist
        probe = ca.SX.sym("probe")
        torque = ca.gradient(energy_of(row["law"], probe), probe)
        self._show[f"{row['name']}.torque"] = ca.substitute(torque, probe, twist)

    # joints --------------------------------------------------------------------------------------------------------

    def _spherical(self, row: Mapping) -> list:
        first, second = self._ends(row)
        return [second.place(row["at"]) - first.place(row["at"])]

    def _revolute(self, row: Mapping) -> list:
        """About the line through ``at`` and ``end``, fixed to both bodies."""
        along = np.subtract(row["end"], row["at"])
        return [*self._spherical(row), *self._parallel({**row, "axis": along})]

    def _parallel(self, row: Mapping) -> list:
        first, second = self._ends(row)
        along, *across = _across(row["axis"])
        return [ca.dot(first.turn(ca.DM(along)), second.turn(ca.DM(each))) for each in across]

    def _point_on_line(self, row: Mapping) -> list:
        """Point ``point`` of the second body on a line of the first through ``at`` along ``axis``."""
        first, second = self._ends(row)
        gap = second.place(row["point"]) - first.place(row["at"])
        return [ca.dot(first.turn(ca.DM(each)), gap) for each in _across(row["axis"])[1:]]

    def _cylindrical(self, row: Mapping) -> list:
        return [*self._point_on_line({**row, "point": row["at"]}), *self._parallel(row)]

    def _prismatic(self, row: Mapping) -> list:
        return [*self._point_on_line({**row, "point": row["at"]}), *self._aligned(row)]

    def _aligned(self, row: Mapping) -> list:
        return [_relative(*self._ends(row))]

    def _fixed(self, row: Mapping) -> list:
        return [*self._spherical(row), *self._aligned(row)]

    def _perpendicular(self, row: Mapping) -> list:
        """A direction of the first body stays across a direction of the second."""
        first, second = self._ends(row)
        return [ca.dot(first.turn(ca.DM(row["axis"])), second.turn(ca.DM(row["other"])))]

    def _about(self, row: Mapping) -> list:
        """The rotation vector of the second body in the first has no component along an axis."""
        first, second = self._ends(row)
        return [ca.dot(ca.DM(row["axis"]), _rotation_vector(_relative(first, second)))]

    def _rod(self, row: Mapping) -> list:
        first, second = self._ends(row)
        reach = second.place(row["end"]) - first.place(row["at"])
        length = float(np.linalg.norm(np.subtract(row["end"], row["at"])))
        return [ca.sqrt(ca.dot(reach, reach)) - length]

    # rack and wheels -----------------------------------------------------------------------------------------------

    def _add_rack(self, row: Mapping) -> None:
        """The rack's travel in its housing, held or under a force."""
        first, second = self._ends(row)
        along = ca.DM(_across(row["axis"])[0])
        at = row.get("at", self.data.bodies[row["second"]])
        travel = ca.dot(along, first.back(second.place(at) - first.place(at)))
        force = ca.SX.sym("rack force")
        held = self.input("rack.held")
        self._unknowns.append(force)
        self._closing.append(
            held * (travel - self.input("rack.travel"))
            + (1.0 - held) * _MICRO * (force - self.input("rack.force"))
        )
        self._virtual.append((force, travel, None))
        self._show |= {"rack.travel": travel, "rack.force": force}
        rack = self.poses["rack"]  # may be another body than the driven pinion
        self._show["rack.place"] = ca.dot(along, first.back(rack.place(at) - first.place(at)))

    def _add_wheel(self, name: str, wheel: Wheel) -> None:
        """Loads do virtual work on points frozen to the body; the road pushes up at the lowest point of the disc."""
        body = self.poses[wheel.body]
        axis = body.turn(ca.DM(_across(wheel.axis)[0]))
        level = ca.sqrt(axis[0] ** 2 + axis[1] ** 2)
        down = ca.vertcat(axis[0] * axis[2], axis[1] * axis[2], axis[2] ** 2 - 1.0) / level
        centre = body.place(wheel.centre)
        patch = centre + wheel.radius * down
        load = {each: self.input(f"{name}.{each}") for each in (*_LOADS, "trail")}
        rear = ca.cross(axis, ca.DM([0.0, 0.0, 1.0])) * (
            -1.0 if float(wheel.axis[1]) > 0.0 else 1.0
        )
        behind = patch + load["trail"] * rear / ca.norm_2(rear)
        vertical = ca.SX.sym(f"{name} load")
        self._unknowns.append(vertical)
        self._road.append((name, patch[2], vertical))
        self._push(body, patch, ca.vertcat(0.0, 0.0, vertical))
        self._push(body, behind, ca.vertcat(load["patch_x"], load["patch_y"], 0.0))
        self._push(body, centre, ca.vertcat(load["centre_x"], load["centre_y"], 0.0))
        moment = ca.vertcat(load["moment_x"], load["moment_y"], load["moment_z"])
        for each in np.eye(
            3
        ):  # half the sum of arm times motion of three unit arms is the rotation
            arm = body.turn(ca.DM(each))
            self._virtual.append((0.5 * _cross(moment, arm), arm, None))
        self._show |= {
            f"{name}.centre": centre, f"{name}.patch": patch, f"{name}.axis": axis,
            f"{name}.vertical_force": vertical, f"{name}.turn": _rotation_vector(body.m),
        }  # fmt: skip

    def _close_road(self) -> None:
        """What is held at each wheel; with ``roll`` at both: the difference of heights, and the sum of loads."""
        roll = self.input("roll")
        heights, forces = ([row[k] for row in self._road] for k in (1, 2))
        together = [
            heights[0] - heights[-1] - self.input("roll.difference"),
            _MICRO * (sum(forces, ca.SX(0.0)) - self.input("roll.load")),
        ]
        for k, (name, height, force) in enumerate(self._road):
            held = self.input(f"{name}.held")
            alone = held * (height - self.input(f"{name}.height"))
            alone += (1.0 - held) * _MICRO * (force - self.input(f"{name}.load"))
            self._closing.append((1.0 - roll) * alone + roll * together[k % 2])

    def _push(self, body: _Pose, place, force) -> None:
        """A force on the point of a body that is at a place now."""
        arm = ca.SX.sym("arm", 3)
        self._virtual.append((force, body.reference + body.u + body.turn(arm), (arm, body, place)))

    def _generalised(self, q):
        """Virtual work of all loads for a unit of each coordinate."""
        total = ca.SX.zeros(q.shape[0])
        for force, motion, frozen in self._virtual:
            row = ca.jacobian(motion, q)
            if frozen is not None:
                arm, body, place = frozen
                row = ca.substitute(row, arm, body.back(place - body.reference - body.u))
            total += row.T @ force
        return total

    def _finish(self) -> None:
        q = ca.vertcat(*(ca.vertcat(pose.u, pose.m) for pose in self.poses.values() if pose.moves))
        conditions = ca.vertcat(ca.SX(0, 1), *(each for _, each in self._conditions))
        multipliers = ca.SX.sym("multipliers", conditions.shape[0])
        gradient = ca.gradient(self._energy + ca.dot(multipliers, conditions), q)
        residual = ca.vertcat(gradient - self._generalised(q), conditions, *self._closing)
        x = ca.vertcat(q, multipliers, *self._unknowns)
        p = ca.vertcat(*self.inputs.values())
        start = 0
        for name, each in self._conditions:
            self._show[f"{name}.multipliers"] = multipliers[start : start + each.shape[0]]
            start += each.shape[0]
        self._show["energy"] = self._energy
        self.size, self.names = x.shape[0], tuple(self._show)
        shown = [ca.SX(each) for each in self._show.values()]
        self.residual = ca.Function("residual", [x, p], [residual, ca.jacobian(residual, x)])
        self.by_inputs = ca.Function("by_inputs", [x, p], [ca.jacobian(residual, p)])
        self.show = ca.Function("show", [x, p], shown)
        stacked = ca.vertcat(*shown)
        self.show_slopes = ca.Function(
            "show_slopes", [x, p], [ca.jacobian(stacked, x), ca.jacobian(stacked, p)]
        )
