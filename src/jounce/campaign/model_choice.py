"""Model selection: an update is repeated with simpler and richer models, which are assessed on held-out trials."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Any

import numpy as np

from jounce.campaign.characterise import Knowledge
from jounce.campaign.description import UpdateEntry
from jounce.campaign.run import Runner, prepared_campaign
from jounce.core.errors import FitError, JounceError, unknown
from jounce.core.findings import Finding, finding
from jounce.core.operation import File, Mark, operation
from jounce.core.serialise import Plain
from jounce.core.shown import Shown
from jounce.design.lumping import lumped_from
from jounce.identify.estimate import correlation_time
from jounce.identify.update import UpdateResult
from jounce.identify.update import update_model as fit
from jounce.parts import Corner

TYRE = ("tyre.stiffness", "tyre.curve")
_CUBIC = ("tyre.curve.coefficients[0]", "tyre.curve.coefficients[1]", "tyre.curve.coefficients[2]")
CARRIED = 2.0
"""AIC difference within which the data support two models equally (Burnham and Anderson 2002, section 2.6)."""


@dataclass(frozen=True)
class ModelRow(Shown):
    """One model, fitted on the same trials as the others.

    Attributes
    ----------
    model : str
        Description of the model: rig, tyre law, friction.
    parameters : int
        Number of free parameters.
    aic, bic : float
        Information criteria (1) relative to the best model, from the effective number of independent residuals.
    objective : float
        Weighted sum of squared residuals relative to that of the measured signals (1).
    fitted, held_out : float or None
        Minimum R2 (1) of a channel over the fitted trials, and over the held-out trials.
    holds : int
        Number of held-out trials with the verdict `holds`.
    trials : int
        Number of held-out trials that were compared.
    """

    model: str
    parameters: int
    aic: float
    bic: float
    objective: float
    fitted: float | None
    held_out: float | None
    holds: int
    trials: int


@dataclass(frozen=True)
class ModelChoice(Plain):
    """Comparison of models of one update, in order of increasing AIC.

    Attributes
    ----------
    update : str
        Update whose trials and settings the models share.
    models : tuple of ModelRow
        Models in order of increasing AIC.
    findings : tuple of Finding
        Conclusions, and models that could not be fitted.
    """

    update: str
    models: tuple[ModelRow, ...]
    findings: tuple[Finding, ...]


@dataclass(frozen=True)
class _Model:
    """A variant of an update: its name, the knowledge before it, and its entry."""

    name: str
    knowledge: Knowledge
    entry: UpdateEntry


@operation(
    "campaign models",
    named={"path": "campaign"},
    page="jounce.report.laboratory:model_choice_page",
    title="{campaign}",
    doing="fitting models",
    example="jounce campaign models campaign.toml",
)
def compare_campaign_models(
    path: Annotated[Path | str, File("Campaign file with updates.", "CAMPAIGN.toml")],
    strategy: Annotated[str, Mark("Name of the update; the last one by default.", "STRATEGY")] = "",
    *,
    progress: Callable[[str], None] = lambda _text: None,
) -> ModelChoice:
    """Fit an update with different models, and report which models the data support.

    The models are the rig as described and, for a 3-D rig, its equivalent quarter car; with a linear tyre and with the
    measured cubic tyre curve; with and without the friction forces that the update estimates.

    Parameters
    ----------
    path : path
        Campaign TOML.
    strategy : str
        Name of the update; default: the last one.
    progress : callable
        Called with one line of text that describes the current step.

    Returns
    -------
    ModelChoice
        Information criteria, and the prediction of held-out trials by each model.

    Raises
    ------
    DescriptionError, FitError
        As :func:`jounce.run_campaign`, and if the campaign does not have the update.

    Examples
    --------
    >>> import tempfile
    >>> from jounce.campaign import new_campaign
    >>> choice = compare_campaign_models(new_campaign(tempfile.mkdtemp() + "/mine"))
    >>> len(choice.models), choice.models[0].aic
    (4, 0.0)
    """
    runner, _, start = prepared_campaign(path, progress)
    entries = {entry.name: entry for entry in runner.campaign.update}
    if not entries:
        raise FitError(
            "the campaign has no update",
            where=str(path),
            hint="Write an [[update]] with free parameters.",
        )
    if strategy and strategy not in entries:
        raise unknown(strategy, entries, what="update", where=f"{path}: strategy")
    entry = entries[strategy] if strategy else list(entries.values())[-1]
    done = {
        result.update.name: result
        for result in runner.update_all(start, [entry.start_from] if entry.start_from else [])
    }
    knowledge = done[entry.start_from].knowledge if entry.start_from in done else start
    plain = entry.model_copy(update={"start_from": None, "tyre_law": "as-rig"})
    rows: list[tuple[ModelRow, float, float]] = []
    findings: list[Finding] = []
    for model in _models(runner, knowledge, plain):
        progress(f"{entry.name}: {model.name}")
        try:
            rows.append(_fit_model(runner, model))
        except JounceError as error:
            findings.append(finding("campaign.model_left_out", model.name, error=error))
    if not rows:
        raise FitError("no model could be fitted", where=entry.name, found=str(findings[-1]))
    least = min(aic for _, aic, _ in rows), min(bic for _, _, bic in rows)
    models = [replace(row, aic=aic - least[0], bic=bic - least[1]) for row, aic, bic in rows]
    models.sort(key=lambda row: row.aic)
    return ModelChoice(entry.name, tuple(models), (*_conclusion(models), *findings))


def _models(runner: Runner, knowledge: Knowledge, entry: UpdateEntry) -> Iterator[_Model]:
    """Yield the variants of an update, starting with the rig as described."""
    rigs = [("", knowledge)]
    if isinstance(knowledge.rig, Corner) and knowledge.rig.guide != "fixed":
        rigs.append(("quarter car, ", replace(knowledge, rig=lumped_from(knowledge.rig))))
    for words, known in rigs:
        values = known.rig.parameters()
        free = {
            path: bounds
            for path, bounds in entry.free.items()
            if path in values or path.startswith(TYRE)
        }
        frictions = [path for path in free if "friction" in path and path.endswith(".force")]
        for tyre, law in (("one tyre stiffness", "as-rig"), ("cubic tyre", "polynomial")):
            own = {path: bounds for path, bounds in free.items() if not path.startswith(TYRE)}
            bounds = next((given for path, given in free.items() if path.startswith(TYRE)), None)
            if law == "polynomial" and (not runner.campaign.bench.tyre or bounds is None):
                continue
            if bounds is not None:
                own |= (
                    dict.fromkeys(_CUBIC, _RELATIVE)
                    if law == "polynomial"
                    else {"tyre.stiffness": bounds}
                )
            changed = entry.model_copy(update={"tyre_law": law, "free": own})
            yield _Model(f"{words}{tyre}", known, changed)
            if frictions:
                without = replace(known, rig=known.rig.with_changes(dict.fromkeys(frictions, 0.0)))
                less = {path: given for path, given in own.items() if path not in frictions}
                yield _Model(
                    f"{words}{tyre}, no friction",
                    without,
                    changed.model_copy(update={"free": less}),
                )


_RELATIVE = "20 %"
"""Bounds of each coefficient of the measured tyre curve: the difference between rolling and standing tyres."""


def _fit_model(runner: Runner, model: _Model) -> tuple[ModelRow, float, float]:
    """Fit a model to the trials of its update and compare it with the others; also return absolute AIC and BIC."""
    knowledge, chosen, trials, settings = runner.set_up(model.entry, model.knowledge, {})
    if not trials:
        raise FitError(
            "no trial to fit", where=model.entry.name, hint='Mark trials with use = "fit".'
        )
    free = {
        path: given["bounds"] if isinstance(given, Mapping) else given
        for path, given in model.entry.free.items()
    }
    result = fit(
        trials, free, name=settings.name, method=settings.method, weights=settings.weights, channels=settings.channels,
        align=settings.align, starts=settings.starts,
    )  # fmt: skip
    after = knowledge.after(result.parameters, [item.entry.tyre_pressure for item in chosen])
    fitted = {item.entry.number for item in chosen}
    seen: dict[bool, list[Any]] = {True: [], False: []}
    residuals = []
    for number, item in runner.loaded.items():
        lag = result.lags.get(f"trial {number}", None if result.lags else 0.0)
        comparison, signals, _, _ = runner.comparison(item, after, lag)
        if comparison is not None:
            seen[number in fitted].append(comparison)
            if number in fitted:
                residuals += [signal.measured - signal.simulated for signal in signals.values()]
    aic, bic = _criteria(residuals, len(free), result)
    least = {
        key: min(
            (channel.r2 for part in comparisons for channel in part.channels.values()), default=None
        )
        for key, comparisons in seen.items()
    }
    holds = sum(judged.verdict == "holds" for judged in seen[False])
    left = result.objective_after / max(result.objective_before, 1e-300)
    row = ModelRow(
        model.name, len(free), aic, bic, left, least[True], least[False], holds, len(seen[False])
    )
    return row, aic, bic


def _criteria(
    residuals: list[np.ndarray], parameters: int, result: UpdateResult
) -> tuple[float, float]:
    """Compute AIC and BIC of residuals by channel, each with its own variance and number of independent samples."""
    likelihood = count = 0.0
    for residual in residuals:
        independent = len(residual) / correlation_time(residual)
        likelihood += independent * math.log(
            max(float(residual @ residual) / len(residual), 1e-300)
        )
        count += independent
    unknowns = parameters + len(residuals) + len(result.lags)
    return likelihood + 2.0 * unknowns, likelihood + math.log(max(count, 2.0)) * unknowns


def _conclusion(models: list[ModelRow]) -> Iterator[Finding]:
    best = models[0]
    alike = [row.model for row in models[1:] if row.aic <= CARRIED]
    others = ", ".join(alike)
    if alike:
        yield finding("campaign.models_alike", best.model, others=others)
    simplest = min(models, key=lambda row: row.bic)
    if simplest is not best and simplest.model not in alike:
        yield finding(
            "campaign.criteria_differ",
            best.model,
            other=simplest.model,
            parameters=simplest.parameters,
        )
    judged = [row for row in models if row.held_out is not None]
    ahead = max(judged, key=lambda row: row.held_out or 0.0, default=None)
    if (
        ahead is not None
        and best.held_out is not None
        and (ahead.held_out or 0.0) > best.held_out + _BETTER
    ):
        yield finding(
            "campaign.other_model_predicts",
            best.model,
            other=ahead.model,
            r2=ahead.held_out,
            own=best.held_out,
        )


_BETTER = 0.01
"""Minimum gain in R2 on held-out trials for another model to be reported: a fifth of the margin of `holds`."""
