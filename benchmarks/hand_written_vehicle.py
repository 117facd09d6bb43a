"""A vehicle of nine bodies written by hand: a free body, and on each corner a lower arm, an upright and three rods."""

from __future__ import annotations

from typing import Any

import casadi as ca

import jounce as jn

CORNERS = {
    "front_left": (0.8, 1.0),
    "front_right": (0.8, -1.0),
    "rear_left": (-0.8, 1.0),
    "rear_right": (-0.8, -1.0),
}


def vehicle() -> jn.mechanics.Mechanism:
    car = jn.mechanics.Mechanism()
    body = car.body("body", 250.0, (0.0, 0.0, 0.35), (30.0, 90.0, 100.0))
    car.free("ride", body)
    for name, (ahead, side) in CORNERS.items():

        def at(
            x: float, y: float, z: float, ahead: float = ahead, side: float = side
        ) -> tuple[float, float, float]:
            return ahead + x, side * y, z

        arm = car.body(f"{name}.arm", 2.0, at(0.0, 0.4, 0.14), (0.02, 0.02, 0.03))
        car.revolute(f"{name}.pivot", body, arm, at=at(0.1, 0.25, 0.14), axis=(1.0, 0.0, 0.0))
        upright = car.body(f"{name}.upright", 9.0, at(0.0, 0.6, 0.25), (0.1, 0.15, 0.1))
        car.spherical(f"{name}.lower_ball", arm, upright, at=at(0.0, 0.58, 0.13))
        ball = at(-0.01, 0.55, 0.36)
        car.rod(f"{name}.upper_front", body, upright, at(0.12, 0.28, 0.33), ball)
        car.rod(f"{name}.upper_rear", body, upright, at(-0.12, 0.28, 0.33), ball)
        car.rod(f"{name}.tie_rod", body, upright, at(-0.08, 0.25, 0.17), at(-0.08, 0.57, 0.17))
        spring = {"stiffness": "45 N/mm", "damping": 1800, "free_length": "0.42 m"}
        _, force = car.spring_damper(
            f"{name}.strut", body, arm, at(0.0, 0.35, 0.5), at(0.0, 0.5, 0.15), **spring
        )
        hub = upright.point(at(0.0, 0.6, 0.25))
        depth = car.track(f"{name}.road").value + 0.255 - hub.value[2]
        load = car.switch(f"{name}.contact", depth) * 120e3 * depth
        car.apply_force(upright, ca.vertcat(0.0, 0.0, load), hub)
        car.output(f"{name}.tyre.force", load, "N", "contact force")
        car.output(f"{name}.strut.force", force, "N", "strut, compression positive")
        car.watch_body(upright)
    car.watch_body(body)
    car.watch_coordinates()
    return car


def setup() -> dict[str, Any]:
    bump = jn.mechanics.interpolated([0.5, 0.6, 0.7], [0.0, 0.02, 0.0], smooth=False)
    return {"motions": {f"{name}.road": bump for name in CORNERS}, "at_rest": True}


if __name__ == "__main__":
    run = jn.simulate_mechanism(vehicle(), "2 s", **setup())
    weight = 9.81 * (250.0 + 4 * 11.0)
    carried = sum(float(run[f"{name}.tyre.force"][0]) for name in CORNERS)
    assert abs(carried - weight) < 1e-3 * weight, (carried, weight)
