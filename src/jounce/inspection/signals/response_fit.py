"""Quarter car from the motion of a plate and the force on it, whatever moves the plate.

Every stretch of the record is transformed once. In its bins the force is the response of a quarter car to the plate's
height, and what the stretch began and ended with: a polynomial in s over the characteristic polynomial (Pintelon and
Schoukens), so nothing has to be at rest or periodic. White noise of the force has the same weight in every bin.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from jounce.core.constants import GRAVITY
from jounce.core.errors import FitError
from jounce.core.types import Array
from jounce.inspection.signals.normal_equations import TRANSIENT, normal_equations
from jounce.inspection.signals.response import Corner, responses

Complex = NDArray[np.complex128]
_FREE = 6
_TIED = np.eye(_FREE, 5)
_TIED[5, 0] = -1.0  # sprung and unsprung mass together carry the static load
_SUM = np.array([1.0, 0.0, 0.0, 0.0, 0.0, 1.0])
_SCALE = np.array([1.0, 1e3, 10.0, 1e3, 50.0, 10.0])
_MASS_SPREAD = 0.2
_MOST_STEPS = 40
_ROUGH_STEP, _SMALLEST_STEP = 2e-2, 1e-4
_FEWEST_BINS = 24
_GRADIENT_STEP = 1e-5
_MORE_STEPS = 12
_START_LINES = 60
_TYRE_DAMPING, _TYRE_DAMPING_SPREAD = 50.0, 60.0  # N s/m: what a record with little to say falls back on


@dataclass(frozen=True)
class Stretch:
    """Bins of one stretch of a record.

    Attributes
    ----------
    s : ndarray of complex, shape (n,)
        Laplace variable of the bins, 1/s.
    height, force : ndarray of complex, shape (n,)
        Sums over the samples of plate height (m) and dynamic tyre force (N).
    samples : int
        Of the stretch.
    """

    s: Complex
    height: Complex
    force: Complex
    samples: int


@dataclass(frozen=True)
class ResponseFit:
    """Quarter car fitted to a record.

    Attributes
    ----------
    corner : Corner
        Fitted masses, rates and dampings.
    covariance : ndarray, shape (6, 6)
        Of unsprung mass, spring rate, damping, tyre stiffness, tyre damping and sprung mass, SI.
    noise : float
        Standard deviation of what the model leaves, N per sample, between the lowest and the highest frequency.
    explained : float
        Share (1) of the force in these bins that the model explains.
    """

    corner: Corner
    covariance: Array
    noise: float
    explained: float

    def spread(self, quantity: Callable[[Corner], float]) -> float:
        """Standard error of a number that follows from the corner, in the number's unit."""
        return self._spread(np.array([quantity(_corner(near)) for near in self._near]))

    def spread_at(self, frequency: float, quantity: Callable[[Complex], Array]) -> float:
        """Standard error of a number that follows from the response (N/m) at a frequency in Hz, in its unit.

        The quantity is asked for several responses (m,) at once.
        """
        return self._spread(quantity(responses(self._near, np.array([2j * np.pi * frequency]))[:, 0]))

    @cached_property
    def _near(self) -> Array:
        """The parameters, and for each of them a copy in which it is a little greater, shape (7, 6)."""
        here = _parameters(self.corner)
        steps = np.maximum(np.abs(here), _SCALE) * _GRADIENT_STEP
        return np.asarray(here + np.vstack([np.zeros(_FREE), np.diag(steps)]))

    def _spread(self, values: Array) -> float:
        slope = (values[1:] - values[0]) / np.diag(self._near[1:] - self._near[0])
        return math.sqrt(max(float(slope @ self.covariance @ slope), 0.0))


