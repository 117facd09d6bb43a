"""Records section of a campaign report: spectra and transfer functions with the model, modes, channel statistics."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.display import display_unit
from jounce.plots.display import number, percent, quantity, ratio_unit, setting_text, with_half
from jounce.report.chart import Chart, Panel, Series
from jounce.report.page import (
    Block,
    Cell,
    Details,
    PageTable,
    Paragraph,
    Section,
    Subsection,
    unique_slugs,
)

if TYPE_CHECKING:
    from jounce.analysis.spectrum import RecordSpectra
    from jounce.analysis.transfer import TransferEstimate
    from jounce.campaign.first_look import ComparedMode, ComparedSpectra, FirstLook, TrialStatistics


def records(look: FirstLook) -> Section:
    """Return spectra and transfer functions per pressure, modes of decays and trials, and channel statistics."""
    blocks: list[Block] = []
    names = unique_slugs(
        [f"spectra {setting_text(spectra.pressure, 'Pa')}" for spectra in look.spectra]
    )
    if look.spectra:
        charts = tuple(
            _spectra(spectra, name) for spectra, name in zip(look.spectra, names, strict=True)
        )
        blocks.append(Subsection("Spectra and transfer functions", charts))
    if look.modes:
        blocks.append(Subsection("Modal frequencies and damping", (_modes(look.modes),)))
    if look.statistics:
        table = _statistics(look.statistics)
        blocks.append(
            Subsection(
                "Statistics of the channels", (Details("Every trial and channel", (table,)),)
            )
        )
    if not blocks:
        blocks.append(Paragraph("No record could be analysed; see Findings."))
    return Section("Records", tuple(blocks))


def _spectra(spectra: ComparedSpectra, name: str) -> Chart:
    panels = [_density(spectra, k) for k in range(len(spectra.measured.channels))]
    words = "Amplitude density of each channel"
    if spectra.transfer is not None and spectra.model_transfer is not None:
        panels += _transfer(spectra.transfer, spectra.model_transfer)
        words += ", and gain and coherence from wheel to body"
    settings = ", ".join(
        text
        for text in (setting_text(spectra.pressure, "Pa"), setting_text(spectra.angle, "rad"))
        if text != "–"
    )
    caption = (
        f"{_trials(spectra.trials).capitalize()}{f' ({settings})' if settings else ''}: {words[0].lower()}{words[1:]}. "
        "The model's signals in the same trials are analysed in the same way."
    )
    return Chart(tuple(panels), name, caption, f"{words}, measured and of the model.")


_ROLES = (("measured", "measured"), ("after", "model"))


def _density(compared: ComparedSpectra, channel: int) -> Panel:
    both: tuple[RecordSpectra, ...] = (compared.measured, compared.simulated)
    unit = display_unit(compared.measured.channels[channel].unit)
    series = []
    for spectra, (role, label) in zip(both, _ROLES, strict=True):
        row = spectra.channels[channel]
        series.append(
            Series(row.frequency, np.sqrt(row.density) * unit.factor, role, "line", label)
        )
    return Panel(
        tuple(series),
        "frequency [Hz]",
        f"density [({unit.name})/√Hz]",
        both[0].channels[channel].channel,
        from_zero=True,
    )


def _transfer(measured: TransferEstimate, model: TransferEstimate) -> list[Panel]:
    both = (measured, model)
    output, into = display_unit(measured.output_unit), display_unit(measured.given_unit)
    factor = output.factor / into.factor
    gains = [
        Series(transfer.frequency, transfer.gain * factor, role, "line", label)
        for transfer, (role, label) in zip(both, _ROLES, strict=True)
    ]
    coherences = [
        Series(transfer.frequency, transfer.coherence, role, "line", label)
        for transfer, (role, label) in zip(both, _ROLES, strict=True)
    ]
    title = f"{measured.output} over {measured.given}"
    across = "frequency [Hz]"
    return [
        Panel(
            tuple(gains),
            across,
            f"gain [{ratio_unit(output.name, into.name)}]",
            title,
            from_zero=True,
        ),
        Panel(
            tuple(coherences),
            across,
            "coherence [–]",
            "coherence over the trials",
            y_range=(0.0, 1.0),
        ),
    ]


def _modes(modes: Sequence[ComparedMode]) -> PageTable:
    rows = [
        (
            mode.decay or _trials(mode.trials),
            with_half(mode.frequency),
            number(mode.model_frequency),
            number(mode.readings_frequency),
            with_half(mode.damping_ratio),
            number(mode.model_damping_ratio),
            number(mode.readings_damping_ratio),
        )
        for mode in modes
    ]
    model = ("linear model", "model, same fit")
    header = (
        "record",
        "frequency [Hz]",
        *(f"{model_name} [Hz]" for model_name in model),
        "damping ratio",
        *model,
    )
    note = (
        "± half of the 95 % interval due to noise. Undamped natural frequencies of free motion: decays, and "
        "trials after their last obstacle. The linear model and the damping of decays exclude dry friction; "
        "in trials friction counts as damping. Same fit: to the model's signals in these trials, with friction; – "
        "if they show no such mode."
    )
    return PageTable("Modes of the records and of the model", header, tuple(rows), "lrrrrrr", note)


def _statistics(statistics: Sequence[TrialStatistics]) -> PageTable:
    rows: list[tuple[Cell | str, ...]] = []
    for trial in statistics:
        for row in trial.channels:
            mean = row.mean.value if abs(row.mean.value) > _ROUNDING * row.rms.value else 0.0
            values = (mean, row.rms.value, row.minimum, row.maximum)
            share = trial.clipped[row.channel]
            clipped = Cell(percent(share), "bad", "at its limits") if share else "–"
            rows.append(
                (
                    str(trial.number),
                    row.channel,
                    *(quantity(value, row.unit, 3) for value in values),
                    number(row.crest_factor, 3),
                    clipped,
                )
            )
    header = (
        "trial",
        "channel",
        "mean (offset)",
        "r.m.s.",
        "minimum",
        "maximum",
        "crest factor",
        "clipped",
    )
    note = (
        "Before the fit removes zero offsets; AC coupling has already removed the mean. Clipped: share of the samples "
        "at the channel's limits."
    )
    return PageTable("Statistics of the channels", header, tuple(rows), "llrrrrrr", note)


_ROUNDING = 1e-9  # of the r.m.s.: residual of a mean that the conditioning removed


def _trials(numbers: Sequence[int]) -> str:
    return f"trial{'' if len(numbers) == 1 else 's'} {', '.join(map(str, numbers))}"
