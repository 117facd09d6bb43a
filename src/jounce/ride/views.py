"""What a ride metric sees of a recording: one acceleration, all accelerations at a place, or one corner."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from jounce.core.errors import RecordingError
from jounce.core.types import Array
from jounce.ride.comfort import duration_of
from jounce.ride.holding import mean
from jounce.ride.weighting import Start, weighted, weighting

Pair = tuple[float | None, float | None]
USUAL_WEIGHTING = {"x": "Wd", "y": "Wd", "z": "Wk", "roll": "We", "pitch": "We", "yaw": "We"}
_NO_PASSENGER = {"unsprung", "wheel", "tyre", "road", "platform", "knuckle", "upright", "axle", "strut"}


@dataclass(frozen=True)
class Choices:
    """What the user of the metrics has decided, SI.

    Attributes
    ----------
    settling : float
        Time at the start that does not count, s.
    weighting : mapping of str to str
        Weighting by channel or axis where it is not the usual one.
    start : {"rest", "first", "mean"}
        What was before the record, for the weightings.
    travel, stop_gap : mapping of str to pair of float
        Rebound and bump travel from the mean deflection (m), rebound and bump stop's gaps (m), by corner.
    exposure : float
        Daily exposure, s.
    lift_off_load : float
        Wheel load up to which the tyre counts as lifted, N.
    """

    settling: float = 0.0
    weighting: Mapping[str, str] = field(default_factory=dict)
    start: Start = "rest"
    travel: Mapping[str, Pair] = field(default_factory=dict)
    stop_gap: Mapping[str, Pair] = field(default_factory=dict)
    exposure: float = 8.0 * 3600.0
    lift_off_load: float = 0.0


@dataclass
class Motion:
    """One acceleration: ``values`` (m/s^2 or rad/s^2) at ``rate`` (Hz); what lies before ``first`` does not count."""

    channel: str
    axis: str
    values: Array
    rate: float
    first: int
    choices: Choices
    _weighted: dict[str, Array] = field(default_factory=dict, repr=False)

    @property
    def signal(self) -> Array:
        """The part that counts, unweighted."""
        return self.values[self.first :]

    @property
    def usual(self) -> str:
        """Name of its weighting."""
        chosen = self.choices.weighting
        return chosen.get(self.channel, chosen.get(self.axis, USUAL_WEIGHTING[self.axis]))

    def weighted(self, name: str = "") -> Array:
        """The part that counts, weighted over the whole record; refused when it is too short for the weighting."""
        row = weighting(name or self.usual)
        if row.name not in self._weighted:
            total = duration_of(self.signal, self.rate)
            if total < row.shortest * (1.0 - 1e-9):
                raise RecordingError(
                    f"the measurement is too short for {row.name}",
                    where=self.channel,
                    found=f"{total:g} s",
                    allowed=f"{row.shortest:g} s or more, one period of its lower limit",
                )
            found = weighted(self.values, self.rate, row.name, start=self.choices.start)
            self._weighted[row.name] = found[self.first :]
        return self._weighted[row.name]


@dataclass(frozen=True)
class Point:
    """Accelerations along the axes (x, y, z) at one place where people or goods are."""

    place: str
    motions: Mapping[str, Motion]


@dataclass(frozen=True)
class Corner:
    """Signals of one strut and tyre by the end of their names at ``rate`` (Hz); ``name`` is empty for a quarter car."""

    name: str
    signals: Mapping[str, Array]
    rate: float
    choices: Choices

    def __getitem__(self, suffix: str) -> Array:
        if suffix not in self.signals:
            raise RecordingError(f"no channel {self.name + '.' if self.name else ''}{suffix}")
        return self.signals[suffix]

    def has(self, suffix: str) -> bool:
        """Tell whether the channel is there."""
        return suffix in self.signals

    @property
    def stop_gaps(self) -> Pair:
        """Gaps of rebound and bump stop in m, None where there is none."""
        return self.choices.stop_gap.get(self.name, (None, None))

    def stop_gap(self, which: str) -> float:
        """Gap of the ``"bump"`` or ``"rebound"`` stop in m."""
        gap = self.stop_gaps[which == "bump"]
        if gap is None:
            raise RecordingError(f"no {which} stop's gap is given", where=self.name)
        return gap

    @property
    def travel(self) -> tuple[float, float]:
        """Rebound and bump travel in m from the mean deflection: as given, or up to the stops."""
        rebound, bump = self.choices.travel.get(self.name, (None, None))
        if rebound is None or bump is None:
            deflection = self.signals["strut.deflection"]
            middle, (below, above) = mean(deflection), self.stop_gaps
            if below is None or above is None:
                raise RecordingError("no available travel is given, nor both stops' gaps", where=self.name)
            rebound, bump = below + middle, above - middle
        if not (rebound > 0.0 and bump > 0.0):
            raise RecordingError(
                "the available travel is not positive",
                where=self.name,
                found=f"{rebound:g} m in rebound, {bump:g} m in bump",
                allowed="above 0 m from the mean deflection",
            )
        return rebound, bump


def carries_passengers(place: str) -> bool:
    """Tell whether a place lies on the sprung side, where comfort matters."""
    return place.rpartition(".")[2] not in _NO_PASSENGER
