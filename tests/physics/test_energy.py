"""Energy: what goes in at the road is stored or dissipated, and nothing else happens."""

from __future__ import annotations

import numpy as np
import pytest

from jounce import parts
from jounce.core.segments import flat
from jounce.models import build
from jounce.roads import HalfSine, Versine
from jounce.simulation.compiled import compile_model
from jounce.simulation.prepare import solve
from jounce.simulation.settings import output_times

KART = parts.load("kart-quarter-car")
UNDAMPED = KART.with_changes({"strut.damper.coefficient": 0.0})


def run(rig, road, duration, *, step=2e-5, tolerance=1e-9, offset=None):
    compiled = compile_model(build(rig))
    p, times = compiled.parameter_values(rig.parameters()), output_times(duration, step)
    solution = solve(compiled, p, road, times, tolerance=tolerance, offset=offset)
    assert solution.status.name == "COMPLETED"
    return times, dict(zip(compiled.output_names, solution.outputs, strict=True))


def stored(rig, out):
    """Kinetic energy, weight, spring (with preload) and the compressed tyre, J."""
    deflection = out["tyre.deflection"]
    tyre = np.maximum(deflection, 0.0) if rig.tyre.lift_off else deflection
    strut = out["strut.deflection"]
    return (
        0.5 * rig.sprung.mass * out["sprung.vz"] ** 2
        + 0.5 * rig.unsprung.mass * out["unsprung.vz"] ** 2
        + rig.gravity * (rig.sprung.mass * out["sprung.z"] + rig.unsprung.mass * out["unsprung.z"])
        + 0.5 * rig.strut.spring.rate * strut**2
        + rig.strut.spring.preload * strut
        + 0.5 * rig.tyre.stiffness * tyre**2
    )


@pytest.mark.parametrize("lift_off", [False, True])
@pytest.mark.parametrize("drop", [0.001, 0.02])
def test_undamped_energy_is_conserved(lift_off, drop):
    """10 s of free motion, with a drop of 20 mm also flying and landing some fifty times."""
    rig = UNDAMPED.with_changes({"tyre.lift_off": lift_off, "strut.spring.preload": 30.0})
    _, out = run(rig, flat(10.0), 10.0, step=1e-2, offset=np.array([drop, drop, 0.0, 0.0]))
    energy = stored(rig, out)
    exchanged = np.ptp(0.5 * rig.sprung.mass * out["sprung.vz"] ** 2)
    assert np.max(np.abs(energy - energy[0])) < 1e-6 * exchanged
    assert exchanged > 1e-4


@pytest.mark.parametrize(
    "changes",
    [
        {},
        {"strut.damper": {"bump_coefficient": 80.0, "rebound_coefficient": 240.0}},
        {
            "strut.friction": {"force": 12.0},
            "guide.friction": {"force": 6.0, "regularisation_velocity": 0.005},
        },
        {"tyre.lift_off": False},
        {"strut.damper.coefficient": 0.0},
    ],
    ids=["linear damper", "bilinear", "friction", "no lift-off", "undamped"],
)
@pytest.mark.parametrize("shape", [HalfSine, Versine])
def test_balance(changes, shape):
    """Work of the road = change of the stored energy + damper, strut friction and guide friction, at all times."""
    rig = KART.with_changes({"strut.spring.preload": 30.0, **changes})
    segments = (
        shape(height=0.01, length=0.06, start=0.1).segments(3.0).in_time(2.0)
    )  # edges on samples
    times, out = run(rig, segments, 0.6)
    strut = (
        out["strut.force"]
        - rig.strut.spring.rate * out["strut.deflection"]
        - rig.strut.spring.preload
    )
    guide = np.zeros_like(times)
    if rig.guide.friction is not None:
        speed = out["sprung.vz"]
        guide = (
            rig.guide.friction.force
            * np.tanh(speed / rig.guide.friction.regularisation_velocity)
            * speed
        )
    lost = strut * out["strut.velocity"] + guide
    assert lost.min() > -1e-9
    energy = stored(rig, out)
    road = work_of_the_road(segments, times, out["tyre.force"])
    dissipated = cumulative_trapezoid(lost, times)
    balance = energy - energy[0] + dissipated - road
    scale = np.ptp(energy)
    assert np.max(np.abs(balance)) < 3e-5 * scale  # trapezoids of 0.02 ms over kinks
    assert np.max(np.abs(balance - 0.01 * dissipated)) > 3e-4 * scale or dissipated[
        -1
    ] == pytest.approx(0.0, abs=1e-9)


def work_of_the_road(segments, times, force):
    """Integral of force times rate of height; the rate may jump at a sample, so each interval has its own ends."""
    after, before = (segments.evaluate(times + shift)[1] for shift in (1e-9, -1e-9))
    pieces = 0.5 * (force[:-1] * after[:-1] + force[1:] * before[1:]) * np.diff(times)
    return np.concatenate([[0.0], np.cumsum(pieces)])


def cumulative_trapezoid(y, x):
    """Integral from the first point on."""
    return np.concatenate([[0.0], np.cumsum(0.5 * (y[1:] + y[:-1]) * np.diff(x))])


def test_tyre_damping_only_takes_energy():
    rig = KART.with_changes({"strut.damper.coefficient": 0.0, "tyre.damping_coefficient": 60.0})
    times, out = run(rig, flat(3.0), 2.0, step=2e-5, offset=np.array([0.02, 0.02, 0.0, 0.0]))
    energy = stored(rig, out)
    assert out["tyre.force"].min() == 0.0
    assert np.max(np.diff(energy)) < 1e-9 * np.ptp(energy)
    assert energy[-1] < 0.9 * energy[0] + 0.1 * energy.min()
    elastic = rig.tyre.stiffness * np.maximum(out["tyre.deflection"], 0.0)
    taken = cumulative_trapezoid((out["tyre.force"] - elastic) * -out["unsprung.vz"], times)
    assert np.max(np.abs(energy - energy[0] + taken)) < 1e-4 * np.ptp(energy)


def test_undamped_rise_over_a_bump_gives_back_its_energy_in_motion():
    """The road's work is found in the motion afterwards, to the tolerance."""
    segments = HalfSine(height=0.01, length=0.06, start=0.1).segments(3.0).in_time(2.0)
    times, out = run(UNDAMPED, segments, 0.5, step=5e-6, tolerance=1e-10)
    work = work_of_the_road(segments, times, out["tyre.force"])[-1]
    gained = stored(UNDAMPED, out)
    after = gained[times > segments.edges[2]]
    assert np.ptp(after) < 1e-7 * work
    assert after.mean() - gained[0] == pytest.approx(work, rel=1e-5)
    assert work > 0.01
