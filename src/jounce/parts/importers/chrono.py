"""Suspensions of Project Chrono as 3-D rigs: double wishbone, MacPherson strut and multi-link."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, cast

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding
from jounce.parts.corners import Corner
from jounce.parts.importers.chrono_bodies import (
    DESIGN,
    about_axis,
    arm_frame,
    body_table,
    joined,
    rod_frame,
    wheel_tensor,
)
from jounce.parts.importers.chrono_corner import HARDPOINTS
from jounce.parts.importers.chrono_elements import (
    STOP_ESTIMATE,
    damper_table,
    element_findings,
    spring_table,
    stop_tables,
)
from jounce.parts.importers.chrono_file import Array, ChronoFile
from jounce.parts.leverage import motion_ratio, spring_force, static_spring_force, static_tyre_deflection
from jounce.parts.loading import rig_from_table
from jounce.parts.writing import rig_text

WHEEL_RADIUS, WHEEL_MASS, TYRE_STIFFNESS, SPRUNG_MASS = 0.33, 20.0, 250e3, 350.0
"""Estimates for what suspension files do not hold: m, kg (rim and tyre), N/m, kg; those of a passenger car."""
_ADVICE = "Other suspensions can be written as rig files by hand; see the documentation of rigs."
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
_ORDER = (
    "schema",
    "model",
    "source",
    "estimated",
    "side",
    "guide",
    "hardpoints",
    "wheel",
    "sprung",
    "bodies",
    "strut",
    "steering",
    "tyre",
)
_READ = {"Name", "Type", "Template", "Vehicle-Frame Inertia", "Camber Angle (deg)", "Toe Angle (deg)", "Axle"}


@dataclass
class _Reading:
    """One file while it is read: its points as they stand there, and what was found out on the way."""

    file: ChronoFile
    points: dict[str, Array]
    findings: list[Finding] = field(default_factory=list)
    estimated: list[str] = field(default_factory=list)

    def body(self, name: str, section: str, frame: Array, centre: Array | None = None) -> dict[str, Any]:
        """Table of a body; an inertia that had to be changed is estimated."""
        table, found = body_table(self.file, section, frame, centre)
        self.findings += found
        if found:
            self.estimated.append(f"bodies.{name}.inertia")
        return table

    def arm(self, name: str, section: str, front: str, rear: str, outer: str) -> dict[str, Any]:
        """Table of an A-arm in Chrono's frame of it."""
        return self.body(name, section, arm_frame(self.points[front], self.points[rear], self.points[outer]))


