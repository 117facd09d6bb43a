"""Conversion of the signals of an acquisition card to physical quantities: sensitivity, zero and range of a channel."""

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
"""Quantities that cards record, by SI unit: the last word of the raw channel's name."""
_BETWEEN = ("C", "V", "A", "1", "ohm")
"""SI units of the outputs of sensors and conditioners."""
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
    """Sensitivity of a measuring chain: ``factor`` in ``recorded`` (V, A, or 1: counts) per SI unit."""

    factor: float
    recorded: str


def sensitivity_of(
    given: str | Sequence[str], unit: str, *, where: str = "sensitivity"
) -> Sensitivity:
    """Parse a sensitivity, or a chain of sensitivities from the sensor to the card.

    Parameters
    ----------
    given : str or sequence of str
        ``"100 mV/g"``, ``"5 V / 50 mm"``, or links in order: ``["10 pC/(m/s^2)", "1 mV/pC"]``.
    unit : str
        SI unit of the measured quantity.
    where : str
        Location named in errors.

    Returns
    -------
    Sensitivity
        Recorded value per SI unit of the quantity.

    Raises
    ------
    DescriptionError
        If a unit is missing or does not match the output of the previous link, or if a value is 0.

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
            "the sensitivity does not end in a quantity that a data acquisition card records",
            where=where,
            found=", ".join(links),
            allowed=Phrase(
                "a chain that ends in a voltage, a current or counts, e.g. {examples}",
                examples=_EXAMPLES,
            ),
        )
    return Sensitivity(factor, before)


def _link(text: str, unit: str, where: str) -> tuple[float, str]:
    """Return the output of one link per SI ``unit`` of its input, and the SI unit of the output."""
    match = _RATIO.fullmatch(text)
    if match is None:
        raise DescriptionError(
            "a sensitivity with its units is required", where=where, found=text, allowed=_EXAMPLES
        )
    per = match["per"].strip("() ")
    given = _electrical_unit(match["unit"].strip())
    if given is None or not is_unit_of(per, unit):
        wrong = match["unit"].strip() if given is None else per
        allowed = Phrase(
            "{examples}; the unit after the slash must convert to {unit}",
            examples=_EXAMPLES,
            unit=unit,
        )
        raise DescriptionError(
            Phrase("the unit {wrong!r} is not valid in a sensitivity", wrong=wrong),
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
            "a sensitivity of 0 cannot record a signal", where=where, found=text, allowed=_EXAMPLES
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
    """Map the raw channels of sensors to columns of a file, in the form of ``columns`` of `read_recording`.

    A column without a unit is assumed to be in the final unit of the sensitivity (V, A or counts); columns that the
    file lacks are omitted.
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
    """Convert voltages, currents and counts to the quantities that their sensors measure.

    Parameters
    ----------
    data : xarray.Dataset
        Recording with a channel ``<name>.voltage`` (V), ``.current`` (A) or ``.counts`` (1) for each sensor with a
        sensitivity.
    sensors : mapping of str to Sensor
        Sensors by the channel that they measure.
    where : str
        File named in findings.

    Returns
    -------
    dataset : xarray.Dataset
        The recording with those channels in SI instead of the raw channels. Orientation and gain of a sensor are not
        undone here: they are applied to the model's signals.
    findings : list of Finding
        Samples at the end of a sensor's range, offsets removed after AC coupling, and implausible magnitudes.

    Raises
    ------
    RecordingError
        If the time steps differ: a sensor's chain is defined for a constant rate.
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
        ):  # after AC coupling the mean is the conditioner's offset
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
    """Report the mean removed after AC coupling if it is visible compared with the signal."""
    if abs(zero) <= _SEEN * float(np.ptp(recorded)):
        return []
    return [finding("recordings.offset_removed", f"{where}: {name}", zero / chain.factor)]


_SEEN = 0.01  # fraction of a signal's range above which an offset is reported


def _beyond(name: str, values: np.ndarray, sensor: Sensor, where: str) -> Iterator[Finding]:
    """Report the fraction of samples at the end of the sensor's range, beyond which nothing was recorded."""
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
"""Fraction of a range above which a sample counts as clipped: converters saturate one step below the range."""


def range_of(name: str, sensor: Sensor, *, where: str = "sensors") -> tuple[float, float] | None:
    """Return the minimum and maximum (SI) that a channel can record; None if the range is not stated.

    A range is given in the unit of the quantity (``"50 g"``) or of the recorded signal (``"10 V"``).

    >>> from jounce.recordings import Sensor
    >>> range_of("sprung.az", Sensor(sensitivity="1 V/(m/s^2)", range="10 V"))
    (-10.0, 10.0)
    """
    return (
        _range(name, sensor.range, sensor.sensitivity, sensor.zero, f"{where}: {name}")
        if sensor.range
        else None
    )


@lru_cache(maxsize=256)  # a fit calls this at every evaluation
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
    """Clip readings to their sensor's range; their derivatives are set to 0 outside it.

    Parameters
    ----------
    name : str
        Channel, which determines the SI unit of the readings.
    sensor : Sensor
        Sensor of the channel; without a range nothing is clipped.
    table : ndarray, shape (n,) or (n, k)
        Readings, or a column of readings followed by columns of their derivatives.

    Returns
    -------
    ndarray, shape of ``table``
        The clipped readings, and their derivatives.

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
    """Return the channels with raw signals of a card (voltage, current or counts)."""
    return [name for name in names if name.rpartition(".")[2] in ELECTRICAL.values()]
