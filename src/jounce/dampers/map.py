"""The map of a damper: force over velocity and clicks from a folder of records."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Any, get_args

import numpy as np

from jounce.core.errors import FitError, JounceError, unknown
from jounce.core.findings import Finding, finding
from jounce.core.operation import File, Mark, operation
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.dampers.adjusters import LEVEL, adjusters_of, adjusters_over, is_clicks, place_of
from jounce.dampers.curves import DamperSetting, Reading, curve_of, usual_reading, with_rest
from jounce.dampers.exports import PeakTable
from jounce.dampers.files import (
    AnyDynoFiles,
    Settings,
    UnreadFile,
    as_dyno_files,
    common_settings,
    read_settings,
    settings_of,
)
from jounce.dampers.loops import mean_of
from jounce.dampers.peaks import curve_of_peaks
from jounce.dampers.runs import DynoRun, ReadRun, left_out, read_run, summary_of, turned_by_gas
from jounce.dampers.tables import map_table
from jounce.identify.signs import ForcePositive, StrokePositive

_UNLIKE = 3.0  # factor between a force and that of other records of its setting: a wrong unit, or another damper
_ENOUGH = 3  # records of a setting, from which one can differ from the others
_SWAPPED = (
    0.2  # share of the force by which a record whose bump is the others' rebound differs from them
)
_ALIKE, _CLEARER = 0.15, 0.4
"""Largest difference of such a record when it is turned, as a share of the force and of its difference as it is."""
_SMOOTH = 1e-3  # m/s: a hundredth of slow body motion; seals stick below


@dataclass(frozen=True)
class CurveAt(Plain):
    """Force over velocity between measured clicks.

    Attributes
    ----------
    clicks : float
        Clicks [1]; NaN for those of several adjusters.
    velocity, force, low, high : array (n,)
        Velocity (m/s), force without gas (N) and its 95 % interval (N); NaN where it is unknown.
    """

    clicks: float
    velocity: Array
    force: Array
    low: Array
    high: Array


@dataclass(frozen=True)
class DamperMap(Plain):
    """The map of a damper, SI, compression positive.

    Attributes
    ----------
    reading : {"peak", "continuous"}
        How the loops were read: one point a cycle at peak velocity (PVP), or the whole loop (CVP).
    settings : tuple of DamperSetting
        One for each setting, by clicks.
    runs : tuple of DynoRun
        The records.
    findings : tuple of Finding
        Findings of the reader, of the records and of the map.
    """

    reading: Reading
    settings: tuple[DamperSetting, ...]
    runs: tuple[DynoRun, ...]
    findings: tuple[Finding, ...]

    @property
    def adjusters(self) -> tuple[str, ...]:
        """Adjusters that were moved; empty if settings do not state their clicks, or several state the same."""
        return adjusters_of(self.settings)

    @property
    def clicks(self) -> tuple[float, ...]:
        """Measured clicks of the adjuster that was moved, ascending; empty if there is none, or several."""
        moved = self.adjusters
        if len(moved) != 1:
            return ()
        return tuple(item.settings[moved[0]] for item in self.settings)

    @property
    def velocity(self) -> Array:
        """Velocities (m/s) at which all settings are known."""
        return shared_velocity(self.settings)

    @property
    def damper(self) -> dict[str, Any]:
        """Table to write under ``strut.damper``, SI: over clicks if one adjuster was moved, set to the middle ones.

        Of several adjusters it is the first setting; :func:`jounce.choose_clicks` gives the table of any other.
        """
        if not self.clicks:
            return self.settings[0].damper
        rows = []
        for item in self.settings:
            table = item.damper
            velocity, _ = with_rest(self.velocity, self.velocity)
            rows.append(np.interp(velocity, table["velocity"], table["force"]).tolist())
        return {
            "kind": "clicks",
            "clicks": self.clicks[len(self.clicks) // 2],
            "measured_clicks": list(self.clicks),
            "velocity": velocity.tolist(),
            "force": rows,
        }

    @property
    def friction(self) -> dict[str, float] | None:
        """Table to write under ``strut.friction``, SI: the mean of all settings; None if no record shows it."""
        forces = [item.friction.value for item in self.settings if item.friction.value > 0.0]
        if not forces:
            return None
        return {"force": float(np.mean(forces)), "regularisation_velocity": _SMOOTH}

    def at(self, clicks: float | Mapping[str, float]) -> CurveAt:
        """Return the curve at clicks between measured ones.

        Its interval adds those of the measured settings and the error of the interpolation, which is told from how
        well neighbours predict each measured setting between them; between two settings alone nothing tells it.
        Where only some combinations of several adjusters were measured, their effects are added, and by how much they
        would differ if they multiplied counts as an error.

        Parameters
        ----------
        clicks : float or mapping of str to float
            Clicks, within the measured ones; of several adjusters by name (``bump_clicks``).

        Raises
        ------
        DescriptionError
            If the map has no clicks, or they lie beyond the measured ones.
        """
        over = adjusters_over(self.settings, self.velocity)
        place = place_of(over, clicks)
        (force,), (error,) = over.at(place)
        half = LEVEL * error
        value = math.nan if isinstance(clicks, Mapping) else float(clicks)
        return CurveAt(value, over.velocity, force, force - half, force + half)

    def table(self) -> str:
        """Write all settings as CSV, SI, for other programs and :func:`jounce.read_damper_map`."""
        return map_table(self.settings)

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, SI, with the tables for a rig."""
        return {**super().to_dict(), "damper": self.damper, "friction": self.friction}


