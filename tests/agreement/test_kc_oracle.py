"""The oracle of kinematics and compliance against closed forms, laws of mechanics, and what jounce already computes."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from kc_oracle import GROUND, Data, Oracle, State, Wheel, energy_of
from kc_rigs import SIDES, read_axle
from scipy.integrate import quad
from scipy.optimize import brentq, fsolve

import jounce as jn

CORNERS = (
    "reference-double-wishbone",
    "generic-mcpherson",
    "sedan-multi-link",
    "semi-trailing-arm",
    "formula-student-front",
)
LOADS = {  # of jn.compliance: the oracle's input, and its sign
    "braking": ("patch_x", -1.0),
    "driving": ("centre_x", 1.0),
    "lateral": ("patch_y", 1.0),
    "aligning": ("moment_z", 1.0),
}


def table_of(rig) -> dict:
    return rig.model_dump(by_alias=True, exclude_none=True)


def on_pads(data: Data, travel: float = 0.0, rack: float = 0.0) -> dict[str, float]:
    """Inputs of an axle on its pads at design height plus travel, the rack locked."""
    inputs = {}
    for name, wheel in data.wheels.items():
        level = np.hypot(wheel.axis[0], wheel.axis[1]) / np.linalg.norm(wheel.axis)
        height = wheel.centre[2] - wheel.radius * level + travel
        inputs |= {f"{name}.held": 1.0, f"{name}.height": height}
    return inputs | ({"rack.held": 1.0, "rack.travel": rack} if data.rack else {})


def toe_out(axis) -> float:
    return float(np.arctan2(-axis[0], abs(axis[1])))


# --- closed forms -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "law",
    [
        {"rate": 2e5, "preload": 300.0},
        {"polynomial": (1e5, -2e6, 4e9)},
        {"table": ((-0.02, -0.004, 0.003, 0.01, 0.03), (-4e3, -500.0, 200.0, 900.0, 7e3))},
        {"power": (3e6, 1.7)},
        {"rate": 1e5, "bump_stop": {"gap": 0.01, "rate": 3e5, "progression": 1e9}},
    ],
)
@pytest.mark.parametrize("x", [-0.025, -0.003, 0.007, 0.035])
def test_energy_is_the_integral_of_the_force(law: dict, x: float) -> None:
    def force(at: float) -> float:
        total = law.get("preload", 0.0) + law.get("rate", 0.0) * at
        total += sum(c * at ** (i + 1) for i, c in enumerate(law.get("polynomial", ())))
        if "table" in law:
            xs, fs = law["table"]
            low = fs[0] + (fs[1] - fs[0]) / (xs[1] - xs[0]) * (at - xs[0])
            high = fs[-1] + (fs[-1] - fs[-2]) / (xs[-1] - xs[-2]) * (at - xs[-1])
            total += low if at < xs[0] else high if at > xs[-1] else float(np.interp(at, xs, fs))
        if "power" in law:
            total += law["power"][0] * max(at, 0.0) ** law["power"][1]
        into = max(at - law.get("bump_stop", {"gap": 1.0})["gap"], 0.0)
        if into:
            total += law["bump_stop"]["rate"] * into + law["bump_stop"]["progression"] * into**3
        return total

    knots = [0.01, *law.get("table", ((), ()))[0]]
    area = quad(force, 0.0, x, points=[k for k in knots if min(0, x) < k < max(0, x)] or None)[0]
    assert float(energy_of(law, x)) == pytest.approx(area, rel=1e-9)


def slider(elastic: list[dict]) -> Data:
    """A body that only slides along z, with a wheel on it."""
    joint = {"kind": "prismatic", "name": "slider", "first": GROUND, "second": "body"}
    return Data(
        bodies={"body": (0.0, 0.0, 0.3)},
        joints=[{**joint, "at": (0.0, 0.0, 0.3), "axis": (0.0, 0.0, 1.0)}],
        elastic=elastic,
        wheels={"wheel": Wheel("body", (0.0, 0.0, 0.3), (0.0, 1.0, 0.0), 0.3)},
    )


def test_two_springs() -> None:
    """A vertical spring, and a horizontal one that is stretched as the body leaves its height."""
    row = {"kind": "spring", "first": "body", "second": GROUND, "at": (0.0, 0.0, 0.3)}
    oracle = Oracle(
        slider(
            [
                {**row, "name": "up", "end": (0.0, 0.0, 0.7), "law": {"rate": 2e4}},
                {**row, "name": "across", "end": (0.4, 0.0, 0.3), "law": {"rate": 5e4}},
            ]
        )
    )
    for load in (-3000.0, -20.0, 700.0, 4000.0):
        z = oracle.solve({"wheel.load": load}).shown["wheel.patch"][2]
        length = np.hypot(0.4, z)
        assert load == pytest.approx(2e4 * z + 5e4 * (length - 0.4) * z / length, rel=1e-12)


def test_chain_of_bushings() -> None:
    """Three links in a row, each on a bushing: compliances add up, those of rotation by the lever squared."""
    stiffness, turning = np.array([[3e5, 4e5, 5e5], [2e5, 3e5, 1e5], [6e5, 2e5, 3e5]]), [
        [900.0, 800.0, 700.0], [400.0, 500.0, 600.0], [300.0, 250.0, 200.0],
    ]  # fmt: skip
    joints = [0.0, 0.2, 0.5]  # along x; the wheel is at 0.9
    names = [GROUND, "a", "b", "c"]
    elastic = [
        {
            "kind": "bushing", "name": f"joint {i}", "first": first, "second": second,
            "at": (joints[i], 0.0, 0.3), "stiffness": stiffness[i],
            "rotational_stiffness": turning[i],
        }
        for i, (first, second) in enumerate(pairwise(names))
    ]  # fmt: skip
    wheel = Wheel("c", (0.9, 0.0, 0.3), (0.0, 1.0, 0.0), 0.3)
    bodies = {name: (joints[i], 0.0, 0.3) for i, name in enumerate(names[1:])}
    state = Oracle(Data(bodies=bodies, elastic=elastic, wheels={"wheel": wheel})).solve({})
    levers = 0.9 - np.array(joints)
    sideways = np.sum(1.0 / stiffness[:, 1]) + sum(levers**2 / np.array(turning)[:, 2])
    along = np.sum(1.0 / stiffness[:, 0])
    turned = np.sum(1.0 / np.array(turning)[:, 2])
    force, moment = state.slopes("wheel.moment_z"), state.slopes("wheel.centre_x")
    assert state.slopes("wheel.load")["wheel.centre"][2] == pytest.approx(
        np.sum(1.0 / stiffness[:, 2]) + sum(levers**2 / np.array(turning)[:, 1]), rel=1e-12
    )
    assert state.slopes("wheel.centre_y")["wheel.centre"][1] == pytest.approx(sideways, rel=1e-12)
    assert moment["wheel.centre"][0] == pytest.approx(along, rel=1e-12)
    assert force["wheel.turn"][2] == pytest.approx(turned, rel=1e-12)


def test_bending_of_a_chain_of_many_bushings_is_that_of_a_beam() -> None:
    """A cantilever cut into pieces of equal bending stiffness, far beyond small angles: the elastica of Euler."""
    pieces, length, stiffness = 60, 1.0, 1000.0
    at = (np.arange(pieces) + 0.5) * length / pieces
    names = [GROUND, *(f"piece {i}" for i in range(pieces))]
    elastic = [
        {
            "kind": "bushing", "name": f"cut {i}", "first": first, "second": second,
            "at": (at[i], 0.0, 0.0), "stiffness": (1e12,) * 3,
            "rotational_stiffness": (1e9, stiffness * pieces / length, 1e9),
        }
        for i, (first, second) in enumerate(pairwise(names))
    ]  # fmt: skip
    bodies = {name: (at[i], 0.0, 0.0) for i, name in enumerate(names[1:])}
    tip = Wheel(names[-1], (length, 0.0, 0.0), (0.0, 1.0, 0.0), 0.3)
    state = Oracle(Data(bodies=bodies, elastic=elastic, wheels={"tip": tip})).solve(
        {"tip.moment_y": -1500.0}
    )
    turned = 1500.0 * length / stiffness  # by a couple it is bent to an arc
    assert state.shown["tip.turn"][1] == pytest.approx(-turned, rel=1e-9)
    x, _, z = state.place(names[-1], (length, 0.0, 0.0))
    assert x == pytest.approx(np.sin(turned) / turned, rel=2e-4)
    assert z == pytest.approx((1.0 - np.cos(turned)) / turned, rel=2e-4)


def test_four_bar_linkage() -> None:
    """Positions from two triangles, and the force that holds a couple by virtual work."""
    crank, coupler, rocker, ground = 0.1, 0.35, 0.25, 0.3
    start = np.radians(70.0)

    def ends(angle: float) -> tuple[np.ndarray, np.ndarray]:
        b = crank * np.array([np.cos(angle), np.sin(angle)])
        base = np.array([ground, 0.0]) - b
        distance = np.hypot(*base)
        cosine = (coupler**2 + distance**2 - rocker**2) / (2.0 * coupler * distance)
        turn = np.arctan2(base[1], base[0]) + np.arccos(cosine)
        return b, b + coupler * np.array([np.cos(turn), np.sin(turn)])

    def point(flat) -> np.ndarray:
        return np.array([flat[0], 0.0, flat[1]])

    b, c = ends(start)
    across = np.array([0.0, 1.0, 0.0])
    joints = [
        {"kind": "revolute", "name": "a", "first": GROUND, "second": "crank", "at": np.zeros(3)},
        {"kind": "spherical", "name": "b", "first": "crank", "second": "coupler", "at": point(b)},
        {"kind": "point on line", "name": "c", "first": "coupler", "second": "rocker",
         "at": point(c), "axis": across, "point": point(c)},
        {"kind": "revolute", "name": "d", "first": GROUND, "second": "rocker",
         "at": point((ground, 0.0))},
        {"kind": "perpendicular", "name": "flat", "first": GROUND, "second": "coupler",
         "axis": across, "other": (1.0, 0.0, 0.0)},
        {"kind": "perpendicular", "name": "level", "first": GROUND, "second": "coupler",
         "axis": across, "other": (0.0, 0.0, 1.0)},
    ]  # fmt: skip
    for joint in joints:
        joint["end"] = joint["at"] + across if joint["kind"] == "revolute" else None
    data = Data(
        bodies={"crank": np.zeros(3), "coupler": point(b), "rocker": point((ground, 0.0))},
        joints=joints,
        wheels={"wheel": Wheel("crank", point(b), across, 0.05)},
    )
    data.wheels["brake"] = Wheel("rocker", point(c), across, 0.05)
    oracle = Oracle(data)
    inputs, state = {"wheel.held": 1.0, "wheel.height": b[1] - 0.05, "brake.moment_y": 12.0}, None
    for angle in np.radians([70.0, 60.0, 50.0, 40.0, 30.0]):
        b, c = ends(angle)
        state = oracle.solve({**inputs, "wheel.height": b[1] - 0.05}, state)
        np.testing.assert_allclose(state.shown["brake.centre"], point(c), atol=1e-13)
        step = 1e-5
        ahead, behind = ends(angle + step), ends(angle - step)
        turn = np.arctan2(*(ahead[1] - [ground, 0.0])) - np.arctan2(*(behind[1] - [ground, 0.0]))
        lift = ahead[0][1] - behind[0][1]  # rotation about +y carries z to x
        force = -12.0 * turn / lift
        assert state.shown["wheel.vertical_force"][0] == pytest.approx(force, rel=1e-8)


def test_lateral_stiffness_of_a_trailing_arm() -> None:
    """A rigid arm on two bushings on an axis along y, against a six by six stiffness written by hand."""
    stiffness, turning = np.array([2e6, 5e6, 3e6]), np.array([200.0, 150.0, 250.0])
    mounts, centre, radius = [np.array([0.4, y, 0.3]) for y in (0.25, 0.6)], (0.0, 0.7, 0.3), 0.3
    row = {"kind": "bushing", "first": GROUND, "second": "arm", "stiffness": stiffness}
    elastic = [
        {**row, "name": f"mount {i}", "at": at, "rotational_stiffness": turning}
        for i, at in enumerate(mounts)
    ]
    wheel = Wheel("arm", centre, (0.0, 1.0, 0.0), radius)
    data = Data(bodies={"arm": mounts[0]}, elastic=elastic, wheels={"wheel": wheel})
    state = Oracle(data).solve({"wheel.held": 1.0})
    matrix = np.zeros((6, 6))
    for at in mounts:
        x, y, z = at
        lever = np.hstack([np.eye(3), -np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])])
        matrix += lever.T @ np.diag(stiffness) @ lever
        matrix[3:, 3:] += np.diag(turning)

    def wrench(force, at) -> np.ndarray:
        return np.hstack([force, np.cross(at, force)])

    patch = np.array([0.0, 0.7, 0.0])
    up = wrench([0.0, 0.0, 1.0], patch)
    for name, load in {
        "patch_y": wrench([0.0, 1.0, 0.0], patch),
        "patch_x": wrench([1.0, 0.0, 0.0], patch),
        "centre_x": wrench([1.0, 0.0, 0.0], centre),
        "moment_z": np.array([0.0, 0.0, 0.0, 0.0, 0.0, 1.0]),
    }.items():
        whole = np.block([[matrix, -up[:, None]], [up[None], np.zeros((1, 1))]])
        *moved, vertical = np.linalg.solve(whole, [*load, 0.0])
        slopes = state.slopes(f"wheel.{name}")
        np.testing.assert_allclose(slopes["wheel.turn"], moved[3:], rtol=1e-9, atol=1e-18)
        assert slopes["wheel.vertical_force"][0] == pytest.approx(vertical, rel=1e-9, abs=1e-12)
        speed = state.speed("arm", patch, f"wheel.{name}")
        expected = np.array(moved[:3]) + np.cross(moved[3:], patch)
        np.testing.assert_allclose(speed, expected, rtol=1e-9, atol=1e-18)


# --- laws of mechanics -----------------------------------------------------------------------------------------------


def bush(*stiffness: float, turning=(60.0, 50.0, 40.0), **other) -> dict:
    return {
        "stiffness": [1e6 * value for value in stiffness],
        "rotational_stiffness": list(turning),
        **other,
    }


def everywhere() -> dict:
    """A double wishbone that yields wherever it can."""
    table = table_of(jn.load("reference-double-wishbone"))
    curves = {
        "y": {"kind": "polynomial", "coefficients": [6e6, 1e9, 3e12]},
        "rx": {
            "kind": "table",
            "angle": [-0.2, -0.05, 0.05, 0.2],
            "torque": [-40.0, -5.0, 5.0, 40.0],
        },
    }
    own = {"x_axis": [1.0, 0.1, 0.0], "z_axis": [0.0, 0.1, 1.0], "preload": [100.0, 200.0, -50.0]}
    hard = {"turning": (5.0, 4.0, 3.0)}
    table["bushings"] = {
        "lower_arm_front": bush(8, 6, 2, curves=curves, **own),
        "lower_arm_rear": bush(4, 3, 2, rotational_preload=(3.0, 1.0, -2.0)),
        "upper_arm_front": bush(5, 5, 1),
        "upper_arm_rear": bush(5, 5, 1),
        "lower_ball_joint": bush(30, 30, 30, **hard),
        "upper_ball_joint": bush(20, 20, 20, **hard),
        "tie_rod_inner": bush(20, 30, 20, **hard),
        "tie_rod_outer": bush(25, 35, 25, **hard),
        "strut_top": bush(3, 3, 5),
        "strut_bottom": bush(6, 6, 9),
        "arb_pivot": bush(3, 3, 3),
        "arb_link_end": bush(10, 10, 10),
        "arb_arm_end": bush(10, 10, 10),
    }
    table["subframe"] = {
        "carries": ["lower_arm_front", "lower_arm_rear", "rack"],
        "mounts": [
            {"point": [0.25, 0.35, 0.25], **bush(8, 7, 6)},
            {"point": [-0.25, 0.38, 0.26], **bush(9, 5, 7)},
        ],
    }
    table["bearing"] = {
        "stiffness": [1e8, 5e7, 1e8],
        "rotational_stiffness": [1e5, 0.0, 1.1e5],
    }
    table["links"] = {"tie_rod": {"stiffness": 5e7}, "lower_arm": {"stiffness": 6e7}}
    table["steering"] = {
        "rack_travel": 0.0, "rack_ratio": 0.008, "column_stiffness": 2000.0, "assistance": 5.0,
        "housing": [{"point": [-0.1, 0.25, 0.2], **bush(20, 5, 20)}],
    }  # fmt: skip
    table["hardpoints"] |= {
        "arb_pivot": (-0.3, 0.35, 0.3),
        "arb_arm_end": (-0.08, 0.45, 0.3),
        "arb_link_end": (-0.05, 0.6, 0.2),
    }
    table["anti_roll_bar"] = {"stiffness": 900.0, "on": "lower_arm", "kind": "u"}
    return table


@pytest.fixture(scope="module")
def soft() -> tuple[Oracle, State]:
    """An axle of bushings, its handwheel locked."""
    data = read_axle(everywhere())
    oracle = Oracle(data)
    return oracle, oracle.solve(on_pads(data))


def test_the_other_side_is_the_mirror_image(soft: tuple[Oracle, State]) -> None:
    oracle, rest = soft
    one = {"left.patch_y": 900.0, "left.patch_x": -700.0, "right.patch_y": 300.0}
    loads = {**one, "left.moment_z": 80.0, "rack.travel": 0.01}
    other = {"right.patch_y": -900.0, "right.patch_x": -700.0, "left.patch_y": -300.0}
    other |= {"right.moment_z": -80.0, "rack.travel": -0.01}
    first, second = (oracle.solve({**rest.inputs, **each}, rest) for each in (loads, other))
    for name in ("patch", "centre", "axis"):
        np.testing.assert_allclose(
            first.shown[f"left.{name}"],
            second.shown[f"right.{name}"] * [1.0, -1.0, 1.0],
            atol=1e-12,
        )


def test_energy_is_the_work_of_loads(soft: tuple[Oracle, State]) -> None:
    """Along a path of loads, steering and heights, the elastic energy grows by the work done on the axle."""
    oracle, rest = soft
    shares, weights = np.polynomial.legendre.leggauss(40)
    shares, weights = 0.5 * (shares + 1.0), 0.5 * weights
    change = {
        "left.centre_x": 1500.0, "right.centre_y": 800.0, "left.height": 0.004,
        "right.height": -0.003,
    }  # fmt: skip

    def at(share: float, start: State) -> State:
        moved = {name: share * value + rest.inputs.get(name, 0.0) for name, value in change.items()}
        return oracle.solve({**rest.inputs, **moved}, start)

    work, state = 0.0, rest
    for share, weight in zip(shares, weights, strict=True):
        state = at(share, state)
        for name, rate in change.items():
            slopes = state.slopes(name)
            for load, (place, k) in {
                "left.centre_x": ("left.centre", 0), "right.centre_y": ("right.centre", 1),
            }.items():  # fmt: skip
                work += weight * rate * slopes[place][k] * state.inputs[load]
            for wheel in SIDES:
                lift = slopes[f"{wheel}.patch"][2]
                work += weight * rate * lift * state.shown[f"{wheel}.vertical_force"][0]
    gained = at(1.0, state).shown["energy"][0] - rest.shown["energy"][0]
    assert gained == pytest.approx(work, rel=1e-10)


def test_reciprocity(soft: tuple[Oracle, State]) -> None:
    """Maxwell and Betti: what a load at one point moves at another, a load there moves here."""
    oracle, rest = soft
    places = {
        "left.centre_x": ("left.centre", 0),
        "left.centre_y": ("left.centre", 1),
        "right.centre_x": ("right.centre", 0),
        "right.centre_y": ("right.centre", 1),
        "left.load": ("left.patch", 2),
        "right.load": ("right.patch", 2),
    }
    loads = {f"{side}.load": rest.shown[f"{side}.vertical_force"][0] for side in SIDES}
    state = oracle.solve({**loads, "left.centre_y": 500.0}, rest)
    matrix = np.array([[state.slopes(of)[name][k] for name, k in places.values()] for of in places])
    np.testing.assert_allclose(matrix, matrix.T, rtol=1e-8, atol=1e-12 * np.abs(matrix).max())


def test_slopes_are_differences(soft: tuple[Oracle, State]) -> None:
    oracle, rest = soft
    for name, step in {"left.patch_y": 5.0, "right.moment_z": 1.0, "rack.travel": 1e-4}.items():
        ends = [
            oracle.solve({**rest.inputs, name: rest.inputs.get(name, 0.0) + sign * step}, rest)
            for sign in (1.0, -1.0)
        ]
        slopes = rest.slopes(name)
        for what in ("left.axis", "right.centre", "left.vertical_force", "left.bearing.force"):
            rise = (ends[0].shown[what] - ends[1].shown[what]) / (2.0 * step)
            np.testing.assert_allclose(slopes[what], rise, rtol=1e-4, atol=1e-4 * max(abs(rise)))


def test_forces_balance(soft: tuple[Oracle, State]) -> None:
    """What the road puts in, mounts, bushings and springs on the car's body take out."""
    oracle, rest = soft
    loads = {"left.patch_y": 1200.0, "right.patch_x": -900.0}
    state = oracle.solve({**rest.inputs, **loads}, rest)
    total = np.array([-900.0, 1200.0, sum(state.shown[f"{s}.vertical_force"][0] for s in SIDES)])
    for row in oracle.data.elastic:
        if GROUND in (row["first"], row["second"]) and row["kind"] == "bushing":
            force = state.shown[f"{row['name']}.force_ground"]  # on the second body
            total += force if row["first"] == GROUND else -force
    assert not [j for j in oracle.data.joints if j["first"] == GROUND and j["kind"] != "aligned"]
    np.testing.assert_allclose(total, 0.0, atol=1e-7)


