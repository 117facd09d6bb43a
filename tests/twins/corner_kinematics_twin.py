"""Readable twin of the corner kinematics: one rigid upright held by constraint equations, NumPy only.

It is the oracle of the kinematic sweeps and shares no code with jounce: plain points (m, left side, x forward, y left,
z up) go in. The upright is one rigid body with six unknowns: displacement ``t`` of the wheel centre and a rotation
vector. Five scalar constraints hold it, the sixth row is the drive, wheel-centre height:

    rod       |outer - inner| = design length
    slider    the body's strut top stays on the upright's strut axis (two rows)
    hinge     a point of the pivot axis stays where it is (three rows) and so does its direction (two rows)

Velocities come from the same rows, linear in the twist (velocity of the wheel centre, angular velocity), with one more
row that says what moves: v_z = 1 at the wheel centre (or at the contact point). Accelerations (for the change of the
motion ratio) come from the rows differentiated once more. No finite differences anywhere.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from math import asin, atan2, cos, sin

import numpy as np

UP = np.array([0.0, 0.0, 1.0])


def unit(v):
    return v / np.linalg.norm(v)


def rotation(r) -> np.ndarray:
    """Matrix of a rotation vector (Rodrigues)."""
    angle = np.linalg.norm(r)
    cross = np.cross(np.eye(3), np.asarray(r))
    if angle < 1e-9:
        return np.eye(3) + cross + cross @ cross / 2.0
    return np.eye(3) + sin(angle) / angle * cross + (1.0 - cos(angle)) / angle**2 * cross @ cross


class Rod:
    """Constant distance between a point of the body and one of the upright; ``shift`` moves the inner point."""

    def __init__(self, inner, outer) -> None:
        self.inner, self.outer = np.array(inner, float), np.array(outer, float)
        self.square = np.sum((self.outer - self.inner) ** 2)
        self.shift = np.zeros(3)

    def residual(self, pose):
        d = pose.at(self.outer) - self.inner - self.shift
        return [(d @ d - self.square) / 2.0]

    def rows(self, pose):
        d, arm = pose.at(self.outer) - self.inner - self.shift, pose.arm(self.outer)
        return [[*d, *np.cross(arm, d)]]

    def quadratic(self, pose, v, w):
        """What ``rows @ twist'`` must be so that the rate of the constraint stays zero."""
        d, arm = pose.at(self.outer) - self.inner - self.shift, pose.arm(self.outer)
        rate = v + np.cross(w, arm)
        return [-(rate @ rate) - d @ np.cross(w, np.cross(w, arm))]


class Slider:
    """A point ``top`` of the body stays on the line through ``bottom`` and ``top`` of the upright."""

    def __init__(self, bottom, top) -> None:
        self.bottom, self.top = np.array(bottom, float), np.array(top, float)
        axis = unit(self.top - self.bottom)
        side = unit(np.cross(axis, [1.0, 0.0, 0.0]))
        self.normals = side, np.cross(axis, side)

    def residual(self, pose):
        return [(pose.turned(n)) @ (self.top - pose.at(self.bottom)) for n in self.normals]

    def rows(self, pose):
        arm, out = pose.arm(self.bottom), []
        for normal in self.normals:
            n = pose.turned(normal)
            d = self.top - pose.at(self.bottom)
            out.append([*-n, *(np.cross(n, d) - np.cross(arm, n))])
        return out

    def quadratic(self, pose, v, w):
        arm, out = pose.arm(self.bottom), []
        rate = v + np.cross(w, arm)
        for normal in self.normals:
            n, d = pose.turned(normal), self.top - pose.at(self.bottom)
            turn = np.cross(w, n)
            out.append(
                -(np.cross(w, turn) @ d) + 2.0 * turn @ rate + n @ np.cross(w, np.cross(w, arm))
            )
        return out


