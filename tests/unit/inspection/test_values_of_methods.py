"""Values of methods from known forces, poles and covariances, and where their findings begin."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest

from jounce.inspection import methods, quarter_car, turn_forces
from jounce.inspection.methods import WheelTest, find_adhesion, find_rigidity, rigidity_findings
from jounce.inspection.quarter_car import (
    LinearQuarterCar,
    ResponseFit,
    body_damping,
    road_poles,
    stretch_of,
    wheel_damping,
)
from jounce.inspection.signals import WheelSignals, _residual_per_hz, find_turns
from jounce.inspection.sweep import Sweep
from jounce.inspection.turn_forces import Analysis, FrequencyCurve, find_lift_off, stretches_between
from jounce.parts.testers import load_tester
from jounce.testers.plates import phase_angle

EGEA, THETA = load_tester("egea-specsus2018"), load_tester("theta-msd3000")
CAR = LinearQuarterCar(400.0, 40.0, 25e3, 1000.0, 200e3, 100.0)


def held(hz: float, turns: float, *, noise: float = 0.0) -> tuple[WheelSignals, Sweep]:
    """A plate held at one frequency, 3 mm, and a force of 600 N that leads by 0.4 rad."""
    time = np.arange(round(1000.0 * turns / hz)) / 1000.0
    angle = 2.0 * np.pi * hz * time
    draw = np.random.default_rng(1).standard_normal(time.size)
    force = 4e3 + 600.0 * np.sin(angle + 0.4) + noise * draw
    one = WheelSignals("left", time, force, 3e-3 * np.sin(angle), None, 4e3, 20.0)
    found = find_turns(time, one.height, 0.0, 3e-3)
    count = found.top.size
    return one, Sweep(found, count - 1, count - 1, slice(0, count), 0.0)


def test_rigidity_of_a_hold() -> None:
    """EGEA: 0.571 times force over motion, and 46 N/mm; its interval is that of the noise over 24 turns."""
    signals, sweep = held(25.0, 60.0, noise=40.0)
    found, findings = find_rigidity(signals, sweep, 4e3)
    assert findings == []
    assert found.force_amplitude == pytest.approx(600.0, abs=10.0)
    assert found.rigidity == pytest.approx(0.571 * found.force_amplitude / 3e-3 + 46e3, rel=1e-3)
    error = 40.0 * math.sqrt(2.0 / (24 * 40))
    assert found.half_width == pytest.approx(1.96 * 0.571 * error / 3e-3, rel=0.1)


@pytest.mark.parametrize(
    ("hz", "turns", "known"),
    [(24.1, 30, True), (23.9, 30, False), (25.9, 30, True), (26.1, 30, False)],
)
def test_rigidity_needs_a_hold_at_25_hz(hz, turns, known) -> None:
    signals, sweep = held(hz, turns)
    found, findings = find_rigidity(signals, sweep, 4e3)
    assert (found is not None) is known
    assert [one.code for one in findings] == ([] if known else ["no_rigidity_hold"])
    for one in findings:
        assert one.words == {"count": 25, "frequency": pytest.approx(hz, rel=1e-3)}
    for count, enough in ((6, True), (5, False)):
        short = Sweep(sweep.turns, sweep.first, sweep.last, slice(0, count), 0.0)
        assert (find_rigidity(signals, short, 4e3)[0] is not None) is (enough and known)


def test_rigidity_without_a_height() -> None:
    signals, sweep = held(25.0, 30)
    blind = WheelSignals("left", signals.time, signals.force, None, None, 4e3, 20.0)
    assert [one.code for one in find_rigidity(blind, sweep, 4e3)[1]] == ["no_rigidity_height"]


@pytest.mark.parametrize(
    ("rigidity", "code"),
    [(159.9e3, "tyre_soft"), (160e3, ""), (400e3, ""), (400.1e3, "tyre_stiff")],
)
def test_tyres_inflated_wrongly(rigidity: float, code: str) -> None:
    found = rigidity_findings(rigidity, EGEA, "left.tyre")
    assert [one.code for one in found] == ([code] if code else [])
    for one in found:
        assert one.words == pytest.approx(
            {"rigidity": 1e-3 * rigidity, "limit": 160.0 if code == "tyre_soft" else 400.0}
        )


def pair(ratio: float, hz: float) -> list[complex]:
    w = 2.0 * math.pi * hz
    pole = complex(-ratio * w, w * math.sqrt(1.0 - ratio**2))
    return [pole, pole.conjugate()]


def test_which_pole_is_the_wheels_and_which_the_bodys() -> None:
    both = np.array([*pair(0.2, 12.0), *pair(0.3, 1.2)])
    assert wheel_damping(both) == pytest.approx((0.2, 12.0))
    assert body_damping(both) == pytest.approx(0.3)
    creeping = np.array(
        [*pair(0.25, 11.0), -3.0, -9.0], dtype=complex
    )  # a body that does not oscillate
    assert wheel_damping(creeping) == pytest.approx((0.25, 11.0))
    assert body_damping(creeping) == 1.0
    stuck = np.array([*pair(0.1, 1.5), -60.0, -250.0], dtype=complex)  # a wheel that does not
    assert wheel_damping(stuck) == pytest.approx((1.0, 250.0 / (2.0 * math.pi)))
    assert body_damping(stuck) == pytest.approx(0.1)
    assert wheel_damping(np.array([-1.0, -4.0, -60.0, -250.0], dtype=complex))[0] == 1.0


def fitted(corner: LinearQuarterCar, relative: float) -> ResponseFit:
    """A fit whose parameters are all known to a share."""
    here = quarter_car._parameters(corner)
    return ResponseFit(corner, np.diag((relative * here) ** 2), 1.0, 0.995)


def test_spreads_follow_from_the_covariance() -> None:
    fit = fitted(CAR, 0.01)
    assert fit.spread(lambda one: one.spring_rate) == pytest.approx(250.0, rel=1e-6)
    assert fit.spread(lambda one: one.sprung_mass + one.unsprung_mass) == pytest.approx(
        math.hypot(4.0, 0.4), rel=1e-6
    )
    expected = abs(quarter_car.force_response(CAR, [8.0])[0])

    def response(**change: float) -> float:
        return abs(
            quarter_car.force_response(LinearQuarterCar(**{**vars(CAR), **change}), [8.0])[0]
        )

    slopes = [
        (response(**{name: value * 1.001}) - response(**{name: value * 0.999})) / 0.002
        for name, value in vars(CAR).items()
    ]
    assert fit.spread_at(8.0, np.abs) == pytest.approx(
        0.01 * math.sqrt(sum(s**2 for s in slopes)), rel=1e-3
    )
    assert expected > 0.0


def test_what_is_expected_pulls_down_the_surprise() -> None:
    """The pull is minus half of the surprise's slope, the normal matrix half of its curvature."""
    here, mass, variance = np.array([45.0, 26e3, 900.0, 210e3, 130.0, 380.0]), 440.0, 7.0
    known, pull = quarter_car._prior_equations(here, mass, variance)

    def surprise(at: np.ndarray) -> float:
        return quarter_car._surprise(at, mass, variance)

    steps = np.diag([1e-3 * value for value in here])
    slope = [(surprise(here + step) - surprise(here - step)) / (2.0 * step.max()) for step in steps]
    np.testing.assert_allclose(-2.0 * pull, slope, rtol=1e-6, atol=1e-9)
    np.testing.assert_allclose(np.linalg.multi_dot([steps, known, steps]).diagonal() * 2.0,
                               [surprise(here + s) + surprise(here - s) - 2.0 * surprise(here) for s in steps],
                               rtol=1e-5, atol=1e-9)  # fmt: skip
    assert surprise(np.array([40.0, 0.0, 0.0, 0.0, 50.0, 400.0])) == 0.0
    assert surprise(np.array([40.0, 0.0, 0.0, 0.0, 110.0, 400.0])) == pytest.approx(7.0)
    assert surprise(np.array([40.0, 0.0, 0.0, 0.0, 50.0, 488.0])) == pytest.approx(7.0)


