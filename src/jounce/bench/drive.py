"""The bench's drive: from inverter to belt, what the photo-sensor counts, and what the belt asks of the motor."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from jounce.bench.estimated import estimated, estimates_used
from jounce.core.description import Description, Whole
from jounce.core.errors import FitError
from jounce.core.findings import Finding
from jounce.core.units import (
    Frequency,
    NonNegativeDampingCoefficient,
    NonNegativeForce,
    NonNegativeLength,
    PositiveLength,
    Unit,
)
from jounce.identify.estimate import Estimate, estimate

AngularSpeed = Annotated[float, Unit("rad/s", above=0.0)]
Power = Annotated[float, Unit("W", above=0.0)]
Share = Annotated[float, Unit("1", at_least=0.0, at_most=0.9)]
Efficiency = Annotated[float, Unit("1", above=0.0, at_most=1.0)]
_SPEED_FIELDS = ("cylinder_radius", "belt_thickness", "pulley_slip", "flat_belt_slip")


class BenchDrive(Description):
    """Motor, pulleys, cylinder and flat belt of the bench.

    The published values are the defaults. Never published and therefore *estimated*: ``cylinder_radius`` 50 mm,
    ``belt_thickness`` 3 mm, ``pulley_slip`` 2 % (slip of the belt between motor and cylinder), ``flat_belt_slip`` 0,
    ``efficiency`` 0.95, ``standstill_torque`` 0.5 (share of the rated torque a self-ventilated motor keeps without
    overheating at standstill, growing linearly to 1 at the supply frequency).

    ``belt_reference`` names the radius at which belt speed and pull act: ``pitch`` R + t/2 (the belt does not stretch),
    ``outer`` R + t, ``bare`` R.
    """

    motor_power: Power = 1500.0
    supply_frequency: Frequency = 60.0
    rated_motor_speed: AngularSpeed = 356.05
    pole_pairs: Annotated[Whole, Field(ge=1, le=8)] = 1
    motor_pulley_diameter: PositiveLength = 0.060
    cylinder_pulley_diameter: PositiveLength = 0.120
    belt_length: PositiveLength = 1.97
    belt_reference: Literal["pitch", "outer", "bare"] = "pitch"
    cylinder_radius: PositiveLength = estimated(0.050, "typical for a bench belt of 1.97 m")
    belt_thickness: NonNegativeLength = estimated(0.003, "typical flat belt")
    pulley_slip: Share = estimated(0.02, "typical V-belt under load")
    flat_belt_slip: Share = estimated(0.0, "not observable with a sensor on the cylinder")
    efficiency: Efficiency = estimated(0.95, "typical V-belt")
    standstill_torque: Efficiency = estimated(0.5, "typical self-ventilated motor on an inverter")

    @property
    def ratio(self) -> float:
        """Motor speed over cylinder speed without slip [1]."""
        return self.cylinder_pulley_diameter / self.motor_pulley_diameter

    @property
    def radius(self) -> float:
        """Radius at which the belt runs [m], see ``belt_reference``."""
        share = {"pitch": 0.5, "outer": 1.0, "bare": 0.0}[self.belt_reference]
        return self.cylinder_radius + self.belt_thickness * share

    @property
    def motor_slip(self) -> float:
        """Slip of the motor at its rating [1]."""
        return 1.0 - self.rated_motor_speed * self.pole_pairs / (2.0 * math.pi * self.supply_frequency)

    @property
    def rated_torque(self) -> float:
        """Torque of the motor at its rating [N m]."""
        return self.motor_power / self.rated_motor_speed


@dataclass(frozen=True)
class BeltSpeed:
    """Speeds along the drive at one inverter frequency.

    Attributes
    ----------
    inverter_frequency : float
        [Hz].
    motor_speed, cylinder_speed : float
        Angular speeds with the slips of motor and pulleys [rad/s].
    ideal_speed : float
        Belt speed without slip between motor and belt, the motor at its rated slip [m/s].
    sensor_speed : float
        What a photo-sensor on the cylinder reports [m/s].
    speed : float
        Belt speed [m/s].
    recurrence_time : float
        Time after which an obstacle fixed to the belt comes again [s].
    findings : tuple of Finding
        Estimated values used, and what the sensor cannot see.
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
    """Give the inverter frequency [Hz] at which the belt runs at ``speed`` [m/s].

    Examples
    --------
    >>> bench = BenchDrive(belt_reference="bare", pulley_slip=0.0)
    >>> round(inverter_frequency_for(bench, 3.87), 2)
    26.09
    """
    _check_positive(speed, "belt speed", "m/s")
    return speed / belt_speed(drive, 1.0).speed


