"""Readings of one table in jounce's units and signs: columns found, converted, and what was wrong with them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from jounce.core.columns import Column
from jounce.core.errors import JounceError, RecordingError
from jounce.core.findings import Finding, finding
from jounce.core.text import without_accents
from jounce.core.types import Array
from jounce.core.units import conversion_factor, is_unit_of
from jounce.kc.channels import (
    KcColumn,
    KcMap,
    is_counter,
    needs_wheel,
    read_heading,
    refuse_axles,
)
from jounce.kc.conventions import SignConvention
from jounce.kc.gauges import toe_of_distance, toe_of_gauges
from jounce.kc.sections import Section
from jounce.kc.tests import TESTS
from jounce.kc.vocabulary import INPUTS, QUANTITIES, WHEELS

_ANGLES = ("rad", "deg")
_NAMED = 6  # columns that a finding names; own sheets of elastic axles have hundreds


@dataclass(frozen=True)
class Channel:
    """A column with its meaning.

    Attributes
    ----------
    column : Column
        The column as written.
    quantity : str
        Its quantity.
    wheel : str
        Its wheel; empty for the axle.
    unit : str
        Its unit; empty if nothing states it.
    entry : KcColumn or None
        Its entry in the map, if it has one.
    """

    column: Column
    quantity: str
    wheel: str
    unit: str
    entry: KcColumn | None = None

    @property
    def label(self) -> str:
        """The heading, as written."""
        return self.column.written or self.column.label


@dataclass
class Readings:
    """Readings of a table by variable (SI, jounce's signs), their channels, and findings."""

    values: dict[str, Array] = field(default_factory=dict)
    channels: dict[str, Channel] = field(default_factory=dict)
    findings: list[Finding] = field(default_factory=list)


def channels_of(section: Section, rig: KcMap, test: str | None) -> tuple[list[Channel], list[str]]:
    """Return the channels of a table, and the headings that are not recognised. Raises for columns of two axles."""
    channels, unknown, axles = [], list[str](), set[str]()
    for column in section.table:
        entry = rig.column(column, test)
        if entry is not None:
            if entry.quantity:
                unit = entry.unit or column.unit
                channels.append(Channel(column, entry.quantity, entry.wheel or "", unit, entry))
            continue
        heading = read_heading(column.name, column.unit)
        if heading is not None and heading.axle and rig.axle and heading.axle != rig.axle:
            continue
        if heading is None:
            if not (is_counter(column.name) or column.is_empty):
                unknown.append(column.written or column.label)
            continue
        axles.add(heading.axle)
        channels.append(Channel(column, heading.quantity, heading.wheel, heading.unit))
    if {"front", "rear"} <= axles:
        raise refuse_axles(section.place)
    return channels, unknown


def _some_of(names: list[str]) -> list[str]:
    """Name the first columns, and how many more there are.

    >>> _some_of(["a", "b"]), _some_of([*"abcdefgh"])
    (['a', 'b'], ['a', 'b', 'c', 'd', 'e', '… (8 in all)'])
    """
    return names if len(names) <= _NAMED else [*names[: _NAMED - 1], f"… ({len(names)} in all)"]


def read_section(section: Section, rig: KcMap, signs: SignConvention, test: str | None) -> Readings:
    """Convert the columns of a table to jounce's units and signs; ``test`` is None as long as it is not known."""
    result = Readings()
    channels, unknown = channels_of(section, rig, test)
    place = section.place
    if unknown:
        result.findings.append(finding("kc.not_recognised", place, columns=_some_of(unknown)))
    channels = _with_wheels(channels, section, rig, test, result.findings)
    assumed = []
    base: float | Array | None = rig.gauge_base
    rows = max(_last_row(column) for column in section.table)
    for channel in sorted(channels, key=lambda item: item.quantity != "gauge_base"):
        try:
            values, is_assumed = _in_si(channel, rows, signs, base, test)
        except JounceError as error:
            result.findings.append(finding("kc.column_left_out", place, error=error))
            continue
        if is_assumed:
            assumed.append(f"{channel.label} [{QUANTITIES[channel.quantity].usual}]")
        if channel.quantity == "gauge_base":
            base = values
        else:
            _store(result, channel, values, test, place)
    if assumed:
        result.findings.append(finding("kc.unit_assumed", place, columns=assumed))
    _read_gauges(result, base, place)
    _complete_angles(result.values)
    return result


def _with_wheels(
    channels: list[Channel],
    section: Section,
    rig: KcMap,
    test: str | None,
    findings: list[Finding],
) -> list[Channel]:
    """Give columns that name no wheel theirs: that of the map or of the title, or the input of the test."""
    bare = [channel for channel in channels if needs_wheel(channel.quantity) and not channel.wheel]
    if not bare:
        return channels
    if any(channel.wheel for channel in channels):
        has_input = any(channel.quantity == "input" for channel in channels)
        shared = [_as_input(channel, test, section.place, findings, has_input) for channel in bare]
        return [item for item in channels if item not in bare] + [*filter(None, shared)]
    wheel: str = stated(section, rig.wheels) or rig.wheel or _wheel_of(section.names)
    if not wheel:
        wheel = "left"
        findings.append(finding("kc.wheel_assumed", section.place, wheel=wheel))
    return [replace(item, wheel=wheel) if item in bare else item for item in channels]


def _as_input(
    channel: Channel, test: str | None, place: str, findings: list[Finding], has_input: bool
) -> Channel | None:
    """Return a column without a wheel, among columns with one, as the input of the test or the travel of both."""
    target = QUANTITIES[channel.quantity].target or channel.quantity
    if target in ("contact_point_z", "wheel_centre_z") and test in (None, "bounce"):
        wheel = "both"
    elif test is not None and INPUTS[TESTS[test].kind] == target and not has_input:
        wheel = "input"
    else:
        findings.append(finding("kc.no_wheel", place, column=channel.label))
        return None
    findings.append(finding("kc.for_both_wheels", place, column=channel.label))
    return replace(channel, wheel=wheel)


def stated(section: Section, names: Mapping[str, str]) -> str:
    """Return what a map says of a table by the name of its sheet or file; empty if it says nothing."""
    file = Path(section.table.file)
    return next(
        (names[name] for name in (section.title, file.name, file.stem) if name in names), ""
    )


def _wheel_of(names: Iterable[str]) -> str:
    for name in names:
        words = {*without_accents(name).replace("_", " ").replace("-", " ").split()}
        is_left, is_right = words & {"left", "links", "fl", "lf", "rl", "vl", "hl"}, words & {
            "right", "rechts", "fr", "rf", "rr", "vr", "hr"}  # fmt: skip
        if bool(is_left) != bool(is_right):
            return "left" if is_left else "right"
    return ""


def _in_si(
    channel: Channel,
    rows: int,
    signs: SignConvention,
    base: float | Array | None,
    test: str | None,
) -> tuple[Array, bool]:
    """Return the readings in jounce's unit and sign, and whether their unit had to be assumed."""
    quantity, column = QUANTITIES[channel.quantity], channel.column
    si = quantity.unit or TESTS[test or "bounce"].unit
    unit = channel.unit or (quantity.usual if quantity.unit else "")
    values = _numbers(column, rows)
    if channel.entry is not None:
        values = channel.entry.sign * (values - channel.entry.offset)
    values = values * quantity.times * signs.factor(channel.quantity)
    if channel.quantity == "toe" and is_unit_of(unit, "m"):
        return toe_of_distance(values * conversion_factor(unit, "m"), base, column.where), False
    if channel.quantity == "rack_travel" and unit in _ANGLES:
        raise RecordingError(
            "an angle in the column of the rack travel",
            where=column.where,
            found=unit,
            allowed="a length",
            hint="Is it the handwheel angle? Then map the column to handwheel_angle.",
        )
    if channel.quantity == "input" and not unit:
        raise RecordingError("the header has no unit", where=column.where, allowed=si)
    return values * conversion_factor(unit, si, where=column.where), not channel.unit


def _last_row(column: Column) -> int:
    return len(column.values) if column.part is None else int(column.part[0][-1]) + 1


def _numbers(column: Column, rows: int) -> Array:
    """Return the numbers of a column, NaN in empty cells; raise its fault for texts."""
    if column.fault is not None and column.part is not None:
        values = np.full(rows, np.nan)
        values[column.part[0]] = column.part[1]
        return values
    return np.asarray(column.readable().values, dtype=float)


def _store(result: Readings, channel: Channel, values: Array, test: str | None, place: str) -> None:
    target = QUANTITIES[channel.quantity].target or channel.quantity
    if channel.wheel == "input":
        rearward = (
            target == "longitudinal_force" and test is not None and test.startswith("braking")
        )
        result.values["input"] = -values if rearward else values
        result.channels["input"] = channel
        return
    for wheel in WHEELS if channel.wheel == "both" else (channel.wheel,):
        name = f"{wheel}.{target}" if wheel else target
        before = result.channels.get(name)
        if before is None or (before.wheel == "both" and channel.wheel != "both"):
            result.values[name], result.channels[name] = values, channel
        elif channel.wheel != "both" and name in result.values:
            _store_again(result, name, channel, values, place)


def _store_again(result: Readings, name: str, channel: Channel, values: Array, place: str) -> None:
    """Keep the first of two columns of one variable if they say the same, neither if they contradict."""
    before = result.channels[name]
    same = np.array_equal(result.values[name], values, equal_nan=True)
    if same or before.quantity != channel.quantity:
        named = {"column": channel.label, "first": before.label}
        result.findings.append(finding("kc.column_twice", place, **named))
    else:
        del result.values[name]
        names = [before.label, channel.label]
        result.findings.append(finding("kc.columns_contradict", place, columns=names, name=name))


def _read_gauges(result: Readings, base: float | Array | None, place: str) -> None:
    """Turn pairs of dial gauges into toe angles."""
    for wheel in WHEELS:
        names = [f"{wheel}.toe_front_gauge", f"{wheel}.toe_rear_gauge"]
        pair = [result.values.pop(name, None) for name in names]
        front, rear = pair
        if front is None and rear is None:
            continue
        if front is None or rear is None:
            missing = names[0 if front is None else 1]
            result.findings.append(finding("kc.gauge_missing", place, gauge=missing))
            continue
        try:
            toe = toe_of_gauges(front, rear, base, place)
        except JounceError as error:
            result.findings.append(finding("kc.column_left_out", place, error=error))
            continue
        result.values[f"{wheel}.toe"] = toe
        result.findings.append(finding("kc.gauges_outward", f"{place}: {wheel}"))


def _complete_angles(values: dict[str, Array]) -> None:
    """Add toe where only the steer angle was measured, and the reverse: they are the same angle."""
    for wheel, sign in (("left", -1.0), ("right", 1.0)):
        toe, steer = f"{wheel}.toe", f"{wheel}.steer"
        if toe in values and steer not in values:
            values[steer] = sign * values[toe]
        elif steer in values and toe not in values:
            values[toe] = sign * values[steer]


def proposed_entry(channel: Channel) -> KcColumn:
    """Return the entry of a recognised column for a channel map."""
    wheel = channel.wheel if channel.wheel in WHEELS else None
    return KcColumn(quantity=channel.quantity, wheel=wheel, unit=channel.unit)
