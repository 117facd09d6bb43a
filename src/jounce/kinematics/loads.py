"""Loads of pickup points and joints for a load at the contact patch: rigid parts and the spring in equilibrium.

The spring's force is the one that the load requires, not that of its law at the travel; forces therefore agree with
virtual work. Parts are massless; effects of the other wheel are included only in load cases.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Annotated, Literal

import casadi as ca
import numpy as np

from jounce.core.description import Description
from jounce.core.types import Array
from jounce.core.units import Force, Unit
from jounce.kinematics.model import check_corner
from jounce.kinematics.sweeps import PreparedSweep, Values, ends_text, no_pose, prepare_sweep
from jounce.mechanics.rotations import normals, unit
from jounce.parts import Corner, Rig
from jounce.parts.leverage import AXES

if TYPE_CHECKING:
    import xarray as xr


# static equilibrium of rigid parts ------------------------------------------------------------------------------------


BODY = ""
"""The reference body: the car's body with the rack. It is not among the parts in equilibrium."""


@dataclass
class PartBalance:
    """Equilibrium of parts at n poses; unknowns are forces of the wheel-side part on the body-side part."""

    parts: tuple[str, ...]
    poses: int
    _columns: list[Array] = field(default_factory=list)
    _shared: list[tuple[Array, list[int], list[int]]] = field(default_factory=list)
    _load: Array = field(init=False)

    def __post_init__(self) -> None:
        self._load = np.zeros((self.poses, 6 * len(self.parts)))

    def load(self, part: str, force: Array, point: Array, torque: Array) -> None:
        """Apply a force (N, shape (n, 3)) at a point (m) and a torque (N m) to a part."""
        self._load += self._wrench(part, force, point) + self._turn(part, torque)

    def along(self, inner: str, outer: str, direction: Array, at: Array) -> int:
        """Add an unknown force along a direction, shape (n, 3), at a point; return its index among the unknowns."""
        self._columns.append(
            self._wrench(inner, direction, at) - self._wrench(outer, direction, at)
        )
        return len(self._columns) - 1

    def about(self, inner: str, outer: str, direction: Array) -> int:
        """Add an unknown torque about a direction."""
        self._columns.append(self._turn(inner, direction) - self._turn(outer, direction))
        return len(self._columns) - 1

    def share(self, axis: Array, first: list[int], second: list[int]) -> None:
        """Let two joints share the force along an axis equally, since a shaft in two bearings is indeterminate."""
        self._shared.append((axis, first, second))

    def solve(self) -> Array:
        """Solve for all unknowns, shape (n, unknowns)."""
        count = len(self._columns)
        matrix = np.zeros((self.poses, count, count))
        right = np.zeros((self.poses, count))
        rows = 6 * len(self.parts)
        matrix[:, :rows] = np.stack(self._columns, axis=2)
        right[:, :rows] = -self._load
        for i, (axis, first, second) in enumerate(self._shared):
            matrix[:, rows + i, first] += axis
            matrix[:, rows + i, second] -= axis
        return np.asarray(np.linalg.solve(matrix, right[:, :, None])[:, :, 0])

    def _wrench(self, part: str, force: Array, point: Array) -> Array:
        rows = np.zeros((self.poses, 6 * len(self.parts)))
        if part != BODY:
            first = 6 * self.parts.index(part)
            rows[:, first : first + 3] = force
            rows[:, first + 3 : first + 6] = np.cross(point, force)
        return rows

    def _turn(self, part: str, torque: Array) -> Array:
        rows = np.zeros((self.poses, 6 * len(self.parts)))
        if part != BODY:
            first = 6 * self.parts.index(part)
            rows[:, first + 3 : first + 6] = torque
        return rows


# loads of the pickup points -------------------------------------------------------------------------------------------


_Torque = Annotated[float, Unit("N*m")]


