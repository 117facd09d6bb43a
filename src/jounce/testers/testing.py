"""Simulated shock absorber tests: records in the format of a tester, with true values."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.errors import SimulationError
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.seeds import check_seed
from jounce.core.text import quote
from jounce.core.types import Array
from jounce.core.writing import write_atomically
from jounce.parts.rig import Rig
from jounce.parts.testers import Tester, as_tester
from jounce.parts.vehicles import FrontViewAxle, FullCar, HalfCar4DOF, axle_of
from jounce.recordings.files import write_recording
from jounce.recordings.schema import recording_of
from jounce.testers.programme import Other, ProgrammeRun, Wheel, run_programme
from jounce.testers.rig import channel, rig_on_tester

if TYPE_CHECKING:
    import xarray as xr


@dataclass(frozen=True)
class Sensors:
    """Effects of a tester's sensors on the signals.

    Attributes
    ----------
    displacement_noise : float
        Standard deviation of the displacement noise, m.
    force_offset : float
        Offset added to the force, N.
    force_limit : float or None
        Range of the force cells, N; larger values are clipped.
    tacho : bool
        Whether the rotation of the exciter is recorded (``<wheel>.plate.frequency``, Hz).
    """

    displacement_noise: float = 0.0
    force_offset: float = 0.0
    force_limit: float | None = None
    tacho: bool = False

    def __post_init__(self) -> None:
        for name, unit in (("displacement_noise", "m"), ("force_limit", "N")):
            _refuse_below_zero(name, getattr(self, name), unit)


def _refuse_below_zero(name: str, value: float | None, unit: str) -> None:
    if value is not None and not (np.isfinite(value) and value >= 0.0):
        raise SimulationError(
            "out of range", where=name, found=value, allowed=Phrase("0 {unit} or more", unit=unit)
        )


def simulate_test(
    rig: Rig,
    tester: Tester | str | Path,
    *,
    wheel: Wheel = "both",
    other: Other = "still",
    noise: float = 0.0,
    seed: int = 0,
    sensors: Sensors | None = None,
    truth: bool = True,
    about: Mapping[str, object] | None = None,
) -> xr.Dataset:
    """Simulate the test of a wheel or an axle and return a record like a measured one.

    Parameters
    ----------
    rig : QuarterCar, Corner, FrontViewAxle, FullCar or HalfCar4DOF
        Rig on the plates; for a vehicle, the axle named in ``about``, by default the front axle.
    tester : Tester, str or Path
        Plates, programme and sampling; also by name or file.
    wheel : {"both", "left", "right"}
        Tested wheels of an axle, left first; for a single wheel its plate, left for ``"both"``.
    other : {"still", "excited"}
        Motion of the axle's other plate during the test.
    noise : float
        Standard deviation of the force noise relative to the static load (1).
    seed : int
        Seed of the noise.
    sensors : Sensors, optional
        Other effects of the sensors.
    truth : bool
        Whether to add quantities that testers cannot measure, as channels with the prefix ``truth.``.
    about : mapping, optional
        Additional attributes of the record: ``axle`` (default ``"front"``), ``vehicle``, ``date``, ...

    Returns
    -------
    xarray.Dataset
        ``<wheel>.plate.z`` (m, up, zero at rest) and ``<wheel>.plate.force`` (N, compression positive) on ``time``
        (s). Attributes: ``<wheel>.static_load`` (N), ``<wheel>.plate_mass`` (kg), ``tester``, ``axle``,
        ``wheel_order``, ``simulated`` (printed across the page of reports), and the entries of ``about``.

    Raises
    ------
    SimulationError
        If the rig cannot be placed on a tester, has no equilibrium, or the run fails.
    DescriptionError
        For an unknown wheel.

    Examples
    --------
    >>> from jounce.parts import load
    >>> from jounce.parts.testers import load_tester
    >>> record = simulate_test(load("audi-a6-quarter-car"), load_tester("eusama"))
    >>> adhesion = float(record["truth.left.tyre.force"].min()) / record.attrs["left.static_load"]
    >>> 0.7 < adhesion < 0.8
    True
    """
    tester = as_tester(tester)
    _refuse_below_zero("noise", noise, "of the static load")
    facts = {"axle": "front", **(about or {})}
    if isinstance(rig, (FullCar, HalfCar4DOF)):
        rig = axle_of(rig, facts["axle"])  # type: ignore[arg-type]  # it rejects other names
    run = run_programme(rig, tester, wheel=wheel, other=other)
    single: str = "left" if wheel == "both" else wheel
    sides = {"left": "left", "right": "right"} if isinstance(rig, FrontViewAxle) else {single: ""}
    check_seed(seed)
    generator = np.random.default_rng(seed)
    channels: dict[str, tuple[Array, str, str]] = {}
    order = wheel if wheel in sides else ", ".join(sides)
    attributes: dict[str, object] = {
        "tester": tester.name,
        "wheel_order": order if len(sides) == 1 or other == "still" else "together",
        "comment": f"simulated, seed {seed}",
        "simulated": f"jounce {metadata.version('jounce')}, seed {seed}",
        **facts,
    }
    for side, place in sides.items():
        static = run.static[channel(place, "tyre.force")]
        attributes[f"{side}.static_load"], attributes[f"{side}.plate_mass"] = (
            static,
            tester.plate_mass,
        )
        channels.update(
            _measure(run, tester, side, place, sensors or Sensors(), (generator, noise))
        )
    if truth:
        channels.update(_truth(run, sides))
    return recording_of(run.time, channels, attributes=attributes)


def _measure(
    run: ProgrammeRun,
    tester: Tester,
    side: str,
    place: str,
    sensors: Sensors,
    noise: tuple[np.random.Generator, float],
) -> dict[str, tuple[Array, str, str]]:
    """Return the readings of one side; ``noise`` is the generator and its standard deviation over static load."""
    cell = "plate.force" if tester.force_cell == "under-plate" else "tyre.force"
    static = run.static[channel(place, "tyre.force")]
    height = run.values[channel(place, "plate.z")] - run.static[channel(place, "plate.z")]
    generator, share = noise
    force = _noisy(
        run.values[channel(place, cell)] + sensors.force_offset, share * static, generator
    )
    if sensors.force_limit is not None:
        force = np.clip(force, -sensors.force_limit, sensors.force_limit)
    height = _noisy(height, sensors.displacement_noise, generator)
    result = {
        f"{side}.plate.z": (height, "m", f"{side} plate, height over rest"),
        f"{side}.plate.force": (force, "N", f"{side} plate, force, compression positive"),
    }
    if sensors.tacho:
        turns = run.values[channel(place, "excenter.frequency")]
        result[f"{side}.plate.frequency"] = (
            turns,
            "Hz",
            f"{side} plate, turns of the exciter per second",
        )
    return result


def _noisy(values: Array, size: float, generator: np.random.Generator) -> Array:
    return (
        values
        if size <= 0.0
        else np.asarray(values + size * generator.standard_normal(len(values)))
    )


def _truth(run: ProgrammeRun, sides: Mapping[str, str]) -> dict[str, tuple[Array, str, str]]:
    """Return all outputs of the model, with the wheel's side in the name."""
    single = next(iter(sides)) if "" in sides.values() else ""
    return {
        f"truth.{channel(single, output.name)}": (
            run.values[output.name],
            output.unit,
            f"{output.long_name} (truth)",
        )
        for output in run.outputs
    }


