"""Full car on 3-D corners: written in the body's axes (shipped) against everything in ground axes (twin)."""

from __future__ import annotations

from functools import cache

import casadi as ca
import numpy as np
import pytest
from full_car_in_ground_axes import full_car_in_ground_axes

import jounce as jn
from jounce.core.segments import flat
from jounce.models import build
from jounce.simulation.compiled import compile_rig
from jounce.simulation.prepare import solve

pytestmark = pytest.mark.usefixtures("optimised")

AGREEMENT = 1e-9
BODY = ("sprung.distance", "attitude.angle", "attitude.second_angle")


def functions(model):
    symbols = [model.x, model.u, model.p, model.m]
    return {
        name: ca.Function(name, symbols, [getattr(model, name)])
        for name in ("output", "projection", "switch")
    }


def values_of(model, values):
    return np.array([values[path] for path in model.parameters])


def matrix(e):
    w, x, y, z = e
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def quaternion(r):
    w = np.sqrt(1.0 + np.trace(r)) / 2.0
    return np.array(
        [
            w,
            (r[2, 1] - r[1, 2]) / (4 * w),
            (r[0, 2] - r[2, 0]) / (4 * w),
            (r[1, 0] - r[0, 1]) / (4 * w),
        ]
    )


def state(model, seed):
    """Any closed pose in motion, far from the design one."""
    random, n_q = np.random.default_rng(seed), len(model.coordinates)
    x = np.concatenate([model.start, np.zeros(len(model.speeds))])
    x[:n_q] += 0.02 * random.normal(size=n_q)
    x[n_q:] = 0.5 * random.normal(size=len(x) - n_q)
    x[[model.coordinates.index(name) for name in BODY]] = 0.05 * random.normal(size=3)
    u = 0.01 * random.normal(size=model.u.shape[0])
    for i, track in enumerate(model.tracks):
        if not track.endswith("road.z"):
            u[i * model.track_order] = 3.0 * random.normal()
    return x, u


def in_ground_axes(model, x, values):
    """Turn what is relative to the body in the shipped model (quaternions, spins, free uprights) into the twin's."""
    n_q = len(model.coordinates)
    pitch, roll = (x[model.coordinates.index(name)] for name in BODY[1:])
    pitching, rolling = (x[n_q + model.speeds.index(f"{name} rate")] for name in BODY[1:])
    about_y = np.array(
        [[np.cos(pitch), 0, np.sin(pitch)], [0, 1, 0], [-np.sin(pitch), 0, np.cos(pitch)]]
    )
    about_x = np.array(
        [[1, 0, 0], [0, np.cos(roll), -np.sin(roll)], [0, np.sin(roll), np.cos(roll)]]
    )
    spin = np.array([rolling, pitching * np.cos(roll), -pitching * np.sin(roll)])
    found = x.copy()
    for i, name in enumerate(model.coordinates):
        if name.endswith(".e0"):
            seen, k = matrix(x[i : i + 4]), n_q + model.speeds.index(f"{name[:-2]}wx")
            found[i : i + 4] = quaternion(about_y @ about_x @ seen)
            found[k : k + 3] += seen.T @ spin
        elif name.endswith(".x"):
            centre, place = np.array([0.0, 0.0, values["body.height"]]), design_place(name, values)
            k = n_q + model.speeds.index(f"{name} rate")
            arm = place + x[i : i + 3] - centre
            rise, rising = (0.0, 0.0, x[0]), (0.0, 0.0, x[n_q])
            found[i : i + 3] = about_y @ about_x @ arm + centre + rise - place
            found[k : k + 3] = about_y @ about_x @ (x[k : k + 3] + np.cross(spin, arm)) + rising
    return found


def design_place(coordinate, values):
    """Where a free body is counted from: an upright at its wheel centre, an arm at its centre of mass."""
    corner, body, _ = coordinate.split(".")
    end, side = corner.split("_")
    point = "hardpoints.wheel_centre" if body == "upright" else f"bodies.{body}.centre_of_mass"
    x, y, z = (values[f"{end}.corner.{point}[{i}]"] for i in range(3))
    ahead = (1 if end == "front" else -1) * values[f"{end}.distance"] - values[
        f"{end}.corner.hardpoints.wheel_centre[0]"
    ]
    return np.array([x + ahead, y if side == "left" else -y, z])


