"""Rows of the benchmark table for vehicles: half car, full car, and the full car on four 3-D double wishbones.

``python benchmarks/vehicle_rows.py`` prints them alone. Peers get the matrices or the compiled right-hand side of the
same model and the same road; each uses its loosest setting that reaches the error.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cache, cached_property

import numpy as np
from numpy.typing import NDArray
from timing import Row, markdown, median_time

import jounce as jn
from jounce.core.segments import Segments
from jounce.parts.vehicles import FullCar3D
from jounce.roads import Iso8608, Train, Trapezoid, Trial
from jounce.simulation.compiled import Compiled, compile_rig
from jounce.simulation.prepare import PreparedRun, prepare
from jounce.simulation.problem import excitation
from jounce.simulation.reduced_car import LastTables, ReducedCar, car_reduction_of
from jounce.simulation.settings import output_times
from jounce.simulation.statics import find_equilibrium

Array = NDArray[np.float64]
Run = Callable[[], Array]
ERROR = 1e-6
_SLOW = 2.0  # s: what takes longer is timed once
_DISPLACEMENTS = ("unsprung.z", "body.z", "body.pitch", "body.roll")
TOLERANCES = (1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8)


@dataclass(frozen=True)
class Problem:
    """A vehicle on a trial: compiled model, parameters, output times, signals of all tracks, number of coordinates."""

    compiled: Compiled
    p: Array
    times: Array
    signals: list[Segments]

    @classmethod
    def of(cls, vehicle: jn.Vehicle, trial: Trial) -> Problem:
        """Compile and lay out."""
        compiled = compile_rig(vehicle)
        times = output_times(trial.duration, 1e-3)
        p = compiled.parameter_values(vehicle.parameters())
        return cls(compiled, p, times, excitation(compiled.facts, vehicle, trial))

    def prepared(self, tolerance: float) -> PreparedRun:
        """Our run."""
        return prepare(self.compiled, self.p, self.signals, self.times, tolerance=tolerance)

    def moved(self, states: Array) -> Array:
        """Coordinates from their values at rest."""
        found = states[: len(self.compiled.facts.coordinates)]
        return found - found[:, :1]

    def inputs(self, times: Array) -> Array:
        """Value and rate of every track at some times, one row each."""
        rows = [
            row
            for signal in self.signals
            for row in signal.evaluate(times)[: self.compiled.facts.track_order]
        ]
        return np.array(rows)

    def matrices(self) -> tuple[Array, Array, Array]:
        """Slopes of the rates along states and inputs at rest, and the state there."""
        still = self.inputs(self.times[:1])[:, 0]
        rest = find_equilibrium(self.compiled, self.p, still)
        a, b = (self.compiled.slopes(by, rest.x, still, self.p, rest.modes)["rate"] for by in "xu")
        return a, b, rest.x

    @cached_property
    def reference(self) -> Array:
        """Displacements to rounding error."""
        return self.moved(self.prepared(1e-11).run().states)

    def error(self, found: Array) -> float:
        """Largest error of a displacement relative to its range; constant displacements are left out."""
        reference = self.reference
        size = np.ptp(reference, axis=1)
        moving = size > 1e-9
        return float(np.max(np.max(np.abs(found - reference), axis=1)[moving] / size[moving]))


def own_row(title: str, problem: Problem, target: str, note: str = "") -> Row:
    """jounce's run at the loosest tolerance that reaches the error."""
    for tolerance in TOLERANCES:
        run = problem.prepared(tolerance)
        solution = run.run()
        error = problem.error(problem.moved(solution.states))
        if error <= ERROR:
            break
    seconds = median_time(run.run, repeats=31)
    faster = f"{problem.times[-1] / seconds:.0f} × real time"
    how = f"{solution.method}, {solution.steps} steps" if solution.steps else solution.method
    text = ", ".join(
        part
        for part in (note, how, f"{len(problem.compiled.facts.outputs)} channels", faster)
        if part
    )
    return Row(title, "jounce, compiled run", seconds, error, 1.0, target, text)


def peer_rows(
    title: str, problem: Problem, own: Row, peers: Iterator[tuple[str, Run]]
) -> list[Row]:
    """The first setting of each peer that reaches the error, else its last."""
    best: dict[str, tuple[float, Run, float]] = {}
    for name, run in peers:
        if name not in best or best[name][0] > ERROR:
            start = time.perf_counter()
            found = run()
            best[name] = problem.error(found), run, time.perf_counter() - start
    rows = []
    for name, (error, run, first) in best.items():
        seconds = first if first > _SLOW else median_time(run, repeats=5, budget=3.0)
        note = "displacements only" if error <= ERROR else "displacements only, error not reached"
        rows.append(Row(title, name, seconds, error, seconds / own.median, note=note))
    return rows


