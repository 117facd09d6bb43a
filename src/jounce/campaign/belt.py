"""Trials on a running belt: speed from pulses, detection of obstacle passages, averages over loops of the belt."""

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
"""Channel with the pulses of the photo sensor."""
_MET_AS_STATED = 0.02
"""Maximum deviation in s of the obstacle's passage from its stated time that the alignment of a fit can compensate."""
_SLIP_BEYOND = 0.005
"""Relative difference between the speeds from recurrence and from pulses above which slip is reported; smaller
differences may come from the radius and length of the belt."""

SPEED_CODES = (
    "identify.other_speed",
    "campaign.belt_and_pulses_differ",
    "campaign.other_speed_than_noted",
)
"""Findings about the speed of one trial."""
_LARGEST_SLIP = 0.1
"""Maximum slip (1) of a flat belt that may go unnoticed."""


class Belt(Description):
    """The belt of the bench.

    Attributes
    ----------
    length : float or None
        Length of the loop, m, after which the obstacle returns. If it is not given, it is estimated from the speeds
        of the trials and the time between passages, and then includes slip.
    radius : float or None
        Radius of the cylinder with the marks, m.
    thickness : float
        Thickness of the belt, m; half of it is added to the radius.
    pulses : int or None
        Pulses of the photo sensor per revolution of the cylinder.
    column : str
        Column of the pulses in the trials' files, e.g. ``"ch2 [V]"``.
    slip : float
        Slip (1) of the belt relative to its cylinder, for trials in which the obstacle passes only once.

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
        """Effective radius of the belt, m; None if the radius of the cylinder is unknown."""
        return None if self.radius is None else self.radius + 0.5 * self.thickness

    @property
    def has_pulses(self) -> bool:
        """Whether the speed of a trial can be calculated from pulses."""
        return bool(self.column and self.pulses and self.radius)

    @property
    def sensors(self) -> dict[str, Sensor]:
        """The photo sensor; empty if its column is unknown."""
        return {PULSES: Sensor(column=self.column)} if self.column else {}

    def speed(self, measured: xr.Dataset, where: str) -> PulseSpeed | None:
        """Calculate the surface speed of the cylinder in a record; None without pulses."""
        radius = self.pitch_radius
        if not self.has_pulses or PULSES not in measured or radius is None or self.pulses is None:
            return None
        time, signal = measured["time"].to_numpy(), measured[PULSES].to_numpy()
        return pulse_speed(time, signal, per_turn=self.pulses, radius=radius, where=where)


@dataclass(frozen=True)
class TrialOnBelt(Shown):
    """Belt speed and obstacle passages of one trial.

    Attributes
    ----------
    noted : float or None
        Speed stated in the campaign, m/s.
    pulses : float or None
        Speed from the pulses, m/s.
    speed : float
        Speed used for the model, m/s: from the recurrence of the obstacle if it passes more than once.
    slip : float or None
        Slip (1) of the belt relative to its cylinder.
    passages : Passages
        Passages of the obstacle.
    findings : tuple of Finding
        Uncertainties of speed and passages.
    """

    noted: float | None
    pulses: float | None
    speed: float
    slip: float | None
    passages: Passages
    findings: tuple[Finding, ...] = field(default=())


def with_recurrence(road: Road, belt: Belt | None) -> Road:
    """Set the belt's length as the recurrence of a road, unless the road states its own.

    >>> from jounce.roads import HalfSine
    >>> with_recurrence(HalfSine(height="10 mm", length="60 mm"), Belt(length="1.97 m")).recurrence
    1.97
    """
    if belt is None or belt.length is None or road.recurrence is not None or road.is_course():
        return road
    return road.with_fields(recurrence=belt.length)


def loop_length(met: Sequence[tuple[Sequence[float], float]]) -> tuple[float, float] | None:
    """Estimate the length of a belt (m) from the instants of obstacle passages (s) and the speed (m/s) of each trial.

    Returns the median over the trials and the standard deviation; None if fewer than two trials have two passages.

    >>> loop_length([([0.2, 1.2, 2.2], 1.97), ([1.0, 0.5, 2.0], 3.94)])
    (1.97, 0.0)
    """
    lengths = []
    for instants, speed in met:
        gaps = [later - sooner for sooner, later in pairwise(sorted(instants))]
        if gaps:
            loops = sum(
                round(gap / min(gaps)) for gap in gaps
            )  # an intermediate passage may have been missed
            lengths.append(speed * sum(gaps) / loops)
    if len(lengths) < _FEWEST_LENGTHS:
        return None
    return median(lengths), stdev(lengths)


_FEWEST_LENGTHS = 2
"""Minimum number of trials: a single trial does not show the scatter."""

Placed = tuple[FitTrial, TrialOnBelt | None, Sequence[Finding]]
"""A trial aligned with its record, its belt speed and passages, and findings."""


def place_trial(
    trial: FitTrial, noted: float | None, passage: Passage, pulses: PulseSpeed | None
) -> Placed:
    """Align a trial with its record, so that the model passes the obstacle at the same time.

    On a belt the record is averaged over its loops (``passage="all"``) or reduced to one loop, and the model is in
    periodic motion; a record without a complete loop is used unchanged. Without a belt, the obstacle is moved to its
    position in the record if it differs from the position stated by the road.

    Raises
    ------
    ObstacleNotFoundError
        If the obstacle is not found.
    FitError
        If the requested passage does not exist, or the belt carries a different obstacle.
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
    """Estimate the zero of a sensor as a free offset: a loop of the belt has no phase at rest."""
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
    # Speeds are stated to three digits, 1.95 m/s to 0.3 %; more than 1 % is not rounding.
    if noted is not None and abs(passages.speed / noted - 1.0) > 0.01:
        numbers = {"noted": noted, "period": passages.period, "speed": passages.speed}
        findings.append(
            finding("campaign.other_speed_than_noted", "speed", passages.speed, **numbers)
        )
    return findings


