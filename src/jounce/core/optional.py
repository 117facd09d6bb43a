"""Packages that come with an extra: import them, or say what to install."""

from __future__ import annotations

import importlib
from types import ModuleType

from jounce.core.errors import JounceError


class MissingPackageError(JounceError):
    """A package is needed that is not installed."""


def require(module: str, extra: str) -> ModuleType:
    """Import a package of an optional extra; where it is missing, a MissingPackageError says how to install it.

    >>> require("json", "io").dumps([1])
    '[1]'
    """
    try:
        return importlib.import_module(module)
    except ModuleNotFoundError as error:
        if error.name is None or error.name.partition(".")[0] != module.partition(".")[0]:
            raise
        raise MissingPackageError(
            f"the package {module!r} is not installed", hint=f"Install it with: pip install 'jounce[{extra}]'"
        ) from None
