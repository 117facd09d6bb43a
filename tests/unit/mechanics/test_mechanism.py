"""What the authoring API promises: order does not matter where it need not, numbers change without compiling, names."""

from __future__ import annotations

import json
import re

import casadi
import numpy as np
import pytest

import jounce as jn
from jounce.mechanics import joints
from jounce.mechanics.expressions import text_of
from jounce.simulation import compiled

X, Y, Z, ORIGIN = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (0.0, 0.0, 0.0)
BALL = (0.1, 0.1, 0.1)
CHAIN = ((0.0, 0.0), (0.0, 0.2), (0.4, 0.3), (0.5, 0.0))


def pendulum():
    mechanism = jn.mechanics.Mechanism()
    body = mechanism.body("bob", "500 g", ("80 cm", 0.0, 0.0), ("0.01 kg*m^2", 0.01, 0.01))
    mechanism.revolute("pivot", mechanism.ground, body, at=ORIGIN, axis=(0.0, 3.0, 0.0))
    mechanism.watch_body(body)
    return mechanism, body


def chain():
    mechanism = jn.mechanics.Mechanism()
    a, b, c, d = (np.array([x, 0.0, z]) for x, z in CHAIN)
    crank, coupler, rocker = (
        mechanism.body(name, 1.0, 0.5 * (one + other), (0.01, 0.01, 0.01))
        for name, one, other in (("crank", a, b), ("coupler", b, c), ("rocker", c, d))
    )
    mechanism.revolute("left.A", mechanism.ground, crank, at=a, axis=Y)
    mechanism.revolute("left.B", crank, coupler, at=b, axis=Y)
    mechanism.revolute("right.D", mechanism.ground, rocker, at=d, axis=Y)
    mechanism.revolute("right.C", coupler, rocker, at=c, axis=Y)
    mechanism.watch_coordinates()
    mechanism.watch_energy()
    return mechanism


def test_texts_with_units_are_read():
    mechanism, _ = pendulum()
    assert mechanism.values["bob.mass"] == 0.5
    assert mechanism.values["bob.centre_of_mass[0]"] == pytest.approx(0.8)
    run = jn.simulate_mechanism(
        mechanism, "200 ms", start={"pivot.angle": "-90 deg", "pivot.angle rate": "60 deg/s"}
    )
    assert float(run["bob.z"][0]) == pytest.approx(0.8)
    assert float(run["bob.vx"][0]) == pytest.approx(0.8 * np.pi / 3.0)


def test_other_numbers_need_no_other_model(monkeypatch):
    mechanism, _ = pendulum()
    jn.simulate_mechanism(mechanism, 0.1)
    monkeypatch.setattr(compiled, "compile_functions", lambda *_: pytest.fail("compiled anew"))
    run = jn.simulate_mechanism(
        mechanism, 0.1, values={"bob.centre_of_mass[0]": "1 m", "gravity": 5.0}
    )
    assert float(run["bob.x"][0]) == 1.0
    assert float(run["bob.az"][0]) == pytest.approx(-5.0 * 0.5 / (0.5 + 0.01))
    assert mechanism.values["gravity"] == 9.81


def test_what_is_added_after_a_run_counts():
    mechanism, body = pendulum()
    first = jn.simulate_mechanism(mechanism, 0.1)
    tip = mechanism.body("tip", 1.0, (1.0, 0.0, 0.0), BALL)
    mechanism.fixed("weld", body, tip)
    mechanism.watch_point("end", tip, (1.0, 0.0, 0.0))
    second = jn.simulate_mechanism(mechanism, 0.1)
    assert "end.z" not in first
    inertia, moment = 0.01 + 0.5 * 0.8**2 + 0.1 + 1.0, 0.5 * 0.8 + 1.0
    assert float(second["end.az"][0]) == pytest.approx(-9.81 * moment / inertia)