def _unseen_slip(drive: BenchDrive) -> Finding:
    text = (
        "a photo-sensor on the cylinder sees the losses between motor and cylinder, but not the slip between flat belt "
        f"and cylinder (here taken as {100.0 * drive.flat_belt_slip:.3g} %); check it once with a mark on the belt."
    )
    return Finding("bench drive", "note", text, drive.flat_belt_slip)


def _check_positive(value: float, what: str, unit: str) -> None:
    if not (math.isfinite(value) and value > 0.0):
        raise FitError(f"the {what} is not positive", found=f"{value} {unit}", allowed=f"above 0 {unit}")


@dataclass(frozen=True)
class SensorSpeed:
    """Belt speed counted by the photo-sensor on the cylinder.

    Attributes
    ----------
    speed : Estimate
        [m/s].
    cylinder_speed : Estimate
        [rad/s].
    resolution : float
        Change of the speed by one pulse [m/s].
    recurrence_time : float
        Belt length over speed [s].
    findings : tuple of Finding
        Estimated values used, coarse counting, and what the sensor cannot see.
    """

    speed: Estimate
    cylinder_speed: Estimate
    resolution: float
    recurrence_time: float
    findings: tuple[Finding, ...]


def photo_sensor_speed(
    drive: BenchDrive, pulses: int, duration: float, *, pulses_per_revolution: int = 1, radius_error: float = 0.0
) -> SensorSpeed:
    """Estimate the belt speed, with its 95 % interval, from the pulses counted in a window of ``duration`` (s).

    Both ends of the counting window fall anywhere between two pulses, so the count is uncertain by 1/sqrt(6) pulses
    (standard deviation); ``radius_error`` (m), the standard error of the radius at which the belt runs, adds its own
    relative error.

    Examples
    --------
    >>> found = photo_sensor_speed(BenchDrive(), 62, 10.0)
    >>> round(found.speed.value, 3), round(found.speed.standard_error, 3)
    (2.006, 0.013)
    """
    _check_positive(pulses, "number of pulses", "")
    _check_positive(pulses_per_revolution, "number of pulses per revolution", "")
    _check_positive(duration, "duration", "s")
    if radius_error < 0.0:
        raise FitError("the error of the radius is negative", found=f"{radius_error} m", allowed="0 m or more")
    one = 2.0 * math.pi / (pulses_per_revolution * duration)
    angular = estimate(pulses * one, one / math.sqrt(6.0))
    speed = angular.value * drive.radius
    error = math.hypot(one / math.sqrt(6.0) * drive.radius, angular.value * radius_error)
    findings = [*estimates_used(drive, "photo-sensor", _SPEED_FIELDS[:2]), _unseen_slip(drive)]
    if pulses < 40:
        text = f"one pulse is {100.0 / pulses:.2g} % of the speed: count longer, or put more marks on the cylinder."
        findings.append(Finding("photo-sensor", "warning", text, 1.0 / pulses))
    return SensorSpeed(estimate(speed, error), angular, one * drive.radius, drive.belt_length / speed, tuple(findings))


Inertia = Annotated[float, Unit("kg*m^2", at_least=0.0)]
Limit = Literal["supply frequency", "torque", "cooling"]


class BeltLoad(Description):
    """What resists the belt.

    Required pull = rolling_resistance * wheel_load + bed_friction * bed_load + bending_force + drag * speed
    + inertia * acceleration / radius^2. Nothing of it is published: every value is *estimated* (``wheel_load`` is
    the weight of 16 kg sprung and an estimated 5 kg unsprung mass; ``bed_load`` presses the belt on its metal support
    and equals the wheel load when not given).
    """

    wheel_load: NonNegativeForce = estimated(206.0, "16 kg sprung and 5 kg unsprung mass")
    rolling_resistance: Annotated[float, Unit("1", at_least=0.0)] = estimated(0.02, "small pneumatic tyre")
    bed_friction: Annotated[float, Unit("1", at_least=0.0)] = estimated(0.3, "belt back on sheet metal")
    bed_load: NonNegativeForce | None = None
    bending_force: NonNegativeForce = estimated(10.0, "bending a thin flat belt round two cylinders")
    drag: NonNegativeDampingCoefficient = estimated(0.0, "bearing losses neglected")
    inertia: Inertia = estimated(0.0, "constant speed")
    acceleration: Annotated[float, Unit("m/s^2")] = 0.0

    def force(self, speed: float, radius: float) -> float:
        """Pull needed at the belt [N] at ``speed`` [m/s] round cylinders of ``radius`` [m]."""
        bed = self.wheel_load if self.bed_load is None else self.bed_load
        resting = self.rolling_resistance * self.wheel_load + self.bed_friction * bed + self.bending_force
        return resting + self.drag * speed + self.inertia * self.acceleration / radius**2


