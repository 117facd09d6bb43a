"""Every row of the kinematic catalogue from poses alone: places of points at many poses, and differences of them.

It knows where points are at design and at a grid of travels and racks, the numbers of springs and dampers, and nothing
of how jounce differentiates: slopes are differences of order eight, forces are slopes of energies, the motion of the
upright is the rotation between its points. That the poses are right is seen from what does not change in them: lengths
of links and shapes of bodies (``shape_errors``).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import cos, sin

import numpy as np

UP = np.array([0.0, 0.0, 1.0])
REACH = 4  # poses to either side of one for a difference of order eight
ORDERS = {1: (4 / 5, -1 / 5, 4 / 105, -1 / 280), 2: (8 / 5, -1 / 5, 8 / 315, -1 / 560)}
STEPS = 1.2e-3, 0.8e-3  # m of travel and of rack
BODIES = {  # points that keep their distances, by suspension
    "double-wishbone": [
        ("lower_arm_front", "lower_arm_rear", "lower_ball_joint"),
        ("upper_arm_front", "upper_arm_rear", "upper_ball_joint"),
        ("tie_rod_inner", "tie_rod_outer"),
        ("lower_ball_joint", "upper_ball_joint", "tie_rod_outer", "wheel_centre"),
    ],
    "mcpherson": [
        ("lower_arm_front", "lower_arm_rear", "lower_ball_joint"),
        ("tie_rod_inner", "tie_rod_outer"),
        ("lower_ball_joint", "tie_rod_outer", "wheel_centre", "strut_bottom"),
    ],
    "five-link": [
        *((f"link_{i}_inner", f"link_{i}_outer") for i in range(1, 6)),
        (*(f"link_{i}_outer" for i in range(1, 6)), "wheel_centre"),
    ],
    "trailing-arm": [("arm_inner", "arm_outer", "wheel_centre", "strut_bottom")],
}
FURTHER = [
    ("pushrod_outer", "pushrod_inner"),
    ("rocker_pivot", "rocker_axis", "pushrod_inner", "strut_bottom"),
    ("arb_pivot", "arb_arm_end"),
    ("arb_arm_end", "arb_link_end"),
]
UPRIGHT = {name: bodies[-1] for name, bodies in BODIES.items()}
AXES = {
    "double-wishbone": ("lower_ball_joint", "upper_ball_joint"),
    "mcpherson": ("lower_ball_joint", "strut_top"),
}


def unit(v):
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


def dot(a, b):
    return np.sum(a * b, axis=-1)


def slope(values, step: float, axis: int, order: int = 1):
    """Difference of order eight at all poses that have four neighbours on each side along an axis."""
    values = np.moveaxis(np.asarray(values), axis, 0)
    count = len(values)
    found = (-205.0 / 72.0 * values[REACH : count - REACH]) if order == 2 else 0.0
    sign = 1.0 if order == 2 else -1.0
    for k, weight in enumerate(ORDERS[order], start=1):
        ahead, behind = values[REACH + k : count - REACH + k], values[REACH - k : count - REACH - k]
        found = found + weight * (ahead + sign * behind)
    return np.moveaxis(found / step**order, 0, axis)


def turned_about(point, pivot, axis, design):
    """Angle of a point about an axis since design, rad, positive about it."""
    axis = unit(axis)
    now, then = point - pivot, design - pivot
    now, then = now - dot(now, axis)[..., None] * axis, then - dot(then, axis)[..., None] * axis
    return np.arctan2(dot(np.cross(then, now), axis), dot(then, now))


def angle_between(a, b):
    return np.arccos(np.clip(dot(unit(a), unit(b)), -1.0, 1.0))


@dataclass
class Screw:
    """Angular velocity, and velocity of the wheel centre."""

    w: np.ndarray
    v: np.ndarray

    def plus(self, share, other):
        return Screw(self.w + share[..., None] * other.w, self.v + share[..., None] * other.v)

    @property
    def pitch(self):
        return dot(self.w, self.v) / dot(self.w, self.w)

    def axis(self, centre):
        """Point and upward direction of the axis."""
        point = centre + np.cross(self.w, self.v) / dot(self.w, self.w)[..., None]
        return point, self.w * np.sign(self.w[..., 2:])


class FromPoses:
    """Rows at one travel and rack (m), from the places that ``swept`` holds around it; axes of a left wheel inside."""

    def __init__(self, rig, sweep_travel, travel: float, rack: float = 0.0, up=UP) -> None:
        self.up = np.asarray(up)  # out of the road, axes of a left wheel
        self.rig, self.side = rig, 1.0 if rig.side == "left" else -1.0
        self.steers = rig.model != "trailing-arm"
        travels = travel + STEPS[0] * np.arange(-2 * REACH, 2 * REACH + 1)
        racks = rack + STEPS[1] * np.arange(-REACH, REACH + 1)
        swept = (
            sweep_travel(rig, travels, racks, points=True)
            if self.steers
            else sweep_travel(rig, travels, points=True)
        )
        self.mirror = np.array([1.0, self.side, 1.0])
        self.points = {}
        for name in (*rig.hardpoints.given(), "contact_point"):
            place = (
                np.stack([swept[f"{name}.{axis}"].to_numpy() for axis in "xyz"], axis=-1)
                * self.mirror
            )
            self.points[name] = place if self.steers else place[:, None, :]
        self.design = {
            name: np.array(place) * self.mirror for name, place in rig.hardpoints.given().items()
        }

    # differences ----------------------------------------------------------------------------------------------

    def d(self, values, order: int = 1):
        """Slope along travel; two fewer reaches of poses are left."""
        return slope(values, STEPS[0], 0, order)

    def r(self, values):
        """Slope along the rack at constant height of the wheel centre, at the middle rack."""
        return slope(values, STEPS[1], 1)

    def now(self, values):
        """Value at the pose in the middle."""
        values = np.asarray(values)
        found = values[values.shape[0] // 2]
        return found[found.shape[0] // 2] if found.ndim and values.ndim > 1 else found

    def inner(self, values):
        """Poses at which slopes along travel are known."""
        return values[REACH:-REACH]

    # the wheel ------------------------------------------------------------------------------------------------

    @cached_property
    def rotation(self):
        """Rotation of the upright since design, by its points."""
        names = UPRIGHT[self.rig.model]
        then = np.array([self.design[name] for name in names])
        now = np.stack([self.points[name] for name in names], axis=-2)
        one, other = then - then.mean(axis=0), now - now.mean(axis=-2, keepdims=True)
        left, _, right = np.linalg.svd(np.swapaxes(other, -1, -2) @ one)
        flip = np.linalg.det(left @ right)
        left[..., :, 2] *= flip[..., None]
        return left @ right

    @cached_property
    def spin(self):
        camber, toe = self.rig.wheel.camber, self.rig.wheel.toe
        return self.rotation @ np.array(
            [sin(toe) * cos(camber), cos(toe) * cos(camber), -sin(camber)]
        )

    @property
    def centre(self):
        return self.points["wheel_centre"]

    def contact_of(self, centre, spin):
        return centre + self.rig.wheel.radius * unit(spin * (spin @ self.up)[..., None] - self.up)

    @cached_property
    def contact(self):
        return self.contact_of(self.centre, self.spin)

    @cached_property
    def camber(self):
        return -np.arcsin(self.spin[..., 2])

    @cached_property
    def toe_out(self):
        return np.arctan2(-self.spin[..., 0], self.spin[..., 1])

    def screw(self, slopes, kept) -> Screw:
        """Motion of the upright from slopes of its rotation and of the wheel centre."""
        rate = slopes(self.rotation) @ np.swapaxes(kept(self.rotation), -1, -2)
        w = np.stack([rate[..., 2, 1], rate[..., 0, 2], rate[..., 1, 0]], axis=-1)
        return Screw(w, slopes(self.centre))

    @cached_property
    def by_travel(self) -> Screw:
        return self.screw(self.d, self.inner)

    @cached_property
    def by_rack(self) -> Screw:
        """At the middle rack; travel as of ``by_travel``."""
        found = self.screw(self.r, lambda values: values[:, REACH:-REACH])
        return Screw(self.inner(found.w), self.inner(found.v))

    @cached_property
    def patch(self):
        """Slope of the upright's point that is the contact point, along travel."""
        reach = self.inner(self.contact - self.centre)
        return self.by_travel.v + np.cross(self.by_travel.w, reach)

    # the steering axis ----------------------------------------------------------------------------------------

    @property
    def lift(self) -> Screw:
        middle = self.centre.shape[1] // 2
        return Screw(
            *(part[:, middle : middle + 1] for part in (self.by_travel.w, self.by_travel.v))
        )

    @cached_property
    def turning(self) -> Screw:
        """Rack and travel together: a pure turn, of two the one with less travel; else the screw of least pitch."""
        rack, lift = self.by_rack, self.lift
        shares = np.zeros(rack.w.shape[:-1])
        for at in np.ndindex(shares.shape):
            w, v, lw, lv = rack.w[at], rack.v[at], lift.w[at], lift.v[at]
            roots = np.roots([lw @ lv, w @ lv + lw @ v, w @ v])
            if np.all(np.isreal(roots)):
                shares[at] = min(roots.real, key=abs)
                continue
            top, under = (
                np.poly1d([lw @ lv, w @ lv + lw @ v, w @ v]),
                np.poly1d([lw @ lw, 2.0 * w @ lw, w @ w]),
            )
            extremes = (top.deriv() * under - top * under.deriv()).roots
            shares[at] = min(
                extremes[np.isreal(extremes)].real, key=lambda t: abs(top(t) / under(t))
            )
        return rack.plus(shares, lift)

    @cached_property
    def axis(self):
        """Point and direction of the steering axis at the middle rack, for all travels with slopes."""
        middle = slice(self.centre.shape[1] // 2, self.centre.shape[1] // 2 + 1)
        if self.rig.model in AXES:
            low, high = (self.inner(self.points[name])[:, middle] for name in AXES[self.rig.model])
            return low, high - low
        return self.turning.axis(self.inner(self.centre)[:, middle])

    def leads(self, axis, place):
        """How far an axis lies ahead (x) and outward (y) of a place at its height."""
        point, along = axis
        return (
            point + along * ((place[..., 2] - point[..., 2]) / along[..., 2])[..., None] - place
        )[..., :2]

    def axis_rows(self) -> dict:
        middle = slice(self.centre.shape[1] // 2, self.centre.shape[1] // 2 + 1)
        contact, centre = (self.inner(place)[:, middle] for place in (self.contact, self.centre))
        point, along = self.axis
        caster, inclination = (
            np.arctan2(-along[..., 0], along[..., 2]),
            np.arctan2(-along[..., 1], along[..., 2]),
        )
        ground, level = self.leads((point, along), contact), self.leads((point, along), centre)
        spin = self.inner(self.spin)[:, middle]
        flat = unit(spin[..., :2])
        forward = np.stack([flat[..., 1], -flat[..., 0]], axis=-1)
        held = self.by_rack.plus(
            -self.by_rack_of(self.length("spring")) / self.lift_of(self.length("spring")), self.lift
        )
        held_axis = held.axis(centre)
        held_ground = self.leads(held_axis, contact)
        rows = {
            "caster": caster,
            "kingpin_inclination": inclination,
            "caster_trail": ground[..., 0],
            "scrub_radius": -ground[..., 1],
            "spindle_offset": -level[..., 1],
            "wheel_centre_caster_offset": -level[..., 0],
            "caster_trail_wheel": dot(ground, forward),
            "scrub_radius_wheel": -dot(ground, flat),
            "spindle_offset_wheel": -dot(level, flat),
            "wheel_centre_caster_offset_wheel": -dot(level, forward),
            "steering_axis_pitch": self.turning.pitch,
            "caster_held_spring": np.arctan2(-held_axis[1][..., 0], held_axis[1][..., 2]),
            "kingpin_inclination_held_spring": np.arctan2(
                -held_axis[1][..., 1], held_axis[1][..., 2]
            ),
            "caster_trail_held_spring": held_ground[..., 0],
            "scrub_radius_held_spring": -held_ground[..., 1],
            "caster_gain": self.d(caster),
            "kingpin_inclination_gain": self.d(inclination),
            "steer_gain": self.by_rack_of(self.side * self.toe_out),
            "camber_per_steer": self.by_rack_of(self.camber) / self.by_rack_of(self.toe_out),
        }
        inner = "tie_rod_inner" if "tie_rod_inner" in self.points else "link_5_inner"
        rows["rack_travel"] = self.side * (self.points[inner] - self.design[inner])[..., 1]
        return rows

    def by_rack_of(self, values):
        return self.inner(self.r(values))

    def lift_of(self, values):
        middle = self.centre.shape[1] // 2
        return self.d(values)[:, middle : middle + 1]

    # springs --------------------------------------------------------------------------------------------------

    def length(self, element: str):
        """Length of spring or damper, m."""
        own = f"{element}_bottom" in self.points
        names = [
            f"{element if f'{element}_{end}' in self.points else 'strut'}_{end}"
            for end in ("bottom", "top")
        ]
        assert own or names[0] == "strut_bottom"
        return np.linalg.norm(self.points[names[1]] - self.points[names[0]], axis=-1)

    def short(self, element: str):
        """Design length minus length, m."""
        names = [
            f"{element if f'{element}_{end}' in self.points else 'strut'}_{end}"
            for end in ("bottom", "top")
        ]
        return np.linalg.norm(self.design[names[1]] - self.design[names[0]]) - self.length(element)

    def coil(self, spring, short, design: float):
        """Energy, force and stiffness of a spring (linear) that has become shorter by so much."""
        free = 0.0 if spring.free_length is None else spring.free_length - design
        force = spring.rate * (short + free) + (spring.preload or 0.0)
        return (
            0.5 * spring.rate * short**2 + (spring.rate * free + (spring.preload or 0.0)) * short,
            force,
            spring.rate,
        )

    def stop(self, stop, short):
        """Energy, force and stiffness of a stop."""
        depth = np.zeros_like(short) if stop is None else np.maximum(short - stop.gap, 0.0)
        rate, progression = (0.0, 0.0) if stop is None else (stop.rate, stop.progression)
        return (
            0.5 * rate * depth**2 + 0.25 * progression * depth**4,
            rate * depth + progression * depth**3,
            (rate + 3.0 * progression * depth**2) * (depth > 0.0),
        )

    def still(self, damper, short):
        """Energy, force and stiffness of a damper at rest that has become shorter by so much."""
        if damper.kind != "tanh":
            assert damper.kind in ("linear", "bilinear")
            return 0.0 * short, 0.0 * short, 0.0
        assert damper.displacement_coupling == 0.0
        stored = 0.5 * damper.stiffness * short**2 + damper.offset * short
        return stored, damper.stiffness * short + damper.offset, damper.stiffness

    def spring_rows(self) -> dict:
        rig, strut = self.rig, self.rig.strut
        length, damper, short = self.length("spring"), self.length("damper"), self.short("spring")
        rise = self.patch[..., 2]
        ratio, rows = self.d(short), {}
        rows |= {"spring_length": length, "damper_length": damper, "motion_ratio": ratio}
        rows |= {"motion_ratio_contact": ratio / rise, "motion_ratio_gradient": self.d(short, 2)}
        rows["motion_ratio_contact_gradient"] = self.d(ratio / rise) / self.inner(rise)
        rows["damper_motion_ratio"] = self.d(self.short("damper"))
        law = strut.damper
        coefficient = (
            0.5 * (law.bump_coefficient + law.rebound_coefficient)
            if law.kind == "bilinear"
            else law.coefficient + (law.force * law.slope if law.kind == "tanh" else 0.0)
        )
        rows["wheel_damping_coefficient"] = coefficient * rows["damper_motion_ratio"] ** 2
        bump, rebound = self.stop(strut.bump_stop, short), self.stop(strut.rebound_stop, -short)
        energy, force, stiffness = bump[0] + rebound[0], bump[1] - rebound[1], bump[2] + rebound[2]
        rows["stop_force"] = force
        if "spring" not in rig.without:
            coil = self.coil(strut.spring, short, float((length + short).flat[0]))
            rows["spring_force"] = coil[1]
            energy, force, stiffness = energy + coil[0], force + coil[1], stiffness + coil[2]
        at_contact = self.inner(force) * ratio / rise
        soft = self.inner(stiffness * np.ones_like(short)) * ratio**2
        gas = self.still(law, self.short("damper"))
        rows["damper_force"], energy = gas[1], energy + gas[0]
        at_contact = at_contact + self.inner(gas[1]) * rows["damper_motion_ratio"] / rise
        soft = soft + gas[2] * rows["damper_motion_ratio"] ** 2
        if rig.torsion_bar is not None:
            angle = self.torsion_angle
            torque = rig.torsion_bar.preload + rig.torsion_bar.stiffness * angle
            rows |= {
                "torsion_bar_angle": angle,
                "torsion_bar_torque": torque,
                "torsion_bar_motion_ratio": self.d(angle),
            }
            energy = (
                energy
                + rig.torsion_bar.preload * angle
                + 0.5 * rig.torsion_bar.stiffness * angle**2
            )
            at_contact = at_contact + self.inner(torque) * self.d(angle) / rise
            soft = soft + rig.torsion_bar.stiffness * self.d(angle) ** 2
        rows |= {
            "wheel_force": self.d(energy),
            "wheel_rate": self.d(energy, 2),
            "wheel_rate_spring": soft,
        }
        rows["wheel_rate_contact"] = self.d(at_contact) / self.inner(rise)
        rows["wheel_rate_contact_spring"] = soft / rise**2
        rows["tyre_deflection"] = np.array(
            (rig.tyre.undeformed_radius or rig.wheel.radius) - rig.wheel.radius
        )
        rows["tyre_stiffness"] = np.array(rig.tyre.stiffness)
        rows["ride_rate"] = 1.0 / (1.0 / rows["wheel_rate"] + 1.0 / rig.tyre.stiffness)
        return rows | self.across_rows(energy)

    @property
    def torsion_angle(self):
        pairs = {
            "lower_arm": ("lower_arm_front", "lower_arm_rear", "lower_ball_joint"),
            "rocker": ("rocker_pivot", "rocker_axis", "pushrod_inner"),
        }
        one, other, tip = pairs[self.rig.torsion_bar.on]
        axis = self.design[other] - self.design[one]
        angle = turned_about(self.points[tip], self.design[one], axis, self.design[tip])
        return angle * np.sign(self.now(self.d(angle)))  # bump winds it up

    def across_rows(self, energy) -> dict:
        """Third spring and anti-roll bar: both wheels alike, half of the energy is this wheel's."""
        rig, rows = self.rig, {}
        whole = energy
        if rig.third_spring is not None:
            length = 2.0 * self.points["third_spring_end"][..., 1]
            design = 2.0 * self.design["third_spring_end"][1]
            stored, force, _ = self.coil(rig.third_spring.spring, design - length, design)
            rows |= {"third_spring_length": length, "third_spring_motion_ratio": -self.d(length)}
            stored = stored + self.still(rig.third_spring.damper, design - length)[0]
            rows |= {"third_spring_force": force, "third_wheel_force": 0.5 * self.d(stored)}
            rows["third_wheel_rate"] = 0.5 * self.d(stored, 2)
            rows["third_damping_coefficient"] = (
                0.5 * rig.third_spring.damper.coefficient * self.d(length) ** 2
            )
            whole = whole + 0.5 * stored
        if rig.anti_roll_bar is not None:
            bar, pivot = rig.anti_roll_bar, self.design["arb_pivot"]
            axis = np.array([0.0, 1.0, 0.0])
            if "arb_axis" in self.design:
                axis = self.design["arb_axis"] - pivot
                axis = unit(axis if axis[1] > 0.0 else -axis)
            end, link = (
                self.points["arb_arm_end"],
                self.points["arb_link_end"] - self.points["arb_arm_end"],
            )
            angle = turned_about(end, pivot, axis, self.design["arb_arm_end"])
            twice = 2.0 * angle if bar.kind == "z" else 0.0 * angle
            arm = end - pivot - dot(end - pivot, axis)[..., None] * axis
            rows |= {"anti_roll_bar_angle": angle, "anti_roll_bar_motion_ratio": self.d(angle)}
            rows["anti_roll_bar_motion_ratio_gradient"] = self.d(angle, 2)
            opposite = (
                2.0 * self.d(angle) if bar.kind == "u" else 0.0 * self.d(angle)
            )  # twist for a metre each way
            rows["anti_roll_bar_rate"] = 0.5 * bar.stiffness * opposite**2
            rows["anti_roll_bar_arm_angle"] = angle_between(arm, link)
            rows["anti_roll_bar_stiffness"] = np.array(bar.stiffness)
            whole = whole + 0.5 * 0.5 * bar.stiffness * twice**2
        if rig.third_spring is not None or (
            rig.anti_roll_bar is not None and rig.anti_roll_bar.kind == "z"
        ):
            rows |= {"heave_force": self.d(whole), "heave_rate": self.d(whole, 2)}
        if "rocker_pivot" in self.points:
            pivot, axis = (
                self.design["rocker_pivot"],
                unit(self.design["rocker_axis"] - self.design["rocker_pivot"]),
            )
            turn = turned_about(
                self.points["pushrod_inner"], pivot, axis, self.design["pushrod_inner"]
            )
            rows["rocker_angle"] = turn * np.sign(self.now(self.d(turn)))
            for name, (inner, outer) in {
                "pushrod_angle": ("pushrod_inner", "pushrod_outer"),
                "rocker_spring_angle": ("strut_bottom", "strut_top"),
            }.items():
                arm = self.points[inner] - pivot
                arm = arm - dot(arm, axis)[..., None] * axis
                rows[name] = angle_between(arm, self.points[outer] - self.points[inner])
        return rows

    # the catalogue --------------------------------------------------------------------------------------------

    def rows(self) -> dict[str, float]:
        """Every row at the pose in the middle, SI."""
        centre, contact, patch, turn = self.centre, self.contact, self.patch, self.by_travel.w
        here = self.inner(contact)
        across, along = patch[..., 1] / patch[..., 2], patch[..., 0] / patch[..., 2]
        start = self.contact_of(self.design["wheel_centre"], np.array(self.spin_at_design))
        front, side = patch[..., 2] / turn[..., 0], patch[..., 2] / turn[..., 1]
        found = {
            "wheel_travel": centre[..., 2] - self.design["wheel_centre"][2],
            "camber": self.camber,
            "inclination": np.arcsin(self.side * self.spin[..., 2]),
            "steer": np.arctan2(-self.side * self.spin[..., 0], self.spin[..., 1]),
            "toe": np.arctan2(self.spin[..., 0], self.spin[..., 1]),
            "half_track_change": contact[..., 1] - start[1],
            "half_track_gradient": self.d(contact[..., 1]),
            "bump_steer": self.side * self.d(self.toe_out),
            "camber_gain": self.d(self.camber),
            "instant_centre_y": self.side * (here[..., 1] - front),
            "instant_centre_z": here[..., 2] + across * front,
            "side_instant_centre_x": here[..., 0] + side,
            "side_instant_centre_z": here[..., 2] - along * side,
            "front_view_swing_arm_length": front,
            "side_view_swing_arm_length": side,
            "front_view_swing_arm_angle": np.arctan(across),
            "side_view_swing_arm_angle": -np.arctan(along),
            "roll_centre_height": here[..., 1] * across,
            "jacking": across,
            "contact_patch_recession": along,
            "wheel_centre_longitudinal_slope": self.d(centre[..., 0]),
            "wheel_centre_recession": self.d(centre[..., 0]) / patch[..., 2],
            "wheel_centre_lateral_slope": self.d(centre[..., 1]),
            "ride_height_change": start[2] - contact[..., 2],
        }
        for i, axis in enumerate("xyz"):
            found[f"wheel_centre_{axis}"] = self.mirror[i] * centre[..., i]
            found[f"contact_point_{axis}"] = self.mirror[i] * contact[..., i]
        found |= self.spring_rows()
        found |= self.axis_rows() if self.steers else {}
        return {
            name: float(self.now(value)) if np.ndim(value) else float(value)
            for name, value in found.items()
        }

    @property
    def spin_at_design(self):
        camber, toe = self.rig.wheel.camber, self.rig.wheel.toe
        return sin(toe) * cos(camber), cos(toe) * cos(camber), -sin(camber)

    def shape_errors(self) -> dict[str, float]:
        """Largest change of a distance within each body or link over all poses, m."""
        found = {}
        for names in [*BODIES[self.rig.model], *FURTHER]:
            if not all(name in self.points for name in names):
                continue
            for i, one in enumerate(names):
                for other in names[i + 1 :]:
                    now = np.linalg.norm(self.points[one] - self.points[other], axis=-1)
                    then = np.linalg.norm(self.design[one] - self.design[other])
                    found[f"{one} {other}"] = float(np.max(np.abs(now - then)))
        if self.rig.model == "mcpherson":  # the strut's line is fixed to the upright
            line = unit(self.points["strut_top"] - self.points["strut_bottom"])
            then = unit(self.design["strut_top"] - self.design["strut_bottom"])
            found["strut line"] = float(
                np.max(np.linalg.norm(line - self.rotation @ then, axis=-1))
            )
        return found
