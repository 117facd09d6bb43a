"""``jounce study``: shipped studies, on real measurements and of models."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli import study_audi, study_inspection
from jounce.cli.options import AsJson, Force, RigName, positive_quantity
from jounce.cli.outputs import check_outputs
from jounce.cli.reply import Reply, progress
from jounce.cli.tables import show_findings, table

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.papers.proving_ground import ProvingGround

app = typer.Typer(no_args_is_help=True, help="Shipped studies.")
study_audi.register(app)
study_inspection.register(app)
_SPEEDS = ("1.95 m/s", "2.86 m/s", "3.79 m/s")


@app.callback()
def _study() -> None:
    """Keep the name of a study part of the command even where there is only one."""


@app.command("proving-ground")
def proving_ground(
    out: Annotated[Path | None, typer.Option(help="Folder for report, figures and results.json.")] = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Drive a real vehicle with a measured damper over a measured course; without --out nothing is written.

    Example: jounce study proving-ground --out proving-ground
    """
    check_outputs(folder=out, force=force)
    with progress() as say:
        from jounce.papers.proving_ground import run_proving_ground

        study = run_proving_ground(progress=say)
        if out is not None:
            from jounce.report import write_page
            from jounce.report.proving_ground import proving_ground_page

            write_page(proving_ground_page(study), out, force=force, progress=say)
    plain = {**study.to_dict(), "out": None if out is None else str(out)}
    return Reply(plain, lambda console: _draw(console, plain, study, out), as_json)


@app.command("lumped-vs-spatial")
def lumped_vs_spatial(
    rig: RigName,
    lumped: Annotated[
        str | None, typer.Option(help="A quarter car to compare; without it the one that the rig amounts to at rest.")
    ] = None,
    road: Annotated[str | None, typer.Option(help="A road: file, or a name of `jounce library`.")] = None,
    speed: Annotated[list[str] | None, typer.Option(help='Speed over the road, e.g. "1.95 m/s". Repeat it.')] = None,
    duration: Annotated[str, typer.Option(help="Length of each run.")] = "2 s",
    as_json: AsJson = False,
) -> Reply:
    """Say where a lumped quarter car differs from a rig in 3-D, and why.

    Example: jounce study lumped-vs-spatial kart-double-wishbone --lumped kart-quarter-car
    """
    trials = _trials(road, speed or list(_SPEEDS), positive_quantity(duration, "s", "--duration"))
    with progress() as say:
        say("loading")
        from jounce.design.model_comparison import compare_models
        from jounce.parts import load

        pair = load(rig), None if lumped is None else load(lumped)
        say("comparing")
        found = compare_models(*pair, trials)
    plain = {"rig": rig, "lumped_rig": lumped, **found.to_dict()}
    return Reply(plain, lambda console: _draw_models(console, plain), as_json)


def _trials(road: str | None, speeds: list[str], duration: float) -> dict[str, Any]:
    """Give trials by name; without a road over the bench's obstacle (estimated: 10 mm high, 60 mm long)."""
    from jounce.roads import HalfSine, Trial, load_road

    course = HalfSine(height=0.010, length=0.060, start=0.2) if road is None else load_road(road)
    return {
        text: Trial(road=course, speed=positive_quantity(text, "m/s", "--speed"), duration=duration) for text in speeds
    }


def _draw_models(console: Console, plain: dict[str, Any]) -> None:
    other = plain["lumped_rig"] or "the quarter car it amounts to at rest"
    rows = [(row["quantity"], row["unit"], row["spatial"], row["lumped"], row["why"]) for row in plain["rows"]]
    header = ("about rest", "unit", "3-D", "lumped", "why")
    console.print(table(f"{plain['rig']} and {other}", header, rows, text=(0, 1, 4)))
    curve = zip(plain["travel"], plain["motion_ratio"], plain["wheel_rate"], strict=True)
    points = [
        (1e3 * travel, ratio, plain["lumped_motion_ratio"], rate, plain["lumped_wheel_rate"])
        for travel, ratio, rate in list(curve)[::3]
    ]
    columns = ("travel mm", "motion ratio 3-D", "lumped", "wheel rate 3-D N/m", "lumped")
    console.print(table("Over travel", columns, points, text=()))
    peaks = [
        (peak["trial"], peak["channel"], peak["unit"], peak["spatial"], peak["lumped"], 100.0 * peak["relative"])
        for peak in plain["peaks"]
    ]
    names = ("trial", "largest", "unit", "3-D", "lumped", "difference %")
    console.print(table("Peaks", names, peaks, text=(0, 1, 2)))


def _draw(console: Console, plain: dict[str, Any], study: ProvingGround, out: Path | None) -> None:
    rows = [
        (record, law, 100.0 * fit["nrmse"], fit["r2"])
        for record, laws in plain["damper_fits"].items()
        for law, fit in laws.items()
    ]
    console.print(table("Measured damper", ("record", "law", "NRMSE %", "R2"), rows, text=(0, 1)))
    model = [
        (item["name"], item["value"], item["unit"], "estimated" if item["is_estimated"] else "")
        for item in plain["model"]
    ]
    console.print(table("Quarter car (SI)", ("quantity", "value", "unit", ""), model, text=(0, 2, 3)))
    rows = [
        (name, damper, *values) for name, by_damper in plain["figures"].items() for damper, values in by_damper.items()
    ]
    header = ("figure (SI)", "damper", *(f"{3.6 * speed:.0f} km/h" for speed in plain["speed"]))
    console.print(table("Ride over the measured course, unweighted", header, rows, text=(0, 1)))
    show_findings(console, study.findings)
    console.print(
        "nothing was written: give --out DIR" if out is None else f"written: {out}, open {out / 'report.html'}"
    )
