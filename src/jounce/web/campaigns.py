"""Campaigns for the page: measurements, planned updates, and adding measured files."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import tomlkit
from pydantic import BaseModel, ConfigDict, Field

from jounce.core.errors import DescriptionError, JounceError, OutputError
from jounce.core.files import only_below
from jounce.core.units import to_si
from jounce.web.project import Project, Text

if TYPE_CHECKING:
    from jounce.campaign.laboratory import TrialRow

_READ = ("columns", "variable", "sample_time", "stroke_positive", "force_positive")
_OWN_RIG = "rig.toml"  # beside a new campaign
_MOST_FILES = 500  # of one bench table; also those of a request to enter files
"""Keys that define how all files of a table are read."""
Use = Literal["spring", "tyre", "decay", "trial"]


def overview(project: Project, path: str) -> dict[str, Any]:
    """Return the contents of a campaign as in its file, with the files that match its patterns."""
    from jounce.campaign.description import load_campaign

    file = project.inside(path)
    with only_below(project.root):
        campaign, text = load_campaign(file)
    plain = tomlkit.parse(text).unwrap()
    folder = file.parent
    bench = plain.get("bench", {})
    tables = {"spring": bench.get("spring"), "decay": bench.get("decay")}
    tables |= {f"tyre at {pressure}": table for pressure, table in bench.get("tyre", {}).items()}
    return {
        "title": campaign.title,
        "synthetic": campaign.synthetic,
        "rig": campaign.rig,
        "roads": list(campaign.roads),
        "mass": _mass(project, campaign.rig, file),
        "bench": [
            {
                "name": name,
                **table,
                "found": _matching_files(project, folder, table.get("files", [])),
            }
            for name, table in tables.items()
            if table
        ],
        "trials": [_place(project, folder, trial) for trial in plain.get("trial", [])],
        "updates": plain.get("update", []),
    }


def title_of(project: Project, path: str) -> str:
    """Return the title of a campaign, or its file name if it is unreadable, which the job then reports."""
    try:
        title = tomlkit.parse(project.read(path).text).get("title", "")
    except (DescriptionError, tomlkit.exceptions.TOMLKitError):
        return path
    return title if isinstance(title, str) and title else path


class OwnRig(BaseModel):
    """A rig with the laboratory's own values, with units, by path."""

    model_config = ConfigDict(extra="forbid")
    rig: str
    changes: dict[str, str] = Field(default_factory=dict, max_length=200)


class NewCampaign(OwnRig):
    """A campaign to be written: its rig, its obstacle, and the trains of that obstacle by name.

    With ``changes``, the rig is written beside the campaign with these values.
    """

    title: str = "Bench campaign"
    obstacle: dict[str, str]
    roads: dict[str, dict[str, Any]] = {}


class FileEntry(BaseModel):
    """A measured file for a campaign: its role, the keys of its table, and the state of the file that was shown."""

    model_config = ConfigDict(extra="forbid")
    use: Use
    fields: dict[str, Any]
    file: str = ""
    state: str = ""


def enter_file(project: Project, path: str, use: Use, fields: Mapping[str, Any]) -> dict[str, Any]:
    """Add a measured file to a campaign, as a bench table or a new trial. Comments of the file are kept.

    The change is not written if it would make the campaign invalid.
    """
    was = project.read(path)
    text = _checked(project, path, was.text, FileEntry(use=use, fields=dict(fields)))
    return _written(project, path, text, was)


