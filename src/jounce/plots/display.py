"""Format SI values for people: display units, labels, numbers and estimates with sensible digits."""

from __future__ import annotations

import math
import re

import numpy as np

from jounce.core.display import DisplayUnit as DisplayUnit  # noqa: PLC0414 - re-exported by the package
from jounce.core.display import display_unit as display_unit  # noqa: PLC0414
from jounce.core.display import display_unit_for
from jounce.core.numbers import digits_for as digits_for  # noqa: PLC0414
from jounce.core.numbers import estimate_cells as estimate_cells  # noqa: PLC0414
from jounce.core.numbers import estimate_text as estimate_text  # noqa: PLC0414
from jounce.core.numbers import number as number  # noqa: PLC0414
from jounce.core.numbers import percent as percent  # noqa: PLC0414
from jounce.core.numbers import quantity as quantity  # noqa: PLC0414
from jounce.core.numbers import with_half as with_half  # noqa: PLC0414
from jounce.core.types import Array
from jounce.recordings.schema import QUANTITIES, quantity_of

SMALLEST = {"rad": 1e-5, "rad/m": 1e-4, "m": 1e-6}
"""Magnitudes (SI) below which a value is negligible for people who build suspensions."""
PARALLEL = 1e2
"""Distance (m) of an instant centre, or length of a swing arm, above which arms count as parallel."""
FAR_AWAY = ("instant_centre", "swing_arm")


def settle(values: Array, si: str) -> Array:
    """Return values (n,) of an SI unit with rounding residues set to 0, and equal if they differ by rounding only."""
    least = SMALLEST.get(si, 0.0)
    rounded = np.where(np.abs(values) < least, 0.0, values)
    known = rounded[np.isfinite(rounded)]
    if known.size and np.ptp(known) <= max(1e-9 * float(np.max(np.abs(known))), least):
        return np.where(np.isfinite(rounded), float(np.mean(known)), np.nan)
    return rounded


def kinematic_value(name: str, value: float, si: str) -> float | str | None:
    """Return a kinematic quantity in its display unit; ``parallel`` if the arms do not intersect, None if unknown.

    Examples
    --------
    >>> kinematic_value("camber", -1.4e-6, "rad"), kinematic_value("front_view_swing_arm_length", 3.1e6, "m")
    (0.0, 'parallel')
    """
    if any(word in name for word in FAR_AWAY) and si == "m" and not abs(value) < PARALLEL:
        return "parallel" if not math.isnan(value) else None
    if not math.isfinite(value):
        return None
    return 0.0 if abs(value) < SMALLEST.get(si, 0.0) else value * display_unit(si, value).factor


_ROUNDING = 1e-12
"""Magnitude (SI) below which values are rounding residues."""


def settle_number(value: float | None, si: str, unit: DisplayUnit) -> str:
    """Write an SI value in a unit; a rounding residue is written as zero.

    >>> settle_number(3e-17, "rad", DisplayUnit("°", 57.3)), settle_number(0.01, "m", DisplayUnit("mm", 1e3))
    ('0', '10.00')
    """
    if value is not None and abs(value) < SMALLEST.get(si, _ROUNDING):
        return number(0.0)
    return number(None if value is None else value * unit.factor)


def words_of(name: str) -> str:
    """Return the quantity of a channel in words without its place, e.g. ``acceleration`` for ``sprung.az``."""
    quantity = quantity_of(name)
    words = QUANTITIES[quantity][1] if quantity else name.rpartition(".")[2].replace("_", " ")
    return words.removeprefix("vertical ")


def ratio_unit(above: str, below: str) -> str:
    """Write the unit of a ratio of two display units.

    >>> ratio_unit("m/s²", "mm"), ratio_unit("m/s²", "m/s²"), ratio_unit("N", "m/s²")
    ('(m/s²)/mm', '–', 'N/(m/s²)')
    """
    if above == below:
        return "–"
    first, second = (f"({unit})" if "/" in unit else unit or "1" for unit in (above, below))
    return f"{first}/{second}"


def setting_text(value: float | None, si: str, words: str = "") -> str:
    """Write a setting as the campaign gave it, in its display unit and without padding zeros; ``si`` is its SI unit.

    ``words`` names the quantity, which matters for speeds: see :func:`jounce.core.display.display_unit_for`.

    Examples
    --------
    >>> setting_text(310000.0, "Pa"), setting_text(0.4537856, "rad"), setting_text(1.95, "m/s"), setting_text(None, "m")
    ('0.31 MPa', '26°', '1.95 m/s', '–')
    """
    if value is None:
        return "–"
    unit = display_unit_for(si, words) if words else display_unit(si, value)
    return unit.behind(f"{value * unit.factor:.5g}".replace("-", "−"))


def milliseconds(time: float, decimals: int = 1) -> str:
    """Write a time in s as milliseconds with ``decimals``, without the unit and without a sign before zero."""
    return f"{round(1e3 * time, decimals) + 0.0:.{decimals}f}".replace("-", "−")


def correlation(value: float) -> str:
    """Write a correlation [1] with its sign and two decimals; zero is ``0.00``."""
    text = f"{value:+.2f}"
    return "0.00" if text[1:] == "0.00" else text.replace("-", "−")


_EXPONENT = re.compile(r"(?<![\w.])((?:\w+[*/·])*(?:km|mm|m|s|N|rad))\^([23])(?!\d)")


def raise_exponents(text: str) -> str:
    """Write the units in a sentence with superscript exponents, as in labels.

    >>> raise_exponents("256e-6 m^3, above 0.5 m/s^2"), raise_exponents("x^2 in a law")
    ('256e-6 m³, above 0.5 m/s²', 'x^2 in a law')
    """
    return _EXPONENT.sub(lambda match: match[1] + "²³"[int(match[2]) - 2], text)
