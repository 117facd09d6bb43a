"""The report of a bench campaign, section by section, and the files that accompany it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from jounce.campaign.beside_reference import beside_reference
from jounce.core.display import display_unit, display_unit_for
from jounce.core.errors import JounceError
from jounce.core.findings import Finding
from jounce.core.serialise import to_json
from jounce.core.text import slug
from jounce.identify.estimate import Estimate
from jounce.plots.campaign import channels_of
from jounce.plots.display import (
    correlation,
    estimate_cells,
    milliseconds,
    number,
    percent,
    setting_text,
)
from jounce.report.answer import answer_chart, answer_table, answers, decisive
from jounce.report.bench_charts import road_panels
from jounce.report.characterisation import characterisation, replaced_table
from jounce.report.chart import Chart, Panel, Series, Style
from jounce.report.first_look import records
from jounce.report.page import (
    Block,
    Bullets,
    Cell,
    Details,
    Fact,
    Facts,
    Findings,
    Page,
    PageTable,
    Paragraph,
    Section,
    Subsection,
    Tone,
    findings_blocks,
    sections_of,
    unique_slugs,
    worst_first,
)
from jounce.report.render import write_page
from jounce.report.strategies import progress
from jounce.report.trials import scene_name, select_trials, trial_chart, trials_viewer
from jounce.roads import Road, read_roads

if TYPE_CHECKING:
    from jounce.campaign.description import TrialEntry
    from jounce.campaign.result import CampaignResult
    from jounce.campaign.strategy_result import StrategyResult
    from jounce.campaign.trial_result import ChannelComparison, TrialResult
    from jounce.design.model_comparison import ModelComparison, PeakDifference
    from jounce.identify.discrepancy import Discrepancy
    from jounce.identify.passages import Sought


SYNTHETIC_NOTE = "Synthetic data, not measurements"


def write_campaign(
    result: CampaignResult,
    out: Path | str,
    *,
    force: bool = False,
    figures: Sequence[str] = (),
    tables: Sequence[str] = (),
    pdf: bool = False,
    progress: Callable[[str], None] = lambda _text: None,
) -> list[Path]:
    """Write all results of a campaign into a folder.

    Parameters
    ----------
    result : CampaignResult
        Outcome of :func:`jounce.campaign.run_campaign`.
    out : Path or str
        Output folder; created if it does not exist. A folder that is not empty requires ``force``.
    force : bool
        Replace files of the same names in an existing folder; other files are kept.
    figures : sequence of str
        Formats in which every figure is also written as ``figures/<name>.<format>``: ``"svg"``, ``"png"``.
    tables : sequence of str
        Formats in which the tables are also written: ``"csv"`` (folder ``tables``), ``"xlsx"`` (``tables.xlsx``).
    pdf : bool
        Whether to write ``report.pdf`` as well.
    progress : callable
        Called with a one-line message at each stage.

    Returns
    -------
    list of Path
        ``report.html`` (self-contained), ``results.json``, the rigs of each update, and the requested figures. A rig
        is ``rig-<update>.toml``; with several tyre pressures there is one file per pressure, such as
        ``rig-<update>-0-31-mpa.toml``.

    Raises
    ------
    OutputError
        If the folder is not empty or cannot be written; nothing is changed then.
    DrawingError
        If figures or sections cannot be drawn; results, rigs and all other files have been written by then.
    """
    files = campaign_files(result)
    return write_page(
        lambda: campaign_page(result),
        out,
        files=files,
        force=force,
        figures=figures,
        tables=tables,
        pdf=pdf,
        progress=progress,
    )


def campaign_files(result: CampaignResult) -> dict[str, str]:
    """Return the results of a campaign as files, name to content: ``results.json`` and the rigs of each update."""
    names = unique_slugs([strategy.update.name for strategy in result.strategies])
    rigs = {
        f"rig-{name}{label and '-'}{slug(label) if label else ''}.toml": text
        for name, strategy in zip(names, result.strategies, strict=True)
        for label, text in strategy.rig_texts.items()
    }
    return {"results.json": to_json(result.to_dict()) + "\n", **rigs}


def campaign_page(result: CampaignResult) -> Page:
    """Return the report of a campaign as a page with figures; a section that cannot be drawn contains a notice."""
    synthetic, compared, reference = (
        result.campaign.synthetic,
        result.lumped,
        result.campaign.reference,
    )
    parts = {
        "Answer": lambda: answer(result),
        **({} if reference is None else {"Published result": lambda: published_results(result)}),
        "Curves": lambda: curves(result),
        "Validation": lambda: validation(result),
        "Records": lambda: records(result.look),
        "Characterisation": lambda: characterisation(result),
        "Updates": lambda: updates(result),
        **(
            {}
            if compared is None
            else {"Lumped model versus linkage": lambda: lumped_model(compared)}
        ),
        "Trials and roads": lambda: trials(result),
        "Findings": lambda: Section("Findings", (Findings(result.findings),)),
        "Method and definitions": lambda: method(result),
    }
    sections, missing = sections_of(parts)
    return Page(
        title=result.campaign.title,
        subtitle="Bench campaign: from measurements to an updated model",
        banner=f"{SYNTHETIC_NOTE}. {synthetic}" if synthetic else "",
        figure_note=SYNTHETIC_NOTE if synthetic else "",
        sections=sections,
        files=tuple(campaign_files(result).items()),
        missing=missing,
    )


def campaign_summary(result: CampaignResult) -> Page:
    """Return the results of a campaign without figures: measured values, updates, trials, findings."""
    replaced = (replaced_table(result),) if result.characterisation.replaced else ()
    updated: list[Block] = [_overview(result)] if result.strategies else []
    for strategy in result.strategies:
        units = {path: parameter.unit for path, parameter in strategy.update.parameters.items()}
        known = [
            block for block in discrepancy_blocks(strategy, units) if isinstance(block, PageTable)
        ]
        updated += [replace(table, note="") for table in (_parameters(strategy, units), *known)]
    sections = {
        "Characterisation": replaced,
        "Updates": [*updated, *([Paragraph(_NOISE_ONLY, "muted")] if updated else [])],
        "Trials": (_validation_table(result),),
        "Published result": (_reference_table(result),) if result.campaign.reference else (),
        "Findings": (Findings(result.findings),),
    }
    return Page(
        result.campaign.title,
        tuple(Section(title, tuple(blocks)) for title, blocks in sections.items()),
    )


TONES: dict[str, Tone] = {
    "holds": "good",
    "holds partly": "fair",
    "does not hold": "bad",
    "not usable": "muted",
}
_MOST_FINDINGS = 3
_VERDICT_WORDS = {
    "holds": "predicted within limits",
    "holds partly": "predicted partly",
    "does not hold": "not predicted",
    "not usable": "not usable",
}
_OTHERS = {"holds partly": "partly", "does not hold": "not", "not usable": "not usable"}


def verdict(trial: TrialResult) -> str:
    """Return the verdict in words, including for a trial that could not be compared."""
    return trial.after.verdict if trial.after is not None else "not usable"


def answer(result: CampaignResult) -> Section:
    """Return the section with values and intervals, the trials for which they hold, and warnings."""
    chain = decisive(result)
    facts = []
    for use, label in (("fit", "Fitted trials"), ("hold-out", "Held-out trials")):
        verdicts = [verdict(trial) for trial in result.trials if trial.entry.use == use]
        if verdicts:
            facts.append(_verdicts(label, verdicts))
    facts += [_reduction(strategy) for strategy in chain[-1:]]
    blocks: list[Block] = [Facts(tuple(facts))] if facts else []
    if not result.is_complete:
        blocks.append(
            Paragraph("Parts of this campaign failed; see Findings for what is missing.", "bad")
        )
    if not result.trials:
        blocks.append(
            Paragraph(
                "This campaign contains no trial: there is nothing that the model was held against."
            )
        )
    rows = answers(result)
    if rows:
        last = chain[-1] if chain else None
        name, count = ("", 0) if last is None else (last.update.name, len(last.fitted_on))
        blocks.append(answer_table(rows, name, count))
        picture = answer_chart(rows)
        if picture is not None:
            blocks.append(picture)
    blocks.append(
        Subsection(
            "Where these values hold",
            (Paragraph(_where_it_holds(result)), Paragraph(_what_was_done(result))),
        )
    )
    careful = most_important(_of_the_answer(result))
    blocks.append(Subsection("Warnings and notes", (Findings(careful),)))
    return Section("Answer", tuple(blocks))


def _where_it_holds(result: CampaignResult) -> str:
    """Return the counts of verdicts, separately for fitted and held-out trials, as sentences."""
    texts = []
    for use, words in (("fit", "Of those fitted"), ("hold-out", "Of those held out")):
        by_verdict: dict[str, list[str]] = {}
        for trial in result.trials:
            if trial.entry.use == use:
                by_verdict.setdefault(verdict(trial), []).append(str(trial.entry.number))
        parts = [
            f"{'trial' if len(numbers) == 1 else 'trials'} {_in_sentence(numbers)} "
            f"{'is' if len(numbers) == 1 else 'are'} {_VERDICT_WORDS[word]}"
            for word, numbers in by_verdict.items()
        ]
        if parts:
            texts.append(f"{words}, {'; '.join(parts)}.")
    return " ".join(texts) or "No trial was compared with the model."


def _of_the_answer(result: CampaignResult) -> tuple[Finding, ...]:
    """Return the findings except those of superseded updates, which are listed with their updates."""
    decisive_names = {strategy.update.name for strategy in decisive(result)}
    superseded = [s.update.name for s in result.strategies if s.update.name not in decisive_names]
    return tuple(
        finding
        for finding in result.findings
        if not any(
            finding.place == name or finding.place.startswith(f"{name}:") for name in superseded
        )
    )


def most_important(findings: Sequence[Finding]) -> tuple[Finding, ...]:
    """Select the most severe findings, one per code: findings of the same code differ only in their numbers."""
    kinds: dict[tuple[str, str], Finding] = {}
    for finding in worst_first(findings):
        error = str(finding.numbers.get("error", ""))
        kinds.setdefault((finding.code, error) if finding.code else ("", finding.message), finding)
    return tuple(kinds.values())[:_MOST_FINDINGS]


def _reduction(strategy: StrategyResult) -> Fact:
    update = strategy.update
    label = f"Objective, {update.name}"
    value = percent(-0.01 * update.reduction_percent)
    numbers = ", ".join(str(trial) for trial in strategy.fitted_on)
    trials = f"trial{'s' if len(strategy.fitted_on) > 1 else ''} {numbers}"
    note = (
        f"{number(update.objective_before)} → {number(update.objective_after)}, fitted on {trials}"
    )
    return Fact(label, value, note)


def _verdicts(label: str, verdicts: list[str]) -> Fact:
    counts = Counter(verdicts)
    note = ", ".join(f"{counts[word]} {words}" for word, words in _OTHERS.items() if counts[word])
    note = f"prediction within limits{'; ' if note else ''}{note}"
    tone: Tone = (
        "good" if counts["holds"] == len(verdicts) else "bad" if counts["does not hold"] else "fair"
    )
    return Fact(label, f"{counts['holds']} of {len(verdicts)} hold", note, tone)


def _what_was_done(result: CampaignResult) -> str:
    bench, asked = result.characterisation, result.campaign
    measured = [
        text
        for text, measurement in (
            ("the spring", bench.spring),
            (f"the tyre at {_count(len(bench.tyre), 'pressure')}", bench.tyre),
            ("the damping from " + _count(len(bench.decays), "free decay"), bench.decay),
        )
        if measurement
    ]
    first = f"Bench measurements characterise {_in_sentence(measured)}. " if measured else ""
    free = dict.fromkeys(
        path for strategy in result.strategies for path in strategy.update.parameters
    )
    second = (
        f"{len(result.strategies)} of {_count(len(asked.update), 'planned update')} "
        f"{'was' if len(asked.update) == 1 else 'were'} completed; fitted: "
        f"{_in_sentence(list(free))}. "
        if result.strategies
        else "No parameter was updated. "
    )
    compared = sum(trial.after is not None for trial in result.trials)
    third = f"{compared} of {_count(len(result.trials), 'trial')} were compared with the model"
    return f"{first}{second}{third}{' after the last update' if result.strategies else ''}."


def _count(number_of: int, word: str) -> str:
    """Return a count with its noun, singular or plural: ``1 update``, ``2 updates``, ``2 free decays``."""
    return f"{number_of} {word}" if number_of == 1 else f"{number_of} {word}s"


def _in_sentence(items: list[str]) -> str:
    return (
        items[0]
        if len(items) == 1
        else f"{', '.join(items[:-1])} and {items[-1]}"
        if items
        else "nothing"
    )


_OPEN = 3
_USES = {"fit": "fitted", "hold-out": "held out"}
_GRADE_TONES = {"excellent": "good", "good": "good", "fair": "fair", "poor": "bad"}


_REPRODUCED: dict[str, Tone] = {
    "reproduced": "good",
    "not reproduced": "bad",
    "not comparable": "muted",
}


def published_results(result: CampaignResult) -> Section:
    """Return a comparison of the campaign's results with the published result it cites."""
    return Section("Published result", (_reference_table(result),))


