"""Pieces of stationary responses against SciPy, defective matrices included."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.linalg import expm, expm_frechet, solve_continuous_lyapunov

import jounce as jn
from jounce.core.errors import SimulationError
from jounce.ride.covariance import Flow, Inverse, Schur, check_stable, frequencies, relative, sources_of
from jounce.ride.family import Matrices, _track_width, without_unreached

RNG = np.random.default_rng(5)
STABLE = RNG.normal(size=(6, 6)) - 4.0 * np.eye(6)
DEFECTIVE = np.array([[-1.0, 1.0, 0.0], [0.0, -1.0, 1.0], [0.0, 0.0, -1.0]])
CASES = pytest.mark.parametrize("a", [STABLE, DEFECTIVE], ids=["plain", "defective"])


@CASES
def test_flow_and_its_slope(a):
    along = RNG.normal(size=a.shape)
    for time in (0.0, 0.03, 0.7):
        assert Flow(a).at(time) == pytest.approx(expm(a * time), rel=1e-10, abs=1e-12)
        exact = expm_frechet(a * time, along * time, compute_expm=False)
        assert Flow(a).slope(time, along) == pytest.approx(exact, rel=1e-9, abs=1e-12)


@CASES
def test_lyapunov_equation(a):
    q = RNG.normal(size=a.shape)  # need not be symmetric
    found = Schur(a).solve(q)
    assert a @ found + found @ a.T + q == pytest.approx(np.zeros_like(a), abs=1e-12)
    assert found == pytest.approx(solve_continuous_lyapunov(a, -q), rel=1e-10, abs=1e-12)


@CASES
def test_inverse_at_many_frequencies(a):
    s, b, c = 2j * np.pi * np.array([0.1, 1.0, 30.0]), RNG.normal(size=(len(a), 2)), RNG.normal(size=(4, len(a)))
    inverse = Inverse(a, s)
    for i, value in enumerate(s):
        exact = np.linalg.inv(value * np.eye(len(a)) - a)
        assert inverse.times(b)[i] == pytest.approx(exact @ b, rel=1e-10)
        assert inverse.before(c)[i] == pytest.approx(c @ exact, rel=1e-10)


def test_quadrature_resolves_light_damping_and_delays():
    for ratio in (1e-3, 0.02, 0.5):
        omega = 2 * np.pi * 3.0
        a = np.array([[0.0, 1.0], [-(omega**2), -2 * ratio * omega]])
        f, weights = frequencies(1e-6, 1e4, a, 0.0)
        response = np.abs(1.0 / (omega**2 - (2 * np.pi * f) ** 2 + 2j * ratio * omega * 2 * np.pi * f)) ** 2
        assert response @ weights == pytest.approx(1.0 / (8.0 * ratio * omega**3), rel=1e-6)  # one-sided
    f, weights = frequencies(0.2, 60.0, np.array([[-1.0]]), 0.3)
    exact = (np.sin(2 * np.pi * 60.0 * 0.3) - np.sin(2 * np.pi * 0.2 * 0.3)) / (2 * np.pi * 0.3)
    assert np.cos(2 * np.pi * f * 0.3) @ weights == pytest.approx(exact, abs=1e-9)


def test_wheels_are_sorted_by_what_drives_them():
    one = sources_of([0.0, 0.0, 0.1, 0.1], [1, -1, 1, -1], same=True)
    assert [(group.delay, group.wheels) for group in one[0]] == [(0.0, (0, 1)), (0.1, (2, 3))]
    left, right = sources_of([0.0, 0.0, 0.1, 0.1], [1, -1, 1, -1], same=False)
    assert [group.wheels for group in left] == [(0,), (2,)]
    assert [group.wheels for group in right] == [(1,), (3,)]
    assert len(sources_of([0.0, 0.1], [0, 0], same=False)) == 1


@pytest.mark.parametrize("part", ["B", "D"])
def test_a_model_that_feels_the_acceleration_of_the_road_is_refused(part):
    b, d = np.zeros((3, 2, 1)), np.zeros((3, 2, 1))
    b[0, 1] = 4.0
    plain = Matrices(np.array([[0.0, 1.0], [-4.0, -1.0]]), b, np.eye(2), d, np.zeros(2))
    assert relative(plain).E.ravel() == pytest.approx([1.0, 0.0])
    felt = getattr(plain, part).copy()
    felt[2, 1] = 0.1
    with pytest.raises(SimulationError, match="feels the acceleration of the road"):
        relative(replace(plain, **{part: felt}))


def test_neutral_motions_that_are_driven_stay_and_are_refused():
    def model(push: float) -> Matrices:
        a, b = np.array([[0.0, 0.0], [0.0, -1.0]]), np.array([[[push], [1.0]], [[0.0], [0.0]]])
        return Matrices(a, b, np.eye(2), np.zeros((2, 2, 1)), np.zeros(2))

    reduced, _ = without_unreached(model(0.0), [])
    assert reduced.A.tolist() == [[-1.0]]
    kept, _ = without_unreached(model(1.0), [])
    assert kept.A.shape == (2, 2)
    with pytest.raises(SimulationError, match="not asymptotically stable"):
        check_stable(kept.A)
    with pytest.raises(SimulationError, match=r"eigenvalue 2 \+1j"):
        check_stable(np.array([[2.0, 1.0], [-1.0, 2.0]]))


def test_sides_are_as_far_apart_as_the_hardpoints_say() -> None:
    assert _track_width(jn.load("sedan-full-car-3d")) == pytest.approx(0.7979 + 0.8)  # half tracks of front and rear
