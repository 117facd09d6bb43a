"""Controlled suspensions: actuators, sensors, laws as symbols or Python functions; models and runs are elsewhere."""

from jounce.control.actuators import ActiveActuator, MagnetorheologicalDamper, SemiActiveDamper
from jounce.control.controller import CONTROLS, Controller, PythonControl, as_controller, controller
from jounce.control.design import CornerModel
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

__all__ = [
    "ADD",
    "CONTROLS",
    "LQG",
    "LQR",
    "PID",
    "SHADD",
    "ActiveActuator",
    "Controller",
    "CornerModel",
    "Groundhook",
    "HInfinity",
    "Hybrid",
    "MagnetorheologicalDamper",
    "Passive",
    "PreviewMPC",
    "PythonControl",
    "SemiActiveDamper",
    "Skyhook",
    "TwoStateGroundhook",
    "TwoStateSkyhook",
    "as_controller",
    "controller",
]
