"""Text above the tables that race loggers export: names of driver, car and track, and lap markers.

AiM Race Studio writes pairs ``"Venue","Monza"`` above the names of the columns, and with them the instants (s) at which
the car passed the beacon. Tables of Race Technology have only names and units of columns, which every table may have.
"""

from __future__ import annotations

import csv
import re

from jounce.recordings.laps import beacon_attributes

_AIM = "aim csv file"
_MOST_LINES, _LONGEST_LINE = 60, 100_000
_BEACONS = "beacon markers"
_NO_WORD = re.compile(r"\W+")
_LEFT_OUT = ("format", "segment times", "data source")


def preamble(text: str) -> dict[str, object]:
    r"""Return texts and lap markers above a table of AiM; nothing for other tables.

    >>> preamble('"Format","AIM CSV File"\n"Venue","Monza"\n"Beacon Markers","95.3","190.6"\n\n"Time","RPM"\n')
    {'venue': 'Monza', 'beacons': array([ 95.3, 190.6])}
    """
    head = text[:200].lower()
    if not head.replace('"', "").startswith(("format,", "format;")) or _AIM not in head:
        return {}
    lines = []
    for line in text[:_LONGEST_LINE].splitlines()[:_MOST_LINES]:
        if not line.strip(' ",;'):
            break
        lines.append(line)
    separator = ";" if head.replace('"', "").startswith("format;") else ","
    attributes: dict[str, object] = {}
    for key, *cells in csv.reader(lines, delimiter=separator):
        name = key.strip().lower()
        values = [word for cell in cells for word in cell.split()]
        if name == _BEACONS:
            markers = [(float(word), "") for word in values if _is_number(word)]
            attributes |= beacon_attributes(markers)
        elif name and values and name not in _LEFT_OUT:
            attributes.setdefault(_NO_WORD.sub("_", name), " ".join(values)[:200])
    return attributes


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return "_" not in word
