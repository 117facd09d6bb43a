"""The page of a kinematic design: values as an engineer reads them."""

from __future__ import annotations

import math

from jounce.report.kinematic_design import _span


def test_what_rounding_leaves_of_a_curve_is_nothing():
    degrees = 180.0 / math.pi
    curve = [-5.6e-17, 9.0e-5]
    assert _span(curve, degrees, 1e-6 * 1.7e-4) == "0 to 0.005157"
    assert _span(0.0004, 1.0) == "4.000e−4"
    assert _span(-0.5, 1.0, 1e-6) == "−0.5000"
