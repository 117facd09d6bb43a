"""A corner linearised about rest is the lumped model that its kinematics make of it.

The two go different ways: the multibody model is linearised as a whole; the lumped one is put together from motion
ratios, rates and the motion of every body at rest. Where theory says that they are equal, they agree to rounding.
"""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.design.lumping import _damper, lump, lumped_from
from jounce.design.model_comparison import compare_models
from jounce.parts.dampers import VelocityTable
from jounce.parts.variants import with_strut_angle

KART = jn.load("kart-double-wishbone")
BUMP = jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m")
BESIDE_STRUT = {  # torsion bar, third spring and damper, Z-bar: both wheels move alike
    "torsion_bar": {"stiffness": 60.0, "preload": 3.0, "on": "lower_arm"},
    "third_spring": {
        "spring": {"rate": 2e3, "preload": 10.0},
        "damper": {"coefficient": 40.0},
        "on": "lower_arm",
    },
    "anti_roll_bar": {"stiffness": 8.0, "on": "lower_arm", "kind": "z"},
    "hardpoints.third_spring_end": [0.0, 0.12, 0.125],
    "hardpoints.arb_pivot": [-0.1, 0.1, 0.12],
    "hardpoints.arb_arm_end": [-0.02, 0.12, 0.12],
    "hardpoints.arb_link_end": [0.0, 0.2, 0.06],
}
GAS = {
    "kind": "tanh",
    "coefficient": 160.0,
    "force": 0.0,
    "slope": 1.0,
    "stiffness": 1500.0,
    "offset": 40.0,
}
RIGS = {
    "kart": KART,
    "kart, springs beside the strut": KART.with_changes(BESIDE_STRUT),
    "kart at 10 deg": with_strut_angle(KART, "10 deg"),
    "kart, heavy arms": KART.with_changes(
        {"bodies.lower_arm.mass": 3.0, "bodies.upper_arm.inertia.xx": 0.004}
    ),
    "kart, preloaded": KART.with_changes({"strut.spring.free_length": "215 mm"}),
    "reference": jn.load("reference-double-wishbone").with_changes({"guide": "vertical"}),
    "kart on its bump stop, tyre curve, on the right": KART.with_changes(
        {
            "tyre.stiffness": None,
            "tyre.curve": {"kind": "polynomial", "coefficients": [120e3, 1e6]},
            "strut.bump_stop": {"gap": "1 mm", "rate": "50 N/mm", "progression": 1e9},
            "strut.spring.free_length": "203 mm",
        }
    ).mirrored(),
    "mcpherson": jn.load("generic-mcpherson"),
    "kart, gas in its damper": KART.with_changes({"strut.damper": GAS}),
    "damped tyre": KART.with_changes({"tyre.damping_coefficient": 60.0}),
}


@pytest.mark.parametrize("name", RIGS)
@pytest.mark.some(2)
def test_modes_with_masses_rates_and_inertance_are_those_of_the_mechanism(name):
    rig = RIGS[name]
    spatial, lumped = jn.modes(rig), lump(rig).modes()
    assert len(spatial) == len(lumped) >= 1
    for one, other in zip(spatial, lumped, strict=True):
        assert other.frequency_hz == pytest.approx(one.frequency_hz, rel=1e-8)
        assert other.damping_ratio == pytest.approx(one.damping_ratio, rel=1e-7)
        for channel in ("sprung.z", "unsprung.z"):
            assert complex(*other.shape[channel]) == pytest.approx(
                complex(*one.shape[channel]), abs=1e-7
            )


def test_a_link_with_universal_joints_spins_a_little():
    """The strut's link turns about itself away from design, which the lumped model leaves out: near, not equal."""
    rig = jn.load("sedan-multi-link")
    for one, other in zip(jn.modes(rig), lump(rig).modes(), strict=True):
        assert other.frequency_hz == pytest.approx(one.frequency_hz, rel=1e-4)


def test_the_agreement_hangs_on_every_part():
    """Leave out the inertance, the preload term or the weights' rate, and the modes are others."""
    found = lump(RIGS["reference"])
    exact = found.modes()[1].frequency_hz

    def hop(**parts):
        changed = type(found)(**{**found.__dict__, **parts})
        return changed.modes()[1].frequency_hz

    still = {
        name: type(part)(part.mass, part.wheel_share, 0.0) for name, part in found.shares.items()
    }
    assert abs(hop(shares=still) / exact - 1.0) > 1e-3
    assert abs(hop(wheel_rate_preload=0.0) / exact - 1.0) > 1e-3
    assert abs(hop(wheel_rate_weight=0.0) / exact - 1.0) > 1e-6


