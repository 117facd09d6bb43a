"""Lap markers of a recording: the attributes ``beacons`` (s) and ``beacon_names``."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from jounce.core.errors import RecordingError
from jounce.core.types import Array

if TYPE_CHECKING:
    import xarray as xr

_LATEST = 1e9  # s: no record is longer


def beacon_attributes(markers: list[tuple[float, str]]) -> dict[str, object]:
    """Return ``beacons`` (s, ascending) and ``beacon_names``; nothing without a finite instant.

    >>> beacon_attributes([(90.5, "Lap 2"), (1.25, "Lap 1")])
    {'beacons': array([ 1.25, 90.5 ]), 'beacon_names': 'Lap 1; Lap 2'}
    """
    ordered = sorted((time, name) for time, name in markers if abs(time) < _LATEST)
    if not ordered:
        return {}
    names = "; ".join(name.replace(";", ",") for _, name in ordered)
    attributes: dict[str, object] = {"beacons": np.array([time for time, _ in ordered])}
    return attributes | ({"beacon_names": names} if names.strip("; ") else {})


def find_laps(run: xr.Dataset) -> Array:
    """Find the laps of a recording between the lap markers that its file contains.

    Parameters
    ----------
    run : xarray.Dataset
        Recording with the attribute ``beacons``: times of lap markers (s), as readers of MoTeC, VBO and AiM give it.

    Returns
    -------
    ndarray, shape (n, 2)
        Start and end of each lap (s), in order. Time before the first and after the last marker is no lap, and neither
        is a lap that the recording contains only in part.

    Raises
    ------
    RecordingError
        If the recording has no lap markers.

    Examples
    --------
    >>> from jounce.recordings import recording
    >>> run = recording([0.0, 100.0, 200.0], {"body.speed": ([30.0, 31.0, 32.0], "m/s", "")})
    >>> find_laps(run.assign_attrs(beacons=[12.5, 95.0, 178.0])).tolist()
    [[12.5, 95.0], [95.0, 178.0]]
    """
    beacons = np.atleast_1d(np.asarray(run.attrs.get("beacons", ()), dtype=float))
    if not beacons.size:
        raise RecordingError(
            "the recording has no lap markers",
            where=str(run.encoding.get("source", "recording")),
            hint="Set them: run.assign_attrs(beacons=[...]), times in s.",
        )
    time = run["time"].to_numpy()
    inside = np.unique(beacons[(beacons >= time[0]) & (beacons <= time[-1])])
    return np.stack([inside[:-1], inside[1:]], axis=1)


def runs_of_numbers(time: Array, numbers: Array) -> list[tuple[int, float, float]]:
    """Return each run of equal whole numbers of a counter: the number, and its first and last instant (s).

    The first and the last run, which the recording has only in part, are left out.

    >>> runs_of_numbers(np.arange(8.0), np.array([0.0, 1, 1, 1, 2, 2, 3, 3]))
    [(1, 1.0, 4.0), (2, 4.0, 6.0)]
    """
    whole = np.rint(numbers)
    changes = np.flatnonzero(whole[1:] != whole[:-1]) + 1
    return [
        (int(whole[first]), float(time[first]), float(time[last]))
        for first, last in zip(changes[:-1].tolist(), changes[1:].tolist(), strict=True)
    ]
