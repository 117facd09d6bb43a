"""Import of Adams Car subsystems (``.sub``) as 3-D rigs: hardpoints, bodies, and property files."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path, PureWindowsPath
from typing import Annotated, Any, cast
from xml.etree import ElementTree as ET

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.files import content_of
from jounce.core.findings import finding
from jounce.core.markup import parse_xml
from jounce.core.operation import File, Switch, operation
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.parts.corners import Corner
from jounce.parts.files import RIGS, rig_from_table, rig_text
from jounce.parts.importers.drafts import (
    CARRIED_MASS,
    NAMES_IN_FILE,
    SPRUNG_MASS,
    TYRE_RADIUS,
    WHEEL_RADIUS,
    Draft,
    ImportedRig,
    TyreStiffness,
    WheelMass,
    add_wheel,
    as_table,
    join_bodies,
    raise_rig,
    rig_of,
    set_on_the_road,
    tensor_of,
)
from jounce.parts.importers.hardpoints import PointReading, names_of_points
from jounce.parts.importers.points import PointRow, PointTable
from jounce.parts.importers.teim_orbit import Block, TeimOrbit, number, read_teim_orbit

_OURS = np.diag([-1.0, -1.0, 1.0])
"""Rotation from Adams Car's axes (x rearward, y to the right, z up) to jounce's."""
_BODIES = {
    "lower_arm": ("lower_control_arm", "lca", "lower_arm"),
    "upper_arm": ("upper_control_arm", "uca", "upper_arm"),
    "upright": ("upright", "knuckle", "hub_carrier", "lower_strut"),
    "tie_rod": ("tierod", "tie_rod", "tierod_inner", "tierod_outer"),
    "wheel": ("spindle", "hub"),
    "strut": ("upper_strut", "strut"),
    "arm": ("trailing_arm", "control_arm"),
    "rocker": ("bell_crank", "bellcrank", "rocker"),
}
"""Parts of Adams templates for each jounce body; several parts may form one body."""
_CORNERS = {
    "lower_arm": ("lower_arm_front", "lower_arm_rear", "lower_ball_joint"),
    "upper_arm": ("upper_arm_front", "upper_arm_rear", "upper_ball_joint"),
    "upright": (
        "lower_ball_joint",
        "upper_ball_joint",
        "tie_rod_outer",
        "wheel_centre",
        "strut_bottom",
    ),
    "arm": ("arm_inner", "arm_outer", "wheel_centre"),
    "rocker": ("rocker_pivot", "pushrod_inner", "strut_bottom"),
}
_MASSES = {"lower_arm": 4.0, "upper_arm": 2.0, "upright": 8.0, "arm": 12.0, "rocker": 1.0}
"""Default masses of bodies missing in the file, kg, for a passenger car."""
_SPRING_RATE, _DAMPING = 30e3, 2000.0  # N/m, N s/m: defaults for missing property files
_SYMMETRIES = ("left/right", "left", "right", "single")
_STOPS = {"bump_stop": ("jounce", "bump"), "rebound_stop": ("rebound",)}
_SIX = ("FX", "FY", "FZ", "TX", "TY", "TZ")
_LINEAR = 1e-3  # tolerance for a constant spring rate, relative to the largest force
_POINT = re.compile(r"(?i)x,\s*y,\s*z\s+location\s*=\s*(.+)")
_VECTOR = re.compile(r"(?i)([zx])p\s+vector\s*=\s*(.+)")


@operation(
    "import adams",
    named={"path": "file", "names": "name"},
    echo={"file": "file"},
    offers=("imported_rig",),
    page="jounce.report.exchange:imported_rig_page",
    title="{out}",
    doing="reading the file",
    example="jounce import adams database.cdb/subsystems.tbl/front.sub --out rig.toml",
    python_only=("source",),
)
def import_adams(
    path: Annotated[Path | str, File("Suspension subsystem of Adams Car, as text.", "FILE.sub")],
    *,
    names: Annotated[Mapping[str, str] | None, NAMES_IN_FILE] = None,
    wheel_radius: Annotated[float | None, TYRE_RADIUS] = None,
    wheel_mass: WheelMass = None,
    tyre_stiffness: TyreStiffness = None,
    sprung_mass: Annotated[float | None, CARRIED_MASS] = None,
    rigid: Annotated[bool, Switch("Leave the bushings out: the joints are ideal.")] = False,
    source: str | None = None,
) -> ImportedRig:
    """Convert a suspension subsystem of Adams Car, with its property files, to the left corner of a 3-D rig.

    The ``.sub`` contains hardpoints, parts with mass, camber and toe. Springs, dampers, stops and bushings are in the
    property files of its database (``springs.tbl``, ``dampers.tbl``, ``bumpstops.tbl``, ``bushings.tbl``) next to
    it. Adams Car's axes are x rearward and y to the right.

    Parameters
    ----------
    path : Path or str
        The ``.sub`` file.
    names : mapping, optional
        jounce's name for each hardpoint name in the file, for templates with custom names.
    wheel_radius : float, optional
        Undeformed radius of the tyre [m]; estimated 0.33 m.
    wheel_mass : float, optional
        Mass of rim and tyre [kg]; estimated 20 kg.
    tyre_stiffness : float, optional
        Radial stiffness [N/m]; estimated 250 kN/m.
    sprung_mass : float, optional
        Sprung mass on this wheel [kg]; estimated from the load of spring and stops at design position.
    rigid : bool
        Ignore bushings, as Adams Car does in kinematic mode: joints are ideal.
    source : str, optional
        Text for ``source`` of the rig; by default the name of the file.

    Returns
    -------
    rig : Corner
        ``DoubleWishbone``, ``McPherson`` or another suspension with these points.
    findings : list of Finding
        Assumptions, omissions and estimates.
    text : str
        Text of the rig file.

    Raises
    ------
    DescriptionError
        For a missing file or a different format, a subsystem that is not a suspension, unknown or missing points,
        points on the other side, missing units, or values that are not numbers.

    Examples
    --------
    >>> import tempfile
    >>> file = Path(tempfile.mkdtemp()) / "steering.sub"
    >>> _ = file.write_text("[SUBSYSTEM_HEADER]" + chr(10) + "MAJOR_ROLE = 'steering'")
    >>> import_adams(file)   # doctest: +ELLIPSIS
    Traceback (most recent call last):
    jounce.core.errors.DescriptionError: ... not a suspension; found 'steering'; allowed: suspension.
    """
    file = read_teim_orbit(path)
    header = file.first("SUBSYSTEM_HEADER")
    role = header.values.get("MAJOR_ROLE", "")
    if role.lower() != "suspension":
        raise DescriptionError(
            "the subsystem is not a suspension",
            where=header.where,
            found=role,
            allowed="suspension",
        )
    reading = _Subsystem(file, {**(names or {})})
    table = reading.table(wheel_radius, wheel_mass, tyre_stiffness, sprung_mass, rigid=rigid)
    draft = reading.draft
    default = f"{file.path.name}, subsystem of Adams Car"
    table |= {"estimated": sorted(draft.estimated), "source": default if source is None else source}
    comments = [
        f"Left corner imported from {file.path.name} of Adams Car. z = 0 is the road.",
        *(
            f"{item.place.removeprefix(str(file.path))}: {item.message}".removeprefix(": ")
            for item in draft.findings
        ),
    ]
    text = rig_text(rig_of(draft, table), comments)
    rig = cast(Corner, rig_from_table(tomllib.loads(text), where=str(path)))
    return ImportedRig(rig, draft.findings, text)


@dataclass
class _Subsystem:
    """Converts a subsystem to a rig."""

    file: TeimOrbit
    names: dict[str, str]
    draft: Draft = field(init=False)
    points: dict[str, Array] = field(init=False)

    def __post_init__(self) -> None:
        self.draft = Draft(self.file.path)
        self.length, self.force, self.mass = (
            self.file.unit(name) for name in ("LENGTH", "FORCE", "MASS")
        )
        self._used: set[str] = set()

    def table(
        self,
        radius: float | None,
        mass: float | None,
        stiffness: float | None,
        sprung_mass: float | None,
        *,
        rigid: bool = False,
    ) -> dict[str, Any]:
        """Return the table of the rig, with the wheel on the road."""
        reading = PointReading(self._hardpoints(), "left", None, self.names)
        model = reading.model_of(None)
        reading.complete(model)
        reading.turn("-x,-y,z")
        reading.scale(None)
        self.points = reading.points
        strut = reading.strut(model)
        self.draft.findings += reading.findings
        self.draft.estimated += reading.estimated
        kind = RIGS[model]
        assert issubclass(kind, Corner)
        if "strut_bottom" not in self.points:
            return self._of_points(model, strut, radius)
        strut.setdefault("on", kind.strut_on[0])
        names = [*kind.needed_bodies, *(("rocker",) if "rocker_pivot" in self.points else ())]
        in_file = self._bodies((*kind.needed_bodies, *kind.further_bodies), model)
        spindle = in_file.pop("wheel", None)
        bodies = {
            **{name: self._estimate_body(name) for name in names if name not in in_file},
            **in_file,
        }
        table: dict[str, Any] = {
            "schema": "jounce.rig/1", "model": model, "source": "", "estimated": [], "side": "left",
            "guide": "vertical", "hardpoints": dict(self.points), "bodies": bodies,
            "strut": {**strut, "spring": self._spring(), "damper": self._damper(), **self._stops()},
        }  # fmt: skip
        if (
            "tie_rod_inner" in self.points
            and self.file.first("SUBSYSTEM_HEADER").values.get("MINOR_ROLE") != "rear"
        ):
            table["steering"] = {"rack_travel": 0.0}
        bushings = {} if rigid else self._bushings(kind.bushed)
        if bushings:
            table["bushings"] = bushings
        add_wheel(self.draft, table, spindle, self._angles(), (radius, mass, stiffness))
        self._note_rest()
        set_on_the_road(self.draft, table, sprung_mass)
        return table

    def _of_points(self, model: str, strut: dict[str, Any], radius: float | None) -> dict[str, Any]:
        """Return the table of a rig for kinematics only: without a strut, nothing carries the car."""
        self.draft.note("parts.import_kinematics_only", self.draft.at("HARDPOINT"))
        if radius is None:
            self.draft.estimated.append("wheel.radius")
            radius = WHEEL_RADIUS
        table: dict[str, Any] = {
            "schema": "jounce.rig/1", "model": model, "source": "", "estimated": [], "side": "left",
            "wheel": {"radius": radius, **self._angles()}, "strut": strut,
            "hardpoints": dict(self.points), "bodies": {},
        }  # fmt: skip
        raise_rig(table, radius - float(self.points["wheel_centre"][2]))
        return table

    def _hardpoints(self) -> PointTable:
        table = PointTable(self.file.path, unit="m")
        for block in self.file.blocks_of("HARDPOINT"):
            for cells, where in block.rows:
                if len(cells) != 5 or cells[1].lower() not in _SYMMETRIES:
                    raise DescriptionError(
                        "not a hardpoint", where=where, found=" ".join(cells)[:80],
                        allowed="name, symmetry (left/right, left, right or single), x, y and z",
                    )  # fmt: skip
                symmetry = cells[1].lower()
                place = self.length * np.array([number(cell, where) for cell in cells[2:]])
                side = {"left/right": "left"}.get(symmetry, symmetry)
                if (
                    side in ("left", "right")
                    and place[1] * {"left": 1.0, "right": -1.0}[side] > 0.0
                ):
                    raise DescriptionError(
                        "left and right are swapped: y points to the right",
                        where=where,
                        found=f"{cells[0]} ({symmetry}) with y = {cells[3]}",
                        allowed="y below 0 for points of the left side",
                    )
                if side != "right":
                    table.rows.append(PointRow(cells[0], place, where))
        if not table.rows:
            raise DescriptionError(
                "the file contains no hardpoints",
                where=str(self.file.path),
                allowed="a block [HARDPOINT]",
            )
        return table

    def _angles(self) -> dict[str, float]:
        """Return camber and toe in rad; of the left side if the sides differ."""
        unit = self.file.unit("ANGLE")
        angles = {"camber": 0.0, "toe": 0.0}
        for block in self.file.blocks_of("PARAMETER"):
            for cells, where in block.rows:
                name = cells[0].lower().removesuffix("_angle")
                if len(cells) >= 4 and name in angles and cells[1].lower() != "right":
                    angles[name] = unit * number(cells[3], where)
        return angles

    def _bodies(self, names: tuple[str, ...], model: str) -> dict[str, dict[str, Any]]:
        """Return the tables of bodies in the file; parts that form one jounce body are joined."""
        bodies: dict[str, dict[str, Any]] = {}
        left: list[str] = []
        seen: dict[str, str] = {}
        for part in self.file.blocks_of("PART_ASSEMBLY"):
            if part.values.get("SYMMETRY", "").lower() == "right":
                continue
            if part.usage and seen.setdefault(part.usage, part.where) != part.where:
                raise DescriptionError(
                    Phrase("the part {usage} is given twice", usage=part.usage),
                    where=part.where,
                    found=f"first in {seen[part.usage]}",
                    allowed="each part once per side",
                )
            name = next((name for name, usages in _BODIES.items() if part.usage in usages), "")
            if name not in names or (part.usage == "lower_strut" and model != "mcpherson"):
                left.append(f"{part.usage} ({part.number('MASS', 0.0) * self.mass:.4g} kg)")
                continue
            body = self._body(name, part)
            before = bodies.get(name)
            bodies[name] = (
                body
                if before is None
                else join_bodies(before, body["mass"], body["centre_of_mass"], tensor_of(body))
            )
        if left:
            self.draft.note(
                "parts.import_parts_left_out", self.draft.at("PART_ASSEMBLY"), names=", ".join(left)
            )
        return bodies

    def _body(self, name: str, part: Block) -> dict[str, Any]:
        """Return mass, centre and inertia of a part in jounce's axes; comments contain dependent frames."""
        texts = {}
        for comment in part.comments:
            if match := _POINT.search(comment):
                texts["place"] = match[1]
            elif match := _VECTOR.search(comment):
                texts[match[1].lower()] = match[2]

        def triple(key: str, *names: str) -> Array | None:
            if all(entry in part.values for entry in names):
                return np.array([part.number(entry) for entry in names])
            words = texts.get(key, "").split(",")
            return (
                np.array([number(word.strip(), part.where) for word in words])
                if len(words) == 3
                else None
            )

        place = triple("place", "PART_LOC_X", "PART_LOC_Y", "PART_LOC_Z")
        z, x = (triple(end, *(f"PART_ORI_{end.upper()}P{i}" for i in (1, 2, 3))) for end in "zx")
        mass = self.mass * part.number("MASS")
        if not mass > 0.0:
            raise DescriptionError(
                "no mass", where=f"{part.where}: MASS", found=mass, allowed="above 0"
            )
        has_inertia = any(key in part.values for key in ("IXX", "IYY", "IZZ"))
        if place is None or z is None or x is None or not has_inertia:
            code = "parts.import_frame_unknown" if has_inertia else "parts.import_inertia_unknown"
            self.draft.note(code, self.draft.at(f"PART_ASSEMBLY {part.usage}"))
            return self._estimate_body(name, mass)
        frame = _frame(x, z, part.where)
        centre = self.length * (
            place + frame @ [part.number(f"CM_LOCATION_FROM_PART_{i}", 0.0) for i in "XYZ"]
        )
        xx, yy, zz, xy, zx, yz = (
            part.number(key, 0.0) for key in ("IXX", "IYY", "IZZ", "IXY", "IZX", "IYZ")
        )
        tensor = (
            self.mass * self.length**2 * np.array([[xx, -xy, -zx], [-xy, yy, -yz], [-zx, -yz, zz]])
        )
        turned = _OURS @ frame
        tensor = turned @ tensor @ turned.T
        moments, axes = np.linalg.eigh(tensor)
        if moments[0] <= 0.0 or moments[2] > moments[0] + moments[1]:
            usage = self.draft.at(f"PART_ASSEMBLY {part.usage}")
            self.draft.note("parts.import_moments_raised", usage, moments=moments.tolist())
            self.draft.estimated.append(f"bodies.{name}.inertia")
            low = max(moments[0], 1e-3 * max(moments[2], 1e-6))
            middle = max(moments[1], moments[2] - low, low)
            tensor = axes @ np.diag([low, middle, min(moments[2], low + middle)]) @ axes.T
        return as_table(mass, _OURS @ centre, 0.5 * (tensor + tensor.T))

    def _estimate_body(self, name: str, mass: float | None = None) -> dict[str, Any]:
        """Return the table of a body with estimated inertia (and mass): a ball at the mean of its points."""
        places = np.array(
            [self.points[point] for point in _CORNERS.get(name, ()) if point in self.points]
        )
        if not len(places):
            places = np.array(
                [
                    self.points[end]
                    for end in ("tie_rod_inner", "tie_rod_outer")
                    if end in self.points
                ]
            )
        centre = places.mean(axis=0)
        size = max(float(np.linalg.norm(places - centre, axis=1).max()), 0.02)
        self.draft.estimated += [f"bodies.{name}.{key}" for key in ("centre_of_mass", "inertia")]
        if mass is None:
            mass = _MASSES.get(name, 1.0)
            self.draft.estimated.append(f"bodies.{name}.mass")
            self.draft.note(
                "parts.import_mass_assumed", self.draft.at(f"bodies.{name}"), mass, mass=mass
            )
        return as_table(mass, centre, 0.4 * mass * size**2 * np.eye(3))

    # --- springs, dampers and stops

    def _element(self, name: str, *words: str) -> Block | None:
        """Return the first force element whose usage contains one of ``words``, or else the first one."""
        blocks = [
            block
            for block in self.file.blocks_of(name)
            if block.values.get("SYMMETRY", "").lower() != "right"
        ]
        chosen = next(
            (block for block in blocks if any(word in block.usage for word in words)), None
        )
        if chosen is not None:
            self._used.add(chosen.where)
        return chosen

    def _property(self, block: Block | None) -> Path | None:
        """Find the property file of an element, next to the subsystem or in its database; None if missing."""
        text = "" if block is None else block.values.get("PROPERTY_FILE", "")
        parts = [
            part
            for part in PureWindowsPath(text).parts
            if not re.fullmatch(r"<.*>|\W*|\w+://.*", part)
        ]
        if not parts or ".." in parts:
            return None
        folder = self.file.path.parent
        for place in (folder.parent.joinpath(*parts), folder.joinpath(*parts), folder / parts[-1]):
            if place.is_file():
                return place
        return None

    def _missing(self, what: str, block: Block | None, assumed: str, **numbers: float) -> None:
        named = "" if block is None else block.values.get("PROPERTY_FILE", "")
        code = (
            "parts.import_no_property_file" if not named else "parts.import_property_file_missing"
        )
        instead = finding(assumed, self.draft.at(what), **numbers)
        self.draft.note(code, self.draft.at(what), name=named, assumed=instead)

    def _design_length(self, element: str) -> float:
        ends = [
            self.points.get(f"{element}_{end}", self.points[f"strut_{end}"])
            for end in ("bottom", "top")
        ]
        return float(np.linalg.norm(ends[1] - ends[0]))

    def _spring(self) -> dict[str, Any]:
        block = self._element("NSPRING_ASSEMBLY", "ride", "spring", "")
        file = self._property(block)
        if block is None or file is None:
            self._missing(
                "strut.spring",
                block,
                "parts.import_spring_assumed",
                rate=_SPRING_RATE,
                mass=SPRUNG_MASS,
            )
            self.draft.estimated += ["strut.spring.rate", "strut.spring.preload"]
            return {"rate": _SPRING_RATE, "preload": SPRUNG_MASS * 9.81}
        free, deflection, force = _spring_file(file)
        kind, value = block.values.get("VALUE_TYPE", "").lower(), block.values.get("USER_VALUE")
        compressed = 0.0
        if kind == "installed_length" and value is not None:
            compressed = free - self.length * number(value, block.where)
        elif kind == "preload" and value is not None:
            compressed = float(
                np.interp(self.force * number(value, block.where), force, deflection)
            )
        else:
            self.draft.note("parts.import_spring_free", self.draft.at("strut.spring"))
        table: dict[str, Any] = {"free_length": self._design_length("spring") + compressed}
        rate = float(deflection @ force / (deflection @ deflection))
        if np.abs(force - rate * deflection).max() <= _LINEAR * np.abs(force).max():
            return {"rate": rate, **table}
        return {"curve": {"kind": "table", "deflection": deflection, "force": force}, **table}

    def _damper(self) -> dict[str, Any]:
        block = self._element("DAMPER_ASSEMBLY", "ride", "damper", "")
        file = self._property(block)
        if file is None:
            self._missing(
                "strut.damper", block, "parts.import_damper_assumed", coefficient=_DAMPING
            )
            self.draft.estimated.append("strut.damper.coefficient")
            return {"coefficient": _DAMPING}
        properties = read_teim_orbit(file)
        length = properties.unit("LENGTH")
        velocity, force = properties.first("CURVE").curve(
            length / properties.unit("TIME"), properties.unit("FORCE")
        )
        return {
            "kind": "table",
            "velocity": -velocity[::-1],
            "force": -force[::-1],
        }  # Adams: rebound is positive

    def _stops(self) -> dict[str, Any]:
        stops = {}
        for stop, words in _STOPS.items():
            block = self._element("BUMPSTOP_ASSEMBLY", *words) or self._element(
                "REBOUNDSTOP_ASSEMBLY", *words
            )
            if block is None:
                continue
            file = self._property(block)
            if file is None:
                self._missing(f"strut.{stop}", block, "parts.import_no_stop")
                continue
            properties = read_teim_orbit(file)
            depth, force = properties.first("CURVE").curve(
                properties.unit("LENGTH"), properties.unit("FORCE")
            )
            law, worst = _stop_law(depth, force, file)
            gap = self.length * block.number("USER_DISTANCE")
            if block.values.get("DISTANCE_TYPE", "clearance").lower() != "clearance":
                sign = 1.0 if stop == "bump_stop" else -1.0
                gap = sign * (self._design_length("damper") - gap)
            stops[stop] = {"gap": gap, **law}
            self.draft.note(
                "parts.import_stop_fitted", self.draft.at(f"strut.{stop}"), worst, worst=worst
            )
        return stops

    def _bushings(self, allowed: tuple[str, ...]) -> dict[str, dict[str, Any]]:
        """Return bushings at the allowed hardpoints, if their property files exist."""
        bushings: dict[str, dict[str, Any]] = {}
        known = names_of_points()
        for block in self.file.blocks_of("BUSHING_ASSEMBLY"):
            point = self.names.get(block.usage, known.get(block.usage.replace("_", " "), ""))
            file = self._property(block)
            if (
                block.values.get("SYMMETRY", "").lower() == "right"
                or point not in allowed
                or file is None
            ):
                continue
            self._used.add(block.where)
            scales = [block.number(f"{axis}_SCALING_FACTOR", 1.0) for axis in _SIX]
            bushings[point], worst = _bushing_file(file, scales)
            self.draft.note(
                "parts.import_bushing", self.draft.at(f"bushings.{point}"), worst, worst=worst
            )
            loads = [key for key in block.values if "PRELOAD" in key and block.number(key) != 0.0]
            if loads:
                self.draft.note(
                    "parts.import_loads_left_out",
                    self.draft.at(f"bushings.{point}"),
                    names=", ".join(loads),
                )
        return bushings

    def _note_rest(self) -> None:
        """Add findings on parts of the file that the rig does not use."""
        bushings = {
            block.usage
            for block in self.file.blocks_of("BUSHING_ASSEMBLY")
            if block.where not in self._used
        }
        if bushings:
            names = ", ".join(sorted(bushings))
            self.draft.findings.append(
                finding(
                    "parts.import_bushings_rigid", self.draft.at("BUSHING_ASSEMBLY"), names=names
                )
            )
        rest = [
            f"{block.name.lower()} {block.usage}"
            for block in self.file.blocks
            if block.name.endswith(("SPRING_ASSEMBLY", "DAMPER_ASSEMBLY", "STOP_ASSEMBLY", "FORCE"))
            and block.where not in self._used
        ]
        if rest:
            self.draft.note(
                "parts.import_forces_left_out", self.draft.at("forces"), names=", ".join(rest)
            )


