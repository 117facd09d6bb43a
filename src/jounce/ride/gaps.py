"""Available travel and gaps of the stops: as given for all corners or by corner, or as a rig's description has them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from jounce.core.errors import DescriptionError, unknown
from jounce.core.units import to_si
from jounce.parts import Rig
from jounce.ride.views import Pair

Given = Any
_STOPS = ("rebound_stop.gap", "bump_stop.gap")


def by_corner(given: Given, corners: Sequence[str], where: str) -> dict[str, Pair]:
    """Rebound and bump lengths (m) of every corner, from one value or pair for all, or a mapping by corner or axle."""
    if given is None:
        return {}
    if not isinstance(given, Mapping):
        pair = _pair(given, where)
        return dict.fromkeys(corners, pair)
    for key in given:
        if not any(key in (corner, _axle(corner)) for corner in corners):
            raise unknown(str(key), {*corners, *map(_axle, corners)} - {""}, what="corner", where=where)
    found = {}
    for corner in corners:
        for key in (corner, _axle(corner)):
            if key in given and corner not in found:
                found[corner] = _pair(given[key], f"{where}: {key}")
    return found


def gaps_of(rig: Rig | None, corners: Sequence[str]) -> dict[str, Pair]:
    """Gaps (m) of rebound and bump stop of every corner, as far as the rig or vehicle has stops."""
    if rig is None:
        return {}
    numbers = rig.parameters()
    return {corner: (_gap(numbers, corner, _STOPS[0]), _gap(numbers, corner, _STOPS[1])) for corner in corners}


def _gap(numbers: Mapping[str, float], corner: str, stop: str) -> float | None:
    paths = [path for path in numbers if path.endswith(stop)]
    axle = _axle(corner)
    own = [path for path in paths if not axle or path.startswith(f"{axle}.")]
    return numbers[own[0]] if own else None


def _axle(corner: str) -> str:
    return corner.partition("_")[0]


def _pair(given: Any, where: str) -> Pair:
    if isinstance(given, (list, tuple)):
        if len(given) != 2:
            raise DescriptionError("not a pair", where=where, found=given, allowed="rebound and bump, e.g. 0.06, 0.08")
        rebound, bump = (None if value is None else to_si(value, "m", where=where) for value in given)
        return rebound, bump
    return None, to_si(given, "m", where=where)
