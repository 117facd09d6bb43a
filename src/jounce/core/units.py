"""Convert input with units to SI floats, which all other code uses."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from functools import lru_cache
from numbers import Real
from typing import Annotated, Any

from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic_core import CoreSchema, core_schema

from jounce.core.errors import DescriptionError, as_found
from jounce.core.misplaced import error_at
from jounce.core.phrases import Phrase, Phrases
from jounce.core.remembered import Recent

_NUMBER = re.compile(r"([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(\S.*)?", re.DOTALL)
_COMMA = re.compile(r"([+-]?\d+),(\d+(?:[eE][+-]?\d+)?(?:\s*[^\d\s,].*)?)", re.DOTALL)
_LONGEST_TEXT = 1000
_DIMENSIONLESS = {"", "1", "-"}
_UNIT_HINT = "Check spelling and case, e.g. 'mm', 'N/mm', 'N*s/m', 'MPa', 'deg', 'm/s^2'."


def _registry() -> Any:
    """Return pint's registry: one for all threads, because units of two registries cannot be mixed."""

    def make() -> Any:
        import pint

        # No cache: pint unpickles files in its cache folder, which other users may be able to write.
        return pint.UnitRegistry(autoconvert_offset_to_baseunit=True)

    return _registries.of("pint", make)


_registries: Recent[Any] = Recent()


_LONGEST_UNIT = 64
_UNIT_TEXT = re.compile(r"[A-Za-z_°µμΩ%0-9.*/^()\s+-]*")
_POWER = re.compile(
    r"\^\s*(?:\(\s*[+-]?\d{1,2}(?:\.\d+)?\s*\)|[+-]?\d{1,2}(?:\.\d+)?)(?![\d.]|\s*\^)"
)
_AS_WRITTEN = str.maketrans({
    "²": "^2", "³": "^3", "⁴": "^4", "·": "*", "⋅": "*", "×": "*", "−": "-", "’": "'", "\N{GREEK SMALL LETTER MU}": "µ",
})  # fmt: skip
_WORDS = {
    "Nm": "N*m", "kNm": "kN*m", "Nmm": "N*mm", "Ns": "N*s", "kNs": "kN*s", "Nms": "N*m*s", "kp": "kgf", "kmh": "km/h",
    "kmph": "km/h", "ips": "in/s", "fps": "ft/s", "Sek": "s", "sek": "s", "Grad": "deg", "grad": "deg",
    "Mpa": "MPa", "Kpa": "kPa", "KPa": "kPa", "Bar": "bar", "PSI": "psi", "Kg": "kg", "KG": "kg",
}  # fmt: skip
"""Units of test benches that pint does not know, or interprets differently (Nm: a textile unit)."""
_WHOLE = {"U/min": "rpm", "1/min": "rpm", "min^-1": "rpm", "lb-ft": "lbf*ft", "ft-lb": "lbf*ft", "ft-lbs": "lbf*ft",
          "ft*lb": "lbf*ft", "lb*ft": "lbf*ft", "lb-in": "lbf*in", "in-lb": "lbf*in"}  # fmt: skip
"""Units with a different meaning in a column of rotation or torque."""
_GRAVITY = {
    **dict.fromkeys(("g", "G", "gn", "g_n", "g0", "g_0", "gs", "g's", "g-force"), 1.0),
    **dict.fromkeys(
        ("mg", "mG", "mgn", "milli-g", "millig", "milli g", "milli_g", "milligravity"), 1e-3
    ),
    **dict.fromkeys(("µg", "ug", "micro-g", "microg", "micro g"), 1e-6),
}
"""Acceleration units in multiples of standard gravity: pint reads g as gram."""


def _plain_spelling(unit: str) -> str:
    """Convert a unit to pint's spelling: ``m/s2`` to ``m/s^2``, ``N.m`` and ``N-m`` to ``N*m``.

    >>> [_plain_spelling(text) for text in ("m/s2", "N·s/mm", "m s-2", "kNm/deg", "°/s²", "%")]
    ['m/s^2', 'N*s/mm', 'm s^-2', 'kN*m/deg', '°/s^2', 'percent']
    """
    text = re.sub(r"⁻([¹²³⁴])", lambda match: f"^-{'¹²³⁴'.index(match[1]) + 1}", unit)
    text = text.translate(_AS_WRITTEN).replace("**", "^").replace("%", "percent").strip("'\"")
    text = re.sub(r"(?<=[A-Za-zµ°])(-?\d)(?![\dA-Za-z])", r"^\1", text)
    text = re.sub(r"(?<=[A-Za-z])\s*[.-]\s*(?=[A-Za-z])", "*", text)
    return re.sub(r"[A-Za-z]+", lambda match: _WORDS.get(match[0], match[0]), text)


