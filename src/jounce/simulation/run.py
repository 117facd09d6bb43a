"""Simulate a rig on a trial."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from jounce.core.findings import finding_attributes, findings_of
from jounce.parts import Rig, as_rig, rig_findings
from jounce.roads import HoldsTrial, Trial, as_trial
from jounce.simulation.settings import Method, RunSettings, Start
from jounce.simulation.solve import solve

if TYPE_CHECKING:
    import xarray as xr

    from jounce.simulation.controlled import AnyControl


def simulate(
    rig: Rig | str | Path,
    trial: Trial | HoldsTrial,
    *,
    output_step: float = 1e-3,
    tolerance: float = 1e-5,
    method: Method = "auto",
    offset: dict[str, float] | None = None,
    detail: bool = False,
    check: bool = True,
    control: AnyControl | None = None,
    start: Start = "rest",
) -> xr.Dataset:
    """Simulate a rig over a trial, from static equilibrium or on a belt that is already running.

    Parameters
    ----------
    rig : Rig, str or Path
        A rig or vehicle, its file, or its name in the library.
    trial : Trial
        Road and speed, or a base motion, and the duration.
    output_step, tolerance, method : float, float, {"auto", "explicit", "implicit"}
        As in :class:`jounce.simulation.RunSettings`: s, 1. ``attrs["method"]`` is the method used.
    offset : dict, optional
        Initial offset from equilibrium: m or m/s (rad, rad/s) by state, e.g. ``"sprung.z"`` or ``"sprung.vz"``
        (`equilibrium` returns the names); at rest by default.
    detail : bool
        For 3-D corners, also on a car: add all hardpoints and the contact point (m), joint reactions (N, N m, on the
        second body, ground axes) and energies (J). No effect for lumped rigs.
    check : bool
        Raise if the run stops before its end; otherwise ``attrs["status"]`` reports how it ended.
    control : Controller, str, Path or callable, optional
        Controller of all struts (see ``jounce.control``): a controller, its name (``"skyhook"``), a TOML file, or a
        function ``control(measurement, t) -> command``. Adds ``command`` and ``actuator.force`` (N) of every corner.
    start : {"rest", "periodic"} or int
        Start on a road with a ``recurrence``, the length of a belt (m): at rest, after the given number of loops, or
        after enough loops for the transient from rest to decay.

    Returns
    -------
    xarray.Dataset
        One variable for each channel on ``time`` (s), with ``units`` (SI), ``long_name`` and ``place``. z is up,
        deflections and forces are positive in compression, accelerations are kinematic (zero at rest).
        ``attrs["findings"]``, if present, contains the warnings of :func:`jounce.parts.rig_findings`.

    Raises
    ------
    SimulationError
        If there is no equilibrium or, with ``check``, the run stops before its end.

    Examples
    --------
    >>> import jounce as jn
    >>> trial = jn.Trial(road=jn.HalfSine(height="10 mm", length="60 mm"), speed="1.95 m/s", duration="1 s")
    >>> run = jn.simulate(jn.load("kart-quarter-car"), trial)
    >>> bool(run["tyre.force"].min() == 0.0)   # the tyre lifts off
    True
    """
    settings, rig = RunSettings(output_step, tolerance, method), as_rig(rig)
    more: dict[str, Any] = {"offset": offset, "detail": detail, "check": check, "control": control}
    if start == "rest":
        run = solve(rig, as_trial(trial), settings, **more)
    else:
        from jounce.simulation.running import solved_running

        run = solved_running(rig, as_trial(trial), settings, start, **more)
    warnings = [item for item in rig_findings(rig) if item.severity != "note"]
    dataset = run.recording()
    return (
        dataset.assign_attrs(finding_attributes([*warnings, *findings_of(dataset.attrs)]))
        if warnings
        else dataset
    )
