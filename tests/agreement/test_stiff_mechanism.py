"""A double wishbone on stiff bushings: the implicit method against the explicit one, and against rigid joints."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce import parts
from jounce.core.errors import SimulationError
from jounce.models import build
from jounce.roads import HalfSine, Trial
from jounce.simulation.compiled import compile_model, compile_rig
from jounce.simulation.linear_systems import linear_functions
from jounce.simulation.prepare import prepare, solve
from jounce.simulation.settings import MAX_STEPS, output_times
from jounce.simulation.statics import find_equilibrium

RIGID = parts.load(Path(__file__).parents[1] / "files" / "prototype-double-wishbone.toml")
ARMS = ("lower_arm_front", "lower_arm_rear", "upper_arm_front", "upper_arm_rear")
FRICTION = {"force": 10.0, "regularisation_velocity": 0.001}


def stiff(rig=RIGID, *, damping=0.0, friction=True, lift_off=None):
    """Bushings of 1e7 N/m in place of the arms' inner joints, friction in the strut and with it a tyre that lifts off.

    With both there is one model to compile, for seconds.
    """
    law = {"stiffness": (1e7,) * 3, "rotational_stiffness": (1.0,) * 3, "damping": (damping,) * 3}
    table = rig.model_dump(by_alias=True, exclude_none=True) | {
        "bushings": dict.fromkeys(ARMS, law)
    }
    if friction:
        table["strut"]["friction"] = FRICTION
    table["tyre"]["lift_off"] = friction if lift_off is None else lift_off
    return type(rig).model_validate(table)


def bump(duration):
    return Trial(road=HalfSine(height="10 mm", length="60 mm"), speed="1.95 m/s", duration=duration)


def error(run, reference, channel):
    return float(abs(run[channel] - reference[channel]).max()) / np.ptp(
        reference[channel].to_numpy()
    )


CASES = {
    "undamped": {"friction": False},
    "friction": {"lift_off": False},
    "lift-off": {},
    "damped bushings": {"damping": 1e3},
}


@pytest.mark.parametrize(
    "name", [pytest.param(n, marks=[pytest.mark.slow] if n == "friction" else []) for n in CASES]
)
def test_methods_agree(name):
    """Displacements within the tolerance, at loose and tight ones; contact and friction switch as often."""
    rig, trial = stiff(**CASES[name]), bump("0.3 s")
    reference = jn.simulate(rig, trial, tolerance=1e-9, method="explicit")
    for tolerance in (1e-4, 1e-6, 1e-8):
        run = jn.simulate(rig, trial, tolerance=tolerance, method="implicit")
        assert run.attrs["method"] == "implicit"
        for channel in ("sprung.z", "unsprung.z", "strut.deflection"):
            assert error(run, reference, channel) < tolerance, (tolerance, channel)
    assert run.attrs["events"] == reference.attrs["events"]


@pytest.mark.parametrize("friction", [False, True])
def test_stiff_bushings_act_as_rigid_joints(friction):
    """What differs is the bushings' own deflection, 20 um of 7 mm at rest and some times that at a kilonewton."""
    trial = bump("3 s")
    rigid = jn.simulate(
        RIGID.with_changes({"strut.friction": FRICTION, "tyre.lift_off": True})
        if friction
        else RIGID,
        trial,
    )
    soft = jn.simulate(stiff(friction=friction), trial)
    assert soft.attrs["method"] == "implicit"
    for channel in ("sprung.z", "unsprung.z"):
        assert 1e-5 < error(soft, rigid, channel) < 3e-2
    assert float(abs(soft["wheel.camber"] - rigid["wheel.camber"]).max()) < 5e-4


def test_the_faster_method_is_chosen():
    trial = bump("3 s")
    assert jn.simulate(RIGID, trial).attrs["method"] == "reduced explicit"
    assert jn.simulate(stiff(damping=1e4), trial).attrs["method"] == "implicit"
    assert jn.simulate(RIGID, trial, method="implicit").attrs["method"] == "implicit"
    explicit = jn.simulate(stiff(), bump("0.1 s"), method="explicit")
    assert explicit.attrs["method"] == "explicit"