@lru_cache(maxsize=512)
def _parse_unit(unit: str) -> Any:
    """Return pint's unit for a text; raise ValueError if it is not a unit, far too long, or has too high a power."""
    plain = _plain_spelling(unit) if len(unit) <= _LONGEST_UNIT else "^"
    if (
        not plain
        or not _UNIT_TEXT.fullmatch(plain)
        or plain.count("^") != len(_POWER.findall(plain))
    ):
        raise ValueError(Phrase("{unit!r} is not a unit", unit=unit[:_LONGEST_UNIT]))
    try:
        result = _registry().Unit(plain)
        _registry().Quantity(1.0, result).to_root_units()
    except Exception as error:
        raise ValueError(Phrase("{unit!r} is not a unit", unit=unit)) from error
    return result


@lru_cache(maxsize=20_000)  # pint takes half a millisecond to reject a word
def is_unit(text: str) -> bool:
    """Whether a text is any unit.

    >>> [is_unit(text) for text in ("N", "m/s2", "milli-g", "front", ":,1", "m^9**9**9")]
    [True, True, True, False, False, False]
    """
    text = text.strip()
    if text in _GRAVITY or text in _WHOLE or text in _KNOWN:
        return True
    try:
        _parse_unit(text)
    except ValueError:
        return False
    return any(letter.isalpha() or letter in "%°" for letter in text)


def is_unit_of(text: str, si: str) -> bool:
    """Whether a text is a unit that converts to an SI unit.

    >>> is_unit_of("ms", "s"), is_unit_of("N", "s"), is_unit_of("front", "s")
    (True, False, False)
    """
    try:
        _factor(text.strip(), si)
    except ValueError:
        return False
    return True


_EVERYDAY: dict[str, dict[str, float]] = {
    "1": {"%": 0.01},
    "Hz": {"kHz": 1e3},
    "N": {"kN": 1e3},
    "N/m": {"N/mm": 1e3, "kN/m": 1e3, "kN/mm": 1e6},
    "N/m^3": {"N/mm^3": 1e9},
    "Pa": {"MPa": 1e6, "bar": 1e5, "kPa": 1e3},
    "kg": {"g": 1e-3},
    "m": {"cm": 0.01, "mm": 1e-3},
    "m/s": {"km/h": 1e3 / 3600.0, "mm/s": 1e-3},
    "m/s^2": {"mm/s^2": 1e-3},
    "rad": {"deg": math.pi / 180.0},
    "s": {"ms": 1e-3},
}
"""Units in nearly every description; with them most commands need not load pint. A test compares them with it."""
_KNOWN = {unit for si, others in _EVERYDAY.items() for unit in (si, *others)} - {"1"}


@lru_cache(maxsize=512)
def _factor(unit: str, si: str) -> float:
    """Return the value of one ``unit`` in ``si``; raise ValueError with the reason if it does not convert."""
    if unit == si or (si in _DIMENSIONLESS and unit in _DIMENSIONLESS):
        return 1.0
    if si == "m/s^2" and unit in _GRAVITY:
        return 9.80665 * _GRAVITY[unit]
    everyday = _EVERYDAY.get(si, {}).get(unit)
    return _factor_of_library(unit, si) if everyday is None else everyday


