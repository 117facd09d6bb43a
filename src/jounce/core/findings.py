"""Findings: advice as data, never a print."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, Literal, get_args

from jounce.core.errors import JounceError, OutputError
from jounce.core.shown import Shown
from jounce.core.text import shortened

Severity = Literal["note", "warning", "problem"]


@dataclass(frozen=True)
class Finding(Shown):
    """One thing the reader of a result must know.

    Attributes
    ----------
    place : str
        File, path, channel or trial the finding is about.
    severity : {"note", "warning", "problem"}
        ``note``: good to know; ``warning``: weakens a result; ``problem``: a result is missing or not to be trusted.
    message : str
        One sentence that says what was found and what to do.
    value : float or None
        The number behind it, SI, where there is one.
    """

    place: str
    severity: Severity
    message: str
    value: float | None = None

    def __str__(self) -> str:
        return f"{self.severity}: {self.place}: {self.message}"


def findings_of(attributes: Mapping[str, Any]) -> list[Finding]:
    """Findings that a recording carries as texts in its attribute ``findings``.

    >>> [str(one) for one in findings_of({"findings": ["note: a.fmu: v: it has no unit: taken for m/s."]})]
    ['note: a.fmu: v: it has no unit: taken for m/s.']
    """
    told = attributes.get("findings", [])
    found = []
    for text in [told] if isinstance(told, str) else told:
        severity, _, rest = str(text).partition(": ")
        place, _, message = rest.partition(": ")
        if severity in get_args(Severity) and message:
            found.append(Finding(place, severity, message))  # type: ignore[arg-type]
    return found


def not_drawn(place: str, error: Exception) -> Finding:
    """A problem with drawing, which is one of a picture or a page and never of what was computed."""
    text = str(error) if isinstance(error, JounceError) else f"{type(error).__name__}: {shortened(str(error), 300)}"
    return Finding(place, "problem", f"could not be drawn: {text.rstrip('.')}. What was computed is whole.")


class DrawingError(OutputError):
    """Pictures or pages that could not be drawn; what was computed is written all the same.

    Parameters
    ----------
    findings : iterable of Finding
        What is missing, and why: one problem each.
    """

    def __init__(self, findings: Iterable[Finding]) -> None:
        self.findings = tuple(findings)
        super().__init__("; ".join(one.message.rstrip(".") for one in self.findings), where=self.findings[0].place)
