"""Mass properties of shapes against closed forms and against each other."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.mechanics.mass import SolidMass, check_inertia

DENSITY = 7850.0
SIZE, CENTRE = (0.2, 0.3, 0.1), (0.4, -0.1, 0.25)


def close(one: SolidMass, other: SolidMass, tolerance: float = 1e-12) -> None:
    assert one.mass == pytest.approx(other.mass, rel=tolerance)
    np.testing.assert_allclose(one.centre_of_mass, other.centre_of_mass, rtol=0.0, atol=tolerance)
    size = np.max(np.abs(other.inertia))
    np.testing.assert_allclose(one.inertia, other.inertia, rtol=0.0, atol=tolerance * size)


def block(size=SIZE, centre=CENTRE):
    """Corners and outward triangles of a block."""
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    vertices = np.array(centre) + (corners - 0.5) * np.array(size)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    faces = np.array([(a, b, c) for a, b, c, _ in quads] + [(a, c, d) for a, _, c, d in quads])
    return vertices, faces


def test_box_is_integrated_over_its_volume():
    """Gauss-Legendre with three points a direction is exact for these integrals."""
    nodes, weights = np.polynomial.legendre.leggauss(3)
    points = [np.array(CENTRE)[i] + 0.5 * np.array(SIZE)[i] * nodes for i in range(3)]
    x, y, z = np.meshgrid(*points, indexing="ij")
    w = DENSITY * np.prod(SIZE) / 8.0 * np.einsum("i,j,k->ijk", weights, weights, weights)
    found = jn.mechanics.box(DENSITY, SIZE, CENTRE)
    assert found.mass == pytest.approx(np.sum(w))
    dx, dy, dz = x - CENTRE[0], y - CENTRE[1], z - CENTRE[2]
    tensor = [
        [dy**2 + dz**2, -dx * dy, -dx * dz],
        [-dx * dy, dx**2 + dz**2, -dy * dz],
        [-dx * dz, -dy * dz, dx**2 + dy**2],
    ]
    np.testing.assert_allclose(
        found.inertia, np.sum(np.array(tensor) * w, axis=(2, 3, 4)), rtol=0.0, atol=1e-12
    )


def test_sphere_and_cylinder_have_textbook_moments():
    ball = jn.mechanics.sphere(1000.0, 0.1, CENTRE)
    assert ball.mass == pytest.approx(4.1887902, rel=1e-7)
    close(jn.mechanics.sphere("1 g/cm^3", "100 mm", CENTRE), ball)
    np.testing.assert_allclose(ball.inertia, 0.4 * ball.mass * 0.01 * np.eye(3), rtol=1e-14)
    bar = jn.mechanics.cylinder(1000.0, 0.05, (0.1, 0.0, 0.0), (0.5, 0.0, 0.0))
    mass = 1000.0 * np.pi * 0.05**2 * 0.4
    across = mass * (3.0 * 0.05**2 + 0.4**2) / 12.0
    close(
        bar,
        SolidMass(mass, np.array([0.3, 0.0, 0.0]), np.diag([0.5 * mass * 0.05**2, across, across])),
    )


def test_tube_is_a_bar_less_its_bore():
    start, end = (0.1, 0.2, 0.3), (0.4, -0.2, 0.5)
    tube = jn.mechanics.tube(DENSITY, 0.02, 0.03, start, end)
    bore = jn.mechanics.cylinder(DENSITY, 0.02, start, end)
    close(jn.mechanics.combine_solids(tube, bore), jn.mechanics.cylinder(DENSITY, 0.03, start, end))


def test_bar_turns_its_inertia_along():
    straight = jn.mechanics.cylinder(DENSITY, 0.02, (0.0, 0.0, 0.0), (0.0, 0.0, 0.5))
    a, b = np.radians(35.0), np.radians(-50.0)
    turn = np.array([[np.cos(a), -np.sin(a), 0.0], [np.sin(a), np.cos(a), 0.0], [0.0, 0.0, 1.0]])
    turn = turn @ np.array(
        [[np.cos(b), 0.0, np.sin(b)], [0.0, 1.0, 0.0], [-np.sin(b), 0.0, np.cos(b)]]
    )
    tilted = jn.mechanics.cylinder(DENSITY, 0.02, (0.0, 0.0, 0.0), turn @ [0.0, 0.0, 0.5])
    close(
        tilted,
        SolidMass(straight.mass, turn @ straight.centre_of_mass, turn @ straight.inertia @ turn.T),
    )


def test_halves_make_the_whole():
    left = jn.mechanics.box(DENSITY, (0.1, 0.3, 0.1), (0.35, -0.1, 0.25))
    right = jn.mechanics.box(DENSITY, (0.1, 0.3, 0.1), (0.45, -0.1, 0.25))
    close(jn.mechanics.combine_solids(left, right), jn.mechanics.box(DENSITY, SIZE, CENTRE))


def test_mesh_of_a_block_is_the_block(tmp_path):
    trimesh = pytest.importorskip("trimesh")
    close(jn.mechanics.mesh(DENSITY, block()), jn.mechanics.box(DENSITY, SIZE, CENTRE))
    vertices, faces = block()
    file = tmp_path / "block.stl"
    trimesh.Trimesh(vertices=1000.0 * vertices, faces=faces).export(file)
    close(
        jn.mechanics.mesh(DENSITY, file, scale=1e-3),
        jn.mechanics.box(DENSITY, SIZE, CENTRE),
        tolerance=1e-6,
    )
    ball = trimesh.creation.icosphere(subdivisions=4, radius=0.1)
    close(
        jn.mechanics.mesh(DENSITY, (ball.vertices, ball.faces)),
        jn.mechanics.sphere(DENSITY, 0.1, (0, 0, 0)),
        5e-3,
    )


def test_open_and_inside_out_meshes_are_refused(tmp_path):
    pytest.importorskip("trimesh")
    vertices, faces = block()
    with pytest.raises(jn.AssemblyError, match=r"does not enclose a volume.*11 faces"):
        jn.mechanics.mesh(DENSITY, (vertices, faces[:-1]))
    with pytest.raises(jn.AssemblyError, match=r"does not enclose a volume.*volume -0\.006"):
        jn.mechanics.mesh(DENSITY, (vertices, faces[:, ::-1]))
    with pytest.raises(jn.JounceError, match=r"nowhere\.stl"):
        jn.mechanics.mesh(DENSITY, tmp_path / "nowhere.stl")
    broken = tmp_path / "broken.stl"
    broken.write_text("the surface cannot be read", encoding="utf-8")
    with pytest.raises(jn.JounceError, match=r"broken\.stl"):
        jn.mechanics.mesh(DENSITY, broken)
    with pytest.raises(jn.JounceError, match=r"block\.what"):
        jn.mechanics.mesh(DENSITY, tmp_path / "block.what")


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (lambda: jn.mechanics.box(-1.0, SIZE, CENTRE), "invalid density; found '-1 kg"),
        (lambda: jn.mechanics.box(1.0, (0.1, 0.0, 0.1), CENTRE), "invalid size; found '0 m'"),
        (lambda: jn.mechanics.box(1.0, (0.1, 0.1), CENTRE), "size"),
        (lambda: jn.mechanics.box(1.0, SIZE, (0.0, 0.0)), "centre"),
        (lambda: jn.mechanics.box(1.0, SIZE, (0.0, 0.0, float("nan"))), "centre"),
        (lambda: jn.mechanics.sphere(1.0, float("nan"), CENTRE), "radius: not a finite number"),
        (
            lambda: jn.mechanics.tube(1.0, 0.2, 0.1, (0, 0, 0), (1, 0, 0)),
            "invalid inner radius; found '0.2 m'",
        ),
        (
            lambda: jn.mechanics.cylinder(1.0, 0.1, (0, 0, 0), (0, 0, 0)),
            "invalid distance of the ends; found '0 m'",
        ),
        (jn.mechanics.combine_solids, "nothing to combine"),
    ],
)
def test_shapes_that_are_none(make, text):
    with pytest.raises(jn.JounceError, match=text):
        make()


def test_triangle_inequality_of_moments():
    check_inertia("plate", 1.0, np.diag([1.0, 2.0, 3.0]))
    check_inertia("point", 1.0, np.zeros((3, 3)))
    with pytest.raises(jn.AssemblyError, match=r"plate: impossible inertia.*1, 2, 3.1 kg m\^2"):
        check_inertia("plate", 1.0, np.diag([1.0, 2.0, 3.1]))
    with pytest.raises(jn.AssemblyError, match="impossible inertia"):  # a product too large
        check_inertia("plate", 1.0, np.array([[1.0, 1.1, 0.0], [1.1, 1.0, 0.0], [0.0, 0.0, 1.5]]))


def test_solids_go_into_mechanisms():
    solid = jn.mechanics.combine_solids(
        jn.mechanics.cylinder(DENSITY, 0.01, (0.0, 0.0, 0.0), (0.5, 0.0, 0.0)),
        jn.mechanics.sphere(DENSITY, 0.04, (0.5, 0.0, 0.0)),
    )
    mechanism = jn.mechanics.Mechanism()
    body = mechanism.body("bob", *solid.arguments)
    assert mechanism.values["bob.mass"] == solid.mass
    assert mechanism.values["bob.inertia.yy"] == solid.inertia[1, 1]
    tensor = mechanism.body("same", solid.mass, solid.centre_of_mass, solid.inertia)
    assert tensor.name == "same"
    assert mechanism.values["same.inertia.yy"] == solid.inertia[1, 1]
    assert body.mass_properties is not None
