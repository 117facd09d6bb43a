"""Models: symbolic equations built from parts with mechanics."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from jounce.mechanics import Model
from jounce.models.corner import TEMPLATES, corner
from jounce.models.quarter_car import quarter_car
from jounce.parts import QuarterCar, Rig
from jounce.parts.parameters import structure_of

_BUILDERS: dict[type[Rig], Callable[[Any], Model]] = {
    QuarterCar: quarter_car,
    **dict.fromkeys(TEMPLATES, corner),
}
_built: dict[str, Model] = {}


def build(rig: Rig) -> Model:
    """Give the symbolic model of a rig; rigs that differ in numbers only share one."""
    structure = structure_of(rig)
    if structure not in _built:
        _built[structure] = _BUILDERS[type(rig)](rig)
    return _built[structure]


__all__ = ["build", "corner", "quarter_car"]
