"""Adjustments of the prototype: what the paper's numbers ask for, what stays, what is refused; the inverse."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import AssemblyError, DescriptionError
from jounce.design.adjustments import (
    QUANTITIES,
    adjust_report,
    adjustment_findings,
    lengths_for,
    wheel_state,
)
from jounce.kinematics.adjustments import BLOCK_MASS, SETTINGS, apply_adjustments, arm_length
from jounce.parts.bodies import distance
from jounce.parts.leverage import spring_force

KART = jn.load("kart-double-wishbone")
REFERENCE = jn.load("reference-double-wishbone")
PAIRS = (
    ("lower_ball_joint", "upper_ball_joint"),
    ("lower_ball_joint", "tie_rod_outer"),
    ("lower_ball_joint", "wheel_centre"),
    ("upper_ball_joint", "wheel_centre"),
    ("tie_rod_outer", "wheel_centre"),
)


def degrees(value):
    return float(np.degrees(value))


# --- the paper's numbers -------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("arm", "sign"), [("upper", 1.0), ("lower", -1.0)])
def test_20_mm_of_an_arm_give_about_five_degrees_of_camber(arm, sign):
    """Domain A4: 20 mm at one arm, ball joints 228.6 mm apart: atan(20 / 228.6) = 5 deg; the tie rod turns it, too."""
    rig = apply_adjustments(KART, {f"{arm}_arm_length": "20 mm", "tie_rod_length": 0.0})
    assert degrees(rig.wheel.camber) == pytest.approx(sign * 5.0, abs=0.6)
    straight = lengths_for(KART, camber=f"{sign * 5.0} deg", toe="0 deg")
    assert 1e3 * getattr(straight, f"{arm}_arm_length") == pytest.approx(20.0, abs=1.2)


def test_20_mm_of_the_tie_rod_give_the_published_toe():
    """Domain A4: 20 mm at a steering arm with a base of 107.9 mm: 10.5 deg."""
    for sign in (1.0, -1.0):
        rig = apply_adjustments(KART, {"tie_rod_length": sign * 0.020})
        assert degrees(rig.wheel.toe) == pytest.approx(sign * 10.5, abs=0.35)


def test_published_ranges():
    assert (SETTINGS["upper_arm_length"].lowest, SETTINGS["upper_arm_length"].highest) == (
        0.0,
        0.020,
    )
    assert degrees(SETTINGS["strut_angle"].lowest) == pytest.approx(10.0)
    assert degrees(SETTINGS["strut_angle"].highest) == pytest.approx(26.0)
    for setting in SETTINGS.values():
        assert "section 4" in setting.source or "estimated" in setting.source
        assert setting.lowest < setting.highest
        assert setting.range_for(KART) == pytest.approx(
            (setting.lowest, setting.highest), rel=1e-3, abs=1e-9
        )
    # a car's spring carries more than the prototype's
    assert SETTINGS["spring_preload"].range_for(REFERENCE)[1] > 5e3


def test_block_adds_its_mass_and_shortens_the_upper_arm_only():
    rig = apply_adjustments(KART, {"short_upper_arm": "150 mm"})
    assert rig.sprung.mass == pytest.approx(18.6)  # paper: 16 kg and 18.6 kg
    assert pytest.approx(2.6) == BLOCK_MASS
    assert arm_length(rig, "upper") == pytest.approx(0.150, rel=1e-12)
    for name in (
        "lower_ball_joint",
        "upper_ball_joint",
        "wheel_centre",
        "tie_rod_outer",
        "lower_arm_front",
    ):
        assert getattr(rig.hardpoints, name) == pytest.approx(
            getattr(KART.hardpoints, name), abs=1e-12
        )
    # a short upper arm swings the wheel's top in with bump, the more the shorter
    camber = [
        float(jn.sweep_travel(one, [0.02])["camber"][0])
        for one in (KART, rig, apply_adjustments(KART, {"short_upper_arm": "113 mm"}))
    ]
    assert camber[0] > camber[1] > camber[2]
    assert camber[2] < -np.radians(0.2)


# --- what stays ----------------------------------------------------------------------------------------------------

CASES = [
    {"upper_arm_length": "20 mm"},
    {"lower_arm_length": "12 mm", "upper_arm_length": "4 mm"},
    {"tie_rod_length": "-15 mm"},
    {"upper_arm_support": "20 mm", "lower_arm_support": "-10 mm"},
    {"lower_arm_length": "10 mm", "short_upper_arm": "160 mm", "tie_rod_length": "3 mm"},
]


@pytest.mark.parametrize("settings", CASES, ids=", ".join)
@pytest.mark.parametrize("side", ["left", "right"])
def test_upright_is_moved_as_a_rigid_body_and_rods_have_their_lengths(settings, side):
    rig = KART if side == "left" else KART.mirrored()
    new = apply_adjustments(rig, settings)
    old_points, points = rig.hardpoints, new.hardpoints
    for one, other in PAIRS:
        before, after = (distance(getattr(p, one), getattr(p, other)) for p in (old_points, points))
        assert after == pytest.approx(before, abs=1e-11)
    assert points.wheel_centre[2] == pytest.approx(old_points.wheel_centre[2], abs=1e-11)
    for arm in ("lower", "upper"):
        asked = float(str(settings.get(f"{arm}_arm_length", "0 mm")).split()[0]) * 1e-3
        base = 0.160 if arm == "upper" and "short_upper_arm" in settings else arm_length(rig, arm)
        assert arm_length(new, arm) == pytest.approx(base + asked, abs=1e-11)
    asked = float(str(settings.get("tie_rod_length", "0 mm")).split()[0]) * 1e-3
    lengths = [distance(p.tie_rod_inner, p.tie_rod_outer) for p in (old_points, points)]
    assert lengths[1] - lengths[0] == pytest.approx(asked, abs=1e-11)
    foot = [distance(p.strut_bottom, p.lower_ball_joint) for p in (old_points, points)]
    assert foot[1] == pytest.approx(foot[0], abs=1e-11)
    assert points.strut_top == old_points.strut_top
    for name, body in new.body_masses().items():
        assert body.mass == rig.body_masses()[name].mass
        moments = body.inertia.principal_moments, rig.body_masses()[name].inertia.principal_moments
        assert moments[0] == pytest.approx(moments[1], rel=1e-9)


def test_wheel_angles_are_those_of_the_moved_upright():
    """Kinematics of the adjusted rig start from the camber and toe of its description."""
    rig = apply_adjustments(
        KART.with_changes({"wheel.camber": "-1 deg", "wheel.toe": "0.5 deg"}),
        {"upper_arm_length": "7 mm"},
    )
    sweep = jn.sweep_travel(rig, [0.0])
    assert float(sweep["camber"][0]) == pytest.approx(rig.wheel.camber, abs=1e-12)
    assert float(sweep["toe"][0]) == pytest.approx(rig.wheel.toe, abs=1e-12)


def test_sides_of_the_car_are_mirrors():
    left = apply_adjustments(KART, CASES[1])
    right = apply_adjustments(KART.mirrored(), CASES[1])
    mirrored = left.mirrored().parameters()
    assert right.parameters() == pytest.approx(mirrored, abs=1e-9)


def test_spring_keeps_its_free_length_and_preload_follows():
    settings = {"upper_arm_length": "20 mm"}
    free = apply_adjustments(KART, settings)
    assert free.strut.spring.free_length == KART.strut.spring.free_length
    by_preload = KART.with_changes(
        {"strut.spring": {"rate": KART.strut.spring.rate, "preload": spring_force(KART)}}
    )
    other = apply_adjustments(by_preload, settings)
    assert spring_force(other) == pytest.approx(spring_force(free), rel=1e-9)
    assert jn.equilibrium(other)["sprung.z"] == pytest.approx(
        jn.equilibrium(free)["sprung.z"], abs=1e-9
    )


def test_preload_is_the_force_at_design_length_and_lifts_the_body():
    rig = apply_adjustments(KART, {"spring_preload": "250 N"})
    assert spring_force(rig) == pytest.approx(250.0, rel=1e-9)
    lift = jn.equilibrium(rig)["sprung.z"] - jn.equilibrium(KART)["sprung.z"]
    # domain A4: ride height shift = preload / rate, at the wheel; the wheel stays on its tyre
    at_wheel = (250.0 - spring_force(KART)) * 0.8988 / 18525.0
    assert lift == pytest.approx(at_wheel, rel=0.03)


def test_wedges_turn_the_wheel_alone():
    rig = apply_adjustments(KART, {"camber_wedge": "-2 deg", "toe_wedge": "1 deg"})
    assert (degrees(rig.wheel.camber), degrees(rig.wheel.toe)) == pytest.approx((-2.0, 1.0))
    assert rig.hardpoints == KART.hardpoints
    assert rig.bodies == KART.bodies


def test_nothing_set_is_nothing_changed():
    assert apply_adjustments(KART, {}) == KART
    assert apply_adjustments(KART, {"upper_arm_length": 0.0}) == KART


# --- reports and findings ------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def report():
    return adjust_report(KART)


def test_report_covers_every_setting_and_quantity(report):
    assert [effect.setting for effect in report.effects] == [
        item.name for item in SETTINGS.values() if item.fits(KART)
    ]
    assert len(report.effects) == 11
    assert report.findings == ()
    for effect in report.effects:
        assert effect.at_lowest is not None
        assert effect.at_highest is not None
        assert set(effect.per_unit) == set(QUANTITIES)
        assert all(value is not None for value in effect.per_unit.values())


def test_slopes_lie_between_the_secants_of_the_range(report):
    """Per unit at the rig's own value: of the size that the ends of the range say."""
    effects = {effect.setting: effect for effect in report.effects}
    for name, quantity in (
        ("upper_arm_length", "camber"),
        ("lower_arm_length", "camber"),
        ("tie_rod_length", "toe"),
        ("lower_arm_support", "roll_centre_height"),
        ("strut_angle", "wheel_rate"),
        ("spring_preload", "ride_height"),
    ):
        effect = effects[name]
        ends = [getattr(state, quantity) for state in (effect.at_lowest, effect.at_highest)]
        secant = (ends[1] - ends[0]) / (effect.highest - effect.lowest)
        assert effect.per_unit[quantity] == pytest.approx(secant, rel=0.4), name


