"""Posterior of one update of a campaign, and the next trial worth running."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product
from pathlib import Path
from typing import Annotated, Any

import numpy as np

from jounce.campaign.characterise import Knowledge
from jounce.campaign.description import Campaign, load_campaign
from jounce.campaign.run import Runner, prepared_campaign
from jounce.campaign.strategy_result import StrategyResult
from jounce.core.errors import FitError, JounceError, unknown
from jounce.core.findings import Finding, finding
from jounce.core.operation import Count, File, Mark, Switch, Texts, operation
from jounce.core.optional import require
from jounce.core.phrases import Phrase
from jounce.core.serialise import to_json
from jounce.core.shown import Shown
from jounce.core.text import slug
from jounce.core.units import positive_si, to_si
from jounce.identify.fit_problem import FitTrial
from jounce.identify.next_trial import Candidate, NextTrials, next_trials
from jounce.identify.posterior import Posterior, posterior_with, update_with_density
from jounce.identify.prediction import PredictionBand
from jounce.identify.settings import UpdateSettings
from jounce.recordings.writers import netcdf_of
from jounce.roads import Trial, read_roads

CAMPAIGN = File("Campaign file with updates.", "CAMPAIGN.toml")
STRATEGY = Mark("Name of the update; the last one by default.", "STRATEGY")
NOISE_ONLY = Switch(
    "Count noise only, without the campaign's uncertainty of model and measurement."
)
_SPEEDS = 5  # default speeds between the slowest and the fastest trial
_MOST = 500  # candidates; each requires a simulation with sensitivities
Progress = Callable[[str], None]


@dataclass(frozen=True)
class CampaignPosterior(Shown):
    """A posterior with its campaign, and the files written from them.

    Attributes
    ----------
    posterior : Posterior
        Parameters, draws and predictions, SI.
    campaign : Campaign
        Campaign with the measured trials.
    """

    posterior: Posterior
    campaign: Campaign

    def __str__(self) -> str:
        return str(self.posterior)

    @property
    def title(self) -> str:
        """Title of the campaign."""
        return self.campaign.title

    def to_dict(self) -> dict[str, Any]:
        """Return plain values without curves; each band is reduced to the fraction of samples inside."""
        plain = self._table()
        del plain["profiles"]
        return plain

    def files(self) -> dict[str, bytes | str]:
        """Return numbers, draws and the bands of each trial as a mapping from file name to content."""
        predictions = self.posterior.predictions
        return {
            "posterior.json": to_json(self._table()) + "\n",
            "draws.nc": netcdf_of(self.posterior.samples),
            **{
                f"bands/{slug(trial)}.csv": _bands_csv(channels)
                for trial, channels in predictions.items()
            },
        }

    def _table(self) -> dict[str, Any]:
        plain = self.posterior.to_dict()
        plain["predictions"] = {
            trial: {
                name: {"inside": band.inside, "is_fitted": band.is_fitted}
                for name, band in channels.items()
            }
            for trial, channels in self.posterior.predictions.items()
        }
        return plain


def _bands_csv(channels: Mapping[str, PredictionBand]) -> str:
    """Format the bands of one trial as CSV, SI."""
    columns: dict[str, Any] = {"time [s]": next(iter(channels.values())).time}
    for name, band in channels.items():
        low, high = band.ends()
        given = {"measured": band.measured, "mean": band.mean, "lower": low, "upper": high}
        columns |= {f"{name} {word} [{band.unit}]": values for word, values in given.items()}
    rows = [
        ",".join(columns),
        *(",".join(f"{v:.9g}" for v in row) for row in zip(*columns.values(), strict=True)),
    ]
    return "\n".join(rows) + "\n"


@operation(
    "campaign posterior",
    named={"path": "campaign"},
    offers=("folder",),
    required=("folder",),
    python="jounce.campaign.posterior:campaign_posterior",
    page="jounce.report.posterior:campaign_posterior_page",
    terminal="jounce.report.posterior:campaign_posterior_summary",
    title="{result.title}",
    doing="reading the campaign",
    example='jounce campaign posterior campaign.toml --strategy "strategy 2" --out posterior',
)
def reported_posterior(
    path: Annotated[Path | str, CAMPAIGN],
    strategy: Annotated[str, STRATEGY] = "",
    *,
    draws: Annotated[int, Count("Minimum number of draws.", least=1000, most=10_000_000)] = 20_000,
    seed: Annotated[int, Count("Seed of the random numbers.", least=0)] = 1,
    noise_only: Annotated[bool, NOISE_ONLY] = False,
    progress: Progress = lambda _text: None,
) -> CampaignPosterior:
    """Sample the posterior distribution of an update's parameters, and predict every trial.

    Like :func:`jounce.campaign_posterior`, but the result includes the campaign's title and files.
    """
    for module in ("emcee", "arviz_stats.base"):
        require(module, "posterior")
    options: dict[str, Any] = {
        "draws": draws,
        "seed": seed,
        "noise_only": noise_only,
        "progress": progress,
    }
    posterior = campaign_posterior(path, strategy, **options)
    return CampaignPosterior(posterior, load_campaign(path)[0])


def campaign_posterior(
    path: Path | str,
    strategy: str = "",
    *,
    draws: int = 20_000,
    seed: int = 1,
    noise_only: bool = False,
    progress: Progress = lambda _text: None,
) -> Posterior:
    """Sample the posterior of the parameters of one update of a campaign, with predictions for every trial.

    Parameters
    ----------
    path : path
        Campaign TOML; file names in it are relative to its folder.
    strategy : str
        Name of the update; default: the last one. The updates that it starts from are run first.
    draws : int
        Number of draws, as for :func:`posterior`.
    seed : int
        Seed of the random numbers.
    noise_only : bool
        Count noise only, without the model and measurement uncertainties of the campaign.
    progress : callable
        Called with one line of text that describes the current step.

    Returns
    -------
    Posterior
        Posterior in SI, with bands for fitted and held-out trials.

    Raises
    ------
    DescriptionError
        As :func:`run_campaign`, and if the update is not in the campaign.
    FitError
        As :func:`posterior`, and if the update, or one that it starts from, fails.

    Examples
    --------
    >>> import tempfile
    >>> from jounce.campaign import new_campaign
    >>> found = campaign_posterior(new_campaign(tempfile.mkdtemp() + "/mine"), draws=2000)
    >>> found.counted, sorted(found.predictions)
    ('noise only', ['trial 1', 'trial 2', 'trial 4'])
    """
    runner, _, start = prepared_campaign(path, progress)
    knowledge, trials, free, settings = _prepared_update(
        runner, start, strategy, path, noise_only=noise_only
    )
    every = [runner.fit_trial(item, knowledge) for item in runner.loaded.values()]
    return posterior_with(
        trials, free, settings, draws=draws, seed=seed, predict=every, progress=progress
    )


@operation(
    "campaign next",
    named={
        "path": "campaign",
        "speeds": "speed",
        "roads": "road",
        "strut_angles": "strut_angle",
        "tyre_pressures": "tyre_pressure",
    },
    page="jounce.report.posterior:next_trials_page",
    title="{campaign}",
    example='jounce campaign next campaign.toml --strategy "strategy 4" --strut-angle "26 deg"',
)
def campaign_next_trials(
    path: Annotated[Path | str, CAMPAIGN],
    strategy: Annotated[str, STRATEGY] = "",
    *,
    speeds: Annotated[
        Sequence[float | str] | None,
        Texts(
            'A possible speed, e.g. "2.5 m/s"; repeat for several. Default: five speeds.',
            "SPEED",
        ),
    ] = None,
    roads: Annotated[
        Sequence[str] | None,
        Texts("A road of the campaign; repeat for several. Default: all.", "ROAD"),
    ] = None,
    strut_angles: Annotated[
        Sequence[float | str] | None,
        Texts('A possible strut angle, e.g. "26 deg"; repeat for several.', "ANGLE"),
    ] = None,
    tyre_pressures: Annotated[
        Sequence[float | str] | None,
        Texts('A possible tyre pressure, e.g. "0.31 MPa"; repeat for several.', "PRESSURE"),
    ] = None,
    count: Annotated[int, Count("Number of trials to choose in sequence.", least=1, most=20)] = 3,
    noise_only: Annotated[bool, NOISE_ONLY] = False,
    progress: Progress = lambda _text: None,
) -> NextTrials:
    """Rank candidate trials by their expected information about an update's parameters.

    Parameters
    ----------
    path : path
        Campaign TOML.
    strategy : str
        Name of the update; default: the last one.
    speeds : sequence, optional
        Possible speeds, m/s or text; default: five between the minimum and maximum speed of the campaign.
    roads : sequence of str, optional
        Roads of the campaign; default: all.
    strut_angles, tyre_pressures : sequence, optional
        Possible settings, rad and Pa or text; default: those of the campaign's trials.
    count : int
        Number of trials to choose in sequence, each the best given the previous ones.
    noise_only : bool
        Count noise only, without the model and measurement uncertainties of the campaign.
    progress : callable
        Called with one line of text that describes the current step.

    Returns
    -------
    NextTrials
        All candidates with their expected information gain, best first, and the best sequence of trials.

    Raises
    ------
    DescriptionError, FitError
        As :func:`campaign_posterior`, and if the campaign does not have a road.

    Examples
    --------
    >>> import tempfile
    >>> from jounce.campaign import new_campaign
    >>> file = new_campaign(tempfile.mkdtemp() + "/mine")
    >>> ranking = campaign_next_trials(file, speeds=["1 m/s", "2 m/s", "3 m/s"], count=1)
    >>> len(ranking.candidates), ranking.candidates[0].gain > 0.0
    (6, True)
    """
    runner, _, start = prepared_campaign(path, progress)
    knowledge, trials, free, settings = _prepared_update(
        runner, start, strategy, path, noise_only=noise_only
    )
    candidates, lost = _candidates(
        runner, knowledge, Path(path), speeds, roads, strut_angles, tyre_pressures
    )
    basis = update_with_density(trials, free, settings, progress).basis
    progress(Phrase("{name}: {count} candidate trials", name=settings.name, count=len(candidates)))
    ranking = next_trials(basis, candidates, count=count)
    return replace(ranking, findings=(*ranking.findings, *lost))


def _prepared_update(
    runner: Runner, start: Knowledge, strategy: str, path: Path | str, *, noise_only: bool
) -> tuple[Knowledge, list[FitTrial], dict[str, Any], UpdateSettings]:
    """Run the updates that an update starts from; return knowledge, trials, free parameters and settings."""
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
    before, name = [], entry.start_from
    while name is not None:
        before.append(name)
        name = entries[name].start_from
    done: dict[str, StrategyResult] = {
        item.update.name: item for item in runner.update_all(start, before)
    }
    problems = [item for item in runner.findings if item.severity == "problem"]
    if len(done) < len(before) and problems:
        raise FitError(
            "an update on which it is based failed", where=entry.name, found=str(problems[-1])
        )
    knowledge, _, trials, settings = runner.set_up(entry, start, done)
    if settings.nuisances:
        hint = (
            "Enter the speeds and filters that the update estimated (speed of the trials, low_pass of "
            "the sensors), and omit nuisances."
        )
        raise FitError(
            "a posterior does not sample speeds and filters", where=entry.name, hint=hint
        )
    if not trials:
        raise FitError(
            "no trial to fit",
            where=entry.name,
            hint='Mark trials with use = "fit" or name their numbers.',
        )
    free: dict[str, Any] = dict(entry.free)
    if noise_only:  # priors apply only together with uncertainties
        settings = replace(settings, doubt=None)
        free = {
            path: given["bounds"] if isinstance(given, Mapping) else given
            for path, given in free.items()
        }
    return knowledge, trials, free, settings


def _candidates(
    runner: Runner, knowledge: Knowledge, path: Path, speeds: Sequence[float | str] | None,
    roads: Sequence[str] | None, strut_angles: Sequence[float | str] | None,
    tyre_pressures: Sequence[float | str] | None,
) -> tuple[list[Candidate], list[Finding]]:  # fmt: skip
    """Return all feasible combinations of road, speed and settings, and findings about the others."""
    known = read_roads(runner.campaign.roads, where=str(path), folder=path.parent)
    for name in roads or ():
        if name not in known:
            raise unknown(name, known, what="road", where=f"{path}: roads")
    names = list(roads or known)
    if not names:
        raise FitError(
            "no road is defined",
            where=str(path),
            hint="Write [roads.NAME] tables in the campaign.",
        )
    driven = [entry.speed for entry in runner.campaign.trial if entry.speed is not None]
    if speeds is None and not driven:
        raise FitError(
            "no speed is given", where=str(path), hint='Give speeds, e.g. ["1 m/s", "3 m/s"].'
        )
    if speeds is None:
        chosen = [float(v) for v in np.round(np.linspace(min(driven), max(driven), _SPEEDS), 3)]
    else:
        chosen = [positive_si(v, "m/s", where="speeds") for v in speeds]
    entries = runner.campaign.trial
    angles: list[float | None] = list(dict.fromkeys(entry.strut_angle for entry in entries))
    angles.sort(key=lambda angle: angle is None)  # None may equal one of the others
    if strut_angles is not None:
        angles = [to_si(v, "rad", where="strut_angles") for v in strut_angles]
    pressures: list[float | None] = list(dict.fromkeys(entry.tyre_pressure for entry in entries))
    if tyre_pressures is not None:
        pressures = [to_si(v, "Pa", where="tyre_pressures") for v in tyre_pressures]
    count = len(names) * len(chosen) * len(angles) * len(pressures)
    if count > _MOST:
        raise FitError(
            "too many trials to compare",
            found=count,
            allowed=Phrase("up to {most}", most=_MOST),
            where="candidates",
        )
    duration = max(float(item.measured["time"][-1]) for item in runner.loaded.values())
    sensors = next(iter(runner.sensors.values()), runner.campaign.sensors)
    candidates: list[Candidate] = []
    lost: dict[str, list[str]] = {}
    for road, speed, angle, pressure in product(names, chosen, angles, pressures):
        words = [f"{road} at {speed:.4g} m/s"]
        words += [] if len(angles) == 1 or angle is None else [f"strut {np.degrees(angle):.4g} deg"]
        words += (
            [] if len(pressures) == 1 or pressure is None else [f"tyre {pressure / 1e6:.4g} MPa"]
        )
        name = ", ".join(words)
        try:
            trial = Trial(road=known[road], speed=speed, duration=duration)
            rig = knowledge.rig_for(angle, pressure, {})
        except JounceError as error:
            lost.setdefault(error.message(), []).append(name)
            continue
        if any(other.trial == trial and other.rig == rig for other in candidates):
            continue
        if trial.obstacle_end() < duration:
            candidates.append(Candidate(name, rig, trial, sensors))
        else:
            late = f"obstacles end after the {duration:.4g} s that were recorded: drive faster, or record longer."
            lost.setdefault(late, []).append(name)
    left_out = [
        finding("campaign.left_out_with_others", each[0], error=why, more=len(each) - 1)
        if each[1:]
        else finding("campaign.left_out", each[0], error=why)
        for why, each in lost.items()
    ]
    if not candidates:
        raise FitError("none of the trials can be run", where="candidates", found=str(left_out[0]))
    return candidates, left_out
