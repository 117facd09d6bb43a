"""Static equilibrium of a rig with an element of another program: both must agree on its force."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from jounce.control.controller import Regulator
from jounce.core.errors import SimulationError
from jounce.core.types import Array
from jounce.simulation.compiled import Compiled
from jounce.simulation.statics import Equilibrium, find_equilibrium

_ITERATIONS = 30
_HALVINGS = 6  # of a step behind which the rig has no rest
_BALANCED, _LEAST = 1e-9, 1e-6  # of the element's force, and N: as well as forces are balanced
_CHANGE = 1e-3  # of its own load: what a force that changes from rest may be there


def balanced_commands(
    regulator: Regulator, compiled: Compiled, p: Array, still: Array, columns: NDArray[np.int64], where: str
) -> tuple[Array, Equilibrium]:
    """Commands (N) under which the rig rests where the element then gives just these; Newton's method.

    The ``regulator`` gives commands and their slopes for measurements, the rig its rest under commands; these are the
    inputs ``columns`` of ``still``. ``where`` is the element's file.
    """
    rows = np.array([compiled.output_names.index(name) for name in regulator.channels], dtype=np.int64)
    still, commands = still.copy(), np.zeros(len(columns))
    rest = find_equilibrium(compiled, p, still)
    if regulator.from_rest:
        _check_change(_asked(regulator, np.zeros(len(rows))), where)
        return commands, rest
    first = np.zeros(0)
    for _ in range(_ITERATIONS):
        outputs = compiled.evaluate("output", rest.x, still, p, rest.modes)
        beyond = _asked(regulator, outputs[rows]) - commands
        first = first if len(first) else beyond
        if not np.isfinite(beyond).all():
            break
        if np.abs(beyond).max() <= _LEAST + _BALANCED * np.abs(outputs[rows]).max():
            return commands, rest
        slopes = regulator.answer(outputs[rows])
        if slopes is None:
            break
        found = _moved(compiled, p, still, columns, rest, rows, slopes[1][: len(commands)], beyond)
        if found is None:
            break
        commands, rest = found
        still[columns] = commands
    raise SimulationError(
        "no static equilibrium was found with the force of the FMU",
        where=where,
        found=f"{', '.join(f'{one:+.4g} N' for one in first)} beside the force that holds the rig at rest with its own",
        allowed="a force that rises to the load of the rig within its travel",
        hint="Check signs (compression positive), units and preload; with from_rest = true the rig's own force holds "
        "at rest, and the FMU gives what changes.",
    )


def _asked(regulator: Regulator, measured: Array) -> Array:
    """Commands at the first instant of a run."""
    regulator.start()
    return np.array(regulator([*measured.tolist(), 0.0]))


def _moved(
    compiled: Compiled,
    p: Array,
    still: Array,
    columns: NDArray[np.int64],
    rest: Equilibrium,
    rows: NDArray[np.int64],
    slopes: Array,
    beyond: Array,
) -> tuple[Array, Equilibrium] | None:
    """Commands after a step of Newton's method, and the rest there; None where there is none on the way."""
    where = (rest.x, still, p, rest.modes)
    along = compiled.slopes("u", *where)
    pushed = np.zeros((len(rest.balance), len(columns)))
    pushed[: len(rest.rows)] = along["rate"][np.ix_(rest.rows, columns)]
    shift = rest.moved @ np.linalg.lstsq(rest.balance, -pushed, rcond=None)[0]
    seen = compiled.slopes("x", *where)["output"][rows] @ shift + along["output"][np.ix_(rows, columns)]
    try:
        step = np.linalg.solve(np.eye(len(columns)) - slopes @ seen, beyond)
    except np.linalg.LinAlgError:
        return None
    for _ in range(_HALVINGS):
        inputs = still.copy()
        inputs[columns] += step
        try:
            return inputs[columns], find_equilibrium(compiled, p, inputs, rest.x[: compiled.facts.counts[0]])
        except SimulationError:
            step = 0.5 * step
    return None


def _check_change(change: Array, where: str) -> None:
    if np.abs(change).max() > _LEAST:
        raise SimulationError(
            "a force that changes from rest (from_rest) is not zero there",
            where=where,
            found=", ".join(f"{force:.6g} N" for force in change),
            allowed="0 N without any change of its inputs",
        )
