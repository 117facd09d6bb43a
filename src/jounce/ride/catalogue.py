"""Ride metrics: one frozen row each with name, unit, label, source, and common confusions.

Integrals and means run from the end of the settling time to the end of the record. Deflections are positive in
compression.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import RecordingError
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.ride import absorbed_power as power
from jounce.ride import comfort
from jounce.ride.comfort import duration_of, integral
from jounce.ride.weighting import Start, check_duration, weight, weighting

# numbers of one signal ------------------------------------------------------------------------------------------------


def mean(values: Array) -> float:
    """Return the time mean in the unit of ``values``, by the trapezoidal rule."""
    return integral(values, 1.0) / duration_of(values, 1.0)


def deviation(values: Array) -> float:
    """Return the standard deviation about the time mean, in the unit of ``values``."""
    centred = values - mean(values)
    return float(mean(centred * centred) ** 0.5)


def peak_to_peak(values: Array) -> float:
    """Return maximum minus minimum, in the unit of ``values``."""
    return float(values.max() - values.min())


def peak_use(deflection: Array, rebound: float, bump: float) -> float:
    """Return the maximum share (1) of bump or rebound travel (m from the mean deflection) used by a deflection (m)."""
    middle = mean(deflection)
    return max(
        (float(deflection.max()) - middle) / bump, (middle - float(deflection.min())) / rebound
    )


def contacts(deflection: Array, gap: float) -> int:
    """Count (1) how often a deflection (m) closes a stop's gap (m), including a gap closed at the start."""
    closed = deflection > gap
    return int(np.count_nonzero(closed[1:] & ~closed[:-1])) + int(closed[0])


def share(condition: NDArray[np.bool_]) -> float:
    """Return the share (1) of time for which a condition is true."""
    return mean(condition.astype(float))


def load_coefficient(load: Array) -> float:
    """Return the standard deviation over mean (1) of a wheel load (N)."""
    return deviation(load) / _static(load)


def adhesion(load: Array) -> float:
    """Return the minimum over mean wheel load (1); loads in N."""
    return smallest(load) / _static(load)


def smallest(load: Array) -> float:
    """Return the minimum wheel load (N)."""
    return float(load.min()) + 0.0  # + 0.0 turns -0 into 0


def stress_factor(load: Array) -> float:
    """Return the mean fourth power of the wheel load (N) over the fourth power of its mean (1)."""
    relative = load / _static(load)
    return mean(relative**4)


def _static(load: Array) -> float:
    average = mean(load)
    if not average > 0.0:
        raise RecordingError(
            "the mean wheel load is not positive", found=f"{average:g} N", allowed="above 0 N"
        )
    return average


# parts of a recording used by metrics --------------------------------------------------------------------------------


Pair = tuple[float | None, float | None]
USUAL_WEIGHTING = {"x": "Wd", "y": "Wd", "z": "Wk", "roll": "We", "pitch": "We", "yaw": "We"}
_NO_PASSENGER = {
    "unsprung",
    "wheel",
    "tyre",
    "road",
    "platform",
    "knuckle",
    "upright",
    "axle",
    "strut",
}


@dataclass(frozen=True)
class Choices:
    """Options of the metrics, SI.

    The first ``settling`` seconds are skipped; ``weighting`` overrides the default weighting of a channel or an axis;
    ``start`` is the assumption about the time before the record. ``travel`` and ``stop_gap`` contain, for each corner,
    rebound and bump travel from the mean deflection and the gaps of rebound and bump stop (m). ``exposure`` is the
    daily duration (s); at wheel loads up to ``lift_off_load`` (N) a tyre is considered lifted off.
    """

    settling: float = 0.0
    weighting: Mapping[str, str] = field(default_factory=dict)
    start: Start = "rest"
    travel: Mapping[str, Pair] = field(default_factory=dict)
    stop_gap: Mapping[str, Pair] = field(default_factory=dict)
    exposure: float = 8.0 * 3600.0  # the working day that A(8) refers to
    lift_off_load: float = 0.0


@dataclass
class Acceleration:
    """One acceleration: ``values`` (m/s^2 or rad/s^2) at ``rate`` (Hz); samples before ``first`` are skipped."""

    channel: str
    axis: str
    values: Array
    rate: float
    first: int
    choices: Choices
    _weighted: dict[str, Array] = field(default_factory=dict, repr=False)

    @property
    def signal(self) -> Array:
        """Evaluated part, unweighted."""
        return self.values[self.first :]

    @property
    def usual(self) -> str:
        """Name of the weighting in use."""
        by_name = self.choices.weighting
        return by_name.get(self.channel, by_name.get(self.axis, USUAL_WEIGHTING[self.axis]))

    def filtered(self, name: str = "") -> Array:
        """Return the evaluated part of the weighted record; raise an error if it is too short for the weighting."""
        row = weighting(name or self.usual)
        if row.name not in self._weighted:
            check_duration(row.name, duration_of(self.signal, self.rate), where=self.channel)
            record = weight(self.values, self.rate, row.name, start=self.choices.start)
            self._weighted[row.name] = record[self.first :]
        return self._weighted[row.name]


