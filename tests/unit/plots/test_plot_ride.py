"""Pictures of ride studies: every controller is named, spectra have their axes."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.plots.labels import LabelLayout
from jounce.ride.study import RideStudy


@pytest.fixture(scope="module")
def study() -> RideStudy:
    car = jn.load("audi-a6-half-car-4dof")
    return jn.compare_rides(
        car, jn.iso_trial(car, "C", "20 m/s", duration="5 s"), ["passive", "skyhook", "lqr"]
    )


def test_trade_off_names_every_controller(study: RideStudy) -> None:
    axes = jn.plots.figure_of(study).axes[0]
    assert {text.get_text() for text in axes.texts} == {"passive", "skyhook", "lqr"}
    assert axes.get_xlabel() == "body, weighted r.m.s. (Wk) [m/s²]"
    assert "wheel load" in axes.get_ylabel()
    left = axes.get_xlim()[0]
    assert left < min(ride.merits["comfort"] for ride in study.rides)


def test_trade_off_without_tyres_shows_travel() -> None:
    car = jn.load("audi-a6-half-car")
    found = jn.compare_rides(car, jn.iso_trial(car, "C", "20 m/s", duration="5 s"), ["passive"])
    assert "travel" in jn.plots.figure_of(found).axes[0].get_ylabel()


def test_spectra_show_body_and_wheel_load(study: RideStudy) -> None:
    figure = jn.plots.figure_of(study.rides[0])
    assert [axes.get_title("left") for axes in figure.axes] == [
        "body.az",
        "front.tyre.force",
        "rear.tyre.force",
    ]
    assert figure.axes[-1].get_xlabel() == "frequency [Hz]"


def test_spectra_and_deviations_leave_the_settling_time_out(study: RideStudy) -> None:
    ride = study.ride("passive")
    assert ride.settling == study.trial.settling > 0.0
    settled = ride.run["body.az"].sel(time=slice(ride.settling, None))
    assert (
        ride.standard_deviation("body.az")
        == float(settled.std())
        != float(ride.run["body.az"].std())
    )
    drawn = jn.plots.figure_of(ride).axes[0].lines[0]
    rate, segment = (
        1.0 / float(settled["time"][1] - settled["time"][0]),
        min(max(ride.duration / 8, 8), ride.duration / 2),
    )
    expected = jn.power_spectrum(settled.to_numpy(), rate, segment=segment)
    assert drawn.get_ydata() == pytest.approx(
        expected.density[1 : 1 + len(drawn.get_ydata())], rel=1e-12
    )


def crowded() -> LabelLayout:
    """Three heaps of points, the last one in a corner of the frame."""
    points = np.array(
        [[200.0 + 4 * i, 150.0 + 3 * (i % 3)] for i in range(6)]
        + [[80.0, 250.0 + i] for i in range(4)]
    )
    points = np.vstack([points, [[398.0, 3.0], [396.0, 5.0], [399.0, 9.0]]])
    sizes = np.column_stack([30.0 + 6.0 * (np.arange(len(points)) % 7), np.full(len(points), 9.0)])
    return LabelLayout(
        points, 3.0 + np.arange(len(points)) % 4, sizes, np.zeros(2), np.array([400.0, 300.0])
    )


def test_names_cover_neither_names_nor_points() -> None:
    layout = crowded()
    centres = layout.place_all()
    low, high = centres - 0.5 * layout.sizes, centres + 0.5 * layout.sizes
    assert (low > 0.0).all()
    assert (high < [400.0, 300.0]).all()
    for i in range(len(centres)):
        for j in range(i):
            assert (np.maximum(low[i], low[j]) >= np.minimum(high[i], high[j])).any(), (i, j)
        nearest = np.clip(layout.points, low[i], high[i])
        assert (np.linalg.norm(nearest - layout.points, axis=1) >= layout.radii).all(), i


def test_lines_to_names_do_not_cross() -> None:
    layout = crowded()
    centres = layout.place_all()
    lines = [(layout.points[i], layout.edge(i, centres[i][None])[0]) for i in range(len(centres))]
    for i, (a, b) in enumerate(lines):
        for c, d in lines[:i]:
            sides = [
                np.linalg.det(np.array([q - p, r - p]))
                for p, q, r in ((a, b, c), (a, b, d), (c, d, a), (c, d, b))
            ]
            assert not (sides[0] * sides[1] < 0.0 and sides[2] * sides[3] < 0.0)


def test_a_lone_name_stands_close_to_the_right() -> None:
    study_of_one = LabelLayout(
        np.array([[10.0, 20.0]]),
        np.array([4.0]),
        np.array([[30.0, 8.0]]),
        np.zeros(2),
        np.full(2, 99.0),
    )
    (x, y), *_ = study_of_one.place_all()
    assert (x - 15.0, y) == pytest.approx((10.0 + 4.0 + 2.5, 20.0))


def test_names_are_drawn_where_they_were_put(study: RideStudy) -> None:
    figure = jn.plots.figure_of(study)
    axes = figure.axes[0]
    figure.draw_without_rendering()
    boxes = {text.get_text(): text.get_window_extent() for text in axes.texts}
    for ride in study.rides:
        at = axes.transData.transform((ride.merits["comfort"], ride.merits["load_coefficient"]))
        box = boxes.pop(ride.control)
        assert np.hypot(*(at - np.clip(at, [box.x0, box.y0], [box.x1, box.y1]))) < 30.0
        assert not any(box.overlaps(other) for other in boxes.values())
        assert box.x0 > axes.bbox.x0
        assert box.x1 < axes.bbox.x1
