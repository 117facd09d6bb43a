"""The virtual bench: simulate all measurement files of a campaign from a model with known values.

It writes the files of a laboratory: force over deflection of spring and tyre, free decays, and obstacle passes
recorded by accelerometers. The same truth, plan and seed always give the same files; ``truth.toml`` next to them
contains the true values.

The paper's recordings were not published; the bench replaces its laboratory. It is described by a
:class:`~jounce.campaign.truth.BenchTruth`: a rig with its laws, the rolling and the standing tyre, the belt and the
sensors. The shipped campaigns include theirs as ``truth.toml``; a different one can be passed.
"""

from __future__ import annotations

import zlib
from dataclasses import dataclass, field
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np

import jounce as jn
from jounce.papers import Array, Counted, Progress, no_progress
from jounce.papers.table2 import Table2Row, table2

SYNTHETIC = "Synthetic: made by jounce's virtual bench from a richer model (truth.toml); not a laboratory record."
_OBSTACLES_IN_TRAIN = 5  # number of obstacles in the paper's profile B
_WEIGHT = 2.5  # kg; weights on the sprung mass before a free decay
_LEVEL = 24
"""Number of samples of level belt next to an obstacle at which the error of a spline is below a nanometre."""


@dataclass(frozen=True)
class BenchPlan:
    """Plan of the measurements: spring cycles, tyre cycles at each pressure (Pa), free decays and obstacle passes.

    ``duration`` is the length of each recording (s), ``sample_rate`` that of decays and passes (Hz), ``seed`` the seed
    of all scatter and noise.
    """

    spring_trials: int = 5
    tyre_trials: int = 3
    decays: int = 4
    pressures: tuple[float, ...] = (310e3, 250e3)
    trials: tuple[Table2Row, ...] = field(default_factory=table2)
    duration: float = 3.0
    sample_rate: float = 1000.0
    seed: int = 2008


def campaign_texts() -> dict[str, str]:
    """Return the description files of the shipped campaign, the kart-scale prototype: file name to text.

    Examples
    --------
    >>> sorted(campaign_texts())
    ['campaign.toml', 'quarter-car.toml', 'quick-look.toml', 'rig.toml']
    """
    folder = resources.files("jounce") / "library" / "campaigns" / "kart-prototype"
    return {
        file.name: file.read_text(encoding="utf-8") for file in folder.iterdir() if file.is_file()
    }


def shipped_truth() -> jn.BenchTruth:
    """Return the truth behind the virtual bench of the shipped campaign.

    Examples
    --------
    >>> shipped_truth().true_rig().guide_friction.force
    9.0
    """
    return jn.load_truth("kart-prototype")


@dataclass(frozen=True)
class SimulatedPass:
    """True values of a pass: exact speed (m/s), and delay of its recording (s)."""

    speed: float
    lag: float


