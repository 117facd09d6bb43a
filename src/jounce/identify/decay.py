"""Damping from free decays: logarithmic decrement, and viscous damping separated from dry friction and drag."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Annotated, Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from jounce.core.errors import FitError, unknown
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.results import Shows
from jounce.core.samples import as_samples
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.core.units import as_number, to_si
from jounce.identify.decay_doubts import (
    EXACT,
    drift_of,
    low_pass_of,
    nonlinear_spring,
    residual_causes,
    without_dropouts,
)
from jounce.identify.estimate import (
    Estimate,
    Uncertainty,
    at_least_zero,
    central_differences,
    combine,
    correlation_time,
    linear_least_squares,
    r_squared,
    uncertainty,
)
from jounce.identify.free_response import DecayParameters, alternating, decay_response, decay_slopes
from jounce.identify.motion import (
    MOTIONS,
    QUANTITIES,
    MeasuredMotion,
    MotionName,
    Quantity,
    in_motion,
    motion_of,
    order_of,
    unit_in_words,
)
from jounce.identify.signals import count_lost_samples, noise_of, quantum_of, zigzag
from jounce.recordings.carried import carried_channel, clock_of

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr


Drag = Literal["auto", "yes", "no"]
DRAG_CHOICES: tuple[Drag, ...] = ("auto", "yes", "no")

# turning points -------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Peaks:
    """Successive turning points: times (s) and signal values, alternating between maxima and minima.

    The first one is the release, which has the largest excursion.
    """

    time: Array
    value: Array

    def half_period(self) -> float:
        """Time from one turning point to the next [s], not counting the release."""
        gaps = np.diff(self.time)[1:]
        return float(np.average(gaps, weights=np.abs(np.diff(self.value))[1:]))


_SUDDEN = (
    2.0  # ratio to the larger of the two previous swings: a hit, as a free decay only decreases
)
_GROWS = 1.02  # ratio to the previous swing: a beat continues to grow after a node
_FEWEST = 20  # samples: nearly three for each of the seven parameters of a response


def find_release(signal: Array, noise: float) -> int:
    """Find the sample at which the decay starts: the end of a hold, or just past the first peak.

    It is the last sample within 2 % of the largest excursion from the final value (more where the noise is larger)
    before the signal falls below 70 % of it.
    """
    tail = float(np.median(signal[-max(5, len(signal) // 10) :]))
    away = np.abs(_smooth(signal, noise) - tail)
    top = int(np.argmax(away))
    fallen = np.flatnonzero(away[top:] < 0.7 * away[top])  # an eighth of a cycle after the release
    end = top + (int(fallen[0]) if len(fallen) else len(signal) - top)
    limit = float(away[top]) - max(0.02 * float(away[top]), 3.0 * noise)
    return int(top + np.flatnonzero(away[top:end] >= limit)[-1])


def _smooth(signal: Array, noise: float) -> Array:
    """Smooth over a few samples if the noise exceeds 1 % of the range."""
    share = noise / max(float(np.ptp(signal)), 1e-300)
    width = int(np.clip(1 + 2 * round(100.0 * share), 1, max(1, len(signal) // 50)))
    return _moving_average(signal, width)


def _moving_average(signal: Array, width: int) -> Array:
    """Moving average over an odd number of samples."""
    if width < 3:
        return signal
    padded = np.pad(signal, width // 2, mode="edge")
    return np.convolve(padded, np.ones(width) / width, mode="same")[
        width // 2 : width // 2 + len(signal)
    ]


def find_peaks(time: Array, signal: Array, noise: float) -> Peaks:
    """Find the maxima and minima of a decay from its release on, refined between samples by a parabola.

    Reversals within the noise are ignored. A signal without a turning point after the release raises an error.
    """
    reach = float(np.ptp(signal))
    coarse = zigzag(_smooth(signal, noise), max(12.0 * noise, 0.03 * reach))
    half = _half_period(time, coarse)
    width = max(1, round(half / 12.0 / float(np.median(np.diff(time)))))
    smooth = _moving_average(signal, width | 1)
    turns = zigzag(smooth, max(8.0 * noise / math.sqrt(width), 2e-4 * reach))
    turns = [0, *(turn for turn in turns[1:] if turn >= coarse[1] - width)]
    refined = [(float(time[turns[0]]), float(smooth[turns[0]]))]
    refined += [_parabola(time, signal, smooth, index, half) for index in turns[1:]]
    if len(refined) == 2:  # the mass rests after its first swing back
        refined.append(
            (refined[1][0] + half, float(np.median(signal[-max(5, len(signal) // 4) :])))
        )
    moments, values = np.array(refined).T
    return Peaks(moments, values)


def until_it_grows(peaks: Peaks, noise: float) -> Peaks:
    """Cut off the part after a second hit, where swings are suddenly much larger than the two before.

    The swings of a beat also grow at a node of its envelope, but they continue to grow and are kept.

    >>> until_it_grows(Peaks(np.arange(8.0), np.array([9.0, -8, 7, -6, 5, -4, 20, -18.0])), 0.0).value.tolist()
    [9.0, -8.0, 7.0, -6.0, 5.0, -4.0]
    """
    swing = np.abs(np.diff(peaks.value))
    for i in range(2, len(swing)):
        # Swings that are small, or little above the noise, may double by chance.
        is_sudden = (
            swing[i] > _SUDDEN * max(swing[i - 2 : i]) and swing[i] > 0.1 * swing[0] + 10.0 * noise
        )
        if is_sudden and not (
            len(swing) > i + 2 and swing[i + 2] > _GROWS * swing[i + 1] > _GROWS**2 * swing[i]
        ):
            return Peaks(peaks.time[: i + 1], peaks.value[: i + 1])
    return peaks


def _half_period(time: Array, turns: list[int]) -> float:
    """Compute the half period [s] from coarse turning points; raise an error if there is no swing."""
    if len(turns) < 2:
        raise FitError(
            "no oscillation to evaluate",
            found="no turning point after the release",
            allowed="at least 1",
            hint=(
                "Possible causes: damping near critical, friction that stops the first oscillation, or a "
                "record that is not a free decay."
            ),
        )
    gaps = np.diff(time[turns])
    return float(np.median(gaps[1:] if len(gaps) > 1 else gaps))


def _parabola(
    time: Array, signal: Array, smooth: Array, index: int, half: float
) -> tuple[float, float]:
    near = (
        np.abs(time - time[index]) <= half / 10.0
    )  # there a cosine is a parabola to 0.04 % of its height
    near[max(index - 1, 0) : index + 2] = True
    local = time[near] - time[index]
    if len(local) < 3:
        return float(time[index]), float(smooth[index])
    square, slope, level = np.polyfit(local, signal[near], 2)
    shift = -slope / (2.0 * square) if square != 0.0 else 0.0
    if abs(shift) > half / 8.0:  # a vertex beyond the samples is one of noise
        return float(time[index]), float(smooth[index])
    return float(time[index] + shift), float(level + 0.5 * slope * shift)


@dataclass(frozen=True)
class PeakRegression:
    """Damping ratio [1], and friction deflection F_c / k and equilibrium (unit of the signal), from turning points.

    The friction is negative if the peaks decrease more slowly than they would with any friction.
    """

    damping_ratio: float
    friction_deflection: float
    equilibrium: float


def ratio_from_decrement(decrement: float) -> float:
    """Compute the damping ratio [1] from the logarithmic decrement per full cycle [1].

    >>> round(ratio_from_decrement(0.631484), 6)
    0.1
    """
    return decrement / math.hypot(2.0 * math.pi, decrement)


def _equivalent(decrement: Estimate) -> Estimate:
    if not math.isfinite(decrement.value):
        return Estimate(1.0)
    slope = (2.0 * math.pi) ** 2 / math.hypot(2.0 * math.pi, decrement.value) ** 3
    error = None if decrement.standard_error is None else slope * decrement.standard_error
    ends = decrement.interval and (
        ratio_from_decrement(decrement.interval[0]),
        ratio_from_decrement(decrement.interval[1]),
    )
    return Estimate(ratio_from_decrement(decrement.value), error, ends)


def regress_peaks(peaks: Peaks) -> PeakRegression:
    """Separate viscous from dry damping by the recursion of turning points.

    The swings D_i between neighbouring turning points obey |D_(i+1)| = q |D_i| - 2 x_k (1 + q) for any equilibrium.
    This gives q and the equilibrium. The amplitudes X_i about it then obey X_(i+1) = q X_i - x_k (1 + q), which is
    fitted using only turning points on alternating sides (a mass about to stick turns twice on the same side). With
    the minimum of three turning points, friction is assumed to be zero.

    >>> x = np.array([20.0, -12.702389, 7.559395, -3.934868, 1.380481, 0.419723])
    >>> found = regress_peaks(Peaks(np.arange(6.0), x + 5.0))
    >>> [round(value, 4) for value in (found.damping_ratio, found.friction_deflection, found.equilibrium)]
    [0.1107, 0.8169, 5.0]
    """
    swing = np.abs(np.diff(peaks.value))
    if len(swing) < 3:
        q = float(np.clip(swing[1] / swing[0], 1e-4, 0.9999))
        return PeakRegression(_ratio_of(q), 0.0, _equilibrium(peaks, swing, q, 0.0))
    q, intercept = np.polyfit(swing[:-1], swing[1:], 1, w=swing[:-1])
    q = float(np.clip(q, 1e-4, 0.9999))
    friction = -float(intercept) / (2.0 * (1.0 + q))
    centre = _equilibrium(peaks, swing, q, friction)
    positive = alternating(peaks.value - centre)
    if len(positive) >= 4:
        slope, level = np.polyfit(positive[:-1], positive[1:], 1)
        if 0.0 < slope < 1.0:
            q, friction = float(slope), -float(level) / (1.0 + float(slope))
    return PeakRegression(_ratio_of(q), friction, centre)


def _ratio_of(q: float) -> float:
    """Compute the damping ratio from the ratio of neighbouring amplitudes."""
    return ratio_from_decrement(-2.0 * math.log(q))


def _equilibrium(peaks: Peaks, swing: Array, q: float, friction: float) -> float:
    side = np.sign(-np.diff(peaks.value))  # +1 where the swing starts above
    amplitude = side * (friction + swing / (1.0 + q))
    return float(np.average(peaks.value[:-1] - amplitude, weights=swing))


# search ---------------------------------------------------------------------------------------------------------------

_ZEROED = 0.2  # share of the first swing: velocities and accelerations with a smaller mean start without offset


def _start(peaks: Peaks, quantity: Quantity, ratio: float, friction: float, centre: float) -> Array:
    """Return a start vector from the damping ratio and friction (unit of the record) of the turning points."""
    ratio = float(np.clip(ratio, 0.002, 0.9))
    damped = math.pi / peaks.half_period()
    omega = damped / math.sqrt(1.0 - ratio**2)
    top = float(peaks.value[0]) - centre
    if order_of(quantity) == 0:
        return np.array([omega, ratio, friction, centre, float(peaks.time[0]) - 0.1 / omega, top])
    if order_of(quantity) == 1:
        late = math.acos(ratio) / damped
        factor = math.exp(-ratio * omega * late) * omega
        deflection, begin = -top / factor, float(peaks.time[0]) - late
    else:
        factor, begin = omega**2, float(peaks.time[0]) - 0.1 / omega
        deflection = -top / factor
    shifted = friction / factor
    return np.array(
        [
            omega,
            ratio,
            shifted,
            centre,
            begin,
            deflection + shifted * math.copysign(1.0, deflection),
        ]
    )


def _starts(peaks: Peaks, quantity: Quantity) -> list[Array]:
    """Return start vectors: the regression of the turning points, then mixtures of viscous damping and dry friction."""
    guess = regress_peaks(peaks)
    swing = np.abs(np.diff(peaks.value))
    naive = ratio_from_decrement(max(1e-3, 2.0 * math.log(swing[0] / swing[1])))
    dry = float(swing[0] - swing[1]) / 4.0
    is_zeroed = order_of(quantity) > 0 and abs(guess.equilibrium) < _ZEROED * swing[0]
    centre = 0.0 if is_zeroed else guess.equilibrium
    pairs = [(guess.damping_ratio, guess.friction_deflection)]
    pairs += [((1.0 - share) * naive, share * dry) for share in (0.0, 0.25, 0.5, 0.75, 1.0)]
    starts = [_start(peaks, quantity, ratio, friction, centre) for ratio, friction in pairs]
    if (
        order_of(quantity) == 2
    ):  # its largest value may be just before a turning point: count from the one before
        starts += [_one_half_earlier(start) for start in starts]
    return starts


def _early(t: Array, peaks: Peaks) -> NDArray[np.bool_]:
    """Mark the early samples, until the swings fall below a fifth of the first; at least three half cycles."""
    swing = np.abs(np.diff(peaks.value))
    small = np.flatnonzero(
        swing < 0.2 * swing[0]
    )  # a chosen limit: later swings are increasingly dominated by friction and noise
    index = max(3, int(small[0]) if len(small) else len(swing))
    early: NDArray[np.bool_] = t <= float(peaks.time[min(index, len(swing))])
    return early if np.count_nonzero(early) >= _FEWEST else np.ones(len(t), bool)


def _along_the_valley(start: Array, share: float) -> Array:
    """Exchange dry friction for viscous damping, keeping the mean loss of amplitude."""
    change = share * max(abs(start[2]), 0.01 * abs(start[5]))
    moved = start.copy()
    moved[2] += change
    moved[1] = np.clip(moved[1] - 4.0 * change / (math.pi * abs(start[5])), -0.15, 0.95)
    return moved


def _one_half_earlier(start: Array) -> Array:
    omega, ratio, friction, offset, begin, deflection = start
    root = math.sqrt(1.0 - ratio**2)
    side = math.copysign(1.0, deflection)
    before = -(deflection + side * friction) * math.exp(math.pi * ratio / root) - side * friction
    return np.array([omega, ratio, friction, offset, begin - math.pi / (omega * root), before])


def _unpack(values: Array) -> DecayParameters:
    return DecayParameters(*(float(value) for value in values))


_RATIO, _FRICTION, _OFFSET, _RELEASE_TIME, _DRAG = 1, 2, 3, 4, 6  # indices in a parameter vector
_WITHOUT_DRAG = (True, True, True, True, True, True, False)
_EVERYTHING = (True,) * 7
_FAR = 1e6  # as a share of the range: residual of an impossible fit
_CLEAR_GAIN = 12.0  # gain of twice the log-likelihood: about 3.5 standard errors


def _fit(
    t: Array,
    signal: Array,
    starts: list[Array],
    quantity: Quantity,
    free: Sequence[bool] = _WITHOUT_DRAG,
) -> tuple[Array, Uncertainty, Array]:
    """Fit by nonlinear least squares from several starts; return the best parameters, their uncertainty and residual.

    Parameters that are not ``free`` keep their start values and count as exactly known.
    """
    if len(t) < _FEWEST or np.ptp(signal) == 0.0 or not np.all(np.isfinite(np.concatenate(starts))):
        raise FitError(
            "the record contains no free decay that can be fitted",
            found=f"{len(t)} samples between turning points",
            hint="Select the section with a time window (from, to).",
        )
    thin = _sample_step(t, starts[0])
    if len(starts) > 1 and thin > 1:  # the starts are compared on a part of the samples
        starts = [_fit(t[::thin], signal[::thin], starts, quantity, free)[0]]
    reach, which = float(np.ptp(signal)), np.array(free)
    best = None
    for start in starts:
        descent = _descend(
            t, signal / reach, np.append(start, np.zeros(7 - len(start))), quantity, reach, which
        )
        if best is None or descent[0].cost < best[0].cost * (1.0 - 1e-9):
            best = descent
    assert best is not None
    solution, scale, begin = best
    values = begin.copy()
    values[which] = solution.x * scale[which]
    residual, jacobian = -reach * solution.fun, reach * solution.jac / scale[which]
    if order_of(quantity) == 2:
        jacobian = jacobian * _off_jumps(t, _unpack(values))[:, None]
    spread = uncertainty(jacobian, residual)
    covariance = np.zeros((7, 7))
    covariance[np.ix_(which, which)] = spread.covariance
    return values, replace(spread, covariance=covariance), residual


def _sample_step(t: Array, start: Array) -> int:
    """Return the sample stride of a coarse search: it keeps at least 40 samples per cycle and some thousands in all."""
    cycle = 2.0 * math.pi / float(start[0]) / float(np.median(np.diff(t)))
    return max(1, min(int(cycle / 40.0), len(t) // 2000))


def _off_jumps(t: Array, parameters: DecayParameters) -> Array:
    """Return 0 at samples next to a turning point, where friction makes the acceleration jump, and 1 elsewhere."""
    damped = parameters.angular_frequency * math.sqrt(1.0 - parameters.damping_ratio**2)
    phase = (t - parameters.release_time) * damped / math.pi
    # Acceleration changes within a step there: two samples at most are less than 0.6 steps away.
    return (np.abs(phase - np.round(phase)) > 0.6 * float(np.median(np.diff(phase)))).astype(float)


def _descend(
    t: Array, target: Array, start: Array, quantity: Quantity, reach: float, free: NDArray[np.bool_]
) -> tuple[Any, Array, Array]:
    """Run one descent in scaled free parameters; return SciPy's solution, the scales and the start within bounds."""
    from scipy.optimize import least_squares

    size = abs(start[5])
    scale = np.array([start[0], 0.1, 0.02 * size, reach, 1.0 / start[0], size, 0.1 / size])
    low = (
        np.array(
            [0.3 * start[0], -0.2, -size, -np.inf, t[0] - 6.0 / start[0], -np.inf, -1.0 / size]
        )
        / scale
    )
    high = (
        np.array([3.0 * start[0], 0.97, size, np.inf, t[0] + 3.0 / start[0], np.inf, 30.0 / size])
        / scale
    )

    def point(scaled: Array) -> Array:
        values = start.copy()
        values[free] = scaled * scale[free]
        return values

    def misfit(scaled: Array) -> Array:
        response = decay_response(t, _unpack(point(scaled)), quantity) / reach
        return (
            np.clip(np.nan_to_num(response, nan=_FAR), -_FAR, _FAR) - target
        )  # negative damping explodes

    closed = not free[_DRAG] and start[_DRAG] == 0.0

    def slopes(scaled: Array) -> Array:
        values = point(scaled)
        if closed:
            jacobian = decay_slopes(t, _unpack(values), quantity)[:, free[:_DRAG]]
        else:
            steps = np.cbrt(np.finfo(float).eps) * np.maximum(scale, np.abs(values))
            jacobian = _slopes_with_drag(t, values, quantity, steps)[:, free]
        jacobian *= scale[free] / reach
        jacobian[~(np.abs(misfit(scaled) + target) < _FAR)] = 0.0
        return jacobian

    begin = np.clip(start / scale, low + 1e-9, high - 1e-9)
    solution = least_squares(
        misfit,
        begin[free],
        bounds=(low[free], high[free]),
        jac=slopes,
        xtol=1e-11,
        ftol=1e-11,
        gtol=1e-11,
        max_nfev=60,
    )
    return solution, scale, start


