"""Answers of the bench commands."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from jounce.cli.reply import Reply
from jounce.cli.tables import estimates, show_findings, table

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.bench.drive import BeltSpeed, SensorSpeed
    from jounce.bench.similitude import SimilitudeReport
    from jounce.bench.springs import SpringComparison
    from jounce.bench.traction import AttainableSpeed, DriveMargin
    from jounce.core.findings import Finding

Row = tuple[str, object, str]


def speed_reply(computed: BeltSpeed | None, counted: SensorSpeed | None, *, as_json: bool) -> Reply:
    """Belt speed from the inverter, from the photo-sensor, or both side by side."""
    findings = _together(computed, counted)
    known = counted.speed.value if counted is not None else computed.speed if computed is not None else None
    plain = {"speed": known, "inverter": _plain(computed), "photo_sensor": _plain(counted), "findings": _list(findings)}

    def draw(out: Console) -> None:
        if computed is not None:
            rows: list[Row] = [
                ("inverter frequency", computed.inverter_frequency, "Hz"),
                ("motor speed", computed.motor_speed, "rad/s"),
                ("cylinder speed", computed.cylinder_speed, "rad/s"),
                ("belt speed without slip", computed.ideal_speed, "m/s"),
                ("what the photo-sensor reports", computed.sensor_speed, "m/s"),
                ("belt speed", computed.speed, "m/s"),
                ("an obstacle recurs after", computed.recurrence_time, "s"),
            ]
            out.print(_quantities("From the inverter", rows))
        if counted is not None:
            measured = [("cylinder speed", counted.cylinder_speed, "rad/s"), ("belt speed", counted.speed, "m/s")]
            out.print(estimates("From the photo-sensor", measured))
            out.print(
                f"one pulse is {counted.resolution:.4g} m/s; an obstacle recurs after {counted.recurrence_time:.4g} s"
            )
        show_findings(out, findings)

    return Reply(plain, draw, as_json)


def drive_reply(margin: DriveMargin | None, attainable: AttainableSpeed, *, as_json: bool) -> Reply:
    """What the belt asks and what the motor has."""
    findings = _together(margin, attainable)
    plain = {**(_plain(margin) or {}), "attainable": _plain(attainable), "findings": _list(findings)}

    def draw(out: Console) -> None:
        if margin is not None:
            header = ("", "required", "available", "for long", "unit")
            sides = [
                ("pull at the belt", margin.required_force, margin.available_force, margin.continuous_force, "N"),
                ("power at the belt", margin.required_power, margin.available_power, None, "W"),
                ("torque of the motor", margin.required_torque, margin.rated_torque, None, "N*m"),
                ("margin", None, margin.margin, margin.continuous_margin, "1"),
            ]
            title = f"Drive at {margin.speed:g} m/s, inverter at {margin.inverter_frequency:.4g} Hz"
            out.print(table(title, header, sides, text=(0, 4)))
        rows: list[Row] = [
            (f"attainable speed, limited by {attainable.limited_by}", attainable.speed, "m/s"),
            ("for a short time", attainable.short_time_speed, "m/s"),
            ("too hot below", attainable.lowest_continuous_speed, "m/s"),
        ]
        if attainable.implied_force is not None:
            rows.append(("pull that explains the ceiling", attainable.implied_force, "N"))
        out.print(_quantities("Attainable", rows))
        show_findings(out, findings)

    return Reply(plain, draw, as_json)


def scale_reply(report: SimilitudeReport, *, as_json: bool) -> Reply:
    """Mass, factors and violations."""

    def draw(out: Console) -> None:
        rows: list[Row] = [
            ("mass by Eq. 1, same density", report.mass_same_density, "kg"),
            ("mass by Eq. 1, density of the prototype", report.mass_prototype_density, "kg"),
            ("factor that gives the mass as built", report.effective_mass_factor, "1"),
            ("full-size density that gives the mass as built", report.density_for_built_mass, "kg/m^3"),
            ("body bounce of the prototype", report.frequency, "Hz"),
            ("body bounce of a similar one", report.similar_frequency, "Hz"),
        ]
        out.print(_quantities("Prototype", rows))
        factors = [(item.name, item.factor, item.prototype, item.full_size, item.unit) for item in report.factors]
        header = ("quantity", "full size / prototype", "prototype", "stands for", "unit")
        out.print(table("Similitude with the same gravity", header, factors, text=(0, 4)))
        show_findings(out, report.findings)

    return Reply({**(_plain(report) or {}), "findings": _list(report.findings)}, draw, as_json)


def springs_reply(comparison: SpringComparison, *, as_json: bool) -> Reply:
    """Candidates side by side."""

    def draw(out: Console) -> None:
        header = ("", "spring N/mm", "wheel N/mm", "static mm", "of the travel %", "natural Hz", "on rigid tyre Hz",
                  "damping ratio", "friction holds mm")  # fmt: skip
        rows = [
            (
                row.name,
                1e-3 * row.spring_rate,
                1e-3 * row.wheel_rate,
                1e3 * row.static_deflection,
                100.0 * row.travel_share,
                row.natural_frequency,
                row.natural_frequency_rigid_tyre,
                row.damping_ratio,
                1e3 * row.friction_deflection,
            )
            for row in comparison.rows
        ]
        out.print(table("Springs", header, rows))
        out.print(f"take: {comparison.chosen}", style="bold")
        show_findings(out, comparison.findings)

    return Reply({**(_plain(comparison) or {}), "findings": _list(comparison.findings)}, draw, as_json)


def _quantities(title: str, rows: list[Row]) -> Any:
    return table(title, ("quantity", "value", "unit"), rows, text=(0, 2))


def _plain(result: Any) -> dict[str, Any] | None:
    """Plain values of a result without its findings, which are listed once for all."""
    from jounce.core.serialise import to_plain

    return None if result is None else {key: value for key, value in to_plain(result).items() if key != "findings"}


def _list(findings: tuple[Finding, ...]) -> list[Any]:
    from jounce.core.serialise import to_plain

    return list(to_plain(findings))


def _together(*results: Any) -> tuple[Finding, ...]:
    """Findings of several results, each once."""
    return tuple(dict.fromkeys(item for result in results if result is not None for item in result.findings))