@pytest.mark.parametrize("name", CORNERS)
def test_force_based_roll_centre(name: str) -> None:
    """Opposed loads of ideal joints lift a wheel as its contact point moves sideways per rise: virtual work."""
    rig = jn.load(name)
    data = read_axle(table_of(rig))
    state = Oracle(data).solve(on_pads(data))
    outward = 1.0 if rig.side == "left" else -1.0
    slope = state.slopes(f"{rig.side}.patch_y")[f"{rig.side}.vertical_force"][0]
    height = -slope * outward * abs(state.shown[f"{rig.side}.patch"][1])
    swept = jn.sweep_travel(rig, [0.0])
    assert height == pytest.approx(float(swept["roll_centre_height"][0]), abs=1e-12)


# --- what jounce computes already -------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "rack"), [*((name, 0.0) for name in CORNERS), *((name, 0.02) for name in CORNERS[:2])]
)
def test_kinematics_of_a_corner(name: str, rack: float) -> None:
    rig = jn.load(name)
    data = read_axle(table_of(rig), (rig.side,))
    oracle, centre = Oracle(data), rig.hardpoints.wheel_centre[2]
    states, state = [], oracle.solve(on_pads(data))
    for travel in (-0.03, 0.0, 0.025):
        state = oracle.solve(on_pads(data, travel, rack), state)
        states.append(state)
    shown = [{k.removeprefix(f"{rig.side}."): v for k, v in s.shown.items()} for s in states]
    swept = jn.sweep_travel(
        rig, [row["centre"][2] - centre for row in shown], rack if data.rack else None
    )
    for at, row in enumerate(shown):
        for k, letter in enumerate("xyz"):
            for place, body in (("contact_point", "patch"), ("wheel_centre", "centre")):
                there = float(swept[f"{place}_{letter}"][at])
                assert row[body][k] == pytest.approx(there, abs=1e-12)
        assert toe_out(row["axis"]) == pytest.approx(-float(swept["toe"][at]), abs=1e-12)
        assert np.arcsin(row["axis"][2]) == pytest.approx(-float(swept["camber"][at]), abs=1e-12)
        assert row["spring.force"][0] == pytest.approx(float(swept["spring_force"][at]), rel=1e-10)
        stops = row.get("bump_stop.force", [0.0])[0] + row.get("rebound_stop.force", [0.0])[0]
        assert stops == pytest.approx(float(swept["stop_force"][at]), abs=1e-7)
        rate = states[at].slopes(f"{rig.side}.height")[f"{rig.side}.vertical_force"][0]
        assert rate == pytest.approx(float(swept["wheel_rate_contact"][at]), rel=1e-10)