def _slopes_with_drag(t: Array, values: Array, quantity: Quantity, steps: Array) -> Array:
    """Return derivatives of the response by all parameters, shape (n, 7); by differences without a closed form."""
    slopes = np.ones((len(t), 7))
    known = [_OFFSET] if order_of(quantity) == 2 else [_OFFSET, _RELEASE_TIME]
    others = np.delete(np.arange(7), known)

    def response(some: Array) -> Array:
        moved = values.copy()
        moved[others] = some
        return decay_response(t, _unpack(moved), quantity)

    slopes[:, others] = central_differences(response, values[others], steps[others])
    if order_of(quantity) < 2:  # a later release is the same motion later
        following = motion_of(quantity).quantities[order_of(quantity) + 1]
        slopes[:, _RELEASE_TIME] = values[_OFFSET] - decay_response(t, _unpack(values), following)
    return slopes


def _not_negative(
    t: Array,
    signal: Array,
    values: Array,
    spread: Uncertainty,
    quantity: Quantity,
    free: Sequence[bool],
) -> tuple[Array, Uncertainty, Array]:
    """Set negative parameters (damping, friction, drag) to zero, the most significant first, and refit the others.

    A parameter at zero keeps its uncertainty from the fit in which it was free. The uncertainties of the others are not
    reduced below those of that fit.
    """
    left = list(free)
    doubt: Array = np.diag(spread.covariance).copy()
    residual = signal - decay_response(t, _unpack(values), quantity)
    while True:
        wrong = [i for i in (_RATIO, _FRICTION, _DRAG) if left[i] and values[i] < 0.0]
        if not wrong:
            break
        clearest = min(
            wrong, key=lambda i: float(values[i]) / math.sqrt(max(float(doubt[i]), 1e-300))
        )
        left[clearest] = False
        start = values.copy()
        start[clearest] = 0.0
        values, spread, residual = _fit(t, signal, [start], quantity, left)
    if left == list(free):
        return values, spread, residual
    known = np.diag(spread.covariance)
    covariance = spread.covariance + np.diag(np.maximum(doubt - known, 0.0))
    return values, replace(spread, covariance=covariance), residual


