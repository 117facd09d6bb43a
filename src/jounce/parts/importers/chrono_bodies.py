"""Bodies of Project Chrono in design axes: its frames turned back, impossible inertias cut to possible ones."""

from __future__ import annotations

from typing import Any

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.parts.bodies import TRIANGLE_TOLERANCE
from jounce.parts.importers.chrono_file import ChronoFile, RigidPart

DESIGN = np.eye(3)


def arm_frame(front: Array, rear: Array, outer: Array, where: str) -> Array:
    """Axes of Chrono's A-arms as columns: x along the axis to the front, z normal to the arm."""
    normal = _unit(np.cross(rear - outer, front - outer), where)
    along = _unit(front - rear, where)
    return np.column_stack([along, np.cross(normal, along), normal])


def rod_frame(start: Array, end: Array, across: Array, where: str) -> Array:
    """Axes of Chrono's links as columns: z from ``start`` to ``end``, y along ``across`` made perpendicular to it."""
    along = _unit(end - start, where)
    side = _unit(across - along * (along @ across), where)
    return np.column_stack([np.cross(side, along), side, along])


def body_table(
    file: ChronoFile, section: str, frame: Array, centre: Array | None = None
) -> tuple[dict[str, Any], list[Finding]]:
    """Table of one body and what was assumed; ``frame`` holds the axes of the file's inertia as columns."""
    part = file.part(section, centre=centre)
    tensor, found = _possible(part, file.at(section))
    if file.table.get("Vehicle-Frame Inertia") is not True:
        tensor = frame @ tensor @ frame.T
    return as_table(part.mass, part.centre, tensor), found


def as_table(mass: float, centre: Array, tensor: Array) -> dict[str, Any]:
    """Table of a body in the names of rig files."""
    names = {"xx": (0, 0), "yy": (1, 1), "zz": (2, 2), "xy": (0, 1), "xz": (0, 2), "yz": (1, 2)}
    size = float(np.abs(tensor).max())
    inertia = {name: float(tensor[at]) for name, at in names.items() if abs(tensor[at]) > 1e-9 * size}
    return {"mass": mass, "centre_of_mass": centre, "inertia": inertia}


def joined(one: dict[str, Any], mass: float, centre: Array, tensor: Array) -> dict[str, Any]:
    """Table of a body and another one that is fixed to it (kg, m, kg m^2)."""
    masses, centres = (one["mass"], mass), (np.array(one["centre_of_mass"]), centre)
    whole = masses[0] + masses[1]
    middle = (masses[0] * centres[0] + masses[1] * centres[1]) / whole
    total = tensor_of(one) + tensor
    for part, place in zip(masses, centres, strict=True):
        away = place - middle
        total = total + part * ((away @ away) * np.eye(3) - np.outer(away, away))
    return as_table(whole, middle, total)


def tensor_of(table: dict[str, Any]) -> Array:
    """Inertia tensor of a body's table, shape (3, 3), kg m^2."""
    xx, yy, zz, xy, xz, yz = (table["inertia"].get(name, 0.0) for name in ("xx", "yy", "zz", "xy", "xz", "yz"))
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def about_axis(table: dict[str, Any], one: Array, other: Array) -> float:
    """Moment of inertia of a body's table about the line through two points in kg m^2."""
    axis = (other - one) / np.linalg.norm(other - one)
    away = np.linalg.norm(np.cross(axis, np.array(table["centre_of_mass"]) - one))
    return float(axis @ tensor_of(table) @ axis + table["mass"] * away**2)


def wheel_tensor(mass: float, radius: float) -> Array:
    """Inertia of rim and tyre, estimated: 0.6 m r^2 about the axle, 0.35 m r^2 across it."""
    return np.asarray(mass * radius**2 * np.diag([0.35, 0.6, 0.35]))


def _possible(part: RigidPart, where: str) -> tuple[Array, list[Finding]]:
    """Tensor in the file's frame; a largest moment over the sum of the others, which no body has, is cut to it."""
    xy, xz, yz = part.products
    tensor = np.diag(part.moments) + np.array([[0.0, xy, xz], [xy, 0.0, yz], [xz, yz, 0.0]])
    moments, axes = np.linalg.eigh(tensor)
    if moments[0] <= 0.0:
        raise DescriptionError(
            "an inertia that no body has: a principal moment is not above 0",
            where=where,
            found=", ".join(f"{moment:.6g} kg m^2" for moment in moments),
        )
    if moments[2] <= (moments[0] + moments[1]) * (1.0 + TRIANGLE_TOLERANCE):
        return tensor, []
    cut = moments[0] + moments[1]
    message = (
        f"no body has the principal moments {moments[0]:.5g}, {moments[1]:.5g} and {moments[2]:.5g} kg m^2: the "
        f"largest is cut to the sum of the others, {cut:.5g}."
    )
    moments = np.array([moments[0], moments[1], cut])
    return axes @ np.diag(moments) @ axes.T, [Finding(where, "warning", message, float(cut))]


def _unit(vector: Array, where: str) -> Array:
    length = float(np.linalg.norm(vector))
    if length < 1e-9:
        raise DescriptionError("two points are the same, or three lie on one line", where=where, allowed="a triangle")
    return vector / length
