"""Channels of dampers in a record from the track: which column belongs to which corner, told from its name."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Literal

from jounce.core.errors import unknown
from jounce.core.text import without_accents
from jounce.core.units import is_unit_of

Place = Literal["damper", "wheel"]
CORNERS = ("front_left", "front_right", "rear_left", "rear_right")
AXLES = ("front", "rear")
ALONE = "damper"
"""Name of the corner of a record that has one damper, and names no corner."""
COUNTERS = ("lap", "sector")

_CORNER_LETTERS = {
    "fl": "front_left",
    "lf": "front_left",
    "fr": "front_right",
    "rf": "front_right",
    "rl": "rear_left",
    "lr": "rear_left",
    "rr": "rear_right",
    "vl": "front_left",
    "vr": "front_right",
    "hl": "rear_left",
    "hr": "rear_right",
}
"""Short names of corners, English and German."""
_ENDS = {
    **dict.fromkeys(("front", "frnt", "vorne", "vorn", "fork", "f", "fo"), "front"),
    **dict.fromkeys(("rear", "back", "hinten", "shock_rear", "h"), "rear"),
}
_SIDES = {
    **dict.fromkeys(("left", "links", "l", "lh", "lhs"), "left"),
    **dict.fromkeys(("right", "rechts", "rh", "rhs"), "right"),
}
_DAMPER = {
    "damper",
    "dampers",
    "damp",
    "dampr",
    "dmpr",
    "dampfer",
    "shock",
    "shk",
    "absorber",
    "strut",
    "fork",
}
_SUSPENSION = {
    "susp",
    "suspension",
    "sus",
    "pot",
    "poti",
    "pots",
    "potentiometer",
    "linpot",
    "lvdt",
}
_WHEEL = {"wheel", "whl", "rad", "radhub", "hub"}
_TRAVEL = {
    "pos",
    "position",
    "travel",
    "trav",
    "trvl",
    "disp",
    "displ",
    "displacement",
    "defl",
    "deflection",
    "stroke",
    "weg",
    "hub",
    "radhub",
    "federweg",
    "movement",
    "z",
}
_VELOCITY = {"vel", "velocity", "speed", "spd", "geschwindigkeit", "geschw"}
_OTHERS = {
    "temp",
    "temperature",
    "press",
    "pressure",
    "force",
    "load",
    "acc",
    "accel",
    "acceleration",
    "az",
    "brake",
    "tyre",
    "tire",
    "steer",
    "steering",
    "camber",
    "toe",
    "torque",
    "rpm",
    "slip",
    "histogram",
    "angle",
    "target",
    "error",
    "status",
    "power",
    "energy",
    "stop",
    "friction",
    "length",
    "spring",
    "third",
    "command",
    "road",
    "ref",
    "reference",
    "fuel",
    "gps",
    "heave",
    "roll",
    "pitch",
}
"""Words of channels that are no travel of a damper."""
_LAPS = {"lap", "lapnumber", "lapno", "lapnum", "lapcount", "lapcounter", "runde", "rundennummer"}
_SECTORS = {"sector", "sektor", "segment", "split"}
_NUMBERS = {
    "number",
    "no",
    "num",
    "nr",
    "count",
    "counts",
    "counter",
    "index",
    "id",
    "current",
    "nummer",
}


@dataclass(frozen=True)
class Match:
    """A channel of a corner: its column, whether it is a velocity, and where it is measured.

    ``electrical`` is the unit of a column that is still in volts, amperes or counts; ``lacks_unit`` marks one without.
    """

    corner: str
    column: str
    is_velocity: bool
    place: Place
    electrical: str = ""
    lacks_unit: bool = False
    score: tuple[int, ...] = ()

    @property
    def is_usable(self) -> bool:
        """Whether it has a unit of length or velocity."""
        return not (self.electrical or self.lacks_unit)

    @property
    def channel(self) -> str:
        """Name of the channel in a recording."""
        return f"{self.corner}.{self.place}.{'velocity' if self.is_velocity else 'travel'}"


def words_of(name: str) -> list[str]:
    """Split the name of a channel into lower-case words; letters of a corner stand apart.

    >>> words_of("DamperPosFL"), words_of("LFshockDefl"), words_of("Stoßdämpfer_VL")
    (['damper', 'pos', 'fl'], ['lf', 'shock', 'defl'], ['stossdampfer', 'vl'])
    """
    spaced = re.sub(r"(?<=[a-zäöüß])(?=[A-Z])", " ", name)
    words: list[str] = []
    for word in re.findall(r"[a-z]+|\d+", without_accents(spaced)):
        words += _apart(word)
    return words


def _apart(word: str) -> list[str]:
    """Split a word such as ``flshock`` or ``suspfl`` into the letters of a corner and a known word."""
    known = _DAMPER | _SUSPENSION | _WHEEL | _TRAVEL
    if word[:2] in _CORNER_LETTERS and word[2:] in known:
        return [word[:2], word[2:]]
    if word[-2:] in _CORNER_LETTERS and word[:-2] in known:
        return [word[:-2], word[-2:]]
    return [word]


def corner_in(words: list[str]) -> str:
    """Return the corner or the axle that words name; empty if none.

    >>> corner_in(["front", "left", "damper"]), corner_in(["susp", "hr"]), corner_in(["fork"]), corner_in(["strut"])
    ('front_left', 'rear_right', 'front', '')
    """
    end = next((_ENDS[word] for word in words if word in _ENDS), "")
    side = next((_SIDES[word] for word in words if word in _SIDES), "")
    if not side and end and "r" in words:
        side = "right"
    if end and side:
        return f"{end}_{side}"
    letters = next((_CORNER_LETTERS[word] for word in words if word in _CORNER_LETTERS), "")
    if not letters and words[-2:] in (["r", "l"], ["r", "r"]):
        letters = _CORNER_LETTERS["".join(words[-2:])]
    return letters or end


def corner_named(text: str, where: str) -> str:
    """Return the corner, axle or damper that an option names.

    >>> corner_named("FL", "channels"), corner_named("rear", "motion_ratio"), corner_named("damper", "channels")
    ('front_left', 'rear', 'damper')
    """
    named = corner_in(words_of(text)) or (ALONE if words_of(text) == [ALONE] else "")
    if not named:
        raise unknown(text, (*CORNERS, *AXLES, ALONE), what="corner", where=where)
    return named


def match_of(name: str, unit: str) -> Match | None:
    """Return what a channel is, from its name and its unit; None if it is no motion of a damper or wheel.

    >>> match_of("LFshockVel", "m/s").channel, match_of("Wheel Speed FL", "km/h")
    ('front_left.damper.velocity', None)
    """
    words = words_of(name)
    known = set(words)
    if known & _OTHERS or any(word in ("histo", "raw") for word in words):
        return None
    is_damper = bool(known & _DAMPER) or any("dampfer" in word or "shock" in word for word in words)
    is_suspension = bool(known & _SUSPENSION)
    is_wheel = bool(known & _WHEEL)
    says_travel = bool(known & _TRAVEL)
    if not (is_damper or is_suspension or (is_wheel and says_travel) or "federweg" in known):
        return None
    is_velocity = is_unit_of(unit, "m/s") if unit else bool(known & _VELOCITY)
    electrical = unit if unit and _is_electrical(unit) else ""
    if unit and not (is_velocity or is_unit_of(unit, "m") or electrical):
        return None
    place: Place = "wheel" if is_wheel and not (is_damper or is_suspension) else "damper"
    score = (
        int(not electrical),
        int(bool(unit)),
        int(is_damper),
        int(is_suspension),
        int(says_travel or is_velocity),
        -len(words),
    )
    return Match(corner_in(words), name, is_velocity, place, electrical, not unit, score)


def _is_electrical(unit: str) -> bool:
    return unit.lower() in ("count", "counts", "lsb", "digits", "bits") or any(
        is_unit_of(unit, si) for si in ("V", "A")
    )


def guess_channels(columns: Iterable[tuple[str, str]]) -> dict[str, Match]:
    """Guess the travel and velocity of each corner from names and units; by the name of the channel.

    A damper is preferred to a suspension, and both to a wheel. Channels without a corner are used if no channel has
    one: the only one is the ``damper``; a fork and a shock are the front and the rear of a bicycle.

    >>> list(guess_channels([("Damper FL", "mm"), ("Damper FR", "mm"), ("Wheel Speed FL", "km/h")]))
    ['front_left.damper.travel', 'front_right.damper.travel']
    >>> list(guess_channels([("fork", "mm"), ("shock", "mm")])), list(guess_channels([("strut.deflection", "m")]))
    (['front.damper.travel', 'rear.damper.travel'], ['damper.damper.travel'])
    """
    given = list(columns)
    matches = [match for name, unit in given if (match := match_of(name, unit))]
    placed = [match for match in matches if match.corner]
    bare = [match for match in matches if not match.corner]
    if {match.corner for match in placed} == {"front"}:
        placed += [_at(match, "rear") for match in bare]
    elif not placed:
        placed = [_at(match, ALONE) for match in bare]
    if any(match.corner in CORNERS for match in placed):
        placed = [match for match in placed if match.corner in CORNERS]
    best: dict[tuple[str, bool], Match] = {}
    for match in placed:
        known = best.get((match.corner, match.is_velocity))
        if known is None or match.score > known.score:
            best[match.corner, match.is_velocity] = match
    order = (*CORNERS, *AXLES, ALONE)
    chosen = sorted(best.values(), key=lambda match: (match.is_velocity, _rank(match, order)))
    return {match.channel: match for match in chosen}


def _rank(match: Match, order: tuple[str, ...]) -> int:
    return order.index(match.corner) if match.corner in order else len(order)


def _at(match: Match, corner: str) -> Match:
    return Match(
        corner,
        match.column,
        match.is_velocity,
        match.place,
        match.electrical,
        match.lacks_unit,
        match.score,
    )


def counter_in(columns: Iterable[tuple[str, str]], kind: str) -> str:
    """Return the column that counts laps or sectors; empty if there is none.

    >>> counter_in([("Lap Time", "s"), ("Lap Number", "")], "lap"), counter_in([("Sector", "")], "lap")
    ('Lap Number', '')
    """
    words = _LAPS if kind == "lap" else _SECTORS
    for name, unit in columns:
        named = set(words_of(name))
        if named & words and named <= words | _NUMBERS and unit in ("", "1", "counts", "count"):
            return name
    return ""


def speed_in(columns: Iterable[tuple[str, str]]) -> str:
    """Return the column of the car's speed; empty if there is none.

    >>> speed_in([("Wheel Speed FL", "km/h"), ("Ground Speed", "km/h")]), speed_in([("Damper Speed FL", "mm/s")])
    ('Ground Speed', '')
    """
    named = [
        (_SPEEDS.index(" ".join(words_of(name))), name)
        for name, unit in columns
        if is_unit_of(unit, "m/s") and " ".join(words_of(name)) in _SPEEDS
    ]
    return min(named)[1] if named else ""


_SPEEDS = (
    "body speed",
    "ground speed",
    "vehicle speed",
    "car speed",
    "speed",
    "gps speed",
    "corr speed",
    "velocity",
    "v",
    "geschwindigkeit",
    "fahrgeschwindigkeit",
)


def by_corner(
    given: Mapping[str, float] | float | None, corners: Iterable[str], where: str
) -> dict[str, float]:
    """Return a number for each corner: given for all, an axle or a corner; the corner's own counts first."""
    if given is None:
        return {}
    if not isinstance(given, Mapping):
        return dict.fromkeys(corners, float(given))
    named = {
        "all" if str(name).lower() == "all" else corner_named(str(name), where): float(value)
        for name, value in given.items()
    }
    values = {}
    for corner in corners:
        for key in (corner, corner.partition("_")[0], "all"):
            if key in named:
                values[corner] = named[key]
                break
    return values
