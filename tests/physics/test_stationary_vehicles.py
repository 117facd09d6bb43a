"""Stationary responses of vehicles: delay and sides against integration over the spectrum, slopes, simulation."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError, SimulationError
from jounce.parts.vehicles import Vehicle
from jounce.ride.stationary import StationaryResponse, stationary
from jounce.roads import Iso8608
from jounce.roads.rough import BAND
from jounce.roughness.spectra import white_noise_intensity

HARD = {"front.tyre.damping_coefficient": 0.0, "rear.tyre.damping_coefficient": 0.0}
WIDE = (1e-5, 500.0)  # 1/m: nearly all waves


def undamped_tyres(name: str) -> Vehicle:
    vehicle = jn.load(name).with_changes(HARD)
    assert isinstance(vehicle, Vehicle)
    return vehicle


def compare(
    found: StationaryResponse, other: StationaryResponse, tolerance: float, nothing: float = 1e-7
) -> None:
    assert len(found.standard_deviation) > 10
    for name, value in found.standard_deviation.items():
        assert other[name] == pytest.approx(value, rel=tolerance, abs=nothing), name


def test_delay_of_the_rear_wheels_against_the_spectrum():
    vehicle = undamped_tyres("audi-a6-half-car-4dof")
    found = stationary(vehicle, "C", "15 m/s")
    compare(found, stationary(vehicle, "C", "15 m/s", band=WIDE), 5e-4)
    for name in (
        "body.az",
        "body.pitch_acceleration",
        "front.strut.deflection",
        "rear.strut.force",
    ):
        assert stationary(vehicle, "C", 15.0, band=WIDE)[name] == pytest.approx(
            found[name], rel=1e-9
        )


@pytest.mark.parametrize("sides", ["uncorrelated", "same"])
def test_sides_of_a_full_car_against_the_spectrum(sides):
    vehicle = undamped_tyres("audi-a6-full-car")
    found = stationary(vehicle, "C", 15.0, sides=sides)
    compare(found, stationary(vehicle, "C", 15.0, band=WIDE, sides=sides), 5e-4)
    assert ("body.roll" in found.absent) == (sides == "uncorrelated")
    if sides == "same":
        assert found["body.roll_acceleration"] < 1e-6 * found["body.pitch_acceleration"]


def test_cut_off_against_the_spectrum():
    vehicle = undamped_tyres("audi-a6-full-car")
    found = stationary(vehicle, "C", 15.0, cut_off=0.011)
    compare(
        found,
        stationary(vehicle, "C", 15.0, cut_off=0.011, band=(1e-6, 500.0), sides="uncorrelated"),
        5e-4,
    )
    # dz/dt = -a z + w: variance W / (2 a)
    exact = np.sqrt(white_noise_intensity("C", 15.0) / (2.0 * 2.0 * np.pi * 0.011 * 15.0))
    assert found["front_left.road.z"] == pytest.approx(exact, rel=1e-9)
    compare(
        stationary(vehicle, "C", 15.0, sides="same"),
        stationary(vehicle, "C", 15.0, cut_off=1e-7, sides="same"),
        1e-4,
        5e-5,
    )


def test_coherence_lies_between_one_road_and_two():
    vehicle = jn.load("audi-a6-full-car")
    by_sides = {
        sides: stationary(vehicle, "C", 20.0, band="iso", sides=sides)
        for sides in ("same", "isotropic", "exponential", "uncorrelated")
    }
    heave = [by_sides[sides]["body.az"] for sides in by_sides]
    roll = [by_sides[sides]["body.roll"] for sides in by_sides]
    assert heave[0] > max(heave[1:3]) > min(heave[1:3]) > heave[3]
    assert roll[0] < 1e-9 < min(roll[1:3]) < max(roll[1:3]) < roll[3]


def test_roads_of_iso_8608_have_their_heights():
    found = stationary(jn.load("audi-a6-half-car-4dof"), "A", 20.0, band=BAND)
    assert found["front.road.z"] == pytest.approx(3.806e-3, abs=5e-7)  # sqrt(G n0^2 (1/n1 - 1/n2))


@pytest.mark.parametrize("sides", ["uncorrelated", "isotropic"])
def test_slopes_are_those_of_differences(sides):
    vehicle = jn.load("audi-a6-full-car")
    paths = [
        "front.track",
        "front.distance",
        "rear.spring_rate",
        "front.anti_roll_bar_rate",
        "body.mass",
    ]
    settings = {"band": "iso"} if sides == "isotropic" else {}
    found = stationary(vehicle, "C", 20.0, sides=sides, parameters=paths, **settings)
    for path in paths:
        value = vehicle.parameters()[path]
        above, below = (
            stationary(
                vehicle.with_changes({path: value * (1 + side)}), "C", 20.0, sides=sides, **settings
            )
            for side in (1e-4, -1e-4)
        )
        assert ("front_left.strut.deflection" in found.slopes[path]) == (
            path != "front.track" or sides == "isotropic"
        )
        for name, slope in found.slopes[path].items():
            difference = (above[name] - below[name]) / (2e-4 * value)
            assert slope * value == pytest.approx(
                difference * value, rel=1e-5, abs=1e-6 * found[name]
            ), (path, name)


def test_slopes_of_a_mechanism_and_of_curves():
    for name, paths in (
        ("kart-double-wishbone", ["strut.spring.rate", "hardpoints.strut_top[1]"]),
        ("hmmwv-front-corner", ["tyre.stiffness", "sprung.mass"]),
    ):
        rig = jn.load(name)
        found = stationary(rig, "B", 3.0, band="iso", parameters=paths)
        for path in paths:
            value = rig.parameters()[path]
            above, below = (
                stationary(rig.with_changes({path: value * (1 + side)}), "B", 3.0, band="iso")
                for side in (1e-4, -1e-4)
            )
            for channel in ("sprung.az", "strut.deflection", "tyre.force"):
                difference = (above[channel] - below[channel]) / 2e-4
                slope = found.slopes[path][channel] * value
                assert slope == pytest.approx(difference, rel=1e-4, abs=1e-7 * found[channel]), (
                    name,
                    path,
                    channel,
                )


def test_nonlinear_spring_moves_its_equilibrium_with_the_mass():
    """A progressive spring is stiffer under more weight; its slope along the mass knows that."""
    curve = {"kind": "polynomial", "coefficients": [8e3, 0.0, 2e6]}
    rig = jn.QuarterCar(
        sprung={"mass": 400.0},
        unsprung={"mass": 40.0},
        strut={"spring": {"curve": curve}, "damper": {"coefficient": 1500.0}},
        tyre={"stiffness": 200e3},
    )
    found = stationary(rig, "B", 20.0, parameters=["sprung.mass"])
    above, below = (
        stationary(rig.with_changes({"sprung.mass": mass}), "B", 20.0) for mass in (400.04, 399.96)
    )
    for channel in ("sprung.az", "strut.deflection", "tyre.force"):
        slope = (above[channel] - below[channel]) / 0.08
        assert found.slopes["sprung.mass"][channel] == pytest.approx(slope, rel=1e-6)


def test_quarter_car_on_a_synthesised_road():
    rig = jn.load("kart-quarter-car").with_changes(
        {
            "sprung.mass": 400.0,
            "unsprung.mass": 40.0,
            "strut.angle": 0.0,
            "strut.spring.rate": 25e3,
            "strut.damper.coefficient": 1500.0,
            "tyre.stiffness": 200e3,
            "tyre.lift_off": False,
        }
    )
    x, height = Iso8608(
        class_="B", length=1500.0, step=0.025, seed=3, run_in=0.0
    ).points()  # one period
    x, height = np.concatenate([x, 1500.0 + x[1:12001]]), np.concatenate([height, height[1:12001]])
    road = jn.Table(x=x, height=height, interpolation="cubic")
    run = jn.simulate(rig, jn.Trial(road=road, speed=20.0, duration=90.0), output_step=2e-3)
    run = run.isel(time=slice(-37500, None))  # the last 1500 m
    found = stationary(rig, "B", 20.0, band="iso")
    for name in ("sprung.az", "strut.deflection", "tyre.force", "unsprung.az", "strut.force"):
        assert float(run[name].std()) == pytest.approx(found[name], rel=0.01), name


@pytest.mark.slow
def test_full_car_on_both_tracks_of_a_road():
    vehicle = jn.load("audi-a6-full-car")
    left = Iso8608(
        class_="B", length=6000.0, step=0.02, seed=8, interpolation="cubic", start=-20.0, track=1.54
    )
    trial = jn.Trial(road=left, right=left.other_track(), speed=20.0, duration=298.0)
    run = jn.simulate(vehicle, trial, output_step=2e-3)
    found = stationary(vehicle, "B", 20.0, band="iso", sides="isotropic")
    for name in (
        "body.az",
        "body.pitch_acceleration",
        "rear_left.strut.deflection",
        "front_right.tyre.force",
    ):
        assert float(run[name][2500:].std()) == pytest.approx(found[name], rel=0.01), name
    assert float(run["body.roll_acceleration"][2500:].std()) == pytest.approx(
        found["body.roll_acceleration"], rel=0.03
    )


def test_what_is_not_stationary_is_absent_with_its_reason():
    found = stationary(jn.load("audi-a6-full-car"), "B", 20.0)
    assert "wanders" in found.absent["body.z"]
    assert "infinite" in found.absent["front_left.tyre.force"]  # its tyre is damped
    assert "body.pitch" in found.standard_deviation  # a difference of heights is stationary
    with pytest.raises(DescriptionError, match=r"no stationary variance.*band"):
        found["body.z"]
    with pytest.raises(DescriptionError, match=r"Did you mean 'body.az'"):
        found["body.a"]


def test_findings_of_the_linear_model():
    rig = jn.load("kart-quarter-car")
    rough = [finding.place for finding in stationary(rig, "E", 3.0, band="iso").findings]
    assert "tyre.force" in rough
    assert [
        f.place for f in stationary(rig, 1e-8, 3.0, band="iso").findings if f.severity == "warning"
    ] == []
    stopped = jn.load("audi-a6-half-car-4dof").with_changes(
        {"front.bump_stop": {"gap": "0.18 m", "rate": "50 N/mm"}}
    )
    assert "front.strut.deflection" in [f.place for f in stationary(stopped, "D", 20.0).findings]
    assert "front.strut.deflection" not in [f.place for f in stationary(stopped, "A", 5.0).findings]


def test_a_bilinear_damper_counts_by_its_mean():
    rig = jn.load("kart-quarter-car").with_changes({"strut.damper.coefficient": 100.0})
    both = rig.with_changes(
        {"strut.damper": {"bump_coefficient": 50.0, "rebound_coefficient": 150.0}}
    )
    first, second = (stationary(one, "B", 3.0, band="iso") for one in (rig, both))
    assert second["sprung.az"] == pytest.approx(first["sprung.az"], rel=1e-9)


def test_the_memory_of_hysteresis_is_a_spring_at_rest():
    """Bouc-Wen: z' = rate v at z = 0, so force z adds force * rate to the stiffness; its neutral mode is left out."""
    rig = jn.load("kart-quarter-car")
    law = {
        "kind": "bouc-wen",
        "coefficient": 150.0,
        "hysteretic_force": 20.0,
        "rate": 50.0,
        "sigma": 1.0,
        "exponent": 1.5,
    }
    paths = ["strut.damper.hysteretic_force", "sprung.mass"]
    found = stationary(rig.with_changes({"strut.damper": law}), "B", 3.0, parameters=paths)
    stiffer = rig.with_changes({"strut.spring.rate": rig.strut.spring.rate + 20.0 * 50.0})
    same = stationary(stiffer, "B", 3.0, parameters=["strut.spring.rate", "sprung.mass"])
    for name in ("sprung.az", "strut.deflection", "tyre.force"):
        assert found[name] == pytest.approx(same[name], rel=1e-9)
        along = found.slopes[paths[0]][name], found.slopes["sprung.mass"][name]
        expected = 50.0 * same.slopes["strut.spring.rate"][name], same.slopes["sprung.mass"][name]
        assert along == pytest.approx(expected, rel=1e-8, abs=1e-15)
    assert paths[0] in [finding.place for finding in found.findings]


