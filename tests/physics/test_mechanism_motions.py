"""Prescribed motions, couplers, slots and springs against closed forms; what happens at the end of a travel."""

from __future__ import annotations

from functools import cache

import casadi
import numpy as np
import pytest

import jounce as jn

X, Y, Z, ORIGIN = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (0.0, 0.0, 0.0)


@cache
def shaker() -> jn.mechanics.Mechanism:
    """A mass moved up and down by force, beside one whose support moves by itself, and a third hung on springs."""
    mechanism = jn.mechanics.Mechanism()
    track = mechanism.track("table")
    forced = mechanism.body("forced", 3.0, ORIGIN, (0.1, 0.1, 0.1))
    height = mechanism.prismatic("guide", mechanism.ground, forced, axis=Z)
    mechanism.output(
        "drive.force", mechanism.motion("drive", height, track), "N", "force of the drive"
    )
    carried = mechanism.body("carried", 3.0, ORIGIN, (0.1, 0.1, 0.1))
    mechanism.driven("table", mechanism.ground, carried, axis=Z, travel=track)
    rider = mechanism.body("rider", 2.0, (1.0, 0.0, 0.5), (0.1, 0.1, 0.1))
    mechanism.prismatic("rail", carried, rider, axis=Z, at=(1.0, 0.0, 0.5))
    mechanism.spring_damper(
        "spring",
        carried,
        rider,
        (1.0, 0.0, 0.0),
        (1.0, 0.0, 0.5),
        stiffness="2 N/mm",
        damping=8.0,
        free_length=0.52,
    )
    for body in (forced, carried, rider):
        mechanism.watch_body(body)
    mechanism.watch_coordinates()
    mechanism.watch_energy()
    for joint in ("guide", "table", "rail"):
        mechanism.watch_reaction(joint)
    return mechanism


def test_shaken_masses_take_mass_times_acceleration():
    amplitude, frequency = 0.02, 3.0
    motion = jn.mechanics.harmonic(amplitude, frequency, phase=0.4, mean=0.01)
    run = jn.simulate_mechanism(
        shaker(), 1.0, motions={"table": motion}, output_step=0.01, tolerance=1e-9
    )
    w = 2.0 * np.pi * frequency
    swing = np.sin(w * run["time"].values + 0.4)
    np.testing.assert_allclose(run["forced.z"], 0.01 + amplitude * swing, rtol=0.0, atol=1e-12)
    np.testing.assert_allclose(run["carried.az"], -amplitude * w**2 * swing, rtol=0.0, atol=1e-9)
    np.testing.assert_allclose(
        run["drive.force"], 3.0 * (9.81 - amplitude * w**2 * swing), rtol=0.0, atol=1e-8
    )
    np.testing.assert_allclose(run["guide.fz"], run["drive.force"], rtol=0.0, atol=1e-9)
    together = 3.0 * (run["carried.az"] + 9.81) + 2.0 * (run["rider.az"] + 9.81)
    np.testing.assert_allclose(run["table.fz"], together, rtol=0.0, atol=1e-8)
    spring = 2000.0 * (0.02 - run["rail.distance"]) - 8.0 * run["rail.distance rate"]
    np.testing.assert_allclose(2.0 * (run["rider.az"] + 9.81), spring, rtol=0.0, atol=1e-8)


def test_step_moves_and_stops():
    motion = jn.mechanics.step(0.0, 0.1, begin=0.2, stop=0.7)
    run = jn.simulate_mechanism(
        shaker(), 1.0, motions={"table": motion}, output_step=0.01, tolerance=1e-9
    )
    assert float(abs(run["forced.z"][:21]).max()) < 1e-12
    np.testing.assert_allclose(run["forced.z"][70:], 0.1, rtol=0.0, atol=1e-12)
    np.testing.assert_allclose(run["forced.vz"][45], 1.5 * 0.1 / 0.5, rtol=1e-9)
    np.testing.assert_allclose(run["drive.force"][75:], 3.0 * 9.81, rtol=1e-12)


