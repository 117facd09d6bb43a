"""Records of dampers: displacement, velocity and force checked, signed and cut to the motion."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from jounce.core.errors import FitError, unknown
from jounce.core.findings import Finding, finding
from jounce.core.samples import as_samples
from jounce.core.types import Array
from jounce.identify.signals import count_lost_samples, noise_of, quantum_of, zigzag
from jounce.identify.signs import ForcePositive, Signs, StrokePositive, damper_signs, sign_of
from jounce.recordings.carried import as_recording, clock_of, damper_channels
from jounce.recordings.quality import clipped_share, frozen_samples

VelocityFrom = Literal["recorded", "displacement"]


@dataclass(frozen=True)
class DamperMotion:
    """Displacement, velocity and force of a damper while it moves, compression positive.

    ``displacement`` (m) is measured from ``centre`` (m), the middle of the recorded stroke; ``force`` (N) is positive
    when it resists compression. ``velocity_resolution`` is the smallest difference between two recorded velocities
    (m/s), 0 if they are not quantised. ``signs`` are the sign conventions of the source record.
    """

    time: Array
    displacement: Array
    velocity: Array
    force: Array
    centre: float
    cycles: float
    velocity_resolution: float
    signs: Signs

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
    stroke_positive: StrokePositive | None = None,
    force_positive: ForcePositive | None = None,
    name: str = "damper",
) -> tuple[DamperMotion, list[Finding]]:
    """Check a damper record (m, m/s, N, s), make compression positive and trim standstill at both ends.

    Without a velocity, or with ``velocity_from="displacement"``, the derivative of the displacement is used: central
    differences, or slopes of cubics over as many samples as its noise requires, since noise in the velocity biases
    coefficients towards zero. A recorded velocity has the sign of the displacement. Sign conventions are stated or
    detected, with findings: :mod:`jounce.identify.signs`.

    Raises
    ------
    FitError
        Unequal lengths, fewer than 50 samples, NaN, time that does not increase, no motion, less than one cycle.
    """
    if velocity_from not in ("recorded", "displacement"):
        raise unknown(
            str(velocity_from), ("recorded", "displacement"), what="velocity_from", where=name
        )
    columns = {
        "displacement": (displacement, "m"),
        "velocity": (velocity, "m/s"),
        "force": (force, "N"),
        "time": (time, "s"),
    }
    arrays = {
        key: as_samples(value, si, where=f"{name}: {key}", error=FitError)
        for key, (value, si) in columns.items()
        if value is not None or key != "velocity"
    }
    _check(arrays, name)
    sign_of(stroke_positive, "stroke", where=name)
    sign_of(force_positive, "force", where=name)
    findings: list[Finding] = []
    x, f, t = arrays["displacement"], arrays["force"], arrays["time"]
    lost = _without_dropouts(arrays, name, findings)
    x = arrays["displacement"]
    derivative = np.asarray(np.gradient(x, t))
    resolution = 0.0
    uses_derivative = "velocity" not in arrays or velocity_from == "displacement"
    if "velocity" in arrays:
        arrays["velocity"] = _as_the_stroke(arrays["velocity"], derivative, name, findings)
        resolution = _check_velocity(
            arrays["velocity"], derivative, t, velocity_from, name, findings
        )
    else:
        findings.append(finding("identify.velocity_derived", name))
    v = _rate(x, t, derivative, name, findings) if uses_derivative else arrays["velocity"]
    findings += [*_out_of_range({"displacement": x, "force": f}, name)]
    if uses_derivative and (jumps := count_lost_samples(t, x)):
        findings.append(finding("identify.stroke_jumps", name, jumps, jumps=jumps))
    first, last = _moving_part(x, name, findings)
    sound = np.flatnonzero(~lost[first:last]) + first
    x, v, f, t, derivative = (column[sound] for column in (x, v, f, t, derivative))
    cycles = cycles_of(x)
    if cycles < 0.95:  # a slightly incomplete cycle still contains all velocities
        raise FitError(
            "less than one cycle of motion",
            where=name,
            found=f"{cycles:g} cycles",
            allowed="at least 1",
        )
    signs = damper_signs(
        x,
        derivative,
        f,
        stroke_positive=stroke_positive,
        force_positive=force_positive,
        name=name,
        findings=findings,
    )
    x, v, f = signs.stroke * x, signs.stroke * v, signs.force * f
    centre = 0.5 * float(x.max() + x.min())
    return DamperMotion(t, x - centre, v, f, centre, cycles, resolution, signs), findings


def _check(arrays: dict[str, Array], name: str) -> None:
    lengths = {key: value.shape for key, value in arrays.items()}
    if len(set(lengths.values())) > 1 or any(value.ndim != 1 for value in arrays.values()):
        raise FitError("the columns are not of the same length", where=name, found=str(lengths))
    if len(arrays["time"]) < 50:
        raise FitError(
            "too few samples", where=name, found=len(arrays["time"]), allowed="at least 50"
        )
    for key, value in arrays.items():
        bad = np.flatnonzero(~np.isfinite(value))
        if len(bad):
            raise FitError(
                "a value is missing or not finite", where=name, found=f"{key}, sample {bad[0] + 1}"
            )
    if np.any(np.diff(arrays["time"]) <= 0.0):
        place = int(np.argmax(np.diff(arrays["time"]) <= 0.0)) + 2
        raise FitError("the time does not increase", where=name, found=f"sample {place}")
    if np.ptp(arrays["displacement"]) == 0.0 or np.ptp(arrays["force"]) == 0.0:
        raise FitError(
            "displacement or force never changes", where=name, hint="Are these the right columns?"
        )


def _without_dropouts(
    arrays: dict[str, Array], name: str, findings: list[Finding]
) -> NDArray[np.bool_]:
    """Mark logger dropouts during motion, and interpolate the displacement across them for its derivative."""
    lost = np.zeros(len(arrays["time"]), bool)
    for column in ("displacement", "velocity", "force"):
        if column in arrays and (marks := frozen_samples(arrays[column])).any():
            findings.append(
                finding(
                    "identify.dropouts",
                    name,
                    np.count_nonzero(marks),
                    channel=column,
                    samples=np.count_nonzero(marks),
                )
            )
            lost |= marks
            if column == "displacement":
                time, bridged = arrays["time"], arrays[column].copy()
                bridged[marks] = np.interp(time[marks], time[~marks], bridged[~marks])
                arrays[column] = bridged
                lost |= np.convolve(marks, np.ones(2 * _BESIDE + 1), mode="same") > 0.0
    return lost


_BESIDE = 8  # samples next to a bridged gap whose derivative is invalid


def _out_of_range(columns: Mapping[str, Array], name: str) -> list[Finding]:
    """Report columns that are clipped: flat at their limits, entered by a jump."""
    findings = []
    for column, values in columns.items():
        share = clipped_share(values)
        if share > _CLIPPED:
            if column == "force":
                findings.append(
                    finding("identify.force_out_of_range", name, share, share=share, channel=column)
                )
            else:
                findings.append(
                    finding("identify.flat_at_limits", name, share, share=share, channel=column)
                )
    return findings


_CLIPPED = (
    2e-3  # share of the samples: a steady sine clipped for so long loses 0.002 % of its amplitude
)


def _as_the_stroke(velocity: Array, derivative: Array, name: str, findings: list[Finding]) -> Array:
    """Return the velocity with the sign of the displacement's derivative."""
    gain = float(velocity @ derivative) / float(derivative @ derivative)
    if gain > -0.5:  # halfway between a reversed velocity (-1) and an unrelated one (0)
        return velocity
    findings.append(finding("identify.velocity_reversed", name, gain, factor=gain))
    return -velocity