SOFT = {"stiffness": [6e6, 8e6, 3e6], "rotational_stiffness": [50.0, 60.0, 70.0]}
YIELDING = {
    "reference-double-wishbone": dict.fromkeys(
        ("lower_arm_front", "lower_arm_rear", "upper_arm_front", "upper_arm_rear"), SOFT
    ),
    "generic-mcpherson": {"lower_arm_front": SOFT, "lower_arm_rear": SOFT},
    "sedan-multi-link": {"link_4_inner": {"stiffness": [6e6, 8e6, 3e6]}},
    "semi-trailing-arm": {"arm_inner": SOFT, "arm_outer": SOFT},
}


@pytest.mark.parametrize("travel", [-0.05, 0.0, 0.05])
@pytest.mark.parametrize("name", YIELDING)
def test_compliance_of_a_corner(name: str, travel: float) -> None:
    rig = jn.load(name).with_changes({"bushings": YIELDING[name]})
    data = read_axle(table_of(rig), (rig.side,))
    height = float(jn.sweep_travel(rig, [travel])["contact_point_z"][0])
    state = Oracle(data).solve({**on_pads(data), f"{rig.side}.height": height})
    given = jn.compliance(rig, [travel])
    side, body = rig.side, data.wheels[rig.side].body
    a = state.shown[f"{side}.axis"]
    assert toe_out(a) == pytest.approx(-float(given["toe"][0]), abs=1e-12)
    patch = state.design(body, state.shown[f"{side}.patch"])
    for load, (name_of, sign) in LOADS.items():
        of = f"{side}.{name_of}"
        slopes = {key: sign * value for key, value in state.slopes(of).items()}
        da, moved = slopes[f"{side}.axis"], sign * state.speed(body, patch, of)
        found = {
            "steer": (a[0] * da[1] - a[1] * da[0]) / (a[0] ** 2 + a[1] ** 2),
            "camber": -da[2] / np.sqrt(1.0 - a[2] ** 2),
            "wheel_centre_x": slopes[f"{side}.centre"][0],
            "wheel_centre_y": slopes[f"{side}.centre"][1],
            "patch_x": moved[0],
            "patch_y": moved[1],
        }
        for quantity, value in found.items():
            there = float(given[f"{load}.{quantity}"][0])
            assert value == pytest.approx(there, rel=1e-9, abs=1e-15), (load, quantity)


