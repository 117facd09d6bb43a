"""Force laws as graphs, held against the words of their descriptions."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Mapping
from pathlib import Path

import casadi as ca
import numpy as np
import pytest

import jounce as jn
from jounce.core.description import Description
from jounce.mechanics import System, damper_map_force
from jounce.mechanics.bushings import add_sliding_bushing
from jounce.mechanics.elements import (
    bump_stop_force,
    bushing_curve,
    damper_force,
    friction_force,
    spring_force,
    tyre_force,
)
from jounce.parts.bushings import load_of
from jounce.parts.curves import PolynomialCurve, PowerCurve, RotationalTableCurve, TableCurve
from jounce.parts.dampers import (
    BilinearDamper,
    BlowOffDamper,
    BoucWenDamper,
    LinearDamper,
    MapDamper,
    TanhDamper,
    VelocityTable,
)
from jounce.parts.elements import BumpStop, Friction, Spring, Tyre

MAP = MapDamper(
    length=(0.30, 0.36, 0.45),
    velocity=(-0.8, -0.1, 0.2, 1.0),
    force=(
        (-900.0, -400.0, 150.0, 500.0),
        (-700.0, -350.0, 60.0, 420.0),
        (-1200.0, -300.0, 200.0, 900.0),
    ),
)


def law_of(make: Callable[[System, ca.SX, ca.SX], ca.SX], numbers: Mapping[str, float]):
    """A law's force and its inner state's rate, over deflection, rate and inner state; switches as their signs say."""
    system = System()
    deflection, rate = system.coordinate("deflection"), system.coordinate("rate")
    for each in (deflection, rate):
        system.point_mass(ca.SX(1.0), each)
    system.output("force", make(system, deflection, rate), "N", "force")
    model = system.finish()
    where = [model.x, model.u, model.p, model.m]
    switches, both = (
        ca.Function("f", where, list(graphs))
        for graphs in ([model.switch], [model.output, model.rate])
    )
    p = ca.DM([numbers[name] for name in model.parameters])

    def evaluate(deflection: float, rate: float, inner: float = 0.0) -> tuple[float, float]:
        x = ca.DM([deflection, rate, 0.0, 0.0, inner][: len(model.states)])
        m = ca.DM.zeros(len(model.switches))
        for _ in range(2):  # contact of a tyre asks for its force, which has switches of its own
            m = switches(x, ca.DM(0, 1), p, m) > 0.0
        force, rates = both(x, ca.DM(0, 1), p, m)
        return float(force), float(rates[-1])

    return evaluate


def numbers_of(part: Description, path: str) -> dict[str, float]:
    """Numbers of a description by the paths that a model gives them."""
    found: dict[str, float] = {}

    def walk(value: object, path: str) -> None:
        if isinstance(value, dict):
            for name, inner in value.items():
                walk(inner, f"{path}.{name}")
        elif isinstance(value, list | tuple):
            for i, inner in enumerate(value):
                walk(inner, f"{path}[{i}]")
        elif isinstance(value, float):
            found[path] = value

    walk(part.model_dump(), path)
    return found


TANH = TanhDamper(
    coefficient=700.0,
    stiffness=900.0,
    force=250.0,
    slope=12.0,
    displacement_coupling=3.0,
    offset=40.0,
)
BLOW_OFF = BlowOffDamper(
    bump_blow_off_force=300.0,
    bump_blow_off_velocity=0.1,
    bump_high_speed_coefficient=500.0,
    rebound_blow_off_force=800.0,
    rebound_blow_off_velocity=0.2,
    rebound_high_speed_coefficient=700.0,
)
POLYNOMIAL = PolynomialCurve(coefficients=(2e4, -3e4, 5e5))
POWER = PowerCurve(coefficient=3e5, exponent=1.3)
TABLE = TableCurve(deflection=(-0.02, 0.0, 0.03), force=(-300.0, 50.0, 900.0))
STOP = BumpStop(gap=0.01, rate=2e4, progression=3e6)
DEFLECTIONS = np.array([-0.05, -0.02, -0.004, 0.006, 0.013, 0.04])


def over(x: np.ndarray, points: tuple[float, ...], forces: tuple[float, ...]) -> np.ndarray:
    """Straight lines through three points, going on beyond the ends."""
    slopes = np.diff(forces) / np.diff(points)
    return np.where(
        x < points[1],
        forces[1] + slopes[0] * (x - points[1]),
        forces[1] + slopes[1] * (x - points[1]),
    )


@pytest.mark.parametrize(
    ("make", "part", "expected"),
    [
        (spring_force, Spring(rate=3e4, preload=800.0), lambda x, _: 800.0 + 3e4 * x),
        (spring_force, Spring(curve=POLYNOMIAL), lambda x, _: 2e4 * x - 3e4 * x**2 + 5e5 * x**3),
        (
            spring_force,
            Spring(curve=POWER, preload=5.0),
            lambda x, _: 5.0 + 3e5 * np.maximum(x, 0.0) ** 1.3,
        ),
        (spring_force, Spring(curve=TABLE), lambda x, _: over(x, TABLE.deflection, TABLE.force)),
        (damper_force, LinearDamper(coefficient=1500.0), lambda _, v: 1500.0 * v),
        (
            damper_force,
            BilinearDamper(bump_coefficient=800.0, rebound_coefficient=2200.0),
            lambda _, v: np.where(v > 0.0, 800.0, 2200.0) * v,
        ),
        (
            damper_force,
            VelocityTable(velocity=TABLE.deflection, force=TABLE.force),
            lambda _, v: over(v, TABLE.deflection, TABLE.force),
        ),
        (
            damper_force,
            BLOW_OFF,
            lambda _, v: np.interp(
                v, (-1.2, -0.2, 0.0, 0.1, 1.1), (-1500.0, -800.0, 0.0, 300.0, 800.0)
            ),
        ),
        (
            damper_force,
            TANH,
            lambda x, v: 700.0 * v + 900.0 * x + 250.0 * np.tanh(12.0 * (v + 3.0 * x)) + 40.0,
        ),
        (
            bump_stop_force,
            STOP,
            lambda x, _: np.where(x > 0.01, 2e4 * (x - 0.01) + 3e6 * (x - 0.01) ** 3, 0.0),
        ),
        (friction_force, Friction(force=90.0), lambda _, v: 90.0 * np.tanh(v / 0.002)),
        (
            tyre_force,
            Tyre(stiffness=2e5, damping_coefficient=400.0),
            lambda x, v: held(2e5 * x + 400.0 * v, 2e5 * x),
        ),
        (tyre_force, Tyre(stiffness=2e5, lift_off=False), lambda x, _: 2e5 * x),
        (tyre_force, Tyre(curve=POWER), lambda x, _: 3e5 * np.maximum(x, 0.0) ** 1.3),
        (
            tyre_force,
            Tyre(curve=POLYNOMIAL),
            lambda x, _: held(2e4 * x - 3e4 * x**2 + 5e5 * x**3, x),
        ),
        (
            tyre_force,
            Tyre(curve=TABLE),
            lambda x, _: held(over(x, TABLE.deflection, TABLE.force), x),
        ),
    ],
)
def test_a_law_is_what_its_description_says(
    make: Callable, part: Description, expected: Callable
) -> None:
    def written(system: System, deflection: ca.SX, rate: ca.SX) -> ca.SX:
        if make is tyre_force:
            return tyre_force(system, part, deflection, rate)
        if make is damper_force:
            return damper_force(system, part, "part", deflection, rate)
        return make(system, part, "part", rate if make is friction_force else deflection)

    law = law_of(written, numbers_of(part, "tyre" if make is tyre_force else "part"))
    x, v = (grid.ravel() for grid in np.meshgrid(DEFLECTIONS, 10.0 * DEFLECTIONS))
    found = [law(*each)[0] for each in zip(x, v, strict=True)]
    np.testing.assert_allclose(found, expected(x, v), rtol=1e-12, atol=1e-9)


def held(force: np.ndarray, depth: np.ndarray) -> np.ndarray:
    """A contact force: neither does it pull nor does it act where the tyre is off the road."""
    return np.where((force > 0.0) & (depth > 0.0), force, 0.0)


def test_steps_land_where_friction_is_nearly_full() -> None:
    system = System()
    place, rate = system.coordinate("place"), system.coordinate("rate")
    for each in (place, rate):
        system.point_mass(ca.SX(1.0), each)
    friction = Friction(force=90.0, regularisation_velocity=0.01)
    system.output("force", friction_force(system, friction, "part", rate), "N", "force")
    model = system.finish()
    both = ca.Function("f", [model.x, model.p], [model.switch, model.output])
    assert model.parameters == ("part.regularisation_velocity", "part.force")
    for speed in (-0.03, 0.03):  # on both sides of the layer
        sliding, force = (float(part) for part in both([0.0, speed, 0.0, 0.0], [0.01, 90.0]))
        assert sliding == pytest.approx(0.0, abs=1e-12)
        assert force == pytest.approx(np.sign(speed) * 0.995 * 90.0, rel=1e-4)


def test_contact_of_a_tyre_is_asked_for_in_newtons() -> None:
    """Force and deflection are compared where the tyre hardly presses: in newtons, by a stiffness of its order."""
    for curve, stiffness in (
        (None, 2e5),
        (POLYNOMIAL, 2e4 + 1.0),
        (POWER, 3e5),
        (TABLE, 1200.0 / 0.05),
    ):
        part, system = (
            Tyre(curve=curve, stiffness=None if curve else 2e5, damping_coefficient=1e9),
            System(),
        )
        depth, rate = system.coordinate("depth"), system.coordinate("rate")
        for each in (depth, rate):
            system.point_mass(ca.SX(1.0), each)
        system.output("force", tyre_force(system, part, depth, rate), "N", "force")
        model = system.finish()
        contact = ca.Function("f", [model.x, model.p, model.m], [model.switch])
        numbers = numbers_of(part, "tyre")
        found = contact(
            [1e-3, 1.0, 0.0, 0.0],
            [numbers[name] for name in model.parameters],
            [1.0] * model.m.numel(),
        )
        assert float(found[list(model.switches).index("tyre contact")]) == pytest.approx(
            1e-3 * stiffness, rel=1e-12
        )


@pytest.mark.parametrize("velocity", [-0.3, 0.2])
@pytest.mark.parametrize("z", [-0.8, 0.4])
def test_a_bouc_wen_damper_turns_over_as_its_description_says(velocity: float, z: float) -> None:
    part = BoucWenDamper(
        coefficient=300.0,
        stiffness=700.0,
        hysteretic_force=80.0,
        rate=900.0,
        sigma=0.7,
        exponent=1.6,
        offset=9.0,
    )
    found = law_of(
        lambda system, x, v: damper_force(system, part, "part", x, v), numbers_of(part, "part")
    )
    force, rate = found(0.02, velocity, z)
    assert force == pytest.approx(300.0 * velocity + 700.0 * 0.02 + 80.0 * z + 9.0, rel=1e-12)
    turning = 0.7 * abs(velocity) * abs(z) ** 0.6 * z
    assert rate == pytest.approx(
        900.0 * (velocity - turning + (0.7 - 1.0) * velocity * abs(z) ** 1.6), rel=1e-12
    )


def test_a_damper_map_is_bilinear_between_its_points() -> None:
    law = law_of(
        lambda system, x, v: damper_map_force(system, MAP, "map", x, v), numbers_of(MAP, "map")
    )
    rows, speeds, forces = np.array(MAP.length), np.array(MAP.velocity), np.array(MAP.force)
    for place in (0.25, 0.31, 0.36, 0.40, 0.44, 0.50):  # beyond the lengths the force stays
        for speed in (
            -1.5,
            -0.8,
            -0.45,
            0.0,
            0.15,
            0.2,
            0.7,
            1.6,
        ):  # beyond the velocities it goes straight on
            j = int(np.clip(np.searchsorted(speeds, speed) - 1, 0, len(speeds) - 2))
            slope = (forces[:, j + 1] - forces[:, j]) / (speeds[j + 1] - speeds[j])
            expected = np.interp(place, rows, forces[:, j] + slope * (speed - speeds[j]))
            assert law(place, speed)[0] == pytest.approx(expected, rel=1e-12, abs=1e-9)


def test_a_sliding_bushing_holds_across_its_line_and_not_along_it() -> None:
    mechanism = jn.mechanics.Mechanism()
    block = mechanism.body("block", 2.0, (0.0, 0.0, 0.0), (0.1, 0.1, 0.1))
    mechanism.free("block", block)
    at, axis, stiffness, damping = (
        np.array(v) for v in ((0.1, 0, 0), (0, 0.6, 0.8), (3e3, 5e3, 9e3), (20.0, 30.0, 50.0))
    )
    given = [ca.SX(v) for v in (at, axis, at, stiffness, damping)]
    force, power = add_sliding_bushing(mechanism, mechanism.ground, block, *given)
    for i, part in enumerate((*ca.vertsplit(force), power)):
        mechanism.output(f"out {i}", part, "N", "bushing")
    model = mechanism.finish()
    seen = ca.Function("f", [model.x, model.p], [model.output])
    apart, rate = np.array([0.01, -0.02, 0.03]), np.array([0.3, -0.2, 0.1])
    x = np.concatenate((apart, (1.0, 0.0, 0.0, 0.0), rate, (0.0, 0.0, 0.0)))
    found = seen(x, [mechanism.values[name] for name in model.parameters]).full().ravel()
    across = np.eye(3) - np.outer(axis, stiffness * axis) / (
        axis @ (stiffness * axis)
    )  # slid to where nothing pushes
    expected = -stiffness * (across @ apart) - damping * (across @ rate)
    np.testing.assert_allclose(found, [*expected, -expected @ (across @ rate)], rtol=1e-9)
    assert (stiffness * (across @ apart)) @ axis == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize(("end", "place", "side"), [("lower", -0.12, 1.0), ("upper", 0.23, -1.0)])
@pytest.mark.parametrize("rate", [-3.0, -0.5, 0.0, 0.5, 3.0])
def test_a_stop_pushes_and_never_pulls(end: str, place: float, side: float, rate: float) -> None:
    mechanism = jn.mechanics.Mechanism()
    sled = mechanism.body("sled", 2.0, (0.0, 0.0, 0.0), (0.1, 0.1, 0.1))
    along = mechanism.prismatic("rail", mechanism.ground, sled, axis=(1.0, 0.0, 0.0))
    stop = mechanism.stop(
        "stop", along, stiffness=5000.0, damping=200.0, **{end: -0.1 if end == "lower" else 0.2}
    )
    mechanism.output("stop.force", stop, "N", "force of the stop")
    start = {"rail.distance": place, "rail.distance rate": rate}
    run = jn.simulate_mechanism(mechanism, 1e-3, start=start, output_step=1e-3)
    depth = 0.02 if end == "lower" else 0.03
    push = (
        5000.0 * depth - side * 200.0 * rate
    )  # spring and damper; pulling back what leaves is cut off
    assert float(run["stop.force"][0]) == pytest.approx(side * max(push, 0.0), rel=1e-9)


def test_the_page_of_mechanisms_uses_every_force_element():
    """The functions that the package offers, and the builder's methods that add a load."""
    page = (Path(__file__).parents[3] / "docs" / "how-to" / "mechanisms.md").read_text(
        encoding="utf-8"
    )
    blocks = "".join(re.findall(r"```python\n(.*?)```", page, re.DOTALL))
    functions = [
        name for name in jn.mechanics.__all__ if name.startswith("add_") or name.endswith("_force")
    ]
    methods = [
        name for name, method in inspect.getmembers(jn.mechanics.Mechanism, inspect.isfunction)
        if "self.act(" in inspect.getsource(method)
    ]  # fmt: skip
    assert {"add_elastic_rod", "tyre_force"} <= {*functions}
    assert {"spring_damper", "push_apart", "load"} <= {*methods}
    assert [name for name in functions if f"jn.mechanics.{name}(" not in blocks] == []
    assert [name for name in methods if f"block.{name}(" not in blocks] == []


