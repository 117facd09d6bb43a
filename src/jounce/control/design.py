"""Corner model for controller design, with design of regulators, Kalman filters and H-infinity controllers."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from jounce.core.constants import GRAVITY
from jounce.core.errors import SimulationError
from jounce.core.optional import require
from jounce.core.shown import Shown
from jounce.core.types import Array

_TYPICAL_RATIO = 0.3  # default damping ratio of the body for a corner without a damper


@dataclass(frozen=True)
class CornerModel(Shown):
    """Quarter car of one corner: the plant model of a decentralised controller.

    Attributes
    ----------
    sprung_mass : float
        Sprung mass carried by this corner, kg.
    unsprung_mass : float
        Unsprung mass, kg; 0 for a massless axle.
    spring_rate : float
        Wheel rate (spring at the wheel), N/m.
    tyre_stiffness : float
        Tyre stiffness, N/m; 0 for a massless axle.
    damping_coefficient : float
        Coefficient of the corner's own damper at the wheel, N s/m.
    motion_ratio : float
        Strut travel over wheel travel, 1.
    gravity : float
        Gravity, m/s^2.
    static_deflection : float
        Strut deflection at rest, m.
    """

    sprung_mass: float
    unsprung_mass: float
    spring_rate: float
    tyre_stiffness: float
    damping_coefficient: float
    motion_ratio: float = 1.0
    gravity: float = GRAVITY
    static_deflection: float = 0.0

    @property
    def reference_damping(self) -> float:
        """Coefficient (N s/m, at the strut) from which default bounds and gains are derived."""
        wheel = self.damping_coefficient
        if wheel <= 0.0:
            wheel = 2.0 * _TYPICAL_RATIO * math.sqrt(self.spring_rate * self.sprung_mass)
        return wheel / self.motion_ratio**2


def corner_equations(
    corner: CornerModel, damping_coefficient: float | None = None
) -> tuple[Array, Array, Array]:
    """Return matrices ``A``, ``B``, ``G`` of ``dx/dt = A x + B u + G w``: ``u`` lifts the body (N), ``w`` is road.vz.

    States: sprung.z - unsprung.z (m), sprung.vz (m/s), unsprung.z - road.z (m), unsprung.vz (m/s). In all functions
    of this module, ``damping_coefficient`` (N s/m at the wheel) replaces the corner's own damper.
    """
    m_s, m_u, k, k_t = (
        corner.sprung_mass,
        corner.unsprung_mass,
        corner.spring_rate,
        corner.tyre_stiffness,
    )
    c = corner.damping_coefficient if damping_coefficient is None else damping_coefficient
    A = np.array(
        [
            [0.0, 1.0, 0.0, -1.0],
            [-k / m_s, -c / m_s, 0.0, c / m_s],
            [0.0, 0.0, 0.0, 1.0],
            [k / m_u, c / m_u, -k_t / m_u, -c / m_u],
        ]
    )
    B = np.array([[0.0], [1.0 / m_s], [0.0], [-1.0 / m_u]])
    G = np.array([[0.0], [0.0], [-1.0], [0.0]])
    return A, B, G


def corner_outputs(
    corner: CornerModel, channels: tuple[str, ...], damping_coefficient: float | None = None
) -> tuple[Array, Array]:
    """Return matrices ``C``, ``D`` of channels (changes from static equilibrium, SI) from states and force (N)."""
    A, B, _ = corner_equations(corner, damping_coefficient)
    r, eye = corner.motion_ratio, np.eye(4)
    zero = np.zeros(1)
    known = {
        "strut.deflection": (-r * eye[0], zero),
        "strut.velocity": (r * (eye[3] - eye[1]), zero),
        "sprung.vz": (eye[1], zero),
        "sprung.az": (A[1], B[1]),
        "tyre.deflection": (-eye[2], zero),
        "tyre.force": (-corner.tyre_stiffness * eye[2], zero),
        "unsprung.vz": (eye[3], zero),
        "unsprung.az": (A[3], B[3]),
    }
    rows = [known[name] for name in channels]
    return np.array([row for row, _ in rows]), np.array([column for _, column in rows])


@dataclass(frozen=True)
class Weights:
    """Cost ``J = integral of az^2 + deflection x1^2 + tyre x3^2 + force u^2`` over time.

    Attributes
    ----------
    deflection, tyre : float
        Weights of suspension and tyre deflection, 1/s^4.
    force : float
        Weight of the force, 1/kg^2.
    """

    deflection: float
    tyre: float
    force: float


def cost_matrices(
    corner: CornerModel, weights: Weights, damping_coefficient: float | None = None
) -> tuple[Array, Array, Array]:
    """Return matrices ``Q``, ``R``, ``S`` of the cost ``x'Qx + u'Ru + 2 x'Su``."""
    C, D = corner_outputs(corner, ("sprung.az",), damping_coefficient)
    Q = C.T @ C + np.diag([weights.deflection, 0.0, weights.tyre, 0.0])
    R = D.T @ D + weights.force
    return np.asarray(Q), np.asarray(R), np.asarray(C.T @ D)


