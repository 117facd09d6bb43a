"""Damper laws, the Bouc-Wen path, and checks of damper records."""

import itertools
import math
from dataclasses import replace

import foreign_records
import numpy as np
import pytest

from jounce.core.errors import DescriptionError, FitError
from jounce.core.serialise import to_json
from jounce.identify.damper import _fitted_part, damper_curve, fit_damper
from jounce.identify.damper_findings import _force_step, damper_advice, hysteresis_share
from jounce.identify.damper_laws import LAWS, damper_law
from jounce.identify.damper_record import _check_velocity, _moving_part, cycles_of, read_motion
from jounce.identify.damper_result import DamperResult
from jounce.identify.estimate import Estimate
from jounce.identify.hysteresis_path import bouc_wen_path

TIME = np.arange(0.0, 6.0, 0.005)
X = 0.020 * np.sin(2 * math.pi * TIME) + 0.004 * np.sin(2 * math.pi * 2.3 * TIME)
V = (
    2
    * math.pi
    * (0.020 * np.cos(2 * math.pi * TIME) + 0.004 * 2.3 * np.cos(2 * math.pi * 2.3 * TIME))
)


def messages(result):
    return " | ".join(finding.message for finding in result.findings)


def values(result):
    return {key: one.value for key, one in result.parameters.items()}


@pytest.mark.parametrize("exponent", [1.0, 2.0])
@pytest.mark.parametrize("sigma", [0.5, 1.0, 5.0, 120.0])
def test_path_agrees_with_the_closed_form(exponent, sigma):
    # one way from z = -1 + small: n = 1: u' = 1 - u (u > 0), 1 - b u (u < 0), b = 2 sigma - 1; n = 2: tanh and tan
    rate, start, b = 300.0, -0.6, 2 * sigma - 1
    x = np.linspace(0.0, 0.012, 400)
    z = bouc_wen_path(x, rate, sigma, exponent, start)
    s = rate * x
    if exponent == 1.0:
        zero = 0.6 if b == 0.0 else math.log(1 + b * 0.6) / b
        below = -(zero - s) if b == 0.0 else (1 - np.exp(b * (zero - s))) / b
        exact = np.where(s < zero, below, 1 - np.exp(-np.maximum(s - zero, 0.0)))
    else:
        root = math.sqrt(b)
        zero = 0.6 if b == 0.0 else math.atan(root * 0.6) / root
        below = (
            s - zero if b == 0.0 else np.tan(np.minimum(root * (s - zero), 0.0)) / max(root, 1e-9)
        )
        exact = np.where(s < zero, below, np.tanh(np.maximum(s - zero, 0.0)))
    assert np.max(np.abs(z - exact)) < 2e-4


def test_path_is_the_same_with_turned_signs_and_stays_bounded():
    z = bouc_wen_path(X, 400.0, 3.0, 1.6, 0.0)
    assert np.allclose(bouc_wen_path(-X, 400.0, 3.0, 1.6, 0.0), -z, atol=1e-12)
    assert np.abs(z).max() <= 1.0
    assert np.abs(z).max() > 0.99


def test_the_shortest_paths_and_what_is_none():
    assert bouc_wen_path(np.zeros(0), 400.0, 3.0, 1.6, 0.5).shape == (0,)
    assert bouc_wen_path(np.ones(1), 400.0, 3.0, 1.6, 0.5) == [0.5]
    for path in (np.ones((2, 2)), [0.0, np.nan], [0.0, np.inf]):
        with pytest.raises(DescriptionError, match="displacement: invalid path"):
            bouc_wen_path(path, 400.0, 3.0, 1.6, 0.0)
    given = {"rate": 400.0, "sigma": 3.0, "exponent": 1.6, "start": 0.0}
    for name, bad in (
        ("rate", -1.0),
        ("sigma", 0.4),
        ("exponent", 0.0),
        ("exponent", np.inf),
        ("start", np.nan),
    ):
        with pytest.raises(DescriptionError, match=f"{name}: out of range"):
            bouc_wen_path(X, **{**given, name: bad})


