"""``jounce check``, ``jounce library`` and ``jounce import``: checks, the shipped library, files of other programs."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import LENGTH, AsJson, Force, optional_positive
from jounce.cli.reply import Reply, show_findings, table, tell
from jounce.core.errors import DescriptionError, unknown

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.core.findings import Finding


def library(
    name: Annotated[str | None, typer.Argument(help="File to print, or road to describe.")] = None,
    as_json: AsJson = False,
) -> Reply:
    """List the shipped rigs, vehicles, roads, testers, limits and truths of virtual benches, or print one of them.

    Example: jounce library kart-quarter-car > my-rig.toml
    """
    from jounce.campaign.shipped import truth_library
    from jounce.inspection.shipped import SHIPPED, shipped_limits
    from jounce.parts import library as rigs
    from jounce.parts.testers import library as testers
    from jounce.roads import road_library as roads

    shipped_rigs, shipped_roads, shipped_testers = rigs(), roads(), testers()
    limits, truths = {SHIPPED: shipped_limits()}, truth_library()
    if name is None:
        described = [_rig(*item) for item in shipped_rigs.items()]
        plain = {
            "rigs": [item for item in described if item["kind"] == "rig"],
            "vehicles": [item for item in described if item["kind"] == "vehicle"],
            "roads": [_road(*item) for item in shipped_roads.items()],
            "testers": [_tester(*item) for item in shipped_testers.items()],
            "limits": [_limits(*item) for item in limits.items()],
            "truths": [_truth(*item) for item in truths.items()],
        }
        return Reply(plain, lambda out: _draw_list(out, plain), as_json)
    for shipped, about in ((shipped_rigs, _rig), (shipped_testers, _tester), (limits, _limits), (truths, _truth)):
        if name in shipped:
            return _printed(about(name, shipped[name]), as_json=as_json)
    if name not in shipped_roads:
        raise unknown(
            name, [*shipped_rigs, *shipped_roads, *shipped_testers, *limits, *truths], what="name", where="NAME"
        )
    road = _road(name, shipped_roads[name])
    lines = f"{name}: {road['what']}\nfile: {road['file']}\n\n{road['source']}"
    return Reply(road, lambda out: out.print(lines), as_json)


# Files that are shipped are read and not loaded: they are known to be right, and checking them all takes longest.
def _rig(name: str, file: Path) -> dict[str, Any]:
    table = _shipped_table(file)
    kind = "vehicle" if table["schema"].startswith("jounce.vehicle/") else "rig"
    return _described(name, kind, table["model"], table, file)


def _tester(name: str, file: Path) -> dict[str, Any]:
    table = _shipped_table(file)
    return _described(name, "tester", f"{table['kind']}, {table['method']}", table, file)


def _limits(name: str, file: Path) -> dict[str, Any]:
    table = _shipped_table(file)
    what = f"limits {table['version']} of {', '.join(table['methods'])}"
    return {"name": name, "kind": "limits", "what": what, "source": table["source"], "file": str(file)}


def _truth(name: str, file: Path) -> dict[str, Any]:
    from jounce.parts.files import rig_path

    table = _shipped_table(file)
    model = _shipped_table(rig_path(table["rig"]))["model"]
    return _described(name, "truth", f"of a virtual bench, {model}", table, file)


def _shipped_table(file: Path) -> dict[str, Any]:
    from jounce.core.description import read_toml

    return read_toml(file)[0]


def _described(name: str, kind: str, what: str, table: dict[str, Any], file: Path) -> dict[str, Any]:
    about = {"name": name, "kind": kind, "what": what}
    return {**about, "source": table.get("source", ""), "estimated": table.get("estimated", []), "file": str(file)}


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


def _printed(about: dict[str, Any], *, as_json: bool) -> Reply:
    text = Path(about["file"]).read_text(encoding="utf-8")

    def draw(_: Console) -> None:
        sys.stdout.write(text)

    return Reply({**about, "text": text}, draw, as_json)


def _draw_list(out: Console, plain: dict[str, Any]) -> None:
    for title in ("Rigs", "Vehicles", "Roads", "Testers", "Limits", "Truths"):
        rows = [(item["name"], item["what"], item["source"]) for item in plain[title.lower()]]
        out.print(table(title, ("name", "what", "source"), rows, text=(0, 1, 2)))
    out.print("`jounce library NAME` prints one of them; the names are accepted wherever a file is.")


import_app = typer.Typer(no_args_is_help=True, help="Convert models of other programs to rig files.")


@import_app.callback()
def _import() -> None:
    """Keep the name of a program part of the command even where there is only one."""


@import_app.command("chrono")
def chrono(
    file: Annotated[Path, typer.Argument(metavar="FILE.json", help="DoubleWishbone, MacPhersonStrut or MultiLink.")],
    out: Annotated[Path | None, typer.Option(help="Rig file to write; stdout by default.")] = None,
    wheel_radius: Annotated[
        str | None, typer.Option(help="Undeformed tyre radius. Default: 330 mm (estimated).")
    ] = None,
    wheel_mass: Annotated[str | None, typer.Option(help="Mass of rim and tyre. Default: 20 kg (estimated).")] = None,
    tyre_stiffness: Annotated[str | None, typer.Option(help="Tyre stiffness. Default: 250 N/mm (estimated).")] = None,
    sprung_mass: Annotated[
        str | None,
        typer.Option(help="Sprung mass on this wheel. Default: what the spring carries at design (estimated)."),
    ] = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Convert a Project Chrono suspension to the left corner of a 3-D rig.

    Example: jounce import chrono suspension.json --out rig.toml --wheel-radius "344 mm"
    """
    from jounce.parts.importers import import_chrono

    return _imported(
        file,
        out,
        lambda: import_chrono(
            file,
            wheel_radius=optional_positive(wheel_radius, "m", "--wheel-radius", most=LENGTH),
            wheel_mass=optional_positive(wheel_mass, "kg", "--wheel-mass"),
            tyre_stiffness=optional_positive(tyre_stiffness, "N/m", "--tyre-stiffness"),
            sprung_mass=optional_positive(sprung_mass, "kg", "--sprung-mass"),
        ),
        force=force,
        as_json=as_json,
    )


