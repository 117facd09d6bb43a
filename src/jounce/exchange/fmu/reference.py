"""Reference results of an FMU: a jounce simulation of a smooth bump or motion, for comparison by the user."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from jounce.core.types import Array
from jounce.exchange.fmu.variables import structured_name
from jounce.mechanics import Mechanism, constant, constant_rate
from jounce.mechanics.facts import ModelFacts, speed_of
from jounce.parts import Rig
from jounce.roads import Trial, Versine
from jounce.simulation.controlled import AnyControl
from jounce.simulation.free_run import simulate_mechanism
from jounce.simulation.problem import excitation
from jounce.simulation.run import simulate
from jounce.testers.rig import TesterRig

TOLERANCE = 1e-8  # the reference file has nine digits
_BUMP = Trial(road=Versine(height=0.01, length=0.5, start=0.1), speed=5.0, duration=0.3)
_SECONDS, _STEP, _TURNS = 0.3, 1e-3, 10.0  # s, s, Hz
Given = Callable[[], tuple[Mapping[str, Array], str]]
"""Function that returns columns by name (time first), and a description of the run."""


def of_rig(
    rig: Rig, facts: ModelFacts, control: AnyControl | None
) -> tuple[Mapping[str, Array], str]:
    """Simulate a rig over a bump."""
    run = simulate(rig, _BUMP, control=control, tolerance=TOLERANCE)
    time = run["time"].to_numpy()
    columns = {"time": time}
    for track, signal in zip(facts.tracks, excitation(facts, rig, _BUMP), strict=True):
        if track.rpartition(".")[2] != "command":  # commands are set by the built-in controller
            columns[track], columns[speed_of(track)] = signal.evaluate(time)[:2]
    columns |= {str(name): run[name].to_numpy() for name in run.data_vars if name not in columns}
    return columns, "over a bump of 10 mm and 0.5 m at 5 m/s"


def of_tester(on: TesterRig) -> tuple[Mapping[str, Array], str]:
    """Simulate a rig on a tester with exciters at 10 Hz."""
    time = np.linspace(0.0, _SECONDS, round(_SECONDS / _STEP) + 1)
    rate = 2.0 * np.pi * _TURNS
    turning = constant_rate(rate)
    solution = on.run(dict.fromkeys(on.places, turning), time, fastest=rate, tolerance=TOLERANCE)
    columns = {"time": time}
    for track in on.compiled.facts.tracks:
        columns[track], columns[speed_of(track)] = rate * time, np.full_like(time, rate)
    given = dict(zip(on.compiled.output_names, solution.outputs, strict=True))
    return columns | {
        name: value for name, value in given.items() if name not in columns
    }, "with exciters at 10 Hz"


def of_mechanism(mechanism: Mechanism) -> tuple[Mapping[str, Array], str]:
    """Simulate a mechanism released from its design pose, with all inputs at zero."""
    still = constant(0.0)
    run = simulate_mechanism(
        mechanism,
        _SECONDS,
        motions=dict.fromkeys(mechanism.tracks, still),
        output_step=_STEP,
        tolerance=TOLERANCE,
    )
    time = run["time"].to_numpy()
    columns = {"time": time}
    for track in mechanism.tracks:
        columns[track] = columns[speed_of(track)] = np.zeros_like(time)
    columns |= {str(name): run[name].to_numpy() for name in run.data_vars if name not in columns}
    return columns, "released from its design pose"


def reference(given: Given) -> tuple[bytes, str]:
    """Return the run as CSV (every 1 ms, SI, nine digits, names of the FMU), and a note for the documentation."""
    columns, what = given()
    rows = [",".join(map(structured_name, columns))]
    rows += [
        ",".join(f"{value + 0.0:.9g}" for value in row)
        for row in np.column_stack([*columns.values()])
    ]
    note = f"""<h2>How to test it</h2>
<p><code>extra/jounce/reference.csv</code> in the archive contains a jounce simulation {what}.
The first columns are time (s) and inputs, the others are outputs, all SI. Connect the inputs, compare the outputs.</p>
"""
    return ("\n".join(rows) + "\n").encode(), note
