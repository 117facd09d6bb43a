"""``jounce check``: whether files are what they should be, and whether everything is there that they name."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import AsJson, files
from jounce.cli.reply import DONE, REFUSED, Reply
from jounce.cli.tables import table

if TYPE_CHECKING:
    from rich.console import Console


def check(
    given: Annotated[
        list[str],
        typer.Argument(
            metavar="FILE...", help="Rigs, vehicles, controllers, campaigns, roads, testers, limits, recordings."
        ),
    ],
    parameters: Annotated[
        bool, typer.Option("--parameters", help="List the numbers of rigs, vehicles and testers by their paths.")
    ] = False,
    as_json: AsJson = False,
) -> Reply:
    """Check descriptions, and for campaigns every file they name. Exit code 2 when anything is wrong.

    Example: jounce check campaign.toml rig.toml roads/*.toml
    """
    from jounce.cli.checking import check_file

    checked = [check_file(file) for file in files(given, "FILE")]
    plain = {
        "ok": not any(item.problems for item in checked),
        "files": [
            {
                "file": str(item.file),
                "kind": item.kind,
                "ok": not item.problems,
                "what": item.what,
                "problems": list(item.problems),
                "notes": list(item.notes),
                **({"parameters": item.parameters} if parameters else {}),
            }
            for item in checked
        ],
    }
    for item in checked:
        sys.stderr.writelines(f"jounce: {problem}\n" for problem in item.problems)
    return Reply(plain, lambda out: _draw(out, plain), as_json, DONE if plain["ok"] else REFUSED)


def _draw(out: Console, plain: dict[str, Any]) -> None:
    rows = []
    for item in plain["files"]:
        count = len(item["problems"])
        verdict = "ok" if item["ok"] else f"{count} problem{'s' if count > 1 else ''}"
        rows.append((item["file"], item["kind"], verdict, item["what"]))
    out.print(table("", ("file", "kind", "verdict", "what"), rows, text=(0, 1, 2, 3)))
    for item in plain["files"]:
        for note in item["notes"]:
            out.print(note)
    for item in plain["files"]:
        if item.get("parameters"):
            numbers = [(path, found["value"], found["unit"]) for path, found in item["parameters"].items()]
            out.print(table(f"{item['file']}: numbers", ("path", "value", "unit"), numbers, text=(0, 2)))