# --- dependent axles --------------------------------------------------------------------------------------------------

SOLID = {
    "model": "solid-axle",
    "wheel": {"radius": 0.3},
    "hardpoints": {  # three trailing links, equal and parallel: in bounce the axle does not turn
        "wheel_centre": (0.0, 0.75, 0.3),
        "lower_link_body": (0.6, 0.5, 0.25),
        "lower_link_axle": (0.0, 0.5, 0.25),
        "upper_link_body": (0.6, 0.0, 0.45),
        "upper_link_axle": (0.0, 0.0, 0.45),
        "strut_bottom": (0.0, 0.5, 0.3),
        "strut_top": (0.0, 0.5, 0.7),
    },
    "strut": {"on": "axle", "spring": {"rate": 3e4, "preload": 3000.0}},
}
PANHARD = {"panhard_body": (-0.1, 0.5, 0.36), "panhard_axle": (-0.1, -0.45, 0.30)}
WATT = {
    "watt_pivot": (-0.1, 0.0, 0.3),
    "watt_upper_axle": (-0.1, 0.0, 0.36),
    "watt_upper_body": (-0.1, 0.5, 0.36),
    "watt_lower_axle": (-0.1, 0.0, 0.24),
    "watt_lower_body": (-0.1, -0.5, 0.24),
}