@dataclass(frozen=True)
class Point:
    """Accelerations along the axes (x, y, z) at one position of people or goods."""

    place: str
    motions: Mapping[str, Acceleration]


@dataclass(frozen=True)
class CornerSignals:
    """Signals of one strut and tyre by suffix, at ``rate`` (Hz); ``name`` is empty for a quarter car."""

    name: str
    signals: Mapping[str, Array]
    rate: float
    choices: Choices

    def __getitem__(self, suffix: str) -> Array:
        if suffix not in self.signals:
            raise RecordingError(f"no channel {self.name + '.' if self.name else ''}{suffix}")
        return self.signals[suffix]

    def has(self, suffix: str) -> bool:
        """Whether the corner has the channel."""
        return suffix in self.signals

    @property
    def stop_gaps(self) -> Pair:
        """Gaps of rebound and bump stop in m; None for a stop without a gap."""
        return self.choices.stop_gap.get(self.name, (None, None))

    def stop_gap(self, which: str) -> float:
        """Return the gap of the ``"bump"`` or ``"rebound"`` stop in m."""
        gap = self.stop_gaps[which == "bump"]
        if gap is None:
            raise RecordingError(
                Phrase("no {which} stop's gap is given", which=which), where=self.name
            )
        return gap

    @property
    def travel(self) -> tuple[float, float]:
        """Return rebound and bump travel in m from the mean deflection: as given, or up to the stops."""
        rebound, bump = self.choices.travel.get(self.name, (None, None))
        if rebound is None or bump is None:
            deflection = self.signals["strut.deflection"]
            middle, (below, above) = mean(deflection), self.stop_gaps
            if below is None or above is None:
                raise RecordingError(
                    "neither the available travel nor the gaps of both stops are given",
                    where=self.name,
                )
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
    """Whether a position is on the sprung mass, where comfort matters."""
    return place.rpartition(".")[2] not in _NO_PASSENGER


# the catalogue --------------------------------------------------------------------------------------------------------


Scope = Literal["motion", "rotation", "comfort", "point", "corner"]
LINEAR, VERTICAL, TURNING = (
    ("ax", "ay", "az"),
    ("az",),
    ("roll_acceleration", "pitch_acceleration", "yaw_acceleration"),
)
_STRUT, _TYRE = "strut.deflection", "tyre.force"


@dataclass(frozen=True)
class RideMetric:
    """One row of the catalogue.

    ``formula`` computes the value from the part of a recording named by ``scope``, in the SI ``unit`` ("1" for ratios
    and counts). There is one value for each acceleration ("motion"), each rotational acceleration ("rotation"), each
    acceleration of people or goods ("comfort"), all axes of such a position together ("point"), or each corner.
    ``needs`` lists suffixes of channel names: any of them (motions, points), or all of them (corners). ``source`` is a
    standard or a definition; ``is_not`` describes common confusions and limitations.
    """

    name: str
    unit: str
    label: str
    formula: Callable[[Any], float]
    scope: Scope
    needs: tuple[str, ...]
    source: str
    is_not: str


def _total(view: Point) -> float:
    return comfort.total_value(
        {axis: comfort.rms(m.filtered(), m.rate) for axis, m in view.motions.items()}
    )


def _exposure(view: Acceleration) -> float:
    value = comfort.HEALTH_FACTORS[view.axis] * comfort.rms(view.filtered(), view.rate)
    return comfort.daily_exposure(value, view.choices.exposure)


def _sickness(view: Acceleration) -> float:
    return comfort.SICK_PER_DOSE * comfort.msdv(view.filtered("Wf"), view.rate)


def _absorbed(view: Acceleration) -> float:
    """Return the mean absorbed power (W) of the evaluated part; the filter has seen what came before."""
    course = power.power_course(view.values, view.rate, start=view.choices.start)[view.first :]
    power.check_length(duration_of(course, view.rate), where=view.channel)
    return mean(course)


def _shock(view: Acceleration) -> float:
    course = power.shock_course(view.values, view.rate, start=view.choices.start)
    return float(abs(course[view.first :]).max())


def _power(view: CornerSignals) -> float:
    force = view["strut.damper_force"] if view.has("strut.damper_force") else view["strut.force"]
    return mean(force * view["strut.velocity"])


def _use(view: CornerSignals) -> float:
    return peak_use(view[_STRUT], *view.travel)


