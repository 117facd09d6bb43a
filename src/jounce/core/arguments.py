"""Check arguments of public functions: if a call fails, the error names the argument of the wrong type."""

from __future__ import annotations

import importlib
import inspect
import operator
import os
import sys
import types
import typing
from collections.abc import Callable, Iterable, Iterator, Mapping, Sized
from contextlib import suppress
from dataclasses import fields, is_dataclass
from functools import wraps
from typing import Any, Literal, TypeVar, get_args, get_origin

from jounce.core.errors import DescriptionError, JounceError, value_or_kind
from jounce.core.phrases import Phrase

Function = TypeVar("Function", bound=Callable[..., Any])

_KINDS = {
    "Rig": ("a rig or a vehicle", "jn.load(...) reads one from a file or the library."),
    "Trial": ("a trial", "Make one: jn.Trial(road=..., speed=..., duration=...)."),
    "HoldsTrial": ("what holds one", ""),
    "RideTrial": (
        "a trial for ride studies",
        "Make one: jn.iso_trial(rig, ...) or jn.road_trial(rig, ...).",
    ),
    "Road": ("a road", "Make one, e.g. jn.HalfSine(...), or read it: jn.load_road(...)."),
    "Dataset": (
        "a recording (xarray.Dataset)",
        "jn.read_recording(...) reads a recording from a file, jn.recording(...) creates one from arrays.",
    ),
    "FitTrial": ("a measured trial", "Make one: jn.FitTrial(name, rig, trial, measured)."),
    "Tester": ("a tester", "jn.load_tester(...) reads one from a file or the library."),
    "Path": ("a path", ""),
    "str": ("a text", ""),
    "float": ("a number", ""),
    "int": ("a whole number", ""),
    "bool": ("True or False", ""),
    "NoneType": ("None", ""),
    "ndarray": ("an array of numbers", ""),
    "Numbers": ("an array of numbers", ""),
}
"""Common name of a class, and how to get an instance; other classes are shown by their own names."""


def guard_arguments(function: Function, name: str) -> Function:
    """Wrap a public function so that its failures name the argument that does not match its annotation.

    Successful calls, errors of jounce and errors with matching arguments are not changed. Arguments are checked only
    after a failure, except for switches, which must be True or False. The wrapped function reports ``jounce`` as its
    module.

    >>> def halve(length: float) -> float:
    ...     return length / 2.0
    >>> guard_arguments(halve, "halve")([1.0])
    Traceback (most recent call last):
    jounce.core.errors.DescriptionError: halve: length: a list was given; allowed: a number.
    """
    flags = frozenset(
        key for key, hint in function.__annotations__.items() if hint in ("bool", bool)
    )

    @wraps(function)
    def call(*arguments: Any, **options: Any) -> Any:
        if not all(fits(options[key], bool) for key in flags & options.keys()):
            error = misfit(
                function, arguments, options
            )  # the text "no" would count as True, and overwrite files
            if error is not None:
                raise error
        try:
            return function(*arguments, **options)
        except JounceError:
            raise
        except Exception:
            error = misfit(function, arguments, options)
            if error is None:
                raise
            raise error from None

    call.__module__, call.__qualname__ = "jounce", name
    return typing.cast("Function", call)


def misfit(
    function: Callable[..., Any], arguments: tuple[Any, ...], options: Mapping[str, Any]
) -> DescriptionError | None:
    """Return the error for the first argument that does not match its annotation; None if all match."""
    signature = inspect.signature(function)
    try:
        given = signature.bind(*arguments, **options).arguments
    except TypeError:  # Python's message names the missing or unknown argument
        return None
    hints = _hints(function)
    for name, value in given.items():
        if signature.parameters[name].kind in (
            inspect.Parameter.VAR_POSITIONAL,
            inspect.Parameter.VAR_KEYWORD,
        ):
            continue
        for place, wrong, hint in _misfits(value, hints.get(name, Any), name):
            words, ways = map(dict.fromkeys, zip(*_words(hint), strict=True))
            swapped = [
                other
                for other, kind in hints.items()
                if other in signature.parameters and _is_for(wrong, kind)
            ]
            advice = (
                [f"It would do for {swapped[0]!r}: are the arguments in order?"] if swapped else []
            )
            return DescriptionError(
                Phrase("{wrong} was given", wrong=value_or_kind(wrong)),
                where=f"{function.__name__}: {place}",
                allowed=" or ".join(words),
                hint=" ".join([*advice, *filter(None, ways)]),
            )
    return None


