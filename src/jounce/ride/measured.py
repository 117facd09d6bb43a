"""Ride metrics of a recording, with findings on the recording."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any

from jounce.core.findings import Finding
from jounce.core.operation import Mark, Number, operation
from jounce.core.serialise import Plain, to_plain
from jounce.parts import as_rig
from jounce.parts.options import MaybeRig
from jounce.recordings.options import AnyRecording
from jounce.ride.metrics import RideMetrics, ride_metrics
from jounce.ride.weighting import Start


@dataclass(frozen=True)
class MeasuredRide(Plain):
    """Metrics of a recorded ride.

    Attributes
    ----------
    metrics : RideMetrics
        Ride metrics, SI.
    findings : tuple of Finding
        Findings of the reader and of the metrics.
    """

    metrics: RideMetrics
    findings: tuple[Finding, ...]

    @property
    def extent(self) -> str:
        """Evaluated time and sample rate, in words."""
        return f"{self.metrics.duration:g} s at {self.metrics.sample_rate:g} Hz"

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, SI: metrics by name and place."""
        values: dict[str, dict[str, float]] = {}
        for item in self.metrics.values:
            values.setdefault(item.metric, {})[item.place] = item.value
        return {
            "duration": self.metrics.duration,
            "settling": self.metrics.settling,
            "sample_rate": self.metrics.sample_rate,
            "metrics": values,
            "comfort": self.metrics.comfort,
            "absent": to_plain(self.metrics.absent),
            "findings": to_plain(self.findings),
        }


@operation(
    "ride-metrics",
    faces={"settling": "0 s", "exposure": "8 h", "lift_off_load": "0 N"},
    echo={"record": "record", "vehicle": "vehicle"},
    page="jounce.report.ride:measured_ride_page",
    title="Ride metrics of {record}",
    example='jounce ride-metrics lap.csv --columns seat.az="AccZ [g]" --settling "5 s"',
)
def measured_ride(
    recording: AnyRecording,
    rig: MaybeRig = None,
    *,
    settling: Annotated[
        float | str, Number('Time at the start that does not count, e.g. "5 s".', "TIME", "s")
    ] = 0.0,
    start: Annotated[
        Start,
        Mark(
            "What was before the record: rest, first or mean (for signals with gravity in them).",
            "START",
        ),
    ] = "mean",
    exposure: Annotated[
        float | str,
        Number("Daily duration of the vibration, for A(8).", "TIME", "s", is_positive=True),
    ] = "8 h",
    lift_off_load: Annotated[
        float | str, Number("Wheel load up to which a tyre counts as lifted.", "FORCE", "N")
    ] = 0.0,
) -> MeasuredRide:
    """Compute ride metrics of a measured or simulated record: weighted accelerations, travel, road holding.

    Findings report errors that level and spectrum reveal: filters, coarse steps, swapped channels, m/s² given as g.

    Parameters
    ----------
    recording : tuple of xarray.Dataset and list of Finding
        Recording and findings as returned by :func:`jounce.read_recording`.
    rig : Rig, str or Path, optional
        Rig or vehicle of the ride; supplies the gaps of bump and rebound stops.
    settling : float or str
        Time skipped at the start, s.
    start : {"rest", "first", "mean"}
        State before the record, as for :func:`jounce.ride_metrics`.
    exposure : float or str
        Daily duration of the vibration, s.
    lift_off_load : float or str
        Wheel load up to which a tyre is considered lifted off, N.

    Returns
    -------
    MeasuredRide
        Metrics in SI, with findings.

    Examples
    --------
    >>> import jounce as jn
    >>> trial = jn.iso_trial(jn.load("audi-a6-quarter-car"), "C", "20 m/s", duration="10 s").trial
    >>> run = jn.simulate("audi-a6-quarter-car", trial)
    >>> 0.5 < measured_ride((run, []), settling="1 s").metrics.value("weighted_rms") < 3.0
    True
    """
    run, notes = recording
    chosen = None if rig is None else as_rig(rig)
    choices: dict[str, Any] = {"settling": settling, "start": start, "exposure": exposure}
    metrics = ride_metrics(run, chosen, lift_off_load=lift_off_load, **choices)
    known = {(finding.severity, finding.message) for finding in notes}
    more = [
        finding for finding in metrics.findings if (finding.severity, finding.message) not in known
    ]
    return MeasuredRide(metrics, (*notes, *more))
