"""Actuators of controlled suspensions: force, limits and lag of a command, and its inverse, the command for a force."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal, Self

import casadi as ca
import numpy as np
from pydantic import BaseModel, Discriminator, Tag, model_validator

from jounce.control.design import CornerModel
from jounce.core.description import Description
from jounce.core.errors import show_value
from jounce.core.misplaced import error_at
from jounce.core.old_names import old_method
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.core.units import Frequency, NonNegativeDampingCoefficient, PositiveNumber, Unit
from jounce.parts.dampers import BoucWenDamper, SampledPoint, TanhDamper
from jounce.parts.rig import parameters_of

SOFTEST, FIRMEST = 0.2, 8.0 / 3.0
"""Default minimum and maximum coefficient of a damper, relative to the corner's own damping coefficient."""
_REVERSAL = 0.02
"""Velocity (m/s) over which a hysteretic force reverses if its state is not measured."""
_Lag = Annotated[float, Unit("s", at_least=0.0)]
_Voltage = Annotated[float, Unit("V", above=0.0)]
_Rate = Annotated[float, Unit("N*s/m/s", above=0.0)]
_ForceRate = Annotated[float, Unit("N/s", above=0.0)]
_VoltageRate = Annotated[float, Unit("V/s", above=0.0)]
_ForceLimit = Annotated[float, Unit("N", above=0.0)]


Replaced = Literal["spring", "stops", "tyre"]
"""Elements other than the damper that a force may replace."""
OWN, RATE = "own_force", "velocity"
"""Channels ``actuator.*`` of a replaced element: its original force (N), and its deflection rate (m/s)."""

Lookup = Callable[[str], ca.SX]
"""Function that returns the symbol of a channel or parameter by name."""


@dataclass(frozen=True)
class Instant:
    """Inputs of a law for one corner at one control instant, as symbols.

    Attributes
    ----------
    seen : callable
        Returns the symbol of a channel without its corner (``"sprung.vz"``), as change from static equilibrium.
    number : callable
        Returns the symbol of a parameter of the law or the actuator, or of a limit of its command (``minimum``,
        ``maximum``).
    last : casadi.SX
        Command of the previous instant.
    memory : list of casadi.SX
        Memory of the law from the previous instant.
    """

    seen: Lookup
    number: Lookup
    last: ca.SX
    memory: Sequence[ca.SX] = ()

    @property
    def extension_rate(self) -> ca.SX:
        """Extension rate of the strut (m/s), positive in rebound."""
        return -self.seen("strut.velocity")

    def clip(self, command: ca.SX) -> ca.SX:
        """Clip a command to the limits of the actuator."""
        return clip(command, self.number("minimum"), self.number("maximum"))

    def between(self, share: ca.SX) -> ca.SX:
        """Interpolate the command from minimum (``share`` 0) to maximum (1); for dampers, from soft to firm."""
        low, high = self.number("minimum"), self.number("maximum")
        return low + (high - low) * share


class _Actuator(Description):
    """Base of all actuators: a command with its unit, and parameters for the vehicle model."""

    unit: ClassVar[str] = ""

    @property
    def replaces_damper(self) -> bool:
        """Whether it replaces the corner's own damper instead of acting in parallel."""
        return True

    @property
    def structure(self) -> str:
        """Identifier of the actuator's equations, independent of parameter values."""
        raise NotImplementedError

    @property
    def plant_numbers(self) -> dict[str, float]:
        """Parameters of the actuator's equations, SI."""
        raise NotImplementedError

    @property
    def limits(self) -> tuple[float, float]:
        """Minimum and maximum command, in the unit of the command."""
        raise NotImplementedError

    @property
    def rest(self) -> float:
        """Command before the first control instant."""
        return self.limits[0]

    resolved: ClassVar[Any] = old_method("Actuator.resolved", "complete_for")

    def complete_for(self, corner: CornerModel) -> Self:  # noqa: ARG002 - others need it
        """Return a copy of the actuator with missing values set for a corner."""
        return self

    def force_of(self, command: ca.SX, now: Instant) -> ca.SX:
        """Return the strut force (N) of a command without lag."""
        raise NotImplementedError

    def command_for_force(self, force: ca.SX, now: Instant) -> ca.SX:
        """Return the command whose force is closest to a strut force (N, compression positive).

        A damper can only produce forces that oppose its velocity, within its limits.
        """
        raise NotImplementedError

    def command_for_coefficient(self, coefficient: ca.SX, now: Instant) -> ca.SX:
        """Return the command closest to a damping coefficient of the strut (N s/m)."""
        return self.command_for_force(coefficient * now.seen("strut.velocity"), now)


