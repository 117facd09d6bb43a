"""Figures of a campaign's bench measurements and roads, as data."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.display import display_unit, display_unit_for
from jounce.core.types import Array
from jounce.identify.force_deflection import ForceDeflectionTrial, number_namesakes, seat
from jounce.identify.free_response import alternating, decay_response, turning_points
from jounce.identify.motion import MOTIONS, motion_of, order_of
from jounce.plots.display import number, quantity
from jounce.plots.signals import sample_segments
from jounce.report.chart import Panel, Series

if TYPE_CHECKING:
    from jounce.identify.decay import DecayResult
    from jounce.identify.stiffness import PressureStiffness, StiffnessResult
    from jounce.roads import Road


def stiffness_panels(
    fit: StiffnessResult, trials: Sequence[ForceDeflectionTrial], title: str
) -> tuple[Panel, ...]:
    """Plot force against deflection with the fitted law, and the stiffness of each trial with its interval."""
    series, reach, motion = [], 0.0, MOTIONS[fit.motion]
    across, up = display_unit(motion.deflection), display_unit(motion.force)
    for k, trial in enumerate(number_namesakes(list(trials))):
        seated, _ = seat(trial, zero=fit.zero)
        label = "" if k else ("measured" if len(trials) == 1 else f"measured, {len(trials)} trials")
        series.append(
            Series(
                across.factor * seated.deflection,
                up.factor * seated.force,
                "measured",
                "line",
                label,
            )
        )
        reach = max(reach, float(seated.deflection.max()))
    low, high = fit.fitted_range
    dropped = 0.0  # intercept force of the fit that the model's law omits
    if fit.law == "linear" and fit.intercept_choice == "drop" and fit.intercept is not None:
        dropped = fit.intercept.value
    inside, whole = np.linspace(low, high, 60), np.linspace(0.0, max(high, reach), 60)
    words = "used in the model, without intercept" if dropped else "beyond the fitted range"
    series.append(
        Series(across.factor * whole, up.factor * fit.curve(whole), "after", "dashed", words)
    )
    fitted = up.factor * (fit.curve(inside) + dropped)
    series.append(
        Series(across.factor * inside, fitted, "after", "line", f"fit, {fit.law}{fit.of_branch}")
    )
    bands = ((0.0, across.factor * low, "not fitted"),) if low > 0.02 * high else ()
    verticals: tuple[tuple[float, str, str], ...] = ()
    if fit.operating_deflection is not None:
        verticals = (
            (across.factor * fit.operating_deflection, "before", "static operating point"),
        )
    labels = across.label(motion.deflection_word), up.label(motion.force_word)
    left = Panel(tuple(series), *labels, title, bands, verticals, width=450, height=290)
    return left, _each_trial(fit)


def _each_trial(fit: StiffnessResult) -> Panel:
    si = MOTIONS[fit.motion].stiffness
    unit, pooled = display_unit(si), fit.stiffness
    series = []
    for row, trial in enumerate(fit.trials):
        if trial.stiffness.interval is not None:
            ends = [end * unit.factor for end in trial.stiffness.interval]
            series.append(Series(ends, [row, row], "muted"))
        series.append(Series([trial.stiffness.value * unit.factor], [row], "measured", "dots"))
    pooled_ends = [end * unit.factor for end in pooled.interval or ()]
    return Panel(
        tuple(series),
        unit.label("stiffness"),
        title=f"all trials: {quantity(pooled.value, si)} (band: 95 %)",
        bands=((pooled_ends[0], pooled_ends[1], ""),) if pooled_ends else (),
        verticals=((pooled.value * unit.factor, "after", ""),),
        lanes=tuple(trial.name.rpartition("/")[2].removesuffix(".csv") for trial in fit.trials),
        width=350,
        height=max(130, 70 + 26 * len(fit.trials)),
    )


def pressure_panel(law: PressureStiffness) -> Panel:
    """Plot stiffness against inflation pressure with intervals."""
    stiffness, pressure = display_unit("N/m"), display_unit("Pa")
    x = [value * pressure.factor for value in law.pressures]
    y = [estimate.value * stiffness.factor for estimate in law.stiffnesses]
    series = [Series(x, y, "after", "line", "interpolated")]
    for place, estimate in zip(x, law.stiffnesses, strict=True):
        if estimate.interval is not None:
            series.append(
                Series(
                    [place, place], [end * stiffness.factor for end in estimate.interval], "muted"
                )
            )
    series.append(Series(x, y, "measured", "dots", "fitted, with 95 % interval"))
    power = (
        ""
        if law.exponent is None
        else f"proportional to pressure to the power {number(law.exponent, 2)}"
    )
    reach = 0.12 * (max(x) - min(x)) or 0.1
    ends = (min(x) - reach, max(x) + reach)
    labels = pressure.label("inflation pressure"), stiffness.label("tyre stiffness")
    return Panel(tuple(series), *labels, power, x_range=ends)


def decay_panels(decay: DecayResult, time: Array, record: Array, title: str) -> tuple[Panel, ...]:
    """Plot a free decay over time with the fitted response, turning points, and damping ratios of single decrements."""
    motion, order = motion_of(decay.quantity), order_of(decay.quantity)
    unit = display_unit(motion.units[order])
    begin, end = decay.window
    dense = np.linspace(begin, end, 600)
    response = decay_response(dense, decay.parameters, decay.quantity) * unit.factor
    over_time = (
        [Series(time, record * unit.factor, "measured", "line", "measured")] if len(record) else []
    )
    over_time.append(
        Series(dense, response, "after", "line", "fit: viscous damping and dry friction")
    )
    span = end - begin
    labels = "time [s]", unit.label(decay.quantity.replace("_", " "))
    earliest = float(time[0]) if len(record) else begin
    shown = (max(begin - 0.15 * span, earliest - 0.02 * span), end + 0.02 * span)
    panels = [Panel(tuple(over_time), *labels, title, x_range=shown, width=520)]
    if order == 0:
        amplitudes = np.array(decay.amplitudes) * unit.factor
        turns = alternating(turning_points(decay.parameters, 40)) * unit.factor
        points = [Series(amplitudes[:-1], amplitudes[1:], "measured", "dots", "measured")]
        if len(turns) > 2:
            points.append(Series(turns[:-1], turns[1:], "after", "line", "fitted"))
            without = [0.0, float(decay.parameters.half_cycle_ratio * turns[0])]
            points.append(
                Series([0.0, float(turns[0])], without, "muted", "dotted", "without friction")
            )
        labels = unit.label("turning point, from equilibrium"), unit.label("next turning point")
        panels.append(
            Panel(
                tuple(points),
                *labels,
                "each turning point against the last",
                from_zero=True,
                width=380,
            )
        )
    return (*panels, _ratios(decay))


def _ratios(decay: DecayResult) -> Panel:
    cycles = 0.5 * np.arange(len(decay.naive_damping_ratios))
    ratio = decay.damping_ratio
    ends = [-0.25, max(float(cycles.max(initial=0.0)) + 0.25, 1.0)]
    series = [
        Series(ends, [ratio.value, ratio.value], "after", "line", "viscous, with 95 % interval")
    ]
    if ratio.interval is not None:
        series += [Series(ends, [end, end], "after", "dotted") for end in ratio.interval]
    series.append(
        Series(cycles, decay.naive_damping_ratios, "before", "squares", "single decrements")
    )
    friction = quantity(decay.coulomb_force.value, MOTIONS[decay.motion].force, 3)
    return Panel(
        tuple(series),
        "cycle",
        "damping ratio [–]",
        f"damping ratio (dry friction: {friction})",
        x_range=(ends[0], ends[1]),
        from_zero=True,
        width=380,
    )


def road_panels(roads: Mapping[str, Road]) -> tuple[Panel, ...]:
    """Plot the height of each road against distance, over a common range."""
    reach = 1.08 * max(*(road.end() for road in roads.values()), 1e-3)
    begin = min(road.start for road in roads.values())
    shown = (max(0.0, begin - 0.08 * (reach - begin)), reach)
    across, up = display_unit_for("m", largest=reach), display_unit("m")
    shown = (across.factor * shown[0], across.factor * shown[1])
    panels = []
    for k, (name, road) in enumerate(roads.items()):
        x, height = sample_segments(road.segments(reach))
        label = across.label("distance") if k == len(roads) - 1 else ""
        panels.append(
            Panel(
                (Series(across.factor * x, up.factor * height),),
                label,
                up.label("height"),
                name,
                x_range=shown,
                width=620,
                height=110 + 18 * bool(label),
            )
        )
    return tuple(panels)
