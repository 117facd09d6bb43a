"""How runs end: outcomes are data, each the right one, with a text that helps."""

from __future__ import annotations

from typing import NamedTuple

import casadi as ca
import numpy as np
import pytest

from jounce.core.segments import flat
from jounce.kernel.engine import Status
from jounce.mechanics import System
from jounce.simulation import prepare as run_module
from jounce.simulation.compiled import compile_model
from jounce.simulation.prepare import solve
from jounce.simulation.settings import output_times


class Body(NamedTuple):
    system: System
    z: ca.SX
    v: ca.SX


def mass_on_a_spring(extra):
    """1 kg on 100 N/m, with a force ``extra(body)`` besides."""
    system = System()
    z, road = system.coordinate("body.z"), system.track("road.z")
    system.point_mass(ca.SX(1.0), z)
    system.force(z, -system.parameter("rate") * (z - road.value))
    system.force(z, extra(Body(system, z, system.rate_of(z))))
    system.output("body.z", z, "m", "body height")
    return system.finish()


def outcome(extra, *, duration=3.0, start=(0.01, 0.0), tolerance=1e-5):
    compiled = compile_model(mass_on_a_spring(extra))
    times = output_times(duration, 1e-2)
    return solve(
        compiled,
        np.array([100.0]),
        flat(duration),
        times,
        tolerance=tolerance,
        offset=np.array(start),
    )


def test_an_ordinary_run_completes():
    """The frame itself: z = 0.01 cos(10 t), by adaptive steps (a cubic of 1e-9 N/m^3 makes the model nonlinear)."""
    run = outcome(lambda body: -1e-9 * body.z**3)
    assert run.status is Status.COMPLETED
    assert run.steps > 10
    assert run.states[0] == pytest.approx(0.01 * np.cos(10.0 * run.time), abs=1e-7)


def test_negative_damping_of_a_linear_model_overflows():
    run = outcome(lambda body: 500.0 * body.v, duration=10.0)
    assert run.status is Status.NOT_FINITE


def test_negative_damping_of_a_nonlinear_model_overflows():
    """Growth like exp(100 t) leaves the numbers after 7 s."""
    run = outcome(lambda body: 100.0 * body.v + 1e-3 * ca.sin(body.z), duration=60.0)
    assert run.status is Status.NOT_FINITE
    assert "unstable" in run.status.help


def test_finite_time_singularity_does_not_complete():
    """z'' = 1e4 z^2 reaches infinity within a second."""
    run = outcome(lambda body: 1e4 * body.z**2, start=(0.1, 1.0))
    assert run.status in (Status.NOT_FINITE, Status.STEP_TOO_SMALL)


def test_a_switch_that_holds_the_solution_on_it_chatters():
    """Coulomb friction without regularisation: at rest the velocity's sign cannot settle."""
    run = outcome(
        lambda body: -20.0 * (2.0 * body.system.switch("sliding", body.v) - 1.0), start=(0.1, 0.1)
    )
    assert run.status is Status.CHATTER


def test_too_stiff_for_an_explicit_method():
    run = outcome(lambda body: -1e30 * ca.tanh(body.z), start=(0.1, 0.0))
    assert run.status is Status.STEP_TOO_SMALL


def test_step_budget(monkeypatch):
    monkeypatch.setattr(run_module, "MAX_STEPS", 20)
    run = outcome(lambda body: -1e3 * body.z**3, duration=30.0)
    assert run.status is Status.TOO_MANY_STEPS
    assert run.steps + run.rejected == 20


def test_samples_that_were_not_reached_are_no_numbers(monkeypatch):
    monkeypatch.setattr(run_module, "MAX_STEPS", 20)
    run = outcome(lambda body: -1e3 * body.z**3, duration=30.0)
    assert np.isfinite(run.states[:, 0]).all()
    assert np.isnan(run.states[:, -1]).all()
    assert np.isnan(run.outputs[:, -1]).all()


def test_a_jump_is_not_linear():
    """Dry friction by the sign of the velocity: derivatives are zero, yet nothing is linear."""
    model = mass_on_a_spring(lambda body: -20.0 * ca.sign(body.v))
    assert not model.is_piecewise_linear()


def test_every_status_helps():
    assert len({status.code for status in Status}) == len(Status)
    for status in Status:
        assert Status.of(status.code) is status
        assert len(status.help) > 20
