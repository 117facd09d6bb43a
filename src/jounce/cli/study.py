"""``jounce study``: shipped studies, on real measurements, of models, of shock-absorber tests, and of the papers."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import (
    STROKE,
    AsJson,
    Changes,
    FigureFile,
    Force,
    NumbersFile,
    ReportFile,
    RigName,
    changes,
    check_numbers,
    check_outputs,
    chosen_rig,
    write_numbers,
    write_picture,
    write_report,
)
from jounce.cli.reply import Reply, drawing, progress, show_findings, show_written, table
from jounce.core.typed import positive_quantity, quantity

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.core.findings import Finding
    from jounce.inspection.equivalence import Equivalence, Factor
    from jounce.papers.audi_a6_paper import Erratum
    from jounce.papers.proving_ground import ProvingGround
    from jounce.report import Page


app = typer.Typer(no_args_is_help=True, help="Shipped studies.")
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
    """Drive a real vehicle with a measured damper over a measured course. Without --out nothing is written.

    Example: jounce study proving-ground --out proving-ground
    """
    check_outputs(folder=out, force=force)
    with progress() as say:
        from jounce.papers.proving_ground import run_proving_ground

        study = run_proving_ground(progress=say)
        missing = _write(study, out, "proving_ground", say, force=force)
    plain = {**study.to_dict(), "out": None if out is None else str(out)}
    return Reply(plain, lambda console: _draw(console, plain, study, out), as_json, missing=missing)


def _write(study: object, out: Path | None, name: str, say: Callable[[str], None], *, force: bool) -> Sequence[Finding]:
    """Write what a study found, and then its page, into a folder if one is given; give what could not be drawn."""
    if out is None:
        return ()
    from jounce.report import papers, write_page
    from jounce.report.render import figures_here

    files = getattr(papers, f"{name}_files")(study)
    with drawing() as missing:
        page = getattr(papers, f"{name}_page")
        write_page(lambda: page(study), out, files=files, force=force, figures=figures_here(), progress=say)
    return missing


@app.command("lumped-vs-spatial")
def lumped_vs_spatial(
    rig: RigName,
    lumped: Annotated[
        str | None, typer.Option(help="Quarter car to compare; by default the equivalent of the rig at equilibrium.")
    ] = None,
    road: Annotated[str | None, typer.Option(help="A road: file, or a name of `jounce library`.")] = None,
    speed: Annotated[list[str] | None, typer.Option(help='Speed over the road, e.g. "1.95 m/s". Repeat it.')] = None,
    duration: Annotated[str, typer.Option(help="Length of each run.")] = "2 s",
    out: NumbersFile = None,
    figure: FigureFile = None,
    report: ReportFile = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Show where a lumped quarter car differs from a 3-D rig, and why.

    Example: jounce study lumped-vs-spatial kart-double-wishbone --lumped kart-quarter-car
    """
    check_numbers(out, force=force)
    check_outputs(figure=figure, report=report, force=force)
    trials = _trials(road, speed or list(_SPEEDS), positive_quantity(duration, "s", "--duration"))
    with progress() as say:
        say("loading")
        from jounce.design.model_comparison import compare_models
        from jounce.parts import load

        pair = load(rig), None if lumped is None else load(lumped)
        say("comparing")
        found = compare_models(*pair, trials)
        plain = {"rig": rig, "lumped_rig": lumped, **found.to_dict()}
        other = "its equivalent quarter car" if lumped is None else Path(lumped).stem
        title = f"{Path(rig).stem} and {other}"

        def page() -> Page:
            from jounce.report import model_comparison_page

            return model_comparison_page(found, title=title, rig=pair[0])

        written = write_numbers(plain, plain["rows"], out, force=force)
        drawn, missing = write_picture(found, figure, title, force=force)
        document, undrawn = write_report(page, report, force=force)
    plain |= {"out": written, "figure": drawn, "report": document}
    return Reply(plain, lambda console: _draw_models(console, plain), as_json, missing=[*missing, *undrawn])


