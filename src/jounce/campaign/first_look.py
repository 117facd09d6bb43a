"""A first look at a campaign's records: statistics of channels, transfer functions between them, and modes.

Trials of one set-up are combined. Each passes an obstacle from rest to rest, or is one loop of the belt, so the whole
record is one segment without a window; the coherence shows how well the trials agree. The model's readings of the same
trials are analysed in the same way, so resolution, window and dry friction affect measurement and model alike.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import ParamSpec, TypeVar

import numpy as np
import xarray as xr

from jounce.analysis.modes import FittedModes, fit_modes, oscillating
from jounce.analysis.record import Measured, from_recording
from jounce.analysis.spectrum import RecordSpectra, estimate_spectra
from jounce.analysis.statistics import ChannelStatistics, describe_channels
from jounce.analysis.transfer import TransferEstimate, estimate_transfer, sliding_model
from jounce.campaign.characterise import Characterisation
from jounce.campaign.description import Campaign
from jounce.campaign.trial_result import Signals, TrialResult
from jounce.core.errors import JounceError
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.identify.estimate import Estimate
from jounce.parts import Rig
from jounce.recordings import channel_unit
from jounce.recordings.quality import clipped_share
from jounce.recordings.schema import recording_of

_PAIRS = (("unsprung.az", "sprung.az"), ("unsprung.z", "sprung.z"))
"""Input and output of the transfer function: from the wheel to the body."""
_HIGHEST = 40.0  # Hz: above wheel hop, even of the kart prototype (28 Hz)
_MOST_SETUPS = 8  # those with most trials; each adds rows to the report and an analysis to the time
_NEAR = 1.5  # factor of frequency between a mode of the records and one of the model's readings
_EVEN = 1e-3  # of a step
_Arguments = ParamSpec("_Arguments")
_Result = TypeVar("_Result")


@dataclass(frozen=True)
class TrialStatistics(Plain):
    """Statistics of a trial's recorded channels, and the fraction (1) of clipped samples of each channel."""

    number: int
    channels: tuple[ChannelStatistics, ...]
    clipped: Mapping[str, float]


@dataclass(frozen=True)
class ComparedMode(Plain):
    """A mode of the records, compared with the linear model and, for trials, the same fit to the model's readings.

    ``trials`` are the numbers of one set-up; ``decay`` names a free decay by its position among the files. Undamped
    natural frequencies are in Hz, damping ratios in 1. The linear model and the damping of a decay exclude dry
    friction; the damping of trials includes it. Values are None if the model, or the fit to its readings, has no such
    mode.
    """

    trials: tuple[int, ...]
    decay: str
    frequency: Estimate
    damping_ratio: Estimate
    model_frequency: float | None = None
    model_damping_ratio: float | None = None
    readings_frequency: float | None = None
    readings_damping_ratio: float | None = None


@dataclass(frozen=True)
class ComparedSpectra(Plain):
    """Spectra and transfer functions of the trials of one set-up, for the measurement and the model's readings.

    The transfer functions are None for a single trial, whose coherence would always be 1.
    """

    left_out = ("measured", "simulated", "transfer", "model_transfer")
    trials: tuple[int, ...]
    pressure: float | None
    angle: float | None
    measured: RecordSpectra
    simulated: RecordSpectra
    transfer: TransferEstimate | None = None
    model_transfer: TransferEstimate | None = None


@dataclass(frozen=True)
class FirstLook(Plain):
    """Statistics of every trial, spectra of one set-up at each pressure, and modes of decays and set-ups."""

    left_out = ("spectra",)
    statistics: tuple[TrialStatistics, ...] = ()
    spectra: tuple[ComparedSpectra, ...] = ()
    modes: tuple[ComparedMode, ...] = ()


