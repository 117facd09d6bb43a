"""What a page shows leaves it: pictures, documents, tables; what is no figure or table is refused."""

from __future__ import annotations

import csv
import io
import struct
import zipfile
from typing import Any

import numpy as np
import pytest

from jounce.core.errors import JounceError

pytest.importorskip("fastapi")
pydantic = pytest.importorskip("pydantic")

TIME = np.linspace(0.0, 1.0, 101)
WAVE = np.sin(9.0 * TIME)
CHART: dict[str, Any] = {
    "kind": "chart",
    "caption": "Half sine",
    "x_label": "time [s]",
    "x": TIME.tolist(),
    "panels": [
        {
            "title": "acceleration",
            "unit": "m/s²",
            "curves": [
                {"label": "changed", "y": WAVE.tolist()},
                {"label": "saved", "role": "before", "y": [None, *WAVE[1:].tolist()]},
            ],
        },
        {"title": "force", "unit": "N", "curves": [{"y": (100.0 * WAVE).tolist()}]},
    ],
}
TABLE: dict[str, Any] = {
    "kind": "table",
    "caption": "Modes",
    "header": ["mode", "frequency [Hz]"],
    "rows": [["body", "1.5"], ["=wheel", "−12.25"]],
    "numbers": [1],
}


def export(
    form: str, *blocks: dict[str, Any], title: str = "Kart: over Größe", **others: Any
) -> bytes:
    from jounce.web.exports import Exported, exported

    return exported(
        Exported.model_validate({"title": title, "form": form, "blocks": list(blocks), **others})
    )


def test_curves_are_numbers_again_from_csv() -> None:
    text = export("csv", CHART).decode("utf-8-sig")
    header, *rows = csv.reader(io.StringIO(text))
    assert header == [
        "time [s]",
        "acceleration, changed [m/s²]",
        "acceleration, saved [m/s²]",
        "force [N]",
    ]
    assert rows[0] == ["0", "0", "", "0"]
    values = np.array([[float(cell) for cell in row] for row in rows[1:]])
    np.testing.assert_allclose(
        values, np.column_stack([TIME, WAVE, WAVE, 100.0 * WAVE])[1:], rtol=1e-9, atol=1e-12
    )


def test_only_the_part_that_is_seen_is_saved() -> None:
    rows = export("csv", CHART | {"window": [0.25, 0.5]}).decode("utf-8-sig").splitlines()[1:]
    assert [float(row.split(",")[0]) for row in (rows[0], rows[-1])] == pytest.approx([0.25, 0.5])


@pytest.mark.parametrize("scale", [1.0, 2.0, 4.0])
def test_a_picture_has_the_resolution_that_was_asked_for(scale: float) -> None:
    pytest.importorskip("typst")
    content = export("png", CHART, scale=scale)
    assert content.startswith(b"\x89PNG")
    width, height = struct.unpack(">II", content[16:24])
    assert (width, height) == (pytest.approx(880 * scale, abs=1), pytest.approx(460 * scale, abs=1))


def test_a_drawing_needs_no_style_sheet_of_a_page() -> None:
    text = export("svg", CHART).decode()
    assert text.startswith("<svg xmlns=")
    assert "var(--" not in text
    assert "time [s]" in text
    assert "acceleration" in text


def test_a_page_is_a_document_and_a_workbook() -> None:
    pytest.importorskip("typst")
    openpyxl = pytest.importorskip("openpyxl")
    blocks = [
        {"kind": "heading", "text": "Run"},
        {"kind": "text", "text": "It rides <well>."},
        CHART,
        TABLE,
    ]
    assert export("pdf", *blocks).startswith(b"%PDF")
    page = export("html", *blocks).decode()
    assert "It rides &lt;well&gt;." in page
    assert page.count("<svg") >= 2
    assert "<th" in page
    content = export("xlsx", *blocks)
    assert zipfile.is_zipfile(io.BytesIO(content))
    book = openpyxl.load_workbook(io.BytesIO(content))
    (curves, modes) = book.worksheets[1:]
    assert [cell.value for cell in curves[1]][:2] == ["time [s]", "acceleration, changed [m/s²]"]
    assert curves.cell(102, 4).value == pytest.approx(100.0 * np.sin(9.0), rel=1e-9)
    assert [cell.value for cell in modes[3]] == ["=wheel", -12.25]
    assert modes.cell(3, 1).data_type == "s"  # a text that begins like a formula stays a text


