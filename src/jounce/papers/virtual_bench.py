"""The virtual bench: every measurement file of a campaign, made from a model with known values.

It gives the files that a laboratory would: force against deflection of spring and tyre, free decays, obstacle passes
seen through accelerometers. The same plan always gives the same files; ``truth.toml`` beside them holds the values.

The paper's recordings are lost, so the bench stands in for its laboratory. It runs the shipped kart-scale
double wishbone in 3-D, which is what the paper built; a quarter car that is fitted to it lacks the linkage (motion
ratio that changes with travel, inertia of arms and upright). What the bench has and both models lack: a slightly
heavier upright than its builders say, a tyre that stiffens with deflection and damps, a damper whose force falls behind
its velocity (degressive, softer in bump than in rebound), dry friction in strut and guide, and, on the test machine
only, a tyre that first settles on its support (the paper's explanation of its soft first 2 mm; a rolling tyre does not
do that). What the wheel meets is richer, too: a contact patch of finite length smooths the obstacle, and every obstacle
slows the belt down a little, which the motor then makes up for.
"""

from __future__ import annotations

import math
import zlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np

import jounce as jn
from jounce.papers import Array, Progress, no_progress
from jounce.papers.table2 import Table2Row, table2

SYNTHETIC = "Synthetic: made by jounce's virtual bench from a richer model (truth.toml); not a laboratory record."
RIG = "kart-double-wishbone"
"""Shipped rig whose geometry and masses the bench has, but for what is said here."""
SPRING_RATE = 22730.0  # N/m
SPRUNG_MASS = 16.0  # kg
UPRIGHT_MASS = 4.7  # kg, with wheel; campaigns are told 4.6 kg
TYRE_DAMPING = 20.0  # N s/m
STRUT_FRICTION = 5.0  # N
GUIDE_FRICTION = 9.0  # N
REGULARISATION_VELOCITY = 0.001  # m/s
DAMPER_VELOCITY = (-1.2, -0.5, -0.15, 0.0, 0.15, 0.5, 1.2)  # m/s, bump positive
DAMPER_FORCE = (-190.0, -92.0, -32.0, 0.0, 23.0, 66.0, 136.0)  # N
TYRE_CURVES: Mapping[float, tuple[float, float, float]] = MappingProxyType(
    {310e3: (128.8e3, 0.60e6, 30e6), 250e3: (114.2e3, 0.85e6, 22e6)}
)  # Pa: N/m, N/m^2, N/m^3, rolling
SETTLING = 0.45e-3, 50.0  # m, N: how far, and the force over which, a tyre settles on the test machine's support
CONTACT_LENGTH = 0.012  # m
SPEED_DROP = 0.006  # share of the belt's speed that each obstacle takes
SPEED_RECOVERY = 0.4  # s
TYRE_LOSS = 0.06  # share of the force missing when the tyre is unloaded
SENSORS: Mapping[str, jn.Sensor] = {
    "sprung.az": jn.Sensor(high_pass=0.5, low_pass=250.0, noise=0.15, bias=0.04, gain=1.01),
    "unsprung.az": jn.Sensor(high_pass=0.5, low_pass=250.0, noise=0.8, bias=-0.15, gain=0.99),
}
_OBSTACLE = {"height": 0.010, "length": 0.060, "start": 0.2}
_OBSTACLES_IN_TRAIN = 5
_WEIGHT = 2.5  # kg; weights that press the sprung mass down before a free decay


def true_rig(strut_angle: float = 0.4537856, tyre_pressure: float = 310e3) -> jn.DoubleWishbone:
    """Give the rig that the virtual bench runs, at a strut angle (rad, in front view) and a tyre pressure (Pa).

    Examples
    --------
    >>> rig = true_rig()
    >>> rig.guide_friction.force, rig.tyre.curve.kind
    (9.0, 'polynomial')
    """
    shipped = jn.load(RIG)
    assert isinstance(shipped, jn.DoubleWishbone)
    friction = {"regularisation_velocity": REGULARISATION_VELOCITY}
    table: dict[str, Any] = shipped.model_dump(by_alias=True, exclude_none=True)
    strut, upright = table["strut"], table["bodies"]["upright"]
    table |= {
        "source": SYNTHETIC,
        "estimated": (),
        "sprung": {"mass": SPRUNG_MASS},
        "bodies": {**table["bodies"], "upright": {**upright, "mass": UPRIGHT_MASS}},
        "strut": {
            **strut,
            "spring": {**strut["spring"], "rate": SPRING_RATE},
            "damper": {"velocity": DAMPER_VELOCITY, "force": DAMPER_FORCE},
            "friction": {"force": STRUT_FRICTION, **friction},
        },
        "guide_friction": {"force": GUIDE_FRICTION, **friction},
        "tyre": {
            "curve": {"kind": "polynomial", "coefficients": TYRE_CURVES[tyre_pressure]},
            "damping_coefficient": TYRE_DAMPING,
        },
    }
    return jn.with_strut_angle(jn.DoubleWishbone.from_table(table), strut_angle)


