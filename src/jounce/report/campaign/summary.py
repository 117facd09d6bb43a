"""The first thing the reader sees: what was fitted, what it brought, where the model holds."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from typing import TYPE_CHECKING

from jounce.core.findings import Finding
from jounce.plots.display import number
from jounce.report.numbers import percent
from jounce.report.page import Block, Fact, Facts, Findings, Paragraph, Section, Subsection, Tone, worst_first

if TYPE_CHECKING:
    from jounce.campaign.result import CampaignResult, StrategyResult, TrialResult

TONES: dict[str, Tone] = {"holds": "good", "holds partly": "fair", "does not hold": "bad", "not usable": "muted"}
_MOST_FINDINGS = 3
_OTHERS = {"holds partly": "partly", "does not hold": "not", "not usable": "not usable"}


def verdict(trial: TrialResult) -> str:
    """Verdict in words, also of a trial that could not be compared."""
    return trial.after.verdict if trial.after is not None else "not usable"


def summary(result: CampaignResult) -> Section:
    """Box of numbers, what was done in words, what failed, the most important findings."""
    facts = [_reduction(strategy) for strategy in result.strategies]
    for use, label in (("fit", "Fitted trials"), ("hold-out", "Held-out trials")):
        verdicts = [verdict(trial) for trial in result.trials if trial.entry.use == use]
        if verdicts:
            facts.append(_verdicts(label, verdicts))
    blocks: list[Block] = [Facts(tuple(facts)), Paragraph(_what_was_done(result))]
    if not result.is_complete:
        blocks.append(Paragraph("Parts of this campaign failed; what is missing is listed under Findings.", "bad"))
    blocks.append(Subsection("Most important findings", (Findings(most_important(result.findings)),)))
    return Section("Summary", tuple(blocks))


def most_important(findings: Sequence[Finding]) -> tuple[Finding, ...]:
    """Choose the worst findings, each kind of sentence once: those that differ in numbers only say the same."""
    kinds: dict[str, Finding] = {}
    for finding in worst_first(findings):
        kinds.setdefault(re.sub(r"[\d.,+−-]+|\[\w+\]", "", finding.message), finding)
    return tuple(kinds.values())[:_MOST_FINDINGS]


def _reduction(strategy: StrategyResult) -> Fact:
    update = strategy.update
    label = f"Objective, {update.name}"
    value = percent(-0.01 * update.reduction_percent)
    numbers = ", ".join(str(one) for one in strategy.fitted_on)
    trials = f"trial{'s' if len(strategy.fitted_on) > 1 else ''} {numbers}"
    note = f"{number(update.objective_before)} → {number(update.objective_after)}, fitted on {trials}"
    return Fact(label, value, note)


def _verdicts(label: str, verdicts: list[str]) -> Fact:
    counts = Counter(verdicts)
    note = ", ".join(f"{counts[word]} {words}" for word, words in _OTHERS.items() if counts[word])
    tone: Tone = "good" if counts["holds"] == len(verdicts) else "bad" if counts["does not hold"] else "fair"
    return Fact(label, f"{counts['holds']} of {len(verdicts)} hold", note, tone)


def _what_was_done(result: CampaignResult) -> str:
    bench, asked = result.characterisation, result.campaign
    measured = [
        text
        for text, found in (
            ("the spring", bench.spring),
            (f"the tyre at {_count(len(bench.tyre), 'pressure')}", bench.tyre),
            ("the damping from " + _count(len(bench.decays), "free decay"), bench.decay),
        )
        if found
    ]
    first = f"Bench measurements gave {_listed(measured)}. " if measured else ""
    free = dict.fromkeys(path for strategy in result.strategies for path in strategy.update.parameters)
    second = (
        f"{_count(len(result.strategies), 'update').capitalize()} of {_count(len(asked.update), 'planned')} fitted "
        f"{_listed(list(free))}. "
        if result.strategies
        else "No parameter was updated. "
    )
    compared = sum(trial.after is not None for trial in result.trials)
    third = f"{compared} of {_count(len(result.trials), 'trial')} were compared with the model"
    return f"{first}{second}{third}{' after the last update' if result.strategies else ''}."


def _count(number_of: int, word: str) -> str:
    """One thing or several: ``1 update``, ``2 updates``, ``2 free decays``."""
    plural = {"free decay": "free decays", "planned": "planned"}.get(word, f"{word}s")
    return f"{number_of} {word if number_of == 1 else plural}"


def _listed(items: list[str]) -> str:
    return items[0] if len(items) == 1 else f"{', '.join(items[:-1])} and {items[-1]}" if items else "nothing"