def test_what_is_asked_for_without_sense_is_refused() -> None:
    with pytest.raises(JounceError, match="svg: this format can contain only one figure; found 0"):
        export("svg", TABLE)
    with pytest.raises(
        JounceError, match="a CSV file can contain only one figure or table; found 2"
    ):
        export("csv", CHART, TABLE)
    with pytest.raises(JounceError, match="there is no table or curve to export"):
        export("xlsx", {"kind": "text", "text": "alone"})
    for block in (
        CHART | {"x": [0.0]},
        TABLE | {"rows": [["one"]]},
        CHART | {"panels": []},
        CHART
        | {"panels": [{"title": "x", "curves": [{"y": TIME.tolist(), "role": '"><script>'}]}]},
    ):
        with pytest.raises(pydantic.ValidationError):
            export("html", block)


def test_a_name_is_one_that_every_system_takes() -> None:
    from jounce.web.exports import Exported, file_name

    asked = Exported.model_validate({"title": 'a/b: "Größe"', "form": "csv", "blocks": [TABLE]})
    assert file_name(asked) == "a-b-grosse.csv"


DRAWING: dict[str, Any] = {
    "kind": "drawing",
    "caption": "Mechanism",
    "width": 300,
    "height": 200,
    "shapes": [
        {"d": "M10 10L100 50", "stroke": "#0067b1", "width": 3.5, "dash": [4, 2], "alpha": 0.5},
        {"d": "M10 10A5 5 0 1 0 20 10A5 5 0 1 0 10 10Z", "fill": "#22262b"},
    ],
    "names": [{"text": "<ball joint>", "x": 20, "y": 30}],
}


def test_a_drawing_leaves_as_paths_that_stay_sharp() -> None:
    svg = export("svg", DRAWING).decode()
    assert 'd="M10 10L100 50"' in svg
    assert "&lt;ball joint&gt;" in svg
    pytest.importorskip("typst")
    assert export("pdf", DRAWING).startswith(b"%PDF")
    assert export("png", DRAWING, scale=1.0)[16:24] == struct.pack(">II", 300, 200)
    page = export("html", {"kind": "heading", "text": "Mechanism"}, DRAWING, CHART).decode()
    assert 'd="M10 10L100 50"' in page


@pytest.mark.parametrize(
    "shape",
    [
        {"d": 'M0 0"/><script>', "stroke": "#000000"},
        {"d": "M0 0", "stroke": "url(http://elsewhere)"},
        {"d": "M0 0", "stroke": "#000000", "width": float("nan")},
        {"d": "M0 0", "href": "file:///etc/passwd"},
    ],
)
def test_a_drawing_is_paths_and_nothing_else(shape: dict[str, Any]) -> None:
    with pytest.raises(pydantic.ValidationError):
        export("svg", DRAWING | {"shapes": [shape]})


def test_compared_curves_have_line_styles_and_the_first_on_top() -> None:
    roles = ["after", "other-5", "other-1", "other-2"]
    curves = [
        {"label": role, "role": role, "y": (WAVE * k).tolist()} for k, role in enumerate(roles)
    ]
    chart = CHART | {"panels": [{"title": "force", "unit": "N", "curves": curves}]}
    svg = export("svg", chart).decode()
    drawn = [svg.index(f'class="l q {role} ') for role in roles]
    assert drawn == sorted(drawn, reverse=True)
    for style in ("dashed", "dotted", "dash-dotted"):
        assert f".chart .{style}{{stroke-dasharray:" in svg