class SemiActiveDamper(_Actuator):
    """Damper with a commanded coefficient, ``F = c * velocity``; replaces the corner's own damper.

    Attributes
    ----------
    minimum, maximum : float or None
        Bounds of the coefficient, N s/m; default: 0.2 and 8/3 of the corner's own damping coefficient.
    lag : float
        Time constant of the first-order lag of the coefficient, s; 0 means no lag.
    rate_limit : float or None
        Maximum rate of change of the commanded coefficient, N s/m per s.
    """

    kind: Literal["semi-active"] = "semi-active"
    minimum: NonNegativeDampingCoefficient | None = None
    maximum: NonNegativeDampingCoefficient | None = None
    lag: _Lag = 0.01
    rate_limit: _Rate | None = None
    unit: ClassVar[str] = "N*s/m"

    @model_validator(mode="after")
    def _check_order(self) -> Self:
        if self.minimum is not None and self.maximum is not None and self.maximum <= self.minimum:
            raise ValueError(
                Phrase(
                    "maximum = {maximum:g} N*s/m is not above minimum = {minimum:g} N*s/m; swap them, "
                    "or widen the range of the damper",
                    maximum=self.maximum,
                    minimum=self.minimum,
                )
            )
        return self

    @property
    def structure(self) -> str:
        """Identifier of the actuator's equations."""
        return f"semi-active, lag {self.lag > 0.0}"

    @property
    def plant_numbers(self) -> dict[str, float]:
        """Parameters of the actuator's equations, SI."""
        return {"lag": self.lag} if self.lag > 0.0 else {}

    @property
    def limits(self) -> tuple[float, float]:
        """Minimum and maximum coefficient, N s/m."""
        if self.minimum is None or self.maximum is None:
            raise AssertionError("the damper is resolved first")
        return self.minimum, self.maximum

    def complete_for(self, corner: CornerModel) -> Self:
        """Return a copy of the damper with ``minimum`` and ``maximum`` set."""
        low = SOFTEST * corner.reference_damping if self.minimum is None else self.minimum
        high = FIRMEST * corner.reference_damping if self.maximum is None else self.maximum
        table = {**self.model_dump(exclude_none=True), "minimum": low, "maximum": high}
        return type(self).from_table(table, where="actuator")

    def force_of(self, command: ca.SX, now: Instant) -> ca.SX:
        """Return the strut force, N."""
        return command * now.seen("strut.velocity")

    def command_for_force(self, force: ca.SX, now: Instant) -> ca.SX:
        """Return the coefficient, N s/m; the minimum if the force would drive the motion."""
        velocity = now.seen("strut.velocity")
        wanted = force * velocity / ca.fmax(velocity * velocity, 1e-12)
        return ca.if_else(force * velocity > 0.0, now.clip(wanted), now.number("minimum"))

    def command_for_coefficient(self, coefficient: ca.SX, now: Instant) -> ca.SX:
        """Return the coefficient clipped to the limits, N s/m."""
        return now.clip(coefficient)