def test_the_way_to_what_no_car_has_is_halved() -> None:
    before = np.array([40.0, 25e3, 1000.0, 200e3, 100.0, 400.0])
    tried = np.array([-10.0, -5.0, -2.0, 500.0, -3e3, 50.0])
    found = quarter_car._within(tried, before, 440.0)
    np.testing.assert_allclose(found, 0.5 * np.add(before, [0.44, 0.0, 0.0, 1e3, -2e3, 88.0]))
    high = quarter_car._within(np.array([300.0, 2e7, 2e6, 2e8, 3e4, 2e3]), before, 440.0)
    np.testing.assert_allclose(high, 0.5 * np.add(before, [264.0, 1e7, 1e6, 1e8, 2e4, 1320.0]))
    np.testing.assert_array_equal(quarter_car._within(before, before, 440.0), before)


def theta_of(corner: LinearQuarterCar, relative: float, tester=None):
    """What THETA finds in a test without a height, of which only the fit is known."""
    signals = WheelSignals("left", np.arange(2.0), np.ones(2), None, None, 4e3, 20.0)
    return methods._theta(
        WheelTest(signals, SimpleNamespace(turns=None), 4e3, tester, fitted(corner, relative))
    )


def test_findings_of_damping_ratios() -> None:
    sound = theta_of(CAR, 0.01)
    ratio = wheel_damping(road_poles(CAR))[0]
    assert sound.values["theta_road"] == sound.values["theta_rig"] == pytest.approx(ratio)
    assert sound.values["explained_force"] == 0.995
    assert sound.findings == []
    slope = (
        wheel_damping(road_poles(LinearQuarterCar(400.0, 40.0, 25e3, 1001.0, 200e3, 100.0)))[0]
        - ratio
    ) * 1000.0
    only_damper = ResponseFit(CAR, np.diag([0.0, 0.0, 10.0**2, 0.0, 0.0, 0.0]), 1.0, 0.99)
    assert methods.theta_by_fit(only_damper, None).road_half_width == pytest.approx(
        1.96 * 0.01 * slope, rel=1e-2
    )
    dead = LinearQuarterCar(400.0, 40.0, 25e3, 0.0, 200e3, 0.0)
    assert [one.code for one in theta_of(dead, 0.01).findings] == ["undamped"]
    firm = LinearQuarterCar(400.0, 40.0, 25e3, 7000.0, 200e3, 0.0)
    assert [one.code for one in theta_of(firm, 0.001).findings] == ["overdamped"]
    on_rig = theta_of(CAR, 0.01, THETA).values["theta_rig"]
    poles = quarter_car.rig_poles(
        CAR, THETA.plate_mass, THETA.plate_spring_rate, THETA.plate_damping_coefficient or 0.0
    )
    assert on_rig == pytest.approx(wheel_damping(poles)[0])


