"""Base class and catalogue of controllers, and controllers that run in Python."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal, Protocol, Self

import casadi as ca
import numpy as np
from pydantic import BaseModel, BeforeValidator, Field, model_validator

from jounce.control.actuators import (
    ActiveActuator,
    Actuator,
    AnyActuator,
    Instant,
    SemiActiveDamper,
)
from jounce.control.design import CornerModel
from jounce.core.description import Description, Seed, check_schema, read_toml
from jounce.core.errors import DescriptionError, JounceError, SimulationError, show_value, unknown
from jounce.core.findings import Finding
from jounce.core.kinds import Rows
from jounce.core.misplaced import error_at, misplaced_value
from jounce.core.old_names import old_method, with_old_names
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.core.units import Frequency, Unit, to_si
from jounce.recordings.schema import channel_unit

SCHEMA = "jounce.control/1"


@dataclass(frozen=True)
class Kind:
    """Named controller: class, one-line summary, and fields that differ from the class defaults."""

    law: type[Controller]
    summary: str
    fields: dict[str, Any]


class _Controls(Rows[Kind]):
    """Controllers, ordered by module and class."""

    def _order(self, item: tuple[str, Kind]) -> str:
        return item[1].law.__module__


CONTROLS = _Controls("jounce.control")
"""Controllers by name."""
FILE_CONTROLS = _Controls("jounce.control")
"""Controllers that require a file, by its ``law``."""


def _read_noise(value: object) -> object:
    """Read standard deviations by channel, given as text with units or in SI."""
    if not isinstance(value, Mapping):
        return value
    try:
        deviations = {
            str(name): to_si(number, channel_unit(str(name)), where=str(name))
            for name, number in value.items()
        }
    except JounceError as error:
        raise misplaced_value((), error) from None
    for name, number in deviations.items():
        if number < 0.0:
            raise ValueError(
                Phrase(
                    "{name}: a standard deviation of {number:g} is below 0",
                    name=name,
                    number=number,
                )
            )
    return deviations


Noise = Annotated[
    dict[str, Annotated[float, Unit("1")]], BeforeValidator(_read_noise)
]  # in the unit of the channel


@dataclass(frozen=True)
class Decision:
    """Result of a law at one instant: the command, and the memory for the next instant."""

    command: ca.SX
    memory: Sequence[ca.SX] = ()


class Controller(Description):
    """Base of all controllers: each corner is controlled separately, from measurements of that corner.

    Defining a subclass registers the names in its ``catalogue``.

    Attributes
    ----------
    actuator : SemiActiveDamper, ActiveActuator or MagnetorheologicalDamper
        Actuator that receives the commands.
    rate : float
        Control rate, Hz; a command is held until the next instant.
    noise : dict
        Standard deviation of white sensor noise by channel (SI or text): ``{"sprung.az": "0.05 m/s^2"}``; applies to
        every corner.
    seed : int
        Seed of the noise.
    """

    schema_: Literal["jounce.control/1"] = Field(default="jounce.control/1", alias="schema")
    actuator: Actuator = SemiActiveDamper()
    rate: Frequency = 1000.0
    noise: Noise = {}
    seed: Seed = 0

    catalogue: ClassVar[Mapping[str, tuple[str, AnyActuator | None]]] = {}
    """Name to (one-line summary, actuator)."""
    from_file: ClassVar[str] = ""
    """One-line summary of a controller that needs a file; the file selects it by its ``law``."""
    needs_wheel: ClassVar[bool] = False
    """Whether the gains require a wheel with mass and tyre."""
    is_element: ClassVar[bool] = False
    """Whether it may replace the force of a spring, of stops or of a tyre."""
    memory_size: ClassVar[int] = 0
    """Size of the memory of one corner between instants."""

    @classmethod
    def __pydantic_init_subclass__(cls, **_: Any) -> None:
        for name, (summary, actuator) in vars(cls).get("catalogue", {}).items():
            CONTROLS.add(
                name, Kind(cls, summary, {} if actuator is None else {"actuator": actuator})
            )
        if summary := vars(cls).get("from_file", ""):
            FILE_CONTROLS.add(cls.model_fields["law"].default, Kind(cls, summary, {}))

    @model_validator(mode="after")
    def _check_place(self) -> Self:
        place = getattr(self.actuator, "in_place_of", None)
        if place is not None and not self.is_element:
            raise ValueError(
                Phrase(
                    "actuator: the law {name!r} cannot replace the {place}; only an FMU can",
                    name=self.name,
                    place=place,
                )
            )
        return self

    @property
    def name(self) -> str:
        """Name of the law."""
        return str(getattr(self, "law", "control"))

    def decide(self, now: Instant) -> Decision:
        """Return the law's decision for one corner at one instant, as symbols."""
        raise NotImplementedError

    def numbers(self, corner: CornerModel) -> dict[str, float]:  # noqa: ARG002 - others need it
        """Return the parameters of the law for a corner, SI; none by default."""
        return {}

    def resolve_paths(self, folder: Path) -> Self:  # noqa: ARG002 - others need it
        """Return a copy of the controller with file names resolved against a folder."""
        return self

    def with_rate_for(self, fastest: float) -> Self:  # noqa: ARG002 - others need it
        """Return a copy of the controller with its rate set, if it depends on the rig's fastest mode (rad/s)."""
        return self

    def complete_for(self, corner: CornerModel) -> Self:
        """Return a copy of the controller with missing values of its actuator set for a corner."""
        return BaseModel.model_copy(
            self, update={"actuator": self.actuator.complete_for(corner)}
        )  # already validated

    beside: ClassVar[Any] = old_method("Controller.beside", "resolve_paths")
    paced: ClassVar[Any] = old_method("Controller.paced", "with_rate_for")
    resolved: ClassVar[Any] = old_method("Controller.resolved", "complete_for")


