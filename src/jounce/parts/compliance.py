"""Findings about the compliance of a corner: what only the K&C rig takes into account, and parts that nothing holds."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from jounce.core.findings import Finding, finding
from jounce.core.types import Array
from jounce.parts.bushings import DIRECTIONS, Bushing, Mount, load_of, points_of
from jounce.parts.corners import Corner
from jounce.parts.curves import PolynomialCurve

_MIRROR = np.array([1.0, -1.0, 1.0])
_NONE = 1e-9
"""Stiffness, relative to the largest of its part, that counts as none."""
_ZERO = 0.01
"""Load of a curve at zero displacement over its largest load, above which it acts as a preload."""


def compliance_findings(rig: Corner) -> Iterator[Finding]:
    """Yield what is unlikely in the bushings and mounts of a corner, and what acts on the K&C rig only."""
    only = only_on_kc_rig(rig)
    if only:
        yield finding("parts.kc_only", only[0], names=", ".join(only))
    straight = linear_in_runs(rig)
    if straight:
        yield finding("parts.curve_linear_in_runs", straight[0], names=", ".join(straight))
    for place, bushing in bushings_of(rig).items():
        yield from _check_curves(place, bushing)
    for name in rig.bushed:
        if name in rig.elastic_points:
            yield from _check_hold(rig, name)
    housing = getattr(getattr(rig, "steering", None), "housing", ())
    mounts = rig.subframe.mounts if rig.subframe is not None else ()
    for place, part in (("subframe.mounts", mounts), ("steering.housing", housing)):
        yield from _check_mounts(place, part)


def bushings_of(rig: Corner) -> dict[str, Bushing]:
    """Return all bushings and mounts of a corner by path."""
    bushings = {
        f"bushings.{name}": getattr(rig.bushings, name)
        for name in rig.bushed
        if name in rig.elastic_points
    }
    mounts = {} if rig.subframe is None else {"subframe.mounts": rig.subframe.mounts}
    mounts["steering.housing"] = getattr(getattr(rig, "steering", None), "housing", ())
    return bushings | {
        f"{path}[{i}]": mount for path, part in mounts.items() for i, mount in enumerate(part)
    }


def only_on_kc_rig(rig: Corner) -> tuple[str, ...]:
    """Return the paths that runs and kinematics ignore: there, joints are ideal, parts rigid, bushings without loss."""
    names = [
        name
        for name in rig.elastic_parts
        if name.removeprefix("bushings.") not in rig.bushed_in_runs
    ]
    fields = ("friction", "rotational_friction", "loss_angle")
    light = ("preload", "rotational_preload")
    for point in _in_runs(rig):
        ignored = (*fields, *light) if _is_linear(rig, point) else fields
        bushing = getattr(rig.bushings, point)
        names += [
            f"bushings.{point}.{name}" for name in ignored if getattr(bushing, name) is not None
        ]
    return tuple(names)


def linear_in_runs(rig: Corner) -> tuple[str, ...]:
    """Return the paths of curves whose slope at design acts in runs: next to a massless rod or a sliding strut."""
    return tuple(
        f"bushings.{point}.curves"
        for point in _in_runs(rig)
        if _is_linear(rig, point) and getattr(rig.bushings, point).curves is not None
    )


def _in_runs(rig: Corner) -> list[str]:
    return [name for name in rig.bushed_in_runs if name in rig.elastic_points]


def _is_linear(rig: Corner, point: str) -> bool:
    """Whether runs join this bushing in series with a part without mass."""
    body = point.removesuffix("_inner") if point.endswith("_inner") else ""
    body = "strut" if point == "strut_top" else body
    return body in rig.further_bodies and getattr(rig.bodies, body) is None


def _check_curves(place: str, bushing: Bushing) -> Iterator[Finding]:
    """Report stiffnesses that a curve replaces, and curves that carry a load at design."""
    given = (*bushing.stiffness, *bushing.rotational_stiffness)
    both = []
    for name, curve, stiffness in zip(DIRECTIONS, bushing.curve_of_each, given, strict=True):
        if curve is None:
            continue
        if stiffness > 0.0:
            both.append(name)
        if isinstance(curve, PolynomialCurve):
            continue
        load = float(load_of(curve, 0.0))
        if abs(load) > _ZERO * max(map(abs, points_of(curve)[1])):
            yield finding("parts.curve_not_zero", f"{place}.curves.{name}", load)
    if both:
        yield finding("parts.curve_replaces", f"{place}.curves", names=", ".join(both))


def _check_hold(rig: Corner, name: str) -> Iterator[Finding]:
    """Report directions that an ideal joint would hold but the bushing does not."""
    bushing: Bushing = getattr(rig.bushings, name)
    loose = list(bushing.loose)
    if name == "rocker_pivot":
        loose += _loose_about(rig, bushing)
    if loose:
        yield finding("parts.bushing_loose", f"bushings.{name}", names=", ".join(loose))


def _loose_about(rig: Corner, bushing: Bushing) -> list[str]:
    """Return the direction in which a rocker's bushing lets its axis tilt freely."""
    points = rig.hardpoints.given()
    axis = np.subtract(points["rocker_axis"], points["rocker_pivot"])
    across = np.linalg.svd(axis[np.newaxis])[2][1:] @ bushing.axes  # two directions, own axes
    values, vectors = np.linalg.eigh(across * bushing.tangents[3:] @ across.T)
    if values[0] > _NONE * values[1]:
        return []
    return [DIRECTIONS[3 + int(np.abs(vectors[:, 0] @ across).argmax())]]


def _check_mounts(place: str, mounts: tuple[Mount, ...]) -> Iterator[Finding]:
    """Report a part that can move freely on its mounts."""
    if not mounts:
        return
    size = max(float(np.ptp([mount.point for mount in mounts], axis=0).max()), 0.1)
    centre = np.mean([mount.point for mount in mounts], axis=0) * (1.0, 0.0, 1.0)
    held = np.zeros((6, 6))
    for mount in mounts:
        for side in (np.ones(3), _MIRROR):
            held += _held_by(mount, side, centre, size)
    values, vectors = np.linalg.eigh(held)
    if values[0] <= _NONE * values[-1]:
        direction = ("along x", "along y", "along z", "about x", "about y", "about z")
        free = direction[int(np.abs(vectors[:, 0]).argmax())]
        yield finding("parts.mounts_loose", place, direction=free)


def _held_by(mount: Mount, side: Array, centre: Array, size: float) -> Array:
    """Stiffness (N/m) of a mount against displacements and rotations times ``size`` (m) of its part, shape (6, 6)."""
    axes = side[:, np.newaxis] * mount.axes
    x, y, z = (side * mount.point - centre) / size
    lever = np.array([[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]])
    along, about = np.hstack([np.eye(3), lever]), np.hstack([np.zeros((3, 3)), np.eye(3) / size])
    local = np.vstack([axes.T @ along, axes.T @ about])
    return np.asarray(local.T * mount.tangents @ local)
