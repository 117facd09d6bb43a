"""Clearances: distances of links, points and the rim over travel and rack; lengths of links."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import TYPE_CHECKING, Self, TypeAlias

import numpy as np
from pydantic import model_validator

from jounce.core.description import Description
from jounce.core.errors import DescriptionError, unknown
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.core.units import Length, NonNegativeLength, PositiveLength
from jounce.kernel.poses import REACHED
from jounce.kinematics.model import check_corner
from jounce.kinematics.sweeps import (
    PreparedSweep,
    Values,
    ends_text,
    no_pose,
    path_sweep,
    prepare_sweep,
)
from jounce.kinematics.tangents import Tangents
from jounce.parts import Corner, Rig
from jounce.parts.bodies import Point, distance

if TYPE_CHECKING:
    import xarray as xr


class Solid(Description):
    """A sphere at one hardpoint, or a round bar along several, of this ``radius`` (m); it moves with its hardpoints.

    With positions ``places`` (m, ground axes) instead of ``points`` it is fixed to the body: a frame tube, an engine,
    or a keep-out zone.

    Examples
    --------
    >>> Solid(points=["tie_rod_inner", "tie_rod_outer"], radius="8 mm").radius
    0.008
    """

    points: tuple[str, ...] = ()
    places: tuple[Point, ...] = ()
    radius: NonNegativeLength = 0.0

    @model_validator(mode="after")
    def _has_points(self) -> Self:
        if bool(self.points) == bool(self.places):
            raise ValueError(
                "give points (one hardpoint, or several along a bar), or positions (places) on the body"
            )
        return self


class Rim(Description):
    """The inside of a rim: a cylinder of this ``radius`` (m) about the wheel's axis, between two offsets (m).

    Offsets are measured from the wheel centre along its axis, outboard positive.

    Examples
    --------
    >>> Rim(radius="115 mm", inner="-90 mm", outer="20 mm").inner
    -0.09
    """

    radius: PositiveLength
    inner: Length
    outer: Length

    @model_validator(mode="after")
    def _has_width(self) -> Self:
        if self.inner >= self.outer:
            raise ValueError(
                Phrase(
                    "inner = {inner:g} m is not inboard of outer = {outer:g} m",
                    inner=self.inner,
                    outer=self.outer,
                )
            )
        return self


Shape: TypeAlias = Solid | Rim
_SAMPLES, _ROUNDS = (
    33,
    7,
)  # each round narrows 16 times, to 1e-9 of a length: slopes need the exact position
_ANGLES = ("camber", "steer")
_POINT = 1e-12  # m: a shorter bar is a sphere


def clearances(
    rig: Rig, pairs: Mapping[str, Sequence[Shape]], travel: Values = 0.0, rack: Values | None = None
) -> xr.Dataset:
    """Compute distances between bodies of a corner over travel and rack.

    Parameters
    ----------
    rig : Rig
        A corner with hardpoints.
    pairs : mapping of str to sequence of Solid or Rim, shape (2,)
        Two bodies by the name of their clearance; at most one of them is a rim.
    travel : float, str or array_like, shape (n,)
        Vertical travel of the wheel centre from design, m, bump positive, monotonic.
    rack : float, str or array_like, shape (m,), optional
        Travel of the rack, m, positive to the left; the description's own by default.

    Returns
    -------
    xarray.Dataset
        On ``wheel_travel`` and ``rack_travel`` (m): shortest distance of the surfaces of each pair, m, negative if
        they overlap (by their radii); NaN out of reach.

    Raises
    ------
    DescriptionError
        If a rig has no hardpoints or not the named one, a pair has two rims, or values are not monotonic.
    SimulationError
        If no pose can be reached.

    Examples
    --------
    >>> import jounce as jn
    >>> rods = {"pushrod": ("pushrod_outer", "pushrod_inner"), "arm": ("upper_arm_front", "upper_ball_joint")}
    >>> bars = [jn.Solid(points=points, radius="8 mm") for points in rods.values()]
    >>> gaps = jn.clearances(jn.load("formula-student-front"), {"push rod to arm": tuple(bars)}, "-20 mm:20 mm:10 mm")
    >>> gaps["push rod to arm"].dims
    ('wheel_travel', 'rack_travel')
    """
    import xarray as xr

    corner = check_corner(rig)
    if not pairs:
        raise DescriptionError("nothing to measure", where="pairs", allowed="a name and two bodies")
    for name, pair in pairs.items():
        check_pair(corner, pair, f"pairs: {name}")
    sweep = prepare_sweep(corner, travel, rack)
    rows = sweep.quantities()
    if not np.isfinite(rows["wheel_travel"]).any():
        raise no_pose(sweep.ends())
    places = _places(sweep, sweep.model.point_names)
    posed = PosedCorner(places, _axis(corner, rows))
    variables = {}
    for name, (first, second) in pairs.items():
        gaps = posed.distance(first, second)[0]
        attributes = {"units": "m", "long_name": f"clearance: {name}", "sign": "positive: apart"}
        variables[name] = (
            ("wheel_travel", "rack_travel"),
            gaps.reshape(sweep.layout.shape),
            attributes,
        )
    at = [np.unique(sweep.layout.targets[:, i]) for i in (0, 1)]
    ends = sweep.ends() if not np.isfinite(rows["wheel_travel"]).all() else []
    facts = {"model": str(getattr(rig, "model", "")), "stopped": ends_text(ends)}
    coordinates = {
        name: ((name,), values, {"units": "m", "long_name": name.replace("_", " ")})
        for name, values in zip(("wheel_travel", "rack_travel"), at, strict=True)
    }
    return xr.Dataset(variables, coordinates, facts)


def check_pair(rig: Corner, pair: Sequence[Shape], where: str) -> None:
    """Raise an error unless the argument is a pair of bodies of this corner."""
    given = rig.hardpoints.given()
    if len(pair) != 2 or all(isinstance(shape, Rim) for shape in pair):
        raise DescriptionError(
            "invalid pair of bodies", where=where, allowed="two bars, or a bar and a rim"
        )
    for shape in pair:
        for point in shape.points if isinstance(shape, Solid) else ():
            if point not in given:
                raise unknown(point, given, what="hardpoint", where=where)


@dataclass(frozen=True)
class PosedCorner:
    """Positions of points (poses, 3) and the wheel's axis at pairs of travel and rack; NaN out of reach, m.

    ``moved`` has the derivatives of each position and ``turned`` those of the axis along directions, (directions,
    poses, 3), if they were computed.
    """

    places: dict[str, Array]
    axis: Array
    moved: dict[str, Array] = field(default_factory=dict)
    turned: Array | None = None

    @classmethod
    def along(
        cls,
        rig: Corner,
        names: Collection[str],
        poses: tuple[Array, Array],
        numbers: Array,
        directions: Array | None = None,
    ) -> PosedCorner:
        """Compute poses of a corner at pairs of travel and rack, for given parameters of its model.

        ``names`` are the required hardpoints; ``directions`` (tracks and parameters, n) are the directions of
        derivatives (see ``tangents``).
        """
        sweep, values = path_sweep(rig, *poses, numbers)
        rows = {
            row.name: value
            for row, value in zip(sweep.model.rows, values, strict=True)
            if row.name in _ANGLES
        }
        required = {"wheel_centre", *names}
        places, axis = _places(sweep, required), _axis(rig, rows)
        if directions is None:
            return cls(places, axis)
        slopes = Tangents(sweep, directions, places=True).run()
        reached = sweep.found.outcome == REACHED
        ordered = sweep.in_place(slopes.reshape(-1, slopes.shape[2]), reached).reshape(slopes.shape)
        at = {name: 3 * i for i, name in enumerate(sweep.model.point_names)}
        positions = {
            name: np.moveaxis(ordered[at[name] : at[name] + 3], 0, -1) for name in required
        }
        return cls(places, axis, positions, _axis_slope(rig, rows, ordered[-2], ordered[-1]))

    def distance(self, first: Shape, second: Shape) -> tuple[Array, Array | None]:
        """Return the shortest distance of two bodies at each pose, m, and its slopes (directions, poses) if requested.

        If two positions are equally close, the slope is that of one of them.
        """
        if isinstance(second, Rim):
            first, second = second, first
        assert isinstance(second, Solid)
        if isinstance(first, Rim):
            gaps = [self._to_rim(first, bar) for bar in self._bars(second)]
            radii = second.radius
        else:
            gaps = [
                self._between(bar, rod) for bar in self._bars(first) for rod in self._bars(second)
            ]
            radii = first.radius + second.radius
        distances = np.array([distance for distance, _ in gaps])
        nearest = np.argmin(np.nan_to_num(distances, nan=np.inf), axis=0)
        poses = np.arange(distances.shape[1])
        if self.turned is None:
            return np.asarray(distances[nearest, poses] - radii), None
        slopes = np.array([slope() for _, slope in gaps])
        return np.asarray(distances[nearest, poses] - radii), np.asarray(
            slopes[nearest, :, poses].T
        )

    def _bars(self, solid: Solid) -> list[_Bar]:
        """Return the straight segments of a bar; a single segment of zero length for a sphere."""
        if solid.places:
            like = next(iter(self.places.values()))
            ends = [
                (np.broadcast_to(np.array(place), like.shape), np.zeros((1, 1, 3)))
                for place in solid.places
            ]
        else:
            ends = [
                (self.places[name], self.moved.get(name, np.zeros((1, 1, 3))))
                for name in solid.points
            ]
        return [
            _Bar(a, b, u, v) for (a, u), (b, v) in pairwise(ends if len(ends) > 1 else ends * 2)
        ]

    def _between(self, first: _Bar, second: _Bar) -> _Gap:
        """Return the distance of two segments: along the common normal, or at ends."""
        s, t = _feet(first, second)
        gap = first.at(s) - second.at(t)
        distance = np.linalg.norm(gap, axis=1)
        return distance, lambda: _over(
            np.einsum("ni,kni->kn", gap, first.slopes_at(s) - second.slopes_at(t)), distance
        )

    def _to_rim(self, rim: Rim, bar: _Bar) -> _Gap:
        """Return the distance of a segment from the rim's cylinder."""
        centre, axis = self.places["wheel_centre"], self.axis
        share = _nearest_to_rim(rim, bar, centre, axis)
        place = bar.at(share) - centre
        along = np.einsum("ni,ni->n", place, axis)
        radius = np.linalg.norm(place - along[:, None] * axis, axis=1)
        beyond = np.minimum(along - rim.inner, 0.0) + np.maximum(along - rim.outer, 0.0)
        distance = np.hypot(radius - rim.radius, beyond)

        def slope() -> Array:
            assert self.turned is not None
            offset = bar.slopes_at(share) - self.moved["wheel_centre"]
            along_slope = np.einsum("ni,kni->kn", axis, offset) + np.einsum(
                "ni,kni->kn", place, self.turned
            )
            radius_slope = _over(
                np.einsum("ni,kni->kn", place, offset) - along * along_slope, radius
            )
            return _over((radius - rim.radius) * radius_slope + beyond * along_slope, distance)

        return distance, slope


