"""Findings about rigs: each with a rig that deserves it, and none for rigs that do not."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from jounce.parts import Corner, library, load, rig_findings
from jounce.parts.leverage import (
    force_at,
    motion_ratio,
    spring_force,
    static_load,
    static_spring_force,
    static_tyre_deflection,
    torsion_ratio,
)

FILES = Path(__file__).parents[2] / "files"
REFERENCE = load("reference-double-wishbone")
POINTS = [f"hardpoints.{name}" for name in REFERENCE.hardpoints.given()]


def test_levers_and_statics_of_the_specified_prototype():
    """Published with the case: motion ratio 0.50595500, strut 322.37155325 N, tyre 207.972 N / 138468 N/m."""
    rig = load(FILES / "prototype-double-wishbone.toml")
    assert motion_ratio(rig) == pytest.approx(0.5059550010708399, rel=1e-12)
    assert static_spring_force(rig) == pytest.approx(322.37155324877654, rel=1e-12)
    assert spring_force(rig) == pytest.approx(322.37155324877654, rel=1e-12)
    assert static_tyre_deflection(rig) == pytest.approx(207.972 / 138468.0, rel=1e-12)
    assert rig_findings(rig) == []


def test_lever_of_the_reference_mechanism():
    """Table of the reference mechanism: 0.698500 at the wheel centre, spring on the lower arm."""
    assert motion_ratio(REFERENCE) == pytest.approx(0.698500, abs=5e-7)
    assert motion_ratio(REFERENCE.mirrored()) == pytest.approx(motion_ratio(REFERENCE), rel=1e-12)
    assert motion_ratio(REFERENCE, "damper") == motion_ratio(REFERENCE)


def test_lever_of_a_vertical_strut_over_the_wheel_is_one():
    changes = {
        "hardpoints.strut_bottom": [0.0, 0.76, 0.3],
        "hardpoints.strut_top": [0.0, 0.76, 0.6],
        "strut.on": "upright",
    }
    assert motion_ratio(REFERENCE.with_changes(changes)) == pytest.approx(1.0, rel=1e-12)


def test_lever_through_a_rocker():
    """A rocker with equal arms turns the push rod's motion by a right angle and keeps its size."""
    rocker = {
        "hardpoints.pushrod_outer": [0.0, 0.76, 0.3],
        "hardpoints.pushrod_inner": [0.0, 0.76, 0.8],
        "hardpoints.rocker_pivot": [0.0, 0.66, 0.8],
        "hardpoints.rocker_axis": [0.1, 0.66, 0.8],
        "hardpoints.strut_bottom": [0.0, 0.66, 0.9],
        "hardpoints.strut_top": [0.0, 0.36, 0.9],
        "bodies.rocker": {
            "mass": 1.0,
            "centre_of_mass": [0.0, 0.7, 0.83],
            "inertia": {"xx": 0.01, "yy": 0.01, "zz": 0.01},
        },
        "strut.on": "rocker",
        "strut.pushrod_on": "upright",
    }
    assert motion_ratio(REFERENCE.with_changes(rocker)) == pytest.approx(1.0, rel=1e-12)
    doubled = {
        **rocker,
        "hardpoints.strut_bottom": [0.0, 0.66, 1.0],
        "hardpoints.strut_top": [0.0, 0.36, 1.0],
    }
    assert motion_ratio(REFERENCE.with_changes(doubled)) == pytest.approx(2.0, rel=1e-12)