@pytest.mark.parametrize("share", [1.0, 0.4])
def test_friction_that_builds_up_over_travel_is_dahls(share: float) -> None:
    """Between reversals the share that follows the travel goes to its end as the exponential of the way."""
    force, over, onset = 8.0, 3e-4, 5e-3
    friction = {
        "force": force,
        "regularisation_velocity": onset,
        "presliding": share,
        "presliding_distance": over,
    }
    rig = jn.load("kart-quarter-car").with_changes({"guide.friction": friction})
    road = jn.HalfSine(height="10 mm", length="60 mm", start="0.05 m")
    trial = jn.Trial(road=road, speed="2 m/s", duration="0.4 s")
    run = jn.simulate(rig, trial, tolerance=1e-8, output_step=2e-4)
    travel, rate = run["sprung.z"].to_numpy(), run["sprung.vz"].to_numpy()
    built_up = [0.0]
    for way in np.diff(travel):
        end = np.sign(way)
        built_up.append(end + (built_up[-1] - end) * np.exp(-abs(way) / over))
    expected = -force * (share * np.array(built_up) + (1.0 - share) * np.tanh(rate / onset))
    assert np.max(np.abs(run["guide.force"].to_numpy() - expected)) < 0.01 * force
    assert np.ptp(built_up) > 1.9


