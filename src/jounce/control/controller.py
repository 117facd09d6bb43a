"""What all controllers share: an actuator, a fixed rate, sensor noise, and a law written as symbols."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Annotated, Any, ClassVar, Literal, Protocol, Self

import casadi as ca
import numpy as np
from pydantic import BeforeValidator, Field, model_validator

from jounce.control.actuators import ActiveActuator, Actuator, Lookup, Means, SemiActiveDamper
from jounce.control.design import CornerModel
from jounce.core.description import Description
from jounce.core.errors import JounceError, SimulationError, unknown
from jounce.core.types import Array
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


class Regulator(Protocol):
    """What the loop calls at every control instant."""

    channels: tuple[str, ...]
    """Measurements wanted."""
    from_rest: bool
    """Whether they are changes from static equilibrium."""

    def start(self) -> None:
        """Forget everything: a run begins."""

    def __call__(self, values: list[float]) -> list[float]:
        """Commands from measurements, of which the last is the time (s)."""


@dataclass(frozen=True)
class Setting:
    """What a regulator knows of the run.

    Attributes
    ----------
    controllers, models : mapping
        Corner to its resolved controller, and to what it is.
    outputs : tuple of str
        All channels of the model.
    instants : int
        Control instants of the run.
    road : callable
        Corner and times (s) to the road's height (m) under its wheel.
    """

    controllers: Mapping[str, Controller]
    models: Mapping[str, CornerModel]
    outputs: tuple[str, ...]
    instants: int
    road: Callable[[str, Array], Array]


class CallbackController(Controller):
    """A controller that runs in Python."""

    def regulator(self, setting: Setting) -> Regulator:
        """Give what the loop calls."""
        raise NotImplementedError


class PythonControl(CallbackController):
    """A plain Python function in the loop: ``function(measurement, t) -> command``.

    ``measurement`` is a dict of all channels of the model (SI, with noise where there is some), ``t`` the time in s.
    The command is a number for a quarter car; for a vehicle a dict of corners or a sequence in the order of its
    corners. It is clipped to the limits of the actuator.

    Attributes
    ----------
    function : callable
        Called once a control period.

    Examples
    --------
    >>> def firm_in_rebound(measurement, t):
    ...     return 3000.0 if measurement["strut.velocity"] < 0.0 else 500.0   # N s/m
    >>> PythonControl(function=firm_in_rebound, rate="200 Hz").rate
    200.0
    """

    law: Literal["python"] = "python"
    function: Callable[..., Any]
    actuator: Actuator = SemiActiveDamper()

    def regulator(self, setting: Setting) -> Regulator:
        """Give what the loop calls."""
        return _Own(self.function, setting)


class _Measurement(dict[str, float]):
    """Channels by name; one that is not there is said with the nearest name."""

    def __missing__(self, name: str) -> float:
        raise unknown(str(name), self, what="channel", where="measurement")


class _Own:
    """A user's function with its answer checked, clipped and held back."""

    from_rest = False

    def __init__(self, function: Callable[[dict[str, float], float], Any], setting: Setting) -> None:
        self._function = function
        self.channels = setting.outputs
        self._corners = tuple(setting.controllers)
        self._limits = Limits(setting.controllers)

    def start(self) -> None:
        """Begin a run."""
        self._limits.start()

    def __call__(self, values: list[float]) -> list[float]:
        """Commands from measurements."""
        measurement = _Measurement(zip(self.channels, values, strict=False))  # behind the channels stands the time
        answer = self._function(measurement, values[-1])
        if type(answer) is float and len(self._corners) == 1:
            return self._limits.kept([answer])
        return self._limits.kept(self._commands(answer, values[-1]))

    def _commands(self, answer: Any, t: float) -> list[float]:
        corners = self._corners
        if isinstance(answer, Mapping):
            unknown = [name for name in answer if name not in corners]
            if unknown or len(answer) != len(corners):
                raise _refused(f"corners {', '.join(map(str, answer))}", corners, t)
            answer = [answer[name] for name in corners]
        elif isinstance(answer, np.ndarray):
            answer = answer.tolist()
        commands = list(answer) if isinstance(answer, Sequence) and not isinstance(answer, str) else [answer]
        if len(commands) != len(corners):
            raise _refused(repr(answer), corners, t)
        try:
            return [float(command) for command in commands]
        except (TypeError, ValueError):
            raise _refused(repr(answer), corners, t) from None


def _refused(found: str, corners: tuple[str, ...], t: float) -> SimulationError:
    several = f"{len(corners)} numbers: a dict or a sequence for {', '.join(corners)}"
    return SimulationError(
        "the controller's answer is not a command",
        where=f"control function at t = {t:.6g} s",
        found=found,
        allowed=several if len(corners) > 1 else "one number",
    )


class Limits:
    """Limits and rate limits of all commands."""

    def __init__(self, controllers: Mapping[str, Controller]) -> None:
        actuators = [controller.actuator for controller in controllers.values()]
        self._limits = [actuator.limits for actuator in actuators]
        rates = [actuator.rate_limit for actuator in actuators]
        periods = [1.0 / controller.rate for controller in controllers.values()]
        self._steps = [math.inf if rate is None else rate * period for rate, period in zip(rates, periods, strict=True)]
        self._rest = [actuator.rest for actuator in actuators]
        self.last = list(self._rest)

    def start(self) -> None:
        """Begin from the commands of rest."""
        self.last = list(self._rest)

    def kept(self, commands: list[float]) -> list[float]:
        """Commands clipped and held back; those that are no numbers stay as they are."""
        found = []
        for command, before, step, (low, high) in zip(commands, self.last, self._steps, self._limits, strict=True):
            clipped = low if command < low else high if command > high else command
            change = clipped - before
            found.append(before + step if change > step else before - step if change < -step else clipped)
        self.last = found
        return found
