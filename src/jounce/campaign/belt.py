"""Trials on a belt that has been running: speed from pulses, passages found, loops averaged."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations, pairwise
from statistics import median, stdev
from typing import Annotated, Literal

import xarray as xr
from pydantic import Field

from jounce.core.description import Description, Whole
from jounce.core.errors import JounceError
from jounce.core.findings import Finding, finding
from jounce.core.shown import Shown
from jounce.core.units import NonNegativeLength, PositiveLength, Unit
from jounce.identify.fit_problem import FitTrial
from jounce.identify.passages import ObstacleNotFoundError, Passages, find_passages
from jounce.identify.trials_on_belt import averaged_trial, select_loop, trial_on_running_belt
from jounce.recordings.pulses import PulseSpeed, pulse_speed
from jounce.recordings.sensors import Sensor
from jounce.roads import Road

Passage = Whole | Literal["all"]
PULSES = "belt.voltage"
"""Channel that holds the pulses of the photo sensor."""
_MET_AS_STATED = 0.02
"""Seconds by which the obstacle may be met earlier or later than the road says: what the alignment of a fit takes."""
_SLIP_BEYOND = 0.005
"""Share by which the speed from recurrence may differ from that of the pulses before slip is said: what radius and
length of a belt are known to."""

SPEED_CODES = (
    "identify.other_speed",
    "campaign.belt_and_pulses_differ",
    "campaign.other_speed_than_noted",
)
"""Findings about the speed of one trial."""
_LARGEST_SLIP = 0.1
"""Share that a flat belt slips by at most without being seen or heard."""


class Belt(Description):
    """The belt of the bench.

    Attributes
    ----------
    length : float or None
        Length of the loop, m: the obstacle comes again each time it has been driven. Where nobody measured it, it
        follows from the speeds of the trials and the time between passages; slip then counts in it.
    radius : float or None
        Radius of the cylinder that carries the marks, m.
    thickness : float
        Thickness of the belt, m; half of it adds to the radius.
    pulses : int or None
        Pulses of the photo sensor a turn of the cylinder.
    column : str
        Column of the pulses in the trials' files, e.g. ``"ch2 [V]"``.
    slip : float
        Share (1) by which the belt is slower than its cylinder, for trials in which the obstacle passes only once.

    Examples
    --------
    >>> round(Belt(length="1.97 m", radius="50 mm", thickness="3 mm", pulses=12, column="ch2").pitch_radius, 6)
    0.0515
    """

    length: PositiveLength | None = None
    radius: PositiveLength | None = None
    thickness: NonNegativeLength = 0.0
    pulses: Annotated[Whole, Field(ge=1, le=10_000)] | None = None
    column: str = ""
    slip: Annotated[float, Unit("1", at_least=0.0, at_most=0.5)] = 0.0

    @property
    def pitch_radius(self) -> float | None:
        """Radius at which the belt runs, m; None where that of the cylinder is not known."""
        return None if self.radius is None else self.radius + 0.5 * self.thickness

    @property
    def has_pulses(self) -> bool:
        """Whether a trial's speed follows from its pulses."""
        return bool(self.column and self.pulses and self.radius)

    @property
    def sensors(self) -> dict[str, Sensor]:
        """The photo sensor, where its column is known."""
        return {PULSES: Sensor(column=self.column)} if self.column else {}

    def speed(self, measured: xr.Dataset, where: str) -> PulseSpeed | None:
        """Speed of the cylinder's surface in a record; None without pulses."""
        radius = self.pitch_radius
        if not self.has_pulses or PULSES not in measured or radius is None or self.pulses is None:
            return None
        time, signal = measured["time"].to_numpy(), measured[PULSES].to_numpy()
        return pulse_speed(time, signal, per_turn=self.pulses, radius=radius, where=where)


@dataclass(frozen=True)
class TrialOnBelt(Shown):
    """Belt and passages of one trial.

    Attributes
    ----------
    noted : float or None
        Speed as the campaign states it, m/s.
    pulses : float or None
        Speed from the pulses, m/s.
    speed : float
        Speed that the model drives, m/s: from the recurrence of the obstacle where it passes more than once.
    slip : float or None
        Share (1) by which the belt is slower than its cylinder.
    passages : Passages
        Where the obstacle was met.
    findings : tuple of Finding
        What is doubtful of speed and passages.
    """

    noted: float | None
    pulses: float | None
    speed: float
    slip: float | None
    passages: Passages
    findings: tuple[Finding, ...] = field(default=())


