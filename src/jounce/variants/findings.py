"""Findings of many runs, each once, with the number of variants that have it."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from typing import Any

from jounce.core.findings import Finding, findings_of

TEXTS, COUNTS = "findings", "finding_variants"
"""Attributes of the results of a sweep: texts of one variant each, and how many variants had it."""
_NUMBER = re.compile(r"(?<![\w.\[])\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w\]])")


class Tally:
    """Counts findings that differ only in their numbers as one, under the first of their texts."""

    def __init__(self) -> None:
        self._found: dict[str, tuple[str, int]] = {}

    def add(self, texts: Iterable[str]) -> None:
        """Add what was found of one variant."""
        for kind, text in {_kind(text): text for text in texts}.items():
            self._count(kind, text, 1)

    def merge(self, attributes: Mapping[str, Any]) -> None:
        """Add what the attributes of other results say."""
        texts, counts = (_listed(attributes.get(name, [])) for name in (TEXTS, COUNTS))
        for text, count in zip(texts, counts, strict=True):
            self._count(_kind(text), text, count)

    def _count(self, kind: str, text: str, count: int) -> None:
        first, before = self._found.get(kind, (text, 0))
        self._found[kind] = first, before + count

    def attributes(self) -> dict[str, Any]:
        """Return the attributes; none without findings."""
        if not self._found:
            return {}
        texts, counts = zip(*self._found.values(), strict=True)
        return {TEXTS: list(texts), COUNTS: list(counts)}


def _listed(value: Any) -> list[Any]:
    """An attribute that is a list; files keep it as JSON."""
    return list(json.loads(value) if isinstance(value, str) else value)


def _kind(text: str) -> str:
    """A text without its numbers; those of names stay.

    >>> _kind("warning: a2.fmu: F[1]: of 0.52 J of its work 1.2e-05 J (3 %)")
    'warning: a2.fmu: F[1]: of # J of its work # J (# %)'
    """
    return _NUMBER.sub("#", text)


def findings_of_variants(attributes: Mapping[str, Any], ran: int) -> list[Finding]:
    """Findings of the attributes of a sweep's results, each with the number of variants that had it."""
    tally = Tally()
    tally.merge(attributes)
    told = tally.attributes()
    return [
        Finding(one.place, one.severity, f"{count} of {ran} variants: {one.message}", float(count))
        for text, count in zip(told.get(TEXTS, []), told.get(COUNTS, []), strict=True)
        for one in findings_of({TEXTS: text})
    ]
