"""The implicit method: its order, its accuracy where the problem is stiff, and the energy of what it integrates."""

from __future__ import annotations

import casadi
import numpy as np
import pytest

from jounce import parts
from jounce.core.segments import SINE, Segments, flat
from jounce.kernel.engine import Control, Problem, Status, flatten
from jounce.kernel.methods.implicit import integrate
from jounce.mechanics import System
from jounce.models import build
from jounce.roads import HalfSine
from jounce.simulation.compiled import compile_model
from jounce.simulation.linear_systems import slopes_of
from jounce.simulation.prepare import room, solve
from jounce.simulation.settings import output_times

KART = parts.load("kart-quarter-car")
LOOSE = 1e30  # a tolerance that every step meets: the step is then the longest one allowed


def wave(amplitude, frequency, duration):
    return Segments(
        np.array([0.0, duration]), np.array([SINE]), np.array([[0.0, amplitude, frequency, 0.3]])
    )


def run(model, values, x0, times, *, track=None, tolerance=LOOSE, longest=np.inf, scale=1.0):
    """States (n, samples) and counts of steps."""
    compiled = compile_model(model)
    tracks = flatten([track or flat(times[-1])])
    piece = tracks.first[:-1].copy() if model.tracks else tracks.first[:0].copy()
    p, start = compiled.extend(np.array(values, dtype=float)), np.array(x0, dtype=float)
    problem = Problem(
        compiled.engine, tracks, piece, p, np.zeros(0), start, len(model.tracks) * model.track_order
    )
    control = Control(tolerance, np.full(len(x0), scale), np.zeros(0), 1_000_000, longest)
    out, counts = room(compiled, times), np.zeros(3, dtype=np.int64)
    assert (
        Status.of(integrate(problem, slopes_of(compiled), control, out, counts)) is Status.COMPLETED
    )
    return out.states, counts


def driven_pendulum():
    system = System()
    drive, angle = system.track("drive"), system.coordinate("angle")
    system.point_mass(casadi.SX(1.0), angle)
    torque = -4.0 * casadi.sin(angle) + 2.0 * drive.value + 0.3 * drive.rate * casadi.cos(angle)
    system.force(angle, torque - 0.2 * system.rate_of(angle) * angle**2)
    system.output("angle", angle, "rad", "angle")
    return system.finish()


def test_order_is_five_and_samples_lose_one():
    """Fixed steps over a driven pendulum, whose input moves within them: the time derivative counts as well."""
    model, track = driven_pendulum(), wave(1.0, 3.0, 4.0)
    times, ends = np.linspace(0.0, 4.0, 401), slice(0, None, 40)
    reference, _ = run(model, [], [0.5, 0.0], times, track=track, longest=1e-3)
    steps = 0.1 * 0.5 ** np.arange(4)
    errors = [
        np.abs(run(model, [], [0.5, 0.0], times, track=track, longest=h)[0] - reference)[0]
        for h in steps
    ]
    at_end = [error[-1] for error in errors]
    inside = [error.max() for error in errors]
    assert np.polyfit(np.log(steps), np.log(at_end), 1)[0] == pytest.approx(5.0, abs=0.4)
    assert np.polyfit(np.log(steps), np.log(inside), 1)[0] == pytest.approx(5.0, abs=0.7)
    assert at_end[-1] < 1e-7
    assert np.max(errors[0][ends]) < 1e-2


def follower():
    """``z' = -rate (z - drive) + drive'``: its solution is the drive itself (Prothero and Robinson's test)."""
    system = System()
    drive = system.track("drive")
    system.point_mass(casadi.SX(1.0), system.coordinate("idle"))
    z = system.internal_state("z")
    system.set_internal_rate("z", -system.parameter("rate") * (z - drive.value) + drive.rate)
    system.output("z", z, "m", "follower")
    return system.finish()


