"""Controllers: what all of them share, the catalogue that knows them by name, and those that run in Python."""

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

from jounce.control.actuators import ActiveActuator, Actuator, AnyActuator, Instant, SemiActiveDamper
from jounce.control.design import CornerModel
from jounce.core.description import Description, Seed, check_schema, read_toml
from jounce.core.errors import DescriptionError, JounceError, SimulationError, shown, unknown
from jounce.core.findings import Finding
from jounce.core.kinds import Rows
from jounce.core.misplaced import misplaced, misplaced_value
from jounce.core.old_names import with_old_names
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.core.units import Frequency, Unit, to_si
from jounce.recordings.schema import channel_unit

SCHEMA = "jounce.control/1"


@dataclass(frozen=True)
class Kind:
    """A controller known by name: its class, one line about it, and the values that are not the class's defaults."""

    law: type[Controller]
    summary: str
    fields: dict[str, Any]


class _Controls(Rows[Kind]):
    """Controllers in the order in which modules and classes are written."""

    def _order(self, item: tuple[str, Kind]) -> str:
        return item[1].law.__module__


CONTROLS = _Controls("jounce.control")
"""Controllers by name."""
FILE_CONTROLS = _Controls("jounce.control")
"""Controllers that need more than a name, by the ``law`` of their files."""


def _noise(value: object) -> object:
    """Standard deviations by channel, text with units or SI."""
    if not isinstance(value, Mapping):
        return value
    try:
        found = {str(name): to_si(number, channel_unit(str(name)), where=str(name)) for name, number in value.items()}
    except JounceError as error:
        raise misplaced_value((), error) from None
    for name, number in found.items():
        if number < 0.0:
            raise ValueError(f"{name}: a standard deviation of {number:g} is below 0")
    return found


Noise = Annotated[dict[str, Annotated[float, Unit("1")]], BeforeValidator(_noise)]  # in the unit of the channel


@dataclass(frozen=True)
class Decision:
    """What a law gives at an instant: the command, and what it keeps for the next instant."""

    command: ca.SX
    memory: Sequence[ca.SX] = ()


class Controller(Description):
    """Base of all controllers: each corner is controlled by itself, from what is measured at this corner.

    A subclass is known by the names in its ``catalogue`` as soon as it is defined.

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
    seed: Seed = 0

    catalogue: ClassVar[Mapping[str, tuple[str, AnyActuator | None]]] = {}
    """Name to a line about it, and its actuator."""
    from_file: ClassVar[str] = ""
    """What a controller is in a line that no name is enough for: a file says the rest, under its ``law``."""
    needs_wheel: ClassVar[bool] = False
    """Whether the gains need a wheel with mass and tyre."""
    is_element: ClassVar[bool] = False
    """Whether it may give the force of a spring, of stops or of a tyre."""
    memory_size: ClassVar[int] = 0
    """Numbers that the law keeps from one instant to the next, for one corner."""

    @classmethod
    def __pydantic_init_subclass__(cls, **_: Any) -> None:
        for name, (summary, actuator) in vars(cls).get("catalogue", {}).items():
            CONTROLS.add(name, Kind(cls, summary, {} if actuator is None else {"actuator": actuator}))
        if summary := vars(cls).get("from_file", ""):
            FILE_CONTROLS.add(cls.model_fields["law"].default, Kind(cls, summary, {}))

    @model_validator(mode="after")
    def _fits_its_actuator(self) -> Self:
        place = getattr(self.actuator, "in_place_of", None)
        if place is not None and not self.is_element:
            raise ValueError(f"actuator: the law {self.name!r} cannot stand in place of the {place}; only an FMU can")
        return self

    @property
    def name(self) -> str:
        """Word of the law."""
        return str(getattr(self, "law", "control"))

    def decide(self, now: Instant) -> Decision:
        """Write the law of one corner at one instant, as symbols."""
        raise NotImplementedError

    def numbers(self, corner: CornerModel) -> dict[str, float]:  # noqa: ARG002 - others need it
        """Numbers of the law for a corner, SI; none by default."""
        return {}

    def beside(self, folder: Path) -> Self:  # noqa: ARG002 - others need it
        """Give the same controller with the files that it names found from a folder."""
        return self

    def paced(self, fastest: float) -> Self:  # noqa: ARG002 - others need it
        """Give the same with its rate, where that follows from the rig's fastest mode (rad/s)."""
        return self

    def resolved(self, corner: CornerModel) -> Self:
        """Give the same controller with its actuator's open numbers filled in for a corner."""
        return BaseModel.model_copy(self, update={"actuator": self.actuator.resolved(corner)})  # checked before


