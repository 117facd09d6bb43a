"""Time runs of the linear quarter car against its transfer functions, invariants, limits and static forms.

Formulas: equations of motion of the two-mass model without tyre damping,
D(s) = ms mu s^4 + M c s^3 + (M k + ms kt) s^2 + c kt s + k kt, with M = ms + mu, k and c at the wheel.
"""

from __future__ import annotations

import numpy as np
import pytest

from jounce import parts
from jounce.core.segments import SINE, Segments, flat, piecewise_linear
from jounce.models import build
from jounce.simulation import equilibrium, linearise, modes
from jounce.simulation.compiled import compile_model
from jounce.simulation.prepare import solve
from jounce.simulation.settings import output_times

KART = parts.load("kart-quarter-car")
LINEAR = KART.with_changes({"tyre.lift_off": False})
TANH = {
    "strut.damper": {
        "kind": "tanh",
        "coefficient": 60.0,
        "force": 10.0,
        "slope": 20.0,
        "displacement_coupling": 2.0,
    }
}


def shaken(frequency: float, amplitude: float, duration: float) -> Segments:
    """Base that starts to move as a sine at time 0."""
    wave = np.array([[0.0, amplitude, 2 * np.pi * frequency, 0.0]])
    return Segments(np.array([0.0, duration]), np.array([SINE]), wave)


def run(rig, road, duration, *, step=1e-3, tolerance=1e-9, offset=None):
    compiled = compile_model(build(rig))
    p, times = compiled.parameter_values(rig.parameters()), output_times(duration, step)
    solution = solve(compiled, p, road, times, tolerance=tolerance, offset=offset)
    assert solution.status.name == "COMPLETED"
    return times, dict(zip(compiled.output_names, solution.outputs, strict=True))


