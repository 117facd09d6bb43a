"""Steady response of a wheel to its plate from the linear model: contact force, adhesion, phase angle, wheel mode."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.errors import DescriptionError, SimulationError, unknown
from jounce.core.samples import as_samples
from jounce.core.types import Array, Complex
from jounce.parts.rig import Rig
from jounce.parts.testers import Tester, as_tester
from jounce.simulation.statics import for_small_motions
from jounce.testers.plates import SteadyResponse, least, least_adhesion
from jounce.testers.rig import TesterRig, channel, rig_on_tester

_ALIKE = 1.3  # frequency ratio below which two wheel modes of an axle form a pair


@dataclass(frozen=True)
class LinearTesterRig:
    """Linear model about rest, ``dx/dt = A x + B u``, ``y = C x + D u``; ``u`` are angles and rates of exciters."""

    on: TesterRig
    A: Array  # the inputs are the value and first derivatives of each track
    B: Array
    C: Array
    D: Array

    def transfer(self, frequency: ArrayLike, output: str, place: str = "") -> Complex:
        """Return the complex amplitude of an output (SI) for 1 rad of the exciter's angle, at frequencies in Hz."""
        row, (first, last) = self._row(output), self._inputs(place)
        s = 2j * np.pi * np.atleast_1d(as_samples(frequency, "Hz", where="frequency"))
        if s.ndim > 1:
            raise DescriptionError(
                "not a list of frequencies", where="frequency", found=f"shape {s.shape}"
            )
        drive = s[:, None] ** np.arange(last - first)
        size = len(self.A)
        states = np.linalg.solve(
            s[:, None, None] * np.eye(size) - self.A, (drive @ self.B[:, first:last].T)[:, :, None]
        )
        return np.asarray(states[:, :, 0] @ self.C[row] + drive @ self.D[row, first:last])

    def states(self, frequency: float, place: str = "") -> Complex:
        """Return the complex amplitudes of all states for 1 rad of an eccentric exciter's angle."""
        first, last = self._inputs(place)
        s = 2j * np.pi * frequency
        result = np.linalg.solve(
            s * np.eye(len(self.A)) - self.A, self.B[:, first:last] @ s ** np.arange(last - first)
        )
        return np.asarray(self.on.rest.lift @ result)

    def _row(self, output: str) -> int:
        names = self.on.compiled.output_names
        if output not in names:
            raise unknown(output, names, what="output", where="linear response")
        return names.index(output)

    def _inputs(self, place: str) -> tuple[int, int]:
        order = self.on.compiled.facts.track_order
        first = order * self.on.places.index(place)
        return first, first + order


def linear_rig_on_tester(on: TesterRig) -> LinearTesterRig:
    """Linearise a rig with driven exciters about rest."""
    compiled, still, p = on.compiled, on.prepared.still, on.prepared.problem.p
    rest = for_small_motions(compiled, on.rest, p, still)
    where = rest.x, still, p, rest.modes
    along = compiled.slopes("u", *where)
    c = compiled.slopes("x", *where)["output"] @ rest.lift
    return LinearTesterRig(on, rest.reduced, rest.pick @ along["rate"], c, along["output"])


def steady_response(
    rig: Rig, tester: Tester | str | Path, frequency: ArrayLike, *, wheel: str = "left"
) -> SteadyResponse:
    """Compute the steady response of a wheel to its plate from the linear model, in closed form.

    Parameters
    ----------
    rig : QuarterCar, Corner or FrontViewAxle
        Rig on the plates; springs and dampers have their slope at rest, the mean of both sides at a kink.
    tester : Tester, str or Path
        Tester that defines stroke and plate; also by name or file.
    frequency : array_like, shape (n,)
        Hz, above 0.
    wheel : {"left", "right"}
        Excited wheel of an axle; the other plate is at rest.

    Returns
    -------
    SteadyResponse
        Force response (N/m), plate response, adhesion and phase angle (rad).

    Raises
    ------
    SimulationError
        If the rig cannot be placed on a tester.
    DescriptionError
        If a wheel is unknown.

    Examples
    --------
    >>> from jounce.parts import load
    >>> from jounce.parts.testers import load_tester
    >>> found = steady_response(load("audi-a6-quarter-car"), load_tester("eusama"), [16.6])
    >>> round(float(found.adhesion[0]), 3)   # 3 mm, tyre damping 1000 N s/m
    0.725
    """
    return _steady(
        linear_rig_on_tester(rig_on_tester(rig, as_tester(tester))),
        np.atleast_1d(as_samples(frequency, "Hz", where="frequency")),
        wheel,
    )


def _steady(linear: LinearTesterRig, frequency: Array, wheel: str) -> SteadyResponse:
    if not np.all(np.isfinite(frequency)) or np.any(frequency <= 0.0):
        raise SimulationError(
            "invalid frequencies",
            where="frequency",
            found=float(frequency.min()),
            allowed="above 0 Hz",
        )
    place, amplitude = place_of(linear.on, wheel), linear.on.tester.amplitude
    force = linear.transfer(frequency, channel(place, "tyre.force"), place)
    plate = linear.transfer(frequency, channel(place, "plate.z"), place)
    return SteadyResponse(
        frequency, force / plate, plate / amplitude, linear.on.static_load(place), amplitude
    )


