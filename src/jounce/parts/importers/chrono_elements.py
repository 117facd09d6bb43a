"""Springs, dampers and stops of Project Chrono as tables of a rig file, in jounce's signs.

Chrono's curves are forces over lengthening and its rate, positive in tension; jounce's are over shortening, positive in
compression. Both axes change sign, so the points change their order too.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.parts.importers.chrono_corner import damper_map
from jounce.parts.importers.chrono_file import ChronoFile, ascending

STOP_RATE, STOP_PROGRESSION = 1.0e5, 6.0e7
"""Stop in N/m and N/m^3 within 8 % of the points that Chrono uses for every vehicle, from 2 mm to 50 mm of depth."""
STOP_ESTIMATE = ("strut.bump_stop.rate", "strut.bump_stop.progression")


def spring_table(file: ChronoFile) -> dict[str, Any]:
    """Table of ``strut.spring``: rate or curve, with its free length in m."""
    free, preload = file.positive("Spring", "Free Length"), file.number("Spring", "Preload", 0.0)
    if file.has("Spring", "Spring Coefficient"):
        rate = file.positive("Spring", "Spring Coefficient")
        return {"rate": rate, "free_length": free + preload / rate}
    key = "Curve Data" if file.has("Spring", "Curve Data") else "Spring Curve Data"
    lengthening, force = file.curve("Spring", key)
    curve = {"kind": "table", "deflection": -lengthening[::-1], "force": preload - force[::-1]}
    return {"curve": curve, "free_length": free}


def damper_table(file: ChronoFile) -> dict[str, Any]:
    """Table of ``strut.damper``: linear, through points of velocity, or a map over length and velocity."""
    if file.has("Shock", "Map Data"):
        found = damper_map(file)
        return {
            "kind": "map",
            "length": found.length + file.number("Shock", "Free Length", 0.0),
            "velocity": -found.velocity[::-1],
            "force": -found.force.T[:, ::-1],
        }
    key = "Curve Data" if file.has("Shock", "Curve Data") else "Damping Curve Data"
    if file.has("Shock", key):
        lengthening, force = file.curve("Shock", key)
        return {"kind": "table", "velocity": -lengthening[::-1], "force": -force[::-1]}
    coefficient = file.positive("Shock", "Damping Coefficient")
    if not file.has("Shock", "Degressivity Compression", "Degressivity Expansion"):
        return {"coefficient": coefficient}
    shares = [file.number("Shock", f"Degressivity {way}", 0.0) for way in ("Expansion", "Compression")]
    return {"kind": "table", **_degressive(coefficient, shares[0], shares[1])}


def stop_tables(file: ChronoFile, design_length: float) -> dict[str, Any]:
    """Tables of ``strut.bump_stop`` and ``strut.rebound_stop``; ``design_length`` of the spring in m."""
    if not file.has("Spring", "Minimum Length", "Maximum Length"):
        return {}
    shortest, longest = file.positive("Spring", "Minimum Length"), file.positive("Spring", "Maximum Length")
    ascending(np.array([shortest, longest]), file.at("Spring", "Minimum Length"))
    law = {"rate": STOP_RATE, "progression": STOP_PROGRESSION}
    return {
        "bump_stop": {"gap": design_length - shortest, **law},
        "rebound_stop": {"gap": longest - design_length, **law},
    }


def element_findings(file: ChronoFile, tables: dict[str, Any]) -> list[Finding]:
    """What the reader must know about the elements that were read."""
    found = []
    if "bump_stop" in tables:
        found.append(
            Finding(
                file.at("Spring", "Minimum Length"),
                "note",
                "stops work from the spring's shortest and longest length on, with the law that Chrono gives every "
                "vehicle: 100 N/mm and rising.",
            )
        )
    if file.has("Shock", "Degressivity Compression"):
        found.append(
            Finding(file.at("Shock"), "note", "the degressive damper is read as a table that follows it to 3 m/s.")
        )
    return found


def _degressive(coefficient: float, expansion: float, compression: float) -> dict[str, Array]:
    """Damper ``c v / (1 + share |v|)`` at points of velocity, bump positive."""
    if min(expansion, compression) < 0.0:
        raise DescriptionError("a degressivity below 0", found=[expansion, compression], allowed="at least 0")
    speeds = np.array([0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.5, 2.0, 3.0])
    bump = coefficient * speeds / (1.0 + compression * speeds)
    rebound = coefficient * speeds / (1.0 + expansion * speeds)
    return {
        "velocity": np.concatenate([-speeds[::-1], [0.0], speeds]),
        "force": np.concatenate([-rebound[::-1], [0.0], bump]),
    }
