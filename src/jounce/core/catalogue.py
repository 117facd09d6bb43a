"""Texts of findings, in English and German: one ``findings.toml`` in the folder of each package.

A row has a severity and a sentence in each language; ``{name}`` is replaced by a number or text of the finding. Numbers
are SI: ``{travel:.3g mm}`` writes 0.0123 as ``12.3 mm``, ``{low:.3g ~mm}`` as ``12.3``. The table ``words`` has the
German of inserted words (``bump``, ``left``). A file is read when one of its codes is first used.
"""

from __future__ import annotations

import math
import string
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, Literal, get_args

from jounce.core.phrases import Phrase, in_german

Severity = Literal["note", "warning", "problem"]
Language = Literal["en", "de"]
FACTORS = {
    "mm": 1e3, "mm/s": 1e3, "%": 100.0, "deg": 180.0 / math.pi, "ms": 1e3, "N/mm": 1e-3, "kN": 1e-3, "kHz": 1e-3,
    "kJ": 1e-3, "kW": 1e-3, "MPa": 1e-6, "bar": 1e-5, "cm": 1e2, "km/h": 3.6,
}  # fmt: skip
"""Display value of one SI unit, by the unit after a format; without a unit after the format, values stay SI."""
_PACKAGES = Path(__file__).parent.parent


@dataclass(frozen=True)
class Row:
    """One kind of finding.

    Attributes
    ----------
    severity : {"note", "warning", "problem"}
        Severity, unless the code that reports it sets another.
    en, de : str
        Sentences with fields in braces.
    """

    severity: Severity
    en: str
    de: str


@dataclass(frozen=True)
class Catalogue:
    """Rows of a package by name, and the German of inserted words."""

    rows: Mapping[str, Row]
    words: Mapping[str, str]


@cache
def catalogue_of(package: str) -> Catalogue:
    """Read the findings of a package; empty without a file."""
    file = _PACKAGES.joinpath(*package.split("."), "findings.toml")
    tables = tomllib.loads(file.read_text(encoding="utf-8")) if file.is_file() else {}
    words = tables.pop("words", {})
    assert all(row["severity"] in get_args(Severity) for row in tables.values())
    return Catalogue({name: Row(**row) for name, row in tables.items()}, words)


def row_of(code: str) -> Row | None:
    """Return the row of a code such as ``parts.steep_strut``; None for unknown codes, e.g. of a newer jounce."""
    return catalogue_of(_package(code)).rows.get(code.rpartition(".")[2])


def _package(code: str) -> str:
    """Package of a code; codes of inspection have no package prefix, because archives contain them so."""
    package = code.rpartition(".")[0]
    return package if package.isidentifier() else "inspection"


def sentence(
    code: str, numbers: Mapping[str, Any], language: Language = "en", *, decimal: str = "."
) -> str:
    """Return the sentence of a code with its numbers inserted.

    Examples
    --------
    >>> sentence("parts.steep_angle", {"angle": 0.35}), sentence("parts.steep_angle", {"angle": 0.35}, "de")
    ('20.1 deg is a lot; were degrees given as rad?', '20.1 ° ist viel; wurden Grad als rad angegeben?')
    """
    row = row_of(code)
    if row is None:
        raise KeyError(code)
    return _Filled(_package(code), language, decimal).vformat(getattr(row, language), (), numbers)


class _Filled(string.Formatter):
    """Formatter that writes numbers in the unit after their format, and words in the language of the sentence."""

    def __init__(self, package: str, language: Language, decimal: str) -> None:
        self.words = catalogue_of(package).words if language == "de" else {}
        self.language, self.decimal = language, decimal

    def format_field(self, value: Any, format_spec: str) -> str:
        digits, _, unit = format_spec.partition(" ")
        if value is None:  # not a finite number, in a file
            return "–"
        if hasattr(value, "said"):
            return str(value.sentence(self.language, decimal=self.decimal))
        if isinstance(value, Mapping):  # a finding that was plain data in a file
            return sentence(value["code"], value["numbers"], self.language, decimal=self.decimal)
        if isinstance(value, (list, tuple)):
            return ", ".join(self.format_field(item, format_spec) for item in value)
        if isinstance(value, Phrase):  # the text of an error
            return in_german(value) if self.language == "de" else str(value)
        if isinstance(value, str):
            return format(
                ", ".join(self.words.get(word, word) for word in value.split(", ")), digits
            )
        unit, is_written = unit.removeprefix("~"), not unit.startswith("~")
        text = format(value * FACTORS[unit] if unit else value, digits).replace(".", self.decimal)
        return (
            f"{text} {_GERMAN_UNITS.get(unit, unit) if self.language == 'de' else unit}"
            if unit and is_written
            else text
        )


_GERMAN_UNITS = {"deg": "°"}