def _reference_table(result: CampaignResult) -> PageTable:
    rows = [
        (
            row.what,
            row.published,
            row.ours,
            Cell(row.verdict, _REPRODUCED[row.verdict]),
            row.follows,
        )
        for row in beside_reference(result.campaign.reference, result.strategies, result.trials)
    ]
    source = result.campaign.reference.source if result.campaign.reference else ""
    header = ("statement", "published", "here", "verdict", "what follows")
    note = "A published reduction counts as reproduced within 10 percentage points, a parameter within our interval."
    return PageTable(f"Beside the published result: {source}", header, tuple(rows), "lrrll", note)


def trials(result: CampaignResult) -> Section:
    """Return a table of all trials with their settings, and the road profiles."""
    rows = tuple(_setting(trial) for trial in result.trials)
    header = (
        "trial",
        "use",
        "speed",
        "road",
        "obstacle pitch",
        "strut angle",
        "tyre pressure",
        "recording",
    )
    blocks: list[Block] = [PageTable("Test matrix", header, rows, "llrlrrrl")]
    if any(trial.belt is not None for trial in result.trials):
        blocks.append(_belt_table(result))
    roads = _roads_of(result)
    if roads:
        words = f"Height profiles of the roads {', '.join(roads)}."
        blocks.append(
            Chart(
                road_panels(roads),
                "roads",
                "Road profiles: height against distance.",
                words,
                columns=1,
            )
        )
    return Section("Trials and roads", tuple(blocks))


