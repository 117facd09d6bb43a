"""``jounce ride``, ``ride-metrics``, ``compare`` and ``iri``: rides over rough roads, their records, roughness."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from typer.core import TyperCommand

from jounce.cli.options import (
    AsJson,
    Changes,
    Columns,
    Database,
    FigureFile,
    Force,
    ReportFile,
    Resample,
    SampleTime,
    Trust,
    Variable,
    VehicleName,
    changes,
    check_outputs,
    chosen_rig,
    optional_positive,
    reading,
    write_picture,
    write_report,
)
from jounce.cli.reply import Reply, progress, show_findings, show_written, table
from jounce.core.display import size
from jounce.core.errors import DescriptionError
from jounce.core.trust import trusting
from jounce.core.typed import positive_quantity, quantity

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from rich.console import Console

    from jounce.parts import Rig
    from jounce.report import Page
    from jounce.ride.metrics import RideMetrics
    from jounce.ride.study import Ride, RideStudy, RideTrial


_TO_THE_END = (
    "otherwise until the rear axle reaches the end of the road, the front axle being a wheelbase beyond it, or until "
    "the front axle reaches it if the road ends at another height than it begins."
)
RideRoad = Annotated[
    str, typer.Option(help="A class of ISO 8608 (iso:A to iso:H), a road file, or a name of `jounce library`.")
]
RideSpeed = Annotated[str, typer.Option(help='Speed over the road, e.g. "20 m/s".')]
RideDuration = Annotated[
    str | None,
    typer.Option(help=f"Time over the road; by default 60 s on ISO roads, {_TO_THE_END}"),
]
Seed = Annotated[int, typer.Option(min=0, help="Seed of the random road.")]


def ride(
    vehicle: VehicleName,
    road: RideRoad,
    speed: RideSpeed,
    control: Annotated[
        list[str] | None,
        typer.Option(
            help="A controller (see `jounce compare --help`), its file, or all; passive by default. Repeat it."
        ),
    ] = None,
    duration: RideDuration = None,
    seed: Seed = 0,
    trust: Trust = False,
    set_: Changes = None,
    out: Annotated[
        Path | None, typer.Option(help="Write the recording of a single run (.nc, .csv, .mat, .mf4, .parquet, .xlsx).")
    ] = None,
    figure: FigureFile = None,
    report: ReportFile = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Drive a vehicle over a rough road: ride metrics and, on ISO roads, those of the linear model.

    Example: jounce ride audi-a6-full-car --road iso:C --speed "20 m/s" --control skyhook
    """
    names = _names(control or ["passive"])
    if out is not None and len(names) > 1:
        raise DescriptionError(
            "one file holds one run", where="--out", found=", ".join(names), allowed="one --control with --out"
        )
    check_outputs(recording=out, figure=figure, report=report, force=force)
    study, plain, rig = _study(vehicle, road, speed, duration, seed, names, set_, trust=trust)
    if out is not None:
        from jounce.recordings import write_recording

        write_recording(study.rides[0].run, out, force=force)

    def spectra() -> Figure:
        from jounce.plots.design import ride_spectra

        return ride_spectra(study.rides, study.stationary, title)

    name = _stem(vehicle)
    driven = f"{name}, {_stem(names[0])}," if len(names) == 1 else name  # several have a legend
    title = f"{driven} on {_stem(road)} at {size(study.trial.trial.speed or 0.0, 'm/s', 'speed')}"
    drawn, missing = write_picture(spectra, figure, force=force)
    document, undrawn = write_report(lambda: _page(study, title, rig), report, force=force)
    plain = {**plain, "out": out and str(out), "figure": drawn, "report": document}
    return Reply(plain, lambda console: _draw_ride(console, plain, study), as_json, missing=[*missing, *undrawn])


def _stem(name: str) -> str:
    """What a title calls a file; other names, such as ``iso:C``, stay as they are.

    >>> _stem("cars/mine.toml"), _stem("iso:C"), _stem("audi-a6-full-car")
    ('mine', 'iso:C', 'audi-a6-full-car')
    """
    return Path(name).stem


def _page(study: RideStudy, title: str, rig: Rig) -> Page:
    from jounce.report import ride_page

    return ride_page(study, title=title, rig=rig)


_SOME = "passive, skyhook, lqr, ..."


class NamesControllers(TyperCommand):
    """A command whose help names every controller; they are loaded only when the help is shown."""

    def format_help(self, ctx: Any, formatter: Any) -> None:
        """Fill in the names of the registry."""
        from jounce.control import CONTROLS

        for parameter in self.params:
            if parameter.name == "control":
                parameter.help = str(parameter.help).replace(_SOME, ", ".join(CONTROLS))  # type: ignore[attr-defined]
        super().format_help(ctx, formatter)


