from __future__ import annotations

import re
from pathlib import Path

import pytest

from jounce.core.errors import OutputError
from jounce.core.findings import Finding
from jounce.core.text import slug
from jounce.plots import new_figure
from jounce.report import (
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
)
from jounce.report import write_page as write
from jounce.report.page import group_findings, unique_slugs, worst_first
from jounce.report.render import inline_svg

BOTH = ("svg", "png")


def picture(name: str) -> Picture:
    figure = new_figure(1.5, 3.0)
    figure.subplots().plot([0.0, 1.0], label="<line>")
    return Picture(figure, name, "A line.", 'A "line" <rising>')


def page(*blocks: object, **options: object) -> Page:
    return Page("A & B", (Section("One <1>", blocks), Section("Two", ())), **options)  # type: ignore[arg-type]


def test_everything_is_shown_and_escaped(tmp_path: Path) -> None:
    nested = Details(
        "More <i>", (Subsection("Deep", (Bullets(("<li>first", "second")),)),), is_open=True
    )
    table = PageTable(
        "Numbers", ("name", "value [mm]"), (("a<b", Cell("1.0", "bad", "note")),), "lr", "small"
    )
    facts = Facts((Fact("label", "42 %", "<note>", "good"),))
    found = Findings((Finding("trial 1", "problem", "x < y"),))
    write(
        page(Paragraph("a < b & c"), table, facts, found, nested, picture("p")),
        tmp_path / "out",
        figures=BOTH,
    )
    html = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    for text in (
        "a &lt; b &amp; c",
        "a&lt;b",
        "&lt;note&gt;",
        "x &lt; y",
        "&lt;li&gt;first",
        "More &lt;i&gt;",
        "A &amp; B",
    ):
        assert text in html
    assert "<details open>" in html
    assert '<th scope="col" class="right">value [mm]</th>' in html
    assert 'class="right bad"' in html
    assert "&#34;line&#34; &lt;rising&gt;" in html or "&quot;line&quot; &lt;rising&gt;" in html
    assert sorted(file.name for file in (tmp_path / "out" / "figures").iterdir()) == [
        "p.png",
        "p.svg",
    ]


def test_bytes_are_the_same_each_time(tmp_path: Path) -> None:
    for name in ("a", "b"):
        write(page(picture("p"), picture("q")), tmp_path / name, figures=BOTH)
    for file in ("report.html", "figures/p.svg", "figures/q.png"):
        assert (tmp_path / "a" / file).read_bytes() == (tmp_path / "b" / file).read_bytes()


def test_two_figures_of_one_name(tmp_path: Path) -> None:
    with pytest.raises(OutputError, match=r"two figures have the same name.*'p'"):
        write(page(picture("p"), Details("x", (picture("p"),))), tmp_path / "out")
    assert list(tmp_path.iterdir()) == []


def test_full_folder_is_refused_before_any_drawing(tmp_path: Path) -> None:
    (tmp_path / "mine").write_text("x", encoding="utf-8")
    said: list[str] = []
    with pytest.raises(OutputError, match="not empty"):
        write(page(picture("p")), tmp_path, progress=said.append)
    assert said == []


def test_banner_on_every_section_and_in_every_figure(tmp_path: Path) -> None:
    write(
        page(picture("p"), banner="Synthetic: made up.", figure_note="Synthetic data"),
        tmp_path / "out",
        figures=BOTH,
    )
    html = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert html.count('<span class="tag">Synthetic data</span>') == 2
    assert '<p class="banner" role="note">Synthetic: made up.</p>' in html
    assert 'class="print-head"' in html
    assert "Synthetic data" in (tmp_path / "out" / "figures" / "p.svg").read_text(encoding="utf-8")


def test_further_files_stand_beside_the_page(tmp_path: Path) -> None:
    files = write(page(files=(("a.toml", "x = 1\n"),), name="index.html"), tmp_path / "out")
    assert [file.name for file in files] == ["index.html", "a.toml"]
    assert files[1].read_text(encoding="utf-8") == "x = 1\n"


def test_names_in_figures_do_not_collide() -> None:
    svg = b'<?xml?><svg width="547pt" height="9pt"><metadata>x</metadata><g id="a" clip-path="url(#c)"/></svg>'
    one = inline_svg(svg, "fig-1", "words")
    assert 'id="fig-1-a"' in one
    assert "url(#fig-1-c)" in one
    assert "metadata" not in one
    assert 'role="img" aria-labelledby="fig-1-title"' in one
    assert '<title id="fig-1-title">words</title>' in one
    assert re.search(r'width="547pt"', one) is None


def test_findings_are_grouped_worst_first() -> None:
    items = (
        Finding("a", "note", "same"),
        Finding("b", "note", "same"),
        Finding("c", "problem", "bad"),
        Finding("a", "note", "same"),
        Finding("d", "warning", "weak"),
    )
    assert group_findings(Findings(items)) == [
        ("problem", "Problems", [("c", "bad")]),
        ("warning", "Warnings", [("d", "weak")]),
        ("note", "Notes", [("a, b", "same")]),
    ]
    assert [row[0] for row in group_findings(Findings(items, most=1))] == ["problem"]
    assert [item.severity for item in worst_first(items)] == [
        "problem",
        "warning",
        "note",
        "note",
        "note",
    ]


def test_many_places_are_counted() -> None:
    items = tuple(Finding(f"t{k}", "note", "same") for k in range(9))
    assert group_findings(Findings(items))[0][2] == [("t0, t1, t2, t3, t4, t5 and 3 more", "same")]


def test_slugs() -> None:
    assert slug("../../etc/passwd") == "etc-passwd"
    assert slug("Straße 5") == "strasse-5"
    assert unique_slugs(["a", "A", "a-2", "?"]) == ["a", "a-2", "a-2-2", "unnamed"]


def test_negative_numbers_in_findings_have_a_minus_as_in_tables() -> None:
    found = Findings(
        (Finding("a", "note", "moved by -0.5 (-3 to -1e-05), ISO 2631-1 of 2026-11-22"),)
    )
    assert (
        group_findings(found)[0][2][0][1]
        == "moved by −0.5 (−3 to −1e-05), ISO 2631-1 of 2026-11-22"
    )
