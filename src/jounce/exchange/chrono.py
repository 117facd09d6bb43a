"""Export of 3-D corners as Project Chrono suspension files, the inverse of ``jounce import chrono``."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Any

import numpy as np

from jounce.core.errors import DescriptionError, OutputError
from jounce.core.findings import Finding, finding
from jounce.core.operation import File, Number, Switch, operation
from jounce.core.phrases import Phrase
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.core.writing import check_writable, write_atomically
from jounce.exchange.corners import corner_of, require_parts
from jounce.parts import Rig, as_rig
from jounce.parts.bodies import INERTIA_ELEMENTS, RigidBody
from jounce.parts.corners import Corner, DoubleWishbone, FiveLink, McPherson
from jounce.parts.curves import TableCurve
from jounce.parts.dampers import LinearDamper, MapDamper
from jounce.parts.importers.chrono import (
    DESIGN,
    STOP_PROGRESSION,
    STOP_RATE,
    TEMPLATES,
    arm_frame,
    rod_frame,
)
from jounce.parts.leverage import force_at
from jounce.parts.options import AnyRig
from jounce.parts.points import SAME_POINT

_RADIUS = {"Spindle": 0.1, "Upright": 0.025}  # m, body radii in Chrono's graphics; default 0.02 m
_SPINDLE_SHARE, _SPINDLE_SIZE = (
    0.05,
    0.05,
)  # fraction of the upright's mass, m: spindle of a rig without a separate wheel
_ARM_SHARE, _ARM_SIZE = 0.05, 0.02  # fraction of the upright's mass, m: arm formed by links 1 and 2
_AXLE_INERTIA = 0.4  # kg m^2: half shaft, required by Chrono
_CURVE = np.linspace(-0.1, 0.25, 71)  # m: sampling points of curves that are not tables
_EXACT_PRODUCTS = ("DoubleWishbone",)  # templates of Chrono that read products of inertia
_LOST = 1e-4  # products of inertia below this fraction of the largest moment count as zero


@dataclass(frozen=True)
class ChronoExport(Plain):
    """Result of an export.

    Attributes
    ----------
    path : Path
        The file written.
    template : str
        Chrono template: ``DoubleWishbone``, ``MacPhersonStrut`` or ``MultiLink``.
    findings : tuple of Finding
        Parts of the rig that the file omits or represents differently.
    """

    path: Path
    template: str
    findings: tuple[Finding, ...]


@operation(
    "export chrono",
    named={"changes": "set", "path": "out"},
    faces={"wheel_mass": None},
    echo={"rig": "rig", "out": "out"},
    page="jounce.report.exchange:chrono_export_page",
    title="{rig}",
    doing="writing the suspension",
    example="jounce export chrono sedan-double-wishbone --out suspension.json",
)
def write_chrono(
    rig: AnyRig,
    path: Annotated[Path | str, File("Project Chrono suspension file to write.", "FILE.json")],
    *,
    wheel_mass: Annotated[
        float | str,
        Number(
            "Mass of rim and tyre, which Chrono keeps in other files: subtracted from the wheel. Default: 0.",
            "MASS",
            "kg",
            is_positive=True,
        ),
    ] = 0.0,
    force: Annotated[bool, Switch("Overwrite existing output.")] = False,
) -> ChronoExport:
    """Write a 3-D rig as a suspension of Project Chrono: double wishbone, McPherson strut, multi-link.

    Supports double wishbones, McPherson struts, and five links of which two form an arm. Heights are relative to the
    wheel centre, because Chrono positions a suspension relative to its axle. The file describes the left side, as
    ``jounce import chrono`` expects.

    Parameters
    ----------
    rig : Rig, str or Path
        3-D corner of a car, its file, or its name in the library.
    path : Path or str
        File to write.
    wheel_mass : float
        Mass of rim and tyre [kg], which Chrono keeps in separate files. It is subtracted from the spindle, with the
        inertia of a typical wheel. 0: the spindle is the whole wheel.
    force : bool
        Overwrite an existing file.

    Returns
    -------
    ChronoExport
        The file written, and findings.

    Raises
    ------
    OutputError
        For a rig that fits none of these templates, a wheel mass above that of the wheel, or an existing file.

    Examples
    --------
    >>> import tempfile
    >>> import jounce as jn
    >>> made = write_chrono(jn.load("sedan-multi-link"), tempfile.mkdtemp() + "/rear.json")
    >>> made.template
    'MultiLink'
    """
    file = check_writable(path, what="suspensions", suffixes=(".json",), force=force)
    wheel_mass = to_si(wheel_mass, "kg", where="wheel_mass")
    if wheel_mass < 0.0:
        raise DescriptionError(
            "invalid mass", where="wheel_mass", found=wheel_mass, allowed="0 kg or more"
        )
    writing = _ChronoWriter(_left_corner(as_rig(rig)), wheel_mass)
    table = writing.table()
    write_atomically(file, (json.dumps(_plain(table), indent=2) + "\n").encode(), force=force)
    return ChronoExport(file, table["Template"], tuple(writing.findings))


def _left_corner(rig: Rig) -> Corner:
    allowed = "3-D corners: double-wishbone, mcpherson, five-link"
    corner = corner_of(rig, "Chrono has no template for this rig", allowed)
    require_parts(corner, what="a suspension of Chrono")
    return corner if corner.side == "left" else corner.mirrored()


def _plain(value: Any) -> Any:
    """Convert arrays to lists and round numbers to 12 digits."""
    if isinstance(value, Mapping):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, np.ndarray | list | tuple):
        return [_plain(item) for item in value]
    return float(f"{value:.12g}") + 0.0 if isinstance(value, float) else value


@dataclass
class _ChronoWriter:
    """Builds the file of a rig, and collects findings."""

    rig: Corner
    wheel_mass: float
    findings: list[Finding] = field(default_factory=list)
    points: dict[str, Array] = field(init=False)
    template: str = field(init=False)

    def __post_init__(self) -> None:
        down = np.array([0.0, 0.0, self.rig.hardpoints.wheel_centre[2]])
        self._down = down
        self.points = {
            name: np.array(point) - down for name, point in self.rig.hardpoints.given().items()
        }
        for element in ("spring", "damper"):
            for end in ("bottom", "top"):
                self.points.setdefault(f"{element}_{end}", self.points[f"strut_{end}"])

    def table(self) -> dict[str, Any]:
        """Return the content of the file."""
        ways: dict[type[Corner], tuple[str, Callable[[], dict[str, Any]]]] = {
            DoubleWishbone: ("DoubleWishbone", self._double_wishbone),
            McPherson: ("MacPhersonStrut", self._mcpherson),
            FiveLink: ("MultiLink", self._multi_link),
        }
        rig = self.rig
        if type(rig) not in ways:
            raise self._refusal(f"Chrono has no template for a {getattr(rig, 'model', '')}")
        if rig.strut.on == "rocker":
            raise self._refusal("Chrono's templates have no push rod and rocker")
        self.template, bodies = ways[type(rig)]
        wheel = rig.wheel
        head = {
            "Name": rig.source.splitlines()[0][:80] if rig.source else f"{rig.model} of jounce",  # type: ignore[attr-defined]
            "Type": "Suspension",
            "Template": self.template,
            "Camber Angle (deg)": float(np.degrees(wheel.camber)),
            "Toe Angle (deg)": float(np.degrees(wheel.toe)),
        }
        parts = bodies()
        self._place_points(parts)
        parts["Spring"] |= self._spring()
        parts["Shock"] |= self._damper()
        self._note_rest()
        return {**head, **parts, "Axle": {"Inertia": _AXLE_INERTIA}}

    def _refusal(self, what: str, **more: Any) -> OutputError:
        return OutputError(
            what,
            where="rig",
            allowed="a strut on the lower arm; or export equations or MJCF",
            **more,
        )

    def _say(self, code: str, place: str, value: float | None = None, /, **numbers: Any) -> None:
        self.findings.append(finding(code, place, value, **numbers))

    def _place_points(self, parts: dict[str, dict[str, Any]]) -> None:
        """Write each point to its section and key."""
        names, _ = TEMPLATES[self.template]
        for name, (section, key) in names.items():
            if name in self.points:
                parts.setdefault(section, {})[key] = self.points[name]

    # --- bodies

    def _part(self, name: str, section: str, body: RigidBody, frame: Array) -> dict[str, Any]:
        """Return mass properties in Chrono's frame of a body."""
        tensor = frame.T @ body.inertia.tensor @ frame
        products = [tensor[0, 1], tensor[0, 2], tensor[1, 2]]
        whole = {
            "Mass": body.mass,
            "COM": np.array(body.centre_of_mass) - self._down,
            "Radius": _RADIUS.get(section, 0.02),
        }
        largest = float(np.abs(products).max()) / float(np.abs(tensor).max())
        if self.template in _EXACT_PRODUCTS and section != "Spindle":
            return whole | {"Moments of Inertia": np.diag(tensor), "Products of Inertia": products}
        if largest > _LOST:
            self._say(
                "exchange.products_lost",
                f"bodies.{name}",
                largest,
                section=section,
                largest=largest,
            )
        return whole | {"Inertia": np.diag(tensor), "Products of Inertia": products}

    def _body(self, name: str) -> RigidBody | None:
        body: RigidBody | None = self.rig.body_masses().get(name)
        return body

    def _arm(self, name: str, section: str) -> dict[str, Any]:
        body = self._body(name)
        assert body is not None
        front, rear = (self.points[f"{name}_{end}"] for end in ("front", "rear"))
        ball = self.points[name.replace("arm", "ball_joint")]
        return self._part(name, section, body, arm_frame(front, rear, ball, name))

    def _carrier(self) -> dict[str, dict[str, Any]]:
        """Return spindle and upright."""
        upright, wheel = self._body("upright"), self._body("wheel")
        assert upright is not None
        at = np.array(self.rig.hardpoints.wheel_centre)
        if wheel is None:
            mass = _SPINDLE_SHARE * upright.mass
            if self.wheel_mass:
                raise OutputError(
                    "the rig has no wheel body from which to subtract rim and tyre", where="wheel_mass",
                    found=f"{self.wheel_mass:g} kg", allowed="0 kg",
                )  # fmt: skip
            spindle = _ball(mass, at, _SPINDLE_SIZE)
            upright = _less(upright, spindle)
            self._say("exchange.spindle_of_upright", "bodies.wheel", mass=mass)
        else:
            spindle = wheel
            if self.wheel_mass:
                radius = self.rig.wheel.radius
                rolling = _body(
                    self.wheel_mass, at, self.wheel_mass * radius**2 * np.diag([0.35, 0.6, 0.35])
                )
                spindle = _less(wheel, rolling)
            else:
                self._say("exchange.spindle_is_wheel", "bodies.wheel", wheel.mass, mass=wheel.mass)
        if np.linalg.norm(np.array(spindle.centre_of_mass) - at) > SAME_POINT:
            self._say("exchange.spindle_centre", "bodies.wheel")
        return {
            "Spindle": {**self._part("wheel", "Spindle", spindle, DESIGN), "Width": 0.05},
            "Upright": self._part("upright", "Upright", upright, DESIGN),
        }

    def _rod(self, name: str) -> dict[str, Any]:
        """Return the tie rod as a body if it has mass, else an empty table."""
        body = self._body(name)
        if body is None:
            return {}
        inner, outer = self.points[f"{name}_inner"], self.points[f"{name}_outer"]
        frame = rod_frame(inner, outer, np.cross(outer - inner, [1.0, 0.0, 0.0]), name)
        part = self._part(name, "Tierod", body, frame)
        if np.linalg.norm(part.pop("COM") - 0.5 * (inner + outer)) > SAME_POINT:
            self._say("exchange.tie_rod_centre", f"bodies.{name}")
        if "Moments of Inertia" in part:
            part["Inertia"] = part.pop("Moments of Inertia")
        return part

    def _double_wishbone(self) -> dict[str, dict[str, Any]]:
        if self.rig.strut.on != "lower_arm":
            raise self._refusal(
                "Chrono's double wishbone has its strut on the lower arm", found=self.rig.strut.on
            )
        return {
            **self._carrier(),
            "Upper Control Arm": self._arm("upper_arm", "Upper Control Arm"),
            "Lower Control Arm": self._arm("lower_arm", "Lower Control Arm"),
            "Tierod": self._rod("tie_rod"), "Spring": {}, "Shock": {},
        }  # fmt: skip

    def _mcpherson(self) -> dict[str, dict[str, Any]]:
        parts = {**self._carrier(), "Control Arm": self._arm("lower_arm", "Control Arm")}
        strut = self._body("strut")
        if strut is None:
            self._say("exchange.strut_mass", "bodies.strut")
            strut = _ball(0.1, np.array(self.rig.hardpoints.strut_top), _ARM_SIZE)
        parts["Strut"] = self._part("strut", "Strut", strut, DESIGN)
        middle = 0.5 * (self.points["spring_top"] + self.points["spring_bottom"])
        if np.linalg.norm(parts["Strut"].pop("COM") - middle) > SAME_POINT:
            self._say("exchange.strut_centre", "bodies.strut")
        return {**parts, "Tierod": self._rod("tie_rod"), "Spring": {}, "Shock": {}}

    def _multi_link(self) -> dict[str, dict[str, Any]]:
        points, bodies = self.points, self.rig.body_masses()
        if np.linalg.norm(points["link_1_outer"] - points["link_2_outer"]) > SAME_POINT:
            raise self._refusal(
                "links 1 and 2 have different outer points, but are one upper arm in Chrono's multi-link"
            )
        if self.rig.strut.on != "link_4":
            raise self._refusal(
                "Chrono's multi-link has its strut on the trailing link", found=self.rig.strut.on
            )
        missing = [name for name in ("link_3", "link_4") if name not in bodies]
        if missing:
            raise self._refusal(
                "massless links, but Chrono's multi-link needs their masses",
                found=", ".join(missing),
            )
        heavy = [name for name in ("link_1", "link_2") if name in bodies]
        if heavy:
            raise self._refusal(
                "links 1 and 2 are separate bodies, but one arm in Chrono",
                found=", ".join(heavy),
            )
        carrier = bodies["upright"]
        outer = np.array(self.rig.hardpoints.link_1_outer)  # type: ignore[attr-defined]
        arm = _ball(_ARM_SHARE * carrier.mass, outer, _ARM_SIZE)
        self._say("exchange.upper_arm_mass", "Upper Arm", mass=arm.mass)
        inners = points["link_1_inner"], points["link_2_inner"]
        original = self.rig
        self.rig = original.model_copy(
            update={
                "bodies": original.bodies.model_copy(
                    update={"upright": _less(carrier, arm, with_inertia=False)}
                )
            }
        )
        parts = {
            **self._carrier(),
            "Upper Arm": self._part(
                "link_1", "Upper Arm", arm, arm_frame(*inners, points["link_1_outer"], "link_1")
            ),
        }
        self.rig = original
        for name, section, beside in (
            ("link_3", "Lateral", points["link_4_outer"]),
            ("link_4", "Trailing Link", points["spring_bottom"]),
        ):
            start, end = points[f"{name}_outer"], points[f"{name}_inner"]
            across = np.cross(start - beside, end - beside)
            frame = rod_frame(start, end, across, name)
            axes = {
                "Universal Joint Axis Link": frame[:, 0],
                "Universal Joint Axis Chassis": frame[:, 1],
            }
            parts[section] = {**self._part(name, section, bodies[name], frame), **axes}
        return {**parts, "Tierod": self._rod("link_5"), "Spring": {}, "Shock": {}}

    # --- spring and damper

    def _spring(self) -> dict[str, Any]:
        strut, spring = self.rig.strut, self.rig.strut.spring
        design = self.rig.hardpoints.length("spring")
        result: dict[str, Any]
        if spring.rate is not None:
            preload = spring.preload or 0.0
            free = (
                spring.free_length
                if spring.free_length is not None
                else design + preload / spring.rate
            )
            result = {"Spring Coefficient": spring.rate, "Free Length": free}
        else:
            curve = spring.curve
            assert curve is not None
            compressed = np.array(curve.deflection) if isinstance(curve, TableCurve) else _CURVE
            if not isinstance(curve, TableCurve):
                self._say("exchange.curve_as_table", "strut.spring")
            force = np.array([force_at(curve, x) for x in compressed]) + (spring.preload or 0.0)
            free = design if spring.free_length is None else spring.free_length
            result = {
                "Curve Data": np.column_stack([-compressed[::-1], -force[::-1]]),
                "Free Length": free,
            }
        gaps = {name: getattr(strut, name) for name in ("bump_stop", "rebound_stop")}
        if all(gaps.values()):
            result["Minimum Length"] = design - gaps["bump_stop"].gap
            result["Maximum Length"] = design + gaps["rebound_stop"].gap
        for name, stop in gaps.items():
            if stop is None:
                continue
            if not all(gaps.values()):
                self._say("exchange.stop_left_out", f"strut.{name}")
            elif not np.allclose((stop.rate, stop.progression), (STOP_RATE, STOP_PROGRESSION)):
                self._say("exchange.stop_law", f"strut.{name}")
        return result

    def _damper(self) -> dict[str, Any]:
        damper = self.rig.strut.damper
        if isinstance(damper, LinearDamper):
            return {"Damping Coefficient": damper.coefficient}
        if isinstance(damper, MapDamper):
            force = -np.array(damper.force)[:, ::-1].T
            rows = np.column_stack([-np.array(damper.velocity)[::-1], force])
            return {"Deformation": np.array(damper.length), "Map Data": rows}
        points = damper.points(beyond=10.0)
        if points is None:
            raise self._refusal("Chrono's files have no damper with hysteresis", found=damper.kind)
        velocity, force = points
        return {"Curve Data": np.column_stack([-velocity[::-1], -force[::-1]])}

    def _note_rest(self) -> None:
        """Add findings on parts of the rig that the file omits."""
        rig = self.rig
        parts = ("anti_roll_bar", "torsion_bar", "third_spring", "guide_friction")
        left = [name for name in parts if getattr(rig, name, None) is not None]
        left += ["strut.friction"] if rig.strut.friction is not None else []
        left += ["steering.rack_travel"] if rig.parameters().get("steering.rack_travel") else []
        left += rig.elastic_parts
        if left:
            self.findings.append(finding("exchange.not_in_file", "rig", names=", ".join(left)))
        self._say("exchange.tyre_elsewhere", "rig")


