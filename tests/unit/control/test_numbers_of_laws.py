"""Numbers that laws have at a corner, and what laws do with them at one instant, beside plain NumPy."""

from __future__ import annotations

import math
from types import SimpleNamespace

import casadi as ca
import numpy as np
import pytest
from scipy.linalg import expm, solve_discrete_are
from scipy.optimize import minimize, nnls

from jounce.control import (
    LQR,
    PID,
    ActiveActuator,
    CornerModel,
    SemiActiveDamper,
    Skyhook,
    controller,
)
from jounce.control.actuators import Instant
from jounce.control.controller import CommandLimits, RunSetting
from jounce.control.design import (
    H_INFINITY_CHANNELS,
    Targets,
    Weights,
    _build_plant,
    corner_equations,
    corner_outputs,
    h_infinity,
    observer,
    regulator_gains,
)
from jounce.control.laws import LQG, LQG_CHANNELS, SHADD, HInfinity, Hybrid, Passive
from jounce.control.preview import PreviewMPC, _horizon, _limits, _Plan, _Planner
from jounce.control.program import program, values
from jounce.core.errors import SimulationError

CORNER = CornerModel(400.0, 40.0, 25e3, 200e3, 1500.0, motion_ratio=0.8, static_deflection=0.03)
FORCE, DAMPER = ActiveActuator(force_limit=1e6, lag=0.0), SemiActiveDamper(minimum=1.0, maximum=1e6)


def instant(numbers, seen, memory=(), last=0.0):
    look = (lambda name: ca.SX(float(seen[name]))), (lambda name: ca.SX(float(numbers[name])))
    return Instant(*look, ca.SX(last), [ca.SX(float(value)) for value in memory])


def matrix(numbers, name, rows, columns=None):
    if columns is None:
        return np.array([numbers[f"{name}[{i}]"] for i in range(rows)])
    return np.array([[numbers[f"{name}[{i}][{j}]"] for j in range(columns)] for i in range(rows)])


def test_numbers_that_nobody_gave() -> None:
    """Coefficients at the strut are those at the wheel over the motion ratio squared."""
    assert Passive().numbers(CORNER) == pytest.approx({"damping_coefficient": 1500.0 / 0.64})
    assert Skyhook().numbers(CORNER) == pytest.approx(
        {"damping_coefficient": 4000.0, "motion_ratio": 0.8}
    )
    assert Hybrid().numbers(CORNER)["skyhook_share"] == 0.5
    assert SHADD().numbers(CORNER)["crossover"] == pytest.approx(2.0 * math.pi * 1.8)
    keep = 0.01 / 0.011
    assert PID().numbers(CORNER) == pytest.approx({
        "proportional": 2000.0, "integral_gain": 2.5, "derivative": 0.0, "filter_keep": keep,
        "filter_gain": (1.0 - keep) / 1e-3, "tracking": 0.005, "motion_ratio": 0.8,
    })  # fmt: skip
    assert PID(tracking_time=1e-5).numbers(CORNER)["tracking"] == 1.0
    assert (SemiActiveDamper().lag, ActiveActuator().lag, ActiveActuator().damping_ratio) == (
        0.01,
        0.005,
        1.0,
    )
    mpc = PreviewMPC()
    assert (mpc.rate, mpc.preview, mpc.stroke, mpc.keep_contact) == (200.0, 0.08, None, True)
    class_c = 2.0 * math.pi**2 * 0.1**2 * 256e-6 * 20.0  # of the road's velocity at 20 m/s, m^2/s
    assert LQG().roughness == pytest.approx(class_c, rel=1e-4)


@pytest.mark.parametrize(("actuator", "base"), [(FORCE, None), (DAMPER, 0.0)])
def test_regulators_are_those_of_their_cost(actuator, base) -> None:
    """A damper takes the place of the corner's own; the body's natural frequency sets the weights."""
    square = (25e3 / 400.0) ** 2
    gains = regulator_gains(CORNER, Weights(square, 10.0 * square, 0.0), base)
    law = LQR(actuator=actuator)
    numbers = law.numbers(CORNER) | {"minimum": actuator.limits[0], "maximum": actuator.limits[1]}
    np.testing.assert_allclose(matrix(numbers, "gain", 4), gains, rtol=1e-12)
    seen = {"strut.deflection": 0.02, "sprung.vz": -0.3, "tyre.deflection": 0.004, "unsprung.vz": 0.9,
            "strut.velocity": 0.96}  # fmt: skip
    force = -gains @ [-0.02 / 0.8, -0.3, -0.004, 0.9] / 0.8
    found = float(law.decide(instant(numbers, seen)).command)
    assert found == pytest.approx(force if base is None else max(force / 0.96, 1.0), rel=1e-9)


