"""Linear models: frequency responses and modes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.errors import SimulationError, nearest
from jounce.plots.display import display_unit, number, words_of
from jounce.plots.style import AFTER, PALETTE, new_figure, styled
from jounce.recordings.schema import QUANTITIES, quantity_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from jounce.simulation import LinearModel, Mode


@styled
def frequency_response(
    model: LinearModel,
    outputs: Sequence[str] = ("sprung.az", "tyre.force"),
    frequency: ArrayLike | None = None,
    track: str = "road.z",
) -> Figure:
    r"""Draw magnitude and phase of outputs for a harmonic road.

    Parameters
    ----------
    model : LinearModel
        Rig linearised about static equilibrium.
    outputs : sequence of str
        Channels.
    frequency : array (n,), optional
        Hz; by default 0.1 to 100 Hz.
    track : str
        The input.

    Returns
    -------
    matplotlib.figure.Figure
        Per output: magnitude per mm of input and phase (°) against frequency (Hz).

    Raises
    ------
    SimulationError
        For an output that the model does not have.

    Examples
    --------
    >>> import jounce as jn
    >>> figure = frequency_response(jn.linearise(jn.load("kart-quarter-car")), ["sprung.z"])
    >>> [axes.get_ylabel() for axes in figure.axes]
    ['position\nper road.z [mm/mm]', 'phase [°]']
    """
    for name in outputs:
        if name not in model.outputs:
            raise SimulationError(
                f"no output {name!r}", allowed=", ".join(model.outputs), hint=nearest(name, model.outputs)
            )
    f = np.geomspace(0.1, 100.0, 1200) if frequency is None else np.asarray(frequency, float)
    figure = new_figure(3.6, 3.9 * max(1, len(outputs)) if len(outputs) < 3 else 3.0 * len(outputs))
    grid = figure.subplots(2, len(outputs), sharex=True, squeeze=False, gridspec_kw={"height_ratios": [2.2, 1.0]})
    for column, name in enumerate(outputs):
        response = model.frequency_response(f, name, track)
        known = quantity_of(name)
        unit = display_unit(QUANTITIES[known][0] if known else "1")
        top, bottom = grid[:, column]
        top.loglog(f, np.abs(response) * unit.factor * 1e-3, color=PALETTE[0])
        bottom.semilogx(f, np.degrees(np.unwrap(np.angle(response))), color=PALETTE[0])
        top.set(ylabel=f"{words_of(name)}\nper {track} [{_per_mm(unit.name)}]", title=name)
        bottom.set(xlabel="frequency [Hz]", ylabel="phase [°]", xlim=(float(f[0]), float(f[-1])))
    return figure


def _per_mm(unit: str) -> str:
    return f"({unit})/mm" if "/" in unit else f"{unit or '1'}/mm"


@styled
def modes(found: Sequence[Mode]) -> Figure:
    """Draw the shapes of the modes of a rig as bars: real part of each coordinate, the largest being 1.

    Parameters
    ----------
    found : sequence of Mode
        Modes by rising frequency.

    Returns
    -------
    matplotlib.figure.Figure
        One set of axes per mode, with frequency (Hz) and damping ratio.

    Examples
    --------
    >>> import jounce as jn
    >>> len(modes(jn.modes(jn.load("kart-quarter-car"))).axes)
    2
    """
    if not found:
        raise SimulationError("no oscillating mode to draw")
    figure = new_figure(2.2 + 0.18 * len(found[0].shape), min(2.6 * len(found) + 1.2, 10.0))
    row = figure.subplots(1, len(found), sharey=True, squeeze=False)[0]
    for mode, axes in zip(found, row, strict=True):
        names = list(mode.shape)
        axes.barh(range(len(names)), [mode.shape[name][0] for name in names], 0.5, color=AFTER)
        axes.axvline(0.0, color="#9aa1a9", linewidth=0.8)
        axes.set_yticks(range(len(names)), names)
        axes.set_xlim(-1.15, 1.15)
        axes.grid(axis="y", visible=False)
        axes.set(xlabel="relative motion [–]")
        axes.set_title(f"{number(mode.frequency_hz, 3)} Hz, damping ratio {number(mode.damping_ratio, 2)}", fontsize=9)
    return figure