def regulator_gains(
    corner: CornerModel, weights: Weights, damping_coefficient: float | None = None
) -> Array:
    """Return gains ``K`` (N/m, N s/m, N/m, N s/m) of the optimal force ``u = -K x`` on the body [hrovat1997]."""
    from scipy.linalg import solve_continuous_are

    A, B, _ = corner_equations(corner, damping_coefficient)
    Q, R, S = cost_matrices(corner, weights, damping_coefficient)
    try:
        X = solve_continuous_are(A, B, Q, R, s=S)
    except (np.linalg.LinAlgError, ValueError) as error:
        raise SimulationError(
            "no regulator gains were found",
            where="lqr",
            found=str(error),
            hint="Check the weights and the corner.",
        ) from None
    gains: Array = np.linalg.solve(R, B.T @ X + S.T)[0]
    return gains


@dataclass(frozen=True)
class Observer:
    """Discrete Kalman filter: ``x- = F x + H u``, ``x = x- + L (y - C x- - D u)``."""

    F: Array
    H: Array
    L: Array
    C: Array
    D: Array


def observer(
    corner: CornerModel,
    channels: tuple[str, ...],
    deviations: Array,
    roughness: float,
    disturbance: float,
    period: float,
    damping_coefficient: float | None = None,
) -> Observer:
    """Return the steady-state Kalman filter of the corner on a road whose velocity is white noise.

    ``deviations`` are the standard deviations of the measured ``channels`` (SI), ``roughness`` is the intensity of the
    road's velocity (m^2/s), ``disturbance`` that of unmodelled accelerations of body and wheel (m^2/s^3),
    ``period`` the control period (s).
    """
    from scipy.linalg import solve_discrete_are

    A, B, G = corner_equations(corner, damping_coefficient)
    C, D = corner_outputs(corner, channels, damping_coefficient)
    unknown = np.diag([0.0, disturbance, 0.0, disturbance])
    F, H, spread = discretise(A, B, roughness * G @ G.T + unknown, period)
    noise = np.diag(np.asarray(deviations) ** 2)
    try:
        P = solve_discrete_are(F.T, C.T, spread, noise)
    except (np.linalg.LinAlgError, ValueError) as error:
        raise SimulationError("no Kalman filter was found", where="lqg", found=str(error)) from None
    L = np.linalg.solve(C @ P @ C.T + noise, C @ P).T
    return Observer(F, H[:, 0], np.asarray(L), C, D[:, 0])


def discretise(A: Array, B: Array, intensity: Array, period: float) -> tuple[Array, Array, Array]:
    """Discretise with a held input; return state matrix, input matrix and noise covariance [vanloan1978]."""
    from scipy.linalg import expm

    n, m = B.shape
    held = np.zeros((n + m, n + m))
    held[:n, :n], held[:n, n:] = A, B
    whole = expm(held * period)
    both = np.zeros((2 * n, 2 * n))
    both[:n, :n], both[:n, n:], both[n:, n:] = -A, intensity, A.T
    exponential = expm(both * period)
    return whole[:n, :n], whole[:n, n:], exponential[n:, n:].T @ exponential[:n, n:]


@dataclass(frozen=True)
class Dynamic:
    """Discrete linear controller: ``x+ = A x + B y``, ``u = C x + D y``."""

    A: Array
    B: Array
    C: Array
    D: Array


H_INFINITY_CHANNELS = ("strut.deflection", "sprung.az")
H_INFINITY_ORDER = 6  # four corner states, actuator force, and one state of the force weight


@dataclass(frozen=True)
class Targets:
    """Disturbances of an H-infinity controller, and scales of the outputs that it minimises.

    Attributes
    ----------
    road : float
        Height of the road's disturbance, m.
    acceleration, deflection : float
        Body acceleration (m/s^2) and suspension deflection (m) that are weighted equally.
    force : float
        Force (N) at low frequency with the same weight.
    noise : tuple of float
        Noise of the two measurements, m and m/s^2.
    """

    road: float
    acceleration: float
    deflection: float
    force: float
    noise: tuple[float, float]


@lru_cache(maxsize=64)
def h_infinity(
    corner: CornerModel,
    targets: Targets,
    actuator_rate: float,
    period: float,
    damping_coefficient: float | None = None,
) -> tuple[Dynamic, float]:
    """Return an H-infinity controller from suspension deflection and body acceleration to force, and its norm.

    SLICOT does the synthesis. ``actuator_rate`` is the corner frequency of the actuator's first-order lag (rad/s). The
    controller is discretised by Tustin's method with the control ``period`` (s).
    """
    from scipy.signal import cont2discrete

    slycot = require("slycot", "control")
    plant, scale = _build_plant(corner, targets, actuator_rate, damping_coefficient)

    def synthesise(bound: float) -> tuple[Array, ...] | None:
        a, b, c, d = (part.copy() for part in plant)
        try:
            synthesis = slycot.sb10fd(len(a), b.shape[1], len(c), 1, 2, bound, a, b, c, d)
        except (slycot.exceptions.SlycotError, ValueError):
            return None
        controller = tuple(np.asarray(part) for part in synthesis[:4])
        # SLICOT may return a controller that misses its bound; 1 % is the tolerance of the minimum bound.
        return (
            controller if _norm(slycot, *_close_loop(plant, controller)) <= 1.01 * bound else None
        )

    norm = _find_least_bound(synthesise)
    controller = synthesise(_RELAXED * norm) if np.isfinite(norm) else None
    if controller is None:
        raise SimulationError(
            "no H-infinity controller was found",
            where="h-infinity",
            hint="Relax the targets for deflection and acceleration.",
        )
    A, B, C, D, _ = cont2discrete(controller, period, method="bilinear")
    measured, force = scale
    return Dynamic(A, B / measured, force * C, force * D / measured), _RELAXED * norm


