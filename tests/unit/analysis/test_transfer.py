"""Transfer functions between channels: a known system, noise at either end, and what is refused or doubted."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr
from two_masses import TwoMasses

import jounce as jn
from jounce.core.errors import DescriptionError, RecordingError


def _run(seed: int, noise: float = 0.05) -> xr.Dataset:
    t, road, both = TwoMasses().drive(seed, 60.0, noise=noise)
    signals = {
        "road.z": (road, "m", ""),
        "sprung.az": (both[:, 0], "m/s^2", ""),
        "unsprung.az": (both[:, 1], "m/s^2", ""),
    }
    return jn.recording(t, signals)


def test_a_known_system_lies_within_the_intervals() -> None:
    inside, count = 0, 0
    for seed in range(30):
        found = jn.estimate_transfer(_run(seed), "unsprung.az", "road.z", band=(3.0, 60.0))
        truth = abs(TwoMasses().response(found.frequency)[:, 1])
        low, high = found.gain_interval
        inside += int(np.count_nonzero((low <= truth) & (truth <= high)))
        count += truth.size
    assert 0.93 <= inside / count <= 0.97


def test_estimators_are_right_where_their_noise_is() -> None:
    rng = np.random.default_rng(5)
    x = rng.normal(size=200_000)
    noise = rng.normal(size=x.size)
    t = np.arange(x.size) / 100.0
    for estimator, given, output, expected in (
        ("H1", x, 2.0 * x + noise, 2.0),
        ("H2", x + 0.5 * noise, 2.0 * x, 2.0),
        ("H1", x + 0.5 * noise, 2.0 * x, 2.0 / 1.25),
        ("Hv", x + 0.5 * noise, 2.0 * x + rng.normal(size=x.size), 2.0),
    ):
        run = jn.recording(t, {"a.z": (given, "m", ""), "b.z": (output, "m", "")})
        found = jn.estimate_transfer(run, "b.z", "a.z", estimator=estimator, segment="2 s")  # type: ignore[arg-type]
        assert np.mean(found.gain) == pytest.approx(expected, rel=0.01)


@pytest.mark.parametrize("estimator", ["H1", "H2", "Hv"])
@pytest.mark.some(2)
def test_the_stated_errors_are_those_that_occur(estimator: str) -> None:
    """Scatter over 200 records against the formulas of Bendat and Piersol, of gain and of phase."""
    gains, phases, errors = [], [], []
    for seed in range(200):
        rng = np.random.default_rng(seed)
        x = rng.normal(size=4000)
        y = x + rng.normal(size=x.size)
        run = jn.recording(np.arange(x.size) / 100.0, {"a.z": (x, "m", ""), "b.z": (y, "m", "")})
        found = jn.estimate_transfer(run, "b.z", "a.z", estimator=estimator, segment="1 s")  # type: ignore[arg-type]
        gains.append(found.gain[5:45])
        phases.append(found.phase[5:45])
        errors.append((np.mean(found.gain_error[5:45]), np.mean(found.phase_error[5:45])))
    scatter = np.std(np.log(gains), axis=0).mean(), np.std(phases, axis=0).mean()
    assert scatter == pytest.approx(tuple(np.mean(errors, axis=0)), rel=0.06)


def test_unrelated_channels_are_a_problem_and_their_coherence_stays_low() -> None:
    shares = []
    for seed in range(20):
        rng = np.random.default_rng(seed)
        signals = {name: (rng.normal(size=6000), "m", "") for name in ("a.z", "b.z")}
        found = jn.estimate_transfer(jn.recording(np.arange(6000) / 100.0, signals), "b.z", "a.z")
        assert [one.severity for one in found.findings] == ["problem"]
        assert "does not follow the input anywhere" in found.findings[0].message
        shares.append(np.mean(found.coherence > found.significant))
    assert 0.03 < np.mean(shares) < 0.07


def test_a_band_without_excitation_is_named() -> None:
    from scipy import signal

    rng = np.random.default_rng(0)
    x = signal.sosfiltfilt(signal.butter(8, 10.0, fs=100.0, output="sos"), rng.normal(size=20_000))
    signals = {"a.z": (x, "m", ""), "b.z": (x + 0.01 * rng.normal(size=x.size), "m", "")}
    (one,) = jn.estimate_transfer(
        jn.recording(np.arange(x.size) / 100.0, signals), "b.z", "a.z"
    ).findings
    assert one.code == "analysis.low_coherence"
    assert "hardly excites" in one.message
    assert one.sentence("de").startswith("Die Kohärenz liegt")


@pytest.mark.parametrize(
    ("options", "error", "words"),
    [
        ({"given": "still.z"}, RecordingError, "still.z: the channel is constant"),
        ({"given": "roads.z"}, RecordingError, "no channel 'roads.z'"),
        ({"segment": "50 s"}, RecordingError, "at least two independent segments"),
        ({"estimator": "H3"}, DescriptionError, "unknown estimator"),
    ],
)
def test_what_cannot_be_estimated_is_refused(
    options: dict[str, str], error: type[Exception], words: str
) -> None:
    run = _run(0)
    run["still.z"] = run["road.z"] * 0.0
    run["still.z"].attrs = run["road.z"].attrs
    asked = {"output": "sprung.az", "given": "road.z", **options}
    with pytest.raises(error, match=words):
        jn.estimate_transfer(run, **asked)  # type: ignore[arg-type]


def test_a_peak_that_short_segments_flatten_is_named_and_longer_ones_raise_it() -> None:
    t, road, both = TwoMasses(damper=200.0).drive(0, 200.0, noise=0.001)
    run = jn.recording(t, {"road.z": (road, "m", ""), "unsprung.az": (both[:, 1], "m/s^2", "")})
    truth = abs(TwoMasses(damper=200.0).response(np.linspace(5.0, 20.0, 500))).max(axis=0)[1]
    short, long = (
        jn.estimate_transfer(run, "unsprung.az", "road.z", segment=segment, band=(2.0, 40.0))
        for segment in (1.0, 8.0)
    )
    assert [one.code for one in short.findings] == ["analysis.flat_peak"]
    assert short.gain.max() < 0.95 * truth
    assert long.findings == ()
    assert long.gain.max() == pytest.approx(truth, rel=0.03)
