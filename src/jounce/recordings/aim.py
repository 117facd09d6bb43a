"""Text above the tables that AiM Race Studio exports: names of driver, car and track, and lap markers.

It consists of pairs ``"Venue","Monza"``, one of which lists the instants (s) at which the car passed the beacon.
"""

from __future__ import annotations

import csv
import re
from pathlib import Path

from jounce.core.findings import Finding, finding
from jounce.recordings.laps import beacon_attributes

_AIM = "aim csv file"
_MOST_LINES, _LONGEST_LINE = 60, 100_000
_BEACONS = "beacon markers"
_NO_WORD = re.compile(r"\W+")
_LEFT_OUT = ("format", "segment times", "data source")


def preamble(text: str, path: Path) -> tuple[dict[str, object], list[Finding]]:
    r"""Return texts and lap markers above a table of AiM, nothing for other tables; unreadable markers are a finding.

    >>> head = '"Format","AIM CSV File"\n"Venue","Monza"\n"Beacon Markers","95.3","190.6"\n\n"Time","RPM"\n'
    >>> preamble(head, Path("outing.csv"))
    ({'venue': 'Monza', 'beacons': array([ 95.3, 190.6])}, [])
    """
    head = text[:200].lower()
    if not head.replace('"', "").startswith(("format,", "format;")) or _AIM not in head:
        return {}, []
    lines = []
    for line in text[:_LONGEST_LINE].splitlines()[:_MOST_LINES]:
        if not line.strip(' ",;'):
            break
        lines.append(line)
    separator = ";" if head.replace('"', "").startswith("format;") else ","
    attributes: dict[str, object] = {}
    findings: list[Finding] = []
    for key, *cells in csv.reader(lines, delimiter=separator):
        name = key.strip().lower()
        values = [word for cell in cells for word in cell.split()]
        if name == _BEACONS:
            try:
                markers = [(float(word.replace(",", ".")), "") for word in values]
            except ValueError as error:
                findings.append(finding("recordings.no_beacons", str(path), reason=str(error)))
            else:
                attributes |= beacon_attributes(markers)
        elif name and values and name not in _LEFT_OUT:
            attributes.setdefault(_NO_WORD.sub("_", name), " ".join(values)[:200])
    return attributes, findings