def test_roll_centre_rises_with_the_lower_supports(report):
    """Arms that are parallel and level: the lower one tilted by h / 225 mm carries the contact point's path with it."""
    effect = next(effect for effect in report.effects if effect.setting == "lower_arm_support")
    assert effect.per_unit["roll_centre_height"] == pytest.approx(2.0, abs=0.3)
    assert wheel_state(KART).roll_centre_height == pytest.approx(8.9e-3, abs=0.5e-3)


def test_findings_of_strut_angles():
    assert adjustment_findings({"strut_angle": np.radians(16.0)}) == []
    assert [f.severity for f in adjustment_findings({"strut_angle": np.radians(18.0)})] == ["note"]
    (steep,) = adjust_report(KART, {"strut_angle": "33 deg"}, effects=False).findings
    assert steep.severity == "warning"
    assert "Adams" in steep.message


def test_report_of_another_rig_says_what_it_cannot_have():
    spring = {
        "strut.spring": {
            "curve": {"kind": "polynomial", "coefficients": [22e3]},
            "free_length": 0.208,
        }
    }
    found = adjust_report(KART.with_changes(spring))
    assert "spring_preload" not in [effect.setting for effect in found.effects]
    assert any(
        f.place == "spring_preload" and "no single preload" in f.message for f in found.findings
    )