@dataclass(frozen=True)
class DecayPart:
    """A free decay in a record: samples, turning points, and the fit of its large swings.

    ``values`` is the parameter vector of that fit and ``r2`` its coefficient of determination (1). ``early_misfit`` is
    the r.m.s. residual of the first half cycle over that of the others (1); it is large if the part contains the hit.
    """

    time: Array
    signal: Array
    peaks: Peaks
    values: Array
    r2: float
    early_misfit: float
    findings: tuple[Finding, ...]


def search_decay(
    part: DecayPart,
    quantity: Quantity,
    drag: Drag,
    name: str,
    findings: list[Finding],
    known: float | None = None,
) -> tuple[DecayParameters, Uncertainty, Array, bool]:
    """Fit the response, without the time at rest if sliding friction would have stopped the mass elsewhere.

    ``known`` is the natural angular frequency (rad/s) from mass and stiffness. Returns the best parameters, their
    uncertainty, the residual (measured minus fitted, NaN where the record was left out), and whether the response
    includes quadratic drag.
    """
    t, signal, peaks = part.time, part.signal, part.peaks
    starts = [part.values]
    starts += [_along_the_valley(starts[0], share) for share in (-0.15, -0.05, 0.05, 0.15)]
    values, spread, residual = _fit(t, signal, starts, quantity)
    rest = _at_rest(t, signal, peaks)
    used = np.ones(len(t), bool)
    if order_of(quantity) == 0 and np.count_nonzero(rest) >= 10:
        alone = _fit(t[~rest], signal[~rest], [starts[0], values], quantity)
        gap, doubt = _rest_gap(t[rest], signal[rest], alone[0], alone[1])
        # Four standard errors occur by chance once in 16 000 records; smaller gaps are misfit or have no effect.
        if abs(gap) >= max(
            4.0 * doubt, 3.0 * float(alone[2].std()), 0.05 * abs(alone[0][_FRICTION])
        ):
            findings.append(
                finding("identify.static_friction", name, gap, gap=motion_of(quantity).say(gap))
            )
            used, (values, spread, residual) = ~rest, alone
    without_drag = _not_negative(t[used], signal[used], values, spread, quantity, _WITHOUT_DRAG)
    dragged = _with_drag(t[used], signal[used], peaks, without_drag, quantity, drag)
    if (
        dragged
        and drag == "auto"
        and known is not None
        and _leads_away(dragged[0], without_drag[0], known)
    ):
        dragged = None
    values, spread, fitted_residual = dragged or without_drag
    residual = np.full(len(t), np.nan)
    residual[used] = fitted_residual
    return _unpack(values), spread, residual, dragged is not None