def import_chrono(
    path: Path | str,
    *,
    wheel_radius: float | None = None,
    wheel_mass: float | None = None,
    tyre_stiffness: float | None = None,
    sprung_mass: float | None = None,
    source: str | None = None,
) -> tuple[Corner, list[Finding], str]:
    """Read a suspension file of Project Chrono as the left corner of a 3-D rig.

    Chrono places a suspension relative to its axle; here the road becomes z = 0, and the wheel centre stands above it
    by the tyre's radius less its deflection under the corner's weight.

    Parameters
    ----------
    path : Path or str
        JSON file of the template ``DoubleWishbone``, ``MacPhersonStrut`` or ``MultiLink``.
    wheel_radius : float, optional
        Undeformed radius of the tyre [m]; estimated 0.33 m.
    wheel_mass : float, optional
        Rim and tyre [kg], which stand in other files; estimated 20 kg.
    tyre_stiffness : float, optional
        Radial stiffness [N/m]; estimated 250 kN/m.
    sprung_mass : float, optional
        Share of the body on this wheel [kg]; estimated as what spring and stops carry at design position, 350 kg where
        they carry less than 20 kg.
    source : str, optional
        Text for ``source`` of the rig; by default the names of suspension and file.

    Returns
    -------
    rig : Corner
        ``DoubleWishbone``, ``McPherson`` or ``FiveLink``.
    findings : list of Finding
        What was assumed, changed or left out.
    text : str
        The rig file that describes it.

    Raises
    ------
    DescriptionError
        For a file that is missing, no JSON (with the line), of another template, or with values that are missing, no
        numbers, of the wrong shape, or no mechanism.

    Examples
    --------
    >>> from importlib import resources
    >>> folder = Path(str(resources.files("jounce.parts"))) / "library" / "hmmwv"
    >>> rig, findings, text = import_chrono(folder / "HMMWV_DoubleWishboneFront_mapShock.json")
    >>> rig.model, rig.strut.damper.kind, round(rig.sprung.mass)   # kg
    ('double-wishbone', 'map', 702)
    """
    file = ChronoFile(Path(path), list(_TEMPLATES), _ADVICE)
    names, build = _TEMPLATES[file.template]
    reading = _Reading(file, {name: file.numbers(section, key, (3,)) for name, (section, key) in names.items()})
    table = build(reading)
    _add_elements(reading, table)
    _add_wheel(reading, table, wheel_radius, wheel_mass, tyre_stiffness)
    _set_on_the_road(reading, table, sprung_mass)
    reading.findings += [*_left_out(file, names), *_assumptions(file)]
    table = {key: table[key] for key in _ORDER if key in table} | {"estimated": sorted(reading.estimated)}
    table["source"] = table["source"] if source is None else source
    text = rig_text(table, _comments(reading))
    return cast(Corner, rig_from_table(tomllib.loads(text), where=str(path))), reading.findings, text


def _double_wishbone(reading: _Reading) -> dict[str, Any]:
    arms = {
        f"{side}_arm": reading.arm(
            f"{side}_arm", f"{side.title()} Control Arm", f"{side}_arm_front", f"{side}_arm_rear", f"{side}_ball_joint"
        )
        for side in ("lower", "upper")
    }
    bodies = {**arms, "upright": reading.body("upright", "Upright", DESIGN)}
    _add_tie_rod(reading, bodies)
    return _head(reading, "double-wishbone", bodies, "lower_arm", steering={"rack_travel": 0.0})


def _mcpherson(reading: _Reading) -> dict[str, Any]:
    bodies = {
        "lower_arm": reading.arm("lower_arm", "Control Arm", "lower_arm_front", "lower_arm_rear", "lower_ball_joint"),
        "upright": reading.body("upright", "Upright", DESIGN),
    }
    if reading.file.has("Strut", "Mass"):
        middle = (reading.points["spring_top"] + reading.points["spring_bottom"]) / 2.0
        bodies["strut"] = reading.body("strut", "Strut", DESIGN, middle)
    _add_tie_rod(reading, bodies)
    return _head(reading, "mcpherson", bodies, "upright", steering={"rack_travel": 0.0})


def _five_link(reading: _Reading) -> dict[str, Any]:
    points, file = reading.points, reading.file
    lateral, trailing = (
        (points["link_3_outer"], points["link_3_inner"]),
        (points["link_4_outer"], points["link_4_inner"]),
    )
    spring = points["spring_bottom"]
    frames = {
        "link_3": rod_frame(*lateral, np.cross(lateral[0] - trailing[0], lateral[1] - trailing[0])),
        "link_4": rod_frame(*trailing, np.cross(trailing[0] - spring, trailing[1] - spring)),
    }
    upright = reading.body("upright", "Upright", DESIGN)
    arm = reading.arm("upright", "Upper Arm", "link_1_inner", "link_2_inner", "link_1_outer")
    ends = points["link_1_inner"], points["link_2_inner"]
    lever = np.linalg.norm(np.cross(ends[1] - ends[0], points["link_1_outer"] - ends[0])) / np.linalg.norm(
        ends[1] - ends[0]
    )
    share = about_axis(arm, *ends) / float(lever) ** 2
    reading.findings.append(
        Finding(
            file.at("Upper Arm"),
            "note",
            f"the upper arm becomes links 1 and 2 without mass; {share:.4g} kg of its {arm['mass']:.4g} kg (inertia "
            "about its axis over its length squared) move with the upright at their common point.",
            share,
        )
    )
    bodies = {
        "upright": joined(upright, share, points["link_1_outer"], np.zeros((3, 3))),
        "link_3": reading.body("link_3", "Lateral", frames["link_3"]),
        "link_4": reading.body("link_4", "Trailing Link", frames["link_4"]),
    }
    if file.has("Tierod", "Mass"):
        bodies["link_5"] = _tie_rod(reading, "link_5", points["link_5_inner"], points["link_5_outer"])
    return _head(reading, "five-link", bodies, "link_4")


