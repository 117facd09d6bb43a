"""Laws that are formulas: skyhook, groundhook, hybrid, acceleration driven damping, PID."""

from __future__ import annotations

import math
from typing import Annotated, Literal

import casadi as ca

from jounce.control.actuators import FIRMEST, ActiveActuator, Actuator
from jounce.control.controller import Controller, DamperLaw, Decision, ForceLaw, extension_rate, given, step
from jounce.control.conversion import Lookup, Means
from jounce.control.corner import CornerModel
from jounce.core.units import (
    DampingCoefficient,
    Frequency,
    NonNegativeDampingCoefficient,
    Stiffness,
    Unit,
)

_Share = Annotated[float, Unit("1", at_least=0.0, at_most=1.0)]
_Inertance = Annotated[float, Unit("kg")]
_Time = Annotated[float, Unit("s", at_least=0.0)]
_Tracking = Annotated[float, Unit("s", above=0.0)]


class Passive(Controller):
    """No control: the rig as it is, or with ``damping_coefficient`` (N s/m) a damper of that constant setting."""

    law: Literal["passive"] = "passive"
    damping_coefficient: NonNegativeDampingCoefficient | None = None

    def decide(self, seen: Lookup, memory: list[ca.SX], number: Lookup, means: Means) -> Decision:  # noqa: ARG002
        """Write the law of one corner."""
        return Decision(means.command_for_coefficient(number("damping_coefficient")))

    def numbers(self, corner: CornerModel) -> dict[str, float]:
        """Give the coefficient, N s/m."""
        return {"damping_coefficient": given(self.damping_coefficient, lambda: corner.reference_damping)}


class _Hook(ForceLaw):
    """A damper between the body or the wheel and something at rest, as far as the actuator can be it."""

    damping_coefficient: NonNegativeDampingCoefficient | None = None

    def numbers(self, corner: CornerModel) -> dict[str, float]:
        """Give the coefficient (N s/m) at the wheel, and the motion ratio."""
        r = corner.motion_ratio
        coefficient = given(self.damping_coefficient, lambda: FIRMEST * corner.reference_damping * r**2)
        return {"damping_coefficient": coefficient, "motion_ratio": r}


class Skyhook(_Hook):
    """Damper between body and sky: force ``-damping_coefficient * sprung.vz`` [karnopp1974].

    With a damper it is clipped to what this can give; with an active actuator it is the skyhook itself.

    Attributes
    ----------
    damping_coefficient : float or None
        N s/m; left out: 8/3 of the corner's own.

    Examples
    --------
    >>> Skyhook(damping_coefficient="4000 N*s/m", rate="500 Hz").rate
    500.0
    """

    law: Literal["skyhook"] = "skyhook"

    def force(self, seen: Lookup, number: Lookup) -> ca.SX:
        """Force on the body, N."""
        return -number("damping_coefficient") * seen("sprung.vz")


class Groundhook(_Hook):
    """Damper between wheel and ground: force ``-damping_coefficient * unsprung.vz`` on the wheel.

    Attributes
    ----------
    damping_coefficient : float or None
        N s/m; left out: 8/3 of the corner's own.
    """

    law: Literal["groundhook"] = "groundhook"

    def force(self, seen: Lookup, number: Lookup) -> ca.SX:
        """Force on the body, N."""
        return number("damping_coefficient") * seen("unsprung.vz")


class Hybrid(_Hook):
    """Skyhook and groundhook mixed after each was clipped to what a damper can do [goncalves2003].

    Attributes
    ----------
    damping_coefficient : float or None
        N s/m; left out: 8/3 of the corner's own.
    skyhook_share : float
        1: skyhook only, 0: groundhook only.
    """

    law: Literal["hybrid"] = "hybrid"
    skyhook_share: _Share = 0.5

    def force(self, seen: Lookup, number: Lookup) -> ca.SX:
        """Force on the body, N."""
        body, wheel, parting = seen("sprung.vz"), seen("unsprung.vz"), extension_rate(seen)
        sky, ground = body, -wheel
        if not isinstance(self.actuator, ActiveActuator):
            sky = ca.if_else(body * parting > 0.0, body, 0.0)
            ground = ca.if_else(-wheel * parting > 0.0, -wheel, 0.0)
        share = number("skyhook_share")
        return -number("damping_coefficient") * (share * sky + (1.0 - share) * ground)

    def numbers(self, corner: CornerModel) -> dict[str, float]:
        """Give coefficient (N s/m), motion ratio and share."""
        return {**super().numbers(corner), "skyhook_share": self.skyhook_share}


