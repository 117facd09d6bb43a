"""FMUs: cost of a component per control instant, and speed of exported rigs."""

from __future__ import annotations

import ctypes
import math
import subprocess
import sys
import tempfile
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from timing import Row, median_time, processor_time, side_by_side

import jounce as jn
from jounce.control.fmu import FmuControl, caller, read_fmu
from jounce.control.fmu.component import unpack
from jounce.control.fmu.platforms import PLATFORMS, this_platform
from jounce.core.types import Array
from jounce.exchange.fmu import build
from jounce.simulation.compiled import compile_rig
from jounce.simulation.statics import find_equilibrium

sys.path.insert(0, str(Path(__file__).parent.parent / "tests" / "twins"))
import fmu_component  # noqa: E402 - the component of the tests

_INPUTS = {"v_body": "sprung.vz", "v_strut": "strut.velocity"}
_SECONDS, _RATE, _STEP = 10.0, 1000.0, 1e-3


def exchange_rows() -> list[Row]:
    """Rows of import and export."""
    if not fmu_component.can_be_made():
        return []
    with tempfile.TemporaryDirectory() as folder:
        return [*_import_rows(Path(folder)), *_export_rows(Path(folder))]


def _import_rows(folder: Path) -> list[Row]:
    """A run of 10 000 control instants with a component FMU, compared with an empty Python function."""
    rig = jn.load("audi-a6-quarter-car")
    road = jn.Iso8608(**{"class": "C", "seed": 1, "length": "250 m"})
    trial = jn.Trial(road=road, speed="20 m/s", duration=_SECONDS)
    instants = _SECONDS * _RATE
    problem = f"quarter car, ISO C, {instants:.0f} control instants"
    laws: list[tuple[str, Any, str]] = [
        ("Python function", jn.PythonControl(function=lambda _m, _t: 1500.0), "")
    ]
    for version in (2, 3):
        file = fmu_component.write(
            folder / f"{version}.fmu", version, fmu_component.binary(version, folder)
        )
        fields = {"file": str(file), "inputs": _INPUTS, "output": "coefficient"}
        laws.append(
            (
                f"component FMU, FMI {version}.0",
                FmuControl(**fields, trusted=True),
                "≤ 5 µs per instant",
            )
        )
    laws.append(("the same in a separate process", FmuControl(**fields), ""))
    runs = [partial(jn.simulate, rig, trial, control=law, output_step=1e-2) for _, law, _ in laws]
    measured = side_by_side([partial(processor_time, run) for run in runs[:-1]])
    measured.append(
        (median_time(runs[-1], repeats=7), math.nan)
    )  # its child's time is none of this process
    rows = []
    for (way, _, target), (median, ratio) in zip(laws, measured, strict=True):
        clock = "wall clock, " if math.isnan(ratio) else ""
        note = f"{clock}{1e6 * median / instants:.2g} µs per instant, run included"
        rows.append(
            Row(problem, way, median, None, None if math.isnan(ratio) else ratio, target, note)
        )
    return rows


def _export_rows(folder: Path) -> list[Row]:
    """An exported rig in co-simulation at 1 ms, and one evaluation of its derivatives beside jounce's code."""
    rows = []
    own = _master(folder)
    for name, count, real_time, slower in (
        ("kart-quarter-car", 20_000, "≥ 5 000 × real time", "≤ 1.5"),
        ("kart-double-wishbone", 5000, "", "≤ 1.5"),
        ("sedan-full-car-3d", 1000, "≥ 10 ×", "≤ 3.5"),
    ):
        file = folder / f"{name}.fmu"
        jn.export_fmu(jn.load(name), file)
        about = read_fmu(file)
        inputs = [
            ("Float64", v.reference, 0, [0.0]) for v in about.inputs if v.unit in ("m", "m/s")
        ]
        told = {
            "library": str(unpack(about) / about.binary()), "version": about.version, "token": about.token,
            "resources": "", "period": _STEP, "inputs": inputs, "starts": [],
            "outputs": [("Float64", about.outputs[0].reference, 0, [0.0])],
        }  # fmt: skip
        instances = caller.Instances([told])
        still = [0.0] * len(inputs)

        def run(
            instances: caller.Instances = instances, still: list[float] = still, count: int = count
        ) -> None:
            instances.start()
            for _ in range(count):
                instances.step(still)

        problem = f"FMU of {name}, co-simulation at 1 ms"
        in_c = min(_stepped(own, told, count) for _ in range(7))
        note = "× real time, processor time"
        rows.append(
            Row(
                problem,
                "importer in C",
                in_c,
                None,
                1.0,
                real_time,
                f"{count * _STEP / in_c:.0f} {note}",
            )
        )
        in_python = min(processor_time(partial(run, instances)) for _ in range(5))
        own_note = f"{count * _STEP / in_python:.0f} {note}"
        rows.append(
            Row(
                problem,
                "jounce's importer in Python",
                in_python,
                None,
                in_python / in_c,
                "",
                own_note,
            )
        )
        (here, _), (there, ratio), (asked, as_asked) = side_by_side(_rates(own, told, name))
        problem = f"{name}, one evaluation of the state derivatives"
        rows.append(Row(problem, "jounce's machine code", here, None, 1.0))
        rows.append(Row(problem, "the FMU's binary", there, None, ratio, slower))
        note = "states set and projected onto the loops, derivatives read"
        rows.append(Row(problem, "the FMU through its interface", asked, None, as_asked, "", note))
    return rows


