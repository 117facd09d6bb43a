"""Pinocchio with SciPy: tree in joint coordinates, four loop rows solved in one dense system, DOP853 with events."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from math import sin, sqrt
from time import perf_counter

import numpy as np
from mechanism_problem import DURATION, TIMES, Array, Case


class Wishbone:
    """The model: body, lower arm, upright (ball joint as z-y-x angles) and upper arm; the rest closes loops."""

    def __init__(self, case: Case) -> None:
        import pinocchio as pin

        self.case, self.pin = case, pin
        h, model = case.points, pin.Model()
        model.gravity.linear = np.array([0.0, 0.0, -case.model["gravity"]])

        def joint(parent: int, kind, place: Array, name: str, origin: Array) -> int:
            number = model.addJoint(parent, kind, pin.SE3(np.eye(3), place), name)
            mass, centre, tensor = case.inertia(name)
            model.appendBodyToJoint(
                number, pin.Inertia(mass, centre - origin, tensor), pin.SE3.Identity()
            )
            return number

        chassis = model.addJoint(0, pin.JointModelPZ(), pin.SE3.Identity(), "chassis")
        mass = case.model["bodies"]["chassis"]["mass"]
        model.appendBodyToJoint(
            chassis, pin.Inertia(mass, np.zeros(3), np.eye(3)), pin.SE3.Identity()
        )
        lower = joint(chassis, pin.JointModelRX(), h["P_L"], "lower_arm", h["P_L"])
        upright = joint(
            lower, pin.JointModelSphericalZYX(), h["BJ_L"] - h["P_L"], "upright", h["BJ_L"]
        )
        upper = joint(chassis, pin.JointModelRX(), h["P_U"], "upper_arm", h["P_U"])

        def frame(name: str, body: int, origin: Array, point: str) -> int:
            return model.addFrame(
                pin.Frame(name, body, pin.SE3(np.eye(3), h[point] - origin), pin.FrameType.OP_FRAME)
            )

        self.ball = frame("ball of the upright", upright, h["BJ_L"], "BJ_U")
        self.arm_end = frame("end of the upper arm", upper, h["P_U"], "BJ_U")
        self.rod_end = frame("rod", upright, h["BJ_L"], "T_U")
        self.seat = frame("strut", lower, h["P_L"], "S_A")
        self.hub = frame("hub", upright, h["BJ_L"], "W")
        self.model, self.data = model, model.createData()

    def right_hand_side(
        self, road: Callable[[float], float], touching: bool
    ) -> Callable[[float, Array], Array]:
        """``x' = f(t, x)`` with x = (q, v)."""
        from scipy.linalg.lapack import dgesv

        pin, model, data = self.pin, self.model, self.data
        h, strut, tyre = self.case.points, self.case.model["strut"], self.case.model["tyre"]
        rate, damping, free_length = strut["k"], strut["c"], strut["L0"]
        stiffness, radius = (tyre["k"] if touching else 0.0), tyre["R0"]
        top, inner, axes, still = (
            h["S_C"].copy(),
            h["T_C"].copy(),
            pin.LOCAL_WORLD_ALIGNED,
            np.zeros(6),
        )
        ball, arm_end, rod_end, seat, hub = (
            self.ball,
            self.arm_end,
            self.rod_end,
            self.seat,
            self.hub,
        )
        system, right, out = np.zeros((10, 10), order="F"), np.zeros(10), np.empty(12)

        def f(t: float, x: Array) -> Array:
            q, v = x[:6], x[6:]
            pin.computeAllTerms(model, data, q, v)
            pin.forwardKinematics(model, data, q, v, still)
            pin.updateFramePlacements(model, data)
            places = data.oMf
            d_strut = places[seat].translation - top
            d_strut[2] -= q[0]
            length = sqrt(d_strut @ d_strut)
            along = d_strut @ pin.getFrameJacobian(model, data, seat, axes)[:3] / length
            along[0] -= d_strut[2] / length
            force = rate * (free_length - length) - damping * (along @ v)
            load = stiffness * (radius + road(t) - places[hub].translation[2])
            d_rod = places[rod_end].translation - inner
            d_rod[2] -= q[0]
            rows = (
                pin.getFrameJacobian(model, data, ball, axes)[:3]
                - pin.getFrameJacobian(model, data, arm_end, axes)[:3]
            )
            rod = pin.getFrameJacobian(model, data, rod_end, axes)[:3]
            rod[2, 0] -= 1.0
            speed = rod @ v
            system[:6, :6] = data.M
            system[6:9, :6] = rows
            system[:6, 6:9] = rows.T
            system[9, :6] = system[:6, 9] = d_rod @ rod
            right[:6] = (
                force * along + load * pin.getFrameJacobian(model, data, hub, axes)[2] - data.nle
            )
            right[6:9] = (
                pin.getFrameClassicalAcceleration(model, data, arm_end, axes).linear
                - pin.getFrameClassicalAcceleration(model, data, ball, axes).linear
            )
            right[9] = (
                -speed @ speed
                - d_rod @ pin.getFrameClassicalAcceleration(model, data, rod_end, axes).linear
            )
            out[:6] = v
            out[6:] = dgesv(system, right)[2][:6]
            return out.copy()

        return f

    def hub_height(self, q: Array) -> float:
        """Height of the wheel centre, m."""
        self.pin.forwardKinematics(self.model, self.data, q)
        return self.pin.updateFramePlacement(self.model, self.data, self.hub).translation[2]


