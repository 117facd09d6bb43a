"""Pages of the laboratory bench: belt speed, drive, similitude, and choice of a spring."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jounce.core.display import size
from jounce.report.page import (
    Block,
    Page,
    Paragraph,
    TableColumn,
    answer_page,
    findings_blocks,
    quantity_table,
    table_of,
)

if TYPE_CHECKING:
    from jounce.bench.drive import BeltSpeeds, DriveAssessment
    from jounce.bench.similitude import SimilitudeReport
    from jounce.bench.springs import SpringComparison


def belt_speed_page(speeds: BeltSpeeds, *, title: str) -> Page:
    """Create a page of the belt speed from the inverter and from the photo-sensor."""
    blocks: list[Block] = []
    if speeds.inverter is not None:
        drive = speeds.inverter
        rows = [
            ("inverter frequency", drive.inverter_frequency, "Hz"),
            ("motor speed", drive.motor_speed, "rad/s"),
            ("cylinder speed", drive.cylinder_speed, "rad/s"),
            ("belt speed without slip", drive.ideal_speed, "m/s"),
            ("photo-sensor reading", drive.sensor_speed, "m/s"),
            ("belt speed", drive.speed, "m/s"),
            ("obstacle recurs every", drive.recurrence_time, "s"),
        ]
        blocks.append(quantity_table("From the inverter", rows))
    if speeds.photo_sensor is not None:
        counted = speeds.photo_sensor
        estimates = (counted.cylinder_speed, counted.speed)
        lows, highs = zip(
            *(estimate.interval or (None, None) for estimate in estimates), strict=True
        )
        columns = (
            TableColumn("quantity", ["cylinder speed [rad/s]", "belt speed [m/s]"]),
            TableColumn("value", [estimate.value for estimate in estimates], "1"),
            TableColumn("standard error", [estimate.standard_error for estimate in estimates], "1"),
            TableColumn("95 % interval, from", lows, "1"),
            TableColumn("to", highs, "1"),
        )
        note = f"One pulse corresponds to {size(counted.resolution, 'm/s', 'speed')}; "
        note += f"the obstacle recurs every {counted.recurrence_time:.4g} s."
        blocks.append(table_of("From the photo-sensor", columns, note))
    return answer_page(title, [*blocks, *findings_blocks(speeds.findings)])


def drive_page(assessment: DriveAssessment, *, title: str) -> Page:
    """Create a page of the margin of the drive and the attainable speed."""
    blocks: list[Block] = []
    if assessment.margin is not None:
        margin = assessment.margin
        caption = f"Drive at {size(margin.speed, 'm/s', 'speed')}, inverter at {margin.inverter_frequency:.4g} Hz"
        columns = (
            TableColumn(
                "",
                [
                    "pull at the belt [N]",
                    "power at the belt [W]",
                    "torque of the motor [N m]",
                    "margin",
                ],
            ),
            TableColumn(
                "required",
                [margin.required_force, margin.required_power, margin.required_torque, None],
                "1",
            ),
            TableColumn(
                "available",
                [
                    margin.available_force,
                    margin.available_power,
                    margin.rated_torque,
                    margin.margin,
                ],
                "1",
            ),
            TableColumn(
                "continuous", [margin.continuous_force, None, None, margin.continuous_margin], "1"
            ),
        )
        blocks.append(table_of(caption, columns))
    fastest = assessment.attainable
    rows: list[tuple[str, float | None, str]] = [
        (f"attainable speed, limited by {fastest.limited_by}", fastest.speed, "m/s"),
        ("attainable for a short time", fastest.short_time_speed, "m/s"),
        ("motor overheats in continuous duty below", fastest.lowest_continuous_speed, "m/s"),
    ]
    if fastest.implied_force is not None:
        rows.append(("pull that would explain the observed ceiling", fastest.implied_force, "N"))
    blocks.append(quantity_table("Attainable", rows))
    return answer_page(title, [*blocks, *findings_blocks(assessment.findings)])


def similitude_page(report: SimilitudeReport, *, title: str) -> Page:
    """Create a page of the masses, scale factors and similitude violations of a prototype."""
    rows = [
        ("mass by Eq. 1, same density", report.mass_same_density, "kg"),
        ("mass by Eq. 1, density of the prototype", report.mass_prototype_density, "kg"),
        ("mass factor that gives the mass as built", report.effective_mass_factor, "1"),
        ("full-size density that gives the mass as built", report.density_for_built_mass, "kg/m^3"),
        ("body bounce frequency of the prototype", report.frequency, "Hz"),
        ("body bounce frequency of a similar prototype", report.similar_frequency, "Hz"),
    ]
    columns = (
        TableColumn("quantity", [f"{factor.name} [{factor.unit}]" for factor in report.factors]),
        TableColumn("full size / prototype", [factor.factor for factor in report.factors], "1"),
        TableColumn("prototype", [factor.prototype for factor in report.factors], "1"),
        TableColumn("full-size equivalent", [factor.full_size for factor in report.factors], "1"),
    )
    factors = table_of("Similitude under the same gravity", columns)
    return answer_page(
        title,
        [quantity_table("Mass and frequency", rows), factors, *findings_blocks(report.findings)],
    )


def spring_choice_page(comparison: SpringComparison, *, title: str) -> Page:
    """Create a page that compares candidate springs and marks the recommended one."""
    rows = comparison.rows
    columns = (
        TableColumn("", [row.name for row in rows]),
        TableColumn("spring rate", [row.spring_rate for row in rows], "N/m"),
        TableColumn("wheel rate", [row.wheel_rate for row in rows], "N/m"),
        TableColumn("static deflection", [row.static_deflection for row in rows], "m"),
        TableColumn("share of travel", [row.travel_share for row in rows], "1"),
        TableColumn("natural frequency", [row.natural_frequency for row in rows], "Hz"),
        TableColumn("on a rigid tyre", [row.natural_frequency_rigid_tyre for row in rows], "Hz"),
        TableColumn("damping ratio", [row.damping_ratio for row in rows], "1"),
        TableColumn("friction band", [row.friction_deflection for row in rows], "m"),
    )
    return answer_page(
        title,
        [
            table_of("Candidates", columns),
            Paragraph(f"recommended: {comparison.chosen}"),
            *findings_blocks(comparison.findings),
        ],
    )
