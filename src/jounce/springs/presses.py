"""Records of a press: signs, saturation, zeros, cycles, and force over deflection in each cycle."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated

import numpy as np

from jounce.core.errors import FitError
from jounce.core.findings import Finding, finding
from jounce.core.results import Shows
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.identify.estimate import Estimate, student_factor
from jounce.identify.signals import noise_of
from jounce.identify.signs import ForcePositive, StrokePositive, sign_of
from jounce.springs.strokes import Contact, Part, Stroke, force_at, lost_motion, strokes_of, zero_of

_FEWEST = 40  # samples of a record
_LOADED = 0.02  # share of the range of the force: a record that starts beyond it starts loaded
_AT_TOP = 0.002  # share of the range of the force that counts as its largest
_OVER = 0.03  # share of the stroke over which a force at its largest is a full-scale reading
_FLATTER = 5.0  # times as long as the rise before would need
_MOVES = 0.005  # share of the stroke that is named as lost motion
_DRIFTS = 0.01  # share of the range of the force that is named as a drift of the zero
_SOFTENS = 0.03  # by which a first loading is stiffer than the later ones
_CLEAR = 4.0  # standard errors beyond which a difference is clear
_LEVEL = student_factor(math.inf)


@dataclass(frozen=True)
class PressRun(Plain):
    """A record of a press.

    Attributes
    ----------
    file : str
        Name of the file.
    speed : float
        Loading speed, m/s; NaN without time.
    stroke : float
        Largest deflection from contact, m.
    largest_force : float
        Largest force, N, above its zero.
    cycles : int
        Cycles of loading and unloading that count.
    stroke_positive, force_positive : str
        Positive directions in the record, as stated or found.
    force_zero, contact : Estimate
        Force (N) and stroke (m) of the record at contact, compression positive; without an interval if not seen.
    """

    file: Annotated[str, Shows("file")]
    speed: Annotated[float, Shows("loading speed", "m/s")]
    stroke: Annotated[float, Shows("stroke", "m")]
    largest_force: Annotated[float, Shows("largest force", "N")]
    cycles: Annotated[int, Shows("cycles")]
    stroke_positive: StrokePositive
    force_positive: ForcePositive
    force_zero: Annotated[Estimate, Shows("zero of the force", "N")]
    contact: Annotated[Estimate, Shows("contact at", "m")]


@dataclass
class Press:
    """A record that has been read: strokes measured from contact, compression positive."""

    file: str
    strokes: list[Stroke]
    zero: Contact
    has_zero: bool
    turned: tuple[int, int]
    noise: float
    top: float = math.inf  # m from contact, beyond which the load cell is saturated
    findings: list[Finding] = field(default_factory=list)

    @property
    def speed(self) -> float:
        """Median loading speed, m/s; NaN without time."""
        speeds = [s.speed for s in self.strokes if s.is_loading and math.isfinite(s.speed)]
        return float(np.median(speeds)) if speeds else math.nan

    @property
    def reach(self) -> float:
        """Deflection (m) from contact that all strokes reach."""
        ends = min(float(s.deflection[-1]) for s in self.strokes) - self.zero.place
        return min(ends, self.top)

    @property
    def pairs(self) -> list[tuple[Stroke, Stroke | None]]:
        """Loadings with the unloading that follows."""
        pairs: list[tuple[Stroke, Stroke | None]] = []
        for stroke in self.strokes:
            if stroke.is_loading:
                pairs.append((stroke, None))
            elif pairs and pairs[-1][1] is None:
                pairs[-1] = (pairs[-1][0], stroke)
        return pairs

    def summary(self) -> PressRun:
        """Sum up the record."""
        forces = [
            float(s.force[s.deflection - self.zero.place <= self.top].max()) for s in self.strokes
        ]
        return PressRun(
            self.file, self.speed, self.reach, max(forces) - self.zero.zero, len(self.pairs),
            "compression" if self.turned[0] > 0 else "extension",
            "compression" if self.turned[1] > 0 else "tension",
            _seen(self.zero.zero, self.zero.zero_error if self.has_zero else None),
            _seen(self.zero.place, self.zero.place_error if self.has_zero else None),
        )  # fmt: skip


def _seen(value: float, error: float | None) -> Estimate:
    if error is None:
        return Estimate(value)
    return Estimate(value, error, (value - _LEVEL * error, value + _LEVEL * error))


def read_press(
    file: str,
    deflection: Array,
    force: Array,
    time: Array | None,
    *,
    part: Part,
    stroke_positive: StrokePositive | None,
    force_positive: ForcePositive | None,
) -> Press:
    """Read a record (m, N, s): signs, contact, whole strokes from contact on.

    Raises
    ------
    FitError
        If there are too few points, no motion, or a force that does not rise.
    """
    findings: list[Finding] = []
    name = Path(file).name
    known = np.isfinite(deflection) & np.isfinite(force)
    if not known.all():
        findings.append(
            finding("springs.rows_left_out", name, int((~known).sum()), rows=int((~known).sum()))
        )
        deflection, force = deflection[known], force[known]
        time = None if time is None else time[known]
    if len(force) < _FEWEST:
        raise FitError(
            "too few points", where=name, found=len(force), allowed=f"at least {_FEWEST}"
        )
    if not (np.ptp(deflection) > 0.0 and np.ptp(force) > 0.0):
        raise FitError(
            "stroke or force never changes", where=name,
            found=f"{np.ptp(deflection):g} m and {np.ptp(force):g} N",
        )  # fmt: skip
    turned = _signs(deflection, force, stroke_positive, force_positive, name, findings)
    deflection, force = turned[0] * deflection, turned[1] * force
    strokes = strokes_of(deflection, force, time)
    if not any(stroke.is_loading for stroke in strokes):
        raise FitError(
            "no loading in the record", where=name, found=f"{len(strokes)} strokes",
            hint="The record must begin before the part is compressed.",
        )  # fmt: skip
    zero = zero_of(strokes, part)
    press = Press(
        name, strokes, zero or _without_contact(strokes, name, findings), zero is not None, turned,
        noise_of(force), findings=findings,
    )  # fmt: skip
    press.top = _saturated(press)
    _name_zeros(press, part)
    press.strokes = _conditioned(press)
    return press


def _signs(
    deflection: Array,
    force: Array,
    stroke_positive: StrokePositive | None,
    force_positive: ForcePositive | None,
    name: str,
    findings: list[Finding],
) -> tuple[int, int]:
    """Return the signs that make compression positive: a record begins at the free end, and the force rises from it."""
    stated = (
        sign_of(stroke_positive, "stroke", where=name),
        sign_of(force_positive, "force", where=name),
    )
    span = float(np.ptp(deflection))
    low, high = float(deflection.min()), float(deflection.max())
    stroke = stated[0]
    if stroke_positive is None:
        begins_high = high - float(deflection[0]) < 0.1 * span
        begins_low = float(deflection[0]) - low < 0.1 * span
        if (
            begins_high == begins_low
        ):  # begins in between: the free end is the one with the flatter force
            ends = [deflection < low + 0.1 * span, deflection > high - 0.1 * span]
            begins_high = float(np.ptp(force[ends[1]])) < float(np.ptp(force[ends[0]]))
        stroke = -1 if begins_high else 1
        if stroke < 0:
            findings.append(finding("springs.stroke_reversed", name))
    rises = float(np.polyfit(stroke * (deflection - deflection.mean()) / span, force, 1)[0])
    load = 1 if rises > 0.0 else -1
    if force_positive is not None and load != stated[1]:
        findings.append(finding("springs.stated_force_reversed", name, stated=force_positive))
    elif force_positive is None and load < 0:
        findings.append(finding("springs.force_reversed", name))
    return stroke, load


def _without_contact(strokes: Sequence[Stroke], name: str, findings: list[Finding]) -> Contact:
    """Return the start of a record without free travel as its zero, and say what that leaves open."""
    place = max(float(stroke.deflection[0]) for stroke in strokes)
    first = strokes[0]
    start = float(np.median(first.force[: max(3, len(first.force) // 100)]))
    largest = max(float(stroke.force.max()) for stroke in strokes)
    is_loaded = abs(start) > _LOADED * (largest - start)
    code = "springs.starts_loaded" if is_loaded else "springs.no_free_travel"
    findings.append(finding(code, name, start, force=start))
    return Contact(place, 0.0, 0.0 if is_loaded else start, 0.0)


def _saturated(press: Press) -> float:
    """Return the deflection (m) from contact from which on the force stays at its largest; infinite if it does not."""
    stroke = max(press.strokes, key=lambda item: float(item.force.max()))
    x, f = stroke.deflection, stroke.force
    span, height = float(np.ptp(x)), float(np.ptp(f))
    near = max(_AT_TOP * height, 3.0 * press.noise)
    at_top = np.flatnonzero(f > f.max() - near)
    over = float(x[-1] - x[at_top[0]])
    before = (f > f.max() - near - 0.1 * height) & (f <= f.max() - near)
    if np.count_nonzero(before) < 3 or over < _OVER * span:
        return math.inf
    slope = float(np.polyfit(x[before], f[before], 1)[0])
    if slope <= 0.0 or over < _FLATTER * near / slope:
        return math.inf
    begin = float(x[at_top[0]]) - press.zero.place
    press.findings.append(
        finding(
            "springs.saturated",
            press.file,
            float(f.max()),
            force=float(f.max() - press.zero.zero),
            deflection=begin,
        )
    )
    return begin - 0.02 * span


def _name_zeros(press: Press, part: Part) -> None:
    """Name a zero that drifts, and travel that is lost between loading and unloading."""
    contacts = [s.contact for s in press.strokes if s.contact]
    height = max(float(s.force.max()) for s in press.strokes) - press.zero.zero
    if len(contacts) > 1:
        first, last = contacts[0], contacts[-1]
        drift = last.zero - first.zero
        error = math.hypot(first.zero_error, last.zero_error)
        if abs(drift) > max(_DRIFTS * height, _CLEAR * error):
            press.findings.append(finding("springs.zero_drifts", press.file, drift, drift=drift))
    if press.has_zero and abs(press.zero.zero) > _LOADED * height:
        press.findings.append(
            finding("springs.not_zeroed", press.file, press.zero.zero, force=press.zero.zero)
        )
    lost = lost_motion(press.strokes)
    if lost is None:
        return
    travel, error = lost
    if abs(travel) > max(_MOVES * press.reach, _CLEAR * error):
        press.findings.append(
            finding(
                "springs.lost_motion" if part == "spring" else "springs.recovers_late",
                press.file,
                travel,
                travel=travel,
                low=travel - _LEVEL * error,
                high=travel + _LEVEL * error,
            )
        )


def _conditioned(press: Press) -> list[Stroke]:
    """Leave out the first cycle if its loading is stiffer than the later ones."""
    pairs = press.pairs
    if len(pairs) < 2:
        return press.strokes
    places = press.zero.place + np.linspace(0.2, 0.9, 15) * press.reach
    width = 0.03 * press.reach
    first, own = force_at(pairs[0][0], places, width)
    later = np.array([force_at(pair[0], places, width)[0] for pair in pairs[1:]])
    mean = later.mean(axis=0)
    known = np.isfinite(first) & np.isfinite(mean)
    if not known.any():
        return press.strokes
    difference = first[known] - mean[known]
    share = float(difference.sum() / (mean[known] - press.zero.zero).sum())
    error = math.sqrt(float(np.mean(own[known] ** 2)) / known.sum())
    if abs(share) < _SOFTENS or abs(float(difference.mean())) < _CLEAR * error:
        return press.strokes
    press.findings.append(finding("springs.first_cycle", press.file, share, share=share))
    return [
        stroke
        for stroke in press.strokes
        if stroke is not pairs[0][0] and stroke is not pairs[0][1]
    ]


def cycle_forces(press: Press, grid: Array, width: float) -> tuple[Array, Array]:
    """Return forces (N) above zero at deflections from contact, and standard errors: (cycles, 2, n).

    Loading, then unloading; NaN where a cycle has none.
    """
    values = np.full((len(press.pairs), 2, len(grid)), np.nan)
    errors = np.full_like(values, np.nan)
    for k, pair in enumerate(press.pairs):
        for side, stroke in enumerate(pair):
            if stroke is not None:
                at = force_at(stroke, press.zero.place + grid, width)
                values[k, side], errors[k, side] = at[0] - press.zero.zero, at[1]
    return values, errors
