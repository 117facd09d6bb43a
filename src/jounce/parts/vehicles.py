"""Lumped rigs and whole vehicles: quarter car, one axle, half cars and full cars."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal, NamedTuple, Self

from pydantic import Field, model_validator

from jounce.core.constants import GRAVITY
from jounce.core.description import Description
from jounce.core.errors import DescriptionError, unknown
from jounce.core.misplaced import error_at
from jounce.core.phrases import Phrase
from jounce.core.units import (
    Acceleration,
    Length,
    Mass,
    MomentOfInertia,
    NonNegativeDampingCoefficient,
    NonNegativeStiffness,
    PositiveLength,
    PositiveStiffness,
    Unit,
)
from jounce.parts.axles import AnyDependentAxle, DependentAxle
from jounce.parts.bodies import Point
from jounce.parts.corners import AnyCorner, Corner
from jounce.parts.dampers import Damper, LinearDamper
from jounce.parts.elements import BumpStop, Friction, Spring, Tyre, require_one
from jounce.parts.rig import Rig

_StrutAngle = Annotated[float, Unit("rad", at_least=0.0, at_most=1.2)]


class Lump(Description):
    """A mass that only translates along z, kg."""

    mass: Mass


class Strut(Description):
    """Spring and damper unit at ``angle`` to the vertical; lumped, its motion ratio is ``cos(angle)``."""

    angle: _StrutAngle = 0.0
    spring: Spring
    damper: Damper
    friction: Friction | None = None
    bump_stop: BumpStop | None = None


class Guide(Description):
    """Vertical guide of the sprung mass."""

    friction: Friction | None = None


class QuarterCar(Rig):
    """Quarter car: sprung and unsprung mass on strut and tyre, moving vertically (paper 2, eqs 1-4, extended).

    Signs: z up, deflections and forces positive in compression. ``gravity`` in m/s^2.
    """

    schema_: Literal["jounce.rig/1"] = Field(default="jounce.rig/1", alias="schema")
    model: Literal["quarter-car"] = "quarter-car"
    gravity: Acceleration = GRAVITY
    sprung: Lump
    unsprung: Lump
    strut: Strut
    guide: Guide = Guide()
    tyre: Tyre


Compat = Literal["physical", "sign-corrected", "simulink"]


class Place(NamedTuple):
    """Position of a wheel: distance behind the front axle (m), and side (1 left, -1 right, 0 in the middle)."""

    behind: float
    side: int


class VehicleBody(Description):
    """Body: ``mass`` (kg), ``pitch_inertia`` (kg m^2) about its centre of gravity, ``height`` (m) of that centre.

    Without ``height`` deceleration is not an input, because its pitch moment is unknown.
    """

    mass: Mass
    pitch_inertia: MomentOfInertia
    height: PositiveLength | None = None


class RollingBody(VehicleBody):
    """Body that also rolls: ``roll_inertia`` (kg m^2) about the x axis through its centre of gravity."""

    roll_inertia: MomentOfInertia


class Axle(Description):
    """Massless axle of two equal wheels: ``distance`` from the centre of gravity (m), spring and damper per wheel."""

    distance: PositiveLength
    spring_rate: PositiveStiffness
    damping_coefficient: NonNegativeDampingCoefficient


class WheeledAxle(Description):
    """Axle of two equal wheels with masses and tyres. All values are per wheel; springs act at the wheel.

    Deflections and the gaps of stops are measured from the undeformed spring, compression positive.

    Attributes
    ----------
    distance : float
        Distance of the axle from the body's centre of gravity, m.
    unsprung_mass : float
        Unsprung mass of one wheel, kg.
    tyre : Tyre
        Radial tyre.
    spring_rate, damping_coefficient : float or None
        Linear rates, N/m and N s/m. Alternatively give ``spring`` and ``damper`` as in rigs.
    bump_stop, rebound_stop : BumpStop or None
        Stops; the gap of a rebound stop is measured in extension.
    friction : Friction or None
        Friction of the strut.
    """

    distance: PositiveLength
    unsprung_mass: Mass
    tyre: Tyre
    spring_rate: PositiveStiffness | None = None
    spring: Spring | None = None
    damping_coefficient: NonNegativeDampingCoefficient | None = None
    damper: Damper | None = None
    bump_stop: BumpStop | None = None
    rebound_stop: BumpStop | None = None
    friction: Friction | None = None

    @model_validator(mode="after")
    def _one_law(self) -> Self:
        require_one(self, "spring_rate", "spring")
        require_one(self, "damping_coefficient", "damper")
        return self

    @property
    def spring_law(self) -> Spring:
        """Spring law, also for a constant rate."""
        return self.spring if self.spring is not None else Spring(rate=self.spring_rate)

    @property
    def damper_law(self) -> Damper:
        """Damper law, also for a constant coefficient."""
        return (
            self.damper
            if self.damper is not None
            else LinearDamper(coefficient=self.damping_coefficient)
        )


class FullAxle(WheeledAxle):
    """Axle of a full car.

    Attributes
    ----------
    track : float
        Distance between the wheels' contact points, m.
    anti_roll_bar_rate : float
        Force on a wheel per metre of strut deflection relative to the other wheel, N/m.
    roll_centre_height : float
        Height above the road at which the axle's share of a lateral force acts on the body, m.
    """

    track: PositiveLength
    anti_roll_bar_rate: NonNegativeStiffness = 0.0
    roll_centre_height: Length = 0.0


class Vehicle(Rig):
    """Base of all vehicles: a body that heaves and pitches on a front and a rear axle, driven over a road.

    Signs: z up; pitch positive nose down, roll positive right side down (ISO 8855). ``gravity`` in m/s^2.
    """

    schema_: Literal["jounce.vehicle/1"] = Field(default="jounce.vehicle/1", alias="schema")
    gravity: Acceleration = GRAVITY
    corners: ClassVar[tuple[str, ...]] = ("front", "rear")

    @property
    def wheelbase(self) -> float:
        """Distance between the axles, m."""
        front, rear = (getattr(self, axle).distance for axle in ("front", "rear"))
        return float(front + rear)

    @property
    def wheels(self) -> dict[str, Place]:
        """Position of each corner's wheel."""
        return {corner: _place(corner, self.wheelbase) for corner in self.corners}


