"""Actuators of controlled suspensions: force, limits and lag of a command, and the command for a demanded force."""

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
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.core.units import Frequency, NonNegativeDampingCoefficient, PositiveNumber, Unit
from jounce.parts.dampers import BoucWenDamper, SampledPoint, TanhDamper
from jounce.parts.rig import parameters_of

SOFTEST, FIRMEST = 0.2, 8.0 / 3.0
"""Default smallest and largest coefficient of a damper, as shares of the corner's own damping coefficient."""
_REVERSAL = 0.02
"""Velocity (m/s) over which a hysteretic force reverses where its state is not measured."""
_Lag = Annotated[float, Unit("s", at_least=0.0)]
_Voltage = Annotated[float, Unit("V", above=0.0)]
_Rate = Annotated[float, Unit("N*s/m/s", above=0.0)]
_ForceRate = Annotated[float, Unit("N/s", above=0.0)]
_VoltageRate = Annotated[float, Unit("V/s", above=0.0)]
_ForceLimit = Annotated[float, Unit("N", above=0.0)]


Replaced = Literal["spring", "stops", "tyre"]
"""Elements besides the damper that a force may replace."""
OWN, RATE = "own_force", "velocity"
"""Channels ``actuator.*`` of such an element: force (N) of the rig's own, and rate (m/s) of the deflection."""

Lookup = Callable[[str], ca.SX]
"""Symbol of a channel or a number by its name."""


@dataclass(frozen=True)
class Instant:
    """One corner at one control instant, as a law sees it: symbols by name.

    Attributes
    ----------
    seen : callable
        Channel without its corner (``"sprung.vz"``) to its symbol, as a change from static equilibrium.
    number : callable
        Name to the symbol of a number: those that the law gives, those of the actuator, and the limits of its command
        (``minimum``, ``maximum``).
    last : casadi.SX
        Command of the instant before.
    memory : list of casadi.SX
        Memory of the law from the instant before.
    """

    seen: Lookup
    number: Lookup
    last: ca.SX
    memory: Sequence[ca.SX] = ()

    @property
    def extension_rate(self) -> ca.SX:
        """Velocity (m/s) at which body and wheel part, along the strut; positive in rebound."""
        return -self.seen("strut.velocity")

    def clip(self, command: ca.SX) -> ca.SX:
        """Clip a command to the limits of the actuator."""
        return clip(command, self.number("minimum"), self.number("maximum"))

    def between(self, share: ca.SX) -> ca.SX:
        """Command at a share (0 to 1) of the way from the smallest to the largest; of dampers from soft to firm."""
        low, high = self.number("minimum"), self.number("maximum")
        return low + (high - low) * share


class _Actuator(Description):
    """Base of all actuators: a command with its unit, and the numbers that the model of the car needs."""

    unit: ClassVar[str] = ""

    @property
    def replaces_damper(self) -> bool:
        """Whether it replaces the corner's own damper or acts beside it."""
        return True

    @property
    def structure(self) -> str:
        """Text that identifies the equations of the actuator, without their numbers."""
        raise NotImplementedError

    @property
    def plant_numbers(self) -> dict[str, float]:
        """Numbers of those equations, SI."""
        raise NotImplementedError

    @property
    def limits(self) -> tuple[float, float]:
        """Smallest and largest command, in the unit of the command."""
        raise NotImplementedError

    @property
    def rest(self) -> float:
        """Command before the first control instant."""
        return self.limits[0]

    def complete_for(self, corner: CornerModel) -> Self:  # noqa: ARG002 - others need it
        """Return the same actuator with all missing numbers filled in for a corner."""
        return self

    def force_of(self, command: ca.SX, now: Instant) -> ca.SX:
        """Strut force (N) that a command gives without lag."""
        raise NotImplementedError

    def command_for_force(self, force: ca.SX, now: Instant) -> ca.SX:
        """Command that comes nearest to a strut force (N, compression positive).

        A damper can only give forces that resist its velocity, within its limits.
        """
        raise NotImplementedError

    def command_for_coefficient(self, coefficient: ca.SX, now: Instant) -> ca.SX:
        """Command that comes nearest to a damping coefficient of the strut, N s/m."""
        return self.command_for_force(coefficient * now.seen("strut.velocity"), now)


