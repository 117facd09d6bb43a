"""Values that people type: numbers with units, ranges, pairs, and values of TOML."""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from jounce.core.errors import DescriptionError
from jounce.core.phrases import Phrase

if TYPE_CHECKING:
    from pydantic import BaseModel

LONGEST = 10.0
"""Length (m) above which a bare number is taken for millimetres: no part of a suspension is longer."""


def quantity(text: str, unit: str, where: str, *, most: float | None = None) -> float:
    """Read a number with its unit into SI; a bare number is SI, as in the files, unless that is implausible.

    ``most`` bounds bare numbers more closely than their unit does.
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
    """Return the number when the text is one, otherwise the text."""
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
    """Refuse anything but a band of spatial frequencies."""
    allowed = ", ".join([*words, "LOW..HIGH"])
    return DescriptionError(
        "not a band of spatial frequencies", where=where, found=text, allowed=allowed
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
    """Read anything that TOML writes on one line; what is no TOML is text."""
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
    """Values of the fields of a description as it takes them; numbers without a unit are refused as in `quantity`.

    ``option`` names the place of a field.
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
