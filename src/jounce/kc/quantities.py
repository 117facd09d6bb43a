"""What a K&C rig measures at each sample: angles and places of the wheels, forces of road, springs, links, bushings."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
import xarray as xr

from jounce.axles.assembly import GROUND, Element
from jounce.axles.builder import SIDES, AxleBuilder
from jounce.axles.wheels import caster_of, moved, turned, wheel_quantities
from jounce.core.types import Array
from jounce.kernel import equilibrium as eq

_DIRECTIONS = ("force_x", "force_y", "force_z", "torque_x", "torque_y", "torque_z")
ANGLES = {
    "toe": ("toe angle", "toe-in"),
    "camber": ("camber angle", "top outward"),
    "steer": ("steer angle", "about +z"),
    "caster": ("caster angle", "top rearward"),
    "spin": ("rotation of the wheel carrier about the wheel's axis", "as in rolling forward"),
}
"""Angles of a wheel, rad: label and sign."""
_AXES = (("x", "forward"), ("y", "to the left"), ("z", "up"))


@dataclass(frozen=True)
class Poses:
    """Settled samples of a test."""

    axle: AxleBuilder
    settled: eq.Settled
    path: eq.Path

    def places(self) -> Array:
        """Poses of all bodies, shape (samples, bodies, 12)."""
        return self.settled.poses.reshape(len(self.settled.poses), -1, 12)

    def multipliers(self, element: int) -> Array:
        """Multipliers of a constraint, shape (samples, rows)."""
        assembly = self.axle.assembly
        first, count = assembly.order()[element], eq.ROWS[assembly.elements[element].kind]
        return self.settled.multipliers[:, first : first + count]

    def control_force(self, name: str) -> Array:
        """Force that a control exerts, N."""
        assembly = self.axle.assembly
        place = assembly.order()[-1] + [control for control, *_ in assembly.controls].index(name)
        return self.settled.multipliers[:, place]


def table_deflections(poses: Poses) -> Iterator[tuple[Element, int, Array]]:
    """Yield element, direction and deflections at the samples, m or rad, of each direction with a table."""
    places = poses.places()
    lengths = poses.settled.forces.reshape(len(places), -1, 6)[:, :, 1]
    for i, element in enumerate(poses.axle.assembly.elements):
        tables = [k for k, law in enumerate(element.laws) if law and law.kind == eq.TABLE]
        if not tables:
            continue
        data = np.real(element.data[:, 0])
        if element.kind == eq.LINE:
            yield element, 0, data[eq.SIGN] * (data[eq.LENGTH] - lengths[:, i])
            continue
        first, second = (
            _STILL if body == GROUND else places[:, body]
            for body in (element.first, element.second)
        )
        point, axes = data[eq.P : eq.P + 3], data[eq.A : eq.A + 9].reshape(3, 3)
        gap = moved(second, point) - moved(first, point)
        about = np.sign(np.linalg.det(axes)) * _rotation_vector(first, second) @ axes.T
        for k in tables:
            yield (
                element,
                k,
                about[:, k - 3] if k > 2 else (turned(first, axes[k]) * gap).sum(axis=-1),
            )


_STILL = np.concatenate([np.zeros(3), np.eye(3).ravel()])[None]


def _rotation_vector(first: Array, second: Array) -> Array:
    """Return axis times angle of poses (n, 12) relative to others, in the axes of the others, shape (n, 3)."""
    a, b = (pose[..., 3:].reshape(-1, 3, 3) for pose in (first, second))
    inner = np.swapaxes(a, 1, 2) @ b
    parts = [
        inner[:, (i + 2) % 3, (i + 1) % 3] - inner[:, (i + 1) % 3, (i + 2) % 3] for i in range(3)
    ]
    sine = 0.5 * np.stack(parts, axis=-1)
    size = np.linalg.norm(sine, axis=-1)
    angle = np.arctan2(size, 0.5 * (np.trace(inner, axis1=1, axis2=2) - 1.0))
    return np.asarray(
        np.where(size > 0.0, angle / np.where(size > 0.0, size, 1.0), 1.0)[:, None] * sine
    )


def is_of_element(name: str) -> bool:
    """Whether a quantity is a force or length of a spring, link or bushing.

    >>> is_of_element("left.tie_rod.force"), is_of_element("arb.twist"), is_of_element("left.toe")
    (True, True, False)
    """
    return "." in name.removeprefix("left.").removeprefix("right.")


def quantities(poses: Poses, *, elements: bool = True) -> dict[str, xr.Variable]:
    """Return all quantities of a test as variables on ``sample``, those of springs, links and bushings if asked."""
    axle, places = poses.axle, poses.places()
    out: dict[str, xr.Variable] = {}

    def keep(name: str, values: Array, unit: str, label: str, positive: str = "") -> None:
        attributes = {"units": unit, "long_name": label}
        if positive:
            attributes["positive"] = positive
        out[name] = xr.Variable("sample", np.ascontiguousarray(values), attributes)

    for k, side in enumerate(SIDES):
        wheel = axle.assembly.wheels[k]
        centre, direction = (np.real(part).T[0] for part in (wheel.centre, wheel.axis))
        pose = places[:, wheel.body]
        found = wheel_quantities(
            pose, centre, direction, np.real(wheel.radius)[:1], 1.0 if side == "left" else -1.0
        )
        if side in axle.steering_axis:
            ends = [
                np.real(point).T[0]
                if body == GROUND
                else moved(places[:, body], np.real(point).T[0])
                for body, point in axle.steering_axis[side]
            ]
            found["caster"] = caster_of(*np.broadcast_arrays(*ends, pose[:, :3])[:2])
        for name, (label, positive) in ANGLES.items():
            if name in found:
                keep(f"{side}.{name}", found[name], "rad", label, positive)
        for name, label in (("wheel_centre", "wheel centre"), ("contact_point", "contact point")):
            for axis, positive in _AXES:
                values = found[f"{name}_{axis}"]
                keep(f"{side}.{name}_{axis}", values, "m", f"{label}, from design", positive)
        _keep_road(poses, k, side, keep)
    if elements:
        _keep_elements(poses, keep)
    if axle.steered:
        element = next(e for e in axle.assembly.elements if e.is_control)
        travel = _travel(places, element, axle.bodies["rack"])
        keep("rack_travel", travel, "m", "travel of the rack in its housing", "to the left")
        keep(
            "rack_force",
            poses.control_force("rack"),
            "N",
            "force of the handwheel on the rack",
            "to the left",
        )
        _keep_handwheel(poses, _travel(places, element, element.second), keep)
    return out


def _travel(places: Array, element: Element, body: int) -> Array:
    """Return the travel (m) of a body along a control's line on its first body, which may move itself."""
    at, direction = (np.real(element.data[k : k + 3, 0]) for k in (eq.P, eq.ALONG))
    if element.first == GROUND:
        return np.asarray((moved(places[:, body], at) - at) @ direction)
    holder = places[:, element.first]
    apart = moved(places[:, body], at) - moved(holder, at)
    return np.asarray((apart * turned(holder, direction)).sum(axis=-1))