def linear_peers(problem: Problem) -> Iterator[tuple[str, Run]]:
    """Linear systems on the matrices at rest: SciPy, python-control, RK4 in Numba."""
    from scipy.integrate import solve_ivp
    from scipy.signal import StateSpace, lsim

    a, b, _ = problem.matrices()
    times, n = problem.times, len(problem.compiled.facts.coordinates)
    u = problem.inputs(times)
    du, keep = u - u[:, :1], (np.eye(len(a))[:n], np.zeros((n, b.shape[1])))
    system = StateSpace(a, b, *keep)
    yield "SciPy signal.lsim", lambda: lsim(system, du.T, times)[1].T
    try:
        import control
    except ImportError:
        pass
    else:
        same = control.ss(a, b, *keep)
        yield (
            "python-control forced_response",
            lambda: np.asarray(control.forced_response(same, times, du).outputs),
        )
    for count in (1, 2, 4, 8):
        yield "Numba RK4, up to 8 steps per sample", _rk4(problem, a, b, count)
    for tolerance in (1e-6, 1e-8):

        def integrate(tolerance: float = tolerance) -> Array:
            def rate(t: float, x: Array) -> Array:
                return a @ x + b @ (problem.inputs(np.array([t]))[:, 0] - u[:, 0])

            options = {"rtol": tolerance, "atol": 1e-3 * tolerance, "max_step": 0.01}
            end = min(times[-1], 10.0)
            return solve_ivp(
                rate, (0.0, end), np.zeros(len(a)), "DOP853", times[times <= end], **options
            ).y[:n]

        if times[-1] <= 10.0:
            yield "SciPy solve_ivp DOP853", integrate


def _rk4(problem: Problem, a: Array, b: Array, count: int) -> Run:
    """A loop with fixed steps that do not land on the road's points."""
    n = len(problem.compiled.facts.coordinates)
    steps = count * (len(problem.times) - 1)
    fine = np.arange(2 * steps + 1) * (problem.times[-1] / (2 * steps))
    u = problem.inputs(fine)
    forcing = np.ascontiguousarray((b @ (u - u[:, :1])).T)
    return lambda: _rk4_loop(a, forcing, problem.times[-1] / steps, count)[:n]


