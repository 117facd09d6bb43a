"""jounce: from bench measurements to a validated suspension model, and from the model to decisions.

Everything public is an attribute of this package and is loaded when it is first used, so ``import jounce`` is fast.

>>> import jounce as jn
>>> "JounceError" in dir(jn)
True
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:  # what type checkers and editors see; a test keeps it equal to _PUBLIC
    from jounce.core.errors import AssemblyError as AssemblyError
    from jounce.core.errors import DescriptionError as DescriptionError
    from jounce.core.errors import FitError as FitError
    from jounce.core.errors import JounceError as JounceError
    from jounce.core.errors import OutputError as OutputError
    from jounce.core.errors import RecordingError as RecordingError
    from jounce.core.errors import SimulationError as SimulationError
    from jounce.core.findings import Finding as Finding

    __version__: str

_PUBLIC = {  # public name -> module that defines it; a module itself is its own value
    "AssemblyError": "jounce.core.errors",
    "DescriptionError": "jounce.core.errors",
    "Finding": "jounce.core.findings",
    "FitError": "jounce.core.errors",
    "JounceError": "jounce.core.errors",
    "OutputError": "jounce.core.errors",
    "RecordingError": "jounce.core.errors",
    "SimulationError": "jounce.core.errors",
}


def __getattr__(name: str) -> object:
    from importlib import import_module, metadata

    if name == "__version__":
        value: object = metadata.version("jounce")
    elif name in _PUBLIC:
        module = import_module(_PUBLIC[name])
        value = module if _PUBLIC[name] == f"jounce.{name}" else getattr(module, name)
    else:
        from jounce.core.errors import nearest

        raise AttributeError(f"module 'jounce' has no attribute {name!r}. {nearest(name, _PUBLIC)}".rstrip())
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*_PUBLIC, "__version__", "__doc__", "__name__"})
