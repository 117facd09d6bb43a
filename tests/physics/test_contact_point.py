"""One contact point: cars balance about the road where their wheels lean, and runs say what load cases say."""

from __future__ import annotations

import numpy as np
import pytest
from car_at_rest import at_rest, body_centre, force, loaded, place, seen_from_body, without_weights
from scipy.optimize import brentq, root

import jounce as jn
from jounce.kinematics.axle import Ground, TwoWheelAxle
from jounce.parts.vehicles import FullCar3D

CARS = ("formula-student-car", "kart-whole-vehicle", "sedan-full-car-3d")
LAWS = ("vertical", "radial")
BALANCE = 1e-9  # of the weight times the height of the centre of gravity
UP = np.array([0.0, 0.0, 1.0])


def with_law(car: FullCar3D, law: str, **changes) -> FullCar3D:
    return car.with_changes(
        {**{f"{end}.corner.tyre.law": law for end in ("front", "rear")}, **changes}
    )


# balance of moments about the road ------------------------------------------------------------------------------------


def mapped(before: np.ndarray, after: np.ndarray, point: np.ndarray) -> np.ndarray:
    """Where a point of a rigid body is whose points are known before and after; of two points: with the least turn."""
    middles = before.mean(axis=0), after.mean(axis=0)
    u, _, v = np.linalg.svd((before - middles[0]).T @ (after - middles[1]))
    if len(before) == 2:
        one, other = ((p[1] - p[0]) / np.linalg.norm(p[1] - p[0]) for p in (before, after))
        axis, cosine = np.cross(one, other), one @ other
        cross = np.array(
            [[0.0, -axis[2], axis[1]], [axis[2], 0.0, -axis[0]], [-axis[1], axis[0], 0.0]]
        )
        turn = np.eye(3) + cross + cross @ cross / (1.0 + cosine)
    else:
        turn = v.T @ np.diag([1.0, 1.0, np.linalg.det(v.T @ u.T)]) @ u.T
    return middles[1] + turn @ (point - middles[0])


def points_of(corner) -> dict[str, tuple[str, ...]]:
    """Hardpoints that move with each body of a corner that has mass."""
    found: dict[str, tuple[str, ...]] = {"rocker": ("rocker_pivot", "rocker_axis", "pushrod_inner")}
    if corner.model == "five-link":
        found["upright"] = tuple(f"link_{i}_outer" for i in range(1, 6))
        found |= {f"link_{i}": (f"link_{i}_inner", f"link_{i}_outer") for i in range(1, 6)}
    else:
        found["upright"] = ("wheel_centre", "lower_ball_joint", "upper_ball_joint", "tie_rod_outer")
        found |= {
            f"{a}_arm": (f"{a}_arm_front", f"{a}_arm_rear", f"{a}_ball_joint")
            for a in ("lower", "upper")
        }
    found[corner.strut.on] = (*found[corner.strut.on], "strut_bottom")
    return found | {"wheel": found["upright"]}


def masses(car: FullCar3D, run) -> list[tuple[float, np.ndarray]]:
    """Mass and place of its centre of every body of a car as it stands, from the places of its hardpoints."""
    found = []
    for which in car.corners:
        axle = getattr(car, which.partition("_")[0])
        mirror = np.array([1.0, 1.0 if which.endswith("left") else -1.0, 1.0])
        for name, body in axle.corner.body_masses().items():
            names = points_of(axle.corner)[name]
            before = np.array([axle.corner.hardpoints.at(point) for point in names]) * mirror
            after = np.array([place(run, f"{which}.{point}") for point in names])
            found.append((body.mass, mapped(before, after, np.array(body.centre_of_mass) * mirror)))
    return [*found, (car.body.mass, body_centre(car, run))]


@pytest.mark.parametrize("law", LAWS)
def every_car() -> list:
    """Cars and laws; a radial one is another model, though the same, and takes seconds to make."""
    slow = [pytest.mark.slow]
    named = [(name, law) for name in CARS for law in LAWS]
    return [
        pytest.param(*one, marks=slow if one[1] == "radial" and one[0] != CARS[0] else [])
        for one in named
    ]


