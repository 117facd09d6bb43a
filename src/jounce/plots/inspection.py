"""Curves of an inspection: force amplitude and phase angle over frequency, plate force over time."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.types import Array
from jounce.inspection.signals.run_down import run_down
from jounce.plots.style import MUTED, PALETTE, new_figure, styled

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.inspection.result import Inspection, WheelCurves, WheelResult

_LOOKS = {"left": (PALETTE[0], "-"), "right": (PALETTE[1], (0, (4, 1.5)))}
_BAND = (6.0, 18.0)
_ENVELOPE = 400  # bins of a force over time; finer than the paper shows
_EMPTY_HEIGHT = 0.5  # inches
_WORDS = {
    "en": {
        "left": "left", "right": "right", "frequency": "frequency [Hz]", "time": "time [s]",
        "amplitude": "Force amplitude [kN]", "phase": "Phase angle [°]", "plate": "Plate amplitude [mm]",
        "force": "Plate force [kN]", "height": "Plate height [mm]", "limit": "limit", "static": "static load",
        "nothing": "nothing to show",
    },
    "de": {
        "left": "links", "right": "rechts", "frequency": "Frequenz [Hz]", "time": "Zeit [s]",
        "amplitude": "Kraftamplitude [kN]", "phase": "Phasenwinkel [°]", "plate": "Plattenamplitude [mm]",
        "force": "Plattenkraft [kN]", "height": "Plattenhub [mm]", "limit": "Grenzwert", "static": "statische Last",
        "nothing": "nichts zu zeigen",
    },
}  # fmt: skip


@styled
def inspection_curves(
    inspection: Inspection,
    record: xr.Dataset | None = None,
    *,
    language: str = "en",
    phase_limit: float | None = None,
    height: float = 1.9,
    width: float = 8.6,
) -> Figure:
    """Draw the curves of both wheels of an axle beside each other.

    Parameters
    ----------
    inspection : Inspection
        As ``evaluate`` or ``grade`` give it; wheels without curves are left out.
    record : xarray.Dataset, optional
        The record, whose plate forces (N) are drawn over time (s).
    language : {"en", "de"}
        Of labels; German numbers have a comma.
    phase_limit : float, optional
        Of the least phase angle in degrees, drawn as a line.
    height, width : float
        Inches.

    Returns
    -------
    matplotlib.figure.Figure
        On a rigid plate force amplitude and phase angle over frequency, on a sprung one the plate's amplitude; with a
        record the plate force over time.

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
    drawings = _drawings(wheels, record, words, phase_limit)
    figure = new_figure(height if drawings else _EMPTY_HEIGHT, width)
    rows = figure.subplots(1, max(len(drawings), 1), squeeze=False)[0]
    for axes, draw in zip(rows, drawings, strict=False):
        draw(axes)
        _finish(axes, language)
    if not drawings:
        rows[0].set_axis_off()
        rows[0].text(0.5, 0.5, words["nothing"], ha="center", color=MUTED, transform=rows[0].transAxes)
    return figure


def _drawings(
    wheels: list[WheelResult], record: xr.Dataset | None, words: dict[str, str], phase_limit: float | None
) -> list[Callable[[Axes], None]]:
    """What there is to draw, from left to right."""
    found: list[Callable[[Axes], None]] = []
    rigid = any(_known(_amplitude(wheel)) for wheel in wheels)
    if rigid:
        found.append(lambda axes: _over_frequency(axes, wheels, "amplitude", words))
        if any(_known(wheel.curves.phase_deg) for wheel in wheels if wheel.curves is not None):
            found.append(lambda axes: _phase(axes, wheels, words, phase_limit))
    elif any(wheel.curves is not None and _known(wheel.curves.plate_amplitude) for wheel in wheels):
        found.append(lambda axes: _over_frequency(axes, wheels, "plate", words))
    if record is not None:
        sides = [side for side in _LOOKS if f"{side}.plate.force" in record]
        loads = {wheel.wheel: wheel.static_load for wheel in wheels}
        if not rigid and any(f"{side}.plate.z" in record for side in sides):
            found.append(lambda axes: _over_time(axes, record, "plate.z", 1e3, "height", words, {}))
        if sides:
            found.append(lambda axes: _over_time(axes, record, "plate.force", 1e-3, "force", words, loads))
    return found


def _known(values: Array) -> bool:
    return bool(np.isfinite(values).any())


def _amplitude(wheel: WheelResult) -> Array:
    """Force amplitude of every turn, N: half of greatest less least force."""
    if wheel.curves is None:
        return np.empty(0)
    return 0.5 * (wheel.curves.greatest_force - wheel.curves.least_force)


