"""What turns about an axis is fitted in words and units of its own: pendulums, rate gyros, twisted parts."""

from __future__ import annotations

import foreign_records
import numpy as np
import pytest

from jounce.core.errors import DescriptionError, FitError
from jounce.identify.decay import combine_decays, fit_decay
from jounce.identify.force_deflection import ForceDeflectionTrial
from jounce.identify.motion import (
    MOTIONS,
    QUANTITIES,
    QUANTITY_OF_UNIT,
    ROTATION,
    TRANSLATION,
    motion_of,
    order_of,
)
from jounce.identify.stiffness import fit_stiffness


def turned(kind="angle", friction=0.0):
    """Columns of a pendulum whose truth is known, made without jounce: time (s) and signal (SI)."""
    run = foreign_records.swing(
        500.0,
        4.0,
        mass=foreign_records.INERTIA,
        stiffness=foreign_records.TWIST,
        damping=foreign_records.TORQUE_DAMPING,
        friction=friction,
        start=0.2,
    )
    return run["t"], run[
        {"angle": "z", "angular_velocity": "vz", "angular_acceleration": "az"}[kind]
    ]


def told(result):
    return " | ".join(one.message for one in result.findings)


def test_each_unit_of_a_motion_has_its_quantity():
    assert {QUANTITY_OF_UNIT[unit] for motion in MOTIONS.values() for unit in motion.units} == set(
        QUANTITIES
    )
    assert [motion_of(one).name for one in QUANTITIES] == ["translation"] * 3 + ["rotation"] * 3
    assert [order_of(one) for one in QUANTITIES] == [0, 1, 2, 0, 1, 2]


@pytest.mark.parametrize("kind", ROTATION.quantities)
def test_a_pendulum_has_an_inertia_and_torques(kind):
    result = fit_decay(*turned(kind, 0.6), inertia=foreign_records.INERTIA, quantity=kind)
    assert result.damping_coefficient.value == pytest.approx(
        foreign_records.TORQUE_DAMPING, rel=0.01
    )
    assert result.coulomb_force.value == pytest.approx(0.6, rel=0.03)
    assert result.stiffness.value == pytest.approx(foreign_records.TWIST, rel=1e-3)
    assert (result.motion, result.equilibrium is None) == ("rotation", kind != "angle")
    assert "N m s/rad and 0." in told(result)
    assert "the inertia at this frequency implies a stiffness of 420 N m/rad" in told(result)
    assert " N/m" not in told(result)


def test_a_known_stiffness_of_a_rotation_is_compared():
    t, x = turned()
    stated = fit_decay(t, x, inertia="0.8 kg*m^2", stiffness="420 N*m/rad", quantity="angle")
    assert "implies a stiffness" not in told(stated)
    wrong = fit_decay(t, x, inertia="0.8 kg*m^2", stiffness="0.5 kN*m/rad", quantity="angle")
    assert "inertia and frequency give 420" in told(wrong)
    assert "check inertia, stiffness and time base" in told(wrong)
    with pytest.raises(DescriptionError, match="N/m"):
        fit_decay(t, x, inertia=0.8, stiffness="420 N/m", quantity="angle")


@pytest.mark.parametrize(
    ("quantity", "given", "words"),
    [
        (
            "angle",
            {"mass": 16.0},
            "a record of this quantity needs the inertia of the oscillating body",
        ),
        (
            "angle",
            {"mass": 16.0, "inertia": 0.8},
            ("a record of this quantity needs the inertia of the oscillating body"),
        ),
        ("angle", {}, "the inertia is not given"),
        ("angle", {"inertia": -0.8}, "the inertia is not positive"),
        (
            "velocity",
            {"inertia": 0.8},
            "a record of this quantity needs the mass of the oscillating body",
        ),
        ("velocity", {}, "the mass is not given"),
        ("velocity", {"mass": 0.0}, "the mass is not positive"),
    ],
)
def test_mass_and_inertia_are_not_exchanged(quantity, given, words):
    with pytest.raises(FitError, match=words):
        fit_decay(*turned(), quantity=quantity, **given)


def test_degrees_read_as_radians_are_told_by_their_size():
    t, x = turned()
    assert "check the unit of the record" not in told(
        fit_decay(t, x, inertia=0.8, quantity="angle")
    )
    assert "check the unit of the record" in told(
        fit_decay(t, np.degrees(x), inertia=0.8, quantity="angle")
    )
    assert "begins with 20 m and 1070 g" in told(fit_decay(t, 100.0 * x, mass=0.8))


def test_decays_of_both_kinds_do_not_combine():
    t, x = turned()
    runs = [fit_decay(t, x, inertia=0.8, quantity="angle"), fit_decay(t, x, mass=0.8)]
    assert combine_decays(runs[:1]).motion == "rotation"
    with pytest.raises(FitError, match="do not combine"):
        combine_decays(runs)


def twist(rate=5200.0, **given):
    angle = np.radians(np.concatenate([np.linspace(0.0, 8.0, 60), np.linspace(8.0, 0.0, 60)]))
    return ForceDeflectionTrial(angle, rate * angle, motion="rotation", **given)


def test_torque_over_angle_is_a_stiffness():
    result = fit_stiffness(
        [twist(), twist(5220.0)], discard_below="1 deg", operating_force="400 N*m"
    )
    assert result.motion == "rotation"
    assert result.stiffness.value == pytest.approx(5210.0, rel=1e-6)
    assert result.fitted_range[0] >= np.radians(1.0)
    assert result.tangent_stiffness.value == pytest.approx(5210.0, rel=1e-3)


@pytest.mark.parametrize(
    ("trial", "words"),
    [
        (twist(0.5), "0.5 N m/rad is implausible for a bar, bush or frame"),
        (
            ForceDeflectionTrial(30.0 * twist().deflection, twist().force, motion="rotation"),
            "angle reaches 240 deg",
        ),
        (
            ForceDeflectionTrial(-twist().deflection, twist().force, motion="rotation"),
            "in the direction of loading",
        ),
        (
            ForceDeflectionTrial(twist().deflection, 40.0 + twist().force, motion="rotation"),
            "with 40 N m, so",
        ),
    ],
)
def test_findings_of_a_twist_speak_of_angles_and_torques(trial, words):
    assert words in told(fit_stiffness(trial))
    assert " mm" not in told(fit_stiffness(trial))


def test_forces_and_torques_are_not_fitted_together():
    line = ForceDeflectionTrial(twist().deflection, twist().force)
    with pytest.raises(FitError, match="not fitted together"):
        fit_stiffness([twist(), line])
    with pytest.raises(DescriptionError, match="rotaton"):
        fit_stiffness(ForceDeflectionTrial([0.0, 1.0, 2.0], [0.0, 1.0, 2.0], motion="rotaton"))
    assert (TRANSLATION.say(0.0123), ROTATION.say(np.pi)) == ("12.3 mm", "180 deg")
