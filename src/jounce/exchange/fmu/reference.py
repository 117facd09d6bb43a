"""What an FMU shall give: our own run on a smooth bump, for whoever received it to compare with."""

from __future__ import annotations

import numpy as np

from jounce.exchange.fmu.variables import structured
from jounce.mechanics.facts import Facts, speed_of
from jounce.parts import Rig
from jounce.roads import Trial, Versine
from jounce.simulation.controlled import AnyControl
from jounce.simulation.problem import excitation
from jounce.simulation.run import simulate

TOLERANCE = 1e-8
_BUMP = Trial(road=Versine(height=0.01, length=0.5, start=0.1), speed=5.0, duration=0.3)
NOTE = """<h2>To test it</h2>
<p><code>extra/jounce/reference.csv</code> in the archive holds a run of jounce over a bump of 10 mm and 0.5 m at 5 m/s:
the first columns are time (s) and inputs, the others outputs, all SI. Connect the inputs, start at rest, compare.</p>
"""


def reference(rig: Rig, facts: Facts, control: AnyControl | None) -> bytes:
    """Time, inputs and channels of the run as CSV, every 1 ms, SI to nine digits; names are those of the FMU."""
    run = simulate(rig, _BUMP, control=control, tolerance=TOLERANCE)
    time = run["time"].to_numpy()
    columns = {"time": time}
    commands = {
        name for name in facts.tracks if name.rpartition(".")[2] == "command"
    }  # the controller inside sets them
    for track, signal in zip(facts.tracks, excitation(facts, rig, _BUMP), strict=True):
        if track not in commands:
            value, rate = signal.evaluate(time)[:2]
            columns[track], columns[speed_of(track)] = value, rate
    columns |= {str(name): run[name].to_numpy() for name in run.data_vars if name not in columns}
    rows = [",".join(map(structured, columns))]
    rows += [",".join(f"{value + 0.0:.9g}" for value in row) for row in np.column_stack([*columns.values()])]
    return ("\n".join(rows) + "\n").encode()
