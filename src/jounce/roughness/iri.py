"""Longitudinal profiles from files, and their international roughness index by the original algorithm."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from jounce.core.columns import text_of
from jounce.core.errors import RecordingError, at_line
from jounce.core.findings import Finding, finding
from jounce.core.operation import File, Number, operation
from jounce.core.phrases import Phrase
from jounce.core.recursion import first_order
from jounce.core.samples import as_samples
from jounce.core.serialise import Plain, to_plain
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.recordings.files import read_columns
from jounce.recordings.options import COLUMNS
from jounce.recordings.quality import check_ascending
from jounce.roads.loading import road_library
from jounce.roads.measured import read_crg_profile

SPEED = 80.0 / 3.6  # m/s; with the golden car's numbers by definition of the IRI
TYRE, SPRING, DAMPER, MASS_RATIO = (
    653.0,
    63.3,
    6.0,
    0.15,
)  # per sprung mass: 1/s^2, 1/s^2, 1/s; unsprung over sprung
BASE = 0.25  # m: base length of a slope
RUN_UP = 11.0  # m: length whose mean slope initialises the car, WTP-46
COARSEST, COARSE = (
    0.61,
    0.3,
)  # m between samples: WTP-46 allows up to 0.61 m (2 ft); above BASE short waves are lost
LARGEST_JITTER = (
    0.01  # share of the spacing: tolerates rounded positions, but not a missing row (1)
)
SMOOTHEST, ROUGHEST, NO_ROAD = 0.1, 30.0, 300.0
"""m/km. The scale of WTP-46 ranges from runways (0.25) to rough unpaved roads (20). Ten times ``ROUGHEST`` is rejected:
heights in mm read as m increase the index by a factor of a thousand."""
_NEARLY = 1e-6  # of a sample interval, or m: rounding tolerance
_TEXT = (".csv", ".txt", ".tsv")


@dataclass(frozen=True)
class RoughnessSegment:
    """Roughness of one part of a profile.

    Attributes
    ----------
    start, end : float
        Start and end distance, m.
    iri_m_per_km : float
        Mean rectified slope of the golden car, m/km.
    partial : bool
        Whether it is the shorter remainder at the end.
    """

    start: float
    end: float
    iri_m_per_km: float
    partial: bool


@dataclass(frozen=True)
class Roughness(Shown):
    """International roughness index of a profile and of its segments.

    Attributes
    ----------
    iri_m_per_km : float
        IRI of the whole profile, m/km (equal to mm/m).
    start, end : float
        Start and end of the profile, m.
    spacing : float
        Sample spacing, m.
    base : float
        Base length of the slopes, m: 0.25 m rounded to whole samples.
    segment : float
        Length of the segments, m.
    segments : tuple of RoughnessSegment
        Segments in order; the car's state is continuous at their borders.
    findings : tuple of Finding
        Limitations of the results.
    """

    iri_m_per_km: float
    start: float
    end: float
    spacing: float
    base: float
    segment: float
    segments: tuple[RoughnessSegment, ...]
    findings: tuple[Finding, ...] = ()

    def __str__(self) -> str:
        lines = [
            f"IRI {self.iri_m_per_km:.3f} m/km from {self.start:g} m to {self.end:g} m, every {self.spacing:g} m"
        ]
        for part in self.segments:
            rest = " (partial)" if part.partial else ""
            lines.append(
                f"{part.start:12.3f} m {part.end:12.3f} m {part.iri_m_per_km:9.3f} m/km{rest}"
            )
        return "\n".join([*lines, *map(str, self.findings)])


def iri(
    distance: ArrayLike,
    height: ArrayLike,
    *,
    segment: float | str = 100.0,
    run_up: float | str = RUN_UP,
    place: str = "profile",
) -> Roughness:
    """Compute the international roughness index (IRI) of one wheel track.

    Parameters
    ----------
    distance : array_like, shape (n,)
        Positions in m, ascending in constant steps of at most 0.61 m; not resampled.
    height : array_like, shape (n,)
        Heights in m.
    segment : float or str
        Length of the segments, m or text with a unit.
    run_up : float or str
        Length in m whose mean slope defines the car's initial state; 11 m by definition (some programs use 0.5 s at
        80 km/h, 11.11 m).
    place : str
        Name of the profile in messages, e.g. its file.

    Returns
    -------
    Roughness
        Index of the whole profile and of each segment, m/km.

    Raises
    ------
    RecordingError
        For distances that are not uniform or descend, values that are not finite, samples too far apart, a profile that
        is too short, and heights that are implausible for a road.

    Notes
    -----
    Source: World Bank Technical Paper 46 (``wtp-46``), ASTM E1926. Slopes over 0.25 m in whole samples drive a quarter
    car at 80 km/h (``golden car``), propagated exactly from sample to sample; the index is the mean of the absolute
    difference between the slopes of its sprung and its unsprung mass. It is not a measure of the profile's height, and
    not the roughness of a lane, which is the mean of two wheel tracks.

    Examples
    --------
    >>> import numpy as np
    >>> x = np.arange(0.0, 2000.1, 0.25)
    >>> wave = iri(x, 0.010 * np.sin(2.0 * np.pi * x / 15.4), segment="1 km")
    >>> round(wave.iri_m_per_km, 3), len(wave.segments)
    (3.975, 2)
    """
    x = as_samples(distance, "m", where=f"{place}: distance")
    z = as_samples(height, "m", where=f"{place}: height")
    length, start_length = to_si(segment, "m", where="segment"), to_si(run_up, "m", where="run_up")
    spacing = _check_spacing(x, z, place)
    samples = base_samples(spacing)
    base = samples * spacing
    _check_lengths(x, spacing, base, length, start_length, place)
    trace = rectified_slope(z, spacing, start_length)
    whole = 1e3 * float(trace.mean())
    findings = _findings(whole, spacing, place)
    segments = _segments(trace, float(x[0]), float(x[-1]), spacing, base, length)
    return Roughness(whole, float(x[0]), float(x[-1]), spacing, base, length, segments, findings)


def base_samples(spacing: float) -> int:
    """Return the number of sample intervals in the base of a slope: 0.25 m over ``spacing`` (m), at least 1."""
    return max(1, math.floor(BASE / spacing + 0.5 + _NEARLY))


def rectified_slope(height: Array, spacing: float, run_up: float = RUN_UP) -> Array:
    """Compute the absolute slope difference (m/m) between the masses of the golden car after each step of a profile.

    ``height`` (m) has samples every ``spacing`` (m); the car starts with the mean slope over ``run_up`` (m). The
    result has one value per slope: the number of samples minus the number of intervals in the base.
    """
    count = base_samples(spacing)
    slope = (height[count:] - height[:-count]) / (count * spacing)
    ahead = float(np.interp(run_up / spacing, np.arange(height.size), height) - height[0]) / run_up
    values, vectors, inverse = _modes()
    factors = np.exp(values * spacing / SPEED)
    drive = (factors - 1.0) / values * (inverse @ _drive())
    shown = vectors[0] - vectors[2]
    rest = inverse @ np.array([ahead, 0.0, ahead, 0.0])
    upper = [
        i for i, value in enumerate(values) if value.imag > 0.0
    ]  # the other two modes are their conjugates
    result = sum(
        2.0 * (shown[i] * first_order(slope * drive[i], complex(factors[i]), complex(rest[i]))).real
        for i in upper
    )
    return np.asarray(abs(result), dtype=float)


def state_transition(spacing: float) -> tuple[Array, Array]:
    """Return the matrices of one step along the profile: ``Z[i+1] = ST Z[i] + PR slope`` (slope form, s for the rates).

    ``Z`` holds the slopes (1) and their rates (1/s) of sprung and unsprung mass; ``spacing`` is the step in m.
    """
    values, vectors, inverse = _modes()
    factors = np.exp(values * spacing / SPEED)
    step = (vectors * factors) @ inverse
    drive = vectors @ ((factors - 1.0) / values * (inverse @ _drive()))
    return np.ascontiguousarray(step.real), np.ascontiguousarray(drive.real)


def golden_car_response(wavelength: ArrayLike) -> NDArray[np.complex128]:
    """Return the golden car's slope difference over the slope of a sinusoidal road (1), by wavelength in m.

    This is the quarter car alone at 80 km/h, without the 0.25 m base, whose gain is ``sinc(0.25 m / wavelength)``.
    """
    s = 2j * math.pi * SPEED / np.asarray(wavelength, dtype=float)
    values, vectors, inverse = _modes()
    drive = (vectors[0] - vectors[2]) * (inverse @ _drive())
    return np.asarray(np.sum(drive / (s[..., None] - values), axis=-1), dtype=np.complex128)


def _system() -> Array:
    return np.array(
        [
            [0.0, 1.0, 0.0, 0.0],
            [-SPRING, -DAMPER, SPRING, DAMPER],
            [0.0, 0.0, 0.0, 1.0],
            [
                SPRING / MASS_RATIO,
                DAMPER / MASS_RATIO,
                -(TYRE + SPRING) / MASS_RATIO,
                -DAMPER / MASS_RATIO,
            ],
        ]
    )


def _drive() -> Array:
    return np.array([0.0, 0.0, 0.0, TYRE / MASS_RATIO])


def _modes() -> tuple[NDArray[np.complex128], NDArray[np.complex128], NDArray[np.complex128]]:
    """Return eigenvalues (1/s), eigenvectors and their inverse, for an exact and cheap matrix exponential."""
    values, vectors = np.linalg.eig(_system())
    return values, vectors, np.linalg.inv(vectors)


def _segments(
    trace: Array, start: float, end: float, spacing: float, base: float, length: float
) -> tuple[RoughnessSegment, ...]:
    """Return means over the steps whose midpoints are in a segment."""
    middle = 0.5 * base + spacing * np.arange(trace.size)
    whole = math.floor((end - start) / length + _NEARLY)
    number = np.floor(middle / length + 1e-9).astype(int)
    counts, sums = np.bincount(number), np.bincount(number, weights=trace)
    return tuple(
        RoughnessSegment(
            start + i * length,
            min(start + (i + 1) * length, end),
            1e3 * float(sums[i] / counts[i]),
            partial=i >= whole,
        )
        for i in range(len(counts))
        if counts[i]
    )


def _check_spacing(x: Array, z: Array, place: str) -> float:
    """Check that distances and heights form a profile; return the sample spacing, m."""
    if x.ndim != 1 or x.shape != z.shape:
        problem = "distance and height are not two columns of the same length"
        raise RecordingError(problem, where=place, found=f"shapes {x.shape} and {z.shape}")
    if x.size < 3:
        raise RecordingError(
            "too few samples", where=place, found=x.size, allowed="a profile longer than 11 m"
        )
    for name, values in (("distance", x), ("height", z)):
        _check_finite(values, f"{place}: {name}")
    if np.all(np.diff(x) < 0.0):
        raise RecordingError(
            "the distance decreases", where=place, hint="Reverse the order of the rows."
        )
    steps = check_ascending(x, "distance", "m", where=place)
    spacing = float(x[-1] - x[0]) / (x.size - 1)
    usual = float(np.median(steps))
    jitter = abs(steps - usual)
    if jitter.max() > LARGEST_JITTER * usual + 1e-9 * abs(x).max():
        row = int(jitter.argmax()) + 1
        raise RecordingError(
            Phrase("the samples are not evenly spaced: see row {row}", row=row + 1),
            where=place,
            found=f"a step of {steps[row - 1]:.6g} m",
            allowed=Phrase("{usual:.6g} m within 1 %, as elsewhere in the profile", usual=usual),
            hint="Is a row missing, or was distance written with too few digits?",
        )
    return spacing


def _check_finite(values: Array, where: str) -> None:
    bad = ~np.isfinite(values)
    if not bad.any():
        return
    inside = np.flatnonzero(~bad)
    row = int(np.argmax(bad))
    padding = inside.size > 0 and not bad[inside[0] : inside[-1] + 1].any()
    hint = "Cut off the padding." if padding else "Fill the gap, or evaluate the parts separately."
    what = Phrase(
        "{count} values are not finite numbers, the first at row {row}",
        count=int(bad.sum()),
        row=row + 1,
    )
    raise RecordingError(what, where=where, found=str(values[row]), hint=hint)


def _check_lengths(
    x: Array, spacing: float, base: float, segment: float, run_up: float, place: str
) -> None:
    if spacing > COARSEST:
        raise RecordingError(
            "the samples are too far apart for the roughness index",
            where=place,
            found=f"{spacing:g} m",
            allowed=Phrase("at most {coarsest} m", coarsest=COARSEST),
            hint="Is the distance in the unit given in its header?",
        )
    if not run_up > 0.0:
        raise RecordingError("the run-up is not positive", where=place, found=f"{run_up:g} m")
    if not segment >= max(base, spacing):
        raise RecordingError(
            "the segment is too short",
            where=place,
            found=f"{segment:g} m",
            allowed=Phrase("at least {base:g} m", base=base),
        )
    total = float(x[-1] - x[0])
    if total < run_up + base - _NEARLY:
        raise RecordingError(
            "the profile is too short for the roughness index",
            where=place,
            found=f"{total:g} m",
            allowed=Phrase(
                "at least {run_up:g} m: {second_run_up:g} m to settle the initial state and {base:g} m for one slope",
                run_up=run_up + base,
                second_run_up=run_up,
                base=base,
            ),
            hint="Is the distance in the unit given in its header?",
        )


def _findings(whole: float, spacing: float, place: str) -> tuple[Finding, ...]:
    if whole > NO_ROAD:
        raise RecordingError(
            "these heights are implausible for a road",
            where=place,
            found=f"IRI {whole:.4g} m/km",
            allowed=Phrase(
                "at most {no_road:g} m/km; the roughest tracks have about {roughest:g}",
                no_road=NO_ROAD,
                roughest=ROUGHEST,
            ),
            hint="Are heights and distances in the units given in their headers?",
        )
    findings = []
    if whole > ROUGHEST:
        findings.append(finding("roughness.rougher", place, whole, iri=whole))
    if 0.0 < whole < SMOOTHEST:
        findings.append(finding("roughness.smoother", place, whole, iri=whole))
    if spacing > COARSE:
        findings.append(finding("roughness.spacing", place, spacing, spacing=spacing))
    return tuple(findings)


def read_profile(
    path: Path | str, *, columns: Mapping[str, str] | None = None, lateral_offset: float = 0.0
) -> tuple[Array, Array, list[Finding]]:
    r"""Read distance and height (m) of a longitudinal profile, with findings on assumptions and errors.

    The file is text with columns ``x`` and ``z`` (``x [m], z [mm]``) or two columns without a header in m, any other
    format of recordings, or a straight OpenCRG road (``.crg``). The name of a shipped road is also accepted. From an
    OpenCRG road the line at ``lateral_offset`` (m, positive to the left) is read. ``columns`` maps ``x`` and ``z`` to
    other names: ``{"z": "elevation [mm]"}``. Curved roads, unknown columns and incompatible units are rejected.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "track.csv"
    >>> _ = file.write_text("x [m], z [mm]\n0, 0\n0.25, 1.5\n")
    >>> read_profile(file)[1].tolist()
    [0.0, 0.0015]
    """
    file = road_library().get(str(path), Path(path))
    if file.suffix.lower() == ".crg":
        return *read_crg_profile(file, lateral_offset), []
    if lateral_offset:
        raise RecordingError(
            "only OpenCRG roads have lateral offsets",
            where=str(file),
            found=f"{lateral_offset:g} m",
            allowed="0 m",
        )
    if columns is None and file.suffix.lower() in _TEXT and file.is_file() and _is_bare(file):
        return _bare_columns(file)
    values, findings = read_columns(file, {"x": "m", "z": "m"}, columns=columns)
    return values["x"], values["z"], findings


@dataclass(frozen=True)
class ProfileRoughness(Plain):
    """A profile from a file and its roughness.

    Attributes
    ----------
    profile : str
        File, or name of a shipped road.
    offset : float
        Lateral offset of the profile in an OpenCRG road, m.
    roughness : Roughness
        Index of the whole profile and of each segment.
    distance, height : ndarray, shape (n,)
        Distance and height of the profile, m.
    findings : tuple of Finding
        Assumptions made when reading the file, and limitations of the results.
    """

    profile: str
    offset: float
    roughness: Roughness
    distance: Array
    height: Array
    findings: tuple[Finding, ...]

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, SI."""
        result = to_plain(self.roughness)
        return {
            "profile": self.profile,
            "offset": self.offset,
            **result,
            "findings": to_plain(self.findings),
        }

    def rows(self) -> list[dict[str, Any]]:
        """Return the segments as rows of a table, SI."""
        return list(to_plain(self.roughness.segments))


