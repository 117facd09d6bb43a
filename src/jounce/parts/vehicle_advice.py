"""What is legal in a vehicle and yet looks wrong: findings with the number behind each."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from jounce.core.findings import Finding
from jounce.parts.curves import VelocityTable
from jounce.parts.vehicles import Axle, FullAxle, FullCar, FullCar3D, HalfCar, HalfCar4DOF, WheeledAxle

AnyVehicle = HalfCar | HalfCar4DOF | FullCar | FullCar3D

LONGEST = 6.0
"""m; no axle lies that far from the centre of gravity, nothing of a car is that wide or high."""
INDICES = (0.4, 2.0)
"""Dynamic indices (pitch inertia over mass and both distances, 1) that road vehicles have."""
FREQUENCIES = (0.6, 6.0)
"""Hz, of the body over one axle: from the softest coach to a race car."""
RATIOS = (0.05, 1.5)
"""Damping ratios (1) of the body over one axle."""


def vehicle_findings(car: AnyVehicle) -> list[Finding]:
    """List what a careful colleague would ask about a vehicle; values in SI.

    Parameters
    ----------
    car : Vehicle
        Any vehicle; the corners of a 3-D car are examined as rigs.

    Examples
    --------
    >>> from jounce.parts import load
    >>> car = load("audi-a6-half-car")
    >>> vehicle_findings(car)
    []
    >>> [found.place for found in vehicle_findings(car.with_changes({"front.spring_rate": "28 N/m"}))]
    ['front.spring_rate']
    """
    sizes = list(_sizes(car))
    return sizes or [found for check in (_index, _axles, _roll_centres) for found in check(car)]


def _warn(place: str, message: str, value: float) -> Finding:
    return Finding(place, "warning", message, float(value))


def _axles_of(car: AnyVehicle) -> dict[str, Axle | WheeledAxle]:
    """Axles that hold their own springs, by name; none of a 3-D car."""
    named = {name: getattr(car, name) for name in ("front", "rear")}
    return {name: axle for name, axle in named.items() if isinstance(axle, Axle | WheeledAxle)}


def _sizes(car: AnyVehicle) -> Iterator[Finding]:
    lengths = {path: value for path, value in car.parameters().items() if path.count(".") == 1}
    for path, value in lengths.items():
        if path.endswith((".distance", ".track", ".height", ".roll_centre_height")) and abs(value) > LONGEST:
            yield _warn(
                path, f'{value:g} m: millimetres given as metres? A bare number is in m; write "1290 mm".', value
            )


def _index(car: AnyVehicle) -> Iterator[Finding]:
    body = car.body
    index = body.pitch_inertia / (body.mass * car.front.distance * car.rear.distance)
    if not INDICES[0] <= index <= INDICES[1]:
        text = (
            f"the dynamic index, inertia over mass and both distances, is {index:.3g}; road vehicles have about 0.7 "
            "to 1.1. Is the inertia that of the body about its centre of gravity?"
        )
        yield _warn("body.pitch_inertia", text, index)


def _carried(car: AnyVehicle) -> dict[str, float]:
    """Mass of the body that one wheel carries, kg."""
    return {
        name: 0.5 * car.body.mass * getattr(car, other).distance / car.wheelbase
        for name, other in (("front", "rear"), ("rear", "front"))
    }


def _axles(car: AnyVehicle) -> Iterator[Finding]:
    carried = _carried(car)
    for name, axle in _axles_of(car).items():
        mass = carried[name]
        if axle.spring_rate is not None:
            yield from _frequency(name, axle, mass, axle.spring_rate)
        if isinstance(axle, WheeledAxle):
            yield from _wheel(name, axle, mass, car.gravity)


def _frequency(name: str, axle: Axle | WheeledAxle, mass: float, rate: float) -> Iterator[Finding]:
    angular = float(np.sqrt(rate / mass))
    frequency = angular / (2.0 * np.pi)
    if not FREQUENCIES[0] <= frequency <= FREQUENCIES[1]:
        text = (
            f"the body over this axle would swing at {frequency:.3g} Hz, {mass:.4g} kg on {rate:.4g} N/m; cars have 1 "
            "to 2 Hz, race cars up to 5 Hz. The rate is that of one wheel; is its unit right?"
        )
        yield _warn(f"{name}.spring_rate", text, frequency)
    elif axle.damping_coefficient:
        ratio = axle.damping_coefficient / (2.0 * mass * angular)
        if not RATIOS[0] <= ratio <= RATIOS[1]:
            text = (
                f"the body over this axle would have the damping ratio {ratio:.3g}; cars have 0.2 to 0.5. "
                "The coefficient is that of one wheel; is its unit right?"
            )
            yield _warn(f"{name}.damping_coefficient", text, ratio)


def _wheel(name: str, axle: WheeledAxle, mass: float, gravity: float) -> Iterator[Finding]:
    if axle.unsprung_mass > 0.5 * mass:
        text = (
            f"{axle.unsprung_mass:g} kg is more than half of the {mass:.4g} kg that the wheel carries; "
            "the mass is that of one wheel."
        )
        yield _warn(f"{name}.unsprung_mass", text, axle.unsprung_mass)
    if axle.spring_rate is not None:
        rest = mass * gravity / axle.spring_rate
        closed = (
            f"the stop is closed at rest, where the deflection from undeformed springs is about {1e3 * rest:.4g} mm."
        )
        if axle.bump_stop is not None and axle.bump_stop.gap < rest:
            yield _warn(f"{name}.bump_stop.gap", closed, axle.bump_stop.gap)
        if axle.rebound_stop is not None and -axle.rebound_stop.gap > rest:
            yield _warn(f"{name}.rebound_stop.gap", closed, axle.rebound_stop.gap)
    damper = axle.damper
    if isinstance(damper, VelocityTable):
        for velocity, force in zip(damper.velocity, damper.force, strict=True):
            if velocity * force < 0.0:
                text = (
                    f"{force:g} N at {velocity:g} m/s drives the motion, it does not damp it; compression is positive."
                )
                yield _warn(f"{name}.damper.force", text, force)
                return


def _roll_centres(car: AnyVehicle) -> Iterator[Finding]:
    for name, axle in _axles_of(car).items():
        if isinstance(axle, FullAxle) and car.body.height is not None and axle.roll_centre_height > car.body.height:
            text = (
                f"{axle.roll_centre_height:g} m lies above the centre of gravity, {car.body.height:g} m: "
                "over it the body leans into the turn."
            )
            yield _warn(f"{name}.roll_centre_height", text, axle.roll_centre_height)
