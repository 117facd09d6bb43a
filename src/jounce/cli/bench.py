"""``jounce bench``: the laboratory bench, its drive, its prototype, its springs."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from jounce.cli import bench_options as bench
from jounce.cli import bench_tables as tables
from jounce.cli.options import AsJson, optional_quantity, pairs, positive_quantity, quantity
from jounce.cli.reply import Reply
from jounce.core.errors import DescriptionError

app = typer.Typer(
    no_args_is_help=True, help="The laboratory bench: belt speed, drive, similitude, choice of the spring."
)
PUBLISHED_SPRINGS = ("bicycle=52775 N/m", "scooter=22730 N/m")


@app.command("speed")
def speed(
    inverter_frequency: Annotated[
        str | None, typer.Option(metavar="VALUE", help='Frequency set at the inverter, e.g. "24.6 Hz".')
    ] = None,
    wanted: Annotated[
        str | None, typer.Option("--speed", metavar="VALUE", help="Belt speed wanted: gives the frequency.")
    ] = None,
    pulses: Annotated[int | None, typer.Option(help="Pulses that the photo-sensor on the cylinder counted.")] = None,
    duration: Annotated[str | None, typer.Option(metavar="VALUE", help="How long it counted.")] = None,
    pulses_per_revolution: Annotated[int, typer.Option(help="Marks on the cylinder.")] = 1,
    radius_error: Annotated[str, typer.Option(metavar="VALUE", help="Standard error of the radius.")] = "0 mm",
    supply_frequency: bench.SupplyFrequency = None,
    rated_motor_speed: bench.RatedMotorSpeed = None,
    pole_pairs: bench.PolePairs = None,
    motor_pulley_diameter: bench.MotorPulleyDiameter = None,
    cylinder_pulley_diameter: bench.CylinderPulleyDiameter = None,
    cylinder_radius: bench.CylinderRadius = None,
    belt_thickness: bench.BeltThickness = None,
    belt_length: bench.BeltLength = None,
    belt_reference: bench.BeltReference = None,
    pulley_slip: bench.PulleySlip = None,
    flat_belt_slip: bench.FlatBeltSlip = None,
    as_json: AsJson = False,
) -> Reply:
    """Belt speed from the inverter's frequency or from photo-sensor pulses, or the frequency for a speed.

    Example: jounce bench speed --inverter-frequency "24.6 Hz" --cylinder-radius "50 mm"
    """
    options = locals()
    from jounce.bench.drive import BenchDrive, belt_speed, inverter_frequency_for, photo_sensor_speed

    drive = bench.described(BenchDrive, options)
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
    if pulses is not None:
        if duration is None:
            raise DescriptionError("--duration is missing; pulses are counted in a time", allowed='--duration "10 s"')
        counted = photo_sensor_speed(
            drive,
            pulses,
            positive_quantity(duration, "s", "--duration"),
            pulses_per_revolution=pulses_per_revolution,
            radius_error=quantity(radius_error, "m", "--radius-error"),
        )
    return tables.speed_reply(computed, counted, as_json=as_json)


@app.command("drive")
def drive(
    belt_speed: Annotated[
        str | None, typer.Option("--speed", metavar="VALUE", help='Belt speed to judge, e.g. "3.87 m/s".')
    ] = None,
    observed_ceiling: Annotated[
        str | None, typer.Option(metavar="VALUE", help="Speed not exceeded in practice: what pull explains it?")
    ] = None,
    motor_power: bench.MotorPower = None,
    supply_frequency: bench.SupplyFrequency = None,
    rated_motor_speed: bench.RatedMotorSpeed = None,
    pole_pairs: bench.PolePairs = None,
    motor_pulley_diameter: bench.MotorPulleyDiameter = None,
    cylinder_pulley_diameter: bench.CylinderPulleyDiameter = None,
    cylinder_radius: bench.CylinderRadius = None,
    belt_thickness: bench.BeltThickness = None,
    belt_reference: bench.BeltReference = None,
    pulley_slip: bench.PulleySlip = None,
    flat_belt_slip: bench.FlatBeltSlip = None,
    efficiency: bench.Efficiency = None,
    standstill_torque: bench.StandstillTorque = None,
    wheel_load: bench.WheelLoad = None,
    rolling_resistance: bench.RollingResistance = None,
    bed_friction: bench.BedFriction = None,
    bed_load: bench.BedLoad = None,
    bending_force: bench.BendingForce = None,
    drag: bench.Drag = None,
    inertia: bench.Inertia = None,
    acceleration: bench.Acceleration = None,
    as_json: AsJson = False,
) -> Reply:
    """Torque and power margin at a belt speed, the attainable speed and what limits it.

    Example: jounce bench drive --speed "3.87 m/s" --cylinder-radius "50 mm"
    """
    options = locals()
    from jounce.bench.drive import BenchDrive
    from jounce.bench.traction import BeltLoad, attainable_speed, drive_margin

    machine, load = bench.described(BenchDrive, options), bench.described(BeltLoad, options)
    margin = None
    if belt_speed is not None:
        margin = drive_margin(machine, positive_quantity(belt_speed, "m/s", "--speed"), load)
    ceiling = optional_quantity(observed_ceiling, "m/s", "--observed-ceiling")
    return tables.drive_reply(margin, attainable_speed(machine, load, observed_ceiling=ceiling), as_json=as_json)


@app.command("scale")
def scale(
    reference_mass: bench.ReferenceMass = None,
    prototype_mass: bench.PrototypeMass = None,
    geometry_factor: bench.GeometryFactor = None,
    mass_factor: bench.MassFactor = None,
    reference_density: bench.ReferenceDensity = None,
    prototype_density: bench.PrototypeDensity = None,
    prototype_wheel_rate: bench.PrototypeWheelRate = None,
    prototype_tyre_stiffness: bench.PrototypeTyreStiffness = None,
    prototype_speed: bench.PrototypeSpeed = None,
    reference_frequency: bench.ReferenceFrequency = None,
    as_json: AsJson = False,
) -> Reply:
    """Similitude of a prototype: its mass by Eq. 1 of the paper, the factors, and what is violated.

    Example: jounce bench scale --prototype-mass "18.6 kg"
    """
    options = locals()
    from jounce.bench.similitude import Similitude, similitude_report

    return tables.scale_reply(similitude_report(bench.described(Similitude, options)), as_json=as_json)


@app.command("springs")
def springs(
    candidates: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="NAME=RATE", help=f"Candidates. Default: {', '.join(PUBLISHED_SPRINGS)}.", show_default=False
        ),
    ] = None,
    sprung_mass: bench.SprungMass = None,
    strut_angle: bench.StrutAngle = None,
    tyre_stiffness: bench.TyreStiffness = None,
    damping_coefficient: bench.DampingCoefficient = None,
    available_travel: bench.AvailableTravel = None,
    target_frequency: bench.TargetFrequency = None,
    friction_force: bench.FrictionForce = None,
    as_json: AsJson = False,
) -> Reply:
    """Compare candidate springs: static deflection, frequency, damping ratio, and which one to take.

    Example: jounce bench springs stiff="52.775 N/mm" soft="22.73 N/mm" --sprung-mass "16 kg"
    """
    options = locals()
    from jounce.bench.springs import SpringChoice, compare_springs

    named: dict[str, Any] = pairs(candidates or PUBLISHED_SPRINGS, "NAME=RATE", 'soft="22.73 N/mm"')
    rates = [(name, positive_quantity(rate, "N/m", name)) for name, rate in named.items()]
    return tables.springs_reply(compare_springs(rates, bench.described(SpringChoice, options)), as_json=as_json)
