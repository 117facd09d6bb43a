"""Findings of an evaluation as data: a code with its numbers, said in English and German."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from jounce.core.findings import Finding, Severity
from jounce.inspection.remark_sentences import GERMAN_WORDS, SENTENCES
from jounce.inspection.verdicts.quantities import Language


@dataclass(frozen=True)
class Remark(Finding):
    """A finding whose sentence is known in both languages.

    Attributes
    ----------
    place, severity, message, value
        As of every `Finding`; the message is English.
    code : str
        Which sentence of ``SENTENCES``.
    words : mapping
        What stands in it: numbers in the unit that the sentence names, and names.
    """

    code: str = ""
    words: Mapping[str, Any] = field(default_factory=dict)


def remark(place: str, severity: Severity, code: str, value: float | None = None, /, **words: Any) -> Remark:
    """Make a finding of a code; its message is English.

    Examples
    --------
    >>> found = remark("left.tyre", "warning", "load_off", 1.03, load=4e3, measured=4120.5, percent=3.01)
    >>> found.message
    'the header gives 4000 N, the plate carries 4120 N on average: +3.0 %, allowed are 2 %.'
    >>> said(found, "de")
    'Der Kopf nennt 4000 N, die Platte trägt im Mittel 4120 N: +3,0 %, zulässig sind 2 %.'
    """
    return Remark(place, severity, _sentence(code, words, "en"), value, code, words)


_OF_READER = {
    "the channel is constant": "reading_constant",
    "the channel looks clipped": "reading_clipped",
    "the time step varies": "reading_resampled",
    "columns that are no known channel": "reading_columns",
    "signals of another length": "reading_columns",
}


def of_reader(finding: Finding) -> Finding:
    """Give a finding of the file's reader its code; one that has a code, or that is not known, is given as it is."""
    code = next((code for begin, code in _OF_READER.items() if finding.message.startswith(begin)), None)
    if code is None or isinstance(finding, Remark):
        return finding
    value = finding.value if finding.value is not None else 0.0
    words = {"text": finding.message, "value": value, "percent": 100.0 * value}
    return Remark(finding.place, finding.severity, finding.message, finding.value, code, words)


def of_plain(table: Mapping[str, Any]) -> Finding:
    """Give a finding back from its plain table, with its code where it has one that is known.

    Examples
    --------
    >>> found = remark("left", "note", "plate_still")
    >>> of_plain(found.__dict__) == found, of_plain({"place": "a", "severity": "note", "message": "b", "value": None})
    (True, Finding(place='a', severity='note', message='b', value=None))
    """
    known = {name: table[name] for name in ("place", "severity", "message", "value")}
    if table.get("code") not in SENTENCES:
        return Finding(**known)
    return Remark(**known, code=str(table["code"]), words=dict(table.get("words", {})))


def said(finding: Finding, language: Language = "en") -> str:
    """Give a finding's sentence in a language; the English one where it has no code."""
    if language == "en" or not isinstance(finding, Remark):
        return finding.message
    return _sentence(finding.code, finding.words, language)


def _sentence(code: str, words: Mapping[str, Any], language: Language) -> str:
    shown = {name: _german(value) for name, value in words.items()} if language == "de" else words
    return SENTENCES[code][language].format(**shown)


def _german(value: Any) -> Any:
    if isinstance(value, float):
        return _German(value)
    if isinstance(value, str):
        return ", ".join(GERMAN_WORDS.get(part, part) for part in value.split(", "))
    return value


class _German(float):
    """A number that is written with a comma."""

    def __format__(self, spec: str) -> str:
        return super().__format__(spec).replace(".", ",")
