"""Free vibrations about equilibrium, such as the decaying motion of a rig disturbed before a record begins."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from jounce.core.types import Array
from jounce.simulation.compiled import Compiled
from jounce.simulation.statics import find_equilibrium

_SMALL = 1e-6  # m: size of output changes in finite differences; small enough to be linear
_SWINGS = (
    1e-6  # imaginary part over magnitude of a pole; smaller ratios are rounding of a real pole
)


@dataclass(frozen=True)
class FreeVibration:
    """One natural vibration about equilibrium, with an amplitude of 1 m.

    Attributes
    ----------
    frequency : float
        Damped natural frequency, Hz.
    decay : float
        Rate of decay, 1/s.
    displaced, moving : dict
        State to its distance from equilibrium (SI) at maximum displacement, and a quarter of a period later.
    """

    frequency: float
    decay: float
    displaced: Mapping[str, float]
    moving: Mapping[str, float]


def free_motions(compiled: Compiled, p: Array, still: Array) -> list[FreeVibration]:
    """Return the free vibrations of a model about rest under the inputs ``still``, the slowest first.

    ``p`` are all parameter values (SI). The amplitude refers to the height, travel or deflection output with the
    largest motion. Overdamped motions are omitted.
    """
    rest = find_equilibrium(compiled, p, still)
    poles, shapes = np.linalg.eig(rest.reduced)
    lengths = [i for i, output in enumerate(compiled.facts.outputs) if output.unit == "m"]
    motions = []
    for pole, shape in sorted(
        zip(poles, (rest.lift @ shapes).T, strict=True), key=lambda pair: pair[0].imag
    ):
        if pole.imag <= _SWINGS * abs(pole):
            continue

        def motion_of(part: Array) -> Array:
            step = _SMALL / float(np.max(np.abs(part), initial=1e-300))
            above, below = (
                compiled.evaluate("output", rest.x + sign * step * part, still, p, rest.modes)
                for sign in (1.0, -1.0)
            )
            return np.asarray((above - below)[lengths] / (2.0 * step))

        seen = motion_of(shape.real) + 1j * motion_of(shape.imag)
        largest = seen[np.argmax(np.abs(seen))]
        swing = shape / largest
        motions.append(
            FreeVibration(
                float(pole.imag) / (2.0 * np.pi),
                -float(pole.real),
                dict(zip(compiled.facts.states, swing.real.tolist(), strict=True)),
                dict(zip(compiled.facts.states, (1j * swing).real.tolist(), strict=True)),
            )
        )
    return motions
