"""Analysis of misfits over speed: response, sensitivity and residuals."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from jounce.campaign.result import CampaignResult
from jounce.campaign.trial_result import TrialComparison
from jounce.core.errors import DescriptionError, FitError, SimulationError
from jounce.core.samples import as_values
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.identify.fit_problem import FitTrial, FreeParameter, UpdateProblem
from jounce.identify.settings import UpdateSettings
from jounce.parts import Rig
from jounce.parts.rig import unknown_path
from jounce.recordings.schema import recording_of
from jounce.roads import Road, Train, Trial
from jounce.simulation.settings import RunSettings

if TYPE_CHECKING:
    import xarray as xr

CHANNELS = ("sprung.az", "unsprung.az")
PARAMETERS = ("strut.spring.rate", "strut.damper.coefficient", "tyre.stiffness")
_WATCHED = {"sprung.z": "m", "sprung.az": "m/s^2", "unsprung.az": "m/s^2", "tyre.force": "N"}


def speed_sweep(
    rig: Rig,
    road: Road,
    speeds: ArrayLike | Sequence[str],
    *,
    duration: float | str = 3.0,
    parameters: Sequence[str] = PARAMETERS,
    output_step: float = 1e-3,
) -> xr.Dataset:
    """Drive a rig over a road at many speeds; report its response and the parameters that govern it.

    Parameters
    ----------
    rig : Rig
        Rig with a tyre force.
    road : Road
        An obstacle or a train.
    speeds : array_like, shape (n,)
        Speeds in m/s, or text with units; above 0.
    duration : float or str
        Duration of each run, s.
    parameters : sequence of str
        Paths of the parameters to examine; their values must not be zero.
    output_step : float
        Time step of the samples, s.

    Returns
    -------
    xarray.Dataset
        On ``speed`` (m/s): ``peak_body_acceleration``, ``peak_wheel_acceleration`` (largest size, m/s^2),
        ``peak_body_displacement`` (largest distance from rest, m), ``lift_off_time`` (s), ``contact_events`` (losses
        and returns of contact, 1), ``obstacle_frequency`` (speed over the length of one obstacle, Hz) and
        ``pass_frequency`` (speed over pitch, Hz, NaN for a single obstacle).
        On ``speed``, ``channel`` and ``parameter``: ``sensitivity``, the r.m.s. over the run of d(signal) over
        d(ln parameter) in m/s^2 (what a relative error of the parameter does to the signal, exact), and
        ``relative_sensitivity``, the same over the r.m.s. of the signal (1).

    Raises
    ------
    DescriptionError
        If a speed is not above 0.
    FitError
        If the value of a parameter is zero.

    Examples
    --------
    >>> import jounce as jn
    >>> road = jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m")
    >>> sweep = speed_sweep(jn.load("kart-quarter-car"), road, [1.95, 2.86, 3.79], duration="1 s")
    >>> bool((sweep["lift_off_time"] > 0.0).all())   # the wheel leaves the obstacle at all of them
    True
    """
    import xarray as xr

    velocity = _speeds(speeds)
    free = _logarithmic(rig, parameters)
    length = to_si(duration, "s", where="duration")
    rows, table = [], np.empty((len(velocity), len(CHANNELS), len(free), 2))
    for i, speed in enumerate(velocity):
        trial = Trial(road=road, speed=float(speed), duration=length)
        numbers, table[i] = _sweep_point(rig, trial, free, output_step)
        rows.append(numbers)
    obstacle, pitch = (road.of, road.pitch) if isinstance(road, Train) else (road, np.nan)
    span = obstacle.profile().span
    by_speed = {name: [row[name] for row in rows] for name in rows[0]} | {
        "obstacle_frequency": velocity / span if span > 0.0 else np.full(len(velocity), np.nan),
        "pass_frequency": velocity / pitch,
    }
    dimensions = ("speed", "channel", "parameter")
    return xr.Dataset(
        {
            **{
                name: ("speed", np.asarray(values, dtype=float), _LABELS[name])
                for name, values in by_speed.items()
            },
            "sensitivity": (dimensions, table[..., 0], _LABELS["sensitivity"]),
            "relative_sensitivity": (dimensions, table[..., 1], _LABELS["relative_sensitivity"]),
        },
        coords={
            "speed": ("speed", velocity, {"units": "m/s", "long_name": "speed"}),
            "channel": list(CHANNELS),
            "parameter": list(parameters),
        },
    )


_LABELS = {
    "peak_body_acceleration": {"units": "m/s^2", "long_name": "peak acceleration of the body"},
    "peak_wheel_acceleration": {"units": "m/s^2", "long_name": "peak acceleration of the wheel"},
    "peak_body_displacement": {
        "units": "m",
        "long_name": "peak displacement of the body from rest",
    },
    "lift_off_time": {"units": "s", "long_name": "time without contact"},
    "contact_events": {"units": "1", "long_name": "losses and returns of contact"},
    "obstacle_frequency": {"units": "Hz", "long_name": "speed over obstacle length"},
    "pass_frequency": {"units": "Hz", "long_name": "speed over pitch"},
    "sensitivity": {
        "units": "m/s^2",
        "long_name": "r.m.s. change of the signal for a relative change of the parameter",
    },
    "relative_sensitivity": {
        "units": "1",
        "long_name": "that change over the r.m.s. of the signal",
    },
}


def _speeds(speeds: ArrayLike | Sequence[str]) -> Array:
    velocity = as_values(speeds, "m/s", where="speeds")
    if len(velocity) == 0 or not np.all(velocity > 0.0):
        raise DescriptionError(
            "invalid speeds",
            where="speeds",
            found=speeds,
            allowed="one or more above 0 m/s",
        )
    return velocity


def _logarithmic(rig: Rig, parameters: Sequence[str]) -> tuple[FreeParameter, ...]:
    """Free parameters whose scaled unit is their own value, so that derivatives are with respect to the logarithm."""
    values = rig.parameters()
    for path in parameters:
        if path not in values:
            raise unknown_path(f"speed sweep: {path}", values, name=path)
        if values[path] == 0.0:
            raise FitError(
                "a value of zero has no relative sensitivity",
                where=path,
                hint="Use a small nonzero value.",
            )
    return tuple(FreeParameter(path, values[path], 0.0, 2.0 * values[path]) for path in parameters)


def _sweep_point(
    rig: Rig, trial: Trial, free: tuple[FreeParameter, ...], output_step: float
) -> tuple[dict[str, float], Array]:
    """Return key values of one run, and sensitivities by channel and parameter (absolute, relative).

    For a record of zeros, the residuals are the negative signals and their Jacobian the negative sensitivities.
    """
    times = RunSettings(output_step).times(trial.duration)
    zeros = recording_of(
        times, {name: (np.zeros(len(times)), unit, "") for name, unit in _WATCHED.items()}
    )
    problem = UpdateProblem(
        [FitTrial(f"speed {trial.speed:g} m/s", rig, trial, zeros)],
        free,
        UpdateSettings(tolerance=1e-6),
    )
    names = [channel.name for channel in problem.trials[0].channels]
    if set(names) != set(_WATCHED):
        raise SimulationError(
            "the rig lacks a signal", where="speed sweep", allowed=", ".join(_WATCHED)
        )
    residuals = problem.residuals(np.zeros(len(free)))
    signal = {
        name: -residuals.vector[block] for name, block in zip(names, residuals.blocks, strict=True)
    }
    slopes = {
        name: -residuals.jacobian[block]
        for name, block in zip(names, residuals.blocks, strict=True)
    }
    table = np.empty((len(CHANNELS), len(free), 2))
    for i, name in enumerate(CHANNELS):
        table[i, :, 0] = np.sqrt(np.mean(slopes[name] ** 2, axis=0))
        table[i, :, 1] = table[i, :, 0] / max(float(np.sqrt(np.mean(signal[name] ** 2))), 1e-300)
    return _numbers(signal, output_step), table


def _numbers(signal: dict[str, Array], output_step: float) -> dict[str, float]:
    aloft = (
        signal["tyre.force"] == 0.0
    )  # exactly, with lift-off; a tyre that can pull only passes through it
    return {
        "peak_body_acceleration": float(np.max(np.abs(signal["sprung.az"]))),
        "peak_wheel_acceleration": float(np.max(np.abs(signal["unsprung.az"]))),
        "peak_body_displacement": float(np.max(np.abs(signal["sprung.z"] - signal["sprung.z"][0]))),
        "lift_off_time": float(np.count_nonzero(aloft)) * output_step,
        "contact_events": float(np.count_nonzero(np.diff(aloft.astype(np.int8)))),
    }


def misfit_against_speed(result: CampaignResult) -> xr.Dataset:
    """Tabulate the residuals of an evaluated campaign against speed and pitch.

    On ``trial`` (number): ``speed`` (m/s), ``pitch`` (m; NaN for a single obstacle), ``use`` ("fit" or "hold-out") and
    ``verdict``; on ``trial`` and ``channel``: ``nrmse_before`` and ``nrmse`` (r.m.s. of measured minus simulated over
    the standard deviation of the measured, 1) and ``iso18571`` (1). Channels that a trial lacks are NaN; trials that
    could not be used, or were not driven over a road, are left out.
    """
    import xarray as xr

    trials = [
        trial
        for trial in result.trials
        if trial.after is not None and trial.entry.speed is not None
    ]
    names = sorted({name for trial in trials if trial.after for name in trial.after.channels})
    tables = {
        key: np.full((len(trials), len(names)), np.nan)
        for key in ("nrmse_before", "nrmse", "iso18571")
    }
    for i, trial in enumerate(trials):
        _enter(tables["nrmse_before"][i], trial.before, names, "nrmse")
        _enter(tables["nrmse"][i], trial.after, names, "nrmse")
        _enter(tables["iso18571"][i], trial.after, names, "iso18571")
    pitch = [np.nan if trial.obstacle_pitch is None else trial.obstacle_pitch for trial in trials]
    return xr.Dataset(
        {
            "speed": (
                "trial",
                np.array([trial.entry.speed for trial in trials], dtype=float),
                {"units": "m/s"},
            ),
            "pitch": ("trial", np.array(pitch, dtype=float), {"units": "m"}),
            "use": ("trial", [trial.entry.use for trial in trials]),
            "verdict": ("trial", [trial.after.verdict if trial.after else "" for trial in trials]),
            **{key: (("trial", "channel"), table, {"units": "1"}) for key, table in tables.items()},
        },
        coords={"trial": [trial.entry.number for trial in trials], "channel": names},
    )


def _enter(
    row: Array, comparison: TrialComparison | None, names: Sequence[str], number: str
) -> None:
    for name, channel in (comparison.channels if comparison is not None else {}).items():
        row[names.index(name)] = getattr(channel, number)
