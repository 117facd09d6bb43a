"""Stiffness from force-deflection trials."""

import math
from dataclasses import replace

import numpy as np
import pytest

from jounce.core.errors import DescriptionError, FitError
from jounce.core.serialise import to_json
from jounce.identify.estimate import Estimate, uncertainty
from jounce.identify.force_deflection import _is_free_travel
from jounce.identify.motion import TRANSLATION
from jounce.identify.stiffness import (
    FittedCurve,
    ForceDeflectionTrial,
    TrialStiffness,
    _advice,
    _end_force,
    _increasing,
    _slope_at,
    _tangent_gradient,
    fit_curve,
    fit_stiffness,
)

STROKE = np.linspace(0.0, 0.010, 101)


def messages(result):
    return " | ".join(finding.message for finding in result.findings)


def line(k, b=0.0, name="trial"):
    return ForceDeflectionTrial(STROKE, k * STROKE + b, name)


def settling_tyre(stiffness, settle=0.002):
    """Force that grows quadratically while the tread settles and with ``stiffness`` afterwards."""
    return np.where(
        settle > STROKE, stiffness * STROKE**2 / (2 * settle), stiffness * (STROKE - settle / 2)
    )


def test_exact_lines_give_their_slope_and_intercept():
    result = fit_stiffness([line(k, 5.0) for k in (22700.0, 22730.0, 22760.0)])
    assert result.stiffness.value == pytest.approx(22730.0, rel=1e-12)
    assert result.intercept.value == pytest.approx(5.0, rel=1e-9)
    assert result.repeatability == pytest.approx(30.0, rel=1e-9)
    assert result.stiffness.standard_error == pytest.approx(30.0 / math.sqrt(3.0), rel=1e-9)
    assert result.r2 > 0.9999


def test_peak_forces_of_the_papers_springs():
    # domain A5: 791.6 N and 341.0 N at the end of the 15 mm stroke
    x = np.linspace(0.0, 0.015, 61)
    for k, peak in ((52775.0, 791.6), (22730.0, 341.0)):
        result = fit_stiffness([ForceDeflectionTrial(x, k * x)])
        assert float(result.curve(0.015)) == pytest.approx(peak, abs=0.06)


@pytest.mark.parametrize("intercept", ["drop", "shift", "keep"])
def test_the_choice_about_the_intercept_changes_the_curve_and_not_the_slope(intercept):
    result = fit_stiffness([line(1e5, -100.0)], intercept=intercept, zero="none")
    assert result.stiffness.value == pytest.approx(1e5)
    assert result.intercept.value == pytest.approx(-100.0)
    force = {"drop": 500.0, "shift": 400.0, "keep": 400.0}[intercept]
    assert float(result.curve(0.005)) == pytest.approx(force)
    assert result.curve.origin == pytest.approx(0.001 if intercept == "shift" else 0.0)
    assert result.curve.preload == pytest.approx(-100.0 if intercept == "keep" else 0.0)
    assert ("negative preload" in messages(result)) == (intercept == "keep")


def test_discarding_the_settling_zone_gives_the_stiffness_beyond_it():
    # paper 1 section 8: points below 2 mm are discarded, then one line through the rest of all trials
    trials = [
        ForceDeflectionTrial(STROKE, settling_tyre(k), str(k))
        for k in (138000.0, 138468.0, 138936.0)
    ]
    result = fit_stiffness(trials, discard_below=0.002)
    assert result.stiffness.value == pytest.approx(138468.0, rel=1e-9)
    assert result.fitted_range == pytest.approx((0.002, 0.010))
    assert fit_stiffness(trials).stiffness.value < 0.97 * 138468.0


def test_operating_point_in_the_discarded_zone_is_reported_with_the_slope_there():
    trials = [ForceDeflectionTrial(STROKE, settling_tyre(138468.0), str(i)) for i in range(3)]
    result = fit_stiffness(trials, discard_below=0.002, operating_force=100.0)
    assert result.operating_deflection == pytest.approx(
        math.sqrt(100.0 * 0.004 / 138468.0), rel=1e-3
    )
    assert result.tangent_stiffness.value == pytest.approx(
        138468.0 * result.operating_deflection / 0.002, rel=0.02
    )
    assert "outside the fitted range" in messages(result)
    assert f"the slope measured there is {result.tangent_stiffness.value:.4g} N/m" in messages(
        result
    )
    inside = fit_stiffness(trials, discard_below=0.002, operating_force=500.0)
    assert "outside the fitted range" not in messages(inside)