def harmonic(times, signal, frequency):
    """Complex amplitude at a frequency over a whole number of periods (the last samples), relative to a sine."""
    period = round(1.0 / (frequency * (times[1] - times[0])))
    count = (len(times) // (2 * period)) * period
    t, y = times[-count:], signal[-count:]
    return 2j * np.mean((y - y.mean()) * np.exp(-2j * np.pi * frequency * t))


def transfer(rig, frequency):
    """Closed forms zs/zr, zu/zr, (zs - zu)/zr."""
    ms, mu, kt = rig.sprung.mass, rig.unsprung.mass, rig.tyre.stiffness
    cos2 = np.cos(rig.strut.angle) ** 2
    k, c, total, s = (
        cos2 * rig.strut.spring.rate,
        cos2 * rig.strut.damper.coefficient,
        ms + mu,
        2j * np.pi * frequency,
    )
    d = ms * mu * s**4 + total * c * s**3 + (total * k + ms * kt) * s**2 + c * kt * s + k * kt
    return kt * (c * s + k) / d, kt * (ms * s**2 + c * s + k) / d, -ms * kt * s**2 / d


@pytest.mark.parametrize("lift_off", [False, True], ids=["exact propagation", "adaptive steps"])
@pytest.mark.parametrize("frequency", [1.0, 4.0, 5.0, 12.5, 25.0])
def test_transfer_functions(frequency, lift_off):
    rig = KART.with_changes({"tyre.lift_off": lift_off})
    amplitude = 2e-5  # small: the tyre, 1.5 mm deep at rest, keeps contact
    times, out = run(rig, shaken(frequency, amplitude, 8.0), 8.0)
    assert out["tyre.force"].min() > 0.0
    body, wheel, strut = transfer(rig, frequency)
    assert harmonic(times, out["sprung.z"], frequency) / amplitude == pytest.approx(body, rel=2e-6)
    assert harmonic(times, out["unsprung.z"], frequency) / amplitude == pytest.approx(
        wheel, rel=2e-6
    )
    relative = harmonic(times, out["strut.deflection"], frequency) / -np.cos(rig.strut.angle)
    assert relative / amplitude == pytest.approx(strut, rel=2e-6)
    acceleration = harmonic(times, out["sprung.az"], frequency) / -((2 * np.pi * frequency) ** 2)
    assert acceleration / amplitude == pytest.approx(body, rel=2e-6)


@pytest.mark.parametrize("frequency", [0.5, 5.1, 28.0])
def test_frequency_response_of_the_linear_model(frequency):
    found = [
        linearise(KART).frequency_response([frequency], name)[0]
        for name in ("sprung.z", "unsprung.z")
    ]
    assert found == pytest.approx(transfer(KART, frequency)[:2], rel=1e-9)


@pytest.mark.parametrize(
    "damper", [{}, {"strut.damper.coefficient": 30.0}, TANH], ids=["as built", "soft", "tanh"]
)
def test_invariant_of_the_body_acceleration(damper):
    """At sqrt(kt/mu) it is +kt/ms times the road, whatever acts between the masses (Hedrick and Butsuen 1990)."""
    rig = LINEAR.with_changes({"unsprung.mass": 138468.0 / (2 * np.pi * 25.0) ** 2, **damper})
    amplitude = 1e-3
    times, out = run(
        rig, shaken(25.0, amplitude, 20.0), 20.0, step=2e-4
    )  # a nonlinear damper's overtones alias
    found = harmonic(times, out["sprung.az"], 25.0) / amplitude
    assert found == pytest.approx(138468.0 / 16.0, rel=1e-5)


@pytest.mark.parametrize(
    "damper", [{}, {"strut.damper.coefficient": 30.0}, TANH], ids=["as built", "soft", "tanh"]
)
def test_invariant_of_the_suspension_deflection(damper):
    """At sqrt(kt/M) its amplitude is M/ms that of the road."""
    total = 138468.0 / (2 * np.pi * 12.5) ** 2
    rig = LINEAR.with_changes({"sprung.mass": total - 5.0, **damper})
    amplitude = 1e-3
    times, out = run(rig, shaken(12.5, amplitude, 30.0), 30.0)
    found = (
        abs(harmonic(times, out["strut.deflection"], 12.5)) / np.cos(rig.strut.angle) / amplitude
    )
    assert found == pytest.approx(total / (total - 5.0), rel=1e-5)


@pytest.mark.parametrize("ratio", [0.5, 1.0, np.sqrt(2.0), 3.0])
def test_one_mass_on_a_moving_base(ratio):
    """A stiff tyre and a light wheel leave T = sqrt((1 + (2 z r)^2) / ((1 - r^2)^2 + (2 z r)^2)); T = 1 at sqrt(2)."""
    frequency = 5.0
    natural = 2 * np.pi * frequency / ratio
    stiffness, zeta = 16.0 * natural**2, 0.2
    rig = LINEAR.with_changes(
        {
            "strut.angle": 0.0,
            "strut.spring.rate": stiffness,
            "strut.damper.coefficient": 2 * zeta * natural * 16.0,
            "unsprung.mass": 1e-4,
            "tyre.stiffness": 1e10,
        }
    )
    times, out = run(rig, shaken(frequency, 1e-3, 12.0), 12.0)
    found = abs(harmonic(times, out["sprung.z"], frequency)) / 1e-3
    part = (2 * zeta * ratio) ** 2
    assert found == pytest.approx(np.sqrt((1 + part) / ((1 - ratio**2) ** 2 + part)), rel=1e-4)
    if ratio == np.sqrt(2.0):
        assert found == pytest.approx(1.0, rel=1e-4)


def test_free_decay_of_one_mass():
    """Peaks of a side fall by exp(-2 pi zeta / sqrt(1 - zeta^2)) a cycle; between them lies the damped period."""
    stiffness, zeta = 18362.0, 0.15
    natural = np.sqrt(stiffness / 16.0)
    rig = LINEAR.with_changes(
        {
            "strut.angle": 0.0,
            "strut.spring.rate": stiffness,
            "strut.damper.coefficient": 2 * zeta * natural * 16.0,
            "unsprung.mass": 1e-4,
            "tyre.stiffness": 1e10,
        }
    )
    times, out = run(rig, flat(2.0), 1.0, offset=np.array([0.02, 0.0, 0.0, 0.0]), step=1e-4)
    z = out["sprung.z"] + 16.0 * 9.81 / stiffness + 16.0001 * 9.81 / 1e10
    damped = natural * np.sqrt(1 - zeta**2)
    expected = (
        0.02
        * np.exp(-zeta * natural * times)
        * (np.cos(damped * times) + zeta * natural / damped * np.sin(damped * times))
    )
    assert np.max(np.abs(z - expected)) < 2e-5 * 0.02  # the tyre's own give


def test_superposition():
    """The linear model answers the sum of two roads with the sum of its answers."""
    generator = np.random.default_rng(3)
    x = np.linspace(0.0, 1.0, 41)
    first, second = (np.cumsum(generator.normal(0.0, 1e-3, 41)) * (x > 0.05) for _ in range(2))
    answers = []
    for height in (first, second, 2.0 * first - 3.0 * second):
        _, out = run(LINEAR, piecewise_linear(x, height), 1.0)
        answers.append(out["sprung.z"] - out["sprung.z"][0])
    a, b, both = answers
    assert np.max(np.abs(both - (2.0 * a - 3.0 * b))) < 1e-10 * np.max(np.abs(both))
    assert np.max(np.abs(both - (2.0 * a - 2.9 * b))) > 1e-3 * np.max(np.abs(both))


def test_lift_off_breaks_superposition():
    x = np.array([0.0, 0.1, 0.13, 0.16, 1.0])
    single = run(KART, piecewise_linear(x, np.array([0.0, 0.0, 0.01, 0.0, 0.0])), 1.0)[1][
        "sprung.z"
    ]
    double = run(KART, piecewise_linear(x, np.array([0.0, 0.0, 0.02, 0.0, 0.0])), 1.0)[1][
        "sprung.z"
    ]
    difference = np.abs(double - double[0] - 2.0 * (single - single[0]))
    assert difference.max() > 0.01 * np.ptp(double)


@pytest.mark.parametrize("angle", [0.0, np.radians(10.0), np.radians(26.0)])
@pytest.mark.parametrize("preload", [0.0, 80.0, 300.0])
def test_static_equilibrium(angle, preload):
    """Tyre: M g / kt. Strut along its axis: (ms g / cos - preload) / rate."""
    rig = KART.with_changes({"strut.angle": angle, "strut.spring.preload": preload})
    found, cos = equilibrium(rig, road_height=0.02), np.cos(angle)
    tyre, strut = 21.0 * 9.81 / 138468.0, (16.0 * 9.81 / cos - preload) / 22730.0
    assert found["tyre.deflection"] == pytest.approx(tyre, rel=1e-12)
    assert found["tyre.force"] == pytest.approx(206.01, rel=1e-12)
    assert found["strut.deflection"] == pytest.approx(strut, rel=1e-10)
    assert found["strut.force"] == pytest.approx(16.0 * 9.81 / cos, rel=1e-12)
    assert found["sprung.z"] == pytest.approx(0.02 - tyre - strut / cos, rel=1e-10)
    assert found["sprung.az"] == pytest.approx(0.0, abs=1e-10)


def test_static_equilibrium_on_a_closed_stop():
    """rate d + stop (d - gap) + progression (d - gap)^3 carries ms g: the cubic's real root."""
    rig = KART.with_changes(
        {"strut.angle": 0.0, "strut.bump_stop": {"gap": 0.003, "rate": 6e4, "progression": 3e9}}
    )
    roots = np.roots([3e9, 0.0, 22730.0 + 6e4, 22730.0 * 0.003 - 16.0 * 9.81])
    depth = roots[np.abs(roots.imag) < 1e-9].real.item()
    assert depth > 0.0
    assert equilibrium(rig)["strut.deflection"] == pytest.approx(0.003 + depth, rel=1e-10)


def test_modes_are_the_roots_of_the_characteristic_polynomial():
    ms, mu, kt, cos2 = 16.0, 5.0, 138468.0, np.cos(np.radians(26.0)) ** 2
    k, c = cos2 * 22730.0, cos2 * 150.0
    roots = np.roots([ms * mu, 21.0 * c, 21.0 * k + ms * kt, c * kt, k * kt])
    expected = sorted(abs(root) / (2 * np.pi) for root in roots if root.imag > 0)
    assert [mode.frequency_hz for mode in modes(KART)] == pytest.approx(expected, rel=1e-10)
    for mode in modes(KART):
        value = min(roots, key=lambda root: abs(abs(root) / (2 * np.pi) - mode.frequency_hz))
        assert mode.damping_ratio == pytest.approx(-value.real / abs(value), rel=1e-9)


@pytest.mark.parametrize("kind", ["two coefficients", "table", "with dry friction"])
def test_modes_of_a_damper_with_two_sides_decay_as_it_does(kind):
    """Each half swing of one mass decays by exp(-pi zeta / sqrt(1 - zeta^2)) of its side; friction takes no ratio."""
    zetas, stiffness = (0.05, 0.15), 18362.0
    bump, rebound = (2 * zeta * np.sqrt(stiffness * 16.0) for zeta in zetas)
    changes = {
        "strut.angle": 0.0,
        "strut.spring.rate": stiffness,
        "strut.damper": {"bump_coefficient": bump, "rebound_coefficient": rebound},
        "unsprung.mass": 1e-4,
        "tyre.stiffness": 1e10,
    }
    if kind == "table":
        changes["strut.damper"] = {"velocity": [-1.0, 0.0, 1.0], "force": [-rebound, 0.0, bump]}
    if kind == "with dry friction":
        changes["strut.friction"] = {"force": 30.0}
    body = modes(KART.with_changes(changes))[0]
    decrement = sum(np.pi * zeta / np.sqrt(1 - zeta**2) for zeta in zetas)
    assert 2 * np.pi * body.damping_ratio / np.sqrt(1 - body.damping_ratio**2) == pytest.approx(
        decrement, rel=5e-3
    )
    assert body.frequency_hz == pytest.approx(np.sqrt(stiffness / 16.0) / (2 * np.pi), rel=1e-4)