@pytest.mark.parametrize("rate", [1.0, 1e2, 1e4, 1e6, 1e8])
def test_stiffness_does_not_spoil_the_order(rate):
    """The method was made to keep order 4 there, where others fall to 1 or 2; at the ends of the steps."""
    model, track, times = follower(), wave(1.0, 2.0, 3.0), np.array([0.0, 3.0])
    truth, _ = track.evaluate(times)
    steps = 0.1 * 0.5 ** np.arange(5)
    errors = []
    for h in steps:
        states, _ = run(model, [rate], [0.0, 0.0, truth[0]], times, track=track, longest=h)
        errors.append(max(abs(states[2, -1] - truth[-1]), 1e-15))
    floor = 1e-13
    kept = [(h, error) for h, error in zip(steps, errors, strict=True) if error > floor]
    assert errors[0] < 1e-4
    assert errors[-1] < 1e-9
    if len(kept) > 2:
        assert np.polyfit(*np.log(np.array(kept)).T, 1)[0] > 3.5


def test_van_der_pol():
    """``y'' = 1000 (1 - y^2) y' - y`` to t = 2000.

    Reference: F. Mazzia, C. Magherini, Test Set for Initial Value Problem Solvers, release 2.4 (2008), problem VDPOL,
    whose time is ours over 1000: y(2) = 0.1706167732170483e1, y'(2) = -0.8928097010247975e0.
    """
    system = System()
    y = system.coordinate("y")
    system.point_mass(casadi.SX(1.0), y)
    system.force(y, 1000.0 * (1.0 - y**2) * system.rate_of(y) - y)
    system.output("y", y, "m", "deflection")
    model, times = system.finish(), np.array([0.0, 2000.0])
    wanted = np.array([1.706167732170483, -0.8928097010247975e-3])
    for tolerance in (1e-5, 1e-7, 1e-9):
        states, counts = run(model, [], [2.0, 0.0], times, tolerance=tolerance, scale=1e-3)
        assert np.max(np.abs(states[:, -1] / wanted - 1.0)) < 30.0 * tolerance
        assert counts[0] < 4000


@pytest.mark.parametrize("lift_off", [False, True])
@pytest.mark.parametrize("friction", [None, {"force": 12.0}])
def test_tolerance_is_met(lift_off, friction):
    """Displacements of the quarter car, also across contact and friction, against the explicit method."""
    rig = KART.with_changes({"tyre.lift_off": lift_off, "strut.friction": friction})
    compiled, road = (
        compile_model(build(rig)),
        HalfSine(height=0.01, length=0.06, start=0.1).segments(3.0).in_time(2.86),
    )
    p, times = compiled.parameter_values(rig.parameters()), output_times(0.8, 1e-3)
    reference = solve(compiled, p, road, times, tolerance=1e-11, method="explicit").states[:2]
    for tolerance in (1e-4, 1e-6, 1e-8):
        found = solve(compiled, p, road, times, tolerance=tolerance, method="implicit")
        assert found.method == "implicit"
        error = np.max(np.abs(found.states[:2] - reference), axis=1) / np.ptp(reference, axis=1)
        assert np.all(error < tolerance), (tolerance, error)


def test_energy_is_kept_where_nothing_takes_it():
    """10 s of free oscillation without damper: an L-stable method takes some, as little as the tolerance says."""
    rig = KART.with_changes({"strut.damper.coefficient": 0.0})
    compiled, times = compile_model(build(rig)), output_times(10.0, 1e-2)
    p, start = compiled.parameter_values(rig.parameters()), np.array([0.001, 0.001, 0.0, 0.0])
    losses = []
    for tolerance in (1e-6, 1e-8):
        found = solve(
            compiled, p, flat(10.0), times, tolerance=tolerance, method="implicit", offset=start
        )
        out = dict(zip(compiled.output_names, found.outputs, strict=True))
        kinetic = (
            0.5 * rig.sprung.mass * out["sprung.vz"] ** 2
            + 0.5 * rig.unsprung.mass * out["unsprung.vz"] ** 2
        )
        weight = rig.gravity * (
            rig.sprung.mass * out["sprung.z"] + rig.unsprung.mass * out["unsprung.z"]
        )
        springs = 0.5 * rig.strut.spring.rate * out["strut.deflection"] ** 2
        springs += 0.5 * rig.tyre.stiffness * out["tyre.deflection"] ** 2
        energy = kinetic + weight + springs
        losses.append(np.max(np.abs(energy - energy[0])) / np.ptp(kinetic))
    assert losses[0] < 3e-5
    assert losses[1] < 0.05 * losses[0]
