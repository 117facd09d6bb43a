"""Exported FMUs under other masters: the same motion as ``jn.simulate``, in model exchange and in co-simulation."""

from __future__ import annotations

import shutil
import subprocess
import zipfile
from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.control.fmu.platforms import this_platform
from jounce.exchange.fmu import build
from jounce.mechanics.facts import speed_of
from jounce.simulation.compiled import compile_rig
from jounce.simulation.problem import excitation

fmpy = pytest.importorskip("fmpy")
validation = pytest.importorskip("fmpy.validation")
fmu_master = pytest.importorskip("fmu_master")
if build.compiler_for((this_platform(),)) is None:
    pytest.skip("no compiler", allow_module_level=True)

QUICK = ("kart-quarter-car", "kart-double-wishbone")
SLOW = (
    "audi-a6-quarter-car", "audi-a6-half-car", "audi-a6-half-car-4dof", "audi-a6-full-car", "sldemo-half-car",
    "hmmwv-front-corner", "formula-student-front", "generic-mcpherson", "sedan-multi-link", "semi-trailing-arm",
    "suv-front", "van-front", "formula-student-car", "sedan-full-car-3d",
)  # fmt: skip


def bump(end: float) -> jn.Trial:
    return jn.Trial(
        road=jn.HalfSine(height="10 mm", length="60 mm"), speed="1.95 m/s", duration=end
    )


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """FMUs by rig, version and law, each written once."""
    folder = tmp_path_factory.mktemp("fmu")

    def write(name: str, version: int = 3, control: str | None = None) -> Path:
        file = folder / f"{name}-{version}-{control}.fmu"
        if not file.exists():
            jn.export_fmu(jn.load(name), file, version=version, control=control)
        return file

    return write


def course(name: str, trial: jn.Trial, *, rates: bool = True) -> fmu_master.Course:
    rig = jn.load(name)
    facts = compile_rig(rig).facts
    signals = excitation(facts, rig, trial)
    names = [
        word for track in facts.tracks for word in ((track, speed_of(track)) if rates else (track,))
    ]

    def values(t: float) -> list[float]:
        found = []
        for signal in signals:
            value, rate = (float(part[0]) for part in signal.evaluate(np.array([t]))[:2])
            found += [value, rate] if rates else [value]
        return found

    return fmu_master.Course(
        names, values, sorted({float(edge) for signal in signals for edge in signal.edges})
    )


def instance(path: Path, folder: Path, kind: str) -> fmu_master.Fmu:
    return fmu_master.Fmu(path, folder, kind)


def displacements(run, outputs) -> list[str]:
    """Channels whose values are compared: displacements and what follows from them."""
    return [
        n
        for n in outputs
        if n in run and n.endswith((".z", ".deflection", "strut.force", "tyre.force", ".camber"))
    ]


def compare(
    path: Path, tmp_path: Path, name: str, trial: jn.Trial, control: str | None = None
) -> tuple[float, int, int]:
    """Largest difference of a run of model exchange at its end, of the channel's range; events of both."""
    run = jn.simulate(
        jn.load(name),
        trial,
        tolerance=1e-10,
        method="auto" if control else "explicit",
        control=control,
    )
    outputs = displacements(
        run, [v.name for v in fmpy.read_model_description(str(path)).modelVariables]
    )
    reference = np.array([run[channel].values for channel in outputs]).T
    # An angle comes from directions, whose elements of up to 1 round by 1e-16 each: together by about 1e-15 rad. That
    # is a hundredth of 1e-9 of a range of 1e-4 rad; the camber of a wheel guided in parallel stays within 1e-6 rad.
    least = np.where([channel.endswith(".camber") for channel in outputs], 1e-4, 0.0)
    most = np.max(np.abs(reference), axis=0)
    size = np.max([np.ptp(reference, axis=0), 1e-6 * most, least], axis=0)
    fmu = instance(path, tmp_path, "ModelExchange")
    found = fmu_master.exchange(fmu, course(name, trial), trial.duration, outputs)
    fmu.close()
    moved = size > 1e-9
    difference = np.abs(found.outputs - reference[-1])[moved] / size[moved]
    return float(np.max(difference)), len(found.events), int(run.attrs["events"])


