"""Volts, currents and counts become the quantities of their sensors."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy import signal

import jounce as jn
from jounce.core.errors import DescriptionError, RecordingError
from jounce.recordings import Sensor, apply_sensors, conditioning, read_recording, recording
from jounce.recordings.conditioning import condition, range_of, sensitivity_of
from jounce.recordings.sensors import sections_of

GRAVITY = 9.80665
_COUPLING = 20.0  # Hz: AC couplings are slower, and by bilinear transform they are exact


@pytest.mark.parametrize(
    ("text", "unit", "factor", "recorded"),
    [
        ("100 mV/g", "m/s^2", 0.1 / GRAVITY, "V"),
        ("5 V / 50 mm", "m", 100.0, "V"),
        ("10 mV/(m/s^2)", "m/s^2", 0.01, "V"),
        ("10 mV/(m/s²)", "m/s^2", 0.01, "V"),
        ("2 mV/N", "N", 2e-3, "V"),
        ("16 mA / 200 mm", "m", 0.08, "A"),
        ("4096 counts / 5 kN", "N", 4096.0 / 5e3, "1"),
        ("1.5e-2 V/deg", "rad", 1.5e-2 * 180.0 / np.pi, "V"),
        (("10 pC/(m/s^2)", "1 mV/pC"), "m/s^2", 0.01, "V"),
        (("100 mV/g", "32768 counts / 10 V"), "m/s^2", 0.1 / GRAVITY * 3276.8, "1"),
    ],
)
def test_sensitivities_are_read(
    text: str | tuple[str, ...], unit: str, factor: float, recorded: str
) -> None:
    found = sensitivity_of(text, unit)
    assert found.factor == pytest.approx(factor, rel=1e-12)
    assert found.recorded == recorded


@pytest.mark.parametrize(
    ("text", "unit", "what"),
    [
        ("100", "m/s^2", "a sensitivity with its units is required"),
        ("100 mV", "m/s^2", "a sensitivity with its units is required"),
        ("100 mV/mm", "m/s^2", "is not valid in a sensitivity"),
        ("100 g/mV", "m/s^2", "is not valid in a sensitivity"),
        ("0 mV/g", "m/s^2", "cannot record a signal"),
        (
            ("10 pC/(m/s^2)",),
            "m/s^2",
            "does not end in a quantity that a data acquisition card records",
        ),
        (("10 pC/(m/s^2)", "1 mV/N"), "m/s^2", "is not valid in a sensitivity"),
        ((), "m", "does not end"),
    ],
)
def test_other_sensitivities_are_refused(text: str | tuple[str, ...], unit: str, what: str) -> None:
    with pytest.raises(DescriptionError, match=what) as refused:
        sensitivity_of(text, unit, where="sensors: sprung.az")
    assert refused.value.where == "sensors: sprung.az"


def written(folder: Path, header: str, *columns: np.ndarray) -> Path:
    file = folder / "raw.csv"
    rows = "\n".join(
        ",".join(f"{value:.9g}" for value in row) for row in zip(*columns, strict=True)
    )
    file.write_text(f"{header}\n{rows}\n", encoding="utf-8")
    return file


def test_volts_become_quantities(tmp_path: Path) -> None:
    time = np.arange(400) / 400.0
    motion = 0.02 * np.sin(2.0 * np.pi * 3.0 * time)
    file = written(tmp_path, "time [s],ch3 [mV]", time, 1e3 * (2.5 + 100.0 * motion))
    run, _ = read_recording(
        file, sensors={"sprung.z": Sensor(column="ch3", sensitivity="5 V / 50 mm", zero="2.5 V")}
    )
    assert list(run.data_vars) == ["sprung.z"]
    assert run["sprung.z"].attrs["units"] == "m"
    np.testing.assert_allclose(run["sprung.z"], motion, atol=1e-7)


def test_a_column_without_a_unit_is_in_that_of_the_sensitivity(tmp_path: Path) -> None:
    time = np.arange(400) / 400.0
    file = written(tmp_path, "time [s],ch0", time, np.sin(20.0 * time))
    sensors = {"sprung.az": Sensor(column="ch0", sensitivity="1 V/(m/s^2)")}
    run, _ = read_recording(file, sensors=sensors)
    np.testing.assert_allclose(run["sprung.az"], np.sin(20.0 * time), atol=1e-6)


def test_behind_ac_coupling_the_mean_is_an_offset(tmp_path: Path) -> None:
    time = np.arange(1000) / 1000.0
    file = written(tmp_path, "time [s],ch0 [V]", time, 0.3 + 0.1 * np.sin(2.0 * np.pi * 5.0 * time))
    for high_pass, mean in ((None, 3.0), (0.5, 0.0)):
        sensor = Sensor(column="ch0", sensitivity="100 mV/(m/s^2)", high_pass=high_pass)
        run, _ = read_recording(file, sensors={"sprung.az": sensor})
        assert float(run["sprung.az"].mean()) == pytest.approx(mean, abs=1e-6)


def test_files_without_the_column_are_read_all_the_same(tmp_path: Path) -> None:
    time = np.arange(400) / 400.0
    file = written(tmp_path, "time [s],sprung.az [m/s^2]", time, np.sin(20.0 * time))
    run, _ = read_recording(
        file, sensors={"sprung.z": Sensor(column="ch3", sensitivity="5 V / 50 mm")}
    )
    assert list(run.data_vars) == ["sprung.az"]


def test_what_reaches_the_end_of_a_range_is_said(tmp_path: Path) -> None:
    time = np.arange(1000) / 1000.0
    file = written(
        tmp_path, "time [s],ch0 [V]", time, np.clip(2.0 * np.sin(12.0 * time), -1.0, 1.0)
    )
    sensor = Sensor(column="ch0", sensitivity="1 V/g", range="1 V")
    _, findings = read_recording(file, sensors={"sprung.az": sensor})
    (at_end,) = [item for item in findings if item.code == "recordings.at_end_of_range"]
    assert 0.5 < at_end.value < 0.8


@pytest.mark.parametrize(
    ("given", "ends"),
    [
        ({"range": "50 g"}, (-50.0 * GRAVITY, 50.0 * GRAVITY)),
        ({"range": "±10 V", "sensitivity": "1 V/(m/s^2)"}, (-10.0, 10.0)),
        ({"range": "10 V", "sensitivity": "1 V/(m/s^2)", "zero": "2 V"}, (-12.0, 8.0)),
        ({}, None),
    ],
)
def test_ranges(given: dict[str, str], ends: tuple[float, float] | None) -> None:
    found = range_of("sprung.az", Sensor(**given))
    assert found == pytest.approx(ends) if ends else found is None


def test_a_range_cuts_the_model_as_it_cut_the_record() -> None:
    rig = jn.load("kart-quarter-car")
    trial = jn.Trial(
        road=jn.HalfSine(height="10 mm", length="60 mm"), speed="1.95 m/s", duration="1 s"
    )
    stiff = rig.with_changes({"strut.spring.rate": "24 N/mm"})
    sensors = {"sprung.az": Sensor(range="10 m/s^2")}
    record = jn.apply_sensors(jn.simulate(stiff, trial, tolerance=1e-8)[["sprung.az"]], sensors)
    assert float(abs(record["sprung.az"]).max()) == 10.0
    found = jn.update_model(
        [jn.FitTrial("one", rig, trial, record, sensors)], {"strut.spring.rate": "15 %"}
    )
    assert found.parameters["strut.spring.rate"].value == pytest.approx(24e3, rel=1e-6)


def test_a_voltage_without_a_sensitivity_is_refused(tmp_path: Path) -> None:
    time = np.arange(400) / 400.0
    file = written(tmp_path, "time [s],ch0 [V]", time, np.sin(20.0 * time))
    with pytest.raises((DescriptionError, RecordingError), match="unit"):
        read_recording(file, sensors={"sprung.az": Sensor(column="ch0")})


@pytest.mark.parametrize("order", [1, 2, 3, 4, 5, 8])
@pytest.mark.parametrize(("corner", "error"), [(5.0, 1e-3), (100.0, 3e-3)])
def test_filters_have_the_response_of_the_analogue_ones(
    order: int, corner: float, error: float
) -> None:
    rate = 2000.0
    frequency = np.linspace(0.2, 2.0, 50) * corner
    for kind, keys in (("low", "low_pass"), ("high", "high_pass")):
        sections = sections_of(Sensor(**{keys: corner, f"{keys}_order": order}), rate)
        _, found = signal.sosfreqz(sections, 2.0 * np.pi * frequency / rate)
        analogue = signal.butter(order, 2.0 * np.pi * corner, kind, analog=True)
        _, wanted = signal.freqs(*analogue, 2.0 * np.pi * frequency)
        beside = frequency < corner if kind == "low" else corner < _COUPLING
        assert np.max(np.abs(found - wanted)[beside], initial=0.0) < error


def test_an_offset_behind_ac_coupling_is_said() -> None:
    time = np.arange(1000) * 1e-3
    wave = np.sin(2.0 * np.pi * 10.0 * time)
    for offset, codes in ((0.5, ["recordings.offset_removed"]), (0.0, [])):
        raw = recording(time, {"sprung.az.voltage": (wave + offset, "V", "")})
        sensor = Sensor(sensitivity="100 mV/(m/s^2)", high_pass=0.5)
        run, findings = condition(raw, {"sprung.az": sensor}, where="a.csv")
        assert [item.code for item in findings] == codes
        assert float(run["sprung.az"].mean()) == pytest.approx(0.0, abs=1e-9)
        for item in findings:
            assert item.value == pytest.approx(5.0, rel=1e-6)
        stated, findings = condition(
            raw, {"sprung.az": sensor.model_copy(update={"zero": "0 V"})}, where="a.csv"
        )
        assert findings == []
        assert float(stated["sprung.az"].mean()) == pytest.approx(10.0 * offset, abs=1e-9)


def test_uneven_time_is_refused_before_a_chain_takes_it_for_even() -> None:
    time = np.arange(1000) * 1e-3
    time[500:] += 0.4e-3
    run = recording(time, {"sprung.az": (np.sin(time), "m/s^2", "")})
    with pytest.raises(RecordingError, match=r"jitters by 40 %.*resample"):
        apply_sensors(run, {"sprung.az": Sensor(low_pass="50 Hz")})
    raw = recording(time, {"sprung.az.voltage": (np.sin(time), "V", "")})
    with pytest.raises(RecordingError, match=r"jitters by 40 %.*resample"):
        condition(raw, {"sprung.az": Sensor(sensitivity="1 V/g")}, where="a.csv")


def test_a_range_is_read_once(monkeypatch: pytest.MonkeyPatch) -> None:
    sensor = Sensor(sensitivity="100 mV/(m/s^2)", range="4.321 V")
    assert range_of("sprung.az", sensor) == pytest.approx((-43.21, 43.21))
    monkeypatch.setattr(conditioning, "to_si", None)
    assert range_of("sprung.az", sensor) == pytest.approx((-43.21, 43.21))
