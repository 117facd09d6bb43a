"""Kinematic model of a corner: body fixed, wheel centre and rack driven, every quantity a function of the pose.

With all motions driven, a Newton step on the loops is the pose, the speeds for a unit rate of travel or rack are exact
slopes, and the accelerations for constant rates are exact curvatures. Nothing of it depends on masses or on gravity.
Bushings are taken as ideal joints.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import DescriptionError
from jounce.kernel.native import Native, compile_functions
from jounce.kinematics.catalogue import Quantity, quantities
from jounce.kinematics.view import CornerView, Quasistatic
from jounce.mechanics import Model
from jounce.mechanics.system import Track
from jounce.models.corner import suspension
from jounce.parts import Corner, Rig
from jounce.parts.parameters import structure_of

Array = NDArray[np.float64]
_TRAVEL, _RACK = "travel", "rack"


@dataclass(frozen=True)
class KinematicModel:
    """Native functions of a corner's poses and quantities.

    Attributes
    ----------
    rows : tuple of Quantity
        The catalogue's rows that this corner has, in the order of the outputs.
    tracks : tuple of str
        What is driven: ``"travel"``, and ``"rack"`` where the wheel steers.
    parameters : tuple of str
        Paths of the numbers of the description, in the order the functions take them.
    start : ndarray, shape (n_coordinates,)
        Coordinates in the design pose.
    functions : dict
        The functions ``pose`` and ``output`` (see ``kernel.poses``) as CasADi evaluates them.
    native : Native
        The same as machine code.
    view : CornerView
        The symbols.
    model : Model
        Equations that the functions come from.
    """

    rows: tuple[Quantity, ...]
    tracks: tuple[str, ...]
    parameters: tuple[str, ...]
    start: Array
    functions: dict[str, ca.Function]
    native: Native
    view: CornerView
    model: Model

    def parameter_values(self, rig: Corner) -> Array:
        """Numbers of a description in the order of ``parameters``."""
        values = rig.parameters()
        return np.array([values[path] for path in self.parameters])

    @cached_property
    def points(self) -> tuple[tuple[str, ...], Native]:
        """Names of all points that move or stand, and their native function ``output``: x, y, z of each."""
        places = _places(self.view)
        function = self.function("output", ca.vertcat(*(place for _, place in places)))
        return tuple(name for name, _ in places), compile_functions({"output": function})

    def function(self, name: str, expression: ca.SX) -> ca.Function:
        """Function (q, track values, p, m) of an expression of coordinates, tracks and parameters."""
        return _function(name, self.model, expression)


_models: dict[str, KinematicModel] = {}


def kinematic_model(rig: Rig) -> KinematicModel:
    """Give the kinematic model of a corner; corners that differ in numbers only share one.

    Raises
    ------
    DescriptionError
        For a rig without hardpoints.
    """
    corner = check_corner(rig)
    structure = structure_of(corner)
    if structure not in _models:
        _models[structure] = _build(_rigid(corner))
    return _models[structure]


def _rigid(rig: Corner) -> Corner:
    """Give the corner with ideal joints in place of its bushings."""
    bushings = getattr(rig, "bushings", None)
    return rig if bushings is None else rig.model_copy(update={"bushings": type(bushings)()})


def check_corner(rig: Rig) -> Corner:
    """Refuse a rig that has no hardpoints."""
    if isinstance(rig, Corner):
        return rig
    raise DescriptionError(
        "a lumped rig has no kinematics",
        where=getattr(rig, "name", None) or "rig",
        found=f'model = "{getattr(rig, "model", type(rig).__name__)}"',
        allowed="a rig with hardpoints: double-wishbone, mcpherson, five-link, trailing-arm",
        hint="Try reference-double-wishbone of `jounce library`.",
    )


def has_rack(rig: Corner) -> bool:
    """Tell whether a rack moves the wheel: whether there is a tie rod or a toe link."""
    points = rig.hardpoints
    return hasattr(points, "tie_rod_inner") or hasattr(points, "link_5_inner")


def _build(rig: Corner) -> KinematicModel:
    mechanism = Quasistatic(gravity=ca.SX(0.0))
    travel = mechanism.track(_TRAVEL)
    rack = mechanism.track(_RACK) if has_rack(rig) else None
    linkage = suspension(rig, mechanism, guide="fixed", rack=rack)
    height = linkage.wheel_centre.value[2] - linkage.number("hardpoints.wheel_centre[2]")
    mechanism.condition("wheel_travel", height - travel.value)
    bare = mechanism.finish()
    tracks = [travel] if rack is None else [travel, rack]
    v = bare.x[len(bare.coordinates) :]
    speeds = [_speeds(bare, tracks, k) for k in range(len(tracks))]
    view = CornerView(mechanism, linkage, travel, rack, _driven(v, tracks, speeds[1], 1) if rack is not None else None)
    rows = quantities(view)
    for row in rows:
        mechanism.output(row.name, row.formula(view), row.unit, row.long_name)
    model = mechanism.finish()
    bound = _driven(v, tracks, speeds[0], 0)
    functions = {
        "pose": _function("pose", model, _pose(bare, v, tracks, speeds)),
        "output": _function("output", model, bound(model.output)),
    }
    start = np.array(model.start, dtype=float)
    native = compile_functions(functions)
    return KinematicModel(rows, model.tracks, model.parameters, start, functions, native, view, model)


def _speeds(model: Model, tracks: list[Track], which: int) -> ca.SX:
    """Speeds for a unit rate of one track: from rest, one projection onto the constraints' rates."""
    count = len(model.coordinates)
    v = model.x[count:]
    found = model.projection[count : count + v.shape[0]]
    return _driven(v, tracks, ca.SX(v.shape[0], 1), which)(found)


