"""Simulated tests of shock absorbers: records as a tester's computer writes them, with the truth beside them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import SimulationError
from jounce.core.findings import Finding
from jounce.parts.front_view import FrontViewAxle
from jounce.parts.rig import Rig
from jounce.parts.testers import Tester
from jounce.recordings.schema import recording
from jounce.simulation.courses import Course, Other, Wheel, run_course
from jounce.simulation.stand import channel, stand

if TYPE_CHECKING:
    import xarray as xr

Array = NDArray[np.float64]


def simulate_test(
    rig: Rig,
    tester: Tester,
    *,
    wheel: Wheel = "both",
    other: Other = "still",
    noise: float = 0.0,
    displacement_noise: float = 0.0,
    force_limit: float | None = None,
    seed: int = 0,
    truth: bool = True,
    about: Mapping[str, object] | None = None,
) -> xr.Dataset:
    """Simulate the test of a wheel or an axle; the result is a record like a measured one.

    Parameters
    ----------
    rig : QuarterCar, Corner or FrontViewAxle
        What stands on the plates (an axle of a vehicle: ``jounce.parts.front_view.axle_of``).
    tester : Tester
        Plates, programme, sampling.
    wheel : {"both", "left", "right"}
        Of an axle the wheels tested, left first; of a single wheel the plate that it stands on, left for ``"both"``.
    other : {"still", "excited"}
        What the other plate of an axle does in the meantime.
    noise : float
        Standard deviation of the force's noise, in shares of the static load (1).
    displacement_noise : float
        Of the plate's height, m.
    force_limit : float, optional
        Range of the force cells, N: what is beyond is clipped.
    seed : int
        Of the noise; equal seeds give equal records.
    truth : bool
        Whether what no tester measures comes along, as channels that begin with ``truth.``.
    about : mapping, optional
        Written into the record's attributes: ``axle`` (``"front"`` otherwise), ``vehicle``, ``date``, ...

    Returns
    -------
    xarray.Dataset
        ``<wheel>.plate.z`` (m, up, zero at rest), ``<wheel>.plate.force`` (N, compression positive) and
        ``<wheel>.plate.frequency`` (Hz) on ``time`` (s). Attributes: ``<wheel>.static_load`` (N),
        ``<wheel>.plate_mass`` (kg), ``tester``, ``axle``, ``wheel_order``, and what is said ``about`` it.

    Raises
    ------
    SimulationError
        For a rig that no tester takes, no equilibrium, or a run that does not reach its end.
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
    _check_sensors(noise, displacement_noise, force_limit)
    run = run_course(rig, tester, wheel=wheel, other=other)
    sides = {"left": "left", "right": "right"} if isinstance(rig, FrontViewAxle) else {_side(wheel): ""}
    sensors = _Sensors(np.random.default_rng(seed), noise, displacement_noise, force_limit)
    channels: dict[str, tuple[Array, str, str]] = {}
    attributes: dict[str, object] = {
        "tester": tester.name,
        "axle": "front",
        "wheel_order": ",".join(sides if wheel == "both" else [wheel] if wheel in sides else sides),
        "source": "simulated",
        "seed": seed,
        **(about or {}),
    }
    for side, place in sides.items():
        static = run.static[channel(place, "tyre.force")]
        attributes[f"{side}.static_load"], attributes[f"{side}.plate_mass"] = static, tester.plate_mass
        channels.update(_measured(run, tester, side, place, sensors))
    if truth:
        channels.update(_truth(run, sides))
    return recording(run.time, channels, attributes=attributes)


@dataclass(frozen=True)
class _Sensors:
    generator: np.random.Generator
    noise: float
    displacement_noise: float
    force_limit: float | None

    def force(self, values: Array, static: float) -> Array:
        """Force as read, N."""
        found = values
        if self.noise > 0.0:
            found = values + self.noise * static * self.generator.standard_normal(len(values))
        return found if self.force_limit is None else np.clip(found, -self.force_limit, self.force_limit)

    def height(self, values: Array) -> Array:
        """Height as read, m."""
        if self.displacement_noise <= 0.0:
            return values
        return np.asarray(values + self.displacement_noise * self.generator.standard_normal(len(values)))