def _trials(road: str | None, speeds: list[str], duration: float) -> dict[str, Any]:
    """Give trials by name; without a road over the bench's obstacle (estimated: 10 mm high, 60 mm long)."""
    from jounce.roads import HalfSine, Trial, load_road

    course = HalfSine(height=0.010, length=0.060, start=0.2) if road is None else load_road(road)
    return {
        text: Trial(road=course, speed=positive_quantity(text, "m/s", "--speed"), duration=duration) for text in speeds
    }


def _draw_models(console: Console, plain: dict[str, Any]) -> None:
    other = plain["lumped_rig"] or "its equivalent quarter car"
    rows = [(row["quantity"], row["unit"], row["spatial"], row["lumped"], row["why"]) for row in plain["rows"]]
    header = ("at equilibrium", "unit", "3-D", "lumped", "reason")
    console.print(table(f"{plain['rig']} and {other}", header, rows, text=(0, 1, 4)))
    curve = zip(plain["travel"], plain["motion_ratio"], plain["wheel_rate"], strict=True)
    points = [
        (1e3 * travel, ratio, plain["lumped_motion_ratio"], rate, plain["lumped_wheel_rate"])
        for travel, ratio, rate in list(curve)[::3]
    ]
    columns = ("travel mm", "motion ratio 3-D", "lumped", "wheel rate 3-D N/m", "lumped N/m")
    console.print(table("Over travel", columns, points, text=()))
    peaks = [
        (peak["trial"], peak["channel"], peak["unit"], peak["spatial"], peak["lumped"], 100.0 * peak["relative"])
        for peak in plain["peaks"]
    ]
    names = ("trial", "peak of", "unit", "3-D", "lumped", "difference %")
    console.print(table("Peaks", names, peaks, text=(0, 1, 2)))
    show_written(console, plain)


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
    console.print(table("Quarter car", ("quantity", "value", "unit", ""), model, text=(0, 2, 3)))
    rows = [
        (name, damper, *values) for name, by_damper in plain["figures"].items() for damper, values in by_damper.items()
    ]
    header = ("metric (SI)", "damper", *(f"{3.6 * speed:.0f} km/h" for speed in plain["speed"]))
    console.print(table("Ride metrics over the measured course, unweighted", header, rows, text=(0, 1)))
    show_findings(console, study.findings)
    console.print(
        "nothing was written; give --out DIR to keep the results"
        if out is None
        else f"written: {out}, open {out / 'report.html'}"
    )


Out = Annotated[Path | None, typer.Option(help="Folder for report, figures, curves (CSV, netCDF) and results.json.")]


@app.command("audi-a6-case-a")
def case_a(out: Out = None, force: Force = False, as_json: AsJson = False) -> Reply:
    """Brake the paper's Audi A6 onto a 5 cm obstacle, in three variants. Without --out nothing is written.

    Example: jounce study audi-a6-case-a --out case-a
    """
    return _case("case-a", out, force, as_json)


@app.command("audi-a6-case-b")
def case_b(out: Out = None, force: Force = False, as_json: AsJson = False) -> Reply:
    """Accelerate the paper's Audi A6 into a 2 cm pothole, in three variants. Without --out nothing is written.

    Example: jounce study audi-a6-case-b --json
    """
    return _case("case-b", out, force, as_json)


