"""Control laws: formulas (skyhook, groundhook, ADD, PID), and designs from the corner model (LQR, LQG, H-infinity).

With a damper, a demanded force is clipped to the range of the damper.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Annotated, ClassVar, Literal

import casadi as ca
import numpy as np

from jounce.control.actuators import (
    FIRMEST,
    ActiveActuator,
    Actuator,
    AnyActuator,
    Instant,
    Lookup,
    SemiActiveDamper,
)
from jounce.control.controller import Controller, Decision, ForceLaw, TwoStateLaw, or_default
from jounce.control.design import (
    H_INFINITY_CHANNELS,
    H_INFINITY_ORDER,
    CornerModel,
    Targets,
    Weights,
    h_infinity,
    observer,
    regulator_gains,
)
from jounce.core.types import Array
from jounce.core.units import (
    DampingCoefficient,
    Frequency,
    NonNegativeDampingCoefficient,
    PositiveLength,
    Stiffness,
    Unit,
)

_Share = Annotated[float, Unit("1", at_least=0.0, at_most=1.0)]
_Inertance = Annotated[float, Unit("kg")]
_Time = Annotated[float, Unit("s", at_least=0.0)]
_Tracking = Annotated[float, Unit("s", above=0.0)]
Weight = Annotated[float, Unit("1/s^4", at_least=0.0)]
ForceWeight = Annotated[float, Unit("1/kg^2", at_least=0.0)]
_Disturbance = Annotated[float, Unit("m^2/s^3", at_least=0.0)]
_Roughness = Annotated[float, Unit("m^2/s", above=0.0)]
_Acceleration = Annotated[float, Unit("m/s^2", above=0.0)]
_Force = Annotated[float, Unit("N", above=0.0)]
_ACCELERATION_NOISE, _DEFLECTION_NOISE = 0.05, 5e-4  # m/s^2, m: default sensor noise
_DAMPER, _FORCE = SemiActiveDamper(), ActiveActuator()


class Passive(Controller):
    """No control: the unchanged rig, or a constant ``damping_coefficient`` (N s/m)."""

    law: Literal["passive"] = "passive"
    damping_coefficient: NonNegativeDampingCoefficient | None = None
    catalogue: ClassVar = {"passive": ("the rig as it is", None)}

    def decide(self, now: Instant) -> Decision:
        """Return the same command at every instant."""
        return Decision(
            self.actuator.command_for_coefficient(now.number("damping_coefficient"), now)
        )

    def numbers(self, corner: CornerModel) -> dict[str, float]:
        """Return the coefficient, N s/m."""
        return {
            "damping_coefficient": or_default(self.damping_coefficient, corner.reference_damping)
        }


class _Hook(ForceLaw):
    """Emulates a damper between body or wheel and a fixed point, within the limits of the actuator."""

    damping_coefficient: NonNegativeDampingCoefficient | None = None

    def numbers(self, corner: CornerModel) -> dict[str, float]:
        """Return the coefficient at the wheel (N s/m) and the motion ratio."""
        r = corner.motion_ratio
        coefficient = or_default(
            self.damping_coefficient, FIRMEST * corner.reference_damping * r**2
        )
        return {"damping_coefficient": coefficient, "motion_ratio": r}


class Skyhook(_Hook):
    """Damper between body and sky: force ``-damping_coefficient * sprung.vz`` [karnopp1974].

    A damper provides the force within its range; an active actuator provides it fully.

    Attributes
    ----------
    damping_coefficient : float or None
        Coefficient, N s/m; default: 8/3 of the corner's own.

    Examples
    --------
    >>> Skyhook(damping_coefficient="4000 N*s/m", rate="500 Hz").rate
    500.0
    """

    law: Literal["skyhook"] = "skyhook"
    catalogue: ClassVar = {
        "skyhook": ("damper between body and sky, clipped to a damper", _DAMPER),
        "active-skyhook": ("damper between body and sky, by an active actuator", _FORCE),
    }

    def force(self, now: Instant) -> ca.SX:
        """Return the force on the body, N."""
        return -now.number("damping_coefficient") * now.seen("sprung.vz")


class TwoStateSkyhook(TwoStateLaw):
    """Firm if a damper to the sky would act in the same direction: ``sprung.vz * extension rate >= 0``."""

    law: Literal["skyhook-two-state"] = "skyhook-two-state"
    catalogue: ClassVar = {
        "skyhook-two-state": ("firm where a damper to the sky would pull the same way", _DAMPER)
    }

    def product(self, now: Instant) -> ca.SX:
        """Return body velocity times extension rate."""
        return now.seen("sprung.vz") * now.extension_rate


class Groundhook(_Hook):
    """Damper between wheel and ground: force ``-damping_coefficient * unsprung.vz`` on the wheel.

    Attributes
    ----------
    damping_coefficient : float or None
        Coefficient, N s/m; default: 8/3 of the corner's own.
    """

    law: Literal["groundhook"] = "groundhook"
    catalogue: ClassVar = {
        "groundhook": ("damper between wheel and ground, clipped to a damper", _DAMPER)
    }

    def force(self, now: Instant) -> ca.SX:
        """Return the force on the body, N."""
        return now.number("damping_coefficient") * now.seen("unsprung.vz")


class TwoStateGroundhook(TwoStateLaw):
    """Firm if a damper to the ground would act on the wheel in the same direction."""

    law: Literal["groundhook-two-state"] = "groundhook-two-state"
    catalogue: ClassVar = {
        "groundhook-two-state": (
            "firm where a damper to the ground would pull the same way",
            _DAMPER,
        )
    }

    def product(self, now: Instant) -> ca.SX:
        """Return the negative of wheel velocity times extension rate."""
        return -now.seen("unsprung.vz") * now.extension_rate


class Hybrid(_Hook):
    """Weighted sum of skyhook and groundhook, each clipped to the range of a damper [goncalves2003].

    Attributes
    ----------
    damping_coefficient : float or None
        Coefficient, N s/m; default: 8/3 of the corner's own.
    skyhook_share : float
        Weight of skyhook: 1 is skyhook only, 0 groundhook only.
    """

    law: Literal["hybrid"] = "hybrid"
    skyhook_share: _Share = 0.5
    catalogue: ClassVar = {"hybrid": ("skyhook and groundhook mixed", _DAMPER)}

    def force(self, now: Instant) -> ca.SX:
        """Return the force on the body, N."""
        body, wheel, parting = now.seen("sprung.vz"), now.seen("unsprung.vz"), now.extension_rate
        sky, ground = body, -wheel
        if not isinstance(self.actuator, ActiveActuator):
            sky = ca.if_else(body * parting > 0.0, body, 0.0)
            ground = ca.if_else(-wheel * parting > 0.0, -wheel, 0.0)
        share = now.number("skyhook_share")
        return -now.number("damping_coefficient") * (share * sky + (1.0 - share) * ground)

    def numbers(self, corner: CornerModel) -> dict[str, float]:
        """Return coefficient (N s/m), motion ratio and skyhook share."""
        return {**super().numbers(corner), "skyhook_share": self.skyhook_share}


class ADD(TwoStateLaw):
    """Acceleration driven damping: firm if body acceleration and extension rate have the same sign [savaresi2005]."""

    law: Literal["add"] = "add"
    catalogue: ClassVar = {"add": ("acceleration driven damping", _DAMPER)}

    def product(self, now: Instant) -> ca.SX:
        """Return body acceleration times extension rate."""
        return now.seen("sprung.az") * now.extension_rate


class SHADD(TwoStateLaw):
    """Skyhook below a crossover frequency, acceleration driven damping above it [savaresi2007].

    Attributes
    ----------
    crossover : float
        Crossover frequency, Hz; usually 1.7 to 2.
    """

    law: Literal["sh-add"] = "sh-add"
    crossover: Frequency = 1.8
    catalogue: ClassVar = {
        "sh-add": ("skyhook below a crossover frequency, acceleration driven above it", _DAMPER),
    }

    def product(self, now: Instant) -> ca.SX:
        """Return body velocity or acceleration, whichever dominates, times extension rate."""
        velocity, acceleration = now.seen("sprung.vz"), now.seen("sprung.az")
        slow = acceleration**2 - (now.number("crossover") * velocity) ** 2 <= 0.0
        return ca.if_else(slow, velocity, acceleration) * now.extension_rate

    def numbers(self, corner: CornerModel) -> dict[str, float]:  # noqa: ARG002
        """Return the crossover frequency, rad/s."""
        return {"crossover": 2.0 * math.pi * self.crossover}


class PID(Controller):
    """PID control of body velocity, with filtered derivative and back-calculation anti-windup [astrom2006].

    The proportional part acts as a damper to the sky, the integral part as a spring to the sky, and the derivative part
    as added mass.

    Attributes
    ----------
    proportional : float or None
        Proportional gain, N s/m; default: 4/3 of the corner's own damping coefficient.
    integral : float or None
        Integral gain, N/m; default: a tenth of the wheel rate.
    derivative : float
        Derivative gain, kg.
    filter_time : float
        Time constant of the derivative's filter, s.
    tracking_time : float
        Anti-windup time constant: how quickly the integral follows the force missing at the actuator, s.
    """

    law: Literal["pid"] = "pid"
    proportional: DampingCoefficient | None = None
    integral: Stiffness | None = None
    derivative: _Inertance = 0.0
    filter_time: _Time = 0.01
    tracking_time: _Tracking = 0.2
    actuator: Actuator = ActiveActuator()
    catalogue: ClassVar = {"pid": ("PID on the body's velocity, active", _FORCE)}
    memory_size: ClassVar[int] = 3  # integral, filtered derivative, previous error

    def decide(self, now: Instant) -> Decision:
        """Return the command; the force missing at the actuator is fed back to the integral."""
        integral, slope, before = now.memory
        error, r = -now.seen("sprung.vz"), now.number("motion_ratio")
        slope = now.number("filter_keep") * slope + now.number("filter_gain") * (error - before)
        demand = now.number("proportional") * error + integral + now.number("derivative") * slope
        command = self.actuator.command_for_force(demand / r, now)
        missed = self.actuator.force_of(command, now) * r - demand
        following = integral + now.number("integral_gain") * error + now.number("tracking") * missed
        return Decision(command, [following, slope, error])

    def numbers(self, corner: CornerModel) -> dict[str, float]:
        """Return the gains for the control rate, SI, and the motion ratio."""
        period, r = 1.0 / self.rate, corner.motion_ratio
        keep = self.filter_time / (self.filter_time + period)
        return {
            "proportional": or_default(
                self.proportional, 0.5 * FIRMEST * corner.reference_damping * r**2
            ),
            "integral_gain": or_default(self.integral, 0.1 * corner.spring_rate) * period,
            "derivative": self.derivative,
            "filter_keep": keep,
            "filter_gain": (1.0 - keep) / period,
            "tracking": min(period / self.tracking_time, 1.0),
            "motion_ratio": r,
        }


class _Quadratic(Controller):
    """Cost of a regulator: integral of ``az^2 + deflection_weight x1^2 + tyre_weight x3^2 + force_weight u^2``."""

    deflection_weight: Weight | None = None
    tyre_weight: Weight | None = None
    force_weight: ForceWeight = 0.0
    actuator: Actuator = ActiveActuator()
    needs_wheel: ClassVar[bool] = True

    @property
    def _base(self) -> float | None:
        """Damping in parallel with the force: the corner's own (None), or 0 if the actuator replaces the damper."""
        return 0.0 if self.actuator.replaces_damper else None

    def gains(self, corner: CornerModel) -> Array:
        """Return gains of deflection, body velocity, tyre deflection, wheel velocity: N/m, N s/m, N/m, N s/m."""
        square = (corner.spring_rate / corner.sprung_mass) ** 2
        weights = Weights(
            or_default(self.deflection_weight, square),
            or_default(self.tyre_weight, 10.0 * square),
            self.force_weight,
        )
        return regulator_gains(corner, weights, self._base)


