"""How long a damper moves at which velocity: from its histogram, or a table of shares."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from jounce.core.errors import DescriptionError, RecordingError, unknown
from jounce.core.files import existing_file
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.design.damper_targets import columns_of_table
from jounce.recordings.cells import cells_of_file

_WHOLE = "whole"  # section of a histogram that is the whole record
_HISTOGRAM = ("record", "section", "corner", "quantity", "from", "to", "share")


def shares_over(
    given: Any, corner: str = "", motion_ratio: float | None = None
) -> tuple[Array, Array]:
    """Return damper velocities (m/s, bump positive) and time shares [1], which add up to 1.

    ``given`` is a mapping, a result of :func:`jounce.damper_histograms`, its table, or a table with the columns
    ``velocity`` and ``share``. ``corner`` is a corner of a histogram or the beginning of its name: its corners are
    averaged. ``motion_ratio`` (damper over wheel, 1) converts histograms of the wheel.

    Raises
    ------
    RecordingError, DescriptionError
        If the table cannot be read, the corner is unknown, the motion ratio is missing, or shares are negative.
    """
    if isinstance(given, Mapping):
        _refuse_corner(corner)
        velocity, share = np.array(sorted(given.items()), dtype=float).reshape(-1, 2).T
    elif hasattr(given, "measured_at"):
        velocity, share = _of_histogram(given, corner, motion_ratio)
    elif isinstance(given, str | Path):
        velocity, share = _of_file(Path(given), corner)
    else:
        raise DescriptionError(
            "no histogram", where="shares", found=type(given).__name__,
            allowed="a histogram, its table, or a table with velocity and share",
        )  # fmt: skip
    if not (np.isfinite(share).all() and (share >= 0.0).all() and share.any()):
        raise DescriptionError(
            "out of range", where="shares", allowed="0 or above, not all 0",
            found=f"{share.min():g}" if share.size else "nothing",
        )  # fmt: skip
    return velocity, share / share.sum()


def _of_histogram(given: Any, corner: str, motion_ratio: float | None) -> tuple[Array, Array]:
    """Return middles and shares of the bins of the first record, the mean of the chosen corners."""
    names = _corners(given.corners, corner)
    data = given.data["velocity_share"].isel(record=0).sel(section=_WHOLE, corner=names)
    velocity = np.asarray(given.data["velocity"].to_numpy(), dtype=float)
    if any(given.measured_at.get(name) == "wheel" for name in names):
        if motion_ratio is None:
            raise DescriptionError(
                "a histogram of the wheel needs the motion ratio", where="motion_ratio",
                hint="Or draw the histogram of the damper.",
            )  # fmt: skip
        velocity = velocity * motion_ratio
    return velocity, np.asarray(data.mean("corner").to_numpy(), dtype=float)


def _of_file(file: Path, corner: str) -> tuple[Array, Array]:
    header, *rows = cells_of_file(existing_file(file, RecordingError)) or [[]]
    if tuple(cell.strip().lower() for cell in header) != _HISTOGRAM:
        _refuse_corner(corner)
        points = sorted(columns_of_table(file, {"velocity": "m/s", "share": "1"}))
        velocity, share = np.array(points).T
        return velocity, share
    bins: dict[tuple[str, float], float] = {}
    record = next((row[0] for row in rows if row), "")
    for number, row in enumerate(rows, 2):
        if (
            len(row) == len(_HISTOGRAM)
            and row[3].startswith("velocity")
            and row[:2] == [record, _WHOLE]
        ):
            low, high, part = (
                to_si(text, "1", where=f"{file}, row {number}, {name}")
                for text, name in zip(row[4:], _HISTOGRAM[4:], strict=True)
            )
            bins[row[2], 0.5 * (low + high)] = part
    names = _corners(list(dict.fromkeys(name for name, _ in bins)), corner)
    velocity = np.unique([middle for name, middle in bins if name in names])
    share = np.mean([[bins.get((name, float(v)), 0.0) for v in velocity] for name in names], axis=0)
    return velocity, np.asarray(share)


def _refuse_corner(corner: str) -> None:
    if corner:
        raise DescriptionError(
            "shares over velocity have no corners", where="corner", found=corner, allowed="nothing"
        )


def _corners(known: list[str], corner: str) -> list[str]:
    """Return the corners that begin with a name; refuse several without one."""
    chosen = [name for name in known if name.startswith(corner)]
    if not chosen:
        raise unknown(corner, known, what="corner", where="corner")
    if not corner and len(chosen) > 1:
        raise DescriptionError(
            "the histogram has several corners", where="corner", allowed=", ".join(known),
            hint="Name the corner of this damper, or its axle: front, rear.",
        )  # fmt: skip
    return chosen
