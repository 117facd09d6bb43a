"""Curves of paper 2: half car over obstacle and pothole (figures 12 to 16), corner on its exciter (figure 8)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from jounce.core.display import DisplayUnit, display_unit, display_unit_for
from jounce.core.errors import RecordingError, nearest
from jounce.core.phrases import Phrase
from jounce.papers.audi_a6_paper import FREE_LENGTH, READ_LENGTH
from jounce.plots.display import quantity
from jounce.plots.figures import INK, MUTED, PALETTE, in_style, legend_above, new_figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from jounce.papers.audi_a6 import AudiCase, CaseRun
    from jounce.papers.audi_a6_exciter import EccentricExciter

_QUANTITIES = {
    "bounce.displacement": ("bounce", "mm", 1e3),
    "pitch.angle": ("pitch", "mrad", 1e3),
    "front.force": ("front force", "kN", 1e-3),
    "rear.force": ("rear force", "kN", 1e-3),
    "front.road.z": ("road, front", "mm", 1e3),
    "rear.road.z": ("road, rear", "mm", 1e3),
    "pitch.moment": ("moment", "N·m", 1.0),
}
_LINES: dict[str, dict[str, Any]] = {
    "simulink": {"color": PALETTE[1], "linestyle": (0, (4, 1.6)), "zorder": 3},
    "sign-corrected": {"color": PALETTE[0], "linestyle": "-", "zorder": 2},
    "physical": {"color": PALETTE[2], "linestyle": "-", "zorder": 1.9},
}
_MODELS: dict[str, dict[str, Any]] = {
    "summed": {"color": PALETTE[1], "linestyle": "-", "zorder": 2},
    "series": {"color": PALETTE[4], "linestyle": (0, (2.5, 2.5)), "zorder": 3},
    "two-mass": {"color": PALETTE[0], "linestyle": "-", "zorder": 2},
}
_BEGIN, _END = 2.5, 10.0  # s: range shown
_EVENTS = (3.0, 6.0, 8.0)  # s: start of the moment, start and end of the obstacle, as in the paper
_TURNS = 0.4  # s: two turns of the exciter


@in_style
def case_curve(study: AudiCase, channel: str = "bounce.displacement") -> Figure:
    r"""Draw one signal of a case (mm, mrad, kN): one set of axes for each moment, one line for each variant.

    Examples
    --------
    >>> from jounce.papers.audi_a6 import run_audi_a6
    >>> figure = case_curve(run_audi_a6("case-a"), "pitch.angle")
    >>> [axes.get_ylabel() for axes in figure.axes]
    ['pitch\n[mrad]', 'pitch\n[mrad]']
    """
    if channel not in _QUANTITIES:
        raise RecordingError(
            Phrase("no channel {channel!r}", channel=channel),
            allowed=", ".join(_QUANTITIES),
            hint=nearest(channel, list(_QUANTITIES)),
        )
    by_moment = {
        run.moment: [other for other in study.runs if other.moment == run.moment]
        for run in study.runs
    }
    figure = new_figure(0.7 + 2.3 * len(by_moment))
    rows = figure.subplots(len(by_moment), 1, sharex=True, squeeze=False)[:, 0]
    for axes, (moment, runs) in zip(rows, by_moment.items(), strict=True):
        _draw(axes, runs, channel)
        axes.set_title(f"pitch moment {quantity(moment, 'N*m')} from 3 s on")
    _finish(figure, list(rows))
    return figure


@in_style
def case_overview(study: AudiCase, moment: float) -> Figure:
    """Draw all signals of the runs with one pitch moment (N m): bounce, pitch, forces, road and moment."""
    runs = [run for run in study.runs if run.moment == moment]
    if not runs:
        allowed = ", ".join(f"{value:g}" for value in sorted({run.moment for run in study.runs}))
        raise RecordingError("no run with this torque", found=f"{moment:g} N m", allowed=allowed)
    figure = new_figure(8.4)
    rows = figure.subplots(len(_QUANTITIES), 1, sharex=True)
    for axes, channel in zip(rows, _QUANTITIES, strict=True):
        _draw(axes, runs, channel)
    _finish(figure, list(rows))
    return figure


@in_style
def start_up_transient(study: AudiCase) -> Figure:
    """Draw the transient of the paper's vehicle (mm) from the initial state of the demo to its equilibrium."""
    start_up = study.start_up
    figure = new_figure(2.6)
    axes = figure.subplots()
    unit = display_unit("m")
    axes.plot(start_up.signals["time"], unit.factor * start_up.signals["body.z"], color=PALETTE[0])
    for value, text, above in (
        (start_up.initial, "initial state of the demo", -10),
        (start_up.equilibrium, "equilibrium", 4),
    ):
        axes.axhline(unit.factor * value, color=MUTED, linewidth=0.8, linestyle=(0, (3, 2)))
        note = f"{text}: {quantity(value, 'm', 3)}"
        axes.annotate(
            note, (1.0, unit.factor * value), (-2, above), xycoords=("axes fraction", "data"),
            textcoords="offset points", ha="right", color=MUTED, fontsize=8.5,
        )  # fmt: skip
    axes.set(
        xlabel="time [s]",
        ylabel=unit.label("height of the body"),
        xlim=(0.0, float(start_up.signals["time"][-1])),
    )
    return figure


