"""Poles of closed loops: whether a linear law holds the car it is put around, before any run."""

from __future__ import annotations

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from jounce.control.actuators import ActiveActuator
from jounce.control.controller import CallbackController
from jounce.control.program import Program, program, values
from jounce.core.errors import SimulationError
from jounce.core.types import Array
from jounce.parts import Rig
from jounce.simulation.compiled import Compiled, compile_rig
from jounce.simulation.controlled import AnyControl, Loop, close_loop, command_names
from jounce.simulation.statics import Rest, find_rest

_GROWING = 1e-3  # 1/s below which a pole counts as rounding


def closed_loop_poles(rig: Rig, control: AnyControl) -> NDArray[np.complex128]:
    """Poles of a rig with a linear law, at the control instants, about static equilibrium.

    Limits of the actuator are left out. What the law samples and holds is in them exactly.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle.
    control : Controller, str or Path
        A law with an active actuator that is a formula.

    Returns
    -------
    ndarray of complex
        1/s, by falling real part; a positive one grows. A pole beyond half the control rate is shown within it.

    Raises
    ------
    SimulationError
        For a law with a damper (it can only take energy) or one that is no formula.

    Examples
    --------
    >>> from jounce.parts import load
    >>> bool(closed_loop_poles(load("audi-a6-quarter-car"), "active-skyhook")[0].real < 0.0)
    True
    """
    loop = close_loop(rig, control)
    if loop is None or not is_linear(loop):
        raise SimulationError(
            "no linear law with an active actuator",
            where="control",
            found="none" if loop is None else f"{loop.first.name}, {loop.actuator.kind}",
            allowed="active-skyhook, pid, lqr, lqg, h-infinity with an active actuator",
        )
    compiled = compile_rig(rig, actuator=loop.actuator)
    p = compiled.parameter_values({**rig.parameters(), **loop.parameters(compiled)})
    still = compiled.inputs(0.0)
    return poles(loop, compiled, p, find_rest(compiled, p, still), still)


def is_linear(loop: Loop) -> bool:
    """Tell whether the law is a formula with a force actuator: apart from its limits such a loop is linear."""
    return isinstance(loop.actuator, ActiveActuator) and not isinstance(loop.first, CallbackController)


def poles(loop: Loop, compiled: Compiled, p: Array, rest: Rest, still: Array) -> NDArray[np.complex128]:
    """Poles (1/s) of a loop around a model at rest, by falling real part.

    Parameters
    ----------
    loop : Loop
        The controller.
    compiled : Compiled
        The model with actuators.
    p, still : ndarray
        Parameters and inputs, SI.
    rest : Rest
        Equilibrium.
    """
    from scipy.linalg import expm

    made, period = program(loop.first, loop.corners), 1.0 / loop.first.rate
    facts, names = compiled.facts, compiled.output_names
    columns = [facts.tracks.index(name) * facts.track_order for name in command_names(loop.corners)]
    rows = [names.index(name) for name in made.channels]
    where = (rest.x, still, p, rest.modes)
    along = compiled.slopes("u", *where)
    B, D = (rest.pick @ along["rate"])[:, columns], along["output"][np.ix_(rows, columns)]
    C = compiled.slopes("x", *where)["output"][rows] @ rest.lift
    n, m = B.shape
    held = np.zeros((n + m, n + m))
    held[:n, :n], held[:n, n:] = rest.reduced, B
    F, H = np.split(expm(held * period)[:n], [n], axis=1)
    kept, seen = _slopes(made, values(loop.controllers, loop.models, made.numbers))
    u_x, u_kept, u_u = seen[:m] @ C, kept[:m], seen[:m] @ D
    next_x, next_kept, next_u = seen[m:] @ C, kept[m:], seen[m:] @ D
    whole = np.block([[F + H @ u_x, H @ u_kept, H @ u_u], [next_x, next_kept, next_u], [u_x, u_kept, u_u]])
    found = np.log(np.linalg.eigvals(whole).astype(complex) + 1e-300) / period
    return np.asarray(found[np.argsort(-found.real)])


def _slopes(made: Program, p: Array) -> tuple[Array, Array]:
    """Slopes of (commands, next memory) along memory and measurements, at rest."""
    function = made.function
    memory, measured, numbers, nothing = (ca.SX.sym(f"i{i}", function.size1_in(i)) for i in range(function.n_in()))
    result = function(memory, measured, numbers, nothing)
    slopes = [ca.jacobian(result, memory), ca.jacobian(result, measured)]
    evaluate = ca.Function("slopes", [memory, measured, numbers], [ca.densify(part) for part in slopes])
    kept, seen = evaluate(np.zeros(function.size1_in(0)), np.zeros(function.size1_in(1)), p)
    return np.asarray(kept), np.asarray(seen)[:, :-1]  # the last one is the time


def check_stable(loop: Loop, compiled: Compiled, p: Array, rest: Rest, still: Array) -> None:
    """Refuse a linear loop with a growing pole; arguments as for :func:`poles`."""
    if not is_linear(loop):
        return
    worst = poles(loop, compiled, p, rest, still)[0]
    if worst.real > _GROWING:
        raise SimulationError(
            "the closed loop is unstable: small motions grow",
            where=f"control: {loop.first.name}",
            found=f"a pole at {worst.real:.3g} 1/s, {abs(worst.imag) / (2.0 * np.pi):.3g} Hz",
            hint="Take smaller gains, a faster actuator or a higher control rate (check=False runs it all the same).",
        )
