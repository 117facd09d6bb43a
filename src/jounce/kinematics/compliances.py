"""Compliance: displacement of a wheel on bushings under loads at the contact patch.

The body is fixed, the rack is locked, and the ground holds the wheel at the contact height that ideal joints would give
at that travel, like a test rig with locked pads. Spring and stops follow their laws. Equilibrium includes all large
motions; compliances are its exact derivatives.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import casadi as ca
import numpy as np

from jounce.core.errors import DescriptionError, SimulationError
from jounce.core.remembered import Recent
from jounce.core.types import Array
from jounce.kinematics.loads import ContactLoad
from jounce.kinematics.model import check_corner, has_rack
from jounce.kinematics.sweeps import Values, no_pose, prepare_sweep, sweep_values
from jounce.kinematics.view import CornerView
from jounce.mechanics import Track
from jounce.mechanics.driven import Quasistatic, Statics
from jounce.models.corner import add_both_alike, add_torsion_bar, suspension
from jounce.parts import Corner, Rig
from jounce.parts.rig import structure_of

if TYPE_CHECKING:
    import xarray as xr

_ITERATIONS = 40  # of Newton's method, at most; one that diverges takes them all
_SETTLED = 1e-12  # m, rad
_FREE = 1e-13  # smallest singular value of the scaled equations, relative to the largest: rounding
LOADS = {
    "braking": ("N", "braking force at the contact patch, rearward, wheel locked"),
    "driving": ("N", "longitudinal force at the wheel centre, forward"),
    "lateral": ("N", "lateral force at the contact patch, to the left"),
    "aligning": ("N*m", "torque about +z"),
}
"""Loads of the road on the wheel: unit and label."""
QUANTITIES = {
    "toe": ("rad", "toe angle, toe-in positive"),
    "camber": ("rad", "camber angle, top outward positive"),
    "steer": ("rad", "steer angle, about +z"),
    "wheel_centre_x": ("m", "wheel centre, forward"),
    "wheel_centre_y": ("m", "wheel centre, to the left"),
    "patch_x": ("m", "contact patch, fixed to the upright, forward"),
    "patch_y": ("m", "contact patch, fixed to the upright, to the left"),
}
"""Displacements: unit and label."""


@dataclass(frozen=True)
class ElasticModel:
    """Equations of a corner on its bushings.

    ``equations(q, multipliers, p, ground)`` returns the unbalanced forces and loop equations, their Jacobian for a
    small displacement and the multipliers, and their slope by the loads; ``moved(q, displacement, ...)`` the
    coordinates after a displacement; ``seen(q, p)`` toe, camber and steer, and the displacement of all ``QUANTITIES``
    along one.
    """

    parameters: tuple[str, ...]
    start: Array
    sizes: tuple[int, int]
    equations: ca.Function
    moved: ca.Function
    seen: ca.Function


_models: Recent[ElasticModel] = Recent()


def compliance(
    rig: Rig, travel: Values = 0.0, *, rack: float | None = None, load: ContactLoad | None = None
) -> xr.Dataset:
    """Compute changes of toe, camber and position of a wheel on bushings per unit load at the contact patch.

    The body and the rack are fixed, the ground holds the height of the contact point; spring and stops follow their
    laws, and so do a torsion bar and the gas of a damper; third spring and Z-bar act as if the other wheel carries the
    mirrored load. Results are slopes at equilibrium, not differences; weights, tyre, U- and T-bar are neglected.

    Parameters
    ----------
    rig : Rig
        A corner with hardpoints and bushings.
    travel : float, str or array_like, shape (n,)
        Travel of the wheel centre (m, bump positive, monotonic) of the corner with ideal joints at the height of the
        ground.
    rack : float, optional
        Travel of the rack, m, positive to the left; the description's own by default.
    load : ContactLoad, optional
        Load about which the slopes are taken, N and N m; none by default. Its vertical force must be zero: the ground
        provides it.

    Returns
    -------
    xarray.Dataset
        On ``wheel_travel`` (m): ``<load>.<quantity>`` for the loads braking, driving, lateral (N) and aligning (N m)
        and the quantities toe, camber, steer (rad), wheel_centre_x, wheel_centre_y, patch_x, patch_y (m); and the
        state: ``toe``, ``camber``, ``steer`` (rad). A newton of ``braking`` pushes the patch rearward, one of
        ``driving`` the wheel centre forward; lateral forces (to the left), torques and positions are in ground axes.

    Raises
    ------
    DescriptionError
        If a rig has no hardpoints or no bushings, or values are not monotonic.
    SimulationError
        If no equilibrium is found, or the bushings leave a motion unconstrained.

    Examples
    --------
    >>> import jounce as jn
    >>> soft = {"stiffness": ["8 kN/mm", "8 kN/mm", "8 kN/mm"]}
    >>> arms = ("lower_arm_front", "lower_arm_rear", "upper_arm_front", "upper_arm_rear")
    >>> rig = jn.load("reference-double-wishbone").with_changes({"bushings": dict.fromkeys(arms, soft)})
    >>> yielding = jn.compliance(rig)
    >>> bool(yielding["lateral.patch_y"][0] > 0.0)  # yields to the force
    True
    """
    corner = check_corner(rig)
    if not corner.elastic_points & {*corner.bushed_in_runs}:
        raise DescriptionError(
            "the corner has no bushings, so it has no compliance",
            where="bushings",
            allowed="tables [bushings.<hardpoint>] with a stiffness",
        )
    corner.require("spring", what="compliance")
    load = load or ContactLoad()
    if load.vertical_force:
        raise DescriptionError(
            "the vertical force follows from the ground",
            where="vertical_force",
            found=load.vertical_force,
        )
    travels = sweep_values(travel, "wheel travel")
    ground = _ground(corner, travels, rack)
    states = [
        _yields(corner, float(height), float(at), load) for height, at in zip(*ground, strict=True)
    ]
    return _dataset(corner, travels, states)


def _ground(rig: Corner, travel: Array, rack: float | None) -> tuple[Array, Array]:
    """Height of the contact point (m) and rack travel (m) at each travel, with ideal joints."""
    sweep = prepare_sweep(rig, travel, rack)
    rows = {name: value[:, 0] for name, value in sweep.quantities().items()}
    if not np.all(np.isfinite(rows["wheel_travel"])):
        raise no_pose(sweep.ends())
    return rows["contact_point_z"], rows.get("rack_travel", np.zeros(len(travel)))


def _elastic_model(rig: Corner) -> ElasticModel:
    return _models.of(structure_of(rig), lambda: _build(rig))


def _build(rig: Corner) -> ElasticModel:
    mechanism = Quasistatic(gravity=ca.SX(0.0))
    rack = mechanism.parameter("compliance.rack") if has_rack(rig) else None
    linkage = suspension(rig, mechanism, guide="fixed", rack=rack)
    still = Track(*(ca.SX(0.0) for _ in range(3)))
    view = CornerView(mechanism, linkage, still, None, None)
    linkage.push(view.spring, view.springs.force + view.stops.force)
    linkage.push(view.damper, view.still_damper.force)
    add_torsion_bar(linkage)
    add_both_alike(linkage, damped=False)
    mechanism.condition("ground", view.contact[2] - mechanism.parameter("compliance.ground"))
    mirror = ca.SX([1.0, view.side, 1.0])
    patch, centre, turn = mirror * view.patch, mirror * view.centre.rate, linkage.upright.spin[2]
    loads = [mechanism.parameter(f"compliance.{name}") for name in LOADS]
    for rate, force in zip((-patch[0], centre[0], patch[1], turn), loads, strict=True):
        mechanism.load(rate, force)
    angles = ca.vertcat(-view.toe_out, view.camber, view.side * view.toe_out)
    rates = ca.vertcat(mechanism.rate_of(angles), centre[:2], patch[:2])
    return _functions(mechanism.statics(), ca.vertcat(*loads), angles, rates)


def _functions(statics: Statics, loads: ca.SX, angles: ca.SX, rates: ca.SX) -> ElasticModel:
    q, v, p = statics.q, statics.v, statics.p
    still = ca.SX.zeros(v.shape[0])
    multipliers = ca.SX.sym("multipliers", statics.constraint.shape[0])
    gradient = ca.jacobian(statics.constraint_rate, v)
    unbalanced = ca.substitute(statics.load, v, still) + gradient.T @ multipliers
    equations = ca.vertcat(unbalanced, statics.constraint)
    by_displacement = ca.jacobian(equations, q) @ ca.jacobian(statics.rates, v)
    matrix = ca.horzcat(by_displacement, ca.jacobian(equations, multipliers))
    displacement = ca.SX.sym("displacement", v.shape[0])
    return ElasticModel(
        statics.parameters,
        np.array(statics.start, dtype=float),
        (v.shape[0], multipliers.shape[0]),
        ca.Function(
            "equations", [q, multipliers, p], [equations, matrix, ca.jacobian(equations, loads)]
        ),
        ca.Function("moved", [q, displacement], [statics.moved(displacement)]),
        ca.Function("seen", [q, p], [angles, ca.jacobian(rates, v)]),
    )


def _yields(rig: Corner, ground: float, rack: float, load: ContactLoad) -> tuple[Array, Array]:
    """Angles at equilibrium, shape (3,), and slopes of the quantities along the loads, shape (quantities, loads)."""
    model = _elastic_model(rig)
    longitudinal, forward = (
        ("braking", -1.0) if load.through == "contact_point" else ("driving", 1.0)
    )
    given = {
        "ground": ground,
        "rack": rack,
        "lateral": load.lateral_force,
        "aligning": load.aligning_torque,
    }
    given[longitudinal] = forward * load.longitudinal_force
    numbers = {**rig.parameters(), **{f"compliance.{name}": 0.0 for name in LOADS}}
    numbers |= {f"compliance.{name}": value for name, value in given.items()}
    p = np.array([numbers[path] for path in model.parameters])
    q, multipliers = _equilibrium(model, p)
    _, matrix, slope = (part.full() for part in model.equations(q, multipliers, p))
    displacement = _solve(matrix, -slope)[: model.sizes[0]]
    angles, rates = (part.full() for part in model.seen(q, p))
    return angles[:, 0], rates @ displacement


def _equilibrium(model: ElasticModel, p: Array) -> tuple[Array, Array]:
    """Find coordinates and multipliers in equilibrium by Newton's method from the design pose."""
    q, multipliers = model.start, np.zeros(model.sizes[1])
    for _ in range(_ITERATIONS):
        residual, matrix, _ = (part.full() for part in model.equations(q, multipliers, p))
        step = _solve(matrix, -residual)[:, 0]
        displacement = step[: model.sizes[0]]
        q, multipliers = (
            model.moved(q, displacement).full()[:, 0],
            multipliers + step[model.sizes[0] :],
        )
        if not np.all(np.isfinite(q)):
            break
        if np.max(np.abs(displacement)) < _SETTLED:
            return q, multipliers
    raise SimulationError(
        "no equilibrium on the bushings was found",
        where="bushings",
        hint="Check their stiffnesses and the spring.",
    )


