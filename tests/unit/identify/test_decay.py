"""Results and refusals of the decay fit."""

import math
from dataclasses import replace
from itertools import count

import foreign_records
import numpy as np
import pytest

from jounce.core.errors import DescriptionError, FitError
from jounce.core.serialise import to_json
from jounce.identify.decay import (
    Peaks,
    _advice,
    _along_the_valley,
    _at_rest,
    _estimates,
    _fit,
    _naive_decrement,
    _next_start,
    _off_jumps,
    _part,
    combine_decays,
    fit_decay,
)
from jounce.identify.estimate import Estimate, Uncertainty, central_differences, combine
from jounce.identify.free_response import DecayParameters, decay_response, decay_slopes

MASS, STIFFNESS = 16.0, 18362.0
TIME = np.arange(0.0, 2.0, 1e-3)


def truth(c=120.0, friction=15.0, offset=0.003, release=0.2, deflection=0.020):
    omega = math.sqrt(STIFFNESS / MASS)
    return DecayParameters(
        omega,
        c / (2 * math.sqrt(STIFFNESS * MASS)),
        friction / STIFFNESS,
        offset,
        release,
        deflection,
    )


def record(noise=0.0, seed=0, time=TIME, quantity="displacement", **changes):
    clean = decay_response(time, truth(**changes), quantity)
    return clean + np.random.default_rng(seed).normal(0.0, 1.0, len(time)) * noise


@pytest.mark.parametrize("quantity", ["displacement", "velocity", "acceleration"])
@pytest.mark.parametrize(
    "changes", [{}, {"friction": 0.0}, {"c": 700.0, "deflection": -0.02}, {"c": -3.0}]
)
def test_slopes_are_those_of_differences(quantity, changes):
    exact = truth(**changes)
    values = np.array(list(vars(exact).values()))
    steps = np.append(
        np.maximum(1e-6 * np.abs(values[:6]), [1e-6, 1e-6, 1e-9, 1e-6, 1e-6, 1e-9]), 0.0
    )
    slopes = decay_slopes(TIME, exact, quantity)
    for i, move in enumerate(np.diag(steps)[:6]):
        after, before = (
            decay_response(TIME, DecayParameters(*(values + way * move)), quantity)
            for way in (1.0, -1.0)
        )
        expected = (after - before) / (2.0 * steps[i])
        off = np.abs(slopes[:, i] - expected) / np.max(np.abs(slopes[:, i]))
        assert np.count_nonzero(off > 1e-6) <= 30, i  # samples next to which a swing ends or begins
        assert np.median(off) < 1e-8, i


def messages(result):
    return " | ".join(finding.message for finding in result.findings)


def test_exact_decay_gives_its_parameters():
    result = fit_decay(TIME, record(), mass=MASS)
    assert result.damping_coefficient.value == pytest.approx(120.0, rel=1e-6)
    assert result.coulomb_force.value == pytest.approx(15.0, rel=1e-6)
    assert result.damping_ratio.value == pytest.approx(0.1106958, abs=1e-6)
    assert result.natural_frequency_hz.value == pytest.approx(5.39163, abs=1e-5)
    assert result.equilibrium.value == pytest.approx(0.003, abs=1e-9)
    assert result.stiffness.value == pytest.approx(STIFFNESS, rel=1e-7)
    assert result.parameters.release_time == pytest.approx(0.2, abs=1e-7)
    assert result.r2 == pytest.approx(1.0, abs=1e-9)


def test_naive_decrement_depends_on_the_amplitude():
    # domain A6: full-cycle log-dec gives 0.1530, 0.1834, 0.2612 instead of 0.1107
    result = fit_decay(TIME, record(), mass=MASS)
    assert result.naive_damping_ratios == pytest.approx([0.1530, 0.1834, 0.2612], abs=3e-4)
    assert result.decrements[0] == pytest.approx(math.log(20.0 / 7.559395), abs=1e-4)
    assert result.cycles == pytest.approx(2.0)
    assert "dry friction; use the combined estimate" in messages(result)
    assert result.logarithmic_decrement.value > 2 * math.pi * 0.1107 / math.sqrt(1 - 0.1107**2)


def test_two_peaks_give_the_decrement_of_a_whole_cycle():
    # they lie half a cycle apart; the second is q x0 - x_k (1 + q) with q = exp(-pi zeta / sqrt(1 - zeta^2))
    result = fit_decay(TIME, record(c=200.0, friction=60.0), mass=MASS)
    assert result.amplitudes == pytest.approx([0.020, 0.0060106], rel=2e-3)
    assert result.logarithmic_decrement.value == pytest.approx(
        2.0 * math.log(0.020 / 0.0060106), rel=2e-3
    )
    assert result.decrements == ()