def test_a_share_that_builds_up_needs_its_distance() -> None:
    with pytest.raises(jn.DescriptionError, match="belong together"):
        jn.load("kart-quarter-car").with_changes(
            {"guide.friction": {"force": 8.0, "presliding": 0.5}}
        )


@pytest.mark.parametrize(
    "curve",
    [
        POLYNOMIAL,
        TableCurve(
            deflection=(-0.02, -0.004, 0.0, 0.01, 0.03), force=(-900.0, -60.0, 0.0, 200.0, 900.0)
        ),
        RotationalTableCurve(angle=(-0.1, 0.05), torque=(-20.0, 25.0)),
    ],
)
def test_the_curve_of_a_bushing_and_its_energy(curve) -> None:
    """Load as its description computes it; energy zero at design, its slope is the load."""
    numbers = numbers_of(curve, "curve")
    load, energy = (
        law_of(lambda system, x, _, i=i: bushing_curve(system, curve, "curve", x)[i], numbers)
        for i in range(2)
    )
    for x in (-0.05, -0.015, -0.002, 0.004, 0.02, 0.06):
        assert load(x, 0.0)[0] == pytest.approx(float(load_of(curve, x)), rel=1e-12)
        slope = (energy(x + 1e-6, 0.0)[0] - energy(x - 1e-6, 0.0)[0]) / 2e-6
        assert slope == pytest.approx(float(load_of(curve, x)), rel=1e-6)
    assert energy(0.0, 0.0)[0] == 0.0