def test_the_papers_static_deflection_lies_below_two_millimetres():
    # domain A5: 16 * 9.81 / 138468 = 1.13 mm
    result = fit_stiffness([line(138468.0)], discard_below=0.002, operating_force=16 * 9.81)
    assert 1e3 * result.operating_deflection == pytest.approx(1.13, abs=0.005)
    assert "outside the fitted range" in messages(result)


def test_polynomial_recovers_its_coefficients():
    truth = (50e3, 12e6, -300e6)
    force = sum(a * STROKE**i for i, a in enumerate(truth, 1))
    result = fit_stiffness([ForceDeflectionTrial(STROKE, force)], law="polynomial", degree=3)
    assert [c.value for c in result.coefficients] == pytest.approx(truth, rel=1e-8)
    assert result.curve.to_table(0.01) == {
        "kind": "polynomial",
        "coefficients": pytest.approx(truth, rel=1e-8),
    }
    assert result.stiffness.value == pytest.approx(
        truth[0] + 2 * truth[1] * 0.005 + 3 * truth[2] * 0.005**2
    )
    assert result.intercept is None


def test_power_law_recovers_its_parameters_and_its_tangent():
    rng = np.random.default_rng(2)
    force = 4e5 * STROKE**1.3 + rng.normal(0.0, 0.2, len(STROKE))
    result = fit_stiffness([ForceDeflectionTrial(STROKE, force)], law="power")
    a, b = result.coefficients
    assert a.has(4e5)
    assert b.has(1.3)
    assert 0.0 < b.standard_error < 0.01
    assert result.stiffness.value == pytest.approx(4e5 * 1.3 * 0.005**0.3, rel=0.005)
    table = result.curve.to_table(0.01)
    assert np.interp(0.005, table["deflection"], table["force"]) == pytest.approx(
        4e5 * 0.005**1.3, rel=0.01
    )


def test_monotone_spline_follows_a_knee_and_never_falls():
    rng = np.random.default_rng(4)
    trials = [
        ForceDeflectionTrial(
            STROKE, settling_tyre(1.3e5) + rng.normal(0.0, 4.0, len(STROKE)), str(i)
        )
        for i in range(3)
    ]
    result = fit_stiffness(trials, law="monotone-spline")
    grid = np.linspace(0.0, 0.010, 500)
    assert np.all(np.diff(result.curve(grid)) >= -1e-9)
    assert np.allclose(result.curve(STROKE), settling_tyre(1.3e5), atol=8.0)
    assert float(result.curve(0.0)) == 0.0
    table = result.curve.to_table(0.01)
    assert table["kind"] == "table"
    assert len(table["deflection"]) == len(table["force"]) == len(result.coefficients)
    assert result.curve.tangent(0.008) == pytest.approx(1.3e5, rel=0.05)


def test_free_travel_and_load_cell_zero_are_removed():
    rng = np.random.default_rng(1)
    x = np.linspace(0.037, 0.052, 151)
    force = 22730.0 * np.maximum(x - 0.040, 0.0) + 3.0 + rng.normal(0.0, 0.1, 151)
    result = fit_stiffness([ForceDeflectionTrial(x, force)])
    assert "free travel" in messages(result)
    assert result.fitted_range[1] == pytest.approx(0.012, abs=2e-5)
    assert abs(result.intercept.value) < 0.3
    assert result.stiffness.value == pytest.approx(22730.0, rel=1e-3)


def test_a_soft_start_is_not_taken_for_free_travel():
    rng = np.random.default_rng(0)
    trial = ForceDeflectionTrial(STROKE, settling_tyre(138468.0) + rng.normal(0.0, 1.0, 101))
    assert "free travel" not in messages(fit_stiffness([trial]))


def test_a_start_under_load_keeps_the_recorded_zero():
    result = fit_stiffness([ForceDeflectionTrial(STROKE + 0.001, 1e5 * STROKE + 100.0)])
    assert "already loaded" in messages(result)
    assert result.fitted_range[0] == pytest.approx(0.001)


@pytest.mark.parametrize("begin", [0.0, 0.05, -0.05])
@pytest.mark.parametrize(("turn_x", "turn_f"), [(-1, -1), (-1, 1), (1, -1), (1, 1)])
def test_turned_signs_are_found_and_reported(turn_x, turn_f, begin):
    result = fit_stiffness([ForceDeflectionTrial(begin + turn_x * STROKE, turn_f * 2e4 * STROKE)])
    assert result.stiffness.value == pytest.approx(2e4)
    assert messages(result).count("sign was reversed") == (turn_x < 0) + (turn_f < 0)


