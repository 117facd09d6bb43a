"""Sensors of a card from a file: one of their own, a campaign, or the settings of a laboratory."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.recordings.options import chosen_recording, recording_in_python
from jounce.recordings.sensor_files import read_sensors

SENSORS = """schema = "jounce.sensors/1"
[sensors."sprung.az"]
column = "ch0"
sensitivity = "100 mV/(m/s^2)"
zero = "0.2 V"
range = "4 V"
high_pass = "0.5 Hz"
"""
LABORATORY = """schema = "jounce.laboratory/1"
sprung_mass = "16 kg"
unsprung_mass = "5 kg"
obstacle = {height = "10 mm", length = "60 mm"}
[channels]
ch0 = {measures = "sprung.az", sensitivity = "100 mV/(m/s^2)", zero = "0.2 V", range = "4 V", high_pass = "0.5 Hz"}
"""


def written(folder: Path, text: str, name: str = "card.toml") -> Path:
    file = folder / name
    file.write_text(text, encoding="utf-8")
    return file


@pytest.fixture
def record(tmp_path: Path) -> Path:
    time = np.arange(1000) * 1e-3
    rows = "".join(f"{t:.3f},{0.2 + 0.1 * np.sin(40.0 * t):.9f}\n" for t in time)
    return written(tmp_path, f"time [s],ch0 [V]\n{rows}", "a.csv")


def test_a_laboratory_and_a_file_of_their_own_say_the_same(tmp_path: Path) -> None:
    own, laboratory = (read_sensors(written(tmp_path, text)) for text in (SENSORS, LABORATORY))
    assert own == laboratory
    assert own["sprung.az"].high_pass == 0.5


def test_a_campaign_will_do(tmp_path: Path) -> None:
    campaign = jn.new_campaign(tmp_path / "mine")
    described, _ = jn.campaign.load_campaign(campaign)
    assert read_sensors(campaign) == described.sensors


def test_the_file_reads_a_record_as_the_sensors_do(tmp_path: Path, record: Path) -> None:
    file = written(tmp_path, SENSORS)
    by_file, _ = chosen_recording(str(record), sensors=str(file))
    by_sensors, _ = jn.read_recording(record, sensors=read_sensors(file))
    assert by_file.identical(by_sensors)
    expected = np.sin(40.0 * by_file["time"].to_numpy())
    np.testing.assert_allclose(by_file["sprung.az"], expected, atol=1e-6)
    assert (
        recording_in_python("a.csv", sensors="card.toml")
        == "jn.read_recording('a.csv', sensors='card.toml')"
    )


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('schema = "jounce.rig/1"\n', "jounce.sensors/1"),
        ('schema = "jounce.sensors/1"\n', "the file has no sensors"),
        ('schema = "jounce.sensors/1"\nsensors = 3\n', "the file has no sensors"),
        ('schema = "jounce.sensors/1"\n[sensors]\n"sprung.az" = 3\n', "sprung.az"),
        (
            'schema = "jounce.laboratory/1"\n[channels]\nch0 = 3\n',
            "the quantity that it measures is missing",
        ),
        (
            SENSORS.replace("100 mV/(m/s^2)", "100 mV"),
            r"sprung.az.sensitivity: a sensitivity with its units is required",
        ),
        (SENSORS.replace("0.2 V", "0.2 m"), r"sprung.az.zero"),
        (SENSORS.replace("4 V", "4 kg"), r"sprung.az.range"),
        (SENSORS.replace("zero", "zeero"), r"card.toml, line \d+.*zeero"),
        (SENSORS.replace('column = "ch0"', 'bias = "1 kg"'), "bias"),
        (
            LABORATORY.replace('measures = "sprung.az", ', ""),
            "the quantity that it measures is missing",
        ),
        (LABORATORY.replace('"0.2 V"', "[1]"), "zero"),
    ],
)
def test_what_cannot_be_meant_is_refused(tmp_path: Path, text: str, said: str) -> None:
    with pytest.raises(DescriptionError, match=said):
        read_sensors(written(tmp_path, text))
