"""Designs of experiments: lists, grids, and points spread over ranges or distributions."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Literal

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.phrases import Phrase
from jounce.core.samples import as_values
from jounce.core.seeds import check_seed, is_whole
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.core.units import Unit, to_si

Spread = str | Sequence[float | str] | Mapping[str, float | str]
"""Range or distribution of a parameter: see :func:`sobol`."""
Kind = Literal["grid", "latin-hypercube", "sobol", "monte-carlo", "morris", "saltelli"]
MOST = 50_000_000  # variants: with ten parameters 4 GB
"""Variants of a design."""
_FORMS = '"20 %", "±2 kg", ["14 kg", "18 kg"], {mean = "16 kg", sd = "0.5 kg"} or {low, mode, high}'
_SHAPES = ({"mean", "sd"}, {"sd"}, {"low", "mode", "high"}, {"low", "high"})


@dataclass(frozen=True)
class Design(Shown):
    """A design of variants, not yet evaluated for a rig; created by :func:`grid`, :func:`sobol` and similar functions.

    Attributes
    ----------
    kind : {"grid", "latin-hypercube", "sobol", "monte-carlo", "morris", "saltelli"}
        Method that places the points.
    spreads : mapping
        Path of a parameter to its range, distribution or values.
    count : int
        Number of variants.
    seed : int
        Seed of random points.
    """

    kind: Kind
    spreads: Mapping[str, Any]
    count: int
    seed: int = 0

    def values(
        self,
        number: Callable[[str], tuple[float, str]],
        whole: Callable[[str], bool] | None = None,
        limit: Callable[[str], Unit] | None = None,
    ) -> dict[str, Array]:
        """Return the values (SI) of every variant by path.

        ``number`` returns value and SI unit of the parameter at a path, ``whole`` whether it is an integer (default:
        never). With ``limit``, a range that exceeds the allowed one raises an error (see :meth:`refuse_outside`).
        """
        if self.kind == "grid":
            columns = [_list(given, number(path)[1], path) for path, given in self.spreads.items()]
            rows = np.array(list(itertools.product(*columns))).reshape(-1, len(columns))
            return {path: rows[:, i].copy() for i, path in enumerate(self.spreads)}
        laws = self._laws(number, whole)
        if limit is not None:
            self._refuse_outside(laws, limit)
        shares = _points(self.kind, len(self.spreads), self.count, self.seed)
        return {path: law(shares[:, i]) for i, (path, law) in enumerate(laws.items())}

    def refuse_outside(
        self,
        number: Callable[[str], tuple[float, str]],
        limit: Callable[[str], Unit],
        whole: Callable[[str], bool] | None = None,
    ) -> None:
        """Raise an error for a range beyond the limits of the description, before anything runs.

        An end may be equal to an excluded limit (``above 0``), since no point is drawn there. Normal distributions
        (unbounded) and grids (explicit values) are not checked; their forbidden values are not run.
        """
        if self.kind != "grid":
            self._refuse_outside(self._laws(number, whole), limit)

    def _refuse_outside(
        self, laws: Mapping[str, Callable[[Array], Array]], limit: Callable[[str], Unit]
    ) -> None:
        for path, law in laws.items():
            low, high = law(np.array([0.0, 1.0])).tolist()
            least, most = limit(path).limits
            if math.isfinite(low) and (low < least or high > most):
                raise DescriptionError(
                    Phrase(
                        "the spread exceeds the allowed range, from {low:g} to {high:g} {si}",
                        low=low,
                        high=high,
                        si=limit(path).si,
                    ),
                    where=path,
                    found=self.spreads[path],
                    allowed=limit(path).range_text,
                )

    def _laws(
        self, number: Callable[[str], tuple[float, str]], whole: Callable[[str], bool] | None
    ) -> dict[str, Callable[[Array], Array]]:
        """Return for every parameter a function that maps quantiles in 0..1 to values, SI."""
        laws = {path: _law(spread, *number(path), path) for path, spread in self.spreads.items()}
        rounded = [path for path in laws if whole is not None and whole(path)]
        return laws | {path: _in_whole(laws[path], self.spreads[path], path) for path in rounded}


def grid(values: Mapping[str, Sequence[float | str]]) -> Design:
    """Return a design with every combination of values.

    Parameters
    ----------
    values : mapping
        Path of a parameter to its values, SI or texts with units; the last path changes fastest.

    Returns
    -------
    Design
        For :func:`jounce.simulate_many`.

    Raises
    ------
    DescriptionError
        If there is nothing to vary, or there are too many variants.

    Examples
    --------
    >>> import jounce as jn
    >>> jn.grid({"sprung.mass": ["14 kg", "16 kg", "18 kg"], "strut.spring.rate": ["20 N/mm", "25 N/mm"]}).count
    6
    """
    for path, given in _check_paths(values).items():
        if not is_list(given):
            raise DescriptionError(
                "not a list of values", where=path, found=given, allowed='e.g. ["14 kg", "16 kg"]'
            )
    return Design("grid", dict(values), _count(math.prod(len(given) for given in values.values())))


def sobol(spreads: Mapping[str, Spread], count: int, *, seed: int = 0) -> Design:
    """Spread points evenly over all parameters by a scrambled Sobol sequence [sobol1967].

    Means over such points converge faster than over random ones; a ``count`` that is a power of 2 is best balanced.

    Parameters
    ----------
    spreads : mapping
        Path of a parameter to its range or distribution. ``"20 %"`` and ``"±2 kg"`` extend to either side of the rig's
        own value; two values (SI or texts with units) are the ends of a range. ``{"mean": ..., "sd": ...}`` is a normal
        distribution (``sd`` may be in percent; ``mean`` is the rig's own value by default), and ``{"low": ..., "mode":
        ..., "high": ...}`` a triangular one. An integer parameter (the seed of a road) takes integers only.
    count : int
        Number of variants.
    seed : int
        Seed of the scrambling.

    Returns
    -------
    Design
        For :func:`jounce.simulate_many`.

    Raises
    ------
    DescriptionError
        If there is nothing to vary, a spread is empty, or there are too many variants.

    Notes
    -----
    Scrambling and points are identical to those of ``scipy.stats.qmc.Sobol``.

    Examples
    --------
    >>> import jounce as jn
    >>> jn.sobol({"strut.spring.rate": "20 %", "sprung.mass": ["14 kg", "18 kg"]}, 4096, seed=1).count
    4096
    """
    return _spread("sobol", spreads, count, seed)


def latin_hypercube(spreads: Mapping[str, Spread], count: int, *, seed: int = 0) -> Design:
    """Spread points such that each of ``count`` equal parts of each range is used once [mckay1979].

    Parameters
    ----------
    spreads : mapping
        As for :func:`sobol`.
    count : int
        Number of variants.
    seed : int
        Seed of the random order.

    Returns
    -------
    Design
        For :func:`jounce.simulate_many`.

    Raises
    ------
    DescriptionError
        As for :func:`sobol`.

    Examples
    --------
    >>> import jounce as jn
    >>> jn.latin_hypercube({"tyre.stiffness": "10 %"}, 50).kind
    'latin-hypercube'
    """
    return _spread("latin-hypercube", spreads, count, seed)


def monte_carlo(spreads: Mapping[str, Spread], count: int, *, seed: int = 0) -> Design:
    """Draw independent random points.

    Parameters
    ----------
    spreads : mapping
        As for :func:`sobol`.
    count : int
        Number of variants.
    seed : int
        Seed of the random numbers.

    Returns
    -------
    Design
        For :func:`jounce.simulate_many`.

    Raises
    ------
    DescriptionError
        As for :func:`sobol`.

    Examples
    --------
    >>> import jounce as jn
    >>> jn.monte_carlo({"tyre.stiffness": {"sd": "5 %"}}, 1000, seed=3).seed
    3
    """
    return _spread("monte-carlo", spreads, count, seed)


def morris(spreads: Mapping[str, Spread], trajectories: int, *, seed: int = 0) -> Design:
    """Create trajectories that change one parameter at a time, to screen many parameters [morris1991].

    Each trajectory starts at a random point and moves every parameter once, in random order, by half of its range in
    quantiles, between 8 levels (the middle of each eighth). A dozen trajectories are enough to separate influential
    parameters from the others; :func:`sensitivity_indices` computes the effects from the results.

    Parameters
    ----------
    spreads : mapping
        As for :func:`sobol`.
    trajectories : int
        Number of trajectories; each has one variant more than there are parameters.
    seed : int
        Seed of the random starts and orders.

    Returns
    -------
    Design
        For :func:`jounce.simulate_many`.

    Raises
    ------
    DescriptionError
        As for :func:`sobol`.

    Examples
    --------
    >>> import jounce as jn
    >>> jn.morris({"strut.spring.rate": "20 %", "sprung.mass": ["14 kg", "18 kg"]}, 10).count
    30
    """
    return _spread("morris", spreads, _count(trajectories) * (len(_check_paths(spreads)) + 1), seed)


def saltelli(spreads: Mapping[str, Spread], pairs: int, *, seed: int = 0) -> Design:
    """Create pairs of points that exchange one parameter at a time, for Sobol' indices [saltelli2010].

    From the results, :func:`sensitivity_indices` computes the share of a metric's variance that each parameter causes,
    alone and in interaction with others. For each pair, both points are run, and the first point with each parameter in
    turn taken from the second.

    Parameters
    ----------
    spreads : mapping
        As for :func:`sobol`; the parameters are independent of each other.
    pairs : int
        Number of pairs, preferably a power of 2; each has two variants more than there are parameters.
    seed : int
        Seed of the scrambling.

    Returns
    -------
    Design
        For :func:`jounce.simulate_many`.

    Raises
    ------
    DescriptionError
        As for :func:`sobol`.

    Examples
    --------
    >>> import jounce as jn
    >>> jn.saltelli({"strut.spring.rate": "20 %", "sprung.mass": ["14 kg", "18 kg"]}, 512).count
    2048
    """
    return _spread("saltelli", spreads, _count(pairs) * (len(_check_paths(spreads)) + 2), seed)


def _spread(kind: Kind, spreads: Mapping[str, Spread], count: int, seed: int) -> Design:
    for path, spread in _check_paths(spreads).items():
        if not isinstance(spread, str | Mapping) and not is_list(spread):
            raise DescriptionError(
                "no distribution is given", where=path, found=spread, allowed=_FORMS
            )
    check_seed(seed)
    return Design(kind, dict(spreads), _count(count), int(seed))


def _check_paths(given: object) -> Mapping[str, Any]:
    if not isinstance(given, Mapping) or not given:
        raise DescriptionError(
            "no parameter to vary is given",
            where="variants",
            found=given,
            allowed="the path of a parameter and its values",
        )
    return given


def is_list(values: Any) -> bool:
    """Whether an object is a non-empty list, array or column of any library, but not a text or mapping."""
    try:
        return len(values) > 0 and not isinstance(values, str | Mapping)
    except TypeError:  # a scalar may have a `__len__` that raises
        return False


def _count(count: int) -> int:
    if not is_whole(count) or not 1 <= count <= MOST:
        raise DescriptionError(
            "invalid number of variants",
            where="count",
            found=count,
            allowed=Phrase("1 to {most}", most=MOST),
        )
    return int(count)


def _points(kind: Kind, numbers: int, count: int, seed: int) -> Array:
    """Return points in the open unit cube, one row each."""
    if kind == "monte-carlo":
        points = np.random.default_rng(seed).random((count, numbers))
    elif kind == "morris":
        points = _trajectories(numbers, count // (numbers + 1), np.random.default_rng(seed))
    elif kind == "saltelli":
        pairs = _points("sobol", 2 * numbers, count // (numbers + 2), seed)
        first, second = pairs[:, None, :numbers], pairs[:, None, numbers:]
        exchanged = np.where(np.eye(numbers, dtype=bool), second, first)
        points = np.concatenate([first, exchanged, second], axis=1).reshape(-1, numbers)
    elif kind == "sobol":
        points = _sobol(numbers, count, seed)
    else:
        from scipy.stats import qmc

        points = qmc.LatinHypercube(numbers, seed=seed).random(count)
    return np.asarray(np.minimum(np.maximum(points, 1e-12), 1.0 - 1e-12), dtype=float)


_BITS = 30  # of a Sobol sequence: a billion points, as in SciPy
_FIRST = 1024  # points computed one by one; for fewer, doubling is slower
_TURNS = np.array(
    [(i & -i).bit_length() - 1 for i in range(1, _FIRST)]
)  # direction along which each point moves
_PLACES = 2 ** np.arange(_BITS - 1, -1, -1)
_BELOW, _DIAGONAL = np.tri(_BITS, k=-1), np.eye(_BITS)


def _sobol(numbers: int, count: int, seed: int) -> Array:
    """Return points of a scrambled Sobol sequence, identical to ``qmc.Sobol(numbers, seed=seed)`` to the last bit.

    Creating SciPy's engine for each seed takes as long as two dozen variants of a small model, half of it for setup.
    Its directions are the same for all seeds and are read only once. A triangular matrix of random bits scrambles the
    bits of each direction. Points follow Gray code order: the first thousand one step at a time, then repeatedly
    doubled by mirroring all existing points along the next direction.
    """
    doublings = max((count - 1).bit_length(), 1)
    random = np.random.default_rng(seed)
    shift = random.integers(0, 2, (numbers, _BITS), dtype=np.uint32) @ _PLACES[::-1]
    mix = random.integers(0, 2, (numbers, _BITS, _BITS), dtype=np.uint32) * _BELOW + _DIAGONAL
    mixed = (mix @ _directions(numbers, doublings)).astype(np.int64) & 1
    along = (_PLACES @ mixed).astype(np.uint32)
    result = np.empty((numbers, count), dtype=np.uint32)
    result[:, 0] = shift
    first = min(count, _FIRST)
    np.take(along, _TURNS[: first - 1], axis=1, out=result[:, 1:first])
    np.bitwise_xor.accumulate(result[:, :first], axis=1, out=result[:, :first])
    for i in range(_FIRST.bit_length() - 1, doublings):
        old = 2**i
        new = result[:, old : 2 * old]
        np.bitwise_xor(result[:, old - new.shape[1] : old][:, ::-1], along[:, i, None], out=new)
    return np.asarray((result * 2.0**-_BITS).T, dtype=float)


@lru_cache(64)
def _directions(numbers: int, count: int) -> Array:
    """Return the bits of the first directions of the Sobol sequence, (numbers, bits, directions), highest bit first."""
    from scipy.stats import qmc

    directions = []
    for i in range(count):
        sequence = qmc.Sobol(numbers, scramble=False)
        if i:
            sequence.fast_forward(2**i - 1)
        before, after = (sequence.random(2) * 2.0**_BITS).astype(np.int64)
        directions.append(before ^ after)
    return np.asarray(
        np.array(directions).T[:, None] >> np.arange(_BITS - 1, -1, -1)[:, None] & 1, dtype=float
    )


LEVELS = 8
"""Levels of each parameter on a trajectory of :func:`morris`; a step spans half of them."""


def _trajectories(numbers: int, count: int, random: np.random.Generator) -> Array:
    """Return the points of all trajectories, one row each, trajectory by trajectory."""
    begin = random.integers(0, LEVELS, (count, numbers))
    end = (begin + LEVELS // 2) % LEVELS
    rank = np.argsort(random.random((count, numbers)), axis=1)  # step at which each parameter moves
    is_moved = rank[:, None, :] < np.arange(numbers + 1)[:, None]
    levels = np.where(is_moved, end[:, None, :], begin[:, None, :])
    return np.asarray((levels.reshape(-1, numbers) + 0.5) / LEVELS, dtype=float)


def _law(spread: Any, value: float, unit: str, path: str) -> Callable[[Array], Array]:
    """Return a function that maps quantiles in 0..1 to values, SI."""
    if (
        isinstance(spread, str)
        and spread.strip().startswith("±")
        and not spread.strip().endswith("%")
    ):
        reach = to_si(spread.strip().removeprefix("±"), unit, where=path)
        if not 0.0 < reach < math.inf:
            raise DescriptionError("invalid range", where=path, found=spread, allowed=_FORMS)
        return lambda share: value + reach * (2.0 * share - 1.0)
    if isinstance(spread, str):
        part = _percent(spread, path)
        if value == 0.0:
            raise DescriptionError(
                "a relative spread around zero has no width",
                where=path,
                found=spread,
                allowed=_FORMS.removeprefix('"20 %", '),
            )
        return lambda share: value + abs(value) * part * (2.0 * share - 1.0)
    if not isinstance(spread, Mapping):
        low, high = _ends(_list(spread, unit, path), path, spread)
        return lambda share: low + (high - low) * share
    if set(spread) not in _SHAPES:
        raise DescriptionError(
            "invalid distribution", where=path, found=dict(spread), allowed=_FORMS
        )
    if "sd" in spread:
        mean = to_si(spread["mean"], unit, where=f"{path}: mean") if "mean" in spread else value
        given = spread["sd"]
        relative = isinstance(given, str) and given.strip().endswith("%")
        sd = (
            abs(mean) * _percent(str(given), path)
            if relative
            else to_si(given, unit, where=f"{path}: sd")
        )
        if not (sd > 0.0 and math.isfinite(sd) and math.isfinite(mean)):
            raise DescriptionError(
                "invalid standard deviation", where=f"{path}: sd", found=given, allowed="above 0"
            )
        from scipy.special import ndtri

        return lambda share: np.asarray(mean + sd * ndtri(share), dtype=float)
    low, high = _ends(
        [to_si(spread[key], unit, where=f"{path}: {key}") for key in ("low", "high")], path, spread
    )
    if "mode" not in spread:
        return lambda share: low + (high - low) * share
    mode = to_si(spread["mode"], unit, where=f"{path}: mode")
    if not low <= mode <= high:
        raise DescriptionError(
            "the mode is outside its range",
            where=path,
            found=dict(spread),
            allowed="a mode between low and high",
        )
    bend = (mode - low) / (high - low)

    def triangular(share: Array) -> Array:
        rising = low + np.sqrt(share * (high - low) * (mode - low))
        falling = high - np.sqrt((1.0 - share) * (high - low) * (high - mode))
        return np.asarray(np.where(share < bend, rising, falling))

    return triangular


def _in_whole(law: Callable[[Array], Array], spread: object, path: str) -> Callable[[Array], Array]:
    """Round a law to integers, with the ends of a range as likely as the other values."""
    begin, end = law(np.array([0.0, 1.0])).tolist()
    if not (math.isfinite(begin) and math.isfinite(end)):
        return lambda share: np.rint(law(share))
    low, high = math.ceil(begin), math.floor(end)
    if low > high:
        raise DescriptionError(
            "the range contains no integer", where=path, found=spread, allowed="e.g. [1, 100]"
        )
    stretch = (high + 1 - low) / (end - begin)
    return lambda share: np.asarray(
        np.clip(np.floor(low + stretch * (law(share) - begin)), low, high), dtype=float
    )


def _percent(text: str, path: str) -> float:
    try:
        share = text.strip().removeprefix("±")
        percent = float(share.removesuffix("%")) / 100.0 if share.endswith("%") else math.nan
    except ValueError:
        percent = math.nan
    if not 0.0 < percent < math.inf:
        raise DescriptionError("invalid share", where=path, found=text, allowed=_FORMS)
    return percent


def _ends(values: Sequence[float], path: str, given: object) -> tuple[float, float]:
    if len(values) != 2 or not values[0] < values[1]:
        raise DescriptionError(
            "invalid range", where=path, found=given, allowed="a lower and a higher value"
        )
    return values[0], values[1]


def _list(given: Sequence[float | str], unit: str, path: str) -> list[float]:
    result: list[float] = as_values(given, unit, where=path).tolist()
    if not np.all(np.isfinite(result)):
        raise DescriptionError("not finite numbers", where=path, found=str(list(given))[:60])
    return result


DESIGNS: Mapping[str, Callable[..., Design]] = {
    "grid": grid,
    "latin-hypercube": latin_hypercube,
    "sobol": sobol,
    "monte-carlo": monte_carlo,
    "morris": morris,
    "saltelli": saltelli,
}
"""Functions that create a design, by kind."""
