"""FMUs of rigs on testers and of mechanisms: under another master they give the run that is in their archive."""

from __future__ import annotations

import csv
import io
import zipfile
from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.control.fmu.platforms import this_platform
from jounce.exchange.fmu import build

fmpy = pytest.importorskip("fmpy")
validation = pytest.importorskip("fmpy.validation")
fmu_master = pytest.importorskip("fmu_master")
if build.compiler_for((this_platform(),)) is None:
    pytest.skip("no compiler", allow_module_level=True)


def kept_run(path: Path) -> dict[str, np.ndarray]:
    """The run that is in the archive."""
    with zipfile.ZipFile(path) as archive:
        names, *rows = csv.reader(io.StringIO(archive.read("extra/jounce/reference.csv").decode()))
    return dict(zip(names, np.array(rows, dtype=float).T, strict=True))


def off(path: Path, folder: Path, channels: list[str]) -> float:
    """Largest difference from the kept run in co-simulation at 1 ms, as a share of each channel's range."""
    kept = kept_run(path)
    fmu = fmu_master.Fmu(path, folder, "CoSimulation")
    inputs = [v.name for v in fmu.about.modelVariables if v.causality == "input" and v.name in kept]

    def values(t: float) -> list[float]:
        return [float(kept[name][round(1e3 * t)]) for name in inputs]

    found = fmu_master.cosimulate(
        fmu, fmu_master.Course(inputs, values, []), 0.3, 1e-3, channels, 1e-8
    )
    fmu.close()
    wanted = np.array([kept[channel] for channel in channels]).T
    assert np.all(np.ptp(wanted, axis=0) > 0.0)
    return float(np.max(np.abs(found - wanted) / np.ptp(wanted, axis=0)))


@pytest.mark.source(
    kind="program",
    of="models for other programs",
    key="fmpy",
    where="co-simulation by FMPy; equations are ours on both sides",
    tolerance="of inputs that are lines over a communication step",
    compares="a quarter car on a EUSAMA plate",
)
def test_a_rig_on_a_tester(tmp_path: Path) -> None:
    made = jn.export_fmu(
        jn.load("audi-a6-quarter-car"), tmp_path / "plate.fmu", tester="eusama", adjoint=False
    )
    assert validation.validate_fmu(str(made.path)) == []
    assert made.inputs[:2] == ("excenter.angle", "excenter.angle_rate")
    difference = off(made.path, tmp_path, ["plate.z", "plate.force", "tyre.force", "unsprung.z"])
    assert difference == pytest.approx(0.0, abs=1e-5)
    description = fmpy.read_model_description(str(made.path))
    units = {v.name: v.unit for v in description.modelVariables}
    assert (units["tester.amplitude"], units["tester.plate_mass"], units["excenter.angle"]) == (
        "m",
        "kg",
        "rad",
    )


@pytest.mark.slow
def test_an_axle_on_sprung_plates(tmp_path: Path) -> None:
    made = jn.export_fmu(
        jn.load("audi-a6-full-car"), tmp_path / "axle.fmu", tester="boge", axle="rear", version=2
    )
    assert validation.validate_fmu(str(made.path)) == []
    assert off(made.path, tmp_path, ["left.plate.z", "right.tyre.force", "body.z"]) < 1e-5


def four_bar() -> jn.mechanics.Mechanism:
    chain, y = jn.mechanics.Mechanism(), (0.0, 1.0, 0.0)
    crank = chain.body("crank", 1.0, (0.0, 0.0, 0.1), (0.01, 0.01, 0.001))
    coupler = chain.body("coupler", 2.0, (0.2, 0.0, 0.25), (0.01, 0.02, 0.02))
    rocker = chain.body("rocker", 1.5, (0.45, 0.0, 0.15), (0.01, 0.01, 0.001))
    chain.revolute("A", chain.ground, crank, at=(0.0, 0.0, 0.0), axis=y)
    chain.revolute("B", crank, coupler, at=(0.0, 0.0, 0.2), axis=y)
    chain.revolute("D", chain.ground, rocker, at=(0.5, 0.0, 0.0), axis=y)
    chain.rod("C", coupler, rocker, (0.4, 0.0, 0.3), (0.4, 0.0, 0.35))
    chain.watch_coordinates()
    return chain


@pytest.mark.slow
def test_a_mechanism_moves_as_ours(tmp_path: Path) -> None:
    made = jn.export_fmu(four_bar(), tmp_path / "chain.fmu", adjoint=False)
    assert off(made.path, tmp_path, ["A.angle", "B.angle", "D.angle"]) < 1e-6


def test_a_mechanism_of_ones_own(tmp_path: Path) -> None:
    arm = jn.mechanics.Mechanism()
    crank = arm.body("crank", 1.0, (0.0, 0.0, 0.1), (0.01, 0.01, 0.001))
    arm.revolute("A", arm.ground, crank, at=(0.0, 0.0, 0.0), axis=(0.0, 1.0, 0.0))
    arm.watch_coordinates()
    made = jn.export_fmu(arm, tmp_path / "arm.fmu", adjoint=False, platforms=())
    assert validation.validate_fmu(str(made.path)) == []
    assert (made.inputs, made.outputs[0]) == ((), "A.angle")
    names = {v.name: v for v in fmpy.read_model_description(str(made.path)).modelVariables}
    assert float(names["mechanism.crank.mass"].start) == 1.0
    assert names["mechanism.crank.mass"].unit == "kg"
    assert names["settings.start_at_rest"].start == "false"


def test_what_does_not_go_together(tmp_path: Path) -> None:
    with pytest.raises(jn.DescriptionError, match="a mechanism has no control"):
        jn.export_fmu(four_bar(), tmp_path / "a.fmu", control="skyhook")
    with pytest.raises(jn.DescriptionError, match="on a tester is not controlled"):
        jn.export_fmu(
            jn.load("kart-quarter-car"), tmp_path / "a.fmu", control="skyhook", tester="eusama"
        )