# --- the inverse ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("camber", "toe"),
    [(-2.0, 0.5), (4.0, -1.0), (-4.9, 0.0), (0.3, 8.0), (-0.3, 8.0), (1.0, None), (None, -6.0)],
)
def test_lengths_reach_what_is_wished(camber, toe):
    found = lengths_for(
        KART, *(None if value is None else f"{value} deg" for value in (camber, toe))
    )
    wheel = apply_adjustments(KART, found.settings()).wheel
    if camber is not None:
        assert degrees(wheel.camber) == pytest.approx(camber, abs=1e-7)
    if toe is not None:
        assert degrees(wheel.toe) == pytest.approx(toe, abs=1e-7)
    assert (found.camber, found.toe) == pytest.approx((wheel.camber, wheel.toe), abs=1e-12)
    for name, value in found.settings().items():
        assert SETTINGS[name].lowest <= value <= SETTINGS[name].highest
    assert 0.0 in (found.lower_arm_length, found.upper_arm_length)


def test_lengths_of_a_car_are_found_too():
    found = lengths_for(REFERENCE, camber="-2 deg", toe="0.1 deg")
    wheel = apply_adjustments(REFERENCE, found.settings()).wheel
    assert (degrees(wheel.camber), degrees(wheel.toe)) == pytest.approx((-2.0, 0.1), abs=1e-7)


