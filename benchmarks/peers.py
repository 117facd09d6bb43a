"""Peers that run the same problems. Each is tuned to the requested error."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import pairwise
from typing import Any

import numpy as np
from problems import (
    DURATION,
    SAMPLES,
    TIMES,
    Array,
    Obstacle,
    QuarterCar,
    channels_of,
    displacement_error,
)

Run = Callable[[], Array]


def road_height(t: Any, bump: Obstacle) -> Any:  # noqa: ANN401
    """Height of the half-sine bump at times ``t``, m."""
    begin, end = bump.edges
    inside = (t > begin) & (t < end)
    return np.where(
        inside, bump.height * np.sin(np.pi * (t - begin) * bump.speed / bump.length), 0.0
    )


def right_hand_side(car: QuarterCar, bump: Obstacle) -> Callable[[float, Array], Array]:
    """Plain Python right-hand side with lift-off."""
    k, c = car.rate * car.lever**2, car.damping * car.lever**2
    begin, end = bump.edges
    wave = np.pi * bump.speed / bump.length

    def rate(t: float, x: Array) -> Array:
        zs, zu, vs, vu = x
        z = bump.height * np.sin(wave * (t - begin)) if begin < t < end else 0.0
        strut = k * (zu - zs) + c * (vu - vs)
        tyre = max(car.tyre * (z - zu), 0.0)
        return np.array(
            [vs, vu, strut / car.sprung - car.gravity, (tyre - strut) / car.unsprung - car.gravity]
        )

    return rate


def scipy_runs(car: QuarterCar, bump: Obstacle) -> Iterator[tuple[str, float, Run]]:
    """SciPy's solvers; restarted at the bump's edges so that they do not step over it."""
    from scipy.integrate import solve_ivp

    rate = right_hand_side(car, bump)
    stops = [0.0, *bump.edges, DURATION]
    for method in ("LSODA", "DOP853"):
        for tolerance in (1e-6, 1e-7, 1e-8, 1e-9):

            def run(method: str = method, tolerance: float = tolerance) -> Array:
                x, parts = car.rest(), []
                for begin, end in pairwise(stops):
                    at = TIMES[(begin <= TIMES) & (end > TIMES)]
                    solution = solve_ivp(
                        rate,
                        (begin, end),
                        x,
                        method=method,
                        t_eval=np.append(at, end),
                        rtol=tolerance,
                        atol=tolerance * 1e-3,
                    )
                    parts.append(solution.y[:, : len(at)])
                    x = solution.y[:, -1]
                states = np.hstack([*parts, x[:, None]])
                channels_of(states, road_height(TIMES, bump), car, lift_off=True)
                return states

            yield f"SciPy {method}", tolerance, run


def numba_runs(car: QuarterCar, bump: Obstacle) -> Iterator[tuple[str, float, Run]]:
    """A hand-written RK4 loop in Numba, without event location: finer steps are its only tool."""
    from numba import njit

    k, c, ms, mu, kt, g = (
        car.rate * car.lever**2,
        car.damping * car.lever**2,
        car.sprung,
        car.unsprung,
        car.tyre,
        car.gravity,
    )
    begin, end = bump.edges
    wave, height = np.pi * bump.speed / bump.length, bump.height

    @njit
    def rate(t, zs, zu, vs, vu):  # noqa: ANN001, ANN202
        z = height * np.sin(wave * (t - begin)) if begin < t < end else 0.0
        strut = k * (zu - zs) + c * (vu - vs)
        return vs, vu, strut / ms - g, (max(kt * (z - zu), 0.0) - strut) / mu - g

    @njit
    def loop(x, sub, out):  # noqa: ANN001, ANN202
        h = DURATION / ((SAMPLES - 1) * sub)
        a, b, p, q = x
        for i in range((SAMPLES - 1) * sub + 1):
            if i % sub == 0:
                out[0, i // sub], out[1, i // sub], out[2, i // sub], out[3, i // sub] = a, b, p, q
            t = i * h
            a1, b1, p1, q1 = rate(t, a, b, p, q)
            a2, b2, p2, q2 = rate(
                t + h / 2, a + h / 2 * a1, b + h / 2 * b1, p + h / 2 * p1, q + h / 2 * q1
            )
            a3, b3, p3, q3 = rate(
                t + h / 2, a + h / 2 * a2, b + h / 2 * b2, p + h / 2 * p2, q + h / 2 * q2
            )
            a4, b4, p4, q4 = rate(t + h, a + h * a3, b + h * b3, p + h * p3, q + h * q3)
            a += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)
            b += h / 6 * (b1 + 2 * b2 + 2 * b3 + b4)
            p += h / 6 * (p1 + 2 * p2 + 2 * p3 + p4)
            q += h / 6 * (q1 + 2 * q2 + 2 * q3 + q4)

    out = np.empty((4, SAMPLES))
    for sub in (1, 2, 4, 8, 16, 32, 64):

        def run(sub: int = sub) -> Array:
            loop(car.rest(), sub, out)
            channels_of(out, road_height(TIMES, bump), car, lift_off=True)
            return out

        yield "Numba RK4 by hand", 1.0 / sub, run


def diffrax_runs(car: QuarterCar, bump: Obstacle) -> Iterator[tuple[str, float, Run]]:
    """diffrax Tsit5 and Dopri8, adaptive, steps landing on the bump's edges, compiled."""
    import diffrax
    import jax
    import jax.numpy as jnp

    jax.config.update("jax_enable_x64", True)
    k, c = car.rate * car.lever**2, car.damping * car.lever**2
    begin, end = bump.edges
    wave = np.pi * bump.speed / bump.length

    def rate(t: Any, x: Any, _: Any) -> Any:  # noqa: ANN401
        zs, zu, vs, vu = x
        z = jnp.where((t > begin) & (t < end), bump.height * jnp.sin(wave * (t - begin)), 0.0)
        strut = k * (zu - zs) + c * (vu - vs)
        tyre = jnp.maximum(car.tyre * (z - zu), 0.0)
        return jnp.stack(
            [vs, vu, strut / car.sprung - car.gravity, (tyre - strut) / car.unsprung - car.gravity]
        )

    for name, solver in (("Tsit5", diffrax.Tsit5()), ("Dopri8", diffrax.Dopri8())):
        for tolerance in (1e-6, 1e-7, 1e-8, 1e-9, 1e-10):
            controller = diffrax.ClipStepSizeController(
                diffrax.PIDController(rtol=tolerance, atol=tolerance * 1e-3),
                step_ts=jnp.array([begin, end]),
            )

            @jax.jit
            def solve(x: Any, solver: Any = solver, controller: Any = controller) -> Any:  # noqa: ANN401
                saved = diffrax.SaveAt(ts=jnp.asarray(TIMES))
                return diffrax.diffeqsolve(
                    diffrax.ODETerm(rate),
                    solver,
                    0.0,
                    DURATION,
                    1e-3,
                    x,
                    saveat=saved,
                    stepsize_controller=controller,
                    max_steps=100000,
                ).ys

            def run(solve: Any = solve) -> Array:  # noqa: ANN401
                states = np.asarray(solve(jnp.asarray(car.rest())).block_until_ready()).T
                channels_of(states, road_height(TIMES, bump), car, lift_off=True)
                return states

            yield f"diffrax {name}", tolerance, run