def test_a_vague_damping_of_the_body_is_not_told() -> None:
    known = theta_of(CAR, 0.05)
    assert known.half_widths["body_damping_ratio"] < 0.1
    assert known.values["body_damping_ratio"] == pytest.approx(body_damping(road_poles(CAR)))
    factor = 0.1 / known.half_widths["body_damping_ratio"]
    assert "body_damping_ratio" in theta_of(CAR, 0.05 * 0.98 * factor).values
    assert "body_damping_ratio" not in theta_of(CAR, 0.05 * 1.02 * factor).values


def analysis(least, greatest, lifted=None, fit=None) -> Analysis:
    count = len(least)
    rows = np.full((count, 7), np.nan)
    rows[:, 0], rows[:, 2] = least, greatest
    frequency = np.linspace(24.0, 6.0, count)
    off = np.zeros(count, dtype=bool) if lifted is None else np.asarray(lifted)
    return Analysis(
        4e3,
        fit,
        np.arange(float(count)),
        frequency,
        frequency,
        rows,
        np.full_like(rows, np.nan),
        off,
        3e-3,
    )


def test_adhesion_is_the_least_force_of_all_turns() -> None:
    least = 3e3 + 10.0 * (np.linspace(24.0, 6.0, 40) - 13.0) ** 2
    found = find_adhesion(analysis(least, np.full(40, 5e3)), 24.0)
    assert (found.lift_off, found.half_width is None) == (False, False)
    assert found.adhesion == pytest.approx(0.75, abs=1e-3)
    assert found.relative_force_amplitude == pytest.approx(0.25, abs=1e-3)
    assert found.frequency_hz == pytest.approx(13.0, abs=0.3)
    assert find_adhesion(analysis(least, np.full(40, 5e3)), 12.0).frequency_hz == 12.0
    few = np.where(np.arange(40) < 3, least, np.nan)
    assert find_adhesion(analysis(few, np.full(40, 5e3)), 24.0) is None
    hop = find_adhesion(analysis(least, np.full(40, 9e3), lifted=np.arange(40) == 20), 24.0)
    assert (hop.adhesion, hop.lift_off, hop.half_width) == (0.0, True, None)
    assert hop.relative_force_amplitude == pytest.approx(1.25)


def test_lift_off_and_the_stretches_between() -> None:
    force = np.full(5000, 4e3)
    force[2000:2020] = 30.0  # what noise and drift leave of nothing: below 1 % of the load
    force[3000:3004] = 0.0  # 4 ms: the mean over 9 ms stays
    found = find_lift_off(force, 4e3, 1000.0)
    assert np.flatnonzero(found).tolist() == list(range(2004, 2016))
    assert stretches_between(found, 0, 5000, 1000.0) == [(0, 1944), (2075, 5000)]
    assert stretches_between(found, 1200, 2800, 1000.0) == []
    assert stretches_between(found, 1144, 2875, 1000.0) == [(1144, 1944), (2075, 2875)]
    assert stretches_between(np.zeros(5000, dtype=bool), 100, 300, 1000.0) == [(100, 300)]


