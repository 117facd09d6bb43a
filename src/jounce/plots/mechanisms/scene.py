"""Scene of a 3-D rig: its parts, its poses in a sweep or a run, the road under its wheel."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from jounce.core.display import DisplayUnit, display_unit
from jounce.core.errors import DescriptionError, RecordingError
from jounce.core.phrases import Phrase
from jounce.core.remembered import Recent
from jounce.core.types import Array
from jounce.mechanics.contact import towards_road
from jounce.plots.display import number
from jounce.plots.figures import INK, PALETTE
from jounce.plots.signals import sample_segments

if TYPE_CHECKING:
    import xarray as xr

    from jounce.parts.corners import Corner
    from jounce.roads import Trial


COLOURS = {
    "lower_arm": PALETTE[0],
    "upper_arm": PALETTE[2],
    "arm": PALETTE[0],
    "link_1": PALETTE[0],
    "link_2": PALETTE[5],
    "link_3": PALETTE[2],
    "link_4": "#7a9a1e",
    "link_5": PALETTE[1],
    "tie_rod": PALETTE[1],
    "upright": INK,
    "strut": PALETTE[3],
    "pushrod": PALETTE[4],
    "rocker": "#7b5ea7",
    "anti_roll_bar": "#8c6d5a",
    "torsion_bar": "#b5472a",
    "third_spring": PALETTE[5],
}
"""Colour of each part, the same in all figures."""
_STEERING_AXES = {
    "double-wishbone": ("lower_ball_joint", "upper_ball_joint"),
    "mcpherson": ("lower_ball_joint", "strut_top"),
}
_WORDS = {
    "double-wishbone": "double wishbone",
    "mcpherson": "McPherson strut",
    "five-link": "five-link suspension",
    "trailing-arm": "trailing arm",
    "anti_roll_bar": "anti-roll bar",
    "pushrod": "push rod",
}
BAR = ("arb_pivot", "arb_arm_end", "arb_link_end")
MIDDLE = {"arb_pivot": "arb_middle", "third_spring_end": "third_spring_middle"}
"""Points of parts that extend to the other wheel, and their projections on the centre plane (not hardpoints)."""
USUAL_WIDTH = 0.6  # relative to the radius


@dataclass(frozen=True)
class Part:
    """A part as a line along hardpoints, or as a plate with corners at three or more of them."""

    name: str
    points: tuple[str, ...]
    colour: str  # as #rrggbb

    @property
    def words(self) -> str:
        """Name in words."""
        return _WORDS.get(self.name) or self.name.replace("_", " ")

    @property
    def plate(self) -> bool:
        """Whether it is drawn as a surface."""
        return len(self.points) > 2 and self.name != "anti_roll_bar"

    @property
    def coil(self) -> bool:
        """Whether it is drawn as a coil between two points."""
        return self.name == "third_spring"


@dataclass(frozen=True)
class Bracket:
    """A thin line from a hardpoint to the nearest point on the part that carries it."""

    point: str
    first: str
    second: str
    share: float  # position of the nearest point, from 0 at the first hardpoint to 1 at the second
    colour: str


@dataclass(frozen=True)
class Scene:
    """Parts of a drawing that are the same in every pose; lengths in m."""

    title: str
    side: float  # 1 on the left, -1 on the right
    parts: tuple[Part, ...]  # links, arms, upright in the order of drawing; not the strut
    brackets: tuple[Bracket, ...]
    on_body: frozenset[str]  # hardpoints on the car's body
    spring: tuple[str, str] | None  # hardpoints at its bottom and top; None without a strut
    damper: tuple[str, str] | None
    steering_axis: (
        tuple[str, str] | None
    )  # lower and upper hardpoint; None if no two points define the axis
    radius: float  # of the wheel at design
    undeformed_radius: float
    width: float
    design: Pose
    feet: frozenset[str] = frozenset(MIDDLE.values())
    """Points that parts are drawn to and that are no hardpoints."""

    @property
    def damper_length(self) -> float:
        """Design length of the damper in m."""
        return self._length(self.damper)

    @property
    def coil_radius(self) -> float:
        """Radius in m of drawn springs, including a third spring, even without a strut."""
        widest = 0.3 * self.radius
        return widest if self.spring is None else min(0.1 * self._length(self.spring), widest)

    def _length(self, ends: tuple[str, str] | None) -> float:
        return (
            0.0
            if ends is None
            else float(np.linalg.norm(np.subtract(*(self.design.points[name] for name in ends))))
        )

    @property
    def strut_colour(self) -> str:
        """Colour of spring and damper."""
        return COLOURS["strut"]


@dataclass(frozen=True)
class Pose:
    """One pose: positions of shape (3,), m."""

    points: Mapping[str, Array]
    spin_axis: Array  # unit vector along the wheel's axis, outboard
    contact: Array  # contact point with the road, or in flight its projection
    ground: float  # height of the road there
    touches: bool = True  # whether the tyre carries load
    label: str = ""  # e.g. "wheel travel 20 mm"


def require_corner(rig: object) -> Corner:
    """Return a rig that has hardpoints; refuse all others."""
    from jounce.parts.corners import Corner

    if not isinstance(rig, Corner):
        raise DescriptionError(
            "only a 3-D rig of one corner can be drawn as a mechanism",
            found=getattr(rig, "model", type(rig).__name__),
            allowed="double-wishbone, mcpherson, five-link, trailing-arm",
            hint="A solid axle or twist beam is drawn on its K&C sheet: `jounce kc`.",
        )
    return rig


def scene_of(rig: Corner) -> Scene:
    """Make the scene of a 3-D rig; its equations determine which points are fixed to the body."""
    require_corner(rig)
    from jounce.parts.leverage import AXES

    lines, owners, holders = _trace_linkage(rig)
    names = rig.hardpoints.given()
    stem = rig.anti_roll_bar is not None and rig.anti_roll_bar.kind == "t"
    if "arb_pivot" in names:
        along = "arb_axis" if "arb_axis" in names else MIDDLE["arb_pivot"]
        lines.setdefault("anti_roll_bar", (BAR[0], along, *BAR[1:]) if stem else (along, *BAR))
    if rig.torsion_bar is not None:
        lines["torsion_bar"] = AXES[rig.torsion_bar.on][:2]
    if rig.third_spring is not None:
        lines["third_spring"] = ("third_spring_end", MIDDLE["third_spring_end"])
    parts = tuple(
        Part(name, points, COLOURS.get(name, PALETTE[4])) for name, points in lines.items()
    )
    on_body = {name for name, owner in owners.items() if owner in holders} | (
        {"arb_pivot", "" if stem else "arb_axis"} & set(names)
    )
    design = _design(rig)
    model = str(getattr(rig, "model"))  # noqa: B009 - every subclass has it
    return Scene(
        f"{_WORDS.get(model, model)}, {rig.side} side",
        rig.sign,
        parts,
        _brackets(parts, owners, names),
        frozenset(on_body | ({MIDDLE["arb_pivot"]} & design.points.keys())),
        ends_of(names, "spring") if rig.has_strut else None,
        ends_of(names, "damper") if rig.has_strut else None,
        _STEERING_AXES.get(model),
        rig.wheel.radius,
        rig.undeformed_radius,
        rig.wheel.width or USUAL_WIDTH * rig.wheel.radius,
        design,
    )


_Carried: TypeAlias = tuple[dict[str, tuple[str, ...]], dict[str, str], set[str]]
_known: Recent[_Carried] = Recent()


def _trace_linkage(rig: Corner) -> _Carried:
    """Return lines to draw, the body of each hardpoint, and the bodies fixed to the car; cached per structure."""
    from jounce.mechanics import Mechanism
    from jounce.models.corner import suspension
    from jounce.parts.rig import structure_of

    def make() -> _Carried:
        linkage = suspension(rig, Mechanism())
        lines = {name: points for name, points in linkage.lines.items() if name != "strut"}
        owners = {name: owner.name for name, owner in linkage.owners.items()}
        return lines, owners, {linkage.chassis.name, linkage.rack.name}

    lines, owners, holders = _known.of(structure_of(rig), make)
    return dict(lines), owners, holders


def _brackets(
    parts: tuple[Part, ...],
    owners: Mapping[str, str],
    names: Mapping[str, tuple[float, float, float]],
) -> tuple[Bracket, ...]:
    """Connect each point that is not on the line of its part; the rocker's axis is shown in the same way."""
    by_name = {part.name: part for part in parts}
    brackets = []
    for name, owner in owners.items():
        part = by_name.get(owner)
        if part is None or name in part.points:
            continue
        edges = list(pairwise(part.points)) + (
            [(part.points[-1], part.points[0])] if part.plate else []
        )
        brackets.append(
            min(
                (_bracket_to(names, name, *edge, part.colour) for edge in edges),
                key=lambda choice: choice[0],
            )[1]
        )
    if "rocker_axis" in names:
        brackets.append(
            Bracket("rocker_axis", "rocker_pivot", "rocker_pivot", 0.0, COLOURS["rocker"])
        )
    return tuple(brackets)


