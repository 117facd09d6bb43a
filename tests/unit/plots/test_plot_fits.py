from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError, FitError
from jounce.identify.decay import fit_decay
from jounce.identify.estimate import Estimate
from jounce.identify.force_deflection import ForceDeflectionTrial
from jounce.identify.free_response import DecayParameters, decay_response
from jounce.identify.stiffness import stiffness_against_pressure
from jounce.plots import damper_loops, decay_fit, objectives, stiffness_fit, tyre_pressure, update


def tyre_trials() -> list[ForceDeflectionTrial]:
    x = np.linspace(0.0, 0.010, 60)
    return [
        ForceDeflectionTrial(x, k * x + 3e6 * x**2, f"tyre_{k:.0f}.csv") for k in (100e3, 101e3)
    ]


def line_of(axes, label: str):
    return next(line for line in axes.lines if str(line.get_label()).startswith(label))


def test_stiffness_shows_points_fit_and_model() -> None:
    trials = tyre_trials()
    result = jn.fit_stiffness(trials, discard_below=0.002, operating_force=206.0)
    left, right = stiffness_fit(result, trials, "tyre").axes
    fit, model, points = (
        line_of(left, label) for label in ("fit, linear", "used in the model", "measured, 2 trials")
    )
    assert points.get_xdata()[-1] == pytest.approx(10.0)
    assert points.get_ydata() == pytest.approx(trials[0].force)
    slope = np.diff(fit.get_ydata())[0] / np.diff(fit.get_xdata())[0]
    assert slope == pytest.approx(1e-3 * result.stiffness.value)
    assert fit.get_ydata()[0] - model.get_ydata()[0] != 0.0
    assert result.intercept is not None
    at = 1e-3 * float(fit.get_xdata()[0])
    assert fit.get_ydata()[0] == pytest.approx(result.stiffness.value * at + result.intercept.value)
    assert model.get_ydata()[0] == pytest.approx(0.0, abs=1e-9)  # what goes into the rig
    assert line_of(left, "static operating point").get_xdata()[0] == pytest.approx(
        1e3 * result.operating_deflection
    )
    assert [label.get_text() for label in right.get_yticklabels()] == ["tyre_100000", "tyre_101000"]


def test_a_fit_to_one_branch_of_two_says_which() -> None:
    x = np.linspace(0.0, 0.010, 30)
    cycle = ForceDeflectionTrial(
        np.append(x, x[::-1]), np.append(22e3 * x, 22e3 * x[::-1] - 10.0), "spring"
    )
    for branch, told in (("loading", "fit, linear, loading"), ("both", "fit, linear")):
        left = stiffness_fit(jn.fit_stiffness([cycle], branch=branch), [cycle]).axes[0]
        assert line_of(left, "fit").get_label() == told


def test_kept_intercept_is_part_of_the_model() -> None:
    trials = tyre_trials()
    left = stiffness_fit(jn.fit_stiffness(trials, intercept="keep"), trials).axes[0]
    assert line_of(left, "fit, linear").get_ydata()[0] == pytest.approx(
        line_of(left, "beyond").get_ydata()[0]
    )


def test_stiffness_without_points_and_curved_laws() -> None:
    result = jn.fit_stiffness(tyre_trials(), law="polynomial")
    left = stiffness_fit(result).axes[0]
    fit = line_of(left, "fit, polynomial")
    assert fit.get_ydata()[-1] == pytest.approx(float(result.curve(result.fitted_range[1])))


def test_points_stand_where_the_fit_counted_them() -> None:
    x = np.linspace(0.0, 0.020, 41)
    trial = ForceDeflectionTrial(x, 3.0 + 20e3 * np.clip(x - 0.005, 0.0, None), "slack")
    firsts = []
    for zero in ("first-contact", "none"):
        result = jn.fit_stiffness([trial], zero=zero, discard_below=0.006)
        assert result.zero == zero
        firsts.append(line_of(stiffness_fit(result, [trial]).axes[0], "measured").get_xydata()[-1])
    assert firsts[0] == pytest.approx([15.0, 300.0], abs=0.1)
    assert firsts[1] == pytest.approx([20.0, 303.0])  # as recorded: 5 mm of slack, 3 N of load cell
    with pytest.raises(DescriptionError, match="unknown zero"):
        jn.fit_stiffness([trial], zero="last-contact")