def with_recurrence(road: Road, belt: Belt | None) -> Road:
    """The road with the belt's length as its recurrence, unless it states one.

    >>> from jounce.roads import HalfSine
    >>> with_recurrence(HalfSine(height="10 mm", length="60 mm"), Belt(length="1.97 m")).recurrence
    1.97
    """
    if belt is None or belt.length is None or road.recurrence is not None or road.is_course():
        return road
    return road.with_fields(recurrence=belt.length)


def loop_length(met: Sequence[tuple[Sequence[float], float]]) -> tuple[float, float] | None:
    """Length of a belt (m) from instants at which an obstacle was met (s) and the speed (m/s) of each trial.

    Gives the median of the trials and their standard deviation; None where fewer than two meet it twice.

    >>> loop_length([([0.2, 1.2, 2.2], 1.97), ([1.0, 0.5, 2.0], 3.94)])
    (1.97, 0.0)
    """
    lengths = []
    for instants, speed in met:
        gaps = [later - sooner for sooner, later in pairwise(sorted(instants))]
        if gaps:
            loops = sum(
                round(gap / min(gaps)) for gap in gaps
            )  # a passage between may not have been recognised
            lengths.append(speed * sum(gaps) / loops)
    if len(lengths) < _FEWEST_LENGTHS:
        return None
    return median(lengths), stdev(lengths)


_FEWEST_LENGTHS = 2
"""Trials whose lengths must agree: one alone shows no scatter."""

Placed = tuple[FitTrial, TrialOnBelt | None, Sequence[Finding]]
"""A trial that meets its obstacle when the record does, what was found of belt and passages, and what is doubtful."""


def place_trial(
    trial: FitTrial, noted: float | None, passage: Passage, pulses: PulseSpeed | None
) -> Placed:
    """Give a trial whose model meets the obstacle when the record does.

    On a belt the record is the average of its loops (``passage="all"``), or one of them, and the model has been
    running; a record that holds no loop in full is taken as it is. Without a belt the obstacle is moved to where the
    record meets it, where that is not where the road says.

    Raises
    ------
    ObstacleNotFoundError
        Where the obstacle is not found.
    FitError
        Where the passage that is asked for does not exist, or the belt carries another obstacle.
    """
    road = trial.trial.road
    assert road is not None
    assert trial.trial.speed is not None
    channels = _compared_channels(trial)
    if road.recurrence is None:
        return _move_obstacle(trial, noted, channels)
    passages = find_passages(
        trial.measured,
        trial.rig,
        road,
        trial.trial.speed,
        sensors=trial.sensors,
        channels=channels,
        name=trial.name,
    )
    if passage != "all":
        passages = select_loop(
            passages, trial.measured, passage, channels=channels, name=trial.name
        )
    slip = None if pulses is None else 1.0 - passages.speed / pulses.mean
    facts = TrialOnBelt(
        noted,
        None if pulses is None else pulses.mean,
        passages.speed,
        slip,
        passages,
        tuple(_speed_findings(noted, slip, passages)),
    )
    sensors = {name: _with_free_zero(trial.sensors.get(name)) for name in channels}
    trial = replace(trial, sensors={**trial.sensors, **sensors})
    if passages.loop is None:
        met = ", ".join(f"{time:.3g} s" for time in passages.times)
        facts = replace(
            facts,
            findings=(*facts.findings, finding("campaign.no_whole_loop", "belt", None, times=met)),
        )
        return trial_on_running_belt(trial, passages), facts, facts.findings
    return averaged_trial(trial, passages), facts, facts.findings


def _compared_channels(trial: FitTrial) -> list[str]:
    return [str(name) for name in trial.measured.data_vars if str(name) != PULSES]


def _with_free_zero(sensor: Sensor | None) -> Sensor:
    """Nothing is at rest in a loop that could tell where zero lies."""
    sensor = sensor or Sensor()
    return (
        sensor if sensor.datum is not None else sensor.model_copy(update={"datum": "free offset"})
    )


def _speed_findings(noted: float | None, slip: float | None, passages: Passages) -> list[Finding]:
    findings = list(passages.findings)
    if slip is not None and abs(slip) > _SLIP_BEYOND:
        code = (
            "campaign.belt_slips"
            if 0.0 < slip < _LARGEST_SLIP
            else "campaign.belt_and_pulses_differ"
        )
        findings.append(finding(code, "speed", slip, slip=slip, speed=passages.speed))
    # Speeds are noted to three digits, 1.95 m/s to 0.3 %; beyond 1 % it is not rounding.
    if noted is not None and abs(passages.speed / noted - 1.0) > 0.01:
        numbers = {"noted": noted, "period": passages.period, "speed": passages.speed}
        findings.append(
            finding("campaign.other_speed_than_noted", "speed", passages.speed, **numbers)
        )
    return findings


