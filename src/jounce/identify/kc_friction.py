"""What dry friction adds to the curves of K&C tests: simulated, beside the smooth model whose numbers are fitted."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from jounce.core.errors import JounceError
from jounce.core.types import Array
from jounce.kc.laboratory import Handwheel, Held, Laboratory, axle_of
from jounce.kc.loops import Lines, lines_of, noise_of
from jounce.kc.quantities import is_of_element, quantities
from jounce.kc.tests import TESTS
from jounce.parts import Corner, DependentAxle, Rig

if TYPE_CHECKING:
    import xarray as xr

_SAMPLES = 80  # of a measured loop that is simulated
_CLOSED = 0.05  # of the input's range: ends of a sweep that are closer make it a loop
_TRIED = 10.0  # N: friction of the strut whose loop is compared with the measured one
_CLEAR = 6.0  # standard deviations of the noise from which a loop is open


class FrictionCurve(NamedTuple):
    """A fitted curve: test, quantity, inputs of its nodes, whether its loop is open, and the measured sweep (SI)."""

    test: str
    quantity: str
    inputs: Array
    is_open: bool
    sweep: Array


class FrictionEffects:
    """Simulates the tests with and without friction, as they were measured."""

    def __init__(
        self, rig: Corner | DependentAxle, smooth: Corner | DependentAxle, travel: float
    ) -> None:
        self.rig, self.smooth, self.travel = rig, smooth, travel
        self._weights: dict[tuple[bytes, bytes], tuple[Array, ...]] = {}
        self.openings: list[float] = []

    def of(
        self,
        changes: Mapping[str, float],
        curves: Sequence[FrictionCurve],
        held: Held,
        handwheel: Handwheel,
    ) -> list[Array]:
        """Return for each curve what friction adds at its nodes, at changed numbers; zero where it cannot be told.

        ``openings`` are then those of the simulated loops, root mean squares.
        """
        pair = [self._laboratory(rig, changes) for rig in (self.rig, self.smooth)]
        runs: dict[str, list[dict[str, Array]] | None] = {}
        effects, self.openings = [], []
        for curve in curves:
            loop = sampled(curve.sweep)
            if curve.test not in runs:
                of_elements = any(map(is_of_element, (c.quantity for c in curves)))
                runs[curve.test] = None if loop is None else [
                    _values(laboratory, curve.test, loop, held, handwheel, elements=of_elements)
                    for laboratory in pair
                ]  # fmt: skip
            run = runs[curve.test]
            if run is None or loop is None:
                effects.append(np.zeros(len(curve.inputs)))
                self.openings.append(0.0)
                continue
            lines = [self._lines(loop, values[curve.quantity], curve.inputs) for values in run]
            rubbed = lines[0].elastic if curve.is_open else lines[0].mean
            effects.append(_filled(curve.inputs, rubbed - lines[1].mean))
            self.openings.append(float(np.sqrt(mean_square_opening(lines[0]))))
        return effects

    def _lines(self, loop: Array, values: Array, inputs: Array) -> Lines:
        """Return the lines of a loop, as `lines_of`: for loops without gaps a product with its branches' weights."""
        if not np.isfinite(values).all():
            return lines_of(loop, values, inputs)
        key = loop.tobytes(), inputs.tobytes()
        if key not in self._weights:
            each = [lines_of(loop, unit, inputs) for unit in np.eye(loop.size)]
            self._weights[key] = tuple(
                np.stack([getattr(lines, branch) for lines in each], axis=1)
                for branch in ("up", "down")
            )
        up, down = self._weights[key]
        return Lines(inputs, up @ values, down @ values)

    def _laboratory(self, rig: Corner | DependentAxle, changes: Mapping[str, float]) -> Laboratory:
        return Laboratory(
            axle_of(rig.with_changes(dict(changes)) if changes else rig, None), self.travel
        )


def mean_square_opening(lines: Lines) -> float:
    """Return the mean square of the distance of both branches; 0 where there are no two."""
    gap = lines.up - lines.down
    gap = gap[np.isfinite(gap)]
    return float(np.mean(gap**2)) if gap.size else 0.0


def _filled(inputs: Array, effect: Array) -> Array:
    """Continue an effect to nodes at which a branch is missing; zero without any."""
    known = np.isfinite(effect)
    if not known.any():
        return np.zeros(len(inputs))
    return np.asarray(np.interp(inputs, inputs[known], effect[known]))


def sampled(sweep: Array) -> Array | None:
    """Return some samples of a measured loop, with its ends; None if the sweep is no loop.

    >>> sampled(np.array([0.0, 1.0, 2.0])) is None, sampled(np.array([0.0, 1.0, 0.0, -1.0, 0.0])).tolist()
    (True, [0.0, 1.0, 0.0, -1.0, 0.0])
    """
    reach = float(np.ptp(sweep))
    if abs(float(sweep[-1] - sweep[0])) > _CLOSED * reach:
        return None
    places = np.linspace(0, sweep.size - 1, min(sweep.size, _SAMPLES + 1)).round().astype(int)
    places = np.unique([*places, int(np.argmin(sweep)), int(np.argmax(sweep))])
    return np.asarray(sweep[places], dtype=float)


def _values(
    laboratory: Laboratory,
    test: str,
    inputs: Array,
    held: Held,
    handwheel: Handwheel,
    *,
    elements: bool,
) -> dict[str, Array]:
    kind = TESTS[test]
    poses, _ = laboratory.run(kind, inputs, held, handwheel, kind.trail)
    every = quantities(poses, elements=elements)
    return {name: variable.values for name, variable in every.items()}


def strut_friction(rig: Rig, tests: Mapping[str, xr.Dataset], travel: float) -> float:
    """Return the dry friction of the strut, N, that opens the loop of wheel loads in bounce as measured; else 0."""
    data, strut = tests.get("bounce"), getattr(rig, "strut", None)
    if data is None or strut is None or getattr(strut, "friction", None) is not None:
        return 0.0
    loop = sampled(np.asarray(data["input"].values, dtype=float))
    names = [f"{side}.vertical_force" for side in ("left", "right")]
    names = [name for name in names if name in data]
    if loop is None or not names:
        return 0.0
    try:
        rubbed = rig.with_changes({"strut.friction": {"force": _TRIED}})
        laboratory = Laboratory(axle_of(rubbed, None), travel)
        run = _values(laboratory, "bounce", loop, "load", "locked", elements=False)
    except JounceError:
        return 0.0
    sweep, forces = np.asarray(data["input"].values, dtype=float), []
    inner = np.linspace(0.3 * float(sweep.min()), 0.3 * float(sweep.max()), 11)
    for name in names:
        values = np.asarray(data[name].values, dtype=float)
        measured, tried = (
            float(np.nanmedian(lines.up - lines.down))
            for lines in (lines_of(sweep, values, inner), lines_of(loop, run[name], inner))
        )
        if tried > 0.0 and measured > _CLEAR * noise_of(values) / np.sqrt(inner.size):
            forces.append(_TRIED * measured / tried)
    return float(np.mean(forces)) if forces else 0.0