class SemiActiveDamper(_Actuator):
    """Damper whose coefficient is commanded: ``F = c * velocity``, in place of the corner's own damper.

    Attributes
    ----------
    minimum, maximum : float or None
        Bounds of the coefficient, N s/m; left out: 0.2 and 8/3 of the corner's own damping coefficient.
    lag : float
        Time constant of the first-order lag of the coefficient, s; 0: none.
    rate_limit : float or None
        Fastest change of the commanded coefficient, N s/m per s.
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
                    "maximum = {maximum:g} N*s/m does not lie above minimum = {minimum:g} N*s/m; swap them, "
                    "or give the damper a range to work in",
                    maximum=self.maximum,
                    minimum=self.minimum,
                )
            )
        return self

    @property
    def structure(self) -> str:
        """Its equations."""
        return f"semi-active, lag {self.lag > 0.0}"

    @property
    def plant_numbers(self) -> dict[str, float]:
        """Numbers of those equations, SI."""
        return {"lag": self.lag} if self.lag > 0.0 else {}

    @property
    def limits(self) -> tuple[float, float]:
        """Smallest and largest coefficient, N s/m."""
        if self.minimum is None or self.maximum is None:
            raise AssertionError("the damper is resolved first")
        return self.minimum, self.maximum

    def complete_for(self, corner: CornerModel) -> Self:
        """Return the same damper with both bounds."""
        low = SOFTEST * corner.reference_damping if self.minimum is None else self.minimum
        high = FIRMEST * corner.reference_damping if self.maximum is None else self.maximum
        table = {**self.model_dump(exclude_none=True), "minimum": low, "maximum": high}
        return type(self).from_table(table, where="actuator")

    def force_of(self, command: ca.SX, now: Instant) -> ca.SX:
        """Strut force, N."""
        return command * now.seen("strut.velocity")

    def command_for_force(self, force: ca.SX, now: Instant) -> ca.SX:
        """Coefficient, N s/m; the softest where the force would drive the motion."""
        velocity = now.seen("strut.velocity")
        wanted = force * velocity / ca.fmax(velocity * velocity, 1e-12)
        return ca.if_else(force * velocity > 0.0, now.clip(wanted), now.number("minimum"))

    def command_for_coefficient(self, coefficient: ca.SX, now: Instant) -> ca.SX:
        """The coefficient itself within the limits, N s/m."""
        return now.clip(coefficient)


class ActiveActuator(_Actuator):
    """Force actuator beside spring and damper, or in place of the damper; positive pushes body and wheel apart.

    Attributes
    ----------
    force_limit : float or None
        Largest force, N; left out: half of the corner's static load.
    lag : float
        Time constant of a first-order lag, s; 0: none.
    bandwidth : float or None
        Natural frequency of a second-order actuator instead of the lag, Hz (hydraulic ones: 20 to 25 Hz).
    damping_ratio : float
        Of the second-order actuator; below 1 the force overshoots its command, and its limit, for a moment.
    rate_limit : float or None
        Fastest change of the commanded force, N/s.
    in_place_of_damper : bool
        Whether the corner's own damper is taken out: the command is the damper's force, too.
    in_place_of : {"spring", "stops", "tyre"} or None
        Another element whose force comes from an FMU. The rig's own element stays and bridges the time between two
        instants: the command is the difference between the FMU's force and its own. It has neither lag nor limits.
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
        """Whether the corner's own damper is taken out."""
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
                    "a force in place of the {in_place_of} has no {given}; leave it out, or leave out in_place_of",
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
        """Its equations."""
        if self.in_place_of is not None:
            return f"active, in place of the {self.in_place_of}"
        order = "second order" if self.bandwidth is not None else f"lag {self.lag > 0.0}"
        return f"active, {order}{', no damper' if self.in_place_of_damper else ''}"

    @property
    def plant_numbers(self) -> dict[str, float]:
        """Numbers of those equations, SI."""
        if self.bandwidth is not None:
            return {"bandwidth": self.bandwidth, "damping_ratio": self.damping_ratio}
        return {"lag": self.lag} if self.lag > 0.0 else {}

    @property
    def order(self) -> int:
        """States between command and force: 0, 1 or 2."""
        return 2 if self.bandwidth is not None else int(self.lag > 0.0)

    @property
    def equations(self) -> tuple[Array, Array]:
        """Matrices of the force's own states (force first), and how the command drives them, SI."""
        if self.bandwidth is None:
            return np.array([[-1.0 / self.lag]]), np.array([[1.0 / self.lag]])
        w = 2.0 * math.pi * self.bandwidth
        return np.array([[0.0, 1.0], [-(w**2), -2.0 * self.damping_ratio * w]]), np.array(
            [[0.0], [w**2]]
        )

    @property
    def limits(self) -> tuple[float, float]:
        """Smallest and largest force, N."""
        if self.force_limit is None:
            raise AssertionError("the actuator is resolved first")
        return -self.force_limit, self.force_limit

    @property
    def rest(self) -> float:
        """No force, N."""
        return 0.0

    def complete_for(self, corner: CornerModel) -> Self:
        """Return the same actuator with its limit."""
        if self.in_place_of is not None:
            return BaseModel.model_copy(
                self, update={"force_limit": math.inf}
            )  # none, which no description may give
        limit = (
            0.5 * corner.sprung_mass * corner.gravity
            if self.force_limit is None
            else self.force_limit
        )
        return self.model_copy(update={"force_limit": limit})

    def force_of(self, command: ca.SX, now: Instant) -> ca.SX:  # noqa: ARG002
        """The command itself, N."""
        return command

    def command_for_force(self, force: ca.SX, now: Instant) -> ca.SX:
        """The force within its limits, N."""
        return now.clip(force)


