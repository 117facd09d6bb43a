from __future__ import annotations

import numpy as np
import pytest

from jounce.identify import warping
from jounce.identify.warping import _pays, warping_path


def plain_path(x: np.ndarray, y: np.ndarray, radius: int) -> list[tuple[int, int]]:
    """Dynamic programming on the whole table, as in textbooks."""
    n = x.size
    cost = np.full((n + 1, n + 1), np.inf)
    cost[0, 0] = 0.0
    for i in range(n):
        for j in range(max(0, i - radius), min(n, i + radius + 1)):
            cost[i + 1, j + 1] = (x[i] - y[j]) ** 2 + min(
                cost[i, j + 1], cost[i + 1, j], cost[i, j]
            )
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
    for x, y in (
        rng.standard_normal((2, n)).cumsum(axis=1),
        rng.integers(0, 3, (2, n)).astype(float),
    ):  # with ties
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
    assert {tuple(step) for step in np.stack((np.diff(i), np.diff(j)), axis=1).tolist()} <= {
        (0, 1),
        (1, 0),
        (1, 1),
    }


@pytest.mark.parametrize(
    ("x", "y"), [(np.zeros(3), np.zeros(4)), (np.zeros(0), np.zeros(0)), (np.zeros((2, 2)),) * 2]
)
def test_shapes_must_fit(x: np.ndarray, y: np.ndarray) -> None:
    with pytest.raises(ValueError, match="same length"):
        warping_path(x, y, 2)


@pytest.mark.parametrize(
    ("nrmse", "kind", "pays"),
    [(0.05, "body", True), (0.3, "wheel", True), (1.0, "wheel", False), (3.0, "body", False)],
)
def test_a_narrower_band_is_tried_where_it_saves_time(nrmse: float, kind: str, pays: bool) -> None:
    """Measured at 6 s: 0.3 to 0.75 of the time up to NRMSE 0.3, 1.05 to 1.2 from 1 on."""
    rng, n = np.random.default_rng(1), 20_008
    spectrum = np.fft.rfft(rng.standard_normal((2, n)))
    low, high = {"body": (0.5, 3.0), "wheel": (5.0, 30.0)}[kind]
    frequency = np.fft.rfftfreq(n, 1e-4)
    one, other = np.fft.irfft(np.where((frequency < low) | (frequency > high), 0.0, spectrum), n)
    assert _pays(one + nrmse * other, np.ascontiguousarray(one[::-1]), 2000) is pays


@pytest.mark.parametrize("nrmse", [0.01, 0.3, 1.5])
@pytest.mark.parametrize(
    ("n", "share"), [(1500, 0.1), (4001, 0.1), (9000, 0.1), (3000, 0.6), (2000, 1.0)]
)
def test_leaving_out_what_costs_too_much_changes_nothing(
    n: int, share: float, nrmse: float
) -> None:
    """Exact pruning: the path is that of the whole band, also with ties, late signals and steps."""
    rng = np.random.default_rng(n)
    rough = np.convolve(rng.standard_normal(n + 40), np.hanning(41), mode="valid")
    other = np.convolve(rng.standard_normal(n + 40), np.hanning(41), mode="valid")
    radius = round(share * n)
    noisy = rough + nrmse * other
    for x, y in (
        (rough, noisy),
        (np.roll(rough, n // 25), noisy),
        (np.round(rough), np.round(noisy)),
    ):
        whole = warping_path(x, y, radius, narrow=-1)
        for narrow in (0, radius // 50, radius // 8, None):
            np.testing.assert_array_equal(warping_path(x, y, radius, narrow=narrow), whole)


def least_cost(x: np.ndarray, y: np.ndarray, radius: int) -> float:
    """Cost of the cheapest path, anti-diagonal by anti-diagonal, k = i - j from -radius to radius."""
    n = x.size
    k = np.arange(-radius, radius + 1)
    before = behind = np.full(k.size + 2, np.inf)
    for s in range(2 * n - 1):
        i, j = (s + k) // 2, (s - k) // 2
        inside = ((s + k) % 2 == 0) & (i >= 0) & (j >= 0) & (i < n) & (j < n)
        cost = np.where(inside, (x[np.clip(i, 0, n - 1)] - y[np.clip(j, 0, n - 1)]) ** 2, np.inf)
        least = np.minimum(np.minimum(before[:-2], before[2:]), behind[1:-1]) if s else 0.0
        now = np.full(k.size + 2, np.inf)
        now[1:-1] = np.where(inside, least + cost, np.inf)
        behind, before = before, now
    return float(before[radius + 1])


@pytest.mark.parametrize("radius", [700, 2100, 4999])
def test_strips_wider_than_one_give_the_least_cost(radius: int) -> None:
    rng = np.random.default_rng(radius)
    x, y = rng.standard_normal((2, 5000)).cumsum(axis=1)
    least = least_cost(x, y, radius)
    for narrow in (-1, None):
        i, j = warping_path(x, y, radius, narrow=narrow)
        assert float(np.sum((x[i] - y[j]) ** 2)) == pytest.approx(least, rel=1e-12)


def test_what_is_done_otherwise_for_long_signals_changes_nothing(monkeypatch) -> None:
    """Machine code for this very processor, fewer stores, and ordinary memory where no other is to be had."""
    x, y = np.random.default_rng(3).standard_normal((2, 1700)).cumsum(axis=1)
    expected = warping_path(x, y, 600)
    monkeypatch.setattr(warping, "_SHORT", 100)
    np.testing.assert_array_equal(warping_path(x, y, 600), expected)
    monkeypatch.delattr(warping.mmap, "MAP_PRIVATE")
    np.testing.assert_array_equal(warping_path(x, y, 600), expected)
