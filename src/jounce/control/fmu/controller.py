"""FMUs in the control loop: connected by names, with unit conversion, in a child process unless trusted."""

from __future__ import annotations

import ctypes
import json
import math
import re
import struct
import sys
import weakref
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar, Literal, Protocol, Self

import numpy as np
from pydantic import BaseModel, model_validator

from jounce.control.actuators import OWN, RATE, ActiveActuator
from jounce.control.controller import CallbackController, CommandLimits, Regulator, RunSetting
from jounce.control.fmu import caller
from jounce.control.fmu.component import REALS, WHOLE, FmuComponent, FmuVariable, read_fmu, unpack
from jounce.core.child_processes import ChildProcess
from jounce.core.errors import DescriptionError, ResourceError, SimulationError, unknown
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.text import qualify, shorten
from jounce.core.trust import trust_said
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.core.writing import working_folder

_PATIENCE = 60.0  # s: time limit of one instant
_NAMED = 5  # maximum number of names in a list
_TURN = 0.05  # rad: default phase of the rig's fastest mode per period
_USUAL, _MOST = 1000.0, 10  # default rate in Hz, and maximum multiple of it
_PROBES = {
    "m": 1e-3,
    "rad": 1e-3,
}  # perturbations of a measurement to probe the direct feedthrough; default:
_PROBE = 1e-2
_SHALLOW = 0.01  # maximum perturbation relative to the tyre deflection at rest
_MUCH = 0.02  # tolerated work of holding a force, relative to the force's work
_ROUND = 1e-6  # relative rounding tolerance of a step


class FmuControl(CallbackController):
    """Co-simulation FMU of any tool as a controller, a damper or an actuator, stepped at every control instant.

    At each instant the FMU receives the measurements and advances by one control period; its outputs are the commands
    of this instant. Direct feedthrough therefore has no delay, and internal states are one period ahead. With an active
    actuator without lag, the output is a strut force (compression positive), held for a period. In this case ``rate``
    defaults to a value at which the phase of the rig's fastest mode at rest changes by at most 0.05 rad per period (1
    to 10 kHz). Such an actuator may replace a spring, stops or a tyre (``in_place_of``): the run starts in equilibrium
    with the FMU's force, and between instants the force changes like that of the rig's own element.

    Attributes
    ----------
    file : str
        The ``.fmu`` file; in a control file, relative to its folder.
    inputs : dict
        Channel (without the corner) for each input of the FMU: ``{"v_body": "sprung.vz"}``. Array elements are ``u[1]``
        or ``u[1,2]``, counted from 1. Inputs with the name of a channel are connected automatically; all others keep
        their start values.
    output : str or None
        Output that is the command of a corner, in the actuator's unit; default: ``command``, or the only output. Each
        corner has its own instance.
    outputs : dict or None
        Outputs by corner, instead of ``output``, for one instance that controls the whole vehicle. Channels then
        include the corner.
    parameters : dict
        Start values of parameters and unconnected inputs by name: numbers in SI or text with a unit, strings for string
        variables, lists for arrays; a table of axles or corners if their values differ
        (``{"gain": {"front": "4 kN*s/m", "rear": "3 kN*s/m"}}``).
    counts : dict
        Size of one count of integer inputs and outputs, by name (``{"adc": "0.1 mm"}``); inputs are rounded to the
        nearest count. By default a count is 1 in SI, and measurements that are not whole numbers are refused.
    from_rest : bool
        Whether channels are changes from static equilibrium instead of values.
    hold : {"zero", "first"}
        Command within a period: its value at the instant (``zero``), or the mean of the linear extrapolation from the
        previous value (``first``), which removes the half-period delay of a held force.
    trusted : bool
        Run in this process: an instant takes microseconds, but a crash of the FMU also ends Python. Otherwise the FMU
        runs in a child process, as always in commands without ``--trust``. Neither protects against malicious code: run
        only FMUs that you would start as a program.

    Examples
    --------
    >>> law = FmuControl(file="skyhook.fmu", inputs={"v_body": "sprung.vz"}, output="c", rate="500 Hz")
    >>> law.inputs["v_body"]
    'sprung.vz'
    """

    law: Literal["fmu"] = "fmu"
    file: str
    inputs: dict[str, str] = {}
    output: str | None = None
    outputs: dict[str, str] | None = None
    parameters: dict[str, Any] = {}
    counts: dict[str, Any] = {}
    from_rest: bool = False
    hold: Literal["zero", "first"] = "zero"
    trusted: bool = False
    from_file: ClassVar[str] = "fmu"
    is_element: ClassVar[bool] = True

    @model_validator(mode="after")
    def _check_outputs(self) -> Self:
        if self.output is not None and self.outputs is not None:
            raise ValueError(
                "both output and outputs are given; output is for each corner, outputs for the vehicle"
            )
        return self

    def resolve_paths(self, folder: Path) -> Self:
        """Return a copy with its file resolved against a folder."""
        return self.model_copy(update={"file": str(folder / self.file)})

    @property
    def place(self) -> str:
        """File of the FMU."""
        return self.file

    @property
    def is_force(self) -> bool:
        """Whether its output is a strut force without lag."""
        return isinstance(self.actuator, ActiveActuator) and self.actuator.order == 0

    def with_rate_for(self, fastest: float) -> Self:
        """Return a copy with a rate suited to the rig's fastest mode (rad/s), for forces without a given rate."""
        if "rate" in self.model_fields_set or not self.is_force:
            return self
        rate = _USUAL * min(max(math.ceil(fastest / _TURN / _USUAL), 1), _MOST)
        fixed = read_fmu(self.file).fixed_step
        if fixed:
            rate = 1.0 / (fixed * max(math.floor(1.0 / (rate * fixed) + _ROUND), 1))
        return BaseModel.model_copy(
            self, update={"rate": rate}
        )  # the actuator may already be resolved

    def regulator(self, setting: RunSetting) -> Regulator:
        """Return the object that the loop calls."""
        return _FmuRegulator(self, setting)