class Hinge:
    """Two points of the pivot axis stay where they are (the second only across the axis)."""

    def __init__(self, inner, outer) -> None:
        self.first, self.second = np.array(inner, float), np.array(outer, float)
        axis = unit(self.second - self.first)
        side = unit(np.cross(axis, [1.0, 0.0, 0.0]))
        self.pairs = [(self.first, e) for e in np.eye(3)] + [
            (self.second, side),
            (self.second, np.cross(axis, side)),
        ]

    def residual(self, pose):
        return [e @ (pose.at(p) - p) for p, e in self.pairs]

    def rows(self, pose):
        return [[*e, *np.cross(pose.arm(p), e)] for p, e in self.pairs]

    def quadratic(self, pose, _, w):
        return [-e @ np.cross(w, np.cross(w, pose.arm(p))) for p, e in self.pairs]


@dataclass(frozen=True)
class Pose:
    """Place of the upright: displacement of its wheel centre and rotation matrix."""

    centre: np.ndarray
    t: np.ndarray
    R: np.ndarray

    def at(self, p):
        return self.centre + self.t + self.arm(p)

    def arm(self, p):
        """From the wheel centre to the point, turned."""
        return self.R @ (np.asarray(p) - self.centre)

    def turned(self, direction):
        return self.R @ direction


@dataclass
class Motion:
    """First and second derivative of everything with respect to the travel of one point."""

    v: np.ndarray
    w: np.ndarray
    a: np.ndarray
    alpha: np.ndarray

    def velocity(self, arm):
        return self.v + np.cross(self.w, arm)

    def acceleration(self, arm):
        return self.a + np.cross(self.alpha, arm) + np.cross(self.w, np.cross(self.w, arm))