def test_curves_reach_over_both_of_their_ends() -> None:
    frequency = np.linspace(6.0, 18.0, 13)
    curve = FrequencyCurve(frequency, (frequency - 10.3) ** 2, np.full(13, 0.5))
    at = np.array([5.9, 6.0, 9.5, 18.0, 18.1])
    np.testing.assert_allclose(curve.at(at, np.full(5, -1.0)), [-1.0, 4.3**2, 0.8**2, 7.7**2, -1.0])
    few = FrequencyCurve(frequency[:7], curve.value[:7], curve.error[:7])
    assert few.at(at, np.full(5, -1.0)).tolist() == [-1.0] * 5
    assert curve.lowest() == pytest.approx((10.0, 0.09, 0.5))
    assert curve.least(6.0, 18.0) == pytest.approx((10.3, 0.0, 0.5), abs=0.02)
    assert curve.least(12.0, 18.0) == pytest.approx((12.0, 1.7**2, 0.5))
    assert curve.least(5.9, 18.0) is curve.least(6.0, 18.1) is None
    rising = FrequencyCurve(frequency, np.exp(0.5 * (frequency - 6.0)), curve.error)
    assert rising.least(6.0, 18.0)[:2] == pytest.approx((6.0, 1.0), rel=1e-12)
    assert FrequencyCurve(frequency, rising.value[::-1], curve.error).least(6.0, 18.0)[
        1
    ] == pytest.approx(1.0, rel=1e-12)


def test_the_greatest_movement_and_what_noise_makes_of_it() -> None:
    """Of a plate at 9 Hz; the noise is that of third differences, of which the motion has next to nothing."""
    time = np.arange(4000) / 1000.0
    height = (
        5e-3 * np.sin(2.0 * np.pi * 9.0 * time) * (1.0 + 0.2 * np.exp(-(((time - 2.0) / 0.2) ** 2)))
    )
    noisy = height + 2e-5 * np.random.default_rng(3).standard_normal(time.size)
    turns = find_turns(time, noisy, 0.0, 5e-3)
    signals = WheelSignals("left", time, np.full(time.size, 4e3), noisy, None, 4e3, 20.0)
    found = methods.find_boge(
        WheelTest(signals, Sweep(turns, 0, 1, slice(0, 2), 0.0), 4e3, THETA, None)
    )
    assert found.amplitude == pytest.approx(12e-3, rel=0.02)
    assert found.frequency_hz == pytest.approx(9.0, rel=1e-2)
    assert found.half_width == pytest.approx(1.96 * 2e-5 * math.sqrt(2.0), rel=0.1)


def test_what_a_calibration_leaves_for_each_hz() -> None:
    time = np.arange(12_000) / 1000.0
    frequency = np.linspace(25.0, 3.0, time.size)
    angle = (
        2.0
        * np.pi
        * np.concatenate([[0.0], np.cumsum(0.5 * (frequency[1:] + frequency[:-1]) / 1000.0)])
    )
    residual = 0.3 * frequency * np.sin(angle + 0.7)
    found = _residual_per_hz(time, 3e-3 * np.sin(angle), residual, EGEA, "left.plate.z")
    beside = 1.0 / (
        4.0 * np.pi * 6.0 * 0.5
    )  # half seconds hold no whole turns: at 6 Hz that is worth so much
    assert 0.3 <= found <= 0.3 * (1.0 + beside)


def test_stretches_begin_and_end_half() -> None:
    """Trapezoidal sums: the first sample stands for the last one, too."""
    time = np.arange(1001) / 1000.0
    height, force = 1e-3 * time + 2e-3 * np.sin(9.0 * time), 50.0 * time**2
    found = stretch_of(height, force, 1000.0, 2.0, 5.0)
    assert found.samples == 1000
    hz = np.arange(2.0, 6.0)
    np.testing.assert_allclose(found.s, 2j * np.pi * hz)
    for values, bins in ((height, found.height), (force, found.force)):
        about, share = values - values.mean(), np.ones(1001)
        share[[0, -1]] = 0.5
        waves = np.exp(-2j * np.pi * np.outer(hz, time))
        np.testing.assert_allclose(bins, waves @ (share * about), rtol=1e-9)