@pytest.mark.parametrize("actuator", [ActiveActuator(force_limit=1e6, lag=0.004), DAMPER])
def test_an_instant_of_the_observer_is_a_prediction_and_a_correction(actuator) -> None:
    law = LQG(actuator=actuator, rate=250.0, noise={"sprung.az": 0.2})
    numbers = law.numbers(CORNER) | {"minimum": actuator.limits[0], "maximum": actuator.limits[1]}
    base = None if isinstance(actuator, ActiveActuator) else 0.0
    one = observer(
        CORNER, LQG_CHANNELS, np.array([0.2, 0.05, 5e-4]), law.roughness, 1e-3, 0.004, base
    )
    states, late_before, last = np.array([0.01, -0.2, 0.003, 0.5]), 700.0, 300.0
    measured = dict(zip(LQG_CHANNELS, (1.3, -4.0, 0.015), strict=True)) | {"strut.velocity": 0.4}
    late = math.exp(-1.0) if base is None else math.exp(-0.4)
    mean = (1.0 - late) / (1.0 if base is None else 0.4)
    arrived = last + late * (late_before - last)
    each = 0.8 if base is None else 0.8 * 0.4  # a coefficient makes a force with the velocity
    force, mean_force = each * arrived, each * (last + mean * (late_before - last))
    before = one.F @ states + one.H * mean_force
    after = before + one.L @ (np.array([1.3, -4.0, 0.015]) - one.C @ before - one.D * force)
    decided = law.decide(instant(numbers, measured, [*states, late_before], last))
    np.testing.assert_allclose([float(v) for v in decided.memory], [*after, arrived], rtol=1e-9)
    wanted = -float(law.gains(CORNER) @ after) / 0.8
    assert float(decided.command) == pytest.approx(
        wanted if base is None else max(wanted / 0.4, 1.0), rel=1e-9
    )


def test_an_instant_of_h_infinity_is_a_step_of_its_states() -> None:
    pytest.importorskip("slycot")
    law = HInfinity(actuator=ActiveActuator(force_limit=1e6, lag=0.01), rate=500.0)
    acceleration = 2.56 * 25e3 / 400.0 * 0.05
    targets = Targets(
        0.05, acceleration, 0.8 * 0.05, 400.0 * CORNER.gravity, (0.2 * 0.05, acceleration / 16.0)
    )
    damping = (
        CORNER.reference_damping * 0.8**2
    )  # to the last bit, for the search ends elsewhere with another one
    made, bound = h_infinity(CORNER, targets, 100.0, 0.002, damping)
    assert bound < 10.0
    numbers = law.numbers(CORNER)
    assert numbers["damping_coefficient"] == pytest.approx(1500.0)
    for name, whole in (("A", made.A), ("B", made.B)):
        np.testing.assert_allclose(matrix(numbers, name, *whole.shape), whole, rtol=1e-9)
    quick = HInfinity(actuator=ActiveActuator(force_limit=1e6, lag=1e-4), rate=500.0).numbers(
        CORNER
    )
    fastest, _ = h_infinity(CORNER, targets, 300.0, 0.002, damping)
    np.testing.assert_allclose(matrix(quick, "A", 6, 6), fastest.A, rtol=1e-9)
    numbers |= {"minimum": -1e6, "maximum": 1e6}
    states, seen = (
        np.linspace(-1.0, 2.0, 6),
        dict(zip(H_INFINITY_CHANNELS, (0.012, -1.7), strict=True)),
    )
    decided = law.decide(instant(numbers, seen, states))
    measured = np.array([0.012, -1.7])
    assert float(decided.command) == pytest.approx(
        (made.C[0] @ states + made.D[0] @ measured) / 0.8, rel=1e-9
    )
    np.testing.assert_allclose(
        [float(v) for v in decided.memory], made.A @ states + made.B @ measured, rtol=1e-9
    )


