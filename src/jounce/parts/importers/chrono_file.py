"""Files of Project Chrono.

Access to values by section and key with error locations, and reading of double wishbones without conversion.
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np

from jounce.core.description import description_text, is_nested_deeply
from jounce.core.errors import DescriptionError, at_line, nearest
from jounce.core.phrases import Phrase
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.core.units import LARGEST

_COMMENT = re.compile(r'("(?:\\.|[^"\\])*(?:"|$))|//[^\n]*|/\*(?:.*?\*/|.*)', re.DOTALL)
"""Unterminated strings and comments extend to the end of the file: this avoids repeated scans."""


@dataclass(frozen=True)
class RigidPart:
    """Mass properties of a body.

    Attributes
    ----------
    mass : float
        Mass [kg].
    centre : array (3,)
        Centre of mass [m], x forward, y left, z up.
    moments : array (3,)
        Moments of inertia about the centre of mass [kg m^2].
    products : array (3,)
        Tensor elements xy, xz, yz [kg m^2].
    """

    mass: float
    centre: Array
    moments: Array
    products: Array = field(default_factory=lambda: np.zeros(3))


class ChronoFile:
    """Values of a suspension file.

    Parameters
    ----------
    path : Path
        JSON file in SI; comments are allowed, as in Chrono.
    templates : sequence of str
        Supported kinds of suspension.
    advice : str
        Hint for missing values.
    """

    def __init__(self, path: Path, templates: Sequence[str], advice: str) -> None:
        self.path, self.advice = path, advice
        self.table = read_json(path)
        template = self.table.get("Template")
        if template not in templates:
            kind = self.table.get("Type")
            of = f" ({kind})" if isinstance(kind, str) and kind != "Suspension" else ""
            raise DescriptionError(
                Phrase("this kind of Chrono file cannot be read{of}", of=of),
                where=str(path),
                found=template,
                allowed=Phrase("the template {templates}", templates=", ".join(templates)),
                hint=advice,
            )
        self.template = str(template)

    @property
    def name(self) -> str:
        """Name given in the file, or the name of the file."""
        name = self.table.get("Name", self.path.stem)
        if not isinstance(name, str):
            raise DescriptionError(
                "invalid name", where=self.at("Name"), found=name, allowed="text"
            )
        return name

    def at(self, *keys: str) -> str:
        """Return the location of a value for messages."""
        return ": ".join((str(self.path), *keys))

    def has(self, section: str, *keys: str) -> bool:
        """Whether a section contains all keys."""
        here = self.table.get(section)
        return isinstance(here, dict) and all(key in here for key in keys)

    def value(self, section: str, key: str) -> Any:
        """Return a value as written."""
        here: Any = self.table
        for i, part in enumerate((section, key)):
            if not isinstance(here, dict) or part not in here:
                known = list(here) if isinstance(here, dict) else []
                raise DescriptionError(
                    Phrase("the key {part!r} is missing", part=part),
                    where=self.at(*(section,)[:i]),
                    allowed=", ".join(known),
                    hint=nearest(part, known) or self.advice,
                )
            here = here[part]
        return here

    def numbers(self, section: str, key: str, shape: tuple[int, ...]) -> Array:
        """Return finite numbers of a shape; -1 in the shape means any size."""
        return self._check_numbers(self.value(section, key), self.at(section, key), shape)

    def positive(self, section: str, key: str) -> float:
        """Return a number above zero."""
        value = float(self.numbers(section, key, ()))
        if not value > 0.0:
            raise DescriptionError(
                "out of range", where=self.at(section, key), found=value, allowed="above 0"
            )
        return value

    def number(self, section: str, key: str, default: float) -> float:
        """Return an optional number."""
        return float(self.numbers(section, key, ())) if self.has(section, key) else default

    def angle(self, key: str) -> float:
        """Return a top-level angle (written in degrees) in rad; 0 if omitted."""
        return float(np.radians(self._check_numbers(self.table.get(key, 0.0), self.at(key), ())))

    def part(self, section: str, *, centre: Array | None = None) -> RigidPart:
        """Return mass properties of a body; ``centre`` (m) is used if the file does not give it."""
        key = "Moments of Inertia" if self.has(section, "Moments of Inertia") else "Inertia"
        products = "Products of Inertia"
        return RigidPart(
            self.positive(section, "Mass"),
            self.numbers(section, "COM", (3,)) if centre is None else centre,
            self.numbers(section, key, (3,)),
            self.numbers(section, products, (3,)) if self.has(section, products) else np.zeros(3),
        )

    def curve(self, section: str, key: str) -> tuple[Array, Array]:
        """Return the points of a curve as two arrays; the first must ascend."""
        points = self.numbers(section, key, (-1, 2))
        ascending(points[:, 0], self.at(section, key))
        return points[:, 0], points[:, 1]

    def _check_numbers(self, value: Any, where: str, shape: tuple[int, ...]) -> Array:
        try:
            numbers = np.asarray(value, dtype=float)
        except (TypeError, ValueError, OverflowError):
            raise DescriptionError("not a regular list of numbers", where=where) from None
        fits = numbers.ndim == len(shape) and all(
            n in (-1, m) for n, m in zip(shape, numbers.shape, strict=True)
        )
        if not fits or not np.isfinite(numbers).all() or _has_truth(value):
            wanted = " x ".join("n" if n < 0 else str(n) for n in shape) or "one"
            raise DescriptionError(
                "unexpected numbers",
                where=where,
                found=f"shape {numbers.shape}",
                allowed=Phrase("{wanted} finite numbers", wanted=wanted),
            )
        if np.abs(numbers).max(initial=0.0) > LARGEST:
            raise DescriptionError(
                "an impossible value",
                where=where,
                found=float(np.abs(numbers).max()),
                allowed=Phrase("magnitudes up to {largest:g}", largest=LARGEST),
            )
        return numbers


def ascending(values: Array, where: str) -> None:
    """Refuse fewer than two values, or values that are not ascending."""
    if len(values) < 2 or not bool(np.all(np.diff(values) > 0.0)):
        raise DescriptionError("fewer than two ascending values", where=where)


def _has_truth(value: object) -> bool:
    return isinstance(value, bool) or (
        isinstance(value, list) and any(_has_truth(item) for item in value)
    )


def read_json(path: Path) -> dict[str, Any]:
    """Read a JSON object with comments."""
    try:
        text = description_text(path)
    except UnicodeDecodeError:
        raise DescriptionError(
            "not a text file", where=str(path), allowed="JSON text in UTF-8"
        ) from None
    blank = _COMMENT.sub(lambda match: match[1] or re.sub(r"[^\n]", " ", match[0]), text)
    try:
        table = json.loads(blank)
    except json.JSONDecodeError as error:
        raise DescriptionError(
            Phrase("not valid JSON: {msg}", msg=error.msg), where=at_line(path, error.lineno)
        ) from None
    except (RecursionError, ValueError):
        what = "not valid JSON: nested too deeply, or an integer of thousands of digits"
        raise DescriptionError(what, where=str(path)) from None
    if is_nested_deeply(table):
        raise DescriptionError("not valid JSON: nested too deeply", where=str(path))
    if not isinstance(table, dict):
        raise DescriptionError("not a description", where=str(path), allowed="one JSON object")
    return table


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
"""Section and key of each point in the file, by jounce's name."""
_BODIES = {
    "spindle": "Spindle",
    "upright": "Upright",
    "upper_arm": "Upper Control Arm",
    "lower_arm": "Lower Control Arm",
}
_CORNER_ADVICE = "Chrono's double wishbones with a linear spring and a damper map can be read."


