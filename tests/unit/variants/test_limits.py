"""Speeds at which limits are reached: several crossings, narrow ones, gaps, and the obstacle curve."""

from __future__ import annotations

import math

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.variants.limits import find_crossings, find_speed_limits

RIG = jn.load("audi-a6-quarter-car")
BUMP = jn.HalfSine(height="100 mm", length="0.6 m")
GRID = np.geomspace(1.0, 30.0, 12)


def test_a_growing_metric_is_crossed_once() -> None:
    ((speed, is_exceeded),) = find_crossings(lambda v: v**2 - 50.0, GRID)
    assert is_exceeded
    assert speed == pytest.approx(math.sqrt(50.0), rel=3e-3)


def test_all_crossings_are_found_in_order() -> None:
    crossings = find_crossings(lambda v: math.sin(0.5 * v), np.linspace(1.0, 20.0, 20))
    assert [above for _, above in crossings] == [False, True, False]
    assert [speed for speed, _ in crossings] == pytest.approx(
        [2.0 * math.pi * k for k in (1, 2, 3)], rel=3e-3
    )


def test_a_narrow_summit_near_the_limit_is_found_between_the_first_speeds() -> None:
    """The summit lies between two speeds of the grid and is above the limit nowhere on it."""
    grid = np.linspace(1.0, 9.0, 9)

    def excess(v: float) -> float:
        return 0.2 - (v - 4.6) ** 2

    assert max(excess(float(v)) for v in grid if v != 5.0) < 0.0
    shifted = [float(v) for v in grid - 0.09]  # 4.91: excess 0.1 above; 4.51 is not on the grid
    crossings = find_crossings(excess, np.array(shifted))
    assert [above for _, above in crossings] == [True, False]
    narrow = find_crossings(lambda v: 0.01 - (v - 4.5) ** 2, grid)
    assert [speed for speed, _ in narrow] == pytest.approx([4.4, 4.6], rel=3e-3)


def test_a_narrow_valley_below_the_limit_is_found() -> None:
    narrow = find_crossings(lambda v: (v - 4.5) ** 2 - 0.01, np.linspace(1.0, 9.0, 9))
    assert [above for _, above in narrow] == [False, True]


def test_gaps_make_no_crossing() -> None:
    def excess(v: float) -> float:
        return math.nan if 4.0 < v < 6.0 else v - 5.0

    assert find_crossings(excess, np.linspace(1.0, 9.0, 9)) == []


def test_six_watts_on_a_rough_road() -> None:
    found = find_speed_limits(RIG, "iso:E", slowest=4.0, fastest=12.0, points=4, length="100 m")
    (curve,) = found.curves
    assert (curve.metric, curve.unit, curve.limit) == ("absorbed_power sprung.az", "W", 6.0)
    at = found.limit_speed()
    assert at is not None
    again = find_speed_limits(
        RIG, "iso:E", slowest=4.0, fastest=at, points=3, length="100 m"
    ).curves[0]
    assert again.values[again.speed == at][0] == pytest.approx(6.0, rel=0.02)
    assert found.table().startswith("metric,unit,limit,height [m],speed [m/s],value\n")


def test_a_limit_that_is_kept_again_above_is_reported_with_all_its_crossings() -> None:
    found = find_speed_limits(
        RIG, BUMP, {"shock sprung.az": "19 m/s^2"}, slowest=1.5, fastest=40.0, points=12
    )
    (curve,) = found.curves
    assert [item.is_exceeded_above for item in curve.crossings] == [True, False]
    assert found.limit_speed() == curve.crossings[0].speed
    (said,) = found.findings
    assert said.code == "variants.limit_crossed_again"
    assert "(>)" in said.message
    assert "(<)" in said.message


def test_the_obstacle_curve_falls_with_height() -> None:
    found = find_speed_limits(
        RIG, BUMP, {"shock sprung.az": "1.2 g", "min tyre.force": 100.0},
        slowest=1.0, fastest=15.0, heights=["140 mm", 0.06, "100 mm"], points=7,
    )  # fmt: skip
    assert found.heights == (0.06, 0.1, 0.14)
    shocks = [curve.limit_speed for curve in found.curves if curve.metric.startswith("shock")]
    assert shocks == sorted(shocks, reverse=True)
    assert shocks[0] > 1.5 * shocks[2]
    lifted = [curve for curve in found.curves if curve.metric.startswith("min")]
    for curve in lifted:  # a lower limit: exceeded where the load is below it
        for speed, value in zip(curve.speed, curve.values, strict=True):
            if curve.limit_speed is not None and speed < 0.98 * curve.limit_speed:
                assert value > 100.0
    plain = found.to_dict()["lowest"]
    assert [row["height"] for row in plain] == [0.06, 0.1, 0.14]
    with pytest.raises(DescriptionError, match="no such height"):
        found.limit_speed(0.2)


def test_limits_at_the_ends_of_the_range() -> None:
    low, high = (
        find_speed_limits(RIG, BUMP, {"peak sprung.az": limit}, slowest=5.0, fastest=9.0, points=3)
        for limit in (1.0, 1000.0)
    )
    assert low.limit_speed() == 5.0
    assert [item.code for item in low.findings] == ["variants.limit_always_exceeded"]
    assert high.limit_speed() is None
    assert [item.code for item in high.findings] == ["variants.limit_never_reached"]


@pytest.mark.parametrize(
    ("options", "match"),
    [
        ({"slowest": 9.0, "fastest": 5.0}, "no range of speeds"),
        ({"points": 2}, "out of range"),
        ({"limits": {"absorbed_power tyre.force": 6.0}}, "only for accelerations"),
        ({"limits": {"rms nothing": 6.0}}, "unknown channel"),
        ({"limits": {"peak sprung.az": "3 kg"}}, "unit"),
        ({"heights": ["-1 mm"]}, "heights"),
        ({"road": "iso:C", "heights": ["10 mm"]}, "no height to replace"),
        ({"road": "iso:C:3", "seed": 4}, "two different seeds"),
    ],
)
def test_refusals(options: dict[str, object], match: str) -> None:
    given = {"road": BUMP, **options}
    with pytest.raises(DescriptionError, match=match):
        find_speed_limits(RIG, **given)


def test_figure_and_page() -> None:
    found = find_speed_limits(
        RIG, BUMP, slowest=2.0, fastest=10.0, heights=["60 mm", "140 mm"], points=5
    )
    figure = jn.plots.figure_of(found)
    assert [axis.get_xlabel() for axis in figure.axes] == ["speed [m/s]", "obstacle height [mm]"]
    from jounce.report.speed_limits import speed_limits_page

    page = speed_limits_page(found, title="Bump")
    assert page.title == "Bump"