@pytest.mark.some(3)
@pytest.mark.parametrize(
    "load",
    [{}, *({"lateral_acceleration": a} for a in (1.0, 3.0, 6.0)), {"deceleration": 4.0}],
    ids=str,
)
@pytest.mark.parametrize(("name", "law"), every_car())
def test_every_car_balances_about_the_road(name, law, load):
    """All forces on the car and all moments add up to nothing: weights, inertia of driving, and what the road does.

    What keeps the car from sliding takes no force, and no moment but about the vertical axis.
    """
    car = with_law(jn.load(name), law)
    if (
        name == "sedan-full-car-3d"
    ):  # two points tell no turn of a link about itself, off which its centre lies by 0.5 mm
        ends = [
            np.array(car.rear.corner.hardpoints.at(f"link_3_{end}")) for end in ("inner", "outer")
        ]
        car = car.with_changes({"rear.corner.bodies.link_3.centre_of_mass": list(0.5 * sum(ends))})
    run = at_rest(car, **load)
    bodies = masses(car, run)
    total = sum(mass for mass, _ in bodies)
    inertia = np.array(
        [load.get("deceleration", 0.0), -load.get("lateral_acceleration", 0.0), -car.gravity]
    )
    wheels = {
        which: (float(run[f"{which}.tyre.force"]), place(run, f"{which}.contact_point"))
        for which in car.corners
    }
    share = -total * inertia * [1.0, 1.0, 0.0] / sum(pushed for pushed, _ in wheels.values())
    acting = [(mass * inertia, where) for mass, where in bodies]
    acting += [(pushed * (UP + share), where) for pushed, where in wheels.values()]
    size = total * car.gravity
    assert np.abs(sum(push for push, _ in acting)).max() < BALANCE * size
    moment = sum(np.cross(where, push) for push, where in acting)
    guide = "guide_joint" if car.body.joint else "attitude"
    assert np.abs(force(run, guide)[:2]).max() < BALANCE * size
    held = np.array([float(run[f"{guide}.t{axis}"]) for axis in "xyz"])
    assert np.abs(moment + held).max() < BALANCE * size * car.body.height
    assert np.abs(held[:2]).max() <= 0.1 * abs(held[2]) + BALANCE * size * car.body.height


# an oracle in plain numbers -------------------------------------------------------------------------------------------

ARM, INNER, CENTRE, STRUT_TOP = (
    0.30,
    0.40,
    np.array([0.76, 0.30]),
    np.array([0.60, 0.55]),
)  # m; y and z
LOW, HIGH = 0.15, 0.40  # m: heights of both arms
BODY, HALF_BASE, UPRIGHT, ARMS = (1600.0, 0.55), 1.3, 30.0, 4.0  # kg and m, m, kg, kg of each arm
LEVER, TYRE, RADIUS, G = (
    1.5,
    2.2e5,
    0.32,
    9.81,
)  # of the wheel over the spring, which holds the body at design
SPRING = {"rate": 9e4, "preload": LEVER * 0.25 * BODY[0] * G}


def parallel_arms() -> FullCar3D:
    """A car whose wheels lean exactly as its body does: equal arms, level at design, and a tie rod like them."""
    arm = {f"{which}_arm_{end}": [x, INNER, z] for which, z in (("lower", LOW), ("upper", HIGH)) for end, x in
           (("front", 0.15), ("rear", -0.15))}  # fmt: skip
    outer = INNER + ARM
    points = {"lower_ball_joint": [0.0, outer, LOW], "upper_ball_joint": [0.0, outer, HIGH]}
    points |= {"tie_rod_inner": [-0.12, INNER, 0.2], "tie_rod_outer": [-0.12, outer, 0.2]}
    points |= {
        "wheel_centre": [0.0, *CENTRE],
        "strut_bottom": [0.0, 0.6, LOW],
        "strut_top": [0.0, *STRUT_TOP],
    }
    inertia = {"xx": 0.1, "yy": 0.1, "zz": 0.1}
    bodies = {f"{which}_arm": {"mass": ARMS, "centre_of_mass": [0.0, INNER + 0.5 * ARM, z], "inertia": inertia}
              for which, z in (("lower", LOW), ("upper", HIGH))}  # fmt: skip
    bodies["upright"] = {"mass": UPRIGHT, "centre_of_mass": [0.0, *CENTRE], "inertia": inertia}
    corner = jn.load("reference-double-wishbone").with_changes(
        {
            "hardpoints": arm | points,
            "wheel": {"radius": RADIUS, "camber": 0.0, "toe": 0.0},
            "bodies": bodies,
            "strut.spring": SPRING,
            "tyre": {"stiffness": TYRE, "undeformed_radius": RADIUS},
        }
    )
    axle = {"distance": HALF_BASE, "corner": corner}
    body = {"mass": BODY[0], "pitch_inertia": 2500.0, "roll_inertia": 600.0, "height": BODY[1]}
    return FullCar3D(source="made up", body=body, front=axle, rear=axle)