def test_a_body_that_is_free_to_turn_still_has_a_response():
    rig = jn.load("kart-whole-vehicle")
    path = "front.corner.strut.spring.rate"
    found, value = stationary(rig, "A", 3.0, band="iso", parameters=[path]), rig.parameters()[path]
    above, below = (
        stationary(rig.with_changes({path: value * (1 + side)}), "A", 3.0, band="iso")
        for side in (1e-3, -1e-3)
    )
    for name in ("body.az", "body.roll_rate", "rear_left.tyre.force"):
        assert found.slopes[path][name] * value == pytest.approx(
            (above[name] - below[name]) / 2e-3, rel=1e-3
        )


@pytest.mark.parametrize(
    ("arguments", "options", "text"),
    [
        (("Z", 20.0), {}, "unknown road class 'Z'"),
        (("C", 0.0), {}, "speed: out of range"),
        (("C", "20 km"), {}, "wrong unit"),
        ((-1.0, 20.0), {}, "invalid degree of roughness"),
        (("C", 20.0), {"band": (1.0, 0.1)}, "invalid band"),
        (("C", 20.0), {"band": 3.0}, "invalid band"),
        (("C", 20.0), {"waviness": 2.5}, "requires a frequency band"),
        (("C", 20.0), {"sides": "isotropic"}, "requires a frequency band"),
        (("C", 20.0), {"sides": "both"}, "unknown relation"),
        (("C", 20.0), {"contact_length": 0.1}, "requires a frequency band"),
        (("C", 20.0), {"contact_length": -0.1, "band": "iso"}, "at least 0 m"),
        (("C", 20.0), {"weighting": {"body.az": "Wk"}}, "requires a frequency band"),
        (("C", 20.0), {"weighting": {"body.ay": "Wk"}, "band": "iso"}, "unknown channel"),
        (("C", 20.0), {"cut_off": -1.0}, "above 0"),
        (("C", 20.0), {"cut_off": 0.01, "waviness": 1.8, "band": "iso"}, "waviness 2"),
        (("C", 20.0), {"parameters": ["front.spring"]}, "unknown parameter.*Did you mean"),
        ((lambda n: -n, 20.0), {}, "does not give densities"),
    ],
)
def test_bad_requests(arguments, options, text):
    with pytest.raises(DescriptionError, match=text):
        stationary(jn.load("audi-a6-half-car-4dof"), *arguments, **options)


