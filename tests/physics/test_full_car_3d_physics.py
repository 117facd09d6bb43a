"""Full car on four 3-D corners: balance, symmetry, load transfer, energy, convergence, one corner against the rig."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.design.lumping import lump
from jounce.parts.vehicles import FullCar
from jounce.simulation.compiled import compile_rig

CAR = jn.load("formula-student-car")
SEDAN = jn.load("sedan-full-car-3d")
CORNERS = CAR.corners
BOTH = pytest.mark.parametrize(  # another linkage in the same car: eight seconds to compile
    "vehicle",
    [
        pytest.param(CAR, id="formula-student"),
        pytest.param(SEDAN, id="sedan", marks=pytest.mark.slow),
    ],
)
BUMP = jn.HalfSine(height="15 mm", length="0.5 m", start="1 m")
LEVEL = jn.Flat()
SPEED = "10 m/s"


def mass_of(vehicle):
    """All masses of a vehicle, kg."""
    corners = [getattr(vehicle, end).corner for end in ("front", "rear")]
    return vehicle.body.mass + 2.0 * sum(
        body.mass for corner in corners for body in corner.body_masses().values()
    )


def centre_of(vehicle):
    """Height of the centre of gravity of everything at design, m."""
    total = vehicle.body.mass * vehicle.body.height
    for end in ("front", "rear"):
        bodies = getattr(vehicle, end).corner.body_masses().values()
        total += 2.0 * sum(body.mass * body.centre_of_mass[2] for body in bodies)
    return total / mass_of(vehicle)


def test_a_car_whose_front_wheels_hang_in_the_air_at_design_does_not_stand_on_its_nose():
    """Full steps of Newton's method tip it over; it comes down on its wheels, with the loads that their places ask."""
    ends = [f"{end}.corner.hardpoints.wheel_centre[2]" for end in ("front", "rear")]
    rest = jn.equilibrium(CAR.with_changes(dict(zip(ends, (0.236, 0.219), strict=True))))
    assert abs(rest["body.pitch"]) < 0.03
    front, rear = (
        rest[f"{end}_left.tyre.force"] + rest[f"{end}_right.tyre.force"]
        for end in ("front", "rear")
    )
    assert front + rear == pytest.approx(mass_of(CAR) * CAR.gravity, rel=1e-9)
    level = jn.equilibrium(CAR)
    assert front == pytest.approx(2.0 * level["front_left.tyre.force"], rel=0.02)


def forces(run, at=-1):
    return {corner: float(run[f"{corner}.tyre.force"][at]) for corner in CORNERS}


def held(vehicle, **loads):
    """The vehicle at rest under constant loads."""
    run = jn.simulate(vehicle, jn.Trial(road=LEVEL, speed=SPEED, duration="20 ms", **loads))
    assert abs(float(run["body.az"][-1])) < 1e-6
    return run


@BOTH
def test_the_tyres_carry_the_weight(vehicle):
    rest = jn.equilibrium(vehicle)
    carried = sum(rest[f"{corner}.tyre.force"] for corner in CORNERS)
    assert carried == pytest.approx(mass_of(vehicle) * vehicle.gravity, rel=1e-9)
    assert rest["body.roll"] == pytest.approx(0.0, abs=1e-12)


@pytest.mark.slow
@BOTH
def test_a_road_that_is_alike_on_both_sides_does_not_roll_the_car(vehicle):
    run = jn.simulate(vehicle, jn.Trial(road=BUMP, speed=SPEED, duration="0.8 s"))
    assert np.max(np.abs(run["body.pitch"] - run["body.pitch"][0])) > 1e-3
    assert np.max(np.abs(run["body.roll"])) < 1e-9
    for end in ("front", "rear"):
        left, right = (run[f"{end}_{side}.tyre.force"] for side in ("left", "right"))
        assert np.max(np.abs(left - right)) < 1e-6 * float(left.max())


@BOTH
def test_mirrored_roads_mirror_the_roll(vehicle):
    left = jn.simulate(
        vehicle, jn.Trial(road=BUMP, right=LEVEL, speed=SPEED, duration="0.8 s"), tolerance=1e-7
    )
    right = jn.simulate(
        vehicle, jn.Trial(road=LEVEL, right=BUMP, speed=SPEED, duration="0.8 s"), tolerance=1e-7
    )
    assert np.max(np.abs(left["body.roll"])) > 3e-3
    assert np.max(np.abs(left["body.roll"] + right["body.roll"])) < 1e-7
    assert np.max(np.abs(left["body.pitch"] - right["body.pitch"])) < 1e-7
    for end in ("front", "rear"):
        one, other = left[f"{end}_left.unsprung.z"], right[f"{end}_right.unsprung.z"]
        assert np.max(np.abs(one - other)) < 1e-7
        one, other = left[f"{end}_left.wheel.steer"], right[f"{end}_right.wheel.steer"]
        assert np.max(np.abs(one + other)) < 1e-6  # about +z, so of opposite sign


