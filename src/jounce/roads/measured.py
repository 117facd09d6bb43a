"""Roads given by points: tables in the description or in a file, and measured courses in OpenCRG files."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from difflib import get_close_matches
from functools import lru_cache
from itertools import pairwise
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np

from jounce.core.columns import read_columns_csv
from jounce.core.errors import DescriptionError, RecordingError, is_of_system, resource_error
from jounce.core.files import State, existing_file, state_of
from jounce.core.phrases import Phrase
from jounce.core.process_settings import collect_warnings
from jounce.core.samples import Listed
from jounce.core.segments import Segments
from jounce.core.types import Array
from jounce.core.units import Length, Unit
from jounce.roads.profile import Profile, cubic_profile, lay_out, linear_profile, periodic_places
from jounce.roads.road import SampledRoad

Interpolation = Literal["linear", "cubic"]
FEWEST = {"linear": 2, "cubic": 4}
_JUMP, _STEEP = (
    1.0,
    10.0,
)  # m and 1; a higher and steeper step between rows is padding


Lengths = Annotated[tuple[Annotated[float, Unit("m")], ...], Listed]
Forces = Annotated[tuple[Annotated[float, Unit("N")], ...], Listed]
Times = Annotated[tuple[Annotated[float, Unit("s")], ...], Listed]


class Table(SampledRoad):
    """Heights at given points, with lines or a cubic spline between them.

    The first height continues before the first point, the last height after the last point (at `end`).

    Attributes
    ----------
    x, height : tuple of float
        Points in m: distance from ``start``, strictly ascending, and height. Mutually exclusive with ``file``.
    file : Path or None
        Text file with columns ``x`` and ``z`` with units, e.g. ``x [m], z [mm]``.
    interpolation : {"linear", "cubic"}
        Lines, or a not-a-knot cubic spline (at least 4 points).
    start : float
        Distance in m of x = 0; negative if the run begins inside the table.

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
        """Reject points that are missing, given twice, or not ascending."""
        check_source(self.file, {"x": self.x, "height": self.height}, self.interpolation)
        if self.file is not None:
            self.profile()

    def profile(self) -> Profile:
        """Return pieces through the points."""
        if self.file is not None:
            return file_profile(self.file, {"x": "m", "z": "m"}, self.interpolation)
        return point_profile(self.x, self.height, self.interpolation)

    def points(self) -> tuple[Array, Array]:
        """Return the given points: distance from ``start`` and height, each in m with shape (n,)."""
        if self.file is not None:
            return file_points(self.file, {"x": "m", "z": "m"}, FEWEST[self.interpolation])
        return np.asarray(self.x, dtype=float), np.asarray(self.height, dtype=float)


class Crg(SampledRoad):
    """Measured course from an OpenCRG file, straight or curved, at one lateral offset.

    The file's options determine the road before and after the course; usually the end heights continue.

    Attributes
    ----------
    file : Path
        The ``.crg`` file.
    v : float
        Lateral offset in m from the reference line, positive to the left.
    start : float
        Distance in m at which the course begins; negative when the run begins inside it.
    """

    kind: Literal["crg"] = "crg"
    start: Length = 0.0
    file: Path
    v: Length = 0.0

    def check(self) -> None:
        """Read the file, so that its errors are reported immediately."""
        if self.is_endless() and self.recurrence is not None:
            raise ValueError(
                "the course repeats according to the file's options; leave out recurrence"
            )

    def profile(self) -> Profile:
        """Return lines between the cross sections."""
        return self._course().profile

    def segments(self, distance: float, behind: float = 0.0) -> Segments:
        """Return the road over [0, ``distance``] (m) for a wheel that follows ``behind`` metres, as closed-form pieces.

        Raises
        ------
        DescriptionError
            If the run leaves a file that declares no road beyond its ends.
        """
        if (
            self._course().beyond == "nothing"
            and not self.start <= -behind <= distance - behind <= self.end()
        ):
            raise DescriptionError(
                "the run leaves the course, and BORDER_MODE_U = 0 states that there is no road beyond its ends",
                where=str(self.file),
                found=f"{0.0 - behind:g} to {distance - behind:g} m",
                allowed=Phrase("{start:g} to {end:g} m", start=self.start, end=self.end()),
            )
        return super().segments(distance, behind)

    def end(self) -> float:
        """Return the distance in m of the last cross section on the first pass."""
        return self.start + float(self._course().s[-1])

    def points(self) -> tuple[Array, Array]:
        """Return the cross sections: distance from ``start`` along the path and height, each in m with shape (n,)."""
        course = self._course()
        return course.s.copy(), course.height.copy()

    def known_length(self) -> float:
        """Return the distance in m of the last cross section; infinite if the course repeats."""
        return math.inf if self.is_endless() else super().known_length()

    def is_endless(self) -> bool:
        """Whether the course repeats according to the file's options."""
        return self._course().beyond in ("repeat", "reflect", "closed")

    def _course(self) -> CrgCourse:
        return read_course(self.file, self.v)

    def _between(self, low: float, high: float) -> Segments:
        course = self._course()
        if course.beyond in ("keep", "nothing"):
            return super()._between(low, high)
        places = periodic_places(self.start, course.profile.span, low, high)
        return lay_out(course.profile, places, low, high)


