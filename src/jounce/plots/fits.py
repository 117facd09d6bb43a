"""Figures of fits to measurements: springs and tyres, dampers, free decays, and the parameters of a model."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.display import display_unit
from jounce.core.errors import FitError
from jounce.core.types import Array
from jounce.identify.force_deflection import ForceDeflectionTrial, number_namesakes, seat
from jounce.identify.free_response import alternating, decay_response, turning_points
from jounce.identify.motion import MOTIONS, motion_of, order_of
from jounce.plots.display import digits_for, number, quantity
from jounce.plots.figures import (
    AFTER,
    BEFORE,
    INK,
    MEASURED,
    MUTED,
    PALETTE,
    at_tick,
    fill_cells,
    in_legend,
    in_style,
    legend_above,
    new_figure,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.identify.calibration import Calibration
    from jounce.identify.decay import DecayResult
    from jounce.identify.force_deflection import Zero
    from jounce.identify.stiffness import PressureStiffness, StiffnessResult
    from jounce.identify.update import UpdatedParameter, UpdateResult


@in_style
def calibration_fit(result: Calibration, title: str = "") -> Figure:
    """Draw the points of a calibration with the fitted line, and their residuals.

    Parameters
    ----------
    result : Calibration
        Result of :func:`jounce.fit_calibration`.
    title : str
        Name of the calibrated sensor.

    Returns
    -------
    matplotlib.figure.Figure
        Recorded over reference values, and the residuals.

    Examples
    --------
    >>> import jounce as jn
    >>> points = jn.fit_calibration([0.0, 0.01, 0.02], [0.4, 1.41, 2.4], unit="m")
    >>> [axes.get_ylabel() for axes in calibration_fit(points).axes]
    ['recorded [V]', 'off the line [V]']
    """
    figure = new_figure(4.2)
    above, below = figure.subplots(2, 1, sharex=True, gridspec_kw={"height_ratios": [2.2, 1.0]})
    across = display_unit(result.quantity_unit)
    recorded = result.recorded_unit.replace("1", "counts")
    x = np.array(result.reference) * across.factor
    ends = np.array([min(result.reference), max(result.reference)])
    above.plot(
        ends * across.factor,
        result.zero.value + result.sensitivity.value * ends,
        color=AFTER,
        label="line",
    )
    above.plot(x, result.recorded, "o", color=MEASURED, markersize=4.5, label="measured")
    above.set(ylabel=f"recorded [{recorded}]", title=title)
    above.legend()
    below.axhline(0.0, color=AFTER, linewidth=1.0)
    below.plot(x, result.off_the_line(), "o", color=MEASURED, markersize=4.5)
    below.set(ylabel=f"off the line [{recorded}]", xlabel=across.label("reference"))
    return figure


@in_style
def stiffness_fit(
    result: StiffnessResult, trials: Sequence[ForceDeflectionTrial] = (), title: str = ""
) -> Figure:
    """Draw a fitted force law with the measured points, and the stiffness of each individual trial.

    Parameters
    ----------
    result : StiffnessResult
        Result of the fit.
    trials : sequence of ForceDeflectionTrial, optional
        The fitted trials; if given, the measured points are drawn as used in the fit.
    title : str
        Name of the measured component, e.g. ``"spring"``.

    Returns
    -------
    matplotlib.figure.Figure
        Force against deflection, or torque against angle, and the stiffness of each trial with its 95 % interval.

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> x = np.linspace(0.0, 0.015, 31)
    >>> trials = [ForceDeflectionTrial(x, k * x, f"spring {k}") for k in (22700.0, 22760.0)]
    >>> [axes.get_xlabel() for axes in stiffness_fit(jn.fit_stiffness(trials), trials).axes]
    ['deflection [mm]', 'stiffness [N/mm]']
    """
    figure = new_figure(3.7)
    left, right = figure.subplots(1, 2, gridspec_kw={"width_ratios": [1.5, 1.0]})
    reach = _draw_points(left, trials, result.zero) or result.fitted_range[1]
    _draw_law(left, result, reach)
    motion = MOTIONS[result.motion]
    across, up = display_unit(motion.deflection), display_unit(motion.force)
    left.set(
        xlabel=across.label(motion.deflection_word), ylabel=up.label(motion.force_word), title=title
    )
    _draw_trials(right, result)
    figure.legend(
        *left.get_legend_handles_labels(), loc="outside lower left", ncols=3, columnspacing=1.4
    )
    return figure


def _draw_points(axes: Axes, trials: Sequence[ForceDeflectionTrial], zero: Zero) -> float:
    """Draw all points with the zero of the fit; return the largest deflection (SI)."""
    reach = 0.0
    for k, trial in enumerate(number_namesakes(list(trials))):
        seated, _ = seat(trial, zero=zero)
        across, up = display_unit(seated.motion.deflection), display_unit(seated.motion.force)
        label = (
            ("measured" if len(trials) == 1 else f"measured, {len(trials)} trials")
            if k == 0
            else None
        )
        axes.plot(
            seated.deflection * across.factor,
            seated.force * up.factor,
            color=MEASURED,
            alpha=0.75,
            linewidth=0.6,
            marker=".",
            markersize=3.0,
            markeredgewidth=0.0,
            label=label,
        )
        reach = max(reach, float(seated.deflection.max()))
    return reach


def _draw_law(axes: Axes, result: StiffnessResult, reach: float) -> None:
    motion = MOTIONS[result.motion]
    across, up = display_unit(motion.deflection), display_unit(motion.force)
    low, high = result.fitted_range
    inside, whole = np.linspace(low, high, 200), np.linspace(0.0, max(high, reach), 200)
    dropped = 0.0  # force in the fit that is not in the law for the model
    if (
        result.law == "linear"
        and result.intercept_choice == "drop"
        and result.intercept is not None
    ):
        dropped = result.intercept.value
    fitted = (result.curve(inside) + dropped) * up.factor
    axes.plot(
        inside * across.factor,
        fitted,
        color=AFTER,
        linewidth=1.8,
        label=f"fit, {result.law}{result.of_branch}",
    )
    label = "used in the model, without intercept" if dropped else "beyond the fitted range"
    law = result.curve(whole) * up.factor
    axes.plot(
        whole * across.factor, law, color=AFTER, linewidth=1.0, linestyle=(0, (4, 2)), label=label
    )
    if low > 0.02 * high:
        axes.axvspan(
            0.0, low * across.factor, color="#e4e8eb", linewidth=0.0, zorder=0, label="not fitted"
        )
    if result.operating_deflection is not None:
        at = result.operating_deflection * across.factor
        axes.axvline(
            at,
            color=PALETTE[1],
            linewidth=1.2,
            linestyle=(0, (1, 1.5)),
            label="static operating point",
        )


def _draw_trials(axes: Axes, result: StiffnessResult) -> None:
    si = MOTIONS[result.motion].stiffness
    unit, pooled = display_unit(si), result.stiffness
    if pooled.interval is not None:
        axes.axvspan(
            *(end * unit.factor for end in pooled.interval), color=AFTER, alpha=0.15, linewidth=0.0
        )
    axes.axvline(pooled.value * unit.factor, color=AFTER, linewidth=1.4)
    for row, trial in enumerate(result.trials):
        value, interval = trial.stiffness.value * unit.factor, trial.stiffness.interval
        if interval is not None:
            axes.plot(
                [end * unit.factor for end in interval], [row, row], color=MUTED, linewidth=1.2
            )
        axes.plot(value, row, "o", color=MEASURED, markersize=4.5)
    axes.set_yticks(range(len(result.trials)), [_short(trial.name) for trial in result.trials])
    axes.set_ylim(len(result.trials) - 0.4, -0.6)
    axes.grid(axis="y", visible=False)
    axes.set(xlabel=unit.label("stiffness"))
    axes.locator_params(axis="x", nbins=5)
    axes.set_title(
        f"all trials: {quantity(pooled.value, si)} (band: 95 %)", fontweight="normal", fontsize=9
    )


def _short(name: str) -> str:
    bare = name.rpartition("/")[2].removesuffix(".csv")
    return bare if len(bare) <= 18 else f"…{bare[-17:]}"


@in_style
def tyre_pressure(result: PressureStiffness) -> Figure:
    """Draw tyre stiffness against inflation pressure.

    Parameters
    ----------
    result : PressureStiffness
        Stiffness at each measured pressure.

    Returns
    -------
    matplotlib.figure.Figure
        Stiffness (N/mm) with 95 % intervals against pressure (MPa), connected as in the interpolation.
    """
    figure = new_figure(2.9, 4.6)
    axes = figure.subplots()
    stiffness, pressure = display_unit("N/m"), display_unit("Pa")
    x = [value * pressure.factor for value in result.pressures]
    y = [estimate.value * stiffness.factor for estimate in result.stiffnesses]
    axes.plot(x, y, color=AFTER, label="interpolated")
    for place, estimate in zip(x, result.stiffnesses, strict=True):
        if estimate.interval is not None:
            axes.plot(
                [place, place],
                [end * stiffness.factor for end in estimate.interval],
                color=MUTED,
                linewidth=1.4,
            )
    axes.plot(x, y, "o", color=MEASURED, markersize=5, label="fitted, with 95 % interval")
    axes.set(xlabel=pressure.label("inflation pressure"), ylabel=stiffness.label("tyre stiffness"))
    axes.margins(x=0.12, y=0.2)
    if result.exponent is not None:
        text = f"proportional to pressure to the power {number(result.exponent, 2)}"
        axes.text(0.98, 0.05, text, transform=axes.transAxes, ha="right", color=INK, fontsize=8.5)
    legend_above(axes, 2)
    return figure


@in_style
def damper_loops(
    displacement: ArrayLike,
    velocity: ArrayLike,
    force: ArrayLike,
    fits: Mapping[str, ArrayLike],
    title: str = "",
) -> Figure:
    """Draw force against velocity and against displacement, measured and fitted.

    Parameters
    ----------
    displacement : array (n,)
        Piston displacement [m]; empty: only the velocity panel is drawn.
    velocity : array (n,)
        Piston velocity [m/s].
    force : array (n,)
        Measured force [N].
    fits : mapping of str to array (n,)
        Force of each law by name, at the same instants [N].
    title : str
        Name of the record.

    Returns
    -------
    matplotlib.figure.Figure
        Force-velocity and force-displacement loops.

    Raises
    ------
    FitError
        For arrays of different lengths.

    Examples
    --------
    >>> import numpy as np
    >>> t = np.linspace(0.0, 1.0, 200)
    >>> x, v = 0.01 * np.sin(2 * np.pi * t), 0.02 * np.pi * np.cos(2 * np.pi * t)
    >>> [axes.get_xlabel() for axes in damper_loops(x, v, 900.0 * v, {"linear": 900.0 * v}).axes]
    ['velocity [m/s]', 'displacement [mm]']
    """
    x, v, measured = (np.asarray(values, float) for values in (displacement, velocity, force))
    shapes = {
        v.shape,
        measured.shape,
        *(np.shape(values) for values in fits.values()),
        *([x.shape] if x.size else []),
    }
    if len(shapes) != 1:
        raise FitError(
            "the columns of the damper record have different lengths",
            found=", ".join(map(str, shapes)),
        )
    panels = [("velocity", v, display_unit("m/s"))]
    if x.size:
        panels.append(("displacement", x, display_unit("m")))
    unit = display_unit("N", float(np.abs(measured).max(initial=0.0)))
    figure = new_figure(3.4)
    row = figure.subplots(1, len(panels), sharey=True, squeeze=False)[0]
    for (words, values, shown), axes in zip(panels, row, strict=True):
        axes.plot(
            values * shown.factor,
            measured * unit.factor,
            color=MEASURED,
            linewidth=2.6,
            alpha=0.35,
            label="measured",
        )
        for k, (name, fitted) in enumerate(fits.items()):
            axes.plot(
                values * shown.factor,
                np.asarray(fitted) * unit.factor,
                color=PALETTE[k % len(PALETTE)],
                linewidth=1.2,
                label=in_legend(name),
            )
        axes.set_xlabel(shown.label(words))
        axes.locator_params(axis="x", nbins=6)
    row[0].set_ylabel(unit.label("force"))
    row[0].set_title(title)
    handles, labels = row[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper right", ncols=min(5, len(labels)))
    return figure


@in_style
def decay_fit(
    result: DecayResult, time: ArrayLike = (), signal: ArrayLike = (), title: str = ""
) -> Figure:
    """Draw a free decay, the fitted response, and each turning point against the previous one.

    With viscous damping alone the turning points are on a line through the origin; dry friction shifts the line down.
    The damping ratios from single logarithmic decrements then increase as the amplitude falls.

    Parameters
    ----------
    result : DecayResult
        Result of the fit.
    time : array (n,), optional
        Times of the record [s].
    signal : array (n,), optional
        Signal of the record in SI; without it only the fitted response is drawn.
    title : str
        Name of the record.

    Returns
    -------
    matplotlib.figure.Figure
        Decay over time; turning points (displacements only); damping ratios of single decrements.
    """
    figure = new_figure(5.2)
    parts = figure.subplot_mosaic(
        [["decay", "decay"], ["peaks", "ratios"]], height_ratios=[1.25, 1.0]
    )
    t, record = np.asarray(time, float), np.asarray(signal, float)
    _draw_decay(parts["decay"], result, t, record)
    parts["decay"].set_title(title)
    _draw_peaks(parts["peaks"], result)
    _draw_ratios(parts["ratios"], result)
    return figure


def _draw_decay(axes: Axes, result: DecayResult, time: Array, record: Array) -> None:
    unit = display_unit(motion_of(result.quantity).units[order_of(result.quantity)])
    begin, end = result.window
    if len(record):
        axes.plot(time, record * unit.factor, color=MEASURED, linewidth=1.6, label="measured")
    dense = np.linspace(begin, end, 1500)
    response = decay_response(dense, result.parameters, result.quantity)
    axes.plot(
        dense,
        response * unit.factor,
        color=AFTER,
        linewidth=1.1,
        label="fit: viscous damping and dry friction",
    )
    turns = np.concatenate([[0], np.flatnonzero(np.diff(np.sign(np.diff(response))) != 0) + 1])
    offset = result.parameters.offset
    envelope = np.abs(response[turns] - offset)
    for sign in (1.0, -1.0):
        label = "envelope" if sign > 0 else None
        axes.plot(
            dense[turns],
            (offset + sign * envelope) * unit.factor,
            color=PALETTE[1],
            linewidth=0.9,
            linestyle=(0, (4, 2)),
            label=label,
        )
    axes.axhline(offset * unit.factor, color=MUTED, linewidth=0.8, linestyle=(0, (1, 2)))
    span = end - begin
    earliest = float(time[0]) if len(time) else begin
    axes.set_xlim(max(begin - 0.15 * span, earliest - 0.02 * span), end + 0.02 * span)
    axes.set(xlabel="time [s]", ylabel=unit.label(result.quantity.replace("_", " ")))
    legend_above(axes, 3)


def _draw_peaks(axes: Axes, result: DecayResult) -> None:
    motion = motion_of(result.quantity)
    if order_of(result.quantity):
        axes.set_axis_off()
        words = f"turning points are shown\nfor {'displacements' if motion.name == 'translation' else 'angles'} only"
        axes.text(0.5, 0.5, words, ha="center", va="center", color=MUTED)
        return
    unit = display_unit(motion.deflection)
    measured = np.array(result.amplitudes) * unit.factor
    axes.plot(measured[:-1], measured[1:], "o", color=MEASURED, markersize=4.5, label="measured")
    turns = alternating(turning_points(result.parameters, 40)) * unit.factor
    if len(turns) > 2:
        axes.plot(turns[:-1], turns[1:], color=AFTER, label="fitted")
        axes.plot(
            [0.0, turns[0]],
            [0.0, result.parameters.half_cycle_ratio * turns[0]],
            color=MUTED,
            linewidth=1.0,
            linestyle=(0, (1, 2)),
            label="without friction",
        )
    axes.set_xlim(left=0.0)
    axes.set_ylim(bottom=0.0)
    axes.set(
        xlabel=unit.label("turning point, from equilibrium"),
        ylabel=unit.label("next turning point"),
    )
    axes.set_title("each turning point against the previous one", fontweight="normal", fontsize=9)
    axes.legend(loc="upper left")


def _draw_ratios(axes: Axes, result: DecayResult) -> None:
    count = len(result.naive_damping_ratios)
    cycles = 0.5 * np.arange(count)
    axes.plot(
        cycles,
        result.naive_damping_ratios,
        "s",
        color=PALETTE[1],
        markersize=4.5,
        label="single decrements",
    )
    combined = result.damping_ratio
    if combined.interval is not None:
        axes.axhspan(*combined.interval, color=AFTER, alpha=0.15, linewidth=0.0)
    axes.axhline(combined.value, color=AFTER, label="viscous, with 95 % interval")
    top = max(
        [value for value in (*result.naive_damping_ratios, combined.value) if np.isfinite(value)],
        default=0.0,
    )
    axes.set_ylim(
        0.0, 1.6 * top if top > 0.0 else 1.0
    )  # room for the legend; a wide band may exceed the axes
    axes.set_xlim(-0.25, max(0.5 * count - 0.25, 1.0))
    axes.set(xlabel="cycle", ylabel="damping ratio [–]")
    friction = quantity(result.coulomb_force.value, motion_of(result.quantity).force, 3)
    axes.set_title(f"damping ratio (dry friction: {friction})", fontweight="normal", fontsize=9)
    axes.legend(loc="upper left")


@in_style
def update(result: UpdateResult) -> Figure:
    """Draw the fitted parameters of one update within their bounds, and the correlation of their estimates.

    Parameters
    ----------
    result : UpdateResult
        One update.

    Returns
    -------
    matplotlib.figure.Figure
        Parameters from the lower (-100 %) to the upper bound (+100 %) with 95 % intervals due to noise only;
        correlation matrix of the parameters (without lags).
    """
    count = len(result.parameters)
    figure = new_figure(1.15 + 0.42 * max(count, 2))
    if count == 1:
        figure.set_figwidth(5.4)
        _draw_parameters(figure.subplots(), result.parameters)
        return figure
    left, right = figure.subplots(
        1, 2, gridspec_kw={"width_ratios": [1.0, 0.3 + 0.14 * min(count, 8)]}
    )
    _draw_parameters(left, result.parameters)
    _draw_correlation(right, result.correlation, count)
    return figure


def _draw_parameters(axes: Axes, parameters: Mapping[str, UpdatedParameter]) -> None:
    for row, p in enumerate(parameters.values()):
        middle, half = 0.5 * (p.lower + p.upper), 0.5 * (p.upper - p.lower)
        ends = [] if p.interval is None else [100.0 * (end - middle) / half for end in p.interval]
        if ends:
            axes.plot(
                np.clip(ends, -108.0, 108.0), [row, row], color=AFTER, linewidth=1.6, alpha=0.6
            )
        marker, colour, ink = ("s", PALETTE[1], PALETTE[1]) if p.at_bound else ("o", AFTER, INK)
        axes.plot(
            100.0 * (p.initial - middle) / half,
            row,
            "o",
            markersize=7,
            color="white",
            markeredgecolor=MUTED,
        )
        axes.plot(100.0 * (p.value - middle) / half, row, marker, markersize=6, color=colour)
        axes.text(
            1.02,
            row,
            _value_text(p),
            transform=axes.get_yaxis_transform(),
            va="center",
            fontsize=8.5,
            color=ink,
        )
    axes.axvline(-100.0, color=MUTED, linewidth=1.0)
    axes.axvline(100.0, color=MUTED, linewidth=1.0)
    axes.set_xlim(-112.0, 112.0)
    axes.set_ylim(len(parameters) - 0.4, -0.6)
    numbered = [
        f"{path}  {row}" if len(parameters) > 1 else path for row, path in enumerate(parameters, 1)
    ]
    axes.set_yticks(range(len(parameters)), numbered)
    axes.set_xticks([-100, -50, 0, 50, 100])
    axes.grid(axis="y", visible=False)
    axes.set_xlabel("position between lower and upper bound [%]")
    axes.set_title(
        "initial ○, fitted ●, at a bound ■\nline and ±: 95 %, noise only",
        fontweight="normal",
        fontsize=9,
    )


def _value_text(p: UpdatedParameter) -> str:
    unit = display_unit(p.unit, p.value)
    half = None if p.interval is None else 0.5 * (p.interval[1] - p.interval[0])
    value = (
        0.0 if abs(p.value) < 1e-9 * (p.upper - p.lower) else p.value
    )  # rounding residue of a bound at zero
    text = number(value * unit.factor, digits_for(value, half))
    if half is not None:
        text += f" ± {number(half * unit.factor, 2)}"
    return f"{text} {unit.name}".rstrip() + (" (at bound)" if p.at_bound else "")


_MOST_NUMBERS = 7  # maximum number of parameters for correlations with two decimals


def _draw_correlation(axes: Axes, correlation: Sequence[Sequence[float]], count: int) -> None:
    values = np.array(correlation)[:count, :count]
    size, digits = (
        (min(8.0, 38.0 / count), 2)
        if count <= _MOST_NUMBERS
        else (max(8.0 * _MOST_NUMBERS / count, 4.0), 1)
    )
    fill_cells(axes, values, "RdBu_r")
    for row in range(len(values)):
        for column in range(len(values)):
            known = values[row, row] > 0.0 and values[column, column] > 0.0
            text = (
                ("1" if row == column else f"{values[row, column]:.{digits}f}".replace("-", "−"))
                if known
                else "–"
            )
            shade = "white" if abs(values[row, column]) > 0.6 else INK
            axes.text(column, row, text, ha="center", va="center", fontsize=size, color=shade)
    axes.set_xticks(range(count), [str(k) for k in range(1, count + 1)])
    axes.set_yticks(range(count), [str(k) for k in range(1, count + 1)])
    axes.set_xlabel("parameter number")
    axes.spines[:].set_visible(False)
    axes.tick_params(length=0)
    axes.set_title("correlation", fontweight="normal", fontsize=9)


def _change(percent: float) -> str:
    text = f"{percent:+.1f} %"
    return "no change" if text in ("+0.0 %", "-0.0 %") else text.replace("-", "−")


@in_style
def objectives(results: Sequence[UpdateResult]) -> Figure:
    """Draw the objective of several updates before and after, each relative to its initial value.

    Parameters
    ----------
    results : sequence of UpdateResult
        The updates in order.

    Returns
    -------
    matplotlib.figure.Figure
        Two bars for each update, labelled with the objectives.
    """
    figure = new_figure(0.9 + 0.55 * len(results))
    axes = figure.subplots()
    for row, result in enumerate(results):
        remaining = 100.0 - result.reduction_percent
        axes.barh(
            row - 0.19, 100.0, 0.34, color=BEFORE, alpha=0.55, label="before" if row == 0 else None
        )
        axes.barh(row + 0.19, remaining, 0.34, color=AFTER, label="after" if row == 0 else None)
        axes.text(101.0, row - 0.19, number(result.objective_before), va="center", fontsize=8.5)
        text = f"{number(result.objective_after)} ({_change(-result.reduction_percent)})"
        axes.text(max(remaining, 0.0) + 1.0, row + 0.19, text, va="center", fontsize=8.5)
    axes.set_yticks(range(len(results)), [at_tick(result.name) for result in results])
    axes.set_ylim(len(results) - 0.45, -0.55)
    axes.set_xlim(0.0, 118.0)
    axes.set_xticks([0, 25, 50, 75, 100])
    axes.grid(axis="y", visible=False)
    axes.set_xlabel("objective relative to its initial value [%]")
    legend_above(axes, 2)
    return figure
