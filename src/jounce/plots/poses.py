"""Many poses of a 3-D rig, read from a sweep or a run that says where its hardpoints are."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import DescriptionError, RecordingError
from jounce.core.types import Array
from jounce.plots.display import DisplayUnit, display_unit, number
from jounce.plots.scenes import BAR, Pose, Scene, contact_points, spin_axes

if TYPE_CHECKING:
    import xarray as xr

    from jounce.parts.corners import Corner


@dataclass(frozen=True)
class Poses:
    """Many poses, over travel or over time.

    Attributes
    ----------
    points : mapping of str to ndarray, shape (n, 3)
        Hardpoints, m.
    spin_axis, contact : ndarray, shape (n, 3)
        As in :class:`Pose`.
    ground : ndarray, shape (n,)
        Height of the road under the wheel, m.
    touches : ndarray of bool, shape (n,)
        Whether the tyre carries anything.
    over : ndarray, shape (n,)
        What the poses are counted by, SI.
    words, unit : str
        What ``over`` is, and its SI unit.
    in_time : bool
        A run over time rather than a sweep.
    signals : mapping of str to ndarray, shape (n,)
        Everything else known of each pose, by name, SI.
    signal_units, signal_words : mapping of str to str
        SI unit and long name of each.
    """

    points: Mapping[str, Array]
    spin_axis: Array
    contact: Array
    ground: Array
    touches: NDArray[np.bool_]
    over: Array
    words: str
    unit: str
    in_time: bool
    signals: Mapping[str, Array] = field(default_factory=dict)
    signal_units: Mapping[str, str] = field(default_factory=dict)
    signal_words: Mapping[str, str] = field(default_factory=dict)

    def __len__(self) -> int:
        return len(self.over)

    @property
    def display(self) -> DisplayUnit:
        """Unit in which ``over`` is shown."""
        return DisplayUnit("s", 1.0) if self.in_time else display_unit(self.unit)

    def label(self, k: int) -> str:
        """What pose ``k`` is, e.g. ``"wheel travel 20 mm"``."""
        value = self.over[k] * self.display.factor
        text = f"{value:.3f}" if self.in_time else f"{round(value, 2):+g}".replace("+0", "0")
        return f"{self.words} {text.replace('-', '−')} {self.display.name}"

    def pose(self, k: int) -> Pose:
        """Give one of them."""
        points = {name: place[k] for name, place in self.points.items()}
        return Pose(
            points, self.spin_axis[k], self.contact[k], float(self.ground[k]), bool(self.touches[k]), self.label(k)
        )

    def taken(self, index: Any) -> Poses:
        """Only some of them, as numpy indexes."""
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
        """Index of the pose nearest to a value of ``over`` in its SI unit; values outside are refused."""
        low, high = float(self.over.min()), float(self.over.max())
        if not low - 1e-9 <= value <= high + 1e-9:
            show = self.display
            ends = [f"{number(end * show.factor)} {show.name}" for end in (low, high)]
            raise DescriptionError(
                f"there is no pose at this {self.words}",
                where=where,
                found=f"{number(value * show.factor)} {show.name}",
                allowed=" to ".join(ends),
            )
        return int(np.abs(self.over - value).argmin())


def poses_of(rig: Corner, scene: Scene, data: xr.Dataset) -> Poses:
    """Read poses from a sweep or a run.

    Parameters
    ----------
    rig : Corner
        What moves.
    scene : Scene
        Of that rig.
    data : xarray.Dataset
        Variables ``<hardpoint>.x``, ``.y`` and ``.z`` (m, ground axes) and the wheel's camber and steer (rad), over one
        dimension.

    Returns
    -------
    Poses
        All poses in which everything is known.

    Raises
    ------
    RecordingError
        Without hardpoints, or with more than one dimension.
    """
    dimension = _dimension(data)
    in_time = dimension == "time"
    points = _tracks(rig, scene, data, dimension, in_time=in_time)
    one = {str(name): v.to_numpy().astype(float) for name, v in data.variables.items() if v.dims == (dimension,)}
    axis = spin_axes(_first(one, ("camber", "wheel.camber")), _first(one, ("steer", "wheel.steer")), scene.side)
    radius = scene.undeformed_radius if in_time else scene.radius
    contact = contact_points(points["wheel_centre"], axis, radius)
    for kind in ("contact_point.{}", "contact_point_{}"):
        names = [kind.format(letter) for letter in "xyz"]
        for i, name in enumerate(names):
            contact[:, i] = one.get(name, contact[:, i])
    if in_time and "road.z" in one:
        ground = one["road.z"]
        contact[:, 2] = np.maximum(contact[:, 2], ground)  # the tyre is pressed flat
    else:
        ground = contact[:, 2].copy()
    force = one.get("tyre.force")
    touches = np.ones(len(ground), dtype=bool) if force is None else force > 0.0
    over = dimension if dimension in one else _counted_by(one, dimension)
    places = {f"{name}.{letter}" for name in points for letter in "xyz"}
    signals = {name: v for name, v in one.items() if name not in places and name not in (over, "pose")}
    poses = Poses(
        points,
        axis,
        contact,
        ground,
        touches,
        one[over],
        over.replace("_", " "),
        str(data[over].attrs.get("units", "s" if in_time else "m")),
        in_time,
        signals,
        {name: str(data[name].attrs.get("units", "1")) for name in signals},
        {name: str(data[name].attrs.get("long_name", name)) for name in signals},
    )
    known = np.isfinite(axis).all(axis=1) & np.isfinite(points["wheel_centre"]).all(axis=1)
    if not known.any():
        raise RecordingError("no pose is known; every one has gaps", where="poses")
    return poses if known.all() else poses.taken(known)


def _dimension(data: xr.Dataset) -> str:
    if "wheel_centre.z" not in data:
        raise RecordingError(
            "these poses hold no hardpoints, only " + (", ".join(map(str, list(data.data_vars)[:6])) or "nothing"),
            where="poses",
            hint="Ask for them: jn.sweep_travel(..., points=True), jn.simulate(..., detail=True).",
        )
    dimensions = data["wheel_centre.z"].dims
    if len(dimensions) != 1:
        raise RecordingError(
            "poses over one dimension are needed",
            where="poses",
            found=" x ".join(map(str, dimensions)),
            hint="Choose one value of the others, e.g. poses.isel(rack_travel=0).",
        )
    return str(dimensions[0])


def _tracks(rig: Corner, scene: Scene, data: xr.Dataset, dimension: str, *, in_time: bool) -> dict[str, Array]:
    """Places of every hardpoint, shape (n, 3); on a body that stands still, those not in the data are at design."""
    count = data.sizes[dimension]
    found, missing = {}, []
    for name, design in rig.hardpoints.given().items():
        names = [f"{name}.{letter}" for letter in "xyz"]
        if all(one in data for one in names):
            found[name] = np.stack([np.broadcast_to(data[one].to_numpy(), count) for one in names], axis=1)
        elif name in scene.on_body and (not in_time or rig.guide == "fixed"):
            found[name] = np.broadcast_to(np.array(design), (count, 3))
        elif name not in BAR:
            missing.append(name)
    if missing:
        raise RecordingError(
            "the poses do not say where these hardpoints are; are they of another rig?",
            where="poses",
            found=", ".join(missing),
        )
    return found


def _first(one: Mapping[str, Array], names: tuple[str, ...]) -> Array:
    for name in names:
        if name in one:
            return one[name]
    raise RecordingError(
        "the poses do not say how the wheel stands", where="poses", allowed=f"a variable {' or '.join(names)}"
    )


def _counted_by(one: Mapping[str, Array], dimension: str) -> str:
    """Name of what a dimension without values of its own is counted by."""
    for name in ("wheel_travel", "rack_travel", "roll_angle"):
        if name in one:
            return name
    raise RecordingError("the poses are not counted by anything", where="poses", found=f"dimension {dimension}")