def _add_tie_rod(reading: _Reading, bodies: dict[str, Any]) -> None:
    if reading.file.has("Tierod", "Mass"):
        bodies["tie_rod"] = _tie_rod(
            reading, "tie_rod", reading.points["tie_rod_inner"], reading.points["tie_rod_outer"]
        )


def _tie_rod(reading: _Reading, name: str, inner: Array, outer: Array) -> dict[str, Any]:
    across = np.cross(outer - inner, [1.0, 0.0, 0.0])
    return reading.body(name, "Tierod", rod_frame(inner, outer, across), (inner + outer) / 2.0)


_TEMPLATES: dict[str, tuple[dict[str, tuple[str, str]], Callable[[_Reading], dict[str, Any]]]] = {
    "DoubleWishbone": (HARDPOINTS, _double_wishbone),
    "MacPhersonStrut": (_MACPHERSON, _mcpherson),
    "MultiLink": (_MULTI_LINK, _five_link),
}


def _head(reading: _Reading, model: str, bodies: dict[str, Any], on: str, **more: Any) -> dict[str, Any]:
    """Table of a rig without its wheel; the strut's points are the spring's, other points of a damper stand beside."""
    points = dict(reading.points)
    points["strut_bottom"], points["strut_top"] = points.pop("spring_bottom"), points.pop("spring_top")
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


def _add_elements(reading: _Reading, table: dict[str, Any]) -> None:
    points = table["hardpoints"]
    stops = stop_tables(reading.file, float(np.linalg.norm(points["strut_top"] - points["strut_bottom"])))
    table["strut"] |= {"spring": spring_table(reading.file), "damper": damper_table(reading.file), **stops}
    reading.findings += element_findings(reading.file, stops)
    if stops:
        reading.estimated += [*STOP_ESTIMATE, *(path.replace("bump", "rebound") for path in STOP_ESTIMATE)]


def _add_wheel(
    reading: _Reading, table: dict[str, Any], radius: float | None, mass: float | None, stiffness: float | None
) -> None:
    """Wheel, tyre and the body that turns with them; what is not given is estimated."""
    given = {"wheel.radius": radius, "bodies.wheel.mass": mass, "tyre.stiffness": stiffness}
    for name, value in given.items():
        if value is None:
            reading.estimated.append(name)
        elif not value > 0.0:
            raise DescriptionError("out of range", where=name, found=value, allowed="above 0")
    reading.estimated.append("bodies.wheel.inertia")
    file = reading.file
    radius = WHEEL_RADIUS if radius is None else radius
    spindle = reading.body("wheel", "Spindle", DESIGN)
    rolling = WHEEL_MASS if mass is None else mass
    table["wheel"] = {
        "radius": radius,
        "camber": file.angle("Camber Angle (deg)"),
        "toe": file.angle("Toe Angle (deg)"),
    }
    centre = table["hardpoints"]["wheel_centre"]
    table["bodies"]["wheel"] = joined(spindle, rolling, centre, wheel_tensor(rolling, radius))
    table["tyre"] = {"stiffness": TYRE_STIFFNESS if stiffness is None else stiffness}


