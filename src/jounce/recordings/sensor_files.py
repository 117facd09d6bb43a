"""Sensor descriptions read from a sensor file, a campaign, or a laboratory's settings."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from jounce.core.description import check_schema, read_toml
from jounce.core.errors import DescriptionError
from jounce.core.phrases import Phrase
from jounce.core.units import to_si
from jounce.recordings.conditioning import range_of, sensitivity_of
from jounce.recordings.schema import channel_unit
from jounce.recordings.sensors import Sensor, check_sensors

_SCHEMAS = ("jounce.sensors/1", "jounce.campaign/1", "jounce.truth/1", "jounce.laboratory/1")


def read_sensors(path: Path | str) -> dict[str, Sensor]:
    r"""Read sensor descriptions from a file, by measured channel.

    Parameters
    ----------
    path : Path or str
        TOML with tables ``[sensors."sprung.az"]`` (schema ``jounce.sensors/1``, or a campaign), or the settings of a
        laboratory (schema ``jounce.laboratory/1``), whose ``[channels]`` are named by the columns of the card.

    Returns
    -------
    dict of str to Sensor
        Sensors by channel, as accepted by `read_recording`.

    Raises
    ------
    DescriptionError
        If the file has no sensors or is invalid; the message names file, line, key, value and allowed values.

    Examples
    --------
    >>> import tempfile
    >>> file = Path(tempfile.mkdtemp()) / "card.toml"
    >>> text = 'schema = "jounce.sensors/1"\n[sensors."sprung.az"]\ncolumn = "ch0"\nsensitivity = "100 mV/g"\n'
    >>> _ = file.write_text(text)
    >>> read_sensors(file)["sprung.az"].column
    'ch0'
    """
    table, text = read_toml(path)
    is_laboratory = check_schema(table, _SCHEMAS, str(path)) == "jounce.laboratory/1"
    key = "channels" if is_laboratory else "sensors"
    given = table.get(key)
    if not isinstance(given, Mapping) or not given:
        allowed = (
            "[channels.COLUMN] with the quantity of each channel"
            if is_laboratory
            else '[sensors."sprung.az"]'
        )
        raise DescriptionError(
            "the file has no sensors",
            where=f"{path}: {key}",
            allowed=Phrase("tables {allowed}", allowed=allowed),
        )
    sensors = {}
    for name, entry in given.items():
        channel, keys = (
            _channel_entry(name, entry, f"{path}: {key}") if is_laboratory else (name, entry)
        )
        sensors[channel] = Sensor.from_table(keys, where=str(path), text=text, path=(key, name))
    check_sensors(sensors, f"{path}: {key}")
    for name, sensor in sensors.items():
        _check_chain(name, sensor, f"{path}: {key}")
    return sensors


def _check_chain(name: str, sensor: Sensor, where: str) -> None:
    """Refuse an invalid sensitivity, zero or range before a file is read."""
    if sensor.sensitivity:
        chain = sensitivity_of(
            sensor.sensitivity, channel_unit(name), where=f"{where}: {name}.sensitivity"
        )
        if sensor.zero:
            to_si(sensor.zero, chain.recorded, where=f"{where}: {name}.zero")
    range_of(name, sensor, where=where)


def _channel_entry(column: str, entry: Any, where: str) -> tuple[str, dict[str, Any]]:
    """Return the channel measured by a column of a laboratory's card, and the keys of its sensor."""
    if not isinstance(entry, Mapping) or not isinstance(entry.get("measures"), str):
        raise DescriptionError(
            "the quantity that it measures is missing",
            where=f"{where}.{column}",
            allowed='measures = "sprung.az"',
        )
    return entry["measures"], {
        "column": column,
        **{key: item for key, item in entry.items() if key != "measures"},
    }