def virtual_bench(
    folder: Path | str,
    truth: jn.BenchTruth | Path | str | None = None,
    *,
    changes: dict[str, Any] | None = None,
    seed: int = BenchPlan.seed,
    duration: float = BenchPlan.duration,
    force: bool = False,
    progress: Progress = no_progress,
) -> Path:
    """Simulate the recordings of a bench with known truth, and write them with the shipped campaign.

    The measurements are those of the quarter-car prototype paper: five spring trials of 15 mm, three tyre trials of
    10 mm at each of two pressures, free decays, and the sixteen obstacle passes of its Table 2 at 1 kHz.

    Parameters
    ----------
    folder : Path or str
        Folder; created if missing.
    truth : BenchTruth, Path, str or None
        True values of the bench: a description, its file, or a shipped name (``"kart-low-friction"``); None means
        ``"kart-prototype"``.
    changes : dict or None
        Changed values by path, in the truth (``"belt.speed_drop"``) or its rig (``"rig.strut.friction.force"``); whole
        elements can be replaced, e.g. ``{"rig.strut.damper": {"coefficient": "104 N*s/m"}}``.
    seed : int
        Seed of all scatter and noise, including differences between passes; 0 or more.
    duration : float
        Length of each recording, s.
    force : bool
        Overwrite existing files.
    progress : callable
        Called with one line of text at each step of the work.

    Returns
    -------
    Path
        The new ``campaign.toml``, for :func:`jounce.run_campaign`. Next to it are ``quick-look.toml`` (the same with a
        quarter car), their rigs, ``bench/`` and ``trials/`` as CSV with ``name [unit]`` headers below a line that marks
        them as synthetic, and ``truth.toml``, which reproduces the files with the same seed.

    Raises
    ------
    DescriptionError
        For an invalid truth, and a duration too short to pass all obstacles.
    OutputError
        If one of the files exists, without ``force``; nothing is written then.

    Examples
    --------
    >>> import tempfile
    >>> file = virtual_bench(tempfile.mkdtemp(), changes={"rig.strut.friction.force": 0.0}, seed=7, duration=1.0)
    >>> jn.load_truth(file.with_name("truth.toml")).true_rig().strut.friction.force
    0.0
    """
    given_seed: object = seed
    if isinstance(given_seed, bool) or not isinstance(given_seed, int) or seed < 0:
        raise jn.DescriptionError(
            "invalid seed", where="seed", found=seed, allowed="an integer of 0 or more"
        )
    given = (
        shipped_truth()
        if truth is None
        else jn.load_truth(truth)
        if isinstance(truth, (str, Path))
        else truth
    )
    real = given.with_changes(changes) if changes else given
    plan = BenchPlan(seed=seed, duration=duration)
    measured = measurement_texts(plan, real, progress=progress)
    texts = {**campaign_texts(), **measured, "truth.toml": truth_text(plan, real)}
    jn.write_files(folder, texts, force=force)
    return Path(folder) / "campaign.toml"


def make_measurements(
    folder: Path | str,
    plan: BenchPlan | None = None,
    truth: jn.BenchTruth | None = None,
    *,
    force: bool = False,
    progress: Progress = no_progress,
) -> list[Path]:
    """Write the measurement files of a plan below a folder: ``bench/``, ``trials/`` and ``truth.toml``.

    If one exists, nothing is written unless ``force`` is set.

    Examples
    --------
    >>> import tempfile
    >>> plan = BenchPlan(spring_trials=1, tyre_trials=0, decays=0, trials=())
    >>> [file.name for file in make_measurements(tempfile.mkdtemp(), plan)]
    ['spring_1.csv', 'truth.toml']
    """
    plan, truth = plan or BenchPlan(), truth or shipped_truth()
    texts = measurement_texts(plan, truth, progress=progress)
    return jn.write_files(folder, {**texts, "truth.toml": truth_text(plan, truth)}, force=force)


def measurement_texts(
    plan: BenchPlan, truth: jn.BenchTruth | None = None, *, progress: Progress = no_progress
) -> dict[str, str]:
    """Return the texts of a plan's measurement files, by name relative to the campaign's folder."""
    truth = truth or shipped_truth()
    progress("virtual bench: spring and tyre on the test machine")
    texts = _springs(plan, truth) | _tyres(plan, truth)
    progress("virtual bench: free decays")
    texts |= _decays(plan, truth)
    for k, row in enumerate(plan.trials, 1):
        progress(Counted("virtual bench, trial", k, len(plan.trials), row.number))
        texts[f"trials/{row.number:02d}.csv"] = _pass(row, plan, truth)
    return texts


def spring_cycle(stroke: float, points: int, rate: float, friction: float) -> tuple[Array, Array]:
    """Simulate loading spring and strut to a ``stroke`` (m) and unloading: return deflections (m) and forces (N).

    The load cell was zeroed with the strut sliding. Therefore its ``friction`` (N) appears as a drop of twice its force
    during unloading; ``rate`` is that of the spring (N/m).
    """
    deflection, direction = _triangle(stroke, points)
    reversed_friction = 2.0 * friction * (1.0 - np.exp(-(stroke - deflection) / 0.1e-3))
    return deflection, rate * deflection - np.where(direction > 0.0, 0.0, reversed_friction)


