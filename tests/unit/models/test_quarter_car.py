"""The quarter car as symbols: shared structure, channels, and single values worked out by hand."""

from __future__ import annotations

import numpy as np
import pytest

from jounce import parts
from jounce.models import build
from jounce.recordings.schema import QUANTITIES
from jounce.simulation.compiled import compile_model

KART = parts.load("kart-quarter-car")
CURVES = {
    "polynomial": {"kind": "polynomial", "coefficients": [1e4, -2e5, 3e7]},
    "power": {"kind": "power", "coefficient": 2e6, "exponent": 1.5},
    "table": {
        "kind": "table",
        "deflection": [-0.01, 0.0, 0.01, 0.02],
        "force": [-50.0, 10.0, 200.0, 600.0],
    },
}


def at(rig, *, zs=0.0, zu=0.0, vs=0.0, vu=0.0, road=0.0, rate=0.0, internal=()):
    """Outputs by name and state rates at one state; modes as the switches say."""
    compiled = compile_model(build(rig))
    p, x, u = (
        compiled.parameter_values(rig.parameters()),
        np.array([zs, zu, vs, vu, *internal]),
        np.array([road, rate]),
    )
    modes = np.ones(len(compiled.model.switches))
    for _ in range(3):
        if len(modes):
            modes = (compiled.evaluate("switch", x, u, p, modes) > 0.0).astype(float)
    outputs = compiled.evaluate("output", x, u, p, modes)
    return dict(zip(compiled.output_names, outputs, strict=True)), compiled.evaluate(
        "rate", x, u, p, modes
    )


def test_rigs_that_differ_in_numbers_share_a_model():
    assert build(KART) is build(KART.with_changes({"sprung.mass": 99.0, "strut.angle": 0.5}))
    assert build(KART) is not build(KART.with_changes({"tyre.lift_off": False}))
    assert build(KART) is not build(KART.with_changes({"strut.friction": {"force": 1.0}}))


def test_every_number_of_the_rig_is_a_parameter_of_the_model():
    rig = KART.with_changes(
        {"strut.friction": {"force": 1.0}, "strut.bump_stop": {"gap": 0.01, "rate": 1e4}}
    )
    assert set(build(rig).parameters) == set(rig.parameters())


def test_channels_have_known_quantities_units_and_labels():
    outputs = build(KART).outputs
    assert len({output.name for output in outputs}) == len(outputs)
    for output in outputs:
        unit, _ = QUANTITIES[output.name.rpartition(".")[2]]
        assert output.unit == unit, output.name
        assert output.long_name
    expected = {
        f"{body}.{quantity}" for body in ("sprung", "unsprung") for quantity in ("z", "vz", "az")
    }
    assert expected | {
        "strut.deflection",
        "strut.force",
        "tyre.deflection",
        "tyre.force",
        "road.z",
    } <= {o.name for o in outputs}


def test_piecewise_linear_as_long_as_nothing_is_curved():
    bilinear = {"strut.damper": {"bump_coefficient": 80.0, "rebound_coefficient": 240.0}}
    for changes in ({}, {"tyre.lift_off": False}, bilinear):
        assert build(KART.with_changes(changes)).facts.linear_without == ()
    assert build(KART.with_changes({"strut.friction": {"force": 1.0}})).facts.linear_without is None
    curve = {
        "tyre.stiffness": None,
        "tyre.curve": {"kind": "polynomial", "coefficients": [6e4, 2e7]},
    }
    assert build(KART.with_changes(curve)).facts.linear_without is None


def test_a_bump_stop_is_linear_without_its_progression():
    model = build(KART.with_changes({"strut.bump_stop": {"gap": 0.01, "rate": 1e4}}))
    assert not model.is_piecewise_linear()
    assert model.facts.linear_without == ("strut.bump_stop.progression",)


def test_signs_and_values_of_the_strut():
    """The wheel 10 mm up against the body at 0.1 m/s: compression, bump, both positive; cos(26 deg) twice."""
    out, rate = at(KART.with_changes({"strut.spring.preload": 40.0}), zu=0.01, vu=0.1, road=-1.0)
    cos = np.cos(np.radians(26.0))
    force = 40.0 + 22730.0 * 0.01 * cos + 150.0 * 0.1 * cos
    assert out["strut.deflection"] == pytest.approx(0.01 * cos)
    assert out["strut.force"] == pytest.approx(force)
    assert out["sprung.az"] == pytest.approx(cos * force / 16.0 - 9.81)
    assert out["unsprung.az"] == pytest.approx(-cos * force / 5.0 - 9.81)
    assert rate == pytest.approx([0.0, 0.1, out["sprung.az"], out["unsprung.az"]])


def test_tyre():
    rig = KART.with_changes({"tyre.damping_coefficient": 60.0})
    out, _ = at(rig, zu=-0.002, vu=-0.1, vs=-0.1, zs=-0.002, road=0.001, rate=0.5)
    assert out["tyre.deflection"] == pytest.approx(0.003)
    assert out["tyre.force"] == pytest.approx(138468.0 * 0.003 + 60.0 * 0.6)
    assert out["unsprung.az"] == pytest.approx(out["tyre.force"] / 5.0 - 9.81)


