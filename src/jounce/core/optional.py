"""Import packages of optional extras, or report what to install."""

from __future__ import annotations

import importlib
import json
import re
import sys
from pathlib import Path
from types import ModuleType

from jounce.core.errors import JounceError
from jounce.core.phrases import Phrase


class MissingPackageError(JounceError):
    """A required package is not installed."""


def require(module: str, extra: str) -> ModuleType:
    """Import a package of an optional extra; raise MissingPackageError with the install command if it is missing.

    >>> require("json", "io").dumps([1])
    '[1]'
    """
    package = module.partition(".")[0]
    if package in _HIDDEN:
        _HIDDEN.remove(package)
        del sys.modules[package]
    try:
        return importlib.import_module(module)
    except ModuleNotFoundError as error:
        if error.name is None or error.name.partition(".")[0] != module.partition(".")[0]:
            raise
        raise MissingPackageError(
            Phrase("the package {module!r} is not installed", module=module),
            hint=Phrase(
                "Install the package with: {how_to_install}", how_to_install=how_to_install(extra)
            ),
        ) from None


def hide_from_others(*modules: str) -> None:
    """Let packages that use a module only if it is installed go without it; :func:`require` still imports it.

    >>> hide_from_others("xmlrpc")
    >>> sys.modules["xmlrpc"], require("xmlrpc", extra="io").__name__
    (None, 'xmlrpc')
    """
    for module in modules:
        if module not in sys.modules:
            sys.modules[module] = None  # type: ignore[assignment]  # the import system's sign for it
            _HIDDEN.add(module)


_HIDDEN: set[str] = set()


def how_to_install(extra: str) -> str:
    """Return the command that installs an extra: from the source folder of jounce if known, else package by package.

    A package index may not have jounce, or may have a different project of that name.
    """
    from importlib import metadata
    from urllib.parse import urlsplit
    from urllib.request import url2pathname

    from jounce.core.commands import command_line

    try:
        own = metadata.distribution("jounce")
    except metadata.PackageNotFoundError:  # sources on the path, nothing installed
        return command_line(["pip", "install", f".[{extra}]"])
    source = json.loads(own.read_text("direct_url.json") or "{}")
    address = urlsplit(source.get("url", ""))
    folder = Path(url2pathname(address.path))
    if address.scheme == "file" and (folder / "pyproject.toml").is_file():
        editable = ["-e"] if source.get("dir_info", {}).get("editable") else []
        return command_line(["pip", "install", *editable, f"{folder}[{extra}]"])
    needed = [requirement.partition(";") for requirement in own.requires or ()]
    return command_line(
        ["pip", "install", *(name for name, _, when in needed if re.search(rf"\b{extra}\b", when))]
    )