def track_width(rig: object) -> float:
    """Distance in m between left and right wheels, mean of front and rear axle; 0 for models without separate sides.

    >>> from jounce.parts import load
    >>> track_width(load("audi-a6-full-car")), track_width(load("audi-a6-half-car-4dof"))
    (1.54, 0.0)
    """
    if not isinstance(rig, FullCar | FullCar3D):
        return 0.0
    front, rear = (
        axle.track
        if isinstance(axle, FullAxle)
        else 2.0 * abs(axle.suspension.hardpoints.wheel_centre[1])
        for axle in (rig.front, rig.rear)
    )
    return 0.5 * (front + rear)


def _place(corner: str, wheelbase: float) -> Place:
    side = 1 if corner.endswith("left") else -1 if corner.endswith("right") else 0
    return Place(wheelbase if corner.startswith("rear") else 0.0, side)


class HalfCar(Vehicle):
    """Half car as in paper 2 (eqs 6-11): body that bounces and pitches on massless axles, two wheels each.

    ``compat`` selects how the road acts: ``"physical"`` (the rear axle is delayed by wheelbase over speed, dampers act
    on the road's rate as well), ``"simulink"`` (the well-known demo unchanged: bumps point down, both axles are excited
    at once, dampers act on the body only) or ``"sign-corrected"`` (the demo with bumps up). The sign of the rear moment
    as printed in paper 2, eq. (9), makes pitch unstable and is not available.
    """

    model: Literal["half-car"] = "half-car"
    compat: Compat = "physical"
    body: VehicleBody
    front: Axle
    rear: Axle

    @property
    def wheels(self) -> dict[str, Place]:
        """Position of each corner's wheel; both axles are excited at once except with ``compat="physical"``."""
        wheels = super().wheels
        return wheels if self.compat == "physical" else {corner: Place(0.0, 0) for corner in wheels}


class HalfCar4DOF(Vehicle):
    """Half car with unsprung masses: bounce and pitch of the body, two wheel heights (4 degrees of freedom)."""

    model: Literal["half-car-4dof"] = "half-car-4dof"
    body: VehicleBody
    front: WheeledAxle
    rear: WheeledAxle


class FullCar(Vehicle):
    """Full car: heave, pitch and roll of the body, four wheel heights (7 degrees of freedom), anti-roll bars."""

    model: Literal["full-car"] = "full-car"
    body: RollingBody
    front: FullAxle
    rear: FullAxle
    corners: ClassVar[tuple[str, ...]] = ("front_left", "front_right", "rear_left", "rear_right")


