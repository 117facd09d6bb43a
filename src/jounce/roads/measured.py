"""Roads given by points: tables in the description or in a file, and measured OpenCRG courses."""

from __future__ import annotations

from functools import lru_cache
from itertools import pairwise
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
from pydantic import BeforeValidator

from jounce.core.columns import read_columns_csv
from jounce.core.errors import DescriptionError, RecordingError
from jounce.core.files import existing_file
from jounce.core.segments import Segments
from jounce.core.types import Array
from jounce.core.units import Length, Unit
from jounce.roads.opencrg import Course, read_course
from jounce.roads.profile import Profile, cubic_profile, laid_out, linear_profile, periodic_places
from jounce.roads.road import Road

Interpolation = Literal["linear", "cubic"]
FEWEST = {"linear": 2, "cubic": 4}
_JUMP, _STEEP = 1.0, 10.0  # m and 1; a step from one row to the next that is higher and steeper is padding, no road


def _plain(value: object) -> object:
    return value.tolist() if isinstance(value, np.ndarray) else value


Lengths = Annotated[tuple[Annotated[float, Unit("m")], ...], BeforeValidator(_plain)]
Times = Annotated[tuple[Annotated[float, Unit("s")], ...], BeforeValidator(_plain)]


class Table(Road):
    """Heights at given points, with lines or a cubic spline between them.

    Before the first point its height holds, after the last point the last one's (`end` says where that is).

    Attributes
    ----------
    x, height : tuple of float
        Points in m: distance from ``start``, strictly ascending, and height. Either these or ``file``.
    file : Path or None
        Text file with the columns ``x`` and ``z``, each with its unit, e.g. ``x [m], z [mm]``.
    interpolation : {"linear", "cubic"}
        Lines, or a not-a-knot cubic spline (at least 4 points).
    start : float
        Distance in m at which x = 0 lies; negative when the drive begins inside the table.

    Examples
    --------
    >>> road = Table(x=["0 m", "0.5 m", "2 m"], height=["0 mm", "10 mm", "0 mm"])
    >>> float(road.height_at(0.25)), road.end()
    (0.005, 2.0)
    """

    kind: Literal["table"] = "table"
    start: Length = 0.0
    x: Lengths = ()
    height: Lengths = ()
    file: Path | None = None
    interpolation: Interpolation = "linear"

    def check(self) -> None:
        """Refuse points that are missing, given twice, or do not ascend."""
        check_source(self.file, {"x": self.x, "height": self.height}, self.interpolation)
        if self.file is not None:
            self.profile()

    def profile(self) -> Profile:
        """Pieces through the points."""
        if self.file is not None:
            return file_profile(self.file, {"x": "m", "z": "m"}, self.interpolation)
        return point_profile(self.x, self.height, self.interpolation)

    def points(self) -> tuple[Array, Array]:
        """Points as they are given: distance from ``start`` and height, both in m, each of shape (n,)."""
        if self.file is not None:
            return file_points(self.file, {"x": "m", "z": "m"}, FEWEST[self.interpolation])
        return np.asarray(self.x, dtype=float), np.asarray(self.height, dtype=float)


class Crg(Road):
    """Measured course from an OpenCRG file, straight or curved, at one lateral offset.

    What lies before and after the course is what the file's options say: usually its first and last height.

    Attributes
    ----------
    file : Path
        The ``.crg`` file.
    v : float
        Lateral offset in m from the reference line, left positive.
    start : float
        Distance in m at which the course begins; negative when the drive begins inside it.
    """

    kind: Literal["crg"] = "crg"
    start: Length = 0.0
    file: Path
    v: Length = 0.0

    def check(self) -> None:
        """Read the file, so that whatever is wrong with it is said at once."""
        if self.is_endless() and self.recurrence is not None:
            raise ValueError("the options of the file say that the course repeats; leave out recurrence")

    def profile(self) -> Profile:
        """Lines between the cross sections."""
        return self._course().profile

    def segments(self, distance: float, behind: float = 0.0) -> Segments:
        """Give the road over [0, ``distance``] (m) for a wheel that follows ``behind`` metres, as closed-form pieces.

        Raises
        ------
        DescriptionError
            When the file says that there is no road beyond its ends and the drive goes there.
        """
        if self._course().beyond == "nothing" and not self.start <= -behind <= distance - behind <= self.end():
            raise DescriptionError(
                "the drive leaves the course, and the option BORDER_MODE_U = 0 says that there is no road",
                where=str(self.file),
                found=f"{0.0 - behind:g} to {distance - behind:g} m",
                allowed=f"{self.start:g} to {self.end():g} m",
            )
        return super().segments(distance, behind)

    def end(self) -> float:
        """Distance in m at which the last cross section lies on the first pass."""
        return self.start + float(self._course().s[-1])

    def points(self) -> tuple[Array, Array]:
        """Cross sections: distance from ``start`` along the path and height, both in m, each of shape (n,)."""
        course = self._course()
        return course.s.copy(), course.height.copy()

    def is_endless(self) -> bool:
        """Whether the file's options say that the course repeats."""
        return self._course().beyond in ("repeat", "reflect", "closed")

    def _course(self) -> Course:
        return read_course(self.file, self.v)

    def _between(self, low: float, high: float) -> Segments:
        course = self._course()
        if course.beyond in ("keep", "nothing"):
            return super()._between(low, high)
        places = periodic_places(self.start, course.profile.span, low, high)
        return laid_out(course.profile, places, low, high)