def test_deceleration_moves_load_to_the_front():
    """m a h / L with the height at rest; the body's own pitch moves its centre by less than the tolerance."""
    rate = 8.0
    still, run = forces(held(CAR)), held(CAR, deceleration={"value": rate})
    loaded = forces(run)
    moved = sum(loaded[corner] - still[corner] for corner in CORNERS if corner.startswith("front"))
    height = centre_of(CAR) + float(run["body.z"][-1])
    assert moved == pytest.approx(mass_of(CAR) * rate * height / CAR.wheelbase, rel=0.01)
    assert sum(loaded.values()) == pytest.approx(sum(still.values()), rel=1e-9)
    assert float(run["body.pitch"][-1]) > 1e-3


def test_lateral_acceleration_moves_load_to_the_outside():
    """m a h / t with the height of the centre in the car as it stands and half the track on either side."""
    rate = 9.0  # to the left: the car rolls to the right
    still, run = forces(held(CAR)), held(CAR, lateral_acceleration={"value": rate})
    loaded, roll = forces(run), float(run["body.roll"][-1])
    moved = sum(loaded[corner] - still[corner] for corner in CORNERS if corner.endswith("right"))
    track = 2.0 * CAR.front.corner.hardpoints.wheel_centre[1]
    height = centre_of(CAR) + float(run["body.z"][-1])
    shifted = (
        CAR.body.mass * CAR.gravity * height * roll / track
    )  # the body's weight moves outwards, too
    assert roll > 0.0
    assert moved == pytest.approx(mass_of(CAR) * rate * height / track + shifted, rel=0.03)
    assert moved > mass_of(CAR) * rate * centre_of(CAR) / track * 0.98


def test_pitch_moment_and_deceleration_share_their_sign():
    moment = {"value": 300.0}
    run, still = held(CAR, pitch_moment=moment), held(CAR)
    moved = sum(
        forces(run)[corner] - forces(still)[corner] for corner in ("front_left", "front_right")
    )
    assert moved == pytest.approx(300.0 / CAR.wheelbase, rel=0.01)


def test_the_anti_roll_bar_holds_the_body_and_loads_its_axle():
    load = {"value": 9.0}
    found = {}
    for rate in (0.0, 6e3, 2e4):
        run = held(CAR.with_changes({"front.anti_roll_bar_rate": rate}), lateral_acceleration=load)
        by = forces(run)
        found[rate] = float(run["body.roll"][-1]), by["front_right"] - by["front_left"]
    rolls, transfers = zip(*found.values(), strict=True)
    assert rolls[0] > rolls[1] > rolls[2] > 0.0
    assert transfers[0] < transfers[1] < transfers[2]


def test_a_bar_of_both_axles_does_nothing_on_an_even_road():
    bars = {"front.anti_roll_bar_rate": 0.0, "rear.anti_roll_bar_rate": 0.0}
    trial = jn.Trial(road=BUMP, speed=SPEED, duration="0.5 s")
    one, other = jn.simulate(CAR, trial), jn.simulate(CAR.with_changes(bars), trial)
    assert np.max(np.abs(one["body.z"] - other["body.z"])) < 1e-9


@pytest.mark.parametrize("corner", ["front_left", "rear_right"])
def test_a_corner_under_a_body_that_is_held_is_the_single_corner(corner):
    """A body without motion and too heavy to move: the corner's accelerations are those of the rig on a fixed body."""
    heavy = CAR.with_changes(
        {"body.mass": 1e15, "body.pitch_inertia": 1e15, "body.roll_inertia": 1e15}
    )
    own = dict.fromkeys(("front.anti_roll_bar_rate", "rear.anti_roll_bar_rate", "gravity"), 0.0)
    heavy = heavy.with_changes(own)
    alone = {"guide": "fixed", "gravity": 0.0, "tyre.law": "radial"}  # as the tyres of cars are
    rig = getattr(CAR, corner.split("_")[0]).corner.with_changes(alone)
    rig = rig if corner.endswith("left") else rig.mirrored()
    whole, single = compile_rig(heavy), compile_rig(rig)
    random = np.random.default_rng(1)
    x = np.zeros(single.state_count)
    x[: len(single.facts.coordinates)] = single.facts.start
    x += 0.03 * random.normal(size=len(x))
    names = [f"{corner}.{name}" for name in single.facts.states]
    states = np.zeros(whole.state_count)
    states[: len(whole.facts.coordinates)] = whole.facts.start
    places = [whole.facts.states.index(name) for name in names]
    p, q = single.parameter_values(rig.parameters()), whole.parameter_values(heavy.parameters())
    modes = np.ones(len(single.facts.switches))
    for _ in range(5):
        x = single.project(x, single.inputs(0.0), p, modes)
    states[places] = x
    wanted = single.evaluate("rate", x, single.inputs(0.0), p, modes)
    found = whole.evaluate("rate", states, whole.inputs(0.0), q, np.ones(len(whole.facts.switches)))
    assert np.max(np.abs(found[places] - wanted)) < 1e-8 * np.max(np.abs(wanted))


