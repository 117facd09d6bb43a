"""Paper 2's front corner on an eccentric exciter (section 4), reproduced with three models of spring and tyre."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

import jounce as jn
from jounce.papers import Array, Counted, Progress, no_progress
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

if TYPE_CHECKING:
    import xarray as xr

RIG = "audi-a6-quarter-car"
VARIANTS = ("summed", "series", "two-mass")
"""Models: spring and tyre constants summed; spring and tyre in series without wheel mass; and with wheel mass."""
AMPLITUDE, PLATE_MASS = 0.003, 20.0
"""Amplitude of the exciter (m) and mass of the plate (kg), both estimated because the paper does not state them."""
LARGEST = 0.095
"""Amplitude in m at which the spring of the summed model, 341 mm long, is compressed to zero length."""
DURATION, STEADY = 12.0, 1.0
"""Duration of a run, and of its steady final part, s."""
TOP = 25.0
"""Start frequency of a EUSAMA sweep, Hz."""
_STEP, _TOLERANCE = 1e-3, 1e-9  # s; far below the three digits printed in the paper
_TURNING = 2.0 * np.pi * FREQUENCY  # rad/s


@dataclass(frozen=True)
class Range:
    """Minimum, mean and maximum of a steady signal, in its SI unit."""

    min: float
    mean: float
    max: float


@dataclass(frozen=True)
class Oscillation:
    """One linear mode: ``frequency_hz`` (undamped, Hz) and ``damping_ratio`` (1)."""

    frequency_hz: float
    damping_ratio: float


@dataclass(frozen=True)
class ExciterDrive:
    """The exciter's drive in steady motion: torque (N m), mean power, and mean power dissipated by the dampers (W)."""

    torque: Range
    power: float
    dissipated: float


@dataclass(frozen=True)
class PlateRun(jn.Plain):
    """Results of one model on the plate, SI.

    ``statics`` is for the plate's mean height. ``amplitudes`` (simulated) and ``closed_form`` are amplitudes at the
    exciter's frequency per metre of plate amplitude. ``spring_length`` and ``spring_force`` are for the steady motion,
    ``shortest`` is the minimum length during the initial transient.
    """

    left_out = ("signals",)

    variant: str
    statics: dict[str, float]
    modes: tuple[Oscillation, ...]
    amplitudes: dict[str, float]
    closed_form: dict[str, float]
    spring_length: Range
    spring_force: Range
    shortest: float
    drive: ExciterDrive
    signals: xr.Dataset


@dataclass(frozen=True)
class Eusama:
    """Minimum contact force over the static one (1) in a sweep down from 25 Hz, and its frequency (Hz)."""

    tyre_damping_coefficient: float
    adhesion: float
    frequency_hz: float


@dataclass(frozen=True)
class EccentricExciter(jn.Plain):
    """Results of the exciter study.

    Attributes
    ----------
    rig : QuarterCar
        The corner of the paper's Table 1.
    amplitude, plate_mass : float
        Amplitude of the exciter (m) and mass of the plate (kg); estimated.
    runs : tuple of PlateRun
        Runs of the three models.
    torque : float
        Torque of eq. (5) in the correct units, N m.
    printed_torque : float
        Torque as computed in the paper, N m.
    fitting_amplitude : float
        Amplitude at which the minimum compression of the summed spring would be the paper's 12.2 mm, m.
    eusama : tuple of Eusama
        Results with the printed tyre damping and without it.
    errata : tuple of Erratum
        Values printed in the paper with the corrected ones.
    findings : tuple of Finding
        Warnings about the results.
    """

    rig: jn.QuarterCar
    amplitude: float
    plate_mass: float
    runs: tuple[PlateRun, ...]
    torque: float
    printed_torque: float
    fitting_amplitude: float
    eusama: tuple[Eusama, ...]
    errata: tuple[Erratum, ...]
    findings: tuple[jn.Finding, ...]

    def run(self, variant: str) -> PlateRun:
        """Return the run of a model."""
        return next(run for run in self.runs if run.variant == variant)

    def to_dict(self) -> dict[str, Any]:
        """Return the results as plain data in SI, without signals."""
        return jn.plain_table(
            {
                "rig": self.rig.model_dump(by_alias=True, exclude_none=True),
                "frequency_hz": FREQUENCY,
                "power": POWER,
                "load": LOAD,
                "free_length": FREE_LENGTH,
                "amplitude": self.amplitude,
                "plate_mass": self.plate_mass,
                "estimated": ("amplitude", "plate_mass", *self.rig.estimated),
                "runs": self.runs,
                "torque_of_eq_5": self.torque,
                "torque_of_eq_5_as_printed": self.printed_torque,
                "amplitude_that_would_fit": self.fitting_amplitude,
                "eusama": self.eusama,
                "paper": self.errata,
                "findings": self.findings,
            }
        )


