"""An axle of a corner and its mirror image: both wheels while the body rolls, and while the rack steers.

The right wheel is the mirror image of the left: its pose is that of the left wheel at the opposite rack travel.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from jounce.core.datasets import dataset
from jounce.core.errors import DescriptionError
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.kernel.poses import REACHED
from jounce.kinematics.across import ConnectedWheel, Connection, Ends, connect, reaches_over
from jounce.kinematics.catalogue import Quantity
from jounce.kinematics.column import handwheel_angle, pinion_angle, rack_travel
from jounce.kinematics.model import check_corner, check_rack, kinematic_model
from jounce.kinematics.sweeps import (
    AxleLayout,
    End,
    PreparedSweep,
    SweepVariables,
    Values,
    facts_of,
    no_pose,
    path_sweep,
    prepare_sweep,
    sweep_values,
)
from jounce.kinematics.tangents import Tangents
from jounce.mechanics.contact import towards_road
from jounce.parts import Corner, Rig

if TYPE_CHECKING:
    import xarray as xr


# both wheels ----------------------------------------------------------------------------------------------------------


_ITERATIONS, _LEVEL = 40, 1e-13  # m: rounding of a height
_STEEPEST = 1.2  # rad: 69 degrees, beyond the rollover of any car
_STRAIGHT = 1e-6  # rad: Ackermann shares of smaller steer angles are rounding
_ODD = {  # rows that change sign when mirrored in y
    "rack_travel",
    "inclination",
    "steer",
    "wheel_centre_y",
    "contact_point_y",
    "bump_steer",
    "instant_centre_y",
}
_INNER_MORE = "positive: inner wheel steers more"
_OUTER_MORE = (
    "positive: outer wheel steers more than Ackermann geometry asks, towards parallel steering"
)
_BEND = 1e-4  # rad: step of the only finite difference, of an exact derivative: truncation 1e-8, rounding 1e-12


@dataclass(frozen=True)
class WheelRows:
    """Catalogue of one wheel of the axle at the poses of a sweep, in the axes of a left wheel.

    ``rows`` has each quantity, shape (n,), NaN out of reach; ``radius`` is in m. ``ends`` has the ends of connections
    to the other wheel, if any.
    """

    rows: dict[str, Array]
    radius: float
    ends: Ends | None = None

    @property
    def centre(self) -> Array:
        """Wheel centre, m, shape (n, 3)."""
        return np.stack([self.rows[f"wheel_centre_{axis}"] for axis in "xyz"], axis=1)

    @property
    def centre_slope(self) -> Array:
        """Velocity of the wheel centre for a unit rate of travel, shape (n, 3)."""
        along = [self.rows[f"wheel_centre_{name}_slope"] for name in ("longitudinal", "lateral")]
        return np.stack([*along, np.ones_like(along[0])], axis=1)

    @property
    def axis(self) -> Array:
        """Wheel's axis, pointing outboard, shape (n, 3)."""
        camber, steer = self.rows["camber"], self.rows["steer"]
        level = np.cos(camber)
        return np.stack([-np.sin(steer) * level, np.cos(steer) * level, -np.sin(camber)], axis=1)

    @property
    def axis_slope(self) -> Array:
        """Derivative of the axis along travel, 1/m, shape (n, 3)."""
        camber, steer = self.rows["camber"], self.rows["steer"]
        gain, turn = self.rows["camber_gain"], self.rows["bump_steer"]
        x = -np.cos(steer) * np.cos(camber) * turn + np.sin(steer) * np.sin(camber) * gain
        y = -np.cos(steer) * np.sin(camber) * gain - np.sin(steer) * np.cos(camber) * turn
        return np.stack([x, y, -np.cos(camber) * gain], axis=1)

    @property
    def turn_slope(self) -> Array:
        """Rotation of the upright for a unit rate of travel, rad/m, shape (n, 3).

        The component perpendicular to the wheel's axis rotates that axis; the component along it follows from the
        motion of the contact patch.
        """
        axis, recession = self.axis, self.rows["contact_patch_recession"]
        across = np.cross(axis, self.axis_slope)
        contact = np.stack([self.rows[f"contact_point_{component}"] for component in "xyz"], axis=1)
        reach = contact - self.centre

        def lag(turn: Array) -> Array:
            """Return the difference between the patch motion due to a rotation and its recession."""
            velocity = np.cross(turn, reach)
            return np.asarray(velocity[:, 0] - recession * velocity[:, 2])

        still = self.centre_slope[:, 0] - recession
        along = -(still + lag(across)) / lag(axis)
        return np.asarray(across + along[:, None] * axis)

    def rows_seen_from(self, side: float) -> dict[str, Array]:
        """Rows in ground axes: ``side`` is 1 for the left wheel, -1 for the right one."""
        return {name: side * value if name in _ODD else value for name, value in self.rows.items()}