class LQR(_Quadratic):
    """Linear quadratic regulator with full state measurement; clipped-optimal with a damper [butsuen1989].

    Attributes
    ----------
    deflection_weight, tyre_weight : float or None
        Weights of suspension and tyre deflection relative to body acceleration, 1/s^4; default: 1 and 10 times the
        fourth power of the body's natural angular frequency.
    force_weight : float
        Weight of the force, 1/kg^2.

    Examples
    --------
    >>> from jounce.control import CornerModel
    >>> corner = CornerModel(400.0, 40.0, 25000.0, 200000.0, 1500.0)
    >>> round(float(LQR().gains(corner)[1]), 1)   # force for each m/s of the body, N s/m
    3002.6
    """

    law: Literal["lqr"] = "lqr"
    catalogue: ClassVar = {
        "lqr": ("linear quadratic regulator, active", _FORCE),
        "clipped-lqr": ("clipped-optimal regulator with a damper", _DAMPER),
    }

    def decide(self, now: Instant) -> Decision:
        """Return the command for the optimal force."""
        r = now.number("motion_ratio")
        parting, tyre = -now.seen("strut.deflection") / r, -now.seen("tyre.deflection")
        states = ca.vertcat(parting, now.seen("sprung.vz"), tyre, now.seen("unsprung.vz"))
        force = -ca.dot(_vector(now.number, "gain", 4), states)
        return Decision(self.actuator.command_for_force(force / r, now))

    def numbers(self, corner: CornerModel) -> dict[str, float]:
        """Return gains, SI, and motion ratio."""
        return {**_flatten("gain", self.gains(corner)), "motion_ratio": corner.motion_ratio}


