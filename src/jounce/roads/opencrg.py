"""Measured straight roads in OpenCRG files, as heights along one lateral offset."""

from __future__ import annotations

import re
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import RecordingError

Array = NDArray[np.float64]
_HARMLESS = re.compile(r"^unknown (keyword|data channel)|white space byte|header values used$")
HIGHEST = 1e4  # m; no road lies above
_EDGE = 1e-9  # m; rounding of the lateral range


def read_crg_profile(path: Path | str, lateral_offset: float = 0.0) -> tuple[Array, Array]:
    """Read the heights of a straight OpenCRG road at one lateral offset.

    Heights are the sum of the reference line's elevation (its slope integrated), banking times offset and the grid,
    linear between the long sections (bilinear together with straight lines along u). Cross sections without any value
    at the end of a binary file are padding and left out. Modifiers that the file holds are applied.

    Parameters
    ----------
    path : Path or str
        File of format KRBI, KDBI (binary), LRFI or LDFI (text).
    lateral_offset : float
        Offset v in m from the reference line, left positive, inside the grid.

    Returns
    -------
    u : ndarray, shape (n,)
        Distance along the reference line in m, from 0 at the first cross section.
    height : ndarray, shape (n,)
        Height z in m, up positive.

    Raises
    ------
    RecordingError
        For a missing, damaged, truncated or contradictory file, a curved reference line, an offset outside the
        grid, and heights that are missing at that offset.

    Notes
    -----
    Format: ASAM OpenCRG 1.2. Not interpreted: border options (they act outside the grid only) and the position of the
    reference line in the plane.
    """
    file = Path(path)
    if not file.is_file():
        raise RecordingError("no such file", where=str(file), hint="Check the path and the name.")
    status = file.stat()
    u, height = _profile(str(file), float(lateral_offset), status.st_mtime_ns, status.st_size)
    return u.copy(), height.copy()


@lru_cache(maxsize=16)
def _profile(file: str, offset: float, _changed: int, _size: int) -> tuple[Array, Array]:
    road = _read(file)
    if not road.is_straight:
        raise RecordingError(
            "the reference line is curved",
            where=file,
            allowed="a straight road",
            hint="A single wheel's road needs one straight line; cut a straight part out of the course.",
        )
    if any(road.get_option(name) for name in ("border_smooth_ubeg", "border_smooth_uend")):
        raise RecordingError("the option border_smooth is not supported", where=file, hint="Remove it from the file.")
    height = _grid_height(road, offset, file) + road.zr + road.banking * offset
    u = np.asarray(road.u - road.u_start, dtype=float)
    if np.nanmax(np.abs(height), initial=0.0) > HIGHEST:
        problem = "the OpenCRG file is damaged: heights above 10 km"
        raise RecordingError(problem, where=file, hint="Use an original copy.")
    if not np.isfinite(height).all():
        bad = int(np.flatnonzero(~np.isfinite(height))[0])
        raise RecordingError(
            f"no height at u = {road.u[bad]:g} m for the lateral offset {offset:g} m",
            where=file,
            hint="Choose another lateral offset, or fill the gap in the file.",
        )
    return u, height


def _read(file: str) -> Any:
    """Read and check; everything the reader would guess is refused."""
    import pyopencrg

    try:
        with np.errstate(all="ignore"):  # damaged numbers overflow
            road = pyopencrg.read(file, check=False)
            problems = [*road.check().errors, *_overlong_rows(file)]
            if road.mods and not problems:
                road = road.apply_mods()
    except FileNotFoundError as error:
        raise RecordingError(_one_line(error, file), where=file, hint="Put it there or change the name.") from None
    except (ValueError, OSError, IndexError, KeyError, ArithmeticError, TypeError, MemoryError) as error:
        raise RecordingError(f"not a readable OpenCRG file: {_one_line(error, file)}", where=file) from None
    problems += [text for text in road.read_warnings if not _HARMLESS.search(text)]
    if problems:
        text = "; ".join(problem.removeprefix("(reading) ") for problem in dict.fromkeys(problems[:2]))
        raise RecordingError(
            f"the OpenCRG file is damaged or contradicts itself: {text}", where=file, hint="Use an original copy."
        )
    return road


def _overlong_rows(file: str) -> list[str]:
    """Text rows that hold more values than the header defines (pyopencrg ignores the rest)."""
    from pyopencrg.io import read_ipl

    header = read_ipl(file, meta_only=True)
    width = {"LRFI": 10, "LDFI": 20}.get(header.fmt)
    if width is None or not header.kd_def:
        return []
    rows = Path(file).read_bytes()[header.data_offset :].splitlines()
    longest = width * min(len(header.kd_def), 80 // width)
    bad = [number for number, row in enumerate(rows, 1) if len(row.rstrip()) > longest]
    return [f"row {bad[0]} of the data holds more than the {len(header.kd_def)} channels of the header"] if bad else []


def _one_line(error: Exception, file: str) -> str:
    return " ".join(str(error).split()).removeprefix(f"{file}: ") or type(error).__name__


def _grid_height(road: Any, offset: float, file: str) -> Array:
    """Grid heights at the offset, linear between the long sections beside it."""
    v = np.asarray(road.v, dtype=float)
    if not v[0] - _EDGE <= offset <= v[-1] + _EDGE:
        raise RecordingError(
            "the lateral offset lies outside the road",
            where=file,
            found=f"{offset:g} m",
            allowed=f"{v[0]:g} to {v[-1]:g} m",
        )
    right = int(np.clip(np.searchsorted(v, offset, side="right") - 1, 0, len(v) - 2))
    share = float(np.clip((offset - v[right]) / (v[right + 1] - v[right]), 0.0, 1.0))
    grid = np.asarray(road.z, dtype=float)
    if share in (0.0, 1.0):  # a gap beside the section does not matter
        return grid[:, right + int(share)].copy()
    return np.asarray((1.0 - share) * grid[:, right] + share * grid[:, right + 1])
