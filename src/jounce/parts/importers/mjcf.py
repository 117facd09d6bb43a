"""Import of MuJoCo models (MJCF) of suspensions as 3-D rigs: points by name and by structure."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Any, cast
from xml.etree import ElementTree as ET

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.files import content_of, existing_file
from jounce.core.findings import finding
from jounce.core.markup import parse_xml
from jounce.core.operation import File, Mark, operation
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.parts.corners import Corner
from jounce.parts.files import RIGS, rig_from_table, rig_text
from jounce.parts.importers.drafts import (
    NAMES_IN_FILE,
    SPRUNG_MASS,
    TYRE_STIFFNESS,
    Draft,
    ImportedRig,
    as_table,
    length_of_tyre,
    rig_of,
    sprung_mass_of,
    tensor_of,
)
from jounce.parts.importers.hardpoints import PointReading, names_of_points
from jounce.parts.importers.points import AXLE_END, PointRow, PointTable

_LARGEST = 20_000_000  # bytes: far above the size of real files; protects memory
_DEEPEST = 200  # maximum nesting of bodies
_ARM = 0.1  # m: distance of generated axis points from a hinge
_FAR = 100.0  # m: tendon lengths above it mean no limit
_LENGTHS = 2  # a pair: two ends of a tendon, two lengths of its dead band
_CARRIERS = {
    body for kind in Corner.__subclasses__() for body in (*kind.strut_on, *kind.pushrod_on)
} - {"rocker"}
_UNREAD = ("frame", "replicate", "attach", "composite")
"""Elements that hold bodies and sites at places of their own; MuJoCo writes them as bodies when it saves a model."""
_CHANGING = {"inertiafromgeom": "auto", "settotalmass": "-1", "boundmass": "0", "boundinertia": "0"}
"""What MuJoCo may make other masses from than a body's own, and how it is left alone."""
_TURNS = ("quat", "euler", "axisangle", "xyaxes", "zaxis")
_LAWS = ("stiffness", "damping", "frictionloss", "springlength")
_Ball = tuple[str, str, Array]


@dataclass
class _Body:
    """Body in world axes: position, axes as columns, mass properties, and parent body."""

    name: str
    parent: str
    place: Array
    axes: Array
    mass: dict[str, Any] | None = None
    joints: list[tuple[str, str, Array, Array]] = field(
        default_factory=list
    )  # name, type, place, axis


@operation(
    "import mjcf",
    named={"path": "file", "names": "name"},
    echo={"file": "file"},
    offers=("imported_rig",),
    page="jounce.report.exchange:imported_rig_page",
    title="{out}",
    doing="reading the file",
    example="jounce import mjcf corner.xml --out rig.toml",
    python_only=("source",),
)
def import_mjcf(
    path: Annotated[Path | str, File("Model of MuJoCo with one corner of a car.", "FILE.xml")],
    *,
    names: Annotated[Mapping[str, str] | None, NAMES_IN_FILE] = None,
    model: Annotated[
        str | None, Mark("Suspension. Default: the one that has these points.")
    ] = None,
    wheel_radius: Annotated[float | None, length_of_tyre("that of the tyre")] = None,
    sprung_mass: Annotated[float | None, sprung_mass_of("that of the body in the file")] = None,
    source: str | None = None,
) -> ImportedRig:
    """Convert a model of MuJoCo (MJCF) whose bodies are a suspension to the left corner of a 3-D rig.

    Points are sites, joints and constraints with the names of hardpoint tables. Unnamed points follow from the
    structure: two arms on hinges, connected to an upright by ball joints, a tie rod and a spring. With bodies named as
    in rigs, springs and dampers as spatial tendons, and a tyre as exported by jounce, the rig can be simulated;
    otherwise it supports only kinematics. x must point forward or rearward, z up.

    Parameters
    ----------
    path : Path or str
        The complete ``.xml`` file (without ``include``).
    names : mapping, optional
        jounce's name for each name in the file.
    model : str, optional
        Suspension model; by default the one with these points.
    wheel_radius : float, optional
        Undeformed radius of the tyre [m]; by default that of the tyre, or the height of the wheel centre.
    sprung_mass : float, optional
        Sprung mass on this wheel [kg]; by default that of the body that carries the arms.
    source : str, optional
        Text for ``source`` of the rig; by default the name of the file.

    Returns
    -------
    rig : Corner
        The left corner.
    findings : list of Finding
        Assumptions, omissions and estimates.
    text : str
        Text of the rig file.

    Raises
    ------
    DescriptionError
        For a missing file, a file that is not MJCF, unsupported definitions of positions, a tree that is not a
        suspension, or missing or duplicate points.

    Examples
    --------
    >>> import tempfile
    >>> file = Path(tempfile.mkdtemp()) / "pendulum.xml"
    >>> _ = file.write_text("<mujoco><worldbody><body><joint type='hinge'/></body></worldbody></mujoco>")
    >>> import_mjcf(file)   # doctest: +ELLIPSIS
    Traceback (most recent call last):
    jounce.core.errors.DescriptionError: ... the file contains no points...
    """
    reading = _Tree(existing_file(path), dict(names or {}))
    return reading.rig(model, wheel_radius, sprung_mass, source)


