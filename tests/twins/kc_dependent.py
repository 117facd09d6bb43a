"""Dependent axles as plain data of the oracle (``kc_oracle``): solid axles on links, and twist beams.

Points are those of the left side, in m; the right side has their mirror images. ``bushings`` are rows of the oracle by
the name of their point: stiffness, rotational_stiffness and so on.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from kc_oracle import GROUND, Data, Wheel

SIDES = {"left": 1.0, "right": -1.0}


def mirrored(point: Sequence[float], sign: float) -> np.ndarray:
    """A point of the left side on the side at hand."""
    return np.asarray(point, dtype=float) * [1.0, sign, 1.0]


def solid_axle(
    points: Mapping[str, Sequence[float]],
    radius: float,
    *,
    links: Sequence[str],
    single: Sequence[str] = (),
    spring: Mapping | None = None,
    bushings: Mapping[str, Mapping] | None = None,
) -> Data:
    """A rigid axle between ``wheel_centre`` and its mirror image.

    Each name of ``links`` has points ``<name>_body`` and ``<name>_axle`` on both sides, each of ``single`` (a Panhard
    rod, an upper link in the middle) only those given. A Watt linkage has ``watt_pivot`` on the axle, its crank's ends
    ``watt_crank_left`` and ``_right``, and ``watt_body_left`` and ``_right``. A ``spring`` (a law) stands between
    ``spring_axle`` and ``spring_body``.
    """
    bushings = bushings or {}
    data = Data(bodies={"axle": (points["wheel_centre"][0], 0.0, points["wheel_centre"][2])})
    for name in links:
        for side, sign in SIDES.items():
            ends = [mirrored(points[f"{name}_{end}"], sign) for end in ("body", "axle")]
            _link(data, f"{side}.{name}", ends, "axle", bushings, name, sign)
    for name in single:
        ends = [mirrored(points[f"{name}_{end}"], 1.0) for end in ("body", "axle")]
        _link(data, name, ends, "axle", bushings, name, 1.0)
    if "watt_pivot" in points:
        pivot = np.asarray(points["watt_pivot"], dtype=float)
        data.bodies["watt"] = tuple(pivot)
        row = {"first": "axle", "second": "watt", "at": pivot, "end": pivot + np.eye(3)[0]}
        data.joints.append({"kind": "revolute", "name": "watt", **row})
        for side, sign in SIDES.items():
            ends = [np.asarray(points[f"watt_{end}_{side}"]) for end in ("body", "crank")]
            _link(data, f"{side}.watt", ends, "watt", bushings, "watt", sign)
    for side, sign in SIDES.items():
        if spring:
            ends = [mirrored(points[f"spring_{end}"], sign) for end in ("axle", "body")]
            _spring(data, side, "axle", ends, spring)
        centre = tuple(mirrored(points["wheel_centre"], sign))
        data.wheels[side] = Wheel("axle", centre, (0.0, sign, 0.0), radius)
    return data


def twist_beam(
    points: Mapping[str, Sequence[float]],
    radius: float,
    *,
    stiffness: float,
    bushing: Mapping | None = None,
    spring: Mapping | None = None,
) -> Data:
    """Two trailing halves on ``mount`` and its mirror image, joined at ``shear_centre`` by a beam that only twists.

    Without a ``bushing`` the left mount is a ball joint and the right one slides along y: between two ball joints a
    twisted beam is too long.
    """
    data = Data()
    for side, sign in SIDES.items():
        body, mount = f"{side}.beam", mirrored(points["mount"], sign)
        data.bodies[body] = tuple(mount)
        row = {"name": f"{side}.mount", "first": GROUND, "second": body, "at": mount}
        if bushing:
            data.elastic.append({"kind": "bushing", **row, **bushing, "mirrored": sign < 0.0})
        elif sign > 0.0:
            data.joints.append({"kind": "spherical", **row})
        else:
            data.joints.append({"kind": "point on line", **row, "axis": (0, 1, 0), "point": mount})
        if spring:
            ends = [mirrored(points[f"spring_{end}"], sign) for end in ("axle", "body")]
            _spring(data, side, body, ends, spring)
        centre = tuple(mirrored(points["wheel_centre"], sign))
        data.wheels[side] = Wheel(body, centre, (0.0, sign, 0.0), radius)
    middle = np.asarray(points["shear_centre"], dtype=float) * [1.0, 0.0, 1.0]
    ends = {"first": "right.beam", "second": "left.beam"}
    row = {"at": middle, "end": middle + np.eye(3)[1]}
    data.joints.append({"kind": "revolute", "name": "beam", **ends, **row})
    law = {"rate": stiffness}
    data.elastic.append({"kind": "twist", "name": "beam", "axis": (0, 1, 0), "law": law, **ends})
    return data


def _spring(data: Data, side: str, body: str, ends: Sequence[np.ndarray], law: Mapping) -> None:
    row = {"first": body, "second": GROUND, "at": ends[0], "end": ends[1], "law": law}
    data.elastic.append({"kind": "spring", "name": f"{side}.spring", **row})


def _link(
    data: Data,
    name: str,
    ends: Sequence[np.ndarray],
    axle: str,
    bushings: Mapping[str, Mapping],
    kind: str,
    sign: float,
) -> None:
    """A rod from the car's body to the axle, or a link on bushings at both ends."""
    soft = [bushings.get(f"{kind}_{end}") for end in ("body", "axle")]
    if not any(soft):
        row = {"first": GROUND, "second": axle, "at": ends[0], "end": ends[1]}
        data.joints.append({"kind": "rod", "name": name, **row})
        return
    assert all(soft), "bushings at both ends of a link, or at none"
    data.bodies[name] = tuple(ends[0])
    for end, first, second, at, bushing in (
        ("body", GROUND, name, ends[0], soft[0]), ("axle", name, axle, ends[1], soft[1]),
    ):  # fmt: skip
        row = {"name": f"{name}_{end}", "first": first, "second": second, "at": at}
        data.elastic.append({"kind": "bushing", **row, **bushing, "mirrored": sign < 0.0})