@dataclass(frozen=True)
class Ground:
    """A plane road under a wheel while the body rolls: its normal in the wheel's axes, and the normal's slope by roll.

    ``side`` is 1 for the left wheel, -1 for the right one; ``roll`` (rad) is positive about +x, after a ``pitch``
    about +y (nose down).
    """

    wheel: WheelRows
    roll: Array
    side: float
    pitch: Array | float = 0.0

    @property
    def normal(self) -> Array:
        """Unit vector out of the road, shape (n, 3)."""
        level, ahead = np.cos(self.pitch), np.zeros_like(self.roll) - np.sin(self.pitch)
        return np.stack(
            [ahead, self.side * np.sin(self.roll) * level, np.cos(self.roll) * level], axis=1
        )

    @property
    def normal_slope(self) -> Array:
        """Derivative of the normal with roll, shape (n, 3)."""
        level, zero = np.cos(self.pitch), np.zeros_like(self.roll)
        return np.stack(
            [zero, self.side * np.cos(self.roll) * level, -np.sin(self.roll) * level], axis=1
        )

    @property
    def toe_out(self) -> Array:
        """Angle along the road from the body's x axis to the wheel plane of a left wheel, rad."""
        ahead = np.cross(self.wheel.axis, self.normal)
        body = np.array([1.0, 0.0, 0.0]) - self.normal[:, :1] * self.normal
        sine = _dot(np.cross(body, ahead), self.normal)
        return np.arctan2(sine, _dot(body, ahead))

    @property
    def lean(self) -> Array:
        """Component of the wheel's axis along the normal; minus the sine of the camber to the ground."""
        return _dot(self.wheel.axis, self.normal)

    @property
    def contact(self) -> Array:
        """Contact point in body axes of a left wheel, m, shape (n, 3)."""
        down, _ = towards_road(self.wheel.axis.T, self.normal.T)
        return self.wheel.centre + self.wheel.radius * np.stack(down, axis=1)

    @property
    def jacking(self) -> Array:
        """Outward motion of the wheel's point at the contact point over its rise, of a left wheel, body axes [1]."""
        velocity = self.wheel.centre_slope + np.cross(
            self.wheel.turn_slope, self.contact - self.wheel.centre
        )
        return np.asarray(velocity[:, 1] / velocity[:, 2])

    @property
    def height(self) -> Array:
        """Height of the contact point along the normal, m."""
        return _dot(self.contact, self.normal)

    @property
    def height_by_travel(self) -> Array:
        """Derivative of that height along travel."""
        tilt = self.wheel.radius * self.lean / np.sqrt(1.0 - self.lean**2)
        return _dot(self.wheel.centre_slope, self.normal) + tilt * _dot(
            self.wheel.axis_slope, self.normal
        )

    @property
    def height_by_roll(self) -> Array:
        """Derivative of that height with roll, m/rad."""
        tilt = self.wheel.radius * self.lean / np.sqrt(1.0 - self.lean**2)
        return _dot(self.wheel.centre, self.normal_slope) + tilt * _dot(
            self.wheel.axis, self.normal_slope
        )


def _dot(a: Array, b: Array) -> Array:
    return np.asarray(np.einsum("ij,ij->i", a, b))


def _by_side(values: Array | tuple[Array, Array] | None) -> dict[float, Array]:
    """Return values by side: 1 left, -1 right."""
    both = values if isinstance(values, tuple) else (values, values)
    return {side: own for side, own in zip((1.0, -1.0), both, strict=True) if own is not None}