def _master(folder: Path) -> ctypes.CDLL:
    """Compile the importer in C."""
    compiler = build.compiler_for((this_platform(),))
    assert compiler is not None
    out = folder / f"master{PLATFORMS[this_platform()].suffix}"
    source = Path(__file__).with_name("fmu_master.c")
    words = [
        *compiler[1],
        "-std=c99",
        "-O2",
        "-fPIC",
        "-shared",
        "-o",
        str(out),
        str(source),
        "-lm",
    ]
    subprocess.run(words, check=True)
    library = ctypes.CDLL(str(out))
    for name in ("steps", "rates", "native"):
        getattr(library, name).restype = ctypes.c_double
    return library


def _function(library: ctypes.CDLL, name: str) -> ctypes.c_void_p:
    return ctypes.cast(library[f"fmi3{name}"], ctypes.c_void_p)


def _begun(told: dict[str, Any], kind: str) -> tuple[ctypes.CDLL, ctypes.c_void_p]:
    """The library of an FMU, and an instance of it after initialisation."""
    library = ctypes.CDLL(told["library"])
    make = library[f"fmi3Instantiate{kind}"]
    make.restype = ctypes.c_void_p
    flags = (0, 0, None, 0, None) if kind == "CoSimulation" else (None,)
    found = ctypes.c_void_p(make(b"one", told["token"].encode(), b"", 0, 0, *flags, None, None))
    number = ctypes.c_double(0.0)
    library.fmi3EnterInitializationMode(found, False, number, number, False, number)
    if library.fmi3ExitInitializationMode(found):
        raise RuntimeError("the FMU was not initialised")
    return library, found


def _stepped(own: ctypes.CDLL, told: dict[str, Any], count: int) -> float:
    library, instance = _begun(told, "CoSimulation")
    inputs = [reference for _, reference, *_ in told["inputs"]]
    addresses = [_function(library, name) for name in ("SetFloat64", "DoStep", "GetFloat64")]
    array = (ctypes.c_uint32 * len(inputs))(*inputs)
    size, out = ctypes.c_size_t(len(inputs)), ctypes.c_uint32(told["outputs"][0][1])
    seconds = own.steps(*addresses, instance, array, size, out, count, ctypes.c_double(_STEP))
    library.fmi3FreeInstance(instance)
    return _measured(seconds)


def _rates(own: ctypes.CDLL, told: dict[str, Any], name: str) -> list[Callable[[], float]]:
    """Time (s) to evaluate derivatives at rest: jounce's code, the FMU's binary, the FMU through its interface."""
    compiled = compile_rig(jn.load(name))
    p, u = compiled.parameter_values(jn.load(name).parameters()), compiled.inputs({})
    rest = find_equilibrium(compiled, p, u)
    n, count = len(rest.x), 100_000 if len(rest.x) < 10 else 2000
    x, dx = (ctypes.c_double * n)(*rest.x), (ctypes.c_double * n)()
    library, instance = _begun(told, "ModelExchange")
    # What depends on parameters alone is taken out of both, in an order of its own.
    extended = np.zeros(100_000)
    library.jn_derived(_at(np.ascontiguousarray(p, dtype=float)), _at(extended))
    known = [
        np.ascontiguousarray(part, dtype=float)
        for part in (u, compiled.plain.extend(p), rest.modes)
    ]
    ours, theirs = (
        ctypes.c_void_p(compiled.plain.native.address["rate"]),
        ctypes.cast(library.jn_rate, ctypes.c_void_p),
    )
    addresses = [
        _function(library, word)
        for word in ("SetContinuousStates", "GetContinuousStateDerivatives")
    ]

    def evaluated(rate: ctypes.c_void_p, e: Array) -> float:
        return float(own.native(rate, x, _at(known[0]), _at(e), _at(known[2]), dx, count)) / count

    def asked() -> float:
        return _measured(own.rates(*addresses, instance, x, dx, ctypes.c_size_t(n), count)) / count

    return [partial(evaluated, ours, known[1]), partial(evaluated, theirs, extended), asked]


def _at(values: Array) -> ctypes.c_void_p:
    return ctypes.c_void_p(values.ctypes.data)


def _measured(seconds: float) -> float:
    if seconds < 0.0:
        raise RuntimeError("the FMU refused a step")
    return seconds
