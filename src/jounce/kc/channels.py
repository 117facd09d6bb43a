"""Columns of measured K&C sheets: what a heading says, and the map of a rig that says the rest."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

from pydantic import model_validator

from jounce.core.columns import Column, names_time
from jounce.core.description import Description, read_description
from jounce.core.errors import RecordingError, nearest
from jounce.core.misplaced import error_at
from jounce.core.text import without_accents
from jounce.core.units import Number, PositiveLength, is_unit_of
from jounce.kc.conventions import CONVENTIONS, SignConvention
from jounce.kc.tests import TESTS
from jounce.kc.vocabulary import AXLE_QUANTITIES, QUANTITIES, WHEEL_QUANTITIES

SCHEMA = "jounce.kc-map/1"
Wheel = Literal["left", "right"]


class KcColumn(Description):
    """What one column of a rig's files holds.

    In a file it is a table, or a short text: ``"left.toe [deg]"``, with a minus in front for the opposite sign.

    Attributes
    ----------
    quantity : str
        Quantity such as ``toe``, ``lateral_force``, ``wheel_travel``, ``rack_travel``; empty for a column that is not
        used.
    wheel : {"left", "right"} or None
        Wheel that it belongs to; None for quantities of the axle.
    unit : str
        Unit of its numbers; empty: that of its heading.
    sign : {1, -1}
        -1 if its readings have the opposite sign of the sheet's convention.
    offset : float
        Reading at zero, subtracted before the sign is applied, in the unit of the column.
    test : str or None
        The only test in which the column has this meaning; None: every test.
    """

    quantity: str = ""
    wheel: Wheel | None = None
    unit: str = ""
    sign: Literal[1, -1] = 1
    offset: Number = 0.0
    test: str | None = None

    @model_validator(mode="before")
    @classmethod
    def _from_text(cls, value: Any) -> Any:
        return _column_keys(value) if isinstance(value, str) else value

    @model_validator(mode="after")
    def _is_known(self) -> KcColumn:
        if self.quantity and self.quantity not in QUANTITIES:
            raise error_at(
                ("quantity",),
                "unknown quantity",
                found=self.quantity,
                allowed=", ".join(QUANTITIES),
                hint=nearest(self.quantity, QUANTITIES),
            )
        if self.wheel is not None and self.quantity in AXLE_QUANTITIES:
            raise error_at(("wheel",), "this quantity belongs to no wheel", found=self.quantity)
        _check_test(self.test, ("test",))
        return self


_SHORT = re.compile(r"(-?)\s*(?:(left|right)\.)?(\w*)\s*(?:\[(.*)\])?")


def _column_keys(text: str) -> dict[str, Any]:
    match = _SHORT.fullmatch(text.strip())
    if match is None:
        raise error_at((), "not a column", found=text, allowed='"left.toe [deg]"')
    keys = {"sign": -1 if match[1] else 1, "quantity": match[3]}
    return keys | {"wheel": match[2], "unit": match[4] or ""}


def _check_test(name: str | None, path: tuple[str, ...]) -> None:
    if name is not None and name not in TESTS:
        raise error_at(
            path,
            "unknown test",
            found=name,
            allowed=", ".join(TESTS),
            hint=nearest(name, TESTS),
        )


class KcMap(Description):
    """How the files of a rig are to be read (schema ``jounce.kc-map/1``).

    Attributes
    ----------
    convention : str, SignConvention or None
        Signs of the readings: a name such as ``"iso"`` or ``"j670e"``, or a table of directions. None: what the files
        state, else ISO 8855.
    track : float or None
        Distance of the contact points, m, for the roll angle of pads.
    gauge_base : float or None
        Length over which toe is measured as a distance, m: between two dial gauges, or the diameter of the rim.
    wheel : {"left", "right"} or None
        Wheel of columns that name none.
    wheels : mapping
        The same for each file, sheet or section, by its name: ``{"Run 07" = "left", "Run 08" = "right"}``.
    axle : {"front", "rear"} or None
        Axle to read, if the files hold both.
    tests : mapping
        Test of each file, sheet or section, by its name: ``{"Run 07" = "lateral-opposed"}``.
    columns : mapping
        Meaning of columns by their headings. Other columns are recognised by their headings.
    """

    convention: str | SignConvention | None = None
    track: PositiveLength | None = None
    gauge_base: PositiveLength | None = None
    wheel: Wheel | None = None
    wheels: Mapping[str, Wheel] = {}
    axle: Literal["front", "rear"] | None = None
    tests: Mapping[str, str] = {}
    columns: Mapping[str, KcColumn] = {}

    @model_validator(mode="before")
    @classmethod
    def _without_schema(cls, value: Any) -> Any:
        return (
            {k: v for k, v in value.items() if k != "schema"}
            if isinstance(value, Mapping)
            else value
        )

    @model_validator(mode="after")
    def _is_known(self) -> KcMap:
        if isinstance(self.convention, str) and self.convention not in CONVENTIONS:
            allowed = ", ".join(CONVENTIONS)
            raise error_at(
                ("convention",), "unknown convention", found=self.convention, allowed=allowed
            )
        for title, test in self.tests.items():
            _check_test(test, ("tests", title))
        return self

    def column(self, column: Column, test: str | None = None) -> KcColumn | None:
        """Return the entry of a column; None if it has none, or only one for another test."""
        for name in (column.written, column.label, column.name):
            entry = self.columns.get(name)
            if entry is not None and (entry.test is None or test is None or entry.test == test):
                return entry
        return None


def as_map(given: KcMap | Mapping[str, Any] | Path | str | None) -> KcMap:
    """Return a map from itself, its keys, its columns alone, or its file."""
    if given is None:
        return KcMap()
    if isinstance(given, KcMap):
        return given
    if isinstance(given, str | Path):
        return read_description(KcMap, given, SCHEMA)[0]
    keys = dict(given)
    if not keys.keys() <= {*KcMap.model_fields, "schema"}:
        keys = {"columns": keys}
    return KcMap.from_table(keys, where="channels")


@dataclass(frozen=True)
class Heading:
    """Meaning of a heading: quantity, wheel and axle (empty if it names none), and unit (empty if it has none)."""

    quantity: str
    wheel: str
    axle: str
    unit: str


_LEFT = {"l", "left", "lh", "lhs", "li", "links", "linke", "linkes", "lf", "fl", "lr", "rl", "vl", "hl"}  # fmt: skip
_RIGHT = {"r", "right", "rh", "rhs", "rechts", "rechte", "rechtes", "rf", "fr", "rr", "vr", "hr"}
_FRONT = {"front", "lf", "fl", "rf", "fr", "vl", "vr", "vorn", "vorne"}
_REAR = {"rear", "lr", "rl", "rr", "hl", "hr", "hinten"}
_NOISE = {"actual", "measured", "meas", "change", "delta", "value", "signal", "channel", "wheel", "rad", "disp",
          "displacement", "angle", "winkel", "position", "pos", "movement"}  # fmt: skip
"""Words that do not change what a heading means, left out if the heading is not recognised with them."""
_UNIT_WORDS = ("kN", "N", "mm", "m", "deg", "rad", "Nm", "kNm", "°", "mrad", "min", "lbf", "in")

_POINT = (
    r"(?:cent(?:er|re) (?:of )?(?:tyre|tire) contact|contact (?:patch|point|cent(?:er|re))|patch|cp|tcp"
    r"|(?:rad)?aufstandspunkt)"
)
_CENTRE = r"(?:wheel cent(?:er|re)|wc|hub cent(?:er|re)|spindle|radmitte|radmittelpunkt|wheel)"
_AXES = {
    "x": r"(?:x|longitudinal|fore aft|langs)",
    "y": r"(?:y|lateral|quer)",
    "z": r"(?:z|vertical|vert)",
}
_MOVED = r"(?: (?:displacement|disp|position|pos|movement|travel))?"
_PATTERNS: list[tuple[str, str]] = [
    (r"(?:toe )?(?:gauge )?front(?: toe)? gauge|gauge front|toe (?:gauge )?front", "toe_front_gauge"),
    (r"(?:toe )?(?:gauge )?rear(?: toe)? gauge|gauge rear|toe (?:gauge )?rear", "toe_rear_gauge"),
    (r"(?:toe )?gauge (?:base|distance|spacing)|base(?: length)?|messbasis|rim diameter", "gauge_base"),
    (r"(?:hand ?wheel|steering(?: wheel)?|sw|lenkrad) ?(?:torque|moment)|lenkmoment|swt", "handwheel_torque"),
    (r"(?:hand ?wheel|steering wheel|sw|lenkrad)(?: ?(?:angle|winkel))?|swa|steering angle", "handwheel_angle"),
    (r"rack (?:force|load)|zahnstangen ?kraft", "rack_force"),
    (r"rack(?: (?:travel|displacement|position|disp|pos|stroke))?|zahnstangen? ?(?:weg|hub)?", "rack_travel"),
    (r"brak(?:e|ing) force|brems ?kraft", "brake_force"),
    (r"mz|(?:self )?align(?:ing)? (?:moment|torque)|ruckstell ?moment", "aligning_moment"),
    (r"spring (?:force|load)|feder ?kraft", "spring_force"),
    (r"(?:wheel|vertical|contact|tyre|tire|normal) load|normal force|rad ?last|load", "wheel_load"),
    (r"fz|vertical force|z force|force z", "vertical_force"),
    (r"fy|lateral (?:force|load)|side force|cornering force|y force|force y|(?:seiten|quer) ?kraft", "lateral_force"),
    (r"fx|longitudinal (?:force|load)|x force|force x|langs ?kraft", "longitudinal_force"),
    *((rf"{_POINT} {axis}{_MOVED}|{axis} {_POINT}{_MOVED}", f"contact_point_{name}") for name, axis in _AXES.items()),
    (r"(?:pad|table|platform|platten|plattform) ?(?:height|hohe|z|travel|position|displacement)", "pad_height"),
    *((rf"{_CENTRE} {axis}{_MOVED}|{axis} {_CENTRE}{_MOVED}", f"wheel_centre_{name}") for name, axis in _AXES.items()),
    (r"(?:(?:wheel|bump|jounce|vertical) )?(?:travel|deflection|stroke)|wheel displacement|jounce|bump|"
     r"rad ?hub|rad ?weg|einfederung|hub", "wheel_travel"),
    (r"roll(?: angle)?|wank ?winkel", "roll_angle"),
    (r"(?:road )?wheel(?: steer)? angle|steer(?: angle)?|(?:rad ?)?lenk ?winkel|einschlag ?(?:winkel)?", "steer"),
    (r"toe(?: in)?(?: angle)?|(?:vor)?spur ?(?:winkel)?", "toe"),
    (r"camber(?: angle)?|sturz ?(?:winkel)?", "camber"),
    (r"cast[eo]r(?: angle)?|nachlauf ?winkel", "caster"),
    (r"(?:wheel )?(?:spin|wind ?up)(?: angle)?", "spin"),
    (r"input", "input"),
]  # fmt: skip
"""Whole headings without wheel, axle and unit, in order; the first one that fits decides."""
_COMPILED = [(re.compile(pattern), quantity) for pattern, quantity in _PATTERNS]
_COUNTERS = {"sample", "samples", "index", "no", "nr", "number", "point", "step", "cycle", "row"}


_LOAD_OF_A_PART = re.compile(r"[\w.\[\]]+\.(?:(?:force|torque)(?:_[xyz])?|length|twist)")
"""Headings of bushings, links and springs in jounce's own files, such as ``left.lower_arm_front.force_y``."""


