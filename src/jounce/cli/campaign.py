"""``jounce campaign`` and ``jounce demo``: a whole bench campaign, a commented one to start from, the shipped one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.derived import add_commands
from jounce.cli.options import (
    AsJson,
    Force,
    changes,
    check_outputs,
)
from jounce.cli.reply import DONE, FAILED, Reply, drawing, progress
from jounce.core.commands import command_line
from jounce.core.errors import DescriptionError
from jounce.core.optional import require
from jounce.core.typed import positive_quantity

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.campaign import Campaign, CampaignResult, FolderCampaign
    from jounce.core.findings import Finding
    from jounce.identify.posterior import Posterior
    from jounce.identify.prediction import PredictionBand


class TableKind(StrEnum):
    """How the tables of a report are written beside it."""

    CSV = "csv"
    XLSX = "xlsx"


class ReportKind(StrEnum):
    """Forms of a report."""

    HTML = "html"
    PDF = "pdf"


class StrategyChoice(StrEnum):
    """Updates of a campaign that is made of a folder."""

    DEFAULT = "default"
    PAPER = "paper"


class FigureKind(StrEnum):
    """What can be written beside a report."""

    SVG = "svg"
    PNG = "png"
    PAPER = "paper"


Figures = Annotated[
    list[FigureKind] | None,
    typer.Option(
        help="Also write every figure of the report as SVG or PNG into the folder figures; paper: those of the "
        "quarter-car prototype paper (4, 6, 8, 9, 10). Repeat it."
    ),
]
Tables = Annotated[
    list[TableKind] | None,
    typer.Option(
        "--table", help="Also write the tables of the report: csv into the folder tables, xlsx as one workbook."
    ),
]
Reports = Annotated[
    list[ReportKind] | None,
    typer.Option("--report", help="Form of the report; pdf is written beside the page, which is always there."),
]
app = typer.Typer(no_args_is_help=True, help="Evaluate a bench campaign, or start a new one.")


@app.command("run")
def run(
    campaign: Annotated[
        Path, typer.Argument(metavar="CAMPAIGN.toml", help="Campaign file: what was measured, and what to update.")
    ],
    out: Annotated[Path, typer.Option(help="Folder for report, figures, updated rigs and results.json.")],
    figure: Figures = None,
    table_: Tables = None,
    report: Reports = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Characterise, update the model, compare every trial with it, and write the report.

    Exit code 1 means that something failed; everything else is still completed and written.

    Example: jounce campaign run campaign.toml --out results
    """
    check_outputs(folder=out, force=force)
    _check_packages(figure or (), table_ or (), report or ())
    with progress() as say:
        from jounce.campaign import run_campaign

        result = run_campaign(campaign, progress=say)
        say("writing the report")
        drawn, missing = _write(result, out, figure or (), table_ or (), report or (), force=force)
    return campaign_reply(result, out, missing, as_json=as_json, figures=drawn)


def _check_packages(figure: Sequence[FigureKind], tables: Sequence[TableKind], reports: Sequence[ReportKind]) -> None:
    """Refuse, before the work, what takes packages that are not installed."""
    if ReportKind.PDF in reports or FigureKind.PNG in figure:
        from jounce.report.typeset import TYPESETTER

        require(*TYPESETTER)
    if TableKind.XLSX in tables:
        require("openpyxl", "io")


def _write(
    result: CampaignResult,
    out: Path,
    figure: Sequence[FigureKind],
    tables: Sequence[TableKind],
    reports: Sequence[ReportKind],
    *,
    force: bool,
) -> tuple[list[str], list[Finding]]:
    """Write everything that a campaign found; give the names of the figures beside the report, and what is missing."""
    from jounce.report import write_campaign

    formats = dict.fromkeys(name.value for name in figure if name is not FigureKind.PAPER)
    sheets = tuple(dict.fromkeys(kind.value for kind in tables))
    pdf = ReportKind.PDF in reports
    with drawing() as missing:
        write_campaign(result, out, force=force, figures=tuple(formats), tables=sheets, pdf=pdf)
    drawn = sorted(f"figures/{file.name}" for form in formats for file in (out / "figures").glob(f"*.{form}"))
    more, undrawn = _paper_figures(result, out, force=force) if FigureKind.PAPER in figure else ([], [])
    return [*drawn, *more], [*missing, *undrawn]