@dataclass(frozen=True)
class DamperMap:
    """Damper force over length and velocity.

    Attributes
    ----------
    length : array (n,)
        Length between the damper's ends, ascending [m].
    velocity : array (m,)
        Rate of change of the length, ascending: positive in rebound [m/s].
    force : array (m, n)
        Force that resists the velocity, positive in tension [N].
    """

    length: Array
    velocity: Array
    force: Array

    def coefficients_at(self, length: float) -> tuple[float, float]:
        """Return bump and rebound coefficient (N s/m) at a length in m, from the velocities adjacent to zero."""
        zero = int(np.argmin(np.abs(self.velocity)))
        column = np.array([np.interp(length, self.length, row) for row in self.force])
        slopes = np.diff(column) / np.diff(self.velocity)
        return float(slopes[zero - 1]), float(slopes[zero])


@dataclass(frozen=True)
class ChronoCorner(Shown):
    """Left corner as described by the file, at design position.

    Attributes
    ----------
    name : str
        Name in the file.
    points : mapping of str to array (3,)
        Hardpoints [m], x forward, y left, z up.
    parts : mapping of str to RigidPart
        ``spindle``, ``upright``, ``upper_arm``, ``lower_arm``.
    tie_rod_mass : float
        Mass of the tie rod [kg].
    spring_rate, spring_free_length : float
        Rate [N/m] and free length [m] of the spring.
    spring_shortest, spring_longest : float
        Working range of the spring length [m].
    damper : DamperMap
        Force of the damper.
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

    def distance(self, first: str, second: str) -> float:
        """Distance between two hardpoints at design position in m."""
        return float(np.linalg.norm(self.points[first] - self.points[second]))


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
        JSON file of Chrono in SI; comments are allowed.

    Returns
    -------
    ChronoCorner
        The left corner with jounce's names; values are not converted.

    Raises
    ------
    DescriptionError
        For a missing file, invalid JSON (with the line), a different template, no linear spring or damper map, or
        values that are missing, not finite or of the wrong shape.

    Examples
    --------
    >>> from importlib import resources
    >>> folder = resources.files("jounce.parts") / "library" / "hmmwv"
    >>> read_chrono_corner(Path(str(folder)) / "HMMWV_DoubleWishboneFront_mapShock.json").spring_rate
    167062.0
    """
    file = ChronoFile(Path(path), ["DoubleWishbone"], _CORNER_ADVICE)
    parts = {name: file.part(section) for name, section in _BODIES.items()}
    points = {name: file.numbers(section, key, (3,)) for name, (section, key) in HARDPOINTS.items()}
    lengths = [
        file.positive("Spring", key) for key in ("Free Length", "Minimum Length", "Maximum Length")
    ]
    free, shortest, longest = lengths
    if not shortest < longest:
        raise DescriptionError(
            "the spring's lengths contradict each other", where=file.at("Spring"), found=lengths
        )
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
    """Read the damper map; each row starts with its velocity."""
    length = file.numbers("Shock", "Deformation", (-1,))
    rows = file.numbers("Shock", "Map Data", (-1, len(length) + 1))
    velocity = rows[:, 0]
    for name, values in (("Deformation", length), ("Map Data", velocity)):
        ascending(values, file.at("Shock", name))
    if not (
        velocity[0] < 0.0 < velocity[-1]
        and math.isclose(float(np.abs(velocity).min()), 0.0, abs_tol=1e-9)
    ):
        raise DescriptionError(
            "the velocities do not span zero",
            where=file.at("Shock", "Map Data"),
            found=velocity.tolist(),
            allowed="negative ones (bump), 0, positive ones (rebound)",
        )
    return DamperMap(length, velocity, rows[:, 1:])
