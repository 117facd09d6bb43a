"""Campaigns for the page: measurements, planned updates, and adding measured files."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, Literal

import tomlkit

from jounce.core.errors import DescriptionError
from jounce.core.files import only_below
from jounce.web.project import Project

_READ = ("columns", "variable", "sample_time", "stroke_positive", "force_positive")
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


def enter_file(project: Project, path: str, use: Use, fields: Mapping[str, Any]) -> dict[str, Any]:
    """Add a measured file to a campaign, as a bench table or a new trial. Comments of the file are kept.

    The change is not written if it would make the campaign invalid.
    """
    from jounce.campaign.description import Campaign
    from jounce.core.description import toml_table

    was = project.read(path)
    try:
        text = _with_file(project, path, was.text, use, fields)
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
    written = project.write(path, text, was.digest)
    return {"path": path, "text": written.text, "digest": written.digest, "before": was.text}


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
    """Return file names of the project relative to the campaign in the same folder."""
    if isinstance(value, list):
        return [_relative(project, campaign, item) for item in value]
    if isinstance(value, Mapping):
        return {**value, "file": _relative(project, campaign, value["file"])}
    file = project.inside(str(value))
    if not file.is_relative_to(campaign.parent):
        hint = "Upload or copy the file to that folder."
        raise DescriptionError(
            "the file is not in the campaign's folder", where=str(value), hint=hint
        )
    return file.relative_to(campaign.parent).as_posix()


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