@pytest.mark.some(2)
@pytest.mark.source(
    kind="program",
    of="models for other programs",
    key="fmpy",
    where="FMI 2.0 and 3.0 by FMPy, stepped by SciPy's DOP853; equations are ours on both sides",
    tolerance="of both integrators, as share of a channel's range",
    compares="model exchange of quarter cars and corners, with events",
)
@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize("name", QUICK)
def test_model_exchange_is_our_run(written, tmp_path, name, version):
    file = written(name, version)
    assert validation.validate_fmu(str(file)) == []
    difference, events, ours = compare(file, tmp_path, name, bump(1.0))
    assert difference == pytest.approx(0.0, abs=1e-9)
    assert events == ours == 6  # lift-off and landing, one of them at a height of exactly zero


@pytest.mark.slow
@pytest.mark.parametrize("name", SLOW)
def test_every_shipped_rig_is_our_run(written, tmp_path, name):
    file = written(name)
    assert validation.validate_fmu(str(file)) == []
    trial = jn.Trial(road=jn.HalfSine(height="20 mm", length="200 mm"), speed="5 m/s", duration=0.4)
    difference, events, ours = compare(file, tmp_path, name, trial)
    assert difference < 1e-7
    assert events == ours


@pytest.mark.source(
    kind="program",
    of="models for other programs",
    key="fmpy",
    where="FMI 2.0 and 3.0 by FMPy, stepped by SciPy's DOP853; equations are ours on both sides",
    tolerance="of both integrators, as share of a channel's range",
    compares="model exchange with a controller inside",
)
@pytest.mark.parametrize(
    ("name", "law"), [("kart-quarter-car", "skyhook"), ("audi-a6-quarter-car", "lqg")]
)
def test_controller_is_a_sampled_part(written, tmp_path, name, law):
    difference, events, ours = compare(written(name, 3, law), tmp_path, name, bump(0.4), law)
    assert difference == pytest.approx(0.0, abs=1e-9)
    assert events == ours


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "law"), [("audi-a6-full-car", "skyhook"), ("audi-a6-quarter-car", "pid")]
)
def test_every_kind_of_controller(written, tmp_path, name, law):
    difference, events, ours = compare(written(name, 2, law), tmp_path, name, bump(0.4), law)
    assert difference < 1e-7
    assert events == ours


@pytest.mark.source(
    kind="program",
    of="models for other programs",
    key="fmpy",
    where="co-simulation by FMPy; equations are ours on both sides",
    tolerance="of inputs that are lines over a communication step",
    compares="co-simulation of a quarter car over a bump",
)
@pytest.mark.parametrize(("step", "allowed"), [(1e-3, 5e-3), (1e-4, 1e-4)])
def test_co_simulation_follows_the_road(written, tmp_path, step, allowed):
    trial, outputs = bump(0.4), ["tyre.force", "sprung.z", "unsprung.z", "strut.force"]
    run = jn.simulate(jn.load("kart-quarter-car"), trial, tolerance=1e-10, output_step=step)
    reference = np.array([run[channel].values for channel in outputs]).T
    fmu = instance(written("kart-quarter-car"), tmp_path, "CoSimulation")
    found = fmu_master.cosimulate(fmu, course("kart-quarter-car", trial), 0.4, step, outputs)
    fmu.close()
    assert (found - reference) / np.ptp(reference, axis=0) == pytest.approx(
        np.zeros(found.shape), abs=allowed
    )


