"""What the belt asks of the motor and what the motor can give: margins, attainable speed and what limits it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray

from jounce.bench.drive import BenchDrive, belt_speed, inverter_frequency_for
from jounce.bench.estimated import estimated, estimates_used
from jounce.core.description import Description
from jounce.core.findings import Finding
from jounce.core.units import NonNegativeDampingCoefficient, NonNegativeForce, Unit

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
    """Compare the pull and power needed at a belt speed with what the motor can give.

    An inverter keeps voltage over frequency constant, so the rated *torque* is available at every speed up to the
    supply frequency and the power grows with the speed; a motor cooled by its own fan must stay below that at low
    speed.

    Parameters
    ----------
    drive : BenchDrive
        The bench.
    speed : float
        Belt speed [m/s], above 0.
    load : BeltLoad or None
        What resists the belt; None: all estimated.

    Returns
    -------
    DriveMargin
        Forces [N], powers [W], torques [N m] and margins [1].

    Raises
    ------
    FitError
        For a speed that is not positive.

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
        text = f"the belt asks for more than the rated torque at {speed:.3g} m/s: the motor will not hold the speed."
        findings.append(Finding("bench drive", "problem", text, margin))
    elif lasting < 0.0:
        text = f"at {speed:.3g} m/s the motor has the torque but not the cooling: it will overheat after a while."
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
    """Find the highest belt speed and what limits it.

    Parameters
    ----------
    drive : BenchDrive
        The bench.
    load : BeltLoad or None
        What resists the belt; None: all estimated.
    observed_ceiling : float or None
        Speed that was not exceeded in practice [m/s], e.g. 3.87 on the paper's bench: the result tells what pull would
        explain it.

    Returns
    -------
    AttainableSpeed
        Speeds in m/s.

    Raises
    ------
    FitError
        For an observed ceiling that is not positive.

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
        f"a ceiling of {ceiling:.3g} m/s means that the belt resists with {there.continuous_force:.0f} N (motor "
        f"overheats) to {there.available_force:.0f} N (rated torque reached); the load described here is "
        f"{there.required_force:.0f} N."
    )
    return there.continuous_force, text