def test_without_friction_the_decrement_is_the_textbook_one():
    result = fit_decay(TIME, record(friction=0.0, noise=2e-5), mass=MASS)
    assert result.coulomb_force.interval[0] == 0.0
    assert result.coulomb_force.interval[1] < 0.05
    # delta = 2 pi zeta / sqrt(1 - zeta^2) at zeta = 0.110696
    assert result.logarithmic_decrement.value == pytest.approx(0.69983, rel=0.02)
    assert "use the combined" not in messages(result)


def test_negative_friction_is_reported_as_none():
    for seed in range(20):
        result = fit_decay(TIME, record(friction=0.0, noise=1e-4, seed=seed), mass=MASS)
        assert result.coulomb_force.value >= 0.0
        assert result.parameters.friction_deflection >= 0.0
        if result.parameters.friction_deflection == 0.0:
            assert result.coulomb_force.value == 0.0
            assert "no dry friction" in messages(result)
            return
    pytest.fail("no seed made the friction negative: the test shows nothing")


def test_rest_position_is_not_taken_for_the_equilibrium():
    result = fit_decay(TIME, record(noise=2e-5), mass=MASS)
    rest = record()[-1]
    assert abs(rest - 0.003) > 0.4e-3
    assert result.equilibrium.has(0.003)


@pytest.mark.parametrize("quantity", ["velocity", "acceleration"])
def test_other_quantities_give_the_same_damping(quantity):
    result = fit_decay(TIME, record(quantity=quantity, offset=0.0), mass=MASS, quantity=quantity)
    assert result.damping_coefficient.value == pytest.approx(120.0, rel=1e-4)
    assert result.coulomb_force.value == pytest.approx(15.0, rel=1e-4)
    assert result.equilibrium is None


@pytest.mark.parametrize("offset", [-9.0, 9.0])
def test_a_velocity_with_any_zero_gives_the_same_damping(offset):
    """The search began at an offset of 0 and ended in another minimum, which explained half of the record."""
    shown = record(quantity="velocity", offset=offset, c=40.0, friction=50.0)
    result = fit_decay(TIME, shown, mass=MASS, quantity="velocity")
    assert result.damping_coefficient.value == pytest.approx(40.0, rel=1e-4)
    assert result.coulomb_force.value == pytest.approx(50.0, rel=1e-4)
    assert result.parameters.offset == pytest.approx(offset, rel=1e-6)


def test_record_that_starts_in_motion():
    moving = TIME > 0.23
    result = fit_decay(TIME[moving], record(noise=2e-5)[moving], mass=MASS)
    assert result.damping_coefficient.has(120.0)
    assert result.coulomb_force.has(15.0)


def test_impulse_in_the_middle_of_the_record():
    # at rest in equilibrium, then an initial velocity at 0.5 s; integrated independently of the closed form
    from scipy.integrate import solve_ivp

    def rate(_, state):
        force = -120.0 * state[1] - 4.0 * np.tanh(state[1] / 1e-5) - STIFFNESS * state[0]
        return [state[1], force / MASS]

    t = TIME[TIME >= 0.5]
    moved = solve_ivp(rate, (0.5, 2.0), [0.0, 0.8], method="LSODA", t_eval=t, rtol=1e-8, atol=1e-11)
    signal = np.concatenate([np.zeros(len(TIME) - len(t)), moved.y[0]])
    signal += np.random.default_rng(0).normal(0.0, 1e-5, len(signal))
    result = fit_decay(TIME, signal, mass=MASS)
    assert result.damping_coefficient.value == pytest.approx(120.0, rel=0.01)
    assert result.coulomb_force.value == pytest.approx(4.0, rel=0.03)


def test_larger_friction_at_rest_does_not_spoil_the_damping():
    clean = record()
    stop = 0.2 + 4 * math.pi / (math.sqrt(STIFFNESS / MASS) * math.sqrt(1 - 0.1107**2))
    stuck = np.where(
        stop < TIME, clean[np.searchsorted(TIME, stop)], clean
    )  # rests one half swing too early
    stuck += np.random.default_rng(0).normal(0.0, 1e-5, len(TIME))
    result = fit_decay(TIME, stuck, mass=MASS)
    assert result.damping_coefficient.value == pytest.approx(120.0, rel=0.03)
    assert result.coulomb_force.value == pytest.approx(15.0, rel=0.03)