@pytest.mark.parametrize("name", ["generic-mcpherson", "sedan-multi-link"])
def test_levers_agree_with_a_small_step(name: str):
    """The other way to the same number: joints solved 0.1 mm above and below design."""
    from scipy.optimize import root

    rig = load(name)
    points = {key: np.array(value) for key, value in rig.hardpoints.given().items()}
    origin = points["wheel_centre"]

    def placed(q: Any, point: Any) -> Any:
        x, y, z = q[3:]
        skew = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
        turn = np.eye(3) + skew + skew @ skew / 2.0  # of second order, which a small step needs
        return origin + q[:3] + turn @ (point - origin)

    def residual(q: Any, rise: float) -> Any:
        if name == "sedan-multi-link":
            rods = [(f"link_{i}_outer", f"link_{i}_inner") for i in range(1, 6)]
            held: list[float] = []
        else:
            rods = [("lower_ball_joint", f"lower_arm_{end}") for end in ("front", "rear")]
            rods.append(("tie_rod_outer", "tie_rod_inner"))
            bottom = placed(q, points["strut_bottom"])
            line = placed(q, points["strut_top"]) - bottom
            off = np.cross(line, points["strut_top"] - bottom)
            held = [off[0], off[1]]
        lengths = [
            np.linalg.norm(placed(q, points[outer]) - points[inner])
            - np.linalg.norm(points[outer] - points[inner])
            for outer, inner in rods
        ]
        return [*lengths, *held, q[2] - rise]

    def length(rise: float) -> float:
        q = root(residual, np.zeros(6), args=(rise,), method="lm", tol=1e-14).x
        if name == "generic-mcpherson":
            return float(np.linalg.norm(points["strut_top"] - placed(q, points["strut_bottom"])))
        inner, outer = points["link_4_inner"], placed(q, points["link_4_outer"])
        before, now = points["link_4_outer"] - inner, outer - inner
        axis = np.cross(before, now) / (
            before @ before
        )  # small turn of the link, none about itself
        away = points["strut_bottom"] - inner
        return float(np.linalg.norm(points["strut_top"] - inner - away - np.cross(axis, away)))

    step = 1e-4
    assert motion_ratio(rig) == pytest.approx(
        (length(-step) - length(step)) / (2.0 * step), rel=1e-5
    )


def test_forces_of_laws():
    rig = REFERENCE.with_changes(
        {
            "strut.bump_stop": {"gap": "10 mm", "rate": "100 N/mm", "progression": 1e9},
            "strut.rebound_stop": {"gap": "20 mm", "rate": "50 N/mm"},
        }
    )
    assert spring_force(rig) == pytest.approx(5726.56)
    assert spring_force(rig, 0.03) == pytest.approx(
        5726.56 + 40e3 * 0.03 + 100e3 * 0.02 + 1e9 * 0.02**3
    )
    assert spring_force(rig, -0.03) == pytest.approx(5726.56 - 40e3 * 0.03 - 50e3 * 0.01)
    curved = REFERENCE.with_changes(
        {
            "strut.spring": {
                "curve": {"kind": "table", "deflection": [0.0, 0.1], "force": [0.0, 5000.0]},
                "free_length": REFERENCE.hardpoints.length("spring") + 0.05,
            }
        }
    )
    assert spring_force(curved) == pytest.approx(2500.0)
    assert spring_force(curved, 0.1) == pytest.approx(7500.0), "tables go on beyond their ends"
    law = {
        "polynomial": {"coefficients": [2.0, 3.0]},
        "power": {"coefficient": 4.0, "exponent": 1.5},
    }
    tyres = {
        kind: REFERENCE.with_changes(
            {"tyre.stiffness": None, "tyre.curve": {"kind": kind, **law[kind]}}
        ).tyre.curve
        for kind in law
    }
    assert force_at(tyres["polynomial"], 2.0) == pytest.approx(16.0)
    assert (force_at(tyres["power"], 4.0), force_at(tyres["power"], -1.0)) == pytest.approx(
        (32.0, 0.0)
    )


@pytest.mark.parametrize(
    "name", ["kart-double-wishbone", "reference-double-wishbone", "kart-quarter-car"]
)
def test_nothing_is_found_where_nothing_is_wrong(name: str):
    assert rig_findings(load(name)) == []


