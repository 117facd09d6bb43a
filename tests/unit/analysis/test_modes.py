"""Modes from records: free decays, what is said of modes that are not there, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest
from two_masses import TwoMasses

import jounce as jn
from jounce.analysis.modes import oscillating, poles_with_held_output
from jounce.core.errors import DescriptionError, RecordingError
from jounce.simulation.linear_model import linearise

TWO = TwoMasses()
SIGNALS = ["sprung.az", "unsprung.az"]


def _run(seed: int = 0, duration: float = 60.0) -> object:
    t, road, both = TWO.drive(seed, duration)
    named = {name: (both[:, k], "m/s^2", "") for k, name in enumerate(SIGNALS)}
    return jn.recording(t, {"road.z": (road, "m", ""), **named})


def _decay(noise: float, seed: int = 0) -> object:
    t = np.arange(0.0, 3.0, 0.005)
    total = np.zeros(t.size)
    for (f, z), size in zip(TWO.modes(), (1.0, 0.3), strict=True):
        w = 2.0 * np.pi * f
        total += size * np.exp(-z * w * t) * np.cos(w * np.sqrt(1.0 - z**2) * t)
    total += noise * np.random.default_rng(seed).normal(size=t.size)
    return jn.recording(t, {"sprung.z": (0.02 * total, "m", "")})


def test_a_free_decay_of_two_modes_is_found_to_its_digits() -> None:
    found = jn.fit_modes(_decay(0.0), decay=True, count=2)
    for mode, (f, z) in zip(found.modes, TWO.modes(), strict=True):
        assert mode.frequency.value == pytest.approx(f, rel=1e-4)
        assert mode.damping_ratio.value == pytest.approx(z, rel=1e-3)
        assert mode.damped_frequency == pytest.approx(f * np.sqrt(1.0 - z**2), rel=1e-3)
    assert found.kind == "decay"


def test_intervals_of_a_decay_hold_the_truth() -> None:
    inside = np.zeros(4)
    for seed in range(60):
        modes = jn.fit_modes(_decay(0.01, seed), decay=True, count=2).modes
        assert len(modes) == 2
        pairs = zip(modes, TWO.modes(), strict=True)
        inside += [
            has
            for mode, (f, z) in pairs
            for has in (mode.frequency.has(f), mode.damping_ratio.has(z))
        ]
    assert np.all(inside >= 52)


def test_a_transfer_function_gives_body_and_wheel() -> None:
    found = jn.fit_modes(_run(), given="road.z")
    assert found.outputs == ("sprung.az", "unsprung.az")
    assert [mode.frequency.value for mode in found.modes] == pytest.approx(
        [f for f, _ in TWO.modes()], rel=0.03
    )
    assert found.modes[1].orders >= 15
    assert found.rows()[1]["frequency_low"] < TWO.modes()[1][0] < found.rows()[1]["frequency_high"]


def test_short_segments_do_not_damp_a_mode() -> None:
    """A quarter of the usual length: peaks come out wider, the poles do not."""
    light = TwoMasses(damper=200.0)
    t, road, both = light.drive(1, 120.0)
    run = jn.recording(t, {"road.z": (road, "m", ""), "unsprung.az": (both[:, 1], "m/s^2", "")})
    (_, truth) = light.modes()
    for segment in (2.0, 8.0):
        found = jn.fit_modes(
            run, "unsprung.az", "road.z", segment=segment, count=1, band=(5.0, 40.0)
        )
        assert found.modes[-1].damping_ratio.value == pytest.approx(truth[1], rel=0.03)


def test_modes_of_the_model_stand_beside_those_of_the_record() -> None:
    rig = jn.load("audi-a6-quarter-car")
    found = jn.fit_modes(_run(), given="road.z", rig=rig)
    codes = [one.code for one in found.findings]
    theirs = [mode.frequency_hz for mode in jn.modes(rig)]
    for mode in found.modes:
        assert mode.model_frequency is None or any(
            mode.model_frequency == pytest.approx(f, rel=1e-6) for f in theirs
        )
    assert (
        len([mode for mode in found.modes if mode.model_frequency])
        + codes.count("analysis.mode_not_measured")
        == 2
    )


def test_a_mode_of_the_model_outside_the_band_is_named() -> None:
    found = jn.fit_modes(
        _run(), given="road.z", rig=jn.load("audi-a6-quarter-car"), band=(4.0, 40.0)
    )
    (one,) = [one for one in found.findings if one.code == "analysis.mode_outside_band"]
    assert "is outside the band from 4 to 40 Hz" in one.message


def test_a_mode_at_the_edge_of_the_band_is_named() -> None:
    found = jn.fit_modes(_run(), given="road.z", band=(9.5, 40.0), count=1)
    assert any(one.code == "analysis.mode_at_edge" for one in found.findings)


def test_noise_has_no_modes() -> None:
    rng, t = np.random.default_rng(0), np.arange(6000) / 100.0
    run = jn.recording(
        t, {"road.z": (rng.normal(size=6000), "m", ""), "body.z": (rng.normal(size=6000), "m", "")}
    )
    found = jn.fit_modes(run, "body.z", "road.z")
    assert found.modes == ()
    (one,) = [one for one in found.findings if one.severity == "problem"]
    assert one.code == "analysis.no_mode"


def test_a_held_wheel_leaves_the_body_on_its_spring() -> None:
    rig = jn.load("audi-a6-quarter-car")
    values = rig.parameters()
    poles = poles_with_held_output(linearise(rig), "unsprung.z", "road.z")
    ((frequency, ratio),) = oscillating(poles)
    rate, damper, mass = (
        values[name] for name in ("strut.spring.rate", "strut.damper.coefficient", "sprung.mass")
    )
    assert frequency == pytest.approx(np.sqrt(rate / mass) / (2.0 * np.pi), rel=1e-6)
    assert ratio == pytest.approx(damper / (2.0 * np.sqrt(rate * mass)), rel=1e-6)


@pytest.mark.parametrize(
    ("options", "error", "words"),
    [
        ({"decay": True, "given": "road.z"}, DescriptionError, "a free decay has no input"),
        ({"outputs": "road.z", "given": "road.z"}, RecordingError, "no output"),
        (
            {"given": "road.z", "band": (10.0, 12.0)},
            RecordingError,
            "the band is too narrow for modes",
        ),
        ({"given": "road.z", "segment": "30 s"}, RecordingError, "too short for intervals"),
    ],
)
def test_what_cannot_be_fitted_is_refused(
    options: dict[str, object], error: type[Exception], words: str
) -> None:
    with pytest.raises(error, match=words):
        jn.fit_modes(_run(), **options)  # type: ignore[arg-type]