@dataclass(frozen=True)
class _Wires:
    """Connections of one instance: channels, and conversions from and to SI.

    ``starts`` are (type, reference, values) of variables set before a run; ``inputs`` and ``outputs`` are (type,
    reference, element, initial values of all elements). ``wholes`` are the integer inputs by index.
    """

    starts: list[tuple[str, int, list[Any]]]
    inputs: list[tuple[str, int, int, list[Any]]]
    channels: list[str]
    to_own: list[tuple[float, float]]
    outputs: list[tuple[str, int, int, list[Any]]]
    to_si: list[tuple[float, float]]
    wholes: dict[int, _Whole]


@dataclass(frozen=True)
class _VariablePlace:
    """Variable or array element with the user's name for it; ``at`` is None for a whole array."""

    name: str
    variable: FmuVariable
    at: int | None


@dataclass(frozen=True)
class _Whole:
    """Integer input: SI size of a count, and limits; values are rounded if the user gives the size of a count."""

    name: str
    channel: str
    count: float
    least: int
    most: int
    is_rounded: bool

    def apply(self, value: float, where: str) -> float:
        """Convert a measurement in counts to a whole number; refuse fractions and counts beyond the limits."""
        if self.is_rounded and math.isfinite(value):
            value = float(round(value))
        if value % 1.0 == 0.0 and self.least <= value <= self.most:
            return value
        is_between = not self.is_rounded and value % 1.0 != 0.0
        hint = Phrase(
            "Set the size of a count, counts = {{ {name!r} = ... }}, or connect a different channel.",
            name=self.name,
        )
        raise SimulationError(
            Phrase(
                "the input {name} requires whole numbers, but {channel} does not supply them",
                name=self.name,
                channel=self.channel,
            )
            if is_between
            else Phrase(
                "{channel} exceeds the range of the input {name}",
                channel=self.channel,
                name=self.name,
            ),
            where=where,
            found=f"{value:.9g}",
            allowed="0 and 1"
            if self.most == 1
            else Phrase("whole numbers from {least} to {most}", least=self.least, most=self.most),
            hint=hint
            if is_between and self.most > 1
            else "Connect a different channel, or change its count.",
        )


