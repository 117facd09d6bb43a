"""Cars on dependent axles in maximal coordinates by Lagrange's equations: linearised about rest, and integrated.

Nothing of jounce is used but the numbers of a description, read by their paths. Each body has six coordinates, the
displacement of its centre and a rotation vector; rods, hinges and the guide of the car's body are constraints with
multipliers. Tyres are radial: they deflect in the plane of the wheel.
"""

from __future__ import annotations

from collections.abc import Callable
from math import factorial
from typing import Any

import casadi as ca
import numpy as np
from scipy.integrate import solve_ivp

_TERMS = 8  # of the series of sine and cosine: exact to rounding below 0.5 rad


def _series(s: ca.SX, first: int) -> ca.SX:
    """Sum of (-s)^k / (2 k + first)!."""
    return sum((-s) ** k / factorial(2 * k + first) for k in range(_TERMS))


def rotation(v: ca.SX) -> ca.SX:
    """Rotation matrix of a rotation vector."""
    k, s = ca.skew(v), ca.dot(v, v)
    return ca.SX.eye(3) + _series(s, 1) * k + _series(s, 2) * k @ k


def spin(v: ca.SX, rate: ca.SX) -> ca.SX:
    """Angular velocity of a rotation vector that changes."""
    k, s = ca.skew(v), ca.dot(v, v)
    return (ca.SX.eye(3) + _series(s, 2) * k + _series(s, 3) * k @ k) @ rate


