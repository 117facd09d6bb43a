"""The damping a campaign takes from free decays, on rigs whose truth is known, laws as lines and as curves."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.campaign.characterise import (
    Characterisation,
    DampingChoice,
    Replaced,
    _AtWheel,
    bench_values,
    characterise,
)
from jounce.campaign.description import Bench
from jounce.identify.estimate import Estimate
from jounce.recordings import write_recording

KART = jn.load("kart-quarter-car")
CURVES = {
    "lines": {},
    "curved spring": {
        "strut.spring": {
            "rate": None,
            "curve": {"kind": "polynomial", "coefficients": [20e3, 2e5]},
            "preload": 0.0,
        }
    },
    "curved tyre": {
        "tyre.stiffness": None,
        "tyre.curve": {"kind": "polynomial", "coefficients": [90e3, 1.2e7]},
    },
}


@pytest.mark.parametrize("support", ["tyre", "blocked"])
@pytest.mark.parametrize("name", CURVES)
def test_damping_of_the_strut_is_recovered(tmp_path, name, support):
    """Small amplitudes, so that curves act with their tangents; the unsprung mass is neglected by the method."""
    truth = KART.with_changes({**CURVES[name], "tyre.lift_off": False, "unsprung.mass": 0.05})
    if support == "blocked":
        truth = truth.with_changes({"tyre": {"stiffness": 1e9, "lift_off": False}})
    trial = jn.Trial(road=jn.Flat(), speed="1 m/s", duration="1.5 s")
    run = jn.simulate(truth, trial, offset={"sprung.z": -1e-3}, tolerance=1e-8)
    write_recording(run[["sprung.z"]], tmp_path / "decay.csv")
    start = truth.with_changes({"strut.damper.coefficient": 100.0})
    bench = Bench(decay={"files": ["decay.csv"], "support": support})
    found, knowledge = characterise(start, bench, tmp_path)
    assert not found.failed
    assert knowledge.rig.parameters()["strut.damper.coefficient"] == pytest.approx(150.0, rel=0.02)
    assert np.isfinite(found.decay.stiffness.value)


RACER = jn.QuarterCar.from_table(
    {
        "sprung": {"mass": 62.0},
        "unsprung": {"mass": 11.0},
        "strut": {"angle": "12 deg", "spring": {"rate": 38e3}, "damper": {"coefficient": 1200.0}},
        "tyre": {"stiffness": 105e3, "damping_coefficient": 60.0},
    }
)
"""A corner of a Formula Student car: damped by 0.29 of critical, on a tyre that is only three times as stiff."""


def _released(path, coefficient: float, friction: float) -> None:
    """Record a racer's corner, pushed down by 8 mm and let go: two masses, integrated by SciPy; contact is kept."""
    from scipy.integrate import solve_ivp

    lean = np.cos(np.radians(12.0))

    def rate(_t, y):
        speed = (y[3] - y[1]) * lean
        strut = (
            38e3 * (y[2] - y[0]) * lean + coefficient * speed + friction * np.tanh(speed / 2e-3)
        ) * lean
        return [y[1], strut / 62.0, y[3], (-105e3 * y[2] - 60.0 * y[3] - strut) / 11.0]

    held = -8e-3 * 38e3 * lean**2 / (38e3 * lean**2 + 105e3)
    time = np.arange(1500) * 1e-3
    run = solve_ivp(
        rate,
        (0.0, 1.5),
        [-8e-3, 0.0, held, 0.0],
        t_eval=time,
        method="LSODA",
        rtol=1e-9,
        atol=1e-12,
    )
    noise = np.random.default_rng(3).normal(0.0, 2e-5, time.size)
    lines = [f"{t:.4f}, {1e3 * z:.5f}" for t, z in zip(time, run.y[0] + noise, strict=True)]
    path.write_text("\n".join(["time [s], sprung.z [mm]", *lines]))


