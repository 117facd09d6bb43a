"""Runs with the implicit method: slopes of the rates as native code, how such a run is steered, when it pays."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np

from jounce.core.errors import SimulationError
from jounce.core.types import Array
from jounce.kernel.implicit import Slopes
from jounce.kernel.native import Native, Source, compile_functions, kept_code
from jounce.kernel.rosenbrock_steps import RosenbrockStep
from jounce.mechanics import Model
from jounce.simulation.compiled import Compiled
from jounce.simulation.newton_matrix import linear_functions
from jounce.simulation.statics import Rest

Method = Literal["auto", "explicit", "implicit"]
METHODS: tuple[str, ...] = get_args(Method)
STEP_SHARE = 0.12  # of the tolerance for one step of the implicit method
_CARRIED = 1e-2  # share of the quasi-static motion at which a mode must be seen in the samples
_FELT = 300.0  # tolerances: share at which a mode must be followed through its oscillations
_PAYS = 4.0  # steps of the explicit method for one of the implicit method, above which the latter is faster
_OVERSAMPLED = 1.2  # radians in one step, at a tolerance of 1e-5


@dataclass(frozen=True)
class Pace:
    """Undamped natural frequencies at rest (rad/s) and what share of the quasi-static motion over the road each has."""

    frequency: Array
    share: Array

    def fastest(self, share: float) -> float:
        """Highest frequency (rad/s) among the modes with at least a share."""
        return float(np.max(self.frequency[self.share >= share], initial=0.0))


def pace_of(compiled: Compiled, p: Array, rest: Rest, u: Array) -> Pace:
    """Find out which modes a road can move, without damping, since friction that sticks at rest soon slides.

    Parameters
    ----------
    compiled : Compiled
        The model.
    p : ndarray, shape (n_parameters,)
        Parameter values, SI.
    rest : Rest
        Where.
    u : ndarray, shape (n_inputs,)
        Inputs at rest.
    """
    f, order = len(rest.free), compiled.facts.track_order
    squares, shapes = np.linalg.eig(-rest.reduced[f : 2 * f, :f])
    pulled = rest.pick[f : 2 * f] @ compiled.evaluate("rate_u", rest.x, u, p, rest.modes)[:, ::order]
    firm = np.where(squares == 0.0, np.inf, squares)
    weights = np.linalg.norm(np.linalg.lstsq(shapes, pulled.astype(complex), rcond=None)[0] / firm[:, None], axis=1)
    sizes = weights * np.linalg.norm(rest.lift[: compiled.facts.counts[0], :f] @ shapes, axis=0)
    return Pace(np.sqrt(np.abs(squares)), sizes / max(float(np.max(sizes, initial=0.0)), 1e-300))


def check_method(method: str, compiled: Compiled | None = None) -> None:
    """Refuse a method that does not exist, and the implicit one where sensitivities are wanted."""
    if method not in METHODS:
        raise SimulationError("not a method", where="method", found=method, allowed=", ".join(METHODS))
    if method == "implicit" and compiled is not None and compiled.free:
        raise SimulationError(
            "the implicit method carries no sensitivities",
            where="method",
            found=f"implicit, with {len(compiled.free)} free parameters",
            allowed="auto, explicit",
        )


def pays(pace: Pace, waves: float, explicit: float, tolerance: float) -> bool:
    """Tell whether the implicit method is likely to be faster.

    Parameters
    ----------
    pace : Pace
        Modes at rest.
    waves : float
        Fastest wave of the road, rad/s.
    explicit : float
        What limits the explicit method, rad/s.
    tolerance : float
        Relative error of the displacements.
    """
    return explicit > _PAYS * max(pace.fastest(_FELT * tolerance), waves)


def longest_step(pace: Pace, waves: float, tolerance: float) -> float:
    """Step (s) beyond which samples inside it would be worse than its end, or a contact could be passed over."""
    return longest_step_of(max(pace.fastest(_CARRIED), waves, 1e-3), tolerance)


def longest_step_of(fastest: float, tolerance: float) -> float:
    """Longest step (s) for the fastest motion (rad/s) that samples must show."""
    return float(_OVERSAMPLED * (tolerance / 1e-5) ** 0.2 / fastest)


_FUNCTIONS = ("look", "along_input", "factor", "interpolant")
_made: dict[int, tuple[Compiled, Slopes, Native]] = {}


def slopes_of(compiled: Compiled) -> Slopes:
    """Give the native functions for the linear systems of a model; made once, kept on disk as all native code."""
    plain = compiled.plain
    if id(plain) not in _made:
        if plain.identity:
            native, notes = kept_code(f"implicit {plain.identity}", lambda: _source(plain.model))
        else:
            source = _source(plain.model)
            native, notes = compile_functions(source.functions, source.step), source.notes
        look, along_input, factor, interpolant = (native.address[name] for name in _FUNCTIONS)
        stages = np.array([address for name, address in native.address.items() if name.startswith("stage_")])
        size, room = json.loads(notes)
        _made[id(plain)] = plain, Slopes(look, along_input, factor, stages, interpolant, size, room), native
    return _made[id(plain)][1]


def _source(model: Model) -> Source:
    functions = linear_functions(model)
    step = RosenbrockStep(model.x.shape[0])
    return Source(functions, step, notes=json.dumps([functions[name].size1_out(0) for name in ("look", "factor")]))
