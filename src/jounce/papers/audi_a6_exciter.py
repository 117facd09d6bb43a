"""Paper 2's front corner on an eccentric exciter (section 4), rebuilt: springs summed, in series, and in full."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding
from jounce.core.serialise import to_plain
from jounce.core.types import Array
from jounce.mechanics.motions import constant_rate
from jounce.papers.audi_a6_paper import (
    FREE_LENGTH,
    FREQUENCY,
    LOAD,
    POWER,
    READ_LENGTH,
    Erratum,
    exciter_torque,
    paper_errata,
)
from jounce.papers.audi_a6_plate import CHAINS, plate_model
from jounce.parts import QuarterCar, load
from jounce.recordings.schema import recording
from jounce.simulation import linearise
from jounce.simulation.compiled import Compiled, compile_model
from jounce.simulation.prepare import solve
from jounce.simulation.result import samples_reached
from jounce.simulation.settings import output_times
from jounce.simulation.statics import Equilibrium, find_equilibrium

if TYPE_CHECKING:
    import xarray as xr

Progress = Callable[[str], None]
RIG = "audi-a6-quarter-car"
AMPLITUDE, PLATE_MASS = 0.003, 20.0
LARGEST = 0.095
"""Amplitude in m at which the spring of the summed model, 341 mm long, is compressed to nothing."""
"""Of the exciter (m) and of the plate (kg); neither is in the paper, both are estimated."""
DURATION, STEADY = 12.0, 1.0
"""Length of a run, and of its last part that counts as steady, s."""
TOP = 25.0
"""Where a EUSAMA run-down begins, Hz."""
_BOTTOM = -0.5 * np.pi  # rad: the plate starts from its lowest place, where a steady turn does not jerk it
_TOLERANCE = 1e-9


@dataclass(frozen=True)
class Range:
    """Least, mean and greatest value of a steady signal, in its SI unit."""

    min: float
    mean: float
    max: float


@dataclass(frozen=True)
class Oscillation:
    """One mode of small motions: ``frequency_hz`` (undamped, Hz) and ``damping_ratio`` (1)."""

    frequency_hz: float
    damping_ratio: float


@dataclass(frozen=True)
class Drive:
    """What the drive of the exciter has to give once the motion is steady.

    Attributes
    ----------
    torque : Range
        N m.
    power, dissipated : float
        Mean power of the drive, and mean power that the dampers turn to heat, W; they must be the same.
    """

    torque: Range
    power: float
    dissipated: float


@dataclass(frozen=True)
class PlateRun:
    """One model on the plate.

    Attributes
    ----------
    variant : str
        ``"summed"``, ``"series"`` or ``"two-mass"``.
    statics : dict of str to float
        Compression of the spring and of all springs together (m), length of the spring (m), force on the plate (N) at
        the plate's mean height.
    modes : tuple of Oscillation
        By rising frequency.
    amplitudes : dict of str to float
        At the exciter's frequency for one metre of the plate: ``body``, ``wheel``, ``spring`` (compression; m/m),
        ``contact`` (force on the plate, N/m), from the simulation.
    closed_form : dict of str to float
        The same by the formulas of linear oscillations.
    spring_length, spring_force : Range
        Once the motion is steady, m and N.
    shortest : float
        Length of the spring at its shortest while it takes up the load, m.
    drive : Drive
        Torque and power.
    signals : xarray.Dataset
        Over time, from the uncompressed spring on.
    """

    variant: str
    statics: dict[str, float]
    modes: tuple[Oscillation, ...]
    amplitudes: dict[str, float]
    closed_form: dict[str, float]
    spring_length: Range
    spring_force: Range
    shortest: float
    drive: Drive
    signals: xr.Dataset

    def to_dict(self) -> dict[str, Any]:
        """Give the results as plain data in SI, without signals."""
        plain: dict[str, Any] = to_plain(
            {name: getattr(self, name) for name in self.__annotations__ if name != "signals"}
        )
        return plain


@dataclass(frozen=True)
class Eusama:
    """Least contact force over the static one (1) in a run-down from 25 Hz, and where (Hz)."""

    tyre_damping_coefficient: float
    adhesion: float
    frequency_hz: float


@dataclass(frozen=True)
class EccentricExciter:
    """What the exciter study found.

    Attributes
    ----------
    rig : QuarterCar
        The paper's Table 1.
    amplitude, plate_mass : float
        Of the exciter (m) and the plate (kg); estimated.
    runs : tuple of PlateRun
        The three models.
    torque : float
        Of eq. (5) in the right units, N m.
    printed_torque : float
        As the paper computed it, N m.
    fitting_amplitude : float
        Amplitude at which the summed spring's least compression would be the paper's 12.2 mm, m.
    eusama : tuple of Eusama
        With the printed tyre damping and without.
    errata : tuple of Erratum
        The paper's numbers beside the correct ones.
    findings : tuple of Finding
        What the reader must know.
    """

    rig: QuarterCar
    amplitude: float
    plate_mass: float
    runs: tuple[PlateRun, ...]
    torque: float
    printed_torque: float
    fitting_amplitude: float
    eusama: tuple[Eusama, ...]
    errata: tuple[Erratum, ...]
    findings: tuple[Finding, ...]

    def run(self, variant: str) -> PlateRun:
        """Give the run of one model."""
        return next(run for run in self.runs if run.variant == variant)

    def to_dict(self) -> dict[str, Any]:
        """Give the results as plain data in SI, without signals."""
        plain: dict[str, Any] = to_plain(
            {
                "rig": self.rig.model_dump(by_alias=True, exclude_none=True),
                "frequency_hz": FREQUENCY,
                "power": POWER,
                "load": LOAD,
                "free_length": FREE_LENGTH,
                "amplitude": self.amplitude,
                "plate_mass": self.plate_mass,
                "estimated": ("amplitude", "plate_mass", *self.rig.estimated),
                "runs": [run.to_dict() for run in self.runs],
                "torque_of_eq_5": self.torque,
                "torque_of_eq_5_as_printed": self.printed_torque,
                "amplitude_that_would_fit": self.fitting_amplitude,
                "eusama": self.eusama,
                "paper": self.errata,
                "findings": self.findings,
            }
        )
        return plain


def run_eccentric_exciter(
    amplitude: float = AMPLITUDE, plate_mass: float = PLATE_MASS, *, progress: Progress = lambda _: None
) -> EccentricExciter:
    """Drive the paper's quarter car on its plate at 5 Hz, in three models.

    The spring is uncompressed (341 mm long) and the plate at its lowest when the exciter begins to turn steadily; the
    load of 460 kg then compresses the spring.

    Parameters
    ----------
    amplitude : float
        Of the exciter, m: half the plate's stroke.
    plate_mass : float
        kg.
    progress : callable
        Called with one line of text as the work goes on.

    Returns
    -------
    EccentricExciter
        Statics, modes, steady response, spring length and force over time, torque of the drive.

    Raises
    ------
    DescriptionError
        For an amplitude that is not above 0 or leaves the spring no length, or a negative mass.

    Examples
    --------
    >>> found = run_eccentric_exciter()
    >>> [round(1e3 * run.statics["compression"], 2) for run in found.runs]    # mm
    [13.35, 133.79, 135.27]
    """
    if not (np.isfinite(amplitude) and 0.0 < amplitude <= LARGEST):
        raise DescriptionError(
            "not an amplitude of this exciter",
            where="amplitude",
            found=f"{amplitude:g} m",
            allowed=f"above 0 m, at most {LARGEST:g} m; more would compress the spring to nothing",
        )
    if not (np.isfinite(plate_mass) and plate_mass >= 0.0):
        raise DescriptionError("not a mass", where="plate_mass", found=plate_mass, allowed="0 kg or more")
    rig = load(RIG)
    assert isinstance(rig, QuarterCar)
    extra = {"excenter.amplitude": amplitude, "plate.mass": plate_mass, "spring.free_length": FREE_LENGTH}
    runs = []
    for variant in CHAINS:
        progress(f"simulate: {variant}")
        runs.append(_plate_run(variant, rig, rig.parameters() | extra))
    summed = runs[0]
    fitting = (summed.statics["compression"] - (FREE_LENGTH - READ_LENGTH)) / summed.closed_form["spring"]
    torque = exciter_torque(POWER, FREQUENCY)
    testers = tuple(eusama(rig, amplitude, damping) for damping in (rig.tyre.damping_coefficient, 0.0))
    findings = _findings(runs, torque, amplitude, fitting)
    return EccentricExciter(
        rig, amplitude, plate_mass, tuple(runs), torque, 60.0 * torque, fitting, testers, paper_errata(), findings
    )


def _plate_run(variant: str, rig: QuarterCar, values: dict[str, float]) -> PlateRun:
    compiled = compile_model(plate_model(variant, rig))
    p = compiled.parameter_values(values)
    signals = _simulated(compiled, p, values["excenter.amplitude"])
    rest = find_equilibrium(compiled, p, np.zeros(compiled.facts.track_order))
    part = signals.isel(time=slice(-1 - round(STEADY / 1e-3), -1))
    time = part["time"].to_numpy()
    steady_part = {str(name): part[name].to_numpy() for name in part.data_vars}
    scale = 1.0 / values["excenter.amplitude"]
    carriers = {"body": "sprung.z", "wheel": "unsprung.z", "spring": "spring.deflection", "contact": "tyre.force"}
    return PlateRun(
        variant,
        _statics(compiled, p, rest),
        _oscillations(rest),
        {key: scale * _amplitude(time, steady_part[name]) for key, name in carriers.items() if name in steady_part},
        closed_form(variant, values),
        _range(steady_part["spring.length"]),
        _range(steady_part["spring.force"]),
        float(signals["spring.length"].min()),
        Drive(
            _range(steady_part["excenter.torque"]),
            float(steady_part["excenter.power"].mean()),
            float(steady_part["dampers.power"].mean()),
        ),
        signals,
    )


def _simulated(compiled: Compiled, p: Array, amplitude: float) -> xr.Dataset:
    """Run from uncompressed springs, the plate at its lowest."""
    turn = constant_rate(2.0 * np.pi * FREQUENCY, _BOTTOM)
    times = output_times(DURATION, 1e-3)
    still = np.zeros(compiled.facts.track_order)
    still[0] = _BOTTOM
    rest = find_equilibrium(compiled, p, still)
    positions = {*compiled.facts.coordinates, *compiled.facts.internal}
    start = np.array([-amplitude if name in positions else 0.0 for name in compiled.facts.states])
    solution = solve(compiled, p, turn, times, tolerance=_TOLERANCE, offset=start - rest.x)
    samples_reached(solution, compiled.facts, check=True)
    outputs = zip(compiled.facts.outputs, solution.outputs, strict=True)
    return recording(times, {output.name: (row, output.unit, output.long_name) for output, row in outputs})


def _statics(compiled: Compiled, p: Array, rest: Equilibrium) -> dict[str, float]:
    still = np.zeros(compiled.facts.track_order)
    found = compiled.evaluate("output", rest.x, still, p, rest.modes)
    values = dict(zip(compiled.output_names, map(float, found), strict=True))
    return {
        "spring_compression": values["spring.deflection"],
        "compression": values["stand.deflection"],
        "spring_length": values["spring.length"],
        "contact_force": values["tyre.force"],
    }


def _oscillations(rest: Equilibrium) -> tuple[Oscillation, ...]:
    values = [value for value in np.linalg.eigvals(rest.reduced) if value.imag > 1e-9 * abs(value)]
    found = [Oscillation(float(abs(value)) / (2.0 * np.pi), float(-value.real / abs(value))) for value in values]
    return tuple(sorted(found, key=lambda one: one.frequency_hz))


def _amplitude(time: Array, values: Array) -> float:
    """Amplitude of the motion at the exciter's frequency; the samples are whole turns."""
    return float(abs(2.0 * np.mean(values * np.exp(-2j * np.pi * FREQUENCY * time))))