def test_hysteresis_of_a_known_loop():
    # loading F = k x, unloading F = 0.8 k x: energy 0.2 W, loss factor 0.2 / 2 pi
    x = np.concatenate([STROKE, STROKE[::-1]])
    force = 1e5 * x * np.repeat([1.0, 0.8], len(STROKE))
    result = fit_stiffness([ForceDeflectionTrial(x, force)])
    assert result.hysteresis_energy == pytest.approx(0.2 * 0.5 * 1e5 * 0.010**2, rel=1e-6)
    assert result.loss_factor == pytest.approx(0.2 / (2 * math.pi), rel=1e-6)
    assert fit_stiffness(
        [ForceDeflectionTrial(x, force)], branch="unloading"
    ).stiffness.value == pytest.approx(8e4)
    assert (
        8e4 < fit_stiffness([ForceDeflectionTrial(x, force)], branch="both").stiffness.value < 1e5
    )


def test_hysteresis_is_that_of_the_deflections_which_both_branches_cover():
    back = np.linspace(0.010, 0.004, 61)
    x = np.concatenate([STROKE[10:], back[1:]])
    force = 1e5 * x * np.repeat([1.0, 0.8], [91, 60])
    result = fit_stiffness([ForceDeflectionTrial(x, force)], zero="none")
    work = 0.5 * 1e5 * (0.010**2 - 0.004**2)
    assert result.hysteresis_energy == pytest.approx(
        0.2 * work - 0.5 * 200.0 * 0.0001, rel=1e-3
    )  # less a step at the turn
    assert result.loss_factor == pytest.approx(
        result.hysteresis_energy / (2 * math.pi * work), rel=1e-6
    )
    for end, is_one in ((0.0051, False), (0.0049, True)):  # back to less than half
        part = np.concatenate([STROKE, [end]])
        assert (
            fit_stiffness([ForceDeflectionTrial(part, 1e5 * part)]).loss_factor is not None
        ) == is_one


@pytest.mark.parametrize("farthest", [0, 1, 2])
def test_of_several_load_cycles_one_is_taken(farthest):
    """The energy was that of a mean over all branches: three quarters of it, or half, without a word."""
    one = np.concatenate([STROKE, STROKE[-2::-1]])
    size = np.where(np.arange(3) == farthest, 1.0, 0.999)
    x, force = (np.concatenate([part * each for each in size]) for part in (one, 1e5 * one))
    force *= np.tile(np.repeat([1.0, 0.8], [101, 100]), 3)
    result = fit_stiffness([ForceDeflectionTrial(x + 0.05, force + 3.0)])
    assert result.hysteresis_energy == pytest.approx(0.2 * 0.5 * 1e5 * 0.010**2, rel=0.02)
    assert result.stiffness.value == pytest.approx(1e5)
    assert (
        f"reverses 5 times): only the largest one is used, points {201 * farthest + 1} to"
        in messages(result)
    )
    assert "turns" not in messages(fit_stiffness([ForceDeflectionTrial(one, one)]))


def test_a_copy_is_no_repetition():
    result = fit_stiffness([line(2e4, name="a"), line(2.01e4, name="b"), line(2e4, name="c")])
    assert [one.place for one in result.findings if "the same numbers as a:" in one.message] == [
        "c"
    ]


def test_without_unloading_there_is_no_loss_factor_but_a_finding():
    result = fit_stiffness([line(2e4)])
    assert result.loss_factor is None
    assert result.hysteresis_energy is None
    assert "has an unloading branch, so there is no hysteresis" in messages(result)


def test_curvature_under_a_linear_law_is_reported():
    assert "not linear" in messages(
        fit_stiffness([ForceDeflectionTrial(STROKE, settling_tyre(1e5))])
    )
    assert "not linear" not in messages(fit_stiffness([line(1e5)]))


def test_a_force_that_falls_on_the_way_is_reported():
    force = 2e4 * STROKE
    force[60:70] -= 40.0
    assert "falls by" in messages(fit_stiffness([ForceDeflectionTrial(STROKE, force)]))


@pytest.mark.slow
def test_pooled_interval_honours_the_scatter_between_trials():
    hits, naive = 0, 0
    for seed in range(200):
        rng = np.random.default_rng(seed)
        trials = [
            ForceDeflectionTrial(
                STROKE, rng.normal(22730.0, 200.0) * STROKE + rng.normal(0.0, 0.5, 101), str(i)
            )
            for i in range(5)
        ]
        result = fit_stiffness(trials)
        hits += result.stiffness.has(22730.0)
        x = np.tile(STROKE, 5)
        force = np.concatenate([t.force for t in trials])
        found, covariance = np.polyfit(x, force, 1, cov="unscaled")
        error = math.sqrt(
            covariance[0, 0] * np.sum((force - np.polyval(found, x)) ** 2) / (len(x) - 2)
        )
        naive += abs(found[0] - 22730.0) < 1.96 * error
    assert 0.91 <= hits / 200 <= 0.985
    assert naive / 200 < 0.6  # what the residuals of all points together would have claimed


