"""Pages of a laboratory: test sheet, folder, calibrations, and model selection."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import TYPE_CHECKING

from jounce.core.commands import command_line
from jounce.core.results import fields_of, fields_table
from jounce.plots import figure_of
from jounce.report.page import (
    Bullets,
    Fact,
    Facts,
    Findings,
    Page,
    PageTable,
    Paragraph,
    Picture,
    Section,
    TableColumn,
    as_table,
    table_of,
)

if TYPE_CHECKING:
    from jounce.campaign.from_folder import FolderCampaign
    from jounce.campaign.model_choice import ModelChoice
    from jounce.campaign.new import NewCampaign
    from jounce.campaign.test_sheet import TestSheet
    from jounce.identify.calibration import Calibration


def folder_page(made: FolderCampaign, *, title: str = "") -> Page:
    """Create a page of the detected role of each file in a folder, and of missing files."""
    files = table_of(
        "Files",
        (
            TableColumn("file", [item.file.name for item in made.files]),
            TableColumn("is", [item.kind for item in made.files]),
            TableColumn(
                "trial", ["" if item.number is None else str(item.number) for item in made.files]
            ),
            TableColumn("because", [item.why for item in made.files]),
        ),
    )
    return Page(
        title or "Campaign of a folder", (Section("Files", (files, Findings(made.findings))),)
    )


def new_campaign_page(start: NewCampaign, *, title: str) -> Page:
    """Create a page of a new campaign: its files or the detected roles of measured files, and next steps."""
    campaign = str(start.campaign)
    run = command_line(["jounce", "campaign", "run", campaign, "--out", "results"])
    if start.made is not None:
        page = folder_page(start.made, title=title)
        return replace(page, sections=(*page.sections, Section("Next", (Bullets((run,)),))))
    files = Paragraph(f"Files: {', '.join(start.files)}")
    text = Paragraph("Next: put your measurements there, edit campaign.toml, then")
    commands = Bullets((command_line(["jounce", "check", campaign]), run))
    return Page(title, (Section("Files", (files, text, commands)),))


def calibration_page(calibration: Calibration, *, title: str = "") -> Page:
    """Create a page of sensitivity and zero with intervals, points and fitted line, and keys of a sensor."""
    sensitivity, zero = fields_of(calibration, "sensitivity", "zero")
    known = [
        field
        for field in fields_of(calibration, "residual", "gain_doubt")
        if field.value is not None
    ]
    note = "; ".join(f"{field.label} {field.in_words()}" for field in known) + "."
    results = as_table(fields_table("Calibration", [sensitivity, zero]), note)
    rounding = 1e-12 * max(map(abs, calibration.recorded))
    points = table_of(
        "Points",
        (
            TableColumn("reference", list(calibration.reference), calibration.quantity_unit),
            TableColumn(f"recorded [{zero.unit}]", [f"{y:.6g}" for y in calibration.recorded]),
            TableColumn(
                f"off the line [{zero.unit}]",
                [f"{y:+.2g}" if abs(y) > rounding else "0" for y in calibration.off_the_line()],
            ),
        ),
    )
    keys = Bullets(
        tuple(f"{name} = {json.dumps(value)}" for name, value in calibration.sensor().items())
    )
    in_file = Paragraph(
        "As keys of a sensor in a campaign, or of a channel in the settings of a laboratory:"
    )
    words = (
        "Recorded values against known sizes with the fitted line, and deviations from that line."
    )
    picture = Picture(lambda: figure_of(calibration), "calibration", words, words)
    blocks = (results, points, in_file, keys, Findings(calibration.findings), picture)
    return Page(
        title or "Calibration", (Section("Calibration", blocks),), "Calibration of a sensor"
    )


def model_choice_page(choice: ModelChoice, *, title: str = "") -> Page:
    """Create a page that compares the models of an update, best supported by the data first."""
    models = choice.models
    table = table_of(
        f"Models of {choice.update}",
        (
            TableColumn("model", [row.model for row in models]),
            TableColumn("parameters", [str(row.parameters) for row in models]),
            TableColumn("AIC above minimum", [f"{row.aic:.1f}" for row in models]),
            TableColumn("BIC above minimum", [f"{row.bic:.1f}" for row in models]),
            TableColumn("minimum R2, fitted", [_text(row.fitted) for row in models]),
            TableColumn("minimum R2, held out", [_text(row.held_out) for row in models]),
            TableColumn(
                "held-out trials that hold", [f"{row.holds} of {row.trials}" for row in models]
            ),
        ),
        "AIC and BIC count independent residuals; models within 2 of the lowest AIC are equally supported.",
    )
    return Page(
        title or "Models compared", (Section("Models", (table, Findings(choice.findings))),)
    )


_NOTES = (
    "Date, place, who measures; temperature of the room, and of the tyre before and after",
    "Tyre pressure before and after each trial, with the gauge used",
    "Strut angle as set; spring seat; anything loosened or exchanged since the last trial",
    "Speed of the belt as shown, and the inverter's frequency",
    "Sensors: serial number, mounting, orientation, range and gain of each channel; rate and filters of the card",
    "Mass of the body with everything on it, and of wheel and knuckle, weighed to 1 %",
    "Height and length of the obstacle by caliper, at three places; length of the belt",
)
"""Items that a report requires and a record does not contain."""


def sheet_page(sheet: TestSheet, *, title: str = "") -> Page:
    """Create a printable test sheet: settings, order, expected values, fields for notes, and an optional exercise."""
    masses = ", ".join(f"{mass:g} kg" for mass in sheet.masses)
    frequencies = ", ".join(f"{frequency:.3g} Hz" for frequency in sheet.frequencies)
    facts = Facts((Fact("masses", masses), Fact("natural frequencies expected", frequencies)))
    card = table_of(
        "Channels of the card",
        (
            TableColumn("column", [column for column, _, _ in sheet.channels]),
            TableColumn("measures", [measures for _, measures, _ in sheet.channels]),
            TableColumn("sensitivity", [text for _, _, text in sheet.channels]),
            TableColumn("checked", ["" for _ in sheet.channels]),
        ),
    )
    trials = table_of("Trials in the order of least setup effort", _trial_columns(sheet))
    sections = [
        Section("Settings", (facts, card)),
        Section("Trials", (trials, Paragraph(_PREDICTED, "muted"), _information_table(sheet))),
        Section("To note", (Bullets(_NOTES),)),
    ]
    if sheet.for_students:
        sections += _exercise(sheet)
    return Page(title or sheet.title, tuple(sections), "Test sheet")


_PREDICTED = "Peaks are those of the model before any measurement."
_TAUGHT = (
    "Noise of typical accelerometers only, one loop, all else known: real errors are many times larger; only the "
    "order of the trials is meaningful."
)


def _trial_columns(sheet: TestSheet) -> list[TableColumn]:
    trials = sheet.trials
    shown = [
        TableColumn("trial", [str(trial.number) for trial in trials]),
        TableColumn("speed", [trial.speed for trial in trials], "m/s"),
        TableColumn("angle", [trial.angle for trial in trials], "rad"),
        TableColumn("pressure", [trial.pressure for trial in trials], "Pa"),
        TableColumn("obstacles", [str(trial.obstacles) for trial in trials]),
        TableColumn("pitch", [trial.pitch for trial in trials], "m"),
        TableColumn("returns after", [trial.returns for trial in trials], "s"),
    ]
    shown += [
        TableColumn(f"peak {name}", [trial.peaks.get(name) for trial in trials], "m/s^2")
        for name in ("sprung.az", "unsprung.az")
    ]
    return [*shown, TableColumn("file, remarks", ["" for _ in trials])]


def _information_table(sheet: TestSheet) -> PageTable:
    """Return a table of the standard error of each parameter from each trial alone."""
    paths = dict.fromkeys(path for trial in sheet.trials for path in trial.teaches)
    columns = [
        TableColumn(
            path.replace(".", " ").replace("_", " "),
            [
                f"{100.0 * trial.teaches[path]:.2g} %" if path in trial.teaches else "–"
                for trial in sheet.trials
            ],
        )
        for path in paths
    ]
    names = TableColumn("trial", [str(trial.number) for trial in sheet.trials])
    return table_of(
        "Information from each trial: standard error of a parameter", (names, *columns), _TAUGHT
    )


def _exercise(sheet: TestSheet) -> list[Section]:
    """Return sections in which students predict, measure and compare."""
    numbers = [str(trial.number) for trial in sheet.trials]
    blank = ["" for _ in numbers]
    quantities = (
        "peak sprung.az",
        "peak unsprung.az",
        "natural frequency of the body",
        "of the wheel",
    )

    def form(caption: str, *columns: str) -> PageTable:
        return table_of(
            caption,
            (TableColumn("trial", numbers), *(TableColumn(name, blank) for name in columns)),
        )

    questions = (
        "Which parameter determines the first peak of the wheel, and why does the body hardly respond to it?",
        "At which speed does the obstacle meet a natural frequency, and what do you expect there?",
        "Where does the tyre leave the road, and how would you see it in the record?",
    )
    return [
        Section(
            "Predict",
            (
                Paragraph("Before any trial is run."),
                Bullets(questions),
                form("Prediction", *quantities),
            ),
        ),
        Section("Measure", (form("Measurement", "file", *quantities),)),
        Section(
            "Compare",
            (
                form("Comparison", "predicted", "measured", "difference", "because"),
                Paragraph(
                    "Conclusion: which model do the data support, for which trials, and how do you know?"
                ),
            ),
        ),
    ]


def _text(value: float | None) -> str:
    return "" if value is None else f"{value:.5g}"
