"""Everything a campaign found, ready for tables, pictures and files."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from jounce.campaign.characterise import Characterisation
from jounce.campaign.description import Campaign, TrialEntry
from jounce.campaign.setup import Knowledge
from jounce.campaign.validation import Signals, TrialComparison
from jounce.core.findings import Finding
from jounce.core.serialise import to_plain
from jounce.design.model_comparison import ModelComparison
from jounce.identify.update import UpdateResult
from jounce.parts import Rig


@dataclass(frozen=True)
class StrategyResult:
    """One update with the knowledge after it and the trials it was fitted on."""

    update: UpdateResult
    knowledge: Knowledge
    fitted_on: tuple[int, ...]
    rig_text: str


@dataclass(frozen=True)
class TrialResult:
    """One trial: before (characterised model) and after (last update); None where a recording could not be used.

    ``obstacle_pitch`` is the distance of the obstacles of a train in m, None for a single one.
    """

    entry: TrialEntry
    obstacle_pitch: float | None
    before: TrialComparison | None
    after: TrialComparison | None
    signals_before: dict[str, Signals]
    signals: dict[str, Signals]


@dataclass(frozen=True)
class CampaignResult:
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
        For a 3-D rig: where the quarter car it amounts to differs from it, with the values of the last update.
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
            "characterisation": to_plain(
                {
                    "spring": _stiffness(bench.spring),
                    "tyre": {name: _stiffness(result) for name, result in bench.tyre.items()},
                    "pressure": bench.pressure,
                    "decay": _decay(bench.decay),
                    "replaced": bench.replaced,
                }
            ),
            "updates": [_update(strategy) for strategy in self.strategies],
            "trials": [_trial(trial) for trial in self.trials],
            "lumped": None if self.lumped is None else self.lumped.to_dict(),
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
    keys = ("damping_ratio", "damping_coefficient", "coulomb_force", "natural_frequency_hz", "equilibrium")
    return {key: to_plain(getattr(result, key)) for key in keys if hasattr(result, key)}


def _update(strategy: StrategyResult) -> dict[str, Any]:
    plain: dict[str, Any] = to_plain(strategy.update)
    plain["findings"] = to_plain(list(strategy.update.findings))
    return {**plain, "trials": list(strategy.fitted_on)}


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
    }
