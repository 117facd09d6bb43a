"""Paper 2's corner on its exciter as a page: three models, spring length and force, drive, the paper beside them."""

from __future__ import annotations

from jounce.core.serialise import to_json
from jounce.papers.audi_a6_exciter import EccentricExciter, Range
from jounce.papers.audi_a6_paper import FREQUENCY, LOAD, POWER
from jounce.plots.audi_a6 import exciter_spring, exciter_torque_curve
from jounce.plots.display import number, quantity
from jounce.report.audi_a6 import errata_table
from jounce.report.curves import curve_files
from jounce.report.page import Block, Fact, Facts, Findings, Page, Paragraph, Picture, Section, Table

_ABOUT = (
    "The paper simulated the front corner on a plate that an eccentric exciter moves (section 4). It merged tyre and "
    "spring into one by adding their constants. Here the same stand is built three times: summed as in the paper, in "
    "series (a massless wheel between spring and tyre), and with two masses (the quarter car, whose tyre may "
    "leave the plate)."
)
_RUN = (
    "The exciter turns steadily at 5 Hz and moves the plate as a Scotch yoke does; the plate starts at its lowest "
    "place with an uncompressed spring of 341 mm, and the load then compresses it. Without friction in the guides the "
    "drive's mean power is what the dampers turn to heat."
)


def exciter_page(study: EccentricExciter) -> Page:
    """Put the study's page together; nothing is computed here."""
    curves = (file for run in study.runs for file in curve_files(run.variant, run.signals))
    return Page(
        "Audi A6, front corner on an eccentric exciter",
        (
            _summary(study),
            Section("Spring", _spring(study)),
            Section("Statics, modes and response", _linear(study)),
            Section("Drive", _drive(study)),
            Section("The paper beside what is correct", (errata_table(study.errata),)),
            Section("Findings", (Findings(study.findings),)),
        ),
        subtitle="Quarter car of the suspension-system paper, section 4, rebuilt",
        files=(("results.json", to_json(study.to_dict())), *curves),
    )


def _summary(study: EccentricExciter) -> Section:
    facts = tuple(
        Fact(f"compression, {run.variant}", quantity(run.statics["compression"], "m", 5), "static, of all springs")
        for run in study.runs
    )
    torque = Fact("torque of eq. (5)", quantity(study.torque, "N*m", 4), f"the paper: {study.printed_torque:.1f} N·m")
    inputs = (
        f"Inputs of Table 1: load {LOAD:g} N, power {POWER:g} W, frequency {FREQUENCY:g} Hz, spring 38 N/mm with "
        "2 N·s/mm, tyre 300 N/mm with 1 N·s/mm. Estimated: amplitude "
        f"{quantity(study.amplitude, 'm', 3)}, mass of the plate {study.plate_mass:g} kg, unsprung mass "
        f"{study.rig.unsprung.mass:g} kg."
    )
    return Section("Summary", (Paragraph(_ABOUT), Facts((*facts, torque)), Paragraph(_RUN), Paragraph(inputs, "muted")))


def _spring(study: EccentricExciter) -> tuple[Block, ...]:
    words = "Plate, length of the spring and its force, from the uncompressed spring on (figure 8 of the paper)."
    rows = tuple(
        (
            run.variant,
            quantity(run.statics["spring_length"], "m", 5),
            _span(run.spring_length, "m", 5),
            _span(run.spring_force, "N", 4),
            quantity(run.shortest, "m", 4),
        )
        for run in study.runs
    )
    header = ("model", "length at rest", "in steady motion", "force in steady motion", "shortest while loading")
    text = (
        "The paper reads 328.8 mm. Only the summed spring comes near it: its length at rest is "
        f"{quantity(study.runs[0].statics['spring_length'], 'm', 4)}. As the least compression of a steady motion "
        f"12.2 mm would need an amplitude of {quantity(study.fitting_amplitude, 'm', 2)}."
    )
    note = "For the summed model it is the merged spring, for the others the suspension's."
    return (
        Picture(exciter_spring(study), "figure-8-spring", words, words),
        Table("Spring of 341 mm under the load.", header, rows, "lrrrr", note),
        Paragraph(text),
    )


def _linear(study: EccentricExciter) -> tuple[Block, ...]:
    statics = tuple(
        (
            run.variant,
            quantity(run.statics["spring_compression"], "m", 5),
            quantity(run.statics["compression"], "m", 5),
            quantity(run.statics["contact_force"], "N", 5),
            "; ".join(f"{number(mode.frequency_hz, 5)} Hz, ζ {number(mode.damping_ratio, 4)}" for mode in run.modes),
        )
        for run in study.runs
    )
    response = tuple(
        (
            f"{run.variant}, {kind}",
            *(number(values.get(name), 4) for name in ("body", "wheel", "spring")),
            quantity(values["contact"], "N/m", 4),
        )
        for run in study.runs
        for kind, values in (("simulated", run.amplitudes), ("closed form", run.closed_form))
    )
    tester = tuple(
        (
            f"{one.tyre_damping_coefficient:g} N·s/m",
            f"{100.0 * one.adhesion:.1f} %",
            quantity(one.frequency_hz, "Hz", 3),
        )
        for one in study.eusama
    )
    return (
        Table(
            "At rest, and modes.",
            ("model", "spring", "all springs", "force on the plate", "modes"),
            statics,
            "lrrrl",
            "The tyre of the two-mass model carries the wheel's weight, too.",
        ),
        Table(
            "Amplitudes at 5 Hz for one mm of the plate.",
            ("model", "body [mm]", "wheel [mm]", "spring [mm]", "force on the plate"),
            response,
            "lrrrr",
        ),
        Table(
            "What a EUSAMA tester would show with this amplitude: least contact force over the static one.",
            ("tyre damping", "adhesion", "at"),
            tester,
            "lrr",
        ),
    )


def _drive(study: EccentricExciter) -> tuple[Block, ...]:
    words = "Torque that the exciter asks for and force on the plate, two turns of steady motion."
    rows = tuple(
        (
            run.variant,
            quantity(run.drive.torque.mean, "N*m", 3),
            _span(run.drive.torque, "N*m", 3),
            quantity(run.drive.power, "W", 4),
            quantity(run.drive.dissipated, "W", 4),
        )
        for run in study.runs
    )
    text = (
        f"Eq. (5) in the right units gives {quantity(study.torque, 'N*m', 4)} from {POWER:g} W at {FREQUENCY:g} Hz; "
        f"the paper's factor of 60 makes {study.printed_torque:.1f} N·m of it. As a constant torque on the exciter "
        "either would only speed it up, because the stand takes up far less: a drive holds the speed."
    )
    header = ("model", "mean torque", "torque", "mean power", "heat in dampers")
    return (
        Picture(exciter_torque_curve(study), "torque", words, words),
        Table("What the drive has to give in steady motion.", header, rows, "lrrrr"),
        Paragraph(text),
    )


def _span(found: Range, unit: str, digits: int) -> str:
    return f"{quantity(found.min, unit, digits)} to {quantity(found.max, unit, digits)}"