def test_reactions_and_energies_may_be_asked_for_early():
    early, late = (jn.mechanics.Mechanism() for _ in range(2))
    runs = []
    for mechanism, is_early in ((early, True), (late, False)):
        body = mechanism.body("bob", 1.0, (1.0, 0.0, 0.0), BALL)
        mechanism.revolute("pivot", mechanism.ground, body, at=ORIGIN, axis=Y)
        for turn in (is_early, not is_early):
            if turn:
                mechanism.watch_reaction("pivot")
                mechanism.watch_energy()
                mechanism.watch_coordinates()
            else:
                end = mechanism.body("end", 2.0, (2.0, 0.0, 0.0), BALL)
                mechanism.revolute("elbow", body, end, at=(1.5, 0.0, 0.0), axis=Y)
                mechanism.apply_force(end, (0.0, 0.0, 4.0), (2.0, 0.0, 0.0))
        runs.append(jn.simulate_mechanism(mechanism, 0.2, output_step=0.05))
    assert set(runs[0].data_vars) == set(runs[1].data_vars)
    for name in runs[0].data_vars:
        np.testing.assert_allclose(runs[0][name], runs[1][name], rtol=0.0, atol=1e-9, err_msg=name)


def test_refused_redundancy_can_be_removed_afterwards():
    mechanism = chain()
    with pytest.raises(jn.AssemblyError, match=re.escape("right.C: redundant joints")) as caught:
        jn.simulate_mechanism(mechanism, 0.2)
    assert "in the loop of right.C, right.D, left.A, left.B" in str(caught.value)
    run = jn.simulate_mechanism(mechanism, 0.2, redundant="remove")
    assert float(run["constraint.residual"].max()) < 1e-12
    with pytest.raises(jn.AssemblyError, match="redundant joints"):
        jn.simulate_mechanism(mechanism, 0.2)


def test_assembly_says_what_it_moved_and_keeps_what_was_given():
    run = jn.simulate_mechanism(
        chain(),
        0.1,
        start={"left.A.angle": 0.5, "left.A.angle rate": 3.0},
        redundant="remove",
        output_step=0.05,
    )
    assert float(run["left.A.angle"][0]) == pytest.approx(0.5, abs=1e-12)
    assert float(run["left.A.angle rate"][0]) == pytest.approx(3.0, abs=1e-12)
    moved = [
        text.split(":")[1].strip() for text in run.attrs["findings"] if "assembly moved" in text
    ]
    assert moved == ["left.B.angle", "right.D.angle"]
    assert "assembly moved it from 0 to -0.602196" in run.attrs["findings"][0]


def test_removed_equations_are_chosen_anew_where_others_are_superfluous():
    """Across the plane means across y, and across x when the chain is turned by a right angle."""
    mechanism = chain()
    first = jn.simulate_mechanism(mechanism, 0.2, redundant="remove", output_step=0.05)
    values = {
        path: 0.0
        for path in mechanism.values
        if re.search(r"(at|axis|centre_of_mass)\[[01]\]$", path)
    }
    for path in list(values):
        stem, place = path[:-3], path[-2]
        other = mechanism.values[f"{stem}[{1 - int(place)}]"]
        values[path] = other if place == "1" else -other  # x to y, y to -x
    turned = jn.simulate_mechanism(
        mechanism, 0.2, values=values, redundant="remove", output_step=0.05
    )
    again = jn.simulate_mechanism(mechanism, 0.2, redundant="remove", output_step=0.05)
    for name in first.data_vars:
        np.testing.assert_allclose(turned[name], first[name], rtol=0.0, atol=1e-6, err_msg=name)
        np.testing.assert_array_equal(again[name], first[name])
    assert float(turned["constraint.residual"].max()) < 1e-12


def test_motions_decide_where_a_run_starts():
    mechanism = chain()
    mechanism.motion("drive", mechanism.coordinate_named("left.A.angle"), mechanism.track("turn"))
    motions = {"turn": jn.mechanics.constant_rate(2.0, start=0.5)}
    run = jn.simulate_mechanism(
        mechanism, 0.2, motions=motions, redundant="remove", output_step=0.05
    )
    np.testing.assert_allclose(run["left.A.angle"], 0.5 + 2.0 * run["time"], rtol=0.0, atol=1e-12)
    assert set(run.data_vars) >= {"energy.supplied", "left.A.angle acceleration"}


def test_orientations_are_taken_at_length_one_and_shown():
    mechanism = jn.mechanics.Mechanism(gravity=0.0)
    mechanism.free("flight", mechanism.body("bob", 1.0, ORIGIN, BALL))
    mechanism.watch_coordinates()
    run = jn.simulate_mechanism(
        mechanism, 0.2, start={"flight.e0": 2.0, "flight.e3": 2.0, "flight.wz": 1.0}
    )
    assert float(run["flight.e0"][0]) == pytest.approx(np.sqrt(0.5))
    turn = 0.25 * np.pi + 0.5 * run["time"]
    np.testing.assert_allclose(run["flight.e3"], np.sin(turn), rtol=0.0, atol=1e-8)
    assert run["flight.wz"].attrs["units"] == "rad/s"
    assert run["flight.x acceleration"].attrs["units"] == "m/s^2"


