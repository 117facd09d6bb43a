"""Pictures of ride studies: every controller is named, spectra have their axes."""

from __future__ import annotations

import pytest

import jounce as jn
from jounce.studies.ride import RideStudy


@pytest.fixture(scope="module")
def study() -> RideStudy:
    car = jn.load("audi-a6-half-car-4dof")
    return jn.compare_rides(car, jn.iso_trial(car, "C", "20 m/s", duration="5 s"), ["passive", "skyhook", "lqr"])


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
    assert [axes.get_title("left") for axes in figure.axes] == ["body.az", "front.tyre.force"]
    assert figure.axes[-1].get_xlabel() == "frequency [Hz]"


def test_spectra_and_deviations_leave_the_settling_time_out(study: RideStudy) -> None:
    ride = study.ride("passive")
    assert ride.settling == study.trial.settling > 0.0
    settled = ride.run["body.az"].sel(time=slice(ride.settling, None))
    assert ride.standard_deviation("body.az") == float(settled.std()) != float(ride.run["body.az"].std())
    drawn = jn.plots.figure_of(ride).axes[0].lines[0]
    expected = jn.power_spectrum(settled.to_numpy(), 1.0 / float(settled["time"][1] - settled["time"][0]))
    assert drawn.get_ydata() == pytest.approx(expected.density[1 : 1 + len(drawn.get_ydata())], rel=1e-12)
