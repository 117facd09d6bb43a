"""Readers of points: table rows, nested keys of YAML and JSON, and the front view of VSUSP."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import numpy as np

from jounce.core.description import is_nested_deeply
from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.types import Array

_DEEPEST = 20  # maximum nesting of keys
_KEY = re.compile(r"""(?:"([^"]*)"\s*|'([^']*)'\s*|([^:#{}\[\]]++)):(?:\s+(.*))?$""")
_ITEM = re.compile(r"(\s*)-\s+(.*)$")
_COMMENT = re.compile(r"(?<!\s)\s+#.*$")
LONGEST_LINE = 2000  # characters: on hostile lines the patterns take 0.1 s here, and 13 s on lines ten times as long
_FLOW = re.compile(r"\{(.*)\}|\[(.*)\]")
_VSUSP = re.compile(r"\b(front|rear)\{([^{}]*)\}")
_MICRONS = 1e-6  # m: unit of all numbers in VSUSP
_ARM_SPAN = 0.3  # of the lower arm's length: from the middle of an arm to its pivots, which a front view does not show
AXLE_END = "axle end"
"""Row name of a second point on the wheel's axis, which defines camber and toe."""
_SIZES = ("rim_diameter", "aspect_ratio", "section_width")
_MOUNTS = {"lower_wishbone": "lower_arm", "upper_wishbone": "upper_arm", "upright": "upright"}


@dataclass(frozen=True)
class PointRow:
    """Point as written: name, coordinates and location in the file."""

    name: str
    place: Array
    where: str


@dataclass
class PointTable:
    """Contents of a file: rows, the unit it names, and lines with numbers that are not points.

    A row named `AXLE_END` is a point on the wheel's axis. ``radius`` is the distance from wheel centre to road (m), by
    axle if the file has two; ``carrier`` is the body that carries strut or push rod. ``estimated`` are hardpoints not
    in the file, explained in ``notes``.
    """

    file: Path
    rows: list[PointRow] = field(default_factory=list)
    unit: str = ""
    unread: list[tuple[str, list[str]]] = field(
        default_factory=list
    )  # where, and the cells of the line
    radius: dict[str, float] = field(default_factory=dict)
    carrier: str = ""
    notes: list[Finding] = field(default_factory=list)
    estimated: list[str] = field(default_factory=list)


# --- nested keys


class _TwiceError(Exception):
    """Duplicate key."""


def _require_unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    table: dict[str, Any] = {}
    for key, value in pairs:
        if key in table:
            raise _TwiceError(key)
        table[key] = value
    return table


def parse_nested(text: str) -> dict[str, Any] | None:
    r"""Parse a JSON object or plain YAML (no anchors, no multi-line strings); return None for other text.

    >>> parse_nested("a:\n  b: {x: 1, y: 2}\n  c:\n    - 3\n    - 4  # four\n")
    {'a': {'b': {'x': '1', 'y': '2'}, 'c': ['3', '4']}}
    >>> parse_nested("name, x, y, z")
    """
    if text.lstrip().startswith("{"):
        try:
            keys = json.loads(text, object_pairs_hook=_require_unique)
        except (ValueError, RecursionError):
            return None
        return keys if isinstance(keys, dict) else None
    root: dict[str, Any] = {}
    open_: list[tuple[int, Any, str]] = [
        (-1, root, "")
    ]  # indent, what is filled, key in the one above
    for line in text.splitlines():
        if len(line) > LONGEST_LINE:
            return None
        bare = _COMMENT.sub("", line).rstrip()
        if not bare.strip() or bare.lstrip().startswith("#") or bare.strip() in ("---", "..."):
            continue
        indent = len(bare) - len(bare.lstrip())
        while len(open_) > 1 and indent <= open_[-1][0]:
            open_.pop()
        here = open_[-1][1]
        if match := _ITEM.match(bare):
            above = open_[-2][1] if len(open_) > 1 else None
            if isinstance(here, dict) and not here and isinstance(above, dict):
                here = above[open_[-1][2]] = []
                open_[-1] = (open_[-1][0], here, open_[-1][2])
            if not isinstance(here, list):
                return None
            here.append(_value(match[2]))
            continue
        match = _KEY.match(bare.lstrip())
        if match is None or not isinstance(here, dict) or len(open_) > _DEEPEST:
            return None
        key, value = (match[1] or match[2] or match[3] or "").strip(), (match[4] or "").strip()
        if key in here:
            raise _TwiceError(key)
        here[key] = _value(value) if value else {}
        if not value:
            open_.append((indent, here[key], key))
    return root or None