@pytest.mark.parametrize(
    ("zu", "vu", "touching"),
    [
        (0.001, -1.0, False),
        (-0.001, 0.0, True),
        (-0.001, 5.0, False),
        (0.001, 5.0, False),
        (-0.001, -1.0, True),
    ],
    ids=[
        "above, coming down",
        "compressed",
        "leaving faster than the tyre follows",
        "flying",
        "landing",
    ],
)
def test_a_tyre_never_pulls(zu, vu, touching):
    out, _ = at(KART.with_changes({"tyre.damping_coefficient": 60.0}), zu=zu, vu=vu)
    assert (out["tyre.force"] > 0.0) == touching
    assert out["tyre.force"] == pytest.approx(max(0.0, 138.468 - 60.0 * vu) if zu < 0 else 0.0)


def test_without_lift_off_it_does():
    out, _ = at(KART.with_changes({"tyre.lift_off": False}), zu=0.001)
    assert out["tyre.force"] == pytest.approx(-138.468)


@pytest.mark.parametrize(
    ("kind", "x", "force"),
    [
        ("polynomial", 0.01, 100.0 - 20.0 + 30.0),
        ("polynomial", -0.01, -100.0 - 20.0 - 30.0),
        ("power", 0.01, 2000.0),
        ("power", -0.01, 0.0),
        ("table", 0.005, 105.0),
        ("table", 0.015, 400.0),
        ("table", -0.02, -110.0),
        ("table", 0.03, 1000.0),
    ],
)
def test_curves(kind, x, force):
    """Polynomial and power law by hand; a table's outer lines go on."""
    rig = KART.with_changes(
        {"strut.angle": 0.0, "strut.spring": {"rate": None, "curve": CURVES[kind]}}
    )
    out, _ = at(rig, zu=x, road=-1.0)
    assert out["strut.force"] == pytest.approx(force, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize(("velocity", "force"), [(0.5, 40.0), (-0.5, -120.0), (0.0, 0.0)])
def test_bilinear_damper(velocity, force):
    changes = {
        "strut.angle": 0.0,
        "strut.damper": {"bump_coefficient": 80.0, "rebound_coefficient": 240.0},
    }
    out, _ = at(KART.with_changes(changes), vu=velocity, road=-1.0)
    assert out["strut.force"] == pytest.approx(force)
    assert out["strut.velocity"] == pytest.approx(velocity)


def test_tanh_damper():
    damper = {
        "kind": "tanh",
        "coefficient": 80.0,
        "stiffness": 500.0,
        "force": 20.0,
        "slope": 30.0,
        "displacement_coupling": 3.0,
        "offset": 4.0,
    }
    out, _ = at(
        KART.with_changes({"strut.angle": 0.0, "strut.damper": damper}),
        zu=0.01,
        vu=-0.02,
        road=-1.0,
    )
    expected = (
        227.3 + 80.0 * -0.02 + 500.0 * 0.01 + 20.0 * np.tanh(30.0 * (-0.02 + 3.0 * 0.01)) + 4.0
    )
    assert out["strut.force"] == pytest.approx(expected, rel=1e-13)


@pytest.mark.parametrize("z", [-0.6, 0.0, 0.6])
@pytest.mark.parametrize("velocity", [-0.1, 0.1])
def test_bouc_wen_damper(z, velocity):
    damper = {
        "kind": "bouc-wen",
        "coefficient": 80.0,
        "stiffness": 300.0,
        "hysteretic_force": 20.0,
        "rate": 800.0,
        "sigma": 0.8,
        "exponent": 1.6,
        "offset": -3.0,
    }
    rig = KART.with_changes({"strut.angle": 0.0, "strut.damper": damper})
    out, rate = at(rig, vu=velocity, road=-1.0, internal=[z])
    assert out["strut.force"] == pytest.approx(80.0 * velocity + 20.0 * z - 3.0)
    turning = 0.8 * abs(velocity) * abs(z) ** 0.6 * z + 0.2 * velocity * abs(z) ** 1.6
    assert rate[4] == pytest.approx(800.0 * (velocity - turning), rel=1e-12)


def test_hysteresis_stays_within_its_bounds():
    damper = {
        "kind": "bouc-wen",
        "coefficient": 0.0,
        "hysteretic_force": 20.0,
        "rate": 800.0,
        "sigma": 0.8,
        "exponent": 2.0,
    }
    rig = KART.with_changes({"strut.damper": damper})
    for z, velocity in ((1.0, 0.5), (-1.0, -0.5)):
        _, rate = at(rig, vu=velocity, internal=[z])
        assert rate[4] == pytest.approx(0.0, abs=1e-9)


def test_friction_of_strut_and_guide():
    rig = KART.with_changes(
        {"strut.angle": 0.0, "strut.friction": {"force": 12.0}, "guide.friction": {"force": 6.0}}
    )
    out, _ = at(rig, vs=0.01, vu=0.03, road=-1.0)
    assert out["strut.force"] == pytest.approx(150.0 * 0.02 + 12.0 * np.tanh(10.0))
    guide = 6.0 * np.tanh(5.0)
    assert out["sprung.az"] == pytest.approx((out["strut.force"] - guide) / 16.0 - 9.81)
    assert out["unsprung.az"] == pytest.approx(-out["strut.force"] / 5.0 - 9.81)


@pytest.mark.parametrize(
    ("deflection", "extra"), [(0.009, 0.0), (0.01, 0.0), (0.015, 6e4 * 0.005 + 3e8 * 0.005**3)]
)
def test_bump_stop(deflection, extra):
    rig = KART.with_changes(
        {"strut.angle": 0.0, "strut.bump_stop": {"gap": 0.01, "rate": 6e4, "progression": 3e8}}
    )
    out, _ = at(rig, zu=deflection, road=-1.0)
    assert out["strut.force"] == pytest.approx(22730.0 * deflection + extra)