@operation(
    "damper map",
    echo={"files": "measured"},
    offers=("table", "figure", "report"),
    page="jounce.report.dampers:damper_map_page",
    title="Damper map",
    doing="reading",
    example="jounce damper map dyno --settings settings.csv --report damper.html",
)
def damper_map(
    files: AnyDynoFiles,
    settings: Annotated[
        str | Path | Mapping[str, Mapping[str, float | str]] | None,
        File(
            r"Table of the settings of each file: file, clicks, temperature \[degC], gas pressure \[bar]."
        ),
    ] = None,
    *,
    reading: Annotated[
        Reading | None,
        Mark(
            "One point a cycle at peak velocity, or the whole loop; default: what the records allow.",
            "peak|continuous",
        ),
    ] = None,
    stroke_positive: Annotated[
        StrokePositive | None,
        Mark(
            "Positive direction of the stroke; default: found from the gas force, else compression.",
            "compression|extension",
        ),
    ] = None,
    force_positive: Annotated[
        ForcePositive | None,
        Mark("Positive direction of the force; likewise.", "compression|tension"),
    ] = None,
) -> DamperMap:
    """Make the map of a damper from the records of a test rig: force over velocity, for each setting.

    Records of sine, crank, triangle, ramp and random motion, of one or several velocities and settings, in one folder.
    Settings are taken from a table, from channels ``clicks`` and ``gas_pressure``, or from the names of files
    ("front_8clicks_40degC.csv"). A file that cannot be used is a finding; the others are used.

    Parameters
    ----------
    files : sequence of RecordFile, str or Path
        Records with ``displacement`` (m) and ``force`` (N) over time (s), and ``velocity`` (m/s) if recorded; folders
        of them.
    settings : str, Path or mapping, optional
        Table with a column ``file`` and columns ``clicks`` (of several adjusters ``bump clicks``, ``low-speed rebound
        clicks``, ...), ``temperature`` and ``gas pressure``; or these by the name of each file, SI or with a unit.
    reading : {"peak", "continuous"}, optional
        Read one point a cycle at peak velocity (PVP), or the whole loop (CVP). By default "peak" if every setting was
        run at three peak velocities or more.
    stroke_positive, force_positive : str, optional
        Positive direction of the stroke ("compression", "extension") and of the force ("compression", "tension") in
        all records.

    Returns
    -------
    DamperMap
        Force over velocity at each setting with its interval; gas force, friction and lag; findings. Intervals contain
        the scatter of cycles and of records, not errors of the load cell and of the stroke's calibration.

    Raises
    ------
    FitError
        If no record can be used.
    RecordingError, DescriptionError
        If the table of settings cannot be read.

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> t = np.arange(0.0, 20.0, 1e-3)
    >>> def sine(speed):
    ...     x, v = speed / 10.0 * np.sin(10.0 * t), speed * np.cos(10.0 * t)
    ...     force = np.where(v > 0.0, 800.0, 1600.0) * v + 5.0 * np.random.default_rng(1).standard_normal(len(t))
    ...     channels = {"displacement": (x, "m", ""), "velocity": (v, "m/s", ""), "force": (force, "N", "")}
    ...     return jn.recording(t, channels)
    >>> records = [jn.RecordFile(f"{speed}.csv", sine(speed)) for speed in (0.05, 0.13, 0.26)]
    >>> made = jn.damper_map(records)
    >>> made.reading, (made.settings[0].force / made.settings[0].velocity)[[0, -1]].round(-1).tolist()
    ('peak', [1600.0, 800.0])
    """
    if reading not in (None, *get_args(Reading)):
        raise unknown(str(reading), get_args(Reading), what="reading", where="reading")
    table = read_settings(settings)
    findings: list[Finding] = []
    runs: list[ReadRun] = []
    peaks: list[PeakTable] = []
    for item in as_dyno_files(files):
        if isinstance(item, UnreadFile):
            findings.append(left_out(item.path, item.error))
            continue
        try:
            stated, more = settings_of(item, table)
            if isinstance(item, PeakTable):
                peaks.append(
                    replace(item, settings=stated).with_signs(stroke_positive, force_positive)
                )
            else:
                runs.append(
                    read_run(
                        item, stated, stroke_positive=stroke_positive, force_positive=force_positive
                    )
                )
                # What a record check says with its consequence for a damper is said once.
                findings += [each for each in item.findings if each.code != "recordings.clipped"]
        except JounceError as error:
            findings.append(left_out(item.path, error))
            continue
        findings += more
    if not runs and not peaks:
        raise FitError(
            "no record of a damper can be used", where="files",
            found="; ".join(item.message for item in findings[:3]) or "nothing",
        )  # fmt: skip
    if stroke_positive is None and force_positive is None:
        runs = turned_by_gas(runs)
    common = common_settings([run.settings for run in runs] + [item.settings for item in peaks])
    groups: dict[Settings, list[ReadRun]] = {}
    tables: dict[Settings, list[PeakTable]] = {}
    for run, key in zip(runs, common, strict=False):
        groups.setdefault(key, []).append(run)
    for item, key in zip(peaks, common[len(runs) :], strict=True):
        if key in groups:
            findings.append(finding("dampers.peaks_and_records", Path(item.path).name))
        else:
            tables.setdefault(key, []).append(item)
    alike = {key: _alike(group, findings) for key, group in groups.items()}
    used = [run for group in alike.values() for run in group]
    chosen = reading or usual_reading(list(alike.values()))
    largest = max((run.peak for run in used), default=0.0)
    curves: list[DamperSetting] = []
    for key in sorted({**alike, **tables}, key=_clicks_of):
        if key in tables:
            curve = curve_of_peaks(tables[key], findings)
        else:
            curve = curve_of(alike[key], chosen, largest, findings)
        if len(curve.velocity) > 1:
            curves.append(replace(curve, settings=dict(key)))
        else:
            findings.append(finding("dampers.no_curve", curve.files[0]))
    if not curves:
        raise FitError(
            "no setting has enough cycles for a curve", where="files", found=next((run.file for run in runs), ""),
            allowed="three cycles at each velocity",
        )  # fmt: skip
    summaries = tuple(summary_of(run) for run in used)
    findings += [item for run in used for item in run.findings]
    made = DamperMap(chosen, tuple(curves), summaries, ())
    if len(curves) > 1 and not made.adjusters:
        findings.append(finding("dampers.settings_unknown", "settings", len(curves)))
    return replace(made, findings=(*findings, *_mixed(made)))


