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
NOISE_ONLY = Switch("Count noise only, not what the campaign doubts of model and measurement.")
_SPEEDS = 5  # between the slowest and the fastest trial, where none are given; each multiplies the candidates
_MOST = 500  # candidates: each is a run with its sensitivities
Progress = Callable[[str], None]


@dataclass(frozen=True)
class CampaignPosterior(Shown):
    """A posterior with its campaign, and the files written from both.

    Attributes
    ----------
    posterior : Posterior
        Parameters, draws and predictions, SI.
    campaign : Campaign
        What was measured.
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
        """Give plain values without curves: of each band the share of samples inside."""
        plain = self._table()
        del plain["profiles"]
        return plain

    def files(self) -> dict[str, bytes | str]:
        """Give the numbers, the draws, and the bands of each trial as files, name to content."""
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
    """Write the bands of one trial as a table, SI."""
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
    draws: Annotated[
        int, Count("Number of draws, at least.", least=1000, most=10_000_000)
    ] = 20_000,
    seed: Annotated[int, Count("Of everything at random.", least=0)] = 1,
    noise_only: Annotated[bool, NOISE_ONLY] = False,
    progress: Progress = lambda _text: None,
) -> CampaignPosterior:
    """Draw what the recordings say of an update's parameters, and what that predicts for every trial.

    It is what :func:`jounce.campaign_posterior` does, with the campaign's title and files.
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
    """Posterior of the parameters of one update of a campaign, with what it predicts for every trial.

    Parameters
    ----------
    path : path
        Campaign TOML; files it names are relative to its folder.
    strategy : str
        Name of the update, the last one by default. Those it starts from are run before it.
    draws : int
        Number of draws, as for :func:`posterior`.
    seed : int
        Of everything at random.
    noise_only : bool
        Count noise only, not the doubts of the campaign.
    progress : callable
        Is told in one line of text what is being done.

    Returns
    -------
    Posterior
        SI; bands for fitted and held-out trials.

    Raises
    ------
    DescriptionError
        As :func:`run_campaign`, and for an update that is not in the campaign.
    FitError
        As :func:`posterior`, and where the update, or one that it starts from, fails.

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
            'A speed that could be driven, e.g. "2.5 m/s"; repeat it. By default five are tried.',
            "SPEED",
        ),
    ] = None,
    roads: Annotated[
        Sequence[str] | None, Texts("A road of the campaign; repeat it. By default all.", "ROAD")
    ] = None,
    strut_angles: Annotated[
        Sequence[float | str] | None,
        Texts('A strut angle to set up, e.g. "26 deg"; repeat it.', "ANGLE"),
    ] = None,
    tyre_pressures: Annotated[
        Sequence[float | str] | None,
        Texts('A tyre pressure, e.g. "0.31 MPa"; repeat it.', "PRESSURE"),
    ] = None,
    count: Annotated[int, Count("Trials to choose one after the other.", least=1, most=20)] = 3,
    noise_only: Annotated[bool, NOISE_ONLY] = False,
    progress: Progress = lambda _text: None,
) -> NextTrials:
    """Rank candidate trials by the information that they are expected to give about an update's parameters.

    Parameters
    ----------
    path : path
        Campaign TOML.
    strategy : str
        Name of the update, the last one by default.
    speeds : sequence, optional
        Speeds that could be driven, m/s or text; by default five between the least and the greatest of the campaign.
    roads : sequence of str, optional
        Roads of the campaign; by default all.
    strut_angles, tyre_pressures : sequence, optional
        Set-ups that could be tried, rad and Pa or text; by default those of the campaign's trials.
    count : int
        How many trials to choose, each the best after those before it.
    noise_only : bool
        Count noise only, not the doubts of the campaign.
    progress : callable
        Is told in one line of text what is being done.

    Returns
    -------
    NextTrials
        All candidates with what they would tell, best first, and the series that is best one after the other.

    Raises
    ------
    DescriptionError, FitError
        As :func:`campaign_posterior`, and for roads that the campaign does not have.

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
    progress(
        Phrase(
            "{name}: {count} trials that could be run", name=settings.name, count=len(candidates)
        )
    )
    ranking = next_trials(basis, candidates, count=count)
    return replace(ranking, findings=(*ranking.findings, *lost))


def _prepared_update(
    runner: Runner, start: Knowledge, strategy: str, path: Path | str, *, noise_only: bool
) -> tuple[Knowledge, list[FitTrial], dict[str, Any], UpdateSettings]:
    """Run what an update starts from; give what is then known, its trials, free parameters and settings."""
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
        raise FitError("an update it starts from failed", where=entry.name, found=str(problems[-1]))
    knowledge, _, trials, settings = runner.set_up(entry, start, done)
    if settings.nuisances:
        hint = (
            "State what the update finds as speed of the trials and low_pass of the sensors, and "
            "leave nuisances out."
        )
        raise FitError(
            "speeds and filters are not drawn from a posterior", where=entry.name, hint=hint
        )
    if not trials:
        raise FitError(
            "no trial to fit",
            where=entry.name,
            hint='Mark trials with use = "fit" or name their numbers.',
        )
    free: dict[str, Any] = dict(entry.free)
    if noise_only:  # a prior counts beside doubts only
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
    """All combinations that can be set up and driven, and why others cannot."""
    known = read_roads(runner.campaign.roads, where=str(path), folder=path.parent)
    for name in roads or ():
        if name not in known:
            raise unknown(name, known, what="road", where=f"{path}: roads")
    names = list(roads or known)
    if not names:
        raise FitError(
            "no road to drive over",
            where=str(path),
            hint="Write [roads.NAME] tables in the campaign.",
        )
    driven = [entry.speed for entry in runner.campaign.trial if entry.speed is not None]
    if speeds is None and not driven:
        raise FitError(
            "no speed to drive at", where=str(path), hint='Give speeds, e.g. ["1 m/s", "3 m/s"].'
        )
    if speeds is None:
        chosen = [float(v) for v in np.round(np.linspace(min(driven), max(driven), _SPEEDS), 3)]
    else:
        chosen = [positive_si(v, "m/s", where="speeds") for v in speeds]
    entries = runner.campaign.trial
    angles: list[float | None] = list(dict.fromkeys(entry.strut_angle for entry in entries))
    angles.sort(key=lambda angle: angle is None)  # which may be one of the others
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
