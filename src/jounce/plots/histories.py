"""Signals over time, one set of axes per channel."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import RecordingError, nearest
from jounce.core.types import Array
from jounce.plots.display import display_unit, words_of
from jounce.plots.style import MUTED, PALETTE, limits, new_figure, styled

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_PREFERRED = ("road.z", "sprung.az", "unsprung.az", "strut.deflection", "tyre.force")
_MOST_BY_DEFAULT = 6
_NO_CONTACT = "#f2c6b5"


@styled
def time_history(run: xr.Dataset, channels: Sequence[str] | None = None) -> Figure:
    r"""Draw channels of a recording, measured or simulated, one above the other over the same time.

    Instants at which a tyre has no contact (its channel ``tyre.force`` is 0) are shaded.

    Parameters
    ----------
    run : xarray.Dataset
        A recording: channels over ``time`` in s, with ``units`` in SI. They are shown in usual units (mm, °, kN).
    channels : sequence of str, optional
        What to draw, from top to bottom; by default road, accelerations, strut deflection and tyre force where they
        exist, otherwise the first six channels.

    Returns
    -------
    matplotlib.figure.Figure
        One set of axes per channel.

    Raises
    ------
    RecordingError
        For a channel that the recording does not hold, or no channel at all.

    Examples
    --------
    >>> import jounce as jn
    >>> trial = jn.Trial(road=jn.HalfSine(height="10 mm", length="60 mm"), speed="1.95 m/s", duration="0.5 s")
    >>> figure = time_history(jn.simulate(jn.load("kart-quarter-car"), trial), ["sprung.az", "tyre.force"])
    >>> [axes.get_ylabel() for axes in figure.axes]
    ['acceleration\n[m/s²]', 'force\n[N]']
    """
    names = _chosen(run, channels)
    figure = new_figure(0.55 + 1.2 * len(names) if len(names) > 1 else 2.8)
    rows = figure.subplots(len(names), 1, sharex=True, squeeze=False)[:, 0]
    time = run["time"].to_numpy()
    shaded = False
    for name, axes in zip(names, rows, strict=True):
        values = run[name].to_numpy()
        unit = display_unit(str(run[name].attrs.get("units", "1")), float(np.abs(values).max(initial=0.0)))
        axes.plot(time, values * unit.factor, color=PALETTE[0], linewidth=1.1)
        axes.set_ylabel(unit.label(f"{words_of(name)}\n").replace("\n ", "\n"))
        axes.set_title(name)
        shaded |= _shade_lost_contact(axes, run, name, time, labelled=not shaded)
    limits(rows[0], float(time[0]), float(time[-1]))
    rows[-1].set_xlabel("time [s]")
    if shaded:
        first = next(axes for axes in rows if axes.get_legend_handles_labels()[0])
        handles = first.get_legend_handles_labels()[0]
        rows[0].legend(handles=handles, loc="lower right", bbox_to_anchor=(1.0, 1.0), labelcolor=MUTED)
    figure.align_ylabels(rows)
    return figure


def _chosen(run: xr.Dataset, channels: Sequence[str] | None) -> list[str]:
    present = [str(name) for name in run.data_vars if run[name].dims == ("time",)]
    if channels is None:
        channels = [name for name in _PREFERRED if name in present] or present[:_MOST_BY_DEFAULT]
    if not channels:
        raise RecordingError("no channel over time to draw", found=", ".join(map(str, run.data_vars)) or "nothing")
    for name in channels:
        if name not in present:
            raise RecordingError(
                f"no channel {name!r}", where="plot", allowed=", ".join(present), hint=nearest(name, present)
            )
    return list(channels)


def _shade_lost_contact(axes: Axes, run: xr.Dataset, name: str, time: Array, *, labelled: bool) -> bool:
    """Shade where the channel's own tyre (or, for channels without a corner, any tyre) carries nothing."""
    corner = name.partition(".")[0]
    tyres = [str(other) for other in run.data_vars if str(other).endswith("tyre.force")]
    own = [other for other in tyres if other.startswith(f"{corner}.")] if corner != "tyre" else []
    lost = np.zeros(len(time), dtype=bool)
    for other in own or tyres:
        lost |= run[other].to_numpy() == 0.0
    for k, (begin, end) in enumerate(stretches(lost)):
        label = "no contact" if labelled and k == 0 else None
        axes.axvspan(time[begin], time[end], color=_NO_CONTACT, linewidth=0.0, alpha=0.7, zorder=0, label=label)
    return bool(lost.any())


def stretches(condition: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """First and last index of each stretch in which a condition, shape (n,), holds.

    Examples
    --------
    >>> stretches(np.array([False, True, True, False, True]))
    [(1, 2), (4, 4)]
    """
    edges = np.flatnonzero(np.diff(np.concatenate([[0], condition.astype(np.int8), [0]])))
    return [(int(begin), int(end) - 1) for begin, end in zip(edges[::2], edges[1::2], strict=True)]
