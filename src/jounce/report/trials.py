"""Curves of a campaign's trials, for the viewer and as static figures."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.display import display_unit
from jounce.core.errors import JounceError
from jounce.parts.corners import Corner
from jounce.plots.campaign import lively_window
from jounce.plots.display import setting_text
from jounce.plots.mechanisms.scene import poses_of, roadway_of, scene_of
from jounce.recordings.schema import QUANTITIES, channel_unit, quantity_of
from jounce.report.chart import Chart
from jounce.report.live import Curve, Motion, Pane, PosedRig, Viewer, ViewerScene, scene_panels

if TYPE_CHECKING:
    from jounce.campaign.result import CampaignResult
    from jounce.campaign.strategy_result import StrategyResult
    from jounce.campaign.trial_result import TrialResult
    from jounce.core.types import Array
    from jounce.report.page import Tone

_MEASURED, _BEFORE, _AFTER = "measured", "before", "after"
_MORE = ("tyre.force", "strut.force", "strut.deflection", "sprung.z", "unsprung.z", "road.z")
"""Outputs of the model that can be shown with the measurements."""
_USES = {"fit": "fitted", "hold-out": "held out"}
_MOST_OTHERS = 6
MOST_SCENES = 64
"""Maximum number of trials; more would make the page slow to open."""


def scene_name(number: int) -> str:
    """Return the name of a trial's scene and figure."""
    return f"trial-{number:02d}"


def trials_viewer(
    result: CampaignResult, verdicts: Mapping[int, tuple[str, Tone]]
) -> Viewer | None:
    """Show all trials with signals in one viewer; ``verdicts`` contains text and tone by trial number."""
    others = result.strategies[:-1][-_MOST_OTHERS:]
    mechanisms = _mechanisms(result)
    shown = select_trials(result, verdicts)
    scenes = tuple(
        _scene(result, trial, others, verdicts[trial.entry.number], mechanisms) for trial in shown
    )
    if not scenes:
        return None
    roles = [
        (_MEASURED, "measured", True),
        (_BEFORE, "before updating" if result.strategies else "simulated", True),
    ]
    roles += [(f"other-{k}", strategy.update.name, False) for k, strategy in enumerate(others, 1)]
    roles += [(_AFTER, strategy.update.name, True) for strategy in result.strategies[-1:]]
    caption = "Measured and simulated signals of every trial; shaded: wheel on the obstacle."
    if len(scenes) == MOST_SCENES < len(result.trials):
        caption += (
            f" Shown are {MOST_SCENES} of {len(result.trials)} trials: the fitted ones, then those "
            "predicted worst."
        )
    if mechanisms:
        caption += " The mechanism moves as the model after the last update does, true to scale."
    return Viewer(result.campaign.title, scenes, tuple(roles), caption)


def select_trials(
    result: CampaignResult, verdicts: Mapping[int, tuple[str, Tone]]
) -> list[TrialResult]:
    """Return trials with signals, in order; if there are too many, the fitted and the worst-predicted ones."""
    drawn = [trial for trial in result.trials if trial.signals or trial.signals_before]
    order = {"bad": 0, "fair": 1}
    ranked = sorted(
        range(len(drawn)),
        key=lambda k: (
            drawn[k].entry.use != "fit",
            order.get(verdicts[drawn[k].entry.number][1], 2),
        ),
    )
    return [drawn[k] for k in sorted(ranked[:MOST_SCENES])]


def trial_label(trial: TrialResult) -> str:
    """Return a one-line description of a trial."""
    entry = trial.entry
    parts = [f"{entry.number}", _USES[entry.use]]
    if entry.speed is not None:
        parts.append(setting_text(entry.speed, "m/s", "speed"))
    if entry.road is not None:
        parts.append(f"road {entry.road}")
    if entry.strut_angle is not None:
        parts.append(setting_text(entry.strut_angle, "rad"))
    if entry.tyre_pressure is not None:
        parts.append(setting_text(entry.tyre_pressure, "Pa"))
    return " · ".join(parts)


def trial_chart(scene: ViewerScene, trial: TrialResult) -> Chart:
    """Plot the part of a trial with the largest motion: measured, before and after updating."""
    channels = trial.after.channels if trial.after is not None else {}
    words = "; ".join(f"{name}: rating {c.iso18571:.2f}, {c.grade}" for name, c in channels.items())
    return Chart(
        scene_panels(scene, "time", "s", (_MEASURED, _BEFORE, _AFTER)),
        scene.name,
        "The part of the record with the largest motion; shaded: wheel on the obstacle.",
        f"Measured and simulated signals of trial {trial.entry.number}, before and after updating. {words}.",
        columns=1,
    )


