"""Values within a formula, and their units as powers of base units."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.units import BaseUnit, in_base_units
from jounce.recordings.schema import QUANTITIES

Powers = tuple[tuple[str, float], ...]
PLAIN: Powers = ()
ANGLE: Powers = (("rad", 1.0),)
SECOND: Powers = (("s", 1.0),)
HERTZ: Powers = (("s", -1.0),)


@dataclass(frozen=True)
class Signal:
    """A value within a formula: samples (n,) or a number in SI, powers of its base units, and the text it is of.

    A zero (``is_zero``) fits every unit.
    """

    values: Any
    powers: Powers
    text: str
    is_zero: bool = False

    @property
    def is_number(self) -> bool:
        """Whether it is the same at all times."""
        return np.ndim(self.values) == 0


def alike(left: Signal, right: Signal, symbol: str) -> tuple[Signal, Signal]:
    """Return two values of the same unit, or refuse them; a zero has any unit."""
    if left.is_zero and left.is_number:
        left = replace(left, powers=right.powers)
    if right.is_zero and right.is_number:
        right = replace(right, powers=left.powers)
    if not fit(left.powers, right.powers):
        angle = {left.powers, right.powers} == {PLAIN, ANGLE}
        raise DescriptionError(
            "units do not fit",
            where=f"{left.text} {symbol} {right.text}",
            found=f"{unit_name(left.powers)} and {unit_name(right.powers)}",
            allowed="two values of the same unit",
            hint="Give the angle its unit in quotes: '1 deg' or '1 rad'."
            if angle
            else "Write a number with its unit in quotes: '3 mm'.",
        )
    return left, replace(right, powers=left.powers)


def powers_of(base: BaseUnit) -> Powers:
    """Return the powers of the base units of a unit."""
    return tuple(sorted(base.powers.items()))


def multiplied(left: Powers, right: Powers, sign: float = 1.0) -> Powers:
    """Return the powers of a product, or with ``sign`` -1 of a quotient."""
    powers = dict(left)
    for name, power in right:
        powers[name] = round(powers.get(name, 0.0) + sign * power, 9)
    return tuple(sorted((name, power) for name, power in powers.items() if power))


def fit(left: Powers, right: Powers) -> bool:
    """Whether units are alike; an angle is left out of products with others, but is no plain number itself."""
    plain = without_angle(left)
    return left == right or (plain != PLAIN and plain == without_angle(right))


def without_angle(powers: Powers) -> Powers:
    """Return powers without that of angles."""
    return tuple((name, power) for name, power in powers if name != "rad")


def unit_name(powers: Powers) -> str:
    """Write a unit: a usual one if it has a name, otherwise by base units."""
    for wanted in (powers, without_angle(powers) or powers):  # an angle times a speed is a speed
        for unit in _USUAL:
            if wanted == powers_of(in_base_units(unit)):
                return unit
    above = [_raised(name, power) for name, power in powers if power > 0.0]
    below = [_raised(name, -power) for name, power in powers if power < 0.0]
    return "/".join(["*".join(above) or "1", *below])


def _raised(name: str, power: float) -> str:
    return (
        name
        if power == 1.0
        else f"{name}^{power:g}"
        if power == int(power)
        else f"{name}^({power:g})"
    )


_USUAL = tuple(
    dict.fromkeys(
        [unit for unit, _ in QUANTITIES.values() if unit not in ("Hz", "J")]
        + ["N/m", "N*s/m", "N/s", "kg", "kg*m^2", "N/m^3", "rad/m", "1/m", "1/s"]
    )
)
"""Units that have a usual name; torque has that of N*m, not J."""
