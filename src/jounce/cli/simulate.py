"""``jounce simulate`` and ``jounce modes``: one rig or vehicle on one trial, and about static equilibrium."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, cast

import typer

from jounce.cli.options import (
    STEP,
    AsJson,
    Changes,
    Deceleration,
    DrivenSpeed,
    Duration,
    ExcitationFile,
    FigureFile,
    Force,
    LateralAcceleration,
    PitchMoment,
    ReportFile,
    RightRoad,
    RigName,
    RoadName,
    changes,
    check_outputs,
    chosen_rig,
    trial_of,
    write_picture,
    write_report,
)
from jounce.cli.reply import Reply, progress, show_findings, show_written, table
from jounce.core.display import size
from jounce.core.typed import positive_quantity

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from rich.console import Console

    from jounce.core.findings import Finding
    from jounce.parts import Rig
    from jounce.report import Page
    from jounce.roads import Trial
    from jounce.simulation.run import Solved
    from jounce.simulation.settings import Method


def simulate(
    rig: RigName,
    road: RoadName = None,
    speed: DrivenSpeed = None,
    duration: Duration = None,
    excitation: ExcitationFile = None,
    right_road: RightRoad = None,
    pitch_moment: PitchMoment = None,
    deceleration: Deceleration = None,
    lateral_acceleration: LateralAcceleration = None,
    set_: Changes = None,
    output_step: Annotated[str, typer.Option(help="Time step of the output.")] = "1 ms",
    tolerance: Annotated[str, typer.Option(help="Relative error of displacements.")] = "1e-5",
    method: Annotated[str, typer.Option(help="Integration method: auto, explicit, or implicit (stiff rigs).")] = "auto",
    out: Annotated[
        Path | None, typer.Option(help="Write the recording: RUN.nc, .csv, .mat, .mf4, .parquet or .xlsx.")
    ] = None,
    figure: FigureFile = None,
    report: ReportFile = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Simulate a rig or vehicle on a road or a shaker, starting from static equilibrium.

    Example: jounce simulate kart-quarter-car --road bump.toml --speed "1.95 m/s" --duration "3 s" --out run.nc
    """
    check_outputs(recording=out, figure=figure, report=report, force=force)
    step = positive_quantity(output_step, "s", "--output-step", most=STEP)
    error = positive_quantity(tolerance, "1", "--tolerance")
    loads = {
        "pitch_moment": pitch_moment,
        "deceleration": deceleration,
        "lateral_acceleration": lateral_acceleration,
    }
    trial = trial_of(road, excitation, speed, duration, where="jounce simulate", right=right_road, loads=loads)
    with progress() as say:
        say("loading")
        from jounce.roads.trial import trial_findings
        from jounce.simulation.run import solved
        from jounce.simulation.settings import RunSettings

        wanted = changes(set_)
        chosen = chosen_rig(rig, wanted)
        say("simulating")
        run = solved(chosen, trial, RunSettings(step, error, cast("Method", method)))
        if out is not None:
            from jounce.recordings import write_recording

            write_recording(run.recording(), out, force=force)
        findings = trial_findings(trial, chosen, output_step=step)
        at = "" if trial.speed is None else f" at {size(trial.speed, 'm/s', 'speed')}"
        on = f"{Path(str(excitation or road)).stem}{at}"
        drawn, missing = write_picture(_picture(run), figure, f"{Path(rig).stem} on {on}", force=force)
        page, undrawn = write_report(lambda: _page(rig, chosen, run, trial, findings, on), report, force=force)
    setup: dict[str, Any] = {"rig": rig, "changes": wanted, "road": road, "right_road": right_road, "loads": loads}
    setup |= {"excitation": excitation and str(excitation)}
    plain = {**setup, **_summary(run, trial), "findings": findings, "out": out and str(out)}
    plain |= {"figure": drawn, "report": page}
    return Reply(plain, lambda console: _draw(console, plain, findings), as_json, missing=[*missing, *undrawn])


def _picture(run: Solved) -> Callable[[], Figure]:
    def drawn() -> Figure:
        from jounce.plots import time_history

        return time_history(run.recording())

    return drawn


def _page(rig: str, chosen: Rig, run: Solved, trial: Trial, findings: list[Finding], on: str) -> Page:
    from jounce.report import recordings_page

    name = Path(rig).stem
    return recordings_page(
        {name: run.recording()},
        title=f"{name} on {on}",
        subtitle=f"Simulation of {trial.duration:g} s",
        rig=chosen,
        trial=trial,
        findings=findings,
    )


def _summary(run: Solved, trial: Trial) -> dict[str, Any]:
    """What a recording would hold: extremes of every channel with their times, and the rest that it starts from."""
    from jounce.recordings.schema import extremes

    return {
        "speed": trial.speed,
        "duration": trial.duration,
        "samples": len(run.time),
        "status": run.attributes["status"],
        "method": run.attributes["method"],
        "steps": run.attributes["steps"],
        "events": run.attributes["events"],
        "channels": extremes(run.time, run.channels),
    }


def _draw(out: Console, plain: dict[str, Any], findings: list[Finding]) -> None:
    on = plain["excitation"] or f"{plain['road']} at {size(plain['speed'], 'm/s', 'speed')}"
    header = ("channel", "unit", "static", "minimum", "at s", "maximum", "at s")
    rows = [(name, *channel.values()) for name, channel in plain["channels"].items()]
    out.print(table(f"{plain['rig']} on {on}, {plain['duration']:g} s", header, rows, text=(0, 1)))
    events = "event" if plain["events"] == 1 else "events"
    out.print(
        f"{plain['samples']} samples, {plain['method']} method, {plain['steps']} steps, {plain['events']} {events} "
        "(tyre lift-off or landing, contact with a stop)"
    )
    show_findings(out, findings)
    show_written(out, plain)
