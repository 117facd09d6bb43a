"""Rough roads: fields, reproducibility, fades, tracks, and the benchmark without chance."""

from __future__ import annotations

import numpy as np
import pytest

from jounce.core.errors import DescriptionError, RecordingError
from jounce.roads import Iso8608, SineSum, class_roughness, load_road, read_roads, track_coherence
from jounce.roads.rough import as_roughness, height_variance
from jounce.roughness.spectra import (
    estimate_roughness,
    filtered_noise,
    road_psd,
    roughness_class,
    white_noise_intensity,
)

MEANS = {
    "A": 16,
    "B": 64,
    "C": 256,
    "D": 1024,
    "E": 4096,
    "F": 16384,
    "G": 65536,
    "H": 262144,
}  # domain D1, 1e-6 m^3


@pytest.mark.source(
    kind="published",
    of="ride and roughness",
    key="iso-8608",
    where="the geometric means of its classes",
    tolerance="the digits of the standard",
    compares="roughness of the classes A to H",
)
@pytest.mark.parametrize(("name", "mean"), MEANS.items())
def test_means_and_limits_of_the_classes(name, mean) -> None:
    assert class_roughness(name) == pytest.approx(mean * 1e-6, rel=1e-12)
    assert roughness_class(mean * 1e-6) == name
    # the limits lie at half and at twice the mean
    assert roughness_class(mean * 0.501e-6) == name
    assert roughness_class(mean * 1.999e-6) == name
    assert Iso8608(class_=name.lower(), length=100).degree_of_roughness == pytest.approx(
        mean * 1e-6, rel=1e-12
    )


def test_classes_end_at_a_and_h() -> None:
    assert (roughness_class(1e-9), roughness_class(10.0)) == ("A", "H")


@pytest.mark.source(
    kind="published",
    of="ride and roughness",
    key="iso-8608",
    where="densities at 1 rad/m of classes A and C",
    tolerance="the digits of the standard",
    compares="densities over cycles and over radians",
)
def test_density_in_cycles_and_in_radians() -> None:
    # ISO 8608 table: G_d(Omega0) of classes A and C at 1 rad/m
    n = 1.0 / (2.0 * np.pi)  # Omega = 1 rad/m
    assert road_psd("C", n) / (2.0 * np.pi) == pytest.approx(16.085e-6, rel=1e-4)
    assert road_psd("A", n) / (2.0 * np.pi) == pytest.approx(1.00531e-6, rel=1e-5)
    assert road_psd(256e-6, 0.2, waviness=3.0) == pytest.approx(256e-6 / 8, rel=1e-12)


@pytest.mark.parametrize(
    ("name", "intensity"), [("A", 6.3165e-5), ("B", 2.5266e-4), ("C", 1.0106e-3), ("D", 4.0426e-3)]
)
def test_white_noise_of_the_classes(name, intensity) -> None:
    assert white_noise_intensity(name, 20.0) == pytest.approx(
        intensity, rel=5e-5
    )  # domain D1, 20 m/s


def test_filtered_noise_has_the_density_of_the_road() -> None:
    pole, gain = filtered_noise("B", 25.0)
    f = 25.0 * np.array([0.1, 0.5, 2.0])  # Hz
    # G_z(f) = G_d(n) / v, far above the cutoff
    assert gain**2 / ((2 * np.pi * f) ** 2 + pole**2) == pytest.approx(
        road_psd("B", f / 25.0) / 25.0 / (1 + (0.011 * 25.0 / f) ** 2), rel=1e-12
    )
    frequency = np.geomspace(1e-4, 1e4, 200_001)
    variance = np.trapezoid(gain**2 / ((2 * np.pi * frequency) ** 2 + pole**2), frequency)
    assert gain**2 / (4 * pole) == pytest.approx(variance, rel=1e-3)
    for cutoff in (-0.01, 0.0, np.inf):
        with pytest.raises(DescriptionError, match="invalid spatial frequency"):
            filtered_noise("B", 25.0, cutoff=cutoff)
    with pytest.raises(DescriptionError, match="invalid speed"):
        filtered_noise("B", 0.0)


