"""Where runs of mechanisms start, through which poses they go, and what rounding leaves of a tolerance."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

X, Y, Z, ORIGIN = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (0.0, 0.0, 0.0)


def governor():
    """A ball on a light arm that swings on a spindle, which turns freely."""
    mechanism = jn.mechanics.Mechanism()
    spindle = mechanism.body("spindle", 1.0, ORIGIN, (0.1, 0.1, 0.2))
    arm = mechanism.body("arm", 0.5, (0.0, 0.0, -0.4))
    mechanism.revolute("spin", mechanism.ground, spindle, at=ORIGIN, axis=Z)
    mechanism.revolute("swing", spindle, arm, at=ORIGIN, axis=(0.0, -1.0, 0.0))
    mechanism.watch_coordinates()
    return mechanism


def test_given_speeds_are_kept_and_all_else_is_in_equilibrium():
    """A ball at rest on a turning arm hangs at cos(a) = g / (w^2 l)."""
    start = {"spin.angle rate": 9.0, "swing.angle": 0.8}
    run = jn.simulate_mechanism(
        governor(), 1.0, start=start, at_rest=True, output_step=0.1, tolerance=1e-9
    )
    np.testing.assert_allclose(run["spin.angle rate"], 9.0, rtol=1e-9)
    np.testing.assert_allclose(
        run["swing.angle"], np.arccos(9.81 / (81.0 * 0.4)), rtol=0.0, atol=1e-7
    )
    assert not run.attrs["findings"]


def car():
    """A body on four upright springs that stand on the level ground wherever it is."""
    mechanism = jn.mechanics.Mechanism()
    body = mechanism.body("car", 400.0, (0.1, 0.0, 0.5), (60.0, 150.0, 180.0))
    mechanism.free("flight", body)
    for x in (-1.0, 1.0):
        for y in (-0.6, 0.6):
            foot = body.point((x, y, 0.0)).value[2]
            mechanism.force(
                foot,
                mechanism.switch(f"contact {x} {y}", -foot) * -20e3 * foot
                - 300.0 * mechanism.rate_of(foot),
            )
    mechanism.watch_body(body)
    mechanism.watch_coordinates()
    return mechanism


def test_equilibrium_leaves_alone_what_nothing_decides_and_says_so():
    start = {"flight.x": 3.0, "flight.y": -2.0, "flight.z": -0.02, "flight.x rate": 5.0}
    start |= jn.mechanics.orientation("flight", Z, "30 deg")
    run = jn.simulate_mechanism(car(), 0.5, start=start, at_rest=True, output_step=0.1)
    (finding,) = run.attrs["findings"]
    assert "flight.y, flight.wz: its rest position is undetermined" in finding
    assert float(run["car.yaw"][0]) == pytest.approx(np.radians(30.0), abs=1e-9)
    assert float(run["flight.y"][0]) == pytest.approx(-2.0, abs=1e-12)
    np.testing.assert_allclose(run["flight.x"], 3.0 + 5.0 * run["time"], rtol=0.0, atol=1e-6)
    weight = (
        400.0 * 9.81
    )  # 0.1 m ahead of the middle, and 0.5 m above the feet, so it leans forward itself
    pitch = 0.1 * weight / (4.0 * 20e3 - 0.5 * weight)
    np.testing.assert_allclose(run["car.pitch"], pitch, rtol=0.0, atol=1e-6)
    np.testing.assert_allclose(run["car.vz"], 0.0, rtol=0.0, atol=1e-6)


@pytest.mark.parametrize("sag", [0.5, 12.0, 300.0, 40e3])
def test_an_equilibrium_is_found_however_far_it_is(sag: float):
    """A weight on a soft upright spring sags by m g / k; a soft torsion spring winds up by torque over rate."""
    mechanism = jn.mechanics.Mechanism()
    block, drum = (
        mechanism.body("block", 1.0, ORIGIN),
        mechanism.body("drum", 1.0, ORIGIN, (0.1, 0.1, 0.1)),
    )
    fall = mechanism.prismatic("fall", mechanism.ground, block, axis=Z)
    mechanism.force(fall, -9.81 / sag * fall)
    mechanism.revolute("wind", mechanism.ground, drum, at=ORIGIN, axis=Y)
    mechanism.rotational_spring_damper("torsion", "wind", stiffness=2.0 / sag)
    mechanism.apply_torque(drum, (0.0, 2.0, 0.0))
    mechanism.watch_coordinates()
    run = jn.simulate_mechanism(mechanism, 0.1, at_rest=True, output_step=0.1)
    np.testing.assert_allclose(run["fall.distance"], -sag, rtol=1e-9)
    np.testing.assert_allclose(run["wind.angle"], sag, rtol=1e-9)


def test_a_chain_of_arms_is_found_hanging_far_below_its_design():
    """Three arms of 30 m that stand nearly upright fall by turning: a way that curves all along."""
    mechanism = jn.mechanics.Mechanism()
    below = mechanism.ground
    for i in range(3):
        arm = mechanism.body(f"arm {i}", 1.0, (0.0, 0.0, 30.0 * (i + 1)), (1.0, 1.0, 1.0))
        mechanism.revolute(f"hinge {i}", below, arm, at=(0.0, 0.0, 30.0 * i), axis=Y)
        below = arm
    mechanism.spring_damper(
        "spring", mechanism.ground, below, (0.0, 0.0, -200.0), (0.0, 0.0, 90.0), stiffness=1.0
    )
    mechanism.watch_body(below)
    mechanism.watch_coordinates()
    run = jn.simulate_mechanism(
        mechanism, 0.1, start={"hinge 0.angle": 2.0}, at_rest=True, output_step=0.1
    )
    for name in ("arm 2.vx", "arm 2.vz"):
        np.testing.assert_allclose(run[name], 0.0, rtol=0.0, atol=1e-6)


def test_a_speed_of_zero_that_is_given_is_no_running_motion():
    """The block sinks into its spring whether its speed of 0 is given or not."""
    mechanism = jn.mechanics.Mechanism()
    fall = mechanism.prismatic(
        "fall", mechanism.ground, mechanism.body("block", 1.0, ORIGIN), axis=Z
    )
    mechanism.force(fall, -100.0 * fall)
    mechanism.watch_coordinates()
    for start in ({}, {"fall.distance rate": 0.0}, {"fall.distance rate": "0 mm/s"}):
        run = jn.simulate_mechanism(mechanism, 0.1, start=start, at_rest=True)
        np.testing.assert_allclose(run["fall.distance"], -0.0981, rtol=1e-9)


@pytest.mark.parametrize(("angle", "rests", "falls"), [(0.4, 0.0, False), (2.5, np.pi, True)])
def test_a_pendulum_that_rests_upside_down_is_told(angle, rests, falls):
    mechanism = jn.mechanics.Mechanism()
    bob = mechanism.body("bob", 2.0, (0.0, 0.0, -0.5), (0.1, 0.1, 0.1))
    mechanism.revolute("pivot", mechanism.ground, bob, at=ORIGIN, axis=Y)
    slide = mechanism.body("slide", 1.0, ORIGIN)
    mechanism.prismatic(
        "drift", mechanism.ground, slide, axis=Y
    )  # nothing moves it: it does not fall
    mechanism.watch_coordinates()
    run = jn.simulate_mechanism(
        mechanism, 0.1, start={"pivot.angle": angle}, at_rest=True, output_step=0.1
    )
    assert float(run["pivot.angle"][0]) == pytest.approx(rests, abs=1e-9)
    told = [text for text in run.attrs["findings"] if "in unstable equilibrium" in text]
    assert [text.split(": ")[1] for text in told] == ["pivot.angle"] * falls


def _told_of_a_top(mechanism, **options) -> list[str]:
    mechanism.watch_coordinates()
    run = jn.simulate_mechanism(mechanism, 0.1, at_rest=True, output_step=0.1, **options)
    return [
        text.split(": ")[1] for text in run.attrs["findings"] if "in unstable equilibrium" in text
    ]


def test_every_top_is_told():
    """Two pendulums that fall by themselves, of 10 1/s^2 and less, beside a block that is held with 1e11 1/s^2."""
    mechanism = jn.mechanics.Mechanism()
    for name, length in (("long", 0.8), ("short", 0.5), ("hanging", 0.3)):
        bob = mechanism.body(name, 1.0, (0.0, 0.0, -length), (0.01, 0.01, 0.01))
        mechanism.revolute(name, mechanism.ground, bob, at=ORIGIN, axis=Y)
    block = mechanism.prismatic(
        "held", mechanism.ground, mechanism.body("block", 1.0, ORIGIN), axis=X
    )
    mechanism.force(block, -1e11 * block)
    assert _told_of_a_top(mechanism, start={"long.angle": 2.5, "short.angle": 2.5}) == [
        "long.angle, short.angle"
    ]


def test_a_ball_joint_upside_down_falls_to_all_sides():
    mechanism = jn.mechanics.Mechanism()
    mechanism.spherical(
        "ball", mechanism.ground, mechanism.body("bob", 1.0, Z, (0.01, 0.01, 0.01)), at=ORIGIN
    )
    assert _told_of_a_top(mechanism) == ["ball.wx, ball.wy"]


@pytest.mark.parametrize("stiffness", [1e3, 1e7, 1e11])
def test_what_rounding_of_stiff_springs_moves_does_not_fall(stiffness):
    """Two bodies that a spring of any stiffness joins turn and slide freely."""
    mechanism = jn.mechanics.Mechanism(gravity=0.0)
    one = mechanism.body("one", 1.3, ORIGIN, (0.01, 0.02, 0.03))
    other = mechanism.body("other", 0.4, (0.6, 0.3, 0.2), (0.01, 0.02, 0.03))
    for body in (one, other):
        mechanism.free(body.name, body)
    mechanism.spring_damper(
        "spring", one, other, (0.0, 0.0, 0.1), (0.6, 0.3, 0.25), stiffness=stiffness
    )
    assert _told_of_a_top(mechanism) == []


@pytest.mark.parametrize(("rate", "told"), [(0.0, ["swing.angle"]), (10.0, [])])
def test_what_a_track_turns_is_on_no_top(rate, told):
    """A slide on a turned table that no spring would hold alone; an arm upside down, where the table stands still."""
    mechanism = jn.mechanics.Mechanism()
    table = mechanism.body("table", 5.0, ORIGIN, (0.1, 0.1, 0.2))
    spin = mechanism.revolute("spin", mechanism.ground, table, at=ORIGIN, axis=Z)
    out = mechanism.prismatic("out", table, mechanism.body("slide", 1.0, (0.2, 0.0, 0.0)), axis=X)
    mechanism.force(out, -50.0 * out)
    mechanism.motion("drive", spin, mechanism.track("turn"))
    if told:
        mechanism.revolute(
            "swing", table, mechanism.body("arm", 0.5, (0.0, 0.0, 0.4)), at=ORIGIN, axis=Y
        )
    assert _told_of_a_top(mechanism, motions={"turn": jn.mechanics.constant_rate(rate)}) == told


def test_what_nothing_holds_is_named():
    mechanism = jn.mechanics.Mechanism()
    mechanism.prismatic("fall", mechanism.ground, mechanism.body("block", 1.0, ORIGIN), axis=Z)
    with pytest.raises(
        jn.SimulationError, match=r"fall\.distance: no static equilibrium was found"
    ):
        jn.simulate_mechanism(mechanism, 0.1, at_rest=True)


def between_springs(length: float):
    """A free body of 1 kg between six springs of 1 kN/m: their lengths are known to some 1e-16 of themselves only."""
    mechanism = jn.mechanics.Mechanism(gravity=0.0)
    body = mechanism.body("body", 1.0, ORIGIN, (0.1, 0.1, 0.1))
    mechanism.free("flight", body)
    for i, axis in enumerate(np.eye(3)):
        for side in (-1.0, 1.0):
            end = side * length * axis
            mechanism.spring_damper(
                f"spring {i} {side:g}", mechanism.ground, body, end, ORIGIN, stiffness=1e3
            )
    mechanism.watch_coordinates()
    return mechanism


@pytest.mark.parametrize("duration", [0.1, 0.5, 3.0])
@pytest.mark.parametrize(
    ("length", "fine", "coarse", "advised"),
    [(1e4, 1e-10, 1e-8, 1e-8), (1e5, 3e-10, 1e-7, 1e-7), (10.0, None, 1e-11, None)],
)
def test_a_tolerance_that_rounding_forbids_is_said_whatever_the_duration(
    length, fine, coarse, advised, duration
):
    """What is advised is had, against the closed form, with a part of the steps."""
    mechanism = between_springs(length)
    given = {
        "start": {"flight.x": 0.1, "flight.z rate": 1.0},
        "output_step": duration / 10.0,
        "method": "explicit",
    }
    free = jn.simulate_mechanism(mechanism, duration, **given, tolerance=coarse)
    far = [
        "warning: points" for _ in range(length > 10.0)
    ]  # they look like millimetres given as metres
    assert [text.rpartition(": ")[0][:15] for text in free.attrs["findings"]] == far
    if fine is None:
        return
    run = jn.simulate_mechanism(mechanism, duration, **given, tolerance=fine)
    *_, finding = run.attrs["findings"]
    assert f"tolerance: {fine:g} is below rounding accuracy here" in finding
    assert f"; {advised:g} needs only a few" in finding
    assert run.attrs["steps"] > 5 * free.attrs["steps"]
    pace = np.sqrt(2e3)  # two of the springs lie along each axis
    exact = {"x": 0.1 * np.cos(pace * run["time"]), "z": np.sin(pace * run["time"]) / pace}
    for axis, way in exact.items():
        assert float(abs(free[f"flight.{axis}"] - way).max()) < advised * float(abs(way).max())


def isosceles():
    """A crank and a rod of one length: when the piston comes to the crank's bearing, both could swing like a door."""
    mechanism = jn.mechanics.Mechanism(gravity=0.0)
    inertia = (0.01, 0.01, 0.01)
    crank = mechanism.body("crank", 1.0, (0.25, 0.0, 0.25), inertia)
    rod = mechanism.body("rod", 1.0, (0.75, 0.0, 0.25), inertia)
    piston = mechanism.body("piston", 1.0, (1.0, 0.0, 0.0), inertia)
    mechanism.revolute("main", mechanism.ground, crank, at=ORIGIN, axis=Y)
    mechanism.revolute("knee", crank, rod, at=(0.5, 0.0, 0.5), axis=Y)
    mechanism.prismatic("bore", mechanism.ground, piston, axis=X, at=(1.0, 0.0, 0.0))
    mechanism.point_on_line("pin", rod, piston, at=(1.0, 0.0, 0.0), axis=Y, point=(1.0, 0.0, 0.0))
    mechanism.watch_coordinates()
    mechanism.watch_energy()
    return mechanism


