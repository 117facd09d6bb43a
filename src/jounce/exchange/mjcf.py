"""Export of 3-D corners as MuJoCo models (MJCF): bodies as a tree, loops as constraints, springs as tendons."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Any
from xml.etree import ElementTree as ET

import numpy as np

from jounce.core.errors import OutputError
from jounce.core.findings import Finding, finding
from jounce.core.operation import File, Switch, operation
from jounce.core.serialise import Plain
from jounce.core.writing import check_writable, write_atomically
from jounce.exchange.corners import corner_of, require_parts
from jounce.mechanics import Mechanism
from jounce.models.corner import suspension
from jounce.parts import as_rig
from jounce.parts.corners import Corner
from jounce.parts.curves import Curve
from jounce.parts.dampers import LinearDamper
from jounce.parts.elements import BumpStop
from jounce.parts.leverage import force_at
from jounce.parts.options import AnyRig

STEP = 1e-4  # s: loop closures are springs with a time constant of two steps; longer ones let hardpoints separate
_STIFF = 2.0  # time constant of loop closures in steps: MuJoCo's lower limit
_SMALL = 1e-3  # m: finite difference about the design length for the rate of a curve
_SLOW = 0.05  # m/s: speed at which a nonlinear damper's coefficient is evaluated
_ROUNDING = (
    1e-6  # relative margin of inertia: rounding must not violate a thin plate's triangle inequality
)
_FAR = 1e3  # m: longer than any strut


@dataclass(frozen=True)
class MjcfExport(Plain):
    """Result of an export.

    Attributes
    ----------
    path : Path
        The file written.
    bodies, joints, loops : int
        Counts; loops are equality constraints.
    findings : tuple of Finding
        Parts of the rig that the file omits or represents differently.
    """

    path: Path
    bodies: int
    joints: int
    loops: int
    findings: tuple[Finding, ...]


@operation(
    "export mjcf",
    named={"changes": "set", "path": "out"},
    echo={"rig": "rig", "out": "out"},
    page="jounce.report.exchange:mjcf_export_page",
    title="{rig}",
    doing="writing the model",
    example="jounce export mjcf kart-double-wishbone --out kart.xml",
)
def write_mjcf(
    rig: AnyRig,
    path: Annotated[Path | str, File("MuJoCo model to write.", "FILE.xml")],
    *,
    force: Annotated[bool, Switch("Overwrite existing output.")] = False,
) -> MjcfExport:
    """Write a 3-D rig on its road as a MuJoCo model (MJCF), with loops as equality constraints.

    All frames coincide in the design pose, so positions are those of the rig: SI, x forward, y left, z up. Equality
    constraints close loops, rods are tendons of fixed length, and spring, damper, stops and friction are tendons. The
    tyre is an actuator between ``road`` (a movable mocap body) and the wheel centre. Its control is the rate of the
    road's height (m/s), used by tyres with damping. Sites have the names of hardpoints.

    Parameters
    ----------
    rig : Rig, str or Path
        3-D corner of a car, its file, or its name in the library.
    path : Path or str
        File to write.
    force : bool
        Overwrite an existing file.

    Returns
    -------
    MjcfExport
        The file written, and findings. Curves are replaced by tangents at design, bushings by ideal joints.

    Raises
    ------
    OutputError
        For a rig without hardpoints, a torsion bar instead of the spring, nonzero rack travel, a curve without positive
        slope at design, a damper with hysteresis, or an existing file.

    Examples
    --------
    >>> import tempfile
    >>> import jounce as jn
    >>> made = write_mjcf(jn.load("kart-double-wishbone"), tempfile.mkdtemp() + "/kart.xml")
    >>> made.bodies, made.loops   # body, two arms, upright; upper ball joint and tie rod
    (4, 2)
    """
    file = check_writable(path, what="models of MuJoCo", suffixes=(".xml",), force=force)
    rig = as_rig(rig)
    corner = corner_of(rig, "the rig is not a 3-D mechanism")
    require_parts(corner, "tyre", what="a model of MuJoCo")
    rack = rig.parameters().get("steering.rack_travel", 0.0)
    if rack:
        raise OutputError(
            "nonzero rack travel at design", where="steering.rack_travel", found=f"{rack:g} m",
            allowed="0 m: MuJoCo uses the lengths and joints of the design position",
        )  # fmt: skip
    writing = _MjcfWriter(corner)
    root = writing.root()
    ET.indent(root)
    write_atomically(file, ET.tostring(root, encoding="utf-8") + b"\n", force=force)
    kinds = [element.tag for element in root.iter()]
    joints = sum(kinds.count(kind) for kind in ("joint", "freejoint"))
    loops = len(root.findall("equality/*"))
    bodies = kinds.count("inertial")
    return MjcfExport(file, bodies, joints, loops, tuple(writing.findings))


def _text(values: Iterable[float] | float) -> str:
    numbers = [values] if isinstance(values, float | int) else values
    return " ".join(f"{float(value) + 0.0:.12g}" for value in numbers)


def _add(parent: ET.Element, tag: str, *given: Mapping[str, str], **more: str) -> ET.Element:
    return ET.SubElement(
        parent, tag, more | {name: text for each in given for name, text in each.items()}
    )


@dataclass
class _MjcfWriter:
    """Builds the model of a rig, and collects findings."""

    rig: Corner
    findings: list[Finding] = field(default_factory=list)
    _tendon: ET.Element = field(default_factory=lambda: ET.Element("tendon"))
    _equality: ET.Element = field(default_factory=lambda: ET.Element("equality"))
    _actuator: ET.Element = field(default_factory=lambda: ET.Element("actuator"))
    _sensor: ET.Element = field(default_factory=lambda: ET.Element("sensor"))

    def root(self) -> ET.Element:
        """Return the root element of the file."""
        self._without_bushings()
        mechanism = Mechanism()
        mechanism.gravity = mechanism.parameter("gravity")
        linkage = suspension(self.rig, mechanism)
        known = {
            path: value
            for path, value in self.rig.parameters().items()
            if path in mechanism.parameters
        }
        listed = mechanism.to_dict(known)
        root = ET.Element("mujoco", model=self.rig.model)  # type: ignore[attr-defined]
        ET.SubElement(root, "compiler", angle="radian", autolimits="true")
        option = ET.SubElement(
            root,
            "option",
            timestep=_text(STEP),
            gravity=f"0 0 {_text(-self.rig.gravity)}",
            integrator="implicitfast",
        )
        ET.SubElement(option, "flag", contact="disable")
        world = ET.SubElement(root, "worldbody")
        road = ET.SubElement(world, "body", name="road", mocap="true")
        ET.SubElement(road, "site", name="road", pos="0 0 0")
        bodies = self._tree(world, listed)
        for name, point in self.rig.hardpoints.given().items():
            carrier = linkage.owners[name].name if name in linkage.owners else linkage.chassis.name
            axis = (
                {"zaxis": _text(self._axle())} if name == "wheel_centre" else {}
            )  # only the wheel centre's site has a direction
            _add(bodies[carrier], "site", axis, name=name, pos=_text(point))
        root.extend([self._tendon, self._equality, self._actuator, self._sensor])
        self._close(listed, bodies)
        self._strut()
        self._tyre()
        self._watch(listed)
        self._note_rest()
        return root

    def _say(self, code: str, place: str, **numbers: Any) -> None:
        self.findings.append(finding(code, place, **numbers))

    def _axle(self) -> tuple[float, float, float]:
        """Return the direction of the wheel's axis, outboard."""
        camber, toe = self.rig.wheel.camber, self.rig.wheel.toe
        return (
            np.sin(toe) * np.cos(camber),
            self.rig.sign * np.cos(toe) * np.cos(camber),
            -np.sin(camber),
        )

    def _without_bushings(self) -> None:
        soft = self.rig.elastic_parts
        if soft:
            names = ", ".join(name.removeprefix("bushings.") for name in soft)
            self._say("exchange.ideal_joints", "bushings", names=names)
            self.rig = self.rig.model_copy(update={"bushings": type(self.rig.bushings)()})

    # --- bodies and joints

    def _tree(self, world: ET.Element, listed: dict[str, Any]) -> dict[str, ET.Element]:
        """Create bodies by name; each is the child of the body at the other side of its joint."""
        masses = {body["name"]: body for body in listed["bodies"]}
        bodies = {"ground": world}
        for joint in listed["joints"]:
            name = joint["carries"]
            parent = joint["first"] if joint["second"] == name else joint["second"]
            body = ET.SubElement(bodies[parent], "body", name=name)
            self._joint(body, joint)
            if masses[name].get("mass") is not None:
                self._inertial(body, masses[name])
            bodies[name] = body
        return bodies

    def _joint(self, body: ET.Element, joint: dict[str, Any]) -> None:
        kind, name = joint["kind"], joint["name"]
        friction = self.rig.guide_friction
        loss = {"frictionloss": _text(friction.force)} if name == "sprung" and friction else {}
        at = {"pos": _text(joint["at"])} if "at" in joint else {}
        if kind == "prismatic":
            _add(body, "joint", loss, name=name, type="slide", axis=_text(joint["axis"]))
        elif kind == "revolute":
            _add(body, "joint", at, name=name, type="hinge", axis=_text(joint["axis"]))
        elif kind == "spherical":
            _add(body, "joint", at, name=name, type="ball")
        elif kind == "universal":
            _add(body, "joint", at, name=name, type="hinge", axis=_text(joint["axis"]))
            _add(
                body,
                "joint",
                at,
                name=f"{name}.second",
                type="hinge",
                axis=_text(joint["second_axis"]),
            )
        elif kind == "free":
            ET.SubElement(body, "freejoint", name=name)
        elif kind not in ("fixed", "driven"):
            raise OutputError("MuJoCo has no such joint", where=name, found=kind)

    @staticmethod
    def _inertial(body: ET.Element, given: dict[str, Any]) -> None:
        xx, yy, zz, xy, xz, yz = (
            given["inertia"][name] for name in ("xx", "yy", "zz", "xy", "xz", "yz")
        )
        moments = {"diaginertia": "1 1 1"}  # for a body that only heaves
        if xx + yy + zz > 0.0:
            low, middle, high = np.linalg.eigvalsh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
            more = max(
                0.0, high - (low + middle) * (1.0 - _ROUNDING)
            )  # thin plates: MuJoCo has no rounding tolerance
            moments = {"fullinertia": _text((xx + more, yy + more, zz + more, xy, xz, yz))}
        _add(
            body, "inertial", moments, pos=_text(given["centre_of_mass"]), mass=_text(given["mass"])
        )

    def _close(self, listed: dict[str, Any], bodies: dict[str, ET.Element]) -> None:
        """Close loops: coincident points, rods, and points on a line through a slider of negligible mass."""
        soft = {"solref": f"{_text(_STIFF * STEP)} 1", "solimp": "0.9999 0.9999 0.001"}
        for loop in listed["closures"]:
            name, kind = loop["name"], loop["kind"]
            ends = {"body1": self._body(loop["first"]), "body2": self._body(loop["second"])}
            if kind == "point to point":
                _add(self._equality, "connect", ends, soft, name=name, anchor=_text(loop["at"]))
            elif kind == "rod":
                self._rod(name, loop, bodies, soft)
            elif kind == "point on line":
                slider = ET.SubElement(bodies[loop["first"]], "body", name=name)
                ET.SubElement(slider, "joint", name=name, type="slide", axis=_text(loop["axis"]))
                ET.SubElement(
                    slider,
                    "inertial",
                    pos=_text(loop["point"]),
                    mass="0.01",
                    diaginertia="1e-5 1e-5 1e-5",
                )
                ends["body1"] = name
                _add(self._equality, "connect", ends, soft, name=name, anchor=_text(loop["point"]))
                self._say("exchange.sliding_body", name)
            else:
                raise OutputError("MuJoCo has no such constraint", where=name, found=kind)

    @staticmethod
    def _body(name: str) -> str:
        return "world" if name == "ground" else name

    def _rod(
        self, name: str, loop: dict[str, Any], bodies: dict[str, ET.Element], soft: dict[str, str]
    ) -> None:
        """Add a tendon whose length stays at its design value."""
        tendon = ET.SubElement(self._tendon, "spatial", name=name)
        for end, body, place in (
            ("first", loop["first"], loop["at"]),
            ("second", loop["second"], loop["second_at"]),
        ):
            site = f"{name}.{end}"
            ET.SubElement(bodies[body], "site", name=site, pos=_text(place))
            ET.SubElement(tendon, "site", site=site)
        _add(self._equality, "tendon", soft, name=name, tendon1=name, polycoef="0 0 0 0 0")

    # --- springs, dampers, tyre

    def _line(self, name: str, element: str, **laws: str) -> None:
        """Add a tendon along an element of the strut."""
        given = self.rig.hardpoints.given()
        tendon = _add(self._tendon, "spatial", laws, name=name)
        for end in ("bottom", "top"):
            site = f"{element}_{end}"
            ET.SubElement(tendon, "site", site=site if site in given else f"strut_{end}")

    def _strut(self) -> None:
        strut, points = self.rig.strut, self.rig.hardpoints
        rate, force = self._spring_at_design()
        self._line(
            "spring",
            "spring",
            stiffness=_text(rate),
            springlength=_text(points.length("spring") + force / rate),
        )
        friction = {} if strut.friction is None else {"frictionloss": _text(strut.friction.force)}
        self._line("damper", "damper", damping=_text(self._coefficient()), **friction)
        design = points.length("spring")
        for name, side in (("bump_stop", -1.0), ("rebound_stop", 1.0)):
            stop: BumpStop | None = getattr(strut, name)
            if stop is None:
                continue
            edge = max(design + side * stop.gap, 1e-6)
            free = (edge, _FAR) if side < 0.0 else (0.0, edge)
            self._line(name, "spring", stiffness=_text(stop.rate), springlength=_text(free))
            if stop.progression:
                self._say("exchange.no_progression", f"strut.{name}")

    def _spring_at_design(self) -> tuple[float, float]:
        """Return rate (N/m) and force (N) of the spring at design."""
        spring = self.rig.strut.spring
        compressed = (
            0.0
            if spring.free_length is None
            else spring.free_length - self.rig.hardpoints.length("spring")
        )
        if spring.rate is not None:
            return spring.rate, spring.rate * compressed + (spring.preload or 0.0)
        assert spring.curve is not None
        rate, force = self._tangent(spring.curve, compressed, "strut.spring")
        return rate, force + (spring.preload or 0.0)

    def _tangent(self, curve: Curve, x: float, where: str) -> tuple[float, float]:
        """Return rate (N/m) and force (N) of a curve at a deflection (m); refuse curves without a positive rate."""
        low, force, high = (force_at(curve, x + side * _SMALL) for side in (-1.0, 0.0, 1.0))
        rate = (high - low) / (2.0 * _SMALL)
        if not rate > 0.0:
            raise OutputError(
                "a curve without a rate at design",
                where=where,
                found=f"{rate + 0.0:g} N/m",
                allowed="above 0",
            )
        self._say("exchange.straight_line", where)
        return rate, force

    def _coefficient(self) -> float:
        """Return the coefficient of the damper, N s/m."""
        damper = self.rig.strut.damper
        if isinstance(damper, LinearDamper):
            return damper.coefficient
        if damper.hysteretic:
            raise OutputError(
                "MuJoCo has no damper with hysteresis", where="strut.damper", found=damper.kind,
                allowed="linear, bilinear, blow-off, table, map",
            )  # fmt: skip
        mean = damper.at_length(self.rig.hardpoints.length("damper")).mean_coefficient(_SLOW)
        self._say("exchange.mean_damper", "strut.damper", coefficient=mean)
        return mean

    def _tyre(self) -> None:
        """Add the tyre as a compressive force between road and wheel centre."""
        tyre, radius = self.rig.tyre, self.rig.undeformed_radius
        if tyre.stiffness is not None:
            stiffness = tyre.stiffness
        else:
            assert tyre.curve is not None
            height = self.rig.hardpoints.wheel_centre[2]
            stiffness, force = self._tangent(tyre.curve, radius - height, "tyre")
            radius = height + force / stiffness
        if getattr(tyre, "law", "vertical") == "radial":
            self._say("exchange.tyre_by_height", "tyre.law")
        if tyre.damping_coefficient:
            self._say("exchange.road_rate", "tyre.damping_coefficient")
        limits = {"forcerange": f"0 {_text(1e9)}"} if tyre.lift_off else {}
        _add(
            self._actuator, "general", limits, name="tyre", site="wheel_centre", refsite="road", gear="0 0 1 0 0 0",
            gaintype="fixed", gainprm=_text(tyre.damping_coefficient), biastype="affine",
            biasprm=_text((stiffness * radius, -stiffness, -tyre.damping_coefficient)),
        )  # fmt: skip

    def _watch(self, listed: dict[str, Any]) -> None:
        ET.SubElement(
            self._sensor, "framepos", name="wheel_centre", objtype="site", objname="wheel_centre"
        )
        ET.SubElement(self._sensor, "actuatorfrc", name="tyre.force", actuator="tyre")
        ET.SubElement(self._sensor, "tendonpos", name="strut.length", tendon="spring")
        if any(joint["name"] == "sprung" for joint in listed["joints"]):
            ET.SubElement(self._sensor, "jointpos", name="sprung.z", joint="sprung")

    def _note_rest(self) -> None:
        """Add findings on parts of the rig that the file omits."""
        left = [
            name
            for name in ("anti_roll_bar", "torsion_bar", "third_spring")
            if getattr(self.rig, name, None)
        ]
        if left:
            self._say("exchange.not_in_file", "rig", names=", ".join(left))
