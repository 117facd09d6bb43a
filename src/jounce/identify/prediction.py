"""Predictions of a posterior for trials: bands with the measured curves, each draw simulated exactly."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.identify.densities import Basis, DoubtDensity, NoiseDensity
from jounce.identify.discrepancy import extended_runs
from jounce.identify.fit_problem import Channel, FitTrial, FreeParameter, prepare_trial
from jounce.identify.lags import Shifted, best_lag
from jounce.identify.settings import UpdateSettings
from jounce.recordings import estimate_lag
from jounce.recordings.signals import shift_signals

if TYPE_CHECKING:
    import xarray as xr

RICHER = "richer value of "
"""Prefix of the path for draws of a parameter of the extended model."""
_TOLERANCE = 1e-6  # of displacements, far below what draws differ by
_TWO_SIDED = 1.959963984540054  # standard deviations to either side of a 95 % interval
_APART = 0.02  # s by which the lag of a draw may differ from that of their mean
_AROUND = 0.05  # s over which the level of a signal is taken


@dataclass(frozen=True)
class PredictionBand(Shown):
    """Prediction and measurement of one channel of one trial; SI.

    Attributes
    ----------
    time : ndarray, shape (samples,)
        Time, s.
    measured, mean : ndarray, shape (samples,)
        Recording, and mean of the draws, in the channel's unit.
    parameters : ndarray, shape (samples,)
        Standard deviation due to parameters (and doubts), same unit.
    whole : ndarray, shape (samples,)
        Standard deviation including noise and, with model error, the unexplained residual, same unit.
    inside : float
        Share (1) of the recording within the 95 % band of ``whole``.
    is_fitted : bool
        Whether the trial was fitted.
    unit : str
        SI unit.
    """

    time: Array
    measured: Array
    mean: Array
    parameters: Array
    whole: Array
    inside: float
    is_fitted: bool
    unit: str

    def ends(self, *, whole: bool = True) -> tuple[Array, Array]:
        """Return lower and upper end of the 95 % band, total or due to the parameters only."""
        half = _TWO_SIDED * (self.whole if whole else self.parameters)
        return self.mean - half, self.mean + half


def bands_of(
    density: NoiseDensity | DoubtDensity, basis: Basis, samples: xr.Dataset, trials: Sequence[FitTrial],
    count: int, seed: int,
) -> dict[str, dict[str, PredictionBand]]:  # fmt: skip
    """Predict every channel of the given trials, with ``count`` draws each."""
    free = basis.free
    by = RICHER if isinstance(density, DoubtDensity) else ""
    law = np.column_stack([samples[f"{by}{item.path}"].to_numpy().ravel() for item in free])
    rows = np.random.default_rng([seed, 9]).choice(len(law), min(count, len(law)), replace=False)
    law = law[rows]
    fitted = {trial.name for trial in basis.trials}
    if isinstance(density, DoubtDensity):
        scaled = np.array(
            [[item.scale(v) for item, v in zip(free, row, strict=True)] for row in law]
        )
        curves = _richer(density, trials, scaled, seed, basis.settings)
    else:
        curves = [_plain(trial, free, law, basis.settings) for trial in trials]
    noise, rest = _levels(basis, density)
    bands: dict[str, dict[str, PredictionBand]] = {}
    for trial, channels in zip(trials, curves, strict=True):
        time = trial.measured["time"].to_numpy()
        for channel, simulated, unit in channels:
            name, measured = channel.name, channel.measured
            mean, spread = simulated.mean(axis=0), simulated.std(axis=0, ddof=1)
            level = _moving(mean - mean[0], time)
            whole = np.sqrt(spread**2 + noise.get(name, 0.0) ** 2 + rest.get(name, 0.0) * level**2)
            inside = float(np.mean(np.abs(measured - mean) <= _TWO_SIDED * whole))
            band = PredictionBand(
                time, measured, mean, spread, whole, inside, trial.name in fitted, unit
            )
            bands.setdefault(trial.name, {})[name] = band
    return bands


_Curves = list[tuple[Channel, Array, str]]
"""Channels, their simulated readings for every draw (draws, samples), and units."""


def _plain(
    trial: FitTrial, free: Sequence[FreeParameter], law: Array, settings: UpdateSettings
) -> _Curves:
    """Simulate a trial for each draw."""
    prepared = prepare_trial(trial, free, settings)
    names = prepared.compiled.facts.parameters
    places = [names.index(path) for path in prepared.compiled.free]
    plain = replace(prepared, compiled=prepared.compiled.plain)
    tables: dict[str, list[Array]] = {channel.name: [] for channel in prepared.channels}
    for values in law:
        start = prepared.start.copy()
        start[places] = prepared.own(values)
        run = replace(plain, start=start)
        solution = run.solve(np.zeros(0), _TOLERANCE)
        for channel in run.channels:
            table = run.table(channel, solution)
            tables[channel.name].append(channel.offset(table, np.zeros(len(table)))[0][:, 0])
    units = {output.name: output.unit for output in prepared.compiled.facts.outputs}
    return _lay_over_recording(
        prepared.channels, tables, units, prepared.rate, align=settings.fits_lags
    )


def _richer(
    density: DoubtDensity,
    trials: Sequence[FitTrial],
    scaled: Array,
    seed: int,
    settings: UpdateSettings,
) -> list[_Curves]:
    """Simulate a trial for each draw, with random model and measurement errors."""
    doubts = density.doubts(scaled, seed)
    curves: list[_Curves] = []
    for run in extended_runs(density.fit, trials):
        tables: dict[str, list[Array]] = {}
        rng = np.random.default_rng([seed, 10, len(curves)])
        for x, step in zip(scaled, doubts, strict=True):
            for name, table in run.draw(x, step, rng).items():
                tables.setdefault(name, []).append(table)
        curves.append(
            _lay_over_recording(run.channels, tables, run.units, run.rate, align=settings.fits_lags)
        )
    return curves


def _lay_over_recording(
    channels: Sequence[Channel], tables: Mapping[str, list[Array]], units: Mapping[str, str], rate: float, *,
    align: bool,
) -> _Curves:  # fmt: skip
    """Align draws with a recording, each with its best-fitting lag if lags are fitted, as in the update."""
    laid = {channel.name: np.array(tables[channel.name]) for channel in channels}
    if align:
        most = max(channels, key=lambda channel: float(np.std(channel.measured)))
        late = float(estimate_lag(laid[most.name].mean(axis=0), most.measured, rate))
        laid = {
            name: np.array(shift_signals(table.T, rate, late).T) for name, table in laid.items()
        }
        for k in range(len(laid[most.name])):
            shifted = [
                Shifted.of(
                    c.measured,
                    laid[c.name][k][:, None],
                    c.weight,
                    rate,
                    offset=c.datum == "free offset",
                )
                for c in channels
            ]
            lag = best_lag(shifted, _APART)
            for channel, signal in zip(channels, shifted, strict=True):
                laid[channel.name][k] = signal.at(lag)[0][:, 0]
    return [(channel, laid[channel.name], units[channel.name]) for channel in channels]


def _levels(
    basis: Basis, density: NoiseDensity | DoubtDensity
) -> tuple[Mapping[str, float], dict[str, float]]:
    """Return the noise of each channel (SI), and the unexplained part as a share (1) of the signal's power."""
    if not isinstance(density, DoubtDensity):
        return basis.noise, {}
    fit = density.fit
    return {name: float(np.sqrt(value)) for name, value in fit.step.noise.items()}, fit.rest


def _moving(signal: Array, time: Array) -> Array:
    """Return the root mean square of a signal around each instant; over a shorter window near its ends."""
    width = max(1, min(round(_AROUND / max(float(np.median(np.diff(time))), 1e-9)), len(signal)))
    total, count = (
        np.convolve(values, np.ones(width), mode="same")
        for values in (signal**2, np.ones(len(signal)))
    )
    return np.asarray(np.sqrt(total / count))
