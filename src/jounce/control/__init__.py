"""Controlled suspensions: actuators, sensors, laws as symbols or Python functions; models and runs are elsewhere."""

from jounce.control.actuators import ActiveActuator, MagnetorheologicalDamper, SemiActiveDamper
from jounce.control.catalogue import CONTROLS, as_controller, controller
from jounce.control.controller import Controller
from jounce.control.corner import CornerModel
from jounce.control.laws import (
    ADD,
    PID,
    SHADD,
    Groundhook,
    Hybrid,
    Passive,
    Skyhook,
    TwoStateGroundhook,
    TwoStateSkyhook,
)
from jounce.control.linear_laws import LQG, LQR, HInfinity
from jounce.control.preview import PreviewMPC
from jounce.control.regulator import PythonControl

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
