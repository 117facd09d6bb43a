"""Import of Project Chrono suspensions as 3-D rigs: double wishbone, MacPherson strut and multi-link."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any, cast

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.findings import finding
from jounce.core.operation import File, operation
from jounce.core.types import Array
from jounce.parts.bodies import TRIANGLE_TOLERANCE, distance_to_line
from jounce.parts.corners import Corner
from jounce.parts.files import rig_from_table, rig_text
from jounce.parts.importers.chrono_file import HARDPOINTS, ChronoFile, ascending, damper_map
from jounce.parts.importers.drafts import (
    CARRIED_MASS,
    TYRE_RADIUS,
    Draft,
    ImportedRig,
    TyreStiffness,
    WheelMass,
    add_wheel,
    as_table,
    join_bodies,
    rig_of,
    set_on_the_road,
    tensor_of,
)

DESIGN = np.eye(3)


def arm_frame(front: Array, rear: Array, outer: Array, where: str) -> Array:
    """Return the axes of Chrono's A-arms as columns: x along the axis to the front, z normal to the arm."""
    normal = _unit(np.cross(rear - outer, front - outer), where)
    along = _unit(front - rear, where)
    return np.column_stack([along, np.cross(normal, along), normal])


def rod_frame(start: Array, end: Array, across: Array, where: str) -> Array:
    """Return the axes of Chrono's links as columns: z from ``start`` to ``end``, y along ``across`` orthogonalised."""
    along = _unit(end - start, where)
    side = _unit(across - along * (along @ across), where)
    return np.column_stack([np.cross(side, along), side, along])


def about_axis(table: dict[str, Any], start: Array, end: Array) -> float:
    """Return the moment of inertia of a body about the line through two points, kg m^2."""
    axis = (end - start) / np.linalg.norm(end - start)
    away = np.linalg.norm(np.cross(axis, np.array(table["centre_of_mass"]) - start))
    return float(axis @ tensor_of(table) @ axis + table["mass"] * away**2)


def _unit(vector: Array, where: str) -> Array:
    length = float(np.linalg.norm(vector))
    if length < 1e-9:
        raise DescriptionError(
            "two points coincide, or three are collinear", where=where, allowed="a triangle"
        )
    return vector / length


STOP_RATE, STOP_PROGRESSION = 1.0e5, 6.0e7
"""Stop law (N/m, N/m^3) within 8 % of the points that Chrono uses for all vehicles, from 2 mm to 50 mm of depth."""


def spring_table(file: ChronoFile) -> dict[str, Any]:
    """Return the table of ``strut.spring``: rate or curve, with free length in m."""
    free, preload = file.positive("Spring", "Free Length"), file.number("Spring", "Preload", 0.0)
    if file.has("Spring", "Spring Coefficient"):
        rate = file.positive("Spring", "Spring Coefficient")
        return {"rate": rate, "free_length": free + preload / rate}
    key = "Curve Data" if file.has("Spring", "Curve Data") else "Spring Curve Data"
    lengthening, force = file.curve("Spring", key)
    curve = {"kind": "table", "deflection": -lengthening[::-1], "force": preload - force[::-1]}
    return {"curve": curve, "free_length": free}


