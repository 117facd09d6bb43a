"""Suspensions and poses at which every row of the kinematic catalogue is held against differences of poses."""

from __future__ import annotations

from functools import cache

from axle_from_wheels import rolled, steered
from catalogue_from_poses import FromPoses

import jounce as jn
from jounce.kinematics.catalogue import CATALOGUE

_BAR = {
    "hardpoints.arb_pivot": [-0.08, 0.15, 0.36],
    "hardpoints.arb_arm_end": [-0.15, 0.15, 0.44],
    "hardpoints.arb_link_end": [0.0, 0.22, 0.43],
    "anti_roll_bar": {"stiffness": 900.0, "on": "rocker"},
}
_GAS = {
    "kind": "tanh",
    "coefficient": 2000.0,
    "force": 150.0,
    "slope": 20.0,
    "stiffness": 900.0,
    "offset": 250.0,
}
_THIRD_GAS = {**_GAS, "coefficient": 800.0, "force": 0.0, "offset": 60.0}
_BESIDE = {
    "third_spring": {"spring": {"rate": 30e3, "preload": 150.0}, "damper": _THIRD_GAS},
    "hardpoints.third_spring_end": [0.02, 0.21, 0.42],
    "torsion_bar": {"stiffness": 1900.0, "preload": 120.0, "on": "lower_arm"},
    "strut.bump_stop": {"gap": "5 mm", "rate": "60 N/mm"},
}
SUSPENSIONS = {
    "double wishbone": ("reference-double-wishbone", {}),
    "double wishbone, push rod, U-bar": ("formula-student-front", {**_BAR, **_BESIDE}),
    "the same with a Z-bar, on the right": (
        "formula-student-front",
        {**_BAR, **_BESIDE, "anti_roll_bar.kind": "z"},
    ),
    "McPherson strut": ("generic-mcpherson", {"strut.damper": _GAS}),
    "five links": ("sedan-multi-link", {}),
    "semi-trailing arm": ("semi-trailing-arm", {}),
}
CASES = [
    ("double wishbone", -0.03, 0.01),
    ("double wishbone, push rod, U-bar", 0.017, -0.008),
    ("double wishbone, push rod, U-bar", -0.011, 0.012),
    ("the same with a Z-bar, on the right", 0.017, 0.009),
    ("McPherson strut", 0.03, -0.01),
    ("five links", 0.03, 0.01),
    ("five links", -0.02, -0.006),
    ("semi-trailing arm", 0.025, None),
]
"""Suspension, wheel travel and rack travel (m)."""
ROLLS, RACKS = ((0.02, 0.0), (-0.015, 0.012)), (0.015, -0.012)
"""Roll of the body (rad) with travel of the rack (m), and travel of the rack alone, of an axle."""
SCALES = {
    "m": 1e-2,
    "rad": 1e-2,
    "1": 1e-2,
    "rad/m": 0.1,
    "1/m": 0.1,
    "rad/m^2": 1.0,
    "m/rad": 1e-3,
}
"""Sizes (SI) to which differences of rows near zero are related; of the other units the rows are not near zero."""


@cache
def rig_of(name: str):
    """The rig of a case."""
    rig, changes = SUSPENSIONS[name]
    kind = changes.get("anti_roll_bar.kind")
    found = jn.load(rig).with_changes(
        {path: value for path, value in changes.items() if path != "anti_roll_bar.kind"}
    )
    found = found if kind is None else found.with_changes({"anti_roll_bar.kind": kind})
    return found.mirrored() if "right" in name else found


def compared_axle() -> dict[str, float]:
    """Of each row of an axle how far both are apart, relative to its size; stops are open."""
    changes = {path: value for path, value in _BAR.items() if path != "strut.bump_stop"}
    column = {
        "handwheel": [-0.7, 0.0, 0.6],
        "upper_joint": [-0.4, 0.0, 0.5],
        "lower_joint": [-0.1, 0.02, 0.25],
    }
    changes["steering"] = {"rack_ratio": 0.013, "column": {**column, "pinion": [0.06, 0.03, 0.148]}}
    changes["strut.bump_stop"] = {"gap": 0.06, "rate": 1e5}
    rig = jn.load("formula-student-front").with_changes(changes)
    car = jn.AxleLayout(
        axle="front",
        wheelbase=1.55,
        centre_of_mass_height=0.3,
        brake_share=0.6,
        front_overhang=0.7,
        body_width=1.2,
    )
    pairs = [rolled(rig, roll, rack) for roll, rack in ROLLS]
    pairs += [steered(rig, car, rack, 0.006) for rack in RACKS]
    found: dict[str, float] = {}
    for own, wanted in pairs:
        for name, value in wanted.items():
            apart = abs(own[name] - value) / max(abs(value), 1e-3)
            bare = name.removeprefix("left.").removeprefix("right.")
            found[bare] = max(found.get(bare, 0.0), apart)
    return found


def compared(
    name: str, travel: float, rack: float | None
) -> tuple[dict[str, float], dict[str, float]]:
    """Of each row how far both are apart, relative to its size; and how far shapes of links and bodies change, m."""
    rig = rig_of(name)
    poses = FromPoses(rig, jn.sweep_travel, travel, 0.0 if rack is None else rack)
    swept, wanted = jn.sweep_travel(rig, [travel], rack), poses.rows()
    units = {row.name: row.unit for row in CATALOGUE}
    found = {}
    for one in wanted:
        own = float(swept[one].to_numpy().ravel()[0])
        found[one] = abs(wanted[one] - own) / max(abs(wanted[one]), SCALES.get(units[one], 1e-6))
    return found, poses.shape_errors()