def test_a_loop_that_could_become_a_door_goes_on_as_its_momentum_says():
    """However long the run is: no impulse turns the motion towards the door, which is at rest when the pose is met."""
    mechanism = isosceles()
    for duration in (0.5, 0.8, 1.3, 2.0, 3.0):
        run = jn.simulate_mechanism(
            mechanism, duration, start={"main.angle rate": -3.0}, output_step=0.01
        )
        assert run.attrs["status"] == "completed"
        assert "a singular configuration" in run.attrs["findings"][0]
        place = 2.0 * np.sqrt(0.5) * np.cos(np.radians(45.0) - run["main.angle"])
        np.testing.assert_allclose(1.0 + run["bore.distance"], place, rtol=0.0, atol=1e-8)
        np.testing.assert_allclose(run["knee.angle"], -2.0 * run["main.angle"], rtol=0.0, atol=1e-7)
        np.testing.assert_allclose(run["energy.kinetic"], run["energy.kinetic"][0], rtol=1e-6)


def driven_arm():
    mechanism = jn.mechanics.Mechanism()
    bob = mechanism.body("bob", 1.0, X, (0.1, 0.1, 0.1))
    angle = mechanism.revolute("pivot", mechanism.ground, bob, at=ORIGIN, axis=Y)
    mechanism.motion("drive", angle, mechanism.track("turn"))
    mechanism.watch_coordinates()
    return mechanism


