"""Models of MuJoCo as rigs: those that we wrote come back; others are read by their names and by their structure."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.exchange.mjcf import write_mjcf
from jounce.parts.importers import import_mjcf

OTHER = {"wheel.width", "steering.rack_travel"}  # not in such a file


@pytest.mark.parametrize("name", ["kart-double-wishbone", "generic-mcpherson", "sedan-multi-link"])
@pytest.mark.parametrize("side", ["left", "right"])
def test_rigs_come_back(tmp_path: Path, name: str, side: str) -> None:
    rig = jn.load(name).with_changes({"wheel.camber": "-1 deg", "wheel.toe": "0.3 deg"})
    file = write_mjcf(rig if side == "left" else rig.mirrored(), tmp_path / "rig.xml").path
    found, findings, _ = import_mjcf(file)
    before, after = rig.parameters(), found.parameters()
    assert set(before) - set(after) <= OTHER
    for path, value in after.items():
        assert value == pytest.approx(before[path], rel=1e-6, abs=1e-8), path
    assert found.strut.on == rig.strut.on
    assert not any(finding.severity == "warning" for finding in findings)


def test_a_push_rod_comes_back_with_its_stop(tmp_path: Path) -> None:
    rig = jn.load("formula-student-front")
    found, _, _ = import_mjcf(write_mjcf(rig, tmp_path / "rig.xml").path)
    assert (found.strut.on, found.strut.pushrod_on) == ("rocker", "lower_arm")
    assert found.strut.bump_stop.gap == pytest.approx(rig.strut.bump_stop.gap, abs=1e-9)
    for point, place in rig.hardpoints.given().items():
        assert getattr(found.hardpoints, point) == pytest.approx(place, abs=1e-9)


ARMS = """<mujoco>
  <compiler angle="{angle}"/>
  <default><joint axis="0 0 1"/><tendon stiffness="30000"/>
    <default class="turning"><joint axis="1 0 0"/><default class="arm"><joint pos="0 0 0"/></default></default>
    <default class="rod"><tendon stiffness="0"/></default>
  </default>
  <worldbody>
    <body name="chassis" pos="0 0 0.2">
      <site name="a" pos="0 0.3 0.5"/> <site name="rack end" pos="-0.1 0.25 0.05"/>
      <body name="bottom" pos="0 0.25 -0.05" {turn}>
        <joint class="arm"/> <site name="b" pos="{b}"/>
        <body name="knuckle" pos="{knuckle}" {back}>
          <joint type="ball"/> <site name="arm of the rack" pos="-0.1 -0.02 0.1"/>
          <body name="rim" pos="0 0.05 0.13"><joint type="hinge" axis="0 1 0"/></body>
        </body>
      </body>
      <body name="top" pos="0 0.3 0.15"><joint class="arm"/></body>
    </body>
  </worldbody>
  <tendon>
    <spatial name="coil"><site site="a"/><site site="b"/></spatial>
    <spatial name="rod" class="rod"><site site="rack end"/><site site="arm of the rack"/></spatial>
  </tendon>
  <equality><connect body1="knuckle" body2="top" anchor="0 -0.03 0.24"/><tendon tendon1="rod"/></equality>