def test_path_depends_on_the_way_and_not_on_its_division():
    coarse = np.array([0.0, 0.004, -0.002, 0.001])
    fine = np.concatenate([np.linspace(a, b, 50) for a, b in itertools.pairwise(coarse)])
    assert bouc_wen_path(fine, 500.0, 2.0, 1.5, 0.0)[-1] == pytest.approx(
        bouc_wen_path(coarse, 500.0, 2.0, 1.5, 0.0)[-1], abs=1e-5
    )


def test_linear():
    result = fit_damper(X, V, 1500.0 * V + 20.0, TIME)
    assert values(result) == pytest.approx({"coefficient": 1500.0, "offset": 20.0}, rel=1e-9)
    assert result.damper == {"coefficient": pytest.approx(1500.0)}
    assert result.r2 == pytest.approx(1.0)
    assert "include it in the preload" in messages(result)


def test_energy_of_a_viscous_damper_per_cycle():
    # E = pi c omega X^2 for a sine
    x, v = 0.02 * np.sin(2 * math.pi * TIME), 0.04 * math.pi * np.cos(2 * math.pi * TIME)
    result = fit_damper(x, v, 1000.0 * v, TIME)
    assert result.energy_per_cycle == pytest.approx(
        math.pi * 1000.0 * 2 * math.pi * 0.02**2, rel=2e-3
    )
    assert result.cycles == pytest.approx(6.0, abs=0.01)
    assert result.fitted_energy_per_cycle == pytest.approx(result.energy_per_cycle, rel=1e-9)


def test_bilinear_with_dry_friction():
    motion = read_motion(X, V, V, TIME)[0]
    slow = 0.01 * motion.peak_velocity
    force = np.where(V > 0, 400.0, 1200.0) * V + 30.0 * np.tanh(V / slow) - 5.0
    result = fit_damper(X, V, force, TIME, law="bilinear", friction=True)
    expected = {
        "bump_coefficient": 400.0,
        "rebound_coefficient": 1200.0,
        "friction_force": 30.0,
        "offset": -5.0,
    }
    assert values(result) == pytest.approx(expected, rel=1e-6)
    assert result.damper == {
        "bump_coefficient": pytest.approx(400.0),
        "rebound_coefficient": pytest.approx(1200.0),
    }
    assert result.friction == {
        "force": pytest.approx(30.0),
        "regularisation_velocity": pytest.approx(slow),
    }
    without = fit_damper(X, V, force, TIME, law="bilinear")
    assert "dry friction" in messages(without)
    assert without.friction is None
    assert "dry friction" not in messages(result)


@pytest.mark.parametrize("odd", [False, True])
def test_polynomial(odd):
    force = 900.0 * V + (0.0 if odd else 800.0) * V**2 + 5e3 * V**3
    result = fit_damper(X, V, force, TIME, law="polynomial", degree=3, odd=odd)
    assert set(result.parameters) == (
        {"a1", "a3", "offset"} if odd else {"a1", "a2", "a3", "offset"}
    )
    assert values(result)["a3"] == pytest.approx(5e3, rel=1e-6)
    speed, table = np.array(result.damper["velocity"]), np.array(result.damper["force"])
    assert np.interp(0.0, speed, table) == pytest.approx(0.0, abs=1e-6)
    assert table == pytest.approx(
        900.0 * speed + (0.0 if odd else 800.0) * speed**2 + 5e3 * speed**3, rel=1e-5, abs=1e-4
    )


def test_a_curve_that_falls_is_reported():
    force = 2000.0 * V - 4e4 * V**3
    assert "decreases with rising velocity" in messages(
        fit_damper(X, V, force, TIME, law="polynomial")
    )


