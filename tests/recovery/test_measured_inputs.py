"""Trials with a measured actuator force and a measured base motion, as files of every kind."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.campaign import run_campaign
from jounce.core.errors import SimulationError
from jounce.recordings import recording, write_recording

RIG = jn.load("kart-quarter-car")
TRUTH = RIG.with_changes({"strut.spring.rate": "21.5 N/mm", "strut.damper.coefficient": 120.0})
TIME = np.arange(0.0, 2.0005, 1e-3)
FORCE = 60.0 * np.sin(2 * np.pi * 3.0 * TIME) * np.minimum(1.0, TIME) + 20.0
BASE = 2e-3 * np.sin(2 * np.pi * 7.0 * TIME) * np.minimum(1.0, TIME)
CAMPAIGN = """schema = "jounce.campaign/1"
rig = "kart-quarter-car"
[[trial]]
number = 1
recording = "answer.csv"
use = "fit"
{trial}
[[update]]
name = "one"
free = {{ "strut.spring.rate" = "15 %", "strut.damper.coefficient" = ["60 N*s/m", "300 N*s/m"] }}
"""


def driven(**inputs):
    return jn.simulate(TRUTH, jn.Trial(duration=2.0, **inputs), tolerance=1e-9)


def base_motion():
    return {"excitation": {"time": TIME, "height": BASE}}


def actuator():
    return {"actuator_force": {"time": TIME, "force": FORCE}}


def campaign(folder, trial, run, channels=("sprung.az", "unsprung.az")):
    write_recording(run[list(channels)], folder / "answer.csv", force=True)
    (folder / "campaign.toml").write_text(CAMPAIGN.format(trial=trial), encoding="utf-8")
    return run_campaign(folder / "campaign.toml")


def check(result):
    assert result.is_complete, [f.message for f in result.findings if f.severity == "problem"]
    found = result.strategies[0].update.parameters
    for path, parameter in found.items():
        assert parameter.value == pytest.approx(TRUTH.parameters()[path], rel=2e-4), path


def test_a_constant_actuator_force_carries_part_of_the_load():
    """20 N pushing body and wheel apart lift the body by 20 N over the wheel rate; the tyre does not feel it."""
    still = jn.simulate(RIG, jn.Trial(road=jn.Flat(), speed=1.0, duration=0.1))
    held = {"time": [0.0, 1.0, 2.0, 3.0], "force": [20.0] * 4}
    pushed = jn.simulate(
        RIG, jn.Trial(road=jn.Flat(), speed=1.0, duration=0.1, actuator_force=held)
    )
    values = RIG.parameters()
    slope = values["strut.spring.rate"] * np.cos(values["strut.angle"])
    lift = (pushed["sprung.z"] - pushed["unsprung.z"] - still["sprung.z"] + still["unsprung.z"])[-1]
    assert float(lift) == pytest.approx(20.0 / slope, rel=1e-6)
    assert float(pushed["tyre.force"][-1]) == pytest.approx(
        float(still["tyre.force"][-1]), rel=1e-9
    )
    np.testing.assert_allclose(pushed["actuator.force"], 20.0)


def test_an_active_rig_gives_its_parameters_back():
    trial = jn.Trial(duration=2.0, **base_motion(), **actuator())
    measured = driven(**base_motion(), **actuator())[
        ["sprung.az", "strut.deflection", "actuator.force"]
    ]
    free = {"strut.spring.rate": "15 %", "strut.damper.coefficient": [60.0, 300.0]}
    update = jn.update_model([jn.FitTrial("one", RIG, trial, measured)], free)
    for path, parameter in update.parameters.items():
        assert parameter.value == pytest.approx(TRUTH.parameters()[path], rel=1e-5), path
    blind = jn.update_model(
        [jn.FitTrial("one", RIG, jn.Trial(duration=2.0, **base_motion()), measured)], free
    )
    assert blind.objective_after > 100.0 * max(update.objective_after, 1e-9)


@pytest.mark.parametrize("sign", [1, -1])
def test_a_campaign_with_a_measured_actuator_force(tmp_path, sign):
    write_recording(
        recording(TIME, {"actuator.force": (sign * FORCE, "N", "")}), tmp_path / "force.csv"
    )
    write_recording(recording(TIME, {"road.z": (BASE, "m", "")}), tmp_path / "base.csv")
    words = 'excitation = "base.csv"\nactuator_force = "force.csv"\n'
    words += 'force_positive = "tension"' if sign < 0 else ""
    check(campaign(tmp_path, words, driven(**base_motion(), **actuator())))


@pytest.mark.parametrize(
    "table",
    [
        '"base.csv"',
        '{file = "mm.csv", columns = {"road.z" = "table [mm]", time = "t [ms]"}}',
        '{file = "plain.csv", columns = {"road.z" = "lvdt [mm]"}, sample_time = "1 ms", datum = "rest"}',
        '{file = "base.mat", variable = "rig", columns = {time = "rig(:,1) [s]", "road.z" = "rig(:,2) [mm]"}}',
    ],
)
def test_base_motion_is_read_like_every_recording(tmp_path, table):
    from scipy.io import savemat

    write_recording(recording(TIME, {"road.z": (BASE, "m", "")}), tmp_path / "base.csv")
    rows = zip(TIME.tolist(), BASE.tolist(), strict=True)
    (tmp_path / "mm.csv").write_text(
        "t; table\n" + "\n".join(f"{1e3 * t!r}; {1e3 * z!r}" for t, z in rows)
    )
    (tmp_path / "plain.csv").write_text(
        "lvdt\n" + "\n".join(repr(310.0 + 1e3 * z) for z in BASE.tolist())
    )
    savemat(tmp_path / "base.mat", {"rig": np.column_stack([TIME, 1e3 * BASE])})
    check(campaign(tmp_path, f"excitation = {table}", driven(**base_motion())))


def test_missing_channels_are_said(tmp_path):
    write_recording(recording(TIME, {"sprung.z": (BASE, "m", "")}), tmp_path / "other.csv")
    words = 'excitation = "other.csv"\nactuator_force = {file = "other.csv", sample_time = "1 ms"}'
    result = campaign(tmp_path, words, driven(**base_motion()))
    assert any("no channel 'actuator.force'" in f.message for f in result.findings)


def test_what_cannot_be_is_refused():
    with pytest.raises(SimulationError, match="no actuator for a given force"):
        jn.simulate(
            jn.load("audi-a6-half-car"), jn.Trial(duration=1.0, **base_motion(), **actuator())
        )
    with pytest.raises(SimulationError, match="one of the two"):
        jn.simulate(
            RIG, jn.Trial(duration=1.0, **base_motion(), **actuator()), control=jn.Skyhook()
        )


def test_a_base_motion_takes_the_keys_of_every_recording(tmp_path):
    """In Python and in campaigns alike; what its reader found is a finding of the trial."""
    file = tmp_path / "base.csv"
    table = np.column_stack([1e3 * BASE, np.zeros_like(BASE)])
    np.savetxt(file, table, delimiter=";", header="plate;spare", comments="")
    text = file.read_text(encoding="utf-8").replace(".", ",")
    file.write_text(text, encoding="utf-8")
    base = jn.Excitation(file=file, columns={"road.z": "plate [mm]"}, sample_time="1 ms")
    given = jn.Excitation(time=TIME, height=BASE)
    assert base.end() == pytest.approx(given.end())
    ours, theirs = (jn.simulate(TRUTH, jn.Trial(excitation=one)) for one in (base, given))
    np.testing.assert_allclose(
        ours["sprung.az"], theirs["sprung.az"], atol=1e-4 * float(abs(theirs["sprung.az"]).max())
    )
    assert any(
        "decimal commas" in finding.message
        for finding in jn.Trial(excitation=base).excitation.findings()
    )
    check(
        campaign(
            tmp_path,
            'excitation = {file = "base.csv", columns = {"road.z" = "plate [mm]"}, sample_time = "1 ms"}',
            driven(**base_motion()),
        )
    )


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"time": [0.0, 0.1, 0.2, 0.3], "height": [0.0] * 4, "sample_time": "1 ms"}, "give file"),
        (
            {"file": "base.csv", "columns": {"road.z": "plait [mm]"}},
            "no column 'plait'.*Did you mean 'plate'",
        ),
        ({"file": "base.csv", "sample_time": "1 ms"}, "no channel|road.z|no column"),
        ({"file": "none.mat", "variable": "a"}, "no such file"),
    ],
)
def test_keys_that_cannot_be_meant_are_refused(tmp_path, given, message, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "base.csv").write_text(
        "time [s];plate [mm]\n0;0\n0,1;1\n0,2;0\n0,3;1\n", encoding="utf-8"
    )
    with pytest.raises(jn.JounceError, match=message):
        jn.Excitation(**given)