class TwoWheelAxle:
    """Both wheels of an axle, from the description of one of them, or of each if ``right`` is given.

    ``numbers`` replace the values of the model's ``parameters`` in the description. With ``directions`` (tracks and
    parameters, n; see ``tangents``) each wheel stores the derivatives of its rows along them in ``slopes``. With a
    right corner, ``numbers`` and ``directions`` are pairs.
    """

    def __init__(
        self,
        rig: Corner,
        numbers: Array | tuple[Array, Array] | None = None,
        directions: Array | tuple[Array, Array] | None = None,
        right: Corner | None = None,
    ) -> None:
        self.rig, self.right = rig, rig if right is None else right
        self.ends: list[End] = []
        self.slopes: dict[float, dict[str, Array]] = {}
        self._numbers, self._directions = _by_side(numbers), _by_side(directions)
        self._values = {side: self.of(side).parameters() for side in (1.0, -1.0)}
        for side, own in self._numbers.items():
            self._values[side] |= dict(
                zip(kinematic_model(self.of(side)).parameters, own.tolist(), strict=True)
            )
        self.radius = self.number("wheel.radius")

    def number(self, path: str) -> float:
        """A parameter of the (left) description, SI."""
        return float(self._values[1.0][path])

    def of(self, side: float) -> Corner:
        """Return the description of the corner on a side: 1 left, -1 right."""
        return self.rig if side > 0.0 else self.right

    def wheel(self, side: float, travel: Array | float, rack: Array | float) -> WheelRows:
        """Compute one wheel at pairs of travel and rack travel (m); either may be a single value."""
        rig = self.of(side)
        rack_of_wheel = side * rig.sign * np.asarray(rack, dtype=float)
        travel, numbers = np.asarray(travel, dtype=float), self._numbers.get(side)
        if travel.ndim and rack_of_wheel.ndim:
            finite = np.flatnonzero(np.isfinite(travel + rack_of_wheel))
            sweep = (
                path_sweep(rig, travel[finite], rack_of_wheel[finite], numbers)[0]
                if len(finite)
                else None
            )
            count = len(travel)
        else:
            swept, fixed = (
                (travel, rack_of_wheel) if rack_of_wheel.ndim == 0 else (rack_of_wheel, travel)
            )
            order = np.argsort(swept)
            finite, count = order[np.isfinite(swept[order])], len(swept)
            pair = (
                (swept[finite], float(fixed))
                if rack_of_wheel.ndim == 0
                else (float(fixed), swept[finite])
            )
            sweep = prepare_sweep(rig, *pair) if len(finite) else None
            if sweep is not None and numbers is not None:
                sweep.walk.p[:] = numbers
            if sweep is not None:
                sweep.run()
        if sweep is None:
            raise no_pose(self.ends)
        reached = sweep.found.outcome == REACHED
        values = np.full((len(sweep.model.rows), count), np.nan)
        values[:, finite] = sweep.in_place(sweep.found.outputs, reached).reshape(len(values), -1)
        self.note(sweep)
        names = [row.name for row in sweep.model.rows]
        if side in self._directions:
            self.slopes[side] = self._slopes_of(sweep, side, names, finite, count)
        rows = self._flip(dict(zip(names, values, strict=True)), rig)
        return WheelRows(
            rows,
            float(sweep.walk.p[sweep.model.parameters.index("wheel.radius")]),
            self._ends(sweep, side, finite, count),
        )

    def _ends(
        self, sweep: PreparedSweep, side: float, finite: NDArray[np.intp], count: int
    ) -> Ends | None:
        """Ends of the connections to the other wheel, at the poses of a sweep."""
        if "across" not in sweep.model.functions:
            return None
        reached = sweep.found.outcome == REACHED
        states = []
        for values_of in (sweep.found.poses, sweep.found.inputs):
            in_order = np.full((len(values_of), count), np.nan)
            in_order[:, finite] = sweep.in_place(values_of, reached).reshape(len(values_of), -1)
            states.append(in_order)
        return Ends.of(sweep.model, self.of(side), (states[0], states[1], sweep.walk.p), side)

    def connection(self, left: WheelRows, right: WheelRows) -> Connection:
        """Forces between both wheels at pairs of poses."""
        model = kinematic_model(self.rig)
        numbers = self._numbers.get(1.0, model.parameter_values(self.rig))
        left_wheel, right_wheel = (
            ConnectedWheel(wheel.rows, wheel.ends, self._values[side], side * self.of(side).sign)
            for side, wheel in ((1.0, left), (-1.0, right))
        )
        return connect(self.rig, model, numbers, left_wheel, right_wheel)

    def _slopes_of(
        self,
        sweep: PreparedSweep,
        side: float,
        names: list[str],
        finite: NDArray[np.intp],
        count: int,
    ) -> dict[str, Array]:
        """Slopes of the rows of a sweep, each (directions, poses), in the axes of a left wheel."""
        tangents = Tangents(sweep, self._directions[side]).run()
        ordered = sweep.in_place(
            tangents.reshape(-1, tangents.shape[2]), sweep.found.outcome == REACHED
        )
        slopes = np.full((*tangents.shape[:2], count), np.nan)
        slopes[:, :, finite] = ordered.reshape(*tangents.shape[:2], -1)
        return self._flip(dict(zip(names, slopes, strict=True)), self.of(side))

    def _flip(self, rows: dict[str, Array], rig: Corner) -> dict[str, Array]:
        return {name: rig.sign * value if name in _ODD else value for name, value in rows.items()}

    def note(self, sweep: PreparedSweep) -> None:
        """Store the ends of travel of the first sweep that has any."""
        if not self.ends and np.any(sweep.found.outcome != REACHED):
            self.ends = sweep.ends()

    def rows_of(self, side: float) -> tuple[Quantity, ...]:
        """Rows of the catalogue for a wheel."""
        return kinematic_model(self.of(side)).rows

    def level(self, roll: Array, rack: float) -> tuple[Ground, Ground]:
        """Move both wheels by the same travel in opposite directions until they touch one plane road."""
        away = np.abs(self.number("hardpoints.wheel_centre[1]")) * np.tan(roll)
        for _ in range(_ITERATIONS):
            left = Ground(self.wheel(1.0, -away, rack), roll, 1.0)
            right = Ground(self.wheel(-1.0, away, rack), roll, -1.0)
            off = left.height - right.height
            away = away + off / (left.height_by_travel + right.height_by_travel)
            if np.nanmax(np.abs(off), initial=0.0) < _LEVEL:
                break
        return left, right


