"""Summary of many runs: statistics of every metric, bands over time, and reasons for missing runs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.errors import DescriptionError, unknown
from jounce.core.findings import Finding, finding
from jounce.core.serialise import Plain
from jounce.variants.designs import DESIGNS
from jounce.variants.findings import findings_of_variants
from jounce.variants.sensitivity import metrics_of, numbers_of, sensitivity_indices

if TYPE_CHECKING:
    import xarray as xr

_PERCENTILES = (5.0, 50.0, 95.0)  # by default
_MOST_REASONS = 20  # different reasons listed at most
_LITTLE = 0.7  # share of the variance below which a finding reports that the linear regression explains little


@dataclass(frozen=True)
class MetricSummary(Plain):
    """Statistics of a metric over all variants that ran, SI.

    Attributes
    ----------
    name, unit : str
        Metric and its SI unit.
    mean, standard_deviation : float
        Mean and standard deviation over the variants.
    least, greatest : float
        Minimum and maximum.
    least_at, greatest_at : int
        Numbers of the variants with the minimum and the maximum.
    percentiles : dict
        5th, 50th and 95th percentile, each with the ends of its 95 % confidence interval; None if there are too few
        variants.
    """

    name: str
    unit: str
    mean: float
    standard_deviation: float
    least: float
    least_at: int
    greatest: float
    greatest_at: int
    percentiles: dict[str, dict[str, Any]]


@dataclass(frozen=True)
class Influence(Plain):
    """Sensitivity of a metric to a parameter.

    Attributes
    ----------
    metric, number : str
        Metric, and path of the parameter.
    measures : dict
        Every measure of :func:`sensitivity_indices` with the ends of its 95 % interval, if available.
    """

    metric: str
    number: str
    measures: dict[str, Any]


@dataclass(frozen=True)
class Summary(Plain):
    """Statistics of many runs.

    Attributes
    ----------
    count, ran, side_by_side : int
        Number of variants in total, of those that ran, and of those that ran in vector registers.
    numbers : dict
        Path of each varied parameter to its minimum, maximum and SI unit.
    metrics : tuple of MetricSummary
        Statistics of every metric.
    influences : tuple of Influence
        Sensitivities of each metric; empty if too few variants ran.
    failed : dict
        Reason to the number of variants without a run, and the first of these variants.
    findings : tuple of Finding
        Warnings about the results.
    """

    count: int
    ran: int
    side_by_side: int
    numbers: dict[str, dict[str, Any]]
    metrics: tuple[MetricSummary, ...]
    influences: tuple[Influence, ...]
    failed: dict[str, dict[str, int]]
    findings: tuple[Finding, ...]


def summarise(many: xr.Dataset) -> Summary:
    """Summarise many runs; beyond the first twenty, reasons of missing runs are combined."""
    reasons = many["reason"].to_numpy()
    failed: dict[str, dict[str, int]] = {}
    for row in np.flatnonzero(reasons != ""):
        text = str(reasons[row])
        if text not in failed and len(failed) >= _MOST_REASONS:
            text = "other reasons"
        failed.setdefault(text, {"variants": 0, "first": int(many["variant"][row])})[
            "variants"
        ] += 1
    ran = int(np.sum(reasons == ""))
    count = int(many.attrs.get("variants", len(reasons)))
    numbers = {}
    for path in numbers_of(many):
        ends = {"least": float(many[path].min()), "greatest": float(many[path].max())}
        numbers[path] = {**ends, "unit": str(many[path].attrs["units"])}
    columns = many.data_vars.values()
    has_metrics = any(
        column.dims == ("variant",) and column.dtype.kind in "fi" for column in columns
    )
    names = metrics_of(many) if has_metrics and ran else []
    influences, findings = _influences(many, names) if numbers and names else ((), list[Finding]())
    if names and many.attrs.get("design") == "morris":
        findings.append(finding("variants.points_on_trajectories", "statistics"))
    if failed:
        lost = len(reasons) - ran
        findings.insert(
            0, finding("variants.without_run", "variants", lost, lost=lost, all=len(reasons))
        )
    outside = int(many.attrs.get("outside", 0))
    if outside and many.attrs.get("design") in DESIGNS.keys() - {"grid"}:
        share = outside / len(reasons)
        findings.append(finding("variants.cut_off", "spreads", share, share=share))
    findings += findings_of_variants(many.attrs, ran)
    metrics = tuple(_metric(many, name) for name in names)
    side_by_side = int(many.attrs.get("side_by_side", 0))
    return Summary(count, ran, side_by_side, numbers, metrics, influences, failed, tuple(findings))


def _metric(many: xr.Dataset, name: str) -> MetricSummary:
    values = many[name].to_numpy()
    variants = many["variant"].to_numpy()
    good = np.flatnonzero(np.isfinite(values))
    metric = values[good]
    low, high = good[np.argmin(metric)], good[np.argmax(metric)]
    percentiles = {f"{level:g}": _percentile(np.sort(metric), level) for level in _PERCENTILES}
    unit = str(many[name].attrs.get("units", "1"))
    spread = float(np.std(metric, ddof=1)) if len(metric) > 1 else 0.0
    return MetricSummary(
        name, unit, float(np.mean(metric)), spread, float(values[low]), int(variants[low]), float(values[high]),
        int(variants[high]), percentiles,
    )  # fmt: skip


def _percentile(ordered: np.ndarray, level: float) -> dict[str, Any]:
    """Return a percentile with its distribution-free 95 % interval from order statistics."""
    from scipy.stats import binom

    count, share = len(ordered), level / 100.0
    low = int(binom.ppf(0.025, count, share)) - 1
    high = int(binom.ppf(0.975, count, share))
    interval = [float(ordered[low]), float(ordered[high])] if low >= 0 and high < count else None
    return {"value": float(np.percentile(ordered, level)), "interval": interval}


def _influences(
    many: xr.Dataset, names: Sequence[str]
) -> tuple[tuple[Influence, ...], list[Finding]]:
    try:
        indices = sensitivity_indices(many, names)
    except DescriptionError as error:
        return (), [finding("variants.dependencies_unknown", "sensitivity", error=error.what)]
    influences, findings = [], []
    measures = [
        str(name) for name in indices.data_vars if not str(name).endswith(("_low", "_high"))
    ]
    for metric in names:
        for number in map(str, indices["number"].to_numpy()):
            at = indices.sel(metric=metric, number=number)
            measured = {name: _measure(at, name) for name in measures if name != "explained"}
            ends = {name: float(at[name]) for name in ("at_low", "at_high") if name in at}
            influences.append(Influence(metric, number, {**measured, **ends}))
        explained = (
            float(indices["explained"].sel(metric=metric)) if "explained" in indices else 1.0
        )
        if explained < _LITTLE:
            findings.append(
                finding("variants.lines_explain_little", metric, explained, explained=explained)
            )
    if indices.attrs["left_out"] and indices.attrs["design"] in ("morris", "saltelli"):
        findings.append(
            finding(
                "variants.variants_left_out",
                "sensitivity",
                indices.attrs["left_out"],
                count=indices.attrs["left_out"],
            )
        )
    return tuple(influences), findings


def _measure(at: xr.Dataset, name: str) -> dict[str, Any]:
    ends = [float(at[f"{name}_{end}"]) for end in ("low", "high")] if f"{name}_low" in at else None
    return {"value": float(at[name]), "interval": ends}


def bands(
    many: xr.Dataset, channel: str, percentiles: Sequence[float] = _PERCENTILES
) -> xr.DataArray:
    """Return percentiles of a channel over the variants at every time.

    The band between two percentiles contains the corresponding share of variants at each time; a percentile is in
    general not a single run.

    Parameters
    ----------
    many : xarray.Dataset
        Dataset with the channel on ``variant`` and ``time`` (``outputs=`` of :func:`simulate_many`).
    channel : str
        Name of the channel.
    percentiles : sequence of float
        Percentiles in percent, 0 to 100.

    Returns
    -------
    xarray.DataArray
        Percentiles on ``percentile`` (percent) and ``time`` (s), in the channel's SI unit; variants without a run are
        skipped.

    Raises
    ------
    DescriptionError
        For a channel that was not stored over time, or invalid percentiles.

    Examples
    --------
    >>> import jounce as jn
    >>> rig = jn.load("audi-a6-quarter-car")
    >>> trial = jn.Trial(road=jn.HalfSine(height="10 mm", length="1 m"), speed="10 m/s", duration="1 s")
    >>> many = jn.simulate_many(rig, trial, jn.sobol({"sprung.mass": "10 %"}, 16), outputs="sprung.z")
    >>> band = jn.bands(many, "sprung.z")
    >>> bool((band.sel(percentile=5) <= band.sel(percentile=95)).all())
    True
    """
    import xarray as xr

    known = [
        str(name)
        for name, variable in many.data_vars.items()
        if variable.dims == ("variant", "time")
    ]
    if channel not in known:
        raise unknown(channel, known, what="channel over time", where="channel")
    levels = np.asarray(percentiles, dtype=float)
    if levels.ndim != 1 or not len(levels) or not np.all((levels >= 0.0) & (levels <= 100.0)):
        raise DescriptionError(
            "invalid percentiles", where="percentiles", found=percentiles, allowed="0 to 100"
        )
    values = many[channel].to_numpy()
    values = values[np.all(np.isfinite(values), axis=1)]
    if not len(values):
        raise DescriptionError("no variant has a completed run", where=channel)
    about: Mapping[Any, Any] = many[channel].attrs
    return xr.DataArray(
        np.percentile(values, levels, axis=0),
        {"percentile": levels, "time": many["time"]},
        ("percentile", "time"),
        channel,
        about,
    )