class MagnetorheologicalDamper(_Actuator):
    """Magneto-rheological damper in place of the corner's own: a hysteretic law that moves with the voltage.

    Both laws come from measurements (:func:`jounce.fit_damper` gives their tables); every number is interpolated
    between them by the voltage that has arrived, a first-order lag behind the command.

    Attributes
    ----------
    off, on : TanhDamper or BoucWenDamper
        Law at 0 V and at ``maximum``; both of the same kind.
    maximum : float
        Largest voltage, V.
    lag : float
        Time constant of the voltage, s; 0: none.
    rate_limit : float or None
        Fastest change of the commanded voltage, V/s.

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
                    "off is a {kind!r} law and on a {second_kind!r} one; give two of one kind",
                    kind=self.off.kind,
                    second_kind=self.on.kind,
                )
            )
        return self

    @property
    def structure(self) -> str:
        """Its equations."""
        return f"magnetorheological, {self.off.kind}, lag {self.lag > 0.0}"

    @property
    def plant_numbers(self) -> dict[str, float]:
        """Numbers of those equations, SI."""
        numbers = {
            **parameters_of(self.off, "off."),
            **parameters_of(self.on, "on."),
            "maximum": self.maximum,
        }
        return {**numbers, "lag": self.lag} if self.lag > 0.0 else numbers

    @property
    def limits(self) -> tuple[float, float]:
        """Smallest and largest voltage, 0 and ``maximum``, SI."""
        return 0.0, self.maximum

    def force_of(self, command: ca.SX, now: Instant) -> ca.SX:
        """Strut force, N."""
        off, on = self._force("off", now), self._force("on", now)
        low, high = now.number("minimum"), now.number("maximum")
        return off + (on - off) * (command - low) / (high - low)

    def command_for_force(self, force: ca.SX, now: Instant) -> ca.SX:
        """Voltage, V, by the share of the force between the two laws."""
        off, on = self._force("off", now), self._force("on", now)
        share = (force - off) * (on - off) / ca.fmax((on - off) ** 2, 1e-12)
        return now.between(clip(share, 0.0, 1.0))

    def _force(self, end: str, now: Instant) -> ca.SX:
        """Force (N) at one end of the voltage."""
        deflection = now.seen("strut.deflection") + now.number("static_deflection")
        law: TanhDamper | BoucWenDamper = getattr(self, end)
        return law.evaluate(
            _ControllerPoint(
                lambda name: now.number(f"{end}.{name}"), now.seen("strut.velocity"), deflection
            )
        )


class _ControllerPoint(SampledPoint):
    """Operating point of a damper law as a controller sees it: only the side of the hysteresis is known."""

    def state(self, name: str, rate: Callable[[Any], Any]) -> Any:  # noqa: ARG002
        """Return the state that a motion in this direction leads to."""
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