@pytest.mark.parametrize(
    ("name", "camber", "toe", "used"),
    [
        ("generic-mcpherson", -1.2, 0.1, {"camber_plate", "tie_rod_length"}),
        ("generic-mcpherson", 1.0, None, {"camber_plate"}),
        ("sedan-multi-link", -1.5, 0.15, {"link_5_length"}),
    ],
)
def test_lengths_of_other_suspensions(name, camber, toe, used):
    rig = jn.load(name)
    found = lengths_for(
        rig, *(None if value is None else f"{value} deg" for value in (camber, toe))
    )
    wheel = apply_adjustments(rig, found.settings()).wheel
    assert degrees(wheel.camber) == pytest.approx(camber, abs=1e-7)
    assert used <= set(found.settings())
    assert len(found.settings()) == (1 if toe is None else 2)
    if toe is not None:
        assert degrees(wheel.toe) == pytest.approx(toe, abs=1e-7)
    with pytest.raises(
        DescriptionError, match=r"lengths do not reach this.* deg to .* deg.*wedges"
    ):
        lengths_for(rig, camber="-25 deg")


@pytest.mark.parametrize(
    "wished", [{"camber": "7 deg"}, {"camber": "-8 deg", "toe": 0.0}, {"toe": "15 deg"}]
)
def test_what_the_published_lengths_do_not_reach_is_refused_with_their_range(wished):
    with pytest.raises(DescriptionError, match=r"does not reach this.* deg to .* deg.*wedges"):
        lengths_for(KART, **wished)


# --- bad input -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"uper_arm_length": "3 mm"}, "Did you mean 'upper_arm_length'"),
        ({"upper_arm_length": "21 mm"}, r"out of range.*0 mm to 20 mm.*section 4"),
        ({"upper_arm_length": "-1 mm"}, "out of range"),
        ({"upper_arm_length": "3"}, "unit is missing"),
        ({"upper_arm_length": "3 deg"}, "wrong unit"),
        ({"strut_angle": "80 deg"}, "out of range"),
        ({"spring_preload": -1.0}, "out of range"),
        ({"short_upper_arm": "300 mm"}, "112.5 mm to 225 mm"),
    ],
)
def test_settings_that_cannot_be_made_are_refused(settings, message):
    with pytest.raises(DescriptionError, match=message):
        apply_adjustments(KART, settings)


