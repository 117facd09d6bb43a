"""FMUs of other tools: what they say of themselves, what is refused, what a crash does."""

from __future__ import annotations

import os
import subprocess
import sys
import zipfile

import numpy as np
import pytest

import jounce as jn
from jounce.cli import main
from jounce.control.fmu import FmuControl, caller
from jounce.control.fmu.controller import _HeldWork
from jounce.control.fmu.platforms import PLATFORMS, this_platform
from jounce.core.errors import DescriptionError, JounceError, SimulationError
from jounce.core.trust import trusting

fmu_component = pytest.importorskip("fmu_component")
TRIAL = jn.Trial(road=jn.Flat(), speed="1 m/s", duration="0.05 s")
INPUTS = {"v_body": "sprung.vz", "v_strut": "strut.velocity"}
RIG = jn.load("kart-quarter-car")
needs_compiler = pytest.mark.skipif(not fmu_component.can_be_made(), reason="no compiler")


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    folder = tmp_path_factory.mktemp("component")
    return lambda version: fmu_component.binary(version, folder)


def run(file, **changes):
    fields = {"inputs": INPUTS, "output": "coefficient", **changes}
    return jn.simulate(RIG, TRIAL, control=FmuControl(file=str(file), **fields))


@pytest.mark.parametrize("version", [2, 3])
def test_what_an_fmu_says_of_itself(tmp_path, version) -> None:
    file = fmu_component.write(tmp_path / "a.fmu", version, b"no library")
    found = jn.read_fmu(file)
    assert (found.version, found.name, found.platforms) == (
        version,
        "component",
        (this_platform(),),
    )
    assert [v.name for v in found.inputs] == ["v_body", "v_strut", "spare", "deflection", "rate"]
    assert found.can_step
    assert not found.can_be_integrated
    assert not found.findings
    by_name = {v.name: v for v in (*found.inputs, *found.outputs, *found.parameters)}
    assert found.conversion(by_name["v_body"], "m/s") == (pytest.approx(1000.0), 0.0)
    assert found.conversion(by_name["v_strut"], "m/s") == (
        1.0,
        0.0,
    )  # without its base: by its name
    assert found.conversion(by_name["spare"], "N") == (1.0, 0.0)
    assert found.to_dict()["inputs"][0]["unit"] == "mm/s"


def test_a_unit_with_an_offset(tmp_path) -> None:
    units = '<UnitDefinitions><Unit name="degC"><BaseUnit K="1" offset="273.15"/></Unit></UnitDefinitions>'
    text = fmu_component.description(3, units=units, spare="degC")
    found = jn.read_fmu(fmu_component.write(tmp_path / "a.fmu", 3, b"", text))
    factor, offset = found.conversion(found.inputs[2], "K")
    assert factor * 300.0 + offset == pytest.approx(26.85)


@pytest.mark.parametrize(
    ("text", "what"),
    [
        (
            fmu_component.description(3, step='<ModelExchange modelIdentifier="component"/>'),
            "model exchange only",
        ),
        (fmu_component.description(2).replace('"2.0"', '"1.0"'), "unsupported version of FMI"),
        (
            fmu_component.description(
                2, step='<CoSimulation modelIdentifier="c" needsExecutionTool="true"/>'
            ),
            "no binary",
        ),
        (fmu_component.description(3, v_body="N.s/m"), "the unit does not match"),
        (fmu_component.description(3, force="mm/s"), "the unit does not match"),
        (fmu_component.description(3, v_strut="furlong/kg"), "wrong unit"),
        (fmu_component.description(3).replace('valueReference="4"', ""), "no value reference"),
        (
            fmu_component.description(3).replace('name="force"', 'name="coefficient"'),
            "two variables have the same name",
        ),
        (
            fmu_component.description(3).replace('factor="0.001"', 'factor="0"'),
            "a unit with a factor of 0",
        ),
        (fmu_component.description(3).replace('factor="0.001"', 'factor="1,2"'), "not a number"),
        (
            fmu_component.description(
                3, step='<CoSimulation modelIdentifier="component" fixedInternalStepSize="-0.1"/>'
            ),
            "its fixed step is negative",
        ),
        ("<a", "not valid XML of an FMU"),
        ('<!DOCTYPE a [<!ENTITY b "c">]><a>&b;</a>', "a document type"),
        (
            fmu_component.description(
                3, step='<CoSimulation modelIdentifier="component" fixedInternalStepSize="0.0007"/>'
            ),
            "not a multiple of the FMU's fixed step",
        ),
    ],
)
def test_what_cannot_be_run_is_refused_before_the_run(tmp_path, text, what) -> None:
    version = 2 if '"2.0"' in text else 3
    file = fmu_component.write(tmp_path / "a.fmu", version, b"no library", text)
    with pytest.raises(DescriptionError, match=what):
        run(file, output="force", actuator=jn.ActiveActuator())