def phases(angle: np.ndarray, frequency: np.ndarray, *, fit=None, lifted=None) -> Analysis:
    """Turns whose force is lowest at given phase angles (degrees) after their tops."""
    tops = np.cumsum(1.0 / frequency)
    rows = np.full((frequency.size, 7), np.nan)
    rows[:, 3], rows[:, 4], rows[:, 6] = (
        tops + angle / (360.0 * frequency) + one for one in (-0.01, 0.03, 0.0)
    )
    rows[:, 3] -= 0.02
    rows[:, 6] = 500.0
    modelled = np.full_like(rows, np.nan)
    if fit is not None:
        own = np.degrees(phase_angle(quarter_car.force_response(fit.corner, frequency)))
        modelled[:, 3] = modelled[:, 4] = tops + own / (360.0 * frequency)
        modelled[:, 6] = 500.0
    off = np.zeros(frequency.size, dtype=bool) if lifted is None else lifted
    return Analysis(4e3, fit, tops, frequency, frequency, rows, modelled, off, 3e-3)


FALLING = np.linspace(23.95, 3.05, 210)


def test_the_least_phase_angle_within_a_band() -> None:
    found, angles = methods.find_phase_minimum(
        phases(40.0 + 0.5 * (FALLING - 10.0) ** 2, FALLING), (6.0, 18.0)
    )
    assert (found.angle_deg, found.frequency_hz) == pytest.approx((40.0, 10.0), abs=0.15)
    assert (found.at_end, found.in_lift_off) == (False, False)
    for slope, end in ((3.0, 6.0), (-3.0, 18.0)):
        found, _ = methods.find_phase_minimum(
            phases(90.0 + slope * (FALLING - 12.0), FALLING), (6.0, 18.0)
        )
        assert (found.frequency_hz, found.at_end) == (pytest.approx(end), True)
        assert found.angle_deg == pytest.approx(72.0, abs=0.1)
    rough = 60.0 + np.random.default_rng(2).standard_normal(FALLING.size)
    analysis = phases(rough, FALLING)
    _, angles = methods.find_phase_minimum(analysis, (6.0, 18.0))
    same = angles == methods.phase_angles(analysis, analysis.measured)
    np.testing.assert_array_equal(same, (FALLING <= 4.0) | (FALLING >= 20.0))
    assert methods.find_phase_minimum(phases(rough, FALLING), (2.9, 18.0))[0] is None


def test_phase_angles_of_turns_that_lift_off_are_those_of_the_fit() -> None:
    fit, sure = fitted(CAR, 0.01), fitted(CAR, 0.0)
    own = np.degrees(phase_angle(quarter_car.force_response(CAR, FALLING)))
    gone = (FALLING > 7.0) & (FALLING < 9.0)
    beyond = np.abs(FALLING - 22.0) < 0.2
    measured = np.where(gone | beyond, np.nan, own + 3.0)
    found, angles = methods.find_phase_minimum(phases(measured, FALLING, fit=fit), (6.0, 18.0))
    np.testing.assert_allclose(angles[gone], own[gone], atol=1e-6)
    np.testing.assert_allclose(angles[FALLING > 20.0], measured[FALLING > 20.0])
    assert found.angle_deg == pytest.approx(own.min(), abs=0.05)
    assert not found.in_lift_off
    hopped, angles = methods.find_phase_minimum(
        phases(own + 3.0, FALLING, fit=fit, lifted=gone), (6.0, 18.0)
    )
    np.testing.assert_allclose(angles[gone], own[gone], atol=1e-6)
    assert hopped.in_lift_off
    rough = phases(own + np.random.default_rng(7).standard_normal(FALLING.size), FALLING, fit=fit)
    loose, _ = methods.find_phase_minimum(rough, (6.0, 18.0))
    firm, _ = methods.find_phase_minimum(Analysis(**{**vars(rough), "fit": sure}), (6.0, 18.0))
    spread = math.degrees(fit.spread_at(loose.frequency_hz, phase_angle))
    assert loose.half_width_deg == pytest.approx(
        math.hypot(firm.half_width_deg, 1.96 * spread), rel=1e-3
    )


