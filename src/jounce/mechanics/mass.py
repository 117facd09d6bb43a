"""Mass properties of simple shapes and closed meshes: mass, centre and inertia about it, in design axes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.errors import AssemblyError
from jounce.core.files import existing_file
from jounce.core.optional import require
from jounce.core.phrases import Phrase
from jounce.core.samples import as_samples
from jounce.core.types import Array
from jounce.core.units import to_si

Number = float | str
"""A number in SI units, or text with a unit."""
_TRIANGLE = (
    1e-6  # share of the largest moment by which rounding may violate the triangle inequality
)


@dataclass(frozen=True)
class SolidMass:
    """Mass (kg), centre of mass (m, shape (3,)) and inertia about it (kg m^2, shape (3, 3), design axes).

    Pass it to a mechanism as ``body(name, *solid.arguments)``.
    """

    mass: float
    centre_of_mass: Array
    inertia: Array

    @property
    def arguments(self) -> tuple[float, tuple[float, ...], tuple[float, ...]]:
        """Mass, centre and the inertia elements xx, yy, zz, xy, xz, yz."""
        i = self.inertia
        elements = (i[0, 0], i[1, 1], i[2, 2], i[0, 1], i[0, 2], i[1, 2])
        return self.mass, tuple(map(float, self.centre_of_mass)), tuple(map(float, elements))


def box(density: Number, size: Sequence[Number], centre: Sequence[Number]) -> SolidMass:
    """Return the mass properties of a block with edges along the design axes.

    Parameters
    ----------
    density : float
        kg/m^3.
    size : sequence of float, shape (3,)
        Edge lengths along x, y, z, m.
    centre : sequence of float, shape (3,)
        Its centre, m.

    Returns
    -------
    SolidMass
        Mass, centre, inertia.

    Examples
    --------
    >>> round(box(7150.0, (0.108, 0.094, 0.038), (0.0, 0.0, 0.0)).mass, 3)   # the block of the prototype paper
    2.758
    """
    a, b, c = (_positive(part, "m", "size") for part in _three(size, "size"))
    mass = _positive(density, "kg/m^3", "density") * a * b * c
    moments = mass / 12.0 * np.array([b * b + c * c, a * a + c * c, a * a + b * b])
    return SolidMass(mass, _place(centre, "centre"), np.diag(moments))


def sphere(density: Number, radius: Number, centre: Sequence[Number]) -> SolidMass:
    """Return the mass properties of a solid sphere.

    Parameters
    ----------
    density : float
        kg/m^3.
    radius : float
        m.
    centre : sequence of float, shape (3,)
        Its centre, m.

    Returns
    -------
    SolidMass
        Mass, centre, inertia.
    """
    r, rho = _positive(radius, "m", "radius"), _positive(density, "kg/m^3", "density")
    mass = rho * 4.0 / 3.0 * np.pi * r**3
    return SolidMass(float(mass), _place(centre, "centre"), 0.4 * mass * r * r * np.eye(3))


def cylinder(
    density: Number, radius: Number, start: Sequence[Number], end: Sequence[Number]
) -> SolidMass:
    """Return the mass properties of a round bar between two points.

    Parameters
    ----------
    density : float
        kg/m^3.
    radius : float
        m.
    start, end : sequence of float, shape (3,)
        Centres of its end faces, m.

    Returns
    -------
    SolidMass
        Mass, centre, inertia.
    """
    return tube(density, 0.0, radius, start, end)


def tube(
    density: Number,
    inner_radius: Number,
    outer_radius: Number,
    start: Sequence[Number],
    end: Sequence[Number],
) -> SolidMass:
    """Return the mass properties of a tube between two points.

    Parameters
    ----------
    density : float
        kg/m^3.
    inner_radius, outer_radius : float
        m.
    start, end : sequence of float, shape (3,)
        Centres of its end faces, m.

    Returns
    -------
    SolidMass
        Mass, centre, inertia.

    Raises
    ------
    AssemblyError
        If a size is not positive or the inner radius is not below the outer one.
    """
    rho, outer = (
        _positive(density, "kg/m^3", "density"),
        _positive(outer_radius, "m", "outer radius"),
    )
    inner = to_si(inner_radius, "m", where="inner radius")
    if not 0.0 <= inner < outer:
        raise AssemblyError(
            "invalid inner radius",
            found=f"{inner:g} m",
            allowed=Phrase("0 to below {outer:g} m", outer=outer),
        )
    first, last = _place(start, "start"), _place(end, "end")
    length = _positive(float(np.linalg.norm(last - first)), "m", "distance of the ends")
    axis = (last - first) / length
    mass = rho * np.pi * (outer**2 - inner**2) * length
    squares = outer**2 + inner**2
    along, across = 0.5 * mass * squares, mass * (squares / 4.0 + length**2 / 12.0)
    inertia = across * np.eye(3) + (along - across) * np.outer(axis, axis)
    return SolidMass(float(mass), 0.5 * (first + last), inertia)


def mesh(
    density: Number, surface: str | Path | tuple[ArrayLike, ArrayLike], scale: float = 1.0
) -> SolidMass:
    """Return the mass properties of a closed triangle mesh, computed by trimesh (extra ``mesh``).

    Parameters
    ----------
    density : float
        kg/m^3.
    surface : str or Path or tuple of array_like
        A file (STL, OBJ, PLY ...), or vertices (n, 3) and faces (m, 3), in design axes.
    scale : float
        Length unit of the surface in m (1e-3 for millimetres).

    Returns
    -------
    SolidMass
        Mass, centre, inertia.

    Raises
    ------
    AssemblyError
        If the file cannot be read, the surface is not closed, or its faces do not all point outwards.
    """
    trimesh = require("trimesh", "mesh")
    if isinstance(surface, tuple):
        vertices = as_samples(surface[0], where="surface: vertices", error=AssemblyError)
        result = trimesh.Trimesh(vertices=vertices, faces=np.asarray(surface[1]))
    else:
        result = _read(trimesh, Path(surface))
    if not result.is_watertight or not result.is_winding_consistent or result.volume <= 0.0:
        raise AssemblyError(
            "the surface does not enclose a volume",
            where=str(surface) if not isinstance(surface, tuple) else "surface",
            found=f"{len(result.faces)} faces, watertight: {result.is_watertight}, volume {result.volume:.4g}",
            hint="Close the mesh and let all faces point outwards.",
        )
    rho, unit = _positive(density, "kg/m^3", "density"), _positive(scale, "m", "scale")
    inertia = np.asarray(result.moment_inertia) * rho * unit**5
    return SolidMass(
        float(result.volume * rho * unit**3), np.asarray(result.center_mass) * unit, inertia
    )


def _read(trimesh: ModuleType, file: Path) -> Any:
    """Surface in a file."""
    existing_file(file, AssemblyError)
    try:
        result = trimesh.load(str(file), force="mesh")
    except Exception as error:  # readers of the various formats raise arbitrary exceptions
        hint = "Use STL, OBJ or PLY."
        raise AssemblyError(
            "the surface cannot be read", where=str(file), found=str(error), hint=hint
        ) from error
    if not isinstance(result, trimesh.Trimesh) or not len(result.faces):
        raise AssemblyError("no surface in the file", where=str(file), found="no faces")
    return result


def combine_solids(*solids: SolidMass) -> SolidMass:
    """Return the mass properties of several solids as one body.

    Parameters
    ----------
    *solids : SolidMass
        The parts.

    Returns
    -------
    SolidMass
        Mass (kg), centre (m), inertia (kg m^2).

    Raises
    ------
    AssemblyError
        If no solid is given.
    """
    if not solids:
        raise AssemblyError("nothing to combine", hint="Give at least one solid.")
    mass = sum(solid.mass for solid in solids)
    centre = np.asarray(sum(solid.mass * solid.centre_of_mass for solid in solids)) / mass
    inertia = np.zeros((3, 3))
    for solid in solids:
        arm = solid.centre_of_mass - centre
        inertia += solid.inertia + solid.mass * (arm @ arm * np.eye(3) - np.outer(arm, arm))
    return SolidMass(mass, centre, inertia)


def check_inertia(name: str, mass: float, inertia: Array) -> None:
    """Refuse a mass that is not positive and an inertia that is physically impossible.

    Raises
    ------
    AssemblyError
        If either is invalid; the message contains the principal moments.
    """
    if not (np.isfinite(mass) and mass > 0.0):
        raise AssemblyError("invalid mass", where=name, found=f"{mass:g} kg", allowed="above 0 kg")
    moments = np.linalg.eigvalsh(inertia)
    slack = _TRIANGLE * max(moments[2], 1e-300)
    if (
        not np.all(np.isfinite(inertia))
        or moments[0] < -slack
        or moments[2] > moments[0] + moments[1] + slack
    ):
        shown = ", ".join(f"{moment:.6g}" for moment in moments)
        raise AssemblyError(
            "impossible inertia",
            where=name,
            found=f"principal moments {shown} kg m^2",
            allowed="none negative, the largest at most the sum of the others",
            hint="Check units, axes and the signs of the products (xy = -integral of x y dm).",
        )


def _positive(value: Number, unit: str, what: str) -> float:
    number = to_si(value, unit, where=what)
    if not number > 0.0:
        raise AssemblyError(
            Phrase("invalid {what}", what=what), found=f"{number:g} {unit}", allowed="above 0"
        )
    return number


def _three(values: Sequence[Number], what: str) -> Sequence[Number]:
    if len(values) != 3:
        raise AssemblyError(
            "invalid vector", where=what, found=f"{len(values)} numbers", allowed="three: x, y, z"
        )
    return values


def _place(values: Sequence[Number], what: str) -> Array:
    return np.array([to_si(value, "m", where=what) for value in _three(values, what)])