def first_look(
    campaign: Campaign,
    bench: Characterisation,
    rig: Rig,
    records: Mapping[int, xr.Dataset],
    trials: Sequence[TrialResult],
) -> FirstLook:
    """Analyse the records of a campaign, and compare decays with a rig and trials with their model.

    ``records`` are the trials as read, by number. Records that cannot be analysed, e.g. because of gaps, are left out.
    """
    set_ups = _set_ups(trials)
    statistics = [_try_analysis(_statistics, number, run) for number, run in records.items()]
    spectra = [_try_analysis(_spectra, shared) for shared in _one_at_each_pressure(set_ups)]
    modes = _try_analysis(_decay_modes, campaign, bench, rig) or []
    for shared in set_ups[:_MOST_SETUPS]:
        modes += _try_analysis(_free_modes, shared) or []
    return FirstLook(
        tuple(item for item in statistics if item is not None),
        tuple(item for item in spectra if item is not None),
        tuple(modes),
    )


def _try_analysis(
    analyse: Callable[_Arguments, _Result], *given: _Arguments.args, **named: _Arguments.kwargs
) -> _Result | None:
    try:
        return analyse(*given, **named)
    except (
        JounceError,
        ArithmeticError,
        ValueError,
    ):  # numerics of one record never lose the campaign
        return None


def _statistics(number: int, run: xr.Dataset) -> TrialStatistics:
    used = from_recording(run, f"trial {number}")
    channels = describe_channels(used).channels
    return TrialStatistics(
        number, channels, {row.channel: clipped_share(used.values(row.channel)) for row in channels}
    )


def _set_ups(trials: Sequence[TrialResult]) -> list[list[TrialResult]]:
    """Group compared trials by rig, channels and sample rate; the largest groups come first."""
    by_rig: dict[tuple[str, tuple[str, ...], int], list[TrialResult]] = {}
    for trial in trials:
        if trial.motion is None or not trial.signals or trial.motion.trial.road is None:
            continue
        steps = np.diff(next(iter(trial.signals.values())).time)
        if trial.motion.trial.road.is_course() or np.ptp(steps) > _EVEN * steps.mean():
            continue
        key = (
            trial.motion.rig.model_dump_json(),
            tuple(trial.signals),
            round(1.0 / float(steps.mean())),
        )
        by_rig.setdefault(key, []).append(trial)
    return sorted(by_rig.values(), key=lambda shared: -len(shared))


def _one_at_each_pressure(set_ups: Sequence[list[TrialResult]]) -> list[list[TrialResult]]:
    chosen: dict[float | None, list[TrialResult]] = {}
    for shared in set_ups:
        chosen.setdefault(shared[0].entry.tyre_pressure, shared)
    return list(chosen.values())


_READINGS: dict[str, Callable[[Signals], Array]] = {
    "measured": lambda signals: signals.measured,
    "simulated": lambda signals: signals.simulated,
}


def _spectra(shared: Sequence[TrialResult]) -> ComparedSpectra:
    pair = next((pair for pair in _PAIRS if set(pair) <= set(shared[0].signals)), None)
    names = list(shared[0].signals) if pair is None else list(pair)
    records = [_end_to_end(shared, names, which) for which in _READINGS.values()]
    length = records[0].run.sizes["time"] / records[0].rate / len(shared)
    band = 1.0 / length, min(_HIGHEST, 0.5 * records[0].rate)
    spectra = [
        estimate_spectra(run, names, band=band, segment=length, window="boxcar") for run in records
    ]
    transfers: list[TransferEstimate | None] = [None, None]
    if pair is not None and len(shared) > 1:
        given, output = pair
        transfers = [
            estimate_transfer(run, output, given, band=band, segment=length, window="boxcar")
            for run in records
        ]
    numbers, entry = tuple(trial.entry.number for trial in shared), shared[0].entry
    return ComparedSpectra(
        numbers, entry.tyre_pressure, entry.strut_angle, spectra[0], spectra[1], *transfers
    )


def _end_to_end(
    shared: Sequence[TrialResult], names: Sequence[str], which: Callable[[Signals], Array]
) -> Measured:
    """Concatenate readings of trials, each cut to the length of the shortest."""
    samples = min(len(trial.signals[names[0]].time) for trial in shared)
    joined = {
        name: np.concatenate([which(trial.signals[name])[:samples] for trial in shared])
        for name in names
    }
    return _uniform(joined, {name: channel_unit(name) for name in names}, _step(shared))