@pytest.mark.parametrize("name", ["kart-double-wishbone", "reference-double-wishbone"])
def test_shipped_rigs_stand_in_equilibrium_at_design(name: str):
    rig = load(name)
    assert isinstance(rig, Corner)
    assert spring_force(rig) == pytest.approx(static_spring_force(rig), rel=1e-4)
    pressed = rig.undeformed_radius - rig.hardpoints.wheel_centre[2]
    assert pressed == pytest.approx(static_tyre_deflection(rig), abs=1e-6)


def test_kart_has_the_dimensions_that_its_paper_gives():
    """20 mm at the upright turn it by 5 deg, 20 mm at the steering arm by 10.5 deg; the strut stands at 26 deg."""
    points = {
        name: np.array(point)
        for name, point in load("kart-double-wishbone").hardpoints.given().items()
    }
    upright = points["upper_ball_joint"] - points["lower_ball_joint"]
    assert np.linalg.norm(upright) == pytest.approx(0.020 / np.tan(np.radians(5.0)), abs=1e-4)
    at_tie_rod = (
        points["lower_ball_joint"] + upright * 0.060 / upright[2]
    )  # the tie rod is 60 mm above the lower joint
    assert points["tie_rod_outer"][2] - points["lower_ball_joint"][2] == pytest.approx(0.060)
    base = at_tie_rod[0] - points["tie_rod_outer"][0]
    assert base == pytest.approx(0.020 / np.tan(np.radians(10.5)), abs=1e-4)
    strut = points["strut_top"] - points["strut_bottom"]
    assert np.degrees(np.arctan2(-strut[1], strut[2])) == pytest.approx(26.0, abs=0.01)
    for arm, ball in (("lower_arm", "lower_ball_joint"), ("upper_arm", "upper_ball_joint")):
        assert np.linalg.norm((points[ball] - points[f"{arm}_front"])[1:]) == pytest.approx(
            0.225, abs=1e-4
        )


def scaled(factor: float) -> Corner:
    points = {
        f"hardpoints.{name}": [factor * x for x in point]
        for name, point in REFERENCE.hardpoints.given().items()
    }
    return REFERENCE.with_changes(points)


