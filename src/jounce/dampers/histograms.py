"""Histograms of dampers from the track: how long each stood at which travel and moved at which velocity."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, get_args

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import DescriptionError, JounceError, RecordingError, unknown
from jounce.core.files import existing_file, matching_files
from jounce.core.findings import Finding, finding
from jounce.core.operation import File, Mark, Number, Pairs, Texts, operation
from jounce.core.serialise import Plain, plain_table
from jounce.core.types import Array
from jounce.core.units import positive_si, to_si
from jounce.dampers.corners import ALONE, AXLES, CORNERS, Place, corner_named
from jounce.dampers.counting import (
    COVERED,
    FASTEST_BIN,
    FINE,
    MOST_BINS,
    CountedCorner,
    CountedTrack,
    FineCounts,
    count_track,
    nice_width,
)
from jounce.dampers.runs import left_out
from jounce.dampers.track import Division, TrackOptions, distances, read_track
from jounce.identify.estimate import student_factor
from jounce.recordings.options import RESAMPLE, SAMPLE_TIME, SENSORS, VARIABLE

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

    from jounce.recordings.options import RecordFile

ZONES = ("high rebound", "low rebound", "low bump", "high bump")
"""Ranges of velocity, from fast extension to fast compression."""
_SHIFTED = 1e-3  # m: shift of the model's travel that is named
_WIDE = 0.05  # change of a share by noise from which it is a warning

TrackRecord = Annotated[
    "Sequence[xr.Dataset | pd.DataFrame | RecordFile | tuple[xr.Dataset, list[Finding]] | str | Path]"
    " | xr.Dataset | pd.DataFrame | RecordFile | str | Path",
    Texts("Records from the track; several are shown side by side.", "FILE..."),
]


@dataclass(frozen=True)
class DamperHistograms(Plain):
    """How long each damper stood at which travel, and moved at which velocity.

    Attributes
    ----------
    data : xarray.Dataset
        Shares of time (1) over ``record``, ``section`` ("whole", "lap 1", "sector 2" ...) and ``corner``; bump is
        positive. ``travel_share`` over ``travel`` (m) and ``velocity_share`` over ``velocity`` (m/s), the middles of
        their bins; the first and the last bin also contain everything beyond. ``zone_share`` over ``zone`` ("high
        rebound", "low rebound", "low bump", "high bump"), with the half width of its 95 % interval
        (``zone_share_half``) and what the noise adds to it (``noise_share``), both for the whole record.
        ``mean_travel``, ``least_travel``, ``largest_travel`` (m); ``rms_velocity``, ``mean_bump_velocity``,
        ``mean_rebound_velocity``, ``largest_bump_velocity``, ``largest_rebound_velocity`` (m/s, rebound negative);
        ``velocity_noise`` (m/s, r.m.s.); ``duration`` (s). ``balance`` is the zone share of the front minus that of the
        rear, ``velocity_ratio`` the r.m.s. velocity of the front over that of the rear. ``travel_overlap`` and
        ``velocity_overlap`` (1) compare each record with the last, if it is the model's. NaN where nothing is known.
    low_speed : float
        Velocity (m/s) up to which motion is low speed.
    cutoff, passband : dict of str to float
        For each record, the frequencies (Hz) at which the velocity has half of its amplitude left, and up to which it
        errs by less than 1 %; 0 of a velocity as recorded.
    measured_at : dict of str to str
        For each corner "damper" or "wheel": whose travel is shown.
    beside : str
        Name of the record in ``data`` that is the model's; empty without one.
    findings : tuple of Finding
        What was guessed, found, mended or left out.
    """

    left_out = ("data",)
    data: xr.Dataset
    low_speed: float
    cutoff: dict[str, float]
    passband: dict[str, float]
    measured_at: dict[str, str]
    beside: str
    findings: tuple[Finding, ...]

    @property
    def records(self) -> list[str]:
        """Names of the records, the model's last."""
        return [str(name) for name in self.data["record"].to_numpy()]

    @property
    def corners(self) -> list[str]:
        """Names of the corners."""
        return [str(name) for name in self.data["corner"].to_numpy()]

    @property
    def sections(self) -> list[str]:
        """The whole record, then its laps or sectors."""
        return [str(name) for name in self.data["section"].to_numpy()]

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, SI: each quantity with its unit, its dimensions and its values."""
        quantities = {
            str(name): {
                "units": str(self.data[name].attrs.get("units", "")),
                "dimensions": [str(along) for along in self.data[name].dims],
                "values": self.data[name].to_numpy(),
            }
            for name in (*self.data.coords, *self.data.data_vars)
        }
        return {**super().to_dict(), **plain_table(quantities)}

    def table(self) -> str:
        """Write the shares of all bins and zones as CSV: one row for each record, section, corner and bin, SI."""
        lines = ["record,section,corner,quantity,from,to,share"]
        edges = {
            "travel": edges_of(self.data["travel"].to_numpy()),
            "velocity": edges_of(self.data["velocity"].to_numpy()),
        }
        units = {"travel": "travel [m]", "velocity": "velocity [m/s]"}
        for place in self._places():
            for name, ends in edges.items():
                shares = self.data[f"{name}_share"].sel(place).to_numpy()
                if np.isfinite(shares).all():
                    lines += [
                        f"{_cells(place)},{units[name]},{low:.9g},{high:.9g},{share:.9g}"
                        for low, high, share in zip(ends[:-1], ends[1:], shares, strict=True)
                    ]
            zones = self.data["zone_share"].sel(place).to_numpy()
            if np.isfinite(zones).all():
                limits = (-math.inf, -self.low_speed, 0.0, self.low_speed, math.inf)
                lines += [
                    f"{_cells(place)},{zone},{low:.9g},{high:.9g},{share:.9g}"
                    for zone, low, high, share in zip(
                        ZONES, limits[:-1], limits[1:], zones, strict=True
                    )
                ]
        return "\n".join(lines) + "\n"

    def _places(self) -> Iterator[dict[str, str]]:
        for record in self.records:
            for section in self.sections:
                for corner in self.corners:
                    yield {"record": record, "section": section, "corner": corner}


def _cells(place: Mapping[str, str]) -> str:
    return ",".join(
        f'"{text}"' if "," in text or '"' in text else text
        for text in (value.replace('"', '""') for value in place.values())
    )


def edges_of(middles: Array) -> Array:
    """Return the edges of bins of equal width from their middles.

    >>> edges_of(np.array([-0.5, 0.5])).tolist()
    [-1.0, 0.0, 1.0]
    """
    width = float(middles[1] - middles[0]) if middles.size > 1 else 1.0
    return np.append(middles - 0.5 * width, middles[-1] + 0.5 * width)


@operation(
    "damper histogram",
    named={
        "channels": "channel",
        "begin": "from",
        "end": "to",
        "division": "by",
        "reversed_corners": "reversed",
        "sector_ends": "sector_end",
        "shown_at": "at",
    },
    offers=("table", "figure", "report"),
    page="jounce.report.damper_histograms:damper_histogram_page",
    title="Damper histograms",
    doing="counting",
    example="jounce damper histogram lap.ld --beside run.nc --report histograms.html",
)
def damper_histograms(  # noqa: PLR0913 - independent options
    records: TrackRecord,
    *,
    channels: Annotated[
        Mapping[str, str] | None,
        Pairs(
            r'Column of a corner, with its unit if the header gives none: front_left="Damper FL \[mm]". Repeat it.',
            "CORNER=COLUMN",
            'front_left="Damper FL [mm]"',
        ),
    ] = None,
    beside: Annotated[
        xr.Dataset
        | pd.DataFrame
        | RecordFile
        | tuple[xr.Dataset, list[Finding]]
        | str
        | Path
        | None,
        File("Record of the model on the same road, to be shown beside: a run that jounce wrote."),
    ] = None,
    division: Annotated[
        Division, Mark("Also show laps, sectors, or only the whole record.", "laps|sectors|whole")
    ] = "laps",
    sector_ends: Annotated[
        Sequence[float | str] | None,
        Texts(
            'Distance from the start of a lap at which a sector ends: "800 m". Repeat it.',
            "DISTANCE",
        ),
    ] = None,
    low_speed: Annotated[
        float | str,
        Number(
            'Velocity up to which motion is low speed, e.g. "25 mm/s".',
            "VELOCITY",
            "m/s",
            is_positive=True,
        ),
    ] = 0.025,
    cutoff: Annotated[
        float | str,
        Number(
            'Frequency up to which travel is differentiated, e.g. "60 Hz".',
            "FREQUENCY",
            "Hz",
            is_positive=True,
        ),
    ] = 60.0,
    measured_at: Annotated[
        Place | None,
        Mark(
            "Where the sensors are; default: told from the names, else the damper.", "damper|wheel"
        ),
    ] = None,
    shown_at: Annotated[
        Place | None,
        Mark("Whose travel is shown; default: as measured. Needs a motion ratio.", "damper|wheel"),
    ] = None,
    motion_ratio: Annotated[
        Mapping[str, float] | float | None,
        Pairs(
            "Damper travel over wheel travel, of a corner, an axle or all: front=0.9.",
            "CORNER=RATIO",
            "front=0.9",
        ),
    ] = None,
    stroke: Annotated[
        float | str | None,
        Number('Available stroke of the damper, e.g. "75 mm".', "LENGTH", "m", is_positive=True),
    ] = None,
    reversed_corners: Annotated[
        Sequence[str] | str,
        Texts("Corner whose sensor grows in rebound; an axle, or all. Repeat it.", "CORNER"),
    ] = (),
    begin: Annotated[
        float | str | None, Number('Ignore samples before this time, e.g. "30 s".', "TIME", "s")
    ] = None,
    end: Annotated[
        float | str | None, Number("Ignore samples after this time.", "TIME", "s")
    ] = None,
    variable: Annotated[str, VARIABLE] = "",
    sample_time: Annotated[float | str | None, SAMPLE_TIME] = None,
    resample: Annotated[float | str | None, RESAMPLE] = None,
    sensors: Annotated[str | Path | None, SENSORS] = None,
) -> DamperHistograms:
    """Make histograms of the travel and velocity of dampers from records of the track.

    Each sample counts as its share of time. Channels are named, or guessed from their names ("Damper FL",
    "LFshockDefl", "Federweg VL", "front_left.strut.deflection"); what was guessed is a finding. Velocity is the
    derivative of the travel, with zero phase, up to ``cutoff``. What cannot be used is a finding; the rest is used.

    Parameters
    ----------
    records : sequence of recordings or files, or one
        Recordings with the travel of dampers or wheels (any unit of length), or with their velocity.
    channels : mapping of str to str, optional
        Column of each corner: "front_left", "FL", "front", ... to ``"name"`` or ``"name [unit]"``. Corners that are not
        named are guessed.
    beside : recording or file, optional
        A model's run on the same road, counted in the same bins.
    division : {"laps", "sectors", "whole"}
        Sections shown beside the whole record. Laps are between lap markers (attribute ``beacons``), or of one number
        of a lap counter; sectors of one number of a sector channel, or between ``sector_ends``.
    sector_ends : sequence of float or str, optional
        Distances (m) from the start of a lap at which sectors end; needs laps and the speed.
    low_speed : float or str
        Velocity (m/s) up to which motion is low speed, at the place that is shown.
    cutoff : float or str
        Frequency (Hz) at which half of the velocity's amplitude is left; at most 0.4 of the sample rate.
    measured_at, shown_at : {"damper", "wheel"}, optional
        Where the sensors are, and whose travel is shown.
    motion_ratio : float or mapping of str to float, optional
        Damper travel over wheel travel (1), for all corners, an axle or a corner.
    stroke : float or str, optional
        Available stroke (m) at the place that is shown.
    reversed_corners : sequence of str
        Corners, axles or "all" whose signal grows in rebound.
    begin, end : float or str, optional
        Section of each record to use, s or text with a unit.
    variable : str
        Matrix, group or sheet of the files.
    sample_time, resample : float or str, optional
        Step (s) of files without time; step to which irregular time is brought.
    sensors : str or Path, optional
        File of the sensors whose volts or counts the columns contain.

    Returns
    -------
    DamperHistograms
        Shares of time, with the intervals of their scatter and the effect of noise; findings.

    Raises
    ------
    RecordingError
        If no record can be used, or the run beside cannot be.
    DescriptionError
        If an option is out of range or names no corner.

    Notes
    -----
    White noise of r.m.s. s in the travel adds a velocity of r.m.s. s times the norm of the filter's kernel, about
    ``s sqrt(8 pi^2 f^3 / (3 r))`` for a cut-off f and a sample rate r, which moves time from low to high speed.
    ``noise_share`` is the change of each share when that noise is added once more: to first order what the noise has
    already done. Intervals are those of the scatter of 20 equal parts of the record.

    References
    ----------
    cook-1994

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> t = np.arange(0.0, 60.0, 1e-3)
    >>> travel = 0.01 * np.sin(2.0 * np.pi * 2.0 * t)
    >>> made = jn.damper_histograms(jn.recording(t, {"front_left.damper.travel": (travel, "m", "")}))
    >>> share = made.data["zone_share"].sel(record="recording", section="whole", corner="front_left")
    >>> low = 2.0 / np.pi * np.arcsin(0.025 / (0.01 * 2.0 * np.pi * 2.0))  # share of time of a sine
    >>> bool(abs(float(share.sel(zone=["low bump", "low rebound"]).sum()) - low) < 5e-3)
    True
    """
    options = TrackOptions(
        dict(channels or {}),
        _choice(division, get_args(Division), "division"),
        distances(sector_ends, "sector_ends"),
        None if begin is None else to_si(begin, "s", where="begin"),
        None if end is None else to_si(end, "s", where="end"),
        _choice(measured_at, get_args(Place), "measured_at"),
        _choice(shown_at, get_args(Place), "shown_at"),
        _ratios(motion_ratio),
        (reversed_corners,) if isinstance(reversed_corners, str) else tuple(reversed_corners),
        {
            "variable": variable,
            "sample_time": sample_time,
            "resample": resample,
            "sensors": sensors,
        },
    )
    for name in (*options.channels, *(name for name in options.reversed_corners if name != "all")):
        corner_named(name, "channels" if name in options.channels else "reversed_corners")
    low = positive_si(low_speed, "m/s", where="low_speed")
    if low > 0.5 * FASTEST_BIN:
        raise DescriptionError(
            "no damper is that fast",
            where="low_speed",
            found=f"{low:g} m/s",
            allowed=f"up to {0.5 * FASTEST_BIN:g} m/s",
        )
    wanted = positive_si(cutoff, "Hz", where="cutoff")
    longest = None if stroke is None else positive_si(stroke, "m", where="stroke")
    findings: list[Finding] = []
    counted: list[CountedTrack] = []
    errors: list[JounceError] = []
    items = _items(records)
    for place, item in enumerate([*items, *([] if beside is None else [_existing(beside)])]):
        is_model = place == len(items)
        try:
            track = read_track(item, replace(options, division="whole") if is_model else options)
            made, more = count_track(track, wanted, low, longest, is_model=is_model)
        except JounceError as error:
            if is_model:
                raise
            errors.append(error)
            findings.append(left_out(_name_of(item), error))
            continue
        counted.append(made)
        findings += more
    own = [item for item in counted if not item.is_model]
    if not own:
        if len(items) == 1:
            raise errors[0]
        raise RecordingError(
            "no record of a damper can be used",
            where="records",
            found="; ".join(item.message for item in findings[:3]) or "nothing",
        )
    if counted[-1].is_model:
        counted[-1] = _at_level(counted[-1], own[0], findings)
    return _assembled(_with_own_names(counted), low, findings)


def _choice(value: Any, allowed: tuple[str, ...], where: str) -> Any:
    if value is not None and value not in allowed:
        raise unknown(str(value), allowed, what=where.replace("_", " "), where=where)
    return value


def _ratios(given: Mapping[str, float] | float | None) -> Mapping[str, float] | float | None:
    """Return motion ratios as numbers, which must be positive."""
    if given is None:
        return None
    if not isinstance(given, Mapping):
        return positive_si(given, "1", where="motion_ratio")
    for name in given:
        if str(name).lower() != "all":
            corner_named(str(name), "motion_ratio")
    return {
        str(name): positive_si(value, "1", where=f"motion_ratio {name}")
        for name, value in given.items()
    }


def _items(records: Any) -> list[Any]:
    if isinstance(records, list | tuple) and not (
        isinstance(records, tuple) and len(records) == 2 and isinstance(records[1], list)
    ):
        items = list(records)
    else:
        items = [records]
    taken: list[Any] = []
    for item in items:
        is_file = isinstance(item, str | Path)
        taken += matching_files([str(item)], "FILE") if is_file else [item]
    return [_existing(item) for item in taken]


def _existing(item: Any) -> Any:
    """Refuse the name of a file that does not exist: that is no bad file, but a mistyped option."""
    return existing_file(item, RecordingError) if isinstance(item, str | Path) else item


def _name_of(item: Any) -> str:
    path = getattr(item, "path", item)
    return Path(path).name if isinstance(path, str | Path) else "recording"


# putting together -----------------------------------------------------------------------------------------------------


def _with_own_names(counted: Sequence[CountedTrack]) -> dict[str, CountedTrack]:
    """Name the records, each by its own name."""
    named: dict[str, CountedTrack] = {}
    for item in counted:
        base = "model" if item.is_model and item.name in ("recording", *named) else item.name
        name, number = base, 2
        while name in named:
            name, number = f"{base} ({number})", number + 1
        named[name] = item
    return named


def _at_level(model: CountedTrack, track: CountedTrack, findings: list[Finding]) -> CountedTrack:
    """Shift the travel of a model to the mean of a record, because sensors and models have different zeros."""
    corners, shifts = dict(model.corners), list[float]()
    for corner, item in model.corners.items():
        other = track.corners.get(corner)
        if item.travel is None or other is None or other.travel is None:
            continue
        means = [
            float(t.total @ t.middles) / float(t.total.sum()) for t in (other.travel, item.travel)
        ]
        bins = round((means[0] - means[1]) / item.travel.width)
        shifts.append(bins * item.travel.width)
        travel = replace(item.travel, begin=item.travel.begin + bins)
        extremes = item.extremes + np.array([shifts[-1], shifts[-1], 0.0, 0.0])
        corners[corner] = replace(item, travel=travel, extremes=extremes)
    if shifts and max(map(abs, shifts)) > _SHIFTED:
        least, most = min(shifts), max(shifts)
        findings.append(finding("dampers.model_shifted", model.name, most, least=least, most=most))
    return replace(model, corners=corners)


def _assembled(
    counted: Mapping[str, CountedTrack], low: float, findings: list[Finding]
) -> DamperHistograms:
    """Bring the counts of all records into common bins, and put them on the axes of a Dataset."""
    import xarray as xr

    tracks = list(counted.values())
    corners = [
        corner
        for corner in (*CORNERS, *AXLES, ALONE)
        if any(corner in track.corners for track in tracks)
    ]
    sections = list(dict.fromkeys(name for track in tracks for name in track.sections))
    items = [item for track in tracks for item in track.corners.values()]
    velocity, travel = _velocity_bins(items, low), _travel_bins(items)
    lengths = {
        "record": len(tracks), "section": len(sections), "corner": len(corners), "zone": len(ZONES),
        "travel": travel.count, "velocity": velocity.count,
    }  # fmt: skip
    made = {
        name: np.full([lengths[along] for along in dimensions], np.nan)
        for name, dimensions in _OVER.items()
    }
    for t, track in enumerate(tracks):
        for c, corner in enumerate(corners):
            item = track.corners.get(corner)
            if item is None:
                continue
            own = [section in track.sections for section in sections]
            parts = [rows for section, rows in track.sections.items() if section in sections]
            samples = item.velocity.in_parts(parts)
            made["velocity_share"][t, own, c] = item.velocity.shares(samples, velocity.borders)
            made["zone_share"][t, own, c] = _zones(item.velocity, samples, low)
            if item.travel is not None:
                places = item.travel.in_parts(parts)
                made["travel_share"][t, own, c] = item.travel.shares(places, travel.borders)
            for name, values in _statistics(item, samples, parts).items():
                made[name][t, own, c] = values
            seconds = samples.sum(axis=1) / track.rate
            made["duration"][t, own] = np.fmax(made["duration"][t, own], seconds)
            made["zone_share_half"][t, c] = _half_widths(item.velocity, track.pieces, low)
            made["velocity_noise"][t, c] = item.noise
            effect = _noise_effect(item.velocity, item.noise, low)
            made["noise_share"][t, c] = effect
            change = float(effect[1] + effect[2])
            if abs(change) > _WIDE and not track.is_model:
                place = f"{track.name}: {item.trace.column}"
                code = "dampers.noise_matters"
                findings.append(finding(code, place, change, noise=item.noise, change=change))
    model = next((name for name, track in counted.items() if track.is_model), "")
    data = xr.Dataset(
        {name: _variable(name, values) for name, values in made.items()},
        coords={
            "record": list(counted),
            "section": sections,
            "corner": corners,
            "zone": list(ZONES),
            "travel": travel.axis("travel", "m"),
            "velocity": velocity.axis("velocity", "m/s"),
        },
    )
    data = data.assign(_balance(data) | (_overlaps(data, model) if model else {}))
    cuts = {
        name: next((item.cut for item in track.corners.values() if item.cut), None)
        for name, track in counted.items()
    }
    measured_at = {
        corner: str(track.corners[corner].trace.place)
        for track in reversed(tracks)
        for corner in corners
        if corner in track.corners
    }
    return DamperHistograms(
        data,
        low,
        {name: 0.0 if cut is None else cut.cutoff for name, cut in cuts.items()},
        {name: 0.0 if cut is None else cut.passband for name, cut in cuts.items()},
        {corner: measured_at[corner] for corner in corners},
        model,
        tuple(findings),
    )


_STATISTICS = {
    "mean_travel": "m", "least_travel": "m", "largest_travel": "m", "rms_velocity": "m/s",
    "mean_bump_velocity": "m/s", "mean_rebound_velocity": "m/s", "largest_bump_velocity": "m/s",
    "largest_rebound_velocity": "m/s",
}  # fmt: skip
_OVER = {
    "travel_share": ("record", "section", "corner", "travel"),
    "velocity_share": ("record", "section", "corner", "velocity"),
    "zone_share": ("record", "section", "corner", "zone"),
    "zone_share_half": ("record", "corner", "zone"),
    "noise_share": ("record", "corner", "zone"),
    "velocity_noise": ("record", "corner"),
    "duration": ("record", "section"),
    **dict.fromkeys(_STATISTICS, ("record", "section", "corner")),
}
_UNITS = {**_STATISTICS, "velocity_noise": "m/s", "duration": "s"}
_NAMES = {
    "travel_share": "share of time by travel",
    "velocity_share": "share of time by velocity",
    "zone_share": "share of time by zone of velocity",
    "zone_share_half": "half width of the 95 % interval of the share",
    "noise_share": "change of the share by noise",
}


def _variable(name: str, values: Array) -> tuple[tuple[str, ...], Array, dict[str, str]]:
    long_name = _NAMES.get(name, name.replace("_", " "))
    return _OVER[name], values, {"units": _UNITS.get(name, "1"), "long_name": long_name}


@dataclass(frozen=True)
class _Bins:
    """Bins of one width that are shown: the first begins at ``first * width``."""

    width: float
    first: int
    count: int

    @property
    def borders(self) -> Array:
        """Edges between bins; the outer bins are open."""
        return np.asarray((self.first + np.arange(1, self.count)) * self.width, dtype=float)

    def axis(self, name: str, unit: str) -> tuple[str, Array, dict[str, str]]:
        """Return the middles of the bins, as a coordinate."""
        middles = np.asarray((self.first + np.arange(self.count) + 0.5) * self.width, dtype=float)
        return name, middles, {"units": unit, "long_name": f"{name}, bump positive"}


def _velocity_bins(items: Sequence[CountedCorner], low: float) -> _Bins:
    """Choose bins that show nearly all velocities, with an edge at 0 and, if they can, at the end of low speed."""
    fastest = max(
        abs(item.velocity.quantile(share)) for item in items for share in (1.0 - COVERED, COVERED)
    )
    fine = items[0].velocity.width
    widths = (
        max(1, round(low * n / fine)) * fine for n in (0.2, 0.5, *(2.0**k for k in range(12)))
    )
    width = next(width for width in widths if 2.0 * fastest / width <= MOST_BINS)
    reach = max(2, math.ceil(fastest / width))
    return _Bins(width, -reach, 2 * reach)


def _travel_bins(items: Sequence[CountedCorner]) -> _Bins:
    """Choose bins that show all travels; each is at least as wide as those that were counted for it."""
    travels = [item.travel for item in items if item.travel is not None]
    if not travels:
        return _Bins(1e-3, 0, 1)
    bottom, top = min(item.ends[0] for item in travels), max(item.ends[1] for item in travels)
    width = max(nice_width((top - bottom) / MOST_BINS), *(item.width * FINE for item in travels))
    first = math.floor(bottom / width)
    return _Bins(width, first, math.ceil(top / width) - first)


def _zones(velocity: FineCounts, samples: NDArray[np.int64], low: float) -> Array:
    return velocity.shares(samples, np.array([-low, 0.0, low]))


def _half_widths(velocity: FineCounts, pieces: Sequence[NDArray[np.intp]], low: float) -> Array:
    """Return the half widths of 95 % intervals of the zones' shares, from the scatter of pieces."""
    shares = _zones(velocity, velocity.in_parts(pieces), low)
    known = shares[np.isfinite(shares[:, 0])]
    if len(known) < 2:
        return np.full(len(ZONES), np.nan)
    error = known.std(axis=0, ddof=1) / math.sqrt(len(known))
    return np.asarray(student_factor(len(known) - 1) * error, dtype=float)


def _statistics(
    item: CountedCorner, samples: NDArray[np.int64], parts: Sequence[NDArray[np.intp]]
) -> dict[str, Array]:
    """Return means and extremes of parts of the record; NaN of those without samples."""
    middles = item.velocity.middles

    def mean(values: Array, counts: NDArray[np.int64]) -> Array:
        with np.errstate(invalid="ignore", divide="ignore"):
            return np.asarray(counts @ values / counts.sum(axis=1), dtype=float)

    ends = np.array([_ends(item.extremes[rows]) for rows in parts])
    bump, rebound = middles > 0.0, middles < 0.0
    statistics = {
        "rms_velocity": np.sqrt(mean(middles**2, samples)),
        "mean_bump_velocity": mean(middles[bump], samples[:, bump]),
        "mean_rebound_velocity": mean(middles[rebound], samples[:, rebound]),
        "largest_bump_velocity": np.maximum(ends[:, 3], 0.0),
        "largest_rebound_velocity": np.minimum(ends[:, 2], 0.0),
    }
    if item.travel is not None:
        statistics["mean_travel"] = mean(item.travel.middles, item.travel.in_parts(parts))
        statistics["least_travel"], statistics["largest_travel"] = ends[:, 0], ends[:, 1]
    return statistics


def _ends(extremes: Array) -> Array:
    """Return the least and the largest travel and velocity of atoms; NaN without samples."""
    least, most = (
        np.fmin.reduce(extremes[:, ::2], initial=math.inf),
        np.fmax.reduce(extremes[:, 1::2], initial=-math.inf),
    )
    ends = np.array([least[0], most[0], least[1], most[1]])
    return np.where(np.isfinite(ends), ends, np.nan)


def _noise_effect(velocity: FineCounts, noise: float, low: float) -> Array:
    """Return how the shares of the zones change when the noise is added once more."""
    if noise == 0.0:
        return np.zeros(len(ZONES))
    from scipy.special import ndtr

    shares = velocity.total / float(velocity.total.sum())
    edges = (-low, 0.0, low)
    with_noise, without = (
        np.diff(np.concatenate([[0.0], below, [1.0]]))
        for below in (
            np.stack([ndtr((edge - velocity.middles) / noise) @ shares for edge in edges]),
            np.stack([(velocity.middles < edge) @ shares for edge in edges]),
        )
    )
    return np.asarray(with_noise - without, dtype=float)


def _balance(data: xr.Dataset) -> dict[str, Any]:
    """Return the front minus the rear: zone shares, and the ratio of velocities."""
    corners = [str(name) for name in data["corner"].to_numpy()]
    ends = [[name.startswith(axle) for name in corners] for axle in AXLES]
    if not all(map(any, ends)):
        return {}
    zones, speeds = data["zone_share"].to_numpy(), data["rms_velocity"].to_numpy()
    shares = [_mean_of_known(zones[:, :, end]) for end in ends]
    squares = [_mean_of_known(np.square(speeds[:, :, end])) for end in ends]
    words = {"units": "1", "long_name": "zone share, front minus rear"}
    ratio = {"units": "1", "long_name": "r.m.s. velocity, front over rear"}
    return {
        "balance": (("record", "section", "zone"), shares[0] - shares[1], words),
        "velocity_ratio": (("record", "section"), np.sqrt(squares[0] / squares[1]), ratio),
    }


def _mean_of_known(values: Array) -> Array:
    """Return the mean over corners, the third axis, of those that are known; NaN without any."""
    known = np.isfinite(values)
    with np.errstate(invalid="ignore"):
        mean = np.where(known, values, 0.0).sum(axis=2) / known.sum(axis=2)
    return np.asarray(mean, dtype=float)


def _overlaps(data: xr.Dataset, model: str) -> dict[str, Any]:
    """Return how much of each histogram lies within the model's: 1 if they are equal, 0 if nothing is common."""
    made = {}
    for name in ("travel", "velocity"):
        shares = data[f"{name}_share"]
        other = shares.sel(record=model, section="whole").to_numpy()
        common = np.minimum(shares.to_numpy(), other).sum(axis=-1)
        words = f"share of the {name} histogram within the model's"
        made[f"{name}_overlap"] = (
            ("record", "section", "corner"),
            common,
            {"units": "1", "long_name": words},
        )
    return made
