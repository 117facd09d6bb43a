"""Files of a damper rig: which records a folder has, and at which settings each was taken."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
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
from jounce.dampers.exports import PeakTable, read_export
from jounce.recordings.carried import damper_channels
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


DynoFile: TypeAlias = RecordFile | PeakTable | UnreadFile
AnyDynoFiles: TypeAlias = Annotated[
    Sequence[RecordFile | PeakTable | UnreadFile | str | Path],
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
    return [item for path in dyno_paths(measured) for item in _read(path, **options)]


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

    A table of settings and maps that were written here before are no records.

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
            if item.suffix.lower() in endings
            and item.is_file()
            and not (item.stem.lower() == "settings" or is_written_map(item))
        )
        if not inside:
            raise RecordingError(
                "no records in this folder", where=str(path), allowed=", ".join(sorted(endings))
            )
        paths += inside
    return paths


def is_written_map(file: Path) -> bool:
    """Whether a file is a map as :meth:`jounce.DamperMap.table` writes it: a result, no measurement."""
    if file.suffix.lower() != ".csv":
        return False
    with file.open("rb") as stream:
        return _OF_MAPS in stream.readline(1000)


_OF_MAPS = b"force [N],low [N],high [N],gas force [N],gas force low [N]"


def as_dyno_files(
    measured: Sequence[RecordFile | PeakTable | UnreadFile | str | Path] | str | Path,
) -> list[DynoFile]:
    """Read what is given by its path; leave what has been read."""
    given = [measured] if isinstance(measured, str | Path) else list(measured)
    files: list[DynoFile] = []
    for item in given:
        if isinstance(item, RecordFile | PeakTable | UnreadFile):
            files.append(item)
        else:
            files += [read for path in dyno_paths([item]) for read in _read(path)]
    return files


def _read(path: Path, **options: Any) -> Sequence[DynoFile]:
    """Read a file by the names of its channels, else as a dyno's export."""
    if is_written_map(path):
        return [
            UnreadFile(
                path, RecordingError("this is a map, no record", where=path.name, hint=_MAPS)
            )
        ]
    try:
        record = chosen_file(str(path), **options)
        damper_channels(record.data, where=str(path))
    except JounceError as error:
        try:
            return read_export(path, sample_time=options.get("sample_time"))
        except JounceError as reason:
            return [UnreadFile(path, error if options.get("columns") else reason)]
    return [record]


_MAPS = "Read it with read_damper_map, or give it to a command that takes a map."


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


Settings: TypeAlias = tuple[tuple[str, float], ...]
"""Settings (SI) by name, in order."""


def common_settings(stated: Sequence[Mapping[str, float]]) -> list[Settings]:
    """Return the settings with measured conditions made equal: a damper warms up from run to run.

    Temperatures with less than 5 K between neighbours are one, their mean, if all else is equal; gas pressures likewise
    with 5 %.

    >>> common_settings([{"clicks": 1.0, "temperature": t} for t in (301.0, 304.0, 320.0)])[:2]
    [(('clicks', 1.0), ('temperature', 302.5)), (('clicks', 1.0), ('temperature', 302.5))]
    """
    common = [dict(settings) for settings in stated]
    for name, (apart, share) in _MEASURED.items():
        groups: dict[Settings, list[dict[str, float]]] = {}
        for settings in common:
            if name in settings:
                others = {key: value for key, value in settings.items() if key not in _MEASURED}
                groups.setdefault(tuple(sorted(others.items())), []).append(settings)
        for group in groups.values():
            group.sort(key=lambda settings: settings[name])
            values = [settings[name] for settings in group]
            gaps = [high - low - apart - share * low for low, high in pairwise(values)]
            starts = [0, *(k for k, gap in enumerate(gaps, 1) if gap >= 0.0)]
            for start, end in zip(starts, [*starts[1:], len(values)], strict=True):
                for settings in group[start:end]:
                    settings[name] = sum(values[start:end]) / (end - start)
    return [tuple(sorted(settings.items())) for settings in common]


_MEASURED = {"temperature": (5.0, 0.0), "gas_pressure": (0.0, 0.05)}
"""What sensors measure: by how much neighbours differ that are one, in SI and as a share."""


def settings_of(
    file: RecordFile | PeakTable, table: Mapping[str, Mapping[str, float]]
) -> tuple[dict[str, float], list[Finding]]:
    """Return the settings of a record (SI): from the table, else from its channels, else from its name."""
    name = Path(file.path).name
    own = name.partition(" (")[0]  # a part of a file
    stated = next((table[key] for key in (name, own, Path(own).stem) if key in table), None)
    if stated is not None:
        return dict(stated), []
    values, findings = settings_in_name(name), list[Finding]()
    conditions = (
        file.settings if isinstance(file, PeakTable) else file.data.attrs.get("conditions", {})
    )
    for setting, value in conditions.items():
        if values.get(setting, value) != value and setting not in _MEASURED:
            outside = values[setting]
            findings.append(
                finding(
                    "dampers.name_differs",
                    name,
                    value,
                    setting=setting,
                    inside=value,
                    outside=outside,
                )
            )
        values[setting] = value
    if isinstance(file, RecordFile):
        adjusters = {str(name): "1" for name in file.data.data_vars if is_clicks(str(name))}
        for setting, unit in {**SETTINGS, **adjusters}.items():
            if setting in file.data and str(file.data[setting].attrs.get("units", "")) == unit:
                samples: Array = file.data[setting].to_numpy()
                values[setting] = float(samples.mean())
    if table:
        findings.append(finding("dampers.not_in_table", name))
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
