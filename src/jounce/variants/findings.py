"""Findings of many runs, each once, with the number of variants concerned."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from typing import Any

from jounce.core.findings import DATA, Finding, finding, finding_attributes, findings_of

COUNTS = "finding_variants"
"""Attribute of the results of a sweep: number of variants with each of its findings."""
_NUMBER = re.compile(r"(?<![\w.\[])\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w\]])")


class Tally:
    """Counts findings; those that differ only in numbers are combined under the first one."""

    def __init__(self) -> None:
        self._found: dict[tuple[str, ...], tuple[Finding, int]] = {}

    def add(self, findings: Iterable[Finding]) -> None:
        """Add the findings of one variant."""
        for item in {_kind(item): item for item in findings}.values():
            self._count(item, 1)

    def merge(self, attributes: Mapping[str, Any]) -> None:
        """Add the findings in the attributes of other results."""
        plain = {
            name: _as_list(attributes[name]) for name in ("findings", COUNTS) if name in attributes
        }
        items = findings_of(
            plain | {name: attributes[name] for name in (DATA,) if name in attributes}
        )
        for item, count in zip(items, plain.get(COUNTS, []), strict=True):
            self._count(item, count)

    def _count(self, item: Finding, count: int) -> None:
        first, before = self._found.get(_kind(item), (item, 0))
        self._found[_kind(item)] = first, before + count

    def attributes(self) -> dict[str, Any]:
        """Return the findings as attributes; empty without findings."""
        if not self._found:
            return {}
        return {
            **finding_attributes(item for item, _ in self._found.values()),
            COUNTS: [count for _, count in self._found.values()],
        }

    def findings(self, ran: int) -> list[Finding]:
        """Return the findings, each with the number of variants that had it, of those that ``ran``."""
        return [
            finding(
                "variants.of_many",
                item.place,
                count,
                severity=item.severity,
                count=count,
                ran=ran,
                found=item,
            )
            for item, count in self._found.values()
        ]


def _as_list(value: Any) -> list[Any]:
    """Read an attribute that is a list; files keep it as JSON."""
    return list(json.loads(value) if isinstance(value, str) else value)


def _kind(item: Finding) -> tuple[str, ...]:
    """Return a key shared by findings that differ only in numbers; names must be equal.

    >>> _kind(Finding("a2.fmu: F[1]", "warning", "of 0.52 J of its work 1.2e-05 J (3 %)"))
    ('a2.fmu: F[1]', 'warning', 'of # J of its work # J (# %)')
    """
    if not item.code:  # of a controller in Python, or of an older version
        return item.place, item.severity, _NUMBER.sub("#", item.message)
    return (
        item.place,
        item.severity,
        item.code,
        *(str(word) for word in item.numbers.values() if isinstance(word, str)),
    )


def findings_of_variants(attributes: Mapping[str, Any], ran: int) -> list[Finding]:
    """Return the findings in the attributes of a sweep's results, each with the number of variants that had it."""
    tally = Tally()
    tally.merge(attributes)
    return tally.findings(ran)
