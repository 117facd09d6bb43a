"""Position of a recorded channel's zero: at rest, at the model's zero, or anywhere.

Displacement sensors and load cells are usually zeroed at rest, whereas models measure from undeformed springs. Without
a correction, a fit attributes the difference to a softer spring or a larger mass. The quiet start of a record shows
which zero applies.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from jounce.core.findings import Finding, finding
from jounce.core.types import Array
from jounce.identify.fit_problem import Channel, FitTrial, UpdateProblem
from jounce.identify.settings import UpdateSettings
from jounce.identify.signals import noise_of
from jounce.identify.signs import likeness, turned_channel
from jounce.recordings.sensors import Datum, Sensor, filter_signals

_STILL = 1e-3  # as a share of the simulated signal's range: below it there is no motion yet
_MARGIN, _FEW = 0.02, 8  # possible lead of a recording, s; samples needed to estimate noise
_TURNED = -0.6  # correlation with the model below which a record is reversed
_TINY = 0.002  # as a share of the record's range: a constant below this is harmless
_SMALL = 0.02  # as a share of the record's range: a constant below this does not indicate a datum
_AT_REST, _ABSOLUTE = (
    0.1,
    0.35,
)  # errors of zeros and of the model's start values, as shares of the static value


@dataclass(frozen=True)
class QuietStart:
    """Reading of a channel before the motion starts, in its SI unit.

    ``recorded`` is the mean of the record there and ``doubt`` its standard error. ``static`` is the expected reading
    with the model's zero, ``zero`` that of a channel zeroed at rest (the sensor's bias). ``reach`` is the range of the
    record. ``recorded`` is None if the record begins in motion. ``likeness`` is the correlation of record and model
    over the whole record (1), and ``is_stated`` is true if the datum was given.
    """

    recorded: float | None
    doubt: float
    static: float
    zero: float
    reach: float
    likeness: float = 0.0
    is_stated: bool = False

    def datum(self) -> Datum:
        """Determine the datum of the record."""
        small = _SMALL * self.reach + 4.0 * self.doubt
        load = abs(self.static - self.zero)
        if self.recorded is None:
            return "undeformed" if load <= small else "free offset"
        if load <= small:
            tiny = (
                _TINY * self.reach + 4.0 * self.doubt
            )  # this static value does not depend on the model's parameters
            return "undeformed" if abs(self.recorded - self.static) <= tiny else "free offset"
        if abs(self.recorded - self.zero) <= small + _AT_REST * load:
            return "rest"
        return (
            "undeformed"
            if abs(self.recorded - self.static) <= small + _ABSOLUTE * load
            else "free offset"
        )

    def matters(self, datum: Datum) -> bool:
        """Whether the choice of datum makes a difference."""
        small = _SMALL * self.reach + 4.0 * self.doubt
        return (
            abs(self.static - self.zero) > small or datum != "undeformed"
        ) and not self.is_stated


Starts = Mapping[str, Mapping[str, QuietStart]]
"""Mapping from trial to channel to its start."""


def with_datums(
    trials: Sequence[FitTrial], channels: Sequence[str] | None = None
) -> tuple[list[FitTrial], list[Finding]]:
    """Return the trials with the datum of every compared channel decided, and findings that state the choice.

    A datum stated by a sensor is kept. Otherwise the quiet starts are compared with the model's static values, which
    may be off by 35 % before an update, to choose "rest" or "undeformed". If neither fits, or if a loaded channel never
    begins at rest, the channel gets a "free offset". A channel has the same datum in all trials: if their starts
    contradict each other, its offset is free in each trial.
    """
    starts = {trial.name: quiet_starts(trial, channels) for trial in trials}
    datums = datums_of(starts)
    return [with_datum(trial, starts[trial.name], datums) for trial in trials], start_findings(
        starts
    )


def datums_of(starts: Starts) -> dict[str, Datum]:
    """Determine the datum of each channel from its starts in all trials."""
    said = dict[str, dict[bool, set[Datum]]]()
    for channels in starts.values():
        for name, start in channels.items():
            if not start.is_stated:
                said.setdefault(name, {}).setdefault(start.recorded is not None, set()).add(
                    start.datum()
                )
    # records that begin at rest determine the datum, also for those that begin in motion
    votes = {name: by_rest.get(True) or by_rest[False] for name, by_rest in said.items()}
    return {
        name: next(iter(choices)) if len(choices) == 1 else "free offset"
        for name, choices in votes.items()
    }


def with_datum(
    trial: FitTrial, starts: Mapping[str, QuietStart], datums: Mapping[str, Datum]
) -> FitTrial:
    """Return a trial with the given datums for all channels whose sensors do not state one."""
    sensors = dict(trial.sensors)
    for name, start in starts.items():
        if not start.is_stated:
            sensors[name] = sensors.get(name, Sensor()).model_copy(update={"datum": datums[name]})
    return replace(trial, sensors=sensors)


def start_findings(starts: Starts) -> list[Finding]:
    """Report for each channel the chosen datum, and whether its sign is reversed."""
    datums, by_channel = datums_of(starts), dict[str, list[tuple[str, QuietStart]]]()
    for trial, channels in starts.items():
        for channel, start in channels.items():
            by_channel.setdefault(channel, []).append((trial, start))
    turned, chosen = list[Finding](), list[Finding]()
    for channel, both in by_channel.items():
        trials = [trial for trial, start in both if start.likeness < _TURNED]
        if trials:
            last = next(start.likeness for _, start in reversed(both) if start.likeness < _TURNED)
            turned.append(turned_channel(channel, last, trials))
        some = [pair for pair in both if channel in datums and pair[1].matters(datums[channel])]
        if some:
            chosen += _findings(channel, datums[channel], some)
    return turned + chosen


def _findings(
    channel: str, datum: Datum, starts: Sequence[tuple[str, QuietStart]]
) -> list[Finding]:
    quiet = [trial for trial, start in starts if start.recorded is not None]
    moving = [trial for trial, start in starts if start.recorded is None]
    differ = len({start.datum() for _, start in starts if start.recorded is not None}) > 1
    code = {"rest": "identify.datum_rest", "undeformed": "identify.datum_undeformed"}.get(
        datum, "identify.datum_free"
    )
    if datum == "free offset" and differ:
        code = "identify.datums_differ"
    findings = [finding(code, channel, trials=_join_trials(quiet or moving))]
    if quiet and moving:
        findings.append(finding("identify.datum_in_motion", channel, trials=_join_trials(moving)))
    return findings


def _join_trials(trials: Sequence[str]) -> str:
    return ", ".join(trials) if len(trials) < 5 else f"{len(trials)} trials"


def quiet_starts(trial: FitTrial, channels: Sequence[str] | None = None) -> dict[str, QuietStart]:
    """Return the starts of all compared channels, with the model's static values."""
    problem = UpdateProblem([trial], (), UpdateSettings(channels=channels, tolerance=1e-5))
    prepared = problem.trials[0]
    solution = prepared.solve(np.zeros(0), problem.tolerance)
    time, starts = trial.measured["time"].to_numpy(), {}
    for channel in prepared.channels:
        static = solution.outputs[channel.column][:1]
        if channel.sensor is not None:
            static = filter_signals(static, prepared.rate, channel.sensor, where=channel.name)
        simulated = prepared.table(channel, solution)[:, 0]
        start = _quiet_start(channel, time, simulated, float(static[0]) + channel.bias)
        like = likeness(channel.measured, simulated, round(_MARGIN * prepared.rate))
        stated = channel.sensor is not None and channel.sensor.datum is not None
        starts[channel.name] = replace(start, likeness=like, is_stated=stated)
    return starts


def _quiet_start(channel: Channel, time: Array, simulated: Array, static: float) -> QuietStart:
    measured = channel.measured
    moved = np.flatnonzero(np.abs(simulated - static) > _STILL * np.ptp(simulated))
    begin = float(time[moved[0]]) if len(moved) else float("inf")
    quiet = measured[time < begin - _MARGIN]
    quiet = quiet if len(quiet) else measured[time < begin]
    recorded, doubt = None, 0.0
    if len(quiet):
        recorded, doubt = float(quiet.mean()), noise_of(measured) if len(measured) > _FEW else 0.0
        doubt = max(doubt, float(quiet.std())) / len(quiet) ** 0.5
    return QuietStart(recorded, doubt, static, channel.bias, float(np.ptp(measured)))