def _factor_of_library(unit: str, si: str) -> float:
    """Return the same for any unit, computed by pint."""
    registry = _registry()
    target = registry.Unit(si if si not in _DIMENSIONLESS else "dimensionless")
    turning = si in ("Hz", "rad/s", "N*m", "N*m/rad")
    parsed = _parse_unit(_WHOLE.get(unit, unit) if turning else unit)
    wrong = f"{unit!r} is not a unit of {si if si not in _DIMENSIONLESS else 'a plain number'}"
    try:
        factor, thrice = (
            float(registry.Quantity(number, parsed).to(target).magnitude) for number in (1.0, 3.0)
        )
    except Exception as error:
        raise ValueError(wrong) from error
    if not math.isclose(thrice, 3.0 * factor, rel_tol=1e-9):  # dB, octaves, degrees Celsius
        raise ValueError(wrong)
    angles = _angles(parsed)
    if si == "Hz" and angles == 1.0:
        return factor / (2.0 * math.pi)
    if not (
        angles == _angles(target)
        or (angles == 0.0 and si.startswith("rad") and _has_dimensions(parsed))
    ):
        raise ValueError(wrong)
    if si.startswith("rad/s") and "hertz" in str(parsed):
        raise ValueError(wrong)
    return factor


def _angles(unit: Any) -> float:
    """Exponent of the angle in a unit: 1 for rad/s and rpm, 0 for Hz.

    pint treats radians as plain numbers: it would convert 60 rpm to 6.28 Hz, and a count to 1 rad.
    """
    root = _registry().Quantity(1.0, unit).to_root_units().units
    return float(root._units.get("radian", 0.0))


def _has_dimensions(unit: Any) -> bool:
    """Whether a unit is not just a count or a fraction: mm/m may be an angle and 1/s a rotation, but not % or bits."""
    return any(_registry().Unit(name).dimensionality for name in unit._units)


def conversion_factor(unit: str, si: str, *, where: str = "") -> float:
    """Return the SI value of one ``unit``, in ``si`` (``"1"``: a plain number).

    The unit is as users write it, e.g. ``"mm"``, ``"N*s/m"``, or ``"g"`` for standard gravity if ``si`` is m/s^2
    (``"mg"`` and ``"milli-g"``: a thousandth of it). Spellings of test benches are also accepted: ``m/s2``, ``Nm``,
    ``N.s/m``, ``U/min``. Unknown units and units of a different quantity raise a DescriptionError at ``where``.

    >>> conversion_factor("mg", "m/s^2"), conversion_factor("mg", "kg"), round(conversion_factor("rpm", "Hz"), 9)
    (0.00980665, 1e-06, 0.016666667)
    """
    try:
        return _factor(unit.strip(), si)
    except ValueError as error:
        raise DescriptionError(
            "wrong unit",
            where=where,
            found=unit[:_LONGEST_UNIT],
            allowed=Phrase("a unit that converts to {si}", si=si),
            hint=_VOLTAGE_HINT if _VOLTAGE.fullmatch(unit.strip()) else _UNIT_HINT,
        ) from error


_VOLTAGE = re.compile("[kmuµμ]?V|[Vv]olts?")
_VOLTAGE_HINT = "A voltage is a raw sensor signal: divide by its sensitivity (e.g. mV/g) and write the resulting unit."


@dataclass(frozen=True)
class BaseUnit:
    """A unit by base units: powers of kg, m, s, A, K, rad, and the SI value of a number x, ``factor * x + offset``."""

    powers: dict[str, float]
    factor: float
    offset: float = 0.0


def in_base_units(unit: str, *, where: str = "") -> BaseUnit:
    """Return any unit by base units; ``g`` and ``mg`` are accelerations, as in the columns of records.

    Unknown units and logarithmic units (dB) raise a DescriptionError at ``where``.

    >>> in_base_units("mm/s"), in_base_units("g").factor
    (BaseUnit(powers={'m': 1.0, 's': -1.0}, factor=0.001, offset=0.0), 9.80665)
    """
    text = unit.strip()
    if text in _DIMENSIONLESS or text == "–":
        return BaseUnit({}, 1.0)
    if text in _GRAVITY:
        return BaseUnit({"m": 1.0, "s": -2.0}, 9.80665 * _GRAVITY[text])
    try:
        parsed = _parse_unit(_WHOLE.get(text, text) if text != "1/min" else text)
        zero, unity, three = (
            _registry().Quantity(number, parsed).to_base_units() for number in (0.0, 1.0, 3.0)
        )
        offset = float(zero.magnitude)
        factor = float(unity.magnitude) - offset
        if not math.isclose(float(three.magnitude), 3.0 * factor + offset, rel_tol=1e-9):
            raise ValueError(unit)  # dB
    except Exception as error:
        raise DescriptionError(
            "not a unit", where=where, found=unit[:_LONGEST_UNIT], hint=_UNIT_HINT
        ) from error
    powers = {
        _SYMBOLS.get(str(name), str(name)): round(float(power), 9)
        for name, power in unity.units._units.items()
    }
    return BaseUnit(dict(sorted(powers.items())), factor, offset)