SUSPICIOUS: list[tuple[dict[str, Any], str, str, float | None]] = [
    ({"wheel.radius": 3.0}, "wheel.radius", "implausible for a wheel", 3.0),
    ({"wheel.radius": 0.01}, "wheel.radius", "implausible for a wheel", 0.01),
    ({"wheel.camber": -1.0}, "wheel.camber", "were degrees given as rad", -1.0),
    ({"wheel.toe": 0.3}, "wheel.toe", "17.2 deg is a lot", 0.3),
    ({"tyre.undeformed_radius": 0.42}, "hardpoints.wheel_centre", "compressed by 120 mm", 0.12),
    ({"tyre.undeformed_radius": 0.2}, "hardpoints.wheel_centre", "100 mm above the road", -0.1),
    (
        {"hardpoints.strut_top": [0.01, 0.3, 0.52]},
        "hardpoints.strut_top",
        "leans 42.6 deg",
        np.arctan2(0.34, 0.37),
    ),
    (
        {"hardpoints.strut_top": [0.01, 0.52, 0.1]},
        "hardpoints.strut_top",
        "does not lie above strut_bottom",
        None,
    ),
    (
        {"hardpoints.lower_arm_front[0]": -0.15, "hardpoints.lower_arm_rear[0]": 0.15},
        "hardpoints.lower_arm_front",
        "lies behind lower_arm_rear",
        None,
    ),
    (
        {"hardpoints.tie_rod_inner[1]": 0.72},
        "hardpoints.tie_rod_inner",
        "further outboard than tie_rod_outer",
        None,
    ),
    (
        {"hardpoints.tie_rod_inner[1]": -0.02},
        "hardpoints.tie_rod_inner",
        "slightly beyond the middle",
        -0.02,
    ),
    (
        {"bodies.lower_arm.centre_of_mass[1]": 2.0},
        "bodies.lower_arm.centre_of_mass",
        "from the nearest",
        None,
    ),
    (
        {"bodies.lower_arm.centre_of_mass[2]": 147.0},
        "bodies.lower_arm.centre_of_mass",
        "from the nearest",
        None,
    ),
    (
        {"bodies.upright.inertia": {"xx": 850.0, "yy": 1200.0, "zz": 800.0}},
        "bodies.upright.inertia",
        "radius of gyration is 6124 mm",
        np.sqrt(1200.0 / 32.0),
    ),
    (
        {"strut.spring.rate": 400.0, "strut.spring.preload": 0.0},
        "strut.spring",
        "cannot carry the weight",
        None,
    ),
    (
        {"strut.spring.preload": 0.0},
        "strut.spring",
        "205 mm of wheel travel into bump",
        5726.52 / 40e3 / 0.6985,
    ),
    ({"strut.spring.preload": 11000.0}, "strut.spring", "of wheel travel into rebound", None),
    ({"sprung.mass": "40260 kg"}, "strut.spring", "cannot carry the weight", None),
    ({"tyre.stiffness": "20 N/mm"}, "tyre", "check the stiffness", None),
    (
        {"strut.bump_stop": {"gap": -0.005, "rate": 1e5}},
        "strut.bump_stop.gap",
        "compressed by 5 mm",
        -0.005,
    ),
    (
        {"strut.damper": {"velocity": [-1.0, 0.0, 1.0], "force": [500.0, 0.0, -300.0]}},
        "strut.damper.force",
        "500 N at -1 m/s drives the motion",
        500.0,
    ),
    ({"sprung.joint": [0.0, 0.0, 0.5]}, "sprung", "joint is not used", None),
    (
        {"estimated": ("bodies", "strut.damping")},
        "estimated",
        "'strut.damping' is neither a parameter",
        None,
    ),
    (
        {"strut.on": "upper_arm", "hardpoints.strut_bottom": [0.0, 0.455, 0.375]},
        "strut",
        "shortens by only 0.0",
        None,
    ),
]


@pytest.mark.parametrize(
    ("changes", "place", "message", "value"),
    SUSPICIOUS,
    ids=[s[1] + " " + s[2] for s in SUSPICIOUS],
)
def test_suspicious_rigs(changes: dict[str, Any], place: str, message: str, value: float | None):
    found = rig_findings(REFERENCE.with_changes(changes), "rig.toml")
    matching = [
        finding
        for finding in found
        if finding.place == f"rig.toml: {place}" and message in finding.message
    ]
    assert len(matching) == 1, [str(finding) for finding in found]
    if value is not None:
        assert matching[0].value == pytest.approx(value, rel=1e-3)


@pytest.mark.parametrize(
    ("factor", "message"), [(1e3, "millimetres given as metres"), (1e-3, "given as millimetres")]
)
def test_a_wrong_unit_everywhere_is_told_once(factor: float, message: str):
    found = rig_findings(scaled(factor))
    assert [finding.place for finding in found] == ["hardpoints"]
    assert message in found[0].message


@pytest.mark.parametrize("name", ["reference-double-wishbone", "generic-mcpherson"])
def test_a_ball_joint_inboard_of_its_pivots(name):
    rig = load(name)
    for arm in ("lower", "upper") if name.startswith("ref") else ("lower",):
        pivot = getattr(rig.hardpoints, f"{arm}_arm_front")[1]
        found = rig_findings(rig.with_changes({f"hardpoints.{arm}_ball_joint[1]": pivot - 0.02}))
        own = [item for item in found if item.place == f"hardpoints.{arm}_ball_joint"]
        assert own
        assert own[0].value < 0.0
        assert "inboard of a pivot" in own[0].message


