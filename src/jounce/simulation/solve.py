"""Runs from static equilibrium, before conversion to a recording."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.errors import SimulationError, nearest
from jounce.core.findings import finding_attributes
from jounce.core.segments import Segments
from jounce.core.types import Array
from jounce.core.units import as_number
from jounce.mechanics.facts import ModelFacts
from jounce.parts import Rig
from jounce.recordings.schema import channel_unit, quantity_of, recording_of
from jounce.roads import Trial
from jounce.simulation.compiled import Compiled, compile_rig
from jounce.simulation.prepare import prepare
from jounce.simulation.problem import excitation, force_actuator
from jounce.simulation.result import Solution, cut_at_branch, samples_reached
from jounce.simulation.settings import RunSettings

if TYPE_CHECKING:
    import xarray as xr

    from jounce.simulation.controlled import AnyControl


@dataclass(frozen=True)
class RunOutput:
    """Result of a run before conversion to a recording: sample times (s), channels and attributes."""

    time: Array
    channels: dict[str, tuple[Array, str, str]]
    attributes: dict[str, Any]

    def recording(self) -> xr.Dataset:
        """Convert the result to a recording."""
        return recording_of(self.time, self.channels, attributes=self.attributes)


def solve(
    rig: Rig,
    trial: Trial,
    settings: RunSettings,
    *,
    offset: dict[str, float] | None = None,
    detail: bool = False,
    check: bool = True,
    control: AnyControl | None = None,
) -> RunOutput:
    """Run like :func:`simulate`, without building a Dataset."""
    times, method = settings.times(trial.duration), settings.method
    if not (offset or detail or control is not None):
        reduced = _solve_reduced(rig, trial, settings, times)
        if reduced is not None:
            return reduced
    loop = None
    if control is not None:
        from jounce.simulation.controlled import (
            check_coupling,
            check_stable,
            close_loop,
            raise_controller_error,
        )

        loop = close_loop(rig, control)
    if loop and trial.actuator_force is not None:
        raise SimulationError(
            "the actuator has both a controller and a given force",
            where="trial: actuator_force",
            allowed="one of the two",
        )
    compiled = compile_rig(
        rig, detail=detail, actuator=loop.actuator if loop else force_actuator(trial)
    )
    p = compiled.parameter_values(
        {**rig.parameters(), **(loop.parameters(compiled) if loop else {})}
    )
    start = start_offset(compiled, offset)
    signals = excitation(compiled.facts, rig, trial)
    if loop and method == "implicit":
        raise SimulationError(
            "controlled runs need the explicit method",
            where="method",
            found=method,
            allowed="auto, explicit",
        )
    if loop:
        signals, method = loop.with_rest(compiled, signals, p), "explicit"
    prepared = prepare(
        compiled, p, signals, times, tolerance=settings.tolerance, offset=start, method=method
    )
    if loop:
        if check and prepared.equilibrium is not None:
            check_stable(loop, compiled, p, prepared.equilibrium, prepared.still)
        prepared = loop.around(compiled, prepared, signals)
        if check:
            check_coupling(loop, compiled, p, prepared)
    solution = prepared.run()
    if loop:
        raise_controller_error(loop)
    solution = cut_at_branch(compiled, solution)
    reach = samples_reached(solution, compiled.facts, check=check)
    result = _output(compiled, solution, reach)
    if loop and loop.findings:
        result = replace(result, attributes=result.attributes | finding_attributes(loop.findings))
    return result


def _solve_reduced(rig: Rig, trial: Trial, settings: RunSettings, times: Array) -> RunOutput | None:
    """Run reduced corners; None if that is not possible and the full mechanism is required."""
    from jounce.simulation.reduced import ReducedCorner, reduction_for
    from jounce.simulation.reduced_car import ReducedCar, car_reduction_for
    from jounce.simulation.sampled import DEGREES

    def course(facts: ModelFacts) -> tuple[dict[str, float], list[Segments], Array, float]:
        return rig.parameters(), excitation(facts, rig, trial), times, settings.tolerance

    if (corner := reduction_for(rig, trial, settings)) is not None:
        run = ReducedCorner(corner, *course(corner.compiled(DEGREES[0]).facts)).run()
    elif (car := car_reduction_for(rig, trial, settings)) is not None:
        run = ReducedCar(car, *course(car.compiled(DEGREES[0]).facts)).run()
    else:
        return None
    if run is None:
        return None
    return _output(run[1].compiled, run[0], len(times))


def _output(compiled: Compiled, solution: Solution, reach: int) -> RunOutput:
    """Return the first ``reach`` samples of a run."""
    channels = {
        output.name: (solution.outputs[i, :reach], output.unit, output.long_name)
        for i, output in enumerate(compiled.facts.outputs)
    }
    times = solution.time
    times = (
        times if reach == len(times) else times[:reach]
    )  # pass the whole array: its derived data are cached
    how = {"status": solution.status.name.lower(), "method": solution.method}
    return RunOutput(times, channels, {**how, "steps": solution.steps, "events": solution.events})


def start_offset(compiled: Compiled, offset: Mapping[str, float] | None) -> Array | None:
    """Return the offsets of all states (SI) from offsets by name; None if none are given."""
    if not offset:
        return None
    names = compiled.facts.states
    shift = np.zeros(len(names))
    for name, value in offset.items():
        if name not in names:
            hint = nearest(name, names)
            raise SimulationError(
                "not a state of the model", where=name, allowed=", ".join(names), hint=hint
            )
        si = channel_unit(name) if quantity_of(name) else "1"
        shift[names.index(name)] = number = as_number(value, si, where=f"offset: {name}")
        if not np.isfinite(number):
            raise SimulationError(
                "not a finite number", where=f"offset: {name}", found=number, allowed="m or m/s"
            )
    return shift