def _bracket_to(
    names: Mapping[str, tuple[float, float, float]], name: str, first: str, second: str, colour: str
) -> tuple[float, Bracket]:
    """Return the distance in m of a point from the line through two others, and the bracket to it."""
    point, start, end = (np.array(names[key]) for key in (name, first, second))
    along = end - start
    square = float(along @ along)
    share = float(np.clip((point - start) @ along / square, 0.0, 1.0)) if square > 0.0 else 0.0
    return float(np.linalg.norm(start + share * along - point)), Bracket(
        name, first, second, share, colour
    )


def ends_of(names: Mapping[str, Any], element: str) -> tuple[str, str]:
    """Return the hardpoints at the lower and upper end of spring or damper."""
    bottom, top = (
        own if (own := f"{element}_{end}") in names else f"strut_{end}" for end in ("bottom", "top")
    )
    return bottom, top


def _design(rig: Corner) -> Pose:
    points = with_middle({name: np.array(place) for name, place in rig.hardpoints.given().items()})
    axis = spin_axes(np.array(rig.wheel.camber), np.array(-rig.sign * rig.wheel.toe), rig.sign)
    contact = contact_points(points["wheel_centre"], axis, rig.wheel.radius)
    return Pose(points, axis, contact, float(contact[2]), label="design position")


