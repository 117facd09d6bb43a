"""Sheets of dampers, and two dampers compared with a tolerance: closed forms, intervals, files."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.report.damper_sheets import comparison_page, sheet_page

SPEEDS = (-0.5, -0.25, -0.1, 0.1, 0.25, 0.5)


def write(file: Path, factor: float = 1.0, half: float | None = 2.0, clicks=(0, 4, 8)) -> Path:
    rows = [
        "clicks,velocity,force,low,high,gas force,gas force low,gas force high,temperature [degC]"
    ]
    for c in clicks:
        for v in SPEEDS:
            force = factor * (1000.0 - 50.0 * c) * v
            ends = ["", ""] if half is None else [force - half, force + half]
            rows.append(",".join(map(str, [c, v, force, *ends, 120, 115, 125, 25])))
    file.write_text("\n".join(rows), encoding="utf-8")
    return file


def test_a_sheet_has_forces_at_standard_speeds_and_nothing_beyond(tmp_path: Path):
    sheet = jn.damper_sheet([write(tmp_path / "left.csv")], serials=["17"])
    (damper,) = sheet.dampers
    assert (damper.name, damper.serial) == ("left", "17")
    rows = {(row.settings["clicks"], row.speed): row for row in damper.rows}
    assert {speed for _, speed in rows} == {0.13, 0.26, 0.39}  # 0.05 and 0.52 m/s were not
    row = rows[4.0, 0.26]
    assert row.bump.value == pytest.approx(800.0 * 0.26)
    assert row.rebound.value == pytest.approx(-800.0 * 0.26)
    assert row.bump.interval == pytest.approx((208.0 - 2.0, 208.0 + 2.0))
    own = jn.damper_sheet([write(tmp_path / "left.csv")], speeds=["100 mm/s", 0.5])
    assert {row.speed for row in own.dampers[0].rows} == {0.1, 0.5}


def test_a_set_puts_dampers_beside_each_other_and_into_files(tmp_path: Path):
    maps = [write(tmp_path / "left.csv"), write(tmp_path / "right.csv", 1.1)]
    sheet = jn.damper_sheet(maps, names=["front left", "front right"], remark="oil 5")
    cells = list(csv.DictReader(io.StringIO(sheet.table())))
    assert {row["damper"] for row in cells} == {"front left", "front right"}
    assert float(cells[0]["temperature [K]"]) == pytest.approx(298.15)
    loads = [
        float(r["bump [N]"]) for r in cells if (r["clicks"], r["speed [m/s]"]) == ("8", "0.13")
    ]
    assert loads == pytest.approx([78.0, 85.8])
    assert set(sheet.sheets()) == {"forces", "conditions"}
    assert sheet.conditions()[1][sheet.conditions()[0].index("gas force [N]")] == 120.0
    page = sheet_page(sheet, title="Front")
    assert [section.title for section in page.sections] == ["Set", "front left", "front right"]
    tables = [block for block in page.sections[0].blocks if hasattr(block, "header")]
    assert [table.header[1:] for table in tables] == [("front left", "front right")] * 3
    assert tables[0].rows[0][0] == "−0.39"
    with pytest.raises(DescriptionError, match="one for each damper"):
        jn.damper_sheet(maps, names=["left"])
    with pytest.raises(DescriptionError, match="no damper map"):
        jn.damper_sheet([])


def test_verdicts_count_the_interval_of_the_difference(tmp_path: Path):
    """2.5 % stronger is within 5 %, 10 % outside; where intervals cross the band nothing is said."""
    left = write(tmp_path / "left.csv")
    same = jn.compare_dampers(left, left)
    assert same.verdict == "within"
    assert max(abs(item.difference.value) for item in same.forces) == 0.0
    near = jn.compare_dampers(left, write(tmp_path / "a.csv", 1.025), tolerance_force=5.0)
    assert near.verdict == "within"
    far = jn.compare_dampers(left, write(tmp_path / "b.csv", 1.1), tolerance_force=5.0)
    assert far.verdict == "outside"
    assert not far.is_met
    for item in far.forces:
        size = 1.05 * abs(item.first)
        assert item.tolerance == pytest.approx(0.05 * size + 5.0)
        away, half = 0.1 * abs(item.first), np.hypot(2.0, 2.0)
        assert abs(item.difference.value) == pytest.approx(away)
        assert item.difference.interval[1] - item.difference.value == pytest.approx(half)
        expected = (
            "outside" if away - half > item.tolerance
            else "within" if away + half <= item.tolerance else "cannot be told"
        )  # fmt: skip
        assert item.verdict == expected
    assert abs(far.worst.velocity) == 0.5
    assert far.worst.clicks == {"clicks": 0.0}
    assert set(far.counts.values()) != {0}
    page = comparison_page(far, title="Pair")
    assert any(getattr(b, "caption", "") == "Forces" for b in page.sections[0].blocks)


def test_without_intervals_nothing_is_decided(tmp_path: Path):
    left = write(tmp_path / "left.csv", half=None)
    pair = jn.compare_dampers(left, write(tmp_path / "right.csv", 1.02))
    assert pair.verdict == "cannot be told"
    assert "dampers.compared_without_interval" in {item.code for item in pair.findings}


def test_clicks_of_one_damper_only_are_interpolated_or_left_out(tmp_path: Path):
    left = write(tmp_path / "left.csv", clicks=(0, 4, 8))
    pair = jn.compare_dampers(left, write(tmp_path / "right.csv", clicks=(0, 2, 8, 12)))
    assert {item.clicks["clicks"] for item in pair.forces} == {0.0, 2.0, 4.0, 8.0}
    assert pair.verdict == "within"
    assert "dampers.clicks_of_one_only" in {item.code for item in pair.findings}
    assert pair.others["gas_force"].value == 0.0
    assert pair.others["gas_force"].interval[1] > 0.0
    other = tmp_path / "other.csv"
    other.write_text(left.read_text().replace("clicks,velocity", "bump clicks,velocity"))
    with pytest.raises(DescriptionError, match="no clicks in common"):
        jn.compare_dampers(left, other)
    with pytest.raises(DescriptionError, match="one for each damper"):
        jn.compare_dampers(left, left, names=["left"])
    with pytest.raises(DescriptionError, match="a tolerance is required"):
        jn.compare_dampers(left, left, tolerance=0.0, tolerance_force=0.0)


def test_both_are_written_as_workbooks_with_every_number(tmp_path: Path):
    openpyxl = pytest.importorskip("openpyxl")
    from jounce.core.workbooks import workbook_of

    left = write(tmp_path / "left.csv")
    for k, result in enumerate((jn.damper_sheet([left]), jn.compare_dampers(left, left))):
        file = tmp_path / f"{k}.xlsx"
        file.write_bytes(workbook_of(result.sheets()))
        sheet = openpyxl.load_workbook(file)["forces"]
        written = list(csv.reader(io.StringIO(result.table())))
        assert sheet.max_row == len(written)
        last = [cell.value for cell in list(sheet.rows)[-1]]
        assert [float(x) for x in written[-1] if x.replace(".", "").lstrip("-").isdigit()] == (
            pytest.approx([x for x in last if isinstance(x, int | float)])
        )