def _close_loop(
    plant: tuple[Array, ...], controller: tuple[Array, ...]
) -> tuple[Array, Array, Array, Array]:
    """Close the loop of the generalised plant from its last two outputs to its last input."""
    (a, b, c, d), (A, B, C, D) = plant, controller
    b_w, b_u, c_z, c_y = b[:, :-1], b[:, -1:], c[:-2], c[-2:]
    d_zw, d_zu, d_yw = d[:-2, :-1], d[:-2, -1:], d[-2:, :-1]
    whole = np.block([[a + b_u @ D @ c_y, b_u @ C], [B @ c_y, A]])
    into = np.vstack([b_w + b_u @ D @ d_yw, B @ d_yw])
    return whole, into, np.hstack([c_z + d_zu @ D @ c_y, d_zu @ C]), d_zw + d_zu @ D @ d_yw


def _norm(slycot: Any, A: Array, B: Array, C: Array, D: Array) -> float:
    """Return the H-infinity norm of a system; infinite if it is unstable."""
    if np.max(np.linalg.eigvals(A).real) >= 0.0:
        return float("inf")
    n = len(A)
    try:
        peak, _ = slycot.ab13dd(
            "C", "I", "S", "D", n, B.shape[1], len(C), A, np.eye(n), B, C, D, tol=1e-4
        )
    except slycot.exceptions.SlycotError:
        return float("inf")
    return float(peak)


_RELAXED = 1.1  # relative to the minimum norm, at which the equations are ill-conditioned
_BOUNDS = 1e-2, 1e4  # search range of the norm, chosen: weights that need more are unreasonable


def _find_least_bound(synthesise: Callable[[float], tuple[Array, ...] | None]) -> float:
    """Find the minimum bound for which a controller exists, to 1 %; infinite if there is none."""
    low, high = _BOUNDS[0], 1.0
    while synthesise(high) is None:
        low, high = high, 2.0 * high
        if high > _BOUNDS[1]:
            return float("inf")
    while high > 1.01 * low:  # the controller itself is computed at 1.1 times the minimum
        middle = float(np.sqrt(low * high))
        low, high = (low, middle) if synthesise(middle) is not None else (middle, high)
    return high


def _build_plant(
    corner: CornerModel, targets: Targets, actuator_rate: float, damping_coefficient: float | None
) -> tuple[tuple[Array, Array, Array, Array], tuple[Array, float]]:
    """Build the generalised plant: (road, two noises, command) to (force, deflection, acceleration, two measurements).

    The road input is a height, so ``x3`` is the wheel height. ``x5`` is the force, ``x6`` the state of its weight
    ``(s + 50) / (s + 500)``. Signals are scaled to about 1; the scales of measurements and force are also returned.
    """
    A4, B4, _ = corner_equations(corner, damping_coefficient)
    C, D = corner_outputs(corner, H_INFINITY_CHANNELS, damping_coefficient)
    A, B, slow, fast = np.zeros((6, 6)), np.zeros((6, 4)), 50.0, 500.0
    A[:4, :4], A[:4, 4:5] = A4, B4
    B[3, 0] = corner.tyre_stiffness / corner.unsprung_mass * targets.road
    A[4, 4], B[4, 3] = -actuator_rate, actuator_rate
    A[5, 5], B[5, 3] = -fast, fast - slow
    outputs, through = np.zeros((5, 6)), np.zeros((5, 4))
    price = fast / slow / targets.force
    outputs[0, 5], through[0, 3] = -price, price
    outputs[1, 0] = 1.0 / targets.deflection
    outputs[2, :4], outputs[2, 4:5] = C[1] / targets.acceleration, D[1] / targets.acceleration
    outputs[3:, :4], outputs[3:, 4:5] = C, D
    through[3, 1], through[4, 2] = targets.noise
    force = 0.1 * targets.force
    measured = np.array([0.2 * targets.road, targets.acceleration])
    frequency = np.sqrt(corner.spring_rate / corner.sprung_mass)
    length = 0.2 * targets.road
    states = np.array([length, length * frequency, length, 5.0 * length * frequency, force, force])
    rows, columns = np.array([1.0, 1.0, 1.0, *measured]), np.array([1.0, 1.0, 1.0, force])
    scaled = (
        A * states / states[:, None],
        B * columns / states[:, None],
        outputs * states / rows[:, None],
        through * columns / rows[:, None],
    )
    return scaled, (measured, force)