def _with_drag(
    t: Array,
    signal: Array,
    peaks: Peaks,
    without: tuple[Array, Uncertainty, Array],
    quantity: Quantity,
    drag: Drag,
) -> tuple[Array, Uncertainty, Array] | None:
    """Fit quadratic drag as well; None if it is not requested, or if it is optional and the data do not show it."""
    values, _, residual = without
    before = float(np.sqrt(np.mean(residual**2)))
    if drag == "no" or (drag == "auto" and before <= EXACT * float(np.ptp(signal))):
        return None
    starts = []
    for share in (
        0.0,
        0.5,
        0.9,
    ):  # share of the dissipated energy that drag takes over from viscous damping, at half the amplitude
        start = np.append(values, 0.0)[:7]
        start[_DRAG] += share * max(start[_RATIO], 1e-3) * 1.5 * math.pi / abs(start[5])
        start[_RATIO] *= 1.0 - share
        starts.append(start)
    early = _early(t, peaks)
    starts.append(_fit(t[early], signal[early], starts, quantity, _EVERYTHING)[0])
    free, spread, _ = _fit(t, signal, starts, quantity, _EVERYTHING)
    with_drag = _not_negative(t, signal, free, spread, quantity, _EVERYTHING)
    if drag == "yes":
        return with_drag
    after = max(float(np.sqrt(np.mean(with_drag[2] ** 2))), 1e-3 * EXACT * float(np.ptp(signal)))
    gain = 2.0 * len(t) / correlation_time(with_drag[2]) * math.log(max(before / after, 1.0))
    return with_drag if with_drag[0][_DRAG] > 0.0 and gain > _CLEAR_GAIN else None


def _leads_away(dragged: Array, without: Array, known: float) -> bool:
    """Whether quadratic drag moves the frequency away from a known one, so that it represents a different effect.

    Such effects are a second mass, or the friction of a strut on a tyre, which the single-mass model does not include.
    """
    with_drag, without_drag = (
        abs(_unpack(values).angular_frequency / known - 1.0) for values in (dragged, without)
    )
    return with_drag > max(without_drag, 0.5 * _OFF)


