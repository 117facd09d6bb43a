"""Why methods disagree about a wheel: its load, its tyre, limits that mean different damping."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from jounce.inspection.methods.steady import steady_state
from jounce.inspection.result import WheelResult
from jounce.inspection.verdicts.limits import VERDICTS, Band, Limits
from jounce.inspection.verdicts.reasons import Reason

USUAL_TYRE = 200e3
"""Stiffness of a usual car tyre, N/m; that of the reference car on which the methods were compared."""
_ALIKE = 0.05


def explain(wheel: WheelResult, bands: Mapping[str, Band], limits: Limits) -> list[Reason]:
    """Say why methods disagree about a wheel.

    Parameters
    ----------
    wheel : WheelResult
        Its values.
    bands : mapping of str to Band
        By method.
    limits : Limits
        Where the bands are from.

    Returns
    -------
    list of Reason
        Empty where all verdicts are the same.
    """
    if len({band.verdict for band in bands.values()}) < 2:
        return []
    found = [Reason("disagree", "", {"grades": tuple(bands.items())})]
    rank = {method: VERDICTS.index(band.verdict) for method, band in bands.items()}
    others = {method: value for method, value in rank.items() if method != "eusama"}
    if "eusama" in rank and all(value != rank["eusama"] for value in others.values()):
        found += _of_adhesion(wheel, limits)
    if "egea" in rank and "theta" in rank and rank["egea"] != rank["theta"]:
        found.append(Reason("limits_differ"))
    return found


def _of_adhesion(wheel: WheelResult, limits: Limits) -> list[Reason]:
    found = []
    limit = limits.methods["eusama"].passing_from()
    if wheel.lift_off or wheel.adhesion == 0.0:
        found.append(Reason("lifted"))
    elif wheel.adhesion is not None and wheel.static_load is not None and limit is not None and limit < 1.0:
        force = (1.0 - wheel.adhesion) * wheel.static_load
        values = {"force": force, "load": wheel.static_load, "needed": force / (1.0 - limit)}
        found.append(Reason("mass", "", {**values, "limit": limit, "criterion": limits.methods["eusama"]}))
    return found + _of_tyre(wheel)


def _of_tyre(wheel: WheelResult) -> list[Reason]:
    """Adhesion with a usual tyre, by the model of the record; without one, what the tyre does in general."""
    amplitude = np.nan
    if wheel.curves is not None and wheel.curves.plate_amplitude.size:
        amplitude = float(np.nanmax(wheel.curves.plate_amplitude, initial=np.nan))
    if wheel.corner is None or not np.isfinite(amplitude):
        if wheel.tyre_rigidity is None:
            return []
        return [Reason("rigidity", "", {"rigidity": 1e-3 * wheel.tyre_rigidity})]
    stiffness = wheel.corner.tyre_stiffness
    if abs(stiffness / USUAL_TYRE - 1.0) < _ALIKE:
        return []
    usual = steady_state(replace(wheel.corner, tyre_stiffness=USUAL_TYRE), wheel.static_load, amplitude=amplitude)
    values = {"usual": 1e-3 * USUAL_TYRE, "stiffness": 1e-3 * stiffness}
    return [Reason("tyre", "", {**values, "adhesion": usual.adhesion, "phase": usual.phase_angle_min_deg})]
