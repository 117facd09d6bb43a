"""Detect defects in the record of a free decay: faults of the logger, and effects that the model lacks."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from jounce.core.findings import Finding, finding
from jounce.core.types import Array
from jounce.identify.estimate import linear_least_squares
from jounce.identify.free_response import DecayParameters, decay_slopes
from jounce.identify.low_pass import low_pass_corner, smoother_corner
from jounce.identify.motion import Quantity, order_of
from jounce.identify.signals import quantum_of
from jounce.recordings.quality import clipped_share, frozen_samples

EXACT = 1e-6  # as a share of the range: a smaller misfit needs no explanation
_COARSE = 0.05  # as a share of the range: larger steps are reported
_BENT, _CAUSE = (
    0.05,
    0.5,
)  # change of stiffness over the amplitudes of a decay; share of the residual that a cause explains
_SEAM, _SEAMS = (
    0.75,
    0.125,
)  # share of the residual that two decays explain; cycles between candidate instants
_ODD_STEP, _JUMP, _FEW_JUMPS = (
    10.0,
    0.02,
    3,
)  # times the usual step, of the range, jumps of a record
_FEW, _FEW_SEAMS = (
    4000,
    400,
)  # maximum samples and instants, to limit the run time for long records
_SLOW, _DRIFTS = (
    4.0,
    0.03,
)  # minimum cycles of a drift; minimum share of the range, as no damper shifts the centre
_RELEASING = 0.05  # share of a cycle after the release in which recorder filters may delay a jump
_NEAR = 8.0  # ratio to the natural frequency below which a low pass changes the effect of friction


def without_dropouts(t: Array, signal: Array, name: str) -> tuple[Array, Array, list[Finding]]:
    """Remove logger dropouts, and report coarse quantisation and clipped peaks."""
    lost, findings = frozen_samples(signal), []
    if lost.any():
        findings.append(
            finding(
                "identify.decay_dropouts",
                name,
                np.count_nonzero(lost),
                samples=np.count_nonzero(lost),
            )
        )
    if share := clipped_share(signal):
        findings.append(finding("identify.decay_out_of_range", name, share, share=share))
    step, reach = quantum_of(signal), float(np.ptp(signal))
    if step > _COARSE * reach:
        findings.append(finding("identify.decay_steps", name, step, step=step, share=step / reach))
    return t[~lost], signal[~lost], findings


def nonlinear_spring(
    times: Array, turns: Array, parameters: DecayParameters, noise: float, name: str
) -> list[Finding]:
    """Report a frequency that depends on the amplitude, which neither damping nor dry friction causes.

    ``turns`` are the displacements at successive turning points, at ``times`` (s).
    """
    swing = np.abs(np.diff(turns))
    # Their amplitude is at least ten times the noise and three times what friction shifts; smaller ones say little.
    clear = swing > max(20.0 * noise, 0.05 * swing[0], 6.0 * parameters.friction_deflection)
    count = int(np.argmin(clear)) if not clear.all() else len(clear)
    times, sizes = times[1 : count + 1], swing[1:count]
    if len(times) < 6:
        return []
    periods = times[2:] - times[:-2]
    squares = (0.5 * (sizes[:-1] + sizes[1:]) / swing[0]) ** 2
    rates = (2.0 * math.pi / periods) ** 2
    coefficients, _, spread = linear_least_squares(
        np.column_stack([squares, np.ones_like(squares)]), rates
    )
    share = float(coefficients[0]) * float(squares[0]) / float(coefficients[1])
    if (
        abs(share) < _BENT
        or not (bend := spread.estimates(coefficients)[0]).interval
        or bend.has(0.0)
    ):
        return []
    code = "identify.spring_stiffens" if share > 0.0 else "identify.spring_softens"
    return [finding(code, name, share, first=1.0 / periods[0], last=1.0 / periods[-1])]


def drift_of(
    t: Array, residual: Array, parameters: DecayParameters, reach: float
) -> np.polynomial.Polynomial | None:
    """Return a cubic in time if it explains most of the residual, and more than an asymmetric damper can."""
    used = np.isfinite(residual)
    left = float(residual[used] @ residual[used])
    if left == 0.0 or t[-1] - t[0] < _SLOW * 2.0 * math.pi / parameters.angular_frequency:
        return None
    slow = np.polynomial.Polynomial.fit(t[used], residual[used], 3)
    without, moved = residual[used] - slow(t[used]), slow(t[used])
    is_large = float(np.ptp(moved)) > _DRIFTS * reach
    return slow if is_large and float(without @ without) < (1.0 - _CAUSE) * left else None


def residual_causes(
    t: Array,
    signal: Array,
    residual: Array,
    parameters: DecayParameters,
    quantity: Quantity,
    name: str,
) -> list[Finding]:
    """Report the likely cause of residuals: a jump, two decays, a drift, or a damper firmer in one direction."""
    left = float(residual @ residual)
    begin = 0
    if order_of(quantity) == 2:  # the acceleration of a body jumps when it is released
        turn_time = 2.0 * math.pi / parameters.angular_frequency
        begin = int(np.searchsorted(t, parameters.release_time + _RELEASING * turn_time))
    if (later := _jump(residual[begin:], float(np.ptp(signal)))) is not None:
        jump = begin + later
        return [
            finding(
                "identify.decay_jumps_once",
                name,
                t[jump],
                jump=residual[jump] - residual[jump - 1],
                time=t[jump],
            )
        ]
    findings = []
    place = np.linspace(-0.5, 0.5, len(t))
    fall, turn = _swing(t, parameters)
    even = np.column_stack(
        [fall, fall * np.cos(2.0 * turn), fall * np.sin(2.0 * turn), np.ones_like(t)]
    )
    slope, remaining, _ = linear_least_squares(np.column_stack([place, np.ones_like(t)]), residual)
    drifts = 1.0 - float(remaining @ remaining) / left
    _, remaining, _ = linear_least_squares(even, residual)
    lopsided = 1.0 - float(remaining @ remaining) / left
    seam, at = _seam(t, residual, parameters, quantity)
    if seam > max(lopsided, drifts, _SEAM):
        findings.append(finding("identify.decay_second_hit", name, at, time=at, share=seam))
    elif drifts > max(lopsided, _CAUSE):
        findings.append(
            finding(
                "identify.decay_zero_drifts", name, slope[0], drift=float(slope[0]), share=drifts
            )
        )
    elif lopsided >= _CAUSE:
        findings.append(finding("identify.decay_lopsided", name, lopsided, share=lopsided))
    return findings


def low_pass_of(
    t: Array,
    signal: Array,
    residual: Array,
    parameters: DecayParameters,
    name: str,
    *,
    is_alike: bool,
) -> list[Finding]:
    """Detect a low-pass filter near the decay's frequency, from correlated noise or missing corners of the signal."""
    rate, frequency = (
        1.0 / float(np.median(np.diff(t))),
        parameters.angular_frequency / (2.0 * math.pi),
    )
    reach, step = float(np.ptp(signal)), quantum_of(signal)
    corner = smoother_corner(signal, signal - residual, rate, near=_NEAR * frequency)
    if corner is None and is_alike and _jump(residual, reach) is None:
        corner = low_pass_corner(residual, rate, frequency, reach=reach, step=step, near=_NEAR)
    if corner is None:
        return []
    return [finding("identify.decay_low_pass", name, corner, corner=corner, frequency=frequency)]


