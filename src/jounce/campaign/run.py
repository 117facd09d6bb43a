"""Run a campaign: characterise components, run the updates, and compare every trial with the model."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import xarray as xr

from jounce.campaign.belt import (
    PULSES,
    SPEED_CODES,
    Belt,
    TrialOnBelt,
    common_speed_errors,
    exchanged_trials,
    loop_length,
    place_trial,
    with_recurrence,
)
from jounce.campaign.characterise import (
    SPRUNG_MASS,
    Characterisation,
    Knowledge,
    bench_values,
    characterise,
    polynomial_tyres,
)
from jounce.campaign.description import Campaign, TrialEntry, UpdateEntry, load_campaign
from jounce.campaign.exchanged import better_exchanged
from jounce.campaign.first_look import first_look
from jounce.campaign.result import CampaignResult
from jounce.campaign.strategy_result import StrategyResult, StrategyTrial
from jounce.campaign.trial_result import (
    Signals,
    TrialComparison,
    TrialMotion,
    TrialResult,
    compare_trial,
)
from jounce.campaign.truth import BenchTruth, load_truth, true_values
from jounce.campaign.updated_rigs import updated_rigs
from jounce.core.errors import DescriptionError, FitError, JounceError, reason, unknown
from jounce.core.findings import Finding, at_place, finding
from jounce.core.phrases import Phrase, Phrases
from jounce.core.waiting import Stage, progress_through
from jounce.design.lumping import lumped_from
from jounce.design.model_comparison import (
    ModelComparison,
    PeakDifference,
    compare_models,
    compare_peaks,
)
from jounce.identify.datum import QuietStart, datums_of, quiet_starts, start_findings, with_datum
from jounce.identify.extended_rig import own_doubt
from jounce.identify.fit_problem import FitTrial, check_free
from jounce.identify.passages import ObstacleNotFoundError, Sought, find_passages
from jounce.identify.settings import UpdateSettings
from jounce.identify.signs import compression_positive, sign_of
from jounce.identify.update import bounds_and_priors, run_update
from jounce.kinematics import sweep_travel
from jounce.kinematics.adjustments import apply_adjustments
from jounce.parts import Corner, Rig, load, rig_findings
from jounce.parts.files import rig_named_in
from jounce.parts.variants import strut_angle_findings, with_strut_angle
from jounce.recordings import Sensor
from jounce.recordings.plausibility import SLOWEST_STEP
from jounce.recordings.pulses import PulseSpeed
from jounce.recordings.quality import FEWEST_SAMPLES
from jounce.recordings.sensors import check_sensors
from jounce.roads import Excitation, Road, Train, Trial, read_roads
from jounce.roads.trial import road_findings
from jounce.simulation.compiled import compile_rig

_POSES, _LEAST_TRAVEL = 25, 1e-3  # of the wheel against the body, m
Progress = Callable[[str], None]
_Compared = tuple[TrialComparison | None, dict[str, Signals], list[Finding], TrialMotion | None]


@dataclass(frozen=True)
class _Loaded:
    """A trial with its road and recording."""

    entry: TrialEntry
    trial: Trial
    measured: xr.Dataset
    pulses: PulseSpeed | None = None
    facts: TrialOnBelt | None = None


def run_campaign(path: Path | str, *, progress: Progress = lambda _text: None) -> CampaignResult:
    """Evaluate a whole bench campaign.

    Parameters
    ----------
    path : path
        Campaign TOML; file names in it are relative to its folder.
    progress : callable
        Called with one line of text that describes the current step.

    Returns
    -------
    CampaignResult
        Results in memory; to write them, see :func:`jounce.report.write_campaign`. A failed bench table, trial or
        update is reported as a finding of severity ``problem``, and the run continues.

    Raises
    ------
    DescriptionError
        If the campaign, rig or road tables are invalid.

    Examples
    --------
    >>> import tempfile
    >>> from jounce.campaign import new_campaign
    >>> result = run_campaign(new_campaign(tempfile.mkdtemp() + "/mine"))
    >>> result.is_complete, result.strategies[0].update.reduction_percent > 0.0
    (True, True)
    """
    runner, rig, knowledge = prepared_campaign(path, progress)
    campaign, bench, findings = runner.campaign, runner.bench, runner.findings
    strategies = runner.compare_strategies(runner.update_all(knowledge))
    trials = runner.compare_all(knowledge, strategies)
    final = strategies[-1].knowledge if strategies else knowledge
    findings += runner.exchanged_conditions(final, trials)
    lumped = runner.compare_with_lumped(final)
    poses = runner.poses(trials)
    look = first_look(campaign, bench, knowledge.rig, runner.records, trials)
    return CampaignResult(
        campaign,
        runner.folder,
        rig,
        knowledge.rig,
        bench,
        tuple(strategies),
        tuple(trials),
        tuple(_leading(_unique(findings))),
        lumped,
        poses,
        look,
        runner.sought,
    )


def prepared_campaign(path: Path | str, progress: Progress) -> tuple[Runner, Rig, Knowledge]:
    """Read and check a campaign, and evaluate its bench tests, to prepare the updates.

    Returns the runner, the rig as described, and the knowledge before any update.
    """
    file = Path(path)
    campaign, text = load_campaign(file)
    rig_file = rig_named_in(campaign.rig, file)
    rig = load(rig_file)
    roads = read_roads(campaign.roads, where=str(file), text=text, folder=file.parent)
    _check_references(campaign, roads, file)
    findings = rig_findings(rig, rig_file.name)
    for name, road in roads.items():
        findings += road_findings(road, f"roads.{name}")
    for check in checks_of(campaign, rig, file):
        findings += check()
    parts = [Phrase(name) for name in ("spring", "tyre", "decay") if getattr(campaign.bench, name)]
    progress(Phrase("bench: {parts}", parts=Phrases(", ", parts)))
    bench, knowledge = characterise(rig, campaign.bench, file.parent, campaign.sensors)
    findings += bench.findings
    loaded = _load_trials(campaign, roads, file.parent, findings)
    runner = Runner(
        campaign,
        file.parent,
        loaded,
        rig_file.read_text(encoding="utf-8"),
        bench,
        findings,
        progress,
    )
    runner.records = {number: item.measured for number, item in loaded.items()}
    runner.truth = _truth(campaign, file.parent, findings)
    runner.place_trials(knowledge)
    runner.decide_datums(knowledge)
    return runner, rig, knowledge


def _truth(campaign: Campaign, folder: Path, findings: list[Finding]) -> BenchTruth | None:
    """Return the true values behind a synthetic campaign if its folder contains them."""
    file = folder / "truth.toml"
    if not (campaign.synthetic and file.is_file()):
        return None
    try:
        return load_truth(file)
    except JounceError as error:
        findings.append(finding("campaign.no_truths", "truth.toml", error=error))
        return None


_LEADING = (
    "identify.strongly_correlated",
    "identify.mass_moved",
    "identify.on_bound",
    "identify.nuisance_on_bound",
    "identify.bench_contradicted",
)


def _leading(findings: list[Finding]) -> list[Finding]:
    """Sort findings so that those which question the physical meaning of parameters come first."""
    return sorted(findings, key=lambda finding: finding.code not in _LEADING)


def _check_references(campaign: Campaign, roads: dict[str, Road], file: Path) -> None:
    for i, entry in enumerate(campaign.trial):
        if entry.road is not None and entry.road not in roads:
            raise unknown(
                entry.road,
                roads,
                what="road",
                where=f"{file}: trial[{i}].road (number {entry.number})",
            )


def checks_of(campaign: Campaign, rig: Rig, file: Path) -> list[Callable[[], list[Finding]]]:
    """Return the checks made before a run; ``jounce check`` also makes all of them."""
    return [
        partial(check, campaign, rig, file)
        for check in (
            _check_sensors,
            check_strut_angles,
            _check_adjustments,
            _check_masses,
            _check_updates,
        )
    ]


def _check_sensors(campaign: Campaign, rig: Rig, file: Path) -> list[Finding]:
    channels = compile_rig(rig).output_names
    for name in campaign.sensors:
        if name not in channels:
            raise unknown(name, channels, what="channel", where=f"{file}: sensors")
    check_sensors(campaign.sensors, f"{file}: sensors")
    return []


def check_strut_angles(campaign: Campaign, rig: Rig, file: Path) -> list[Finding]:
    """Refuse strut angles that this rig cannot have; report angles that the literature advises against."""
    findings: list[Finding] = []
    for i, entry in enumerate(campaign.trial):
        if entry.strut_angle is None:
            continue
        try:
            with_strut_angle(rig, entry.strut_angle)
        except DescriptionError as error:
            place = f"{file}: trial[{i}].strut_angle (number {entry.number})"
            raise DescriptionError(
                error.what, where=place, found=error.found, allowed=error.allowed, hint=error.hint
            ) from None
        findings += strut_angle_findings(entry.strut_angle, f"trial {entry.number}: strut_angle")
    return findings


def rig_of(entry: TrialEntry, knowledge: Knowledge) -> Rig:
    """Return the rig as set up for a trial; adjustments are applied last."""
    rig = knowledge.rig_for(entry.strut_angle, entry.tyre_pressure, entry.changes, entry.added_mass)
    return apply_adjustments(rig, entry.adjustments) if entry.adjustments else rig


def _check_adjustments(campaign: Campaign, rig: Rig, file: Path) -> list[Finding]:
    """Refuse adjustments that the rig does not have, or that conflict with each other."""
    for i, entry in enumerate(campaign.trial):
        if not entry.adjustments:
            continue
        try:
            apply_adjustments(rig, entry.adjustments)
        except JounceError as error:
            place = f"{file}: trial[{i}].adjustments (number {entry.number})"
            where = f"{place}: {error.where}" if error.where else place
            raise DescriptionError(
                error.what, where=where, found=error.found, allowed=error.allowed, hint=error.hint
            ) from None
    return []


def _check_masses(campaign: Campaign, rig: Rig, file: Path) -> list[Finding]:
    """Refuse added masses if the rig has no body."""
    for i, entry in enumerate(campaign.trial):
        if entry.added_mass and SPRUNG_MASS not in rig.parameters():
            place = f"{file}: trial[{i}].added_mass (number {entry.number})"
            raise DescriptionError(
                "the rig has no body to add a mass to",
                where=place,
                allowed=Phrase("a rig with {sprung_mass}", sprung_mass=SPRUNG_MASS),
            )
    return []


def _check_updates(campaign: Campaign, rig: Rig, file: Path) -> list[Finding]:
    """Refuse invalid updates and uncertainties before the run starts."""
    for path, given in campaign.doubt.values.items():
        own_doubt(rig, path, given, f"{file}: doubt.values")
    for i, entry in enumerate(campaign.update):
        place = f"{file}: update[{i}].free ({entry.name})"
        curve = {
            path
            for path in entry.free
            if path.startswith("tyre.curve") and entry.tyre_law == "polynomial"
        }
        ranges, _ = bounds_and_priors(rig, entry.free, place)
        check_free(
            rig,
            {path: bounds for path, bounds in ranges.items() if path not in curve},
            where=place,
            more=len(curve),
        )
    return []


def _load_trials(
    campaign: Campaign, roads: dict[str, Road], folder: Path, findings: list[Finding]
) -> dict[int, _Loaded]:
    loaded = {}
    for entry in campaign.trial:
        place = f"trial {entry.number}"
        try:
            loaded[entry.number], notes = load_trial(entry, roads, folder, campaign)
        except Exception as error:  # noqa: BLE001 - one bad file never loses the others
            findings.append(finding("campaign.trial_left_out", place, error=reason(error)))
        else:
            findings += [at_place(f"{place}: {note.place}", note) for note in notes]
    return loaded


def load_trial(
    entry: TrialEntry, roads: Mapping[str, Road], folder: Path, campaign: Campaign | None = None
) -> tuple[_Loaded, list[Finding]]:
    """Read the inputs and the recording of a trial; refuse a trial that cannot be compared with a simulation."""
    belt, sensors = (None, {}) if campaign is None else (campaign.belt, campaign.sensors)
    measured, notes = entry.read(
        folder / entry.recording, folder, {**sensors, **(belt.sensors if belt else {})}
    )
    measured = compression_positive(measured, entry.stroke_positive, entry.force_positive)
    measured = _window(measured, entry)
    duration = entry.duration or float(measured["time"][-1])
    known = _inputs_of(entry, folder, notes)
    pulses = belt.speed(measured, entry.recording) if belt else None
    if entry.road is not None:
        speed = entry.speed
        if belt and pulses:
            notes += pulses.findings
            speed = speed or pulses.mean * (1.0 - belt.slip)
        known = {"road": with_recurrence(roads[entry.road], belt), "speed": speed, **known}
    trial = Trial(duration=duration, **known)
    _check_length(trial, measured)
    measured = measured.drop_vars(PULSES, errors="ignore").sel(time=slice(None, duration))
    return _Loaded(entry, trial, measured, pulses), notes


def _window(measured: xr.Dataset, entry: TrialEntry) -> xr.Dataset:
    """Return the part of a record between ``from`` and ``to``, with time starting at 0."""
    if entry.from_ is None and entry.to is None:
        return measured
    part = measured.sel(time=slice(entry.from_, entry.to))
    if part.sizes["time"] < FEWEST_SAMPLES:
        raise FitError(
            "the record has no samples between from and to",
            where="from, to",
            found=f"{part.sizes['time']} samples",
            allowed=Phrase(
                "between {measured:.4g} and {second_measured:.4g} s",
                measured=float(measured["time"][0]),
                second_measured=float(measured["time"][-1]),
            ),
        )
    time = part["time"]
    return part.assign_coords(time=("time", time.to_numpy() - float(time[0]), time.attrs))


def _inputs_of(entry: TrialEntry, folder: Path, findings: list[Finding]) -> dict[str, Any]:
    """Read the measured inputs of a trial (base motion and actuator force) as fields of a `Trial`."""
    known: dict[str, Any] = {}
    if entry.actuator_force is not None:
        file = folder / entry.actuator_force.file
        time, force, notes = entry.actuator_force.signal(file, folder, "actuator.force")
        sign = sign_of(entry.force_positive, "force")
        known["actuator_force"] = {"time": time, "force": sign * force}
        findings += notes
    if entry.excitation is not None:
        keys = entry.excitation.model_dump(exclude_unset=True)
        if "database" in keys:
            keys["database"] = str(folder / keys["database"])
        known["excitation"] = Excitation(**{**keys, "file": folder / entry.excitation.file})
        findings += known["excitation"].findings()
    return known


def _check_length(trial: Trial, measured: xr.Dataset) -> None:
    last = min(float(measured["time"][-1]), trial.duration)
    step = float(measured["time"][1] - measured["time"][0])
    if step > SLOWEST_STEP:
        raise FitError(
            "the sample rate is too low to resolve the motion of a suspension",
            where="time",
            found=f"a sample every {step:.4g} s",
            allowed=Phrase("steps up to {slowest_step:g} s", slowest_step=SLOWEST_STEP),
            hint="Is the time in ms, or in a unit other than the one in the header?",
        )
    if last < trial.obstacle_end():
        raise FitError(
            "the recording is shorter than the obstacle pass",
            found=f"{last:.4g} s",
            allowed=Phrase("at least {obstacle_end:.4g} s", obstacle_end=trial.obstacle_end()),
            hint="Check speed, start and length of the obstacle, or record longer.",
        )


@dataclass
class Runner:
    """Runs the updates of a campaign and compares trials with the model."""

    campaign: Campaign
    folder: Path
    loaded: dict[int, _Loaded]
    rig_text: str
    bench: Characterisation
    findings: list[Finding]
    progress: Progress
    sensors: dict[int, Mapping[str, Sensor]] = field(default_factory=dict)
    compared: dict[tuple[str | float | None, ...], _Compared] = field(default_factory=dict)
    truth: BenchTruth | None = None
    records: Mapping[int, xr.Dataset] = field(default_factory=dict)
    sought: dict[int, Sought] = field(default_factory=dict)
    as_read: dict[int, _Loaded] = field(default_factory=dict)
    strategies: tuple[int, int] = (0, 1)  # compared with all trials, of how many

    def fit_trial(self, item: _Loaded, knowledge: Knowledge) -> FitTrial:
        """Return a trial with its rig as set up for it."""
        entry = item.entry
        rig = rig_of(entry, knowledge)
        added = {SPRUNG_MASS: entry.added_mass} if entry.added_mass else {}
        sensors = self.sensors.get(entry.number, self.campaign.sensors)
        noise = item.facts.passages.noise if item.facts else {}
        return FitTrial(
            f"trial {entry.number}",
            rig,
            item.trial,
            item.measured,
            sensors,
            added,
            entry.wheel_load,
            noise=noise,
        )

    def place_trials(self, knowledge: Knowledge) -> None:
        """Find when each record passes its obstacle, and align the model with it; see `jounce.campaign.belt`."""
        if self.campaign.belt is not None and self.campaign.belt.length is None:
            self._measure_belt(knowledge)
        self.as_read = dict(self.loaded)
        for number, item in list(self.loaded.items()):
            if item.entry.road is None:
                continue
            name = f"trial {number}"
            try:
                trial, facts, findings = place_trial(
                    self.fit_trial(item, knowledge),
                    item.entry.speed,
                    item.entry.passage,
                    item.pulses,
                )
            except ObstacleNotFoundError as error:
                if error.sought is not None:
                    self.sought[number] = error.sought
                code = (
                    "campaign.trial_left_out"
                    if self.campaign.belt
                    else "campaign.obstacle_not_seen"
                )
                said: str = error.message(within=name)
                self.findings.append(finding(code, name, error=said))
                if self.campaign.belt:
                    del self.loaded[number]
                continue
            except Exception as error:  # noqa: BLE001 - one bad file never loses the others
                said = reason(error, name)
                self.findings.append(finding("campaign.trial_left_out", name, error=said))
                del self.loaded[number]
                continue
            if facts is not None:
                self.sensors[number] = trial.sensors
                self.loaded[number] = replace(
                    item, trial=trial.trial, measured=trial.measured, facts=facts
                )
            self.findings += [
                item if item.place.startswith(name) else at_place(f"{name}: {item.place}", item)
                for item in findings
            ]
        on_belt = {number: item.facts for number, item in self.loaded.items() if item.facts}
        if self.campaign.belt is not None and self.campaign.belt.length is not None:
            common, is_in_doubt = common_speed_errors(on_belt, self.campaign.belt.length)
            if common:  # reported once instead of for every trial
                self.findings[:] = [
                    item for item in self.findings if item.code not in SPEED_CODES
                ] + common
            if is_in_doubt:
                self.loaded.clear()
                return
        self.findings += exchanged_trials(on_belt)

    def _measure_belt(self, knowledge: Knowledge) -> None:
        """Estimate the unknown length of the belt from speeds and obstacle passages, and set it for all roads."""
        met = []
        for item in self.loaded.values():
            road, speed = item.trial.road, item.trial.speed
            if road is None or speed is None or road.is_course():
                continue
            trial = self.fit_trial(item, knowledge)
            with suppress(JounceError):  # reported when the trial is aligned
                passages = find_passages(
                    item.measured, trial.rig, road, speed, sensors=trial.sensors, name=trial.name
                )
                met.append(
                    ((*passages.times, *passages.again), item.pulses.mean if item.pulses else speed)
                )
        measured = loop_length(met)
        if measured is None:
            self.findings.append(finding("campaign.belt_length_unknown", "belt"))
            return
        length, scatter = measured
        numbers = {"length": length, "scatter": scatter, "count": len(met)}
        self.findings.append(finding("campaign.belt_length_found", "belt", length, **numbers))
        for number, item in self.loaded.items():
            if item.trial.road is not None:
                road = with_recurrence(item.trial.road, Belt(length=length))
                self.loaded[number] = replace(item, trial=item.trial.with_fields(road=road))

    def decide_datums(self, knowledge: Knowledge) -> None:
        """Determine the zero of every channel once for all updates and comparisons, and check the signs."""
        trials, starts = dict[int, FitTrial](), dict[str, dict[str, QuietStart]]()
        for number, item in self.loaded.items():
            with suppress(Exception):  # reported when the trial is used
                trial = self.fit_trial(item, knowledge)
                starts[trial.name] = quiet_starts(trial)
                trials[number] = trial
        datums = datums_of(starts)
        for number, trial in trials.items():
            self.sensors[number] = with_datum(trial, starts[trial.name], datums).sensors
        self.findings += start_findings(starts)

    def update_all(
        self, start: Knowledge, chosen: Sequence[str] | None = None
    ) -> list[StrategyResult]:
        """Run all updates, or only those with the given names."""
        done: dict[str, StrategyResult] = {}
        for k, entry in enumerate(self.campaign.update, 1):
            if chosen is not None and entry.name not in chosen:
                continue
            try:
                self.progress(
                    progress_through(
                        "update {which} of {count}: {name}",
                        k,
                        len(self.campaign.update),
                        name=entry.name,
                    )
                )
                done[entry.name] = self._update(entry, start, done)
            except Exception as error:  # noqa: BLE001 - one bad file never loses the others
                said = reason(error, entry.name)
                self.findings.append(finding("campaign.update_left_out", entry.name, error=said))
        return list(done.values())

    def set_up(
        self, entry: UpdateEntry, start: Knowledge, done: Mapping[str, StrategyResult]
    ) -> tuple[Knowledge, list[_Loaded], list[FitTrial], UpdateSettings]:
        """Return the knowledge before an update, the trials to fit, and the settings."""
        knowledge = start
        if entry.start_from is not None:
            if entry.start_from not in done:
                raise FitError("the update on which it is based failed", found=entry.start_from)
            knowledge = done[entry.start_from].knowledge
        if entry.tyre_law == "polynomial":
            knowledge = polynomial_tyres(self.campaign.bench, knowledge, self.folder, self.bench)
        chosen = self._trials_of(entry)
        trials = [self.fit_trial(item, knowledge) for item in chosen]
        settings = UpdateSettings(
            name=entry.name,
            method=entry.method,
            weights=entry.weights,
            channels=entry.channels,
            align=entry.align,
            nuisances=entry.nuisances,
            starts=entry.starts,
            doubt=self.campaign.doubt,
            bench=bench_values(self.bench, trials[0].rig, chosen[0].entry.tyre_pressure)
            if chosen
            else {},
        )
        return knowledge, chosen, trials, settings

    def _update(
        self, entry: UpdateEntry, start: Knowledge, done: dict[str, StrategyResult]
    ) -> StrategyResult:
        knowledge, chosen, trials, settings = self.set_up(entry, start, done)
        result, _ = run_update(trials, entry.free, settings)
        self.findings += [
            item if item.place == entry.name else at_place(f"{entry.name}: {item.place}", item)
            for item in result.findings
        ]
        after = knowledge.after(result.parameters, [item.entry.tyre_pressure for item in chosen])
        numbers = tuple(item.entry.number for item in chosen)
        strategy = StrategyResult(result, knowledge, after, numbers)
        if self.truth is not None:
            try:
                truth = true_values(self.truth, list(result.parameters), trials, chosen[0].entry)
                strategy = replace(strategy, truth=truth)
            except JounceError as error:
                self.findings.append(
                    finding("campaign.no_truths_of", "truth.toml", error=error, name=entry.name)
                )
        chain = [*self._before(entry, done), strategy]
        return replace(
            strategy, rig_texts=updated_rigs(self.campaign, self.rig_text, self.bench, chain)
        )

    def _before(self, entry: UpdateEntry, done: dict[str, StrategyResult]) -> list[StrategyResult]:
        """Return the updates that an update builds on, in order of execution."""
        if entry.start_from is None:
            return []
        earlier = next(update for update in self.campaign.update if update.name == entry.start_from)
        return [*self._before(earlier, done), done[earlier.name]]

    def _trials_of(self, entry: UpdateEntry) -> list[_Loaded]:
        if entry.trials == "fit":
            return [item for item in self.loaded.values() if item.entry.use == "fit"]
        lost = [number for number in entry.trials if number not in self.loaded]
        if lost:
            raise FitError("a required trial could not be used", found=f"trial {lost[0]}")
        return [self.loaded[number] for number in entry.trials]

    def compare_strategies(self, strategies: list[StrategyResult]) -> list[StrategyResult]:
        """Compare the model with all trials before and after every update."""
        compared = []
        for k, strategy in enumerate(strategies, 1):
            self.strategies = (k - 1, len(strategies))
            self.progress(
                progress_through(
                    "compare strategy {which} of {count}: {name}",
                    k,
                    len(strategies),
                    name=strategy.update.name,
                )
            )
            compared.append(self._compare_trials(strategy))
        return compared

    def _compare_trials(self, strategy: StrategyResult) -> StrategyResult:
        lags = strategy.update.lags
        trials = []
        for number, item in self.loaded.items():
            lag = lags.get(f"trial {number}", None if lags else 0.0)
            before = self.comparison(item, strategy.start, lag)
            after = self.comparison(
                item, strategy.knowledge, lag, strategy.update.offsets.get(f"trial {number}")
            )
            trials.append(
                StrategyTrial(
                    number, number in strategy.fitted_on, before[0], after[0], before[1], after[1]
                )
            )
        return replace(strategy, trials=tuple(trials))

    def compare_all(self, start: Knowledge, strategies: list[StrategyResult]) -> list[TrialResult]:
        """Compare every trial with the characterised model and with the model after the last update."""
        final = strategies[-1].knowledge if strategies else start
        lags = {name: lag for strategy in strategies for name, lag in strategy.update.lags.items()}
        offsets = {
            name: offset
            for strategy in strategies
            for name, offset in strategy.update.offsets.items()
        }
        aligned = any(entry.align for entry in self.campaign.update)
        return [
            self._compare(entry, start, final, lags, offsets, aligned)
            for entry in self.campaign.trial
        ]

    def exchanged_conditions(
        self, knowledge: Knowledge, trials: Sequence[TrialResult]
    ) -> list[Finding]:
        """Find pairs of records that are better explained by each other's conditions."""
        known = {item.place for item in self.findings if item.code == "campaign.trials_exchanged"}
        left = {
            trial.entry.number: min(channel.r2 for channel in trial.after.channels.values())
            for trial in trials
            if trial.after is not None and trial.after.verdict != "holds"
        }
        doubtful = sorted(left, key=lambda number: left[number])
        conditions = {number: _conditions(self.loaded[number].entry) for number in doubtful}

        def under(record: int, other: int) -> FitTrial:
            own, set_up = self.as_read[record], self.as_read[other]
            trial = set_up.trial.with_fields(duration=own.trial.duration)
            if (
                trial.road is not None and trial.road.recurrence is not None
            ):  # the speed belongs to the record
                trial = trial.with_fields(speed=own.trial.speed)
            item = replace(set_up, trial=trial, measured=own.measured)
            held = self.fit_trial(item, knowledge)
            return held if trial.road is None else place_trial(held, None, "all", own.pulses)[0]

        exchanges = better_exchanged(
            doubtful, lambda first, other: conditions[first] == conditions[other], under
        )
        return [item for item in exchanges if item.place not in known]

    def compare_with_lumped(self, knowledge: Knowledge) -> ModelComparison | None:
        """Compare a 3-D rig with its equivalent quarter car; None for a lumped rig."""
        if not isinstance(knowledge.rig, Corner) or knowledge.rig.guide == "fixed":
            return None
        self.progress("compare: lumped model")
        try:
            comparison = compare_models(knowledge.rig)
            peaks = [peak for item in self.loaded.values() for peak in self._peaks(item, knowledge)]
        except Exception as error:  # noqa: BLE001 - one bad file never loses the others
            self.findings.append(
                finding("campaign.lumped_not_compared", "lumped model", error=reason(error))
            )
            return None
        return replace(comparison, peaks=tuple(peaks))

    def poses(self, trials: list[TrialResult]) -> dict[float | None, xr.Dataset]:
        """Compute poses over the travel of all trials at each strut angle; none for lumped rigs."""
        sweeps: dict[float | None, xr.Dataset] = {}
        for angle in dict.fromkeys(trial.entry.strut_angle for trial in trials):
            motions = [
                t.motion for t in trials if t.motion is not None and t.entry.strut_angle == angle
            ]
            motions = [
                motion
                for motion in motions
                if isinstance(motion.rig, Corner) and "sprung.z" in motion.outputs
            ]
            if not motions:
                continue
            travels = [
                motion.outputs["unsprung.z"] - motion.outputs["sprung.z"] for motion in motions
            ]
            low, high = (
                min(float(part.min()) for part in travels),
                max(float(part.max()) for part in travels),
            )
            grid = np.linspace(min(low, -_LEAST_TRAVEL), max(high, _LEAST_TRAVEL), _POSES)
            with suppress(JounceError):
                sweeps[angle] = sweep_travel(motions[0].rig, grid, points=True)
        return sweeps

    def _peaks(self, item: _Loaded, knowledge: Knowledge) -> list[PeakDifference]:
        entry = item.entry
        rig = rig_of(entry, knowledge)
        assert isinstance(rig, Corner)
        return compare_peaks(f"trial {entry.number}", rig, lumped_from(rig), item.trial)

    def _compare(
        self,
        entry: TrialEntry,
        start: Knowledge,
        final: Knowledge,
        lags: Mapping[str, float],
        offsets: Mapping[str, Mapping[str, float]],
        aligned: bool,
    ) -> TrialResult:
        name = f"trial {entry.number}"
        item = self.loaded.get(entry.number)
        if item is None:
            return TrialResult(entry, None, None, None, {}, {})
        which = list(self.loaded).index(entry.number) + 1
        title = Phrase("trial {number}", number=entry.number)
        done, strategies = self.strategies
        count = len(self.loaded)
        self.progress(
            Stage(
                "compare trial {which} of {count}: {name}",
                share=(done + (which - 1) / count) / strategies,
                which=which,
                count=count,
                name=title,
            )
        )
        lag = lags.get(name, None if aligned else 0.0)
        pitch = item.trial.road.pitch if isinstance(item.trial.road, Train) else None
        before, curves_before, _, _ = self.comparison(item, start, lag)
        after, curves, notes, motion = self.comparison(item, final, lag, offsets.get(name))
        self.findings += _without_repeats(notes)
        return TrialResult(entry, pitch, before, after, curves_before, curves, motion, item.facts)

    def comparison(
        self,
        item: _Loaded,
        knowledge: Knowledge,
        lag: float | None,
        offset: Mapping[str, float] | None = None,
    ) -> _Compared:
        """Compare a trial with a model; results are cached, and a failure is reported as a finding.

        ``offset`` is the estimated deviation from equilibrium at the start of the trial.
        """
        trial = self.fit_trial(item, knowledge)
        trial = trial.in_motion(offset) if offset else trial
        key = (trial.name, lag, trial.rig.model_dump_json(), *trial.offset.values())
        if key not in self.compared:
            try:
                self.compared[key] = compare_trial(trial, lag)
            except Exception as error:  # noqa: BLE001 - one bad file never loses the others
                self.findings.append(
                    finding("campaign.not_compared", trial.name, error=reason(error))
                )
                self.compared[key] = (None, {}, [], None)
        return self.compared[key]


def _conditions(entry: TrialEntry) -> dict[str, Any]:
    """Return the conditions of a trial, without its record and reading options."""
    names = (
        "road",
        "excitation",
        "strut_angle",
        "tyre_pressure",
        "added_mass",
        "changes",
        "adjustments",
        "speed",
    )
    return entry.model_dump(include=set(names))


def _without_repeats(notes: list[Finding]) -> list[Finding]:
    """Reduce the location of notes to their channel: notes about the sample rate are the same for all trials."""
    return [at_place(n.place.split(", ")[-1], n) if n.severity == "note" else n for n in notes]


def _unique(findings: list[Finding]) -> list[Finding]:
    """Remove duplicate findings, keeping their order."""
    seen: dict[tuple[str, str], Finding] = {}
    for item in findings:
        seen.setdefault((item.place, item.message), item)
    return list(seen.values())