LQG_CHANNELS = ("sprung.az", "unsprung.az", "strut.deflection")


class LQG(_Quadratic):
    """Regulator with a Kalman filter that estimates the states from two accelerometers and the stroke.

    With a damper, the force is clipped to the range of the damper.

    Attributes
    ----------
    deflection_weight, tyre_weight, force_weight : float
        As for :class:`LQR`.
    roughness : float
        Intensity of the road's velocity assumed by the filter, m^2/s; class C at 20 m/s: 1.01e-3.
    disturbance : float
        Intensity of unmodelled accelerations, m^2/s^3. It shortens the memory of the filter: without it, the filter
        needs half a minute to settle, and differences between a 3-D corner and its model make it drift.
    """

    law: Literal["lqg"] = "lqg"
    roughness: _Roughness = 1.0106e-3
    disturbance: _Disturbance = 1e-3
    catalogue: ClassVar = {
        "lqg": ("regulator on a Kalman filter, active", _FORCE),
        "clipped-lqg": ("clipped-optimal regulator on a Kalman filter, with a damper", _DAMPER),
    }
    memory_size: ClassVar[int] = 5  # estimated states, and the command after the actuator's lag

    def decide(self, now: Instant) -> Decision:
        """Return the command for the states, estimated from measurements and from the command after the lag."""
        number, r = now.number, now.number("motion_ratio")
        missing = now.memory[4] - now.last
        arrived, mean = (
            now.last + number("late") * missing,
            now.last + number("mean_late") * missing,
        )
        force, mean_force = (
            self.actuator.force_of(command, now) * r for command in (arrived, mean)
        )
        before = (
            _matrix(number, "F", 4, 4) @ ca.vertcat(*now.memory[:4])
            + _vector(number, "H", 4) * mean_force
        )
        measured = ca.vertcat(*(now.seen(channel) for channel in LQG_CHANNELS))
        expected = _matrix(number, "C", 3, 4) @ before + _vector(number, "D", 3) * force
        states = before + _matrix(number, "L", 4, 3) @ (measured - expected)
        command = self.actuator.command_for_force(
            -ca.dot(_vector(number, "gain", 4), states) / r, now
        )
        return Decision(command, [*ca.vertsplit(states), arrived])

    def numbers(self, corner: CornerModel) -> dict[str, float]:
        """Return gains and filter matrices, SI."""
        lag = _lag(self.actuator)
        periods = 1.0 / (self.rate * lag) if lag > 0.0 else math.inf
        late = {"late": math.exp(-periods), "mean_late": -math.expm1(-periods) / periods}
        usual = {"strut.deflection": _DEFLECTION_NOISE}
        deviations = np.array(
            [self.noise.get(name) or usual.get(name, _ACCELERATION_NOISE) for name in LQG_CHANNELS]
        )
        filter_ = observer(
            corner,
            LQG_CHANNELS,
            deviations,
            self.roughness,
            self.disturbance,
            1.0 / self.rate,
            self._base,
        )
        filter_numbers = _flatten_all({name: getattr(filter_, name) for name in "FHLCD"})
        return {
            **filter_numbers,
            **late,
            **_flatten("gain", self.gains(corner)),
            "motion_ratio": corner.motion_ratio,
        }


