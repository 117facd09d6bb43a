"""Assembly of rigs from files of other programs; missing values are estimated and listed."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Any, NamedTuple, TypeAlias, cast

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding, finding
from jounce.core.operation import Names, Number
from jounce.core.typed import LONGEST
from jounce.core.types import Array
from jounce.parts.advice import rig_findings
from jounce.parts.bodies import INERTIA_ELEMENTS
from jounce.parts.corners import Corner
from jounce.parts.files import rig_from_table
from jounce.parts.leverage import (
    motion_ratio,
    spring_force,
    static_spring_force,
    static_tyre_deflection,
)

WHEEL_RADIUS, WHEEL_MASS, TYRE_STIFFNESS, SPRUNG_MASS = 0.33, 20.0, 250e3, 350.0
"""Defaults of a passenger car for values missing in suspension files: m, kg (rim and tyre), N/m, kg."""


def length_of_tyre(default: str) -> Number:
    """Return the option for the tyre radius; ``default`` describes its default."""
    return Number(
        f"Undeformed tyre radius. Default: {default}.", unit="m", is_positive=True, most=LONGEST
    )


def sprung_mass_of(default: str) -> Number:
    """Return the option for the sprung mass; ``default`` describes its default."""
    return Number(f"Sprung mass on this wheel. Default: {default}.", unit="kg", is_positive=True)


WheelMass: TypeAlias = Annotated[
    float | None,
    Number("Mass of rim and tyre. Default: 20 kg (estimated).", unit="kg", is_positive=True),
]
TyreStiffness: TypeAlias = Annotated[
    float | None,
    Number("Tyre stiffness. Default: 250 N/mm (estimated).", unit="N/m", is_positive=True),
]
TYRE_RADIUS = length_of_tyre("330 mm (estimated)")
CARRIED_MASS = sprung_mass_of("what the spring carries at design (estimated)")
NAMES_IN_FILE = Names("A name in the file and the hardpoint it is.", "THEIRS=OURS")


class ImportedRig(NamedTuple):
    """Rig read from a file of a different program, with findings and the text of its rig file."""

    rig: Corner
    findings: list[Finding]
    text: str

    def __str__(self) -> str:
        return self.text

    @property
    def printed(self) -> str:
        """Text for the terminal if no file is written."""
        return self.text

    def advice(self, where: str = "") -> list[Finding]:
        """Return findings of the import, and of the rig in the file ``where``."""
        return [*self.findings, *rig_findings(self.rig, where)]

    def to_dict(self, where: str = "") -> dict[str, Any]:
        """Return the import as plain data, with the text of the rig file."""
        rig = self.rig
        about = {
            "model": getattr(rig, "model", ""),
            "source": rig.source,
            "estimated": list(rig.estimated),
        }
        return {**about, "findings": self.advice(where), "text": self.text}


@dataclass
class Draft:
    """Findings and paths of estimated values of a rig during assembly."""

    path: Path
    findings: list[Finding] = field(default_factory=list)
    estimated: list[str] = field(default_factory=list)

    def note(self, code: str, place: str, value: float | None = None, /, **numbers: Any) -> None:
        """Add a finding from the catalogue for a path."""
        self.findings.append(finding(code, place, value, **numbers))

    def at(self, *keys: str) -> str:
        """Return the location of a value for messages."""
        return ": ".join((str(self.path), *keys))


def as_table(mass: float, centre: Array, tensor: Array) -> dict[str, Any]:
    """Return the table of a body as in rig files."""
    size = float(np.abs(tensor).max())
    inertia = {
        name: float(tensor[at])
        for name, at in INERTIA_ELEMENTS.items()
        if abs(tensor[at]) > 1e-9 * size
    }
    return {"mass": mass, "centre_of_mass": centre, "inertia": inertia}


def join_bodies(body: dict[str, Any], mass: float, centre: Array, tensor: Array) -> dict[str, Any]:
    """Combine a body and a mass fixed to it into one table (kg, m, kg m^2)."""
    masses, centres = (body["mass"], mass), (np.array(body["centre_of_mass"]), centre)
    whole = masses[0] + masses[1]
    middle = (masses[0] * centres[0] + masses[1] * centres[1]) / whole
    total = tensor_of(body) + tensor
    for part, place in zip(masses, centres, strict=True):
        away = place - middle
        total = total + part * ((away @ away) * np.eye(3) - np.outer(away, away))
    return as_table(whole, middle, total)


def tensor_of(table: dict[str, Any]) -> Array:
    """Return the inertia tensor of a body's table, shape (3, 3), kg m^2."""
    xx, yy, zz, xy, xz, yz = (table["inertia"].get(name, 0.0) for name in INERTIA_ELEMENTS)
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def add_wheel(
    draft: Draft,
    table: dict[str, Any],
    spindle: dict[str, Any] | None,
    angles: dict[str, float],
    given: tuple[float | None, float | None, float | None],
) -> None:
    """Add wheel, tyre and the body that rotates with them; estimate missing values (radius, mass, stiffness).

    ``spindle`` is the table of other rotating parts, ``angles`` contains camber and toe (rad).
    """
    radius, mass, stiffness = given
    named = {"wheel.radius": radius, "bodies.wheel.mass": mass, "tyre.stiffness": stiffness}
    for name, value in named.items():
        if value is None:
            draft.estimated.append(name)
        elif not value > 0.0:
            raise DescriptionError("out of range", where=name, found=value, allowed="above 0")
    draft.estimated.append("bodies.wheel.inertia")
    radius = WHEEL_RADIUS if radius is None else radius
    rolling = WHEEL_MASS if mass is None else mass
    table["wheel"] = {"radius": radius, **angles}
    centre = table["hardpoints"]["wheel_centre"]
    # the inertia of rim and tyre is estimated: 0.6 m r^2 about the axle, 0.35 m r^2 across it
    inertia = rolling * radius**2 * np.diag([0.35, 0.6, 0.35])
    whole = (
        as_table(rolling, centre, inertia)
        if spindle is None
        else join_bodies(spindle, rolling, centre, inertia)
    )
    table["bodies"]["wheel"] = whole
    table["tyre"] = {"stiffness": TYRE_STIFFNESS if stiffness is None else stiffness}


