"""How SI values are shown to people: display units, labels, numbers and estimates with sensible digits."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.display import DisplayUnit as DisplayUnit  # noqa: PLC0414 - offered by the package, too
from jounce.core.display import display_unit as display_unit  # noqa: PLC0414
from jounce.core.display import shown_as
from jounce.core.types import Array
from jounce.recordings.schema import QUANTITIES, quantity_of

if TYPE_CHECKING:
    from jounce.identify.estimate import Estimate
    from jounce.identify.update import UpdatedParameter


SMALLEST = {"rad": 1e-5, "rad/m": 1e-4, "m": 1e-6}
"""Below these (SI) is what rounding leaves of nothing, as far as people who build suspensions are concerned."""
PARALLEL = 1e2
"""Arms whose instant centre or swing arm is farther away than this (m) are parallel."""
FAR_AWAY = ("instant_centre", "swing_arm")


def settled(values: Array, si: str) -> Array:
    """Values (n,) of an SI unit, 0 where only rounding is left, and all alike where they differ by rounding only."""
    least = SMALLEST.get(si, 0.0)
    found = np.where(np.abs(values) < least, 0.0, values)
    known = found[np.isfinite(found)]
    if known.size and np.ptp(known) <= max(1e-9 * float(np.max(np.abs(known))), least):
        return np.where(np.isfinite(found), float(np.mean(known)), np.nan)
    return found


def kinematic_value(name: str, value: float, si: str) -> float | str | None:
    """Give a kinematic quantity in its display unit; ``parallel`` where its arms meet nowhere, None where unknown.

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


def words_of(name: str) -> str:
    """Give the quantity of a channel in words without its place, e.g. ``acceleration`` for ``sprung.az``."""
    quantity = quantity_of(name)
    words = QUANTITIES[quantity][1] if quantity else name.rpartition(".")[2].replace("_", " ")
    return words.removeprefix("vertical ")


def number(value: float | None, digits: int = 4) -> str:
    """Write a number with significant digits, without an exponent where people read it more easily so.

    Parameters
    ----------
    value : float or None
        In the unit of the caller (any; 1 for a plain number); None and NaN become an en dash.
    digits : int
        Significant digits.

    Returns
    -------
    str
        With a true minus sign.

    Examples
    --------
    >>> number(22730.4), number(0.00012345), number(-1.5), number(None), number(1234567.0)
    ('22730', '1.234e−4', '−1.500', '–', '1.235e6')
    """
    if value is None or math.isnan(value):
        return "–"
    if math.isinf(value):
        return "∞" if value > 0 else "−∞"
    if value == 0.0:
        return "0"
    rounded = float(f"{value:.{digits - 1}e}")
    exponent = math.floor(math.log10(abs(rounded)))
    if not -4 < exponent < 6:
        mantissa, _, power = f"{value:.{digits - 1}e}".partition("e")
        return f"{mantissa}e{int(power)}".replace("-", "−")
    return f"{value:.{max(0, digits - 1 - exponent)}f}".replace("-", "−")


def quantity(value: float | None, si: str, digits: int = 4) -> str:
    """Write an SI value in its display unit with the unit behind it, e.g. ``22.73 N/mm``.

    Parameters
    ----------
    value : float or None
        In the SI unit ``si``.
    si : str
        SI unit as written in recordings.
    digits : int
        Significant digits.

    Returns
    -------
    str
        An en dash where there is no value.

    Examples
    --------
    >>> quantity(22730.0, "N/m"), quantity(0.11, "1", 2)
    ('22.73 N/mm', '0.11')
    """
    if value is None or math.isnan(value):
        return "–"
    unit = display_unit(si, value)
    return unit.behind(number(value * unit.factor, digits))


def digits_for(value: float, error: float | None, most: int = 7, default: int = 4) -> int:
    """Significant digits of a value so that its error shows two; both in the same unit."""
    if error is None or not error > 0.0 or not math.isfinite(error) or value == 0.0:
        return default
    return max(2, min(most, math.floor(math.log10(abs(value))) - math.floor(math.log10(error)) + 2))


def estimate_cells(found: Estimate | UpdatedParameter | None, si: str) -> tuple[str, str, str, str]:
    """Value, standard error, 95 % interval and unit of an estimate in the SI unit ``si``, as table cells.

    Examples
    --------
    >>> from jounce.identify.estimate import Estimate
    >>> estimate_cells(Estimate(22731.4, 12.3, (22705.0, 22757.0)), "N/m")
    ('22.731', '0.012', '22.705 to 22.757', 'N/mm')
    """
    if found is None:
        return "–", "–", "–", display_unit(si).name
    unit = display_unit(si, found.value)
    value = found.value * unit.factor
    error = None if found.standard_error is None else found.standard_error * unit.factor
    digits = digits_for(value, error)
    interval = "–"
    if found.interval is not None:
        low, high = (end * unit.factor for end in found.interval)
        width = (high - low) / 4.0
        interval = f"{number(low, digits_for(low, width))} to {number(high, digits_for(high, width))}"
    return number(value, digits), number(error, 2), interval, unit.name


def estimate_text(found: Estimate | UpdatedParameter | None, si: str) -> str:
    """Write an estimate in a sentence: ``22.731 N/mm (95 %: 22.705 to 22.757)``; ``si`` is its SI unit."""
    if found is None:
        return "–"
    value, _, interval, unit = estimate_cells(found, si)
    return f"{value} {unit}".strip() + (f" (95 %: {interval})" if interval != "–" else "")


def percent(share: float | None, digits: int = 1) -> str:
    """Write a ratio [1] as percentage with decimals, e.g. ``−3.1 %``.

    Examples
    --------
    >>> percent(-0.031), percent(None), percent(-1e-9)
    ('−3.1 %', '–', '0.0 %')
    """
    if share is None or share != share:  # noqa: PLR0124 - not a number
        return "–"
    text = f"{100.0 * share:.{digits}f} %"
    return text[1:] if text.startswith("-") and not text.strip("-0. %") else text.replace("-", "−")


def given(value: float | None, si: str, words: str = "") -> str:
    """Write a setting as the campaign gave it, in its display unit and without padding zeros; ``si`` is its SI unit.

    What it is, in ``words``, matters for speeds, as :func:`jounce.core.display.shown_as` has them.

    Examples
    --------
    >>> given(310000.0, "Pa"), given(0.4537856, "rad"), given(1.95, "m/s"), given(None, "m")
    ('0.31 MPa', '26°', '1.95 m/s', '–')
    """
    if value is None:
        return "–"
    unit = shown_as(si, words) if words else display_unit(si, value)
    return unit.behind(f"{value * unit.factor:.5g}".replace("-", "−"))


def milliseconds(time: float, decimals: int = 1) -> str:
    """Write a time in s as milliseconds with so many decimals and no sign before zero, without the unit."""
    return f"{round(1e3 * time, decimals) + 0.0:.{decimals}f}".replace("-", "−")


def correlation(value: float) -> str:
    """Write a correlation [1] with its sign and two decimals, a vanishing one as ``0.00``."""
    text = f"{value:+.2f}"
    return "0.00" if text[1:] == "0.00" else text.replace("-", "−")