def _belt_table(result: CampaignResult) -> PageTable:
    """Return belt speeds (as noted, from pulses, from recurrence), passages, and the scatter between loops."""
    rows = []
    for trial in result.trials:
        belt = trial.belt
        if belt is None:
            continue
        passages = belt.passages
        repeatability = ", ".join(
            f"{name} {percent(share)}" for name, share in passages.repeatability.items()
        )
        odd = f" (without {', '.join(map(str, passages.odd))})" if passages.odd else ""
        rows.append(
            (
                str(trial.entry.number),
                setting_text(belt.noted, "m/s", "speed"),
                setting_text(belt.pulses, "m/s", "speed"),
                setting_text(belt.speed, "m/s", "speed"),
                "–" if belt.slip is None else percent(belt.slip),
                f"{len(passages.times)}{odd}",
                setting_text(passages.times[0], "s"),
                repeatability or "–",
            )
        )
    header = (
        "trial",
        "speed noted",
        "by pulses",
        "driven",
        "slip",
        "passages",
        "first at",
        "scatter between loops",
    )
    note = "Scatter: r.m.s. of the differences between loops of the belt over the r.m.s. of their average."
    return PageTable("Belt and passages", header, tuple(rows), "lrrrrrrl", note)


def _road_or_motion(entry: TrialEntry) -> str:
    """Return the road, or the file of the base motion, and the file of the actuator force if any."""
    words = entry.road or (f"excitation {entry.excitation.file}" if entry.excitation else "")
    return (
        words
        if entry.actuator_force is None
        else f"{words}, actuator force {entry.actuator_force.file}"
    )


def _setting(trial: TrialResult) -> tuple[Cell | str, ...]:
    entry = trial.entry
    road = _road_or_motion(entry)
    lost = (
        Cell(entry.recording, "bad", "not usable, see Findings")
        if trial.after is None
        else entry.recording
    )
    return (
        str(entry.number),
        _USES[entry.use],
        setting_text(entry.speed, "m/s", "speed"),
        road or "–",
        setting_text(trial.obstacle_pitch, "m"),
        setting_text(entry.strut_angle, "rad"),
        setting_text(entry.tyre_pressure, "Pa"),
        lost,
    )


def validation(result: CampaignResult) -> Section:
    """Return ratings of all trials and channels, fitted and held out, and the error against speed and pitch."""
    model = "as last updated" if result.strategies else "as characterised"
    blocks: list[Block] = [
        Paragraph(
            f"Each trial is simulated with the model {model} and compared with its recording. The worst channel "
            "decides the verdict: the model holds with an ISO/TS 18571 rating above 0.80 and R² above 0.95, and holds "
            "partly with a rating above 0.58 and R² above 0.75. A verdict says how well the model predicts a recording "
            "within these limits; it does not say that its parameters are those of the parts."
        ),
        _matrix(result),
        _validation_table(result),
    ]
    if any(trial.after is not None for trial in result.trials):
        picture = _errors(result)
        blocks.append(Subsection("Error against speed and obstacle pitch", (picture,)))
    return Section("Validation", tuple(blocks))