@pytest.mark.parametrize(("c", "friction"), [(400.0, 10.0), (500.0, 15.0), (600.0, 0.0)])
def test_few_swings_still_give_covering_intervals_and_a_warning(c, friction):
    result = fit_decay(TIME, record(noise=2e-5, c=c, friction=friction), mass=MASS)
    assert result.damping_coefficient.has(c)
    assert result.coulomb_force.has(friction)
    assert result.cycles <= 1.5
    assert ("hardly be distinguished" in messages(result)) == (result.cycles < 1.5)


def test_given_stiffness_is_compared():
    assert "from the given" not in messages(
        fit_decay(TIME, record(), mass=MASS, stiffness=1.02 * STIFFNESS)
    )
    assert "-9.1 % from the given" in messages(
        fit_decay(TIME, record(), mass=MASS, stiffness=1.1 * STIFFNESS)
    )


def test_coarse_sampling_is_reported():
    time = np.arange(0.0, 2.0, 0.0125)
    assert "samples per cycle" in messages(fit_decay(time, record(time=time), mass=MASS))


def test_a_beat_is_not_taken_for_a_decay():
    t = np.arange(0.0, 4.0, 1e-3)
    beat = 0.01 * np.exp(-0.3 * t) * (np.cos(30.0 * t) + 0.9 * np.cos(36.0 * t))
    assert "explains only" in messages(fit_decay(t, beat, mass=MASS))


def test_result_is_plain_data():
    assert "damping_ratio" in to_json(fit_decay(TIME, record(noise=1e-5), mass=MASS))


@pytest.mark.parametrize(
    ("time", "signal", "options", "text"),
    [
        (TIME[:-1], record(), {}, "same length"),
        (TIME[:10], record()[:10], {}, "too few samples"),
        (TIME, np.where(TIME[7] == TIME, np.nan, record()), {}, "sample 8"),
        (np.zeros_like(TIME), record(), {}, "does not increase"),
        (TIME[::-1], record(), {}, "does not increase"),
        (TIME, 0.0 * TIME, {}, "never changes"),
        (TIME, record(), {"mass": -1.0}, "mass is not positive"),
        (TIME, record(), {"stiffness": 0.0}, "stiffness is not positive"),
        (TIME, 0.02 * np.exp(-5.0 * TIME), {}, "no oscillation"),
    ],
)
def test_unusable_records_are_refused(time, signal, options, text):
    with pytest.raises(FitError, match=text):
        fit_decay(time, signal, **{"mass": MASS, "name": "decay.csv", **options})


def test_unknown_quantity_is_refused():
    with pytest.raises(DescriptionError, match="Did you mean 'velocity'"):
        fit_decay(TIME, record(), mass=MASS, quantity="velocty")


def test_combining_honours_the_scatter_between_runs():
    # by hand: equal errors 1, values 8, 10, 12: Q = 8, tau^2 = (8 - 2) / 2 = 3, error = sqrt((1 + 3) / 3)
    found = combine([Estimate(8.0, 1.0), Estimate(10.0, 1.0), Estimate(12.0, 1.0)])
    assert found.value == pytest.approx(10.0)
    assert found.standard_error == pytest.approx(math.sqrt(4.0 / 3.0))
    assert found.interval[1] == pytest.approx(10.0 + 4.3027 * math.sqrt(4.0 / 3.0), rel=1e-4)


def test_combining_agreeing_runs_weights_by_their_errors():
    found = combine([Estimate(10.0, 1.0), Estimate(10.2, 2.0)])
    assert found.value == pytest.approx(10.04)
    assert found.standard_error == pytest.approx(1.0 / math.sqrt(1.25))


def test_combining_without_errors_uses_the_scatter():
    assert combine([Estimate(1.0), Estimate(3.0)]).standard_error == pytest.approx(1.0)


def test_several_decays_become_one():
    runs = [fit_decay(TIME, record(noise=5e-5, seed=seed), mass=MASS) for seed in range(3)]
    found = combine_decays(runs)
    assert found.runs == 3
    assert found.cycles == pytest.approx(sum(run.cycles for run in runs))
    assert found.damping_coefficient.has(120.0)
    assert found.equilibrium.has(0.003)
    assert combine_decays(runs[:1]).damping_coefficient == runs[0].damping_coefficient
    assert "a copy" not in messages(found)
    assert "1 of 3 runs are identical to a different run: a copy" in messages(
        combine_decays([*runs[:2], runs[0]])
    )
    with pytest.raises(FitError, match="no decays"):
        combine_decays([])


