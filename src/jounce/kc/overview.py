"""Rows that a K&C laboratory prints first: characteristic slopes of each test, with the field's names and units."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.display import DisplayUnit, current_units
from jounce.core.errors import DescriptionError, unknown
from jounce.core.numbers import number
from jounce.core.serialise import Plain
from jounce.core.tables import TextTable
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.kc.centres import SUPPORTS
from jounce.kc.slopes import kc_slopes, slope_unit
from jounce.kc.tests import TESTS, KCTest

if TYPE_CHECKING:
    import xarray as xr

SIDES = ("left", "right")
Within = float | str | tuple[float | str, float | str]
_SHARE = 0.5
"""Default range of a fit: half of the test's."""
_FEWEST = 3  # inputs in that half; the whole range if there are fewer


@dataclass(frozen=True)
class Characteristic:
    """A row of the overview: the slope of a quantity over the input, or over another quantity.

    Attributes
    ----------
    name, label, positive : str
        Key, words and sign.
    quantity : str
        Quantity of each wheel (``toe``), or of the axle if it has a dot in front (``.rack_force``).
    over : str
        Quantity in place of the input, written likewise.
    at_end : bool
        Mean change to both ends of the range instead of a slope.
    """

    name: str
    label: str
    positive: str
    quantity: str
    over: str = ""
    at_end: bool = False


_TOE_IN, _TOP_OUT, _TOP_BACK = "toe-in", "top outward", "top rearward"
_LEFT_TURN, _FORWARD, _OUTWARD, _LEFT = "about +z", "forward", "outward", "to the left"
_ROLLING = "as in rolling forward"
C = Characteristic
_TOE = C("toe", "toe", _TOE_IN, "toe")
_CAMBER = C("camber", "camber", _TOP_OUT, "camber")
_WIND_UP = C("wind_up", "wind-up (spin)", _ROLLING, "spin")
_LATERAL = (
    _TOE,
    _CAMBER,
    C("wheel_centre_lateral", "lateral compliance, wheel centre", _LEFT, "wheel_centre_y"),
    C("contact_patch_lateral", "lateral compliance, contact patch", _LEFT, "contact_point_y"),
    C("rack_force", "force of the handwheel on the rack", _LEFT, ".rack_force"),
)
_LONGITUDINAL = (
    _TOE,
    _CAMBER,
    C("caster", "caster", _TOP_BACK, "caster"),
    _WIND_UP,
    C(
        "wheel_centre_longitudinal",
        "longitudinal compliance, wheel centre",
        _FORWARD,
        "wheel_centre_x",
    ),
    C(
        "contact_patch_longitudinal",
        "longitudinal compliance, contact patch",
        _FORWARD,
        "contact_point_x",
    ),
)
_ROWS: Mapping[str, tuple[Characteristic, ...]] = {
    "heights": (
        C("wheel_rate", "wheel rate at the contact patch", "up", "vertical_force"),
        C("ride_steer", "ride steer (bump toe)", _TOE_IN, "toe"),
        C("ride_camber", "ride camber", _TOP_OUT, "camber"),
        C("ride_caster", "ride caster", _TOP_BACK, "caster"),
        C("wheel_recession", "wheel recession, wheel centre", _FORWARD, "wheel_centre_x"),
        C("half_track_change", "half-track change", _OUTWARD, "half_track"),
        C("ride_wind_up", "wind-up (spin)", _ROLLING, "spin"),
    ),
    "roll": (
        C("roll_stiffness", "roll stiffness", "against the roll", ".roll_moment"),
        C("roll_steer", "roll steer", _LEFT_TURN, "steer"),
        C("roll_camber", "roll camber, to the body", _TOP_OUT, "camber"),
        C("roll_camber_ground", "roll camber, to the ground", _TOP_OUT, "camber_to_ground"),
        C("load_transfer", "load transfer", "up", "vertical_force"),
    ),
    "rack": (
        C("steering_ratio", "steering ratio, handwheel over wheels", "same sense", ".handwheel_angle", ".mean_steer"),
        C("rack_to_wheel", "steer of the wheel", _LEFT_TURN, "steer"),
        C("toe_difference", "Ackermann: toe-out of both wheels at full rack",
            "inner wheel steers more", ".toe_out", at_end=True),
        C("camber_over_steer", "camber over steer", _TOP_OUT, "camber", "steer"),
        C("caster_over_steer", "caster over steer", _TOP_BACK, "caster", "steer"),
        C("rack_effort", "force of the handwheel on the rack", _LEFT, ".rack_force"),
        C("handwheel_effort", "handwheel torque over angle", _LEFT, ".handwheel_torque", ".handwheel_angle"),
    ),
    "lateral": _LATERAL,
    "longitudinal": _LONGITUDINAL,
    "aligning": (
        _TOE,
        C("steer", "steer", _LEFT_TURN, "steer"),
        *_LATERAL[1:],
    ),
}  # fmt: skip