# roll -----------------------------------------------------------------------------------------------------------------


def roll_of_corner(rig: Rig, angles: Array, rack: float) -> xr.Dataset:
    """Roll an axle of a corner and its mirror image (rad) at one rack travel (m); see ``sweep_roll``."""
    corner = check_corner(rig)
    axle = TwoWheelAxle(corner)
    variables = roll_axle(axle, angles, rack)
    reached = np.isfinite(variables.values["track"])
    if not reached.any():
        raise no_pose(axle.ends)
    return variables.dataset(reached, axle.ends, corner)


def roll_axle(axle: TwoWheelAxle, angles: Array, rack: float) -> AxleVariables:
    """Roll an axle (rad) at one rack travel (m)."""
    left, right = axle.level(angles, rack)
    bend = _bend(axle, angles, rack)
    variables = roll_rows(axle, left, right, bend)
    _add_roll_stiffness(variables, axle, angles, rack, (left, right), bend)
    return variables


def check_roll(angles: Array, name: str) -> None:
    """Raise an error for roll angles at which the wheels cannot touch a road."""
    if np.max(np.abs(angles)) > _STEEPEST:
        raise DescriptionError(
            "too steep", where=name, found=f"{np.max(np.abs(angles)):g} rad", allowed="1.2 rad"
        )