class Leaning:
    """Half of that car in its front view: heave and roll of its body, and the angle of the arms on both sides."""

    def placed(self, q, point, side: float):
        """Where a point of the body is; places (y, z) at design, of a left wheel, q = heave, roll, arms."""
        y, z = side * point[0], point[1] - BODY[1]
        cosine, sine = np.cos(q[1]), np.sin(q[1])
        return np.array([cosine * y - sine * z, BODY[1] + q[0] + sine * y + cosine * z])

    def swung(self, q, side: float) -> np.ndarray:
        """How far the outer end of the arms has moved, in the body's axes of a left wheel."""
        angle = q[2] if side > 0.0 else q[3]
        return ARM * np.array([np.cos(angle) - 1.0, np.sin(angle)])

    def wheel(self, q, side: float):
        """Wheel centre, and a unit vector down along the wheel, which leans as the body does."""
        down = np.array([np.sin(q[1]), -np.cos(q[1])])
        return self.placed(q, CENTRE + self.swung(q, side), side), down

    def forces(self, q, acceleration: float):
        """Generalised forces; those of each wheel's contact point as ``(normal, side force, place)``."""
        held = [(0.5 * BODY[0], lambda p: self.placed(p, np.array([0.0, BODY[1]]), 1.0))]
        for side in (1.0, -1.0):
            held.append((UPRIGHT, lambda p, side=side: self.wheel(p, side)[0]))
            for z in (LOW, HIGH):
                middle = np.array([INNER + 0.5 * ARM, z])
                held.append(
                    (
                        ARMS,
                        lambda p, side=side, at=middle: self.placed(
                            p, at + 0.5 * self.swung(p, side), side
                        ),
                    )
                )
        total = sum(mass for mass, _ in held)
        work = [(mass * np.array([-acceleration, -G]), where) for mass, where in held]
        contacts = []
        for side in (1.0, -1.0):
            centre, down = self.wheel(q, side)
            loaded = centre[1] / -down[1]
            normal = max(TYRE * (RADIUS - loaded), 0.0) / -down[1]
            contacts.append([normal, 0.0, centre + loaded * down])
        loads = sum(normal for normal, *_ in contacts)
        for side, contact in zip((1.0, -1.0), contacts, strict=True):
            contact[1] = total * acceleration * contact[0] / loads
            below = CENTRE - [0.0, self.wheel(q, side)[0][1] / np.cos(q[1])]

            def of_upright(p, side=side, at=below):
                return self.placed(p, at + self.swung(p, side), side)

            assert np.allclose(of_upright(q), contact[2], atol=1e-12)
            work.append((np.array([contact[1], contact[0]]), of_upright))

        def spring(p, side: float):
            angle = p[2] if side > 0.0 else p[3]
            share = (0.6 - INNER) * np.array([np.cos(angle), np.sin(angle)])
            reach = STRUT_TOP - np.array([INNER, LOW]) - share
            shorter = STRUT_TOP[1] - LOW - np.sqrt(reach[0] ** 2 + reach[1] ** 2)
            return SPRING["preload"] * shorter + 0.5 * SPRING["rate"] * shorter**2

        found, small = np.zeros(4), 1e-30
        for k in range(4):
            p = np.asarray(q, dtype=complex) + 1j * small * np.eye(4)[k]
            found[k] = sum(push @ where(p).imag for push, where in work) / small
            found[k] -= sum(spring(p, side).imag for side in (1.0, -1.0)) / small
        return found, contacts

    def at_rest(self, acceleration: float):
        """Balanced q and contacts in a steady bend to the left."""
        found = root(lambda q: self.forces(q, acceleration)[0], np.zeros(4), tol=1e-13)
        assert np.abs(found.fun).max() < 1e-7
        return found.x, self.forces(found.x, acceleration)[1]


@pytest.mark.parametrize("law", [LAWS[0], pytest.param(LAWS[1], marks=pytest.mark.slow)])
@pytest.mark.parametrize("acceleration", [0.001, 1.0, 4.0])
def test_a_car_that_leans_on_parallel_arms(acceleration, law):
    """Roll, heave, loads and contact points are those of an equilibrium by virtual work with four coordinates."""
    run = at_rest(with_law(parallel_arms(), law), lateral_acceleration=acceleration)
    q, contacts = Leaning().at_rest(acceleration)
    assert float(run["body.z"]) == pytest.approx(q[0], abs=1e-9)
    assert float(run["body.roll"]) == pytest.approx(q[1], abs=1e-9)
    for side, (normal, _, where) in zip(("left", "right"), contacts, strict=True):
        for end in ("front", "rear"):
            assert float(run[f"{end}_{side}.tyre.force"]) == pytest.approx(normal, rel=1e-8)
            assert place(run, f"{end}_{side}.contact_point")[1:] == pytest.approx(where, abs=1e-9)


