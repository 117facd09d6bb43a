"""Controllers on 3-D suspensions: the corner they are designed for, and what they do there."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.control import Skyhook
from jounce.simulation.corner_models import corner_models

KART = "kart-double-wishbone"
TRIAL = jn.Trial(
    road=jn.HalfSine(height="5 mm", length="300 mm", start="0.3 m"), speed="3 m/s", duration="1.5 s"
)


def test_the_corner_of_a_linkage_is_the_quarter_car_it_amounts_to() -> None:
    corner = corner_models(jn.load(KART))[""]
    at_rest = jn.sweep_travel(jn.load(KART), "-1 mm:1 mm:1 mm").sel(wheel_travel=0.0)
    load = jn.equilibrium(jn.load(KART))["tyre.force"]
    assert (corner.sprung_mass + corner.unsprung_mass) * 9.81 == pytest.approx(load, rel=1e-9)
    assert corner.tyre_stiffness == pytest.approx(jn.load(KART).tyre.stiffness)
    assert corner.spring_rate == pytest.approx(float(at_rest["wheel_rate_spring"]), rel=1e-4)
    assert corner.motion_ratio == pytest.approx(float(at_rest["motion_ratio"]), rel=1e-4)


def test_skyhook_calms_the_body_on_a_double_wishbone() -> None:
    rig = jn.load(KART)
    passive, controlled = jn.simulate(rig, TRIAL), jn.simulate(rig, TRIAL, control="skyhook")
    assert float(controlled["sprung.az"].std()) < 0.8 * float(passive["sprung.az"].std())
    assert {"command", "actuator.force"} <= set(map(str, controlled.data_vars))


def test_a_constant_command_is_a_passive_damper() -> None:
    """Dry friction of the strut stays, as it does in lumped rigs."""
    rig = jn.load(KART).with_changes({"strut.friction": {"force": 30.0}})
    coefficient = rig.parameters()["strut.damper.coefficient"]
    law = jn.Passive(
        damping_coefficient=coefficient,
        actuator=jn.SemiActiveDamper(
            minimum=0.5 * coefficient, maximum=2.0 * coefficient, lag="0 s"
        ),
    )
    passive, controlled = (
        jn.simulate(rig, TRIAL, tolerance=1e-8),
        jn.simulate(rig, TRIAL, control=law, tolerance=1e-8),
    )
    for name in ("sprung.z", "unsprung.z", "strut.force"):
        size = float(passive[name].max() - passive[name].min())
        np.testing.assert_allclose(controlled[name], passive[name], atol=1e-6 * size)


def test_corners_of_a_full_car_are_controlled_each_by_itself() -> None:
    car = jn.load("formula-student-car")
    left = jn.HalfSine(height="5 mm", length="400 mm", start="1 m")
    trial = jn.Trial(road=left, right=jn.Flat(), speed="10 m/s", duration="0.6 s")
    run = jn.simulate(car, trial, control=Skyhook(actuator=jn.SemiActiveDamper(lag="5 ms")))
    forces = [float(run[f"{corner}.actuator.force"].std()) for corner in car.corners]
    assert forces[0] > 1.5 * forces[1]
    assert all(float(run[f"{corner}.command"].std()) > 0.0 for corner in car.corners)