def _check_velocity(
    velocity: Array, derivative: Array, time: Array, source: str, name: str, findings: list[Finding]
) -> float:
    """Compare the recorded velocity with the derivative of the displacement; return its resolution [m/s]."""
    power = float(derivative @ derivative)
    gain = float(velocity @ derivative) / power
    slope = np.gradient(derivative, time)
    delay = -float((velocity - derivative) @ slope) / float(slope @ slope)
    step = float(np.median(np.diff(time)))
    if abs(gain - 1.0) > 0.05:  # the coefficient has the same relative error
        findings.append(finding("identify.velocity_gain", name, gain, factor=gain))
    elif (
        abs(delay) > 0.2 * step and source == "recorded"
    ):  # a chosen limit: channels on the same clock agree far better
        findings.append(
            finding("identify.velocity_late", name, delay, delay=delay, samples=delay / step)
        )
    resolution = quantum_of(np.round(velocity, 9))
    if resolution > 1e-3 * float(
        np.abs(velocity).max()
    ):  # slow motion, a tenth of the peak, is then known to 1 %
        findings.append(finding("identify.velocity_steps", name, resolution, step=resolution))
    return resolution


def _rate(x: Array, t: Array, plain: Array, name: str, findings: list[Finding]) -> Array:
    """Differentiate a displacement (m/s) over as many samples as its noise requires; ``plain`` uses three."""
    steps = np.diff(t)
    step = float(np.median(steps))
    turns = np.diff(zigzag(_smooth(x), 0.05 * float(np.ptp(x))))[1:]
    widest = int(_WIDEST * turns.min()) if len(turns) else 0
    noise = max(noise_of(x), quantum_of(x) / math.sqrt(12.0))
    if float(np.ptp(steps)) > 0.01 * step:  # uneven steps, so no cubic can be fitted
        widest = 0
    power = float(np.mean((_slope(x, widest) / step) ** 2 if widest > 1 else plain**2))

    def share(half: int) -> float:
        weights = _weights_of_slope(half) if half > 1 else np.array([0.5, 0.5])
        white = noise**2 * float(weights @ weights)
        return max(white, (0.5 * quantum_of(x) / (2 * half + 1)) ** 2) / (step**2 * power)

    half = 1
    while share(half) > _CALM and half < widest:
        half = min(max(half + 1, int(1.2 * half)), widest)
    left = share(half)
    if half > 1:
        findings.append(
            finding("identify.derivative_width", name, 2 * half + 1, samples=2 * half + 1)
        )
    if left > _NOISY:
        findings.append(finding("identify.stroke_noise", name, left, noise=noise, share=left))
    return plain if half == 1 else _slope(x, half) / step


