"""A run with its rig, trial and findings, and the extremes of its channels."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any

from jounce.core.display import size
from jounce.core.findings import Finding
from jounce.core.operation import Mark, Number, operation
from jounce.core.serialise import Plain, to_plain
from jounce.parts import Rig, as_rig
from jounce.parts.options import AnyRig
from jounce.recordings.options import LONGEST_STEP
from jounce.recordings.schema import extremes
from jounce.roads import Trial
from jounce.roads.options import AnyTrial
from jounce.roads.trial import trial_findings
from jounce.simulation.settings import Method, RunSettings, Start
from jounce.simulation.solve import RunOutput, solve

if TYPE_CHECKING:
    import xarray as xr


@dataclass(frozen=True)
class TrialRun(Plain):
    """A rig run over a trial.

    Attributes
    ----------
    rig : Rig
        The rig tested.
    trial : Trial
        The road or excitation.
    run : RunOutput
        Times, channels and status.
    findings : tuple of Finding
        Findings about road and loads.
    """

    rig: Rig
    trial: Trial
    run: RunOutput
    findings: tuple[Finding, ...]

    def recording(self) -> xr.Dataset:
        """Return the run as a recording, like :func:`jounce.simulate`."""
        return self.run.recording()

    @property
    def at_speed(self) -> str:
        """Speed as text preceded by "at"; empty for an excitation."""
        return "" if self.trial.speed is None else f" at {size(self.trial.speed, 'm/s', 'speed')}"

    def extremes(self) -> dict[str, dict[str, Any]]:
        """Return unit, static value, minimum and maximum (SI) with their times (s) of every channel."""
        return extremes(self.run.time, self.run.channels)

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, SI: status of the run and extremes of every channel."""
        went = {name: self.run.attributes[name] for name in ("status", "method", "steps", "events")}
        return {
            "speed": self.trial.speed,
            "duration": self.trial.duration,
            "samples": len(self.run.time),
            **went,
            "channels": self.extremes(),
            "findings": to_plain(self.findings),
        }


@operation(
    "simulate",
    named={"changes": "set"},
    faces={"output_step": "1 ms", "tolerance": "1e-5"},
    echo={
        "rig": "rig",
        "changes": "set",
        "road": "road",
        "right_road": "right_road",
        "loads": ("pitch_moment", "deceleration", "lateral_acceleration"),
        "excitation": "excitation",
    },
    offers=("recording", "figure", "report"),
    python="jounce.simulation.run:simulate",
    page="jounce.report.trial_runs:trial_run_page",
    title="{rig} on {road}{excitation}{result.at_speed}",
    doing="simulating",
    example='jounce simulate kart-quarter-car --road bump.toml --speed "1.95 m/s" --duration "3 s" --out run.nc',
)
def run_trial(
    rig: AnyRig,
    trial: AnyTrial,
    *,
    output_step: Annotated[
        float, Number("Time step of the output.", "STEP", "s", is_positive=True, most=LONGEST_STEP)
    ] = 1e-3,
    tolerance: Annotated[
        float, Number("Relative error of displacements.", "TOLERANCE", "1", is_positive=True)
    ] = 1e-5,
    method: Annotated[
        Method, Mark("Integration method: auto, explicit, or implicit (stiff rigs).", "METHOD")
    ] = "auto",
    start: Annotated[
        Start,
        Mark(
            "Start on a belt (a road with recurrence): rest, periodic, or a number of loops before.",
            "START",
        ),
    ] = "rest",
) -> TrialRun:
    """Simulate a rig or vehicle on a road or a shaker, starting from static equilibrium.

    Like :func:`jounce.simulate`, but the result also includes the trial and its findings.
    """
    rig = as_rig(rig)
    settings = RunSettings(output_step, tolerance, method)
    if start == "rest":
        run = solve(rig, trial, settings)
    else:
        from jounce.simulation.running import solved_running

        run = solved_running(rig, trial, settings, start)
    return TrialRun(rig, trial, run, tuple(trial_findings(trial, rig, output_step=output_step)))