@dataclass(frozen=True)
class OverviewRow(Plain):
    """One row of an overview, SI.

    Attributes
    ----------
    test, name, label, positive : str
        Test, key, words, and the meaning of a positive value.
    unit : str
        SI unit of the values.
    left, right, axle : float or None
        Values of the wheels, or of the axle.
    kinematic : float or None
        The same with ideal joints, for roll centre and support angles.
    nonlinearity, hysteresis : float or None
        Largest of both wheels, as shares; see :func:`jounce.kc_slopes`.
    low, high : float or None
        Range of the input that was fitted, in ``input_unit``.
    own_unit, input_unit : str
        SI units of the quantity and of what it is divided by; the latter is empty for plain values.
    """

    test: str
    name: str
    label: str
    positive: str
    unit: str
    left: float | None = None
    right: float | None = None
    axle: float | None = None
    kinematic: float | None = None
    nonlinearity: float | None = None
    hysteresis: float | None = None
    low: float | None = None
    high: float | None = None
    own_unit: str = "1"
    input_unit: str = ""

    def values(self) -> tuple[float | None, ...]:
        """Return left, right, axle and kinematic value."""
        return self.left, self.right, self.axle, self.kinematic

    def usual(self) -> DisplayUnit:
        """Return the unit in which laboratories write it."""
        is_rack = TESTS[self.test].kind == "rack"
        return usual_unit(self.own_unit, self.input_unit, per_mm=is_rack or self.own_unit == "N")


@dataclass(frozen=True)
class KcOverview(Plain):
    """Overview of K&C tests.

    Attributes
    ----------
    rows : tuple of OverviewRow
        In the order of the sheet.
    """

    rows: tuple[OverviewRow, ...]

    def __iter__(self) -> Iterator[OverviewRow]:
        return iter(self.rows)

    def __len__(self) -> int:
        return len(self.rows)

    def __str__(self) -> str:
        header = ("test", "quantity", "unit", "left", "right", "axle")
        rows = [
            (
                row.test,
                row.label,
                row.usual().name,
                *(usual_text(value, row.usual()) for value in row.values()[:3]),
            )
            for row in self.rows
        ]
        return str(TextTable("K&C overview", header, rows, (0, 1, 2)))

    def row(self, test: str, name: str) -> OverviewRow:
        """Look up the characteristic of a test by its key.

        Parameters
        ----------
        test, name : str
            Test and key of the row.

        Returns
        -------
        OverviewRow
            SI.

        Raises
        ------
        DescriptionError
            If there is none.

        Examples
        --------
        >>> import jounce as jn
        >>> tests = jn.kc_tests(jn.load("semi-trailing-arm"), ("bounce",))
        >>> round(1e-3 * jn.kc_overview(tests).row("bounce", "wheel_rate").left, 1)         # N/mm
        21.4
        """
        known = {(item.test, item.name): item for item in self.rows}
        if (test, name) not in known:
            raise unknown(
                f"{test}.{name}", [".".join(key) for key in known], what="row", where="row"
            )
        return known[test, name]

    def table(self) -> str:
        """Return all rows as CSV: usual units, then the same in SI."""
        stream = io.StringIO()
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(CSV_HEADER)
        writer.writerows(self.cells())
        return stream.getvalue()

    def cells(self) -> list[list[str | float]]:
        """Return all rows as cells under `CSV_HEADER`."""
        return [_cells(row) for row in self.rows]


CSV_HEADER = (
    "test", "quantity", "positive", "unit", "left", "right", "axle", "kinematic", "nonlinearity [%]", "hysteresis [%]",
    "from", "to", "of input [SI]", "key", "SI unit", "left [SI]", "right [SI]", "axle [SI]", "kinematic [SI]",
)  # fmt: skip


