"""Pages as PDF, and their tables as CSV and one workbook."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path
from typing import Any

import pytest

from jounce.campaign.result import CampaignResult
from jounce.core.errors import JounceError
from jounce.core.findings import Finding
from jounce.plots import new_figure
from jounce.report import (
    REPORTS,
    Bullets,
    Cell,
    Details,
    Fact,
    Facts,
    Findings,
    Page,
    PageTable,
    Paragraph,
    Picture,
    Section,
    Subsection,
    write_campaign,
    write_page,
)
from jounce.report.chart import Chart, Panel, Series
from jounce.report.document import _blocks, page_pdf, table_csv, tables_of, tables_xlsx
from jounce.report.render import TEMPLATES
from jounce.report.typeset import typeset

HOSTILE = '#panic("x") $ \\ */ // ` <script> @ref = "' + "漢字" * 20 + "x" * 300


def page(*blocks: object) -> Page:
    return Page(HOSTILE, (Section(HOSTILE, blocks),), HOSTILE, HOSTILE, "Synthetic data")  # type: ignore[arg-type]


def everything() -> Page:
    figure = new_figure(1.5, 3.0)
    figure.subplots().plot([0.0, 1.0], label=HOSTILE)
    chart = Chart(
        (Panel((Series([0.0, 1.0], [0.0, 1.0], label=HOSTILE),), HOSTILE),) * 5,
        "c",
        HOSTILE,
        HOSTILE,
    )
    return page(
        Paragraph(HOSTILE, "bad"),
        Bullets((HOSTILE,)),
        Facts((Fact(HOSTILE, HOSTILE, HOSTILE, "good"),) * 5),
        PageTable(
            HOSTILE,
            (HOSTILE,) * 3,
            (("a", Cell(HOSTILE, "fair", HOSTILE), "1.0"),) * 60,
            "lrc",
            HOSTILE,
        ),
        Findings((Finding(HOSTILE, "problem", HOSTILE), Finding("p", "note", "n"))),
        Findings(()),
        Details(
            HOSTILE,
            (
                Subsection(
                    HOSTILE, (Paragraph("deep"), Picture(figure, "p", HOSTILE, HOSTILE), chart)
                ),
            ),
        ),
    )


def test_any_text_is_printed_and_not_run(tmp_path: Path) -> None:
    files = write_page(everything(), tmp_path / "out", pdf=True)
    pdf = next(file for file in files if file.suffix == ".pdf").read_bytes()
    assert pdf.startswith(b"%PDF")
    write_page(everything(), tmp_path / "again", pdf=True)
    assert (tmp_path / "again" / "report.pdf").read_bytes() == pdf


def test_a_campaign_s_document_is_the_same_each_time(
    result: CampaignResult, tmp_path: Path
) -> None:
    for name in ("a", "b"):
        write_campaign(result, tmp_path / name, pdf=True, tables=("csv", "xlsx"))
    for file in (
        "report.pdf",
        "tables.xlsx",
        *(f"tables/{f.name}" for f in (tmp_path / "a" / "tables").iterdir()),
    ):
        assert (tmp_path / "a" / file).read_bytes() == (tmp_path / "b" / file).read_bytes()


def test_no_column_leaves_the_page() -> None:
    """Seen in the picture of the page: its right margin stays white, however wide a table is."""
    from PIL import Image

    header = tuple(f"column {k} [N/mm]" for k in range(11))
    row = ("a name of some length", *("1.2345 → 0.9876" for _ in range(9)), "holds partly")
    wide = Page("Wide", (Section("s", (PageTable("t", header, (row,) * 3, "l" + "r" * 10),)),))
    files = {"main.typ": (TEMPLATES / "page.typ").read_bytes()}
    kept: dict[str, bytes] = {}

    def keep(given: dict[str, bytes], *_: object) -> bytes:
        kept.update(given)
        return b""

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("jounce.report.document.typeset", keep)
        page_pdf(wide, {}, files["main.typ"])
    picture = Image.open(io.BytesIO(typeset(kept, "png", ppi=72.0)[0])).convert("L")
    margin = picture.crop((picture.width - 30, 60, picture.width, picture.height - 60))
    assert margin.getextrema() == (255, 255)


def test_tables_hold_numbers_and_no_formula() -> None:
    table = PageTable(
        "A/B",
        ("=name", "value [mm]", "word"),
        (("=1+1", "−0.50", Cell("good", "good", "of all")), ("+x", "–", "-")),
    )
    rows = list(csv.reader(io.StringIO(table_csv(table))))
    assert rows == [
        ["'=name", "value [mm]", "word"],
        ["'=1+1", "-0.50", "good (of all)"],
        ["'+x", "–", "'-"],
    ]
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.load_workbook(io.BytesIO(tables_xlsx(page(table, Details("d", (table,))))))
    assert book.sheetnames == ["Contents", "01-a-b", "02-a-b"]
    sheet = book["01-a-b"]
    assert [[cell.value for cell in row] for row in sheet.iter_rows()] == [
        ["=name", "value [mm]", "word"],
        ["=1+1", -0.5, "good (of all)"],
        ["+x", "–", "-"],
    ]
    assert {cell.data_type for row in sheet.iter_rows() for cell in row} == {"s", "n"}
    assert list(tables_of(page(table))) == ["01-a-b"]


def test_unknown_formats_are_refused_before_any_work(tmp_path: Path) -> None:
    for options in ({"figures": ["gif"]}, {"tables": ["ods"]}):
        with pytest.raises(JounceError, match=r"unknown format of .*allowed"):
            write_page(everything(), tmp_path / "out", **options)
    assert list(tmp_path.iterdir()) == []


def test_on_paper_figures_stand_alone_where_a_page_has_them_below_what_moves() -> None:
    still = Details("The same as a figure", (Paragraph("drawn"),), is_still=True)
    folded = Details("More", (Paragraph("told"),))
    assert [
        (one["kind"], one.get("text", one.get("title"))) for one in _blocks((still, folded), {})
    ] == [
        ("Paragraph", "drawn"),
        ("Group", "More"),
    ]


@pytest.mark.parametrize(("title", "is_covered"), [("Größe ω² ≤ 3 N·s/m", True), ("漢字", False)])
def test_fonts_of_the_computer_serve_letters_that_no_other_has(
    title: str, is_covered: bool, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    import typst

    asked: list[dict[str, Any]] = []
    files: list[dict[str, bytes]] = []

    def compile_(content: dict[str, bytes], **options: Any) -> bytes:
        files.append(content)
        asked.append(options)
        return b"%PDF"

    monkeypatch.setattr(typst, "compile", compile_)
    REPORTS.write(Page(title, (Section("s", (Paragraph("p"),)),)), tmp_path / "a.pdf")
    assert asked[0]["ignore_system_fonts"] is is_covered
    assert ("a browser shows them" in json.loads(files[0]["page.json"])["foot"]) is not is_covered