def _scene(
    result: CampaignResult,
    trial: TrialResult,
    others: Sequence[StrategyResult],
    verdict: tuple[str, Tone],
    mechanisms: Mapping[float | None, PosedRig],
) -> ViewerScene:
    shown = trial.signals or trial.signals_before
    time = next(iter(shown.values())).time
    span = obstacle_pass(trial)
    panes = []
    for name, signal in shown.items():
        after, before = trial.signals.get(name), trial.signals_before.get(name)
        unit = display_unit(_si(name), float(np.abs(signal.measured).max(initial=0.0)))
        curves = [Curve("measured", _MEASURED, signal.measured * unit.factor)]
        if before is not None:
            curves.append(Curve("before", _BEFORE, before.simulated * unit.factor))
        for k, strategy in enumerate(others, 1):
            fitted = next(
                (
                    candidate
                    for candidate in strategy.trials
                    if candidate.number == trial.entry.number
                ),
                None,
            )
            if fitted is not None and name in fitted.signals:
                curves.append(
                    Curve(
                        strategy.update.name,
                        f"other-{k}",
                        fitted.signals[name].simulated * unit.factor,
                    )
                )
        if after is not None and result.strategies:
            curves.append(Curve("after", _AFTER, after.simulated * unit.factor))
        panes.append(Pane(name, _words(name), unit.name, tuple(curves)))
    motion = trial.motion
    if motion is not None:
        role = _AFTER if result.strategies else _BEFORE
        for name in _MORE:
            if name in motion.outputs and name not in shown:
                values = motion.outputs[name]
                unit = display_unit(_si(name), float(np.abs(values).max(initial=0.0)))
                panes.append(
                    Pane(
                        name,
                        _words(name),
                        unit.name,
                        (Curve("model", role, values * unit.factor),),
                        False,
                    )
                )
    return ViewerScene(
        scene_name(trial.entry.number),
        trial_label(trial),
        time,
        tuple(panes),
        *verdict,
        (span,) if span is not None else (),
        lively_window(shown, span),
        _motion(trial, mechanisms.get(trial.entry.strut_angle)),
    )


def _si(name: str) -> str:
    return channel_unit(name) if quantity_of(name) else "1"


def _words(name: str) -> str:
    quantity = quantity_of(name)
    place = name.rpartition(".")[0]
    return f"{place} {QUANTITIES[quantity][1]}" if quantity else name


def obstacle_pass(trial: TrialResult) -> tuple[float, float] | None:
    """Return the first and last time (s) of the wheel on the obstacle; ``None`` if the whole record is excited."""
    if trial.motion is None or trial.motion.trial.road is None or trial.motion.trial.speed is None:
        return None
    drive, last = trial.motion.trial, float(trial.motion.time[-1])
    edges = drive.segments().edges
    begin = (
        float(edges[1])
        if drive.road is not None and drive.road.start > 0.0 and len(edges) > 2
        else 0.0
    )
    loops = 0.0  # a record that starts on a running belt
    if drive.road is not None and drive.road.recurrence is not None and drive.speed is not None:
        period = drive.road.recurrence / drive.speed
        loops = math.ceil((float(trial.motion.time[0]) - begin) / period - 1e-9) * period
    end = min(drive.end() + loops, last)
    return (begin + loops, end) if 0.0 < end - begin - loops < 0.8 * last else None


def _mechanisms(result: CampaignResult) -> dict[float | None, PosedRig]:
    mechanisms = {}
    for angle, sweep in result.poses.items():
        motion = next(
            t.motion for t in result.trials if t.motion is not None and t.entry.strut_angle == angle
        )
        if not isinstance(motion.rig, Corner):
            continue
        try:
            drawing = scene_of(motion.rig)
            mechanisms[angle] = PosedRig(drawing, poses_of(motion.rig, drawing, sweep))
        except JounceError:  # a page without the mechanism still shows the curves
            continue
    return mechanisms


def _motion(trial: TrialResult, mechanism: PosedRig | None) -> Motion | None:
    motion = trial.motion
    if motion is None or mechanism is None:
        return None
    out = motion.outputs
    ground: Array = out["road.z"] if "road.z" in out else np.zeros_like(motion.time)
    road, speed = None, motion.trial.speed or 0.0
    if motion.trial.road is not None:
        try:
            road = roadway_of(motion.trial, motion.time, mechanism.drawing.undeformed_radius)
        except JounceError:
            road = None
    load = out.get("tyre.force", np.ones_like(motion.time))
    travel = out["unsprung.z"] - out["sprung.z"]
    return Motion(mechanism, out["sprung.z"], travel, ground, load, road, speed)
