"""Calls of C functions of co-simulation FMUs, in this process or in a child process.

The child executes this file without importing jounce, so it starts quickly. A crash of the FMU ends only the child.
"""

from __future__ import annotations

import contextlib
import ctypes
import json
import os
import re
import struct
import sys
from collections import deque
from typing import Any

_WORST = 1  # highest accepted status, a warning; above: discard, error, fatal
_FATAL = 4  # status of FMI, after which an instance may not be called
_STATUS = ("OK", "warning", "discard", "error", "fatal error", "pending")
_MESSAGES = 5  # number of last messages quoted in an error
_MUCH = 1000  # number of messages without an error after which logging is switched off
_POINTER, _SIZE, _DOUBLE, _TEXT = ctypes.c_void_p, ctypes.c_size_t, ctypes.c_double, ctypes.c_char_p
_MORE = 3  # number of variadic arguments read
_LOGGER_2 = ctypes.CFUNCTYPE(
    None, _POINTER, _TEXT, ctypes.c_int, _TEXT, _TEXT, *(_POINTER,) * _MORE
)
"""The C logger is variadic; its first arguments are passed like those of a fixed signature."""
_LOGGER_3 = ctypes.CFUNCTYPE(None, _POINTER, ctypes.c_int, _TEXT, _TEXT)
_TYPES: dict[str, Any] = {
    "Real": _DOUBLE, "Integer": ctypes.c_int, "Boolean2": ctypes.c_int,
    "Float64": _DOUBLE, "Float32": ctypes.c_float, "Boolean": ctypes.c_bool,
    "Int8": ctypes.c_int8, "Int16": ctypes.c_int16, "Int32": ctypes.c_int32, "Int64": ctypes.c_int64,
    "UInt8": ctypes.c_uint8, "UInt16": ctypes.c_uint16, "UInt32": ctypes.c_uint32, "UInt64": ctypes.c_uint64,
    "String": _TEXT,
}  # fmt: skip
"""C types by FMI type; a Boolean of FMI 2 is an integer."""
_DOUBLES = ("Real", "Float64")
_REALS = (*_DOUBLES, "Float32")


def _c_type(kind: str, version: int) -> Any:
    """Return the C type of values of an FMI type."""
    return _TYPES["Boolean2" if (kind, version) == ("Boolean", 2) else kind]


_time = _DOUBLE.from_param


def _place(of: Any) -> Any:
    """Convert the address of an instance or an array to a C argument."""
    return _POINTER.from_param(of if of is None or isinstance(of, int) else ctypes.addressof(of))


class FmuFailedError(Exception):
    """Failed call of an FMU; the message quotes the FMU's log."""


class _Callbacks(ctypes.Structure):
    """Callbacks passed to an instance of FMI 2.0."""

    _fields_ = (
        ("logger", _LOGGER_2),
        ("allocate", _POINTER),
        ("free", _POINTER),
        ("finished", _POINTER),
        ("environment", _POINTER),
    )


class _Group:
    """Variables of one type that are set or read together: values, and positions of a step's numbers."""

    def __init__(self, kind: str, version: int) -> None:
        self.kind = kind
        self.places: list[tuple[int, int]] = []
        self.cast: Any = float if kind in _REALS else int
        self._type = _c_type(kind, version)
        self._begins: dict[int, int] = {}
        self._first: list[float] = []

    def add(self, number: int, reference: int, at: int, values: list[float]) -> None:
        """Map a number of a step to an element of a variable; ``values`` are its initial elements."""
        if reference not in self._begins:
            self._begins[reference] = len(self._first)
            self._first += values
        self.places.append((self._begins[reference] + at, number))

    def make(self) -> None:
        """Allocate the arrays that C reads and writes."""
        self.references = (ctypes.c_uint32 * len(self._begins))(*self._begins)
        self.values = (self._type * len(self._first))(*map(self.cast, self._first))


def _groups(ports: list[tuple[str, int, int, list[float]]], version: int) -> list[_Group]:
    """Group the numbers of a step by the types of their variables."""
    groups: dict[str, _Group] = {}
    for number, (kind, reference, at, values) in enumerate(ports):
        groups.setdefault(kind, _Group(kind, version)).add(number, reference, at, values)
    for group in groups.values():
        group.make()
    return list(groups.values())


def _are_reals(groups: list[_Group], count: int) -> bool:
    """Whether a step's numbers are all doubles, in order, without other elements."""
    if len(groups) != 1 or groups[0].kind not in _DOUBLES:
        return False
    return groups[0].places == [(i, i) for i in range(count)] and len(groups[0].values) == count