def test_without_damping_nothing_is_stationary():
    rig = jn.load("kart-quarter-car").with_changes(
        {"strut.damper.coefficient": 0.0, "tyre.damping_coefficient": 0.0}
    )
    with pytest.raises(SimulationError, match="not asymptotically stable"):
        stationary(rig, "B", 3.0)


def test_spectra_enveloping_and_weighting():
    rig = jn.load("audi-a6-quarter-car")
    plain = stationary(rig, "C", 20.0, band="iso", weighting={"sprung.az": "Wk"})
    both = stationary(
        rig, "C", 20.0, band="iso", weighting={"unsprung.az": "Wd", "sprung.az": "Wk"}
    )
    assert both.weighted["sprung.az"] == pytest.approx(plain.weighted["sprung.az"], rel=1e-12)
    assert both.weighted["unsprung.az"] < 0.5 * plain["unsprung.az"]
    again = stationary(
        rig,
        lambda n: 256e-6 * (n / 0.1) ** -2.0,
        20.0,
        weighting={"sprung.az": lambda f: 0 * f + 2.0},
    )
    assert again["sprung.az"] == pytest.approx(plain["sprung.az"], rel=1e-12)
    assert again.weighted["sprung.az"] == pytest.approx(2.0 * plain["sprung.az"], rel=1e-12)
    assert 0.5 * plain["sprung.az"] < plain.weighted["sprung.az"] < plain["sprung.az"]
    enveloped = stationary(rig, "C", 20.0, band="iso", contact_length="100 mm")
    assert 0.5 < enveloped["unsprung.az"] / plain["unsprung.az"] < 0.99
    assert 0.97 < enveloped["strut.deflection"] / plain["strut.deflection"] < 1.0