def roll_rows(axle: TwoWheelAxle, left: Ground, right: Ground, bend: Array) -> AxleVariables:
    """Return rows of a rolled axle; ``bend`` is the second derivative of the right wheel's travel by roll, m/rad^2."""
    gain = travel_by_roll(left, right)
    sign = "positive: about +x, left side up"
    variables = AxleVariables("roll_angle", left.roll, "rad", "roll angle of the body", sign)
    outward = "positive: top outward"
    for wheel, name, travel in ((left, "left", -gain), (right, "right", gain)):
        variables.add_wheel(axle, wheel.wheel, name, wheel.side)
        seen = wheel.wheel.rows_seen_from(wheel.side)
        variables.add(
            f"{name}.camber_to_ground",
            -np.arcsin(wheel.lean),
            "rad",
            "camber angle to the road",
            outward,
        )
        variables.add(
            f"{name}.roll_steer",
            travel * seen["bump_steer"],
            "1",
            "roll steer",
            "positive: about +z",
        )
        variables.add(
            f"{name}.roll_camber", travel * seen["camber_gain"], "1", "roll camber", outward
        )
        if "caster_gain" in seen:
            text, sign = "roll caster: caster angle over roll angle", "positive: top moves rearward"
            variables.add(f"{name}.roll_caster", travel * seen["caster_gain"], "1", text, sign)
    add_axle_rows(variables, left, right)
    _add_roll_moments(variables, axle, (left, right), bend)
    return variables


def travel_by_roll(left: Ground, right: Ground) -> Array:
    """Derivative of the right wheel's travel by roll, m/rad."""
    return (left.height_by_roll - right.height_by_roll) / (
        left.height_by_travel + right.height_by_travel
    )


def _bend(axle: TwoWheelAxle, roll: Array, rack: float) -> Array:
    """Second derivative of the right wheel's travel by roll, m/rad^2."""
    ahead, behind = (travel_by_roll(*axle.level(roll + step, rack)) for step in (_BEND, -_BEND))
    return (ahead - behind) / (2.0 * _BEND)


def add_axle_rows(variables: AxleVariables, left: Ground, right: Ground) -> None:
    """Add track and roll centre."""
    left_point, right_point = left.contact * [1.0, 1.0, 1.0], right.contact * [1.0, -1.0, 1.0]
    roll = left.roll
    at_left, at_right = _across(left_point, roll), _across(right_point, roll)
    variables.add(
        "track", at_left - at_right, "m", "track: distance of the contact points", "never negative"
    )
    left_slope, right_slope = left.jacking, right.jacking
    with np.errstate(divide="ignore", invalid="ignore"):
        apart = right_point - left_point
        along = (apart[:, 2] - apart[:, 1] * right_slope) / (left_slope + right_slope)
        centre = np.stack(
            [left_point[:, 0], left_point[:, 1] - along, left_point[:, 2] + along * left_slope],
            axis=1,
        )
        height = _dot(centre, left.normal) - left.height
        variables.add(
            "roll_centre_height", height, "m", "roll centre height above the road", "positive: up"
        )
        offset = _across(centre, roll) - 0.5 * (at_left + at_right)
        variables.add(
            "roll_centre_y",
            offset,
            "m",
            "roll centre, lateral distance from mid-track",
            "positive: left",
        )


_AGAINST = "positive: against the roll"


def _add_roll_moments(
    variables: AxleVariables, axle: TwoWheelAxle, wheels: tuple[Ground, Ground], bend: Array
) -> None:
    """Moments of springs and connections, and the roll stiffness of the springs."""
    left, right = (ground.wheel for ground in wheels)
    forces = "wheel_force" in left.rows and "wheel_force" in right.rows
    if not forces or (reaches_over(axle.rig) and left.ends is None):  # forces are unknown
        return
    gain = travel_by_roll(*wheels)
    force = right.rows["wheel_force"] - left.rows["wheel_force"]
    stiffness = right.rows["wheel_rate"] + left.rows["wheel_rate"]
    connection = axle.connection(left, right)
    moment = force * gain + (connection.forces[1] - connection.forces[0]) * gain
    variables.add(
        "roll_moment", moment, "N*m", "moment of springs and anti-roll bar on the body", _AGAINST
    )
    for name, (value, unit, text, sign) in connection.rows.items():
        variables.add(name, value, unit, text, sign)
    springs = stiffness * gain**2 + force * bend
    variables.add(
        "roll_stiffness_springs", springs, "N*m/rad", "roll stiffness of the springs", _AGAINST
    )