@pytest.mark.parametrize(("friction", "within"), [(0.0, 0.01), (12.0, 0.25)])
def test_a_firm_damper_upon_a_soft_tyre_is_recovered(tmp_path, friction, within):
    """Referred by the deflections' share alone it came out 6 % too large; with friction, as quadratic drag, as 0."""
    _released(tmp_path / "decay.csv", 1450.0, friction)
    found, knowledge = characterise(RACER, Bench(decay={"files": ["decay.csv"]}), tmp_path)
    assert not found.failed
    assert found.decay.quadratic_drag is None
    assert knowledge.rig.parameters()["strut.damper.coefficient"] == pytest.approx(
        1450.0, rel=within
    )
    assert not [one for one in found.findings if friction == 0.0 and "check mass" in one.message]


def test_a_body_that_comes_to_rest_faster_than_any_damper_lets_it_is_told(tmp_path):
    """One mass of its own: with a coefficient of 1.9 kN s/m, where the racer's body falls with 1.7 at most."""
    rate, time = 38e3 * np.cos(np.radians(12.0)) ** 2, np.arange(800) * 1e-3
    share = 105e3 / (rate + 105e3)
    pole = np.sqrt(rate * share / 62.0) * (-0.75 + 0.66j)
    lines = [
        f"{t:.4f}, {z:.7f}" for t, z in zip(time, -8.0 * np.exp(pole * time).real, strict=True)
    ]
    (tmp_path / "decay.csv").write_text("\n".join(["time [s], sprung.z [mm]", *lines]))
    found, _ = characterise(RACER, Bench(decay={"files": ["decay.csv"]}), tmp_path)
    (used,) = [choice for choice in found.damping_choices if choice.is_used]
    by_share = 1.0 / (share * np.cos(np.radians(12.0))) ** 2
    assert used.at_strut.value == pytest.approx(used.seen.value * by_share, rel=1e-9)
    assert used.at_strut.standard_error == pytest.approx(
        used.seen.standard_error * by_share, rel=1e-9
    )
    assert [one.place for one in found.findings if "comes to rest faster" in one.message] == [
        "bench.decay"
    ]


def _pole(corner: _AtWheel, damping: float, near: complex) -> complex:
    """That eigenvalue of both masses (1/s) which is the nearest to another one."""
    ms, mu, k, kt, c = (
        corner.sprung_mass,
        corner.unsprung_mass,
        corner.wheel_rate,
        corner.tyre_rate,
        damping,
    )
    body = [-k / ms, k / ms, -c / ms, c / ms]
    wheel = [k / mu, -(k + kt) / mu, c / mu, -(c + corner.tyre_damping) / mu]
    poles = np.linalg.eigvals([[0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0], body, wheel])
    return poles[np.argmin(np.abs(poles - near))]


def _followed(corner: _AtWheel, dampings) -> np.ndarray:
    """The body's pole (1/s) while the damping grows from little, until it creeps."""
    held = corner.wheel_rate * corner.tyre_rate / (corner.wheel_rate + corner.tyre_rate)
    poles = [1j * np.sqrt(held / corner.sprung_mass)]
    for damping in dampings:
        pole = _pole(corner, damping, poles[-1])
        if abs(pole.imag) < 1e-9 * abs(pole):
            break
        poles.append(pole)
    return np.array(poles[1:])


@pytest.mark.parametrize(
    ("corner", "creeps"),
    [
        (_AtWheel(20e3, 180e3, 250.0, 35.0, 50.0, 1.0), True),
        (_AtWheel(20e3, 240e3, 250.0, 30.0, 0.0, 1.0), True),
        (_AtWheel(25e3, 300e3, 300.0, 35.0, 1000.0, 1.0), True),
        (_AtWheel(30e3, 200e3, 100.0, 20.0, 0.0, 1.0), False),
        (_AtWheel(36357.0, 105e3, 62.0, 11.0, 60.0, 1.0), False),
        (_AtWheel(30e3, 150e3, 300.0, 60.0, 0.0, 1.0), False),
    ],
)
def test_damping_is_found_up_to_the_largest_swing_and_none_beyond(corner, creeps):
    """With more damping than at the top the body falls slower, or creeps: then its swing ends at its largest."""
    dampings = np.linspace(0.0, 12e3, 4001)
    near = int(np.argmin(_followed(corner, dampings).real))
    dampings = np.append(dampings[:near], np.linspace(dampings[near], dampings[near + 1], 2001))
    poles = _followed(corner, dampings)
    top = int(np.argmin(poles.real))
    assert (top == len(poles) - 1) == creeps
    for share in (0.2, 0.5, 0.8, 0.9, 0.95, 0.97, 0.98, 0.99, 0.995, 0.999):
        at = int(np.argmin(np.abs(dampings - share * dampings[top])))
        damping = dampings[at]
        less, seen, more = (
            -2.0 * corner.sprung_mass * _pole(corner, damping * one, poles[at]).real
            for one in (1 - 1e-5, 1, 1 + 1e-5)
        )
        found = corner.damping_behind(seen)
        assert found == pytest.approx((damping, 2e-5 * damping / (more - less)), rel=1e-4)
        assert found[0] == pytest.approx(damping, rel=1e-7)
    largest = -2.0 * corner.sprung_mass * poles[top].real
    assert [corner.damping_behind(share * largest) for share in (1.001, 1.02, 1.2, 2.0)] == [
        None
    ] * 4