def test_one_trial_has_a_residual_interval_and_a_warning():
    rng = np.random.default_rng(5)
    result = fit_stiffness([ForceDeflectionTrial(STROKE, 2e4 * STROKE + rng.normal(0.0, 1.0, 101))])
    assert result.stiffness.has(2e4)
    assert result.repeatability is None
    assert "only one trial" in messages(result)


def test_millimetres_read_as_metres_are_noticed():
    assert "right unit" in messages(
        fit_stiffness([ForceDeflectionTrial(1e3 * STROKE, 20.0 * 1e3 * STROKE)])
    )


def test_trials_of_the_same_name_are_told_apart():
    assert [row.name for row in fit_stiffness([line(1e4), line(2e4)]).trials] == [
        "trial 1",
        "trial 2",
    ]


def test_result_is_plain_data():
    assert "22730" in to_json(fit_stiffness([line(22730.0), line(22731.0)], operating_force=20.0))


@pytest.mark.parametrize(
    ("trials", "options", "text"),
    [
        ([], {}, "no trials"),
        ([ForceDeflectionTrial([0, 1e-3], [0, 1], "a")], {}, "too few points"),
        ([ForceDeflectionTrial([0, 1e-3, 2e-3], [0, 1], "a")], {}, "same length"),
        (
            [ForceDeflectionTrial([0, 1e-3, math.nan], [0, 1, 2], "a")],
            {},
            "not finite; found .point 3",
        ),
        ([ForceDeflectionTrial([1e-3] * 5, [0, 1, 2, 3, 4], "a")], {}, "never changes"),
        ([line(1e4, name="a")], {"discard_below": 0.02}, "a: no points remain after discarding"),
        ([line(1e4)], {"discard_below": -1e-3}, "discard_below"),
        ([line(1e4)], {"law": "polynomial", "degree": 0}, "degree"),
        (
            [ForceDeflectionTrial(STROKE[:4], 1e4 * STROKE[:4])],
            {"law": "polynomial", "degree": 5},
            "fewer points",
        ),
        ([line(1e4)], {"law": "power", "intercept": "keep"}, "no intercept"),
        ([ForceDeflectionTrial(STROKE, 0 * STROKE)], {}, "does not grow"),
        (
            [ForceDeflectionTrial(STROKE[::-1], 1e4 * STROKE[::-1])],
            {},
            "ends at zero deflection .* -10 mm and -100 N",
        ),
        ([line(1e4)], {"operating_force": math.nan}, "invalid static force; found .nan N"),
        ([line(1e4)], {"operating_force": 0.0}, "operating_force: invalid static force"),
        (
            [ForceDeflectionTrial(STROKE, np.where(STROKE > 0.00985, 9.0, -1.0))],
            {"law": "power", "zero": "none"},
            "three",
        ),
    ],
)
def test_unusable_data_are_refused(trials, options, text):
    with pytest.raises(FitError, match=text):
        fit_stiffness(trials, **options)


@pytest.mark.parametrize("wrong", [{"law": "lineer"}, {"intercept": "dropp"}, {"branch": "up"}])
def test_unknown_choices_are_refused(wrong):
    with pytest.raises(DescriptionError, match="unknown"):
        fit_stiffness([line(1e4)], **wrong)


def test_a_table_through_points_with_a_gap_is_still_the_line():
    x = np.concatenate([np.linspace(0.0, 0.002, 60), np.linspace(0.008, 0.010, 60)])
    curve = fit_stiffness([ForceDeflectionTrial(x, 2e5 * x)], law="monotone-spline").curve
    assert [float(curve(place)) for place in (0.001, 0.005, 0.009)] == pytest.approx(
        [200.0, 1000.0, 1800.0], rel=1e-9
    )


@pytest.mark.parametrize(("reach", "is_told"), [(0.99, False), (1.01, True)])
def test_a_deflection_beyond_a_metre_is_a_problem(reach, is_told):
    x = np.linspace(0.0, reach, 60)
    result = fit_stiffness([ForceDeflectionTrial(x, 2e3 * x)])
    assert [f.value for f in result.findings if "in the right unit" in f.message] == (
        [pytest.approx(reach)] if is_told else []
    )