def set_on_the_road(draft: Draft, table: dict[str, Any], sprung_mass: float | None) -> None:
    """Determine the sprung mass, then raise the rig until the tyre carries the corner."""
    raise_rig(table, table["wheel"]["radius"] - table["hardpoints"]["wheel_centre"][2])
    table["sprung"] = {"mass": SPRUNG_MASS if sprung_mass is None else sprung_mass}
    rig = rig_of(draft, table)
    if sprung_mass is None:
        draft.estimated.append("sprung.mass")
        table["sprung"]["mass"] = _estimate_sprung_mass(draft, rig)
        rig = rig_of(draft, table)
    raise_rig(table, -static_tyre_deflection(rig))


def _estimate_sprung_mass(draft: Draft, rig: Corner) -> float:
    """Estimate the sprung mass (kg) that spring and stops carry at design, or return the default."""
    try:
        ratio = motion_ratio(rig)
        mass = SPRUNG_MASS + (spring_force(rig) - static_spring_force(rig)) * ratio / rig.gravity
    except (np.linalg.LinAlgError, ZeroDivisionError):
        raise DescriptionError(
            "the joints prevent the wheel from rising, or allow more than one motion",
            where=str(draft.path),
        ) from None
    # kg, chosen: a lower limit would accept a nearly unloaded spring, a higher one reject that of a light kart.
    if mass > 20.0:
        draft.note("parts.import_mass_carried", draft.at("sprung mass"), mass, mass=mass)
    else:
        mass = SPRUNG_MASS
        draft.note("parts.import_carries_nothing", draft.at("sprung mass"), mass, mass=mass)
    return float(f"{mass:.6g}")


def rig_of(draft: Draft, table: dict[str, Any]) -> Corner:
    """Build a rig from a table with arrays."""

    def plain(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: plain(item) for key, item in value.items()}
        return value.tolist() if isinstance(value, np.ndarray) else value

    return cast(Corner, rig_from_table(plain(table), where=str(draft.path)))


def raise_rig(table: dict[str, Any], height: float) -> None:
    """Move a rig up by a height in m."""
    up = np.array([0.0, 0.0, round(height, 6)])
    table["hardpoints"] = {name: point + up for name, point in table["hardpoints"].items()}
    for body in table["bodies"].values():
        body["centre_of_mass"] = np.array(body["centre_of_mass"]) + up
