"""What differs between rigs, runs and campaigns of a project."""

from __future__ import annotations

import contextlib
import tomllib
from collections.abc import Mapping, Sequence
from pathlib import PurePath
from typing import TYPE_CHECKING, Any

from jounce.core.description import Description
from jounce.core.errors import DescriptionError, JounceError
from jounce.web.answers import cells_of, label_of, rig_of, trial_of
from jounce.web.kept import digest_of_inputs, history
from jounce.web.project import RESULTS, Project
from jounce.web.untrusted import content, plain_json

if TYPE_CHECKING:
    from jounce.parts import Rig

_KINDS = ("rig", "trial", "campaign")
_LARGEST = 20_000_000  # bytes of a file of results


def compare_files(project: Project, names: Sequence[str]) -> dict[str, Any]:
    """List what differs between rigs, vehicles, campaigns and runs, or what campaigns found, with equivalent code.

    A run counts as its rig and trial. What a run was made of is found by its digest, in the file or in its earlier
    versions.
    """
    from jounce.parts.differences import compare_descriptions

    runs = {run["path"]: run for run in history(project)}
    paths = list(dict.fromkeys(names))
    if paths and all(PurePath(name).name == RESULTS for name in paths):
        return _compare_results(project, paths)
    described = {label_of(name): _described(project, name, runs) for name in paths}
    kinds = [
        kind for kind in _KINDS if described and all(kind in each for each in described.values())
    ]
    if not kinds:
        listed = ", ".join(f"{name}: {', '.join(each)}" for name, each in described.items())
        raise DescriptionError(
            "these cannot be compared", where="names", found=listed, allowed="files of one kind"
        )
    rows = []
    for kind in kinds:
        rows += cells_of(compare_descriptions({n: each[kind] for n, each in described.items()}))[
            "rows"
        ]
    return {"names": list(described), "rows": rows} | _equivalents(
        paths, runs, is_campaign="campaign" in kinds
    )


def _compare_results(project: Project, names: Sequence[str]) -> dict[str, Any]:
    """List what campaigns found, from their files of results."""
    from jounce.campaign.results_compared import compare_results

    results = {}
    for name in names:
        try:
            results[name] = plain_json(content(project.inside(name), _LARGEST))
        except (OSError, ValueError):
            results[name] = {}  # refused with its name
    rows = []
    for row in compare_results(results).rows:
        cells, unit = row.cells()
        rows.append([row.name, unit, *cells])
    files = "".join(f"    {name!r}: {name!r},\n" for name in names)
    python = f"import jounce as jn\n\nprint(jn.compare_results({{\n{files}}}))\n"
    listed = {"names": list(names), "rows": rows, "title": "Results of campaigns"}
    return listed | {"python": python, "command": "", "files": {}}


def _described(
    project: Project, name: str, runs: Mapping[str, Mapping[str, Any]]
) -> dict[str, Description]:
    """Return the descriptions of a run (its rig and trial), of a campaign, or of a rig."""
    if name in runs:
        run = runs[name]
        return {"rig": _rig_of_run(project, run), "trial": trial_of(project, run["trial"])}
    if _is_campaign(project, name):
        from jounce.campaign import load_campaign
        from jounce.core.files import only_below

        with only_below(project.root):
            return {"campaign": load_campaign(project.inside(name))[0]}
    return {"rig": rig_of(project, name)}


def _is_campaign(project: Project, name: str) -> bool:
    if not name.endswith(".toml"):
        return False
    try:
        return tomllib.loads(project.read(name).text).get("schema") == "jounce.campaign/1"
    except tomllib.TOMLDecodeError:
        return False  # the error is raised when it is loaded as a rig


def _rig_of_run(project: Project, run: Mapping[str, Any]) -> Rig:
    """Return the rig that a run was made of: the file, or the earlier version that has its digest."""
    name = run["rig"]
    earlier = project.versions(name) if name.endswith(".toml") else []
    for each in (name, *(version.name for version in earlier)):
        with contextlib.suppress(JounceError):  # invalid by now
            rig = rig_of(project, each).with_changes(dict(run["changes"]))
            if digest_of_inputs(rig) == run["rig_digest"]:
                return rig
    raise DescriptionError(
        "the rig of this run is not known any more",
        where=run["path"],
        found=name,
        allowed="the rig's file, or an earlier version of it, as it was for the run",
        hint="Save the run again.",
    )


def _equivalents(
    names: Sequence[str], runs: Mapping[str, Mapping[str, Any]], *, is_campaign: bool
) -> dict[str, Any]:
    """Return Python code that lists the differences between files; empty for runs and versions, which need more."""
    if any(name in runs or "@" in name for name in names):
        return {"python": "", "command": "", "files": {}}
    load = "load_campaign({!r})[0]" if is_campaign else "jn.load({!r})"
    also = "from jounce.campaign import load_campaign\n" if is_campaign else ""
    listed = "".join(f"    {name!r}: {load.format(name)},\n" for name in names)
    python = f"import jounce as jn\n{also}\nprint(jn.compare_descriptions({{\n{listed}}}))\n"
    return {"python": python, "command": "", "files": {}}