def test_a_curve_is_asked_for_the_deflection_at_a_force():
    curve = FittedCurve("polynomial", (1e4, 1e6), preload=3.0, origin=0.002)
    for deflection in (0.0021, 0.005, 0.0099):
        assert curve.deflection_at(float(curve(deflection)), 0.01) == pytest.approx(
            deflection, rel=1e-6
        )
    assert curve.deflection_at(2.0, 0.01) == 0.002  # less than the preload: where it begins
    assert curve.deflection_at(float(curve(0.01)) + 0.1, 0.01) is None
    assert curve.tangent(0.005) == pytest.approx(1e4 + 2e6 * 0.003)
    power = FittedCurve("power", (4e5, 1.5))
    assert power.tangent(0.01) == pytest.approx(4e5 * 1.5 * 0.1)
    assert power(-1.0) == 0.0
    table = FittedCurve("table", deflection=(0.0, 0.01, 0.02), force=(0.0, 100.0, 200.0))
    assert table.tangent(0.013) == pytest.approx(1e4)


def test_values_are_pooled_until_none_falls():
    assert _increasing(
        np.array([1.0, 5.0, 2.0, 3.0, 9.0]), np.array([1.0, 1.0, 2.0, 1.0, 1.0])
    ).tolist() == [
        1,
        3,
        3,
        3,
        9,
    ]
    assert _increasing(np.array([4.0, 2.0, 0.0]), np.array([1.0, 2.0, 1.0])).tolist() == [2.0] * 3
    assert _increasing(np.array([3.0, 2.0, 2.5]), np.array([1.0, 3.0, 1.0])).tolist() == [
        2.25,
        2.25,
        2.5,
    ]


def test_the_slope_at_a_place_is_that_of_a_parabola_there():
    x = np.linspace(-0.01, 0.01, 41)
    force = 200.0 * x + 9e3 * x**2 + 4e6 * x**3
    assert _slope_at(x, 200.0 * x + 9e3 * x**2, 0.003) == pytest.approx(200.0, rel=1e-9)
    odd = float(
        np.sum(x[14:27] ** 4) / np.sum(x[14:27] ** 2)
    )  # what a parabola takes a cube's slope to be
    assert _slope_at(x, force, 0.003001) == pytest.approx(200.0 + 4e6 * odd, rel=1e-9)
    few = np.array([-0.002, 0.0, 0.001, 0.003])
    assert _slope_at(few, 5.0 * few + 1.0, 0.01) == pytest.approx(5.0)
    assert _slope_at(few, few**2, 0.01) == pytest.approx(
        np.polyfit(few, few**2, 1)[0]
    )  # a line through so few
    five = np.append(few, 0.004)
    assert _slope_at(five, five**2, 0.01) == pytest.approx(0.0, abs=1e-12)
    assert _slope_at(few, few, 0.0005) is None


def test_the_force_at_the_end_is_that_of_a_line_through_the_last_tenth():
    x = np.linspace(0.0, 0.01, 101)
    force = np.where(x >= 0.009 - 1e-9, 5e4 * x + 7.0, 0.0)
    assert _end_force(x, force) == pytest.approx(507.0, rel=1e-12)
    assert _end_force(np.array([0.0, 0.001, 0.01, 0.01]), np.array([0.0, 1.0, 6.0, 8.0])) == 7.0


@pytest.mark.parametrize(
    ("law", "least"), [("linear", 3), ("polynomial", 4), ("power", 3), ("monotone-spline", 5)]
)
def test_a_law_needs_more_points_than_numbers(law, least):
    x = np.linspace(0.001, 0.01, least)
    given = {"law": law, "degree": 3, "intercept": "drop", "where": "a"}
    assert fit_curve(x, 1e4 * x, **given).curve(0.005) == pytest.approx(50.0, rel=0.2)
    with pytest.raises(FitError, match="a: fewer points than the law needs"):
        fit_curve(np.append(x[1:], x[-1]), 1e4 * np.append(x[1:], x[-1]), **given)


def row(**changes):
    known = {"name": "a", "stiffness": Estimate(1e4), "intercept": None, "loss_factor": 0.1,
             "hysteresis_energy": 1.0, "rms_residual": 0.0, "points": 10}  # fmt: skip
    return TrialStiffness(**known | changes)


