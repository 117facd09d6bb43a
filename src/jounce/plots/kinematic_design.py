"""Pictures of hardpoints found from targets: curves before and after with the bands wanted, and sensitivities."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from jounce.core.display import display_unit
from jounce.plots.display import settled
from jounce.plots.style import MUTED, PALETTE, new_figure, styled

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.design.kinematics import KinematicDesign, TargetResult

_COLUMNS = 3
_MOST_BARS = 14
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
    low, high = _band(target, len(after))
    axes.fill_between(x, low * unit.factor, high * unit.factor, color=PALETTE[2], alpha=0.25, lw=0, label="wanted")
    axes.plot(x, settled(before, target.unit) * unit.factor, color=MUTED, ls="--", label="before")
    axes.plot(x, settled(after, target.unit) * unit.factor, color=PALETTE[0], marker=".", label="after")
    axes.set_title(unit.label(target.quantity.replace("_", " ")) + ("" if target.met else ", missed"), loc="left")
    words = {"travel": "wheel travel", "rack": "rack travel", "roll": "roll angle"}[target.along]
    axes.set_xlabel(along.label(words))
    seen = np.concatenate([before, after, low[np.isfinite(low)], high[np.isfinite(high)]]) * unit.factor
    room = 0.08 * max(float(np.ptp(seen)), 1e-9)
    axes.set_ylim(float(np.min(seen)) - room, float(np.max(seen)) + room)


def _band(target: TargetResult, count: int) -> tuple[np.ndarray, np.ndarray]:
    wanted = target.wanted
    if isinstance(wanted, list) and len(wanted) == 2 and _is_limit(target, count):
        low, high = wanted
    else:
        low = high = wanted
    ends = [
        np.full(count, fallback) if end is None else np.broadcast_to(np.array(end, dtype=float), (count,))
        for end, fallback in ((low, -1e9), (high, 1e9))
    ]
    return ends[0] - target.tolerance, ends[1] + target.tolerance


def _is_limit(target: TargetResult, count: int) -> bool:
    return count != 2 or None in target.wanted


def _singles(axes: Axes, targets: list[TargetResult]) -> None:
    """Each single value as so many tolerances from what is wanted."""
    axes.axvspan(-1.0, 1.0, color=PALETTE[2], alpha=0.25, lw=0, label="wanted")
    for i, target in enumerate(targets):
        for value, colour, mark, label in (
            (target.before, MUTED, "o", "before"),
            (target.after, PALETTE[0], "D", "after"),
        ):
            off = float(np.clip(_off(target, float(value)), -_FARTHEST, _FARTHEST))  # type: ignore[arg-type]
            face = "none" if label == "before" else colour
            axes.plot(off, i, marker=mark, color=colour, mfc=face, ls="none", label=label if i == 0 else None)
    axes.set_yticks(range(len(targets)), [target.quantity.replace("_", " ") for target in targets])
    axes.set_ylim(len(targets) - 0.4, -0.6)
    axes.set_xlim(-1.08 * _FARTHEST, 1.08 * _FARTHEST)
    axes.set_xlabel(f"tolerances off (edge: {_FARTHEST:g} and more)")
    axes.set_title("single values", loc="left")


def _off(target: TargetResult, value: float) -> float:
    if isinstance(target.wanted, list):
        low, high = target.wanted
        over = value - high if high is not None and value > high else 0.0
        under = value - low if low is not None and value < low else 0.0
        return (over + under) / target.tolerance
    return (value - float(target.wanted)) / target.tolerance


@styled
def sensitivity_bars(design: KinematicDesign) -> Figure:
    """Draw what 1 mm of the coordinates that matter most changes of each target, in its tolerances.

    Parameters
    ----------
    design : KinematicDesign
        What :func:`jounce.design_kinematics` found.

    Returns
    -------
    matplotlib.figure.Figure
        One set of bars a target, up to six; coordinates by their largest effect.
    """
    targets = design.targets[:6]
    paths = list(design.sensitivity)
    unit = display_unit("m")
    effects = np.array([design.sensitivity[path][: len(targets)] for path in paths])
    effects = effects / unit.factor / np.array([target.tolerance for target in targets])
    order = np.argsort(-np.max(np.abs(effects), axis=1))[:_MOST_BARS]
    order = order[np.max(np.abs(effects[order]), axis=1) > 0.0]
    figure = new_figure(1.0 + 0.24 * len(order), 2.2 + 1.9 * len(targets))
    grid = figure.subplots(1, len(targets), sharey=True, squeeze=False)[0]
    names = [_point(paths[i]) for i in order]
    for k, (axes, target) in enumerate(zip(grid, targets, strict=True)):
        axes.barh(range(len(order)), effects[order, k], color=PALETTE[0], height=0.7)
        axes.axvline(0.0, color=MUTED, linewidth=0.6)
        axes.set_title(target.quantity.replace("_", " "), loc="left")
    grid[0].set_yticks(range(len(order)), names)
    grid[0].set_ylim(len(order) - 0.5, -0.5)
    figure.supxlabel(f"change by 1 {unit.name}, in tolerances of the target (the largest over its curve)", fontsize=9)
    return figure


def _point(path: str) -> str:
    name, axis = path.removeprefix("hardpoints.")[:-3], path[-2]
    return f"{name.replace('_', ' ')} {'xyz'[int(axis)]}"