def check_source(
    file: Path | None, points: dict[str, tuple[float, ...]], interpolation: str
) -> None:
    """Raise ValueError for file and points together, unequal lengths, too few points, or x not ascending."""
    (x_name, x), (y_name, y) = points.items()
    if file is not None:
        if x or y:
            raise ValueError(
                Phrase(
                    "points and a file are both given; give either {x_name} and {y_name} or file",
                    x_name=x_name,
                    y_name=y_name,
                )
            )
        return
    if not x and not y:
        raise ValueError(
            Phrase("no points; give {x_name} and {y_name}, or file", x_name=x_name, y_name=y_name)
        )
    if len(x) != len(y):
        raise ValueError(
            Phrase(
                "{x_name} has {count} values and {y_name} has {second_count}; give equal numbers of both",
                x_name=x_name,
                count=len(x),
                y_name=y_name,
                second_count=len(y),
            )
        )
    if len(x) < FEWEST[interpolation]:
        raise ValueError(
            Phrase(
                "{count} points; {interpolation} interpolation needs at least {fewest}",
                count=len(x),
                interpolation=interpolation,
                fewest=FEWEST[interpolation],
            )
        )
    for i, (a, b) in enumerate(pairwise(x)):
        if b <= a:
            raise ValueError(
                Phrase(
                    "{x_name}[{i}] = {b:g} is not above {x_name}[{second_i}] = {a:g}; sort the points",
                    x_name=x_name,
                    i=i + 1,
                    b=b,
                    second_i=i,
                    a=a,
                )
            )


def point_profile(x: tuple[float, ...], height: tuple[float, ...], interpolation: str) -> Profile:
    """Return pieces through points that are known to ascend; ``x`` in m (or s), ``height`` in m."""
    make = linear_profile if interpolation == "linear" else cubic_profile
    return make(np.asarray(x, dtype=float), np.asarray(height, dtype=float))


def file_profile(
    file: Path, columns: dict[str, str], interpolation: str, fewest: int = 2
) -> Profile:
    """Return pieces through the two columns (name to SI unit) of a text file with at least ``fewest`` rows."""
    key = _key(file, columns, max(fewest, FEWEST[interpolation]))
    return _file_profile(key, interpolation)


def file_points(file: Path, columns: dict[str, str], fewest: int = 2) -> tuple[Array, Array]:
    """Read two columns (name to SI unit) of a text file with at least ``fewest`` rows; the first must ascend."""
    x, height = _file_points(_key(file, columns, fewest))
    return x.copy(), height.copy()


_Key = tuple[str, tuple[tuple[str, str], ...], int, State]


def _key(file: Path, columns: dict[str, str], fewest: int) -> _Key:
    """Return the cache key of a file: its columns and modification time."""
    return str(file), tuple(columns.items()), fewest, state_of(existing_file(file, RecordingError))


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
        raise RecordingError(
            "too few rows",
            where=file,
            found=len(x),
            allowed=Phrase("at least {fewest}", fewest=fewest),
        )
    steps = np.diff(x)
    if (steps < 0.0).all():
        raise RecordingError(
            Phrase("{name} decreases", name=name),
            where=f"{file}: column {table[name].label!r}",
            found=f"{x[0]:g} to {x[-1]:g} {unit}",
            hint="Reverse the order of the rows: the vehicle drives towards larger values.",
        )
    stays = np.flatnonzero(steps <= 0.0)
    if len(stays):
        i = int(stays[0])
        raise RecordingError(
            Phrase(
                "{name} does not increase from row {i} to row {second_i}",
                name=name,
                i=i + 1,
                second_i=i + 2,
            ),
            where=f"{file}: column {table[name].label!r}",
            found=f"{x[i]:g} {unit}, then {x[i + 1]:g} {unit}",
            hint="Sort the rows, and remove repeated ones.",
        )
    if unit == "m":
        _check_jumps(x, height, f"{file}: column {table[columns[1][0]].label!r}")
    return x, height