def test_steps_follow_the_slow_motion():
    """With damped bushings a tenth of a percent of what the explicit method's stability asks; also with friction."""
    rig, trial = stiff(damping=1e4), bump("3 s")
    run = jn.simulate(rig, trial)
    compiled = compile_rig(rig)
    p = compiled.parameter_values(rig.parameters())
    rest = find_equilibrium(compiled, p, compiled.inputs())
    decay = np.max(np.abs(np.linalg.eigvals(rest.reduced)))
    assert (
        run.attrs["steps"] < 0.01 * 3.0 * decay / 6.0
    )  # the stability interval of the explicit method is about 6
    assert run.attrs["steps"] < 2000


def test_an_explicit_run_without_steps_left_goes_on_implicitly():
    rig, times = stiff(damping=1e3), output_times(0.2, 1e-3)
    compiled = compile_rig(rig)
    prepared = prepare(
        compiled, compiled.parameter_values(rig.parameters()), bump("0.2 s").segments(), times
    )
    assert prepared.control.max_steps == MAX_STEPS
    poor = prepared.__class__(
        **{
            **{name: getattr(prepared, name) for name in prepared.__dataclass_fields__},
            "control": prepared.control._replace(max_steps=50),
            "method": "explicit",
        }
    )
    found, whole = poor.run(), prepared.run()
    assert found.method == "implicit"
    assert found.status.name == "COMPLETED"
    np.testing.assert_allclose(found.states, whole.states, atol=1e-6)


def test_sensitivities_are_refused():
    compiled = compile_rig(RIGID, ("strut.spring.rate",))
    p = compiled.parameter_values(RIGID.parameters())
    with pytest.raises(SimulationError, match="does not support sensitivities"):
        solve(compiled, p, bump("0.1 s").segments(), output_times(0.1, 1e-3), method="implicit")


def test_a_method_that_does_not_exist_is_refused():
    with pytest.raises(SimulationError, match="implicit"):
        jn.simulate(RIGID, bump("0.1 s"), method="stiff")


@pytest.mark.parametrize(
    "rig",
    [
        RIGID,
        stiff(damping=1e3),
        parts.load("kart-quarter-car"),
        parts.load("kart-quarter-car").with_changes(
            {
                "strut.damper": {
                    "kind": "bouc-wen",
                    "coefficient": 50.0,
                    "hysteretic_force": 20.0,
                    "rate": 500.0,
                    "sigma": 0.6,
                    "exponent": 1.5,
                }
            }
        ),
    ],
    ids=["rigid", "bushings", "quarter car", "internal state"],
)
def test_linear_systems_against_dense_ones(rig):
    """At a state off the constraints' rest: solution of ``(shift - df/dx) d = r`` by LAPACK with the dense slopes."""
    model = build(rig)
    compiled, functions, random = (
        compile_model(model),
        linear_functions(model),
        np.random.default_rng(5),
    )
    p, u = compiled.parameter_values(rig.parameters()), compiled.inputs()
    rest = find_equilibrium(compiled, p, u)
    x, r = rest.x + 1e-4 * random.standard_normal(len(rest.x)), random.standard_normal(len(rest.x))
    looked, n = functions["look"](x, u, p, rest.modes), len(x)
    slopes, rate = looked[:-n], looked[-n:].full()[:, 0]
    for shift in (1e2, 1e4, 1e6):
        factors = functions["factor"](slopes, shift, [], [])
        found = functions["solve"](r, [], factors, slopes).full()[:, 0]
        matrix = shift * np.eye(len(x)) - compiled.evaluate("rate_x", x, u, p, rest.modes)
        wanted = np.linalg.solve(matrix, r)
        assert float(factors[0]) > 1e-3
        np.testing.assert_allclose(found, wanted, atol=1e-9 * np.max(np.abs(wanted)))
    wanted = compiled.evaluate("rate", x, u, p, rest.modes)
    np.testing.assert_allclose(rate, wanted, atol=1e-12 * np.max(np.abs(wanted)))
    by_input = functions["along_input"](x, u, p, rest.modes).full()
    wanted = compiled.evaluate("rate_u", x, u, p, rest.modes)
    np.testing.assert_allclose(by_input, wanted, atol=1e-12 * np.max(np.abs(wanted)))
