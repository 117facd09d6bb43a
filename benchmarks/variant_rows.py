"""Rows of the benchmark table for many runs: ten thousand quarter cars, and a thousand full cars, metrics only.

``python benchmarks/variant_rows.py`` prints them alone. The quarter cars drive over the long random road of the linear
problem, with lift-off also at three times its height. Peers that are written by hand know the equations of this one
model, and do not locate when a tyre lifts off; their error is that of ``rms sprung.az`` against ours. Slow methods
are timed with fewer variants, which the row states.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from mechanism_peers import PEERS, cheapest
from mechanism_problem import Case
from problems import Array, QuarterCar, long_road
from timing import Row, markdown, median_time

import jounce as jn

WISHBONE = Path(__file__).parent.parent / "tests" / "files" / "prototype-double-wishbone.toml"
COUNT, FULL, FEWER, CARS = 10_000, 2_000, 200, 1_000
METRICS = ["rms sprung.az", "max tyre.force", "range strut.deflection"]
SPREAD = {"strut.spring.rate": "20 %", "sprung.mass": ["14 kg", "18 kg"]}
_STEP = 1e-3


def variant_rows() -> list[Row]:
    """Quarter cars without and with lift-off, then full cars and double wishbones."""
    rig = jn.load("kart-quarter-car")
    held = rig.with_changes({"tyre.lift_off": False})
    return [
        *_quarter_cars("linear", held, 1.0, "≤ 0.2 s on two cores"),
        *_quarter_cars("lift-off enabled but not reached", rig, 1.0, "≤ 0.4 s on two cores"),
        *_quarter_cars("three times as rough, with lift-off", rig, 3.0, "≤ 5 s on two cores"),
        *_full_cars(),
        *_double_wishbones(),
    ]


def _quarter_cars(title: str, rig: jn.Rig, height: float, target: str) -> list[Row]:
    time, road = long_road()
    trial = jn.Trial(
        road=jn.Table(x=time, height=height * road), speed="1 m/s", duration=float(time[-1])
    )
    problem = f"{_shown(COUNT)} quarter cars, {title}, road of 10 s at 1 kHz, 3 metrics"
    design = jn.sobol(SPREAD, COUNT, seed=1)
    found: list[Any] = []
    own = median_time(
        lambda: found.append(jn.simulate_many(rig, trial, design, metrics=METRICS)), repeats=5
    )
    many = found[-1]
    rows = [
        Row(
            problem,
            "jounce, simulate_many",
            own,
            None,
            1.0,
            target,
            f"{many.attrs['side_by_side']} per batch",
        )
    ]
    one = median_time(
        lambda: jn.simulate_many(rig, trial, design, metrics=METRICS, threads=1), repeats=3
    )
    rows.append(Row(problem, "jounce, one thread", one, None, one / own))
    few = {path: many[path].values[:FEWER] for path in SPREAD}
    alone = (
        median_time(lambda: [_alone(rig, trial, few, i) for i in range(20)], repeats=3) * COUNT / 20
    )
    rows.append(
        Row(problem, "jounce, jn.simulate one by one", alone, None, alone / own, note="from 20")
    )
    for name, count, run in _peers(many, height * road, linear=not rig.tyre.lift_off):
        seconds = median_time(run, repeats=3) * COUNT / count
        expected = many["rms sprung.az"].values[:count]
        error = float(np.max(np.abs(run() / expected - 1.0)))
        note = "error of rms sprung.az" + ("" if count == COUNT else f", from {count}")
        rows.append(Row(problem, name, seconds, error, seconds / own, note=note))
    return rows


def _shown(count: int) -> str:
    return f"{count:,}".replace(",", " ")


def _alone(rig: jn.Rig, trial: jn.Trial, few: dict[str, Array], i: int) -> float:
    run = jn.simulate(
        rig.with_changes({path: float(values[i]) for path, values in few.items()}), trial
    )
    return float(np.sqrt(np.mean(run["sprung.az"].values ** 2)))


def _peers(many: Any, road: Array, *, linear: bool) -> list[tuple[str, int, Callable[[], Array]]]:  # noqa: ANN401
    """Name, number of variants, and function that returns ``rms sprung.az`` of each."""
    rate, mass = many["strut.spring.rate"].values, many["sprung.mass"].values
    if linear:
        return [
            (
                "Numba by hand, exact steps, SIMD, all cores",
                COUNT,
                lambda: _by_hand(rate, mass, road),
            ),
            (
                "SciPy lsim",
                20,
                lambda: np.array(
                    [_lsim(*pair, road) for pair in zip(rate[:20], mass[:20], strict=True)]
                ),
            ),
        ]
    return [
        (
            "Numba by hand, RK4 with 2 steps per sample, all cores",
            COUNT,
            lambda: _rk4(rate, mass, road),
        ),
        (
            "jax, vmap of the same",
            COUNT // 10,
            lambda: _jax(rate[: COUNT // 10], mass[: COUNT // 10], road),
        ),
    ]


def _lsim(rate: float, mass: float, road: Array) -> float:
    from scipy.signal import StateSpace, lsim

    car = QuarterCar(sprung=mass, rate=rate)
    a, b, _ = car.matrices()
    _, y, _ = lsim(
        StateSpace(a, b[:, None], a[2:3], np.zeros((1, 1))), road, np.arange(len(road)) * _STEP
    )
    return float(np.sqrt(np.mean(y**2)))


def _by_hand(rate: Array, mass: Array, road: Array) -> Array:
    from scipy.linalg import expm

    whole = np.zeros((len(rate), 6, 6))
    for i, (k, m) in enumerate(zip(rate, mass, strict=True)):
        a, b, _ = QuarterCar(sprung=m, rate=k).matrices()
        whole[i, :4, :4], whole[i, :4, 4], whole[i, 4, 5] = a, b, 1.0
    steps = expm(whole * _STEP)
    rows = np.concatenate([steps[:, :4], np.zeros((len(rate), 1, 6))], axis=1)
    for i in range(len(rate)):
        rows[i, 4, :4] = whole[i, 2, :4]
    blocks = np.ascontiguousarray(rows.reshape(-1, 16, 30).transpose(0, 2, 1))
    return _loops()[0](blocks, road, np.append(np.diff(road) / _STEP, 0.0)).ravel()


def _rk4(rate: Array, mass: Array, road: Array) -> Array:
    return _loops()[1](rate.reshape(-1, 16), mass.reshape(-1, 16), road).ravel()


@cache
def _loops() -> tuple[Callable[..., Array], Callable[..., Array]]:
    from numba import njit, prange

    car = QuarterCar()
    lever, damping, unsprung, tyre, gravity = (
        car.lever**2,
        car.damping,
        car.unsprung,
        car.tyre,
        car.gravity,
    )

    @njit(parallel=True, fastmath=True)
    def exact(blocks, road, slope):  # noqa: ANN001, ANN202
        count, wide = blocks.shape[0], blocks.shape[2]
        found = np.empty((count, wide))
        for block in prange(count):
            m, x, y, total = blocks[block], np.zeros((4, wide)), np.zeros((4, wide)), np.zeros(wide)
            for k in range(road.size):
                z, v = road[k], slope[k]
                for lane in range(wide):
                    a, b, c, d = x[0, lane], x[1, lane], x[2, lane], x[3, lane]
                    force = m[24, lane] * a + m[25, lane] * b + m[26, lane] * c + m[27, lane] * d
                    total[lane] += force * force
                    for i in range(4):
                        y[i, lane] = (
                            m[6 * i, lane] * a + m[6 * i + 1, lane] * b + m[6 * i + 2, lane] * c
                            + m[6 * i + 3, lane] * d + m[6 * i + 4, lane] * z + m[6 * i + 5, lane] * v
                        )  # fmt: skip
                x, y = y, x
            found[block] = np.sqrt(total / road.size)
        return found

    @njit(fastmath=True, inline="always")
    def accelerations(zs, zu, vs, vu, z, k, mass):  # noqa: ANN001, ANN202
        strut = k * lever * (zu - zs) + damping * lever * (vu - vs)
        return strut / mass - gravity, (max(tyre * (z - zu), 0.0) - strut) / unsprung - gravity

    @njit(parallel=True, fastmath=True)
    def rk4(rates, masses, road):  # noqa: ANN001, ANN202
        count, wide = rates.shape
        found, h = np.empty((count, wide)), 0.5 * _STEP
        for block in prange(count):
            x, total = np.zeros((4, wide)), np.zeros(wide)
            for lane in range(wide):
                x[1, lane] = -(masses[block, lane] + unsprung) * gravity / tyre
                x[0, lane] = x[1, lane] - masses[block, lane] * gravity / (
                    rates[block, lane] * lever
                )
            for k in range(road.size):
                rise = road[min(k + 1, road.size - 1)] - road[k]
                for lane in range(wide):
                    rate, mass = rates[block, lane], masses[block, lane]
                    a, b, c, d = x[0, lane], x[1, lane], x[2, lane], x[3, lane]
                    p1, q1 = accelerations(a, b, c, d, road[k], rate, mass)
                    total[lane] += p1 * p1
                    for half in range(2):
                        z = road[k] + 0.5 * half * rise
                        p1, q1 = accelerations(a, b, c, d, z, rate, mass)
                        c2, d2 = c + 0.5 * h * p1, d + 0.5 * h * q1
                        p2, q2 = accelerations(
                            a + 0.5 * h * c, b + 0.5 * h * d, c2, d2, z + 0.25 * rise, rate, mass
                        )
                        c3, d3 = c + 0.5 * h * p2, d + 0.5 * h * q2
                        p3, q3 = accelerations(
                            a + 0.5 * h * c2, b + 0.5 * h * d2, c3, d3, z + 0.25 * rise, rate, mass
                        )
                        c4, d4 = c + h * p3, d + h * q3
                        p4, q4 = accelerations(
                            a + h * c3, b + h * d3, c4, d4, z + 0.5 * rise, rate, mass
                        )
                        a, b = (
                            a + h / 6.0 * (c + 2.0 * c2 + 2.0 * c3 + c4),
                            b + h / 6.0 * (d + 2.0 * d2 + 2.0 * d3 + d4),
                        )
                        c, d = (
                            c + h / 6.0 * (p1 + 2.0 * p2 + 2.0 * p3 + p4),
                            d + h / 6.0 * (q1 + 2.0 * q2 + 2.0 * q3 + q4),
                        )
                    x[0, lane], x[1, lane], x[2, lane], x[3, lane] = a, b, c, d
            found[block] = np.sqrt(total / road.size)
        return found

    return exact, rk4


def _jax(rate: Array, mass: Array, road: Array) -> Array:
    return np.asarray(_jax_function()(rate, mass, road, np.append(np.diff(road), 0.0)))


@cache
def _jax_function() -> Callable[..., Any]:
    import jax
    import jax.numpy as jnp

    jax.config.update("jax_enable_x64", True)
    car, h = QuarterCar(), 0.5 * _STEP
    lever = car.lever**2

    def slope(x: Any, z: Any, k: Any, m: Any) -> Any:  # noqa: ANN401
        strut = k * lever * (x[1] - x[0]) + car.damping * lever * (x[3] - x[2])
        tyre = jnp.maximum(car.tyre * (z - x[1]), 0.0)
        return jnp.stack(
            [x[2], x[3], strut / m - car.gravity, (tyre - strut) / car.unsprung - car.gravity]
        )

    def one(k: Any, m: Any, road: Any, rise: Any) -> Any:  # noqa: ANN401
        wheel = -(m + car.unsprung) * car.gravity / car.tyre
        x = jnp.stack([wheel - m * car.gravity / (k * lever), wheel, 0.0 * m, 0.0 * m])

        def step(kept: Any, at: Any) -> Any:  # noqa: ANN401
            x, total = kept
            z, up = at
            total += slope(x, z, k, m)[2] ** 2
            for half in (0.0, 0.5):
                k1 = slope(x, z + half * up, k, m)
                k2 = slope(x + 0.5 * h * k1, z + (half + 0.25) * up, k, m)
                k3 = slope(x + 0.5 * h * k2, z + (half + 0.25) * up, k, m)
                k4 = slope(x + h * k3, z + (half + 0.5) * up, k, m)
                x = x + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)
            return (x, total), None

        return jnp.sqrt(jax.lax.scan(step, (x, 0.0 * m), (road, rise))[0][1] / len(road))

    return jax.jit(jax.vmap(one, (0, 0, None, None)))


def _full_cars() -> list[Row]:
    """Seven freedoms on an ISO road of class C, two tracks, a point every 5 cm."""
    car = jn.load("audi-a6-full-car")
    road = jn.Iso8608(class_="C", length="1300 m", step="5 cm")
    trial = jn.Trial(road=road, right=road.other_track(), speed="20 m/s", duration="60 s")
    design = jn.sobol({"body.mass": "20 %", "front.spring_rate": "20 %"}, CARS, seed=1)
    metrics, rows = (
        ["rms body.az", "max front_left.tyre.force", "range front_left.strut.deflection"],
        [],
    )
    held = car.with_changes({"front.tyre.lift_off": False, "rear.tyre.lift_off": False})
    for title, rig, target in (("linear", held, "≤ 1.5 s on two cores"), ("lift-off", car, "")):
        problem = f"{_shown(CARS)} full cars with 7 degrees of freedom, {title}, ISO road C, 60 s at 1 kHz"
        own = median_time(
            lambda rig=rig: jn.simulate_many(rig, trial, design, metrics=metrics), repeats=3
        )
        rows.append(Row(problem, "jounce, simulate_many", own, None, 1.0, target))
        alone = median_time(lambda rig=rig: jn.simulate(rig, trial), repeats=3) * CARS
        rows.append(
            Row(problem, "jounce, jn.simulate one by one", alone, None, alone / own, note="from 1")
        )
    return rows


def _double_wishbones() -> list[Row]:
    """The prototype's double wishbone over an obstacle, 3 s, its tyre lifting off: hardpoints and rates vary."""
    rig = jn.load(str(WISHBONE)).with_changes({"tyre.lift_off": True})
    road = jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m")
    trial = jn.Trial(road=road, speed="1.95 m/s", duration="3 s")
    spread = {
        path: [value - 2e-3, value + 2e-3]
        for path, value in rig.parameters().items()
        if path in _MOVED
    }
    spread |= {"strut.spring.rate": "10 %", "tyre.stiffness": "10 %"}
    design = jn.sobol(spread, COUNT, seed=1)
    found = jn.simulate_many(rig, trial, design, metrics=METRICS, tolerance=1e-4)

    def many(count: int, tolerance: float = 1e-4, **options: Any) -> Any:  # noqa: ANN401
        few = {path: found[path].values[:count] for path in spread}
        return jn.simulate_many(rig, trial, few, metrics=METRICS, tolerance=tolerance, **options)

    problem = (
        f"{_shown(COUNT)} double wishbones, unilateral tyre, obstacle, 3 s at 1 kHz, tolerance 1e-4"
    )
    own = median_time(lambda: many(COUNT), repeats=3)
    exact = many(20, 1e-8)
    error = max(
        float(np.max(np.abs(found[name].values[:20] / exact[name].values - 1.0)))
        for name in METRICS
    )
    note = f"{found.attrs['side_by_side']} per batch; largest error of a metric, from 20"
    rows = [Row(problem, "jounce, simulate_many", own, error, 1.0, "≤ 1.2 s on two cores", note)]
    one = median_time(lambda: many(COUNT, threads=1), repeats=3)
    rows.append(Row(problem, "jounce, one thread", one, None, one / own))
    alone = median_time(lambda: many(3), repeats=5) * COUNT / 3
    rows.append(
        Row(
            problem,
            "jounce, as one coordinate, one by one",
            alone,
            None,
            alone / own,
            note="from 3",
        )
    )
    full = median_time(lambda: many(FULL, method="explicit"), repeats=3) * COUNT / FULL
    note = f"from {_shown(FULL)}"
    rows.append(
        Row(problem, "jounce, full mechanism", full, None, full / own, "≤ 4 s on two cores", note)
    )
    one = median_time(lambda: many(FULL, method="explicit", threads=1), repeats=3) * COUNT / FULL
    rows.append(Row(problem, "jounce, full mechanism, one thread", one, None, one / own, note=note))
    alone = median_time(lambda: many(20, method="explicit", threads=1), repeats=5) * COUNT / 20
    way = "jounce, full mechanism, one by one on one thread"
    rows.append(
        Row(
            problem, way, alone, None, alone / own, note=f"from 20, {alone / one:.2g} times as long"
        )
    )
    name = "Pinocchio + SciPy DOP853"
    if PEERS[name].is_installed:
        peer = cheapest(name, Case("unilateral", 1.95), 1e-4)
        rows.append(
            Row(
                problem,
                name,
                peer.seconds * COUNT,
                peer.error,
                peer.seconds * COUNT / own,
                note="from one variant",
            )
        )
    return rows


_MOVED = (
    "hardpoints.upper_ball_joint[2]",
    "hardpoints.lower_ball_joint[1]",
    "hardpoints.tie_rod_outer[2]",
)


if __name__ == "__main__":
    sys.stdout.write(markdown(variant_rows()) + "\n")