def _range(values: Array) -> Range:
    return Range(float(values.min()), float(values.mean()), float(values.max()))


def closed_form(variant: str, values: dict[str, float]) -> dict[str, float]:
    """Amplitudes at the exciter's frequency for one metre of the plate, by complex stiffnesses.

    Parameters
    ----------
    variant : {"summed", "series", "two-mass"}
        Which model.
    values : dict of str to float
        Parameters by path, SI.

    Returns
    -------
    dict of str to float
        ``body``, ``spring`` (m/m), ``contact`` (N/m), and ``wheel`` where there is one.
    """
    omega = 2.0 * np.pi * FREQUENCY
    inertia = values["sprung.mass"] * omega**2
    suspension = values["strut.spring.rate"] + 1j * omega * values["strut.damper.coefficient"]
    tyre = values["tyre.stiffness"] + 1j * omega * values["tyre.damping_coefficient"]
    if variant == "summed":
        body = (suspension + tyre) / (suspension + tyre - inertia)
        return _sizes(body=body, spring=1.0 - body, contact=(suspension + tyre) * (1.0 - body))
    wheel_inertia = values["unsprung.mass"] * omega**2 if variant == "two-mass" else 0.0
    follows = suspension / (suspension - inertia)  # body over wheel
    wheel = tyre / (tyre - wheel_inertia - inertia * follows)
    found = _sizes(body=follows * wheel, spring=(1.0 - follows) * wheel, contact=tyre * (1.0 - wheel))
    return found | _sizes(wheel=wheel) if variant == "two-mass" else found