def _frame(x: Array, z: Array, where: str) -> Array:
    """Return the axes of a part as columns, from its z axis and a vector in its x-z plane."""
    along = np.linalg.norm(z)
    across = np.cross(z, x)
    if along < 1e-9 or np.linalg.norm(across) < 1e-9:
        raise DescriptionError("the axes of a part are parallel or zero", where=where)
    z, y = z / along, across / np.linalg.norm(across)
    return np.column_stack([np.cross(y, z), y, z])


def _spring_file(file: Path) -> tuple[float, Array, Array]:
    """Read free length (m), deflection (m) and force (N), compression positive, from a ``.spr`` in text or XML."""
    if file.suffix.lower() == ".xml":
        return _xml_spring(file)
    properties = read_teim_orbit(file)
    length = properties.unit("LENGTH")
    deflection, force = properties.first("CURVE").curve(length, properties.unit("FORCE"))
    return length * properties.first("SPRING_DATA").number("FREE_LENGTH"), deflection, force


def _bushing_file(file: Path, scales: list[float]) -> tuple[dict[str, Any], float]:
    """Return the table of a bushing from a ``.bus``, and the relative deviation of its curves from straight lines."""
    properties = read_teim_orbit(file)
    length, force, angle, time = (
        properties.unit(name) for name in ("LENGTH", "FORCE", "ANGLE", "TIME")
    )
    units = [(length, force)] * 3 + [(angle, force * length)] * 3
    slopes, worst = [], 0.0
    for axis, scale, (along, across) in zip(_SIX, scales, units, strict=True):
        x, y = properties.first(f"{axis}_CURVE").curve(along, across)
        if not x[0] <= 0.0 <= x[-1]:
            raise DescriptionError(
                "the curve does not reach zero", where=properties.first(f"{axis}_CURVE").where
            )
        step = 1e-3 * (x[-1] - x[0])
        ends = np.clip([-step, step], x[0], x[-1])
        low, high = np.interp(ends, x, y)
        slope = (high - low) / (ends[1] - ends[0])
        if slope < 0.0:
            raise DescriptionError(
                "a bushing with negative stiffness", where=properties.first(f"{axis}_CURVE").where
            )
        slopes.append(scale * float(slope))
        largest = float(np.abs(y).max())
        worst = max(worst, float(np.abs(y - slope * x).max()) / largest if largest else 0.0)
    damping = properties.blocks_of("DAMPING")
    given = [damping[0].number(f"{axis}_DAMPING", 0.0) if damping else 0.0 for axis in _SIX[:3]]
    table = {"stiffness": slopes[:3], "rotational_stiffness": slopes[3:]}
    return table | {"damping": [value * force * time / length for value in given]}, worst