def _set_on_the_road(reading: _Reading, table: dict[str, Any], sprung_mass: float | None) -> None:
    """Find the sprung mass, then move everything up until the tyre carries the corner."""
    _raise(table, table["wheel"]["radius"] - table["hardpoints"]["wheel_centre"][2])
    table["sprung"] = {"mass": SPRUNG_MASS if sprung_mass is None else sprung_mass}
    rig = _rig(reading, table)
    if sprung_mass is None:
        reading.estimated.append("sprung.mass")
        table["sprung"]["mass"] = _carried(reading, rig)
        rig = _rig(reading, table)
    _raise(table, -static_tyre_deflection(rig))


def _carried(reading: _Reading, rig: Corner) -> float:
    """Sprung mass in kg that spring and stops hold at design position, or the general estimate."""
    surplus = spring_force(rig) - static_spring_force(rig)
    mass = SPRUNG_MASS + surplus * motion_ratio(rig) / rig.gravity
    if mass > 20.0:
        message = f"the sprung mass is not in the file; {mass:.4g} kg is what the spring carries at design position."
    else:
        message = (
            f"the sprung mass is not in the file, and the spring carries nothing at design: {SPRUNG_MASS:g} kg assumed."
        )
        mass = SPRUNG_MASS
    reading.findings.append(Finding(reading.file.at("sprung mass"), "note", message, mass))
    return float(f"{mass:.6g}")


def _rig(reading: _Reading, table: dict[str, Any]) -> Corner:
    return cast(Corner, rig_from_table(tomllib.loads(rig_text(table)), where=str(reading.file.path)))


def _raise(table: dict[str, Any], height: float) -> None:
    """Move a rig up by a height in m."""
    up = np.array([0.0, 0.0, round(height, 6)])
    table["hardpoints"] = {name: point + up for name, point in table["hardpoints"].items()}
    for body in table["bodies"].values():
        body["centre_of_mass"] = np.array(body["centre_of_mass"]) + up


def _left_out(file: ChronoFile, names: dict[str, tuple[str, str]]) -> list[Finding]:
    """What the file holds and the rig does not."""
    read = {*_READ, *(section for section, _ in names.values()), "Upright", "Strut", "Spindle"}
    found = [
        Finding(file.at(section), "warning", "this section is not read.")
        for section in file.table
        if section not in read
    ]
    bushed = [section for section in file.table if file.has(section, "Bushing Data")]
    found += [
        Finding(file.at(section, "Bushing Data"), "warning", "bushings are not read: the joints are rigid.")
        for section in bushed
    ]
    links = [section for section in file.table if file.has(section, "Universal Joint Axis Link")]
    if links:
        message = "the axes of the universal joints are not read: links do not turn about themselves."
        found.append(Finding(file.at(links[0]), "note", message))
    return found


def _assumptions(file: ChronoFile) -> list[Finding]:
    """What is taken for granted about every file."""
    if file.table.get("Vehicle-Frame Inertia") is True:
        frames = "inertias are taken in vehicle axes, as the file says (Vehicle-Frame Inertia)."
    else:
        frames = (
            "inertias are taken in each body's own axes, as Chrono does: of arms x along the axis and z normal to the "
            "arm, of links z along the link, of all other bodies those of the vehicle."
        )
    rolling = (
        "rim and tyre stand in other files; their mass is added to the spindle, with the inertia of a common wheel."
    )
    return [Finding(file.at("Vehicle-Frame Inertia"), "note", frames), Finding(file.at("Spindle"), "note", rolling)]


def _comments(reading: _Reading) -> list[str]:
    name = str(reading.file.path)
    lines = [f"{item.place.removeprefix(f'{name}: ')}: {item.message}" for item in reading.findings]
    return [
        f"Left corner imported from {reading.file.path.name} of Project Chrono (BSD-3-Clause). z = 0 is the road.",
        *lines,
    ]
