"""Set up the shipped campaign in a new folder: write its files, simulate its measurements and evaluate it."""

from __future__ import annotations

from itertools import count
from pathlib import Path

import jounce as jn
from jounce.papers import Progress, no_progress
from jounce.papers.virtual_bench import virtual_bench

FULL, QUICK = "campaign.toml", "quick-look.toml"
"""Campaign files: the double wishbone in 3-D, and the same measurements with a quarter car."""


def prepare_demo(
    out: Path | str | None = None, *, force: bool = False, progress: Progress = no_progress
) -> Path:
    """Write the shipped campaign with its synthetic measurements; return its ``campaign.toml``.

    Without ``out``, the first unused folder ``demo-1``, ``demo-2``, ... in the current one is created. If a file
    exists, nothing is written unless ``force`` is set.
    """
    folder = (_next_folder() if out is None else Path(out)) / "campaign"
    return virtual_bench(folder, force=force, progress=progress)


def run_demo(
    out: Path | str | None = None,
    *,
    quick: bool = False,
    force: bool = False,
    progress: Progress = no_progress,
) -> tuple[Path, jn.CampaignResult]:
    """Prepare and evaluate the shipped campaign, ``quick`` with a quarter car instead of the double wishbone in 3-D.

    Returns the demo's folder, for report and results, and the campaign's result; the caller writes the report.
    """
    file = prepare_demo(out, force=force, progress=progress).with_name(QUICK if quick else FULL)
    return file.parent.parent, jn.run_campaign(file, progress=progress)


def _next_folder() -> Path:
    """Create the first unused numbered folder."""
    for number in count(1):
        folder = Path(f"demo-{number}")
        try:
            folder.mkdir()
        except FileExistsError:
            continue
        return folder
    raise AssertionError("there is always a next number")
