"""Force laws as graphs, held against the words of their descriptions."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

import jounce as jn
from jounce.mechanics import System, damper_map_force
from jounce.parts.elements import MapDamper

MAP = MapDamper(
    length=(0.30, 0.36, 0.45),
    velocity=(-0.8, -0.1, 0.2, 1.0),
    force=((-900.0, -400.0, 150.0, 500.0), (-700.0, -350.0, 60.0, 420.0), (-1200.0, -300.0, 200.0, 900.0)),
)


def law_of(damper: MapDamper):
    """The map's force over (length, velocity), with each switch on where its expression is positive."""
    system = System()
    length, velocity = system.coordinate("length"), system.coordinate("velocity")
    for place in (length, velocity):
        system.point_mass(ca.SX(1.0), place)
    system.output("force", damper_map_force(system, damper, "map", length, velocity), "N", "force")
    model = system.finish()
    where = [model.x, model.u, model.p, model.m]
    switches, force = (ca.Function("f", where, [graph]) for graph in (model.switch, model.output))
    flat = {f"map.length[{i}]": value for i, value in enumerate(damper.length)}
    flat |= {f"map.velocity[{j}]": value for j, value in enumerate(damper.velocity)}
    flat |= {f"map.force[{i}][{j}]": value for i, row in enumerate(damper.force) for j, value in enumerate(row)}
    p = ca.DM([flat[name] for name in model.parameters])

    def evaluate(place: float, speed: float) -> float:
        x = ca.DM([place, speed, 0.0, 0.0])
        m = switches(x, ca.DM(0, 1), p, ca.DM.zeros(len(model.switches))) > 0.0
        return float(force(x, ca.DM(0, 1), p, m))

    return evaluate


def test_a_damper_map_is_bilinear_between_its_points() -> None:
    law, rows, speeds, forces = law_of(MAP), np.array(MAP.length), np.array(MAP.velocity), np.array(MAP.force)
    for place in (0.25, 0.31, 0.36, 0.40, 0.44, 0.50):  # beyond the lengths the force stays
        for speed in (-1.5, -0.8, -0.45, 0.0, 0.15, 0.2, 0.7, 1.6):  # beyond the velocities it goes straight on
            j = int(np.clip(np.searchsorted(speeds, speed) - 1, 0, len(speeds) - 2))
            slope = (forces[:, j + 1] - forces[:, j]) / (speeds[j + 1] - speeds[j])
            expected = np.interp(place, rows, forces[:, j] + slope * (speed - speeds[j]))
            assert law(place, speed) == pytest.approx(expected, rel=1e-12, abs=1e-9)


@pytest.mark.parametrize(("end", "place", "side"), [("lower", -0.12, 1.0), ("upper", 0.23, -1.0)])
@pytest.mark.parametrize("rate", [-3.0, -0.5, 0.0, 0.5, 3.0])
def test_a_stop_pushes_and_never_pulls(end: str, place: float, side: float, rate: float) -> None:
    mechanism = jn.mechanics.Mechanism()
    sled = mechanism.body("sled", 2.0, (0.0, 0.0, 0.0), (0.1, 0.1, 0.1))
    along = mechanism.prismatic("rail", mechanism.ground, sled, axis=(1.0, 0.0, 0.0))
    stop = mechanism.stop("stop", along, stiffness=5000.0, damping=200.0, **{end: -0.1 if end == "lower" else 0.2})
    mechanism.output("stop.force", stop, "N", "force of the stop")
    start = {"rail.distance": place, "rail.distance rate": rate}
    run = jn.simulate_mechanism(mechanism, 1e-3, start=start, output_step=1e-3)
    depth = 0.02 if end == "lower" else 0.03
    push = 5000.0 * depth - side * 200.0 * rate  # spring and damper; pulling back what leaves is cut off
    assert float(run["stop.force"][0]) == pytest.approx(side * max(push, 0.0), rel=1e-9)