def _move_obstacle(trial: FitTrial, noted: float | None, channels: list[str]) -> Placed:
    """Move the obstacle to its position in the record, if it differs from the position stated by the road."""
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
        return trial, None, ()  # the comparison reports the error
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
"""Minimum correlation with the model's response for which the detected position replaces the position of the road."""


def exchanged_trials(trials: Mapping[int, TrialOnBelt]) -> list[Finding]:
    """Find pairs of trials whose records were exchanged: each runs at the stated speed of the other."""
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
"""Relative error of a trial's stated speed above which other trials are considered: speeds are stated with two
decimals, and a belt is steady to half a per cent."""
_SAME_SPEED = 0.02
"""Maximum relative difference between the stated speed and the speed from recurrence of the right trial, with slip."""
_MUCH_NEARER = 1.0 / 3.0
"""Fraction of the difference to a trial's own stated speed below which the other trial's speed is taken as its own."""


def common_speed_errors(
    trials: Mapping[int, TrialOnBelt], length: float
) -> tuple[list[Finding], bool]:
    """Report an error that scales the speeds of all trials by one factor; also return whether the length is doubtful.

    The speed from recurrence depends on the belt's ``length`` (m), pulses depend on radius and marks, and stated speeds
    on the drive. If pulses and stated speeds agree, or there are no pulses, the length is wrong; if stated speeds and
    recurrence agree, the pulses are wrong.
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
    """Whether a speed factor differs from 1 by more than slip can explain."""
    return not 1.0 - _LARGEST_SLIP < factor < 1.0 + _SAME_SPEED


def _common_factor(pairs: Sequence[tuple[float, float | None]]) -> float | None:
    """Return the common factor between pairs of speeds; None if there is none, or if there are too few pairs."""
    factors = [speed / other for speed, other in pairs if other]
    if len(factors) < _FEWEST_ALIKE:
        return None
    middle = median(factors)
    alike = sum(abs(factor / middle - 1.0) < _SAME_SPEED for factor in factors)
    return middle if alike >= _MOST_ALIKE * len(factors) else None


_FEWEST_ALIKE = 3
_MOST_ALIKE = 0.8
"""Minimum number and fraction of trials that must share a factor: one or two may be exchanged or misread."""