def enter_files(
    project: Project, path: str, entries: Sequence[FileEntry], new: NewCampaign | None = None
) -> dict[str, Any]:
    """Add measured files to a campaign, or to a new one; a file that does not fit does not stop the others.

    Returns the written text as `enter_file` does, the ``entered`` files, and the ``refused`` ones with the reason.
    Without ``use``, trials that cover the range of speeds are fitted, if the campaign fits none yet.
    """
    was = Text(path, _filled(project, path, new), "") if new else project.read(path)
    if new and project.inside(path).exists():
        raise OutputError("the file already exists", where=path, hint="Choose another name.")
    text, entered, refused = was.text, list[str](), list[dict[str, Any]]()
    own = _own_text(project, path, new) if new and new.changes else None
    ordered = sorted(entries, key=lambda entry: entry.use != "trial")  # a campaign needs one
    at_once = _all_checked(project, path, text, ordered)
    for entry in ordered:
        try:
            if at_once is None:
                _check_state(project, entry)
                text = _checked(project, path, text, entry)
            entered.append(entry.file)
        except JounceError as error:
            message = error.message()
            refused.append({"file": entry.file, "message": message, "german": message.german()})
    if not entered:
        return {"path": path, "entered": [], "refused": refused}
    text = _with_fitted(text if at_once is None else at_once)
    if own is not None:
        project.write(own.path, own.text, own.digest)
    return _written(project, path, text, was) | {"entered": entered, "refused": refused}


def pasted_trials(project: Project, path: str, table: str, was: str = "") -> dict[str, Any]:
    """Return what a table of trials changes in the trials of a campaign with the same numbers.

    With the digest of the campaign that was shown (``was``), the changes are written.
    """
    from jounce.campaign.description import Campaign
    from jounce.campaign.laboratory import read_trial_text
    from jounce.core.description import toml_table

    read = project.read(path)
    document: Any = tomlkit.parse(read.text)
    trials = {int(trial["number"]): trial for trial in document.get("trial", [])}
    rows = read_trial_text(table)
    changes: list[dict[str, Any]] = [
        {"number": row.number, "key": key, "before": str(trial.get(key, "")), "after": value}
        for row in rows
        if (trial := trials.get(row.number)) is not None
        for key, value in _new_fields(trial, row, document).items()
    ]
    for change in changes:
        trials[change["number"]][change["key"]] = change["after"]
    text = tomlkit.dumps(document)
    with only_below(project.root):
        Campaign.from_table(toml_table(text), where=path, text=text)
    answer = {
        "changes": changes,
        "absent": [row.number for row in rows if row.number not in trials],
        "unlisted": sorted(set(trials) - {row.number for row in rows}),
        "digest": read.digest,
    }
    if not was or not changes:
        return answer
    written = project.write(path, text, was)
    return answer | {"path": path, "digest": written.digest, "before": read.text}


def _new_fields(trial: Mapping[str, Any], row: TrialRow, document: Any) -> dict[str, str]:
    """Return the keys of a trial that differ from its row in the table; a missing train of obstacles is added."""
    from jounce.campaign.arrivals import fields_of
    from jounce.campaign.from_folder import road_of

    fields = {
        key: value
        for key, value in fields_of(row).items()
        if not _is_same(trial.get(key), value, _UNITS[key])
    }
    roads = document.get("roads", {})
    present = roads.get(trial.get("road"), {})
    if row.pitch is not None and not _is_train(present, row):
        known = next((name for name, road in roads.items() if _is_train(road, row)), None)
        if known is None and "A" in roads:
            known = road_of(row)
            roads[known] = _item(
                {"kind": "train", "of": "A", "count": row.count, "pitch": f"{row.pitch:g} m"}
            )
        if known is not None:
            fields["road"] = known
    elif row.pitch is None and present.get("kind") == "train" and "A" in roads:
        fields["road"] = "A"
    return fields


_UNITS = {"speed": "m/s", "tyre_pressure": "Pa", "strut_angle": "rad"}


def _is_same(before: Any, after: str, si: str) -> bool:
    try:
        return math.isclose(to_si(before, si), to_si(after, si), rel_tol=1e-9)
    except JounceError:
        return False


def _is_train(road: Mapping[str, Any], row: TrialRow) -> bool:
    return (
        road.get("kind") == "train"
        and road.get("count") == row.count
        and _is_same(road.get("pitch"), f"{row.pitch:g} m", "m")
    )


def _written(project: Project, path: str, text: str, was: Text) -> dict[str, Any]:
    written = project.write(path, text, was.digest)
    before = was.text if was.digest else ""
    return {"path": path, "text": written.text, "digest": written.digest, "before": before}


def _all_checked(
    project: Project, path: str, text: str, entries: Sequence[FileEntry]
) -> str | None:
    """Return the text with all files; ``None`` if any of them does not fit."""
    try:
        for entry in entries:
            _check_state(project, entry)
        return _checked(project, path, text, *entries)
    except JounceError:
        return None


