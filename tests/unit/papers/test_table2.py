"""The trial matrix of the prototype paper."""

import math

import pytest

from jounce.core.errors import DescriptionError
from jounce.papers.table2 import table2

# Quarter-car prototype paper, Table 2: the printed speeds by trial number.
SPEEDS = [
    1.95,
    2.86,
    3.79,
    1.97,
    1.92,
    1.99,
    2.03,
    2.06,
    1.92,
    2.90,
    3.87,
    2.03,
    1.97,
    2.01,
    2.01,
    2.01,
]


@pytest.mark.parametrize("variant", ["reconstructed", "literal"])
def test_both_readings_have_the_printed_speeds_in_order(variant):
    rows = table2(variant)
    assert [row.number for row in rows] == list(range(1, 17))
    assert [row.speed for row in rows] == SPEEDS


def test_the_reconstruction_has_two_equal_blocks_one_for_each_pressure():
    rows = table2()
    blocks = [rows[:8], rows[8:]]
    assert [{row.tyre_pressure for row in block} for block in blocks] == [{310e3}, {250e3}]
    settings = [
        sorted((round(math.degrees(r.strut_angle)), r.pitch or 0.0) for r in block)
        for block in blocks
    ]
    assert settings[0] == settings[1]
    assert settings[0] == [
        (10, 0.0),
        (16, 0.0),
        (26, 0.0),
        (26, 0.0),
        (26, 0.0),
        (26, 0.1),
        (26, 0.15),
        (26, 0.2),
    ]


def test_trains_are_driven_at_about_two_metres_a_second_in_the_reconstruction():
    # the digest of the paper gives pass frequencies of about 19.7, 12.8-13.4 and 9.95-10.05 Hz
    frequencies = {row.pitch: [] for row in table2() if row.pitch}
    for row in table2():
        if row.pitch:
            frequencies[row.pitch].append(row.speed / row.pitch)
    assert frequencies[0.10] == pytest.approx([19.7, 20.1], abs=0.05)
    assert frequencies[0.15] == pytest.approx([12.8, 13.4], abs=0.05)
    assert frequencies[0.20] == pytest.approx([9.95, 10.05], abs=0.01)


def test_the_literal_reading_keeps_the_cells_where_they_are_printed():
    rows = {row.number: row for row in table2("literal")}
    assert [rows[n].road for n in (4, 5, 6, 7, 14, 15, 16, 12)] == [
        "A",
        "B10",
        "B15",
        "B20",
        "A",
        "B10",
        "B15",
        "B20",
    ]
    assert [n for n, row in rows.items() if row.tyre_pressure == 310e3] == [1, 2, 3, 4, 5, 6, 7]
    assert [round(math.degrees(rows[n].strut_angle)) for n in (8, 9, 13)] == [16, 10, 16]


def test_an_unknown_reading_is_refused():
    with pytest.raises(DescriptionError, match="literal"):
        table2("litteral")
