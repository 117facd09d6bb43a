"""Measured and simulated K&C tests beside each other: slopes, differences, and where the model leaves its tolerance."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.errors import DescriptionError, unknown
from jounce.core.findings import Finding, finding, finding_attributes
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.kc.loops import lines_of
from jounce.kc.slopes import kc_slopes, slope_unit
from jounce.kc.tests import TESTS
from jounce.kc.vocabulary import READING, WHEELS, quantity_name

if TYPE_CHECKING:
    import xarray as xr

_SHARE, _NOISE, _GRID = 0.1, 3.0, 201
_FEWEST = 3  # inputs of a range that is judged
_CLEAR = 4.0  # tolerances by which a curve moves whose sign and unit are judged
_FACTORS = (1e3, 1e-3, float(np.pi / 180.0), float(180.0 / np.pi))
"""Factors of usual mistakes: m for mm, N for kN, deg for rad."""
_Pair = tuple[Array, Array, Array, float]
"""Inputs, simulated and measured curve, and tolerance."""
_NUMBERS = {
    "slope_simulated": "slope of the simulated curve",
    "slope_measured": "slope of the measured curve",
    "difference": "largest difference of the changes from zero input",
    "difference_at": "input of the largest difference",
    "tolerance": "allowed difference",
    "leaves_at": "input closest to zero at which the model leaves the tolerance",
    "offset": "simulated minus measured value at zero input",
    "nonlinearity_simulated": "nonlinearity of the simulated curve",
    "nonlinearity_measured": "nonlinearity of the measured curve",
    "hysteresis_simulated": "hysteresis of the simulated curve",
    "hysteresis_measured": "hysteresis of the measured curve",
    "low": "lower end of the range that is compared",
    "high": "upper end of the range that is compared",
}


def compare_kc(
    simulated: Mapping[str, xr.Dataset] | xr.Dataset,
    measured: Mapping[str, xr.Dataset] | xr.Dataset,
    tolerances: Mapping[str, float | str] | None = None,
) -> xr.Dataset:
    """Compare simulated with measured K&C tests, quantity by quantity, and judge each against a tolerance.

    Mean curves of both branches are compared over the inputs that both cover, as changes from zero input: a different
    static value is the ``offset``. Bounce and roll are compared over the travel of the wheel centres if both have it,
    because the model's tyre is rigid. A handwheel angle is compared with the model's own.

    Parameters
    ----------
    simulated, measured : mapping of str to xarray.Dataset, or xarray.Dataset
        Tests by name, or one test.
    tolerances : mapping of str to float or str, optional
        Allowed difference of a quantity, in its SI unit, as text with a unit, or as a share of the measured range:
        ``{"toe": "0.05 deg", "left.camber": "10 %", "roll.toe": 0.001}``; the more specific name counts. By default
        10 % of the measured range, plus three standard deviations of the reading noise, and at least what a laboratory
        reads: 0.01 deg, 0.1 mm, 10 N, 1 N m.

    Returns
    -------
    xarray.Dataset
        Over ``row``, with the coordinates ``test``, ``quantity``, ``unit`` and ``slope_unit``: slopes over the common
        range (SI), ``difference`` and the input where it is largest, ``tolerance``, ``leaves_at`` (the input closest to
        zero at which the model leaves the tolerance, NaN if it does not), ``offset``, shares of nonlinearity and
        hysteresis, the range, and ``verdict``: ``within``, ``outside`` or ``not judged``. Findings name tests and
        quantities that only one side has, and ranges that the model does not cover.

    Raises
    ------
    DescriptionError
        If a tolerance names no quantity or is not one, or a dataset is no K&C test.

    Examples
    --------
    >>> import numpy as np
    >>> import xarray as xr
    >>> x = np.linspace(-0.05, 0.05, 41)
    >>> def bounce(gain):                                                      # synthetic: two straight bump steers
    ...     toe = ("sample", gain * x, {"units": "rad"})
    ...     return xr.Dataset({"left.toe": toe}, {"input": ("sample", x, {"units": "m"})}, {"test": "bounce"})
    >>> table = compare_kc(bounce(-0.10), bounce(-0.12), {"toe": "0.02 deg"}).isel(row=0)
    >>> str(table["verdict"].values), round(float(table["difference"]), 9), round(abs(float(table["leaves_at"])), 3)
    ('outside', 0.001, 0.018)
    """
    ours, theirs = _tests(simulated, "simulated"), _tests(measured, "measured")
    _check_tolerances(tolerances or {}, theirs)
    findings: list[Finding] = []
    rows: list[dict[str, Any]] = []
    for test in sorted(theirs, key=_place):
        if test not in ours:
            findings.append(finding("kc.not_simulated", test))
            continue
        rows += _compare_test(test, ours[test], theirs[test], tolerances or {}, findings)
    only = [test for test in sorted(ours, key=_place) if test not in theirs]
    if only:
        findings.append(finding("kc.not_measured", "simulated", names=only))
    return _table(rows, findings)


def _tests(given: Mapping[str, xr.Dataset] | xr.Dataset, where: str) -> dict[str, xr.Dataset]:
    import xarray as xr

    if not isinstance(given, xr.Dataset):
        return dict(given)
    name = given.attrs.get("test")
    if name is None:
        raise DescriptionError("the dataset names no test", where=where, allowed="a K&C test")
    return {str(name): given}


def _place(test: str) -> int:
    names = [*TESTS]
    return names.index(test) if test in names else len(names)


def _check_tolerances(
    tolerances: Mapping[str, float | str], tests: Mapping[str, xr.Dataset]
) -> None:
    known = {
        key
        for test, data in tests.items()
        for name in data.data_vars
        for key in _keys(test, str(name))
    }
    for key in tolerances:
        if key not in known:
            raise unknown(key, sorted(known), what="quantity", where="tolerances")


def _keys(test: str, name: str) -> tuple[str, ...]:
    """Return the names of a quantity in tolerances, the most specific first."""
    return f"{test}.{name}", f"{test}.{quantity_name(name)}", name, quantity_name(name)


def _compare_test(
    test: str,
    ours: xr.Dataset,
    theirs: xr.Dataset,
    tolerances: Mapping[str, float | str],
    findings: list[Finding],
) -> list[dict[str, Any]]:
    unit = str(theirs["input"].attrs.get("units", "1"))
    inputs = same_inputs(ours, theirs)
    if inputs is None:
        other = str(ours["input"].attrs.get("units", "1"))
        findings.append(finding("kc.other_input", test, unit=unit, other=other))
        return []
    known = [np.isfinite(sweep) for sweep in inputs]
    shared = [str(name) for name in theirs.data_vars if name in ours]
    missing = [str(name) for name in theirs.data_vars if name not in ours]
    ours, theirs = (
        data[shared].assign_coords(input=("sample", sweep, {"units": unit})).isel(sample=good)
        for data, sweep, good in zip((ours, theirs), inputs, known, strict=True)
    )
    sweep, reached = _values(ours, "input"), _values(theirs, "input")
    low, high = (
        max(float(sweep.min()), float(reached.min())),
        min(float(sweep.max()), float(reached.max())),
    )
    if missing:
        findings.append(finding("kc.quantities_not_simulated", test, names=missing))
    if not high > low:
        findings.append(finding("kc.no_common_range", test))
        return [_not_judged(test, name, ours, unit) for name in shared]
    if any(_count(data, low, high) < _FEWEST for data in (sweep, reached)):
        sizes = [f"{float(np.ptp(data)):.3g} {unit}" for data in (reached, sweep)]
        numbers = {"measured": sizes[0], "simulated": sizes[1]}
        findings.append(finding("kc.ranges_differ", test, **numbers))
        return [_not_judged(test, name, ours, unit) for name in shared]
    if high - low < 0.98 * float(np.ptp(reached)):
        share = (high - low) / float(np.ptp(reached))
        findings.append(finding("kc.range_not_covered", test, share, share=share))
    fits = [kc_slopes(data[shared], within=(low, high)) for data in (ours, theirs)]
    grid = np.unique(np.append(np.linspace(low, high, _GRID), 0.0 if low <= 0.0 <= high else low))
    rows: list[dict[str, Any]] = []
    pairs: dict[str, _Pair] = {}
    for k, name in enumerate(shared):
        row = _not_judged(test, name, ours, unit) | {"low": low, "high": high}
        for side, fit in zip(("simulated", "measured"), fits, strict=True):
            row |= {
                f"{key}_{side}": float(fit[key][k])
                for key in ("slope", "nonlinearity", "hysteresis")
            }
        curves = [
            lines_of(x, _values(data, name), grid).mean
            for x, data in ((sweep, ours), (reached, theirs))
        ]
        allowed = _allowed(test, theirs[name], curves[1], tolerances)
        rows.append(row | _judge(grid, curves[0], curves[1], allowed))
        pairs[name] = grid, curves[0], curves[1], allowed
    findings += _mistakes(test, pairs)
    return rows


def _count(sweep: Array, low: float, high: float) -> int:
    """Return the number of different inputs in a range."""
    digits = 9 - int(np.floor(np.log10(high - low)))
    return len(np.unique(np.round(sweep[(sweep >= low) & (sweep <= high)], digits)))


def _mistakes(test: str, pairs: Mapping[str, _Pair]) -> Iterator[Finding]:
    """Yield findings for curves outside their tolerance that a usual mistake would bring within it."""
    wrong = {
        name: pair
        for name, pair in pairs.items()
        if _is_clear(pair) and not _agrees(pair[1], pair[2], pair)
    }
    mirrored = [name for name, pair in wrong.items() if _agrees(pair[1], -pair[2], pair)]
    if mirrored:
        yield finding("kc.opposite_sign", test, names=mirrored)
    exchanged = []
    for quantity in dict.fromkeys(map(quantity_name, wrong)):
        names = [f"{wheel}.{quantity}" for wheel in WHEELS]
        both = [pairs[name] for name in names if name in pairs]
        if len(both) == len(names) and not {*names} & {*mirrored}:
            swapped = zip(both, reversed(both), strict=True)
            if all(_agrees(own[1], other[2], other) for own, other in swapped):
                exchanged.append(quantity)
    if exchanged:
        yield finding("kc.other_wheel", test, names=exchanged)
    for factor in _FACTORS:
        names = [n for n, pair in wrong.items() if _agrees(pair[1], factor * pair[2], pair, factor)]
        if names:
            yield finding("kc.other_unit", test, factor, names=names, factor=factor)


def _is_clear(pair: _Pair) -> bool:
    """Whether the measured curve moves by several times its tolerance, so that its sign and size mean something."""
    known = pair[2][np.isfinite(pair[2])]
    return known.size > 0 and float(np.ptp(known)) > _CLEAR * pair[3]


def _agrees(ours: Array, theirs: Array, pair: _Pair, factor: float = 1.0) -> bool:
    return _judge(pair[0], ours, theirs, factor * pair[3]).get("verdict") == "within"


def same_inputs(ours: xr.Dataset, theirs: xr.Dataset) -> tuple[Array, Array] | None:
    """Return what both tests are compared over, in the unit of the measured input; None if the model has no value.

    Pads also deflect the tyre, which the model takes as rigid: travels of the wheel centre count if both have them.
    """
    made_of = str(theirs.attrs.get("input_quantity", ""))
    test, measured = str(theirs.attrs.get("test", "")), _values(theirs, "input")
    names = [f"{wheel}.wheel_centre_z" for wheel in WHEELS]
    present = [name for name in names if name in theirs and name in ours]
    if test == "bounce" and present:
        ours_z, theirs_z = (
            np.mean([_values(data, name) for name in present], axis=0) for data in (ours, theirs)
        )
        return ours_z, theirs_z
    track = ours.attrs.get("track", theirs.attrs.get("track"))
    if test == "roll" and len(present) == len(WHEELS) and track is not None:
        ours_roll, theirs_roll = (
            (_values(data, names[0]) - _values(data, names[1])) / float(track)
            for data in (ours, theirs)
        )
        return ours_roll, theirs_roll
    if made_of in ("rack_travel", "handwheel_angle") and made_of in ours:
        return _values(ours, made_of), measured
    if str(ours["input"].attrs.get("units", "1")) == str(theirs["input"].attrs.get("units", "1")):
        return _values(ours, "input"), measured
    return None


def _values(data: xr.Dataset, name: str) -> Array:
    return np.asarray(data.variables[name].values, dtype=float)


def _allowed(
    test: str, measured: xr.DataArray, curve: Array, tolerances: Mapping[str, float | str]
) -> float:
    """Return the tolerance of a quantity, in its unit."""
    unit, span = str(measured.attrs.get("units", "1")), float(np.nanmax(curve) - np.nanmin(curve))
    given = next((tolerances[k] for k in _keys(test, str(measured.name)) if k in tolerances), None)
    if given is None:
        noise = float(measured.attrs.get("noise", 0.0))
        return max(_SHARE * span + _NOISE * noise, READING.get(unit, 0.0))
    if isinstance(given, str) and given.strip().endswith("%"):
        share = to_si(given, "1", where=f"tolerances: {measured.name}")
        allowed = share * span
    else:
        allowed = to_si(given, unit, where=f"tolerances: {measured.name}")
    if allowed < 0.0:
        raise DescriptionError(
            "not a tolerance",
            where=f"tolerances: {measured.name}",
            found=given,
            allowed="0 or more",
        )
    return allowed


def _judge(grid: Array, ours: Array, theirs: Array, allowed: float) -> dict[str, Any]:
    """Compare two mean curves as changes from zero input, or from the input closest to it."""
    known = np.isfinite(ours) & np.isfinite(theirs)
    if not known.any():
        return {}
    zero = int(np.argmin(np.where(known, np.abs(grid), np.inf)))
    away = (ours - ours[zero]) - (theirs - theirs[zero])
    size = np.where(known, np.abs(away), 0.0)
    most = int(np.argmax(size))
    out = size > allowed
    leaves = float(grid[np.argmin(np.where(out, np.abs(grid), np.inf))]) if out.any() else np.nan
    return {
        "difference": float(size[most]),
        "difference_at": float(grid[most]),
        "tolerance": allowed,
        "leaves_at": leaves,
        "offset": float(ours[zero] - theirs[zero]),
        "verdict": "outside" if out.any() else "within",
    }


def _not_judged(test: str, name: str, ours: xr.Dataset, over: str) -> dict[str, Any]:
    unit = str(ours[name].attrs.get("units", "1"))
    return dict.fromkeys(_NUMBERS, np.nan) | {
        "test": test, "quantity": name, "unit": unit, "slope_unit": slope_unit(unit, over),
        "input_unit": over, "verdict": "not judged",
    }  # fmt: skip


def _table(rows: list[dict[str, Any]], findings: list[Finding]) -> xr.Dataset:
    import xarray as xr

    numbers = {
        name: ("row", np.array([row[name] for row in rows], dtype=float), {"long_name": label})
        for name, label in _NUMBERS.items()
    }
    texts = {
        name: ("row", np.array([row[name] for row in rows], dtype=str))
        for name in ("test", "quantity", "unit", "slope_unit", "input_unit", "verdict")
    }
    verdict = {"verdict": texts.pop("verdict")}
    return xr.Dataset({**numbers, **verdict}, texts, finding_attributes(findings))