@cache
def gearing() -> jn.mechanics.Mechanism:
    """A rack that a pinion carries, a screw in its nut, and a pair of gears, each falling on its own."""
    mechanism = jn.mechanics.Mechanism()
    rack = mechanism.body("rack", 2.0, ORIGIN, (0.1, 0.1, 0.1))
    pinion = mechanism.body("pinion", 1.0, ORIGIN, (0.1, 0.004, 0.1))
    slid = mechanism.prismatic("slide", mechanism.ground, rack, axis=Z)
    rolled = mechanism.revolute("roll", mechanism.ground, pinion, at=ORIGIN, axis=Y)
    force = mechanism.coupler("teeth", slid - 0.05 * rolled)
    mechanism.output("teeth.force", force, "N", "force of the teeth on the rack")
    screw = mechanism.body("screw", 1.5, ORIGIN, (0.1, 0.1, 3e-5))
    along, turn = casadi.vertsplit(
        mechanism.cylindrical("nut", mechanism.ground, screw, at=ORIGIN, axis=Z)
    )
    mechanism.coupler("thread", along - 0.02 / (2.0 * np.pi) * turn)
    small = mechanism.body("small", 1.0, (0.0, 0.0, 0.1), (0.1, 0.002, 0.1))
    large = mechanism.body("large", 1.0, (0.3, 0.0, 0.0), (0.1, 0.030, 0.1))
    fast = mechanism.revolute("small bearing", mechanism.ground, small, at=ORIGIN, axis=Y)
    slow = mechanism.revolute("large bearing", large, mechanism.ground, at=(0.3, 0.0, 0.0), axis=Y)
    mechanism.coupler(
        "mesh", fast - 3.0 * slow
    )  # outer teeth: the second joint counts the other way round
    mechanism.watch_coordinates()
    mechanism.watch_energy()
    return mechanism


def test_rack_screw_and_gears_fall_with_the_inertia_they_turn():
    run = jn.simulate_mechanism(gearing(), 0.5, output_step=0.01, tolerance=1e-9)
    time = run["time"].values
    rack = 9.81 * 2.0 / (2.0 + 0.004 / 0.05**2)
    np.testing.assert_allclose(run["slide.distance"], -0.5 * rack * time**2, rtol=0.0, atol=1e-9)
    np.testing.assert_allclose(
        run["roll.angle"], run["slide.distance"] / 0.05, rtol=0.0, atol=1e-12
    )
    np.testing.assert_allclose(run["teeth.force"], 2.0 * (9.81 - rack), rtol=1e-9)
    screw = 9.81 * 1.5 / (1.5 + 3e-5 * (2.0 * np.pi / 0.02) ** 2)
    np.testing.assert_allclose(run["nut.distance"], -0.5 * screw * time**2, rtol=0.0, atol=1e-9)
    np.testing.assert_allclose(
        run["nut.angle"], run["nut.distance"] * 2.0 * np.pi / 0.02, rtol=0.0, atol=1e-10
    )
    np.testing.assert_allclose(
        run["large bearing.angle"], run["small bearing.angle"] / 3.0, rtol=0.0, atol=1e-12
    )
    total = run["energy.kinetic"] + run["energy.weight"]
    assert float(abs(total).max()) < 1e-8 * float(run["energy.kinetic"].max())


@cache
def yoke() -> jn.mechanics.Mechanism:
    """Scotch yoke: a pin on a crank in the slot of a yoke; a wheel hangs on a torsion spring beside it."""
    mechanism = jn.mechanics.Mechanism()
    crank = mechanism.body("crank", 1.0, ORIGIN, (0.01, 0.01, 0.01))
    slide = mechanism.body("yoke", 2.0, (0.1, 0.0, 0.0), (0.01, 0.01, 0.01))
    mechanism.revolute("main", mechanism.ground, crank, at=ORIGIN, axis=(0.0, -1.0, 0.0))
    mechanism.prismatic("guide", mechanism.ground, slide, axis=X, at=(0.1, 0.0, 0.0))
    mechanism.point_on_line("slot", slide, crank, at=(0.1, 0.0, 0.0), axis=Z, point=(0.1, 0.0, 0.0))
    wheel = mechanism.body("wheel", 1.0, ORIGIN, (0.03, 0.03, 0.05))
    mechanism.revolute("shaft", mechanism.ground, wheel, at=ORIGIN, axis=Z)
    mechanism.rotational_spring_damper(
        "torsion", "shaft", stiffness=5.0, damping=0.05, free_angle=0.2
    )
    mechanism.watch_body(slide)
    mechanism.watch_coordinates()
    mechanism.watch_energy()
    mechanism.watch_reaction("slot")
    mechanism.watch_reaction("shaft")
    return mechanism


