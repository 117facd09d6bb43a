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
    run = jn.simulate_mechanism(governor(), 1.0, start=start, at_rest=True, output_step=0.1, tolerance=1e-9)
    np.testing.assert_allclose(run["spin.angle rate"], 9.0, rtol=1e-9)
    np.testing.assert_allclose(run["swing.angle"], np.arccos(9.81 / (81.0 * 0.4)), rtol=0.0, atol=1e-7)
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
                foot, mechanism.switch(f"contact {x} {y}", -foot) * -20e3 * foot - 300.0 * mechanism.rate_of(foot)
            )
    mechanism.watch_body(body)
    mechanism.watch_coordinates()
    return mechanism


def test_equilibrium_leaves_alone_what_nothing_decides_and_says_so():
    start = {"flight.x": 3.0, "flight.y": -2.0, "flight.z": -0.02, "flight.x rate": 5.0}
    start |= jn.mechanics.orientation("flight", Z, "30 deg")
    run = jn.simulate_mechanism(car(), 0.5, start=start, at_rest=True, output_step=0.1)
    (finding,) = run.attrs["findings"]
    assert "flight.y, flight.wz: nothing decides where it rests" in finding
    assert float(run["car.yaw"][0]) == pytest.approx(np.radians(30.0), abs=1e-9)
    assert float(run["flight.y"][0]) == pytest.approx(-2.0, abs=1e-12)
    np.testing.assert_allclose(run["flight.x"], 3.0 + 5.0 * run["time"], rtol=0.0, atol=1e-6)
    weight = 400.0 * 9.81  # 0.1 m ahead of the middle, and 0.5 m above the feet, so it leans forward itself
    pitch = 0.1 * weight / (4.0 * 20e3 - 0.5 * weight)
    np.testing.assert_allclose(run["car.pitch"], pitch, rtol=0.0, atol=1e-6)
    np.testing.assert_allclose(run["car.vz"], 0.0, rtol=0.0, atol=1e-6)


def test_what_nothing_holds_is_named():
    mechanism = jn.mechanics.Mechanism()
    mechanism.prismatic("fall", mechanism.ground, mechanism.body("block", 1.0, ORIGIN), axis=Z)
    with pytest.raises(jn.SimulationError, match=r"fall\.distance: no static equilibrium was found"):
        jn.simulate_mechanism(mechanism, 0.1, at_rest=True)


def test_a_tolerance_that_rounding_forbids_is_found_and_said():
    """A spring of 40 N/m that is 100 km long: its length, and so its force, is known to some 1e-10 only."""
    mechanism = jn.mechanics.Mechanism(gravity=0.0)
    block = mechanism.body("block", 1.0, ORIGIN)
    mechanism.prismatic("slide", mechanism.ground, block, axis=X)
    mechanism.spring_damper("spring", mechanism.ground, block, (-1e5, 0.0, 0.0), ORIGIN, stiffness=40.0)
    mechanism.watch_coordinates()
    given = {"start": {"slide.distance": 0.1}, "output_step": 0.1, "method": "explicit"}
    fine = jn.simulate_mechanism(mechanism, 2.0, **given, tolerance=1e-8)
    assert not fine.attrs["findings"]
    run = jn.simulate_mechanism(mechanism, 2.0, **given, tolerance=1e-10)
    assert run.attrs["steps"] > 10 * fine.attrs["steps"]
    (finding,) = run.attrs["findings"]
    assert "tolerance: 1e-10 is below what rounding allows here" in finding
    attainable = float(finding.split("steps; ")[1].split(" is as exact")[0])
    again = jn.simulate_mechanism(mechanism, 2.0, **given, tolerance=attainable)
    assert again.attrs["steps"] < 0.1 * run.attrs["steps"]
    exact = 0.1 * np.cos(np.sqrt(40.0) * run["time"])
    for one in (run, again):
        np.testing.assert_allclose(one["slide.distance"], exact, rtol=0.0, atol=1e-7)


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
        run = jn.simulate_mechanism(mechanism, duration, start={"main.angle rate": -3.0}, output_step=0.01)
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
    run = jn.simulate_mechanism(mechanism, 0.1, start={"pivot.angle": angle}, at_rest=True, output_step=0.05)
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
    assert any("slide.distance: nothing decides where it rests" in text for text in run.attrs["findings"])


def test_a_speed_that_is_given_leaves_its_coordinate_and_may_leave_no_equilibrium():
    with pytest.raises(jn.SimulationError, match="no static equilibrium was found"):
        jn.simulate_mechanism(
            four_bar_on_a_slide(), 0.1, start={"crank.angle rate": 3.0}, at_rest=True, redundant="remove"
        )