def _driven(v: ca.SX, tracks: list[Track], speeds: ca.SX, which: int) -> Callable[[ca.SX], ca.SX]:
    """Give the substitution of the speeds by those of a unit rate of one track, without accelerations."""
    symbols = [v, *(track.rate for track in tracks), *(track.acceleration for track in tracks)]
    rates = [ca.SX(float(k == which)) for k in range(len(tracks))]
    values = [ca.densify(speeds), *rates, *([ca.SX(0.0)] * len(tracks))]

    def substitute(expression: ca.SX) -> ca.SX:
        return ca.substitute(ca.densify(expression), ca.vertcat(*symbols), ca.densify(ca.vertcat(*values)))

    return substitute


def _pose(model: Model, v: ca.SX, tracks: list[Track], speeds: list[ca.SX]) -> ca.SX:
    """Coordinates after a Newton step, violation before it, slopes of the coordinates along each track.

    The step starts from quaternions of length one: extrapolated ones are not, and would hide a violation.
    """
    count = len(model.coordinates)
    moved, violation = model.projection[:count], model.projection[-2]
    slopes = [_driven(v, tracks, speeds[k], k)(model.rate[:count]) for k in range(len(tracks))]
    q = model.x[:count]
    start = ca.SX(q)
    for first in (i for i, name in enumerate(model.coordinates) if name.endswith(".e0")):
        e = q[first : first + 4]
        start[first : first + 4] = e / ca.sqrt(ca.dot(e, e))
    return ca.substitute(ca.vertcat(moved, violation, *slopes), q, start)


def _function(name: str, model: Model, expression: ca.SX) -> ca.Function:
    q = model.x[: len(model.coordinates)]
    u = model.u[:: model.track_order]
    return ca.Function(name, [q, u, model.p, ca.SX.sym("m", 1)], [ca.cse(ca.densify(expression))])


def _places(view: CornerView) -> list[tuple[str, ca.SX]]:
    """Places of all hardpoints of the description and of the contact point, ground axes, m."""
    linkage = view.linkage
    names = [name for name in type(linkage.rig.hardpoints).model_fields if getattr(linkage.rig.hardpoints, name)]
    own = view.bar_points if linkage.rig.anti_roll_bar is not None else {}
    places = []
    for name in names:
        owner, place = linkage.owners.get(name), linkage.hardpoint(name)
        places.append((name, own.get(name, place if owner is None else owner.point(place).value)))
    mirror = ca.SX([1.0, view.side, 1.0])
    return [*places, ("contact_point", mirror * view.contact)]