def casadi_runs(car: QuarterCar, bump: Obstacle) -> Iterator[tuple[str, float, Run]]:
    """CasADi's CVODES on the same equations; steps of at most 5 ms so that it does not step over the bump."""
    import casadi as ca

    x, t = ca.SX.sym("x", 4), ca.SX.sym("t")
    k, c = car.rate * car.lever**2, car.damping * car.lever**2
    begin, end = bump.edges
    wave = np.pi * bump.speed / bump.length
    z = ca.if_else(ca.logic_and(t > begin, t < end), bump.height * ca.sin(wave * (t - begin)), 0.0)
    strut = k * (x[1] - x[0]) + c * (x[3] - x[2])
    tyre = ca.fmax(car.tyre * (z - x[1]), 0.0)
    rate = ca.vertcat(
        x[2], x[3], strut / car.sprung - car.gravity, (tyre - strut) / car.unsprung - car.gravity
    )
    grid = np.unique(np.concatenate([TIMES, bump.edges]))
    keep = np.isin(grid, TIMES)
    for tolerance in (1e-6, 1e-7, 1e-8, 1e-9):
        options = {
            "reltol": tolerance,
            "abstol": tolerance * 1e-3,
            "max_num_steps": 1000000,
            "max_step_size": 5e-3,
        }
        solver = ca.integrator("s", "cvodes", {"x": x, "t": t, "ode": rate}, 0.0, grid[1:], options)

        def run(solver: Any = solver) -> Array:  # noqa: ANN401
            states = np.column_stack([car.rest(), solver(x0=car.rest())["xf"].full()])[:, keep]
            channels_of(states, road_height(TIMES, bump), car, lift_off=True)
            return states

        yield "CasADi CVODES", tolerance, run


def cheapest(
    runs: Iterator[tuple[str, float, Run]], reference: Array, error: float
) -> list[tuple[str, float, Run, float]]:
    """For each method the loosest setting that reaches ``error``, or the tightest if none does."""
    best: dict[str, tuple[str, float, Run, float]] = {}
    for name, setting, run in runs:
        known = best.get(name)
        if known is not None and known[3] <= error:
            continue
        best[name] = (name, setting, run, displacement_error(run(), reference))
    return list(best.values())


def linear_runs(car: QuarterCar, time: Array, road: Array) -> Iterator[tuple[str, Run]]:
    """The linear problem by other libraries: first-order hold on a uniform grid."""
    import control
    from scipy import signal

    a, b, _ = car.matrices()
    c, d = np.eye(4), np.zeros((4, 1))
    yield "scipy.signal.lsim", lambda: signal.lsim((a, b[:, None], c, d), road, time)[1].T
    system = control.ss(a, b[:, None], c, d)
    yield "python-control", lambda: control.forced_response(system, time, road).outputs
    discrete = signal.cont2discrete((a, b[:, None], c, d), time[1] - time[0], method="foh")
    filters = [
        signal.ss2tf(discrete[0], discrete[1], discrete[2][i : i + 1], discrete[3][i : i + 1])
        for i in range(4)
    ]
    yield (
        "foh discretisation + lfilter",
        lambda: np.array([signal.lfilter(n[0], m, road) for n, m in filters]),
    )