def is_counter(name: str) -> bool:
    """Whether a heading names time or a running number, which a sheet does not need."""
    return names_time(name) or name.strip().strip(".").lower() in _COUNTERS


def read_heading(name: str, unit: str = "") -> Heading | None:
    """Recognise a heading; None if it is not known.

    >>> read_heading("LF_Camber", "deg")
    Heading(quantity='camber', wheel='left', axle='front', unit='deg')
    >>> read_heading("Fy Left N"), read_heading("Handwheel Angle").quantity, read_heading("Sturz links").wheel
    (Heading(quantity='lateral_force', wheel='left', axle='', unit='N'), 'handwheel_angle', 'left')
    >>> read_heading("left.toe", "rad").wheel, read_heading("left.lower_arm_front.force_y", "N")
    ('left', None)
    """
    if _LOAD_OF_A_PART.fullmatch(name):
        return None
    words = _words(_own_part(name))
    if not unit and len(words) > 1 and words[-1] in _UNIT_WORDS:
        inner = read_heading(" ".join(words[:-1]), words[-1])
        if inner is not None and _fits(inner):
            return inner
    plain = [without_accents(word) for word in words]
    is_left, is_right = bool(_LEFT & {*plain}), bool(_RIGHT & {*plain})
    if is_left and is_right:
        return None
    gauge = _quantity(" ".join(word for word in plain if word not in (_LEFT | _RIGHT)))
    if gauge is not None and "gauge" in gauge:
        return Heading(gauge, _side(is_left, is_right), "", unit)
    quiet = [word for word in plain if word not in (_LEFT | _RIGHT | _FRONT | _REAR)]
    quantity = _quantity(" ".join(quiet)) or _quantity(
        " ".join(word for word in quiet if word not in _NOISE)
    )
    if quantity is None:
        return None
    if quantity in AXLE_QUANTITIES and (is_left or is_right):
        return None
    is_front, is_rear = bool(_FRONT & {*plain}), bool(_REAR & {*plain})
    axle = "" if is_front == is_rear else "front" if is_front else "rear"
    return Heading(quantity, _side(is_left, is_right), axle, unit)