def _add_roll_stiffness(
    variables: AxleVariables,
    axle: TwoWheelAxle,
    roll: Array,
    rack: float,
    wheels: tuple[Ground, Ground],
    bend: Array,
) -> None:
    """Roll stiffness of the connections, of all springs, and with the tyres."""
    left, right = (ground.wheel for ground in wheels)
    if "roll_stiffness_springs" not in variables.values:
        return
    gain, description = travel_by_roll(*wheels), axle.rig.anti_roll_bar
    springs, bar = variables.values["roll_stiffness_springs"], np.zeros_like(roll)
    if description is not None and description.kind == "u" and axle.rig.third_spring is None:
        angle, ratio, change = (
            [wheel.rows[f"anti_roll_bar_{name}"] for wheel in (left, right)]
            for name in ("angle", "motion_ratio", "motion_ratio_gradient")
        )
        twist, speed = angle[1] - angle[0], (ratio[0] + ratio[1]) * gain
        geometric = twist * ((change[1] - change[0]) * gain**2 + (ratio[0] + ratio[1]) * bend)
        bar = left.rows["anti_roll_bar_stiffness"] * (speed**2 + geometric)
    elif description is not None or axle.rig.third_spring is not None:
        ahead, behind = (_connected_moment(axle, roll + step, rack) for step in (_BEND, -_BEND))
        bar = (ahead - behind) / (2.0 * _BEND)
    total = springs + bar
    text = "roll stiffness of anti-roll bar and third spring"
    variables.add("roll_stiffness_bar", bar, "N*m/rad", text, _AGAINST)
    variables.add(
        "roll_stiffness", total, "N*m/rad", "roll stiffness of springs and anti-roll bar", _AGAINST
    )
    if "tyre_stiffness" in left.rows:
        tyres = (
            0.25
            * (left.rows["tyre_stiffness"] + right.rows["tyre_stiffness"])
            * variables.values["track"] ** 2
        )
        text = "roll stiffness of springs and anti-roll bar in series with the tyres"
        variables.add(
            "roll_stiffness_total", total * tyres / (total + tyres), "N*m/rad", text, _AGAINST
        )


def _connected_moment(axle: TwoWheelAxle, roll: Array, rack: float) -> Array:
    """Moment of the connections against the roll, N m."""
    grounds = axle.level(roll, rack)
    connection = axle.connection(*(ground.wheel for ground in grounds))
    return np.asarray((connection.forces[1] - connection.forces[0]) * travel_by_roll(*grounds))


def _across(point: Array, roll: Array) -> Array:
    """Coordinate along the road, to the left, m."""
    return np.asarray(point[:, 1] * np.cos(roll) - point[:, 2] * np.sin(roll))


class AxleVariables(SweepVariables):
    """Variables of an axle over one coordinate."""

    def __init__(self, along: str, at: Array, unit: str, long_name: str, sign: str) -> None:
        super().__init__()
        self.along, self.at = along, at
        self.coordinate = {"units": unit, "long_name": long_name, "sign": sign}

    def add_wheel(self, axle: TwoWheelAxle, wheel: WheelRows, name: str, side: float) -> None:
        """Add the catalogue of one wheel in ground axes."""
        rows = wheel.rows_seen_from(side)
        for row in axle.rows_of(side):
            self.add(
                f"{name}.{row.name}", rows[row.name], row.unit, f"{name}: {row.long_name}", row.sign
            )

    def dataset(self, reached: NDArray[np.bool_], ends: Sequence[End], rig: Rig) -> xr.Dataset:
        """Dataset of the poses that both wheels reach."""
        import xarray as xr

        variables = {
            name: xr.Variable((self.along,), value[reached], self.attributes[name], fastpath=True)
            for name, value in self.values.items()
        }
        facts = facts_of(rig, "both", self.at[reached], ends if not reached.all() else [])
        along = xr.Variable((self.along,), self.at[reached], self.coordinate)
        return dataset(variables, xr.Dataset(coords={self.along: along}), facts)


# steering -------------------------------------------------------------------------------------------------------------