def _hints(function: Callable[..., Any]) -> dict[str, Any]:
    """Annotations of a function or class as types; unresolvable ones are left out."""
    space = _ModuleNames(vars(sys.modules[function.__module__]))
    hints: dict[str, Any] = {}
    for name, annotation in inspect.get_annotations(function).items():
        holder = types.SimpleNamespace(__annotations__={name: annotation})
        with suppress(NameError, AttributeError, TypeError):
            hints |= typing.get_type_hints(holder, {}, space)
    return hints


class _ModuleNames(dict[str, Any]):
    """Names of a module, including those it imports for type checkers only, found in other modules of jounce."""

    def __missing__(self, name: str) -> Any:
        if name in ("pd", "xr"):
            return importlib.import_module({"pd": "pandas", "xr": "xarray"}[name])
        for module in [module for key, module in sys.modules.items() if key.startswith("jounce.")]:
            if name in vars(module):
                return vars(module)[name]
        raise KeyError(name)


def _misfits(value: Any, hint: Any, place: str) -> Iterator[tuple[str, Any, Any]]:
    """Yield mismatches of a value, or of the values in it: path, value, and expected type."""
    if fits(value, hint):
        if is_dataclass(value) and not isinstance(value, type):
            hints = _hints(type(value))
            for field in fields(value):
                yield from _misfits(
                    getattr(value, field.name), hints.get(field.name, Any), f"{place}.{field.name}"
                )
        elif isinstance(value, (list, tuple)):
            for k, item in enumerate(value):
                yield from _misfits(item, Any, f"{place}[{k}]")
        return
    inside = list[tuple[str, Any, Any]]()
    for option in _options(hint):
        origin, parts = get_origin(option), get_args(option)
        if _is_mapping(origin) and isinstance(value, Mapping):
            for key, item in value.items():
                inside += [
                    *_misfits(key, parts[0], place),
                    *_misfits(item, parts[1], f"{place}[{key!r}]"),
                ]
        elif _is_series(origin) and isinstance(value, (list, tuple)):
            each = (
                parts
                if len(parts) == len(value) and parts[-1] is not Ellipsis
                else parts[:1] * len(value)
            )
            for k, (item, part) in enumerate(zip(value, each, strict=True)):
                inside += _misfits(item, part, f"{place}[{k}]")
    yield from inside or [(place, value, hint)]


def _options(hint: Any) -> tuple[Any, ...]:
    """Members of a union, or the hint itself; NumPy's array-like counts as one member."""
    parts = _members(hint)
    if len(parts) == 1:
        return parts
    from numpy.typing import ArrayLike

    arrays = _members(ArrayLike)
    if not set(arrays) <= set(parts):
        return parts
    return (ArrayLikeNumbers, *(part for part in parts if part not in arrays))


def _members(hint: Any) -> tuple[Any, ...]:
    """Members of a union and of nested ones; NumPy 2.5 names its unions by ``type`` statements (PEP 695)."""
    origin = get_origin(hint) or hint
    if hasattr(origin, "__value__"):
        return _members(origin.__value__)
    if origin not in (typing.Union, types.UnionType):
        return (hint,)
    return tuple(dict.fromkeys(member for part in get_args(hint) for member in _members(part)))


class ArrayLikeNumbers:
    """Anything that NumPy converts to an array of numbers."""


def _is_mapping(origin: Any) -> bool:
    return isinstance(origin, type) and issubclass(origin, Mapping)


def _is_series(origin: Any) -> bool:
    is_listed = (
        isinstance(origin, type)
        and issubclass(origin, Iterable)
        and not issubclass(origin, Mapping)
    )
    return is_listed and origin.__name__ != "ndarray"


def _is_for(value: Any, hint: Any) -> bool:
    """Whether a value is an instance of a class in the annotation: a rig, a road, a recording."""
    return any(
        isinstance(option, type) and bool(_words(option)[0][1]) and fits(value, option)
        for option in _options(hint)
    )


