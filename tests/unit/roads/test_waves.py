"""Waves, sweeps, and the obstacles with rounded edges or cosine ramps."""

from __future__ import annotations

import math

import numpy as np
import pytest

from jounce.core.errors import DescriptionError
from jounce.core.segments import CIRCLE
from jounce.roads import Kerb, Pothole, Ramp, Sine, SineSweep, Step, Trapezoid, Trial, swept_sine


def test_a_sine_holds_its_heights_at_both_ends() -> None:
    road = Sine(amplitude="10 mm", wavelength="2 m", length="5 m", start="1 m", phase="90 deg")
    x = np.linspace(1.0, 5.999, 400)
    np.testing.assert_allclose(
        road.height_at(x), 0.01 * np.cos(np.pi * (x - 1.0)), rtol=0, atol=1e-14
    )
    assert road.height_at([0.0, 7.0]) == pytest.approx([0.01, -0.01], abs=1e-15)
    assert road.segments(9.0).edges.tolist() == [0.0, 1.0, 6.0, 9.0]


@pytest.mark.parametrize("law", ["linear", "logarithmic"])
@pytest.mark.parametrize(("first", "last"), [(10.0, 0.5), (0.5, 10.0), (2.0, 2.0)])
def test_sweep_follows_the_integral_of_its_frequency(law, first, last) -> None:
    road = SineSweep(
        amplitude=0.005, first_wavelength=first, last_wavelength=last, length=60, start=2, law=law
    )
    x = np.linspace(0.0, 59.99, 5000)
    a, b, share = 1.0 / first, 1.0 / last, x / 60.0
    if law == "linear":
        cycles = 60.0 * (a * share + 0.5 * (b - a) * share**2)
    elif a == b:
        cycles = a * x
    else:
        cycles = 60.0 * a * ((b / a) ** share - 1.0) / math.log(b / a)
    np.testing.assert_allclose(
        road.height_at(2 + x), 0.005 * np.sin(2 * np.pi * cycles), rtol=0, atol=5e-9
    )
    n = a + (b - a) * share if law == "linear" else a * (b / a) ** share
    slope = 0.005 * 2 * np.pi * n * np.cos(2 * np.pi * cycles)
    np.testing.assert_allclose(road.slope_at(2 + x), slope, rtol=0, atol=1e-4 * np.abs(slope).max())
    assert road.end() == pytest.approx(62.0, abs=1e-12)


@pytest.mark.parametrize("law", ["linear", "logarithmic"])
def test_a_sweep_in_time_is_an_excitation(law) -> None:
    shaker = swept_sine("2 mm", "1 Hz", "20 Hz", "8 s", law=law)
    trial = Trial(excitation=shaker)
    t = np.linspace(0.01, 7.99, 4000)
    cycles = (
        8 * (t / 8 + 9.5 * (t / 8) ** 2)
        if law == "linear"
        else 8 * (20 ** (t / 8) - 1) / math.log(20)
    )
    height = trial.segments().evaluate(t)[0]
    np.testing.assert_allclose(height, 0.002 * np.sin(2 * np.pi * cycles), rtol=0, atol=2e-7)
    assert trial.duration == 8.0


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (("2 s", 1, 2, 3), "amplitude: wrong unit"),
        ((1e-3, 0, 2, 3), "first_frequency: out of range; found 0; allowed: above 0 Hz"),
        ((1e-3, 1, "-2 Hz", 3), "last_frequency: out of range"),
        ((1e-3, 1, 2, 0), "duration: out of range"),
        ((1e-3, 1, 2, 1e6), "too many waves"),
    ],
)
def test_refuses_sweeps_in_time(arguments, says) -> None:
    with pytest.raises(DescriptionError, match=says):
        swept_sine(*arguments)
    with pytest.raises(DescriptionError, match="unknown law"):
        swept_sine(1e-3, 1, 2, 3, law="cubic")


def test_refuses_endless_sweeps() -> None:
    with pytest.raises(DescriptionError, match="waves; allowed: up to 20000"):
        SineSweep(amplitude=0.01, first_wavelength=1, last_wavelength=0.001, length=1000)
    most = {"amplitude": 0.01, "first_wavelength": 1.0, "last_wavelength": 1.0}
    assert SineSweep(**most, length=20_000).length == 20_000
    with pytest.raises(DescriptionError, match="20001 waves"):
        SineSweep(**most, length=20_001)
    assert len(swept_sine(1e-3, 1.0, 1.0, 0.05).time) == 9  # part of a wave has eight pieces, too
    with pytest.raises(DescriptionError, match="last_wavelength: out of range"):
        SineSweep(amplitude=0.01, first_wavelength=1, last_wavelength=0, length=10)