def test_swapped_ball_joints():
    swapped = {
        **{
            f"hardpoints.lower_{name}": getattr(REFERENCE.hardpoints, f"upper_{name}")
            for name in ("arm_front", "arm_rear")
        },
        **{
            f"hardpoints.upper_{name}": getattr(REFERENCE.hardpoints, f"lower_{name}")
            for name in ("arm_front", "arm_rear")
        },
        "hardpoints.lower_ball_joint": REFERENCE.hardpoints.upper_ball_joint,
        "hardpoints.upper_ball_joint": REFERENCE.hardpoints.lower_ball_joint,
    }
    found = rig_findings(REFERENCE.with_changes(swapped))
    assert "hardpoints.upper_ball_joint" in [finding.place for finding in found]


def test_joints_that_do_not_let_the_wheel_rise():
    rig = load("sedan-multi-link")
    same_line = {f"hardpoints.link_{i}_inner": [0.0, 0.2, 0.1 * i] for i in range(1, 6)}
    parallel = {f"hardpoints.link_{i}_outer": [0.0, 0.7, 0.1 * i] for i in range(1, 6)}
    found = rig_findings(rig.with_changes({**same_line, **parallel}))
    assert [finding.message for finding in found if finding.place == "hardpoints"] == [
        "the joints do not allow the wheel to rise at design position, or allow more than one motion."
    ]


def test_every_shipped_rig_is_examined():
    assert all(isinstance(rig_findings(load(name)), list) for name in library())


def test_springs_beside_the_strut_carry_the_car_too() -> None:
    """A torsion bar alone: where it stands by its lever at design, and what it cannot hold."""
    plain = load("formula-student-front")
    table = plain.model_dump(by_alias=True, exclude_none=True)
    for name in ("spring", "bump_stop", "rebound_stop"):
        table["strut"].pop(name, None)
    table["torsion_bar"] = {"stiffness": 1900.0, "preload": 0.0, "on": "lower_arm"}
    rig = type(plain).from_table({**table, "guide": "vertical", "sprung": {"mass": 60.0}})
    lever = torsion_ratio(rig)
    travel = static_load(rig) / (1900.0 * lever**2)
    found = {
        item.place: item
        for item in rig_findings(rig.with_changes({"torsion_bar.stiffness": 950.0}))
    }
    assert found["torsion_bar"].value == pytest.approx(2.0 * travel, rel=1e-6)
    assert "mm of wheel travel into bump" in found["torsion_bar"].message
    assert "all springs together give 0 N" in found["torsion_bar"].message
    held = rig.with_changes({"torsion_bar.preload": static_load(rig) / lever})
    assert "torsion_bar" not in {item.place for item in rig_findings(held)}
    weak = rig.with_changes({"torsion_bar.stiffness": 20.0})
    message = next(item.message for item in rig_findings(weak) if item.place == "torsion_bar")
    assert "cannot carry the weight" in message
    assert "at the wheel centre" in message


def test_choices_may_be_estimated():
    """What carries the strut is a guess of importers, and no number."""
    rig = load("formula-student-front").with_changes(
        {"estimated": ["strut.on", "strut.onn", "guide"]}
    )
    said = [finding.message for finding in rig_findings(rig) if finding.place.endswith("estimated")]
    assert said == ["'strut.onn' is neither a parameter nor a part of this rig."]


def test_a_quarter_car_upon_its_stop_is_told():
    """Gaps are measured at standing cars; this one counts from the undeformed spring."""
    rig = load("kart-quarter-car")
    rest = rig.sprung.mass * rig.gravity / np.cos(rig.strut.angle) / rig.strut.spring.rate
    for gap, places in ((0.9 * rest, ["strut.bump_stop.gap"]), (1.1 * rest, [])):
        given = rig.with_changes({"strut.bump_stop": {"gap": gap, "rate": 60e3}})
        assert [finding.place for finding in rig_findings(given)] == places
