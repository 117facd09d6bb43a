"""Figures of inspections: curves of a test, history of a vehicle, and comparison of three test methods."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from datetime import date, timedelta
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.types import Array
from jounce.inspection.sweep import turns_of_sweep
from jounce.plots.figures import MUTED, PALETTE, in_style, legend_above, new_figure

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.inspection.archive.history import WheelVisit
    from jounce.inspection.archive.questions import VehicleHistory
    from jounce.inspection.equivalence import Equivalence, Factor
    from jounce.inspection.result import Inspection, WheelResult


_LOOKS = {"left": (PALETTE[0], "-"), "right": (PALETTE[1], (0, (4, 1.5)))}
_BAND = (6.0, 18.0)  # Hz, for the phase angle: EGEA SPECSUS2018
_ENVELOPE = 400  # bins of a force over time; finer than the resolution of paper
_EMPTY_HEIGHT = 0.5  # inches
_WORDS = {
    "en": {
        "left": "left", "right": "right", "frequency": "frequency [Hz]", "time": "time [s]",
        "amplitude": "Force amplitude [kN]", "phase": "Phase angle [°]", "plate": "Plate amplitude [mm]",
        "force": "Plate force [kN]", "height": "Plate height [mm]", "limit": "limit",
        "passes": "passes from here", "fails": "fails below", "static": "static load",
        "nothing": "no curves available",
    },
    "de": {
        "left": "links", "right": "rechts", "frequency": "Frequenz [Hz]", "time": "Zeit [s]",
        "amplitude": "Kraftamplitude [kN]", "phase": "Phasenwinkel [°]", "plate": "Plattenamplitude [mm]",
        "force": "Plattenkraft [kN]", "height": "Plattenhub [mm]", "limit": "Grenzwert",
        "passes": "bestanden ab hier", "fails": "darunter nicht bestanden", "static": "statische Last",
        "nothing": "keine Kurven vorhanden",
    },
}  # fmt: skip


@in_style
def inspection_curves(
    inspection: Inspection,
    record: xr.Dataset | None = None,
    *,
    language: str = "en",
    phase_limit: float | None = None,
    phase_failure: float | None = None,
    height: float = 1.9,
    width: float = 8.6,
) -> Figure:
    """Draw the curves of the left and right wheel of an axle; ``height`` and ``width`` are in inches.

    For a rigid plate, force amplitude and phase angle are drawn over frequency, with the limit (degrees) from which the
    minimum phase angle passes and, if different, the limit below which it fails. For a sprung plate, its amplitude is
    drawn; with a record, also the plate force (N) over time (s). Wheels without curves are omitted; labels are in
    English or German.

    Examples
    --------
    >>> from jounce.inspection import Inspection, WheelCurves, WheelResult
    >>> f = np.linspace(25.0, 3.0, 50)
    >>> curves = WheelCurves(f, f, 4e3 - 9.0 * f, 4e3 + 9.0 * f, 180.0 - f, 0.0 * f + 3e-3)
    >>> figure = inspection_curves(Inspection((WheelResult("left", static_load=4e3, curves=curves),)))
    >>> [axes.get_title(loc="left") for axes in figure.axes]
    ['Force amplitude [kN]', 'Phase angle [°]']
    """
    words = _WORDS["de" if language == "de" else "en"]
    wheels = [wheel for wheel in inspection.wheels if wheel.curves is not None]
    drawings = _drawings(wheels, record, words, _phase_limits(phase_limit, phase_failure, words))
    figure = new_figure(height if drawings else _EMPTY_HEIGHT, width)
    rows = figure.subplots(1, max(len(drawings), 1), squeeze=False)[0]
    for axes, draw in zip(rows, drawings, strict=False):
        draw(axes)
        _decimal_commas(axes, language)
    if not drawings:
        rows[0].set_axis_off()
        rows[0].text(
            0.5, 0.5, words["nothing"], ha="center", color=MUTED, transform=rows[0].transAxes
        )
    return figure


def _drawings(
    wheels: list[WheelResult],
    record: xr.Dataset | None,
    words: dict[str, str],
    phase_limits: dict[str, float],
) -> list[Callable[[Axes], None]]:
    """Return functions that draw the panels, from left to right."""
    drawings: list[Callable[[Axes], None]] = []
    rigid = any(_has_values(_amplitude(wheel)) for wheel in wheels)
    if rigid:
        drawings.append(lambda axes: _over_frequency(axes, wheels, "amplitude", words))
        if any(_has_values(wheel.curves.phase_deg) for wheel in wheels if wheel.curves is not None):
            drawings.append(lambda axes: _phase(axes, wheels, words, phase_limits))
    elif any(
        wheel.curves is not None and _has_values(wheel.curves.plate_amplitude) for wheel in wheels
    ):
        drawings.append(lambda axes: _over_frequency(axes, wheels, "plate", words))
    if record is not None:
        sides = [side for side in _LOOKS if f"{side}.plate.force" in record]
        loads = {wheel.wheel: wheel.static_load for wheel in wheels}
        legend = any(
            side not in {wheel.wheel for wheel in wheels if wheel.curves is not None}
            for side in sides
        )
        if not rigid and any(f"{side}.plate.z" in record for side in sides):
            drawings.append(
                lambda axes: _over_time(
                    axes, record, "plate.z", 1e3, "height", words, {}, legend=legend
                )
            )
        if sides:
            drawings.append(
                lambda axes: _over_time(
                    axes, record, "plate.force", 1e-3, "force", words, loads, legend=legend
                )
            )
    return drawings


def _has_values(values: Array) -> bool:
    return bool(np.isfinite(values).any())


def _amplitude(wheel: WheelResult) -> Array:
    """Force amplitude of each turn, N: half of maximum minus minimum force."""
    if wheel.curves is None:
        return np.empty(0)
    return 0.5 * (wheel.curves.greatest_force - wheel.curves.least_force)


def _over_frequency(
    axes: Axes, wheels: list[WheelResult], kind: str, words: dict[str, str]
) -> None:
    for wheel in wheels:
        if wheel.curves is None:
            continue
        if kind == "amplitude":
            values = 1e-3 * _amplitude(wheel)
        else:
            values = np.where(
                turns_of_sweep(wheel.curves.frequency, wheel.curves.time),
                1e3 * wheel.curves.plate_amplitude,
                np.nan,
            )
        _curve(axes, wheel.curves.frequency, values, wheel.wheel, words)
    axes.set_ylim(bottom=0.0)
    axes.set(title=words[kind], xlabel=words["frequency"])
    axes.legend(loc="best", labelspacing=0.2)


def _phase_limits(
    passing: float | None, failing: float | None, words: dict[str, str]
) -> dict[str, float]:
    """Return the limits (degrees) by label."""
    both = {words["passes"]: passing, words["fails"]: failing}
    named = both if None not in both.values() and passing != failing else {words["limit"]: passing}
    return {name: limit for name, limit in named.items() if limit is not None}


def _phase(
    axes: Axes, wheels: list[WheelResult], words: dict[str, str], limits: dict[str, float]
) -> None:
    axes.axvspan(*_BAND, color="#eef3f7", linewidth=0.0, zorder=0)
    for wheel in wheels:
        curves = wheel.curves
        if curves is None:
            continue
        frequency, angle = curves.frequency, curves.phase_deg
        if wheel.phase_angle_min_deg is not None and wheel.phase_frequency_hz is not None:
            least = wheel.phase_frequency_hz, wheel.phase_angle_min_deg
            axes.plot(*least, "o", color=_LOOKS[wheel.wheel][0], markersize=4.0)
            frequency, angle = (
                np.append(frequency, least[0]),
                np.append(angle, least[1]),
            )  # it is between turns
        shown = np.where((angle > -90.0) & (angle < 270.0), angle, np.nan)
        _curve(axes, frequency, shown, wheel.wheel, words)
    for name, limit in limits.items():
        axes.axhline(limit, color=MUTED, linewidth=0.9, linestyle=(0, (2, 2)))
        place = {
            "xy": (1.0, limit),
            "xycoords": ("axes fraction", "data"),
            "textcoords": "offset points",
        }
        over = limit == max(limits.values())
        where = {
            "xytext": (-2, 2 if over else -2),
            "va": "baseline" if over else "top",
            "ha": "right",
        }
        axes.annotate(name, **place, **where, color=MUTED, fontsize=7.5)  # type: ignore[arg-type]
    axes.set_yticks([0, 45, 90, 135, 180])
    axes.set_ylim(min(0.0, axes.get_ylim()[0]), max(180.0, axes.get_ylim()[1]))
    axes.set(title=words["phase"], xlabel=words["frequency"])


def _curve(axes: Axes, frequency: Array, values: Array, side: str, words: dict[str, str]) -> None:
    colour, line = _LOOKS[side]
    known = np.isfinite(values) & np.isfinite(frequency)
    order = np.argsort(frequency[known], kind="stable")
    x, y = frequency[known][order], values[known][order]
    axes.plot(x, y, color=colour, linestyle=line, linewidth=1.2, label=words[side])


def _over_time(
    axes: Axes,
    record: xr.Dataset,
    channel: str,
    factor: float,
    kind: str,
    words: dict[str, str],
    loads: dict[str, float | None],
    *,
    legend: bool,
) -> None:
    """Draw a channel of each wheel; with ``legend``, label wheels not named in other panels, e.g. one at standstill."""
    time = record["time"].to_numpy()
    ends: list[Array] = []
    for side, (colour, line) in _LOOKS.items():
        if f"{side}.{channel}" not in record:
            continue
        centre, low, high = envelope(time, factor * record[f"{side}.{channel}"].to_numpy())
        axes.fill_between(
            centre, low, high, color=colour, linewidth=0.4, alpha=0.75, label=words[side]
        )
        ends += [low, high]
        load = loads.get(side)
        if load is not None:
            axes.axhline(factor * load, color=colour, linewidth=0.8, linestyle=line)
    axes.set(title=words[kind], xlabel=words["time"])
    if legend:
        axes.legend(loc="best", labelspacing=0.2)
    _leave_out_jolts(axes, np.concatenate(ends))


def _leave_out_jolts(axes: Axes, ends: Array) -> None:
    """Limit the axes to keep the jolt of a starting plate from flattening the rest of the signal."""
    if ends.size < _ENVELOPE:
        return
    least, low, high, greatest = np.quantile(ends, [0.0, 0.01, 0.99, 1.0])
    room = 0.25 * (high - low)
    axes.set_ylim(max(least - 0.1 * room, low - room), min(greatest + 0.1 * room, high + room))


def envelope(time: Array, values: Array, bins: int = _ENVELOPE) -> tuple[Array, Array, Array]:
    """Return the midpoint (s), minimum and maximum of at most ``bins`` equal parts of a signal over time (s).

    Values that are not finite are ignored.

    Examples
    --------
    >>> [part.tolist() for part in envelope(np.arange(6.0), np.array([0.0, 5.0, 1.0, 2.0, -3.0, 4.0]), 2)]
    [[1.0, 4.0], [0.0, -3.0], [5.0, 4.0]]
    """
    known = np.isfinite(values) & np.isfinite(time)
    time, values = time[known], values[known]
    if time.size == 0:
        return np.empty(0), np.empty(0), np.empty(0)
    starts = np.unique(np.linspace(0, time.size, min(bins, time.size), endpoint=False).astype(int))
    ends = np.append(starts[1:], time.size)
    centre = 0.5 * (time[starts] + time[ends - 1])
    return centre, np.minimum.reduceat(values, starts), np.maximum.reduceat(values, starts)


def _decimal_commas(axes: Axes, language: str) -> None:
    from matplotlib.ticker import FuncFormatter

    if language != "de":
        return
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter(
            FuncFormatter(lambda value, _: f"{value:g}".replace(".", ",").replace("-", "−"))
        )


_HOLLOW = " (hollow: unreliable, as after lift-off)"
_MARKS = {"left": ("o", "-"), "right": ("s", (0, (4, 1.5)))}


def history_figure(result: VehicleHistory, title: str = "") -> Figure:  # noqa: ARG001 - the page has the title
    """Draw the inspection history of a vehicle."""
    return vehicle_history(result.visits)


@in_style
def vehicle_history(visits: Sequence[WheelVisit], *, height: float = 5.4) -> Figure:
    """Draw adhesion (%), phase angle (degrees) and damping ratio of each wheel against the date.

    Visits without a date are omitted. Unreliable values have hollow marks.

    Examples
    --------
    >>> from jounce.inspection.archive.history import WheelVisit
    >>> visit = WheelVisit(1, "2026-11-21", "B-AB 123", "rear", "left", {"adhesion": 0.6}, "pass", "")
    >>> [axes.get_title("left") for axes in vehicle_history([visit]).axes]
    ['Adhesion (EUSAMA) [%]', 'Least phase angle (EGEA) [°]', 'Damping ratio on the road (THETA)']
    """
    from jounce.inspection.archive.history import QUANTITIES, day_number
    from jounce.inspection.quantities import NUMBERS

    dated = [
        (date.fromordinal(day), visit)
        for visit in visits
        if (day := day_number(visit.date)) is not None
    ]
    wheels = list(dict.fromkeys((visit.axle, visit.wheel) for _, visit in dated))
    axles = list(dict.fromkeys(axle for axle, _ in wheels))
    figure = new_figure(height)
    panels = figure.subplots(len(QUANTITIES), 1, sharex=True)
    for axes, name in zip(panels, QUANTITIES, strict=True):
        scale = NUMBERS[name].factor
        for axle, wheel in wheels:
            own = [
                (day, visit) for day, visit in dated if (visit.axle, visit.wheel) == (axle, wheel)
            ]
            known = [
                (day, scale * value)
                for day, visit in own
                if (value := visit.values.get(name)) is not None
            ]
            mark, line = _MARKS.get(wheel, ("o", "-"))
            colour = PALETTE[axles.index(axle) % len(PALETTE)]
            days, values = [day for day, _ in known], [value for _, value in known]
            size, edge = (
                (4.5, "white") if wheel == "right" else (7.5, colour)
            )  # equal values of both remain visible
            axes.plot(
                days, values, marker=mark, ls=line, color=colour, label=f"{axle} {wheel}".strip(), markersize=size,
                markeredgecolor=edge, markeredgewidth=0.8,
            )  # fmt: skip
            doubted = {day for day, visit in own if name in visit.unreliable}
            hollow = [point for point in known if point[0] in doubted]
            if hollow:
                axes.plot(
                    *zip(*hollow, strict=True),
                    marker=mark,
                    ls="none",
                    ms=size,
                    color=colour,
                    markerfacecolor="white",
                )
        axes.set_title(
            NUMBERS[name].label()
            + (_HOLLOW if any(name in visit.unreliable for _, visit in dated) else "")
        )
        shown = [
            scale * value for _, visit in dated if (value := visit.values.get(name)) is not None
        ] or [1.0]
        axes.set_ylim(1.15 * min(0.0, *shown), 1.15 * max(0.0, *shown) or 1.0)
    if wheels:
        legend_above(panels[0])
    if len({day for day, _ in dated}) == 1:  # otherwise the axis would span four years
        panels[-1].set_xticks([dated[0][0]], [dated[0][0].isoformat()])
        panels[-1].set_xlim(dated[0][0] - timedelta(days=60), dated[0][0] + timedelta(days=60))
    figure.autofmt_xdate(rotation=0, ha="center")
    return figure


_NAMES = {"eusama": "EUSAMA adhesion", "egea": "EGEA phase angle", "theta": "THETA"}
_NEVER = "dots at the top: never rejected"
_SOUND, _WORN = "#dceedd", "#f6ddd4"


@in_style
def equivalence(study: Equivalence) -> Figure:
    """Draw for each factor the damper wear (%) from which each method rejects the vehicle.

    A method rejects above its line; dots at the top mean that it never does. Sound dampers are shaded green, worn red.
    """
    from matplotlib.lines import Line2D

    figure = new_figure(4.0)
    row = figure.subplots(1, len(study.factors), sharey=True, squeeze=False)[0]
    for factor, axes in zip(study.factors, row, strict=True):
        _panel(study, factor, axes)
    row[0].set_ylabel("loss of damping [%]")
    handles = [line for line in row[0].lines if line.get_label() in _NAMES.values()]
    if any(line.get_linestyle() == "None" for axes in row for line in axes.lines):
        handles += [
            Line2D([], [], color=MUTED, marker=".", linestyle="None", markersize=2.5, label=_NEVER)
        ]
    figure.legend(
        handles=handles, loc="outside upper left", ncols=len(handles), fontsize=8.5, frameon=False
    )
    return figure


def _panel(study: Equivalence, factor: Factor, axes: Axes) -> None:
    from jounce.inspection.equivalence import SOUND, WORN

    values = factor.scale * study.planes[factor.name][factor.name].to_numpy()
    axes.axhspan(0.0, 100.0 * SOUND, color=_SOUND, zorder=0)
    axes.axhspan(100.0 * WORN, 100.0, color=_WORN, zorder=0)
    for i, (method, name) in enumerate(_NAMES.items()):
        edge = study.rejecting_wear(factor.name, method)
        axes.plot(values, 100.0 * edge, color=PALETTE[i], label=name)
        never = values[np.isnan(edge)]
        if len(never):
            axes.plot(
                never, np.full(len(never), 98.5 - 2.2 * i), ".", color=PALETTE[i], markersize=2.5
            )
    middle = 0.5 * (values[0] + values[-1])
    for height, text in ((50.0 * SOUND, "sound"), (50.0 * (1.0 + WORN), "worn")):
        axes.text(middle, height, text, ha="center", va="center", fontsize=8, color=MUTED)
    axes.set(xlabel=factor.label, xlim=(values[0], values[-1]), ylim=(0.0, 100.0))