class SpatialBody(RollingBody):
    """Body of a full car on 3-D corners; ``height`` (m) is that of its centre of gravity; its axes are principal axes.

    On a test bench, a spherical joint on a vertical guide may hold the vehicle. ``joint`` (m) is its position: x ahead
    of the centre of gravity, y to the left, z above the road. Otherwise the body rotates about its centre of gravity.
    """

    height: PositiveLength
    joint: Point | None = None


class SpatialAxle(Description):
    """Axle of two mirrored 3-D corners, or a solid axle or twist beam.

    Attributes
    ----------
    distance : float
        Distance of the wheel centres from the body's centre of gravity at design, m. Hardpoints are shifted along x.
    corner : Corner, optional
        The left corner; its ``sprung`` and ``guide`` are ignored. A file may also give the name of a shipped rig or the
        path of a rig file, relative to the vehicle file.
    axle : DependentAxle, optional
        A solid axle or a twist beam instead of corners, with ``bodies`` and ``tyre``; likewise by name or path.
    anti_roll_bar_rate : float
        Force on a wheel per metre of travel relative to the other wheel, N/m. Only for corners without a U- or T-bar,
        which act through their links; a Z-bar, which does not resist roll, may be combined with it.
    """

    distance: PositiveLength
    corner: AnyCorner | None = None
    axle: AnyDependentAxle | None = None
    anti_roll_bar_rate: NonNegativeStiffness = 0.0

    @property
    def suspension(self) -> Corner | DependentAxle:
        """The corner, or the dependent axle."""
        part = self.corner if self.axle is None else self.axle
        assert part is not None
        return part

    @property
    def part(self) -> str:
        """Key of the suspension: ``"corner"`` or ``"axle"``."""
        return "corner" if self.axle is None else "axle"

    @model_validator(mode="after")
    def _is_complete(self) -> Self:
        require_one(self, "corner", "axle")
        if self.corner is not None and self.corner.side != "left":
            raise error_at(
                ("corner", "side"),
                "the corner of a car must be the left one",
                allowed="the left corner; the right one is its mirror image",
            )
        if self.suspension.lacks:
            lacks = ", ".join(self.suspension.lacks)
            raise error_at(
                (self.part,),
                Phrase(
                    "the corner of a car needs all its parts, but this one has no {lacks}",
                    lacks=lacks,
                )
                if self.axle is None
                else Phrase(
                    "the axle of a car needs all its parts, but this one has no {lacks}",
                    lacks=lacks,
                ),
            )
        bar = self.suspension.anti_roll_bar
        if bar is not None and bar.kind != "z" and self.anti_roll_bar_rate > 0.0:
            raise error_at(
                ("anti_roll_bar_rate",),
                "the corner also describes this bar, so its effect would be counted twice"
                if self.axle is None
                else "the axle also describes this bar, so its effect would be counted twice",
                allowed="one of them",
            )
        return self


class FullCar3D(Vehicle):
    """Full car on 3-D corners, solid axles or twist beams: the body heaves, pitches and rolls, without yaw or slip."""

    model: Literal["full-car-3d"] = "full-car-3d"
    body: SpatialBody
    front: SpatialAxle
    rear: SpatialAxle
    corners: ClassVar[tuple[str, ...]] = FullCar.corners


_DYNAMIC_INDEX = 0.7
"""Default roll inertia over that of point masses above the wheels; cars have 0.6 to 0.8 (estimated)."""
_TRACK = 1.5  # m, default: a passenger car


class Side(Description):
    """One side of an axle: the ``wheel``, and its lateral ``distance`` (m) from the body's centre of gravity."""

    distance: PositiveLength
    wheel: QuarterCar | FullAxle | WheeledAxle


class FrontViewAxle(Rig):
    """Body that heaves and rolls on the two wheels of an axle; z up, roll positive right side down (ISO 8855).

    Attributes
    ----------
    gravity : float
        Gravity, m/s^2.
    mass : float
        Mass of the body on this axle, kg.
    roll_inertia : float
        Roll inertia of that body about its centre of gravity, kg m^2.
    anti_roll_bar_rate : float
        Force on a wheel per metre of travel relative to the other wheel, N/m.
    left, right : Side
        The wheels.
    """

    schema_: Literal["jounce.rig/1"] = Field(default="jounce.rig/1", alias="schema")
    model: Literal["front-view-axle"] = "front-view-axle"
    has_file: ClassVar[bool] = False
    gravity: Acceleration = GRAVITY
    mass: Mass
    roll_inertia: MomentOfInertia
    anti_roll_bar_rate: NonNegativeStiffness = 0.0
    left: Side
    right: Side


