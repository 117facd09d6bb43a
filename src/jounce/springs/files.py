"""Files of a press: force over stroke, with time if it was recorded."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, TypeAlias

from jounce.core.errors import JounceError, RecordingError
from jounce.core.findings import Finding
from jounce.core.operation import MadeBy, Texts
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.dampers.files import UnreadFile, dyno_paths
from jounce.recordings.formats import TableFormat
from jounce.recordings.options import COLUMNS, VARIABLE, RecordFile

_COLUMNS = {"displacement": "m", "force": "N"}


@dataclass(frozen=True)
class PressFile(Shown):
    """A record of a press.

    Attributes
    ----------
    path : str or Path
        The file.
    deflection, force : array (n,)
        Stroke (m) and force (N) as recorded.
    time : array (n,) or None
        Time, s, if it was recorded.
    findings : sequence of Finding
        Findings of the reader.
    """

    path: str | Path
    deflection: Array
    force: Array
    time: Array | None = None
    findings: Sequence[Finding] = ()


AnyPressFiles: TypeAlias = Annotated[
    Sequence[PressFile | RecordFile | UnreadFile | str | Path],
    MadeBy("jounce.springs.files:read_press_files", "jounce.springs.files:press_files_in_python"),
]
"""Records of a press: files and folders; user interfaces ask for the options to read them, too."""


def read_press_files(
    measured: Annotated[
        Sequence[str | Path],
        Texts("Records of a press, or folders of them: displacement, force, time.", "FILE..."),
    ],
    columns: Annotated[Any, COLUMNS] = None,
    variable: Annotated[str, VARIABLE] = "",
) -> list[PressFile | UnreadFile]:
    """Read records of a press and folders of them; a file that cannot be read is kept with its error.

    Parameters
    ----------
    measured : sequence of str or Path
        Files and folders; the files have columns ``displacement`` and ``force``, and ``time`` if it was recorded.
    columns : mapping, optional
        Name of the column for each quantity.
    variable : str
        Variable, group or sheet to read from the file.

    Returns
    -------
    list of PressFile
        Records in SI; an ``UnreadFile`` for each file that cannot be read.

    Raises
    ------
    RecordingError
        If a file does not exist, or a folder has no records.

    Examples
    --------
    >>> read_press_files(["no-such.csv"])
    Traceback (most recent call last):
        ...
    jounce.core.errors.RecordingError: no-such.csv: no such file. Check the path and the name.
    """
    table = TableFormat(columns=columns or {}, variable=variable)
    return [_read(path, table) for path in dyno_paths(measured)]


def _read(path: Path, table: TableFormat) -> PressFile | UnreadFile:
    try:
        values, findings = table.read_columns(path, [{"time": "s", **_COLUMNS}, _COLUMNS])
    except JounceError as error:
        return UnreadFile(path, error)
    return PressFile(
        path, values["displacement"], values["force"], values.get("time"), tuple(findings)
    )


def press_files_in_python(measured: Sequence[str], **options: Any) -> str:
    """Return a Python expression for the files.

    >>> press_files_in_python(["press"]), press_files_in_python(["press"], variable="Run 1")
    ("['press']", "jn.read_press_files(['press'], variable='Run 1')")
    """
    texts = "".join(f", {name}={value!r}" for name, value in options.items())
    return f"jn.read_press_files({list(measured)!r}{texts})" if options else repr(list(measured))


def as_press_files(
    measured: Sequence[PressFile | RecordFile | UnreadFile | str | Path] | str | Path,
) -> list[PressFile | UnreadFile]:
    """Read what is given by its path; take channels of recordings; leave what has been read."""
    given = [measured] if isinstance(measured, str | Path) else list(measured)
    files: list[PressFile | UnreadFile] = []
    for item in given:
        if isinstance(item, PressFile | UnreadFile):
            files.append(item)
        elif isinstance(item, RecordFile):
            files.append(_of_recording(item))
        else:
            files += read_press_files([item])
    return files


def _of_recording(record: RecordFile) -> PressFile | UnreadFile:
    missing = [name for name in _COLUMNS if name not in record.data]
    if missing:
        error = RecordingError(
            "a column is missing", where=str(record.path),
            found=", ".join(map(str, record.data.data_vars)), allowed=", ".join(_COLUMNS),
        )  # fmt: skip
        return UnreadFile(record.path, error)
    deflection, force = (record.data[name].to_numpy() for name in _COLUMNS)
    return PressFile(
        record.path, deflection, force, record.data["time"].to_numpy(), tuple(record.findings)
    )