@pytest.mark.parametrize(
    ("bend", "preload", "rows", "told"),
    [
        (0.0, None, [row(), row()], []),
        (0.0, None, [row()], ["trials"]),
        (0.0, None, [row(loss_factor=None), row()], []),
        (0.0, None, [row(loss_factor=None)] * 2, ["trials"]),
        (0.0, None, [row(), row(points=9)], ["a"]),
        (0.028, None, [row(), row()], []),
        (0.032, None, [row(), row()], ["linear law"]),
        (-0.032, None, [row(), row()], ["linear law"]),
        (0.0, Estimate(-0.1), [row(), row()], ["intercept"]),
        (0.0, Estimate(0.0), [row(), row()], []),
    ],
)
def test_what_a_stiffness_is_told_of_begins_at_its_limits(bend, preload, rows, told):
    x = np.linspace(0.0, 0.01, 60)
    force = 1e4 * x * (1.0 + 0.5 * bend * (x / 0.01 - 1.0)) + 1e-6 * (-1.0) ** np.arange(60)
    fit = fit_curve(x, force, law="linear", degree=1, intercept="drop", where="a")
    found = _advice(fit, x, force, "linear", preload, rows, TRANSLATION)
    assert [one.place for one in found] == told
    for one in found:
        if one.place == "linear law":
            assert one.value == pytest.approx(bend, rel=1e-3)
        if one.place == "intercept":
            assert one.value == -0.1


def test_a_curve_that_falls_is_a_problem():
    x = np.linspace(0.0, 0.01, 60)
    for force, told in ((1e4 * x - 4.9e5 * x**2, 0), (1e4 * x - 5.1e5 * x**2, 1)):
        fit = fit_curve(x, force, law="polynomial", degree=2, intercept="drop", where="a")
        found = _advice(fit, x, force, "polynomial", None, [row(), row()], TRANSLATION)
        assert [(one.place, one.severity) for one in found] == [("curve", "problem")] * told


@pytest.mark.parametrize(("back", "is_told"), [(0.019, False), (0.021, True)])
def test_a_deflection_that_reverses_on_the_way_is_told(back, is_told):
    x = np.concatenate(
        [np.linspace(0.0, 0.005, 40), [0.005 - 0.01 * back], np.linspace(0.0051, 0.01, 40)]
    )
    found = [
        one
        for one in fit_stiffness([ForceDeflectionTrial(x, 1e4 * x)] * 2).findings
        if "reverses" in one.message
    ]
    assert [one.value for one in found] == [pytest.approx(0.01 * back)] * (2 * is_told)


@pytest.mark.parametrize(("drop", "is_told"), [(0.029, False), (0.031, True)])
def test_a_force_that_falls_on_the_way_is_told_from_three_percent_on(drop, is_told):
    force = 1e4 * STROKE
    force[50] = force[49] - 100.0 * drop
    found = [
        one
        for one in fit_stiffness([ForceDeflectionTrial(STROKE, force)]).findings
        if "falls by" in one.message
    ]
    assert [one.value for one in found] == [pytest.approx(100.0 * drop)] * is_told


def test_a_power_law_knows_its_factor_and_exponent_as_its_slopes_say():
    x = np.linspace(0.001, 0.01, 40)
    force = 4e5 * x**1.3 + np.random.default_rng(3).normal(0.0, 0.5, 40)
    fit = fit_curve(x, force, law="power", degree=1, intercept="drop", where="a")
    a, b = fit.parameters
    expected = uncertainty(np.column_stack([x**b, a * x**b * np.log(x)]), force - a * x**b)
    np.testing.assert_allclose(fit.uncertainty.covariance, expected.covariance, rtol=1e-4)
    np.testing.assert_allclose(fit.residual, force - a * x**b, atol=1e-9)


@pytest.mark.parametrize(("law", "degree"), [("linear", 1), ("polynomial", 3), ("power", 1)])
def test_the_tangent_is_as_sure_as_the_numbers_of_its_law(law, degree):
    x = np.linspace(0.001, 0.01, 40)
    force = 4e5 * x**1.3 + np.random.default_rng(4).normal(0.0, 0.5, 40)
    fit = fit_curve(x, force, law=law, degree=degree, intercept="drop", where="a")
    count = len(fit.curve.coefficients)
    moves = np.eye(len(fit.parameters)) * 1e-5 * np.abs(fit.parameters)
    slopes = []
    for move in moves:
        ends = [
            replace(fit.curve, coefficients=tuple((fit.parameters + way * move)[:count]))
            for way in (1.0, -1.0)
        ]
        slopes.append(
            (ends[0].tangent(0.004) - ends[1].tangent(0.004)) / (2.0 * np.abs(move).max())
        )
    np.testing.assert_allclose(_tangent_gradient(fit, 0.004), slopes, rtol=1e-6)


@pytest.mark.parametrize(
    ("flat", "rise", "is_free"),
    [(8, 0.0, True), (7, 0.0, False), (8, 0.099, True), (8, 0.101, False)],
)
def test_free_travel_is_eight_points_that_hardly_rise(flat, rise, is_free):
    """Points one apart: the force rises by ``rise`` of the mean stiffness over the first ones, and then to 1."""
    x = np.arange(41.0)
    steep = 40.0 * rise / 40.0
    force = np.where(x < flat, steep * x, steep * (flat - 1.0) + 0.0)
    force[flat:] += np.linspace(1.0, 40.0 - force[-1], 41 - flat)
    assert _is_free_travel(x, force, flat - 1, 40) == is_free
    assert not _is_free_travel(x, force, flat - 1, flat + 1)  # two points behind it are too few


