"""Page of a posterior: parameter intervals, then draws, profiles, and bands for every trial."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from jounce.core.display import display_unit
from jounce.core.old_names import old_argument
from jounce.core.text import slug
from jounce.plots.display import number
from jounce.plots.posterior import posterior_bands, posterior_draws, profile_likelihood
from jounce.report.campaign import SYNTHETIC_NOTE
from jounce.report.page import (
    Block,
    Bullets,
    Cell,
    Fact,
    Facts,
    Findings,
    Page,
    PageTable,
    Paragraph,
    Picture,
    Section,
    Subsection,
    TableColumn,
    findings_blocks,
    sections_of,
    table_of,
)

if TYPE_CHECKING:
    from jounce.campaign.posterior import CampaignPosterior
    from jounce.identify.next_trial import NextTrials
    from jounce.identify.posterior import Posterior

_DRAWS = {
    "noise only": "Draws of each parameter with the limits of its 95 % interval, and of each pair.",
    "model error": "Draws of the test machine's value for each part (bars) and of the model's law over the ride "
    "(line), with the limits of the 95 % interval that covers both; below: pairs of parts.",
}
_PROFILES = (
    "Profile log likelihood of each parameter, compared with a Gaussian of the same curvature."
)
_MOST_TRIALS = 20
_INSIDE, _FEW_INSIDE = 0.9, 0.8
"""Thresholds for the fraction of samples in a 95 % band: chosen, because neighbouring samples are correlated."""
_COUNTED = {
    "noise only": "Noise only: how far values would scatter if the trials were run again. Model error is "
    "not included.",
    "model error": "All uncertainties of the campaign are included: law shapes, masses, sensors, obstacles, speeds, "
    "and the unexplained residual. Values are those of the physical parts.",
}


@old_argument("found", "posterior")
def posterior_page(posterior: Posterior, *, title: str, synthetic: str = "") -> Page:
    """Create a page of a posterior.

    Parameters
    ----------
    posterior : Posterior
        Result of :func:`jounce.posterior`.
    title : str
        Name of the fit.
    synthetic : str
        Note on synthetic recordings, if any.

    Returns
    -------
    Page
        Page to be written with :func:`jounce.report.write_page`.
    """
    parts: dict[str, Callable[[], Section]] = {
        "Answer": lambda: Section("Answer", _answer(posterior)),
        "Draws": lambda: Section(
            "Draws",
            (
                Picture(
                    posterior_draws(posterior),
                    "draws",
                    _DRAWS[posterior.counted],
                    _DRAWS[posterior.counted],
                ),
            ),
        ),
        "Profile likelihood": lambda: Section(
            "Profile likelihood",
            (Picture(profile_likelihood(posterior), "profiles", _PROFILES, _PROFILES),),
        ),
    }
    if posterior.predictions:
        parts["Predictions"] = lambda: Section("Predictions", _predictions(posterior))
    parts["How it was made"] = lambda: Section("How it was made", (_method(posterior),))
    sections, missing = sections_of(parts)
    return Page(
        title, sections, f"Posterior of {posterior.name}; {posterior.counted}", missing=missing,
        banner=f"{SYNTHETIC_NOTE}. {synthetic}" if synthetic else "", figure_note=SYNTHETIC_NOTE if synthetic else "",
    )  # fmt: skip


def campaign_posterior_page(answer: CampaignPosterior, *, title: str) -> Page:
    """Create a page of the posterior of a campaign."""
    return posterior_page(answer.posterior, title=title, synthetic=answer.campaign.synthetic)


def campaign_posterior_summary(answer: CampaignPosterior, *, title: str) -> Page:
    """Create a page of the posterior of a campaign, without figures."""
    return posterior_summary(answer.posterior, title=title)


def posterior_summary(posterior: Posterior, *, title: str) -> Page:
    """Create a page of a posterior without figures; ``title`` is the name of the fit."""
    blocks = (*_answer(posterior), *(_bands(posterior) if posterior.predictions else ()))
    return Page(
        title, (Section("Answer", blocks),), f"Posterior of {posterior.name}; {posterior.counted}"
    )


def _answer(posterior: Posterior) -> tuple[Block, ...]:
    from jounce.identify.posterior import FEWEST_DRAWS, MOST_ERROR, MOST_R_HAT

    worst = max(parameter.convergence.r_hat for parameter in posterior.parameters.values())
    least = min(
        min(parameter.convergence.bulk, parameter.convergence.tail)
        for parameter in posterior.parameters.values()
    )
    facts = (
        Fact("Counted", posterior.counted, ""),
        Fact(
            "Draws", str(posterior.draws), f"{least:.0f} effective at least",
            "good" if least >= FEWEST_DRAWS else "fair",
        ),
        Fact("R-hat", f"{worst:.3f}", "1.01 at most", "good" if worst <= MOST_R_HAT else "bad"),
        Fact(
            "Error of the log density", f"{posterior.density_error:.2g}", "at draws that were simulated",
            "good" if posterior.density_error <= MOST_ERROR else "fair",
        ),
    )  # fmt: skip
    rows = []
    for path, parameter in posterior.parameters.items():
        unit = display_unit(
            parameter.unit or "1", max(abs(parameter.interval[0]), abs(parameter.interval[1]))
        )

        def ends(pair: tuple[float, float] | None, factor: float = unit.factor) -> str:
            return "–" if pair is None else " to ".join(number(end * factor) for end in pair)

        shown = (
            number(parameter.value * unit.factor),
            ends(parameter.interval),
            ends(parameter.gaussian),
            ends(parameter.likelihood),
        )
        rows.append(
            (
                path,
                unit.name or "–",
                *shown,
                f"{parameter.convergence.r_hat:.3f}",
                f"{parameter.convergence.bulk:.0f}",
            )
        )
    intervals = ("95 % of draws", "Gaussian", "profile likelihood")
    header = ("parameter", "unit", "value", *intervals, "R-hat", "effective draws")
    table = PageTable(
        "Intervals of each parameter", header, tuple(rows), "llrrrrrr", _note(posterior)
    )
    blocks: list[Block] = [Paragraph(_COUNTED[posterior.counted]), Facts(facts), table]
    blocks += findings_blocks(posterior.findings)
    return tuple(blocks)


def _note(posterior: Posterior) -> str:
    if posterior.counted == "noise only":
        return "A dash: the profile does not end within the bounds."
    return (
        "The first two intervals cover the test machine's value for the part and the model's law over the ride; "
        "that of the profile refers to the parameter of the extended model. A dash: it extends beyond the figure."
    )


def _bands(posterior: Posterior) -> tuple[Block, ...]:
    rows = []
    for trial, channels in posterior.predictions.items():
        for channel, band in channels.items():
            share = f"{100.0 * band.inside:.0f} %"
            inside = Cell(
                share,
                "good"
                if band.inside >= _INSIDE
                else "fair"
                if band.inside >= _FEW_INSIDE
                else "bad",
            )
            rows.append((trial, "fitted" if band.is_fitted else "held out", channel, inside))
    header = ("trial", "use", "channel", "samples in the 95 % band")
    return (PageTable("Fraction of every recording within its band", header, tuple(rows), "lllr"),)


def _predictions(posterior: Posterior) -> tuple[Block, ...]:
    blocks: list[Block] = [*_bands(posterior)]
    for trial in posterior.predictions:
        words = f"{trial}: measured, mean of the draws, 95 % bands of parameters alone and of all uncertainties."
        picture = Picture(posterior_bands(posterior, trial), f"bands-{slug(trial)}", words, words)
        blocks.append(Subsection(trial, (picture,)))
    return tuple(blocks)


def next_trials_page(ranking: NextTrials, *, title: str) -> Page:
    """Create a page of possible next trials, most informative first.

    Parameters
    ----------
    ranking : NextTrials
        Result of :func:`jounce.next_trials`.
    title : str
        Name of the update.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.
    """
    shown = ranking.candidates[:_MOST_TRIALS]
    errors = [
        TableColumn(
            f"± {path}",
            [now, *(candidate.standard_errors[path] for candidate in shown)],
            ranking.units[path] or "1",
        )
        for path, now in ranking.now.items()
    ]
    names = TableColumn("trial", ["today", *(candidate.name for candidate in shown)])
    gains = TableColumn("gain [nat]", [None, *(candidate.gain for candidate in shown)], "1")
    left = len(ranking.candidates) - len(shown)
    more = f"{left} less informative trials are omitted; --json lists all. " if left else ""
    series = "one after the other: " + ", then ".join(
        candidate.name for candidate in ranking.series
    )
    caption = f"Information gained by the next trial, {ranking.counted}"
    blocks = (
        table_of(caption, [names, gains, *errors], f"{more}{series}"),
        Findings(ranking.findings),
    )
    return Page(title, (Section("Answer", blocks),), "Trials to run next")


def _method(posterior: Posterior) -> Block:
    return Bullets((
        f"The log density is a polynomial through exact values and slopes; all fitted trials were "
        f"simulated {posterior.evaluations} times for it, 16 of them at draws not used for the fit.",
        f"emcee drew {posterior.draws} points in {posterior.chains} chains ({100.0 * posterior.accepted:.0f} % of "
        "steps accepted); "
        "R-hat is rank-normalised, between four ensembles and their earlier and later halves; effective draws are "
        "those of the bulk; both by ArviZ.",
        "Bands come from draws that were each simulated exactly.",
        f"Seed {posterior.seed}: the same numbers each time.",
    ))  # fmt: skip