def tyre_cycle(
    stroke: float, points: int, pressure: float, scale: float, truth: jn.BenchTruth | None = None
) -> tuple[Array, Array]:
    """Simulate loading the standing tyre to a ``stroke`` (m) and unloading: return deflections (m) and forces (N).

    The deflection is measured by the machine and includes settling: the standing tyre is softer than the rolling one at
    first, and has less force during unloading. ``scale`` is the ratio of this trial's stiffness to the true curve at
    the ``pressure`` (Pa).
    """
    truth = truth or shipped_truth()
    standing = truth.standing_tyre
    deflection, direction = _triangle(stroke, points)
    tyre = np.linspace(0.0, stroke, 4001)
    force = scale * np.polyval([*reversed(_tyre_coefficients(truth, pressure)), 0.0], tyre)
    machine = tyre + standing.settling * (1.0 - np.exp(-force / standing.settling_force))
    loading = np.interp(deflection, machine, force)
    lost = np.where(direction > 0.0, 0.0, standing.loss * (1.0 - (deflection / stroke) ** 4))
    return deflection, loading * (1.0 - lost)


def _tyre_coefficients(truth: jn.BenchTruth, pressure: float) -> tuple[float, ...]:
    """Coefficients of the tyre's force over deflection, from the truth's curve or from the rig's tyre."""
    curve = truth.curve_at(pressure)
    if curve is not None:
        return curve
    tyre = truth.true_rig(pressure).tyre
    if tyre.stiffness is not None:
        return (tyre.stiffness,)
    if tyre.curve is None or tyre.curve.kind != "polynomial":
        raise jn.DescriptionError(
            "the test machine needs a stiffness or a polynomial of the tyre",
            where=f"tyre at {pressure:g} Pa",
            hint="Give the coefficients of the tyre under [tyre].",
        )
    coefficients: tuple[float, ...] = tyre.curve.coefficients
    return coefficients


def _triangle(stroke: float, points: int) -> tuple[Array, Array]:
    """Deflections of loading and unloading, and +1 or -1 for the direction."""
    up = np.linspace(0.0, stroke, points)
    return np.concatenate([up, up[-2::-1]]), np.concatenate([np.ones(points), -np.ones(points - 1)])


def wheel_path(
    road: jn.Road,
    speed: float,
    duration: float,
    truth: jn.BenchTruth | None = None,
    *,
    points: int = 60,
) -> jn.Excitation:
    """Return the true height (m) below the wheel over time (s) while the belt carries obstacles past it.

    It is the mean height over the contact patch, which begins half a patch before the foot of the obstacle, at the
    distance travelled by the slowed belt. ``speed`` (m/s) is the speed before the first obstacle. Each obstacle has
    ``points`` samples; before the first and after the last the belt is level.
    """
    belt = (truth or shipped_truth()).belt
    single = road.of if isinstance(road, jn.Train) else road
    spacing = single.profile().span / points
    reach = 0.5 * belt.contact_length + _LEVEL * spacing
    distance = np.arange(road.start - reach, road.end() + reach, spacing)
    if distance[0] <= 0.0:
        raise jn.DescriptionError(
            "the obstacle begins too early",
            where="obstacle.start",
            found=f"{road.start:.4g} m",
            allowed=f"{reach:.4g} m",
        )
    time = _time_at(distance, road, speed, belt)
    if time[-1] >= duration:
        raise jn.DescriptionError(
            "the recording ends before the obstacles are passed",
            where="duration",
            found=f"{duration:g} s",
            allowed=f"above {time[-1]:.3g} s",
        )
    height = _patch_mean(road, distance, belt.contact_length)
    ends = np.array([0.0, 0.5 * time[0]]), np.array([0.5 * (time[-1] + duration), duration])
    return jn.Excitation(
        time=np.concatenate([ends[0], time, ends[1]]),
        height=np.concatenate([np.zeros(2), height, np.zeros(2)]),
        # A cubic needs several samples on the ramps into which the contact patch turns edges.
        interpolation="cubic" if belt.contact_length > 4.0 * spacing else "linear",
    )


