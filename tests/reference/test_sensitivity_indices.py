"""Sobol's indices and Morris' effects against closed forms: the functions of Ishigami and of Sobol."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
import xarray as xr
from scipy import stats

import jounce as jn
from jounce.core.errors import DescriptionError

pytestmark = pytest.mark.source(
    kind="published",
    of="many runs",
    key="ishigami-1990",
    where="closed forms of the indices",
    tolerance="0.01 of 4096 base points",
)


def runs(design, function):
    numbers = design.spreads
    columns = design.values(lambda _: (1.0, "1"))
    x = np.column_stack([columns[path] for path in numbers])
    where = {path: ("variant", columns[path], {"units": "1"}) for path in numbers}
    reason = ("variant", np.full(len(x), "", dtype=object))
    return xr.Dataset(
        {"y": ("variant", function(x), {"units": "N"}), "reason": reason},
        {"variant": np.arange(len(x)), **where},
        {"design": design.kind},
    )


def ishigami(x):
    return np.sin(x[:, 0]) + 7.0 * np.sin(x[:, 1]) ** 2 + 0.1 * x[:, 2] ** 4 * np.sin(x[:, 0])


# Ishigami and Homma (1990), An importance quantification technique in uncertainty analysis for computer models; closed
# forms with a = 7, b = 0.1: V1 = (1 + b pi^4 / 5)^2 / 2, V2 = a^2 / 8, V13 = 8 b^2 pi^8 / 225.
V1, V2 = 0.5 * (1.0 + 0.1 * np.pi**4 / 5.0) ** 2, 49.0 / 8.0
V13 = 8.0 * 0.01 * np.pi**8 / 225.0
V = V1 + V2 + V13
FIRST, TOTAL = np.array([V1, V2, 0.0]) / V, np.array([V1 + V13, V2, V13]) / V
RANGES = {key: [-np.pi, np.pi] for key in "abc"}


def test_the_function_of_ishigami():
    assert pytest.approx([0.3139, 0.4424, 0.0], abs=5e-5) == FIRST
    found = jn.sensitivity_indices(runs(jn.saltelli(RANGES, 4096, seed=1), ishigami))
    assert found["first"].values[0] == pytest.approx(FIRST, abs=0.01)
    assert found["total"].values[0] == pytest.approx(TOTAL, abs=0.01)
    assert found["number"].values.tolist() == ["a", "b", "c"]
    assert found.attrs["left_out"] == 0
    for name, truth in (("first", FIRST), ("total", TOTAL)):
        assert np.all(found[f"{name}_low"].values[0] <= truth)
        assert np.all(found[f"{name}_high"].values[0] >= truth)
        assert np.all(found[f"{name}_high"].values[0] - found[f"{name}_low"].values[0] < 0.1)


@pytest.mark.source(
    kind="published",
    of="many runs",
    key="sobol-1993",
    where="closed forms of the g function",
    tolerance="0.01 of 4096 base points",
)
def test_the_g_function():
    """Sobol (1993): product of (|4 x - 2| + a) / (1 + a), V_i = 1 / (3 (1 + a_i)^2)."""
    a = np.array([0.0, 1.0, 4.5, 9.0])
    alone = 1.0 / (3.0 * (1.0 + a) ** 2)
    variance = np.prod(1.0 + alone) - 1.0
    total = alone * np.array([np.prod(np.delete(1.0 + alone, i)) for i in range(4)]) / variance
    design = jn.saltelli({key: [0.0, 1.0] for key in "abcd"}, 4096, seed=2)
    found = jn.sensitivity_indices(
        runs(design, lambda x: np.prod((np.abs(4.0 * x - 2.0) + a) / (1.0 + a), axis=1))
    )
    assert found["first"].values[0] == pytest.approx(alone / variance, abs=0.01)
    assert found["total"].values[0] == pytest.approx(total, abs=0.01)


@pytest.mark.source(
    kind="program",
    of="many runs",
    key="scipy",
    where="stats.sobol_indices on the same values",
    tolerance="rounding",
)
def test_the_estimators_are_those_of_scipy():
    many = runs(jn.saltelli(RANGES, 256, seed=3), ishigami)
    y = many["y"].values.reshape(-1, 5)
    theirs = stats.sobol_indices(
        func={
            "f_A": y[None, :, 0],
            "f_B": y[None, :, 4],
            "f_AB": y[:, None, 1:4].transpose(2, 1, 0),
        },
        n=256,
    )
    found = jn.sensitivity_indices(many)
    assert found["first"].values[0] == pytest.approx(
        theirs.first_order.ravel(), rel=1e-9, abs=1e-12
    )
    assert found["total"].values[0] == pytest.approx(theirs.total_order.ravel(), rel=1e-9)


@pytest.mark.no_source
def test_intervals_hold_the_truth_about_as_often_as_they_say():
    inside = []
    for seed in range(12):
        pairs = np.random.default_rng(seed).uniform(-np.pi, np.pi, (128, 6))
        first, second = pairs[:, None, :3], pairs[:, None, 3:]
        x = np.concatenate(
            [first, np.where(np.eye(3, dtype=bool), second, first), second], axis=1
        ).reshape(-1, 3)
        many = runs(jn.saltelli(RANGES, 128), ishigami).assign_coords(
            {name: ("variant", x[:, i]) for i, name in enumerate("abc")}
        )
        found = jn.sensitivity_indices(many.assign(y=("variant", ishigami(x), {"units": "N"})))
        for name, truth in (("first", FIRST), ("total", TOTAL)):
            inside += (
                (found[f"{name}_low"].values[0] <= truth)
                & (truth <= found[f"{name}_high"].values[0])
            ).tolist()
    share = np.mean(inside)
    assert share > 0.84  # of 72; the percentile bootstrap is a little short for so few pairs


@pytest.mark.no_source
def test_intervals_of_few_pairs_hold_the_truth_too():
    """Of 8 and 16 pairs fewer than nine in ten were held, where 95 % were said."""
    held = []
    for pairs, seed in itertools.product((8, 16), range(6)):
        found = jn.sensitivity_indices(runs(jn.saltelli(RANGES, pairs, seed=seed), ishigami))
        for name, truth in (("first", FIRST), ("total", TOTAL)):
            held += (
                (found[f"{name}_low"].values[0] <= truth)
                & (truth <= found[f"{name}_high"].values[0])
            ).tolist()
        assert np.all(found["total_low"] >= 0.0)
    assert np.mean(held) > 0.92


@pytest.mark.no_source
def test_morris_of_a_straight_line_with_a_product():
    """Effects of whole ranges: of the line its slopes; of a product of two numbers they differ from place to place."""
    design = jn.morris({key: [0.0, 2.0] for key in "abc"}, 40, seed=1)
    assert design.count == 160
    found = jn.sensitivity_indices(runs(design, lambda x: 3.0 * x[:, 0] - x[:, 1] + 0.0 * x[:, 2]))
    assert found["mean_effect"].values[0] == pytest.approx([6.0, -2.0, 0.0])
    assert found["mean_absolute_effect"].values[0] == pytest.approx([6.0, 2.0, 0.0])
    assert found["effect_spread"].values[0] == pytest.approx([0.0, 0.0, 0.0], abs=1e-12)
    found = jn.sensitivity_indices(runs(design, lambda x: x[:, 0] * x[:, 1] + x[:, 2]))
    # the effect of a is 2 b: b is uniform over its 8 levels, of mean 1 and variance (1 - 1 / 64) / 3
    spread = 2.0 * np.sqrt((1.0 - 1.0 / 64.0) / 3.0)
    assert found["effect_spread"].values[0] == pytest.approx([spread, spread, 0.0], abs=0.25)
    assert found["mean_effect"].values[0][2] == pytest.approx(2.0)


@pytest.mark.no_source
def test_regression_of_a_straight_line():
    found = jn.sensitivity_indices(
        runs(jn.sobol({key: [0.0, 1.0] for key in "ab"}, 256), lambda x: 3 * x[:, 0] - 4 * x[:, 1])
    )
    assert found["regression"].values[0] == pytest.approx([0.6, -0.8], abs=0.02)
    assert found["explained"].values[0] == pytest.approx(1.0)
    assert found["rank_correlation"].values[0] == pytest.approx([0.6, -0.8], abs=0.05)
    assert found["at_high"].values[0] - found["at_low"].values[0] == pytest.approx(
        [2.4, -3.2], abs=0.05
    )
    bent = jn.sensitivity_indices(runs(jn.sobol({"a": [-1.0, 1.0]}, 256), lambda x: x[:, 0] ** 2))
    assert abs(bent["explained"].values[0]) < 0.01


@pytest.mark.no_source
def test_intervals_of_regression_hold_the_truth_about_as_often_as_they_say():
    """Of a line whose scatter grows along one number; the truth is that of very many variants."""
    noise = np.random.default_rng(0)

    def scattered(x):
        return 2.0 * x[:, 0] - x[:, 1] + (0.2 + x[:, 0]) * noise.standard_normal(len(x))

    ranges = {key: [0.0, 1.0] for key in "ab"}
    truth = jn.sensitivity_indices(runs(jn.monte_carlo(ranges, 50_000, seed=99), scattered))
    inside = {"regression": [], "rank_correlation": []}
    for seed in range(100):
        found = jn.sensitivity_indices(runs(jn.monte_carlo(ranges, 60, seed=seed), scattered))
        for name, held in inside.items():
            exact = truth[name].values[0]
            held.extend(
                (found[f"{name}_low"].values[0] <= exact)
                & (exact <= found[f"{name}_high"].values[0])
            )
    for (
        name,
        held,
    ) in inside.items():  # of 200: 0.95 is met within 0.03, and 60 variants are few for the errors
        assert 0.90 < np.mean(held) < 0.98, name


@pytest.mark.no_source
@pytest.mark.parametrize(("make", "size"), [(jn.saltelli, 5), (jn.morris, 4)])
def test_what_did_not_run_takes_what_belongs_to_it_with_it(make, size):
    many = runs(make(RANGES, 64, seed=4), ishigami)
    whole = jn.sensitivity_indices(many.isel(variant=slice(size, None)))
    y = many["y"].values.copy()
    y[2] = np.nan
    found = jn.sensitivity_indices(many.assign(y=("variant", y, {"units": "N"})))
    assert found.attrs["left_out"] == size
    for name in ("first", "total") if make is jn.saltelli else ("mean_effect", "effect_spread"):
        assert found[name].values == pytest.approx(whole[name].values)
    holes = np.delete(
        np.arange(many.sizes["variant"]), [1, -1]
    )  # a sweep that is not finished, and lacks a shard
    cut = jn.sensitivity_indices(many.isel(variant=holes))
    inner = jn.sensitivity_indices(many.isel(variant=slice(size, -size)))
    assert cut.attrs["left_out"] == 2 * (size - 1)
    assert cut[name].values == pytest.approx(inner[name].values)


@pytest.mark.no_source
def test_a_metric_that_does_not_vary_depends_on_nothing():
    for make in (jn.saltelli, jn.morris, jn.sobol):
        found = jn.sensitivity_indices(runs(make(RANGES, 16), lambda x: np.full(len(x), 3.0)))
        assert all(
            np.nanmax(np.abs(found[name].values[0])) == 0.0
            for name in found
            if not name.startswith(("at_", "expl"))
        )


@pytest.mark.no_source
def test_what_cannot_be_told():
    many = runs(jn.sobol(RANGES, 16), ishigami)
    with pytest.raises(DescriptionError, match="unknown metric 'z'"):
        jn.sensitivity_indices(many, "z")
    with pytest.raises(DescriptionError, match="too few variants"):
        jn.sensitivity_indices(many.isel(variant=slice(0, 3)))
    with pytest.raises(DescriptionError, match="no metric of the runs was stored"):
        jn.sensitivity_indices(many.drop_vars("y"))
    with pytest.raises(DescriptionError, match="no parameter varies"):
        jn.sensitivity_indices(many.isel(variant=[0, 0, 0, 0, 0, 0]))
