"""A master for FMUs of model exchange as the standard means it: inputs in every evaluation, events located exactly."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass, field
from pathlib import Path

import fmpy
import numpy as np
from scipy.integrate import solve_ivp

DOUBLES = ctypes.POINTER(ctypes.c_double)


class Fmu:
    """An instance of an FMU of either version, by names."""

    def __init__(self, path: Path, folder: Path, kind: str) -> None:
        unzipped = fmpy.extract(str(path), unzipdir=str(folder / path.stem))
        self.about = fmpy.read_model_description(str(path))
        self.references = {v.name: v.valueReference for v in self.about.modelVariables}
        self.messages: list[str] = []
        self.three = self.about.fmiVersion.startswith("3")
        self.it = fmpy.instantiate_fmu(
            unzipped, self.about, fmi_type=kind, **({} if self.three else {"debug_logging": False})
        )
        self.states = self.about.numberOfContinuousStates or len(
            [v for v in self.about.modelVariables if v.name.startswith("der(")]
        )

    def get(self, *names: str) -> np.ndarray:
        get = self.it.getFloat64 if self.three else self.it.getReal
        return np.array(get([self.references[name] for name in names]))

    def set(self, **values: float) -> None:
        self.put(list(values), list(values.values()))

    def put(self, names, values) -> None:
        real = [
            (n, float(v)) for n, v in zip(names, values, strict=True) if not isinstance(v, bool)
        ]
        flags = [(n, v) for n, v in zip(names, values, strict=True) if isinstance(v, bool)]
        if real:
            put = self.it.setFloat64 if self.three else self.it.setReal
            put([self.references[n] for n, _ in real], [v for _, v in real])
        if flags:
            self.it.setBoolean([self.references[n] for n, _ in flags], [v for _, v in flags])

    def begin(self, values: dict[str, float] | None = None, tolerance: float | None = None) -> None:
        """Initialise with some values set."""
        values = values or {}
        if self.three:
            self.put(list(values), list(values.values()))
            self.it.enterInitializationMode(startTime=0.0, tolerance=tolerance)
        else:
            self.it.setupExperiment(startTime=0.0, tolerance=tolerance)
            self.put(list(values), list(values.values()))
            self.it.enterInitializationMode()
        self.it.exitInitializationMode()

    def step(self, t: float, h: float) -> None:
        self.it.doStep(t, h)

    def modes(self) -> np.ndarray:
        """Which modes are on."""
        references = [vr for name, vr in self.references.items() if name.startswith("mode.")]
        return np.array(self.it.getBoolean(references) if references else [], dtype=bool)

    def close(self) -> None:
        self.it.terminate()
        self.it.freeInstance()


@dataclass
class Course:
    """Inputs by name against time, smooth between edges: ``values(t)`` gives them, ``edges`` are times (s)."""

    names: list[str]
    values: object
    edges: list[float]


@dataclass
class Run:
    """What a master saw: outputs at the end, and when modes changed (twice where two changed at once)."""

    outputs: np.ndarray
    events: list[float] = field(default_factory=list)
    evaluations: int = 0


def exchange(fmu: Fmu, course: Course, end: float, outputs: list[str], rtol: float = 1e-9) -> Run:
    """Integrate an FMU of model exchange; SciPy's DOP853 does the steps, events are those of the indicators."""
    it, n, indicators = fmu.it, fmu.states, fmu.about.numberOfEventIndicators or 0
    fmu.begin(dict(zip(course.names, course.values(0.0), strict=True)))
    x, z, dx, nominal = np.zeros(n), np.zeros(indicators), np.zeros(n), np.zeros(n)
    run, low, high = Run(np.zeros(0)), 0.0, end

    def event_mode() -> float:
        it.enterEventMode()
        return update()

    def update() -> float:
        if fmu.three:
            _, _, _, _, given, following = it.updateDiscreteStates()
        else:
            _, _, _, _, given, following = it.newDiscreteStates()
        it.enterContinuousTimeMode()
        return float(following) if given else np.inf

    def put(t: float, y: np.ndarray) -> None:
        inside = min(max(t, low + 1e-13), high - 1e-13)  # of the smooth piece
        it.setTime(t)
        fmu.put(course.names, course.values(inside))
        whole = np.ascontiguousarray(y)
        it.setContinuousStates(whole.ctypes.data_as(DOUBLES), n)

    def slope(t: float, y: np.ndarray) -> np.ndarray:
        run.evaluations += 1
        put(t, y)
        derivatives = it.getContinuousStateDerivatives if fmu.three else it.getDerivatives
        derivatives(dx.ctypes.data_as(DOUBLES), n)
        return dx.copy()

    def indicator(i: int):
        def value(t: float, y: np.ndarray) -> float:
            put(t, y)
            it.getEventIndicators(z.ctypes.data_as(DOUBLES), indicators)
            return float(z[i])

        value.terminal = True
        return value

    following = update()
    it.getContinuousStates(x.ctypes.data_as(DOUBLES), n)
    it.getNominalsOfContinuousStates(nominal.ctypes.data_as(DOUBLES), n)
    t = 0.0
    edges = sorted({*(edge for edge in course.edges if 0.0 < edge < end), end})
    while t < end - 1e-12:
        high = min(next(edge for edge in edges if edge > t + 1e-12), following)
        low = t
        found = solve_ivp(
            slope, (t, high), x, method="DOP853", rtol=rtol, atol=rtol * nominal, max_step=2e-3,
            events=[indicator(i) for i in range(indicators)] or None,
        )  # fmt: skip
        t, x = float(found.t[-1]), found.y[:, -1]
        put(t, x)
        it.completedIntegratorStep()
        if t < end - 1e-12:  # inputs may jump at edges: a controller sees what holds from here on
            low, high = t, end
            put(t, x)
            before = fmu.modes()
            following = event_mode()
            run.events += [t] * int(np.sum(fmu.modes() != before))
    low, high = end - 1.0, end
    put(end, x)
    run.outputs = fmu.get(*outputs)
    return run


def cosimulate(
    fmu: Fmu, course: Course, end: float, step: float, outputs: list[str], tolerance: float = 1e-5
) -> np.ndarray:
    """Outputs at all communication points, shape (points, outputs); the inputs at a point hold until the next."""
    fmu.begin(dict(zip(course.names, course.values(0.0), strict=True)), tolerance)
    count = round(end / step)
    found = [fmu.get(*outputs)]
    for i in range(count):
        fmu.put(course.names, course.values(i * step))
        fmu.step(i * step, step)
        found.append(fmu.get(*outputs))
    return np.array(found)