def fits(value: Any, hint: Any) -> bool:
    """Whether a value matches an annotation; True if this cannot be decided."""
    options = _options(hint)
    if len(options) > 1:
        return any(fits(value, option) for option in options)
    (hint,) = options
    origin, parts = get_origin(hint), get_args(hint)
    kind = origin or hint
    if isinstance(hint, TypeVar):
        return hint.__bound__ is None or fits(value, hint.__bound__)
    if origin is typing.Annotated:
        return fits(value, parts[0])
    if origin is Literal:
        return any(type(value) is type(part) and value == part for part in parts)
    if hint is bool:
        return type(value).__name__ in ("bool", "bool_", "int") and value in (0, 1)
    if not isinstance(kind, type):
        return True
    if kind in (float, int, ArrayLikeNumbers) or kind.__name__ == "ndarray":
        return _is_number(value, kind)
    if kind.__name__ == "Callable":
        return callable(value)
    if _is_mapping(kind) and parts:
        return isinstance(value, Mapping) and all(
            fits(key, parts[0]) and fits(item, parts[1]) for key, item in value.items()
        )
    if _is_series(kind) and parts:
        return _is_series_of(value, kind, parts)
    with suppress(TypeError):  # protocols without runtime checks
        return isinstance(value, os.PathLike if issubclass(kind, os.PathLike) else kind)
    return True


def _is_series_of(value: Any, kind: type, parts: tuple[Any, ...]) -> bool:
    if isinstance(value, (str, bytes, Mapping)) or not isinstance(value, Iterable):
        return False
    if isinstance(value, Iterator):  # an iterator can be consumed only once
        return True
    if kind is tuple and not isinstance(value, (tuple, list)):
        return False
    can_be_indexed = hasattr(value, "__getitem__") or kind is Iterable
    if not isinstance(value, Sized) or not can_be_indexed or _dimensions(value) != 1:
        return False
    if kind is tuple and parts[-1] is not Ellipsis:
        return len(value) == len(parts) and all(map(fits, value, parts))
    return all(fits(item, parts[0]) for item in value)


def _is_number(value: Any, kind: type) -> bool:
    """Whether a value is a number, or an array of numbers; text is not a number, although NumPy converts it."""
    import numpy as np

    if value is None or (
        kind in (float, int) and (isinstance(value, (str, bytes)) or _dimensions(value, 0))
    ):
        return False
    try:
        if kind is int:
            return abs(operator.index(value)) < 2**63
        _ = float(value) if kind is float else np.asarray(value, dtype=float)
    except Exception:  # noqa: BLE001 - conversion of a foreign object may raise anything
        return False
    return True


def _dimensions(value: Any, usual: int = 1) -> int:
    """Number of dimensions of an array; ``usual`` for any other value."""
    dimensions = getattr(value, "ndim", usual)
    return dimensions if isinstance(dimensions, int) else usual


def _words(hint: Any) -> list[tuple[str, str]]:
    """Common name of each expected type, and how to get it; one pair for each member of a union."""
    options = _options(hint)
    if len(options) > 1:
        return [pair for option in options for pair in _words(option)]
    (hint,) = options
    if isinstance(hint, TypeVar) and hint.__bound__ is not None:
        return _words(hint.__bound__)
    origin, parts = get_origin(hint), get_args(hint)
    if origin is typing.Annotated:
        return _words(parts[0])
    if origin is Literal:
        return [(repr(part), "") for part in parts]
    if isinstance(origin, type) and issubclass(origin, Mapping):
        return [
            (
                f"a mapping of {_either(parts[0])} to {_either(parts[1])}"
                if parts
                else "a mapping",
                "",
            )
        ]
    if origin is tuple and parts[-1] is not Ellipsis:
        return [(f"({', '.join(_either(part) for part in parts)})", "")]
    if _is_series(origin) and parts:
        return [(f"a list, each {_either(parts[0])}", _words(parts[0])[0][1])]
    name = getattr(origin or hint, "__name__", str(hint))
    return [_KINDS.get(name, ("a function" if name == "Callable" else name, ""))]


def _either(hint: Any) -> str:
    return " or ".join(dict.fromkeys(word for word, _ in _words(hint)))