</mujoco>
"""
PLAIN = {"angle": "degree", "turn": "", "back": "", "b": "0 0.2 0.02", "knuckle": "0 0.4 0"}
TURNED = {  # the same with the lower arm's frame turned by 90 degrees about x
    "angle": "radian", "turn": 'euler="1.5707963267948966 0 0"', "back": 'quat="0.70710678118 -0.70710678118 0 0"',
    "b": "0 0.02 -0.2", "knuckle": "0 0 -0.4",
}  # fmt: skip


@pytest.mark.parametrize("frames", [PLAIN, TURNED])
def test_names_of_nobody_follow_from_the_structure(tmp_path: Path, frames: dict[str, str]) -> None:
    file = tmp_path / "corner.xml"
    file.write_text(ARMS.format(**frames))
    rig, findings, _ = import_mjcf(file)
    points = {name: np.array(place) for name, place in rig.hardpoints.given().items()}
    wanted = {
        "lower_arm_front": (0.1, 0.25, 0.15), "lower_arm_rear": (-0.1, 0.25, 0.15),
        "lower_ball_joint": (0.0, 0.65, 0.15),
        "upper_arm_front": (0.1, 0.3, 0.35), "upper_ball_joint": (0.0, 0.62, 0.39), "wheel_centre": (0.0, 0.7, 0.28),
        "tie_rod_inner": (-0.1, 0.25, 0.25), "tie_rod_outer": (-0.1, 0.63, 0.25), "strut_top": (0.0, 0.3, 0.7),
        "strut_bottom": (0.0, 0.45, 0.17),
    }  # fmt: skip
    for name, place in wanted.items():
        assert points[name] == pytest.approx(place, abs=1e-9), name
    said = " ".join(finding.message for finding in findings)
    assert "the rig supports kinematics only: lower_arm, " in said
    assert "lower_ball_joint follows from the structure" in said
    assert set(rig.lacks) == {"bodies", "spring", "damper", "tyre"}
    assert np.isfinite(jn.sweep_travel(rig, [0.0])["camber"].values).all()


def test_without_a_spring_it_is_a_rig_for_kinematics(tmp_path: Path) -> None:
    file = tmp_path / "corner.xml"
    file.write_text(ARMS.format(**PLAIN).replace("30000", "0"))
    rig, findings, _ = import_mjcf(file)
    assert rig.lacks == ("strut", "bodies", "spring", "damper", "tyre")
    assert any("supports kinematics only: " in finding.message for finding in findings)
    assert np.isfinite(jn.sweep_travel(rig, [-0.01, 0.0, 0.01])["camber"]).all()


def test_springs_and_dampers_of_joints_are_said_to_be_left_out(tmp_path: Path) -> None:
    file = tmp_path / "corner.xml"
    file.write_text(
        ARMS.format(**PLAIN).replace(
            '<joint class="arm"/> <site', '<joint class="arm" damping="5"/> <site'
        )
    )
    warned = [finding.message for finding in import_mjcf(file)[1] if finding.severity == "warning"]
    assert warned == ["left out: damping."]
    rig = jn.load("kart-double-wishbone").with_changes({"guide_friction": {"force": "12 N"}})
    found = import_mjcf(write_mjcf(rig, tmp_path / "rig.xml").path)[1]
    assert [finding.message for finding in found if finding.severity == "warning"] == [
        "left out: frictionloss."
    ]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("<mujoco><worldbody>", "not XML"),
        ("<robot/>", "not an MJCF file; found '<robot>'"),
        ('<!DOCTYPE a [<!ENTITY b "c">]><mujoco/>', "document type"),
        ("<mujoco/>", "an element worldbody"),
        ('<mujoco><include file="a.xml"/></mujoco>', "includes other files"),
        ('<mujoco><compiler coordinate="global"/></mujoco>', "global coordinates"),
        ("<mujoco><worldbody/></mujoco>", "the file contains no points"),
        (ARMS.format(**PLAIN).replace('pos="0 0 0.2"', 'pos="0 0"'), "3 numbers"),
        (ARMS.format(**PLAIN).replace('axis="1 0 0"', 'axis="0 0 0"'), "an axis without direction"),
        (
            ARMS.format(**PLAIN).replace('name="top"', 'name="knuckle"'),
            "two bodies have the same name",
        ),
        (ARMS.format(**PLAIN).replace('name="b"', 'name="a"'), "two sites have the same name"),
        (
            ARMS.format(**PLAIN).replace('pos="0 0 0.2"', 'zaxis="0 0 0"'),
            "an axis without direction",
        ),
        (
            ARMS.format(**PLAIN).replace('name="b" pos', 'name="b" fromto'),
            "b: fromto: a site between two places",
        ),
        (ARMS.format(**PLAIN).replace("30000", "hard"), "tendon.*stiffness: unexpected numbers"),
        (ARMS.format(**PLAIN).replace("30000", ""), "tendon.*stiffness: unexpected numbers"),
        (
            ARMS.format(**PLAIN).replace("<compiler", '<compiler settotalmass="300"'),
            "masses that are not those",
        ),
        (
            ARMS.format(**PLAIN).replace("<compiler", '<compiler inertiafromgeom="true"'),
            "masses that are not those",
        ),
        (ARMS.format(**PLAIN).replace('pos="0 0 0.2"', 'quat="0 0 0 0"'), "quaternion of zeros"),
        (
            ARMS.format(**PLAIN).replace("0.7", "nan").replace('pos="0 0 0.2"', 'pos="0 0 nan"'),
            "3 numbers",
        ),
        (
            ARMS.format(**PLAIN).replace('pos="0 0 0.2"', 'axisangle="0 0 0 1"'),
            "axis without direction",
        ),
        (
            ARMS.format(**PLAIN).replace('pos="0 0 0.2"', 'xyaxes="1 0 0 2 0 0"'),
            "axis without direction",
        ),
        (ARMS.format(**PLAIN).replace("<compiler", '<compiler eulerseq="xYz"'), "order of angles"),
        (
            ARMS.format(**PLAIN).replace('"rod" class="rod"', '"rod" class="road"'),
            "unknown class.*allowed: arm, ",
        ),
        (
            ARMS.format(**PLAIN)
            .replace("<worldbody>", "<worldbody><frame>")
            .replace("</worldb", "</frame></worldb"),
            "frame is not read",
        ),
        (
            "<mujoco>" + "<default>" * 300 + "</default>" * 300 + "<worldbody/></mujoco>",
            "nested too deeply",
        ),
        (
            "<mujoco><worldbody>" + "<body>" * 300 + "</body>" * 300 + "</worldbody></mujoco>",
            "nested too deeply",
        ),
    ],
)
def test_mistakes_are_named(tmp_path: Path, text: str, message: str) -> None:
    file = tmp_path / "corner.xml"
    file.write_text(text)
    with pytest.raises(DescriptionError, match=message):
        import_mjcf(file)