def test_a_start_at_rest_has_the_speed_of_a_running_motion():
    motions = {"turn": jn.mechanics.harmonic(0.1, 1.0)}
    run = jn.simulate_mechanism(driven_arm(), 0.1, motions=motions, at_rest=True, output_step=0.05)
    assert float(run["pivot.angle rate"][0]) == pytest.approx(0.2 * np.pi, rel=1e-6)
    assert run.attrs["findings"] == []


def test_given_speeds_that_the_loops_change_are_said():
    motions = {"turn": jn.mechanics.harmonic(0.1, 1.0)}
    start = {"pivot.angle rate": 5.0}
    run = jn.simulate_mechanism(driven_arm(), 0.1, motions=motions, start=start, output_step=0.05)
    assert run.attrs["findings"] == ["note: pivot.angle rate: assembly moved it from 5 to 0.628319"]


@pytest.mark.parametrize("angle", [0.0, 0.001, 0.3])
def test_a_pendulum_comes_to_rest_where_it_hangs_and_no_turns_away(angle):
    """A start that is level, or nearly so, has a slope that would throw Newton's method far away."""
    mechanism = jn.mechanics.Mechanism()
    bob = mechanism.body("bob", 1.0, (0.3, 0.0, 0.0), (0.1, 0.1, 0.1))
    mechanism.revolute("pivot", mechanism.ground, bob, at=ORIGIN, axis=Y)
    mechanism.watch_coordinates()
    run = jn.simulate_mechanism(
        mechanism, 0.1, start={"pivot.angle": angle}, at_rest=True, output_step=0.05
    )
    np.testing.assert_allclose(run["pivot.angle"], 0.5 * np.pi, rtol=0.0, atol=1e-9)