@cache
def _compiled_loop() -> Callable[..., Array]:
    from numba import njit

    @njit(fastmath=True)
    def loop(a, f, h, count):  # noqa: ANN001, ANN202
        size, steps = len(a), (len(f) - 1) // 2
        x, found = np.zeros(size), np.zeros((size, steps // count + 1))
        for i in range(steps):
            k1 = a @ x + f[2 * i]
            k2 = a @ (x + 0.5 * h * k1) + f[2 * i + 1]
            k3 = a @ (x + 0.5 * h * k2) + f[2 * i + 1]
            k4 = a @ (x + h * k3) + f[2 * i + 2]
            x = x + h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)
            if (i + 1) % count == 0:
                found[:, (i + 1) // count] = x
        return found

    return loop


def _rk4_loop(a: Array, forcing: Array, h: float, count: int) -> Array:
    return _compiled_loop()(np.ascontiguousarray(a), forcing, h, count)


def half_car_rows() -> list[Row]:
    """Case A of paper 2 in its physical form: brakes from 3 s, 5 cm obstacle from 6 s to 8 s."""
    road = Trapezoid(height="5 cm", length="20 m", ramp="0.5 m", shape="cosine", start="60 m")
    trial = Trial(
        road=road, speed="10 m/s", duration="10 s", pitch_moment={"value": 2700.0, "start": "3 s"}
    )
    title, problem = (
        "half car, case A, 10 s at 1 kHz",
        Problem.of(jn.load("audi-a6-half-car"), trial),
    )
    own = own_row(title, problem, "≤ 1 ms")
    return [own, *peer_rows(title, problem, own, linear_peers(problem))]


def iso_trial(step: str, duration: str) -> Trial:
    """Class C at 20 m/s, two tracks."""
    road = Iso8608(class_="C", length="1300 m", step=step)
    return Trial(road=road, right=road.other_track(), speed="20 m/s", duration=duration)


def full_car_rows() -> list[Row]:
    """Seven degrees of freedom on an ISO road of class C; tyres that stay down, and that lift."""
    vehicle = jn.load("audi-a6-full-car")
    held = vehicle.with_changes({"front.tyre.lift_off": False, "rear.tyre.lift_off": False})
    rows = []
    for title, car, step in (
        ("linear", held, "5 cm"),
        ("lift-off", vehicle, "5 cm"),
        ("lift-off", vehicle, "10 cm"),
    ):
        name = f"full car with 7 degrees of freedom, {title}, ISO road C, a point every {step}, 60 s at 1 kHz"
        problem = Problem.of(car, iso_trial(step, "60 s"))
        own = own_row(name, problem, "≤ 20 ms")
        rows += [
            own,
            *(peer_rows(name, problem, own, linear_peers(problem)) if car is held else []),
        ]
    return rows


def spatial_rows() -> list[Row]:
    """Formula Student car on four double wishbones with push rods and rockers."""
    vehicle = jn.load("formula-student-car")
    bumps = Train(
        of=jn.HalfSine(height="20 mm", length="0.5 m", start="5 m"), count=40, pitch="3 m"
    )
    trials = {
        "40 obstacles": Trial(road=bumps, right=jn.Flat(), speed="15 m/s", duration="10 s"),
        "ISO road C, a point every 10 cm": iso_trial("10 cm", "10 s"),
        "ISO road C, a point every 5 cm": iso_trial("5 cm", "10 s"),
    }
    rows = []
    for road, trial in trials.items():
        title = f"full car on four 3-D double wishbones, 10 s at 1 kHz, {road}"
        problem = Problem.of(vehicle, trial)
        own = own_row(title, problem, "≥ 50 × real time")
        rows += [own, reduced_row(title, problem, vehicle, own)]
        rows += (
            peer_rows(title, problem, own, compiled_peers(problem)) if "obstacles" in road else []
        )
    return rows


def reduced_row(title: str, problem: Problem, vehicle: jn.Vehicle, own: Row) -> Row:
    """The same car with one coordinate for each wheel, with new tables for every run."""
    assert isinstance(vehicle, FullCar3D)
    reduction = car_reduction_of(vehicle)
    assert reduction is not None
    shown = [
        i for i, name in enumerate(problem.compiled.output_names) if name.endswith(_DISPLACEMENTS)
    ]
    reference = problem.prepared(1e-11).run().outputs[shown]
    size = np.ptp(reference, axis=1)
    for tolerance in TOLERANCES:
        car = ReducedCar(reduction, vehicle.parameters(), problem.signals, problem.times, tolerance)
        found = car.run()
        assert found is not None
        solution = found[0]
        error = float(
            np.max(
                np.max(np.abs(solution.outputs[shown] - reference), axis=1)[size > 1e-9]
                / size[size > 1e-9]
            )
        )
        if error <= ERROR:
            break
    seconds = median_time(
        lambda: replace(car, reduction=replace(reduction, made=LastTables())).run(), repeats=31
    )
    how = f"{solution.method}, {solution.steps} steps, {len(solution.outputs)} channels, with its tables"
    return Row(
        title, "jounce, one coordinate per wheel", seconds, error, seconds / own.median, note=how
    )


def compiled_peers(problem: Problem) -> Iterator[tuple[str, Run]]:
    """SciPy on our compiled right-hand side; without location of lift-off and steps on the obstacles' edges."""
    from scipy.integrate import solve_ivp

    compiled, p, n = (
        problem.compiled,
        problem.compiled.extend(problem.p),
        len(problem.compiled.facts.coordinates),
    )
    modes, start = np.ones(len(compiled.facts.switches)), problem.matrices()[2]

    def rate(t: float, x: Array) -> Array:
        u = problem.inputs(np.array([t]))[:, 0]
        sides = (compiled.evaluate("switch", x, u, p, modes) > 0.0).astype(float)
        return compiled.evaluate("rate", x, u, p, sides)

    for tolerance in (1e-5,):

        def run(tolerance: float = tolerance) -> Array:
            options = {"rtol": tolerance, "atol": 1e-3 * tolerance, "max_step": 0.01}
            span = problem.times[0], problem.times[-1]
            return problem.moved(
                solve_ivp(rate, span, start, "DOP853", problem.times, **options).y[:n]
            )

        yield "SciPy solve_ivp DOP853 on jounce's compiled right-hand side", run


def start_rows() -> list[Row]:
    """Building and compiling the 3-D car in fresh processes."""
    script = (
        "import time, jounce as jn\nfrom jounce.simulation.compiled import compile_rig\n"
        "import casadi, llvmlite.binding\ncar = jn.load('formula-student-car'); start = time.perf_counter()\n"
        "compile_rig(car); print(time.perf_counter() - start)"
    )

    def once(folder: str) -> float:
        environment = {**os.environ, "JOUNCE_CACHE_DIR": folder}
        command = [sys.executable, "-c", script]
        return float(
            subprocess.run(
                command, capture_output=True, text=True, check=True, env=environment
            ).stdout
        )

    problem = "build and compile the full car on four 3-D double wishbones"
    with tempfile.TemporaryDirectory() as folder:
        first = once(folder)
        cached = float(np.median([once(folder) for _ in range(3)]))
    return [
        Row(problem, "first time", first, target="≤ 5 s"),
        Row(problem, "from the cache", cached, target="≤ 50 ms"),
    ]


def vehicle_rows() -> list[Row]:
    """All of them."""
    parts = (half_car_rows, full_car_rows, spatial_rows, start_rows)
    return [row for part in parts for row in part()]


if __name__ == "__main__":
    print(markdown(vehicle_rows()))