@pytest.mark.parametrize(
    ("changes", "what"),
    [
        ({"inputs": {"v_bodi": "sprung.vz"}}, "unknown input 'v_bodi'.*v_body"),
        ({"inputs": {"v_body": "sprung.v"}}, "unknown channel 'sprung.v'"),
        ({"inputs": {"v_body": "sprung.z"}}, "the unit does not match"),
        ({"output": "coefficients"}, "unknown output.*coefficient"),
        ({"output": "force"}, "the unit does not match"),
        ({"output": None}, "no output or several"),
        ({"output": None, "outputs": {"left": "coefficient"}}, "outputs are given by corner"),
        ({"parameters": {"gane": 1.0}}, "unknown parameter 'gane'.*gain"),
        ({"parameters": {"gain": "3 m"}}, "wrong unit"),
        ({"parameters": {"mistake": 1.5}}, "the value has the wrong type"),
        ({"parameters": {"is_on": 2.0}}, "the value has the wrong type"),
    ],
)
def test_names_and_units_that_do_not_fit(tmp_path, changes, what) -> None:
    file = fmu_component.write(tmp_path / "a.fmu", 3, b"no library")
    with pytest.raises(JounceError, match=what):
        run(file, **changes)


def test_a_binary_that_is_none(tmp_path) -> None:
    file = fmu_component.write(tmp_path / "a.fmu", 3, b"no library")
    for trusted in (False, True):
        with pytest.raises(SimulationError, match="its binary cannot be loaded"):
            run(file, trusted=trusted)


def test_an_fmu_that_needs_its_tool_says_so_where_it_fails(tmp_path) -> None:
    text = fmu_component.description(
        3, step='<CoSimulation modelIdentifier="component" needsExecutionTool="true"/>'
    )
    file = fmu_component.write(tmp_path / "a.fmu", 3, b"no library", text)
    with pytest.raises(
        SimulationError, match=r"cannot be loaded.*It needs the tool that made it on this machine"
    ):
        run(file)


def test_another_platform_is_named(tmp_path) -> None:
    file = fmu_component.write(tmp_path / "a.fmu", 3, b"")
    other = next(name for name in PLATFORMS if name != this_platform())
    with pytest.raises(DescriptionError, match="only sources"):
        run(file)
    with zipfile.ZipFile(file, "a") as archive:
        archive.writestr(f"binaries/{other}/component{PLATFORMS[other].suffix}", b"x")
    with pytest.raises(
        DescriptionError, match=f"no binary for this machine .{this_platform()}.*only for {other}"
    ):
        run(file)


@pytest.mark.parametrize(
    "name", ["../out.txt", "/etc/out.txt", "resources/../../out.txt", "C:/out.txt", "a\\..\\b"]
)
def test_paths_that_leave_the_archive(tmp_path, name) -> None:
    folder = tmp_path / "in" / "side"
    folder.mkdir(parents=True)
    file = fmu_component.write(folder / "a.fmu", 3, b"x", **{name: b"out"})
    with pytest.raises(DescriptionError, match="a path outside the archive"):
        jn.read_fmu(file)


def test_archives_that_are_none_too_large_or_damaged(tmp_path) -> None:
    file = tmp_path / "a.fmu"
    file.write_bytes(b"PK\x03\x04 and no more")
    with pytest.raises(DescriptionError, match="not a readable archive"):
        jn.read_fmu(file)
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("readme", b"")
    with pytest.raises(DescriptionError, match="no modelDescription"):
        jn.read_fmu(file)
    with zipfile.ZipFile(file, "w") as archive:
        link = zipfile.ZipInfo("resources/link")
        link.external_attr = 0o120777 << 16
        archive.writestr(link, b"/etc")
    with pytest.raises(DescriptionError, match="a link in the archive"):
        jn.read_fmu(file)
    with zipfile.ZipFile(file, "w") as archive:
        for i in range(20_001):
            archive.writestr(f"resources/{i}", b"")
    with pytest.raises(DescriptionError, match="too large for an FMU; found '20001 files"):
        jn.read_fmu(file)