def damper_table(file: ChronoFile) -> dict[str, Any]:
    """Return the table of ``strut.damper``: linear, a table over velocity, or a map over length and velocity."""
    if file.has("Shock", "Map Data"):
        grid = damper_map(file)
        return {
            "kind": "map",
            "length": grid.length + file.number("Shock", "Free Length", 0.0),
            "velocity": -grid.velocity[::-1],
            "force": -grid.force.T[:, ::-1],
        }
    key = "Curve Data" if file.has("Shock", "Curve Data") else "Damping Curve Data"
    if file.has("Shock", key):
        lengthening, force = file.curve("Shock", key)
        return {"kind": "table", "velocity": -lengthening[::-1], "force": -force[::-1]}
    coefficient = file.positive("Shock", "Damping Coefficient")
    if not file.has("Shock", "Degressivity Compression", "Degressivity Expansion"):
        return {"coefficient": coefficient}
    expansion, compression = (
        file.number("Shock", f"Degressivity {way}", 0.0) for way in ("Expansion", "Compression")
    )
    if min(expansion, compression) < 0.0:
        raise DescriptionError(
            "a degressivity below 0", found=[expansion, compression], allowed="at least 0"
        )
    speeds = np.array(
        [0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.5, 2.0, 3.0]
    )  # c v / (1 + share |v|), bump positive
    bump = coefficient * speeds / (1.0 + compression * speeds)
    rebound = coefficient * speeds / (1.0 + expansion * speeds)
    return {
        "kind": "table",
        "velocity": np.concatenate([-speeds[::-1], [0.0], speeds]),
        "force": np.concatenate([-rebound[::-1], [0.0], bump]),
    }


_MACPHERSON = {
    "lower_arm_front": ("Control Arm", "Location Chassis Front"),
    "lower_arm_rear": ("Control Arm", "Location Chassis Back"),
    "lower_ball_joint": ("Control Arm", "Location Upright"),
    "tie_rod_inner": ("Tierod", "Location Chassis"),
    "tie_rod_outer": ("Tierod", "Location Upright"),
    "wheel_centre": ("Spindle", "COM"),
    "spring_top": ("Spring", "Location Chassis"),
    "spring_bottom": ("Spring", "Location Upright"),
    "damper_top": ("Shock", "Location Chassis"),
    "damper_bottom": ("Shock", "Location Upright"),
}
_MULTI_LINK = {
    "link_1_inner": ("Upper Arm", "Location Chassis Front"),
    "link_1_outer": ("Upper Arm", "Location Upright"),
    "link_2_inner": ("Upper Arm", "Location Chassis Back"),
    "link_2_outer": ("Upper Arm", "Location Upright"),
    "link_3_inner": ("Lateral", "Location Chassis"),
    "link_3_outer": ("Lateral", "Location Upright"),
    "link_4_inner": ("Trailing Link", "Location Chassis"),
    "link_4_outer": ("Trailing Link", "Location Upright"),
    "link_5_inner": ("Tierod", "Location Chassis"),
    "link_5_outer": ("Tierod", "Location Upright"),
    "wheel_centre": ("Spindle", "COM"),
    "spring_top": ("Spring", "Location Chassis"),
    "spring_bottom": ("Spring", "Location Link"),
    "damper_top": ("Shock", "Location Chassis"),
    "damper_bottom": ("Shock", "Location Link"),
}