def _at_rest(t: Array, signal: Array, peaks: Peaks) -> NDArray[np.bool_]:
    """Mark the samples at rest at the end of the record."""
    tail = signal[-max(5, len(signal) // 20) :]
    # Test records that end at rest reach half of this limit, those that end in motion at least four times.
    if float(tail.std()) > 3.0 * noise_of(signal) + 1e-3 * float(np.ptp(signal)):
        return np.zeros(len(t), bool)  # the record ends while it moves
    still = max(4.0 * float(tail.std()), 1e-3 * float(np.ptp(signal)))
    left = np.flatnonzero(np.abs(signal - np.median(tail)) > still)
    begin = int(left[-1]) + 1 if len(left) else 0
    marks = np.arange(len(t)) >= begin
    long_enough = t[-1] - t[min(begin, len(t) - 1)] > peaks.half_period()
    return marks if long_enough else np.zeros(len(t), bool)


def _rest_gap(t: Array, signal: Array, values: Array, spread: Uncertainty) -> tuple[float, float]:
    """Return the mean distance of the rest position from the end of the response, and the standard error of the end."""

    def end(point: Array) -> Array:
        return np.asarray(decay_response(t, _unpack(point), "displacement").mean())

    steps = 1e-6 * np.maximum(np.abs(values), 1e-3 * abs(values[5]))
    gradient = central_differences(end, values, steps)
    return float(signal.mean()) - float(end(values)), spread.propagate(
        0.0, gradient
    ).standard_error or 0.0


# fit ------------------------------------------------------------------------------------------------------------------


def _label_in_motion(before: str, word: str, behind: str = "") -> Callable[[Any], str]:
    """Make a label that contains a word of the motion, such as mass or inertia."""
    return lambda decay: f"{before} {in_motion(word)(decay)}{behind}"


@dataclass(frozen=True)
class DecayEstimates(Shown):
    """Result of one or several decays: see :class:`DecayResult`."""

    damping_ratio: Annotated[Estimate, Shows("viscous damping ratio", "1")]
    damping_coefficient: Annotated[
        Estimate, Shows("viscous damping coefficient", in_motion("damping"))
    ]
    coulomb_force: Annotated[
        Estimate, Shows(_label_in_motion("dry friction", "force_word"), in_motion("force"))
    ]
    quadratic_drag: Annotated[Estimate | None, Shows("quadratic drag", in_motion("drag"))]
    natural_frequency_hz: Annotated[Estimate, Shows("natural frequency", "Hz")]
    equilibrium: Annotated[Estimate | None, Shows("equilibrium position", in_motion("deflection"))]
    stiffness: Annotated[
        Estimate,
        Shows(
            _label_in_motion("stiffness from", "inertia_word", " and natural frequency"),
            in_motion("stiffness"),
        ),
    ]
    logarithmic_decrement: Annotated[
        Estimate, Shows("logarithmic decrement (friction neglected, for comparison)", "1")
    ]

    @property
    def equivalent_damping_ratio(
        self,
    ) -> Annotated[Estimate, Shows("damping ratio (friction neglected)", "1")]:
        """Equivalent viscous damping ratio from the naive decrement [1], which includes friction."""
        return _equivalent(self.logarithmic_decrement)


@dataclass(frozen=True)
class DecayResult(DecayEstimates):
    """Damping identified from one free decay.

    Attributes
    ----------
    damping_ratio : Estimate
        Viscous part only, c / (2 sqrt(k m)) [1].
    damping_coefficient : Estimate
        Viscous part only, c [N s/m]; of a rotation [N m s/rad].
    coulomb_force : Estimate
        Dry friction F_c [N]; of a rotation its torque [N m]; not negative.
    quadratic_drag : Estimate or None
        d [N s^2/m^2] of a force ``d x' |x'|``, of a rotation [N m s^2/rad^2], not negative; None if the record shows no
        drag.
    natural_frequency_hz : Estimate
        Undamped natural frequency [Hz].
    equilibrium : Estimate or None
        Displacement [m] or angle [rad] of static equilibrium without friction; not the final rest position, which
        depends on friction. None for velocity and acceleration records.
    stiffness : Estimate
        Mass or inertia times squared natural angular frequency [N/m or N m/rad].
    logarithmic_decrement : Estimate
        Naive decrement: slope of ln(amplitude) per full cycle about the equilibrium, all turning points [1]. Friction
        makes it larger than viscous damping alone.
    amplitudes : tuple of float
        Amplitudes of the successive turning points about the equilibrium, unit of the record.
    decrements : tuple of float
        ln(X_i / X_(i+2)) of successive turning points [1].
    naive_damping_ratios : tuple of float
        Damping ratios that correspond to these decrements without friction [1].
    cycles : float
        Full cycles between first and last turning point [1].
    r2 : float
        Share of the variance of the decay explained by the response [1].
    rms_residual : float
        Root mean square of measured minus fitted, unit of the record.
    window : (float, float)
        First and last time used [s].
    parameters : DecayParameters
        The fitted response; ``decay_response(time, parameters, quantity)`` draws it.
    quantity : {"displacement", "velocity", "acceleration", "angle", "angular_velocity", "angular_acceleration"}
        Quantity that was fitted.
    findings : tuple of Finding
        Limitations of the result.
    """

    amplitudes: tuple[float, ...]
    decrements: tuple[float, ...]
    naive_damping_ratios: tuple[float, ...]
    cycles: Annotated[float, Shows("cycles", "1")]
    r2: Annotated[float, Shows("R²", "1", 6)]
    rms_residual: float
    window: tuple[float, float]
    parameters: DecayParameters
    quantity: Quantity
    findings: tuple[Finding, ...]

    @property
    def motion(self) -> MotionName:
        """Whether a mass moves along a line ("translation") or an inertia about an axis ("rotation")."""
        return motion_of(self.quantity).name


def fit_decay(
    time: ArrayLike | xr.Dataset | pd.DataFrame,
    displacement: ArrayLike | None = None,
    *,
    mass: float | None = None,
    inertia: float | None = None,
    stiffness: float | None = None,
    quantity: Quantity = "displacement",
    begin: float | str | None = None,
    end: float | str | None = None,
    quadratic_drag: Drag = "auto",
    name: str = "decay",
) -> DecayResult:
    """Find viscous damping, dry friction and quadratic drag from a free decay.

    The response of ``m x'' + c x' + F_c sign(x') + d x' |x'| + k (x - x_eq) = 0`` is fitted to the record from the
    release on, final sticking included. Without drag it has a closed form from turning point to turning point. Start
    values come from the recursion of the turning points. c, F_c and d cannot be negative: a parameter that would be
    negative is set to zero and the others are refitted. The record may contain a hold before the release, an initial
    velocity, or a release in the middle. The hit of an impact test is left out if it is the largest excursion, and so
    is everything after a second hit, with findings. Displacement is the best quantity. With friction, an acceleration
    jumps at every turning point, and its intervals for the friction are some 10 % too narrow.

    A pendulum or another rotating part obeys the same equation with inertia and torques: state ``inertia`` instead of
    ``mass``, and an angular ``quantity``, such as the angular velocity of a rate gyro.

    Parameters
    ----------
    time : array (n,), DataArray, Dataset or DataFrame
        Increasing times [s]; or, without ``displacement``, a channel with its own time, a recording or a table
        (``name [unit]``) with one channel of the ``quantity``.
    displacement : array (n,), optional
        The record of the ``quantity``: displacement [m], velocity [m/s], acceleration [m/s^2], angle [rad], angular
        velocity [rad/s] or angular acceleration [rad/s^2]; any zero, any sign.
    mass : float
        Oscillating mass [kg], for a displacement, velocity or acceleration.
    inertia : float
        Moment of inertia about the axis [kg m^2], for an angle or its derivatives.
    stiffness : float or None
        Known stiffness [N/m or N m/rad]: compared with the one from mass and frequency; "auto" accepts no drag that
        moves the result away from it.
    quantity : {"displacement", "velocity", "acceleration", "angle", "angular_velocity", "angular_acceleration"}
        Quantity of the record.
    begin, end : float or str or None
        First and last time to use, s; None: the whole record.
    quadratic_drag : {"auto", "yes", "no"}
        Whether d is fitted as well; "auto": if it explains the residual of viscous damping and friction.
    name : str
        File or channel named in messages.

    Returns
    -------
    DecayResult
        Estimates with standard errors and 95 % intervals.

    Raises
    ------
    FitError
        Unequal lengths, NaN, time that does not increase, a mass (or inertia, for a rotation) that is missing or not
        positive, no oscillation.

    References
    ----------
    Den Hartog (1931), Transactions of the ASME 53, 107-115 (combined viscous and Coulomb damping).

    Examples
    --------
    >>> from jounce.identify.decay import decay_response
    >>> truth = DecayParameters(33.9, 0.11, 0.8e-3, 0.0, 0.2, 0.020)
    >>> t = np.arange(0.0, 2.0, 1e-3)
    >>> result = fit_decay(t, decay_response(t, truth, "displacement"), mass=16.0)
    >>> round(result.damping_ratio.value, 5), round(result.coulomb_force.value, 2)
    (0.11, 14.71)
    """
    if quadratic_drag not in DRAG_CHOICES:
        raise unknown(str(quadratic_drag), DRAG_CHOICES, what="quadratic_drag", where=name)
    if quantity not in QUANTITIES:
        raise unknown(str(quantity), QUANTITIES, what="quantity", where=name)
    motion = motion_of(quantity)
    if displacement is None:
        displacement = carried_channel(time, motion.units[order_of(quantity)], where=name)
        time = clock_of([displacement], where=name)
    mass = _inertia(mass, inertia, motion, quantity, name)
    stiffness = (
        None
        if stiffness is None
        else as_number(stiffness, motion.stiffness, where=f"{name}: stiffness")
    )
    t, signal = _check_record(time, displacement, stiffness, quantity, name)
    t, signal = _in_window(t, signal, begin, end, name)
    t, signal, logged = without_dropouts(t, signal, name)
    part = _best_part(t, signal, quantity, name, look_on=begin is None)
    known = None if stiffness is None else math.sqrt(stiffness / mass)
    drifted, reach = 0.0, float(np.ptp(part.signal))
    for attempt in range(_DETRENDED + 1):
        findings, peaks = list(part.findings), part.peaks
        parameters, spread, residual, has_drag = search_decay(
            part, quantity, quadratic_drag, name, findings, known
        )
        drift = drift_of(part.time, residual, parameters, reach)
        if drift is None or attempt == _DETRENDED or spread.correlation_time <= _ALIKE_FOR:
            break
        drifted += float(drift(part.time[-1]) - drift(part.time[0]))
        turns = replace(peaks, value=peaks.value - drift(peaks.time))
        part = replace(part, signal=part.signal - drift(part.time), peaks=turns)
    if drifted:
        findings.append(finding("identify.decay_drifts", name, drifted, drifted=drifted))
    used = np.isfinite(residual)
    t, signal, residual = part.time[used], part.signal[used], residual[used]
    estimates = _estimates(parameters, spread, mass)
    centre, drag = estimates.pop("equilibrium"), estimates.pop("quadratic_drag")
    amplitudes = _amplitudes(peaks, parameters, quantity)
    decrements = tuple(
        float(math.log(a / b)) for a, b in zip(amplitudes[:-2], amplitudes[2:], strict=True)
    )
    result = DecayResult(
        **estimates,
        quadratic_drag=drag if has_drag else None,
        equilibrium=centre if order_of(quantity) == 0 else None,
        logarithmic_decrement=_naive_decrement(amplitudes),
        amplitudes=tuple(map(float, amplitudes)),
        decrements=decrements,
        naive_damping_ratios=tuple(ratio_from_decrement(decrement) for decrement in decrements),
        cycles=(len(peaks.time) - 1) / 2.0,
        r2=r_squared(signal, residual),
        rms_residual=float(np.sqrt(np.mean(residual**2))),
        window=(float(t[0]), float(t[-1])),
        parameters=parameters,
        quantity=quantity,
        findings=(),
    )
    findings += [*logged, *_advice(result, spread, float(np.median(np.diff(t))), stiffness, name)]
    if stiffness is None:
        findings.append(
            finding(
                "identify.decay_stiffness",
                name,
                result.stiffness.value,
                inertia=motion.inertia_word,
                value=result.stiffness.value,
                unit=unit_in_words(motion.stiffness),
            )
        )
    is_alike = spread.correlation_time > _ALIKE_FOR
    findings += _doubts(
        result, replace(part, time=t, signal=signal), residual, name, is_alike=is_alike
    )
    return replace(result, findings=tuple(findings))


def _doubts(
    result: DecayResult, part: DecayPart, residual: Array, name: str, *, is_alike: bool
) -> list[Finding]:
    """Report defects of a record that its fit does not show; ``is_alike`` is true if residuals are correlated."""
    t, signal, peaks, p, order = (
        part.time,
        part.signal,
        part.peaks,
        result.parameters,
        order_of(result.quantity),
    )
    findings: list[Finding] = []
    if order < 2 and (lost := count_lost_samples(t, signal)) > _FEW_LOST:
        findings.append(finding("identify.decay_jumps", name, lost, places=lost))
    if order == 0:
        findings += nonlinear_spring(peaks.time, peaks.value, p, noise_of(signal), name)
    held, step = p.friction_deflection * p.angular_frequency**order, quantum_of(signal)
    if step > _STEPS * held and _is_clear(result.coulomb_force):
        findings.append(
            finding("identify.decay_steps_hide_friction", name, step, step=step, held=held)
        )
    if result.rms_residual <= EXACT * float(np.ptp(signal)):
        return findings
    low = low_pass_of(t, signal, residual, p, name, is_alike=is_alike)
    causes = residual_causes(t, signal, residual, p, result.quantity, name) if is_alike else []
    if is_alike and not causes:
        causes = _read_otherwise(part, residual, result, name, is_smooth=bool(low))
    return [*findings, *causes, *low]


def _is_clear(friction: Estimate) -> bool:
    """Whether a friction is significant."""
    return (
        friction.standard_error is not None and friction.value > _CLEARLY * friction.standard_error
    )


def _read_otherwise(
    part: DecayPart, residual: Array, result: DecayResult, name: str, *, is_smooth: bool
) -> list[Finding]:
    """Report a different reading of the record if it fits much better: a different quantity, or high-pass filtered.

    A record that ``is_smooth`` after a low-pass filter resembles an integrated one to some degree.
    """
    t, signal, left = part.time, part.signal, float(residual @ residual)
    parameters, quantity = result.parameters, result.quantity

    def leaves(record: Array, starts: list[Array], other: Quantity) -> float:
        """Residual of a fit, as a share of the uncorrected record's [1]."""
        try:
            rest = _fit(t, record, starts, other)[2]
        except FitError:
            return math.inf
        return float(rest @ rest) / left

    others = [other for other in motion_of(quantity).quantities if other != quantity]
    shares = {other: leaves(signal, _starts(part.peaks, other), other) for other in others}
    other = min(shares, key=lambda candidate: shares[candidate])
    if shares[other] < (_SURELY if is_smooth else _RATHER):
        return [
            finding(
                "identify.decay_of_other_quantity",
                name,
                1.0 / shares[other],
                other=_in_words(other),
                quantity=_in_words(quantity),
                times=1.0 / shares[other],
            )
        ]
    if is_smooth:
        return []
    frequency = parameters.angular_frequency / (2.0 * math.pi)
    summed = np.concatenate([[0.0], np.cumsum(0.5 * (signal[1:] + signal[:-1]) * np.diff(t))])
    start = np.array([getattr(parameters, key) for key in _NAMES])

    def share_uncoupled(corner: float) -> float:
        return leaves(signal + 2.0 * math.pi * corner * summed, [start], quantity)

    corner = float(min(frequency * _CORNERS, key=share_uncoupled))
    corner = float(min(corner * _BESIDE, key=share_uncoupled))
    if (least := share_uncoupled(corner)) < _COUPLED:
        return [finding("identify.decay_high_pass", name, corner, corner=corner, share=least)]
    return []


def _in_words(quantity: Quantity) -> str:
    """Return the quantity in words."""
    return quantity.replace("_", " ")


_RATHER, _SURELY, _COUPLED = (
    0.2,
    0.05,
    0.35,
)  # remaining share of the residual with a different quantity: a fifth is not by chance
_CORNERS = np.geomspace(
    0.01, 0.5, 10
)  # as shares of the natural frequency; then refined around the best
_BESIDE = np.array([0.75, 0.87, 1.0, 1.15, 1.33])
_NAMES = tuple(one.name for one in fields(DecayParameters) if one.name != "quadratic_drag")
_OFF = 0.03  # relative deviation of the stiffness above which it is reported
_FEW_LOST = 2  # gaps: fewer have no effect
_ALIKE_FOR = 4.0  # correlation length of residuals, in samples, above which they exceed noise
_STEPS = 2.0  # ratio to the shift by friction: larger steps hide it
_DETRENDED = 4  # times that a drift is subtracted
_MOST_ACCELERATION = 500.0  # m/s^2: struck wheels reach some 40 g
_SAME = 0.02  # relative change of a logarithmic decrement below which it counts as constant
_CLEARLY = 4.0  # standard errors of a friction: by its interval alone one decay in forty would show friction
_TRIES = 5  # turning points, each of which may be the release
_EXPLAINED, _STILL_HIT = (
    0.98,
    6.0,
)  # R2, and misfit of the first half cycle relative to later ones: limits for the end of the hit


def _in_window(
    t: Array, signal: Array, begin: float | str | None, end: float | str | None, name: str
) -> tuple[Array, Array]:
    low = -math.inf if begin is None else to_si(begin, "s", where=f"{name}: from")
    high = math.inf if end is None else to_si(end, "s", where=f"{name}: to")
    inside = (t >= low) & (t <= high)
    if low >= high or np.count_nonzero(inside) < _FEWEST:
        raise FitError(
            "the time window leaves too few samples",
            where=name,
            found=f"{np.count_nonzero(inside)} from {low:g} s to {high:g} s",
            allowed=Phrase(
                "at least {fewest} within {t:g} s to {second_t:g} s",
                fewest=_FEWEST,
                t=t[0],
                second_t=t[-1],
            ),
        )
    if np.ptp(signal[inside]) == 0.0:
        raise FitError(
            "the record never changes in the time window",
            where=name,
            found=f"{low:g} s to {high:g} s",
        )
    return t[inside], signal[inside]


def _best_part(
    t: Array, signal: Array, quantity: Quantity, name: str, *, look_on: bool
) -> DecayPart:
    """Fit from the largest excursion on; if that is the hit itself, from later turning points until the fit is good."""
    noise = noise_of(signal)
    first, best, refusal = find_release(signal, noise), None, None
    for attempt in range(_TRIES if look_on else 1):
        try:
            part = _part(t, signal, first, noise, quantity, name)
        except FitError as error:
            refusal = refusal or error
        else:
            fits = part.r2 >= _EXPLAINED and part.early_misfit < _STILL_HIT
            if (
                fits or best is None or part.r2 > best[1].r2 + 0.01
            ):  # the first of equally good releases
                best = (attempt, part)
            if fits:
                break
        following = _next_start(signal, first, noise)
        if following is None:
            break
        first = following
    if best is None:
        assert refusal is not None
        raise FitError(
            refusal.what,
            where=name,
            found=refusal.found,
            allowed=refusal.allowed,
            hint=refusal.hint,
        ) from refusal
    attempt, part = best
    if attempt:
        return replace(
            part,
            findings=(
                finding("identify.decay_begins_late", name, part.time[0], start=part.time[0]),
                *part.findings,
            ),
        )
    return part


def _next_start(signal: Array, first: int, noise: float) -> int | None:
    """Index of the release after the next turning point; None where too little is left."""
    ahead = signal[first:]
    if len(ahead) < 2 * _FEWEST:
        return None
    turns = zigzag(_smooth(ahead, noise), max(12.0 * noise, 0.03 * float(np.ptp(ahead))))
    after = first + (turns[1] if len(turns) > 1 else max(1, len(ahead) // 50))
    if len(signal) - after < _FEWEST or np.ptp(signal[after:]) == 0.0:
        return None
    return max(after + find_release(signal[after:], noise), first + 1)


def _part(
    t: Array, signal: Array, first: int, noise: float, quantity: Quantity, name: str
) -> DecayPart:
    """Cut out the decay that begins at an index, and fit its large swings.

    Far from sticking the misfit has a single minimum; each sticking position adds its own.
    """
    findings: list[Finding] = []
    every = find_peaks(t[first:], signal[first:], noise)
    peaks = until_it_grows(every, noise)
    last = int(np.searchsorted(t, peaks.time[-1] + 3.0 * peaks.half_period(), side="right"))
    if len(peaks.time) < len(every.time):
        findings.append(finding("identify.decay_grows", name, peaks.time[-1], end=peaks.time[-1]))
        last = int(np.searchsorted(t, peaks.time[-1], side="right"))
    t, signal = t[first:last], signal[first:last]
    if len(t) < _FEWEST:
        raise FitError(
            "too few samples of a free decay",
            found=len(t),
            allowed=Phrase("at least {fewest}", fewest=_FEWEST),
        )
    early = _early(t, peaks)
    values, _, residual = _fit(t[early], signal[early], _starts(peaks, quantity), quantity)
    opening = t[early] <= t[0] + peaks.half_period()
    misfit = 1.0
    if opening.any() and not opening.all():
        least = (EXACT * float(np.ptp(signal))) ** 2
        misfit = math.sqrt(
            float(np.mean(residual[opening] ** 2))
            / max(float(np.mean(residual[~opening] ** 2)), least)
        )
    return DecayPart(
        t, signal, peaks, values, r_squared(signal[early], residual), misfit, tuple(findings)
    )


def _inertia(
    mass: float | None, inertia: float | None, motion: MeasuredMotion, quantity: Quantity, name: str
) -> float:
    """Return the mass of a translation or the inertia of a rotation; raise an error if it is missing or wrong."""
    given = {"mass": mass, "inertia": inertia}
    stated = given.pop(motion.inertia_word)
    (other,) = given
    if given[other] is not None:
        raise FitError(
            _SWINGS[motion.inertia_word],
            where=name,
            found=f"{other} = {given[other]}, quantity {quantity}",
            allowed=Phrase(
                "{inertia_word} in {inertia}",
                inertia_word=Phrase(motion.inertia_word),
                inertia=unit_in_words(motion.inertia),
            ),
        )
    if stated is None:
        raise FitError(
            Phrase(
                "the {inertia_word} is not given, and a decay determines only ratios to it",
                inertia_word=Phrase(motion.inertia_word),
            ),
            where=name,
            found=f"quantity {quantity}",
            allowed=Phrase(
                "{inertia_word} in {inertia}",
                inertia_word=Phrase(motion.inertia_word),
                inertia=unit_in_words(motion.inertia),
            ),
        )
    value = as_number(stated, motion.inertia, where=f"{name}: {motion.inertia_word}")
    if not (math.isfinite(value) and value > 0.0):
        raise FitError(
            Phrase("the {inertia_word} is not positive", inertia_word=Phrase(motion.inertia_word)),
            where=name,
            found=value,
            allowed="above 0",
        )
    return value


_SWINGS = {
    "mass": "a record of this quantity needs the mass of the oscillating body",
    "inertia": "a record of this quantity needs the inertia of the oscillating body",
}


def _check_record(
    time: ArrayLike, record: ArrayLike, stiffness: float | None, quantity: Quantity, name: str
) -> tuple[Array, Array]:
    si = motion_of(quantity).units[order_of(quantity)]
    t = as_samples(time, "s", where=f"{name}: time", error=FitError)
    signal = as_samples(record, si, where=f"{name}: {quantity}", error=FitError)
    if t.ndim != 1 or t.shape != signal.shape:
        raise FitError(
            "time and record are not two columns of the same length",
            where=name,
            found=f"{t.shape} and {signal.shape}",
        )
    if len(t) < _FEWEST:
        raise FitError(
            "too few samples",
            where=name,
            found=len(t),
            allowed=Phrase("at least {fewest}", fewest=_FEWEST),
        )
    bad = np.flatnonzero(~(np.isfinite(t) & np.isfinite(signal)))
    if len(bad):
        raise FitError("a value is missing or not finite", where=name, found=f"sample {bad[0] + 1}")
    if np.any(np.diff(t) <= 0.0):
        place = int(np.argmax(np.diff(t) <= 0.0)) + 2
        raise FitError("the time does not increase", where=name, found=f"sample {place}")
    if stiffness is not None and not (math.isfinite(stiffness) and stiffness > 0.0):
        raise FitError(
            "the stiffness is not positive", where=name, found=stiffness, allowed="above 0"
        )
    if np.ptp(signal) == 0.0:
        raise FitError("the record never changes", where=name, hint="Is this the right channel?")
    return t, signal


def _estimates(p: DecayParameters, spread: Uncertainty, mass: float) -> dict[str, Estimate]:
    omega, ratio, friction = p.angular_frequency, p.damping_ratio, p.friction_deflection

    def propagate(value: float, *gradient: float) -> Estimate:
        return spread.propagate(value, np.array([*gradient, *[0.0] * (7 - len(gradient))]))

    return {
        "damping_ratio": at_least_zero(propagate(ratio, 0.0, 1.0)),
        "damping_coefficient": at_least_zero(
            propagate(2.0 * ratio * omega * mass, 2.0 * ratio * mass, 2.0 * omega * mass)
        ),
        "coulomb_force": at_least_zero(
            propagate(
                friction * mass * omega**2, 2.0 * friction * mass * omega, 0.0, mass * omega**2
            )
        ),
        "natural_frequency_hz": propagate(omega / (2.0 * math.pi), 1.0 / (2.0 * math.pi)),
        "quadratic_drag": at_least_zero(
            propagate(p.quadratic_drag * mass, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, mass)
        ),
        "equilibrium": propagate(p.offset, 0.0, 0.0, 0.0, 1.0),
        "stiffness": propagate(mass * omega**2, 2.0 * mass * omega),
    }


def _amplitudes(peaks: Peaks, parameters: DecayParameters, quantity: Quantity) -> Array:
    """Return the turning points as positive amplitudes, up to the first on the wrong side of the equilibrium."""
    away = peaks.value - parameters.offset
    if order_of(quantity) == 0:
        away[0] = parameters.release_deflection  # the fitted release is better than one sample
    return alternating(away)


def _naive_decrement(amplitudes: Array) -> Estimate:
    if len(amplitudes) < 2:
        return Estimate(math.inf)
    cycle = 0.5 * np.arange(len(amplitudes))
    if len(amplitudes) == 2:
        return Estimate(2.0 * math.log(amplitudes[0] / amplitudes[1]))
    coefficients, _, spread = linear_least_squares(
        np.column_stack([-cycle, np.ones_like(cycle)]), np.log(amplitudes)
    )
    return spread.estimates(coefficients)[0]


def _advice(
    result: DecayResult, spread: Uncertainty, step: float, stiffness: float | None, name: str
) -> list[Finding]:
    p, friction, cycles, motion = (
        result.parameters,
        result.coulomb_force,
        result.cycles,
        MOTIONS[result.motion],
    )
    findings: list[Finding] = []

    def add(code: str, value: float, /, **numbers: Any) -> None:
        findings.append(finding(code, name, value, **numbers))

    changed = (
        abs(result.decrements[-1] / result.decrements[0] - 1.0)
        if len(result.decrements) > 1
        else 0.0
    )
    if _is_clear(friction) and changed > _SAME:
        first, last = result.decrements[0], result.decrements[-1]
        estimates = {"damping": result.damping_coefficient.value, "friction": friction.value}
        units = {
            "damping_unit": unit_in_words(motion.damping),
            "force_unit": unit_in_words(motion.force),
        }
        add(
            "identify.decrement_changes",
            friction.value,
            first=first,
            last=last,
            **estimates,
            **units,
        )
    drag = result.quadratic_drag
    if p.friction_deflection == 0.0:
        add("identify.no_dry_friction", 0.0)
    if p.damping_ratio == 0.0:
        add("identify.no_viscous_damping", 0.0)
    if drag is not None and drag.value > 0.0:
        add("identify.quadratic_drag", drag.value, drag=drag.value, unit=unit_in_words(motion.drag))
    reach, begins = abs(p.release_deflection), abs(p.release_deflection) * p.angular_frequency**2
    is_far, begin = begins > _MOST_ACCELERATION, f"{reach:.3g} m and {begins / 9.81:.0f} g"
    if motion.name == "rotation":
        is_far, begin = reach > math.pi, motion.say(reach)
    if is_far:
        add("identify.decay_begins_far", reach, begin=begin)
    if cycles < 1.5:  # four turning points, one more than damping and friction need
        add("identify.decay_few_cycles", cycles, cycles=cycles)
    samples = 2.0 * math.pi / p.angular_frequency / step
    if samples < 20.0:  # the parabola of a turning point has three samples at most (`_parabola`)
        add("identify.few_samples_per_cycle", samples, samples=samples)
    if result.r2 < _EXPLAINED:
        add("identify.decay_explains_little", result.r2, share=result.r2)
    elif spread.correlation_time > _ALIKE_FOR and result.rms_residual > 1e-6 * abs(
        p.release_deflection
    ):
        add("identify.residuals_correlated", spread.correlation_time)
    if stiffness is not None and abs(result.stiffness.value / stiffness - 1.0) > _OFF:
        share = result.stiffness.value / stiffness - 1.0
        code = (
            "identify.stiffness_off"
            if motion.name == "rotation"
            else "identify.wheel_stiffness_off"
        )
        both = {"value": result.stiffness.value, "given": stiffness, "excess": share}
        add(code, share, inertia=motion.inertia_word, unit=unit_in_words(motion.stiffness), **both)
    return findings


# several runs ---------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class CombinedDecay(DecayEstimates):
    """Damping from several decays of the same system.

    Attributes
    ----------
    quadratic_drag : Estimate or None
        As in :class:`DecayResult`; None unless every run shows it.
    damping_ratio, damping_coefficient, coulomb_force, natural_frequency_hz, stiffness, logarithmic_decrement : Estimate
        As in :class:`DecayResult`, over all runs; the intervals include the scatter between runs.
    equilibrium : Estimate or None
        [m or rad]; None if a run has no equilibrium.
    cycles : float
        Sum over the runs [1].
    runs : int
        Number of decays.
    motion : {"translation", "rotation"}
        As in :class:`DecayResult`, of all runs.
    findings : tuple of Finding
        Findings of the runs, and about runs that contradict or copy each other.
    """

    cycles: Annotated[float, Shows("cycles", "1")]
    runs: Annotated[int, Shows("decays")]
    motion: MotionName
    findings: tuple[Finding, ...]


def combine_decays(results: Sequence[DecayResult]) -> CombinedDecay:
    """Combine several decays of the same system into one estimate per quantity; a single run is returned unchanged.

    Runs are weighted by their own variance plus the variance between runs (DerSimonian and Laird). The interval is that
    of Hartung and Knapp with (runs - 1) degrees of freedom, and never narrower than the runs' own errors imply.
    """
    if not results:
        raise FitError("no decays to combine", allowed="at least one")
    if len({result.motion for result in results}) > 1:
        raise FitError(
            "decays of a translation and of a rotation do not combine",
            found=", ".join(result.quantity for result in results),
            allowed="one of the two",
        )
    names = (
        "damping_ratio",
        "damping_coefficient",
        "coulomb_force",
        "natural_frequency_hz",
        "stiffness",
        "logarithmic_decrement",
    )
    combined = {name: combine([getattr(result, name) for result in results]) for name in names}
    for name in ("damping_ratio", "damping_coefficient", "coulomb_force"):
        combined[name] = at_least_zero(combined[name])
    centres = [result.equilibrium for result in results if result.equilibrium is not None]
    findings = [finding for result in results for finding in result.findings]
    frequencies = [result.natural_frequency_hz.value for result in results]
    if np.ptp(frequencies) > 0.05 * float(np.mean(frequencies)):  # stiffness differs by a tenth
        findings.append(
            finding(
                "identify.decay_frequencies_range",
                "decays",
                np.ptp(frequencies),
                least=min(frequencies),
                greatest=max(frequencies),
            )
        )
    copies = len(results) - len({result.parameters for result in results})
    if copies:
        findings.append(
            finding("identify.decay_copies", "decays", copies, copies=copies, runs=len(results))
        )
    drags = [result.quadratic_drag for result in results if result.quadratic_drag is not None]
    if drags and len(drags) < len(results):
        findings.append(
            finding(
                "identify.decay_drags_differ",
                "decays",
                len(drags),
                with_drag=len(drags),
                runs=len(results),
            )
        )
    return CombinedDecay(
        **combined,
        quadratic_drag=at_least_zero(combine(drags)) if len(drags) == len(results) else None,
        equilibrium=combine(centres) if len(centres) == len(results) else None,
        cycles=float(sum(result.cycles for result in results)),
        runs=len(results),
        motion=results[0].motion,
        findings=tuple(findings),
    )