_Gap: TypeAlias = "tuple[Array, Callable[[], Array]]"
"""Distance of two segments at each pose, m, and a function that returns its slopes (directions, poses)."""


@dataclass(frozen=True)
class _Bar:
    """A straight segment from ``a`` to ``b`` (poses, 3), and the slopes of its ends (directions, poses, 3)."""

    a: Array
    b: Array
    a_moved: Array
    b_moved: Array

    def at(self, share: Array) -> Array:
        """Return positions at shares (poses,) of its length."""
        return np.asarray(self.a + share[:, None] * (self.b - self.a))

    def slopes_at(self, share: Array) -> Array:
        """Return the slopes of these positions."""
        return np.asarray(self.a_moved + share[:, None] * (self.b_moved - self.a_moved))


def _over(values: Array, size: Array) -> Array:
    """Values (directions, poses) over a size (poses,); zero for zero size."""
    return np.asarray(np.divide(values, size, out=np.zeros_like(values), where=size != 0.0))


def link_lengths(rig: Rig) -> dict[str, float]:
    """Return the lengths of the links of a corner at design.

    Parameters
    ----------
    rig : Rig
        A corner with hardpoints.

    Returns
    -------
    dict of str to float
        Distance in m by the hardpoints of both ends, such as ``"tie_rod_inner - tie_rod_outer"``: legs of arms and
        rods, push rod, strut, link of the anti-roll bar. A sweep keeps all of them constant except the strut's.

    Raises
    ------
    DescriptionError
        If a rig has no hardpoints.

    Examples
    --------
    >>> import jounce as jn
    >>> lengths = jn.link_lengths(jn.load("formula-student-front"))
    >>> round(1e3 * lengths["tie_rod_inner - tie_rod_outer"], 1)   # mm
    331.5
    """
    corner = check_corner(rig)
    points = corner.hardpoints.given()
    ends = [(inner, outer) for outer, inner in corner.hardpoints.rods]
    ends += [
        ("pushrod_inner", "pushrod_outer"),
        ("strut_bottom", "strut_top"),
        ("arb_arm_end", "arb_link_end"),
    ]
    return {
        f"{a} - {b}": distance(points[a], points[b]) for a, b in ends if a in points and b in points
    }


