"""Controllers by name, and from TOML files."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from jounce.control.actuators import ActiveActuator, SemiActiveDamper
from jounce.control.controller import Controller, PythonControl
from jounce.control.laws import (
    ADD,
    LQG,
    LQR,
    PID,
    SHADD,
    Groundhook,
    HInfinity,
    Hybrid,
    Passive,
    Skyhook,
    TwoStateGroundhook,
    TwoStateSkyhook,
)
from jounce.control.preview import PreviewMPC
from jounce.core.description import check_schema, read_toml
from jounce.core.errors import DescriptionError, unknown

SCHEMA = "jounce.control/1"


@dataclass(frozen=True)
class Kind:
    """One controller that is known by name.

    Attributes
    ----------
    law : type
        Its class.
    summary : str
        One line about it.
    fields : dict
        Values in which it differs from the class's defaults.
    """

    law: type[Controller]
    summary: str
    fields: dict[str, Any]


_DAMPER, _FORCE = {"actuator": SemiActiveDamper()}, {"actuator": ActiveActuator()}
CONTROLS: dict[str, Kind] = {
    "passive": Kind(Passive, "the rig as it is", {}),
    "skyhook": Kind(Skyhook, "damper between body and sky, clipped to a damper", _DAMPER),
    "skyhook-two-state": Kind(TwoStateSkyhook, "firm where a damper to the sky would pull the same way", _DAMPER),
    "groundhook": Kind(Groundhook, "damper between wheel and ground, clipped to a damper", _DAMPER),
    "groundhook-two-state": Kind(
        TwoStateGroundhook, "firm where a damper to the ground would pull the same way", _DAMPER
    ),
    "hybrid": Kind(Hybrid, "skyhook and groundhook mixed", _DAMPER),
    "add": Kind(ADD, "acceleration driven damping", _DAMPER),
    "sh-add": Kind(SHADD, "skyhook below a crossover frequency, acceleration driven above it", _DAMPER),
    "pid": Kind(PID, "PID on the body's velocity, active", _FORCE),
    "active-skyhook": Kind(Skyhook, "damper between body and sky, by an active actuator", _FORCE),
    "lqr": Kind(LQR, "linear quadratic regulator, active", _FORCE),
    "clipped-lqr": Kind(LQR, "clipped-optimal regulator with a damper", _DAMPER),
    "lqg": Kind(LQG, "regulator on a Kalman filter, active", _FORCE),
    "clipped-lqg": Kind(LQG, "clipped-optimal regulator on a Kalman filter, with a damper", _DAMPER),
    "h-infinity": Kind(HInfinity, "H-infinity output feedback, active", _FORCE),
    "clipped-h-infinity": Kind(HInfinity, "H-infinity output feedback, clipped to a damper", _DAMPER),
    "mpc": Kind(PreviewMPC, "model predictive control with preview of the road, with a damper", _DAMPER),
    "active-mpc": Kind(PreviewMPC, "model predictive control with preview of the road, active", _FORCE),
}
"""Controllers by name."""


def controller(name: str | Path, **changes: Any) -> Controller:
    """Give a controller by its name, or from a TOML file.

    Parameters
    ----------
    name : str or Path
        One of :data:`CONTROLS`, or a path to a file of the schema ``jounce.control/1``.
    **changes
        Fields that differ from what the name or the file says.

    Returns
    -------
    Controller
        The frozen description.

    Raises
    ------
    DescriptionError
        For an unknown name (with the nearest one) or a file that cannot be understood.

    Examples
    --------
    >>> controller("skyhook", rate="500 Hz").rate
    500.0
    """
    if isinstance(name, Path) or str(name).endswith(".toml"):
        found = _from_file(Path(name))
        return type(found).from_table({**found.model_dump(by_alias=True, exclude_unset=True), **changes})
    if name not in CONTROLS:
        raise unknown(name, CONTROLS, what="controller", where="control")
    kind = CONTROLS[name]
    return kind.law.from_table({**kind.fields, **changes}, where=name)


def _from_file(path: Path) -> Controller:
    table, text = read_toml(path)
    check_schema(table, (SCHEMA,), str(path))
    law = table.get("law")
    if law not in CONTROLS:
        raise unknown(str(law), CONTROLS, what="law", where=f"{path}: law")
    kind = CONTROLS[str(law)]
    own = kind.law.model_fields["law"].default
    return kind.law.from_table({**kind.fields, **table, "law": own}, where=str(path), text=text)


def as_controller(value: Controller | str | Path | Callable[..., Any]) -> Controller:
    """Give a controller for what a user may say: one, its name or file, or a Python function.

    Parameters
    ----------
    value : Controller, str, Path or callable
        A function gets ``(measurement, t)`` and gives the command (see :class:`PythonControl`).
    """
    if isinstance(value, Controller):
        return value
    if isinstance(value, str | Path):
        return controller(value)
    if callable(value):
        return PythonControl(function=value)
    raise DescriptionError(
        "not a controller", where="control", found=value, allowed="a controller, its name, a file, or a function"
    )