def test_height_without_its_rate_keeps_tyre_damping(written, tmp_path):
    """Without a rate a damped tyre would feel the road as standing still: 9 % off, however small the steps."""
    name = "audi-a6-quarter-car"
    trial = jn.Trial(road=jn.HalfSine(height="20 mm", length="2 m"), speed="5 m/s", duration=0.6)
    run = jn.simulate(jn.load(name), trial, tolerance=1e-10)
    reference = run["unsprung.z"].values
    off = {}
    for kind, rates in (("given", True), ("taken from the values", False)):
        fmu = instance(written(name, 3), tmp_path, "CoSimulation")
        found = fmu_master.cosimulate(
            fmu, course(name, trial, rates=rates), 0.6, 1e-3, ["unsprung.z"]
        )[:, 0]
        fmu.close()
        off[kind] = np.max(np.abs(found - reference)) / np.ptp(reference)
    assert off["given"] < 5e-4
    assert off["taken from the values"] < 5e-3


def test_model_exchange_by_cvode_needs_no_rates(written, tmp_path):
    """FMPy evaluates at times at which it does not set inputs: a difference over these times has no bound.

    Its CVode takes inputs once a step; with rates it is 0.5 % off, too.
    """
    name = "audi-a6-quarter-car"
    trial = jn.Trial(
        road=jn.HalfSine(height="20 mm", length="0.8 m", start="100 mm"),
        speed="5 m/s",
        duration=0.3,
    )
    run = jn.simulate(jn.load(name), trial, tolerance=1e-9)
    t = np.linspace(0.0, 0.3, 3001)
    bump = t - 0.02
    road = np.where((bump > 0.0) & (bump < 0.16), 0.02 * np.sin(np.pi * bump / 0.16), 0.0)
    found = fmpy.simulate_fmu(
        str(written(name, 3)), fmi_type="ModelExchange", relative_tolerance=1e-7, stop_time=0.3, output_interval=1e-3,
        input=np.rec.fromarrays([t, road], names=["time", "road.z"]), output=["unsprung.z"],
    )  # fmt: skip
    assert np.abs(found["unsprung.z"] - run["unsprung.z"].values).max() < 0.01 * np.ptp(
        run["unsprung.z"].values
    )


def test_a_short_pulse_needs_its_edges_twice_in_cvode(written):
    """As the page says: with samples given twice, which FMPy takes as events, a pulse of 10 ms is not stepped over."""
    t = np.linspace(0.0, 0.5, 5001)
    phase = np.clip((t - 0.1) / 0.01, 0.0, 1.0)
    columns = [t, 0.01 * np.sin(np.pi * phase) ** 2, np.pi * np.sin(2.0 * np.pi * phase)]
    road = np.rec.fromarrays(columns, names=["time", "road.z", "road.vz"])
    twice = road[np.sort(np.concatenate([np.arange(len(t)), [1000, 1100]]))]
    given = {"stop_time": 0.5, "output": ["unsprung.z"]}
    file = str(written("kart-quarter-car"))
    fine = fmpy.simulate_fmu(
        file, fmi_type="CoSimulation", step_size=1e-4, output_interval=1e-4, input=road, **given
    )["unsprung.z"][::10]  # fmt: skip
    off = []
    for inputs in (road, twice):
        found = fmpy.simulate_fmu(
            file,
            fmi_type="ModelExchange",
            relative_tolerance=1e-6,
            output_interval=1e-3,
            input=inputs,
            **given,
        )
        at = np.searchsorted(found["time"], np.arange(501) * 1e-3 - 1e-9)
        off.append(np.max(np.abs(found["unsprung.z"][at] - fine)) / np.ptp(fine))
    assert off[0] > 0.05
    assert off[1] < 0.01


def test_rates_that_are_set_to_zero_are_none(written, tmp_path):
    """Importers set inputs that nobody connected to zero, at every step."""
    fmu = instance(written("kart-quarter-car"), tmp_path, "CoSimulation")
    fmu.begin()
    for i in range(100):
        fmu.put(["road.z", "road.vz"], [1e-3 * i * 0.1, 0.0])
        fmu.step(1e-3 * i, 1e-3)
    assert fmu.get("road.vz")[0] == pytest.approx(0.1)
    fmu.close()


