"""The laboratory bench as pages: belt speed, drive, similitude, and choice of a spring."""

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


def belt_speed_page(found: BeltSpeeds, *, title: str) -> Page:
    """Put the belt speed, from the inverter and from the photo-sensor, on a page."""
    blocks: list[Block] = []
    if found.inverter is not None:
        drive = found.inverter
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
    if found.photo_sensor is not None:
        counted = found.photo_sensor
        estimates = (counted.cylinder_speed, counted.speed)
        lows, highs = zip(*(one.interval or (None, None) for one in estimates), strict=True)
        columns = (
            TableColumn("quantity", ["cylinder speed [rad/s]", "belt speed [m/s]"]),
            TableColumn("value", [one.value for one in estimates], "1"),
            TableColumn("standard error", [one.standard_error for one in estimates], "1"),
            TableColumn("95 % interval, from", lows, "1"),
            TableColumn("to", highs, "1"),
        )
        note = f"One pulse corresponds to {size(counted.resolution, 'm/s', 'speed')}; "
        note += f"the obstacle recurs every {counted.recurrence_time:.4g} s."
        blocks.append(table_of("From the photo-sensor", columns, note))
    return answer_page(title, [*blocks, *findings_blocks(found.findings)])


def drive_page(found: DriveAssessment, *, title: str) -> Page:
    """Put the margin of the drive and the attainable speed on a page."""
    blocks: list[Block] = []
    if found.margin is not None:
        one = found.margin
        caption = f"Drive at {size(one.speed, 'm/s', 'speed')}, inverter at {one.inverter_frequency:.4g} Hz"
        columns = (
            TableColumn("", ["pull at the belt [N]", "power at the belt [W]", "torque of the motor [N m]", "margin"]),
            TableColumn("required", [one.required_force, one.required_power, one.required_torque, None], "1"),
            TableColumn("available", [one.available_force, one.available_power, one.rated_torque, one.margin], "1"),
            TableColumn("continuous", [one.continuous_force, None, None, one.continuous_margin], "1"),
        )
        blocks.append(table_of(caption, columns))
    fastest = found.attainable
    rows: list[tuple[str, float | None, str]] = [
        (f"attainable speed, limited by {fastest.limited_by}", fastest.speed, "m/s"),
        ("attainable for a short time", fastest.short_time_speed, "m/s"),
        ("motor overheats in continuous duty below", fastest.lowest_continuous_speed, "m/s"),
    ]
    if fastest.implied_force is not None:
        rows.append(("pull that would explain the observed ceiling", fastest.implied_force, "N"))
    blocks.append(quantity_table("Attainable", rows))
    return answer_page(title, [*blocks, *findings_blocks(found.findings)])


def similitude_page(found: SimilitudeReport, *, title: str) -> Page:
    """Put the masses, the scale factors and the violations of a prototype on a page."""
    rows = [
        ("mass by Eq. 1, same density", found.mass_same_density, "kg"),
        ("mass by Eq. 1, density of the prototype", found.mass_prototype_density, "kg"),
        ("mass factor that gives the mass as built", found.effective_mass_factor, "1"),
        ("full-size density that gives the mass as built", found.density_for_built_mass, "kg/m^3"),
        ("body bounce frequency of the prototype", found.frequency, "Hz"),
        ("body bounce frequency of a similar prototype", found.similar_frequency, "Hz"),
    ]
    columns = (
        TableColumn("quantity", [f"{one.name} [{one.unit}]" for one in found.factors]),
        TableColumn("full size / prototype", [one.factor for one in found.factors], "1"),
        TableColumn("prototype", [one.prototype for one in found.factors], "1"),
        TableColumn("full-size equivalent", [one.full_size for one in found.factors], "1"),
    )
    factors = table_of("Similitude under the same gravity", columns)
    return answer_page(title, [quantity_table("Mass and frequency", rows), factors, *findings_blocks(found.findings)])


def spring_choice_page(found: SpringComparison, *, title: str) -> Page:
    """Put candidate springs side by side on a page, with the recommended one."""
    rows = found.rows
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
        [table_of("Candidates", columns), Paragraph(f"recommended: {found.chosen}"), *findings_blocks(found.findings)],
    )