def _cells(row: OverviewRow) -> list[str | float]:
    unit = row.usual()
    plain = [_known(value) for value in row.values()]
    shown = [value if value == "" else float(value) * unit.factor for value in plain]
    shares = [
        value if value == "" else 100.0 * float(value)
        for value in (_known(row.nonlinearity), _known(row.hysteresis))
    ]
    ends = [_known(row.low), _known(row.high), TESTS[row.test].unit if row.low is not None else ""]
    return [
        row.test,
        row.label,
        row.positive,
        unit.name,
        *shown,
        *shares,
        *ends,
        row.name,
        row.unit,
        *plain,
    ]


def _known(value: float | None) -> float | str:
    return "" if value is None or not math.isfinite(value) else value


# units ----------------------------------------------------------------------------------------------------------------


_DEG = 180.0 / math.pi
_LBF, _INCH = 4.4482216152605, 0.0254
_ABOVE = {
    "metric": {"rad": ("deg", _DEG), "m": ("mm", 1e3), "N": ("N", 1.0), "N*m": ("N·m", 1.0)},
    "imperial": {
        "rad": ("deg", _DEG),
        "m": ("in", 1.0 / _INCH),
        "N": ("lbf", 1.0 / _LBF),
        "N*m": ("lbf·ft", 1.0 / (12.0 * _INCH * _LBF)),
    },
}
_BELOW = {
    "metric": {
        "rad": ("deg", _DEG),
        "m": ("m", 1.0),
        "N": ("kN", 1e-3),
        "N*m": ("(100 N·m)", 1e-2),
    },
    "imperial": {
        "rad": ("deg", _DEG),
        "m": ("in", 1.0 / _INCH),
        "N": ("klbf", 1e-3 / _LBF),
        "N*m": ("(100 lbf·ft)", 1e-2 / (12.0 * _INCH * _LBF)),
    },
}


def usual_unit(own: str, over: str = "", *, per_mm: bool = False) -> DisplayUnit:
    """Return the unit in which laboratories write a quantity, or its slope over another.

    >>> usual_unit("rad", "N").name, usual_unit("N", "m", per_mm=True).name, usual_unit("rad", "m").name
    ('deg/kN', 'N/mm', 'deg/m')
    """
    system = current_units()
    name, factor = _ABOVE[system].get(own, (own, 1.0))
    if not over:
        return DisplayUnit(name, factor)
    under, divisor = _BELOW[system].get(over, (over, 1.0))
    if per_mm and under == "m":
        under, divisor = "mm", 1e3
    return DisplayUnit(f"{name}/{under}", factor / divisor)


def usual_text(value: float | None, unit: DisplayUnit) -> str:
    """Write a value in its unit; rounding residues as zero, nothing for what the row does not have."""
    if value is None:
        return ""
    if not math.isfinite(value):
        return "–"
    shown = value * unit.factor
    return number(0.0 if abs(shown) < _LEAST else shown)


_LEAST = 5e-7
"""Smallest number shown, in usual units."""


# rows -----------------------------------------------------------------------------------------------------------------


def kc_overview(
    tests: Mapping[str, xr.Dataset],
    centres: xr.Dataset | None = None,
    *,
    within: Mapping[str, Within] | None = None,
) -> KcOverview:
    """Return the characteristic rows of K&C tests, as laboratories print them first.

    Parameters
    ----------
    tests : mapping of str to xarray.Dataset
        Tests by name, simulated or measured: see :func:`jounce.kc_tests`.
    centres : xarray.Dataset, optional
        Adds roll centre height and support angles: see :func:`jounce.kc_centres`.
    within : mapping, optional
        Range of the fit by test, about zero: ``{"bounce": "20 mm", "roll": ("-1 deg", "1 deg")}``. By default half of
        the range of each test.

    Returns
    -------
    KcOverview
        Rows with values of left and right wheel or of the axle (SI), range, nonlinearity and hysteresis. Rows whose
        quantities a test does not have are left out. Signs: toe-in, camber with the top outward, caster with the top
        rearward, displacements forward, left and outward, spin as in rolling forward are positive.

    Raises
    ------
    DescriptionError
        If a range is given for a test that is not there, or contains fewer than two inputs.

    Examples
    --------
    >>> import jounce as jn
    >>> tests = jn.kc_tests(jn.load("generic-mcpherson"), ("bounce", "roll"))
    >>> row = jn.kc_overview(tests, within={"bounce": "20 mm"}).row("bounce", "ride_camber")
    >>> row.usual().name, row.low, row.high, row.left == row.right
    ('deg/m', -0.02, 0.02, True)
    """
    for name in within or {}:
        if name not in tests:
            raise unknown(name, tests, what="test", where="within")
    rows: list[OverviewRow] = []
    for name, dataset in tests.items():
        kind = TESTS.get(name)
        if kind is not None:
            rows += _rows_of(kind, dataset, fitted_range(dataset, (within or {}).get(name)))
            rows += [] if centres is None else _centre_rows(kind, centres)
    return KcOverview(tuple(rows))


