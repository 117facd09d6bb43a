"""Display units of SI values: metric or imperial, one system at a time for all interfaces.

Files, recordings and JSON stay SI, and inputs carry their units.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import lru_cache
from typing import Literal, get_args

from jounce.core.errors import DescriptionError, unknown

System = Literal["metric", "imperial"]
SYSTEMS: tuple[System, ...] = get_args(System)


@dataclass(frozen=True)
class DisplayUnit:
    """Unit in which values of an SI unit are shown.

    Attributes
    ----------
    name : str
        Printed name, e.g. ``"mm"``; empty for plain numbers.
    factor : float
        Displayed value of one SI unit [1].
    """

    name: str
    factor: float

    def label(self, words: str) -> str:
        """Return an axis label such as ``displacement [mm]``; plain numbers have ``[–]``."""
        return f"{words} [{self.name or '–'}]"

    def behind(self, number: str) -> str:
        """Return a number with its unit: ``22 N/mm``, but ``26°``."""
        return f"{number}{'' if self.name == '°' else ' '}{self.name}".strip()


_DEGREES = 180.0 / math.pi
_INCH, _FOOT, _POUND, _GRAVITY = (
    0.0254,
    0.3048,
    0.45359237,
    9.80665,
)  # m, m, kg, m/s^2: exact by definition
_POUND_FORCE = _POUND * _GRAVITY
_ANYWHERE = {
    "rad": DisplayUnit("°", _DEGREES),
    "rad/s": DisplayUnit("°/s", _DEGREES),
    "rad/s^2": DisplayUnit("°/s²", _DEGREES),
    "1": DisplayUnit("", 1.0),
    "": DisplayUnit("", 1.0),
}
_UNITS: dict[System, dict[str, DisplayUnit]] = {
    "metric": {
        **_ANYWHERE,
        "m": DisplayUnit("mm", 1e3),
        "m/s": DisplayUnit("m/s", 1.0),
        "m/s^2": DisplayUnit("m/s²", 1.0),
        "rad/m": DisplayUnit("°/m", _DEGREES),
        "rad/m^2": DisplayUnit("°/m²", _DEGREES),
        "Pa": DisplayUnit("MPa", 1e-6),
        "N/m": DisplayUnit("N/mm", 1e-3),
        "N*s/m": DisplayUnit("N·s/m", 1.0),
        "N*m": DisplayUnit("N·m", 1.0),
        "kg*m^2": DisplayUnit("kg·m²", 1.0),
    },
    "imperial": {
        **_ANYWHERE,
        "m": DisplayUnit("in", 1.0 / _INCH),
        "m^2": DisplayUnit("in²", _INCH**-2),
        "m^3": DisplayUnit("ft³", _FOOT**-3),
        "m/s": DisplayUnit("in/s", 1.0 / _INCH),
        "m/s^2": DisplayUnit("ft/s²", 1.0 / _FOOT),
        "m/s^3": DisplayUnit("ft/s³", 1.0 / _FOOT),
        "1/m": DisplayUnit("1/ft", _FOOT),
        "rad/m": DisplayUnit("°/in", _DEGREES * _INCH),
        "rad/m^2": DisplayUnit("°/in²", _DEGREES * _INCH**2),
        "m/km": DisplayUnit("in/mi", 1e-3 * 5280.0 * _FOOT / _INCH),
        "m/rad": DisplayUnit("in/rad", 1.0 / _INCH),
        "kg": DisplayUnit("lb", 1.0 / _POUND),
        "kg*m^2": DisplayUnit("lb·ft²", 1.0 / (_POUND * _FOOT**2)),
        "N": DisplayUnit("lbf", 1.0 / _POUND_FORCE),
        "Pa": DisplayUnit("psi", _INCH**2 / _POUND_FORCE),
        "N/m": DisplayUnit("lbf/in", _INCH / _POUND_FORCE),
        "N/m^2": DisplayUnit("lbf/in²", _INCH**2 / _POUND_FORCE),
        "N/m^3": DisplayUnit("lbf/in³", _INCH**3 / _POUND_FORCE),
        "N*s/m": DisplayUnit("lbf·s/in", _INCH / _POUND_FORCE),
        "N/s": DisplayUnit("lbf/s", 1.0 / _POUND_FORCE),
        "N/Hz": DisplayUnit("lbf/Hz", 1.0 / _POUND_FORCE),
        "N*m": DisplayUnit("lbf·ft", 1.0 / (_POUND_FORCE * _FOOT)),
        "N*m/rad": DisplayUnit("lbf·ft/rad", 1.0 / (_POUND_FORCE * _FOOT)),
        "N*m*s/rad": DisplayUnit("lbf·ft·s/rad", 1.0 / (_POUND_FORCE * _FOOT)),
        "J": DisplayUnit("ft·lbf", 1.0 / (_POUND_FORCE * _FOOT)),
        "W": DisplayUnit("hp", 1.0 / (550.0 * _POUND_FORCE * _FOOT)),
    },
}
_LARGE: dict[System, dict[str, tuple[float, DisplayUnit]]] = {
    "metric": {"N": (2e4, DisplayUnit("kN", 1e-3)), "W": (2e4, DisplayUnit("kW", 1e-3))},
    "imperial": {
        "m": (10.0, DisplayUnit("ft", 1.0 / _FOOT)),
        "m/s": (4.0, DisplayUnit("mph", 3600.0 / (5280.0 * _FOOT))),
    },
}
"""Size (SI) from which a different unit is usual: roads are measured in feet, vehicle speeds in miles per hour."""
_chosen: System = "metric"


def current_units() -> System:
    """Return the name of the current system of units."""
    return _chosen


def use_units(system: System) -> None:
    """Select the system of units for tables, figures, reports and notebooks.

    Parameters
    ----------
    system : {"metric", "imperial"}
        ``metric``: mm, N/mm, N·s/m, MPa, the default. ``imperial``: in, lbf/in, lbf·s/in, psi, lb, lbf,
        and mph and ft for large speeds and lengths. Angles are in degrees in both systems.

    Raises
    ------
    DescriptionError
        For an unknown system.

    Notes
    -----
    Only displayed values change. Results, recordings and JSON stay SI, and input files state their units. Findings and
    error messages stay metric.

    Examples
    --------
    >>> import jounce as jn
    >>> jn.use_units("imperial")
    >>> jn.plots.quantity(22730.0, "N/m")
    '129.8 lbf/in'
    >>> jn.use_units("metric")
    >>> jn.plots.quantity(22730.0, "N/m")
    '22.73 N/mm'
    """
    global _chosen  # noqa: PLW0603 - one choice for the whole process
    if system not in SYSTEMS:
        raise unknown(str(system), SYSTEMS, what="system of units", where="use_units")
    _chosen = system


@contextmanager
def local_units(system: System) -> Iterator[None]:
    """Select the system of units within a block."""
    before = _chosen
    use_units(system)
    try:
        yield
    finally:
        use_units(before)


def display_unit(si: str, largest: float = 0.0) -> DisplayUnit:
    """Choose the display unit for values of an SI unit.

    Parameters
    ----------
    si : str
        SI unit as written in recordings, e.g. ``"m/s^2"``.
    largest : float
        Largest absolute value to display, in that SI unit; forces above 20 000 N are shown in kN, and in imperial
        units speeds from 4 m/s on in mph, lengths from 10 m on in ft.

    Returns
    -------
    DisplayUnit
        The SI unit itself if no other unit is common.

    Examples
    --------
    >>> display_unit("m").label("displacement"), display_unit("N", 5e4).name, display_unit("N*s/m").name
    ('displacement [mm]', 'kN', 'N·s/m')
    """
    large = _LARGE[_chosen].get(si)
    if large is not None and abs(largest) >= large[0]:
        return large[1]
    return _UNITS[_chosen].get(si) or DisplayUnit(
        si.replace("^2", "²").replace("^3", "³").replace("*", "·"), 1.0
    )


def display_unit_for(unit: str, words: str = "", largest: float = 0.0) -> DisplayUnit:
    """Return the unit, in the current system, for values in a metric unit, and the factor.

    Parameters
    ----------
    unit : str
        Metric unit of the values, SI or not: ``"N/m"``, ``"mm"``, ``"N·s/m"``.
    words : str
        Quantity in words: speeds are in mph, regardless of their size.
    largest : float
        Largest absolute value, in ``unit``.

    Returns
    -------
    DisplayUnit
        ``unit`` itself, with the factor 1, in the metric system and if it has no imperial counterpart.

    Examples
    --------
    >>> with local_units("imperial"):
    ...     display_unit_for("mm").name, round(display_unit_for("m/s", "speed").factor, 5), display_unit_for("Hz")
    ('in', 2.23694, DisplayUnit(name='Hz', factor=1.0))
    """
    if _chosen == "metric":
        return DisplayUnit(unit, 1.0)
    conversion = _si_of(unit)
    if conversion is None:
        return DisplayUnit(unit, 1.0)
    si, size = conversion
    if si == "m/s" and "speed" in words:
        largest = math.inf
    other = display_unit(si, largest * size)
    return DisplayUnit(other.name, other.factor * size)


def size(value: float, unit: str, words: str = "") -> str:
    """Write a value in a metric unit, with its unit in the current system; ``words`` as in `display_unit_for`.

    >>> with local_units("imperial"):
    ...     size(20.0, "m/s"), size(0.35, "m"), size(2.0, "s")
    ('44.74 mph', '13.78 in', '2 s')
    """
    other = display_unit_for(unit, words, abs(value))
    digits = ".6g" if other.factor == 1.0 else ".4g"
    return f"{value * other.factor:{digits}} {other.name}"


@lru_cache(maxsize=256)
def _si_of(unit: str) -> tuple[str, float] | None:
    """SI unit and factor of a metric unit, if it has an imperial counterpart."""
    from jounce.core.units import conversion_factor

    if unit in _KEPT or unit in _ANYWHERE:
        return None
    table = _UNITS["imperial"]
    if unit in table:
        return unit, 1.0
    for si in table:
        if si not in _ANYWHERE:
            try:
                return si, conversion_factor(unit, si)
            except DescriptionError:
                continue
    return None


_KEPT = frozenset({"g", "%", "°", "deg", "s", "ms", "Hz", "–", "SI"})
"""Units of both systems; ``g`` is standard gravity."""