def test_tanh_hysteretic_recovers_its_parameters():
    force = 300.0 * V + 2e3 * X + 150.0 * np.tanh(40.0 * (V + 1.5 * X)) + 12.0
    result = fit_damper(X, V, force, TIME, law="tanh-hysteretic")
    centred = result.displacement_centre
    found = values(result)
    assert centred == pytest.approx(0.5 * (X.max() + X.min()))
    assert found["slope"] == pytest.approx(40.0, rel=0.02)
    assert found["displacement_coupling"] == pytest.approx(1.5, rel=0.05)
    assert found["force"] == pytest.approx(150.0, rel=0.01)
    assert set(result.damper) == {
        "kind",
        "coefficient",
        "stiffness",
        "force",
        "slope",
        "displacement_coupling",
        "offset",
    }
    assert result.nrmse < 2e-3


def test_bouc_wen_recovers_its_parameters():
    z = bouc_wen_path(X, 600.0, 2.5, 1.6, 0.0)
    result = fit_damper(X, V, 250.0 * V + 1500.0 * X + 180.0 * z + 10.0, TIME, law="bouc-wen")
    expected = {
        "coefficient": 250.0,
        "stiffness": 1500.0,
        "hysteretic_force": 180.0,
        "rate": 600.0,
        "sigma": 2.5,
        "exponent": 1.6,
    }
    found = values(result)
    for key, value in expected.items():
        assert found[key] == pytest.approx(value, rel=0.01), key
    assert found["offset"] == pytest.approx(10.0 + 1500.0 * result.displacement_centre, rel=0.02)
    assert result.damper["kind"] == "bouc-wen"
    assert set(result.damper) == {
        "kind",
        "coefficient",
        "stiffness",
        "hysteretic_force",
        "rate",
        "sigma",
        "exponent",
        "offset",
    }
    assert result.nrmse < 1e-3


def test_tables_are_accepted_by_a_rig():
    from pydantic import TypeAdapter

    from jounce.parts.dampers import Damper

    force = (
        np.where(V > 0, 400.0, 1200.0) * V
        + 60.0 * np.tanh(V / 0.005)
        + 0.5 * bouc_wen_path(X, 600.0, 2.5, 1.6, 0.0)
    )
    for law in LAWS:
        TypeAdapter(Damper).validate_python(fit_damper(X, V, force, TIME, law=law).damper)


def test_factors_that_cannot_be_negative_are_not():
    result = fit_damper(X, V, -30.0 * V + 200.0 * np.tanh(30.0 * V), TIME, law="tanh-hysteretic")
    assert result.parameters["coefficient"].value == 0.0
    assert result.parameters["coefficient"].interval is None
    assert "limit of its range" in messages(result)


def test_hysteresis_under_a_velocity_law_is_reported():
    force = 200.0 * V + 100.0 * bouc_wen_path(X, 300.0, 1.0, 1.5, 0.0)
    assert "hysteresis" in messages(fit_damper(X, V, force, TIME))
    assert "hysteresis" not in messages(fit_damper(X, V, 900.0 * V, TIME))
    # two branches 200 N apart over a range of 400 N, with noise that alone would not count as hysteresis
    noise = np.random.default_rng(3).normal(size=len(TIME))
    rising = np.gradient(V, TIME) > 0.0
    motion, _ = read_motion(X, V, np.where(rising, 100.0, -100.0) + 1000.0 * V + 15.0 * noise, TIME)
    assert hysteresis_share(motion) == pytest.approx(200.0 / np.ptp(motion.force), rel=0.02)


def test_hysteresis_begins_where_the_first_stroke_comes_from():
    for side in (1.0, -1.0):
        motion, _ = read_motion(side * X, side * V, side * 900.0 * V, TIME, name="first stroke")
        law = damper_law("bouc-wen", motion)
        state = law.columns(motion.displacement, motion.velocity, np.array([600.0, 2.5, 1.6]))[:, 2]
        assert state[0] == -side
        assert state[40] * side > 0.5


