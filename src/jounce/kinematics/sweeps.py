"""Sweeps of one corner over wheel travel, rack, or both: values, walk, ends of travel, files."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import numpy as np
from numpy.typing import NDArray

from jounce.core.constants import GRAVITY
from jounce.core.datasets import dataset
from jounce.core.description import Description
from jounce.core.errors import DescriptionError, SimulationError
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.samples import as_values
from jounce.core.types import Array
from jounce.core.units import Length, Mass, Unit, bare_si, to_si
from jounce.core.writing import Formats
from jounce.kernel.poses import END_OF_TRAVEL, REACHED, Found, Walk, Work, space_for, walk_poses
from jounce.kinematics.model import KinematicModel, check_corner, check_rack, kinematic_model
from jounce.parts import Corner, Rig
from jounce.recordings.writers import netcdf_of

if TYPE_CHECKING:
    import xarray as xr


# values and the order of the walk -------------------------------------------------------------------------------------


Values = float | str | Sequence[float | str] | Array
"""Values to sweep over: numbers in SI, or text such as "-80 mm:80 mm:4 mm" (first, last, step)."""
_MOST_POSES = 1_000_000  # with 70 quantities 0.6 GB
_FARTHEST = 2.0  # m: largest plausible travel of a wheel or rack
_WHOLE = 1e-9  # tolerance on the end of a range, as a share of the step: rounding of decimal steps


@dataclass(frozen=True)
class Grid:
    """Pairs of travel and rack travel in traversal order, starting at the pair closest to design.

    ``targets`` has the pairs (m), ``place`` the index of each in the flattened grid of ``shape``, and ``before`` the
    index of the target from which each continues, -1 for the design pose.
    """

    shape: tuple[int, int]
    place: NDArray[np.intp]
    targets: Array
    before: NDArray[np.int64]


def text_range(text: str, unit: str, where: str) -> Array:
    """Convert ``"first:last:step"``, or one value, to SI; the last value is included if the steps reach it exactly."""
    parts = [part.strip() for part in text.split(":")]
    if len(parts) not in (1, 3) or not all(parts):
        raise DescriptionError(
            "invalid range", where=where, found=text, allowed='"first:last:step", or one value'
        )
    numbers = [_quantity(part, unit, where) for part in parts]
    if len(numbers) == 1:
        refuse_metres(np.array(numbers), where, unit, text)
        return np.array(numbers)
    first, last, step = numbers
    if step == 0.0 or last == first:
        wrong = "invalid step" if step == 0.0 else "the range is empty"
        raise DescriptionError(
            wrong, where=where, found=text, allowed="first:last:step, or one value"
        )
    if (last - first) * step < 0.0:
        raise DescriptionError(
            "the sign of the step does not lead from the first to the last value",
            where=where,
            found=text,
            allowed="a step above 0 where the values ascend, below 0 where they descend",
            hint="Change its sign, or exchange the ends of the range.",
        )
    refuse_metres(np.array([first, last]), where, unit, text)
    count = (last - first) / step + _WHOLE
    if count > _MOST_POSES:
        raise DescriptionError(
            "too many values",
            where=where,
            found=f"{count:.3g}",
            allowed=Phrase("at most {most_poses}", most_poses=_MOST_POSES),
        )
    return np.round(first + step * np.arange(int(count) + 1), 12)


def refuse_metres(values: Array, where: str, unit: str, text: object = None) -> None:
    """Raise an error for implausible travels (m), such as millimetres given as metres."""
    far = float(np.max(np.abs(values), initial=0.0))
    if unit == "m" and far >= _FARTHEST:
        raise DescriptionError(
            Phrase("{far} m of travel; a bare number is in metres", far=f"{far:g}"),
            where=where,
            found=text if text is not None else f"{far:g} m",
            allowed=Phrase("below {most} m", most=f"{_FARTHEST:g}"),
            hint='Millimetres meant? Write "-20 mm:20 mm:2 mm".',
        )


def _quantity(text: str, unit: str, where: str) -> float:
    try:
        number = float(text)
    except ValueError:
        return to_si(text, unit, where=where)
    return bare_si(number, unit, where=where)


def sweep_values(values: Values, name: str, unit: str = "m") -> Array:
    """Check values to sweep over: finite, ascending or descending, at least one; text is read as a range."""
    if isinstance(values, str):
        return text_range(values, unit, name)
    checked = as_values(values, unit, where=name)
    if not checked.size:
        raise DescriptionError(
            "not a list of values", where=name, found="nothing", allowed="one value or more"
        )
    if not np.all(np.isfinite(checked)):
        raise DescriptionError(
            "not a finite number", where=name, found=checked[~np.isfinite(checked)][0]
        )
    refuse_metres(checked, name, unit)
    steps = np.diff(checked)
    turns = np.flatnonzero((steps == 0.0) | (steps * steps[:1] < 0.0))
    if len(turns):
        i = int(turns[0])
        raise DescriptionError(
            "the values are not monotonic",
            where=f"{name}[{i + 1}]",
            found=f"{checked[i + 1]:g} after {checked[i]:g}",
            allowed="strictly ascending or descending values",
            hint="Sort them.",
        )
    if len(checked) > _MOST_POSES:
        raise DescriptionError(
            "too many values",
            where=name,
            found=len(checked),
            allowed=Phrase("at most {most_poses}", most_poses=_MOST_POSES),
        )
    return checked


def grid(travel: Array, rack: Array) -> Grid:
    """Plan the traversal: along the rack at the travel closest to design, then from each of these along the travel."""
    if len(travel) * len(rack) > _MOST_POSES:
        raise DescriptionError(
            "too many poses",
            where="travel, rack",
            found=len(travel) * len(rack),
            allowed=Phrase("at most {most_poses}", most_poses=_MOST_POSES),
        )
    rows, parents = _chain(travel), _parents(travel)
    columns, starts = _chain(rack), _parents(rack)
    place = [rows[0] * len(rack) + column for column in columns]
    before = list(starts)
    for c, column in enumerate(columns):
        first = len(place) - 1  # target k > 0 of this column has the index first + k
        place += [row * len(rack) + column for row in rows[1:]]
        before += [c if parent == 0 else first + parent for parent in parents[1:]]
    pairs = np.array(np.meshgrid(travel, rack, indexing="ij")).reshape(2, -1).T
    order = np.array(place, dtype=np.intp)
    return Grid(
        (len(travel), len(rack)),
        order,
        np.ascontiguousarray(pairs[order]),
        np.array(before, dtype=np.int64),
    )


def path_grid(travel: Array, rack: Array, *, chained: bool = True) -> Grid:
    """Plan a traversal of pairs of travel and rack, each from the previous one, or all from the design pose."""
    count = len(travel)
    before = (
        np.arange(-1, count - 1, dtype=np.int64) if chained else np.full(count, -1, dtype=np.int64)
    )
    pairs = np.ascontiguousarray(np.stack([travel, rack], axis=1))
    return Grid((count, 1), np.arange(count, dtype=np.intp), pairs, before)


def _middle(values: Array) -> int:
    """Return the index of the value closest to zero, the lower of two, to make a sweep and its reverse equal."""
    return min(range(len(values)), key=lambda i: (abs(values[i]), values[i]))


def _chain(values: Array) -> list[int]:
    """Return the indices from the value closest to zero to the end, then back to the beginning."""
    middle = _middle(values)
    return [middle, *range(middle + 1, len(values)), *range(middle - 1, -1, -1)]


def _parents(values: Array) -> list[int]:
    """Return the predecessor of each index in the chain."""
    middle = _middle(values)
    up, down = len(values) - 1 - middle, middle
    return [-1, *range(up), *([0, *range(up + 1, up + down)] if down else [])]


# the car around the corner --------------------------------------------------------------------------------------------


_Share = Annotated[float, Unit("1", at_least=0.0, at_most=1.0)]
CarLength = Annotated[float, Unit("m", above=0.0, at_most=30.0)]
"""A dimension of a car, m; the upper limit detects millimetres given as metres."""


class AxleLayout(Description):
    """Vehicle data of an axle, for the shares of load transfer carried by the suspension's geometry.

    ``axle`` is the axle of the corner; ``wheelbase`` (m), ``centre_of_mass_height`` (m, above the ground);
    ``brake_share`` is this axle's share of the braking force, with ``brakes`` on the wheels (outboard) or at the
    inboard end of the shafts (inboard). ``drive_share`` is its share of the driving force (default: 1 for a rear axle,
    0 for a front axle), through shafts from a motor on the body or, with ``drive = "hub"``, from motors on the wheels.
    ``mass`` (kg, of the car) adds dive, lift and squat in m at 1 g. ``front_overhang`` (m, of the body ahead of the
    front wheel centres) and ``body_width`` (m) add the turn diameter between walls.

    Examples
    --------
    >>> AxleLayout(axle="front", wheelbase="2.7 m", centre_of_mass_height="550 mm", brake_share=0.65).wheelbase
    2.7
    """

    axle: Literal["front", "rear"]
    wheelbase: CarLength
    centre_of_mass_height: CarLength
    brake_share: _Share
    brakes: Literal["outboard", "inboard"] = "outboard"
    drive_share: _Share | None = None
    drive: Literal["shaft", "hub"] = "shaft"
    mass: Mass | None = None
    front_overhang: Length | None = None
    body_width: CarLength | None = None

    @property
    def driven(self) -> float:
        """Share of the axle in the driving force [1]."""
        return float(self.axle == "rear") if self.drive_share is None else self.drive_share

    @property
    def effects(self) -> tuple[str, ...]:
        """Names of the anti-effects: in braking and, for a driven axle, in driving."""
        names = ("anti_dive", "anti_lift") if self.axle == "front" else ("anti_lift", "anti_squat")
        return names if self.driven > 0.0 else names[:1]


ANTI_EFFECTS = {
    ("front", "anti_dive"): "share of the braking dive that the front geometry takes",
    ("front", "anti_lift"): "share of the driving lift that the front geometry takes",
    ("rear", "anti_lift"): "share of the braking lift that the rear geometry takes",
    ("rear", "anti_squat"): "share of the driving squat that the rear geometry takes",
}
ANTI_SIGN = "positive: against the body's motion; 1 is all of it"
_PER_G = {"front": ("dive_per_g", "lift_per_g"), "rear": ("lift_per_g", "squat_per_g")}
_MOVES = {"dive": "sinking", "squat": "sinking", "lift": "rising"}


def shares(vehicle: AxleLayout, contact: Array, centre: Array) -> dict[str, Array]:
    """Shares of load transfer carried by the geometry, 1 for all of it.

    The transfer acts at the contact patch; ``contact`` and ``centre`` are dx [1] per rise of the patch with the wheel
    locked: of the patch itself, for torques reacted by the wheel carrier (outboard brakes, hub motors), and of the
    wheel centre, where the force of torques through a shaft reaches the carrier. By virtual work this relieves the
    spring.
    """
    lever = vehicle.wheelbase / vehicle.centre_of_mass_height
    way = 1.0 if vehicle.axle == "front" else -1.0
    braked = contact if vehicle.brakes == "outboard" else centre
    driven = contact if vehicle.drive == "hub" else centre
    values = way * vehicle.brake_share * lever * braked, way * vehicle.driven * lever * driven
    return dict(zip(vehicle.effects, values, strict=False))


def moves_per_g(
    vehicle: AxleLayout, rows: Mapping[str, Array], taken: Mapping[str, Array]
) -> dict[str, Array]:
    """Displacement of the body (m) above this axle at 1 g of braking, and of driving, by springs and tyres."""
    if vehicle.mass is None or "wheel_rate_contact" not in rows:
        return {}
    transfer = (
        0.5 * vehicle.mass * GRAVITY * vehicle.centre_of_mass_height / vehicle.wheelbase
    )  # N, per wheel
    rate = rows["wheel_rate_contact"]
    if (
        "heave_rate" in rows
    ):  # springs that act in parallel wheel travel are given at the wheel centre
        force, at_centre = (
            rows[f"heave_{name}"] - rows[f"wheel_{name}"] for name in ("force", "rate")
        )
        rise = (
            rows["motion_ratio"] / rows["motion_ratio_contact"]
        )  # rise of the patch per rise of the wheel centre
        growth = rows["motion_ratio_gradient"] - rise**2 * rows["motion_ratio_contact_gradient"]
        rate = rate + (at_centre - force * growth / rows["motion_ratio"]) / rise**2
    tyre = transfer / rows["tyre_stiffness"] if "tyre_stiffness" in rows else 0.0
    shares_of: list[Array | float] = [taken[name] for name in vehicle.effects]
    shares_of += [0.0] * (2 - len(shares_of))
    names = _PER_G[vehicle.axle]
    return {
        name: transfer * (1.0 - share) / rate + tyre
        for name, share in zip(names, shares_of, strict=True)
    }


# ends of travel -------------------------------------------------------------------------------------------------------


_MOST_ENDS = 4  # ends of travel listed individually, to keep messages readable
_JUST_BEFORE = 0.999  # share of the last step at which the forces of the joints are compared
_HOLDS = 0.25  # share of the largest constraint force above which a joint is named


@dataclass(frozen=True)
class End:
    """An end of travel: the last reachable pose, the requested pose (m), and the joints stretched there."""

    travel: float
    rack: float
    wanted_travel: float
    wanted_rack: float
    joints: tuple[str, ...]

    def __str__(self) -> str:
        at = f"at wheel travel {1e3 * self.travel:.4g} mm"
        wanted = f"{1e3 * self.wanted_travel:.4g} mm"
        if self.rack or self.wanted_rack:
            at += f", rack travel {1e3 * self.rack:.4g} mm"
            wanted += f", {1e3 * self.wanted_rack:.4g} mm"
        held = (
            f"; {' and '.join(self.joints)} {'are' if len(self.joints) > 1 else 'is'} stretched"
            if self.joints
            else ""
        )
        return f"the mechanism reaches the end of its travel {at}, on the way to {wanted}{held}"


def ends_text(ends: Sequence[End]) -> str:
    """Describe where a sweep stopped, listing only the first ends."""
    more = f"; and {len(ends) - _MOST_ENDS} more ends of travel" if len(ends) > _MOST_ENDS else ""
    return "; ".join(map(str, ends[:_MOST_ENDS])) + more


def no_pose(ends: Sequence[End]) -> SimulationError:
    """Build the error for a sweep without any pose."""
    why = f": {ends[0]}" if ends else ""
    return SimulationError(
        Phrase("no pose of the sweep can be reached{why}", why=why), hint="Sweep a smaller range."
    )


def ends_of_travel(model: KinematicModel, walk: Walk, layout: Grid, poses: Found) -> list[End]:
    """Return the ends of travel of a sweep, the first one with the joints that block it."""
    ends: list[End] = []
    for i in np.flatnonzero(poses.outcome == END_OF_TRAVEL):
        j = int(layout.before[i])
        start = layout.targets[j] if j >= 0 else np.zeros(2)
        last = start + poses.share[i] * (layout.targets[i] - start)
        first = len(ends) < _MOST_ENDS
        joints = (
            _holding(model, walk, poses, int(i), start + _JUST_BEFORE * (last - start))
            if first
            else ()
        )
        wanted = layout.targets[i]
        ends.append(End(float(last[0]), float(last[1]), float(wanted[0]), float(wanted[1]), joints))
    return ends


def _holding(
    model: KinematicModel, walk: Walk, poses: Found, i: int, last: Array
) -> tuple[str, ...]:
    """Joints with the largest forces just before the end of travel."""
    j = int(walk.before[i])
    tracks = walk.targets.shape[1]
    near = _to_target(walk, poses, j, last[:tracks])
    last_poses, work = space_for(near, len(model.rows))
    walk_poses(near, last_poses, work)
    pose, at = last_poses.poses[:, 0], near.targets[0]
    if not np.all(np.isfinite(pose)):
        pose, at = near.start, near.origin
    matrix = model.functions["gradient"](pose, at, walk.p, 0.0).full()
    shares = np.abs(np.linalg.svd(matrix)[0][:, -1])
    names: dict[str, float] = {}
    for joint, share in zip(model.joints, shares * np.linalg.norm(matrix, axis=1), strict=True):
        if joint != "wheel_travel":
            names[joint] = max(names.get(joint, 0.0), float(share))
    largest = max(names.values(), default=0.0)
    return tuple(name for name, share in names.items() if share >= _HOLDS * largest > 0.0)


def _to_target(walk: Walk, poses: Found, j: int, target: Array) -> Walk:
    """Return the walk from target ``j`` of a different walk to a given target."""
    start, origin = (poses.poses[:, j], walk.targets[j]) if j >= 0 else (walk.start, walk.origin)
    return walk._replace(
        start=np.ascontiguousarray(start),
        origin=np.ascontiguousarray(origin),
        targets=np.array([target]),
        before=np.array([-1], dtype=np.int64),
    )


# toggles --------------------------------------------------------------------------------------------------------------

_TOGGLE = 3.0  # times the speed at design beyond which a toggle is reported
_TRACKS = ("wheel travel", "rack travel")


def toggle_findings(sweep: PreparedSweep) -> list[Finding]:
    """Report where the last run came close to a toggle: on each side, the first pose with excessive speeds.

    Near a toggle the loops are ill conditioned: parts move many times as fast for the same travel (or rack) as at the
    start of the sweep, and beyond it the mechanism locks. The same holds for the spring.
    """
    poses, tracks = sweep.found, sweep.walk.targets.shape[1]
    reached = poses.outcome == REACHED
    if not reached[0]:
        return []
    size, names = len(sweep.walk.start), [row.name for row in sweep.model.rows]
    speeds = {
        ("kinematics.parts_toggle", _TRACKS[t]): np.max(
            np.abs(poses.slopes[t * size : (t + 1) * size]), axis=0
        )
        for t in range(tracks)
    }
    if "motion_ratio" in names:
        speeds["kinematics.spring_toggles", ""] = np.abs(poses.outputs[names.index("motion_ratio")])
    findings = []
    for (code, track), speed in speeds.items():
        for side in (1.0, -1.0):
            distance = side * sweep.layout.targets.sum(axis=1)
            near = reached & (distance > 0.0) & (speed > _TOGGLE * speed[0]) & (speed[0] > 0.0)
            if near.any():
                i = int(np.flatnonzero(near)[np.argmin(distance[near])])
                travel, rack = sweep.layout.targets[i]
                at = f"wheel travel {1e3 * travel:.4g} mm" + (
                    f", rack travel {1e3 * rack:.4g} mm" if rack else ""
                )
                share = float(speed[i] / speed[0])
                findings.append(finding(code, at, share, ratio=share, track=track))
    return findings


# sweeps ---------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class PreparedSweep:
    """A prepared sweep of a corner; ``run`` can be called any number of times."""

    rig: Corner
    model: KinematicModel
    layout: Grid
    walk: Walk
    found: Found
    work: Work

    def run(self) -> Array:
        """Compute all poses; return the quantities, shape (rows, travels, racks), NaN out of reach."""
        walk_poses(self.walk, self.found, self.work)
        return self.in_place(self.found.outputs, self.found.outcome == REACHED)

    def quantities(self) -> dict[str, Array]:
        """Compute all poses; return each quantity by name, shape (travels, racks)."""
        return {row.name: value for row, value in zip(self.model.rows, self.run(), strict=True)}

    def in_place(self, values: Array, reached: NDArray[np.bool_]) -> Array:
        """Reorder values from traversal order, shape (rows, targets), to grid order."""
        ordered = np.full((len(values), len(self.layout.place)), np.nan)
        ordered[:, self.layout.place[reached]] = values[:, reached]
        return ordered.reshape(len(values), *self.layout.shape)

    def points(self) -> dict[str, Array]:
        """Coordinates of all points in the last run, ``<name>.x`` and so on, m, shape (travels, racks)."""
        names, native = self.model.point_names, self.model.points
        reached = self.found.outcome == REACHED
        places = np.full((3 * len(names), len(reached)), np.nan)
        for i in np.flatnonzero(reached):
            at = self.found.poses[:, i], self.found.inputs[:, i], self.walk.p, np.zeros(1)
            places[:, i] = native.evaluate("output", (3 * len(names),), *at)
        keys = [f"{name}.{axis}" for name in names for axis in "xyz"]
        return dict(zip(keys, self.in_place(places, reached), strict=True))

    def ends(self) -> list[End]:
        """Ends of travel of the last run."""
        return ends_of_travel(self.model, self.walk, self.layout, self.found)


def prepare_sweep(rig: Rig, travel: Values, rack: Values | None = None) -> PreparedSweep:
    """Prepare a sweep of a corner over travel (m, bump positive) and rack travel (m, positive to the left), in order.

    By default the rack is at the position given in the description.

    >>> import jounce as jn
    >>> sweep = prepare_sweep(jn.load("reference-double-wishbone"), [-0.04, 0.0, 0.04])
    >>> sweep.run().shape[1:]
    (3, 1)
    """
    corner = check_corner(rig)
    layout = grid(
        sweep_values(travel, "wheel travel"), sweep_values(_rack_of(corner, rack), "rack travel")
    )
    return _prepare(corner, layout)


def _prepare(corner: Corner, layout: Grid) -> PreparedSweep:
    model = kinematic_model(corner)
    tracks = len(model.tracks)
    walk = Walk(
        model.native.address["pose"],
        model.native.address["output"],
        model.parameter_values(corner),
        model.start,
        np.zeros(tracks),
        np.ascontiguousarray(layout.targets[:, :tracks]),
        layout.before,
    )
    return PreparedSweep(corner, model, layout, walk, *space_for(walk, len(model.rows)))


def _rack_of(corner: Corner, rack: Values | None) -> Values:
    if rack is None:
        steering = getattr(corner, "steering", None)
        return 0.0 if steering is None else float(steering.rack_travel)
    if np.any(sweep_values(rack, "rack travel") != 0.0):
        check_rack(corner, "0, or a corner with a tie rod")
    return rack


def travel_of_corner(
    rig: Rig, bump: Values, rack: Values | None, vehicle: AxleLayout | None, *, points: bool
) -> xr.Dataset:
    """Sweep a corner over wheel travel; see ``sweep_travel``."""
    return _swept(
        prepare_sweep(rig, bump, rack),
        rack is not None and (np.ndim(rack) > 0 or (isinstance(rack, str) and ":" in rack)),
        True,
        vehicle,
        points,
    )


def sweep_rack(
    rig: Rig,
    rack: Values,
    travel: float | str = 0.0,
    *,
    vehicle: AxleLayout | None = None,
    points: bool = False,
) -> xr.Dataset:
    """Sweep the steering rack of a corner with the wheel centre at one height.

    Parameters
    ----------
    rig : Rig
        A corner with a tie rod (or toe link) and hardpoints.
    rack : float, str or array_like, shape (m,)
        Travel of the rack, m, positive to the left, monotonic; or text, ``"-20 mm:20 mm:5 mm"``.
    travel : float or str
        Vertical travel of the wheel centre from design, m, bump positive.
    vehicle : AxleLayout, optional
        Adds anti-dive, or anti-lift and anti-squat.
    points : bool
        Whether to add the positions of all hardpoints, m.

    Returns
    -------
    xarray.Dataset
        As from :func:`sweep_travel`, on ``rack_travel`` (m).

    Raises
    ------
    DescriptionError
        If a rig has no hardpoints or rack, or values are not monotonic.
    SimulationError
        If no pose can be reached.

    Examples
    --------
    >>> import jounce as jn
    >>> steered = jn.sweep_rack(jn.load("reference-double-wishbone"), [-0.01, 0.0, 0.01])
    >>> bool(steered["steer"][0] > 0.0)  # tie rod behind the axle: rack to the right, wheel to the left
    True
    """
    check_rack(check_corner(rig))
    return _swept(
        prepare_sweep(rig, to_si(travel, "m", where="wheel travel"), rack),
        True,
        False,
        vehicle,
        points,
    )


def sweep_path(
    rig: Rig,
    travel: Values,
    rack: Values,
    *,
    vehicle: AxleLayout | None = None,
    points: bool = False,
) -> xr.Dataset:
    """Sweep a corner along a path of pairs of wheel travel and rack travel, as in a table or a measured log.

    Parameters
    ----------
    rig : Rig
        A corner with hardpoints.
    travel, rack : sequence of float or str, or array_like, shape (n,)
        Travel of the wheel centre from design (m, bump positive) and of the rack (m, positive to the left), pose by
        pose, in any order; one value for all poses is allowed.
    vehicle : AxleLayout, optional
        Adds anti-dive, or anti-lift and anti-squat.
    points : bool
        Whether to add the positions of all hardpoints, m.

    Returns
    -------
    xarray.Dataset
        As from :func:`sweep_travel`, on ``pose`` (numbers from 0) with ``wheel_travel`` and ``rack_travel`` (m) as
        further coordinates; NaN for a pair out of reach.

    Raises
    ------
    DescriptionError
        If a rig has no hardpoints or no rack to move, or values have different lengths.
    SimulationError
        If no pose can be reached.

    Examples
    --------
    >>> import jounce as jn
    >>> turn = jn.sweep_path(jn.load("formula-student-front"), [0.0, 0.005, 0.01], [0.0, -0.01, -0.02])
    >>> turn["camber"].sizes["pose"]
    3
    """
    import xarray as xr

    corner = check_corner(rig)
    pair = [
        path_values(values, name)
        for values, name in ((travel, "wheel travel"), (rack, "rack travel"))
    ]
    if np.any(pair[1] != 0.0):
        check_rack(corner, "0, or a corner with a tie rod")
    if len({len(values) for values in pair if len(values) > 1}) > 1:
        counts = [len(values) for values in pair]
        raise DescriptionError(
            "rack travel and wheel travel have different lengths", where="rack travel", found=counts
        )
    both = np.broadcast_arrays(*pair)
    sweep, quantities = path_sweep(corner, *both)
    ends = sweep.ends() if np.any(sweep.found.outcome != REACHED) else []
    if not np.isfinite(quantities[0]).any():
        raise no_pose(ends)
    variables_by_name = SweepVariables()
    for row, value in zip(sweep.model.rows, quantities, strict=True):
        variables_by_name.add(row.name, value, row.unit, row.long_name, row.sign, row.clause)
    _add_further(variables_by_name, sweep, vehicle, points=points, keep=...)
    variables = {
        name: xr.Variable(("pose",), value[:, 0], variables_by_name.attributes[name], fastpath=True)
        for name, value in variables_by_name.values.items()
        if name not in ("wheel_travel", "rack_travel")
    }
    axes: list[_Axis] = [("pose", "pose", np.arange(len(both[0]), dtype=float).tobytes(), ())]
    for name, values in zip(("wheel_travel", "rack_travel"), both, strict=True):
        axes.append(
            (
                name,
                "pose",
                values.tobytes(),
                (("units", "m"), ("long_name", name.replace("_", " "))),
            )
        )
    facts = facts_of(corner, corner.side, variables_by_name.values["wheel_travel"], ends)
    facts["findings"] = "; ".join(map(str, toggle_findings(sweep)))
    return dataset(variables, _axes(*axes), facts)


def path_sweep(
    corner: Corner, travel: Array, rack: Array, numbers: Array | None = None
) -> tuple[PreparedSweep, Array]:
    """Run a sweep along pairs (m); return it with its quantities, shape (rows, n, 1); ``numbers`` as in the model."""
    for chained in (True, False):  # then from design, to reach pairs after an unreachable one
        sweep = _prepare(corner, path_grid(travel, rack, chained=chained))
        if numbers is not None:
            sweep.walk.p[:] = numbers
        values = sweep.run()
        if np.all(sweep.found.outcome == REACHED):
            break
    return sweep, values


def path_values(values: Values, name: str, unit: str = "m") -> Array:
    """Check values given pose by pose, in any order."""
    if isinstance(values, str):
        return text_range(values, unit, name)
    checked = as_values(values, unit, where=name)
    if checked.ndim != 1 or not len(checked) or not np.all(np.isfinite(checked)):
        raise DescriptionError("not a list of finite values", where=name, found=str(values)[:60])
    if len(checked) > _MOST_POSES:
        raise DescriptionError(
            "too many values",
            where=name,
            found=len(checked),
            allowed=Phrase("at most {most_poses}", most_poses=_MOST_POSES),
        )
    refuse_metres(checked, name, unit)
    return checked


def _add_further(
    variables: SweepVariables,
    sweep: PreparedSweep,
    vehicle: AxleLayout | None,
    *,
    points: bool,
    keep: Any,
) -> None:
    """Add optional variables: shares of load transfer, coordinates of points."""
    if vehicle is not None:
        slopes = (
            variables.values["contact_patch_recession"],
            variables.values["wheel_centre_recession"],
        )
        taken = shares(vehicle, *slopes)
        for name, share in taken.items():
            variables.add(name, share, "1", ANTI_EFFECTS[vehicle.axle, name], ANTI_SIGN)
        for (name, move), when in zip(
            moves_per_g(vehicle, variables.values, taken).items(),
            ("braking", "driving"),
            strict=False,
        ):
            direction = _MOVES[name.partition("_")[0]]
            text = f"{direction} of the body above this axle at 1 g of {when}, springs and tyres together"
            variables.add(name, move, "m", text, f"positive: {direction}")
    if points:
        for name, value in sweep.points().items():
            variables.add(name, value[keep], "m", f"place of {name}", "ground axes")


def _swept(
    sweep: PreparedSweep,
    along_rack: bool,
    along_travel: bool,
    vehicle: AxleLayout | None,
    points: bool,
) -> xr.Dataset:
    """Run a sweep and arrange its quantities on their grid; a fixed dimension becomes a scalar coordinate."""
    import xarray as xr

    values = sweep.run()
    ends = sweep.ends() if np.any(sweep.found.outcome != REACHED) else []
    reached = np.isfinite(values[0])
    if not reached.any():
        raise no_pose(ends)
    some = (np.flatnonzero(reached.any(axis=1)), np.flatnonzero(reached.any(axis=0)))
    keep = ... if reached.all() else np.ix_(*some)  # a view costs less than a copy
    variables_by_name = SweepVariables()
    for row, value in zip(sweep.model.rows, values, strict=True):
        variables_by_name.add(row.name, value[keep], row.unit, row.long_name, row.sign, row.clause)
    _add_further(variables_by_name, sweep, vehicle, points=points, keep=keep)
    along = {"wheel_travel": along_travel, "rack_travel": along_rack}
    dimensions = tuple(name for name, swept in along.items() if swept)
    at = tuple(slice(None) if swept else 0 for swept in along.values())
    coordinates = []
    for i, (name, swept) in enumerate(along.items()):
        if name in variables_by_name.values:
            axis = np.nanmax(variables_by_name.values[name], axis=1 - i)
            attributes = tuple(variables_by_name.attributes[name].items())
            coordinates.append((name, name if swept else "", axis.tobytes(), attributes))
    variables = {
        name: xr.Variable(dimensions, value[at], variables_by_name.attributes[name], fastpath=True)
        for name, value in variables_by_name.values.items()
        if name not in along
    }
    facts = facts_of(sweep.rig, sweep.rig.side, variables_by_name.values["wheel_travel"], ends)
    facts["findings"] = "; ".join(map(str, toggle_findings(sweep)))
    return dataset(variables, _axes(*coordinates), facts)


_Axis = tuple[str, str, bytes, tuple[tuple[str, str], ...]]


@lru_cache(32)
def _axes(*coordinates: _Axis) -> xr.Dataset:
    """Axes of a sweep: name, dimension (empty for a single value), values and attributes of each."""
    import xarray as xr

    coordinates_of: dict[str, Any] = {}
    for name, along, content, attributes in coordinates:
        values = np.frombuffer(content).copy()
        values = values.astype(int) if name == "pose" else values
        coordinates_of[name] = xr.Variable(
            along or (), values if along else values[0], dict(attributes)
        )
    return xr.Dataset(coords=coordinates_of)


class SweepVariables:
    """Variables of a sweep by name, each with its attributes."""

    def __init__(self) -> None:
        self.values: dict[str, Array] = {}
        self.attributes: dict[str, dict[str, str]] = {}

    def add(
        self, name: str, value: Array, unit: str, long_name: str, sign: str, clause: str = ""
    ) -> None:
        """Add a variable; ``sign`` is the meaning of a positive value."""
        self.values[name] = value
        self.attributes[name] = {"units": unit, "long_name": long_name, "sign": sign}
        if clause:
            self.attributes[name]["clause"] = clause


def facts_of(rig: Rig, side: str, swept: Array, ends: Sequence[End]) -> dict[str, Any]:
    """Return the attributes of a sweep: its rig, its range, and where it stopped."""
    return {
        "model": str(getattr(rig, "model", "")),
        "side": side,
        "status": "end_of_travel" if ends else "completed",
        "reached": [float(np.nanmin(swept)), float(np.nanmax(swept))],
        "stopped": ends_text(ends),
    }


# files ----------------------------------------------------------------------------------------------------------------


def write_sweep(sweep: xr.Dataset, path: Path | str, *, force: bool = False) -> Path:
    """Write a sweep to a file.

    Parameters
    ----------
    sweep : xarray.Dataset
        As returned by :func:`sweep_travel` and related functions.
    path : Path or str
        ``.nc`` for netCDF-4 with all attributes; ``.csv`` for one row per pose with ``name [unit]`` headers, SI.
    force : bool
        Overwrite an existing file.

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    OutputError
        If a file exists and ``force`` is not set, a folder is missing, or the suffix is not supported.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> import jounce as jn
    >>> sweep = jn.sweep_travel(jn.load("reference-double-wishbone"), [-0.04, 0.0, 0.04])
    >>> file = jn.write_sweep(sweep, pathlib.Path(tempfile.mkdtemp()) / "sweep.csv")
    >>> file.read_text(encoding="utf-8").splitlines()[0].startswith("wheel_travel [m],rack_travel [m]")
    True
    """
    return SWEEP_FILES.write(sweep, path, force=force)


def _write_netcdf(sweep: xr.Dataset, file: Path) -> None:
    listed = {
        str(key): value for key, value in sweep.attrs.items() if isinstance(value, (list, tuple))
    }
    numbers = {
        key: np.array(value)
        for key, value in listed.items()
        if all(isinstance(x, float) for x in value)
    }
    file.write_bytes(netcdf_of(sweep.assign_attrs(numbers)))


def _write_csv(sweep: xr.Dataset, file: Path) -> None:
    """Write one row per pose; missing values (out of reach, at infinity) stay empty."""
    names = [*map(str, sweep.coords), *map(str, sweep.data_vars)]
    sizes = {str(name): size for name, size in sweep.sizes.items()}
    columns = [_on_grid(sweep[name].variable, sizes) for name in names]
    header = ",".join(f"{name} [{sweep[name].attrs.get('units', '1')}]" for name in names)
    rows = (
        ",".join(repr(value) if np.isfinite(value) else "" for value in row)
        for row in zip(*columns, strict=True)
    )
    file.write_bytes(("\n".join([header, *rows]) + "\n").encode())


def _on_grid(variable: Any, sizes: dict[str, int]) -> list[float]:
    return list(variable.set_dims(sizes).transpose(*sizes).values.ravel().tolist())


SWEEP_FILES = Formats("sweeps", {".nc": _write_netcdf, ".csv": _write_csv})
"""Formats of sweep files."""