SOFT = {"stiffness": [1e6] * 3, "damping": [100.0] * 3, "rotational_stiffness": [20.0] * 3}
ARMS = ("lower_arm_front", "lower_arm_rear", "upper_arm_front", "upper_arm_rear")
CARS = {
    "bushings": jn.load("formula-student-car").with_changes(
        {"front.corner.bushings": dict.fromkeys(ARMS, SOFT)}
    ),
    "double wishbones": jn.load("formula-student-car"),
    "multi-link behind": jn.load("sedan-full-car-3d"),
    "radial tyres": jn.load("formula-student-car").with_changes(
        {"front.corner.tyre.law": "radial"}
    ),
}


@cache
def both(name):
    """Shipped model and twin of a car, with their functions."""
    models = build(CARS[name]), full_car_in_ground_axes(CARS[name])
    return *models, *map(functions, models)


def moving(shipped, twin, functions, vehicle, seed):
    """Arguments of both models in any motion with closed loops."""
    x, u = state(shipped, seed)
    modes, p, q = (
        np.ones(shipped.m.shape[0]),
        *(values_of(model, vehicle.parameters()) for model in (shipped, twin)),
    )
    for _ in range(6):
        x = functions["projection"](x, u, p, modes).full().ravel()[: len(x)]
    order = shipped.track_order
    inputs = np.concatenate(
        [u[shipped.tracks.index(track) * order :][:order] for track in twin.tracks]
    )
    return (x, u, p, modes), (in_ground_axes(shipped, x, vehicle.parameters()), inputs, q, modes)


@pytest.mark.parametrize("name", CARS)
@pytest.mark.parametrize("seed", range(3))
def test_accelerations_and_forces_agree_in_any_motion(name, seed):
    shipped, twin, one, other = both(name)
    assert shipped.coordinates == twin.coordinates
    assert shipped.speeds == twin.speeds
    here, there = moving(shipped, twin, one, CARS[name], seed)
    names = [output.name for output in shipped.outputs]
    found = one["output"](*here).full().ravel()
    wanted = other["output"](*there).full().ravel()
    wanted = wanted[[[output.name for output in twin.outputs].index(name) for name in names]]
    assert other["projection"](*there).full().ravel()[-2] < 1e-12  # closed there, too
    assert np.max(np.abs(found - wanted) / (1.0 + np.abs(wanted))) < AGREEMENT
    first = one["switch"](*here).full()
    second = other["switch"](*there).full()
    assert np.max(np.abs(first - second) / (1.0 + np.abs(second))) < AGREEMENT


@pytest.mark.parametrize("name", CARS)
@pytest.mark.some(2)
def test_reactions_and_hardpoints_agree_in_any_motion(name):
    """Forces and torques of all joints, of the four corners and of the body on its guide; kN in these motions."""
    shipped, twin = build(CARS[name], detail=True), full_car_in_ground_axes(CARS[name], detail=True)
    here, there = moving(shipped, twin, functions(shipped), CARS[name], 1)
    found, wanted = (
        {output.name: float(value) for output, value in zip(model.outputs, values, strict=True)}
        for model, values in (
            (model, functions(model)["output"](*given).full().ravel())
            for model, given in ((shipped, here), (twin, there))
        )
    )
    # The torque of a rack is given where its frame begins: the middle of the car on the road, or the body's centre.
    both = [name for name in found if name in wanted and ".rack.t" not in name]
    reactions = [
        name for name in both if name.rpartition(".")[2] in ("fx", "fy", "fz", "tx", "ty", "tz")
    ]
    assert len(reactions) > 4 * 6 * 6
    size = max(abs(wanted[name]) for name in reactions)
    assert size > 1e3
    assert max(abs(found[name] - wanted[name]) for name in reactions) < AGREEMENT * size
    places = [name for name in both if name.rpartition(".")[2] in ("x", "y", "z")]
    assert len(places) > 4 * 10
    assert max(abs(found[name] - wanted[name]) for name in places) < AGREEMENT


