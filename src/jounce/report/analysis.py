"""Pages of record analyses: statistics, spectra, transfer functions, modes, integrated accelerations."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from jounce.core.display import display_unit
from jounce.core.old_names import old_argument
from jounce.plots import figure_of
from jounce.plots.display import number, percent, quantity, ratio_unit, with_half
from jounce.report.page import (
    Block,
    Fact,
    Facts,
    Page,
    PageTable,
    Picture,
    TableColumn,
    answer_page,
    findings_blocks,
    table_of,
)

if TYPE_CHECKING:
    from collections.abc import Sequence

    from jounce.analysis.integrate import Integration
    from jounce.analysis.modes import FittedModes, MeasuredMode
    from jounce.analysis.spectrum import RecordSpectra, SpectralPeak
    from jounce.analysis.statistics import ChannelStatistics, RecordStatistics
    from jounce.analysis.transfer import TransferEstimate


@old_argument("found", "statistics")
def statistics_page(statistics: RecordStatistics, *, title: str) -> Page:
    """Create a page of the statistics of each channel.

    Parameters
    ----------
    statistics : RecordStatistics
        Result of :func:`jounce.describe_channels`.
    title : str
        Heading of the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.
    """
    rows = [_levels(channel) for channel in statistics.channels]
    header = ("channel", "unit", "mean", "r.m.s.", "standard deviation", "minimum", "maximum")
    note = "± half of the 95 % interval, from the scatter of 20 parts of the record."
    levels = PageTable("Level and range", header, tuple(rows), "llrrrrr", note)
    shapes = (
        TableColumn("channel", [channel.channel for channel in statistics.channels]),
        TableColumn("crest factor", [channel.crest_factor for channel in statistics.channels], "1"),
        TableColumn("skewness", [channel.skewness for channel in statistics.channels], "1"),
        TableColumn("kurtosis", [channel.kurtosis for channel in statistics.channels], "1"),
        TableColumn(
            "crossings per second", [channel.crossings for channel in statistics.channels], "Hz"
        ),
    )
    gauss = (
        "Gaussian noise has skewness 0 and kurtosis 3, a sine crest factor 1.41 and kurtosis 1.5."
    )
    words = (
        "Each channel over time, and the distribution of its values; dashed: Gaussian distribution."
    )
    picture = Picture(lambda: figure_of(statistics), "channels", words, words)
    blocks: list[Block] = [
        levels,
        *findings_blocks(statistics.findings),
        picture,
        table_of("Distribution", shapes, gauss),
    ]
    return answer_page(
        title, blocks, _stretch(statistics.begin, statistics.end, statistics.sample_rate)
    )


def _levels(channel: ChannelStatistics) -> tuple[str, ...]:
    unit = display_unit(channel.unit, max(abs(channel.minimum), abs(channel.maximum)))
    values = (channel.standard_deviation, channel.minimum, channel.maximum)
    levels = (with_half(estimate, unit.factor) for estimate in (channel.mean, channel.rms))
    return (
        channel.channel,
        unit.name or "–",
        *levels,
        *(number(value * unit.factor) for value in values),
    )


@old_argument("found", "spectra")
def spectra_page(spectra: RecordSpectra, *, title: str) -> Page:
    """Create a page of the spectra of a record, with their significant peaks.

    Parameters
    ----------
    spectra : RecordSpectra
        Result of :func:`jounce.estimate_spectra`.
    title : str
        Heading of the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.
    """
    low, high = spectra.interval
    facts = Facts(
        (
            Fact(
                "resolution",
                quantity(spectra.resolution, "Hz", 3),
                f"{spectra.window.capitalize()} segments of {spectra.segment:.3g} s",
            ),
            Fact(
                "degrees of freedom",
                number(spectra.degrees_of_freedom, 3),
                f"{spectra.averages:.3g} independent segments",
            ),
            Fact(
                f"{100.0 * spectra.confidence:g} % interval",
                f"{number(low, 3)} to {number(high, 3)} of a density",
                "stationary Gaussian noise",
            ),
        )
    )
    band = f"r.m.s. from {spectra.band[0]:.3g} to {spectra.band[1]:.4g} Hz"
    rows = tuple(
        (row.channel, quantity(row.rms, row.unit), _peaks(row.peaks)) for row in spectra.channels
    )
    table = PageTable(
        "Channels",
        ("channel", band, "peaks"),
        rows,
        "lrl",
        "Peaks rise above what chance explains.",
    )
    words = "Power spectral density of each channel; shaded: its interval; circles: peaks."
    picture = Picture(lambda: figure_of(spectra), "spectra", words, words)
    blocks: list[Block] = [facts, table, *findings_blocks(spectra.findings), picture]
    peaks = [(row, peak) for row in spectra.channels for peak in row.peaks]
    if peaks:
        cells = tuple(
            (
                row.channel,
                number(peak.frequency),
                quantity(peak.rms, row.unit),
                f"{number(peak.ratio, 3)} times",
            )
            for row, peak in peaks
        )
        header = (
            "channel",
            "frequency [Hz]",
            "r.m.s. of the peak",
            "above the neighbouring valley",
        )
        blocks.append(PageTable("Peaks", header, cells, "lrrr"))
    return answer_page(title, blocks, _stretch(spectra.begin, spectra.end, spectra.sample_rate))


def _peaks(peaks: Sequence[SpectralPeak]) -> str:
    texts = [number(peak.frequency, 3) for peak in peaks]
    return f"{', '.join(texts)} Hz" if texts else "–"


@old_argument("found", "transfer")
def transfer_page(transfer: TransferEstimate, *, title: str) -> Page:
    """Create a page of a transfer function: estimation settings, gain, phase and coherence.

    Parameters
    ----------
    transfer : TransferEstimate
        Result of :func:`jounce.estimate_transfer`.
    title : str
        Heading of the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.
    """
    good = transfer.coherence >= 0.8  # the gain error is then up to 6 % with 30 segments
    facts = [
        Fact("estimator", transfer.estimator, _ESTIMATORS[transfer.estimator]),
        Fact(
            "resolution",
            quantity(transfer.resolution, "Hz", 3),
            f"{transfer.window.capitalize()} segments of {transfer.segment:.3g} s",
        ),
        Fact(
            "independent segments",
            number(transfer.averages, 3),
            f"chance stays below {transfer.significant:.2g}",
        ),
        Fact("coherence of 0.8 or more", percent(float(good.mean())), "of the band"),
    ]
    words = (
        f"Gain, phase and coherence of {transfer.output} over {transfer.given}; shaded: intervals."
    )
    if transfer.model is not None:
        apart = (
            np.abs(transfer.response[good] / transfer.model[good] - 1.0)
            if good.any()
            else np.empty(0)
        )
        usual = float(np.median(apart)) if apart.size else None
        facts.append(
            Fact("model", percent(usual), "median distance where the coherence is 0.8 or more")
        )
        words += " Dashed: the linear model."
    picture = Picture(lambda: figure_of(transfer), "transfer", words, words)
    blocks: list[Block] = [
        Facts(tuple(facts)),
        *findings_blocks(transfer.findings),
        picture,
        _octaves(transfer),
    ]
    subtitle = (
        f"{transfer.output} over {transfer.given}; "
        f"{_stretch(transfer.begin, transfer.end, transfer.sample_rate)}"
    )
    return answer_page(title, blocks, subtitle)


_ESTIMATORS = {
    "H1": "right with noise in the output",
    "H2": "right with noise in the input",
    "Hv": "right with equal noise in both",
}


def _octaves(transfer: TransferEstimate) -> PageTable:
    """Return a table of gain, phase and coherence at third octaves."""
    f = transfer.frequency
    wanted = 10.0 ** (np.arange(-20, 41) / 10.0)
    inside = wanted[(wanted >= f[0]) & (wanted <= f[-1])]
    lines = sorted({int(np.argmin(abs(f - at))) for at in inside})
    output, given = display_unit(transfer.output_unit), display_unit(transfer.given_unit)
    factor = output.factor / given.factor
    half = transfer.factor * transfer.gain_error
    rows = tuple(
        (
            number(float(f[i]), 3),
            f"{number(float(transfer.gain[i]) * factor, 3)} ± {percent(_finite(half[i]), 1)}",
            f"{number(float(np.degrees(transfer.phase[i])), 3)}",
            number(float(transfer.coherence[i]), 3),
            *(
                ()
                if transfer.model is None
                else (number(float(abs(transfer.model[i])) * factor, 3),)
            ),
        )
        for i in lines
    )
    per = ratio_unit(output.name, given.name)
    model = () if transfer.model is None else ("gain of the model",)
    header = ("frequency [Hz]", f"gain [{per}]", "phase [°]", "coherence", *model)
    note = f"At third octaves; ± half of the {100.0 * transfer.confidence:g} % interval."
    return PageTable("Transfer function", header, rows, "r" * len(header), note)


def _finite(value: float) -> float | None:
    return float(value) if value < 10.0 else None  # an error of ten times the value is meaningless


@old_argument("found", "fitted")
def measured_modes_page(fitted: FittedModes, *, title: str) -> Page:
    """Create a page of measured modes, compared with those of a model if given.

    Parameters
    ----------
    fitted : FittedModes
        Result of :func:`jounce.fit_modes`.
    title : str
        Heading of the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.
    """
    has_model = any(mode.model_frequency is not None for mode in fitted.modes)
    rows = tuple(_mode(mode, has_model=has_model) for mode in fitted.modes)
    model = ("model [Hz]", "apart", "model", "apart") if has_model else ()
    header = ("frequency [Hz]", *model[:2], "damping ratio", *model[2:], "orders that agree")
    note = "± half of the 95 % interval. Undamped natural frequencies."
    if has_model:
        note += "  A model's value within the interval is consistent with the measurement."
    what = {
        "transfer": f"transfer functions from {fitted.given} to {', '.join(fitted.outputs)}",
        "spectrum": f"spectra of {', '.join(fitted.outputs)}",
        "decay": f"the free decay of {', '.join(fitted.outputs)}",
    }[fitted.kind]
    words = "Measured (thin) and fitted; below: poles of denominators of rising order, filled where they are stable."
    if has_model:
        words += " Dashed: modes of the model."
    picture = Picture(lambda: figure_of(fitted), "modes", words, words)
    table = PageTable(f"Modes of {what}", header, rows, "r" * len(header), note)
    blocks: list[Block] = [*([table] if rows else []), *findings_blocks(fitted.findings), picture]
    band = f"{fitted.band[0]:.3g} to {fitted.band[1]:.4g} Hz"
    subtitle = f"{band}; {_stretch(fitted.begin, fitted.end, fitted.sample_rate)}"
    return answer_page(title, blocks, subtitle)


def _mode(mode: MeasuredMode, *, has_model: bool) -> tuple[str, ...]:
    cells: list[str] = []
    pairs = ((mode.frequency, mode.model_frequency), (mode.damping_ratio, mode.model_damping_ratio))
    for measured, model in pairs:
        cells.append(with_half(measured))
        if has_model:
            apart = None if model is None else model / measured.value - 1.0
            inside = model is not None and measured.has(model)
            cells += [number(model), f"{percent(apart)}{', within' if inside else ''}"]
    return (*cells, str(mode.orders))


@old_argument("found", "integration")
def integration_page(integration: Integration, *, title: str) -> Page:
    """Create a page of integrated accelerations, with their valid band and errors.

    Parameters
    ----------
    integration : Integration
        Result of :func:`jounce.integrate_acceleration`.
    title : str
        Heading of the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.
    """
    inside = (integration.time >= integration.valid[0]) & (integration.time <= integration.valid[1])
    rows = tuple(
        (
            channel.displacement_channel,
            quantity(float(np.std(channel.displacement[inside])), channel.displacement_unit, 3),
            quantity(float(np.ptp(channel.displacement[inside])), channel.displacement_unit, 3),
            quantity(channel.displacement_error, channel.displacement_unit, 2),
            quantity(channel.removed, channel.displacement_unit, 2),
            f"{number(channel.band[0], 3)} to {number(channel.band[1])} Hz",
        )
        for channel in integration.channels
    )
    header = ("channel", "r.m.s.", "peak to peak", "noise adds", "removed", "amplitudes within 5 %")
    note = {
        "random": "Removed: displacement below the corner frequency, both drift and lost motion.",
        "transient": "Removed: the contribution of the sensor's offset and drift.",
        "periodic": "Removed: the non-periodic part.",
    }[integration.motion]
    table = PageTable("Displacements", header, rows, "lrrrrr", note)
    speeds = tuple(
        (
            channel.velocity_channel,
            quantity(float(np.std(channel.velocity[inside])), channel.velocity_unit, 3),
            quantity(channel.velocity_error, channel.velocity_unit, 2),
            f"{number(channel.noise, 3)} {channel.unit.replace('^2', '²')}/√Hz",
            "–" if channel.corner == 0.0 else f"{number(channel.corner, 3)} Hz",
        )
        for channel in integration.channels
    )
    velocity = PageTable(
        "Velocities",
        ("channel", "r.m.s.", "noise adds", "noise density", "corner"),
        speeds,
        "lrrrr",
    )
    words = "Acceleration, velocity and displacement over time; shaded: end effects of the record."
    picture = Picture(lambda: figure_of(integration), "integrated", words, words)
    blocks: list[Block] = [table, *findings_blocks(integration.findings), picture, velocity]
    subtitle = f"{integration.motion} motion, valid from {integration.valid[0]:.4g} s to {integration.valid[1]:.4g} s"
    return answer_page(title, blocks, subtitle)


def _stretch(begin: float, end: float, rate: float) -> str:
    return f"{begin:.4g} s to {end:.4g} s at {rate:.6g} Hz"