def _sizes(**values: complex) -> dict[str, float]:
    return {name: float(abs(value)) for name, value in values.items()}


def eusama(rig: QuarterCar, amplitude: float, tyre_damping: float) -> Eusama:
    """Adhesion of a slow run-down from 25 Hz, from the linear model (no lift-off).

    Parameters
    ----------
    rig : QuarterCar
        What stands on the plate.
    amplitude : float
        Of the plate, m.
    tyre_damping : float
        Damping coefficient of the tyre, N s/m.
    """
    model = linearise(rig.with_changes({"tyre.damping_coefficient": tyre_damping}))
    frequency = np.linspace(0.01, TOP, 2500)
    size = np.abs(model.frequency_response(frequency, "tyre.force"))
    worst = int(np.argmax(size))
    static = (rig.sprung.mass + rig.unsprung.mass) * rig.gravity
    return Eusama(tyre_damping, 1.0 - amplitude * float(size[worst]) / static, float(frequency[worst]))


def _findings(runs: list[PlateRun], torque: float, amplitude: float, fitting: float) -> tuple[Finding, ...]:
    summed, full = runs[0], runs[-1]
    length, power = summed.spring_length, full.drive.power
    lifted = [
        run.variant for run in runs if float(run.signals["tyre.force"].isel(time=slice(-1000, None)).min()) <= 0.0
    ]
    found = [
        Finding(
            "exciter",
            "warning",
            f"its amplitude ({1e3 * amplitude:g} mm) and the plate's mass are estimated; so is the unsprung mass.",
        ),
        Finding(
            "summed",
            "warning",
            f"the spring swings between {1e3 * length.min:.1f} and {1e3 * length.max:.1f} mm about "
            f"{1e3 * length.mean:.1f} mm; the paper's 328.8 mm is longer than the mean, so it is no maximum of "
            f"compression for any amplitude: it reads as a static value. As least compression it would need "
            f"{1e3 * fitting:.2f} mm of amplitude.",
            fitting,
        ),
        Finding(
            "drive",
            "note",
            f"the two-mass model takes up {power:.1f} W on average, {full.drive.torque.max:.1f} N m at most; the "
            f"{torque:.2f} N m of eq. (5) would only speed the exciter up: a drive holds the speed, not the torque.",
            power,
        ),
    ]
    found += [Finding(variant, "warning", "the wheel leaves the plate in steady motion.") for variant in lifted]
    return tuple(found)