def _matrix(result: CampaignResult) -> PageTable:
    """Return an overview of the ratings of all trials and channels before and after updating."""
    channels = channels_of(result.trials)
    drawn = select_trials(result, _verdicts_of(result))
    shown = {trial.entry.number: scene_name(trial.entry.number) for trial in drawn}
    rows = []
    for trial in result.trials:
        word = verdict(trial)
        use = _USES[trial.entry.use].replace(" ", "\u00a0")
        cells: list[Cell | str] = [
            Cell(str(trial.entry.number), show=shown.get(trial.entry.number, "")),
            use,
        ]
        for comparison in (trial.before, trial.after):
            for name in channels:
                channel = comparison.channels.get(name) if comparison is not None else None
                if channel is None:
                    cells.append("–")
                else:
                    cells.append(Cell(f"{channel.iso18571:.2f}", _GRADE_TONES[channel.grade]))  # type: ignore[arg-type]
        lowest = (
            min((c.r2 for c in trial.after.channels.values()), default=None)
            if trial.after is not None
            else None
        )
        cells += [
            "–" if lowest is None else f"{lowest:.3f}".replace("-", "−"),
            Cell(word, TONES[word]),
        ]
        rows.append(tuple(cells))
    header = (
        "trial",
        "use",
        *(f"{name}, {when}" for when in ("before", "after") for name in channels),
        "lowest R²",
        "verdict",
    )
    note = (
        "ISO/TS 18571 rating: above 0.94 excellent, above 0.80 good, above 0.58 fair, else poor. The number of a "
        "trial shows its curves."
    )
    caption = "ISO/TS 18571 rating of every trial and channel, before and after updating"
    return PageTable(caption, header, tuple(rows), "ll" + "r" * (2 * len(channels) + 1) + "l", note)


def _errors(result: CampaignResult) -> Chart:
    """Plot each trial's normalised error after updating against speed (single obstacles) or pitch (trains)."""
    usable = [trial for trial in result.trials if trial.after is not None]
    channels = channels_of(usable)
    speed, pitch = display_unit_for("m/s", "speed"), display_unit("m")
    single = [
        (speed.factor * t.entry.speed, t)
        for t in usable
        if t.entry.speed is not None and t.obstacle_pitch is None
    ]
    trains = [(pitch.factor * t.obstacle_pitch, t) for t in usable if t.obstacle_pitch is not None]
    panels = []
    for points, label, title in (
        (single, speed.label("speed"), "single obstacles"),
        (trains, pitch.label("pitch of the obstacles"), "trains"),
    ):
        series, notes = [], []
        for k, name in enumerate(channels):
            role = ("after", "other-5", "other-1", "other-2", "other-3", "other-4")[k % 6]
            for use, style, words in (("fit", "dots", "fitted"), ("hold-out", "rings", "held out")):
                here = [
                    (x, t.after.channels[name].nrmse, t)
                    for x, t in points
                    if t.entry.use == use and t.after and name in t.after.channels
                ]
                if here:
                    xs, ys = [x for x, _, _ in here], [y for _, y, _ in here]
                    series.append(Series(xs, ys, role, style, f"{name}, {words}"))  # type: ignore[arg-type]
                if k == 0:
                    notes += [(x, y, str(t.entry.number)) for x, y, t in here]
        if series:
            panels.append(
                Panel(
                    tuple(series),
                    label,
                    "NRMSE after updating [–]",
                    title,
                    notes=tuple(notes),
                    from_zero=True,
                )
            )
    words = "Normalised error of every trial against speed and obstacle pitch; all numbers are in the validation table."
    return Chart(
        tuple(panels), "validation-residual", f"{words} Numbers are those of the trials.", words
    )


def _validation_table(result: CampaignResult) -> PageTable:
    rows: list[tuple[Cell | str, ...]] = []
    for use in ("fit", "hold-out"):
        for trial in result.trials:
            if trial.entry.use == use:
                rows += _validation_rows(trial)
    header = (
        "trial",
        "use",
        "channel",
        "NRMSE",
        "R²",
        "peak error",
        "lag [ms]",
        "ISO 18571",
        "grade",
        "before",
        "verdict",
    )
    return PageTable(
        "Model compared with measurement, fitted trials first",
        header,
        tuple(rows),
        "lllrrrrrlrl",
        "Before: ISO 18571 rating before updating. For definitions, see Method and definitions.",
    )


def _validation_rows(trial: TrialResult) -> list[tuple[Cell | str, ...]]:
    head = (str(trial.entry.number), _USES[trial.entry.use])
    word = verdict(trial)
    if trial.after is None:
        return [(*head, "–", "–", "–", "–", "–", "–", "–", "–", Cell(word, TONES[word]))]
    rows: list[tuple[Cell | str, ...]] = []
    for k, (name, channel) in enumerate(trial.after.channels.items()):
        before = trial.before.channels.get(name) if trial.before is not None else None
        rows.append(
            (
                *(head if k == 0 else ("", "")),
                name,
                number(channel.nrmse, 2),
                f"{channel.r2:.3f}".replace("-", "−"),
                percent(channel.peak_error),
                milliseconds(channel.lag),
                f"{channel.iso18571:.2f}",
                Cell(channel.grade, _GRADE_TONES[channel.grade]),  # type: ignore[arg-type]
                f"{before.iso18571:.2f}" if before is not None else "–",
                Cell(word, TONES[word]) if k == 0 else "",
            )
        )
    return rows


