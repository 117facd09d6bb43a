"""``jounce plot``, ``jounce draw`` and ``jounce animate``: signals, and 3-D rigs at rest and in motion."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import (
    AsJson,
    Changes,
    Columns,
    Database,
    DrivenSpeed,
    Duration,
    ExcitationFile,
    FigureFile,
    Force,
    ReportFile,
    Resample,
    RigName,
    RoadName,
    SampleTime,
    Variable,
    changes,
    check_outputs,
    optional_positive,
    optional_quantity,
    reading,
)
from jounce.cli.reply import DONE, REFUSED, Reply, progress, show_findings, show_written, tell
from jounce.core.errors import DescriptionError, OutputError
from jounce.core.phrases import Phrase
from jounce.core.typed import positive_quantity, quantity

if TYPE_CHECKING:
    import numpy as np
    import xarray as xr
    from numpy.typing import NDArray
    from rich.console import Console

    from jounce.core.findings import Finding
    from jounce.parts.corners import Corner
    from jounce.roads import Trial


def plot(
    run: Annotated[
        Path,
        typer.Argument(metavar="RUN", help="A recording: .nc of `jounce simulate`, .csv, .mat ..."),
    ],
    channels: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="RUN|CHANNEL",
            help="More recordings, to compare them; channels to plot, from top to bottom.",
            show_default=False,
        ),
    ] = None,
    figure: FigureFile = None,
    report: ReportFile = None,
    columns_: Columns = None,
    variable: Variable = "",
    sample_time: SampleTime = None,
    resample: Resample = None,
    database: Database = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Plot channels of a recording against time, or compare several: one picture with differences, or a page.

    Example: jounce plot run.nc sprung.az unsprung.az --figure accelerations.png
    """
    from jounce.core.serialise import to_plain

    if figure is None and report is None:
        raise DescriptionError(
            "nothing to write", where="jounce plot", allowed="--figure FILE, --report FILE"
        )
    check_outputs(figure=figure, report=report, force=force)
    from jounce.plots.comparison import common_channels

    more = [Path(name) for name in channels or [] if _is_file(name)]
    wanted = [name for name in channels or [] if not _is_file(name)] or None
    options = reading(columns_, sample_time, variable, resample, database)
    runs, findings = _recordings([run, *more], options)
    drawn = wanted or common_channels(runs, None)
    if figure is not None:
        from jounce.plots.comparison import compare
        from jounce.plots.figures import FIGURES
        from jounce.plots.signals import time_history

        picture = compare(runs, wanted) if more else time_history(runs[next(iter(runs))], wanted)
        FIGURES.write(picture, figure, force=force)
        drawn = drawn if more or wanted else [axes.get_title("left") for axes in picture.axes]
    if report is not None:
        from jounce.report import REPORTS, recordings_page

        title = " and ".join(runs) if len(runs) < _MANY else f"{len(runs)} recordings"
        REPORTS.write(
            recordings_page(runs, wanted, title=title, findings=findings), report, force=force
        )
    written = [str(file) for file in (figure, report) if file is not None]
    plain = {
        "run": str(run),
        "runs": [str(run), *map(str, more)],
        "channels": drawn,
        "out": figure and str(figure),
    }
    plain |= {"report": report and str(report), "findings": to_plain(findings)}

    def draw(console: Console) -> None:
        console.print(f"{', '.join(drawn)}\nwritten: {', '.join(written)}")
        show_findings(console, findings)

    return Reply(plain, draw, as_json)


_MANY = 4


def _is_file(name: str) -> bool:
    """Whether an argument names a recording rather than a channel."""
    from jounce.recordings.readers import READERS

    suffix = Path(name).suffix.lower()
    return Path(name).is_file() or any(suffix in known.suffixes for known in READERS)


def _recordings(
    files: list[Path], options: dict[str, Any]
) -> tuple[dict[str, xr.Dataset], list[Finding]]:
    """Read recordings; return them by their shortest distinct names, with their findings."""
    from jounce.core.findings import at_place
    from jounce.recordings import read_recording

    stems = [file.stem for file in files]
    names = [str(file) if stems.count(file.stem) > 1 else file.stem for file in files]
    runs: dict[str, xr.Dataset] = {}
    findings: list[Finding] = []
    for name, file in zip(names, files, strict=True):
        runs[name], advice = read_recording(file, **options)
        place = f"{name}: " if len(files) > 1 else ""
        findings += [at_place(f"{place}{finding.place}", finding) for finding in advice]
    return runs, findings


_MOST_POSES = 9
_WAY = 41

Travel = Annotated[
    str | None,
    typer.Option(help='Wheel travel, bump positive: "-50 mm:50 mm:2 mm", or a single value.'),
]
Rack = Annotated[
    str | None, typer.Option(help="Rack travel, positive to the left: a range, or a single value.")
]