@import_app.command("adams")
def adams(
    file: Annotated[Path, typer.Argument(metavar="FILE.sub", help="Suspension subsystem of Adams Car, as text.")],
    out: Annotated[Path | None, typer.Option(help="Rig file to write; stdout by default.")] = None,
    name: Annotated[
        list[str] | None, typer.Option(metavar="THEIRS=OURS", help="A name in the file and the hardpoint it is.")
    ] = None,
    wheel_radius: Annotated[
        str | None, typer.Option(help="Undeformed tyre radius. Default: 330 mm (estimated).")
    ] = None,
    wheel_mass: Annotated[str | None, typer.Option(help="Mass of rim and tyre. Default: 20 kg (estimated).")] = None,
    tyre_stiffness: Annotated[str | None, typer.Option(help="Tyre stiffness. Default: 250 N/mm (estimated).")] = None,
    sprung_mass: Annotated[
        str | None,
        typer.Option(help="Sprung mass on this wheel. Default: what the spring carries at design (estimated)."),
    ] = None,
    rigid: Annotated[bool, typer.Option("--rigid", help="Leave the bushings out: the joints are ideal.")] = False,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Convert a suspension subsystem of Adams Car, with its property files, to the left corner of a 3-D rig.

    Example: jounce import adams database.cdb/subsystems.tbl/front.sub --out rig.toml
    """
    from jounce.parts.importers import import_adams

    return _imported(
        file,
        out,
        lambda: import_adams(
            file,
            names=dict(_pair(text) for text in name or ()),
            wheel_radius=optional_positive(wheel_radius, "m", "--wheel-radius", most=LENGTH),
            wheel_mass=optional_positive(wheel_mass, "kg", "--wheel-mass"),
            tyre_stiffness=optional_positive(tyre_stiffness, "N/m", "--tyre-stiffness"),
            sprung_mass=optional_positive(sprung_mass, "kg", "--sprung-mass"),
            rigid=rigid,
        ),
        force=force,
        as_json=as_json,
    )


@import_app.command("hardpoints")
def hardpoints(
    file: Annotated[
        Path,
        typer.Argument(
            metavar="TABLE", help="Text (name, x, y, z; Lotus; OptimumKinematics; VSUSP), YAML, JSON, .xlsx."
        ),
    ],
    out: Annotated[Path | None, typer.Option(help="Rig file to write; stdout by default.")] = None,
    unit: Annotated[
        str | None, typer.Option(help="Of the coordinates: mm, m, inch, cm. Default: what the file says.")
    ] = None,
    axes: Annotated[
        str | None, typer.Option(help='What in the table is forward, left and up, e.g. "-x,-y,z". Default: x,y,z.')
    ] = None,
    side: Annotated[str, typer.Option(help="Corner that is read where there are both: left or right.")] = "left",
    axle: Annotated[str | None, typer.Option(help="Axle that is read where there are both: front or rear.")] = None,
    model: Annotated[str | None, typer.Option(help="Suspension. Default: the one that has these points.")] = None,
    name: Annotated[
        list[str] | None, typer.Option(metavar="THEIRS=OURS", help="A name in the table and the hardpoint it is.")
    ] = None,
    wheel_radius: Annotated[
        str | None, typer.Option(help="Undeformed tyre radius. Default: height of the wheel centre (estimated).")
    ] = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Convert a table of hardpoints to the left corner of a 3-D rig, for its kinematics.

    Example: jounce import hardpoints points.csv --out rig.toml
    """
    from jounce.parts.importers import import_hardpoints

    pairs = dict(_pair(text) for text in name or ())
    sides, axles = ("left", "right"), ("front", "rear")
    if side not in sides:
        raise unknown(side, sides, what="side", where="--side")
    if axle is not None and axle not in axles:
        raise unknown(axle, axles, what="axle", where="--axle")
    return _imported(
        file,
        out,
        lambda: import_hardpoints(
            file,
            unit=unit,
            axes=axes,
            side=side,  # type: ignore[arg-type]
            axle=axle,  # type: ignore[arg-type]
            model=model,
            names=pairs,
            wheel_radius=optional_positive(wheel_radius, "m", "--wheel-radius", most=LENGTH),
        ),
        force=force,
        as_json=as_json,
    )


@import_app.command("mjcf")
def mjcf(
    file: Annotated[Path, typer.Argument(metavar="FILE.xml", help="Model of MuJoCo with one corner of a car.")],
    out: Annotated[Path | None, typer.Option(help="Rig file to write; stdout by default.")] = None,
    model: Annotated[str | None, typer.Option(help="Suspension. Default: the one that has these points.")] = None,
    name: Annotated[
        list[str] | None, typer.Option(metavar="THEIRS=OURS", help="A name in the file and the hardpoint it is.")
    ] = None,
    wheel_radius: Annotated[str | None, typer.Option(help="Undeformed tyre radius. Default: that of the tyre.")] = None,
    sprung_mass: Annotated[
        str | None, typer.Option(help="Sprung mass on this wheel. Default: that of the body in the file.")
    ] = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Convert a model of MuJoCo (MJCF) whose bodies are a suspension to the left corner of a 3-D rig.

    Example: jounce import mjcf corner.xml --out rig.toml
    """
    from jounce.parts.importers import import_mjcf

    return _imported(
        file,
        out,
        lambda: import_mjcf(
            file,
            names=dict(_pair(text) for text in name or ()),
            model=model,
            wheel_radius=optional_positive(wheel_radius, "m", "--wheel-radius", most=LENGTH),
            sprung_mass=optional_positive(sprung_mass, "kg", "--sprung-mass"),
        ),
        force=force,
        as_json=as_json,
    )


def _pair(text: str) -> tuple[str, str]:
    theirs, equals, ours = text.rpartition("=")
    if not equals or not theirs.strip() or not ours.strip():
        raise DescriptionError("not two names", where="--name", found=text, allowed="THEIRS=OURS")
    return theirs.strip(), ours.strip()


def _imported(
    file: Path,
    out: Path | None,
    read: Callable[[], tuple[Any, list[Finding], str]],
    *,
    force: bool,
    as_json: bool,
) -> Reply:
    """What every import does: look whether the rig can be written, read the file, write it, say what was found."""
    from jounce.core.writing import check_writable, write_atomically
    from jounce.parts import rig_findings

    if out is not None:
        check_writable(out, what="rigs", suffixes=(".toml",), force=force)
    rig, findings, text = read()
    found = [*findings, *rig_findings(rig, "" if out is None else str(out))]
    if out is not None:
        write_atomically(out, text, force=force)
    plain = {
        "file": str(file),
        "model": getattr(rig, "model", ""),
        "source": rig.source,
        "estimated": list(rig.estimated),
        "findings": found,
        "out": None if out is None else str(out),
        "text": text,
    }
    return Reply(plain, lambda console: _draw_import(console, plain, found), as_json)


def _draw_import(console: Console, plain: dict[str, Any], findings: list[Finding]) -> None:
    """Show the rig file alone on stdout, or what was written and what to know about it."""
    if plain["out"] is None:
        sys.stdout.write(plain["text"])
        for finding in findings:
            if finding.severity != "note":
                tell(str(finding), program="")
        return
    console.print(f"{plain['out']}: {plain['model']}, {plain['source']}")
    console.print(f"estimated: {', '.join(plain['estimated']) or 'nothing'}")
    show_findings(console, findings)
