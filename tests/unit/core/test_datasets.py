"""Datasets put together directly are those of the public constructor; where they would not be, that one makes them."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

from jounce.core import datasets
from jounce.core.datasets import dataset


@pytest.fixture
def axes():
    time = xr.Variable("time", np.array([0.0, 1.0, 2.5]), {"units": "s"})
    return xr.Dataset(
        coords={
            "time": time,
            "place": xr.Variable((), 3.0, {"units": "m"}),
            "side": ("side", ["l", "r"]),
        }
    )


def variables():
    z = xr.Variable(("time",), np.array([1.0, np.nan, 3.0]), {"units": "m"})
    return {"z": z, "force": xr.Variable(("time", "side"), np.arange(6.0).reshape(3, 2))}


def beside():
    return {"speed": xr.Variable(("time",), np.array([1.0, 2.0, 3.0]), {"units": "m/s"})}


def known(monkeypatch, answer: bool) -> None:
    monkeypatch.setattr(datasets, "_inside_is_known", lambda: answer)


@pytest.mark.parametrize("attributes", [None, {}, {"status": "completed", "steps": 3}])
def test_both_ways_make_the_same(axes, attributes, monkeypatch):
    datasets._inside_is_known.cache_clear()
    assert datasets._inside_is_known()  # of the xarray that is installed
    made = dataset(variables(), axes, attributes, beside())
    known(monkeypatch, False)
    right = dataset(variables(), axes, attributes, beside())
    assert made.identical(right)
    assert list(made.variables) == list(right.variables)
    assert repr(made) == repr(right)
    for use in (
        lambda data: data.sel(time=1.0, method="nearest"),
        lambda data: data.isel(time=slice(1, None), side=0),
        lambda data: data.copy(deep=True),
        lambda data: xr.concat([data, data], dim="run"),
        lambda data: data.interp(time=[0.5]),
        lambda data: data + 1.0,
        lambda data: data.drop_vars("z"),
        lambda data: data.to_dataframe().to_xarray(),
    ):
        assert use(made).identical(use(right))


def test_values_are_not_copied_and_attributes_are_of_one_dataset_only(axes):
    mine = variables()
    made, other = dataset(mine, axes), dataset(variables(), axes)
    assert made["z"].variable._data is mine["z"]._data
    made["time"].attrs["units"] = "ms"
    made.attrs["by"] = "me"
    assert other["time"].attrs == axes["time"].attrs == {"units": "s"}
    assert other.attrs == {}
    made["new"] = ("time", np.zeros(3))
    assert "new" not in other


def refused(cls, *_):
    raise TypeError("another signature")


def empty(cls, *_):
    return xr.Dataset()


@pytest.mark.parametrize("broken", [refused, empty])
def test_another_inside_is_noticed_and_the_public_constructor_used(axes, monkeypatch, broken):
    right = dataset(variables(), axes)
    with monkeypatch.context() as other:
        other.setattr(xr.Dataset, "_construct_direct", classmethod(broken))
        assert not datasets._inside_is_known.__wrapped__()
    known(monkeypatch, False)
    assert dataset(variables(), axes).identical(right)


@pytest.mark.parametrize(
    "wrong",
    [xr.Variable("time", np.zeros(2)), xr.Variable("elsewhere", np.zeros(3))],
    ids=["size", "dimension"],
)
def test_what_does_not_fit_is_for_the_public_constructor(axes, wrong):
    if "time" in wrong.dims:
        with pytest.raises(ValueError, match="conflicting sizes"):
            dataset({"z": wrong}, axes)
    else:
        assert dict(dataset({"z": wrong}, axes).sizes) == {"time": 3, "side": 2, "elsewhere": 3}