class ActiveActuator(_Actuator):
    """Force actuator in parallel with spring and damper, or instead of the damper; a positive force extends the strut.

    Attributes
    ----------
    force_limit : float or None
        Maximum force, N; default: half of the corner's static load.
    lag : float
        Time constant of a first-order lag, s; 0 means no lag.
    bandwidth : float or None
        Natural frequency of a second-order actuator instead of the lag, Hz (hydraulic ones: 20 to 25 Hz).
    damping_ratio : float
        Damping ratio of the second-order actuator; below 1 the force briefly overshoots its command and its limit.
    rate_limit : float or None
        Maximum rate of change of the commanded force, N/s.
    in_place_of_damper : bool
        Whether the actuator replaces the corner's own damper; the command then includes the damper's force.
    in_place_of : {"spring", "stops", "tyre"} or None
        A different element whose force an FMU computes. The rig's own element remains active between two instants; the
        command is the difference between the FMU's force and its own. It has neither lag nor limits.
    """

    kind: Literal["active"] = "active"
    force_limit: _ForceLimit | None = None
    lag: _Lag = 0.005
    bandwidth: Frequency | None = None
    damping_ratio: PositiveNumber = 1.0
    rate_limit: _ForceRate | None = None
    in_place_of_damper: bool = False
    in_place_of: Replaced | None = None
    unit: ClassVar[str] = "N"

    @property
    def replaces_damper(self) -> bool:
        """Whether the actuator replaces the corner's own damper."""
        return self.in_place_of_damper

    @model_validator(mode="before")
    @classmethod
    def _remove_lag(cls, table: Any) -> Any:
        is_element = isinstance(table, dict) and table.get("in_place_of") is not None
        return {"lag": 0.0, **table} if is_element else table

    @model_validator(mode="after")
    def _check_element(self) -> Self:
        given = [
            name
            for name in ("force_limit", "bandwidth", "rate_limit")
            if getattr(self, name) is not None
        ]
        given += ["lag"] if self.lag > 0.0 else []
        given += ["in_place_of_damper"] if self.in_place_of_damper else []
        if self.in_place_of is not None and given:
            raise ValueError(
                Phrase(
                    "a force that replaces the {in_place_of} has no {given}; omit it, or omit in_place_of",
                    in_place_of=self.in_place_of,
                    given=given[0],
                )
            )
        return self

    @model_validator(mode="after")
    def _check_speed(self) -> Self:
        if self.bandwidth is not None and "lag" in self.model_fields_set and self.lag > 0.0:
            raise ValueError("both lag and bandwidth are given; give one of them")
        return self

    @property
    def structure(self) -> str:
        """Identifier of the actuator's equations."""
        if self.in_place_of is not None:
            return f"active, in place of the {self.in_place_of}"
        order = "second order" if self.bandwidth is not None else f"lag {self.lag > 0.0}"
        return f"active, {order}{', no damper' if self.in_place_of_damper else ''}"

    @property
    def plant_numbers(self) -> dict[str, float]:
        """Parameters of the actuator's equations, SI."""
        if self.bandwidth is not None:
            return {"bandwidth": self.bandwidth, "damping_ratio": self.damping_ratio}
        return {"lag": self.lag} if self.lag > 0.0 else {}

    @property
    def order(self) -> int:
        """Number of states between command and force: 0, 1 or 2."""
        return 2 if self.bandwidth is not None else int(self.lag > 0.0)

    @property
    def equations(self) -> tuple[Array, Array]:
        """State and input matrix of the actuator's force (first state is the force), SI."""
        if self.bandwidth is None:
            return np.array([[-1.0 / self.lag]]), np.array([[1.0 / self.lag]])
        w = 2.0 * math.pi * self.bandwidth
        return np.array([[0.0, 1.0], [-(w**2), -2.0 * self.damping_ratio * w]]), np.array(
            [[0.0], [w**2]]
        )

    @property
    def limits(self) -> tuple[float, float]:
        """Minimum and maximum force, N."""
        if self.force_limit is None:
            raise AssertionError("the actuator is resolved first")
        return -self.force_limit, self.force_limit

    @property
    def rest(self) -> float:
        """Zero force, N."""
        return 0.0

    def complete_for(self, corner: CornerModel) -> Self:
        """Return a copy of the actuator with ``force_limit`` set."""
        if self.in_place_of is not None:
            return BaseModel.model_copy(
                self, update={"force_limit": math.inf}
            )  # no limit; descriptions must be finite
        limit = (
            0.5 * corner.sprung_mass * corner.gravity
            if self.force_limit is None
            else self.force_limit
        )
        return self.model_copy(update={"force_limit": limit})

    def force_of(self, command: ca.SX, now: Instant) -> ca.SX:  # noqa: ARG002
        """Return the command itself, N."""
        return command

    def command_for_force(self, force: ca.SX, now: Instant) -> ca.SX:
        """Return the force clipped to the limits, N."""
        return now.clip(force)


