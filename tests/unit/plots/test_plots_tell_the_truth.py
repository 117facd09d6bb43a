"""Pictures and tables that must not mislead: what is drawn, and how large, is what was found."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

import jounce as jn
from jounce.plots.design import ride_spectra, trade_off
from jounce.plots.display import kinematic_value, settle
from jounce.plots.figures import new_figure
from jounce.plots.fits import _draw_correlation
from jounce.plots.kinematics import kinematic_curves
from jounce.report.live import PageArrays
from jounce.report.papers import _headline
from jounce.ride.study import RideStudy, compare_rides, iso_trial


@pytest.fixture(scope="module")
def ride() -> RideStudy:
    rig = jn.load("audi-a6-half-car-4dof")
    return compare_rides(
        rig, iso_trial(rig, "C", 20.0, duration=10.0, seed=3), ["passive", "skyhook"]
    )


class TestViewer:
    def test_small_changes_of_large_values_are_drawn_without_steps(self):
        camber = -2.0 + 1e-4 * np.linspace(-1.0, 1.0, 81) ** 2  # degrees
        packed = PageArrays()
        packed.add(camber)
        assert packed.arrays[0]["step"] < 1e-3 * np.ptp(camber)
        assert packed.arrays[0]["low"] == pytest.approx(camber.min(), abs=1e-3 * np.ptp(camber))

    def test_rounding_is_no_curve(self):
        noise = 1e-7 * np.sin(np.arange(50.0))
        assert np.ptp(settle(noise, "rad")) == 0.0
        assert settle(noise, "rad")[0] == 0.0
        assert np.ptp(settle(-0.03 + 1e-13 * noise, "rad")) == 0.0
        assert np.array_equal(
            settle(np.array([0.0, 0.01, np.nan]), "rad"), [0.0, 0.01, np.nan], equal_nan=True
        )


class TestRideSpectra:
    def test_all_wheels_with_title_density_and_linear_model(self, ride):
        figure = ride_spectra(
            ride.rides, ride.stationary, "audi-a6-half-car-4dof on iso:C at 20 m/s"
        )
        titles = [axes.get_title("left") for axes in figure.axes]
        assert titles == ["body.az", "front.tyre.force", "rear.tyre.force"]
        assert (
            figure.get_suptitle()
            == "audi-a6-half-car-4dof on iso:C at 20 m/s, 10 s, resolution 0.3 Hz"
        )
        assert all("power spectral density" in axes.get_ylabel() for axes in figure.axes[:3])
        labels = [line.get_label() for line in figure.axes[0].lines]
        assert labels == ["passive", "skyhook", "linear model, passive"]

    def test_ten_seconds_resolve_the_bounce_of_the_body(self, ride):
        """The body bounces at 1.2 Hz: below it there is more than one frequency, and there the linear model is met."""
        found = ride.rides[0].spectra()["body.az"]
        assert np.count_nonzero((found.frequency > 0.0) & (found.frequency < 1.2)) >= 4

    def test_linear_spectrum_holds_the_variance(self, ride):
        linear = ride.stationary
        for name in ("body.az", "front.tyre.force", "rear.strut.deflection"):
            variance = np.trapezoid(linear.spectra[name], linear.frequency)
            assert variance == pytest.approx(linear[name] ** 2, rel=5e-3)

    def test_short_runs_scatter_as_said(self):
        """Standard deviations over 10 s scatter as ``chance`` says; 30 runs tell that to 4 of their standard errors."""
        rig = jn.load("audi-a6-quarter-car")
        names, found = ("sprung.az", "tyre.force"), []
        for seed in range(30):
            study = compare_rides(
                rig, iso_trial(rig, "C", 20.0, duration=10.0, seed=seed), ["passive"]
            )
            found.append(
                [study.rides[0].standard_deviation(name) / study.stationary[name] for name in names]
            )
        half = 1.96 * np.std(found, axis=0, ddof=1)
        said = [study.stationary.chance(name, 10.0) for name in names]
        assert half == pytest.approx(said, rel=4.0 / np.sqrt(2.0 * 29.0))
        assert study.stationary.chance("tyre.force", 40.0) == pytest.approx(0.5 * said[1])


def test_areas_of_the_trade_off_are_as_the_travel(ride):
    figure = trade_off(ride)
    areas = np.sort([float(dots.get_sizes()[0]) for dots in figure.axes[0].collections])
    travel = np.sort([one.merits["travel"] for one in ride.rides])
    assert areas / areas[-1] == pytest.approx(travel / travel[-1])


@pytest.mark.parametrize("count", [3, 7, 12, 16])
def test_correlations_do_not_overlap(count):
    figure = new_figure(1.15 + 0.42 * count)
    left, right = figure.subplots(
        1, 2, gridspec_kw={"width_ratios": [1.0, 0.3 + 0.11 * min(count, 10)]}
    )
    _draw_correlation(right, (-0.9 * np.ones((count, count)) + 1.9 * np.eye(count)).tolist(), count)
    figure.draw_without_rendering()
    boxes = [text.get_window_extent() for text in right.texts if text.get_text()]
    for i, one in enumerate(boxes):
        for other in boxes[i + 1 :]:
            assert not one.overlaps(other)
    left.set_visible(False)


@pytest.fixture(scope="module")
def sweep() -> xr.Dataset:
    return jn.sweep_travel(jn.load("kart-double-wishbone"), [-0.02, -0.01, 0.0, 0.01, 0.02])


class TestParallelArms:
    def test_their_swing_arm_is_called_parallel_and_camber_is_nothing(self, sweep):
        arm, camber = (float(sweep[name][1]) for name in ("front_view_swing_arm_length", "camber"))
        assert kinematic_value("front_view_swing_arm_length", arm, "m") == "parallel"
        assert kinematic_value("camber", camber, "rad") == 0.0
        assert kinematic_value("front_view_swing_arm_length", -1.5, "m") == -1500.0
        assert kinematic_value("camber", float("nan"), "rad") is None

    def test_pictures_draw_no_rounding(self, sweep):
        camber, arm = kinematic_curves(sweep, ["camber", "front_view_swing_arm_length"]).axes
        assert np.all(camber.lines[0].get_ydata() == 0.0)
        assert [text.get_text() for text in arm.texts] == ["parallel"]


def test_headline_holds_no_run_that_uses_more_travel_than_there_is():
    def study(used: list[float]):
        over = ("damper", "speed")
        values = {
            "body_acceleration": (over, [[1.0, 2.0, 3.0]]),
            "bump_travel_utilisation": (over, [[0.5, 0.6, 0.7]]),
            "rebound_travel_utilisation": (over, [used]),
        }
        figures = xr.Dataset(values, {"damper": ["0 V"], "speed": [10 / 3.6, 20 / 3.6, 40 / 3.6]})
        return type("Study", (), {"figures": figures})()

    within = _headline(study([0.8, 0.9, 2.82]), "0 V")
    assert (within.value, within.note) == (
        "2.00 m/s²",
        "r.m.s. of the body at 20 km/h, 90 % of the travel used",
    )
    beyond = _headline(study([1.5, 2.82, 1.4]), "0 V")
    assert beyond.value == "not valid"
    assert "140 % of the travel used even at 40 km/h" in beyond.note


def test_frequencies_of_many_modes_do_not_run_into_each_other():
    found = jn.modes(jn.load("audi-a6-full-car"))
    figure = jn.plots.modes(found)
    figure.draw_without_rendering()
    assert len(figure.axes) == len(found) == 7
    boxes = [axes._left_title.get_window_extent() for axes in figure.axes]
    assert not any(one.overlaps(other) for i, one in enumerate(boxes) for other in boxes[:i])
    assert "rad" in figure.get_supxlabel()
