"""Energy, symmetry and agreement of rigs on testers."""

from __future__ import annotations

import numpy as np
import pytest

from jounce.core.segments import Segments
from jounce.mechanics.motions import constant, constant_rate
from jounce.parts import QuarterCar, load
from jounce.parts.testers import Motor, load_tester
from jounce.parts.vehicles import axle_from, axle_of
from jounce.testers.periodic import periodic, steady_sweep
from jounce.testers.plate_response import closed_form_adhesion, steady_response, wheel_mode
from jounce.testers.programme import run_programme
from jounce.testers.rig import rig_on_tester
from jounce.testers.testing import simulate_test

EUSAMA, THETA, BOGE = (load_tester(name) for name in ("eusama", "theta-msd3000", "boge"))


def car(damping=1000.0, **changes):
    rig = QuarterCar.from_table(
        {
            "sprung": {"mass": 400.0},
            "unsprung": {"mass": 40.0},
            "strut": {"spring": {"rate": 25e3}, "damper": {"coefficient": float(damping)}},
            "tyre": {"stiffness": 200e3, "damping_coefficient": 150.0},
        }
    )
    return rig.with_changes(changes)


FRICTION = {"strut.friction.force": 120.0, "strut.friction.regularisation_velocity": 0.005}


@pytest.mark.parametrize(
    "tester", [EUSAMA, THETA.with_changes({"plate_damping_coefficient": 200.0})]
)
@pytest.mark.parametrize(
    ("rig", "frequency", "lifts"),
    [(car(), 7.0, False), (car(1000.0, **FRICTION), 12.0, False), (car(200.0), 12.0, True)],
)
def test_the_drive_gives_what_the_dampers_take(tester, rig, frequency, lifts):
    on = rig_on_tester(rig, tester)
    found = periodic(on, frequency, tolerance=1e-8)
    values = found.values
    assert found.settled
    assert (found.force_min == 0.0) == (lifts and tester is EUSAMA)
    suspension = (
        values["strut.force"] * values["strut.velocity"]
    )  # springs give back what they take in a turn
    tyre = values["tyre.force"] * (values["plate.vz"] - values["unsprung.vz"])
    lift_rate = (
        np.gradient(values["excenter.z"], edge_order=2) * 512 * frequency - values["plate.vz"]
    )
    plate = (tester.plate_damping_coefficient or 0.0) * lift_rate**2
    taken = np.mean(suspension + tyre + plate)
    assert taken > 1.0
    turning = 2.0 * np.pi * frequency
    assert np.mean(values["excenter.torque"]) * turning == pytest.approx(taken, rel=2e-4)
    assert np.mean(values["excenter.power"]) == pytest.approx(taken, rel=2e-4)


@pytest.mark.parametrize("kind", ["rigid", "sprung"])
def test_energy_of_a_free_run_down(kind):
    """What the drive's inertia loses is in the dampers, the drive's friction, and what still moves."""
    tester = BOGE if kind == "sprung" else EUSAMA.model_copy(update={"drive": BOGE.drive})
    rig = car(600.0)
    on = rig_on_tester(rig, tester, ("",))
    # angle 0 at mean height: where a driven test would be after its hold
    driven = rig_on_tester(rig, tester)
    begin = driven.run(
        {"": constant_rate(2.0 * np.pi * 16.0)},
        np.linspace(0.0, 1.0, 3),
        fastest=100.0,
        tolerance=1e-8,
    )
    start = dict(zip(driven.compiled.facts.states, begin.states[:, -1], strict=True))
    start |= {"excenter.angle": 0.0, "excenter.angle rate": 2.0 * np.pi * 16.0}
    times = np.arange(0.0, 6.0, 2e-4)
    run = on.run({"": constant(0.0)}, times, start=start, fastest=110.0, tolerance=1e-9)
    v = dict(zip(on.compiled.output_names, run.outputs, strict=True))
    x = dict(zip(on.compiled.facts.states, run.states, strict=True))
    inertia, g, amplitude = tester.drive.inertia, 9.81, tester.amplitude
    rate = x["excenter.angle rate"]
    stored = (
        0.5 * inertia * rate**2
        + 0.5 * 400.0 * v["sprung.vz"] ** 2
        + 0.5 * 40.0 * v["unsprung.vz"] ** 2
    )
    stored += 0.5 * tester.plate_mass * v["plate.vz"] ** 2
    stored += g * (
        400.0 * v["sprung.z"] + 40.0 * v["unsprung.z"] + tester.plate_mass * v["plate.z"]
    )
    stored += (
        0.5 * 25e3 * (v["unsprung.z"] - v["sprung.z"]) ** 2
        + 0.5 * 200e3 * v["tyre.deflection"] ** 2
    )
    if kind == "sprung":
        stored += 0.5 * tester.plate_spring_rate * (v["excenter.z"] - v["plate.z"]) ** 2
    assert v["tyre.force"].min() > 0.0
    lost = (
        600.0 * v["strut.velocity"] ** 2
        + 150.0 * (v["plate.vz"] - v["unsprung.vz"]) ** 2
        + v["drive.torque"] * rate
    )
    work = np.concatenate([[0.0], np.cumsum(0.5 * (lost[1:] + lost[:-1]) * np.diff(times))])
    assert np.ptp(stored) > 300.0
    assert np.max(np.abs(stored + work - stored[0])) < 2e-3 * np.ptp(stored)
    assert np.allclose(v["excenter.z"], amplitude * np.sin(x["excenter.angle"]), atol=1e-12)
    assert rate[-1] < 0.8 * rate[0]


