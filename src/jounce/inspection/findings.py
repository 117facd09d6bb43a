"""Findings of an evaluation: rows of this package's ``findings.toml``, with codes without a package prefix."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from jounce.core.catalogue import Severity, sentence
from jounce.core.findings import Finding, finding_of
from jounce.inspection.quantities import Language


@dataclass(frozen=True)
class Remark(Finding):
    """A finding of an evaluation; archives and ``--json`` also store its numbers as ``words``.

    Attributes
    ----------
    place, severity, message, value, numbers
        As in `Finding`; the message is in English.
    code : str
        Key in this package's ``findings.toml``.
    words : mapping
        Values in the message: names, and numbers in the unit of the sentence.
    """

    words: Mapping[str, Any] = field(default_factory=dict)


def remark(
    place: str, severity: Severity, code: str, value: float | None = None, /, **words: Any
) -> Remark:
    """Create a finding from a code, with an English message.

    Examples
    --------
    >>> found = remark("left.tyre", "warning", "load_off", 1.03, load=4e3, measured=4120.5, percent=3.01)
    >>> found.message
    'the header gives 4000 N, but the plate carries 4120 N on average: +3.0 %, but only 2 % is allowed.'
    >>> sentence_of(found, "de")
    'Der Kopf nennt 4000 N, die Platte trägt im Mittel 4120 N: +3,0 %, zulässig sind 2 %.'
    """
    return Remark(place, severity, sentence(code, words), value, code, words, words)


def problem(place: str, code: str, value: float | None = None, /, **words: Any) -> Finding:
    """Create a finding that makes a record unusable; ``code`` and ``words`` as in `remark`."""
    return remark(place, "problem", code, value, **words)


def warning(place: str, code: str, value: float | None = None, /, **words: Any) -> Finding:
    """Create a finding that makes a value less reliable; ``code`` and ``words`` as in `remark`."""
    return remark(place, "warning", code, value, **words)


def of_plain(table: Mapping[str, Any]) -> Finding:
    """Restore a finding from a plain table, with its code if known.

    Examples
    --------
    >>> found = remark("left", "note", "plate_still")
    >>> of_plain(found.__dict__) == found, of_plain({"place": "a", "severity": "note", "message": "b", "value": None})
    (True, Finding(place='a', severity='note', message='b', value=None))
    """
    plain = finding_of({"numbers": table.get("words", {}), **table})
    return Remark(**vars(plain), words=plain.numbers) if "words" in table else plain


def sentence_of(finding: Finding, language: Language = "en") -> str:
    """Return a finding's sentence in a language, with German decimal commas; the English message if it has no code."""
    return finding.sentence(language, decimal="," if language == "de" else ".")