@app.command("audi-a6-excenter")
def exciter(
    amplitude: Annotated[str, typer.Option(help="Of the exciter: half the stroke. Estimated.")] = "3 mm",
    plate_mass: Annotated[str, typer.Option(help="Mass of the plate. Estimated.")] = "20 kg",
    out: Out = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Put the paper's front corner on a driven plate, in three models. Without --out nothing is written.

    Example: jounce study audi-a6-excenter --amplitude "3 mm"
    """
    size = positive_quantity(amplitude, "m", "--amplitude", most=STROKE)
    mass = quantity(plate_mass, "kg", "--plate-mass")
    check_outputs(folder=out, force=force)
    with progress() as say:
        from jounce.papers.audi_a6_exciter import run_eccentric_exciter

        study = run_eccentric_exciter(size, mass, progress=say)
        missing = _write(study, out, "exciter", say, force=force)
    plain = {**study.to_dict(), "out": None if out is None else str(out)}

    def draw(console: Console) -> None:
        _draw_exciter(console, plain)
        _end(console, study.errata, study.findings, out)

    return Reply(plain, draw, as_json, missing=missing)


def _case(name: str, out: Path | None, force: bool, as_json: bool) -> Reply:
    check_outputs(folder=out, force=force)
    with progress() as say:
        from jounce.papers.audi_a6 import run_audi_a6

        study = run_audi_a6(name, progress=say)
        missing = _write(study, out, "audi_case", say, force=force)
    plain = {**study.to_dict(), "out": None if out is None else str(out)}

    def draw(console: Console) -> None:
        _draw_case(console, plain, study.case.title)
        _end(console, study.errata, study.findings, out)

    return Reply(plain, draw, as_json, missing=missing)


def _draw_case(console: Console, plain: dict[str, Any], title: str) -> None:
    rows = [
        (
            run["variant"],
            f"{z['start']:g}-{z['end']:g}",
            *(part for window in (z, theta) for part in _extremes(window)),
        )
        for run in plain["runs"]
        for z, theta in zip(run["outputs"]["z"]["windows"], run["outputs"]["theta"]["windows"], strict=True)
    ]
    names = (f"{what} {end} {unit}" for what, unit in (("z", "mm"), ("theta", "mrad")) for end in ("min", "max"))
    header = ("variant", "window s", *(text for name in names for text in (name, "at s")))
    size = len(rows) // len({run["moment"] for run in plain["runs"]})
    console.print(f"{title}. z up and theta nose down are changes from static equilibrium.")
    for first, moment in enumerate(dict.fromkeys(run["moment"] for run in plain["runs"])):
        caption = f"Pitch moment {moment:.6g} N m from 3 s on"
        console.print(table(caption, header, rows[first * size : (first + 1) * size], text=(0, 1)))
    rest = plain["runs"][0]["statics"]
    axles = [(name, *rest[name].values()) for name in ("front", "rear")]
    caption = f"Static: z {1e3 * rest['z']:.5f} mm, theta {1e3 * rest['theta']:.5f} mrad"
    console.print(table(caption, ("axle", "force N", "per wheel N", "compression m"), axles))
    rows = [(mode["frequency_hz"], mode["damped_frequency_hz"], mode["damping_ratio"]) for mode in plain["modes"]]
    console.print(table("Modes", ("natural frequency Hz", "damped Hz", "damping ratio"), rows, text=()))


def _extremes(window: dict[str, float]) -> Iterable[str]:
    for end in ("min", "max"):
        yield f"{1e3 * window[end] + 0.0:.3f}".replace("-0.000", "0.000")
        yield f"{window[f't_{end}']:.3f}"


def _draw_exciter(console: Console, plain: dict[str, Any]) -> None:
    rows = [
        (
            run["variant"],
            1e3 * run["statics"]["spring_compression"],
            1e3 * run["statics"]["compression"],
            1e3 * run["statics"]["spring_length"],
            1e3 * run["spring_length"]["min"],
            1e3 * run["spring_length"]["max"],
            "; ".join(f"{mode['frequency_hz']:.5g} Hz {mode['damping_ratio']:.4f}" for mode in run["modes"]),
        )
        for run in plain["runs"]
    ]
    header = ("model", "spring mm", "all springs mm", "length mm", "shortest mm", "longest mm", "modes, damping ratio")
    caption = (
        f"Static compression, and length of the spring (341 mm), static and at 5 Hz, {1e3 * plain['amplitude']:g} mm"
    )
    console.print(table(caption, header, rows, text=(0, 6)))
    rows = [
        (run["variant"], *(run["amplitudes"].get(name) for name in ("body", "wheel", "spring", "contact")))
        for run in plain["runs"]
    ]
    response = ("model", "body", "wheel", "spring", "contact N/m")
    console.print(table("Response at 5 Hz per metre of plate amplitude", response, rows))
    rows = [
        (run["variant"], *run["drive"]["torque"].values(), run["drive"]["power"], run["drive"]["dissipated"])
        for run in plain["runs"]
    ]
    drive = ("model", "least torque N m", "mean", "greatest", "mean power W", "heat in dampers W")
    console.print(table("Drive in steady motion", drive, rows))
    torque, printed = plain["torque_of_eq_5"], plain["torque_of_eq_5_as_printed"]
    console.print(f"eq. (5): {torque:.2f} N m; the paper computed {printed:.1f} N m")
    for one in plain["eusama"]:
        damping = f"{one['tyre_damping_coefficient']:g} N s/m in the tyre"
        console.print(f"EUSAMA, {damping}: {100.0 * one['adhesion']:.1f} % at {one['frequency_hz']:.1f} Hz")


def _end(console: Console, errata: Iterable[Erratum], findings: Iterable[Finding], out: Path | None) -> None:
    rows = [(erratum.place, erratum.printed, erratum.correct) for erratum in errata]
    console.print(table("Errata of the paper", ("place", "printed", "correct"), rows, text=(0, 1, 2)))
    show_findings(console, findings)
    console.print(
        "nothing was written; give --out DIR to keep the results"
        if out is None
        else f"written: {out}, open {out / 'report.html'}"
    )


@app.command("inspection-equivalence")
def equivalence(
    rig: RigName,
    points: Annotated[int, typer.Option(min=2, max=200, help="Number of values of each varied quantity.")] = 28,
    set_: Changes = None,
    limits: Annotated[Path | None, typer.Option(help="A limits file in place of the shipped limits.")] = None,
    figure: FigureFile = None,
    report: ReportFile = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Compare adhesion, phase angle and THETA of one wheel over damper wear, tyre stiffness, load and friction.

    Example: jounce study inspection-equivalence audi-a6-quarter-car --figure tests.png
    """
    check_outputs(figure=figure, report=report, force=force)
    wanted = changes(set_)
    with progress() as say:
        say("loading")
        from jounce.inspection.equivalence import compare_tests, usual_factors
        from jounce.inspection.limits import load_limits
        from jounce.variants.threads import processors

        study = compare_tests(
            chosen_rig(rig, wanted),  # type: ignore[arg-type]
            factors=usual_factors(points),
            limits=load_limits(limits),
            workers=processors(),
            progress=lambda share: say(f"testing: {100.0 * share:.0f} %"),
        )
        title = f"{Path(rig).stem}, simulated tests"
        drawn, missing = write_picture(study, figure, title, force=force)
        document, undrawn = write_report(lambda: _tests_page(study, title), report, force=force)
    plain = {"rig": rig, "changes": wanted, **study.to_dict(), "figure": drawn, "report": document}
    return Reply(plain, lambda console: _draw_equivalence(console, plain, study), as_json, missing=[*missing, *undrawn])


def _tests_page(study: Equivalence, title: str) -> Page:
    from jounce.report import equivalence_page

    return equivalence_page(study, title=title)


def _draw_equivalence(console: Console, plain: dict[str, Any], study: Equivalence) -> None:
    factors = {factor.name: factor for factor in study.factors}
    rows = [
        (
            factors[one.factor].label,
            one.method,
            f"{one.rejected_sound} of {one.sound}",
            _range(factors[one.factor], one.rejected_at),
            f"{one.passed_worn} of {one.worn}",
            _range(factors[one.factor], one.passed_at),
        )
        for one in study.disagreements
    ]
    header = ("varied", "method", "sound rejected", "at", "worn passed", "at")
    title = f"{plain['rig']}: a sound damper has lost up to {100.0 * plain['sound_up_to']:.0f} %, a worn one lost "
    title += f"{100.0 * plain['worn_from']:.0f} % or more (estimated)"
    console.print(table(title, header, rows, text=tuple(range(6))))
    console.print(f"{plain['tests']} simulated tests, limits {plain['limits']}")
    show_written(console, plain)


def _range(factor: Factor, ends: tuple[float, float] | None) -> str:
    return " to ".join(f"{factor.scale * end:.4g}" for end in dict.fromkeys(ends or ()))
