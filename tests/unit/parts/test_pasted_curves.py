"""Curves pasted from a spreadsheet: units, order, signs, and rows that are wrong."""

from __future__ import annotations

import pytest

from jounce.core.errors import JounceError
from jounce.parts.importers.curves import read_pasted_curve

ROWS = [(-0.5, -300.0), (0.0, 0.0), (0.5, 200.0)]


@pytest.mark.parametrize("mark", ["\t", ";", ","])
@pytest.mark.parametrize("head", ["velocity [m/s]|force [N]", "v|F", ""])
def test_separators_and_headings(mark: str, head: str) -> None:
    rows = [mark.join(f"{value}" for value in row) for row in ROWS]
    text = "\n".join(([head.replace("|", mark)] if head else []) + rows)
    found = read_pasted_curve(text, "velocity")
    assert list(zip(found.over, found.force, strict=True)) == ROWS
    assert found.is_unit_stated == ("[" in head)


def test_units_of_headings_of_the_caller_and_by_size() -> None:
    stated = read_pasted_curve("s [mm];F [kN]\n0;0\n10,5;0,2\n", "deflection")
    assert (stated.over, stated.force) == ((0.0, 0.0105), (0.0, 200.0))
    given = read_pasted_curve("s;F\n0;0\n1;2\n", "deflection", over_unit="inch", force_unit="lbf")
    assert given.over[1] == pytest.approx(0.0254)
    assert given.force[1] == pytest.approx(8.896443)
    guessed = read_pasted_curve("s;F\n0;0\n15;300\n", "deflection")
    assert (guessed.units, guessed.over[1], guessed.is_unit_stated) == (("mm", "N"), 0.015, False)


def test_rows_are_sorted_and_signs_turned() -> None:
    found = read_pasted_curve("s\tF\n0.02\t5\n0.01\t2\n", "deflection", turned="both")
    assert (found.over, found.force) == ((-0.02, -0.01), (-5.0, -2.0))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("s\tF\n1\t2\n1\t3\n", "line 3"),
        ("s\tF\n1\t2\nx\t3\n", "line 3"),
        ("s\tF\n1\t2\n2\t\n", "table"),
        ("s\tF\tT\n1\t2\t3\n2\t3\t4\n", "not two columns"),
        ("s\tF\n1\t2\n2\t3\t4\n", "line 3"),
        ("s\tF\n1\t2\n", "two rows"),
        ("s [kg]\tF [N]\n1\t2\n2\t3\n", "unit"),
        ("", "empty"),
    ],
)
def test_a_wrong_table_is_refused(text: str, said: str) -> None:
    with pytest.raises(JounceError, match=said):
        read_pasted_curve(text, "deflection")
