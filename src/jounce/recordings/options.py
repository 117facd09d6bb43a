"""How people give what is needed to read a measured file: its columns, its sampling, its part."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any, TypeAlias

from jounce.core.operation import Columns, File, MadeBy, Mark, Number
from jounce.recordings.files import read_recording

if TYPE_CHECKING:
    import xarray as xr

    from jounce.core.findings import Finding

LONGEST_STEP = 1.0
"""Sampling interval (s) above which a bare number is taken for milliseconds."""
COLUMNS = Columns(
    r'Column that holds a quantity, with its unit if the header gives none: force="F \[kN]". Repeat it.',
    "NAME=COLUMN",
    'force="F [kN]"',
)
VARIABLE = Mark(
    "Matrix or struct of a .mat file, group of a .tdms file, or sheet of a workbook (or rows: Run!5:300).", "VARIABLE"
)
SAMPLE_TIME = Number(
    'Constant sampling interval of a file without time, e.g. "10 ms".', "TIME", "s", is_positive=True, most=LONGEST_STEP
)
RESAMPLE = Number(
    'Bring irregular time, or signals at different instants, onto constant steps, e.g. "10 ms".',
    "TIME",
    "s",
    is_positive=True,
    most=LONGEST_STEP,
)
DATABASE = File("Database of bus messages (.dbc) with which the bus frames of an MDF file are decoded.")
AnyRecording: TypeAlias = Annotated[
    "tuple[xr.Dataset, list[Finding]]",
    MadeBy("jounce.recordings.options:chosen_recording", "jounce.recordings.options:recording_in_python"),
]
"""A recording with what is to be known of it, as `jounce.read_recording` gives both; faces ask for file and columns."""


def chosen_recording(
    record: Annotated[str, File("A recording: .csv, .mat, .mf4, .tdms, .parquet, .xlsx, .nc ...", "RECORD")],
    columns: Annotated[Any, COLUMNS] = None,
    variable: Annotated[str, VARIABLE] = "",
    sample_time: Annotated[float | None, SAMPLE_TIME] = None,
    resample: Annotated[float | None, RESAMPLE] = None,
    database: Annotated[str | None, DATABASE] = None,
) -> tuple[xr.Dataset, list[Finding]]:
    """Read a recording."""
    return read_recording(
        record, columns=columns, sample_time=sample_time, variable=variable, resample=resample, database=database
    )


def recording_in_python(record: str, **options: Any) -> str:
    """Write the recording as Python.

    >>> recording_in_python("lap.csv", sample_time=0.01)
    "jn.read_recording('lap.csv', sample_time=0.01)"
    """
    return f"jn.read_recording({', '.join([repr(record), *(f'{key}={item!r}' for key, item in options.items())])})"
