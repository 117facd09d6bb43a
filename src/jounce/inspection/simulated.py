"""Simulated inspection of a rig: an evaluated sweep, or steady states."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from jounce.core.errors import SimulationError, unknown
from jounce.core.findings import Finding
from jounce.core.shown import Shown
from jounce.inspection.evaluation import evaluate
from jounce.inspection.findings import warning
from jounce.inspection.grading import GradedInspection, grade
from jounce.inspection.methods import METHODS, methods_on, rigidity_findings
from jounce.inspection.quarter_car import body_damping
from jounce.inspection.result import Inspection, WheelResult
from jounce.parts import QuarterCar, Rig
from jounce.parts.dampers import LinearDamper
from jounce.parts.testers import Tester, as_tester, load_tester
from jounce.parts.vehicles import FrontViewAxle, Vehicle, axle_of
from jounce.testers.periodic import steady_sweep
from jounce.testers.plate_response import (
    closed_form_adhesion,
    least_phase_angle,
    linear_rig_on_tester,
    steady_response,
    wheel_mode,
)
from jounce.testers.plates import RIGIDITY_FREQUENCY, tyre_rigidity
from jounce.testers.rig import check_rig, rig_on_tester
from jounce.testers.testing import findings_of_test, simulate_test

if TYPE_CHECKING:
    import xarray as xr

_RESOLUTION = 0.005  # Hz: half the 0.01 Hz step of the search for minima


@dataclass(frozen=True)
class SimulatedInspection(Shown):
    """Result of one wheel in a simulated test.

    Attributes
    ----------
    wheel : WheelResult
        Values (SI), grade, verdict and reasons.
    record : xarray.Dataset or None
        Record of the simulated test; None for steady states.
    theta_road, theta_rig : float or None
        True damping ratios of the wheel's mode, from the poles of the linear model.
    """

    wheel: WheelResult
    record: xr.Dataset | None
    theta_road: float | None
    theta_rig: float | None


def tester_for(method: str) -> Tester:
    """Return the shipped tester of a method.

    Raises
    ------
    DescriptionError
        For an unknown method.
    """
    if method not in METHODS:
        raise unknown(method, METHODS, what="method", where="method")
    return load_tester(METHODS[method].tester)


def on_plates(rig: Rig, axle: Literal["front", "rear"] = "front") -> Rig:
    """Return the rig on the plates; of a vehicle, one of its axles.

    Raises
    ------
    DescriptionError, SimulationError
        For a vehicle without tyres, or a rig that cannot be tested.
    """
    standing: Rig = axle_of(rig, axle) if isinstance(rig, Vehicle) else rig
    check_rig(standing)
    return standing


def simulate_inspection(
    rig: Rig,
    tester: Tester | str | Path,
    *,
    method: str | None = None,
    steady: bool = False,
    wheel: Literal["left", "right"] = "left",
    axle: Literal["front", "rear"] = "front",
    noise: float = 0.0,
    seed: int = 0,
    vehicle: str = "",
) -> SimulatedInspection:
    """Simulate the test of a wheel, evaluate its record as if it were measured, and grade it.

    Parameters
    ----------
    rig : QuarterCar, Corner, FrontViewAxle, FullCar or HalfCar4DOF
        Rig under test.
    tester : Tester, str or Path
        Plates, programme and limits.
    method : {"eusama", "egea", "theta", "boge"}, optional
        Method whose grade decides; by default the tester's.
    steady : bool
        Whether to compute steady states, equivalent to an infinitely slow sweep without noise.
    wheel : {"left", "right"}
        Wheel of an axle; for a single wheel, its plate.
    axle : {"front", "rear"}
        Axle of a vehicle.
    noise : float
        Standard deviation of the force noise relative to the static load (1).
    seed : int
        Seed of the noise.
    vehicle : str
        Name of the vehicle, for the record.

    Returns
    -------
    SimulatedInspection
        Values, grade and the record.

    Raises
    ------
    JounceError
        For a rig that cannot be tested, an unknown method or wheel, or a failed simulation.

    Examples
    --------
    >>> from jounce.parts import load
    >>> found = simulate_inspection(load("audi-a6-quarter-car"), tester_for("eusama"), steady=True)
    >>> round(found.wheel.adhesion, 3), round(found.wheel.adhesion_frequency_hz, 1)   # 1, Hz
    (0.725, 16.6)
    """
    tester = as_tester(tester)
    deciding = _deciding(method, tester)
    stood = on_plates(rig, axle)
    modes = [wheel_mode(stood, tester, wheel=wheel, on=place) for place in ("road", "rig")]
    road, on_rig = (None if mode is None else mode.damping_ratio for mode in modes)
    record = None
    if steady:
        methods = methods_on(tester.kind) if tester.kind == "rigid-plate" else (deciding,)
        inspection = Inspection(
            (_steady_wheel(stood, tester, wheel, road, on_rig),), methods=methods
        )
    else:
        about = {"axle": axle, "vehicle": vehicle}
        record = simulate_test(stood, tester, wheel=wheel, noise=noise, seed=seed, about=about)
        inspection = evaluate(_of_wheel(record, wheel), tester)
        inspection = replace(
            inspection, wheels=tuple(item for item in inspection.wheels if item.wheel == wheel)
        )
        inspection = _with_findings(inspection, stood, tester)
    graded = grade(inspection, deciding=[deciding])
    return SimulatedInspection(graded.wheels[0], record, road, on_rig)


def simulate_axle(
    rig: Rig,
    tester: Tester | str | Path,
    *,
    method: str | None = None,
    axle: Literal["front", "rear"] = "front",
    noise: float = 0.0,
    seed: int = 0,
    vehicle: str = "",
) -> tuple[GradedInspection, xr.Dataset]:
    """Simulate the test of both wheels of an axle, one after the other, evaluate the record and grade it.

    Parameters
    ----------
    rig : FrontViewAxle, FullCar or HalfCar4DOF
        Rig under test.
    tester : Tester, str or Path
        Plates, programme and limits.
    method : {"eusama", "egea", "theta", "boge"}, optional
        Method whose grade decides; by default the tester's.
    axle : {"front", "rear"}
        Axle of a vehicle.
    noise : float
        Standard deviation of the force noise relative to the static load (1).
    seed : int
        Seed of the noise.
    vehicle : str
        Name of the vehicle, for the record.

    Returns
    -------
    graded : GradedInspection
        Values (SI), grades and differences of both wheels, from the record alone.
    record : xarray.Dataset
        Record of the simulated test.

    Raises
    ------
    JounceError
        For a rig with only one wheel, or as in `simulate_inspection`.

    Examples
    --------
    >>> from jounce.parts import load
    >>> graded, record = simulate_axle(load("audi-a6-full-car"), tester_for("egea"), axle="rear")
    >>> [wheel.verdict for wheel in graded.wheels], record.attrs["wheel_order"]
    (['pass', 'pass'], 'left, right')
    """
    tester = as_tester(tester)
    deciding = _deciding(method, tester)
    stood = on_plates(rig, axle)
    if not isinstance(stood, FrontViewAxle):
        raise SimulationError(
            "a single wheel stands on one plate only",
            where="wheel",
            found="both",
            allowed="left, right; or an axle of a vehicle",
        )
    about = {"axle": axle, "vehicle": vehicle}
    record = simulate_test(stood, tester, noise=noise, seed=seed, about=about)
    return grade(evaluate(record, tester), deciding=[deciding]), record


def _deciding(method: str | None, tester: Tester) -> str:
    """Return the method whose grade decides."""
    chosen = method or tester.method
    if chosen not in METHODS:
        raise unknown(chosen, METHODS, what="method", where="method")
    return chosen


def _of_wheel(record: xr.Dataset, wheel: str) -> xr.Dataset:
    """Return the channels of one wheel's plate; the axle's other plate did not move."""
    return record[[name for name in record.data_vars if str(name).startswith(f"{wheel}.")]]


def _with_findings(inspection: Inspection, rig: Rig, tester: Tester) -> Inspection:
    """Add findings from the description that the evaluation lacks."""
    wheel = inspection.wheels[0]
    known = {item.place.rpartition(".")[2] for item in wheel.findings}
    new = [
        item for item in findings_of_test(rig, tester) if item.place.rpartition(".")[2] not in known
    ]
    return replace(inspection, wheels=(replace(wheel, findings=(*wheel.findings, *new)),))


def _steady_wheel(
    rig: Rig, tester: Tester, wheel: str, road: float | None, on_rig: float | None
) -> WheelResult:
    findings = findings_of_test(rig, tester)
    load = float(steady_response(rig, tester, [RIGIDITY_FREQUENCY], wheel=wheel).static_load)
    values: dict[str, Any] = {"theta_road": road, "theta_rig": on_rig}
    if tester.kind == "rigid-plate":
        steady = _closed_form_values(rig, tester, wheel) if _is_linear(rig) else None
        if steady is None:
            steady, said = _swept(rig, tester, wheel)
            findings += said
        values |= steady
        findings += _end_finding(values["phase_frequency_hz"], tester, wheel)
        findings += rigidity_findings(values["tyre_rigidity"], tester, f"{wheel}.tyre_rigidity")
    uncertainty = dict.fromkeys(
        (key for key, value in values.items() if isinstance(value, float)), 0.0
    )
    uncertainty |= {key: _RESOLUTION for key in uncertainty if key.endswith("_hz")}
    poles = np.linalg.eigvals(
        linear_rig_on_tester(rig_on_tester(rig, tester, blocked=True)).A
    ).astype(complex)
    more = {"body_damping_ratio": body_damping(poles)}
    return WheelResult(
        wheel,
        static_load=load,
        uncertainty=uncertainty,
        findings=tuple(findings),
        more=more,
        **values,
    )


def _is_linear(rig: Rig) -> bool:
    """Whether lift-off of the tyre is the only nonlinearity."""
    if not isinstance(rig, QuarterCar):
        return False
    strut = rig.strut
    laws = (
        strut.spring.rate is not None
        and isinstance(strut.damper, LinearDamper)
        and rig.tyre.stiffness is not None
    )
    return (
        laws and strut.friction is None and strut.bump_stop is None and rig.guide.friction is None
    )


def _closed_form_values(rig: Rig, tester: Tester, wheel: str) -> dict[str, Any] | None:
    """Compute values in closed form; None if the wheel lifts off."""
    adhesion, at = closed_form_adhesion(rig, tester, wheel=wheel)
    if adhesion <= 0.0:
        return None
    phase, there = least_phase_angle(rig, tester, wheel=wheel)
    force = float(
        steady_response(rig, tester, [RIGIDITY_FREQUENCY], wheel=wheel).force_amplitude[0]
    )
    return {
        "adhesion": adhesion,
        "adhesion_frequency_hz": at,
        "phase_angle_min_deg": float(np.degrees(phase)),
        "phase_frequency_hz": there,
        "relative_force_amplitude": 1.0 - adhesion,
        "tyre_rigidity": tyre_rigidity(force, tester.amplitude),
        "lift_off": False,
    }


def _swept(rig: Rig, tester: Tester, wheel: str) -> tuple[dict[str, Any], list[Finding]]:
    """Compute values of periodic steady states, and findings about them."""
    sweep = steady_sweep(rig, tester, wheel=wheel)
    static = float(steady_response(rig, tester, [RIGIDITY_FREQUENCY], wheel=wheel).static_load)
    above = max(state.force_max for state in sweep.states) / static - 1.0
    values = {
        "adhesion": sweep.adhesion,
        "adhesion_frequency_hz": sweep.adhesion_frequency,
        "phase_angle_min_deg": float(np.degrees(sweep.phase_angle)),
        "phase_frequency_hz": sweep.phase_frequency,
        "relative_force_amplitude": above if sweep.lift_off else 1.0 - sweep.adhesion,
        "tyre_rigidity": tyre_rigidity(sweep.force_amplitude_25, tester.amplitude),
        "lift_off": sweep.lift_off,
    }
    findings = []
    if sweep.lift_off:
        findings.append(warning(f"{wheel}.adhesion", "lift_off"))
    restless = [state.frequency for state in sweep.states if not state.settled]
    if restless:
        span = {"low": min(restless), "high": max(restless)}
        findings.append(
            warning(f"{wheel}.steady_states", "not_periodic", float(len(restless)), **span)
        )
    return values, findings


def _end_finding(frequency: float, tester: Tester, wheel: str) -> list[Finding]:
    low, high = tester.limits.frequency_min, tester.limits.frequency_max
    if low + _RESOLUTION < frequency < high - _RESOLUTION:
        return []
    return [warning(f"{wheel}.phase_angle", "phase_at_end", frequency, frequency=frequency)]


def sweep_wear(text: str) -> list[float]:
    """Parse wears from ``first:last:step``, both ends included, or from one number.

    Raises
    ------
    SimulationError
        For any other text, or wears outside 0 to 1.

    Examples
    --------
    >>> sweep_wear("0:1:0.25")
    [0.0, 0.25, 0.5, 0.75, 1.0]
    """
    parts = text.split(":")
    try:
        numbers = [float(part) for part in parts]
    except ValueError:
        numbers = []
    good = len(numbers) in (1, 3) and all(np.isfinite(number) for number in numbers)
    if good and len(numbers) == 3:
        first, last, step = numbers
        good = (
            step > 0.0 and last >= first and (last - first) / step < 1e4
        )  # each is a simulated test
        numbers = (
            [round(first + i * step, 12) for i in range(round((last - first) / step + 1e-9) + 1)]
            if good
            else []
        )
        numbers = [number for number in numbers if number <= last + 1e-9]
    if not good or not numbers or min(numbers) < 0.0 or max(numbers) > 1.0:
        raise SimulationError(
            "not a range of wear", where="wear", found=text, allowed="FIRST:LAST:STEP within 0 to 1"
        )
    return numbers