def test_other_rigs_are_refused():
    with pytest.raises(DescriptionError, match="only a corner with hardpoints"):
        adjust_report(jn.load("kart-quarter-car"))
    with pytest.raises(DescriptionError, match=r"none of its lengths sets camber.*wedges"):
        lengths_for(jn.load("semi-trailing-arm"), camber="-1 deg")
    with pytest.raises(
        DescriptionError,
        match=r"the rig does not have this adjustment.*allowed: lower_arm_length, tie_rod_length",
    ):
        apply_adjustments(jn.load("generic-mcpherson"), {"pushrod_length": "1 mm"})


def test_nothing_wished_is_refused():
    with pytest.raises(DescriptionError, match="no target is given"):
        lengths_for(KART)


def test_a_linkage_that_does_not_go_together_is_refused_by_name():
    """A tie rod that stands upright over its outer end cannot be 20 mm shorter: nothing lets the end rise."""
    stretched = KART.with_changes({"hardpoints.tie_rod_inner": [-0.1061, 0.3266, 0.212]})
    points = stretched.hardpoints
    assert distance(points.tie_rod_inner, points.tie_rod_outer) == pytest.approx(0.107)
    with pytest.raises(AssemblyError, match="cannot be assembled"):
        apply_adjustments(stretched, {"tie_rod_length": "-20 mm"})


# shims and rockers ----------------------------------------------------------------------------------------------------


def lengths_of(rig) -> dict[str, float]:
    points = {name: np.array(point) for name, point in rig.hardpoints.given().items()}
    rods = {
        **{inner: outer for outer, inner in rig.hardpoints.rods},
        "pushrod_inner": "pushrod_outer",
    }
    rods |= {"rocker_pivot": "strut_bottom", "rocker_axis": "pushrod_inner"}
    found = {f"{a} {b}": float(np.linalg.norm(points[a] - points[b])) for a, b in rods.items()}
    upper = [("upper_arm_front", "upper_ball_joint"), ("upper_arm_rear", "upper_ball_joint")]
    return found | {f"{a} {b}": float(np.linalg.norm(points[a] - points[b])) for a, b in upper}


def test_shims_and_rods_of_a_car_with_rockers_change_their_length_alone():
    rig = jn.load("formula-student-front")
    before = lengths_of(rig)
    for setting, rod, longer in (
        ("pushrod_length", "pushrod_inner pushrod_outer", 0.004),
        ("tie_rod_length", "tie_rod_inner tie_rod_outer", -0.003),
    ):
        after = lengths_of(apply_adjustments(rig, {setting: longer}))
        for name, length in before.items():
            assert after[name] == pytest.approx(length + longer * (name == rod), abs=1e-10), (
                setting,
                name,
            )
    shimmed = apply_adjustments(rig, {"camber_shim": "3 mm"})
    assert lengths_of(shimmed) == pytest.approx(before, abs=1e-10)  # every rod keeps its length
    # in the upright the ball joint has moved by the shim, along the wheel's axis, inwards
    bases, frames = [], []
    for one in (rig, shimmed):
        points = {name: np.array(point) for name, point in one.hardpoints.given().items()}
        along = [
            points[name] - points["wheel_centre"] for name in ("lower_ball_joint", "tie_rod_outer")
        ]
        bases.append(np.column_stack([*along, np.cross(*along)]))
        frames.append(
            np.linalg.solve(bases[-1], points["upper_ball_joint"] - points["wheel_centre"])
        )
    moved = bases[0] @ (frames[1] - frames[0])
    camber = rig.wheel.camber
    assert moved == pytest.approx([0.0, -0.003 * np.cos(camber), 0.003 * np.sin(camber)], abs=1e-9)
    assert (
        0.9 < (shimmed.wheel.camber - camber) / (0.003 / 0.2) < 1.0
    )  # 200 mm between joints, on arms that lean
    high = apply_adjustments(rig, {"pushrod_length": "4 mm"})
    assert (
        wheel_state(high).ride_height > wheel_state(rig).ride_height + 2e-3
    )  # a longer push rod lifts the car


