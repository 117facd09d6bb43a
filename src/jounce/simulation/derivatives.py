"""Exact sensitivities of a run, and gradients of objectives, with respect to any parameters of the rig."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.errors import SimulationError, unknown
from jounce.core.phrases import Phrase
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.kernel.engine import Status
from jounce.mechanics.facts import ModelFacts
from jounce.parts import Rig
from jounce.parts.rig import check_rig, unit_of, unknown_path
from jounce.recordings.carried import as_recording, is_table
from jounce.recordings.schema import check_recording, place_of
from jounce.roads import HoldsTrial, Trial, as_trial
from jounce.simulation.compiled import compile_rig
from jounce.simulation.prepare import solve
from jounce.simulation.problem import excitation, force_actuator
from jounce.simulation.reduced import with_slopes
from jounce.simulation.result import Solution
from jounce.simulation.settings import RunSettings

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr


@dataclass(frozen=True)
class Gradient(Shown):
    """Value of an objective and its slope with respect to each parameter.

    Attributes
    ----------
    value : float
        The objective, in the square of its channels' SI units.
    gradient : dict
        Parameter path to the slope, per SI unit of the parameter.
    channels : dict
        Contribution of each channel to the value, SI.
    """

    value: float
    gradient: dict[str, float]
    channels: dict[str, float]


def sensitivities(
    rig: Rig,
    trial: Trial | HoldsTrial,
    parameters: Sequence[str],
    *,
    output_step: float = 1e-3,
    tolerance: float = 1e-5,
) -> xr.Dataset:
    """Differentiate all channels of a run with respect to parameters, exactly, during the simulation.

    The run starts from static equilibrium, which depends on the parameters as well.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle.
    trial : Trial
        Road and speed, or a base motion, and the duration.
    parameters : sequence of str
        Paths, e.g. ``"hardpoints.tie_rod_outer[2]"``.
    output_step, tolerance : float
        As in :class:`jounce.simulation.RunSettings`: s, 1.

    Returns
    -------
    xarray.Dataset
        One variable for each channel, over ``parameter`` and ``time`` (s). ``units`` is the channel's unit; values are
        per SI unit of the parameter, given by the coordinate ``parameter_units``. ``attrs["method"]`` is the method:
        "reduced explicit" for a reduced corner, otherwise that of the full model.

    Raises
    ------
    DescriptionError
        If the description does not have a path.
    SimulationError
        If the model does not use a parameter, for the wheelbase on a road (it delays the rear axle), or if the run
        stops before its end.

    Examples
    --------
    >>> import jounce as jn
    >>> trial = jn.Trial(road=jn.HalfSine(height="10 mm", length="60 mm"), speed="1.95 m/s", duration="0.5 s")
    >>> slopes = jn.sensitivities(jn.load("kart-quarter-car"), trial, ["tyre.stiffness", "sprung.mass"])
    >>> round(float(slopes["tyre.force"].sel(parameter="sprung.mass")[0]), 2)   # at rest: gravity
    9.81
    """
    import xarray as xr

    trial = as_trial(trial)
    times = RunSettings(output_step, tolerance).times(trial.duration)
    facts, solution = _run(rig, trial, parameters, times, tolerance)
    variables = {}
    for output, slopes in zip(facts.outputs, solution.output_slopes, strict=True):
        attrs = {
            "units": output.unit,
            "long_name": output.long_name,
            "place": place_of(output.name),
        }
        variables[output.name] = (("parameter", "time"), slopes, attrs)
    units = [unit_of(rig, path) for path in parameters]
    coordinates = {
        "parameter": list(parameters),
        "parameter_units": ("parameter", units),
        "time": ("time", times, {"units": "s"}),
    }
    how = {"method": solution.method, "steps": solution.steps, "events": solution.events}
    return xr.Dataset(variables, coordinates, how)


def gradient(
    rig: Rig,
    trial: Trial | HoldsTrial,
    parameters: Sequence[str],
    objective: xr.Dataset | pd.DataFrame | Mapping[str, float],
    *,
    weights: Mapping[str, float] | None = None,
    output_step: float = 1e-3,
    tolerance: float = 1e-5,
) -> Gradient:
    """Differentiate an objective of a run with respect to parameters, exactly.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle.
    trial : Trial
        Road and speed, or a base motion, and the duration.
    parameters : sequence of str
        Paths, e.g. ``"strut.spring.rate"``.
    objective : xarray.Dataset, pandas.DataFrame or mapping
        A recording in SI units, or a table with columns ``name [unit]``: the objective is the sum of
        (measured - simulated)^2 over its channels and samples. Alternatively weights (1) by channel: the objective is
        the weighted sum of the channels' mean squares over the trial.
    weights : mapping, optional
        For a recording, weights (1) by channel; other channels are ignored. By default all channels have weight 1.
    output_step, tolerance : float
        As in :class:`jounce.simulation.RunSettings`: s, 1. A recording is compared at its own times.

    Returns
    -------
    Gradient
        Value and slopes.

    Raises
    ------
    DescriptionError
        If a path or a channel does not exist.
    SimulationError
        If the model does not use a parameter, a recording is longer than the trial, or the run stops before its
        end.
    RecordingError
        If a recording is not in SI units or not finite.

    Examples
    --------
    Slopes of the mean square body acceleration by spring rate and damping:

    >>> import jounce as jn
    >>> trial = jn.Trial(road=jn.HalfSine(height="10 mm", length="60 mm"), speed="1.95 m/s", duration="1 s")
    >>> rig = jn.load("kart-quarter-car")
    >>> slopes = jn.gradient(rig, trial, ["strut.spring.rate", "strut.damper.coefficient"], {"sprung.az": 1.0}).gradient
    >>> slopes["strut.spring.rate"] > 0.0 > slopes["strut.damper.coefficient"]   # softer and more damped is better
    True
    """
    import xarray as xr

    trial = as_trial(trial)
    times = RunSettings(output_step, tolerance).times(trial.duration)
    measured: xr.Dataset | None = None
    if is_table(objective) or isinstance(objective, xr.Dataset):
        measured = as_recording(objective, where="objective")
        wanted = dict(weights or dict.fromkeys(map(str, measured.data_vars), 1.0))
        others = [name for name in measured.data_vars if name not in wanted]
        check_recording(measured.drop_vars(others), where="objective")
        times = _times_of(measured, trial)
    elif weights is not None:
        raise SimulationError(
            "weights require a recording",
            where="weights",
            hint="The objective already contains weights.",
        )
    else:
        wanted = {name: objective[name] for name in objective}
    facts, solution = _run(rig, trial, parameters, times, tolerance)
    names, shares, slopes = (
        tuple(output.name for output in facts.outputs),
        {},
        np.zeros(len(parameters)),
    )
    for name, weight in wanted.items():
        _check_channel(name, weight, names, measured)
        signal, along = (
            part[names.index(name)] for part in (solution.outputs, solution.output_slopes)
        )
        if measured is None:
            errors, weight = signal, weight / len(signal)  # noqa: PLW2901
        else:
            count = measured.sizes["time"]
            errors, along = signal[-count:] - measured[name].to_numpy(), along[:, -count:]
        shares[name] = float(weight * (errors @ errors))
        slopes += 2.0 * weight * (along @ errors)
    return Gradient(
        sum(shares.values()), dict(zip(parameters, map(float, slopes), strict=True)), shares
    )


def _run(
    rig: Rig, trial: Trial, parameters: Sequence[str], times: Array, tolerance: float
) -> tuple[ModelFacts, Solution]:
    """Simulate with sensitivities."""
    values = check_rig(rig).parameters()
    if isinstance(parameters, str) or not parameters or len(set(parameters)) < len(parameters):
        allowed = "a list of at least one path, each only once"
        raise SimulationError(
            "invalid choice of parameters", where="parameters", found=parameters, allowed=allowed
        )
    for path in parameters:
        if path not in values:
            raise unknown_path(f"parameters: {path}", values, name=path)
    free, plain = tuple(parameters), compile_rig(rig, actuator=force_actuator(trial))
    signals = excitation(plain.facts, rig, trial, free)
    solution = with_slopes(rig, trial, values, signals, times, tolerance, free)
    if solution is None:
        compiled = compile_rig(rig, free, actuator=force_actuator(trial))
        solution = solve(
            compiled, compiled.parameter_values(values), signals, times, tolerance=tolerance
        )
    if solution.status is not Status.COMPLETED:
        raise SimulationError("the run did not reach its end", found=solution.status.help)
    return plain.facts, solution


def _times_of(measured: xr.Dataset, trial: Trial) -> Array:
    """Return the times of a recording, with 0 prepended if it starts later, since runs begin at 0."""
    times = np.asarray(measured["time"].to_numpy(), dtype=np.float64)
    if (
        not len(times)
        or not np.all(np.diff(times) > 0.0)
        or times[0] < 0.0
        or times[-1] > trial.duration * (1 + 1e-9)
    ):
        raise SimulationError(
            "the recording does not fit the trial",
            where="objective: time",
            found=f"{times[0]:g} to {times[-1]:g} s" if len(times) else "no samples",
            allowed=Phrase("rising times from 0 to {duration:g} s", duration=trial.duration),
        )
    return times if times[0] == 0.0 else np.concatenate([[0.0], times])


def _check_channel(
    name: str, weight: float, names: tuple[str, ...], measured: xr.Dataset | None
) -> None:
    if name not in names:
        raise unknown(name, names, what="channel", where="objective")
    if measured is not None and name not in measured:
        raise unknown(
            name, [str(channel) for channel in measured.data_vars], what="channel", where="weights"
        )
    if not (np.isfinite(weight) and weight >= 0.0):
        raise SimulationError(
            "invalid weight", where=f"objective: {name}", found=weight, allowed="0 or more"
        )