def compare(
    vehicle: VehicleName,
    control: Annotated[
        list[str] | None,
        typer.Option(help=f"all, or controllers by name or file: {_SOME}. Repeat it."),
    ] = None,
    road: RideRoad = "iso:C",
    speed: RideSpeed = "20 m/s",
    duration: Annotated[
        str | None, typer.Option(help=f"Time over the road; by default 20 s on ISO roads, {_TO_THE_END}")
    ] = None,
    seed: Seed = 0,
    trust: Trust = False,
    set_: Changes = None,
    figure: FigureFile = None,
    report: ReportFile = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Compare controllers over one road: comfort, travel and road holding, as a table and a plot of the trade-off.

    Example: jounce compare audi-a6-half-car-4dof --control all --figure trade-off.png
    """
    length = duration if duration is not None else ("20 s" if road.lower().startswith("iso:") else None)
    names = _names(control or ["all"])
    check_outputs(figure=figure, report=report, force=force)
    study, plain, rig = _study(vehicle, road, speed, length, seed, names, set_, trust=trust)
    title = f"{_stem(vehicle)} on {_stem(road)} at {size(study.trial.trial.speed or 0.0, 'm/s', 'speed')}"
    drawn, missing = write_picture(study, figure, title, force=force)
    document, undrawn = write_report(lambda: _page(study, title, rig), report, force=force)
    plain = {**plain, "figure": drawn, "report": document}
    missing = [*missing, *undrawn]
    return Reply(plain, lambda console: _draw_comparison(console, plain, study), as_json, missing=missing)


def _names(given: list[str]) -> list[str]:
    """Controllers in the order given, each once; ``all`` stands for every one."""
    from jounce.ride.study import all_controls

    texts = [part.strip() for text in given for part in text.split(",") if part.strip()]
    if not texts:
        raise DescriptionError("no controller is named", where="--control", allowed="a controller, its file, or all")
    return list(dict.fromkeys(name for text in texts for name in (all_controls() if text == "all" else (text,))))


def _study(
    vehicle: str,
    road: str,
    speed: str,
    duration: str | None,
    seed: int,
    names: list[str],
    set_: list[str] | None,
    *,
    trust: bool,
) -> tuple[RideStudy, dict[str, Any], Rig]:
    """Run the study that the options describe; give it with what ``--json`` prints, and the rig."""
    seed = _seed(road, seed)
    wanted, v = changes(set_), positive_quantity(speed, "m/s", "--speed")
    lasting = optional_positive(duration, "s", "--duration")
    with progress() as say:
        say("loading")
        from jounce.ride.study import compare_rides

        rig = chosen_rig(vehicle, wanted)
        with trusting(trust):
            study = compare_rides(rig, _trial(rig, road, v, lasting, seed), names, progress=say)
    return study, {"vehicle": vehicle, "changes": wanted, "road": road, "seed": seed, **study.to_dict()}, rig


def _seed(road: str, seed: int) -> int:
    """Seed that the road (iso:C:7) or the option says."""
    from jounce.roads.loading import class_and_seed, is_class

    said = class_and_seed(road)[1] if is_class(road) else None
    if said is None or seed in (0, said):
        return seed if said is None else said
    raise DescriptionError(
        "two different seeds are given", where="--seed", found=f"{seed}, and {said} in --road {road}"
    )


def _trial(rig: Rig, road: str, speed: float, duration: float | None, seed: int) -> RideTrial:
    from jounce.ride.study import DEFAULT_DURATION, iso_trial, road_trial
    from jounce.roads import load_road
    from jounce.roads.loading import class_and_seed, is_class

    if is_class(road):
        lasting = DEFAULT_DURATION if duration is None else duration
        return iso_trial(rig, class_and_seed(road)[0], speed, duration=lasting, seed=seed)
    return road_trial(rig, load_road(road), speed, duration=duration)


def _draw_ride(console: Console, plain: dict[str, Any], study: RideStudy) -> None:
    for ride in study.rides:
        title = f"{plain['vehicle']}, {ride.control}, on {plain['road']} at {size(plain['speed'], 'm/s', 'speed')}"
        _draw_metrics(console, title, ride.metrics)
        _draw_stationary(console, study, ride)
        show_findings(console, ride.metrics.findings)
    _draw_end(console, plain, study)


def _draw_stationary(console: Console, study: RideStudy, ride: Ride) -> None:
    """Simulated beside stationary standard deviations, of the rig as it is."""
    if study.stationary is None or ride.control != "passive":
        return
    linear = study.stationary.standard_deviation
    chances = study.by_chance
    rows = [
        (
            name, study.stationary.units[name], ride.standard_deviation(name), linear[name],
            "–" if (share := chances[name]) is None else f"± {100.0 * share:.2g} %",
        )
        for name in linear
        if linear[name]
    ]  # fmt: skip
    header = ("channel", "unit", "simulated", "linear model", "by chance")
    title = f"Standard deviations: simulated over {ride.duration:.3g} s, and of the linear model over endless time"
    console.print(table(title, header, rows, text=(0, 1)))
    console.print(f"by chance: 95 % of runs of {ride.duration:.3g} s differ by no more from an endless one")
    show_findings(console, study.stationary.findings)


def _draw_comparison(console: Console, plain: dict[str, Any], study: RideStudy) -> None:
    from jounce.ride.study import MERITS

    shown = [merit for merit in MERITS if any(merit.name in ride.merits for ride in study.rides)]
    rows = [(ride.control, *(ride.merits.get(merit.name) for merit in shown)) for ride in study.rides]
    header = ("controller", *(f"{merit.label} [{merit.unit}]" for merit in shown))
    title = f"{plain['vehicle']} on {plain['road']} at {size(plain['speed'], 'm/s', 'speed')}; smaller is better"
    console.print(table(title, header, rows))
    _draw_end(console, plain, study)


def _draw_end(console: Console, plain: dict[str, Any], study: RideStudy) -> None:
    for name, reason in study.failed.items():
        console.print(f"not run: {name}: {reason}", soft_wrap=True)
    show_written(console, plain)


def ride_metrics(
    record: Annotated[
        Path, typer.Argument(metavar="RECORD", help="Recording of a ride: accelerations in the vehicle.")
    ],
    vehicle: Annotated[
        str | None, typer.Option(help="Rig or vehicle of the ride, for the gaps of its bump and rebound stops.")
    ] = None,
    settling: Annotated[str, typer.Option(help='Time at the start that does not count, e.g. "5 s".')] = "0 s",
    start: Annotated[
        str, typer.Option(help="What was before the record: rest, first or mean (for signals with gravity in them).")
    ] = "mean",
    exposure: Annotated[str, typer.Option(help="Daily duration of the vibration, for A(8).")] = "8 h",
    lift_off_load: Annotated[str, typer.Option(help="Wheel load up to which a tyre counts as lifted.")] = "0 N",
    columns_: Columns = None,
    variable: Variable = "",
    sample_time: SampleTime = None,
    resample: Resample = None,
    database: Database = None,
    as_json: AsJson = False,
) -> Reply:
    """Give ride metrics of a measured (or simulated) record: weighted accelerations, travel, road holding.

    Level and spectrum tell some of what can be wrong: filters, coarse steps, exchanged channels, m/s² called g.

    Example: jounce ride-metrics lap.csv --columns seat.az="AccZ [g]" --settling "5 s"
    """
    read = reading(columns_, sample_time, variable, resample, database)
    before = quantity(settling, "s", "--settling")
    daily, load = positive_quantity(exposure, "s", "--exposure"), quantity(lift_off_load, "N", "--lift-off-load")
    from jounce.core.serialise import to_plain
    from jounce.recordings import read_recording
    from jounce.ride.metrics import ride_metrics as metrics_of

    run, notes = read_recording(record, **read)
    rig = None if vehicle is None else chosen_rig(vehicle, {})
    found = metrics_of(run, rig, settling=before, start=start, exposure=daily, lift_off_load=load)  # type: ignore[arg-type]
    values: dict[str, dict[str, float]] = {}
    for item in found.values:
        values.setdefault(item.metric, {})[item.place] = item.value
    known = {(one.severity, one.message) for one in notes}
    findings = [*notes, *(one for one in found.findings if (one.severity, one.message) not in known)]
    plain = {
        "record": str(record), "vehicle": vehicle, "duration": found.duration, "settling": found.settling,
        "sample_rate": found.sample_rate, "metrics": values, "comfort": found.comfort,
        "absent": to_plain(found.absent), "findings": to_plain(findings),
    }  # fmt: skip

    def draw(console: Console) -> None:
        _draw_metrics(console, f"{record}, {found.duration:g} s at {found.sample_rate:g} Hz", found)
        show_findings(console, findings)

    return Reply(plain, draw, as_json)


def _draw_metrics(console: Console, title: str, metrics: RideMetrics) -> None:
    rows, last = [], ""
    for item in metrics.values:
        rows.append((item.label if item.label != last else "", item.place, item.value, item.unit))
        last = item.label
    console.print(table(title, ("metric", "place", "value", "unit"), rows, text=(0, 1, 3)))
    for place, words in metrics.comfort.items():
        console.print(f"{place}: {words}")