def sweep_steering(
    rig: Rig, rack: Values, travel: float | str = 0.0, *, vehicle: AxleLayout | None = None
) -> xr.Dataset:
    """Steer an axle of a corner and its mirror image by one rack.

    Parameters
    ----------
    rig : Rig
        A corner with a tie rod (or toe link); the other side is its mirror image.
    rack : float, str or array_like, shape (n,)
        Travel of the rack, m, positive to the left, monotonic; or text, ``"-20 mm:20 mm:5 mm"``.
    travel : float or str
        Vertical travel of both wheel centres from design, m, bump positive.
    vehicle : AxleLayout, optional
        Its wheelbase adds the rows of the turn; ``front_overhang`` and ``body_width`` add the diameter between walls.

    Returns
    -------
    xarray.Dataset
        On ``rack_travel`` (m): ``left.<quantity>`` and ``right.<quantity>`` of the catalogue; ``mean_steer`` (rad,
        about +z), ``steer_difference`` (rad, inner minus outer wheel), ``track`` (m, between the contact points). With
        a vehicle ``ackermann`` [1] = (inner - outer) / (inner - ideal outer steer angle): 1 where the normals through
        both contact points meet on the line of the rear axle, the wheelbase behind the static wheel centre, 0 for
        parallel wheels, NaN straight ahead; ``ideal_outer_steer`` and ``ackermann_error`` (rad, outer minus ideal);
        ``turning_radius`` (m, from the middle of the rear axle to the middle between the points where both normals
        meet its line, positive to the left); ``turn_diameter_kerbs`` and ``turn_diameter_walls`` (m).

    Raises
    ------
    DescriptionError
        If a rig has no hardpoints or rack, or values are not monotonic.
    SimulationError
        If no pose can be reached.

    Examples
    --------
    >>> import jounce as jn
    >>> car = jn.AxleLayout(axle="front", wheelbase="2.7 m", centre_of_mass_height="0.55 m", brake_share=0.6)
    >>> steered = jn.sweep_steering(jn.load("reference-double-wishbone"), [-0.02, 0.0, 0.02], vehicle=car)
    >>> bool(steered["mean_steer"][0] > 0.0)
    True
    """
    corner, racks = check_corner(rig), sweep_values(rack, "rack travel")
    check_rack(corner)
    axle = TwoWheelAxle(corner)
    lifted = to_si(travel, "m", where="wheel travel")
    left, right = (axle.wheel(side, lifted, racks) for side in (1.0, -1.0))
    reached = np.isfinite(left.rows["steer"] + right.rows["steer"])
    if not reached.any():
        raise no_pose(axle.ends)
    return steering_rows(axle, left, right, racks, vehicle).dataset(reached, axle.ends, corner)


def steering_rows(
    axle: TwoWheelAxle, left: WheelRows, right: WheelRows, racks: Array, vehicle: AxleLayout | None
) -> AxleVariables:
    """Rows of a steered axle at each rack travel (m)."""
    variables = AxleVariables(
        "rack_travel", racks, "m", "travel of the steering rack", "positive: to the left (+y)"
    )
    variables.add_wheel(axle, left, "left", 1.0)
    variables.add_wheel(axle, right, "right", -1.0)
    add_steering(variables, left, right, vehicle, axle)
    handwheel_rows(variables, axle, racks, left, right)
    return variables


def add_steering(
    variables: AxleVariables,
    left: WheelRows,
    right: WheelRows,
    vehicle: AxleLayout | None,
    axle: TwoWheelAxle,
) -> None:
    """Add steer angles of both wheels and, with a vehicle, the rows of the turn."""
    left_steer, right_steer = left.rows["steer"], -right.rows["steer"]
    mean = 0.5 * (left_steer + right_steer)
    difference = (
        left_steer - right_steer
    )  # in left turns both angles are positive, and the inner wheel is the left one
    track = left.rows["contact_point_y"] + right.rows["contact_point_y"]
    variables.add(
        "mean_steer",
        mean,
        "rad",
        "mean steer angle of both wheels",
        "positive: about +z, a left turn",
    )
    variables.add(
        "steer_difference",
        difference,
        "rad",
        "steer angle of the inner minus that of the outer wheel",
        "positive: toe-out",
    )
    if "track" not in variables.values:
        variables.add(
            "track", track, "m", "track: distance of the contact points", "never negative"
        )
    if vehicle is not None:
        _add_turn(variables, left, right, vehicle, axle)