class ChronoReading(Draft):
    """Reading state of one file: its points as written, and findings."""

    def __init__(self, file: ChronoFile, points: dict[str, Array]) -> None:
        super().__init__(file.path)
        self.file, self.points = file, points

    def body(
        self, name: str, section: str, frame: Array, centre: Array | None = None
    ) -> dict[str, Any]:
        """Return the table of a body; ``frame`` contains the axes of the inertia in the file as columns.

        A principal moment cannot exceed the sum of the others: such a moment is reduced to the sum, and the inertia
        is marked as estimated.
        """
        part, where = self.file.part(section, centre=centre), self.file.at(section)
        xy, xz, yz = part.products
        tensor = np.diag(part.moments) + np.array([[0.0, xy, xz], [xy, 0.0, yz], [xz, yz, 0.0]])
        moments, axes = np.linalg.eigh(tensor)
        if moments[0] <= 0.0:
            raise DescriptionError(
                "an impossible inertia: a principal moment is not above 0",
                where=where,
                found=", ".join(f"{moment:.6g} kg m^2" for moment in moments),
            )
        cut = moments[0] + moments[1]
        if moments[2] > cut * (1.0 + TRIANGLE_TOLERANCE):
            tensor = axes @ np.diag([moments[0], moments[1], cut]) @ axes.T
            self.findings.append(
                finding(
                    "parts.import_moments_cut",
                    where,
                    cut,
                    first=moments[0],
                    second=moments[1],
                    third=moments[2],
                    cut=cut,
                )
            )
            self.estimated.append(f"bodies.{name}.inertia")
        if self.file.table.get("Vehicle-Frame Inertia") is not True:
            tensor = frame @ tensor @ frame.T
        return as_table(part.mass, part.centre, tensor)

    def arm(self, name: str, section: str, front: str, rear: str, outer: str) -> dict[str, Any]:
        """Return the table of an A-arm, whose inertia is in Chrono's arm frame."""
        corners = self.points[front], self.points[rear], self.points[outer]
        return self.body(name, section, arm_frame(*corners, self.file.at(section)))

    def add_tie_rod(self, bodies: dict[str, Any], name: str = "tie_rod") -> None:
        """Add the tie rod to the bodies if it has mass."""
        if self.file.has("Tierod", "Mass"):
            inner, outer = self.points[f"{name}_inner"], self.points[f"{name}_outer"]
            frame = rod_frame(
                inner, outer, np.cross(outer - inner, [1.0, 0.0, 0.0]), self.file.at("Tierod")
            )
            bodies[name] = self.body(name, "Tierod", frame, (inner + outer) / 2.0)


def _head(
    reading: ChronoReading, model: str, bodies: dict[str, Any], on: str, **more: Any
) -> dict[str, Any]:
    """Return the table of a rig without its wheel; strut points are those of the spring, a damper may have its own."""
    points = dict(reading.points)
    points["strut_bottom"], points["strut_top"] = (
        points.pop("spring_bottom"),
        points.pop("spring_top"),
    )
    for end in ("bottom", "top"):
        if np.array_equal(points[f"damper_{end}"], points[f"strut_{end}"]):
            del points[f"damper_{end}"]
    return {
        "schema": "jounce.rig/1",
        "model": model,
        "source": f"{reading.file.name}, suspension file of Project Chrono, {reading.file.path.name}",
        "estimated": [],
        "side": "left",
        "guide": "vertical",
        "hardpoints": points,
        "bodies": bodies,
        "strut": {"on": on},
        **more,
    }


def _double_wishbone(reading: ChronoReading) -> dict[str, Any]:
    arms = {
        f"{side}_arm": reading.arm(
            f"{side}_arm",
            f"{side.title()} Control Arm",
            f"{side}_arm_front",
            f"{side}_arm_rear",
            f"{side}_ball_joint",
        )
        for side in ("lower", "upper")
    }
    bodies = {**arms, "upright": reading.body("upright", "Upright", DESIGN)}
    reading.add_tie_rod(bodies)
    return _head(reading, "double-wishbone", bodies, "lower_arm", steering={"rack_travel": 0.0})


def _mcpherson(reading: ChronoReading) -> dict[str, Any]:
    bodies = {
        "lower_arm": reading.arm(
            "lower_arm", "Control Arm", "lower_arm_front", "lower_arm_rear", "lower_ball_joint"
        ),
        "upright": reading.body("upright", "Upright", DESIGN),
    }
    if reading.file.has("Strut", "Mass"):
        middle = (reading.points["spring_top"] + reading.points["spring_bottom"]) / 2.0
        bodies["strut"] = reading.body("strut", "Strut", DESIGN, middle)
    reading.add_tie_rod(bodies)
    return _head(reading, "mcpherson", bodies, "upright", steering={"rack_travel": 0.0})


