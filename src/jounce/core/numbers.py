"""Format numbers, quantities and estimates for people: with sensible digits, in the current system of units."""

from __future__ import annotations

import math
from typing import Protocol

from jounce.core.display import DisplayUnit, display_unit


class Estimated(Protocol):
    """Protocol of a number with its uncertainty: an estimate, or a parameter of an update."""

    @property
    def value(self) -> float:
        """The number."""

    @property
    def standard_error(self) -> float | None:
        """Its standard error, in the same unit."""

    @property
    def interval(self) -> tuple[float, float] | None:
        """Its 95 % interval, in the same unit."""


def number(value: float | None, digits: int = 4) -> str:
    """Write a number with significant digits, without an exponent if it is readable without one.

    Parameters
    ----------
    value : float or None
        In the unit of the caller (any; 1 for a plain number); None and NaN become an en dash.
    digits : int
        Significant digits.

    Returns
    -------
    str
        The number, with a true minus sign.

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
    """Write an SI value in its display unit with the unit, e.g. ``22.73 N/mm``.

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
        The value with its unit; an en dash for None.

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
    """Number of significant digits of a value at which its error has two; both in the same unit."""
    if error is None or not error > 0.0 or not math.isfinite(error) or value == 0.0:
        return default
    return max(2, min(most, math.floor(math.log10(abs(value))) - math.floor(math.log10(error)) + 2))


def estimate_cells(
    estimate: Estimated | None, si: str, shown: DisplayUnit | None = None
) -> tuple[str, str, str, str]:
    """Value, standard error, 95 % interval and unit of an estimate in the SI unit ``si``, as table cells.

    ``shown`` is the display unit, by default the usual one for its size.

    Examples
    --------
    >>> from jounce.identify.estimate import Estimate
    >>> estimate_cells(Estimate(22731.4, 12.3, (22705.0, 22757.0)), "N/m")
    ('22.731', '0.012', '22.705 to 22.757', 'N/mm')
    """
    if estimate is None:
        return "–", "–", "–", display_unit(si).name
    unit = shown or display_unit(si, estimate.value)
    value = estimate.value * unit.factor
    error = None if estimate.standard_error is None else estimate.standard_error * unit.factor
    digits = digits_for(value, error)
    interval = "–"
    if estimate.interval is not None:
        low, high = (end * unit.factor for end in estimate.interval)
        width = (high - low) / 4.0
        interval = (
            f"{number(low, digits_for(low, width))} to {number(high, digits_for(high, width))}"
        )
    return number(value, digits), number(error, 2), interval, unit.name


def estimate_text(estimate: Estimated | None, si: str) -> str:
    """Write an estimate in a sentence: ``22.731 N/mm (95 %: 22.705 to 22.757)``; ``si`` is its SI unit."""
    if estimate is None:
        return "–"
    value, _, interval, unit = estimate_cells(estimate, si)
    return f"{value} {unit}".strip() + (f" (95 %: {interval})" if interval != "–" else "")


def with_half(estimate: Estimated, factor: float = 1.0) -> str:
    """Write an estimate times a factor, with half the width of its interval: ``5.44 ± 0.03``."""
    if estimate.interval is None:
        return number(estimate.value * factor)
    half = 0.5 * (estimate.interval[1] - estimate.interval[0]) * factor
    value = estimate.value * factor
    return f"{number(value, digits_for(value, half))} ± {number(half, 2)}"


def percent(share: float | None, digits: int = 1) -> str:
    """Write a ratio [1] as a percentage with ``digits`` decimals, e.g. ``−3.1 %``.

    Examples
    --------
    >>> percent(-0.031), percent(None), percent(-1e-9)
    ('−3.1 %', '–', '0.0 %')
    """
    if share is None or share != share:  # noqa: PLR0124 - not a number
        return "–"
    text = f"{100.0 * share:.{digits}f} %"
    return text[1:] if text.startswith("-") and not text.strip("-0. %") else text.replace("-", "−")
