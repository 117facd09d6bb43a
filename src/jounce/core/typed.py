"""Parse values that users type: numbers with units, ranges, pairs, and TOML values."""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from jounce.core.errors import DescriptionError
from jounce.core.phrases import Phrase

if TYPE_CHECKING:
    from pydantic import BaseModel

LONGEST = 10.0
"""Length (m) above which a bare number is refused as probably millimetres: no part of a suspension is longer."""


def quantity(text: str, unit: str, where: str, *, most: float | None = None) -> float:
    """Convert a number with its unit to SI; a bare number is SI, as in files, and refused if that is implausible.

    ``most`` is a tighter limit of bare numbers than that of their unit.
    """
    from jounce.core.units import to_si

    return to_si(_plausible(text, unit, where, most), unit, where=where)


def positive_quantity(text: str, unit: str, where: str, *, most: float | None = None) -> float:
    """Read a number that must be above 0."""
    from jounce.core.units import positive_si

    return positive_si(_plausible(text, unit, where, most), unit, where=where)


def _plausible(text: str, unit: str, where: str, most: float | None) -> str | float:
    from jounce.core.units import bare_si

    given = bare_number(text)
    return given if isinstance(given, str) else bare_si(given, unit, where=where, most=most)


def bare_number(text: str) -> str | float:
    """Return the number if the text is one, otherwise the text."""
    try:
        return float(text)
    except ValueError:
        return text


def ends(text: str) -> tuple[str | float, str | float] | None:
    """Split ``LOW..HIGH UNIT``; a unit after the second end applies to both. None if the text is no range.

    >>> ends("20..40 N/mm"), ends("300..6000"), ends("10 %")
    (('20 N/mm', '40 N/mm'), (300.0, 6000.0), None)
    """
    low, dots, high = text.partition("..")
    if not dots:
        return None
    first, second = bare_number(low.strip()), bare_number(high.strip())
    if isinstance(first, float) and isinstance(second, str):
        unit = second.lstrip("+-0123456789.eE ")
        return f"{low.strip()} {unit}", second
    return first, second


def unreadable_band(text: object, where: str, words: Sequence[str]) -> DescriptionError:
    """Return the error for a text that is not a valid band of spatial frequencies."""
    allowed = ", ".join([*words, "LOW..HIGH"])
    return DescriptionError(
        "invalid band of spatial frequencies", where=where, found=text, allowed=allowed
    )


def pairs(texts: Sequence[str] | None, where: str, example: str) -> dict[str, str]:
    """Split ``NAME=VALUE`` texts."""
    split: dict[str, str] = {}
    for text in texts or ():
        name, equals, value = text.partition("=")
        name, value = name.strip(), value.strip()
        if not (equals and name and value):
            raise DescriptionError(
                "not NAME=VALUE",
                where=where,
                found=text,
                allowed=Phrase("e.g. {example}", example=example),
            )
        if name in split:
            raise DescriptionError(
                Phrase("{name!r} is given twice", name=name), where=where, found=text
            )
        split[name] = value
    return split


def toml_value(text: str) -> Any:
    """Read a TOML value on one line; a text that is not valid TOML is returned as it is."""
    from jounce.core.description import toml_table

    try:
        value = toml_table(f"value = {text}")["value"]
    except tomllib.TOMLDecodeError:
        return text
    try:
        return float(value) if isinstance(value, int) and not isinstance(value, bool) else value
    except OverflowError:  # refused later, when read as a size
        return value


def bare_numbers(
    kind: type[BaseModel], texts: dict[str, str], option: Callable[[str], str]
) -> dict[str, str | float]:
    """Convert texts to field values of a description; implausible bare numbers are refused as in `quantity`.

    ``option`` returns the name of a field's option for errors.
    """
    from jounce.core.units import Unit, bare_si

    given = {name: bare_number(text) for name, text in texts.items()}
    for name, value in given.items():
        units = [
            item.si
            for item in getattr(kind.model_fields.get(name), "metadata", ())
            if isinstance(item, Unit)
        ]
        if units and isinstance(value, float):
            bare_si(value, units[0], where=option(name), most=LONGEST if units[0] == "m" else None)
    return given