_CALM, _NOISY = (
    1e-4,
    1e-2,
)  # noise as a share of the velocity's mean square: harmless, and reported
_WIDEST = (
    0.05  # as a share of half a cycle: largest half width over which a cubic follows the motion
)


def _smooth(x: Array) -> Array:
    """Average over about a hundredth of a cycle, before the search for turning points."""
    width = max(1, len(x) // 2000) | 1
    return np.convolve(np.pad(x, width // 2, mode="edge"), np.ones(width) / width, mode="valid")


def _weights_of_slope(half: int) -> Array:
    """Return the filter weights of the centre slope (per sample) of a cubic fitted to ``2 half + 1`` samples."""
    place = np.arange(-half, half + 1) / half
    weights: Array = np.linalg.pinv(place[:, None] ** np.arange(4.0))[1] / half
    return weights


def _slope(x: Array, half: int) -> Array:
    """Return slopes (per sample) of cubics over ``2 half + 1`` samples; the ends use the first and the last cubic."""
    place = np.arange(-half, half + 1) / half
    inside = np.convolve(x, _weights_of_slope(half)[::-1], mode="valid")
    ends = [
        np.polyval(np.polyder(np.polyfit(place, part, 3)), place) / half
        for part in (x[: 2 * half + 1], x[-2 * half - 1 :])
    ]
    return np.concatenate([ends[0][:half], inside, ends[1][half + 1 :]])


def _moving_part(displacement: Array, name: str, findings: list[Finding]) -> tuple[int, int]:
    """Return the first and last sample of the motion; short standstills at the ends are kept."""
    still = 2e-3 * float(np.ptp(displacement))
    away = np.flatnonzero(np.abs(displacement - displacement[0]) > still)
    back = np.flatnonzero(np.abs(displacement - displacement[-1]) > still)
    first, last = max(int(away[0]) - 1, 0), min(int(back[-1]) + 2, len(displacement))
    first = first if first > 5 else 0
    last = last if len(displacement) - last > 5 else len(displacement)
    left_out = first + len(displacement) - last
    if left_out:
        findings.append(finding("identify.rest_left_out", name, left_out, samples=left_out))
    return first, last


def cycles_of(displacement: Array, *, is_closed: bool = False) -> float:
    """Return the number of cycles: half the crossings of the middle, or the path over twice the stroke if that is more.

    With ``is_closed`` the record begins and ends at a crossing, which adds one.
    """
    stroke = float(np.ptp(displacement))
    side = displacement - 0.5 * float(displacement.max() + displacement.min())
    clear = np.sign(
        side[np.abs(side) > 0.1 * stroke]
    )  # noise in the middle of the stroke makes no crossings
    turns = displacement[[*zigzag(displacement, 0.05 * stroke), len(displacement) - 1]]
    path = float(np.abs(np.diff(turns)).sum())
    return max(0.5 * float(np.count_nonzero(np.diff(clear)) + is_closed), path / (2.0 * stroke))


def columns_of(
    displacement: Any, velocity: Any, force: Any, time: Any, name: str
) -> tuple[ArrayLike, ArrayLike | None, ArrayLike, ArrayLike]:
    """Complete the columns of a record: a channel provides its time, a recording or a table all columns."""
    if force is None and velocity is None and not hasattr(displacement, "dtype"):
        displacement, velocity, force = damper_channels(
            as_recording(displacement, where=name), where=name
        )
    if force is None:
        raise FitError(
            "the force is missing",
            where=name,
            allowed="displacement, velocity or None, force, time",
        )
    return (
        displacement,
        velocity,
        force,
        clock_of((displacement, force), where=name) if time is None else time,
    )
