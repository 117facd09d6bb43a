"""The implicit method's coefficients, and the loop around them: edges, events, statuses."""

from __future__ import annotations

import numba
import numpy as np
import pytest

from jounce.core.segments import Segments
from jounce.kernel.engine import Control, Problem, Status, flatten
from jounce.kernel.loops.signals import fill, fill_rates
from jounce.kernel.methods import rosenbrock
from jounce.kernel.methods.implicit import integrate
from jounce.mechanics import System
from jounce.simulation.compiled import compile_model
from jounce.simulation.linear_systems import slopes_of
from jounce.simulation.prepare import room


def as_standard_form():
    """``alpha``, ``gamma`` and the weights of ``k_i = f(..) + gamma J k`` from the form without matrix products."""
    size, a, b = rosenbrock.STAGES, rosenbrock.A[:-1], rosenbrock.B
    inverse = np.eye(size) / rosenbrock.GAMMA - b
    gamma = np.linalg.inv(inverse)
    return a @ gamma, gamma, rosenbrock.A[-1] @ gamma


def test_coefficients_satisfy_the_order_conditions():
    """Conditions up to order 5 that involve sums of alpha and beta: Hairer and Wanner, vol. II, section IV.7."""
    alpha, gamma, weights = as_standard_form()
    beta = alpha + gamma
    a, b = alpha.sum(axis=1), beta.sum(axis=1)
    conditions = {
        "1": (weights.sum(), 1.0),
        "2": (weights @ b, 1 / 2),
        "3a": (weights @ a**2, 1 / 3),
        "3b": (weights @ beta @ b, 1 / 6),
        "4a": (weights @ a**3, 1 / 4),
        "4b": (weights @ (a * (alpha @ b)), 1 / 8),
        "4c": (weights @ beta @ a**2, 1 / 12),
        "4d": (weights @ beta @ beta @ b, 1 / 24),
        "5a": (weights @ a**4, 1 / 5),
        "5b": (weights @ (a**2 * (alpha @ b)), 1 / 10),
        "5c": (weights @ (alpha @ b) ** 2, 1 / 20),
        "5d": (weights @ (a * (alpha @ a**2)), 1 / 15),
        "5e": (weights @ (a * (alpha @ beta @ b)), 1 / 30),
        "5f": (weights @ beta @ a**3, 1 / 20),
        "5g": (weights @ beta @ (a * (alpha @ b)), 1 / 40),
        "5h": (weights @ beta @ beta @ a**2, 1 / 60),
        "5i": (weights @ beta @ beta @ beta @ b, 1 / 120),
    }
    for name, (found, wanted) in conditions.items():
        assert found == pytest.approx(wanted, abs=2e-13), name


def test_coefficients_of_times_follow_from_the_others():
    alpha, gamma, _ = as_standard_form()
    np.testing.assert_allclose(alpha.sum(axis=1), rosenbrock.C, atol=1e-13)
    np.testing.assert_allclose(gamma.sum(axis=1), rosenbrock.D, atol=1e-13)


def test_the_method_forgets_fast_modes():
    """Stability function at minus infinity is zero, and on the imaginary axis nothing grows (L-stable)."""
    _, gamma, weights = as_standard_form()
    beta = as_standard_form()[0] + gamma
    size, ones = len(weights), np.ones(len(weights))

    def growth(z):
        return 1.0 + z * weights @ np.linalg.solve(np.eye(size) - z * beta, ones)

    assert abs(growth(-1e12)) < 1e-9
    assert max(abs(growth(1j * w)) for w in np.geomspace(1e-2, 1e4, 400)) < 1.0 + 1e-12


@numba.njit
def around_and_rates(tracks, piece, times, around, t, rates):
    fill(tracks, piece, times, around)
    fill_rates(tracks, piece, t, rates)


def signal(kind, coefficients, rate=2.0):
    return Segments(np.array([0.0, 5.0]), np.array([kind]), np.array([coefficients]), rate)


