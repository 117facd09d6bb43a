"""Data of a page's viewers: curves over time and mechanisms, packed compactly into the page.

Numbers are quantised to sixteen bits between the minimum and maximum of their curve. The error is below 1/130 000 of
that range, which no screen resolves, and zero at zero. Tables use the original numbers.
"""

from __future__ import annotations

import base64
import json
import zlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from hashlib import blake2b
from importlib import resources
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from jounce.core.types import Array
from jounce.plots.mechanisms.drawing import COILS, DAMPER_BODY
from jounce.plots.thinning import thin
from jounce.report.chart import LINES, Panel, Series

if TYPE_CHECKING:
    from jounce.plots.mechanisms.scene import Poses, Roadway
    from jounce.plots.mechanisms.scene import Scene as Drawing


Whole: TypeAlias = NDArray[np.int64]


@dataclass(frozen=True)
class Curve:
    """One curve: label, role (which sets the colour), and values (n,) in the unit of its pane."""

    label: str
    role: str
    values: Array


@dataclass(frozen=True)
class Pane:
    """One quantity: channel name, description, display unit, curves, and whether it is shown initially."""

    name: str
    words: str
    unit: str
    curves: tuple[Curve, ...]
    shown: bool = True


@dataclass(frozen=True)
class PosedRig:
    """A 3-D rig with poses over wheel travel and its body at the design position, or with recorded poses.

    The ``travel`` of a motion refers to the variable by which ``poses`` are ordered.
    """

    drawing: Drawing
    poses: Poses
    rolls: bool = True
    """Whether the rig drives over a road, with unloaded tyre radius; on a plate it has the design radius."""
    other: PosedRig | None = None
    """The other side of an axle, with poses over the same variable."""


@dataclass(frozen=True)
class Motion:
    """Motion of a mechanism: heights and travel over time, shape (n,), m; ``load`` of the tyre in N.

    ``travel`` selects the pose of the mechanism, in the variable by which the poses are ordered.
    """

    mechanism: PosedRig
    body: Array
    travel: Array
    ground: Array
    load: Array
    road: Roadway | None = None
    speed: float = 0.0  # m/s


@dataclass(frozen=True)
class ViewerScene:
    """One selectable scene of a viewer.

    Attributes
    ----------
    name, label : str
        Identifier for links, and label in the selection.
    x : array (n,)
        Common axis of all curves, ascending.
    panes : tuple of Pane
        Panes, from top to bottom.
    note, tone : str
        Short note, e.g. a verdict, and its tone.
    spans : tuple of (float, float)
        Shaded parts of the axis.
    window : (float, float), optional
        Part of the axis shown initially.
    motion : Motion, optional
        Mechanism animated with the curves.
    """

    name: str
    label: str
    x: Array
    panes: tuple[Pane, ...]
    note: str = ""
    tone: str = "plain"
    spans: tuple[tuple[float, float], ...] = ()
    window: tuple[float, float] | None = None
    motion: Motion | None = None


@dataclass(frozen=True)
class Viewer:
    """Selectable scenes, one shown at a time, with toggles for curves: (role, label, shown initially).

    With ``stage``, the mechanism is the main subject and drawn large. ``slower`` is the initial slow-motion factor.
    """

    title: str
    scenes: tuple[ViewerScene, ...]
    roles: tuple[tuple[str, str, bool], ...]
    caption: str = ""
    words: str = "time"
    unit: str = "s"
    stage: bool = False
    slower: float | None = None


_LONGEST_TITLE = 62  # bold characters that fit across a panel


def _fitting(title: str) -> str:
    """Shorten a title by trailing words until it fits."""
    while len(title) > _LONGEST_TITLE and ", " in title:
        title = title.rpartition(", ")[0]
    return title if len(title) <= _LONGEST_TITLE else f"{title[: _LONGEST_TITLE - 1]}…"