def test_a_free_run_down_passes_the_resonance():
    record = simulate_test(car(300.0), BOGE)
    moving = record["time"].values > BOGE.programme.hold_time
    height = np.abs(record["left.plate.z"].values[moving])
    turns = record["truth.left.excenter.frequency"].values[moving]
    assert turns[0] == pytest.approx(16.0, abs=0.2)
    assert turns[-1] < 3.0
    peak = turns[np.argmax(height)]
    mode = wheel_mode(car(300.0), BOGE, on="rig")
    assert (
        mode.frequency_hz - 3.0 < peak < mode.frequency_hz + 0.5
    )  # the drive hurries through the resonance
    assert height.max() > 2.0 * height[:1000].max()


def test_a_motor_brings_the_exciter_up_from_rest():
    drive = BOGE.drive.model_copy(
        update={"motor": Motor(stall_torque=40.0, no_load_frequency=20.0)}
    )
    programme = BOGE.programme.model_copy(update={"hold_time": 8.0, "duration": 2.0})
    tester = BOGE.model_copy(update={"drive": drive, "programme": programme})
    run = run_programme(car(1500.0), tester)
    turns = run.values["excenter.frequency"]
    assert abs(turns[0]) < 1e-9
    assert 15.0 < turns[8000] < 20.0  # friction keeps it below the no-load speed
    assert turns[-1] < turns[8000] - 0.5
    on = run.values["motor.torque"]
    assert np.allclose(on[:7999], 40.0 * (1.0 - turns[:7999] / 20.0), atol=1e-9)
    assert np.all(on[8001:] == 0.0)


def test_cell_under_the_plate_feels_its_inertia():
    contact = simulate_test(car(), EUSAMA.with_changes({"force_cell": "contact"}))
    under = simulate_test(car(), EUSAMA)
    inertia = EUSAMA.plate_mass * under["truth.left.plate.az"].values
    assert np.allclose(under["left.plate.force"] - contact["left.plate.force"], inertia, atol=1e-6)
    assert np.abs(inertia).max() == pytest.approx(20.0 * 0.003 * (2 * np.pi * 25.0) ** 2, rel=1e-3)


def test_a_sprung_plate_stands_on_its_spring():
    """Spring force = contact force and what moves and weighs the plate."""
    run = run_programme(car(), THETA).values
    spring = THETA.plate_spring_rate * (run["excenter.z"] - run["plate.z"])
    assert np.allclose(spring, run["plate.force"] + 9.81 * THETA.plate_mass, atol=1e-6)


def test_sides_that_do_not_feel_each_other_are_quarter_cars():
    """With the roll inertia of masses over the wheels each side is a quarter car."""
    left, right = car(900.0), car(400.0)
    axle = axle_from(left, right, track=1.5, roll_inertia=2.0 * 400.0 * 0.75**2)
    tester = EUSAMA.with_changes({"programme.sweep_rate": "5 Hz/s"})
    both = simulate_test(axle, tester)
    alone = {side: simulate_test(rig, tester) for side, rig in (("left", left), ("right", right))}
    length = len(alone["left"]["time"])
    first = both["left.plate.force"].values[:length]
    assert np.allclose(first, alone["left"]["left.plate.force"], atol=0.5)
    later = round(1000 * (float(alone["left"]["time"][-1]) + tester.programme.pause))
    second = both["right.plate.force"].values[later:]
    assert len(second) == length
    assert np.allclose(second, alone["right"]["left.plate.force"], atol=0.5)