def test_the_same_seed_is_the_same_road() -> None:
    one, two = (Iso8608(class_="C", length=200, seed=5).points()[1] for _ in range(2))
    np.testing.assert_array_equal(one, two)
    other = Iso8608(class_="C", length=200, seed=6).points()[1]
    assert abs(np.corrcoef(one, other)[0, 1]) < 0.7
    # Golden: of 2026-11-21, a seed means the same road for good
    x, z = Iso8608(class_="C", length=200, seed=5, interpolation="cubic").points()
    np.testing.assert_allclose(np.interp([50.0, 100.0, 150.0], x, z), PINNED, rtol=0, atol=1e-12)


PINNED = [0.017465636538077593, 0.01840362712699727, 0.00588311546077864]


def test_a_finer_step_is_the_same_road() -> None:
    coarse = Iso8608(class_="C", length=300, step=0.1, seed=2, interpolation="cubic")
    fine = Iso8608(class_="C", length=300, step=0.02, seed=2, interpolation="cubic")
    x = np.linspace(0, 300, 5001)
    np.testing.assert_allclose(coarse.height_at(x), fine.height_at(x), rtol=0, atol=5e-5)
    np.testing.assert_allclose(coarse.slope_at(x[:-1]), fine.slope_at(x[:-1]), rtol=0, atol=2e-3)


def test_roads_scale_with_the_root_of_their_roughness() -> None:
    a, c = (Iso8608(class_=name, length=300, seed=2).points()[1] for name in "AC")
    np.testing.assert_allclose(c, 4.0 * a, rtol=0, atol=1e-15)


@pytest.mark.parametrize("interpolation", ["linear", "cubic"])
def test_begins_and_ends_level(interpolation) -> None:
    road = Iso8608(class_="D", length="300 m", start="5 m", interpolation=interpolation)
    assert road.height_at([-3.0, 0.0, 5.0, 305.0, 400.0]).tolist() == [0.0] * 5
    assert road.end() == 305.0
    assert abs(float(road.slope_at(5.0))) < 1e-3
    assert (
        abs(float(road.height_at(5.5))) < 1e-3
    )  # 0.5 m into a fade of 10 m: at most 0.6 % of the height is left
    assert road.segments(400.0).edges[[1, -2]].tolist() == [5.0, 305.0]
    whole = Iso8608(
        class_="D", length="300 m", start="5 m", interpolation=interpolation, run_in=0.0
    )
    x = np.linspace(15.0, 294.9, 3000)  # nothing is changed between the fades
    np.testing.assert_allclose(road.height_at(x), whole.height_at(x), rtol=0, atol=1e-12)
    assert abs(whole.points()[1].mean()) < 0.05


def test_behind_the_front_wheel_and_inside_the_road() -> None:
    road = Iso8608(class_="C", length=100, start="-20 m", seed=1)
    x = np.linspace(-25.0, 85.0, 2000)
    shifted = Iso8608(class_="C", length=100, seed=1).height_at(x + 20.0)
    np.testing.assert_allclose(road.height_at(x), shifted, rtol=0, atol=1e-14)
    rear = road.segments(60.0, behind=2.9)
    np.testing.assert_allclose(
        rear.evaluate(x[500:1500])[0], road.height_at(x[500:1500] - 2.9), rtol=0, atol=1e-13
    )


def test_a_belt_loop_of_rough_road() -> None:
    road = Iso8608(class_="C", length=100, recurrence=100.0)
    np.testing.assert_allclose(
        road.height_at([33.0, 133.0, 933.0]), road.height_at(33.0), rtol=0, atol=1e-14
    )


