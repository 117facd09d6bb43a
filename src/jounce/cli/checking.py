"""What each kind of file must satisfy; every problem is collected, none hides another."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from jounce.core.errors import DescriptionError, JounceError, RecordingError, unknown

_OTHER_COLUMNS = ("no column", "no channel")  # what readers say of a file of another kind
_TOML_KINDS = {
    "jounce.rig/1": "rig",
    "jounce.vehicle/1": "vehicle",
    "jounce.campaign/1": "campaign",
    "jounce.road/1": "road",
    "jounce.control/1": "control",
    "jounce.tester/1": "tester",
    "jounce.limits/1": "limits",
}


@dataclass
class Checked:
    """Outcome for one file: what it is, in words, everything wrong with it, and the numbers that ``--set`` changes."""

    file: Path
    kind: str = "unknown"
    what: str = ""
    problems: list[str] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    parameters: dict[str, dict[str, float | str]] = field(default_factory=dict)

    @contextmanager
    def step(self) -> Iterator[None]:
        """Note the error of one step and let the next one run."""
        try:
            yield
        except JounceError as error:
            self.problems.append(str(error))
        except OSError as error:
            self.problems.append(f"{error.filename or self.file}: {error.strerror or error}.")


def check_file(file: Path) -> Checked:
    """Check one file by what it is: a description (TOML), the header of a record, a road, a table or a recording."""
    checked = Checked(file)
    with checked.step():
        checks: dict[str, Callable[[Checked], None]] = {".toml": _toml, ".crg": _road}
        checks.get(file.suffix.lower(), _measured)(checked)
    return checked


def _toml(checked: Checked) -> None:
    from jounce.core.description import read_toml

    table, text = read_toml(checked.file)
    if "schema" not in table and _is_header(table):
        _header(checked, table, text)
        return
    schema = table.get("schema", "jounce.road/1" if "kind" in table else None)
    checked.kind = _TOML_KINDS.get(str(schema), "unknown")
    if checked.kind == "unknown":
        if schema is None:
            raise DescriptionError(
                "the schema line is missing", where=str(checked.file), allowed=", ".join(_TOML_KINDS)
            )
        raise unknown(str(schema), _TOML_KINDS, what="schema", where=str(checked.file))
    _CHECKS[checked.kind](checked)


def _rig(checked: Checked) -> None:
    from jounce.parts import load, rig_findings

    rig = load(checked.file)
    checked.what = f"{getattr(rig, 'model', 'rig')} with {len(rig.parameters())} parameters"
    checked.parameters = _parameters(rig)
    checked.notes += map(str, rig_findings(rig, str(checked.file)))


def _parameters(description: Any) -> dict[str, dict[str, float | str]]:
    """Every number of a description by its path, SI, with its unit."""
    from jounce.parts.rig import parameters_of, unit_of

    found = parameters_of(description)
    return {path: {"value": value, "unit": unit_of(description, path)} for path, value in found.items()}


def _road(checked: Checked) -> None:
    from jounce.roads import load_road

    checked.kind = "road"
    road = load_road(checked.file)
    checked.what = f"{getattr(road, 'kind', 'road')}, ends at {road.end():g} m"


def _control(checked: Checked) -> None:
    from jounce.control import controller

    found = controller(checked.file)
    checked.what = str(getattr(found, "law", type(found).__name__))


def _tester(checked: Checked) -> None:
    from jounce.parts.testers import findings_of_tester, load_tester

    tester = load_tester(checked.file)
    checked.what = f"{tester.name}: {tester.kind}, evaluated by {tester.method}"
    checked.parameters = _parameters(tester)
    checked.notes += map(str, findings_of_tester(tester, str(checked.file)))


def _limits(checked: Checked) -> None:
    from jounce.inspection.limits import load_limits

    limits = load_limits(checked.file)
    further = [*limits.conditions, *(f"difference of {name}" for name in limits.differences)]
    checked.what = f"{limits.label}: {', '.join([*limits.methods, *further])}"


def _is_header(table: dict[str, Any]) -> bool:
    """Whether a file says anything that stands in the header of a tester's record."""
    from jounce.inspection.record import NUMBERS, SIDES, TEXTS, flat_facts

    known = {*TEXTS, *(f"{side}.{name}" for side in SIDES for name in NUMBERS)}
    return not known.isdisjoint(flat_facts(table))