def solid(**guide) -> tuple[Data, dict]:
    points = SOLID["hardpoints"] | guide
    return read_axle({**SOLID, "hardpoints": points}), points


def test_panhard_rod_in_bounce() -> None:
    """Two spheres: the links' and the rod's."""
    data, points = solid(**PANHARD)
    oracle, state = Oracle(data), None
    link = np.subtract(points["lower_link_axle"], points["lower_link_body"])
    rod = np.subtract(points["panhard_axle"], points["panhard_body"])
    for z in np.linspace(-0.08, 0.08, 9):
        state = oracle.solve(on_pads(data, z), state)
        moved = state.shown["left.centre"] - points["wheel_centre"]
        assert np.linalg.norm(state.shown["left.turn"]) < 1e-12
        assert moved[2] == pytest.approx(z, abs=1e-13)
        assert np.linalg.norm(link + moved) == pytest.approx(0.6, abs=1e-13)
        assert np.linalg.norm(rod + moved) == pytest.approx(np.linalg.norm(rod), abs=1e-13)


def test_roll_centre_of_a_panhard_rod() -> None:
    """The rod is the only part across: sideways loads transfer load as if they acted where it crosses the middle."""
    data, points = solid(**PANHARD)
    state = Oracle(data).solve(on_pads(data))
    slopes = [state.slopes(f"{side}.patch_y") for side in SIDES]  # a newton at each wheel
    transfer = sum(s["left.vertical_force"][0] - s["right.vertical_force"][0] for s in slopes)
    (_, y0, z0), (_, y1, z1) = points["panhard_body"], points["panhard_axle"]
    height = z0 - y0 * (z1 - z0) / (y1 - y0)
    assert -transfer * 0.75 / 2.0 == pytest.approx(height, abs=1e-10)