def axle_of(
    vehicle: Vehicle,
    axle: Literal["front", "rear"],
    *,
    track: float | None = None,
    roll_inertia: float | None = None,
) -> FrontViewAxle:
    """Return one axle of a vehicle with its share of the body.

    Parameters
    ----------
    vehicle : FullCar or HalfCar4DOF
        A vehicle whose wheels have tyres.
    axle : {"front", "rear"}
        The axle to extract.
    track : float, optional
        Distance between the wheels, m. By default that of a full car, or 1.5 m for a half car (estimated).
    roll_inertia : float, optional
        Roll inertia of the body's share, kg m^2. By default the share of a full car's, estimated for a half car.

    Returns
    -------
    FrontViewAxle
        The axle; ``estimated`` lists the assumed values.

    Raises
    ------
    DescriptionError
        For a vehicle without tyres, a 3-D vehicle, or an unknown axle.

    Examples
    --------
    >>> from jounce.parts import load
    >>> axle = axle_of(load("audi-a6-full-car"), "front")
    >>> round(axle.mass, 1), axle.left.distance   # kg, m
    (910.8, 0.77)
    """
    if axle not in ("front", "rear"):
        raise unknown(axle, ("front", "rear"), what="axle", where="axle")
    if not isinstance(vehicle, (FullCar, HalfCar4DOF)):
        raise DescriptionError(
            "a tester needs a lumped axle with wheels on tyres",
            where="vehicle",
            found=getattr(vehicle, "model", type(vehicle).__name__),
            allowed="full-car, half-car-4dof; or a quarter car or a 3-D corner",
            hint="A half car without unsprung masses has no tyres; for a 3-D car, test one of its corners.",
        )
    own = vehicle.front if axle == "front" else vehicle.rear
    other = vehicle.rear if axle == "front" else vehicle.front
    share = other.distance / vehicle.wheelbase
    full = isinstance(vehicle, FullCar)
    mass = share * vehicle.body.mass
    width = track or (own.track if isinstance(own, FullAxle) else _TRACK)
    inertia = roll_inertia or (
        share * vehicle.body.roll_inertia if isinstance(vehicle, FullCar) else None
    )
    side = Side(distance=0.5 * width, wheel=own)
    return FrontViewAxle(
        source=vehicle.source,
        estimated=() if full else ("left.distance", "right.distance", "roll_inertia"),
        gravity=vehicle.gravity,
        mass=mass,
        roll_inertia=inertia or _DYNAMIC_INDEX * mass * (0.5 * width) ** 2,
        anti_roll_bar_rate=own.anti_roll_bar_rate if isinstance(own, FullAxle) else 0.0,
        left=side,
        right=side,
    )


def axle_from(
    left: QuarterCar, right: QuarterCar, *, track: float = _TRACK, roll_inertia: float | None = None
) -> FrontViewAxle:
    """Combine two quarter cars into an axle with a rigid body between them.

    Parameters
    ----------
    left, right : QuarterCar
        The two wheels. Their sprung masses become one body; each wheel still carries its own share.
    track : float
        Distance between the wheels, m.
    roll_inertia : float, optional
        Roll inertia, kg m^2. By default 0.7 of the inertia at which the two sides are uncoupled (estimated).

    Returns
    -------
    FrontViewAxle
        The axle.

    Examples
    --------
    >>> from jounce.parts import load
    >>> wheel = load("audi-a6-quarter-car")
    >>> axle_from(wheel, wheel).mass == 2.0 * wheel.sprung.mass
    True
    """
    masses = left.sprung.mass, right.sprung.mass
    total = sum(masses)
    return FrontViewAxle(
        source=left.source,
        estimated=() if roll_inertia else ("roll_inertia",),
        gravity=left.gravity,
        mass=total,
        roll_inertia=roll_inertia or _DYNAMIC_INDEX * track**2 * masses[0] * masses[1] / total,
        left=Side(distance=track * masses[1] / total, wheel=left),
        right=Side(distance=track * masses[0] / total, wheel=right),
    )