class ForceLaw(Controller):
    """Law that demands a force; a damper provides the part that it can produce."""

    def force(self, now: Instant) -> ca.SX:
        """Return the demanded force (N) on the body at the wheel, positive up; the opposite force acts on the wheel."""
        raise NotImplementedError

    def decide(self, now: Instant) -> Decision:
        """Return the command for that force."""
        return Decision(
            self.actuator.command_for_force(self.force(now) / now.number("motion_ratio"), now)
        )


class TwoStateLaw(Controller):
    """Law that switches a damper between soft and firm; it accepts no force actuator."""

    def product(self, now: Instant) -> ca.SX:
        """Return the switching function: the damper is firm if it is zero or positive."""
        raise NotImplementedError

    def decide(self, now: Instant) -> Decision:
        """Return the firm or the soft command."""
        return Decision(now.between(ca.if_else(self.product(now) >= 0.0, 1.0, 0.0)))

    @model_validator(mode="after")
    def _check_is_damper(self) -> Self:
        if isinstance(self.actuator, ActiveActuator):
            what = Phrase("the law {name} is for a switched damper", name=show_value(self.name))
            raise error_at(
                (),
                what,
                found=Phrase("an active actuator"),
                allowed="semi-active, magnetorheological",
            )
        return self


__getattr__ = with_old_names(__name__, {"DamperLaw": "TwoStateLaw"})


def or_default(value: float | None, default: float) -> float:
    """Return the value, or the default if it is None."""
    return default if value is None else value


def controller(name: str | Path, **changes: Any) -> Controller:
    """Return a controller by name, or from a TOML file.

    Parameters
    ----------
    name : str or Path
        A name from :data:`CONTROLS`, or the path of a file with schema ``jounce.control/1``.
    **changes
        Fields that override those of the name or the file.

    Returns
    -------
    Controller
        The immutable description.

    Raises
    ------
    DescriptionError
        For an unknown name (with the nearest match) or an invalid file.

    Examples
    --------
    >>> controller("skyhook", rate="500 Hz").rate
    500.0
    """
    if isinstance(name, Path) or str(name).endswith(".toml"):
        base = _load(Path(name))
        return type(base).from_table(
            {**base.model_dump(by_alias=True, exclude_unset=True), **changes}
        )
    if name not in CONTROLS:
        raise unknown(name, CONTROLS, what="controller", where="control")
    kind = CONTROLS[name]
    return kind.law.from_table({**kind.fields, **changes}, where=name)


def _load(path: Path) -> Controller:
    table, text = read_toml(path)
    check_schema(table, (SCHEMA,), str(path))
    law, known = table.get("law"), {**CONTROLS, **FILE_CONTROLS}
    if not isinstance(law, str) or law not in known:
        raise unknown(str(law), known, what="law", where=f"{path}: law")
    kind = known[law]
    own = kind.law.model_fields["law"].default
    law_of_file = kind.law.from_table(
        {**kind.fields, **table, "law": own}, where=str(path), text=text
    )
    return law_of_file.resolve_paths(path.parent)


def as_controller(value: Controller | str | Path | Callable[..., Any]) -> Controller:
    """Convert a name, a file or a Python function to a controller.

    Parameters
    ----------
    value : Controller, str, Path or callable
        Controller, its name or file, or a function of ``(measurement, t)`` that returns the command (see
        :class:`PythonControl`).
    """
    if isinstance(value, Controller):
        return value
    if isinstance(value, str | Path):
        return controller(value)
    if callable(value):
        return PythonControl(function=value)
    raise DescriptionError(
        "not a controller",
        where="control",
        found=value,
        allowed="a controller, its name, a file, or a function",
    )


class Regulator(Protocol):
    """Object that the loop calls at every control instant."""

    channels: tuple[str, ...]
    """Channels to measure."""
    from_rest: bool
    """Whether measurements are changes from static equilibrium."""

    @property
    def findings(self) -> Sequence[Finding]:
        """Findings to report with the run."""

    def start(self) -> None:
        """Reset the state at the start of a run."""

    def __call__(self, values: list[float]) -> list[float]:
        """Return commands from measurements; the last measurement is time (s)."""

    def answer(self, rest: Array) -> tuple[Array, Array] | None:
        """Return derivatives of (commands, memory) at rest by memory and measurements, or None if unknown."""