def draw(
    rig: RigName,
    figure: Annotated[
        Path | None,
        typer.Option(
            help="Picture to write: .png, .svg or .pdf; by default the name of the rig with .png."
        ),
    ] = None,
    travel: Travel = None,
    rack: Rack = None,
    names: Annotated[bool, typer.Option("--names/--no-names", help="Label the hardpoints.")] = True,
    centres: Annotated[
        bool,
        typer.Option(
            "--centres",
            help="Draw instant centres, roll centre and steering axis at design instead.",
        ),
    ] = False,
    set_: Changes = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Draw a 3-D rig in three views and in perspective; --travel or --rack add poses to the design position.

    Example: jounce draw kart-double-wishbone --travel "-20 mm:20 mm:20 mm" --figure kart.png
    """
    from jounce.plots.figures import FIGURES

    file = FIGURES.check(f"{Path(rig).stem}.png" if figure is None else figure, force=force)
    with progress() as say:
        say("loading")
        chosen, wanted = _rig(rig, set_)
        from jounce.plots.mechanisms.drawing import mechanism

        title = Path(rig).stem
        if centres and (travel is not None or rack is not None):
            raise DescriptionError(
                "instant centres are drawn only in the design position",
                where="--centres",
                hint="Leave out --travel and --rack.",
            )
        if centres:
            from jounce.plots.mechanisms.geometry import suspension_geometry

            FIGURES.write(suspension_geometry(chosen, title=title), file, force=force)
        elif travel is None and rack is None:
            FIGURES.write(mechanism(chosen, names=names, title=title), file, force=force)
        if travel is None and rack is None:
            plain = {"rig": rig, "changes": wanted, "poses": [], "out": str(file)}
            return Reply(plain, lambda console: show_written(console, plain), as_json)
        say("sweeping")
        sweep, at = _few_poses(chosen, travel, rack)
        say("drawing")
        FIGURES.write(
            mechanism(chosen, sweep, list(at), names=names, title=title), file, force=force
        )
    plain = {"rig": rig, "changes": wanted, "poses": at.tolist(), "out": str(file)}
    return Reply(
        plain, lambda console: show_written(console, plain), as_json, _report_early_end(sweep)
    )


def animate(
    rig: RigName,
    report: Annotated[
        Path | None,
        typer.Option(help="Page to write: .html, which opens anywhere: turn, play, read values."),
    ] = None,
    figure: Annotated[
        Path | None, typer.Option(help="Film to write: .gif, or .mp4 (needs ffmpeg).")
    ] = None,
    travel: Travel = None,
    rack: Rack = None,
    road: RoadName = None,
    speed: DrivenSpeed = None,
    duration: Duration = None,
    excitation: ExcitationFile = None,
    between: Annotated[
        str | None,
        typer.Option(
            metavar="FIRST:LAST",
            help='Show only part of the motion: "0.1 s:0.4 s", or a range of travel.',
        ),
    ] = None,
    slow: Annotated[str, typer.Option(help="Slow-motion factor of a run.")] = "5",
    frames: Annotated[
        int | None,
        typer.Option(
            min=1, help="Maximum number of poses; by default 1000 in a page, 300 in a film."
        ),
    ] = None,
    set_: Changes = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Show a 3-D rig in motion: swept over --travel or --rack, or driven over a --road or an --excitation.

    Example: jounce animate kart-double-wishbone --travel "-20 mm:20 mm:1 mm" --report motion.html
    """
    from jounce.report.animation import animate as write_animation
    from jounce.roads.trial import trial_findings

    files = _animations(report, figure, force=force)
    slower = positive_quantity(slow, "1", "--slow")
    driven = _build_trial(travel, rack, road, speed, duration, excitation)
    with progress() as say:
        say("loading")
        chosen, wanted = _rig(rig, set_)
        say("simulating" if driven else "sweeping")
        from jounce.simulation import simulate

        poses = (
            simulate(chosen, driven, detail=True)
            if driven
            else _sweep(chosen, _ranges(travel, rack))
        )
        part = None if between is None else _ends(between, "s" if driven else "m")
        title = (
            Path(rig).stem
            if driven is None
            else f"{Path(rig).stem} on {Path(str(excitation or road)).stem}"
        )
        for file in files:
            write_animation(
                chosen,
                poses,
                file,
                trial=driven,
                between=part,
                slow=slower,
                frames=frames,
                title=title,
                force=force,
                progress=say,
            )
    findings = [] if driven is None else trial_findings(driven)
    over = next(name for name in ("time", "rack_travel", "wheel_travel") if name in poses.sizes)
    plain = {
        "rig": rig,
        "changes": wanted,
        "over": over,
        "poses": poses.sizes[over],
        "findings": findings,
    }
    plain["out"] = str(files[0])
    plain |= {"report": report and str(report), "figure": figure and str(figure)}

    def tell(console: Console) -> None:
        for file in files:
            console.print(f"written: {file}", soft_wrap=True)
        show_findings(console, findings)

    return Reply(plain, tell, as_json, _report_early_end(poses))


def _animations(report: Path | None, figure: Path | None, *, force: bool) -> list[Path]:
    """Check in advance that the requested files can be written, and return them."""
    from jounce.report.animation import check_animation

    for option, file, allowed in (
        ("--report", report, (".html",)),
        ("--figure", figure, (".gif", ".mp4")),
    ):
        if file is not None and file.suffix.lower() not in allowed:
            raise OutputError(
                "animations are not written in this format",
                where=option,
                found=str(file),
                allowed=", ".join(allowed),
            )
    animated = [check_animation(file, force=force) for file in (report, figure) if file is not None]
    if not animated:
        raise DescriptionError(
            "nothing to write",
            where="jounce animate",
            allowed="--report FILE.html, --figure FILE.gif",
        )
    return animated


def _rig(name: str, set_: list[str] | None) -> tuple[Corner, dict[str, Any]]:
    """Load a rig that can be drawn."""
    from jounce.parts import load
    from jounce.plots.mechanisms.scene import require_corner

    wanted = changes(set_)
    chosen = load(name)
    return require_corner(chosen.with_changes(wanted) if wanted else chosen), wanted


def _build_trial(
    travel: str | None,
    rack: str | None,
    road: str | None,
    speed: str | None,
    duration: str | None,
    excitation: Path | None,
) -> Trial | None:
    """Build the trial; ``None`` for a sweep."""
    swept = travel is not None or rack is not None
    given = any(option is not None for option in (road, speed, duration, excitation))
    if swept and given:
        raise DescriptionError(
            "both a sweep and a run are given",
            where="jounce animate",
            allowed="--travel and --rack, or --road, --speed and --duration, or --excitation",
        )
    if not swept and not given:
        example = '--travel "-50 mm:50 mm:2 mm", or --road ROAD --speed "1.95 m/s" --duration "3 s"'
        raise DescriptionError("no motion is given", where="jounce animate", allowed=example)
    if swept:
        return None
    from jounce.roads.options import trial_of_options

    seconds = optional_positive(duration, "s", "--duration")
    file = None if excitation is None else str(excitation)
    return trial_of_options(road, optional_quantity(speed, "m/s", "--speed"), seconds, file)


def _sweep(rig: Corner, ranges: dict[str, NDArray[np.float64]]) -> xr.Dataset:
    """Sweep --travel or --rack; the other one is constant."""
    from jounce.kinematics import sweep_rack, sweep_travel

    travel, rack = ranges.get("--travel"), ranges.get("--rack")
    if travel is not None and rack is not None and min(len(travel), len(rack)) > 1:
        raise DescriptionError(
            "only one motion can be swept",
            where="--travel, --rack",
            hint="Give a single value for one of them.",
        )
    if rack is not None and (travel is None or len(travel) == 1):
        return sweep_rack(rig, rack, 0.0 if travel is None else float(travel[0]), points=True)
    assert travel is not None
    return sweep_travel(rig, travel, None if rack is None else float(rack[0]), points=True)


def _ranges(travel: str | None, rack: str | None) -> dict[str, NDArray[np.float64]]:
    from jounce.kinematics.sweeps import text_range

    texts = {"--travel": travel, "--rack": rack}
    return {
        option: text_range(text, "m", option) for option, text in texts.items() if text is not None
    }


def _few_poses(
    rig: Corner, travel: str | None, rack: str | None
) -> tuple[xr.Dataset, NDArray[np.float64]]:
    """Sweep finely for the paths of wheel centre and contact point, and return the poses to draw."""
    import numpy as np

    values = _ranges(travel, rack)
    moved = "--travel" if len(values.get("--travel", ())) > 1 or rack is None else "--rack"
    at = values[moved]
    if len(at) > _MOST_POSES:
        raise DescriptionError(
            "too many poses for one picture",
            where=moved,
            found=len(at),
            allowed=Phrase("at most {most_poses}", most_poses=_MOST_POSES),
            hint="Use larger steps, or jounce animate.",
        )
    fine = np.unique(np.round([*at, *np.linspace(at[0], at[-1], _WAY)], 9)) if len(at) > 1 else at
    sweep = _sweep(rig, {**values, moved: fine})
    reached = sweep["rack_travel" if moved == "--rack" else "wheel_travel"].to_numpy()
    return sweep, at[(at >= reached.min() - 1e-9) & (at <= reached.max() + 1e-9)]


def _ends(text: str, unit: str) -> tuple[float, float]:
    first, colon, last = text.partition(":")
    if not colon or not first.strip() or not last.strip():
        raise DescriptionError(
            "invalid range", where="--between", found=text, allowed='"first:last"'
        )
    return quantity(first.strip(), unit, "--between"), quantity(last.strip(), unit, "--between")


def _report_early_end(poses: xr.Dataset) -> int:
    """Print why a sweep ended early; return the exit code."""
    why = str(poses.attrs.get("stopped", ""))
    if why:
        tell(f"{why}. The poses before that are shown.")
    return REFUSED if why else DONE