class HInfinity(Controller):
    """H-infinity output feedback from stroke and body acceleration, synthesised by SLICOT (extra ``control``).

    The force is added to the corner's own damping; with a damper, the sum is clipped to the range of the damper.

    Attributes
    ----------
    road : float
        Height of the road's disturbance, m.
    acceleration : float or None
        Body acceleration, m/s^2, allowed on this road; default: 2.56 wheel rate / sprung mass times ``road``.
    deflection : float or None
        Suspension deflection, m, with the same weight; default: 0.8 ``road``.
    force : float or None
        Force, N, with the same weight; default: the static load.
    """

    law: Literal["h-infinity"] = "h-infinity"
    road: PositiveLength = 0.05
    acceleration: _Acceleration | None = None
    deflection: PositiveLength | None = None
    force: _Force | None = None
    actuator: Actuator = ActiveActuator()
    catalogue: ClassVar = {
        "h-infinity": ("H-infinity output feedback, active", _FORCE),
        "clipped-h-infinity": ("H-infinity output feedback, clipped to a damper", _DAMPER),
    }
    needs_wheel: ClassVar[bool] = True
    memory_size: ClassVar[int] = H_INFINITY_ORDER

    def decide(self, now: Instant) -> Decision:
        """Return the command of the linear controller, and its next states."""
        n, channels, states = H_INFINITY_ORDER, H_INFINITY_CHANNELS, ca.vertcat(*now.memory)
        number, r = now.number, now.number("motion_ratio")
        measured = ca.vertcat(*(now.seen(channel) for channel in channels))
        force = ca.dot(_vector(number, "C", n), states) + ca.dot(
            _vector(number, "D", len(channels)), measured
        )
        if self.actuator.replaces_damper:
            force += number("damping_coefficient") * now.seen("strut.velocity") / r
        following = (
            _matrix(number, "A", n, n) @ states + _matrix(number, "B", n, len(channels)) @ measured
        )
        return Decision(self.actuator.command_for_force(force / r, now), ca.vertsplit(following))

    def numbers(self, corner: CornerModel) -> dict[str, float]:
        """Return the matrices of the controller, SI."""
        r = corner.motion_ratio
        acceleration = or_default(
            self.acceleration, 2.56 * corner.spring_rate / corner.sprung_mass * self.road
        )
        targets = Targets(
            self.road,
            acceleration,
            or_default(self.deflection, 0.8 * self.road),
            or_default(self.force, corner.sprung_mass * corner.gravity),
            (0.2 * self.road, acceleration / 16.0),
        )
        damping, lag = corner.reference_damping * r**2, _lag(self.actuator)
        quickness = min(1.0 / lag, _QUICKEST) if lag > 0.0 else _QUICKEST
        controller, _ = h_infinity(corner, targets, quickness, 1.0 / self.rate, damping)
        matrices = _flatten_all(
            {"A": controller.A, "B": controller.B, "C": controller.C[0], "D": controller.D[0]}
        )
        return {**matrices, "motion_ratio": r, "damping_coefficient": damping}


