"""Double-wishbone files of Project Chrono: hardpoints, masses, spring and damper of a left corner."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from importlib import resources
from pathlib import Path

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.types import Array
from jounce.parts.importers.chrono_file import ChronoFile, RigidPart, ascending

HARDPOINTS = {
    "lower_arm_front": ("Lower Control Arm", "Location Chassis Front"),
    "lower_arm_rear": ("Lower Control Arm", "Location Chassis Back"),
    "lower_ball_joint": ("Lower Control Arm", "Location Upright"),
    "upper_arm_front": ("Upper Control Arm", "Location Chassis Front"),
    "upper_arm_rear": ("Upper Control Arm", "Location Chassis Back"),
    "upper_ball_joint": ("Upper Control Arm", "Location Upright"),
    "tie_rod_inner": ("Tierod", "Location Chassis"),
    "tie_rod_outer": ("Tierod", "Location Upright"),
    "wheel_centre": ("Spindle", "COM"),
    "spring_top": ("Spring", "Location Chassis"),
    "spring_bottom": ("Spring", "Location Arm"),
    "damper_top": ("Shock", "Location Chassis"),
    "damper_bottom": ("Shock", "Location Arm"),
}
"""Jounce's name of each point: section and key of the file."""
_BODIES = {
    "spindle": "Spindle",
    "upright": "Upright",
    "upper_arm": "Upper Control Arm",
    "lower_arm": "Lower Control Arm",
}
_ADVICE = "Chrono's double wishbones with a linear spring and a damper map can be read."


@dataclass(frozen=True)
class DamperMap:
    """Damper force over length and velocity.

    Attributes
    ----------
    length : array (n,)
        Length between the damper's ends, ascending [m].
    velocity : array (m,)
        Rate of that length, ascending: positive in rebound [m/s].
    force : array (m, n)
        Force that resists the velocity, positive in tension [N].
    """

    length: Array
    velocity: Array
    force: Array

    def coefficients_at(self, length: float) -> tuple[float, float]:
        """Give the bump and the rebound coefficient (N s/m) between the velocities next to zero, at a length in m."""
        zero = int(np.argmin(np.abs(self.velocity)))
        column = np.array([np.interp(length, self.length, row) for row in self.force])
        slopes = np.diff(column) / np.diff(self.velocity)
        return float(slopes[zero - 1]), float(slopes[zero])


@dataclass(frozen=True)
class ChronoCorner:
    """A left corner as the file describes it, at design position.

    Attributes
    ----------
    name : str
        As in the file.
    points : mapping of str to array (3,)
        Hardpoints [m], x forward, y left, z up.
    parts : mapping of str to RigidPart
        ``spindle``, ``upright``, ``upper_arm``, ``lower_arm``.
    tie_rod_mass : float
        [kg].
    spring_rate, spring_free_length : float
        [N/m], [m].
    spring_shortest, spring_longest : float
        Lengths between which the spring works [m].
    damper : DamperMap
        Its force.
    """

    name: str
    points: Mapping[str, Array]
    parts: Mapping[str, RigidPart]
    tie_rod_mass: float
    spring_rate: float
    spring_free_length: float
    spring_shortest: float
    spring_longest: float
    damper: DamperMap

    def distance(self, one: str, other: str) -> float:
        """Distance between two hardpoints at design position in m."""
        return float(np.linalg.norm(self.points[one] - self.points[other]))


def shipped_corner() -> ChronoCorner:
    """Read the shipped front corner of a HMMWV.

    Examples
    --------
    >>> round(shipped_corner().distance("spring_top", "spring_bottom"), 4)   # in m, with a free length of 0.339 m
    0.2463
    """
    folder = Path(str(resources.files("jounce.parts") / "library" / "hmmwv"))
    return read_chrono_corner(folder / "HMMWV_DoubleWishboneFront_mapShock.json")


def read_chrono_corner(path: Path | str) -> ChronoCorner:
    """Read a double-wishbone suspension of Project Chrono.

    Parameters
    ----------
    path : Path or str
        JSON file in SI, as Chrono writes it: comments are allowed, as they are there.

    Returns
    -------
    ChronoCorner
        The left corner in jounce's names; nothing is computed.

    Raises
    ------
    DescriptionError
        For a file that is missing, no JSON (with the line), of another template, without a linear spring or a damper
        map, or with values that are missing, no finite numbers, or of the wrong shape.

    Examples
    --------
    >>> from importlib import resources
    >>> folder = resources.files("jounce.parts") / "library" / "hmmwv"
    >>> read_chrono_corner(Path(str(folder)) / "HMMWV_DoubleWishboneFront_mapShock.json").spring_rate
    167062.0
    """
    file = ChronoFile(Path(path), ["DoubleWishbone"], _ADVICE)
    parts = {name: file.part(section) for name, section in _BODIES.items()}
    points = {name: file.numbers(section, key, (3,)) for name, (section, key) in HARDPOINTS.items()}
    lengths = [file.positive("Spring", key) for key in ("Free Length", "Minimum Length", "Maximum Length")]
    free, shortest, longest = lengths
    if not shortest < longest:
        raise DescriptionError("the spring's lengths contradict each other", where=file.at("Spring"), found=lengths)
    return ChronoCorner(
        name=file.name,
        points=points,
        parts=parts,
        tie_rod_mass=file.positive("Tierod", "Mass"),
        spring_rate=file.positive("Spring", "Spring Coefficient"),
        spring_free_length=free,
        spring_shortest=shortest,
        spring_longest=longest,
        damper=damper_map(file),
    )


def damper_map(file: ChronoFile) -> DamperMap:
    """Read the map; each of its rows begins with its velocity."""
    length = file.numbers("Shock", "Deformation", (-1,))
    rows = file.numbers("Shock", "Map Data", (-1, len(length) + 1))
    velocity = rows[:, 0]
    for name, values in (("Deformation", length), ("Map Data", velocity)):
        ascending(values, file.at("Shock", name))
    if not (velocity[0] < 0.0 < velocity[-1] and math.isclose(float(np.abs(velocity).min()), 0.0, abs_tol=1e-9)):
        raise DescriptionError(
            "the velocities do not lie about zero",
            where=file.at("Shock", "Map Data"),
            found=velocity.tolist(),
            allowed="negative ones (bump), 0, positive ones (rebound)",
        )
    return DamperMap(length, velocity, rows[:, 1:])