def test_missing_velocity_is_derived():
    result = fit_damper(X, None, 1500.0 * V, TIME)
    assert result.parameters["coefficient"].value == pytest.approx(1500.0, rel=2e-3)
    assert "derivative of the displacement is used" in messages(result)


def test_backward_difference_is_recognised():
    late = np.concatenate([[V[0]], np.diff(X) / 0.005])
    result = fit_damper(X, late, 1500.0 * V, TIME)
    assert "2.5 ms (0.50 samples), like" in messages(result)
    better = fit_damper(X, late, 1500.0 * V, TIME, velocity_from="displacement")
    assert better.nrmse < 0.3 * result.nrmse
    assert "samples), like" not in messages(better)


def test_wrong_unit_or_sign_of_the_velocity_is_a_problem():
    assert "1e+03 times the derivative" in messages(fit_damper(X, 1e3 * V, V, TIME))
    assert "-1 times the derivative" in messages(fit_damper(X, -V, V, TIME))


def test_force_of_the_other_sign_is_turned():
    result = fit_damper(X, V, -1500.0 * V, TIME)
    assert result.parameters["coefficient"].value == pytest.approx(1500.0)
    assert "recorded with the opposite sign" in messages(result)


def test_quantised_velocity_is_reported():
    assert "in steps of 5 mm/s" in messages(
        fit_damper(X, np.round(V / 0.005) * 0.005, 1500.0 * V, TIME)
    )


def test_rest_is_left_out():
    rest = np.zeros(200)
    t = np.arange(len(TIME) + 200) * 0.005
    x, v = np.concatenate([rest + X[0], X]), np.concatenate([rest, V])
    result = fit_damper(x, v, np.concatenate([rest - 300.0, 1500.0 * V]), t)
    assert result.parameters["coefficient"].value == pytest.approx(1500.0, rel=1e-2)
    assert "samples at rest" in messages(result)
    assert result.samples < len(TIME) + 5


def test_law_on_another_record():
    z = bouc_wen_path(X, 600.0, 2.5, 1.6, 0.0)
    force = 250.0 * V + 180.0 * z
    half = len(TIME) // 2
    result = fit_damper(X[:half], V[:half], force[:half], TIME[:half], law="bouc-wen")
    curve = damper_curve(result, X[half:], V[half:], force[half:], TIME[half:])
    assert np.sqrt(np.mean((curve.fitted - curve.measured)[100:] ** 2)) < 0.03 * np.ptp(force)


def test_result_is_plain_data():
    assert "coefficient" in to_json(fit_damper(X, V, 1500.0 * V, TIME))


@pytest.mark.parametrize(
    ("columns", "options", "text"),
    [
        ((X[:-1], V, V, TIME), {}, "not of the same length"),
        ((X[:20], V[:20], V[:20], TIME[:20]), {}, "too few samples"),
        ((X, V, np.where(TIME[4] == TIME, np.inf, V), TIME), {}, "force, sample 5"),
        ((X, V, V, np.zeros_like(TIME)), {}, "does not increase"),
        ((0 * X, V, V, TIME), {}, "never changes"),
        ((X, V, 0 * V, TIME), {}, "never changes"),
        ((X[:80], V[:80], V[:80], TIME[:80]), {}, "less than one cycle"),
        ((X, V, V, TIME), {"law": "polynomial", "degree": 12}, "degree"),
        ((X, V, V, TIME), {"law": "bouc-wen", "friction": True}, "contains dry friction"),
    ],
)
def test_unusable_records_are_refused(columns, options, text):
    with pytest.raises(FitError, match=text):
        fit_damper(*columns, **options)


@pytest.mark.parametrize("wrong", [{"law": "bouc-wenn"}, {"velocity_from": "recordet"}])
def test_unknown_choices_are_refused(wrong):
    with pytest.raises(DescriptionError, match="Did you mean"):
        fit_damper(X, V, V, TIME, **wrong)


