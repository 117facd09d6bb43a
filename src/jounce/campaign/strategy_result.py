"""Updates with the knowledge before and after them, and the comparison of all trials."""

from __future__ import annotations

from dataclasses import dataclass, field

from jounce.campaign.characterise import Knowledge
from jounce.campaign.trial_result import Signals, TrialComparison
from jounce.core.shown import Shown
from jounce.identify.update import UpdateResult


@dataclass(frozen=True)
class StrategyTrial:
    """One trial before and after one update, fitted or held out (``is_fitted``); None if the simulation failed."""

    number: int
    is_fitted: bool
    before: TrialComparison | None
    after: TrialComparison | None
    signals_before: dict[str, Signals]
    signals: dict[str, Signals]


@dataclass(frozen=True)
class StrategyResult(Shown):
    """One update: the knowledge before (``start``) and after it, the fitted trials, and all comparisons.

    ``rig_texts`` are its rig files by name of the tyre pressure; the name is empty if there is only one. ``truth`` has
    the true values of synthetic recordings by path (SI), as a test machine would measure them, if the campaign's folder
    contains them.
    """

    update: UpdateResult
    start: Knowledge
    knowledge: Knowledge
    fitted_on: tuple[int, ...]
    rig_texts: dict[str, str] = field(default_factory=dict)
    trials: tuple[StrategyTrial, ...] = ()
    truth: dict[str, float] = field(default_factory=dict)

    def trial(self, number: int) -> StrategyTrial:
        """Return a trial before and after this update, by its number."""
        return next(trial for trial in self.trials if trial.number == number)

    def objective_by_channel(self) -> dict[str, tuple[float, float]]:
        """Split Eq. 2 over the fitted trials by channel, unweighted.

        Returns
        -------
        dict of str to (float, float)
            Channel to its sum of squared differences before and after, in the square of its SI unit: (m/s^2)^2.
        """
        fitted = [
            t for t in self.trials if t.is_fitted and t.before is not None and t.after is not None
        ]
        split: dict[str, tuple[float, float]] = {}
        for trial in fitted:
            assert trial.before is not None
            assert trial.after is not None
            for name, after in trial.after.channels.items():
                before_sum, after_sum = split.get(name, (0.0, 0.0))
                split[name] = (
                    before_sum + trial.before.channels[name].objective,
                    after_sum + after.objective,
                )
        return split
