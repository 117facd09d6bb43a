"""Figures of signals over time, studies over one variable, roads, frequency responses, and modes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from jounce.core.display import display_unit, display_unit_for
from jounce.core.errors import RecordingError, SimulationError, nearest
from jounce.core.old_names import old_argument
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.plots.display import number, words_of
from jounce.plots.figures import (
    AFTER,
    MUTED,
    PALETTE,
    in_legend,
    in_style,
    legend_above,
    limits,
    log_axes,
    new_figure,
)
from jounce.plots.thinning import thin
from jounce.recordings.schema import QUANTITIES, quantity_of

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.core.segments import Segments
    from jounce.roads import Road
    from jounce.roughness.iri import Roughness
    from jounce.simulation import LinearModel, Mode


MOST_COLUMNS = 4000
"""Number of columns, more than any printed figure resolves; in longer records each column keeps its peaks."""
PREFERRED = (
    ("road.z",),
    ("body.az", "sprung.az"),
    ("unsprung.az",),
    ("strut.deflection",),
    ("tyre.force",),
)
"""Quantities shown by default, each with its alternatives."""
_MOST_BY_DEFAULT = 6
_NO_CONTACT = "#f2c6b5"


def preferred_channels(
    present: Sequence[str], quantities: Sequence[Sequence[str]], least: int
) -> list[str]:
    """Return the channels of some quantities at all axles and corners: whole groups, until there are enough.

    Of the alternatives of a quantity, the first that is present counts. The road is shown at its first place.

    >>> names = ["front.road.z", "rear.road.z", "body.az", "front.tyre.force", "rear.tyre.force"]
    >>> preferred_channels(names, PREFERRED, 4)
    ['front.road.z', 'body.az', 'front.tyre.force', 'rear.tyre.force']
    """
    chosen: list[str] = []
    for ends in quantities:
        groups = ([c for c in present if c == end or c.endswith(f".{end}")] for end in ends)
        group = next((names for names in groups if names), [])
        chosen += group[:1] if "road.z" in ends else group
        if len(chosen) >= least:
            break
    return chosen


@in_style
def time_history(run: xr.Dataset, channels: Sequence[str] | None = None) -> Figure:
    r"""Draw channels of a measured or simulated recording in stacked axes over a common time.

    Times without tyre contact (``tyre.force`` is 0) are shaded.

    Parameters
    ----------
    run : xarray.Dataset
        A recording: channels over ``time`` in s, with ``units`` in SI; shown in usual units (mm, °, kN).
    channels : sequence of str, optional
        Channels to draw, from top to bottom; by default road, accelerations, strut deflection and tyre force if they
        exist, otherwise the first six channels.

    Returns
    -------
    matplotlib.figure.Figure
        One set of axes per channel.

    Raises
    ------
    RecordingError
        For a channel missing in the recording, or a recording without channels.

    Examples
    --------
    >>> import jounce as jn
    >>> trial = jn.Trial(road=jn.HalfSine(height="10 mm", length="60 mm"), speed="1.95 m/s", duration="0.5 s")
    >>> figure = time_history(jn.simulate(jn.load("kart-quarter-car"), trial), ["sprung.az", "tyre.force"])
    >>> [axes.get_ylabel() for axes in figure.axes]
    ['acceleration\n[m/s²]', 'force\n[N]']
    """
    names = _choose_channels(run, channels)
    figure = new_figure(0.55 + 1.2 * len(names) if len(names) > 1 else 2.8)
    rows = figure.subplots(len(names), 1, sharex=True, squeeze=False)[:, 0]
    time = run["time"].to_numpy()
    shaded = False
    for name, axes in zip(names, rows, strict=True):
        values = run[name].to_numpy()
        unit = display_unit(
            str(run[name].attrs.get("units", "1")), float(np.abs(values).max(initial=0.0))
        )
        few, shown = thin(time, values, float(time[0]), float(time[-1]), MOST_COLUMNS)
        axes.plot(few, shown * unit.factor, color=PALETTE[0], linewidth=1.1)
        axes.set_ylabel(unit.label(f"{words_of(name)}\n").replace("\n ", "\n"))
        axes.set_title(name)
        shaded |= _shade_lost_contact(axes, run, name, time, labelled=not shaded)
    limits(rows[0], float(time[0]), float(time[-1]))
    rows[-1].set_xlabel("time [s]")
    if shaded:
        first = next(axes for axes in rows if axes.get_legend_handles_labels()[0])
        handles = first.get_legend_handles_labels()[0]
        rows[0].legend(
            handles=handles, loc="lower right", bbox_to_anchor=(1.0, 1.0), labelcolor=MUTED
        )
    figure.align_ylabels(rows)
    return figure


def _choose_channels(run: xr.Dataset, channels: Sequence[str] | None) -> list[str]:
    present = [str(name) for name in run.data_vars if run[name].dims == ("time",)]
    if channels is None:
        channels = preferred_channels(present, PREFERRED, _MOST_BY_DEFAULT - 1)
        channels = channels or present[:_MOST_BY_DEFAULT]
    if not channels:
        raise RecordingError(
            "no time-dependent channel to draw",
            found=", ".join(map(str, run.data_vars)) or "nothing",
        )
    for name in channels:
        if name not in present:
            raise RecordingError(
                Phrase("no channel {name!r}", name=name),
                where="plot",
                allowed=", ".join(present),
                hint=nearest(name, present),
            )
    return list(channels)


def _shade_lost_contact(
    axes: Axes, run: xr.Dataset, name: str, time: Array, *, labelled: bool
) -> bool:
    """Shade times at which the channel's own tyre (or, for channels without a corner, any tyre) carries no load."""
    corner = name.partition(".")[0]
    tyres = [str(other) for other in run.data_vars if str(other).endswith("tyre.force")]
    own = [other for other in tyres if other.startswith(f"{corner}.")] if corner != "tyre" else []
    lost = np.zeros(len(time), dtype=bool)
    for other in own or tyres:
        lost |= run[other].to_numpy() == 0.0
    for k, (begin, end) in enumerate(stretches(lost)):
        label = "no contact" if labelled and k == 0 else None
        axes.axvspan(
            time[begin],
            time[end],
            color=_NO_CONTACT,
            linewidth=0.0,
            alpha=0.7,
            zorder=0,
            label=label,
        )
    return bool(lost.any())


