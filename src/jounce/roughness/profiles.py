"""Longitudinal profiles from files: text columns with or without a header, other measured formats, OpenCRG."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from jounce.core.errors import RecordingError
from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.recordings.files import read_columns
from jounce.roads.loading import road_library
from jounce.roads.opencrg import read_crg_profile

_TEXT = (".csv", ".txt", ".tsv")


def read_profile(
    path: Path | str, *, columns: Mapping[str, str] | None = None, lateral_offset: float = 0.0
) -> tuple[Array, Array, list[Finding]]:
    r"""Read a longitudinal profile.

    Parameters
    ----------
    path : Path or str
        Text file with the columns ``x`` and ``z`` (``x [m], z [mm]``), or with two bare columns of numbers in m; any
        other format recordings are read from; a straight OpenCRG road (``.crg``), or the name of a shipped one.
    columns : mapping of str to str, optional
        Where ``x`` and ``z`` are when they have other names: ``{"z": "elevation [mm]"}``.
    lateral_offset : float
        Of the line to read from an OpenCRG road, m, left positive.

    Returns
    -------
    distance : ndarray, shape (n,)
        Positions as written, m.
    height : ndarray, shape (n,)
        Heights, m.
    findings : list of Finding
        What was assumed or looks wrong.

    Raises
    ------
    RecordingError
        For files that are missing, damaged or have other columns, and curved roads.
    DescriptionError
        For units that do not fit.

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
            "only OpenCRG roads have lateral offsets", where=str(file), found=f"{lateral_offset:g} m", allowed="0 m"
        )
    if columns is None and file.suffix.lower() in _TEXT and file.is_file() and _is_bare(file):
        return _bare_columns(file)
    values, findings = read_columns(file, {"x": "m", "z": "m"}, columns=columns)
    return values["x"], values["z"], findings


def _rows(file: Path) -> list[tuple[int, list[str]]]:
    """Lines that hold something but comments, with their numbers, split at blanks, commas, semicolons."""
    text = file.read_bytes().decode("utf-8-sig", errors="replace")
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
                "not two numbers", where=f"{file}, line {number}", found=" ".join(cells), allowed="distance and height"
            )
        if not np.isfinite(row).all():
            raise RecordingError(
                "not a finite number",
                where=f"{file}, line {number}",
                found=" ".join(cells),
                hint="Fill the gap, or cut padding off.",
            )
        values.append(row)
    text = "the file has no header; its two columns were taken for distance and height in m"
    table = np.array(values)
    return table[:, 0].copy(), table[:, 1].copy(), [Finding(str(file), "note", text)]
