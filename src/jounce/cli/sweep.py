"""``jounce sweep``: many variants of a rig, from a study file into a folder that outlasts whatever stops the work."""

from __future__ import annotations

import math
import sys
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import AsJson, Force, Trust
from jounce.cli.reply import DONE, FAILED, Reply, drawing, progress, show_findings, show_written, table, tell
from jounce.core.commands import command_line
from jounce.core.interrupts import uncovering_interrupts
from jounce.core.text import guarded
from jounce.core.trust import trusting

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.core.findings import Finding
    from jounce.report import Page
    from jounce.variants.study import SweepResult
    from jounce.variants.summary import Summary

_MOST_ROWS = 100_000  # of variants.csv


def sweep(
    study: Annotated[
        Path, typer.Argument(metavar="STUDY.toml", help='Study file, schema = "jounce.sweep/1".', show_default=False)
    ],
    out: Annotated[
        Path,
        typer.Option(metavar="DIR", help="Folder of shards, summary.json, variants.csv, report and pictures."),
    ],
    workers: Annotated[
        int | None,
        typer.Option(min=1, help="Processes; by default one, or one a processor where variants run alone for long."),
    ] = None,
    cluster: Annotated[
        str | None,
        typer.Option(metavar="URL", help='A Dask scheduler that does the work instead, e.g. "tcp://10.0.0.5:8786".'),
    ] = None,
    trust: Trust = False,
    resume: Annotated[bool, typer.Option("--resume", help="Go on where the sweep in the folder was stopped.")] = False,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Simulate many variants of a rig and tell what metrics amount to and depend on. Exit code 1 where none ran.

    Example: jounce sweep study.toml --out swept
    """
    from jounce.core.errors import DescriptionError

    if resume and force:
        raise DescriptionError(
            "--force begins anew, --resume goes on", where="--resume, --force", allowed="one of them"
        )
    if cluster is not None and workers is not None:
        allowed = "one of them: the workers of a cluster are its own"
        raise DescriptionError("two places to work in", where="--workers, --cluster", allowed=allowed)
    command = command_line(["jounce", *sys.argv[1:]]) if sys.argv[1:2] == ["sweep"] else ""
    missing: Sequence[Finding] = ()
    with trusting(trust), progress() as say:
        say("reading the study")
        from jounce.variants.study import read_sweep, run_sweep
        from jounce.variants.workers import cluster_at

        def tell_share(done: int, count: int) -> None:
            say(f"simulating {count:,} variants: {100.0 * done / count:.1f} %".replace(",", " "))

        def run(client: Any = None) -> SweepResult:
            return run_sweep(
                study, out, resume=resume, force=force, workers=workers, client=client, say=tell_share, command=command
            )

        try:
            with uncovering_interrupts():
                if cluster is None:
                    found = run()
                else:
                    read_sweep(study)  # what is wrong with it is said before anybody is asked to work
                    with cluster_at(cluster) as client:
                        found = run(client)
                say("drawing")
                missing = _write(found, study, out)
        except KeyboardInterrupt:
            if (out / "sweep.json").is_file():
                tell("what is finished is kept; the same command with --resume goes on.")
            raise
    plain = found.to_dict()
    code = DONE if found.summary.ran else FAILED
    return Reply(plain, lambda console: draw_sweep(console, plain, found.summary), as_json, code, missing)


def _write(found: SweepResult, study: Path, out: Path) -> Sequence[Finding]:
    """Write summary and table, and then the page; give what could not be drawn."""
    from jounce.core.serialise import to_json
    from jounce.plots.figures import rendered
    from jounce.report import Picture, sweep_page, write_page
    from jounce.variants.study import extreme_runs, read_sweep

    text = study.read_text(encoding="utf-8")
    computed: dict[str, bytes | str] = {
        "study.toml": text,
        "summary.json": to_json(found) + "\n",
        "variants.csv": _variants(found),
    }

    def page() -> Page:
        sweep_ = read_sweep(study)
        runs = extreme_runs(sweep_, found.data)
        rig, trial = sweep_.work.study.rig, sweep_.work.study.trial
        whole = sweep_page(found, title=f"Sweep {study.stem}", runs=runs, rig=rig, trial=trial, study=text)
        pictures = [one for one in whole.pictures() if isinstance(one, Picture)]
        drawn = {f"{one.name}.png": rendered(one.figure, [".png"])[".png"] for one in pictures}
        return replace(whole, files=tuple(drawn.items()))

    with drawing() as missing:
        write_page(page, out, files=computed, force=True)
    return missing


def _variants(found: SweepResult) -> str:
    """Table of the variants with their numbers and metrics, SI; the first ones where there are very many."""
    data = found.data.drop_dims("time", errors="ignore").isel(variant=slice(0, _MOST_ROWS))
    names = [str(name) for name in (*data.coords, *data.data_vars) if name not in ("variant", "reason")]
    frame = data.reset_coords()[[*names, "reason"]].to_dataframe().reset_index()
    header = {name: guarded(f"{name} [{data[name].attrs.get('units', '1')}]") for name in names}
    frame = frame.map(lambda cell: guarded(cell) if isinstance(cell, str) else cell)
    return str(frame.rename(columns=header).to_csv(index=False, lineterminator="\n"))


def _measured(name: str, measure: Mapping[str, Any]) -> str:
    """A measure with its interval, in words; of shares and coefficients to a thousandth, less than a design tells."""
    if not math.isfinite(measure["value"]):
        return ""
    in_units = "effect" in name
    value, *ends = (
        f"{each:.3g}" if in_units else f"{round(each, 3) + 0.0:.3f}"
        for each in (measure["value"], *(measure["interval"] or ()))
    )
    return f"{value} ({' to '.join(ends)})" if ends else value


def draw_sweep(console: Console, plain: dict[str, Any], summary: Summary) -> None:
    """Print statistics of every metric, what it depends on, and why variants have no run."""
    from jounce.core.display import display_unit

    rows = []
    for one in summary.metrics:
        unit = display_unit(one.unit, max(abs(one.least), abs(one.greatest)))
        levels = [level["value"] for level in one.percentiles.values()]
        numbers = (one.mean, one.standard_deviation, one.least, *levels, one.greatest)
        rows.append((one.name, unit.name or "1", *(value * unit.factor for value in numbers)))
    header = ("metric", "unit", "mean", "standard deviation", "least", "5 %", "50 %", "95 %", "greatest")
    console.print(table(f"{summary.ran} of {summary.count} variants ran", header, rows, text=(0, 1)))
    if summary.influences:
        measures = [name for name in summary.influences[0].measures if not name.startswith("at_")]
        heaviest = next(name for name in ("total", "mean_absolute_effect", "regression") if name in measures)
        places = [one.name for one in summary.metrics]
        ordered = sorted(
            summary.influences, key=lambda one: (places.index(one.metric), -abs(one.measures[heaviest]["value"] or 0.0))
        )
        told = [
            (one.metric, one.number, *(_measured(name, one.measures[name]) for name in measures)) for one in ordered
        ]
        words = [name.replace("_", " ") for name in measures]
        title = "What they depend on (SI, with 95 % intervals)"
        console.print(table(title, ("metric", "number", *words), told, text=(0, 1)))
    for reason, lost in summary.failed.items():
        console.print(f"{lost['variants']} without a run (variant {lost['first']} first): {reason}")
    show_findings(console, summary.findings)
    show_written(console, plain)
