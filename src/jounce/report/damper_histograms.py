"""Page of damper histograms: figures, the zones of velocity of each corner, balance, laps, and what was found."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from jounce.core.display import size
from jounce.core.numbers import number
from jounce.core.tables import TextTable
from jounce.dampers.histograms import ZONES
from jounce.plots.damper_histograms import (
    corner_words,
    damper_histogram_bars,
    unit_of,
    zones_over_sections,
)
from jounce.report.page import (
    Block,
    Details,
    Page,
    Paragraph,
    Picture,
    answer_page,
    as_table,
    findings_blocks,
)

if TYPE_CHECKING:
    from jounce.dampers.histograms import DamperHistograms


def damper_histogram_page(result: DamperHistograms, *, title: str) -> Page:
    """Create a page of damper histograms.

    Parameters
    ----------
    result : DamperHistograms
        Result of :func:`jounce.damper_histograms`.
    title : str
        Heading of the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.
    """
    velocity = (
        "Share of time over velocity for each corner; the outer bins contain all that is faster."
    )
    travel = "Share of time over travel for each corner."
    blocks: list[Block] = [
        as_table(_zones(result)),
        Paragraph(_how(result), "muted"),
        Picture(lambda: damper_histogram_bars(result), "velocity-histograms", velocity, velocity),
    ]
    if np.isfinite(result.data["travel_share"].to_numpy()).any():
        blocks.append(
            Picture(
                lambda: damper_histogram_bars(result, "travel"), "travel-histograms", travel, travel
            )
        )
    if "balance" in result.data:
        blocks.append(as_table(_balance(result)))
    if result.beside:
        blocks.append(as_table(_beside(result)))
    if len(result.sections) > 1:
        words = "Shares of the zones of velocity over laps or sectors."
        blocks.append(
            Picture(lambda: zones_over_sections(result), "zones-by-section", words, words)
        )
    blocks += findings_blocks(result.findings)
    blocks.append(as_table(_motion(result)))
    if len(result.sections) > 1:
        blocks.append(Details("Laps and sectors", (as_table(_sections(result)),)))
    count = len(result.corners)
    return answer_page(
        title, blocks, f"{', '.join(result.records)}: {count} corner{'s' * (count != 1)}"
    )


def _how(result: DamperHistograms) -> str:
    """Write how velocities were made and what the numbers contain."""
    record = result.records[0]
    low = size(1e3 * result.low_speed, "mm/s")
    places = sorted(set(result.measured_at.values()))
    made = "Velocity is as recorded."
    if result.cutoff[record] > 0.0:
        made = (
            f"Velocity is the derivative of the travel with zero phase: right within 1 % up to "
            f"{number(result.passband[record], 2)} Hz, half of its amplitude at {number(result.cutoff[record], 3)} Hz."
        )
    return (
        f"Low speed is up to {low}, at the {' and the '.join(places)}. {made} Intervals (95 %) come from the scatter "
        "of 20 parts of the record. The effect of noise is how much the noise of the sensor changes a share."
    )


def _table(
    caption: str, header: tuple[str, ...], rows: list[tuple[str, ...]], texts: int
) -> TextTable:
    """Make a table whose first column names the record; without it if all rows are of the same."""
    if len({row[0] for row in rows}) == 1 and texts > 1:
        header, rows, texts = header[1:], [row[1:] for row in rows], texts - 1
    return TextTable(caption, header, rows, texts=tuple(range(texts)))


def _percent(share: float, digits: int = 1) -> str:
    return "–" if not np.isfinite(share) else f"{100.0 * share:.{digits}f}".replace("-", "−")


def _zones(result: DamperHistograms) -> TextTable:
    rows = []
    for record in result.records:
        for corner in result.corners:
            own = result.data.sel(record=record, corner=corner)
            shares = own["zone_share"].sel(section="whole").to_numpy()
            if not np.isfinite(shares).all():
                continue
            halves, noise = own["zone_share_half"].to_numpy(), own["noise_share"].to_numpy()
            cells = [
                f"{_percent(share)} ± {_percent(half)}" if np.isfinite(half) else _percent(share)
                for share, half in zip(shares, halves, strict=True)
            ]
            low = shares[1] + shares[2]
            bump = shares[2] + shares[3]
            row = (
                record,
                corner_words(corner),
                *cells,
                _percent(low),
                _percent(bump),
                _percent(noise[1] + noise[2], 2),
            )
            rows.append(row)
    header = ("record", "corner", *ZONES, "low speed", "bump", "noise adds to low speed")
    return TextTable(
        "Shares of time by velocity, %, with 95 % intervals", header, rows, texts=(0, 1)
    )


def _balance(result: DamperHistograms) -> TextTable:
    rows = []
    for record in result.records:
        own = result.data.sel(record=record, section="whole")
        cells = [_percent(float(share)).replace("–", "") for share in own["balance"].to_numpy()]
        rows.append((record, *cells, number(float(own["velocity_ratio"]), 3)))
    header = ("record", *ZONES, "r.m.s. velocity, front over rear")
    return _table("Balance: shares of the front minus those of the rear, %", header, rows, 1)


def _beside(result: DamperHistograms) -> TextTable:
    rows = []
    for record in result.records[:-1]:
        for corner in result.corners:
            cells = [
                _percent(
                    float(
                        result.data[f"{name}_overlap"].sel(
                            record=record, section="whole", corner=corner
                        )
                    )
                )
                for name in ("velocity", "travel")
            ]
            rows.append((record, corner_words(corner), *cells))
    header = ("record", "corner", "velocity", "travel")
    return _table("Common area with the model's histogram, % (100: the same)", header, rows, 2)


def _motion(result: DamperHistograms) -> TextTable:
    travel, speed = unit_of("travel"), unit_of("velocity")
    names = {
        "mean_travel": travel,
        "least_travel": travel,
        "largest_travel": travel,
        "rms_velocity": speed,
        "mean_bump_velocity": speed,
        "mean_rebound_velocity": speed,
        "largest_bump_velocity": speed,
        "largest_rebound_velocity": speed,
        "velocity_noise": speed,
    }
    rows = []
    for record in result.records:
        for corner in result.corners:
            own = result.data.sel(record=record, section="whole", corner=corner)
            values = [float(own[name]) * unit.factor for name, unit in names.items()]
            if np.isfinite(values[3]):
                rows.append((record, corner_words(corner), *(number(value, 3) for value in values)))
    labels = (
        "mean travel",
        "least",
        "largest",
        "r.m.s. velocity",
        "mean bump",
        "mean rebound",
        "largest bump",
        "largest rebound",
        "noise",
    )
    header = (
        "record",
        "corner",
        *(unit.label(label) for label, unit in zip(labels, names.values(), strict=True)),
    )
    return _table("Travel and velocity", header, rows, 2)


def _sections(result: DamperHistograms) -> TextTable:
    rows = []
    for record in result.records:
        for section in result.sections[1:]:
            for corner in result.corners:
                own = result.data.sel(record=record, section=section, corner=corner)
                shares = own["zone_share"].to_numpy()
                if np.isfinite(shares).all():
                    seconds = number(float(own["duration"]), 4)
                    rows.append(
                        (
                            record,
                            section,
                            corner_words(corner),
                            seconds,
                            *(_percent(float(x)) for x in shares),
                        )
                    )
    header = ("record", "section", "corner", "time [s]", *ZONES)
    return _table("Shares of time by velocity, %", header, rows, 3)