def test_an_unknown_law_is_refused_by_the_law_itself():
    with pytest.raises(DescriptionError, match="unknown damper law"):
        damper_law("viscous", read_motion(X, V, V, TIME)[0])


@pytest.fixture(scope="module")
def line():
    motion, _ = read_motion(X, V, 900.0 * V, TIME)
    return fit_damper(X, V, 900.0 * V, TIME), motion


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({}, []),
        ({"cycles": 3.0}, []),
        ({"cycles": 2.99}, [("note", 2.99)]),
        ({"r2": 0.901}, []),
        ({"r2": 0.899}, [("warning", 0.899)]),
        ({"parameters": {"offset": Estimate(3.0, 1.0, (1.0, 5.0))}}, [("note", 3.0)]),
        ({"parameters": {"offset": Estimate(3.0, 2.0, (-1.0, 7.0))}}, []),
        ({"parameters": {"coefficient": Estimate(-1.0, 0.1)}}, [("problem", -1.0)]),
        ({"parameters": {"bump_coefficient": Estimate(-1.0)}}, [("problem", -1.0)]),
        ({"parameters": {"rebound_coefficient": Estimate(-1.0)}}, [("problem", -1.0)]),
        ({"law": "tanh-hysteretic", "parameters": {"slope": Estimate(10.0, 4.9)}}, []),
        (
            {"law": "tanh-hysteretic", "parameters": {"slope": Estimate(-10.0, 5.1)}},
            [("note", 5.1)],
        ),
        ({"law": "bouc-wen", "parameters": {"sigma": Estimate(10.0, 5.1)}}, [("note", 5.1)]),
        ({"parameters": {"force": Estimate(10.0, 9.0)}}, []),
        (
            {"damper": {"velocity": [-1.0, 0.0, 1.0], "force": [-1.0, 2.0, 1.9]}},
            [("warning", None)],
        ),
        ({"damper": {"velocity": [-1.0, 0.0, 1.0], "force": [-1.0, 2.0, 2.0]}}, []),
        ({"law": "tanh-hysteretic", "parameters": {"coefficient": Estimate(-1.0)}}, []),
    ],
)
def test_what_a_law_is_told_of_begins_at_its_limits(line, changes, told):
    result, motion = line
    parameters = {"offset": Estimate(0.0, 1.0, (-2.0, 2.0))} | changes.get("parameters", {})
    units = dict.fromkeys(parameters, "1")
    known = {"cycles": 9.0, "r2": 0.99, "parameters": parameters, "units": units}
    changed = replace(
        result, **known | {key: value for key, value in changes.items() if key != "parameters"}
    )
    found = damper_advice(changed, motion, (), "a.csv")
    assert [(one.place, one.severity, one.value) for one in found] == [
        ("a.csv", *each) for each in told
    ]


def test_a_number_at_the_limit_of_its_range_is_told(line):
    result, motion = line
    at_end = replace(
        result,
        law="bouc-wen",
        parameters={"sigma": Estimate(4.0)},
        units={"sigma": "1"},
        cycles=9.0,
    )
    (limit,) = damper_advice(at_end, motion, ("sigma",), "a.csv")
    assert (limit.severity, limit.value) == ("warning", 4.0)


@pytest.mark.parametrize(("share", "told"), [(0.039, 0), (0.041, 1)])
def test_hysteresis_is_told_from_four_percent_on(line, share, told):
    result, motion = line
    rising = np.gradient(motion.velocity, motion.time) > 0.0
    smooth = np.ptp(900.0 * motion.velocity)
    step = smooth / (1.0 / share - 1.0)  # the range of the force grows with what is added
    looped = replace(
        motion, force=900.0 * motion.velocity + 0.5 * step * np.where(rising, 1.0, -1.0)
    )
    size = hysteresis_share(looped)
    looped = replace(
        looped,
        force=900.0 * motion.velocity + (looped.force - 900.0 * motion.velocity) * share / size,
    )
    assert [
        one.value for one in damper_advice(result, looped, (), "") if "hysteresis" in one.message
    ] == ([pytest.approx(share, rel=0.03)] * told)


