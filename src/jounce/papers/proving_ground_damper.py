"""A damper of laboratory size as the damper of a vehicle: fit, similitude, reference to the wheel."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np

from jounce.core.errors import FitError
from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.identify.damper import DamperCurve, DamperResult, LawName, damper_curve, fit_damper
from jounce.recordings import read_columns

RECORDS = {"0 V": "shaking_table_0v.csv", "0.88 V": "shaking_table_088v.csv"}
LAWS: tuple[LawName, ...] = ("linear", "tanh-hysteretic", "bouc-wen")
_COLUMNS = {"time": "s", "displacement": "m", "velocity": "m/s", "force": "N"}
_CYCLE = 2000  # samples of a harmonic cycle


@dataclass(frozen=True)
class MeasuredDamper:
    """One record of the damper with the laws fitted to it.

    Attributes
    ----------
    name : str
        Voltage on the damper.
    laws : dict of str to DamperResult
        Fits of several laws by name.
    curves : dict of str to DamperCurve
        Measured and fitted force of each.
    """

    name: str
    laws: dict[str, DamperResult]
    curves: dict[str, DamperCurve]

    @property
    def stroke(self) -> float:
        """Largest minus smallest displacement of the record [m]."""
        return float(np.ptp(self.curves[LAWS[0]].displacement))

    @property
    def peak_velocity(self) -> float:
        """Largest speed of the record [m/s]."""
        return float(np.abs(self.curves[LAWS[0]].velocity).max())


@dataclass(frozen=True)
class Similitude:
    """How a small damper becomes a large one on a vehicle.

    With r = motion_ratio / stroke_scale, the force at the wheel is
    ``motion_ratio * force_scale * law(r * wheel displacement, r * wheel velocity)``: time is not scaled.

    Attributes
    ----------
    stroke_scale : float
        Displacement (and velocity) of the large damper over that of the small one [1].
    force_scale : float
        Force of the large damper over that of the small one [1].
    motion_ratio : float
        Damper travel over wheel travel [1].
    """

    stroke_scale: float
    force_scale: float
    motion_ratio: float

    @property
    def speed_ratio(self) -> float:
        """Velocity of the small damper for one m/s of the wheel [1]."""
        return self.motion_ratio / self.stroke_scale


def measured_dampers() -> tuple[tuple[MeasuredDamper, ...], tuple[Finding, ...]]:
    """Read the shipped records and fit the laws; velocities are central differences of the displacement.

    Returns
    -------
    tuple of MeasuredDamper
        One per voltage.
    tuple of Finding
        Doubts about records and laws.
    """
    folder = Path(str(resources.files("jounce"))) / "library" / "measurements" / "mr_damper"
    found, findings = [], list[Finding]()
    for name, file in RECORDS.items():
        columns, reading = read_columns(folder / file, _COLUMNS)
        findings += reading
        record = columns["displacement"], columns["velocity"], columns["force"], columns["time"]
        place = f"damper at {name}"
        laws: dict[str, DamperResult] = {
            law: fit_damper(*record, law=law, velocity_from="displacement", name=place) for law in LAWS
        }
        findings += [finding for finding in laws["tanh-hysteretic"].findings if finding not in findings]
        curves: dict[str, DamperCurve] = {
            law: damper_curve(fit, *record, velocity_from="displacement") for law, fit in laws.items()
        }
        found.append(MeasuredDamper(name, laws, curves))
    return tuple(found), tuple(findings)


def referred_to_wheel(table: Mapping[str, Any], similitude: Similitude) -> dict[str, Any]:
    """Damper table of a rig whose strut stands at the wheel, from the table of the measured damper.

    What multiplies velocity or displacement changes with motion_ratio * force_scale * r, forces with
    motion_ratio * force_scale, and what stands beside them inside the law (the tanh's ``slope`` in s/m, Bouc-Wen's
    ``rate`` in 1/m) with r = motion_ratio / stroke_scale; ``displacement_coupling`` (1/s), ``sigma`` and ``exponent``
    stay. The static ``offset`` is left out: the spring's preload carries the vehicle.

    Parameters
    ----------
    table : mapping
        ``strut.damper`` of kind linear, tanh or bouc-wen, SI.
    similitude : Similitude
        Scales and motion ratio.

    Returns
    -------
    dict
        The table at the wheel, SI.

    Raises
    ------
    FitError
        For another kind of law.

    Examples
    --------
    >>> referred_to_wheel({"coefficient": 1000.0}, Similitude(stroke_scale=2.0, force_scale=10.0, motion_ratio=0.5))
    {'coefficient': 1250.0}
    """
    force, speed = similitude.motion_ratio * similitude.force_scale, similitude.speed_ratio
    factors = {
        "coefficient": force * speed,
        "stiffness": force * speed,
        "force": force,
        "hysteretic_force": force,
        "slope": speed,
        "rate": speed,
        "displacement_coupling": 1.0,
        "sigma": 1.0,
        "exponent": 1.0,
        "offset": 0.0,
    }
    strange = [key for key in table if key != "kind" and key not in factors]
    if strange:
        raise FitError("this law cannot be scaled", found=", ".join(strange), allowed="linear, tanh, bouc-wen")
    return {key: value if key == "kind" else value * factors[key] for key, value in table.items()}


def harmonic_energy(table: Mapping[str, Any], amplitude: float, frequency: float) -> float:
    """Work that a damper takes up per cycle of steady harmonic motion.

    Parameters
    ----------
    table : mapping
        ``strut.damper`` of kind linear, tanh or bouc-wen, SI.
    amplitude : float
        [m].
    frequency : float
        [Hz].

    Returns
    -------
    float
        [J].

    Examples
    --------
    >>> round(harmonic_energy({"coefficient": 1000.0}, 0.02, 1.0), 4), round(1000.0 * np.pi * 2 * np.pi * 0.02**2, 4)
    (7.8957, 7.8957)
    """
    phase = np.linspace(0.0, 4.0 * np.pi, 2 * _CYCLE + 1)  # the first cycle brings a law with a memory into its state
    x, v = amplitude * np.sin(phase), 2.0 * np.pi * frequency * amplitude * np.cos(phase)
    force = _force(table, x, v)
    power = (force * v)[_CYCLE:]
    return float(np.trapezoid(power, phase[_CYCLE:])) / (2.0 * np.pi * frequency)


def equivalent_coefficient(table: Mapping[str, Any], amplitude: float, frequency: float) -> float:
    """Linear damping coefficient (N s/m) that takes up as much per cycle; ``amplitude`` in m, ``frequency`` in Hz."""
    return harmonic_energy(table, amplitude, frequency) / (2.0 * np.pi**2 * frequency * amplitude**2)


def _force(table: Mapping[str, Any], x: Array, v: Array) -> Array:
    from jounce.identify.hysteresis_path import bouc_wen_path

    linear = table["coefficient"] * v + table.get("stiffness", 0.0) * x
    if table.get("kind") == "tanh":
        lagged = v + table["displacement_coupling"] * x
        return np.asarray(linear + table["force"] * np.tanh(table["slope"] * lagged))
    if table.get("kind") == "bouc-wen":
        state = bouc_wen_path(x, table["rate"], table["sigma"], table["exponent"], 0.0)
        return np.asarray(linear + table["hysteretic_force"] * state)
    return np.asarray(linear)