@pytest.mark.parametrize(
    ("kind", "coefficients"),
    [(0, [0.1, 0.2, -0.3, 0.05]), (1, [0.1, 0.2, 1.7, 0.4]), (2, [0.1, 2.0, 0.3, 1.0])],
    ids=["cubic", "sine", "circle"],
)
def test_rates_of_inputs_are_their_derivatives(kind, coefficients):
    """Against central differences of the inputs themselves."""
    tracks = flatten([signal(kind, coefficients)])
    piece, step, at = tracks.first[:-1].copy(), 1e-5, 0.5
    around, rates = np.zeros((3, 2)), np.zeros(3)
    around_and_rates(tracks, piece, np.array([at - step, at + step]), around, at, rates)
    np.testing.assert_allclose(rates, (around[:, 1] - around[:, 0]) / (2.0 * step), rtol=1e-7)


def bouncing():
    """A mass on a stiff stop: it falls and jumps."""
    system = System()
    z = system.coordinate("z")
    system.point_mass(system.parameter("mass"), z)
    touching = system.switch("touching", -z)
    system.force(z, -9.81 * system.parameter("mass") - touching * system.parameter("stiffness") * z)
    system.output("z", z, "m", "height")
    return system.finish()


def run(model, values, x0, times, *, tolerance=1e-8, longest=0.05, max_steps=100_000, modes=()):
    compiled = compile_model(model)
    p = compiled.extend(np.array(values, dtype=float))
    tracks, start = flatten([signal(0, [0.0] * 4)]), np.array(x0, dtype=float)
    problem = Problem(
        compiled.engine, tracks, tracks.first[:0].copy(), p, np.array(modes, dtype=float), start, 0
    )
    control = Control(
        tolerance, np.full(len(x0), 1e-2), np.full(len(modes), 1e-12), max_steps, longest
    )
    out, counts = room(compiled, times), np.zeros(3, dtype=np.int64)
    return Status.of(integrate(problem, slopes_of(compiled), control, out, counts)), out, counts


def test_events_are_found_and_counted():
    """Fall from 0.1 m onto a spring of 1e6 N/m, back up to 0.1 m: the period of free flight and contact is known."""
    mass, stiffness, height, g = 2.0, 1e6, 0.1, 9.81
    fall, w = np.sqrt(2.0 * height / g), np.sqrt(stiffness / mass)
    speed, sag = g * fall, g / w**2
    contact = 2.0 * (np.pi - np.arctan(speed / (w * sag))) / w
    period = 2.0 * fall + contact
    times = np.linspace(0.0, 10.0 * period, 1001)
    status, out, counts = run(
        bouncing(), [mass, stiffness], [height, 0.0], times, modes=[0.0], tolerance=1e-9
    )
    assert status is Status.COMPLETED
    assert counts[2] == 20
    np.testing.assert_allclose(out.states[0, ::100], height, rtol=2e-6)
    lowest = -sag - np.sqrt(sag**2 + (speed / w) ** 2)
    assert out.states[0].min() == pytest.approx(lowest, rel=0.05)


def test_a_used_up_budget_is_told():
    status, _, counts = run(
        bouncing(), [2.0, 1e6], [0.1, 0.0], np.linspace(0.0, 5.0, 11), modes=[0.0], max_steps=30
    )
    assert status is Status.TOO_MANY_STEPS
    assert counts[0] + counts[1] == 30


def test_what_runs_away_is_told():
    """Negative stiffness that grows: the solution leaves the numbers in finite time."""
    system = System()
    z = system.coordinate("z")
    system.point_mass(system.parameter("mass"), z)
    system.force(z, z**3 * system.parameter("rate"))
    system.output("z", z, "m", "height")
    status, out, _ = run(system.finish(), [1.0, 1e3], [1.0, 0.0], np.linspace(0.0, 5.0, 501))
    assert status in (Status.NOT_FINITE, Status.STEP_TOO_SMALL)
    assert np.isnan(out.states[0, -1])
    assert np.isfinite(out.states[0, 0])


def test_a_state_of_rest_stays():
    status, out, counts = run(
        bouncing(), [2.0, 1e6], [-2.0 * 9.81 / 1e6, 0.0], np.linspace(0.0, 1.0, 5), modes=[1.0]
    )
    assert status is Status.COMPLETED
    np.testing.assert_allclose(out.states[0], -2.0 * 9.81 / 1e6, rtol=1e-9)
    assert counts[0] < 60