def with_middle(points: dict[str, Array]) -> dict[str, Array]:
    """Add the points on the centre plane of parts that extend to the other wheel."""
    flat = np.array([1.0, 0.0, 1.0])
    known = points.keys() - (
        {"arb_pivot"} if "arb_axis" in points else set()
    )  # whose axis is drawn to that point
    return points | {foot: points[name] * flat for name, foot in MIDDLE.items() if name in known}


def spin_axes(camber: Array, steer: Array, side: float) -> Array:
    """Return outboard unit vectors of wheel axes, shape (..., 3), from camber and steer (rad) and side (1 left)."""
    level = np.cos(camber)
    return np.stack(
        [-side * np.sin(steer) * level, side * np.cos(steer) * level, -np.sin(camber)], axis=-1
    )


def contact_points(centre: Array, axis: Array, radius: float) -> Array:
    """Return contact points of wheels, shape (..., 3), m, from centres and axes of that shape and a radius in m."""
    down, _ = towards_road(np.moveaxis(axis, -1, 0), (0.0, 0.0, 1.0))
    return np.asarray(centre + radius * np.stack(down, axis=-1))


@dataclass(frozen=True)
class Poses:
    """Poses over travel or time: positions of shape (n, 3), m, and values of shape (n,), SI."""

    points: Mapping[str, Array]
    spin_axis: Array
    contact: Array
    ground: Array
    touches: NDArray[np.bool_]
    over: Array  # coordinate of the poses
    words: str  # name of that coordinate
    unit: str  # its SI unit
    in_time: bool  # a run over time rather than a sweep
    signals: Mapping[str, Array] = field(default_factory=dict)  # other values of each pose
    signal_units: Mapping[str, str] = field(default_factory=dict)
    signal_words: Mapping[str, str] = field(default_factory=dict)

    def __len__(self) -> int:
        return len(self.over)

    @property
    def display(self) -> DisplayUnit:
        """Unit in which ``over`` is shown."""
        return DisplayUnit("s", 1.0) if self.in_time else display_unit(self.unit)

    def label(self, k: int) -> str:
        """Label of pose ``k``, e.g. ``"wheel travel 20 mm"``."""
        value = self.over[k] * self.display.factor
        text = f"{value:.3f}" if self.in_time else f"{round(value, 2):+g}".replace("+0", "0")
        return f"{self.words} {text.replace('-', '−')} {self.display.name}"

    def pose(self, k: int) -> Pose:
        """Return pose ``k``."""
        points = {name: place[k] for name, place in self.points.items()}
        return Pose(
            points,
            self.spin_axis[k],
            self.contact[k],
            float(self.ground[k]),
            bool(self.touches[k]),
            self.label(k),
        )

    def subset(self, index: Any) -> Poses:
        """Return a selection of poses by a numpy index."""
        return replace(
            self,
            points={name: place[index] for name, place in self.points.items()},
            spin_axis=self.spin_axis[index],
            contact=self.contact[index],
            ground=self.ground[index],
            touches=self.touches[index],
            over=self.over[index],
            signals={name: values[index] for name, values in self.signals.items()},
        )

    def nearest(self, value: float, where: str) -> int:
        """Return the index of the pose nearest to a value of ``over`` in SI; refuse values outside its range."""
        low, high = float(self.over.min()), float(self.over.max())
        if not low - 1e-9 <= value <= high + 1e-9:
            show = self.display
            ends = [f"{number(end * show.factor)} {show.name}" for end in (low, high)]
            raise DescriptionError(
                Phrase("no pose at this {words}", words=self.words),
                where=where,
                found=f"{number(value * show.factor)} {show.name}",
                allowed=" to ".join(ends),
            )
        return int(np.abs(self.over - value).argmin())