def test_the_other_track() -> None:
    left = Iso8608(class_="C", length=500, seed=1)
    right = left.other_track()
    assert right == Iso8608(class_="C", length=500, seed=1, side="right")
    assert right.other_track() == left
    narrow = Iso8608(class_="C", length=500, seed=1, side="right", track="1 mm")
    zl, zr, zn = (road.points()[1] for road in (left, right, narrow))
    np.testing.assert_allclose(
        zn, zl, rtol=0, atol=0.02 * zl.std()
    )  # tracks that lie together are one
    assert 0.5 < np.corrcoef(zl, zr)[0, 1] < 0.999  # long waves are common to both
    slopes = np.corrcoef(np.diff(zl), np.diff(zr))[0, 1]
    assert -0.1 < slopes < 0.2  # short ones are not
    assert zr.std() == pytest.approx(zl.std(), rel=0.1)


def test_plain_form_and_table_give_the_same_road() -> None:
    road = Iso8608(class_="C", length=100, side="right", band=["0.02 1/m", 2.0])
    assert Iso8608.model_validate_json(road.model_dump_json()) == road
    table = {
        "kind": "iso-8608",
        "class": "c",
        "length": "100 m",
        "side": "right",
        "band": [0.02, "2 1/m"],
    }
    assert read_roads({"rough": table})["rough"] == road


def test_roads_by_the_name_of_their_class() -> None:
    assert load_road("iso:C") == Iso8608(class_="C", length=1000)
    assert load_road("iso:b:7", length=250.0) == Iso8608(class_="B", length=250, seed=7)
    for text, says in [
        ("iso:K", r"iso:K: unknown road class 'K'; allowed: A, B"),
        ("iso:C:x", "iso:C:x: not a road class; allowed: iso:CLASS or iso:CLASS:SEED"),
        ("iso:", "unknown road class ''"),
        ("iso:C:1:2", "not a road class"),
    ]:
        with pytest.raises(DescriptionError, match=says):
            load_road(text)


@pytest.mark.parametrize(
    ("fields", "says"),
    [
        ({"length": 100}, "neither a class nor a roughness is given"),
        (
            {"length": 100, "class": "A", "roughness": 1e-6},
            "both a class and a roughness are given",
        ),
        (
            {"length": 100, "class": "I"},
            "class: unknown road class 'I'; allowed: A, B, C, D, E, F, G, H",
        ),
        ({"length": 100, "class": 3}, "class: "),
        ({"length": 100, "roughness": "256 mm"}, "roughness: wrong unit"),
        ({"length": 100, "roughness": 0}, "roughness: out of range"),
        ({"class": "C"}, "length: the key is missing"),
        ({"class": "C", "length": 0}, "length: out of range"),
        ({"class": "C", "length": 100, "step": 0}, "step: out of range"),
        ({"class": "C", "length": 100, "step": 60}, "cannot represent waves of 0.011 1/m and more"),
        (
            {"class": "C", "length": 100, "run_in": 51},
            r"two fades of 51 m do not fit into the length 100 m",
        ),
        ({"class": "C", "length": 100, "band": [2, 1]}, "band: 1 1/m is not above 2 1/m"),
        ({"class": "C", "length": 100, "seed": -1}, "seed: "),
        ({"class": "C", "length": 100, "seed": 1.5}, "seed: "),
        ({"class": "C", "length": 100, "side": "middle"}, "side: "),
        ({"class": "C", "length": 1e7, "step": 0.01}, "points; allowed: up to 20000000"),
        ({"class": "C", "length": 100, "waviness": 9}, "waviness: out of range"),
        ({"class": "C", "length": 100, "recurrence": 50}, "recurs before it ends"),
    ],
)
def test_refuses_rough_roads(fields, says) -> None:
    with pytest.raises(DescriptionError, match=says):
        Iso8608(**fields)