class _Tree:
    """Converts a file to a rig."""

    def __init__(self, file: Path, names: dict[str, str]) -> None:
        if file.stat().st_size > _LARGEST:
            raise DescriptionError(
                "too large for a suspension", where=str(file), allowed="up to 20 MB"
            )
        self.file, self.names, self.draft = file, names, Draft(file)
        self.root = _parse(file)
        given: dict[str, str] = {}
        for compiler in self.root.findall("compiler"):  # several count as one
            given |= compiler.attrib
        self._turn = 1.0 if given.get("angle", "degree") == "radian" else np.pi / 180.0
        self._order = given.get("eulerseq", "xyz")
        if not re.fullmatch(r"[xyz]{3}|[XYZ]{3}", self._order):
            raise self._refusal(
                "an order of angles that is not read",
                self._order,
                "xyz, XYZ and the like",
                "eulerseq",
            )
        if given.get("coordinate", "local") != "local":
            raise self._refusal(
                "places in global coordinates",
                given["coordinate"],
                "local ones, as MuJoCo has since 2.3",
            )
        for word, without in _CHANGING.items():
            if given.get(word, without) != without and not _is_zero(given[word]):
                raise self._refusal(
                    "masses that are not those of the bodies",
                    f"{word} = {given[word]}",
                    without,
                    "compiler",
                )
        self._defaults: dict[str, dict[str, dict[str, str]]] = {"": {}}
        for element in self.root.findall("default"):
            self._keep_defaults(element, "", 0)
            self._defaults[""] = self._defaults[
                element.get("class", "main")
            ]  # the outermost class is everybody's
        self.sites: dict[str, tuple[Array, str]] = {}
        self.axle_end: Array | None = None
        self._known = names_of_points()
        self.bodies = {"world": _Body("world", "", np.zeros(3), np.eye(3))}
        worlds = self.root.findall("worldbody")
        if not worlds:
            raise self._refusal("not an MJCF file", None, "an element worldbody")
        for world in worlds:
            self._walk(world, "world", "", 0)

    def _refusal(self, what: str, found: object, allowed: str, where: str = "") -> DescriptionError:
        return DescriptionError(
            what,
            where=f"{self.file}: {where}" if where else str(self.file),
            found=found,
            allowed=allowed,
        )

    # --- the tree

    def _keep_defaults(self, element: ET.Element, above: str, depth: int) -> None:
        """Store attributes of elements by class and tag; nested classes inherit from the outer class."""
        if depth > _DEEPEST:
            raise self._refusal("classes nested too deeply", depth, f"up to {_DEEPEST}")
        own = {tag: dict(given) for tag, given in self._defaults[above].items()}
        for child in element:
            if child.tag != "default":
                own[child.tag] = own.get(child.tag, {}) | child.attrib
        name = element.get("class", "main" if depth == 0 else f"class {len(self._defaults)}")
        self._defaults[name] = own
        for child in element.findall("default"):
            self._keep_defaults(child, name, depth + 1)

    def _attributes_of(self, element: ET.Element, tag: str, inherited: str = "") -> dict[str, str]:
        """Return the attributes of an element, including those of its class."""
        name = element.get("class", inherited)
        if name not in self._defaults:
            raise self._refusal(
                "an unknown class",
                name,
                ", ".join(sorted(self._defaults)[1:]) or "none",
                element.tag,
            )
        return self._defaults[name].get(tag, {}) | element.attrib

    def _walk(self, element: ET.Element, name: str, inherited: str, depth: int) -> None:
        if depth > _DEEPEST:
            raise self._refusal("bodies nested too deeply", depth, f"up to {_DEEPEST}")
        here = self.bodies[name]
        for child in element:
            if child.tag == "site" and child.get("name"):
                self._add_site(child, here, inherited)
            elif child.tag in ("joint", "freejoint"):
                self._add_joint(child, here, inherited)
            elif child.tag == "inertial":
                here.mass = self._inertial(child, here)
            elif child.tag == "body":
                own = child.get("name") or f"body {len(self.bodies)}"
                if own in self.bodies:
                    raise self._refusal("two bodies have the same name", own, "every name once")
                axes = here.axes @ self._axes(child)
                self.bodies[own] = _Body(
                    own, name, here.place + here.axes @ self._three(child, "pos"), axes
                )
                self._walk(child, own, child.get("childclass", inherited), depth + 1)
            elif child.tag in _UNREAD:
                raise self._refusal(
                    f"{child.tag} is not read",
                    child.get("name"),
                    "bodies, joints and sites",
                    f"body {name}",
                )

    def _ours(self, name: str) -> str:
        """Return jounce's name of a point; empty if unknown."""
        return self.names.get(
            name, self._known.get(" ".join(name.lower().replace("_", " ").split()), "")
        )

    def _add_site(self, child: ET.Element, here: _Body, inherited: str) -> None:
        """Store a site; a rotated site of the wheel centre defines the wheel's axis by its z axis."""
        given = self._attributes_of(child, "site", inherited)
        name = child.get("name", "")
        if name in self.sites:
            raise self._refusal("two sites have the same name", name, "every name once")
        if "fromto" in given:
            raise self._refusal(
                "a site between two places", given["fromto"], "pos", f"site {name}: fromto"
            )
        place = here.place + here.axes @ self._numbers(
            given.get("pos", "0 0 0"), 3, f"site {name}: pos"
        )
        self.sites[name] = place, here.name
        if any(word in given for word in _TURNS) and self._ours(name) == "wheel_centre":
            self.axle_end = place + here.axes @ self._axes(ET.Element("site", given))[:, 2]

    def _add_joint(self, child: ET.Element, here: _Body, inherited: str) -> None:
        given = self._attributes_of(child, "joint", inherited)
        kind = "free" if child.tag == "freejoint" else given.get("type", "hinge")
        place = here.place + here.axes @ self._numbers(given.get("pos", "0 0 0"), 3, "joint: pos")
        where = f"joint {child.get('name', '')}"
        axis = self._direction(
            here.axes @ self._numbers(given.get("axis", "0 0 1"), 3, f"{where}: axis"), where
        )
        here.joints.append((child.get("name", ""), kind, place, axis))
        left = [
            key
            for key in ("stiffness", "damping", "frictionloss")
            if given.get(key, "0").strip("0. ")
        ]
        if left:
            self.draft.findings.append(
                finding("parts.import_left_out", self.draft.at(where), names=", ".join(left))
            )

    def _direction(self, vector: Array, where: str) -> Array:
        size = float(np.linalg.norm(vector))
        if size < 1e-9:
            raise self._refusal("an axis without direction", vector.tolist(), "not all zero", where)
        return np.asarray(vector / size)

    def _numbers(self, text: str, count: int, where: str) -> Array:
        try:
            numbers = np.array([float(word) for word in text.split()])
        except ValueError:
            numbers = np.full(0, np.nan)
        if len(numbers) != count or not np.all(np.isfinite(numbers)):
            raise self._refusal("unexpected numbers", text[:80], f"{count} numbers", where)
        return numbers

    def _several(self, given: Mapping[str, str], key: str, where: str) -> list[float]:
        """Return the numbers of an attribute, at least one; default 0, or -1 for lengths."""
        text = given.get(key, "-1" if key == "springlength" else "0")
        return [float(x) for x in self._numbers(text, max(len(text.split()), 1), f"{where}: {key}")]

    def _three(self, element: ET.Element, key: str) -> Array:
        return self._numbers(
            element.get(key, "0 0 0"), 3, f"{element.tag} {element.get('name', '')}: {key}"
        )

    def _axes(self, element: ET.Element) -> Array:
        """Return the axes of a frame as columns, from a quaternion, angles, an axis and an angle, or two axes."""
        from scipy.spatial.transform import Rotation

        where = f"{element.tag} {element.get('name', '')}"
        if "quat" in element.attrib:
            w, x, y, z = self._numbers(element.attrib["quat"], 4, f"{where}: quat")
            if not np.any([w, x, y, z]):
                raise self._refusal(
                    "a quaternion of zeros", element.attrib["quat"], "not all zero", where
                )
            return np.asarray(Rotation.from_quat([x, y, z, w]).as_matrix())
        if "euler" in element.attrib:
            angles = self._turn * self._numbers(element.attrib["euler"], 3, f"{where}: euler")
            order = self._order.swapcase()  # small letters turn with the body there, capitals here
            return np.asarray(Rotation.from_euler(order, angles).as_matrix())
        if "axisangle" in element.attrib:
            *turned, angle = self._numbers(element.attrib["axisangle"], 4, f"{where}: axisangle")
            return np.asarray(
                Rotation.from_rotvec(
                    self._direction(np.array(turned), where) * angle * self._turn
                ).as_matrix()
            )
        if "xyaxes" in element.attrib:
            six = self._numbers(element.attrib["xyaxes"], 6, f"{where}: xyaxes")
            x = self._direction(six[:3], where)
            y = self._direction(six[3:] - (six[3:] @ x) * x, where)
            return np.column_stack([x, y, np.cross(x, y)])
        if "zaxis" in element.attrib:
            z = self._direction(self._numbers(element.attrib["zaxis"], 3, f"{where}: zaxis"), where)
            across = np.array(
                [-z[1], z[0], 0.0]
            )  # turned the short way from z; about x where that is turned round
            size = float(np.linalg.norm(across))
            axis = across / size if size > 1e-10 else np.array([1.0, 0.0, 0.0])
            return np.asarray(Rotation.from_rotvec(axis * np.arctan2(size, z[2])).as_matrix())
        return np.eye(3)

    def _inertial(self, element: ET.Element, here: _Body) -> dict[str, Any] | None:
        mass = self._numbers(element.get("mass", ""), 1, "inertial: mass")[0]
        centre = here.place + here.axes @ self._three(element, "pos")
        if "fullinertia" in element.attrib:
            xx, yy, zz, xy, xz, yz = self._numbers(
                element.attrib["fullinertia"], 6, "inertial: fullinertia"
            )
            tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        else:
            tensor = np.diag(
                self._numbers(element.get("diaginertia", "0 0 0"), 3, "inertial: diaginertia")
            )
        axes = here.axes @ self._axes(element)
        return as_table(float(mass), centre, axes @ tensor @ axes.T) if mass > 0.0 else None

    # --- points

    def _balls(self) -> Iterator[_Ball]:
        """Yield pairs of bodies and their common point: ball joints and connections."""
        for body in self.bodies.values():
            for _, kind, place, _ in body.joints:
                if kind == "ball":
                    yield body.parent, body.name, place
        for connection in self.root.iter("connect"):
            names = connection.get("body1", ""), connection.get("body2", "world")
            if connection.get("site1") in self.sites:
                place, first = self.sites[connection.get("site1", "")]
                yield first, self.sites.get(connection.get("site2", ""), (place, "world"))[1], place
            elif names[0] in self.bodies and names[1] in self.bodies:
                here = self.bodies[names[0]]
                yield names[0], names[1], here.place + here.axes @ self._three(connection, "anchor")

    def _tendons(self) -> dict[str, tuple[dict[str, str], list[str]]]:
        """Return spatial tendons between two sites: attributes and site names."""
        tendons: dict[str, tuple[dict[str, str], list[str]]] = {}
        for tendon in self.root.iter("spatial"):
            sites = [site.get("site", "") for site in tendon if site.tag == "site"]
            if len(sites) == _LENGTHS and all(site in self.sites for site in sites):
                tendons[tendon.get("name", f"tendon {len(tendons)}")] = (
                    self._attributes_of(tendon, "tendon"),
                    sites,
                )
        return tendons

    def table(self) -> PointTable:
        """Return named points, and points derived from the structure."""
        table = PointTable(self.file, unit="m")
        named = {}
        for name, (place, _) in self.sites.items():
            named[name] = place
        for body in self.bodies.values():
            for name, kind, place, _ in body.joints:
                if name and kind == "ball":
                    named.setdefault(name, place)
        table.rows = [
            PointRow(name, place, f"{self.file}: {name}") for name, place in named.items()
        ]
        carriers = [
            self.sites[name][1] for name in ("pushrod_outer", "strut_bottom") if name in self.sites
        ]
        table.carrier = carriers[0] if carriers and carriers[0] in _CARRIERS else ""
        if self.axle_end is not None:
            table.rows.append(
                PointRow(AXLE_END, self.axle_end, f"{self.file}: zaxis of the wheel centre")
            )
        own = {self._ours(name) for name in named}
        for name, place in self._by_structure():
            if name not in own:
                table.rows.append(PointRow(name, place, f"{self.file}: structure"))
                note = finding(
                    "parts.import_from_structure", str(self.file), name=name, place=place.tolist()
                )
                table.notes.append(note)
        return table

    def _by_structure(self) -> Iterator[tuple[str, Array]]:
        """Yield points of two arms on hinges with a common upright, its tie rod and wheel, and of the spring."""
        balls = list(self._balls())
        hinges = {
            b.name: b.joints[0]
            for b in self.bodies.values()
            if len(b.joints) == 1 and b.joints[0][1] == "hinge"
        }

        def neighbours(name: str) -> Iterator[tuple[str, Array]]:
            for first, second, place in balls:
                if name in (first, second):
                    yield (second if first == name else first), place

        shared: dict[str, list[tuple[str, Array]]] = {}
        for arm in hinges:
            for other, place in neighbours(arm):
                if other not in hinges and other != self.bodies[arm].parent:
                    shared.setdefault(other, []).append((arm, place))
        upright = max(shared, key=lambda name: len(shared[name]), default="")
        arms = sorted(shared.get(upright, []), key=lambda arm: float(arm[1][2]))
        for (arm, ball), ours in zip(arms, ("lower", "upper"), strict=False):
            _, _, place, axis = hinges[arm]
            ahead = axis if axis[0] >= 0.0 else -axis
            yield f"{ours}_ball_joint", ball
            yield f"{ours}_arm_front", place + _ARM * ahead
            yield f"{ours}_arm_rear", place - _ARM * ahead
        if not upright:
            return
        for body in self.bodies.values():
            if body.parent == upright and body.joints and body.joints[0][1] == "hinge":
                yield "wheel_centre", body.joints[0][2]
        for rods in (*self._rods(), *self._links(balls, upright)):
            if upright in (rods[0][1], rods[1][1]):
                outer, inner = rods if rods[0][1] == upright else rods[::-1]
                yield "tie_rod_outer", outer[0]
                yield "tie_rod_inner", inner[0]
        for given, sites in self._tendons().values():
            if self._several(given, "stiffness", "tendon")[0] > 0.0:
                low, high = sorted(
                    (self.sites[site] for site in sites), key=lambda site: float(site[0][2])
                )
                yield "strut_bottom", low[0]
                yield "strut_top", high[0]
                return

    def _rods(self) -> Iterator[tuple[tuple[Array, str], tuple[Array, str]]]:
        """Yield tendons of constant length."""
        tendons = self._tendons()
        for equality in self.root.iter("equality"):
            for held in equality.iter("tendon"):
                if held.get("tendon1") in tendons:
                    first, second = tendons[held.get("tendon1", "")][1]
                    yield self.sites[first], self.sites[second]

    @staticmethod
    def _links(
        balls: list[_Ball], upright: str
    ) -> Iterator[tuple[tuple[Array, str], tuple[Array, str]]]:
        """Yield bodies between two ball joints, one of them on the upright."""
        for first, second, outer in balls:
            if upright not in (first, second):
                continue
            link = second if first == upright else first
            ends = [(a if b == link else b, place) for a, b, place in balls if link in (a, b)]
            others = [(place, name) for name, place in ends if name != upright]
            if len(ends) == _LENGTHS and len(others) == 1:
                yield (outer, upright), others[0]

    # --- the rig

    def rig(
        self,
        model: str | None,
        wheel_radius: float | None,
        sprung_mass: float | None,
        source: str | None,
    ) -> ImportedRig:
        """Return the rig, its findings, and the text of its file."""
        table = self.table()
        if not table.rows:
            raise self._refusal(
                "the file contains no points",
                None,
                "sites named like hardpoints, or two arms with an upright",
            )
        tyre = self._tyre()
        if tyre is not None:
            radius = tyre.pop("radius")
            wheel_radius = radius if wheel_radius is None else wheel_radius
        reading = PointReading(table, "left", None, self.names)
        before = {name: np.array(point) for name, point in reading.points.items()}
        rig, findings, text = reading.rig(None, None, model, wheel_radius, source)
        whole = self._whole(rig, before, reading.points, tyre, sprung_mass)
        self.draft.findings = findings + self.draft.findings
        if whole is None:
            return ImportedRig(rig, self.draft.findings, text)
        made = rig.model_dump(
            by_alias=True,
            exclude_none=True,
            include={"schema_", "model", "source", "side", "hardpoints", "wheel"},
        )
        strut = rig.strut.model_dump(exclude_none=True, include={"on", "pushrod_on"})
        if table.carrier and rig.strut.on != "rocker":
            strut["on"] = table.carrier
        estimated = sorted({*rig.estimated, *self.draft.estimated})
        made |= {**whole, "estimated": estimated, "strut": {**strut, **whole["strut"]}}
        comments = [
            f"Left corner from {self.file.name} of MuJoCo.",
            *(finding.message for finding in self.draft.findings),
        ]
        text = rig_text(rig_of(self.draft, made), comments)
        whole_rig = cast(Corner, rig_from_table(tomllib.loads(text), where=str(self.file)))
        return ImportedRig(whole_rig, self.draft.findings, text)

    def _whole(
        self,
        rig: Corner,
        before: Mapping[str, Array],
        after: Mapping[str, Array],
        tyre: dict[str, Any] | None,
        sprung_mass: float | None,
    ) -> dict[str, Any] | None:
        """Return masses, strut and tyre, or None if the file lacks them."""
        kind = RIGS[rig.model]  # type: ignore[attr-defined]
        assert issubclass(kind, Corner)
        masses = {name: body.mass for name, body in self.bodies.items() if body.mass is not None}
        needed = [name for name in kind.needed_bodies if name not in masses]
        spring = self._spring()
        if needed or spring is None or not rig.has_strut:
            strut = [] if rig.has_strut else ["strut_bottom", "strut_top"]
            lacking = [*needed, *([] if spring is not None else ["a spring"]), *strut]
            self.draft.note("parts.import_lacks", self.draft.at("bodies"), names=", ".join(lacking))
            return None
        flip = np.diag([_sign(before, after, axis) for axis in range(2)] + [1.0])
        up = after["wheel_centre"] - flip @ before["wheel_centre"]
        bodies = {
            name: _mirror_mass(masses[name], flip, up)
            for name in (*kind.needed_bodies, *kind.further_bodies)
            if name in masses
        }
        left = [
            name
            for name in masses
            if name not in bodies and name != "sprung" and self.bodies[name].parent != "world"
        ]
        if left:
            self.draft.note(
                "parts.import_bodies_left_out", self.draft.at("bodies"), names=", ".join(left)
            )
        chassis = masses.get("sprung") or next(
            (m for n, m in masses.items() if self.bodies[n].parent == "world" and n not in bodies),
            None,
        )
        if sprung_mass is None:
            sprung_mass = SPRUNG_MASS if chassis is None else float(chassis["mass"])
            if chassis is None:
                self.draft.estimated.append("sprung.mass")
                self.draft.note(
                    "parts.import_mass_assumed", self.draft.at("sprung.mass"), mass=SPRUNG_MASS
                )
        if tyre is None:
            tyre = {"stiffness": TYRE_STIFFNESS}
            self.draft.estimated.append("tyre.stiffness")
            self.draft.note("parts.import_tyre_assumed", self.draft.at("tyre"), rate=TYRE_STIFFNESS)
        return {
            "guide": "vertical",
            "bodies": bodies,
            "strut": spring,
            "tyre": tyre,
            "sprung": {"mass": sprung_mass},
        }

    def _spring(self) -> dict[str, Any] | None:
        """Return spring, damper, friction and stops from tendons with stiffness or damping; None without a spring."""
        spring: dict[str, Any] | None = None
        stops: dict[str, Any] = {}
        damping = friction = 0.0
        for name, (given, sites) in self._tendons().items():
            rates, dampings, losses, lengths = (
                self._several(given, key, f"tendon {name}") for key in _LAWS
            )
            rate = rates[0]
            if any(rates[1:]) or any(dampings[1:]):
                self.draft.findings.append(finding("parts.import_polynomial", self.draft.at(name)))
            length = float(np.linalg.norm(self.sites[sites[0]][0] - self.sites[sites[1]][0]))
            if rate > 0.0 and len(lengths) == _LENGTHS:  # a dead band: it works beyond either end
                for stop, gap in (
                    ("bump_stop", length - lengths[0]),
                    ("rebound_stop", lengths[1] - length),
                ):
                    if lengths[0] > 0.0 if stop == "bump_stop" else lengths[1] < _FAR:
                        stops[stop] = {"gap": gap, "rate": rate}
            elif rate > 0.0 and spring is None:
                spring = {"rate": rate, "free_length": lengths[0] if lengths[0] > 0.0 else length}
            elif rate > 0.0:
                self.draft.note("parts.import_further_spring", self.draft.at(name))
            damping += dampings[0]
            friction += losses[0]
        if spring is None:
            return None
        further = {"friction": {"force": friction}} if friction else {}
        return {"spring": spring, "damper": {"coefficient": damping}, **further, **stops}

    def _tyre(self) -> dict[str, Any] | None:
        """Return the tyre from an actuator between road and wheel that acts along z, or None."""
        for actuator in self.root.iter("general"):
            given = self._attributes_of(actuator, "general")
            if (
                given.get("biastype") == "affine"
                and given.get("refsite")
                and given.get("gear", "").split()[:3] == ["0", "0", "1"]
            ):
                # MuJoCo omits trailing zeros when it saves a model.
                force, rate, damping = [*self._several(given, "biasprm", "actuator"), 0.0, 0.0][:3]
                if force > 0.0 > rate:
                    return {
                        "stiffness": -rate,
                        "damping_coefficient": -damping,
                        "radius": -force / rate,
                    }
        return None


