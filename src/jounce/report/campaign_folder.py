"""A campaign run into a folder: report, rigs and results, and the figures and tables that are asked for."""

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
    """A campaign that was run and written into a folder.

    Attributes
    ----------
    result : CampaignResult
        Measured values, updates and trials, SI.
    out : Path
        The folder.
    figures : tuple of str
        Figures that were written into it beside the report, by their names there.
    missing : tuple of Finding
        What could not be drawn; everything else is written.
    """

    result: CampaignResult
    out: Path
    figures: tuple[str, ...] = ()
    missing: tuple[Finding, ...] = ()

    def __str__(self) -> str:
        return str(self.result)

    @property
    def is_met(self) -> bool:
        """Whether nothing failed."""
        return self.result.is_complete

    def to_dict(self) -> dict[str, Any]:
        """Give the results as plain data, SI, with the folder and the figures that were written."""
        drawn = {"figures": list(self.figures)} if self.figures else {}
        return {**self.result.to_dict(), "is_complete": self.is_met, "out": str(self.out), **drawn}


@operation(
    "campaign run",
    named={"path": "campaign", "figures": "figure", "tables": "table", "reports": "report"},
    faces={"figure": None, "table": None, "report": None},
    page="jounce.report.campaign_folder:reported_page",
    title="{result.result.campaign.title}",
    doing="reading the campaign",
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

    What fails is a finding; everything else is still completed and written.

    Parameters
    ----------
    path : Path or str
        Campaign TOML; files it names are relative to its folder.
    out : Path or str
        Folder for ``report.html``, ``results.json`` and the rigs of each update.
    figures : sequence of {"svg", "png", "paper"}
        What else is drawn into the folder ``figures``: every figure of the report in a format, or the figures of the
        quarter-car prototype paper.
    tables : sequence of {"csv", "xlsx"}
        Formats of the tables of the report: into the folder ``tables``, or as one workbook.
    reports : sequence of {"html", "pdf"}
        Forms of the report; the page is always there.
    force : bool
        Replace files of the same names in an existing folder; others stay.
    progress : callable
        Called with one line of text as the work goes on.

    Returns
    -------
    ReportedCampaign
        What :func:`jounce.run_campaign` gives, and what was written.

    Raises
    ------
    DescriptionError
        When the campaign, rig or road tables cannot be understood.
    OutputError
        For a folder that is not empty, without ``force``; nothing is computed then.

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
    """Refuse forms that do not exist, and those that need packages that are not installed."""
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
    """Write everything that a campaign gave; what cannot be drawn is noted, and the rest is written."""
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
    """Write the paper's figures below ``out`` as SVG and PNG; give their names, and what could not be drawn."""
    from jounce.plots import add_note, paper_figures, render_figure
    from jounce.report.campaign import SYNTHETIC_NOTE

    files: dict[str, bytes | str] = {}
    try:
        for name, figure in paper_figures(result).items():
            add_note(figure, SYNTHETIC_NOTE if result.campaign.synthetic else "")
            drawn = render_figure(figure, (".svg", ".png"))
            files |= {f"figures/paper-{name}{suffix}": content for suffix, content in drawn.items()}
        write_files(out, files, force=force)
    except Exception as error:  # noqa: BLE001 - whatever it is, the results are answered
        return [], [not_drawn("figures of the paper", error)]
    return list(files), []


def reported_page(reported: ReportedCampaign, *, title: str) -> Page:
    """Put on a page what a campaign gave, without its figures; title and report stand in the folder."""
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
