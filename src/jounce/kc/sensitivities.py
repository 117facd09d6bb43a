"""Slopes of K&C tests by hardpoints and stiffnesses."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Literal

import numpy as np

from jounce.axles.dependent import build_axle
from jounce.core.errors import unknown
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.kc.laboratory import Handwheel, Held, Laboratory, axle_of
from jounce.kc.quantities import Poses, quantities
from jounce.kc.slopes import slope_unit
from jounce.kc.tangents import DIRECTIONS, SETTLED, Tangents
from jounce.kc.tests import TESTS, KCTest
from jounce.kernel import equilibrium as eq
from jounce.parts import Rig
from jounce.parts.rig import unit_of

if TYPE_CHECKING:
    import xarray as xr

_STATED = ("wheel.radius",)  # measured with a tape, not adjusted


def kc_parameters(rig: Rig) -> tuple[str, ...]:
    """Return the paths of all numbers that equilibria of an axle depend on: hardpoints, stiffnesses, preloads."""
    axle = axle_of(rig, None)
    read = build_axle(axle).read
    listed = [path for path in read if path not in _STATED]
    assembly = build_axle(axle, listed).assembly
    seeds, moves = assembly.seeds(), set()
    for (place, column), change in zip(seeds.places.tolist(), seeds.changes.copy(), strict=True):
        if place >= 0 and assembly.elements[place].kind == eq.BUSHING:  # curves replace stiffnesses
            laws = assembly.elements[place].laws
            change[[eq.K + k for k, law in enumerate(laws) if law is not None]] = 0.0
        if change.any():
            moves.add(column)
    return tuple(path for i, path in enumerate(listed) if i in moves)


def check_parameters(
    rig: Rig, parameters: Sequence[str] | None, known: Sequence[str] = ()
) -> tuple[str, ...]:
    """Return the paths by which slopes are asked for, or all; refuse what the axle does not depend on."""
    known = tuple(known) or kc_parameters(rig)
    if parameters is None:
        return known
    names: list[str] = []
    for path in parameters:
        parts = [name for name in known if name.startswith((f"{path}[", f"{path}."))]
        if path in known:
            names.append(path)
        elif parts:
            names += parts
        else:
            raise unknown(path, known, what="parameter of the axle", where="parameters")
    return tuple(dict.fromkeys(names))


def kc_sensitivities(  # noqa: PLR0913 - options of a test
    axle: Rig,
    tests: str | Sequence[str] | None = None,
    parameters: Sequence[str] | None = None,
    *,
    quantities: Sequence[str] | None = None,
    to: float | str | None = None,
    points: int = 41,
    travel: float | str = 0.0,
    steer: float | str | None = None,
    held: Held = "load",
    handwheel: Handwheel = "locked",
    trail: float | str | None = None,
    on: Literal["front", "rear"] | None = None,
) -> xr.Dataset:
    """Compute how K&C tests change with hardpoints and stiffnesses: exact slopes at every sample, and of fitted lines.

    A parameter of the corner changes both sides of the axle. The loads at ride height, which tests keep, change with
    the parameters; the slopes contain that, and what friction keeps from earlier samples. Where the solver halves a
    step during which friction slips, slopes are exact to about 1e-3 of the largest only.

    Parameters
    ----------
    axle : Rig
        A corner with hardpoints, or a 3-D car.
    tests : str or sequence of str, optional
        Tests; by default all that the axle can do. One name gives a dataset without the dimension ``test``.
    parameters : sequence of str, optional
        Paths of numbers of the description; a whole point or bushing, such as ``"hardpoints.tie_rod_inner"``, stands
        for all its numbers. By default all hardpoints, stiffnesses and preloads that the axle is built from.
    quantities : sequence of str, optional
        Names such as ``"left.toe"``; by default all of the tests except loads of bushings.
    to, points, travel, steer, held, handwheel, trail, on
        As in `kc_test`: end of the range (SI or with unit), number of samples, height of the pads and rack travel
        before the test (m), what is held, trail (m) and the axle of a car.

    Returns
    -------
    xarray.Dataset
        ``value`` (quantity, sample) in SI, ``sensitivity`` (quantity, sample, parameter), the slope of each by each
        parameter in SI, ``slope`` (quantity) of the straight line over the whole test, and ``slope_sensitivity``
        (quantity, parameter). ``input`` (sample), the units of quantities, slopes and parameters are coordinates.

    Raises
    ------
    DescriptionError
        If a test, quantity or parameter is unknown.
    SimulationError
        If there is no equilibrium at ride height.

    Examples
    --------
    >>> import jounce as jn
    >>> rig = jn.load("generic-mcpherson")
    >>> rows = jn.kc_sensitivities(rig, "bounce", ["hardpoints.tie_rod_inner[2]"])
    >>> bump_steer = rows["slope_sensitivity"].sel(quantity="left.toe", parameter="hardpoints.tie_rod_inner[2]")
    >>> f"{float(bump_steer):.2f} rad/m per m"
    '12.13 rad/m per m'
    """
    import xarray as xr

    rig = axle_of(axle, on)
    paths = check_parameters(rig, parameters)
    rack = None if steer is None else to_si(steer, "m", where="steer")
    laboratory = Laboratory(rig, to_si(travel, "m", where="travel"), rack)
    names = laboratory.names((tests,) if isinstance(tests, str) else tests)
    options = (points, held, handwheel, trail)
    each = sensitivities_of(laboratory, dict.fromkeys(names, to), paths, quantities, *options)
    if isinstance(tests, str):
        return each[tests]
    longest = max(part.sizes["sample"] for part in each.values())
    return xr.concat(
        [part.pad(sample=(0, longest - part.sizes["sample"])) for part in each.values()],
        xr.Variable("test", names),
        data_vars="all",
        coords=["input", "slope_unit"],
        combine_attrs="drop_conflicts",
    )


def sensitivities_of(
    laboratory: Laboratory,
    ends: Mapping[str, float | str | None],
    parameters: tuple[str, ...],
    quantities: Sequence[str] | None = None,
    points: int = 41,
    held: Held = "load",
    handwheel: Handwheel = "locked",
    trail: float | str | None = None,
) -> dict[str, xr.Dataset]:
    """Return the slopes of tests by name, each to the end of its range, with one laboratory."""
    tangents = Tangents(laboratory, parameters)
    options = (points, held, handwheel, trail)
    units = {path: unit_of(laboratory.rig, path) for path in parameters}
    return {
        name: _of_test(tangents, TESTS[name], units, quantities, to, *options)
        for name, to in ends.items()
    }


def _of_test(
    tangents: Tangents,
    test: KCTest,
    parameters: Mapping[str, str],
    wanted: Sequence[str] | None,
    to: float | str | None,
    points: int,
    held: Held,
    handwheel: Handwheel,
    trail: float | str | None,
) -> xr.Dataset:
    import xarray as xr

    laboratory = tangents.laboratory
    inputs = laboratory.inputs(test, to, points)
    behind = test.trail if trail is None else to_si(trail, "m", where="trail")
    tangent, place = tangents.run(test, inputs, held, handwheel, behind)
    path = laboratory.path(test, inputs, held, handwheel, behind)
    own = laboratory.multipliers + len(laboratory.controls)
    settled = tangent.settled._replace(multipliers=tangent.settled.multipliers[:, :own])
    settled = settled._replace(**{part: getattr(settled, part)[place] for part in SETTLED})
    values = quantities(Poses(laboratory.axle, settled, path))
    if wanted is None:
        wanted = [name for name in values if not is_of_bushing(name)]
    for name in wanted:
        if name not in values:
            raise unknown(name, values, what="quantity", where="quantities")
    slopes = tangents.slopes(tangent, wanted)
    names = [name for name in wanted if name in slopes]
    changes = np.stack([slopes[name] for name in names])[:, place]
    curves = np.stack([values[name].values for name in names])
    units = [str(values[name].attrs["units"]) for name in names]
    return xr.Dataset(
        {
            "value": (("quantity", "sample"), curves),
            "sensitivity": (("quantity", "sample", "parameter"), changes),
            "slope": ("quantity", line_of(inputs, curves[..., None])[:, 0]),
            "slope_sensitivity": (("quantity", "parameter"), line_of(inputs, changes)),
        },
        {
            "quantity": names,
            "parameter": list(parameters),
            "input": (
                "sample",
                inputs,
                {"units": test.unit, "long_name": test.what, "positive": test.positive},
            ),
            "unit": ("quantity", units),
            "slope_unit": ("quantity", [slope_unit(unit, test.unit) for unit in units]),
            "parameter_unit": ("parameter", list(parameters.values())),
        },
        {"test": test.name, "held": held, "handwheel": handwheel},
    )


def line_of(inputs: Array, values: Array) -> Array:
    """Return the slopes of straight lines through values (..., samples, m) over inputs, without samples not reached."""
    reached = np.isfinite(values).all(axis=(0, 2))
    away = np.where(reached, inputs - inputs[reached].mean(), 0.0)
    return np.asarray(np.einsum("s,qsp->qp", away / (away @ away), np.nan_to_num(values)))


def is_of_bushing(name: str) -> bool:
    """Whether a quantity is a load of a bushing."""
    return name.rpartition(".")[2] in DIRECTIONS