def _sign(before: Mapping[str, Array], after: Mapping[str, Array], axis: int) -> float:
    """Return -1 if the table was reversed along an axis, else 1."""
    products = [before[name][axis] * after[name][axis] for name in before if name in after]
    return -1.0 if min(products, default=0.0) < 0.0 else 1.0


def _is_zero(text: str) -> bool:
    """Whether a text is a number not above 0, which means none."""
    try:
        return float(text) <= 0.0
    except ValueError:
        return False


def _mirror_mass(table: dict[str, Any], flip: Array, up: Array) -> dict[str, Any]:
    """Mirror and move mass properties."""
    centre = flip @ np.array(table["centre_of_mass"]) + up
    return as_table(table["mass"], centre, flip @ tensor_of(table) @ flip)


def _parse(file: Path) -> ET.Element:
    try:
        root = parse_xml(content_of(file))
    except (ET.ParseError, ValueError, LookupError, RecursionError) as error:
        raise DescriptionError(
            Phrase("not XML: {error}", error=str(error)), where=str(file), allowed="MJCF"
        ) from None
    if root.tag != "mujoco":
        raise DescriptionError(
            "not an MJCF file", where=str(file), found=f"<{root.tag}>", allowed="<mujoco>"
        )
    if next(root.iter("include"), None) is not None:
        raise DescriptionError(
            "the file includes other files",
            where=str(file),
            allowed="one file",
            hint="Save the whole model with MuJoCo first.",
        )
    return root
