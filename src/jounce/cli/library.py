"""``jounce library``: what comes with the program."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import AsJson
from jounce.cli.reply import Reply
from jounce.cli.tables import table
from jounce.core.errors import unknown

if TYPE_CHECKING:
    from rich.console import Console


def library(
    name: Annotated[str | None, typer.Argument(help="Print this file, or describe this road.")] = None,
    as_json: AsJson = False,
) -> Reply:
    """List the shipped rigs, vehicles, roads, testers and limits, or print one of them.

    Example: jounce library kart-quarter-car > my-rig.toml
    """
    from jounce.inspection.limits import SHIPPED, shipped_limits
    from jounce.parts import library as rigs
    from jounce.parts.testers import library as testers
    from jounce.roads import road_library as roads

    shipped_rigs, shipped_roads, shipped_testers = rigs(), roads(), testers()
    limits = {SHIPPED: shipped_limits()}
    if name is None:
        described = [_rig(*item) for item in shipped_rigs.items()]
        plain = {
            "rigs": [item for item in described if item["kind"] == "rig"],
            "vehicles": [item for item in described if item["kind"] == "vehicle"],
            "roads": [_road(*item) for item in shipped_roads.items()],
            "testers": [_tester(*item) for item in shipped_testers.items()],
            "limits": [_limits(*item) for item in limits.items()],
        }
        return Reply(plain, lambda out: _draw_list(out, plain), as_json)
    for files, about in ((shipped_rigs, _rig), (shipped_testers, _tester), (limits, _limits)):
        if name in files:
            return _printed(about(name, files[name]), as_json=as_json)
    if name in shipped_roads:
        road = _road(name, shipped_roads[name])
        return Reply(road, lambda out: _draw_road(out, road), as_json)
    raise unknown(name, [*shipped_rigs, *shipped_roads, *shipped_testers, *limits], what="name", where="NAME")


def _printed(about: dict[str, Any], *, as_json: bool) -> Reply:
    text = Path(about["file"]).read_text(encoding="utf-8")
    return Reply({**about, "text": text}, lambda _: _print_raw(text), as_json)


def _rig(name: str, file: Path) -> dict[str, Any]:
    from jounce.parts import Vehicle, load

    rig = load(file)
    return {
        "name": name,
        "kind": "vehicle" if isinstance(rig, Vehicle) else "rig",
        "what": getattr(rig, "model", ""),
        "source": rig.source,
        "estimated": list(rig.estimated),
        "file": str(file),
    }


def _tester(name: str, file: Path) -> dict[str, Any]:
    from jounce.parts.testers import load_tester

    tester = load_tester(file)
    return {
        "name": name,
        "kind": "tester",
        "what": f"{tester.kind}, {tester.method}",
        "source": tester.source,
        "estimated": list(tester.estimated),
        "file": str(file),
    }


def _limits(name: str, file: Path) -> dict[str, Any]:
    from jounce.inspection.limits import load_limits

    limits = load_limits(file)
    what = f"limits {limits.version} of {', '.join(limits.methods)}"
    return {"name": name, "kind": "limits", "what": what, "source": limits.source, "file": str(file)}


def _road(name: str, file: Path) -> dict[str, Any]:
    from jounce.roads import load_road, source_of_course

    road = load_road(file)
    points = road.segments(road.end()).evaluate(road.segments(road.end()).edges)[0]
    return {
        "name": name,
        "kind": "road",
        "what": f"measured course of {road.end():g} m, heights {1e3 * points.min():.3g} to {1e3 * points.max():.3g} mm",
        "length": road.end(),
        "lowest": float(points.min()),
        "highest": float(points.max()),
        "source": source_of_course(file),
        "file": str(file),
    }


def _print_raw(text: str) -> None:
    sys.stdout.write(text)


def _draw_list(out: Console, plain: dict[str, Any]) -> None:
    for title in ("Rigs", "Vehicles", "Roads", "Testers", "Limits"):
        rows = [(item["name"], item["what"], item["source"]) for item in plain[title.lower()]]
        out.print(table(title, ("name", "what", "source"), rows, text=(0, 1, 2)))
    out.print("jounce library NAME prints one; give a name wherever such a file is asked for.")


def _draw_road(out: Console, road: dict[str, Any]) -> None:
    out.print(f"{road['name']}: {road['what']}\nfile: {road['file']}\n\n{road['source']}")
