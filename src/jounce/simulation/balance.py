"""Static equilibrium of a rig with an external element: rig and element must agree on the force."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from jounce.control.controller import Regulator
from jounce.core.errors import SimulationError
from jounce.core.types import Array
from jounce.simulation.compiled import Compiled
from jounce.simulation.statics import Equilibrium, find_equilibrium

_ITERATIONS = 30  # maximum of Newton steps
_HALVINGS = 6  # maximum halvings of a step that leads to commands without equilibrium
_BALANCED, _LEAST = (
    1e-9,
    1e-6,
)  # share of the element's force, and N: rounding of a balance of forces


def balanced_commands(
    regulator: Regulator,
    compiled: Compiled,
    p: Array,
    still: Array,
    columns: NDArray[np.int64],
    where: str,
) -> tuple[Array, Equilibrium]:
    """Find commands (N) at which the rig is at rest and the element returns the same commands, by Newton's method.

    The ``regulator`` returns commands and their slopes for measurements; the rig returns its equilibrium under
    commands, which are the inputs ``columns`` of ``still``. ``where`` is the element's file.
    """
    rows = np.array(
        [compiled.output_names.index(name) for name in regulator.channels], dtype=np.int64
    )
    still, commands = still.copy(), np.zeros(len(columns))
    rest = find_equilibrium(compiled, p, still)
    if regulator.from_rest:
        _check_change(_commands_at_start(regulator, np.zeros(len(rows))), where)
        return commands, rest
    first_gap = np.zeros(0)
    for _ in range(_ITERATIONS):
        outputs = compiled.evaluate("output", rest.x, still, p, rest.modes)
        gap = _commands_at_start(regulator, outputs[rows]) - commands
        first_gap = first_gap if len(first_gap) else gap
        if not np.isfinite(gap).all():
            break
        if np.abs(gap).max() <= _LEAST + _BALANCED * np.abs(outputs[rows]).max():
            return commands, rest
        slopes = regulator.answer(outputs[rows])
        if slopes is None:
            break
        improved = _newton_step(
            compiled, p, still, columns, rest, rows, slopes[1][: len(commands)], gap
        )
        if improved is None:
            break
        commands, rest = improved
        still[columns] = commands
    gaps = ", ".join(f"{force:+.4g} N" for force in first_gap)
    raise SimulationError(
        "no static equilibrium was found with the force of the FMU",
        where=where,
        found=f"{gaps} off the force that holds the rig at rest",
        allowed="a force that rises to the load of the rig within its travel",
        hint=(
            "Check signs (compression positive), units and preload; with from_rest = true the rig's "
            "own force holds the equilibrium, and the FMU supplies the change."
        ),
    )


def _commands_at_start(regulator: Regulator, measured: Array) -> Array:
    """Return the commands at the first instant of a run."""
    regulator.start()
    return np.array(regulator([*measured.tolist(), 0.0]))


def _newton_step(
    compiled: Compiled,
    p: Array,
    still: Array,
    columns: NDArray[np.int64],
    rest: Equilibrium,
    rows: NDArray[np.int64],
    slopes: Array,
    gap: Array,
) -> tuple[Array, Equilibrium] | None:
    """Return commands after a Newton step and their equilibrium; None if no equilibrium exists along the step."""
    where = (rest.x, still, p, rest.modes)
    along = compiled.slopes("u", *where)
    pushed = np.zeros((len(rest.balance), len(columns)))
    pushed[: len(rest.rows)] = along["rate"][np.ix_(rest.rows, columns)]
    shift = rest.moved @ np.linalg.lstsq(rest.balance, -pushed, rcond=None)[0]
    measured_slopes = (
        compiled.slopes("x", *where)["output"][rows] @ shift
        + along["output"][np.ix_(rows, columns)]
    )
    try:
        step = np.linalg.solve(np.eye(len(columns)) - slopes @ measured_slopes, gap)
    except np.linalg.LinAlgError:
        return None
    for _ in range(_HALVINGS):
        inputs = still.copy()
        inputs[columns] += step
        try:
            return inputs[columns], find_equilibrium(
                compiled, p, inputs, rest.x[: compiled.facts.counts[0]]
            )
        except SimulationError:
            step = 0.5 * step
    return None


def _check_change(change: Array, where: str) -> None:
    if np.abs(change).max() > _LEAST:
        raise SimulationError(
            "a force that changes from rest (from_rest) is not zero there",
            where=where,
            found=", ".join(f"{force:.6g} N" for force in change),
            allowed="0 N while the inputs do not change",
        )