@operation(
    "iri",
    offers=("numbers", "figure", "report"),
    faces={"segment": "100 m", "offset": "0 m"},
    page="jounce.report.models:profile_page",
    title="Roughness of {profile}",
    doing="running the quarter car of the IRI",
    example='jounce iri track.csv --segment "100 m"',
)
def profile_roughness(
    profile: Annotated[
        Path | str,
        File("Columns x [m] and z [m], or a straight .crg road.", "PROFILE", shipped=("roads",)),
    ],
    *,
    segment: Annotated[
        float | str, Number("Length of the segments.", "LENGTH", "m", is_positive=True)
    ] = 100.0,
    offset: Annotated[
        float | str, Number("Lateral offset of the profile in a .crg road.", "LENGTH", "m")
    ] = 0.0,
    columns: Annotated[Mapping[str, str] | None, COLUMNS] = None,
) -> ProfileRoughness:
    r"""Return the international roughness index (IRI) of a profile and of its segments.

    Parameters
    ----------
    profile : path or str
        Text with columns ``x`` and ``z`` or two columns without a header in m, any other format of recordings, a
        straight OpenCRG road, or the name of a shipped road.
    segment : float or str
        Length of the segments, m.
    offset : float or str
        Lateral offset of the profile in an OpenCRG road, m, positive to the left.
    columns : mapping, optional
        Other names of the columns ``x`` and ``z``: ``{"z": "elevation [mm]"}``.

    Returns
    -------
    ProfileRoughness
        Results in SI; the index in m/km.

    Raises
    ------
    RecordingError
        If the file cannot be read, and as for :func:`iri`.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "track.csv"
    >>> _ = file.write_text("x [m], z [mm]\n" + "".join(f"{0.25 * i}, {i % 2}\n" for i in range(100)))
    >>> len(profile_roughness(file, segment="10 m").roughness.segments)
    3
    """
    lateral = to_si(offset, "m", where="offset")
    x, z, notes = read_profile(profile, columns=columns, lateral_offset=lateral)
    result = iri(x, z, segment=segment, place=str(profile))
    return ProfileRoughness(str(profile), lateral, result, x, z, (*notes, *result.findings))


