"""Renamed public names, methods and properties: the old names still work, with a warning that gives the new name."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Callable, Mapping
from functools import wraps
from typing import Any, ParamSpec, TypeVar

P = ParamSpec("P")
R = TypeVar("R")


def with_old_names(
    module: str, old: Mapping[str, str], load: Callable[[str], Any] | None = None
) -> Callable[[str], Any]:
    """Return a module's ``__getattr__`` that resolves ``old`` names to new ones, with a warning.

    ``load`` resolves other names that the module loads lazily.
    """

    def get(name: str) -> Any:
        if name in old:
            warnings.warn(
                f"{module}.{name} is called {old[name]} now", DeprecationWarning, stacklevel=2
            )
            return getattr(sys.modules[module], old[name])
        if load is None:
            raise AttributeError(f"module {module!r} has no attribute {name!r}")
        return load(name)

    return get


def old_method(old: str, new: str) -> Any:
    """Return a method that calls the method ``new`` of the same object, with a warning; ``old`` is ``"Class.name"``.

    >>> class Spring:
    ...     def stretch(self, length):
    ...         return 2.0 * length
    ...
    ...     stretched = old_method("Spring.stretched", "stretch")
    """

    def call(self: Any, *arguments: Any, **options: Any) -> Any:
        warnings.warn(f"{old} is called {new} now", DeprecationWarning, stacklevel=2)
        return getattr(self, new)(*arguments, **options)

    call.__doc__ = f"Call ``{new}``, the current name of this method, with a warning."
    return call


def old_property(old: str, new: str) -> Any:
    """Return a property that returns the attribute ``new`` of the same object, with a warning."""

    def get(self: Any) -> Any:
        warnings.warn(f"{old} is called {new} now", DeprecationWarning, stacklevel=2)
        return getattr(self, new)

    get.__doc__ = f"The attribute ``{new}`` under its old name, with a warning."
    return property(get)


def old_argument(old: str, new: str) -> Callable[[Callable[P, R]], Callable[P, R]]:
    """Let callers of a function still name an argument by its ``old`` name, with a warning.

    >>> @old_argument("stretch", "deflection")
    ... def force(deflection):
    ...     return 2.0 * deflection
    >>> with warnings.catch_warnings(action="ignore"):
    ...     force(stretch=3.0)
    6.0
    """

    def decorate(function: Callable[P, R]) -> Callable[P, R]:
        @wraps(function)
        def call(*arguments: P.args, **options: P.kwargs) -> R:
            if old in options:
                message = f"the argument {old} of {function.__qualname__} is called {new} now"
                warnings.warn(message, DeprecationWarning, stacklevel=2)
                options[new] = options.pop(old)
            return function(*arguments, **options)

        return call

    return decorate