def _check_jumps(x: Array, height: Array, where: str) -> None:
    """Raise an error for jumps caused by padding, e.g. -9999 for missing values."""
    jumps = np.abs(np.diff(height))
    wild = np.flatnonzero((jumps > _JUMP) & (jumps > _STEEP * np.diff(x)))
    if len(wild):
        i = int(wild[0])
        raise RecordingError(
            Phrase(
                "the height jumps implausibly from row {i} to row {second_i}",
                i=i + 1,
                second_i=i + 2,
            ),
            where=where,
            found=f"{height[i]:g} m, then {height[i + 1]:g} m",
            hint="Fill the gap or remove the padding, and check the unit of the heights.",
        )


Beyond = Literal["keep", "nothing", "repeat", "reflect", "closed"]
_HARMLESS = re.compile(r"^unknown (keyword|data channel)|white space byte|header values used$")
HIGHEST = 1e4  # m; higher than any road
_SMALLEST = 1e-28  # m; rounding produces larger numbers, a wrong byte order smaller ones
_SPIKE = 1.0  # m; a single point that deviates by more is an error
_EDGE = 1e-9  # m; rounding of the lateral range
_BEYOND: dict[int, Beyond] = {0: "nothing", 1: "keep", 2: "keep", 3: "repeat", 4: "reflect"}


@dataclass(frozen=True)
class CrgCourse:
    """Heights along one lateral offset of an OpenCRG road, and its continuation beyond the ends.

    Attributes
    ----------
    s, height : ndarray, shape (n,)
        Distance driven along the path at that offset, from 0, and height, in m, at every cross section.
    profile : Profile
        Pieces of one pass, including smoothed ends and the link that closes a track.
    beyond : {"keep", "nothing", "repeat", "reflect", "closed"}
        Continuation according to the file's options: end level, no road, repetition, mirror image, or closed track.
    """

    s: Array
    height: Array
    profile: Profile
    beyond: Beyond


def read_crg_profile(path: Path | str, lateral_offset: float = 0.0) -> tuple[Array, Array]:
    """Read the heights of an OpenCRG road at one lateral offset.

    Heights are the sum of the reference line's elevation (its slope integrated), banking times offset and the grid,
    linear between the long sections (bilinear together with straight lines along u). Empty cross sections at the end
    of a binary file are padding and are omitted. Modifiers in the file are applied.

    Parameters
    ----------
    path : Path or str
        File of format KRBI, KDBI (binary), LRFI or LDFI (text), or one that refers to such a file.
    lateral_offset : float
        Offset v in m from the reference line, positive to the left; inside the grid, or outside it if the file's option
        BORDER_MODE_V defines the height there.

    Returns
    -------
    s : ndarray, shape (n,)
        Distance in m driven along the path at that offset, from 0 at the first cross section. On a straight line it
        is the distance u along the reference line; on the inside of a bend it is shorter: ds = (1 - v k) du with the
        curvature k, positive to the left.
    height : ndarray, shape (n,)
        Height z in m, positive upwards, before any smoothing at the ends.

    Raises
    ------
    RecordingError
        For a missing, damaged, truncated or inconsistent file, an offset outside the grid or beyond the centre of a
        bend, and missing heights at that offset.

    Notes
    -----
    Format: ASAM OpenCRG 1.2. As defined by the format, the reference line is straight between cross sections; corners
    of the offset path are on the bisectors. The default modifiers of OpenCRG tools for files without modifiers (filling
    gaps, moving the start to the origin) are not applied.
    """
    profile = read_course(path, lateral_offset)
    return profile.s.copy(), profile.height.copy()


def read_course(path: Path | str, lateral_offset: float = 0.0) -> CrgCourse:
    """Read the path at one lateral offset in m, with ends as defined by the file's options."""
    file = existing_file(path, RecordingError)
    return _course(str(file), float(lateral_offset), state_of(file))