def test_load_transfer_in_closed_form():
    """At small acceleration, of light wheels and with the roll centre on the road: t dF = m z (a + g phi).

    Tyres that push vertically below their wheel centres leave out m g R phi of it.
    """
    small, light = 1e-3, {"mass": 1e-4, "inertia": dict.fromkeys(("xx", "yy", "zz"), 1e-6)}
    places = {
        f"{end}.corner.bodies.{name}"
        for end in ("front", "rear")
        for name in ("lower_arm", "upper_arm", "upright")
    }
    car = parallel_arms()
    bodies = {
        path: {**light, "centre_of_mass": at(car, f"{path}.centre_of_mass")} for path in places
    }
    car = car.with_changes(bodies)
    run = at_rest(car, lateral_acceleration=small)
    track = place(run, "front_left.contact_point")[1] - place(run, "front_right.contact_point")[1]
    gap = [
        float(run[f"{end}_right.tyre.force"] - run[f"{end}_left.tyre.force"])
        for end in ("front", "rear")
    ]
    roll, height = float(run["body.roll"]), body_centre(car, run)[2]
    expected = car.body.mass * height * (small + car.gravity * roll)
    assert 0.5 * sum(gap) * track == pytest.approx(expected, rel=1e-5)
    assert car.body.mass * car.gravity * RADIUS * roll > 0.05 * expected


def at(description, path: str):
    for name in path.split("."):
        description = getattr(description, name)
    return list(description)


# one point everywhere -------------------------------------------------------------------------------------------------

SOFT = {"stiffness": [4e6] * 3, "rotational_stiffness": [10.0] * 3}
ON_ARMS = ("lower_arm_front", "lower_arm_rear", "upper_arm_front", "upper_arm_rear")


@pytest.mark.parametrize("load", [{"lateral_acceleration": 4.0}, {"deceleration": 5.0}], ids=str)
@pytest.mark.parametrize("name", ["formula-student-car", "sedan-full-car-3d"])
def test_runs_and_kinematics_have_one_contact_point(name, load):
    car = jn.load(name)
    run = at_rest(car, **load)
    for which in car.corners:
        side = 1.0 if which.endswith("left") else -1.0
        corner, travel, _, _ = loaded(car, run, which)
        wheel = TwoWheelAxle(corner if side > 0.0 else corner.mirrored()).wheel(
            side, np.array([travel]), np.zeros(1)
        )
        ground = Ground(wheel, np.array([float(run["body.roll"])]), side, float(run["body.pitch"]))
        ahead = np.array(
            [
                (1.0 if which.startswith("front") else -1.0)
                * getattr(car, which.split("_")[0]).distance
            ]
        )
        expected = ground.contact[0] * [1.0, side, 1.0]
        expected[0] += ahead[0] - corner.hardpoints.wheel_centre[0]
        assert seen_from_body(car, run, place(run, f"{which}.contact_point")) == pytest.approx(
            expected, abs=1e-9
        )


@pytest.mark.slow
def test_wheels_of_runs_and_of_compliance_steer_alike_when_braked():
    """On bushings, with a moment on the body so that it stays level: steer and camber are those of the corner held."""
    bushings = {f"{end}.corner.bushings": dict.fromkeys(ON_ARMS, SOFT) for end in ("front", "rear")}
    car = without_weights(jn.load("formula-student-car").with_changes(bushings))

    def braked(moment: float) -> dict[str, float]:
        return at_rest(car, deceleration=5.0, pitch_moment=moment)

    run = braked(brentq(lambda moment: braked(moment)["body.pitch"], -1500.0, 0.0, xtol=1e-10))
    corner, _, _, held = loaded(car, run, "front_left")
    height = seen_from_body(car, run, place(run, "front_left.contact_point"))[2]
    ideal = brentq(
        lambda z: float(jn.sweep_travel(corner, z)["contact_point_z"][0]) - height,
        -0.03,
        0.03,
        xtol=1e-13,
    )
    found = jn.compliance(corner, ideal, load=jn.ContactLoad(longitudinal_force=-5.0 * held))
    free = jn.compliance(corner, ideal)
    assert abs(float(found["steer"][0] - free["steer"][0])) > 2e-4
    for angle in ("steer", "camber"):
        assert run[f"front_left.wheel.{angle}"] == pytest.approx(float(found[angle][0]), abs=1e-9)
