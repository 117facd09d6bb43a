"""An FMU that another tool made does what the same law does in Python: as a controller, and as a damper."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.control.fmu import FmuControl
from jounce.control.fmu.platforms import this_platform

FILE = Path(__file__).parents[1] / "files" / "fmu" / "pythonfmu" / "Skyhook.fmu"
if this_platform() not in jn.read_fmu(FILE).platforms:
    pytest.skip(f"PythonFMU has no binary for {this_platform()}", allow_module_level=True)

TRIAL = jn.Trial(
    road=jn.HalfSine(height="30 mm", length="0.5 m", start="0.5 m"),
    speed="10 m/s",
    duration="0.4 s",
)
INPUTS = {"v_body": "sprung.vz", "v_strut": "strut.velocity"}


def skyhook(measured, _):
    force, v = -4000.0 * measured["sprung.vz"], measured["strut.velocity"]
    return force * v / max(v * v, 1e-12) if force * v > 0.0 else 0.0


def damper(measured, _):
    return 4000.0 * measured["strut.velocity"]


@pytest.mark.parametrize(
    ("output", "law", "actuator"),
    [
        ("command", skyhook, jn.SemiActiveDamper(minimum=300.0, maximum=4000.0)),
        ("force", damper, jn.ActiveActuator(lag=0.0, force_limit=1e5, in_place_of_damper=True)),
    ],
)
def test_the_law_of_another_tool_is_the_law_in_python(output, law, actuator) -> None:
    """In a process of its own and in this one, to the last bit."""
    rig = jn.load("audi-a6-quarter-car")
    own = jn.simulate(
        rig, TRIAL, control=jn.PythonControl(function=law, actuator=actuator, rate=1000.0)
    )
    assert np.ptp(own["command"].values) > 3000.0
    for trusted in (False, True):
        there = FmuControl(
            file=str(FILE), inputs=INPUTS, output=output, actuator=actuator, rate=1000.0, trusted=trusted,
        )  # fmt: skip
        run = jn.simulate(rig, TRIAL, control=there)
        for channel in ("command", "sprung.z", "tyre.force"):
            np.testing.assert_array_equal(run[channel], own[channel])
        assert any("v_body: has no unit: m/s" in finding for finding in run.attrs["findings"])


def test_another_tool_is_named_and_heard() -> None:
    (finding,) = jn.read_fmu(FILE).findings
    assert str(finding).startswith("warning")
    assert "it needs the tool PythonFMU 0.7.0" in str(finding)
    law = FmuControl(
        file=str(FILE), inputs=INPUTS, output="command", parameters={"fails_after": 0.1}
    )
    with pytest.raises(
        jn.SimulationError, match=r"(?s)the step from 0.101 s gave fatal error.*the valve is stuck"
    ):
        jn.simulate(jn.load("audi-a6-quarter-car"), TRIAL, control=law)
