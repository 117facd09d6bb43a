from __future__ import annotations

import numpy as np
import pytest

from jounce.identify.warping import warping_path


def plain_path(x: np.ndarray, y: np.ndarray, radius: int) -> list[tuple[int, int]]:
    """Dynamic programming on the whole table, as in textbooks."""
    n = x.size
    cost = np.full((n + 1, n + 1), np.inf)
    cost[0, 0] = 0.0
    for i in range(n):
        for j in range(max(0, i - radius), min(n, i + radius + 1)):
            cost[i + 1, j + 1] = (x[i] - y[j]) ** 2 + min(cost[i, j + 1], cost[i + 1, j], cost[i, j])
    i = j = n
    path = [(i - 1, j - 1)]
    while (i, j) != (1, 1):
        step = int(np.argmin([cost[i - 1, j], cost[i, j - 1], cost[i - 1, j - 1]]))
        i, j = i - (step != 1), j - (step != 0)
        path.append((i - 1, j - 1))
    return path[::-1]


@pytest.mark.parametrize("n", [1, 2, 3, 4, 5, 8, 13, 64, 127, 128, 129, 130, 300])
@pytest.mark.parametrize("share", [0.0, 0.02, 0.1, 0.5, 1.0])
def test_path_is_that_of_the_whole_table(n: int, share: float) -> None:
    rng = np.random.default_rng(n)
    radius = round(share * n)
    for x, y in (rng.standard_normal((2, n)).cumsum(axis=1), rng.integers(0, 3, (2, n)).astype(float)):  # with ties
        i, j = warping_path(x, y, radius)
        assert list(zip(i.tolist(), j.tolist(), strict=True)) == plain_path(x, y, radius)


def test_band_of_zero_width_is_the_diagonal() -> None:
    i, j = warping_path(np.arange(1000.0), np.zeros(1000), 0)
    np.testing.assert_array_equal(i, np.arange(1000))
    np.testing.assert_array_equal(j, np.arange(1000))


def test_long_path_stays_in_its_band_and_moves_by_single_steps() -> None:
    time = np.arange(5000) * 1e-3
    i, j = warping_path(np.sin(9.0 * time), np.sin(9.0 * time - 0.9), 90)
    assert np.abs(i - j).max() == 90
    assert {tuple(step) for step in np.stack((np.diff(i), np.diff(j)), axis=1).tolist()} <= {(0, 1), (1, 0), (1, 1)}


@pytest.mark.parametrize(("x", "y"), [(np.zeros(3), np.zeros(4)), (np.zeros(0), np.zeros(0)), (np.zeros((2, 2)),) * 2])
def test_shapes_must_fit(x: np.ndarray, y: np.ndarray) -> None:
    with pytest.raises(ValueError, match="same length"):
        warping_path(x, y, 2)