@pytest.mark.parametrize("hz", [0.5, 3.0, 15.0])
def test_the_generalised_plant_is_the_corner_behind_its_actuator(hz: float) -> None:
    """Of road, noises and command to price of the force, deflection, acceleration and the two measurements."""
    targets = Targets(0.05, 9.0, 0.04, 3900.0, (0.011, 0.6))
    (a, b, c, d), (measured, unit) = _build_plant(CORNER, targets, 150.0, 1200.0)
    s = 2j * math.pi * hz
    found = c @ np.linalg.solve(s * np.eye(6) - a, b) + d
    found[3:] *= measured[:, None]
    found[:, 3] /= unit
    between = 25e3 + 1200.0 * s
    masses = np.array(
        [[400.0 * s**2 + between, -between], [-between, 40.0 * s**2 + between + 200e3]]
    )
    by_road = np.linalg.solve(masses, [0.0, 200e3 * 0.05])
    by_force = np.linalg.solve(masses, [1.0, -1.0]) * 150.0 / (s + 150.0)
    lag, columns = 150.0 / (s + 150.0), []
    for heights, force in ((by_road, 0.0), (by_force, lag)):
        apart, body = heights[0] - heights[1], s**2 * heights[0]
        price = 10.0 / 3900.0 * (s + 50.0) / (s + 500.0) if force else 0.0
        columns.append([price, apart / 0.04, body / 9.0, -0.8 * apart, body])
    np.testing.assert_allclose(found[:, [0, 3]].T, columns, rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(
        found[:, 1:3], [[0, 0], [0, 0], [0, 0], [0.011, 0], [0, 0.6]], atol=1e-12
    )


def brute_force_plan(law, corner, state, bumps):
    """First force of the least cost over the horizon, from predictions step by step."""
    a, b, g = corner_equations(corner)
    c, d = corner_outputs(corner, ("sprung.az",))
    price, lag = 0.0, law.actuator.lag
    if lag:
        a, b = (
            np.block([[a, b], [np.zeros((1, 4)), -1.0 / lag]]),
            np.vstack([np.zeros((4, 1)), 1.0 / lag]),
        )
        g, c, d, price = np.vstack([g, [[0.0]]]), np.hstack([c, d]), 0.0 * d, 1e-3 / 400.0**2
    n, m = len(bumps), len(a)
    whole = expm(np.block([[a, b, g], [np.zeros((2, m + 2))]]) / law.rate)
    F, H, V = whole[:m, :m], whole[:m, m : m + 1], whole[:m, m + 1]
    square = (corner.spring_rate / corner.sprung_mass) ** 2
    Q = c.T @ c + np.diag([square, 0.0, 10.0 * square, *np.zeros(m - 3)])
    P = solve_discrete_are(F, H, Q, d.T @ d + price, s=c.T @ d)

    def ridden(forces):
        """Rows whose squares make up the cost: acceleration, weighted deflections, price, and the end's cost."""
        x, rows = np.asarray(state), []
        for force, bump in zip(forces, bumps, strict=True):
            acceleration = float(c[0] @ x + d[0, 0] * force)
            rows += [
                acceleration,
                square**0.5 * x[0],
                (10.0 * square) ** 0.5 * x[2],
                price**0.5 * force,
            ]
            x = F @ x + H[:, 0] * force + V * bump
        return np.concatenate([rows, np.linalg.cholesky(P).T @ x])

    free = ridden(np.zeros(n))
    each = np.array([ridden(1e3 * row) - free for row in np.eye(n)]).T / 1e3
    return float(np.linalg.lstsq(each, -free, rcond=None)[0][0])


@pytest.mark.parametrize("lag", [0.0, 0.01])
def test_a_plan_sees_the_road_that_comes(lag: float) -> None:
    """From an instant on, behind the force that has been commanded, on a corner with a motion ratio."""
    law = PreviewMPC(
        actuator=ActiveActuator(force_limit=1e6, lag=lag), keep_contact=False, preview=0.03
    )
    road = np.array([0.0, 0.0, 0.001, 0.004, 0.003, 0.005, 0.005, 0.002, 0.0, 0.001, 0.0, 0.0])
    plan = _Plan(law, law.actuator, CORNER, 6, road)
    arrived = []
    if lag:
        plan.follow(250.0)
        arrived = [200.0 * (1.0 - math.exp(-0.5))]
    seen, state, bumps = (
        [0.012, 0.2, -0.002, -0.4, -0.48],
        [-0.015, 0.2, 0.002, -0.4],
        np.diff(road)[3:9] * 200.0,
    )
    expected = brute_force_plan(law, CORNER, state + arrived, bumps)
    assert plan.command(seen, 3) == pytest.approx(expected / 0.8, rel=1e-4)
    plan.forget()
    assert plan.command(seen, 3) == pytest.approx(
        brute_force_plan(law, CORNER, state + [0.0 for _ in arrived], bumps) / 0.8, rel=1e-4
    )


@pytest.mark.parametrize("failure", ["no success", "not finite"])
def test_a_plan_goes_on_where_the_solver_finds_none(failure: str) -> None:
    """The rest of the last plan, its end held, within what the actuator can do."""
    law = PreviewMPC(actuator=ActiveActuator(force_limit=1e6, lag=0.0), preview=0.02)
    plan = _Plan(law, law.actuator, CORNER, 4, np.zeros(12))
    plan._forces = np.array([100.0, 200.0, 300.0, 400.0])

    class Failing:
        def __call__(self, **_):
            return {"x": np.full(6, np.nan if failure == "not finite" else 7.0)}

        def stats(self):
            return {"success": failure == "not finite"}

    plan._solver = Failing()
    low, high = np.full(4, -1e3), np.array([1e3, 1e3, 350.0, 1e3])
    np.testing.assert_array_equal(
        plan._solve(np.zeros(6), low, high, np.zeros(4)), [200.0, 300.0, 350.0, 400.0]
    )


def test_limits_of_a_plan() -> None:
    """Stroke both ways and tyre load at every instant to come, each softened by its own slack."""
    rows, margin = _limits(PreviewMPC(stroke=0.03), CORNER, 2, 4)
    contact = 440.0 * CORNER.gravity / 200e3
    np.testing.assert_allclose(margin, [0.03, 0.03, contact] * 2)
    expected = np.zeros((6, 14))
    for i, row in ((1, 0), (2, 3)):
        expected[row, 4 * i], expected[row, -2] = 1.0, -1.0
        expected[row + 1, 4 * i], expected[row + 1, -2] = -1.0, -1.0
        expected[row + 2, 4 * i + 2], expected[row + 2, -1] = 1.0, -1.0
    np.testing.assert_array_equal(rows, expected)
    assert _limits(PreviewMPC(keep_contact=False), CORNER, 2, 4)[0].shape == (0, 14)


def setting(law, road, instants=5):
    laws = {name: law.complete_for(CORNER) for name in ("front", "rear")}
    return RunSetting(laws, dict.fromkeys(laws, CORNER), (), instants, road)


def test_a_planner_gives_each_corner_its_own_channels_and_road() -> None:
    law = PreviewMPC(
        actuator=ActiveActuator(force_limit=1e6, lag=0.01), keep_contact=False, preview=0.03
    )
    roads = {"front": 0.01, "rear": -0.02}
    asked = {}

    def road(name, times):
        asked[name] = times
        return roads[name] * np.sin(40.0 * times)

    planner = _Planner(law, setting(law, road))
    np.testing.assert_allclose(asked["rear"], np.arange(12) / 200.0)
    assert planner.channels[:2] == ("front.strut.deflection", "front.sprung.vz")
    assert planner.channels[5] == "rear.strut.deflection"
    alone = [
        _Plan(law, law.actuator, CORNER, 6, roads[name] * np.sin(40.0 * asked[name]))
        for name in roads
    ]
    seen = [[0.012, 0.2, -0.002, -0.4, -0.48], [-0.01, 0.1, 0.003, 0.3, 0.16]]
    planner.start()
    for turn in range(3):
        commands = planner([*seen[0], *seen[1], 0.0])
        expected = [plan.command(values, turn) for plan, values in zip(alone, seen, strict=True)]
        assert commands == pytest.approx(expected, rel=1e-9)
        for plan, command in zip(alone, commands, strict=True):
            plan.follow(command)


@pytest.mark.parametrize(("preview", "steps"), [(1.0, 200), (1.005, 201)])
def test_longest_plan(preview: float, steps: int, monkeypatch: pytest.MonkeyPatch) -> None:
    made = []
    monkeypatch.setattr(
        "jounce.control.preview._Plan", lambda *a: made.append(a[3]) or SimpleNamespace()
    )
    law = PreviewMPC(preview=preview)
    if steps > 200:
        with pytest.raises(
            SimulationError, match=r"found '201 \(preview times rate\)'; allowed: at most 200"
        ):
            _Planner(law, setting(law, lambda _, t: 0.0 * t))
    else:
        _Planner(law, setting(law, lambda _, t: 0.0 * t))
        assert made == [200, 200]


def test_commands_are_clipped_then_limited_in_rate() -> None:
    slow = Skyhook(
        actuator=SemiActiveDamper(minimum=100.0, maximum=900.0, rate_limit=20e3), rate=100.0
    )
    free = Skyhook(actuator=ActiveActuator(force_limit=50.0), rate=100.0)
    limits = CommandLimits({"front": slow, "rear": free})
    limits.start()
    turns = [
        limits.apply(list(pair))
        for pair in ((5000.0, 70.0), (450.0, -70.0), (-3.0, 20.0), (math.nan, 0.0))
    ]
    assert turns[:3] == [[300.0, 50.0], [450.0, -50.0], [250.0, 20.0]]
    assert math.isnan(turns[3][0])
    limits.start()
    assert limits.apply([5000.0, 0.0])[0] == 300.0  # from the softest again


def test_a_program_keeps_the_order_of_corners_and_limits_rates() -> None:
    law = controller(
        "pid", rate=100.0, actuator={"kind": "active", "force_limit": 500.0, "rate_limit": 3e3}
    )
    made = program(law, ("front", "rear"))
    assert made.memory == 8
    models = {"front": CORNER, "rear": CornerModel(300.0, 30.0, 20e3, 180e3, 1000.0)}
    numbers = values(dict.fromkeys(models, law), models, made.numbers)
    assert numbers[made.numbers.index("rear.rate_limit")] == pytest.approx(30.0)
    at = dict(zip(made.numbers, numbers, strict=True))
    assert at["front.proportional"] == pytest.approx(2000.0)
    assert at["rear.proportional"] == pytest.approx(4.0 / 3.0 * 1000.0)
    measured = [{"front.sprung.vz": 0.9, "rear.sprung.vz": 0.03}[name] for name in made.channels]
    memory = [0.0, 0.0, -0.9, 0.0, 0.0, -0.03, -100.0, -25.0]
    found = np.asarray(made.function(memory, [*measured, 0.0], numbers, [])).ravel()
    assert found[:2] == pytest.approx([-130.0, -40.0])  # -500 held back; -40 within reach
    assert found[-2:] == pytest.approx(found[:2])
    assert [found[4], found[7]] == pytest.approx([-0.9, -0.03])


@pytest.mark.source(
    kind="program",
    key="scipy",
    of="control",
    where="its SLSQP",
    tolerance="what its search leaves, 0.1 %",
    compares="first force of a plan beyond its limits",
)
def test_a_plan_beyond_its_limits_goes_over_by_what_it_costs() -> None:
    """Stroke and tyre load are soft: the first force is that of the problem with two slacks, solved by SciPy."""
    law = PreviewMPC(actuator=ActiveActuator(force_limit=1e6, lag=0.0), stroke=0.01, preview=0.02)
    plan, horizon = _Plan(law, law.actuator, CORNER, 4, np.zeros(12)), _horizon(law, CORNER, 4)
    state = np.array(
        [0.016, 0.9, 0.024, 0.3]
    )  # apart by more than the stroke, and the tyre nearly off the road
    free, contact = horizon.Fx @ state, 440.0 * CORNER.gravity / 200e3
    rows, room = [], []  # rows @ z <= room, of four forces (kN) and two slacks (cm)
    for i in range(1, 5):
        for index, sign, limit, slack in (
            (0, 1.0, 0.01, 4),
            (0, -1.0, 0.01, 4),
            (2, 1.0, contact, 5),
        ):
            rows.append(
                [*(sign * 1e3 * horizon.Fu[4 * i + index]), *(-1e-2 * (np.arange(4, 6) == slack))]
            )
            room.append(limit - sign * free[4 * i + index])
    rows = np.vstack([1e3 * np.array(rows), -np.eye(6)[4:]])  # limits in mm; no slack is negative
    room = np.append(1e3 * np.array(room), [0.0, 0.0])
    scale = np.array([*[1e3] * 4, 1e-2, 1e-2])
    hessian = 1e-2 * horizon.H * np.outer(scale, scale)
    linear = 1e-2 * scale * np.append(horizon.gx @ state, [0.0, 0.0])
    best = minimize(
        lambda z: 0.5 * z @ hessian @ z + linear @ z,
        np.zeros(6),
        jac=lambda z: hessian @ z + linear,
        method="SLSQP",
        constraints={"type": "ineq", "fun": lambda z: room - rows @ z, "jac": lambda _: -rows},
        options={"ftol": 1e-14, "maxiter": 500},
    )
    assert_is_least(best.x, hessian, linear, rows, room)
    assert min(best.x[4:]) > 0.01  # both limits are exceeded
    found = plan.command(
        [-0.8 * state[0], state[1], -state[2], state[3], -0.8 * (state[1] - state[3])], 0
    )
    assert found == pytest.approx(1e3 * best.x[0] / 0.8, rel=1e-3)


def assert_is_least(z, hessian, linear, rows, room) -> None:
    """Check the conditions of Karush, Kuhn and Tucker: whether a search claims success hangs on the last bit."""
    inside = room - rows @ z
    holding = inside < 1e-6
    multipliers, left = nnls(rows[holding].T, -(hessian @ z + linear))
    assert np.min(inside) > -1e-6
    assert left < 1e-6 * np.max(multipliers)
