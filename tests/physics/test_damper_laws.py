"""Damper laws: slopes, energy and equivalent coefficients follow from the force, whatever the law."""

import math

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.identify.damper_laws import _DESCRIBED, LAWS
from jounce.parts.dampers import (
    BilinearDamper,
    BlowOffDamper,
    BoucWenDamper,
    ClickDamper,
    DamperLaw,
    LinearDamper,
    MapDamper,
    SampledPoint,
    TanhDamper,
    VelocityTable,
    as_damper,
    damper_laws,
)

BLOW_OFF = BlowOffDamper(
    bump_blow_off_force=300.0,
    bump_blow_off_velocity=0.1,
    bump_high_speed_coefficient=500.0,
    rebound_blow_off_force=800.0,
    rebound_blow_off_velocity=0.2,
    rebound_high_speed_coefficient=700.0,
)
LAWS_OF_VELOCITY = {
    "linear": LinearDamper(coefficient=1500.0),
    "bilinear": BilinearDamper(bump_coefficient=800.0, rebound_coefficient=2200.0),
    "blow-off": BLOW_OFF,
    "table": VelocityTable(
        velocity=(-1.0, -0.2, 0.0, 0.1, 1.0), force=(-900.0, -500.0, 0.0, 200.0, 500.0)
    ),
    "tanh": TanhDamper(coefficient=300.0, force=250.0, slope=12.0),
    "clicks": ClickDamper(
        clicks=3.0,
        measured_clicks=(0.0, 2.0, 8.0),
        velocity=(-1.0, -0.2, 0.0, 0.1, 1.0),
        force=(
            (-900.0, -500.0, 0.0, 200.0, 500.0),
            (-800.0, -400.0, 0.0, 150.0, 450.0),
            (-500.0, -200.0, 0.0, 90.0, 400.0),
        ),
    ),
}
EVERY = {
    **LAWS_OF_VELOCITY,
    "bouc-wen": BoucWenDamper(
        coefficient=250.0, hysteretic_force=180.0, rate=400.0, sigma=2.0, exponent=1.5
    ),
    "tanh with hysteresis": TanhDamper(
        coefficient=300.0,
        force=250.0,
        slope=12.0,
        displacement_coupling=-4.0,
        stiffness=900.0,
        offset=40.0,
    ),
}
SPEEDS = np.array([-1.3, -0.33, -0.15, -0.03, 0.02, 0.07, 0.45, 1.7])


def test_blow_off_is_straight_up_to_its_force_and_flatter_beyond():
    forces = BLOW_OFF.forces(np.array([-1.2, -0.2, -0.1, 0.0, 0.05, 0.1, 1.1]))
    assert forces == pytest.approx([-1500.0, -800.0, -400.0, 0.0, 150.0, 300.0, 800.0], abs=1e-12)
    assert BLOW_OFF.slopes(np.array([-1.0, -0.1, 0.05, 0.5])) == pytest.approx(
        [700.0, 4000.0, 3000.0, 500.0]
    )
    assert BLOW_OFF.slope_at_rest() == pytest.approx(3500.0)
    velocity, force = BLOW_OFF.points()
    assert velocity == pytest.approx([-1.2, -0.2, 0.0, 0.1, 1.1])
    assert force == pytest.approx([-1500.0, -800.0, 0.0, 300.0, 800.0], abs=1e-12)


def test_a_blow_off_that_never_comes_is_bilinear():
    far = BLOW_OFF.model_copy(update={"bump_blow_off_velocity": 1e3, "bump_blow_off_force": 3e6})
    bilinear = BilinearDamper(bump_coefficient=3000.0, rebound_coefficient=4000.0)
    assert far.forces(SPEEDS[3:]) == pytest.approx(bilinear.forces(SPEEDS[3:]), rel=1e-12)


@pytest.mark.parametrize("name", EVERY)
def test_slopes_are_those_of_differences(name):
    law, step = EVERY[name], 1e-6
    differences = (law.forces(SPEEDS + step, 0.01) - law.forces(SPEEDS - step, 0.01)) / (2.0 * step)
    assert law.slopes(SPEEDS, 0.01) == pytest.approx(differences, rel=1e-6)
    force, stiffness = law.at_rest(0.02)
    beside = [law.forces(0.0, 0.02 + side * step) for side in (-1.0, 1.0)]
    assert force == pytest.approx(float(law.forces(0.0, 0.02)), abs=1e-12)
    assert stiffness == pytest.approx(
        float(beside[1] - beside[0]) / (2.0 * step), rel=1e-6, abs=1e-6
    )