def _places(sweep: PreparedSweep, names: Collection[str]) -> dict[str, Array]:
    """Return positions of points, shape (poses, 3), m."""
    coordinates = sweep.points()
    return {
        name: np.stack([coordinates[f"{name}.{axis}"].ravel() for axis in "xyz"], axis=1)
        for name in names
    }


def _axis(rig: Corner, rows: dict[str, Array]) -> Array:
    """Axis of the wheel, outboard, ground axes, shape (poses, 3)."""
    camber, steer = rows["camber"].ravel(), rows["steer"].ravel()
    side = rig.sign
    level = np.cos(camber)
    return np.stack(
        [-side * np.sin(steer) * level, side * np.cos(steer) * level, -np.sin(camber)], axis=1
    )


def _axis_slope(
    rig: Corner, rows: dict[str, Array], camber_slope: Array, steer_slope: Array
) -> Array:
    """Slope of the axis along directions, (directions, poses, 3)."""
    camber, steer = rows["camber"].ravel(), rows["steer"].ravel()
    side = rig.sign
    x = side * (
        np.sin(steer) * np.sin(camber) * camber_slope - np.cos(steer) * np.cos(camber) * steer_slope
    )
    y = -side * (
        np.cos(steer) * np.sin(camber) * camber_slope + np.sin(steer) * np.cos(camber) * steer_slope
    )
    return np.stack([x, y, -np.cos(camber) * camber_slope], axis=-1)