def test_reaction_in_the_axes_of_a_body():
    mechanism = jn.mechanics.Mechanism()
    body = mechanism.body("bob", 1.0, (1.0, 0.0, 0.0))
    mechanism.revolute("pivot", mechanism.ground, body, at=ORIGIN, axis=Y)
    mechanism.watch_reaction("pivot", frame="bob")
    mechanism.watch_coordinates()
    run = jn.simulate_mechanism(mechanism, 1.0, output_step=0.05, tolerance=1e-9)
    fallen = np.sin(
        run["pivot.angle"]
    )  # a point on a string that falls from level: tension 3 m g sin
    np.testing.assert_allclose(run["pivot.fx"], -3.0 * 9.81 * fallen, rtol=0.0, atol=1e-6)
    np.testing.assert_allclose(run["pivot.fz"], 0.0, rtol=0.0, atol=1e-9)


def test_turn_between_bodies_is_seen_along_an_axis():
    mechanism = jn.mechanics.Mechanism(gravity=0.0)
    table = mechanism.body("table", 1.0, ORIGIN, BALL)
    arm = mechanism.body("arm", 1.0, ORIGIN, BALL)
    mechanism.revolute("one", mechanism.ground, table, at=ORIGIN, axis=Z)
    mechanism.revolute("two", table, arm, at=ORIGIN, axis=Z)
    mechanism.watch_angle("between", table, arm, (0.0, 0.0, 2.0))
    mechanism.watch_angle("whole", mechanism.ground, arm, Z)
    start = {"one.angle rate": 1.0, "two.angle rate": -3.0, "two.angle": 0.3}
    run = jn.simulate_mechanism(mechanism, 1.0, start=start, output_step=0.1, tolerance=1e-9)
    np.testing.assert_allclose(run["between"], 0.3 - 3.0 * run["time"], rtol=0.0, atol=1e-9)
    np.testing.assert_allclose(run["whole rate"], -2.0, rtol=1e-9)
    np.testing.assert_allclose(run["whole acceleration"], 0.0, rtol=0.0, atol=1e-9)


def test_motions_are_what_they_say():
    time = np.array([-1.0, 0.0, 0.25, 1.0, 3.0])
    value, rate = jn.mechanics.harmonic(2.0, 1.0, phase=0.5, mean=1.0).evaluate(time)
    np.testing.assert_allclose(value, 1.0 + 2.0 * np.sin(2.0 * np.pi * time + 0.5), rtol=1e-12)
    np.testing.assert_allclose(rate, 4.0 * np.pi * np.cos(2.0 * np.pi * time + 0.5), rtol=1e-12)
    assert jn.mechanics.constant(3.0).evaluate(time)[0].tolist() == [3.0] * 5
    spline = jn.mechanics.interpolated([0.0, 0.5, 1.0], [0.0, 1.0, 0.0])
    value, rate = spline.evaluate(time)
    np.testing.assert_allclose(
        value, [0.0, 0.0, 0.6875, 0.0, 0.0], rtol=0.0, atol=1e-15
    )  # natural ends; held beyond
    np.testing.assert_allclose(rate, [0.0, 3.0, 2.25, 0.0, 0.0], rtol=0.0, atol=1e-14)
    lines = jn.mechanics.interpolated([0.0, 0.5, 1.0], [0.0, 1.0, 0.0], smooth=False)
    assert lines.evaluate(np.array([0.25, 0.75]))[1].tolist() == [2.0, -2.0]