def _header(checked: Checked, table: dict[str, Any], text: str) -> None:
    """Facts about the car in the file beside a record; each mistake is said with its line."""
    from jounce.core.description import line_of
    from jounce.inspection.record import flat_facts, read_facts

    checked.kind, facts = "header of a record", flat_facts(table)
    checked.what = ", ".join(facts)
    for key, value in facts.items():
        line = line_of(text, tuple(key.split("."))) or line_of(text, (key,))
        with checked.step():
            _, findings = read_facts({key: value}, where=f"{checked.file}, line {line}")
            checked.notes += map(str, findings)


def _measured(checked: Checked) -> None:
    """A recording, a force-deflection trial or a road table: the first whose columns the file has."""
    missing: list[JounceError] = []
    for kind, read in (("recording", _recording), ("force-deflection trial", _trial), ("road table", _road_table)):
        checked.kind = kind
        try:
            read(checked)
        except RecordingError as error:
            if not error.what.startswith(_OTHER_COLUMNS):
                raise
            missing.append(error)
        else:
            return
    checked.kind = "unknown"
    raise missing[0]


def _recording(checked: Checked) -> None:
    from jounce.recordings import read_recording

    data, findings = read_recording(checked.file)
    if any(str(name).endswith(".plate.force") for name in data.data_vars):
        from jounce.inspection.record import read_record

        checked.kind = "record of a tester"
        data, findings = read_record(checked.file)
    time = data["time"].to_numpy()
    checked.what = f"{', '.join(map(str, data.data_vars))}; {len(time)} samples, {time[-1] - time[0]:g} s"
    checked.notes += map(str, findings)


def _trial(checked: Checked) -> None:
    _table(checked, {"displacement": "m", "force": "N"})


def _road_table(checked: Checked) -> None:
    _table(checked, {"x": "m", "z": "m"})


def _table(checked: Checked, wanted: dict[str, str]) -> None:
    from jounce.recordings import read_columns

    values, findings = read_columns(checked.file, wanted)
    checked.what = f"{len(next(iter(values.values())))} rows"
    checked.notes += map(str, findings)


def _campaign(checked: Checked) -> None:
    """The campaign, its rig and roads, and every file of bench and trials."""
    from jounce.campaign import load_campaign
    from jounce.campaign.run import check_strut_angles
    from jounce.parts import load, rig_path
    from jounce.roads import read_roads

    campaign, text = load_campaign(checked.file)
    folder, where = checked.file.parent, str(checked.file)
    checked.what = f"{len(campaign.trial)} trials, {len(campaign.update)} updates"
    with checked.step():
        rig = load(folder / campaign.rig if campaign.rig.endswith(".toml") else rig_path(campaign.rig))
        check_strut_angles(campaign, rig, checked.file)
    roads: dict[str, Any] = dict.fromkeys(campaign.roads)
    with checked.step():
        roads = dict(read_roads(campaign.roads, where=where, text=text, folder=folder))
    for entry in campaign.trial:
        place = f"{where}: trial {entry.number}"
        if entry.road is not None and entry.road not in roads:
            checked.problems.append(str(unknown(entry.road, roads, what="road", where=place)))
        with checked.step():
            _recording_of(folder / entry.recording, entry.columns, place)
        if entry.excitation is not None:
            with checked.step():
                from jounce.roads import Excitation

                Excitation(file=folder / entry.excitation)
    _bench(checked, campaign.bench, folder)


def _recording_of(file: Path, columns: dict[str, str], place: str) -> None:
    from jounce.recordings import read_recording

    try:
        read_recording(file, columns=columns or None)
    except JounceError as error:
        raise RecordingError(f"{place}: {error}") from None


def _bench(checked: Checked, bench: Any, folder: Path) -> None:
    from jounce.campaign.characterise import files_of, read_force_deflection
    from jounce.recordings import read_recording

    tables = {"bench.spring": bench.spring, **{f'bench.tyre."{name}"': item for name, item in bench.tyre.items()}}
    for name, table in tables.items():
        if table is not None:
            with checked.step():
                read_force_deflection(files_of(table.files, folder, f"{checked.file}: {name}"), table.columns)
    if bench.decay is not None:
        with checked.step():
            for file in files_of(bench.decay.files, folder, f"{checked.file}: bench.decay"):
                read_recording(file, columns=bench.decay.columns or None)


_CHECKS: dict[str, Callable[[Checked], None]] = {
    "rig": _rig,
    "vehicle": _rig,
    "road": _road,
    "campaign": _campaign,
    "control": _control,
    "tester": _tester,
    "limits": _limits,
}