class _TwoState(DamperLaw):
    """Firm where a product of two signals is positive, soft elsewhere."""

    def product(self, seen: Lookup, number: Lookup) -> ca.SX:
        """What says by its sign whether the damper is firm."""
        raise NotImplementedError

    def decide(self, seen: Lookup, memory: list[ca.SX], number: Lookup, means: Means) -> Decision:  # noqa: ARG002
        """Write the law of one corner."""
        return Decision(means.command_for_level(step(self.product(seen, number))))

    def numbers(self, corner: CornerModel) -> dict[str, float]:  # noqa: ARG002
        """Give no numbers."""
        return {}


class TwoStateSkyhook(_TwoState):
    """Firm where a damper to the sky would pull the same way: ``sprung.vz * extension rate >= 0``."""

    law: Literal["skyhook-two-state"] = "skyhook-two-state"

    def product(self, seen: Lookup, number: Lookup) -> ca.SX:  # noqa: ARG002
        """Body velocity times extension rate."""
        return seen("sprung.vz") * extension_rate(seen)


class TwoStateGroundhook(_TwoState):
    """Firm where a damper to the ground would pull the wheel the same way."""

    law: Literal["groundhook-two-state"] = "groundhook-two-state"

    def product(self, seen: Lookup, number: Lookup) -> ca.SX:  # noqa: ARG002
        """Wheel velocity times extension rate, reversed."""
        return -seen("unsprung.vz") * extension_rate(seen)


class ADD(_TwoState):
    """Acceleration driven damping: firm where body acceleration and extension rate agree [savaresi2005]."""

    law: Literal["add"] = "add"

    def product(self, seen: Lookup, number: Lookup) -> ca.SX:  # noqa: ARG002
        """Body acceleration times extension rate."""
        return seen("sprung.az") * extension_rate(seen)


class SHADD(_TwoState):
    """Skyhook below a crossover frequency, acceleration driven damping above it [savaresi2007].

    Attributes
    ----------
    crossover : float
        Hz; usually 1.7 to 2.
    """

    law: Literal["sh-add"] = "sh-add"
    crossover: Frequency = 1.8

    def product(self, seen: Lookup, number: Lookup) -> ca.SX:
        """Body velocity or acceleration, whichever rules, times extension rate."""
        velocity, acceleration = seen("sprung.vz"), seen("sprung.az")
        slow = acceleration**2 - (number("crossover") * velocity) ** 2 <= 0.0
        return ca.if_else(slow, velocity, acceleration) * extension_rate(seen)

    def numbers(self, corner: CornerModel) -> dict[str, float]:  # noqa: ARG002
        """Give the crossover, rad/s."""
        return {"crossover": 2.0 * math.pi * self.crossover}


class PID(Controller):
    """PID on the body's velocity, with a filtered derivative and back-calculation against windup [astrom2006].

    The proportional part is a damper to the sky, the integral one a spring to it, the derivative one added mass.

    Attributes
    ----------
    proportional : float or None
        N s/m; left out: 4/3 of the corner's own damping coefficient.
    integral : float or None
        N/m; left out: a tenth of the wheel rate.
    derivative : float
        kg.
    filter_time : float
        Time constant of the derivative's filter, s.
    tracking_time : float
        Time in which the integral follows what the actuator could not do, s.
    """

    law: Literal["pid"] = "pid"
    proportional: DampingCoefficient | None = None
    integral: Stiffness | None = None
    derivative: _Inertance = 0.0
    filter_time: _Time = 0.01
    tracking_time: _Tracking = 0.2
    actuator: Actuator = ActiveActuator()

    @property
    def memory_size(self) -> int:
        """Integral, filtered derivative, error before."""
        return 3

    def decide(self, seen: Lookup, memory: list[ca.SX], number: Lookup, means: Means) -> Decision:
        """Write the law of one corner."""
        integral, slope, before = memory
        error, r = -seen("sprung.vz"), number("motion_ratio")
        slope = number("filter_keep") * slope + number("filter_gain") * (error - before)
        wish = number("proportional") * error + integral + number("derivative") * slope
        command = means.command_for_force(wish / r)
        missed = means.force_of(command) * r - wish
        following = integral + number("integral_gain") * error + number("tracking") * missed
        return Decision(command, [following, slope, error])

    def numbers(self, corner: CornerModel) -> dict[str, float]:
        """Give the gains for the control rate, and the motion ratio."""
        period, r = 1.0 / self.rate, corner.motion_ratio
        keep = self.filter_time / (self.filter_time + period)
        integral = given(self.integral, lambda: 0.1 * corner.spring_rate)
        return {
            "proportional": given(self.proportional, lambda: 0.5 * FIRMEST * corner.reference_damping * r**2),
            "integral_gain": integral * period,
            "derivative": self.derivative,
            "filter_keep": keep,
            "filter_gain": (1.0 - keep) / period,
            "tracking": min(period / self.tracking_time, 1.0),
            "motion_ratio": r,
        }
