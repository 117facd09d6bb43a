"""Errata of paper 2: printed and correct values, missing terms, contradictory values."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

import jounce as jn
from jounce.papers import Array

if TYPE_CHECKING:
    import xarray as xr

POWER, FREQUENCY, LOAD = 2200.0, 5.0, 4512.6
"""Drive power (W), exciter frequency (Hz), and load on the quarter car (N): Table 1."""
FREE_LENGTH, READ_LENGTH, CALCULATED = 0.341, 0.3288, 0.130
"""Spring length before and in the paper's simulation, and the compression in its manual calculation, m."""
DEMO_HEIGHT, DEMO_PITCH = -0.12, 0.0
"""Initial pose of the demo's car: height of the body in m, pitch in rad."""
PRINTED_RATE = 38.0
"""Printed front spring rate, N/m."""
_START_UP = 3.0  # s: time until the moment begins


@dataclass(frozen=True)
class Erratum:
    """One error in the paper, with evidence, and the printed and corrected value in the SI ``unit``."""

    place: str
    printed: str
    correct: str
    why: str
    printed_value: float | None = None
    correct_value: float | None = None
    unit: str = ""


@dataclass(frozen=True)
class PrintedSign:
    """The half car with the printed sign of eq. (9), M_rear = -L_r F_rear.

    It has the largest real part of the eigenvalues (1/s; pitch is unstable above zero), the equilibrium pitch of the
    printed equations (rad), and the eigenvalues (real and imaginary part, 1/s) with the printed and the correct sign.
    """

    growth_rate: float
    pitch_at_rest: float
    eigenvalues: tuple[tuple[float, float], ...]
    correct_eigenvalues: tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class StartUp(jn.Plain):
    """The paper's vehicle with the demo's initial height, m.

    It has the initial height of the body in the demo, the equilibrium height, their difference (``transient``), the
    minimum height in between, and ``signals`` over time.
    """

    left_out = ("signals",)

    initial: float
    equilibrium: float
    transient: float
    lowest: float
    signals: xr.Dataset


def half_car_matrices(vehicle: jn.HalfCar, rear_sign: float = 1.0) -> tuple[Array, Array, Array]:
    """Return mass, damping and stiffness matrix (SI) of a half car by eqs. (6) to (11), coordinates height and pitch.

    ``rear_sign`` is the sign of the rear axle's moment, M_rear = rear_sign L_r F_rear: 1 is correct, -1 is printed in
    eq. (9).
    """
    front, rear = vehicle.front, vehicle.rear
    seen = np.array(
        [[1.0, -front.distance], [1.0, rear.distance]]
    )  # heights of the body above the axles
    moved = np.array(
        [[1.0, 1.0], [-front.distance, rear_sign * rear.distance]]
    )  # effect of axle forces on the body

    def matrix(first: float, second: float) -> Array:
        return np.asarray(moved @ np.diag([2.0 * first, 2.0 * second]) @ seen)

    mass = np.diag([vehicle.body.mass, vehicle.body.pitch_inertia])
    damping = matrix(front.damping_coefficient, rear.damping_coefficient)
    return mass, damping, matrix(front.spring_rate, rear.spring_rate)


def eigenvalues(mass: Array, damping: Array, stiffness: Array) -> NDArray[np.complex128]:
    """Return the eigenvalues (1/s) of a second-order system with matrices (n, n) in SI, by falling real part."""
    n = len(mass)
    lower = -np.linalg.solve(mass, np.hstack([stiffness, damping]))
    values = np.linalg.eigvals(np.vstack([np.hstack([np.zeros((n, n)), np.eye(n)]), lower]))
    return np.asarray(sorted(values.astype(complex), key=lambda value: (-value.real, -value.imag)))


def printed_sign(vehicle: jn.HalfCar) -> PrintedSign:
    """Solve a half car with the printed sign of eq. (9), and with the correct one."""
    printed, correct = (half_car_matrices(vehicle, sign) for sign in (-1.0, 1.0))
    weight = np.array([-vehicle.body.mass * vehicle.gravity, 0.0])
    values = eigenvalues(*printed)
    return PrintedSign(
        float(values[0].real),
        float(np.linalg.solve(printed[2], weight)[1]),
        _pairs(values),
        _pairs(eigenvalues(*correct)),
    )


