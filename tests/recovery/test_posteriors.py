"""Posteriors of virtual benches: as many intervals hold the truth as they say, with and without errors of the model."""

import os

import coverage_counts
import numpy as np
import pytest
import wrong_models

import jounce as jn

BENCHES = int(os.environ.get("JOUNCE_BENCHES", "0"))
"""How many benches are counted with a posterior each, 20 at least; 0 for as many as there is time for, 200 for all."""


def gaussian(one):
    """Which intervals hold of the Gaussian approximation, which is the posterior within some per cent."""
    settings = {"weights": "normalised", "align": "lag", "doubt": jn.Doubt()}
    told = jn.update_model(one.trials, wrong_models.FREE, **settings).discrepancy.parameters
    return [
        counted(path, law.interval, law.value, one) for path, law in told.items() if law.identified
    ]


def counted(path, interval, value, one):
    """Whether an interval holds both readings of the truth, and its half-width over its value."""
    held = all(interval[0] <= true[path] <= interval[1] for true in (one.component, one.effective))
    return held, 0.5 * (interval[1] - interval[0]) / value


@pytest.mark.slow
def test_benches_without_model_error():
    rows = [coverage_counts.without_error(seed) for seed in range(max(BENCHES or 200, 20))]
    share = sum(row.hold for row in rows) / sum(row.intervals for row in rows)
    room = 0.025 * np.sqrt(200.0 / len(rows))  # three standard errors of correlated threes
    assert 0.95 - room <= share <= 0.95 + room


@pytest.mark.slow
def test_benches_that_are_off_by_what_is_doubted():
    """Where errors are drawn from their priors 95 % have to be covered, neither fewer nor more: nothing else is wrong.

    This is what says that intervals are no wider than what is stated; a bench of other errors cannot.
    """
    rows = [
        row for seed in range(100) for row in gaussian(wrong_models.doubted_bench(seed, trials=3))
    ]
    covered, _ = np.array(rows).T
    assert (
        0.92 <= np.mean(covered) <= 0.98
    )  # of some 510, correlated in sixes: three standard errors


@pytest.mark.slow
def test_two_hundred_benches_with_model_error():
    """Seeds from 400 on are others than those the intervals were developed on; the counts are in the documentation.

    No upper end of what is covered: masses are doubted by more than these benches are off by, and a rest that three
    trials tell of has wide tails. Both are stated and not estimated, so more than 95 % are covered, and an end that is
    nearly one could not fail. That intervals are not simply wide is asked of those that are off by what is doubted,
    above, and that they are of use of their widths.
    """
    rows = [row for seed in range(400, 600) for row in gaussian(wrong_models.bench(seed, trials=3))]
    covered, widths = np.array(rows).T
    assert np.mean(covered) >= 0.92
    assert np.median(widths) < 0.1


@pytest.mark.slow
def test_posteriors_with_model_error():
    """Seven seconds each; JOUNCE_BENCHES=200 counts all that the documentation tells of."""
    rows = [
        coverage_counts.with_error(coverage_counts.FIRST + i) for i in range(max(BENCHES or 40, 20))
    ]
    assert sum(row.hold for row in rows) >= 0.92 * sum(row.intervals for row in rows)
    assert np.median([row.widths for row in rows]) < 0.1
    errors = np.array([row.error for row in rows])
    assert np.mean(errors < 0.5) > 0.9
    assert all(row.told == (row.error > 0.5) for row in rows)
    ratios = [row.ratio for row in rows]
    assert (
        0.9 < np.nanmedian(ratios) < 1.1
    )  # so that what is counted of the approximation counts for the posterior