def _measured(
    run: Course, tester: Tester, side: str, place: str, sensors: _Sensors
) -> dict[str, tuple[Array, str, str]]:
    """What the tester of one side reads."""
    cell = "plate.force" if tester.force_cell == "under-plate" else "tyre.force"
    static = run.static[channel(place, "tyre.force")]
    height = run.values[channel(place, "plate.z")] - run.static[channel(place, "plate.z")]
    force = run.values[channel(place, cell)]
    turns = run.values[channel(place, "excenter.frequency")]
    return {
        f"{side}.plate.z": (sensors.height(height), "m", f"{side} plate, height over rest"),
        f"{side}.plate.force": (sensors.force(force, static), "N", f"{side} plate, force, compression positive"),
        f"{side}.plate.frequency": (turns, "Hz", f"{side} plate, turns of the excenter per second"),
    }


def _truth(run: Course, sides: Mapping[str, str]) -> dict[str, tuple[Array, str, str]]:
    """Every output of the model, the wheel's side in its name."""
    single = dict.fromkeys([place for place in sides.values() if not place], next(iter(sides)))
    return {
        f"truth.{channel(single.get('', ''), output.name)}": (
            run.values[output.name],
            output.unit,
            f"{output.long_name} (truth)",
        )
        for output in run.outputs
    }


def _side(wheel: Wheel) -> str:
    return "left" if wheel == "both" else wheel


def _check_sensors(noise: float, displacement_noise: float, force_limit: float | None) -> None:
    for name, value, unit in (
        ("noise", noise, "of the static load"),
        ("displacement_noise", displacement_noise, "m"),
        ("force_limit", force_limit, "N"),
    ):
        if value is not None and not (np.isfinite(value) and value >= 0.0):
            raise SimulationError("out of range", where=name, found=value, allowed=f"0 or more ({unit})")


def findings_of_test(rig: Rig, tester: Tester) -> list[Finding]:
    """Say what a test of this rig on this tester would be worth less for.

    Parameters
    ----------
    rig : QuarterCar, Corner or FrontViewAxle
        What stands on the plates.
    tester : Tester
        Its limits and programme.

    Returns
    -------
    list of Finding
        Wheel loads (N) out of range, sweeps that are too fast or short, samples that are too rare.
    """
    on, limits, programme = stand(rig, tester), tester.limits, tester.programme
    found = []
    for place in on.places:
        load = on.static_load(place)
        if not limits.wheel_load_min <= load <= limits.wheel_load_max:
            allowed = f"{limits.wheel_load_min:.0f} to {limits.wheel_load_max:.0f} N"
            text = f"static wheel load {load:.0f} N is outside of what the tester takes ({allowed})"
            found.append(Finding(channel(place, "static_load"), "warning", text, load))
    if programme.run_down == "controlled":
        if programme.sweep_rate > limits.sweep_rate_max:
            text = f"the sweep of {programme.sweep_rate:g} Hz/s is faster than {limits.sweep_rate_max:g} Hz/s"
            found.append(Finding("programme.sweep_rate", "warning", text, programme.sweep_rate))
        swept = abs(programme.start_frequency - programme.end_frequency) / programme.sweep_rate
        if swept < limits.sweep_time_min:
            text = f"the sweep of {swept:.1f} s is shorter than {limits.sweep_time_min:g} s"
            found.append(Finding("programme.sweep_rate", "warning", text, swept))
    if tester.sampling_frequency < limits.sampling_frequency_min:
        text = f"sampled at {tester.sampling_frequency:g} Hz, below {limits.sampling_frequency_min:g} Hz"
        found.append(Finding("sampling_frequency", "warning", text, tester.sampling_frequency))
    return found
