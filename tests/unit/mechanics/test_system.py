"""Authoring of mechanical systems: equations of motion of textbook systems, and the solver inside the graph."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from jounce.core.errors import AssemblyError
from jounce.mechanics import System
from jounce.mechanics.linear_algebra import Ldl


def evaluated(model, expression, x, u=(), p=(), m=()):
    function = ca.Function("f", [model.x, model.u, model.p, model.m], [expression])
    return function(ca.DM(list(x)), ca.DM(list(u)), ca.DM(list(p)), ca.DM(list(m))).full().ravel()


def pendulum():
    """Point of 2 kg on a rod of length l, angle from straight down, gravity along -z."""
    system = System()
    angle, length = system.coordinate("angle"), system.parameter("length")
    position = ca.vertcat(length * ca.sin(angle), 0, -length * ca.cos(angle))
    system.point_mass(ca.SX(2.0), position)
    system.force(position[2], ca.SX(-2.0 * 9.81))
    system.output("point.az", system.acceleration_of(position[2]), "m/s^2", "vertical acceleration")
    system.output("point.vz", system.rate_of(position[2]), "m/s", "vertical velocity")
    return system.finish()


@pytest.mark.parametrize("angle", [0.0, 0.3, 1.5, 3.0])
def test_pendulum(angle):
    """angle'' = -g/l sin(angle); the vertical acceleration holds the centripetal part."""
    rate, length = 1.3, 0.7
    model = pendulum()
    found = evaluated(model, model.rate, [angle, rate], p=[length])
    acceleration = -9.81 / length * np.sin(angle)
    assert found == pytest.approx([rate, acceleration], rel=1e-14, abs=1e-14)
    az, vz = evaluated(model, model.output, [angle, rate], p=[length])
    assert vz == pytest.approx(length * np.sin(angle) * rate)
    assert az == pytest.approx(length * (np.sin(angle) * acceleration + np.cos(angle) * rate**2))


def test_double_pendulum():
    """Two equal points on equal rods: the textbook mass matrix and velocity terms."""
    system = System()
    a, b = system.coordinate("a"), system.coordinate("b")
    first = ca.vertcat(ca.sin(a), -ca.cos(a))
    second = first + ca.vertcat(ca.sin(b), -ca.cos(b))
    for point in (first, second):
        system.point_mass(ca.SX(1.0), point)
        system.force(point[1], ca.SX(-9.81))
    system.output("a", a, "rad", "first")
    model = system.finish()
    x = [0.4, -1.1, 2.0, -0.5]
    cos, sin = np.cos(x[0] - x[1]), np.sin(x[0] - x[1])
    mass = np.array([[2.0, cos], [cos, 1.0]])
    load = np.array(
        [-sin * x[3] ** 2 - 2 * 9.81 * np.sin(x[0]), sin * x[2] ** 2 - 9.81 * np.sin(x[1])]
    )
    assert evaluated(model, model.rate, x)[2:] == pytest.approx(
        np.linalg.solve(mass, load), rel=1e-12
    )


def test_force_between_a_mass_and_a_track():
    """A damper to a moving base sees the base's rate."""
    system = System()
    z, base = system.coordinate("z"), system.track("road.z")
    system.point_mass(ca.SX(2.0), z)
    stretch = z - base.value
    system.force(stretch, -3.0 * system.rate_of(stretch))
    system.output("z", z, "m", "height")
    model = system.finish()
    assert evaluated(model, model.rate, [0.0, 5.0], u=[0.1, 7.0]) == pytest.approx(
        [5.0, -3.0 * (5.0 - 7.0) / 2.0]
    )
    assert model.tracks == ("road.z",)
    assert model.is_piecewise_linear()


def test_names_and_order():
    system = System()
    z, y = system.coordinate("z"), system.coordinate("y")
    w = system.internal_state("w")
    for q in (z, y):
        system.point_mass(ca.SX(1.0), q)
    k = system.parameter("k")
    assert system.parameter("k") is k
    mode = system.switch("contact", z - y)
    system.force(z, -k * z * mode)
    system.set_internal_rate("w", -3.0 * w)
    system.output("z", z, "m", "height")
    model = system.finish()
    assert model.states == ("z", "y", "vz", "vy", "w")
    assert (model.parameters, model.switches, model.internal) == (("k",), ("contact",), ("w",))
    assert evaluated(model, model.rate, [2.0, 1.0, 0.5, 0.6, 4.0], p=[10.0], m=[1.0]).tolist() == [
        0.5,
        0.6,
        -20.0,
        0.0,
        -12.0,
    ]
    assert evaluated(model, model.rate, [2.0, 1.0, 0.5, 0.6, 4.0], p=[10.0], m=[0.0])[2] == 0.0
    assert evaluated(model, model.switch, [2.0, 1.0, 0.0, 0.0, 0.0], p=[1.0], m=[0.0]).tolist() == [
        1.0
    ]
    assert model.is_piecewise_linear()


def test_nonlinear_is_seen():
    system = System()
    z = system.coordinate("z")
    system.point_mass(ca.SX(1.0), z)
    system.force(z, -(z**3))
    system.output("z", z, "m", "height")
    assert not system.finish().is_piecewise_linear()


def test_nonlinear_output_is_seen():
    system = System()
    z = system.coordinate("z")
    system.point_mass(ca.SX(1.0), z)
    system.force(z, -z)
    system.output("energy", z**2, "J", "energy")
    assert not system.finish().is_piecewise_linear()


@pytest.mark.parametrize("add", ["coordinate", "track", "internal_state"])
def test_a_name_is_used_once(add):
    system = System()
    getattr(system, add)("z")
    with pytest.raises(AssemblyError, match="z: the name is used twice"):
        getattr(system, add)("z")


def test_a_switch_is_named_once():
    system = System()
    system.switch("s", system.coordinate("z"))
    with pytest.raises(AssemblyError, match="twice"):
        system.switch("s", ca.SX(1.0))


def test_internal_state_without_rate():
    system = System()
    system.point_mass(ca.SX(1.0), system.coordinate("z"))
    system.internal_state("w")
    with pytest.raises(AssemblyError, match="w: an internal state has no rate"):
        system.finish()


def test_no_coordinates():
    with pytest.raises(AssemblyError, match="without coordinates"):
        System().finish()


@given(st.integers(1, 6), st.integers(0, 2**32 - 1))
def test_solver_inside_the_graph(size, seed):
    generator = np.random.default_rng(seed)
    root = generator.normal(size=(size, size))
    matrix, rhs = root @ root.T + size * np.eye(size), generator.normal(size=(size, 2))
    symbol = ca.SX.sym("A", size, size)
    solve = ca.Function("solve", [symbol], [Ldl(symbol).solve(ca.SX(rhs))])
    np.testing.assert_allclose(
        solve(matrix).full(), np.linalg.solve(matrix, rhs), rtol=1e-9, atol=1e-12
    )


def test_solver_keeps_zeros():
    """A diagonal mass matrix costs a division a row, no more."""
    diagonal = ca.SX.sym("d", 5)
    solve = ca.Function("solve", [diagonal], [Ldl(ca.diag(diagonal)).solve(ca.SX.ones(5, 1))])
    assert solve.n_nodes() <= 3 * 5 + 1