def test_the_interval_of_adhesion_holds_that_of_the_fit() -> None:
    least = 3e3 + 10.0 * (np.linspace(24.0, 6.0, 40) - 13.0) ** 2
    fit = fitted(CAR, 0.01)
    one, sure = (analysis(least, np.full(40, 5e3), fit=each) for each in (fit, fitted(CAR, 0.0)))
    for each in (one, sure):
        each.modelled[:, 0] = least + 20.0 * np.random.default_rng(1).standard_normal(40)
    loose, firm = find_adhesion(one, 24.0), find_adhesion(sure, 24.0)
    spread = fit.spread_at(loose.frequency_hz, np.abs) * 3e-3 / 4e3
    assert loose.half_width == pytest.approx(math.hypot(firm.half_width, 1.96 * spread), rel=1e-3)
    for share, amplitude in (
        (0.02, 0.98),
        (0.005, 0.8),
        (-0.02, 0.8),
    ):  # next to nothing: the greatest force counts
        found = find_adhesion(analysis(least - (0.75 - share) * 4e3, np.full(40, 7.2e3)), 24.0)
        assert found.adhesion == pytest.approx(max(share, 0.0), abs=1e-3)
        assert found.relative_force_amplitude == pytest.approx(amplitude, abs=1e-3)
        assert found.lift_off is (share < 0.0)


def test_half_power_between_turns() -> None:
    frequency = np.array([4.0, 1.0, 7.0, 2.0, 6.0, 3.0, 5.0])
    amplitude = np.array([1.0, 0.2, 0.2, 0.4, 0.4, 0.6, 0.6])
    level = math.sqrt(0.5)
    width = (4.0 + (1.0 - level) / 0.4) - (3.0 + (level - 0.6) / 0.4)
    assert methods.half_power(frequency, amplitude) == pytest.approx(width / 8.0)
    assert methods.half_power(frequency[frequency > 3.5], amplitude[frequency > 3.5]) is None
    assert methods.half_power(frequency[frequency < 4.5], amplitude[frequency < 4.5]) is None


def test_damping_by_amplification_is_that_of_the_rig() -> None:
    spring, damper = THETA.plate_spring_rate, THETA.plate_damping_coefficient or 0.0
    critical = 2.0 * math.sqrt((CAR.spring_rate + CAR.tyre_stiffness) * CAR.unsprung_mass)
    for share, known in ((0.011, True), (0.1, True), (0.15, True), (0.0095, False)):
        car = LinearQuarterCar(**{**vars(CAR), "damping_coefficient": share * critical})
        gain = float(methods.plate_gain(car, THETA, np.linspace(1.5, 15.0, 541)).max())
        found = methods.theta_by_amplification(gain, CAR, THETA)
        expected = wheel_damping(quarter_car.rig_poles(car, THETA.plate_mass, spring, damper))[0]
        assert found == (pytest.approx(expected, rel=1e-4) if known else None)
    assert methods.theta_by_amplification(0.0, CAR, THETA) is None
    steady = quarter_car.force_response(CAR, [9.0])[0]
    w = 2.0 * math.pi * 9.0
    push = spring + 1j * w * damper
    gain = abs(push / (push + steady - THETA.plate_mass * w**2))
    assert methods.plate_gain(CAR, THETA, np.array([9.0]))[0] == pytest.approx(gain)


@pytest.mark.parametrize(
    ("places", "sizes", "kept"),
    [
        ([100, 200, 300, 400, 500], [16.0, -8.0, 4.0, -2.0, 1.0], 5),
        ([200, 281, 400, 500], [8.0, 4.0, -2.0, 1.0], 3),
        ([200, 279, 400, 500], [-8.0, 4.0, -2.0, 1.0], 2),
        ([200, 319, 400, 500], [8.0, 4.0, -2.0, 1.0], 3),
        ([200, 321, 400, 500], [8.0, 4.0, -2.0, 1.0], 2),
        ([300, 400, 500], [-4.0, -2.0, 1.0], 2),
        ([300, 400, 500], [2.0, -2.0, 1.0], 2),
        ([300, 400, 500], [2.0 * 2.0**1.59, -2.0, 1.0], 3),
        ([300, 400, 500], [2.0 * 2.0**1.61, -2.0, 1.0], 2),
        ([300, 400, 500], [2.0 * 2.0**0.41, -2.0, 1.0], 3),
        ([300, 400, 500], [2.0 * 2.0**0.39, -2.0, 1.0], 2),
        ([], [], 0),
    ],
)
def test_which_turning_points_are_those_of_a_decay(places, sizes, kept) -> None:
    away = np.zeros(600)
    away[places] = sizes
    found = methods._even_turns(np.array(places, dtype=int), away)
    assert found.tolist() == places[len(places) - kept :]