@pytest.mark.parametrize(
    ("name", "factors"),
    [
        ("kart-double-wishbone", {"strut.spring.rate": 1.4, "sprung.mass": 1.3}),
        # its rocker is light: accelerations across the loops once outweighed the balance, and there was no equilibrium
        pytest.param("formula-student-front", {"sprung.mass": 1.3}, marks=pytest.mark.slow),
    ],
)
def test_equilibrium_follows_changed_parameters(written, tmp_path, name, factors):
    rig = jn.load(name)
    changes = {path: factor * rig.parameters()[path] for path, factor in factors.items()}
    ours = jn.equilibrium(rig.with_changes(changes))
    fmu = instance(written(name), tmp_path, "CoSimulation")
    fmu.begin({f"rig.{path}": value for path, value in changes.items()})
    for channel in ("sprung.z", "tyre.force", "strut.force", "wheel.camber"):
        assert fmu.get(channel)[0] == pytest.approx(ours[channel], rel=1e-9, abs=1e-12)
    fmu.close()


def test_no_equilibrium_is_said(written, tmp_path):
    fmu = instance(written("kart-quarter-car"), tmp_path, "CoSimulation")
    with pytest.raises(fmpy.fmi1.FMICallException):
        fmu.begin({"rig.tyre.stiffness": 0.0})  # nothing carries the weight
    fmu.it.freeInstance()


@pytest.mark.parametrize("version", [2, 3])
def test_states_are_saved_and_restored(written, tmp_path, version):
    fmu = instance(written("kart-quarter-car", version), tmp_path, "CoSimulation")
    fmu.begin()

    def drive(first: int, last: int) -> np.ndarray:
        for i in range(first, last):
            t = 1e-3 * i
            fmu.put(["road.z", "road.vz"], [0.01 * np.sin(60.0 * t), 0.6 * np.cos(60.0 * t)])
            fmu.step(t, 1e-3)
        return fmu.get("sprung.z", "tyre.force", "strut.force")

    drive(0, 100)
    state = fmu.it.getFMUState()
    kept = fmu.it.serializeFMUState(state)
    first = drive(100, 200)
    fmu.it.setFMUState(state)
    again = drive(100, 200)
    fmu.it.setFMUState(fmu.it.deserializeFMUState(kept))
    assert np.array_equal(first, again)
    assert np.array_equal(first, drive(100, 200))
    fmu.close()


@pytest.mark.parametrize("name", QUICK)
def test_derivatives_are_those_of_differences_and_their_transpose(written, tmp_path, name):
    """Of everything that the structure lists: of a quarter car's states, too, which are outputs."""
    fmu = instance(written(name), tmp_path, "ModelExchange")
    fmu.begin()
    fmu.it.updateDiscreteStates()
    fmu.it.enterContinuousTimeMode()
    rng, n, x = np.random.default_rng(1), fmu.states, np.zeros(fmu.states)
    fmu.it.getContinuousStates(x.ctypes.data_as(fmu_master.DOUBLES), n)
    names = {v.valueReference: v.name for v in fmu.about.modelVariables}
    rates = [v for v in names if names[v].startswith("der(")]
    states = [
        v.derivative.valueReference
        for v in fmu.about.modelVariables
        if names[v.valueReference].startswith("der(")
    ]
    inputs = [
        fmu.references[name]
        for name in ("road.z", "road.vz", "rig.strut.spring.rate", "rig.sprung.mass")
    ]
    outputs = [unknown.variable.valueReference for unknown in fmu.about.outputs]
    of, by = [*rates, *outputs], [*states, *inputs]
    start = fmu.get(*(names[v] for v in by))
    seed = rng.standard_normal(len(by)) * np.maximum(np.abs(start), 1e-3)
    along = np.array(fmu.it.getDirectionalDerivative(of, by, seed.tolist()))

    def at(share: float) -> np.ndarray:
        fmu.put([names[v] for v in by], start + share * seed)
        return fmu.get(*(names[v] for v in of))

    difference = (at(1e-5) - at(-1e-5)) / 2e-5
    fmu.put([names[v] for v in by], start)
    assert np.allclose(along, difference, rtol=1e-5, atol=1e-6 * np.max(np.abs(along)))
    weight = rng.standard_normal(len(of)) / np.maximum(np.abs(along), 1e-3)
    back = np.array(fmu.it.getAdjointDerivative(of, by, weight.tolist(), nSensitivity=len(by)))
    assert weight @ along == pytest.approx(back @ seed, rel=1e-9)
    fmu.close()