@dataclass
class Corner:
    """A left corner: constraints, wheel, steering axis and spring.

    ``axis`` is a pair (lower, upper) of places of points, each ("upright" | "body", point). ``spring`` is a pair
    (lower, upper) of the same kind, where the first word may also be "arm": the arm turns about the line ``arm[0]``,
    ``arm[1]`` and carries the upright's point ``arm[2]``.
    """

    constraints: list
    wheel_centre: tuple
    radius: float
    spring: tuple
    axis: tuple | None = None
    arm: tuple | None = None
    camber: float = 0.0
    toe: float = 0.0
    steered: object = None
    spin: np.ndarray = field(init=False)

    def __post_init__(self) -> None:
        self.centre = np.array(self.wheel_centre, float)
        c = cos(self.camber)
        self.spin = np.array([sin(self.toe) * c, cos(self.toe) * c, -sin(self.camber)])

    # --- position ---------------------------------------------------------------------------------------------

    def pose(self, travel: float, rack: float = 0.0, step: float = 2e-3) -> Pose:
        """Pose at a wheel-centre travel (m) and rack travel (m), followed from the design position."""
        pose = Pose(self.centre, np.zeros(3), np.eye(3))
        count = max(1, int(np.ceil(max(abs(travel), abs(rack)) / step)))
        for fraction in np.linspace(0.0, 1.0, count + 1):
            pose = self._newton(pose, fraction * travel, fraction * rack)
        return pose

    def _newton(self, pose: Pose, travel: float, rack: float) -> Pose:
        if self.steered is not None:
            self.steered.shift = np.array([0.0, rack, 0.0])
        for _ in range(30):
            residual = [f for c in self.constraints for f in c.residual(pose)] + [
                pose.t[2] - travel
            ]
            move = np.linalg.solve(self._matrix(pose, np.zeros(3)), -np.array(residual))
            pose = Pose(self.centre, pose.t + move[:3], rotation(move[3:]) @ pose.R)
            if np.abs(move).max() < 1e-15:
                break
        assert np.abs(residual).max() < 1e-13, "the pose was not reached"
        left, _, right = np.linalg.svd(pose.R)
        return Pose(self.centre, pose.t, left @ right)

    def _matrix(self, pose: Pose, arm) -> np.ndarray:
        """Constraint rows and the row that gives v_z of the point at ``arm`` from the wheel centre."""
        rows = [row for c in self.constraints for row in c.rows(pose)]
        return np.array([*rows, [*UP, *np.cross(arm, UP)]])

    # --- motion -----------------------------------------------------------------------------------------------

    def motion(self, pose: Pose, arm=(0.0, 0.0, 0.0)) -> Motion:
        """Derivatives with respect to the height of the upright's point at ``arm`` from the wheel centre."""
        arm = np.asarray(arm, float)
        matrix = self._matrix(pose, arm)
        twist = np.linalg.solve(matrix, [0.0] * 5 + [1.0])
        v, w = twist[:3], twist[3:]
        right = [q for c in self.constraints for q in c.quadratic(pose, v, w)]
        second = np.linalg.solve(matrix, [*right, -np.cross(w, np.cross(w, arm))[2]])
        return Motion(v, w, second[:3], second[3:])

    def steering_motion(self, pose: Pose) -> tuple[np.ndarray, np.ndarray]:
        """Twist per metre of rack at constant wheel-centre height."""
        right = np.zeros(6)
        index = 0
        for c in self.constraints:
            if c is self.steered:
                right[index] = c.rows(pose)[0][1]
            index += len(c.rows(pose))
        twist = np.linalg.solve(self._matrix(pose, np.zeros(3)), right)
        return twist[:3], twist[3:]

    # --- places of points of the spring and of the steering axis -----------------------------------------------

    def place(self, where: str, point, pose: Pose, motion: Motion | None = None):
        """Position, and with a motion also velocity and acceleration, of a point of the upright, arm or body."""
        point = np.asarray(point, float)
        if where == "body":
            return point, np.zeros(3), np.zeros(3)
        motion = motion or Motion(*np.zeros((4, 3)))
        if where == "upright":
            arm = pose.arm(point)
            return pose.at(point), motion.velocity(arm), motion.acceleration(arm)
        first, second, carried = (np.asarray(p, float) for p in self.arm)
        e = unit(second - first)
        before, now = carried - first, pose.at(carried) - first
        flat = before - e * (e @ before)
        angle = atan2(np.cross(e, flat) @ now, flat @ now)
        arm = rotation(angle * e) @ (point - first)
        lever, outer = np.cross(e, now), pose.arm(carried)
        rate = motion.velocity(outer) @ lever / (lever @ lever)
        second_rate = motion.acceleration(outer) @ lever / (lever @ lever)
        across = np.cross(e, arm)
        return first + arm, rate * across, second_rate * across + rate**2 * np.cross(e, across)

    def spring_length(self, pose: Pose, motion: Motion) -> tuple[float, float, float]:
        """Length of the spring, its first and its second derivative with respect to travel."""
        (p0, v0, a0), (p1, v1, a1) = (self.place(*end, pose, motion) for end in self.spring)
        d, v, a = p1 - p0, v1 - v0, a1 - a0
        length = np.linalg.norm(d)
        rate = d @ v / length
        return length, rate, (v @ v + d @ a - rate**2) / length

    def _contact_bend(self, m: Motion, spin, to_contact, rate: float, bend: float) -> float:
        """Change of d(length)/dz at the contact point per height of that point, which wanders over the tyre."""
        raw, turn = -UP + spin * spin[2], np.cross(m.w, spin)
        drift = turn * spin[2] + spin * turn[2]
        down = raw / np.linalg.norm(raw)
        wander = self.radius * (drift - down * (down @ drift)) / np.linalg.norm(raw)
        gain = m.velocity(to_contact)[2]
        change = (m.a + np.cross(m.alpha, to_contact) + np.cross(m.w, wander))[2]
        return (bend * gain - rate * change) / gain**3

    def arm_angle(self, pose: Pose) -> float:
        first, second, carried = (np.asarray(p, float) for p in self.arm)
        e = unit(second - first)
        before, now = carried - first, pose.at(carried) - first
        flat = before - e * (e @ before)
        return atan2(np.cross(e, flat) @ now, flat @ now)

    # --- the catalogue ----------------------------------------------------------------------------------------

    def quantities(
        self, travel: float, rack: float = 0.0, spring_rate: float = 0.0, spring_force: float = 0.0
    ) -> dict:
        """Every kinematic quantity at one travel, SI and radians."""
        pose = self.pose(travel, rack)
        spin = pose.turned(self.spin)
        down = unit(-UP + spin * spin[2])
        to_contact = self.radius * down
        centre, contact = pose.at(self.centre), pose.at(self.centre) + to_contact
        m, c = self.motion(pose), self.motion(pose, to_contact)
        patch, wheel = c.velocity(to_contact), m.v
        turn = np.cross(m.w, spin)
        length, rate, bend = self.spring_length(pose, m)
        _, rate_c, _ = self.spring_length(pose, c)
        bend_c = self._contact_bend(m, spin, to_contact, rate, bend)
        out = {
            "camber": -asin(spin[2]),
            "steer": atan2(-spin[0], spin[1]),
            "contact_point": contact,
            "wheel_centre": centre,
            "roll_centre_height": contact[1] * patch[1],
            "contact_dx_dz": patch[0],
            "contact_dy_dz": patch[1],
            "wheel_centre_dx_dz": wheel[0],
            "wheel_centre_dy_dz": wheel[1],
            "camber_gain": -turn[2] / np.sqrt(1.0 - spin[2] ** 2),
            "bump_steer": (spin[0] * turn[1] - spin[1] * turn[0]) / (spin[0] ** 2 + spin[1] ** 2),
            "front_instant_centre_y": contact[1] - 1.0 / c.w[0],
            "front_instant_centre_z": contact[2] + patch[1] / c.w[0],
            "front_view_swing_arm_length": 1.0 / c.w[0],
            "side_instant_centre_x": contact[0] + 1.0 / c.w[1],
            "side_instant_centre_z": contact[2] - patch[0] / c.w[1],
            "side_view_swing_arm_length": 1.0 / c.w[1],
            "spring_length": length,
            "motion_ratio": -rate,
            "motion_ratio_contact": -rate_c,
            "motion_ratio_gradient": -bend,
            "motion_ratio_gradient_contact": -bend_c,
            "wheel_rate_spring": spring_rate * rate**2,
            "wheel_rate": spring_rate * rate**2 - spring_force * bend,
            "wheel_rate_spring_contact": spring_rate * rate_c**2,
            "wheel_rate_contact": spring_rate * rate_c**2 - spring_force * bend_c,
        }
        if self.axis is not None:
            out |= self._axis_quantities(pose, m, centre, contact)
        return out

    def _axis_quantities(self, pose: Pose, m: Motion, centre, contact) -> dict:
        (low, v_low, _), (high, v_high, _) = (self.place(*end, pose, m) for end in self.axis)
        k, dk = high - low, v_high - v_low
        ground = low + k * (contact[2] - low[2]) / k[2]
        level = low + k * (centre[2] - low[2]) / k[2]
        return {
            "caster": atan2(-k[0], k[2]),
            "kingpin_inclination": atan2(-k[1], k[2]),
            "caster_gain": (k[0] * dk[2] - k[2] * dk[0]) / (k[0] ** 2 + k[2] ** 2),
            "caster_trail": ground[0] - contact[0],
            "scrub_radius": contact[1] - ground[1],
            "spindle_offset": centre[1] - level[1],
            "wheel_centre_caster_offset": centre[0] - level[0],
        }

    def virtual_axis(self, pose: Pose) -> tuple[np.ndarray, np.ndarray]:
        """Axis of the pure turn that rack and travel make, of two the one with less travel: point, direction up."""
        v, w = self.steering_motion(pose)
        lift = self.motion(pose)
        roots = np.roots([lift.w @ lift.v, w @ lift.v + lift.w @ v, w @ v])
        share = min(roots[np.isreal(roots)].real, key=abs)
        v, w = v + share * lift.v, w + share * lift.w
        direction = w / np.linalg.norm(w)
        point = pose.at(self.centre) + np.cross(w, v) / (w @ w)
        return point, direction * np.sign(direction[2])

    def contact_loads(self, travel: float, force, torque=(0.0, 0.0, 0.0)) -> dict:
        """Static loads under a force (N) and torque (N m) on the upright at the contact point; no masses, gravity.

        The five constraints and the spring hold the upright: their multipliers follow from virtual work. What the arms
        (with the spring on one of them) and the rods do to the upright is a force at each outer point. Given back:
        {"spring_force" (compression positive), "multipliers", "on_upright": {outer point: force}}.
        """
        pose = self.pose(travel)
        spin = pose.turned(self.spin)
        arm = self.radius * unit(-UP + spin * spin[2])
        matrix = self._matrix(pose, np.zeros(3))
        twists = (Motion(twist[:3], twist[3:], np.zeros(3), np.zeros(3)) for twist in np.eye(6))
        matrix[5] = [self.spring_length(pose, twist)[1] for twist in twists]
        wrench = np.array([*force, *(np.asarray(torque) + np.cross(arm, force))])
        multipliers = np.linalg.solve(matrix.T, -wrench)
        on_upright: dict[tuple, np.ndarray] = {}
        index = 0
        for c in self.constraints:
            if isinstance(c, Rod):
                push = multipliers[index] * np.array(c.rows(pose)[0][:3])
                on_upright[tuple(c.outer)] = on_upright.get(tuple(c.outer), np.zeros(3)) + push
            index += len(c.rows(pose))
        if self.spring[0][0] == "arm":
            on_upright[tuple(self.arm[2])] += multipliers[5] * matrix[5][:3]
        return {
            "spring_force": multipliers[5],
            "multipliers": multipliers[:5],
            "on_upright": on_upright,
        }


