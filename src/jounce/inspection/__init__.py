"""Shock-absorber inspection: records of testers, what they say about each wheel, and how well that is known."""

from __future__ import annotations

from jounce.inspection.evaluation import evaluate
from jounce.inspection.grading import GradedInspection, VehicleGrade, grade, grade_vehicle
from jounce.inspection.limits import Limits, load_limits
from jounce.inspection.quarter_car import Corner, SteadyState, force_response, steady_state
from jounce.inspection.record import read_record
from jounce.inspection.result import Inspection, WheelCurves, WheelResult
from jounce.inspection.signals import PlateCalibration, calibrate_plate

__all__ = [
    "Corner",
    "GradedInspection",
    "Inspection",
    "Limits",
    "PlateCalibration",
    "SteadyState",
    "VehicleGrade",
    "WheelCurves",
    "WheelResult",
    "calibrate_plate",
    "evaluate",
    "force_response",
    "grade",
    "grade_vehicle",
    "load_limits",
    "read_record",
    "steady_state",
]