def fitted_range(dataset: xr.Dataset, within: Within | None = None) -> tuple[float, float]:
    """Return the ends of the range of a fit, SI: those given, or half of the test's range."""
    sweep = np.asarray(dataset["input"].values, dtype=float)
    return range_of_line(sweep, str(dataset["input"].attrs.get("units", "1")), within)


def range_of_line(sweep: Array, unit: str, within: Within | None = None) -> tuple[float, float]:
    """Return the ends of the range of a line over inputs, SI: those given, or half of the inputs' range.

    >>> range_of_line(np.linspace(-0.05, 0.05, 41), "m"), range_of_line(np.linspace(0.0, 8.0, 9), "N", "2 N")
    ((-0.025, 0.025), (0.0, 2.0))
    """
    if within is None:
        low, high = float(np.nanmin(sweep)), float(np.nanmax(sweep))
        inside = np.unique(sweep[(sweep >= _SHARE * low) & (sweep <= _SHARE * high)])
        share = _SHARE if inside.size >= _FEWEST else 1.0
        return share * low, share * high
    if isinstance(within, tuple):
        if len(within) != 2:
            raise DescriptionError(
                "not a range", where="within", found=str(within), allowed="two ends"
            )
        return to_si(within[0], unit, where="within"), to_si(within[1], unit, where="within")
    half = to_si(within, unit, where="within")
    return (0.0, half) if sweep.min() >= 0.0 else (-half, half)


def _rows_of(test: KCTest, dataset: xr.Dataset, ends: tuple[float, float]) -> Iterator[OverviewRow]:
    whole = with_derived(dataset)
    rows = [
        row
        for row in _ROWS[test.kind]
        if not (row.name == "rack_force" and sum(test.shares) == 0.0)
    ]
    asked = {_variable(row.quantity, place) for row in rows for place in ("axle", *SIDES)}
    asked &= set(map(str, whole.data_vars))

    @cache
    def fits(over: str) -> Any:
        swept = whole if not over else _over(whole, over)
        if swept is None:
            return None
        low, high = ends if not over else _ends_over(whole, over, ends)
        return kc_slopes(swept[sorted(asked)], within=(low, high)).set_index(quantity="quantity")

    for row in rows:
        found: dict[str, float] = {}
        shares: list[tuple[float, float]] = []
        own = over = ""
        places = ("axle",) if row.quantity.startswith(".") else SIDES
        for place in places:
            variable = _variable(row.quantity, place)
            if variable not in whole:
                continue
            own = str(whole[variable].attrs["units"])
            if row.at_end:
                found[place] = _at_ends(whole, variable)
                continue
            fit = fits(_variable(row.over, place) if row.over else "")
            if fit is None:
                continue
            over = str(fit.attrs["input_unit"])
            fit = fit.sel(quantity=variable)
            found[place] = float(fit["slope"])
            shares.append((float(fit["nonlinearity"]), float(fit["hysteresis"])))
        if not found:
            continue
        low, high = (None, None) if row.at_end else ends
        nonlinearity, hysteresis = (_largest([pair[k] for pair in shares]) for k in (0, 1))
        yield OverviewRow(
            test.name, row.name, row.label, row.positive, slope_unit(own, over) if over else own, found.get("left"),
            found.get("right"), found.get("axle"), None, nonlinearity, hysteresis, low, high, own, over,
        )  # fmt: skip


