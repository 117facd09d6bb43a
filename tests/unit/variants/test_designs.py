"""Designs of experiments: what values the variants get."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.stats import qmc

from jounce.core.errors import DescriptionError
from jounce.core.units import Unit
from jounce.variants.designs import grid, latin_hypercube, monte_carlo, morris, saltelli, sobol

NUMBERS = {"mass": (16.0, "kg"), "rate": (22730.0, "N/m"), "height": (-0.2, "m")}


def values(design):
    return design.values(NUMBERS.__getitem__)


def test_a_grid_has_every_combination_the_last_number_changing_fastest():
    found = values(grid({"mass": ["14 kg", 18.0], "rate": ["20 N/mm", "25 N/mm", "30 N/mm"]}))
    assert found["mass"].tolist() == [14.0, 14.0, 14.0, 18.0, 18.0, 18.0]
    assert found["rate"] == pytest.approx([20e3, 25e3, 30e3] * 2)


def whole(spread, count=240):
    return latin_hypercube({"mass": spread}, count, seed=1).values(
        NUMBERS.__getitem__, lambda path: path == "mass"
    )


@pytest.mark.parametrize("spread", [[1, 4], {"low": 1.0, "high": 4.0}, [0.2, 4.9]])
def test_whole_numbers_are_drawn_whole_and_their_ends_as_often_as_the_others(spread):
    drawn, times = np.unique(whole(spread)["mass"], return_counts=True)
    assert drawn.tolist() == [1.0, 2.0, 3.0, 4.0]
    assert times.tolist() == [60, 60, 60, 60]


def test_whole_numbers_of_a_distribution_are_rounded_and_keep_its_mean():
    drawn = whole({"mean": 10.0, "sd": 3.0})["mass"]
    assert np.array_equal(drawn, np.rint(drawn))
    assert drawn.mean() == pytest.approx(10.0, abs=0.1)
    assert drawn.std() == pytest.approx(
        np.hypot(3.0, 12.0**-0.5), rel=0.03
    )  # and the rounding's own


def test_a_range_without_a_whole_number_is_refused():
    with pytest.raises(DescriptionError, match="the range contains no integer"):
        whole([1.2, 1.8])


@pytest.mark.parametrize("make", [sobol, latin_hypercube, monte_carlo])
def test_spreads_have_their_ends_and_moments(make):
    spreads = {
        "mass": "20 %",
        "rate": {"mean": "20 N/mm", "sd": "5 %"},
        "height": {"low": "-0.3 m", "mode": "-0.1 m", "high": "0.3 m"},
    }
    found = values(make(spreads, 4096, seed=7))
    assert 12.8 <= found["mass"].min() < 12.83
    assert 19.17 < found["mass"].max() <= 19.2
    # Standard errors of 4 096 random points, three of them; the other designs are far closer.
    assert found["rate"].mean() == pytest.approx(20e3, abs=3 * 1000 / 64)
    assert found["rate"].std() == pytest.approx(1000.0, rel=0.04)
    triangle = (-0.3 - 0.1 + 0.3) / 3.0
    assert found["height"].mean() == pytest.approx(triangle, abs=3 * 0.125 / 64)
    assert found["height"].var() == pytest.approx(
        (0.09 + 0.01 + 0.09 - (0.03 - 0.09 - 0.03)) / 18.0, rel=0.05
    )


@pytest.mark.parametrize("count", [1, 2, 7, 8, 1000, 1024, 1025, 5000])
@pytest.mark.parametrize(("numbers", "seed"), [(1, 0), (2, 3), (12, 2**70)])
@pytest.mark.filterwarnings("ignore:The balance properties:UserWarning")
def test_points_of_a_sobol_sequence_are_those_of_scipy_to_the_last_bit(numbers, seed, count):
    spreads = {str(i): [0.0, 1.0] for i in range(numbers)}
    found = sobol(spreads, count, seed=seed).values(lambda _: (0.5, "1"))
    points = qmc.Sobol(numbers, seed=seed).random(count)
    assert np.array_equal(np.column_stack([*found.values()]), np.clip(points, 1e-12, 1.0 - 1e-12))


def test_points_of_a_sobol_sequence_lie_evenly():
    """In 64 points every one of 8 x 8 cells of two numbers has one: the sequence's defining property."""
    found = values(sobol({"mass": [0.0, 8.0], "rate": [0.0, 8.0]}, 64, seed=3))
    cells = {(int(a), int(b)) for a, b in zip(found["mass"], found["rate"], strict=True)}
    assert len(cells) == 64


def test_a_latin_hypercube_takes_every_part_once():
    found = values(latin_hypercube({"mass": [0.0, 50.0]}, 50, seed=1))
    assert sorted(found["mass"].astype(int)) == list(range(50))