def test_code_with_corners_side_by_side_gives_what_the_graph_gives():
    vehicle = jn.load("formula-student-car")
    compiled, model = compile_rig(vehicle), build(vehicle)
    x, u = state(model, 5)
    p, modes = values_of(model, vehicle.parameters()), np.ones(model.m.shape[0])
    symbols = [model.x, model.u, model.p, model.m]
    for name in ("rate", "output", "switch", "constraint"):
        wanted = ca.Function(name, symbols, [getattr(model, name)])(x, u, p, modes).full().ravel()
        found = compiled.evaluate(name, x, u, p, modes)
        assert np.max(np.abs(found - wanted)) < 1e-12 * np.max(np.abs(wanted)), name
    slopes, small = compiled.slopes("x", x, u, p, modes), 1e-5
    for k in (1, 7, 20, 40):
        shift = np.eye(len(x))[k] * small
        ends = (compiled.evaluate("rate", x + way * shift, u, p, modes) for way in (1.0, -1.0))
        difference = np.subtract(*ends) / (2.0 * small)
        assert np.max(np.abs(slopes["rate"][:, k] - difference)) < 1e-5 * np.max(np.abs(difference))


def test_free_motion_without_dampers_keeps_its_energy():
    """Kinetic energy and height by the twin, springs and tyres by their forces; all of it is exchanged, none lost."""
    ways = [
        f"{end}.corner.strut.damper.{way}_coefficient"
        for end in ("front", "rear")
        for way in ("bump", "rebound")
    ]
    loose = dict.fromkeys(
        [*ways, *(f"{end}.corner.tyre.damping_coefficient" for end in ("front", "rear"))], 0.0
    )
    bars = {f"{end}.anti_roll_bar_rate": 0.0 for end in ("front", "rear")}
    vehicle = jn.load("formula-student-car").with_changes({**loose, **bars})
    compiled, twin = compile_rig(vehicle), full_car_in_ground_axes(vehicle)
    start = {"sprung.distance": 0.001, "attitude.angle": 0.001, "attitude.second_angle": 0.0015}
    offset = np.array([start.get(name, 0.0) for name in compiled.facts.states])
    p, times = compiled.parameter_values(vehicle.parameters()), np.linspace(0.0, 1.0, 101)
    still = [flat(1.0) for _ in compiled.facts.tracks]
    found = solve(compiled, p, still, times, tolerance=1e-10, offset=offset)
    rows = {name: i for i, name in enumerate(compiled.output_names)}
    corners = [
        (corner, getattr(vehicle, corner.split("_")[0]).corner) for corner in vehicle.corners
    ]
    assert min(found.outputs[rows[f"{corner}.tyre.force"]].min() for corner, _ in corners) > 0.0
    stored = np.zeros(len(times))
    for corner, rig in corners:
        stored += found.outputs[rows[f"{corner}.strut.force"]] ** 2 / (2.0 * rig.strut.spring.rate)
        stored += 0.5 * rig.tyre.stiffness * found.outputs[rows[f"{corner}.tyre.deflection"]] ** 2
    energy = in_twin(twin, vehicle, compiled, found.states, ("energy.kinetic", "energy.weight"))
    assert np.ptp(energy[0]) > 0.1
    assert np.ptp(stored + energy.sum(axis=0)) < 1e-7 * np.ptp(energy[0])


def in_twin(twin, vehicle, compiled, states, channels):
    """Outputs of the twin at states of the shipped model."""
    values, names = vehicle.parameters(), [output.name for output in twin.outputs]
    f, modes = functions(twin)["output"], np.ones(twin.m.shape[0])
    u, q = np.zeros(twin.u.shape[0]), values_of(twin, values)
    model = build(vehicle)
    each = [f(in_ground_axes(model, x, values), u, q, modes).full().ravel() for x in states.T]
    return np.array(each).T[[names.index(name) for name in channels]]