@lru_cache(maxsize=16)
def _course(file: str, offset: float, _state: State) -> CrgCourse:
    road = _read(file)
    height = _height(road, offset, file)
    _check_heights(road, height, offset, file)
    s = np.concatenate([[0.0], np.cumsum(_steps(road, offset, file))])
    mode = int(road.get_option("border_mode_u"))
    profile, beyond = _smooth(road, s, height, file), _BEYOND[mode]
    if int(road.get_option("refline_continuation")) == 1:
        link = _link(road, offset, file)
        if link is not None:
            return CrgCourse(s, height, _close(profile, link, _levels(road, profile)), "closed")
    if beyond == "reflect":
        profile = _add_mirror(profile)
    elif beyond == "keep":
        before, after = _levels(road, profile)
        profile = Profile(profile.edges, profile.kind, profile.coefficients, before, after)
    return CrgCourse(s, height, profile, beyond)


def _read(file: str) -> Any:
    """Read and check a file; raise an error instead of guessing."""
    import pyopencrg

    try:
        with np.errstate(all="ignore"), collect_warnings():  # corrupt numbers overflow
            road = pyopencrg.read(file, check=False)
            problems = [*road.check().errors, *_overlong_rows(file)]
            if road.mods and not problems:
                road = road.apply_mods()
    except FileNotFoundError as error:
        raise RecordingError(
            _one_line(error, file), where=file, hint="Copy the file there, or correct the name."
        ) from None
    except (
        ValueError,
        OSError,
        IndexError,
        KeyError,
        ArithmeticError,
        TypeError,
        MemoryError,
    ) as error:
        if is_of_system(error):
            raise resource_error(error, file) from None
        raise RecordingError(
            Phrase("not a readable OpenCRG file: {one_line}", one_line=_one_line(error, file)),
            where=file,
        ) from None
    problems += [
        text for text in road.read_warnings if not _HARMLESS.search(text) or _is_misspelt(text)
    ]
    problems += [
        f"{name} above 100 %"
        for name in ("slope", "banking")
        if np.abs(np.asarray(getattr(road, name))).max() > 1.0
    ]
    if problems:
        text = "; ".join(
            problem.removeprefix("(reading) ") for problem in dict.fromkeys(problems[:2])
        )
        raise RecordingError(
            Phrase("the OpenCRG file is damaged or contradicts itself: {text}", text=text),
            where=file,
            hint="Use an undamaged copy.",
        )
    return road


def _is_misspelt(warning: str) -> bool:
    """Whether an unknown keyword or channel is probably a misspelt known one, whose values are then missing."""
    from pyopencrg.keywords import MODIFIER_KEYWORDS, OPTION_DEFAULTS, ROAD_CRG_KEYWORDS

    name = (re.findall(r"'([^',]*)", warning) or [""])[0].strip().lower()
    known = [
        *ROAD_CRG_KEYWORDS,
        *MODIFIER_KEYWORDS,
        *OPTION_DEFAULTS,
        "reference line slope",
        "reference line banking",
    ]
    near = get_close_matches(name, [*known, "reference line phi"], n=1, cutoff=0.93)
    return bool(near) or bool(get_close_matches(name[:12], ["long section"], n=1, cutoff=0.9))