def _value(text: str) -> Any:
    """Parse a flow sequence or mapping, or text without its quotes."""
    if flow := _FLOW.fullmatch(text):
        parts = [
            part.strip()
            for part in (flow[1] if flow[1] is not None else flow[2]).split(",")
            if part.strip()
        ]
        if flow[1] is None:
            return [part.strip("\"'") for part in parts]
        pairs = [part.partition(":") for part in parts]
        return {key.strip(" \"'"): value.strip(" \"'") for key, _, value in pairs}
    return text.strip("\"'")


def from_nested(file: Path, text: str) -> PointTable | None:
    """Return the points of nested keys: all keys with x, y and z, or with three numbers; None without points.

    A file of suspension-explorer also defines unit, side, the wheel's axis and its tyre.
    """
    try:
        keys = parse_nested(text)
    except _TwiceError as error:
        raise DescriptionError(
            Phrase("{error} is given twice", error=str(error)),
            where=str(file),
            allowed="each point once",
        ) from None
    if keys is None or is_nested_deeply(keys):
        return None
    table = PointTable(file, unit=_text(keys.get("units", keys.get("unit"))))
    side = _text(keys.get("side"))
    table.rows = [
        PointRow(
            f"{side} {name}" if side and not name.startswith(("left ", "right ")) else name,
            place,
            f"{file}: {name}",
        )
        for name, place in _places(file, keys, "")
    ]
    if not table.rows:
        return None
    for row in [row for row in table.rows if row.name.endswith("axle_outboard")]:
        _add_wheel(table, keys, row)
    table.carrier = _MOUNTS.get(_text(_deep(keys, "mount")), "")
    return table


def _places(file: Path, keys: dict[str, Any], above: str) -> Iterator[tuple[str, Array]]:
    for key, value in keys.items():
        name = f"{above} {key}".strip() if above in ("left", "right") else key
        parts = [value.get(axis) for axis in "xyz"] if isinstance(value, dict) else value
        if isinstance(value, dict) and None not in parts and not all(map(_is_number, parts)):
            cells = ", ".join(map(str, parts))
            raise DescriptionError(
                "a point without three coordinates",
                where=f"{file}: {name}",
                found=cells,
                allowed="numbers, 12.5",
            )
        if isinstance(parts, list) and len(parts) == 3 and all(_is_number(part) for part in parts):
            if "cg" not in name.lower().split("_"):
                yield name, np.array([float(part) for part in parts])
        elif isinstance(value, dict):
            yield from _places(file, value, key)


def _is_number(value: Any) -> bool:
    try:
        return not isinstance(value, bool) and bool(np.isfinite(float(value)))
    except (TypeError, ValueError):
        return False


def _text(value: Any) -> str:
    return value.strip().lower() if isinstance(value, str) else ""


def _deep(keys: dict[str, Any], name: str) -> Any:
    """Return the first value of a key at any level."""
    if name in keys:
        return keys[name]
    return next(
        (
            inner
            for value in keys.values()
            if isinstance(value, dict) and (inner := _deep(value, name)) is not None
        ),
        None,
    )


def _add_wheel(table: PointTable, keys: dict[str, Any], outer: PointRow) -> None:
    """Add wheel centre and axle from two points, and the tyre radius."""
    begin = outer.name.removesuffix("axle_outboard")
    inner = next((row for row in table.rows if row.name == f"{begin}axle_inboard"), None)
    if inner is None:
        return
    table.rows = [row for row in table.rows if row not in (inner, outer)]
    along = outer.place - inner.place
    if not np.any(along):
        raise DescriptionError(
            "the two points of the axle coincide", where=outer.where, found=outer.place.tolist()
        )
    along = along / np.linalg.norm(along)
    offset, *sizes = (_read_size(table.file, keys, word) for word in ("offset", *_SIZES))
    centre = outer.place - (offset or 0.0) * along
    table.rows.append(PointRow(f"{begin}wheel_centre", centre, outer.where))
    table.rows.append(PointRow(f"{begin}{AXLE_END}", centre + along, outer.where))
    rim, aspect, width = sizes
    if rim is not None and aspect is not None and width is not None:
        table.radius[""] = (
            0.5 * rim * 0.0254 + aspect * width * 1e-3
        )  # inches and millimetres, as on the tyre


def _read_size(file: Path, keys: dict[str, Any], word: str) -> float | None:
    """Return a dimension of the wheel, or None if it is not in the file."""
    value = _deep(keys, word)
    if value is not None and not _is_number(value):
        raise DescriptionError(
            "not a number", where=f"{file}: {word}", found=value, allowed="a number, 12.5"
        )
    return None if value is None else float(value)


# --- VSUSP


