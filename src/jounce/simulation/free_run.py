"""Simulate a mechanism of one's own: from given coordinates and speeds, with prescribed motions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.errors import AssemblyError, SimulationError, unknown
from jounce.core.findings import Finding
from jounce.core.segments import Segments
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.kernel.explicit import Control, Problem
from jounce.kernel.tracks import flatten
from jounce.mechanics import Mechanism, Model, assemble, constant
from jounce.mechanics.assembly import Assembly
from jounce.mechanics.mass import check_inertia
from jounce.mechanics.mechanism import BALANCE
from jounce.recordings.schema import recording
from jounce.simulation.compiled import Compiled, compile_model
from jounce.simulation.prepare import IMPLICIT_SHARE, STEP_SHARE, Prepared, longest_step_of, room
from jounce.simulation.result import samples_reached
from jounce.simulation.settings import MAX_STEPS, Method, RunSettings
from jounce.simulation.singular_configurations import run_through
from jounce.simulation.statics import find_equilibrium

if TYPE_CHECKING:
    import xarray as xr

_SMALLEST = 1e-3  # m, rad, m/s or rad/s: motions below that need not be resolved relative to themselves
_LONGEST = 1.2  # radians of the fastest motion at the start in one step
_SHARE = 0.02  # of the duration, the longest step
_DECAYING = 0.9  # share of its decay in how fast a motion is, above which it is no oscillation
_STIFF, _LONG_RUN = 20.0, 1e4  # decay over oscillation, and decays in a run, beyond which the implicit method pays
_MASSLESS = 1e-12  # mass that a motion moves, relative to that of the coordinates by themselves
_MOVING = 1e-3  # share of a coordinate in a motion that is worth naming


def simulate_mechanism(  # noqa: PLR0913 - all but two are settings with a default
    mechanism: Mechanism,
    duration: float | str,
    *,
    start: Mapping[str, float | str] | None = None,
    motions: Mapping[str, Segments] | None = None,
    values: Mapping[str, float | str] | None = None,
    output_step: float = 1e-3,
    tolerance: float = 1e-6,
    method: Method = "auto",
    redundant: str = "refuse",
    at_rest: bool = False,
    check: bool = True,
) -> xr.Dataset:
    """Simulate a mechanism from given coordinates and speeds.

    Parameters
    ----------
    mechanism : Mechanism
        Bodies, joints, loops, forces and outputs.
    duration : float or str
        s, or text with a unit.
    start : mapping, optional
        Coordinates (m, rad) and speeds (m/s, rad/s) by name, or text with a unit; others start in the design pose, at
        rest. Where loops leave no such pose or speeds, the nearest ones are taken, those given moving least.
    motions : mapping, optional
        Track to its motion, see :func:`jounce.mechanics.harmonic` and its neighbours.
    values : mapping, optional
        Parameter path to another value (SI, or text with a unit) than it was built with; nothing is compiled anew.
    output_step : float
        Distance of the output samples, s.
    tolerance : float
        Relative error of coordinates and speeds.
    method : {"auto", "explicit", "implicit"}
        How to integrate, see :func:`jounce.simulate`; by itself the implicit method where something decays at the start
        far faster than anything oscillates, and after an explicit run that used up its steps.
    redundant : {"refuse", "remove"}
        What to do about loop equations that repeat each other.
    at_rest : bool
        Start in a static equilibrium near the start, with the tracks held.
    check : bool
        Raise when the run does not reach its end.

    Returns
    -------
    xarray.Dataset
        The outputs on ``time`` (s), SI. ``attrs["findings"]`` says what assembly moved, and where a singular
        configuration was passed only with other steps.

    Raises
    ------
    AssemblyError
        When the loops cannot be closed or repeat each other, or a motion of the joints moves no mass.
    SimulationError
        For unknown names, where no equilibrium is found, or, with ``check``, when the run does not reach its end.

    Examples
    --------
    >>> import jounce as jn
    >>> pendulum = jn.mechanics.Mechanism()
    >>> bob = pendulum.body("bob", mass=1.0, centre_of_mass=(1.0, 0.0, 0.0))
    >>> _ = pendulum.revolute("pivot", pendulum.ground, bob, at=(0.0, 0.0, 0.0), axis=(0.0, 1.0, 0.0))
    >>> pendulum.watch_body(bob)
    >>> run = jn.simulate_mechanism(pendulum, "1 s", start={"pivot.angle": 0.0})
    >>> bool(run["bob.z"].min() < -0.99)   # it swings through its lowest point
    True
    """
    seconds = to_si(duration, "s", where="duration")
    if not seconds > 0.0:
        raise SimulationError("not a duration", where="duration", found=f"{seconds:g} s", allowed="above 0 s")
    times = RunSettings(output_step, tolerance, method).times(seconds)
    if redundant not in ("refuse", "remove"):
        raise unknown(redundant, ("refuse", "remove"), what="choice", where="redundant")
    every, given = _values(mechanism, values or {}), _motions(mechanism, motions or {})
    inputs = {name: float(track.evaluate(np.zeros(1))[0][0]) for name, track in given.items()}
    model = mechanism.model(redundant, start, values=every, inputs=inputs)
    p, tracks = np.array([every[name] for name in model.parameters]), [given[name] for name in model.tracks]
    u = _inputs(model.facts.track_order, tracks)
    pose = assemble(model, p, u, start, redundant="refuse" if redundant == "refuse" else "keep")
    _check_masses(mechanism, model, pose.x, u, p)
    compiled = compile_model(model)
    first = find_equilibrium(compiled, p, u, pose.x[: len(model.coordinates)]).x if at_rest else pose.x

    def begin(x: Array, after: Array, error: float) -> Prepared:
        u = _inputs(model.facts.track_order, tracks, float(after[0]))
        return _prepare(compiled, p, tracks, x, u, after, error, method)

    crossings: tuple[float, ...] = ()
    if model.constraints:
        solution, crossings = run_through(begin, first, times, tolerance, tracks)
    else:
        solution = begin(first, times, tolerance).run()
    reach = samples_reached(solution, compiled.facts, check=check)
    channels = {
        output.name: (solution.outputs[i, :reach], output.unit, output.long_name)
        for i, output in enumerate(compiled.facts.outputs)
        if output.name != BALANCE or "energy.kinetic" in compiled.output_names
    }
    run = recording(solution.time[:reach], channels)
    run.attrs["status"] = solution.status.name.lower()
    run.attrs["method"], run.attrs["steps"], run.attrs["events"] = solution.method, solution.steps, solution.events
    run.attrs["findings"] = _findings(pose, crossings)
    return run


def _values(mechanism: Mechanism, values: Mapping[str, float | str]) -> dict[str, float]:
    """Every parameter by path, those given in place of those it was built with."""
    for name in values:
        if name not in mechanism.parameters:
            raise unknown(name, mechanism.parameters, what="parameter", where="values")
    units = mechanism.units
    given = {name: to_si(value, units.get(name, "1"), where=f"values: {name}") for name, value in values.items()}
    every = mechanism.values | given
    lacking = [name for name in mechanism.parameters if name not in every]
    if lacking:
        raise SimulationError("parameters without a value", where=", ".join(lacking), hint="Give them in values.")
    for name, body in mechanism.mass_values(every).items():
        check_inertia(name, *body)
    return every


def _motions(mechanism: Mechanism, motions: Mapping[str, Segments]) -> dict[str, Segments]:
    for name, motion in motions.items():
        if name not in mechanism.tracks:
            raise unknown(name, mechanism.tracks, what="track", where="motions")
        if not isinstance(motion, Segments):
            hint = "Take constant(), constant_rate(), harmonic(), step() or interpolated() of jounce.mechanics."
            raise SimulationError("not a motion", where=f"motions: {name}", found=str(motion), hint=hint)
        if not (np.all(np.isfinite(motion.coefficients)) and np.all(np.isfinite(motion.edges))):
            raise SimulationError("not a motion", where=f"motions: {name}", found="not a finite number")
    lacking = [name for name in mechanism.tracks if name not in motions]
    if lacking:
        raise SimulationError("tracks without a motion", where=", ".join(lacking), hint="Give them in motions.")
    return {name: motion.with_finite_slopes() for name, motion in motions.items()}


def _inputs(order: int, tracks: list[Segments], time: float = 0.0) -> Array:
    """Inputs at a time (s); accelerations are not needed for a start."""
    u = np.zeros(order * len(tracks))
    for i, track in enumerate(tracks):
        value, rate = track.evaluate(np.array([time]))
        u[i * order : i * order + 2] = value[0], rate[0]
    return u


def _check_masses(mechanism: Mechanism, model: Model, x: Array, u: Array, p: Array) -> None:
    """Refuse a mechanism in which some motion of the joints moves no mass."""
    matrix = mechanism.mass_matrix(model)(x, u, p).full()
    if not np.all(np.isfinite(matrix)):
        raise SimulationError(
            "the mechanism cannot be computed: its mass matrix is not finite",
            hint="Check the axes of the joints, and what `values` made of them.",
        )
    size = np.sqrt(np.diag(matrix))
    scale = np.where(size > 0.0, size, 1.0)
    values, ways = np.linalg.eigh(matrix / np.outer(scale, scale))
    empty = [ways[:, i] for i in np.flatnonzero(values < _MASSLESS)]
    if empty:
        names = [name for way in empty for name, share in zip(model.speeds, way, strict=True) if abs(share) > _MOVING]
        raise AssemblyError(
            "nothing with mass or inertia moves when these coordinates change together",
            where=", ".join(dict.fromkeys(name.removesuffix(" rate") for name in names)),
            hint="Give the bodies there mass and inertia (a point mass has no inertia of its own), or fewer joints: "
            "a massless link is a rod().",
        )


def _prepare(
    compiled: Compiled,
    p: Array,
    tracks: list[Segments],
    x: Array,
    u: Array,
    times: Array,
    tolerance: float,
    method: Method,
) -> Prepared:
    facts = compiled.facts
    modes = (compiled.evaluate("switch", x, u, p, np.ones(len(facts.switches))) > 0.0).astype(float)
    rate = compiled.evaluate("rate", x, u, p, modes)
    if not np.all(np.isfinite(rate)):
        names = [name for name, value in zip(facts.states, rate, strict=True) if not np.isfinite(value)]
        hint = "Check the forces and the start."
        raise SimulationError("the start has no finite rates", where=", ".join(names), found="not a number", hint=hint)
    pace, duration = np.linalg.eigvals(compiled.evaluate("rate_x", x, u, p, modes)), float(times[-1] - times[0])
    fastest = float(np.max(np.abs(pace), initial=1e-3))
    moving = float(np.max(np.abs(pace[-pace.real < _DECAYING * np.abs(pace)]), initial=1e-3))
    longest = min(_LONGEST / fastest, _SHARE * duration)
    scale = np.full(len(x), _SMALLEST)
    control = Control(STEP_SHARE * tolerance, scale, np.full(len(modes), 1e-13), MAX_STEPS, longest)
    flat = flatten(tracks or [constant(0.0)])
    first = flat.first[: len(tracks)].copy()
    problem = Problem(compiled.engine, flat, first, compiled.extended(p), modes.copy(), x, len(u))
    prepared = Prepared(compiled, problem, control, room(compiled, times), None, modes, None, u)
    if method == "explicit":
        return prepared
    coarse = min(longest_step_of(moving, tolerance), _SHARE * duration)
    stiff = control._replace(tolerance=IMPLICIT_SHARE * tolerance, longest=coarse)
    implicitly = method == "implicit" or (fastest > _STIFF * moving and fastest * duration > _LONG_RUN)
    return replace(prepared, stiff=lambda: stiff, method="implicit" if implicitly else "explicit")


def _findings(pose: Assembly, crossings: tuple[float, ...]) -> list[str]:
    moved = [
        Finding(move.coordinate, "note", f"assembly moved it from {move.before:.6g} to {move.after:.6g}")
        for move in pose.displacements
    ]
    passed = [
        Finding(f"{time:.6g} s", "note", "a singular configuration, passed with other steps") for time in crossings
    ]
    return [str(finding) for finding in (*moved, *passed)]
