"""Universal files: time responses in data set 58."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import numpy as np

from jounce.core.columns import Column, ColumnTable
from jounce.core.errors import RecordingError
from jounce.core.optional import require
from jounce.recordings.readers.table import Reader, ReaderOptions, SignalTable, refuse_variable, renamed

_TIME_RESPONSE = 1


def read(path: Path, options: ReaderOptions) -> SignalTable:
    """Read the time responses that share the first one's instants.

    A channel is named after its response entity (or ``point_<node>``), followed by ``:<node><direction>`` when several
    have that name.
    """
    refuse_variable(path, options)
    pyuff = require("pyuff", "io")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            file = pyuff.UFF(str(path))
            kinds = np.atleast_1d(file.get_set_types())
            sets = [file.read_sets(int(index)) for index in np.flatnonzero(kinds == 58)]
    except Exception as error:  # noqa: BLE001 - pyuff raises bare Exceptions
        raise RecordingError(f"not a universal file ({error})", where=str(path)) from None
    sets = [one for one in sets if one["func_type"] == _TIME_RESPONSE]
    if not sets:
        found = ", ".join(f"{int(kind)}" for kind in kinds)
        raise RecordingError("no time response", where=str(path), found=f"data sets {found}", allowed="data set 58")
    instants = np.asarray(sets[0]["x"], dtype=float)
    columns = [Column("time", "s", instants, str(path))]
    names = [_name(one) for one in sets]
    left_out = []
    for one, name in zip(sets, names, strict=True):
        full = name if names.count(name) == 1 else f"{name}:{one['rsp_node']}{one['rsp_dir']:+d}"
        if np.array_equal(one["x"], instants):
            values = np.asarray(one["data"], dtype=float)
            columns.append(Column(full, _unit(one["ordinate_axis_units_lab"]), values, str(path)))
        else:
            left_out.append(full)
    return SignalTable(renamed(ColumnTable(tuple(columns), (), str(path)), options.header), left_out=tuple(left_out))


def _name(one: dict[str, Any]) -> str:
    entity = str(one["rsp_ent_name"]).strip()
    return entity if entity not in ("", "NONE") else f"point_{one['rsp_node']}"


def _unit(label: object) -> str:
    text = str(label).strip()
    return "" if text == "NONE" else text


READER = Reader(
    name="uff",
    label="universal file, time responses (data set 58)",
    suffixes=(".uff", ".unv", ".uf"),
    read=read,
    source="Universal File Format, University of Cincinnati SDRL",
    example="columns={'sprung.az': 'Mic 01 [m/s^2]'}",
    extra="io",
)
