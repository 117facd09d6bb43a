"""One axle seen from the front: a body that heaves and rolls on two wheels, as it stands on a tester."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from jounce.core.constants import GRAVITY
from jounce.core.description import Description
from jounce.core.errors import DescriptionError, unknown
from jounce.core.units import Acceleration, Mass, MomentOfInertia, NonNegativeStiffness, PositiveLength
from jounce.parts.rig import Rig
from jounce.parts.rigs import QuarterCar
from jounce.parts.vehicles import FullAxle, FullCar, HalfCar4DOF, Vehicle, WheeledAxle

_DYNAMIC_INDEX = 0.7
"""Roll inertia over that of masses standing over the wheels, where none is given: cars have 0.6 to 0.8 (estimated)."""
_TRACK = 1.5


class Side(Description):
    """Wheel of one side: ``distance`` (m) from the body's centre of gravity to the left or right, and what is there."""

    distance: PositiveLength
    wheel: QuarterCar | FullAxle | WheeledAxle


class FrontViewAxle(Rig):
    """Body that heaves and rolls on the two wheels of an axle; z up, roll positive right side down (ISO 8855).

    Attributes
    ----------
    gravity : float
        m/s^2.
    mass : float
        Of the body that this axle carries, kg.
    roll_inertia : float
        Of that body about its centre of gravity, kg m^2.
    anti_roll_bar_rate : float
        Force on a wheel for each metre by which it travels further than the other one, N/m.
    left, right : Side
        The wheels.
    """

    schema_: Literal["jounce.rig/1"] = Field(default="jounce.rig/1", alias="schema")
    model: Literal["front-view-axle"] = "front-view-axle"
    gravity: Acceleration = GRAVITY
    mass: Mass
    roll_inertia: MomentOfInertia
    anti_roll_bar_rate: NonNegativeStiffness = 0.0
    left: Side
    right: Side


def axle_of(
    vehicle: Vehicle, axle: Literal["front", "rear"], *, track: float | None = None, roll_inertia: float | None = None
) -> FrontViewAxle:
    """Give one axle of a vehicle with the share of the body that stands on it.

    Parameters
    ----------
    vehicle : FullCar or HalfCar4DOF
        A vehicle whose wheels have tyres.
    axle : {"front", "rear"}
        Which one.
    track : float, optional
        Distance of the wheels, m; a full car's own, 1.5 m for a half car (estimated).
    roll_inertia : float, optional
        Of the body's share, kg m^2; a full car's share, estimated for a half car.

    Returns
    -------
    FrontViewAxle
        With ``estimated`` naming what was assumed.

    Raises
    ------
    DescriptionError
        For a vehicle without tyres, a 3-D one, or an unknown axle.

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
            "an axle on a tester needs wheels on tyres, and lumped",
            where="vehicle",
            found=getattr(vehicle, "model", type(vehicle).__name__),
            allowed="full-car, half-car-4dof; or a quarter car or a 3-D corner",
            hint="A massless half car has no tyres; of a 3-D car test one of its corners.",
        )
    own = vehicle.front if axle == "front" else vehicle.rear
    other = vehicle.rear if axle == "front" else vehicle.front
    share = other.distance / vehicle.wheelbase
    full = isinstance(vehicle, FullCar)
    mass = share * vehicle.body.mass
    width = track or (own.track if isinstance(own, FullAxle) else _TRACK)
    inertia = roll_inertia or (share * vehicle.body.roll_inertia if isinstance(vehicle, FullCar) else None)
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
    """Give the axle of two quarter cars with a rigid body between them.

    Parameters
    ----------
    left, right : QuarterCar
        Their sprung masses become one body, placed so that each still stands on its wheel.
    track : float
        Distance of the wheels, m.
    roll_inertia : float, optional
        kg m^2; by default 0.7 of the inertia with which the sides would not feel each other (estimated).

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
