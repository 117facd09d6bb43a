"""How far roads are known, and files whose distance or heights are wrong."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from jounce.core.errors import DescriptionError, RecordingError
from jounce.roads import (
    Crg,
    Enveloped,
    HalfSine,
    Iso8608,
    SineSum,
    Table,
    Train,
    load_road,
)

FILES = Path(__file__).parents[2] / "files" / "road_crg"
BUMP = HalfSine(height=0.01, length=0.06)
TABLE = Table(x=[0, 0.5, 1, 4], height=[0, 0.01, 0.01, 0], start="2 m")


@pytest.mark.parametrize(
    ("road", "end", "spacing"),
    [
        (BUMP, math.inf, None),
        (SineSum(), math.inf, None),
        (TABLE, 6.0, 0.5),
        (Train(of=TABLE, count=3, pitch=5), 16.0, 0.5),
        (Enveloped(of=TABLE, method="rigid-circle", radius=0.3), 6.0, 0.5),
        (Enveloped(of=BUMP, method="rigid-circle", radius=0.3), math.inf, None),
        (Iso8608(class_="A", length=100.02, start=-10), 90.02, 100.02 / 2001),
        (Table(x=[0, 1], height=[0, 0], recurrence=2), math.inf, 1.0),
        (Train(of=Table(x=[0, 1], height=[0, 0], recurrence=9), count=2, pitch=2), math.inf, 1.0),
        (Crg(file=FILES / "handmade_curved.crg", v=1.0, start=3), 25.0, None),
        (load_road("detrended_rms_course_1in"), 504.75, 0.05),
    ],
    ids=lambda value: getattr(value, "kind", None),
)
def test_where_the_data_ends(road, end, spacing) -> None:
    assert road.known_length() == pytest.approx(end, abs=1e-2)
    if spacing is not None:
        assert road.point_spacing() == pytest.approx(spacing, rel=1e-6)
    elif not isinstance(road, Crg):
        assert road.point_spacing() is None


def test_a_run_longer_than_the_road_is_refused() -> None:
    TABLE.check_covers(6.0)
    TABLE.check_covers(8.0, behind=2.0)
    BUMP.check_covers(1e6)
    with pytest.raises(
        DescriptionError,
        match=r"^trial: the road is shorter than the run; found '7 m driven'; allowed: up to 6 m",
    ):
        TABLE.check_covers(7.0, where="trial")


@pytest.mark.parametrize(
    "road",
    [
        BUMP,
        TABLE,
        SineSum(),
        Train(of=BUMP, count=2, pitch=1),
        HalfSine(height=1, length=1, recurrence=9),
    ],
)
def test_a_wheel_so_far_behind_that_the_run_is_lost_in_the_digits_is_refused(road) -> None:
    road.segments(10.0, behind=1e9)
    for behind in (1e14, 1e29, -1e29):
        with pytest.raises(
            DescriptionError,
            match=r"implausibly far behind .*; found '-?1e\+(14|29) m'; allowed: up to 1e\+13 m",
        ):
            road.segments(10.0, behind=behind)


def test_points_of_tables(tmp_path) -> None:
    x, z = TABLE.points()
    assert (x.tolist(), z.tolist()) == ([0, 0.5, 1, 4], [0, 0.01, 0.01, 0])
    file = tmp_path / "lane.csv"
    file.write_text("x [mm],z [mm]\n0,1\n500,2\n1000,2\n1500,2\n")
    x, z = Table(file=file).points()  # all of them, also those on one line
    np.testing.assert_allclose((x, z), [[0, 0.5, 1, 1.5], [0.001, 0.002, 0.002, 0.002]], rtol=1e-12)


@pytest.mark.parametrize(
    ("rows", "says"),
    [
        (
            "2,0\n1,0\n0,1\n",
            r"lane\.csv: column 'x \[m\]': x decreases; found '2 to 0 m'\. Reverse the order",
        ),
        ("0,0\n2,0\n1,1\n", r"x does not increase from row 2 to row 3"),
        ("0,0\n1,0\n1,1\n", r"x does not increase from row 2 to row 3; found '1 m, then 1 m'"),
        ("0,0\n1,1\nNaN,NaN\n", r"line 4: column 'x \[m\]': not a finite number; found 'NaN'"),
        ("0,0\n1,nan\n2,1\n", r"line 3: column 'z \[m\]': not a finite number; found 'nan'"),
        ("0,0\n1,\n2,1\n", r"line 3: column 'z \[m\]': the cell is blank"),
        ("0,0\n1,inf\n2,1\n", r"not a finite number; found 'inf'"),
    ],
)
def test_refuses_profiles(tmp_path, rows, says) -> None:
    (tmp_path / "lane.csv").write_text(f"x [m],z [m]\n{rows}")
    with pytest.raises(RecordingError, match=says):
        load_road(tmp_path / "lane.csv")


def test_uneven_distances_are_taken_as_they_are(tmp_path) -> None:
    (tmp_path / "lane.csv").write_text("x [m],z [m]\n0,0\n1,0.1\n1.5,0\n7,0.2\n")
    assert load_road(tmp_path / "lane.csv").height_at([0.5, 1.25, 4.25]) == pytest.approx(
        [0.05, 0.05, 0.1]
    )
