"""The shipped campaign in a folder of its own: files written, measured on the virtual bench, evaluated."""

from __future__ import annotations

from collections.abc import Callable
from itertools import count
from pathlib import Path

from jounce.campaign import CampaignResult, run_campaign
from jounce.core.serialise import write_files
from jounce.papers.template import campaign_texts
from jounce.papers.virtual_bench import BenchPlan, measurement_texts, truth_text

Progress = Callable[[str], None]
CAMPAIGN = "kart-prototype"
FULL, QUICK = "campaign.toml", "quick-look.toml"
"""Campaign files: the double wishbone in 3-D, and the same measurements with a quarter car."""


def prepare_demo(out: Path | str | None = None, *, force: bool = False, progress: Progress | None = None) -> Path:
    """Write the shipped campaign with its synthetic measurements.

    Parameters
    ----------
    out : path, optional
        Folder; without it the first free of ``demo-1``, ``demo-2``, ... in the current one.
    force : bool
        Overwrite existing files.
    progress : callable, optional
        Called with one line of text as the work goes on.

    Returns
    -------
    Path
        ``campaign/campaign.toml`` in that folder; the measurements and ``quick-look.toml`` lie beside it.

    Raises
    ------
    OutputError
        When one of the files exists, without ``force``; then nothing is written.
    """
    plan = BenchPlan()
    texts = {
        **campaign_texts(CAMPAIGN),
        **measurement_texts(plan, progress=progress),
        "truth.toml": truth_text(plan),
    }
    folder = (_numbered() if out is None else Path(out)) / "campaign"
    write_files(folder, texts, force=force)
    return folder / "campaign.toml"


def run_demo(
    out: Path | str | None = None, *, quick: bool = False, force: bool = False, progress: Progress | None = None
) -> tuple[Path, CampaignResult]:
    """Prepare and evaluate the shipped campaign; the report is written by who asks for it.

    Parameters
    ----------
    out : path, optional
        Folder; without it the first free of ``demo-1``, ``demo-2``, ... in the current one.
    quick : bool
        Take the prototype for a quarter car instead of its double wishbone in 3-D.
    force : bool
        Overwrite existing files.
    progress : callable, optional
        Called with one line of text as the work goes on.

    Returns
    -------
    folder : Path
        The demo's folder, for report and results.
    result : CampaignResult
        What the campaign found.

    Raises
    ------
    OutputError
        When one of the files exists, without ``force``.
    """
    file = prepare_demo(out, force=force, progress=progress).with_name(QUICK if quick else FULL)
    result = run_campaign(file) if progress is None else run_campaign(file, progress=progress)
    return file.parent.parent, result


def _numbered() -> Path:
    """Make the first free numbered folder."""
    for number in count(1):
        folder = Path(f"demo-{number}")
        try:
            folder.mkdir()
        except FileExistsError:
            continue
        return folder
    raise AssertionError("there is always a next number")