def shared_velocity(curves: Sequence[DamperSetting | CurveAt]) -> Array:
    """Return the velocities (m/s) of curves between the slowest and fastest that all of them have."""
    low = max(float(item.velocity[0]) for item in curves)
    high = min(float(item.velocity[-1]) for item in curves)
    union = np.unique(np.concatenate([item.velocity for item in curves]))
    inside = union[(union >= low) & (union <= high)]
    gap = 0.005 * (high - low)
    kept = [float(value) for value in inside[:1]]
    for value in inside[1:]:
        if value - kept[-1] > gap:
            kept.append(float(value))
    return np.array(kept)


def _clicks_of(settings: Settings) -> list[float]:
    return [value for name, value in settings if is_clicks(name)]


def _mixed(made: DamperMap) -> Iterator[Finding]:
    """Name what differs between settings beside their clicks, and so counts as an effect of them."""
    for name in ("temperature", "gas_pressure") if made.adjusters else ():
        stated = [item.settings[name] for item in made.settings if name in item.settings]
        if stated and (len(stated) < len(made.settings) or len(set(stated)) > 1):
            yield finding("dampers.conditions_differ", name, name=name)


def _alike(runs: list[ReadRun], findings: list[Finding]) -> list[ReadRun]:
    """Leave out records that differ from the others of their setting as a wrong unit or sign does."""
    if len(runs) < _ENOUGH:
        return runs
    points = [_net_peaks(run) for run in runs]
    rates = [float(np.ptp(force) / np.ptp(speed)) for speed, force in points]
    usual_rate, usual_peak = float(np.median(rates)), float(np.median([run.peak for run in runs]))
    kept = []
    for k, (run, rate) in enumerate(zip(runs, rates, strict=True)):
        factor = rate / usual_rate
        limit = _UNLIKE * max(
            run.peak / usual_peak, usual_peak / run.peak
        )  # no valve bends a curve more
        if 1.0 / limit < factor < limit:
            kept.append(k)
        else:
            findings.append(finding("dampers.unlike_others", run.file, factor, factor=factor))
    turned = [
        k
        for k in kept
        if len(kept) >= _ENOUGH and _is_turned(points[k], [points[i] for i in kept if i != k])
    ]
    findings += [finding("dampers.bump_is_rebound", runs[k].file) for k in turned]
    return [runs[k] for k in kept if k not in turned] or runs