_SYMBOLS = {
    "kilogram": "kg",
    "meter": "m",
    "second": "s",
    "ampere": "A",
    "kelvin": "K",
    "radian": "rad",
}
"""Symbols of base units by pint's names."""


def unit_factor(unit: str, other: str, *, where: str = "") -> float:
    """Return the value of one ``unit`` in ``other``, for units of records in any spelling.

    Units of different quantities, and scales with different zeros (°C and K), raise a DescriptionError at ``where``.

    >>> unit_factor("N/mm", "N/m"), round(unit_factor("g", "m/s2"), 5)
    (1000.0, 9.80665)
    """
    if unit == other:
        return 1.0
    first, second = in_base_units(unit, where=where), in_base_units(other, where=where)
    if first.powers != second.powers or first.offset != second.offset:
        raise DescriptionError(
            "wrong unit",
            where=where,
            found=unit,
            allowed=Phrase("a unit that converts to {si}", si=other),
        )
    return first.factor / second.factor


def base_units(si: str) -> dict[str, int]:
    """Powers of the base units (kg, m, s, A, K, rad) of an SI unit; empty for a plain number.

    >>> base_units("N*s/m"), base_units("1")
    ({'kg': 1, 's': -1}, {})
    """
    if si in _DIMENSIONLESS:
        return {}
    powers = _registry().Quantity(1.0, _parse_unit(si)).to_base_units().units._units
    return {_SYMBOLS[str(name)]: int(power) for name, power in sorted(powers.items())}


def as_number(value: object, si: str, *, where: str = "") -> float:
    """Return a number of any library, or a text with its unit, as a float in ``si``; NaN is left to the caller.

    Any other value raises a DescriptionError at ``where``.

    >>> import numpy as np
    >>> as_number(np.timedelta64(500, "ms"), "s"), as_number("500 ms", "s"), as_number(0.5, "s")
    (0.5, 0.5, 0.5)
    """
    from jounce.core.foreign import plain_numbers

    if type(value) is float:
        return value
    if isinstance(value, str):
        return to_si(value, si, where=where)
    given = "None" if value is None else value
    refusal = DescriptionError(
        "invalid physical value",
        where=where,
        found=given,
        allowed=Phrase("'<number> <unit of {si}>'", si=si),
    )
    if isinstance(value, bool) or getattr(getattr(value, "dtype", None), "kind", "") == "b":
        raise refusal
    try:
        array, unit = plain_numbers(value, where, DescriptionError)
    except DescriptionError:
        raise refusal from None
    if array.ndim:
        raise refusal
    return float(array) * (conversion_factor(unit, si, where=where) if unit else 1.0)


def to_si(value: object, si: str, *, where: str = "") -> float:
    """Read one physical value in ``si``: text with its unit (``"22.73 N/mm"``), or a bare number that is already SI.

    Numbers of other libraries are also accepted; those with a unit (a Pint quantity, a duration) are converted. A
    missing or wrong unit, and a value that is not a finite number, raise a DescriptionError at ``where``.
    """
    if (
        type(value) is float and -LARGEST <= value <= LARGEST
    ):  # the most common case: descriptions made from others
        return value
    if not isinstance(value, str) and (
        type(value) is bool or not isinstance(value, Real) or hasattr(value, "dtype")
    ):
        value = as_number(value, si, where=where)
    if not isinstance(value, str):
        try:
            number = float(value)
        except OverflowError:  # an integer of hundreds of digits
            number = math.inf
    else:
        match = _NUMBER.fullmatch(value.strip()) if len(value) <= _LONGEST_TEXT else None
        comma = _COMMA.fullmatch(value.strip()) if len(value) <= _LONGEST_TEXT else None
        if match is None or comma is not None:
            raise DescriptionError(
                "not a number with a unit" if comma is None else "a comma in a number",
                where=where,
                found=value,
                allowed="'<number>'" if si == "1" else Phrase("'<number> {si}'", si=si),
                hint=""
                if comma is None
                else Phrase(
                    "Use a decimal point and no thousands separator: '{whole}.{decimals}'.",
                    whole=comma[1],
                    decimals=comma[2],
                ),
            )
        number = float(match[1])
        if match[2] is None and si not in _DIMENSIONLESS:
            raise DescriptionError(
                "the unit is missing",
                where=where,
                found=value,
                allowed=Phrase(
                    "'{number} {si}' (or a unit that converts to it), or the bare number {number} in SI",
                    number=match[1],
                    si=si,
                ),
            )
        if match[2]:
            number *= conversion_factor(match[2], si, where=where)
    if not math.isfinite(number):
        raise DescriptionError(
            "not a finite number", where=where, found=value, allowed="a finite number"
        )
    is_written = isinstance(value, str)  # a zero with rounding error is valid
    if abs(number) > LARGEST or (is_written and 0.0 < abs(number) < _SMALLEST):
        sizes = Phrase(
            "0, and magnitudes from {least:g} to {most:g}", least=_SMALLEST, most=LARGEST
        )
        allowed = sizes if si == "1" else Phrases(" ", [sizes, si])
        raise DescriptionError("an impossible value", where=where, found=value, allowed=allowed)
    return number