def from_vsusp(file: Path, text: str) -> PointTable | None:
    """Return the points of a VSUSP double wishbone from the project URL, or None for other text.

    VSUSP describes only the front view: the knuckle is rotated until the tyre touches the road. Arm pivots are placed
    in front of and behind their drawn positions, and a tie rod without bump steer is added.
    """
    blocks = {
        name: dict(pair.partition(":")[::2] for pair in body.split("|"))
        for name, body in _VSUSP.findall(unquote(text))
    }
    if not any("frame.center_to_upper_mount_x" in block for block in blocks.values()):
        return None
    table = PointTable(file, unit="m")
    for axle, block in blocks.items():
        _add_front_view(table, axle, block)
    table.notes.append(finding("parts.import_front_view", str(file)))
    return table


def _add_front_view(table: PointTable, axle: str, block: dict[str, str]) -> None:
    from scipy.optimize import brentq

    def of(key: str, default: float | None = None) -> float:
        text = block.get(key)
        where = f"{table.file}: {axle}: {key}"
        if text is None and default is None:
            raise DescriptionError(
                "the number is missing", where=where, allowed="a double wishbone from VSUSP"
            )
        if text is not None and not _is_number(text):
            raise DescriptionError("not a number", where=where, found=text)
        return _MICRONS * float(text) if text is not None else float(default or 0.0)

    bottom = of("frame.bottom_y")
    inner = {
        arm: np.array(
            [of(f"frame.center_to_{arm}_mount_x"), bottom + of(f"frame.bottom_to_{arm}_mount_y")]
        )
        for arm in ("lower", "upper")
    }
    length = {arm: of(f"control_arms.{arm}_length") for arm in inner}
    ball = {
        arm: np.array([-of(f"knuckles.hub_to_{arm}_x"), s * of(f"knuckles.hub_to_{arm}_y")])
        for arm, s in (("lower", -1.0), ("upper", 1.0))
    }
    radius = 0.5 * of("tires.diameter_expl") - of("tires.compression", 0.0)
    wheel = np.array([-of("wheels.offset", 0.0), 0.0])
    between = ball["upper"] - ball["lower"]
    reach = float(np.linalg.norm(between))

    def pose(angle: float) -> tuple[Array, Array, Array] | None:
        """Return lower and upper ball joint and hub at a lower arm angle; None if the knuckle does not reach."""
        low = inner["lower"] + length["lower"] * np.array([np.cos(angle), np.sin(angle)])
        apart = inner["upper"] - low
        distance = float(np.linalg.norm(apart))
        along = (reach**2 + distance**2 - length["upper"] ** 2) / (2.0 * distance)
        if reach**2 < along**2:
            return None
        unit = apart / distance
        outward = np.array(
            [unit[1], -unit[0]]
        )  # the upper ball joint is outboard of the line to its pivot
        high = low + along * unit + np.sqrt(reach**2 - along**2) * outward
        turn = np.arctan2(*(high - low)[::-1]) - np.arctan2(*between[::-1])
        turned = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
        return (
            low,
            high,
            np.column_stack(
                [low - turned @ ball["lower"], turned @ wheel, turned @ np.array([0.0, -radius])]
            ),
        )

    def height(angle: float) -> float:
        solution = pose(angle)
        return float("nan") if solution is None else float(solution[2].sum(axis=1)[1])

    angles = np.linspace(-1.0, 1.0, 401)
    heights = np.array([height(angle) for angle in angles])
    crossing = np.flatnonzero(
        np.isfinite(heights[:-1] * heights[1:]) & (heights[:-1] <= 0.0) & (heights[1:] > 0.0)
    )
    if not len(crossing):
        raise DescriptionError(
            "the arms and the knuckle do not meet with the tyre on the road", where=f"{table.file}: {axle}",
            allowed="a double wishbone from VSUSP",
        )  # fmt: skip
    solution = pose(brentq(height, angles[crossing[0]], angles[crossing[0] + 1], xtol=1e-14))
    assert solution is not None
    low, high, hub = solution
    centre = hub[:, 0] + hub[:, 1]
    span = _ARM_SPAN * length["lower"]
    places = {
        "lower_ball_joint": (0.0, low),
        "upper_ball_joint": (0.0, high),
        "wheel_centre": (0.0, centre),
    }
    places[AXLE_END] = (0.0, centre + np.array([-hub[1, 2], hub[0, 2]]))
    for arm in ("lower", "upper"):
        places |= {
            f"{arm}_arm_{end}": (s * span, inner[arm])
            for end, s in (("front", 1.0), ("rear", -1.0))
        }
    places |= {"tie_rod_inner": (-0.5 * span, inner["lower"]), "tie_rod_outer": (-0.5 * span, low)}
    # The tie rod is a copy of the lower arm, behind it: it causes no bump steer.
    table.rows += [
        PointRow(f"{axle} {name}", np.array([x, *place]), f"{table.file}: {axle}")
        for name, (x, place) in places.items()
    ]
    table.radius[axle] = radius
    table.estimated = ["hardpoints"]
