"""Readable twin of 3-D corner dynamics: absolute coordinates, written apart from jounce with NumPy, Numba and SciPy.

Every body has its centre of mass (3) and a unit quaternion (4), with velocity and angular velocity in world axes. A
joint is some rows of constraints between points and directions of two bodies (body 0 is the ground):

    along          n . (p_B - p_A) = 0            n fixed in body A
    perpendicular  u . w = 0                      u fixed in A, w fixed in B
    rod            (|p_B - p_A|^2 - L^2) / 2 = 0

Accelerations solve the index-1 equations [M J'; J 0] [a; lambda] = [Q; gamma]. DOP853 advances from one output sample
to the next, restarted at the road's edges and at every contact event (found on the dense output, then polished by
integrating exactly to the event); after each piece positions and velocities go back onto the constraints, so nothing
drifts. This is slow (some seconds a run) and meant to be: it gives the truth to about 1e-13 of each channel's range.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np
from numba import njit
from scipy.integrate import DOP853
from scipy.optimize import brentq

ALONG, PERPENDICULAR, ROD = 0, 1, 2


@njit
def _matrix(q):
    w, x, y, z = q
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


@njit
def _cross(a, b):
    return np.array(
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    )


@njit
def _quaternion_rate(q, omega):
    w, x, y, z = q
    a, b, c = omega
    return 0.5 * np.array(
        [
            -x * a - y * b - z * c,
            w * a + z * b - y * c,
            w * b + x * c - z * a,
            w * c + y * a - x * b,
        ]
    )


@njit
def _turned(q, v):
    """Quaternion after a finite rotation vector in world axes."""
    angle = math.sqrt(v @ v)
    s = 0.5 if angle < 1e-8 else math.sin(angle / 2) / angle
    c, (a, b, d), (w, x, y, z) = math.cos(angle / 2), s * v, q
    new = np.array(
        [
            c * w - a * x - b * y - d * z,
            c * x + a * w + b * z - d * y,
            c * y + b * w + d * x - a * z,
            c * z + d * w + a * y - b * x,
        ]
    )
    return new / math.sqrt(new @ new)


@njit
def _constraints(y, n, kinds, ends, first, second, lengths, J, f, gamma):
    """Fill rows J (m, 6 n), residuals f and right-hand sides gamma of the accelerations; body 0 does not move."""
    zero = np.zeros(3)
    for i in range(len(kinds)):
        a, b = ends[i, 0], ends[i, 1]
        Ra, Rb = np.eye(3), np.eye(3)
        xa, xb, va, vb, wa, wb = zero, zero, zero, zero, zero, zero
        if a > 0:
            at = 7 * (a - 1)
            Ra, xa = _matrix(y[at + 3 : at + 7]), y[at : at + 3]
            at = 7 * n + 6 * (a - 1)
            va, wa = y[at : at + 3], y[at + 3 : at + 6]
        if b > 0:
            at = 7 * (b - 1)
            Rb, xb = _matrix(y[at + 3 : at + 7]), y[at : at + 3]
            at = 7 * n + 6 * (b - 1)
            vb, wb = y[at : at + 3], y[at + 3 : at + 6]
        Ja, Jb = np.zeros(6), np.zeros(6)
        if kinds[i] == PERPENDICULAR:
            u, w = Ra @ first[i, :3], Rb @ second[i, :3]
            f[i] = u @ w
            Ja[3:], Jb[3:] = _cross(u, w), _cross(w, u)
            ut, wt = _cross(wa, u), _cross(wb, w)
            gamma[i] = -(_cross(wa, ut) @ w + 2 * (ut @ wt) + u @ _cross(wb, wt))
        else:
            ra, rb = Ra @ first[i, :3], Rb @ second[i, :3]
            d = xb + rb - xa - ra
            ta, tb = _cross(wa, ra), _cross(wb, rb)
            dv = vb + tb - va - ta
            bias = _cross(wb, tb) - _cross(wa, ta)
            if kinds[i] == ROD:
                f[i] = 0.5 * (d @ d - lengths[i] ** 2)
                Ja[:3], Ja[3:], Jb[:3], Jb[3:] = -d, -_cross(ra, d), d, _cross(rb, d)
                gamma[i] = -(dv @ dv + d @ bias)
            else:
                m = Ra @ first[i, 3:]
                mt = _cross(wa, m)
                f[i] = m @ d
                Ja[:3], Ja[3:], Jb[:3], Jb[3:] = -m, _cross(m, d) - _cross(ra, m), m, _cross(rb, m)
                gamma[i] = -(m @ bias + 2 * (mt @ dv) + _cross(wa, mt) @ d)
        J[i, :] = 0.0
        if a > 0:
            J[i, 6 * (a - 1) : 6 * a] += Ja
        if b > 0:
            J[i, 6 * (b - 1) : 6 * b] += Jb


@njit
def _point(y, n, body, local):
    """Position and velocity of a point of a body."""
    if body == 0:
        return local.copy(), np.zeros(3)
    r = _matrix(y[7 * (body - 1) + 3 : 7 * body]) @ local
    at = 7 * n + 6 * (body - 1)
    return y[7 * (body - 1) : 7 * (body - 1) + 3] + r, y[at : at + 3] + _cross(
        y[at + 3 : at + 6], r
    )


@njit
def _add_force(Q, y, n, body, point, force):
    if body > 0:
        Q[6 * (body - 1) : 6 * body - 3] += force
        Q[6 * body - 3 : 6 * body] += _cross(point - y[7 * (body - 1) : 7 * (body - 1) + 3], force)


@njit
def _spring(y, n, ends, places, laws):
    """Length, force (compression positive) and unit vector from A to B of one spring-damper."""
    pa, va = _point(y, n, ends[0], places[:3])
    pb, vb = _point(y, n, ends[1], places[3:])
    d = pb - pa
    length = math.sqrt(d @ d)
    d = d / length
    return length, laws[0] * (laws[2] - length) - laws[1] * (d @ (vb - va)), d, pa, pb


@njit
def _accelerations(  # noqa: PLR0917
    y,
    tyre,
    n,
    mass,
    inertia,
    gravity,
    kinds,
    ends,
    first,
    second,
    lengths,
    s_ends,
    s_places,
    s_laws,
    wheel,
    hub,
):
    """Accelerations (6 n) and multipliers; ``tyre`` is the vertical force at the wheel centre."""
    m = len(kinds)
    J, f, gamma = np.zeros((m, 6 * n)), np.zeros(m), np.zeros(m)
    _constraints(y, n, kinds, ends, first, second, lengths, J, f, gamma)
    Q, W = np.zeros(6 * n), np.zeros((6 * n, m))
    for i in range(len(s_ends)):
        _, force, d, pa, pb = _spring(y, n, s_ends[i], s_places[i], s_laws[i])
        _add_force(Q, y, n, s_ends[i, 0], pa, -force * d)
        _add_force(Q, y, n, s_ends[i, 1], pb, force * d)
    if wheel > 0:
        centre, _ = _point(y, n, wheel, hub)
        _add_force(Q, y, n, wheel, centre, np.array([0.0, 0.0, tyre]))
    free = np.zeros(6 * n)
    for b in range(n):
        R, omega = _matrix(y[7 * b + 3 : 7 * b + 7]), y[7 * n + 6 * b + 3 : 7 * n + 6 * b + 6]
        world = R @ inertia[b] @ R.T
        k = 6 * b
        Q[k + 2] -= mass[b] * gravity
        Q[k + 3 : k + 6] -= _cross(omega, world @ omega)
        turning = np.linalg.inv(world)
        free[k : k + 3], free[k + 3 : k + 6] = Q[k : k + 3] / mass[b], turning @ Q[k + 3 : k + 6]
        W[k : k + 3], W[k + 3 : k + 6] = (
            J[:, k : k + 3].T / mass[b],
            turning @ np.ascontiguousarray(J[:, k + 3 : k + 6].T),
        )
    multipliers = np.linalg.solve(J @ W, gamma - J @ free)
    return free + W @ multipliers, multipliers, J, f, W


@njit
def _rate(y, tyre, n, *model):
    out = np.empty(13 * n)
    for b in range(n):
        v = y[7 * n + 6 * b : 7 * n + 6 * b + 6]
        out[7 * b : 7 * b + 3] = v[:3]
        out[7 * b + 3 : 7 * b + 7] = _quaternion_rate(y[7 * b + 3 : 7 * b + 7], v[3:])
    out[7 * n :] = _accelerations(y, tyre, n, *model)[0]
    return out


@njit
def _project(y, n, *model):
    """Back onto the constraints, the shortest way in the mass metric: positions by Newton, then velocities."""
    y = y.copy()
    for b in range(n):
        y[7 * b + 3 : 7 * b + 7] /= math.sqrt(np.sum(y[7 * b + 3 : 7 * b + 7] ** 2))
    for _ in range(4):
        _, _, J, f, W = _accelerations(y, 0.0, n, *model)
        move = -(W @ np.linalg.solve(J @ W, f))
        for b in range(n):
            y[7 * b : 7 * b + 3] += move[6 * b : 6 * b + 3]
            y[7 * b + 3 : 7 * b + 7] = _turned(
                y[7 * b + 3 : 7 * b + 7], move[6 * b + 3 : 6 * b + 6]
            )
        if np.abs(f).max() < 1e-16:
            break
    _, _, J, f, W = _accelerations(y, 0.0, n, *model)
    y[7 * n :] -= W @ np.linalg.solve(J @ W, J @ y[7 * n :])
    return y, np.abs(f).max()


@dataclass
class System:
    """Bodies, constraints and force elements, all places in world axes at the design position."""

    gravity: float = 9.81
    mass: list = field(default_factory=list)
    centre: list = field(default_factory=list)
    inertia: list = field(default_factory=list)
    rows: list = field(default_factory=list)
    springs: list = field(default_factory=list)
    joints: dict = field(default_factory=dict)  # name to the numbers of its rows
    wheel: int = 0
    hub: tuple = (0.0, 0.0, 0.0)

    def body(self, mass: float, centre, inertia) -> int:
        """Add a body; inertia as six tensor elements xx yy zz xy xz yz about the centre of mass, design axes."""
        xx, yy, zz, xy, xz, yz = inertia
        self.mass.append(mass)
        self.centre.append(np.array(centre, float))
        self.inertia.append(np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], float))
        return len(self.mass)

    def local(self, body: int, point):
        return np.asarray(point, float) - (self.centre[body - 1] if body else 0.0)

    def along(self, a: int, b: int, point, direction) -> None:
        """Points of A and B that coincide at design stay together along a direction of A."""
        place = np.concatenate([self.local(a, point), np.asarray(direction, float)])
        self.rows.append((ALONG, a, b, place, self.local(b, point), 0.0))

    def together(self, a: int, b: int, point) -> None:
        for direction in np.eye(3):
            self.along(a, b, point, direction)

    def perpendicular(self, a: int, b: int, u, w) -> None:
        self.rows.append(
            (PERPENDICULAR, a, b, np.concatenate([u, np.zeros(3)]), np.asarray(w, float), 0.0)
        )

    def rod(self, a: int, b: int, first, second) -> None:
        length = float(np.linalg.norm(np.subtract(second, first)))
        place = np.concatenate([self.local(a, first), np.zeros(3)])
        self.rows.append((ROD, a, b, place, self.local(b, second), length))

    def revolute(self, a: int, b: int, point, axis) -> None:
        self.together(a, b, point)
        axis = np.asarray(axis, float) / np.linalg.norm(axis)
        side = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
        for across in (side, np.cross(axis, side)):
            self.perpendicular(a, b, across, axis)

    def prismatic(self, a: int, b: int, point, axis) -> None:
        axis = np.asarray(axis, float) / np.linalg.norm(axis)
        side = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
        other = np.cross(axis, side)
        for across in (side, other):
            self.along(a, b, point, across)
            self.perpendicular(a, b, across, axis)
        self.perpendicular(a, b, side, other)

    def spring(
        self, a: int, b: int, first, second, rate: float, damping: float, free_length: float
    ) -> None:
        places = np.concatenate([self.local(a, first), self.local(b, second)])
        self.springs.append((a, b, places, (rate, damping, free_length)))

    def named(self, name: str, add, *arguments) -> None:
        """Add a joint (``self.together`` and so on) under a name, for its force."""
        first = len(self.rows)
        add(*arguments)
        self.joints[name] = range(first, len(self.rows))

    def arrays(self) -> tuple:
        """The model as arrays, in the order of the compiled functions."""
        kinds, a, b, first, second, lengths = (list(x) for x in zip(*self.rows, strict=True))
        springs = (
            [list(x) for x in zip(*self.springs, strict=True)] if self.springs else [[], [], [], []]
        )
        return (
            len(self.mass),
            np.array(self.mass, float),
            np.array(self.inertia),
            float(self.gravity),
            np.array(kinds),
            np.column_stack([a, b]),
            np.array([[*x, *np.zeros(6 - len(x))] for x in first]),
            np.array(second),
            np.array(lengths, float),
            np.array([*zip(springs[0], springs[1], strict=True)], dtype=np.int64).reshape(-1, 2),
            np.array(springs[2]).reshape(-1, 6),
            np.array(springs[3], float).reshape(-1, 3),
            self.wheel,
            self.local(self.wheel, self.hub) if self.wheel else np.zeros(3),
        )

    def at_design(self) -> np.ndarray:
        """State at the design position, at rest."""
        poses = [np.concatenate([centre, [1.0, 0.0, 0.0, 0.0]]) for centre in self.centre]
        return np.concatenate([*poses, np.zeros(6 * len(self.mass))])


@dataclass(frozen=True)
class Obstacle:
    """Half-sine bump met at time ``start``."""

    height: float
    length: float
    speed: float
    start: float = 0.2

    @property
    def edges(self) -> tuple[float, float]:
        return self.start, self.start + self.length / self.speed

    def __call__(self, t: float) -> float:
        s = (t - self.start) * self.speed / self.length
        return self.height * math.sin(math.pi * s) if 0.0 < s < 1.0 else 0.0


class Corner:
    """A system with a body on a vertical guide (body 1), a wheel, a tyre and a strut (spring 0)."""

    def __init__(
        self, system: System, stiffness: float, radius: float, *, unilateral: bool
    ) -> None:
        self.system, self.stiffness, self.radius, self.unilateral = (
            system,
            stiffness,
            radius,
            unilateral,
        )
        self.model = system.arrays()
        self.hub = self.model[-1]
        self.design_centre = np.array(system.hub, float)

    def deflection(self, y, height: float) -> float:
        return self.radius + height - _point(y, self.model[0], self.model[-2], self.hub)[0][2]

    def channels(self, y, height: float, touching: bool) -> np.ndarray:
        """zs, zu, as, au, tyre force, strut force, strut length, sprung and unsprung velocity."""
        n, body = self.model[0], self.model[-2]
        tyre = self.stiffness * self.deflection(y, height) if touching else 0.0
        acceleration = _accelerations(y, tyre, *self.model)[0]
        centre, velocity = _point(y, n, body, self.hub)
        omega = y[7 * n + 6 * body - 3 : 7 * n + 6 * body]
        arm = centre - y[7 * (body - 1) : 7 * (body - 1) + 3]
        alpha = acceleration[6 * body - 3 : 6 * body]
        hub = (
            acceleration[6 * body - 6 : 6 * body - 3]
            + np.cross(alpha, arm)
            + np.cross(omega, np.cross(omega, arm))
        )
        length, force, *_ = _spring(y, n, *(x[0] for x in self.model[9:12]))
        zs, zu = y[2] - self.system.centre[0][2], centre[2] - self.design_centre[2]
        return np.array(
            [zs, zu, acceleration[2], hub[2], tyre, force, length, y[7 * n + 2], velocity[2]]
        )

    def joint_forces(self, y, height: float, touching: bool) -> dict[str, np.ndarray]:
        """Force of each named joint on its second body, ground axes."""
        n, system = self.model[0], self.system
        tyre = self.stiffness * self.deflection(y, height) if touching else 0.0
        multipliers = _accelerations(y, tyre, *self.model)[1]
        found = {}
        for name, rows in system.joints.items():
            total = np.zeros(3)
            for i in rows:
                kind, a, b, first, second, _ = system.rows[i]
                if kind == ALONG:
                    turned = _matrix(y[7 * a - 4 : 7 * a]) if a else np.eye(3)
                    total += multipliers[i] * (turned @ first[3:])
                elif kind == ROD:
                    ends = (
                        _point(y, n, a, np.ascontiguousarray(first[:3]))[0],
                        _point(y, n, b, second)[0],
                    )
                    total += multipliers[i] * (ends[1] - ends[0])
            found[name] = total
        return found

    NAMES = ("zs", "zu", "as", "au", "tyre_force", "strut_force", "strut_length", "vs", "vu")

    def run(
        self, road: Obstacle, times, *, rtol: float = 1e-13, atol: float = 1e-15
    ) -> dict[str, np.ndarray]:
        """All channels at the times, joint forces (``<joint>.fx``), "violation" and "events" (contact changes)."""
        y, touching, events, worst = self.system.at_design(), True, [], 0.0
        y, _ = _project(y, *self.model)
        stops = np.unique(
            np.concatenate([times, [e for e in road.edges if times[0] < e < times[-1]]])
        )
        kept = {float(times[0]): self.channels(y, road(times[0]), touching)}
        carried = [self.joint_forces(y, road(times[0]), touching)]
        wanted = set(map(float, times))
        for begin, end in pairwise(stops):
            t = begin
            while t < end:
                t, y, touching, event = self._piece(road, t, end, y, touching, rtol, atol)
                y, violation = _project(y, *self.model)
                worst = max(worst, violation)
                events += [event] if event else []
            if float(end) in wanted:
                kept[float(end)] = self.channels(y, road(end), touching)
                carried.append(self.joint_forces(y, road(end), touching))
        joints = {
            name: np.array([forces[name] for forces in carried]) for name in self.system.joints
        }
        rows = np.array([kept[float(t)] for t in times])
        forces = {
            f"{name}.f{x}": joints[name][:, i] for name in joints for i, x in enumerate("xyz")
        }
        found = dict(zip(self.NAMES, rows.T, strict=True)) | forces
        return found | {"violation": worst, "events": np.array(events)}

    def _piece(self, road, t: float, end: float, y, touching: bool, rtol: float, atol: float):
        """To the end, or to the first contact event before it."""
        middle = 0.5 * (t + end)
        height = road if road.edges[0] < middle < road.edges[1] else (lambda _: 0.0)

        def rate(s, x):
            return _rate(
                x, self.stiffness * self.deflection(x, height(s)) if touching else 0.0, *self.model
            )

        def gap(s, x):
            return self.deflection(x, height(s))

        solver = DOP853(rate, t, y, end, rtol=rtol, atol=atol, first_step=min(end - t, 1e-3))
        while solver.status == "running":
            solver.step()
            wrong = gap(solver.t, solver.y) < 0.0 if touching else gap(solver.t, solver.y) > 0.0
            if self.unilateral and wrong:
                dense = solver.dense_output()
                low = solver.t_old
                if (
                    gap(low, dense(low)) > 0.0
                ) != touching:  # just switched: rounding at the start is no event
                    low += 1e-9
                guess = brentq(_gap_of(gap, dense), low, solver.t, xtol=1e-16, rtol=1e-15)
                event, x = self._polished(rate, gap, dense, (t, y), guess, rtol, atol)
                return event, x, not touching, event
        return end, solver.y, touching, None

    def _polished(self, rate, gap, dense, start: tuple, event: float, rtol: float, atol: float):
        """Move an event of the dense output to where the integrated gap is zero; give it and the state there."""
        for _ in range(3):
            exact = DOP853(
                rate, *start, event, rtol=rtol, atol=atol, first_step=min(event - start[0], 1e-3)
            )
            while exact.status == "running":
                exact.step()
            slope = (gap(event, exact.y) - gap(event - 1e-7, dense(event - 1e-7))) / 1e-7
            shift = gap(event, exact.y) / slope
            if abs(shift) < 1e-15:
                break
            event -= shift
        return event, exact.y


def _gap_of(gap, dense):
    return lambda s: gap(s, dense(s))


def double_wishbone(
    points: dict, bodies: dict, strut: dict, *, gravity: float = 9.81, strut_on="lower_arm"
) -> System:
    """Body on a vertical guide, two arms on hinges, an upright on ball joints, a massless tie rod, one spring-damper.

    ``bodies`` maps chassis, lower_arm, upper_arm and upright to (mass, centre of mass, six inertia elements); ``strut``
    holds rate, damping and free_length.
    """
    p = {name: np.array(point, float) for name, point in points.items()}
    system = System(gravity=gravity)
    number = {
        name: system.body(*bodies[name])
        for name in ("chassis", "lower_arm", "upper_arm", "upright")
    }
    chassis = number["chassis"]
    system.prismatic(0, chassis, system.centre[0], (0.0, 0.0, 1.0))
    for arm in ("lower", "upper"):
        front, rear = p[f"{arm}_arm_front"], p[f"{arm}_arm_rear"]
        hinge = chassis, number[f"{arm}_arm"], (front + rear) / 2.0, front - rear
        system.named(f"{arm}_arm", system.revolute, *hinge)
        ball = number[f"{arm}_arm"], number["upright"], p[f"{arm}_ball_joint"]
        system.named(f"{arm}_ball_joint", system.together, *ball)
    system.named(
        "tie_rod", system.rod, chassis, number["upright"], p["tie_rod_inner"], p["tie_rod_outer"]
    )
    law = strut["rate"], strut["damping"], strut["free_length"]
    system.spring(chassis, number[strut_on], p["strut_top"], p["strut_bottom"], *law)
    system.wheel, system.hub = number["upright"], tuple(p["wheel_centre"])
    return system


def prototype(description: dict, *, unilateral: bool) -> Corner:
    """The double wishbone of the prototype from its JSON description."""
    h, b, s = description["hardpoints"], description["bodies"], description["strut"]
    reach = np.array([0.1, 0.0, 0.0])
    points = {
        "lower_arm_front": h["P_L"] + reach,
        "lower_arm_rear": h["P_L"] - reach,
        "upper_arm_front": h["P_U"] + reach,
        "upper_arm_rear": h["P_U"] - reach,
        "lower_ball_joint": h["BJ_L"],
        "upper_ball_joint": h["BJ_U"],
        "tie_rod_inner": h["T_C"],
        "tie_rod_outer": h["T_U"],
        "strut_top": h["S_C"],
        "strut_bottom": h["S_A"],
        "wheel_centre": h["W"],
    }
    bodies = {
        name: (b[name]["mass"], b[name]["com"], b[name]["inertia"])
        for name in b
        if name != "chassis"
    }
    bodies["chassis"] = (
        b["chassis"]["mass"],
        (0.0, 0.0, 0.2),
        (1.0, 1.0, 1.0, 0.0, 0.0, 0.0),
    )  # it does not turn
    strut = {"rate": s["k"], "damping": s["c"], "free_length": s["L0"]}
    system = double_wishbone(points, bodies, strut, gravity=description["gravity"])
    return Corner(
        system, description["tyre"]["k"], description["tyre"]["R0"], unilateral=unilateral
    )