class ContactLoad(Description):
    """Load of the road on a wheel, ground axes (x forward, y left, z up), forces in N.

    ``longitudinal_force``, ``lateral_force``, ``vertical_force``; ``aligning_torque`` (N m) about +z. ``through`` is
    the point at which the longitudinal force reaches the upright: the contact point (brake on the wheel) or the wheel
    centre (driven or braked through a shaft).

    Examples
    --------
    >>> ContactLoad(vertical_force="4 kN", lateral_force="-2 kN").vertical_force
    4000.0
    """

    longitudinal_force: Force = 0.0
    lateral_force: Force = 0.0
    vertical_force: Force = 0.0
    aligning_torque: _Torque = 0.0
    through: Literal["contact_point", "wheel_centre"] = "contact_point"


@dataclass
class Joints:
    """Unknown forces of a corner with their names, collected while its equilibrium equations are set up.

    ``points`` has the position of every hardpoint, m, shape (n, 3); ``forces`` the hardpoints at which vectors are
    reported, each with (direction, unknown) terms; ``known`` given vectors; ``scalars`` single forces and torques.
    """

    rig: Corner
    points: dict[str, Array]
    balance: PartBalance
    forces: dict[str, list[tuple[Array, int]]] = field(default_factory=dict)
    scalars: dict[str, tuple[int, str]] = field(default_factory=dict)
    known: dict[str, Array] = field(default_factory=dict)
    given: dict[str, tuple[Array, str]] = field(default_factory=dict)

    def ball(self, name: str, inner: str, outer: str) -> list[int]:
        """Ball joint at a hardpoint: three unknown forces along the ground's axes."""
        axes = [np.tile(axis, (self.balance.poses, 1)) for axis in np.eye(3)]
        unknowns = [self.balance.along(inner, outer, axis, self.points[name]) for axis in axes]
        self.report(name, list(zip(axes, unknowns, strict=True)))
        return unknowns

    def report(self, name: str, terms: list[tuple[Array, int]]) -> None:
        """Add terms to the force reported at a hardpoint."""
        self.forces.setdefault(name, []).extend(terms)

    def axis(self, first: str, second: str, part: str) -> None:
        """Hinge a part on an axis through two hardpoints of the body; they share the force along it equally."""
        along = _unit(self.points[first] - self.points[second])
        self.balance.share(along, self.ball(first, BODY, part), self.ball(second, BODY, part))

    def rod(self, name: str, inner: str, outer: str, parts: tuple[str, str]) -> None:
        """Rod between two parts (the one nearer to the body first) that carries only tension and compression."""
        along = _unit(self.points[inner] - self.points[outer])
        unknown = self.balance.along(*parts, -along, self.points[inner])
        self.report(inner, [(-along, unknown)])
        self.report(outer, [(-along, unknown)])
        self.scalars[f"{name}.axial_force"] = (
            unknown,
            f"{name.replace('_', ' ')}: axial force, tension positive",
        )

    def torsion_bar(self, torque: Array) -> None:
        """Add the torsion bar: without a coil spring it carries the load, otherwise ``torque`` is given (N m)."""
        bar = self.rig.torsion_bar
        assert bar is not None
        along = np.tile(bump_axis(self.rig, bar.on), (self.balance.poses, 1))
        text = "torque of the torsion bar, positive against bump"
        if "spring" in self.rig.without:
            self.scalars["torsion_bar.torque"] = (
                self.balance.about(BODY, bar.on, along),
                f"{text}: what the load requires",
            )
            return
        self.balance.load(bar.on, 0.0 * along, 0.0 * along, -torque[:, None] * along)
        self.given["torsion_bar.torque"] = torque, f"{text}: of its law"

    def push(self, part: str, force: Array, points: Sequence[str]) -> None:
        """Apply a known force (N, (n, 3)) to a part at the first of several hardpoints on its line of action."""
        self.balance.load(part, force, self.points[points[0]], np.zeros_like(force))
        for name in points:
            self.known[name] = -force

    def ends(self, element: str) -> list[str]:
        """Hardpoints of the ``"spring"`` or ``"damper"``, from the wheel to the body."""
        own = [f"{element}_{end}" for end in ("bottom", "top")]
        return [
            name if name in self.points else f"strut_{name.removeprefix(element + '_')}"
            for name in own
        ]

    def still_damper(self, force: Array) -> None:
        """Add a damper with a force at rest (N) from its gas."""
        bottom, top = self.ends("damper")
        along = _unit(self.points[top] - self.points[bottom])
        self.push(self.rig.strut.on, -force[:, None] * along, (bottom, top))
        self.given["damper.force"] = (
            force,
            "force of the damper at rest, compression positive: of its law",
        )

    def spring(self) -> None:
        """Add the spring between the body and the part with the strut's lower end."""
        if "spring" in self.rig.without and self.rig.torsion_bar is not None:
            return
        names = self.ends("spring")
        along = _unit(self.points[names[1]] - self.points[names[0]])
        unknown = self.balance.along(BODY, self.rig.strut.on, along, self.points[names[1]])
        for name in names:
            self.report(name, [(along, unknown)])
        self.scalars["spring.force"] = (
            unknown,
            "spring force that the load requires, compression positive",
        )

    def rocker(self) -> None:
        """Add the rocker on its pivot with its push rod; its bearing carries three forces and two torques."""
        if getattr(self.rig.hardpoints, "rocker_pivot", None) is None:
            return
        pivot, end = self.points["rocker_pivot"], self.points["rocker_axis"]
        self.ball("rocker_pivot", BODY, "rocker")
        for normal in _across(_unit(end - pivot)):
            self.balance.about(BODY, "rocker", normal)
        self.rod(
            "pushrod",
            "pushrod_inner",
            "pushrod_outer",
            ("rocker", getattr(self.rig.strut, "pushrod_on", "upright")),
        )