def run_eccentric_exciter(
    amplitude: float = AMPLITUDE,
    plate_mass: float = PLATE_MASS,
    *,
    progress: Progress = no_progress,
) -> EccentricExciter:
    """Excite the paper's quarter car on its plate at 5 Hz, with three models.

    Initially the spring is uncompressed (341 mm long), the plate is at its lowest point, and the exciter turns at
    constant speed; the load of 460 kg then compresses the spring.

    Parameters
    ----------
    amplitude : float
        Amplitude of the exciter, m: half the plate's stroke.
    plate_mass : float
        Mass of the plate, kg.
    progress : callable
        Called with one line of text at each step of the work.

    Returns
    -------
    EccentricExciter
        Statics, modes, steady response, spring length and force over time, and drive torque.

    Raises
    ------
    DescriptionError
        For an amplitude that is not above 0 or would compress the spring completely, or a negative mass.

    Examples
    --------
    >>> found = run_eccentric_exciter()
    >>> [round(1e3 * run.statics["compression"], 2) for run in found.runs]    # mm
    [13.35, 133.79, 135.27]
    """
    if not (np.isfinite(amplitude) and 0.0 < amplitude <= LARGEST):
        raise jn.DescriptionError(
            "invalid amplitude for this exciter",
            where="amplitude",
            found=f"{amplitude:g} m",
            allowed=f"above 0 m, at most {LARGEST:g} m; a larger one would compress the spring completely",
        )
    if not (np.isfinite(plate_mass) and plate_mass >= 0.0):
        raise jn.DescriptionError(
            "invalid mass", where="plate_mass", found=plate_mass, allowed="0 kg or more"
        )
    rig = jn.load(RIG)
    assert isinstance(rig, jn.QuarterCar)
    runs = []
    for k, variant in enumerate(VARIANTS, 1):
        progress(Counted("simulate", k, len(VARIANTS), variant))
        runs.append(_plate_run(variant, rig, amplitude, plate_mass))
    summed = runs[0]
    fitting = (summed.statics["compression"] - (FREE_LENGTH - READ_LENGTH)) / summed.closed_form[
        "spring"
    ]
    torque = exciter_torque(POWER, FREQUENCY)
    testers = tuple(
        eusama(rig, amplitude, damping) for damping in (rig.tyre.damping_coefficient, 0.0)
    )
    findings = _findings(runs, torque, amplitude, fitting)
    return EccentricExciter(
        rig,
        amplitude,
        plate_mass,
        tuple(runs),
        torque,
        60.0 * torque,
        fitting,
        testers,
        paper_errata(),
        findings,
    )


def _plate_run(variant: str, rig: jn.QuarterCar, amplitude: float, plate_mass: float) -> PlateRun:
    values = rig.parameters()
    time = np.asarray(np.arange(round(DURATION / _STEP) + 1) * _STEP, dtype=np.float64)
    if variant == "two-mass":
        output, statics, oscillations = _quarter_car(rig, amplitude, time)
    else:
        output, statics, oscillations = _linear(variant, values, amplitude, time)
    signals = _signals(output, values["gravity"], amplitude, plate_mass, time)
    part = signals.isel(time=slice(-1 - round(STEADY / _STEP), -1))  # whole turns
    steady = {str(name): part[name].to_numpy() for name in part.data_vars}
    carriers = {
        "body": "sprung.z",
        "wheel": "unsprung.z",
        "spring": "spring.deflection",
        "contact": "tyre.force",
    }
    sizes = {
        key: _amplitude(part["time"].to_numpy(), steady[name])
        for key, name in carriers.items()
        if name in steady
    }
    return PlateRun(
        variant,
        statics,
        oscillations,
        {key: size / amplitude for key, size in sizes.items()},
        closed_form(variant, values),
        _range(steady["spring.length"]),
        _range(steady["spring.force"]),
        float(signals["spring.length"].min()),
        ExciterDrive(
            _range(steady["excenter.torque"]),
            float(steady["excenter.power"].mean()),
            float(steady["dampers.power"].mean()),
        ),
        signals,
    )


_Found = tuple[dict[str, Array], dict[str, float], tuple[Oscillation, ...]]


def _plate(amplitude: float, time: Array) -> tuple[Array, Array, Array]:
    """Height (m) of the plate over time, its rate and acceleration; a steady rotation from the lowest point."""
    angle = _TURNING * time - 0.5 * np.pi
    height, rate = amplitude * np.sin(angle), amplitude * _TURNING * np.cos(angle)
    return height, rate, -(_TURNING**2) * height


