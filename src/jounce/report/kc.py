"""Sheet of a K&C laboratory: overview first, then a page for each test with input, curves, fitted lines and slopes."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.display import DisplayUnit, display_unit
from jounce.core.findings import findings_of
from jounce.core.numbers import number
from jounce.kc.overview import (
    SIDES,
    OverviewRow,
    fitted_range,
    usual_text,
    usual_unit,
    with_derived,
)
from jounce.kc.slopes import kc_slopes
from jounce.kc.tests import TESTS, KCTest
from jounce.parts import Corner
from jounce.plots.display import settle
from jounce.report.chart import Chart, Panel, Series, Style
from jounce.report.kc_drawing import axle_drawing
from jounce.report.page import (
    Block,
    Cell,
    Findings,
    Page,
    PageTable,
    Paragraph,
    Section,
    findings_blocks,
)

if TYPE_CHECKING:
    import xarray as xr

    from jounce.kc.sheet import KcTests

_MANY = 6
_CLOSED = 1e-3  # opening of a loop, of its range, below which it is drawn as a line
_WIDTH, _HEIGHT = 300, 210
_PANELS = {
    "heights": ("toe", "camber", "caster", "half_track", "wheel_centre_x", "vertical_force", "spin"),
    "roll": ("steer", "camber", "camber_to_ground", "half_track", "vertical_force", ".roll_moment", "spin"),
    "rack": ("steer", "camber", "caster", ".toe_out", "vertical_force", ".rack_force", "contact_point_y"),
    "lateral": ("toe", "camber", "wheel_centre_y", "contact_point_y", "spin", ".rack_force", "vertical_force"),
    "longitudinal": ("toe", "camber", "caster", "spin", "wheel_centre_x", "contact_point_x", ".rack_force"),
    "aligning": ("toe", "camber", "steer", "wheel_centre_y", "contact_point_y", ".rack_force", "spin"),
}  # fmt: skip
"""Curves of a test, the first that move; a dot marks those of the axle."""
_WHEELS: dict[str, tuple[str, Style]] = {"left": ("after", "line"), "right": ("other-5", "dashed")}
_NAMES = {"half_track": "half-track change", "spin": "wind-up (spin)"}


def kc_page(run: KcTests, *, title: str) -> Page:
    """Create the sheet: overview, a page for each test, the axle, and conditions."""
    sections = [Section("Overview", tuple(_overview(run)))]
    sections += [
        Section(_heading(name), partial(_test_blocks, run, name), own_page=True)
        for name in run.tests
    ]
    if isinstance(run.rig, Corner):
        sections.append(Section("Axle", partial(_axle, run.rig, title), own_page=True))
    sections.append(Section("Conditions", (_conditions(run),)))
    return Page(title, tuple(sections), "Kinematics and compliance")


def kc_summary(run: KcTests, *, title: str) -> Page:
    """Create the page that a terminal shows: the overview."""
    return Page(title, (Section("Overview", tuple(_overview(run))),), "Kinematics and compliance")


def _heading(test: str) -> str:
    """Return the heading of a test.

    >>> _heading("lateral-in-phase")
    'Lateral, in phase'
    """
    first, _, rest = test.partition("-")
    words = f"{first}, {rest.replace('-', ' ')}" if rest else first
    return words[:1].upper() + words[1:]


# overview -------------------------------------------------------------------------------------------------------------


def _overview(run: KcTests) -> list[Block]:
    blocks: list[Block] = []
    if run.compared is not None:
        blocks += [
            Paragraph(_verdict(run.compared)),
            _compared_tests(run.compared),
        ]
    rows, before = [], ""
    for row in run.overview:
        unit = row.usual()
        cells = [usual_text(value, unit) for value in row.values()]
        rows.append(
            (_heading(row.test) if row.test != before else "", row.label, unit.name, *cells)
        )
        before = row.test
    header = ("test", "quantity", "unit", "left", "right", "axle", "ideal joints")
    note = (
        "Slopes over half of each test's range, unless stated otherwise. Toe-in, camber with the top outward, caster "
        "with the top rearward, displacements forward, left and outward, spin as in rolling forward are positive; a "
        "support angle if the links lift the body (anti-dive, anti-squat; anti-lift is negative)."
    )
    table = PageTable("Characteristics", header, tuple(rows), "lllrrrr", note)
    serious = [item for item in run.findings if item.severity != "note"]
    notes = [item for item in run.findings if item.severity == "note"]
    return [*blocks, *findings_blocks(serious), table, *findings_blocks(notes)]


def _verdict(compared: xr.Dataset) -> str:
    verdicts = [str(value) for value in compared["verdict"].values]
    outside = verdicts.count("outside")
    judged = len(verdicts) - verdicts.count("not judged")
    if not judged:
        return "No measured curve could be judged."
    return (
        f"{judged - outside} of {judged} measured curves are within their tolerance of the model."
    )


def _compared_tests(compared: xr.Dataset) -> PageTable:
    """Return a row for each measured test: how many curves agree, and which is furthest from the model."""
    rows: list[tuple[Cell | str, ...]] = []
    tests = [str(name) for name in compared["test"].values]
    for test in dict.fromkeys(tests):
        own = compared.isel(row=[name == test for name in tests])
        judged = own.isel(row=own["verdict"].values != "not judged")
        inside = int((judged["verdict"].values == "within").sum())
        count = f"{judged.sizes['row']}" if judged.sizes["row"] else "not judged"
        agreed = Cell(f"{inside}", "good" if inside == judged.sizes["row"] else "bad")
        furthest: tuple[Cell | str, ...] = ("", "", "", "")
        if judged.sizes["row"]:
            shares = judged["difference"].values / judged["tolerance"].values
            furthest = _judged(judged.isel(row=int(np.argmax(shares))))
        rows.append((_heading(test), count, agreed if judged.sizes["row"] else "", *furthest))
    header = (
        "test", "curves", "within", "furthest from the model", "largest difference", "allowed", "leaves it at",
    )  # fmt: skip
    return PageTable("Model and measurement", header, tuple(rows), "lrrlrrr")


def _comparison(compared: xr.Dataset) -> PageTable:
    """Return the verdict on each measured curve of a test, those outside first."""
    order = {"outside": 0, "within": 1}
    verdicts = [str(value) for value in compared["verdict"].values]
    places = sorted(range(len(verdicts)), key=lambda k: order.get(verdicts[k], 2))
    rows: list[tuple[Cell | str, ...]] = []
    for k in places:
        item = compared.isel(row=k)
        test = str(item["test"].values)
        slope = _slope_unit(test, str(item["unit"].values), _unit_of_input(test))
        slopes = [
            usual_text(float(item[f"slope_{side}"]), slope) for side in ("simulated", "measured")
        ]
        tone = {"outside": "bad", "within": "good"}.get(verdicts[k], "muted")
        quantity, difference, tolerance, leaves_at = _judged(item)
        verdict = Cell(verdicts[k], tone)  # type: ignore[arg-type]
        rows.append((quantity, slope.name, *slopes, difference, tolerance, verdict, leaves_at))
    header = (
        "quantity", "unit", "model", "measured", "largest difference", "allowed", "verdict", "leaves it at",
    )  # fmt: skip
    return PageTable("Model and measurement", header, tuple(rows), "llrrrrlr")


def _judged(item: xr.Dataset) -> tuple[str, str, str, str]:
    """Write quantity, largest difference, tolerance, and the input at which a curve leaves it."""
    own = usual_unit(str(item["unit"].values))
    difference, tolerance = (
        f"{usual_text(float(item[name]), own)} {own.name}" for name in ("difference", "tolerance")
    )
    is_outside = str(item["verdict"].values) == "outside"
    unit = _input_unit(_unit_of_input(str(item["test"].values)))
    leaves_at = _at(float(item["leaves_at"]), unit) if is_outside else ""
    return _words(str(item["quantity"].values)), difference, tolerance, leaves_at


def _unit_of_input(test: str) -> str:
    return TESTS[test].unit if test in TESTS else ""


def _slope_unit(test: str, unit: str, input_unit: str) -> DisplayUnit:
    return OverviewRow(test, "", "", "", "", own_unit=unit, input_unit=input_unit).usual()


def _at(value: float, unit: DisplayUnit) -> str:
    return "" if not np.isfinite(value) else f"{number(value * unit.factor)} {unit.name}"


def _words(variable: str) -> str:
    """Write a variable in words.

    >>> _words("left.contact_point_y"), _words("rack_force")
    ('left, contact point y', 'rack force')
    """
    side, _, quantity = variable.partition(".")
    words = _NAMES.get(quantity or side, (quantity or side).replace("_", " ").replace(".", ", "))
    return f"{side}, {words}" if quantity else words


# tests ----------------------------------------------------------------------------------------------------------------


def _input_unit(unit: str) -> DisplayUnit:
    return (
        DisplayUnit("kN", 1e-3)
        if unit == "N" and display_unit("m").name == "mm"
        else display_unit(unit)
    )


def _range(low: float, high: float, unit: DisplayUnit) -> str:
    return f"{_plain(low * unit.factor)} to {_plain(high * unit.factor)} {unit.name}"


def _plain(value: float) -> str:
    return f"{value + 0.0:.4g}".replace("-", "−")


def _test_blocks(run: KcTests, name: str) -> tuple[Block, ...]:
    test, dataset = TESTS[name], with_derived(run.tests[name])
    unit = _input_unit(test.unit)
    sweep = np.asarray(dataset["input"].values)
    rows = [row for row in run.overview if row.test == name]
    low, high = next(
        ((row.low, row.high) for row in rows if row.low is not None and row.high is not None),
        fitted_range(dataset),
    )
    text = (
        f"Input: {test.what}, {_range(float(sweep.min()), float(sweep.max()), unit)}; positive: {test.positive}. "
        f"{len(sweep)} samples. Lines are fitted from {_range(low, high, unit)}."
    )
    blocks: list[Block] = [Paragraph(text)]
    drawing = axle_drawing(run.rig, test)
    if drawing is not None:
        words = f"Positive input: {test.positive}."
        blocks.append(Chart((drawing,), f"input-{name}", words, words))
    measured = run.measured.get(name)
    beside = None if measured is None else with_derived(measured)
    curves = _curves(test, dataset, (low, high), beside)
    blocks += [curves] if curves.panels else []
    blocks.append(_slopes(rows))
    if run.compared is not None:
        own = np.flatnonzero(run.compared["test"].values == name)
        if own.size:
            blocks.append(_comparison(run.compared.isel(row=own)))
    findings = (
        *findings_of(run.tests[name].attrs),
        *(findings_of(measured.attrs) if measured is not None else ()),
    )
    if findings:
        blocks.append(Findings(tuple(findings)))
    return tuple(blocks)


def _slopes(rows: list[OverviewRow]) -> PageTable:
    cells = [
        (
            row.label,
            row.usual().name,
            *(usual_text(value, row.usual()) for value in row.values()),
            _share(row.nonlinearity),
            _share(row.hysteresis),
            row.positive,
        )
        for row in rows
    ]
    header = (
        "quantity", "unit", "left", "right", "axle", "ideal joints", "nonlinearity [%]", "hysteresis [%]", "positive",
    )  # fmt: skip
    note = "Shares of the range. Nonlinearity: distance of the curve from the line; hysteresis: opening of the loop."
    kept = [k for k in range(len(header)) if k == 0 or any(row[k] for row in cells)]
    return PageTable(
        "Slopes",
        tuple(header[k] for k in kept),
        tuple(tuple(row[k] for k in kept) for row in cells),
        "".join("llrrrrrrl"[k] for k in kept),
        note,
    )


def _share(value: float | None) -> str:
    return "" if value is None else number(0.0 if value < 5e-5 else 100.0 * value)


def _curves(
    test: KCTest, dataset: xr.Dataset, ends: tuple[float, float], measured: xr.Dataset | None
) -> Chart:
    """Return the curves of both wheels with fitted lines, and those of a measured sheet."""
    unit = _input_unit(test.unit)
    shown: list[tuple[str, list[str]]] = []
    for quantity in _PANELS[test.kind]:
        names = (
            [quantity[1:]] if quantity.startswith(".") else [f"{side}.{quantity}" for side in SIDES]
        )
        names = [name for name in names if name in dataset]
        if names and any(_extent(_settled(dataset[name])) > 0.0 for name in names):
            shown.append((quantity.lstrip("."), names))
    shown = shown[:_MANY]
    every = [name for _, names in shown for name in names]
    fits = kc_slopes(dataset[every], within=ends).set_index(quantity="quantity") if every else None
    panels = []
    for k, (quantity, names) in enumerate(shown):
        own = usual_unit(str(dataset[names[0]].attrs["units"]))
        series: list[Series] = []
        for name in names:
            side = name.partition(".")[0] if "." in name else "axle"
            role, style = _WHEELS.get(side, ("after", "line"))
            x, y = _drawn(np.asarray(dataset["input"].values), _settled(dataset[name]))
            label = side if k == 0 else ""
            series.append(Series(x * unit.factor, y * own.factor, role, style, label))
            if measured is not None and name in measured:
                at = np.asarray(measured["input"].values) * unit.factor
                values = np.asarray(measured[name].values) * own.factor
                label = f"{side}, measured" if k == 0 else ""
                series.append(
                    Series(at, values, role, "rings" if side != "right" else "crosses", label)
                )
        for name in names if quantity != "toe_out" else ():
            assert fits is not None
            fit = fits.sel(quantity=name)
            line = np.array(ends)
            values = float(fit["intercept"]) + float(fit["slope"]) * line
            label = "fitted line" if k == 0 and name == names[0] else ""
            series.append(
                Series(line * unit.factor, values * own.factor, "measured", "dotted", label)
            )
        panels.append(
            Panel(
                tuple(series),
                unit.label("input") if k >= len(shown) - 3 else "",
                title=f"{_words(quantity)} [{own.name}]",
                bands=((ends[0] * unit.factor, ends[1] * unit.factor, ""),),
                width=_WIDTH,
                height=_HEIGHT + (16 if k >= len(shown) - 3 else 0),
            )
        )
    words = "Left (solid) and right wheel (dashed), lines fitted over the shaded range (dotted)."
    if measured is not None:
        words = f"{words} Rings and crosses: measured, left and right."
    return Chart(tuple(panels), f"curves-{test.name}", words, words, columns=3)


def _drawn(sweep: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return a curve as it is drawn: as a loop, or once if its branches agree, so that dashes stay dashes."""
    x, first, back = np.unique(sweep, return_index=True, return_inverse=True)
    opening = np.nanmax(np.abs(values - values[first][back]), initial=0.0)
    closed = opening <= _CLOSED * _extent(values)
    return (x, values[first]) if closed else (sweep, values)