@pytest.mark.parametrize("name", [name for name, law in EVERY.items() if law.weights])
def test_a_force_is_the_sum_of_its_weighted_basis(name):
    law = EVERY[name]
    at = SampledPoint(lambda number: getattr(law, number), SPEEDS, 0.01)
    summed = sum(
        getattr(law, weight) * column
        for weight, column in zip(law.weights, law.basis(at), strict=True)
    )
    assert law.forces(SPEEDS, 0.01) == pytest.approx(summed, rel=1e-12)


@pytest.mark.parametrize("name", LAWS_OF_VELOCITY)
def test_the_statistical_coefficient_is_the_mean_slope(name):
    """Of a Gaussian velocity E[F v] / E[v^2] = E[dF/dv] (Stein)."""
    law, deviation = LAWS_OF_VELOCITY[name], 0.21
    z = (np.arange(-60000, 60000) + 0.5) * 1e-4
    mean = float(np.exp(-0.5 * z**2) @ law.slopes(deviation * z)) * 1e-4 / math.sqrt(2.0 * math.pi)
    assert law.statistical_coefficient(deviation) == pytest.approx(mean, rel=2e-5)


def test_the_statistical_coefficient_of_blow_off_in_closed_form():
    def share(knee: float, deviation: float) -> float:
        return 0.5 * math.erf(knee / (math.sqrt(2.0) * deviation))

    for deviation in (0.03, 0.15, 0.8):
        bump, rebound = share(0.1, deviation), share(0.2, deviation)
        expected = 3000.0 * bump + 500.0 * (0.5 - bump) + 4000.0 * rebound + 700.0 * (0.5 - rebound)
        assert BLOW_OFF.statistical_coefficient(deviation) == pytest.approx(expected, rel=1e-5)


def test_the_energy_of_blow_off_in_closed_form():
    """A side of a harmonic motion with peak speed V beyond its knee v_b = V sin(a), over half a cycle."""
    amplitude, frequency = 0.05, 2.0
    omega = 2.0 * math.pi * frequency
    peak = amplitude * omega

    def side(steep: float, flat: float, knee: float) -> float:
        a = math.asin(knee / peak)
        low = 2.0 * steep * peak**2 * (0.5 * a - 0.25 * math.sin(2.0 * a))
        rest = math.pi / 2.0 - a
        square = peak**2 * (0.5 * rest + 0.25 * math.sin(2.0 * a))
        beyond = 2.0 * (flat * square + (steep - flat) * knee * peak * math.cos(a))
        return (low + beyond) / omega

    expected = side(3000.0, 500.0, 0.1) + side(4000.0, 700.0, 0.2)
    assert jn.harmonic_energy(BLOW_OFF, amplitude, frequency) == pytest.approx(expected, rel=1e-5)


@pytest.mark.parametrize("amplitude", [1e-4, 3e-3, 0.05])
@pytest.mark.parametrize("name", EVERY)
def test_energy_is_never_negative(name, amplitude):
    law = EVERY[name]
    assert jn.harmonic_energy(law, amplitude, 1.4) > 0.0
    if not law.hysteretic:
        assert np.all(law.forces(SPEEDS) * SPEEDS > 0.0)


def test_energy_of_tables_and_of_what_is_no_law():
    assert jn.harmonic_energy({"coefficient": 900.0}, 0.02, 1.0) == pytest.approx(
        jn.harmonic_energy(LinearDamper(coefficient=900.0), 0.02, 1.0)
    )
    with pytest.raises(DescriptionError, match=r"damper law 'blow off'.*blow-off"):
        jn.harmonic_energy({"kind": "blow off"}, 0.02, 1.0)


