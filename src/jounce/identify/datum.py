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
from jounce.identify.decay import noise_of
from jounce.identify.fit_problem import Channel, FitTrial, UpdateProblem
from jounce.recordings.sensors import Datum, Sensor, filter_signals

_STILL = 1e-3  # of the range of the simulated signal: less is no motion yet
_MARGIN, _FEW = 0.02, 8  # s by which a recording may be early; samples that show noise
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
    of the record. ``recorded`` is None where the record begins in motion.
    """

    recorded: float | None
    doubt: float
    static: float
    zero: float
    reach: float

    def datum(self) -> Datum:
        """Decide which datum the record has."""
        small = _SMALL * self.reach + 4.0 * self.doubt
        load = abs(self.static - self.zero)
        if self.recorded is None:
            return "undeformed" if load <= small else "free offset"
        if load <= small:
            return "undeformed" if abs(self.recorded - self.static) <= small else "free offset"
        if abs(self.recorded - self.zero) <= small + _AT_REST * load:
            return "rest"
        return "undeformed" if abs(self.recorded - self.static) <= small + _ABSOLUTE * load else "free offset"

    def matters(self) -> bool:
        """Whether the choice changes anything."""
        small = _SMALL * self.reach + 4.0 * self.doubt
        return abs(self.static - self.zero) > small or self.datum() != "undeformed"


def with_datums(
    trials: Sequence[FitTrial], channels: Sequence[str] | None = None
) -> tuple[list[FitTrial], list[Finding]]:
    """Give the trials with the datum of every compared channel decided, and findings that say what was taken."""
    both = [with_datum(trial, channels) for trial in trials]
    return [trial for trial, _ in both], datum_findings({trial.name: taken for trial, taken in both})


def with_datum(trial: FitTrial, channels: Sequence[str] | None = None) -> tuple[FitTrial, dict[str, Datum]]:
    """Give a trial with the datum of every compared channel decided, and those that the data had to decide.

    A datum that a sensor states is kept. Otherwise the quiet start is held against the model's static value, which may
    be off by 35 % (the start values are those before an update) and decides between "rest" and "undeformed"; a record
    that is neither, or one of a loaded channel that begins in motion, gets a "free offset".
    """
    sensors, taken = dict(trial.sensors), dict[str, Datum]()
    for name, start in _quiet_starts(trial, channels).items():
        datum = start.datum()
        sensors[name] = sensors.get(name, Sensor()).model_copy(update={"datum": datum})
        if start.matters():
            taken[name] = datum
    return replace(trial, sensors=sensors), taken


def datum_findings(taken: Mapping[str, Mapping[str, Datum]]) -> list[Finding]:
    """Say for each channel which datum was taken, from datums by trial and channel."""
    found: dict[tuple[str, Datum], list[str]] = {}
    for trial, datums in taken.items():
        for channel, datum in datums.items():
            found.setdefault((channel, datum), []).append(trial)
    return [_finding(channel, datum, trials) for (channel, datum), trials in found.items()]


def _finding(channel: str, datum: Datum, trials: list[str]) -> Finding:
    where = ", ".join(trials) if len(trials) < 5 else f"{len(trials)} trials"
    text = f'datum "{datum}" taken from the start of {where}: {_MEANING[datum]}'
    if datum == "free offset":
        text += "; the record is neither zeroed at rest nor counts as the model does"
    return Finding(channel, "warning" if datum == "free offset" else "note", f"{text}; state it as datum of its sensor")


def _quiet_starts(trial: FitTrial, channels: Sequence[str] | None) -> dict[str, QuietStart]:
    """Quiet starts of the channels that state no datum."""
    stated = {name for name, sensor in trial.sensors.items() if sensor.datum is not None}
    open_ = [str(name) for name in trial.measured.data_vars if str(name) not in stated]
    open_ = [name for name in open_ if channels is None or name in channels]
    if not open_:
        return {}
    problem = UpdateProblem(
        [trial], (), channels=channels, weights="printed", align=False, lag_bound=1.0, tolerance=1e-5
    )
    prepared = problem.trials[0]
    solution = prepared.solve(np.zeros(0), problem.tolerance)
    time, found = trial.measured["time"].to_numpy(), {}
    for channel in prepared.channels:
        if channel.name not in open_:
            continue
        static = solution.outputs[channel.column][:1]
        if channel.sensor is not None:
            static = filter_signals(static, prepared.rate, channel.sensor, where=channel.name)
        simulated = prepared.table(channel, solution)[:, 0]
        found[channel.name] = _quiet_start(channel, time, simulated, float(static[0]) + channel.bias)
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
