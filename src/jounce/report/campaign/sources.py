"""What figures show besides results: measured points, records and roads, read again from the campaign's files."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jounce.campaign.characterise import files_of, read_force_deflection
from jounce.core.errors import JounceError
from jounce.core.types import Array
from jounce.identify.force_deflection import ForceDeflectionTrial
from jounce.recordings import read_recording
from jounce.roads import Road, Trial, read_roads

if TYPE_CHECKING:
    from jounce.campaign.description import DecayBench, StiffnessBench
    from jounce.campaign.result import CampaignResult, TrialResult


def force_deflection(result: CampaignResult, table: StiffnessBench | None) -> list[ForceDeflectionTrial]:
    """Measured trials of a test machine; none where they cannot be read any more."""
    if table is None:
        return []
    try:
        return read_force_deflection(files_of(table.files, result.folder, "report"), table.columns)[0]
    except JounceError:
        return []


def decay_records(result: CampaignResult, table: DecayBench | None) -> list[tuple[str, Array, Array]]:
    """File name, time (s) and record (SI) of each decay; none where they cannot be read any more."""
    if table is None:
        return []
    found = []
    try:
        for file in files_of(table.files, result.folder, "report"):
            recording, _ = read_recording(file, columns=table.columns or None)
            found.append((file.name, recording["time"].to_numpy(), recording[table.channel].to_numpy()))
    except (JounceError, KeyError):
        return []
    return found


def roads_of(result: CampaignResult) -> dict[str, Road]:
    """Roads that trials of the campaign use, by name."""
    try:
        roads = read_roads(result.campaign.roads, folder=result.folder)
    except JounceError:
        return {}
    used = {trial.entry.road for trial in result.trials}
    return {name: road for name, road in roads.items() if name in used}


def obstacle_pass(trial: TrialResult, roads: dict[str, Road]) -> tuple[float, float] | None:
    """First and last time (s) at which the wheel is on the obstacle; None where the whole record is the excitation."""
    road, signals = roads.get(trial.entry.road or ""), trial.signals or trial.signals_before
    if road is None or trial.entry.speed is None or not signals:
        return None
    last = float(next(iter(signals.values())).time[-1])
    drive = Trial(road=road, speed=trial.entry.speed, duration=last)
    edges = drive.segments().edges
    begin = float(edges[1]) if road.start > 0.0 and len(edges) > 2 else 0.0
    end = min(drive.end(), last)
    return (begin, end) if 0.0 < end - begin < 0.8 * last else None
