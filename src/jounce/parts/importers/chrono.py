"""Suspensions of Project Chrono as 3-D rigs: double wishbone, MacPherson strut and multi-link."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any, cast

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding
from jounce.parts.corner import Corner
from jounce.parts.importers.chrono_bodies import DESIGN, joined, wheel_tensor
from jounce.parts.importers.chrono_elements import (
    STOP_ESTIMATE,
    damper_table,
    element_findings,
    spring_table,
    stop_tables,
)
from jounce.parts.importers.chrono_file import ChronoFile
from jounce.parts.importers.chrono_templates import TEMPLATES, Reading
from jounce.parts.leverage import motion_ratio, spring_force, static_spring_force, static_tyre_deflection
from jounce.parts.loading import rig_from_table
from jounce.parts.writing import rig_text

WHEEL_RADIUS, WHEEL_MASS, TYRE_STIFFNESS, SPRUNG_MASS = 0.33, 20.0, 250e3, 350.0
"""Estimates for what suspension files do not hold: m, kg (rim and tyre), N/m, kg; those of a passenger car."""
_ADVICE = "Other suspensions can be written as rig files by hand; see the documentation of rigs."
_READ = {"Name", "Type", "Template", "Vehicle-Frame Inertia", "Camber Angle (deg)", "Toe Angle (deg)", "Axle"}


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
    ('double-wishbone', 'map', 692)
    """
    file = ChronoFile(Path(path), list(TEMPLATES), _ADVICE)
    names, build = TEMPLATES[file.template]
    reading = Reading(file, {name: file.numbers(section, key, (3,)) for name, (section, key) in names.items()})
    table = build(reading)
    _add_elements(reading, table)
    _add_wheel(reading, table, wheel_radius, wheel_mass, tyre_stiffness)
    _set_on_the_road(reading, table, sprung_mass)
    reading.findings += [*_left_out(file, names), *_assumptions(file)]
    table |= {"estimated": sorted(reading.estimated), "source": table["source"] if source is None else source}
    text = rig_text(_rig(reading, table), _comments(reading))
    return cast(Corner, rig_from_table(tomllib.loads(text), where=str(path))), reading.findings, text


def _add_elements(reading: Reading, table: dict[str, Any]) -> None:
    points = table["hardpoints"]
    stops = stop_tables(reading.file, float(np.linalg.norm(points["strut_top"] - points["strut_bottom"])))
    table["strut"] |= {"spring": spring_table(reading.file), "damper": damper_table(reading.file), **stops}
    reading.findings += element_findings(reading.file, stops)
    if stops:
        reading.estimated += [*STOP_ESTIMATE, *(path.replace("bump", "rebound") for path in STOP_ESTIMATE)]


def _add_wheel(
    reading: Reading, table: dict[str, Any], radius: float | None, mass: float | None, stiffness: float | None
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


def _set_on_the_road(reading: Reading, table: dict[str, Any], sprung_mass: float | None) -> None:
    """Find the sprung mass, then move everything up until the tyre carries the corner."""
    _raise(table, table["wheel"]["radius"] - table["hardpoints"]["wheel_centre"][2])
    table["sprung"] = {"mass": SPRUNG_MASS if sprung_mass is None else sprung_mass}
    rig = _rig(reading, table)
    if sprung_mass is None:
        reading.estimated.append("sprung.mass")
        table["sprung"]["mass"] = _carried(reading, rig)
        rig = _rig(reading, table)
    _raise(table, -static_tyre_deflection(rig))


def _carried(reading: Reading, rig: Corner) -> float:
    """Sprung mass in kg that spring and stops hold at design position, or the general estimate."""
    try:
        ratio = motion_ratio(rig)
        mass = SPRUNG_MASS + (spring_force(rig) - static_spring_force(rig)) * ratio / rig.gravity
    except (np.linalg.LinAlgError, ZeroDivisionError):
        raise DescriptionError(
            "the joints do not let the wheel rise, or not in one way only", where=str(reading.file.path)
        ) from None
    if mass > 20.0:
        message = f"the sprung mass is not in the file; {mass:.4g} kg is what the spring carries at design position."
    else:
        message = (
            f"the sprung mass is not in the file, and the spring carries nothing at design: {SPRUNG_MASS:g} kg assumed."
        )
        mass = SPRUNG_MASS
    reading.findings.append(Finding(reading.file.at("sprung mass"), "note", message, mass))
    return float(f"{mass:.6g}")


def _rig(reading: Reading, table: dict[str, Any]) -> Corner:
    return cast(Corner, rig_from_table(_plain(table), where=str(reading.file.path)))


def _plain(value: Any) -> Any:
    """The same table with lists in place of arrays."""
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    return value.tolist() if isinstance(value, np.ndarray) else value


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


def _comments(reading: Reading) -> list[str]:
    name = str(reading.file.path)
    lines = [f"{item.place.removeprefix(f'{name}: ')}: {item.message}" for item in reading.findings]
    return [
        f"Left corner imported from {reading.file.path.name} of Project Chrono (BSD-3-Clause). z = 0 is the road.",
        *lines,
    ]