def stretch_of(height: Array, force: Array, sample_rate: float, low: float, high: float) -> Stretch:
    """Transform a stretch of a record.

    Parameters
    ----------
    height, force : ndarray, shape (n,)
        Plate height (m) and dynamic tyre force (N).
    sample_rate : float
        Hz.
    low, high : float
        Hz; bins outside are left out.

    Returns
    -------
    Stretch
        Heights and forces with half weight for the first and the last sample (trapezoidal sums).
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
    kept = slice(first, last + 1)
    s = 2j * np.pi * np.arange(first, last + 1) * (sample_rate / count)
    return Stretch(s, spectra[0, kept], spectra[1, kept], count)


def fit_response(stretches: Sequence[Stretch], static_load: float, *, where: str = "wheel") -> ResponseFit:
    """Fit a quarter car to stretches of a record.

    Parameters
    ----------
    stretches : sequence of Stretch
        Parts of one record without lift-off.
    static_load : float
        N; says what sum of the masses to expect.
    where : str
        Place named in errors.

    Returns
    -------
    ResponseFit
        Least-squares estimate with its covariance. The mass that acts on the wheel is expected within 20 % of what the
        plate carries, and the damping of the tyre, which hardly shows below the resonance of the wheel, at
        (50 +- 60) N s/m; both count only as far as the noise leaves them open.

    Raises
    ------
    FitError
        When there is too little signal, or no quarter car resembles it.
    """
    bins = sum(one.s.size for one in stretches)
    if bins < _FEWEST_BINS:
        raise FitError("too little signal to fit a quarter car to", where=where, found=f"{bins} spectral lines")
    mass = static_load / GRAVITY
    scale = 1.0 / math.sqrt(sum(one.samples for one in stretches) / len(stretches))
    parts = [Stretch(one.s, one.height * scale, one.force * scale, one.samples) for one in stretches]
    here = _start(parts, mass)
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
            if damping > 1e8:
                break
    return _released(parts, here, mass)


def _released(parts: Sequence[Stretch], here: Array, mass: float) -> ResponseFit:
    """Let the masses differ from the static load, and weigh what is known beforehand against the noise."""
    freedom = max(2 * sum(one.s.size for one in parts) - _FREE - TRANSIENT * len(parts), 1)
    cost, normal, right = _system(parts, here)
    damping = 1e-9
    for _ in range(_MORE_STEPS):
        variance = cost / freedom
        known, pull = _expected(here, mass, variance)
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
    known, _ = _expected(here, mass, cost / freedom)
    size = np.sqrt(np.diag(normal + known))
    size = np.where(size > 0.0, size, 1.0)
    covariance = np.linalg.pinv((normal + known) / np.outer(size, size), rcond=1e-15, hermitian=True)
    power = sum(float(np.sum(np.abs(one.force) ** 2)) for one in parts)
    return ResponseFit(
        corner=_corner(here),
        covariance=covariance / np.outer(size, size) * (cost / freedom),
        noise=math.sqrt(2.0 * cost / freedom),
        explained=1.0 - cost / power if power > 0.0 else 0.0,
    )


def _expected(here: Array, mass: float, variance: float) -> tuple[Array, Array]:
    """Normal matrix and right side of what is known beforehand: tyre damping, and the sum of the masses (kg)."""
    of_mass = variance / (_MASS_SPREAD * mass) ** 2
    known = of_mass * np.outer(_SUM, _SUM)
    known[4, 4] += variance / _TYRE_DAMPING_SPREAD**2
    pull = of_mass * (mass - _SUM @ here) * _SUM
    pull[4] += variance / _TYRE_DAMPING_SPREAD**2 * (_TYRE_DAMPING - here[4])
    return known, pull


def _surprise(here: Array, mass: float, variance: float) -> float:
    """Sum of squares by which parameters miss what is known beforehand."""
    gap = (mass - float(_SUM @ here)) / (_MASS_SPREAD * mass), (_TYRE_DAMPING - here[4]) / _TYRE_DAMPING_SPREAD
    return variance * float(gap[0] ** 2 + gap[1] ** 2)


def _corner(parameters: Array) -> Corner:
    mu, k, c, kt, ct, ms = (float(value) for value in parameters)
    return Corner(ms, mu, k, c, kt, ct)


def _parameters(corner: Corner) -> Array:
    return np.array(
        [
            corner.unsprung_mass,
            corner.spring_rate,
            corner.damping_coefficient,
            corner.tyre_stiffness,
            corner.tyre_damping_coefficient,
            corner.sprung_mass,
        ]
    )


def _within(parameters: Array, before: Array, mass: float) -> Array:
    """Halve the way to what no car can have."""
    low = np.array([1e-3 * mass, 0.0, 0.0, 1e3, -2e3, 0.2 * mass])
    high = np.array([0.6 * mass, 1e7, 1e6, 1e8, 2e4, 3.0 * mass])
    inside = np.where(parameters < low, 0.5 * (before + low), parameters)
    return np.where(inside > high, 0.5 * (before + high), inside)


def _start(parts: Sequence[Stretch], mass: float) -> Array:
    """Best of a grid of quarter cars."""
    tyre = _tyre_stiffness(parts)
    grid = [
        (
            share * mass,
            (1.0 - share) * mass * 65.0,
            ratio * 2.0 * math.sqrt(tyre * share * mass),
            tyre * factor,
            0.0,
            (1.0 - share) * mass,
        )
        for share in (0.06, 0.1, 0.16)
        for ratio in (0.05, 0.15, 0.4)
        for factor in (0.8, 1.0, 1.25)
    ]
    candidates = np.array(grid)
    misfit = np.zeros(len(grid))
    for one in parts:
        few = slice(None, None, max(one.s.size // _START_LINES, 1))
        misfit += np.sum(np.abs(one.force[few] - responses(candidates, one.s[few]) * one.height[few]) ** 2, axis=1)
    return np.asarray(candidates[int(np.argmin(misfit))])


def _tyre_stiffness(parts: Sequence[Stretch]) -> float:
    """Tyre stiffness (N/m) from the highest frequencies, where the wheel hardly follows."""
    one = max(parts, key=lambda part: float(part.s[-1].imag))
    top = one.s.imag > 0.85 * one.s[-1].imag
    drive = float(np.sum(np.abs(one.height[top]) ** 2))
    gain = abs(complex(np.sum(one.force[top] * np.conj(one.height[top])))) / drive if drive > 0.0 else 2e5
    return min(max(0.8 * gain, 6e4), 8e5)


def _system(parts: Sequence[Stretch], parameters: Array) -> tuple[float, Array, Array]:
    """Sum of squares, normal matrix and right side for the six parameters; the transients are projected out."""
    cost, normal, right = 0.0, np.zeros((_FREE, _FREE)), np.zeros(_FREE)
    for one in parts:
        squares, of_part, pull, _ = normal_equations(parameters, one.s.imag, one.height, one.force)
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
    """Dynamic force (N) in the bins of a stretch, with the transients that fit best."""
    left = normal_equations(_parameters(fit.corner), stretch.s.imag, stretch.height, stretch.force)[3]
    return np.asarray(stretch.force - left)