def _checked(project: Project, path: str, text: str, *entries: FileEntry) -> str:
    """Return the text with more files, if that is a valid campaign."""
    from jounce.campaign.description import Campaign
    from jounce.core.description import toml_table

    try:
        for entry in entries:
            text = _with_file(project, path, text, entry.use, entry.fields)
        with only_below(project.root):
            Campaign.from_table(toml_table(text), where=path, text=text)
    except (
        ValueError,
        TypeError,
        KeyError,
        AttributeError,
        RecursionError,
    ) as error:  # wrong fields, or incompatible content
        cause = f"{type(error).__name__}: {error}"
        raise DescriptionError(
            "this cannot be added to the campaign", where=path, found=cause
        ) from None
    return text


def own_values(project: Project, asked: OwnRig) -> list[dict[str, Any]]:
    """Return the values of a rig before and after its changes: number with its unit, by path; nothing is written."""
    rig, own = _rig_with(project, asked)
    before, after = rig.parameters(), own.parameters()
    return [
        {
            "path": name,
            "before": _written_value(rig, name, before[name]),
            "after": _written_value(own, name, after[name]),
        }
        for name in asked.changes
    ]


def _written_value(rig: Any, name: str, value: float) -> str:
    from jounce.core.display import display_unit
    from jounce.parts.rig import unit_of

    unit = display_unit(unit_of(rig, name), abs(value))
    return f"{value * unit.factor:.6g} {unit.name}".strip()


def _rig_with(project: Project, asked: OwnRig) -> tuple[Any, Any]:
    """Return a rig, and the same with its changes."""
    from jounce.web.answers import rig_of

    rig: Any = rig_of(project, asked.rig)
    return rig, rig.with_changes(dict(asked.changes))


def _own_text(project: Project, path: str, new: NewCampaign) -> Text:
    """Return the rig of a new campaign as it will be written beside it; an equal file may be there already."""
    from jounce.parts.files import rig_text

    own = (Path(path).parent / _OWN_RIG).as_posix()
    said = ", ".join(f"{name} = {value}" for name, value in new.changes.items())
    text = rig_text(
        _rig_with(project, new)[1], [f"{new.rig} with values of the laboratory: {said}"]
    )
    if not project.inside(own).exists():
        return Text(own, text, "")
    present = project.read(own)
    if present.text != text:
        raise OutputError("the file already exists", where=own, hint="Choose another folder.")
    return present


def _filled(project: Project, path: str, new: NewCampaign) -> str:
    """Return the text of a new campaign without files."""
    from jounce.campaign.start import campaign_to_fill

    _, rig = _rig_with(project, new)
    file = project.inside(path)
    name = _OWN_RIG if new.changes else new.rig
    if name.endswith(".toml") and not new.changes:
        name = Path(os.path.relpath(project.inside(name), file.parent)).as_posix()
    return campaign_to_fill(rig, name, new.obstacle, new.roads, new.title)


def _check_state(project: Project, entry: FileEntry) -> None:
    """Refuse a file that is no longer the one that was shown."""
    from jounce.campaign.arrivals import file_state

    if entry.state and entry.state != file_state(project.inside(entry.file)):
        raise DescriptionError(
            "the file has changed since it was shown", where=entry.file, hint="Look at it again."
        )


def _with_fitted(text: str) -> str:
    """Return a campaign in which some trials are fitted: as it says, else those that cover the range of speeds."""
    from jounce.campaign.from_folder import trials_to_fit
    from jounce.campaign.laboratory import TrialRow

    document: Any = tomlkit.parse(text)
    trials, roads = document.get("trial", []), document.get("roads", {})
    if any(trial.get("use") for trial in trials):
        return text
    rows = [
        TrialRow.model_validate(
            {
                "number": int(trial["number"]),
                "speed": trial.get("speed"),
                "angle": trial.get("strut_angle"),
                "pressure": trial.get("tyre_pressure"),
                "pitch": 1.0 if roads.get(trial.get("road"), {}).get("kind") == "train" else None,
            }
        )
        for trial in trials
    ]
    fitted = trials_to_fit(rows)
    for trial in trials:
        trial["use"] = "fit" if int(trial["number"]) in fitted else "hold-out"
    return tomlkit.dumps(document)