class Car:
    """A car whose axles are all dependent, from its description."""

    def __init__(self, rig: Any) -> None:
        p = self.p = rig.parameters()
        self.q, self.qd = [], []
        self.centres: list[np.ndarray] = []
        self.kinetic, self.potential = ca.SX(0.0), ca.SX(0.0)
        self.closures: list[ca.SX] = []
        self.losses: list[tuple[ca.SX, float]] = []  # lengths and damping coefficients
        self.roads: list[ca.SX] = []
        self.wheels: list[ca.SX] = []
        inertia = ["roll_inertia", "pitch_inertia", "pitch_inertia"]
        tensor = np.diag([p[f"body.{name}"] for name in inertia])
        self.add(p["body.mass"], np.array([0.0, 0.0, p["body.height"]]), tensor)
        self.closures += [self.q[0][0], self.q[0][1], rotation(self.q[0][3:])[1, 0]]
        for end, sign in (("front", 1.0), ("rear", -1.0)):
            self._axle(end, sign * p[f"{end}.distance"], getattr(rig, end).axle)

    def add(self, mass: float, centre: np.ndarray, tensor: np.ndarray) -> int:
        number = len(self.q)
        q, qd = (ca.SX.sym(f"{name}{number}", 6) for name in ("q", "qd"))
        self.q.append(q)
        self.qd.append(qd)
        self.centres.append(centre)
        turned = rotation(q[3:]).T @ spin(q[3:], qd[3:])
        self.kinetic += 0.5 * mass * ca.dot(qd[:3], qd[:3]) + 0.5 * turned.T @ tensor @ turned
        self.potential += mass * self.p["gravity"] * q[2]
        return number

    def place(self, body: int, point: np.ndarray) -> ca.SX:
        arm = ca.SX(point - self.centres[body])
        return self.centres[body] + self.q[body][:3] + rotation(self.q[body][3:]) @ arm

    def seen(self, vector: ca.SX) -> ca.SX:
        """A vector in the axes of the car's body."""
        return rotation(self.q[0][3:]).T @ vector

    def _axle(self, end: str, at: float, rig: Any) -> None:
        p, before = self.p, f"{end}.axle."
        ahead = np.array([at - p[before + "hardpoints.wheel_centre[0]"], 0.0, 0.0])

        def point(name: str, side: float = 1.0, table: str = "hardpoints.") -> np.ndarray:
            own = np.array([p[f"{before}{table}{name}[{i}]"] for i in range(3)])
            return own * [1.0, side, 1.0] + ahead

        def body(name: str, side: float = 1.0) -> int:
            xx, yy, zz, xy, xz, yz = (
                p[f"{before}bodies.{name}.inertia.{e}"]
                for e in ("xx", "yy", "zz", "xy", "xz", "yz")
            )
            xy, yz = side * xy, side * yz
            tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
            centre = point(f"{name}.centre_of_mass", side, "bodies.")
            return self.add(p[f"{before}bodies.{name}.mass"], centre, tensor)

        has = {name for name, value in rig.hardpoints if value is not None}
        if "shear_centre" in has:
            on = self._twist_beam(before, point, body)
        else:
            on = self._solid_axle(point, body, has)
        for side, carrier in on.items():
            self._strut(before, point, carrier, side, has)
        travels = [self._tyre(before, point("wheel_centre", side), on[side], side) for side in on]
        bar = p.get(f"{end}.anti_roll_bar_rate", 0.0)
        self.potential += 0.5 * bar * (travels[0] - travels[1]) ** 2

    def _solid_axle(self, point: Callable, body: Callable, has: set[str]) -> dict[float, int]:
        beam = body("axle")
        rods = [("lower_link", 1.0, beam), ("lower_link", -1.0, beam), ("upper_link", 1.0, beam)]
        if abs(point("upper_link_body")[1]) > 1e-9:
            rods.append(("upper_link", -1.0, beam))
        if "panhard_axle" in has:
            rods.append(("panhard", 1.0, beam))
        if "watt_pivot" in has:
            lever = body("watt_lever")
            self._hinge(beam, lever, point("watt_pivot"), 0)
            rods += [("watt_upper", 1.0, lever), ("watt_lower", 1.0, lever)]
        for name, side, carrier in rods:
            inner, outer = point(f"{name}_body", side), point(f"{name}_axle", side)
            reach = self.place(carrier, outer) - self.place(0, inner)
            design = outer - inner
            self.closures.append(0.5 * (ca.dot(reach, reach) - float(design @ design)))
        return {1.0: beam, -1.0: beam}

    def _hinge(self, first: int, second: int, at: np.ndarray, along: int) -> None:
        gap = self.place(second, at) - self.place(first, at)
        one, other = (rotation(self.q[body][3:]) for body in (first, second))
        self.closures += ca.vertsplit(gap)
        self.closures += [ca.dot(one[:, i], other[:, along]) for i in range(3) if i != along]

    def _twist_beam(self, before: str, point: Callable, body: Callable) -> dict[float, int]:
        on = {side: body("half", side) for side in (1.0, -1.0)}
        self._hinge(on[1.0], on[-1.0], point("shear_centre"), 1)
        for side, held in ((1.0, (0, 1, 2)), (-1.0, (0, 2))):
            pivot = point("pivot", side)
            gap = self.seen(self.place(on[side], pivot) - self.place(0, pivot))
            self.closures += [gap[i] for i in held]
        left, right = (rotation(self.q[on[side]][3:]) for side in (1.0, -1.0))
        inner = left.T @ right
        twist = ca.atan2(inner[0, 2], inner[2, 2])
        self.potential += 0.5 * self.p[before + "beam.torsional_stiffness"] * twist**2
        return on

    def _strut(self, before: str, point: Callable, on: int, side: float, has: set[str]) -> None:
        def line(element: str) -> tuple[ca.SX, float]:
            names = [f"{element}_{end}" for end in ("bottom", "top")]
            names = [name if name in has else name.replace(element, "strut") for name in names]
            bottom, top = (point(name, side) for name in names)
            reach = self.place(0, top) - self.place(on, bottom)
            return ca.sqrt(ca.dot(reach, reach)), float(np.linalg.norm(top - bottom))

        length, design = line("spring")
        rate, preload = (self.p[f"{before}strut.spring.{name}"] for name in ("rate", "preload"))
        self.potential += preload * (design - length) + 0.5 * rate * (design - length) ** 2
        self.losses.append((line("damper")[0], self.p[before + "strut.damper.coefficient"]))

    def _tyre(self, before: str, centre: np.ndarray, on: int, side: float) -> ca.SX:
        p = self.p
        camber, toe, radius = (p[f"{before}wheel.{name}"] for name in ("camber", "toe", "radius"))
        level = np.cos(camber)
        axis = np.array([np.sin(toe) * level, side * np.cos(toe) * level, -np.sin(camber)])
        road = ca.SX.sym(f"road{len(self.roads)}")
        now = self.place(on, centre)
        lean = (rotation(self.q[on][3:]) @ axis)[2]
        deflection = radius - (now[2] - road) / ca.sqrt(1.0 - lean**2)
        self.roads.append(road)
        self.wheels.append(now)
        self.potential += 0.5 * p[before + "tyre.stiffness"] * deflection**2
        self.losses.append((deflection, p.get(before + "tyre.damping_coefficient", 0.0)))
        return self.seen(now - self.place(0, np.zeros(3)))[2]


