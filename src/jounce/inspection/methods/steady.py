"""Adhesion, phase angle and rigidity of a linear wheel in steady states: what an infinitely slow sweep would show."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import ArrayLike, NDArray

from jounce.core.types import Array
from jounce.inspection.signals.response import Corner, force_response
from jounce.testers.plates import SteadyResponse, least, least_adhesion, tyre_rigidity

Complex = NDArray[np.complex128]
Response = Callable[[ArrayLike], Complex]
_AT_END = 0.005  # Hz


@dataclass(frozen=True)
class SteadyState:
    """Values of the steady states.

    Attributes
    ----------
    adhesion : float
        Least over static tyre force (1); 0 where the linear force would be negative.
    adhesion_frequency_hz : float
        Where, Hz.
    lift_off : bool
        Whether the linear force would be negative.
    phase_angle_min_deg, phase_frequency_hz : float
        Least phase angle in degrees within the band, ends included, and where (Hz).
    phase_at_end : bool
        Whether that is an end of the band.
    relative_force_amplitude : float
        Greatest force amplitude over static load (1).
    tyre_rigidity : float
        By EGEA from the force amplitude at the highest frequency, N/m.
    """

    adhesion: float
    adhesion_frequency_hz: float
    lift_off: bool
    phase_angle_min_deg: float
    phase_frequency_hz: float
    phase_at_end: bool
    relative_force_amplitude: float
    tyre_rigidity: float


def steady_state(
    response: Response | Corner,
    static_load: float | None = None,
    *,
    amplitude: float = 3e-3,
    highest: float = 25.0,
    band: tuple[float, float] = (6.0, 18.0),
) -> SteadyState:
    """Find adhesion, least phase angle and rigidity of a linear wheel on a rigid plate.

    Parameters
    ----------
    response : callable or Corner
        Dynamic tyre force over plate height (N/m, complex) at frequencies (Hz); or the quarter car.
    static_load : float, optional
        N; that of the corner where one is given.
    amplitude : float
        Of the plate, m.
    highest : float
        Highest frequency of the test, Hz. With a damped tyre the force grows with the frequency: the limit matters.
    band : (float, float)
        Where the phase angle is searched for, Hz.

    Returns
    -------
    SteadyState
        Frequencies to 0.01 Hz.

    Examples
    --------
    >>> found = steady_state(Corner(400.0, 40.0, 25e3, 1000.0, 200e3))
    >>> round(100.0 * found.adhesion, 2), round(found.phase_angle_min_deg, 2), round(found.phase_frequency_hz, 2)
    (60.25, 57.27, 7.76)
    """
    force: Response = partial(force_response, response) if isinstance(response, Corner) else response
    own = response.static_load if isinstance(response, Corner) else 0.0
    load = own if static_load is None else static_load

    def answer(frequency: Array) -> SteadyResponse:
        return SteadyResponse(frequency, force(frequency), np.ones(frequency.size, complex), load, amplitude)

    adhesion, peak = least_adhesion(answer, highest)
    angle, at = least(lambda f: answer(f).phase_angle, *band)
    return SteadyState(
        adhesion=max(0.0, adhesion),
        adhesion_frequency_hz=peak,
        lift_off=adhesion < 0.0,
        phase_angle_min_deg=float(np.degrees(angle)),
        phase_frequency_hz=at,
        phase_at_end=min(at - band[0], band[1] - at) < _AT_END,
        relative_force_amplitude=1.0 - adhesion,
        tyre_rigidity=tyre_rigidity(float(answer(np.array([highest])).force_amplitude[0]), amplitude),
    )
