"""Properties of ride metrics and spectra that hold for every signal."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from jounce.ride import comfort
from jounce.ride.spectra import power_spectrum
from jounce.ride.weighting import WEIGHTINGS, weight
from jounce.roughness.iri import iri

seeds = st.integers(0, 2**32 - 1)


@given(seed=seeds, count=st.integers(8, 400), rate=st.floats(1.0, 1e4))
def test_parseval(seed: int, count: int, rate: float) -> None:
    signal = np.random.default_rng(seed).normal(size=count)
    signal -= signal.mean()
    spectrum = power_spectrum(signal, rate, segment=count / rate, window="boxcar")
    assert spectrum.mean_square() == pytest.approx(float(np.mean(signal**2)), rel=1e-9)


@given(
    seed=seeds,
    name=st.sampled_from(sorted(WEIGHTINGS)),
    factor=st.floats(-5.0, 5.0),
    rate=st.floats(100.0, 2000.0),
)
def test_weighting_is_linear(seed: int, name: str, factor: float, rate: float) -> None:
    a, b = np.random.default_rng(seed).normal(size=(2, 500))
    both = weight(a + factor * b, rate, name)
    np.testing.assert_allclose(
        both, weight(a, rate, name) + factor * weight(b, rate, name), atol=1e-9
    )


@given(seed=seeds, shift=st.integers(1, 400))
def test_weighting_does_not_know_when_it_is(seed: int, shift: int) -> None:
    signal = np.concatenate(
        [
            np.zeros(200),
            np.random.default_rng(seed).normal(size=600) * np.hanning(600),
            np.zeros(200),
        ]
    )
    later = np.concatenate([np.zeros(shift), signal])
    np.testing.assert_allclose(
        weight(later, 500.0, "Wk")[shift:], weight(signal, 500.0, "Wk"), atol=1e-6
    )


@given(seed=seeds, factor=st.floats(1e-3, 1e3))
def test_metrics_grow_with_the_signal(seed: int, factor: float) -> None:
    signal = np.random.default_rng(seed).normal(size=3000)
    for metric in (comfort.rms, comfort.mtvv, comfort.vdv, comfort.evdv, comfort.msdv):
        assert metric(factor * signal, 1000.0) == pytest.approx(
            factor * metric(signal, 1000.0), rel=1e-9
        )
    assert comfort.crest_factor(factor * signal, 1000.0) == pytest.approx(
        comfort.crest_factor(signal, 1000.0), rel=1e-9
    )


@given(seed=seeds)
def test_order_of_the_means(seed: int) -> None:
    signal = np.random.default_rng(seed).standard_t(3, size=3000)
    mean, total = comfort.rms(signal, 1000.0), comfort.duration_of(signal, 1000.0)
    assert mean <= comfort.mtvv(signal, 1000.0) * (1.0 + 1e-9)
    assert mean * total**0.25 <= comfort.vdv(signal, 1000.0) * (1.0 + 1e-9)
    assert comfort.crest_factor(signal, 1000.0) >= 1.0


@given(
    seed=seeds,
    lift=st.floats(-1e3, 1e3),
    factor=st.floats(-3.0, 3.0),
    segment=st.floats(5.0, 300.0),
)
def test_roughness_is_homogeneous_and_knows_no_datum(
    seed: int, lift: float, factor: float, segment: float
) -> None:
    x = 0.25 * np.arange(800)
    z = 1e-3 * np.cumsum(np.random.default_rng(seed).normal(size=x.size))
    plain = iri(x, z, segment=segment)
    other = iri(x, lift + factor * z, segment=segment)
    assert other.iri_m_per_km == pytest.approx(abs(factor) * plain.iri_m_per_km, rel=1e-6, abs=1e-6)
    assert plain.segments[-1].end == x[-1]
    mean = np.average(
        [s.iri_m_per_km for s in plain.segments], weights=[s.end - s.start for s in plain.segments]
    )
    assert mean == pytest.approx(plain.iri_m_per_km, rel=0.05)