def test_runs_of_different_systems_are_noticed():
    other = fit_decay(TIME, record(), mass=MASS)
    faster = fit_decay(0.8 * TIME, record(), mass=MASS)
    assert "was something changed" in messages(combine_decays([other, faster]))


@pytest.fixture(scope="module")
def exact():
    return fit_decay(TIME, record(), mass=MASS)


@pytest.mark.parametrize(
    ("changes", "step", "time", "stiffness", "told"),
    [
        (
            {},
            1e-3,
            4.1,
            None,
            [("warning", "use the combined estimate", 15.0), ("note", "successive residuals", 4.1)],
        ),
        ({}, 1e-3, 3.9, None, [("warning", "use the combined estimate", 15.0)]),
        ({"decrements": (1.0,)}, 1e-3, 1.0, None, []),
        ({"coulomb_force": Estimate(3.0, 2.0, (-1.0, 7.0))}, 1e-3, 1.0, None, []),
        (
            {"decrements": (), "cycles": 1.49},
            1e-3,
            1.0,
            None,
            [("warning", "only 1.49 cycles", 1.49)],
        ),
        ({"decrements": (), "cycles": 1.5}, 1e-3, 1.0, None, []),
        ({"decrements": (), "r2": 0.981}, 1e-3, 1.0, None, []),
        (
            {"decrements": (), "r2": 0.979},
            1e-3,
            9.0,
            None,
            [("problem", "explains only 97.9 %", 0.979)],
        ),
        (
            {"decrements": ()},
            1.0 / (19.9 * 5.39163),
            1.0,
            None,
            [("warning", "only 19.9 samples per cycle", 19.9)],
        ),
        ({"decrements": ()}, 1.0 / (20.1 * 5.39163), 1.0, None, []),
        ({"decrements": ()}, 1e-3, 1.0, STIFFNESS / 1.029, []),
        ({"decrements": ()}, 1e-3, 1.0, STIFFNESS / 0.971, []),
        (
            {"decrements": ()},
            1e-3,
            1.0,
            STIFFNESS / 1.031,
            [("warning", "+3.1 % from the given", 0.031)],
        ),
        (
            {"decrements": ()},
            1e-3,
            1.0,
            STIFFNESS / 0.969,
            [("warning", "-3.1 % from the given", -0.031)],
        ),
        (
            {"decrements": (), "quadratic_drag": Estimate(3.0)},
            1e-3,
            1.0,
            None,
            [("warning", "quadratic drag, 3 N", 3.0)],
        ),
        ({"decrements": (), "quadratic_drag": Estimate(0.0)}, 1e-3, 1.0, None, []),
        (
            {"decrements": (), "rms_residual": 1.9e-8},
            1e-3,
            9.0,
            None,
            [],
        ),  # a millionth of the release is rounding
        (
            {"decrements": (), "rms_residual": 2.1e-8},
            1e-3,
            9.0,
            None,
            [("note", "successive residuals", 9.0)],
        ),
    ],
)
def test_what_a_decay_is_told_of_begins_at_its_limits(exact, changes, step, time, stiffness, told):
    known = {
        "coulomb_force": Estimate(15.0, 1.0, (13.0, 17.0)),
        "rms_residual": 1e-5,
        "r2": 0.999,
        "cycles": 2.0,
    }
    found = _advice(
        replace(exact, **known | changes),
        Uncertainty(np.eye(7), 10.0, time),
        step,
        stiffness,
        "decay",
    )
    assert [(one.severity, pytest.approx(one.value, rel=1e-4)) for one in found] == [
        (one[0], one[2]) for one in told
    ]
    assert all(words in one.message for one, (_, words, _) in zip(found, told, strict=True))


@pytest.mark.parametrize("key", ["friction_deflection", "damping_ratio"])
def test_what_was_fitted_as_zero_is_told(exact, key):
    none = replace(exact, parameters=replace(exact.parameters, **{key: 0.0}), decrements=())
    (finding,) = _advice(none, Uncertainty(np.eye(7), 10.0, 1.0), 1e-3, None, "decay")
    assert ("dry friction" if key.startswith("friction") else "viscous damping") in finding.message
    assert (finding.severity, finding.value) == ("note", 0.0)