def _move_obstacle(trial: FitTrial, noted: float | None, channels: list[str]) -> Placed:
    """Move the obstacle to where the record meets it; leave a trial alone whose record begins where the road says."""
    road, speed = trial.trial.road, trial.trial.speed
    assert road is not None
    assert speed is not None
    if road.is_course() or road.end() == road.start:
        return trial, None, ()
    try:
        passages = find_passages(
            trial.measured,
            trial.rig,
            road,
            speed,
            sensors=trial.sensors,
            channels=channels,
            name=trial.name,
        )
    except ObstacleNotFoundError:
        raise
    except JounceError:
        return trial, None, ()  # the comparison says what it finds
    met, stated = passages.times[0], road.start / speed
    if abs(met - stated) <= _MET_AS_STATED or passages.likeness[0] < _SURE:
        return trial, None, passages.findings
    driven = trial.trial.with_fields(road=road.with_fields(start=max(met * speed, 0.0)))
    facts = TrialOnBelt(
        noted,
        None,
        speed,
        None,
        passages,
        (
            *passages.findings,
            finding("campaign.met_elsewhere", "road", met, met=met, stated=stated),
        ),
    )
    return replace(trial, trial=driven), facts, facts.findings


_SURE = 0.8
"""Correlation with the model's response from which on its place is taken, rather than that of the road."""


def exchanged_trials(trials: Mapping[int, TrialOnBelt]) -> list[Finding]:
    """Name pairs of trials whose records were exchanged: each runs at the speed that is noted of the other."""
    noted = {number: facts.noted for number, facts in trials.items() if facts.noted is not None}
    findings = []
    for first, second in combinations(noted, 2):
        speeds = trials[first].speed, trials[second].speed
        straight, crossed = (
            [abs(speed / noted[number] - 1.0) for speed, number in zip(speeds, order, strict=True)]
            for order in ((first, second), (second, first))
        )
        if min(straight) > _NOTED and max(crossed) < min(_SAME_SPEED, _MUCH_NEARER * min(straight)):
            place = f"trials {first} and {second}"
            findings.append(
                finding("campaign.trials_exchanged", place, first=speeds[0], second=speeds[1])
            )
    return findings


_NOTED = 0.01
"""Share by which the speed of a trial is off before another trial's is looked for: they are noted with two decimals,
and a belt is steady to half a per cent."""
_SAME_SPEED = 0.02
"""Share by which a noted speed and that of the recurrence of the right trial differ at most, with slip."""
_MUCH_NEARER = 1.0 / 3.0
"""Share of the difference to a trial's own noted speed, below which that of the other one is its own."""


def common_speed_errors(
    trials: Mapping[int, TrialOnBelt], length: float
) -> tuple[list[Finding], bool]:
    """Say once what makes the speeds of all trials differ by one factor; whether the belt's length is in doubt.

    The speed of the recurrence counts on the belt's ``length`` (m). Pulses count on radius and marks, noted speeds on
    the drive: where both say the same, or there are no pulses, the length is wrong; where the noted speeds agree with
    the recurrence, the pulses are.
    """
    noted = _common_factor([(facts.speed, facts.noted) for facts in trials.values()])
    pulses = _common_factor([(facts.speed, facts.pulses) for facts in trials.values()])
    if (
        noted is not None
        and _is_off(noted)
        and (pulses is None or abs(pulses / noted - 1.0) < _SAME_SPEED)
    ):
        return [
            finding("campaign.belt_length_off", "belt", length, length=length, fits=length / noted)
        ], True
    if pulses is not None and _is_off(pulses) and noted is not None and not _is_off(noted):
        return [finding("campaign.pulses_off", "belt", pulses, factor=pulses)], False
    return [], False


def _is_off(factor: float) -> bool:
    """Whether a factor on speeds is neither one nor slip."""
    return not 1.0 - _LARGEST_SLIP < factor < 1.0 + _SAME_SPEED


def _common_factor(pairs: Sequence[tuple[float, float | None]]) -> float | None:
    """The factor between speeds and others that all pairs have in common; None without one, or with one pair only."""
    factors = [speed / other for speed, other in pairs if other]
    if len(factors) < _FEWEST_ALIKE:
        return None
    middle = median(factors)
    alike = sum(abs(factor / middle - 1.0) < _SAME_SPEED for factor in factors)
    return middle if alike >= _MOST_ALIKE * len(factors) else None


_FEWEST_ALIKE = 3
_MOST_ALIKE = 0.8
"""Trials, and share of them, that must have a factor in common: one or two may be exchanged or misread."""
