"""Shock-absorber inspection: records of testers, what they say about each wheel, and how well that is known."""

from __future__ import annotations

from jounce.inspection.evaluation import evaluate
from jounce.inspection.methods.steady import SteadyState, steady_state
from jounce.inspection.record import read_record
from jounce.inspection.result import Inspection, WheelCurves, WheelResult
from jounce.inspection.signals.conditioning import PlateCalibration, calibrate_plate
from jounce.inspection.signals.response import Corner, force_response
from jounce.inspection.verdicts.grading import GradedInspection, VehicleGrade, grade, grade_vehicle
from jounce.inspection.verdicts.limits import Limits, load_limits

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