@in_style
def exciter_spring(study: EccentricExciter, duration: float = 3.0) -> Figure:
    """Draw plate, spring length (mm) and spring force (kN) over time for all models of the corner on its exciter."""
    figure = new_figure(6.4)
    rows = figure.subplots(3, 1, sharex=True, gridspec_kw={"height_ratios": [0.5, 1.6, 1.2]})
    length_unit, force = display_unit("m"), display_unit_for("kN")
    plate = study.runs[0].signals.isel(time=study.runs[0].signals["time"] <= duration)
    rows[0].plot(plate["time"], length_unit.factor * plate["plate.z"], color=INK, linewidth=0.9)
    for run in study.runs:
        part = run.signals.isel(time=run.signals["time"] <= duration)
        style = {"label": run.variant, **_MODELS[run.variant]}
        rows[1].plot(part["time"], length_unit.factor * part["spring.length"], **style)
        rows[2].plot(part["time"], 1e-3 * force.factor * part["spring.force"], **style)
    for length in (FREE_LENGTH, READ_LENGTH):
        rows[1].axhline(
            length_unit.factor * length, color=MUTED, linewidth=0.8, linestyle=(0, (3, 2))
        )
    rows[1].annotate(
        f"dashed: the paper's {1e3 * FREE_LENGTH:g} mm and {1e3 * READ_LENGTH:g} mm",
        (1.0, length_unit.factor * READ_LENGTH), (-2, -27), xycoords=("axes fraction", "data"),
        textcoords="offset points", ha="right", color=MUTED, fontsize=8.5,
    )  # fmt: skip
    lengths = (_label(words, length_unit) for words in ("plate", "spring length"))
    labels = (*lengths, _label("spring force", force))
    for axes, label in zip(rows, labels, strict=True):
        axes.set_ylabel(label)
    rows[1].margins(y=0.1)
    rows[2].set(xlabel="time [s]", xlim=(0.0, duration))
    legend_above(rows[0], handles=rows[1].get_legend_handles_labels()[0])
    figure.align_ylabels(rows)
    return figure


@in_style
def exciter_torque_curve(study: EccentricExciter) -> Figure:
    """Draw torque (N m) and plate force (kN) over two turns of steady motion, with the torque of eq. (5)."""
    figure = new_figure(4.6)
    rows = figure.subplots(2, 1, sharex=True)
    torque, force = display_unit("N*m"), display_unit_for("kN")
    for run in study.runs:
        time = run.signals["time"]
        part = run.signals.isel(time=time >= float(time[-1]) - _TURNS)
        style = {"label": run.variant, **_MODELS[run.variant]}
        rows[0].plot(part["time"], torque.factor * part["excenter.torque"], **style)
        rows[1].plot(part["time"], 1e-3 * force.factor * part["plate.force"], **style)
    rows[0].axhline(torque.factor * study.torque, color=MUTED, linewidth=0.8, linestyle=(0, (3, 2)))
    rows[0].annotate(
        f"eq. (5): {quantity(study.torque, 'N*m')}, constant", (1.0, torque.factor * study.torque), (-2, -10),
        xycoords=("axes fraction", "data"), textcoords="offset points", ha="right", color=MUTED, fontsize=8.5,
    )  # fmt: skip
    rows[0].set_ylabel(_label("drive torque", torque))
    rows[1].set(xlabel="time [s]", ylabel=_label("force on plate", force))
    rows[1].margins(x=0.0)
    legend_above(rows[0])
    figure.align_ylabels(rows)
    return figure


def _draw(axes: Axes, runs: Sequence[CaseRun], channel: str) -> None:
    words, metric, size = _QUANTITIES[channel]
    unit = display_unit_for(metric)
    for run in runs:
        part = run.signals.isel(time=run.signals["time"] >= _BEGIN)
        line = _LINES[run.variant]
        axes.plot(
            part["time"],
            size * unit.factor * part[channel],
            label=run.variant,
            linewidth=1.2,
            **line,
        )
    axes.set_ylabel(_label(words, unit))


def _finish(figure: Figure, rows: Sequence[Axes]) -> None:
    for axes in rows:
        for event in _EVENTS:
            axes.axvline(event, color="#b9c0c7", linewidth=0.7, zorder=0)
        axes.set_xlim(_BEGIN, _END)
    rows[-1].set_xlabel("time [s]")
    legend_above(rows[0])
    figure.align_ylabels(rows)


def _label(words: str, unit: DisplayUnit) -> str:
    return f"{words}\n[{unit.name}]"