def test_the_benchmark_has_its_level_and_its_period() -> None:
    # domain D1: 12.81605 mm, period 5 s at 20 m/s
    road = SineSum()
    assert road.period() == 100.0
    x = np.arange(10000) * 0.01
    assert 1e3 * np.sqrt(np.mean(road.height_at(x) ** 2)) == pytest.approx(12.81605, abs=5e-6)
    i = np.arange(2, 301)
    phase = 2.0 * np.pi * np.modf(0.6180339887498949 * i)[0]
    amplitude = np.sqrt(2.0 * 256e-6 * (0.01 * i / 0.1) ** -2.0 * 0.01)
    angle = 2.0 * np.pi * 0.01 * i * np.linspace(-150.0, 250.0, 401)[:, None] + phase
    at = np.linspace(-150.0, 250.0, 401)
    np.testing.assert_allclose(
        road.height_at(at), (amplitude * np.cos(angle)).sum(axis=1), rtol=0, atol=1e-11
    )
    between = road.height_at(0.01 + 0.02 * np.arange(5000))  # halfway between the points
    exact = (
        amplitude
        * np.cos(2.0 * np.pi * 0.01 * i * (0.01 + 0.02 * np.arange(5000))[:, None] + phase)
    ).sum(axis=1)
    np.testing.assert_allclose(between, exact, rtol=0, atol=5e-7)


def test_the_benchmark_has_the_level_that_is_asked_for() -> None:
    x = np.linspace(0.0, 99.0, 50)
    default = SineSum().height_at(x)
    for fields, share in (
        ({"class_": "C"}, 1.0),
        ({"class_": "A"}, 0.25),
        ({"roughness": 64e-6}, 0.5),
    ):
        np.testing.assert_allclose(
            SineSum(**fields).height_at(x), share * default, rtol=0, atol=1e-12
        )


def test_the_waves_of_the_benchmark_meet_once_a_period() -> None:
    # frac(0.618 i) makes the phases proportional to i: a train of pulses with the spectrum of class C
    x = np.arange(10000) * 0.01
    z = SineSum().height_at(x)
    assert x[z.argmax()] == pytest.approx(100.0 * (1.0 - 0.6180339887498949), abs=0.01)
    assert z.max() == pytest.approx(0.1195, abs=1e-4)
    assert z.min() > -0.0115


def test_the_benchmark_has_no_beginning() -> None:
    road = SineSum()
    x = np.linspace(0.0, 99.0, 500)
    rear = road.segments(100.0, behind=130.0)
    np.testing.assert_allclose(rear.evaluate(x)[0], road.height_at(x + 70.0), rtol=0, atol=1e-12)
    assert (
        np.abs(np.diff(road.segments(250.0).evaluate(np.linspace(0, 249, 100_000))[0])).max() < 1e-3
    )  # no jump


@pytest.mark.parametrize(
    ("fields", "says"),
    [
        ({"recurrence": 100}, "repeats by itself"),
        ({"first": 5, "last": 4}, "last = 4 is below first = 5"),
        ({"step": 0.1}, "cannot represent waves of 0.333333 m"),
        ({"class": "A", "roughness": 1e-6}, "both a class and a roughness"),
    ],
)
def test_refuses_sums(fields, says) -> None:
    with pytest.raises(DescriptionError, match=says):
        SineSum(**fields)


def test_variance_of_a_band() -> None:
    # domain D1: rms height of class A
    assert 1e3 * height_variance(16e-6, 0.011, 2.83) ** 0.5 == pytest.approx(3.806, abs=5e-4)
    assert 1e3 * height_variance(16e-6, 0.01, 10.0) ** 0.5 == pytest.approx(4.00, abs=5e-3)
    for waviness in (1.0, 1.5, 3.0):
        n = np.geomspace(0.02, 2.0, 20001)
        integral = np.trapezoid(road_psd(1e-6, n, waviness=waviness), n)
        assert height_variance(1e-6, 0.02, 2.0, waviness) == pytest.approx(integral, rel=1e-6)