def _overlong_rows(file: str) -> list[str]:
    """Report text rows with more values than the header defines (pyopencrg ignores them)."""
    from pyopencrg.io import read_ipl

    header = read_ipl(file, meta_only=True)
    width = {"LRFI": 10, "LDFI": 20}.get(header.fmt)
    if width is None or not header.kd_def:
        return []
    rows = Path(file).read_bytes()[header.data_offset :].splitlines()
    longest = width * min(len(header.kd_def), 80 // width)
    bad = [number for number, row in enumerate(rows, 1) if len(row.rstrip()) > longest]
    return (
        [
            f"row {bad[0]} of the data holds more than the {len(header.kd_def)} channels of the header"
        ]
        if bad
        else []
    )


def _one_line(error: Exception, file: str) -> str:
    return " ".join(str(error).split()).removeprefix(f"{file}: ") or type(error).__name__


def _height(road: Any, offset: float, file: str) -> Array:
    """Return the heights at the cross sections."""
    v = np.asarray(road.v, dtype=float)
    if v[0] - _EDGE <= offset <= v[-1] + _EDGE:
        return np.asarray(_grid_height(road, offset) + road.zr + road.banking * offset)
    mode = int(road.get_option("border_mode_v"))
    is_said = "border_mode_v" in road.opts and mode != 0
    if not is_said or (mode in (3, 4) and np.any(road.banking)):
        raise RecordingError(
            "the lateral offset is outside the road",
            where=file,
            found=f"{offset:g} m",
            allowed=Phrase("{v:g} to {second_v:g} m", v=v[0], second_v=v[-1]),
            hint="Programs differ in how they repeat a banked road sideways." if is_said else "",
        )
    inside = road.copy()
    inside.opts = {
        **road.opts,
        "border_smooth_ubeg": 0.0,
        "border_smooth_uend": 0.0,
        "refline_continuation": 0,
    }
    inside.opts["border_mode_u"] = 2
    return np.asarray(inside.uv_to_z(road.u, np.full(road.nu, offset)), dtype=float)


def _grid_height(road: Any, offset: float) -> Array:
    """Return grid heights at the offset, interpolated linearly between adjacent long sections."""
    v = np.asarray(road.v, dtype=float)
    right = int(np.clip(np.searchsorted(v, offset, side="right") - 1, 0, len(v) - 2))
    share = float(np.clip((offset - v[right]) / (v[right + 1] - v[right]), 0.0, 1.0))
    grid = np.asarray(road.z, dtype=float)
    if share in (0.0, 1.0):  # gaps in the other section have no effect
        return grid[:, right + int(share)].copy()
    return np.asarray((1.0 - share) * grid[:, right] + share * grid[:, right + 1])


def _check_heights(road: Any, height: Array, offset: float, file: str) -> None:
    """Raise an error for gaps and implausible heights."""
    grid = np.abs(np.asarray(road.z, dtype=float))
    damage = ""
    if max(np.nanmax(np.abs(height), initial=0.0), np.nanmax(grid, initial=0.0)) > HIGHEST:
        damage = "heights above 10 km"
    elif ((grid > 0.0) & (grid < _SMALLEST)).any():
        damage = Phrase(
            "heights below {smallest:g} m, as a wrong byte order produces", smallest=_SMALLEST
        )
    elif len(height) > 2:
        out = np.abs(height[1:-1] - height[:-2]), np.abs(height[1:-1] - height[2:])
        spikes = np.flatnonzero(
            (out[0] > _SPIKE) & (out[1] > _SPIKE) & (np.abs(height[2:] - height[:-2]) < _SPIKE)
        )
        if len(spikes):
            damage = f"a single height at u = {road.u[spikes[0] + 1]:g} m stands out by {out[0][spikes[0]]:.3g} m"
    if damage:
        raise RecordingError(
            Phrase("the OpenCRG file is damaged: {damage}", damage=damage),
            where=file,
            hint="Use an undamaged copy.",
        )
    if not np.isfinite(height).all():
        bad = int(np.flatnonzero(~np.isfinite(height))[0])
        raise RecordingError(
            Phrase(
                "no height at u = {u:g} m for the lateral offset {offset:g} m",
                u=road.u[bad],
                offset=offset,
            ),
            where=file,
            hint="Choose another lateral offset, or fill the gap in the file.",
        )


def _steps(road: Any, offset: float, file: str) -> Array:
    """Return the distances in m along the path between successive cross sections."""
    if road.is_straight or offset == 0.0:
        return np.diff(np.asarray(road.u, dtype=float))
    x, y = (np.asarray(value) for value in road.uv_to_xy(road.u, np.full(road.nu, offset)))
    along = np.diff(x) * np.diff(road.x) + np.diff(y) * np.diff(road.y)
    if (along <= 0.0).any():
        u = float(road.u[int(np.argmin(along))])
        raise RecordingError(
            "the lateral offset is beyond the centre of a bend",
            where=file,
            found=f"{offset:g} m at u = {u:g} m",
            hint="Choose an offset nearer to the reference line.",
        )
    return np.asarray(np.hypot(np.diff(x), np.diff(y)))


def _smooth(road: Any, s: Array, height: Array, file: str) -> Profile:
    """Join the cross sections by lines; blend smoothed ends into the level of the reference line."""
    first, last = (float(road.get_option(f"border_smooth_{end}")) for end in ("ubeg", "uend"))
    if first <= 0.0 and last <= 0.0:
        return linear_profile(s, height)
    u = np.asarray(road.u - road.u_start, dtype=float)
    if first + last > u[-1]:
        raise RecordingError(
            "the smoothed ends overlap",
            where=file,
            found=f"{first:g} m and {last:g} m of {u[-1]:g} m",
            hint="Programs treat this differently; make BORDER_SMOOTH_UBEG or BORDER_SMOOTH_UEND smaller.",
        )
    marks = [mark for mark in (first, float(u[-1]) - last) if 0.0 < mark < u[-1]]
    nodes = np.unique(np.concatenate([u, marks]))
    level = np.interp(nodes, u, height)
    pieces = np.zeros((len(nodes) - 1, 4))  # polynomials in the normalised coordinate of the piece
    pieces[:, 0], pieces[:, 1] = level[:-1], np.diff(level)
    for zone, base, near in ((first, road.zr[0], nodes), (last, road.zr[-1], u[-1] - nodes)):
        if zone > 0.0:
            weight = np.minimum(near / zone, 1.0)
            pieces[:, 0] -= base
            pieces = weight[:-1, None] * pieces + np.diff(weight)[:, None] * np.roll(
                pieces, 1, axis=1
            )
            pieces[:, 0] += base
    edges = np.interp(nodes, u, s)
    pieces /= np.diff(edges)[:, None] ** np.arange(4)
    kind = np.zeros(len(pieces), dtype=np.int64)
    end = pieces[-1] @ (edges[-1] - edges[-2]) ** np.arange(4)
    return Profile(edges, kind, pieces, float(pieces[0, 0]), float(end))


def _levels(road: Any, profile: Profile) -> tuple[float, float]:
    """Return heights in m before and after the course: end heights or zero, with offset or smoothing."""
    smooth = [float(road.get_option(f"border_smooth_{end}")) > 0.0 for end in ("ubeg", "uend")]
    keeps = int(road.get_option("border_mode_u")) != 1
    offset = float(road.get_option("border_offset_u"))
    before = profile.before if smooth[0] else (profile.before if keeps else 0.0) + offset
    after = profile.after if smooth[1] else (profile.after if keeps else 0.0) + offset
    return before, after


def _add_mirror(profile: Profile) -> Profile:
    """Add the mirror image of a profile of lines and polynomials behind it."""
    span = np.diff(profile.edges)[::-1]
    c = profile.coefficients[::-1]
    powers = span[:, None] ** np.arange(4)
    shifted = np.stack(  # the same polynomial reversed, starting from its far end
        [
            (c * powers).sum(axis=1),
            -(c[:, 1:] * powers[:, :3] * np.arange(1, 4)).sum(axis=1),
            c[:, 2] + 3.0 * c[:, 3] * span,
            -c[:, 3],
        ],
        axis=1,
    )
    edges = np.concatenate([profile.edges, profile.edges[-1] + np.cumsum(span)])
    kind = np.concatenate([profile.kind, profile.kind[::-1]])
    return Profile(
        edges, kind, np.concatenate([profile.coefficients, shifted]), profile.before, profile.before
    )


def _link(road: Any, offset: float, file: str) -> tuple[float, float] | None:
    """Return lengths in m of the lines after the end and before the start that close a track; None if it is open."""
    from pyopencrg.evaluate import closure

    begin, end, length = closure(road)
    if length == 0.0:
        return None
    if int(road.get_option("border_mode_u")) not in (1, 2):
        raise RecordingError(
            "the track is closed, but BORDER_MODE_U says that there is no road in its gap",
            where=file,
            allowed="BORDER_MODE_U = 1 or 2",
        )
    turn = float(road.phi_start - road.phi_end)
    half = np.tan(0.5 * np.arctan2(np.sin(turn), np.cos(turn)))  # the lines meet on the bisector
    after, before = (
        float(end - road.u_end - offset * half),
        float(road.u_start - begin - offset * half),
    )
    if min(after, before) < -_EDGE:
        raise RecordingError(
            "the lateral offset is beyond the corner that closes the track",
            where=file,
            found=f"{offset:g} m",
            hint="Choose an offset nearer to the reference line.",
        )
    return max(after, 0.0), max(before, 0.0)


def _close(profile: Profile, link: tuple[float, float], levels: tuple[float, float]) -> Profile:
    """Add the closing link after the course: level at the end height, then at the start height."""
    lines = [
        (length, level)
        for length, level in zip(link, reversed(levels), strict=True)
        if length > _EDGE
    ]
    edges = np.concatenate(
        [profile.edges, profile.edges[-1] + np.cumsum([length for length, _ in lines])]
    )
    kind = np.append(profile.kind, np.zeros(len(lines), dtype=np.int64))
    level = [[height, 0.0, 0.0, 0.0] for _, height in lines]
    coefficients = np.concatenate([profile.coefficients, np.reshape(level, (-1, 4))])
    return Profile(edges, kind, coefficients, levels[0], levels[0])