@pytest.mark.parametrize(
    ("ratio", "known"), [(0.03, True), (0.1, True), (0.34, True), (0.4, False)]
)
def test_free_decays_of_other_rates_and_rests(ratio: float, known: bool) -> None:
    """Four turning points above half a per cent are needed."""
    for rate in (500.0, 1000.0, 2000.0):
        away = np.arange(round(12.0 * rate)) / rate
        height = 2e-3 + 5e-3 * np.exp(-ratio * 40.0 * away) * np.cos(
            40.0 * math.sqrt(1.0 - ratio**2) * away
        )
        found = methods.theta_by_decay(height, rate)
        expected = (ratio, 40.0 * math.sqrt(1.0 - ratio**2) / (2.0 * math.pi))
        assert found == (pytest.approx(expected, rel=0.04) if known else None)
    hum = np.where(
        away > 9.0, 4e-5 * np.sin(2.0 * np.pi * 10.0 * away), 0.0
    )  # below four times its deviation
    assert methods.theta_by_decay(height + hum, rate) == (
        pytest.approx(expected, rel=0.05) if ratio < 0.3 else None
    )
    noisy = height + 1e-4 * np.random.default_rng(1).standard_normal(height.size)
    assert methods.theta_by_decay(noisy[: round(0.05 * rate)], rate) is None


def let_go(fourth: float, rate: float = 1000.0) -> np.ndarray:
    """A plate that is let go after half a second; its fourth turning point has a share of where it began."""
    growth = -0.25 * math.log(fourth) / math.pi
    away = np.maximum(np.arange(round(12.0 * rate)) / rate - 0.5, 0.0)
    return (
        5e-3 * np.exp(-growth * 40.0 * away) * (np.cos(40.0 * away) + growth * np.sin(40.0 * away))
    )


@pytest.mark.parametrize(("fourth", "known"), [(0.00518, True), (0.00482, False)])
def test_turning_points_below_half_a_per_cent_do_not_count(fourth: float, known: bool) -> None:
    found = methods.theta_by_decay(let_go(fourth), 1000.0)
    assert (found is not None) is known
    if found is not None:
        slope = -0.25 * math.log(fourth)
        assert found[0] == pytest.approx(slope / math.hypot(math.pi, slope), rel=0.02)
        assert found[1] == pytest.approx(40.0 / (2.0 * math.pi), rel=0.02)


@pytest.mark.parametrize(("times", "known"), [(3.96, True), (4.04, False)])
def test_turning_points_within_what_is_left_do_not_count(times: float, known: bool) -> None:
    """Four standard deviations of what moves in the last tenth of a second, whose mean over 5 ms is taken."""
    time = np.arange(12_000) / 1000.0
    hum = np.where(time > 9.0, math.sqrt(2.0) * np.cos(2.0 * np.pi * 10.0 * (time - time[-1])), 0.0)
    height = let_go(0.03) + 5e-3 * 0.03 / 4.0 * times / 4.0 / np.sinc(0.05) * hum
    assert (methods.theta_by_decay(height, 1000.0) is not None) is known


@pytest.mark.parametrize("rate", [1000.0, 2000.0])
def test_free_decays_are_means_over_5_ms(rate: float) -> None:
    """In which 200 Hz are nothing."""
    height = let_go(0.2, rate)[round(0.55 * rate) :]  # from the fall on
    hum = 1e-3 * np.sin(2.0 * np.pi * 200.0 * np.arange(height.size) / rate)
    assert methods.theta_by_decay(height + hum, rate) == pytest.approx(
        methods.theta_by_decay(height, rate), rel=1e-3
    )
    slow = let_go(0.2, 250.0)[138:]  # of which 5 ms are one sample
    jumps = 1e-3 * (-1.0) ** np.arange(slow.size)
    assert methods.theta_by_decay(slow + jumps, 250.0) is None


def test_strokes_of_turns() -> None:
    time = np.arange(3000) / 1000.0
    height = (1e-3 + 1e-3 * time) * np.sin(2.0 * np.pi * 8.0 * time)
    turns = find_turns(time, height, 0.0, 3e-3)
    found = methods.stroke_by_turn(height, time, turns)
    np.testing.assert_allclose(
        found[:-1], 2.0 * (1e-3 + 1e-3 * (turns.top[:-1] + 1.0 / 32.0)), rtol=0.02
    )
    assert found.size == turns.top.size
    assert methods.stroke_by_turn(None, time, turns) is None


@pytest.mark.parametrize(
    ("sample", "hit"), [(949, False), (950, True), (1119, True), (1120, False)]
)
def test_samples_that_belong_to_a_turn(sample: int, hit: bool) -> None:
    flags = np.zeros(3000, dtype=bool)
    flags[sample] = True
    args = (np.array([1.5, 2.9]), np.array([10.0, 10.0]), 1000.0, 0.5)
    assert turn_forces._turns_hit(flags, *args).tolist() == [hit, False]


