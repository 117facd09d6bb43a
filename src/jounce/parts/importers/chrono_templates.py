"""Templates of Project Chrono: which point and which body of a file is which of a rig."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.parts.importers.chrono_bodies import DESIGN, about_axis, arm_frame, body_table, joined, rod_frame
from jounce.parts.importers.chrono_corner import HARDPOINTS
from jounce.parts.importers.chrono_file import ChronoFile
from jounce.parts.points import distance_to_line

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


@dataclass
class Reading:
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
        corners = self.points[front], self.points[rear], self.points[outer]
        return self.body(name, section, arm_frame(*corners, self.file.at(section)))


def _head(reading: Reading, model: str, bodies: dict[str, Any], on: str, **more: Any) -> dict[str, Any]:
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


def _double_wishbone(reading: Reading) -> dict[str, Any]:
    arms = {
        f"{side}_arm": reading.arm(
            f"{side}_arm", f"{side.title()} Control Arm", f"{side}_arm_front", f"{side}_arm_rear", f"{side}_ball_joint"
        )
        for side in ("lower", "upper")
    }
    bodies = {**arms, "upright": reading.body("upright", "Upright", DESIGN)}
    _add_tie_rod(reading, bodies)
    return _head(reading, "double-wishbone", bodies, "lower_arm", steering={"rack_travel": 0.0})


def _mcpherson(reading: Reading) -> dict[str, Any]:
    bodies = {
        "lower_arm": reading.arm("lower_arm", "Control Arm", "lower_arm_front", "lower_arm_rear", "lower_ball_joint"),
        "upright": reading.body("upright", "Upright", DESIGN),
    }
    if reading.file.has("Strut", "Mass"):
        middle = (reading.points["spring_top"] + reading.points["spring_bottom"]) / 2.0
        bodies["strut"] = reading.body("strut", "Strut", DESIGN, middle)
    _add_tie_rod(reading, bodies)
    return _head(reading, "mcpherson", bodies, "upright", steering={"rack_travel": 0.0})


def _five_link(reading: Reading) -> dict[str, Any]:
    points, file = reading.points, reading.file
    ways = {"link_3": ("Lateral", points["link_4_outer"]), "link_4": ("Trailing Link", points["spring_bottom"])}
    links = {}
    for name, (section, beside) in ways.items():
        inner, outer = points[f"{name}_inner"], points[f"{name}_outer"]
        frame = rod_frame(outer, inner, np.cross(outer - beside, inner - beside), file.at(section))
        links[name] = reading.body(name, section, frame)
    upright = reading.body("upright", "Upright", DESIGN)
    arm = reading.arm("upright", "Upper Arm", "link_1_inner", "link_2_inner", "link_1_outer")
    ends = points["link_1_inner"], points["link_2_inner"]
    lever = distance_to_line(points["link_1_outer"], *ends)
    share = about_axis(arm, *ends) / lever**2
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
        **links,
    }
    if file.has("Tierod", "Mass"):
        bodies["link_5"] = _tie_rod(reading, "link_5", points["link_5_inner"], points["link_5_outer"])
    return _head(reading, "five-link", bodies, "link_4")


def _add_tie_rod(reading: Reading, bodies: dict[str, Any]) -> None:
    if reading.file.has("Tierod", "Mass"):
        bodies["tie_rod"] = _tie_rod(
            reading, "tie_rod", reading.points["tie_rod_inner"], reading.points["tie_rod_outer"]
        )


def _tie_rod(reading: Reading, name: str, inner: Array, outer: Array) -> dict[str, Any]:
    across = np.cross(outer - inner, [1.0, 0.0, 0.0])
    return reading.body(
        name, "Tierod", rod_frame(inner, outer, across, reading.file.at("Tierod")), (inner + outer) / 2.0
    )


TEMPLATES: dict[str, tuple[dict[str, tuple[str, str]], Callable[[Reading], dict[str, Any]]]] = {
    "DoubleWishbone": (HARDPOINTS, _double_wishbone),
    "MacPhersonStrut": (_MACPHERSON, _mcpherson),
    "MultiLink": (_MULTI_LINK, _five_link),
}