def test_every_law_is_read_fitted_and_found_in_a_rig():
    """A new law has its rows: the union of rig files, and the laws of fits but tables, which fits do not give."""
    kinds = {law.model_fields["kind"].default for law in DamperLaw.__subclasses__()}
    tables = {VelocityTable, MapDamper, ClickDamper}
    assert set(_DESCRIBED.values()) == set(DamperLaw.__subclasses__()) - tables
    assert set(LAWS) == {*_DESCRIBED, "polynomial"}
    for law in (*EVERY.values(), *LAWS_OF_VELOCITY.values()):
        assert as_damper(law.model_dump()) == law
        rig = jn.load("kart-quarter-car").with_changes({"strut.damper": law.model_dump()})
        assert dict(damper_laws(rig)) == {"strut.damper": law}
        assert law.kind in kinds


def test_a_stationary_response_says_what_a_blow_off_damps():
    rig = jn.load("kart-quarter-car").with_changes({"strut.damper": BLOW_OFF.model_dump()})
    found = jn.stationary(rig, "C", "10 m/s")
    speed = found["strut.velocity"]
    (bent,) = (one for one in found.findings if "the curve bends" in one.message)
    assert bent.place == "strut.damper"
    assert bent.value == pytest.approx(BLOW_OFF.statistical_coefficient(speed), rel=1e-12)
    linear = jn.stationary(
        rig.with_changes({"strut.damper": {"coefficient": BLOW_OFF.slope_at_rest()}}), "C", "10 m/s"
    )
    assert found["sprung.az"] == pytest.approx(linear["sprung.az"], rel=1e-9)


def test_a_fit_finds_a_blow_off():
    t = np.arange(0.0, 6.0, 2e-3)
    x = 0.03 * np.sin(9.0 * t) + 0.01 * np.sin(23.0 * t)
    v = 0.27 * np.cos(9.0 * t) + 0.23 * np.cos(23.0 * t)
    force = BLOW_OFF.forces(v) + 120.0 + np.random.default_rng(2).normal(0.0, 8.0, t.size)
    found = jn.fit_damper(x, v, force, t, law="blow-off")
    for name in (*BlowOffDamper.weights, *BlowOffDamper.shapes):
        assert found.parameters[name].value == pytest.approx(getattr(BLOW_OFF, name), rel=0.02), (
            name
        )
    assert found.parameters["offset"].value == pytest.approx(120.0, abs=2.0)
    assert found.nrmse < 1.1 * 8.0 / np.ptp(force)
    assert as_damper(found.damper).kind == "blow-off"
    curve = jn.damper_curve(found, x, v, force, t)
    assert curve.fitted == pytest.approx(BLOW_OFF.forces(v) + 120.0, abs=12.0)


def test_a_blow_off_is_the_same_law_in_a_linkage_and_in_the_model_of_it():
    """Kinematics, modes and the lumped corner see the slope at rest of a 3-D corner."""
    rig = jn.load("reference-double-wishbone").with_changes({"strut.damper": BLOW_OFF.model_dump()})
    linear = rig.with_changes({"strut.damper": {"coefficient": BLOW_OFF.slope_at_rest()}})
    assert jn.lumped_from(rig).strut.damper == BLOW_OFF
    for one, other in zip(jn.modes(rig), jn.modes(linear), strict=True):
        assert one.damping_ratio == pytest.approx(other.damping_ratio, rel=1e-9)
    bends, straight = (
        jn.sweep_travel(each, "20 mm")["wheel_damping_coefficient"] for each in (rig, linear)
    )
    assert bends.to_numpy() == pytest.approx(straight.to_numpy(), rel=1e-9)
    slow = BLOW_OFF.mean_coefficient(0.05)
    assert slow == pytest.approx(BLOW_OFF.slope_at_rest(), rel=1e-12)


def test_runs_of_a_linkage_reduced_and_whole_agree_with_blow_off():
    rig = jn.load("reference-double-wishbone").with_changes({"strut.damper": BLOW_OFF.model_dump()})
    trial = jn.Trial(
        road=jn.HalfSine(height="30 mm", length="0.3 m"), speed="3 m/s", duration="0.6 s"
    )
    reduced, whole = (
        jn.simulate(rig, trial),
        jn.simulate(rig, trial, method="explicit", tolerance=1e-7),
    )
    assert reduced["strut.velocity"].max() > 0.1
    assert reduced["strut.velocity"].min() < -0.2
    assert (
        np.abs(reduced["sprung.az"] - whole["sprung.az"]).max()
        < 1e-5 * np.abs(whole["sprung.az"]).max()
    )