def check_source(file: Path | None, points: dict[str, tuple[float, ...]], interpolation: str) -> None:
    """Refuse (ValueError) a mixture of file and points, lists of unequal length, too few points, x not ascending."""
    (x_name, x), (y_name, y) = points.items()
    if file is not None:
        if x or y:
            raise ValueError(f"points and a file are both given; give either {x_name} and {y_name} or file")
        return
    if not x and not y:
        raise ValueError(f"no points; give {x_name} and {y_name}, or file")
    if len(x) != len(y):
        raise ValueError(f"{x_name} has {len(x)} values and {y_name} has {len(y)}; give as many of both")
    if len(x) < FEWEST[interpolation]:
        raise ValueError(f"{len(x)} points; {interpolation} interpolation needs at least {FEWEST[interpolation]}")
    for i, (a, b) in enumerate(pairwise(x)):
        if b <= a:
            raise ValueError(f"{x_name}[{i + 1}] = {b:g} does not lie above {x_name}[{i}] = {a:g}; sort the points")


def point_profile(x: tuple[float, ...], height: tuple[float, ...], interpolation: str) -> Profile:
    """Pieces through points that are known to ascend; ``x`` in m (or s), ``height`` in m."""
    make = linear_profile if interpolation == "linear" else cubic_profile
    return make(np.asarray(x, dtype=float), np.asarray(height, dtype=float))


def file_profile(file: Path, columns: dict[str, str], interpolation: str, fewest: int = 2) -> Profile:
    """Pieces through the two columns (name to SI unit) of a text file with at least ``fewest`` rows."""
    key = _key(file, columns, max(fewest, FEWEST[interpolation]))
    return _file_profile(key, interpolation)


def file_points(file: Path, columns: dict[str, str], fewest: int = 2) -> tuple[Array, Array]:
    """Two columns (name to SI unit) of a text file with at least ``fewest`` rows, the first of which ascends."""
    x, height = _file_points(_key(file, columns, fewest))
    return x.copy(), height.copy()


_Key = tuple[str, tuple[tuple[str, str], ...], int, int, int]


def _key(file: Path, columns: dict[str, str], fewest: int) -> _Key:
    """What a file is remembered by: its columns, and when it was changed."""
    status = existing_file(file, RecordingError).stat()
    return str(file), tuple(columns.items()), fewest, status.st_mtime_ns, status.st_size


@lru_cache(maxsize=16)
def _file_profile(key: _Key, interpolation: str) -> Profile:
    return (linear_profile if interpolation == "linear" else cubic_profile)(*_file_points(key))


@lru_cache(maxsize=16)
def _file_points(key: _Key) -> tuple[Array, Array]:
    file, columns, fewest = key[:3]
    table = read_columns_csv(file)
    x, height = (table[name].in_si(si) for name, si in columns)
    name, unit = columns[0]
    if len(x) < fewest:
        raise RecordingError("too few rows", where=file, found=len(x), allowed=f"at least {fewest}")
    steps = np.diff(x)
    if (steps < 0.0).all():
        raise RecordingError(
            f"{name} runs backwards",
            where=f"{file}: column {table[name].label!r}",
            found=f"{x[0]:g} to {x[-1]:g} {unit}",
            hint="Reverse the order of the rows; the drive goes towards larger values.",
        )
    stays = np.flatnonzero(steps <= 0.0)
    if len(stays):
        i = int(stays[0])
        raise RecordingError(
            f"{name} does not ascend from row {i + 1} to row {i + 2}",
            where=f"{file}: column {table[name].label!r}",
            found=f"{x[i]:g} {unit}, then {x[i + 1]:g} {unit}",
            hint="Sort the rows, and remove repeated ones.",
        )
    if unit == "m":
        _check_jumps(x, height, f"{file}: column {table[columns[1][0]].label!r}")
    return x, height


def _check_jumps(x: Array, height: Array, where: str) -> None:
    """Refuse heights that jump as padding does, e.g. -9999 where nothing was measured."""
    jumps = np.abs(np.diff(height))
    wild = np.flatnonzero((jumps > _JUMP) & (jumps > _STEEP * np.diff(x)))
    if len(wild):
        i = int(wild[0])
        raise RecordingError(
            f"the height jumps from row {i + 1} to row {i + 2} as no road does",
            where=where,
            found=f"{height[i]:g} m, then {height[i + 1]:g} m",
            hint="Fill the gap or remove the padding, and check the unit of the heights.",
        )