def _ball(mass: float, centre: Array, radius: float) -> RigidBody:
    return _body(mass, centre, 0.4 * mass * radius**2 * np.eye(3))


def _body(mass: float, centre: Array, tensor: Array) -> RigidBody:
    inertia = {name: float(tensor[at]) for name, at in INERTIA_ELEMENTS.items()}
    return RigidBody.model_validate(
        {"mass": mass, "centre_of_mass": tuple(map(float, centre)), "inertia": inertia}
    )


def _less(whole: RigidBody, part: RigidBody, *, with_inertia: bool = True) -> RigidBody:
    """Subtract a part from a body; refuse a part heavier than the body."""
    mass = whole.mass - part.mass
    if mass <= 0.0:
        raise OutputError(
            "more than the whole mass of the body",
            where="wheel_mass",
            found=f"{part.mass:g} kg",
            allowed=Phrase("below {mass:g} kg", mass=whole.mass),
        )
    centres = np.array(whole.centre_of_mass), np.array(part.centre_of_mass)
    centre = (whole.mass * centres[0] - part.mass * centres[1]) / mass
    tensor = whole.inertia.tensor - (part.inertia.tensor if with_inertia else 0.0)
    for weight, place in ((mass, centre), (part.mass, centres[1])):
        away = place - centres[0]
        tensor = tensor - weight * ((away @ away) * np.eye(3) - np.outer(away, away))
    moments = np.linalg.eigvalsh(tensor)
    if moments[0] <= 0.0 or moments[2] > (moments[0] + moments[1]) * (1.0 + 1e-6):
        raise OutputError(
            "the remaining body has an impossible inertia",
            where="wheel_mass",
            found=f"{part.mass:g} kg of {whole.mass:g} kg",
            hint="Reduce the wheel mass.",
        )
    return _body(mass, centre, tensor)