def poses_of(rig: Corner, scene: Scene, data: xr.Dataset) -> Poses:
    """Read all complete poses from a sweep or a run.

    ``data`` has ``<hardpoint>.x``, ``.y``, ``.z`` (m, ground axes), camber and steer (rad; for an axle, those of this
    wheel) over one dimension.
    """
    dimension = _dimension(data)
    in_time = dimension == "time"
    points = _tracks(rig, scene, data, dimension, in_time=in_time)
    series = {
        str(name): np.asarray(v.values, float)
        for name, v in data.variables.items()
        if v.dims == (dimension,)
    }
    wheel = "right" if scene.side < 0 else "left"  # of a rolling axle
    camber, steer = (
        _first(series, (name, f"wheel.{name}", f"{wheel}.{name}")) for name in ("camber", "steer")
    )
    axis = spin_axes(camber, steer, scene.side)
    radius = scene.undeformed_radius if in_time else scene.radius
    contact = contact_points(points["wheel_centre"], axis, radius)
    for kind in ("contact_point.{}", "contact_point_{}"):
        names = [kind.format(letter) for letter in "xyz"]
        for i, name in enumerate(names):
            contact[:, i] = series.get(name, contact[:, i])
    if in_time and "road.z" in series:
        ground = series["road.z"]
        contact[:, 2] = np.maximum(contact[:, 2], ground)  # the tyre is flattened
    else:
        ground = contact[:, 2].copy()
    force = series.get("tyre.force")
    touches = np.ones(len(ground), dtype=bool) if force is None else force > 0.0
    over = dimension if dimension in series else _counted_by(series, dimension)
    places = {f"{name}.{letter}" for name in points for letter in "xyz"}
    signals = {
        name: v for name, v in series.items() if name not in places and name not in (over, "pose")
    }
    poses = Poses(
        points,
        axis,
        contact,
        ground,
        touches,
        series[over],
        over.replace("_", " "),
        str(data[over].attrs.get("units", "s" if in_time else "m")),
        in_time,
        signals,
        {name: str(data.variables[name].attrs.get("units", "1")) for name in signals},
        {name: str(data.variables[name].attrs.get("long_name", name)) for name in signals},
    )
    known = np.isfinite(axis).all(axis=1) & np.isfinite(points["wheel_centre"]).all(axis=1)
    if not known.any():
        raise RecordingError("no pose is complete; every pose has gaps", where="poses")
    return poses if known.all() else poses.subset(known)


def _dimension(data: xr.Dataset) -> str:
    if "wheel_centre.z" not in data:
        raise RecordingError(
            "these poses hold no hardpoints, only "
            + (", ".join(map(str, list(data.data_vars)[:6])) or "nothing"),
            where="poses",
            hint="Ask for them: jn.sweep_travel(..., points=True), jn.simulate(..., detail=True).",
        )
    dimensions = data["wheel_centre.z"].dims
    if len(dimensions) != 1:
        raise RecordingError(
            "poses over one dimension are needed",
            where="poses",
            found=" x ".join(map(str, dimensions)),
            hint="Choose one value of the other dimensions, e.g. poses.isel(rack_travel=0).",
        )
    return str(dimensions[0])