@needs_compiler
@pytest.mark.parametrize("version", [2, 3])
def test_an_fmu_that_crashes_fails_hangs_or_prints(tmp_path, library, version, monkeypatch) -> None:
    file = fmu_component.write(tmp_path / "a.fmu", version, library(version))
    with pytest.raises(SimulationError, match=r"t = 0.005 s: the FMU crashed \(signal 6\)"):
        run(file, parameters={"mistake": 1})
    for trusted in (False, True):
        with pytest.raises(
            SimulationError,
            match=r"t = 0.005 s: the step from 0.005 s gave error: the valve is stuck",
        ):
            run(file, parameters={"mistake": 2}, trusted=trusted)
        for mistake in (
            5,
            7,
        ):  # NaN, and an infinity, which the limits of its actuator made a command
            with pytest.raises(SimulationError, match="no finite command"):
                run(file, parameters={"mistake": mistake}, trusted=trusted)
    told = run(file, parameters={"mistake": 3}).attrs["findings"]
    assert any("notes.txt" in text for text in told)
    quiet, loud = (run(file, parameters={"mistake": mistake}) for mistake in (0, 4))
    np.testing.assert_array_equal(quiet["sprung.z"], loud["sprung.z"])
    monkeypatch.setattr("jounce.control.fmu.controller._PATIENCE", 0.3)
    with pytest.raises(SimulationError, match=r"no response for 0\.3 s"):
        run(file, parameters={"mistake": 6})


_KILLS = """
import sys
import jounce as jn
from jounce.control.fmu import FmuControl
law = FmuControl(file=sys.argv[1], inputs={"v_body": "sprung.vz"}, output="coefficient", parameters={"mistake": 8})
try:
    trial = jn.Trial(road=jn.Flat(), speed="1 m/s", duration="0.05 s")
    jn.simulate(jn.load("kart-quarter-car"), trial, control=law)
except jn.JounceError as error:
    print(error)
"""


@needs_compiler
@pytest.mark.skipif(os.name != "posix", reason="process groups are a thing of POSIX")
def test_an_fmu_that_kills_its_process_group_ends_itself_only(tmp_path, library) -> None:
    words = [
        sys.executable,
        "-c",
        _KILLS,
        str(fmu_component.write(tmp_path / "a.fmu", 3, library(3))),
    ]
    ended = subprocess.run(
        words, capture_output=True, text=True, check=False, timeout=60, start_new_session=True
    )
    assert (ended.returncode, ended.stderr) == (0, "")
    assert "the FMU crashed (signal 9)" in ended.stdout


