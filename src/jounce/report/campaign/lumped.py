"""Lumped model: where the quarter car that a 3-D rig amounts to differs from it, and why."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jounce.plots import display_unit, number, sweep
from jounce.report.numbers import percent
from jounce.report.page import Block, Cell, Paragraph, Picture, Section, Table

if TYPE_CHECKING:
    from jounce.design.model_comparison import Difference, ModelComparison, PeakDifference

_NOTICED = 0.05
"""Share from which a difference of a peak is coloured."""


def lumped(found: ModelComparison) -> Section:
    """Quantities about rest, curves over travel, shares of the bodies, peaks of every trial."""
    blocks: list[Block] = [
        Paragraph(
            "The rig of this campaign is a linkage in space. Two masses on strut and tyre can stand for it near rest: "
            "the quarter car below has its wheel rate, its damping and both its natural frequencies. What such a model "
            "cannot have is listed with the reason."
        ),
        _rows(found),
        Picture(
            sweep(found.curves(), along="travel"),
            "lumped-travel",
            "Motion ratio and wheel rate against wheel travel: the linkage, and the lumped model that is right at "
            "rest.",
            f"Motion ratio from {found.motion_ratio[0]:.4f} to {found.motion_ratio[-1]:.4f} over the travel shown, "
            f"lumped {found.lumped_motion_ratio:.4f}.",
        ),
        _shares(found),
    ]
    if found.peaks:
        blocks.append(_peaks(found.peaks))
    return Section("Lumped model and linkage", tuple(blocks))


def _rows(found: ModelComparison) -> Table:
    rows = tuple(_row(item) for item in found.rows)
    header = ("quantity, about rest", "3-D", "lumped", "unit", "why")
    note = "Modes without dry friction, which would hold small motions."
    return Table("Where the two models differ", header, rows, "lrrll", note)


def _row(item: Difference) -> tuple[str, ...]:
    values = [value for value in (item.spatial, item.lumped) if value is not None]
    unit = display_unit(item.unit, max(values, key=abs, default=0.0))
    texts = ("–" if value is None else number(value * unit.factor) for value in (item.spatial, item.lumped))
    return (item.quantity, *texts, unit.name, item.why)


def _shares(found: ModelComparison) -> Table:
    rows = tuple(
        (
            name.replace("_", " "),
            number(part.mass),
            number(part.wheel_share, 3),
            number(part.sprung_mass, 3),
            number(part.unsprung_mass, 3),
            number(part.inertance, 3),
        )
        for name, part in found.lumping.shares.items()
    )
    header = ("body", "mass [kg]", "rise over the wheel's", "sprung [kg]", "unsprung [kg]", "inertance [kg]")
    note = (
        "Rise of its centre of mass over that of the wheel: the share of its mass that moves with the wheel. "
        "Inertance: what turning and sideways motion take beyond that."
    )
    return Table("What each body is to body and wheel", header, rows, "lrrrrr", note)


def _peaks(peaks: tuple[PeakDifference, ...]) -> Table:
    rows = []
    for k, peak in enumerate(peaks):
        unit = display_unit(peak.unit, peak.spatial)
        difference = Cell(percent(peak.relative), "fair") if abs(peak.relative) > _NOTICED else percent(peak.relative)
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
    note = (
        "Largest absolute value, each trial with the strut angle and tyre it was run with. No measurement is involved."
    )
    return Table("Peaks of every trial in both models", header, tuple(rows), "llrrlr", note)
