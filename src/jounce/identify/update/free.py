"""Free parameters of an update: their paths, start values and bounds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from jounce.core.errors import DescriptionError, FitError
from jounce.core.units import to_si
from jounce.identify.update.problem import Free
from jounce.parts import Rig
from jounce.parts.parameters import unit_of, unknown_path

Bounds = str | float | Sequence[str | float]


def free_parameters(rig: Rig, free: Mapping[str, Bounds], *, where: str = "") -> tuple[Free, ...]:
    """Read the free parameters and their bounds against a rig's values, SI.

    Raises
    ------
    DescriptionError, FitError
        For an unknown path, bounds that cannot be understood, or bounds that exclude the start value.
    """
    check_free(rig, free, where=where)
    values = rig.parameters()
    found = []
    for path, bounds in free.items():
        initial, place = values[path], f"{where}: {path}"
        lower, upper = _range(bounds, initial, unit_of(rig, path), place)
        if not lower <= initial <= upper:
            raise FitError(
                "the bounds exclude the start value",
                where=place,
                found=f"{initial:g}",
                allowed=f"{lower:g} to {upper:g}",
                hint="Move the bounds or the start value.",
            )
        found.append(Free(path, initial, lower, upper))
    return tuple(found)


def check_free(rig: Rig, free: Mapping[str, Bounds], *, where: str = "", more: int = 0) -> None:
    """Refuse no free parameters (``more`` counts those checked elsewhere), unknown paths and unreadable bounds."""
    if not free and not more:
        raise FitError(
            "no free parameter", where=where, hint='Name at least one, e.g. free = {"strut.spring.rate" = "10 %"}.'
        )
    values = rig.parameters()
    for path, bounds in free.items():
        if path not in values:
            raise unknown_path(f"{where}: {path}" if where else path, values, name=path)
        _range(bounds, values[path] or 1.0, unit_of(rig, path), f"{where}: {path}" if where else path)


def _range(bounds: Bounds, initial: float, unit: str, place: str) -> tuple[float, float]:
    """Lower and upper bound in SI."""
    if not isinstance(bounds, str | int | float):
        return _absolute(bounds, unit, place)
    share = to_si(bounds, "1", where=place)
    if share <= 0.0:
        raise FitError("the range must be above zero", where=place, found=bounds, allowed='e.g. "10 %"')
    if initial == 0.0:
        raise FitError("a relative range of a zero start value", where=place, allowed="[lower, upper] with units")
    lower, upper = sorted((initial * (1.0 - share), initial * (1.0 + share)))
    return lower, upper


def _absolute(bounds: object, unit: str, place: str) -> tuple[float, float]:
    if not isinstance(bounds, Sequence) or len(bounds) != 2:
        raise FitError("not a pair of bounds", where=place, found=bounds, allowed='"10 %" or [lower, upper]')
    lower, upper = (to_si(value, unit, where=place) for value in bounds)
    if lower >= upper:
        raise DescriptionError("the lower bound must lie below the upper", where=place, found=list(bounds))
    return lower, upper
