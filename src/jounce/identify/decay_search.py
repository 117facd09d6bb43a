"""The search for the decay that fits a record: where to start, how to descend, where sticking hides other minima."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.identify.decay_peaks import Peaks, ratio_from_decrement, regress_peaks
from jounce.identify.decay_response import DecayParameters, Quantity, decay_response
from jounce.identify.regression import Uncertainty, uncertainty


def _start(peaks: Peaks, quantity: Quantity, ratio: float, friction: float, centre: float) -> Array:
    """Parameters as a vector, from damping ratio and friction (unit of the record) of the turning points."""
    ratio = float(np.clip(ratio, 0.002, 0.9))
    damped = math.pi / peaks.half_period()
    omega = damped / math.sqrt(1.0 - ratio**2)
    top = float(peaks.value[0]) - centre
    if quantity == "displacement":
        return np.array([omega, ratio, friction, centre, float(peaks.time[0]) - 0.1 / omega, top])
    if quantity == "velocity":
        late = math.acos(ratio) / damped
        factor = math.exp(-ratio * omega * late) * omega
        deflection, begin = -top / factor, float(peaks.time[0]) - late
    else:
        factor, begin = omega**2, float(peaks.time[0]) - 0.1 / omega
        deflection = -top / factor
    shifted = friction / factor
    return np.array([omega, ratio, shifted, centre, begin, deflection + shifted * math.copysign(1.0, deflection)])


def _starts(peaks: Peaks, quantity: Quantity) -> list[Array]:
    """Start vectors: the regression of the turning points, then all mixtures of viscous damping and dry friction."""
    guess = regress_peaks(peaks)
    swing = np.abs(np.diff(peaks.value))
    naive = ratio_from_decrement(max(1e-3, 2.0 * math.log(swing[0] / swing[1])))
    dry = float(swing[0] - swing[1]) / 4.0
    centre = guess.equilibrium if quantity == "displacement" else 0.0
    pairs = [(guess.damping_ratio, guess.friction_deflection)]
    pairs += [((1.0 - share) * naive, share * dry) for share in (0.0, 0.25, 0.5, 0.75, 1.0)]
    starts = [_start(peaks, quantity, ratio, friction, centre) for ratio, friction in pairs]
    if quantity == "acceleration":  # its largest value may be just before a turning point: count from the one before
        starts += [_one_half_earlier(start) for start in starts]
    return starts


def _early_end(peaks: Peaks) -> float:
    """Time until which the swings are still above a fifth of the first, at least three half cycles [s]."""
    swing = np.abs(np.diff(peaks.value))
    small = np.flatnonzero(swing < 0.2 * swing[0])
    index = max(3, int(small[0]) if len(small) else len(swing))
    return float(peaks.time[min(index, len(swing))])


def _along_the_valley(start: Array, share: float) -> Array:
    """Exchange dry friction for viscous damping so that the mean loss of amplitude stays."""
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


def _fit(t: Array, signal: Array, starts: list[Array], quantity: Quantity) -> tuple[Array, Uncertainty, Array]:
    """Nonlinear least squares from several starts; the best one's parameters, uncertainty and residual."""
    reach = float(np.ptp(signal))
    best = None
    for start in starts:
        found = _descend(t, signal / reach, start, quantity, reach)
        if best is None or found[0].cost < best[0].cost * (1.0 - 1e-9):
            best = found
    assert best is not None
    solution, scale = best
    residual, jacobian = -reach * solution.fun, reach * solution.jac / scale
    if quantity == "acceleration":
        jacobian = jacobian * _off_jumps(t, _unpack(solution.x * scale))[:, None]
    return solution.x * scale, uncertainty(jacobian, residual), residual


def _off_jumps(t: Array, parameters: DecayParameters) -> Array:
    """0 at samples next to a turning point, where friction makes the acceleration jump, 1 elsewhere."""
    damped = parameters.angular_frequency * math.sqrt(1.0 - parameters.damping_ratio**2)
    phase = (t - parameters.release_time) * damped / math.pi
    return (np.abs(phase - np.round(phase)) > 0.6 * float(np.median(np.diff(phase)))).astype(float)