def _pairs(values: NDArray[np.complex128]) -> tuple[tuple[float, float], ...]:
    return tuple((float(value.real), float(value.imag)) for value in values)


def start_up(vehicle: jn.HalfCar) -> StartUp:
    """Simulate a half car on a level road from the initial state of the demo."""
    rest = jn.equilibrium(vehicle)
    offset = {"body.z": DEMO_HEIGHT - rest["body.z"], "body.pitch": DEMO_PITCH - rest["body.pitch"]}
    run = jn.simulate(
        vehicle, jn.Trial(road=jn.Flat(), speed=10.0, duration=_START_UP), offset=offset
    )
    height = run["body.z"].to_numpy()
    channels = {
        "body.z": (height, "m", "height of the body"),
        "body.pitch": (run["body.pitch"].to_numpy(), "rad", "pitch of the body, nose down"),
    }
    signals = jn.recording(run["time"].to_numpy(), channels)
    return StartUp(DEMO_HEIGHT, rest["body.z"], offset["body.z"], float(height.min()), signals)


def exciter_torque(power: float, frequency: float) -> float:
    """Return the torque in N m of a drive with a power in W at a frequency in Hz: eq. (5) in the correct units.

    Examples
    --------
    >>> round(exciter_torque(2200.0, 5.0), 2)
    70.03
    """
    return float(power / (2.0 * np.pi * frequency))


def series(*stiffnesses: float) -> float:
    """Return the stiffness (N/m) of springs in series."""
    return 1.0 / sum(1.0 / stiffness for stiffness in stiffnesses)


def series_at(rig: jn.QuarterCar, frequency: float) -> tuple[float, float]:
    """Return stiffness (N/m) and damping coefficient (N s/m) of suspension and tyre in series at a frequency in Hz."""
    omega = 2.0 * np.pi * frequency
    suspension = complex(rig.strut.spring.rate or np.nan, omega * _damping(rig))
    tyre = complex(rig.tyre.stiffness or np.nan, omega * rig.tyre.damping_coefficient)
    both = suspension * tyre / (suspension + tyre)
    return float(both.real), float(both.imag / omega)


def _damping(rig: jn.QuarterCar) -> float:
    return float(rig.strut.damper.coefficient)  # type: ignore[union-attr]


def paper_errata() -> tuple[Erratum, ...]:
    """Compare the paper's values and equations with the correct ones, which are computed from its tables."""
    car, demo, corner = (
        jn.load(name) for name in ("audi-a6-half-car", "sldemo-half-car", "audi-a6-quarter-car")
    )
    assert isinstance(car, jn.HalfCar)
    assert isinstance(demo, jn.HalfCar)
    assert isinstance(corner, jn.QuarterCar)
    return (
        *_stand(corner),
        *_stand_results(corner),
        *_loads(car, corner),
        *_equations(car),
        *_demo(car, demo),
        *_words(corner),
    )