# --- the four templates, from named hardpoints (m) ------------------------------------------------------------------


def double_wishbone(
    h: dict, radius: float, camber: float = 0.0, toe: float = 0.0, strut_on="lower_arm"
) -> Corner:
    rod = Rod(h["tie_rod_inner"], h["tie_rod_outer"])
    arms = [
        Rod(h[f"{a}_arm_{e}"], h[f"{a}_ball_joint"])
        for a in ("lower", "upper")
        for e in ("front", "rear")
    ]
    axis = ("upright", h["lower_ball_joint"]), ("upright", h["upper_ball_joint"])
    side = strut_on.removesuffix("_arm") if strut_on != "upright" else "lower"
    arm = h[f"{side}_arm_front"], h[f"{side}_arm_rear"], h[f"{side}_ball_joint"]
    spring = (
        ("upright" if strut_on == "upright" else "arm", h["strut_bottom"]),
        ("body", h["strut_top"]),
    )
    return Corner([*arms, rod], h["wheel_centre"], radius, spring, axis, arm, camber, toe, rod)


def mcpherson(h: dict, radius: float, camber: float = 0.0, toe: float = 0.0) -> Corner:
    rod = Rod(h["tie_rod_inner"], h["tie_rod_outer"])
    arms = [Rod(h[f"lower_arm_{e}"], h["lower_ball_joint"]) for e in ("front", "rear")]
    spring = (
        ("upright", h.get("spring_bottom", h["strut_bottom"])),
        ("body", h.get("spring_top", h["strut_top"])),
    )
    axis = ("upright", h["lower_ball_joint"]), ("body", h["strut_top"])
    slider = Slider(h["strut_bottom"], h["strut_top"])
    return Corner(
        [*arms, slider, rod], h["wheel_centre"], radius, spring, axis, None, camber, toe, rod
    )


def five_link(h: dict, radius: float, camber: float = 0.0, toe: float = 0.0) -> Corner:
    rods = [Rod(h[f"link_{i}_inner"], h[f"link_{i}_outer"]) for i in range(1, 6)]
    spring = ("upright", h["strut_bottom"]), ("body", h["strut_top"])
    return Corner(rods, h["wheel_centre"], radius, spring, None, None, camber, toe, rods[4])


def trailing_arm(h: dict, radius: float, camber: float = 0.0, toe: float = 0.0) -> Corner:
    spring = ("upright", h["strut_bottom"]), ("body", h["strut_top"])
    hinge = Hinge(h["arm_inner"], h["arm_outer"])
    return Corner([hinge], h["wheel_centre"], radius, spring, None, None, camber, toe)