def curves(result: CampaignResult) -> Section:
    """Return measured and simulated signals of all trials, in one viewer and as figures."""
    viewer = trials_viewer(result, _verdicts_of(result))
    blocks: list[Block] = [viewer] if viewer is not None else []
    scenes = {scene.name: scene for scene in viewer.scenes} if viewer is not None else {}
    for trial in result.trials:
        scene = scenes.get(scene_name(trial.entry.number))
        lost = Paragraph(
            "The recording could not be used, so there is nothing to plot (see Findings).", "bad"
        )
        if scene is None and (trial.signals or trial.signals_before):
            continue  # too many trials: the viewer lists the ones shown
        sought = result.sought.get(trial.entry.number)
        parts: list[Block] = [] if sought is None else [_sought(sought, trial.entry.number)]
        if scene is not None:
            parts.insert(0, trial_chart(scene, trial))
        blocks.append(
            Details(
                _heading(trial),
                tuple(parts or [lost]),
                note=_fit_figures(trial),
                show=scene.name if scene is not None else "",
            )
        )
    if not result.trials:
        blocks.append(Paragraph("This campaign contains no trial."))
    return Section("Curves", tuple(blocks))


def _sought(sought: Sought, number: int) -> Chart:
    """Plot a trial's record with the model response aligned where the two correlate best."""
    time = sought.response["time"].to_numpy()
    around = 2.0 * float(time[-1] - time[0])
    record = sought.record.sel(time=slice(float(time[0]) - around, float(time[-1]) + around))
    panels = []
    for name in map(str, record.data_vars):
        unit = display_unit(str(record[name].attrs["units"]))
        series = tuple(
            Series(
                record["time"].to_numpy(),
                record[name].to_numpy() * unit.factor,
                role,
                "line",
                label,
            )
            for record, role, label in (
                (record, "measured", "record"),
                (sought.response, "after", "looked for"),
            )
        )
        panels.append(Panel(series, "time [s]", unit.label(""), name))
    caption = (
        f"Trial {number}: the obstacle was not found. The model's response is drawn where it matches the record best, "
        f"with a correlation of {sought.likeness:.2f}."
    )
    words = "Record, and the model response that was searched for in it."
    return Chart(tuple(panels), f"sought-{number}", caption, words, columns=1)


def _verdicts_of(result: CampaignResult) -> dict[int, tuple[str, Tone]]:
    return {trial.entry.number: (word := verdict(trial), TONES[word]) for trial in result.trials}


def _heading(trial: TrialResult) -> str:
    entry = trial.entry
    parts = [f"Trial {entry.number} ({_USES[entry.use]})"]
    if entry.speed is not None:
        parts.append(setting_text(entry.speed, "m/s", "speed"))
    parts.append(f"road {entry.road}" if entry.road is not None else _road_or_motion(entry))
    return f"{', '.join(parts)}: {verdict(trial)}"


def _fit_figures(trial: TrialResult) -> str:
    """Return how well the worst channel of a trial fits, before and after updating."""
    if trial.after is None or not trial.after.channels:
        return ""
    name, channel = min(trial.after.channels.items(), key=lambda item: item[1].r2)
    before = trial.before.channels.get(name) if trial.before is not None else None
    first = "" if before is None else f"{_r2(before)} → "
    return f"{name}: R² {first}{_r2(channel)}, NRMSE {number(channel.nrmse, 2)}"


def _r2(channel: ChannelComparison) -> str:
    return f"{channel.r2:.3f}".replace("-", "−")


def _roads_of(result: CampaignResult) -> dict[str, Road]:
    """Return the roads used by the campaign's trials, by name."""
    try:
        roads = read_roads(result.campaign.roads, folder=result.folder)
    except JounceError:
        return {}
    used = {trial.entry.road for trial in result.trials}
    return {name: road for name, road in roads.items() if name in used}


def updates(result: CampaignResult) -> Section:
    """Return a section on all updates in order, naming those that failed."""
    done = {strategy.update.name for strategy in result.strategies}
    blocks: list[Block] = [
        Paragraph(f"Update {entry.name!r} failed and is omitted (see Findings).", "bad")
        for entry in result.campaign.update
        if entry.name not in done
    ]
    if not result.campaign.update:
        blocks.append(
            Paragraph(
                "No update was requested; the trials are compared with the characterised model."
            )
        )
    if result.strategies:
        blocks.append(_overview(result))
    if any(strategy.trials for strategy in result.strategies):
        blocks.append(progress(result))
    files = unique_slugs([f"update {strategy.update.name}" for strategy in result.strategies])
    decisive_names = {strategy.update.name for strategy in decisive(result)}
    for file, strategy in zip(files, result.strategies, strict=True):
        name, content = strategy.update.name, _strategy(strategy, file)
        superseded = f"{name}: superseded, not part of the final model"
        blocks.append(
            Subsection(name, content) if name in decisive_names else Details(superseded, content)
        )
    return Section("Updates", tuple(blocks))


def _overview(result: CampaignResult) -> PageTable:
    rows = tuple(
        (
            update.name,
            update.method,
            ", ".join(str(number_of) for number_of in strategy.fitted_on),
            number(update.objective_before),
            number(update.objective_after),
            percent(0.01 * update.reduction_percent),
            str(update.iterations),
            str(update.evaluations),
        )
        for strategy in result.strategies
        for update in (strategy.update,)
    )
    header = (
        "update",
        "method",
        "trials",
        "objective before",
        "objective after",
        "reduction",
        "iterations",
        "evaluations",
    )
    note = "Objective: weighted sum of squared differences over all channels and samples."
    return PageTable("Results of the updates", header, rows, "lllrrrrr", note)