def test_coherence_of_the_models() -> None:
    n = np.array([1e-4, 0.05, 0.12, 0.5, 5.0])
    for model in ("isotropic", "exponential"):
        gamma2 = track_coherence(n, 1.5, model=model)
        assert gamma2[0] == pytest.approx(1.0, abs=2e-3)
        assert (np.diff(gamma2) < 0).all()
        assert 0.0 <= gamma2[-1] < 1e-15
    # both reach one half at n B = 0.12
    assert track_coherence(0.1211 / 1.5, 1.5) == pytest.approx(0.5, abs=1e-3)
    assert track_coherence(0.1211 / 1.5, 1.5, model="exponential") == pytest.approx(0.5, abs=2e-3)
    # w = 2 against the integral over the surface's spectrum (n^2 + m^2)^(-3/2)
    m = np.linspace(0.0, 400.0, 4_000_001)
    surface = (0.1**2 + m**2) ** -1.5
    gamma = np.trapezoid(surface * np.cos(2 * np.pi * m * 1.5), m) / np.trapezoid(surface, m)
    assert track_coherence(0.1, 1.5) == pytest.approx(gamma**2, rel=1e-4)
    # w = 3: gamma = (1 + y) exp(-y), the Bessel function of order 3/2 in closed form
    n = np.array([0.01, 0.1, 0.3])
    y = 2.0 * np.pi * n * 1.5
    assert track_coherence(n, 1.5, waviness=3.0) == pytest.approx(
        ((1.0 + y) * np.exp(-y)) ** 2, rel=1e-12
    )


@pytest.mark.parametrize(
    ("x", "z", "says"),
    [
        (np.arange(30.0), np.zeros(29), "invalid profile"),
        (np.arange(10.0), np.zeros(10), "at least 16"),
        (np.arange(30.0), np.full(30, np.nan), "NaN or infinite"),
        (np.arange(30.0)[::-1], np.zeros(30), "the distance is reversed"),
        (np.arange(30.0) ** 1.1, np.zeros(30), r"not evenly spaced; found '1 m after x = 0 m"),
        (
            np.arange(30.0) * 0.1,
            np.random.default_rng(1).normal(size=30),
            "too short or too coarse",
        ),
    ],
)
def test_refuses_profiles_without_a_spectrum(x, z, says) -> None:
    with pytest.raises(RecordingError, match=says):
        estimate_roughness(x, z)


def test_a_known_wave_has_its_power_in_the_spectrum() -> None:
    x = np.arange(0.0, 2000.0, 0.05)
    spectrum = estimate_roughness(x, 0.01 * np.sin(2 * np.pi * 0.3 * x) + 1e-5 * np.sin(7.0 * x))
    near = (spectrum.n > 0.28) & (spectrum.n < 0.32)
    power = np.sum(spectrum.psd[near]) * (spectrum.n[1] - spectrum.n[0])
    assert power == pytest.approx(0.5 * 0.01**2, rel=0.01)


def test_limits_of_points_and_waves() -> None:
    """Two points a wave of the lowest frequency, 20 million points, a quarter of the shortest wave in a sum."""
    assert Iso8608(class_="C", length=100, step=45.0).step == 45.0  # 0.5 / 0.011 = 45.5
    with pytest.raises(DescriptionError, match="points every 46 m cannot represent waves"):
        Iso8608(class_="C", length=100, step=46.0)
    assert Iso8608(class_="C", length=2e5, step=0.01).length == 2e5
    with pytest.raises(DescriptionError, match="20000001 points; allowed: up to 20000000"):
        Iso8608(class_="C", length=2e5 + 0.01, step=0.01)
    assert Iso8608(class_="C", length=100, run_in=50).fade == 50.0
    assert SineSum(step=0.0833, last=300, first=300).last == 300
    with pytest.raises(DescriptionError, match="cannot represent waves"):
        SineSum(step=0.0834)
    assert SineSum(spacing=1e-6, step=0.05).period() == 1e6
    with pytest.raises(DescriptionError, match="more than 20000000 points in one period"):
        SineSum(spacing=1e-6, step=0.0499)


def test_what_a_random_road_is_by_default() -> None:
    road = Iso8608(class_="C", length=300)
    assert (road.step, road.seed, road.waviness, road.band) == (0.05, 0, 2.0, (0.011, 2.83))
    assert (road.track, road.coherence_decay, road.fade, road.start) == (1.5, 5.7, 10.0, 0.0)
    assert Iso8608(class_="C", length=50).fade == 5.0
    assert as_roughness(3e-5) == 3e-5
    for wrong in (0.0, -1.0, np.inf):
        with pytest.raises(DescriptionError, match="invalid degree of roughness"):
            as_roughness(wrong)