def _tracks(
    rig: Corner, scene: Scene, data: xr.Dataset, dimension: str, *, in_time: bool
) -> dict[str, Array]:
    """Positions of all hardpoints, shape (n, 3); missing ones on a body at rest are at their design position."""
    count = data.sizes[dimension]
    places, missing = {}, []
    for name, design in rig.hardpoints.given().items():
        names = [f"{name}.{letter}" for letter in "xyz"]
        if all(column in data for column in names):
            places[name] = np.stack(
                [np.broadcast_to(data.variables[column].to_numpy(), count) for column in names],
                axis=1,
            )
        elif name in scene.on_body and (not in_time or rig.guide == "fixed"):
            places[name] = np.broadcast_to(np.array(design), (count, 3))
        elif name not in (*BAR, "arb_axis"):  # a run does not contain the position of its bar
            missing.append(name)
    if missing:
        raise RecordingError(
            "the poses do not include these hardpoints; do they belong to a different rig?",
            where="poses",
            found=", ".join(missing),
        )
    return with_middle(places)


def _first(series: Mapping[str, Array], names: tuple[str, ...]) -> Array:
    for name in names:
        if name in series:
            return series[name]
    raise RecordingError(
        "the poses do not include the orientation of the wheel",
        where="poses",
        allowed=Phrase("a variable {names}", names=" or ".join(names)),
    )


def _counted_by(series: Mapping[str, Array], dimension: str) -> str:
    """Return the name of the variable that orders a dimension without coordinates."""
    for name in ("wheel_travel", "rack_travel", "roll_angle"):
        if name in series:
            return name
    raise RecordingError(
        "the poses have no dimension", where="poses", found=f"dimension {dimension}"
    )


REACH = 3.2
"""Length of the road shown behind and ahead of the wheel, in wheel radii."""
_VISIBLE = 2e-5  # m: a curve drawn with this error looks smooth


@dataclass(frozen=True)
class Roadway:
    """Height of a road over distance, and the distance driven at each pose; m."""

    distance: Array  # corners of the line, ascending; jumps are vertical
    height: Array
    driven: Array

    def line(self, k: int, reach: float, x: float) -> Array:
        """Return x and z (m), shape (m, 2), of the road within ``reach`` (m) of a wheel at ``x`` (m) in pose ``k``."""
        first, last = self.driven[k] - reach, self.driven[k] + reach
        inside = (self.distance > first) & (self.distance < last)
        ends = np.interp([first, last], self.distance, self.height)
        distance = np.concatenate([[first], self.distance[inside], [last]])
        height = np.concatenate([ends[:1], self.height[inside], ends[1:]])
        return np.column_stack([distance - self.driven[k] + x, height])


def roadway_of(trial: Trial, time: Array, radius: float) -> Roadway | None:
    """Return the road of a trial under a wheel with this radius (m) at the times (s) of its poses.

    Returns None for an excitation, whose plate only moves vertically.
    """
    if trial.road is None or trial.speed is None:
        return None
    if time[-1] > trial.duration * (1.0 + 1e-9):
        raise DescriptionError(
            "the poses do not belong to this trial; they continue after its end",
            where="trial",
            found=f"{time[-1]:g} s",
            allowed=Phrase("up to {duration:g} s", duration=trial.duration),
        )
    way = trial.speed * time
    distance, height = sample_segments(trial.road.segments(float(way[-1]) + REACH * radius))
    needed = _bends(distance, height)
    return Roadway(distance[needed], height[needed], way)


def _bends(distance: Array, height: Array) -> NDArray[np.bool_]:
    """Mask of the points needed to draw a line; points on the straight between their neighbours are dropped."""
    needed = np.ones(len(distance), dtype=bool)
    while True:
        at = np.flatnonzero(needed)
        if len(at) < 3:
            return needed
        before, here, after = at[:-2:2], at[1:-1:2], at[2::2]
        count = min(len(before), len(here), len(after))
        before, here, after = before[:count], here[:count], after[:count]
        share = (distance[here] - distance[before]) / np.maximum(
            distance[after] - distance[before], 1e-12
        )
        off = np.abs(height[before] + share * (height[after] - height[before]) - height[here])
        straight = here[off < 0.1 * _VISIBLE]
        if not len(straight):
            return needed
        needed[straight] = False