class MagnetorheologicalDamper(_Actuator):
    """Magnetorheological damper with a hysteretic law that depends on voltage; replaces the corner's own damper.

    Identify the laws at zero and maximum voltage from measurements with :func:`jounce.fit_damper`. Parameters are
    interpolated between them by the actual voltage, which follows the command with a first-order lag.

    Attributes
    ----------
    off, on : TanhDamper or BoucWenDamper
        Law at 0 V and at ``maximum``; the two must be of the same kind.
    maximum : float
        Maximum voltage, V.
    lag : float
        Time constant of the voltage, s; 0 means no lag.
    rate_limit : float or None
        Maximum rate of change of the commanded voltage, V/s.

    Examples
    --------
    >>> law = {"kind": "tanh", "coefficient": 400.0, "force": 60.0, "slope": 25.0}
    >>> damper = MagnetorheologicalDamper(off=law, on={**law, "coefficient": 900.0, "force": 900.0}, maximum="5 V")
    >>> damper.limits   # V
    (0.0, 5.0)
    """

    kind: Literal["magnetorheological"] = "magnetorheological"
    off: TanhDamper | BoucWenDamper
    on: TanhDamper | BoucWenDamper
    maximum: _Voltage
    lag: _Lag = 0.005
    rate_limit: _VoltageRate | None = None
    unit: ClassVar[str] = "V"

    @model_validator(mode="before")
    @classmethod
    def _read_laws(cls, table: Any) -> Any:
        if not isinstance(table, dict):
            return table
        laws: dict[str, type[Description]] = {"tanh": TanhDamper, "bouc-wen": BoucWenDamper}
        fields = dict(table)
        for name in ("off", "on"):
            law = fields.get(name)
            if isinstance(law, dict):
                if law.get("kind") not in laws:
                    what = Phrase(
                        "{name}: the law's kind is {kind}",
                        name=name,
                        kind=show_value(law.get("kind")),
                    )
                    raise error_at((), what, allowed="tanh, bouc-wen")
                fields[name] = laws[law["kind"]].from_table(law, where=name)
        return fields

    @model_validator(mode="after")
    def _check_kinds(self) -> Self:
        if self.off.kind != self.on.kind:
            raise ValueError(
                Phrase(
                    "off is a {kind!r} law, on is a {second_kind!r} law; give two laws of the same kind",
                    kind=self.off.kind,
                    second_kind=self.on.kind,
                )
            )
        return self

    @property
    def structure(self) -> str:
        """Identifier of the actuator's equations."""
        return f"magnetorheological, {self.off.kind}, lag {self.lag > 0.0}"

    @property
    def plant_numbers(self) -> dict[str, float]:
        """Parameters of the actuator's equations, SI."""
        numbers = {
            **parameters_of(self.off, "off."),
            **parameters_of(self.on, "on."),
            "maximum": self.maximum,
        }
        return {**numbers, "lag": self.lag} if self.lag > 0.0 else numbers

    @property
    def limits(self) -> tuple[float, float]:
        """Minimum and maximum voltage, SI: 0 and ``maximum``."""
        return 0.0, self.maximum

    def force_of(self, command: ca.SX, now: Instant) -> ca.SX:
        """Return the strut force, N."""
        off, on = self._force("off", now), self._force("on", now)
        low, high = now.number("minimum"), now.number("maximum")
        return off + (on - off) * (command - low) / (high - low)

    def command_for_force(self, force: ca.SX, now: Instant) -> ca.SX:
        """Return the voltage, V, by linear interpolation of the force between the two laws."""
        off, on = self._force("off", now), self._force("on", now)
        share = (force - off) * (on - off) / ca.fmax((on - off) ** 2, 1e-12)
        return now.between(clip(share, 0.0, 1.0))

    def _force(self, end: str, now: Instant) -> ca.SX:
        """Return the force (N) at minimum (``"off"``) or maximum (``"on"``) voltage."""
        deflection = now.seen("strut.deflection") + now.number("static_deflection")
        law: TanhDamper | BoucWenDamper = getattr(self, end)
        return law.evaluate(
            _ControllerPoint(
                lambda name: now.number(f"{end}.{name}"), now.seen("strut.velocity"), deflection
            )
        )


class _ControllerPoint(SampledPoint):
    """Operating point of a damper law in a controller, which cannot measure the hysteresis state."""

    def state(self, name: str, rate: Callable[[Any], Any]) -> Any:  # noqa: ARG002
        """Return the limit of the state for a motion in this direction."""
        return ca.tanh(self.velocity / _REVERSAL)


def clip(x: ca.SX, low: ca.SX | float, high: ca.SX | float) -> ca.SX:
    """Clip a symbol to two limits."""
    return ca.fmin(ca.fmax(x, low), high)


def _kind(value: Any) -> str:
    if isinstance(value, dict):
        return str(value.get("kind", "semi-active"))
    return str(getattr(value, "kind", "semi-active"))


Actuator = Annotated[
    Annotated[SemiActiveDamper, Tag("semi-active")]
    | Annotated[ActiveActuator, Tag("active")]
    | Annotated[MagnetorheologicalDamper, Tag("magnetorheological")],
    Discriminator(_kind),
]
AnyActuator = SemiActiveDamper | ActiveActuator | MagnetorheologicalDamper