class ForceLaw(Controller):
    """A law that demands a force; a damper gives what it can of it."""

    def force(self, now: Instant) -> ca.SX:
        """Demanded force (N) on the body at the wheel, up positive; the wheel feels the opposite."""
        raise NotImplementedError

    def decide(self, now: Instant) -> Decision:
        """The command for that force."""
        return Decision(self.actuator.command_for_force(self.force(now) / now.number("motion_ratio"), now))


class TwoStateLaw(Controller):
    """A law that switches a damper between soft and firm; a force actuator is refused."""

    def product(self, now: Instant) -> ca.SX:
        """What is not below zero where the damper shall be firm."""
        raise NotImplementedError

    def decide(self, now: Instant) -> Decision:
        """Firm or soft."""
        return Decision(now.between(ca.if_else(self.product(now) >= 0.0, 1.0, 0.0)))

    @model_validator(mode="after")
    def _is_a_damper(self) -> Self:
        if isinstance(self.actuator, ActiveActuator):
            what = Phrase("the law {name} switches a damper", name=shown(self.name))
            found = Phrase("an active actuator")
            raise misplaced((), what, found=found, allowed="semi-active, magnetorheological")
        return self


__getattr__ = with_old_names(__name__, {"DamperLaw": "TwoStateLaw"})


def given(value: float | None, otherwise: float) -> float:
    """A number, or its default where it is not given."""
    return otherwise if value is None else value


def controller(name: str | Path, **changes: Any) -> Controller:
    """Give a controller by its name, or from a TOML file.

    Parameters
    ----------
    name : str or Path
        One of :data:`CONTROLS`, or a path to a file of the schema ``jounce.control/1``.
    **changes
        Fields that differ from those of the name or the file.

    Returns
    -------
    Controller
        The frozen description.

    Raises
    ------
    DescriptionError
        For an unknown name (with the nearest one) or a file that cannot be understood.

    Examples
    --------
    >>> controller("skyhook", rate="500 Hz").rate
    500.0
    """
    if isinstance(name, Path) or str(name).endswith(".toml"):
        found = _from_file(Path(name))
        return type(found).from_table({**found.model_dump(by_alias=True, exclude_unset=True), **changes})
    if name not in CONTROLS:
        raise unknown(name, CONTROLS, what="controller", where="control")
    kind = CONTROLS[name]
    return kind.law.from_table({**kind.fields, **changes}, where=name)


def _from_file(path: Path) -> Controller:
    table, text = read_toml(path)
    check_schema(table, (SCHEMA,), str(path))
    law, known = table.get("law"), {**CONTROLS, **FILE_CONTROLS}
    if not isinstance(law, str) or law not in known:
        raise unknown(str(law), known, what="law", where=f"{path}: law")
    kind = known[law]
    own = kind.law.model_fields["law"].default
    return kind.law.from_table({**kind.fields, **table, "law": own}, where=str(path), text=text).beside(path.parent)


def as_controller(value: Controller | str | Path | Callable[..., Any]) -> Controller:
    """Give a controller for what a user may say: one, its name or file, or a Python function.

    Parameters
    ----------
    value : Controller, str, Path or callable
        A function gets ``(measurement, t)`` and gives the command (see :class:`PythonControl`).
    """
    if isinstance(value, Controller):
        return value
    if isinstance(value, str | Path):
        return controller(value)
    if callable(value):
        return PythonControl(function=value)
    raise DescriptionError(
        "not a controller", where="control", found=value, allowed="a controller, its name, a file, or a function"
    )


