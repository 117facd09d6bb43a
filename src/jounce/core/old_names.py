"""Public names that have another one now: they still work, and say what to write instead."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Callable, Mapping
from typing import Any


def with_old_names(
    module: str, old: Mapping[str, str], load: Callable[[str], Any] | None = None
) -> Callable[[str], Any]:
    """Return the ``__getattr__`` of a module that gives what has a new name by its ``old`` one, and warns.

    ``load`` gives what else the module does not hold.
    """

    def get(name: str) -> Any:
        if name in old:
            warnings.warn(f"{module}.{name} is called {old[name]} now", DeprecationWarning, stacklevel=2)
            return getattr(sys.modules[module], old[name])
        if load is None:
            raise AttributeError(f"module {module!r} has no attribute {name!r}")
        return load(name)

    return get
