"""Trials: what was driven, where the model holds, and the curves themselves."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jounce.plots import (
    measured_against_simulated,
    number,
    residual_against_speed_and_pitch,
    road_profile,
    trial_matrix,
)
from jounce.report.campaign.sources import obstacle_pass, roads_of
from jounce.report.campaign.summary import TONES, verdict
from jounce.report.numbers import given, milliseconds, percent
from jounce.report.page import Block, Cell, Details, Paragraph, Picture, Section, Subsection, Table

if TYPE_CHECKING:
    from jounce.campaign.result import CampaignResult, TrialResult

_OPEN = 3
_USES = {"fit": "fitted", "hold-out": "held out"}
_GRADE_TONES = {"excellent": "good", "good": "good", "fair": "fair", "poor": "bad"}


def trials(result: CampaignResult) -> Section:
    """Every trial with its setting, and the roads."""
    rows = tuple(_setting(trial) for trial in result.trials)
    header = ("trial", "use", "speed", "road", "pitch", "strut angle", "tyre pressure", "recording")
    blocks: list[Block] = [Table("Trials of the campaign", header, rows, "llrlrrrl")]
    roads = roads_of(result)
    if roads:
        figure = road_profile(roads)
        blocks.append(
            Picture(
                figure,
                "roads",
                "Height of the roads against distance.",
                f"Height profiles of the roads {', '.join(roads)}.",
            )
        )
    return Section("Trials", tuple(blocks))


def _setting(trial: TrialResult) -> tuple[Cell | str, ...]:
    entry = trial.entry
    road = entry.road if entry.road is not None else f"excitation {entry.excitation}"
    lost = Cell(entry.recording, "bad", "not usable, see Findings") if trial.after is None else entry.recording
    return (
        str(entry.number),
        _USES[entry.use],
        given(entry.speed, "m/s"),
        road or "–",
        given(trial.obstacle_pitch, "m"),
        given(entry.strut_angle, "rad"),
        given(entry.tyre_pressure, "Pa"),
        lost,
    )


def validation(result: CampaignResult) -> Section:
    """Rating of every trial and channel, fitted and held out, and how the error depends on speed and pitch."""
    model = "after the last update" if result.strategies else "with the characterised values"
    blocks: list[Block] = [
        Paragraph(
            f"Each trial is simulated with the model {model} and compared with its recording. The verdict follows the "
            "channel that is worst: the model holds with an ISO/TS 18571 rating above 0.80 and R² above 0.95, it holds "
            "partly with a rating above 0.58 and R² above 0.75."
        ),
        Picture(
            trial_matrix(result.trials),
            "validation-matrix",
            "ISO/TS 18571 rating of every trial and channel.",
            "Table of ratings before and after updating; all numbers are in the validation table.",
        ),
        _table(result),
    ]
    if any(trial.after is not None for trial in result.trials):
        picture = Picture(
            residual_against_speed_and_pitch(result.trials),
            "validation-residual",
            "Normalised error of every trial against speed (single obstacles) and obstacle pitch (trains); "
            "numbers of the trials "
            "stand where there is room.",
            "NRMSE against speed and obstacle pitch; all numbers are in the validation table.",
        )
        blocks.append(Subsection("Error against speed and obstacle pitch", (picture,)))
    return Section("Validation", tuple(blocks))


def _table(result: CampaignResult) -> Table:
    rows: list[tuple[Cell | str, ...]] = []
    for use in ("fit", "hold-out"):
        for trial in result.trials:
            if trial.entry.use == use:
                rows += _validation_rows(trial)
    header = (
        "trial",
        "use",
        "channel",
        "NRMSE",
        "R²",
        "peak error",
        "lag [ms]",
        "ISO 18571",
        "grade",
        "before",
        "verdict",
    )
    return Table(
        "Model against measurement, fitted trials first",
        header,
        tuple(rows),
        "lllrrrrrlrl",
        "Before: ISO 18571 rating before updating. Definitions are under How this was made.",
    )


def _validation_rows(trial: TrialResult) -> list[tuple[Cell | str, ...]]:
    head = (str(trial.entry.number), _USES[trial.entry.use])
    word = verdict(trial)
    if trial.after is None:
        return [(*head, "–", "–", "–", "–", "–", "–", "–", "–", Cell(word, TONES[word]))]
    rows: list[tuple[Cell | str, ...]] = []
    for k, (name, channel) in enumerate(trial.after.channels.items()):
        before = trial.before.channels.get(name) if trial.before is not None else None
        rows.append(
            (
                *(head if k == 0 else ("", "")),
                name,
                number(channel.nrmse, 2),
                f"{channel.r2:.3f}".replace("-", "−"),
                percent(channel.peak_error),
                milliseconds(channel.lag),
                f"{channel.iso18571:.2f}",
                Cell(channel.grade, _GRADE_TONES[channel.grade]),  # type: ignore[arg-type]
                f"{before.iso18571:.2f}" if before is not None else "–",
                Cell(word, TONES[word]) if k == 0 else "",
            )
        )
    return rows


def curves(result: CampaignResult) -> Section:
    """Measured and simulated signals of every trial, folded but for the first ones."""
    roads = roads_of(result)
    blocks: list[Block] = []
    shown = 0
    for trial in result.trials:
        drawn = bool(trial.signals or trial.signals_before)
        blocks.append(Details(_heading(trial), (_curve(trial, roads),), is_open=drawn and shown < _OPEN))  # type: ignore[arg-type]
        shown += drawn
    return Section("Curves", tuple(blocks))


def _heading(trial: TrialResult) -> str:
    entry = trial.entry
    parts = [f"Trial {entry.number} ({_USES[entry.use]})"]
    if entry.speed is not None:
        parts.append(given(entry.speed, "m/s"))
    parts.append(f"road {entry.road}" if entry.road is not None else f"excitation {entry.excitation}")
    return f"{', '.join(parts)}: {verdict(trial)}"


def _curve(trial: TrialResult, roads: dict[str, object]) -> Block:
    if not (trial.signals or trial.signals_before):
        return Paragraph("The recording could not be used, so there is nothing to draw. See Findings.", "bad")
    window = obstacle_pass(trial, roads)  # type: ignore[arg-type]
    channels = trial.after.channels if trial.after is not None else {}
    words = "; ".join(f"{name}: rating {c.iso18571:.2f}, {c.grade}" for name, c in channels.items())
    return Picture(
        measured_against_simulated(trial, window),
        f"trial-{trial.entry.number:02d}",
        "Left: whole record; right: obstacle pass. Below each signal: measured minus simulated. Shaded: "
        "the wheel is on the "
        "obstacle.",
        f"Measured and simulated signals of trial {trial.entry.number}, before and after updating. {words}.",
    )