@dataclass
class _Connection:
    """Connects an FMU to the corners of a car."""

    law: FmuControl
    component: FmuComponent
    setting: RunSetting
    findings: list[Finding] = field(default_factory=list)

    def wires(self) -> list[_Wires]:
        """Return the connections of each instance."""
        corners = tuple(self.setting.controllers)
        central = self._central(corners)
        if central is not None:
            wires = [self._wire("", [self._output(central[corner], corner) for corner in corners])]
        else:
            place = self._own_output()
            wires = [self._wire(corner, [(place, corner)]) for corner in corners]
        if len(wires) > 1 and self.component.is_once:
            raise DescriptionError(
                "the FMU can be instantiated only once in a process, and every corner has its own instance",
                where=str(self.component.path),
                found=f"{len(wires)} corners",
                hint="Use an FMU with an output for every corner (outputs).",
            )
        return wires

    def _central(self, corners: tuple[str, ...]) -> Mapping[str, str] | None:
        """Return outputs by corner of an FMU for the whole vehicle, or None."""
        if self.law.outputs is not None:
            for corner in (*self.law.outputs, *corners):
                if corner not in corners or corner not in self.law.outputs:
                    raise DescriptionError(
                        "outputs are given by corner",
                        where="control: outputs",
                        found=", ".join(self.law.outputs) or "none",
                        allowed=", ".join(corners),
                    )
            return self.law.outputs
        names = {corner: f"{corner}.command" for corner in corners}
        known = {variable.name for variable in self.component.outputs}
        return (
            names
            if self.law.output is None and corners != ("",) and known >= set(names.values())
            else None
        )

    def _own_output(self) -> _VariablePlace:
        outputs = self.component.outputs
        if self.law.output is None:
            for name in ("command", *(v.name for v in outputs if len(outputs) == 1)):
                if any(v.name == name for v in outputs):
                    return self._output(name, "")[0]
            raise DescriptionError(
                "the FMU has no output or several; name the one that is the command",
                where="control: output",
                allowed=", ".join(v.name for v in outputs) or "an FMU with outputs",
            )
        return self._output(self.law.output, "")[0]

    def _output(self, name: str, corner: str) -> tuple[_VariablePlace, str]:
        return self._find_variable(name, self.component.outputs, "output"), corner

    def _find_variable(
        self, name: str, variables: tuple[FmuVariable, ...], what: str
    ) -> _VariablePlace:
        where = f"{self.component.path}"
        by_name = {v.name: v for v in variables}
        element = _ELEMENT.fullmatch(name)
        if name in by_name:
            variable, at = by_name[name], None if by_name[name].dimensions else 0
        elif element and element[1] in by_name and by_name[element[1]].dimensions:
            variable = by_name[element[1]]
            at = _element(
                variable, [int(index) for index in element[2].split(",")], f"{where}: {name}"
            )
        elif any(
            v.name in (name, element and element[1]) for v in self.component.structural_parameters
        ):
            raise DescriptionError(
                "a structural parameter defines array sizes and cannot be changed",
                where=f"{where}: {name}",
                allowed="parameters and inputs",
                hint="Set it in the tool that exports the FMU.",
            )
        else:
            raise unknown(name, [_elements(v) for v in variables], what=what, where=where)
        if variable.size > _LARGEST:
            raise DescriptionError(
                "the array is too large",
                where=f"{where}: {name}",
                found=variable.shape,
                allowed=Phrase("{largest} elements", largest=_LARGEST),
            )
        if what != "parameter" and (at is None or not variable.is_number):
            raise DescriptionError(
                Phrase("an {what} that is no number", what=what),
                where=f"{where}: {name}",
                found=variable.shape,
                allowed=Phrase("an element: {elements}", elements=_elements(variable))
                if variable.is_number
                else ", ".join((*REALS, *WHOLE)),
            )
        return _VariablePlace(name, variable, at)

    def _wire(self, corner: str, outputs: list[tuple[_VariablePlace, str]]) -> _Wires:
        component, channels = self.component, self.setting.units
        given = {name: self._channel(channel, corner) for name, channel in self.law.inputs.items()}
        places = [self._find_variable(name, component.inputs, "input") for name in given]
        for variable in component.inputs:
            channel = qualify(corner, variable.name)
            if (
                variable.name not in given
                and channel in channels
                and variable.is_number
                and not variable.dimensions
            ):
                given[variable.name] = channel
                places.append(_VariablePlace(variable.name, variable, 0))
        starts = self._starts(corner)
        self._report_unconnected(places)
        inputs: list[tuple[_VariablePlace, str]] = []
        to_own: list[tuple[float, float]] = []
        wholes: dict[int, _Whole] = {}
        for place in sorted(places, key=lambda place: component.inputs.index(place.variable)):
            channel = given[place.name]
            a, b = self._conversion(place, channels[channel])
            if place.variable.is_whole:
                least, most = _range(place.variable, component.version)
                wholes[len(inputs)] = _Whole(
                    place.name, channel, 1.0 / a, least, most, place.name in self.law.counts
                )
            inputs.append((place, channel))
            to_own.append((a, b))
        commands = []
        for place, at in outputs:
            unit = self.setting.controllers[
                at or next(iter(self.setting.controllers))
            ].actuator.unit
            a, b = self._conversion(place, unit)
            commands.append((1.0 / a, -b / a))
        self._check_counts([*(place for place, _ in inputs), *(place for place, _ in outputs)])
        return _Wires(
            [
                (self._kind(variable), variable.reference, values)
                for variable, values in starts.values()
            ],
            [self._port(place, starts) for place, _ in inputs],
            [channel for _, channel in inputs],
            to_own,
            [self._port(place, {}) for place, _ in outputs],
            commands,
            wholes,
        )

    def _port(
        self, place: _VariablePlace, starts: Mapping[str, tuple[FmuVariable, list[Any]]]
    ) -> tuple[str, int, int, list[Any]]:
        """Return the caller's specification of a connection, with all elements of an array: they are set together."""
        variable = place.variable
        values = [0] * variable.size
        if variable.name in starts:
            values = starts[variable.name][1]
        elif variable.dimensions and variable.causality == "input":
            values = self._start_elements(variable)
        return self._kind(variable), variable.reference, place.at or 0, values

    def _report_unconnected(self, places: list[_VariablePlace]) -> None:
        """Report inputs and array elements that are neither connected nor set."""
        taken = {(place.variable.name, place.at or 0) for place in places}
        for name in self.law.parameters:
            place = self._find_variable(
                name, (*self.component.parameters, *self.component.inputs), "parameter"
            )
            every = range(place.variable.size) if place.at is None else [place.at]
            taken |= {(place.variable.name, at) for at in every}
        left = []
        for v in self.component.inputs:
            open_ = [at for at in range(min(v.size, _LARGEST)) if (v.name, at) not in taken]
            if v.dimensions and 0 < len(open_) < v.size:
                some = ", ".join(_index(v, at) for at in open_[:_NAMED])
                left.append(
                    some + (f" and {len(open_) - _NAMED} more" if len(open_) > _NAMED else "")
                )
            elif open_:
                left.append(f"{v.name} = {shorten(v.start, _LONGEST) or '0'}")
        if left:
            note = finding("control.inputs_left", str(self.component.path), inputs=", ".join(left))
            self.findings += [note] if note not in self.findings else []

    def _check_counts(self, places: list[_VariablePlace]) -> None:
        """Refuse counts of variables that are not connected or not integers."""
        wholes = [
            place.name
            for place in places
            if place.variable.is_whole and place.variable.kind != "Boolean"
        ]
        for name in self.law.counts:
            if name not in wholes:
                raise DescriptionError(
                    "counts apply only to connected integer inputs and outputs",
                    where=f"control: counts: {name}",
                    allowed=", ".join(wholes) or "none in this FMU",
                )

    def _kind(self, variable: FmuVariable) -> str:
        """Return the type as in the names of the FMI functions that set and get it."""
        if variable.kind != "Enumeration":
            return variable.kind
        return "Int64" if self.component.version == 3 else "Integer"

    def _conversion(self, place: _VariablePlace, si: str) -> tuple[float, float]:
        variable = place.variable
        if place.name in self.law.counts:
            where = f"control: counts: {place.name}"
            count = to_si(self.law.counts[place.name], si, where=where)
            if not (math.isfinite(count) and count > 0.0 and math.isfinite(1.0 / count)):
                raise DescriptionError(
                    "invalid size of a count",
                    where=where,
                    found=count,
                    allowed=Phrase("more than 0 {si}", si=si),
                )
            return 1.0 / count, 0.0
        if not variable.unit and si not in ("", "1"):
            note = finding("control.no_unit", f"{self.component.path}: {variable.name}", unit=si)
            self.findings += [note] if note not in self.findings else []
        return self.component.conversion(variable, si)

    def _channel(self, name: str, corner: str) -> str:
        channels = self.setting.units
        for channel in (qualify(corner, name), name):
            if channel in channels:
                return channel
        start = f"{corner}."
        short = [
            channel.removeprefix(start)
            for channel in channels
            if not corner or channel.startswith(start)
        ]
        raise unknown(name, short, what="channel", where="control: inputs")

    def _starts(self, corner: str) -> dict[str, tuple[FmuVariable, list[Any]]]:
        """Return the variables set before a run by name, with all their values."""
        starts: dict[str, tuple[FmuVariable, list[Any]]] = {}
        for name, given in self.law.parameters.items():
            place = self._find_variable(
                name, (*self.component.parameters, *self.component.inputs), "parameter"
            )
            variable, where = place.variable, f"control: parameters: {name}"
            value = self._own_value(given, corner, where) if isinstance(given, Mapping) else given
            if self._kind(variable) not in caller._TYPES:
                raise DescriptionError(
                    "it cannot be set",
                    where=where,
                    found=variable.shape,
                    allowed="numbers, booleans, texts",
                )
            if place.at is None:
                values = _flatten(value, variable.dimensions)
                if values is None:
                    text = Phrase(
                        "{shape} values in a list, or {elements}",
                        shape=" x ".join(map(str, variable.dimensions)),
                        elements=_elements(variable),
                    )
                    raise DescriptionError(
                        "not a list of array values", where=where, found=value, allowed=text
                    )
                starts[variable.name] = (
                    variable,
                    [self._value(variable, element, where) for element in values],
                )
                continue
            if variable.name not in starts:
                starts[variable.name] = (
                    variable,
                    self._start_elements(variable) if variable.dimensions else [0],
                )
            starts[variable.name][1][place.at] = self._value(variable, value, where)
        return starts

    def _value(self, variable: FmuVariable, value: object, where: str) -> Any:
        """Convert a value to the variable's type; raise a DescriptionError if the type cannot represent it."""
        kind = self._kind(variable)
        if kind == "String":
            if not isinstance(value, str) or not _is_text(value):
                raise DescriptionError(
                    "the value has the wrong type", where=where, found=value, allowed="a text"
                )
            return value
        if kind in REALS:
            si = self.component.si_unit(variable)
            a, b = self.component.conversion(variable, si)
            return a * to_si(value, si, where=where) + b
        if (
            not isinstance(value, (bool, int, float))
            or value % 1
            or (kind == "Boolean" and value not in (0, 1))
        ):
            allowed = (
                "true, false, 0, 1"
                if kind == "Boolean"
                else Phrase("a whole number ({kind})", kind=variable.kind)
            )
            raise DescriptionError(
                "the value has the wrong type", where=where, found=value, allowed=allowed
            )
        least, most = _range(variable, self.component.version)
        if not least <= value <= most:
            allowed = Phrase("{kind}, {least} to {most}", kind=kind, least=least, most=most)
            raise DescriptionError(
                "out of the range of its type", where=where, found=value, allowed=allowed
            )
        return int(value)

    def _start_elements(self, variable: FmuVariable) -> list[Any]:
        """Return the start values of all elements of an array."""
        words = {"true": 1, "false": 0}
        texts = variable.start.split() if variable.is_number else []
        try:
            number = float if variable.kind in REALS else int
            elements = [words.get(text) if text in words else number(text) for text in texts]
        except ValueError:
            elements = []
        if len(elements) == 1:
            elements *= variable.size
        if len(elements) != variable.size:
            raise DescriptionError(
                "elements of an array without start values cannot be set individually",
                where=f"{self.component.path}: {variable.name}",
                found=variable.start,
                allowed=Phrase(
                    "{size} values of type {kind}", size=variable.size, kind=variable.kind
                ),
                hint=Phrase(
                    "Give all of them: parameters = {{ {name!r} = [...] }}.", name=variable.name
                ),
            )
        return elements

    def _own_value(self, given: Mapping[str, Any], corner: str, where: str) -> Any:
        """Return the value for a corner from a table by corner or axle."""
        corners = tuple(self.setting.controllers)
        known = {*corners, *(name.partition("_")[0] for name in corners)} - {""}
        if (
            not corner
            or set(given) - known
            or not any(name in given for name in (corner, corner.partition("_")[0]))
        ):
            raise DescriptionError(
                "the values by corner do not match the corners that have their own instance",
                where=where,
                found=", ".join(map(str, given)),
                allowed=", ".join(sorted(known)) if corner else "one value",
            )
        return given.get(corner, given.get(corner.partition("_")[0]))