def _quarter_car(rig: jn.QuarterCar, amplitude: float, time: Array) -> _Found:
    """Simulate the two-mass model with lift-off: the quarter car on waves of 1 m length at 5 m/s."""
    road = jn.Sine(
        amplitude=amplitude, wavelength=1.0, length=FREQUENCY * (DURATION + 1.0), phase=-0.5 * np.pi
    )
    rest, values = jn.equilibrium(rig), rig.parameters()
    run = jn.simulate(
        rig,
        jn.Trial(road=road, speed=FREQUENCY, duration=DURATION),
        output_step=_STEP,
        tolerance=_TOLERANCE,
        offset={
            name: -rest[name] for name in ("sprung.z", "unsprung.z")
        },  # no spring is compressed at the start
    )
    velocity = run["strut.velocity"].to_numpy()
    tyre_velocity = _plate(amplitude, time)[1] - run["unsprung.vz"].to_numpy()
    damping, pneumatic = values["strut.damper.coefficient"], values["tyre.damping_coefficient"]
    deflection = run["strut.deflection"].to_numpy()
    quarter_car = {
        "sprung.z": run["sprung.z"].to_numpy(),
        "sprung.az": run["sprung.az"].to_numpy(),
        "unsprung.z": run["unsprung.z"].to_numpy(),
        "spring.deflection": deflection,
        "spring.force": values["strut.spring.rate"] * deflection,
        "strut.force": run["strut.force"].to_numpy(),
        "tyre.force": run["tyre.force"].to_numpy(),
        "dampers.power": damping * velocity**2 + pneumatic * tyre_velocity**2,
    }
    statics = _statics(rest["strut.deflection"], -rest["sprung.z"], rest["tyre.force"])
    return (
        quarter_car,
        statics,
        tuple(Oscillation(mode.frequency_hz, mode.damping_ratio) for mode in jn.modes(rig)),
    )


def _linear(variant: str, values: dict[str, float], amplitude: float, time: Array) -> _Found:
    """Solve one mass on bilateral springs and dampers exactly: each quantity is a row vector over the states.

    The states are height and velocity of the body, for the series model the height of the massless point between spring
    and tyre (whose forces are equal), then sine and cosine of the exciter's angle, and 1.
    """
    from scipy.linalg import expm

    rate, damping = values["strut.spring.rate"], values["strut.damper.coefficient"]
    stiffness, pneumatic = values["tyre.stiffness"], values["tyre.damping_coefficient"]
    count = 2 if variant == "summed" else 3
    body, velocity, *inner, sine, cosine, unity = np.eye(count + 3)
    plate, plate_velocity = amplitude * sine, amplitude * _TURNING * cosine
    if variant == "summed":
        deflection, opening = plate - body, plate_velocity - velocity
        spring = (rate + stiffness) * deflection
        strut = spring + (damping + pneumatic) * opening
        rates = []
        losses = [(damping + pneumatic, opening)]
    else:
        wheel = inner[0]
        pull = stiffness * (plate - wheel) + pneumatic * plate_velocity
        wheel_velocity = (pull - rate * (wheel - body) + damping * velocity) / (damping + pneumatic)
        deflection, opening = wheel - body, wheel_velocity - velocity
        spring = rate * deflection
        strut = spring + damping * opening
        rates = [wheel_velocity]
        losses = [(damping, opening), (pneumatic, plate_velocity - wheel_velocity)]
    acceleration = strut / values["sprung.mass"] - values["gravity"] * unity
    matrix = np.array(
        [velocity, acceleration, *rates, _TURNING * cosine, -_TURNING * sine, 0.0 * unity]
    )
    state = np.zeros(count + 3)
    state[
        [0, *range(2, count)]
    ] = -amplitude  # no spring is compressed, the plate is at its lowest point
    state[-3], state[-1] = -1.0, 1.0
    states, onward = np.empty((len(time), count + 3)), expm(matrix * _STEP)
    for i in range(len(time)):
        states[i] = state
        state = onward @ state
    rows = {
        "sprung.z": body,
        "sprung.az": acceleration,
        "spring.deflection": deflection,
        "spring.force": spring,
        "strut.force": strut,
        "tyre.force": strut,
    }
    linear = {name: states @ row for name, row in rows.items()}
    linear["dampers.power"] = np.sum(
        [coefficient * (states @ row) ** 2 for coefficient, row in losses], axis=0
    )
    motion = matrix[:count, :count]
    rest = np.concatenate(
        [np.linalg.solve(motion, -matrix[:count, -1]), [0.0, 0.0, 1.0]]
    )  # plate at its mean height
    poles = [value for value in np.linalg.eigvals(motion) if value.imag > 1e-9 * abs(value)]
    modes = (
        Oscillation(float(abs(value)) / (2.0 * np.pi), float(-value.real / abs(value)))
        for value in poles
    )
    return (
        linear,
        _statics(float(deflection @ rest), -float(rest[0]), float(strut @ rest)),
        tuple(modes),
    )


