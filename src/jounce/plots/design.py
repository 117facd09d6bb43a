"""Figures of designs and rides: changes by an optimisation, comfort over road holding of designs and controllers."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.display import display_unit, display_unit_for
from jounce.plots.display import number, quantity, raise_exponents
from jounce.plots.figures import (
    AFTER,
    BEFORE,
    INK,
    MUTED,
    PALETTE,
    WIDTH,
    at_tick,
    in_legend,
    in_style,
    log_axes,
    new_figure,
)
from jounce.plots.labels import name_points
from jounce.plots.parallel import between_ends, draw_uprights

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.core.types import Array
    from jounce.design.goal_front import DesignFront
    from jounce.design.optimise import DesignConstraint, DesignNumber, Optimisation
    from jounce.design.pareto import ParetoFront, ParetoMark
    from jounce.ride.stationary import StationaryResponse
    from jounce.ride.study import Ride, RideStudy


_MARKERS = {"present": ("D", BEFORE), "closed form": ("o", "white"), "searched": ("x", INK)}
_KINDS = {
    "present": "present design",
    "closed form": "best damper, closed form",
    "searched": "best damper, searched",
}
_WORDS = {"comfort": "comfort", "holding": "road holding", "travel": "travel"}
_BAR = 0.55


@in_style
def pareto_front(front: ParetoFront) -> Figure:
    """Draw a front: two metrics, coloured by a third if there is one, and best dampers; next to it the free numbers.

    Examples
    --------
    >>> import jounce as jn
    >>> from jounce.design.pareto import pareto
    >>> free = {"strut.damper.coefficient": ("300 N*s/m", "6000 N*s/m")}
    >>> figure = pareto_front(pareto(jn.load("audi-a6-quarter-car"), free, "C", "20 m/s", points=5))
    >>> len(figure.axes)   # front, one kind of number, colours of the travel
    3
    """
    kinds = _by_unit(front)
    figure = new_figure(4.2, 8.6)
    grid = figure.add_gridspec(len(kinds), 2, width_ratios=[1.55, 1.0])
    main = figure.add_subplot(grid[:, 0])
    _front(figure, main, front)
    column = [figure.add_subplot(grid[0, 1])]
    column += [figure.add_subplot(grid[i, 1], sharex=column[0]) for i in range(1, len(kinds))]
    comfort = display_unit(front.units["comfort"])
    for axes, (unit, paths) in zip(column, kinds.items(), strict=True):
        shown = display_unit(unit)
        for path, colour in zip(paths, (PALETTE * len(paths))[: len(paths)], strict=True):
            axes.plot(
                front.comfort * comfort.factor,
                front.numbers[path] * shown.factor,
                color=colour,
                label=path,
                marker=".",
                markersize=4,
            )
        low, high = axes.get_ylim()
        middle, least = 0.5 * (low + high), 1e-3 * max(abs(low), abs(high))
        if (
            high - low < least
        ):  # a number that stays at its bound: do not scale the axis to rounding errors
            axes.set_ylim(middle - 100.0 * least, middle + 100.0 * least)
        axes.set_ylabel(shown.name or "–")
        axes.set_title(" · ".join(paths) if len(paths) == 1 else "")
        if len(paths) > 1:
            axes.legend(loc="best", fontsize=7.5)
        axes.tick_params(labelbottom=axes is column[-1])
    column[-1].set_xlabel(_label(front, "comfort"))
    return figure


@in_style
def design_front(front: DesignFront) -> Figure:
    """Draw a front of several metrics: each pair of the first four, then all metrics and numbers as parallel axes.

    Each design has the same colour in all axes, by the first metric; the present rig is a diamond and a dashed line.

    Examples
    --------
    >>> import jounce as jn
    >>> free, goals = {"strut.damper.coefficient": (300.0, 6000.0)}, ["sprung.az", "tyre.force", "strut.deflection"]
    >>> figure = design_front(jn.design_front("audi-a6-quarter-car", free, goals, "C", "20 m/s", points=4))
    >>> len(figure.axes)   # three pairs, parallel axes
    4
    """
    from matplotlib import colormaps

    colours = colormaps["viridis"](np.linspace(0.0, 0.92, front.count))
    pairs = list(combinations(list(front.goals)[:_MOST_PAIRED], 2))
    across = min(len(pairs), _ACROSS)
    down = -(-len(pairs) // across)
    figure = new_figure(2.7 * down + 3.0, 9.2)
    grid = figure.add_gridspec(down + 1, across, height_ratios=[*[2.7] * down, 2.4])
    for k, (first, second) in enumerate(pairs):
        axes = figure.add_subplot(grid[k // across, k % across])
        units = [
            display_unit(front.goal_units[name], float(np.max(np.abs(front.goals[name]))))
            for name in (first, second)
        ]
        x, y = (
            front.goals[name] * unit.factor
            for name, unit in zip((first, second), units, strict=True)
        )
        axes.scatter(x, y, c=colours, s=26, zorder=3, linewidths=0)
        marker, face = _MARKERS["present"]
        here = [
            front.present[name] * unit.factor
            for name, unit in zip((first, second), units, strict=True)
        ]
        axes.scatter(
            here[0],
            here[1],
            marker=marker,
            s=40,
            facecolor=face,
            edgecolor=INK,
            linewidths=1.2,
            zorder=4,
            label="as it is",
        )
        axes.set(xlabel=units[0].label(first), ylabel=units[1].label(second))
        if not k:
            axes.legend(loc="best", fontsize=8)
    _parallel_front(figure.add_subplot(grid[down, :]), front, colours)
    figure.suptitle(at_tick(raise_exponents(front.driven), 110), fontsize=8, color=MUTED)
    return figure


_MOST_PAIRED, _ACROSS = 4, 3


def _parallel_front(axes: Axes, front: DesignFront, colours: Array) -> None:
    """Draw designs as lines over parallel vertical axes: metrics, then numbers."""
    columns, labels = [], []
    units = {**front.goal_units, **front.number_units}
    present = {**front.present, **front.start}
    for name, values in {**front.goals, **front.numbers}.items():
        every = np.append(values, present[name])
        unit = display_unit(units[name], float(np.max(np.abs(every))))
        columns.append(every * unit.factor)
        labels.append(unit.label(name))
    shares, ends = zip(*map(between_ends, columns), strict=True)
    lines = np.array(shares).T
    for row, colour in zip(lines[:-1], colours, strict=True):
        axes.plot(range(len(labels)), row, color=colour, lw=1.2, alpha=0.9, zorder=2.0)
    axes.plot(range(len(labels)), lines[-1], color=INK, lw=1.2, ls="--", zorder=3.0)
    draw_uprights(axes, ends)
    axes.set_title(
        "designs of the front; as it is, dashed"
        if front.count > 1
        else "the design; as it is, dashed",
        loc="left",
    )
    axes.set_xticks(
        range(len(labels)), labels, rotation=25, ha="right", rotation_mode="anchor", fontsize=8
    )


def _by_unit(front: ParetoFront) -> dict[str, list[str]]:
    paths: dict[str, list[str]] = {}
    for path in front.numbers:
        paths.setdefault(front.number_units[path], []).append(path)
    return paths


def _label(front: ParetoFront, role: str) -> str:
    unit, metric = display_unit(front.units[role]), front.words[role]
    return unit.label(
        metric if ": " in metric else f"{_WORDS[role]}: {metric}"
    )  # a case may have any metric


def _front(figure: Figure, axes: Axes, front: ParetoFront) -> None:
    x, y, travel = (
        display_unit(front.units[role]).factor for role in ("comfort", "holding", "travel")
    )
    places: dict[str, Any] = {
        "x": front.comfort * x,
        "y": front.holding * y,
        "s": 26,
        "zorder": 3,
        "linewidths": 0,
    }
    if "travel" in front.roles:
        points = axes.scatter(**places, c=front.travel * travel, cmap="viridis")
        bar = figure.colorbar(points, ax=axes, orientation="horizontal", aspect=45, pad=0.02)
        bar.set_label(_label(front, "travel"), fontsize=8.5)
        bar.outline.set_visible(False)
    else:
        axes.scatter(**places, color=PALETTE[0])
    axes.plot(front.comfort * x, front.holding * y, color=MUTED, linewidth=0.8, zorder=2)
    every = [*front.comfort, *(mark.comfort for mark in front.marks)]
    middle = 0.5 * (min(every) + max(every))
    for mark in front.marks:
        _draw_mark(axes, mark, x, y, is_right=mark.comfort > middle)
    axes.set(xlabel=_label(front, "comfort"), ylabel=_label(front, "holding"))
    axes.legend(handles=_handles(front), loc="upper right", fontsize=8)
    axes.set_title(
        at_tick(raise_exponents(front.driven), 78), fontsize=8, fontweight="normal", color=MUTED
    )


def _draw_mark(axes: Axes, mark: ParetoMark, x: float, y: float, *, is_right: bool) -> None:
    marker, face = _MARKERS[mark.kind]
    at = (mark.comfort * x, mark.holding * y)
    style: dict[str, Any] = {"marker": marker, "s": 46, "zorder": 4, "linewidths": 1.2}
    if marker == "x":
        axes.scatter(*at, color=face, **style)
    else:
        axes.scatter(*at, facecolor=face, edgecolor=INK, **style)
    if mark.kind == "closed form":
        text = mark.name.removeprefix("best damper ")
        axes.annotate(
            text,
            at,
            xytext=(0, 8),
            textcoords="offset points",
            fontsize=7.5,
            color=INK,
            ha="right" if is_right else "left",
        )


def _handles(front: ParetoFront) -> list[Any]:
    from matplotlib.lines import Line2D

    kinds = [kind for kind in _MARKERS if any(mark.kind == kind for mark in front.marks)]
    handles = [
        Line2D([], [], color=MUTED, marker=".", markersize=8, linewidth=0.8, label="best designs")
    ]
    for kind in kinds:
        marker, face = _MARKERS[kind]
        handles.append(
            Line2D(
                [], [], linestyle="", marker=marker, markeredgecolor=INK, markerfacecolor=face, label=_KINDS[kind]
            )
        )  # fmt: skip
    return handles


@in_style
def optimisation(result: Optimisation) -> Figure:
    """Draw the changes made by an optimisation.

    Left: each design variable between its bounds (0 to 100 %), with the range in which the objective rises by 1 %.
    Right: each metric and limited channel relative to its initial value (%), with limits as vertical marks.

    Examples
    --------
    >>> import jounce as jn
    >>> from jounce.design.optimise import optimise
    >>> free = {"strut.damper.coefficient": ("300 N*s/m", "6000 N*s/m")}
    >>> figure = optimisation(optimise(jn.load("audi-a6-quarter-car"), free, "sprung.az", road="C", speed="20 m/s"))
    >>> [axes.get_title("left") for axes in figure.axes]
    ['Design variables', 'Metrics']
    """
    rows = _rows(result)
    figure = new_figure(1.5 + 0.42 * max(len(result.numbers), len(rows)), 9.2)
    left, right = figure.subplots(1, 2, width_ratios=[1.0, 1.0])
    for i, item in enumerate(result.numbers):
        _draw_number(left, i, item)
    names = [item.path for item in result.numbers]
    left.set_yticks(range(len(names)), names)
    left.set(
        xlabel="position between the bounds [%]",
        xlim=(-4.0, 104.0),
        ylim=(len(names) - 0.4, -0.75),
        title="Design variables",
    )
    left.grid(axis="y", visible=False)
    figure.legend(handles=_number_handles(result), loc="outside lower left", ncols=3, fontsize=8)
    _draw_metrics(right, rows)
    return figure


def _draw_number(axes: Axes, i: int, item: DesignNumber) -> None:
    def place(value: float) -> float:
        return 100.0 * (value - item.lower) / (item.upper - item.lower)

    axes.plot([0.0, 100.0], [i, i], color="#c9ced4", linewidth=2.0, zorder=1, solid_capstyle="butt")
    if item.flat is not None:
        axes.plot([place(end) for end in item.flat], [i, i], color=AFTER, alpha=0.3, linewidth=9.0, zorder=2,
                  solid_capstyle="butt")  # fmt: skip
    axes.plot(
        place(item.start), i, marker="D", color=BEFORE, markeredgecolor=INK, markersize=6, zorder=3
    )
    axes.plot(
        place(item.value), i, marker="o", color=AFTER, markeredgecolor=INK, markersize=7, zorder=4
    )
    text = f"{quantity(item.start, item.unit, 3)} → {quantity(item.value, item.unit, 4)}"
    axes.annotate(
        text,
        (50.0, i),
        xytext=(0, 8),
        textcoords="offset points",
        ha="center",
        fontsize=7.5,
        color=INK,
    )


def _number_handles(result: Optimisation) -> list[Any]:
    from matplotlib.lines import Line2D

    handles = [
        Line2D(
            [],
            [],
            linestyle="",
            marker="D",
            color=BEFORE,
            markeredgecolor=INK,
            markersize=6,
            label="start",
        ),
        Line2D(
            [],
            [],
            linestyle="",
            marker="o",
            color=AFTER,
            markeredgecolor=INK,
            markersize=7,
            label="best",
        ),
    ]
    if any(item.flat is not None for item in result.numbers):
        handles.append(
            Line2D([], [], color=AFTER, alpha=0.3, linewidth=8.0, label="objective within 1 %")
        )
    return handles


_Row = tuple[str, float, float, "DesignConstraint | None", str]


def _rows(result: Optimisation) -> list[_Row]:
    """Name, values before and after, limit and unit of each bar: objective first, then limited channels."""
    rows: list[_Row] = [
        (name, result.before[name], result.after[name], None, result.units[name])
        for name in result.objective
    ]
    for item in result.constraints:
        words = item.name.split()[1:] if item.channel != item.name else []
        rows.append((" ".join([item.channel, *words]), item.start, item.value, item, item.unit))
    return rows


def _draw_metrics(axes: Axes, rows: list[_Row]) -> None:
    for i, (_, before, after, limit, unit) in enumerate(rows):
        size = abs(before) or 1.0
        axes.barh(
            i, 100.0 * after / size, _BAR, color=AFTER if limit is None else PALETTE[5], zorder=2
        )
        for bound in (limit.lower, limit.upper) if limit is not None else ():
            if bound is not None and abs(bound) < 3.0 * size:
                at = 100.0 * bound / size
                axes.plot([at, at], [i - 0.4, i + 0.4], color="#a33f1f", linewidth=2.2, zorder=4)
        held = limit is not None and limit.is_active
        text = quantity(after, unit, 4)
        if limit is None:
            text = f"{text}, {number(100.0 * (after / size - 1.0), 3)} %"
        axes.annotate(
            f" {text}{', at its limit' if held else ''}",
            (0.0, i),
            va="center",
            fontsize=7.5,
            color="white",
            zorder=5,
        )
    axes.axvline(100.0, color=BEFORE, linewidth=1.2, zorder=3)
    axes.set_yticks(range(len(rows)), [row[0] for row in rows])
    axes.set(xlabel="relative to the start [%]", ylim=(len(rows) - 0.4, -0.75), title="Metrics")
    axes.grid(axis="y", visible=False)


_HIGHEST = 50.0  # Hz: above the wheel hop of all rigs in the library
_POINT_SIZE = 200.0  # points^2, of the ride with the largest travel


def study_spectra(study: RideStudy, *, title: str) -> Figure:
    """Draw the spectra of all rides of a study, with the spectra of the linear model."""
    return ride_spectra(study.rides, study.stationary, title)


@in_style
def ride_spectra(
    rides: Sequence[Ride], stationary: StationaryResponse | None = None, title: str = ""
) -> Figure:
    """Draw power spectral densities of the body's acceleration ((m/s²)²/Hz) and of all wheel loads (N²/Hz).

    One line per ride over frequency (Hz), and that of the linear model if its ``stationary`` response is given. The
    title has the road, the duration and the resolution of the spectra.
    """
    spectra = [ride.spectra() for ride in rides]
    channels = list(spectra[0])
    columns = 1 if len(channels) < 3 else 2
    figure = new_figure(0.6 + 2.6 * -(-len(channels) // columns), 9.6 if columns > 1 else WIDTH)
    grid = figure.subplots(-(-len(channels) // columns), columns, sharex=True, squeeze=False)
    units = {"az": display_unit("m/s^2"), "force": display_unit("N")}
    for name, axes in zip(channels, grid.flat, strict=False):
        for i, (ride, spectrum) in enumerate(zip(rides, spectra, strict=True)):
            estimate = spectrum[name]
            unit = units[name.rpartition(".")[2]]
            band = (estimate.frequency > 0.0) & (estimate.frequency <= _HIGHEST)
            style = "-" if i < len(PALETTE) else "--"
            axes.plot(
                estimate.frequency[band],
                unit.factor**2 * estimate.density[band],
                style,
                color=PALETTE[i % len(PALETTE)],
                label=in_legend(ride.control),
            )
        if (
            stationary is not None
            and stationary.frequency is not None
            and name in stationary.spectra
        ):
            line = {
                "color": INK,
                "linewidth": 1.0,
                "linestyle": (0, (4, 2)),
                "label": "linear model, passive",
            }
            axes.plot(stationary.frequency, unit.factor**2 * stationary.spectra[name], **line)
        log_axes(axes)
        squared = f"({unit.name})²" if "/" in unit.name else f"{unit.name}²"
        axes.set(title=name, ylabel=f"power spectral density [{squared}/Hz]", xlim=(0.2, _HIGHEST))
        low, high = _visible_range(axes)
        axes.set_ylim(low, high)
    for axes in grid.flat[len(channels) :]:
        axes.remove()
    for axes in list(grid.flat)[max(len(channels) - columns, 0) : len(channels)]:
        axes.set_xlabel("frequency [Hz]")
        axes.tick_params(labelbottom=True)
    handles, words = grid.flat[0].get_legend_handles_labels()
    if len(handles) > 1:
        grid.flat[0].legend(handles, words, loc="lower left", fontsize=8)
    first = next(iter(spectra[0].values()))
    subtitle = f"{rides[0].duration:.3g} s, resolution {first.resolution:.2g} Hz"
    figure.suptitle(f"{title}, {subtitle}" if title else subtitle, x=0.01, ha="left", fontsize=10)
    return figure


def _visible_range(axes: Axes) -> tuple[float, float]:
    """Vertical limits for the lines within the frequencies shown, at most five decades."""
    greatest = max(float(np.nanmax(line.get_ydata(), initial=0.0)) for line in axes.lines)
    least = min(
        float(np.min(y[(y > 0.0) & (x >= axes.get_xlim()[0]) & (x <= _HIGHEST)], initial=greatest))
        for x, y in (
            (np.asarray(line.get_xdata()), np.asarray(line.get_ydata())) for line in axes.lines
        )
    )
    return max(0.5 * least, 1e-5 * greatest), 2.0 * greatest


@in_style
def trade_off(study: RideStudy) -> Figure:
    """Draw comfort over road holding (travel, if the rig has no tyre); the area of a point shows the travel.

    Better is to the lower left; lines mark the passive rig.
    """
    from jounce.ride.study import MERITS

    merits = {merit.name: merit for merit in MERITS}
    across = merits["comfort"]
    up = merits["load_coefficient" if "load_coefficient" in study.rides[0].merits else "travel"]
    figure = new_figure(5.2)
    axes = figure.subplots()
    travel = np.array([ride.merits["travel"] for ride in study.rides])
    low, high = float(travel.min()), float(max(travel.max(), travel.min() * (1.0 + 1e-9)))
    sizes = (
        _POINT_SIZE * travel / (high or 1.0)
    )  # areas: three times as large is three times the travel
    along, height, stroke = display_unit_for("m/s²"), display_unit(up.unit), display_unit("m")
    places = np.array(
        [
            (along.factor * ride.merits[across.name], height.factor * ride.merits[up.name])
            for ride in study.rides
        ]
    )
    for i in np.argsort(-sizes, kind="stable"):  # small ones on top of large ones
        is_passive = study.rides[i].control == "passive"
        x, y = places[i]
        colour = INK if is_passive else PALETTE[0]
        axes.scatter(
            x, y, sizes[i], color=colour, alpha=0.85, edgecolors="white", linewidths=0.8, zorder=3
        )
        if is_passive:
            axes.axvline(x, color=MUTED, linewidth=0.8, linestyle=":")
            axes.axhline(y, color=MUTED, linewidth=0.8, linestyle=":")
    axes.set(xlabel=along.label(across.label), ylabel=height.label(up.label))
    ends = " to ".join(f"{stroke.factor * end:.3g}" for end in (low, high))
    axes.set_title(f"Better is to the lower left; area shows travel, {ends} {stroke.name} r.m.s.")
    axes.margins(0.1)
    axes.autoscale_view()
    name_points(axes, [ride.control for ride in study.rides], places, np.sqrt(sizes / np.pi))
    return figure
