"""Pictures of hardpoints found from targets: curves before and after with the bands wanted, and sensitivities."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.display import display_unit
from jounce.plots.display import settled
from jounce.plots.style import INK, MUTED, PALETTE, new_figure, styled

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.design.kinematics import KinematicDesign, TargetResult

_COLUMNS = 3
_MOST_BARS, _MOST_TORNADOES = 8, 9
_SMALLEST_BAR = 1e-3  # of the largest
_SAID, _DARK = 0.05, 0.6
_AROUND_NAMES = 0.14  # inches: names of points are long, and measured at another resolution than they are drawn
_FARTHEST = 6.0  # tolerances beyond which a single value is drawn at the edge


@styled
def target_curves(design: KinematicDesign) -> Figure:
    """Draw every wanted curve before and after with its band, and single values in tolerances from what is wanted.

    Parameters
    ----------
    design : KinematicDesign
        What :func:`jounce.design_kinematics` found; SI, shown in usual units (mm, °).

    Returns
    -------
    matplotlib.figure.Figure
        One set of axes a curve, one for all single values.
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
    drawn = [settled(values, target.unit) * unit.factor for values in (before, after)]
    seen = np.concatenate([*drawn, *(end[np.isfinite(end)] * unit.factor for end in (low, high))])
    room = 0.08 * max(float(np.ptp(seen)), 1e-9)
    ends = float(np.min(seen)) - room, float(np.max(seen)) + room
    band = [np.clip(np.nan_to_num(end * unit.factor, posinf=ends[1], neginf=ends[0]), *ends) for end in (low, high)]
    axes.fill_between(x, *band, color=PALETTE[2], alpha=0.25, lw=0, label="wanted")
    axes.plot(x, drawn[0], color=MUTED, ls="--", label="before")
    axes.plot(x, drawn[1], color=PALETTE[0], marker=".", label="after")
    axes.set_title(unit.label(target.label) + ("" if target.met else ", missed"), loc="left")
    words = {"travel": "wheel travel", "rack": "rack travel", "roll": "roll angle"}[target.along]
    axes.set_xlabel(along.label(words))
    axes.set_ylim(*ends)


def _singles(axes: Axes, targets: list[TargetResult]) -> None:
    """Each single value as so many tolerances from what is wanted."""
    axes.axvspan(-1.0, 1.0, color=PALETTE[2], alpha=0.25, lw=0, label="wanted")
    for i, target in enumerate(targets):
        for value, colour, mark, label in (
            (target.before, MUTED, "o", "before"),
            (target.after, PALETTE[0], "D", "after"),
        ):
            off = float(np.clip(target.off(np.array([value]))[0], -_FARTHEST, _FARTHEST))
            face = "none" if label == "before" else colour
            axes.plot(off, i, marker=mark, color=colour, mfc=face, ls="none", label=label if i == 0 else None)
    axes.set_yticks(range(len(targets)), [target.label for target in targets])
    axes.set_ylim(len(targets) - 0.4, -0.6)
    axes.set_xlim(-1.08 * _FARTHEST, 1.08 * _FARTHEST)
    axes.set_xlabel(f"tolerances off (edge: {_FARTHEST:g} and more)")
    axes.set_title("single values", loc="left")


@styled
def sensitivity_bars(design: KinematicDesign) -> Figure:
    """Draw a tornado a target: what 1 mm of each coordinate changes, in tolerances, the largest effects on top.

    Parameters
    ----------
    design : KinematicDesign
        What :func:`jounce.design_kinematics` found.

    Returns
    -------
    matplotlib.figure.Figure
        One tornado a target, up to nine, each with the coordinates that matter most to it.
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
        tornado(axes, {point_name(path): per_unit * one[k] for path, one in design.sensitivity.items()})
        axes.set_title(target.label, loc="left")
    for axes in grid[len(targets) :]:
        axes.set_visible(False)
    what = f"change by 1 {unit.name} towards +x, +y, +z, in tolerances of the target (the largest over its curve)"
    figure.supxlabel(what, fontsize=9)
    return figure


def tornado(axes: Axes, effects: Mapping[str, float], most: int = _MOST_BARS) -> None:
    """Draw bars to either side, the largest on top, of what has an effect at all."""
    largest = max((abs(value) for value in effects.values()), default=0.0)
    kept = [(name, value) for name, value in effects.items() if abs(value) > _SMALLEST_BAR * largest]
    kept = sorted(kept, key=lambda one: -abs(one[1]))[:most]
    colours = [PALETTE[0] if value > 0.0 else PALETTE[1] for _, value in kept]
    axes.barh(range(len(kept)), [value for _, value in kept], color=colours, height=0.7)
    axes.axvline(0.0, color=MUTED, linewidth=0.6)
    axes.set_yticks(range(len(kept)), [name for name, _ in kept])
    axes.set_ylim(max(len(kept), 3) - 0.5, -0.5)
    axes.grid(visible=False, axis="y")


@styled
def tradeoff_matrix(design: KinematicDesign) -> Figure:
    """Draw which targets answer when one more tolerance of one is asked: blue the same way, orange the other.

    Parameters
    ----------
    design : KinematicDesign
        What :func:`jounce.design_kinematics` found.

    Returns
    -------
    matplotlib.figure.Figure
        A row what is asked more of, a column what moves.
    """
    from matplotlib.colors import LinearSegmentedColormap

    table = np.array(design.tradeoffs)
    names = [target.label for target in design.targets]
    count = len(names)
    widest = 0.075 * max(map(len, names))
    figure = new_figure(1.0 + widest + 0.34 * count, 1.9 + widest + 0.42 * count)
    axes = figure.subplots()
    colours = LinearSegmentedColormap.from_list("trade", [PALETTE[1], "white", PALETTE[0]])
    shown = axes.imshow(table, cmap=colours, vmin=-1.0, vmax=1.0)
    for i in range(count):
        for j in range(count):
            if abs(table[i, j]) >= _SAID:
                ink = "white" if abs(table[i, j]) > _DARK else INK
                text = f"{table[i, j]:.1f}".replace("-", "−")
                axes.text(j, i, text, ha="center", va="center", fontsize=7.5, color=ink)
    axes.set_xticks(range(count), names, rotation=45, ha="right", rotation_mode="anchor")
    axes.set_yticks(range(count), names)
    axes.grid(visible=False)
    axes.set_ylabel("one tolerance more of")
    axes.set_xlabel("moves")
    figure.colorbar(shown, ax=axes, shrink=0.8).set_label("by so many tolerances")
    return figure


def point_name(path: str) -> str:
    """Coordinate of a hardpoint in words: ``tie rod inner z``; of several rigs with its name before it."""
    owner, _, rest = path.rpartition("hardpoints.")
    name, axis = rest[:-3], rest[-2:-1]
    return f"{owner.rstrip('.')} {name.replace('_', ' ')} {'xyz'[int(axis)]}".strip() if axis.isdigit() else path


def design_pictures(design: KinematicDesign) -> dict[str, Callable[[], Figure]]:
    """Give what draws each picture of a design, by name."""
    from jounce.plots.mechanisms.geometry import suspension_geometry

    before = design.before()
    pictures: dict[str, Callable[[], Figure]] = {
        "targets": partial(target_curves, design),
        "sensitivity": partial(sensitivity_bars, design),
    }
    if len(design.targets) > 1:
        pictures["tradeoffs"] = partial(tradeoff_matrix, design)
    for name, rig in design.rigs.items():
        label = f"geometry-{name}" if name else "geometry"
        pictures[label] = partial(suspension_geometry, {"before": before[name], "after": rig}, title=name)
    return pictures