def _stand(corner: jn.QuarterCar) -> tuple[Erratum, ...]:
    """Errata of section 4: the Inventor model on its exciter."""
    spring, tyre = corner.strut.spring.rate or np.nan, corner.tyre.stiffness or np.nan
    damper, pneumatic = _damping(corner), corner.tyre.damping_coefficient
    torque, both = exciter_torque(POWER, FREQUENCY), series(spring, tyre)
    at_frequency = series_at(corner, FREQUENCY)[1]
    return (
        Erratum(
            "eq. (5)",
            f"M = 60 P / (2π f) = {60.0 * torque:.1f} N m with f = {FREQUENCY:g} Hz",
            f"M = P / (2π f) = {torque:.2f} N m",
            f"the 60 belongs to a speed in revolutions per minute; n = {60.0 * FREQUENCY:g} rpm gives the same "
            f"{torque:.2f} N m",
            60.0 * torque,
            torque,
            "N*m",
        ),
        Erratum(
            "section 4, spring constant",
            f"sum of tyre and spring: {1e-3 * (spring + tyre):.0f} N/mm",
            f"in series: {1e-3 * both:.3f} N/mm",
            "one load passes through both springs, and their compressions add up",
            spring + tyre,
            both,
            "N/m",
        ),
        Erratum(
            "section 4, damping constant",
            f"sum: {damper + pneumatic:.0f} N s/m",
            f"in series: {at_frequency:.0f} N s/m at {FREQUENCY:g} Hz",
            "dampers beside springs in series have no constant coefficient: it falls with frequency, towards "
            f"c c_t/(c + c_t) = {series(damper, pneumatic):.0f} N s/m",
            damper + pneumatic,
            at_frequency,
            "N*s/m",
        ),
        Erratum(
            "table 1, c_pneu",
            f"{pneumatic:.0f} N s/m",
            "50 to 100 N s/m",
            "tyres of passenger cars damp 10 to 20 times less",
            pneumatic,
            None,
            "N*s/m",
        ),
        Erratum(
            "section 4, principle",
            f"EUSAMA principle at {FREQUENCY:g} Hz, stroke not given",
            "EUSAMA runs down from 25 Hz with a stroke of 6 mm",
            "power and frequency are those of a THETA tester; the exciter's amplitude is an input here (3 mm, "
            "estimated)",
        ),
    )


def _stand_results(corner: jn.QuarterCar) -> tuple[Erratum, ...]:
    """Errata of section 4: compression of the spring."""
    spring, tyre = corner.strut.spring.rate or np.nan, corner.tyre.stiffness or np.nan
    both = series(spring, tyre)
    merged, chain, alone = LOAD / (spring + tyre), LOAD / both, LOAD / spring
    read = FREE_LENGTH - READ_LENGTH
    metre = partial(Erratum, unit="m")
    return (
        metre(
            "section 4, static compression",
            f"of the summed spring: {1e3 * merged:.3f} mm",
            f"{1e3 * chain:.2f} mm: spring {1e3 * alone:.2f} mm and tyre {1e3 * LOAD / tyre:.2f} mm",
            f"{LOAD:g} N on {1e-3 * (spring + tyre):.0f} N/mm, and on {1e-3 * both:.3f} N/mm",
            merged,
            chain,
        ),
        metre(
            "section 4, result",
            f"{1e3 * read:.1f} mm (341 mm to 328.8 mm), which 'corresponds approximately' to {1e3 * CALCULATED:.0f} mm",
            f"{1e3 * merged:.1f} mm for the summed spring, {1e3 * chain:.1f} mm in series",
            f"they differ by a factor of {CALCULATED / read:.1f}: either 130 is a misprint of 13.0 (the summed "
            "spring), or the manual calculation is right (in series) and the simulation wrong",
            read,
            chain,
        ),
    )


def _with_sign(value: float) -> str:
    return f"{value:+.3f}".replace("-", "−")


def _loads(car: jn.HalfCar, corner: jn.QuarterCar) -> tuple[Erratum, ...]:
    """Errata of masses and rates that contradict each other."""
    wheel = jn.equilibrium(car)["front.strut.force"]
    quarter = 0.25 * car.body.mass * car.gravity
    rate = PRINTED_RATE
    return (
        Erratum(
            "table 1, load F",
            f"{LOAD:g} N = {LOAD / corner.gravity:.1f} kg × {corner.gravity:g} m/s²",
            f"{wheel:.0f} N",
            f"table 2 gives {0.25 * car.body.mass:.0f} kg ({quarter:.0f} N) as a quarter of the body, and by the lever "
            f"rule {wheel:.0f} N on a front wheel",
            LOAD,
            wheel,
            "N",
        ),
        Erratum(
            "section 5, front spring rate",
            "'modified from 38 N/m to 28 N/m'",
            "38 N/mm to 28 N/mm",
            f"with {rate:g} N/m the springs would be compressed by {wheel / rate:.0f} m to carry the car",
            rate,
            1e3 * rate,
            "N/m",
        ),
    )