def lumped(vehicle):
    """The 7-degree-of-freedom car that the corners amount to about rest, each on its quarter of the body."""
    table = {"schema": "jounce.vehicle/1", "model": "full-car"}
    body = vehicle.body
    mass, pitch, roll = body.mass, body.pitch_inertia, body.roll_inertia
    for end in ("front", "rear"):
        axle = getattr(vehicle, end)
        found = lump(axle.corner.with_changes({"sprung.mass": body.mass / 4.0}))
        half, unsprung = axle.corner.hardpoints.wheel_centre[1], found.static_masses[1]
        for name, part in axle.corner.body_masses().items():
            carried, y = 2.0 * found.shares[name].sprung_mass, part.centre_of_mass[1]
            mass, pitch, roll = (
                mass + carried,
                pitch + carried * axle.distance**2,
                roll + carried * y**2,
            )
        table[end] = {
            "distance": axle.distance,
            "unsprung_mass": unsprung + found.inertance,
            "spring_rate": found.wheel_rate,
            "damping_coefficient": found.wheel_damping,
            "track": 2.0 * half,
            "anti_roll_bar_rate": axle.anti_roll_bar_rate,
            "tyre": {"stiffness": found.tyre_stiffness},
        }
    table["body"] = {"mass": mass, "pitch_inertia": pitch, "roll_inertia": roll}
    return FullCar.from_table(table)


def test_modes_are_those_of_the_lumped_car():
    """Heave, pitch and roll within 3 %, wheel hops within 6 %.

    The rest is what the lumped car leaves out: what turning and sideways motion of the suspension's bodies take
    (an inertance, here counted to the wheel), and that wheels move sideways and forwards under a body that turns.
    """
    spatial, flat = ([mode.frequency_hz for mode in jn.modes(car)] for car in (CAR, lumped(CAR)))
    assert len(spatial) == len(flat) == 7
    assert np.allclose(spatial[:3], flat[:3], rtol=0.03)
    assert np.allclose(spatial[3:], flat[3:], rtol=0.06)


def test_results_converge_with_the_tolerance():
    trial = jn.Trial(road=BUMP, right=LEVEL, speed=SPEED, duration="0.6 s")
    exact = jn.simulate(CAR, trial, tolerance=1e-11)
    errors = []
    for tolerance in (1e-3, 1e-5, 1e-7):
        run = jn.simulate(CAR, trial, tolerance=tolerance)
        channels = [
            name for name in run if name.endswith((".z", ".pitch", ".roll")) and "road" not in name
        ]
        each = [
            np.abs(run[name] - exact[name]).max() / np.ptp(exact[name].to_numpy())
            for name in channels
        ]
        errors.append(max(map(float, each)))
    assert errors[0] < 1e-3
    assert errors[1] < 1e-5
    assert errors[2] < 1e-7
    assert errors[0] > errors[1] > errors[2]


@pytest.mark.slow
def test_a_joint_at_the_centre_of_gravity_is_the_free_body():
    """The spherical joint lets the body yaw as well, which nothing on an even road makes it do."""
    trial = jn.Trial(road=BUMP, speed=SPEED, duration="0.6 s")
    free = jn.load("kart-whole-vehicle").with_changes({"body.joint": None})
    jointed = free.with_changes({"body.joint": [0.0, 0.0, free.body.height]})
    one, other = (jn.simulate(vehicle, trial, tolerance=1e-7) for vehicle in (free, jointed))
    for name in ("body.z", "body.pitch", "front_left.unsprung.z", "rear_right.unsprung.z"):
        assert np.max(np.abs(one[name] - other[name])) < 1e-7, name


def test_a_joint_leaves_out_the_mode_of_yaw():
    frequencies = [mode.frequency_hz for mode in jn.modes(jn.load("kart-whole-vehicle"))]
    assert len(frequencies) == 7
    assert 4.5 < frequencies[0] < 5.5  # heave, near the quarter vehicle's 5.07 Hz
