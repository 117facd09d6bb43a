"""Balance of moments about the road: tyre loads at the contact points against weights and inertia of all masses."""

from __future__ import annotations

import sys
from functools import cache

import casadi as ca
import numpy as np
import pytest

import jounce as jn
from jounce.models.full_car_3d import full_car_3d
from jounce.simulation.compiled import compile_model
from jounce.simulation.statics import find_equilibrium

AXES = "xyz"
LAWS = ("vertical", "radial")
CARS = {
    "formula student": lambda: jn.load("formula-student-car"),
    "sedan": lambda: jn.load("sedan-full-car-3d"),
    # level arms of one length: its wheels lean as its body does
    "kart": lambda: jn.load("kart-whole-vehicle").with_changes({"body.joint": None}),
}


@cache
def watched(name, law):
    """A car, its compiled model and its masses by channel: mass centres, wheel centres and wheel axes can be seen."""
    car = CARS[name]()
    car = car.with_changes({f"{end}.corner.tyre.law": law for end in ("front", "rear")})
    written = sys.modules[full_car_3d.__module__]
    show_wheel = written.show_wheel

    def show(linkage):
        show_wheel(linkage)
        carrier = linkage.carrier
        parts = {part: (body, body.mass_properties) for part, body in linkage.carriers.items()}
        places = {f"{part}.at": body.frame.point(own.centre).value for part, (body, own) in parts.items() if own}
        places["hub.at"] = linkage.wheel_centre.value
        seen = {part: carrier.placed(place) for part, place in places.items()}
        seen["spin.at"] = carrier.outward(linkage.spin_direction.value)
        for part, place in seen.items():
            for axis, value in zip(AXES, ca.vertsplit(place), strict=True):
                linkage.mechanism.output(f"{part}.{axis}", value, "m", part)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(written, "show_wheel", show)
        model = full_car_3d(car)
    return car, compile_model(model)


def rest(name, law, **loads):
    """Channels of a car at rest under constant loads."""
    car, compiled = watched(name, law)
    p, u = compiled.parameter_values(car.parameters()), compiled.inputs(loads)
    found = find_equilibrium(compiled, p, u)
    outputs = compiled.evaluate("output", found.x, u, p, found.modes)
    return car, dict(zip(compiled.output_names, outputs, strict=True))


def place(found, name):
    return np.array([found[f"{name}.{axis}"] for axis in AXES])


def contact(found, corner, law):
    """Where the plane of a wheel meets the level road below its centre, and the push of the tyre there."""
    hub, axis = place(found, f"{corner}.hub.at"), place(found, f"{corner}.spin.at")
    flat, lean, force = axis[:2] / np.linalg.norm(axis[:2]), np.arcsin(axis[2]), found[f"{corner}.tyre.force"]
    at = np.array([*(hub[:2] + hub[2] * np.tan(lean) * flat), 0.0])
    return at, force * ((hub - at) / np.linalg.norm(hub - at) if law == "radial" else np.array([0.0, 0.0, 1.0]))


def unbalanced(car, found, law, drive):
    """Force (N) and moment (N m) about the origin that nothing holds but the guide, ground axes."""
    field, weights = np.array([*drive, -car.gravity]), []
    weights.append((car.body.mass, np.array([0.0, 0.0, car.body.height + found["body.z"]])))
    for corner in car.corners:
        bodies = getattr(car, corner.partition("_")[0]).corner.body_masses().items()
        weights += [(body.mass, place(found, f"{corner}.{part}.at")) for part, body in bodies]
    contacts = [contact(found, corner, law) for corner in car.corners]
    pushed, mass = sum(push for _, push in contacts), sum(one for one, _ in weights)
    along = -(mass * field + pushed) * [1.0, 1.0, 0.0]  # what is left for the road to hold, by shares of the load
    acting = [(at, push + along * push[2] / pushed[2]) for at, push in contacts]
    acting += [(at, one * field) for one, at in weights]
    return sum(force for _, force in acting), sum(np.cross(at, force) for at, force in acting)


LOADS = {
    "level": {},
    "a little to the left": {"lateral_acceleration": 0.1},
    "leaning": {"lateral_acceleration": 5.0},
    "braking": {"deceleration": 4.0},
    "both, on the right": {"deceleration": 3.0, "lateral_acceleration": -4.0},
}


@pytest.mark.parametrize("loads", LOADS)
@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("name", CARS)
def test_moments_about_the_road_balance(name, law, loads):
    drive = LOADS[loads]
    car, found = rest(name, law, **drive)
    given = (drive.get("deceleration", 0.0), -drive.get("lateral_acceleration", 0.0))
    force, moment = unbalanced(car, found, law, given)
    small, pitch = 1e-9 * car.body.mass * car.gravity, found["body.pitch"]
    assert np.max(np.abs(force)) < small
    assert abs(moment[1]) < small
    assert abs(moment @ [np.cos(pitch), 0.0, -np.sin(pitch)]) < small  # about the body's x axis
    if law == "vertical":
        assert abs(moment[2]) < small  # the guide has to hold nothing
    if "lateral_acceleration" in drive:
        assert abs(found["body.roll"]) > 1e-4
