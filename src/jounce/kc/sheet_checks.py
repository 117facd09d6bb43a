"""What looks wrong on a measured sheet: signs, sides, units, exchanged and doubled channels, missing tests."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.findings import Finding, finding
from jounce.core.types import Array
from jounce.kc.loops import noise_of
from jounce.kc.readings import Channel
from jounce.kc.tests import TESTS
from jounce.kc.vocabulary import INPUTS, QUANTITIES, WHEELS, mirror_of, quantity_name

if TYPE_CHECKING:
    import xarray as xr

_LARGEST = {"rad": 1.2, "m": 1.0, "N": 60e3, "N*m": 20e3}
"""Largest plausible readings of a suspension, SI; handwheel angles turn further."""
_OTHER = {"rad": ("deg", "rad"), "m": ("mm", "m"), "N": ("N", "kN"), "N*m": ("N*mm", "N*m")}
"""Unit that a far too large reading probably has, and the unit that it was given."""
_TURNED, _TURNED_BY_LOAD = {"rack": 1.6, "heights": 0.25, "roll": 0.25}, 0.06
"""Largest plausible change of toe and camber, rad, by the kind of a test, and in tests with horizontal loads."""
_LEAST_LOAD, _LEAST_INPUT = 50.0, {"m": 1e-3, "rad": 2e-4, "N": 20.0, "N*m": 0.5}
"""Least mean wheel load in N, and least range of an input, SI, that are plausible."""
_CLEAR = {"rad": 2e-4, "m": 2e-4, "N": 20.0, "N*m": 1.0}
"""Change over a test, SI, from which its sign is judged."""
_PASSIVE = {
    "lateral_force": ("contact_point_y", "wheel_centre_y"),
    "longitudinal_force": ("contact_point_x", "wheel_centre_x"),
    "aligning_moment": ("steer",),
}
"""Movements that a force at the wheel cannot push the other way, the surest first."""
_MIRRORED = ("toe", "camber", "steer", "wheel_centre_y", "contact_point_y", "wheel_centre_x")
_WHEEL_TEST = ("toe", "camber", "wheel_centre_x", "wheel_centre_y")
_FULL, _FEWEST = 4, 5
"""Tests from which a sheet counts as one of a laboratory; samples that are not equal by chance."""


def check_test(
    test: str, dataset: xr.Dataset, channels: Mapping[str, Channel], place: str
) -> list[Finding]:
    """Return what looks wrong in one measured test."""
    values = {str(name): np.asarray(dataset[name].values) for name in dataset.data_vars}
    sweep = np.asarray(dataset["input"].values)
    labels = {name: channels[name].label if name in channels else name for name in values}
    unit = str(dataset["input"].attrs["units"])
    findings = [*_sizes(test, values, sweep, unit, labels, place)]
    if any(item.severity == "problem" for item in findings):
        return findings  # signs of readings in a wrong unit mean nothing
    findings += _doubled(values, labels, place)
    if test == "steer":
        findings += _handwheel(values, labels, place)
    changes = {name: _change(sweep, array) for name, array in values.items()}
    findings += _passivity(test, values, labels, place)
    findings += _loads(test, values, changes, labels, place)
    findings += _mirrors(test, changes, labels, place)
    return findings


def _sizes(
    test: str,
    values: Mapping[str, Array],
    sweep: Array,
    unit: str,
    labels: Mapping[str, str],
    place: str,
) -> Iterator[Finding]:
    for name, array in values.items():
        quantity = quantity_name(name)
        si, finite = QUANTITIES[quantity].unit, array[np.isfinite(array)]
        largest = float(np.max(np.abs(finite), initial=0.0))
        limit = 60.0 if quantity == "handwheel_angle" else _LARGEST[si]
        if largest > limit:
            likely, written = _OTHER[si]
            numbers = {"column": labels[name], "largest": largest, "unit": si}
            yield finding("kc.too_large", place, largest, **numbers, likely=likely, written=written)
        elif quantity in ("toe", "camber") and largest > 0.0:
            turned = float(np.ptp(finite))
            if turned > _TURNED.get(TESTS[test].kind, _TURNED_BY_LOAD):
                numbers = {"column": labels[name], "reach": turned, "test": test}
                yield finding("kc.turns_too_far", place, turned, **numbers)
        elif quantity == "vertical_force" and 0.0 < abs(float(np.mean(finite))) < _LEAST_LOAD:
            load = float(np.mean(finite))
            yield finding("kc.load_too_small", place, load, column=labels[name], load=load)
    reach = float(np.ptp(sweep))
    if reach < _LEAST_INPUT[unit]:
        yield finding("kc.input_too_small", place, reach, reach=reach, unit=unit)


def _doubled(
    values: Mapping[str, Array], labels: Mapping[str, str], place: str
) -> Iterator[Finding]:
    """Yield channels whose readings are those of another column, sample by sample.

    Both wheels may have equal readings without noise: a commanded height, or a sheet that was computed.
    """
    names = [name for name in values if np.ptp(values[name][np.isfinite(values[name])]) > 0.0]
    for name, other in itertools.combinations(names, 2):
        quantities = {quantity_name(name), quantity_name(other)}
        is_one_column = labels[name] == labels[other] or quantities == {"toe", "steer"}
        if is_one_column or values[name].size < _FEWEST:
            continue
        if not np.array_equal(values[name], values[other], equal_nan=True):
            continue
        smooth = noise_of(values[name]) < 1e-6 * float(np.nanmax(np.abs(values[name])))
        if len(quantities) > 1 or not smooth:
            yield finding("kc.doubled", place, columns=[labels[name], labels[other]])


def _handwheel(
    values: Mapping[str, Array], labels: Mapping[str, str], place: str
) -> Iterator[Finding]:
    """Yield a rack travel that is a handwheel angle: more than 90 of its numbers, 8 to 25 for a degree of steer."""
    rack = values.get("rack_travel")
    steers = [values[name] for name in ("left.steer", "right.steer") if name in values]
    if rack is None or not steers:
        return
    turned = float(np.degrees(np.ptp(np.mean(steers, axis=0))))
    for written in (1e3 * float(np.ptp(rack)), float(np.ptp(rack))):  # mm, or m
        ratio = written / turned if turned > 0.0 else 0.0
        if written > 90.0 and 8.0 <= ratio <= 25.0:
            yield finding("kc.handwheel_as_rack", place, ratio, column=labels["rack_travel"],
                          ratio=ratio)  # fmt: skip
            return


def _passivity(
    test: str, values: Mapping[str, Array], labels: Mapping[str, str], place: str
) -> Iterator[Finding]:
    """Yield movements against the force that causes them: no suspension gives work back along a whole sweep."""
    force = INPUTS[TESTS[test].kind]
    if test in ("lateral-trail", "braking-inboard", "driving") or force not in _PASSIVE:
        return
    for wheel in WHEELS:
        push = values.get(f"{wheel}.{force}")
        moved = next(
            (f"{wheel}.{name}" for name in _PASSIVE[force] if f"{wheel}.{name}" in values), ""
        )
        if push is None or not moved or np.ptp(push) < _CLEAR[QUANTITIES[force].unit]:
            continue
        change = _change(push, values[moved])
        if change < -_CLEAR[QUANTITIES[quantity_name(moved)].unit]:
            names = {"force": labels[f"{wheel}.{force}"], "column": labels[moved]}
            yield finding("kc.against_force", place, change, **names)


def _loads(
    test: str,
    values: Mapping[str, Array],
    changes: Mapping[str, float],
    labels: Mapping[str, str],
    place: str,
) -> Iterator[Finding]:
    """Yield wheel loads that fall in bump or are negative, and loads of the other wheel in roll."""
    rises = {}
    for wheel in WHEELS:
        name = f"{wheel}.vertical_force"
        if name not in values:
            continue
        if float(np.nanmean(values[name])) < 0.0:
            yield finding("kc.load_negative", place, column=labels[name])
            return
        travel = next((f"{wheel}.{z}" for z in ("contact_point_z", "wheel_centre_z")
                       if f"{wheel}.{z}" in values), "")  # fmt: skip
        if test == "bounce":
            change = _change(values[travel], values[name]) if travel else changes[name]
            if change < -_CLEAR["N"]:
                yield finding("kc.load_falls", place, change, column=labels[name])
        elif test == "roll":
            side = 1.0 if wheel == "left" else -1.0
            change = _change(values[travel], values[name]) if travel else side * changes[name]
            rises[wheel] = change
    if len(rises) == 2 and max(rises.values()) < -_CLEAR["N"]:
        names = [labels[f"{wheel}.vertical_force"] for wheel in WHEELS]
        yield finding("kc.wheels_exchanged", place, columns=names)


def _mirrors(
    test: str, changes: Mapping[str, float], labels: Mapping[str, str], place: str
) -> Iterator[Finding]:
    """Yield quantities of similar size on both wheels whose signs are not those of mirror images."""
    mirror = mirror_of(test)
    for quantity in _MIRRORED if mirror else ():
        left, right = (changes.get(f"{wheel}.{quantity}") for wheel in WHEELS)
        if left is None or right is None or (quantity == "steer" and "left.toe" in changes):
            continue
        clear = 2.0 * _CLEAR[QUANTITIES[quantity].unit]
        is_alike = 0.5 < abs(left) / max(abs(right), 1e-300) < 2.0
        expected = mirror * QUANTITIES[quantity].mirror
        if min(abs(left), abs(right)) > clear and is_alike and left * right * expected < 0.0:
            columns = [labels[f"{wheel}.{quantity}"] for wheel in WHEELS]
            yield finding("kc.not_mirrored", place, columns=columns, test=test)


def check_sheet(tests: Mapping[str, xr.Dataset]) -> list[Finding]:
    """Return what looks wrong between the tests of a sheet: wheels exchanged in roll, and missing tests."""
    findings = [*_exchanged(tests)]
    missing = [name for name in TESTS if name not in tests]
    usual = [name for name in missing if name in _USUAL]
    if len(tests) >= _FULL and usual:
        findings.append(finding("kc.tests_missing", "sheet", names=usual))
    return findings


_USUAL = ("bounce", "roll", "steer", "lateral-in-phase", "lateral-opposed", "braking", "driving",
          "aligning-in-phase", "aligning-opposed")  # fmt: skip


def _exchanged(tests: Mapping[str, xr.Dataset]) -> Iterator[Finding]:
    """Yield quantities that follow the other wheel's travel in roll: a wheel moves in roll as it does in bounce."""
    if "bounce" not in tests or "roll" not in tests:
        return
    bounce, roll = tests["bounce"], tests["roll"]
    for quantity in _WHEEL_TEST:
        signs = []
        for wheel, side in (("left", 1.0), ("right", -1.0)):
            name = f"{wheel}.{quantity}"
            if name in bounce and name in roll:
                clear = 2.0 * _CLEAR[QUANTITIES[quantity].unit]
                gains = [
                    _change(np.asarray(data["input"].values), np.asarray(data[name].values))
                    for data in (bounce, roll)
                ]
                if min(map(abs, gains)) > clear:
                    signs.append(float(np.sign(gains[0] * gains[1] * side)))
        if signs == [-1.0, -1.0]:
            columns = [f"{wheel}.{quantity}" for wheel in WHEELS]
            place = str(roll.attrs.get("source", "roll"))
            yield finding("kc.wheels_exchanged", place, columns=columns)


def _change(sweep: Array, values: Array) -> float:
    """Return the change of values (their unit) along a straight line over the range of an input (its unit)."""
    good = np.isfinite(sweep) & np.isfinite(values)
    x, y = sweep[good], values[good]
    if x.size < 2 or not np.ptp(x) > 0.0:
        return 0.0
    x = x - x.mean()
    return float((x * (y - y.mean())).sum() / (x**2).sum() * np.ptp(x))
