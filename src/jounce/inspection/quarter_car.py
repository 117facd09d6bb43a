"""The linear quarter car on a plate: response, steady states, and fit to the motion of a plate.

Each stretch of the record is transformed once. In its bins the force is the quarter car's response to the plate's
height plus a transient from the states at both ends: a polynomial in s over the characteristic polynomial (Pintelon and
Schoukens). The signals need neither start at rest nor be periodic. White force noise has equal weight in all bins.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import astuple, dataclass
from functools import cached_property, partial
from itertools import product

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.constants import GRAVITY
from jounce.core.errors import FitError
from jounce.core.types import Array, Complex
from jounce.kernel.call import Loop
from jounce.testers.plates import SteadyResponse, least, least_adhesion, tyre_rigidity


@dataclass(frozen=True)
class LinearQuarterCar:
    """Linear quarter car as seen by a plate under its wheel.

    Attributes
    ----------
    sprung_mass, unsprung_mass : float
        kg. A record yields the effective mass acting on the wheel, which may differ from the share of the car's mass
        that the wheel carries.
    spring_rate, damping_coefficient : float
        Suspension values at the wheel, N/m and N s/m.
    tyre_stiffness, tyre_damping_coefficient : float
        N/m and N s/m.
    """

    sprung_mass: float
    unsprung_mass: float
    spring_rate: float
    damping_coefficient: float
    tyre_stiffness: float
    tyre_damping_coefficient: float = 0.0

    @property
    def static_load(self) -> float:
        """Weight of sprung and unsprung mass, N, at 9.81 m/s^2."""
        return (self.sprung_mass + self.unsprung_mass) * GRAVITY


def force_response(corner: LinearQuarterCar, frequency: ArrayLike) -> Complex:
    """Return the dynamic tyre force over plate height of a wheel in permanent contact.

    Parameters
    ----------
    corner : LinearQuarterCar
        The quarter car.
    frequency : array_like, shape (n,)
        Hz, not negative.

    Returns
    -------
    ndarray of complex, shape (n,)
        (F - F_st) / z_plate in N/m; force on the tyre and height are positive upwards. The EGEA phase angle is 180
        degrees minus its angle, the EUSAMA adhesion 1 minus its magnitude times plate amplitude over static load.

    Examples
    --------
    >>> car = LinearQuarterCar(400.0, 40.0, 25e3, 1000.0, 200e3)
    >>> float(abs(force_response(car, [25.0])[0]).round(-2))
    250400.0
    """
    s = 2j * np.pi * np.asarray(frequency, dtype=float)
    with np.errstate(divide="ignore", invalid="ignore"):
        strut = corner.spring_rate + corner.damping_coefficient * s
        tyre = corner.tyre_stiffness + corner.tyre_damping_coefficient * s
        body = strut / (corner.sprung_mass * s * s + strut)
        wheel = 1.0 / (corner.unsprung_mass * s * s + strut * (1.0 - body) + tyre)
        return np.asarray(tyre - tyre * tyre * wheel)


def responses(parameters: Array, s: Complex) -> Complex:
    """Return the responses (m, n) in N/m of m quarter cars at ``s`` in 1/s (n,).

    Columns of the parameters (m, 6): unsprung mass, rate, damping, tyre stiffness, tyre damping, sprung mass, SI.
    """
    unsprung, rate, damping, stiffness, loss, sprung = (column[:, None] for column in parameters.T)
    strut, tyre, square = rate + damping * s, stiffness + loss * s, s * s
    hung = strut - strut * strut / (sprung * square + strut)
    return np.asarray(tyre - tyre * tyre / (unsprung * square + hung + tyre))


def road_poles(corner: LinearQuarterCar) -> Complex:
    """Return the poles with the plate at rest, as on the road, 1/s."""
    return _roots(road_polynomial(corner))


def road_polynomial(corner: LinearQuarterCar) -> Array:
    """Return the characteristic polynomial with the plate at rest, highest power first, SI."""
    ms, mu, k, c = (
        corner.sprung_mass,
        corner.unsprung_mass,
        corner.spring_rate,
        corner.damping_coefficient,
    )
    kt, ct = corner.tyre_stiffness, corner.tyre_damping_coefficient
    return np.array(
        [ms * mu, ms * (c + ct) + mu * c, ms * (k + kt) + mu * k + c * ct, c * kt + k * ct, k * kt]
    )


def rig_poles(
    corner: LinearQuarterCar,
    plate_mass: float,
    spring_rate: float,
    damping_coefficient: float = 0.0,
) -> Complex:
    """Return the poles on a sprung plate (kg, N/m, N s/m) with the exciter at rest, 1/s."""
    ms, mu, k, c = (
        corner.sprung_mass,
        corner.unsprung_mass,
        corner.spring_rate,
        corner.damping_coefficient,
    )
    tyre = np.array([corner.tyre_damping_coefficient, corner.tyre_stiffness])
    free = np.array(
        [ms * mu, (ms + mu) * c, (ms + mu) * k, 0.0, 0.0]
    )  # the car on a tyre without stiffness
    plate = np.array([plate_mass, damping_coefficient, spring_rate])
    alone = np.convolve(road_polynomial(corner), plate)
    together = np.convolve(tyre, free)
    alone[-together.size :] += together
    return _roots(alone)


def _roots(polynomial: Array) -> Complex:
    count = polynomial.size - 1
    companion = np.zeros((count, count))
    companion[0] = -polynomial[1:] / polynomial[0]
    companion[np.arange(1, count), np.arange(count - 1)] = 1.0
    return np.linalg.eigvals(companion).astype(complex)


def wheel_damping(poles: Complex) -> tuple[float, float]:
    """Return damping ratio (1) and natural frequency (Hz) of the wheel's mode, the second-lowest oscillatory mode.

    If only the body is overdamped, its poles are slow and the wheel's mode is the lowest remaining one. A fast real
    pole means an overdamped wheel, with ratio 1.
    """
    upper = sorted(poles[poles.imag > 1e-6 * np.abs(poles)], key=abs)
    real = np.sort(np.abs(poles[np.abs(poles.imag) <= 1e-6 * np.abs(poles)].real))
    if len(upper) == len(poles) // 2:
        pole = upper[1]
    elif not upper or real[-1] > abs(upper[0]):
        return 1.0, float(real[-1]) / (2.0 * math.pi)
    else:
        pole = upper[0]
    return float(-pole.real / abs(pole)), float(abs(pole)) / (2.0 * math.pi)


def body_damping(poles: Complex) -> float:
    """Return the damping ratio (1) of the body, the slowest mode; 1 if that mode does not oscillate.

    Tyres hardly damp this mode, so a value near zero means that the damper has no effect.
    """
    slowest = poles[int(np.argmin(np.abs(poles)))]
    return 1.0 if abs(slowest.imag) <= 1e-6 * abs(slowest) else float(-slowest.real / abs(slowest))


TRANSIENT = (
    5  # powers of s from 0 to 4 over the characteristic polynomial, which is of fourth order
)
_equations = Loop("quarter_car")


def normal_equations(
    parameters: Array, speed: Array, height: Complex, force: Complex
) -> tuple[float, Array, Array, Complex]:
    """Compare a quarter car with the bins of a section after projecting out the end transients.

    Parameters (6,): unsprung mass, spring rate, damping, tyre stiffness, tyre damping, sprung mass, SI; angular
    frequencies (n,), ascending, rad/s; plate height (m) and dynamic tyre force (N) in these bins, equally scaled.
    Returns the residual sum of squares, J' J (6, 6) and J' r (6,) of the Gauss-Newton step, and the residual (n,) in N
    after quarter car and transients.
    """
    n = speed.size
    basis, transient, gap = np.empty((TRANSIENT, 2 * n)), np.zeros(2 * n), np.empty(2 * n)
    slopes, falls = np.empty((_FREE, 2 * n)), np.empty((_FREE, 2 * n))
    normal, right = np.empty((_FREE, _FREE)), np.empty(_FREE)
    bins = (np.ascontiguousarray(values) for values in (speed, height, force))
    _equations(
        np.ascontiguousarray(parameters), *bins, basis, transient, slopes, falls, gap, normal, right
    )
    return float(gap @ gap), normal, right, gap[:n] + 1j * gap[n:]


_FREE = 6  # free parameters of the quarter car
_TIED = np.eye(_FREE, 5)
_TIED[5, 0] = -1.0  # sprung and unsprung mass together carry the static load
_SUM = np.array([1.0, 0.0, 0.0, 0.0, 0.0, 1.0])
_SCALE = np.array([1.0, 1e3, 10.0, 1e3, 50.0, 10.0])  # minimum scales for judging step sizes, SI
_MASS_SPREAD = (
    0.2  # share of the carried mass: the effective mass acting on a wheel differs from it
)
_MOST_STEPS, _MORE_STEPS = (
    40,
    12,
)  # with the masses tied to the load, then with all six parameters
_ROUGH_STEP, _SMALLEST_STEP = (
    2e-2,
    1e-4,
)  # relative changes that end these two searches; the first only provides a start
_FEWEST_BINS = (
    24  # spectral lines: 48 numbers for six quarter-car parameters and those of the transient
)
_GRADIENT_STEP = 1e-5  # relative
_START_LINES = 60  # spectral lines used to compare starts
POOR, _TRIED = 0.97, 6
"""Explained share of the force (1) below which a fit is doubtful and more starts are tried, and their number. Kinked
dampers reach 0.98."""
_SHARES, _RATIOS = (
    (0.05, 0.08, 0.12, 0.18),
    (0.005, 0.05, 0.2),
)  # unsprung masses and damping ratios of starts
_STIFFNESSES, _RATES = (
    (8e4, 1.2e5, 1.7e5, 2.4e5, 3.4e5),
    (30.0, 65.0, 150.0, 400.0, 1100.0),
)  # N/m, N/m per kg
TYRES = (5e4, 1.2e6)
"""Range of plausible tyre stiffness, N/m."""
_TYRE_DAMPING, _TYRE_DAMPING_SPREAD = (
    50.0,
    60.0,
)  # N s/m: prior that applies if a record contains little information


@dataclass(frozen=True)
class Stretch:
    """Bins of one section of a record."""

    s: Complex  # (n,): laplace variable of the bins, 1/s
    height: Complex  # (n,): sum over the samples of plate height, m
    force: Complex  # (n,): sum over the samples of dynamic tyre force, N
    samples: int


@dataclass(frozen=True)
class ResponseFit:
    """Quarter car fitted to a record."""

    corner: LinearQuarterCar  # fitted masses, rates and dampings
    # (6, 6): covariance of unsprung mass, spring rate, damping, tyre stiffness, tyre damping and sprung mass, SI
    covariance: Array
    # standard deviation of the residual, N per sample, between the lowest and the highest frequency
    noise: float
    explained: float  # share (1) of the force in these bins that the model explains
    # delay (s) of the force after the height if significant; otherwise 0
    delay: float = 0.0

    def spread(self, quantity: Callable[[LinearQuarterCar], float]) -> float:
        """Return the standard error of a quantity computed from the corner, in its unit."""
        return self._spread(np.array([quantity(_corner(near)) for near in self._near]))

    def spread_at(self, frequency: float, quantity: Callable[[Complex], Array]) -> float:
        """Return the standard error of a quantity computed from the response (N/m) at a frequency in Hz, in its unit.

        ``quantity`` is called with an array of responses (m,).
        """
        return self._spread(
            quantity(responses(self._near, np.array([2j * np.pi * frequency]))[:, 0])
        )

    @cached_property
    def _near(self) -> Array:
        """Return the parameters, and one copy per parameter with that parameter slightly increased, shape (7, 6)."""
        here = _parameters(self.corner)
        steps = np.maximum(np.abs(here), _SCALE) * _GRADIENT_STEP
        return np.asarray(here + np.vstack([np.zeros(_FREE), np.diag(steps)]))

    def _spread(self, values: Array) -> float:
        slope = (values[1:] - values[0]) / np.diag(self._near[1:] - self._near[0])
        return math.sqrt(max(float(slope @ self.covariance @ slope), 0.0))


def stretch_of(height: Array, force: Array, sample_rate: float, low: float, high: float) -> Stretch:
    """Transform a section of plate height (n,) in m and dynamic tyre force (n,) in N, sampled at a rate in Hz.

    Bins outside ``low`` to ``high`` Hz are omitted; first and last sample have weight 0.5 (trapezoidal sums).
    """
    from scipy.fft import next_fast_len, rfft

    count = height.size - 1
    while next_fast_len(count, real=True) != count:
        count -= 1
    signals = np.stack([height[: count + 1], force[: count + 1]])
    signals = signals - signals.mean(axis=1, keepdims=True)
    signals[:, 0] = 0.5 * (signals[:, 0] + signals[:, -1])
    spectra = rfft(signals[:, :-1], axis=1)
    first = max(1, math.ceil(low * count / sample_rate))
    last = min(spectra.shape[1] - 1, math.floor(high * count / sample_rate))
    lines = slice(first, last + 1)
    s = 2j * np.pi * np.arange(first, last + 1) * (sample_rate / count)
    return Stretch(s, spectra[0, lines], spectra[1, lines], count)


def fit_response(
    stretches: Sequence[Stretch], static_load: float, *, where: str = "wheel"
) -> ResponseFit:
    """Fit a quarter car to sections of one record without lift-off; its weight is the static load (N).

    A least-squares estimate with its covariance. Priors: the effective mass is within 20 % of the carried mass, and
    the tyre damping, which has little effect below the wheel's resonance, is (50 +- 60) N s/m. Both priors are weighed
    against the noise. Raises FitError if the signal is too weak or no quarter car resembles it.
    """
    bins = sum(stretch.s.size for stretch in stretches)
    if bins < _FEWEST_BINS:
        raise FitError(
            "the signal is too small to fit a quarter car",
            where=where,
            found=f"{bins} spectral lines",
        )
    mass = static_load / GRAVITY
    scale = 1.0 / math.sqrt(sum(stretch.samples for stretch in stretches) / len(stretches))
    parts = [
        Stretch(stretch.s, stretch.height * scale, stretch.force * scale, stretch.samples)
        for stretch in stretches
    ]
    fit = _fit_from(parts, _start(parts, mass), mass)
    if _merit(fit) < POOR:
        fit = max(
            [fit, *(_fit_from(parts, start, mass) for start in _more_starts(parts, mass))],
            key=_merit,
        )
    return fit


def _merit(fit: ResponseFit) -> float:
    """Return the explained share (1) of the force, negative for an implausible tyre."""
    return fit.explained if TYRES[0] < fit.corner.tyre_stiffness < TYRES[1] else fit.explained - 1.0


def _fit_from(parts: Sequence[Stretch], here: Array, mass: float) -> ResponseFit:
    """Fit the parameters from a start, first with the total mass (kg) fixed to the static load."""
    cost, normal, right = _system(parts, here)
    damping = 1e-3
    for _ in range(_MOST_STEPS):
        step = _TIED @ _solve(_TIED.T @ normal @ _TIED, _TIED.T @ right, damping)
        tried = _within(here + step, here, mass)
        new_cost, new_normal, new_right = _system(parts, tried)
        if new_cost <= cost:
            moved = np.max(np.abs(tried - here) / np.maximum(np.abs(tried), _SCALE))
            here, cost, normal, right = tried, new_cost, new_normal, new_right
            damping *= 0.1
            if moved < _ROUGH_STEP:
                break
        else:
            damping = max(10.0 * damping, 1e-6)
            if damping > 1e8:  # steps are at rounding level
                break
    return _release_masses(parts, here, mass)


def _release_masses(parts: Sequence[Stretch], here: Array, mass: float) -> ResponseFit:
    """Free the masses from the static load, weighing the prior against the noise."""
    freedom = max(2 * sum(stretch.s.size for stretch in parts) - _FREE - TRANSIENT * len(parts), 1)
    cost, normal, right = _system(parts, here)
    damping = 1e-9
    for _ in range(_MORE_STEPS):
        variance = cost / freedom
        known, pull = _prior_equations(here, mass, variance)
        tried = _within(here + _solve(normal + known, right + pull, damping), here, mass)
        new = _system(parts, tried)
        if new[0] + _surprise(tried, mass, variance) > cost + _surprise(here, mass, variance):
            damping = max(100.0 * damping, 1e-5)
            continue
        moved = np.max(np.abs(tried - here) / np.maximum(np.abs(tried), _SCALE))
        here, (cost, normal, right) = tried, new
        damping *= 0.1
        if moved < _SMALLEST_STEP:
            break
    known, _ = _prior_equations(here, mass, cost / freedom)
    size = np.sqrt(np.diag(normal + known))
    size = np.where(size > 0.0, size, 1.0)
    covariance = np.linalg.pinv(
        (normal + known) / np.outer(size, size), rcond=1e-15, hermitian=True
    )
    power = sum(float(np.sum(np.abs(stretch.force) ** 2)) for stretch in parts)
    return ResponseFit(
        corner=_corner(here),
        covariance=covariance / np.outer(size, size) * (cost / freedom),
        noise=math.sqrt(2.0 * cost / freedom),
        explained=1.0 - cost / power if power > 0.0 else 0.0,
    )


def _prior_equations(here: Array, mass: float, variance: float) -> tuple[Array, Array]:
    """Return normal matrix and right-hand side of the prior on tyre damping and total mass (kg)."""
    of_mass = variance / (_MASS_SPREAD * mass) ** 2
    known = of_mass * np.outer(_SUM, _SUM)
    known[4, 4] += variance / _TYRE_DAMPING_SPREAD**2
    pull = of_mass * (mass - _SUM @ here) * _SUM
    pull[4] += variance / _TYRE_DAMPING_SPREAD**2 * (_TYRE_DAMPING - here[4])
    return known, pull


def _surprise(here: Array, mass: float, variance: float) -> float:
    """Return the sum of squared deviations of the parameters from the prior."""
    gap = (
        (mass - float(_SUM @ here)) / (_MASS_SPREAD * mass),
        (_TYRE_DAMPING - here[4]) / _TYRE_DAMPING_SPREAD,
    )
    return variance * float(gap[0] ** 2 + gap[1] ** 2)


def _corner(parameters: Array) -> LinearQuarterCar:
    *others, sprung_mass = map(float, parameters)
    return LinearQuarterCar(sprung_mass, *others)


def delay_of(fit: ResponseFit, stretches: Sequence[Stretch], plate_mass: float = 0.0) -> float:
    """Estimate the delay (s) of the measured force after the height, negative if earlier; 0 if uncertain.

    The inertia of ``plate_mass`` (kg) was subtracted from the force using the height. The delay is estimated to first
    order together with all parameters. It is accepted if it explains about half of the residual, or if the fit needs
    negative tyre damping; it explains at most a third of residuals from dry friction or kinked damper curves.
    """
    here = _parameters(fit.corner)
    steps = np.maximum(np.abs(here), _SCALE) * _DELAY_STEP
    left, slopes, by_delay = [], [], []
    for stretch in stretches:
        scale = 1.0 / math.sqrt(stretch.samples)
        height, force = stretch.height * scale, stretch.force * scale
        speed = stretch.s.imag
        gap = normal_equations(here, speed, height, force)[3]
        near = [normal_equations(place, speed, height, force)[3] for place in here + np.diag(steps)]
        earlier = force + _PER_MILLISECOND * stretch.s * (
            force + plate_mass * stretch.s**2 * height
        )
        left.append(gap)
        slopes.append(
            np.stack(
                [(other - gap) / step for other, step in zip(near, steps, strict=True)], axis=1
            )
        )
        by_delay.append(
            (normal_equations(here, speed, height, earlier)[3] - gap) / _PER_MILLISECOND
        )
    rest, of_delay = (_both_parts(np.concatenate(parts)) for parts in (left, by_delay))
    rows = np.concatenate(slopes)
    held = np.concatenate([rows.real, rows.imag])
    held /= np.linalg.norm(held, axis=0)
    rest, of_delay = (
        part - held @ np.linalg.lstsq(held, part, rcond=1e-12)[0] for part in (rest, of_delay)
    )
    power = float(of_delay @ of_delay)
    delay = -float(of_delay @ rest) / power
    after = rest + delay * of_delay
    error = math.sqrt(float(after @ after) / rest.size / power)
    gain = 1.0 - float(after @ after) / max(float(rest @ rest), 1e-300)
    loss = fit.corner.tyre_damping_coefficient
    drives = -loss > _DRIVES * fit.corner.tyre_stiffness and -loss > _SURELY * math.sqrt(
        float(fit.covariance[4, 4])
    )
    sure = abs(delay) > max(_SMALL_DELAY, _SURELY * error) and (
        gain > _OF_LEFT or (drives and delay > 0.0)
    )
    return delay if sure else 0.0


_DELAY_STEP, _PER_MILLISECOND = 1e-4, 1e-3  # relative, and s: steps of finite differences
_SMALL_DELAY = 0.8e-3  # s: changes the phase angle by 3 degrees at 10 Hz
_OF_LEFT, _SURELY = (
    0.45,
    3.0,
)  # share of the residual (1): dry friction and kinks give a third; standard errors
_DRIVES = 0.5e-3  # s: ratio of negative tyre damping to stiffness


def _both_parts(values: Complex) -> Array:
    return np.concatenate([values.real, values.imag])


def _parameters(corner: LinearQuarterCar) -> Array:
    sprung_mass, *others = astuple(corner)
    return np.array([*others, sprung_mass])


def _within(parameters: Array, before: Array, mass: float) -> Array:
    """Halve the way to a bound that the parameters would cross."""
    low = np.array([1e-3 * mass, 0.0, 0.0, 1e3, -2e3, 0.2 * mass])
    high = np.array([0.6 * mass, 1e7, 1e6, 1e8, 2e4, 3.0 * mass])
    inside = np.where(parameters < low, 0.5 * (before + low), parameters)
    return np.where(inside > high, 0.5 * (before + high), inside)


def _start(parts: Sequence[Stretch], mass: float) -> Array:
    """Return the best of a grid of quarter cars."""
    tyre = _tyre_stiffness(parts)
    grid = []
    for share, ratio, factor in product((0.06, 0.1, 0.16), (0.05, 0.15, 0.4), (0.8, 1.0, 1.25)):
        unsprung, sprung = share * mass, (1.0 - share) * mass
        damping = ratio * 2.0 * math.sqrt(tyre * share * mass)
        grid.append((unsprung, sprung * 65.0, damping, tyre * factor, 0.0, sprung))
    candidates = np.array(grid)
    misfit = np.zeros(len(grid))
    for stretch in parts:
        few = slice(None, None, max(stretch.s.size // _START_LINES, 1))
        misfit += np.sum(
            np.abs(stretch.force[few] - responses(candidates, stretch.s[few]) * stretch.height[few])
            ** 2,
            axis=1,
        )
    return np.asarray(candidates[int(np.argmin(misfit))])


def _more_starts(parts: Sequence[Stretch], mass: float) -> list[Array]:
    """Return the best of a wider grid, with transients projected out: an undamped wheel oscillates for long."""
    grid = []
    for share, ratio, tyre, rate in product(_SHARES, _RATIOS, _STIFFNESSES, _RATES):
        unsprung, sprung = share * mass, (1.0 - share) * mass
        damping = ratio * 2.0 * math.sqrt(tyre * unsprung)
        grid.append(np.array([unsprung, sprung * rate, damping, tyre, 0.0, sprung]))
    costs = [_system(parts, start)[0] for start in grid]
    return [grid[i] for i in np.argsort(costs, kind="stable")[:_TRIED]]


def _tyre_stiffness(parts: Sequence[Stretch]) -> float:
    """Estimate the tyre stiffness (N/m) from the highest frequencies, where the wheel hardly moves."""
    highest = max(parts, key=lambda part: float(part.s[-1].imag))
    # As a start value, the highest 15 % of the lines suffice; the wheel moves least there.
    top = highest.s.imag > 0.85 * highest.s[-1].imag
    drive = float(np.sum(np.abs(highest.height[top]) ** 2))
    gain = (
        abs(complex(np.sum(highest.force[top] * np.conj(highest.height[top])))) / drive
        if drive > 0.0
        else 2e5
    )
    return min(max(0.8 * gain, 6e4), 8e5)


def _system(parts: Sequence[Stretch], parameters: Array) -> tuple[float, Array, Array]:
    """Return sum of squares, normal matrix and right-hand side for the six parameters, transients projected out."""
    cost, normal, right = 0.0, np.zeros((_FREE, _FREE)), np.zeros(_FREE)
    for stretch in parts:
        squares, of_part, pull, _ = normal_equations(
            parameters, stretch.s.imag, stretch.height, stretch.force
        )
        cost += squares
        normal += of_part
        right += pull
    return cost, normal, right


def _solve(normal: Array, right: Array, damping: float) -> Array:
    size = np.sqrt(np.diag(normal))
    size = np.where(size > 0.0, size, 1.0)
    scaled = normal / np.outer(size, size) + damping * np.eye(right.size)
    return np.asarray(np.linalg.solve(scaled, right / size) / size)


def predicted_force(fit: ResponseFit, stretch: Stretch) -> Complex:
    """Predict the dynamic force (N) in the bins of a section, with the best-fitting transients."""
    left = normal_equations(_parameters(fit.corner), stretch.s.imag, stretch.height, stretch.force)[
        3
    ]
    return np.asarray(stretch.force - left)


Response = Callable[[ArrayLike], Complex]
_AT_END = 0.005  # Hz: half the 0.01 Hz step of the search for minima


@dataclass(frozen=True)
class SteadyState:
    """Inspection values from steady-state responses.

    Attributes
    ----------
    adhesion : float
        Minimum over static tyre force (1); 0 if the linear force would be negative.
    adhesion_frequency_hz : float
        Frequency of the minimum force, Hz.
    lift_off : bool
        Whether the linear force would be negative.
    phase_angle_min_deg, phase_frequency_hz : float
        Minimum phase angle in degrees within the band, ends included, and its frequency (Hz).
    phase_at_end : bool
        Whether the minimum is at an end of the band.
    relative_force_amplitude : float
        Maximum force amplitude over static load (1).
    tyre_rigidity : float
        EGEA rigidity from the force amplitude at the highest frequency, N/m.
    """

    adhesion: float
    adhesion_frequency_hz: float
    lift_off: bool
    phase_angle_min_deg: float
    phase_frequency_hz: float
    phase_at_end: bool
    relative_force_amplitude: float
    tyre_rigidity: float


def steady_state(
    response: Response | LinearQuarterCar,
    static_load: float | None = None,
    *,
    amplitude: float = 3e-3,
    highest: float = 25.0,
    band: tuple[float, float] = (6.0, 18.0),
) -> SteadyState:
    """Find adhesion, minimum phase angle and rigidity of a linear wheel on a rigid plate.

    Parameters
    ----------
    response : callable or LinearQuarterCar
        Dynamic tyre force over plate height (N/m, complex) at frequencies (Hz); or the quarter car.
    static_load : float, optional
        N; by default the corner's.
    amplitude : float
        Amplitude of the plate, m.
    highest : float
        Highest frequency of the test, Hz. It affects the result, because the force of a damped tyre grows with
        frequency.
    band : (float, float)
        Search band of the phase angle, Hz.

    Returns
    -------
    SteadyState
        Values with frequencies to 0.01 Hz.

    Examples
    --------
    >>> found = steady_state(LinearQuarterCar(400.0, 40.0, 25e3, 1000.0, 200e3))
    >>> round(100.0 * found.adhesion, 2), round(found.phase_angle_min_deg, 2), round(found.phase_frequency_hz, 2)
    (60.25, 57.27, 7.76)
    """
    force: Response = (
        partial(force_response, response) if isinstance(response, LinearQuarterCar) else response
    )
    own = response.static_load if isinstance(response, LinearQuarterCar) else 0.0
    load = own if static_load is None else static_load

    def answer(frequency: Array) -> SteadyResponse:
        return SteadyResponse(
            frequency, force(frequency), np.ones(frequency.size, complex), load, amplitude
        )

    adhesion, peak = least_adhesion(answer, highest)
    angle, at = least(lambda f: answer(f).phase_angle, *band)
    return SteadyState(
        adhesion=max(0.0, adhesion),
        adhesion_frequency_hz=peak,
        lift_off=adhesion < 0.0,
        phase_angle_min_deg=float(np.degrees(angle)),
        phase_frequency_hz=at,
        phase_at_end=min(at - band[0], band[1] - at) < _AT_END,
        relative_force_amplitude=1.0 - adhesion,
        tyre_rigidity=tyre_rigidity(
            float(answer(np.array([highest])).force_amplitude[0]), amplitude
        ),
    )
