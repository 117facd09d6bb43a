"""Virtual bench: every measurement file of a campaign, made from a model with known values.

The same files a laboratory would give: force against deflection of spring and tyre, free decays, obstacle passes seen
through accelerometers. Deterministic: the same plan gives the same files. ``truth.toml`` beside them holds the values.
"""

from __future__ import annotations

import math
import zlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from jounce.core.serialise import write_files
from jounce.core.types import Array
from jounce.papers.table2 import Table2Row, table2
from jounce.papers.virtual_rig import (
    CONTACT_LENGTH,
    DAMPER_FORCE,
    DAMPER_VELOCITY,
    GUIDE_FRICTION,
    REGULARISATION_VELOCITY,
    RIG,
    SETTLING,
    SPEED_DROP,
    SPEED_RECOVERY,
    SPRING_RATE,
    SPRUNG_MASS,
    STRUT_FRICTION,
    SYNTHETIC,
    TYRE_CURVES,
    TYRE_DAMPING,
    TYRE_LOSS,
    UPRIGHT_MASS,
    spring_cycle,
    true_rig,
    tyre_cycle,
    wheel_path,
)
from jounce.recordings import Sensor, apply_sensors
from jounce.roads import HalfSine, Road, Train, Trial
from jounce.simulation import linearise, simulate

Progress = Callable[[str], None]

SENSORS: Mapping[str, Sensor] = {
    "sprung.az": Sensor(high_pass=0.5, low_pass=250.0, noise=0.15, bias=0.04, gain=1.01),
    "unsprung.az": Sensor(high_pass=0.5, low_pass=250.0, noise=0.8, bias=-0.15, gain=0.99),
}
_OBSTACLE = {"height": 0.010, "length": 0.060, "start": 0.2}
_OBSTACLES_IN_TRAIN = 5
_WEIGHT = 2.5  # kg; weights that press the sprung mass down before a free decay


@dataclass(frozen=True)
class BenchPlan:
    """What is measured.

    Attributes
    ----------
    spring_trials, tyre_trials, decays : int
        Number of test machine cycles of the spring, of the tyre at each pressure, and of free decays.
    pressures : tuple of float
        Tyre pressures on the test machine, Pa.
    trials : tuple of Table2Row
        Obstacle passes.
    duration : float
        Length of each recording, s.
    sample_rate : float
        Of decays and passes, Hz.
    seed : int
        Of all scatter and noise.
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
    progress: Progress | None = None,
) -> list[Path]:
    """Write the measurement files of a campaign.

    Parameters
    ----------
    folder : path
        Folder; ``bench/``, ``trials/`` and ``truth.toml`` are made in it.
    plan : BenchPlan, optional
        What is measured; by default everything the paper did: five spring trials of 15 mm, three tyre trials of 10 mm
        at each of two pressures, free decays, and the sixteen obstacle passes of its Table 2, 3 s each at 1 kHz.
    force : bool
        Overwrite existing files.
    progress : callable
        Called with one line of text as the work goes on.

    Returns
    -------
    list of Path
        The files, CSV with ``name [unit]`` headers under a first line that says they are synthetic.

    Raises
    ------
    OutputError
        For an existing file without ``force``; then nothing is written.

    Examples
    --------
    >>> import tempfile
    >>> plan = BenchPlan(spring_trials=1, tyre_trials=0, decays=0, trials=())
    >>> [file.name for file in make_measurements(tempfile.mkdtemp(), plan)]
    ['spring_1.csv', 'truth.toml']
    """
    plan = plan or BenchPlan()
    texts = measurement_texts(plan, progress=progress)
    return write_files(folder, {**texts, "truth.toml": truth_text(plan)}, force=force)


def measurement_texts(plan: BenchPlan, *, progress: Progress | None = None) -> dict[str, str]:
    """Give the measurement files of a plan: name below the campaign's folder to text."""
    report = progress or _silent
    report("virtual bench: spring and tyre on the test machine")
    texts = _springs(plan) | _tyres(plan)
    report("virtual bench: free decays")
    texts |= _decays(plan)
    for row in plan.trials:
        report(f"virtual bench: trial {row.number}")
        texts[f"trials/{row.number:02d}.csv"] = _pass(row, plan)
    return texts


def course(row: Table2Row, *, shift: float = 0.0) -> Road:
    """Give the obstacle course of a trial, ``shift`` (m) later than planned."""
    obstacle = HalfSine(**{**_OBSTACLE, "start": _OBSTACLE["start"] + shift})
    if row.pitch is None:
        return obstacle
    return Train(of=obstacle, count=_OBSTACLES_IN_TRAIN, pitch=row.pitch)


def true_pass(row: Table2Row, seed: int = BenchPlan.seed) -> TruePass:
    """Give what the bench hides: the speed that rounds to the printed one, and the lag of the recording."""
    generator = _generator(seed, f"pass {row.number}")
    speed = row.speed + generator.uniform(-0.005, 0.005)
    return TruePass(round(speed, 5), round(generator.uniform(-0.6e-3, 0.6e-3), 6))


def _pass(row: Table2Row, plan: BenchPlan) -> str:
    truth = true_pass(row, plan.seed)
    road = course(row, shift=truth.speed * truth.lag)
    trial = Trial(excitation=wheel_path(road, truth.speed, plan.duration), duration=plan.duration)
    run = simulate(true_rig(row.strut_angle, row.tyre_pressure), trial, output_step=1.0 / plan.sample_rate)
    seed = zlib.crc32(f"{plan.seed} sensors {row.number}".encode())
    recorded = apply_sensors(run, SENSORS, seed=seed)
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
    trial = Trial(road=HalfSine(**{**_OBSTACLE, "start": 100.0}), speed=1.0, duration=2.0)  # far away: level ground
    rig = true_rig()
    at_rest = linearise(rig).equilibrium
    for i in range(1, plan.decays + 1):
        generator = _generator(plan.seed, f"decay {i}")
        laden = rig.with_changes({"sprung.mass": SPRUNG_MASS + _WEIGHT * (8.0 + i)})
        pressed = linearise(laden).equilibrium
        offset = {name: value - at_rest[name] for name, value in pressed.items() if value != at_rest[name]}
        run = simulate(rig, trial, output_step=1.0 / plan.sample_rate, offset=offset)
        height = run["sprung.z"].to_numpy()
        noisy = (
            1e3 * (height - height[-1]) + 0.02 * generator.standard_normal(len(height)) + generator.uniform(-1.0, 1.0)
        )
        texts[f"bench/decay_{i}.csv"] = _csv({"time [s]": (run["time"].to_numpy(), 5), "sprung.z [mm]": (noisy, 4)})
    return texts


def _silent(text: str) -> None:
    """Take no notice."""


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
