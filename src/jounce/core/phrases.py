"""Phrases: parts of messages with their German, which is looked up by the English template.

English texts are in the code. Their German is in the ``phrases.toml`` of the package: one row for each template,
``"unknown {kind} {name}" = "{kind} {name} ist nicht bekannt"``. Inserted values are translated if they are phrases
themselves; names from the user are not. A message without German is shown in English, and marked as such.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any

_PACKAGES = Path(__file__).parent.parent


class Phrase(str):
    """A text that keeps its template and fields.

    The template is English, with fields in braces as in `str.format`; it is the key of the German. Fields are given by
    name: numbers, texts, other phrases. A text without fields may contain any braces.

    Examples
    --------
    >>> text = Phrase("unknown {kind} {name}", kind=Phrase("road"), name="'bumb'")
    >>> print(text, text.german(), sep="; ")
    unknown road 'bumb'; Straße 'bumb' ist nicht bekannt
    """

    __slots__ = ("_fields", "_template")
    _template: str
    _fields: dict[str, Any]

    def __new__(cls, template: str, /, **fields: Any) -> Phrase:
        """Fill the template."""
        phrase = super().__new__(cls, template.format(**fields) if fields else template)
        phrase._template, phrase._fields = template, fields
        return phrase

    def __reduce__(self) -> tuple[Any, ...]:
        return _phrase, (self._template, self._fields)

    def german(self) -> str | None:
        """German text; None if no row has its template."""
        template = _rows().get(self._template)
        if template is None or not self._fields:
            return template
        return template.format(**{name: in_german(item) for name, item in self._fields.items()})


class Phrases(Phrase):
    """A sequence of phrases; in German if any of them has German.

    Examples
    --------
    >>> Phrases("; ", [Phrase("out of range"), "x"]).german()
    'außerhalb des Bereichs; x'
    """

    __slots__ = ("_items", "_mark")
    _mark: str
    _items: tuple[str, ...]

    def __new__(cls, mark: str, items: Iterable[str], /) -> Phrases:
        """Join the phrases with a mark between them."""
        parts = tuple(items)
        phrase = str.__new__(cls, mark.join(parts))
        phrase._mark, phrase._items = mark, parts
        return phrase

    def __reduce__(self) -> tuple[Any, ...]:
        return Phrases, (self._mark, self._items)

    def german(self) -> str | None:
        """German text; None if none of the phrases has German."""
        if not any(isinstance(item, Phrase) and item.german() for item in self._items):
            return None
        return self._mark.join(map(in_german, self._items))


class Translated(Phrase):
    """A text with its German already known, such as a message from a different process."""

    __slots__ = ("_german",)
    _german: str | None

    def __new__(cls, english: str, german: str | None, /) -> Translated:
        """Keep both texts."""
        phrase = str.__new__(cls, english)
        phrase._german = german
        return phrase

    def __reduce__(self) -> tuple[Any, ...]:
        return Translated, (str(self), self._german)

    def german(self) -> str | None:
        """The given German text."""
        return self._german


def german_of(text: str) -> str | None:
    """Return the German of a text; None if there is none.

    >>> german_of("out of range"), german_of("front_left")
    ('außerhalb des Bereichs', None)
    """
    return text.german() if isinstance(text, Phrase) else _rows().get(text)


def in_german(part: Any) -> Any:
    """Return the German of a phrase; numbers, names and phrases without German are returned unchanged."""
    return (part.german() or part) if isinstance(part, Phrase) else part


def _phrase(template: str, fields: dict[str, Any]) -> Phrase:
    return Phrase(template, **fields)


@cache
def _rows() -> dict[str, str]:
    """German by English of all packages."""
    tables = (
        tomllib.loads(file.read_text(encoding="utf-8"))
        for file in sorted(_PACKAGES.glob("*/phrases.toml"))
    )
    return {english: german for table in tables for english, german in table.items()}
