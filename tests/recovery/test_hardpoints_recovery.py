"""Curves of a rig whose points were moved: the search finds points that give them, from where they were before."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

TRAVEL = "-30 mm:30 mm:10 mm"
MOVED = {
    "hardpoints.tie_rod_inner[2]": 0.004,
    "hardpoints.upper_arm_front[2]": -0.006,
    "hardpoints.upper_arm_rear[2]": 0.005,
    "hardpoints.upper_ball_joint[1]": -0.004,
    "hardpoints.pushrod_inner[2]": 0.005,
}
CURVES = {
    "toe": "0.001 deg",
    "camber": "0.001 deg",
    "roll_centre_height": "0.02 mm",
    "motion_ratio": 1e-4,
    "caster": "0.002 deg",
}


@pytest.mark.parametrize("seed", [0, 1])
def test_curves_that_a_rig_can_make_are_found_and_so_are_their_points(seed: int) -> None:
    rig = jn.load("formula-student-front")
    before = rig.parameters()
    truth = rig.with_changes({path: before[path] + shift for path, shift in MOVED.items()})
    swept = jn.sweep_travel(truth, TRAVEL)
    targets = [
        {
            "quantity": name,
            "over": TRAVEL,
            "values": swept[name].to_numpy().tolist(),
            "tolerance": tolerance,
        }
        for name, tolerance in CURVES.items()
    ]
    found = jn.design_kinematics(rig, dict.fromkeys(MOVED, "15 mm"), targets, starts=4, seed=seed)
    assert found.met
    assert all(start.met for start in found.starts)
    for path in MOVED:  # five numbers, five curves of seven poses: nothing is left open
        assert found.rig.parameters()[path] == pytest.approx(truth.parameters()[path], abs=2e-5), (
            path
        )
    again = jn.sweep_travel(found.rig, TRAVEL)
    assert float(np.max(np.abs(again["toe"] - swept["toe"]))) <= np.radians(0.001) * (1.0 + 1e-6)


def test_thirty_coordinates_of_a_push_rod_wishbone_meet_forty_targets() -> None:
    rig = jn.load("formula-student-front")
    random = np.random.default_rng(3)
    names = (
        "upper_arm_front",
        "upper_arm_rear",
        "lower_arm_front",
        "lower_arm_rear",
        "upper_ball_joint",
    )
    names += (
        "lower_ball_joint",
        "tie_rod_inner",
        "tie_rod_outer",
        "pushrod_inner",
        "pushrod_outer",
    )
    before = rig.parameters()
    truth = rig.with_changes(
        {
            f"hardpoints.{n}[{i}]": before[f"hardpoints.{n}[{i}]"] + random.uniform(-6e-3, 6e-3)
            for n in names
            for i in range(3)
        }
    )
    quantities = {
        "toe": "0.005 deg",
        "camber": "0.02 deg",
        "roll_centre_height": "0.5 mm",
        "motion_ratio": 0.002,
    }
    quantities |= {
        "caster": "0.05 deg",
        "scrub_radius": "0.5 mm",
        "caster_trail": "0.5 mm",
        "camber_gain": "0.2 deg/m",
    }
    targets = []
    for travel in (-0.02, -0.01, 0.0, 0.01, 0.02):
        swept = jn.sweep_travel(truth, travel)
        targets += [
            {"quantity": name, "at": travel, "value": float(swept[name][0]), "tolerance": tolerance}
            for name, tolerance in quantities.items()
        ]
    assert len(targets) == 40
    free = [{"point": f"hardpoints.{name}", "within": "10 mm"} for name in names]
    found = jn.design_kinematics(rig, free, targets, starts=2)
    assert found.met
    assert found.starts[0].met


def test_contradicting_targets_get_the_middle_and_are_named() -> None:
    rig = jn.load("formula-student-front")
    targets = [
        {"quantity": "camber_gain", "value": value, "tolerance": "0.1 deg/m"}
        for value in ("-30 deg/m", "-34 deg/m")
    ]
    found = jn.design_kinematics(rig, {"hardpoints.upper_arm_front[2]": "20 mm"}, targets)
    assert not found.met
    assert [target.met for target in found.targets] == [False, False]
    assert np.degrees(found.targets[0].after) == pytest.approx(-32.0, abs=1e-3)
    assert {(fight.missed, fight.other) for fight in found.fights} == {(0, 1), (1, 0)}


def test_all_are_met_where_the_compromise_would_miss_one() -> None:
    """Three targets one tolerance and a half apart: the mean misses the odd one, the middle meets all."""
    rig = jn.load("formula-student-front")
    values = ("-32 deg/m", "-32 deg/m", "-32 deg/m", "-33.6 deg/m")
    targets = [
        {"quantity": "camber_gain", "value": value, "tolerance": "1 deg/m"} for value in values
    ]
    found = jn.design_kinematics(rig, {"hardpoints.upper_arm_front[2]": "20 mm"}, targets)
    assert found.met


def test_what_the_targets_leave_open_stays_where_it_is() -> None:
    rig = jn.load("formula-student-front")
    free = {"hardpoints.tie_rod_inner[2]": "10 mm", "hardpoints.strut_top[0]": "10 mm"}
    targets = [
        {"quantity": "bump_steer", "value": "0 deg/m", "tolerance": "0.1 deg/m"},
        {"quantity": "motion_ratio", "at_least": 0.1, "tolerance": 0.01},
        {"quantity": "spring_length", "at_least": "50 mm", "tolerance": "1 mm"},
    ]
    found = jn.design_kinematics(rig, free, targets, starts=1)
    assert found.met
    assert (
        abs(
            found.moved["hardpoints.strut_top[0]"].after
            - found.moved["hardpoints.strut_top[0]"].before
        )
        < 1e-6
    )


def test_a_curve_within_limits_moves_no_more_than_it_needs() -> None:
    """A bracket 14 mm off, toe within a band: one height alone can do it, so six coordinates go no farther together."""
    rig = jn.load("sedan-multi-link").with_changes({"hardpoints.link_5_inner[2]": "210 mm"})
    band = {
        "over": "-40 mm:40 mm:20 mm",
        "at_least": "-0.08 deg",
        "at_most": "0.08 deg",
        "tolerance": "0.01 deg",
    }
    alone, together = (
        jn.design_kinematics(
            rig, dict.fromkeys(points, "15 mm"), [{"quantity": "toe", **band}], starts=1
        )
        for points in (
            ["hardpoints.link_5_inner[2]"],
            ["hardpoints.link_5_inner", "hardpoints.link_5_outer"],
        )
    )
    moves, ways = (
        np.array([moved.after - moved.before for moved in found.moved.values()])
        for found in (alone, together)
    )
    assert alone.met
    assert together.met
    assert np.linalg.norm(ways) < 0.9 * np.linalg.norm(moves)  # two heights share the way
    after = np.degrees(jn.sweep_travel(together.rig, band["over"])["toe"].to_numpy())
    assert np.max(np.abs(after)) == pytest.approx(
        0.08, abs=1e-5
    )  # at the limit, not within: nothing is gained there


def test_a_number_at_its_edge_and_searches_that_did_not_settle_are_told(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    rig = jn.load("sedan-multi-link").with_changes({"hardpoints.link_5_inner[2]": "210 mm"})
    toe = {
        "quantity": "toe",
        "over": "-40 mm:40 mm:20 mm",
        "at_least": "-0.08 deg",
        "at_most": "0.08 deg",
    }

    def findings(within: str, **further: object) -> dict[str, str]:
        found = jn.design_kinematics(
            rig, {"hardpoints.link_5_inner[2]": within}, [{**toe, **further}], starts=2
        )
        assert found.met
        return {one.place: one.message for one in found.findings}

    assert not findings("20 mm", tolerance="0.01 deg")
    assert (
        "edge of its box" in findings("14.3 mm", tolerance="0.01 deg")["hardpoints.link_5_inner[2]"]
    )
    monkeypatch.setattr("jounce.design.hardpoint_search._STEPS", 2)
    assert findings("20 mm", tolerance="0.1 deg")["starts"].startswith(
        "2 of 2 searches stopped before they converged"
    )


def test_a_point_on_a_line_and_points_tied_together() -> None:
    rig = jn.load("formula-student-front")
    free = [
        {"point": "hardpoints.upper_arm_front", "along": [0, 1, 2], "within": "20 mm"},
        {
            "point": "hardpoints.lower_arm_front[2]",
            "tied": ["hardpoints.lower_arm_rear[2]"],
            "within": "20 mm",
        },
    ]
    targets = [
        {"quantity": "camber_gain", "value": "-35 deg/m", "tolerance": "0.1 deg/m"},
        {"quantity": "roll_centre_height", "value": "33 mm", "tolerance": "0.1 mm"},
    ]
    found = jn.design_kinematics(rig, free, targets)
    assert found.met
    shift = {path: change.after - change.before for path, change in found.moved.items()}
    assert shift["hardpoints.upper_arm_front[0]"] == pytest.approx(0.0, abs=1e-9)
    assert shift["hardpoints.upper_arm_front[2]"] == pytest.approx(
        2.0 * shift["hardpoints.upper_arm_front[1]"], abs=2e-9
    )
    assert shift["hardpoints.lower_arm_front[2]"] == pytest.approx(
        shift["hardpoints.lower_arm_rear[2]"], abs=2e-9
    )
    assert abs(shift["hardpoints.lower_arm_front[2]"]) > 1e-4


@pytest.mark.slow
def test_rows_of_third_spring_rocker_handwheel_and_roll_caster_are_targets_too() -> None:
    third = {"spring": {"rate": 30e3}, "on": "rocker"}
    rig = jn.load("formula-student-front").with_changes(
        {
            "third_spring": third,
            "hardpoints.third_spring_end": [0.02, 0.21, 0.42],
            "steering": {"rack_ratio": 0.013},
        }
    )
    before, moved = rig.parameters(), {
        "hardpoints.third_spring_end[2]": 0.006,
        "hardpoints.pushrod_inner[2]": -0.004,
        "hardpoints.tie_rod_outer[0]": 0.005,
        "hardpoints.upper_arm_rear[2]": 0.004,
    }  # fmt: skip
    truth = rig.with_changes({path: before[path] + shift for path, shift in moved.items()})
    swept, roll = jn.sweep_travel(truth, TRAVEL), np.radians([-1.0, 0.0, 1.0])
    rolled = jn.sweep_roll(truth, roll)["left.roll_caster"].to_numpy().tolist()
    targets = [
        {
            "quantity": name,
            "over": TRAVEL,
            "values": swept[name].to_numpy().tolist(),
            "tolerance": 1e-4,
        }
        for name in ("third_spring_motion_ratio", "rocker_spring_angle")
    ]
    ratio = float(jn.sweep_steering(truth, [0.01])["steering_ratio"][0])
    targets.append(
        {"quantity": "steering_ratio", "at": {"rack": "10 mm"}, "value": ratio, "tolerance": 1e-3}
    )
    targets.append(
        {
            "quantity": "left.roll_caster",
            "over": roll.tolist(),
            "along": "roll",
            "values": rolled,
            "tolerance": 1e-4,
        }
    )
    found = jn.design_kinematics(rig, dict.fromkeys(moved, "12 mm"), targets, starts=2)
    assert found.met
    for path in moved:
        assert found.rig.parameters()[path] == pytest.approx(truth.parameters()[path], abs=2e-4), (
            path
        )
    target = {
        "quantity": "roll_moment",
        "over": "-1 deg:1 deg:1 deg",
        "value": 0.0,
        "tolerance": 1.0,
    }
    with pytest.raises(jn.DescriptionError, match="roll_moment"):
        jn.design_kinematics(rig, dict.fromkeys(moved, "12 mm"), [target])


def test_what_must_hold_does_in_a_compromise() -> None:
    rig = jn.load("formula-student-front")
    free = {"hardpoints.upper_arm_front[2]": "20 mm", "hardpoints.lower_arm_front[2]": "20 mm"}
    targets = [
        {"quantity": "camber_gain", "value": "-45 deg/m", "tolerance": "0.1 deg/m"},
        {"quantity": "roll_centre_height", "at_most": "31 mm", "tolerance": "0.1 mm", "must": True},
    ]
    found = jn.design_kinematics(rig, free, targets, starts=2)
    assert not found.met
    assert [target.met for target in found.targets] == [False, True]
    assert any(start.holds for start in found.starts)
    loose = [targets[0], {**targets[1], "must": False}]
    without = jn.design_kinematics(rig, free, loose, starts=2)
    assert [target.met for target in without.targets] == [False, False]
    # on the constraint no other place of the boxes has more camber gain
    edges = np.linspace(-0.02, 0.02, 13)
    start = rig.parameters()
    best = 0.0
    for front in edges:
        changes = {"hardpoints.upper_arm_front[2]": start["hardpoints.upper_arm_front[2]"] + front}
        for lower in edges:
            changes["hardpoints.lower_arm_front[2]"] = (
                start["hardpoints.lower_arm_front[2]"] + lower
            )
            swept = jn.sweep_travel(rig.with_changes(changes), [0.0])
            if float(swept["roll_centre_height"][0]) <= 0.0311:
                best = min(best, float(swept["camber_gain"][0]))
    assert float(found.targets[0].after) <= best * (1.0 - 1e-4)


def test_a_constraint_that_cannot_hold_is_told() -> None:
    rig = jn.load("formula-student-front")
    free = {"hardpoints.upper_arm_front[2]": "2 mm"}
    target = {
        "quantity": "roll_centre_height",
        "at_most": "-200 mm",
        "tolerance": "1 mm",
        "must": True,
    }
    found = jn.design_kinematics(rig, free, [target], starts=2)
    assert not found.met
    assert not any(start.holds for start in found.starts)
    assert any(finding.code == "design.must_missed" for finding in found.findings)


def test_points_tied_against_each_other_and_a_link_that_gets_longer() -> None:
    rig = jn.load("formula-student-front")
    free = [
        {
            "point": "hardpoints.lower_arm_front[2]",
            "tied": ["-hardpoints.lower_arm_rear[2]"],
            "within": "20 mm",
        },
        {"point": "hardpoints.tie_rod_inner", "along": "tie_rod_outer", "within": "20 mm"},
    ]
    targets = [
        {"quantity": "contact_patch_recession", "value": 0.08, "tolerance": 0.002},
        {
            "quantity": "distance(tie_rod_inner, tie_rod_outer)",
            "value": "340 mm",
            "tolerance": "0.1 mm",
        },
    ]
    found = jn.design_kinematics(rig, free, targets, starts=2)
    assert found.met
    shift = {path: one.after - one.before for path, one in found.moved.items()}
    assert shift["hardpoints.lower_arm_front[2]"] == pytest.approx(
        -shift["hardpoints.lower_arm_rear[2]"], abs=2e-9
    )
    rod = np.array(rig.hardpoints.tie_rod_outer) - np.array(rig.hardpoints.tie_rod_inner)
    moved = np.array([shift[f"hardpoints.tie_rod_inner[{i}]"] for i in range(3)])
    assert np.linalg.norm(np.cross(rod, moved)) < 1e-9
    assert np.linalg.norm(rod - moved) == pytest.approx(0.34, abs=1e-4)
    assert found.identified[1].number == "hardpoints.tie_rod_inner along tie_rod_outer"


def test_both_axles_are_designed_together_and_their_points_are_tied() -> None:
    front = jn.load("formula-student-front")
    rear = front.with_changes({"hardpoints.upper_arm_front[2]": "300 mm", "wheel.camber": "-1 deg"})
    car = {"wheelbase": "1.55 m", "centre_of_mass_height": "300 mm"}
    cars = {
        "front": jn.AxleLayout(axle="front", brake_share=0.6, **car),
        "rear": jn.AxleLayout(axle="rear", brake_share=0.4, **car),
    }
    free = [
        {
            "point": "front.hardpoints.lower_arm_front[2]",
            "tied": ["rear.hardpoints.lower_arm_rear[2]"],
            "within": "30 mm",
        },
        {"point": "front.hardpoints.upper_arm_front[2]", "within": "30 mm"},
        {"point": "rear.hardpoints.upper_arm_front[2]", "within": "30 mm"},
    ]
    targets = [
        {"rig": "front", "quantity": "anti_dive", "value": 0.1, "tolerance": 0.01},
        {"rig": "rear", "quantity": "camber_gain", "value": "-30 deg/m", "tolerance": "0.1 deg/m"},
        {"rig": "front", "quantity": "camber_gain", "value": "-35 deg/m", "tolerance": "0.1 deg/m"},
    ]
    found = jn.design_kinematics(
        {"front": front, "rear": rear}, free, targets, vehicle=cars, starts=2
    )
    assert found.met
    shift = {path: one.after - one.before for path, one in found.moved.items()}
    tied = "front.hardpoints.lower_arm_front[2]", "rear.hardpoints.lower_arm_rear[2]"
    assert shift[tied[0]] == pytest.approx(shift[tied[1]], abs=2e-9)
    for name, rate in (("front", -35.0), ("rear", -30.0)):
        swept = jn.sweep_travel(found.rigs[name], [0.0], vehicle=cars[name])
        assert np.degrees(float(swept["camber_gain"][0])) == pytest.approx(rate, abs=0.1 + 1e-6)
    assert found.before()["rear"].parameters()["hardpoints.upper_arm_front[2]"] == 0.3
    with pytest.raises(jn.DescriptionError, match="several rigs"):
        _ = found.rig
    with pytest.raises(jn.DescriptionError, match=r"target\[0\].rig"):
        jn.design_kinematics(
            {"front": front, "rear": rear}, free, [{**targets[0], "rig": "middle"}]
        )
    with pytest.raises(jn.DescriptionError, match="fron"):
        jn.design_kinematics(
            {"front": front, "rear": rear}, {"fron.hardpoints.tie_rod_inner": "5 mm"}, targets[1:]
        )


@pytest.mark.slow  # a right corner is another model to compile
def test_left_and_right_are_tied_as_in_a_mirror() -> None:
    left = jn.load("formula-student-front")
    points = {name: [x, -y, z] for name, (x, y, z) in left.hardpoints.given().items()}
    table = left.model_dump(by_alias=True, exclude_none=True) | {"side": "right"}
    table["hardpoints"] = points
    for name in left.body_masses():
        x, y, z = table["bodies"][name]["centre_of_mass"]
        table["bodies"][name]["centre_of_mass"] = (x, -y, z)
    right = type(left).from_table(table)
    free = [
        {
            "point": "left.hardpoints.tie_rod_inner",
            "tied": ["right.hardpoints.tie_rod_inner"],
            "within": "15 mm",
        }
    ]
    target = {
        "quantity": "toe",
        "over": "-30 mm:30 mm:15 mm",
        "value": 0.0,
        "tolerance": "0.01 deg",
    }
    sides = [{**target, "rig": "left"}, {**target, "rig": "right"}]
    found = jn.design_kinematics({"left": left, "right": right}, free, sides, starts=2)
    assert found.met
    (x, y, z), other = (found.rigs[side].hardpoints.tie_rod_inner for side in ("left", "right"))
    assert y != left.hardpoints.tie_rod_inner[1]
    assert other == pytest.approx((x, -y, z), abs=2e-9)


def test_trade_offs_say_what_is_shared() -> None:
    rig = jn.load("formula-student-front")
    gain = {"quantity": "camber_gain", "tolerance": "0.1 deg/m"}
    twice = [{**gain, "value": "-30 deg/m"}, {**gain, "value": "-34 deg/m"}]
    toe = {"quantity": "bump_steer", "value": 0.0, "tolerance": "0.1 deg/m"}
    free = {"hardpoints.upper_arm_front[2]": "20 mm", "hardpoints.tie_rod_inner[2]": "20 mm"}
    found = jn.design_kinematics(rig, free, [*twice, toe], starts=1)
    table = np.array(found.tradeoffs)
    assert table[:2, :2] == pytest.approx(
        np.full((2, 2), 0.5), abs=1e-6
    )  # one number, asked for twice
    assert table[2, 2] == pytest.approx(1.0, abs=1e-6)
    assert table[:2, 2] == pytest.approx(0.0, abs=1e-6)
    assert found.tradeoff_table().count("\n") == 4


def test_what_curves_tell_of_points_and_what_they_leave_open() -> None:
    rig = jn.load("formula-student-front")
    free = dict.fromkeys(("hardpoints.tie_rod_inner[1]", "hardpoints.tie_rod_inner[2]"), "15 mm")
    free["hardpoints.strut_top[0]"] = "5 mm"
    curve = {"quantity": "toe", "over": "-30 mm:30 mm:5 mm", "value": 0.0, "tolerance": "0.01 deg"}
    lengths = {"quantity": "spring_length", "at_least": "10 mm", "tolerance": "1 mm"}
    found = jn.design_kinematics(rig, free, [curve, lengths], starts=1)
    told = {one.number: one for one in found.identified}
    height = told["hardpoints.tie_rod_inner[2]"]
    assert height.alone is not None
    assert height.together is not None
    assert height.alone < 1e-3
    assert height.together > height.alone
    assert told["hardpoints.strut_top[0]"].together is None
    assert found.open[0].change == 0.0
    assert found.open[0].shares["hardpoints.strut_top[0]"] == pytest.approx(1.0)
    # the number alone, by brute force: a change by one standard deviation changes the curve by one tolerance in all
    moved = found.rig.with_changes(
        {
            "hardpoints.tie_rod_inner[2]": found.rig.parameters()["hardpoints.tie_rod_inner[2]"]
            + 0.1 * height.alone
        }
    )
    over = "-30 mm:30 mm:5 mm"
    change = (
        jn.sweep_travel(moved, over)["toe"].to_numpy()
        - jn.sweep_travel(found.rig, over)["toe"].to_numpy()
    )
    assert np.linalg.norm(change) / np.radians(0.01) == pytest.approx(0.1, rel=0.01)


@pytest.mark.slow
def test_a_rod_keeps_clear_of_a_tube_on_the_body_and_of_the_rim() -> None:
    shapes = {
        "rod": jn.Solid(points=("tie_rod_inner", "tie_rod_outer"), radius="8 mm"),
        "tube": jn.Solid(
            places=(("65 mm", "245 mm", "100 mm"), ("65 mm", "245 mm", "200 mm")), radius="12 mm"
        ),
        "joint": jn.Solid(points=("tie_rod_outer",), radius="12 mm"),
        "rim": jn.Rim(radius="120 mm", inner="-90 mm", outer="20 mm"),
    }
    poses = "-20 mm:20 mm:20 mm"
    targets = [
        {"quantity": "bump_steer", "value": 0.0, "tolerance": "0.5 deg/m"},
        {
            "quantity": "clearance(rod, tube)",
            "over": poses,
            "at_least": "5 mm",
            "tolerance": "0.1 mm",
            "must": True,
        },
        {"quantity": "clearance(joint, rim)", "at_least": "20 mm", "tolerance": "0.1 mm"},
    ]
    free = {"hardpoints.tie_rod_inner": "35 mm", "hardpoints.tie_rod_outer": "15 mm"}
    found = jn.design_kinematics("formula-student-front", free, targets, starts=1, shapes=shapes)
    assert found.met
    assert min(found.targets[1].before) < 0.0
    pair = {"rod": (shapes["rod"], shapes["tube"]), "joint": (shapes["joint"], shapes["rim"])}
    apart = jn.clearances(found.rig, pair, poses)
    assert float(apart["rod"].min()) >= 4.9e-3 - 1e-9
    assert apart["rod"].to_numpy().ravel() == pytest.approx(
        np.array(found.targets[1].after), abs=1e-9
    )
    with pytest.raises(jn.DescriptionError, match="tube"):
        jn.design_kinematics(
            "formula-student-front",
            free,
            [{**targets[1], "quantity": "clearance(rod, tub)"}],
            shapes=shapes,
        )
