"""The Reference FMUs of the Modelica Association drive a car: what they are given, of every type, comes out again."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.control.fmu import FmuControl
from jounce.control.fmu.platforms import this_platform
from jounce.core.findings import finding, findings_of
from jounce.variants import shards
from jounce.variants.findings import Tally
from jounce.variants.summary import summarise

FOLDER = Path(__file__).parents[1] / "files" / "fmu" / "reference_fmus"
FILES = {version: FOLDER / f"Feedthrough-{version}.fmu" for version in (2, 3)}
if this_platform() not in jn.read_fmu(FILES[3]).platforms:
    pytest.skip(f"no binary for {this_platform()}", allow_module_level=True)

TRIAL = jn.Trial(
    road=jn.HalfSine(height="30 mm", length="1 m", start="0.5 m"), speed="5 m/s", duration="0.8 s"
)
ACTUATOR = jn.ActiveActuator(lag=0.0, force_limit=1e5)
EACH = {  # a value of every type
    2: {"Int32_input": -7, "Boolean_input": True, "String_input": "a text — of more", "Enumeration_input": 2},
    3: {
        "Float32_continuous_input": 0.5, "Int8_input": -8, "UInt8_input": 8, "Int16_input": -16, "UInt16_input": 16,
        "Int32_input": -32, "UInt32_input": 32, "Int64_input": -64, "UInt64_input": 64, "Boolean_input": True,
        "String_input": "a text — of more", "Enumeration_input": 2,
    },
}  # fmt: skip


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize("way", ["continuous", "discrete"])
def test_what_goes_in_comes_out(version, way) -> None:
    """A force of 1 N for each m/s, held for a tenth of a second, which is the step of the FMU of FMI 3.0."""
    rig = jn.load("audi-a6-quarter-car")
    law = FmuControl(
        file=str(FILES[version]), inputs={f"Float64_{way}_input": "strut.velocity"}, output=f"Float64_{way}_output",
        parameters={"Float64_fixed_parameter": 3.0, **EACH[version]}, actuator=ACTUATOR, rate=10.0,
    )  # fmt: skip
    own = jn.PythonControl(
        function=lambda measured, _: measured["strut.velocity"], actuator=ACTUATOR, rate=10.0
    )
    run, same = (jn.simulate(rig, TRIAL, control=control) for control in (law, own))
    assert np.ptp(same["command"].values) > 0.1
    for channel in ("command", "sprung.z", "tyre.force"):
        np.testing.assert_array_equal(run[channel], same[channel])
    (left,) = (text for text in run.attrs["findings"] if "keep their start" in text)
    assert not [name for name in EACH[version] if name in left]  # they have another


def test_what_it_is_not_made_for_is_refused() -> None:
    rig = jn.load("audi-a6-quarter-car")
    for changes, what in (
        ({"output": "String_output"}, "an output that is no number.*String.*Float64.*UInt64"),
        ({"output": None}, "no output or several"),
        ({"rate": 1000.0}, "not a multiple of the FMU's fixed step.*multiples of 0.1 s"),
        ({"parameters": {"String_input": 3}}, "the value has the wrong type.*a text"),
        ({"parameters": {"String_input": "a\0b"}}, "the value has the wrong type.*a text"),
        ({"parameters": {"Binary_input": "ff"}}, "cannot be set.*Binary"),
        ({"parameters": {"UInt8_input": 300}}, "out of the range of its type.*300.*UInt8"),
        ({"parameters": {"Int32_input": 2**40}}, "out of the range of its type"),
    ):
        given = {
            "output": "Float64_continuous_output",
            "actuator": ACTUATOR,
            "rate": 10.0,
            **changes,
        }
        with pytest.raises(jn.DescriptionError, match=what):
            jn.simulate(rig, TRIAL, control=FmuControl(file=str(FILES[3]), **given))


def test_texts_keep_their_start() -> None:
    for file in FILES.values():
        starts = {variable.name: variable.start for variable in jn.read_fmu(file).inputs}
        assert starts["String_input"] == "Set me!"


def test_a_sweep_tells_what_its_fmus_found_once(tmp_path, monkeypatch) -> None:
    """Work of the force that is held differs from variant to variant, in memory as by shards; it is one finding."""
    law = FmuControl(
        file=str(FILES[2]), inputs={"Float64_continuous_input": "strut.velocity"}, output="Float64_continuous_output",
        actuator=ACTUATOR, rate=500.0,
    )  # fmt: skip
    monkeypatch.setattr(shards, "_size", lambda *_: 2)
    given = {
        "variants": {"strut.damper.coefficient": [1000.0, 1500.0, 2000.0]},
        "metrics": ["max strut.velocity"],
    }
    trial = jn.Trial(road=TRIAL.road, speed=TRIAL.speed, duration=0.3)
    rig = jn.load("audi-a6-quarter-car")
    found = jn.simulate_many(rig, trial, **given, control=law)
    kept = jn.simulate_many(rig, trial, **given, control=law, out=tmp_path / "out")
    for one in (found, kept, jn.load_sweep(tmp_path / "out")):
        told = [
            str(finding) for finding in summarise(one).findings if "Feedthrough" in finding.place
        ]
        assert [text for text in told if "3 of 3 variants: the force is held for 2 ms" in text]
        assert len(told) == 4  # inputs without a connection, two units, the work
        assert all("3 of 3 variants" in text for text in told)


def test_findings_are_counted_by_what_they_say() -> None:
    tally = Tally()
    texts = (
        "note: a1.fmu: v[1]: held for {} ms",
        "note: a1.fmu: v[2]: held for 0.5 ms",
        "warning: a1.fmu: held",
    )
    tally.add(findings_of({"findings": [texts[0].format("0.5"), texts[1]]}))
    tally.add(findings_of({"findings": [texts[0].format("1.5e-05"), texts[2]]}))
    tally.add([finding("control.no_unit", "a1.fmu", unit="m")])
    found = tally.attributes()
    assert list(zip(found["findings"], found["finding_variants"], strict=True)) == [
        (texts[0].format("0.5"), 2),
        (texts[1], 1),
        (texts[2], 1),
        ("note: a1.fmu: has no unit: m is assumed.", 1),
    ]
    again = Tally()
    again.merge(
        {
            name: json.dumps(value) if isinstance(value, list) else value
            for name, value in found.items()
        }
    )
    assert again.attributes() == found  # as a file keeps them
    assert (
        again.findings(3)[-1].sentence("de")
        == "1 von 3 Varianten: hat keine Einheit: m wird angenommen."
    )
    assert Tally().attributes() == {}


WHOLE = [(2, "Int32"), *((3, f"{sign}Int{bits}") for sign in ("", "U") for bits in (8, 16, 32, 64))]


@pytest.mark.parametrize(
    ("version", "kind"), [*WHOLE, (3, "Float32_continuous"), (3, "Float32_discrete")]
)
def test_measurements_in_counts_come_out_again(version, kind) -> None:
    """A load in counts of 100 N, as a converter gives it; between two a measurement is refused without counts."""
    rig = jn.load("audi-a6-quarter-car")
    names = f"{kind}_input", f"{kind}_output"
    is_single = kind.startswith("Float")
    channel = "strut.velocity" if is_single else "tyre.force"
    fields = {
        "file": str(FILES[version]),
        "inputs": {names[0]: channel},
        "output": names[1],
        "rate": 10.0,
    }
    counts = {} if is_single else {names[0]: "100 N", names[1]: "1 N"}
    run = jn.simulate(rig, TRIAL, control=FmuControl(**fields, counts=counts, actuator=ACTUATOR))
    kept = (lambda f: float(round(f / 100.0))) if counts else (lambda f: float(np.float32(f)))
    own = jn.PythonControl(function=lambda m, _: kept(m[channel]), actuator=ACTUATOR, rate=10.0)
    same = jn.simulate(rig, TRIAL, control=own)
    assert np.unique(same["command"].values).size > 3
    np.testing.assert_array_equal(run["command"], same["command"])
    if counts:
        with pytest.raises(
            jn.SimulationError,
            match=r"whole numbers.*allowed: whole numbers from .* Set the size of a count",
        ):
            jn.simulate(rig, TRIAL, control=FmuControl(**fields, actuator=ACTUATOR))


def test_a_measurement_beyond_its_type_is_refused() -> None:
    fields = {
        "inputs": {"UInt8_input": "tyre.force"},
        "output": "UInt8_output",
        "counts": {"UInt8_input": "1 N"},
    }
    law = FmuControl(file=str(FILES[3]), actuator=ACTUATOR, rate=10.0, **fields)
    with pytest.raises(
        jn.SimulationError,
        match=r"tyre.force exceeds the range of the input UInt8_input.*from 0 to 255",
    ):
        jn.simulate(jn.load("audi-a6-quarter-car"), TRIAL, control=law)


def test_a_matrix_of_gains_and_an_element_of_its_output() -> None:
    """y = C x + D u with x at rest is D u: the Reference FMU of arrays, of which one element of each is connected."""
    rig = jn.load("audi-a6-quarter-car")
    long = jn.Trial(
        road=jn.HalfSine(height="30 mm", length="20 m", start="0 m"), speed="1 m/s", duration="3 s"
    )
    law = FmuControl(
        file=str(FOLDER / "StateSpace-3.fmu"), inputs={"u[2]": "strut.deflection"}, output="y[3]", rate=1.0,
        actuator=ACTUATOR,
        parameters={"A": [[0.0] * 3] * 3, "B": [[0.0] * 3] * 3, "D[3,2]": 1000.0, "D[3,3]": 0.0, "u[3]": 7.0},
    )  # fmt: skip
    run = jn.simulate(rig, long, control=law)
    own = jn.PythonControl(
        function=lambda m, _: 1000.0 * m["strut.deflection"], actuator=ACTUATOR, rate=1.0
    )
    same = jn.simulate(rig, long, control=own)
    assert np.ptp(same["command"].values) > 0.01
    np.testing.assert_allclose(run["command"], same["command"], rtol=1e-12)