def spring_cycle(stroke: float, points: int, rate: float) -> tuple[Array, Array]:
    """Load spring and strut on the test machine to a ``stroke`` (m) and unload them: deflections (m) and forces (N).

    The load cell was zeroed with the strut sliding, so its friction shows as a drop of twice its force on the way back.
    """
    deflection, direction = _triangle(stroke, points)
    reversed_friction = 2.0 * STRUT_FRICTION * (1.0 - np.exp(-(stroke - deflection) / 0.1e-3))
    return deflection, rate * deflection - np.where(direction > 0.0, 0.0, reversed_friction)


def tyre_cycle(stroke: float, points: int, pressure: float, scale: float) -> tuple[Array, Array]:
    """Load the standing tyre on the test machine to a ``stroke`` (m) and unload it: deflections (m) and forces (N).

    The deflection is that of the machine, tyre and settling together: the standing tyre is softer than the rolling one
    at first, and lower when it is unloaded. ``scale`` is the stiffness of this trial over that of the true curve.
    """
    deflection, direction = _triangle(stroke, points)
    tyre = np.linspace(0.0, stroke, 4001)
    force = scale * np.polyval([*reversed(TYRE_CURVES[pressure]), 0.0], tyre)
    machine = tyre + SETTLING[0] * (1.0 - np.exp(-force / SETTLING[1]))
    loading = np.interp(deflection, machine, force)
    lost = np.where(direction > 0.0, 0.0, TYRE_LOSS * (1.0 - (deflection / stroke) ** 4))
    return deflection, loading * (1.0 - lost)


def _triangle(stroke: float, points: int) -> tuple[Array, Array]:
    """Deflections up and down again, and +1 or -1 for the direction."""
    up = np.linspace(0.0, stroke, points)
    return np.concatenate([up, up[-2::-1]]), np.concatenate([np.ones(points), -np.ones(points - 1)])


def wheel_path(road: jn.Road, speed: float, duration: float, *, points: int = 60) -> jn.Excitation:
    """Height (m) that the wheel really meets against time (s) while the belt carries obstacles past it.

    It is the mean of the obstacle's height over the contact patch, which begins half a patch before the foot, at the
    distance that the slowed belt has reached; ``speed`` (m/s) is that before the first obstacle. Between obstacles that
    lie apart the height stays level without samples.
    """
    spacing = (road.end() - road.start) / points if not isinstance(road, jn.Train) else road.of.profile().span / points
    reach = 0.5 * CONTACT_LENGTH + 2.0 * spacing
    distance = np.arange(road.start - reach, road.end() + reach, spacing)
    time = _time_at(distance, road, speed)
    height = _patch_mean(road, distance)
    ends = np.array([0.0, 0.5 * time[0]]), np.array([0.5 * (time[-1] + duration), duration])
    return jn.Excitation(
        time=np.concatenate([ends[0], time, ends[1]]), height=np.concatenate([np.zeros(2), height, np.zeros(2)])
    )


def _patch_mean(road: jn.Road, distance: Array) -> Array:
    """Mean height over the contact patch, from the integral of the height on a fine grid."""
    grid = np.arange(distance[0] - CONTACT_LENGTH, distance[-1] + CONTACT_LENGTH, 5e-5)
    height = road.height_at(grid)
    area = np.concatenate([[0.0], np.cumsum(0.5 * (height[1:] + height[:-1]) * np.diff(grid))])
    half = 0.5 * CONTACT_LENGTH
    gained = np.interp(distance + half, grid, area) - np.interp(distance - half, grid, area)
    return np.asarray(gained / CONTACT_LENGTH, dtype=float)


def _time_at(distance: Array, road: jn.Road, speed: float) -> Array:
    """Time at which the belt has moved by ``distance``: each foot of an obstacle takes a share of the speed.

    The missing speed decays exponentially in time; over the few centimetres concerned, time is distance over speed.
    """
    feet = [road.start] if not isinstance(road, jn.Train) else [road.start + i * road.pitch for i in range(road.count)]
    missing = np.zeros_like(distance)
    for foot in feet:
        since = np.maximum(distance - foot, 0.0) / speed
        missing += np.where(since > 0.0, SPEED_DROP * np.exp(-since / SPEED_RECOVERY), 0.0)
    slowness = 1.0 / (speed * (1.0 - missing))
    steps = 0.5 * (slowness[1:] + slowness[:-1]) * np.diff(distance)
    return np.asarray(distance[0] / speed + np.concatenate([[0.0], np.cumsum(steps)]), dtype=float)


