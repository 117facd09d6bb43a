"""Translation and rotation: the same laws with different words and units."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal

MotionName = Literal["translation", "rotation"]
Quantity = Literal[
    "displacement", "velocity", "acceleration", "angle", "angular_velocity", "angular_acceleration"
]  # fmt: skip


@dataclass(frozen=True)
class MeasuredMotion:
    """Terms of a motion: its quantities from the deflection to its second derivative, and their units (SI).

    ``..._word`` are the names of the quantities, ``pushed`` and ``pulled`` the two directions of a deflection. A
    deflection times ``factor`` has the display unit ``shown``.
    """

    name: MotionName
    quantities: tuple[Quantity, Quantity, Quantity]
    units: tuple[str, str, str]
    inertia_word: str
    inertia: str
    deflection_word: str
    force_word: str
    force: str
    stiffness: str
    damping: str
    drag: str
    pushed: str
    pulled: str
    factor: float
    shown: str

    @property
    def deflection(self) -> str:
        """Unit of a deflection (SI)."""
        return self.units[0]

    def say(self, deflection: float, digits: int = 3) -> str:
        """Format a deflection (SI) in its display unit.

        >>> TRANSLATION.say(0.0123), ROTATION.say(0.1)
        ('12.3 mm', '5.73 deg')
        """
        return f"{self.factor * deflection:.{digits}g} {self.shown}"


def unit_in_words(unit: str) -> str:
    """Format a unit for use in sentences.

    >>> unit_in_words("N*m*s/rad")
    'N m s/rad'
    """
    return unit.replace("*", " ")


TRANSLATION = MeasuredMotion(
    "translation", ("displacement", "velocity", "acceleration"), ("m", "m/s", "m/s^2"),
    "mass", "kg", "deflection", "force", "N", "N/m", "N*s/m", "N*s^2/m^2", "compression", "tension", 1e3, "mm",
)  # fmt: skip
ROTATION = MeasuredMotion(
    "rotation", ("angle", "angular_velocity", "angular_acceleration"), ("rad", "rad/s", "rad/s^2"),
    "inertia", "kg*m^2", "angle", "torque", "N*m", "N*m/rad", "N*m*s/rad", "N*m*s^2/rad^2",
    "one direction", "the other", math.degrees(1.0), "deg",
)  # fmt: skip
MOTIONS: dict[MotionName, MeasuredMotion] = {one.name: one for one in (TRANSLATION, ROTATION)}
QUANTITIES: tuple[Quantity, ...] = (*TRANSLATION.quantities, *ROTATION.quantities)
QUANTITY_OF_UNIT: dict[str, Quantity] = {
    unit: quantity
    for motion in MOTIONS.values()
    for unit, quantity in zip(motion.units, motion.quantities, strict=True)
}


def in_motion(name: str) -> Callable[[Any], str]:
    """Return a function that looks up a unit or word of a result's ``motion``, such as its unit of ``stiffness``."""

    def look_up(result: Any) -> str:
        value: str = getattr(MOTIONS[result.motion], name)
        return value

    return look_up


def motion_of(quantity: Quantity) -> MeasuredMotion:
    """Return the motion that a quantity belongs to.

    >>> motion_of("angle").name
    'rotation'
    """
    return TRANSLATION if quantity in TRANSLATION.quantities else ROTATION


def order_of(quantity: Quantity) -> int:
    """Return the order of the time derivative of the deflection: 0, 1 or 2.

    >>> order_of("angular_velocity")
    1
    """
    return motion_of(quantity).quantities.index(quantity)