def _feet(first: _Bar, second: _Bar) -> tuple[Array, Array]:
    """Find the closest points of two segments, as shares of their lengths."""
    u, v, w = first.b - first.a, second.b - second.a, first.a - second.a
    uu, uv, vv, uw, vw = (
        np.sum(x * y, axis=1) for x, y in ((u, u), (u, v), (v, v), (u, w), (v, w))
    )
    skew = uu * vv - uv**2
    with np.errstate(divide="ignore", invalid="ignore"):
        s = np.where(skew > _POINT * uu * vv, (uv * vw - vv * uw) / skew, 0.0)
        s = np.clip(np.nan_to_num(s), 0.0, 1.0)
        t = np.where(vv > _POINT**2, (uv * s + vw) / vv, 0.0)
        t = np.clip(t, 0.0, 1.0)
        s = np.where(uu > _POINT**2, (uv * t - uw) / uu, 0.0)
        s = np.clip(s, 0.0, 1.0)
    return s, t


def _nearest_to_rim(rim: Rim, bar: _Bar, centre: Array, axis: Array) -> Array:
    """Find the point of a segment closest to the rim's cylinder, as a share of its length, by refined grids."""
    share = np.linspace(0.0, 1.0, _SAMPLES)[None, :] * np.ones((len(bar.a), 1))
    step = 1.0 / (_SAMPLES - 1)
    for _ in range(_ROUNDS):
        places = (
            bar.a[:, None, :] + share[:, :, None] * (bar.b - bar.a)[:, None, :] - centre[:, None, :]
        )
        along = np.einsum("nki,ni->nk", places, axis)
        out = np.sqrt(np.maximum(np.sum(places**2, axis=2) - along**2, 0.0)) - rim.radius
        past = np.maximum(np.maximum(rim.inner - along, along - rim.outer), 0.0)
        away = np.nan_to_num(np.hypot(out, past), nan=np.inf)
        best = np.take_along_axis(share, np.argmin(away, axis=1)[:, None], axis=1)
        share = np.clip(best + np.linspace(-step, step, _SAMPLES)[None, :], 0.0, 1.0)
        step *= 2.0 / (_SAMPLES - 1)
    return np.asarray(best[:, 0])
