"""A campaign run into a folder: report, rigs and results, and the requested figures and tables."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal, get_args

from jounce.core.errors import unknown
from jounce.core.findings import DrawingError, Finding, not_drawn
from jounce.core.operation import File, Switch, Texts, operation
from jounce.core.optional import require
from jounce.core.shown import Shown
from jounce.core.writing import check_folder, write_files
from jounce.report.page import Page, Paragraph, Section

if TYPE_CHECKING:
    from jounce.campaign.result import CampaignResult

FigureForm = Literal["svg", "png", "paper"]
TableForm = Literal["csv", "xlsx"]
ReportForm = Literal["html", "pdf"]
_FORMS: Mapping[str, tuple[str, ...]] = {
    "figures": get_args(FigureForm),
    "tables": get_args(TableForm),
    "reports": get_args(ReportForm),
}
FIGURES = Texts(
    "Also write every figure of the report as SVG or PNG into the folder figures; paper: those of the quarter-car "
    "prototype paper (4, 6, 8, 9, 10). Repeat it.",
    "svg|png|paper",
)
TABLES = Texts(
    "Also write the tables of the report: csv into the folder tables, xlsx as one workbook. Repeat it.",
    "csv|xlsx",
)
REPORTS = Texts(
    "Form of the report; pdf is written beside the page, which is always there. Repeat it.",
    "html|pdf",
)


@dataclass(frozen=True)
class ReportedCampaign(Shown):
    """A completed campaign, written into a folder.

    Attributes
    ----------
    result : CampaignResult
        Measured values, updates and trials, SI.
    out : Path
        Output folder.
    figures : tuple of str
        Names of the figure files written into the folder.
    missing : tuple of Finding
        Figures that could not be drawn; all other files are written.
    """

    result: CampaignResult
    out: Path
    figures: tuple[str, ...] = ()
    missing: tuple[Finding, ...] = ()

    def __str__(self) -> str:
        return str(self.result)

    @property
    def is_met(self) -> bool:
        """Whether the campaign completed without failures."""
        return self.result.is_complete

    def to_dict(self) -> dict[str, Any]:
        """Return the results as plain data in SI units, with the folder and the figures written."""
        drawn = {"figures": list(self.figures)} if self.figures else {}
        return {**self.result.to_dict(), "is_complete": self.is_met, "out": str(self.out), **drawn}


STAGES = ("bench", "update*3", "compare*3", "writing|write|draw")
"""How the progress of a reported campaign begins in each stage, and its usual part of the time."""


@operation(
    "campaign run",
    named={"path": "campaign", "figures": "figure", "tables": "table", "reports": "report"},
    faces={"figure": None, "table": None, "report": None},
    page="jounce.report.campaign_folder:reported_page",
    title="{result.result.campaign.title}",
    doing="reading the campaign",
    stages=STAGES,
    example="jounce campaign run campaign.toml --out results",
)
def report_campaign(
    path: Annotated[
        Path | str, File("Campaign file: what was measured, and what to update.", "CAMPAIGN.toml")
    ],
    out: Annotated[
        Path | str, File("Folder for report, figures, updated rigs and results.json.", "DIR")
    ],
    *,
    figures: Annotated[Sequence[FigureForm], FIGURES] = (),
    tables: Annotated[Sequence[TableForm], TABLES] = (),
    reports: Annotated[Sequence[ReportForm], REPORTS] = (),
    force: Annotated[bool, Switch("Overwrite existing output.")] = False,
    progress: Callable[[str], None] = lambda _: None,
) -> ReportedCampaign:
    """Characterise, update the model, compare every trial with it, and write the report.

    A failed step is reported as a finding; all other results are still computed and written.

    Parameters
    ----------
    path : Path or str
        Campaign TOML; files it names are relative to its folder.
    out : Path or str
        Folder for ``report.html``, ``results.json`` and the rigs of each update.
    figures : sequence of {"svg", "png", "paper"}
        Additional figures in the folder ``figures``: all figures of the report in a format, or those of the
        quarter-car prototype paper.
    tables : sequence of {"csv", "xlsx"}
        Formats of the tables of the report: into the folder ``tables``, or as one workbook.
    reports : sequence of {"html", "pdf"}
        Formats of the report; the HTML page is always written.
    force : bool
        Replace files of the same names in an existing folder; other files are kept.
    progress : callable
        Called with a one-line message at each stage.

    Returns
    -------
    ReportedCampaign
        Result of :func:`jounce.run_campaign`, and the files written.

    Raises
    ------
    DescriptionError
        If the campaign, rig or road tables are invalid.
    OutputError
        If the folder is not empty and ``force`` is not given; nothing is computed then.

    Examples
    --------
    >>> import tempfile
    >>> import jounce as jn
    >>> folder = Path(tempfile.mkdtemp())
    >>> found = report_campaign(jn.new_campaign(folder / "mine"), folder / "results", tables=["csv"])
    >>> found.is_met, (folder / "results" / "report.html").is_file()
    (True, True)
    """
    from jounce.campaign import run_campaign

    check_folder(out, force=force)
    asked = {"figures": figures, "tables": tables, "reports": reports}
    check_forms(**asked)
    result = run_campaign(path, progress=progress)
    progress("writing the report")
    return write_reported(result, out, force=force, **asked)


def check_forms(
    *, figures: Sequence[str] = (), tables: Sequence[str] = (), reports: Sequence[str] = ()
) -> None:
    """Raise an error for formats that are unknown or require packages that are not installed."""
    for where, forms in (("figures", figures), ("tables", tables), ("reports", reports)):
        for form in forms:
            if form not in _FORMS[where]:
                raise unknown(form, _FORMS[where], what="form", where=where)
    if "pdf" in reports or "png" in figures:
        from jounce.report.typeset import TYPESETTER

        require(*TYPESETTER)
    if "xlsx" in tables:
        require("openpyxl", "io")


def write_reported(
    result: CampaignResult,
    out: Path | str,
    *,
    figures: Sequence[str] = (),
    tables: Sequence[str] = (),
    reports: Sequence[str] = (),
    force: bool = False,
) -> ReportedCampaign:
    """Write all results of a campaign; figures that cannot be drawn are reported and skipped."""
    from jounce.report.campaign import write_campaign

    folder, formats = Path(out), tuple(dict.fromkeys(form for form in figures if form != "paper"))
    missing: tuple[Finding, ...] = ()
    try:
        write_campaign(
            result,
            out,
            force=force,
            figures=formats,
            tables=tuple(dict.fromkeys(tables)),
            pdf="pdf" in reports,
        )
    except DrawingError as error:
        missing = error.findings
    drawn = sorted(
        f"figures/{file.name}"
        for form in formats
        for file in (folder / "figures").glob(f"*.{form}")
    )
    if "paper" not in figures:
        return ReportedCampaign(result, folder, tuple(drawn), missing)
    more, undrawn = _paper_figures(result, folder, force=force)
    return ReportedCampaign(result, folder, (*drawn, *more), (*missing, *undrawn))


def _paper_figures(
    result: CampaignResult, out: Path, *, force: bool
) -> tuple[list[str], list[Finding]]:
    """Write the paper's figures below ``out`` as SVG and PNG; return their names, and those that could not be drawn."""
    from jounce.plots import add_note, paper_figures, render_figure
    from jounce.report.campaign import SYNTHETIC_NOTE

    files: dict[str, bytes | str] = {}
    try:
        for name, figure in paper_figures(result).items():
            add_note(figure, SYNTHETIC_NOTE if result.campaign.synthetic else "")
            drawn = render_figure(figure, (".svg", ".png"))
            files |= {f"figures/paper-{name}{suffix}": content for suffix, content in drawn.items()}
        write_files(out, files, force=force)
    except Exception as error:  # noqa: BLE001 - the results are returned in any case
        return [], [not_drawn("figures of the paper", error)]
    return list(files), []


def reported_page(reported: ReportedCampaign, *, title: str) -> Page:
    """Create a page of the results of a campaign without figures; the full report is in the folder."""
    from jounce.report.campaign import campaign_summary

    summary = replace(campaign_summary(reported.result), title=title)
    synthetic = reported.result.campaign.synthetic
    first = (Section("Data", (Paragraph(synthetic, "fair"),)),) if synthetic else ()
    failed = sum(finding.severity == "problem" for finding in reported.result.findings)
    problems = (
        f"{failed} problem{'' if failed == 1 else 's'}, see above; everything else was completed."
    )
    last = (Section("Problems", (Paragraph(problems, "bad"),)),) if failed else ()
    return replace(summary, sections=(*first, *summary.sections, *last))
