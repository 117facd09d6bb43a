"""Words and units as damper dynos write them, and the conditions in the block above their tables."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from jounce.core.columns import name_and_unit
from jounce.core.units import conversion_factor, is_unit, is_unit_of

BUMP = frozenset(
    [
        "comp",
        "compr",
        "compression",
        "compressive",
        "bump",
        "jounce",
        "druck",
        "druckstufe",
        "einfedern",
    ]
)
REBOUND = frozenset(
    ["reb", "rebound", "rbd", "rebnd", "zug", "zugstufe", "ausfedern", "extension", "ext", "droop"]
)
GAS = frozenset(["gas", "gasforce", "gaskraft", "nitrogen", "n2", "gasdruck", "gaspressure"])
_CLICKS = frozenset(["click", "clicks", "klick", "klicks", "rasten", "detents"])
_ADJUSTERS = frozenset(["setting", "adjuster", "adj", "einstellung", "position"])
_SPEEDS = {
    "low_speed": frozenset(["low", "ls", "lsc", "lsr"]),
    "high_speed": frozenset(["high", "hs", "hsc", "hsr"]),
}
_SHORT = {"bump": frozenset(["lsc", "hsc"]), "rebound": frozenset(["lsr", "hsr"])}
_ROOM = frozenset(["ambient", "room", "umgebung", "raum", "limit", "max", "maximum"])
_VALUE = re.compile(r"\s*([-+]?\d+(?:\.\d+)?)\s*([^\d,;/]*)")
_ZERO_CELSIUS = 273.15  # K
_POUNDS = {"lb": "lbf", "lbs": "lbf", "pounds": "lbf", "#": "lbf", "kg": "kgf", "kgs": "kgf"}
_SPELLINGS = {
    "ips": "in/s",
    "fps": "ft/s",
    "inch": "in",
    "inches": "in",
    '"': "in",
    "secs": "s",
    "msec": "ms",
}


def words_of(name: str) -> frozenset[str]:
    """Return the words of a name in lower case.

    >>> sorted(words_of("Comp. Force_avg2")), sorted(words_of("ReboundForce"))
    (['avg', 'comp', 'force'], ['force', 'rebound'])
    """
    spaced = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)
    return frozenset(re.findall(r"[a-zäöüß]+|n2", spaced.lower()))


def unit_of(text: str, si: str) -> str:
    """Return a unit of a kind as jounce spells it; empty if it is none. Pounds and kilograms of a force are weights.

    >>> unit_of("lbs", "N"), unit_of("in/sec", "m/s"), unit_of("kg", "N"), unit_of("V", "m")
    ('lbf', 'in/s', 'kgf', '')
    """
    unit = text.strip(" []().").replace("/sec", "/s").replace("/Sec", "/s")
    if si == "N":
        unit = _POUNDS.get(unit.lower(), unit)
    unit = _SPELLINGS.get(unit.lower(), unit)
    spelt = unit if is_unit(unit) else unit.lower()  # kN are no knots
    return spelt if spelt and is_unit_of(spelt, si) else ""


def kelvin(value: float, unit: str) -> float | None:
    """Convert a temperature; None without a unit of temperatures.

    >>> [round(kelvin(value, unit), 2) for value, unit in ((104.0, "F"), (40.0, "°C"), (300.0, "K"))]
    [313.15, 313.15, 300.0]
    """
    letter = re.sub(r"deg(?:rees?)?|[^a-z]", "", unit.lower())
    if letter in ("f", "fahrenheit"):
        return (value - 32.0) / 1.8 + _ZERO_CELSIUS
    if letter in ("c", "celsius"):
        return value + _ZERO_CELSIUS
    return value if letter in ("k", "kelvin") else None


def adjuster_of(words: frozenset[str]) -> str:
    """Return the name of the adjuster that words are about: ``clicks``, ``low_speed_bump_clicks``, ...

    >>> [adjuster_of(words_of(name)) for name in ("Clicks", "Rebound clicks", "LSC", "Temp")]
    ['clicks', 'rebound_clicks', 'low_speed_bump_clicks', '']
    """
    sides = [
        side
        for side, names in (("bump", BUMP | _SHORT["bump"]), ("rebound", REBOUND | _SHORT["rebound"]))
        if words & names
    ]  # fmt: skip
    short = words & (_SHORT["bump"] | _SHORT["rebound"])
    if not (words & _CLICKS or short or (sides and words & _ADJUSTERS)) or len(sides) > 1:
        return ""
    speeds = [speed for speed, names in _SPEEDS.items() if words & names]
    return "_".join([*speeds[:1], *sides, "clicks"])


def conditions_in(rows: Iterable[Sequence[str]]) -> dict[str, float]:
    """Read clicks, temperature (K), gas pressure (Pa) and gas force (N) from the rows above a table.

    A row is a name and a value, ``Gas pressure;150 psi``, ``Gas pressure [psi];150`` or ``Clicks: 8``. A value without
    the unit it needs is not read, and neither is one of two that contradict each other.

    >>> rows = [["Serial", "A-12"], ["Temp (F)", "104"], ["Gas pressure: 10 bar"], ["Reb clicks", "8"]]
    >>> conditions_in(rows)
    {'temperature': 313.15, 'gas_pressure': 1000000.0, 'rebound_clicks': 8.0}
    """
    read: dict[str, set[float]] = {}
    for row in rows:
        first, *rest = [cell.strip() for cell in row if cell.strip()] or [""]
        name, mark, value = re.match(r"([^:=]*)([:=]?)(.*)", first).groups()  # type: ignore[union-attr]
        texts = [value, *rest] if mark and value.strip() else rest
        match = _VALUE.fullmatch(" ".join(texts[:2]).strip()) if texts else None
        if match is None:
            continue
        condition = _condition(name.strip(), float(match[1]), match[2].strip())
        if condition is not None:
            read.setdefault(condition[0], set()).add(round(condition[1], 6))
    return {name: values.pop() for name, values in read.items() if len(values) == 1}


def _condition(key: str, value: float, unit: str) -> tuple[str, float] | None:
    name, bracketed = name_and_unit(key)
    if not bracketed and key.endswith(")"):
        name, _, bracketed = key[:-1].rpartition("(")
    words, unit = words_of(name), unit or bracketed
    if any(word.startswith("temp") for word in words) and not words & _ROOM:
        celsius = kelvin(value, unit)
        return None if celsius is None else ("temperature", celsius)
    if words & GAS or {"reservoir", "pressure"} <= words:
        for setting, si in (("gas_pressure", "Pa"), ("gas_force", "N")):
            if spelt := unit_of(unit, si):
                return setting, value * conversion_factor(spelt, si)
        return None
    adjuster = adjuster_of(words)
    return (
        (adjuster, value)
        if adjuster and words_of(unit) <= {"clicks", "click", "klicks", "out", "from", "closed"}
        else None
    )
