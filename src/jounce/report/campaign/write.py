"""The report of a campaign and the files beside it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from jounce.core.serialise import to_json
from jounce.report.campaign.bench import characterisation
from jounce.report.campaign.lumped import lumped
from jounce.report.campaign.method import method
from jounce.report.campaign.summary import summary
from jounce.report.campaign.trials import curves, trials, validation
from jounce.report.campaign.updates import updates
from jounce.report.folder import check_folder
from jounce.report.page import Findings, Page, Section, unique_slugs
from jounce.report.render import write_page

if TYPE_CHECKING:
    from jounce.campaign.result import CampaignResult

SYNTHETIC_NOTE = "Synthetic data, not measurements"


def write_campaign(
    result: CampaignResult,
    out: Path | str,
    *,
    force: bool = False,
    progress: Callable[[str], None] = lambda _text: None,
) -> list[Path]:
    """Write everything a campaign found into a folder.

    Parameters
    ----------
    result : CampaignResult
        Outcome of :func:`jounce.campaign.run_campaign`.
    out : Path or str
        Folder; made where it is missing, refused when it holds something and ``force`` is not given.
    force : bool
        Replace files of the same names in an existing folder; others stay.
    progress : callable
        Called with one line of text as the work goes on.

    Returns
    -------
    list of Path
        ``report.html`` (one file that needs nothing else), ``results.json``, ``rig-<update>.toml`` for each update, and
        every figure as ``figures/<name>.svg`` and ``.png``.

    Raises
    ------
    OutputError
        For a folder that is not empty or cannot be written; nothing is changed then.
    """
    check_folder(out, force=force)
    return write_page(campaign_page(result), out, force=force, progress=progress)


def campaign_page(result: CampaignResult) -> Page:
    """Give the report of a campaign as a page, figures drawn."""
    names = unique_slugs([strategy.update.name for strategy in result.strategies])
    rigs = [(f"rig-{name}.toml", strategy.rig_text) for name, strategy in zip(names, result.strategies, strict=True)]
    synthetic = result.campaign.synthetic
    return Page(
        title=result.campaign.title,
        subtitle="Bench campaign: from measurements to an updated model",
        banner=f"{SYNTHETIC_NOTE}. {synthetic}" if synthetic else "",
        figure_note=SYNTHETIC_NOTE if synthetic else "",
        sections=(
            summary(result),
            characterisation(result),
            trials(result),
            updates(result),
            validation(result),
            *((lumped(result.lumped),) if result.lumped is not None else ()),
            curves(result),
            Section("Findings", (Findings(result.findings),)),
            method(result),
        ),
        files=(("results.json", to_json(result.to_dict()) + "\n"), *rigs),
    )