def named_words(name: str, words: str) -> str:
    """Return a channel's name and quantity, or one of them if alike: ``sprung.az, vertical acceleration``.

    >>> named_words("motion_ratio", "motion ratio: spring over wheel"), named_words("sprung.z", "height")
    ('motion ratio: spring over wheel', 'sprung.z, height')
    """
    return words if words.startswith((name, name.replace("_", " "))) else f"{name}, {words}"


def scene_panels(
    scene: ViewerScene, words: str, unit: str, roles: Sequence[str] = ()
) -> tuple[Panel, ...]:
    """Return the initially shown curves of a scene as panels of a static figure, for some roles or all."""
    panes = [pane for pane in scene.panes if pane.shown] or list(scene.panes[:1])
    is_alone = (
        len(
            {
                curve.role
                for pane in panes
                for curve in pane.curves
                if not roles or curve.role in roles
            }
        )
        < 2
    )
    panels = []
    for k, pane in enumerate(panes):
        curves = [curve for curve in pane.curves if not roles or curve.role in roles]
        panels.append(
            Panel(
                tuple(
                    Series(
                        scene.x,
                        c.values,
                        c.role,
                        LINES.get(c.role, "line"),
                        "" if is_alone else c.label,
                    )
                    for c in curves
                ),
                f"{words} [{unit}]" if k == len(panes) - 1 else "",
                f"[{pane.unit or '–'}]",
                _fitting(named_words(pane.name, pane.words)),
                bands=tuple((low, high, "") for low, high in scene.spans),
                x_range=scene.window or (float(scene.x[0]), float(scene.x[-1])),
                width=500,
                height=180,
                is_first_on_top=len(curves) > 1 and curves[0].role == "after",
            )
        )
    return tuple(panels)


_MOST_SAMPLES = 20_000
"""Maximum samples of one curve; longer curves are thinned without losing peaks."""
_GAP = 65535


@dataclass
class PageArrays:
    """Collection of the arrays of a page, without duplicates."""

    arrays: list[dict[str, Any]] = field(default_factory=list)
    known: dict[bytes, int] = field(default_factory=dict)
    planes: list[bytes] = field(default_factory=list)
    length: int = 0

    def add(self, values: Array) -> int:
        """Pack an array, shape (n,); return its index."""
        values = np.ascontiguousarray(values, float)
        key = blake2b(values.tobytes(), digest_size=16).digest()
        if key not in self.known:
            self.known[key] = len(self.arrays)
            self.arrays.append(self._pack(values))
        return self.known[key]

    def _pack(self, values: Array) -> dict[str, Any]:
        n = len(values)
        steps = np.diff(values)
        if n > 1 and np.isfinite(steps).all() and np.ptp(steps) <= 1e-6 * abs(float(steps.mean())):
            even = [float(values[0]), float((values[-1] - values[0]) / (n - 1))]
            return {"n": n, "at": 0, "order": 0, "low": 0.0, "step": 0.0, "even": even}
        finite = np.isfinite(values)
        low, high = (
            (float(f(values[finite])) for f in (np.min, np.max)) if finite.any() else (0.0, 0.0)
        )
        step = (high - low) / (_GAP - 2) or 1.0
        if high > low:
            low = step * float(np.floor(low / step))  # makes 0 exactly representable
        whole = np.full(n, _GAP, np.int64)
        whole[finite] = np.round((values[finite] - low) / step)
        best = min(range(3), key=lambda order: _size(whole, order))
        folded = _fold_differences(whole, best)
        entry = {"n": n, "at": self.length, "order": best, "low": low, "step": step}
        self.planes += [
            (folded & 255).astype(np.uint8).tobytes(),
            (folded >> 8).astype(np.uint8).tobytes(),
        ]
        self.length += 2 * n
        return entry

    def text(self) -> str:
        """Return all arrays, deflated and base64-encoded."""
        return base64.b64encode(zlib.compress(b"".join(self.planes), 6)).decode()


def _fold_differences(whole: Whole, order: int) -> Whole:
    """Return differences of an order, modulo 2^16, with the sign in the lowest bit."""
    if order == 0:
        return whole
    differences = np.diff(whole, n=order, prepend=np.zeros(order, np.int64))
    wrapped: Whole = ((differences + 32768) & 65535) - 32768
    folded: Whole = ((wrapped << 1) ^ (wrapped >> 15)) & 65535
    return folded


