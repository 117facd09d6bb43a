"""Rough roads have the spectrum, the level and the coherence that they say, estimated back from their points."""

from __future__ import annotations

import numpy as np
import pytest

from jounce.roads import Iso8608, track_coherence
from jounce.roads.rough import class_roughness
from jounce.roughness.spectra import estimate_roughness, road_psd


def estimated(road: Iso8608):
    x, z = road.points()
    whole = (x >= road.fade) & (x <= road.length - road.fade)
    return estimate_roughness(x[whole], z[whole])


@pytest.mark.parametrize(
    ("name", "waviness", "side"), [("A", 2.0, "left"), ("C", 2.0, "right"), ("E", 2.5, "left")]
)
def test_welch_gives_slope_and_level_back(name, waviness, side) -> None:
    found = [
        estimated(Iso8608(class_=name, waviness=waviness, length="3 km", seed=seed, side=side))
        for seed in range(10)
    ]
    assert np.mean([one.waviness for one in found]) == pytest.approx(
        waviness, abs=0.05
    )  # domain D1
    level = 10.0 * np.log10(np.array([one.roughness for one in found]) / class_roughness(name))
    assert np.mean(level) == pytest.approx(0.0, abs=0.5)
    assert {one.road_class for one in found} == {name}


def test_each_line_of_the_spectrum_has_its_level() -> None:
    road = Iso8608(class_="B", length="2 km", run_in=0.0, seed=3)
    z = road.points()[1][:-1]
    n = np.fft.rfftfreq(len(z), 2000.0 / len(z))
    psd = 2.0 * np.abs(np.fft.rfft(z)) ** 2 / len(z) ** 2 * 2000.0
    inside = (n > 0.02) & (n < 2.8)
    np.testing.assert_allclose(psd[inside], road_psd("B", n[inside]), rtol=1e-3)
    assert psd[n > 2.84].max() < 1e-12 * psd[inside].min()
    assert psd[n < 0.0105].max() < 1e-12


@pytest.mark.parametrize(("band", "rms"), [((0.011, 2.83), 3.806e-3), ((0.01, 10.0), 4.00e-3)])
def test_rms_height_of_class_a(band, rms) -> None:
    heights = [
        Iso8608(class_="A", length=2000, band=band, run_in=0, seed=s).points()[1].std()
        for s in range(3)
    ]
    assert heights == pytest.approx([rms] * 3, rel=1e-3)  # domain D1: 3.806 and 4.00 mm


def test_heights_are_normally_distributed() -> None:
    z = np.concatenate(
        [
            Iso8608(class_="C", length=2000, run_in=0, seed=s, step=0.2).points()[1]
            for s in range(20)
        ]
    )
    z = z / z.std()
    assert np.mean(z**3) == pytest.approx(0.0, abs=0.15)
    assert np.mean(z**4) == pytest.approx(3.0, abs=0.25)


def test_a_coarse_step_never_folds_waves_back() -> None:
    road = Iso8608(class_="C", length=2000, step=0.5, run_in=0, seed=1)  # Nyquist 1 1/m, below 2.83
    assert road.points()[1].var() == pytest.approx(1e-2 * 256e-6 * (1 / 0.011 - 1 / 1.0), rel=2e-3)


def test_the_fades_take_the_power_that_is_documented() -> None:
    whole = [
        Iso8608(class_="C", length=1000, seed=s, run_in=0).points()[1].var() for s in range(200)
    ]
    faded = [np.mean(Iso8608(class_="C", length=1000, seed=s).points()[1] ** 2) for s in range(200)]
    assert 10.0 * np.log10(np.mean(faded) / np.mean(whole)) == pytest.approx(-0.055, abs=0.012)


@pytest.mark.parametrize(("model", "track"), [("isotropic", 1.5), ("exponential", 1.2)])
def test_coherence_of_the_tracks(model, track) -> None:
    from scipy.signal import csd, welch

    cross, left, right = [], [], []
    for seed in range(25):
        road = Iso8608(class_="C", length=4000, seed=seed, run_in=0, track=track, coherence=model)
        zl, zr = (np.diff(side.points()[1]) for side in (road, road.other_track()))
        n, spectrum = csd(zl, zr, fs=20.0, nperseg=2000)
        cross.append(spectrum)
        left.append(welch(zl, fs=20.0, nperseg=2000)[1])
        right.append(welch(zr, fs=20.0, nperseg=2000)[1])
    gamma2 = np.abs(np.mean(cross, axis=0)) ** 2 / (np.mean(left, axis=0) * np.mean(right, axis=0))
    inside = (n > 0.03) & (n < 0.6)
    expected = track_coherence(n[inside], track, model=model)
    np.testing.assert_allclose(gamma2[inside], expected, rtol=0, atol=0.06)
    assert np.mean(gamma2[inside] - expected) == pytest.approx(0.0, abs=0.01)
    assert np.mean(right, axis=0)[inside] == pytest.approx(np.mean(left, axis=0)[inside], rel=0.1)
    phase = np.angle(np.mean(cross, axis=0))[(n > 0.03) & (n < 0.15)]
    assert np.abs(phase).max() < 0.1  # neither track leads


def test_linear_pieces_weaken_short_waves_as_documented() -> None:
    fields = {"class_": "C", "length": 500, "run_in": 0, "seed": 4, "band": (2.5, 2.83)}
    fine = np.linspace(0.0, 500.0, 200_001)[:-1]
    lines = Iso8608(**fields).height_at(fine)
    exact = Iso8608(**fields, interpolation="cubic", step=0.01).height_at(fine)
    n = np.fft.rfftfreq(len(fine), fine[1])
    band = (n > 2.5) & (n < 2.83)
    gain = np.abs(np.fft.rfft(lines)[band] / np.fft.rfft(exact)[band])
    np.testing.assert_allclose(gain, np.sinc(0.05 * n[band]) ** 2, rtol=2e-3)
