"""Tables: points in the description or in a file."""

from __future__ import annotations

import numpy as np
import pytest

from jounce.core.errors import DescriptionError, RecordingError
from jounce.roads import Table

X = (0.0, 0.5, 2.0, 3.0, 5.0)
Z = (0.001, 0.01, -0.02, 0.0, 0.03)


def test_lines_between_points_and_the_last_height_held() -> None:
    road = Table(x=X, height=Z, start=1.0)
    x = np.linspace(-1, 9, 901)
    np.testing.assert_allclose(road.height_at(x), np.interp(x - 1.0, X, Z), rtol=0, atol=1e-16)
    assert road.end() == 6.0
    assert road.segments(20.0).edges.tolist() == [0.0, 1.0, 1.5, 3.0, 4.0, 6.0, 20.0]
    assert road.slope_at(1.2) == pytest.approx(0.018, rel=1e-12)


def test_points_on_one_line_are_one_piece() -> None:
    road = Table(x=[0, 1, 2, 3, 4], height=[0, 0, 0, 1, 2])
    assert road.segments(4.0).edges.tolist() == [0.0, 2.0, 4.0]


def test_a_cubic_table_gives_a_cubic_back() -> None:
    # a not-a-knot spline through samples of one cubic is that cubic
    x = np.array([0.0, 0.3, 1.1, 1.9, 3.0])
    road = Table(x=x, height=0.01 - 0.02 * x + 0.03 * x**2 - 0.01 * x**3, interpolation="cubic")
    at = np.linspace(0, 2.99, 200)
    np.testing.assert_allclose(
        road.height_at(at), 0.01 - 0.02 * at + 0.03 * at**2 - 0.01 * at**3, rtol=0, atol=1e-15
    )
    np.testing.assert_allclose(
        road.slope_at(at), -0.02 + 0.06 * at - 0.03 * at**2, rtol=0, atol=1e-14
    )


@pytest.mark.parametrize("interpolation", ["linear", "cubic"])
def test_a_negative_start_begins_inside_the_table(interpolation) -> None:
    inside = Table(x=X, height=Z, start="-1.2 m", interpolation=interpolation)
    whole = Table(x=X, height=Z, interpolation=interpolation)
    x = np.linspace(0, 6, 301)
    np.testing.assert_allclose(inside.height_at(x), whole.height_at(x + 1.2), rtol=0, atol=1e-15)
    cut = inside.segments(6.0)
    np.testing.assert_allclose(cut.evaluate(x)[0], whole.height_at(x + 1.2), rtol=0, atol=1e-15)
    assert cut.edges[0] == 0.0


def test_units_arrays_and_a_closed_loop() -> None:
    road = Table(x=["0 mm", "500 mm", "1 m"], height=np.array([0.0, 0.01, 0.0]), recurrence=1.0)
    assert road.height_at([0.5, 1.5, 7.5]).round(12).tolist() == [0.01] * 3
    with pytest.raises(DescriptionError, match=r"cannot recur: it ends 0\.01 m higher"):
        Table(x=[0, 1], height=[0, 0.01], recurrence=1.0)
    with pytest.raises(DescriptionError, match=r"recurrence 0\.9 m is shorter than its length 1 m"):
        Table(x=[0, 1], height=[0, 0], recurrence=0.9)


@pytest.mark.parametrize(
    ("fields", "says"),
    [
        ({}, "no points; give x and height, or file"),
        ({"x": [0, 1]}, "x has 2 values and height has 0"),
        ({"x": [0, 1], "height": [0, 1, 2]}, "x has 2 values and height has 3"),
        ({"x": [0], "height": [0]}, "1 points; linear interpolation needs at least 2"),
        (
            {"x": [0, 1, 2], "height": [0, 0, 0], "interpolation": "cubic"},
            "3 points; cubic .* at least 4",
        ),
        ({"x": [0, 2, 2], "height": [0, 1, 2]}, r"x\[2\] = 2 is not above x\[1\] = 2"),
        ({"x": [0, 2, 1], "height": [0, 1, 2]}, r"x\[2\] = 1 is not above x\[1\] = 2"),
        ({"x": [0, float("nan")], "height": [0, 1]}, r"x\[1\]: not a finite number"),
        ({"x": [0, 1], "height": [0, "1"]}, r"height\[1\]: the unit is missing"),
        (
            {"x": [0, 1], "height": [0, 1], "file": "profile.csv"},
            "points and a file are both given",
        ),
        (
            {"x": [0, 1], "height": [0, 1], "interpolation": "spline"},
            "interpolation: .*found 'spline'",
        ),
    ],
)
def test_refuses_points(fields, says) -> None:
    with pytest.raises(DescriptionError, match=says):
        Table(**fields)


def test_reads_a_file_in_any_unit_and_order(tmp_path) -> None:
    file = tmp_path / "profile.csv"
    file.write_text("# scanned\nz [mm];quality;x [m]\n1;9;0\n11;9;2\n-4;9;5\n")
    road = Table(file=file)
    np.testing.assert_allclose(
        road.height_at([0, 1, 2, 7]), [0.001, 0.006, 0.011, -0.004], rtol=0, atol=1e-15
    )
    assert road.end() == 5.0
    file.write_text("x [m],z [mm]\n0,1\n1,2\n")  # the file is read again when it has changed
    assert road.end() == 1.0


@pytest.mark.parametrize(
    ("content", "error", "says"),
    [
        (
            "x [m],height [m]\n0,0\n1,1\n",
            RecordingError,
            r"profile\.csv: no column 'z'; found 'x \[m\], height \[m\]'",
        ),
        (
            "x,z [m]\n0,0\n1,1\n",
            RecordingError,
            r"column 'x': the header has no unit; allowed: 'x \[m\]'",
        ),
        ("x [s],z [m]\n0,0\n1,1\n", DescriptionError, r"column 'x \[s\]': wrong unit"),
        ("x [m],z [m]\n0,0\n", RecordingError, "too few rows; found 1; allowed: at least 2"),
        (
            "x [mm],z [m]\n0,0\n2000,1\n1000,1\n",
            RecordingError,
            "row 2 to row 3; found '2 m, then 1 m'",
        ),
        (
            "x [m],z [m]\n0,0\n1,-9999\n2,0\n",
            RecordingError,
            "height jumps implausibly from row 1 to row 2.*-9999 m'. Fill the gap",
        ),
        (
            "x [m],z [m]\n0,0\n1,\n",
            RecordingError,
            r"profile\.csv, line 3: column 'z \[m\]': the cell is blank",
        ),
    ],
)
def test_refuses_files(tmp_path, content, error, says) -> None:
    (tmp_path / "profile.csv").write_text(content)
    with pytest.raises(error, match=says):
        Table(file=tmp_path / "profile.csv")


def test_refuses_a_missing_file(tmp_path) -> None:
    with pytest.raises(RecordingError, match=r"none\.csv: no such file"):
        Table(file=tmp_path / "none.csv")
