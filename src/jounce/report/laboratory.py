"""Pages of what a laboratory hands in: its folder, and calibrations of its sensors."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jounce.report.page import Column, Findings, Page, Section, table_of

if TYPE_CHECKING:
    from jounce.campaign.from_folder import FolderCampaign
    from jounce.campaign.model_choice import ModelChoice
    from jounce.identify.calibration import Calibration


def folder_page(made: FolderCampaign, *, title: str = "") -> Page:
    """What each file of a folder was taken for, and what is missing."""
    files = table_of(
        "Files",
        (
            Column("file", [item.file.name for item in made.files]),
            Column("is", [item.kind for item in made.files]),
            Column("trial", ["" if item.number is None else str(item.number) for item in made.files]),
            Column("because", [item.why for item in made.files]),
        ),
    )
    return Page(title or "Campaign of a folder", (Section("Files", (files, Findings(made.findings))),))


def calibration_page(found: Calibration, *, title: str = "") -> Page:
    """Sensitivity and zero with their intervals, and the points beside the line."""
    rows = (("sensitivity", found.sensitivity), ("zero", found.zero))
    recorded = found.recorded_unit.replace("1", "counts")
    units = (f"{recorded}/({found.quantity_unit})", recorded)
    results = table_of(
        "Calibration",
        (
            Column("quantity", [name for name, _ in rows]),
            Column("value", [f"{item.value:.6g}" for _, item in rows]),
            Column("standard error", [_text(item.standard_error) for _, item in rows]),
            Column(
                "95 % interval",
                ["" if item.interval is None else " to ".join(map(_text, item.interval)) for _, item in rows],
            ),
            Column("unit", list(units)),
        ),
    )
    line = [found.zero.value + found.sensitivity.value * x for x in found.reference]
    points = table_of(
        "Points",
        (
            Column(f"reference [{found.quantity_unit}]", [f"{x:.6g}" for x in found.reference]),
            Column(f"recorded [{recorded}]", [f"{y:.6g}" for y in found.recorded]),
            Column(
                f"off the line [{recorded}]", [f"{y - fit:+.2g}" for y, fit in zip(found.recorded, line, strict=True)]
            ),
        ),
    )
    return Page(title or "Calibration", (Section("Calibration", (results, points, Findings(found.findings))),))


def model_choice_page(found: ModelChoice, *, title: str = "") -> Page:
    """Models of an update beside each other, the one that the data carry best first."""
    models = found.models
    table = table_of(
        f"Models of {found.update}",
        (
            Column("model", [row.model for row in models]),
            Column("parameters", [str(row.parameters) for row in models]),
            Column("AIC above least", [f"{row.aic:.1f}" for row in models]),
            Column("BIC above least", [f"{row.bic:.1f}" for row in models]),
            Column("least R2, fitted", [_text(row.fitted) for row in models]),
            Column("least R2, held out", [_text(row.held_out) for row in models]),
            Column("held-out trials that hold", [f"{row.holds} of {row.trials}" for row in models]),
        ),
        "AIC and BIC count independent residuals; models within 2 of the least AIC are carried alike.",
    )
    return Page(title or "Models compared", (Section("Models", (table, Findings(found.findings))),))


def _text(value: float | None) -> str:
    return "" if value is None else f"{value:.5g}"
