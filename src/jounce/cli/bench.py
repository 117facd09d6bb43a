"""``jounce bench``: the laboratory bench, its drive, its prototype, its springs."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from functools import wraps
from typing import TYPE_CHECKING, Annotated, Any, TypeVar

import typer

from jounce.cli.options import (
    LENGTH,
    AsJson,
    bare_numbers,
    optional_positive,
    optional_quantity,
)
from jounce.cli.reply import Reply, estimates, show_findings, table
from jounce.core.display import size
from jounce.core.errors import DescriptionError
from jounce.core.typed import pairs, positive_quantity, quantity

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.bench.drive import AttainableSpeed, BeltSpeed, DriveMargin, SensorSpeed
    from jounce.bench.similitude import SimilitudeReport
    from jounce.bench.springs import SpringComparison
    from jounce.core.description import Description
    from jounce.core.findings import Finding

D = TypeVar("D", bound="Description")
Row = tuple[str, object, str]
Values = dict[str, str | None]

app = typer.Typer(no_args_is_help=True, help="The laboratory bench: belt speed, drive, similitude, choice of spring.")
PUBLISHED_SPRINGS = ("bicycle=52775 N/m", "scooter=22730 N/m")

_BELT = {
    "supply_frequency": "Rated frequency of the motor. Default: 60 Hz.",
    "rated_motor_speed": "Rated speed of the motor. Default: 356.05 rad/s.",
    "pole_pairs": "Pole pairs of the motor. Default: 1.",
    "motor_pulley_diameter": "Diameter of the pulley on the motor. Default: 60 mm.",
    "cylinder_pulley_diameter": "Diameter of the pulley on the cylinder. Default: 120 mm.",
    "cylinder_radius": "Radius R of the cylinder. Default: 50 mm (estimated).",
    "belt_thickness": "Thickness t of the flat belt. Default: 3 mm (estimated).",
    "belt_length": "Length of the belt loop. Default: 1.97 m.",
    "belt_reference": "Effective radius of the belt: pitch (R + t/2), outer (R + t) or bare (R). Default: pitch.",
    "pulley_slip": "Slip between motor and cylinder. Default: 2 % (estimated).",
    "flat_belt_slip": "Slip between cylinder and flat belt. Default: 0 % (estimated).",
}
_DRIVE = {
    "motor_power": "Rated power of the motor. Default: 1500 W.",
    **{name: text for name, text in _BELT.items() if name != "belt_length"},
    "efficiency": "Efficiency of the drive. Default: 0.95 (estimated).",
    "standstill_torque": "Share of the rated torque that the motor sustains at standstill. Default: 0.5 (estimated).",
    "wheel_load": "Wheel load on the belt. Default: 206 N (estimated).",
    "rolling_resistance": "Rolling resistance coefficient of the tyre. Default: 0.02 (estimated).",
    "bed_friction": "Coefficient of friction between belt and bed. Default: 0.3 (estimated).",
    "bed_load": "Load of the belt on its bed. Default: the wheel load.",
    "bending_force": "Pull needed to bend the belt. Default: 10 N (estimated).",
    "drag": "Resistance proportional to speed. Default: 0 N*s/m (estimated).",
    "inertia": "Moment of inertia at the cylinder. Default: 0 kg*m^2 (estimated).",
    "acceleration": "Acceleration of the belt. Default: 0 m/s^2.",
}
_SCALE = {
    "reference_mass": "Sprung mass at full size. Default: 265 kg.",
    "prototype_mass": "Sprung mass as built. Default: 16 kg.",
    "geometry_factor": "Ratio of lengths, full size to prototype. Default: 1.5.",
    "mass_factor": "Ratio of the edges of the mass, full size to prototype. Default: 2.5.",
    "reference_density": "Density at full size. Default: 7850 kg/m^3 (estimated).",
    "prototype_density": "Density of the prototype's mass. Default: 7150 kg/m^3.",
    "prototype_wheel_rate": "Wheel rate as built. Default: 18362 N/m.",
    "prototype_tyre_stiffness": "Tyre stiffness as built. Default: 138468 N/m.",
    "prototype_speed": "Speed of the trials. Default: 1.95 m/s.",
    "reference_frequency": "Body bounce frequency at full size. Default: 1.5 Hz (estimated).",
}
_SPRINGS = {
    "sprung_mass": "Sprung mass. Default: 16 kg.",
    "strut_angle": "Angle of the strut to the vertical. Default: 26 deg.",
    "tyre_stiffness": "Stiffness of the tyre in series. Default: 138468 N/m.",
    "damping_coefficient": "Damping coefficient along the strut. Default: 150 N*s/m (estimated).",
    "available_travel": "Travel available at the wheel. Default: 40 mm (estimated).",
    "target_frequency": "Target frequency of body bounce. Default: 1.84 Hz (estimated).",
    "friction_force": "Friction force at the sprung mass. Default: 15 N (estimated).",
}


def _with_values(helps: Mapping[str, str]) -> Callable[[Callable[..., Reply]], Callable[..., Reply]]:
    """Give a command one option for each value of the bench; it receives their texts together as ``values``."""

    def decorate(command: Callable[..., Reply]) -> Callable[..., Reply]:
        *own, as_json = (
            item for item in inspect.signature(command, eval_str=True).parameters.values() if item.name != "values"
        )
        added = [
            inspect.Parameter(
                name,
                inspect.Parameter.POSITIONAL_OR_KEYWORD,
                default=None,
                annotation=Annotated[str | None, typer.Option(metavar="VALUE", help=text, show_default=False)],
            )
            for name, text in helps.items()
        ]

        @wraps(command)
        def run(**options: Any) -> Reply:
            values = {name: options.pop(name) for name in helps}
            return command(values=values, **options)

        run.__signature__ = inspect.Signature([*own, *added, as_json])  # type: ignore[attr-defined]
        return run

    return decorate


def _described(kind: type[D], values: Values) -> D:
    """Build a description from the values that were given (others may be among them); the rest keeps its defaults."""
    texts = {name: str(values[name]) for name in kind.model_fields if values.get(name) is not None}
    given = bare_numbers(kind, texts, lambda name: f"--{name.replace('_', '-')}")
    try:
        return kind.from_table(given)
    except DescriptionError as error:
        text = str(error)
        for name in given:
            text = text.replace(f"{name}: ", f"--{name.replace('_', '-')}: ")
        raise DescriptionError(text.rstrip(".")) from None


@app.command("speed")
@_with_values(_BELT)
def speed(
    values: Values,
    inverter_frequency: Annotated[
        str | None, typer.Option(metavar="VALUE", help='Frequency set at the inverter, e.g. "24.6 Hz".')
    ] = None,
    wanted: Annotated[
        str | None, typer.Option("--speed", metavar="VALUE", help="Belt speed to reach; gives the inverter frequency.")
    ] = None,
    pulses: Annotated[int | None, typer.Option(help="Pulses counted by the photo-sensor on the cylinder.")] = None,
    duration: Annotated[str | None, typer.Option(metavar="VALUE", help="Counting time of the pulses.")] = None,
    pulses_per_revolution: Annotated[int, typer.Option(help="Marks on the cylinder.")] = 1,
    radius_error: Annotated[str, typer.Option(metavar="VALUE", help="Standard error of the radius.")] = "0 mm",
    as_json: AsJson = False,
) -> Reply:
    """Belt speed from the inverter frequency or from photo-sensor pulses, or the frequency for a speed.

    Example: jounce bench speed --inverter-frequency "24.6 Hz" --cylinder-radius "50 mm"
    """
    from jounce.bench.drive import BenchDrive, belt_speed, inverter_frequency_for, photo_sensor_speed

    drive = _described(BenchDrive, values)
    if (inverter_frequency is not None and wanted is not None) or {inverter_frequency, wanted, pulses} == {None}:
        raise DescriptionError(
            "give what the speed follows from",
            where="jounce bench speed",
            allowed='either --inverter-frequency "24.6 Hz" or --speed "1.95 m/s", and/or --pulses 62 --duration "10 s"',
        )
    frequency = optional_quantity(inverter_frequency, "Hz", "--inverter-frequency")
    if wanted is not None:
        frequency = inverter_frequency_for(drive, positive_quantity(wanted, "m/s", "--speed"))
    computed = None if frequency is None else belt_speed(drive, frequency)
    counted = None
    counting = optional_positive(duration, "s", "--duration")
    error = quantity(radius_error, "m", "--radius-error", most=LENGTH)
    if pulses is None and counting is not None:
        hint = "Count them in that time, or leave it out."
        raise DescriptionError("--duration is the time in which --pulses are counted, which are missing", hint=hint)
    if pulses is not None:
        if counting is None:
            raise DescriptionError("--duration is missing; pulses are counted in a time", allowed='--duration "10 s"')
        counted = photo_sensor_speed(
            drive,
            pulses,
            counting,
            pulses_per_revolution=pulses_per_revolution,
            radius_error=error,
        )
    return _speed_reply(computed, counted, as_json=as_json)


_PUBLISHED_CEILING = 3.87  # m/s, at which the published bench stopped


@app.command("drive")
@_with_values(_DRIVE)
def drive(
    values: Values,
    belt_speed: Annotated[
        str | None, typer.Option("--speed", metavar="VALUE", help='Belt speed to assess, e.g. "3.87 m/s".')
    ] = None,
    observed_ceiling: Annotated[
        str | None,
        typer.Option(
            metavar="VALUE",
            help="Highest speed reached in practice; gives the pull that would explain it. Default: 3.87 m/s of the "
            "published bench, where nothing else of it is changed.",
        ),
    ] = None,
    as_json: AsJson = False,
) -> Reply:
    """Torque and power margin at a belt speed, the attainable speed, and what limits it.

    Example: jounce bench drive --speed "3.87 m/s" --cylinder-radius "50 mm"
    """
    from jounce.bench.drive import BeltLoad, BenchDrive, attainable_speed, drive_margin

    machine, load = _described(BenchDrive, values), _described(BeltLoad, values)
    margin = None
    if belt_speed is not None:
        margin = drive_margin(machine, positive_quantity(belt_speed, "m/s", "--speed"), load)
    ceiling = optional_quantity(observed_ceiling, "m/s", "--observed-ceiling")
    if ceiling is None and machine == BenchDrive() and load == BeltLoad():
        ceiling = _PUBLISHED_CEILING
    return _drive_reply(margin, attainable_speed(machine, load, observed_ceiling=ceiling), as_json=as_json)


@app.command("scale")
@_with_values(_SCALE)
def scale(values: Values, as_json: AsJson = False) -> Reply:
    """Similitude of a prototype: its mass by Eq. 1 of the paper, the scale factors, and which of them it violates.

    Example: jounce bench scale --prototype-mass "18.6 kg"
    """
    from jounce.bench.similitude import Similitude, similitude_report

    return _scale_reply(similitude_report(_described(Similitude, values)), as_json=as_json)


@app.command("springs")
@_with_values(_SPRINGS)
def springs(
    values: Values,
    candidates: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="NAME=RATE", help=f"Candidates. Default: {', '.join(PUBLISHED_SPRINGS)}.", show_default=False
        ),
    ] = None,
    as_json: AsJson = False,
) -> Reply:
    """Compare candidate springs: static deflection, natural frequency, damping ratio, and which one to choose.

    Example: jounce bench springs stiff="52.775 N/mm" soft="22.73 N/mm" --sprung-mass "16 kg"
    """
    from jounce.bench.springs import SpringChoice, compare_springs

    named: dict[str, Any] = pairs(candidates or PUBLISHED_SPRINGS, "NAME=RATE", 'soft="22.73 N/mm"')
    rates = [(name, positive_quantity(rate, "N/m", name)) for name, rate in named.items()]
    return _springs_reply(compare_springs(rates, _described(SpringChoice, values)), as_json=as_json)


def _speed_reply(computed: BeltSpeed | None, counted: SensorSpeed | None, *, as_json: bool) -> Reply:
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
                ("photo-sensor reading", computed.sensor_speed, "m/s"),
                ("belt speed", computed.speed, "m/s"),
                ("obstacle recurs every", computed.recurrence_time, "s"),
            ]
            out.print(_quantities("From the inverter", rows))
        if counted is not None:
            measured = [("cylinder speed", counted.cylinder_speed, "rad/s"), ("belt speed", counted.speed, "m/s")]
            out.print(estimates("From the photo-sensor", measured))
            out.print(
                f"one pulse corresponds to {counted.resolution:.4g} m/s; "
                f"the obstacle recurs every {counted.recurrence_time:.4g} s"
            )
        show_findings(out, findings)

    return Reply(plain, draw, as_json)


def _drive_reply(margin: DriveMargin | None, attainable: AttainableSpeed, *, as_json: bool) -> Reply:
    """Demand of the belt and capacity of the motor."""
    findings = _together(margin, attainable)
    plain = {**(_plain(margin) or {}), "attainable": _plain(attainable), "findings": _list(findings)}

    def draw(out: Console) -> None:
        if margin is not None:
            header = ("", "required", "available", "continuous", "unit")
            sides = [
                ("pull at the belt", margin.required_force, margin.available_force, margin.continuous_force, "N"),
                ("power at the belt", margin.required_power, margin.available_power, None, "W"),
                ("torque of the motor", margin.required_torque, margin.rated_torque, None, "N*m"),
                ("margin", None, margin.margin, margin.continuous_margin, "1"),
            ]
            title = f"Drive at {size(margin.speed, 'm/s', 'speed')}, inverter at {margin.inverter_frequency:.4g} Hz"
            out.print(table(title, header, sides, text=(0, 4)))
        rows: list[Row] = [
            (f"attainable speed, limited by {attainable.limited_by}", attainable.speed, "m/s"),
            ("attainable for a short time", attainable.short_time_speed, "m/s"),
            ("motor overheats in continuous duty below", attainable.lowest_continuous_speed, "m/s"),
        ]
        if attainable.implied_force is not None:
            rows.append(("pull that would explain the observed ceiling", attainable.implied_force, "N"))
        out.print(_quantities("Attainable", rows))
        show_findings(out, findings)

    return Reply(plain, draw, as_json)


def _scale_reply(report: SimilitudeReport, *, as_json: bool) -> Reply:
    """Mass, factors and violations."""

    def draw(out: Console) -> None:
        rows: list[Row] = [
            ("mass by Eq. 1, same density", report.mass_same_density, "kg"),
            ("mass by Eq. 1, density of the prototype", report.mass_prototype_density, "kg"),
            ("mass factor that gives the mass as built", report.effective_mass_factor, "1"),
            ("full-size density that gives the mass as built", report.density_for_built_mass, "kg/m^3"),
            ("body bounce frequency of the prototype", report.frequency, "Hz"),
            ("body bounce frequency of a similar prototype", report.similar_frequency, "Hz"),
        ]
        out.print(_quantities("Prototype", rows))
        factors = [(item.name, item.factor, item.prototype, item.full_size, item.unit) for item in report.factors]
        header = ("quantity", "full size / prototype", "prototype", "full-size equivalent", "unit")
        out.print(table("Similitude under the same gravity", header, factors, text=(0, 4)))
        show_findings(out, report.findings)

    return Reply({**(_plain(report) or {}), "findings": _list(report.findings)}, draw, as_json)


def _springs_reply(comparison: SpringComparison, *, as_json: bool) -> Reply:
    """Candidates side by side."""

    def draw(out: Console) -> None:
        header = ("", "spring N/mm", "wheel N/mm", "static mm", "share of travel %", "natural Hz", "rigid tyre Hz",
                  "damping ratio", "friction band mm")  # fmt: skip
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
        out.print(f"recommended: {comparison.chosen}", style="bold")
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
