"""Records of a bench with known values and known faults, made with NumPy only.

The code shares no laws, integrators or filters with jounce, so it cannot repeat jounce's errors.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import numpy as np

Array = np.ndarray[Any, np.dtype[np.float64]]
PLAIN = "plain"
HIDDEN = "(no file can tell)"
"""What a record is about that is as sound as the truth."""


@dataclass(frozen=True)
class Record:
    """Columns with the units of a file, true values of the part (SI), and the fault of the record.

    ``about`` is a pattern of the words by which a finding names the cause. Without one the record is correct, and a
    warning is a false alarm. ``slack`` are negligible absolute errors.
    """

    group: str
    name: str
    columns: dict[str, Array]
    truth: dict[str, float]
    about: str = ""
    choice: tuple[tuple[str, Any], ...] = ()
    slack: tuple[tuple[str, float], ...] = ()

    def text(self) -> str:
        """The file, comma-separated."""
        rows = zip(*self.columns.values(), strict=True)
        lines = [
            ",".join(self.columns),
            *(",".join(f"{value:.9g}" for value in row) for row in rows),
        ]
        return "\n".join(lines) + "\n"


def low_pass(signal: Array, rate: float, corner: float, order: int = 2) -> Array:
    """Filter causally with one-pole sections, settled on the first sample."""
    share = 1.0 - np.exp(-2.0 * np.pi * corner / rate)
    for _ in range(order):
        out, state = np.empty_like(signal), signal[0]
        for i, value in enumerate(signal):
            state += share * (value - state)
            out[i] = state
        signal = out
    return signal


def steps_of(signal: Array, size: float) -> Array:
    """Round to whole steps, like a converter with few bits."""
    return size * np.round(signal / size)


def lost(count: int, rate: float, seconds: float, times: int, seed: int = 5) -> Array:
    """Mark sections in which a logger loses the signal."""
    marks, length = np.zeros(count, bool), max(1, round(seconds * rate))
    for begin in np.random.default_rng(seed).integers(
        count // 8, count - count // 8 - length, times
    ):
        marks[begin : begin + length] = True
    return marks


def held(signal: Array, marks: Array) -> Array:
    """Repeat the last value in marked sections."""
    last = np.where(marks, 0, np.arange(len(signal)))
    return signal[np.maximum.accumulate(last)]


# dampers --------------------------------------------------------------------------------------------------------------

BUMP, REBOUND, GAS, GAS_RATE = 500.0, 1500.0, 60.0, 50.0


def run_of_dyno(
    rate: float = 500.0,
    *,
    rebound: float = REBOUND,
    gas: float = GAS,
    friction: float = 0.0,
    frequency: float = 1.0,
    rest: float = 0.0,
    noise: float = 1.0,
    seed: int = 1,
) -> tuple[Array, Array, Array]:
    """Time, stroke and force, positive in compression: a sine of 20 mm, with rests brought up and down by half a cycle.

    The machine rests in mid-stroke, where dry friction holds nothing.
    """
    t = np.arange(0.0, 6.0 / frequency + 2.0 * rest, 1.0 / rate)
    turn, end = 2.0 * np.pi * frequency * (t - rest), 12.0 * np.pi
    size = np.clip(np.minimum(turn, end - turn) / np.pi, 0.0, 1.0) if rest else np.ones_like(t)
    size = size**2 * (3.0 - 2.0 * size)
    x = 0.02 * size * np.sin(turn)
    v = np.gradient(x, t) if rest else 0.04 * np.pi * frequency * np.cos(turn)
    f = (
        np.where(v > 0.0, BUMP, rebound) * v
        + gas
        + GAS_RATE * (gas > 0.0) * x
        + friction * np.tanh(v / 2e-3)
    )
    random = np.random.default_rng(seed)
    x, f = (
        x + noise * 1e-6 * random.standard_normal(len(t)),
        f + noise * random.standard_normal(len(t)),
    )
    return t, x, f


def dampers() -> Iterator[Record]:
    """Runs of a damper dyno."""

    def record(
        group: str,
        name: str,
        t: Array,
        x: Array,
        f: Array,
        about: str = "",
        rebound: float = REBOUND,
        **choice: Any,
    ) -> Record:
        columns = {"time [s]": t, "displacement [mm]": 1e3 * x, "force [N]": f}
        truth = {"bump_coefficient": BUMP, "rebound_coefficient": rebound}
        return Record(group, name, columns, truth, about, tuple(choice.items()))

    for rate, rebound, gas, friction, rest, seed in itertools.product(
        (200.0, 1000.0), (REBOUND, BUMP), (GAS, 0.0), (0.0, 15.0), (0.0, 0.5), (1,)
    ):
        run = run_of_dyno(rate, rebound=rebound, gas=gas, friction=friction, rest=rest, seed=seed)
        about = "" if gas or rebound == BUMP else "no gas force to show"
        name = f"{rate:g} Hz, rebound {rebound:g}, gas {gas:g}, friction {friction:g}, rest {rest:g} s, {seed}"
        yield record(PLAIN, name, *run, about, rebound, friction=friction > 0.0)
    signs = [pair for pair in itertools.product((1, -1), (1, -1)) if pair != (1, 1)]
    for (stroke, force), rebound, gas, friction, rest, told in itertools.product(
        signs, (REBOUND, BUMP), (GAS, 0.0), (0.0, 15.0), (0.0, 0.5), (False, True)
    ):
        t, x, f = run_of_dyno(rebound=rebound, gas=gas, friction=friction, rest=rest)
        said = {"stroke_positive": "compression", "force_positive": "compression"} if told else {}
        name = (
            f"{stroke:+d} {force:+d}, rebound {rebound:g}, gas {gas:g}, friction {friction:g}, "
            f"rest {rest:g} s, {told}"
        )
        if told and not gas and stroke == force and rebound != BUMP:
            continue  # stated wrongly, and nothing in the record shows it
        about = "other sign|_positive|turned|stated"
        yield record(
            "sign", name, t, stroke * x, force * f, about, rebound, friction=friction > 0.0, **said
        )
    for zero, rest in itertools.product(
        (-105.0, -200.0), (0.0, 0.5)
    ):  # a gas that pulls: the load cell's zero
        for rebound in (REBOUND, BUMP):
            t, x, f = run_of_dyno(rebound=rebound, rest=rest)
            yield record(
                "datum",
                f"zero {zero:g} N, rest {rest:g} s, rebound {rebound:g}",
                t,
                x,
                f + zero,
                "gas",
                rebound,
            )
    for rebound, rest, friction, fits in itertools.product(
        (REBOUND, 600.0), (0.0, 0.5, 1.0), (0.0, 30.0), (False, True)
    ):
        t, x, f = run_of_dyno(gas=45.0, rest=rest, friction=friction, rebound=rebound)
        name = f"both turned, gas 45, rest {rest:g} s, friction {friction:g} {fits}, rebound {rebound:g}"
        yield record("sign", name, t, -x, -f, "gas", rebound, friction=fits)
    for size, frequency, noise in itertools.product(
        (1.0, 10.0, 20.0, 50.0, 100.0), (0.5, 1.0, 2.0), (0.0, 1.0)
    ):
        t, x, f = run_of_dyno(frequency=frequency, noise=noise)
        yield record(
            "steps",
            f"force {size:g} N, {frequency:g} Hz, noise {noise:g}",
            t,
            x,
            steps_of(f, size),
            "steps of",
        )
    for size, frequency in itertools.product((0.01e-3, 0.1e-3, 1e-3, 5e-3), (0.5, 2.0)):
        t, x, f = run_of_dyno(frequency=frequency)
        yield record(
            "steps",
            f"stroke {1e3 * size:g} mm, {frequency:g} Hz",
            t,
            steps_of(x, size),
            f,
            "steps of|noise of the displacement",
        )
    for corner, order, which, frequency in itertools.product(
        (1.5, 3.0, 6.0, 12.0), (1, 2), ("both", "force", "stroke"), (1.0, 2.0)
    ):
        t, x, f = run_of_dyno(frequency=frequency, rest=0.5)
        x = low_pass(x, 500.0, corner * frequency, order) if which != "force" else x
        f = low_pass(f, 500.0, corner * frequency, order) if which != "stroke" else f
        name = f"{which} low pass of order {order} at {corner:g} times {frequency:g} Hz"
        yield record("filter", name, t, x, f, "low.pass|hysteresis|behind")
    for seconds, times, which, kind in itertools.product(
        (0.02, 0.1, 0.4), (1, 5), ("force", "all"), ("zero", "held")
    ):
        t, x, f = run_of_dyno()
        marks = lost(len(t), 500.0, seconds, times)
        f = held(f, marks) if kind == "held" else np.where(marks, 0.0, f)
        if which == "all":
            x = held(x, marks) if kind == "held" else np.where(marks, 0.0, x)
        about = "dropout|stands still|missing|spikes"
        yield record("dropout", f"{which} {kind} {times} times {seconds:g} s", t, x, f, about)
    for drift, warm in itertools.product((0.0, 40.0, -150.0), (0.0, -0.15)):
        if drift or warm:
            t, x, f = run_of_dyno()
            place = t / t[-1]
            f = (f - GAS) * (1.0 + warm * (place - 0.5)) + GAS + drift * place
            yield record(
                "drift",
                f"force {drift:g} N, damping {100.0 * warm:g} %",
                t,
                x,
                f,
                "drifts|damping (falls|grows)",
            )
    t, x, f = run_of_dyno()
    for size in (2e-3, 10e-3):
        yield record("drift", f"stroke {1e3 * size:g} mm", t, x + size * t / t[-1], f, "drifts")
    yield record("exchange", "stroke and force", t, f / 1e3, 1e3 * x, "feed energy")
    yield record("exchange", "stroke in m said to be mm", t, x / 1e3, f, "range|unit|mm")
    yield record("exchange", "stroke in mm said to be m", t, 1e3 * x, f, "range|unit|mm")
    yield record("exchange", "force in kN said to be N", t, x, f / 1e3, "peak|unit|kN")
    yield record(
        "exchange", "time in ms said to be s", 1e3 * t, x, f, "sample|unit|time|clock|rate"
    )
    yield record(
        "exchange",
        "time in s said to be ms",
        t / 1e3,
        x,
        f,
        "sample|unit|time|clock|rate|power|work",
    )
    spikes = f.copy()
    spikes[[300, 900, 1500, 2100]] += 4000.0
    yield record("dropout", "four spikes", t, x, spikes, "spikes")


# springs --------------------------------------------------------------------------------------------------------------

RATE = 22.7e3


def press(
    count: int = 41,
    *,
    low: float = 0.0,
    high: float = 0.03,
    back: bool = True,
    friction: float = 3.0,
    noise: float = 1.0,
    seed: int = 1,
    preload: float = 0.0,
) -> tuple[Array, Array]:
    """Deflection and force of a spring, up and back, with dry friction in its guide."""
    way = np.linspace(low, high, count)
    way = np.concatenate([way, way[-2::-1]]) if back else way
    side = np.where(np.arange(len(way)) < count, 1.0, -1.0)
    random = np.random.default_rng(seed)
    f = (
        preload
        + RATE * way
        + friction * side * (way != low)
        + noise * random.standard_normal(len(way))
    )
    return way + noise * 2e-6 * random.standard_normal(len(way)), f


def springs() -> Iterator[Record]:
    """Trials of a spring press; rates in N/m."""

    def record(
        group: str,
        name: str,
        x: Array,
        f: Array,
        about: str = "",
        rate: float = RATE,
        **choice: Any,
    ) -> Record:
        return Record(
            group,
            name,
            {"displacement [mm]": 1e3 * x, "force [N]": f},
            {"stiffness": rate},
            about,
            tuple(choice.items()),
        )

    for count, back, branch, friction, seed in itertools.product(
        (21, 41, 400), (True, False), ("loading", "both"), (0.0, 8.0), (1, 2, 3)
    ):
        x, f = press(count, back=back, friction=friction, seed=seed)
        yield record(
            PLAIN,
            f"{count} rows, back {back}, {branch}, friction {friction:g}, {seed}",
            x,
            f,
            branch=branch,
        )
    for (stroke, force), preload, back in itertools.product(
        itertools.product((1, -1), (1, -1)), (0.0, 300.0), (True, False)
    ):
        if (stroke, force) != (1, 1) or preload:
            x, f = press(preload=preload, back=back)
            about = "reversed|already loaded"
            yield record(
                "sign",
                f"{stroke:+d} {force:+d}, preload {preload:g}, back {back}",
                stroke * x,
                force * f,
                about,
            )
    for (low, high), back, branch, soft in itertools.product(
        ((-0.02, 0.02), (-0.02, 0.005), (-0.005, 0.02), (-0.03, -0.01)),
        (True, False),
        ("loading", "both"),
        (1.0, 0.6),
    ):
        x, f = press(low=low, high=high, back=back)
        f = np.where(x < 0.0, soft, 1.0) * f  # a bush that is softer in tension
        rate = RATE if soft == 1.0 else float("nan")
        about = (
            "already loaded|both sides|not linear|side"
            if soft == 1.0
            else "not linear|both sides|side"
        )
        yield record(
            "both sides",
            f"{1e3 * low:g} to {1e3 * high:g} mm, back {back}, {branch}, {soft:g}",
            x,
            f,
            about,
            rate,
            branch=branch,
        )
    for first, branch in itertools.product((1, -1), ("loading", "both")):
        way = np.concatenate(
            [
                np.linspace(0.0, 0.02, 21),
                np.linspace(0.019, -0.02, 40),
                np.linspace(-0.019, 0.0, 20),
            ]
        )
        f = RATE * way + np.random.default_rng(2).normal(0.0, 1.0, len(way))
        yield record(
            "both sides",
            f"0, {first * 20} and {-first * 20} mm, {branch}",
            first * way,
            first * f,
            "side|cycles",
            branch=branch,
        )
    for zero in (-40.0, 25.0, 200.0):
        x, f = press()
        yield record("datum", f"force zero {zero:g} N", x, f + zero, "loaded|zero")
        yield record("datum", f"stroke zero {zero / 10:g} mm", x + zero * 1e-4, f, "loaded|zero")
    for gap in (1e-3, 4e-3):
        x, f = press(100)
        yield record(
            "datum",
            f"free travel of {1e3 * gap:g} mm",
            x,
            np.where(x > gap, f - RATE * gap, 0.0 * f),
            "free travel",
        )
    for place, slip, count, back in itertools.product(
        (0.3, 0.5, 0.7), (0.5e-3, 1e-3, 2e-3), (41, 200), (True, False)
    ):
        x, f = press(count, back=back)
        after = (x > place * 0.03) | (np.arange(len(x)) >= count)
        yield record(
            "slip",
            f"{1e3 * slip:g} mm at {place:g}, {count} rows, back {back}",
            x,
            f - RATE * slip * after,
            "slip",
        )
        x, f = press(count, back=back)
        slid = np.clip(x - place * 0.03, 0.0, slip)
        slid = np.where(np.arange(len(x)) >= count, slip, slid)
        yield record(
            "slip",
            f"{1e3 * slip:g} mm of flat travel at {place:g}, {count} rows, back {back}",
            x,
            f - RATE * slid,
            "slip",
        )
    for size in (1.0, 10.0, 50.0, 200.0):
        x, f = press()
        yield record("steps", f"force {size:g} N", x, steps_of(f, size), "steps of")
    for size in (0.01e-3, 0.1e-3, 1e-3, 4e-3):
        x, f = press(200)
        yield record("steps", f"stroke {1e3 * size:g} mm", steps_of(x, size), f, "steps of")
    for drift in (20.0, 80.0, -80.0):
        x, f = press()
        yield record(
            "drift",
            f"force {drift:g} N",
            x,
            f + drift * np.linspace(0.0, 1.0, len(f)),
            "drift|zero",
        )
    for top in (300.0, 600.0):
        x, f = press(200)
        yield record(
            "out of range", f"force beyond {top:g} N", x, np.minimum(f, top), "out of range"
        )
    for count in (1, 3, 8):
        x, f = press(100)
        f[40 : 40 + count] = 0.0
        yield record("dropout", f"{count} rows of force 0", x, f, "falls|dropout|zero")
        x, f = press(100)
        f[40 : 40 + count] = f[39]
        yield record("dropout", f"{count} rows of held force", x, f, "dropout|stands|slip")
        x, f = press(100)
        x[40 : 40 + count] = 0.0
        yield record("dropout", f"{count} rows of stroke 0", x, f, "reverses|dropout|zero|cycles")
    x, f = press()
    yield record("exchange", "columns exchanged", f / 1e3, 1e3 * x, "unit|no spring|exchanged")
    yield record("exchange", "stroke in m said to be mm", x / 1e3, f, "unit|no spring|mm")
    yield record("exchange", "stroke in mm said to be m", 1e3 * x, f, "unit|no spring|1 m|mm")
    yield record("exchange", "force in kN said to be N", x, f / 1e3, "unit|no spring|kN|N")
    yield record("exchange", "force in N said to be kN", x, 1e3 * f, "unit|no spring|kN|N")
    yield record("exchange", "rows turned round", x[40::-1], f[40::-1], "reversed|loaded")


def twists() -> Iterator[Record]:
    """The same trials for a part in torsion: 8 degrees for 30 mm, 1 N m for 1 N; and trials in other units."""
    degrees = 8.0 / 30.0
    rate = 1e-3 * RATE / np.radians(degrees)
    for one in springs():
        if one.group != "exchange":
            x, f = one.columns.values()
            truth = {"stiffness": rate * one.truth["stiffness"] / RATE}
            columns = {"angle [deg]": degrees * x, "torque [N*m]": f}
            yield replace(
                one, columns=columns, truth=truth, about=one.about and f"{one.about}|mean of both"
            )
    x, f = press()
    angle = 1e3 * degrees * x
    for (head, turned), (unit, torque), sign in itertools.product(
        (("deg", angle), ("rad", np.radians(angle)), ("mrad", 1e3 * np.radians(angle))),
        (("N*m", f), ("kN*m", 1e-3 * f), ("lbf*ft", f / 1.3558179483314)),
        (1, -1),
    ):
        name = f"{head} and {unit}, {sign:+d}"
        yield Record(
            "unit",
            name,
            {f"angle [{head}]": sign * turned, f"torque [{unit}]": sign * torque},
            {"stiffness": rate},
        )
    for name, columns, about in (
        ("deg said to be rad", {"angle [rad]": angle, "torque [N*m]": f}, "unit"),
        ("rad said to be deg", {"angle [deg]": np.radians(angle), "torque [N*m]": f}, HIDDEN),
        ("N m said to be N mm", {"angle [deg]": angle, "torque [N*mm]": f}, HIDDEN),
        ("N mm said to be N m", {"angle [deg]": angle, "torque [N*m]": 1e3 * f}, HIDDEN),
        ("N mm said to be kN m", {"angle [deg]": angle, "torque [kN*m]": 1e3 * f}, "no bar"),
        ("force in place of the torque", {"angle [deg]": angle, "force [N]": f}, "refused"),
    ):
        yield Record("exchange", name, columns, {"stiffness": rate}, about)


# decays ---------------------------------------------------------------------------------------------------------------

MASS, STIFFNESS, DAMPING = 16.0, 18362.0, 40.0
INERTIA, TWIST, TORQUE_DAMPING = 0.8, 420.0, 1.1
"""Of a part on a torsion bar: kg m2, N m/rad, N m s/rad."""
NO_FRICTION = 2e-4 * STIFFNESS * 0.02
"""Friction (N) that no decay of these is without: a five-thousandth of the force at the release."""


@cache
def swing(  # noqa: PLR0913
    rate: float,
    duration: float = 3.0,
    *,
    mass: float = MASS,
    stiffness: float = STIFFNESS,
    damping: float = DAMPING,
    friction: float = 0.0,
    bump: float = 1.0,
    start: float = 0.02,
    hold: float = 0.2,
    hits: tuple[tuple[float, float], ...] = (),
    noise: float = 1e-3,
    seed: int = 1,
    softening: float = 0.0,
) -> dict[str, Array]:
    """Free decay of a mass, by small steps of Heun's method: displacement, velocity, acceleration with relative noise.

    ``bump`` multiplies the damping while the mass goes down; ``hits`` are instants and the velocities they add;
    ``softening`` is the loss of stiffness with the square of the deflection, as for a pendulum.
    """
    fine = max(1, round(2000.0 / rate))
    step = 1.0 / (rate * fine)
    count = round(duration * rate)
    sharp = 1e-4 * start / 0.02

    def acceleration(x: float, v: float) -> float:
        c = damping * (bump if v < 0.0 else 1.0)
        return (
            -c * v - stiffness * x * (1.0 - softening * x * x) - friction * math.tanh(v / sharp)
        ) / mass

    x, v, rows, left = start, 0.0, [], list(hits)
    for index in range(count):
        if index / rate < hold:
            rows.append((start, 0.0, 0.0))
            continue
        rows.append((x, v, acceleration(x, v)))
        while left and index / rate >= left[0][0]:
            v += left.pop(0)[1]
        for _ in range(fine):
            a = acceleration(x, v)
            x1, v1 = x + step * v, v + step * a
            a1 = acceleration(x1, v1)
            x, v = x + 0.5 * step * (v + v1), v + 0.5 * step * (a + a1)
    table = np.array(rows).T
    random = np.random.default_rng(seed)
    table = table + noise * np.abs(table).max(axis=1, keepdims=True) * random.standard_normal(
        table.shape
    )
    return {"t": np.arange(count) / rate, "z": table[0], "vz": table[1], "az": table[2]}


UNITS = {"z": "mm", "vz": "m/s", "az": "m/s^2"}
IN_SI = {
    "z": {"mm": 1e-3, "cm": 0.01, "m": 1.0, "in": 0.0254},
    "vz": {"m/s": 1.0, "mm/s": 1e-3, "km/h": 1.0 / 3.6},
    "az": {"m/s^2": 1.0, "mm/s^2": 1e-3, "g": 9.80665},
}


def high_pass(signal: Array, rate: float, corner: float, order: int = 1) -> Array:
    """High-pass filter of an AC coupling with a corner frequency (Hz), by one-pole sections."""
    for _ in range(order):
        signal = signal - low_pass(signal, rate, corner, 1)
    return signal


def decays() -> Iterator[Record]:
    """Free decays of one mass on a spring."""

    def record(
        group: str,
        name: str,
        t: Array,
        signal: Array,
        kind: str = "z",
        about: str = "",
        damping: float = DAMPING,
        friction: float | None = 0.0,
        unit: str = "",
        said: str = "",
        **choice: Any,
    ) -> Record:
        """``unit`` is the unit of the numbers, ``said`` a different unit in the header."""
        unit = unit or UNITS[kind]
        columns = {"time [s]": t, f"sprung.{kind} [{said or unit}]": signal / IN_SI[kind][unit]}
        truth = {"damping_coefficient": damping}
        if friction is not None:
            truth["coulomb_force"] = friction
        choice = {"channel": f"sprung.{kind}", "mass": MASS, **choice}
        return Record(
            group,
            name,
            columns,
            truth,
            about,
            tuple(choice.items()),
            (("coulomb_force", NO_FRICTION),),
        )

    for rate, kind, friction, seed in itertools.product((200.0, 1000.0), UNITS, (0.0, 3.0), (1, 2)):
        run = swing(rate, friction=friction, seed=seed)
        about = "dry friction" if friction else ""
        name = f"{kind}, {rate:g} Hz, friction {friction:g}, {seed}"
        yield record(PLAIN, name, run["t"], run[kind], kind, about, friction=friction)
    for kind in UNITS:
        run = swing(500.0)
        yield record("sign", kind, run["t"], -run[kind], kind)
        for shift in (0.2, 1.5):
            reach = float(np.abs(run[kind]).max())
            about = "the mean is" if kind == "az" else ""
            yield record(
                "datum",
                f"{kind} shifted by {shift:g}",
                run["t"],
                run[kind] + shift * reach,
                kind,
                about,
            )
        for jump, when in itertools.product((0.05, -0.3), (0.5, 1.2)):
            moved = run[kind] + jump * reach * (run["t"] > when)
            about = "zero|jump|explains only|hit"
            yield record(
                "datum", f"{kind} jumps by {jump:g} at {when:g} s", run["t"], moved, kind, about
            )
    for kind, friction in itertools.product(UNITS, (0.0, 3.0)):
        run = swing(500.0, friction=friction)
        for unit in IN_SI[kind]:
            about = "dry friction" if friction else ""
            name = f"{unit}, friction {friction:g}"
            yield record(
                "unit", name, run["t"], run[kind], kind, about, friction=friction, unit=unit
            )
        for unit, said in itertools.permutations(IN_SI[kind], 2):
            about = (
                "unit" if IN_SI[kind][said] > 30.0 * IN_SI[kind][unit] or not friction else HIDDEN
            )
            name = f"{unit} said to be {said}, friction {friction:g}"
            yield record(
                "unit",
                name,
                run["t"],
                run[kind],
                kind,
                about,
                friction=friction,
                unit=unit,
                said=said,
            )
    for kind, size, curve in itertools.product(
        UNITS, (-0.4, -0.1, 0.1, 0.4), ("line", "warming", "slow wave")
    ):
        run = swing(500.0)
        t, reach = run["t"], float(np.abs(run[kind]).max())
        way = {
            "line": t / t[-1],
            "warming": 1.0 - np.exp(-t / 0.7),
            "slow wave": np.sin(2.0 * np.pi * t / 4.0),
        }[curve]
        yield record(
            "drift",
            f"{kind} by {size:g} as a {curve}",
            t,
            run[kind] + size * reach * way,
            kind,
            "drift",
        )
    for kind, corner, order, friction in itertools.product(
        UNITS, (1.5, 4.0, 10.0, 25.0), (1, 2, 4), (0.0, 8.0)
    ):
        run = swing(500.0, friction=friction)
        signal = low_pass(run[kind], 500.0, corner, order)
        name = f"{kind} low pass of order {order} at {corner:g} Hz, friction {friction:g}"
        yield record(
            "filter", name, run["t"], signal, kind, "low.pass|explains only", friction=friction
        )
    for kind, corner, order, friction in itertools.product(
        UNITS, (0.1, 0.5, 2.0), (1, 2), (0.0, 8.0)
    ):
        run = swing(500.0, friction=friction)
        signal = high_pass(run[kind], 500.0, corner, order)
        yield record(
            "coupling", f"{kind} high pass of order {order} at {corner:g} Hz, friction {friction:g}", run["t"], signal,
            kind, "high pass|drift|explains only", friction=friction,
        )  # fmt: skip
    for size in (0.001, 0.02, 0.1, 0.3):
        for kind in UNITS:
            run = swing(500.0)
            reach = float(np.abs(run[kind]).max())
            yield record(
                "steps",
                f"{kind} in steps of {size:g}",
                run["t"],
                steps_of(run[kind], size * reach),
                kind,
                "steps of",
            )
    for limit, kind, sides in itertools.product((0.9, 0.6, 0.3), UNITS, ("both sides", "one side")):
        run = swing(500.0)
        top = limit * float(np.abs(run[kind]).max())
        signal = np.clip(run[kind], -top if sides == "both sides" else -np.inf, top)
        yield record(
            "clipped",
            f"{kind} at {limit:g}, {sides}",
            run["t"],
            signal,
            kind,
            "out of range|clipped",
        )
    for seconds, times, how, kind in itertools.product(
        (0.04, 0.2), (1, 4), ("zero", "held"), UNITS
    ):
        run = swing(500.0)
        marks = lost(len(run["t"]), 500.0, seconds, times)
        signal = held(run[kind], marks) if how == "held" else np.where(marks, 0.0, run[kind])
        yield record(
            "dropout", f"{kind} {how} {times} times {seconds:g} s", run["t"], signal, kind,
            "dropout|stands still|missing",
        )  # fmt: skip
    for times, length, kind in itertools.product((1, 5), (5, 40), ("z", "vz", "az")):
        run = swing(500.0)
        marks = lost(len(run["t"]), 500.0, length / 500.0, times)
        name = f"{kind}, {times} times {length} rows cut out, the time goes on"
        t = run["t"][: np.count_nonzero(~marks)]
        yield record("dropout", name, t, run[kind][~marks], kind, "missing|hit|explains only|jump")
    for when, kind, size in itertools.product((0.9, 1.37), UNITS, (0.3, 0.6)):
        run = swing(500.0, hits=((when, size),))
        yield record(
            "hit",
            f"second at {when:g} s, {size:g} m/s, {kind}",
            run["t"],
            run[kind],
            kind,
            "hit|explains only",
        )
    for when, kind, size in itertools.product((0.6, 1.0, 1.8), UNITS, (-0.5, 0.1, 0.2)):
        run = swing(500.0, hits=((when, size),))
        yield record(
            "hit",
            f"second at {when:g} s, {size:g} m/s, {kind}",
            run["t"],
            run[kind],
            kind,
            "hit|explains only",
        )
    for kind in UNITS:
        run = swing(500.0, start=1e-5, hits=((0.5, 0.7),))
        yield record("hit", f"struck, {kind}", run["t"], run[kind], kind, "hit")
        run = swing(500.0, start=1e-5, hits=((0.5, 0.7), (0.55, -0.3)))
        yield record("hit", f"struck twice within 50 ms, {kind}", run["t"], run[kind], kind, "hit")
    for apart, share, kind in itertools.product((0.05, 0.08, 0.15), (0.5, 0.8, 0.98), ("z", "az")):
        t = np.arange(0.0, 7.0, 0.005)
        fall, omega = np.exp(-0.15 * t), 33.9
        signal = (
            0.02
            * fall
            * (np.cos(omega * t) + share * np.cos(omega * (1.0 + apart) * t))
            / (1.0 + share)
        )
        signal = signal * (1.0 if kind == "z" else -(omega**2)) + 2e-5 * (
            1.0 if kind == "z" else omega**2
        ) * np.random.default_rng(1).standard_normal(len(t))
        yield record(
            "beat",
            f"{100.0 * apart:g} % apart, {share:g}, {kind}",
            t,
            signal,
            kind,
            "beat|explains only",
            0.3 * MASS,
        )
    for bump, kind in itertools.product((0.3, 0.6, 1.5, 3.0), UNITS):
        run = swing(500.0, bump=bump)
        mean = 0.5 * (1.0 + bump) * DAMPING
        yield record(
            "firmer in one direction",
            f"{bump:g}, {kind}",
            run["t"],
            run[kind],
            kind,
            "one direction",
            mean,
        )
    for said, truth in (
        ("z", "vz"),
        ("z", "az"),
        ("vz", "z"),
        ("vz", "az"),
        ("az", "z"),
        ("az", "vz"),
    ):
        for friction in (0.0, 8.0):
            run = swing(500.0, friction=friction)
            about = "rather one of" if friction else "unit"
            yield record(
                "exchange", f"{truth} said to be {said}, friction {friction:g}", run["t"], run[truth], said, about,
                friction=friction, unit=UNITS[said],
            )  # fmt: skip
    run = swing(500.0)
    yield record("exchange", "signal and time", run["z"], run["t"], "z", "time|clock")
    yield record(
        "exchange",
        "rows turned round",
        run["t"],
        run["z"][::-1],
        "z",
        "grows|explains only|hit|turned",
    )
    yield record(
        "clock", "ms said to be s", 1e3 * run["t"], run["z"], "z", "sample|unit|clock|time"
    )
    yield record(
        "clock",
        "s said to be ms",
        run["t"] / 1e3,
        run["z"],
        "z",
        "sample|unit|clock|time|stiffness|rate",
    )
    for factor, friction in itertools.product((0.5, 1.0 / 1.1, 1.05, 2.0), (0.0, 3.0)):
        run = swing(500.0, friction=friction)
        name = f"{factor:.3g} times, friction {friction:g}, stiffness stated"
        yield record(
            "clock",
            name,
            factor * run["t"],
            run["z"],
            "z",
            "stiffness",
            friction=friction,
            stiffness=STIFFNESS,
        )
        name = f"{factor:.3g} times, friction {friction:g}"
        yield record("clock", name, factor * run["t"], run["z"], "z", HIDDEN, friction=friction)
    for size in (0.2, 0.45):
        run = swing(500.0)
        late = run["t"] + size / 500.0 * np.random.default_rng(4).uniform(-1.0, 1.0, len(run["t"]))
        yield record("clock", f"jitter of {size:g} samples", late, run["z"], "z", "step|jitter")
    yield record(
        "clock",
        "in steps of 10 ms",
        np.floor(run["t"] * 100.0) / 100.0,
        run["z"],
        "z",
        "ascend|step",
    )
    for few, kind in itertools.product((2.5, 4.0, 7.0, 12.0), UNITS):
        run = swing(1000.0)
        thin = max(1, round(1000.0 / (5.39 * few)))
        yield record(
            "rate",
            f"{few:g} samples a cycle, {kind}",
            run["t"][::thin],
            run[kind][::thin],
            kind,
            "samples per cycle",
        )


TURNED = {
    "angle": {"deg": np.pi / 180.0, "rad": 1.0},
    "angular_velocity": {"deg/s": np.pi / 180.0, "rad/s": 1.0, "rpm": np.pi / 30.0},
    "angular_acceleration": {"rad/s^2": 1.0, "deg/s^2": np.pi / 180.0},
}
_LIKE = dict(zip(TURNED, UNITS, strict=True))


def rotations() -> Iterator[Record]:
    """Pendulums and parts on torsion bars, by encoders of their angle and rate gyros."""

    def turn(
        friction: float = 0.0, *, start: float = 0.2, softening: float = 0.0, seed: int = 1
    ) -> dict[str, Array]:
        return swing(
            500.0, 4.0, mass=INERTIA, stiffness=TWIST, damping=TORQUE_DAMPING, friction=friction, start=start,
            softening=softening, seed=seed,
        )  # fmt: skip

    def record(
        group: str,
        name: str,
        t: Array,
        signal: Array,
        kind: str,
        about: str = "",
        friction: float = 0.0,
        unit: str = "",
        said: str = "",
        **choice: Any,
    ) -> Record:
        unit = unit or next(iter(TURNED[kind]))
        columns = {"time [s]": t, f"arm.{kind} [{said or unit}]": signal / TURNED[kind][unit]}
        truth = {"damping_coefficient": TORQUE_DAMPING, "coulomb_force": friction}
        choice = {"channel": f"arm.{kind}", "inertia": INERTIA, **choice}
        return Record(
            group,
            name,
            columns,
            truth,
            about,
            tuple(choice.items()),
            (("coulomb_force", 2e-4 * TWIST * 0.2),),
        )

    for (kind, like), friction, sign in itertools.product(_LIKE.items(), (0.0, 0.6), (1, -1)):
        run = turn(friction)
        about = "dry friction" if friction else ""
        for unit in TURNED[kind]:
            name = f"{kind} in {unit}, friction {friction:g}, sign {sign:+d}"
            yield record(PLAIN, name, run["t"], sign * run[like], kind, about, friction, unit)
        for unit, said in itertools.permutations(TURNED[kind], 2):
            if sign > 0:
                about = (
                    "unit"
                    if TURNED[kind][said] > 30.0 * TURNED[kind][unit] or not friction
                    else HIDDEN
                )
                name = f"{kind}, {unit} said to be {said}, friction {friction:g}"
                yield record("unit", name, run["t"], run[like], kind, about, friction, unit, said)
    for (kind, like), friction in itertools.product(_LIKE.items(), (0.0, 0.6)):
        run = turn(friction)
        t, signal, reach = run["t"], run[like], float(np.abs(run[like]).max())
        more = f"{kind}, friction {friction:g}"
        about = "dry friction" if friction else ""
        yield record(
            "datum", f"bias of 0.4, {more}", t, signal + 0.4 * reach, kind, about, friction
        )
        for size in (0.1, -0.4):
            yield record(
                "drift",
                f"{size:g}, {more}",
                t,
                signal + size * reach * t / t[-1],
                kind,
                "drift",
                friction,
            )
        for corner, order in itertools.product((4.0, 15.0), (1, 2)):
            behind = low_pass(signal, 500.0, corner, order)
            name = f"low pass of order {order} at {corner:g} Hz, {more}"
            yield record("filter", name, t, behind, kind, "low.pass|explains only", friction)
        for size in (0.002, 0.05, 0.2):
            yield record(
                "steps",
                f"{size:g}, {more}",
                t,
                steps_of(signal, size * reach),
                kind,
                "steps of",
                friction,
            )
        for limit in (0.8, 0.4):
            cut = np.clip(signal, -limit * reach, limit * reach)
            yield record(
                "clipped",
                f"{limit:g}, {more}",
                t,
                cut,
                kind,
                "limits of the record|clipped",
                friction,
            )
        for how in ("zero", "held"):
            marks = lost(len(t), 500.0, 0.2, 3)
            gone = held(signal, marks) if how == "held" else np.where(marks, 0.0, signal)
            yield record(
                "dropout", f"{how}, {more}", t, gone, kind, "stands still|stays at", friction
            )
        for factor in (0.5, 1.1):
            name = f"{factor:g} times, stiffness stated, {more}"
            yield record(
                "clock", name, factor * t, signal, kind, "stiffness", friction, stiffness=TWIST
            )
        yield record(
            "inertia",
            f"a mass in its place, {more}",
            t,
            signal,
            kind,
            "inertia",
            friction,
            mass=1.0,
        )
    for start in (0.1, 0.4, 0.8):
        run = turn(start=start, softening=1.0 / 6.0)
        for kind, like in _LIKE.items():
            yield record(
                "pendulum",
                f"let go at {start:g} rad, {kind}",
                run["t"],
                run[like],
                kind,
                "softer|explains only",
            )