def test_static_masses_are_the_whole_mass_and_carry_its_weight():
    for rig in RIGS.values():
        found = lump(rig)
        sprung, unsprung = found.static_masses
        whole = rig.sprung.mass + sum(body.mass for body in rig.body_masses().values())
        assert sprung + unsprung == pytest.approx(whole, rel=1e-12)
        assert jn.equilibrium(rig)["tyre.force"] == pytest.approx(whole * rig.gravity, rel=1e-8)
        # the strut carries what does not stand on the wheel: the law of the lever again
        assert found.wheel_force == pytest.approx(sprung * rig.gravity, rel=1e-6)


@pytest.mark.parametrize("name", [name for name in RIGS if name != "damped tyre"])
def test_quarter_car_has_both_natural_frequencies(name):
    dampers = [path for path in RIGS[name].parameters() if path.endswith(".damper.coefficient")]
    undamped = RIGS[name].with_changes(dict.fromkeys(dampers, 0.0))
    # curves have another slope under the lumped masses, whose sum is not quite the whole mass
    curved = undamped.tyre.curve is not None or undamped.strut.bump_stop is not None
    tolerance = 3e-4 if curved else 1e-8
    for one, other in zip(jn.modes(undamped), jn.modes(lumped_from(undamped)), strict=True):
        assert other.frequency_hz == pytest.approx(one.frequency_hz, rel=tolerance)
        assert abs(other.damping_ratio) < 1e-9


@pytest.mark.parametrize("name", RIGS)
def test_damping_ratios_of_the_quarter_car_are_near(name):
    """Masses that give the frequencies share the inertance between them: damping ratios are near, not equal."""
    for one, other in zip(jn.modes(RIGS[name]), jn.modes(lumped_from(RIGS[name])), strict=True):
        assert other.damping_ratio == pytest.approx(one.damping_ratio, rel=0.13)
        assert other.frequency_hz == pytest.approx(one.frequency_hz, rel=2e-3)


def test_a_third_damper_is_added_to_the_law_of_the_damper():
    """Force at the wheel of both: bilinear and table laws, the third damper at its own velocity, half of it here."""
    third = {"velocity": [-0.2, 0.0, 0.1, 0.3], "force": [-90.0, 0.0, 30.0, 120.0]}
    laws = {
        "strut.damper": {"bump_coefficient": 100.0, "rebound_coefficient": 220.0},
        "third_spring.damper": third,
    }
    rig = RIGS["kart, springs beside the strut"].with_changes(laws)
    found = lump(RIGS["kart, springs beside the strut"])  # ratios are those of the hardpoints
    damper = _damper(rig, found)
    assert isinstance(damper, VelocityTable)
    for velocity in (-0.5, -0.15, 0.05, 0.12, 0.6):  # m/s of the wheel
        own, other = found.damper_ratio * velocity, found.third_ratio * velocity
        strut = (100.0 if own > 0.0 else 220.0) * own
        beyond = -90.0 + 450.0 * (other + 0.2) if other < -0.2 else 120.0 + 450.0 * (other - 0.3)
        force = (
            np.interp(other, third["velocity"], third["force"]) if -0.2 <= other <= 0.3 else beyond
        )
        wanted = found.damper_ratio * strut + 0.5 * found.third_ratio * force
        ends = np.searchsorted(damper.velocity, own)
        i = min(max(ends - 1, 0), len(damper.velocity) - 2)
        (a, b), (low, high) = damper.velocity[i : i + 2], damper.force[i : i + 2]
        lumped = low + (high - low) * (own - a) / (b - a)
        assert found.damper_ratio * lumped == pytest.approx(wanted, rel=1e-9), velocity
    hysteretic = {
        "strut.damper": {"kind": "tanh", "coefficient": 100.0, "force": 20.0, "slope": "30 s/m"}
    }
    with pytest.raises(DescriptionError, match="no lumped equivalent"):
        _damper(rig.with_changes(hysteretic), found)


def test_what_is_carried_beside_the_spring_is_known_from_the_hardpoints():
    """Ratios of the levers at design are those of the kinematics; the spring is left with the rest of the weight."""
    from jounce.parts.leverage import (
        carried_beside_spring,
        static_spring_force,
        third_ratio,
        torsion_ratio,
    )

    plain = RIGS["kart, springs beside the strut"]
    gas = plain.with_changes({"strut.damper": GAS, "third_spring.damper": {**GAS, "offset": 90.0}})
    for rig in (plain, plain.mirrored(), gas):
        row = jn.sweep_travel(rig, 0.0).isel(wheel_travel=0)
        assert torsion_ratio(rig) == pytest.approx(
            float(row["torsion_bar_motion_ratio"]), rel=1e-10
        )
        assert third_ratio(rig) == pytest.approx(float(row["third_spring_motion_ratio"]), rel=1e-10)
        beside = float(row["heave_force"] - row["spring_force"] * row["motion_ratio"])
        assert carried_beside_spring(rig) == pytest.approx(beside, rel=1e-10)
        alone = static_spring_force(KART) - static_spring_force(rig)
        assert alone * float(row["motion_ratio"]) == pytest.approx(beside, rel=1e-10)


