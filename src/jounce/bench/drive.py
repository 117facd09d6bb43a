"""The bench's drive: from the inverter to the belt, and what the photo-sensor says about its speed."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, Literal

from pydantic import Field

from jounce.bench.estimated import estimated, estimates_used
from jounce.core.description import Description
from jounce.core.errors import FitError
from jounce.core.findings import Finding
from jounce.core.units import Frequency, NonNegativeLength, PositiveLength, Unit
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
    pole_pairs: Annotated[int, Field(ge=1, le=8)] = 1
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
    """Compute the belt speed at an inverter frequency.

    Parameters
    ----------
    drive : BenchDrive
        The bench.
    inverter_frequency : float
        [Hz], above 0.

    Returns
    -------
    BeltSpeed
        Speeds in rad/s and m/s.

    Raises
    ------
    FitError
        For a frequency that is not positive.

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
    """Estimate the belt speed from counted pulses.

    Both ends of the counting window fall anywhere between two pulses, so the count is uncertain by 1/sqrt(6) pulses
    (standard deviation); the radius adds its own relative error.

    Parameters
    ----------
    drive : BenchDrive
        Radius and belt length.
    pulses : int
        Pulses counted [1], at least 1.
    duration : float
        Length of the counting window [s].
    pulses_per_revolution : int
        Marks on the cylinder [1].
    radius_error : float
        Standard error of the radius at which the belt runs [m].

    Returns
    -------
    SensorSpeed
        Speed with its 95 % interval.

    Raises
    ------
    FitError
        For counts, durations or errors that are not positive.

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
