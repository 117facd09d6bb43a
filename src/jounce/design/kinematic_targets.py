"""Target values: catalogue rows at poses of a corner or an axle, with derivatives along the free variables.

The derivatives of a corner's rows are exact. Those of an axle's rows are finite differences of closed formulas along
the exact derivatives of the rows of both wheels.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import DescriptionError, unknown
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.core.units import positive_si, to_si
from jounce.design.compliance_targets import SheetEvaluator, SheetRow, read_sheet_row
from jounce.design.free_points import Numbering, Rigs
from jounce.design.kinematic_study import USUAL_TOLERANCES, KinematicTarget
from jounce.kernel.poses import REACHED
from jounce.kinematics.across import reaches_over
from jounce.kinematics.axle import (
    Ground,
    TwoWheelAxle,
    WheelRows,
    roll_axle,
    roll_rows,
    steering_rows,
)
from jounce.kinematics.both_wheels import check_pair_of_corners
from jounce.kinematics.catalogue import require_parts
from jounce.kinematics.clearances import PosedCorner, Rim, Shape, check_pair
from jounce.kinematics.model import KinematicModel, check_corner, has_rack, kinematic_model
from jounce.kinematics.sweeps import AxleLayout, PreparedSweep, prepare_sweep, shares, sweep_values
from jounce.kinematics.tangents import Tangents
from jounce.parts import Corner, DependentAxle

_POSES = ("travel", "rack", "roll")
_UNITS = {"travel": "m", "rack": "m", "roll": "rad"}
_DISTANCE = re.compile(r"distance\(\s*(\w+)\s*,\s*(\w+)\s*\)$")
_CLEARANCE = re.compile(r"clearance\(\s*([^,()]+?)\s*,\s*([^,()]+?)\s*\)$")
_SHARE = 1e-3  # of a direction's length: step of differences of an axle's closed formulas


@dataclass(frozen=True)
class Wanted:
    """A target in SI: the values of ``quantity`` at ``poses`` (k, 3: travel m, rack m, roll rad), along one of them.

    ``low`` and ``high`` (n,) are the limits, equal for a single wanted value; n is 1 for a slope, otherwise k. ``rig``
    is the name of the rig in a study of several, ``right`` the right corner of its axle if it is not the mirror image,
    and ``pair`` the two bodies of a clearance. ``sheet`` is a row of a K&C sheet: then ``along`` is its test, and the
    poses hold the ends of its line.
    """

    text: KinematicTarget
    quantity: str
    unit: str
    poses: Array
    along: str
    low: Array
    high: Array
    tolerance: float
    rig: str = ""
    pair: tuple[Shape, Shape] | None = None
    right: str = ""
    sheet: SheetRow | None = None

    @property
    def at(self) -> Array:
        """Abscissa of the curve, SI, shape (k,)."""
        if self.sheet is not None:
            return self.poses[:, 0]
        return self.poses[:, _POSES.index(self.along)]

    @property
    def weights(self) -> Array:
        """Matrix from values at the poses to wanted values, shape (n, k): identity, or the slope of a line."""
        if not self.text.slope:
            return np.asarray(np.eye(len(self.poses)))
        away = self.at - self.at.mean()
        return np.asarray((away / (away @ away))[None, :])

    @property
    def label(self) -> str:
        """Return the quantity, preceded by the name of its rig in a study of several, and by its test."""
        test = self.sheet.test if self.sheet else ""
        return " ".join(part for part in (self.rig, test, self.quantity) if part)

    def is_met_by(self, values: Array) -> bool:
        """Return whether all values (n,) are within the tolerance."""
        return bool(np.all(np.abs(self.off(values)) <= self.tolerance * (1.0 + 1e-9)))

    def off(self, values: Array) -> Array:
        """Return the deviation of values (n,) from the target, SI; positive above, negative below."""
        return np.asarray(
            np.where(values > self.high, values - self.high, np.minimum(values - self.low, 0.0))
        )


# reading --------------------------------------------------------------------------------------------------------------


def read_targets(
    rigs: Rigs,
    targets: Sequence[KinematicTarget],
    vehicles: Mapping[str, AxleLayout],
    shapes: Mapping[str, Shape] | None = None,
) -> list[Wanted]:
    """Convert the targets of a study to SI; reject targets that do not apply to its rigs, naming the key."""
    for name in vehicles:
        if name not in rigs:
            raise unknown(name, rigs, what="rig", where="vehicles")
    return [
        _read_target(rigs, target, vehicles, shapes or {}, f"target[{i}]")
        for i, target in enumerate(targets)
    ]


def numbering_of(rigs: Rigs, wanted: Sequence[Wanted]) -> Numbering:
    """Index the parameters of rigs that their targets depend on."""
    return Numbering.of(rigs, {item.rig for item in wanted if item.sheet is not None})


def _read_target(
    rigs: Rigs,
    target: KinematicTarget,
    vehicles: Mapping[str, AxleLayout],
    shapes: Mapping[str, Shape],
    where: str,
) -> Wanted:
    name = target.rig or ""
    if name not in rigs:
        if "" in rigs:
            raise DescriptionError(
                "the study has one rig", where=f"{where}.rig", found=name, hint="Leave it out."
            )
        if target.rig is None:
            raise DescriptionError(
                "the target does not name its rig",
                where=f"{where}.rig",
                found="none",
                allowed=", ".join(rigs),
            )
        raise unknown(name, rigs, what="rig", where=f"{where}.rig")
    rig, vehicle = rigs[name], vehicles.get(name)
    if target.test is not None:
        row = _sheet_row(rig, target, where)
        ends = np.array([[row.low, 0.0, 0.0], [row.high, 0.0, 0.0]])
        given = _limits(target, row.unit, 1, where)
        return Wanted(target, row.quantity, row.unit, ends, row.test, *given, name, sheet=row)
    if not isinstance(rig, Corner):
        raise DescriptionError(
            "a dependent axle has targets on K&C tests only",
            where=f"{where}.quantity",
            found=target.quantity,
            hint='Name the test, such as test = "roll".',
        )
    poses, along = _poses(rig, target, where)
    of_axle = _is_of_axle(target, along)
    right = _right_corner(rigs, rig, target, of_axle, where)
    unit = quantity_unit(rig, target.quantity, along if of_axle else "", vehicle, where, right)
    if target.slope:
        unit = {"1": f"1/{_UNITS[along]}"}.get(unit, f"{unit}/{_UNITS[along]}")
    given = _limits(target, unit, 1 if target.slope else len(poses), where)
    pair = _read_pair(rig, target.quantity, along, shapes, where)
    return Wanted(
        target, target.quantity, unit, poses, along, *given, name, pair, target.right or ""
    )


def _sheet_row(rig: Corner | DependentAxle, target: KinematicTarget, where: str) -> SheetRow:
    """Return the row of a K&C sheet that a target names."""
    at = target.at if isinstance(target.at, dict) else {"travel": target.at or 0.0}
    state = {}
    for name, value in at.items():
        if name not in ("travel", "rack"):
            raise unknown(str(name), ("travel", "rack"), what="coordinate", where=f"{where}.at")
        state[name] = to_si(value, "m", where=f"{where}.at.{name}")
    assert target.test is not None
    return read_sheet_row(
        rig,
        target.test,
        target.quantity,
        target.over,
        state.get("travel", 0.0),
        state.get("rack"),
        where,
    )


def _limits(
    target: KinematicTarget, unit: str, count: int, where: str
) -> tuple[Array, Array, float]:
    """Return the lower and upper limit of each value, and the tolerance, SI."""

    def read(name: str) -> Array:
        value = getattr(target, name)
        if value is None:
            return np.full(count, -np.inf if name == "at_least" else np.inf)
        return np.full(count, to_si(value, unit, where=f"{where}.{name}"))

    if target.values is not None:
        if len(target.values) != count:
            raise DescriptionError(
                "there must be one value per pose",
                where=f"{where}.values",
                found=len(target.values),
                allowed=str(count),
            )
        low = np.array(
            [
                to_si(value, unit, where=f"{where}.values[{i}]")
                for i, value in enumerate(target.values)
            ]
        )
        high = low
    elif target.value is not None:
        low = high = read("value")
    else:
        low, high = read("at_least"), read("at_most")
        if np.any(low > high):
            raise DescriptionError(
                "at_least is greater than at_most", where=where, found=f"{target.at_least}"
            )
    if target.tolerance is None and unit not in USUAL_TOLERANCES:
        text, allowed = (
            "the key is missing",
            Phrase("a tolerance above 0 {unit}", unit=unit),
        )
        raise DescriptionError(text, where=f"{where}.tolerance", allowed=allowed)
    given = USUAL_TOLERANCES[unit] if target.tolerance is None else target.tolerance
    tolerance = positive_si(given, unit, where=f"{where}.tolerance")
    return low, high, tolerance


def _right_corner(
    rigs: Rigs, rig: Corner, target: KinematicTarget, of_axle: bool, where: str
) -> Corner | None:
    """Return the right corner of the axle of a target; None if it is the mirror image of the left one."""
    if target.right is None:
        return None
    if target.right not in rigs:
        raise unknown(target.right, rigs, what="rig", where=f"{where}.right")
    if not of_axle:
        text, hint = (
            "only a rolled or steered axle has two corners",
            "Leave it out, or set the target over roll.",
        )
        raise DescriptionError(text, where=f"{where}.right", found=target.quantity, hint=hint)
    if rig.side != "left":
        raise DescriptionError(
            "not a left corner",
            where=f"{where}.rig",
            found=f'side = "{rig.side}"',
            allowed='"left" if right is given',
        )
    right = check_corner(rigs[target.right])
    check_pair_of_corners(rig, right, f"{where}.right")
    if has_rack(rig) and not has_rack(right):
        raise DescriptionError(
            "this wheel has no steering rack", where=f"{where}.right", found=target.right
        )
    return right


def _read_pair(
    rig: Corner, quantity: str, along: str, shapes: Mapping[str, Shape], where: str
) -> tuple[Shape, Shape] | None:
    """Return the two bodies of a clearance target; None for other quantities."""
    named = _CLEARANCE.match(quantity)
    if named is None:
        return None
    if along == "roll":
        raise DescriptionError(
            "a clearance depends only on wheel travel and rack travel",
            where=where,
            found="over roll",
        )
    for name in named.groups():
        if name not in shapes:
            raise unknown(name, shapes, what="shape", where=f"{where}.quantity")
    first, second = (shapes[name] for name in named.groups())
    check_pair(rig, (first, second), where)
    return first, second


def _poses(rig: Corner, target: KinematicTarget, where: str) -> tuple[Array, str]:
    """Return the poses of a target, shape (k, 3), and the coordinate that varies."""
    fixed = {
        "travel": 0.0,
        "rack": float(getattr(getattr(rig, "steering", None), "rack_travel", 0.0)),
        "roll": 0.0,
    }
    along: str = target.along or "travel"
    values = np.zeros(1)
    if target.over is not None:
        along = target.along or ("roll" if _is_angle(target.over) else "travel")
        over = list(target.over) if isinstance(target.over, tuple) else target.over
        values = sweep_values(over, f"{where}.over", _UNITS[along])
        if target.slope and len(values) < 2:
            raise DescriptionError(
                "a slope needs at least two poses", where=f"{where}.over", found=len(values)
            )
    elif isinstance(target.at, dict):
        for name, value in target.at.items():
            if name not in _POSES:
                raise unknown(str(name), _POSES, what="coordinate", where=f"{where}.at")
            fixed[name] = float(sweep_values([value], f"{where}.at.{name}", _UNITS[name])[0])
        along = target.along or next(
            (name for name in ("roll", "rack") if target.at.get(name)), "travel"
        )
        values = np.array([fixed[along]])
    elif target.at is not None:
        along = target.along or ("roll" if _is_angle(target.at) else "travel")
        values = sweep_values([target.at], f"{where}.at", _UNITS[along])
    else:
        values = np.array([fixed[along]])
    if (along == "rack" or fixed["rack"]) and not has_rack(rig):
        raise DescriptionError(
            "this wheel has no steering rack",
            where=where,
            found=f"along the rack: {target.quantity}",
        )
    if along == "roll" and fixed["travel"]:
        raise DescriptionError(
            "wheel travel follows from the roll and cannot be set", where=f"{where}.at"
        )
    poses = np.tile([fixed[name] for name in _POSES], (len(values), 1))
    poses[:, _POSES.index(along)] = values
    return poses, along


def _is_angle(value: object) -> bool:
    texts = [value] if isinstance(value, str) else value if isinstance(value, (list, tuple)) else []
    first = next((item for item in texts if isinstance(item, str)), "")
    words = re.findall(r"[A-Za-z°]+", re.sub(r"(?<=\d)[eE](?=[-+\d])", "", first))
    return bool(words) and words[0] in (
        "deg",
        "rad",
        "mrad",
        "degree",
        "degrees",
        "radian",
        "arcmin",
        "°",
    )


def _is_of_axle(target: KinematicTarget, along: str) -> bool:
    return along == "roll" or target.quantity in _STEERED


_HANDWHEEL = {"c_factor": "m", "steering_ratio": "1"}
"""Rows of the steering gear, if the corner describes it."""
_STEERED = {
    "ackermann": "1",
    "ideal_outer_steer": "rad",
    "ackermann_error": "rad",
    "turning_radius": "m",
    "turn_diameter_kerbs": "m",
    "turn_diameter_walls": "m",
    "mean_steer": "rad",
    "steer_difference": "rad",
    **_HANDWHEEL,
}
_WITHOUT_VEHICLE = ("mean_steer", "steer_difference", *_HANDWHEEL)
_ROLLED = {"track": "m", "roll_centre_height": "m", "roll_centre_y": "m", "roll_moment": "N*m"}
_STIFF = {f"roll_stiffness{name}": "N*m/rad" for name in ("", "_springs", "_bar", "_total")}
"""Rows of a rolled axle that contain a finite difference; their derivatives are differences of whole axles."""
_EACH = {"camber_to_ground": "rad", "roll_steer": "1", "roll_camber": "1", "roll_caster": "1"}


def quantity_unit(
    rig: Corner,
    name: str,
    along: str,
    vehicle: AxleLayout | None,
    where: str,
    right: Corner | None = None,
) -> str:
    """Return the SI unit of a target quantity; reject an unknown quantity."""
    rows = {row.name: row.unit for row in kinematic_model(rig).rows}
    known = dict(rows)
    if vehicle is not None:
        known |= dict.fromkeys(vehicle.effects, "1")
    points = _DISTANCE.match(name)
    if points:
        for point in points.groups():
            if point not in rig.hardpoints.given():
                raise unknown(
                    point, rig.hardpoints.given(), what="hardpoint", where=f"{where}.quantity"
                )
        return "m"
    if _CLEARANCE.match(name):
        return "m"
    if along == "roll":
        others = (
            rows if right is None else {row.name: row.unit for row in kinematic_model(right).rows}
        )
        both = {
            f"{side}.{row}": unit
            for side, own in (("left", rows), ("right", others))
            for row, unit in {**own, **_EACH}.items()
            if row != "roll_caster" or "caster" in own
        }
        springs = {
            row: unit
            for row, unit in _STIFF.items()
            if "total" not in row or "tyre_stiffness" in rows
        }
        known = {**_ROLLED, **both, **(springs if "wheel_force" in rows else {})}
        if "wheel_force" not in rows or "wheel_force" not in others:
            known = {
                row: unit for row, unit in known.items() if row not in (*_STIFF, "roll_moment")
            }
    elif has_rack(rig):
        ratio = getattr(getattr(rig, "steering", None), "rack_ratio", None)
        known |= {
            row: unit
            for row, unit in _STEERED.items()
            if row not in _HANDWHEEL or ratio is not None
        }
        if vehicle is None and name in _STEERED and name not in _WITHOUT_VEHICLE:
            raise DescriptionError(
                "needs vehicle data",
                where=f"{where}.quantity",
                found=name,
                allowed="a table [vehicle] with axle, wheelbase, centre_of_mass_height, brake_share",
            )
    if name not in known:
        if name in ("anti_dive", "anti_lift", "anti_squat"):
            hint = "It needs a table [vehicle] of that axle."
            raise DescriptionError(
                "not available without vehicle data",
                where=f"{where}.quantity",
                found=name,
                hint=hint,
            )
        require_parts(rig, name.removeprefix("left.").removeprefix("right."))
        if name in (*_STIFF, "roll_moment"):
            rig.require("spring", what=name)
        raise unknown(name, known, what="quantity", where=f"{where}.quantity")
    return known[name]


# values ---------------------------------------------------------------------------------------------------------------


@dataclass
class _CornerPoses:
    """A grid of travel and rack positions of one corner, from which target values are read."""

    sweep: PreparedSweep
    tangents: Tangents
    place: NDArray[np.intp] = field(init=False)

    def __post_init__(self) -> None:
        self.place = np.argsort(self.sweep.layout.place)


class TargetEvaluator:
    """Evaluates all targets for the parameters of a rig, with derivatives along ``directions`` (parameters, n).

    ``lengths`` (n,) is the range of each direction. If the axle has a separate ``right`` corner, its parameters follow
    those of the left one.
    """

    def __init__(
        self,
        rig: Corner,
        wanted: Sequence[Wanted],
        directions: Array,
        lengths: Array,
        vehicle: AxleLayout | None,
        right: Corner | None = None,
    ) -> None:
        self.rig, self.wanted, self.vehicle, self.right = rig, list(wanted), vehicle, right
        self.model: KinematicModel = kinematic_model(rig)
        self.names = {row.name: i for i, row in enumerate(self.model.rows)}
        self._cut = len(self.model.parameters)
        self.directions, self.lengths = directions[: self._cut], lengths
        self._padded = self._with_tracks(rig, self.directions)
        self._every = directions  # directions of both sides
        self._posed: dict[bytes, PosedCorner] = {}
        shapes = [
            shape for item in wanted for shape in item.pair or () if not isinstance(shape, Rim)
        ]
        self._solid = {point for shape in shapes for point in shape.points}
        self._grids: dict[tuple[str, float], _CornerPoses] = {}
        for key in dict.fromkeys(
            self._key(item) for item in wanted if self._kind(item) == "corner"
        ):
            self._grids[key] = self._grid(key)
        self._lay_out()

    def together(self, numbers: Array, *, slopes: bool = True) -> tuple[Array, Array]:
        """Return the concatenated values of all targets (see ``parts``) and, if requested, slopes (all, directions)."""
        count = self.parts[-1].stop
        values, along = (
            np.empty(count),
            np.empty((count if slopes else 0, self.directions.shape[1])),
        )
        own = numbers[: self._cut]
        moved: dict[tuple[str, float], Array | None] = {}
        for key, grid in self._grids.items():
            grid.sweep.walk.p[:] = own
            grid.sweep.run()
            tangents = moved[key] = grid.tangents.run() if slopes else None
            into, rows, columns = self._plain[key]
            reached = grid.sweep.found.outcome == REACHED
            values[into] = np.where(
                reached[columns], grid.sweep.found.outputs[rows, columns], np.nan
            )
            if tangents is not None:
                along[into] = tangents[rows, :, columns]
        axles: dict[tuple[str, float], Any] = {}
        self._posed.clear()  # clearances at the same poses share them
        for item, part in self._further:
            kind = self._kind(item)
            if kind == "corner":
                value, slope = self._of_corner(item, moved[self._key(item)])
            elif kind == "distance":
                value, slope = self._distance(item, own)
            elif kind == "clearance":
                value, slope = self._clearance(item, own, slopes=slopes)
            else:
                value, slope = self._of_axle(item, kind, numbers, axles, slopes=slopes)
            values[part] = item.weights @ value
            if slopes and slope is not None:
                along[part] = item.weights @ slope
        return values, along

    def _lay_out(self) -> None:
        """Assign slices to the values of each target, and find targets that are plain rows of a corner's poses."""
        ends = np.cumsum([len(item.low) for item in self.wanted])
        self.parts = [
            slice(int(end) - len(item.low), int(end))
            for item, end in zip(self.wanted, ends, strict=True)
        ]
        plain: dict[tuple[str, float], tuple[list[int], list[int], list[int]]]
        plain = {key: ([], [], []) for key in self._grids}
        self._further: list[tuple[Wanted, slice]] = []
        for item, part in zip(self.wanted, self.parts, strict=True):
            if self._kind(item) != "corner" or item.quantity not in self.names or item.text.slope:
                self._further.append((item, part))
                continue
            into, rows, columns = plain[self._key(item)]
            into += range(part.start, part.stop)
            rows += [self.names[item.quantity]] * len(item.poses)
            columns += self._columns(item).tolist()
        self._plain = {
            key: tuple(np.array(indices, dtype=np.intp) for indices in lists)
            for key, lists in plain.items()
        }

    def _columns(self, item: Wanted) -> NDArray[np.intp]:
        """Return the indices of a target's poses in the traversal order of its grid."""
        grid = self._grids[self._key(item)]
        swept = np.unique(grid.sweep.layout.targets[:, 1 if item.along == "rack" else 0])
        return np.asarray(grid.place[np.searchsorted(swept, item.at)])

    def ends_in_words(self) -> list[str]:
        """Return a description of where the last poses ended."""
        return [
            str(end)
            for grid in self._grids.values()
            if np.any(grid.sweep.found.outcome != REACHED)
            for end in grid.sweep.ends()[:1]
        ]

    # corners -------------------------------------------------------------------------------------------------------

    @staticmethod
    def _kind(item: Wanted) -> str:
        if _DISTANCE.match(item.quantity):
            return "distance"
        if item.pair is not None:
            return "clearance"
        if item.along == "roll":
            return "roll"
        return "steering" if item.quantity in _STEERED else "corner"

    @staticmethod
    def _key(item: Wanted) -> tuple[str, float]:
        return (
            ("rack", float(item.poses[0, 0]))
            if item.along == "rack"
            else ("travel", float(item.poses[0, 1]))
        )

    def _grid(self, key: tuple[str, float]) -> _CornerPoses:
        mine = [
            item for item in self.wanted if self._kind(item) == "corner" and self._key(item) == key
        ]
        swept = np.unique(np.concatenate([item.at for item in mine]))
        sweep = prepare_sweep(self.rig, *((key[1], swept) if key[0] == "rack" else (swept, key[1])))
        return _CornerPoses(sweep, Tangents(sweep, self._padded))

    def _of_corner(self, item: Wanted, moved: Array | None) -> tuple[Array, Array | None]:
        grid = self._grids[self._key(item)]
        i = self._columns(item)
        poses = grid.sweep.found
        outputs = np.where(poses.outcome == REACHED, poses.outputs, np.nan)
        if item.quantity in self.names:
            row = self.names[item.quantity]
            return outputs[row, i], None if moved is None else moved[row][:, i].T
        assert self.vehicle is not None
        contact, centre = (
            self.names[name] for name in ("contact_patch_recession", "wheel_centre_recession")
        )
        value = shares(self.vehicle, outputs[contact, i], outputs[centre, i])[item.quantity]
        if moved is None:
            return value, None
        return value, shares(self.vehicle, moved[contact][:, i].T, moved[centre][:, i].T)[
            item.quantity
        ]

    def _distance(self, item: Wanted, numbers: Array) -> tuple[Array, Array]:
        """Return the distance between two hardpoints at design."""
        match = _DISTANCE.match(item.quantity)
        assert match is not None
        paths = [[f"hardpoints.{name}[{i}]" for i in range(3)] for name in match.groups()]
        known = self.rig.parameters()
        index = {path: i for i, path in enumerate(self.model.parameters)}

        def place(path: str) -> float:
            return float(numbers[index[path]]) if path in index else known[path]

        def slope(path: str) -> Array:
            return (
                self.directions[index[path]]
                if path in index
                else np.zeros(self.directions.shape[1])
            )

        away = np.array([place(a) - place(b) for a, b in zip(*paths, strict=True)])
        length = float(np.linalg.norm(away))
        moves = np.array([slope(a) - slope(b) for a, b in zip(*paths, strict=True)])
        count = len(item.poses)
        return np.full(count, length), np.tile(away @ moves / length, (count, 1))

    def _clearance(
        self, item: Wanted, numbers: Array, *, slopes: bool
    ) -> tuple[Array, Array | None]:
        """Return the distance between two bodies."""
        assert item.pair is not None
        travel, rack = item.poses[:, 0].copy(), item.poses[:, 1].copy()
        key = travel.tobytes() + rack.tobytes()
        if key not in self._posed:
            directions = self._padded if slopes else None
            self._posed[key] = PosedCorner.along(
                self.rig, self._solid, (travel, rack), numbers, directions
            )
        distance, along = self._posed[key].distance(*item.pair)
        return distance, None if along is None else along.T

    # axles ---------------------------------------------------------------------------------------------------------

    def _of_axle(
        self,
        item: Wanted,
        kind: str,
        numbers: Array,
        known: dict[tuple[str, float], Any],
        *,
        slopes: bool,
    ) -> tuple[Array, Array | None]:
        key = (kind, float(item.poses[0, 0 if kind == "steering" else 1]))
        if key not in known:
            mine = [
                target
                for target in self.wanted
                if self._kind(target) == kind and _fixed_value(target, kind) == key[1]
            ]
            names = {target.quantity for target in mine}
            at = np.unique(np.concatenate([_swept_values(target, kind) for target in mine]))
            known[key] = (
                at,
                (self._evaluate_steering if kind == "steering" else self._evaluate_roll)(
                    numbers, at, key[1], names, slopes
                ),
            )
        at, (values, moved) = known[key]
        i = np.searchsorted(at, _swept_values(item, kind))
        return values[item.quantity][i], moved[item.quantity][:, i].T if slopes else None

    def _evaluate_steering(
        self, numbers: Array, racks: Array, travel: float, names: set[str], slopes: bool
    ) -> tuple[dict[str, Array], dict[str, Array]]:
        axle = self._axle(numbers, self._everywhere if slopes else None)
        left, right = (axle.wheel(side, travel, racks) for side in (1.0, -1.0))

        def rows(left: WheelRows, right: WheelRows, numbers: Array) -> dict[str, Array]:
            computed = steering_rows(self._axle(numbers), left, right, racks, self.vehicle).values
            return {name: computed[name] for name in names}

        values = rows(left, right, numbers)
        if not slopes:
            return values, {}
        return values, self._along(
            lambda a, b, p, _: rows(a, b, p), axle, left, right, numbers, 0.0
        )

    def _evaluate_roll(
        self, numbers: Array, roll: Array, rack: float, names: set[str], slopes: bool
    ) -> tuple[dict[str, Array], dict[str, Array]]:
        whole = names & {*_STIFF, *(("roll_moment",) if reaches_over(self.rig) else ())}
        if whole:  # rows that couple both wheels need whole axles
            values, moved = self._difference_roll(numbers, roll, rack, whole, slopes=slopes)
            if whole == names:
                return values, moved
            others = self._evaluate_roll(numbers, roll, rack, names - whole, slopes)
            return values | others[0], moved | others[1]
        rising = tuple(
            np.hstack([part, np.eye(len(part))[:, :1]]) for part in self._everywhere
        )  # and travel
        axle = self._axle(numbers, (rising[0], rising[1]) if slopes else None)
        left, right = axle.level(roll, rack)

        def rows(
            left: WheelRows, right: WheelRows, numbers: Array, roll: Array
        ) -> dict[str, Array]:
            sides = Ground(left, roll, 1.0), Ground(right, roll, -1.0)
            computed = roll_rows(self._axle(numbers), *sides, np.zeros_like(roll)).values
            return {name: computed[name] for name in names}

        values = rows(left.wheel, right.wheel, numbers, roll)
        if not slopes:
            return values, {}
        # the travel at which both wheels touch the road changes too: it closes the height difference
        heights = self._along(
            lambda a, b, _, at: {"off": Ground(a, at, 1.0).height - Ground(b, at, -1.0).height},
            axle,
            left.wheel,
            right.wheel,
            numbers,
            roll,
        )["off"]
        away = heights / (left.height_by_travel + right.height_by_travel)
        for side in (1.0, -1.0):
            axle.slopes[side] = {
                name: slope[:-1] - side * away * slope[-1]
                for name, slope in axle.slopes[side].items()
            }
        return values, self._along(rows, axle, left.wheel, right.wheel, numbers, roll)

    def _difference_roll(
        self, numbers: Array, roll: Array, rack: float, names: set[str], *, slopes: bool
    ) -> tuple[dict[str, Array], dict[str, Array]]:
        """Return the rows of a rolling axle and their differences along each direction."""

        def at(numbers: Array) -> dict[str, Array]:
            computed = roll_axle(self._axle(numbers), roll, rack).values
            return {name: computed[name] for name in names}

        moved = dict[str, list[Array]]()
        for k, length in enumerate(self.lengths if slopes else ()):
            step = _SHARE * length
            ahead, behind = (at(numbers + sign * step * self._every[:, k]) for sign in (1.0, -1.0))
            for name in names:
                moved.setdefault(name, []).append((ahead[name] - behind[name]) / (2.0 * step))
        return at(numbers), {name: np.array(values) for name, values in moved.items()}

    def _along(
        self,
        rows: Any,
        axle: TwoWheelAxle,
        left: WheelRows,
        right: WheelRows,
        numbers: Array,
        roll: Any,
    ) -> dict[str, Array]:
        """Return derivatives of closed formulas of both wheels' rows, by differences along their exact derivatives."""
        slopes_by_name: dict[str, list[Array]] = {}
        for k, length in enumerate(self.lengths):
            step = _SHARE * length
            ends = []
            for sign in (1.0, -1.0):
                wheels = [
                    WheelRows(
                        {
                            name: value + sign * step * axle.slopes[side][name][k]
                            for name, value in wheel.rows.items()
                        },
                        wheel.radius + sign * step * self._radius_slope(side, k),
                    )
                    for side, wheel in ((1.0, left), (-1.0, right))
                ]
                ends.append(rows(*wheels, numbers + sign * step * self._every[:, k], roll))
            for name in ends[0]:
                slopes_by_name.setdefault(name, []).append(
                    (ends[0][name] - ends[1][name]) / (2.0 * step)
                )
        return {name: np.array(slopes) for name, slopes in slopes_by_name.items()}

    def _radius_slope(self, side: float, k: int) -> float:
        own = self._everywhere[0 if side > 0.0 else 1]
        model = self.model if side > 0.0 or self.right is None else kinematic_model(self.right)
        return float(own[len(model.tracks) + model.parameters.index("wheel.radius"), k])

    def _axle(self, numbers: Array, directions: tuple[Array, Array] | None = None) -> TwoWheelAxle:
        """Return the axle with these parameters of both sides."""
        own = numbers[: self._cut]
        return TwoWheelAxle(
            self.rig,
            (own, own if self.right is None else numbers[self._cut :]),
            directions,
            self.right,
        )

    @cached_property
    def _everywhere(self) -> tuple[Array, Array]:
        """Return the directions of both sides, padded for the track widths, which do not vary."""
        if self.right is None:
            return self._padded, self._padded
        return self._padded, self._with_tracks(self.right, self._every[self._cut :])

    @staticmethod
    def _with_tracks(rig: Corner, directions: Array) -> Array:
        return np.vstack(
            [np.zeros((len(kinematic_model(rig).tracks), directions.shape[1])), directions]
        )