def test_universal_joint_counts_from_the_first_body_to_the_second():
    runs = []
    for swapped in (False, True):
        mechanism = jn.mechanics.Mechanism(gravity=0.0)
        body = mechanism.body("bob", 1.0, (1.0, 0.0, 0.0), BALL)
        bodies, axes = (mechanism.ground, body), (Z, Y)
        if swapped:
            bodies, axes = bodies[::-1], axes[::-1]
        mechanism.universal("cross", *bodies, at=ORIGIN, axis=axes[0], second_axis=axes[1])
        mechanism.watch_point("tip", body, (1.0, 0.0, 0.0))
        angles = (
            (-0.3, -0.5) if swapped else (0.5, 0.3)
        )  # about z on the ground, then about y on the body
        start = dict(zip(("cross.angle", "cross.second_angle"), angles, strict=True))
        start["cross.second_angle rate" if swapped else "cross.angle rate"] = (
            -2.0 if swapped else 2.0
        )
        runs.append(
            jn.simulate_mechanism(mechanism, 0.5, start=start, output_step=0.1, tolerance=1e-9)
        )
    tip = np.array([np.cos(0.5) * np.cos(0.3), np.sin(0.5) * np.cos(0.3), -np.sin(0.3)])
    for axis, value in zip("xyz", tip, strict=True):
        assert float(runs[0][f"tip.{axis}"][0]) == pytest.approx(value)
        np.testing.assert_allclose(
            runs[1][f"tip.{axis}"], runs[0][f"tip.{axis}"], rtol=0.0, atol=1e-8
        )


def test_orientation_turns_a_start():
    mechanism = jn.mechanics.Mechanism()
    body = mechanism.body("bob", 1.0, (1.0, 0.0, 0.0), BALL)
    mechanism.spherical("ball", mechanism.ground, body, at=ORIGIN)
    mechanism.watch_body(body)
    start = jn.mechanics.orientation("ball", axis=(0.0, 3.0, 0.0), angle="90 deg")
    run = jn.simulate_mechanism(mechanism, 0.1, start=start, output_step=0.05)
    np.testing.assert_allclose(run["bob.z"], -1.0, rtol=0.0, atol=1e-12)  # it hangs
    with pytest.raises(jn.AssemblyError, match="ball: an axis without direction"):
        jn.mechanics.orientation("ball", axis=ORIGIN, angle=1.0)


def test_a_mechanism_lists_itself():
    mechanism = chain()
    crank, rocker = mechanism.bodies["crank"], mechanism.bodies["rocker"]
    mechanism.spring_damper(
        "strut", crank, rocker, (0.0, 0.0, 0.1), (0.45, 0.0, 0.15), stiffness="2 N/mm"
    )
    angle = mechanism.coordinate_named("left.A.angle")
    mechanism.stop("end", angle, upper="80 deg", stiffness=100.0)
    mechanism.force(crank.point((0.0, 0.0, 0.2)).value[0], -3.0 * angle)
    mechanism.motion("drive", angle, mechanism.track("turn"))
    listed = json.loads(json.dumps(mechanism.to_dict(), allow_nan=False))
    assert [one["name"] for one in listed["bodies"]] == ["crank", "coupler", "rocker"]
    assert listed["bodies"][0]["inertia"]["zz"] == 0.01
    hinge = listed["joints"][0]
    assert (hinge["kind"], hinge["first"], hinge["carries"]) == ("revolute", "ground", "crank")
    assert hinge["coordinates"] == [{"name": "left.A.angle", "unit": "rad"}]
    (closure,) = listed["closures"]
    assert closure["loop"] == ["right.C", "right.D", "left.A", "left.B"]
    assert closure["at"] == [0.4, 0.0, 0.3]
    assert [one["name"] for one in closure["equations"]][-2:] == ["right.C.tilt", "right.C.tilt_2"]
    strut, end, push = listed["loads"]
    assert (strut["stiffness"], strut["units"]["stiffness"]) == (2000.0, "N/m")
    assert (end["upper"], end["units"]["upper"]) == (pytest.approx(np.radians(80.0)), "rad")
    assert push["bodies"] == ["crank"]
    assert listed["conditions"][0]["tracks"] == ["turn"]
    text = str(mechanism)
    assert (
        "right.C: revolute, coupler - rocker, at (0.4, 0, 0.3) m, axis (0, 1, 0); equations 5"
        in text
    )
    assert "strut: spring and damper, crank - rocker" in text
    assert mechanism.to_dict({"strut.stiffness": 5.0})["loads"][0]["stiffness"] == 5.0


