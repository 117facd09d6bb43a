"""``jounce study audi-a6-...``: half car of paper 2 on obstacle and pothole, front corner on an eccentric exciter."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import AsJson, Force, positive_quantity, quantity
from jounce.cli.outputs import check_outputs
from jounce.cli.reply import Reply, progress
from jounce.cli.tables import show_findings, table

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.core.findings import Finding
    from jounce.papers.audi_a6_paper import Erratum

Out = Annotated[Path | None, typer.Option(help="Folder for report, figures, curves (CSV, netCDF) and results.json.")]


def register(app: typer.Typer) -> None:
    """Add the commands to ``jounce study``."""
    app.command("audi-a6-case-a")(case_a)
    app.command("audi-a6-case-b")(case_b)
    app.command("audi-a6-excenter")(exciter)


def case_a(out: Out = None, force: Force = False, as_json: AsJson = False) -> Reply:
    """Brake the paper's Audi A6 onto a 5 cm obstacle, in three variants; without --out nothing is written.

    Example: jounce study audi-a6-case-a --out case-a
    """
    return _case("case-a", out, force, as_json)


def case_b(out: Out = None, force: Force = False, as_json: AsJson = False) -> Reply:
    """Accelerate the paper's Audi A6 into a 2 cm pothole, in three variants; without --out nothing is written.

    Example: jounce study audi-a6-case-b --json
    """
    return _case("case-b", out, force, as_json)


def exciter(
    amplitude: Annotated[str, typer.Option(help="Of the exciter: half the stroke. Estimated.")] = "3 mm",
    plate_mass: Annotated[str, typer.Option(help="Mass of the plate. Estimated.")] = "20 kg",
    out: Out = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Put the paper's front corner on a driven plate, in three models; without --out nothing is written.

    Example: jounce study audi-a6-excenter --amplitude "3 mm"
    """
    size = positive_quantity(amplitude, "m", "--amplitude")
    mass = quantity(plate_mass, "kg", "--plate-mass")
    check_outputs(folder=out, force=force)
    with progress() as say:
        from jounce.papers.audi_a6_exciter import run_eccentric_exciter

        study = run_eccentric_exciter(size, mass, progress=say)
        if out is not None:
            from jounce.report import write_page
            from jounce.report.audi_a6_exciter import exciter_page

            write_page(exciter_page(study), out, force=force, progress=say)
    plain = {**study.to_dict(), "out": None if out is None else str(out)}

    def draw(console: Console) -> None:
        _draw_exciter(console, plain)
        _end(console, study.errata, study.findings, out)

    return Reply(plain, draw, as_json)


def _case(name: str, out: Path | None, force: bool, as_json: bool) -> Reply:
    check_outputs(folder=out, force=force)
    with progress() as say:
        from jounce.papers.audi_a6 import run_audi_a6

        study = run_audi_a6(name, progress=say)
        if out is not None:
            from jounce.report import write_page
            from jounce.report.audi_a6 import audi_case_page

            write_page(audi_case_page(study), out, force=force, progress=say)
    plain = {**study.to_dict(), "out": None if out is None else str(out)}

    def draw(console: Console) -> None:
        _draw_case(console, plain, study.case.title)
        _end(console, study.errata, study.findings, out)

    return Reply(plain, draw, as_json)


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
    _draw_modes(console, plain["modes"])


def _extremes(window: dict[str, float]) -> Iterable[str]:
    for end in ("min", "max"):
        yield f"{1e3 * window[end] + 0.0:.3f}".replace("-0.000", "0.000")
        yield f"{window[f't_{end}']:.3f}"


def _draw_modes(console: Console, modes: list[dict[str, Any]]) -> None:
    rows = [(mode["frequency_hz"], mode["damped_frequency_hz"], mode["damping_ratio"]) for mode in modes]
    console.print(table("Modes", ("natural frequency Hz", "damped Hz", "damping ratio"), rows, text=()))


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
    header = ("model", "spring mm", "all springs mm", "length mm", "shortest", "longest", "modes, damping ratio")
    caption = (
        f"Static compression, and length of the spring (341 mm) at rest and at 5 Hz, {1e3 * plain['amplitude']:g} mm"
    )
    console.print(table(caption, header, rows, text=(0, 6)))
    rows = [
        (run["variant"], *(run["amplitudes"].get(name) for name in ("body", "wheel", "spring", "contact")))
        for run in plain["runs"]
    ]
    response = ("model", "body", "wheel", "spring", "contact N/m")
    console.print(table("At 5 Hz for one metre of the plate", response, rows))
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
    console.print(table("The paper beside what is correct", ("where", "the paper", "correct"), rows, text=(0, 1, 2)))
    show_findings(console, findings)
    console.print(
        "nothing was written: give --out DIR" if out is None else f"written: {out}, open {out / 'report.html'}"
    )
