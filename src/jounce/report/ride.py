"""Pages of rides and comparisons of controllers: results, then all curves, then spectra."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

from jounce.core.display import display_unit
from jounce.plots.display import number, percent, setting_text
from jounce.report.page import (
    Block,
    Fact,
    Facts,
    Page,
    PageTable,
    Paragraph,
    Picture,
    Section,
    answer_page,
    findings_blocks,
    picture_of,
)
from jounce.ride.study import MERITS

if TYPE_CHECKING:
    from collections.abc import Mapping

    from jounce.core.findings import Finding
    from jounce.parts import Rig
    from jounce.ride.measured import MeasuredRide
    from jounce.ride.metrics import RideMetrics
    from jounce.ride.study import RideStudy

_FIRST = (("road.z",), ("body.az", "sprung.az"), ("strut.deflection",), ("tyre.force",))
"""Quantities shown initially, at all axles and corners."""
_MOST_PLACES = 4  # corners of a car
_SHOWN = 10.0  # s of a long ride shown initially


def ride_page(study: RideStudy, *, title: str, rig: Rig | None = None) -> Page:
    """Create a page of the rides of one rig over one trial.

    Parameters
    ----------
    study : RideStudy
        One ride or several controllers, from :func:`jounce.compare_rides`.
    title : str
        Vehicle, road and speed.
    rig : Rig, optional
        3-D corner animated with the first ride; by default that of the study.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.
    """
    several = len(study.rides) > 1
    lasting = study.rides[0].duration if study.rides else 0.0
    answer: list[Block] = []
    if several:
        answer.append(_merits(study))
    elif study.rides:
        answer += [_facts(study), _metrics(_metrics_by_name(study))]
    if study.failed:
        texts = (f"{name} was not run: {reason}." for name, reason in study.failed.items())
        answer += [Paragraph(text, "bad") for text in texts]
    if not study.rides:
        return Page(title, (Section("Answer", (*answer, Paragraph("No ride was completed."))),))
    findings = _findings(study)
    answer += findings_blocks(findings)
    moving = study.rig if rig is None else rig
    curves, spectra = (
        Section(name, partial(draw, study, title, moving)) for name, draw in _DRAWN.items()
    )
    sections = [Section("Answer", tuple(answer)), curves, spectra]
    if several:
        words = "Comfort against road holding of every controller; the area of a point represents the travel."
        sections.insert(1, Section("Trade-off", (picture_of(study, "trade-off", words),)))
        sections.append(Section("Every metric", lambda: (_metrics(_metrics_by_name(study)),)))
    against = _stationary(study)
    if against:
        sections.append(Section("Linear model", tuple(against)))
    counted = (
        f"{setting_text(lasting, 's')} counted, from {setting_text(study.trial.settling, 's')} on"
    )
    return Page(title, tuple(sections), f"Simulated ride; {counted}")


def measured_ride_page(ride: MeasuredRide, *, title: str) -> Page:
    """Create a page of the metrics of a recorded ride."""
    answer: list[Block] = [_metrics({"value": ride.metrics})]
    answer += [Paragraph(f"{place}: {words}") for place, words in ride.metrics.comfort.items()]
    answer += findings_blocks(ride.findings)
    return answer_page(title, answer, ride.extent)


def _merits(study: RideStudy) -> PageTable:
    """Return a table of controllers by comfort, travel and road holding, with the best of each column marked."""
    shown = [merit for merit in MERITS if any(merit.name in ride.merits for ride in study.rides)]
    units = {merit.name: display_unit(merit.unit) for merit in shown}
    rows = tuple(
        (
            ride.control,
            *(
                number(
                    None
                    if (value := ride.merits.get(m.name)) is None
                    else value * units[m.name].factor
                )
                for m in shown
            ),
        )
        for ride in study.rides
    )
    header = ("controller", *(units[merit.name].label(merit.label) for merit in shown))
    return PageTable(
        "Controllers over the same road; smaller is better", header, rows, "l" + "r" * len(shown)
    )


def _facts(study: RideStudy) -> Facts:
    (ride,) = study.rides
    comfort = ride.metrics.comfort
    facts = []
    for merit in MERITS:
        if merit.name in ride.merits:
            unit = display_unit(merit.unit)
            value = f"{number(ride.merits[merit.name] * unit.factor)} {unit.name}".strip()
            facts.append(
                Fact(
                    merit.label,
                    value,
                    next(iter(comfort.values()), "") if merit.name == "comfort" else "",
                )
            )
    return Facts(tuple(facts))


def _metrics(rides: Mapping[str, RideMetrics]) -> PageTable:
    """Return a table of all metrics at all positions, with a column per ride."""
    values = {
        name: {(row.metric, row.place): row for row in ride.values} for name, ride in rides.items()
    }
    every = dict.fromkeys(key for of_ride in values.values() for key in of_ride)
    rows, last = [], ""
    for key in every:
        value = next(of_ride[key] for of_ride in values.values() if key in of_ride)
        unit = display_unit(value.unit, value.value)
        cells = (
            number(of_ride[key].value * unit.factor) if key in of_ride else "–"
            for of_ride in values.values()
        )
        rows.append(
            (value.label if value.label != last else "", value.place, unit.name or "–", *cells)
        )
        last = value.label
    return PageTable(
        "Ride metrics", ("metric", "place", "unit", *values), tuple(rows), "lll" + "r" * len(values)
    )


def _metrics_by_name(study: RideStudy) -> dict[str, RideMetrics]:
    """Return metrics by controller; for a single ride the column is named "value"."""
    several = len(study.rides) > 1
    return {ride.control if several else "value": ride.metrics for ride in study.rides}


def _stationary(study: RideStudy) -> list[Block]:
    """Return a comparison of simulated and stationary standard deviations of the passive rig."""
    passive = next((ride for ride in study.rides if ride.control == "passive"), None)
    if study.stationary is None or passive is None:
        return []
    linear, chances = study.stationary.standard_deviation, study.by_chance
    rows = []
    for name in (control for control in linear if linear[control]):
        unit = display_unit(study.stationary.units[name], linear[name])
        chance = chances[name]
        rows.append(
            (
                name,
                unit.name or "–",
                number(passive.standard_deviation(name) * unit.factor),
                number(linear[name] * unit.factor),
                "–" if chance is None else f"± {percent(chance)}",
            )
        )
    return [
        PageTable(
            "Standard deviations of the passive ride, and of the linear model over infinite time",
            ("channel", "unit", "simulated", "linear model", "by chance"),
            tuple(rows),
            "llrrr",
            "By chance: 95 % of rides of this length differ by no more from an infinitely long one.",
        )
    ]


def _findings(study: RideStudy) -> list[Finding]:
    several = len(study.rides) > 1
    findings = [
        replace(finding, place=f"{ride.control}, {finding.place}") if several else finding
        for ride in study.rides
        for finding in ride.metrics.findings
    ]
    return [*findings, *(study.stationary.findings if study.stationary is not None else ())]


def _curves(study: RideStudy, title: str, rig: Rig | None) -> tuple[Block, ...]:
    runs = {ride.control: ride.run for ride in study.rides}
    from jounce.plots.signals import preferred_channels
    from jounce.report.recordings import curve_blocks

    first = preferred_channels(_names(study), _FIRST, len(_FIRST) * _MOST_PLACES)
    start = study.trial.settling
    window = (start, start + _SHOWN) if study.trial.trial.duration > start + _SHOWN else None
    return curve_blocks(
        {"": runs}, first or None, title=title, rig=rig, trial=study.trial.trial, window=window
    )


def _names(study: RideStudy) -> list[str]:
    """Return the channels that all rides contain."""
    held = [set(map(str, ride.run.data_vars)) for ride in study.rides]
    return [
        str(name) for name in study.rides[0].run.data_vars if all(name in others for others in held)
    ]


def _spectra(study: RideStudy, title: str, _: Rig | None) -> tuple[Block, ...]:
    from jounce.plots.design import ride_spectra

    words = "Power spectral densities of the body's acceleration and of every wheel load."
    return (
        Picture(
            lambda: ride_spectra(study.rides, study.stationary, title), "spectra", words, words
        ),
    )


_DRAWN = {"Curves": _curves, "Spectra": _spectra}