def test_a_rig_without_rocker_has_no_push_rod_to_set():
    with pytest.raises(jn.DescriptionError, match="does not have this adjustment"):
        apply_adjustments(KART, {"pushrod_length": "2 mm"})
    in_line = {
        "hardpoints.rocker_pivot": [0.0, 0.2361, 0.4569],
        "hardpoints.rocker_axis": [0.1, 0.2361, 0.4569],
    }
    with pytest.raises(
        AssemblyError, match="cannot be assembled"
    ):  # the rod points at the pivot: it cannot be shorter
        apply_adjustments(
            jn.load("formula-student-front").with_changes(in_line), {"pushrod_length": "-5 mm"}
        )


# every suspension -----------------------------------------------------------------------------------------------------


def rod_lengths(rig) -> dict[str, float]:
    points = rig.hardpoints
    return {
        inner: distance(getattr(points, inner), getattr(points, outer))
        for outer, inner in points.rods
    }


@pytest.mark.parametrize("side", ["left", "right"])
def test_shims_of_links_and_plates_change_what_they_say_and_nothing_else(side: str):
    links = (
        jn.load("sedan-multi-link") if side == "left" else jn.load("sedan-multi-link").mirrored()
    )
    before = rod_lengths(links)
    longer = apply_adjustments(links, {"link_2_length": "3 mm"})
    for name, length in rod_lengths(longer).items():
        assert length == pytest.approx(before[name] + 3e-3 * (name == "link_2_inner"), abs=1e-10), (
            name
        )
    shimmed = apply_adjustments(links, {"camber_shim": "-2 mm"})
    assert rod_lengths(shimmed) == pytest.approx(before, abs=1e-10)
    assert (
        -1.0 < degrees(shimmed.wheel.camber - links.wheel.camber) < -0.2
    )  # the top of the wheel inwards
    strut = (
        jn.load("generic-mcpherson") if side == "left" else jn.load("generic-mcpherson").mirrored()
    )
    plated = apply_adjustments(strut, {"camber_plate": "-8 mm"})
    assert rod_lengths(plated) == pytest.approx(rod_lengths(strut), abs=1e-10)
    moved = np.subtract(plated.hardpoints.strut_top, strut.hardpoints.strut_top)
    assert moved == pytest.approx([0.0, -8e-3 * strut.sign, 0.0], abs=1e-12)
    height = strut.hardpoints.strut_top[2] - strut.hardpoints.lower_ball_joint[2]
    turned = plated.wheel.camber - strut.wheel.camber  # the upright about its ball joint, toe aside
    assert turned == pytest.approx(-8e-3 / height, rel=0.2)
    # the strut's line is fixed to the upright: seen from there, it has not turned
    for one, other in (("lower_ball_joint", "tie_rod_outer"), ("wheel_centre", "tie_rod_outer")):
        angles = []
        for rig in (strut, plated):
            points = rig.hardpoints
            line = np.subtract(points.strut_top, points.strut_bottom)
            edge = np.subtract(getattr(points, other), getattr(points, one))
            angles.append(float(line @ edge / np.linalg.norm(line) / np.linalg.norm(edge)))
        assert angles[1] == pytest.approx(angles[0], abs=1e-10)
    arm = jn.load("semi-trailing-arm")
    turned = apply_adjustments(arm, {"camber_wedge": "-0.5 deg", "toe_wedge": "0.1 deg"})
    assert degrees(turned.wheel.camber - arm.wheel.camber) == pytest.approx(-0.5)
    assert turned.hardpoints == arm.hardpoints


def test_settings_fit_the_suspension():
    fitting = {
        name: {item.name for item in SETTINGS.values() if item.fits(jn.load(name))}
        for name in (
            "generic-mcpherson",
            "sedan-multi-link",
            "semi-trailing-arm",
            "formula-student-front",
        )
    }
    wedges = {"camber_wedge", "toe_wedge", "spring_preload"}
    assert fitting["semi-trailing-arm"] == wedges
    arm = {"lower_arm_length", "lower_arm_support", "tie_rod_length", "camber_plate"}
    assert fitting["generic-mcpherson"] == wedges | arm
    assert fitting["sedan-multi-link"] == wedges | {f"link_{i}_length" for i in range(1, 6)} | {
        "camber_shim"
    }
    links = {f"link_{i}_length" for i in range(1, 6)}
    assert fitting["formula-student-front"] == SETTINGS.keys() - links - {"camber_plate"}