LARGEST = 1e30
"""Magnitude in SI beyond any value of a vehicle; products of several such values overflow."""
_SMALLEST = 1e-100
"""Magnitude in texts below which quotients overflow."""


_MEANT = {
    "m/s": (0.0, 150.0, "km/h"),
    "m/s^2": (0.0, 1e4, "g"),
    "kg": (0.0, 1e5, "g"),
    "rad": (0.0, 1.0, "deg"),
    "N/m": (100.0, 1e9, "N/mm"),
    "N*s/m": (0.0, 1e6, "N*s/m"),
    "N*m": (0.0, 1e6, "N*mm"),
    "N": (0.0, 1e7, "N"),
    "Pa": (1e3, 1e9, "bar"),
    "Hz": (0.0, 1e5, "rpm"),
    "s": (0.0, 1e6, "ms"),
    "m": (0.0, 1e6, "mm"),
}
"""Magnitudes (SI) allowed for a bare number, 0 or from the first to the second, and the usual other unit."""


def bare_si(number: float, si: str, *, where: str, most: float | None = None) -> float:
    """Return a number without a unit as a value in ``si``; refuse implausible magnitudes.

    ``most`` is a tighter limit than that of the unit; with an explicit unit, any magnitude is accepted.

    >>> bare_si(1.95, "m/s", where="--speed")
    1.95
    >>> bare_si(-2.0, "rad", where="--camber")   # doctest: +ELLIPSIS
    Traceback (most recent call last):
    jounce.core.errors.DescriptionError: --camber: -2 rad is implausible, ... State the unit: '-2 deg', or '-2 rad' ...
    """
    low, high, usual = _MEANT.get(si, (0.0, math.inf, si))
    high = min(high, math.inf if most is None else most)
    if number == 0.0 or low <= abs(number) < high or not math.isfinite(number):
        return to_si(number, si, where=where)
    other = Phrase("'{number:g} {unit}', or ", number=number, unit=usual) if usual != si else ""
    raise DescriptionError(
        Phrase(
            "{number:g} {si} is implausible, and a number without a unit is in {si}",
            number=number,
            si=si,
        ),
        where=where,
        found=f"{number:g}",
        hint=Phrase(
            "State the unit: {other}'{number:g} {si}' if this value is right.",
            other=other,
            number=number,
            si=si,
        ),
    )


def positive_si(value: object, si: str, *, where: str, zero: bool = False) -> float:
    """Read one physical value as :func:`to_si` does, and refuse values below 0 and (unless ``zero``) 0 itself."""
    number = to_si(value, si, where=where)
    if number < 0.0 or (number == 0.0 and not zero):
        limits = Unit(si, at_least=0.0) if zero else Unit(si, above=0.0)
        raise DescriptionError("out of range", where=where, found=value, allowed=limits.range_text)
    return number