def _own_part(name: str) -> str:
    """Return a heading without the names of structs before it, but with its wheel."""
    if not re.fullmatch(r"[\w.]+", name):
        return name
    *above, own = name.split(".")
    return f"{above[-1]} {own}" if above and above[-1] in ("left", "right") else own


def _words(text: str) -> list[str]:
    """Split a heading at signs, and where a small letter or an abbreviation of a wheel precedes a capital."""
    text = text.replace("_", " ")
    text = re.sub(r"(?<=[a-zäöü])(?=[A-ZÄÖÜ])|(?<=[A-Z]{2})(?=[A-Z][a-z])", " ", text)
    text = re.sub(r"(?i)\b(F|M)([xyz])(L|R|F|LF|RF|LR|RR|FL|FR|RL)\b", r"\1\2 \3", text)
    text = re.sub(r"(?i)\b(WC|CP|TCP)([xyz])(L|R|)\b", r"\1 \2 \3", text)
    return re.findall(r"[^\W_]+|°|#", text)


def _quantity(text: str) -> str | None:
    return next((quantity for pattern, quantity in _COMPILED if pattern.fullmatch(text)), None)


def _side(is_left: bool, is_right: bool) -> str:
    return "left" if is_left else "right" if is_right else ""


def _fits(heading: Heading) -> bool:
    si = QUANTITIES[heading.quantity].unit
    return is_unit_of(heading.unit, si) or (
        heading.quantity == "toe" and heading.unit in ("mm", "in")
    )


def needs_wheel(quantity: str) -> bool:
    """Whether a quantity belongs to a wheel."""
    return quantity in WHEEL_QUANTITIES


def refuse_axles(where: str) -> RecordingError:
    """Return the error for a sheet with the columns of both axles."""
    return RecordingError(
        "the columns of two axles",
        where=where,
        allowed="one axle",
        hint='Choose it: axle="front" or axle="rear".',
    )