def _xml_spring(file: Path) -> tuple[float, Array, Array]:
    try:
        root = parse_xml(content_of(file))
    except (ET.ParseError, ValueError, LookupError) as error:
        raise DescriptionError(
            Phrase("not XML of a spring: {error}", error=str(error)), where=str(file)
        ) from None
    units = {
        element.get("name", "").upper(): element.get("current", "")
        for element in root.iter()
        if element.tag.endswith("UnitSetting")
    }
    spring = next(
        (element for element in root.iter() if element.tag.endswith("SpringProperties")), None
    )
    if spring is None:
        raise DescriptionError(
            "the file contains no spring", where=str(file), allowed="SpringProperties"
        )
    properties = TeimOrbit(file, [Block("UNITS", str(file), units)])
    length, force = properties.unit("LENGTH"), properties.unit("FORCE")
    text = "".join(spring.itertext())
    rows = [(line.split(), str(file)) for line in text.splitlines() if line.strip()]
    curve = Block("CURVE", str(file), rows=rows).curve(length, force)
    return length * number(spring.get("freeLength", ""), f"{file}: freeLength"), *curve


def _stop_law(depth: Array, force: Array, file: Path) -> tuple[dict[str, float], float]:
    """Fit rate and progression of a stop to points; return them and the error relative to the largest force."""
    from scipy.optimize import nnls

    here = depth > 0.0
    depth, force = depth[here], force[here]
    if not len(depth) or force.max() <= 0.0:
        raise DescriptionError(
            "a stop without force", where=str(file), allowed="forces above 0 at depths above 0"
        )
    parts = np.column_stack([depth, depth**3])
    rate, progression = nnls(parts, force)[0]
    rate = max(float(rate), float(np.min(force[force > 0.0] / depth[force > 0.0])) * 1e-3)
    worst = float(np.abs(parts @ [rate, progression] - force).max() / force.max())
    return {"rate": rate, "progression": float(progression)}, worst
