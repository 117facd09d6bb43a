"""Pieces of stationary responses against SciPy, defective matrices included."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.linalg import expm, expm_frechet, solve_continuous_lyapunov

import jounce as jn
from jounce.core.errors import DescriptionError, SimulationError
from jounce.ride.covariance import (
    Flow,
    Inverse,
    Lyapunov,
    RandomVibration,
    Signal,
    WheelGroup,
    check_stable,
    frequencies,
    longest_delay,
    relative,
    sources_of,
)
from jounce.ride.family import (
    Eigen,
    Families,
    LinearFamily,
    Matrices,
    side_by_side,
    without_unreached,
)
from jounce.ride.stationary import StationaryResponse, stationary, with_spectra
from jounce.ride.surface import surface

RNG = np.random.default_rng(5)
STABLE = RNG.normal(size=(6, 6)) - 4.0 * np.eye(6)
DEFECTIVE = np.array([[-1.0, 1.0, 0.0], [0.0, -1.0, 1.0], [0.0, 0.0, -1.0]])
TURN = RNG.normal(size=(3, 3))
NEAR = (
    TURN @ np.diag([-1.0, -1.0028, -3.0]) @ np.linalg.inv(TURN)
)  # eigenvalues that are nearly the same
CASES = pytest.mark.parametrize("a", [STABLE, DEFECTIVE, NEAR], ids=["plain", "defective", "near"])


def _three(a: np.ndarray) -> tuple[np.ndarray, Eigen]:
    """The same matrix three times, side by side."""
    many = np.tile(a, (3, 1, 1))
    return many, Eigen(many)


@pytest.mark.source(
    kind="program",
    key="scipy",
    of="ride and roughness",
    where="scipy.linalg: expm, expm_frechet, solve_continuous_lyapunov",
    tolerance="rounding",
    compares="matrix exponential and its derivative",
)
@CASES
def test_flow_and_its_slope(a):
    along = np.random.default_rng(6).normal(size=a.shape)
    times = np.array([0.0, 0.03, 0.7])
    flow = Flow(*_three(a))
    flows, slopes = flow.at(times), flow.slopes(times, np.tile(along, (3, 1, 1, 1)))
    for k, time in enumerate(times):
        assert flows[k] == pytest.approx(expm(a * time), rel=1e-10, abs=1e-12)
        exact = expm_frechet(a * time, along * time, compute_expm=False)
        assert slopes[k, 0] == pytest.approx(exact, rel=1e-9, abs=1e-12)


@pytest.mark.source(
    kind="program",
    key="scipy",
    of="ride and roughness",
    where="scipy.linalg: expm, expm_frechet, solve_continuous_lyapunov",
    tolerance="rounding",
    compares="covariance of a stationary response",
)
@CASES
def test_lyapunov_equation(a):
    one = np.random.default_rng(7).normal(size=a.shape)  # need not be symmetric
    many = np.stack([one, 0.2 * one.T, -0.3 * one])
    equations = Lyapunov(*_three(a))
    found = equations.solve(many)
    for x, q in zip(found, many, strict=True):
        assert a @ x + x @ a.T + q == pytest.approx(np.zeros_like(a), abs=1e-12)
        assert x == pytest.approx(solve_continuous_lyapunov(a, -q), rel=1e-10, abs=1e-12)
    assert equations.solve(many[:, None])[:, 0] == pytest.approx(found, rel=1e-14)


@CASES
def test_inverse_at_many_frequencies(a):
    s, rng = 2j * np.pi * np.array([0.1, 1.0, 30.0]), np.random.default_rng(8)
    b, c = rng.normal(size=(len(a), 2)), rng.normal(size=(4, len(a)))
    inverse = Inverse(*_three(a), np.tile(s, (3, 1)))
    columns = [inverse.times(np.tile(column, (3, 1)))[1] for column in b.T]
    for i, value in enumerate(s):
        exact = np.linalg.inv(value * np.eye(len(a)) - a)
        moved = np.stack([column[:, i] for column in columns], axis=1)
        assert moved == pytest.approx(exact @ b, rel=1e-10)
        assert inverse.before(np.tile(c, (3, 1, 1)))[1, :, :, i] == pytest.approx(
            c @ exact, rel=1e-10
        )


def test_quadrature_resolves_light_damping_and_delays():
    for ratio in (1e-3, 0.02, 0.5):
        omega = 2 * np.pi * 3.0
        a = np.array([[0.0, 1.0], [-(omega**2), -2 * ratio * omega]])
        (f,), (weights,) = frequencies(
            1e-6, 1e4, np.linalg.eigvals(a)[None].astype(complex), np.zeros(1)
        )
        response = (
            np.abs(1.0 / (omega**2 - (2 * np.pi * f) ** 2 + 2j * ratio * omega * 2 * np.pi * f))
            ** 2
        )
        assert response @ weights == pytest.approx(
            1.0 / (8.0 * ratio * omega**3), rel=1e-6
        )  # one-sided
    delays, values = np.array([0.3, 0.0, 0.1]), np.full((3, 1), -1.0 + 0.0j)
    nodes, weights = frequencies(0.2, 60.0, values, delays)
    for f, weight, delay in zip(nodes, weights, np.maximum(delays, 1e-9), strict=True):
        exact = (np.sin(2 * np.pi * 60.0 * delay) - np.sin(2 * np.pi * 0.2 * delay)) / (
            2 * np.pi * delay
        )
        assert np.cos(2 * np.pi * f * delay) @ weight == pytest.approx(exact, abs=1e-9)


def test_wheels_are_sorted_by_what_drives_them():
    delays = np.array([[0.0, 0.0, 0.1, 0.1], [0.0, 0.0, 0.2, 0.2]])
    one = sources_of(delays, [1, -1, 1, -1], same=True)
    assert [(group.delay.tolist(), group.wheels) for group in one[0]] == [
        ([0.0, 0.0], (0, 1)),
        ([0.1, 0.2], (2, 3)),
    ]
    left, right = sources_of(delays, [1, -1, 1, -1], same=False)
    assert [group.wheels for group in left] == [(0,), (2,)]
    assert [group.wheels for group in right] == [(1,), (3,)]
    assert len(sources_of(np.array([[0.0, 0.1]]), [0, 0], same=False)) == 1
    for other in (
        [0.0, 0.0, 0.0, 0.0],
        [0.1, 0.1, 0.0, 0.0],
        [0.0, 0.1, 0.2, 0.2],
    ):  # the wheels follow otherwise
        assert sources_of(np.array([delays[0], other]), [1, -1, 1, -1], same=True) is None
    groups = [
        (WheelGroup(np.array([0.1, 0.0]), (0,)), WheelGroup(np.array([0.4, 0.6]), (1,))),
        (WheelGroup(np.array([0.2, 0.0]), (2,)),),
    ]
    assert longest_delay(groups) == pytest.approx([0.3, 0.6])


@pytest.mark.parametrize("part", ["B", "D"])
def test_a_model_that_feels_the_acceleration_of_the_road_is_refused(part):
    b, d = np.zeros((3, 2, 1)), np.zeros((3, 2, 1))
    b[0, 1] = 4.0
    plain = Matrices(np.array([[0.0, 1.0], [-4.0, -1.0]]), b, np.eye(2), d, np.zeros(2))
    values = np.linalg.eigvals(plain.A).astype(complex)
    assert relative(plain, values).E.ravel() == pytest.approx([1.0, 0.0])
    felt = getattr(plain, part).copy()
    felt[2, 1] = 0.1
    with pytest.raises(SimulationError, match="depends on the acceleration of the road"):
        relative(replace(plain, **{part: felt}), values)


def test_neutral_motions_that_are_driven_stay_and_are_refused():
    def model(push: float) -> Matrices:
        a, b = np.array([[0.0, 0.0], [0.0, -1.0]]), np.array([[[push], [1.0]], [[0.0], [0.0]]])
        return Matrices(a, b, np.eye(2), np.zeros((2, 2, 1)), np.zeros(2))

    none = side_by_side([model(0.0)])[:0]
    reduced, _ = without_unreached(model(0.0), none)
    assert (
        pytest.approx(np.array([[-1.0]]), rel=1e-14) == reduced.A
    )  # a projection of two rows: some roundings
    kept, _ = without_unreached(model(1.0), none)
    assert kept.A.shape == (2, 2)
    with pytest.raises(SimulationError, match="not asymptotically stable"):
        check_stable(np.linalg.eigvals(kept.A))
    with pytest.raises(SimulationError, match=r"eigenvalue 2 \+1j"):
        check_stable(np.array([[-1.0 + 0j, -2.0], [2.0 + 1.0j, 2.0 - 1.0j]]))


def test_where_wheels_stand() -> None:
    """How far behind the first, and the width between left and right, at the numbers of the rig and at others."""
    full = LinearFamily(jn.load("audi-a6-full-car"), ("front.distance", "front.track", "body.mass"))
    first, slopes = full.geometry
    assert first == pytest.approx([0.0, 0.0, 2.91, 2.91, 1.54])
    assert slopes == pytest.approx(
        np.array([[0, 0, 1, 1, 0], [0, 0, 0, 0, 0.5], [0, 0, 0, 0, 0]]), abs=1e-9
    )
    assert full.geometry_at(full.start + np.array([0.1, 0.2, 5.0])) == pytest.approx(
        [0.0, 0.0, 3.01, 3.01, 1.64]
    )
    half = LinearFamily(jn.load("audi-a6-half-car-4dof"))
    assert (half.wheels, list(half.geometry_at())) == (
        ("front", "rear"),
        pytest.approx([0.0, 2.91, 0.0]),
    )
    quarter = LinearFamily(jn.load("audi-a6-quarter-car"), ("sprung.mass",))
    assert (quarter.wheels, quarter.places) == (("",), ((0.0, 0),))
    assert [part.tolist() for part in quarter.geometry] == [[0.0, 0.0], [[0.0, 0.0]]]


@pytest.mark.parametrize(
    "options",
    [{"cut_off": 0.011}, {"band": "iso", "weighting": {"sprung.az": "Wk", "unsprung.az": "Wd"}}],
)
def test_slopes_with_a_cut_off_and_of_weighted_signals(options) -> None:
    rig = jn.load("audi-a6-quarter-car").with_changes({"tyre.damping_coefficient": 100.0})
    paths = ["sprung.mass", "tyre.stiffness", "tyre.damping_coefficient"]
    found = stationary(rig, "C", 20.0, parameters=paths, **options)
    for path in paths:
        value = rig.parameters()[path]
        above, below = (
            stationary(rig.with_changes({path: value * (1.0 + side)}), "C", 20.0, **options)
            for side in (1e-4, -1e-4)
        )
        for kind, slopes in (
            ("standard_deviation", found.slopes),
            ("weighted", found.weighted_slopes),
        ):
            high, low, here = (getattr(one, kind) for one in (above, below, found))
            assert slopes[path].keys() == here.keys()
            for name, slope in slopes[path].items():
                difference = (high[name] - low[name]) / 2e-4
                assert slope * value == pytest.approx(
                    difference, rel=1e-5, abs=1e-6 * here[name]
                ), (path, name)


def test_distances_of_wheels_follow_numbers_whatever_the_others_allow() -> None:
    """A product of inertia may move by little; a distance by half of itself."""
    car = jn.load("sedan-full-car-3d")
    inertia = "front.corner.bodies.upright.inertia.xy"
    family = LinearFamily(
        car, (inertia, "front.corner.hardpoints.wheel_centre[1]", "rear.distance")
    )
    family.__dict__["wheels"] = tuple(car.wheels)  # known without compiling the car
    first, slopes = family.geometry
    assert first[-1] == pytest.approx(0.7979 + 0.8)  # half tracks of front and rear
    wanted = [[0.0] * 5, [0.0, 0.0, 0.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0, 0.0]]
    assert slopes == pytest.approx(np.array(wanted), abs=1e-12)


def test_a_distance_that_may_not_move_is_told_with_its_unit(monkeypatch) -> None:
    def refuse(_self, _changes):
        raise DescriptionError("out of range")

    car = jn.load("audi-a6-half-car")
    monkeypatch.setattr(type(car), "with_changes", refuse)
    with pytest.raises(
        DescriptionError, match=r"this parameter cannot be changed here; found '1\.62 m'"
    ):
        _ = LinearFamily(car, ("rear.distance",)).geometry


def test_spectra_hold_the_variances_and_end_with_the_band() -> None:
    car, band = jn.load("audi-a6-full-car"), (0.02, 1.0)
    response = with_spectra(stationary(car, "C", 20.0, band=band), car, points=2000)
    assert response.frequency[[0, -1]] == pytest.approx([0.4, 20.0])
    for name in ("body.az", "body.roll", "rear_left.tyre.force"):
        variance = np.trapezoid(response.spectra[name], response.frequency)
        assert np.sqrt(variance) == pytest.approx(response[name], rel=2e-3)
    quarter = jn.load("audi-a6-quarter-car")
    white = stationary(quarter, "C", 20.0)
    assert with_spectra(white, quarter) is white
    road = surface("C", 20.0, band=band)
    families = Families((LinearFamily(quarter),))
    densities = RandomVibration(families, road, (Signal(0),)).densities(
        np.array([0.39, 0.41, 19.9, 20.1])
    )
    assert (densities > 0.0).tolist() == [[False, True, True, False]]


def test_chance_of_a_finite_run() -> None:
    """A flat density over a band B: the variance over a time T scatters by its share of one over the root of B T."""
    flat = SimpleNamespace(
        frequency=np.linspace(1.0, 5.0, 9), spectra={"a": np.full(9, 3.0), "still": np.zeros(9)}
    )
    assert StationaryResponse.chance(flat, "a", 25.0) == pytest.approx(
        0.5 * 1.959964 / 10.0, rel=1e-6
    )
    assert StationaryResponse.chance(flat, "still", 25.0) is None
    assert StationaryResponse.chance(flat, "b", 25.0) is None
    assert StationaryResponse.chance(SimpleNamespace(frequency=None, spectra={}), "a", 25.0) is None


class _Interrupted:
    """Values while which are read something else is done, as by another thread."""

    def __init__(self, values, meanwhile):
        self.values, self.meanwhile = values, meanwhile

    def __len__(self):
        return len(self.values)

    def __array__(self, dtype=None, copy=None):
        self.meanwhile()
        return self.values


def test_calls_of_one_function_do_not_share_what_they_work_in():
    """Two threads that judge cars of one kind at once took each other's numbers, once in thirty calls."""
    import casadi as ca

    from jounce.ride.family import _Each

    x, y = ca.SX.sym("x", 2), ca.SX.sym("y")
    each = _Each("each", [x, y], [x * y])
    other = np.array([[5.0, 7.0]]), np.array([[11.0]])
    meanwhile = []
    y_given = _Interrupted(np.array([[3.0]]), lambda: meanwhile.append(each(*other)[0]))
    (found,) = each(np.array([[1.0, 2.0]]), y_given)
    np.testing.assert_array_equal(found[0, :, 0], [3.0, 6.0])
    np.testing.assert_array_equal(meanwhile[0][0, :, 0], [55.0, 77.0])
