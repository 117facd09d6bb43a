"""Pictures of many runs show the numbers that they are given."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.plots import parallel_coordinates, scatter_matrix, tornado, variant_bands


def runs(design=None, **more):
    """A metric in m that is 0.003 a - 0.001 b; b lies between 2 and 4 kg."""
    made = design or jn.sobol({"a": [0.0, 1.0], "b": ["2 kg", "4 kg"]}, 64, seed=1)
    columns = made.values(lambda path: (1.0, "kg" if path == "b" else "1"))
    where = {
        path: ("variant", one, {"units": "kg" if path == "b" else "1"})
        for path, one in columns.items()
    }
    y = 0.003 * columns["a"] - 0.001 * columns["b"]
    reason = np.full(len(y), "", dtype=object)
    if more.get("lost"):
        y, reason = y.copy(), reason.copy()
        y[5], reason[5] = np.nan, "no"
    data = {"max x.z": ("variant", y, {"units": "m"}), "reason": ("variant", reason)}
    return xr.Dataset(data, {"variant": np.arange(len(y)), **where}, {"design": made.kind})


def test_a_tornado_s_bars_go_from_the_mean_to_the_means_at_the_ends():
    many = runs()
    left, right = tornado(many).axes
    assert left.get_title("left") == "max x.z"
    assert [text.get_text() for text in left.get_yticklabels()] == [
        "a",
        "b",
    ]  # what matters most above
    found = jn.sensitivity_indices(many).sel(metric="max x.z")
    mean = 1e3 * float(many["max x.z"].mean())  # in mm
    wanted = [*(1e3 * found["at_low"].values), *(1e3 * found["at_high"].values)]
    assert np.abs([bar.get_width() for bar in left.patches]) == pytest.approx(
        np.abs(np.array(wanted) - mean)
    )
    assert left.get_xlabel().endswith("[mm]")
    assert right.get_title("left") == "Regression"


@pytest.mark.parametrize(("numbers", "rows"), [(2, 5), (15, 3)])
def test_a_tornado_has_as_many_metrics_as_bars_fit(numbers, rows):
    idle = {f"idle {i}": [0.0, 1.0] for i in range(numbers - 2)}
    many = runs(jn.sobol({"a": [0.0, 1.0], "b": ["2 kg", "4 kg"], **idle}, 64))
    many = many.assign({f"max x{i}.z": many["max x.z"] for i in range(4)})
    assert len(tornado(many).axes) == 2 * rows
    assert len(tornado(many, ["max x.z"]).axes) == 2


def test_a_tornado_of_trajectories_shows_half_of_their_effects():
    left, _ = tornado(runs(jn.morris({"a": [0.0, 1.0], "b": [2.0, 4.0]}, 12))).axes
    assert [bar.get_width() for bar in left.patches] == pytest.approx(
        [-1.5, 1.0, 1.5, -1.0]
    )  # mm: 3 over a, -2 over b


def test_a_scatter_has_a_dot_a_variant_that_ran_and_means_of_what_is_alike():
    figure = scatter_matrix(runs(jn.grid({"a": [0.0, 1.0], "b": ["2 kg", "3 kg", "4 kg"]})))
    over_a, over_b = figure.axes
    assert len(over_a.collections[0].get_offsets()) == 6
    assert over_a.lines[0].get_xydata() == pytest.approx(np.array([[0.0, -3.0], [1.0, 0.0]]))
    assert over_b.lines[0].get_xydata()[:, 1] == pytest.approx([-0.5, -1.5, -2.5])
    assert over_b.get_xlabel() == "b [kg]"


def test_pictures_of_many_numbers_keep_those_that_matter():
    many = runs(
        jn.sobol(
            {**{f"idle {i}": [0.0, 1.0] for i in range(8)}, "a": [0.0, 1.0], "b": ["2 kg", "4 kg"]},
            64,
        )
    )
    shown = [axes.get_xlabel().split(" [")[0] for axes in scatter_matrix(many).axes]
    assert len(shown) == 7
    assert shown[-2:] == ["a", "b"]


def test_lines_of_parallel_coordinates_are_the_variants_that_ran():
    axes = parallel_coordinates(runs(lost=True)).axes[0]
    lines = next(one for one in axes.collections if hasattr(one, "get_segments")).get_segments()
    assert len(lines) == 63
    assert {len(line) for line in lines} == {3}
    assert np.min([line[:, 1] for line in lines]) >= 0.0
    assert np.max([line[:, 1] for line in lines]) <= 1.0
    written = [text.get_text() for text in axes.texts]
    assert len(written) == 6  # both ends of three axes


def test_bands_hold_the_shares_they_say():
    values = np.arange(101.0)[:, None] * np.array([0.0, 1e-3])
    many = xr.Dataset(
        {
            "x.z": (("variant", "time"), values, {"units": "m"}),
            "reason": ("variant", np.full(101, "", dtype=object)),
        },
        {"variant": np.arange(101), "time": [0.0, 1.0]},
    )
    assert jn.bands(many, "x.z").values == pytest.approx(
        np.array([[0.0, 0.005], [0.0, 0.05], [0.0, 0.095]])
    )
    axes = variant_bands(many).axes[0]
    assert axes.lines[0].get_ydata() == pytest.approx([0.0, 50.0])
    assert axes.collections[0].get_paths()[0].get_extents().y1 == pytest.approx(95.0)
    assert jn.plots.figure_of(many).axes[0].get_ylabel() == axes.get_ylabel()
    for wrong in ([], [-1.0], [101.0]):
        with pytest.raises(DescriptionError, match="invalid percentiles"):
            jn.bands(many, "x.z", wrong)
    with pytest.raises(DescriptionError, match=r"unknown channel over time 'y\.z'"):
        jn.bands(many, "y.z")


def test_what_cannot_be_drawn_is_said():
    with pytest.raises(DescriptionError, match="no time-dependent channel was stored"):
        variant_bands(runs())
    with pytest.raises(DescriptionError, match="no parameter varies"):
        scatter_matrix(runs().isel(variant=[0]))
    assert jn.plots.figure_of(runs()).axes[0].get_title("left") == "max x.z"


def test_upright_axes_are_drawn_as_their_ends_are_written():
    """A difference that nobody can read is no line across the picture, and rounding is nothing."""
    from jounce.plots.parallel import between_ends

    shares, ends = between_ends(np.array([2.0, 4.0, 3.0]))
    assert (shares.tolist(), ends) == ([0.0, 1.0, 0.5], ("2.000", "4.000"))
    shares, ends = between_ends(np.array([-15.0, -15.0 + 1e-6]))
    assert (shares.tolist(), ends) == ([0.5, 0.5], ("−15.00", "−15.00"))
    assert between_ends(np.array([5.6e-6, 2.957]))[1] == ("0", "2.957")
