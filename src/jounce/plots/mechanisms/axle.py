"""An axle in maximal coordinates: scenes of both sides, and their poses over the input of a test or a sweep."""

from __future__ import annotations

import numpy as np

from jounce.axles.assembly import GROUND
from jounce.axles.builder import SIDES, AxleBuilder
from jounce.axles.wheels import down, moved, turned
from jounce.core.types import Array
from jounce.kc.quantities import Poses as Samples
from jounce.parts import Corner
from jounce.parts.axles import DependentAxle
from jounce.plots.mechanisms.dependent import dependent_scene
from jounce.plots.mechanisms.scene import MIDDLE, Poses, Scene, scene_of, with_middle

Side = tuple[Scene, Poses]


def sides_on_rig(samples: Samples, inputs: Array, words: str, unit: str) -> list[Side]:
    """Return the scene and the poses of the described side, then of the other one.

    The poses are those of one way through the range, ascending in the ``inputs`` (SI) of the ``samples``; what no body
    of the axle carries stays in place.
    """
    way = _one_way(inputs, samples)
    return sides_of(samples.axle, samples.places()[way], inputs[way], words, unit)


def sides_of(axle: AxleBuilder, places: Array, over: Array, words: str, unit: str) -> list[Side]:
    """Return both sides as `sides_on_rig` does for poses of all bodies (n, bodies, 12) ``over`` an ascending input."""
    rig = axle.rig
    return [
        (scene, _poses(scene, side, axle, places, over, (words, unit)))
        for side in sorted(SIDES, key=lambda side: side != rig.side)
        for scene in [_scene(rig, side)]
    ]


def _scene(rig: Corner | DependentAxle, side: str) -> Scene:
    if isinstance(rig, DependentAxle):
        return dependent_scene(rig, side)
    return scene_of(rig if rig.side == side else rig.mirrored())


def _one_way(inputs: Array, samples: Samples) -> Array:
    """Return the samples between both ends of the range, ascending, that have a pose."""
    known = np.flatnonzero(np.isfinite(samples.settled.poses).all(axis=1))
    ends = known[np.argmin(inputs[known])], known[np.argmax(inputs[known])]
    between = known[(known >= min(ends)) & (known <= max(ends))]
    return np.asarray(between[np.argsort(inputs[between], kind="stable")])


def _poses(
    scene: Scene, side: str, axle: AxleBuilder, places: Array, over: Array, named: tuple[str, str]
) -> Poses:
    upright = axle.carried[f"{side}.wheel_centre"]
    tracks = {}
    for name, design in scene.design.points.items():
        if name in MIDDLE.values():
            continue
        body = axle.carried.get(f"{side}.{name}", upright if name in scene.feet else GROUND)
        at = np.asarray(design, dtype=float)
        tracks[name] = (
            np.broadcast_to(at, (len(over), 3)) if body == GROUND else moved(places[:, body], at)
        )
    wheel = axle.assembly.wheels[SIDES.index(side)]
    axis = turned(places[:, wheel.body], np.real(wheel.axis[:, 0]))
    contact = tracks["wheel_centre"] + float(np.real(wheel.radius).flat[0]) * down(axis)
    words, unit = named
    return Poses(
        with_middle(tracks), axis, contact, contact[:, 2], np.ones(len(over), dtype=bool), over,
        words, unit, in_time=False,
    )  # fmt: skip