class Evaluators:
    """Evaluates all targets of a study for the parameters of its rigs, with derivatives along ``directions``.

    ``parts`` has the slice of each target's values, ``paths`` the parameters from which they are computed.
    """

    def __init__(
        self,
        numbering: Numbering,
        wanted: Sequence[Wanted],
        directions: Array,
        lengths: Array,
        vehicles: Mapping[str, AxleLayout],
    ) -> None:
        self.numbering, self.wanted, self.paths, self.evaluations = (
            numbering,
            list(wanted),
            numbering.paths,
            0,
        )
        self._count = directions.shape[1]
        ends = np.cumsum([len(item.low) for item in wanted])
        self.parts = [
            slice(int(end) - len(item.low), int(end))
            for item, end in zip(wanted, ends, strict=True)
        ]
        self._members: list[tuple[NDArray[np.intp], NDArray[np.intp], Any]] = []
        for name, right, is_tested in dict.fromkeys(map(_group_of, wanted)):
            mine = [
                i for i, item in enumerate(wanted) if _group_of(item) == (name, right, is_tested)
            ]
            into = np.concatenate(
                [np.arange(self.parts[i].start, self.parts[i].stop) for i in mine]
            )
            rig, own = numbering.rigs[name], [wanted[i] for i in mine]
            if is_tested:
                part = _places(numbering.parts[name])
                rows = [item.sheet for item in own if item.sheet is not None]
                paths = [
                    numbering.owner(path, path)[1]
                    for path in numbering.paths[numbering.parts[name]]
                ]
                sheet = SheetEvaluator(rig, rows, paths, directions[part])
                self._members.append((part, into, sheet))
                continue
            sides = [name, right] if right else [name]
            part = np.concatenate([_places(numbering.kinematic[side]) for side in sides])
            other = numbering.rigs[right] if right else None
            assert isinstance(rig, Corner)
            assert other is None or isinstance(other, Corner)
            member = TargetEvaluator(rig, own, directions[part], lengths, vehicles.get(name), other)
            self._members.append((part, into, member))

    def together(self, numbers: Array, *, slopes: bool = True) -> tuple[Array, Array]:
        """Return all target values in one array, NaN out of reach, and slopes (all, directions) if requested."""
        self.evaluations += 1
        count = self.parts[-1].stop
        values, along = np.empty(count), np.zeros((count if slopes else 0, self._count))
        for part, into, member in self._members:
            values[into], moved = member.together(numbers[part], slopes=slopes)
            if slopes:
                along[into] = moved
        return values, along

    def at(self, numbers: Array, *, slopes: bool = True) -> tuple[list[Array], list[Array]]:
        """Return the values of each target (n,), NaN out of reach, and slopes (n, directions) if requested."""
        values, along = self.together(numbers, slopes=slopes)
        return [values[part] for part in self.parts], [along[part] for part in self.parts if slopes]

    def ends_in_words(self) -> list[str]:
        """Return a description of where the last poses ended."""
        return [end for *_, member in self._members for end in member.ends_in_words()]


def _group_of(item: Wanted) -> tuple[str, str, bool]:
    """Return rig, right corner, and whether the target is one of a K&C test."""
    return item.rig, item.right, item.sheet is not None


def _places(part: slice) -> NDArray[np.intp]:
    return np.arange(part.start, part.stop)


def _swept_values(item: Wanted, kind: str) -> Array:
    """Return the roll angles (rad) or rack travels (m) of an axle target."""
    return item.poses[:, 1 if kind == "steering" else 2]


def _fixed_value(item: Wanted, kind: str) -> float:
    return float(item.poses[0, 0 if kind == "steering" else 1])
