"""A measured damper record, checked: consistent signs, velocity that belongs to the displacement, rest cut off."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.errors import FitError, unknown
from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.identify.decay_peaks import zigzag

VelocityFrom = Literal["recorded", "displacement"]


@dataclass(frozen=True)
class DamperMotion:
    """Displacement, velocity and force of a damper while it moves.

    Attributes
    ----------
    time : array (n,)
        [s].
    displacement : array (n,)
        From the middle of the stroke, compression positive [m].
    velocity : array (n,)
        Rate of the displacement [m/s].
    force : array (n,)
        Positive where it resists compression [N].
    centre : float
        Middle of the stroke in the record [m].
    cycles : float
        Number of cycles [1].
    velocity_resolution : float
        Smallest difference between two recorded velocities [m/s]; 0 when it is not quantised.
    """

    time: Array
    displacement: Array
    velocity: Array
    force: Array
    centre: float
    cycles: float
    velocity_resolution: float

    @property
    def stroke(self) -> float:
        """Largest minus smallest displacement [m]."""
        return float(np.ptp(self.displacement))

    @property
    def peak_velocity(self) -> float:
        """Largest speed [m/s]."""
        return float(np.abs(self.velocity).max())


def read_motion(
    displacement: ArrayLike,
    velocity: ArrayLike | None,
    force: ArrayLike,
    time: ArrayLike,
    *,
    velocity_from: VelocityFrom = "recorded",
    name: str = "damper",
) -> tuple[DamperMotion, list[Finding]]:
    """Check a damper record and cut off the rest at both ends.

    Parameters
    ----------
    displacement, force, time : array (n,)
        [m], [N], [s]; compression positive. A force that feeds energy in is turned round, with a finding.
    velocity : array (n,) or None
        [m/s]; None: the derivative of the displacement is used.
    velocity_from : {"recorded", "displacement"}
        ``"displacement"``: use the central difference of the displacement though a velocity was recorded.
    name : str
        File or channel, used in messages.

    Returns
    -------
    DamperMotion
        The moving part.
    findings : list of Finding
        Doubts about the record.

    Raises
    ------
    FitError
        Unequal lengths, fewer than 50 samples, NaN, time that does not increase, no motion, less than one cycle.
    """
    if velocity_from not in ("recorded", "displacement"):
        raise unknown(str(velocity_from), ("recorded", "displacement"), what="velocity_from", where=name)
    columns = {"displacement": displacement, "velocity": velocity, "force": force, "time": time}
    arrays = {key: np.asarray(value, float) for key, value in columns.items() if value is not None}
    _check(arrays, name)
    findings: list[Finding] = []
    x, f, t = arrays["displacement"], arrays["force"], arrays["time"]
    derivative = np.asarray(np.gradient(x, t))
    resolution = 0.0
    if "velocity" in arrays:
        resolution = _check_velocity(arrays["velocity"], derivative, t, velocity_from, name, findings)
    else:
        findings.append(Finding(name, "note", "no velocity was given: the derivative of the displacement is used."))
    v = arrays["velocity"] if "velocity" in arrays and velocity_from == "recorded" else derivative
    first, last = _moving_part(x, name, findings)
    x, v, f, t = x[first:last], v[first:last], f[first:last], t[first:last]
    cycles = _cycles(x)
    if cycles < 0.95:
        raise FitError("less than one cycle of motion", where=name, found=f"{cycles:g} cycles", allowed="at least 1")
    if float(np.trapezoid(f * v, t)) < 0.0:
        f = -f
        text = "the force feeds energy into the motion: it was recorded with the other sign and was turned."
        findings.append(Finding(name, "warning", text))
    centre = 0.5 * float(x.max() + x.min())
    return DamperMotion(t, x - centre, v, f, centre, cycles, resolution), findings


def _check(arrays: dict[str, Array], name: str) -> None:
    lengths = {key: value.shape for key, value in arrays.items()}
    if len(set(lengths.values())) > 1 or any(value.ndim != 1 for value in arrays.values()):
        raise FitError("the columns are not of the same length", where=name, found=str(lengths))
    if len(arrays["time"]) < 50:
        raise FitError("too few samples", where=name, found=len(arrays["time"]), allowed="at least 50")
    for key, value in arrays.items():
        bad = np.flatnonzero(~np.isfinite(value))
        if len(bad):
            raise FitError("a value is missing or not finite", where=name, found=f"{key}, sample {bad[0] + 1}")
    if np.any(np.diff(arrays["time"]) <= 0.0):
        place = int(np.argmax(np.diff(arrays["time"]) <= 0.0)) + 2
        raise FitError("the time does not increase", where=name, found=f"sample {place}")
    if np.ptp(arrays["displacement"]) == 0.0 or np.ptp(arrays["force"]) == 0.0:
        raise FitError("displacement or force never changes", where=name, hint="Are these the right columns?")


def _check_velocity(
    velocity: Array, derivative: Array, time: Array, source: str, name: str, findings: list[Finding]
) -> float:
    """Compare the recorded velocity with the derivative of the displacement; give its resolution [m/s]."""
    power = float(derivative @ derivative)
    gain = float(velocity @ derivative) / power
    slope = np.gradient(derivative, time)
    delay = -float((velocity - derivative) @ slope) / float(slope @ slope)
    step = float(np.median(np.diff(time)))
    if abs(gain - 1.0) > 0.05:
        text = f"the recorded velocity is {gain:.3g} times the derivative of the displacement: check units and signs."
        findings.append(Finding(name, "problem", text, gain))
    elif abs(delay) > 0.2 * step and source == "recorded":
        text = (
            f"the recorded velocity is {1e3 * delay:.3g} ms ({delay / step:.2f} samples) behind the displacement, "
            "as a backward difference is; compare with velocity_from='displacement', a central difference."
        )
        findings.append(Finding(name, "warning", text, delay))
    values = np.unique(np.round(velocity, 9))
    gaps = np.diff(values)
    gaps = gaps[gaps > 1e-9 * max(float(np.abs(values).max()), 1e-12)]
    resolution = float(np.median(gaps)) if len(gaps) and len(values) < 0.5 * len(velocity) else 0.0
    if resolution > 1e-3 * float(np.abs(values).max()):
        text = (
            f"the velocity is recorded in steps of {1e3 * resolution:.3g} mm/s: what happens below a few of them is "
            "not resolved."
        )
        findings.append(Finding(name, "note", text, resolution))
    return resolution


def _moving_part(displacement: Array, name: str, findings: list[Finding]) -> tuple[int, int]:
    """First and last sample of the motion; short rests at the ends are kept."""
    still = 2e-3 * float(np.ptp(displacement))
    away = np.flatnonzero(np.abs(displacement - displacement[0]) > still)
    back = np.flatnonzero(np.abs(displacement - displacement[-1]) > still)
    first, last = max(int(away[0]) - 1, 0), min(int(back[-1]) + 2, len(displacement))
    first = first if first > 5 else 0
    last = last if len(displacement) - last > 5 else len(displacement)
    left_out = first + len(displacement) - last
    if left_out:
        text = f"{left_out} samples at rest at the ends were left out: a force at rest belongs to no velocity."
        findings.append(Finding(name, "note", text, float(left_out)))
    return first, last


def _cycles(displacement: Array) -> float:
    """Number of cycles: half the crossings of the middle, or the way over twice the stroke where that is more."""
    stroke = float(np.ptp(displacement))
    side = displacement - 0.5 * float(displacement.max() + displacement.min())
    clear = np.sign(side[np.abs(side) > 0.1 * stroke])
    turns = displacement[[*zigzag(displacement, 0.05 * stroke), len(displacement) - 1]]
    way = float(np.abs(np.diff(turns)).sum())
    return max(0.5 * float(np.count_nonzero(np.diff(clear))), way / (2.0 * stroke))