_ELEMENT = re.compile(r"(.+)\[([0-9]{1,9}(?: *, *[0-9]{1,9})*)\]", re.DOTALL)
_LARGEST = 1_000_000  # maximum number of elements
_LONGEST = 60  # maximum number of characters of a start value


def _elements(variable: FmuVariable) -> str:
    """Return the names of a variable's elements as a range."""
    if not variable.dimensions:
        return variable.name
    first = ",".join("1" for _ in variable.dimensions)
    return f"{variable.name}[{first}] to [{','.join(map(str, variable.dimensions))}]"


def _index(variable: FmuVariable, at: int) -> str:
    """Return the name of an element."""
    return f"{variable.name}[{','.join(str(int(i) + 1) for i in np.unravel_index(at, variable.dimensions))}]"


def _element(variable: FmuVariable, indices: list[int], where: str) -> int:
    """Return the flat index of an array element in row-major order."""
    sizes = variable.dimensions
    if len(indices) != len(sizes) or any(
        not 1 <= i <= n for i, n in zip(indices, sizes, strict=True)
    ):
        raise DescriptionError(
            "no such element", where=where, found=variable.shape, allowed=_elements(variable)
        )
    at = 0
    for i, n in zip(indices, sizes, strict=True):
        at = at * n + i - 1
    return at