def pickup_loads(
    rig: Rig, load: ContactLoad, travel: Values = 0.0, *, rack: float | None = None
) -> xr.Dataset:
    """Compute forces at all hardpoints of a corner for a load at its contact patch.

    Parts are rigid and massless, joints frictionless. The force of the spring follows from the load. Two pickups on one
    axis are reported as sharing the force along it equally: rigid parts do not determine it.

    Parameters
    ----------
    rig : Rig
        A corner with hardpoints.
    load : ContactLoad
        Forces (N) and aligning torque (N m) of the road on the wheel, ground axes.
    travel : float, str or array_like, shape (n,)
        Vertical travel of the wheel centre from design, m, bump positive, monotonic.
    rack : float, optional
        Travel of the rack, m, positive to the left; the description's own by default.

    Returns
    -------
    xarray.Dataset
        On ``wheel_travel`` (m): ``<hardpoint>.fx``, ``.fy``, ``.fz`` (N, ground axes): force of the part nearer to the
        wheel on the one nearer to the body. ``spring.force`` (N, compression positive), or ``torsion_bar.torque``
        (N m, against bump) instead, ``<rod>.axial_force`` (N, tension positive), and ``damper.force`` (N,
        compression positive) of a damper with a force at rest. Forces of anti-roll bar and third spring from the other
        wheel are not included (see :func:`load_cases`).

    Raises
    ------
    DescriptionError
        If a rig has no hardpoints, or values are not monotonic.
    SimulationError
        If no pose can be reached.

    Examples
    --------
    >>> import jounce as jn
    >>> rig = jn.load("reference-double-wishbone")
    >>> loads = jn.pickup_loads(rig, jn.ContactLoad(vertical_force="4 kN"))
    >>> arms = ("lower_arm_front", "lower_arm_rear", "upper_arm_front", "upper_arm_rear")
    >>> round(sum(float(loads[f"{name}.fz"][0]) for name in (*arms, "tie_rod_inner", "strut_top")), 6)
    4000.0
    """
    corner = check_corner(rig)
    sweep = prepare_sweep(corner, travel, rack)
    at, joints = balance_poses(sweep, load)
    return _dataset(sweep, joints, at["wheel_travel"], joints.balance.solve())