def _signals(
    output: dict[str, Array], gravity: float, amplitude: float, plate_mass: float, time: Array
) -> xr.Dataset:
    """Return all channels; the plate is guided without friction and driven by the exciter as a Scotch yoke."""
    height, velocity, acceleration = _plate(amplitude, time)
    force = output["tyre.force"] + plate_mass * (gravity + acceleration)
    channels = {
        "sprung.z": ("m", "body, height"),
        "sprung.az": ("m/s^2", "body, vertical acceleration"),
        "unsprung.z": ("m", "wheel, height"),
        "spring.deflection": ("m", "spring, compression"),
        "spring.length": ("m", "spring, length"),
        "spring.force": ("N", "spring, force without damper, compression positive"),
        "strut.force": ("N", "spring and damper, force, compression positive"),
        "stand.deflection": ("m", "all springs, compression between plate and body"),
        "tyre.force": ("N", "force on the plate, compression positive"),
        "dampers.power": ("W", "power that the dampers turn to heat"),
        "plate.z": ("m", "plate, height"),
        "plate.force": ("N", "exciter on plate, up"),
        "excenter.torque": ("N*m", "torque of the drive on the exciter"),
        "excenter.power": ("W", "power of the drive"),
    }
    every = output | {
        "spring.length": FREE_LENGTH - output["spring.deflection"],
        "stand.deflection": height - output["sprung.z"],
        "plate.z": height,
        "plate.force": force,
        "excenter.torque": force * velocity / _TURNING,
        "excenter.power": force * velocity,
    }
    return jn.recording(
        time, {name: (every[name], *about) for name, about in channels.items() if name in every}
    )


def _statics(spring: float, every: float, contact: float) -> dict[str, float]:
    length = FREE_LENGTH - spring
    return {
        "spring_compression": spring,
        "compression": every,
        "spring_length": length,
        "contact_force": contact,
    }


def _amplitude(time: Array, values: Array) -> float:
    """Amplitude of the motion at the exciter's frequency; the samples must cover whole turns."""
    return float(abs(2.0 * np.mean(values * np.exp(-2j * np.pi * FREQUENCY * time))))


def _range(values: Array) -> Range:
    return Range(float(values.min()), float(values.mean()), float(values.max()))


def closed_form(variant: str, values: dict[str, float]) -> dict[str, float]:
    """Compute amplitudes at the exciter's frequency per metre of plate amplitude, from complex stiffnesses.

    ``values`` are the parameters (SI); the result has ``body``, ``spring`` (m/m), ``contact`` (N/m), and ``wheel`` if
    the model has one.
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
    result = _sizes(
        body=follows * wheel, spring=(1.0 - follows) * wheel, contact=tyre * (1.0 - wheel)
    )
    return result | _sizes(wheel=wheel) if variant == "two-mass" else result


def _sizes(**values: complex) -> dict[str, float]:
    return {name: float(abs(value)) for name, value in values.items()}


def eusama(rig: jn.QuarterCar, amplitude: float, tyre_damping: float) -> Eusama:
    """Compute the adhesion in a slow sweep down from 25 Hz (linear, without lift-off); plate in m, tyre in N s/m."""
    model = jn.linearise(rig.with_changes({"tyre.damping_coefficient": tyre_damping}))
    frequency = np.linspace(0.01, TOP, 2500)
    size = np.abs(model.frequency_response(frequency, "tyre.force"))
    worst = int(np.argmax(size))
    static = (rig.sprung.mass + rig.unsprung.mass) * rig.gravity
    return Eusama(
        tyre_damping, 1.0 - amplitude * float(size[worst]) / static, float(frequency[worst])
    )


def _findings(
    runs: list[PlateRun], torque: float, amplitude: float, fitting: float
) -> tuple[jn.Finding, ...]:
    summed, full = runs[0], runs[-1]
    length, power = summed.spring_length, full.drive.power
    lifted = [
        run.variant
        for run in runs
        if float(run.signals["tyre.force"].isel(time=slice(-1000, None)).min()) <= 0.0
    ]
    lengths = {"least": length.min, "most": length.max, "mean": length.mean, "fitting": fitting}
    torques = {"power": power, "most": full.drive.torque.max, "torque": torque}
    estimated = {"amplitude": amplitude}
    findings = [
        jn.Finding("eccentric exciter", "warning", "", None, "papers.exciter_estimated", estimated),
        jn.Finding("summed", "warning", "", fitting, "papers.spring_length", lengths),
        jn.Finding("drive", "note", "", power, "papers.drive_torque", torques),
    ]
    findings += [
        jn.Finding(variant, "warning", "", None, "papers.wheel_lifts") for variant in lifted
    ]
    return tuple(findings)
