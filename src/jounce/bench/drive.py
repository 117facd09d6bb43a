"""Drive of the bench: belt speed from inverter frequency or photo-sensor pulses, and load of the motor."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, Any, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from jounce.bench.estimated import estimated_default, estimates_used
from jounce.core.description import Description, Whole
from jounce.core.errors import DescriptionError, FitError
from jounce.core.findings import Finding, finding
from jounce.core.operation import Count, MadeBy, Number, operation
from jounce.core.phrases import Phrase
from jounce.core.serialise import Plain, to_plain
from jounce.core.typed import LONGEST
from jounce.core.units import (
    Frequency,
    NonNegativeDampingCoefficient,
    NonNegativeForce,
    NonNegativeLength,
    PositiveLength,
    Unit,
    positive_si,
    to_si,
)
from jounce.identify.estimate import Estimate, estimate

AngularSpeed = Annotated[float, Unit("rad/s", above=0.0)]
Power = Annotated[float, Unit("W", above=0.0)]
Share = Annotated[float, Unit("1", at_least=0.0, at_most=0.9)]
Efficiency = Annotated[float, Unit("1", above=0.0, at_most=1.0)]
_SPEED_FIELDS = ("cylinder_radius", "belt_thickness", "pulley_slip", "flat_belt_slip")


class BenchDrive(Description):
    """Motor, pulleys, cylinder and flat belt of the bench.

    The defaults are the published values. The following were not published and are *estimated*: ``cylinder_radius``
    50 mm, ``belt_thickness`` 3 mm, ``pulley_slip`` 2 % (slip of the belt between motor and cylinder),
    ``flat_belt_slip`` 0, ``efficiency`` 0.95, ``standstill_torque`` 0.5 (fraction of the rated torque that a
    self-ventilated motor sustains at standstill, rising linearly to 1 at the supply frequency).

    Attributes
    ----------
    motor_power : float
        Rated power of the motor.
    supply_frequency : float
        Rated frequency of the motor.
    rated_motor_speed : float
        Rated speed of the motor.
    pole_pairs : int
        Pole pairs of the motor.
    motor_pulley_diameter : float
        Diameter of the pulley on the motor.
    cylinder_pulley_diameter : float
        Diameter of the pulley on the cylinder.
    belt_length : float
        Length of the belt loop.
    belt_reference : str
        Effective radius of the belt: pitch (R + t/2; the belt does not stretch), outer (R + t) or bare (R).
    cylinder_radius : float
        Radius R of the cylinder.
    belt_thickness : float
        Thickness t of the flat belt.
    pulley_slip : float
        Slip between motor and cylinder.
    flat_belt_slip : float
        Slip between cylinder and flat belt.
    efficiency : float
        Efficiency of the drive.
    standstill_torque : float
        Fraction of the rated torque that the motor sustains at standstill.
    """

    motor_power: Power = 1500.0
    supply_frequency: Frequency = 60.0
    rated_motor_speed: AngularSpeed = 356.05
    pole_pairs: Annotated[Whole, Field(ge=1, le=8)] = 1
    motor_pulley_diameter: PositiveLength = 0.060
    cylinder_pulley_diameter: PositiveLength = 0.120
    belt_length: PositiveLength = 1.97
    belt_reference: Literal["pitch", "outer", "bare"] = "pitch"
    cylinder_radius: PositiveLength = estimated_default(0.050, "typical for a bench belt of 1.97 m")
    belt_thickness: NonNegativeLength = estimated_default(0.003, "typical flat belt")
    pulley_slip: Share = estimated_default(0.02, "typical V-belt under load")
    flat_belt_slip: Share = estimated_default(0.0, "not observable with a sensor on the cylinder")
    efficiency: Efficiency = estimated_default(0.95, "typical V-belt")
    standstill_torque: Efficiency = estimated_default(
        0.5, "typical self-ventilated motor on an inverter"
    )

    @property
    def ratio(self) -> float:
        """Ratio of motor speed to cylinder speed without slip [1]."""
        return self.cylinder_pulley_diameter / self.motor_pulley_diameter

    @property
    def radius(self) -> float:
        """Effective radius of the belt [m], see ``belt_reference``."""
        share = {"pitch": 0.5, "outer": 1.0, "bare": 0.0}[self.belt_reference]
        return self.cylinder_radius + self.belt_thickness * share

    @property
    def motor_slip(self) -> float:
        """Rated slip of the motor [1]."""
        return 1.0 - self.rated_motor_speed * self.pole_pairs / (
            2.0 * math.pi * self.supply_frequency
        )

    @property
    def rated_torque(self) -> float:
        """Rated torque of the motor [N m]."""
        return self.motor_power / self.rated_motor_speed


@dataclass(frozen=True)
class BeltSpeed:
    """Speeds along the drive at one inverter frequency.

    Attributes
    ----------
    inverter_frequency : float
        Frequency set at the inverter [Hz].
    motor_speed, cylinder_speed : float
        Angular speeds, including the slip of motor and pulleys [rad/s].
    ideal_speed : float
        Belt speed at the motor's rated slip, without slip between motor and belt [m/s].
    sensor_speed : float
        Speed indicated by a photo-sensor on the cylinder [m/s].
    speed : float
        Belt speed [m/s].
    recurrence_time : float
        Time after which an obstacle fixed to the belt returns [s].
    findings : tuple of Finding
        Estimated values used, and slip that the sensor cannot detect.
    """

    inverter_frequency: float
    motor_speed: float
    cylinder_speed: float
    ideal_speed: float
    sensor_speed: float
    speed: float
    recurrence_time: float
    findings: tuple[Finding, ...]


def belt_speed(drive: BenchDrive, inverter_frequency: float) -> BeltSpeed:
    """Compute the belt speed at an inverter frequency (Hz, above 0).

    Examples
    --------
    >>> bench = BenchDrive(belt_reference="bare", pulley_slip=0.0)
    >>> round(belt_speed(bench, 60.0).cylinder_speed, 3)
    178.025
    """
    _check_positive(inverter_frequency, "inverter frequency", "Hz")
    motor = 2.0 * math.pi * inverter_frequency * (1.0 - drive.motor_slip) / drive.pole_pairs
    ideal = motor / drive.ratio * drive.radius
    sensor = ideal * (1.0 - drive.pulley_slip)
    speed = sensor * (1.0 - drive.flat_belt_slip)
    return BeltSpeed(
        inverter_frequency=inverter_frequency,
        motor_speed=motor,
        cylinder_speed=motor / drive.ratio * (1.0 - drive.pulley_slip),
        ideal_speed=ideal,
        sensor_speed=sensor,
        speed=speed,
        recurrence_time=drive.belt_length / speed,
        findings=(*estimates_used(drive, "bench drive", _SPEED_FIELDS), _unseen_slip(drive)),
    )


def inverter_frequency_for(drive: BenchDrive, speed: float) -> float:
    """Return the inverter frequency [Hz] at which the belt runs at ``speed`` [m/s].

    Examples
    --------
    >>> bench = BenchDrive(belt_reference="bare", pulley_slip=0.0)
    >>> round(inverter_frequency_for(bench, 3.87), 2)
    26.09
    """
    _check_positive(speed, "belt speed", "m/s")
    return speed / belt_speed(drive, 1.0).speed


def _unseen_slip(drive: BenchDrive) -> Finding:
    return finding(
        "bench.unseen_slip", "bench drive", drive.flat_belt_slip, slip=drive.flat_belt_slip
    )


def _check_positive(value: float, what: str, unit: str) -> None:
    if not (math.isfinite(value) and value > 0.0):
        raise FitError(
            Phrase("the {what} is not positive", what=what),
            found=f"{value} {unit}",
            allowed=Phrase("above 0 {unit}", unit=unit),
        )


@dataclass(frozen=True)
class SensorSpeed:
    """Belt speed counted by the photo-sensor on the cylinder.

    Attributes
    ----------
    speed : Estimate
        Belt speed [m/s].
    cylinder_speed : Estimate
        Angular speed of the cylinder [rad/s].
    resolution : float
        Change of the speed by one pulse [m/s].
    recurrence_time : float
        Belt length divided by speed [s].
    findings : tuple of Finding
        Estimated values used, coarse counting, and slip that the sensor cannot detect.
    """

    speed: Estimate
    cylinder_speed: Estimate
    resolution: float
    recurrence_time: float
    findings: tuple[Finding, ...]


def photo_sensor_speed(
    drive: BenchDrive,
    pulses: int,
    duration: float,
    *,
    pulses_per_revolution: int = 1,
    radius_error: float = 0.0,
) -> SensorSpeed:
    """Estimate the belt speed, with its 95 % interval, from the pulses counted in a window of ``duration`` (s).

    The start and end of the counting window fall anywhere between two pulses, so the count has a standard deviation of
    1/sqrt(6) pulses. ``radius_error`` (m), the standard error of the belt's effective radius, adds to the error.

    Examples
    --------
    >>> counted = photo_sensor_speed(BenchDrive(), 62, 10.0)
    >>> round(counted.speed.value, 3), round(counted.speed.standard_error, 3)
    (2.006, 0.013)
    """
    _check_positive(pulses, "number of pulses", "")
    _check_positive(pulses_per_revolution, "number of pulses per revolution", "")
    _check_positive(duration, "duration", "s")
    if radius_error < 0.0:
        raise FitError(
            "the uncertainty of the radius is negative",
            found=f"{radius_error} m",
            allowed="0 m or more",
        )
    per_pulse = 2.0 * math.pi / (pulses_per_revolution * duration)
    angular = estimate(pulses * per_pulse, per_pulse / math.sqrt(6.0))
    speed = angular.value * drive.radius
    error = math.hypot(per_pulse / math.sqrt(6.0) * drive.radius, angular.value * radius_error)
    findings = [*estimates_used(drive, "photo-sensor", _SPEED_FIELDS[:2]), _unseen_slip(drive)]
    if pulses < 40:
        findings.append(
            finding("bench.pulse_coarse", "photo-sensor", 1.0 / pulses, share=100.0 / pulses)
        )
    return SensorSpeed(
        estimate(speed, error),
        angular,
        per_pulse * drive.radius,
        drive.belt_length / speed,
        tuple(findings),
    )


Inertia = Annotated[float, Unit("kg*m^2", at_least=0.0)]
Limit = Literal["supply frequency", "torque", "cooling"]


class BeltLoad(Description):
    """Resistance of the belt.

    Required pull = rolling_resistance * wheel_load + bed_friction * bed_load + bending_force + drag * speed
    + inertia * acceleration / radius^2. No values are published: all are *estimated*. ``wheel_load`` is
    the weight of 16 kg sprung and an estimated 5 kg unsprung mass; ``bed_load`` presses the belt onto its metal support
    and equals the wheel load by default.

    Attributes
    ----------
    wheel_load : float
        Wheel load on the belt.
    rolling_resistance : float
        Rolling resistance coefficient of the tyre.
    bed_friction : float
        Coefficient of friction between belt and bed.
    bed_load : float
        Load of the belt on its bed. Default: the wheel load.
    bending_force : float
        Pull needed to bend the belt.
    drag : float
        Resistance proportional to speed.
    inertia : float
        Moment of inertia at the cylinder.
    acceleration : float
        Acceleration of the belt.
    """

    wheel_load: NonNegativeForce = estimated_default(206.0, "16 kg sprung and 5 kg unsprung mass")
    rolling_resistance: Annotated[float, Unit("1", at_least=0.0)] = estimated_default(
        0.02, "small pneumatic tyre"
    )
    bed_friction: Annotated[float, Unit("1", at_least=0.0)] = estimated_default(
        0.3, "belt back on sheet metal"
    )
    bed_load: NonNegativeForce | None = None
    bending_force: NonNegativeForce = estimated_default(
        10.0, "bending a thin flat belt round two cylinders"
    )
    drag: NonNegativeDampingCoefficient = estimated_default(0.0, "bearing losses neglected")
    inertia: Inertia = estimated_default(0.0, "constant speed")
    acceleration: Annotated[float, Unit("m/s^2")] = 0.0

    def force(self, speed: float, radius: float) -> float:
        """Return the pull required at the belt [N] for ``speed`` [m/s] and cylinders of ``radius`` [m]."""
        bed = self.wheel_load if self.bed_load is None else self.bed_load
        resting = (
            self.rolling_resistance * self.wheel_load + self.bed_friction * bed + self.bending_force
        )
        return resting + self.drag * speed + self.inertia * self.acceleration / radius**2


@dataclass(frozen=True)
class DriveMargin:
    """Required and available torque and power of the motor at one belt speed.

    Attributes
    ----------
    speed, inverter_frequency : float
        Belt speed [m/s] and the frequency that produces it [Hz].
    required_force, available_force, continuous_force : float
        Pull at the belt: required, at rated torque, and at the torque that the motor sustains without overheating [N].
    required_power, available_power : float
        Power at the belt [W].
    required_torque, rated_torque : float
        Torque at the motor [N m].
    margin, continuous_margin : float
        (available - required) / available pull [1]; negative if the drive is overloaded.
    findings : tuple of Finding
        Overload, overheating, estimated values used.
    """

    speed: float
    inverter_frequency: float
    required_force: float
    available_force: float
    continuous_force: float
    required_power: float
    available_power: float
    required_torque: float
    rated_torque: float
    margin: float
    continuous_margin: float
    findings: tuple[Finding, ...]


def drive_margin(drive: BenchDrive, speed: float, load: BeltLoad | None = None) -> DriveMargin:
    """Compare the pull and power required at a belt speed (m/s, above 0) with the capacity of the motor.

    An inverter keeps the ratio of voltage to frequency constant, so the rated *torque* is available at every speed up
    to the supply frequency, and the power grows with the speed. A motor cooled by its own fan must stay below the rated
    torque at low speed. Without a ``load`` the resistance of the belt is estimated.

    Examples
    --------
    >>> bench = BenchDrive(belt_reference="bare", efficiency=1.0, pulley_slip=0.0)
    >>> margin = drive_margin(bench, 3.87)
    >>> round(margin.available_force, 1), round(margin.available_power)
    (168.5, 652)
    """
    load = load or BeltLoad()
    frequency = inverter_frequency_for(drive, speed)
    pull = drive.rated_torque * drive.ratio * drive.efficiency / drive.radius
    available = (
        pull if frequency <= drive.supply_frequency else pull * drive.supply_frequency / frequency
    )
    continuous = available * _cooling(drive, frequency)
    required = load.force(speed, drive.radius)
    margin, lasting = 1.0 - required / available, 1.0 - required / continuous
    findings = [*estimates_used(drive, "bench drive"), *estimates_used(load, "belt load")]
    findings += _overload(margin, lasting, speed, frequency, drive)
    return DriveMargin(
        speed=speed,
        inverter_frequency=frequency,
        required_force=required,
        available_force=available,
        continuous_force=continuous,
        required_power=required * speed,
        available_power=available * speed,
        required_torque=required * drive.radius / (drive.ratio * drive.efficiency),
        rated_torque=drive.rated_torque,
        margin=margin,
        continuous_margin=lasting,
        findings=tuple(findings),
    )


def _cooling(drive: BenchDrive, frequency: float) -> float:
    """Return the fraction of its torque that a self-ventilated motor sustains at an inverter frequency."""
    share = min(frequency / drive.supply_frequency, 1.0)
    return drive.standstill_torque + (1.0 - drive.standstill_torque) * share


def _overload(
    margin: float, lasting: float, speed: float, frequency: float, drive: BenchDrive
) -> list[Finding]:
    findings = []
    if frequency > drive.supply_frequency:
        findings.append(
            finding(
                "bench.above_supply",
                "bench drive",
                frequency,
                speed=speed,
                frequency=frequency,
                supply=drive.supply_frequency,
            )
        )
    if margin < 0.0:
        findings.append(finding("bench.torque_short", "bench drive", margin, speed=speed))
    elif lasting < 0.0:
        findings.append(finding("bench.cooling_short", "bench drive", lasting, speed=speed))
    return findings


@dataclass(frozen=True)
class AttainableSpeed:
    """Attainable speed of the belt.

    Attributes
    ----------
    speed : float
        Highest belt speed that the motor can sustain [m/s]; 0 if there is none.
    limited_by : {"supply frequency", "torque", "cooling"}
        Limiting factor.
    short_time_speed : float
        Highest belt speed within the rated torque, ignoring heating [m/s].
    lowest_continuous_speed : float
        Speed below which the motor's own fan does not cool it sufficiently [m/s]; 0 if it always does.
    implied_force : float or None
        Pull that would explain an observed ceiling [N].
    findings : tuple of Finding
        Explanation of an observed ceiling, estimated values used.
    """

    speed: float
    limited_by: Limit
    short_time_speed: float
    lowest_continuous_speed: float
    implied_force: float | None
    findings: tuple[Finding, ...]


def attainable_speed(
    drive: BenchDrive, load: BeltLoad | None = None, *, observed_ceiling: float | None = None
) -> AttainableSpeed:
    """Find the highest belt speed and its limiting factor; without a ``load`` the resistance is estimated.

    With ``observed_ceiling``, a speed (m/s) that was not exceeded in practice (e.g. 3.87 on the paper's bench), the
    result includes the pull that would explain it.

    Examples
    --------
    >>> attainable_speed(BenchDrive()).limited_by
    'supply frequency'
    """
    load = load or BeltLoad()
    top = belt_speed(drive, drive.supply_frequency).speed
    speeds = np.linspace(top / 2000.0, top, 2000)
    margins = [drive_margin(drive, float(speed), load) for speed in speeds]
    short = np.array([margin.margin >= 0.0 for margin in margins])
    lasting = np.array([margin.continuous_margin >= 0.0 for margin in margins])
    limited = _limit(short, lasting)
    findings = [*estimates_used(drive, "bench drive"), *estimates_used(load, "belt load")]
    implied = None
    if observed_ceiling is not None:
        implied, text = _resistance_at_ceiling(drive, load, observed_ceiling)
        findings.append(Finding("bench drive", "note", text, implied))
    return AttainableSpeed(
        speed=float(speeds[lasting][-1]) if lasting.any() else 0.0,
        limited_by=limited,
        short_time_speed=float(speeds[short][-1]) if short.any() else 0.0,
        lowest_continuous_speed=float(speeds[lasting][0])
        if lasting.any() and not lasting[0]
        else 0.0,
        implied_force=implied,
        findings=tuple(findings),
    )


def _limit(short: NDArray[np.bool_], lasting: NDArray[np.bool_]) -> Limit:
    """Return the limiting factor just above the highest speed that the motor can sustain."""
    if lasting[-1]:
        return "supply frequency"
    above = int(np.flatnonzero(lasting)[-1]) + 1 if lasting.any() else 0
    return "cooling" if short[above] else "torque"


def _resistance_at_ceiling(drive: BenchDrive, load: BeltLoad, ceiling: float) -> tuple[float, str]:
    there = drive_margin(drive, ceiling, load)
    text = (
        f"a ceiling of {ceiling:.3g} m/s implies a belt resistance of {there.continuous_force:.0f} N (motor "
        f"overheats) to {there.available_force:.0f} N (rated torque reached); the load described here is "
        f"{there.required_force:.0f} N."
    )
    return there.continuous_force, text


PUBLISHED_CEILING = 3.87  # m/s
"""Highest belt speed (m/s) of the published bench."""


@dataclass(frozen=True)
class BeltSpeeds(Plain):
    """Belt speed from the inverter frequency, from the photo-sensor, or from both for comparison.

    Attributes
    ----------
    inverter : BeltSpeed or None
        Speed from the inverter frequency.
    photo_sensor : SensorSpeed or None
        Speed from counted pulses.
    """

    inverter: BeltSpeed | None
    photo_sensor: SensorSpeed | None

    @property
    def speed(self) -> float:
        """Belt speed, m/s: from counted pulses if available, otherwise from the inverter."""
        return (
            self.photo_sensor.speed.value
            if self.photo_sensor
            else self.inverter.speed
            if self.inverter
            else 0.0
        )

    @property
    def findings(self) -> tuple[Finding, ...]:
        """Findings of inverter and photo-sensor."""
        return _together(self.inverter, self.photo_sensor)

    def to_dict(self) -> dict[str, Any]:
        """Return the result as plain values, SI."""
        both = {
            "inverter": _without_findings(self.inverter),
            "photo_sensor": _without_findings(self.photo_sensor),
        }
        return {"speed": self.speed, **both, "findings": to_plain(self.findings)}


@operation(
    "bench speed",
    faces={"radius_error": "0 mm"},
    python_only=("motor_power", "efficiency", "standstill_torque"),
    arguments=0,
    page="jounce.report.bench:belt_speed_page",
    title="Belt speed",
    example='jounce bench speed --inverter-frequency "24.6 Hz" --cylinder-radius "50 mm"',
)
def find_belt_speed(
    drive: Annotated[BenchDrive, MadeBy("jounce.bench.drive:BenchDrive")],
    inverter_frequency: Annotated[
        float | str | None, Number('Frequency set at the inverter, e.g. "24.6 Hz".', "VALUE", "Hz")
    ] = None,
    *,
    speed: Annotated[
        float | str | None,
        Number(
            "Belt speed to reach; gives the inverter frequency.", "VALUE", "m/s", is_positive=True
        ),
    ] = None,
    pulses: Annotated[
        int | None, Count("Pulses counted by the photo-sensor on the cylinder.")
    ] = None,
    duration: Annotated[
        float | str | None, Number("Counting time of the pulses.", "VALUE", "s", is_positive=True)
    ] = None,
    pulses_per_revolution: Annotated[int, Count("Marks on the cylinder.")] = 1,
    radius_error: Annotated[
        float | str, Number("Standard error of the radius.", "VALUE", "m", most=LONGEST)
    ] = 0.0,
) -> BeltSpeeds:
    """Find the belt speed from the inverter frequency or from photo-sensor pulses, or the frequency for a speed.

    Parameters
    ----------
    drive : BenchDrive
        The bench.
    inverter_frequency : float or str, optional
        Frequency set at the inverter, Hz.
    speed : float or str, optional
        Desired belt speed, m/s, instead of the frequency.
    pulses : int, optional
        Pulses of the photo-sensor on the cylinder, counted over ``duration``.
    duration : float or str, optional
        Counting time, s.
    pulses_per_revolution : int
        Marks on the cylinder.
    radius_error : float or str
        Standard error of the belt's effective radius, m.

    Returns
    -------
    BeltSpeeds
        Speeds along the drive, SI.

    Raises
    ------
    DescriptionError
        If no input determines a speed, or if the pulses or their counting time are missing.
    FitError
        If a value is not positive.

    Examples
    --------
    >>> round(find_belt_speed(BenchDrive(), "24.6 Hz", pulses=62, duration="10 s").speed, 3)
    2.006
    """
    if (
        inverter_frequency is not None and speed is not None
    ) or inverter_frequency == speed == pulses:
        raise DescriptionError(
            "give an inverter frequency, a speed or pulses",
            where="jounce bench speed",
            allowed='either --inverter-frequency "24.6 Hz" or --speed "1.95 m/s", and/or --pulses 62 --duration "10 s"',
        )
    if pulses is None and duration is not None:
        hint = "Add --pulses, or omit --duration."
        raise DescriptionError(
            "--duration is the time in which --pulses are counted, but --pulses is missing",
            hint=hint,
        )
    if pulses is not None and duration is None:
        raise DescriptionError(
            "--duration is missing: the time in which the pulses were counted",
            allowed='--duration "10 s"',
        )
    frequency = (
        None
        if inverter_frequency is None
        else to_si(inverter_frequency, "Hz", where="inverter_frequency")
    )
    if speed is not None:
        frequency = inverter_frequency_for(drive, positive_si(speed, "m/s", where="speed"))
    computed = None if frequency is None else belt_speed(drive, frequency)
    if pulses is None or duration is None:
        return BeltSpeeds(computed, None)
    counted = photo_sensor_speed(
        drive,
        pulses,
        positive_si(duration, "s", where="duration"),
        pulses_per_revolution=pulses_per_revolution,
        radius_error=to_si(radius_error, "m", where="radius_error"),
    )
    return BeltSpeeds(computed, counted)


@dataclass(frozen=True)
class DriveAssessment(Plain):
    """Load of the motor at a belt speed, and the attainable speed.

    Attributes
    ----------
    margin : DriveMargin or None
        Margin at the requested speed.
    attainable : AttainableSpeed
        Highest belt speed and its limiting factor.
    """

    margin: DriveMargin | None
    attainable: AttainableSpeed

    @property
    def findings(self) -> tuple[Finding, ...]:
        """Findings of margin and attainable speed."""
        return _together(self.margin, self.attainable)

    def to_dict(self) -> dict[str, Any]:
        """Return the result as plain values, SI."""
        margin, attainable = (
            _without_findings(self.margin) or {},
            _without_findings(self.attainable),
        )
        return {**margin, "attainable": attainable, "findings": to_plain(self.findings)}


@operation(
    "bench drive",
    python_only=("belt_length",),
    arguments=0,
    page="jounce.report.bench:drive_page",
    title="Drive",
    example='jounce bench drive --speed "3.87 m/s" --cylinder-radius "50 mm"',
)
def assess_drive(
    drive: Annotated[BenchDrive, MadeBy("jounce.bench.drive:BenchDrive")],
    load: Annotated[BeltLoad, MadeBy("jounce.bench.drive:BeltLoad")],
    *,
    speed: Annotated[
        float | str | None,
        Number('Belt speed to assess, e.g. "3.87 m/s".', "VALUE", "m/s", is_positive=True),
    ] = None,
    observed_ceiling: Annotated[
        float | str | None,
        Number(
            "Highest speed reached in practice; gives the pull that would explain it. Default: 3.87 m/s for the "
            "published bench, if no other value is changed.",
            "VALUE",
            "m/s",
        ),
    ] = None,
) -> DriveAssessment:
    """Assess the drive: torque and power margin at a belt speed, the attainable speed, and its limiting factor.

    Parameters
    ----------
    drive : BenchDrive
        The bench.
    load : BeltLoad
        Resistance of the belt.
    speed : float or str, optional
        Belt speed to assess, m/s.
    observed_ceiling : float or str, optional
        Highest speed reached in practice, m/s; by default that of the published bench, if ``drive`` and ``load`` are
        unchanged.

    Returns
    -------
    DriveAssessment
        Margin and attainable speed, SI.

    Examples
    --------
    >>> found = assess_drive(BenchDrive(), BeltLoad(), speed="3.87 m/s")
    >>> found.attainable.limited_by, found.margin.margin > 0.0
    ('supply frequency', True)
    """
    margin = (
        None
        if speed is None
        else drive_margin(drive, positive_si(speed, "m/s", where="speed"), load)
    )
    if observed_ceiling is None and drive == BenchDrive() and load == BeltLoad():
        observed_ceiling = PUBLISHED_CEILING
    ceiling = (
        None
        if observed_ceiling is None
        else to_si(observed_ceiling, "m/s", where="observed_ceiling")
    )
    return DriveAssessment(margin, attainable_speed(drive, load, observed_ceiling=ceiling))


def _without_findings(result: Any) -> dict[str, Any] | None:
    """Return a part of a result as plain data without findings, which are listed once for the whole result."""
    return (
        None
        if result is None
        else {key: item for key, item in to_plain(result).items() if key != "findings"}
    )


def _together(*results: Any) -> tuple[Finding, ...]:
    """Merge the findings of several results without duplicates."""
    return tuple(
        dict.fromkeys(
            finding for result in results if result is not None for finding in result.findings
        )
    )
