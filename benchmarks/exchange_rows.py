"""FMUs: what an instant of a component costs in a run, and how fast exported rigs step."""

from __future__ import annotations

import sys
import tempfile
from functools import partial
from pathlib import Path
from typing import Any

from timing import Row, median_time

import jounce as jn
from jounce.control.fmu import FmuControl, caller, read_fmu
from jounce.control.fmu.component import unpacked

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
    """A run of 10 000 control instants with a component FMU, beside a function in Python that does nothing."""
    rig = jn.load("audi-a6-quarter-car")
    road = jn.Iso8608(**{"class": "C", "seed": 1, "length": "250 m"})
    trial = jn.Trial(road=road, speed="20 m/s", duration=_SECONDS)
    instants = _SECONDS * _RATE
    problem = f"quarter car, ISO C, {instants:.0f} control instants"
    laws: list[tuple[str, Any, str]] = [("a function in Python", jn.PythonControl(function=lambda _m, _t: 1500.0), "")]
    for version in (2, 3):
        file = fmu_component.write(folder / f"{version}.fmu", version, fmu_component.binary(version, folder))
        fields = {"file": str(file), "inputs": _INPUTS, "output": "coefficient"}
        laws.append((f"component FMU, FMI {version}.0", FmuControl(**fields, trusted=True), "≤ 5 µs an instant"))
    laws.append(("the same in a process of its own", FmuControl(**fields), ""))
    rows, own = [], 0.0
    for way, law, target in laws:
        median = median_time(partial(jn.simulate, rig, trial, control=law, output_step=1e-2), repeats=7)
        own = own or median
        note = f"{1e6 * median / instants:.2g} µs an instant, with the run"
        rows.append(Row(problem, way, median, None, median / own, target, note))
    return rows


def _export_rows(folder: Path) -> list[Row]:
    """An exported rig in co-simulation at 1 ms, called by our own master."""
    rows = []
    for name, count, target in (
        ("kart-quarter-car", 20_000, "≥ 5 000 × real time"),
        ("sedan-full-car-3d", 1000, "≥ 10 ×"),
    ):
        file = folder / f"{name}.fmu"
        jn.export_fmu(jn.load(name), file)
        about = read_fmu(file)
        inputs = [v.reference for v in about.inputs if v.is_real]
        told = {
            "library": str(unpacked(about) / about.binary()), "version": about.version, "token": about.token,
            "resources": "", "period": _STEP, "inputs": inputs, "outputs": [about.outputs[0].reference], "starts": [],
        }  # fmt: skip
        instances = caller.Instances([told])
        still = [0.0] * len(inputs)

        def run(instances: caller.Instances = instances, still: list[float] = still, count: int = count) -> None:
            instances.start()
            for _ in range(count):
                instances.step(still)

        median = median_time(run, repeats=5)
        note = f"{count * _STEP / median:.0f} × real time"
        rows.append(Row(f"FMU of {name}, co-simulation at 1 ms", "our own master", median, None, None, target, note))
    return rows