def _variable(quantity: str, place: str) -> str:
    return quantity[1:] if quantity.startswith(".") else f"{place}.{quantity}"


def _largest(values: list[float]) -> float | None:
    known = [value for value in values if math.isfinite(value)]
    return max(known) if known else None


def _over(dataset: xr.Dataset, name: str) -> xr.Dataset | None:
    """Return a test with another quantity as its input; None if the test does not have it."""
    if name not in dataset:
        return None
    values = dataset[name]
    known = dataset.isel(sample=np.isfinite(np.asarray(values.values)))
    return known.assign_coords(input=("sample", known[name].values, dict(values.attrs)))


def _ends_over(dataset: xr.Dataset, name: str, ends: tuple[float, float]) -> tuple[float, float]:
    """Return the range of another quantity that belongs to a range of the input."""
    sweep = np.asarray(dataset["input"].values)
    values = np.asarray(dataset[name].values)
    inside = (sweep >= ends[0] - 1e-12) & (sweep <= ends[1] + 1e-12) & np.isfinite(values)
    return (float(values[inside].min()), float(values[inside].max())) if inside.any() else ends


def _at_ends(dataset: xr.Dataset, name: str) -> float:
    """Return the mean change of a quantity from zero input to both ends of the range."""
    sweep, values = np.asarray(dataset["input"].values), np.asarray(dataset[name].values)
    at = [int(np.argmin(sweep)), int(np.argmax(sweep))]
    return float(values[at].mean() - values[int(np.argmin(np.abs(sweep)))])


def with_derived(dataset: xr.Dataset) -> xr.Dataset:
    """Add what follows from the quantities of a test: half track, camber to the ground, roll moment, handwheel."""
    added: dict[str, tuple[Any, str, str]] = {}
    sweep = dataset["input"]
    test, track = str(dataset.attrs.get("test", "")), dataset.attrs.get("track")
    for side, sign in zip(SIDES, (1.0, -1.0), strict=True):
        if f"{side}.contact_point_y" in dataset:
            half = sign * dataset[f"{side}.contact_point_y"].values
            added[f"{side}.half_track"] = (half, "m", "outward movement of the contact point")
        if test == "roll" and f"{side}.camber" in dataset:
            ground = dataset[f"{side}.camber"].values + sign * sweep.values
            added[f"{side}.camber_to_ground"] = (ground, "rad", "camber angle to the ground")
    if track is not None and all(f"{side}.vertical_force" in dataset for side in SIDES):
        left, right = (dataset[f"{side}.vertical_force"].values for side in SIDES)
        wide = float(track)
        if all(f"{side}.half_track" in added for side in SIDES):
            wide = wide + sum(added[f"{side}.half_track"][0] for side in SIDES)
        added["roll_moment"] = (
            0.5 * wide * (left - right),
            "N*m",
            "roll moment of the wheel loads",
        )
    if all(f"{side}.steer" in dataset for side in SIDES):
        left, right = (dataset[f"{side}.steer"].values for side in SIDES)
        added["mean_steer"] = (0.5 * (left + right), "rad", "mean steer angle of both wheels")
        added["toe_out"] = (left - right, "rad", "toe-out of both wheels")
    return dataset.assign(
        {
            name: ("sample", values, {"units": unit, "long_name": label})
            for name, (values, unit, label) in added.items()
            if name not in dataset
        }
    )


def _centre_rows(test: KCTest, centres: xr.Dataset) -> Iterator[OverviewRow]:
    """Yield roll centre height or support angle of a test, by forces and with ideal joints."""
    if test.name == "lateral-in-phase":
        yield _centre_row(
            test.name,
            "roll_centre_height",
            "roll centre height, force-based",
            "above the road",
            centres,
        )
    elif test.name in SUPPORTS:
        yield _centre_row(
            test.name,
            "support_angle",
            "support angle, force-based",
            "links lift the body",
            centres,
            test.name,
        )


def _centre_row(
    test: str, name: str, label: str, positive: str, centres: xr.Dataset, variable: str = ""
) -> OverviewRow:
    values = centres[variable or name]
    unit = str(values.attrs["units"])
    forces, kinematics = (float(values.sel(source=source)) for source in ("forces", "kinematics"))
    return OverviewRow(
        test, name, label, positive, unit, axle=forces, kinematic=kinematics, own_unit=unit
    )
