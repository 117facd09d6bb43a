"""Records of testers with known values and faults, made with NumPy only: one axle, one wheel after the other.

A quarter car is on a rigid plate of 6 mm stroke (EUSAMA, EGEA) or on a plate with a spring to the exciter (THETA,
BOGE). The code shares nothing with jounce.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache

import numpy as np
from foreign_records import HIDDEN, PLAIN, Array, held, high_pass, lost, low_pass, steps_of

G, PLATE, SPRING = 9.81, 20.0, 50e3  # m/s^2; kg and N/m of the plates
RATE, SIDES = 1000.0, ("left", "right")
EGEA, THETA = "egea-specsus2018", "theta-msd3000"
STROKES = {EGEA: 6e-3, THETA: 6.5e-3}  # m
SWEEPS = {
    EGEA: (25.0, 0.3, 2.5, 2.0),
    THETA: (20.0, 1.0, 1.5, 2.0),
}  # start, end (Hz), rate (Hz/s), hold (s)
REST = 1.0  # s before, between and after


@dataclass(frozen=True)
class Wheel:
    """Masses in kg, spring and tyre in N/m, damper in N s/m, dry friction in N; rebound over bump damping."""

    body: float
    wheel: float
    spring: float
    damper: float
    tyre: float
    friction: float = 0.0
    rebound: float = 1.0

    @property
    def load(self) -> float:
        """Static load, N."""
        return G * (self.body + self.wheel)

    def matrix(self, tester: str) -> Array:
        """Of heights and velocities of body, wheel and plate; on a rigid plate this one is at rest."""
        k, c, kt = self.spring, self.damper, self.tyre
        plate = PLATE if tester == THETA else np.inf
        stiffness = np.array([[k, -k, 0.0], [-k, k + kt, -kt], [0.0, -kt, kt + SPRING]])
        damping = np.array([[c, -c, 0.0], [-c, c, 0.0], [0.0, 0.0, 0.0]])
        mass = np.array([[self.body], [self.wheel], [plate]])
        upper = np.hstack([np.zeros((3, 3)), np.eye(3)])
        return np.vstack([upper, np.hstack([-stiffness / mass, -damping / mass])])

    def force_over_height(self, frequency: Array) -> Array:
        """Dynamic force of a rigid plate over its height, N/m."""
        s = 2j * np.pi * frequency
        strut = self.spring + self.damper * s
        body = self.body * s**2 + strut
        return self.tyre * (
            1.0 - body * self.tyre / (body * (self.wheel * s**2 + strut + self.tyre) - strut**2)
        )

    def truth(self, tester: str) -> dict[str, float]:
        """True results of a tester: the minimum force of its sweep; the other values from poles and response."""

        def ratio(matrix: Array, count: int) -> float:
            poles = np.linalg.eigvals(matrix)
            upper = sorted(poles[poles.imag > 1e-6], key=abs)
            pole = upper[1 if len(upper) == count else 0]
            return float(-pole.real / abs(pole))

        of_plate = self.matrix(tester)
        on_road = of_plate[np.ix_([0, 1, 3, 4], [0, 1, 3, 4])]
        if tester == THETA:
            return {"theta_road": ratio(on_road, 2), "theta_rig": ratio(of_plate, 3)}
        f = np.linspace(0.5, 25.0, 4901)
        answer, band = self.force_over_height(f), (f >= 6.0) & (f <= 18.0)
        settled = slice(round((REST + 1.0) * RATE), None)
        return {
            "theta_road": ratio(on_road, 2),
            "adhesion": float(run(self, tester)[2][settled].min()) / self.load,
            "phase_angle_min_deg": 180.0 - float(np.degrees(np.angle(answer[band])).max()),
            "tyre_rigidity": 0.571 * float(np.abs(answer[-1])) + 46e3,
        }


WITHIN = {
    "theta_road": 0.015,
    "theta_rig": 0.02,
    "adhesion": 0.02,
    "phase_angle_min_deg": 4.5,  # the sweep alone makes up to 3
    "tyre_rigidity": 12e3,
}
"""Errors that matter to nobody."""
CARS = {
    "hatchback": (Wheel(310.0, 36.0, 21e3, 1350.0, 190e3), Wheel(330.0, 36.0, 21e3, 620.0, 195e3)),
    "estate": (Wheel(420.0, 45.0, 28e3, 1900.0, 230e3), Wheel(405.0, 45.0, 28e3, 1500.0, 225e3)),
    "van": (Wheel(620.0, 60.0, 52e3, 1250.0, 300e3), Wheel(650.0, 60.0, 52e3, 2900.0, 310e3)),
}
"""Left and right wheel."""
FEW = ("hatchback", "van")


@cache
def run(wheel: Wheel, tester: str) -> tuple[Array, Array, Array]:
    """Height of the plate, force of its cell and contact force at `RATE`, from rest to rest, in steps of 0.25 ms."""
    start, end, rate, hold = SWEEPS[tester]
    fine = 4
    length = hold + (start - end) / rate
    t = np.arange(round((length + 2.0 * REST) * RATE) * fine) / (RATE * fine)
    swept = np.clip(t - REST, 0.0, length)
    falls = np.maximum(swept - hold, 0.0)
    drive = 0.5 * STROKES[tester] * np.sin(2.0 * np.pi * (start * swept - 0.5 * rate * falls**2))
    is_rigid, h = tester == EGEA, 1.0 / (RATE * fine)
    kt, k, load = wheel.tyre, wheel.spring, wheel.load
    bump, rebound = (
        wheel.damper * 2.0 / (1.0 + wheel.rebound),
        wheel.damper * 2.0 / (1.0 + 1.0 / wheel.rebound),
    )
    zs = vs = zu = vu = zp = vp = 0.0
    heights, forces = np.empty(t.size), np.empty(t.size)
    for i, at in enumerate(
        drive
    ):  # half a step of velocities, a step of heights, half a step of velocities
        zp = at if is_rigid else zp
        contact = max(load + kt * (zp - zu), 0.0)
        heights[i], forces[i] = zp, contact
        v = vs - vu
        strut = k * (zs - zu) + (bump if v < 0.0 else rebound) * v
        strut += wheel.friction * v / (abs(v) + 2e-3) if wheel.friction else 0.0
        vs -= h * strut / wheel.body
        vu += h * (strut + contact - load) / wheel.wheel
        zs, zu = zs + h * vs, zu + h * vu
        if not is_rigid:
            vp += h * (SPRING * (at - zp) - (contact - load)) / PLATE
            zp += h * vp
    inertia = PLATE * np.gradient(np.gradient(heights, h), h)
    return heights[::fine], (forces + inertia)[::fine], forces[::fine]


@dataclass(frozen=True)
class TesterRecord:
    """A file of a tester: header, columns, wheels, and the fault of the record.

    ``about`` are the codes of findings that name the cause. Without them the record is correct, and a warning is a
    false alarm.
    """

    group: str
    name: str
    tester: str
    header: dict[str, str]
    columns: dict[str, Array]
    truth: dict[str, dict[str, float]]
    about: str = ""
    within: dict[str, float] = field(default_factory=lambda: WITHIN)

    def text(self) -> str:
        """The file, comma-separated."""
        head = [f"# {key} = {value}" for key, value in self.header.items()]
        rows = np.column_stack(list(self.columns.values()))
        return (
            "\n".join(
                [
                    *head,
                    ",".join(self.columns),
                    *(",".join(f"{x:.8g}" for x in row) for row in rows),
                ]
            )
            + "\n"
        )


@dataclass
class Axle:
    """Return the signals of both wheels in SI, before the fault, and the header."""

    tester: str
    wheels: tuple[Wheel, Wheel]
    rate: float
    time: Array
    z: dict[str, Array]
    f: dict[str, Array]
    loads: dict[str, float]
    order: str = '["left", "right"]'
    units: tuple[str, str, str] = ("s", "mm", "N")

    def record(self, group: str, name: str, about: str = "") -> TesterRecord:
        """Write the file, in its units."""
        time, height, force = self.units
        columns = {f"time [{time}]": self.time}
        for side in SIDES:
            columns[f"{side}.plate.z [{height}]"] = 1e3 * self.z[side]
            columns[f"{side}.plate.force [{force}]"] = self.f[side]
        header = {f"{side}.static_load": f'"{load:.0f} N"' for side, load in self.loads.items()}
        header |= {"wheel_order": self.order} if self.order else {}
        truth = {
            side: wheel.truth(self.tester) for side, wheel in zip(SIDES, self.wheels, strict=True)
        }
        return TesterRecord(
            group, f"{self.tester}: {name}", self.tester, header, columns, truth, about
        )


def axle(tester: str, car: str | tuple[Wheel, Wheel], noise: float = 0.003, seed: int = 1) -> Axle:
    """Test the left wheel, then the right one; the other plate is at rest, and the noise is a share of the load."""
    wheels = CARS[car] if isinstance(car, str) else car
    draw = np.random.default_rng(seed)
    z, f = {}, {}
    for i, (side, wheel) in enumerate(zip(SIDES, wheels, strict=True)):
        height, force, _ = run(wheel, tester)
        rest = [np.zeros(height.size), np.full(height.size, wheel.load)]
        order = slice(None, None, 1 if i == 0 else -1)
        z[side] = np.concatenate([height, rest[0]][order]) + 2e-6 * draw.standard_normal(
            2 * height.size
        )
        f[side] = np.concatenate(
            [force, rest[1]][order]
        ) + noise * wheel.load * draw.standard_normal(2 * height.size)
    loads = {side: wheel.load for side, wheel in zip(SIDES, wheels, strict=True)}
    return Axle(tester, wheels, RATE, np.arange(z["left"].size) / RATE, z, f, loads)


def testers() -> Iterator[TesterRecord]:
    """Records of both kinds of testers."""
    for tester in (EGEA, THETA):
        yield from _sound(tester)
        yield from _scales(tester)
        yield from _clocks(tester)
        yield from _losses(tester)
        yield from _filters(tester)
        yield from _exchanges(tester)


def _sound(tester: str) -> Iterator[TesterRecord]:
    for car, noise, seed in itertools.product(CARS, (0.0005, 0.003, 0.01), (1, 2)):
        yield axle(tester, car, noise, seed).record(PLAIN, f"{car}, noise {noise:g}, {seed}")


def _scales(tester: str) -> Iterator[TesterRecord]:
    """Signs, zeros and units."""
    for car, which in itertools.product(CARS, ("height", "force", "both")):
        one = axle(tester, car)
        one.z = {side: -v if which != "force" else v for side, v in one.z.items()}
        one.f = {side: -v if which != "height" else v for side, v in one.f.items()}
        yield one.record("sign", f"{car}, {which}", "upside_down|force_sign")
    for car, share, sides in itertools.product(
        CARS, (-1.0, -0.3, -0.12, -0.05, 0.05, 0.12, 0.3), (("left",), SIDES)
    ):
        one = axle(tester, car)
        for side in sides:
            one.f[side] = one.f[side] + share * one.loads[side]
        name = f"{car}, force zero {share:+g} of the load, {' and '.join(sides)}"
        yield one.record(
            "datum", name, "load_off|load_contradicts|both_offset|force_unit|no_wheel_load"
        )
        one.loads = {}
        about = "load_from_signal|no_wheel_load"
        yield one.record("datum", f"{name}, no load stated", about)
    for zero in (-0.2, 0.004):
        one = axle(tester, "estate")
        one.z = {side: v + zero for side, v in one.z.items()}
        yield one.record("datum", f"height zero {1e3 * zero:g} mm")
    for factor, said in itertools.product((1e-3, 0.1, 1.0 / 4.4482216, 1.0 / G), (True, False)):
        one = axle(tester, "hatchback")
        one.f = {side: factor * v for side, v in one.f.items()}
        name = f"force times {factor:.3g} called N, load {'stated' if said else 'not stated'}"
        one.loads = one.loads if said else {}
        yield one.record(
            "unit",
            name,
            "force_unit|no_wheel_load|load_contradicts|load_from_signal|columns_swapped",
        )
    for unit, factor in (
        ("kN", 1e-3),
        ("daN", 0.1),
        ("lbf", 1.0 / 4.4482216),
        ("kgf", 1.0 / 9.80665),
    ):
        one = axle(tester, "hatchback")
        one.f, one.units = {side: factor * v for side, v in one.f.items()}, ("s", "mm", unit)
        yield one.record("unit", f"force in {unit}")
    for factor in (1e-3, 0.1, 1.0 / 25.4, 1e3, 0.5, 0.8, 0.9, 1.1, 1.25, 2.0):
        for car in ("hatchback", "van"):
            one = axle(tester, car)
            one.z = {side: factor * v for side, v in one.z.items()}
            about = "height_unit|stroke_wrong|stroke_off|stroke_unit|columns_swapped|plate_never_moves|no_wheel"
            about += "|not_sprung|exciter_off"
            if factor in (0.9, 1.1):  # a rigid plate's stroke may differ by 10 %
                about += f"|{HIDDEN}"
            yield one.record("unit", f"{car}, height times {factor:.3g}", about)
    for unit, factor in (("cm", 0.1), ("m", 1e-3), ("inch", 1.0 / 25.4)):
        one = axle(tester, "hatchback")
        one.z, one.units = {side: factor * v for side, v in one.z.items()}, ("s", unit, "N")
        yield one.record("unit", f"height in {unit}")
    for factor, sides in itertools.product((0.8, 0.93, 1.05, 1.2), (("left",), SIDES)):
        for said in (True, False):
            one = axle(tester, "estate")
            for side in sides:
                one.f[side] = factor * one.f[side]
            one.loads = one.loads if said else {}
            name = f"force times {factor:g} {' and '.join(sides)}, load {'stated' if said else 'not stated'}"
            yield one.record(
                "gain", name, "load_off|load_contradicts|load_from_signal|both_offset|force_unit"
            )
    for factor in (1e-3, 0.1, 10.0, 1.0 / G):
        one = axle(tester, "estate")
        one.loads = {side: factor * load for side, load in one.loads.items()}
        yield one.record(
            "unit",
            f"static load times {factor:.3g}",
            "load_unit|load_contradicts|both_offset|force_unit",
        )


def _clocks(tester: str) -> Iterator[TesterRecord]:
    """Rates and clocks."""
    for car, rate in itertools.product(CARS, (500.0, 250.0, 125.0, 50.0)):
        one, thin = axle(tester, car), round(RATE / rate)
        one.time = one.time[::thin]
        one.z = {side: v[::thin] for side, v in one.z.items()}
        one.f = {side: v[::thin] for side, v in one.f.items()}
        yield one.record("rate", f"{car}, {rate:g} Hz", "samples_few|samples_too_few")
    for car, times, which in itertools.product(CARS, (2, 3, 5, 10), ("height", "force", "both")):
        one = axle(tester, car)
        keep = np.arange(one.time.size) // times * times
        one.z = {side: v[keep] if which != "force" else v for side, v in one.z.items()}
        one.f = {side: v[keep] if which != "height" else v for side, v in one.f.items()}
        yield one.record(
            "rate",
            f"{car}, {which} held for {times}",
            "recordings.held|force_late|force_early|channels_apart",
        )
    for car, factor in itertools.product(CARS, (0.5, 0.8, 0.95, 1.05, 1.25, 2.0)):
        one = axle(tester, car)
        one.time = factor * one.time
        about = "sweep_fast|sweep_short|never_high|samples_few|no_rigidity_hold"
        about += "|frequency_off|not_sprung|exciter_off"
        yield one.record("clock", f"{car}, time times {factor:g}", about)
    for factor in (1e3, 1e-3):
        one = axle(tester, "estate")
        one.time = factor * one.time
        yield one.record(
            "clock", f"time times {factor:g}", "clock|samples|too_short|never_high|reading"
        )
    for car, size in itertools.product(CARS, (0.005, 0.2, 0.45)):
        one = axle(tester, car)
        late = np.random.default_rng(7).uniform(-1.0, 1.0, one.time.size) * size / RATE
        one.time = np.maximum(one.time + late, 0.0)
        yield one.record(
            "clock", f"{car}, jitter of {size:g} samples", "clock|recordings.time_step_varies"
        )


def _losses(tester: str) -> Iterator[TesterRecord]:
    """Dropouts, coarse steps and ends of the range."""
    about = "recordings.frozen|dropout|samples_missing|rows_missing|clock|several_sweeps|saturated|clipped"
    for car, seconds, times, (which, how) in itertools.product(
        FEW,
        (0.02, 0.1, 0.4),
        (1, 4),
        itertools.product(("force", "height", "both"), ("zero", "held")),
    ):
        one = axle(tester, car)
        for side, seed in zip(SIDES, (5, 6), strict=True):
            half = one.time.size // 2
            marks = np.zeros(one.time.size, bool)
            marks[:half] = lost(half, RATE, seconds, times, seed)
            marks = marks if side == "left" else np.roll(marks, half)
            for signals in ([one.f] * (which != "height")) + ([one.z] * (which != "force")):
                gone = held(signals[side], marks)
                signals[side] = gone if how == "held" else np.where(marks, 0.0, signals[side])
        yield one.record("dropout", f"{car}, {which} {how} {times} times {seconds:g} s", about)
    for car, rows in itertools.product(CARS, (1, 20, 200, 1000)):
        one = axle(tester, car)
        cut = np.ones(one.time.size, bool)
        for begin in (4000, one.time.size // 2 + 5000):
            cut[begin : begin + rows] = False
        one.z, one.f = ({side: v[cut] for side, v in signals.items()} for signals in (one.z, one.f))
        one.time = one.time[: np.count_nonzero(cut)]
        yield one.record("dropout", f"{car}, {rows} rows cut out, the time goes on", about)
    for car, size in itertools.product(CARS, (1.0, 10.0, 50.0, 150.0, 400.0, 1000.0)):
        one = axle(tester, car)
        one.f = {side: steps_of(v, size) for side, v in one.f.items()}
        yield one.record(
            "steps",
            f"{car}, force in steps of {size:g} N",
            "coarse|clipped|saturated|load_contradicts",
        )
    for car, size in itertools.product(CARS, (1e-5, 1e-4, 5e-4, 1e-3, 2e-3)):
        one = axle(tester, car)
        one.z = {side: steps_of(v, size) for side, v in one.z.items()}
        yield one.record(
            "steps",
            f"{car}, height in steps of {1e3 * size:g} mm",
            "coarse|stroke_off|stroke_wrong",
        )
    for car, share, end in itertools.product(CARS, (0.95, 0.7, 0.4), ("upper", "lower", "height")):
        one = axle(tester, car)
        for side in SIDES:
            load = one.loads[side]
            reach = share * float(np.abs(one.f[side] - load).max())
            top = share * float(np.abs(one.z[side]).max())
            if end == "height":
                one.z[side] = np.clip(one.z[side], -np.inf, top)
            else:
                low, high = (-np.inf, load + reach) if end == "upper" else (load - reach, np.inf)
                one.f[side] = np.clip(one.f[side], low, high)
        yield one.record(
            "clipped", f"{car}, {end} at {share:g}", "saturated|clipped|stroke_off|stroke_wrong"
        )


def _filters(tester: str) -> Iterator[TesterRecord]:
    """Low passes and couplings of a channel or of both."""
    for car, corner, order, which in itertools.product(
        FEW, (10.0, 20.0, 40.0, 100.0), (1, 2, 4), ("force", "height", "both")
    ):
        one = axle(tester, car)
        if which != "height":
            one.f = {side: low_pass(v, RATE, corner, order) for side, v in one.f.items()}
        if which != "force":
            one.z = {side: low_pass(v, RATE, corner, order) for side, v in one.z.items()}
        about = (
            "force_late|force_early|not_rigid|stroke|never_high|no_wheel|poor_fit|not_sprung|"
            "exciter_off|channels_apart"
        )
        yield one.record("low pass", f"{car}, {which} {corner:g} Hz, order {order}", about)
    for car, corner, order, which in itertools.product(
        FEW, (0.1, 0.5, 2.0, 5.0), (1, 2), ("force", "height", "both")
    ):
        one = axle(tester, car)
        if which != "height":
            one.f = {side: high_pass(v, RATE, corner, order) for side, v in one.f.items()}
        if which != "force":
            one.z = {side: high_pass(v, RATE, corner, order) for side, v in one.z.items()}
        about = "force_late|force_early|not_rigid|stroke|no_wheel|poor_fit|load_|both_offset|slips|not_sprung"
        about += "|exciter_off|channels_apart"
        yield one.record("high pass", f"{car}, {which} {corner:g} Hz, order {order}", about)


def _exchanges(tester: str) -> Iterator[TesterRecord]:
    """Exchanged channels and sides."""
    for car, order in itertools.product(
        CARS, ('["left", "right"]', "", '["right", "left"]', '"together"')
    ):
        one = axle(tester, car)
        one.order = order
        about = "" if order == '["left", "right"]' else "order_"
        if order != '"together"':
            yield one.record("wheel order", f"{car}, order {order or 'not stated'}", about)
        for which in ("heights", "forces", "sides", "loads"):
            one = axle(tester, car)
            one.order = order
            if which in ("heights", "sides"):
                one.z = {"left": one.z["right"], "right": one.z["left"]}
            if which in ("forces", "sides"):
                one.f = {"left": one.f["right"], "right": one.f["left"]}
            if which == "loads":
                one.loads = {"left": one.loads["right"], "right": one.loads["left"]}
            about = "sides_swapped|order_|load_off|load_contradicts|both_offset|no_wheel|force_elsewhere"
            if order == '"together"' and which == "sides":
                about = f"{about}|{HIDDEN}"
            yield one.record("exchange", f"{car}, {which}, order {order or 'not stated'}", about)
    for car in CARS:
        one = axle(tester, car)
        one.z, one.f = (
            {s: 1e-3 * v for s, v in one.f.items()},
            {s: 1e3 * v for s, v in one.z.items()},
        )
        yield one.record(
            "exchange", f"{car}, height and force", "columns_swapped|no_wheel_load|reading"
        )
        one = axle(tester, car)
        one.f["left"], one.z["left"] = 1e3 * one.z["left"], 1e-3 * one.f["left"]
        yield one.record(
            "exchange",
            f"{car}, height and force of the left plate",
            "columns_swapped|no_wheel|reading",
        )


_ODD = (
    (
        Wheel(310.0, 36.0, 21e3, 900.0, 190e3, friction=60.0),
        Wheel(330.0, 36.0, 21e3, 1500.0, 195e3, rebound=3.0),
    ),
    (
        Wheel(420.0, 45.0, 28e3, 180.0, 230e3),
        Wheel(405.0, 45.0, 28e3, 1500.0, 225e3, friction=40.0, rebound=2.0),
    ),
    (Wheel(180.0, 38.0, 14e3, 450.0, 220e3), Wheel(620.0, 60.0, 52e3, 2400.0, 320e3, rebound=2.5)),
    (
        Wheel(260.0, 40.0, 18e3, 2400.0, 260e3),
        Wheel(260.0, 40.0, 18e3, 700.0, 260e3, friction=100.0),
    ),
)
"""Dry friction, dampers with bends, worn and stiff ones, a tyre that lifts off: sound records of odd wheels."""


def odd_wheels() -> Iterator[TesterRecord]:
    """Correct records that checks of linear wheels must not reject."""
    for tester, (i, wheels), noise in itertools.product(
        (EGEA, THETA), enumerate(_ODD), (0.0005, 0.003, 0.01)
    ):
        yield axle(tester, wheels, noise).record("odd", f"{i}, noise {noise:g}")
