"""Estimates as text: as many digits as their uncertainty leaves."""

from __future__ import annotations

from typing import Protocol

from jounce.plots.display import digits_for, display_unit, number, quantity


class Uncertain(Protocol):
    """A value with its standard error and 95 % interval, None where the data cannot tell; one SI unit for all."""

    @property
    def value(self) -> float:
        """The estimate, in its SI unit."""

    @property
    def standard_error(self) -> float | None:
        """Its standard deviation, same unit."""

    @property
    def interval(self) -> tuple[float, float] | None:
        """Ends of the 95 % interval, same unit."""


def estimate_cells(found: Uncertain | None, si: str) -> tuple[str, str, str, str]:
    """Value, standard error, 95 % interval and unit of an estimate as table cells.

    Parameters
    ----------
    found : Uncertain or None
        In the SI unit ``si``.
    si : str
        As written in recordings, e.g. ``"N/m"``.

    Returns
    -------
    tuple of str
        En dashes where there is nothing to say.

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


def estimate_text(found: Uncertain | None, si: str) -> str:
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


def given(value: float | None, si: str) -> str:
    """Write a setting as the campaign gave it, in its display unit and without padding zeros; ``si`` is its SI unit.

    Examples
    --------
    >>> given(310000.0, "Pa"), given(0.4537856, "rad"), given(1.95, "m/s"), given(None, "m")
    ('0.31 MPa', '26 °', '1.95 m/s', '–')
    """
    if value is None:
        return "–"
    unit = display_unit(si, value)
    return f"{value * unit.factor:.5g} {unit.name}".strip().replace("-", "−")


def milliseconds(time: float) -> str:
    """Write a time in s as milliseconds with one decimal and no sign before zero, without the unit."""
    return f"{round(1e3 * time, 1) + 0.0:.1f}".replace("-", "−")


def correlation(value: float) -> str:
    """Write a correlation [1] with its sign and two decimals, a vanishing one as ``0.00``."""
    text = f"{value:+.2f}"
    return "0.00" if text[1:] == "0.00" else text.replace("-", "−")


__all__ = [
    "Uncertain",
    "correlation",
    "estimate_cells",
    "estimate_text",
    "given",
    "milliseconds",
    "number",
    "percent",
    "quantity",
]