def place_of(on: TesterRig, wheel: str) -> str:
    """Return a wheel's name in the model: ``wheel`` on an axle, "" for a single wheel."""
    if wheel not in ("left", "right"):
        raise unknown(str(wheel), ("left", "right"), what="wheel", where="wheel")
    return wheel if len(on.places) > 1 else ""


def closed_form_adhesion(rig: Rig, tester: Tester, *, wheel: str = "left") -> tuple[float, float]:
    """Return the minimum adhesion of a slow sweep without lift-off, in closed form, and its frequency (to 0.01 Hz).

    The band is from 0 to the programme's highest frequency, inclusive. A negative adhesion (1) means that the linear
    model predicts lift-off. ``wheel`` is a wheel of an axle, ``left`` or ``right``.

    Examples
    --------
    >>> from jounce.parts import load
    >>> from jounce.parts.testers import load_tester
    >>> adhesion, frequency = closed_form_adhesion(load("audi-a6-quarter-car"), load_tester("eusama"))
    >>> round(100 * adhesion, 1), round(frequency, 1)   # %, Hz
    (72.5, 16.6)
    """
    linear = linear_rig_on_tester(rig_on_tester(rig, tester))
    highest = max(tester.programme.start_frequency, tester.programme.end_frequency)
    return least_adhesion(lambda f: _steady(linear, f, wheel), highest)


def least_phase_angle(rig: Rig, tester: Tester, *, wheel: str = "left") -> tuple[float, float]:
    """Return the minimum EGEA phase angle (rad) in the tester's band, and its frequency (Hz, to 0.01 Hz)."""
    linear, limits = linear_rig_on_tester(rig_on_tester(rig, tester)), tester.limits
    return least(
        lambda f: _steady(linear, f, wheel).phase_angle, limits.frequency_min, limits.frequency_max
    )


@dataclass(frozen=True)
class WheelMode:
    """Mode of the wheel: undamped natural frequency (Hz) and damping ratio (1)."""

    frequency_hz: float
    damping_ratio: float


def wheel_mode(
    rig: Rig, tester: Tester, *, wheel: str = "left", on: str = "road"
) -> WheelMode | None:
    """Return the wheel's mode from the poles of the linear model; None if the wheel does not oscillate.

    ``on="road"`` fixes the plate, ``on="rig"`` leaves it free on its spring; only then does the tester matter. For an
    axle, ``wheel`` is ``left`` or ``right``.

    Examples
    --------
    >>> from jounce.parts import load
    >>> from jounce.parts.testers import load_tester
    >>> mode = wheel_mode(load("audi-a6-quarter-car"), load_tester("theta-msd3000"))
    >>> round(mode.frequency_hz, 2), round(mode.damping_ratio, 3)   # with a tyre damping of 1000 N s/m
    (13.67, 0.393)
    """
    if on not in ("road", "rig"):
        raise unknown(on, ("road", "rig"), what="place of the wheel", where="on")
    linear = linear_rig_on_tester(rig_on_tester(rig, tester, blocked=on == "road"))
    place = place_of(linear.on, wheel)
    values, vectors = np.linalg.eig(linear.A)
    unsprung, sprung, plate = (_shapes(linear, channel(place, name), vectors) for name in _HEIGHTS)
    is_wheel = (values.imag > 1e-9 * np.abs(values)) & (np.abs(unsprung) > np.abs(sprung))
    is_wheel &= (
        unsprung * plate.conj()
    ).real >= 0.0  # in the plate's mode plate and wheel move in opposite directions
    if not is_wheel.any():
        return None
    lowest = np.min(np.abs(values[is_wheel]))
    pair = np.flatnonzero(is_wheel & (np.abs(values) < _ALIKE * lowest))
    first = linear.on.compiled.facts.track_order * linear.on.places.index(place)
    drive = np.linalg.solve(vectors, linear.B[:, first])
    best = values[pair[np.argmax(np.abs(unsprung * drive / values.real)[pair])]]
    return WheelMode(float(abs(best)) / (2.0 * np.pi), float(-best.real / abs(best)))


_HEIGHTS = "unsprung.z", "sprung.z", "plate.z"


def _shapes(linear: LinearTesterRig, output: str, vectors: Complex) -> Complex:
    """Return an output in each mode; zero if the output does not exist, as for a fixed body."""
    names = linear.on.compiled.output_names
    shapes = linear.C[names.index(output)] @ vectors if output in names else np.zeros(len(linear.A))
    return np.asarray(shapes, dtype=np.complex128)


def road_damping_ratio(
    damping_ratio: float,
    *,
    wheel_rate: float,
    tyre_stiffness: float,
    unsprung_mass: float,
    plate_mass: float,
    plate_spring_rate: float,
) -> float:
    """Convert the wheel mode's damping ratio on a sprung plate to the road, assuming one degree of freedom.

    Rates and stiffness in N/m, masses in kg. An approximation; `wheel_mode` is exact.

    Examples
    --------
    >>> car = dict(wheel_rate=25e3, tyre_stiffness=200e3, unsprung_mass=40.0)   # N/m, N/m, kg
    >>> round(road_damping_ratio(0.1118, **car, plate_mass=20.0, plate_spring_rate=50e3), 4)
    0.069
    """
    share = tyre_stiffness / (tyre_stiffness + plate_spring_rate)
    on_rig = (wheel_rate + share * plate_spring_rate) * (unsprung_mass + plate_mass * share**2)
    on_road = (wheel_rate + tyre_stiffness) * unsprung_mass
    return float(damping_ratio * np.sqrt(on_rig / on_road))
