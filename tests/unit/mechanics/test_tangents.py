"""Tangents by the factors of the solution equal those by differentiating it."""

from __future__ import annotations

from pathlib import Path

import casadi as ca
import numpy as np
import pytest

from jounce import mechanics, parts
from jounce.mechanics.tangents import tangent
from jounce.models import build

PROTOTYPE = Path(__file__).parents[2] / "files" / "prototype-double-wishbone.toml"
BOUC_WEN = {"kind": "bouc-wen", "coefficient": 80.0, "hysteretic_force": 20.0, "rate": 800.0}
BOUC_WEN |= {"sigma": 0.8, "exponent": 2.0}


def corner(**changes):
    rig = parts.load(PROTOTYPE).with_changes(changes)
    model = build(rig)
    return model, np.array([rig.parameters()[path] for path in model.parameters])


def quarter(**changes):
    rig = parts.load("kart-quarter-car").with_changes(changes)
    model = build(rig)
    return model, np.array([rig.parameters()[path] for path in model.parameters])


def redundant():
    """A hinged double pendulum closed by a second hinge to the ground, whose spare equations are left out."""
    mechanism = mechanics.Mechanism()
    bars = [
        mechanism.body(name, mass=1.0, centre_of_mass=(x, 0.1, 0.0), inertia=(0.01, 0.02, 0.03))
        for name, x in (("left", 0.0), ("middle", 0.5), ("right", 1.0))
    ]
    places = ((0.0, 0.0, 0.0), (0.0, 0.0, 1.0), (1.0, 0.0, 1.2), (1.0, 0.0, 0.0))
    chain = (mechanism.ground, *bars, mechanism.ground)
    for i, place in enumerate(places):
        mechanism.revolute(f"hinge_{i}", chain[i], chain[i + 1], at=place, axis=(0.0, 1.0, 0.0))
    mechanism.watch_body(bars[1])
    model = mechanism.model("remove")
    return model, np.array([mechanism.values[path] for path in model.parameters])


MODELS = {
    "double wishbone": corner,
    "radial tyre with contact": lambda: corner(**{"tyre.law": "radial", "tyre.lift_off": True}),
    "quarter car": quarter,
    "internal state": lambda: quarter(**{"strut.damper": BOUC_WEN}),
    "redundant four-bar": redundant,
}


@pytest.mark.parametrize("name", MODELS)
def test_tangent_is_the_derivative(name):
    model, p = MODELS[name]()
    seeds = [ca.SX.sym(f"d{part}", getattr(model, part).shape[0]) for part in "xup"]
    found = tangent(model, *seeds)
    generator = np.random.default_rng(1)
    n = model.x.shape[0]
    u, m = 0.01 * generator.normal(size=model.u.shape[0]), np.ones(model.m.shape[0])
    x = np.concatenate([model.start, np.zeros(n - len(model.start))]) + 0.02 * generator.normal(
        size=n
    )
    symbols = [model.x, model.u, model.p, model.m]
    if model.projection.shape[0]:
        project = ca.Function("project", symbols, [model.projection])
        for _ in range(8):
            x = project(x, u, p, m).full()[:n, 0]
    directions = [
        generator.normal(size=n),
        generator.normal(size=len(u)),
        generator.normal(size=len(p)) * np.abs(p),
    ]
    known, along = ca.vertcat(model.x, model.u, model.p), ca.vertcat(*seeds)
    for part in ("rate", "output", "switch", "constraint", "projection"):
        expression = getattr(model, part)
        if part == "projection" and expression.shape[0]:
            expression = expression[:n]
        pair = ca.horzcat(getattr(found, part), ca.jtimes(expression, known, along))
        ours, expected = (
            ca.Function("pair", [*symbols, *seeds], [pair])(x, u, p, m, *directions).full().T
        )
        allowed = 1e-11 * np.max(np.abs(expected), initial=1e-12)
        assert np.max(np.abs(ours - expected), initial=0.0) <= allowed, part
