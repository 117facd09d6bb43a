"""Page of a simulated trial: extremes of its channels, then all curves with the mechanism."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jounce.core.display import display_unit
from jounce.plots.display import number, settle_number
from jounce.report.page import Block, Page, PageTable, Paragraph, Section, findings_blocks

if TYPE_CHECKING:
    from jounce.simulation.trial_run import TrialRun


def trial_run_page(trial_run: TrialRun, *, title: str) -> Page:
    """Create a page of a run."""
    rows = []
    for name, channel in trial_run.extremes().items():
        unit, least, most = channel["unit"], channel["minimum"], channel["maximum"]
        shown = display_unit(unit, max(abs(least), abs(most)))
        static, low, high = (
            settle_number(value, unit, shown) for value in (channel["static"], least, most)
        )
        times = (number(channel[key]) for key in ("time_of_minimum", "time_of_maximum"))
        rows.append((name, shown.name or "–", static, low, next(times), high, next(times)))
    header = ("channel", "unit", "static", "minimum", "at [s]", "maximum", "at [s]")
    answer: list[Block] = [
        PageTable("Extremes", header, tuple(rows), "llrrrrr"),
        Paragraph(_words(trial_run), "muted"),
    ]
    answer += findings_blocks(trial_run.findings)
    sections = (
        Section("Extremes", tuple(answer)),
        Section("Curves", lambda: _curves(trial_run, title)),
    )
    return Page(title, sections, f"Simulation of {trial_run.trial.duration:g} s")


def _words(trial_run: TrialRun) -> str:
    """Return a summary of the integration as text."""
    went = trial_run.run.attributes
    events = "event" if went["events"] == 1 else "events"
    return (
        f"{len(trial_run.run.time)} samples, {went['method']} method, {went['steps']} steps, {went['events']} {events} "
        "(tyre lift-off or landing, contact with a stop)"
    )


def _curves(trial_run: TrialRun, title: str) -> tuple[Block, ...]:
    from jounce.report.recordings import curve_blocks

    return curve_blocks(
        {"": {title: trial_run.recording()}}, title=title, rig=trial_run.rig, trial=trial_run.trial
    )