class Regulator(Protocol):
    """What the loop calls at every control instant."""

    channels: tuple[str, ...]
    """Measurements wanted."""
    from_rest: bool
    """Whether they are changes from static equilibrium."""

    @property
    def findings(self) -> Sequence[Finding]:
        """What the reader of the run must know."""

    def start(self) -> None:
        """Forget everything: a run begins."""

    def __call__(self, values: list[float]) -> list[float]:
        """Commands from measurements, of which the last is the time (s)."""

    def answer(self, rest: Array) -> tuple[Array, Array] | None:
        """Slopes at rest of (commands, memory) along memory and measurements; None where nobody knows them."""


@dataclass(frozen=True)
class RunSetting:
    """What a controller in Python knows of the run.

    Attributes
    ----------
    controllers, models : mapping
        Corner to its resolved controller, and to its model.
    units : mapping
        All channels of the model, with their SI units.
    instants : int
        Control instants of the run.
    road : callable
        Corner and times (s) to the road's height (m) under its wheel.
    """

    controllers: Mapping[str, Controller]
    models: Mapping[str, CornerModel]
    units: Mapping[str, str]
    instants: int
    road: Callable[[str, Array], Array]


class CallbackController(Controller):
    """A controller that runs in Python."""

    @property
    def place(self) -> str:
        """Where it is to be found, for messages."""
        return f"control: {self.name}"

    def regulator(self, setting: RunSetting) -> Regulator:
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

    def regulator(self, setting: RunSetting) -> Regulator:
        """Give what the loop calls."""
        return _OwnFunction(self.function, setting)


class _Measurement(dict[str, float]):
    """Channels by name; for one that is missing the nearest name is suggested."""

    def __missing__(self, name: str) -> float:
        raise unknown(str(name), self, what="channel", where="measurement")


class _OwnFunction:
    """A user's function with its answer checked, clipped and limited in rate."""

    from_rest = False
    findings = ()

    def __init__(self, function: Callable[[dict[str, float], float], Any], setting: RunSetting) -> None:
        self._function = function
        self.channels = tuple(setting.units)
        self._corners = tuple(setting.controllers)
        self._limits = CommandLimits(setting.controllers)

    def start(self) -> None:
        """Begin a run."""
        self._limits.start()

    def answer(self, rest: Array) -> None:
        """Nobody knows what a function does."""

    def __call__(self, values: list[float]) -> list[float]:
        """Commands from measurements."""
        measurement = _Measurement(zip(self.channels, values, strict=False))  # the time follows the channels
        answer = self._function(measurement, values[-1])
        if type(answer) is float and len(self._corners) == 1:
            return self._limits.kept([answer])
        return self._limits.kept(self._commands(answer, values[-1]))

    def _commands(self, answer: Any, t: float) -> list[float]:
        corners = self._corners
        if isinstance(answer, np.ndarray):
            answer = answer.tolist()
        found = repr(answer)
        if isinstance(answer, Mapping):
            if set(answer) == set(corners):
                answer = [answer[name] for name in corners]
                found = repr(answer)
            else:
                found, answer = f"corners {', '.join(map(str, answer))}", []
        commands = list(answer) if isinstance(answer, Sequence) and not isinstance(answer, str) else [answer]
        if len(commands) == len(corners):
            with contextlib.suppress(TypeError, ValueError):
                return [float(command) for command in commands]
        several = f"{len(corners)} numbers: a dict or a sequence for {', '.join(corners)}"
        raise SimulationError(
            "the controller's answer is not a command",
            where=f"control function at t = {t:.6g} s",
            found=found,
            allowed=several if len(corners) > 1 else "one number",
        )


class CommandLimits:
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
        """Commands clipped and limited in rate; NaN for those that are not finite, of which no limit makes one."""
        found = []
        for command, before, step, (low, high) in zip(commands, self.last, self._steps, self._limits, strict=True):
            if not math.isfinite(command):
                found.append(math.nan)
                continue
            clipped = min(max(command, low), high)
            change = clipped - before
            found.append(before + step if change > step else before - step if change < -step else clipped)
        self.last = found
        return found
