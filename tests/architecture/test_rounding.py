"""What plays another library's rounding: it moves numbers a little, and breaks nothing that every library keeps."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import rounding
from rounded import is_rounded

TESTS = Path(__file__).parents[1]


@pytest.mark.parametrize("seed", range(5))
def test_numbers_move_by_a_few_units_in_the_last_place(seed: int) -> None:
    numbers = np.random.default_rng(1).normal(size=(40, 30))[::2, ::3].T
    moved = rounding.moved(numbers, seed)
    units = (moved - numbers) / np.spacing(np.abs(numbers))
    assert set(np.abs(units).ravel()) == {0.0, 1.0, 2.0, 3.0}
    assert np.array_equal(moved, rounding.moved(numbers.copy(), seed))
    assert not np.array_equal(moved, rounding.moved(numbers, seed + 1))


def test_what_every_library_keeps_is_kept() -> None:
    values = np.array([0.0, -0.0, np.inf, np.nan])
    assert np.array_equal(rounding.moved(values, 1), values, equal_nan=True)
    symmetric = np.add.outer(np.arange(9.0), np.arange(9.0)) * 0.1
    assert np.array_equal(rounding.moved(symmetric, 1), rounding.moved(symmetric, 1).T)
    pair = np.array([0.3 + 0.7j, 0.3 - 0.7j])
    assert rounding.moved(pair, 1)[0] == rounding.moved(pair, 1)[1].conjugate()
    eigen = rounding.noisy(np.linalg.eigh, 1)(np.eye(2) + 0.3)
    assert type(eigen) is type(np.linalg.eigh(np.eye(2)))
    x, _, rank, _ = rounding.noisy(np.linalg.lstsq, 1)(np.eye(3), np.arange(3.0))
    assert (x.shape, rank) == ((3,), 3)


def test_optimisers_see_moved_functions_and_constraints() -> None:
    seen = []

    def optimiser(function, start, constraints, method):
        seen.extend([function(start), constraints[0]["fun"](start), constraints[0]["type"], method])

    limits = ({"type": "ineq", "fun": lambda x: x / 3.0},)
    rounding._handed_on(optimiser, 2)(lambda x: (x, [x]), 0.1, constraints=limits, method="SLSQP")
    assert seen[0] == (rounding.moved(0.1, 2), [rounding.moved(0.1, 2)])
    assert seen[1:] == [rounding.moved(0.1 / 3.0, 2), "ineq", "SLSQP"]


def test_files_that_hang_on_rounding_are_found() -> None:
    assert is_rounded(TESTS / "golden" / "test_kept_files.py")
    assert is_rounded(TESTS / "unit" / "control" / "test_numbers_of_laws.py")  # names an optimiser
    assert is_rounded(TESTS / "physics" / "test_anti_effects.py")  # calls what solves equations
    assert not is_rounded(TESTS / "physics" / "test_anti_effects.py", itself=True)
    assert not is_rounded(TESTS / "unit" / "core" / "test_columns.py")