def stretches(condition: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Return the first and last index of each run of True values in a condition, shape (n,).

    Examples
    --------
    >>> stretches(np.array([False, True, True, False, True]))
    [(1, 2), (4, 4)]
    """
    edges = np.flatnonzero(np.diff(np.concatenate([[0], condition.astype(np.int8), [0]])))
    return [(int(begin), int(end) - 1) for begin, end in zip(edges[::2], edges[1::2], strict=True)]


@in_style
def sweep(
    results: xr.Dataset, variables: Sequence[str] | None = None, along: str = "speed"
) -> Figure:
    r"""Draw the variables of a study against the varied quantity.

    Parameters
    ----------
    results : xarray.Dataset
        Variables over the coordinate ``along``; a second dimension (e.g. obstacle pitch) becomes one line per value.
        Units in SI are taken from ``units``, names from ``long_name``.
    variables : sequence of str, optional
        Variables to draw, one set of axes each; by default the first six.
    along : str
        Name of the varied coordinate.

    Returns
    -------
    matplotlib.figure.Figure
        One set of axes per variable over the same coordinate.

    Raises
    ------
    RecordingError
        For a missing coordinate or an unknown variable.

    Examples
    --------
    >>> import xarray as xr
    >>> speed = ("speed", [1.0, 2.0], {"units": "m/s"})
    >>> peak = ("speed", [0.004, 0.006], {"units": "m", "long_name": "largest displacement"})
    >>> sweep(xr.Dataset({"peak": peak}, coords={"speed": speed})).axes[0].get_ylabel()
    'largest displacement\n[mm]'
    """
    if along not in results.coords:
        raise RecordingError(
            Phrase("no coordinate {along!r}", along=along),
            found=", ".join(map(str, results.coords)) or "none",
        )
    present = [
        str(name)
        for name in results.data_vars
        if along in results[name].dims and results[name].ndim <= 2
    ]
    for name in variables or ():
        if name not in present:
            raise RecordingError(
                Phrase("no variable {name!r}", name=name),
                allowed=", ".join(present),
                hint=nearest(name, present),
            )
    names = list(variables or present[:_MOST_BY_DEFAULT])
    if not names:
        raise RecordingError(
            Phrase("no variable over {along!r} to draw", along=along),
            found=", ".join(map(str, results.data_vars)),
        )
    figure = new_figure(0.7 + 1.6 * len(names) if len(names) > 1 else 3.0)
    rows = figure.subplots(len(names), 1, sharex=True, squeeze=False)[:, 0]
    for name, axes in zip(names, rows, strict=True):
        _draw_variable(axes, results[name], along)
    if rows[0].get_legend_handles_labels()[0]:
        legend_above(rows[0], 5)
    words = str(results[along].attrs.get("long_name", along)).replace("_", " ")
    rows[-1].set_xlabel(display_unit(_unit(results[along])).label(words))
    figure.align_ylabels(rows)
    return figure


def _draw_variable(axes: Axes, variable: xr.DataArray, along: str) -> None:
    across = [dimension for dimension in variable.dims if dimension != along]
    unit = display_unit(_unit(variable), float(np.nanmax(np.abs(variable.to_numpy()), initial=0.0)))
    x = variable[along].to_numpy() * display_unit(_unit(variable[along])).factor
    mark = "." if len(x) < 60 else None
    if not across:
        axes.plot(x, variable.to_numpy() * unit.factor, color=PALETTE[0], marker=mark)
    else:
        lines = variable.transpose(along, across[0])
        for k, value in enumerate(lines[across[0]].to_numpy()):
            axes.plot(
                x,
                lines[:, k].to_numpy() * unit.factor,
                color=PALETTE[k % len(PALETTE)],
                marker=mark,
                label=in_legend(_value(lines[across[0]], value)),
            )
    axes.set_ylabel(
        unit.label(f"{variable.attrs.get('long_name', variable.name)}\n").replace("\n ", "\n")
    )


def _unit(variable: xr.DataArray) -> str:
    return str(variable.attrs.get("units", "1"))


def _value(coordinate: xr.DataArray, value: Any) -> str:
    if isinstance(value, str):
        return value
    unit = display_unit(_unit(coordinate))
    words = str(coordinate.attrs.get("long_name", coordinate.name)).replace("_", " ")
    return f"{words} {unit.behind(number(float(value) * unit.factor, 3))}"


_POINTS = 6000


@in_style
def road_profile(roads: Road | Mapping[str, Road], distance: float | None = None) -> Figure:
    """Draw the height of one or several roads against distance.

    Parameters
    ----------
    roads : Road or mapping of str to Road
        One road, or several by name; several are drawn in stacked axes over the same distance.
    distance : float, optional
        End of the distance axis, m; by default slightly beyond the end of the longest road.

    Returns
    -------
    matplotlib.figure.Figure
        Height (mm) against distance (m).

    Examples
    --------
    >>> import jounce as jn
    >>> road_profile(jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m")).axes[0].get_xlabel()
    'distance [m]'
    """
    named = dict(roads) if isinstance(roads, Mapping) else {"": roads}
    figure = new_figure(2.4 if len(named) == 1 else 0.5 + 0.95 * len(named))
    rows = figure.subplots(len(named), 1, sharex=True, sharey=True, squeeze=False)[:, 0]
    ends = {name: road.end() for name, road in named.items()}
    reach = distance if distance is not None else 1.08 * max(*ends.values(), 1e-3)
    across, up = display_unit_for("m", largest=reach), display_unit("m")
    for (name, road), axes in zip(named.items(), rows, strict=True):
        x, height = sample_segments(road.segments(reach))
        if height.min() >= 0.0:
            axes.fill_between(
                across.factor * x, up.factor * height, 0.0, color="#cfd6dc", linewidth=0.0
            )
        axes.plot(across.factor * x, up.factor * height, color=PALETTE[0], linewidth=1.1)
        axes.set_title(name)
        axes.set_ylabel(up.label("height" if len(named) == 1 else "height\n").replace("\n ", "\n"))
        axes.margins(y=0.15)
    begin = min(road.start for road in named.values()) if distance is None else 0.0
    rows[0].set_xlim(
        across.factor * max(0.0, begin - 0.08 * (reach - begin)), across.factor * reach
    )
    rows[-1].set_xlabel(across.label("distance"))
    figure.align_ylabels(rows)
    return figure


def sample_segments(segments: Segments) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Sample closed-form pieces: coordinate (m or s) and height (m), shape (n,); jumps are vertical."""
    count = max(2, min(60, _POINTS // len(segments.kind)))
    share = np.linspace(0.0, 1.0, count)
    share[-1] = 1.0 - 1e-9  # still on this piece: an edge belongs to the next one
    x = (segments.edges[:-1, None] + np.diff(segments.edges)[:, None] * share).ravel()
    return x, segments.evaluate(x)[0]


@in_style
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
                Phrase("no output {name!r}", name=name),
                allowed=", ".join(model.outputs),
                hint=nearest(name, model.outputs),
            )
    from matplotlib.ticker import MultipleLocator

    f = np.geomspace(0.1, 100.0, 1200) if frequency is None else np.asarray(frequency, float)
    figure = new_figure(3.6, 3.9 * max(1, len(outputs)) if len(outputs) < 3 else 3.0 * len(outputs))
    grid = figure.subplots(
        2, len(outputs), sharex=True, squeeze=False, gridspec_kw={"height_ratios": [2.2, 1.0]}
    )
    road = display_unit("m")
    for column, name in enumerate(outputs):
        response = model.frequency_response(f, name, track)
        known = quantity_of(name)
        unit = display_unit(QUANTITIES[known][0] if known else "1")
        per = (
            f"({unit.name})/{road.name}" if "/" in unit.name else f"{unit.name or '1'}/{road.name}"
        )
        top, bottom = grid[:, column]
        top.plot(f, np.abs(response) * unit.factor / road.factor, color=PALETTE[0])
        log_axes(top)
        log_axes(bottom, "x")
        top.set(ylabel=f"{words_of(name)}\nper {track} [{per}]", title=name)
        turned = np.degrees(np.unwrap(np.angle(response)))
        bottom.plot(f, turned, color=PALETTE[0])
        bottom.yaxis.set_major_locator(
            MultipleLocator(90.0 * max(1, round(float(np.ptp(turned)) / 270.0)))
        )
        bottom.set(xlabel="frequency [Hz]", ylabel="phase [°]", xlim=(float(f[0]), float(f[-1])))
    return figure


@in_style
def roughness(profile: Roughness, distance: Array, height: Array) -> Figure:
    """Draw a profile and the international roughness index of each of its segments.

    Parameters
    ----------
    profile : Roughness
        Result of :func:`jounce.iri`, m/km.
    distance, height : ndarray, shape (n,)
        The profile, m.

    Returns
    -------
    matplotlib.figure.Figure
        The profile above, and a bar for each segment below; dashed: the whole profile.

    Examples
    --------
    >>> import jounce as jn
    >>> x = np.arange(0.0, 50.0, 0.05)
    >>> z = 0.005 * np.sin(x)
    >>> [axes.get_ylabel() for axes in roughness(jn.iri(x, z, segment="10 m"), x, z).axes]
    ['height [mm]', 'IRI [m/km]']
    """
    figure = new_figure(3.8)
    above, below = figure.subplots(2, 1, sharex=True)
    unit = display_unit("m", float(np.abs(height).max(initial=0.0)))
    few, shown = thin(distance, height, float(distance[0]), float(distance[-1]), MOST_COLUMNS)
    along, index = display_unit_for("m", largest=float(distance[-1])), display_unit("m/km")
    above.plot(few * along.factor, shown * unit.factor, color=PALETTE[0], linewidth=0.9)
    above.set_ylabel(unit.label("height"))
    starts = [along.factor * part.start for part in profile.segments]
    widths = [along.factor * (part.end - part.start) for part in profile.segments]
    values = [index.factor * part.iri_m_per_km for part in profile.segments]
    below.bar(starts, values, widths, align="edge", color=AFTER, edgecolor="white", linewidth=0.8)
    below.axhline(index.factor * profile.iri_m_per_km, color=MUTED, linewidth=1.0, linestyle="--")
    below.set(ylabel=index.label("IRI"), xlabel=along.label("distance"))
    limits(below, along.factor * float(distance[0]), along.factor * float(distance[-1]))
    return figure


_MODES_ACROSS = 4


@in_style
@old_argument("found", "natural_modes")
def modes(natural_modes: Sequence[Mode]) -> Figure:
    """Draw the mode shapes of a rig as bars: real part of each coordinate, scaled to a maximum of 1.

    Parameters
    ----------
    natural_modes : sequence of Mode
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
    if not natural_modes:
        raise SimulationError("no oscillating mode to draw")
    names = list(natural_modes[0].shape)
    across = min(len(natural_modes), _MODES_ACROSS)
    down = -(-len(natural_modes) // across)
    figure = new_figure(down * (1.6 + 0.18 * len(names)) + 0.6, min(2.2 * across + 1.4, 10.0))
    grid = figure.subplots(down, across, sharex=True, sharey=True, squeeze=False).ravel()
    for mode, axes in zip(natural_modes, grid, strict=False):
        axes.barh(range(len(names)), [mode.shape[name][0] for name in names], 0.5, color=AFTER)
        axes.axvline(0.0, color="#9aa1a9", linewidth=0.8)
        axes.set_yticks(range(len(names)), names)
        axes.set_xlim(-1.15, 1.15)
        axes.grid(axis="y", visible=False)
        axes.set_ylim(len(names) - 0.4, -0.6)  # in order from the top
        axes.set_title(
            f"{number(mode.frequency_hz, 3)} Hz\ndamping ratio {number(mode.damping_ratio, 2)}",
            fontsize=9,
        )
    for empty, above in zip(
        grid[len(natural_modes) :], grid[len(natural_modes) - across :], strict=False
    ):
        empty.remove()
        above.tick_params(labelbottom=True)
    # Displacements and angles of a shape share an axis in SI, so a short bar is not always a small motion.
    figure.supxlabel("shape: displacements in m, angles in rad, the largest of all 1", fontsize=9)
    return figure