def test_decrements_of_one_two_and_many_amplitudes():
    assert _naive_decrement(np.array([3.0])) == Estimate(math.inf)
    assert _naive_decrement(np.array([3.0, 2.0])) == Estimate(2.0 * math.log(1.5))
    assert _naive_decrement(3.0 * 0.8 ** np.arange(5.0)).value == pytest.approx(
        -2.0 * math.log(0.8), rel=1e-12
    )


def test_runs_are_held_against_each_other(exact):
    number = count()

    def run(frequency=5.0, **more):
        own = replace(exact.parameters, release_time=float(next(number)))  # no copies
        return replace(
            exact,
            natural_frequency_hz=Estimate(frequency, 0.01),
            findings=(),
            parameters=own,
            **more,
        )

    for other, told in ((5.25, 0), (5.26, 1), (4.76, 0), (4.75, 1)):  # 5 % of the mean
        found = combine_decays([run(), run(other)]).findings
        assert [one.value for one in found] == [pytest.approx(abs(other - 5.0))] * told
    drag = {"quadratic_drag": Estimate(2.0, 0.1)}
    both, mixed, none = (
        combine_decays(each)
        for each in ([run(**drag), run(**drag)], [run(**drag), run(), run()], [run(), run()])
    )
    assert both.quadratic_drag.value == pytest.approx(2.0)
    assert (both.findings, none.findings, mixed.quadratic_drag, none.quadratic_drag) == (
        (),
        (),
        None,
        None,
    )
    assert [(one.severity, one.value) for one in mixed.findings] == [("warning", 1.0)]
    assert combine_decays([run(), run(equilibrium=None)]).equilibrium is None
    negative = run(damping_ratio=Estimate(-0.1, 0.01), damping_coefficient=Estimate(-1.0, 0.1))
    assert combine_decays([negative, negative]).damping_ratio.value == 0.0
    assert combine_decays([negative, negative]).damping_coefficient.value == 0.0


def test_time_windows_that_leave_nothing_are_refused():
    rest = np.where(TIME < 1.0, record(), record()[1000])
    for begin, end, text in (
        (0.5, 0.5, r"found '1 from 0.5 s to 0.5 s'; allowed: at least 20 within 0 s to 1.999 s"),
        (0.7, 0.5, "the time window leaves too few samples"),
        ("500 ms", 0.5185, "found '19 from 0.5 s to 0.5185 s'"),
        (1.1, None, "the record never changes in the time window; found '1.1 s to inf s'"),
    ):
        with pytest.raises(FitError, match=text):
            fit_decay(TIME, rest, mass=MASS, begin=begin, end=end, name="decay.csv")
    part = fit_decay(TIME, record(), mass=MASS, begin=0.21, end="1.5 s")
    assert part.damping_coefficient.value == pytest.approx(120.0, rel=1e-4)
    assert part.window[1] <= 1.5
    with pytest.raises(DescriptionError, match="unknown quadratic_drag"):
        fit_decay(TIME, record(), mass=MASS, quadratic_drag="maybe")


def test_after_a_hit_the_search_goes_on_behind_the_next_turning_point(exact):
    assert "was left out" not in messages(exact)
    swing = np.concatenate(
        [
            0.25 + 0.75 * np.cos(np.linspace(0.0, np.pi, 51)),
            -0.25 - 0.25 * np.cos(np.linspace(0.0, np.pi, 51)),
        ]
    )
    signal = np.concatenate([swing, np.zeros(200)])
    assert 50 <= _next_start(signal, 0, 0.0) <= 58
    assert _next_start(signal[:39], 0, 0.0) is None  # fewer than two decays' samples
    assert _next_start(np.concatenate([swing[:51], np.full(200, -0.5)]), 5, 0.0) > 5


def test_a_misfit_of_the_first_half_swing_is_told_from_one_behind_it():
    ripple = 5e-5 * np.sin(900.0 * TIME)
    for disturbed, low, high in ((TIME < 0.28, 3.0, np.inf), (TIME > 0.31, 0.0, 0.5)):
        part = _part(TIME, record() + ripple * disturbed, 201, 0.0, "displacement", "decay.csv")
        assert low < part.early_misfit < high
        assert part.r2 > 0.99