def _is_turned(own: Array, points: Sequence[Array]) -> bool:
    """Whether a record is like the others only with bump and rebound exchanged.

    The slowest and the fastest are not judged: bump may overtake rebound where no other record is.
    """
    velocity, force = own
    speeds = [float(np.ptp(item[0])) for item in points]
    if not min(speeds) <= float(np.ptp(velocity)) <= max(speeds):
        return False
    others = np.concatenate(points, axis=1)
    away, away_turned = (
        float(np.abs(force - line).sum() / np.abs(line).sum())
        for line in (_usual(velocity, *others), -_usual(-velocity[::-1], *others)[::-1])
    )
    return away > _SWAPPED and away_turned < min(_ALIKE, _CLEARER * away)


def _net_peaks(run: ReadRun) -> Array:
    """Return peak velocities (m/s) in rebound and bump, and their forces without a static force (N): (2, 2)."""
    velocity, force = (mean_of(item.T)[::-1] for item in run.peak_forces)
    return np.array([velocity, force - run.rest.value])


def _usual(velocity: Array, known: Array, force: Array) -> Array:
    """Return forces at velocities by ``a v + b sqrt(v)`` on either side; a stray point counts little in the fit."""
    usual = np.empty(len(velocity))
    for sign in (-1.0, 1.0):
        side, at = sign * known > 0.0, sign * velocity > 0.0
        basis = np.stack([np.abs(known[side]), np.sqrt(np.abs(known[side]))], axis=1)
        weight = np.ones(int(side.sum()))
        for _ in range(_ROUNDS):
            solution, *_rest = np.linalg.lstsq(
                basis * weight[:, np.newaxis], force[side] * weight, rcond=None
            )
            away = np.abs(force[side] - basis @ solution)
            weight = 1.0 / np.sqrt(np.maximum(away, 1e-3 * np.median(np.abs(force[side]))))
        usual[at] = (
            np.stack([np.abs(velocity[at]), np.sqrt(np.abs(velocity[at]))], axis=1) @ solution
        )
    return usual


_ROUNDS = 10  # of reweighting