def _descend(t: Array, target: Array, start: Array, quantity: Quantity, reach: float) -> tuple[Any, Array]:
    """One descent in scaled parameters; SciPy's solution and the scales."""
    from scipy.optimize import least_squares

    size = abs(start[5])
    scale = np.array([start[0], 0.1, 0.02 * size, reach, 1.0 / start[0], size])
    low = np.array([0.3 * start[0], -0.2, -size, -np.inf, t[0] - 6.0 / start[0], -np.inf]) / scale
    high = np.array([3.0 * start[0], 0.97, size, np.inf, t[0] + 3.0 / start[0], np.inf]) / scale

    def misfit(scaled: Array) -> Array:
        return decay_response(t, _unpack(scaled * scale), quantity) / reach - target

    begin = np.clip(start / scale, low + 1e-9, high - 1e-9)
    solution = least_squares(
        misfit, begin, bounds=(low, high), jac="3-point", xtol=1e-11, ftol=1e-11, gtol=1e-11, max_nfev=60
    )
    return solution, scale


def search_decay(
    t: Array, signal: Array, peaks: Peaks, quantity: Quantity, name: str, findings: list[Finding]
) -> tuple[DecayParameters, Uncertainty, Array]:
    """Fit the response; leave the rest out when the mass does not rest where sliding friction would have stopped it.

    Parameters
    ----------
    t, signal : array (n,)
        Times [s] from the release on, and the record, unit of ``quantity``.
    peaks : Peaks
        Its turning points.
    quantity : {"displacement", "velocity", "acceleration"}
        What the record holds.
    name : str
        Place of findings.
    findings : list of Finding
        Extended when the rest was left out.

    Returns
    -------
    parameters : DecayParameters
        The best fit.
    spread : Uncertainty
        In the order of ``DecayParameters``.
    residual : array (n,)
        Measured minus fitted; NaN where the record was left out.
    """
    early = t <= _early_end(peaks)  # far from sticking the misfit has one minimum; each way of sticking has its own
    starts = [_fit(t[early], signal[early], _starts(peaks, quantity), quantity)[0]]
    starts += [_along_the_valley(starts[0], share) for share in (-0.15, -0.05, 0.05, 0.15)]
    values, spread, residual = _fit(t, signal, starts, quantity)
    rest = _at_rest(t, signal, peaks)
    if quantity != "displacement" or np.count_nonzero(rest) < 10:
        return _unpack(values), spread, residual
    moving, (alone, alone_spread, alone_residual) = ~rest, _fit(t[~rest], signal[~rest], [starts[0], values], quantity)
    gap, doubt = _rest_gap(t[rest], signal[rest], alone, alone_spread)
    if abs(gap) < max(4.0 * doubt, 3.0 * float(alone_residual.std()), 0.05 * abs(alone[2])):
        return _unpack(values), spread, residual
    text = (
        f"the mass comes to rest {1e3 * gap:.3g} mm from where sliding friction would have stopped it: the friction at "
        "rest is another one; the rest was left out of the fit."
    )
    findings.append(Finding(name, "note", text, gap))
    return _unpack(alone), alone_spread, np.where(moving, signal - decay_response(t, _unpack(alone), quantity), np.nan)


def _at_rest(t: Array, signal: Array, peaks: Peaks) -> NDArray[np.bool_]:
    """Mark the samples at the end during which nothing moves."""
    tail = signal[-max(5, len(signal) // 20) :]
    still = max(4.0 * float(tail.std()), 1e-3 * float(np.ptp(signal)))
    left = np.flatnonzero(np.abs(signal - np.median(tail)) > still)
    begin = int(left[-1]) + 1 if len(left) else 0
    marks = np.arange(len(t)) >= begin
    long_enough = t[-1] - t[min(begin, len(t) - 1)] > peaks.half_period()
    return marks if long_enough else np.zeros(len(t), bool)


def _rest_gap(t: Array, signal: Array, values: Array, spread: Uncertainty) -> tuple[float, float]:
    """Mean distance of the rest from where the response ends, and the standard error of that end."""

    def end(point: Array) -> float:
        return float(decay_response(t, _unpack(point), "displacement").mean())

    gradient = np.zeros(len(values))
    for index, value in enumerate(values):
        step = np.zeros(len(values))
        step[index] = 1e-6 * max(abs(value), 1e-3 * abs(values[5]))
        gradient[index] = (end(values + step) - end(values - step)) / (2.0 * step[index])
    return float(signal.mean()) - end(values), spread.derived(0.0, gradient).standard_error or 0.0