def _over_frequency(axes: Axes, wheels: list[WheelResult], kind: str, words: dict[str, str]) -> None:
    for wheel in wheels:
        if wheel.curves is None:
            continue
        if kind == "amplitude":
            values = 1e-3 * _amplitude(wheel)
        else:
            values = np.where(
                run_down(wheel.curves.frequency, wheel.curves.time), 1e3 * wheel.curves.plate_amplitude, np.nan
            )
        _curve(axes, wheel.curves, values, wheel.wheel, words)
    axes.set_ylim(bottom=0.0)
    axes.set(title=words[kind], xlabel=words["frequency"])
    axes.legend(loc="best", labelspacing=0.2)


def _phase(axes: Axes, wheels: list[WheelResult], words: dict[str, str], limit: float | None) -> None:
    axes.axvspan(*_BAND, color="#eef3f7", linewidth=0.0, zorder=0)
    for wheel in wheels:
        curves = wheel.curves
        if curves is None:
            continue
        shown = np.where((curves.phase_deg > -90.0) & (curves.phase_deg < 270.0), curves.phase_deg, np.nan)
        _curve(axes, curves, shown, wheel.wheel, words)
        if wheel.phase_angle_min_deg is not None and wheel.phase_frequency_hz is not None:
            colour = _LOOKS[wheel.wheel][0]
            axes.plot(wheel.phase_frequency_hz, wheel.phase_angle_min_deg, "o", color=colour, markersize=4.0)
    if limit is not None:
        axes.axhline(limit, color=MUTED, linewidth=0.9, linestyle=(0, (2, 2)))
        place = {"xy": (1.0, limit), "xycoords": ("axes fraction", "data"), "textcoords": "offset points"}
        axes.annotate(words["limit"], **place, xytext=(-2, 2), ha="right", color=MUTED, fontsize=7.5)  # type: ignore[arg-type]
    axes.set_yticks([0, 45, 90, 135, 180])
    axes.set_ylim(min(0.0, axes.get_ylim()[0]), max(180.0, axes.get_ylim()[1]))
    axes.set(title=words["phase"], xlabel=words["frequency"])


def _curve(axes: Axes, curves: WheelCurves, values: Array, side: str, words: dict[str, str]) -> None:
    colour, line = _LOOKS[side]
    known = np.isfinite(values) & np.isfinite(curves.frequency)
    order = np.argsort(curves.frequency[known], kind="stable")
    x, y = curves.frequency[known][order], values[known][order]
    axes.plot(x, y, color=colour, linestyle=line, linewidth=1.2, label=words[side])


def _over_time(
    axes: Axes,
    record: xr.Dataset,
    channel: str,
    factor: float,
    kind: str,
    words: dict[str, str],
    loads: dict[str, float | None],
) -> None:
    time = record["time"].to_numpy()
    ends: list[Array] = []
    for side, (colour, line) in _LOOKS.items():
        if f"{side}.{channel}" not in record:
            continue
        centre, low, high = envelope(time, factor * record[f"{side}.{channel}"].to_numpy())
        axes.fill_between(centre, low, high, color=colour, linewidth=0.4, alpha=0.75)
        ends += [low, high]
        load = loads.get(side)
        if load is not None:
            axes.axhline(factor * load, color=colour, linewidth=0.8, linestyle=line)
    axes.set(title=words[kind], xlabel=words["time"])
    _leave_out_jolts(axes, np.concatenate(ends))


def _leave_out_jolts(axes: Axes, ends: Array) -> None:
    """Keep the jolt of a starting plate, a few parts of the signal only, from flattening all the rest."""
    if ends.size < _ENVELOPE:
        return
    least, low, high, greatest = np.quantile(ends, [0.0, 0.01, 0.99, 1.0])
    room = 0.25 * (high - low)
    axes.set_ylim(max(least - 0.1 * room, low - room), min(greatest + 0.1 * room, high + room))


def envelope(time: Array, values: Array, bins: int = _ENVELOPE) -> tuple[Array, Array, Array]:
    """Least and greatest value in equal parts of a signal.

    Parameters
    ----------
    time, values : ndarray, shape (n,)
        Ascending time (s) and any values; what is not finite is left out.
    bins : int
        Parts.

    Returns
    -------
    centre, low, high : ndarray, shape (m,)
        Middle of each part (s), its least and greatest value; m is at most ``bins``.

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


def _finish(axes: Axes, language: str) -> None:
    from matplotlib.ticker import FuncFormatter

    if language != "de":
        return
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}".replace(".", ",").replace("-", "−")))