class _Instance:
    """Instance of an FMU with its connections and step count.

    ``spec`` contains ``library``, ``version``, ``token``, ``resources`` and ``period`` (s); ``inputs`` and ``outputs``
    as (type, value reference, element index, initial values of all elements); and ``starts`` as (type, value reference,
    values).
    """

    def __init__(self, spec: dict[str, Any], library: ctypes.CDLL, name: str) -> None:
        self._spec, self._library, self._name = spec, library, name.encode()
        self._version: int = spec["version"]
        self._period: float = spec["period"]
        self._messages: deque[str] = deque(maxlen=_MESSAGES)
        self._in, self._out = (
            _groups(spec["inputs"], self._version),
            _groups(spec["outputs"], self._version),
        )
        self._component: int | None = None
        self._broken = False
        self._x: Any
        self._y: Any
        self._fill: Any
        self._step = self._bind_unchecked("DoStep")
        self._sets = [self._bind_unchecked(f"Set{group.kind}") for group in self._in]
        self._gets = [self._bind_unchecked(f"Get{group.kind}") for group in self._out]
        self._counts = len(spec["inputs"]), len(spec["outputs"])
        self._flag_bytes = bytearray(3)  # faster to read than the C values that share its memory
        self._flags = (ctypes.c_bool * 3).from_buffer(self._flag_bytes)
        self._last = _DOUBLE()
        self._logger: Any = _LOGGER_2(self._log_2) if self._version == 2 else _LOGGER_3(self._log_3)

    def _bind(self, name: str, *types: Any) -> Any:
        try:
            function = getattr(self._library, f"fmi{self._version}{name}")
        except AttributeError:
            raise FmuFailedError(f"the binary has no function fmi{self._version}{name}") from None
        function.argtypes, function.restype = types, ctypes.c_int
        return function

    def _bind_unchecked(self, name: str) -> Any:
        """Bind a function without argument conversion: constant arguments are converted once per run."""
        self._bind(name)
        function = self._library[f"fmi{self._version}{name}"]
        function.restype = ctypes.c_int
        return function

    def _values(self, group: _Group) -> tuple[Any, ...]:
        """Return the C arguments to get or set the values of a group."""
        many = _SIZE.from_param(len(group.references))
        # FMI 3.0 also requires the number of values: arrays have several.
        more = () if self._version == 2 else (_SIZE.from_param(len(group.values)),)
        return (
            _place(self._component),
            _place(group.references),
            many,
            _place(group.values),
            *more,
        )

    def _prepare_arguments(self) -> None:
        """Prepare the arguments of a step's functions, except the time."""
        inputs, outputs = self._counts
        if _are_reals(
            self._in, inputs
        ):  # fast path for the usual case: C reads the step's numbers directly
            self._x, self._fill = self._in[0].values, struct.Struct(f"{inputs}d").pack_into
            self._set, self._put = self._sets[0], self._values(self._in[0])
        else:
            self._x, self._fill = None, self._fill_groups
            self._set, self._put = self._set_all, tuple(map(self._values, self._in))
        if _are_reals(self._out, outputs):
            self._y = self._out[0].values
            self._get, self._take = self._gets[0], self._values(self._out[0])
        else:
            self._y = [0.0] * outputs
            self._get, self._take = self._get_all, tuple(map(self._values, self._out))
        self._which, period = _place(self._component), _DOUBLE.from_param(self._period)
        if self._version == 2:
            self._rest: tuple[Any, ...] = (period, ctypes.c_int.from_param(1))
            return
        at = ctypes.addressof(self._flags)
        addresses = (at, at + 1, at + 2, ctypes.addressof(self._last))
        self._rest = (period, ctypes.c_bool.from_param(True), *map(_POINTER.from_param, addresses))

    def _log_2(self, *arguments: Any) -> None:
        where, _name, status, category, text, *more = arguments
        self._log_3(where, status, category, _format_message(text or b"", more))

    def _log_3(self, _where: Any, status: int, _category: bytes | None, text: bytes | None) -> None:
        self._logged += status <= 0
        if status > 0 and text:
            self._messages.append(text.decode(errors="replace"))

    def _check(self, what: str, status: int) -> None:
        if status > _WORST:
            self._broken = status >= _FATAL
            said = " ".join(self._messages)
            word = _STATUS[status] if 0 <= status < len(_STATUS) else str(status)
            raise FmuFailedError(f"{what} gave {word}" + (f": {said}" if said else ""))

    def start(self) -> None:
        """Create a new instance and initialise it at time 0."""
        self.close()
        self._messages.clear()
        self._steps = self._logged = 0
        self._instantiate()
        self._prepare_arguments()
        c = self._component
        for kind, reference, values in self._spec["starts"]:
            held = (_c_type(kind, self._version) * len(values))(
                *(value.encode() if isinstance(value, str) else value for value in values)
            )
            many = () if self._version == 2 else (len(values),)
            put = self._bind(
                f"Set{kind}", _POINTER, _POINTER, _SIZE, _POINTER, *(_SIZE,) * len(many)
            )
            refs = (ctypes.c_uint32 * 1)(reference)
            self._check(
                "a start value", put(c, ctypes.addressof(refs), 1, ctypes.addressof(held), *many)
            )
        if self._version == 2:
            setup = self._bind(
                "SetupExperiment", _POINTER, ctypes.c_int, _DOUBLE, _DOUBLE, ctypes.c_int, _DOUBLE
            )
            self._check("set-up", setup(c, 0, 0.0, 0.0, 0, 0.0))
            self._check(
                "the begin of initialisation", self._bind("EnterInitializationMode", _POINTER)(c)
            )
        else:
            whether, number = ctypes.c_bool, _DOUBLE
            enter = self._bind(
                "EnterInitializationMode", _POINTER, whether, number, number, whether, number
            )
            self._check("the begin of initialisation", enter(c, False, 0.0, 0.0, False, 0.0))
        self._check("the end of initialisation", self._bind("ExitInitializationMode", _POINTER)(c))

    def _hush(self) -> None:
        """Switch off logging of the instance."""
        self._logged = 0
        truth = ctypes.c_int if self._version == 2 else ctypes.c_bool
        with contextlib.suppress(FmuFailedError):
            self._bind("SetDebugLogging", _POINTER, truth, _SIZE, _POINTER)(
                self._component, 0, 0, None
            )

    def _instantiate(self) -> None:
        spec, name, token = self._spec, self._name, self._spec["token"].encode()
        kind = "Instantiate" if self._version == 2 else "InstantiateCoSimulation"
        if self._version == 2:
            make = self._bind(
                kind, _TEXT, ctypes.c_int, _TEXT, _TEXT, _POINTER, ctypes.c_int, ctypes.c_int
            )
            make.restype = _POINTER
            c_library = ctypes.CDLL(None) if os.name == "posix" else ctypes.CDLL("msvcrt")
            allocate, free = (
                ctypes.cast(getattr(c_library, word), _POINTER) for word in ("calloc", "free")
            )
            self._callbacks = _Callbacks(self._logger, allocate, free, None, None)
            instance = make(
                name, 1, token, spec["resources"].encode(), ctypes.addressof(self._callbacks), 0, 1
            )
        else:
            types = (
                _TEXT,
                _TEXT,
                _TEXT,
                *(ctypes.c_bool,) * 4,
                _POINTER,
                _SIZE,
                _POINTER,
                _LOGGER_3,
                _POINTER,
            )
            make = self._bind(kind, *types)
            make.restype = _POINTER
            resources = spec["resources"].encode()
            instance = make(
                name, token, resources, False, True, False, False, None, 0, None, self._logger, None
            )
        if not instance:
            said = " ".join(self._messages)
            raise FmuFailedError("it gives no instance" + (f": {said}" if said else ""))
        self._component = instance

    def step(self, values: list[float]) -> list[float]:
        """Set the inputs, advance by one period, and return the outputs."""
        self._fill(self._x, 0, *values)
        if (status := self._set(*self._put)) > _WORST:
            self._check("setting the inputs", status)
        now = self._steps * self._period
        status = self._step(self._which, _time(now), *self._rest)
        if status > _WORST:
            self._check(f"the step from {now:.6g} s", status)
        if self._flag_bytes[1]:
            raise FmuFailedError(f"it asks for the end of the run at {now:.6g} s")
        self._steps += 1
        if self._logged > _MUCH:
            self._hush()
        if (status := self._get(*self._take)) > _WORST:
            self._check("reading the outputs", status)
        return self._y[:]  # type: ignore[no-any-return]

    def _fill_groups(self, _: None, _begin: int, *values: float) -> None:
        """Convert the numbers of a step to their types and store them in the C arrays."""
        for group in self._in:
            for at, number in group.places:
                group.values[at] = group.cast(values[number])

    def _set_all(self, *arguments: Any) -> int:
        """Set the inputs of each type; return the status of the first failure, or 0."""
        statuses = (put(*words) for put, words in zip(self._sets, arguments, strict=True))
        return next((status for status in statuses if status > _WORST), 0)

    def _get_all(self, *arguments: Any) -> int:
        """Read the outputs of each type; return the status of the first failure, or 0."""
        for group, take, words in zip(self._out, self._gets, arguments, strict=True):
            if (status := take(*words)) > _WORST:
                return int(status)
            for at, number in group.places:
                self._y[number] = float(group.values[at])
        return 0

    def close(self) -> None:
        """Free the instance, unless it failed fatally."""
        if self._component is not None and not self._broken:
            self._bind("Terminate", _POINTER)(self._component)
            free = self._bind("FreeInstance", _POINTER)
            free.restype = None
            free(self._component)
        self._component, self._broken = None, False