def test_hysteresis_is_the_difference_of_both_ways_less_their_noise():
    """Two velocities, passed twice up and twice down: means 5 and 1 apart by 4, of variances 2 / 2 + 8 / 2 = 5."""
    speeds = np.array([-1.0, 0.5, 1.0, 0.5, -1.0, 0.5, 1.0, 0.5, -1.0])
    motion = replace(
        read_motion(X, V, 900.0 * V, TIME)[0],
        time=np.arange(9.0),
        velocity=speeds,
        force=np.array([0.0, 4.0, 10.0, -1.0, 0.0, 6.0, 10.0, 3.0, 0.0]),
    )
    assert hysteresis_share(motion) == pytest.approx(
        math.sqrt((5.0 - 1.0) ** 2 - 5.0) / 11.0, rel=1e-12
    )
    once = replace(motion, time=motion.time[:5], velocity=speeds[:5], force=motion.force[:5])
    assert hysteresis_share(once) == 0.0  # passed once each way, nothing is known of the noise


@pytest.mark.parametrize(
    ("share", "noise", "told"), [(0.0205, 0.0, 1), (0.0195, 0.0, 0), (0.05, 1.0, 0), (0.05, 0.3, 1)]
)
def test_a_jump_of_the_force_is_told_where_it_is_two_percent_and_explains_a_fifth(
    share, noise, told
):
    motion, _ = read_motion(X, V, 9000.0 * V, TIME)
    smooth = 9000.0 * motion.velocity
    step = share * np.ptp(smooth) / (1.0 - 2.0 * share)  # the range grows with the step
    jumped = smooth + step * np.tanh(motion.velocity / (0.01 * motion.peak_velocity))
    jumped += noise * step * np.random.default_rng(0).normal(size=len(jumped))
    found = _force_step(replace(motion, force=jumped))
    assert (found is not None) == bool(told)
    if told:
        assert found[0] == pytest.approx(step, rel=0.1 if noise else 1e-6)
    assert _force_step(replace(motion, force=-jumped)) is None


@pytest.mark.parametrize(
    ("gain", "late", "source", "told"),
    [
        (1.049, 0.0, "recorded", None),
        (0.951, 0.0, "recorded", None),
        (1.051, 0.0, "recorded", "problem"),
        (0.949, 0.0, "displacement", "problem"),
        (1.0, 0.19, "recorded", None),
        (1.0, 0.21, "recorded", "warning"),
        (1.0, -0.21, "recorded", "warning"),
        (1.0, 0.21, "displacement", None),
    ],
)
def test_a_recorded_velocity_may_be_five_percent_and_a_fifth_of_a_sample_off(
    gain, late, source, told
):
    findings = []
    slope = np.gradient(V, TIME)
    velocity = gain * V - 0.005 * late * (slope - V * (slope @ V) / (V @ V))
    assert _check_velocity(velocity, V, TIME, source, "a.csv", findings) == 0.0
    assert [one.severity for one in findings] == [told] * (told is not None)
    for one in findings:
        assert one.value == pytest.approx(gain if told == "problem" else 0.005 * late, rel=0.02)


@pytest.mark.parametrize(("step", "told"), [(0.9e-3, 0), (1.1e-3, 1)])
def test_steps_of_a_velocity_are_told_from_a_thousandth_of_its_peak_on(step, told):
    wave = np.round(np.sin(np.arange(20_000) * 2e-3) / step) * step
    time, findings = np.arange(20_000) * 1e-3, []
    assert _check_velocity(wave, wave, time, "recorded", "a.csv", findings) == pytest.approx(step)
    assert [(one.severity, one.value) for one in findings] == [("note", pytest.approx(step))] * told


