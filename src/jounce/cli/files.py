"""``jounce check``, ``jounce library`` and ``jounce import``: what is in a file, what is shipped, what others wrote."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import LENGTH, AsJson, Force, files, optional_positive
from jounce.cli.reply import DONE, REFUSED, Reply, progress, show_findings, table, tell
from jounce.core.errors import DescriptionError, JounceError, RecordingError, unknown

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.control import FmuVariable
    from jounce.core.findings import Finding


def check(
    given: Annotated[
        list[str],
        typer.Argument(
            metavar="FILE...",
            help="Rigs, vehicles (also shipped ones by their name), controllers, FMUs, campaigns, studies, roads, "
            "testers, limits, recordings.",
        ),
    ],
    parameters: Annotated[
        bool, typer.Option("--parameters", help="List the parameters of rigs, vehicles and testers by their paths.")
    ] = False,
    as_json: AsJson = False,
) -> Reply:
    """Check files, and for a campaign all files it refers to. Exit code 2 if anything is wrong.

    Example: jounce check campaign.toml rig.toml roads/*.toml
    """
    from jounce.parts import library as rigs

    checked, every = [], files(given, "FILE")
    with progress() as say:
        for k, file in enumerate(every, 1):
            say(f"checking {k} of {len(every)}: {file}")
            shipped = None if file.exists() else rigs().get(str(file))
            checked.append(check_file(file) if shipped is None else replace(check_file(shipped), file=file))
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
        for problem in item.problems:
            tell(problem)
    return Reply(plain, lambda out: _draw_checked(out, plain), as_json, DONE if plain["ok"] else REFUSED)


def _draw_checked(out: Console, plain: dict[str, Any]) -> None:
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
            out.print(table(f"{item['file']}: parameters", ("path", "value", "unit"), numbers, text=(0, 2)))


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
        checks: dict[str, Callable[[Checked], None]] = {".toml": _check_toml, ".crg": _check_road, ".fmu": _check_fmu}
        checks.get(file.suffix.lower(), _check_measured)(checked)
    return checked


def _check_toml(checked: Checked) -> None:
    from jounce.core.description import read_toml
    from jounce.inspection.record import NUMBERS, SIDES, TEXTS, flat_facts

    table, text = read_toml(checked.file)
    of_header = {*TEXTS, *(f"{side}.{name}" for side in SIDES for name in NUMBERS)}
    further = {key for key, value in table.items() if isinstance(value, (dict, list))} - {*SIDES}
    if "schema" not in table and not further and not of_header.isdisjoint(flat_facts(table)):
        _check_header(checked, flat_facts(table), text)
        return
    schema = table.get("schema", "jounce.road/1" if "kind" in table else None)
    if schema is None:
        raise DescriptionError("the schema line is missing", where=str(checked.file), allowed=", ".join(_SCHEMAS))
    schema = str(schema)
    if schema not in _SCHEMAS:
        raise unknown(schema, _SCHEMAS, what="schema", where=str(checked.file))
    checked.kind = schema.removeprefix("jounce.").removesuffix("/1")
    _SCHEMAS[schema](checked)


def _check_rig(checked: Checked) -> None:
    from jounce.parts import load, rig_findings
    from jounce.simulation import equilibrium

    rig = load(checked.file)
    checked.what = f"{getattr(rig, 'model', 'rig')} with {len(rig.parameters())} parameters"
    checked.parameters = _parameters(rig)
    checked.notes += map(str, rig_findings(rig, str(checked.file)))
    lacks: tuple[str, ...] = getattr(rig, "lacks", ())
    if lacks:
        text = f"it has no {', '.join(lacks)}: its kinematics can be swept, it cannot move."
        checked.notes.append(f"note: {checked.file}: {text}")
        return
    try:
        equilibrium(rig)
    except JounceError as error:
        raise DescriptionError(f"it cannot stand: {error}", where=str(checked.file)) from None


def _parameters(description: Any) -> dict[str, dict[str, float | str]]:
    """Every number of a description by its path, SI, with its unit."""
    from jounce.parts.rig import parameters_of, unit_of

    found = parameters_of(description)
    return {path: {"value": value, "unit": unit_of(description, path)} for path, value in found.items()}


def _check_road(checked: Checked) -> None:
    from jounce.roads import load_road
    from jounce.roads.trial import road_findings

    checked.kind = "road"
    road = load_road(checked.file)
    checked.notes += map(str, road_findings(road, str(checked.file)))
    checked.what = f"{getattr(road, 'kind', 'road')}, ends at {road.end():g} m"


def _check_control(checked: Checked) -> None:
    from jounce.control import FmuControl, controller, read_fmu

    found = controller(checked.file)
    checked.what = str(getattr(found, "law", type(found).__name__))
    if checked.what == "fmu":  # which is read, and not run
        from jounce.control import read_fmu

        component = read_fmu(str(getattr(found, "file", "")))
        component.binary()
        checked.what = f"{checked.what}: {component.path.name}"
    if isinstance(found, FmuControl):
        read_fmu(found.file).binary()


def _check_fmu(checked: Checked) -> None:
    """An FMU: what can be connected, and whether it runs here as a controller or force element."""
    from jounce.control import read_fmu

    found = read_fmu(checked.file)
    checked.kind = "FMU"
    uses = [
        word for word, can in (("co-simulation", found.can_step), ("model exchange", found.can_be_integrated)) if can
    ]
    checked.what = f"FMI {found.version}.0, {', '.join(uses)}, for {', '.join(found.platforms) or 'no platform'}"
    for word, group in (("inputs", found.inputs), ("outputs", found.outputs), ("parameters", found.parameters)):
        shown = [_connectable(v) for v in group[:_MANY]]
        more = f" and {len(group) - _MANY} more" if len(group) > _MANY else ""
        checked.notes.append(f"{word}: {', '.join(shown) or 'none'}{more}")
    checked.notes += map(str, found.findings)


def _connectable(v: FmuVariable) -> str:
    """A variable of an FMU with its unit; the type, too, of what is no single real number."""
    of = "" if v.kind in ("Real", "Float64") and not v.dimensions else f" ({v.shape})"
    return f"{v.name}{f' [{v.unit}]' if v.unit else ''}{of}"


_MANY = 20  # variables of an FMU in a line


def _check_tester(checked: Checked) -> None:
    from jounce.parts.testers import findings_of_tester, load_tester

    tester = load_tester(checked.file)
    checked.what = f"{tester.name}: {tester.kind}, evaluated by {tester.method}"
    checked.parameters = _parameters(tester)
    checked.notes += map(str, findings_of_tester(tester, str(checked.file)))


def _check_limits(checked: Checked) -> None:
    from jounce.inspection.limits import load_limits

    limits = load_limits(checked.file)
    further = [*limits.conditions, *(f"difference of {name}" for name in limits.differences)]
    checked.what = f"{limits.label}: {', '.join([*limits.methods, *further])}"


def _check_header(checked: Checked, facts: dict[str, Any], text: str) -> None:
    """Facts about the car in the file beside a record; each mistake is reported with its line."""
    from jounce.core.description import line_of
    from jounce.inspection.record import read_facts

    checked.kind, checked.what = "header of a record", ", ".join(facts)
    for key, value in facts.items():
        line = line_of(text, tuple(key.split("."))) or line_of(text, (key,))
        with checked.step():
            _, findings = read_facts({key: value}, where=f"{checked.file}, line {line}")
            checked.notes += map(str, findings)


def _check_measured(checked: Checked) -> None:
    """A recording, a force-deflection trial or a road table: the first whose columns the file has."""
    from jounce.recordings import read_columns

    tables = {"force-deflection trial": {"displacement": "m", "force": "N"}, "road table": {"x": "m", "z": "m"}}
    missing: list[JounceError] = []
    for kind in ("recording", *tables):
        checked.kind = kind
        try:
            if kind == "recording":
                _check_recording(checked)
            else:
                values, findings = read_columns(checked.file, tables[kind])
                checked.what = f"{len(next(iter(values.values())))} rows"
                checked.notes += map(str, findings)
        except RecordingError as error:
            if not error.what.startswith(("no column", "no channel")):  # what readers say of a file of another kind
                raise
            missing.append(error)
        else:
            return
    checked.kind = "unknown"
    raise missing[0]


def _check_recording(checked: Checked) -> None:
    from jounce.recordings import read_recording

    data, findings = read_recording(checked.file)
    if any(str(name).endswith(".plate.force") for name in data.data_vars):
        from jounce.inspection.record import read_record

        checked.kind = "record of a tester"
        data, findings = read_record(checked.file)
    time = data["time"].to_numpy()
    checked.what = f"{', '.join(map(str, data.data_vars))}; {len(time)} samples, {time[-1] - time[0]:g} s"
    checked.notes += map(str, findings)


def _check_campaign(checked: Checked) -> None:
    """The campaign, its rig and roads, and every file of bench and trials."""
    from jounce.campaign import load_campaign
    from jounce.campaign.characterise import files_of, read_force_deflection
    from jounce.campaign.run import checks_of, load_trial
    from jounce.parts import load
    from jounce.parts.files import rig_named_in
    from jounce.roads import read_roads

    campaign, text = load_campaign(checked.file)
    folder, where = checked.file.parent, str(checked.file)
    checked.what = ", ".join(
        f"{count} {word}{'' if count == 1 else 's'}"
        for count, word in ((len(campaign.trial), "trial"), (len(campaign.update), "update"))
    )
    with checked.step():
        rig = load(rig_named_in(campaign.rig, checked.file))
        for check in checks_of(campaign, rig, checked.file):
            with checked.step():
                check()
    roads: dict[str, Any] = dict.fromkeys(campaign.roads)
    with checked.step():
        roads = dict(read_roads(campaign.roads, where=where, text=text, folder=folder))
    for entry in campaign.trial:
        place = f"{where}: trial {entry.number}"
        if entry.road is not None and entry.road not in roads:
            checked.problems.append(str(unknown(entry.road, roads, what="road", where=place)))
        with checked.step():
            try:
                if entry.road is not None and roads.get(entry.road) is None:
                    entry.read(folder / entry.recording, folder)  # that of its road is said
                else:
                    load_trial(entry, roads, folder)
            except JounceError as error:
                raise RecordingError(f"{place}: {error}") from None
    bench = campaign.bench
    tables = {"bench.spring": bench.spring, **{f'bench.tyre."{name}"': item for name, item in bench.tyre.items()}}
    for name, asked in tables.items():
        if asked is not None:
            with checked.step():
                read_force_deflection(files_of(asked.files, folder, f"{where}: {name}"), asked)
    if bench.decay is not None:
        with checked.step():
            for file in files_of(bench.decay.files, folder, f"{where}: bench.decay"):
                bench.decay.read(file, folder)


def _check_truth(checked: Checked) -> None:
    from jounce.campaign import load_truth

    truth = load_truth(checked.file)
    channels, rig = ", ".join(truth.sensors), truth.true_rig()
    checked.what = (
        f"virtual bench: {getattr(rig, 'model', '')} with {len(rig.parameters())} parameters; records {channels}"
    )


def _check_design(checked: Checked) -> None:
    from jounce.design.kinematics import check_study

    study, free = check_study(checked.file)
    checked.what = f"design of {study.rig}: {free} free numbers, {len(study.target)} targets, {study.starts} starts"


def _check_sweep(checked: Checked) -> None:
    from jounce.variants.study import read_sweep

    sweep = read_sweep(checked.file)
    metrics, numbers = len(sweep.work.metrics), len(sweep.columns)
    checked.what = (
        f"sweep of {sweep.study.rig}: {sweep.count} variants of {numbers} number{'' if numbers == 1 else 's'}, "
        f"{metrics} metric{'' if metrics == 1 else 's'}"
    )


def _check_optimisation(checked: Checked) -> None:
    from jounce.design.optimisation_study import check_optimisation

    study, problem = check_optimisation(checked.file)
    wanted = "front" if study.front is not None else "best design"
    count = len(problem.free)
    checked.what = f"{wanted} of {study.rig}: {count} number{'' if count == 1 else 's'} over {problem.driven}"


_SCHEMAS: dict[str, Callable[[Checked], None]] = {
    "jounce.rig/1": _check_rig,
    "jounce.vehicle/1": _check_rig,
    "jounce.campaign/1": _check_campaign,
    "jounce.truth/1": _check_truth,
    "jounce.road/1": _check_road,
    "jounce.control/1": _check_control,
    "jounce.tester/1": _check_tester,
    "jounce.limits/1": _check_limits,
    "jounce.design/1": _check_design,
    "jounce.sweep/1": _check_sweep,
    "jounce.optimisation/1": _check_optimisation,
}


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
