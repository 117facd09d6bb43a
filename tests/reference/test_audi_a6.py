"""The studies of paper 2's half car: every window of the cases to the printed digits.

Source: the paper's Table 2 and cases A and B with the correct sign of eq. (9), solved with DOP853 at 1e-10 and with
matrix exponentials, which agree to 1e-3 mm and mrad; printed digits, z in mm, theta in mrad. Times are those of
millisecond samples. Peak accelerations were printed with their digits cut off, not rounded.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.linalg import expm

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.papers.audi_a6 import CASES, VARIANTS, AudiCase, CaseRun, Window, run_audi_a6
from jounce.papers.audi_a6_paper import half_car_matrices

pytestmark = pytest.mark.source(
    kind="computed",
    of="half car",
    key="suspension-system",
    where="Table 2, cases A and B with the sign of eq. (9) corrected; DOP853 at 1e-10 and matrix exponentials",
    tolerance="half a unit of the last printed digit",
)

ANY = None


@cache
def study(name: str) -> AudiCase:
    return run_audi_a6(name)


def case(name: str, moment: float, variant: str) -> CaseRun:
    return next(
        run
        for run in study(name).runs
        if run.variant == variant and run.moment == pytest.approx(moment, rel=1e-12)
    )


def window(name: str, moment: float, variant: str, output: str, index: int) -> Window:
    return case(name, moment, variant).outputs[output][index]


def printed(value: float, text: str) -> bool:
    """Equal in thousandths when rounded to the digits of the text (two of them agree to 1e-3 only)."""
    digits = len(text.partition(".")[2])
    return 1e3 * value == pytest.approx(float(text), abs=0.5000001 * 10.0**-digits)


A, B = ("case-a", 100.0), ("case-b", -100.0)
HARD = ("case-a", 1636.0 * 3.0 * 0.55)
# case, variant, output, window (0: 3-6 s, 1: 6-8 s, 2: 8-10 s), least, greatest
TABLE = [
    *((A, variant, "z", 0, "-0.001", "0.029") for variant in VARIANTS),
    *((A, variant, "theta", 0, "0", "0.5670") for variant in VARIANTS),
    (A, "simulink", "z", 1, "-60.932", ANY),
    (A, "simulink", "theta", 1, "0.1071", "1.4638"),
    (A, "simulink", "z", 2, "-49.941", "10.966"),
    (A, "simulink", "theta", 2, "-0.4793", "0.8768"),
    (A, "sign-corrected", "z", 1, ANY, "60.974"),
    (A, "sign-corrected", "theta", 1, "-0.4797", "0.8770"),
    (A, "sign-corrected", "z", 2, "-10.924", "49.983"),
    (A, "sign-corrected", "theta", 2, "0.1073", "1.4634"),
    (HARD, "sign-corrected", "z", 0, "-0.033", "0.779"),
    (HARD, "sign-corrected", "theta", 0, ANY, "15.306"),
    (HARD, "sign-corrected", "z", 1, ANY, "61.522"),
    (HARD, "sign-corrected", "theta", 1, ANY, "13.667"),
    (HARD, "sign-corrected", "z", 2, "-10.375", ANY),
    (HARD, "sign-corrected", "theta", 2, ANY, "14.254"),
    (A, "physical", "z", 1, ANY, "58.090"),
    (A, "physical", "theta", 1, "-21.933", "5.854"),
    (A, "physical", "z", 2, "-8.041", ANY),
    (A, "physical", "theta", 2, "-4.870", "22.918"),
    *((B, variant, "z", 0, "-0.029", ANY) for variant in VARIANTS),
    *((B, variant, "theta", 0, "-0.5670", ANY) for variant in VARIANTS),
    (B, "simulink", "z", 1, ANY, "24.360"),
    (B, "simulink", "theta", 1, "-0.881", "-0.338"),
    (B, "simulink", "z", 2, "-4.399", ANY),
    (B, "simulink", "theta", 2, "-0.646", "-0.104"),
    (B, "sign-corrected", "z", 1, "-24.402", ANY),
    (B, "sign-corrected", "theta", 1, "-0.646", "-0.103"),
    (B, "sign-corrected", "z", 2, ANY, "4.357"),
    (B, "sign-corrected", "theta", 2, "-0.881", "-0.338"),
    (B, "physical", "z", 1, "-23.249", ANY),
    (B, "physical", "theta", 1, "-2.637", "8.478"),
    (B, "physical", "z", 2, ANY, "3.204"),
    (B, "physical", "theta", 2, "-9.462", "1.653"),
]


@pytest.mark.parametrize(("which", "variant", "output", "index", "least", "greatest"), TABLE)
def test_extremes(which, variant, output, index, least, greatest):
    found = window(*which, variant, output, index)
    assert least is ANY or printed(found.min, least)
    assert greatest is ANY or printed(found.max, greatest)


@pytest.mark.parametrize(
    ("which", "variant", "output", "index", "end", "time"),
    [
        (A, "simulink", "z", 1, "t_min", 6.451),
        (A, "sign-corrected", "z", 1, "t_max", 6.451),
        (A, "sign-corrected", "z", 2, "t_min", 8.451),
        (A, "physical", "z", 1, "t_max", 6.566),
        (A, "physical", "theta", 1, "t_min", 6.292),
        (A, "physical", "theta", 2, "t_max", 8.292),
        (HARD, "sign-corrected", "theta", 0, "t_max", 3.406),
        (B, "sign-corrected", "z", 1, "t_min", 6.451),
        (B, "physical", "z", 1, "t_min", 6.566),
    ],
)
def test_times(which, variant, output, index, end, time):
    assert getattr(window(*which, variant, output, index), end) == pytest.approx(time, abs=1.01e-3)


@pytest.mark.no_source
@pytest.mark.parametrize("name", CASES)
def test_each_moment_runs_in_every_variant(name):
    sign = CASES[name].sign
    expected = [
        (moment, variant) for moment in (100.0, 1636.0 * 3.0 * 0.55) for variant in VARIANTS
    ]
    found = [(sign * run.moment, run.variant) for run in study(name).runs]
    assert [variant for _, variant in found] == [variant for _, variant in expected]
    assert [moment for moment, _ in found] == pytest.approx(
        [moment for moment, _ in expected], rel=1e-12
    )


def test_the_window_where_pitch_settles_under_braking():
    """The static answer to 2699.4 N m: 0.492043 mrad and 0.021088 mm for each 100 N m."""
    signals = case(*HARD, "sign-corrected").signals.sel(time=6.0, method="nearest")
    assert printed(float(signals["pitch.angle"]), "13.282")
    assert 1e5 * float(signals["pitch.angle"]) / 2699.4 == pytest.approx(0.492043, abs=2e-5)
    assert 1e5 * float(signals["bounce.displacement"]) / 2699.4 == pytest.approx(0.021088, abs=1e-5)


@pytest.mark.no_source
@pytest.mark.parametrize("name", CASES)
def test_windows_hold_their_ends(name):
    """The values at 3, 6, 8 and 10 s lie within the windows they end and begin."""
    for run in study(name).runs:
        for output, channel in (("z", "bounce.displacement"), ("theta", "pitch.angle")):
            for found in run.outputs[output]:
                for time in (found.start, found.end):
                    value = float(run.signals[channel].sel(time=time, method="nearest"))
                    assert found.min - 1e-12 <= value <= found.max + 1e-12
                assert found.start <= found.t_min <= found.end
                assert found.start <= found.t_max <= found.end


@pytest.mark.parametrize("variant", ["simulink", "sign-corrected"])
def test_extremes_agree_with_matrix_exponentials(variant):
    """Everything is linear with constant input from 6 s to 8 s: sampled exactly every 0.1 ms, to 1e-4 of the range."""
    mass, damping, stiffness = half_car_matrices(study("case-a").vehicle)
    inverse = np.linalg.inv(mass)
    slope = np.block([[np.zeros((2, 2)), np.eye(2)], [-inverse @ stiffness, -inverse @ damping]])
    height = 0.05 if variant == "sign-corrected" else -0.05

    def settled(level: float) -> np.ndarray:
        load = stiffness @ np.array([level, 0.0]) + np.array([0.0, 100.0])
        return np.concatenate([np.linalg.solve(stiffness, load), np.zeros(2)])

    step = expm(1e-4 * slope)
    state, levels = -settled(0.0), []
    for target, before, count in ((0.0, None, 30000), (height, 0.0, 20000), (0.0, height, 20000)):
        if before is not None:
            state = state + settled(before) - settled(target)
        rows = [state]
        for _ in range(count):
            rows.append(step @ rows[-1])
        state = rows[-1]
        levels.append(np.array(rows) + settled(target))
    for index, rows in enumerate(levels):
        for column, output in ((0, "z"), (1, "theta")):
            found = window(*A, variant, output, index)
            values = rows[:, column]
            assert found.min == pytest.approx(values.min(), abs=1e-6 * np.ptp(values))
            assert found.max == pytest.approx(values.max(), abs=1e-6 * np.ptp(values))


def test_statics():
    for run in study("case-a").runs:
        rest = run.statics
        assert printed(rest.z, "-163.91198")
        assert printed(rest.theta, "-3.38437")
        assert rest.front.force == pytest.approx(8934.584, abs=5.1e-4)
        assert rest.rear.force == pytest.approx(7114.576, abs=5.1e-4)
        assert rest.front.force_per_wheel == pytest.approx(4467.29, abs=5.1e-3)
        assert rest.rear.force_per_wheel == pytest.approx(3557.29, abs=5.1e-3)
        assert printed(rest.front.compression, "159.546")
        assert printed(rest.rear.compression, "169.395")


def test_modes_and_the_printed_sign():
    found = study("case-a")
    assert [mode.frequency_hz for mode in found.modes] == pytest.approx(
        [1.2347, 1.4316], abs=5.1e-5
    )
    assert [mode.damping_ratio for mode in found.modes] == pytest.approx(
        [0.4370, 0.5106], abs=5.1e-5
    )
    assert found.printed.growth_rate == pytest.approx(3.570, abs=5.1e-4)
    assert found.printed.pitch_at_rest == pytest.approx(0.997, abs=5.1e-4)
    assert sorted(real for real, _ in found.printed.correct_eigenvalues) == pytest.approx(
        [-4.5929, -4.5929, -3.3903, -3.3903], abs=5.1e-5
    )
    own = np.linalg.eigvals(
        jn.linearise(found.vehicle).A
    )  # the model's, which has nothing of the printed sign
    correct = [complex(*value) for value in found.printed.correct_eigenvalues]
    assert sorted(own, key=lambda v: (v.real, v.imag)) == pytest.approx(
        sorted(correct, key=lambda v: (v.real, v.imag)), abs=1e-9
    )


def test_start_up_of_the_demo():
    found = study("case-a").start_up
    assert found.transient == pytest.approx(0.0439, abs=5.1e-5)
    assert float(found.signals["body.z"][0]) == pytest.approx(-0.12, abs=1e-12)
    assert float(found.signals["body.pitch"][0]) == pytest.approx(0.0, abs=1e-12)
    assert found.lowest < found.equilibrium < found.initial


@pytest.mark.parametrize(
    ("variant", "peak"), [("simulink", 2.995), ("sign-corrected", 2.995), ("physical", 5.953)]
)
def test_peak_acceleration(variant, peak):
    assert case(*A, variant).peak_acceleration == pytest.approx(
        peak + 5e-4, abs=5e-4
    )  # digits were cut off


@pytest.mark.no_source
def test_wheels_that_would_leave_the_road_are_reported():
    found = study("case-a")
    pulled = [run for run in found.runs if run.least_wheel_force < 0.0]
    assert {run.variant for run in pulled} == {"physical"}
    assert sum("leave the road there" in finding.message for finding in found.findings) == len(
        pulled
    )
    assert all(run.least_wheel_force > 0.0 for run in study("case-b").runs)


@pytest.mark.source(
    kind="published",
    of="half car",
    key="suspension-system",
    where="eq. (5), Tables 1 and 2, section 4: what is printed, and what its own equations give",
    tolerance="half a unit of the last printed digit",
    compares="what paper 2 prints, and what is correct",
)
def test_the_paper_beside_what_is_correct():
    errata = {erratum.place: erratum for erratum in study("case-b").errata}
    torque = errata["eq. (5)"]
    assert (torque.printed_value, torque.correct_value) == (
        pytest.approx(4201.7, abs=0.051), pytest.approx(70.03, abs=0.0051)
    )  # fmt: skip
    stiffness = errata["section 4, spring constant"]
    assert (stiffness.printed_value, stiffness.correct_value) == (
        338e3,
        pytest.approx(33728.0, abs=0.51),
    )
    result = errata["section 4, result"]
    assert result.printed_value == pytest.approx(0.0122, abs=1e-9)
    assert "factor of 10.7" in result.why
    rate = errata["section 5, front spring rate"]
    assert (rate.printed_value, rate.correct_value) == (38.0, 38e3)
    load = errata["table 1, load F"]
    assert (load.printed_value, load.correct_value) == (4512.6, pytest.approx(4467.0, abs=0.51))
    start = errata["demo, initial height"]
    assert "43.9 mm" in start.why
    assert "−0.120122 m" in start.printed
    assert "exactly the defaults" in errata["table 2, K_f and K_r"].why
    assert "THETA" in errata["conclusions, half car"].printed


@pytest.mark.no_source
def test_more_damping_is_not_more_comfort() -> None:
    """Paper 2, "the greater is damping rate, the greater is comfort": the named damping is the best, on any road."""
    best = next(
        one for one in study("case-b").errata if one.place == "Theta, comfort"
    ).correct_value
    corner = jn.load("audi-a6-quarter-car").with_changes({"tyre.damping_coefficient": 0.0})

    def acceleration(coefficient: float) -> float:
        car = corner.with_changes({"strut.damper": {"coefficient": coefficient}})
        return float(jn.stationary(car, "B", 20.0)["sprung.az"])

    assert acceleration(best) < acceleration(0.7 * best)
    assert acceleration(best) < acceleration(1.4 * best) < acceleration(3.0 * best)


@pytest.mark.no_source
def test_unknown_case():
    with pytest.raises(DescriptionError, match="case-a, case-b"):
        run_audi_a6("case-c")