@dataclass(frozen=True)
class RunSetting:
    """Data of a run for controllers in Python.

    Attributes
    ----------
    controllers, models : mapping
        Resolved controller and corner model by corner.
    units : mapping
        SI units of all channels of the model.
    instants : int
        Number of control instants.
    road : callable
        Function of corner and times (s) that returns the road height (m) under its wheel.
    """

    controllers: Mapping[str, Controller]
    models: Mapping[str, CornerModel]
    units: Mapping[str, str]
    instants: int
    road: Callable[[str, Array], Array]


class CallbackController(Controller):
    """Controller that runs in Python."""

    @property
    def place(self) -> str:
        """Location of the controller in messages."""
        return f"control: {self.name}"

    def regulator(self, setting: RunSetting) -> Regulator:
        """Return the object that the loop calls."""
        raise NotImplementedError


class PythonControl(CallbackController):
    """Controller that calls a Python function: ``function(measurement, t) -> command``.

    ``measurement`` is a dict of all channels of the model (SI, including sensor noise), ``t`` is time in s. The
    command is a number for a quarter car; for a vehicle it is a dict by corner or a sequence in the order of corners.
    It is clipped to the limits of the actuator.

    Attributes
    ----------
    function : callable
        Function called once per control period.

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

    def regulator(self, setting: RunSetting) -> Regulator:
        """Return the object that the loop calls."""
        return _OwnFunction(self.function, setting)


class _Measurement(dict[str, float]):
    """Channels by name; the error about a missing channel suggests the nearest name."""

    def __missing__(self, name: str) -> float:
        raise unknown(str(name), self, what="channel", where="measurement")


class _OwnFunction:
    """User function; its result is validated, clipped and rate-limited."""

    from_rest = False
    findings = ()

    def __init__(
        self, function: Callable[[dict[str, float], float], Any], setting: RunSetting
    ) -> None:
        self._function = function
        self.channels = tuple(setting.units)
        self._corners = tuple(setting.controllers)
        self._limits = CommandLimits(setting.controllers)

    def start(self) -> None:
        """Start a run."""
        self._limits.start()

    def answer(self, rest: Array) -> None:
        """Return None: the derivatives of a user function are unknown."""

    def __call__(self, values: list[float]) -> list[float]:
        """Return commands from measurements."""
        measurement = _Measurement(
            zip(self.channels, values, strict=False)
        )  # the last value is the time
        answer = self._function(measurement, values[-1])
        if type(answer) is float and len(self._corners) == 1:
            return self._limits.apply([answer])
        return self._limits.apply(self._commands(answer, values[-1]))

    def _commands(self, answer: Any, t: float) -> list[float]:
        corners = self._corners
        if isinstance(answer, np.ndarray):
            answer = answer.tolist()
        given_answer = repr(answer)
        if isinstance(answer, Mapping):
            if set(answer) == set(corners):
                answer = [answer[name] for name in corners]
                given_answer = repr(answer)
            else:
                given_answer, answer = f"corners {', '.join(map(str, answer))}", []
        commands = (
            list(answer)
            if isinstance(answer, Sequence) and not isinstance(answer, str)
            else [answer]
        )
        if len(commands) == len(corners):
            with contextlib.suppress(TypeError, ValueError):
                return [float(command) for command in commands]
        several = Phrase(
            "{count} numbers: a dict or a sequence for {corners}",
            count=len(corners),
            corners=", ".join(corners),
        )
        raise SimulationError(
            "the controller did not return a valid command",
            where=f"control function at t = {t:.6g} s",
            found=given_answer,
            allowed=several if len(corners) > 1 else "one number",
        )


class CommandLimits:
    """Limits and rate limits of all commands."""

    def __init__(self, controllers: Mapping[str, Controller]) -> None:
        actuators = [controller.actuator for controller in controllers.values()]
        self._limits = [actuator.limits for actuator in actuators]
        rates = [actuator.rate_limit for actuator in actuators]
        periods = [1.0 / controller.rate for controller in controllers.values()]
        self._steps = [
            math.inf if rate is None else rate * period
            for rate, period in zip(rates, periods, strict=True)
        ]
        self._rest = [actuator.rest for actuator in actuators]
        self.last = list(self._rest)

    def start(self) -> None:
        """Reset to the commands at rest."""
        self.last = list(self._rest)

    def apply(self, commands: list[float]) -> list[float]:
        """Return the commands clipped and rate-limited; NaN for commands that are not finite."""
        limited = []
        for command, before, step, (low, high) in zip(
            commands, self.last, self._steps, self._limits, strict=True
        ):
            if not math.isfinite(command):
                limited.append(math.nan)
                continue
            clipped = min(max(command, low), high)
            change = clipped - before
            limited.append(
                before + step if change > step else before - step if change < -step else clipped
            )
        self.last = limited
        return limited