def _flatten(value: object, dimensions: tuple[int, ...]) -> list[Any] | None:
    """Flatten nested lists to the values of an array, or return None if the dimensions do not match."""
    if not dimensions:
        return [value]
    if not isinstance(value, (list, tuple)) or len(value) != dimensions[0]:
        return None
    elements: list[Any] = []
    for row in value:
        part = _flatten(row, dimensions[1:])
        if part is None:
            return None
        elements += part
    return elements


def _c_type(variable: FmuVariable, version: int) -> Any:
    """Return the C type of a variable's values."""
    kind = "Int64" if variable.kind == "Enumeration" else variable.kind
    return caller._c_type("Integer" if version == 2 and kind == "Int64" else kind, version)


def _range(variable: FmuVariable, version: int) -> tuple[int, int]:
    """Return minimum and maximum of an integer type."""
    if variable.kind == "Boolean":
        return 0, 1
    held = _c_type(variable, version)
    bits = 8 * ctypes.sizeof(held)
    return (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1) if held(-1).value < 0 else (0, 2**bits - 1)


def _is_text(value: str) -> bool:
    """Whether a text is valid as a C string: UTF-8 without null bytes."""
    try:
        return b"\0" not in value.encode()
    except UnicodeEncodeError:
        return False


class _FmuRegulator:
    """Regulator of an FMU: runs its instances at every control instant."""

    def __init__(self, law: FmuControl, setting: RunSetting) -> None:
        component = read_fmu(law.file)
        place = component.binary()
        connection = _Connection(law, component, setting)
        wires = connection.wires()
        self._file, self._rate = str(component.path), law.rate
        _check_period(component, 1.0 / law.rate)
        folder = unpack(component)
        resources = folder / "resources"
        start = {
            "library": str(folder.joinpath(*place.split("/"))),
            "version": component.version,
            "token": component.token,
            "resources": resources.as_uri() if component.version == 2 else f"{resources}/",
            "period": 1.0 / law.rate,
        }
        self._tool = (component.tool or "the tool that made it") if component.needs_tool else ""
        specs = [
            {**start, "starts": wire.starts, "inputs": wire.inputs, "outputs": wire.outputs}
            for wire in wires
        ]
        self._notes = connection.findings
        begins = [sum(len(wire.inputs) for wire in wires[:i]) for i in range(len(wires))]
        self._wholes = {
            begin + at: whole
            for begin, wire in zip(begins, wires, strict=True)
            for at, whole in wire.wholes.items()
        }
        self.from_rest = law.from_rest
        measured = [channel for wire in wires for channel in wire.channels]
        instead = getattr(law.actuator, "in_place_of", None)
        own, speeds = _channels(setting, f"actuator.{OWN}"), _channels(setting, _SPEED)
        if instead is not None:
            speeds = _channels(setting, f"actuator.{RATE}")
        else:
            own = []
        is_seen = law.is_force and all(speed in setting.units for speed in speeds)
        what = f"force beyond that of the rig's own {instead}" if instead else "force"
        self._work = _HeldWork(1.0 / law.rate, len(speeds), what) if is_seen else None
        self._count, self._own, self._place = len(measured), len(own), instead or ""
        self._probes = [_PROBES.get(setting.units[channel], _PROBE) for channel in measured]
        self.channels = (*measured, *own, *(speeds if is_seen else ()))
        self._pushed, self._cut = False, 0
        self._extrapolates = law.hold == "first"
        self._before: list[float] = []
        self._to_own = _conversions([pair for wire in wires for pair in wire.to_own])
        self._to_si = _conversions([pair for wire in wires for pair in wire.to_si])
        self._limits = CommandLimits(setting.controllers)
        trusted_here = trust_said()
        self._specs, self._is_trusted = specs, law.trusted if trusted_here is None else trusted_here
        if law.trusted and trusted_here is False:
            self._notes.append(finding("control.not_trusted", self._file))
        self._instances: _Instances | None = None
        self._instant = 0

    @property
    def findings(self) -> list[Finding]:
        """Findings on inputs without connection or unit, on clipped forces, and on files written by the FMU."""
        written = (
            self._instances.written_files() if isinstance(self._instances, _FmuProcess) else []
        )
        findings = [*self._notes, *(self._work.findings(self._file) if self._work else ())]
        if self._cut:
            findings.append(finding("control.force_cut", self._file, instants=self._cut))
        if self._pushed:
            findings.append(finding("control.force_off_road", self._file))
        if not written:
            return findings
        return [*findings, finding("control.files_written", self._file, files=", ".join(written))]

    def start(self) -> None:
        """Start a run."""
        self._limits.start()
        self._before = []
        if self._work is not None:
            self._work.start()
        self._instant, self._cut, self._pushed = 0, 0, False
        try:
            if self._instances is None:
                self._instances = self._make_instances()
                weakref.finalize(self, self._instances.close)
            self._instances.start()
        except caller.FmuFailedError as error:
            raise self._failure(error) from None

    def _make_instances(self) -> _Instances:
        return (
            caller.Instances(self._specs)
            if self._is_trusted
            else _FmuProcess(self._specs, whole=bool(self._tool))
        )

    def __call__(self, values: list[float]) -> list[float]:
        """Return commands from measurements."""
        rest = values[self._count : -1]
        del values[self._count :]  # including the time
        demands = forces = self._step(values)
        self._instant += 1
        if self._own:
            demands = [
                self._excess(*of_one)
                for of_one in zip(forces, rest, rest[self._own :], strict=False)
            ]
        held = demands
        if self._extrapolates:
            held = [
                1.5 * now - 0.5 * before
                for now, before in zip(demands, self._before or demands, strict=True)
            ]
            self._before = demands
        commands = self._limits.apply(held)
        if self._work is not None:
            self._cut += commands != held
            self._work.add(forces, demands, commands, rest[self._own :])
        return commands

    def _excess(self, force: float, own: float, rate: float) -> float:
        """Return a force minus that of the rig's own element (N); ``rate`` is the element's compression rate (m/s)."""
        if (
            self._place == "tyre" and own == 0.0
        ):  # off the ground: the force of the rig's tyre starts at contact
            self._pushed = self._pushed or (rate <= 0.0 and force > _TOUCH)
            return 0.0
        return force - own

    def _step(self, values: list[float]) -> list[float]:
        """Step the instances; return commands (SI) from measurements."""
        assert self._instances is not None
        if self._to_own is not None:
            values = [a * value + b for value, (a, b) in zip(values, self._to_own, strict=True)]
        if self._wholes:
            for at, whole in self._wholes.items():
                values[at] = whole.apply(values[at], self._now())
        try:
            commands = self._instances.step(values)
        except caller.FmuFailedError as error:
            raise self._failure(error) from None
        if self._to_si is not None:
            commands = [a * value + b for value, (a, b) in zip(commands, self._to_si, strict=True)]
        return commands

    def answer(self, rest: Array) -> tuple[Array, Array]:
        """Return derivatives of (commands, memory) at rest by memory and measurements, for feedthrough only."""
        columns = []
        for i, usual in enumerate(self._probes):
            ends = []
            stays = self._place == "tyre" and rest[i]  # on the road
            probe = min(usual, _SHALLOW * abs(float(rest[i]))) if stays else usual
            if whole := self._wholes.get(i):
                if not whole.is_rounded:  # it does not respond to small changes
                    columns.append(np.zeros(len(self._limits.last)))
                    continue
                probe = whole.count * math.ceil(probe / whole.count)
            for sign in (1.0, -1.0):
                self.start()
                values = rest[: self._count].tolist()
                values[i] += sign * probe
                ends.append(self._step(values))
            columns.append((np.array(ends[0]) - np.array(ends[1])) / (2.0 * probe))
        count, silent = len(self._limits.last), len(self.channels) - self._count - self._own
        slopes = np.column_stack(
            [*columns, *-np.eye(count)[: self._own], *[np.zeros(count)] * silent]
        )
        if not self._extrapolates:
            return np.zeros((count, 0)), slopes
        return np.vstack([-0.5 * np.eye(count), np.zeros((count, count))]), np.vstack(
            [1.5 * slopes, slopes]
        )

    def _failure(self, error: Exception) -> SimulationError:
        hint = (
            Phrase("It needs {tool} on this machine.", tool=self._tool)
            if self._tool and not self._instant
            else ""
        )
        return SimulationError(str(error), where=self._now(), hint=hint)

    def _now(self) -> str:
        return f"{self._file} at t = {self._instant / self._rate:.6g} s"