def _extent(values: np.ndarray) -> float:
    known = values[np.isfinite(values)]
    return float(np.ptp(known)) if known.size else 0.0


def _settled(variable: xr.DataArray) -> np.ndarray:
    values = np.asarray(variable.values, dtype=float)
    start = values[0] if np.isfinite(values[0]) else 0.0
    return settle(values - start, str(variable.attrs["units"])) + start


# axle and conditions --------------------------------------------------------------------------------------------------


def _axle(rig: Corner, title: str) -> tuple[Block, ...]:
    from jounce.report.swept import hardpoints_table, mechanism_picture

    return mechanism_picture(rig, title), hardpoints_table(rig)


def _conditions(run: KcTests) -> PageTable:
    import jounce

    first = next(iter(run.tests.values()))
    length = display_unit("m")
    rows = [
        ("model", str(getattr(run.rig, "model", ""))),
        ("distance of the contact points", f"{number(float(first.attrs['track']) * length.factor)} {length.name}"),
        *((name.replace("_", " "), value) for name, value in run.settings.items()),
        ("body", "held at design height"),
        ("axes", str(first.attrs.get("convention", ""))),
        ("computed with", f"jounce {jounce.__version__}"),
    ]  # fmt: skip
    return PageTable("Conditions of all tests", ("setting", "value"), tuple(rows), "ll")