def test_watt_linkage() -> None:
    """The crank's middle follows Watt's curve: straight to some micrometres, and independent of the axle's links."""
    data, points = solid(**WATT)
    oracle, state = Oracle(data), None

    def pose(z: float, ahead: float) -> float:
        """y of the crank's middle: both rods keep their lengths, the pins move ``ahead`` along x."""

        def rods(x):
            y, turn = x
            top = np.array([y - 0.06 * np.sin(turn), z + 0.06 * np.cos(turn)])
            bottom = np.array([y + 0.06 * np.sin(turn), z - 0.06 * np.cos(turn)])
            flat = np.sqrt(0.5**2 - ahead**2)
            return [
                np.hypot(*(top - [0.5, 0.06])) - flat,
                np.hypot(*(bottom - [-0.5, -0.06])) - flat,
            ]

        return float(fsolve(rods, [0.0, 0.0], xtol=1e-12)[0])

    for z in np.linspace(-0.05, 0.05, 5):
        state = oracle.solve(on_pads(data, z), state)
        moved = state.place("axle", points["watt_pivot"]) - points["watt_pivot"]
        assert moved[1] == pytest.approx(pose(moved[2], moved[0]), abs=1e-12)
        assert abs(moved[1]) < 2e-5


BEAM = {
    "model": "twist-beam",
    "wheel": {"radius": 0.3},
    "beam": {"torsional_stiffness": 5000.0},
    "hardpoints": {
        "wheel_centre": (0.0, 0.72, 0.3),
        "pivot": (0.45, 0.5, 0.32),
        "shear_centre": (0.25, 0.0, 0.38),
        "strut_bottom": (0.0, 0.5, 0.28),
        "strut_top": (0.0, 0.5, 0.6),
    },
}
SPRUNG = {**BEAM, "strut": SOLID["strut"]}


