"""Strut angles of lumped and 3-D rigs: what moves, what stays, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.parts.variants import strut_angle, strut_angle_findings, with_strut_angle

KART = jn.load("kart-double-wishbone")


@pytest.mark.parametrize("degrees", [10.0, 16.0, 21.0, 26.0, -12.0])
@pytest.mark.parametrize("side", ["left", "right"])
def test_upper_end_turns_about_the_lower_one_at_constant_length(degrees, side):
    rig = KART if side == "left" else KART.mirrored()
    turned = with_strut_angle(rig, f"{degrees} deg")
    assert np.degrees(strut_angle(turned)) == pytest.approx(degrees, abs=1e-9)
    old, new = rig.hardpoints, turned.hardpoints
    assert new.strut_bottom == old.strut_bottom
    assert new.strut_top[0] == old.strut_top[0]
    assert new.length("strut") == pytest.approx(old.length("strut"), rel=1e-14)
    inboard = abs(new.strut_top[1]) < abs(new.strut_bottom[1])
    assert inboard == (degrees > 0.0)
    assert turned.strut == rig.strut
    changed = {
        path for path, value in turned.parameters().items() if value != rig.parameters()[path]
    }
    assert changed == {"hardpoints.strut_top[1]", "hardpoints.strut_top[2]"}


@pytest.mark.parametrize("degrees", [10.0, 16.0, 21.0, 26.0])
def test_motion_ratio_of_the_kart_at_design_is_the_lumped_prototypes(degrees):
    """Its strut stands beside the ball joint of a level arm; the domain's unit lever: motion ratio = cos(angle)."""
    sweep = jn.sweep_travel(with_strut_angle(KART, f"{degrees} deg"), [0.0])
    assert float(sweep["motion_ratio"][0]) == pytest.approx(np.cos(np.radians(degrees)), rel=1e-4)


def test_equilibrium_is_solved_anew():
    heights = [jn.equilibrium(with_strut_angle(KART, f"{a} deg"))["sprung.z"] for a in (26, 10)]
    assert heights[0] == pytest.approx(0.0, abs=2e-6)
    assert 0.3e-3 < heights[1] < 3e-3  # a steeper strut carries more: 16 kg lift by 15 N / 21 N/mm


def test_a_lumped_rig_takes_the_angle_itself():
    rig = with_strut_angle(jn.load("kart-quarter-car"), np.radians(16.0))
    assert rig.strut.angle == pytest.approx(0.27925268)
    assert strut_angle(rig) == rig.strut.angle


@pytest.mark.parametrize(
    ("rig", "message"),
    [
        (jn.load("generic-mcpherson"), "McPherson strut guides the wheel"),
        (jn.load("hmmwv-front"), r"not collinear.*hardpoints\.(spring|damper)"),
    ],
)
def test_struts_that_cannot_be_turned_are_refused(rig, message):
    with pytest.raises(DescriptionError, match=message):
        with_strut_angle(rig, 0.2)


@pytest.mark.parametrize("angle", [1.3, float("nan"), "16 mm", "16"])
def test_impossible_angles_are_refused(angle):
    with pytest.raises(DescriptionError, match="strut angle"):
        with_strut_angle(KART, angle)


def test_over_thirty_degrees_is_a_finding():
    assert strut_angle_findings(np.radians(30.0), "trial 1") == []
    (found,) = strut_angle_findings(np.radians(31.0), "trial 1")
    assert (found.place, found.severity) == ("trial 1", "warning")
    assert "Adams" in found.message
