"""Virtual benches whose laws, masses, roads and sensors are not those of the quarter car that is fitted to them.

Every bench is drawn from its seed. Two thirds are quarter cars with other laws, a third is the double wishbone in 3-D.
The dampers are degressive and asymmetric tables, progressive ones, blow-off valves, Kwok's hyperbolic tangent and
Bouc-Wen; the tyres polynomials or power laws; obstacles are of another height, and often of another shape or length;
the belt slows down behind each of them; noise is white or coloured; high passes are not as told. What the intervals
are held against are component and effective value over the states truly ridden.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

import jounce as jn
from jounce.identify.discrepancy import ModelErrorProblem, _State
from jounce.identify.fit_problem import free_parameters
from jounce.identify.laws import Laws, States
from jounce.identify.settings import UpdateSettings
from jounce.papers.virtual_bench import wheel_path
from jounce.recordings import recording

RATE, DURATION = 1000.0, 1.4
TRIALS = (  # speed m/s, pitch m (0: a single obstacle), strut angle deg
    (1.95, 0.0, 26), (3.79, 0.0, 26), (1.97, 0.10, 26), (2.06, 0.0, 10), (2.86, 0.0, 16), (1.99, 0.20, 26),
)  # fmt: skip
CHANNELS = ("sprung.az", "unsprung.az")
FREE = {
    "strut.spring.rate": "20 %",
    "strut.damper.coefficient": "60 %",
    "strut.friction.force": ["0 N", "40 N"],
    "guide.friction.force": ["0 N", "40 N"],
    "tyre.stiffness": "25 %",
    "tyre.damping_coefficient": ["0 N*s/m", "90 N*s/m"],
}
_HYSTERETIC = ("tanh", "bouc-wen")
_STATES = ("strut.deflection", "strut.velocity", "tyre.deflection", "sprung.vz")


@dataclass
class Bench:
    """Trials to fit and what they hide: component and effective value of each parameter, SI."""

    seed: int
    kind: str
    trials: list[jn.FitTrial]
    component: dict[str, float]
    effective: dict[str, float] = field(default_factory=dict)


def bench(seed: int, *, trials: int = len(TRIALS)) -> Bench:
    """Draw a bench: every third is in 3-D."""
    draw = np.random.default_rng([7, seed])
    spatial = seed % 3 == 2
    coefficient = draw.uniform(80.0, 220.0)
    kind, damper = _damper(draw, coefficient)
    rate, stiffness = draw.uniform(20e3, 26e3), draw.uniform(118e3, 150e3)
    strut, guide, damping = (
        draw.uniform(2.0, 14.0),
        draw.uniform(2.0, 16.0),
        draw.uniform(5.0, 60.0),
    )
    onsets = np.exp(draw.uniform(np.log(0.3e-3), np.log(4e-3), 2))
    masses = (
        16.0 * (1.0 + 0.004 * draw.standard_normal()),
        5.0 * (1.0 + 0.03 * draw.standard_normal()),
    )
    curve = _tyre(draw, stiffness, (masses[0] + masses[1]) * 9.81)
    friction = [
        {"force": force, "regularisation_velocity": onset}
        for force, onset in zip((strut, guide), onsets, strict=True)
    ]
    changes: dict[str, Any] = {
        "sprung.mass": masses[0],
        "strut.spring.rate": rate,
        "strut.damper": damper,
        "strut.friction": friction[0],
        "tyre": {"curve": curve, "damping_coefficient": damping},
    }
    if spatial:
        rig = jn.load("kart-double-wishbone")
        upright = rig.parameters()["bodies.upright.mass"] * (1.0 + 0.03 * draw.standard_normal())
        changes |= {"guide_friction": friction[1], "bodies.upright.mass": upright}
    else:
        rig = jn.load("kart-quarter-car")
        changes |= {"guide": {"friction": friction[1]}, "unsprung.mass": masses[1]}
        if draw.random() < 0.5:
            bend = rate * draw.uniform(-0.04, 0.08) / 0.015
            changes["strut.spring"] = {
                "curve": {"kind": "polynomial", "coefficients": (rate - 2.0 * bend * 0.007, bend)}
            }
            del changes["strut.spring.rate"]
    height = 0.010 * (1.0 + 0.015 * draw.standard_normal())
    shape = {
        "kind": "half-sine",
        "height": height,
        "length": 0.060 * (1.0 + 0.02 * draw.standard_normal()),
    }
    if draw.random() < 0.3:
        shape |= {"kind": "table", "x": tuple(np.linspace(0.0, shape["length"], 41))}
        length, power = shape.pop("length"), draw.uniform(0.9, 1.15)
        shape["height"] = tuple(height * np.sin(np.pi * np.linspace(0.0, 1.0, 41)) ** power)
        assert length > 0.0
    truth = jn.BenchTruth(
        rig=rig,
        changes=changes,
        obstacle={**shape, "start": 0.2},
        belt={
            "contact_length": draw.uniform(0.003, 0.018),
            "speed_drop": draw.choice([0.0, draw.uniform(0.0, 0.012)]),
            "recovery_time": draw.uniform(0.2, 0.6),
        },
        sensors={
            name: {
                "high_pass": draw.uniform(0.4, 0.65),
                "low_pass": 250.0 * draw.uniform(0.8, 1.25),
                "gain": 1.0 + 0.01 * draw.standard_normal(),
                "bias": 0.1 * draw.standard_normal(),
            }
            for name in CHANNELS
        },
    )
    told = jn.load("kart-quarter-car").with_changes({
        "unsprung.mass": 5.0,
        "strut.spring.rate": rate * draw.uniform(0.97, 1.03),
        "strut.damper.coefficient": coefficient * draw.uniform(0.8, 1.25),
        "strut.friction": {"force": 5.0, "regularisation_velocity": 0.005},
        "guide.friction": {"force": 5.0, "regularisation_velocity": 0.005},
        "tyre.stiffness": stiffness * draw.uniform(0.95, 1.06),
        "tyre.damping_coefficient": 15.0,
    })  # fmt: skip
    colour = draw.choice([0.0, 0.6])
    fits, rides = [], []
    for number, (speed, pitch, degrees) in enumerate(TRIALS[:trials], 1):
        real, lag = speed + draw.uniform(-5e-3, 5e-3), draw.uniform(-6e-4, 6e-4)
        late = truth.obstacle.model_copy(update={"start": 0.2 + real * lag})
        obstacle = late if pitch == 0.0 else jn.Train(of=late, count=5, pitch=pitch)
        path = jn.Trial(excitation=wheel_path(obstacle, real, DURATION, truth), duration=DURATION)
        angle = np.radians(degrees + 0.3 * draw.standard_normal())
        run = jn.simulate(jn.with_strut_angle(truth.true_rig(), angle), path, tolerance=1e-6)
        sensed = jn.apply_sensors(run[list(CHANNELS)], truth.sensors)
        noise = {
            name: _noise(draw, len(run["time"]), colour) * size
            for name, size in zip(CHANNELS, (0.15, 0.8), strict=True)
        }
        measured = recording(
            run["time"].to_numpy(),
            {name: (sensed[name].to_numpy() + noise[name], "m/s^2", "") for name in CHANNELS},
        )
        road = jn.HalfSine(height=0.010, length=0.060, start=0.2)
        road = road if pitch == 0.0 else jn.Train(of=road, count=5, pitch=pitch)
        sensor = {name: jn.Sensor(high_pass=0.5, low_pass=250.0) for name in CHANNELS}
        rig = told.with_changes({"strut.angle": f"{degrees} deg"})
        trial = jn.Trial(road=road, speed=speed, duration=DURATION)
        fits.append(jn.FitTrial(f"trial {number}", rig, trial, measured, sensor))
        rides.append(run)
    component, effective = _truths(truth.true_rig(), rides)
    return Bench(seed, f"{'3-D' if spatial else 'quarter car'}, {kind}", fits, component, effective)


def doubted_bench(seed: int, *, trials: int = len(TRIALS)) -> Bench:
    """Draw a quarter car that is off by just what ``Doubt`` says: every error from its prior, noise white.

    The richer model is the truth here, so nothing is left unexplained and no prior is too wide or too narrow.
    """
    draw = np.random.default_rng([17, seed])
    ranges = ((20e3, 26e3), (80.0, 220.0), (2.0, 14.0), (2.0, 16.0), (118e3, 150e3), (5.0, 60.0))
    true = {path: draw.uniform(*ends) for path, ends in zip(FREE, ranges, strict=True)}
    told = jn.load("kart-quarter-car").with_changes({
        "strut.spring.rate": true["strut.spring.rate"] * draw.uniform(0.97, 1.03),
        "strut.damper.coefficient": true["strut.damper.coefficient"] * draw.uniform(0.8, 1.25),
        "strut.friction": {"force": 5.0, "regularisation_velocity": 0.005},
        "guide.friction": {"force": 5.0, "regularisation_velocity": 0.005},
        "tyre.stiffness": true["tyre.stiffness"] * draw.uniform(0.95, 1.06),
        "tyre.damping_coefficient": 15.0,
    })  # fmt: skip
    sensor = {name: jn.Sensor(high_pass=0.5, low_pass=250.0) for name in CHANNELS}
    meant = []
    for number, (speed, pitch, degrees) in enumerate(TRIALS[:trials], 1):
        road = jn.HalfSine(height=0.010, length=0.060, start=0.2)
        road = road if pitch == 0.0 else jn.Train(of=road, count=5, pitch=pitch)
        rig = told.with_changes({"strut.angle": f"{degrees} deg"})
        trial = jn.Trial(road=road, speed=speed, duration=DURATION)
        meant.append(
            jn.FitTrial(
                f"trial {number}", rig, trial, jn.simulate(rig, trial)[list(CHANNELS)], sensor
            )
        )
    free = free_parameters(told, FREE, where="doubted bench")
    one = ModelErrorProblem(
        meant,
        free,
        UpdateSettings(weights="normalised", align="lag", tolerance=1e-7, doubt=jn.Doubt()),
        start=true,
    )
    state = _State(
        np.array([item.scale(true[item.path]) for item in free]),
        draw.standard_normal(len(one.nuisances)),
        draw.standard_normal((trials, len(one.own))),
        np.zeros(trials),
    )
    seen, fits = [], []
    for number, (run, trial) in enumerate(zip(one.runs, meant, strict=True)):
        for _ in range(4):  # forces beside the strut follow from the motion that they cause
            solution = run.simulate(
                run.compiled.plain, run.numbers(state), one.inputs(state, number)
            )
            states = States.of(run.compiled.plain, solution)
            run.beside = run.forces(states)
        seen.append(states)
        signals = {}
        for channel, size in zip(run.channels, (0.15, 0.8), strict=True):
            reading = run.prepared.table(one._doubtful_channel(channel, state.xi), solution)[:, 0]
            signals[channel.name] = (
                reading + size * draw.standard_normal(len(reading)),
                "m/s^2",
                "",
            )
        fits.append(replace(trial, measured=recording(trial.measured["time"].to_numpy(), signals)))
    laws, run = Laws(one.richer, seen), one.runs[0]
    numbers = one.richer.plain(run.values, run.fitted_values(state.theta), state.xi)
    presliding = one.value("presliding", state.xi)
    both = {path: laws.readings(path, numbers, state.xi, presliding) for path in FREE}
    component, effective = ({path: pair[k] for path, pair in both.items()} for k in (0, 1))
    return Bench(seed, "quarter car, as doubted", fits, component, effective)


def _noise(draw: np.random.Generator, count: int, colour: float) -> np.ndarray:
    """Noise of unit variance, white or of first order."""
    from scipy.signal import lfilter

    white = draw.standard_normal(count + 200)
    return lfilter([np.sqrt(1.0 - colour**2)], [1.0, -colour], white)[200:]


def _damper(draw: np.random.Generator, c: float) -> tuple[str, dict[str, Any]]:
    kind = str(draw.choice(["linear", "degressive", "progressive", "blow-off", "tanh", "bouc-wen"]))
    v = np.array([-1.5, -0.8, -0.4, -0.15, -0.05, 0.0, 0.05, 0.15, 0.4, 0.8, 1.5])
    uneven = 1.0 + draw.uniform(-0.25, 0.25) * np.sign(v)
    if kind == "linear":
        return kind, {"coefficient": c}
    if kind == "degressive":
        power = draw.uniform(0.75, 0.95)
        force = c * uneven * np.sign(v) * np.abs(v) ** power * 0.4 ** (1.0 - power)
    elif kind == "progressive":
        power = draw.uniform(1.05, 1.3)
        force = c * uneven * np.sign(v) * np.abs(v) ** power * 0.4 ** (1.0 - power)
    elif kind == "blow-off":
        opens = draw.uniform(0.2, 0.6)
        force = (
            c
            * uneven
            * np.sign(v)
            * (np.minimum(np.abs(v), opens) + 0.55 * np.maximum(np.abs(v) - opens, 0.0))
        )
    elif kind == "tanh":
        return kind, {
            "kind": "tanh", "coefficient": c, "force": draw.uniform(1.0, 6.0), "slope": draw.uniform(20.0, 80.0),
            "displacement_coupling": draw.uniform(0.0, 8.0),
        }  # fmt: skip
    else:
        return kind, {
            "kind": "bouc-wen", "coefficient": c, "hysteretic_force": draw.uniform(1.0, 6.0),
            "rate": draw.uniform(700.0, 5000.0), "sigma": draw.uniform(0.5, 0.9), "exponent": draw.uniform(1.0, 2.0),
        }  # fmt: skip
    return kind, {"velocity": tuple(v), "force": tuple(force)}


def _tyre(draw: np.random.Generator, stiffness: float, load: float) -> dict[str, Any]:
    """A tyre with the tangent ``stiffness`` (N/m) at its load (N): polynomial or power law."""
    rest = load / stiffness
    if draw.random() < 0.6:
        square, cube = draw.uniform(0.0, 1.2e6), draw.uniform(-10e6, 40e6)
        return {
            "kind": "polynomial",
            "coefficients": (stiffness - 2.0 * square * rest - 3.0 * cube * rest**2, square, cube),
        }
    exponent = draw.uniform(1.0, 1.06)
    return {
        "kind": "power",
        "coefficient": stiffness / (exponent * rest ** (exponent - 1.0)),
        "exponent": exponent,
    }


def _truths(rig: Any, rides: list[Any]) -> tuple[dict[str, float], dict[str, float]]:
    """Component and effective values over the states ridden, from the forces of the true laws."""
    x, v, d, u = (np.concatenate([run[name].to_numpy() for run in rides]) for name in _STATES)
    rate_d = np.concatenate(
        [np.gradient(run["tyre.deflection"].to_numpy(), 1.0 / RATE) for run in rides]
    )
    tyre = np.concatenate([run["tyre.force"].to_numpy() for run in rides])
    force = np.concatenate([run["strut.force"].to_numpy() for run in rides])
    values = rig.parameters()
    elastic = values.get("strut.spring.rate", 0.0) * x
    if rig.strut.spring.curve is not None:
        elastic = np.polyval([*reversed(rig.strut.spring.curve.coefficients), 0.0], x)
    strut, onset = values["strut.friction.force"], values["strut.friction.regularisation_velocity"]
    guide_at = "guide.friction" if "guide.friction.force" in values else "guide_friction"
    guide, turn = values[f"{guide_at}.force"], values[f"{guide_at}.regularisation_velocity"]
    damper, dry = rig.strut.damper, strut
    rest = force - elastic - strut * np.tanh(v / onset)
    if rig.strut.spring.rate is None or abs(rest).max() > 1e3:
        rest = rest - np.median(rest)
    kind = getattr(damper, "kind", "linear")
    viscous = rest
    if kind in _HYSTERETIC:
        dry, viscous = (
            strut + getattr(damper, "force", getattr(damper, "hysteretic_force", 0.0)),
            damper.coefficient * v,
        )
    else:
        viscous = rest - np.mean(rest[np.abs(v) < 1e-4]) if np.any(np.abs(v) < 1e-4) else rest
    static = float(rides[0]["tyre.deflection"][0])
    component = {
        "strut.spring.rate": _tangent(rig, values, float(np.median(x))),
        "strut.damper.coefficient": float(v @ viscous / (v @ v)),
        "strut.friction.force": float(dry),
        "guide.friction.force": guide,
        "tyre.stiffness": _slope(rig.tyre.curve, static),
        "tyre.damping_coefficient": values["tyre.damping_coefficient"],
    }
    names = ("strut.spring.rate", "strut.damper.coefficient", "strut.friction.force")
    table = np.column_stack([np.ones(len(v)), x, v, np.tanh(v / 0.005)])
    effective = dict(zip(names, np.linalg.lstsq(table, force, rcond=None)[0][1:], strict=True))
    on = d > 0.0
    found = np.linalg.lstsq(
        np.column_stack([np.ones(on.sum()), d[on], rate_d[on]]), tyre[on], rcond=None
    )[0]
    column = np.tanh(u / 0.005)
    effective |= {
        "tyre.stiffness": float(found[1]),
        "tyre.damping_coefficient": float(found[2]),
        "guide.friction.force": float(guide * (column @ np.tanh(u / turn)) / (column @ column)),
    }
    return component, effective


def _tangent(rig: Any, values: dict[str, float], at: float) -> float:
    if rig.strut.spring.rate is not None:
        return values["strut.spring.rate"]
    first, second = rig.strut.spring.curve.coefficients
    return float(first + 2.0 * second * at)


def _slope(curve: Any, at: float) -> float:
    if curve.kind == "power":
        return float(curve.coefficient * curve.exponent * at ** (curve.exponent - 1.0))
    return float(sum((i + 1) * c * at**i for i, c in enumerate(curve.coefficients)))


@dataclass(frozen=True)
class Row:
    """One parameter of one bench: true readings, interval of the noise only, and with what the model lacks; SI."""

    seed: int
    kind: str
    path: str
    component: float
    effective: float
    fitted: float
    noise_only: tuple[float, float] | None
    value: float
    interval: tuple[float, float]
    identified: bool
    unexplained: float

    @property
    def is_covered(self) -> bool:
        """Whether the interval holds both readings of the truth."""
        return all(
            self.interval[0] <= true <= self.interval[1]
            for true in (self.component, self.effective)
        )

    @property
    def was_covered(self) -> bool:
        """Whether the interval of the noise only holds either reading."""
        low, high = self.noise_only or (self.fitted, self.fitted)
        return any(low <= true <= high for true in (self.component, self.effective))

    @property
    def share(self) -> float:
        """Half-width over value."""
        return 0.5 * (self.interval[1] - self.interval[0]) / max(abs(self.value), 1e-300)


def rows_of(seed: int) -> list[Row]:
    """Draw a bench, fit the quarter car, and lay its intervals beside the truth."""
    one = bench(seed)
    found = jn.update_model(one.trials, FREE, weights="normalised", align="lag", doubt=jn.Doubt())
    assert found.discrepancy is not None
    unexplained = max(found.discrepancy.unexplained.values())
    rows = []
    for path, law in found.discrepancy.parameters.items():
        plain = found.parameters[path]
        true = one.component[path], one.effective[path]
        numbers = (
            plain.value,
            plain.interval,
            law.value,
            law.interval,
            law.identified,
            unexplained,
        )
        rows.append(Row(seed, one.kind, path, *true, *numbers))
    return rows


def table(rows: list[Row]) -> str:
    """Coverage by parameter: of the noise only, of all, of the identified; how many are, and median half-width."""
    lines = [f"{'parameter':26s} noise only  all  identified  of them covered  median half-width"]
    for path in [*FREE, "all"]:
        some = [row for row in rows if path in (row.path, "all")]
        known = [row for row in some if row.identified]
        covered = 100.0 * np.mean([row.is_covered for row in known]) if known else float("nan")
        lines.append(
            f"{path:26s} {100 * np.mean([row.was_covered for row in some]):8.0f} %"
            f" {100 * np.mean([row.is_covered for row in some]):3.0f} % {len(known):5d} of {len(some):3d}"
            f" {covered:12.0f} % {100 * np.median([row.share for row in some]):14.1f} %"
        )
    return "\n".join(lines)


if __name__ == "__main__":
    import json
    import sys
    from dataclasses import asdict

    everything: list[Row] = []
    for number in range(int(sys.argv[1]), int(sys.argv[2])):
        everything += rows_of(number)
        for row in everything[-len(FREE) :]:
            sys.stdout.write(f"{json.dumps(asdict(row))}\n")
            sys.stdout.flush()
    for title, wanted in (("all", ""), ("quarter car", "quarter"), ("3-D", "3-D")):
        sys.stdout.write(f"{title}\n{table([row for row in everything if wanted in row.kind])}\n")