def _five_link(reading: ChronoReading) -> dict[str, Any]:
    points, file = reading.points, reading.file
    rods = {
        "link_3": ("Lateral", points["link_4_outer"]),
        "link_4": ("Trailing Link", points["spring_bottom"]),
    }
    links = {}
    for name, (section, beside) in rods.items():
        inner, outer = points[f"{name}_inner"], points[f"{name}_outer"]
        frame = rod_frame(outer, inner, np.cross(outer - beside, inner - beside), file.at(section))
        links[name] = reading.body(name, section, frame)
    upright = reading.body("upright", "Upright", DESIGN)
    arm = reading.arm("upright", "Upper Arm", "link_1_inner", "link_2_inner", "link_1_outer")
    ends = points["link_1_inner"], points["link_2_inner"]
    lever = distance_to_line(points["link_1_outer"], *ends)
    share = about_axis(arm, *ends) / lever**2
    reading.note(
        "parts.import_arm_as_links", file.at("Upper Arm"), share, share=share, mass=arm["mass"]
    )
    bodies = {
        "upright": join_bodies(upright, share, points["link_1_outer"], np.zeros((3, 3))),
        **links,
    }
    reading.add_tie_rod(bodies, "link_5")
    return _head(reading, "five-link", bodies, "link_4")


TEMPLATES: dict[
    str, tuple[dict[str, tuple[str, str]], Callable[[ChronoReading], dict[str, Any]]]
] = {
    "DoubleWishbone": (HARDPOINTS, _double_wishbone),
    "MacPhersonStrut": (_MACPHERSON, _mcpherson),
    "MultiLink": (_MULTI_LINK, _five_link),
}


_ADVICE = "Other suspensions can be written as rig files by hand; see the documentation of rigs."
_READ = {
    "Name",
    "Type",
    "Template",
    "Vehicle-Frame Inertia",
    "Camber Angle (deg)",
    "Toe Angle (deg)",
    "Axle",
}


@operation(
    "import chrono",
    named={"path": "file"},
    echo={"file": "file"},
    offers=("imported_rig",),
    page="jounce.report.exchange:imported_rig_page",
    title="{out}",
    doing="reading the file",
    example='jounce import chrono suspension.json --out rig.toml --wheel-radius "344 mm"',
    python_only=("source",),
)
def import_chrono(
    path: Annotated[Path | str, File("DoubleWishbone, MacPhersonStrut or MultiLink.", "FILE.json")],
    *,
    wheel_radius: Annotated[float | None, TYRE_RADIUS] = None,
    wheel_mass: WheelMass = None,
    tyre_stiffness: TyreStiffness = None,
    sprung_mass: Annotated[float | None, CARRIED_MASS] = None,
    source: str | None = None,
) -> ImportedRig:
    """Convert a Project Chrono suspension to the left corner of a 3-D rig.

    Chrono positions a suspension relative to its axle. Here the road is z = 0, and the height of the wheel centre is
    the tyre radius minus its deflection under the weight of the corner.

    Parameters
    ----------
    path : Path or str
        JSON file of the template ``DoubleWishbone``, ``MacPhersonStrut`` or ``MultiLink``.
    wheel_radius : float, optional
        Undeformed radius of the tyre [m]; estimated 0.33 m.
    wheel_mass : float, optional
        Mass of rim and tyre [kg], which are in other files; estimated 20 kg.
    tyre_stiffness : float, optional
        Radial stiffness [N/m]; estimated 250 kN/m.
    sprung_mass : float, optional
        Sprung mass on this wheel [kg]; estimated from the load of spring and stops at design position, or 350 kg if
        they carry less than 20 kg.
    source : str, optional
        Text for ``source`` of the rig; by default the names of suspension and file.

    Returns
    -------
    rig : Corner
        ``DoubleWishbone``, ``McPherson`` or ``FiveLink``.
    findings : list of Finding
        Assumptions, changes and omissions.
    text : str
        Text of the rig file.

    Raises
    ------
    DescriptionError
        For a missing file, invalid JSON (with the line), a different template, values that are missing, not numbers or
        of the wrong shape, or points that do not form a mechanism.

    Examples
    --------
    >>> from importlib import resources
    >>> folder = Path(str(resources.files("jounce.parts"))) / "library" / "hmmwv"
    >>> rig, findings, text = import_chrono(folder / "HMMWV_DoubleWishboneFront_mapShock.json")
    >>> rig.model, rig.strut.damper.kind, round(rig.sprung.mass)   # kg
    ('double-wishbone', 'map', 692)
    """
    file = ChronoFile(Path(path), list(TEMPLATES), _ADVICE)
    names, build = TEMPLATES[file.template]
    reading = ChronoReading(
        file, {name: file.numbers(section, key, (3,)) for name, (section, key) in names.items()}
    )
    table = build(reading)
    _add_elements(reading, table)
    angles = {"camber": file.angle("Camber Angle (deg)"), "toe": file.angle("Toe Angle (deg)")}
    spindle = reading.body("wheel", "Spindle", DESIGN)
    add_wheel(reading, table, spindle, angles, (wheel_radius, wheel_mass, tyre_stiffness))
    set_on_the_road(reading, table, sprung_mass)
    _note_what_differs(reading, names)
    table |= {
        "estimated": sorted(reading.estimated),
        "source": table["source"] if source is None else source,
    }
    place = f"{reading.file.path}: "
    comments = [
        f"Left corner imported from {reading.file.path.name} of Project Chrono (BSD-3-Clause). z = 0 is the road.",
        *(f"{item.place.removeprefix(place)}: {item.message}" for item in reading.findings),
    ]
    text = rig_text(rig_of(reading, table), comments)
    rig = cast(Corner, rig_from_table(tomllib.loads(text), where=str(path)))
    return ImportedRig(rig, reading.findings, text)


