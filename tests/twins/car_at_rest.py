"""Cars in static equilibrium under loads of driving, seen in detail: what tests of contact and of reactions share."""

from __future__ import annotations

import casadi as ca
import numpy as np
from scipy.optimize import root

from jounce.mechanics import Model
from jounce.models import build
from jounce.parts.rig import structure_of
from jounce.parts.vehicles import FullCar3D
from jounce.simulation.compiled import compile_rig
from jounce.simulation.statics import find_equilibrium


def at_rest(car: FullCar3D, **loads: float) -> dict[str, float]:
    """All channels of a car in static equilibrium under loads of driving (m/s^2, N m), or on roads of a height (m)."""
    compiled, values = compile_rig(car), car.parameters()
    u = compiled.inputs(loads)
    found = find_equilibrium(compiled, compiled.parameter_values(values), u)
    key = structure_of(car)
    if key not in _SEEN:  # as its graph gives them: code would take longer to make than to save
        model = build(car, detail=True)
        _SEEN[key] = (
            model,
            ca.Function("output", [model.x, model.u, model.p, model.m], [model.output]),
        )
    model, outputs = _SEEN[key]
    shown = (
        outputs(found.x, u, [values[path] for path in model.parameters], found.modes).full().ravel()
    )
    return {output.name: float(value) for output, value in zip(model.outputs, shown, strict=True)}


_SEEN: dict[str, tuple[Model, ca.Function]] = {}


def place(run, name: str) -> np.ndarray:
    return np.array([float(run[f"{name}.{axis}"]) for axis in "xyz"])


def force(run, name: str) -> np.ndarray:
    return np.array([float(run[f"{name}.f{axis}"]) for axis in "xyz"])


def body_centre(car: FullCar3D, run) -> np.ndarray:
    ahead, left = (float(run[f"body.{axis}"]) if f"body.{axis}" in run else 0.0 for axis in "xy")
    return np.array([ahead, left, car.body.height + float(run["body.z"])])


def without_weights(car: FullCar3D) -> FullCar3D:
    """The car with suspensions that weigh nothing to speak of, and no bars: load cases have none, either."""
    changes = {f"{end}.anti_roll_bar_rate": 0.0 for end in ("front", "rear")}
    for end in ("front", "rear"):
        for name, body in getattr(car, end).corner.body_masses().items():
            inertia = dict.fromkeys(("xx", "yy", "zz"), 1e-8)
            light = {"mass": 1e-6, "centre_of_mass": list(body.centre_of_mass), "inertia": inertia}
            changes[f"{end}.corner.bodies.{name}"] = light
    return car.with_changes(changes)


def seen_from_body(car: FullCar3D, run, point: np.ndarray) -> np.ndarray:
    """A place, m, in the axes of the body, as in the design pose; it pitches, then rolls about its own x axis."""
    (sp, cp), (sr, cr) = (
        (np.sin(a), np.cos(a)) for a in (float(run["body.pitch"]), float(run["body.roll"]))
    )
    about_y = np.array([[cp, 0.0, sp], [0.0, 1.0, 0.0], [-sp, 0.0, cp]])
    about_x = np.array([[1.0, 0.0, 0.0], [0.0, cr, -sr], [0.0, sr, cr]])
    return (about_y @ about_x).T @ (point - body_centre(car, run)) + [0.0, 0.0, car.body.height]


def loaded(car: FullCar3D, run, which: str):
    """Corner whose wheel has the radius that the run leaves it, its travel, its load (N) and the mass that it holds."""
    corner = getattr(car, which.partition("_")[0]).corner
    centre, contact = place(run, f"{which}.wheel_centre"), place(run, f"{which}.contact_point")
    radii = {
        "wheel.radius": float(np.linalg.norm(contact - centre)),
        "tyre.undeformed_radius": corner.undeformed_radius,
    }
    corner = corner.with_changes(radii)
    travel = seen_from_body(car, run, centre)[2] - corner.hardpoints.wheel_centre[2]
    loads = {name: float(run[f"{name}.tyre.force"]) for name in car.corners}
    hanging = [
        body.mass for axle in (car.front, car.rear) for body in axle.corner.body_masses().values()
    ]
    held = (car.body.mass + 2.0 * sum(hanging)) * loads[which] / sum(loads.values())
    return corner if which.endswith("left") else corner.mirrored(), travel, loads[which], held


def kept_level(car: FullCar3D, **roads: float) -> tuple[float, dict[str, float]]:
    """Lateral acceleration (m/s^2) that keeps a car level on roads of some heights, with a moment against its pitch."""

    def turned(given) -> dict[str, float]:
        return at_rest(
            car, lateral_acceleration=float(given[0]), pitch_moment=float(given[1]), **roads
        )

    def tilt(given) -> list[float]:
        run = turned(given)
        return [run["body.roll"], run["body.pitch"]]

    found = root(tilt, [0.0, 0.0], tol=1e-14).x
    run = turned(found)
    assert max(abs(run["body.roll"]), abs(run["body.pitch"])) < 1e-11
    return float(found[0]), run
