"""Findings: advice as data, never printed directly."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, SupportsFloat, get_args

from jounce.core.catalogue import Language, Severity, row_of, sentence
from jounce.core.errors import Clause, JounceError, OutputError
from jounce.core.old_names import old_method
from jounce.core.phrases import Phrase
from jounce.core.shown import Shown
from jounce.core.text import shorten


@dataclass(frozen=True)
class Finding(Shown):
    """A note, warning or problem about a result.

    Attributes
    ----------
    place : str
        File, path, channel or trial that the finding refers to.
    severity : {"note", "warning", "problem"}
        ``note``: for information; ``warning``: weakens a result; ``problem``: a result is missing or unreliable.
    message : str
        One sentence with the finding and advice; by default the sentence of the code.
    value : float or None
        The number it is based on, SI, if there is one.
    code : str
        Its row in a catalogue, such as ``parts.steep_strut``; empty if there is only the text.
    numbers : mapping
        Values inserted into the sentence: numbers in SI, names and words.
    """

    place: str
    severity: Severity
    message: str
    value: float | None = None
    code: str = field(default="", repr=False, compare=False)
    numbers: Mapping[str, Any] = field(default_factory=dict, repr=False, compare=False)

    def __post_init__(self) -> None:
        """Set the message from the code if none is given."""
        if self.code and not self.message and row_of(self.code) is not None:
            object.__setattr__(self, "message", sentence(self.code, self.numbers))

    def __str__(self) -> str:
        return f"{self.severity}: {self.place}: {self.message}"

    def sentence(self, language: Language = "en", *, decimal: str = ".") -> str:
        """Return its sentence in a language; the message if its code is unknown.

        Parameters
        ----------
        language : {"en", "de"}
            The language.
        decimal : str
            Decimal mark of its numbers.

        Returns
        -------
        str
            One sentence.

        Examples
        --------
        >>> finding("parts.steep_angle", "wheel.toe", 0.35, angle=0.35).sentence("de", decimal=",")
        '20,1 ° ist viel; wurden Grad als rad angegeben?'
        """
        if language == "en" or row_of(self.code) is None:
            return self.message
        return sentence(self.code, self.numbers, language, decimal=decimal)

    said = old_method("Finding.said", "sentence")


def finding(
    code: str,
    place: str,
    value: SupportsFloat | None = None,
    /,
    *,
    severity: Severity | Any = None,
    **numbers: Any,
) -> Finding:
    """Make a finding from a row in the catalogue of a package (see `jounce.core.catalogue`).

    Examples
    --------
    >>> print(finding("parts.steep_angle", "wheel.toe", 0.35, angle=0.35))
    warning: wheel.toe: 20.1 deg is a lot; were degrees given as rad?
    """
    row = row_of(code)
    assert row is not None, code
    plain = {
        name: _text_of(given) if isinstance(given, Exception) else given
        for name, given in numbers.items()
    }
    known = None if value is None else float(value)
    return Finding(place, severity or row.severity, sentence(code, plain), known, code, plain)


def _text_of(error: Exception) -> str:
    return error.message() if isinstance(error, JounceError) else str(error)


def at_place(place: str, item: Finding) -> Finding:
    """Return a copy of a finding with a different place."""
    return replace(item, place=place)


def finding_of(plain: Mapping[str, Any]) -> Finding:
    """Restore a finding from plain data as written by `to_dict` and ``--json``; older data has no code."""
    names = ("place", "severity", "message", "value", "code", "numbers")
    return Finding(**{name: plain[name] for name in names if name in plain})


def with_german(plain: Any) -> Any:
    """Return plain data in which findings with a code, and errors, also have their German sentence under ``german``.

    Examples
    --------
    >>> with_german({"findings": [{"message": "", "code": "parts.steep_angle", "numbers": {"angle": 0.35}}]})
    ... # doctest: +ELLIPSIS
    {'findings': [{'message': '', ..., 'german': '20.1 ° ist viel; wurden Grad als rad angegeben?'}]}
    """
    if isinstance(plain, Mapping):
        table = {name: with_german(item) for name, item in plain.items()}
        message, code, numbers = table.get("message"), table.get("code"), table.get("numbers")
        if isinstance(message, Phrase):
            table["german"] = message.german()
        elif (
            "message" in table
            and "german" not in table
            and isinstance(code, str)
            and isinstance(numbers, dict)
        ):
            table |= {"german": sentence(code, plain["numbers"], "de")} if row_of(code) else {}
        return table
    if isinstance(plain, (list, tuple)) and plain and isinstance(plain[0], (Mapping, list, tuple)):
        return [with_german(item) for item in plain]
    return plain


def translations(plain: Any) -> dict[str, str]:
    """Return the German of the phrases in plain data, by their English text.

    >>> translations({"failed": {"a": Phrase("out of range"), "b": "b"}})
    {'out of range': 'außerhalb des Bereichs'}
    """
    items = (
        plain.values()
        if isinstance(plain, Mapping)
        else plain
        if isinstance(plain, (list, tuple))
        else ()
    )
    german_texts: dict[str, str] = {}
    for item in items:
        if isinstance(item, Phrase) and (german := item.german()):
            german_texts[item] = german
        elif isinstance(item, (Mapping, list, tuple)):
            german_texts |= translations(item)
    return german_texts


def for_page(plain: Mapping[str, Any]) -> Any:
    """Return an answer for a web page: with German for findings and errors, and for texts in ``translations``."""
    texts = translations({name: item for name, item in plain.items() if name != "error"})
    return with_german(plain) | ({"translations": texts} if texts else {})


TEXTS, DATA = "findings", "finding_data"
"""Attributes of recordings that store findings: as texts, and as JSON with their codes."""


def finding_attributes(findings: Iterable[Finding]) -> dict[str, Any]:
    """Return the attributes that store findings in a recording: texts for people, and JSON for `findings_of`."""
    from jounce.core.serialise import to_json

    items = list(findings)
    return {TEXTS: [str(item) for item in items], DATA: to_json(items, indent=None)}


def findings_of(attributes: Mapping[str, Any]) -> list[Finding]:
    """Return the findings stored in a recording; files of older versions have texts without codes.

    >>> found = findings_of({"findings": ["note: a.fmu: v: has no unit: m/s is assumed."]})
    >>> found == findings_of(finding_attributes(found)), str(found[0])
    (True, 'note: a.fmu: v: has no unit: m/s is assumed.')
    """
    if DATA in attributes:
        return [finding_of(plain) for plain in json.loads(attributes[DATA])]
    texts = attributes.get(TEXTS, [])
    findings = []
    for text in [texts] if isinstance(texts, str) else texts:
        severity, _, rest = str(text).partition(": ")
        place, _, message = rest.partition(": ")
        if severity in get_args(Severity) and message:
            findings.append(Finding(place, severity, message))  # type: ignore[arg-type]
    return findings


def not_drawn(place: str, error: Exception) -> Finding:
    """Make the finding for a figure or page that could not be drawn; the computed results are not affected."""
    if isinstance(error, JounceError):
        return finding("core.not_drawn", place, error=Clause(error.message()))
    text = f"{type(error).__name__}: {shorten(str(error), 300)}"
    return finding("core.not_drawn", place, error=Clause(text))


class DrawingError(OutputError):
    """Figures or pages that could not be drawn; the computed results are written anyway.

    Parameters
    ----------
    findings : iterable of Finding
        One problem for each missing figure or page, with the reason.
    """

    def __init__(self, findings: Iterable[Finding]) -> None:
        self.findings = tuple(findings)
        super().__init__(
            "; ".join(item.message.rstrip(".") for item in self.findings),
            where=self.findings[0].place,
        )