_SPEED = "strut.velocity"
_TOUCH = 1e-6  # N: rounding tolerance of the force of a tyre off the ground


def _channels(setting: RunSetting, name: str) -> list[str]:
    """Return the names of a channel at all corners."""
    return [qualify(corner, name) for corner in setting.controllers]


class _HeldWork:
    """Compares the work (J) of held (or partly held) forces with the work of the forces themselves."""

    def __init__(self, period: float, count: int, what: str = "force") -> None:
        self._period, self._zeros, self._what = period, [0.0] * count, what
        self.start()

    def start(self) -> None:
        """Start a run."""
        self._through = self._made = 0.0
        self._last = (self._zeros,) * 4

    def add(
        self, forces: list[float], demands: list[float], held: list[float], speeds: list[float]
    ) -> None:
        """Add a period that ends with ``forces`` (N) of the FMU and ``speeds`` (m/s).

        ``demands`` is the held part of the forces, ``held`` its value in the next period.
        """
        half = 0.5 * self._period
        for whole, force, speed, w, f, h, v in zip(
            forces, demands, speeds, *self._last, strict=True
        ):
            self._made += half * (h * (v + speed) - _along_lines(f, v, force, speed))
            self._through += half * abs(_along_lines(w, v, whole, speed))
        self._last = (forces, demands, held, speeds)

    def findings(self, where: str) -> list[Finding]:
        """Return findings on the work added or removed by holding."""
        if not self._through:
            return []
        share = abs(self._made) / self._through
        change = "taken" if self._made > 0.0 else "given"
        numbers: dict[str, Any] = {
            "what": self._what,
            "period": self._period,
            "change": change,
            "share": share,
        }
        numbers |= {"work": self._through, "held": abs(self._made)}
        return [
            finding("control.held" if share <= _MUCH else "control.held_too_long", where, **numbers)
        ]


