"""Options for reading a measured file: columns, sampling, section."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, TypeAlias

from jounce.core.files import matching_files
from jounce.core.operation import Columns, File, MadeBy, Mark, Number, Texts
from jounce.core.shown import Shown
from jounce.recordings.files import read_recording

if TYPE_CHECKING:
    import xarray as xr

    from jounce.core.findings import Finding

LONGEST_STEP = 1.0
"""Sampling interval (s) above which a number without unit is assumed to be in milliseconds."""
COLUMNS = Columns(
    r'Column that holds a quantity, with its unit if the header gives none: force="F \[kN]". Repeat it.',
    "NAME=COLUMN",
    'force="F [kN]"',
)
VARIABLE = Mark(
    "Matrix or struct of a .mat file, group of a .tdms file, or sheet of a workbook (or rows: Run!5:300).",
    "VARIABLE",
)
SAMPLE_TIME = Number(
    'Constant sampling interval of a file without time, e.g. "10 ms".',
    "TIME",
    "s",
    is_positive=True,
    most=LONGEST_STEP,
)
RESAMPLE = Number(
    'Bring irregular time, or signals at different instants, onto constant steps, e.g. "10 ms".',
    "TIME",
    "s",
    is_positive=True,
    most=LONGEST_STEP,
)
DATABASE = File(
    "Database of bus messages (.dbc) with which the bus frames of an MDF file are decoded."
)
SENSORS = File(
    "Sensors whose volts, currents or counts the columns hold: a file with their sensitivities, zeros and ranges, a "
    "campaign, or the settings of a laboratory."
)
AnyRecording: TypeAlias = Annotated[
    "tuple[xr.Dataset, list[Finding]]",
    MadeBy(
        "jounce.recordings.options:chosen_recording",
        "jounce.recordings.options:recording_in_python",
    ),
]
"""A recording and its findings, as returned by `jounce.read_recording`; user interfaces request file and columns."""


def chosen_recording(
    record: Annotated[
        str, File("A recording: .csv, .mat, .mf4, .tdms, .parquet, .xlsx, .nc ...", "RECORD")
    ],
    columns: Annotated[Any, COLUMNS] = None,
    variable: Annotated[str, VARIABLE] = "",
    sample_time: Annotated[float | None, SAMPLE_TIME] = None,
    resample: Annotated[float | None, RESAMPLE] = None,
    database: Annotated[str | None, DATABASE] = None,
    sensors: Annotated[str | None, SENSORS] = None,
) -> tuple[xr.Dataset, list[Finding]]:
    """Read a recording."""
    return read_recording(
        record,
        columns=columns,
        sample_time=sample_time,
        variable=variable,
        resample=resample,
        database=database,
        sensors=sensors,
    )


def recording_in_python(record: str, **options: Any) -> str:
    """Return a Python expression for the recording.

    >>> recording_in_python("lap.csv", sample_time=0.01)
    "jn.read_recording('lap.csv', sample_time=0.01)"
    """
    return f"jn.read_recording({', '.join([repr(record), *(f'{key}={item!r}' for key, item in options.items())])})"


@dataclass(frozen=True)
class RecordFile(Shown):
    """A recording with its source file.

    Parameters
    ----------
    path : str or Path
        The file.
    data : xarray.Dataset
        Its channels over time, SI.
    findings : sequence of Finding
        Findings of the reader.

    Examples
    --------
    >>> import jounce as jn
    >>> jn.RecordFile("run.csv", jn.recording([0.0, 0.1], {"sprung.z": ([0.0, 1e-3], "m", "")})).path
    'run.csv'
    """

    path: str | Path
    data: xr.Dataset
    findings: Sequence[Finding] = ()


AnyRecordFile: TypeAlias = Annotated[
    "RecordFile | str | Path",
    MadeBy("jounce.recordings.options:chosen_file", "jounce.recordings.options:file_in_python"),
]
"""A measured file; user interfaces request it and the options needed to read it."""
AnyRecordFiles: TypeAlias = Annotated[
    "Sequence[RecordFile | str | Path]",
    MadeBy("jounce.recordings.options:chosen_files", "jounce.recordings.options:files_in_python"),
]
"""Several measured files, read with the same options."""


def as_record_file(record: RecordFile | str | Path) -> RecordFile:
    """Read a file given by its path; return a RecordFile unchanged."""
    return (
        record
        if isinstance(record, RecordFile)
        else RecordFile(Path(record), *read_recording(record))
    )


def chosen_file(
    record: Annotated[
        str, File("Record with columns time, displacement, force and optionally velocity.", "FILE")
    ],
    columns: Annotated[Any, COLUMNS] = None,
    variable: Annotated[str, VARIABLE] = "",
    sample_time: Annotated[float | None, SAMPLE_TIME] = None,
    resample: Annotated[float | None, RESAMPLE] = None,
    database: Annotated[str | None, DATABASE] = None,
    sensors: Annotated[str | None, SENSORS] = None,
) -> RecordFile:
    """Read a recording, and keep the name of its file."""
    read = chosen_recording(record, columns, variable, sample_time, resample, database, sensors)
    return RecordFile(Path(record), *read)


def chosen_files(
    measured: Annotated[
        list[str], Texts("Recording of a free decay; several are combined.", "FILE...")
    ],
    columns: Annotated[Any, COLUMNS] = None,
    variable: Annotated[str, VARIABLE] = "",
    sample_time: Annotated[float | None, SAMPLE_TIME] = None,
    resample: Annotated[float | None, RESAMPLE] = None,
    database: Annotated[str | None, DATABASE] = None,
    sensors: Annotated[str | None, SENSORS] = None,
) -> list[RecordFile]:
    """Read several recordings, given by names or patterns."""
    return [
        chosen_file(str(path), columns, variable, sample_time, resample, database, sensors)
        for path in matching_files(measured, "FILE")
    ]


def file_in_python(record: str, **options: Any) -> str:
    """Return a Python expression for the file.

    >>> file_in_python("damper.csv"), file_in_python("damper.csv", sample_time=0.01)
    ("'damper.csv'", "jn.RecordFile('damper.csv', *jn.read_recording('damper.csv', sample_time=0.01))")
    """
    return (
        f"jn.RecordFile({record!r}, *{recording_in_python(record, **options)})"
        if options
        else repr(record)
    )


def files_in_python(measured: Sequence[str], **options: Any) -> str:
    """Return a Python expression for the files.

    >>> files_in_python(["a.csv", "b.csv"])
    "['a.csv', 'b.csv']"
    """
    return f"[{', '.join(file_in_python(record, **options) for record in measured)}]"