def _keep_handwheel(poses: Poses, travel: Array, keep: Any) -> None:
    """Keep angle and torque of the handwheel for a travel (m) of what it drives, if the rack's ratio is known."""
    from jounce.kinematics.column import handwheel_angle, pinion_angle

    steering = getattr(poses.axle.rig, "steering", None)
    if steering is None or steering.rack_ratio is None:
        return
    angle = np.full_like(travel, np.nan)
    known = np.isfinite(travel)
    angle[known] = handwheel_angle(steering, travel[known])
    by_hand = poses.control_force("rack") / (1.0 + (steering.assistance or 0.0))
    torque = by_hand * steering.rack_ratio * pinion_angle(steering, angle)[1]
    keep("handwheel_angle", angle, "rad", "angle of the handwheel", "to the left")
    keep("handwheel_torque", torque, "N*m", "torque on the handwheel", "to the left")


def _keep_road(poses: Poses, k: int, side: str, keep: Any) -> None:
    loads = poses.path.loads.reshape(len(poses.path.loads), len(SIDES), -1)[:, k]
    reached = poses.settled.outcome == eq.SETTLED
    vertical = poses.control_force(f"{side}.contact")
    whole = np.where(reached[:, None], loads, np.nan)
    road = "force of the road on the tyre"
    keep(f"{side}.longitudinal_force", whole[:, 0] + whole[:, 3], "N", road, "forward")
    keep(f"{side}.lateral_force", whole[:, 1] + whole[:, 4], "N", road, "to the left")
    keep(f"{side}.vertical_force", vertical, "N", road, "up")
    keep(
        f"{side}.aligning_moment", whole[:, 2], "N*m", "moment of the road on the tyre", "about +z"
    )


def _keep_elements(poses: Poses, keep: Any) -> None:
    """Keep forces of springs, links and bushings."""
    assembly = poses.axle.assembly
    forces = poses.settled.forces.reshape(len(poses.settled.forces), -1, 6)
    for i, element in enumerate(assembly.elements):
        name = element.name
        if name.startswith("_"):  # one of several that are a part together
            continue
        if element.kind == eq.BUSHING:
            for k, direction in enumerate(_DIRECTIONS):
                keep(
                    f"{name}.{direction}",
                    forces[:, i, k],
                    "N" if k < 3 else "N*m",
                    "load of the bushing on the wheel's side, along its axes",
                )
        elif element.kind == eq.LINE:
            keep(f"{name}.force", forces[:, i, 0], "N", "force, compression positive")
            keep(f"{name}.length", forces[:, i, 1], "m", "length")
        elif element.kind == eq.TWIST:
            keep(f"{name}.torque", -forces[:, i, 0], "N*m", "torque against the twist")
            keep(f"{name}.twist", forces[:, i, 1], "rad", "twist from design")
        elif element.kind == eq.DISTANCE:
            keep(f"{name}.force", poses.multipliers(i)[:, 0], "N", "force, compression positive")
