"""Files that jounce 0.1 wrote on 2026-11-23: every later version reads them, and they mean what they meant."""

from __future__ import annotations

import zipfile
from pathlib import Path
from xml.etree import ElementTree as ET

import numpy as np
import pytest

import jounce as jn
from jounce.operations.checks import check_file
from jounce.parts.testers import load_tester

KEPT = Path(__file__).parents[1] / "files" / "kept"


@pytest.mark.parametrize("file", sorted(KEPT.glob("*.toml")), ids=lambda file: file.stem)
def test_descriptions_are_in_order(file: Path) -> None:
    found = check_file(file)
    if file.stem.startswith("control-fmu"):  # their FMU was never kept
        assert len(found.problems) == 1
        assert "part.fmu: no such file" in found.problems[0]
    else:
        assert not found.problems


def test_descriptions_mean_what_they_meant() -> None:
    quarter = jn.load(KEPT / "kart-quarter-car.toml")
    assert (quarter.sprung.mass, quarter.strut.spring.rate, quarter.tyre.stiffness) == (
        16.0,
        22730.0,
        138468.0,
    )
    corner = jn.load(KEPT / "kart-double-wishbone.toml")
    assert (corner.model, len(corner.hardpoints.given())) == ("double-wishbone", 11)
    vehicle = jn.load(KEPT / "audi-a6-half-car-4dof.toml")
    assert {path.partition(".")[0] for path in vehicle.parameters()} >= {"front", "rear"}
    road = jn.load_road(KEPT / "road.toml")
    assert road.end() == pytest.approx(0.08)
    law = jn.controller(KEPT / "control.toml")
    assert (law.damping_coefficient, law.rate, law.actuator.maximum) == (4000.0, 500.0, 4000.0)
    part = jn.controller(KEPT / "control-fmu.toml")
    assert (part.inputs, part.output, part.actuator.replaces_damper) == (
        {"v": "strut.velocity"},
        "force",
        True,
    )
    tyre = jn.controller(KEPT / "control-fmu-tyre.toml")
    assert (tyre.inputs["rate"], tyre.parameters["stiffness"]["rear"]) == (
        "actuator.velocity",
        "230 N/mm",
    )
    assert (tyre.actuator.in_place_of, tyre.actuator.lag, tyre.actuator.replaces_damper) == (
        "tyre",
        0.0,
        False,
    )
    assert load_tester(KEPT / "tester.toml").method


@pytest.mark.parametrize("suffix", [".nc", ".csv", ".mat", ".mf4", ".parquet", ".xlsx"])
def test_recordings_are_what_was_simulated(suffix: str) -> None:
    """As today's run of the same rig: golden within what the tolerance of a run allows."""
    found, _ = jn.read_recording(KEPT / f"run{suffix}")
    units = {name: found[name].attrs["units"] for name in found.data_vars}
    assert units == {"sprung.z": "m", "tyre.force": "N", "strut.velocity": "m/s"}
    assert found.sizes["time"] == 101
    assert float(found["time"][-1]) == pytest.approx(0.1)
    static = 9.81 * (
        21.0 / 138468.0 + 16.0 / (22730.0 * np.cos(np.radians(26.0)) ** 2)
    )  # tyre and spring
    assert float(found["sprung.z"][0]) == pytest.approx(-static, abs=1e-6)
    rig, road = jn.load(KEPT / "kart-quarter-car.toml"), jn.load_road(KEPT / "road.toml")
    run = jn.simulate(rig, jn.Trial(road=road, speed="1 m/s", duration="0.1 s"))
    for name in units:
        own = run[name].to_numpy()
        np.testing.assert_allclose(found[name], own, rtol=0.0, atol=1e-3 * np.ptp(own))


def test_an_fmu_of_today_has_the_variables_of_the_kept_one(tmp_path: Path) -> None:
    """Names, units and roles of what is connected and set: a model that was built around the old one takes the new."""
    now = tmp_path / "kart.fmu"
    jn.export_fmu(jn.load(KEPT / "kart-quarter-car.toml"), now, platforms=())

    def variables(file: Path) -> dict[str, tuple[str, str, str | None]]:
        with zipfile.ZipFile(file) as archive:
            root = ET.fromstring(archive.read("modelDescription.xml"))
        rows = root.iterfind("ModelVariables/*")
        return {
            row.get("name", ""): (row.tag, row.get("causality", ""), row.get("unit"))
            for row in rows
        }

    old, new = variables(KEPT / "kart.fmu"), variables(now)
    assert {name: new.get(name) for name in old} == old
    assert {
        "road.z",
        "road.vz",
        "sprung.z",
        "tyre.force",
        "rig.strut.spring.rate",
        "settings.start_at_rest",
    } <= set(old)
    assert jn.read_fmu(KEPT / "kart.fmu").version == 3