def test_the_point_at_which_a_torque_is_given_can_be_chosen():
    """A beam held at one end carries its weight: no torque there where it is given at the centre of mass."""

    def held(**given):
        mechanism = jn.mechanics.Mechanism()
        beam = mechanism.body("beam", 2.0, (0.5, 0.0, 0.0), BALL)
        mechanism.fixed("root", mechanism.ground, beam)
        moving = mechanism.body("slider", 1.0, ORIGIN)
        mechanism.prismatic("slide", mechanism.ground, moving, axis=X)
        mechanism.watch_reaction("root", **given)
        return jn.simulate_mechanism(mechanism, 0.1, output_step=0.1)

    run = held()
    np.testing.assert_allclose(run["root.ty"], -0.5 * 2.0 * 9.81, rtol=1e-12)
    run = held(at=(0.5, 0.0, 0.0), on="ground")
    np.testing.assert_allclose(run["root.ty"], 0.0, rtol=0.0, atol=1e-12)
    np.testing.assert_allclose(run["root.fz"], -2.0 * 9.81, rtol=1e-12)


def test_a_listing_takes_units_and_refuses_names_it_does_not_know():
    mechanism = jn.mechanics.Mechanism()
    block = mechanism.body("block", 1.0, ORIGIN, BALL)
    table = mechanism.body("table")
    mechanism.driven("shaker", mechanism.ground, table, Z, mechanism.track("road"))
    mechanism.prismatic("slide", table, block, axis=Z)
    mechanism.spring_damper("strut", table, block, (0.0, 0.0, -1.0), ORIGIN, stiffness=3.0)
    mechanism.watch_reaction("slide", on="table")
    listed = mechanism.to_dict({"strut.stiffness": "3 N/mm"})
    assert listed["loads"][0]["stiffness"] == pytest.approx(3000.0)
    assert listed["joints"][0]["travel"] == "road"
    assert listed["watched"][0]["on"] == "table"
    broken = json.loads(
        json.dumps(mechanism.to_dict({"strut.stiffness": float("nan")}), allow_nan=False)
    )
    assert broken["loads"][0]["stiffness"] is None
    with pytest.raises(
        jn.DescriptionError, match=r"unknown parameter 'strut.stifness'.*strut\.stiffness"
    ):
        mechanism.to_dict({"strut.stifness": 1.0})


def test_a_listing_holds_all_that_acts():
    """Every number and law that was given is found again, in the numbers, expressions and signs of the listing."""
    mechanism = jn.mechanics.Mechanism()
    block, other = (
        mechanism.body("block", 1.0, ORIGIN, BALL),
        mechanism.body("other", 1.0, ORIGIN, BALL),
    )
    slid = mechanism.prismatic("slide", mechanism.ground, block, axis=Z)
    turn = mechanism.revolute("turn", mechanism.ground, other, at=ORIGIN, axis=Y)
    rate = mechanism.number("own.rate", "1.2345678901 kN/m", "N/m")
    mechanism.apply_force(block, (0.0, 0.0, 1.0 / 3.0), (0.1, 0.2, 0.3))
    mechanism.apply_torque(other, (0.0, 4.0, 0.0))
    mechanism.push_apart(block, other, block.point((0.1, 0.0, 0.0)), (0.0, 0.0, 1.0), 5.0 * slid)
    mechanism.load(mechanism.rate_of(turn), -0.3 * mechanism.rate_of(turn))
    mechanism.force(block.point((1.0, 0.0, 0.0)).value[2], -rate * slid)
    mechanism.spring_damper("spring", block, other, ORIGIN, (0.0, 0.0, 2.0), stiffness=3.0)
    mechanism.spring_damper("law", block, other, ORIGIN, (0.0, 0.0, 2.0), force=rate * slid)
    mechanism.rotational_spring_damper("torsion", "turn", torque=-0.1 * turn)
    mechanism.coupler("teeth", slid - 0.05 * turn)
    mechanism.condition("rule", slid**2 - turn)
    mechanism.rod("rod", block, other, ORIGIN, (0.0, 0.0, 0.5))
    mechanism.motion("drive", turn, mechanism.track("go"))
    listed = json.loads(json.dumps(mechanism.to_dict(), allow_nan=False))
    push, twist, apart, load, general, spring, law, torsion = listed["loads"]
    own = {"own.rate": {"value": pytest.approx(1234.5678901, rel=1e-15), "unit": "N/m"}}
    assert (push["force"], push["at"], push["units"]) == (
        [0.0, 0.0, 1.0 / 3.0],
        [0.1, 0.2, 0.3],
        {"force": "N", "at": "m"},
    )
    assert (twist["body"], twist["torque"]) == ("other", [0.0, 4.0, 0.0])
    assert (apart["at"], apart["second_at"], apart["positive"]) == (
        [0.1, 0, 0],
        [0, 0, 1],
        "pushes the points apart",
    )
    assert apart["force"] == {"expression": "(5*slide.distance)", "parameters": {}}
    assert load["magnitude"]["expression"] == "(-0.3*turn.angle rate)"
    assert general["along"]["expression"] == "block.point(1, 0, 0).z"
    assert general["magnitude"] == {"expression": "(-(own.rate*slide.distance))", "parameters": own}
    assert (spring["free_length"], spring["as_designed"]) == (2.0, ["free_length"])
    assert (law["force"], law["positive"]) == (
        {"expression": "(own.rate*slide.distance)", "parameters": own},
        "compression",
    )
    assert "free_length" not in law
    assert (torsion["joint"], torsion["torque"]["expression"], torsion["positive"]) == (
        "turn",
        "(-0.1*turn.angle)",
        "along the angle",
    )
    (rod,) = listed["closures"]
    assert (rod["length"], rod["as_designed"]) == (0.5, ["length"])
    teeth, rule, drive = listed["conditions"]
    assert teeth["ratios"] == {"slide.distance": 1.0, "turn.angle": -0.05}
    assert (rule["expression"], rule["ratios"]) == ("(sq(slide.distance)-turn.angle)", None)
    assert drive["ratios"] == {"go": -1.0, "turn.angle": 1.0}
    assert listed["parameters"]["own.rate"] == own["own.rate"]
    text = str(mechanism)
    for line in (
        "  force, block, force (0, 0, 0.333333) N, at (0.1, 0.2, 0.3) m",
        "  spring: spring and damper, block - other, at (0, 0, 0) m, second at (0, 0, 2) m, free length 2 m as desig",
        "  rod: rod, block - other, at (0, 0, 0) m, second at (0, 0, 0.5) m, length 0.5 m as designed;",
        "force (own.rate*slide.distance) N with own.rate 1234.57 N/m, positive: compression",
        "  teeth: coupler of slide.distance, turn.angle, (slide.distance-(0.05*turn.angle)) = 0",
    ):
        assert line in text, line


