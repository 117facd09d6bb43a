"""Sweeps for commands and pages: on this machine or on a cluster, new or resumed."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any

from jounce.core.commands import typed_command
from jounce.core.errors import DescriptionError
from jounce.core.interrupts import uncovering_interrupts
from jounce.core.operation import Count, File, Mark, Switch, operation
from jounce.core.trust import trusting
from jounce.core.waiting import Stage
from jounce.variants.study import SweepResult, read_sweep, run_sweep
from jounce.variants.workers import cluster_at


@operation(
    "sweep",
    offers=("folder",),
    python="jounce.variants.study:run_sweep",
    page="jounce.report.variants:sweep_result_page",
    title="Sweep {study}",
    doing="reading the study",
    example="jounce sweep study.toml --out swept",
)
def sweep_study(
    study: Annotated[Path | str, File('Study file, schema = "jounce.sweep/1".', "STUDY.toml")],
    out: Annotated[
        Path | str,
        File("Folder of shards, summary.json, variants.csv, report and pictures.", "DIR"),
    ],
    *,
    workers: Annotated[
        int | None,
        Count(
            "Processes; by default one, or one a processor where variants run alone for long.",
            least=1,
        ),
    ] = None,
    cluster: Annotated[
        str | None,
        Mark('A Dask scheduler that does the work instead, e.g. "tcp://10.0.0.5:8786".', "URL"),
    ] = None,
    trust: Annotated[
        bool,
        Switch(
            "Run FMUs of controllers in the process of the run: faster, and a crash ends all of it."
        ),
    ] = False,
    resume: Annotated[bool, Switch("Go on where the sweep in the folder was stopped.")] = False,
    force: Annotated[bool, Switch("Overwrite existing output.")] = False,
    progress: Callable[[str], None] = lambda _: None,
) -> SweepResult:
    """Simulate many variants of a rig; report statistics of metrics and their sensitivities. Exit code 1 if none ran.

    Like :func:`jounce.run_sweep`, with the address of a cluster as an alternative.
    """
    if resume and force:
        allowed = "one of them"
        raise DescriptionError(
            "--resume to continue, or --force to start again",
            where="--resume, --force",
            allowed=allowed,
        )
    if cluster is not None and workers is not None:
        allowed = "only one of them: a cluster has its own workers"
        raise DescriptionError(
            "workers and a cluster are both given", where="--workers, --cluster", allowed=allowed
        )

    def say(done: int, count: int) -> None:
        share, variants = done / count, f"{count:,}".replace(",", " ")
        template = "simulating {variants} variants: {percent:.1f} %"
        progress(Stage(template, share=share, percent=100.0 * share, variants=variants))

    def run(client: Any = None) -> SweepResult:
        options: dict[str, Any] = {
            "resume": resume,
            "force": force,
            "workers": workers,
            "client": client,
        }
        return run_sweep(study, out, **options, say=say, command=typed_command("sweep"))

    try:
        with trusting(trust), uncovering_interrupts():
            if cluster is None:
                return run()
            read_sweep(study)  # report its errors before contacting the cluster
            with cluster_at(cluster) as client:
                return run(client)
    except KeyboardInterrupt as error:
        if (Path(out) / "sweep.json").is_file():
            error.add_note(SweepResult.when_interrupted)
        raise