@pytest.mark.parametrize(
    ("before", "after", "left_out"), [(5, 0, 0), (6, 0, 6), (0, 5, 0), (0, 6, 6), (9, 12, 21)]
)
def test_rests_of_more_than_five_samples_are_left_out(before, after, left_out):
    ramp = np.concatenate([np.zeros(before), np.arange(101.0), np.full(after, 100.0)])
    findings = []
    first, last = _moving_part(ramp, "a.csv", findings)
    assert first + len(ramp) - last == left_out
    assert [one.value for one in findings] == [left_out] * (left_out > 0)


def test_cycles_are_counted_by_crossings_or_by_the_path():
    phase = np.linspace(0.0, 3.0, 3001)  # in cycles
    assert cycles_of(np.sin(2.0 * np.pi * phase)) == pytest.approx(3.0, abs=0.02)
    assert cycles_of(5.0 - 0.01 * np.cos(2.0 * np.pi * phase)) == pytest.approx(3.0, abs=0.02)
    assert cycles_of(np.arange(101.0)) == 0.5
    drifting = np.sin(2.0 * np.pi * phase) + 2.0 * phase  # it crosses its middle once
    turns = np.abs(np.diff(drifting)).sum() / (2.0 * np.ptp(drifting))
    assert cycles_of(drifting) == pytest.approx(turns, rel=1e-3)


def test_the_first_swing_only_sets_the_state_of_what_remembers():
    time = np.linspace(0.0, 3.25, 3251)
    x = -np.cos(2.0 * np.pi * time)
    motion = replace(read_motion(x, None, x, time)[0], displacement=x)
    assert _fitted_part(motion) == slice(500, None)
    assert _fitted_part(replace(motion, displacement=x[:900])) == slice(0, None)  # it turns once
    small = x + 0.05 * np.sin(100.0 * time)  # less than a tenth of the stroke is no turn
    assert _fitted_part(replace(motion, displacement=small)).start == pytest.approx(500, abs=30)


# records that are not what they seem ----------------------------------------------------------------------------------


def shaken(cycles=6, seed=1):
    """Time (s), displacement (m), velocity (m/s) and noisy force (N) of a damper of 900 and 1500 N s/m with gas."""
    t = np.arange(0.0, 0.5 * cycles, 1e-3)
    x, v = 0.02 * np.sin(4.0 * np.pi * t), 0.08 * np.pi * np.cos(4.0 * np.pi * t)
    return (
        t,
        x,
        v,
        np.where(v > 0.0, 900.0, 1500.0) * v
        + 120.0
        + np.random.default_rng(seed).normal(0.0, 2.0, len(t)),
    )


def advised(x, v, f, t, law="bilinear", **more):
    return messages(fit_damper(x, v, f, t, law=law, **more))


def test_a_damper_that_fades_and_a_zero_that_drifts_are_told():
    t, x, v, f = shaken()
    told = (
        "the damping falls",
        "the force at rest drifts",
        "out of range",
        "spikes",
        "samples were missing",
    )
    assert not any(one in advised(x, v, f, t) for one in told)
    assert "the damping falls by 15 %" in advised(
        x, v, 120.0 + (f - 120.0) * (1.0 - 0.14 * t / t[-1]), t
    )
    assert "the force at rest drifts by 60" in advised(x, v, f + 60.0 * t / t[-1], t)


def test_a_sensor_out_of_range_is_told_and_no_law_blamed():
    t, x, v, f = shaken()
    assert "samples of the force are flat at its limits: the load cell" in advised(
        x, v, np.clip(f, -150.0, 250.0), t
    )
    assert "samples of the displacement are flat" in advised(np.clip(x, -0.015, 0.015), None, f, t)


def test_samples_that_are_missing_though_the_time_goes_on_are_told():
    """Samples lost, and a clock that was made up afterwards: too soft a damper, and nothing was said."""
    t, x, _, f = shaken()
    kept = np.arange(len(t)) % 10 != 7
    found = fit_damper(x[kept], None, f[kept], t[: kept.sum()], law="bilinear")
    assert not found.parameters["bump_coefficient"].has(900.0)
    assert "places as if samples were missing" in messages(found)
    true = fit_damper(x[kept], None, f[kept], t[kept], law="bilinear")
    assert true.parameters["bump_coefficient"].value == pytest.approx(900.0, rel=0.02)
    assert "samples were missing" not in messages(true)