def prepared(case: Case) -> Callable[[float], tuple[float, Array, Array]]:
    """``run(tolerance) -> (seconds, zs, zu)`` on the prepared model."""
    wishbone = Wishbone(case)
    height, wave, start = case.bump
    radius = case.model["tyre"]["R0"]

    def on_bump(t: float) -> float:
        return height * sin(wave * (t - start))

    roads = (lambda _: 0.0), on_bump, (lambda _: 0.0)
    functions = [
        [wishbone.right_hand_side(road, touching) for touching in (False, True)] for road in roads
    ]

    def run(tolerance: float) -> tuple[float, Array, Array]:
        begin = perf_counter()
        states = _integrate(case, wishbone, functions, roads, radius, tolerance)
        zu = np.array([wishbone.hub_height(q) for q in states[:, :6]]) - case.points["W"][2]
        return perf_counter() - begin, states[:, 0], zu

    return run


def _integrate(
    case: Case, wishbone: Wishbone, functions, roads, radius: float, tolerance: float
) -> Array:
    """DOP853 step by step, restarted at the road's edges and where the tyre leaves or meets the road."""
    from scipy.integrate import DOP853

    x, touching, parts = np.zeros(12), True, [np.zeros((1, 12))]
    atol = tolerance * np.repeat([1e-2, 1e0], 6)
    for (begin, end), pair, road in zip(
        pairwise((0.0, *case.edges, DURATION)), functions, roads, strict=True
    ):
        t = begin

        def gap(s: float, y: Array, road=road) -> float:
            return radius + road(s) - wishbone.hub_height(y[:6])

        while t < end:
            solver = DOP853(pair[touching], t, x, end, rtol=tolerance, atol=atol)
            while solver.status == "running":
                solver.step()
                dense, switched = (
                    None,
                    case.unilateral and (gap(solver.t, solver.y) > 0.0) != touching,
                )
                low, high = solver.t_old, solver.t
                if switched:
                    dense = solver.dense_output()
                    high = _switch(gap, dense, low, high, touching)
                at = TIMES[(low < TIMES) & (high >= TIMES)]
                if len(at):
                    dense = dense or solver.dense_output()
                    parts.append(dense(at).T)
                if switched:
                    t, x, touching = high, dense(high), not touching
                    break
            else:
                t, x = end, solver.y
    return np.concatenate(parts)


def _switch(gap, dense, low: float, high: float, touching: bool) -> float:
    """Time at which the gap has just changed its sign, or the end of the step if it had it wrong from the start."""
    from scipy.optimize import brentq

    inside = np.linspace(low, high, 9)
    right = [s for s in inside if (gap(s, dense(s)) > 0.0) == touching]
    return brentq(lambda s: gap(s, dense(s)), right[-1], high, xtol=1e-14) if right else high