def _size(whole: Whole, order: int) -> float:
    folded = _fold_differences(whole, order)
    return float(np.log2(1.0 + folded).mean()) if len(folded) else 0.0


@dataclass
class Straight:
    """Collection of the arrays of a response, uncompressed, for a page on the same machine."""

    arrays: list[dict[str, Any]] = field(default_factory=list)
    parts: list[bytes] = field(default_factory=list)
    length: int = 0

    def add(self, values: Array, form: str = "f8") -> int:
        """Add an array, shape (n,) or (n, 3), in 64 or (``"f4"``) 32 bits a number; return its index."""
        content = np.ascontiguousarray(values, f"<{form}").tobytes()
        content += bytes(-len(content) % 8)
        self.arrays.append({"n": values.size, "at": self.length, "form": form})
        self.parts.append(content)
        self.length += len(content)
        return len(self.arrays) - 1

    def add_places(self, values: Array) -> int:
        """Add the places of a mechanism that is drawn: 32 bits are finer than a screen."""
        return self.add(values, "f4")


def live_data(viewers: Sequence[Viewer]) -> dict[str, Any]:
    """Return the content of a page's viewers as plain data."""
    packed = PageArrays()
    content = _content(viewers, packed)
    return content | {"packed": packed.text()}


def live_bytes(viewers: Sequence[Viewer], more: Mapping[str, Any]) -> bytes:
    """Return the content of viewers and ``more`` as uncompressed bytes, for a page that updates often.

    Layout: length of the JSON part (four bytes, little-endian), JSON padded to a multiple of eight bytes, arrays.
    """
    straight = Straight()
    header = json.dumps(
        {**_content(viewers, straight), **more}, separators=(",", ":"), allow_nan=False
    ).encode()
    header += b" " * (-(len(header) + 4) % 8)
    return b"".join((len(header).to_bytes(4, "little"), header, *straight.parts))


def _content(viewers: Sequence[Viewer], packed: PageArrays | Straight) -> dict[str, Any]:
    mechanisms: dict[int, tuple[int, dict[str, Any]]] = {}

    def motion(shown_motion: Motion | None, keep: Whole) -> dict[str, Any] | None:
        if shown_motion is None:
            return None
        if id(shown_motion.mechanism) not in mechanisms:
            whole = mechanism_data(
                shown_motion.mechanism, packed.add_places if isinstance(packed, Straight) else None
            )
            mechanisms[id(shown_motion.mechanism)] = len(mechanisms), whole
        index, _ = mechanisms[id(shown_motion.mechanism)]
        road = shown_motion.road and {
            "x": np.round(1e3 * shown_motion.road.distance, 2).tolist(),
            "z": np.round(1e3 * shown_motion.road.height, 3).tolist(),
            "speed": 1e3 * shown_motion.speed,
        }
        tracks = {
            name: packed.add(1e3 * getattr(shown_motion, name)[keep])
            for name in ("body", "travel", "ground")
        }
        return {
            "mechanism": index,
            **tracks,
            "load": packed.add(shown_motion.load[keep]),
            "road": road,
        }

    def scene(viewer_scene: ViewerScene) -> dict[str, Any]:
        keep = _samples_for_page(viewer_scene)
        return {
            "name": viewer_scene.name,
            "label": viewer_scene.label,
            "note": viewer_scene.note,
            "tone": viewer_scene.tone,
            "x": packed.add(viewer_scene.x[keep]),
            "panes": [
                {
                    "name": pane.name,
                    "words": pane.words,
                    "unit": pane.unit,
                    "shown": pane.shown,
                    "curves": [
                        {
                            "label": curve.label,
                            "role": curve.role,
                            "y": packed.add(curve.values[keep]),
                        }
                        for curve in pane.curves
                    ],
                }
                for pane in viewer_scene.panes
            ],
            "spans": [list(span) for span in viewer_scene.spans],
            "window": None if viewer_scene.window is None else list(viewer_scene.window),
            "motion": motion(viewer_scene.motion, keep),
        }

    models = [
        {
            "title": viewer.title,
            "roles": [
                {"role": role, "label": label, "shown": shown}
                for role, label, shown in viewer.roles
            ],
            "scenes": [scene(viewer_scene) for viewer_scene in viewer.scenes],
            "x": {"words": viewer.words, "unit": viewer.unit},
            "stage": viewer.stage,
            "slower": viewer.slower,
        }
        for viewer in viewers
    ]
    return {
        "viewers": models,
        "mechanisms": [content for _, content in mechanisms.values()],
        "arrays": packed.arrays,
    }


