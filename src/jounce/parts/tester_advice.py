"""What is legal in a tester file and yet looks wrong."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from jounce.core.errors import nearest
from jounce.core.findings import Finding, Severity
from jounce.parts.testers import Tester

CHANNELS = tuple(f"{side}.plate.{name}" for side in Tester.sides for name in ("z", "force", "frequency"))
"""Channels of a record that a tester's ``columns`` may name, besides ``time``."""


def findings_of_tester(tester: Tester, where: str = "") -> list[Finding]:
    """List what a careful colleague would ask about a tester.

    Parameters
    ----------
    tester : Tester
        Any tester.
    where : str
        File it comes from; named before the path of every finding.

    Returns
    -------
    list of Finding
        Empty when nothing looks wrong.

    Examples
    --------
    >>> from jounce.parts.testers import load_tester
    >>> tester = load_tester("egea-specsus2018")
    >>> findings_of_tester(tester)
    []
    >>> [str(finding) for finding in findings_of_tester(tester.with_changes({"sampling_frequency": "500 Hz"}))]
    ['warning: sampling_frequency: 500 Hz is less than its own limits.sampling_frequency_min, 1000 Hz.']
    """
    start = f"{where}: " if where else ""
    found = [*_estimated(tester), *_columns(tester), *_programme(tester)]
    return [Finding(f"{start}{place}", severity, text) for place, severity, text in found]


_Found = tuple[str, Severity, str]


def _estimated(tester: Tester) -> Iterator[_Found]:
    known = set(_paths(tester.model_dump(by_alias=True)))
    for entry in tester.estimated:
        if entry not in known:
            hint = nearest(entry, known)
            yield "estimated", "note", f"{entry!r} names no number and no part of this tester. {hint}".rstrip()


def _paths(table: dict[str, Any], before: str = "") -> Iterator[str]:
    for key, value in table.items():
        yield f"{before}{key}"
        if isinstance(value, dict):
            yield from _paths(value, f"{before}{key}.")


def _columns(tester: Tester) -> Iterator[_Found]:
    for name in tester.columns:
        hint = nearest(name, CHANNELS)
        if name not in (*CHANNELS, "time"):
            severity: Severity = "warning" if hint else "note"
            yield f"columns.{name}", severity, f"no channel that an evaluation uses. {hint}".rstrip()


def _programme(tester: Tester) -> Iterator[_Found]:
    programme, limits = tester.programme, tester.limits
    if tester.sampling_frequency < limits.sampling_frequency_min:
        text = f"{tester.sampling_frequency:g} Hz is less than its own limits.sampling_frequency_min, "
        yield "sampling_frequency", "warning", f"{text}{limits.sampling_frequency_min:g} Hz."
    if programme.run_down == "controlled" and programme.sweep_rate > limits.sweep_rate_max:
        text = f"{programme.sweep_rate:g} Hz/s is more than its own limits.sweep_rate_max, "
        yield "programme.sweep_rate", "warning", f"{text}{limits.sweep_rate_max:g} Hz/s."
    low, high = sorted((programme.start_frequency, programme.end_frequency))
    if tester.method == "egea" and not low <= limits.frequency_min < limits.frequency_max <= high:
        text = f"the exciter goes from {high:g} to {low:g} Hz, the least phase angle is searched for"
        yield "programme", "warning", f"{text} between {limits.frequency_min:g} and {limits.frequency_max:g} Hz."