def test_spikes_are_told_in_place_of_a_law():
    t, x, v, f = shaken()
    f[::500] += 2000.0
    assert "6 samples deviate from the law by more than 12 times" in advised(x, v, f, t)


def test_a_degressive_valve_is_not_taken_for_dry_friction():
    t, x, v, _ = shaken()
    valve = np.where(
        np.abs(v) < 0.05, 2000.0 * v, np.sign(v) * (100.0 + 500.0 * (np.abs(v) - 0.05))
    )
    assert "a degressive valve rather than dry friction" in advised(x, v, valve, t, law="linear")
    assert "dry friction; fit with" in advised(x, v, 900.0 * v + 60.0 * np.sign(v), t, law="linear")


def test_a_smooth_velocity_of_whole_cycles_has_no_steps():
    t, x, v, f = shaken()
    assert "recorded in steps" not in advised(x, v, f, t)


def _of(group: str, name: str) -> foreign_records.Record:
    """A record whose truth is known, made without jounce."""
    return next(one for one in foreign_records.dampers() if (one.group, one.name) == (group, name))


def _fitted(record: foreign_records.Record) -> tuple[DamperResult, list[str]]:
    time, stroke, force = record.columns.values()
    result = fit_damper(1e-3 * stroke, None, force, time, law="bilinear", **dict(record.choice))
    return result, [one.message for one in result.findings if one.severity == "warning"]


@pytest.mark.parametrize(
    ("group", "name", "words"),
    [
        (
            "sign",
            "both turned, gas 45, rest 0.5 s, friction 0 False, rebound 600",
            "where gas would push outwards",
        ),
        ("steps", "force 50 N, 1 Hz, noise 1", "steps of 50 N"),
        ("filter", "both low pass of order 1 at 3 times 1 Hz", "a low-pass filter of the logger"),
        ("filter", "both low pass of order 2 at 6 times 1 Hz", "a low-pass filter of the logger"),
    ],
)
def test_what_a_logger_did_to_the_force_is_told(group: str, name: str, words: str) -> None:
    result, told = _fitted(_of(group, name))
    assert abs(result.parameters["bump_coefficient"].value / foreign_records.BUMP - 1.0) > 0.08
    assert any(words in text for text in told)


@pytest.mark.parametrize("kind", ["zero", "held"])
@pytest.mark.parametrize("which", ["force", "all"])
def test_dropouts_are_left_out_and_no_oil_is_blamed(which: str, kind: str) -> None:
    result, told = _fitted(_of("dropout", f"{which} {kind} 5 times 0.1 s"))
    assert result.parameters["bump_coefficient"].value == pytest.approx(
        foreign_records.BUMP, rel=0.02
    )
    assert result.parameters["rebound_coefficient"].value == pytest.approx(
        foreign_records.REBOUND, rel=0.02
    )
    assert [text for text in told if "logger dropouts" not in text] == []
    assert told


def test_a_machine_that_dwells_or_moves_evenly_has_no_dropouts() -> None:
    time = np.arange(0.0, 8.0, 2e-3)
    place = np.abs((time % 2.0) - 1.0)
    triangle = 0.04 * (place - 0.5)
    dwelling = 0.04 * (np.clip(1.6 * place - 0.3, 0.0, 1.0) - 0.5)
    for stroke in (triangle, dwelling):
        velocity = np.gradient(stroke, time)
        result = fit_damper(stroke, velocity, 900.0 * velocity, time)
        assert not any("dropouts" in one.message for one in result.findings)
        assert result.parameters["coefficient"].value == pytest.approx(900.0, rel=1e-6)