def four_bar_on_a_slide():
    """A loop with a spring on its crank, on a base that slides freely along the level."""
    mechanism = jn.mechanics.Mechanism()
    base = mechanism.body("base", 5.0, ORIGIN, (0.1, 0.1, 0.1))
    mechanism.prismatic("slide", mechanism.ground, base, axis=X)
    crank = mechanism.body("crank", 1.0, (0.0, 0.0, 0.1), (0.01, 0.01, 0.001))
    coupler = mechanism.body("coupler", 2.0, (0.2, 0.0, 0.25), (0.01, 0.02, 0.02))
    rocker = mechanism.body("rocker", 1.5, (0.45, 0.0, 0.15), (0.01, 0.01, 0.001))
    mechanism.revolute("crank", base, crank, at=ORIGIN, axis=Y)
    mechanism.revolute("joint", crank, coupler, at=(0.0, 0.0, 0.2), axis=Y)
    mechanism.revolute("rocker", base, rocker, at=(0.5, 0.0, 0.0), axis=Y)
    mechanism.coincident("loop", coupler, rocker, at=(0.4, 0.0, 0.3))
    mechanism.rotational_spring_damper("spring", "crank", stiffness=40.0, free_angle=0.1)
    mechanism.watch_coordinates()
    return mechanism


def test_what_nothing_decides_stays_where_it_starts_beside_loops():
    given = {"at_rest": True, "redundant": "remove", "output_step": 0.05}
    start = {"crank.angle": 1.0, "slide.distance": 0.2}
    run = jn.simulate_mechanism(four_bar_on_a_slide(), 0.1, start=start, **given)
    np.testing.assert_allclose(run["slide.distance"], 0.2, rtol=0.0, atol=1e-9)
    np.testing.assert_allclose(run["crank.angle acceleration"], 0.0, rtol=0.0, atol=1e-6)
    assert any(
        "slide.distance: its rest position is undetermined" in text
        for text in run.attrs["findings"]
    )


def test_a_speed_that_is_given_leaves_its_coordinate_and_may_leave_no_equilibrium():
    with pytest.raises(jn.SimulationError, match="no static equilibrium was found"):
        jn.simulate_mechanism(
            four_bar_on_a_slide(),
            0.1,
            start={"crank.angle rate": 3.0},
            at_rest=True,
            redundant="remove",
        )