def yoke_run():
    start = {"main.angle rate": 8.0, "shaft.angle": 1.0}
    return jn.simulate_mechanism(
        yoke(), 2.0, start=start, redundant="remove", output_step=0.01, tolerance=1e-9
    )


def test_yoke_slides_by_the_cosine_of_its_crank():
    run = yoke_run()
    np.testing.assert_allclose(run["yoke.x"], 0.1 * np.cos(run["main.angle"]), rtol=0.0, atol=1e-12)
    np.testing.assert_allclose(run["slot.fx"], -2.0 * run["yoke.ax"], rtol=0.0, atol=1e-8)
    speed = np.sqrt(0.01 / (0.01 + 0.02 * np.sin(run["main.angle"]) ** 2)) * 8.0
    np.testing.assert_allclose(run["main.angle rate"], speed, rtol=1e-7)
    assert float(abs(run["slot.fz"]).max()) < 1e-9


def test_torsion_spring_swings_and_loses_energy_as_its_damper_says():
    run = yoke_run()
    time = run["time"].values
    decay, w0 = 0.05 / (2.0 * 0.05), np.sqrt(5.0 / 0.05)
    w = np.sqrt(w0**2 - decay**2)
    angle = 0.2 + 0.8 * np.exp(-decay * time) * (np.cos(w * time) + decay / w * np.sin(w * time))
    np.testing.assert_allclose(run["shaft.angle"], angle, rtol=0.0, atol=1e-7)
    total = (
        run["energy.kinetic"]
        + run["energy.weight"]
        + run["energy.elastic"]
        + run["energy.dissipated"]
    )
    np.testing.assert_allclose(total, total[0], rtol=1e-8)
    assert float(run["energy.dissipated"][-1]) > 0.5
    assert float(abs(run["shaft.tz"]).max()) < 1e-9  # the spring is not the joint


@cache
def limited() -> jn.mechanics.Mechanism:
    """A four-bar chain without a full turn (Grashof's inequality fails): bars 0.5, 0.6, 0.5, ground 1.2 m."""
    mechanism = jn.mechanics.Mechanism()
    height = np.sqrt(0.5**2 - 0.3**2)
    b, c = (0.3, 0.0, height), (0.9, 0.0, height)
    crank = mechanism.body("crank", 1.0, (0.15, 0.0, 0.5 * height), (0.02, 0.02, 0.02))
    coupler = mechanism.body("coupler", 1.0, (0.6, 0.0, height), (0.02, 0.03, 0.03))
    rocker = mechanism.body("rocker", 1.0, (1.05, 0.0, 0.5 * height), (0.02, 0.02, 0.02))
    turn = mechanism.revolute("A", mechanism.ground, crank, at=ORIGIN, axis=(0.0, -1.0, 0.0))
    mechanism.revolute("B", crank, coupler, at=b, axis=Y)
    mechanism.revolute("D", mechanism.ground, rocker, at=(1.2, 0.0, 0.0), axis=Y)
    mechanism.coincident("C", coupler, rocker, at=c)
    mechanism.motion("drive", turn, mechanism.track("angle"))
    mechanism.watch_coordinates()
    mechanism.watch_energy()
    return mechanism


def test_driven_chain_stops_at_the_end_of_its_travel():
    """Crank and ground reach 1.1 m at most (0.6 + 0.5) when coupler and rocker stretch."""
    drive = {"angle": jn.mechanics.constant_rate(1.0)}
    start = np.arccos(0.6)
    end = np.arccos((0.5**2 + 1.2**2 - 1.1**2) / (2.0 * 0.5 * 1.2)) - start
    mechanism = limited()
    run = jn.simulate_mechanism(
        mechanism, 2.0, motions=drive, redundant="remove", output_step=1e-3, check=False
    )
    assert run.attrs["status"] == "locked_up"
    assert float(run["time"][-1]) == pytest.approx(end, abs=2e-3)
    np.testing.assert_allclose(run["A.angle"], run["time"], rtol=0.0, atol=1e-7)
    with pytest.raises(jn.SimulationError, match=rf"stopped after.*{end:.2f}"):
        jn.simulate_mechanism(mechanism, 2.0, motions=drive, redundant="remove", output_step=1e-3)