def test_tyre_pressure() -> None:
    result = stiffness_against_pressure(
        [(0.25e6, Estimate(125800.0)), (0.31e6, Estimate(138468.0, 500.0, (137e3, 140e3)))]
    )
    axes = tyre_pressure(result).axes[0]
    assert axes.get_xlabel() == "inflation pressure [MPa]"
    assert axes.get_ylabel() == "tyre stiffness [N/mm]"
    assert line_of(axes, "fitted").get_xdata() == pytest.approx([0.25, 0.31])
    assert line_of(axes, "fitted").get_ydata() == pytest.approx([125.8, 138.468])


def test_decay_shows_response_and_turning_points() -> None:
    time = np.arange(0.0, 2.0, 1e-3)
    truth = DecayParameters(33.9, 0.08, 0.5e-3, 1e-3, 0.2, 0.020)
    record = decay_response(time, truth, "displacement")
    result = fit_decay(time, record, mass=16.0)
    axes = decay_fit(result, time, record, "decay_1.csv").axes
    assert [one.get_xlabel() for one in axes] == [
        "time [s]",
        "turning point, from equilibrium [mm]",
        "cycle",
    ]
    fitted = line_of(axes[0], "fit: viscous")
    at = np.interp(fitted.get_xdata(), time, 1e3 * record)
    assert fitted.get_ydata() == pytest.approx(at, abs=0.02)
    measured, line = line_of(axes[1], "measured"), line_of(axes[1], "fitted")
    assert measured.get_xdata() == pytest.approx(1e3 * np.array(result.amplitudes[:-1]))
    viscous = line_of(axes[1], "without friction").get_ydata()[1] / line.get_xdata()[0]
    assert viscous == pytest.approx(np.exp(-np.pi * 0.08 / np.sqrt(1.0 - 0.08**2)), rel=1e-6)
    order = np.argsort(line.get_xdata())
    on_line = np.interp(measured.get_xdata()[1:], line.get_xdata()[order], line.get_ydata()[order])
    assert measured.get_ydata()[1:] == pytest.approx(on_line, abs=0.05)
    assert line_of(axes[2], "single").get_ydata() == pytest.approx(result.naive_damping_ratios)


def test_decay_of_an_accelerometer() -> None:
    time = np.arange(0.0, 2.0, 1e-3)
    record = decay_response(time, DecayParameters(33.9, 0.08, 0.0, 0.0, 0.2, 0.020), "acceleration")
    result = fit_decay(time, record, mass=16.0, quantity="acceleration")
    assert decay_fit(result, time, record).axes[0].get_ylabel() == "acceleration [m/s²]"


def test_update_places_parameters_between_bounds(update_result) -> None:
    left, right = update(update_result).axes
    marks = [line for line in left.lines if line.get_marker() in ("o", "s")]
    assert [float(line.get_xdata()[0]) for line in marks] == pytest.approx([0.0, 50.0, 0.0, 100.0])
    assert [line.get_marker() for line in marks] == [
        "o",
        "o",
        "o",
        "s",
    ]  # a square stands on its bound
    interval = next(
        line for line in left.lines if len(line.get_xdata()) == 2 and line.get_alpha() == 0.6
    )
    assert interval.get_xdata() == pytest.approx([40.2, 59.8])
    texts = [text.get_text() for text in left.texts]
    assert texts == ["21.00 ± 0.20 N/mm", "110.0 N/mm (at bound)"]
    assert [text.get_text() for text in right.texts] == ["1", "–", "–", "–"]


def test_objectives(update_result) -> None:
    axes = objectives([update_result]).axes[0]
    assert [patch.get_width() for patch in axes.patches] == pytest.approx([100.0, 25.0])
    assert [text.get_text() for text in axes.texts] == ["200.0", "50.00 (−75.0 %)"]


def test_damper_loops() -> None:
    v = np.linspace(-0.1, 0.1, 50)
    figure = damper_loops([], v, 900.0 * v, {"linear": 890.0 * v})
    assert [axes.get_xlabel() for axes in figure.axes] == ["velocity [m/s]"]
    assert figure.axes[0].lines[1].get_ydata() == pytest.approx(890.0 * v)
    with pytest.raises(FitError, match="different lengths"):
        damper_loops(v[:-1], v, 900.0 * v, {})
