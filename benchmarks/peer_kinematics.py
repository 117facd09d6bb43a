"""Travel sweep of a double wishbone with SciPy: ``fsolve`` on five rods and the drive, metrics in vectorised NumPy.

No suspension package that could serve as a peer installs today: the one on the public index (pymycar) solves fifteen
point coordinates per pose with the same ``fsolve``, without a Jacobian, and writes files at every sweep. Here the pose
has six unknowns and an exact Jacobian, which is the quicker form; velocities come from the same Jacobian in one batch.
"""

from __future__ import annotations

from collections.abc import Callable
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
MILLIMETRES = {
    "lower_arm_front": (150, 400, 155),
    "lower_arm_rear": (-150, 400, 145),
    "lower_ball_joint": (5, 720, 140),
    "upper_arm_front": (110, 450, 385),
    "upper_arm_rear": (-130, 450, 365),
    "upper_ball_joint": (-15, 690, 400),
    "tie_rod_inner": (-130, 380, 185),
    "tie_rod_outer": (-120, 700, 180),
    "wheel_centre": (0, 760, 300),
    "strut_bottom": (0, 640, 150),
    "strut_top": (10, 520, 520),
}
POINTS = {name: np.array(point) * 1e-3 for name, point in MILLIMETRES.items()}
RADIUS, CAMBER = 0.3, np.radians(-1.0)
TRAVELS = np.linspace(-0.08, 0.08, 41)

INNER = np.array(
    [POINTS[f"{a}_arm_{e}"] for a in ("lower", "upper") for e in ("front", "rear")]
    + [POINTS["tie_rod_inner"]]
)
ENDS = (
    "lower_ball_joint",
    "lower_ball_joint",
    "upper_ball_joint",
    "upper_ball_joint",
    "tie_rod_outer",
)
OUTER = np.array([POINTS[name] for name in ENDS])
CENTRE, SPIN = POINTS["wheel_centre"], np.array([0.0, np.cos(CAMBER), -np.sin(CAMBER)])
LOCAL = OUTER - CENTRE
SQUARES = np.sum((OUTER - INNER) ** 2, axis=1)


def _matrix(r: Array) -> Array:
    """Rotation by z-y-x angles."""
    (cx, cy, cz), (sx, sy, sz) = np.cos(r), np.sin(r)
    return np.array(
        [
            [cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx],
            [sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx],
            [-sy, cy * sx, cy * cx],
        ]
    )


def _rates(r: Array) -> Array:
    """Angular velocity per rate of each angle, as columns."""
    (_, cy, cz), (_, sy, sz) = np.cos(r), np.sin(r)
    return np.array([[cz * cy, -sz, 0.0], [sz * cy, cz, 0.0], [-sy, 0.0, 1.0]])


def poses() -> Array:
    """Unknowns (wheel centre, angles) at every travel, shape (41, 6); followed outwards from the design position."""
    from scipy.optimize import fsolve

    def residual(x: Array, height: float) -> Array:
        d = x[:3] + LOCAL @ _matrix(x[3:]).T - INNER
        return np.append(np.einsum("ij,ij->i", d, d) - SQUARES, x[2] - height)

    def jacobian(x: Array, _: float) -> Array:
        arms = LOCAL @ _matrix(x[3:]).T
        d = x[:3] + arms - INNER
        out = np.zeros((6, 6))
        out[:5, :3] = 2.0 * d
        out[:5, 3:] = 2.0 * np.cross(arms, d) @ _rates(x[3:])
        out[5, 2] = 1.0
        return out

    out, middle = np.empty((len(TRAVELS), 6)), len(TRAVELS) // 2
    for order in (range(middle, len(TRAVELS)), range(middle - 1, -1, -1)):
        x = np.append(CENTRE, np.zeros(3)) if order.step == 1 else out[middle]
        for i in order:
            x = fsolve(residual, x, args=(CENTRE[2] + TRAVELS[i],), fprime=jacobian, xtol=1e-12)
            out[i] = x
    return out


def metrics(x: Array) -> dict[str, Array]:
    """The usual quantities for all poses at once."""
    R = np.array([_matrix(r) for r in x[:, 3:]])
    centre = x[:, :3]
    arms = np.einsum("nij,kj->nki", R, LOCAL)
    d = centre[:, None] + arms - INNER
    spin = R @ SPIN
    down = spin * spin[:, 2:] - np.array([0.0, 0.0, 1.0])
    reach = RADIUS * down / np.linalg.norm(down, axis=1)[:, None]
    contact = centre + reach
    rows = np.zeros((len(x), 6, 6))
    rows[:, :5, :3], rows[:, :5, 3:], rows[:, 5, 2] = d, np.cross(arms, d), 1.0
    twist = np.linalg.solve(rows, np.tile(np.eye(6)[:, 5:], (len(x), 1, 1)))[:, :, 0]
    v, w = twist[:, :3], twist[:, 3:]
    low, high = centre + arms[:, 0], centre + arms[:, 2]
    k = high - low
    ground = low + k * ((contact[:, 2] - low[:, 2]) / k[:, 2])[:, None]
    patch = v + np.cross(w, reach)
    patch = patch / patch[:, 2:]
    turn = np.cross(w, spin)
    length, ratio = _spring(low, v + np.cross(w, arms[:, 0]))
    return {
        "camber": -np.arcsin(spin[:, 2]),
        "steer": np.arctan2(-spin[:, 0], spin[:, 1]),
        "caster": np.arctan2(-k[:, 0], k[:, 2]),
        "kingpin_inclination": np.arctan2(-k[:, 1], k[:, 2]),
        "caster_trail": ground[:, 0] - contact[:, 0],
        "scrub_radius": contact[:, 1] - ground[:, 1],
        "contact_point_y": contact[:, 1],
        "roll_centre_height": contact[:, 1] * patch[:, 1],
        "camber_gain": -turn[:, 2] / np.sqrt(1.0 - spin[:, 2] ** 2),
        "spring_length": length,
        "motion_ratio": ratio,
    }


def _spring(ball: Array, velocity: Array) -> tuple[Array, Array]:
    """Spring length and motion ratio from the lower ball joint, which turns the arm that carries the spring."""
    front, rear = POINTS["lower_arm_front"], POINTS["lower_arm_rear"]
    axis = (rear - front) / np.linalg.norm(rear - front)
    start, now = POINTS["lower_ball_joint"] - front, ball - front
    flat = start - axis * (axis @ start)
    angle = np.arctan2(now @ np.cross(axis, flat), now @ flat)
    arm = POINTS["strut_bottom"] - front
    along, across = axis * (axis @ arm), np.cross(axis, arm)
    place = along + np.cos(angle)[:, None] * (arm - along) + np.sin(angle)[:, None] * across
    lever = np.cross(axis, now)
    rate = np.einsum("ij,ij->i", velocity, lever) / np.einsum("ij,ij->i", lever, lever)
    d = front + place - POINTS["strut_top"]
    length = np.linalg.norm(d, axis=1)
    return length, -np.einsum("ij,ij->i", d, np.cross(axis, place)) * rate / length


def sweeps() -> dict[str, Callable[[], object]]:
    """What to time: the poses alone, and with eleven quantities."""
    return {
        "SciPy fsolve, poses": poses,
        "SciPy fsolve, poses and 11 quantities": lambda: metrics(poses()),
    }


if __name__ == "__main__":
    for name, run in sweeps().items():
        times = []
        for _ in range(21):
            begin = perf_counter()
            run()
            times.append(perf_counter() - begin)
        print(f"{name}: {1e3 * np.median(times):.1f} ms")
