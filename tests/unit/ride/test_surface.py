"""What a linear model is driven over: numbers, choices by default, and what is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest

from jounce.core.errors import DescriptionError
from jounce.ride.surface import Surface, read_roughness, surface
from jounce.roads.rough import track_coherence

C = 256e-6  # m^3, ISO 8608 class C
N = np.array([0.02, 0.1, 0.7])


def flat(n):
    return np.full_like(n, 3e-6)


def test_white_noise_of_a_class() -> None:
    road = surface("iso:C", "72 km/h")
    assert (road.roughness, road.speed, road.band, road.sides) == (C, 20.0, None, "uncorrelated")
    assert road.intensity == pytest.approx(2.0 * math.pi**2 * 0.01 * C * 20.0, rel=1e-12)
    assert road.corner_rate is None
    np.testing.assert_allclose(road.heights(N), C * (N / 0.1) ** -2.0, rtol=1e-12)
    assert road.root_coherence(N, 1.5) is None
    assert "density" not in road.to_dict()


def test_other_spectra() -> None:
    steep = surface(C, 20.0, waviness=2.6, band="iso")
    np.testing.assert_allclose(steep.heights(N), C * (N / 0.1) ** -2.6, rtol=1e-12)
    assert steep.band == (0.011, 2.83)
    level = surface("C", 20.0, cut_off=0.01)
    np.testing.assert_allclose(level.heights(N), C * 0.01 / (N**2 + 1e-4), rtol=1e-12)
    assert level.corner_rate == pytest.approx(2.0 * math.pi * 0.01 * 20.0)
    own = surface(flat, 20.0, contact_length="200 mm")
    felt = np.sin(math.pi * N * 0.2) / (math.pi * N * 0.2)
    np.testing.assert_allclose(own.heights(N), 3e-6 * felt**2, rtol=1e-12)
    assert own.band == (0.011, 2.83)
    assert surface(flat, 20.0, band=(0.05, 1.0)).band == (0.05, 1.0)


@pytest.mark.parametrize("sides", ["isotropic", "exponential"])
def test_sides_share_the_root_of_the_coherence(sides: str) -> None:
    road = surface("C", 20.0, band="iso", sides=sides)
    expected = np.sqrt(track_coherence(N, 1.5, model=sides, waviness=2.0))
    np.testing.assert_allclose(road.root_coherence(N, 1.5), expected, rtol=1e-12)
    assert surface("C", 20.0, band="iso").sides == "isotropic"
    assert surface("C", 20.0, band="iso", sides="same").root_coherence(N, 1.5) is None


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("C", C),
        (" iso:C ", C),
        ("ISO:c", C),
        ("64e-6 m^3", 64e-6),
        ("64 cm^3", 64e-6),
        (3e-5, 3e-5),
    ],
)
def test_degrees_of_roughness(text: str | float, value: float) -> None:
    assert read_roughness(text) == pytest.approx(value, rel=1e-12)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"speed": 0.0}, "speed: out of range; found .*0.*; allowed: above 0 m/s"),
        ({"contact_length": "-1 mm"}, "contact_length: out of range; found '-1 mm'"),
        (
            {"waviness": 4.0, "band": "iso"},
            "waviness: out of range; found 4.*; allowed: above 0 and below 4",
        ),
        ({"waviness": 0.0, "band": "iso"}, "waviness: out of range; found 0"),
        ({"waviness": math.nan, "band": "iso"}, "waviness: out of range"),
        ({"cut_off": 0.0}, "cut_off: out of range; found 0.*; allowed: above 0 1/m"),
        ({"cut_off": math.inf}, "cut_off: out of range"),
        (
            {"cut_off": 0.01, "waviness": 1.9, "band": "iso"},
            "a cut-off applies only to a road of waviness 2",
        ),
        ({"road": flat, "cut_off": 0.01}, "a cut-off applies only to a road of waviness 2"),
        (
            {"waviness": 1.9},
            'waviness: this requires a frequency band; found 1.9.*Give band="iso"',
        ),
        ({"contact_length": 0.1}, "contact_length: this requires a frequency band"),
        ({"sides": "isotropic"}, "sides: this requires a frequency band"),
        ({"sides": "mirrored"}, "relation of left and right.*mirrored"),
        ({"band": (1.0, 1.0)}, "invalid band of spatial frequencies; found"),
        ({"band": (0.0, 1.0)}, "invalid band of spatial frequencies"),
        ({"band": (0.1, math.inf)}, "invalid band of spatial frequencies"),
        ({"band": ("a", "b")}, "invalid band of spatial frequencies"),
    ],
)
def test_refused(options, words) -> None:
    road, speed = options.pop("road", "C"), options.pop("speed", 20.0)
    with pytest.raises(DescriptionError, match=words):
        surface(road, speed, **options)


@pytest.mark.parametrize("wrong", [lambda n: -n, lambda n: n * math.nan, lambda n: n[:2]])
def test_a_function_that_gives_no_densities(wrong) -> None:
    with pytest.raises(
        DescriptionError, match="does not give densities; allowed: finite and at least 0"
    ):
        surface(wrong, 20.0).heights(N)
    assert surface(lambda n: 0.0 * n, 20.0).heights(N).tolist() == [0.0, 0.0, 0.0]


def test_waviness_may_be_anything_between() -> None:
    assert surface("C", 20.0, waviness=3.99, band="iso").waviness == 3.99
    assert surface("C", 20.0, waviness=0.01, band="iso").waviness == 0.01
    plain = Surface(C, None, 20.0)
    assert (plain.waviness, plain.contact_length) == (2.0, 0.0)
