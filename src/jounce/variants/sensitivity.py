"""Sensitivities of metrics of many runs: Morris effects, Sobol indices, or regression, with confidence intervals."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.constants import NORMAL_95
from jounce.core.errors import DescriptionError, unknown
from jounce.core.phrases import Phrase
from jounce.core.types import Array

if TYPE_CHECKING:
    import xarray as xr

_CONFIDENCE = (2.5, 97.5)  # percentiles
_RESAMPLES, _FEWER, _MANY = 1000, 200, 200_000  # bootstrap draws; fewer for larger tables
_FEW = 16.0
"""Resampling only a few rows misses rare values: intervals are widened by this constant over the number of rows.

For
the Ishigami function, the g-function and a sum, the intervals contain the closed-form indices in 77 to 100 % of 60
designs of 8 pairs and in 90 to 100 % of 16 and 32 pairs (each index separately); without widening, in 43 to 97 % and 77
to 100 %.
"""
_NEVER_NEGATIVE = ("total", "mean_absolute_effect", "effect_spread")
_END = 0.2  # share of the variants at either end of a parameter's range
_FEWEST = 3  # rows: with two, a variance has no interval
_LEAST = 1e-12  # relative to the size of a metric: smaller variation is rounding


def sensitivity_indices(many: xr.Dataset, metrics: Sequence[str] | str | None = None) -> xr.Dataset:
    """Estimate how metrics depend on the varied parameters, with confidence intervals.

    The measure depends on the design of the variants: Sobol indices for :func:`saltelli`, mean and spread of elementary
    effects for :func:`morris`, regression for all others. It is not the derivative at the unchanged rig, which
    :func:`sensitivities` computes exactly.

    Parameters
    ----------
    many : xarray.Dataset
        Metrics on ``variant``, as returned by :func:`simulate_many` or :func:`load_sweep`.
    metrics : sequence of str, optional
        Metrics to analyse; all by default.

    Returns
    -------
    xarray.Dataset
        Measures on ``metric`` and ``number`` (paths of the varied parameters), each with the ends ``_low`` and
        ``_high`` of its 95 % interval. ``at_low`` and ``at_high`` are means of the metric (SI) over the fifth of the
        variants with the lowest and the highest values of the parameter (not for :func:`morris`). For :func:`saltelli`:
        ``first`` and ``total``, the shares (1) of the metric's variance caused by the parameter alone and including its
        interactions. For :func:`morris`: ``mean_absolute_effect``, ``mean_effect`` and ``effect_spread`` of the metric
        (SI) over the parameter's entire range of quantiles. For other designs: ``regression``, the standardised
        coefficient (1), ``rank_correlation`` (1), and ``explained``, the share (1) of the variance explained by the
        linear model; if it is low, the coefficients say little. ``attrs["left_out"]`` is the number of variants without
        a run, and of those that cannot be used without them.

    Raises
    ------
    DescriptionError
        For data without metrics or varied parameters, an unknown metric, or too few variants ran.

    Notes
    -----
    First-order indices are estimated as recommended in [saltelli2010], total indices after Jansen (equation (f) of
    table 2 there). Effects follow [morris1991], with the mean of absolute effects [campolongo2007]. Their intervals are
    bootstrapped with a fixed seed. Intervals of regression coefficients are robust to heteroscedasticity [white1980];
    those of rank correlations follow [bonett2000].

    Examples
    --------
    >>> import jounce as jn
    >>> rig = jn.load("audi-a6-quarter-car")
    >>> trial = jn.Trial(road=jn.HalfSine(height="10 mm", length="1 m"), speed="10 m/s", duration="1 s")
    >>> design = jn.morris({"strut.damper.coefficient": "20 %", "tyre.stiffness": "20 %"}, 10)
    >>> found = jn.sensitivity_indices(jn.simulate_many(rig, trial, design, metrics="max sprung.az"))
    >>> effect = found["mean_absolute_effect"].sel(metric="max sprung.az")
    >>> bool(effect.sel(number="strut.damper.coefficient") > effect.sel(number="tyre.stiffness"))
    True
    """
    import xarray as xr

    names, paths = metrics_of(many, metrics), numbers_of(many)
    if not paths:
        raise DescriptionError(
            "no parameter varies",
            where="many",
            hint="Pass the result of simulate_many or load_sweep.",
        )
    values = np.column_stack([many[path].to_numpy() for path in paths])
    design = str(many.attrs.get("design", "list"))
    size = {"saltelli": len(paths) + 2, "morris": len(paths) + 1}.get(design, 1)
    belong = many["variant"].to_numpy() // size
    indices: dict[str, Array] = {}
    left_out = 0
    for i, name in enumerate(names):
        y = many[name].to_numpy().astype(float)
        good = np.isfinite(y) & _are_whole(belong, np.isfinite(y), size)
        _check_count(
            int(np.sum(good)) // size, _FEWEST if size > 1 else max(_FEWEST, len(paths) + 2)
        )
        results = {"saltelli": _sobol_indices, "morris": _elementary_effects}.get(
            design, _regression
        )(values[good], y[good])
        if design != "morris":  # its few levels would mix the effects of parameters
            results |= _ends(values[good], y[good])
        left_out = max(left_out, int(np.sum(~good)))
        for key, result in results.items():
            indices.setdefault(key, np.full((len(names), *result.shape), np.nan))[i] = result
    variables = {
        key: (
            ("metric", "number")[: index_values.ndim],
            index_values,
            {"long_name": _WORDS[key.removesuffix("_low").removesuffix("_high")]},
        )
        if key not in ("at_low", "at_high")
        else (("metric", "number"), index_values, {"long_name": _WORDS[key]})
        for key, index_values in indices.items()
    }
    units = [str(many[name].attrs.get("units", "1")) for name in names]
    where = {"metric": names, "number": paths, "units": ("metric", units)}
    return xr.Dataset(variables, where, {"design": design, "left_out": left_out})


_WORDS = {
    "first": "share of the variance that the number is behind alone",
    "total": "share of the variance that the number is behind, alone and with others",
    "mean_absolute_effect": "mean size of the effects of the number's whole range",
    "mean_effect": "mean effect of the number's whole range",
    "effect_spread": "standard deviation of the effects of the number's whole range",
    "regression": "standardised regression coefficient",
    "rank_correlation": "rank correlation",
    "explained": "share of the variance that straight lines explain",
    "at_low": "mean over the fifth of the variants with the lowest values of the number",
    "at_high": "mean over the fifth of the variants with the highest values of the number",
}


def metrics_of(many: xr.Dataset, chosen: Sequence[str] | str | None = None) -> list[str]:
    """Return the names of all metrics of many runs, or of the chosen ones."""
    known = [
        str(name)
        for name, column in many.data_vars.items()
        if column.dims == ("variant",) and column.dtype.kind in "fi"
    ]
    if chosen is None:
        chosen = known
    wanted = [chosen] if isinstance(chosen, str) else list(chosen)
    for name in wanted:
        if name not in known:
            raise unknown(name, known, what="metric", where="metrics")
    if not wanted:
        raise DescriptionError(
            "no metric of the runs was stored", where="metrics", hint="Request metrics."
        )
    return wanted


def numbers_of(many: xr.Dataset) -> list[str]:
    """Return the paths of the parameters that vary among many runs."""
    return [
        str(name)
        for name, coord in many.coords.items()
        if coord.dims == ("variant",) and name != "variant" and np.ptp(coord.to_numpy()) > 0.0
    ]


def _varies(y: Array) -> bool:
    return bool(np.ptp(y) > _LEAST * np.max(np.abs(y)))


def _resample(
    rows: int, numbers: int, estimate: Callable[[Any], tuple[Array, ...]]
) -> list[tuple[Array, Array]]:
    """Bootstrap the interval of each estimate by resampling rows with replacement."""
    random = np.random.default_rng(0)
    times = _RESAMPLES if rows * numbers <= _MANY else _FEWER
    drawn = [estimate(random.integers(0, rows, rows)) for _ in range(times)]
    ends = [
        np.percentile(np.array(estimates), _CONFIDENCE, axis=0)
        for estimates in zip(*drawn, strict=True)
    ]
    return [(low, high) for low, high in ends]


def _estimate_with_ends(
    names: Sequence[str], rows: int, numbers: int, estimate: Callable[[Any], tuple[Array, ...]]
) -> dict[str, Array]:
    with np.errstate(divide="ignore", invalid="ignore"):  # a resample without variation
        values = estimate(slice(None))
        ends = _resample(rows, numbers, estimate)
    results: dict[str, Array] = {}
    wider = 1.0 + _FEW / rows
    for name, value, (low, high) in zip(names, values, ends, strict=False):
        below, above = wider * np.maximum(value - low, 0.0), wider * np.maximum(high - value, 0.0)
        least = 0.0 if name in _NEVER_NEGATIVE else -np.inf
        results |= {
            name: value,
            f"{name}_low": np.maximum(value - below, least),
            f"{name}_high": value + above,
        }
    return results


def _check_count(count: int, least: int) -> None:
    if count < least:
        raise DescriptionError(
            "too few variants have a completed run",
            where="many",
            found=count,
            allowed=Phrase("at least {least}", least=least),
        )


def _are_whole(belong: Array, ran: Array, size: int) -> Array:
    """Return flags of variants in complete groups (index ``belong``): all ``size`` variants are present and ran."""
    _, group, counts = np.unique(belong, return_inverse=True, return_counts=True)
    return np.asarray((counts == size) & (np.bincount(group, ran) == size))[group]


def _sobol_indices(values: Array, y: Array) -> dict[str, Array]:
    numbers = values.shape[1]
    runs = y.reshape(-1, numbers + 2)
    if not _varies(runs):
        return dict.fromkeys(("first", "total"), np.zeros(numbers))
    runs = runs - np.mean(
        runs[:, [0, -1]]
    )  # estimators are products: a large mean would only add scatter

    def estimate(rows: Any) -> tuple[Array, ...]:
        first, exchanged, second = runs[rows, :1], runs[rows, 1:-1], runs[rows, -1:]
        variance = np.var(np.concatenate([first, second]))
        alone = np.mean(second * (exchanged - first), axis=0) / variance
        return alone, 0.5 * np.mean((first - exchanged) ** 2, axis=0) / variance

    return _estimate_with_ends(("first", "total"), len(runs), numbers, estimate)


def _elementary_effects(values: Array, y: Array) -> dict[str, Array]:
    numbers = values.shape[1]
    runs = y.reshape(-1, numbers + 1)
    steps = np.diff(values.reshape(-1, numbers + 1, numbers), axis=1)
    effects = np.zeros((len(runs), numbers))
    number = np.argmax(np.abs(steps) > 0.0, axis=2)
    signs = np.sign(np.take_along_axis(steps, number[:, :, None], axis=2)[:, :, 0])
    np.put_along_axis(
        effects, number, 2.0 * signs * np.diff(runs, axis=1), axis=1
    )  # a step spans half of the quantiles

    def estimate(rows: Any) -> tuple[Array, ...]:
        chosen = effects[rows]
        return (
            np.mean(np.abs(chosen), axis=0),
            np.mean(chosen, axis=0),
            np.std(chosen, axis=0, ddof=1),
        )

    names = ("mean_absolute_effect", "mean_effect", "effect_spread")
    return _estimate_with_ends(names, len(runs), numbers, estimate)


def _regression(x: Array, z: Array) -> dict[str, Array]:
    from scipy.stats import rankdata

    numbers, names = x.shape[1], ("regression", "rank_correlation")
    if not _varies(z):
        return {**dict.fromkeys(names, np.zeros(numbers)), "explained": np.array(0.0)}
    spread = np.std(x, axis=0)
    scaled = (x - np.mean(x, axis=0)) / np.where(spread > 0.0, spread, 1.0)
    target = (z - np.mean(z)) / np.std(z)
    ranks, of_target = rankdata(x, axis=0), rankdata(z)

    slopes = np.linalg.lstsq(scaled, target, rcond=None)[0]
    left = target - scaled @ slopes
    inverse = np.linalg.pinv(scaled.T @ scaled)
    errors = np.sqrt(np.diag(inverse @ (scaled * left[:, None] ** 2).T @ scaled @ inverse))
    ranks = rankdata(x, axis=0) - 0.5 * (len(x) + 1)
    of_target = rankdata(z) - 0.5 * (len(z) + 1)
    size = np.sqrt((ranks**2).sum(axis=0) * (of_target**2).sum())
    alike = (ranks * of_target[:, None]).sum(axis=0) / np.where(size > 0.0, size, 1.0)
    apart = NORMAL_95 * np.sqrt((1.0 + 0.5 * alike**2) / max(len(z) - 3, 1))
    turned = np.arctanh(np.clip(alike, -1.0 + 1e-15, 1.0 - 1e-15))
    return {
        "regression": slopes,
        "regression_low": slopes - NORMAL_95 * errors,
        "regression_high": slopes + NORMAL_95 * errors,
        "rank_correlation": alike,
        "rank_correlation_low": np.tanh(turned - apart),
        "rank_correlation_high": np.tanh(turned + apart),
        "explained": np.array(1.0 - np.var(left)),
    }


def _ends(x: Array, z: Array) -> dict[str, Array]:
    """Return the means of the metric over the fifth of the variants at either end of each parameter."""
    low, high = np.quantile(x, _END, axis=0), np.quantile(x, 1.0 - _END, axis=0)
    return {
        "at_low": np.array([np.mean(z[x[:, j] <= low[j]]) for j in range(x.shape[1])]),
        "at_high": np.array([np.mean(z[x[:, j] >= high[j]]) for j in range(x.shape[1])]),
    }
