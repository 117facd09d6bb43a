"""Shape of a spring: straight sections, a helper that closes, coils that bind, or a progressive curve."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, Literal

import numpy as np

from jounce.core.results import Shows
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.identify.estimate import Estimate, mean_of_replicates
from jounce.springs.curves import window_of
from jounce.springs.presses import Press, cycle_forces

Shape = Literal["linear", "progressive", "helper", "sections"]
KneeKind = Literal["helper", "bind", "knee"]

_POINTS = 80
_STRAIGHT = 0.004  # of the largest force: r.m.s. deviation of a straight line
_BETTER = 0.3  # ratio of sums of squares from which a kink explains what a cubic does not
_BINDS = 4.0  # times the rate before, from which coils bind
_SHORT = 0.2  # share of the stroke: coils that bind leave no more behind them
_APART = 5.0  # window half widths between two kinks
_ROUNDED = 1.3  # window half widths about a kink that do not count
_FEWEST = 12  # points of a fit
_KINKED = 0.05  # change of the rate that is a kink


@dataclass(frozen=True)
class Section(Plain):
    """Rate of a spring over a range of deflections, or at one (``start`` = ``end``).

    Attributes
    ----------
    start, end : float
        Deflection from contact, m.
    rate : Estimate
        Rate, N/m.
    """

    start: Annotated[float, Shows("from", "m")]
    end: Annotated[float, Shows("to", "m")]
    rate: Annotated[Estimate, Shows("rate", "N/m")]


@dataclass(frozen=True)
class Knee(Plain):
    """A deflection at which the rate changes at once.

    Attributes
    ----------
    kind : {"helper", "bind", "knee"}
        A helper that closes (coil bind of the softer of two springs), coils that bind, or a kink of another origin.
    deflection : Estimate
        Deflection from contact, m.
    force : Estimate
        Force there, N.
    helper_rate : Estimate or None
        Rate of the helper alone, N/m, if the main spring has the rate above the knee.
    """

    kind: Annotated[KneeKind, Shows("knee")]
    deflection: Annotated[Estimate, Shows("at", "m")]
    force: Annotated[Estimate, Shows("force", "N")]
    helper_rate: Annotated[Estimate | None, Shows("helper alone", "N/m")] = None


def shape_of(presses: Sequence[Press]) -> tuple[Shape, tuple[Section, ...], tuple[Knee, ...]]:
    """Tell the shape of a spring from all cycles of its records, which count as replicates."""
    reach = min(press.reach for press in presses)
    grid = np.linspace(0.02, 0.99, _POINTS) * reach
    width = window_of(presses, reach, 1.0 / _POINTS)
    cycles, files = [], []
    for k, press in enumerate(presses):
        forces, _ = cycle_forces(press, grid, width)
        both = np.isfinite(forces).all(axis=(1, 2))
        used = forces[both].mean(axis=1) if both.any() else forces[:, 0]
        cycles += list(used)
        files += [k] * len(used)
    known = np.isfinite(cycles).all(axis=0)
    x, runs = grid[known], np.array(cycles)[:, known]
    mean = runs.mean(axis=0)
    places = _kinks(x, mean, _APART * width)
    if places is None:
        return "progressive", _smooth_rates(x, runs), ()
    zero = tuple(
        float(np.mean([getattr(press.zero, name) for press in presses]))
        for name in ("place_error", "zero_error")
    )
    clear = np.ones(len(x), dtype=bool)  # windows that contain a kink round it off
    for place in places:
        clear &= np.abs(x - place) > _ROUNDED * width
    if np.count_nonzero(clear) < _FEWEST:
        clear[:] = True
    return _sections(x[clear], runs[:, clear], places, zero)


def _kinks(x: Array, force: Array, apart: float) -> list[float] | None:
    """Return the kinks of a piecewise straight curve, an empty list for a straight one; None for a smooth curve.

    Kinks are more than ``apart`` (m) from each other.
    """
    height = float(force.max())
    straight, _ = _misfit(x, force)
    if math.sqrt(straight / len(x)) < _STRAIGHT * height:
        return []
    smooth = float(np.sum((force - np.polyval(np.polyfit(x, force, 3), x)) ** 2))
    single, at = _best_kinks(x, force, 1)
    double, both = _best_kinks(x, force, 2)
    is_apart = both[1] - both[0] > apart  # closer kinks are one that windows round off
    if is_apart and double < _BETTER * min(single, smooth) and _is_kinked(x, force, both):
        return both
    if single < _BETTER * smooth and _is_kinked(x, force, at):
        return at
    return None


def _is_kinked(x: Array, force: Array, places: Sequence[float]) -> bool:
    _, factors = _misfit(x, force, *places)
    rates = np.cumsum(factors[1:])
    return bool(np.all(rates > 0.0) and np.all(np.abs(np.diff(rates)) > _KINKED * rates[:-1].max()))


def _misfit(x: Array, force: Array, *places: float) -> tuple[float, Array]:
    """Fit a line with kinks; return the sum of squares, and constant, first rate and changes of the rate."""
    columns = np.column_stack(
        [np.ones_like(x), x, *(np.maximum(x - place, 0.0) for place in places)]
    )
    scale = np.linalg.norm(columns, axis=0)
    factors = np.linalg.lstsq(columns / scale, force, rcond=None)[0] / scale
    rest = force - columns @ factors
    return float(rest @ rest), factors


def _best_kinks(x: Array, force: Array, count: int) -> tuple[float, list[float]]:
    """Search the places of kinks on a grid, then closer."""
    from itertools import combinations

    from scipy.optimize import minimize

    low, high = float(x[2]), float(x[-3])
    tried = np.linspace(low, high, 36)
    best = min(combinations(tried, count), key=lambda places: _misfit(x, force, *places)[0])
    found = minimize(
        lambda places: _misfit(x, force, *np.clip(places, low, high))[0],
        best,
        method="Nelder-Mead",
        options={"xatol": 1e-5 * high, "fatol": 0.0, "maxiter": 200},
    )
    places = sorted(float(place) for place in np.clip(found.x, low, high))
    return _misfit(x, force, *places)[0], places


def _sections(
    x: Array, runs: Array, places: list[float], zero: tuple[float, ...]
) -> tuple[Shape, tuple[Section, ...], tuple[Knee, ...]]:
    """Return straight sections and the knees between them, each cycle fitted alone.

    ``zero`` are the standard errors of place (m) and force (N) at contact, which all cycles share.
    """
    fits = [_fit_near(x, force, places) for force in runs]
    rates = np.array([np.cumsum(factors[1:]) for _, factors in fits])
    at = np.array([where for where, _ in fits])
    ends = [0.0, *places, float(x[-1])]
    sections = tuple(
        Section(ends[i], ends[i + 1], _replicates(rates[:, i])) for i in range(rates.shape[1])
    )
    knees = []
    for i, place in enumerate(places):
        before, after = float(rates[:, i].mean()), float(rates[:, i + 1].mean())
        is_last = i == len(places) - 1
        binds = is_last and after > _BINDS * before and ends[-1] - place < _SHORT * ends[-1]
        kind: KneeKind = "bind" if binds else "helper" if after > before and i == 0 else "knee"
        force = np.array([float(_value(factors, where, where[i])) for where, factors in fits])
        helper = None
        if kind == "helper":
            helper = _replicates(1.0 / (1.0 / rates[:, i] - 1.0 / rates[:, i + 1]))
        knees.append(
            Knee(
                kind,
                _widened(_replicates(at[:, i]), zero[0]),
                _widened(_replicates(force), zero[1]),
                helper,
            )
        )
    kinds = {knee.kind for knee in knees}
    shape: Shape = "helper" if "helper" in kinds else "sections" if "knee" in kinds else "linear"
    return shape, sections, tuple(knees)


def _value(factors: Array, places: Sequence[float], x: float) -> float:
    terms = [1.0, x, *(max(x - place, 0.0) for place in places)]
    return float(np.dot(factors, terms))


def _fit_near(x: Array, force: Array, places: list[float]) -> tuple[list[float], Array]:
    """Fit kinks near given places."""
    if not places:
        return [], _misfit(x, force)[1]
    from scipy.optimize import minimize

    low, high = float(x[1]), float(x[-2])
    found = minimize(
        lambda at: _misfit(x, force, *np.clip(at, low, high))[0],
        places,
        method="Nelder-Mead",
        options={"xatol": 1e-6 * high, "fatol": 0.0, "maxiter": 200},
    )
    at = [float(place) for place in np.clip(found.x, low, high)]
    return at, _misfit(x, force, *at)[1]


def _smooth_rates(x: Array, runs: Array) -> tuple[Section, ...]:
    """Return rates at the beginning, in the middle and at the end, by parabolas over a fifth of the stroke."""
    sections = []
    for share in (0.15, 0.5, 0.85):
        place = share * float(x[-1])
        near = np.abs(x - place) < 0.12 * float(x[-1])
        slope = [float(np.polyfit(x[near] - place, force[near], 2)[1]) for force in runs]
        sections.append(Section(place, place, _replicates(np.array(slope))))
    return tuple(sections)


def _replicates(values: Array) -> Estimate:
    return mean_of_replicates(values.tolist())


def _widened(given: Estimate, error: float) -> Estimate:
    """Return an estimate with another error, independent of its own (same unit)."""
    if given.standard_error is None or given.interval is None or given.standard_error == 0.0:
        return given
    half = 0.5 * (given.interval[1] - given.interval[0])
    factor = half / given.standard_error
    total = math.hypot(given.standard_error, error)
    half = math.hypot(factor * given.standard_error, 1.96 * error)
    return Estimate(given.value, total, (given.value - half, given.value + half))
