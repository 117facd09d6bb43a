"""Count the results of each command for faulty records with known values, for what-no-file-can-tell.md.

``python docs/make_records.py`` counts them (a quarter of an hour on one core) and stores the counts, and the names of
silently wrong records, in ``explanation/wrong-records.json``; with names of commands it counts only these.
"""

from __future__ import annotations

import json
import re
import sys
import tempfile
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from itertools import chain
from pathlib import Path

import foreign_records
import foreign_testers
import identification_variants
import ride_variants
from foreign_records import HIDDEN
from foreign_testers import TesterRecord

from jounce.core.errors import JounceError
from jounce.inspection import evaluate
from jounce.inspection.record import read_record
from jounce.parts.testers import load_tester

FILE = Path(__file__).parent / "explanation" / "wrong-records.json"
VERDICTS = ("right", "told", "refused", "hidden", "silent", "false alarm")
Verdicts = Iterator[tuple[str, str, str]]
"""What was done to a record, its name and what became of it: one of `VERDICTS`."""


def judged_test(record: TesterRecord) -> str:
    """Whether an inspection's values are right, reported with the cause, refused, or silently wrong."""
    tester = load_tester(record.tester)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "lane.csv"
        file.write_text(record.text(), encoding="utf-8")
        try:
            run, notes = read_record(file, tester)
            found = evaluate(run, tester)
        except JounceError:
            return "refused"
    said = [*notes, *found.findings, *chain.from_iterable(wheel.findings for wheel in found.wheels)]
    loud = [
        one.code for one in said if one.code and (one.severity != "note" or "order" in one.code)
    ]
    names = [bool(record.about) and re.search(record.about, code) is not None for code in loud]
    values = [
        (found.wheel(side).value(key), true, record.within[key])
        for side, truth in record.truth.items()
        for key, true in truth.items()
    ]
    given = [(value, true, within) for value, true, within in values if value is not None]
    if not given:
        return "refused" if any(names) else "false alarm"
    if all(abs(value - true) <= within for value, true, within in given):
        return "false alarm" if loud and not record.about else "right"
    return "told" if any(names) else "hidden" if HIDDEN in record.about else "silent"


def _of_files(
    records: Callable[[], Iterable[foreign_records.Record]], fit: Callable[..., object]
) -> Verdicts:
    for one in records():
        yield one.group, one.name, identification_variants.judged(one, fit)  # type: ignore[arg-type]


def _of_tests() -> Verdicts:
    for one in foreign_testers.testers():
        yield one.group, one.name, judged_test(one)


def _of_rides() -> Verdicts:
    for kind, found in ride_variants.outcomes().items():
        for verdict, names in found.items():
            wrong = "hidden" if kind in ride_variants.HIDDEN else "silent"
            yield from (
                (kind, name, wrong if verdict == "silently wrong" else verdict) for name in names
            )


COMMANDS: dict[str, Callable[[], Verdicts]] = {
    "fit damper": lambda: _of_files(foreign_records.dampers, identification_variants._fit_damper),
    "fit stiffness": lambda: _of_files(
        foreign_records.springs, identification_variants._fit_spring
    ),
    "fit decay": lambda: _of_files(foreign_records.decays, identification_variants._fit_decay),
    "ride": _of_rides,
    "inspect": _of_tests,
}


def counted(verdicts: Verdicts) -> dict[str, object]:
    """Counts of the verdicts, and names of silently wrong records and false alarms."""
    kept = list(verdicts)
    counts = Counter(verdict for _, _, verdict in kept)
    names = [
        f"{verdict}: {group}, {name}"
        for group, name, verdict in kept
        if verdict in ("silent", "false alarm")
    ]
    return {"counts": {one: counts[one] for one in VERDICTS}, "names": names}


def table() -> str:
    """Counts of each command."""
    lines = [
        "| command | files | right | reported | refused | undetectable | silently wrong |",
        "|---" + "|---:" * 6 + "|",
    ]
    for command, found in json.loads(FILE.read_text(encoding="utf-8")).items():
        counts = found["counts"]
        numbers = [
            sum(counts.values()),
            *(counts[one] for one in VERDICTS[:4]),
            counts["silent"] + counts["false alarm"],
        ]
        lines.append(f"| `jounce {command}` | {' | '.join(map(str, numbers))} |")
    return "\n".join(lines) + "\n"


def write(folder: Path) -> None:
    """Write the table as a page to include."""
    folder.mkdir(exist_ok=True)
    (folder / "wrong-records.md").write_text(table(), encoding="utf-8")


if __name__ == "__main__":
    kept = json.loads(FILE.read_text(encoding="utf-8")) if FILE.is_file() else {}
    for command in sys.argv[1:] or COMMANDS:
        sys.stderr.write(f"{command}\n")
        kept[command] = counted(COMMANDS[command]())
        ordered = {one: kept[one] for one in COMMANDS if one in kept}
        FILE.write_text(json.dumps(ordered, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
