"""Model predictive control with road preview: one quadratic programme per instant and corner."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar, Literal

import casadi as ca
import numpy as np

from jounce.control.actuators import (
    ActiveActuator,
    Actuator,
    AnyActuator,
    Instant,
    SemiActiveDamper,
)
from jounce.control.controller import (
    CallbackController,
    CommandLimits,
    Regulator,
    RunSetting,
    or_default,
)
from jounce.control.design import CornerModel, corner_equations, corner_outputs, discretise
from jounce.control.laws import ForceWeight, Weight
from jounce.core.errors import SimulationError
from jounce.core.phrases import Phrase
from jounce.core.text import qualify
from jounce.core.types import Array
from jounce.core.units import Frequency, PositiveLength, PositiveTime

_CHANNELS = ("strut.deflection", "sprung.vz", "tyre.deflection", "unsprung.vz", "strut.velocity")
_SOLVERS = ("daqp", "qrqp")
_QUIET: dict[str, dict[str, Any]] = {
    "daqp": {},
    "qrqp": {"print_iter": False, "print_header": False, "print_info": False},
}
_SOFT = (
    1e6,
    3.0,
)  # weights of stroke and contact violations, relative to those of the deflections
_LONGEST = 200  # maximum number of steps of a plan
_SLACK = 1e-2  # m: scale of the slack variables
_CHEAP = 1e-3  # weight of a lagged force, relative to the weight of the acceleration it causes


class PreviewMPC(CallbackController):
    """Model predictive control with road preview; CasADi's QP interface solves the optimisation.

    The cost is that of the regulator over ``preview``, plus the regulator's cost-to-go. A damper's force is bounded by
    its limits at the velocities predicted by the previous plan, so the problem remains a quadratic programme. Stroke
    and tyre load are soft constraints. The prediction includes the lag of an active actuator, but not that of a damper.

    Attributes
    ----------
    preview : float
        Preview time of the road and prediction horizon, s.
    stroke : float or None
        Maximum suspension deflection from equilibrium at the wheel, m; default: no limit.
    keep_contact : bool
        Whether to keep the tyre load above zero.
    deflection_weight, tyre_weight : float or None
        Weights of suspension and tyre deflection relative to body acceleration, 1/s^4; default: 1 and 10 times the
        fourth power of the body's natural angular frequency.
    force_weight : float
        Weight of the force, 1/kg^2.
    """

    law: Literal["mpc"] = "mpc"
    rate: Frequency = 200.0
    preview: PositiveTime = 0.08
    stroke: PositiveLength | None = None
    keep_contact: bool = True
    deflection_weight: Weight | None = None
    tyre_weight: Weight | None = None
    force_weight: ForceWeight = 0.0
    actuator: Actuator = SemiActiveDamper()
    catalogue: ClassVar = {
        "mpc": (
            "model predictive control with preview of the road, with a damper",
            SemiActiveDamper(),
        ),
        "active-mpc": (
            "model predictive control with preview of the road, active",
            ActiveActuator(),
        ),
    }
    needs_wheel: ClassVar[bool] = True

    def regulator(self, setting: RunSetting) -> Regulator:
        """Return the object that the loop calls."""
        return _Planner(self, setting)


@dataclass(frozen=True)
class _Horizon:
    """Prediction ``X = Fx x + Fu U + Fw W`` of the stacked states over the horizon, and matrices of the QP.

    Each instant has ``states`` states: the corner's four, then those of a force actuator. ``own`` are the actuator's
    matrices.
    """

    states: int
    own: tuple[Array, Array]

    Fx: Array
    Fu: Array
    Fw: Array
    H: Array
    gx: Array
    gw: Array
    rows: Array
    margin: Array


def _horizon(mpc: PreviewMPC, corner: CornerModel, steps: int) -> _Horizon:
    """Condense the problem of a corner; its variables are the forces and two slacks."""
    from scipy.linalg import block_diag, solve_discrete_are

    base = 0.0 if mpc.actuator.replaces_damper else None
    A, B, G = corner_equations(corner, base)
    C, D = corner_outputs(corner, ("sprung.az",), base)
    A, B, G, C, D = _add_lag(mpc.actuator, A, B, G, C, D)
    n = len(A)
    F, both, _ = discretise(A, np.hstack([B, G]), np.zeros((n, n)), 1.0 / mpc.rate)
    H, V = both[:, :1], both[:, 1:]
    square = (corner.spring_rate / corner.sprung_mass) ** 2
    weights = or_default(mpc.deflection_weight, square), or_default(mpc.tyre_weight, 10.0 * square)
    price = max(mpc.force_weight, _CHEAP / corner.sprung_mass**2 if n > 4 else 0.0)
    Q = C.T @ C + np.diag([weights[0], 0.0, weights[1], *np.zeros(n - 3)])
    R, S = D.T @ D + price, C.T @ D
    P = solve_discrete_are(F, H, Q, R, s=S)
    powers = [np.linalg.matrix_power(F, i) for i in range(steps + 1)]
    Fx = np.vstack(powers)  # states at 0 .. steps
    Fu, Fw = np.zeros((n * (steps + 1), steps)), np.zeros((n * (steps + 1), steps))
    for i in range(1, steps + 1):
        for j in range(i):
            Fu[n * i : n * i + n, j : j + 1] = powers[i - 1 - j] @ H
            Fw[n * i : n * i + n, j : j + 1] = powers[i - 1 - j] @ V
    whole = block_diag(*[Q] * steps, P)
    cross = np.zeros((n * (steps + 1), steps))
    for i in range(steps):
        cross[n * i : n * i + n, i : i + 1] = S
    hessian = Fu.T @ whole @ Fu + Fu.T @ cross + cross.T @ Fu + R[0, 0] * np.eye(steps)
    gx, gw = (Fu.T @ whole + cross.T) @ Fx, (Fu.T @ whole + cross.T) @ Fw
    rows, margin = _limits(mpc, corner, steps, n)
    slack = np.array(_SOFT) * np.maximum(weights, 1.0)
    return _Horizon(
        n,
        (F[4:, 4:], H[4:, 0]),
        Fx,
        Fu,
        Fw,
        block_diag(hessian, np.diag(slack)),
        gx,
        gw,
        rows,
        margin,
    )


def _add_lag(
    actuator: AnyActuator, A: Array, B: Array, G: Array, C: Array, D: Array
) -> tuple[Array, Array, Array, Array, Array]:
    """Add the states of a force actuator to the corner model; the lag of a damper is neglected."""
    if not isinstance(actuator, ActiveActuator) or not actuator.order:
        return A, B, G, C, D
    own, drive = actuator.equations
    n, m = len(A), len(own)
    first = np.eye(1, m)
    whole = np.block([[A, B @ first], [np.zeros((m, n)), own]])
    none = np.zeros((m, 1))
    return (
        whole,
        np.vstack([np.zeros((n, 1)), drive]),
        np.vstack([G, none]),
        np.hstack([C, D @ first]),
        0.0 * D,
    )


def _limits(mpc: PreviewMPC, corner: CornerModel, steps: int, states: int) -> tuple[Array, Array]:
    """Return rows that select the limited states, and their limits (m)."""
    limited: list[tuple[int, float, float]] = []  # state, sign, limit
    if mpc.stroke is not None:
        limited += [(0, 1.0, mpc.stroke), (0, -1.0, mpc.stroke)]
    if mpc.keep_contact:
        weight = (corner.sprung_mass + corner.unsprung_mass) * corner.gravity
        limited.append((2, 1.0, weight / corner.tyre_stiffness))
    rows, margin = [], []
    for i in range(1, steps + 1):
        for state, sign, limit in limited:
            row = np.zeros(states * (steps + 1) + 2)
            row[states * i + state] = sign
            row[-2 if state == 0 else -1] = -1.0
            rows.append(row)
            margin.append(limit)
    return np.array(rows).reshape(-1, states * (steps + 1) + 2), np.array(margin)


class _Planner:
    """Regulator with one plan per corner."""

    from_rest = True
    findings = ()

    def __init__(self, mpc: PreviewMPC, setting: RunSetting) -> None:
        corners = tuple(setting.controllers)
        self.channels = tuple(qualify(corner, name) for corner in corners for name in _CHANNELS)
        self._limits = CommandLimits(setting.controllers)
        steps = max(round(mpc.preview * mpc.rate), 1)
        if steps > _LONGEST:
            raise SimulationError(
                "the plan has too many steps",
                where="mpc: preview, rate",
                found=f"{steps} (preview times rate)",
                allowed=Phrase("at most {longest}", longest=_LONGEST),
                hint="Lower the control rate or shorten the preview; 50 to 100 ms are usual.",
            )
        times = np.arange(setting.instants + steps + 1) / mpc.rate
        self._plans = [
            _Plan(
                mpc,
                setting.controllers[name].actuator,
                setting.models[name],
                steps,
                setting.road(name, times),
            )
            for name in corners
        ]
        self._instant = 0

    def start(self) -> None:
        """Start a run."""
        self._instant = 0
        self._limits.start()
        for plan in self._plans:
            plan.forget()

    def answer(self, rest: Array) -> None:
        """Return None: a plan has no closed-form derivatives."""

    def __call__(self, values: list[float]) -> list[float]:
        """Return commands from measurements."""
        count = len(_CHANNELS)
        commands = []
        for i, (plan, last) in enumerate(zip(self._plans, self._limits.last, strict=True)):
            if self._instant:
                plan.follow(last)
            commands.append(plan.command(values[i * count : (i + 1) * count], self._instant))
        self._instant += 1
        return self._limits.apply(commands)


class _Plan:
    """Optimisation problem of one corner, solved at every instant."""

    def __init__(
        self, mpc: PreviewMPC, actuator: AnyActuator, corner: CornerModel, steps: int, road: Array
    ) -> None:
        self._steps, self._corner = steps, corner
        self._horizon = _horizon(mpc, corner, steps)
        self._bumps = np.diff(road) * mpc.rate  # mean velocity of the road in each period
        self._bounds, self._command = _actuator_functions(actuator, corner, steps)
        horizon = self._horizon
        self._unit = 0.1 * corner.sprung_mass * corner.gravity  # N: scale of the forces
        self._units = np.append(np.full(steps, self._unit), [_SLACK, _SLACK])
        columns = np.vstack(
            [np.hstack([horizon.Fu, np.zeros((len(horizon.Fu), 2))]), np.zeros((2, steps + 2))]
        )
        columns[-2, -2] = columns[-1, -1] = 1.0
        self._rows = horizon.rows @ columns * self._units
        hessian = horizon.H * self._units[:, None] * self._units
        shape = {
            "h": ca.Sparsity.dense(*horizon.H.shape),
            "a": ca.Sparsity.dense(*self._rows.shape),
        }
        name = next((name for name in _SOLVERS if ca.has_conic(name)), None)
        if name is None:
            raise SimulationError(
                "this build of CasADi has no solver for quadratic programmes",
                allowed=", ".join(_SOLVERS),
            )
        self._solver = ca.conic("plan", name, shape, {**_QUIET[name], "error_on_fail": False})
        scale = np.trace(hessian[:steps, :steps]) / steps
        self._h, self._a, self._scale = (
            ca.DM(hessian / scale),
            ca.DM(self._rows),
            self._units / scale,
        )
        self.forget()

    def forget(self) -> None:
        """Reset the previous plan."""
        self._forces = np.zeros(self._steps)
        self._own = np.zeros(self._horizon.states - 4)

    def follow(self, command: float) -> None:
        """Advance the actuator's force by one period with its last command."""
        F, H = self._horizon.own
        self._own = F @ self._own + H * command * self._corner.motion_ratio

    def command(self, values: list[float], instant: int) -> float:
        """Return the command at an instant from its measurements."""
        r, horizon, n = self._corner.motion_ratio, self._horizon, self._steps
        deflection, body, tyre, wheel, velocity = values
        x = np.array([-deflection / r, body, -tyre, wheel, *self._own])
        w = self._bumps[instant : instant + n]
        free = horizon.Fx @ x + horizon.Fw @ w
        expected = (free + horizon.Fu @ np.append(self._forces[1:], self._forces[-1])).reshape(
            -1, horizon.states
        )[:n]
        along = r * (expected[:, 3] - expected[:, 1])
        along[0] = velocity
        low, high = self._bounds(along, -r * expected[:, 0])
        gradient = np.append(horizon.gx @ x + horizon.gw @ w, [0.0, 0.0]) * self._scale
        room = horizon.margin - horizon.rows[:, :-2] @ free
        forces = self._solve(gradient, np.minimum(low, high) * r, np.maximum(low, high) * r, room)
        self._forces = forces
        return float(self._command(float(forces[0]) / r, velocity, deflection))

    def _solve(self, gradient: Array, low: Array, high: Array, room: Array) -> Array:
        """Solve for the planned forces (N, at the wheel); without a solution, clip those of the previous plan."""
        none = np.zeros(2)
        solution = self._solver(
            h=self._h,
            g=gradient,
            a=self._a,
            lba=np.full(len(room), -np.inf),
            uba=room,
            lbx=np.append(low / self._unit, none),
            ubx=np.append(high / self._unit, none + np.inf),
        )
        forces = np.asarray(solution["x"]).ravel()[: self._steps] * self._unit
        if not self._solver.stats()["success"] or not np.all(np.isfinite(forces)):
            forces = np.append(self._forces[1:], self._forces[-1])
        return np.asarray(np.clip(forces, low, high), dtype=np.float64)