class Equations:
    """Statics, eigenvalues and motion of a car."""

    def __init__(self, car: Car) -> None:
        self.q, self.qd = ca.vertcat(*car.q), ca.vertcat(*car.qd)
        self.road, self.lift = ca.vertcat(*car.roads), ca.SX.sym("lift", len(car.roads))
        closed = ca.vertcat(*car.closures)
        self.force = ca.SX.sym("force", closed.shape[0])
        whole = car.potential + ca.dot(self.force, closed)
        self.rows = ca.jacobian(closed, self.q)
        self.mass = ca.hessian(car.kinetic, self.qd)[0]
        lengths = ca.vertcat(*(length for length, _ in car.losses))
        loss = ca.diag(ca.SX([coefficient for _, coefficient in car.losses]))
        slopes = ca.jacobian(lengths, self.q)
        self.loss = slopes.T @ loss @ slopes
        speeds = slopes @ self.qd + ca.jacobian(lengths, self.road) @ self.lift
        momentum = ca.gradient(car.kinetic, self.qd)
        pushed = -ca.gradient(car.potential, self.q) - slopes.T @ loss @ speeds
        pushed += ca.gradient(car.kinetic, self.q) - ca.jtimes(momentum, self.q, self.qd)
        bent = ca.jtimes(ca.jtimes(closed, self.q, self.qd), self.q, self.qd)
        zero = ca.SX.zeros(closed.shape[0], closed.shape[0])
        system = ca.blockcat([[self.mass, self.rows.T], [self.rows, zero]])
        inputs = [self.q, self.qd, self.road, self.lift]
        self.system = ca.Function("system", inputs, [system, ca.vertcat(pushed, -bent)])
        self.statics = ca.Function(
            "statics",
            [self.q, self.force, self.road],
            [
                ca.vertcat(ca.gradient(whole, self.q), closed),
                ca.hessian(whole, self.q)[0],
                self.rows,
                self.mass,
                self.loss,
            ],
        )
        energy = car.kinetic + car.potential
        self.energy = ca.Function("energy", [self.q, self.qd, self.road], [energy])
        heights = ca.vertcat(*(place[2] for place in car.wheels))
        seen = rotation(car.q[0][3:])
        body = ca.vertcat(car.q[0][2], -ca.asin(seen[2, 0]), ca.atan2(seen[2, 1], seen[2, 2]))
        self.shown = ca.Function("shown", [self.q], [body, heights])
        self.still = np.zeros(len(car.roads))

    def at_rest(self) -> tuple[np.ndarray, np.ndarray]:
        n, m = self.q.shape[0], self.force.shape[0]
        z = np.zeros(n + m)
        for _ in range(30):
            left, slope, rows, *_ = (np.array(x) for x in self.statics(z[:n], z[n:], self.still))
            matrix = np.block([[slope, rows.T], [rows, np.zeros((m, m))]])
            step = np.linalg.solve(matrix, -left[:, 0])
            z = z + step
            if np.abs(step[:n]).max() < 1e-13:
                return z[:n], z[n:]
        raise AssertionError("no equilibrium")

    def eigenvalues(self) -> np.ndarray:
        """Eigenvalues of the motions that the joints allow, of each pair one, by frequency."""
        q, force = self.at_rest()
        _, slope, rows, mass, loss = (np.array(x) for x in self.statics(q, force, self.still))
        free = np.linalg.svd(rows)[2][len(rows) :].T
        mass, loss, slope = (free.T @ part @ free for part in (mass, loss, slope))
        size, inverse = len(mass), np.linalg.inv(mass)
        lower = [-inverse @ slope, -inverse @ loss]
        found = np.linalg.eigvals(np.block([[np.zeros((size, size)), np.eye(size)], lower]))
        found = found[found.imag > 0.0]
        return found[np.argsort(np.abs(found))]

    def run(
        self, times: np.ndarray, roads: Callable[[float], tuple[np.ndarray, np.ndarray]]
    ) -> np.ndarray:
        """Integrate from rest over roads, heights and their rates of all wheels; return the states over time."""
        q, _ = self.at_rest()
        n = len(q)

        def rates(t: float, state: np.ndarray) -> np.ndarray:
            system, right = (np.array(x) for x in self.system(state[:n], state[n:], *roads(t)))
            return np.concatenate([state[n:], np.linalg.solve(system, right[:, 0])[:n]])

        start, span = np.concatenate([q, np.zeros(n)]), (times[0], times[-1])
        solved = solve_ivp(
            rates, span, start, "DOP853", times, rtol=1e-10, atol=1e-12, max_step=2e-3
        )
        return solved.y.T