def test_frequencies_at_which_a_wheel_swings_on_by_itself() -> None:
    dead = LinearQuarterCar(400.0, 40.0, 25e3, 0.0, 200e3, 0.0)
    own = wheel_damping(road_poles(dead))[1]
    for frequency, swings in ((2.49, True), (2.51, False), (0.81 * own, True), (0.79 * own, False),
                              (1.19 * own, True), (1.21 * own, False)):  # fmt: skip
        assert turn_forces._is_own(frequency, dead) is swings
        assert turn_forces._is_own(frequency, CAR) is False
    ratio = (
        wheel_damping(road_poles(LinearQuarterCar(400.0, 40.0, 25e3, 300.0, 200e3, 0.0)))[0] / 300.0
    )
    for share, swings in ((0.95, True), (1.05, False)):
        assert (
            turn_forces._is_own(
                2.0, LinearQuarterCar(400.0, 40.0, 25e3, share * 0.05 / ratio, 200e3, 0.0)
            )
            is swings
        )


@pytest.mark.parametrize(
    ("line", "others", "explained", "codes"),
    [
        (19_900.0, 1.0, 0.971, []),
        (20_100.0, 1.0, 0.971, ["vibrates"]),
        (30_000.0, 2_490.0, 0.971, ["vibrates"]),
        (30_000.0, 2_510.0, 0.971, []),
        (1.0, 1.0, 0.969, ["poor_fit"]),
    ],
)
def test_what_a_fit_leaves_is_told(line, others, explained, codes) -> None:
    """40 N in one line of 1000 samples are 1 % of the load."""
    signals, _ = held(25.0, 30)
    left = np.full(30, others, dtype=complex)
    left[13] = 1j * line
    stretch = quarter_car.Stretch(2j * np.pi * np.arange(1.0, 31.0), left, left, 1000)
    fit = ResponseFit(CAR, np.eye(6), 1.0, explained)
    found = turn_forces._doubts(fit, [stretch], [left], signals, 4e3)
    assert [one.code for one in found] == codes
    for one in found:
        words = (
            {"frequency": 14.0, "force": 2e-3 * line}
            if one.code == "vibrates"
            else {"percent": 96.9}
        )
        assert one.words == pytest.approx(words)


def test_turns_of_one_frequency_are_averaged() -> None:
    f, y, base, wide = np.array(
        [[10.0, 10.01, 10.2], [1.0, 3.0, 7.0], [2.0, 6.0, 1.0], [1.0, 2.0, 3.0]]
    )
    found = turn_forces._merge_turns(f, y, base, wide)
    expected = [[10.005, 10.2], [2.0, 7.0], [4.0, 1.0], [math.sqrt(5.0) / 2.0, 3.0]]
    np.testing.assert_allclose(np.array(found), expected)


def test_noise_of_turns_is_what_jumps() -> None:
    draw = np.random.default_rng(4).standard_normal(4000)
    wide = np.linspace(1.0, 3.0, 4000)
    assert turn_forces._noise(5.0 * wide * draw + 40.0 * wide, wide) == pytest.approx(5.0, rel=0.05)
    assert turn_forces._noise(np.arange(9.0), np.full(9, 2.0)) == pytest.approx(4e-9)


def test_what_a_model_misses_is_a_gaussian_process() -> None:
    """The same as by its kernel, of the size that is likeliest among those that are tried."""
    frequency = np.linspace(5.0, 19.0, 120)
    noise = np.linspace(1.0, 2.0, 120)
    gap = 12.0 * np.sin(0.6 * frequency) + noise * np.random.default_rng(3).standard_normal(120)
    found, error = turn_forces._posterior(frequency, gap, noise, 2.0)
    kernel = np.exp(-0.5 * ((frequency[:, None] - frequency) / 2.0) ** 2)
    size = 5.0 * float(np.median(noise))
    gain = np.linalg.solve(size**2 * kernel + np.diag(noise**2), size**2 * kernel).T
    np.testing.assert_allclose(found, gain @ gap, atol=0.3)
    np.testing.assert_allclose(
        error, np.sqrt(np.diag(size**2 * kernel - gain @ (size**2 * kernel))), rtol=0.15
    )
    none, error = turn_forces._posterior(
        frequency, gap - 12.0 * np.sin(0.6 * frequency), noise, 2.0
    )
    assert not none.any()
    assert not error.any()