def _strategy(strategy: StrategyResult, file: str) -> tuple[Block, ...]:
    update = strategy.update
    units = {path: p.unit for path, p in update.parameters.items()}
    blocks: list[Block] = [_parameters(strategy, units), *discrepancy_blocks(strategy, units)]
    blocks.append(_within_bounds(strategy, units, file))
    if len(update.parameters) > 1:
        blocks.append(_correlation(strategy))
    blocks.append(_identifiability(strategy))
    if update.lags:
        rows = tuple((name, milliseconds(lag, 2)) for name, lag in update.lags.items())
        blocks.append(
            PageTable(
                "Time lag of each recording relative to the simulation",
                ("trial", "lag [ms]"),
                rows,
                "lr",
            )
        )
    blocks += findings_blocks(update.findings)
    return tuple(blocks)


def _within_bounds(strategy: StrategyResult, units: dict[str, str], file: str) -> Chart:
    """Plot the fitted value of each parameter within its bounds, with the noise-only interval."""
    update = strategy.update
    series: list[Series] = []
    for row, p in enumerate(update.parameters.values()):
        middle, half = 0.5 * (p.lower + p.upper), 0.5 * (p.upper - p.lower)
        if p.interval is not None:
            ends = [min(max(100.0 * (end - middle) / half, -108.0), 108.0) for end in p.interval]
            series.append(Series(ends, [row, row], "after", "thick", "95 %, noise only"))
        series.append(
            Series([100.0 * (p.initial - middle) / half], [row], "muted", "rings", "initial")
        )
        role, style, words = (
            ("bad", "squares", "at a bound") if p.at_bound else ("after", "dots", "fitted")
        )
        series.append(Series([100.0 * (p.value - middle) / half], [row], role, style, words))  # type: ignore[arg-type]
    panel = Panel(
        tuple(series),
        "position between lower and upper bound [%]",
        verticals=((-100.0, "muted", ""), (100.0, "muted", "")),
        lanes=tuple(update.parameters),
        x_range=(-112.0, 112.0),
        width=620,
        height=84 + 24 * len(update.parameters),
    )
    fitted = "; ".join(
        f"{path} {estimate_cells(p, units[path])[0]} {display_unit(units[path]).name}"
        + (" at its bound" if p.at_bound else "")
        for path, p in update.parameters.items()
    )
    caption = (
        "Initial and fitted values within their bounds, with 95 % intervals of the noise only."
    )
    return Chart((panel,), file, caption, f"Fitted parameters of {update.name}: {fitted}.")


def _correlation(strategy: StrategyResult) -> PageTable:
    update = strategy.update
    count = len(update.parameters)
    values = [row[:count] for row in update.correlation[:count]]
    rows = []
    for i, path in enumerate(update.parameters):
        cells: list[Cell | str] = [f"{i + 1}  {path}"]
        for j in range(count):
            known = values[i][i] > 0.0 and values[j][j] > 0.0
            strong = known and i != j and abs(values[i][j]) > _STRONG
            text = ("1" if i == j else correlation(values[i][j])) if known else "–"
            cells.append(Cell(text, "fair") if strong else text)
        rows.append(tuple(cells))
    header = ("parameter", *(f"with {place}" for place in range(1, count + 1)))
    note = "– where a parameter is at a bound."
    return PageTable("Correlation of the estimates", header, tuple(rows), "l" + "r" * count, note)


_NOISE_ONLY = (
    "Standard errors and intervals are those of the noise only, which may be correlated: how far the values would "
    "scatter if the trials were run again. They do not cover model error. None is given for a parameter "
    "at its bound."
)


def _parameters(strategy: StrategyResult, units: dict[str, str]) -> PageTable:
    rows: list[tuple[Cell | str, ...]] = []
    for path, p in strategy.update.parameters.items():
        unit = display_unit(units[path], p.value)
        value, error, interval, name = estimate_cells(p, units[path])
        bounds = f"{number(p.lower * unit.factor)} to {number(p.upper * unit.factor)}"
        fitted = Cell(value, "fair", "at its bound") if p.at_bound else value
        rows.append(
            (path, number(p.initial * unit.factor), fitted, error, interval, bounds, name or "–")
        )
    header = (
        "parameter",
        "initial",
        "fitted",
        "standard error",
        "95 %, noise only",
        "bounds",
        "unit",
    )
    return PageTable(
        f"Parameters of {strategy.update.name}", header, tuple(rows), "lrrrrrl", _NOISE_ONLY
    )


def discrepancy_blocks(strategy: StrategyResult, units: dict[str, str]) -> tuple[Block, ...]:
    """Return tables of the parameters of the physical parts, with intervals that include model error."""
    discrepancy = strategy.update.discrepancy
    if discrepancy is None:
        text = (
            "This update gives no values of the physical parts: an interval that includes model error requires at "
            "least three fitted trials."
        )
        shown = _beside_truth(strategy, units)
        return (Paragraph(text), *((shown,) if shown is not None else ()))
    rows: list[tuple[Cell | str, ...]] = []
    for path, law in discrepancy.parameters.items():
        spread = 0.5 * law.half_width
        value, _, interval, name = estimate_cells(
            Estimate(law.value, spread, law.interval), units[path]
        )
        unit = display_unit(units[path], law.value)
        readings = " / ".join(
            number(estimate.value * unit.factor, 4) for estimate in (law.component, law.effective)
        )
        word = (
            Cell("identified", "good")
            if law.identified
            else Cell("not identified with this model", "fair", law.why)
        )
        truth = strategy.truth.get(path)
        true = (
            (number(truth * unit.factor, 4) if truth is not None else "–",)
            if strategy.truth
            else ()
        )
        rows.append(
            (path, value, interval, readings, *true, name or "–", _mostly(law.shares), word)
        )
    header = (
        "parameter",
        "value",
        "95 %, with model error",
        "part / model",
        *(("truth",) if strategy.truth else ()),
    )
    header = (*header, "unit", "mostly from", "verdict")
    return (
        PageTable(
            "Parameters of the physical parts",
            header,
            tuple(rows),
            "lrrr" + "r" * bool(strategy.truth) + "lll",
            "Value of the law over the states ridden. The interval holds what a test machine would give of the part "
            "and what the model's law has to be to give the part's force best; both are shown. "
            + ("Truth: the value behind the synthetic recordings. " if strategy.truth else "")
            + "Mostly from: what the width would shrink by most if it were known.",
        ),
        Paragraph(_sources_of_uncertainty(discrepancy)),
    )