def test_a_linkage_without_arm_masses_is_a_quarter_car():
    """Parallel level arms of no mass: the upright only rises, nothing turns; then there is no inertance."""
    light = {f"bodies.{arm}.mass": 1e-6 for arm in ("lower_arm", "upper_arm")}
    light |= {
        f"bodies.{arm}.inertia.{e}": 1e-9
        for arm in ("lower_arm", "upper_arm")
        for e in ("xx", "yy", "zz")
    }
    rig = KART.with_changes(light)
    found = lump(rig)
    assert abs(found.inertance) < 1e-3 * found.static_masses[1]
    car = jn.load("kart-quarter-car").with_changes(
        {"unsprung.mass": 4.6, "strut.spring.rate": found.wheel_rate / 0.80783}
    )
    for one, other in zip(jn.modes(rig), jn.modes(car), strict=True):
        assert other.frequency_hz == pytest.approx(one.frequency_hz, rel=1e-3)
        assert other.damping_ratio == pytest.approx(one.damping_ratio, rel=3e-3)


def test_kart_and_its_lumped_prototype_can_be_compared():
    """The domain's reference: 26 deg gives a wheel rate of 18 362 N/m by cos^2; the linkage adds its preload term."""
    found = compare_models(KART, jn.load("kart-quarter-car"))
    rows = {row.quantity: row for row in found.rows}
    assert rows["motion ratio at rest"].spatial == pytest.approx(
        rows["motion ratio at rest"].lumped, rel=1e-4
    )
    assert rows["wheel rate"].lumped == pytest.approx(18362.0, abs=1.0)
    extra = rows["wheel rate"].spatial - rows["wheel rate"].lumped
    assert extra == pytest.approx(
        found.lumping.spring_force * found.lumping.motion_ratio_gradient, rel=0.02
    )
    assert 0.0 < extra / rows["wheel rate"].lumped < 0.02
    assert rows["unsprung mass"].spatial == pytest.approx(5.23, abs=0.01)
    assert rows["inertance between body and wheel"].spatial == pytest.approx(-0.2, abs=0.01)
    assert rows["body bounce, natural frequency"].spatial == pytest.approx(5.022, abs=0.002)
    assert rows["body bounce, natural frequency"].lumped == pytest.approx(5.068, abs=0.002)
    assert np.all(np.diff(found.motion_ratio) > 0.0)
    assert np.all(np.diff(found.wheel_rate) > 0.0)


def test_small_motions_are_the_same_and_large_ones_are_not():
    low = jn.Versine(
        height="0.05 mm", length="1 m", start="0.1 m"
    )  # smooth: kinks show the inertance
    trials = {
        "low": jn.Trial(road=low, speed=1.95, duration=1.0),
        "high": jn.Trial(road=BUMP, speed=1.95, duration=1.0),
    }
    found = compare_models(KART, None, trials)
    peaks = {(peak.trial, peak.channel): peak.relative for peak in found.peaks}
    assert abs(peaks["low", "sprung.az"]) < 6e-3
    lighter = sum(found.lumping.effective_masses) / sum(found.lumping.static_masses) - 1.0
    assert peaks["low", "tyre.force"] == pytest.approx(
        lighter, abs=1e-3
    )  # all but static: the masses that it carries
    assert abs(peaks["high", "sprung.az"]) > 2e-2
    assert {peak.unit for peak in found.peaks} == {"m/s^2", "N"}


def test_friction_stops_and_damper_keep_their_laws():
    rig = KART.with_changes(
        {
            "strut.friction": {"force": 5.0},
            "guide_friction": {"force": 9.0},
            "strut.damper": {"velocity": [-1.0, 0.0, 1.0], "force": [-200.0, 0.0, 120.0]},
            "strut.bump_stop": {"gap": "12 mm", "rate": "50 N/mm"},
        }
    )
    car = lumped_from(rig)
    assert (car.strut.friction, car.guide.friction) == (rig.strut.friction, rig.guide_friction)
    assert car.strut.damper == rig.strut.damper
    assert car.strut.bump_stop.gap == pytest.approx(0.012, rel=1e-9)
    rest = jn.equilibrium(car)
    assert rest["strut.deflection"] == pytest.approx(
        jn.equilibrium(rig)["strut.deflection"], abs=2e-4
    )


@pytest.mark.parametrize(
    ("rig", "message"),
    [
        (jn.load("kart-quarter-car"), "already lumped"),
        (KART.with_changes({"guide": "fixed"}), "fixed body"),
    ],
)
def test_what_cannot_be_lumped_is_refused(rig, message):
    with pytest.raises(DescriptionError, match=message):
        lumped_from(rig)


def test_models_that_are_not_a_pair_are_refused():
    with pytest.raises(DescriptionError, match="not a corner with hardpoints"):
        compare_models(jn.load("kart-quarter-car"))
    with pytest.raises(DescriptionError, match="not a quarter car"):
        compare_models(KART, KART)