def _rows(file: Path) -> list[tuple[int, list[str]]]:
    """Return non-empty lines without comments, with line numbers, split at blanks, commas and semicolons."""
    text = text_of(file)
    lines = ((number, line.split("#")[0]) for number, line in enumerate(text.splitlines(), 1))
    split = ((number, line.replace(",", " ").replace(";", " ").split()) for number, line in lines)
    return [(number, cells) for number, cells in split if cells]


def _numbers(cells: list[str]) -> list[float] | None:
    try:
        return [float(cell) for cell in cells]
    except ValueError:
        return None


def _is_bare(file: Path) -> bool:
    """Whether the file begins with two numbers instead of a header."""
    rows = _rows(file)[:1]
    return bool(rows) and len(rows[0][1]) == 2 and _numbers(rows[0][1]) is not None


def _bare_columns(file: Path) -> tuple[Array, Array, list[Finding]]:
    values = []
    for number, cells in _rows(file):
        row = _numbers(cells)
        if row is None or len(row) != 2:
            raise RecordingError(
                "two numbers are required",
                where=at_line(file, number),
                found=" ".join(cells),
                allowed="distance and height",
            )
        if not np.isfinite(row).all():
            raise RecordingError(
                "not a finite number",
                where=at_line(file, number),
                found=" ".join(cells),
                hint="Fill the gap, or cut off the padding.",
            )
        values.append(row)
    table = np.array(values)
    return table[:, 0].copy(), table[:, 1].copy(), [finding("roughness.no_header", str(file))]