def test_the_other_side_is_felt_through_the_body():
    axle = axle_of(load("audi-a6-full-car"), "front")
    record = simulate_test(axle, EUSAMA, wheel="left")
    other = record["right.plate.force"].values - record.attrs["right.static_load"]
    own = record["left.plate.force"].values - record.attrs["left.static_load"]
    assert np.ptp(record["right.plate.z"].values) == 0.0
    assert 0.005 < np.ptp(other) / np.ptp(own) < 0.3
    together = simulate_test(axle, EUSAMA, other="excited")
    assert np.allclose(together["left.plate.force"], together["right.plate.force"], atol=1e-4)
    assert together.attrs["wheel_order"] == "together"


def test_the_sides_of_an_axle_mirror_each_other():
    axle = axle_from(car(900.0), car(900.0))
    left, right = (simulate_test(axle, EUSAMA, wheel=side) for side in ("left", "right"))
    assert np.allclose(left["left.plate.force"], right["right.plate.force"], atol=1e-3)
    assert np.allclose(left["truth.body.roll"], -right["truth.body.roll"], atol=1e-9)


def test_a_3d_corner_is_near_its_lumped_twin():
    corner = load("reference-double-wishbone")
    found, lumped = steady_sweep(corner, EUSAMA), closed_form_adhesion(corner, EUSAMA)
    assert found.adhesion == pytest.approx(lumped[0], abs=5e-4)
    assert found.adhesion_frequency == pytest.approx(lumped[1], abs=0.05)


def test_lift_off_is_in_the_steady_states():
    found = steady_sweep(car(150.0), EUSAMA)
    assert (found.adhesion, found.lift_off) == (0.0, True)
    assert closed_form_adhesion(car(150.0), EUSAMA)[0] == pytest.approx(-0.2277, abs=0.005)
    far = periodic(rig_on_tester(car(150.0), EUSAMA), 22.0)
    closed = steady_response(car(150.0), EUSAMA, [22.0])
    load_ = 440.0 * 9.81
    assert far.force_min / load_ == pytest.approx(float(closed.adhesion[0]), abs=1e-4)
    assert far.phase_angle == pytest.approx(float(closed.phase_angle[0]), abs=1e-4)


def test_friction_makes_a_worn_damper_look_better():
    worn, rubbing = (steady_sweep(rig, EUSAMA) for rig in (car(400.0), car(400.0, **FRICTION)))
    assert rubbing.adhesion > worn.adhesion + 0.02


def test_bump_stops_are_hit():
    stop = {"strut.bump_stop.gap": 0.16, "strut.bump_stop.rate": 4e5}
    found = periodic(rig_on_tester(car(500.0, **stop), EUSAMA), 11.5)
    deflection = found.values["strut.deflection"]
    stop_force = (
        found.values["strut.force"] - 25e3 * deflection - 500.0 * found.values["strut.velocity"]
    )
    assert np.allclose(stop_force, 4e5 * np.maximum(deflection - 0.16, 0.0), atol=1e-6)
    assert stop_force.max() > 100.0
    assert abs(found.force_max - periodic(rig_on_tester(car(500.0), EUSAMA), 11.5).force_max) > 50.0


def test_frequency_is_exactly_linear_in_time():
    """Zero crossings of the plate are those of the exact chirp."""
    tester = EUSAMA.with_changes({"sampling_frequency": 8000.0})
    record = simulate_test(car(), tester, truth=False)
    time, height = record["time"].values, record["left.plate.z"].values
    i = np.flatnonzero((height[:-1] < 0.0) & (height[1:] >= 0.0))
    at = time[i] - height[i] / (height[i + 1] - height[i]) * (time[i + 1] - time[i])
    turned = 25.0 * at - 0.5 * 2.5 * np.maximum(at - 1.5, 0.0) ** 2
    assert np.max(np.abs(turned - np.round(turned))[:-1]) < 2e-4


def test_results_do_not_depend_on_the_tolerance():
    on = rig_on_tester(car(150.0), EUSAMA)
    turns = Segments(
        np.array([0.0, 9.0]), np.zeros(1, np.int64), np.array([[0.0, 150.0, -7.0, 0.0]])
    )
    times = np.linspace(0.0, 9.0, 901)
    row = on.compiled.output_names.index("tyre.force")
    coarse, fine = (
        on.run({"": turns}, times, fastest=150.0, tolerance=t).outputs[row] for t in (1e-5, 1e-9)
    )
    assert np.max(np.abs(coarse - fine)) < 1e-3 * 4316.4
