"""Rigs as files of Project Chrono: read again they are the same rig, and what a file cannot hold is said or refused."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.exchange.chrono import write_chrono
from jounce.parts.importers import import_chrono

ROUND = {  # rig to what may differ: its share
    "sedan-double-wishbone": 1e-6,  # a linear damper
    "hmmwv-front": 1e-6,  # a map, stops, a tie rod with mass
    "generic-double-wishbone-curve": 1e-6,  # curves of spring and damper
    "generic-mcpherson": 1e-6,
    "sedan-multi-link": 2e-3,  # its upper arm is an estimate
}


def back(rig, file: Path, wheel_mass: float):
    return import_chrono(
        file, wheel_radius=rig.wheel.radius, wheel_mass=wheel_mass, tyre_stiffness=rig.tyre.stiffness,
        sprung_mass=rig.sprung.mass,
    )[0]  # fmt: skip


@pytest.mark.parametrize("name", list(ROUND))
def test_rigs_come_back(tmp_path: Path, name: str) -> None:
    rig, rolling = jn.load(name), 5.0
    made = write_chrono(rig, tmp_path / "out.json", wheel_mass=rolling)
    found = back(rig, made.path, rolling)
    before, after = rig.parameters(), found.parameters()
    assert set(before) == set(after)
    for path, value in before.items():
        assert after[path] == pytest.approx(value, rel=ROUND[name], abs=ROUND[name] * 0.02), path
    assert found.strut.damper.kind == rig.strut.damper.kind


def test_stops_count_along_the_spring(tmp_path: Path) -> None:
    """Which may stand apart from the strut: there Chrono's shortest and longest lengths are the spring's, as ours."""
    stops = {f"strut.{name}_stop": {"gap": f"{gap} mm", "rate": "100 N/mm", "progression": "6e7 N/m^3"}
             for name, gap in (("bump", 30), ("rebound", 20))}  # fmt: skip
    rig = jn.load("sedan-double-wishbone")
    top = (
        rig.hardpoints.strut_top[0],
        rig.hardpoints.strut_top[1],
        rig.hardpoints.strut_top[2] - 0.05,
    )
    tables = rig.with_changes(stops).model_dump(by_alias=True, exclude_none=True)
    tables["hardpoints"]["spring_top"] = top
    apart = type(rig).model_validate(tables)
    assert apart.hardpoints.length("spring") < apart.hardpoints.length("strut") - 0.04
    found = back(apart, write_chrono(apart, tmp_path / "out.json").path, 1e-9)
    assert found.strut.bump_stop.gap == pytest.approx(0.03, abs=1e-9)
    assert found.strut.rebound_stop.gap == pytest.approx(0.02, abs=1e-9)
    assert found.hardpoints.damper_top[2] - found.hardpoints.strut_top[2] == pytest.approx(
        0.05, abs=1e-9
    )


def test_the_right_side_is_written_as_the_left(tmp_path: Path) -> None:
    rig = jn.load("sedan-double-wishbone")
    one = write_chrono(rig, tmp_path / "left.json").path.read_text()
    assert write_chrono(rig.mirrored(), tmp_path / "right.json").path.read_text() == one
    assert json.loads(one)["Spindle"]["COM"] == [0.0, pytest.approx(0.7979), 0.0]


@pytest.mark.slow
def test_a_wheel_without_a_body_is_taken_from_the_upright(tmp_path: Path) -> None:
    rig = jn.load("kart-double-wishbone")
    made = write_chrono(rig, tmp_path / "kart.json")
    table = json.loads(made.path.read_text())
    assert table["Spindle"]["Mass"] + table["Upright"]["Mass"] == pytest.approx(
        rig.bodies.upright.mass
    )
    assert any("become the spindle" in finding.message for finding in made.findings)
    found = back(rig, made.path, 1e-9)
    modes = [[mode.frequency_hz for mode in jn.modes(one)] for one in (rig, found)]
    assert modes[0] == pytest.approx(modes[1], rel=1e-4)


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("kart-quarter-car", "no template for this rig; found 'quarter-car'"),
        ("formula-student-front", "no push rod and rocker"),
        ("semi-trailing-arm", "no template for a trailing-arm"),
    ],
)
def test_rigs_that_are_in_no_template(tmp_path: Path, name: str, message: str) -> None:
    with pytest.raises(jn.OutputError, match=message):
        write_chrono(jn.load(name), tmp_path / "out.json")
    assert not list(tmp_path.iterdir())


def test_more_than_the_wheel_has(tmp_path: Path) -> None:
    rig = jn.load("sedan-double-wishbone")
    with pytest.raises(jn.OutputError, match="more than the whole mass of the body"):
        write_chrono(rig, tmp_path / "out.json", wheel_mass=100.0)
    with pytest.raises(jn.OutputError, match="no wheel body"):
        write_chrono(jn.load("kart-double-wishbone"), tmp_path / "out.json", wheel_mass=1.0)


def test_a_damper_with_hysteresis_is_refused(tmp_path: Path) -> None:
    hysteretic = {"kind": "tanh", "coefficient": 800.0, "force": 50.0, "slope": 40.0}
    rig = jn.load("sedan-double-wishbone").with_changes({"strut.damper": hysteretic})
    with pytest.raises(jn.OutputError, match="hysteresis"):
        write_chrono(rig, tmp_path / "out.json")


def test_a_blow_off_comes_back_as_the_straight_lines_it_is(tmp_path: Path) -> None:
    blow_off = {
        f"{side}_{name}": value
        for side, values in (("bump", (300.0, 0.1, 500.0)), ("rebound", (800.0, 0.2, 700.0)))
        for name, value in zip(
            ("blow_off_force", "blow_off_velocity", "high_speed_coefficient"), values, strict=True
        )
    }
    rig = jn.load("sedan-double-wishbone").with_changes(
        {"strut.damper": {"kind": "blow-off", **blow_off}}
    )
    found = back(rig, write_chrono(rig, tmp_path / "out.json", wheel_mass=5.0).path, 5.0)
    assert found.strut.damper.kind == "table"
    speeds = np.linspace(-2.0, 2.0, 41)
    assert found.strut.damper.forces(speeds) == pytest.approx(
        rig.strut.damper.forces(speeds), abs=1e-6
    )


def test_what_is_left_out_is_said(tmp_path: Path) -> None:
    rig = jn.load("sedan-double-wishbone").with_changes(
        {"strut.friction": {"force": "30 N"}, "steering.rack_travel": "5 mm"}
    )
    made = write_chrono(rig, tmp_path / "out.json")
    warned = " ".join(finding.message for finding in made.findings if finding.severity == "warning")
    assert "strut.friction" in warned
    assert "steering.rack_travel" in warned