def handwheel_rows(
    variables: AxleVariables, axle: TwoWheelAxle, racks: Array, left: WheelRows, right: WheelRows
) -> None:
    """Add handwheel, pinion and steering ratio, if the corner has a rack ratio."""
    steering = getattr(axle.rig, "steering", None)
    if steering is None or steering.rack_ratio is None:
        return
    at = handwheel_angle(steering, racks)
    rack_slope = rack_travel(steering, at)[1]
    angle = pinion_angle(steering, at)[0]
    to_left, mean = (
        "positive: to the left",
        0.5 * (left.rows["steer_gain"] + right.rows["steer_gain"]),
    )
    variables.add("handwheel_angle", at, "rad", "angle of the handwheel", to_left)
    variables.add("pinion_angle", angle, "rad", "angle of the pinion", to_left)
    text = "C-factor: travel of the rack over one turn of the handwheel, here"
    sign = "positive: a turn to the left moves the rack to the left"
    variables.add("c_factor", 2.0 * np.pi * rack_slope, "m", text, sign)
    text = "steering ratio: turn of the handwheel over the mean turn of the wheels"
    variables.add(
        "steering_ratio",
        1.0 / (rack_slope * mean),
        "1",
        text,
        "positive: the wheels follow the handwheel",
    )


def _add_turn(
    variables: AxleVariables,
    left: WheelRows,
    right: WheelRows,
    vehicle: AxleLayout,
    axle: TwoWheelAxle,
) -> None:
    """Ackermann and turning circle, from the normals through the contact points and the line of the rear axle.

    A right turn is mirrored: the inner wheel is always the left wheel of a left turn. Positions are measured from the
    middle of the rear axle, forward (m) and towards the inner side (m); angles are positive into the turn.
    """
    rear = axle.number("hardpoints.wheel_centre[0]") - vehicle.wheelbase
    to_left = variables.values["mean_steer"] > 0.0
    is_turn = np.abs(variables.values["mean_steer"]) > _STRAIGHT

    def part(name: str, inner: bool, sign: float = 1.0) -> Array:
        return sign * np.where(to_left == inner, left.rows[name], right.rows[name])

    inner_steer, outer_steer = part("steer", True), part("steer", False, -1.0)
    inner_ahead, outer_ahead = (part("contact_point_x", inner) - rear for inner in (True, False))
    with np.errstate(divide="ignore", invalid="ignore"):
        centres = (
            part("contact_point_y", True) + inner_ahead / np.tan(inner_steer),
            part("contact_point_y", False, -1.0) + outer_ahead / np.tan(outer_steer),
        )
        ideal = np.arctan2(outer_ahead, centres[0] - part("contact_point_y", False, -1.0))
        share = np.where(is_turn, (inner_steer - outer_steer) / (inner_steer - ideal), np.nan)
        middle = np.where(is_turn, 0.5 * (centres[0] + centres[1]), np.inf)
        kerb = 2.0 * np.hypot(middle - part("contact_point_y", False, -1.0), outer_ahead)
    ideal, error = (np.where(is_turn, value, np.nan) for value in (ideal, outer_steer - ideal))
    to_it = "positive: into the turn"
    variables.add(
        "ackermann", share, "1", "steer difference over that of Ackermann geometry", _INNER_MORE
    )
    variables.add(
        "ideal_outer_steer",
        ideal,
        "rad",
        "steer angle of the outer wheel by Ackermann geometry",
        to_it,
    )
    variables.add(
        "ackermann_error",
        error,
        "rad",
        "steer angle of the outer wheel minus the ideal one",
        _OUTER_MORE,
    )
    variables.add(
        "turning_radius",
        np.where(to_left, middle, -middle),
        "m",
        "turning centre from the middle of the rear axle",
        "positive: left",
    )
    width = 0.0 if axle.rig.wheel.width is None else float(axle.rig.wheel.width)
    text = "turn diameter between kerbs, of the outer wheel's contact point" + (
        " and half its width" if width else ""
    )
    variables.add("turn_diameter_kerbs", kerb + width, "m", text, "never negative")
    if vehicle.front_overhang is not None and vehicle.body_width is not None:
        front = vehicle.wheelbase + vehicle.front_overhang
        walls = 2.0 * np.hypot(middle + 0.5 * vehicle.body_width, front)
        variables.add(
            "turn_diameter_walls",
            walls,
            "m",
            "turn diameter between walls, of the body's corner",
            "never negative",
        )