def test_same_rig_gives_the_same_bytes(written, tmp_path):
    again = jn.export_fmu(jn.load("kart-quarter-car"), tmp_path / "again.fmu").path
    assert again.read_bytes() == written("kart-quarter-car").read_bytes()


@pytest.mark.skipif(shutil.which("gcc") is None, reason="no gcc")
@pytest.mark.parametrize(
    ("version", "more"), [(2, {}), (3, {"control": "skyhook", "controller_only": True})]
)
def test_code_gives_no_warning(tmp_path, version, more):
    made = jn.export_fmu(
        jn.load("kart-quarter-car"), tmp_path / "a.fmu", version=version, platforms=(), **more
    )
    with zipfile.ZipFile(made.path) as archive:
        archive.extractall(tmp_path)
    files = sorted(map(str, (tmp_path / "sources").glob("*.c")))
    words = ["gcc", "-std=c99", "-Wall", "-Wextra", "-Werror", "-O1", "-fsyntax-only", *files]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


@pytest.mark.slow
def test_code_is_clean_under_sanitizers(written, tmp_path):
    """Both uses, a landing, saved states: no undefined behaviour, no address that is not ours."""
    if not shutil.which("gcc"):
        pytest.skip("no gcc")
    with zipfile.ZipFile(written("kart-double-wishbone")) as archive:
        archive.extractall(tmp_path)
    sources = tmp_path / "sources"
    (sources / "main.c").write_text(_MAIN)
    flags = [
        "-std=c99",
        "-g",
        "-O1",
        "-Wall",
        "-Wextra",
        "-Werror",
        "-fsanitize=address,undefined",
        "-fno-sanitize-recover=all",
    ]
    files = [str(sources / name) for name in ("main.c", "model.c", "core.c", "fmi3.c")]
    subprocess.run(
        ["gcc", *flags, f"-I{sources}", *files, "-lm", "-o", str(tmp_path / "run")], check=True
    )
    done = subprocess.run([tmp_path / "run"], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "events" in done.stdout


_MAIN = r"""
#include "core.h"
#include "fmi3Functions.h"
#include <math.h>
#include <stdio.h>
int main(void) {
    fmi3Boolean flags[4];
    fmi3Float64 reached, v, next;
    fmi3FMUState state = NULL;
    fmi3Instance c = fmi3InstantiateCoSimulation("one", JN_TOKEN, "", 0, 0, 0, 0, NULL, 0, NULL, NULL, NULL);
    fmi3EnterInitializationMode(c, 0, 0, 0, 0, 0);
    if (fmi3ExitInitializationMode(c)) return 1;
    for (int i = 0; i < 400; i++) {
        fmi3ValueReference road[2] = {VR_U, VR_U + 1};
        fmi3Float64 t = 1e-3 * i, values[2] = {0.02 * sin(60 * t), 1.2 * cos(60 * t)};
        if (fmi3SetFloat64(c, road, 2, values, 2)) return 2;
        if (fmi3DoStep(c, t, 1e-3, 0, &flags[0], &flags[1], &flags[2], &reached)) return 3;
        if (i == 200) fmi3GetFMUState(c, &state);
        for (fmi3ValueReference r = 0; r <= VR_TOLERANCE; r++) if (fmi3GetFloat64(c, &r, 1, &v, 1)) return 4;
    }
    printf("events %d\n", (int)((JnInstance *)c)->s.events);
    if (((JnInstance *)c)->s.events < 4) return 5;
    fmi3SetFMUState(c, state), fmi3FreeFMUState(c, &state), fmi3FreeInstance(c);
    c = fmi3InstantiateModelExchange("two", JN_TOKEN, "", 0, 0, NULL, NULL);
    fmi3EnterInitializationMode(c, 0, 0, 0, 0, 0);
    if (fmi3ExitInitializationMode(c)) return 6;
    fmi3UpdateDiscreteStates(c, &flags[0], &flags[1], &flags[2], &flags[3], &flags[0], &next);
    double x[JN_NX], dx[JN_NX], z[JN_ROOM(JN_NM)];
    fmi3GetContinuousStates(c, x, JN_NX);
    for (int i = 1; i < 100; i++) {
        fmi3SetTime(c, 1e-4 * i), fmi3SetContinuousStates(c, x, JN_NX);
        if (fmi3GetContinuousStateDerivatives(c, dx, JN_NX) || fmi3GetEventIndicators(c, z, JN_NM)) return 7;
        for (int k = 0; k < JN_NX; k++) x[k] += 1e-4 * dx[k];
        fmi3CompletedIntegratorStep(c, 0, &flags[0], &flags[1]);
    }
    fmi3FreeInstance(c);
    return fmi3InstantiateCoSimulation("three", "another token", "", 0, 0, 0, 0, NULL, 0, NULL, NULL, NULL) ? 8 : 0;
}
"""


def test_archive_holds_what_a_receiver_needs(written):
    with zipfile.ZipFile(written("kart-quarter-car")) as archive:
        names = set(archive.namelist())
        page = archive.read("documentation/index.html").decode()
    assert {"modelDescription.xml", "sources/model.c", "sources/buildDescription.xml"} <= names
    assert {"terminalsAndIcons/terminalsAndIcons.xml", "documentation/index.html"} <= names
    assert "road.vz" in page
    assert "rig.strut.spring.rate" in page


def test_refused_before_anything_is_written(tmp_path):
    rig = jn.load("kart-quarter-car")
    there = tmp_path / "there.fmu"
    there.write_text("mine")
    with pytest.raises(jn.OutputError, match="exists"):
        jn.export_fmu(rig, there)
    assert there.read_text() == "mine"
    with pytest.raises(jn.OutputError, match=r"format; found '\.zip'"):
        jn.export_fmu(rig, tmp_path / "car.zip")
    with pytest.raises(jn.OutputError, match="FMI version"):
        jn.export_fmu(rig, tmp_path / "car.fmu", version=1)
    with pytest.raises(jn.DescriptionError, match="unknown platform 'win64'"):
        jn.export_fmu(rig, tmp_path / "car.fmu", platforms=["win64"])
    with pytest.raises(jn.SimulationError, match=r"a Python function.* cannot be part of an FMU"):
        jn.export_fmu(rig, tmp_path / "car.fmu", control=lambda _measured, _t: 0.0)
    assert [file.name for file in tmp_path.iterdir()] == ["there.fmu"]


def test_without_a_compiler_the_sources_are_written(tmp_path, monkeypatch):
    monkeypatch.setattr(build, "compiler_for", lambda _platforms: None)
    rig = jn.load("kart-quarter-car")
    made = jn.export_fmu(rig, tmp_path / "car.fmu")
    assert made.platforms == ()
    assert "no compiler was found" in made.findings[0].message
    with pytest.raises(jn.OutputError, match="no compiler for this platform"):
        jn.export_fmu(rig, tmp_path / "other.fmu", platforms=["x86_64-windows"])


@pytest.mark.parametrize(("version", "control"), [(3, None), (2, None), (3, "skyhook")])
def test_the_reference_inside_is_what_the_fmu_gives(written, tmp_path, version, control) -> None:
    """As its receiver would: inputs and outputs of the archive's own table, in co-simulation at 1 ms."""
    path = written("kart-quarter-car", version, control)
    with zipfile.ZipFile(path) as archive:
        text = archive.read("extra/jounce/reference.csv").decode()
        icon = archive.read("model.png" if version == 2 else "terminalsAndIcons/icon.png")
    assert icon.startswith(b"\x89PNG")
    table = np.genfromtxt(
        text.splitlines(), delimiter=",", names=True, deletechars="", replace_space=" "
    )
    fmu = instance(path, tmp_path, "CoSimulation")
    outputs = ["sprung.z", "unsprung.z", "tyre.force"]
    fmu.begin({"road.z": 0.0, "road.vz": 0.0})
    found = [fmu.get(*outputs)]
    for row in table[:-1]:
        fmu.put(["road.z", "road.vz"], [row["road.z"], row["road.vz"]])
        fmu.step(float(row["time"]), 1e-3)
        found.append(fmu.get(*outputs))
    for i, name in enumerate(outputs):
        own = table[name]
        assert np.abs(np.array(found)[:, i] - own).max() < 6e-3 * np.ptp(own), name


@pytest.mark.parametrize("version", [pytest.param(2, marks=pytest.mark.slow), 3])
def test_casadi_reads_rates_and_derivatives(written, tmp_path, version):
    """Another importer, with the FMU's own directional derivatives for its Jacobian."""
    import casadi as ca

    name = "kart-quarter-car"
    with zipfile.ZipFile(written(name, version)) as archive:
        archive.extractall(tmp_path)
    importer = ca.DaeBuilder("kart", str(tmp_path))
    rates = importer.create("rates", ["x", "u"], ["ode"])
    slope = importer.create("slope", ["x", "u"], ["jac_ode_x"])
    compiled = compile_rig(jn.load(name))
    p = compiled.parameter_values(jn.load(name).parameters())
    x, u = np.array([-0.012, -0.004, 0.3, -0.2]), np.array([0.001, 0.05])
    modes = np.ones(len(compiled.facts.switches))
    assert importer.x() == [fmu_name.replace(" ", "_") for fmu_name in compiled.facts.states]
    assert np.array(rates(x, u)).ravel() == pytest.approx(
        compiled.evaluate("rate", x, u, p, modes), rel=1e-12
    )
    assert np.array(slope(x, u)) == pytest.approx(
        compiled.evaluate("rate_x", x, u, p, modes), rel=1e-9
    )


def test_libcosim_runs_it(written):
    """The engine of the Open Simulation Platform reads FMI 2.0; its own files of FMI 3.0 make it fail."""
    cosim = pytest.importorskip("libcosimpy", reason="libcosimpy is not installed")
    del cosim
    from libcosimpy.CosimExecution import CosimExecution
    from libcosimpy.CosimManipulator import CosimManipulator
    from libcosimpy.CosimObserver import CosimObserver
    from libcosimpy.CosimSlave import CosimLocalSlave

    slave = CosimLocalSlave(fmu_path=str(written("kart-quarter-car", 2)), instance_name="kart")
    execution = CosimExecution.from_step_size(step_size=1e6)  # ns
    index = execution.add_local_slave(local_slave=slave)
    observer, manipulator = CosimObserver.create_last_value(), CosimManipulator.create_override()
    assert execution.add_observer(observer=observer)
    assert execution.add_manipulator(manipulator=manipulator)
    references = {
        v.name: v.valueReference
        for v in fmpy.read_model_description(str(written("kart-quarter-car", 2))).modelVariables
    }
    trial = bump(0.05)
    ours = jn.simulate(jn.load("kart-quarter-car"), trial, tolerance=1e-9)
    drive, found = course("kart-quarter-car", trial), []
    inputs = [references[name] for name in drive.names]
    for i in range(50):
        manipulator.slave_real_values(
            slave_index=index, variable_references=inputs, values=drive.values(1e-3 * i)
        )
        assert execution.step()
        found.append(
            observer.last_real_values(
                slave_index=index, variable_references=[references["sprung.z"]]
            )[0]
        )
    own = ours["sprung.z"].values[1:51]
    assert np.max(np.abs(np.array(found) - own)) < 5e-3 * np.ptp(own)
