"""What all controllers share: an actuator, a fixed rate, sensor noise, and a law written as symbols."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Annotated, Any, ClassVar, Literal, Self

import casadi as ca
from pydantic import BeforeValidator, Field, model_validator

from jounce.control.actuators import ActiveActuator, Actuator, SemiActiveDamper
from jounce.control.conversion import Lookup, Means
from jounce.control.corner import CornerModel
from jounce.core.description import Description
from jounce.core.errors import JounceError
from jounce.core.units import Frequency, Unit, to_si
from jounce.recordings.schema import channel_unit


def _noise(value: object) -> object:
    """Standard deviations by channel word, text with units or SI."""
    if not isinstance(value, Mapping):
        return value
    try:
        found = {str(name): to_si(number, channel_unit(str(name)), where=str(name)) for name, number in value.items()}
    except JounceError as error:
        raise ValueError(str(error)) from None
    for name, number in found.items():
        if number < 0.0:
            raise ValueError(f"{name}: a standard deviation of {number:g} is below 0")
    return found


Noise = Annotated[dict[str, Annotated[float, Unit("1")]], BeforeValidator(_noise)]  # in the unit of the channel


@dataclass
class Decision:
    """What a law gives at an instant: the command, and its memory for the next instant."""

    command: ca.SX
    memory: list[ca.SX] = field(default_factory=list)


class Controller(Description):
    """Base of all controllers: each corner is controlled by itself, from what is measured at this corner.

    Attributes
    ----------
    actuator : SemiActiveDamper, ActiveActuator or MagnetorheologicalDamper
        What the commands go to.
    rate : float
        Control instants per second, Hz; a command holds until the next one.
    noise : dict
        Standard deviation of the sensors by channel (SI or text): ``{"sprung.az": "0.05 m/s^2"}``; white, at every
        corner.
    seed : int
        Of the noise.
    """

    schema_: Literal["jounce.control/1"] = Field(default="jounce.control/1", alias="schema")
    actuator: Actuator = SemiActiveDamper()
    rate: Frequency = 1000.0
    noise: Noise = {}
    seed: int = 0

    needs_wheel: ClassVar[bool] = False
    """Whether the gains need a wheel with mass and tyre."""

    @property
    def name(self) -> str:
        """Word of the law."""
        return str(getattr(self, "law", "control"))

    @property
    def memory_size(self) -> int:
        """Numbers that the law keeps from one instant to the next, for one corner."""
        return 0

    def decide(self, seen: Lookup, memory: list[ca.SX], number: Lookup, means: Means) -> Decision:
        """Write the law of one corner.

        Parameters
        ----------
        seen : callable
            Channel without its corner (``"sprung.vz"``) to its symbol, as a change from static equilibrium.
        memory : list of casadi.SX
            What was kept.
        number : callable
            Name to the symbol of a number of :meth:`numbers`.
        means : Means
            The actuator.
        """
        raise NotImplementedError

    def numbers(self, corner: CornerModel) -> dict[str, float]:
        """Give the numbers of the law for a corner, SI."""
        raise NotImplementedError

    def resolved(self, corner: CornerModel) -> Self:
        """Give the same controller with its actuator's open numbers filled in for a corner."""
        return self.model_copy(update={"actuator": self.actuator.resolved(corner)})


class DamperLaw(Controller):
    """A law that switches a damper between soft and firm; a force actuator is refused."""

    @model_validator(mode="after")
    def _is_a_damper(self) -> Self:
        if isinstance(self.actuator, ActiveActuator):
            raise ValueError(
                f"the law {self.name!r} switches a damper; found an active actuator; "
                "allowed: semi-active, magnetorheological"
            )
        return self


class ForceLaw(Controller):
    """A law that wishes a force; a damper gives what it can of it."""

    def force(self, seen: Lookup, number: Lookup) -> ca.SX:
        """Wished force (N) on the body at the wheel, up positive; the wheel feels the opposite."""
        raise NotImplementedError

    def decide(self, seen: Lookup, memory: list[ca.SX], number: Lookup, means: Means) -> Decision:  # noqa: ARG002
        """Write the law of one corner."""
        return Decision(means.command_for_force(self.force(seen, number) / number("motion_ratio")))


def step(x: ca.SX) -> ca.SX:
    """1 where ``x`` is not below zero, 0 elsewhere."""
    return ca.if_else(x >= 0.0, 1.0, 0.0)


def extension_rate(seen: Lookup) -> ca.SX:
    """Velocity (m/s) at which body and wheel part, along the strut; positive in rebound."""
    return -seen("strut.velocity")


def given(value: float | None, otherwise: Callable[[], float]) -> float:
    """A number, or what stands for it."""
    return otherwise() if value is None else value


def described(kind: type[Controller], table: dict[str, Any], *, where: str = "", text: str = "") -> Controller:
    """Build a controller from its table."""
    return kind.from_table(table, where=where, text=text)
