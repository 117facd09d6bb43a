"""Hardpoints and the wheel's radius are enough to sweep; nothing that takes masses, springs or tyres exists then."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.parts import library, rig_findings
from jounce.parts.files import rig_text

OF_FORCES = {
    "spring_force",
    "stop_force",
    "damper_force",
    "wheel_force",
    "wheel_rate",
    "wheel_rate_spring",
    "wheel_rate_contact",
    "wheel_rate_contact_spring",
    "wheel_damping_coefficient",
    "tyre_deflection",
    "ride_rate",
    "tyre_stiffness",
}


def points_of(name: str, folder: Path, further: str = "") -> Path:
    """A file with only the tables of hardpoints and wheel of a shipped rig, and its push rod's foot."""
    whole = jn.load(name)
    assert name in library()
    lines = ['schema = "jounce.rig/1"', f'model = "{whole.model}"', "# only points", "[hardpoints]"]
    lines += [f"{point} = {list(place)}" for point, place in whole.hardpoints.given().items()]
    lines += ["[wheel]", f"radius = {whole.wheel.radius}", f"camber = {whole.wheel.camber}", f"toe = {whole.wheel.toe}"]
    file = folder / "points.toml"
    file.write_text("\n".join([*lines, further]), encoding="utf-8")
    return file


@pytest.mark.parametrize(
    "name",
    [
        "reference-double-wishbone",
        "formula-student-front",
        "generic-mcpherson",
        "semi-trailing-arm",
    ],
)
def test_rows_of_geometry_are_those_of_the_whole_rig(name: str, tmp_path: Path) -> None:
    whole = jn.load(name)
    on = f'[strut]\non = "{whole.strut.on}"\n'
    if hasattr(whole.strut, "pushrod_on"):
        on += f'pushrod_on = "{whole.strut.pushrod_on}"\n'
    rig = jn.load(points_of(name, tmp_path, on))
    assert set(rig.without) == {"bodies", "spring", "damper", "tyre"}
    found, expected = (jn.sweep_travel(one, [-0.02, 0.0, 0.02]) for one in (rig, whole))
    assert set(expected.data_vars) - set(found.data_vars) == OF_FORCES & set(expected.data_vars)
    for row in found.data_vars:
        assert found[row].to_numpy() == pytest.approx(expected[row].to_numpy(), abs=1e-12), row


def test_a_spring_without_masses_has_its_wheel_rate(tmp_path: Path) -> None:
    further = '[strut]\non = "rocker"\nspring = {rate = "35 N/mm", preload = "1047 N"}\n'
    rig, whole = jn.load(points_of("formula-student-front", tmp_path, further)), jn.load("formula-student-front")
    assert rig.without == ("bodies", "damper", "tyre")
    found, expected = (jn.sweep_travel(one, [-0.01, 0.0, 0.01])["wheel_rate_spring"] for one in (rig, whole))
    assert found.to_numpy() == pytest.approx(expected.to_numpy(), rel=1e-12)


def test_axles_and_designs_of_hardpoints_alone(tmp_path: Path) -> None:
    rig = jn.load(points_of("formula-student-front", tmp_path))
    rolled = jn.sweep_roll(rig, "-2 deg:2 deg:1 deg")
    assert np.isfinite(rolled["roll_centre_height"]).all()
    assert "roll_moment" not in rolled
    target = {"quantity": "bump_steer", "value": "0 deg/m", "tolerance": "0.1 deg/m"}
    assert jn.design_kinematics(rig, {"hardpoints.tie_rod_inner[2]": "15 mm"}, [target]).met
    assert rig_findings(rig) == []


def test_files_of_hardpoints_stay_so(tmp_path: Path) -> None:
    rig = jn.load(points_of("formula-student-front", tmp_path))
    text = rig_text(rig)
    for word in ("bodies", "mass", "tyre", "spring =", "without", "guide"):
        assert word not in text
    (tmp_path / "again.toml").write_text(text, encoding="utf-8")
    assert jn.load(tmp_path / "again.toml") == rig
    moved = rig.with_changes({"hardpoints.tie_rod_inner[2]": "151 mm"})
    kept = jn.save(moved, tmp_path / "kept.toml", like=tmp_path / "points.toml")
    assert "# only points" in kept.read_text(encoding="utf-8")
    assert "bodies" not in kept.read_text(encoding="utf-8")
    assert jn.load(kept) == moved
    assert rig.mirrored().mirrored() == rig
    assert not any(path.startswith(("bodies.", "tyre.", "strut.spring")) for path in rig.parameters())


def test_what_takes_forces_is_refused(tmp_path: Path) -> None:
    rig = jn.load(points_of("formula-student-front", tmp_path))
    with pytest.raises(jn.DescriptionError, match="cannot be had from hardpoints alone") as caught:
        jn.simulate(
            rig,
            jn.Trial(road={"kind": "half-sine", "height": 0.01, "length": 0.1, "start": 0.2}, speed=2.0, duration=1.0),
        )
    assert "[tyre]" in str(caught.value)
    with pytest.raises(jn.DescriptionError):
        jn.lumped_from(rig)
    with pytest.raises(jn.DescriptionError, match="needs all its parts"):
        jn.load("formula-student-car").with_changes({"front.corner": rig.model_dump(by_alias=True)})
    with pytest.raises(jn.DescriptionError, match="no such parameter"):
        jn.design_kinematics(
            rig, {"strut.spring.rate": "1 N/mm"}, [{"quantity": "camber", "value": 0.0, "tolerance": 0.1}]
        )


def test_some_bodies_are_not_none(tmp_path: Path) -> None:
    body = (
        "[bodies.upright]\nmass = 10.0\ncentre_of_mass = [0.0, 0.59, 0.2]\ninertia = {xx = 0.1, yy = 0.1, zz = 0.1}\n"
    )
    with pytest.raises(jn.DescriptionError, match="lower_arm"):
        jn.load(points_of("formula-student-front", tmp_path, body))
    with pytest.raises(jn.DescriptionError):
        jn.load(points_of("formula-student-front", tmp_path, '[sprung]\nmass = "60 kg"\n'))
