"""Controlled suspensions: invariants, balance of power, optimality, closed forms, what the loop samples and holds."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from scipy.linalg import expm, solve_continuous_are, solve_continuous_lyapunov

import jounce as jn
from jounce.control import (
    LQG,
    LQR,
    ActiveActuator,
    CornerModel,
    MagnetorheologicalDamper,
    Passive,
    PythonControl,
    SemiActiveDamper,
    Skyhook,
    controller,
)
from jounce.control.design import (
    Targets,
    Weights,
    corner_equations,
    corner_outputs,
    cost_matrices,
    h_infinity,
    observer,
    regulator_gains,
)
from jounce.control.laws import LQG_CHANNELS
from jounce.simulation.controlled import closed_loop_poles
from jounce.simulation.corner_models import corner_models

CORNER = CornerModel(400.0, 40.0, 25e3, 200e3, 1500.0)
FORMULAS = [
    "skyhook",
    "skyhook-two-state",
    "groundhook",
    "groundhook-two-state",
    "hybrid",
    "add",
    "sh-add",
    "pid",
    "active-skyhook",
    "lqr",
    "clipped-lqr",
    "lqg",
    "clipped-lqg",
]
MR_OFF = {"kind": "tanh", "coefficient": 500.0, "force": 60.0, "slope": 20.0}
MR_ON = {"kind": "tanh", "coefficient": 1500.0, "force": 900.0, "slope": 20.0}


def car(**tyre: object) -> jn.QuarterCar:
    return jn.QuarterCar(
        sprung={"mass": 400.0},
        unsprung={"mass": 40.0},
        strut={"spring": {"rate": 25e3}, "damper": {"coefficient": 1500.0}},
        tyre={"stiffness": 200e3, "lift_off": False, **tyre},
    )


def constant(command: float) -> Callable[[dict[str, float], float], float]:
    return lambda _measurement, _t: command


@pytest.fixture(scope="module")
def bump() -> jn.Trial:
    return jn.Trial(
        road=jn.HalfSine(height="40 mm", length="0.5 m", start="1 m"),
        speed="10 m/s",
        duration="2 s",
    )


@pytest.mark.parametrize(
    "name", [*FORMULAS, "h-infinity", "clipped-h-infinity", "mpc", "active-mpc"]
)
def test_masses_and_tyre_are_in_balance_under_any_law(name: str, bump: jn.Trial) -> None:
    if "h-infinity" in name:
        pytest.importorskip("slycot")
    # domain H: m_s a_s + m_u a_u + k_t (z_u - z_r) = weight, whatever acts between the masses
    run = jn.simulate(car(), bump, control=name)
    inertia = 400.0 * run["sprung.az"] + 40.0 * run["unsprung.az"]
    rest = inertia + 440.0 * 9.81 - run["tyre.force"]
    assert float(abs(rest).max()) < 1e-11 * float(run["tyre.force"].max())
    assert float(abs(run["command"]).max()) > 0.0


@pytest.mark.parametrize(
    "gains", [(0.0, 4000.0, 0.0, 0.0), (300.0, 3000.0, -3000.0, 390.0), (-9e3, 10.0, 8e3, -20.0)]
)
def test_invariant_points_do_not_move_under_any_law(gains: tuple[float, ...]) -> None:
    # domain H: z_s'' / z_r = k_t / m_s at sqrt(k_t / m_u); (z_s - z_u) / z_r = M / m_s at sqrt(k_t / M)
    A, B, G = corner_equations(CORNER)
    closed = A - B @ np.array([gains])

    def response(w: float) -> np.ndarray:
        return np.linalg.solve(1j * w * np.eye(4) - closed, G[:, 0] * 1j * w)

    w = np.sqrt(200e3 / 40.0)
    assert abs(1j * w * response(w)[1]) == pytest.approx(500.0, rel=1e-9)
    assert abs(response(np.sqrt(200e3 / 440.0))[0]) == pytest.approx(1.1, rel=1e-9)


def test_channels_of_the_corner_model_are_those_of_the_rig() -> None:
    model = jn.linearise(car())
    names = ("strut.deflection", "strut.velocity", "sprung.vz", "sprung.az")
    names += ("tyre.deflection", "tyre.force", "unsprung.vz", "unsprung.az")
    A, _, G = corner_equations(CORNER)
    C, _ = corner_outputs(CORNER, names)
    for frequency in (0.7, 6.0):
        s = 2j * np.pi * frequency
        found = C @ np.linalg.solve(s * np.eye(4) - A, G[:, 0]) * s
        for name, value in zip(names, found, strict=True):
            assert value == pytest.approx(
                model.frequency_response([frequency], name)[0], rel=1e-9
            ), name
    _, D = corner_outputs(CORNER, ("sprung.az", "unsprung.az", "tyre.force"))
    assert D.ravel() == pytest.approx([1.0 / 400.0, -1.0 / 40.0, 0.0])  # a force lifts the body


def test_the_observer_is_where_predicting_and_correcting_settle() -> None:
    deviations, period = np.array([2e-3, 0.05, 0.4]), 0.01
    channels = ("strut.deflection", "sprung.vz", "sprung.az")
    found = observer(CORNER, channels, deviations, 1e-3, 2e-3, period)
    A, _, G = corner_equations(CORNER)
    spread = 1e-3 * G @ G.T + np.diag([0.0, 2e-3, 0.0, 2e-3])
    grown = [expm(A * t) for t in period * (np.arange(200) + 0.5) / 200]
    added = sum(one @ spread @ one.T for one in grown) * period / 200
    C, _ = corner_outputs(CORNER, channels)
    P, L = 1e-2 * np.eye(4), np.zeros((4, 3))
    for _ in range(3000):
        P = found.F @ P @ found.F.T + added
        L = P @ C.T @ np.linalg.inv(C @ P @ C.T + np.diag(deviations**2))
        P = (np.eye(4) - L @ C) @ P
    np.testing.assert_allclose(found.F, expm(A * period), atol=1e-10)
    np.testing.assert_allclose(found.L, L, rtol=1e-3, atol=1e-3 * abs(L).max(axis=0).min())


@pytest.mark.parametrize(
    "name", [n for n in FORMULAS if not isinstance(controller(n).actuator, ActiveActuator)]
)
def test_a_damper_only_takes_energy_within_its_bounds(name: str, bump: jn.Trial) -> None:
    damper = SemiActiveDamper(minimum=300.0, maximum=4000.0, lag=0.005)
    run = jn.simulate(car(), bump, control=controller(name, actuator=damper))
    assert float((run["actuator.force"] * run["strut.velocity"]).min()) >= 0.0
    assert 300.0 <= float(run["command"].min()) <= float(run["command"].max()) <= 4000.0


def test_commands_change_at_control_instants_only(bump: jn.Trial) -> None:
    run = jn.simulate(car(), bump, control=Skyhook(rate=50.0), output_step=1e-3)
    changed = np.flatnonzero(np.diff(run["command"].to_numpy())) + 1
    assert len(changed) > 20
    assert set(changed % 20) == {0}


def test_lag_is_of_first_order() -> None:
    # from rest the coefficient goes to a constant command as 1 - exp(-t / lag): seen through the force over velocity
    trial = jn.Trial(road=jn.Step(height="10 mm", start="0.01 m"), speed="10 m/s", duration="0.2 s")
    actuator = SemiActiveDamper(minimum=300.0, maximum=4000.0, lag=0.02)
    run = jn.simulate(car(), trial, control=Passive(damping_coefficient=3000.0, actuator=actuator))
    after = run.sel(time=slice(0.01, 0.1))
    found = (after["actuator.force"] / after["strut.velocity"]).to_numpy()
    expected = 3000.0 + (300.0 - 3000.0) * np.exp(-after["time"].to_numpy() / 0.02)
    np.testing.assert_allclose(found, expected, rtol=1e-6)


def test_second_order_actuator_answers_a_step_by_its_closed_form() -> None:
    # F'' + 2 zeta w F' + w^2 F = w^2 F0: critically damped F = F0 (1 - (1 + w t) exp(-w t))
    trial = jn.Trial(road=jn.Flat(), speed="10 m/s", duration="0.2 s")
    actuator = ActiveActuator(bandwidth=20.0, force_limit=1000.0)
    run = jn.simulate(
        car(), trial, control=PythonControl(function=constant(500.0), actuator=actuator)
    )
    wt = 2.0 * np.pi * 20.0 * run["time"].to_numpy()
    np.testing.assert_allclose(
        run["actuator.force"], 500.0 * (1.0 - (1.0 + wt) * np.exp(-wt)), atol=1e-4
    )


def test_rate_limit_holds_commands_back(bump: jn.Trial) -> None:
    damper = SemiActiveDamper(minimum=300.0, maximum=4000.0, rate_limit=2e5)
    for control in (
        "skyhook-two-state",
        PythonControl(function=lambda m, _: 1e9 * m["strut.velocity"]),
    ):
        law = controller(control, actuator=damper) if isinstance(control, str) else control
        law = law.model_copy(update={"actuator": damper})
        run = jn.simulate(car(), bump, control=law)
        steps = np.abs(np.diff(run["command"].to_numpy()))
        assert steps.max() == pytest.approx(200.0, rel=1e-9)  # 2e5 N s/m per s, 1 ms


def test_a_python_function_is_the_compiled_law(bump: jn.Trial) -> None:
    def skyhook(measurement: dict[str, float], t: float) -> float:
        force = -3000.0 * measurement["sprung.vz"]
        velocity = measurement["strut.velocity"]
        return (
            force / velocity if force * velocity > 1e-12 else 300.0
        )  # at rest rounding has no say

    damper = SemiActiveDamper(minimum=300.0, maximum=4000.0, lag=0.008)
    runs = [
        jn.simulate(car(), bump, control=PythonControl(function=skyhook, actuator=damper)),
        jn.simulate(car(), bump, control=Skyhook(damping_coefficient=3000.0, actuator=damper)),
    ]
    for channel in ("sprung.az", "tyre.force", "command"):
        a, b = (run[channel].to_numpy() for run in runs)
        np.testing.assert_allclose(a, b, atol=1e-9 * np.ptp(b))


def test_force_on_an_active_actuator_is_the_ideal_skyhook() -> None:
    # frequency response of the linear closed form (2 Hz) with an ideal actuator and a high rate
    frequency, c_sky = 2.0, 3000.0
    t = np.arange(0.0, 12.0 + 1e-9, 2e-3)
    height = 5e-3 * np.sin(2.0 * np.pi * frequency * t)
    trial = jn.Trial(excitation=jn.Excitation(time=t, height=height))
    actuator = ActiveActuator(force_limit=1e6, lag=0.0)
    law = Skyhook(damping_coefficient=c_sky, actuator=actuator, rate=10e3)
    run = jn.simulate(car(), trial, control=law)
    s = 2j * np.pi * frequency
    A, B, G = corner_equations(CORNER)
    closed = A - B @ np.array([[0.0, c_sky, 0.0, 0.0]])
    velocity = np.linalg.solve(s * np.eye(4) - closed, G[:, 0])[1] * s * 5e-3
    tail = run["sprung.vz"].to_numpy()[-2000:]
    assert np.sqrt(2.0) * np.std(tail) == pytest.approx(abs(velocity), rel=2e-3)


@pytest.mark.parametrize("damping", [0.0, 1500.0])
def test_regulator_is_optimal(damping: float) -> None:
    weights = Weights(4e3, 4e4, 0.0)
    A, B, _ = corner_equations(CORNER, damping)
    Q, R, S = cost_matrices(CORNER, weights, damping)
    K = regulator_gains(CORNER, weights, damping)
    X = solve_continuous_are(A, B, Q, R, s=S)
    np.testing.assert_allclose(K, np.linalg.solve(R, B.T @ X + S.T)[0], rtol=1e-8)
    start = np.diag([1e-2, 0.1, 1e-2, 1.0]) ** 2

    def cost(gains: np.ndarray) -> float:
        closed = A - B @ gains[None, :]
        if np.max(np.linalg.eigvals(closed).real) >= 0.0:
            return np.inf
        along = Q + np.outer(gains, gains) * R[0, 0] - S @ gains[None, :] - gains[:, None] @ S.T
        return float(np.trace(solve_continuous_lyapunov(closed.T, -along) @ start))

    best, rng = cost(K), np.random.default_rng(4)
    assert best == pytest.approx(float(np.trace(X @ start)), rel=1e-8)
    for _ in range(40):
        changed = K + 0.02 * rng.standard_normal(4) * np.abs(K)
        assert cost(changed) > best
    for i in range(4):  # the slope vanishes
        step = 1e-2 * max(abs(K[i]), 100.0)
        up, down = K.copy(), K.copy()
        up[i] += step
        down[i] -= step
        assert abs(cost(up) - cost(down)) < 2e-2 * (cost(up) + cost(down) - 2.0 * best)


def test_poles_of_the_regulator_are_those_of_its_matrix() -> None:
    law = LQR(deflection_weight=4e3, tyre_weight=4e4, actuator=ActiveActuator(lag=0.0), rate=1e5)
    A, B, _ = corner_equations(CORNER)
    closed = A - B @ law.gains(CORNER)[None, :]
    expected = np.sort_complex(np.linalg.eigvals(closed))
    found = closed_loop_poles(car(), law)
    found = np.sort_complex(found[np.abs(found) < 1e3])
    np.testing.assert_allclose(found, expected, rtol=5e-3)


def test_sampled_poles_of_a_held_force() -> None:
    # domain of one hold: x+ = (F - H K) x, F and H from the exponential of the plant
    law, period = LQR(actuator=ActiveActuator(lag=0.0), rate=50.0), 0.02
    A, B, _ = corner_equations(CORNER)
    whole = expm(np.block([[A, B], [np.zeros((1, 5))]]) * period)
    step = whole[:4, :4] - whole[:4, 4:] @ law.gains(CORNER)[None, :]
    expected = np.sort(np.abs(np.linalg.eigvals(step)))
    found = np.sort(np.abs(np.exp(closed_loop_poles(car(), law) * period)))
    np.testing.assert_allclose(found[-4:], expected, rtol=1e-6)


@pytest.mark.parametrize("rate", [50.0, 1000.0])
def test_regulator_and_filter_keep_their_own_poles(rate: float) -> None:
    # separation: with the true plant the poles are those of the regulator and those of the filter
    law = LQG(actuator=ActiveActuator(lag=0.0), rate=rate)
    A, B, _ = corner_equations(CORNER)
    filter_ = observer(
        CORNER, LQG_CHANNELS, np.array([0.05, 0.05, 5e-4]), 1.0106e-3, 1e-3, 1.0 / rate
    )
    step = expm(np.block([[A, B], [np.zeros((1, 5))]]) / rate)
    regulated = np.linalg.eigvals(step[:4, :4] - step[:4, 4:] @ law.gains(CORNER)[None, :])
    filtered = np.linalg.eigvals((np.eye(4) - filter_.L @ filter_.C) @ step[:4, :4])
    found = np.exp(closed_loop_poles(car(), law) / rate)
    for expected in (*regulated, *filtered):
        assert np.min(np.abs(found - expected)) < 1e-6


def test_controllers_do_what_they_are_for(rough: jn.Trial) -> None:
    def comfort(control: object) -> float:
        return float(jn.simulate(car(), rough, control=control)["sprung.az"].std())

    passive = comfort(None)
    assert comfort("skyhook") < 0.9 * passive
    assert comfort("lqr") < 0.85 * passive
    assert comfort("clipped-lqr") < 0.95 * passive
    assert comfort("lqg") == pytest.approx(comfort("lqr"), rel=0.03)
    assert comfort("active-mpc") < 0.95 * comfort("lqr")  # it sees the road ahead


@pytest.fixture(scope="module")
def rough() -> jn.Trial:
    rng = np.random.default_rng(2)
    t = np.arange(0.0, 8.0, 0.005)
    white = rng.standard_normal(len(t)) * np.sqrt(1.0106e-3 / 0.005)
    height = np.cumsum(white) * 0.005
    return jn.Trial(excitation=jn.Excitation(time=t, height=height - height[0]))


def test_h_infinity_lowers_acceleration_and_tyre_load_for_no_stroke(rough: jn.Trial) -> None:
    pytest.importorskip("slycot")
    runs = [jn.simulate(car(), rough, control=control) for control in (None, "h-infinity")]
    for channel, share in (
        ("sprung.az", 0.98),
        ("tyre.deflection", 0.995),
        ("strut.deflection", 1.03),
    ):
        passive, active = (float(run[channel].std()) for run in runs)
        assert active < share * passive


def test_preview_begins_before_the_bump() -> None:
    trial = jn.Trial(
        road=jn.HalfSine(height="40 mm", length="0.5 m", start="10 m"),
        speed="10 m/s",
        duration="1.2 s",
    )
    run = jn.simulate(car(), trial, control=controller("active-mpc", preview="0.1 s"))
    command = run["command"]
    assert float(abs(command.sel(time=slice(0.0, 0.88))).max()) < 1.0
    assert float(abs(command.sel(time=slice(0.9, 0.999))).max()) > 20.0


def test_stroke_is_kept_by_the_planner() -> None:
    trial = jn.Trial(
        road=jn.HalfSine(height="60 mm", length="2 m", start="10 m"), speed="10 m/s", duration="3 s"
    )
    strokes = []
    for stroke in (None, "20 mm"):
        law = controller(
            "active-mpc",
            preview="0.2 s",
            stroke=stroke,
            actuator=ActiveActuator(force_limit=8000.0, lag=0.0),
        )
        run = jn.simulate(car(), trial, control=law)
        strokes.append(float(abs(run["strut.deflection"] - run["strut.deflection"][0]).max()))
    assert strokes[0] > 0.024
    assert strokes[1] < 0.0215


def test_magnetorheological_damper_follows_its_law(bump: jn.Trial) -> None:
    damper = MagnetorheologicalDamper(off=MR_OFF, on=MR_ON, maximum=5.0, lag=0.0)
    run = jn.simulate(car(), bump, control=Skyhook(actuator=damper))
    share = run["command"] / 5.0
    velocity = run["strut.velocity"]
    force = (500.0 + 1000.0 * share) * velocity + (60.0 + 840.0 * share) * np.tanh(20.0 * velocity)
    np.testing.assert_allclose(run["actuator.force"], force, atol=1e-9 * float(abs(force).max()))
    assert 0.0 <= float(run["command"].min()) < 0.01
    assert 1.0 < float(run["command"].max()) <= 5.0


def test_magnetorheological_damper_gives_the_force_that_is_wished(bump: jn.Trial) -> None:
    damper = MagnetorheologicalDamper(off=MR_OFF, on=MR_ON, maximum=5.0, lag=0.0)
    run = jn.simulate(
        car(), bump, control=Skyhook(damping_coefficient=2500.0, actuator=damper, rate=1000.0)
    )
    run = run.isel(time=slice(0, -1))  # at the end of the run no new command is made
    inside = (run["command"] > 1e-6) & (run["command"] < 5.0 - 1e-6)
    wished = -2500.0 * run["sprung.vz"]
    assert int(inside.sum()) > 100
    missed = float(abs(run["actuator.force"] - wished).where(inside).max())
    assert missed < 1e-6 * float(abs(wished).max())  # seen at the instants


def test_bouc_wen_law_off_is_the_passive_damper(bump: jn.Trial) -> None:
    law = {
        "kind": "bouc-wen",
        "coefficient": 900.0,
        "hysteretic_force": 150.0,
        "rate": 500.0,
        "sigma": 0.8,
        "exponent": 1.5,
    }
    rig = jn.QuarterCar(
        sprung={"mass": 400.0}, unsprung={"mass": 40.0}, tyre={"stiffness": 200e3},
        strut={"spring": {"rate": 25e3}, "damper": law},
    )  # fmt: skip
    damper = MagnetorheologicalDamper(off=law, on={**law, "hysteretic_force": 900.0}, maximum=5.0)
    off = jn.simulate(rig, bump, control=PythonControl(function=constant(0.0), actuator=damper))
    passive = jn.simulate(rig, bump)
    np.testing.assert_allclose(
        off["strut.force"], passive["strut.force"], atol=2e-3 * float(passive["strut.force"].std())
    )


def test_corners_of_vehicles_carry_the_whole_car() -> None:
    for name in ("audi-a6-half-car-4dof", "audi-a6-full-car"):
        vehicle = jn.load(name)
        values, models = vehicle.parameters(), corner_models(vehicle)
        wheels = 2.0 if len(models) == 2 else 1.0
        assert wheels * sum(model.sprung_mass for model in models.values()) == pytest.approx(
            values["body.mass"], rel=1e-9
        )
        for corner, model in models.items():
            axle = corner.partition("_")[0]
            assert model.unsprung_mass == pytest.approx(values[f"{axle}.unsprung_mass"], rel=1e-9)
            assert model.spring_rate == pytest.approx(values[f"{axle}.spring_rate"], rel=1e-9)
            assert model.damping_coefficient == pytest.approx(
                values[f"{axle}.damping_coefficient"], rel=1e-9
            )
            assert model.motion_ratio == pytest.approx(1.0, rel=1e-12)


def test_corner_of_an_inclined_strut_is_that_of_the_wheel() -> None:
    rig = jn.QuarterCar(
        sprung={"mass": 400.0}, unsprung={"mass": 40.0}, tyre={"stiffness": 200e3, "lift_off": False},
        strut={"angle": "30 deg", "spring": {"rate": 25e3}, "damper": {"coefficient": 1500}, "friction": {"force": 9}},
    )  # fmt: skip
    model = corner_models(rig)[""]  # dry friction is no part of its damper
    assert model.motion_ratio == pytest.approx(np.cos(np.pi / 6.0), rel=1e-12)
    assert model.spring_rate == pytest.approx(25e3 * 0.75, rel=1e-9)
    assert model.damping_coefficient == pytest.approx(1500.0 * 0.75, rel=1e-9)
    assert model.sprung_mass == pytest.approx(400.0, rel=1e-9)


def test_skyhook_acts_at_the_wheel_through_an_inclined_strut(bump: jn.Trial) -> None:
    rig = jn.QuarterCar(
        sprung={"mass": 400.0}, unsprung={"mass": 40.0}, tyre={"stiffness": 200e3, "lift_off": False},
        strut={"angle": "30 deg", "spring": {"rate": 25e3}, "damper": {"coefficient": 1500.0}},
    )  # fmt: skip
    actuator = ActiveActuator(force_limit=1e5, lag=0.0)
    run = jn.simulate(rig, bump, control=Skyhook(damping_coefficient=2000.0, actuator=actuator))
    run = run.isel(time=slice(0, -1))  # at the end of the run no new command is made
    on_body = np.cos(np.pi / 6.0) * run["actuator.force"]
    np.testing.assert_allclose(
        on_body, -2000.0 * run["sprung.vz"], atol=1e-6 * float(abs(on_body).max())
    )


def test_a_symmetric_full_car_is_controlled_symmetrically() -> None:
    trial = jn.Trial(
        road=jn.HalfSine(height="40 mm", length="0.5 m", start="1 m"),
        speed="10 m/s",
        duration="2 s",
    )
    run = jn.simulate(jn.load("audi-a6-full-car"), trial, control="skyhook")
    for axle in ("front", "rear"):
        left, right = (
            run[f"{axle}_{side}.actuator.force"].to_numpy() for side in ("left", "right")
        )
        np.testing.assert_allclose(left, right, atol=1e-6 * np.ptp(left))
    assert float(abs(run["body.roll"]).max()) < 1e-9
    passive = jn.simulate(jn.load("audi-a6-full-car"), trial)
    assert float(run["body.az"].std()) < float(passive["body.az"].std())


def test_noise_is_reproducible_and_only_that(bump: jn.Trial) -> None:
    flat = jn.Trial(road=jn.Flat(), speed="10 m/s", duration="2 s")
    noisy = Skyhook(
        noise={"sprung.vz": "0.05 m/s"}, actuator=ActiveActuator(lag=0.0, force_limit=1e5), seed=3
    )
    runs = [
        jn.simulate(car(), flat, control=law)
        for law in (noisy, noisy, noisy.model_copy(update={"seed": 4}))
    ]
    np.testing.assert_array_equal(runs[0]["command"], runs[1]["command"])
    assert float(abs(runs[0]["command"] - runs[2]["command"]).max()) > 1.0
    gain = 8.0 / 3.0 * 1500.0
    measured = -runs[0]["command"] / gain - runs[0]["sprung.vz"]
    assert float(measured.std()) == pytest.approx(0.05, rel=0.05)


def test_h_infinity_reaches_its_norm() -> None:
    pytest.importorskip("slycot")
    targets = Targets(0.05, 8.0, 0.04, 3924.0, (0.01, 0.5))
    made, norm = h_infinity(CORNER, targets, 100.0, 1e-3)
    assert np.max(np.abs(np.linalg.eigvals(made.A))) < 1.0
    A, B, G = corner_equations(CORNER)
    C, D = corner_outputs(CORNER, ("strut.deflection", "sprung.az"))
    worst = 0.0
    for w in np.logspace(
        0.0, 2.0, 300
    ):  # road to weighted acceleration, around the sampled controller
        s, z = 1j * w, np.exp(1j * w * 1e-3)
        K = made.C @ np.linalg.solve(z * np.eye(6) - made.A, made.B) + made.D
        plant = np.linalg.solve(s * np.eye(4) - A, np.hstack([B, G * s * targets.road]))
        force, road = C @ plant[:, :1] + D, C @ plant[:, 1:]
        lagged = 100.0 / (s + 100.0) * K
        u = np.linalg.solve(np.eye(1) - lagged @ force, lagged @ road)
        worst = max(worst, abs((force @ u + road)[1, 0]) / targets.acceleration)
    assert 0.3 * norm < worst < 1.02 * norm
