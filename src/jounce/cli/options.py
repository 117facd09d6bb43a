"""Options that several commands share, and how their text becomes values."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any

import typer

from jounce.core.errors import DescriptionError

AsJson = Annotated[bool, typer.Option("--json", help="Print exactly one JSON object (SI) instead of tables.")]
Force = Annotated[bool, typer.Option("--force", help="Overwrite what exists.")]
Changes = Annotated[
    list[str] | None,
    typer.Option("--set", metavar="PATH=VALUE", help='Change a value of the rig: strut.spring.rate="25 N/mm".'),
]
Columns = Annotated[
    list[str] | None,
    typer.Option(
        "--columns",
        metavar="NAME=COLUMN",
        help=r'Where a quantity is in the file, with its unit if the header has none: force="F \[kN]". Repeat it.',
    ),
]
RigName = Annotated[str, typer.Argument(metavar="RIG", help="A rig file, or a name of `jounce library`.")]
VehicleName = Annotated[
    str, typer.Argument(metavar="VEHICLE", help="A vehicle or rig file, or a name of `jounce library`.")
]


def quantity(text: str, unit: str, option: str) -> float:
    """Read the value of an option into SI; a bare number is SI, as in the files."""
    from jounce.core.units import to_si

    return to_si(bare_number(text), unit, where=option)


def optional_quantity(text: str | None, unit: str, option: str) -> float | None:
    """Read the value of an option that may be left out."""
    return None if text is None else quantity(text, unit, option)


def positive_quantity(text: str, unit: str, option: str) -> float:
    """Read the value of an option that must be above 0."""
    from jounce.core.units import positive_si

    return positive_si(bare_number(text), unit, where=option)


def optional_positive(text: str | None, unit: str, option: str) -> float | None:
    """Read the value of an option that may be left out, and must be above 0."""
    return None if text is None else positive_quantity(text, unit, option)


def pairs(texts: Sequence[str] | None, option: str, example: str) -> dict[str, str]:
    """Split ``NAME=VALUE`` texts."""
    found: dict[str, str] = {}
    for text in texts or ():
        name, equals, value = text.partition("=")
        name, value = name.strip(), value.strip()
        if not (equals and name and value):
            raise DescriptionError("not NAME=VALUE", where=option, found=text, allowed=f"e.g. {example}")
        if name in found:
            raise DescriptionError(f"{name!r} is given twice", where=option, found=text)
        found[name] = value
    return found


def changes(texts: Sequence[str] | None) -> dict[str, Any]:
    """Values by path from ``--set``: text with a unit, or anything that TOML writes on one line."""
    given = pairs(texts, "--set", 'strut.spring.rate="25 N/mm"')
    return {path: _toml_value(value) for path, value in given.items()}


def columns(texts: Sequence[str] | None) -> dict[str, str] | None:
    """Columns by quantity from ``--columns``, one or several in each text; None when nothing is mapped."""
    split = [part for text in texts or () for part in re.split(r",\s*(?=[\w.]+\s*=)", text)]
    return pairs(split, "--columns", 'force="F [kN]"') or None


def files(names: Sequence[str], option: str) -> list[Path]:
    """Paths as given; patterns that no shell has expanded are expanded here."""
    from jounce.core.errors import RecordingError

    found: list[Path] = []
    for name in names:
        path = Path(name)
        if path.exists() or not any(mark in name for mark in "*?["):
            found.append(path)
            continue
        matches = sorted(Path(path.anchor or ".").glob(str(path.relative_to(path.anchor))))
        if not matches:
            raise RecordingError("no file matches", where=option, found=name, hint="Check the folder and the pattern.")
        found += matches
    return found


def bare_number(text: str) -> str | float:
    """Give the number when the text is one, otherwise the text."""
    try:
        return float(text)
    except ValueError:
        return text


def _toml_value(text: str) -> Any:
    try:
        value = tomllib.loads(f"value = {text}")["value"]
    except tomllib.TOMLDecodeError:
        return text
    return float(value) if isinstance(value, int) and not isinstance(value, bool) else value