def _beside_truth(strategy: StrategyResult, units: dict[str, str]) -> PageTable | None:
    if not strategy.truth:
        return None
    rows = []
    for path, truth in strategy.truth.items():
        unit = display_unit(units[path], truth)
        fitted = strategy.update.parameters[path].value
        rows.append(
            (
                path,
                number(fitted * unit.factor, 4),
                number(truth * unit.factor, 4),
                unit.name or "–",
            )
        )
    note = (
        "Truth: the value behind the synthetic recordings; of a tyre stiffness the slope at the static load, of a "
        "damping coefficient the one nearest to the damper's force over the velocities ridden."
    )
    return PageTable(
        "Fitted beside the truth",
        ("parameter", "fitted", "truth", "unit"),
        tuple(rows),
        "lrrl",
        note,
    )


def _mostly(shares: dict[str, float]) -> str:
    """Return the group that contributes most to the width of an interval."""
    if not shares:
        return "–"
    group = max(shares, key=lambda name: shares[name])
    return f"{group.replace('_', ' ')} ({percent(shares[group], 0)})"


def _sources_of_uncertainty(discrepancy: Discrepancy) -> str:
    groups = ", ".join(group.replace("_", " ") for group in discrepancy.counted)
    worst = _in_sentence(
        [f"{percent(share, 0)} in {name}" for name, share in discrepancy.unexplained.items()]
    )
    more = (
        f" More freedom for {discrepancy.would_reduce.replace('_', ' ')} would leave "
        f"{percent(discrepancy.reduced_to, 0)} of all."
        if discrepancy.would_reduce
        else ""
    )
    return (
        f"Counted as uncertain, with the standard deviations of the campaign's doubt table: {groups}. With all of "
        f"these fitted, too, {percent(discrepancy.objective, 0)} of the residual's energy is left. Of that, {worst} is "
        "neither noise nor explained; it counts as three observations for each channel and trial "
        f"({discrepancy.trials} trials).{more}"
    )


def _identifiability(strategy: StrategyResult) -> PageTable:
    known = strategy.update.identifiability
    count = len(strategy.update.parameters)
    rows = tuple(
        (
            f"{place}  {name}",
            number(sensitivity, 3),
            *(
                "1" if place == column else correlation(value)
                for column, value in enumerate(row[:count], 1)
            ),
        )
        for place, (name, sensitivity, row) in enumerate(
            zip(known.parameters, known.sensitivity, known.correlation, strict=True), 1
        )
    )
    header = ("parameter", "sensitivity", *(f"with {place}" for place in range(1, count + 1)))
    note = (
        f"Rank {known.rank} of {len(known.parameters)}, condition number {number(known.condition, 3)}. Sensitivity: "
        "r.m.s. change of the weighted residuals from the middle of the bounds to one end."
    )
    caption = "Identifiability before the fit: sensitivities and expected correlations"
    return PageTable(caption, header, rows, "lr" + "r" * count, note)


_STRONG = 0.9
"""Correlation above which a pair of estimates is coloured."""
_ROUNDING = 1e-5
"""Share of a body's mass below which a contribution is shown as 0: the error of the finite differences."""
_NOTICED = 0.05
"""Relative difference of a peak above which it is coloured."""


def lumped_model(comparison: ModelComparison) -> Section:
    """Return quantities about equilibrium, curves over travel, contributions of the bodies, and peaks of all trials."""
    blocks: list[Block] = [
        Paragraph(
            "The rig of this campaign is a spatial linkage. Near equilibrium it can be represented by two masses on "
            "strut and tyre: the quarter car below matches its wheel rate, its damping and both natural frequencies. "
            "What such a model cannot represent is listed with the reason."
        ),
        _differences(comparison),
        _travel(comparison),
        _shares(comparison),
    ]
    if comparison.peaks:
        blocks.append(_peaks(comparison.peaks))
    return Section("Lumped model versus linkage", tuple(blocks))


_MODELS: tuple[tuple[str, Style, str], ...] = (
    ("after", "line", "3-D"),
    ("before", "dashed", "lumped"),
)


def _travel(comparison: ModelComparison) -> Chart:
    curves, across = comparison.curves(), display_unit("m")
    panels = []
    for name, si in (("motion_ratio", "1"), ("wheel_rate", "N/m")):
        unit = display_unit(si)
        series = [
            Series(
                across.factor * comparison.travel,
                unit.factor * curves[name].to_numpy()[:, k],
                role,
                style,
                label,
            )
            for k, (role, style, label) in enumerate(_MODELS)
        ]
        words = str(curves[name].attrs["long_name"])
        panels.append(
            Panel(tuple(series), across.label("wheel travel from design"), unit.label(words), words)
        )
    return Chart(
        tuple(panels),
        "lumped-travel",
        "Motion ratio and wheel rate against wheel travel: the linkage, and the lumped model that matches it at "
        "equilibrium.",
        f"Motion ratio from {comparison.motion_ratio[0]:.4f} to {comparison.motion_ratio[-1]:.4f} "
        "over the travel shown, lumped "
        f"{comparison.lumped_motion_ratio:.4f}.",
    )


def _differences(comparison: ModelComparison) -> PageTable:
    rows = []
    for item in comparison.rows:
        pair = (item.spatial, item.lumped)
        unit = display_unit(
            item.unit, max((value for value in pair if value is not None), key=abs, default=0.0)
        )
        texts = ("–" if value is None else number(value * unit.factor) for value in pair)
        rows.append((item.quantity, *texts, unit.name, item.why))
    header = ("quantity, about equilibrium", "3-D", "lumped", "unit", "reason")
    note = "Modes are computed without dry friction, which would suppress small motions."
    return PageTable("Where the two models differ", header, tuple(rows), "lrrll", note)


