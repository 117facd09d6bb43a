"""Maps of dampers as tables: with everything that a sheet shows, or as a damper's maker publishes them."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from jounce.core.columns import name_and_unit
from jounce.core.errors import RecordingError
from jounce.core.files import existing_file
from jounce.core.phrases import Phrase
from jounce.dampers.adjusters import is_clicks, words_of
from jounce.dampers.curves import DamperSetting
from jounce.dampers.files import SETTINGS, si_of_setting
from jounce.identify.estimate import Estimate, student_factor
from jounce.recordings.cells import cells_of_file, si_of_cell

_CURVE = {"velocity": "m/s", "force": "N", "low": "N", "high": "N"}
_ESTIMATES = {"gas_force": "N", "gas_stiffness": "N/m", "friction": "N", "lag": "s"}
_TEXTS = (".csv", ".txt", ".tsv", ".dat", ".xlsx")
_LEVEL = student_factor(math.inf)


def map_table(settings: Sequence[DamperSetting]) -> str:
    """Write settings as CSV, SI: a row for each velocity."""
    adjusters = list(dict.fromkeys(n for s in settings for n in s.settings if is_clicks(n)))
    stated = [*(adjusters or ["clicks"]), "temperature", "gas_pressure"]
    header = [_heading(name, "" if is_clicks(name) else SETTINGS[name]) for name in stated]
    header += [f"{name} [{unit}]" for name, unit in _CURVE.items()]
    for name, unit in _ESTIMATES.items():
        header += [_heading(f"{name}{end}", unit) for end in ("", "_low", "_high")]
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(header)
    for item in settings:
        own = [_text(item.settings.get(name, math.nan)) for name in stated]
        ends: list[str] = []
        for name in _ESTIMATES:
            value: Estimate = getattr(item, name)
            ends += [_text(x) for x in (value.value, *(value.interval or (math.nan, math.nan)))]
        for row in zip(item.velocity, item.force, item.low, item.high, strict=True):
            writer.writerow([*own, *(_text(x) for x in row), *ends])
    return stream.getvalue()


def _heading(name: str, unit: str) -> str:
    words = words_of(name)
    return f"{words} [{unit}]" if unit else words


def _text(value: float) -> str:
    return "" if math.isnan(value) else f"{value:.9g}"


def is_map_table(file: Path) -> bool:
    """Whether a file is a table of forces over velocity, not a record over time."""
    if file.suffix.lower() not in _TEXTS:
        return False
    names = _names(next(iter(cells_of_file(file)), []))
    return {"velocity", "force"} <= set(names) and not {"time", "displacement"} & set(names)


def _names(header: Sequence[str]) -> list[str]:
    return [_name(name_and_unit(cell)[0]) for cell in header]


def _name(text: str) -> str:
    return text.strip().lower().replace(" ", "_").replace("-", "_")


def settings_of_table(path: str | Path) -> tuple[DamperSetting, ...]:
    """Read the settings of a table with the columns ``velocity`` and ``force``, SI unless a unit is stated.

    Raises
    ------
    RecordingError
        If a column is missing, unknown or given twice, a cell is no number, or a velocity is there twice.
    """
    file = existing_file(Path(path), RecordingError)
    header, *rows = cells_of_file(file) or [[]]
    names, units = _names(header), [name_and_unit(cell)[1] for cell in header]
    for name in ("velocity", "force"):
        if names.count(name) != 1:
            raise RecordingError(
                Phrase("one column {name} is required", name=name),
                where=str(file), found=", ".join(header), allowed="velocity [m/s], force [N], clicks",
            )  # fmt: skip
    groups: dict[tuple[tuple[str, float], ...], list[dict[str, float]]] = {}
    for number, row in enumerate(rows, 2):
        if not any(cell.strip() for cell in row):
            continue
        values: dict[str, float] = {}
        stated: dict[str, float] = {}
        for name, unit, cell in zip(names, units, row, strict=False):
            text, where = f"{cell.strip()} {unit}".strip(), f"{file}, row {number}, {name}"
            if not cell.strip():
                continue
            if name in SETTINGS or is_clicks(name):
                stated[name] = si_of_setting(name, text, where)
            elif (si := _unit_of(name)) is not None:
                values[name] = si_of_cell(cell, unit, si, where)
        for name in ("velocity", "force"):
            if name not in values:
                raise RecordingError("no number", where=f"{file}, row {number}, {name}")
        groups.setdefault(tuple(stated.items()), []).append(values)
    settings = tuple(_setting(dict(key), points, file) for key, points in groups.items())
    if not settings:
        raise RecordingError("the table has no rows", where=str(file))
    return tuple(sorted(settings, key=lambda item: [*map(_order, item.settings.items())]))


def _order(item: tuple[str, float]) -> float:
    return item[1] if is_clicks(item[0]) else 0.0


def _unit_of(name: str) -> str | None:
    stem = name.removesuffix("_low").removesuffix("_high")
    return _CURVE.get(name) or _ESTIMATES.get(stem)


def _setting(stated: dict[str, float], points: list[dict[str, float]], file: Path) -> DamperSetting:
    points = sorted(points, key=lambda point: point["velocity"])
    velocity = np.array([point["velocity"] for point in points])
    place = f"{file}, " + (
        ", ".join(f"{words_of(k)} {v:g}" for k, v in stated.items()) or "velocity"
    )
    if len(velocity) < 2 or not np.all(np.diff(velocity) > 0.0):
        raise RecordingError(
            "a setting needs at least two velocities, each of them once", where=place,
            hint="Name what differs between them in a column: clicks, bump clicks, temperature [degC].",
        )  # fmt: skip
    force, low, high = (
        np.array([point.get(name, math.nan) for point in points])
        for name in ("force", "low", "high")
    )
    estimates = {name: _estimate(points[0], name) for name in _ESTIMATES}
    return DamperSetting(
        stated, (file.name,), velocity, force, low, high, repeatability=None, knees=(), **estimates
    )


def _estimate(point: dict[str, float], name: str) -> Estimate:
    value = point.get(name, math.nan)
    low, high = (point.get(f"{name}_{end}", math.nan) for end in ("low", "high"))
    if math.isnan(low + high):
        return Estimate(value)
    return Estimate(value, (high - low) / (2.0 * _LEVEL), (low, high))
