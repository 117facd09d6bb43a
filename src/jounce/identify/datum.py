"""Where the zero of a recorded channel lies: at rest, where the model counts from, or anywhere.

Displacement sensors and load cells are zeroed at rest as a rule, models count from undeformed springs: compared as
they stand, the difference is taken for a softer spring or a greater mass. What the record shows before anything moves
decides.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.identify.fit_problem import Channel, FitTrial, UpdateProblem
from jounce.identify.noise import noise_of
from jounce.identify.signs import likeness, turned_channel
from jounce.recordings.sensors import Datum, Sensor, filter_signals

_STILL = 1e-3  # of the range of the simulated signal: less is no motion yet
_MARGIN, _FEW = 0.02, 8  # s by which a recording may be early; samples that show noise
_TURNED = -0.6  # correlation with the model below which a record is turned
_TINY = 0.002  # of the range of the record: a constant below this does no harm
_SMALL = 0.02  # of the range of the record: a constant below this is no datum
_AT_REST, _ABSOLUTE = 0.1, 0.35  # of the static value: how far zeros, and start values of the model, may be off
_MEANING: dict[Datum, str] = {
    "rest": "zero at rest",
    "undeformed": "zero where the model counts from (undeformed springs, design position, no force)",
    "free offset": "an unknown constant is fitted with the parameters",
}


@dataclass(frozen=True)
class QuietStart:
    """What a channel shows before anything moves, in its SI unit.

    ``recorded`` is the mean of the record there and ``doubt`` its standard error, ``static`` what the model says for a
    record that counts as it does, ``zero`` for one that was zeroed at rest (the sensor's bias), and ``reach`` the range
    of the record. ``recorded`` is None where the record begins in motion. ``likeness`` is the correlation of record and
    model over the whole record (1), and ``is_stated`` tells that the datum was given.
    """

    recorded: float | None
    doubt: float
    static: float
    zero: float
    reach: float
    likeness: float = 0.0
    is_stated: bool = False

    def datum(self) -> Datum:
        """Decide which datum the record has."""
        small = _SMALL * self.reach + 4.0 * self.doubt
        load = abs(self.static - self.zero)
        if self.recorded is None:
            return "undeformed" if load <= small else "free offset"
        if load <= small:
            tiny = _TINY * self.reach + 4.0 * self.doubt  # nothing of the model's values is in this static value
            return "undeformed" if abs(self.recorded - self.static) <= tiny else "free offset"
        if abs(self.recorded - self.zero) <= small + _AT_REST * load:
            return "rest"
        return "undeformed" if abs(self.recorded - self.static) <= small + _ABSOLUTE * load else "free offset"

    def matters(self) -> bool:
        """Whether the choice changes anything."""
        small = _SMALL * self.reach + 4.0 * self.doubt
        differs = abs(self.static - self.zero) > small or self.datum() != "undeformed"
        return differs and not self.is_stated


def with_datums(
    trials: Sequence[FitTrial], channels: Sequence[str] | None = None
) -> tuple[list[FitTrial], list[Finding]]:
    """Give the trials with the datum of every compared channel decided, and findings that say what was taken."""
    both = [with_datum(trial, channels) for trial in trials]
    return [trial for trial, _ in both], start_findings({trial.name: starts for trial, starts in both})


def with_datum(trial: FitTrial, channels: Sequence[str] | None = None) -> tuple[FitTrial, dict[str, QuietStart]]:
    """Give a trial with the datum of every compared channel decided, and the starts of the channels.

    A datum that a sensor states is kept. Otherwise the quiet start is held against the model's static value, which may
    be off by 35 % (the start values are those before an update) and decides between "rest" and "undeformed"; a record
    that is neither, or one of a loaded channel that begins in motion, gets a "free offset".
    """
    sensors, starts = dict(trial.sensors), _quiet_starts(trial, channels)
    for name, start in starts.items():
        if not start.is_stated:
            sensors[name] = sensors.get(name, Sensor()).model_copy(update={"datum": start.datum()})
    return replace(trial, sensors=sensors), starts


def start_findings(starts: Mapping[str, Mapping[str, QuietStart]]) -> list[Finding]:
    """Say for each channel which datum was found and whether its sign is turned, from starts by trial and channel."""
    datums, turned = dict[tuple[str, Datum], list[str]](), dict[str, list[str]]()
    likeness = dict[str, float]()
    for trial, channels in starts.items():
        for channel, start in channels.items():
            if start.matters():
                datums.setdefault((channel, start.datum()), []).append(trial)
            if start.likeness < _TURNED:
                turned.setdefault(channel, []).append(trial)
                likeness[channel] = start.likeness
    findings = [turned_channel(channel, likeness[channel], trials) for channel, trials in turned.items()]
    return findings + [_finding(channel, datum, trials) for (channel, datum), trials in datums.items()]


def _finding(channel: str, datum: Datum, trials: list[str]) -> Finding:
    where = ", ".join(trials) if len(trials) < 5 else f"{len(trials)} trials"
    text = f'datum "{datum}" taken from the start of {where}: {_MEANING[datum]}'
    if datum == "free offset":
        text += "; the record is neither zeroed at rest nor counts as the model does"
    return Finding(channel, "warning" if datum == "free offset" else "note", f"{text}; state it as datum of its sensor")


def _quiet_starts(trial: FitTrial, channels: Sequence[str] | None) -> dict[str, QuietStart]:
    """Starts of all compared channels, with the model's own values."""
    problem = UpdateProblem(
        [trial], (), channels=channels, weights="printed", align=False, lag_bound=1.0, tolerance=1e-5
    )
    prepared = problem.trials[0]
    solution = prepared.solve(np.zeros(0), problem.tolerance)
    time, found = trial.measured["time"].to_numpy(), {}
    for channel in prepared.channels:
        static = solution.outputs[channel.column][:1]
        if channel.sensor is not None:
            static = filter_signals(static, prepared.rate, channel.sensor, where=channel.name)
        simulated = prepared.table(channel, solution)[:, 0]
        start = _quiet_start(channel, time, simulated, float(static[0]) + channel.bias)
        like = likeness(channel.measured, simulated, round(_MARGIN * prepared.rate))
        stated = channel.sensor is not None and channel.sensor.datum is not None
        found[channel.name] = replace(start, likeness=like, is_stated=stated)
    return found


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