def _patch_mean(road: jn.Road, distance: Array, length: float) -> Array:
    """Mean height over a contact patch, from the height integrated on a fine grid."""
    if length == 0.0:
        return np.asarray(road.height_at(distance), dtype=float)
    grid = np.arange(distance[0] - length, distance[-1] + length, min(5e-5, 0.05 * length))
    height = road.height_at(grid)
    area = np.concatenate([[0.0], np.cumsum(0.5 * (height[1:] + height[:-1]) * np.diff(grid))])
    gained = np.interp(distance + 0.5 * length, grid, area) - np.interp(
        distance - 0.5 * length, grid, area
    )
    return np.asarray(gained / length, dtype=float)


def _time_at(distance: Array, road: jn.Road, speed: float, belt: Any) -> Array:
    """Time at which the belt has moved by ``distance``: each foot of an obstacle reduces the speed by a fraction.

    The speed loss decays exponentially in time, which is approximated by distance over speed for these short distances.
    """
    feet = (
        [road.start]
        if not isinstance(road, jn.Train)
        else [road.start + i * road.pitch for i in range(road.count)]
    )
    missing = np.zeros_like(distance)
    for foot in feet:
        since = np.maximum(distance - foot, 0.0) / speed
        missing += np.where(since > 0.0, belt.speed_drop * np.exp(-since / belt.recovery_time), 0.0)
    slowness = 1.0 / (speed * (1.0 - missing))
    steps = 0.5 * (slowness[1:] + slowness[:-1]) * np.diff(distance)
    return np.asarray(distance[0] / speed + np.concatenate([[0.0], np.cumsum(steps)]), dtype=float)


def course(row: Table2Row, truth: jn.BenchTruth | None = None, *, shift: float = 0.0) -> jn.Road:
    """Return the obstacle course of a trial, ``shift`` (m) later than planned."""
    given = (truth or shipped_truth()).obstacle
    obstacle = given.model_copy(update={"start": given.start + shift})
    if row.pitch is None:
        return obstacle
    return jn.Train(of=obstacle, count=_OBSTACLES_IN_TRAIN, pitch=row.pitch)


def true_pass(
    row: Table2Row, seed: int = BenchPlan.seed, truth: jn.BenchTruth | None = None
) -> SimulatedPass:
    """Return the true values of a pass: the exact speed, which rounds to the printed one, and the recording's delay."""
    truth = truth or shipped_truth()
    stated = truth.passes.get(str(row.number))
    if stated is not None:
        return SimulatedPass(stated.speed, stated.lag)
    generator = _generator(seed, f"pass {row.number}")
    speed = row.speed + generator.uniform(-1.0, 1.0) * truth.belt.speed_error
    return SimulatedPass(round(speed, 5), round(generator.uniform(-1.0, 1.0) * truth.belt.lag, 6))


def _pass(row: Table2Row, plan: BenchPlan, truth: jn.BenchTruth) -> str:
    real = true_pass(row, plan.seed, truth)
    road = course(row, truth, shift=real.speed * real.lag)
    trial = jn.Trial(
        excitation=wheel_path(road, real.speed, plan.duration, truth), duration=plan.duration
    )
    rig = jn.with_strut_angle(truth.true_rig(row.tyre_pressure), row.strut_angle)
    run = jn.simulate(rig, trial, output_step=1.0 / plan.sample_rate)
    recorded = jn.apply_sensors(
        run, truth.sensors, seed=zlib.crc32(f"{plan.seed} sensors {row.number}".encode())
    )
    columns = {}
    for name in truth.sensors:
        unit = str(run[name].attrs["units"])
        columns[f"{name} [{unit}]"] = (recorded[name].to_numpy(), 4 if unit == "m/s^2" else 8)
    return _csv({"time [s]": (run["time"].to_numpy(), 5), **columns})


def _springs(plan: BenchPlan, truth: jn.BenchTruth) -> dict[str, str]:
    texts: dict[str, str] = {}
    strut = truth.true_rig().strut
    if not plan.spring_trials:
        return texts
    true_rate = strut.spring.rate
    if true_rate is None:
        raise jn.DescriptionError(
            "the test machine needs a spring rate", where="rig.strut.spring", allowed="rate"
        )
    friction = 0.0 if strut.friction is None else strut.friction.force
    for i in range(1, plan.spring_trials + 1):
        generator = _generator(plan.seed, f"spring {i}")
        rate = true_rate * (1.0 + 0.002 * generator.standard_normal())
        cycle = spring_cycle(0.015, 151, rate, friction)
        texts[f"bench/spring_{i}.csv"] = _cycle(*cycle, generator)
    return texts


