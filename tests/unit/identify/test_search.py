"""Searches from several starts: where they begin, when they end, and which place they take for the best."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from jounce.core.errors import SimulationError
from jounce.identify import search
from jounce.identify.search import search_from_starts


class _Wells:
    """A function of one scaled unknown with two wells, as a problem of least squares: the deeper one is at +0.6."""

    size = 1

    def __init__(self, shallow: float = 0.2, lost: float = 2.0) -> None:
        self.shallow, self.lost, self.evaluations, self.begun = shallow, lost, 0, list[float]()

    def coarser(self, _: float) -> Any:
        return _Wells(self.shallow, self.lost)

    @property
    def data_energy(self) -> float:
        return 1.0

    def residuals(self, x: np.ndarray) -> Any:
        self.evaluations += 1
        if x[0] > self.lost:
            raise SimulationError("diverged")
        left, right = 3.0 * (x[0] + 0.6), 3.0 * (x[0] - 0.6)
        # the lesser of two parabolas, the left one not going down to zero
        is_left = left**2 + self.shallow < right**2
        vector = np.array([left, np.sqrt(self.shallow)]) if is_left else np.array([right, 0.0])
        return SimpleNamespace(vector=vector, jacobian=np.array([[3.0], [0.0]]))

    def objective(self, x: np.ndarray) -> tuple[float, np.ndarray]:
        found = self.residuals(x)
        return float(found.vector @ found.vector), 2.0 * found.jacobian.T @ found.vector


def wells(**options: float) -> Any:
    """A problem with two wells; checkers of types need not know how little of one it is."""
    return _Wells(**options)


@pytest.mark.parametrize("method", ["least-squares", "bfgs"])
def test_a_start_in_the_wrong_well_is_found_out(method: str) -> None:
    alone = search_from_starts(wells(), np.array([-0.5]), method, 1, starts=1)
    assert alone.best.scaled[0] == pytest.approx(-0.6, abs=1e-3)
    found = search_from_starts(wells(), np.array([-0.5]), method, 1, starts=None)
    assert found.best.scaled[0] == pytest.approx(0.6, abs=1e-3)
    assert [one.scaled[0] for one in found.others] == [pytest.approx(-0.6, abs=1e-2)]
    assert found.is_confirmed
    assert found.starts >= 4


def test_a_start_in_the_right_well_is_confirmed_and_the_other_one_told() -> None:
    found = search_from_starts(wells(), np.array([0.5]), "least-squares", 1, starts=None)
    assert (found.starts, found.is_confirmed) == (4, True)
    assert [one.scaled[0] for one in found.others] == [pytest.approx(-0.6, abs=1e-2)]
    assert found.others[0].objective == pytest.approx(0.2, rel=1e-2)


def test_a_best_place_that_nothing_confirms_is_no_certainty(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def ends(problem: Any, points: list[np.ndarray]) -> Any:
        return (
            (problem, search.Optimum(0.9 * point, 5.0, 1, 1, converged=True)) for point in points
        )

    monkeypatch.setattr(search, "_rough_ends", ends)
    found = search_from_starts(wells(), np.array([0.5]), "least-squares", 1, starts=None)
    assert (found.starts, found.is_confirmed) == (8, False)


def test_starts_lie_within_the_bounds_and_the_best_end_leads(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    begun: list[np.ndarray] = []

    def minimise(_: object, point: np.ndarray, __: str) -> search.Optimum:
        begun.append(point)
        return search.Optimum(point, float(point[0]), 1, 1, converged=True)

    monkeypatch.setattr(search, "minimise", minimise)
    problem: Any = SimpleNamespace(size=2)
    found = search_from_starts(problem, np.array([0.3, 0.3]), "bfgs", 5, starts=9)
    places = np.array(begun)
    assert places.shape == (9, 2)
    assert begun[0].tolist() == [0.3, 0.3]
    for column in places[1:].T:  # one in each eighth of the range
        assert sorted(np.floor(4.0 * (column + 1.0)).astype(int)) == list(range(8))
    assert found.best.objective == min(places[:, 0])
    assert [one.objective for one in found.others] == sorted(one.objective for one in found.others)