def _jump(residual: Array, reach: float) -> int | None:
    """Find the sample before which a record jumps, once or a few times; friction makes accelerations jump often."""
    steps = np.abs(np.diff(residual))
    usual = float(np.median(steps)) / 0.6745
    large = np.flatnonzero(steps > max(_ODD_STEP * usual, _JUMP * reach))
    return int(np.argmax(steps)) + 1 if 0 < len(large) <= _FEW_JUMPS else None


def _swing(t: Array, parameters: DecayParameters) -> tuple[Array, Array]:
    """Compute envelope (1) and phase (rad) of the decay without friction."""
    since = t - parameters.release_time
    fall = np.exp(-parameters.damping_ratio * parameters.angular_frequency * np.maximum(since, 0.0))
    return fall, parameters.angular_frequency * math.sqrt(1.0 - parameters.damping_ratio**2) * since


def _seam(
    t: Array, residual: Array, parameters: DecayParameters, quantity: Quantity
) -> tuple[float, float]:
    """Find the instant (s) of a possible second decay, and the share of the residual that it explains."""
    thin = max(1, len(t) // _FEW)
    t, residual = t[::thin], residual[::thin]
    fall, turn = _swing(t, parameters)
    slopes = decay_slopes(t, replace(parameters, quadratic_drag=0.0), quantity)
    known = np.linalg.qr(slopes / np.maximum(np.abs(slopes).max(axis=0), 1e-300))[0]
    cosine, sine = fall * np.cos(turn), fall * np.sin(turn)
    cycle = 2.0 * math.pi / parameters.angular_frequency
    best, at = 0.0, float(t[0])
    tried = np.arange(t[0] + cycle, t[-1] - cycle, _SEAMS * cycle)
    for instant in tried[:: max(1, len(tried) // _FEW_SEAMS)]:
        later = t > instant
        columns = np.column_stack([later * cosine, later * sine])
        columns = np.linalg.qr(columns - known @ (known.T @ columns))[0]
        explained = float(np.sum((columns.T @ residual) ** 2) / (residual @ residual))
        if explained > best:
            best, at = explained, float(instant)
    return best, at
