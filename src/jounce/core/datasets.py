"""Build datasets without xarray's copying and alignment, which take longer than a short run.

The result is `identical` to that of the public constructor. This relies on xarray's internals, which are tested once
per process; if the test fails, the public constructor is used.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.turns import turn

if TYPE_CHECKING:
    import xarray as xr


def dataset(
    variables: Mapping[str, xr.Variable],
    axes: xr.Dataset,
    attributes: Mapping[str, Any] | None = None,
    beside: Mapping[str, xr.Variable] | None = None,
) -> xr.Dataset:
    """Put variables on the axes of a Dataset without variables, with other coordinates in ``beside``.

    The variables are not copied; the caller must not use them afterwards. Many Datasets may share the same axes.

    >>> import xarray as xr
    >>> axes = xr.Dataset(coords={"time": [0.0, 1.0]})
    >>> made = dataset({"z": xr.Variable("time", np.array([1.0, 2.0]))}, axes)
    >>> float(made["z"].sel(time=1.0))
    2.0
    """
    beside = beside or {}
    known = (
        _inside_is_known()
        and _fit({**variables, **beside}, axes)
        and not set(beside) & set(variables)
    )
    return (_direct if known else _public)(variables, axes, attributes, beside)


def _fit(variables: Mapping[str, xr.Variable], axes: xr.Dataset) -> bool:
    sizes = axes.sizes
    return all(
        name not in axes.coords
        and all(
            sizes.get(along) == size
            for along, size in zip(variable.dims, variable.shape, strict=True)
        )
        for name, variable in variables.items()
    )


def _public(
    variables: Mapping[str, xr.Variable],
    axes: xr.Dataset,
    attributes: Mapping[str, Any] | None,
    beside: Mapping[str, xr.Variable],
) -> xr.Dataset:
    import xarray as xr

    return xr.Dataset(variables, axes.coords, attributes).assign_coords(dict(beside))


def _direct(
    variables: Mapping[str, xr.Variable],
    axes: Any,
    attributes: Mapping[str, Any] | None,
    beside: Mapping[str, xr.Variable],
) -> xr.Dataset:
    import xarray as xr

    own: dict[Any, xr.Variable] = dict(variables)
    own.update((name, variable.copy(deep=False)) for name, variable in axes._variables.items())
    own.update(beside)
    return xr.Dataset._construct_direct(
        own,
        {*axes._coord_names, *beside},
        dict(axes._dims),
        dict(attributes) if attributes else None,
        dict(axes._indexes),
    )


@cache
def _inside_is_known() -> bool:
    """Whether direct construction gives the same result as the public constructor.

    The test makes xarray load its lazy imports (dask, if installed). Concurrent threads may see a partially loaded
    package, so only one thread runs it at a time.
    """
    with turn(_inside_is_known):
        return _matches_public()


def _matches_public() -> bool:
    import xarray as xr

    try:
        axes = xr.Dataset(
            coords={
                "along": xr.Variable("along", np.array([0.0, 1.0]), {"units": "s"}),
                "across": xr.Variable("across", np.array([1.0, 3.0, 4.0])),
                "at": xr.Variable((), 2.0, {"units": "m"}),
            }
        )

        def variables() -> dict[str, xr.Variable]:
            return {
                "one": xr.Variable(("along",), np.array([1.0, np.nan]), {"units": "1"}),
                "two": xr.Variable(("along", "across"), np.ones((2, 3))),
            }

        def beside() -> dict[str, xr.Variable]:
            return {"weight": xr.Variable(("along",), np.array([2.0, 5.0]), {"units": "kg"})}

        direct, expected = (
            make(variables(), axes, {"by": "jounce"}, beside()) for make in (_direct, _public)
        )
        return (
            direct.identical(expected)
            and list(direct.variables) == list(expected.variables)
            and all(
                getattr(direct, slot, None) == getattr(expected, slot, None)
                for slot in ("_coord_names", "_dims", "_attrs", "_encoding", "_close")
            )
            and {slot for slot in direct.__slots__ if hasattr(direct, slot)}
            == {slot for slot in expected.__slots__ if hasattr(expected, slot)}
            and list(direct.xindexes) == list(expected.xindexes)
            and direct.sel(along=1.0).identical(expected.sel(along=1.0))
        )
    except Exception:  # noqa: BLE001 - other versions may fail in any way
        return False