_PLACE = re.compile(rb"%(?:[-+ #0-9.]*(?:hh|h|ll|l|z)?[a-zA-Z]|%)")


def _format_message(text: bytes, values: list[int | None]) -> bytes:
    """Format a C message with only string and integer placeholders; return other messages unchanged.

    >>> _format_message(b"step %d of 100 %%", [7, None, None]), _format_message(b"at %g s", [0, 0, 0])
    (b'step 7 of 100 %', b'at %g s')
    """
    places = [place for place in _PLACE.findall(text) if place != b"%%"]
    is_elsewhere = (
        sys.platform == "darwin" and os.uname().machine == "arm64"
    )  # variadic arguments are passed on the stack there
    if (
        is_elsewhere
        or len(places) > len(values)
        or any(place[-1:] not in b"sdi" for place in places)
    ):
        return text
    left = iter(values)

    def fill_place(match: re.Match[bytes]) -> bytes:
        if match[0] == b"%%":
            return b"%"
        value = next(left) or 0
        if match[0].endswith(b"s"):
            return ctypes.string_at(value) if value else b""
        return str(ctypes.c_int32(value).value).encode()

    return _PLACE.sub(fill_place, text)


class Instances:
    """Instances of one FMU in this process, stepped together.

    Parameters
    ----------
    specs : list of dict
        Specification of each instance (see `_Instance`).
    """

    def __init__(self, specs: list[dict[str, Any]]) -> None:
        try:
            library = ctypes.CDLL(specs[0]["library"])
        except OSError as error:
            raise FmuFailedError(f"its binary cannot be loaded: {error}") from None
        self._all = [_Instance(spec, library, f"jounce_{i}") for i, spec in enumerate(specs)]
        self._only = self._all[0] if len(self._all) == 1 else None
        self._counts = [len(spec["inputs"]) for spec in specs]

    def start(self) -> None:
        """Start a run."""
        for instance in self._all:
            instance.start()

    def step(self, values: list[float]) -> list[float]:
        """Return the outputs of all instances, in order, from the inputs of all."""
        if self._only is not None:
            return self._only.step(values)
        outputs, at = [], 0
        for instance, count in zip(self._all, self._counts, strict=True):
            outputs += instance.step(values[at : at + count])
            at += count
        return outputs

    def close(self) -> None:
        """Free all instances."""
        for instance in self._all:
            instance.close()


