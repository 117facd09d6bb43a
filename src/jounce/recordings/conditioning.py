"""From what an acquisition card recorded to physical signals: sensitivity, zero and calibration of a channel."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.columns import ColumnTable, name_and_unit
from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.core.units import conversion_factor, is_unit_of, to_si
from jounce.recordings.plausibility import implausible
from jounce.recordings.quality import check_even
from jounce.recordings.schema import channel_unit, describe, place_of

if TYPE_CHECKING:
    import xarray as xr

    from jounce.recordings.sensors import Sensor

ELECTRICAL = {"V": "voltage", "A": "current", "1": "counts"}
"""What cards record, by SI unit: the last word of the channel that holds it."""
_BETWEEN = ("C", "V", "A", "1", "ohm")
"""SI units of what sensors and conditioners hand on."""
_COUNTS = frozenset(
    {"count", "counts", "lsb", "digit", "digits", "bit", "bits", "inc", "increments"}
)
_RATIO = re.compile(
    r"\s*(?P<above>[+-]?[\d.]+(?:[eE][+-]?\d+)?)\s*(?P<unit>[^\s/\d(][^/]*?)\s*/\s*"
    r"(?P<below>[\d.]+(?:[eE][+-]?\d+)?)?\s*(?P<per>\([^()]+\)|[^\s/\d(][^/]*(?:/\s*s(?:\^?2|²)?)?)\s*"
)
_EXAMPLES = '"100 mV/g", "5 V / 50 mm", ["10 pC/(m/s^2)", "1 mV/pC"]'


@dataclass(frozen=True)
class Sensitivity:
    """What is recorded for one SI unit of the quantity: ``factor`` in the SI unit ``recorded`` (V, A or 1: counts)."""

    factor: float
    recorded: str


def sensitivity_of(
    given: str | Sequence[str], unit: str, *, where: str = "sensitivity"
) -> Sensitivity:
    """Read a sensitivity, or a chain of them from the sensor to the card.

    Parameters
    ----------
    given : str or sequence of str
        ``"100 mV/g"``, ``"5 V / 50 mm"``, or links in order: ``["10 pC/(m/s^2)", "1 mV/pC"]``.
    unit : str
        SI unit of the quantity that is measured.
    where : str
        Place that errors name.

    Returns
    -------
    Sensitivity
        Recorded size for one SI unit.

    Raises
    ------
    DescriptionError
        Without a unit, with a unit that does not follow from the link before, or with a size of 0.

    Examples
    --------
    >>> round(sensitivity_of("100 mV/g", "m/s^2").factor, 6), sensitivity_of("5 V / 50 mm", "m")
    (0.010197, Sensitivity(factor=100.0, recorded='V'))
    >>> sensitivity_of(["10 pC/(m/s^2)", "1 mV/pC"], "m/s^2").factor
    0.01
    """
    links = [given] if isinstance(given, str) else list(given)
    factor, before = 1.0, unit
    for link in links:
        size, before = _link(link, before, where)
        factor *= size
    if not links or before not in ELECTRICAL:
        raise DescriptionError(
            "the sensitivity does not end in what a card records",
            where=where,
            found=", ".join(links),
            allowed=Phrase(
                "a voltage, a current or counts at the end, e.g. {examples}", examples=_EXAMPLES
            ),
        )
    return Sensitivity(factor, before)


def _link(text: str, unit: str, where: str) -> tuple[float, str]:
    """Size of one link for one SI ``unit``, and the SI unit of what it gives."""
    match = _RATIO.fullmatch(text)
    if match is None:
        raise DescriptionError(
            "not a sensitivity with its units", where=where, found=text, allowed=_EXAMPLES
        )
    per = match["per"].strip("() ")
    given = _electrical_unit(match["unit"].strip())
    if given is None or not is_unit_of(per, unit):
        wrong = match["unit"].strip() if given is None else per
        allowed = Phrase(
            "{examples}; behind the stroke a unit that converts to {unit}",
            examples=_EXAMPLES,
            unit=unit,
        )
        raise DescriptionError(
            Phrase("the unit {wrong!r} does not fit a sensitivity", wrong=wrong),
            where=where,
            found=text,
            allowed=allowed,
        )
    size = to_si(match["above"], "1", where=where) * _factor(match["unit"].strip(), given)
    below = to_si(match["below"] or "1", "1", where=where) * conversion_factor(
        per, unit, where=where
    )
    if size == 0.0 or below == 0.0:
        raise DescriptionError(
            "a sensitivity of 0 records nothing", where=where, found=text, allowed=_EXAMPLES
        )
    return size / below, given


def _electrical_unit(unit: str) -> str | None:
    if unit.lower() in _COUNTS:
        return "1"
    return next((si for si in _BETWEEN if si != "1" and is_unit_of(unit, si)), None)


def _factor(unit: str, si: str) -> float:
    return 1.0 if unit.lower() in _COUNTS else conversion_factor(unit, si)


# reading --------------------------------------------------------------------------------------------------------------


def electrical_columns(
    sensors: Mapping[str, Sensor], tables: Iterable[ColumnTable]
) -> dict[str, str]:
    """Map the channels that sensors record to their columns in a file, as ``columns`` of `read_recording`.

    A column without a unit is in V, A or counts, as the sensitivity ends; columns that the file lacks are left out.
    """
    columns, known = {}, [column for table in tables for column in table]
    for name, sensor in sensors.items():
        if not sensor.column:
            continue
        recorded = "V"
        if sensor.sensitivity:
            recorded = sensitivity_of(
                sensor.sensitivity, channel_unit(name), where=f"sensors: {name}"
            ).recorded
            name = f"{name}.{ELECTRICAL[recorded]}"  # noqa: PLW2901
        plain = name_and_unit(sensor.column)[0]
        there = next(
            (c for c in known if plain in (c.name, c.label, c.written) or sensor.column == c.label),
            None,
        )
        if there is not None:
            bare = not there.unit and sensor.column == plain and name in raw_names([name])
            columns[name] = f"{plain} [{recorded}]" if bare else sensor.column
    return columns


def condition(
    data: xr.Dataset, sensors: Mapping[str, Sensor], *, where: str
) -> tuple[xr.Dataset, list[Finding]]:
    """Turn voltages, currents and counts into the quantities that their sensors measure.

    Parameters
    ----------
    data : xarray.Dataset
        Recording with a channel ``<name>.voltage`` (V), ``.current`` (A) or ``.counts`` (1) for each sensor with a
        sensitivity.
    sensors : mapping of str to Sensor
        By the channel that each measures.
    where : str
        File named in findings.

    Returns
    -------
    dataset : xarray.Dataset
        The same recording with those channels in SI in place of what the card recorded. Orientation and gain of a
        sensor stay: the model's signals go through them.
    findings : list of Finding
        What reached the end of a sensor's range, an offset that was taken off behind AC coupling, and numbers that no
        suspension reaches.

    Raises
    ------
    RecordingError
        For time with steps that differ: the chain of a sensor is defined for a constant rate.
    """
    time = check_even(data["time"].to_numpy(), where=where)
    channels, findings = {}, list[Finding]()
    for name, sensor in sensors.items():
        if not sensor.sensitivity:
            continue
        chain = sensitivity_of(sensor.sensitivity, channel_unit(name), where=f"sensors: {name}")
        raw = f"{name}.{ELECTRICAL[chain.recorded]}"
        if raw not in data:
            continue
        recorded = data[raw].to_numpy()
        zero = (
            to_si(sensor.zero, chain.recorded, where=f"sensors: {name}.zero")
            if sensor.zero
            else 0.0
        )
        if (
            sensor.high_pass is not None and not sensor.zero
        ):  # behind AC coupling a mean is the conditioner's offset
            zero = float(recorded.mean())
            findings += _offset_removed(name, recorded, zero, chain, where)
        values = (recorded - zero) / chain.factor
        attributes = {
            "units": channel_unit(name),
            "long_name": describe(name),
            "place": place_of(name),
        }
        channels[name] = (data[raw].dims, values, attributes)
        data = data.drop_vars(raw)
        findings += _beyond(name, values, sensor, where)
    step = float(time[-1] - time[0]) / max(len(time) - 1, 1)
    findings += implausible(
        {name: values for name, (_, values, _) in channels.items()}, step, where=where
    )
    return data.assign(channels), findings


def _offset_removed(
    name: str, recorded: Array, zero: float, chain: Sensitivity, where: str
) -> list[Finding]:
    """Say which mean was taken off behind AC coupling, where it can be seen beside the signal."""
    if abs(zero) <= _SEEN * float(np.ptp(recorded)):
        return []
    return [finding("recordings.offset_removed", f"{where}: {name}", zero / chain.factor)]


_SEEN = 0.01  # of the range of a signal, from which on an offset is said


def _beyond(name: str, values: np.ndarray, sensor: Sensor, where: str) -> Iterator[Finding]:
    """Say how much of a record lies at the end of its range: what is beyond was not recorded."""
    ends = range_of(name, sensor)
    if ends is None:
        return
    share = float(np.mean((values <= ends[0] * _AT_END) | (values >= ends[1] * _AT_END)))
    if share > 0.0:
        unit = channel_unit(name)
        yield finding(
            "recordings.at_end_of_range",
            f"{where}: {name}",
            share,
            share=share,
            end=ends[1],
            unit=unit,
        )


_AT_END = 1.0 - 1e-3
"""Share of a range from which on a sample counts as cut: converters end one step below it."""


def range_of(name: str, sensor: Sensor, *, where: str = "sensors") -> tuple[float, float] | None:
    """Least and greatest size (SI) that a channel can record; None where that is not stated.

    A range is given for the quantity (``"50 g"``) or for what is recorded (``"10 V"``).

    >>> from jounce.recordings import Sensor
    >>> range_of("sprung.az", Sensor(sensitivity="1 V/(m/s^2)", range="10 V"))
    (-10.0, 10.0)
    """
    return (
        _range(name, sensor.range, sensor.sensitivity, sensor.zero, f"{where}: {name}")
        if sensor.range
        else None
    )


@lru_cache(maxsize=256)  # a fit asks at every evaluation
def _range(
    name: str, given: str, sensitivity: str | tuple[str, ...], zero: str, where: str
) -> tuple[float, float]:
    unit, text = channel_unit(name), given.lstrip("±").strip()
    chain = sensitivity_of(sensitivity, unit, where=where) if sensitivity else None
    if chain is not None and _has_unit(text, chain.recorded):
        size = to_si(text, chain.recorded, where=f"{where}.range")
        middle = to_si(zero, chain.recorded, where=f"{where}.zero") if zero else 0.0
        ends = sorted(((-size - middle) / chain.factor, (size - middle) / chain.factor))
        return ends[0], ends[1]
    size = to_si(text, unit, where=f"{where}.range")
    return -size, size


def cut_to_range(name: str, sensor: Sensor, table: Array) -> Array:
    """Cut a reading at the end of its sensor's range; what stands beside it (derivatives of it) is 0 there.

    Parameters
    ----------
    name : str
        Channel, which says the SI unit of the reading.
    sensor : Sensor
        Its chain; without a range nothing is cut.
    table : ndarray, shape (n,) or (n, k)
        Readings, or a column of readings and columns of derivatives.

    Returns
    -------
    ndarray, shape of ``table``
        The same, cut.

    Examples
    --------
    >>> from jounce.recordings import Sensor
    >>> cut_to_range("sprung.az", Sensor(range="10 m/s^2"), np.array([[12.0, 1.0], [3.0, 1.0]])).tolist()
    [[10.0, 0.0], [3.0, 1.0]]
    """
    ends = range_of(name, sensor)
    if ends is None:
        return table
    reading = table if table.ndim == 1 else table[:, 0]
    beyond = (reading < ends[0]) | (reading > ends[1])
    cut = table.copy()
    if table.ndim == 1:
        return np.clip(cut, *ends)
    cut[:, 0] = np.clip(reading, *ends)
    cut[beyond, 1:] = 0.0
    return cut


def _has_unit(text: str, si: str) -> bool:
    return is_unit_of(text.lstrip("+-0123456789.eE").strip(), si)


def raw_names(names: Iterable[str]) -> list[str]:
    """Channels that hold what a card recorded, not yet a quantity."""
    return [name for name in names if name.rpartition(".")[2] in ELECTRICAL.values()]
