"""A car whose corners run as one coordinate each is the car run with its linkages.

The car with linkages has all their coordinates, loops and forces, and is projected after every step; the reduced one
has masses, places and lengths that were sampled over travel. The linkages are run at a tolerance a thousand times
tighter.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

import jounce as jn
from jounce.kernel.engine import Status
from jounce.simulation.problem import excitation
from jounce.simulation.reduced_car import PLACES, ReducedCar, car_reduction_of
from jounce.simulation.sampled import DEGREES
from jounce.simulation.settings import RunSettings

CAR = jn.load("formula-student-car")
TOLERANCE = 1e-5
SEED = 20261123
ENDS = ("front", "rear")
STOPS = {
    "bump_stop": {"gap": "12 mm", "rate": "80 N/mm"},
    "rebound_stop": {"gap": "15 mm", "rate": "80 N/mm"},
}
THIRD = {
    "third_spring": {"spring": {"rate": 30e3, "preload": 150.0}, "damper": {"coefficient": 800.0}},
    "hardpoints.third_spring_end": [0.02, 0.21, 0.42],
}
T_BAR = {
    "hardpoints.arb_pivot": [-0.10, 0.0, 0.30],
    "hardpoints.arb_axis": [-0.08, 0.0, 0.45],
    "hardpoints.arb_arm_end": [-0.08, 0.16, 0.45],
    "hardpoints.arb_link_end": [0.0, 0.20, 0.44],
    "anti_roll_bar": {"stiffness": 400.0, "on": "rocker", "kind": "t"},
}
U_BAR = {
    "hardpoints.arb_pivot": [-0.08, 0.15, 0.36],
    "hardpoints.arb_arm_end": [-0.15, 0.15, 0.44],
    "hardpoints.arb_link_end": [0.0, 0.22, 0.43],
    "anti_roll_bar": {"stiffness": 900.0, "on": "rocker"},
}


def of(end: str, changes: dict[str, object]) -> dict[str, object]:
    """Changes of a corner as those of the car."""
    return {f"{end}.corner.{path}": value for path, value in changes.items()}


def errors(reduced, full) -> dict[str, float]:
    """Largest difference of every channel over the range it sweeps, where it moves at all."""
    assert {name: reduced[name].attrs for name in reduced} == {
        name: full[name].attrs for name in full
    }
    ranges = {name: float(np.ptp(full[name].values)) for name in full}
    return {
        name: float(np.max(np.abs(reduced[name].values - full[name].values))) / size
        for name, size in ranges.items()
        if size > 1e-9
    }


def displacements(found: dict[str, float]) -> dict[str, float]:
    """Those of body and wheels."""
    return {
        name: each
        for name, each in found.items()
        if name.endswith(("unsprung.z", "body.z", ".pitch", ".roll"))
    }


def compare(car: jn.Vehicle, trial: jn.Trial) -> tuple[bool, float]:
    """Whether a run is reduced, and how far body and wheels are off, as shares of the tolerance."""
    reduced = jn.simulate(car, trial, tolerance=TOLERANCE)
    if not reduced.attrs["method"].startswith("reduced"):
        return False, 0.0
    full = jn.simulate(car, trial, tolerance=1e-3 * TOLERANCE, method="explicit")
    return True, max(displacements(errors(reduced, full)).values()) / TOLERANCE


def random_case(random: np.random.Generator, car: jn.Vehicle) -> tuple[jn.Vehicle, jn.Trial]:
    """Other hardpoints, masses and rates, racks that are held off the middle, over a rough road or obstacles."""
    changes: dict[str, object] = {}
    for path, value in car.parameters().items():
        point = path.partition("hardpoints.")[2]
        if point and not point.startswith(("wheel", "contact")) and "arb_" not in path:
            changes[path] = value + 0.002 * random.uniform(-1.0, 1.0)
        elif path.endswith((".mass", "spring.rate", "tyre.stiffness", "inertia", "body.height")):
            changes[path] = value * random.uniform(0.85, 1.15)
        elif path.endswith("rack_travel"):
            changes[path] = 0.01 * random.uniform(-1.0, 1.0)
    loads: dict[str, object] = {}
    for load, size in (
        ("deceleration", 8.0),
        ("lateral_acceleration", 6.0),
        ("pitch_moment", 300.0),
    ):
        if random.random() < 0.4:
            loads[load] = {"value": size * random.uniform(-1.0, 1.0), "start": "0.3 s"}
    if random.random() < 0.6:
        of_one = jn.HalfSine(
            height=random.uniform(0.005, 0.04), length=random.uniform(0.2, 1.5), start="1 m"
        )
        road: object = jn.Train(of=of_one, count=3, pitch="3 m")
        right: object = jn.Flat() if random.random() < 0.5 else None
    else:
        kind, number = str(random.choice(list("ABCD"))), int(random.integers(1000))
        road = jn.Iso8608(**{"class": kind}, length="40 m", seed=number)
        right = road.other_track()
    return car.with_changes(changes), jn.Trial(
        road=road, right=right, speed=random.uniform(4.0, 20.0), duration=1.5, **loads
    )


@pytest.fixture(scope="module")
def reduction():
    found = car_reduction_of(CAR)
    assert found is not None
    return found


@pytest.mark.slow
def test_random_cars_agree_within_the_tolerance():
    random = np.random.default_rng(SEED)
    found = [compare(*random_case(random, CAR)) for _ in range(3)]
    assert all(reduced for reduced, _ in found)
    assert max(share for _, share in found) < 1.0


@pytest.mark.slow
def test_sixty_random_cars_agree_within_the_tolerance():
    """Every suspension, bar and spring across the car; what cannot stand, or leaves the road, is no case."""
    elastic = {f"strut.{name}": stop for name, stop in STOPS.items()}
    bars = {f"{end}.anti_roll_bar_rate": 0.0 for end in ENDS}
    cars = [
        CAR,
        jn.load("sedan-full-car-3d"),
        CAR.with_changes(
            {
                **of(
                    "front",
                    {
                        **THIRD,
                        **U_BAR,
                        **elastic,
                        "tyre.law": "radial",
                        "steering.rack_travel": "4 mm",
                    },
                ),
                **of("rear", T_BAR),
                **bars,
            }
        ),
        CAR.with_changes({"body.joint": [0.05, 0.0, 0.35]}),
    ]
    random, found = np.random.default_rng(SEED), []
    while len(found) < 60:
        car, trial = random_case(random, cars[len(found) % len(cars)])
        try:
            found.append(compare(car, trial))
        except jn.JounceError:
            continue
    assert sum(reduced for reduced, _ in found) >= 50
    assert max(share for _, share in found) < 1.0


@pytest.mark.slow
def test_a_car_at_rest_gets_onto_an_obstacle():
    """A third damper pulls wheels that still stand: which way they begin to move is less than steps are exact to."""
    random, car = np.random.default_rng(SEED), CAR.with_changes(of("front", THIRD))
    for _ in range(30):
        start, speed, tolerance = (
            random.uniform(0.3, 3.0),
            random.uniform(3.0, 30.0),
            10.0 ** random.uniform(-6.0, -4.0),
        )
        road = jn.HalfSine(
            height=random.uniform(0.005, 0.03), length=random.uniform(0.1, 2.0), start=start
        )
        trial = jn.Trial(road=road, right=jn.Flat(), speed=speed, duration=start / speed + 0.05)
        varied = car.with_changes({"body.mass": car.body.mass * random.uniform(0.85, 1.15)})
        exact = jn.simulate(varied, trial, tolerance=1e-9, method="explicit")
        for method in ("auto", "explicit"):
            run = jn.simulate(varied, trial, tolerance=tolerance, method=method)
            moved = [name for name in exact if name.endswith(("unsprung.z", "body.z"))]
            size = max(float(np.ptp(exact[name].values)) for name in moved)
            assert (
                max(float(np.max(np.abs(run[name].values - exact[name].values))) for name in moved)
                < tolerance * size
            )


def test_every_channel_is_that_of_the_car_with_linkages():
    trial = jn.Trial(
        road=jn.HalfSine(height="20 mm", length="0.5 m", start="1 m"),
        right=jn.Flat(),
        speed=8.0,
        duration=0.5,
    )
    reduced = jn.simulate(CAR, trial, tolerance=1e-6)
    full = jn.simulate(CAR, trial, tolerance=1e-9, method="explicit")
    assert (reduced.attrs["method"], full.attrs["method"]) == ("reduced explicit", "explicit")
    found = errors(reduced, full)
    assert len(found) > 50
    assert max(displacements(found).values()) < 1e-6
    assert max(found.values()) < 1e-4  # accelerations and forces


@pytest.mark.parametrize(
    "options",
    [
        {"method": "explicit"},
        {"offset": {"sprung.distance": 0.001}},
        {"tolerance": 1e-8},
        {"output_step": 0.01},
    ],
    ids=["asked for", "from an offset", "tight tolerance", "far samples"],
)
def test_the_linkages_run_where_one_coordinate_does_not_do(options):
    trial = jn.Trial(road=jn.Flat(), speed=8.0, duration=0.01)
    assert jn.simulate(CAR, trial, **options).attrs["method"] == "explicit"


def test_wheels_that_travel_farther_than_any_table_are_run_by_their_linkages():
    trial = jn.Trial(
        road=jn.HalfSine(height="160 mm", length="1 m", start="1 m"),
        right=jn.Flat(),
        speed=10.0,
        duration=0.4,
    )
    run, full = jn.simulate(CAR, trial), jn.simulate(CAR, trial, method="explicit", tolerance=1e-8)
    assert run.attrs["method"] == "explicit"
    assert max(displacements(errors(run, full)).values()) < TOLERANCE


def test_a_run_ends_where_a_wheel_leaves_its_table(reduction):
    road = jn.HalfSine(height="60 mm", length="1 m", start="1 m")
    trial = jn.Trial(road=road, right=jn.Flat(), speed=8.0, duration=1.0)
    signals = excitation(reduction.compiled(DEGREES[0]).facts, CAR, trial)
    car = ReducedCar(reduction, CAR.parameters(), signals, RunSettings().times(1.0), 1e-3)
    narrow, wide = (car.lay_out(around) for around in (0.03, 0.055))
    ended, whole = narrow.prepared.run(), wide.prepared.run()
    assert (ended.status, whole.status) == (Status.NOT_FINITE, Status.COMPLETED)
    assert wide.holds(whole.states)
    place = wide.prepared.compiled.facts.states.index("front_left.travel")
    left = int(np.argmax(np.abs(whole.states[place]) > 0.03))
    there = np.isfinite(ended.states[place])
    assert there[: left - 1].all()
    assert not there[left + 1 :].any()


def exact_and_polynomial(reduction, which, degree, travel):
    """Quantities of a corner at travels (m), exact and by a table for 30 mm on either side; the table."""
    values, end = CAR.parameters(), PLACES[which].split("_")[0]
    table = reduction.table(values, which, -0.03, 0.03, degree)
    names = reduction.places(DEGREES[0]).names[which]
    sampling, p = reduction.axles[end], reduction.numbers(values, which)[None, :]
    sampled = dict(zip(sampling.names, sampling.sample(p, 0.0, travel)[:, 0], strict=True))
    rows = table.numbers[3:].reshape(len(names), degree + 1)
    x = travel / table.numbers[1]
    return {
        name: (sampled[name], np.polyval(row[::-1], x))
        for name, row in zip(names, rows, strict=True)
    }, table


def test_the_bound_of_a_table_holds_between_its_points_and_falls_with_its_degree(reduction):
    travel = np.sort(np.random.default_rng(SEED).uniform(-0.03, 0.03, 40))
    for which in range(len(PLACES)):
        bounds, worst = [], []
        for degree in (4, 6, 8, 10):
            found, table = exact_and_polynomial(reduction, which, degree, travel)
            sizes = {
                "wheel_centre.x": 0.03,
                "wheel_centre.y": 0.03,
                "turning.x": 1.0,
                "turning.z": 1.0,
            }
            sizes |= {f"moment.{axis}": 0.03 * table.numbers[2] for axis in "xyz"}
            sizes["spring.length"] = np.ptp(found["spring.length"][0])
            off = {
                name: np.max(np.abs(np.subtract(*found[name]))) / size
                for name, size in sizes.items()
            }
            assert max(off.values()) < table.error + 1e-14
            bounds.append(table.error)
            worst.append(max(off.values()))
        assert all(after < 0.1 * before for before, after in pairwise(bounds))
        assert worst[-1] < 1e-4 * worst[0]


def test_energy_is_neither_made_nor_lost_without_dampers(reduction):
    """Kinetic energy and heights from masses and moments by hand, springs and tyres by their forces."""
    dampers = [
        f"{end}.corner.strut.damper.{way}_coefficient"
        for end in ENDS
        for way in ("bump", "rebound")
    ]
    tyres = [f"{end}.corner.tyre.damping_coefficient" for end in ENDS]
    loose = CAR.with_changes(
        {
            **dict.fromkeys([*dampers, *tyres], 0.0),
            **{f"{end}.anti_roll_bar_rate": 0.0 for end in ENDS},
        }
    )
    road = jn.HalfSine(height="2 mm", length="0.4 m", start="0.1 m")
    trial = jn.Trial(road=road, right=jn.Flat(), speed=8.0, duration=1.0)
    compiled = reduction.compiled(DEGREES[0])
    laid_out = ReducedCar(
        reduction,
        loose.parameters(),
        excitation(compiled.facts, loose, trial),
        RunSettings().times(1.0),
        1e-6,
    ).lay_out(0.03)
    run = laid_out.prepared.run()
    facts, rows = laid_out.prepared.compiled.facts, {}
    rows = dict(zip(facts.states, run.states[:, 400:], strict=True))  # all wheels are past the bump
    shown = dict(zip(laid_out.prepared.compiled.output_names, run.outputs[:, 400:], strict=True))
    p = dict(zip(facts.parameters, laid_out.prepared.problem.p, strict=False))
    energy = body_energy(loose, rows)
    for place in PLACES:
        energy = energy + corner_energy(loose, place, rows, p)
        rig = getattr(loose, place.split("_")[0]).corner
        assert min(shown[f"{place}.{part}.force"].min() for part in ("strut", "tyre")) > 0.0
        energy = energy + shown[f"{place}.strut.force"] ** 2 / (2.0 * rig.strut.spring.rate)
        energy = energy + 0.5 * rig.tyre.stiffness * shown[f"{place}.tyre.deflection"] ** 2
    assert np.ptp(body_energy(loose, rows)) > 0.1
    assert np.ptp(energy) < 1e-5 * np.ptp(body_energy(loose, rows))


def motion(car, rows):
    """Up, velocity of the body's centre and angular velocity in the body's axes, height of the centre."""
    pitch, roll = rows["attitude.angle"], rows["attitude.second_angle"]
    pitching, rolling = rows["attitude.angle rate"], rows["attitude.second_angle rate"]
    up = np.array([-np.sin(pitch), np.cos(pitch) * np.sin(roll), np.cos(pitch) * np.cos(roll)])
    spin = np.array([rolling, pitching * np.cos(roll), -pitching * np.sin(roll)])
    return up, up * rows["sprung.distance rate"], spin, car.body.height + rows["sprung.distance"]


def body_energy(car, rows):
    _, velocity, spin, height = motion(car, rows)
    inertia = np.array([car.body.roll_inertia, car.body.pitch_inertia, car.body.pitch_inertia])
    turning = 0.5 * inertia @ spin**2
    return turning + car.body.mass * (0.5 * np.sum(velocity**2, axis=0) + car.gravity * height)


def corner_energy(car, place, rows, p):
    up, velocity, spin, height = motion(car, rows)
    half, rate = p[f"{place}.travel.half"], rows[f"{place}.travel_rate"]
    x = (rows[f"{place}.travel"] - p[f"{place}.travel.middle"]) / half

    def of_travel(name, slope=False):
        row = np.array([p[f"{place}.of_travel.{name}[{k}]"] for k in range(DEGREES[0] + 1)])[::-1]
        return np.polyval(np.polyder(row), x) / half if slope else np.polyval(row, x)

    mass = p[f"{place}.of_travel.mass[0]"]
    moment, momentum = (
        np.array([of_travel(f"moment.{axis}", slope) for axis in "xyz"]) for slope in (False, True)
    )
    angular = np.array([of_travel(f"angular.{axis}") for axis in "xyz"])
    tensor = np.array([[of_travel(f"tensor.{min(a, b)}{max(a, b)}") for a in "xyz"] for b in "xyz"])
    kinetic = 0.5 * mass * np.sum(velocity**2, axis=0) + np.sum(
        velocity * np.cross(spin.T, moment.T).T, axis=0
    )
    kinetic += (
        0.5 * np.einsum("it,ijt,jt->t", spin, tensor, spin) + 0.5 * of_travel("inertia") * rate**2
    )
    kinetic += rate * np.sum(velocity * momentum + spin * angular, axis=0)
    return kinetic + car.gravity * (mass * height + np.sum(up * moment, axis=0))


def test_variants_of_a_car_are_what_its_runs_are():
    trial = jn.Trial(
        road=jn.HalfSine(height="20 mm", length="0.5 m", start="1 m"), speed=8.0, duration=0.3
    )
    masses = [200.0, 260.0]
    many = jn.simulate_many(CAR, trial, {"body.mass": masses}, outputs="body.z")
    for i, mass in enumerate(masses):
        one = jn.simulate(CAR.with_changes({"body.mass": mass}), trial)
        assert one.attrs["method"] == "reduced explicit"
        assert np.array_equal(many["body.z"].values[i], one["body.z"].values)