_ISO, _DIRECTIVE = "ISO 2631-1:1997, ", "2002/44/EC and ISO 2631-1:1997, 7.2"
_PLAIN, _OWN = "statistics of the signal", "definition of jounce"

# fmt: off
CATALOGUE: tuple[RideMetric, ...] = (
    RideMetric("rms_acceleration", "m/s^2", "r.m.s. of the acceleration about its mean", lambda v: deviation(v.signal),
        "motion", LINEAR, _PLAIN, "not weighted: what people feel depends on frequency"),
    RideMetric("peak_acceleration", "m/s^2", "largest deviation of the acceleration from its mean",
        lambda v: float(abs(v.signal - mean(v.signal)).max()), "motion", LINEAR, _PLAIN,
        "not weighted, and decided by a single sample"),
    RideMetric("rms_angular_acceleration", "rad/s^2", "r.m.s. of the angular acceleration about its mean",
        lambda v: deviation(v.signal), "rotation", TURNING, _PLAIN, "not weighted"),
    RideMetric("weighted_rms_angular_acceleration", "rad/s^2", "weighted r.m.s. angular acceleration, We",
        lambda v: comfort.rms(v.filtered(), v.rate), "rotation", TURNING, _ISO + "6.1",
        "not yet comparable with translation: multiply by 0.63, 0.4, 0.2 m/rad (roll, pitch, yaw)"),
    RideMetric("weighted_rms", "m/s^2", "weighted r.m.s. acceleration a_w (Wk vertical, Wd horizontal)",
        lambda v: comfort.rms(v.filtered(), v.rate), "comfort", LINEAR, _ISO + "6.1",
        "at the place of the channel, without a seat's transmissibility; says little about single shocks"),
    RideMetric("mtvv", "m/s^2", "maximum transient vibration value: largest running r.m.s. over 1 s",
        lambda v: comfort.mtvv(v.filtered(), v.rate), "comfort", LINEAR, _ISO + "6.3.1, eq. 2",
        "not a peak: shorter shocks are averaged over 1 s"),
    RideMetric("mtvv_exponential", "m/s^2", "maximum transient vibration value, exponential averaging",
        lambda v: comfort.mtvv(v.filtered(), v.rate, averaging="exponential"), "comfort", LINEAR,
        _ISO + "6.3.1, eq. 3", "up to 30 % off the linear one for longer shocks; say which is used"),
    RideMetric("vdv", "m/s^1.75", "fourth power vibration dose value", lambda v: comfort.vdv(v.filtered(), v.rate),
        "comfort", LINEAR, _ISO + "6.3.2", "grows with the length of the record: compare equal lengths only"),
    RideMetric("evdv", "m/s^1.75", "estimated vibration dose value, 1.4 a_w T^(1/4)",
        lambda v: comfort.evdv(v.filtered(), v.rate), "comfort", LINEAR, _ISO + "annex B",
        "an estimate for vibration without shocks; where both differ, VDV counts"),
    RideMetric("crest_factor", "1", "largest weighted acceleration over a_w",
        lambda v: comfort.crest_factor(v.filtered(), v.rate), "comfort", LINEAR, _ISO + "6.2.1",
        "no measure of severity: it says whether a_w suffices (up to 9)"),
    RideMetric("daily_exposure", "m/s^2", "A(8): 1.4 a_w (x, y) or a_w (z), over the daily exposure", _exposure,
        "comfort", LINEAR, _DIRECTIVE,
        "per axis: the largest of the three counts against 0.5 (action) and 1.15 m/s^2 (limit)"),
    RideMetric("msdv_z", "m/s^1.5", "motion sickness dose value, Wf", lambda v: comfort.msdv(v.filtered("Wf"), v.rate),
        "comfort", VERTICAL, _ISO + "annex D",
        "of vertical motion only, for 20 min to 6 h; grows with the length of the record"),
    RideMetric("motion_sickness", "1", "share of unadapted people likely to vomit, MSDV_z / 300", _sickness, "comfort",
        VERTICAL, _ISO + "annex D", "for 20 min to 6 h and a mixed population; not for single bumps"),
    RideMetric("absorbed_power", "W", "mean power that a seated person absorbs", _absorbed, "comfort", VERTICAL,
        "Lee and Pradko 1968, filter of Project Chrono",
        "at the place of the channel, not of a seat; of a shock it depends on the length of the record; the limit of "
        "NRMM is 6 W"),
    RideMetric("shock", "m/s^2", "largest magnitude of the acceleration below 30 Hz", _shock, "comfort", VERTICAL,
        "Project Chrono, NRMM", "decided by one event: 2.5 g is the limit of NRMM over a discrete obstacle"),
    RideMetric("vibration_total_value", "m/s^2", "a_v: root of the sum of squares of a_w over the axes recorded",
        _total, "point", LINEAR, _ISO + "6.5 and annex C",
        "without rotation, seat back and feet; axes not recorded count as zero"),
    RideMetric("travel_rms", "m", "r.m.s. deflection of the strut about its mean", lambda v: deviation(v[_STRUT]),
        "corner", (_STRUT,), _PLAIN, "along the strut, not at the wheel"),
    RideMetric("travel_peak_to_peak", "m", "largest minus smallest deflection of the strut",
        lambda v: peak_to_peak(v[_STRUT]), "corner", (_STRUT,), _PLAIN,
        "along the strut; grows with the length of the record"),
    RideMetric("peak_bump_velocity", "m/s", "largest velocity of the strut in bump",
        lambda v: max(0.0, float(v["strut.velocity"].max())), "corner", ("strut.velocity",), _PLAIN,
        "along the strut; decided by a single sample"),
    RideMetric("peak_rebound_velocity", "m/s", "largest velocity of the strut in rebound",
        lambda v: max(0.0, -float(v["strut.velocity"].min())), "corner", ("strut.velocity",), _PLAIN,
        "along the strut; decided by a single sample"),
    RideMetric("travel_utilisation", "1", "largest share of the bump or rebound travel used, from the mean deflection",
        _use, "corner", (_STRUT,), _OWN, "1 means that a stop is reached; above 1 it is compressed"),
    RideMetric("travel_utilisation_rms", "1", "r.m.s. deflection over the whole travel available",
        lambda v: deviation(v[_STRUT]) / sum(v.travel), "corner", (_STRUT,), _OWN,
        "not the probability of reaching a stop"),
    RideMetric("travel_utilisation_peak_to_peak", "1", "peak to peak deflection over the whole travel available",
        lambda v: peak_to_peak(v[_STRUT]) / sum(v.travel), "corner", (_STRUT,), _OWN,
        "may stay below 1 although one stop is hit"),
    RideMetric("bump_stop_hits", "1", "number of bump stop contacts", lambda v: contacts(v[_STRUT], v.stop_gap("bump")),
        "corner", (_STRUT,), _OWN, "a count over the record, not a force"),
    RideMetric("rebound_stop_hits", "1", "number of rebound stop contacts",
        lambda v: contacts(-v[_STRUT], v.stop_gap("rebound")), "corner", (_STRUT,), _OWN,
        "a count over the record, not a force"),
    RideMetric("bump_stop_time", "1", "share of time on the bump stop",
        lambda v: share(v[_STRUT] > v.stop_gap("bump")), "corner", (_STRUT,), _OWN,
        "says nothing about how hard it is hit"),
    RideMetric("dissipated_power", "W", "mean power into the strut (into the damper where its force is recorded)",
        _power, "corner", ("strut.force", "strut.velocity"), "mean of force times velocity",
        "for a whole strut it is the damper's only over closed cycles: springs return what they store"),
    RideMetric("dynamic_load_rms", "N", "r.m.s. wheel load about its mean", lambda v: deviation(v[_TYRE]), "corner",
        (_TYRE,), _PLAIN, "a sum for the axle or the car only where the wheels are independent"),
    RideMetric("dynamic_load_coefficient", "1", "standard deviation over mean of the wheel load",
        lambda v: load_coefficient(v[_TYRE]), "corner", (_TYRE,), "Sweatman 1983",
        "of the record's own mean, which braking and bends move"),
    RideMetric("minimum_wheel_load", "N", "minimum wheel load", lambda v: smallest(v[_TYRE]), "corner", (_TYRE,),
        _PLAIN, "0 whenever the wheel lifts off, however briefly"),
    RideMetric("adhesion", "1", "minimum over mean wheel load", lambda v: adhesion(v[_TYRE]), "corner", (_TYRE,),
        "as the EUSAMA value, on the road", "not the tester's value: the excitation differs"),
    RideMetric("lift_off_time", "1", "share of time with the wheel off the ground",
        lambda v: share(v[_TYRE] <= v.choices.lift_off_load), "corner", (_TYRE,), _OWN,
        "measured loads are never exactly 0: give a threshold"),
    RideMetric("road_stress_factor", "1", "mean fourth power of the wheel load over that of its mean",
        lambda v: stress_factor(v[_TYRE]), "corner", (_TYRE,), "Eisenmann 1975",
        "1 + 6 c^2 + 3 c^4 for Gaussian loads of coefficient c; says nothing about a place on the road"),
    RideMetric("tyre_deflection_rms", "m", "r.m.s. deflection of the tyre about its mean",
        lambda v: deviation(v["tyre.deflection"]), "corner", ("tyre.deflection",), _PLAIN,
        "not proportional to the load once the wheel lifts off"),
)
# fmt: on
"""All ride metrics, in the order of reports."""