@cache
def sled() -> jn.mechanics.Mechanism:
    """A sled between two stops with friction, beside a wheel that a brake holds back."""
    mechanism = jn.mechanics.Mechanism()
    sled = mechanism.body("sled", 2.0, ORIGIN, (0.1, 0.1, 0.1))
    place = mechanism.prismatic("rail", mechanism.ground, sled, axis=X)
    stops = mechanism.stop(
        "stops", place, lower="-100 mm", upper=0.2, stiffness="5 N/mm", damping=20.0
    )
    mechanism.output("stops.force", stops, "N", "force of the stops")
    mechanism.output(
        "drag.force", mechanism.friction("drag", place, 1.5), "N", "friction of the rail"
    )
    wheel = mechanism.body("wheel", 1.0, ORIGIN, (0.03, 0.03, 0.05))
    turn = mechanism.revolute("shaft", mechanism.ground, wheel, at=ORIGIN, axis=Y)
    mechanism.friction("brake", turn, "0.2 N*m", regularisation_rate=1e-3)
    mechanism.watch_coordinates()
    mechanism.watch_energy()
    return mechanism


def test_stops_and_friction_take_what_they_should():
    start = {"rail.distance rate": 4.0, "shaft.angle rate": 6.0}
    run = jn.simulate_mechanism(sled(), 1.0, start=start, output_step=1e-3, tolerance=1e-9)
    time, place, rate = (
        run["time"].values,
        run["rail.distance"].values,
        run["rail.distance rate"].values,
    )
    free = time < 0.04
    np.testing.assert_allclose(
        place[free], 4.0 * time[free] - 0.375 * time[free] ** 2, rtol=0.0, atol=1e-7
    )
    depth = np.maximum(place - 0.2, 0.0) - np.maximum(-0.1 - place, 0.0)
    pushed = np.where(depth == 0.0, 0.0, 5000.0 * depth + 20.0 * rate)
    pushed = np.where(np.sign(pushed) == np.sign(depth), pushed, 0.0)
    np.testing.assert_allclose(run["stops.force"], -pushed, rtol=0.0, atol=1e-6)
    assert float(place.max()) > 0.2
    assert float(place.min()) < -0.1
    total = (
        run["energy.kinetic"]
        + run["energy.weight"]
        + run["energy.elastic"]
        + run["energy.dissipated"]
    )
    np.testing.assert_allclose(total, total[0], rtol=1e-6)
    early, late = time < 0.89, time > 0.91  # the brake stops it after 6 * 0.03 / 0.2 s
    np.testing.assert_allclose(
        run["shaft.angle rate"][early], 6.0 - 0.2 / 0.03 * time[early], rtol=0.0, atol=1e-6
    )
    assert float(abs(run["shaft.angle rate"][late]).max()) < 1e-6


def test_stops_hold_a_weight_in_equilibrium():
    mechanism = jn.mechanics.Mechanism()
    block = mechanism.body("block", 2.0, ORIGIN, (0.1, 0.1, 0.1))
    mechanism.stop(
        "floor",
        mechanism.prismatic("fall", mechanism.ground, block, axis=Z),
        lower=-0.1,
        stiffness=1e4,
    )
    mechanism.watch_coordinates()
    run = jn.simulate_mechanism(
        mechanism, 0.2, start={"fall.distance": -0.11}, at_rest=True, output_step=0.1
    )
    np.testing.assert_allclose(run["fall.distance"], -0.1 - 2.0 * 9.81 / 1e4, rtol=0.0, atol=1e-12)
    with pytest.raises(jn.SimulationError, match="no static equilibrium was found"):
        jn.simulate_mechanism(mechanism, 0.2, at_rest=True)
