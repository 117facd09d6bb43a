"""Roll centre and support angles of an axle from forces on the rig, beside those of its kinematics."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

import numpy as np

from jounce.axles.builder import SIDES
from jounce.axles.dependent import with_ideal_joints
from jounce.axles.wheels import down, moved, turned
from jounce.core.errors import SimulationError
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.kc.laboratory import Laboratory, axle_of, loop
from jounce.kc.tests import TESTS, KCTest
from jounce.parts import DependentAxle, Rig

if TYPE_CHECKING:
    from collections.abc import Iterator

    import xarray as xr

_POINTS = 9
_SHARE = 0.5
SUPPORTS = tuple(name for name, test in TESTS.items() if test.kind == "longitudinal")
"""Tests with a longitudinal force."""


def kc_centres(
    axle: Rig,
    *,
    travel: float | str = 0.0,
    steer: float | str | None = None,
    on: Literal["front", "rear"] | None = None,
) -> xr.Dataset:
    """Determine roll centre height and support angles of an axle from wheel loads on the rig, and with ideal joints.

    The pads are held at their height and the tyres are loaded horizontally; what changes of the wheel loads is carried
    by the links. With ideal joints this is, by virtual work, the slope of the path of the point at which the force
    acts, so the results for ideal joints are those of the kinematics: ``roll_centre_height``,
    ``contact_patch_recession`` and ``wheel_centre_recession`` of `jounce.sweep_axle`.

    The roll centre height is minus the moment about the x axis of the changes of the wheel loads, at the contact points
    before the force, over the lateral force on both wheels. The support angle is the arctangent of the change of the
    wheel load over the longitudinal force, mean of both wheels.

    Parameters
    ----------
    axle : Rig
        A corner with hardpoints, a dependent axle, or a 3-D car.
    travel : float or str
        Height of both pads above the design position, m.
    steer : float or str, optional
        Rack travel, m, to the left; by default that of the description.
    on : {"front", "rear"}, optional
        Axle of a car.

    Returns
    -------
    xarray.Dataset
        On ``source`` (``"forces"``: the axle as described, ``"kinematics"``: its joints ideal):
        ``roll_centre_height`` (m, above the road), and for ``braking``, ``braking-inboard``, ``driving`` and
        ``driving-hub`` the support angle (rad): positive if the links lift the body, as anti-dive and anti-
        squat do; anti-lift is negative. Ideal joints are NaN if the links then bind. Forces are those up to
        half of the usual range. NaN where there is no equilibrium.

    Raises
    ------
    DescriptionError
        If the rig is no axle.
    SimulationError
        If there is no equilibrium at ride height.

    Examples
    --------
    >>> import jounce as jn
    >>> height = jn.kc_centres(jn.load("semi-trailing-arm"))["roll_centre_height"]
    >>> bool(abs(height[0] - height[1]) < 1e-9)                             # ideal joints
    True
    """
    rig = axle_of(axle, on)
    rack = None if steer is None else to_si(steer, "m", where="steer")
    return centres_of(Laboratory(rig, to_si(travel, "m", where="travel"), rack))


def centres_of(laboratory: Laboratory) -> xr.Dataset:
    """Determine them in the state of a laboratory; see `kc_centres`."""
    import xarray as xr

    given = _centres(laboratory)
    beside = _centres_of_ideal(laboratory) or given
    rows = {"roll_centre_height": ("m", "roll centre height, above the road")}
    rows |= {test: ("rad", f"support angle, {TESTS[test].what}") for test in SUPPORTS}
    return xr.Dataset(
        {
            name: ("source", [given[name], beside[name]], {"units": unit, "long_name": label})
            for name, (unit, label) in rows.items()
        },
        {"source": ["forces", "kinematics"]},
    )


def _centres_of_ideal(laboratory: Laboratory) -> dict[str, float]:
    """Return those of the same axle with ideal joints in the same state; nothing if its joints are ideal already."""
    rig = laboratory.rig
    travel = float((laboratory.state.heights - laboratory.design).mean())
    if isinstance(rig, DependentAxle):
        ideal = with_ideal_joints(rig)
        if ideal is None:
            return dict.fromkeys(("roll_centre_height", *SUPPORTS), np.nan)
        return {} if ideal is rig else _centres(Laboratory(ideal, travel))
    if not rig.elastic_parts:
        return {}
    rigid: dict[str, object] = {"subframe": None, "bearing": None}
    rigid |= {name: type(getattr(rig, name))() for name in ("bushings", "links")}
    steering = getattr(rig, "steering", None)
    if steering is not None:
        rigid["steering"] = steering.model_copy(update={"column_stiffness": None, "housing": ()})
    rack = laboratory.state.rack if laboratory.axle.steered else None
    return _centres(Laboratory(rig.model_copy(update=rigid), travel, rack))


def _centres(laboratory: Laboratory) -> dict[str, float]:
    changes = _load_changes(laboratory, TESTS["lateral-in-phase"])
    across = np.array([point[1] for point in _contacts(laboratory)])
    angles = {
        test: float(np.arctan(_load_changes(laboratory, TESTS[test]).mean())) for test in SUPPORTS
    }
    return {"roll_centre_height": float(-(across * changes).sum() / len(SIDES)), **angles}


def _load_changes(laboratory: Laboratory, test: KCTest) -> Array:
    """Slope of each wheel's load over the force on each tyre with the pads held, shape (2,)."""
    inputs = loop(_SHARE * test.range, _POINTS, one_sided=test.one_sided)
    try:
        poses, _ = laboratory.run(test, inputs, "height", "locked", 0.0)
    except SimulationError:
        return np.full(len(SIDES), np.nan)
    loads = np.stack([poses.control_force(f"{side}.contact") for side in SIDES])
    known = np.isfinite(loads).all(axis=0)
    x = inputs[known] - inputs[known].mean()
    return np.asarray((loads[:, known] * x).sum(axis=1) / (x**2).sum())


def _contacts(laboratory: Laboratory) -> Iterator[Array]:
    """Yield the contact points before a test, m."""
    for wheel in laboratory.axle.assembly.wheels:
        pose = laboratory.state.start[0][wheel.body]
        centre, axis = (np.real(part)[:, 0] for part in (wheel.centre, wheel.axis))
        yield moved(pose, centre) + float(np.real(wheel.radius[0])) * down(turned(pose, axis))
