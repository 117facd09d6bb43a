"""What commands do at once, and which command a force needs: the laws behind observers, regulators and predictions."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest
from scipy.linalg import expm

from jounce.control import ActiveActuator, MagnetorheologicalDamper, SemiActiveDamper
from jounce.control.actuators import Instant

TANH = {
    "kind": "tanh",
    "coefficient": 400.0,
    "stiffness": 800.0,
    "force": 60.0,
    "slope": 25.0,
    "offset": 30.0,
}
TANH |= {"displacement_coupling": 2.0}
BOUC = {
    "kind": "bouc-wen",
    "coefficient": 900.0,
    "hysteretic_force": 150.0,
    "rate": 500.0,
    "sigma": 0.8,
    "exponent": 1.5,
}
STATIC = 0.05


def instant(actuator, velocity: float, deflection: float = 0.0) -> Instant:
    low, high = actuator.limits
    numbers = {
        **actuator.plant_numbers,
        "minimum": low,
        "maximum": high,
        "static_deflection": STATIC,
    }
    seen = {"strut.velocity": velocity, "strut.deflection": deflection}
    return Instant(lambda name: ca.SX(seen[name]), lambda name: ca.SX(numbers[name]), ca.SX(0.0))


def tanh_force(law: dict, velocity: float, deflection: float) -> float:
    x = deflection + STATIC
    lagged = velocity + law["displacement_coupling"] * x
    linear = law["coefficient"] * velocity + law["stiffness"] * x + law["offset"]
    return linear + law["force"] * np.tanh(law["slope"] * lagged)


@pytest.mark.parametrize("velocity", [-0.4, 0.03, 0.5])
def test_a_voltage_lies_between_the_two_laws(velocity: float) -> None:
    on = {**TANH, "coefficient": 900.0, "force": 800.0}
    damper = MagnetorheologicalDamper(off=TANH, on=on, maximum=5.0)
    now = instant(damper, velocity, 0.01)
    off_force, on_force = tanh_force(TANH, velocity, 0.01), tanh_force(on, velocity, 0.01)
    for voltage in (0.0, 2.0, 5.0):
        expected = off_force + (on_force - off_force) * voltage / 5.0
        assert float(damper.force_of(ca.SX(voltage), now)) == pytest.approx(expected, rel=1e-12)
        assert float(damper.command_for_force(ca.SX(expected), now)) == pytest.approx(
            voltage, abs=1e-9
        )
    beyond = off_force + 1.5 * (on_force - off_force)
    assert float(damper.command_for_force(ca.SX(beyond), now)) == 5.0


def test_a_hysteretic_force_that_is_not_measured_turns_over_with_the_velocity() -> None:
    damper = MagnetorheologicalDamper(off=BOUC, on={**BOUC, "hysteretic_force": 900.0}, maximum=5.0)
    for velocity in (-0.3, -0.01, 0.02):
        force = float(damper.force_of(ca.SX(5.0), instant(damper, velocity)))
        assert force == pytest.approx(
            900.0 * velocity + 900.0 * np.tanh(velocity / 0.02), rel=1e-12
        )


def test_a_semi_active_damper_never_drives() -> None:
    damper = SemiActiveDamper(minimum=300.0, maximum=4000.0)
    now = instant(damper, -0.2)
    assert float(damper.force_of(ca.SX(1000.0), now)) == -200.0
    commands = [
        float(damper.command_for_force(ca.SX(force), now))
        for force in (-200.0, 200.0, -20.0, -2000.0)
    ]
    assert commands == pytest.approx([1000.0, 300.0, 300.0, 4000.0], rel=1e-9)


def test_an_active_actuator_gives_its_command_within_its_limits() -> None:
    actuator = ActiveActuator(force_limit=1500.0)
    now = instant(actuator, 0.3)
    assert float(actuator.force_of(ca.SX(-700.0), now)) == -700.0
    commands = [
        float(actuator.command_for_force(ca.SX(force), now)) for force in (-2000.0, 700.0, 2000.0)
    ]
    assert commands == [-1500.0, 700.0, 1500.0]


@pytest.mark.parametrize("ratio", [0.4, 1.0])
def test_own_states_of_an_actuator_answer_a_step_by_their_closed_form(ratio: float) -> None:
    a, b = ActiveActuator(bandwidth=20.0, damping_ratio=ratio).equations
    time, w = 0.007, 2.0 * np.pi * 20.0
    found = np.linalg.solve(a, (expm(a * time) - np.eye(2)) @ b).ravel()
    wd = w * np.sqrt(max(1.0 - ratio**2, 0.0))
    swing = w * time if ratio == 1.0 else w * np.sin(wd * time) / wd  # w t in the limit
    decay = np.exp(-ratio * w * time)
    assert found[0] == pytest.approx(1.0 - decay * (np.cos(wd * time) + ratio * swing), rel=1e-9)
    assert found[1] == pytest.approx(w * decay * swing, rel=1e-9)
    a, b = ActiveActuator(lag=0.01).equations
    assert (a.item(), b.item()) == (-100.0, 100.0)
    orders = [
        ActiveActuator(bandwidth=20.0).order,
        ActiveActuator(lag=0.01).order,
        ActiveActuator(lag=0.0).order,
    ]
    assert orders == [2, 1, 0]