def _samples_for_page(scene: ViewerScene) -> Whole:
    """Return the samples to include in the page: all, or for a long record those that preserve its peaks."""
    n = len(scene.x)
    if n <= _MOST_SAMPLES:
        return np.arange(n)
    curves = [curve.values for pane in scene.panes for curve in pane.curves]
    columns = max(_MOST_SAMPLES // (4 * max(len(curves), 1)), 500)
    index = np.arange(n, dtype=float)
    seen = [np.nan_to_num(values) for values in curves]
    return np.unique(
        np.concatenate([thin(index, y, 0.0, n - 1.0, columns)[0] for y in seen]).astype(int)
    )


def mechanism_data(posed: PosedRig, add: Callable[[Array], int] | None = None) -> dict[str, Any]:
    """Return a mechanism and its poses over travel as plain data in mm; with ``add``, positions are array indices."""
    placed = (lambda values: add(1e3 * values)) if add else _mm
    drawing, poses = posed.drawing, posed.poses
    order = np.argsort(poses.over)
    names = list(poses.points)
    index = {name: i for i, name in enumerate(names)}
    parts = [part for part in drawing.parts if all(name in index for name in part.points)]
    brackets = [b for b in drawing.brackets if {b.point, b.first, b.second} <= set(index)]
    return {
        "other": None if posed.other is None else mechanism_data(posed.other, add),
        "side": drawing.side,
        "travel": _mm(poses.over[order]),
        "names": names,
        "onBody": [name in drawing.on_body for name in names],
        "feet": [index[name] for name in names if name in drawing.feet],
        "points": [placed(poses.points[name][order]) for name in names],
        "spin": add(poses.spin_axis[order])
        if add
        else np.round(poses.spin_axis[order], 5).tolist(),
        "contact": placed(poses.contact[order]),
        "parts": [
            {
                "name": part.name,
                "words": part.words,
                "colour": part.colour,
                "plate": part.plate,
                "coil": part.coil,
                "points": [index[name] for name in part.points],
            }
            for part in parts
        ],
        "brackets": [
            [index[b.point], index[b.first], index[b.second], round(b.share, 4), b.colour]
            for b in brackets
        ],
        "strut": {
            "spring": drawing.spring and [index[name] for name in drawing.spring],
            "damper": drawing.damper and [index[name] for name in drawing.damper],
            "radius": _mm(np.array(drawing.coil_radius)),
            "tube": _mm(np.array(DAMPER_BODY * drawing.damper_length)),
            "coils": COILS,
            "colour": drawing.strut_colour,
        },
        "axis": None
        if drawing.steering_axis is None
        else [index[name] for name in drawing.steering_axis],
        "wheel": {
            "centre": index["wheel_centre"],
            "radius": _mm(np.array(drawing.undeformed_radius if posed.rolls else drawing.radius)),
            "width": _mm(np.array(drawing.width)),
        },
    }


def _mm(values: Array) -> Any:
    return np.round(1e3 * values, 3).tolist()


@cache
def bundle(name: str) -> str:
    """Return a built file of the viewer: ``viewer.js``, ``viewer.css`` or ``page.js``."""
    return resources.files("jounce.report").joinpath("viewer", name).read_text(encoding="utf-8")