def balance_poses(sweep: PreparedSweep, load: ContactLoad) -> tuple[dict[str, Array], Joints]:
    """Return the rows of all reached poses, and the parts in equilibrium; further loads may be added."""
    rows = {name: value.ravel() for name, value in sweep.quantities().items()}
    reached = np.flatnonzero(np.isfinite(rows["wheel_travel"]))
    if not len(reached):
        raise no_pose(sweep.ends())
    places = sweep.points()
    names = sweep.model.point_names
    points = {
        name: np.stack([places[f"{name}.{axis}"].ravel()[reached] for axis in "xyz"], axis=1)
        for name in names
    }
    rows = {name: value[reached] for name, value in rows.items()}
    return rows, _balance_corner(sweep.rig, points, load, rows)


def _balance_corner(
    rig: Corner, points: dict[str, Array], load: ContactLoad, rows: dict[str, Array]
) -> Joints:
    """Set up the equilibrium of the parts of a corner."""
    rig.require("strut", what="what the joints carry")
    model = str(getattr(rig, "model", ""))
    parts, build = _TEMPLATES[model]
    extra = ("rocker",) if getattr(rig.hardpoints, "rocker_pivot", None) is not None else ()
    links = tuple(
        name
        for name in _LINKS
        if model == "five-link" and getattr(rig.bodies, name, None) is not None
    )
    poses = len(points["contact_point"])
    joints = Joints(rig, points, PartBalance((*parts, *extra, *links), poses))
    build(joints)
    joints.rocker()
    joints.spring()
    if rig.torsion_bar is not None:
        joints.torsion_bar(rows["torsion_bar_torque"])
    if rig.strut.damper.pushes_at_rest:
        joints.still_damper(rows["damper_force"])
    wheel, contact = parts[-1], points["contact_point"]
    flat = np.tile([0.0, load.lateral_force, load.vertical_force], (poses, 1))
    pull = np.tile([load.longitudinal_force, 0.0, 0.0], (poses, 1))
    torque = np.tile([0.0, 0.0, load.aligning_torque], (poses, 1))
    joints.balance.load(wheel, flat, contact, torque)
    joints.balance.load(wheel, pull, points[load.through], np.zeros((poses, 3)))
    return joints


def bump_axis(rig: Corner, body: str) -> Array:
    """Return the unit vector about which bump rotates an arm or the rocker at design, ground axes, shape (3,)."""
    first, second, tip = (np.array(rig.hardpoints.at(name)) for name in AXES[body])
    axis = (second - first) / np.linalg.norm(second - first)
    motion = np.cross(axis, tip - first)
    if body == "rocker":
        rod = np.array(rig.hardpoints.at("pushrod_inner")) - np.array(
            rig.hardpoints.at("pushrod_outer")
        )
        return np.asarray(axis * np.where((rod @ motion) * rod[2] < 0.0, -1.0, 1.0))
    return np.asarray(axis * np.where(motion[2] < 0.0, -1.0, 1.0))


def _double_wishbone(joints: Joints) -> None:
    for arm in ("lower", "upper"):
        joints.axis(f"{arm}_arm_front", f"{arm}_arm_rear", f"{arm}_arm")
        joints.ball(f"{arm}_ball_joint", f"{arm}_arm", "upright")
    joints.rod("tie_rod", "tie_rod_inner", "tie_rod_outer", (BODY, "upright"))


def _mcpherson(joints: Joints) -> None:
    joints.axis("lower_arm_front", "lower_arm_rear", "lower_arm")
    joints.ball("lower_ball_joint", "lower_arm", "upright")
    joints.rod("tie_rod", "tie_rod_inner", "tie_rod_outer", (BODY, "upright"))
    top = joints.points["strut_top"]
    for normal in _across(_unit(top - joints.points["strut_bottom"])):
        joints.report("strut_top", [(normal, joints.balance.along(BODY, "upright", normal, top))])