def _with_file(project: Project, path: str, text: str, use: Use, fields: Mapping[str, Any]) -> str:
    """Return the text of a campaign with a measured file added."""
    file = project.inside(path)
    plain = {key: value for key, value in fields.items() if value not in ("", None, {}, [])}
    pressure, replace = str(plain.pop("pressure", "")), bool(plain.pop("replace", False))
    for key in ("files", "recording", "excitation"):
        if key in plain:
            plain[key] = _relative(project, file, plain[key])
    document: Any = tomlkit.parse(text)
    if use == "trial":
        table = tomlkit.table()
        numbers = [int(trial["number"]) for trial in document.get("trial", [])]
        for key, value in {"number": max(numbers, default=0) + 1, **plain}.items():
            table.add(key, _item(value))
        if "trial" not in document:
            document.add("trial", tomlkit.aot())
        document["trial"].append(table)
    else:
        bench = document.setdefault("bench", tomlkit.table(is_super_table=True))
        if use == "tyre":
            if not pressure:
                raise DescriptionError("tyre measurements need their pressure", where="pressure")
            bench = bench.setdefault("tyre", tomlkit.table(is_super_table=True))
        files = plain.get("files", [])
        if not isinstance(files, list) or len(files) > _MOST_FILES:
            raise DescriptionError("not a list of files", where="files", allowed="up to 500 files")
        name = pressure if use == "tyre" else use
        own = bench.setdefault(name, tomlkit.table())
        before = [] if replace else [str(file) for file in own.get("files", [])]
        differing = [key for key in _READ if before and own.get(key) != plain.get(key)]
        if differing:
            said = ", ".join(differing)
            hint = "Replace the existing files, or use the same columns for all files."
            raise DescriptionError(
                "the existing files have different reading options",
                where=name,
                found=said,
                hint=hint,
            )
        for key in _READ:
            own.pop(key, None)
        for key, value in plain.items():
            own[key] = _item(
                [*before, *(file for file in value if file not in before)]
                if key == "files"
                else value
            )
    return tomlkit.dumps(document)


def _item(value: Any) -> Any:
    if isinstance(value, Mapping):
        table = tomlkit.inline_table()
        table.update({key: _item(entry) for key, entry in value.items()})
        return table
    return value


def _relative(project: Project, campaign: Path, value: Any) -> Any:
    """Return file names of the project relative to the campaign's folder."""
    if isinstance(value, list):
        return [_relative(project, campaign, item) for item in value]
    if isinstance(value, Mapping):
        return {**value, "file": _relative(project, campaign, value["file"])}
    return Path(os.path.relpath(project.inside(str(value)), campaign.parent)).as_posix()


def _matching_files(project: Project, folder: Path, patterns: list[str]) -> list[str]:
    matches = []
    for pattern in patterns:
        try:
            files = sorted(folder.glob(pattern))
        except (
            ValueError,
            NotImplementedError,
            OSError,
            RecursionError,
        ):  # not a pattern, or no match
            continue
        matches += [file.resolve() for file in files if file.resolve().is_relative_to(project.root)]
    return [file.relative_to(project.root).as_posix() for file in dict.fromkeys(matches)]


def _place(project: Project, folder: Path, trial: Mapping[str, Any]) -> dict[str, Any]:
    """Return a trial with the path of its recording in the project."""
    named = (
        _matching_files(project, folder, [str(trial.get("recording", ""))])
        if trial.get("recording")
        else []
    )
    return {**trial, "file": named[0] if named else ""}


def _mass(project: Project, rig: str, file: Path) -> str:
    """Return the oscillating mass as text with its unit; empty if the rig does not define it."""
    from jounce.parts import load
    from jounce.parts.files import rig_named_in

    try:
        with only_below(project.root):
            numbers = load(rig_named_in(rig, file)).parameters()
    except DescriptionError:
        return ""
    value = numbers.get("sprung.mass")
    return "" if value is None else f"{value:.6g} kg"