def _shares(comparison: ModelComparison) -> PageTable:
    unit = display_unit("kg")
    rows = tuple(
        (
            name.replace("_", " "),
            number(unit.factor * part.mass),
            number(part.wheel_share, 3),
            *(
                number(
                    unit.factor * kilograms if abs(kilograms) > _ROUNDING * part.mass else 0.0, 3
                )
                for kilograms in (part.sprung_mass, part.unsprung_mass, part.inertance)
            ),
        )
        for name, part in comparison.lumping.shares.items()
    )
    masses = (unit.label(words) for words in ("sprung", "unsprung", "inertance"))
    header = ("body", unit.label("mass"), "travel ratio [–]", *masses)
    note = (
        "Travel ratio: vertical travel of the body's centre of mass per wheel travel. "
        "Inertance: additional effective mass due to rotation and lateral motion."
    )
    return PageTable(
        "Contribution of each body to sprung and unsprung mass", header, rows, "lrrrrr", note
    )


def _peaks(peaks: tuple[PeakDifference, ...]) -> PageTable:
    rows = []
    for k, peak in enumerate(peaks):
        unit = display_unit(peak.unit, peak.spatial)
        difference = (
            Cell(percent(peak.relative), "fair")
            if abs(peak.relative) > _NOTICED
            else percent(peak.relative)
        )
        first = peak.trial if k == 0 or peaks[k - 1].trial != peak.trial else ""
        rows.append(
            (
                first,
                peak.channel,
                number(peak.spatial * unit.factor),
                number(peak.lumped * unit.factor),
                unit.name,
                difference,
            )
        )
    header = ("trial", "channel", "3-D", "lumped", "unit", "difference")
    note = "Largest absolute values; each trial with its own strut angle and tyre. No measurements are involved."
    return PageTable(
        "Peak values of every trial in both models", header, tuple(rows), "llrrlr", note
    )


_DEFINITIONS = (
    (
        "objective",
        "Sum over all channels and samples of the squared difference between measurement and simulation (Eq. 2 of "
        "the quarter-car prototype paper), with the channel weights set in the campaign.",
    ),
    ("reduction", "100 (before − after) / before, relative to the start of the same update."),
    (
        "standard error of a parameter",
        "From the exact sensitivities at the optimum, allowing for residuals that are "
        "correlated over time (Newey and West); interval: value ± 1.96 standard errors.",
    ),
    (
        "NRMSE",
        "Root mean square of the difference over the standard deviation of the measured signal: 0 is perfect, 1 is as "
        "good as the mean of the measurement.",
    ),
    ("R²", "1 − NRMSE²."),
    (
        "peak error",
        "Largest absolute simulated value over the largest absolute measured value, minus 1.",
    ),
    ("lag", "Delay of the simulated signal with the largest cross-correlation."),
    (
        "ISO 18571",
        "Overall rating of ISO/TS 18571 (0.4 corridor + 0.2 phase + 0.2 magnitude + 0.2 slope): above 0.94 "
        "excellent, above 0.80 good, above 0.58 fair, else poor.",
    ),
    (
        "verdict",
        "Decided by the worst channel of a trial. Holds: ISO 18571 above 0.80 and R² above 0.95. Holds partly: above "
        "0.58 and 0.75. Else it does not hold; not usable: the recording could not be read or simulated.",
    ),
    (
        "stiffness",
        "Slope of the fitted law; its interval treats the trials as independent repetitions.",
    ),
    ("loss factor", "Energy dissipated per cycle over 2π times the work of loading."),
    (
        "viscous damping and dry friction",
        "Fit of m x″ + c x′ + F sign(x′) + k (x − x₀) = 0 to the free decay, solved in "
        "closed form from turning point to turning point.",
    ),
    (
        "sensitivity",
        "Root mean square change of the weighted residuals when a parameter goes from the middle of its bounds to "
        "one end, at the start values.",
    ),
)
_SOURCES = (
    "ISO/TS 18571:2014, Road vehicles: Objective rating metric for non-ambiguous signals.",
    "J. P. Den Hartog, Forced vibrations with combined Coulomb and viscous friction, "
    "Transactions of the ASME 53 (1931) 107–115.",
    "W. K. Newey, K. D. West, A simple, positive semi-definite, heteroskedasticity and autocorrelation "
    "consistent covariance "
    "matrix, Econometrica 55 (1987) 703–708.",
)


def method(result: CampaignResult) -> Section:
    """Return the section with version, campaign, definitions and sources."""
    import jounce

    blocks: list[Block] = [
        Paragraph(
            f"Generated by jounce {jounce.__version__} from {len(result.trials)} trials. All numbers are also in "
            "results.json "
            "(SI units); the updated rigs are the TOML files next to this page."
        )
    ]
    if result.campaign.synthetic:
        blocks.append(Paragraph(f"Origin of the data: {result.campaign.synthetic}", "bad"))
    if result.rig.source:
        blocks.append(Paragraph(f"Source of the values in the rig file: {result.rig.source}."))
    if result.campaign.estimated:
        listed = ", ".join(result.campaign.estimated)
        blocks.append(
            Paragraph(f"Estimated in the campaign file, because no source gives them: {listed}.")
        )
    if result.rig.estimated:
        listed = ", ".join(result.rig.estimated)
        blocks.append(
            Paragraph(f"Estimated in the rig file, because no source gives them: {listed}.")
        )
    blocks += [
        Subsection(
            "Definitions",
            (PageTable("Definitions of the quantities", ("quantity", "definition"), _DEFINITIONS),),
        ),
        Subsection("Sources", (Bullets(_SOURCES),)),
    ]
    return Section("Method and definitions", tuple(blocks))
