"""Options of the bench commands: one for each value of the bench, with its published or estimated default."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Annotated, Any, TypeVar

import typer

from jounce.cli.options import bare_number
from jounce.core.errors import DescriptionError

if TYPE_CHECKING:
    from jounce.core.description import Description

D = TypeVar("D", bound="Description")


def _value(what: str, default: str, *, estimated: bool = False) -> Any:
    return typer.Option(
        metavar="VALUE", help=f"{what} Default: {default}{' (estimated)' if estimated else ''}.", show_default=False
    )


MotorPower = Annotated[str | None, _value("Rated power of the motor.", "1500 W")]
SupplyFrequency = Annotated[str | None, _value("Frequency at which the motor is rated.", "60 Hz")]
RatedMotorSpeed = Annotated[str | None, _value("Rated speed of the motor.", "356.05 rad/s")]
PolePairs = Annotated[str | None, _value("Pole pairs of the motor.", "1")]
MotorPulleyDiameter = Annotated[str | None, _value("Pulley on the motor.", "60 mm")]
CylinderPulleyDiameter = Annotated[str | None, _value("Pulley on the cylinder.", "120 mm")]
BeltLength = Annotated[str | None, _value("Length of the belt loop.", "1.97 m")]
BeltReference = Annotated[
    str | None, _value("Radius at which the belt runs: pitch (R + t/2), outer (R + t) or bare (R).", "pitch")
]
CylinderRadius = Annotated[str | None, _value("Radius R of the cylinder.", "50 mm", estimated=True)]
BeltThickness = Annotated[str | None, _value("Thickness t of the flat belt.", "3 mm", estimated=True)]
PulleySlip = Annotated[str | None, _value("Slip between motor and cylinder.", "2 %", estimated=True)]
FlatBeltSlip = Annotated[str | None, _value("Slip between cylinder and flat belt.", "0 %", estimated=True)]
Efficiency = Annotated[str | None, _value("Efficiency of the drive.", "0.95", estimated=True)]
StandstillTorque = Annotated[
    str | None, _value("Share of its torque the motor keeps at standstill without overheating.", "0.5", estimated=True)
]
WheelLoad = Annotated[str | None, _value("Load of the wheel on the belt.", "206 N", estimated=True)]
RollingResistance = Annotated[str | None, _value("Rolling resistance of the tyre.", "0.02", estimated=True)]
BedFriction = Annotated[str | None, _value("Friction of the belt on its bed.", "0.3", estimated=True)]
BedLoad = Annotated[str | None, _value("Load of the belt on its bed.", "the wheel load")]
BendingForce = Annotated[str | None, _value("Pull that bends the belt.", "10 N", estimated=True)]
Drag = Annotated[str | None, _value("Resistance that grows with the speed.", "0 N*s/m", estimated=True)]
Inertia = Annotated[str | None, _value("Moment of inertia at the cylinder.", "0 kg*m^2", estimated=True)]
Acceleration = Annotated[str | None, _value("Acceleration of the belt.", "0 m/s^2")]

ReferenceMass = Annotated[str | None, _value("Sprung mass at full size.", "265 kg")]
PrototypeMass = Annotated[str | None, _value("Sprung mass as built.", "16 kg")]
GeometryFactor = Annotated[str | None, _value("Full-size over prototype length.", "1.5")]
MassFactor = Annotated[str | None, _value("Full-size over prototype edge of the mass.", "2.5")]
PrototypeDensity = Annotated[str | None, _value("Density of the prototype's mass.", "7150 kg/m^3")]
PrototypeWheelRate = Annotated[str | None, _value("Spring at the wheel, as built.", "18362 N/m")]
PrototypeTyreStiffness = Annotated[str | None, _value("Tyre, as built.", "138468 N/m")]
PrototypeSpeed = Annotated[str | None, _value("Speed of the trials.", "1.95 m/s")]
ReferenceDensity = Annotated[str | None, _value("Density at full size.", "7850 kg/m^3", estimated=True)]
ReferenceFrequency = Annotated[str | None, _value("Body bounce at full size.", "1.5 Hz", estimated=True)]

SprungMass = Annotated[str | None, _value("Sprung mass.", "16 kg")]
StrutAngle = Annotated[str | None, _value("Angle of the strut to the vertical.", "26 deg")]
TyreStiffness = Annotated[str | None, _value("Tyre in series.", "138468 N/m")]
DampingCoefficient = Annotated[str | None, _value("Damper along the strut.", "150 N*s/m", estimated=True)]
AvailableTravel = Annotated[str | None, _value("Travel at the wheel.", "40 mm", estimated=True)]
TargetFrequency = Annotated[str | None, _value("Body bounce wanted.", "1.84 Hz", estimated=True)]
FrictionForce = Annotated[str | None, _value("Friction at the sprung mass.", "15 N", estimated=True)]


def described(kind: type[D], options: Mapping[str, object]) -> D:
    """Build a description from the options that were given (others may be among them); the rest keeps its defaults."""
    given = {name: bare_number(str(options[name])) for name in kind.model_fields if options.get(name) is not None}
    try:
        return kind.from_table(given)
    except DescriptionError as error:
        text = str(error)
        for name in given:
            text = text.replace(f"{name}: ", f"--{name.replace('_', '-')}: ")
        raise DescriptionError(text.rstrip(".")) from None