def _uniform(channels: Mapping[str, Array], units: Mapping[str, str], step: float) -> Measured:
    time = step * np.arange(len(next(iter(channels.values()))))
    return from_recording(
        recording_of(time, {name: (values, units[name], "") for name, values in channels.items()}),
        "trials",
    )


def _step(shared: Sequence[TrialResult]) -> float:
    time = next(iter(shared[0].signals.values())).time
    return float(time[-1] - time[0]) / (len(time) - 1)


def _free_modes(shared: Sequence[TrialResult]) -> list[ComparedMode]:
    """Fit the common modes of all trials of a set-up to their free vibrations."""
    assert shared[0].motion is not None
    numbers = tuple(trial.entry.number for trial in shared)
    rig = shared[0].motion.rig
    measured, simulated = (
        _fit_modes(_free_parts(shared, which), rig) for which in _READINGS.values()
    )
    if measured is None:
        return []
    theirs = () if simulated is None else simulated.modes
    known = [(other.frequency.value, other.damping_ratio.value) for other in theirs]
    return [
        ComparedMode(
            numbers,
            "",
            mode.frequency,
            mode.damping_ratio,
            mode.model_frequency,
            mode.model_damping_ratio,
            *_nearest(mode.frequency.value, known),
        )
        for mode in measured.modes
    ]


def _fit_modes(run: Measured, rig: Rig) -> FittedModes | None:
    return _try_analysis(fit_modes, run, decay=True, rig=rig, count=2)


def _free_parts(shared: Sequence[TrialResult], which: Callable[[Signals], Array]) -> Measured:
    """Collect the readings of each trial after its last obstacle and last loss of contact as channels of one record."""
    parts: dict[str, Array] = {}
    for trial in shared:
        begin = _set_free(trial)
        for name, signals in trial.signals.items():
            first = int(np.searchsorted(signals.time, begin))
            parts[f"trial_{trial.entry.number}.{name}"] = which(signals)[first:]
    samples = min(len(values) for values in parts.values())
    units = {name: channel_unit(name.partition(".")[2]) for name in parts}
    return _uniform(
        {name: values[:samples] for name, values in parts.items()}, units, _step(shared)
    )


def _set_free(trial: TrialResult) -> float:
    """Return the instant (s) after which a trial is not excited and its tyre stays on the road."""
    motion = trial.motion
    assert motion is not None
    begin = motion.trial.obstacle_end()
    force = motion.outputs.get("tyre.force")
    if force is not None:
        begin = max(begin, float(motion.time[np.flatnonzero(force <= 0.0)].max(initial=begin)))
    return begin


def _nearest(
    frequency: float, modes: Sequence[tuple[float, float]]
) -> tuple[float | None, float | None]:
    """Return frequency (Hz) and damping ratio (1) of the mode nearest to a frequency; None if no mode is near."""
    nearest = min(modes, key=lambda mode: abs(math.log(mode[0] / frequency)), default=None)
    near = nearest is not None and 1.0 / _NEAR < nearest[0] / frequency < _NEAR
    return nearest if near and nearest is not None else (None, None)


def _decay_modes(campaign: Campaign, bench: Characterisation, rig: Rig) -> list[ComparedMode]:
    """Return the mode of each free decay, with the rig's mode for comparison if the wheel is on its tyre."""
    table = campaign.bench.decay
    if table is None or not bench.decays:
        return []
    modes = oscillating(np.linalg.eigvals(sliding_model(rig).A)) if table.support == "tyre" else []
    return [
        ComparedMode(
            (),
            f"decay {number}",
            decay.natural_frequency_hz,
            decay.damping_ratio,
            *_nearest(decay.natural_frequency_hz.value, modes),
        )
        for number, decay in enumerate(bench.decays, 1)
    ]