def test_what_a_decay_gives_knows_what_its_parameters_know():
    """Damping, friction, drag and stiffness are products of the fitted numbers, and their errors those of products."""
    p = replace(truth(), quadratic_drag=3.0)
    at = np.array(list(vars(p).values()))
    root = np.random.default_rng(5).normal(size=(7, 7)) * np.maximum(np.abs(at), 1e-3)[:, None]
    found = _estimates(p, Uncertainty(root @ root.T, 10.0, 1.0), MASS)

    def derived(values):
        omega, ratio, friction, offset, _, _, drag = values
        return np.array([
            ratio, 2.0 * ratio * omega * MASS, friction * MASS * omega**2, omega / (2.0 * math.pi), drag * MASS, offset,
            MASS * omega**2,
        ])  # fmt: skip

    errors = np.linalg.norm(
        central_differences(derived, at, 1e-4 * np.maximum(np.abs(at), 1e-3)) @ root, axis=1
    )
    names = ("damping_ratio", "damping_coefficient", "coulomb_force", "natural_frequency_hz", "quadratic_drag",
             "equilibrium", "stiffness")  # fmt: skip
    assert set(found) == set(names)
    for name, value, error in zip(names, derived(at), errors, strict=True):
        assert (found[name].value, found[name].standard_error) == pytest.approx(
            (value, error), rel=1e-6
        ), name


def test_a_rest_is_half_a_period_of_nothing_at_the_end():
    t = np.arange(400) * 1e-2
    peaks = Peaks(
        np.arange(5.0) * 0.5, 0.5 ** np.arange(5.0) * (-1.0) ** np.arange(5)
    )  # half a period: 0.5 s
    for moves, rests in ((349, False), (347, True)):
        signal = np.where(np.arange(400) < moves, np.cos(2.0 * np.pi * t), 0.3)
        assert _at_rest(t, signal, peaks).tolist() == [
            bool(rests and i >= moves) for i in range(400)
        ]
    assert not _at_rest(t, np.cos(2.0 * np.pi * t), peaks).any()
    for off, begin in ((1.9e-3, 200), (2.1e-3, 300)):  # a thousandth of the range of 2
        signal = np.where(
            np.arange(400) < 200, np.cos(2.0 * np.pi * t), 0.3 + off * (np.arange(400) < 300)
        )
        assert int(np.argmax(_at_rest(t, signal, peaks))) == begin


@pytest.mark.parametrize("ratio", [0.02, 0.4])
def test_samples_beside_a_jump_of_the_acceleration_do_not_count(ratio):
    p = DecayParameters(10.0, ratio, 0.001, 0.0, 0.05, 0.02)
    gaps = np.abs(
        TIME - 0.05 - np.arange(-1, 9)[:, None] * math.pi / (10.0 * math.sqrt(1.0 - ratio**2))
    ).min(axis=0)
    assert _off_jumps(TIME, p).tolist() == (gaps > 0.6e-3).astype(float).tolist()


def test_what_holds_no_decay_is_not_searched():
    start = np.array([30.0, 0.1, 0.001, 0.0, 0.0, 0.02])
    for signal, begin in (
        (record()[:19], start),
        (np.ones(200), start),
        (record()[200:400], np.where(np.arange(6) == 2, np.nan, start)),
    ):
        with pytest.raises(
            FitError,
            match=f"contains no free decay that can be fitted; found '{len(signal)} samples",
        ):
            _fit(TIME[: len(signal)], signal, [begin], "displacement")


def test_friction_is_exchanged_for_damping_that_takes_as_much():
    """A half cycle takes pi zeta of the amplitude, and 2 x_k: over the mean amplitude, half of it, 4 x_k / pi."""
    start = np.array([30.0, 0.3, 0.001, 0.002, 0.1, -0.02])
    moved = _along_the_valley(start, 0.15)
    assert moved - start == pytest.approx(
        [0.0, -4.0 * 0.15e-3 / (math.pi * 0.02), 0.15e-3, 0.0, 0.0, 0.0]
    )
    assert _along_the_valley(np.where(np.arange(6) == 2, 0.0, start), -0.05)[2] == pytest.approx(
        -0.05 * 0.01 * 0.02
    )
    assert _along_the_valley(start, 300.0)[1] == -0.15
    assert _along_the_valley(start, -300.0)[1] == 0.95


# what intervals do not count ------------------------------------------------------------------------------------------