@pytest.mark.parametrize(("value", "known"), [(1300.0, True), (np.inf, False)])
def test_decays_of_too_few_swings_contradict_no_update(value, known):
    choice = DampingChoice(
        "logarithmic-decrement", Estimate(0.3), Estimate(800.0), Estimate(value), is_used=True
    )
    replaced = [Replaced("strut.damper.coefficient", 1000.0, value, None, "bench.decay")]
    found = bench_values(
        Characterisation(damping_choices=(choice,), replaced=replaced), RACER, None
    )
    assert [(path, one.value) for path, one in found.items()] == [
        ("strut.damper.coefficient", value)
    ] * known


@pytest.mark.parametrize("method", ["viscous-and-coulomb", "logarithmic-decrement"])
def test_the_way_to_damping_is_chosen(tmp_path, method):
    """A strut with dry friction: the decrement takes it for viscous damping; both ways are kept beside each other."""
    friction = {"guide.friction": {"force": 8.0, "regularisation_velocity": 1e-4}}
    truth = KART.with_changes({"tyre.lift_off": False, "unsprung.mass": 0.05, **friction})
    trial = jn.Trial(road=jn.Flat(), speed="1 m/s", duration="1.5 s")
    run = jn.simulate(truth, trial, offset={"sprung.z": -12e-3}, tolerance=1e-8)
    write_recording(run[["sprung.z"]], tmp_path / "decay.csv")
    bench = Bench(decay={"files": ["decay.csv"], "method": method})
    found, knowledge = characterise(truth, bench, tmp_path)
    assert not found.failed
    both = {choice.method: choice for choice in found.damping_choices}
    assert both["viscous-and-coulomb"].at_strut.value == pytest.approx(150.0, rel=0.05)
    assert both["logarithmic-decrement"].at_strut.value > 1.2 * 150.0
    used = both[method]
    assert used.is_used
    assert knowledge.rig.parameters()["strut.damper.coefficient"] == used.at_strut.value
    assert found.replaced[0].measured == used.at_strut.value
    naive = both["logarithmic-decrement"].damping_ratio.value
    assert naive == pytest.approx(
        found.decay.logarithmic_decrement.value
        / np.hypot(2 * np.pi, found.decay.logarithmic_decrement.value)
    )


@pytest.mark.parametrize(
    ("window", "works"), [({"from": "0.1 s", "to": "0.9 s"}, True), ({"from": "1.49 s"}, False)]
)
def test_a_time_window_of_a_campaign(tmp_path, window, works):
    trial = jn.Trial(road=jn.Flat(), speed="1 m/s", duration="1.5 s")
    truth = KART.with_changes({"tyre.lift_off": False, "unsprung.mass": 0.05})
    run = jn.simulate(truth, trial, offset={"sprung.z": -1e-3}, tolerance=1e-8)
    write_recording(run[["sprung.z"]], tmp_path / "decay.csv")
    found, _ = characterise(truth, Bench(decay={"files": ["decay.csv"], **window}), tmp_path)
    assert bool(found.failed) != works
    if works:
        assert found.decays[0].window[0] >= 0.1
        assert found.decays[0].window[1] <= 0.9
