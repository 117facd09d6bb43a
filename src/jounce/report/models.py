"""Pages of results that need no simulation: modes, a 3-D rig compared with a lumped one, road roughness."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.display import display_unit, display_unit_for
from jounce.core.old_names import old_argument
from jounce.plots.display import SMALLEST, number, percent
from jounce.recordings.schema import state_unit
from jounce.report.page import (
    Block,
    Fact,
    Facts,
    Findings,
    Page,
    PageTable,
    Paragraph,
    Section,
    TableColumn,
    as_printed,
    findings_blocks,
    picture_of,
    table_of,
)

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    import xarray as xr

    from jounce.core.findings import Finding
    from jounce.core.types import Array
    from jounce.design.model_comparison import LumpedComparison, ModelComparison
    from jounce.parts import Rig
    from jounce.ride.modal import ModalAnalysis
    from jounce.roughness.iri import ProfileRoughness, Roughness
    from jounce.simulation import Mode


_ROUNDING = 1e-9  # for quantities without their own smallest value


def curve_blocks(*runs: Any, **options: Any) -> tuple[Block, ...]:
    """Call :func:`jounce.report.recordings.curve_blocks`, importing it lazily because it is slow to load."""
    from jounce.report.recordings import curve_blocks as blocks

    return blocks(*runs, **options)


@old_argument("found", "modes")
def modes_page(
    modes: Sequence[Mode],
    equilibrium: Mapping[str, float],
    findings: Sequence[Finding] = (),
    *,
    title: str,
) -> Page:
    """Create a page of the oscillating modes of a rig and its static equilibrium.

    Parameters
    ----------
    modes : sequence of Mode
        Result of :func:`jounce.modes`.
    equilibrium : mapping of str to float
        Static value (SI) by channel, from :func:`jounce.equilibrium`.
    findings : sequence of Finding
        Findings on effects the linear model neglects.
    title : str
        Heading of the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.

    Examples
    --------
    >>> import jounce as jn
    >>> rig = jn.load("kart-quarter-car")
    >>> page = modes_page(jn.modes(rig), jn.equilibrium(rig), title="A kart")
    >>> [section.title for section in page.sections]
    ['Modes', 'Static equilibrium']
    """
    if not modes:
        answer: tuple[Block, ...] = (Paragraph("No oscillating mode: all motions are overdamped."),)
    else:
        names = list(modes[0].shape)
        rows = tuple(
            (
                str(k),
                number(m.frequency_hz),
                number(m.damped_frequency_hz),
                number(m.damping_ratio, 3),
                _largest(m),
            )
            for k, m in enumerate(modes, 1)
        )
        header = (
            "mode",
            "natural frequency [Hz]",
            "damped [Hz]",
            "damping ratio [–]",
            "moves most",
        )
        shapes = tuple(
            (name, *(number(abs(complex(*m.shape[name])), 3) for m in modes)) for name in names
        )
        words = "Shape of each mode: motion of every coordinate relative to the largest."
        answer = (
            PageTable("Modes by rising natural frequency", header, rows, "lrrrl"),
            picture_of(list(modes), "modes", words),
            PageTable(
                "Amplitudes of the shapes",
                ("coordinate", *map(str, range(1, len(modes) + 1))),
                shapes,
                "l" + "r" * len(modes),
            ),
        )
    rest = tuple((name, *_at_rest(name, value)) for name, value in equilibrium.items())
    statics = PageTable("Static equilibrium", ("quantity", "unit", "value"), rest, "llr")
    advice = (Findings(tuple(findings)),) if findings else ()
    sections = (Section("Modes", (*answer, *advice)), Section("Static equilibrium", (statics,)))
    return Page(title, sections, "Linear model about rest")


def modal_analysis_page(analysis: ModalAnalysis, *, title: str) -> Page:
    """Create a page of a modal analysis, as :func:`modes_page` does."""
    return modes_page(analysis.modes, analysis.equilibrium, analysis.findings, title=title)


def _at_rest(name: str, value: float) -> tuple[str, str]:
    """Return unit and value, with values at rounding level set to zero."""
    si = state_unit(name)
    if si == "SI":
        return si, number(value)
    unit = display_unit(si, value)
    return unit.name or "–", number(
        0.0 if abs(value) < SMALLEST.get(si, _ROUNDING) else value * unit.factor
    )


def _largest(mode: Mode) -> str:
    return max(mode.shape, key=lambda name: abs(complex(*mode.shape[name])))


@old_argument("found", "roughness")
def roughness_page(
    roughness: Roughness, distance: Array, height: Array, findings: Sequence[Finding], *, title: str
) -> Page:
    """Create a page of the roughness of a profile: the index, its segments, and the profile.

    Parameters
    ----------
    roughness : Roughness
        Result of :func:`jounce.iri`.
    distance, height : ndarray, shape (n,)
        The profile, m.
    findings : sequence of Finding
        Findings that limit the reliability of the results.
    title : str
        Heading of the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.

    Examples
    --------
    >>> import jounce as jn
    >>> x = np.arange(0.0, 50.0, 0.05)
    >>> z = 0.005 * np.sin(x)
    >>> found = jn.iri(x, z, segment="10 m")
    >>> [section.title for section in roughness_page(found, x, z, found.findings, title="Waves").sections]
    ['Answer', 'Profile']
    """
    length, index = display_unit_for("m", largest=roughness.end), display_unit("m/km")

    def along(metres: float) -> str:
        return f"{length.factor * metres:g} {length.name}"

    def iri(value: float) -> str:
        return f"{number(index.factor * value)} {index.name}"

    worst = max(roughness.segments, key=lambda part: part.iri_m_per_km, default=None)
    facts = [
        Fact(
            "IRI of the whole profile",
            iri(roughness.iri_m_per_km),
            f"over {along(roughness.end - roughness.start)}",
        )
    ]
    if worst is not None and len(roughness.segments) > 1:
        facts.append(
            Fact(
                "roughest segment",
                iri(worst.iri_m_per_km),
                f"{along(worst.start)} to {along(worst.end)}",
            )
        )
    rows = tuple(
        (
            f"{length.factor * part.start:g}",
            f"{length.factor * part.end:g}",
            number(index.factor * part.iri_m_per_km),
            "shorter than the others" if part.partial else "",
        )
        for part in roughness.segments
    )
    segments = PageTable(
        "Segments", (length.label("from"), length.label("to"), index.label("IRI"), ""), rows, "rrrl"
    )
    note = f"Samples every {roughness.spacing:g} m, slopes over {roughness.base:g} m."

    def profile() -> xr.Dataset:
        import xarray as xr

        steps = np.full(len(distance), np.nan)
        for part in roughness.segments:
            steps[(distance >= part.start - 1e-9) & (distance <= part.end + 1e-9)] = (
                part.iri_m_per_km
            )
        return xr.Dataset(
            {
                "height": (
                    "distance",
                    height,
                    {"units": "m", "long_name": "height of the profile"},
                ),
                "iri": ("distance", steps, {"units": "m/km", "long_name": "IRI of the segment"}),
            },
            {"distance": ("distance", distance, {"units": "m"})},
        )

    answer: list[Block] = [Facts(tuple(facts)), segments, Paragraph(note, "muted")]
    answer += findings_blocks(findings)
    curves = Section(
        "Profile",
        lambda: curve_blocks({"": {"profile": profile()}}, ["height", "iri"], title=title),
    )
    return Page(title, (Section("Answer", tuple(answer)), curves), "International roughness index")


def profile_page(profile: ProfileRoughness, *, title: str) -> Page:
    """Create a page of a profile from a file and its roughness, as :func:`roughness_page` does."""
    return roughness_page(
        profile.roughness, profile.distance, profile.height, profile.findings, title=title
    )


@old_argument("found", "comparison")
def model_comparison_page(
    comparison: ModelComparison, *, title: str, rig: Rig | None = None
) -> Page:
    """Create a page that compares a 3-D rig with its lumped model: differences, reasons, trials, curves over travel.

    Parameters
    ----------
    comparison : ModelComparison
        Result of :func:`jounce.design.model_comparison.compare_models`.
    title : str
        Heading of the page.
    rig : Rig, optional
        3-D rig animated with the curves.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.

    """
    rows = []
    for row in comparison.rows:
        values = [value for value in (row.spatial, row.lumped) if value is not None]
        unit = display_unit(row.unit, max(map(abs, values), default=0.0))
        cells = (
            number(None if value is None else value * unit.factor)
            for value in (row.spatial, row.lumped)
        )
        rows.append((row.quantity, unit.name or "–", *cells, as_printed(row.why)))
    about_rest = PageTable(
        "About rest", ("quantity", "unit", "3-D", "lumped", "reason"), tuple(rows), "llrrl"
    )
    peaks = []
    for peak in comparison.peaks:
        unit = display_unit(peak.unit, peak.spatial)
        both = (number(value * unit.factor) for value in (peak.spatial, peak.lumped))
        peaks.append((peak.trial, peak.channel, unit.name or "–", *both, percent(peak.relative)))
    header = ("trial", "peak of", "unit", "3-D", "lumped", "difference")
    in_trials = PageTable("Largest values in the trials", header, tuple(peaks), "lllrrr")
    curves = comparison.curves().rename(travel="wheel_travel")
    runs = {str(model): curves.sel(model=model, drop=True) for model in curves["model"].to_numpy()}
    moving = curve_blocks({"": runs}, ["motion_ratio", "wheel_rate"], title=title, rig=rig)
    some = slice(None, None, _EVERY)
    points = [*comparison.travel[some].tolist()]
    over_travel = table_of(
        "Over travel",
        (
            TableColumn("travel", points, "m"),
            TableColumn("motion ratio, 3-D", comparison.motion_ratio[some].tolist(), "1"),
            TableColumn("lumped", [comparison.lumped_motion_ratio] * len(points), "1"),
            TableColumn("wheel rate, 3-D", comparison.wheel_rate[some].tolist(), "N/m"),
            TableColumn("lumped", [comparison.lumped_wheel_rate] * len(points), "N/m"),
        ),
    )
    answer = (about_rest, *((in_trials,) if peaks else ()))
    sections = Section("Answer", answer), Section("Over travel", (*moving, over_travel))
    return Page(title, sections, "Where the models differ, and why")


_EVERY = 3  # points over travel between two rows of the table


def lumped_comparison_page(lumped: LumpedComparison, *, title: str) -> Page:
    """Create a page that compares a 3-D rig with its lumped model."""
    return model_comparison_page(lumped.comparison, title=title, rig=lumped.rig)