def _add_elements(reading: ChronoReading, table: dict[str, Any]) -> None:
    """Add spring, damper and stops of the strut."""
    file, points = reading.file, table["hardpoints"]
    table["strut"] |= {"spring": spring_table(file), "damper": damper_table(file)}
    if file.has("Spring", "Minimum Length", "Maximum Length"):
        design = float(np.linalg.norm(points["strut_top"] - points["strut_bottom"]))
        shortest, longest = (
            file.positive("Spring", "Minimum Length"),
            file.positive("Spring", "Maximum Length"),
        )
        place = file.at("Spring", "Minimum Length")
        ascending(np.array([shortest, longest]), place)
        law = {"rate": STOP_RATE, "progression": STOP_PROGRESSION}
        for stop, gap in (("bump_stop", design - shortest), ("rebound_stop", longest - design)):
            table["strut"][stop] = {"gap": gap, **law}
            reading.estimated += [f"strut.{stop}.{key}" for key in law]
        reading.note("parts.import_stops_of_chrono", place)
    if file.has("Shock", "Degressivity Compression"):
        reading.note("parts.import_degressive_table", file.at("Shock"))


def _note_what_differs(reading: ChronoReading, names: dict[str, tuple[str, str]]) -> None:
    """Add findings on unused parts of the file, and on general assumptions."""
    file = reading.file
    read = {*_READ, *(section for section, _ in names.values()), "Upright", "Strut", "Spindle"}
    unread = [section for section in file.table if section not in read]
    bushed = [section for section in file.table if file.has(section, "Bushing Data")]
    reading.findings += [
        finding("parts.import_section_unread", file.at(section)) for section in unread
    ]
    reading.findings += [
        finding("parts.import_no_bushings", file.at(section, "Bushing Data")) for section in bushed
    ]
    links = [section for section in file.table if file.has(section, "Universal Joint Axis Link")]
    if links:
        reading.note("parts.import_joint_axes", file.at(links[0]))
    if file.table.get("Vehicle-Frame Inertia") is True:
        frames = "parts.import_vehicle_axes"
    else:
        frames = "parts.import_own_axes"
    reading.note(frames, file.at("Vehicle-Frame Inertia"))
    reading.note("parts.import_rim_and_tyre", file.at("Spindle"))