def beam_line() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Left pivot, the direction of the line from the shear centre through it, and the wheel's centre."""
    pivot, shear, centre = (
        np.array(BEAM["hardpoints"][name]) for name in ("pivot", "shear_centre", "wheel_centre")
    )
    return pivot, (pivot - shear) / np.linalg.norm(pivot - shear), centre


def test_twist_beam_in_roll() -> None:
    """Each half turns about the line through its mount and the shear centre in the middle of the car."""
    data = read_axle(SPRUNG)
    oracle = Oracle(data)
    state = oracle.solve(on_pads(data))
    slopes = {
        key: state.slopes("left.height")[key] - state.slopes("right.height")[key]
        for key in state.shown
    }
    mount, along, centre = beam_line()
    patch = centre - [0.0, 0.0, 0.3]
    rate = 1.0 / np.cross(along, patch - mount)[2]  # for a contact point that rises by one
    np.testing.assert_allclose(slopes["left.turn"], rate * along, atol=1e-11)
    np.testing.assert_allclose(
        slopes["left.centre"], np.cross(rate * along, centre - mount), atol=1e-12
    )
    np.testing.assert_allclose(slopes["right.turn"], rate * along * [1.0, -1.0, 1.0], atol=1e-11)
    assert slopes["beam.angle"][0] == pytest.approx(-2.0 * rate * along[1], rel=1e-12)


