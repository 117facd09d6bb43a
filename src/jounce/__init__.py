"""jounce: from bench measurements to a validated suspension model, and from the model to decisions.

Everything public is an attribute of this package and is loaded when it is first used, so ``import jounce`` is fast.
The one list of these names is ``__init__.pyi``.

>>> import jounce as jn
>>> "JounceError" in dir(jn)
True
"""

from __future__ import annotations

import sys
from types import FunctionType
from typing import Any

import lazy_loader

_loaded, _, __all__ = lazy_loader.attach_stub(__name__, __file__)
_OLD_NAMES = {"adjusted": "apply_adjustments"}


def __getattr__(name: str) -> object:
    if name == "__version__":
        from importlib import metadata

        return metadata.version("jounce")
    if name.startswith("__"):  # what tools ask every object for is no name misspelt
        raise AttributeError(f"module 'jounce' has no attribute {name!r}.")
    if name in _OLD_NAMES:
        from jounce.core.old_names import with_old_names

        return with_old_names(__name__, _OLD_NAMES)(name)
    if name not in __all__:
        from jounce.core.synonyms import suggestion

        raise AttributeError(
            f"module 'jounce' has no attribute {name!r}. {suggestion(name, __all__)}".rstrip()
        )
    value = _loaded(name)
    if isinstance(value, FunctionType):
        from jounce.core.arguments import guard_arguments

        globals()[name] = value = guard_arguments(value, name)
    return value


def __dir__() -> list[str]:
    return sorted([*__all__, "__version__", "__doc__", "__name__"])


def _recordings_in_notebooks() -> None:
    """Let a notebook show recordings and sweeps by channel, with units; other datasets as their library does."""

    def table(data: Any) -> str:
        from jounce.core.shown import dataset_html

        return dataset_html(data)

    if "IPython" in sys.modules:
        from IPython import get_ipython

        shell = get_ipython()
        if shell is not None and getattr(shell, "display_formatter", None) is not None:
            formatter = shell.display_formatter.formatters["text/html"]
            formatter.for_type_by_name("xarray.core.dataset", "Dataset", table)


_recordings_in_notebooks()