@pytest.mark.parametrize("way", [zipfile.ZIP_DEFLATED, zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
@pytest.mark.parametrize("at", [0, 1, 4, 9, 40, -1])
def test_members_that_are_damaged(tmp_path, way: int, at: int) -> None:
    """Whatever the way of compression: damaged LZMA was an internal error."""
    file, text = tmp_path / "a.fmu", fmu_component.description(3)
    content = np.random.default_rng(1).bytes(3000) + bytes(3000)
    with zipfile.ZipFile(file, "w", way) as archive:
        archive.writestr("modelDescription.xml", text, zipfile.ZIP_STORED)
        archive.writestr(
            f"binaries/{this_platform()}/component{PLATFORMS[this_platform()].suffix}", content
        )
        first = archive.infolist()[1]
        begin = first.header_offset + 30 + len(first.filename)
        end = begin + first.compress_size
    whole = bytearray(file.read_bytes())
    place = begin + at if at >= 0 else end - 1
    for damage in {0, 1, 93, 128, 255} - {whole[place]}:
        whole[place] = damage
        file.write_bytes(whole)
        with pytest.raises(
            (DescriptionError, SimulationError), match=r"a\.fmu.*(not a readable archive|loaded)"
        ):
            run(file)


@pytest.mark.parametrize(("place", "value"), [(6, 1), (8, 9), (8, 99), (8, 12), (8, 14)])
def test_members_that_are_encrypted_or_of_another_way(tmp_path, place: int, value: int) -> None:
    file = tmp_path / "a.fmu"
    for name in (
        "modelDescription.xml",
        f"binaries/{this_platform()}/component{PLATFORMS[this_platform()].suffix}",
    ):
        fmu_component.write(file, 3, b"no library")
        whole = bytearray(file.read_bytes())
        for mark, more in ((b"PK\x03\x04", 0), (b"PK\x01\x02", 2)):
            begin = (
                whole.index(name.encode()) - 30 if not more else whole.rindex(name.encode()) - 46
            )
            assert whole[begin : begin + 4] == mark
            whole[begin + place + more] = value
        file.write_bytes(whole)
        with pytest.raises(DescriptionError, match=r"a\.fmu: not a readable archive"):
            run(file)


@needs_compiler
def test_parameters_reach_the_fmu_in_its_units(tmp_path, library) -> None:
    file = fmu_component.write(tmp_path / "a.fmu", 2, library(2))
    bump = jn.Trial(
        road=jn.HalfSine(height="5 mm", length="0.1 m"), speed="1 m/s", duration="0.2 s"
    )
    fields = {"file": str(file), "inputs": INPUTS, "output": "coefficient", "trusted": True}
    limits = jn.SemiActiveDamper(minimum=10.0, maximum=1e6)

    def commands(**parameters):
        law = FmuControl(**fields, parameters=parameters, actuator=limits)
        return jn.simulate(RIG, bump, control=law)["command"].values

    assert np.array_equal(commands(gain="0.5 kN*s/m"), commands(gain=500.0))
    assert commands(gain=500.0).max() > 11.0
    assert np.all(commands(gain=500.0, is_on=False) == 10.0)


@needs_compiler
def test_another_token_is_refused_in_the_words_of_the_fmu(tmp_path, library) -> None:
    text = fmu_component.description(2).replace('guid="component"', 'guid="other"')
    file = fmu_component.write(tmp_path / "a.fmu", 2, library(2), text)
    with pytest.raises(SimulationError, match="it gives no instance: another guid"):
        run(file)


def test_a_file_says_where_the_fmu_is(tmp_path) -> None:
    file = tmp_path / "law.toml"
    file.write_text(
        'schema = "jounce.control/1"\nlaw = "fmu"\nfile = "sub/a.fmu"\n[inputs]\nv_body = "sprung.vz"\n'
    )
    found = jn.controller(file, rate="500 Hz")
    assert found.file == str(tmp_path / "sub" / "a.fmu")
    assert (found.rate, found.inputs) == (500.0, {"v_body": "sprung.vz"})
    file.write_text('schema = "jounce.control/1"\nlaw = "fmu"\n')
    with pytest.raises(DescriptionError, match="file: the key is missing"):
        jn.controller(file)
    file.write_text('schema = "jounce.control/1"\nlaw = "fmv"\n')
    with pytest.raises(DescriptionError, match="Did you mean 'fmu'"):
        jn.controller(file)


def test_checking_reads_the_fmu_and_runs_nothing(tmp_path, monkeypatch, capsys) -> None:
    file = tmp_path / "law.toml"
    file.write_text('schema = "jounce.control/1"\nlaw = "fmu"\nfile = "a.fmu"\n')
    assert main(["check", str(file)]) == 2
    assert "a.fmu: no such file" in capsys.readouterr().err
    monkeypatch.setattr("jounce.control.fmu.controller.unpack", None)
    monkeypatch.setattr("subprocess.Popen", None)
    monkeypatch.setattr("ctypes.CDLL", None)
    fmu_component.write(tmp_path / "a.fmu", 3, b"no library")
    assert main(["check", str(file)]) == 0
    (tmp_path / "a.fmu").write_bytes(b"PK")
    assert main(["check", str(file)]) == 2


def test_the_work_of_a_force_that_is_held() -> None:
    """10 N at 1 m/s become 20 N at 2 m/s within 1 s: 140/6 J along lines, and 15 J of the 10 N that are held."""
    work = _HeldWork(1.0, 1)
    work.add([10.0], [10.0], [10.0], [1.0])
    work.start()
    work._last = ([10.0],) * 3 + ([1.0],)
    work.add([20.0], [20.0], [20.0], [2.0])
    assert (work._through, work._made) == (
        pytest.approx(140.0 / 6.0),
        pytest.approx(15.0 - 140.0 / 6.0),
    )
    assert "23.3 J of its work 8.3 J (36 %) were given" in str(work.findings("a.fmu")[0])


def test_a_force_keeps_to_the_fixed_step_of_its_fmu(tmp_path) -> None:
    step = '<CoSimulation modelIdentifier="component" fixedInternalStepSize="0.0003"/>'
    text = fmu_component.description(3, step=step)
    law = FmuControl(
        file=str(fmu_component.write(tmp_path / "a.fmu", 3, b"", text)),
        actuator=jn.ActiveActuator(lag=0),
    )
    assert [round(1.0 / law.with_rate_for(fastest).rate, 6) for fastest in (10.0, 80.0, 1e5)] == [
        0.0009,
        0.0003,
        0.0003,
    ]
    assert law.model_copy(update={"rate": 50.0}).with_rate_for(80.0).rate == 50.0


@pytest.mark.parametrize(
    ("changes", "what"),
    [
        ({"lag": 0.01}, "replaces the tyre has no lag"),
        ({"force_limit": 100.0}, "has no force_limit"),
        ({"rate_limit": "1 kN/s"}, "has no rate_limit"),
        ({"in_place_of_damper": True}, "has no in_place_of_damper"),
        ({"in_place_of": "wheel"}, "in_place_of"),
    ],
)
def test_a_force_in_place_of_an_element_has_no_limits(changes, what) -> None:
    assert jn.ActiveActuator(in_place_of="tyre").order == 0
    with pytest.raises(DescriptionError, match=what):
        jn.ActiveActuator(**{"in_place_of": "tyre", **changes})


def test_only_an_fmu_stands_in_place_of_an_element() -> None:
    with pytest.raises(DescriptionError, match="'skyhook' cannot replace the spring"):
        jn.Skyhook(actuator=jn.ActiveActuator(in_place_of="spring"))


@pytest.mark.parametrize(
    "gain",
    [{"front": 1.0, "left": 2.0}, {"rear": 1.0}, {"": 1.0}, {}],
    ids=["unknown", "lacking", "none", "empty"],
)
def test_values_by_corner_that_do_not_fit(tmp_path, gain) -> None:
    file = fmu_component.write(tmp_path / "a.fmu", 3, b"no library")
    law = FmuControl(file=str(file), inputs=INPUTS, output="coefficient", parameters={"gain": gain})
    with pytest.raises(DescriptionError, match="values by corner do not match"):
        jn.simulate(jn.load("audi-a6-half-car-4dof"), TRIAL, control=law)
    with pytest.raises(DescriptionError, match="allowed: one value"):
        run(file, parameters={"gain": {"front": 1.0}})


def test_both_ways_of_output_are_refused() -> None:
    with pytest.raises(DescriptionError, match="both output and outputs"):
        FmuControl(file="a.fmu", output="a", outputs={"front": "b"})


def test_the_caller_stands_alone() -> None:
    """A child runs it without jounce."""
    from pathlib import Path

    assert "jounce." not in Path(caller.__file__).read_text(encoding="utf-8")


@needs_compiler
def test_a_file_alone_is_no_trust_for_a_command(tmp_path, monkeypatch, library, capsys) -> None:
    """A binary of others runs in this process only after the user's own word."""
    fmu_component.write(tmp_path / "a.fmu", 3, library(3))
    words = [
        "law = 'fmu'",
        "file = 'a.fmu'",
        "output = 'coefficient'",
        "trusted = true",
        "[inputs]",
    ]
    words += [f"{name} = '{channel}'" for name, channel in INPUTS.items()]
    file = tmp_path / "law.toml"
    file.write_text("\n".join(["schema = 'jounce.control/1'", *words]))
    with trusting(False):
        alone = jn.simulate(RIG, TRIAL, control=file)
    assert any("Add --trust as well" in finding for finding in alone.attrs["findings"])
    asked = []

    class Seen(caller.Instances):
        def __init__(self, told) -> None:
            asked.append("here")
            super().__init__(told)

    monkeypatch.setattr(caller, "Instances", Seen)
    command = [
        "ride",
        "kart-quarter-car",
        "--road",
        "iso:A",
        "--duration",
        "4 s",
        "--speed",
        "5 m/s",
        "--control",
        str(file),
    ]
    assert main(command) == 0
    assert "unconnected inputs keep their start values: spare = 2.5" in capsys.readouterr().out
    assert not asked
    assert main([*command, "--trust"]) == 0, capsys.readouterr().err
    assert asked
    asked.clear()
    study = tmp_path / "study.toml"
    study.write_text(
        "schema = 'jounce.sweep/1'\nrig = 'kart-quarter-car'\nmetrics = ['max tyre.force']\ncontrol = 'law.toml'\n"
        "[trial]\nspeed = '2 m/s'\nduration = '0.1 s'\nroad = { kind = 'flat' }\n"
        "[vary]\n'sprung.mass' = ['30 kg', '40 kg']\n[design]\nkind = 'latin-hypercube'\ncount = 2\nseed = 1\n"
    )
    for words, runs_here in (([], False), (["--trust"], True)):
        assert (
            main(["sweep", str(study), "--out", str(tmp_path / f"swept{len(words)}"), *words]) == 0
        )
        assert bool(asked) == runs_here
    asked.clear()
    assert not any(
        "--trust" in finding for finding in jn.simulate(RIG, TRIAL, control=file).attrs["findings"]
    )
    assert asked  # in Python the description decides
