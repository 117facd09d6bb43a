"""All results of a campaign, for tables and files."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from jounce.campaign.belt import TrialOnBelt
from jounce.campaign.beside_reference import beside_reference
from jounce.campaign.characterise import Characterisation
from jounce.campaign.description import Campaign
from jounce.campaign.first_look import FirstLook
from jounce.campaign.strategy_result import StrategyResult
from jounce.campaign.trial_result import TrialResult
from jounce.core.findings import Finding
from jounce.core.results import group_table
from jounce.core.serialise import to_plain
from jounce.core.shown import Shown
from jounce.design.model_comparison import ModelComparison
from jounce.identify.passages import Sought
from jounce.parts import Rig

if TYPE_CHECKING:
    import xarray as xr


@dataclass(frozen=True)
class CampaignResult(Shown):
    """Outcome of a campaign.

    Attributes
    ----------
    campaign : Campaign
        Campaign that was run.
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
        Findings for the reader; failures have the severity ``problem``.
    lumped : ModelComparison or None
        For a 3-D rig: differences from its equivalent quarter car, with the values of the last update.
    poses : dict
        For a 3-D rig: poses over the wheel travel by strut angle of the trials (rad; None if not given), as returned by
        :func:`jounce.sweep_travel` with ``points``.
    look : FirstLook
        Statistics, spectra and modes of the records, compared with those of the model's readings.
    sought : dict
        Details of the unsuccessful obstacle search by trial number.
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
    look: FirstLook = field(default_factory=FirstLook)
    sought: Mapping[int, Sought] = field(default_factory=dict)

    def __str__(self) -> str:
        updates = [strategy.update for strategy in self.strategies]
        tables = [group_table("Updates", updates)] if updates else []
        tables += [
            group_table(f"Parameters of {update.name}", update.parameters) for update in updates
        ]
        compared = {
            f"{trial.entry.number} {trial.entry.use}, {name}": channel
            for trial in self.trials
            if trial.after is not None
            for name, channel in trial.after.channels.items()
        }
        tables += [group_table("Trials", compared)] if compared else []
        return "\n\n".join(
            [self.campaign.title, *map(str, tables), "\n".join(map(str, self.findings))]
        )

    @property
    def is_complete(self) -> bool:
        """Whether nothing failed."""
        return not any(finding.severity == "problem" for finding in self.findings)

    def to_dict(self) -> dict[str, Any]:
        """Return the plain data of ``results.json``, SI, without curves."""
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
            "records": self.look.to_dict(),
            "lumped": None if self.lumped is None else self.lumped.to_dict(),
            **(
                {
                    "reference": to_plain(
                        beside_reference(self.campaign.reference, self.strategies, self.trials)
                    )
                }
                if self.campaign.reference
                else {}
            ),
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
        "objective_by_channel": {
            name: {"before": pair[0], "after": pair[1]} for name, pair in split.items()
        },
        "comparisons": [
            {
                "number": t.number,
                "is_fitted": t.is_fitted,
                "before": to_plain(t.before),
                "after": to_plain(t.after),
            }
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
        "before": {"channels": to_plain(before.channels), "verdict": before.verdict}
        if before
        else None,
        **({"belt": _belt(trial.belt)} if trial.belt else {}),
    }


def _belt(on_belt: TrialOnBelt) -> dict[str, Any]:
    passages = on_belt.passages
    return {
        "noted_speed": on_belt.noted,
        "pulse_speed": on_belt.pulses,
        "speed": on_belt.speed,
        "slip": on_belt.slip,
        "passages": list(passages.times),
        "period": passages.period,
        "repeatability": passages.repeatability,
        "odd": list(passages.odd),
    }