@dataclass(frozen=True)
class Unit:
    """Pydantic annotation of a physical field: ``Annotated[float, Unit("m")]`` reads text with units into SI."""

    si: str
    above: float | None = None
    at_least: float | None = None
    at_most: float | None = None
    meant: float | None = None  # larger values are accepted with a warning

    def mistaken_for(self, value: float) -> str:
        """Unit that was probably meant for a magnitude (SI) implausible for a suspension; empty if it is plausible.

        >>> Unit("N/m").mistaken_for(22.73), Unit("m", meant=1.0).mistaken_for(0.01)
        ('N/mm', '')
        """
        low, high, usual = (
            _MEANT.get(self.si, (0.0, math.inf, self.si))
            if self.si in _ASKED
            else (0.0, math.inf, "mm")
        )
        high = high if self.meant is None else self.meant
        if value == 0.0 or low <= abs(value) <= high:
            return ""
        return usual

    def _read(self, value: object) -> float:
        try:
            number = to_si(value, self.si)
        except DescriptionError as error:
            raise error_at(
                (), error.what, found=as_found(value), allowed=error.allowed, hint=error.hint
            ) from None
        if not self._is_allowed(number):
            raise error_at((), "out of range", found=as_found(value), allowed=self.range_text)
        return number

    @property
    def limits(self) -> tuple[float, float]:
        """Minimum and maximum (SI), infinite without a limit; the minimum itself may be excluded (``above``)."""
        least = max(
            (bound for bound in (self.above, self.at_least) if bound is not None), default=-math.inf
        )
        return least, math.inf if self.at_most is None else self.at_most

    @property
    def range_text(self) -> str:
        """Limits in words, with their unit; empty without limits."""
        bounds = [
            ("above {bound:g}", self.above),
            ("at least {bound:g}", self.at_least),
            ("at most {bound:g}", self.at_most),
        ]
        limits = Phrases(
            ", ", [Phrase(limit, bound=bound) for limit, bound in bounds if bound is not None]
        )
        return limits if not limits or self.si == "1" else Phrases(" ", [limits, self.si])

    def _is_allowed(self, number: float) -> bool:
        return (
            (self.above is None or number > self.above)
            and (self.at_least is None or number >= self.at_least)
            and (self.at_most is None or number <= self.at_most)
        )

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(self._read)

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        return {
            "anyOf": [{"type": "number"}, {"type": "string"}],
            "description": f"text with a unit that converts to {self.si}, or a bare number in {self.si}",
        }


_ASKED = ("kg", "m/s", "N/m", "Pa")
"""Units whose limits apply to all descriptions, not only to command options."""

Length = Annotated[float, Unit("m")]
Height = Annotated[float, Unit("m", meant=1.0)]
PositiveHeight = Annotated[float, Unit("m", above=0.0, meant=1.0)]
PositiveLength = Annotated[float, Unit("m", above=0.0)]
NonNegativeLength = Annotated[float, Unit("m", at_least=0.0)]
Mass = Annotated[float, Unit("kg", above=0.0)]
PositiveTime = Annotated[float, Unit("s", above=0.0)]
Speed = Annotated[float, Unit("m/s")]
PositiveSpeed = Annotated[float, Unit("m/s", above=0.0)]
Force = Annotated[float, Unit("N")]
NonNegativeMass = Annotated[float, Unit("kg", at_least=0.0)]
NonNegativeForce = Annotated[float, Unit("N", at_least=0.0)]
Torque = Annotated[float, Unit("N*m")]
NonNegativeTorque = Annotated[float, Unit("N*m", at_least=0.0)]
Stiffness = Annotated[float, Unit("N/m")]
PositiveStiffness = Annotated[float, Unit("N/m", above=0.0)]
DampingCoefficient = Annotated[float, Unit("N*s/m")]
NonNegativeDampingCoefficient = Annotated[float, Unit("N*s/m", at_least=0.0)]
Acceleration = Annotated[float, Unit("m/s^2")]
Angle = Annotated[float, Unit("rad")]
Frequency = Annotated[float, Unit("Hz", above=0.0)]
Pressure = Annotated[float, Unit("Pa", above=0.0)]
Number = Annotated[float, Unit("1")]
PositiveNumber = Annotated[float, Unit("1", above=0.0)]
ProductOfInertia = Annotated[float, Unit("kg*m^2")]
MomentOfInertia = Annotated[float, Unit("kg*m^2", above=0.0)]
NonNegativeStiffness = Annotated[float, Unit("N/m", at_least=0.0)]
PositiveRotationalStiffness = Annotated[float, Unit("N*m/rad", above=0.0)]
NonNegativeRotationalStiffness = Annotated[float, Unit("N*m/rad", at_least=0.0)]