def _solve(matrix: Array, right: Array) -> Array:
    """Solve the scaled equilibrium equations; raise an error for unconstrained motions."""
    rows = 1.0 / np.maximum(np.max(np.abs(matrix), axis=1), 1e-300)
    scaled = matrix * rows[:, None]
    columns = 1.0 / np.maximum(np.max(np.abs(scaled), axis=0), 1e-300)
    values = np.linalg.svd(scaled * columns, compute_uv=False)
    if values[-1] < _FREE * values[0]:
        raise SimulationError(
            "the bushings leave a motion unconstrained",
            where="bushings",
            hint="Give stiffness in all directions that the joint held, or rotational_stiffness.",
        )
    return np.asarray(columns[:, None] * np.linalg.solve(scaled * columns, right * rows[:, None]))


def _dataset(rig: Corner, travel: Array, states: list[tuple[Array, Array]]) -> xr.Dataset:
    import xarray as xr

    angles, slopes = (np.array(part) for part in zip(*states, strict=True))
    names = list(QUANTITIES)
    variables = {
        name: ("wheel_travel", angles[:, k], {"units": "rad", "long_name": QUANTITIES[name][1]})
        for k, name in enumerate(names[:3])
    }
    for j, (load, (per, words)) in enumerate(LOADS.items()):
        for k, (name, (unit, what)) in enumerate(QUANTITIES.items()):
            text = {
                "units": f"{unit}/{per}" if per == "N" else f"{unit}/({per})",
                "long_name": f"{what}, per {words}",
            }
            variables[f"{load}.{name}"] = ("wheel_travel", slopes[:, k, j], text)
    at = {
        "wheel_travel": (
            "wheel_travel",
            travel,
            {"units": "m", "long_name": "vertical travel of the wheel centre"},
        )
    }
    return xr.Dataset(variables, at, {"model": str(getattr(rig, "model", "")), "side": rig.side})
