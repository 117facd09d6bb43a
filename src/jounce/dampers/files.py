"""Files of a damper rig: which records a folder has, and at which settings each was taken."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, TypeAlias

from jounce.core.columns import name_and_unit
from jounce.core.errors import DescriptionError, JounceError, RecordingError
from jounce.core.files import existing_file, matching_files
from jounce.core.findings import Finding, finding
from jounce.core.operation import MadeBy, Texts
from jounce.core.phrases import Phrase
from jounce.core.shown import Shown
from jounce.core.units import to_si
from jounce.dampers.adjusters import is_clicks
from jounce.recordings.cells import cells_of_file
from jounce.recordings.options import (
    COLUMNS,
    SAMPLE_TIME,
    SENSORS,
    VARIABLE,
    RecordFile,
    chosen_file,
    files_in_python,
)
from jounce.recordings.readers import READERS

if TYPE_CHECKING:
    from jounce.core.types import Array

SETTINGS: Mapping[str, str] = {"clicks": "1", "temperature": "K", "gas_pressure": "Pa"}
"""What a record may have been taken at, with SI units."""
_IN_NAMES = {
    "clicks": (re.compile(r"(?<![a-z0-9.])(-?\d+(?:\.\d+)?)[ _-]?(?:clicks?|clk|cl)(?![a-z])"),
               re.compile(r"(?<![a-z])(?:clicks?|clk|cl|c)[ _-]?(-?\d+(?:\.\d+)?)(?![\d.]|[a-z])")),
    "temperature": (re.compile(r"(?<![a-z0-9.])(-?\d+(?:\.\d+)?)[ _-]?(?:deg[ _-]?c|°c|c)(?![a-z0-9])"),
                    re.compile(r"(?<![a-z])t[ _-]?(-?\d+(?:\.\d+)?)(?:[ _-]?(?:deg[ _-]?c|°c|c))?(?![\d.a-z])")),
    "gas_pressure": (re.compile(r"(?<![a-z0-9.])(\d+(?:\.\d+)?)[ _-]?(bar|psi)(?![a-z])"),),
}  # fmt: skip
_ADJUSTERS = re.compile(
    r"(?<![a-z])(ls|hs|)((?<=s)[bcr]|bump|comp(?:ression)?|reb(?:ound)?)[ _-]?(\d+)(?![\d.a-z]|[ _-](?:mm|hz))"
)
_SPEEDS = {"ls": ("low", "speed"), "hs": ("high", "speed")}
_SIDES = {"b": "bump", "c": "bump", "r": "rebound", "bump": "bump", "comp": "bump",
          "compression": "bump", "reb": "rebound", "rebound": "rebound"}  # fmt: skip


@dataclass(frozen=True)
class UnreadFile(Shown):
    """A file of a folder that could not be read.

    Attributes
    ----------
    path : str or Path
        The file.
    error : JounceError
        Why.
    """

    path: str | Path
    error: JounceError


DynoFile: TypeAlias = RecordFile | UnreadFile
AnyDynoFiles: TypeAlias = Annotated[
    Sequence[RecordFile | UnreadFile | str | Path],
    MadeBy("jounce.dampers.files:chosen_dyno_files", "jounce.dampers.files:dyno_files_in_python"),
]
"""Records of a damper rig: files and folders; commands ask for the options to read them, too."""


def chosen_dyno_files(
    measured: Annotated[
        list[str], Texts("Records of a damper rig, or folders of them.", "FILE...")
    ],
    columns: Annotated[Any, COLUMNS] = None,
    variable: Annotated[str, VARIABLE] = "",
    sample_time: Annotated[float | None, SAMPLE_TIME] = None,
    sensors: Annotated[str | None, SENSORS] = None,
) -> list[DynoFile]:
    """Read records and folders of records; a file that cannot be read is kept with its error."""
    options = {
        "columns": columns,
        "variable": variable,
        "sample_time": sample_time,
        "sensors": sensors,
    }
    return [_read(path, **options) for path in dyno_paths(measured)]


def dyno_files_in_python(measured: Sequence[str], **options: Any) -> str:
    """Return a Python expression for the files.

    >>> dyno_files_in_python(["dyno"])
    "['dyno']"
    """
    if not options:
        return repr(list(measured))
    return files_in_python([str(path) for path in dyno_paths(measured)], **options)


def dyno_paths(measured: Sequence[str | Path]) -> list[Path]:
    """Return files as they are, and of each folder the files whose ending is that of a recording.

    Raises
    ------
    RecordingError
        If a named file does not exist, or a folder has no such file.
    """
    paths: list[Path] = []
    endings = {suffix for reader in READERS for suffix in reader.suffixes}
    for path in matching_files([str(name) for name in measured], "FILE"):
        if not path.is_dir():
            paths.append(existing_file(path, RecordingError))
            continue
        inside = sorted(
            item
            for item in path.rglob("*")
            if item.suffix.lower() in endings and item.is_file() and item.stem.lower() != "settings"
        )
        if not inside:
            raise RecordingError(
                "no records in this folder", where=str(path), allowed=", ".join(sorted(endings))
            )
        paths += inside
    return paths


def as_dyno_files(
    measured: Sequence[RecordFile | UnreadFile | str | Path] | str | Path,
) -> list[DynoFile]:
    """Read what is given by its path; leave what has been read."""
    given = [measured] if isinstance(measured, str | Path) else list(measured)
    files: list[DynoFile] = []
    for item in given:
        if isinstance(item, RecordFile | UnreadFile):
            files.append(item)
        else:
            files += [_read(path) for path in dyno_paths([item])]
    return files


def _read(path: Path, **options: Any) -> DynoFile:
    try:
        return chosen_file(str(path), **options)
    except JounceError as error:
        return UnreadFile(path, error)


def settings_in_name(name: str) -> dict[str, float]:
    """Read settings (SI) from the name of a file.

    >>> settings_in_name("front_8clicks_40degC_10bar.csv")
    {'clicks': 8.0, 'temperature': 313.15, 'gas_pressure': 1000000.0}
    >>> settings_in_name("FSAE_C12_run3.csv"), settings_in_name("sine_100mms.csv")
    ({'clicks': 12.0}, {})
    >>> settings_in_name("lsb8_lsr12.csv")
    {'low_speed_bump_clicks': 8.0, 'low_speed_rebound_clicks': 12.0}
    """
    text = Path(name).stem.lower()
    values: dict[str, float] = {}
    for setting, patterns in _IN_NAMES.items():
        for pattern in patterns:
            if match := pattern.search(text):
                unit = {"clicks": "", "temperature": "degC"}.get(
                    setting, match[match.lastindex or 0]
                )
                values[setting] = si_of_setting(setting, f"{match[1]} {unit}".strip(), name)
                break
    of_sides = {
        "_".join([*_SPEEDS.get(speed, ()), _SIDES[side], "clicks"]): float(clicks)
        for speed, side, clicks in _ADJUSTERS.findall(text)
    }
    return values if "clicks" in values else {**of_sides, **values}


def settings_of(
    file: RecordFile, table: Mapping[str, Mapping[str, float]]
) -> tuple[dict[str, float], list[Finding]]:
    """Return the settings of a record (SI): from the table, else from its channels, else from its name."""
    name = Path(file.path).name
    stated = table.get(name) or table.get(Path(name).stem)
    if stated is not None:
        return dict(stated), []
    values = settings_in_name(name)
    adjusters = {str(name): "1" for name in file.data.data_vars if is_clicks(str(name))}
    for setting, unit in {**SETTINGS, **adjusters}.items():
        if setting in file.data and str(file.data[setting].attrs.get("units", "")) == unit:
            samples: Array = file.data[setting].to_numpy()
            values[setting] = float(samples.mean())
    findings = [finding("dampers.not_in_table", name)] if table else []
    return values, findings


def read_settings(
    source: str | Path | Mapping[str, Mapping[str, float | str]] | None,
) -> dict[str, dict[str, float]]:
    """Read which file was taken at which settings: a table with a column ``file``, or a mapping; SI.

    Raises
    ------
    RecordingError, DescriptionError
        If the column ``file`` is missing, a setting is unknown, or a value cannot be read.
    """
    if source is None:
        return {}
    if isinstance(source, Mapping):
        return {
            str(name): {
                key: si_of_setting(key, value, f"settings of {name}, {key}")
                for key, value in values.items()
            }
            for name, values in source.items()
        }
    return _settings_of_file(Path(source))


def _settings_of_file(file: Path) -> dict[str, dict[str, float]]:
    header, *rows = cells_of_file(existing_file(file, RecordingError)) or [[]]
    headings = [name_and_unit(cell) for cell in header]
    names = [name.strip().lower().replace(" ", "_").replace("-", "_") for name, _ in headings]
    units = [unit for _, unit in headings]
    if "file" not in names:
        raise RecordingError(
            "no column with the names of the files",
            where=str(file),
            found=", ".join(header),
            allowed="file",
        )
    table: dict[str, dict[str, float]] = {}
    for number, row in enumerate(rows, 2):
        if not any(cell.strip() for cell in row):
            continue
        cells = dict(zip(names, row, strict=False))
        values = {}
        for name, unit in zip(names, units, strict=True):
            text = cells.get(name, "").strip()
            if name == "file" or not text:
                continue
            where = f"{file}, row {number}, {name}"
            values[name] = si_of_setting(name, f"{text} {unit}".strip(), where)
        table[cells["file"].strip()] = values
    return table


def si_of_setting(setting: str, value: float | str, where: str) -> float:
    """Convert a setting to SI; degrees Celsius have their zero elsewhere."""
    if setting not in SETTINGS and not is_clicks(setting):
        raise RecordingError(
            Phrase("unknown setting {name!r}", name=setting),
            where=where,
            allowed=", ".join([*SETTINGS, "bump_clicks", "low_speed_rebound_clicks"]),
        )
    if setting != "temperature":
        return to_si(value, SETTINGS.get(setting, "1"), where=where)
    if match := re.fullmatch(r"\s*([-+]?[\d.]+)\s*(?:deg ?C|°C|C)\s*", str(value)):
        return float(match[1]) + _ZERO_CELSIUS
    kelvin = to_si(value, "K", where=where)
    if kelvin < _COLD:
        raise DescriptionError(
            "a temperature that no oil has", where=where, found=str(value), allowed="K or degC",
            hint="State its unit: temperature [degC].",
        )  # fmt: skip
    return kelvin


_ZERO_CELSIUS = 273.15  # K
_COLD = 200.0  # K; below, degrees Celsius were meant