def test_what_has_no_steering_axis_has_no_caster():
    report = adjust_report(jn.load("semi-trailing-arm"), {"camber_wedge": "-1 deg"}, effects=False)
    assert degrees(report.after.camber - report.before.camber) == pytest.approx(-1.0)
    assert report.after.caster is None


def test_hardpoints_alone_are_adjusted_and_have_no_wheel_rate():
    table = KART.model_dump(
        by_alias=True, exclude_none=True, exclude={"bodies", "sprung", "guide", "strut", "tyre"}
    )
    report = adjust_report(
        type(KART).from_table(table), {"upper_arm_length": "20 mm"}, effects=False
    )
    assert degrees(report.after.camber) == pytest.approx(5.244, abs=1e-3)
    assert (report.after.wheel_rate, report.after.ride_height) == (None, None)


BESIDE_STRUT = {
    "torsion_bar": {"stiffness": 60.0, "preload": 3.0, "on": "lower_arm"},
    "third_spring": {"spring": {"rate": 2e3, "preload": 10.0}, "on": "lower_arm"},
    "anti_roll_bar": {"stiffness": 8.0, "on": "lower_arm"},
    "hardpoints.third_spring_end": [0.0, 0.12, 0.125],
    "hardpoints.arb_pivot": [-0.1, 0.1, 0.12],
    "hardpoints.arb_arm_end": [-0.02, 0.12, 0.12],
    "hardpoints.arb_link_end": [0.0, 0.2, 0.06],
}


@pytest.mark.parametrize("side", ["left", "right"])
def test_bars_and_third_springs_go_along(side: str):
    """The link of the bar keeps its length, the third spring's end stays on its arm, what is wound up is kept."""
    rig = KART.with_changes(BESIDE_STRUT)
    rig = rig if side == "left" else rig.mirrored()
    new = apply_adjustments(rig, {"lower_arm_support": "20 mm", "upper_arm_length": "5 mm"})
    assert new.wheel.camber != rig.wheel.camber
    for one, other in (
        ("arb_arm_end", "arb_link_end"),
        ("arb_pivot", "arb_arm_end"),
        ("arb_link_end", "lower_ball_joint"),
        ("arb_link_end", "lower_arm_front"),
        ("third_spring_end", "lower_ball_joint"),
        ("third_spring_end", "lower_arm_rear"),
    ):
        lengths = [
            distance(getattr(r.hardpoints, one), getattr(r.hardpoints, other)) for r in (rig, new)
        ]
        assert lengths[1] == pytest.approx(lengths[0], abs=1e-9), (one, other)
    arms = [
        np.subtract(r.hardpoints.lower_ball_joint, r.hardpoints.lower_arm_front)[1:]
        for r in (rig, new)
    ]
    slopes = [
        float(np.arctan2(z, rig.sign * y)) for y, z in arms
    ]  # of the arm in front view, about its level axis
    wound = 60.0 * (slopes[1] - slopes[0])
    assert new.torsion_bar.preload == pytest.approx(3.0 + wound, abs=1e-9)
    assert wound < -3.0  # the inner supports rise: the arm falls outward
    ends = [abs(r.hardpoints.third_spring_end[1]) for r in (rig, new)]
    assert new.third_spring.spring.preload == pytest.approx(
        10.0 - 2e3 * 2.0 * (ends[1] - ends[0]), abs=1e-9
    )
    with pytest.raises(AssemblyError, match="does not reach its arm"):
        apply_adjustments(
            rig.with_changes({"hardpoints.arb_arm_end[0]": -0.09}), {"lower_arm_support": "-30 mm"}
        )
