"""The pair of lower order for steps that edges keep short: order conditions, interpolant, and when it is taken."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.kernel.engine import LAST_STAGE
from jounce.kernel.methods import runge_kutta
from jounce.kernel.methods.runge_kutta import SHORT_NODES
from jounce.roads import Iso8608, Trial
from jounce.simulation.compiled import compile_rig
from jounce.simulation.prepare import prepare
from jounce.simulation.problem import excitation
from jounce.simulation.settings import output_times

ROWS = [0, *range(runge_kutta.SHORT_FIRST, LAST_STAGE + 1)]
A = np.array([np.zeros(7), *(runge_kutta.SHORT_A[row][ROWS] for row in ROWS[1:])])
B, C, E = A[6], runge_kutta.SHORT_C[ROWS], runge_kutta.SHORT_E[ROWS]


def conditions(b, order):
    """Order conditions of Butcher up to ``order``, as residuals (Hairer, Norsett, Wanner, vol. I, table II.2.2)."""
    ac, ac2 = A @ C, A @ C**2
    every = {
        1: [b.sum() - 1],
        2: [b @ C - 1 / 2],
        3: [b @ C**2 - 1 / 3, b @ ac - 1 / 6],
        4: [b @ C**3 - 1 / 4, b @ (C * ac) - 1 / 8, b @ ac2 - 1 / 12, b @ (A @ ac) - 1 / 24],
        5: [
            b @ C**4 - 1 / 5,
            b @ (C**2 * ac) - 1 / 10,
            b @ (C * ac2) - 1 / 15,
            b @ (C * (A @ ac)) - 1 / 30,
            b @ ac**2 - 1 / 20,
            b @ (A @ C**3) - 1 / 20,
            b @ (A @ (C * ac)) - 1 / 40,
            b @ (A @ ac2) - 1 / 60,
            b @ (A @ (A @ ac)) - 1 / 120,
        ],
    }
    return [residual for k in range(1, order + 1) for residual in every[k]]


def test_the_pair_has_its_orders():
    assert np.allclose(A.sum(axis=1), C, atol=1e-14)
    assert np.max(np.abs(conditions(B, 5))) < 1e-14
    assert np.max(np.abs(conditions(B - E, 4))) < 1e-14
    assert np.max(np.abs(conditions(B - E, 5))) > 1e-4
    assert SHORT_NODES[LAST_STAGE] == 1.0


def test_the_interpolant_is_of_fourth_order():
    """y' = y over steps of halved length: its error inside the step falls by 2^5."""
    errors = []
    for h in (0.4, 0.2):
        k, d = np.ones(7), runge_kutta.SHORT_D[ROWS]
        for i in range(1, 7):
            k[i] = 1.0 + h * A[i] @ k
        change, theta = h * B @ k, np.linspace(0.0, 1.0, 21)
        c1 = h * k[0] - change
        c2, c3 = change - h * k[6] - c1, h * d @ k
        y = 1.0 + theta * (change + (1 - theta) * (c1 + theta * (c2 + (1 - theta) * c3)))
        errors.append(np.max(np.abs(y - np.exp(theta * h))))
    assert 4.5 < np.log2(errors[0] / errors[1]) < 5.6


def laid(vehicle, trial, tolerance=1e-5):
    compiled = compile_rig(vehicle)
    p, times = compiled.parameter_values(vehicle.parameters()), output_times(trial.duration, 1e-3)
    signals = excitation(compiled.facts, vehicle, trial)
    return prepare(
        compiled, p, signals, times, tolerance=tolerance, method="explicit"
    )  # by itself, exact propagation


@pytest.mark.parametrize("tolerance", [1e-4, 1e-5])
def test_rough_roads_are_as_accurate_as_smooth_ones(tolerance):
    vehicle = jn.load("audi-a6-full-car")
    road = Iso8608(class_="D", length="80 m", step="4 cm", run_in="4 m")
    trial = Trial(road=road, right=road.other_track(), speed="20 m/s", duration="4 s")
    rough, exact = laid(vehicle, trial, tolerance), laid(vehicle, trial, 1e-11)
    assert rough.problem.engine.first == runge_kutta.SHORT_FIRST
    assert exact.problem.engine.first == 1
    found, reference = (run.run() for run in (rough, exact))
    count = len(rough.compiled.facts.coordinates)
    error = np.max(np.abs(found.states[:count] - reference.states[:count]), axis=1)
    assert np.max(error / np.ptp(reference.states[:count], axis=1)) < tolerance
    assert found.events == reference.events


def test_smooth_obstacles_keep_the_pair_of_higher_order():
    trial = Trial(
        road=jn.HalfSine(height="10 mm", length="60 mm"), speed="1.95 m/s", duration="1 s"
    )
    assert laid(jn.load("kart-quarter-car"), trial).problem.engine.first == 1