def swung(cubic=0.0, bump=120.0, rebound=120.0):
    """A decay of 16 kg on 18.4 N/mm from 20 mm, by a simulation of its own: cubic spring (N/m^3), two-sided damper."""
    from scipy.integrate import solve_ivp

    t = np.arange(0.0, 1.5, 1e-3)

    def rates(_, state):
        x, v = state
        return v, -(18362.0 * x + cubic * x**3 + (bump if v < 0.0 else rebound) * v) / 16.0

    x = solve_ivp(
        rates, (0.0, 1.5), (-0.02, 0.0), t_eval=t, rtol=1e-8, atol=1e-11, max_step=5e-3
    ).y[0]
    return t, x + np.random.default_rng(3).normal(0.0, 2e-5, len(t))


def told_of(t, x):
    return " | ".join(one.message for one in fit_decay(t, x, mass=16.0).findings)


def test_a_spring_that_stiffens_is_not_taken_for_dry_friction():
    t, x = swung(cubic=2e7)
    assert not fit_decay(t, x, mass=16.0).coulomb_force.has(0.0)
    assert "stiffer at large deflections" in told_of(t, x)
    assert "large deflections" not in told_of(*swung())


def test_a_drift_and_a_damper_that_is_firmer_in_one_direction_are_named():
    t, x = swung()
    assert "drifts" not in told_of(t, x)
    assert "the zero of the record drifts by" in told_of(t, x + 2e-3 * t)
    assert "firmer in one direction; the damping is the mean" in told_of(
        *swung(bump=80.0, rebound=160.0)
    )


def test_samples_that_a_decay_lacks_are_told():
    t, x = swung()
    kept = np.arange(len(t)) % 10 != 4
    assert "as if samples were missing" in told_of(t[: kept.sum()], x[kept])
    assert "as if samples were missing" not in told_of(t[kept], x[kept])
    assert "as if samples were missing" not in told_of(t, 5e-4 * np.round(x / 5e-4))


def _record(group, name):
    """Columns of a record whose truth is known, made without jounce: time (s) and displacement (m)."""
    found = next(one for one in foreign_records.decays() if (one.group, one.name) == (group, name))
    time, signal = found.columns.values()
    return time, 1e-3 * signal


def _fit_foreign(group, name):
    result = fit_decay(*_record(group, name), mass=foreign_records.MASS)
    return result, " ".join(one.message for one in result.findings if one.severity != "note")


@pytest.mark.parametrize("curve", ["line", "warming"])
def test_a_drift_is_taken_off_and_blamed_on_no_damper(curve):
    result, told = _fit_foreign("drift", f"z by 0.4 as a {curve}")
    assert result.damping_coefficient.value == pytest.approx(foreign_records.DAMPING, rel=0.01)
    assert result.damping_coefficient.interval[1] < 1.2 * foreign_records.DAMPING
    assert "drifts by" in told
    assert "one direction" not in told


def test_a_damper_that_is_firmer_in_one_direction_does_not_drift():
    _, told = _fit_foreign("firmer in one direction", "0.6, z")
    assert "one direction" in told
    assert "drifts" not in told


@pytest.mark.parametrize("order", [1, 2, 4])
def test_a_low_pass_is_seen_in_the_noise(order):
    result, told = _fit_foreign("filter", f"z low pass of order {order} at 10 Hz, friction 8")
    assert result.damping_coefficient.value > 1.2 * foreign_records.DAMPING
    assert "a low-pass filter of the logger" in told
    assert (
        "a low-pass filter of the logger"
        not in _fit_foreign("plain", "z, 1000 Hz, friction 3, 1")[1]
    )


def test_dropouts_of_a_decay_are_left_out():
    result, told = _fit_foreign("dropout", "z held 4 times 0.2 s")
    assert result.damping_coefficient.value == pytest.approx(foreign_records.DAMPING, rel=0.01)
    assert "logger dropouts" in told


def test_a_beat_is_no_second_hit():
    time, signal = _record("beat", "8 % apart, 0.98, z")
    result = fit_decay(time, signal, mass=foreign_records.MASS)
    told = " ".join(one.message for one in result.findings)
    assert "second impact" not in told
    assert "explains only" in told


def test_the_equivalent_damping_ratio_has_the_decrement():
    truth = DecayParameters(33.9, 0.11, 0.0, 0.0, 0.2, 0.020)
    time = np.arange(0.0, 2.0, 1e-3)
    result = fit_decay(time, decay_response(time, truth, "displacement"), mass=16.0)
    assert result.equivalent_damping_ratio.value == pytest.approx(0.11, rel=1e-3)
    assert combine_decays([result]).equivalent_damping_ratio == result.equivalent_damping_ratio
    (asked,) = [one for one in result.findings if "none was given for comparison" in one.message]
    assert asked.severity == "note"
    assert asked.value == pytest.approx(16.0 * 33.9**2, rel=1e-4)


