"""Calibrations from points."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from jounce.core.errors import FitError
from jounce.identify.calibration import fit_calibration, read_calibration
from jounce.recordings.conditioning import sensitivity_of


def test_intervals_cover_the_true_sensitivity() -> None:
    draw, inside = np.random.default_rng(1), 0
    blocks = np.array([0.0, 5.0, 10.0, 20.0, 40.0]) * 1e-3
    for _ in range(400):
        found = fit_calibration(
            blocks, 0.4 + 100.0 * blocks + 2e-3 * draw.standard_normal(5), unit="m"
        )
        inside += found.sensitivity.has(100.0)
    assert 365 <= inside <= 393  # 95 % of 400, within three standard deviations


def test_a_slip_is_named() -> None:
    blocks = np.linspace(0.0, 0.05, 6)
    recorded = 100.0 * blocks
    recorded[3] += 0.2
    found = fit_calibration(blocks, recorded, unit="m")
    assert [item.code for item in found.findings] == ["identify.off_the_line"]
    assert found.findings[0].numbers["point"] == pytest.approx(0.03)


def test_two_points_give_no_interval() -> None:
    found = fit_calibration([0.0, 0.05], [0.0, 5.0], unit="m")
    assert found.sensitivity.interval is None
    assert found.gain_doubt is None
    assert [item.code for item in found.findings] == ["identify.two_points"]


@pytest.mark.parametrize(
    ("reference", "recorded", "what"),
    [
        ([0.0], [0.0], "too few points"),
        ([0.01, 0.01], [1.0, 1.1], "equal reference values"),
        ([0.0, 0.01], [1.0, 1.0], "constant reading"),
        ([0.0, 0.01], [1.0], "too few points"),
    ],
)
def test_points_that_tell_nothing_are_refused(
    reference: list[float], recorded: list[float], what: str
) -> None:
    with pytest.raises(FitError, match=what):
        fit_calibration(reference, recorded, unit="m", name="cal.csv")


@pytest.mark.parametrize(
    ("text", "unit", "sensitivity"),
    [
        ("displacement [mm],ch3 [V]\n0,0.4\n10,1.4\n20,2.4\n", "m", 100.0),
        ("ch3 [mV];angle [deg]\n2600;0\n2500;90\n2400;180\n", "m/s^2", 0.1 / 9.80665),
        ("load [N],counts\n0,12\n100,1012\n200,2012\n", "N", 10.0),
    ],
)
def test_files_are_read(tmp_path: Path, text: str, unit: str, sensitivity: float) -> None:
    file = tmp_path / "cal.csv"
    file.write_text(text, encoding="utf-8")
    found = read_calibration(file)
    assert found.quantity_unit == unit
    assert found.sensitivity.value == pytest.approx(sensitivity, rel=1e-9)


@pytest.mark.parametrize(
    ("header", "columns"),
    [
        ("load,out", {"reference": "load [kN]", "recorded": "out [mV]"}),
        ("load,out", "load [kN], out [mV]"),
        ("load [kN],out", {"recorded": "out [mV]"}),
    ],
)
def test_units_can_be_stated_beside_the_file(tmp_path: Path, header: str, columns: object) -> None:
    file = tmp_path / "cal.csv"
    file.write_text(f"{header}\n0,2\n1,12\n2,22\n", encoding="utf-8")
    found = read_calibration(file, columns=columns)
    assert (found.quantity_unit, found.recorded_unit) == ("N", "V")
    assert found.sensitivity.value == pytest.approx(1e-5)
    assert found.zero.value == pytest.approx(2e-3)


def test_keys_of_a_sensor_read_the_points_back() -> None:
    found = fit_calibration([0.0, 100.0, 200.0], [0.5, -0.5, -1.5], unit="N")
    keys = found.sensor()
    assert keys["orientation"] == -1
    assert sensitivity_of(keys["sensitivity"], "N").factor == pytest.approx(0.01)
    assert keys["zero"] == "0.5 V"


def test_a_file_that_is_none_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "cal.csv"
    file.write_text("displacement [mm],force [N]\n0,0\n1,22\n", encoding="utf-8")
    with pytest.raises(FitError, match="not a calibration"):
        read_calibration(file)
