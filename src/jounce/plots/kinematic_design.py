"""Figures of hardpoints designed for targets: curves before and after with target bands, and sensitivities."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.display import display_unit
from jounce.parts import Corner
from jounce.plots.display import settle
from jounce.plots.figures import INK, MUTED, PALETTE, fill_cells, in_style, new_figure
from jounce.plots.parallel import between_ends, draw_uprights

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.design.hardpoint_front import KinematicFront
    from jounce.design.kinematics import KinematicDesign, TargetResult
    from jounce.design.measured_poses import HardpointFit
    from jounce.design.spread import KinematicSpread

_COLUMNS = 3
_MOST_BARS, _MOST_TORNADOES = 8, 12
_SMALLEST_BAR = 1e-3  # of the largest
_MOST_NUMBERS = 10
_SAID, _DARK = 0.05, 0.6  # absolute values from which they are written, and written in white
_AROUND_NAMES = (
    0.14  # inches: names are long, and measured at a resolution that differs from the drawing's
)
_FARTHEST = 6.0  # tolerances beyond which a single value is drawn at the edge


@in_style
def target_curves(design: KinematicDesign) -> Figure:
    """Draw each target curve before and after with its band, and the errors of single values in tolerances.

    Parameters
    ----------
    design : KinematicDesign
        Result of :func:`jounce.design_kinematics`; SI, shown in usual units (mm, °).

    Returns
    -------
    matplotlib.figure.Figure
        One set of axes per curve, and one for all single values.
    """
    curves = [target for target in design.targets if isinstance(target.after, list)]
    single = [target for target in design.targets if not isinstance(target.after, list)]
    count = len(curves) + bool(single)
    columns = min(_COLUMNS, count)
    rows = -(-count // columns)
    tall = max(2.4, 0.9 + 0.3 * len(single)) if rows == 1 else 2.4
    figure = new_figure(0.5 + tall * rows, 3.4 * columns if columns > 1 else 5.5)
    grid = figure.subplots(rows, columns, squeeze=False).ravel()
    for axes, target in zip(grid, curves, strict=False):
        _curve(axes, target)
    if single:
        _singles(grid[len(curves)], single)
    for axes in grid[count:]:
        axes.set_visible(False)
    handles, labels = grid[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper right", ncols=3)
    return figure


def _curve(axes: Axes, target: TargetResult) -> None:
    before, after = np.array(target.before), np.array(target.after)
    unit = display_unit(target.unit, float(np.nanmax(np.abs(after))))
    along = display_unit("rad" if target.along == "roll" else "m")
    x = np.array(target.at) * along.factor
    low, high = target.bounds()
    low, high = low - target.tolerance, high + target.tolerance
    drawn = [settle(values, target.unit) * unit.factor for values in (before, after)]
    seen = np.concatenate([*drawn, *(end[np.isfinite(end)] * unit.factor for end in (low, high))])
    room = 0.08 * max(float(np.ptp(seen)), 1e-9)
    ends = float(np.min(seen)) - room, float(np.max(seen)) + room
    band = [
        np.clip(np.nan_to_num(end * unit.factor, posinf=ends[1], neginf=ends[0]), *ends)
        for end in (low, high)
    ]
    axes.fill_between(x, band[0], band[1], color=PALETTE[2], alpha=0.25, lw=0, label="wanted")
    axes.plot(x, drawn[0], color=MUTED, ls="--", label="before")
    axes.plot(x, drawn[1], color=PALETTE[0], marker=".", label="after")
    axes.set_title(unit.label(target.label) + ("" if target.met else ", missed"), loc="left")
    words = {"travel": "wheel travel", "rack": "rack travel", "roll": "roll angle"}[target.along]
    axes.set_xlabel(along.label(words))
    axes.set_ylim(*ends)


def _singles(axes: Axes, targets: list[TargetResult]) -> None:
    """Draw the distance of each single value from its target, in tolerances."""
    axes.axvspan(-1.0, 1.0, color=PALETTE[2], alpha=0.25, lw=0, label="wanted")
    for i, target in enumerate(targets):
        for value, colour, mark, label in (
            (target.before, MUTED, "o", "before"),
            (target.after, PALETTE[0], "D", "after"),
        ):
            off = float(np.clip(target.off(np.array([value]))[0], -_FARTHEST, _FARTHEST))
            face = "none" if label == "before" else colour
            axes.plot(
                off,
                i,
                marker=mark,
                color=colour,
                mfc=face,
                ls="none",
                label=label if i == 0 else None,
            )
    axes.set_yticks(range(len(targets)), [target.label for target in targets])
    axes.set_ylim(len(targets) - 0.4, -0.6)
    axes.set_xlim(-1.08 * _FARTHEST, 1.08 * _FARTHEST)
    axes.set_xlabel(f"tolerances off (edge: {_FARTHEST:g} and more)")
    axes.set_title("single values", loc="left")


@in_style
def sensitivity_bars(design: KinematicDesign) -> Figure:
    """Draw a tornado chart per target: the effect of 1 mm of each coordinate, in tolerances, largest on top.

    Parameters
    ----------
    design : KinematicDesign
        Result of :func:`jounce.design_kinematics`.

    Returns
    -------
    matplotlib.figure.Figure
        One tornado chart per target, up to twelve, each with its most influential coordinates.
    """
    targets = design.targets[:_MOST_TORNADOES]
    unit = display_unit("m")
    columns = min(_COLUMNS, len(targets))
    rows = -(-len(targets) // columns)
    figure = new_figure(0.5 + 2.5 * rows, max(3.6 * columns, 5.5))
    engine = figure.get_layout_engine()
    assert engine is not None
    engine.set(w_pad=_AROUND_NAMES)  # type: ignore[call-arg]
    grid = figure.subplots(rows, columns, squeeze=False).ravel()
    for k, (axes, target) in enumerate(zip(grid, targets, strict=False)):
        per_unit = 1.0 / (unit.factor * target.tolerance)
        tornado(
            axes,
            {
                point_name(path): per_unit * effects[k]
                for path, effects in design.sensitivity.items()
            },
        )
        axes.set_title(target.label, loc="left")
    for axes in grid[len(targets) :]:
        axes.set_visible(False)
    what = (
        f"change by 1 {unit.name} towards +x, +y, +z,\n"
        "in tolerances of the target (the largest over its curve)"
    )
    left_out = len(design.targets) - len(targets)
    figure.supxlabel(
        what + (f"\n{left_out} more targets in the table of sensitivities" if left_out else ""),
        fontsize=9,
    )
    return figure


def tornado(axes: Axes, effects: Mapping[str, float], most: int = _MOST_BARS) -> None:
    """Draw bars to both sides of zero, the largest on top; negligible effects are omitted."""
    largest = max((abs(value) for value in effects.values()), default=0.0)
    bars = [
        (name, value) for name, value in effects.items() if abs(value) > _SMALLEST_BAR * largest
    ]
    bars = sorted(bars, key=lambda bar: -abs(bar[1]))[:most]
    colours = [PALETTE[0] if value > 0.0 else PALETTE[1] for _, value in bars]
    axes.barh(range(len(bars)), [value for _, value in bars], color=colours, height=0.7)
    axes.axvline(0.0, color=MUTED, linewidth=0.6)
    axes.set_yticks(range(len(bars)), [name for name, _ in bars])
    axes.set_ylim(max(len(bars), 3) - 0.5, -0.5)
    axes.grid(visible=False, axis="y")


@in_style
def tradeoff_matrix(design: KinematicDesign) -> Figure:
    """Draw the response of all targets to one more tolerance of each: blue in the same direction, orange opposite.

    Parameters
    ----------
    design : KinematicDesign
        Result of :func:`jounce.design_kinematics`.

    Returns
    -------
    matplotlib.figure.Figure
        One row for each target that is changed, one column for each target that responds.
    """
    from matplotlib.colors import LinearSegmentedColormap

    table = np.array(design.tradeoffs)
    names = [target.label for target in design.targets]
    count = len(names)
    widest = 0.075 * max(map(len, names))
    figure = new_figure(1.0 + widest + 0.34 * count, 1.9 + widest + 0.42 * count)
    axes = figure.subplots()
    colours = LinearSegmentedColormap.from_list("trade", [PALETTE[1], "white", PALETTE[0]])
    shown = fill_cells(axes, table, colours)
    axes.set_aspect("equal")
    for i in range(count):
        for j in range(count):
            if abs(table[i, j]) >= _SAID:
                ink = "white" if abs(table[i, j]) > _DARK else INK
                text = f"{table[i, j]:.1f}".replace("-", "−")
                axes.text(j, i, text, ha="center", va="center", fontsize=7.5, color=ink)
    axes.set_xticks(range(count), names, rotation=45, ha="right", rotation_mode="anchor")
    axes.set_yticks(range(count), names)
    axes.set_ylabel("one tolerance more of")
    axes.set_xlabel("moves")
    figure.colorbar(shown, ax=axes, shrink=0.8).set_label("in tolerances")
    return figure


@in_style
def spread_bands(spread: KinematicSpread) -> Figure:
    """Draw the effect of manufacturing tolerances on each target, as built and after adjustment, and its causes.

    Parameters
    ----------
    spread : KinematicSpread
        Result of :func:`jounce.kinematic_spread`.

    Returns
    -------
    matplotlib.figure.Figure
        One row per target: bands that contain 95 % of the cars, and shares of the variance.
    """
    count = len(spread.targets)
    figure = new_figure(0.6 + 2.3 * count, 8.6)
    grid = figure.subplots(count, 2, squeeze=False, width_ratios=[1.5, 1.0])
    for (axes, causes), target in zip(grid, spread.targets, strict=True):
        unit = display_unit(target.unit, float(np.max(np.abs([*target.low, *target.high]))))
        along = display_unit("rad" if target.along == "roll" else "m")
        single = len(target.drawn) == 1
        x = np.array([-1.0, 1.0]) if single else np.array(target.at) * along.factor
        rows = {name: np.array(getattr(target, name)) * unit.factor for name in _BANDS}
        rows = {name: np.repeat(row, 2) if single else row for name, row in rows.items()}
        axes.fill_between(
            x, rows["low"], rows["high"], color=PALETTE[1], alpha=0.22, lw=0, label="as built, 95 %"
        )
        if spread.adjustments:
            ends = rows["low_adjusted"], rows["high_adjusted"]
            axes.fill_between(x, *ends, color=PALETTE[0], alpha=0.45, lw=0, label="adjusted, 95 %")
        axes.plot(x, rows["drawn"], color=INK, lw=1.1, label="as drawn")
        low, high = axes.get_ylim()
        for edge, way in ((target.wanted_low, -1.0), (target.wanted_high, 1.0)):
            if None not in edge:
                wanted = (np.array(edge, dtype=float) + way * target.tolerance) * unit.factor
                wanted = np.repeat(wanted, 2) if single else wanted
                axes.plot(
                    x,
                    wanted,
                    color=PALETTE[2],
                    ls="--",
                    lw=1.0,
                    label="wanted" if way < 0.0 else None,
                )
                low, high = min(low, float(wanted.min())), max(high, float(wanted.max()))
        axes.set_ylim(low, high)
        met = f"{100.0 * target.met:.0f} % meet it" + (
            f", adjusted {100.0 * target.met_adjusted:.0f} %" if spread.adjustments else ""
        )
        axes.set_title(f"{unit.label(target.quantity.replace('_', ' '))}: {met}", loc="left")
        if single:
            axes.set_xticks([])
        else:
            words = {"travel": "wheel travel", "rack": "rack travel", "roll": "roll angle"}[
                target.along
            ]
            axes.set_xlabel(along.label(words))
        tornado(
            causes, {name.replace("_", " "): 100.0 * share for name, share in target.causes.items()}
        )
        causes.set_title("caused by (% of the variance)", loc="left")
    handles, labels = grid[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper right", ncols=len(labels))
    return figure


_BANDS = ("drawn", "low", "high", "low_adjusted", "high_adjusted")


@in_style
def front_lines(front: KinematicFront) -> Figure:
    """Draw the designs of a front as lines over parallel axes: goals first, then the design variables.

    Parameters
    ----------
    front : KinematicFront
        Result of :func:`jounce.kinematic_front`.

    Returns
    -------
    matplotlib.figure.Figure
        Parallel coordinates, coloured by the first goal; with two competing goals also the front itself.
    """
    from matplotlib import colormaps

    goals = list(front.goals)
    moved = np.array([list(design.moved.values()) for design in front.designs])
    before = np.array(list(front.before.moved.values()))
    spans = np.max(np.abs(moved - before), axis=0)
    numbers = [k for k in np.argsort(-spans)[:_MOST_NUMBERS] if spans[k] > 0.0]
    names = [goal.replace("_", " ") for goal in goals]
    paths = list(front.before.moved)
    units = [display_unit("m" if "hardpoints." in paths[k] else "1") for k in numbers]
    names += [point_name(paths[k]) for k in numbers]
    values = np.array([list(design.goals.values()) for design in front.designs])
    table = np.hstack(
        [
            values,
            *(
                (moved[:, k : k + 1] - before[k]) * unit.factor
                for k, unit in zip(numbers, units, strict=True)
            ),
        ]
    )
    colours = colormaps["viridis"](np.linspace(0.0, 0.92, len(front.designs)))
    pair = len(goals) == 2
    figure = new_figure(4.4, (3.4 if pair else 0.0) + 1.6 + 0.85 * len(names))
    share = [3.0, max(0.8 * len(names), 3.0)] if pair else [1.0]
    grid = figure.subplots(1, len(share), squeeze=False, width_ratios=share)[0]
    if pair:
        first = grid[0]
        first.plot(*values.T, color=MUTED, lw=0.8, zorder=1.0)
        first.scatter(*values.T, c=colours, s=30, zorder=3.0)
        for k, place in enumerate(values):
            first.annotate(
                str(k + 1),
                place,
                xytext=(4, 4),
                textcoords="offset points",
                fontsize=7.5,
                color=MUTED,
            )
        first.set(xlabel=f"{names[0]} [tolerances]", ylabel=f"{names[1]} [tolerances]")
        first.set_title("goals", loc="left")
    _parallel(
        grid[-1],
        table,
        names,
        ["tolerances"] * len(goals) + [f"by {unit.name or 'SI'}" for unit in units],
        colours,
    )
    return figure


def _parallel(
    axes: Axes, table: np.ndarray, names: list[str], units: list[str], colours: np.ndarray
) -> None:
    """Draw rows as lines over vertical axes, each from its minimum to its maximum."""
    shares, ends = zip(*map(between_ends, table.T), strict=True)
    for row, colour in zip(np.array(shares).T, colours, strict=True):
        axes.plot(range(len(names)), row, color=colour, lw=1.2, alpha=0.9, zorder=2.0)
    draw_uprights(axes, ends)
    labels = [f"{name} [{unit}]" for name, unit in zip(names, units, strict=True)]
    axes.set_xticks(
        range(len(names)), labels, rotation=35, ha="right", rotation_mode="anchor", fontsize=8
    )
    axes.set_title("designs of the front" if len(table) > 1 else "the design", loc="left")


@in_style
def hardpoint_fit(fit: HardpointFit) -> Figure:
    """Draw measured quantities with the model before and after the update of its points, and the points' intervals.

    Parameters
    ----------
    fit : HardpointFit
        Result of :func:`jounce.fit_hardpoints`.

    Returns
    -------
    matplotlib.figure.Figure
        One set of axes per quantity, and one for the coordinates with their 95 % intervals.
    """
    count = len(fit.quantities) + 1
    columns = min(_COLUMNS, count)
    rows = -(-count // columns)
    figure = new_figure(0.5 + 2.5 * rows, 3.5 * columns)
    grid = figure.subplots(rows, columns, squeeze=False).ravel()
    moves = np.ptp(fit.wheel_travel) > 0.0
    over = np.array(fit.wheel_travel if moves else fit.rack_travel)
    along = display_unit("m")
    order = np.argsort(over, kind="stable")
    steered = moves and np.ptp(fit.rack_travel) > 0.0
    for axes, (name, curves) in zip(grid, fit.quantities.items(), strict=False):
        unit = display_unit(curves.unit, float(np.nanmax(np.abs(curves.measured), initial=0.0)))
        x = over[order] * along.factor
        before, after = {"ls": "--", "marker": ""}, {"ls": "-", "marker": ""}
        if steered:  # poses with several rack travels are not on a single line
            before, after = {"ls": "none", "marker": "+"}, {"ls": "none", "marker": "o"}
        for values, style in (
            (curves.before, {"color": MUTED, "label": "before", **before}),
            (curves.measured, {"color": INK, "ls": "none", "marker": ".", "label": "measured"}),
            (curves.after, {"color": PALETTE[0], "mfc": "none", "label": "after", **after}),
        ):
            axes.plot(x, np.array(values)[order] * unit.factor, **style)
        axes.set_title(unit.label(name.replace("_", " ")), loc="left")
        axes.set_xlabel(along.label("wheel travel" if moves else "rack travel"))
    axes = grid[count - 1]
    for k, (label, estimate) in enumerate(fit.numbers.items()):
        moved = (estimate.value - fit.before[label]) * along.factor
        if estimate.interval is not None:
            ends = [(end - fit.before[label]) * along.factor for end in estimate.interval]
            axes.plot(ends, [k, k], color=PALETTE[0], lw=2.0, solid_capstyle="butt")
        axes.plot(
            moved,
            k,
            "o",
            color=PALETTE[0],
            mfc="white" if estimate.interval is None else PALETTE[0],
        )
    axes.axvline(0.0, color=MUTED, lw=0.7)
    axes.set_yticks(range(len(fit.numbers)), [point_name(label) for label in fit.numbers])
    axes.set_ylim(len(fit.numbers) - 0.4, -0.6)
    axes.set_xlabel(along.label("moved by, 95 % interval"))
    for empty in grid[count:]:
        empty.set_visible(False)
    handles, labels = grid[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper right", ncols=3)
    return figure


def point_name(path: str) -> str:
    """Return a hardpoint coordinate in words: ``tie rod inner z``; with several rigs, preceded by the rig's name."""
    owner, _, rest = path.rpartition("hardpoints.")
    name, axis = rest[:-3], rest[-2:-1]
    return (
        f"{owner.rstrip('.')} {name.replace('_', ' ')} {'xyz'[int(axis)]}".strip()
        if axis.isdigit()
        else path
    )


def design_pictures(design: KinematicDesign) -> dict[str, Callable[[], Figure]]:
    """Return the functions that draw the figures of a design, by name."""
    from jounce.plots.mechanisms.geometry import suspension_geometry

    before = design.before()
    pictures: dict[str, Callable[[], Figure]] = {
        "targets": partial(target_curves, design),
        "sensitivity": partial(sensitivity_bars, design),
    }
    if len(design.targets) > 1:
        pictures["tradeoffs"] = partial(tradeoff_matrix, design)
    for name, spread in design.spread.items():
        pictures[f"spread-{name}" if name else "spread"] = partial(spread_bands, spread)
    for name, rig in design.rigs.items():
        start = before[name]
        if isinstance(rig, Corner) and isinstance(start, Corner):
            label = f"geometry-{name}" if name else "geometry"
            pictures[label] = partial(
                suspension_geometry, {"before": start, "after": rig}, title=name
            )
    return pictures
