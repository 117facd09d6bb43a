"""A page that turns and plays a mechanism in any browser: one file, nothing from a network."""

from __future__ import annotations

import html
import json
import re
from functools import cache
from importlib import resources
from typing import Any

import numpy as np

from jounce.core.types import Array
from jounce.plots.display import display_unit
from jounce.plots.drawing import DAMPER_BODY
from jounce.plots.poses import Poses
from jounce.plots.roadways import Roadway
from jounce.plots.scenes import Scene
from jounce.plots.shapes import COILS

_MM = 1e3
_REACTIONS = tuple(f".{kind}{axis}" for kind in "ft" for axis in "xyz")
_FIRST = ("tyre.force", "camber")
_SWEEP_SPEEDS = (("slow", 8.0), ("normal", 20.0), ("fast", 50.0))
_SIGN = re.compile(r",? (?:compression|bump|up) positive\b|, positive [\w ]+")
"""What long names say of signs; there is no room for it beside the values."""
_MOST_DIGITS = 4
_SLOWER = (1.0, 2.0, 4.0, 10.0, 20.0, 50.0)


def viewer_page(scene: Scene, poses: Poses, road: Roadway | None, title: str, slow: float) -> str:
    """Write the page.

    Parameters
    ----------
    scene : Scene
        What moves.
    poses : Poses
        Its poses, in the order in which they are played.
    road : Roadway, optional
        What passes under the wheel.
    title : str
        Heading of the page.
    slow : float
        How many times slower than in reality a run plays at first [1].

    Returns
    -------
    str
        HTML; the same input gives the same text.
    """
    data = json.dumps(_data(scene, poses, road, slow), ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    page = _template().replace("{{title}}", html.escape(title))
    return page.replace("{{data}}", data.replace("<", "\\u003c"))


@cache
def _template() -> str:
    return resources.files("jounce.plots").joinpath("templates", "viewer.html").read_text(encoding="utf-8")


def _data(scene: Scene, poses: Poses, road: Roadway | None, slow: float) -> dict[str, Any]:
    names = list(poses.points)
    index = {name: i for i, name in enumerate(names)}
    parts = [part for part in scene.parts if all(name in index for name in part.points)]
    brackets = [one for one in scene.brackets if {one.point, one.first, one.second} <= set(index)]
    show = poses.display
    over, digits = _digits(poses.over * show.factor)
    return {
        "side": scene.side,
        "inTime": poses.in_time,
        "words": poses.words,
        "unit": show.name,
        "digits": digits,
        "over": over,
        "start": 0 if poses.in_time else int(np.abs(poses.over).argmin()),
        "names": names,
        "onBody": [name in scene.on_body for name in names],
        "points": [_track(poses.points[name]) for name in names],
        "parts": [
            {
                "name": part.name,
                "words": part.words,
                "colour": part.colour,
                "plate": part.plate,
                "points": [index[name] for name in part.points],
            }
            for part in parts
        ],
        "brackets": [
            [index[one.point], index[one.first], index[one.second], round(one.share, 4), one.colour] for one in brackets
        ],
        "strut": {
            "spring": [index[name] for name in scene.spring],
            "damper": [index[name] for name in scene.damper],
            "radius": _millimetres(np.array(scene.coil_radius)),
            "tube": _millimetres(np.array(DAMPER_BODY * scene.damper_length)),
            "coils": COILS,
            "colour": scene.strut_colour,
        },
        "axis": None if scene.steering_axis is None else [index[name] for name in scene.steering_axis],
        "wheel": {
            "centre": index["wheel_centre"],
            "radius": _millimetres(np.array(scene.undeformed_radius if poses.in_time else scene.radius)),
            "width": _millimetres(np.array(scene.width)),
            "pressed": poses.in_time,
        },
        "spin": np.round(poses.spin_axis, 5).tolist(),
        "contact": _millimetres(poses.contact),
        "ground": _millimetres(poses.ground),
        "touches": poses.touches.astype(int).tolist(),
        "road": None if road is None else _road(road),
        "signals": _signals(poses),
        "first": next((name for name in _FIRST if name in poses.signals), ""),
        **_speeds(poses, slow),
    }


def _millimetres(values: Array) -> Any:
    """Lengths in mm to a hundredth."""
    return np.round(_MM * values, 2).tolist()


def _track(track: Array) -> dict[str, Any]:
    """Places of a point, or its place where it stands still."""
    still = bool(np.ptp(track, axis=0).max() < 5e-6)
    return {"at": _millimetres(track[0])} if still else {"track": _millimetres(track)}


def _road(road: Roadway) -> dict[str, Any]:
    return {"x": _millimetres(road.distance), "z": _millimetres(road.height), "way": _millimetres(road.way)}


def _signals(poses: Poses) -> list[dict[str, Any]]:
    """What else is known of each pose; forces in joints are left to the recording."""
    found = []
    for name, values in poses.signals.items():
        if name.endswith(_REACTIONS) or name == "constraint.residual" or not np.isfinite(values).any():
            continue
        known = values[np.isfinite(values)]
        unit = display_unit(poses.signal_units[name], float(np.abs(known).max()))
        shown, digits = _digits(values * unit.factor)
        words = _SIGN.sub("", poses.signal_words[name])
        found.append({"name": name, "words": words, "unit": unit.name, "digits": digits, "values": shown})
    return found


def _digits(values: Array) -> tuple[list[float | None], int]:
    """Values with four significant digits of their largest, and how many digits stand behind the point."""
    finite = np.isfinite(values)
    largest = float(np.abs(values[finite]).max(initial=0.0))
    digits = 0 if largest == 0.0 else int(np.clip(3 - np.floor(np.log10(largest)), 0, _MOST_DIGITS))
    rounded = np.round(values, digits) + 0.0
    return [float(value) if ok else None for value, ok in zip(rounded, finite, strict=True)], digits


def _speeds(poses: Poses, slow: float) -> dict[str, Any]:
    """Choices of speed: words and poses a second, and the one to begin with."""
    if not poses.in_time:
        return {"speeds": list(_SWEEP_SPEEDS), "speed": _SWEEP_SPEEDS[1][1]}
    length = float(poses.over[-1] - poses.over[0]) or 1.0
    rate = (len(poses) - 1) / length
    choices = sorted({*_SLOWER, slow})
    speeds = [("real time" if one == 1.0 else f"1/{one:g}", round(rate / one, 4)) for one in choices]
    return {"speeds": speeds, "speed": round(rate / slow, 4)}
