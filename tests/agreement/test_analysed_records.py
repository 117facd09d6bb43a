"""What is analysed of a simulated lap agrees with the linear model of the same car, and says where it cannot."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

CAR = "audi-a6-quarter-car"
OUTPUTS = ["sprung.az", "unsprung.az"]


@pytest.fixture(scope="module")
def lap() -> object:
    trial = jn.iso_trial(jn.load(CAR), "C", "20 m/s", duration="120 s").trial
    return jn.simulate(CAR, trial, output_step=0.002)


def test_gain_and_phase_are_those_of_the_linear_model(lap: object) -> None:
    found = jn.estimate_transfer(lap, "sprung.az", "road.z", rig=CAR, band=(2.0, 30.0))
    assert found.model is not None
    assert np.median(found.coherence) > 0.99
    assert np.abs(found.gain / abs(found.model) - 1.0).max() < 0.04
    assert np.abs(np.angle(found.response / found.model)).max() < np.radians(3.0)


def test_modes_are_those_of_the_linear_model(lap: object) -> None:
    found = jn.fit_modes(lap, OUTPUTS, "road.z", rig=CAR)
    assert [mode.frequency.value for mode in found.modes] == pytest.approx(
        [mode.frequency_hz for mode in jn.modes(jn.load(CAR))], rel=0.01
    )
    for mode, ours in zip(found.modes, jn.modes(jn.load(CAR)), strict=True):
        assert mode.model_frequency == pytest.approx(ours.frequency_hz, rel=1e-6)
        assert mode.model_damping_ratio == pytest.approx(ours.damping_ratio, rel=1e-6)
        assert mode.damping_ratio.value == pytest.approx(ours.damping_ratio, rel=0.05)


def test_the_body_moves_as_far_as_its_acceleration_says(lap: object) -> None:
    motion = jn.integrate_acceleration(lap, "sprung.az", above=0.3)
    (body,) = motion.channels
    inside = (motion.time >= motion.valid[0]) & (motion.time <= motion.valid[1])
    truth = jn.integrate_acceleration(
        jn.recording(motion.time, {"sprung.az": (lap["sprung.az"].to_numpy(), "m/s^2", "")}),
        above=0.3,
    ).channels[0]
    assert np.array_equal(truth.displacement, body.displacement)
    moved = np.fft.rfft(lap["sprung.z"].to_numpy() - lap["sprung.z"].to_numpy().mean())
    x = (np.fft.rfftfreq(motion.time.size, 0.002) / 0.3) ** 6
    slow = np.fft.irfft(moved * x / (1.0 + x), motion.time.size)
    assert np.std((body.displacement - slow)[inside]) < 0.03 * np.std(slow[inside])


def test_lost_contact_lowers_the_coherence() -> None:
    rig = jn.load(CAR)
    gentle, harsh = (
        jn.simulate(
            rig, jn.iso_trial(rig, kind, "20 m/s", duration="60 s").trial, output_step=0.002
        )
        for kind in "AF"
    )
    assert float(gentle["tyre.force"].min()) > 0.0
    assert float((harsh["tyre.force"] == 0.0).mean()) > 0.02
    band = (2.0, 30.0)
    held, lost = (
        jn.estimate_transfer(run, "sprung.az", "road.z", band=band) for run in (gentle, harsh)
    )
    assert held.coherence.mean() > 0.98
    assert lost.coherence.mean() < held.coherence.mean() - 0.1