def test_a_plateau_between_cosine_ramps() -> None:
    # paper 2 in the studies: 5 cm from 60 m to 80 m (6 s to 8 s at 10 m/s), ramps of 0.5 m at both ends
    road = Trapezoid(height="5 cm", length="20 m", ramp="0.5 m", shape="cosine", start="60 m")
    x = np.array([60.0, 60.125, 60.25, 60.5, 70.0, 79.5, 79.75, 79.875, 80.0])
    half = 0.5 * (1.0 - np.cos(np.pi * np.array([0.0, 0.25, 0.5, 1.0, 1.0, 1.0, 0.5, 0.25, 0.0])))
    np.testing.assert_allclose(road.height_at(x), 0.05 * half, rtol=0, atol=1e-15)
    np.testing.assert_allclose(road.slope_at([60.0, 60.5, 79.5, 79.999999]), 0.0, rtol=0, atol=1e-6)
    up = Ramp(height="5 cm", length="0.5 m", shape="cosine", start="60 m")
    np.testing.assert_allclose(road.height_at(x[:5]), up.height_at(x[:5]), rtol=0, atol=1e-15)
    straight = Trapezoid(height="5 cm", length="20 m", ramp="0.5 m", start="60 m")
    assert straight.shape == "linear"
    assert straight.height_at(60.125) == pytest.approx(0.0125, abs=1e-12)
    closed = Trapezoid(height="-2 cm", length="1 m", ramp="0.5 m", shape="cosine")
    assert closed.height_at([0.25, 0.5, 0.75]) == pytest.approx([-0.01, -0.02, -0.01], abs=1e-15)


@pytest.mark.parametrize("height", [0.12, -0.12])
def test_a_kerb_is_a_rounded_step(height) -> None:
    r = 0.03
    road = Kerb(height=height, edge_radius=r, start=1)
    x = np.linspace(0.0, r, 100, endpoint=False)
    if height > 0:
        expected = height - r + np.sqrt(r**2 - (r - x) ** 2)
    else:
        expected = np.sqrt(r**2 - x**2) - r
    np.testing.assert_allclose(road.height_at(1 + x), expected, rtol=0, atol=1e-12)
    assert road.height_at([0.99, 1.04]).tolist() == [0.0, height]
    assert (
        Kerb(height=height).height_at([-1, 0, 1]).tolist()
        == Step(height=height).height_at([-1, 0, 1]).tolist()
    )
    chord = road.segments(3.0).with_finite_slopes()  # an upright arc gets a short chord
    assert len(chord.kind) == len(road.segments(3.0).kind) + 1


def test_a_pothole_has_walls_and_a_bottom() -> None:
    road = Pothole(depth="80 mm", length="0.5 m", edge_radius="20 mm", start="2 m")
    assert road.height_at([1.9, 2.25, 2.6]).tolist() == [0.0, -0.08, 0.0]
    x = np.linspace(0.0, 0.25, 500, endpoint=False)
    np.testing.assert_allclose(
        road.height_at(2 + x), road.height_at(2.5 - x - 1e-15), rtol=0, atol=1e-9
    )  # symmetric
    assert road.height_at(2.01) == pytest.approx(math.sqrt(0.02**2 - 0.01**2) - 0.02, abs=1e-12)
    assert road.segments(3.0).kind.tolist().count(CIRCLE) == 2
    round_ = Pothole(depth="80 mm", length="40 mm", edge_radius="20 mm")  # two edges and no bottom
    assert round_.segments(1.0).kind.tolist().count(CIRCLE) == 2
    assert round_.height_at(0.02) == pytest.approx(-0.02, abs=1e-9)
    sharp = Pothole(depth="80 mm", length="0.5 m", start="2 m")
    assert sharp.segments(3.0).edges.tolist() == [0.0, 2.0, 2.5, 3.0]


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (
            lambda: Kerb(height=0.02, edge_radius=0.03),
            r"edge radius of 0.03 m exceeds the height 0.02 m",
        ),
        (lambda: Kerb(height=0.02, edge_radius=-0.03), "edge_radius: out of range"),
        (lambda: Pothole(depth=0.02, length=1, edge_radius=0.03), r"exceeds the depth 0.02 m"),
        (
            lambda: Pothole(depth=0.2, length=0.1, edge_radius=0.06),
            r"two edges of radius 0.06 m do not fit",
        ),
        (lambda: Pothole(depth=-0.2, length=0.1), "depth: out of range"),
        (lambda: Trapezoid(height=0.1, length=1, ramp=0.1, shape="round"), "shape: "),
    ],
)
def test_refuses_shapes(make, says) -> None:
    with pytest.raises(DescriptionError, match=says):
        make()