def _told_of(group, name, quantity="displacement", factor=1e-3):
    found = next(one for one in foreign_records.decays() if (one.group, one.name) == (group, name))
    time, signal = found.columns.values()
    result = fit_decay(time, factor * signal, mass=foreign_records.MASS, quantity=quantity)
    return " ".join(one.message for one in result.findings if one.severity != "note")


def test_a_small_second_hit_is_told_by_what_it_leaves():
    assert "the oscillations before 0.6" in _told_of("hit", "second at 0.6 s, 0.1 m/s, z")
    assert "the oscillations before" not in _told_of("plain", "z, 200 Hz, friction 0, 1")
    assert "the oscillations before" not in _told_of("firmer in one direction", "3, z")


def test_a_jump_of_a_velocity_is_told_where_it_is():
    assert "jumps by 0.0979" in (
        told := _told_of("hit", "second at 0.6 s, 0.1 m/s, vz", "velocity", 1.0)
    )
    assert "at 0.602 s" in told
    assert "jumps" not in _told_of("plain", "az, 1000 Hz, friction 3, 1", "acceleration", 1.0)


def test_a_coupling_is_told_by_what_undoes_it():
    told = _told_of(
        "coupling", "az high pass of order 1 at 0.5 Hz, friction 8", "acceleration", 1.0
    )
    assert "high-pass filtered at about 0.4" in told
    assert "high-pass" not in _told_of("plain", "az, 1000 Hz, friction 3, 1", "acceleration", 1.0)


@pytest.mark.parametrize(
    ("said", "true", "quantity"),
    [
        ("z", "velocity", "displacement"),
        ("vz", "displacement", "velocity"),
        ("az", "displacement", "acceleration"),
    ],
)
def test_a_record_of_another_quantity_is_told_by_its_corners(said, true, quantity):
    kind = {"velocity": "vz", "displacement": "z"}[true]
    told = _told_of(
        "exchange", f"{kind} said to be {said}, friction 8", quantity, 1e-3 if said == "z" else 1.0
    )
    assert f"looks like {true} rather than {quantity}" in told


def test_steps_that_hide_the_friction_are_told():
    truth = DecayParameters(33.9, 0.02, 1e-4, 0.0, 0.0, 0.02)
    t = np.arange(0.0, 3.0, 2e-3)
    x = decay_response(t, truth, "displacement")
    assert "rounding hides the friction" in told_of(t, 5e-4 * np.round(x / 5e-4))
    assert "rounding hides the friction" not in told_of(t, 1e-5 * np.round(x / 1e-5))


def test_a_sensor_out_of_range_is_told_of_arrays_too():
    t, x = swung()
    assert "lie at the limits of the record" in told_of(t, np.clip(x, -0.008, 0.008))
    assert "lie at the limits of the record" not in told_of(t, x)


def test_the_jump_of_a_release_hides_no_second_hit_and_is_none() -> None:
    from scipy import signal

    rate, turning, ratio = 5000.0, 32.0, 0.09
    time = np.arange(0.0, 4.0, 1.0 / rate)
    swing, damped = np.maximum(time - 0.5, 0.0), turning * math.sqrt(1.0 - ratio**2)
    fall = 0.012 * np.exp(-ratio * turning * swing)
    height = fall * (np.cos(damped * swing) + ratio * turning / damped * np.sin(damped * swing))
    speed = -fall * turning**2 / damped * np.sin(damped * swing)
    pushed = -(turning**2) * height - 2.0 * ratio * turning * speed
    low_pass = signal.butter(4, 1000.0, fs=rate, output="sos")
    noise = 0.02 * np.random.default_rng(1).standard_normal(time.size)
    codes = []
    for hit in (0.0, 1.5):  # m/s^2, at 1.2 s; the release at 0.5 s jumps by 12 m/s^2
        seen = (
            signal.sosfilt(
                low_pass, np.where(time >= 0.5, pushed, 0.0) + np.where(time > 1.2, hit, 0.0)
            )
            + noise
        )
        codes.append(
            {
                item.code
                for item in fit_decay(time, seen, mass=16.0, quantity="acceleration").findings
            }
        )
    assert "identify.decay_jumps_once" not in codes[0]
    assert "identify.decay_jumps_once" in codes[1]