def test_free_travel_is_that_of_the_loading_branch():
    x = np.concatenate([np.linspace(0.0, 0.010, 41), [0.009]])
    force = np.append(
        1e4 * np.maximum(x[:-1] - 0.0024, 0.0), 0.0
    )  # the first point on the way back is loose
    (found,) = [
        one.value
        for one in fit_stiffness([ForceDeflectionTrial(x, force)]).findings
        if "travel" in one.message
    ]
    assert found == pytest.approx(0.0024, abs=1e-5)


def test_free_travel_counts_from_three_percent_of_the_stroke_on():
    for travel, is_free in ((0.0299, False), (0.0301, True)):
        x = np.concatenate([np.linspace(0.0, travel, 10), np.linspace(travel + 0.01, 1.0, 40)])
        force = np.maximum(x - travel, 0.0)
        assert _is_free_travel(x, force, 9, 49) == is_free


@pytest.mark.parametrize(("points", "bins"), [(30, 3), (100, 12), (207, 24), (400, 24)])
def test_a_table_has_a_knot_for_eight_points(points, bins):
    x = np.linspace(0.0, 0.01, points)
    fit = fit_curve(x, 1e4 * x, law="monotone-spline", degree=1, intercept="drop", where="a")
    assert len(fit.curve.deflection) == bins + 2  # the origin and the end
    assert fit.curve.deflection[-1] == pytest.approx(0.01)


@pytest.mark.parametrize(("share", "told"), [(0.019, 0), (0.021, 1)])
def test_a_start_is_loaded_from_two_percent_of_the_largest_force_on(share, told):
    force = 1e4 * STROKE + share * 100.0 / (1.0 - share)
    found = [
        one
        for one in fit_stiffness([ForceDeflectionTrial(STROKE, force)]).findings
        if "loaded" in one.message
    ]
    assert [one.value for one in found] == [pytest.approx(force[0])] * told


def cycled(name, rate=22730.0, drift=0.0, loss=0.0, seed=1):
    """A load cycle of a spring to 15 mm and back, with noise of 1 N and 5 um; a drift of its load cell [N]."""
    random = np.random.default_rng(seed)
    x = np.concatenate([np.linspace(0.0, 0.015, 151), np.linspace(0.015, 0.0, 151)])
    way = np.repeat([1.0, -1.0], 151)
    force = rate * x + loss * way * np.minimum(1.0, x / 3e-4) + drift * np.linspace(0.0, 1.0, 302)
    return ForceDeflectionTrial(
        x + random.normal(0.0, 5e-6, 302), force + random.normal(0.0, 1.0, 302), name
    )


def told_of(*trials):
    return " | ".join(f"{one.place}: {one.message}" for one in fit_stiffness(trials).findings)


def test_a_load_cell_that_drifts_is_told_and_hysteresis_is_not_taken_for_it():
    """20 N of drift made the loading branch 3 % too stiff, with an interval of 0.5 %, and nothing was said."""
    assert "drifts" not in told_of(*(cycled(f"t{i}", loss=8.0, seed=i) for i in range(3)))
    drifted = [cycled(f"t{i}", drift=20.0, seed=i) for i in range(3)]
    told = [
        one.value
        for one in fit_stiffness(drifted).findings
        if "the zero of the load cell drifts" in one.message
    ]
    assert told == pytest.approx([20.0, 20.0, 20.0], abs=2.0)
    assert not fit_stiffness(drifted).stiffness.has(22730.0)
    assert fit_stiffness(drifted, branch="both").stiffness.value == pytest.approx(22730.0, rel=2e-3)


def test_a_load_cell_out_of_range_is_told():
    trial = cycled("t")
    over = ForceDeflectionTrial(trial.deflection, np.minimum(trial.force, 250.0), "t")
    assert "t: the force stays at 250 N over 4 mm" in told_of(over)
    assert "the force stays" not in told_of(trial)


def test_a_trial_unlike_the_others_is_told():
    alike = [cycled(f"t{i}", rate, seed=i) for i, rate in enumerate((22700.0, 22730.0, 22760.0))]
    assert "times that of the other trials" not in told_of(*alike)
    found = fit_stiffness([*alike, cycled("in kgf", 22730.0 / 9.81, seed=5)]).findings
    told = [(one.place, one.value) for one in found if "that of the other trials" in one.message]
    assert told == [("in kgf", pytest.approx(1.0 / 9.81, rel=0.03))]