def _along_lines(f: float, v: float, force: float, speed: float) -> float:
    """Return twice the mean power (W) of a linearly varying force (N) and speed (m/s)."""
    return (2.0 * (f * v + force * speed) + f * speed + force * v) / 3.0


def _conversions(pairs: list[tuple[float, float]]) -> list[tuple[float, float]] | None:
    """Return the conversions, or None if all are identities."""
    return None if all(pair == (1.0, 0.0) for pair in pairs) else pairs


def _check_period(component: FmuComponent, period: float) -> None:
    fixed = component.fixed_step
    if fixed and abs(period / fixed - round(period / fixed)) > _ROUND * period / fixed:
        raise DescriptionError(
            "the control period is not a multiple of the FMU's fixed step",
            where=f"{component.path}",
            found=f"{period:g} s",
            allowed=Phrase("multiples of {fixed:g} s", fixed=fixed),
            hint="Change the control rate.",
        )


class _Instances(Protocol):
    """Instances of an FMU, in this process or in a child process."""

    def start(self) -> None:
        """Start a run."""

    def step(self, values: list[float]) -> list[float]:
        """Return outputs from inputs."""

    def close(self) -> None:
        """Free all instances."""


class _FmuProcess:
    """Instances in a child process with a temporary working folder.

    With ``whole``, the child's Python can import site packages, as FMUs written in Python require.
    """

    def __init__(self, specs: list[dict[str, Any]], *, whole: bool = False) -> None:
        self._inputs, self._outputs = (
            struct.Struct(f"={sum(len(spec[word]) for spec in specs)}d")
            for word in ("inputs", "outputs")
        )
        self._place = working_folder()
        self._folder = self._place.__enter__()
        command = [sys.executable, "-I", *([] if whole else ["-S"]), caller.__file__]
        try:
            self._process = ChildProcess(
                command, "a process to run an FMU in", folder=self._folder, is_own_session=True
            )
        except ResourceError:
            self._place.__exit__(None, None, None)
            raise
        self._send(json.dumps(specs).encode() + b"\n")

    def start(self) -> None:
        """Start a run."""
        self._ask(b"s")

    def step(self, values: list[float]) -> list[float]:
        """Return outputs from inputs."""
        return self._ask(b"x" + self._inputs.pack(*values))

    def written_files(self) -> list[str]:
        """Return names of files that the FMU wrote to its working folder, up to a maximum."""
        return (
            sorted(file.name for file in self._folder.iterdir())[:_NAMED]
            if self._folder.is_dir()
            else []
        )

    def _ask(self, question: bytes) -> list[float]:
        self._send(question)
        head = self._read(1, _PATIENCE)
        if head == b"-":
            raise caller.FmuFailedError(
                self._read(int.from_bytes(self._read(8), "little")).decode(errors="replace")
            )
        outputs = self._outputs.unpack(self._read(self._outputs.size))
        return list(outputs)

    def _send(self, content: bytes) -> None:
        try:
            self._process.send(content)
        except OSError:
            raise self._crash() from None

    def _read(self, count: int, patience: float | None = None) -> bytes:
        try:
            return self._process.read(count, patience)
        except TimeoutError:
            self._process.kill()
            raise caller.FmuFailedError(
                Phrase(
                    "no response for {patience:g} s: the process was terminated", patience=patience
                )
            ) from None
        except EOFError:
            raise self._crash() from None

    def _crash(self) -> caller.FmuFailedError:
        code = self._process.process.wait()
        how = f"signal {-code}" if code < 0 else f"exit code {code}"
        return caller.FmuFailedError(
            Phrase("the FMU crashed ({how}) in its child process", how=how)
        )

    def close(self) -> None:
        """End the process, and remove its folder."""
        self._process.end(patience=5.0)
        self._place.__exit__(None, None, None)