def _actuator_functions(actuator: AnyActuator, corner: CornerModel, steps: int) -> tuple[Any, Any]:
    """Return two functions: force bounds (N) at velocities and deflections, and the command for a force."""
    low, high = actuator.limits
    if isinstance(actuator, ActiveActuator):
        return (lambda v, _: (np.full(len(v), low), np.full(len(v), high))), (lambda f, _v, _x: f)
    if isinstance(actuator, SemiActiveDamper):

        def coefficient(force: float, velocity: float, _: float) -> float:
            if force * velocity <= 0.0:
                return low
            return min(max(force / velocity, low), high)

        return (lambda v, _: (low * v, high * v)), coefficient
    known = {
        **actuator.plant_numbers,
        "minimum": low,
        "maximum": high,
        "static_deflection": corner.static_deflection,
    }
    force, velocity, deflection = (ca.SX.sym(name) for name in ("force", "velocity", "deflection"))
    seen = {"strut.velocity": velocity, "strut.deflection": deflection}
    now = Instant(seen.__getitem__, lambda name: ca.SX(known[name]), ca.SX(0.0))
    ends = [actuator.force_of(now.between(ca.SX(level)), now) for level in (0.0, 1.0)]
    bounds = ca.Function("bounds", [velocity, deflection], ends).map(steps)
    command = ca.Function(
        "command", [force, velocity, deflection], [actuator.command_for_force(force, now)]
    )

    def both(v: Array, x: Array) -> tuple[Array, Array]:
        values = bounds(v[None, :], x[None, :])
        return np.asarray(values[0]).ravel(), np.asarray(values[1]).ravel()

    return both, lambda f, v, x: float(command(f, v, x))