_QUICKEST = 300.0  # rad/s: far above wheel hop (some 75 rad/s), an actuator has no effective lag


def _lag(actuator: AnyActuator) -> float:
    """Return the time constant of an actuator, s; at low frequency for a second-order actuator."""
    if isinstance(actuator, ActiveActuator) and actuator.bandwidth is not None:
        return actuator.damping_ratio / (math.pi * actuator.bandwidth)
    return actuator.lag


def _flatten(name: str, values: Array | Sequence[float]) -> dict[str, float]:
    """Flatten an array to values by path: ``gain[0]``, ``F[1][2]``."""
    array = np.asarray(values, dtype=np.float64)
    return {
        name + "".join(f"[{i}]" for i in index): float(value)
        for index, value in np.ndenumerate(array)
    }


def _flatten_all(arrays: dict[str, Array]) -> dict[str, float]:
    return {
        path: value
        for name, array in arrays.items()
        for path, value in _flatten(name, array).items()
    }


def _vector(number: Lookup, name: str, size: int) -> ca.SX:
    return ca.vertcat(*(number(f"{name}[{i}]") for i in range(size)))


def _matrix(number: Lookup, name: str, rows: int, columns: int) -> ca.SX:
    return ca.vertcat(
        *(ca.horzcat(*(number(f"{name}[{i}][{j}]") for j in range(columns))) for i in range(rows))
    )