def _equations(car: jn.HalfCar) -> tuple[Erratum, ...]:
    """Errata of section 5: the half car's equations."""
    printed = printed_sign(car)
    slowest = max(real for real, _ in printed.correct_eigenvalues)
    return (
        Erratum(
            "section 3",
            "'the dynamic model of car damping has six degrees of freedom'",
            "two: the quarter car of eqs. (1) to (4); and two for the half car: bounce and pitch",
            "the equations that follow have no more",
        ),
        Erratum(
            "eqs. (6) and (8)",
            "no road height",
            "F_front = 2 K_f (h + L_f θ − z) + ..., F_rear = 2 K_r (h − L_r θ − z) + ...",
            "without h obstacles have no effect; the text describes it as an input",
        ),
        Erratum(
            "eq. (7), text",
            "'determines pitch angle at the front axle'",
            "pitch moment due to the front axle",
            "it is a force times a lever",
        ),
        Erratum(
            "eq. (9)",
            "M_rear = −L_r F_rear",
            "M_rear = +L_r F_rear",
            f"as printed the car is unstable: an eigenvalue of {_with_sign(printed.growth_rate)} 1/s and an "
            f"equilibrium at a pitch of {printed.pitch_at_rest:.3f} rad; with the right sign the real parts are "
            f"{_with_sign(slowest)} 1/s and below",
            printed.growth_rate,
            slowest,
            "1/s",
        ),
    )


def _demo(car: jn.HalfCar, demo: jn.HalfCar) -> tuple[Erratum, ...]:
    """Errata of the demo."""
    rest, own = jn.equilibrium(car)["body.z"], jn.equilibrium(demo)["body.z"]
    rates = f"{car.front.spring_rate:.0f} and {car.rear.spring_rate:.0f} N/m"
    same = (car.front.spring_rate, car.rear.spring_rate) == (
        demo.front.spring_rate,
        demo.rear.spring_rate,
    )
    return (
        Erratum(
            "section 5, road in the demo",
            "F = 2 K (... − (z + h)): an obstacle lowers the body",
            "F = 2 K (... − (z − h))",
            "variant sign-corrected; the road also reaches both axles at once and has no effect on the dampers; "
            "only the variant physical corrects this",
        ),
        Erratum(
            "table 2, K_f and K_r",
            rates,
            "not known",
            "exactly the defaults of the demo, so probably left over from it"
            if same
            else "not the defaults of the demo",
        ),
        Erratum(
            "demo, initial height",
            f"z = −{-DEMO_HEIGHT:g} m, the balance of the demo's own car (−{-own:.6f} m)",
            f"z = −{-rest:.6f} m",
            f"unless it is changed a start-up transient of {1e3 * (DEMO_HEIGHT - rest):.1f} mm runs through the curves",
            DEMO_HEIGHT,
            rest,
            "m",
        ),
        Erratum(
            "section 5, M_y",
            "never given",
            "m_b a h: mass × deceleration × height of the centre of gravity",
            "the demo has a step of 100 N m at 3 s; 3 m/s² at 0.55 m (estimated) would be "
            f"{car.body.mass * 3.0 * 0.55:.1f} N m",
        ),
    )


def _words(corner: jn.QuarterCar) -> tuple[Erratum, ...]:
    """Errata of the text on damping and methods."""
    spring, tyre = corner.strut.spring.rate or np.nan, corner.tyre.stiffness or np.nan
    best = spring * float(np.sqrt((corner.sprung.mass + corner.unsprung.mass) / tyre))
    return (
        Erratum(
            "Theta, comfort",
            "the greater the damping rate, the greater the comfort",
            f"comfort is best near {best:.0f} N s/m and falls beyond",
            f"on a rough road the body's acceleration is least with c = k sqrt(M / k_t); this corner has "
            f"{_damping(corner):.0f} N s/m; a high Theta means that the damper works",
            None,
            best,
            "N*s/m",
        ),
        Erratum(
            "conclusions, half car",
            'the Simulink half car has "design principle THETA"',
            "THETA is a method of testing dampers",
            "the half car is driven by steps of road height and by a moment; no tester occurs in it",
        ),
    )