def test_noise_at_the_top_of_a_cycle_is_no_slip():
    assert "slip" not in told_of(*(cycled(f"t{i}", loss=8.0, seed=i) for i in range(5)))


@pytest.mark.parametrize("branch", ["loading", "both"])
@pytest.mark.parametrize("law", ["linear", "polynomial"])
def test_a_trial_in_tension_and_compression_is_fitted_on_both_sides(law, branch):
    way = np.linspace(-0.02, 0.02, 41)
    way = np.concatenate([way, way[-2::-1]])
    force = 22.7e3 * way + np.random.default_rng(1).normal(0.0, 1.0, len(way))
    result = fit_stiffness([ForceDeflectionTrial(way, force)], law=law, branch=branch)
    assert result.fitted_range == pytest.approx((-0.02, 0.02))
    assert result.trials[0].points == (41 if branch == "loading" else 81)
    assert result.stiffness.value == pytest.approx(22.7e3, rel=2e-3)
    assert result.loss_factor == pytest.approx(0.0, abs=2e-3)
    assert [
        one.message
        for one in result.findings
        if one.severity != "note" and "only one trial" not in one.message
    ] == []


def test_sides_that_differ_and_points_that_a_law_leaves_out_are_named():
    way = np.linspace(-0.02, 0.02, 41)
    force = np.where(way < 0.0, 0.6, 1.0) * 22.7e3 * way + np.random.default_rng(1).normal(
        0.0, 1.0, 41
    )
    sides = " ".join(
        one.message for one in fit_stiffness([ForceDeflectionTrial(way, force)]).findings
    )
    assert "N/m in tension and 2.2" in sides
    one_side = fit_stiffness([ForceDeflectionTrial(way, force)], law="monotone-spline")
    assert any("20 of 41 points are below the zero" in one.message for one in one_side.findings)


@pytest.mark.parametrize("width", [1e-4, 2e-3])
def test_a_slip_of_the_grip_is_named_with_the_slope_without_it(width):
    way = np.linspace(0.0, 0.03, 61)
    force = 22.7e3 * (way - 2e-3 * np.clip((way - 0.015) / width, 0.0, 1.0))
    result = fit_stiffness(
        [ForceDeflectionTrial(way, force + np.random.default_rng(1).normal(0.0, 1.0, 61))]
    )
    (slip,) = [one for one in result.findings if "slip of" in one.message]
    assert slip.value == pytest.approx(45.4, rel=0.1)
    assert (
        "the slope without the slip is 2.2" in slip.message
        or "the slope without the slip is 2.3" in slip.message
    )


@pytest.mark.parametrize("share", [0.0, 0.3, 1.0])
@pytest.mark.parametrize("kind", ["progressive", "knee", "soft start"])
def test_a_spring_that_is_no_line_did_not_slip(share, kind):
    way = np.linspace(0.0, 0.03, 61)
    bend = {
        "progressive": way**2 / 0.03,
        "knee": np.maximum(way - 0.015, 0.0),
        "soft start": -0.004 * (1.0 - np.exp(-way / 0.004)),
    }[kind]
    force = 22.7e3 * (way + share * bend) + np.random.default_rng(1).normal(0.0, 1.0, 61)
    assert not any(
        "slip" in one.message for one in fit_stiffness([ForceDeflectionTrial(way, force)]).findings
    )


@pytest.mark.parametrize(
    ("rate", "told"), [(22.7e6, True), (4.9e6, False), (101.0, False), (44.0, True)]
)
def test_a_rate_of_no_spring_is_questioned(rate, told):
    way = np.linspace(0.0, 0.01, 30)
    result = fit_stiffness([ForceDeflectionTrial(way, rate * way)])
    assert told == any(
        "is implausible for a spring, tyre or bush" in one.message for one in result.findings
    )


def test_a_zero_that_falls_is_no_hysteresis():
    way = np.linspace(0.0, 0.03, 61)
    way = np.concatenate([way, way[-2::-1]])
    noise = np.random.default_rng(1).normal(0.0, 1.0, len(way))
    drift = fit_stiffness(
        [ForceDeflectionTrial(way, 22.7e3 * way + noise - np.linspace(0.0, 80.0, len(way)))]
    )
    assert any("the zero of the load cell drifts" in one.message for one in drift.findings)
    up = np.arange(len(way)) < 61
    friction = 22.7e3 * way + noise + np.where(up, 30.0, -30.0) * np.clip(way / 0.001, 0.0, 1.0)
    assert not any(
        "drifts" in one.message
        for one in fit_stiffness([ForceDeflectionTrial(way, friction)]).findings
    )