def write_test(record: xr.Dataset, path: Path | str, *, force: bool = False) -> Path:
    """Write a record as a test lane does: ``.csv`` with a header about the car, or ``.nc``.

    Parameters
    ----------
    record : xarray.Dataset
        Record from :func:`simulate_test`; plate heights are written in mm.
    path : Path or str
        File with the suffix ``.csv`` or ``.nc``.
    force : bool
        Whether to overwrite an existing file.

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    OutputError
        For an existing file without ``force``, a missing folder, or a different suffix.
    """
    if Path(path).suffix.lower() != ".csv":
        return write_recording(record, path, force=force)
    units = {"m": ("mm", 1e3)}
    columns, header = [record["time"].values], ["time [s]"]
    for name, signal in record.data_vars.items():
        unit, factor = units.get(signal.attrs["units"], (signal.attrs["units"], 1.0))
        columns.append(factor * signal.values)
        header.append(f"{name} [{unit}]")
    facts = [f"# {key} = {_quote(str(key), value)}" for key, value in record.attrs.items()]
    rows = [",".join(f"{value:.10g}" for value in row) for row in np.column_stack(columns)]
    return write_atomically(
        Path(path), "\n".join([*facts, ",".join(header), *rows]) + "\n", force=force
    )


def _quote(key: str, value: object) -> str:
    unit = {"static_load": " N", "plate_mass": " kg"}.get(key.rpartition(".")[2], "")
    return quote(f"{value}{unit}")


def findings_of_test(rig: Rig, tester: Tester) -> list[Finding]:
    """Report limitations of a test of this rig on this tester.

    Covers wheel loads (N) out of range, sweeps that are too fast or short, and sample rates that are too low.
    """
    on, limits, programme = rig_on_tester(rig, tester), tester.limits, tester.programme
    findings = []
    for place in on.places:
        load = on.static_load(place)
        if not limits.wheel_load_min <= load <= limits.wheel_load_max:
            findings.append(
                finding(
                    "testers.wheel_load",
                    channel(place, "static_load"),
                    load,
                    load=load,
                    wheel_load_min=limits.wheel_load_min,
                    wheel_load_max=limits.wheel_load_max,
                )
            )
    if programme.run_down == "controlled":
        if programme.sweep_rate > limits.sweep_rate_max:
            findings.append(
                finding(
                    "testers.sweep_fast",
                    "programme.sweep_rate",
                    programme.sweep_rate,
                    sweep_rate=programme.sweep_rate,
                    sweep_rate_max=limits.sweep_rate_max,
                )
            )
        swept = abs(programme.start_frequency - programme.end_frequency) / programme.sweep_rate
        if swept < limits.sweep_time_min:
            findings.append(
                finding(
                    "testers.sweep_short",
                    "programme.sweep_rate",
                    swept,
                    duration=swept,
                    sweep_time_min=limits.sweep_time_min,
                )
            )
    if tester.sampling_frequency < limits.sampling_frequency_min:
        findings.append(
            finding(
                "testers.sampling_slow",
                "sampling_frequency",
                tester.sampling_frequency,
                sampling_frequency=tester.sampling_frequency,
                sampling_frequency_min=limits.sampling_frequency_min,
            )
        )
    return findings