def _five_link(joints: Joints) -> None:
    for name in _LINKS:
        inner, outer = f"{name}_inner", f"{name}_outer"
        if getattr(joints.rig.bodies, name, None) is None:
            joints.rod(name, inner, outer, (BODY, "upright"))
            continue
        joints.ball(inner, BODY, name)
        joints.ball(outer, name, "upright")
        joints.balance.about(BODY, name, _cross_torque(joints, inner, outer))


def _cross_torque(joints: Joints, inner: str, outer: str) -> Array:
    """Return the direction of the torque in the universal joint of a link: perpendicular to both of its axes."""
    design = np.array(getattr(joints.rig.hardpoints, outer)) - getattr(joints.rig.hardpoints, inner)
    on_the_body = ca.evalf(normals(unit(ca.SX(design)))[0]).full()[:, 0]
    first = np.tile(on_the_body, (joints.balance.poses, 1))
    return np.cross(first, _unit(np.cross(joints.points[outer] - joints.points[inner], first)))


def _trailing_arm(joints: Joints) -> None:
    joints.axis("arm_inner", "arm_outer", "arm")


_LINKS = tuple(f"link_{i}" for i in range(1, 6))
_TEMPLATES: dict[str, tuple[tuple[str, ...], Callable[[Joints], None]]] = {
    "double-wishbone": (("lower_arm", "upper_arm", "upright"), _double_wishbone),
    "mcpherson": (("lower_arm", "upright"), _mcpherson),
    "five-link": (("upright",), _five_link),
    "trailing-arm": (("arm",), _trailing_arm),
}
"""Parts in balance, the one with the wheel last, and a function that connects them."""


def _unit(vectors: Array) -> Array:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=1, keepdims=True))


def _across(axis: Array) -> tuple[Array, Array]:
    """Return two directions perpendicular to an axis and to each other."""
    reference = np.eye(3)[np.argmin(np.abs(axis), axis=1)]
    first = _unit(np.cross(axis, reference))
    return first, np.cross(axis, first)


def _dataset(sweep: PreparedSweep, joints: Joints, travel: Array, unknowns: Array) -> xr.Dataset:
    import xarray as xr

    variables = {}
    for name, force in vector_forces(joints, unknowns).items():
        for k, axis in enumerate("xyz"):
            text = f"{name.replace('_', ' ')}: force along {axis} on the part nearer to the body"
            variables[f"{name}.f{axis}"] = ("wheel_travel", force[:, k], _attributes(text, name))
    for name, value, text in single_forces(joints, unknowns):
        variables[name] = ("wheel_travel", value, _attributes(text, name))
    at = {
        "wheel_travel": (
            "wheel_travel",
            travel,
            {"units": "m", "long_name": "vertical travel of the wheel centre"},
        )
    }
    ends = sweep.ends() if len(travel) < len(sweep.layout.place) else []
    facts = {
        "model": str(getattr(joints.rig, "model", "")),
        "status": "end_of_travel" if ends else "completed",
        "stopped": ends_text(ends),
    }
    return xr.Dataset(variables, at, facts)


def vector_forces(joints: Joints, unknowns: Array) -> dict[str, Array]:
    """Forces at hardpoints on the part nearer to the body, N, ground axes, shape (n, 3)."""
    poses = joints.balance.poses
    forces = {
        name: sum((direction * unknowns[:, [i]] for direction, i in terms), np.zeros((poses, 3)))
        for name, terms in joints.forces.items()
    }
    for name, force in joints.known.items():
        forces[name] = forces.get(name, np.zeros((poses, 3))) + force
    return forces


def single_forces(joints: Joints, unknowns: Array) -> list[tuple[str, Array, str]]:
    """Return scalar forces (N) and torques (N m): name, value, text."""
    unknown_forces = [(name, unknowns[:, i], text) for name, (i, text) in joints.scalars.items()]
    return [*unknown_forces, *((name, value, text) for name, (value, text) in joints.given.items())]


def _attributes(text: str, name: str) -> dict[str, str]:
    return {"units": "N*m" if name.endswith(".torque") else "N", "long_name": text}