def test_roll_stiffness_of_a_twist_beam() -> None:
    """Without springs the beam alone resists: its torque through the lever of the line to the contact point."""
    data = read_axle(BEAM)
    state = Oracle(data).solve(on_pads(data))
    force = state.slopes("left.height")["left.vertical_force"][0]
    mount, along, centre = beam_line()
    rate = along[1] / np.cross(along, centre - [0.0, 0.0, 0.3] - mount)[2]
    assert force == pytest.approx(5000.0 * rate**2, rel=1e-10)


def test_twist_beam_in_bounce() -> None:
    """Both halves turn as one about the line through the mounts."""
    data = read_axle(SPRUNG)
    oracle, state = Oracle(data), None
    arm = (beam_line()[2] - beam_line()[0])[[0, 2]]
    start, length = np.arctan2(arm[1], -arm[0]), np.hypot(*arm)
    for z in (-0.05, 0.0, 0.05):
        state = oracle.solve(on_pads(data, z), state)
        turned = np.arcsin((arm[1] + z) / length) - start
        assert state.shown["left.turn"][1] == pytest.approx(turned, abs=1e-12)
        assert state.shown["beam.angle"][0] == pytest.approx(0.0, abs=1e-12)


def test_roll_centre_of_a_twist_beam() -> None:
    """By virtual work: opposed loads lift the wheels as their contact points move sideways in roll."""
    bushing = {"stiffness": (1e13,) * 3, "rotational_stiffness": (0.0, 0.0, 0.0)}
    data = read_axle({**SPRUNG, "bushings": {"pivot": bushing}})
    state = Oracle(data).solve({**on_pads(data)})
    slopes = [state.slopes(f"{side}.patch_y") for side in SIDES]
    transfer = sum(s["left.vertical_force"][0] - s["right.vertical_force"][0] for s in slopes)
    mount, along, centre = beam_line()
    speed = np.cross(along, centre - [0.0, 0.0, 0.3] - mount)
    # in roll both contact points move sideways alike: by their speed for a rise of one at the left, a fall at the right
    assert -transfer / 2.0 == pytest.approx(speed[1] / speed[2], rel=1e-5)


def test_more_than_a_mechanism_carries_is_refused() -> None:
    row = {"kind": "spring", "first": "body", "second": GROUND, "at": (0.0, 0.0, 0.3)}
    oracle = Oracle(
        slider([{**row, "name": "up", "end": (0, 0, 0.7), "law": {"polynomial": (1e4, 0.0, -1e6)}}])
    )
    with pytest.raises(ArithmeticError, match="no equilibrium"):
        oracle.solve({"wheel.load": 1e6})
    assert brentq(lambda x: 1e4 * x - 1e6 * x**3 - 300.0, 0.0, 0.05) == pytest.approx(
        oracle.solve({"wheel.load": 300.0}).shown["wheel.patch"][2], rel=1e-10
    )