@dataclass(frozen=True)
class DriveMargin:
    """What the belt asks of the motor at one speed, and what the motor has.

    Attributes
    ----------
    speed, inverter_frequency : float
        [m/s], [Hz].
    required_force, available_force, continuous_force : float
        Pull at the belt: needed, at rated torque, and at the torque the motor keeps without overheating [N].
    required_power, available_power : float
        At the belt [W].
    required_torque, rated_torque : float
        At the motor [N m].
    margin, continuous_margin : float
        (available - required) / available pull [1]; negative: the drive is overloaded.
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
    """Compare the pull and power needed at a belt speed (m/s, above 0) with what the motor can give.

    An inverter keeps voltage over frequency constant, so the rated *torque* is available at every speed up to the
    supply frequency and the power grows with the speed; a motor cooled by its own fan must stay below that at low
    speed. Without a ``load`` all that resists the belt is estimated.

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
    available = pull if frequency <= drive.supply_frequency else pull * drive.supply_frequency / frequency
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
    """Share of the torque that a motor cooled by its own fan keeps at an inverter frequency."""
    share = min(frequency / drive.supply_frequency, 1.0)
    return drive.standstill_torque + (1.0 - drive.standstill_torque) * share


def _overload(margin: float, lasting: float, speed: float, frequency: float, drive: BenchDrive) -> list[Finding]:
    findings = []
    if frequency > drive.supply_frequency:
        text = (
            f"{speed:.3g} m/s needs {frequency:.3g} Hz, above the supply frequency of {drive.supply_frequency:g} Hz: "
            "the torque falls there and the bench may not be made for it."
        )
        findings.append(Finding("bench drive", "warning", text, frequency))
    if margin < 0.0:
        text = f"the belt needs more than the rated torque at {speed:.3g} m/s: the motor will not hold the speed."
        findings.append(Finding("bench drive", "problem", text, margin))
    elif lasting < 0.0:
        text = f"at {speed:.3g} m/s the torque suffices but not the cooling: the motor will overheat after a while."
        findings.append(Finding("bench drive", "warning", text, lasting))
    return findings


@dataclass(frozen=True)
class AttainableSpeed:
    """How fast the belt can run.

    Attributes
    ----------
    speed : float
        Highest belt speed the motor can hold for as long as one likes [m/s]; 0 when there is none.
    limited_by : {"supply frequency", "torque", "cooling"}
        What stops it there.
    short_time_speed : float
        Highest belt speed within the rated torque, heating disregarded [m/s].
    lowest_continuous_speed : float
        Below this speed the motor's own fan does not cool it enough [m/s]; 0 when it always does.
    implied_force : float or None
        Pull that would explain an observed ceiling [N].
    findings : tuple of Finding
        What an observed ceiling means, estimated values used.
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
    """Find the highest belt speed and what limits it; without a ``load`` all that resists the belt is estimated.

    With ``observed_ceiling``, a speed (m/s) that was not exceeded in practice, e.g. 3.87 on the paper's bench, the
    result tells what pull would explain it.

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
        implied, text = _implied(drive, load, observed_ceiling)
        findings.append(Finding("bench drive", "note", text, implied))
    return AttainableSpeed(
        speed=float(speeds[lasting][-1]) if lasting.any() else 0.0,
        limited_by=limited,
        short_time_speed=float(speeds[short][-1]) if short.any() else 0.0,
        lowest_continuous_speed=float(speeds[lasting][0]) if lasting.any() and not lasting[0] else 0.0,
        implied_force=implied,
        findings=tuple(findings),
    )


def _limit(short: NDArray[np.bool_], lasting: NDArray[np.bool_]) -> Limit:
    """Name what fails just above the highest speed that can be held."""
    if lasting[-1]:
        return "supply frequency"
    above = int(np.flatnonzero(lasting)[-1]) + 1 if lasting.any() else 0
    return "cooling" if short[above] else "torque"


def _implied(drive: BenchDrive, load: BeltLoad, ceiling: float) -> tuple[float, str]:
    there = drive_margin(drive, ceiling, load)
    text = (
        f"a ceiling of {ceiling:.3g} m/s implies a belt resistance of {there.continuous_force:.0f} N (motor "
        f"overheats) to {there.available_force:.0f} N (rated torque reached); the load described here is "
        f"{there.required_force:.0f} N."
    )
    return there.continuous_force, text