def _paper_figures(result: CampaignResult, out: Path, *, force: bool) -> tuple[list[str], list[Finding]]:
    """Write the paper's figures below ``out`` as SVG and PNG; give their names, and what could not be drawn."""
    from jounce.core.findings import not_drawn
    from jounce.core.writing import write_files
    from jounce.plots import add_note, paper_figures, rendered
    from jounce.report.campaign import SYNTHETIC_NOTE

    files: dict[str, bytes | str] = {}
    try:
        for name, figure in paper_figures(result).items():
            add_note(figure, SYNTHETIC_NOTE if result.campaign.synthetic else "")
            drawn = rendered(figure, (".svg", ".png"))
            files |= {f"figures/paper-{name}{suffix}": content for suffix, content in drawn.items()}
        write_files(out, files, force=force)
    except Exception as error:  # noqa: BLE001 - whatever it is, what was computed is told
        return [], [not_drawn("figures of the paper", error)]
    return list(files), []


@app.command("new")
def new(
    folder: Annotated[Path, typer.Argument(metavar="DIR", help="Folder to create.")],
    source: Annotated[
        Path | None,
        typer.Option(
            "--from", metavar="FOLDER", help="Folder of measured files: recognised, and made into a campaign."
        ),
    ] = None,
    settings: Annotated[
        Path | None,
        typer.Option(help="Settings of the laboratory; by default the file of that kind in --from."),
    ] = None,
    strategies: Annotated[
        StrategyChoice, typer.Option(help="Updates: one with all parameters, or the three of the prototype paper.")
    ] = StrategyChoice.DEFAULT,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Write a commented campaign to start from, or the one that a folder of measured files makes.

    Example: jounce campaign new my-campaign --from measured
    """
    from jounce.campaign import campaign_from_folder, new_campaign

    if source is not None:
        made_of = campaign_from_folder(folder, source, settings=settings, strategies=strategies.value, force=force)
        return _from_folder(made_of, folder, as_json=as_json)
    if settings is not None or strategies is not StrategyChoice.DEFAULT:
        option = "--settings" if settings is not None else "--strategies"
        raise DescriptionError("goes with measured files", where=option, hint="Give their folder with --from.")
    campaign = new_campaign(folder, force=force)
    made = sorted(str(file.relative_to(folder)) for file in folder.rglob("*") if file.is_file())

    def draw(console: Console) -> None:
        console.print(f"{folder}: {', '.join(made)}")
        console.print("Next: put your measurements there, edit campaign.toml, then")
        for words in (["check", str(campaign)], ["campaign", "run", str(campaign), "--out", "results"]):
            console.print(f"  {command_line(['jounce', *words])}", soft_wrap=True)

    return Reply({"folder": str(folder), "files": made}, draw, as_json)


def _from_folder(made: FolderCampaign, folder: Path, *, as_json: bool) -> Reply:
    """What each file was taken for, what is missing, and how to go on."""
    plain = {"folder": str(folder), **made.to_dict()}

    def draw(console: Console) -> None:
        from jounce.cli.terminal import show_page
        from jounce.report.laboratory import folder_page

        show_page(console, folder_page(made, title=str(folder)))
        console.print(f"Next: {command_line(['jounce', 'campaign', 'run', str(made.campaign), '--out', 'results'])}")

    return Reply(plain, draw, as_json)


@app.command("synthesise")
def synthesise(
    folder: Annotated[Path, typer.Argument(metavar="DIR", help="Folder to create.")],
    truth: Annotated[
        str,
        typer.Option(help="What the bench really is: a file, or a shipped name (kart-prototype, kart-low-friction)."),
    ] = "kart-prototype",
    set_: Annotated[
        list[str] | None,
        typer.Option(
            "--set",
            metavar="PATH=VALUE",
            help='Change the truth, or its rig behind "rig.": belt.speed_drop="0 %", '
            'rig.strut.damper="{coefficient = 104}". Repeat it.',
        ),
    ] = None,
    seed: Annotated[int, typer.Option(min=0, help="Of all scatter and noise.")] = 2008,
    duration: Annotated[str, typer.Option(help="Length of each recording.")] = "3 s",
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Make synthetic recordings of a bench whose truth is known, with the campaign that evaluates them.

    Whether a method finds values that one has chosen oneself shows what it is worth.

    Example: jounce campaign synthesise my-bench --seed 7 --set rig.strut.friction.force="0 N"
    """
    length = positive_quantity(duration, "s", "--duration")
    changed = changes(set_)
    check_outputs(folder=folder, force=force)
    with progress() as say:
        from jounce.papers.virtual_bench import virtual_bench

        file = virtual_bench(folder, truth, changes=changed, seed=seed, duration=length, force=force, progress=say)
    made = sorted(str(one.relative_to(folder)) for one in folder.rglob("*") if one.is_file())

    def draw(console: Console) -> None:
        console.print(f"{folder}: {len(made)} files, synthetic; the values behind them are in truth.toml")
        console.print(f"Next: jounce campaign run {file} --out results")

    return Reply({"folder": str(folder), "seed": seed, "changes": changed, "files": made}, draw, as_json)


Strategy = Annotated[str, typer.Option(help="Name of the update; the last one by default.")]
NoiseOnly = Annotated[
    bool, typer.Option("--noise-only", help="Count noise only, not what the campaign doubts of model and measurement.")
]


@app.command("posterior")
def posterior(
    campaign: Annotated[Path, typer.Argument(metavar="CAMPAIGN.toml", help="Campaign file with updates.")],
    out: Annotated[Path, typer.Option(metavar="DIR", help="Folder for report, pictures, posterior.json and draws.nc.")],
    strategy: Strategy = "",
    draws: Annotated[int, typer.Option(min=1000, max=10_000_000, help="Number of draws, at least.")] = 20_000,
    seed: Annotated[int, typer.Option(min=0, help="Of everything at random.")] = 1,
    noise_only: NoiseOnly = False,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Draw what the recordings say of an update's parameters, and what that predicts for every trial.

    Example: jounce campaign posterior campaign.toml --strategy "strategy 2" --out posterior
    """
    check_outputs(folder=out, force=force)
    require("emcee", "posterior")
    require("arviz_stats.base", "posterior")
    with progress() as say:
        from jounce.campaign import load_campaign
        from jounce.campaign.posterior import campaign_posterior

        found = campaign_posterior(campaign, strategy, draws=draws, seed=seed, noise_only=noise_only, progress=say)
        say("writing the report")
        missing = _write_posterior(found, load_campaign(campaign)[0], out, force=force)
    plain = {**_posterior_table(found), "out": str(out)}
    del plain["profiles"]

    def draw(console: Console) -> None:
        from jounce.cli.terminal import show_page
        from jounce.report.posterior import posterior_summary

        show_page(console, posterior_summary(found, title=campaign.stem))
        console.print(f"written: {out}" + (f", open {out / 'report.html'}" if (out / "report.html").exists() else ""))

    return Reply(plain, draw, as_json, DONE, missing)


def _posterior_table(found: Posterior) -> dict[str, Any]:
    """Plain data without curves over time: of each band the share of samples inside."""
    plain = found.to_dict()
    plain["predictions"] = {
        trial: {name: {"inside": band.inside, "is_fitted": band.is_fitted} for name, band in channels.items()}
        for trial, channels in found.predictions.items()
    }
    return plain


def _bands_csv(channels: Mapping[str, PredictionBand]) -> str:
    """Bands of one trial as a table, SI."""
    time = next(iter(channels.values())).time
    columns: dict[str, Any] = {"time [s]": time}
    for name, band in channels.items():
        low, high = band.ends()
        given = {"measured": band.measured, "mean": band.mean, "lower": low, "upper": high}
        columns |= {f"{name} {word} [{band.unit}]": values for word, values in given.items()}
    rows = [",".join(columns), *(",".join(f"{v:.9g}" for v in row) for row in zip(*columns.values(), strict=True))]
    return "\n".join(rows) + "\n"


def _write_posterior(found: Posterior, campaign: Campaign, out: Path, *, force: bool) -> list[Finding]:
    """Write the numbers and draws, and then the page; give what could not be drawn."""
    from dataclasses import replace

    from jounce.core.serialise import to_json
    from jounce.plots.figures import rendered
    from jounce.recordings.writers import netcdf_of
    from jounce.report import Page, Picture, posterior_page, write_page
    from jounce.report.page import slug

    computed: dict[str, bytes | str] = {
        "posterior.json": to_json(_posterior_table(found)) + "\n",
        "draws.nc": netcdf_of(found.samples),
        **{f"bands/{slug(trial)}.csv": _bands_csv(channels) for trial, channels in found.predictions.items()},
    }

    def page() -> Page:
        whole = posterior_page(found, title=campaign.title, synthetic=campaign.synthetic)
        pictures = [one for one in whole.pictures() if isinstance(one, Picture)]
        drawn = {f"{one.name}.png": rendered(one.figure, [".png"])[".png"] for one in pictures}
        return replace(whole, files=tuple(drawn.items()))

    with drawing() as missing:
        write_page(page, out, files=computed, force=force)
    return missing


add_commands(app, "campaign")


def campaign_reply(
    result: CampaignResult, folder: Path, missing: Sequence[Finding], *, as_json: bool, figures: Sequence[str] = ()
) -> Reply:
    """Answer of a campaign that was run and written to ``folder``, with the paper's ``figures`` where asked for."""
    plain = {**result.to_dict(), "is_complete": result.is_complete, "out": str(folder)}
    if figures:
        plain["figures"] = list(figures)
    exit_code = DONE if result.is_complete else FAILED

    def draw(console: Console) -> None:
        from jounce.cli.terminal import show_page
        from jounce.report.campaign import campaign_summary

        if plain["synthetic"]:
            console.print(plain["synthetic"], style="yellow")
        show_page(console, campaign_summary(result))
        console.print(f"written: {folder}" + (f", open {page}" if (page := folder / "report.html").exists() else ""))
        failed = sum(finding.severity == "problem" for finding in result.findings)
        if failed:
            problems = f"{failed} problem{'s' if failed > 1 else ''}"
            console.print(f"{problems}, see above; everything else was completed.", style="bold red")

    return Reply(plain, draw, as_json, exit_code, missing)


def demo(
    out: Annotated[Path | None, typer.Option(help="Output folder; by default a new numbered one.")] = None,
    quick: Annotated[
        bool, typer.Option("--quick", help="Model the prototype as a quarter car instead of a double wishbone.")
    ] = False,
    figure: Figures = None,
    table_: Tables = None,
    report: Reports = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Copy the shipped campaign (synthetic measurements) into a folder and run it, with the rig modelled in 3-D.

    Example: jounce demo --out jounce-demo
    """
    check_outputs(folder=out, force=force)
    _check_packages(figure or (), table_ or (), report or ())
    with progress() as say:
        from jounce.papers.demo import run_demo

        folder, result = run_demo(out, quick=quick, force=force, progress=say)
        say("writing the report")
        # it holds the campaign by now, and nothing else of these names
        drawn, missing = _write(result, folder, figure or (), table_ or (), report or (), force=True)
    reply = campaign_reply(result, folder, missing, as_json=as_json, figures=drawn)

    def draw(console: Console) -> None:
        reply.draw(console)
        page = folder.resolve() / "report.html"
        if page.is_file():
            console.print(f"the report: {page.as_uri()}", soft_wrap=True, highlight=False)
        console.print(
            f"the workbench: {command_line(['jounce', 'serve', str(folder)])}", soft_wrap=True, highlight=False
        )

    return replace(reply, draw=draw)