def serve() -> None:
    """Run instances in a child process, controlled through standard input; output of the FMU is discarded.

    The first line contains the specifications of the instances as JSON. ``s`` starts a run; ``x`` followed by the
    inputs requests a step. A response is ``+`` and the outputs, or ``-``, a length and an error message.
    """
    answers, questions = os.fdopen(os.dup(1), "wb", 0), os.fdopen(os.dup(0), "rb")
    nowhere = os.open(os.devnull, os.O_RDWR)
    for stream in (0, 1, 2):
        os.dup2(nowhere, stream)
    specs = json.loads(questions.readline())
    inputs, outputs = (
        struct.Struct(f"={sum(len(spec[word]) for spec in specs)}d")
        for word in ("inputs", "outputs")
    )
    instances: Instances | None = None
    while head := questions.read(1):
        try:
            if instances is None:
                instances = Instances(specs)
            if head == b"s":
                instances.start()
                answers.write(b"+" + outputs.pack(*[0.0] * (outputs.size // 8)))
            else:
                answers.write(
                    b"+"
                    + outputs.pack(
                        *instances.step(list(inputs.unpack(questions.read(inputs.size))))
                    )
                )
        except FmuFailedError as error:
            text = str(error).encode()
            answers.write(b"-" + len(text).to_bytes(8, "little") + text)
    if instances is not None:
        instances.close()


if __name__ == "__main__":
    serve()