@dataclass(frozen=True)
class BenchPlan:
    """What is measured: cycles of the spring, and of the tyre at each pressure (Pa), free decays, obstacle passes.

    ``duration`` is that of each recording (s), ``sample_rate`` that of decays and passes (Hz), ``seed`` that of all
    scatter and noise.
    """

    spring_trials: int = 5
    tyre_trials: int = 3
    decays: int = 4
    pressures: tuple[float, ...] = (310e3, 250e3)
    trials: tuple[Table2Row, ...] = field(default_factory=table2)
    duration: float = 3.0
    sample_rate: float = 1000.0
    seed: int = 2008


@dataclass(frozen=True)
class TruePass:
    """What a pass really was: speed (m/s) behind its printed two decimals, and how late its recording started (s)."""

    speed: float
    lag: float


def make_measurements(
    folder: Path | str,
    plan: BenchPlan | None = None,
    *,
    force: bool = False,
    progress: Progress = no_progress,
) -> list[Path]:
    """Write the measurement files of a campaign below a folder: ``bench/``, ``trials/`` and ``truth.toml``.

    The default plan is everything that the paper did: five spring trials of 15 mm, three tyre trials of 10 mm at each
    of two pressures, free decays, and the sixteen obstacle passes of its Table 2, 3 s each at 1 kHz. The files are CSV
    with ``name [unit]`` headers under a first line that says they are synthetic. Where one exists nothing is written,
    unless ``force`` allows it.

    Examples
    --------
    >>> import tempfile
    >>> plan = BenchPlan(spring_trials=1, tyre_trials=0, decays=0, trials=())
    >>> [file.name for file in make_measurements(tempfile.mkdtemp(), plan)]
    ['spring_1.csv', 'truth.toml']
    """
    plan = plan or BenchPlan()
    texts = measurement_texts(plan, progress=progress)
    return jn.write_files(folder, {**texts, "truth.toml": truth_text(plan)}, force=force)


def measurement_texts(plan: BenchPlan, *, progress: Progress = no_progress) -> dict[str, str]:
    """Give the measurement files of a plan: name below the campaign's folder to text."""
    progress("virtual bench: spring and tyre on the test machine")
    texts = _springs(plan) | _tyres(plan)
    progress("virtual bench: free decays")
    texts |= _decays(plan)
    for row in plan.trials:
        progress(f"virtual bench: trial {row.number}")
        texts[f"trials/{row.number:02d}.csv"] = _pass(row, plan)
    return texts


def course(row: Table2Row, *, shift: float = 0.0) -> jn.Road:
    """Give the obstacle course of a trial, ``shift`` (m) later than planned."""
    obstacle = jn.HalfSine(**{**_OBSTACLE, "start": _OBSTACLE["start"] + shift})
    if row.pitch is None:
        return obstacle
    return jn.Train(of=obstacle, count=_OBSTACLES_IN_TRAIN, pitch=row.pitch)


def true_pass(row: Table2Row, seed: int = BenchPlan.seed) -> TruePass:
    """Give what the bench hides: the speed that rounds to the printed one, and the lag of the recording."""
    generator = _generator(seed, f"pass {row.number}")
    speed = row.speed + generator.uniform(-0.005, 0.005)
    return TruePass(round(speed, 5), round(generator.uniform(-0.6e-3, 0.6e-3), 6))


def _pass(row: Table2Row, plan: BenchPlan) -> str:
    truth = true_pass(row, plan.seed)
    road = course(row, shift=truth.speed * truth.lag)
    trial = jn.Trial(excitation=wheel_path(road, truth.speed, plan.duration), duration=plan.duration)
    run = jn.simulate(true_rig(row.strut_angle, row.tyre_pressure), trial, output_step=1.0 / plan.sample_rate)
    seed = zlib.crc32(f"{plan.seed} sensors {row.number}".encode())
    recorded = jn.apply_sensors(run, SENSORS, seed=seed)
    columns = {f"{name} [m/s^2]": (recorded[name].to_numpy(), 4) for name in SENSORS}
    return _csv({"time [s]": (run["time"].to_numpy(), 5), **columns})


def _springs(plan: BenchPlan) -> dict[str, str]:
    texts = {}
    for i in range(1, plan.spring_trials + 1):
        generator = _generator(plan.seed, f"spring {i}")
        rate = SPRING_RATE * (1.0 + 0.002 * generator.standard_normal())
        cycle = spring_cycle(0.015, 151, rate)
        texts[f"bench/spring_{i}.csv"] = _cycle(*cycle, generator)
    return texts