@pytest.mark.parametrize("make", [sobol, latin_hypercube, monte_carlo])
def test_the_same_seed_gives_the_same_points(make):
    first, again, other = (
        values(make({"mass": "10 %"}, 8, seed=seed))["mass"] for seed in (4, 4, 5)
    )
    assert first.tolist() == again.tolist() != other.tolist()


def test_shares_of_a_negative_number_keep_the_order_of_the_ends():
    found = values(monte_carlo({"height": "±50 %"}, 1000))["height"]
    assert -0.3 <= found.min() < found.max() <= -0.1


@pytest.mark.parametrize(
    ("spread", "said"),
    [
        ("20", "20 %"),
        ("-5 %", "20 %"),
        ([1.0], "a lower and a higher value"),
        (["18 kg", "14 kg"], "a lower and a higher value"),
        (["14 m", "18 m"], "kg"),
        ("±2 mm", "kg"),
        ("±-2 kg", "±2 kg"),
        ([1.0, float("inf")], "finite"),
        ({"mean": 16.0}, "invalid distribution"),
        ({"mean": 16.0, "sd": 0.0}, "above 0"),
        ({"sd": "-5 %"}, "20 %"),
        ({"low": 14.0, "mode": 20.0, "high": 18.0}, "the mode is outside"),
        (16.0, "no distribution is given"),
    ],
)
def test_what_is_no_spread_is_refused(spread, said):
    with pytest.raises(DescriptionError, match="mass") as caught:
        values(sobol({"mass": spread}, 8))
    assert said in str(caught.value)


def test_a_reach_in_the_number_s_unit_goes_to_either_side_of_it_even_of_zero():
    found = sobol({"offset": "±5 mm"}, 256, seed=1).values(lambda _: (0.0, "m"))["offset"]
    assert (found.min(), found.max()) == pytest.approx((-5e-3, 5e-3), abs=1e-4)
    assert abs(found.mean()) < 1e-4


def test_a_share_of_zero_would_vary_nothing():
    with pytest.raises(DescriptionError, match="a relative spread around zero has no width"):
        sobol({"preload": "20 %"}, 8).values(lambda _: (0.0, "N"))


@pytest.mark.parametrize("count", [0, -1, 2.5, True, 10**9])
def test_a_number_of_variants_that_makes_no_sense_is_refused(count):
    with pytest.raises(DescriptionError, match="count"):
        sobol({"mass": "10 %"}, count)


@pytest.mark.parametrize("given", [{}, None, {"mass": "14 kg"}, {"mass": []}])
def test_a_grid_of_nothing_is_refused(given):
    with pytest.raises(DescriptionError):
        grid(given)


@pytest.mark.parametrize("seed", [-1, 1.5, "a"])
def test_a_seed_is_a_whole_number(seed):
    with pytest.raises(DescriptionError, match="seed"):
        sobol({"mass": "10 %"}, 8, seed=seed)


POSITIVE = Unit("kg", above=0.0, at_most=50.0)


@pytest.mark.parametrize(
    ("spread", "ends"),
    [
        (["-1 kg", "2 kg"], "from -1 to 2 kg"),
        (["-2 kg", "0 kg"], "from -2 to 0 kg"),
        (["40 kg", "60 kg"], "from 40 to 60 kg"),
        ("150 %", "from -8 to 40 kg"),
        ({"low": "-1 kg", "mode": "1 kg", "high": "2 kg"}, "from -1 to 2 kg"),
    ],
)
@pytest.mark.parametrize("make", [sobol, latin_hypercube, monte_carlo, morris, saltelli])
def test_a_range_beyond_what_is_allowed_is_refused_before_anything_runs(make, spread, ends):
    with pytest.raises(DescriptionError, match="mass: the spread exceeds") as caught:
        make({"rate": "10 %", "mass": spread}, 8).refuse_outside(
            NUMBERS.__getitem__, lambda path: POSITIVE if path == "mass" else Unit("N/m", above=0.0)
        )
    assert ends in str(caught.value)
    assert "allowed: above 0, at most 50 kg" in str(caught.value)


@pytest.mark.parametrize("spread", [["0 kg", "50 kg"], "100 %", {"mean": "1 kg", "sd": "2 kg"}])
def test_a_range_up_to_its_limits_and_a_normal_distribution_are_drawn(spread):
    sobol({"mass": spread}, 8).refuse_outside(NUMBERS.__getitem__, lambda _: POSITIVE)
    grid({"mass": [-1.0, 2.0]}).refuse_outside(NUMBERS.__getitem__, lambda _: POSITIVE)