def test_a_listing_holds_switches_states_and_moving_axes():
    mechanism = jn.mechanics.Mechanism()
    block = mechanism.body("block", 1.0, ORIGIN, BALL)
    slid = mechanism.prismatic("slide", mechanism.ground, block, axis=Z)
    up = mechanism.switch("up", slid - 0.1)
    lag = mechanism.internal_state("lag")
    mechanism.set_internal_rate("lag", 2.0 * (slid - lag))
    mechanism.force(slid, -up * lag)
    mechanism.moving_frame(block, casadi.vertcat(0.0, 0.0, -9.81))
    listed = mechanism.to_dict()
    assert listed["switches"] == [
        {"name": "up", "above_zero": {"expression": "(slide.distance-0.1)", "parameters": {}}}
    ]
    (state,) = listed["internal_states"]
    assert (state["name"], state["rate"]["expression"]) == ("lag", "(2*(slide.distance-lag))")
    assert listed["bodies"][-1] == {"name": "block axes", "axes_of": "block"}
    assert "  lag: rate (2*(slide.distance-lag))" in str(mechanism)


def test_every_joint_is_exported():
    classes = {
        name
        for name, one in vars(joints).items()
        if isinstance(one, type) and issubclass(one, joints.Joint)
    }
    assert classes <= set(jn.mechanics.__all__)
    mechanism = jn.mechanics.Mechanism()
    block = mechanism.body("block", 1.0, ORIGIN, BALL)
    mechanism.add(jn.mechanics.Revolute("pivot", mechanism.ground, block, at=ORIGIN, axis=Z))
    assert mechanism.finish().coordinates == ("pivot.angle",)


def test_expressions_are_written_with_all_digits_and_what_they_share_once():
    a, b = casadi.SX.sym("a"), casadi.SX.sym("b")
    shared = casadi.sin(a + 1.0 / 3.0)
    text = text_of(shared**2 + casadi.fmax(shared, b) / 1e-9)
    assert text == "@1 = sin((a+0.3333333333333333)), (sq(@1)+(fmax(@1,b)/1e-09))"
    assert text_of(casadi.SX(2.0)) == "2"
    assert text_of(-a) == "(-a)"