def _tyres(plan: BenchPlan) -> dict[str, str]:
    texts = {}
    for pressure in plan.pressures:
        label = f"{round(pressure / 1e4):03d}"
        for i in range(1, plan.tyre_trials + 1):
            generator = _generator(plan.seed, f"tyre {label} {i}")
            scale = 1.0 + 0.006 * generator.standard_normal()
            texts[f"bench/tyre_{label}_{i}.csv"] = _cycle(*tyre_cycle(0.010, 201, pressure, scale), generator)
    return texts


def _cycle(deflection: Array, force: Array, generator: np.random.Generator) -> str:
    zero = generator.uniform(1e-3, 4e-3)
    moved = deflection + zero + 2e-6 * generator.standard_normal(len(deflection))
    felt = force + 0.5 * generator.standard_normal(len(force))
    return _csv({"displacement [mm]": (1e3 * moved, 4), "force [N]": (felt, 2)})


def _decays(plan: BenchPlan) -> dict[str, str]:
    """Lay weights on the sprung mass, take them off at once, record its height above rest."""
    texts = {}
    trial = jn.Trial(
        road=jn.HalfSine(**{**_OBSTACLE, "start": 100.0}), speed=1.0, duration=2.0
    )  # far away: level ground
    rig = true_rig()
    at_rest = jn.linearise(rig).equilibrium
    for i in range(1, plan.decays + 1):
        generator = _generator(plan.seed, f"decay {i}")
        laden = rig.with_changes({"sprung.mass": SPRUNG_MASS + _WEIGHT * (8.0 + i)})
        pressed = jn.linearise(laden).equilibrium
        offset = {name: value - at_rest[name] for name, value in pressed.items() if value != at_rest[name]}
        run = jn.simulate(rig, trial, output_step=1.0 / plan.sample_rate, offset=offset)
        height = run["sprung.z"].to_numpy()
        noisy = (
            1e3 * (height - height[-1]) + 0.02 * generator.standard_normal(len(height)) + generator.uniform(-1.0, 1.0)
        )
        texts[f"bench/decay_{i}.csv"] = _csv({"time [s]": (run["time"].to_numpy(), 5), "sprung.z [mm]": (noisy, 4)})
    return texts


def _csv(columns: dict[str, tuple[Array, int]]) -> str:
    """Text of a file: header to (values, decimals)."""
    rows = zip(*(np.char.mod(f"%.{digits}f", values) for values, digits in columns.values()), strict=True)
    return "\n".join([f"# {SYNTHETIC}", ", ".join(columns), *map(",".join, rows)]) + "\n"


def _generator(seed: int, name: str) -> np.random.Generator:
    """Random numbers that depend on the seed and the name only."""
    return np.random.default_rng([seed, zlib.crc32(name.encode())])


def truth_text(plan: BenchPlan) -> str:
    """Give the values behind a plan's files as TOML, SI."""
    import tomlkit

    document = tomlkit.document()
    document.add(tomlkit.comment(SYNTHETIC))
    document.add(tomlkit.comment("The values behind the files, SI. A campaign is not told them."))
    for name, value in _values().items():
        document.add(name, tomlkit.item(value))
    passes = tomlkit.table(is_super_table=True)
    for row in plan.trials:
        truth = true_pass(row, plan.seed)
        angle = round(math.degrees(row.strut_angle), 6)
        entry = {"speed": truth.speed, "lag": truth.lag, "strut_angle_deg": angle, "tyre_pressure": row.tyre_pressure}
        passes.add(str(row.number), tomlkit.item(entry))
    document.add("trial", passes)
    return tomlkit.dumps(document)


def _values() -> dict[str, object]:
    return {
        "rig": RIG,
        "sprung_mass": SPRUNG_MASS,
        "upright_mass": UPRIGHT_MASS,
        "spring_rate": SPRING_RATE,
        "damper": {"velocity": list(DAMPER_VELOCITY), "force": list(DAMPER_FORCE)},
        "friction": {
            "strut": STRUT_FRICTION,
            "guide": GUIDE_FRICTION,
            "regularisation_velocity": REGULARISATION_VELOCITY,
        },
        "tyre": {
            "coefficients": {f"{pressure / 1e6:g} MPa": list(values) for pressure, values in TYRE_CURVES.items()},
            "damping_coefficient": TYRE_DAMPING,
            "contact_length": CONTACT_LENGTH,
            "settling_on_the_test_machine": {"distance": SETTLING[0], "force": SETTLING[1]},
            "loss_share_when_unloading": TYRE_LOSS,
        },
        "belt": {"speed_share_taken_by_an_obstacle": SPEED_DROP, "recovery_time": SPEED_RECOVERY},
        "sensors": {
            name: {key: value for key, value in sensor.model_dump(exclude_none=True).items() if key != "orientation"}
            for name, sensor in SENSORS.items()
        },
    }
