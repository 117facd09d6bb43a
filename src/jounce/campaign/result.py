"""Everything a campaign found: trials against the model, channel by channel, and all results for tables and files."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np

from jounce.campaign.belt import TrialOnBelt
from jounce.campaign.characterise import Characterisation, Knowledge
from jounce.campaign.description import Campaign, TrialEntry
from jounce.campaign.reference import beside_reference
from jounce.core.findings import Finding
from jounce.core.results import Shows, group_table
from jounce.core.serialise import to_plain
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.design.model_comparison import ModelComparison
from jounce.identify.comparison import compare, iso18571
from jounce.identify.datum import with_datums
from jounce.identify.fit_problem import FitTrial, Simulated
from jounce.identify.update import UpdateResult
from jounce.parts import Rig
from jounce.recordings import estimate_lag
from jounce.roads import Trial

if TYPE_CHECKING:
    import xarray as xr


HOLDS, PARTLY, FAILS = "holds", "holds partly", "does not hold"
_GOOD, _FAIR = 0.80, 0.58  # ISO/TS 18571 grades
CLOSE, LOOSE = 0.95, 0.75  # R2: a residual of 22 % and 50 % of the signal


@dataclass(frozen=True)
class ChannelComparison:
    """One channel of one trial: ``nrmse`` relative to the measured standard deviation, ``peak_error`` to its peak.

    ``objective`` is its part of Eq. 2: the sum of squared differences, in the square of the channel's unit.
    """

    nrmse: Annotated[float, Shows("NRMSE", "1", 2)]
    r2: Annotated[float, Shows("R²", "1", 4)]
    peak_error: Annotated[float, Shows("peak error", "%", 2)]
    iso18571: Annotated[float, Shows("ISO 18571", "1", 2)]
    grade: Annotated[str, Shows("grade")]
    lag: float
    objective: float


@dataclass(frozen=True)
class Signals:
    """Curves behind a comparison: time (s), measured and simulated reading (SI)."""

    time: Array
    measured: Array
    simulated: Array


@dataclass(frozen=True)
class TrialComparison:
    """One trial against the model: numbers and verdict (by its worst channel's ISO/TS 18571 rating and R2)."""

    channels: dict[str, ChannelComparison]
    verdict: str
    objective: float


@dataclass(frozen=True)
class TrialMotion:
    """What the model did in a trial: the rig as it was set up, and every output (SI) over time (s)."""

    rig: Rig
    trial: Trial
    time: Array
    outputs: Mapping[str, Array]


def compare_trial(
    trial: FitTrial, lag: float | None = 0.0
) -> tuple[TrialComparison, dict[str, Signals], list[Finding], TrialMotion]:
    """Simulate a trial and compare it with its recording, which lags by ``lag`` (s; None: estimated by correlation)."""
    (trial,), _ = with_datums([trial])
    model = Simulated(trial)
    if lag is None:
        lag = _lag(model.readings())
    curves = model.readings(lag)
    channels: dict[str, ChannelComparison] = {}
    signals: dict[str, Signals] = {}
    findings: list[Finding] = []
    for name, (time, measured, simulated) in curves.items():
        numbers = compare(measured, simulated, time, place=f"{trial.name}, {name}")
        rating = iso18571(measured, simulated, 1.0 / float(np.median(np.diff(time))), place=f"{trial.name}, {name}")
        channels[name] = ChannelComparison(
            numbers.nrmse,
            numbers.r2,
            numbers.peak_error,
            rating.rating,
            rating.grade,
            numbers.lag,
            float(np.sum((measured - simulated) ** 2)),
        )
        signals[name] = Signals(time, measured, simulated)
        findings += rating.findings
    objective = sum(channel.objective for channel in channels.values())
    motion = TrialMotion(trial.rig, trial.trial, trial.measured["time"].to_numpy(), model.outputs(lag))
    return TrialComparison(channels, verdict_of(channels), objective), signals, findings, motion


def verdict_of(channels: dict[str, ChannelComparison]) -> str:
    """Judge by the worst channel.

    ``holds``: ISO/TS 18571 above 0.80 (good) and R2 above 0.95; ``holds partly``: above 0.58 (fair) and 0.75. The
    rating alone forgives too much here: a record that is mostly at rest scores near 0.9 with a third of its motion
    missed.
    """
    rating = min(channel.iso18571 for channel in channels.values())
    explained = min(channel.r2 for channel in channels.values())
    if rating > _GOOD and explained > CLOSE:
        return HOLDS
    return PARTLY if rating > _FAIR and explained > LOOSE else FAILS


def _lag(curves: dict[str, tuple[Array, Array, Array]]) -> float:
    """Lag of the recording from its channel with the largest standard deviation in SI, an acceleration as a rule."""
    time, measured, simulated = max(curves.values(), key=lambda curve: float(np.std(curve[1])))
    return float(estimate_lag(simulated, measured, 1.0 / float(np.median(np.diff(time)))))


@dataclass(frozen=True)
class StrategyTrial:
    """One trial before and after one update, which was fitted on it (``is_fitted``) or not; None: it did not run."""

    number: int
    is_fitted: bool
    before: TrialComparison | None
    after: TrialComparison | None
    signals_before: dict[str, Signals]
    signals: dict[str, Signals]


@dataclass(frozen=True)
class StrategyResult(Shown):
    """One update: what was known before (``start``) and after it, the trials it was fitted on, and all compared.

    ``rig_texts`` are its rig files, one for each tyre pressure by its name; the name is empty where there is only one.
    ``truth`` has the values behind synthetic recordings, as a test machine would find them, by path (SI), where they
    stand beside the campaign.
    """

    update: UpdateResult
    start: Knowledge
    knowledge: Knowledge
    fitted_on: tuple[int, ...]
    rig_texts: dict[str, str] = field(default_factory=dict)
    trials: tuple[StrategyTrial, ...] = ()
    truth: dict[str, float] = field(default_factory=dict)

    def trial(self, number: int) -> StrategyTrial:
        """Give a trial before and after this update, by its number."""
        return next(trial for trial in self.trials if trial.number == number)

    def objective_by_channel(self) -> dict[str, tuple[float, float]]:
        """Split Eq. 2 over the trials it was fitted on, unweighted.

        Returns
        -------
        dict of str to (float, float)
            Channel to its sum of squared differences before and after, in the square of its SI unit: (m/s^2)^2.
        """
        fitted = [t for t in self.trials if t.is_fitted and t.before is not None and t.after is not None]
        split: dict[str, tuple[float, float]] = {}
        for trial in fitted:
            assert trial.before is not None
            assert trial.after is not None
            for name, after in trial.after.channels.items():
                before_sum, after_sum = split.get(name, (0.0, 0.0))
                split[name] = (before_sum + trial.before.channels[name].objective, after_sum + after.objective)
        return split


@dataclass(frozen=True)
class TrialResult(Shown):
    """One trial: before (characterised model) and after (last update); None where a recording could not be used.

    ``obstacle_pitch`` is the distance of the obstacles of a train in m, None for a single one. ``motion`` is that of
    the model after the last update, ``belt`` what was found of belt and passages where the record begins in motion.
    """

    entry: TrialEntry
    obstacle_pitch: float | None
    before: TrialComparison | None
    after: TrialComparison | None
    signals_before: dict[str, Signals]
    signals: dict[str, Signals]
    motion: TrialMotion | None = None
    belt: TrialOnBelt | None = None


@dataclass(frozen=True)
class CampaignResult(Shown):
    """Outcome of a campaign.

    Attributes
    ----------
    campaign : Campaign
        What was asked for.
    folder : Path
        Folder of the campaign file.
    rig, start : Rig
        As described, and with the characterised values.
    characterisation : Characterisation
        Bench results.
    strategies : tuple of StrategyResult
        Updates in order.
    trials : tuple of TrialResult
        Every trial, fitted and held out.
    findings : tuple of Finding
        What the reader must know; ``problem`` marks what failed.
    lumped : ModelComparison or None
        For a 3-D rig: where the equivalent quarter car differs from it, with the values of the last update.
    poses : dict
        For a 3-D rig: strut angle of its trials (rad; None where they give none) to poses over the wheel's travel, as
        :func:`jounce.sweep_travel` gives them with ``points``.
    """

    campaign: Campaign
    folder: Path
    rig: Rig
    start: Rig
    characterisation: Characterisation
    strategies: tuple[StrategyResult, ...]
    trials: tuple[TrialResult, ...]
    findings: tuple[Finding, ...]
    lumped: ModelComparison | None = None
    poses: Mapping[float | None, xr.Dataset] = field(default_factory=dict)

    def __str__(self) -> str:
        updates = [strategy.update for strategy in self.strategies]
        tables = [group_table("Updates", updates)] if updates else []
        tables += [group_table(f"Parameters of {update.name}", update.parameters) for update in updates]
        compared = {
            f"{trial.entry.number} {trial.entry.use}, {name}": channel
            for trial in self.trials
            if trial.after is not None
            for name, channel in trial.after.channels.items()
        }
        tables += [group_table("Trials", compared)] if compared else []
        return "\n\n".join([self.campaign.title, *map(str, tables), "\n".join(map(str, self.findings))])

    @property
    def is_complete(self) -> bool:
        """Whether nothing failed."""
        return not any(finding.severity == "problem" for finding in self.findings)

    def to_dict(self) -> dict[str, Any]:
        """Plain data of ``results.json``; SI, no curves."""
        bench = self.characterisation
        return {
            "schema": "jounce.results/1",
            "title": self.campaign.title,
            "synthetic": self.campaign.synthetic,
            "estimated": list(self.campaign.estimated),
            "characterisation": to_plain(
                {
                    "spring": _stiffness(bench.spring),
                    "tyre": {name: _stiffness(result) for name, result in bench.tyre.items()},
                    "pressure": bench.pressure,
                    "decay": _decay(bench.decay),
                    "damping_choices": bench.damping_choices,
                    "replaced": bench.replaced,
                }
            ),
            "updates": [_update(strategy) for strategy in self.strategies],
            "trials": [_trial(trial) for trial in self.trials],
            "lumped": None if self.lumped is None else self.lumped.to_dict(),
            **({"reference": to_plain(beside_reference(self))} if self.campaign.reference else {}),
            "findings": to_plain(list(self.findings)),
        }


def _stiffness(result: Any) -> Any:
    if result is None:
        return None
    keys = (
        "law",
        "stiffness",
        "intercept",
        "intercept_choice",
        "coefficients",
        "fitted_range",
        "r2",
        "repeatability",
        "loss_factor",
        "hysteresis_energy",
        "operating_deflection",
        "tangent_stiffness",
        "trials",
    )
    return {key: to_plain(getattr(result, key)) for key in keys}


def _decay(result: Any) -> Any:
    if result is None:
        return None
    keys = (
        "damping_ratio",
        "damping_coefficient",
        "coulomb_force",
        "quadratic_drag",
        "natural_frequency_hz",
        "equilibrium",
    )
    return {key: to_plain(getattr(result, key)) for key in keys if hasattr(result, key)}


def _update(strategy: StrategyResult) -> dict[str, Any]:
    plain: dict[str, Any] = to_plain(strategy.update)
    plain["findings"] = to_plain(list(strategy.update.findings))
    split = strategy.objective_by_channel()
    return {
        **plain,
        "trials": list(strategy.fitted_on),
        "truth": strategy.truth,
        "objective_by_channel": {name: {"before": pair[0], "after": pair[1]} for name, pair in split.items()},
        "comparisons": [
            {"number": t.number, "is_fitted": t.is_fitted, "before": to_plain(t.before), "after": to_plain(t.after)}
            for t in strategy.trials
        ],
    }


def _trial(trial: TrialResult) -> dict[str, Any]:
    after, before = trial.after, trial.before
    return {
        "number": trial.entry.number,
        "use": trial.entry.use,
        "speed": trial.entry.speed,
        "obstacle_pitch": trial.obstacle_pitch,
        "channels": to_plain(after.channels) if after else {},
        "verdict": after.verdict if after else "not usable",
        "objective": to_plain(after.objective) if after else None,
        "before": {"channels": to_plain(before.channels), "verdict": before.verdict} if before else None,
        **({"belt": _belt(trial.belt)} if trial.belt else {}),
    }


def _belt(found: TrialOnBelt) -> dict[str, Any]:
    passages = found.passages
    return {
        "noted_speed": found.noted,
        "pulse_speed": found.pulses,
        "speed": found.speed,
        "slip": found.slip,
        "passages": list(passages.times),
        "period": passages.period,
        "repeatability": passages.repeatability,
        "odd": list(passages.odd),
    }
