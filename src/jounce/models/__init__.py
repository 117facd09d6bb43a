"""Models: symbolic equations built from parts with mechanics."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from jounce.control.actuators import AnyActuator
from jounce.core.errors import DescriptionError
from jounce.core.phrases import Phrase
from jounce.core.remembered import Recent
from jounce.mechanics import Model
from jounce.models.corner import TEMPLATES, corner
from jounce.models.full_car_3d import full_car_3d
from jounce.models.lumped import full_car, half_car, half_car_4dof
from jounce.models.quarter_car import quarter_car
from jounce.parts import QuarterCar, Rig
from jounce.parts.rig import structure_of
from jounce.parts.vehicles import FullCar, FullCar3D, HalfCar, HalfCar4DOF

_BUILDERS: dict[type[Rig], Callable[..., Model]] = {
    QuarterCar: quarter_car,
    HalfCar: half_car,
    HalfCar4DOF: half_car_4dof,
    FullCar: full_car,
    FullCar3D: full_car_3d,
    **dict.fromkeys(TEMPLATES, corner),
}
_WITH_DETAIL = (*TEMPLATES, FullCar3D)
_built: Recent[Model] = Recent()


def build(rig: Rig, *, detail: bool = False, actuator: AnyActuator | None = None) -> Model:
    """Return the symbolic model of a rig; rigs that differ in numbers only share one.

    With ``detail``, 3-D corners and cars on them also output hardpoints, joint reactions and energies; it has no effect
    on other rigs. With an ``actuator`` every strut has one, and an input ``command``; only its structure matters.
    """
    key = (
        structure_of(rig),
        detail and type(rig) in _WITH_DETAIL,
        actuator.structure if actuator else "",
    )
    options: dict[str, Any] = {"detail": True} if key[1] else {}
    if actuator is not None:
        options["actuator"] = actuator
    builder = _BUILDERS.get(type(rig))
    if builder is None:
        raise DescriptionError(
            "an axle without a car does not run on roads",
            where="rig",
            found=Phrase('model = "{model}"', model=getattr(rig, "model", type(rig).__name__)),
            allowed="a quarter car, a half or full car, or a 3-D corner",
            hint="Put it under a car (full-car-3d with [rear] axle), or test it by jn.kc_test.",
        )
    return _built.of(key, lambda: builder(rig, **options))


__all__ = ["build", "corner", "quarter_car"]