def _tyres(plan: BenchPlan, truth: jn.BenchTruth) -> dict[str, str]:
    texts = {}
    for pressure in plan.pressures:
        label = f"{round(pressure / 1e4):03d}"
        for i in range(1, plan.tyre_trials + 1):
            generator = _generator(plan.seed, f"tyre {label} {i}")
            scale = 1.0 + 0.006 * generator.standard_normal()
            texts[f"bench/tyre_{label}_{i}.csv"] = _cycle(
                *tyre_cycle(0.010, 201, pressure, scale, truth), generator
            )
    return texts


def _cycle(deflection: Array, force: Array, generator: np.random.Generator) -> str:
    zero = generator.uniform(1e-3, 4e-3)
    moved = deflection + zero + 2e-6 * generator.standard_normal(len(deflection))
    felt = force + 0.5 * generator.standard_normal(len(force))
    return _csv({"displacement [mm]": (1e3 * moved, 4), "force [N]": (felt, 2)})


def _decays(plan: BenchPlan, truth: jn.BenchTruth) -> dict[str, str]:
    """Simulate free decays: load the sprung mass with weights, remove them suddenly, record its height above rest."""
    texts = {}
    level = jn.Trial(
        excitation=jn.Excitation(time=[0.0, 0.7, 1.4, 2.0], height=[0.0] * 4), duration=2.0
    )
    rig = truth.true_rig()
    if rig.sprung is None:
        raise jn.DescriptionError(
            "the bench needs a sprung mass",
            where="rig.sprung",
            allowed="a sprung mass and its guide",
        )
    at_rest = jn.linearise(rig).equilibrium
    for i in range(1, plan.decays + 1):
        generator = _generator(plan.seed, f"decay {i}")
        laden = rig.with_changes(
            {"sprung.mass": rig.parameters()["sprung.mass"] + _WEIGHT * (8.0 + i)}
        )
        pressed = jn.linearise(laden).equilibrium
        offset = {
            name: value - at_rest[name] for name, value in pressed.items() if value != at_rest[name]
        }
        run = jn.simulate(rig, level, output_step=1.0 / plan.sample_rate, offset=offset)
        height = run["sprung.z"].to_numpy()
        noisy = (
            1e3 * (height - height[-1])
            + 0.02 * generator.standard_normal(len(height))
            + generator.uniform(-1.0, 1.0)
        )
        texts[f"bench/decay_{i}.csv"] = _csv(
            {"time [s]": (run["time"].to_numpy(), 5), "sprung.z [mm]": (noisy, 4)}
        )
    return texts


def _csv(columns: dict[str, tuple[Array, int]]) -> str:
    """Text of a CSV file from columns: header to (values, decimals)."""
    rows = zip(
        *(np.char.mod(f"%.{digits}f", values) for values, digits in columns.values()), strict=True
    )
    return "\n".join([f"# {SYNTHETIC}", ",".join(columns), *map(",".join, rows)]) + "\n"


def _generator(seed: int, name: str) -> np.random.Generator:
    """Random generator that depends on the seed and the name only."""
    return np.random.default_rng([seed, zlib.crc32(name.encode())])


def truth_text(plan: BenchPlan, truth: jn.BenchTruth) -> str:
    """Return the true values of a plan's files as a truth file, SI, with the random values of each pass."""
    import tomlkit

    passes = {row.number: true_pass(row, plan.seed, truth) for row in plan.trials}
    known = {str(number): {"speed": real.speed, "lag": real.lag} for number, real in passes.items()}
    table = truth.model_dump(by_alias=True, exclude_none=True) | {"passes": known}
    document = tomlkit.document()
    document.add(tomlkit.comment(SYNTHETIC))
    document.add(
        tomlkit.comment(
            f"The values behind the files, SI; seed {plan.seed}. Campaigns do not read them."
        )
    )
    for name, value in table.items():
        document.add(name, tomlkit.item(value))
    return tomlkit.dumps(document)
