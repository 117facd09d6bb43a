"""Rotations as expressions, against those of SciPy."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from jounce.mechanics.frames import AxisRotation
from jounce.mechanics.rotations import (
    matrix_quaternion,
    normals,
    quaternion_matrix,
    quaternion_rate,
    roll_pitch_yaw,
    rotation_vector,
    skew,
    unit,
)

AXES = np.array([(3, 0.2, 0.1), (0.1, -3, 0.3), (0.2, 0.3, 3), (1, 2, -1.5)])
TURNS = [
    Rotation.from_rotvec(angle * axis / np.linalg.norm(axis))
    for angle in (0.3, 2.9, -3.0)
    for axis in AXES
]


def first_scalar(turn: Rotation) -> np.ndarray:
    x, y, z, w = turn.as_quat(canonical=True)
    return np.array([w, x, y, z])


@pytest.mark.source(
    kind="program",
    key="scipy",
    of="mechanisms in space",
    where="scipy.spatial.transform.Rotation",
    tolerance="rounding; rates by differences of its rotations",
)
@pytest.mark.parametrize("turn", TURNS)
def test_quaternions_and_angles_of_a_rotation(turn: Rotation) -> None:
    matrix, e = ca.SX(turn.as_matrix()), first_scalar(turn)
    np.testing.assert_allclose(
        ca.DM(quaternion_matrix(ca.SX(e))), turn.as_matrix(), rtol=0.0, atol=1e-14
    )
    np.testing.assert_allclose(
        ca.DM(matrix_quaternion(matrix)).full().ravel(), e, rtol=0.0, atol=1e-14
    )
    roll, pitch, yaw = (float(ca.DM(angle)) for angle in roll_pitch_yaw(matrix))
    np.testing.assert_allclose(turn.as_euler("ZYX"), [yaw, pitch, roll], rtol=0.0, atol=1e-13)
    spin, h = np.array([0.3, -1.1, 0.7]), 1e-5  # in the body's own axes
    later, before = (
        first_scalar(turn * Rotation.from_rotvec(sign * h * spin)) for sign in (1.0, -1.0)
    )
    rate = ca.DM(quaternion_rate(ca.SX(e), ca.SX(spin))).full().ravel()
    np.testing.assert_allclose(rate, (later - before) / (2.0 * h), rtol=0.0, atol=1e-9)


@pytest.mark.source(
    kind="program",
    key="scipy",
    of="mechanisms in space",
    where="scipy.spatial.transform.Rotation",
    tolerance="rounding; rates by differences of its rotations",
)
@pytest.mark.parametrize("turn", TURNS)
def test_a_turn_about_an_axis(turn: Rotation) -> None:
    vector = turn.as_rotvec()
    angle = float(np.linalg.norm(vector))
    hinge = AxisRotation(ca.SX(vector / angle), ca.SX(angle), ca.SX(1.7))
    tensor = np.array([[2.0, 0.1, -0.3], [0.1, 3.0, 0.2], [-0.3, 0.2, 1.5]])
    matrix = turn.as_matrix()
    np.testing.assert_allclose(ca.DM(hinge.matrix), matrix, rtol=0.0, atol=1e-14)
    np.testing.assert_allclose(
        ca.DM(hinge.turned(ca.SX(tensor))), matrix @ tensor @ matrix.T, rtol=0.0, atol=1e-13
    )
    arm, w = np.array([0.4, -0.7, 1.1]), 1.7 * vector / angle
    followed = hinge.moving(ca.SX(arm))
    place = matrix @ arm
    for part, expected in ((followed.value, place), (followed.rate, np.cross(w, place)),
                           (followed.bias, np.cross(w, np.cross(w, place))), (hinge.rotate(ca.SX(arm)), place),
                           (hinge.unrotate(ca.SX(arm)), matrix.T @ arm), (hinge.ground_spin, w)):  # fmt: skip
        np.testing.assert_allclose(ca.DM(part).full().ravel(), expected, rtol=0.0, atol=1e-13)


@pytest.mark.parametrize(
    "axis", [(1, 0, 0), (0, 1, 0), (0, 0, 1), (0.1, 0.8, -0.6), (-0.8, 0.1, 0.6), (0.8, -0.6, 0.1)]
)
def test_normals_make_a_right_handed_frame_that_leans_on_the_farthest_axis(
    axis: tuple[float, ...],
) -> None:
    along = unit(ca.SX([*axis]))
    n1, n2 = (ca.DM(normal).full().ravel() for normal in normals(along))
    frame = np.column_stack((n1, n2, ca.DM(along).full().ravel()))
    np.testing.assert_allclose(frame.T @ frame, np.eye(3), rtol=0.0, atol=1e-14)
    assert np.linalg.det(frame) == pytest.approx(1.0)
    farthest = int(np.argmin(np.abs(axis)))
    assert n2[farthest] == pytest.approx(0.0, abs=1e-15)
    assert n1[farthest] > 0.7
    np.testing.assert_allclose(
        ca.DM(skew(along) @ ca.SX(n1)).full().ravel(), n2, rtol=0.0, atol=1e-14
    )


@pytest.mark.parametrize("angle", [0.0, 1e-14, 1e-6, 0.03, 0.0999, 0.1001, 0.7, 2.0, 3.0])
def test_a_rotation_vector_and_its_rate(angle: float) -> None:
    """The series below 0.1 rad and the closed form above it give SciPy's vector, and the rate of its differences."""
    matrix = ca.SX.sym("matrix", 3, 3)
    values = ca.Function("vector", [matrix], list(rotation_vector(matrix)))
    slopes = ca.Function(
        "slopes", [matrix], [ca.jacobian(ca.vec(part), matrix) for part in rotation_vector(matrix)]
    )
    spin, step = np.array([0.7, -1.1, 0.4]), 1e-4
    for axis in AXES:
        vector = angle * axis / np.linalg.norm(axis)
        turn = Rotation.from_rotvec(vector)
        found, rates = (np.array(part) for part in values(turn.as_matrix()))
        np.testing.assert_allclose(found.ravel(), vector, rtol=0.0, atol=1e-14)

        def moved(by: float, turn: Rotation = turn) -> np.ndarray:
            return (Rotation.from_rotvec(by * spin) * turn).as_rotvec()

        difference = (
            8.0 * (moved(step) - moved(-step)) - (moved(2.0 * step) - moved(-2.0 * step))
        ) / (12.0 * step)
        np.testing.assert_allclose(rates @ spin, difference, rtol=0.0, atol=1e-10)
        assert all(np.isfinite(np.array(part)).all() for part in slopes(turn.as_matrix()))
