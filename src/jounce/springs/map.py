"""The map of a spring or a bump stop: force over deflection and loading speed from the records of a press."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Annotated, Any, get_args

import numpy as np

from jounce.core.errors import DescriptionError, FitError, JounceError, OutputError, unknown
from jounce.core.findings import Finding, finding
from jounce.core.operation import File, Mark, Number, operation
from jounce.core.phrases import Phrase
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.core.units import positive_si, to_si
from jounce.dampers.files import UnreadFile
from jounce.identify.estimate import Estimate, mean_of_replicates, student_factor
from jounce.identify.signs import ForcePositive, StrokePositive
from jounce.parts import load, rig_path
from jounce.parts.files import updated_text
from jounce.springs.curves import PressCurve, by_speed, curve_of, window_of
from jounce.springs.files import AnyPressFiles, as_press_files
from jounce.springs.presses import Press, PressRun, cycle_forces, read_press
from jounce.springs.shapes import Knee, Section, Shape, shape_of
from jounce.springs.strokes import Part

_UNLIKE = (
    3.0  # factor between the stiffness of a record and the others': a wrong unit, or another part
)
_ENOUGH = 3  # records, from which one can differ from the others
_RATES = (100.0, 1e7)  # N/m: plausible mean stiffness of a spring or a stop
_FARTHEST = 1.0  # m: no spring of a vehicle deflects so far
_LOSES = 0.01  # loss factor of a spring that is named
_MISSES = 0.05  # of the largest force: deviation of the law of a stop that is named
_COMMON = (0.3, 0.95)  # shares of the common stroke over which speeds are compared
_NEARLY = (
    0.02  # by which a speed may lie outside of the measured ones, as they are measured themselves
)
_LEVEL = student_factor(math.inf)
_KNEES = {"helper": "springs.helper", "bind": "springs.bind", "knee": "springs.knee"}


@dataclass(frozen=True)
class CurveAtSpeed(Plain):
    """Force over deflection between measured loading speeds.

    Attributes
    ----------
    speed : float
        Loading speed, m/s.
    deflection, force, low, high : array (n,)
        Deflection from contact (m), force (N) and its 95 % interval (N).
    """

    speed: float
    deflection: Array
    force: Array
    low: Array
    high: Array


@dataclass(frozen=True)
class StopLaw(Plain):
    """The law of a bump stop in a rig that comes closest to its curve.

    Attributes
    ----------
    rate : Estimate
        Rate at contact, N/m.
    progression : Estimate
        Cubic term, N/m^3.
    misses : float
        Largest deviation from the curve over the largest force [1].
    """

    rate: Estimate
    progression: Estimate
    misses: float


@dataclass(frozen=True)
class SpringMap(Plain):
    """The map of a spring or a bump stop, SI, compression positive, deflections from contact.

    Attributes
    ----------
    part : {"spring", "bump-stop"}
        What was pressed.
    curves : tuple of PressCurve
        One for each loading speed, slowest first.
    shape : {"linear", "progressive", "helper", "sections"}
        Shape of a spring; a bump stop is progressive.
    sections : tuple of Section
        Rates of straight sections, or at the beginning, middle and end of a curve.
    knees : tuple of Knee
        Deflections at which the rate changes at once.
    speed_effect : Estimate
        Change of the force for ten times the loading speed, as a share [1], from the slowest to the fastest; NaN with
        one speed.
    law : StopLaw or None
        Law of a bump stop for a rig.
    runs : tuple of PressRun
        The records.
    findings : tuple of Finding
        Findings of the reader, of the records and of the map.
    gap : float or None
        Gap of a bump stop in the rig with its packers taken off, m.
    rig_text : str
        Text of a rig file with the law; empty if no rig was given.
    """

    left_out = ("rig_text",)
    part: Part
    curves: tuple[PressCurve, ...]
    shape: Shape
    sections: tuple[Section, ...]
    knees: tuple[Knee, ...]
    speed_effect: Estimate
    law: StopLaw | None
    runs: tuple[PressRun, ...]
    findings: tuple[Finding, ...]
    gap: float | None = None
    rig_text: str = field(default="", repr=False)

    @property
    def curve(self) -> PressCurve:
        """The curve of the slowest loading."""
        return self.curves[0]

    @property
    def spring(self) -> dict[str, Any]:
        """Table to write under ``strut.spring``, SI: a rate for a straight spring, otherwise a curve."""
        if self.shape == "linear" and not self.knees:
            return {"rate": self.sections[0].rate.value}
        curve = self.curve
        return {
            "curve": {
                "kind": "table",
                "deflection": curve.deflection.tolist(),
                "force": np.maximum.accumulate(curve.force).tolist(),
            }
        }

    @property
    def bump_stop(self) -> dict[str, float] | None:
        """Table to write under ``strut.bump_stop``, SI; without ``gap`` if none was given. None for a spring."""
        if self.law is None:
            return None
        table = {"rate": self.law.rate.value, "progression": self.law.progression.value}
        return table if self.gap is None else {"gap": self.gap, **table}

    def at(self, speed: float | str) -> CurveAtSpeed:
        """Return the curve at a loading speed between measured ones, interpolated over the logarithm of the speed.

        Its interval adds those of both neighbours and the error of the interpolation, which is told from how well
        neighbours predict each measured speed between them; two speeds tell nothing about it, so that the interval then
        contains a quarter of their difference.

        Parameters
        ----------
        speed : float or str
            Loading speed, m/s, within the measured ones.

        Raises
        ------
        DescriptionError
            If the records have no time, or the speed lies beyond the measured ones.
        """
        wanted = positive_si(speed, "m/s", where="speed")
        known = [curve.speed for curve in self.curves if math.isfinite(curve.speed)]
        if not known:
            raise DescriptionError(
                "the records have no time, so that their speed is unknown", where="speed",
                hint="Add a column time.",
            )  # fmt: skip
        slack = 1.0 + _NEARLY
        if not known[0] / slack <= wanted <= known[-1] * slack:
            raise DescriptionError(
                "not among the loading speeds that were measured", where="speed",
                found=f"{wanted:g} m/s",
                allowed=Phrase("{low:g} to {high:g} m/s", low=known[0], high=known[-1]),
            )  # fmt: skip
        curves = self.curves[: len(known)]
        grid = min((curve.deflection for curve in curves), key=lambda x: float(x[-1]))
        force, error = _on(grid, curves)
        if len(known) == 1:
            half = _LEVEL * error[0]
            return CurveAtSpeed(wanted, grid, force[0], force[0] - half, force[0] + half)
        place, at = np.log(wanted), np.log(known)
        upper = min(max(int(np.searchsorted(at, place)), 1), len(at) - 1)
        share = float(np.clip((place - at[upper - 1]) / (at[upper] - at[upper - 1]), 0.0, 1.0))
        mean = (1.0 - share) * force[upper - 1] + share * force[upper]
        own = ((1.0 - share) * error[upper - 1]) ** 2 + (share * error[upper]) ** 2
        bow = 4.0 * share * (1.0 - share) * _bow(at, force)
        half = _LEVEL * np.sqrt(own + bow**2)
        return CurveAtSpeed(wanted, grid, mean, mean - half, mean + half)

    def table(self) -> str:
        """Write deflections, forces and hysteresis with intervals of all speeds as CSV, SI."""
        lines = [
            "speed [m/s],deflection [m],force [N],low [N],high [N],hysteresis [N],low [N],high [N]"
        ]
        for curve in self.curves:
            columns = (
                curve.deflection, curve.force, curve.low, curve.high,
                curve.hysteresis, curve.hysteresis_low, curve.hysteresis_high,
            )  # fmt: skip
            speed = _cell(curve.speed)
            lines += [",".join([speed, *map(_cell, row)]) for row in zip(*columns, strict=True)]
        return "\n".join(lines) + "\n"

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, SI, with the tables for a rig."""
        return {**super().to_dict(), "spring": self.spring, "bump_stop": self.bump_stop}


def _cell(value: float) -> str:
    return "" if math.isnan(value) else f"{value:.9g}"


def _on(grid: Array, curves: Sequence[PressCurve]) -> tuple[Array, Array]:
    """Return forces and standard errors (N) of curves on common deflections (m)."""
    return (
        np.stack([np.interp(grid, curve.deflection, curve.force) for curve in curves]),
        np.stack([np.interp(grid, curve.deflection, curve.error) for curve in curves]),
    )


def _bow(at: Array, force: Array) -> Array:
    """Return the usual error (N) of interpolation half-way between neighbours."""
    if len(at) < 3:
        return np.asarray(0.25 * np.abs(force[1] - force[0]))
    errors = []
    for k in range(1, len(at) - 1):
        share = (at[k] - at[k - 1]) / (at[k + 1] - at[k - 1])
        errors.append(force[k] - (1.0 - share) * force[k - 1] - share * force[k + 1])
    return np.asarray(np.sqrt(np.mean(np.square(errors), axis=0)) / 4.0)


def check_rig_output(*, rig: Any, out: Path | None, **_others: Any) -> None:
    """Refuse a rig without an output file, and the reverse."""
    if (rig is None) != (out is None):
        raise OutputError(
            "--rig and --out must be given together", where="--rig", allowed="--rig and --out"
        )


@operation(
    "spring map",
    echo={"files": "measured"},
    offers=("rig_text", "figure", "report"),
    check="jounce.springs.map:check_rig_output",
    page="jounce.report.springs:spring_map_page",
    title="Spring map",
    doing="reading",
    example="jounce spring map press --part bump-stop --report stop.html",
)
def spring_map(
    files: AnyPressFiles,
    *,
    part: Annotated[Part, Mark("What was pressed.", "spring|bump-stop")] = "spring",
    stroke_positive: Annotated[
        StrokePositive | None,
        Mark(
            "Positive direction of the stroke; default: a record begins at the free end.",
            "compression|extension",
        ),
    ] = None,
    force_positive: Annotated[
        ForcePositive | None,
        Mark(
            "Positive direction of the force; default: it rises in compression.",
            "compression|tension",
        ),
    ] = None,
    rig: Annotated[
        str | None, File("Rig to write the law into: name or file.", "RIG", ("parts",))
    ] = None,
    gap: Annotated[
        float | str | None,
        Number(
            'Gap of the bump stop without packers, e.g. "25 mm"; default: that of the rig.',
            "GAP",
            "m",
        ),
    ] = None,
    packers: Annotated[
        float | str | None,
        Number('Thickness of all packers on the bump stop, e.g. "6 mm".', "THICKNESS", "m"),
    ] = None,
) -> SpringMap:
    """Make the map of a spring or a bump stop from the records of a press: force over deflection, for each speed.

    Records of loading and unloading, of one or several speeds, in one folder. Zeros of load cell and stroke are found
    from free travel before contact. A file that cannot be used is a finding; the others are used.

    Parameters
    ----------
    files : sequence of PressFile, RecordFile, str or Path
        Records with ``displacement`` (m) and ``force`` (N), and ``time`` (s) if recorded; folders of them.
    part : {"spring", "bump-stop"}
        What was pressed. The deflection of a spring counts from the middle of the contacts of loading and unloading, in
        which backlash and friction cancel; that of a bump stop from its first contact.
    stroke_positive, force_positive : str, optional
        Positive direction of the stroke ("compression", "extension") and of the force ("compression", "tension") in all
        records.
    rig : str, optional
        Rig into whose file the law is written: ``strut.spring`` or ``strut.bump_stop``. A spring with a preload there
        begins at the deflection at which it carries this load.
    gap, packers : float or str, optional
        Gap of the bump stop without packers, and their thickness, m; packers reduce the gap.

    Returns
    -------
    SpringMap
        Force over deflection at each loading speed with its interval, hysteresis, shape and knees, effect of the speed,
        and findings. Intervals contain noise, scatter of cycles and files, and the errors of the zeros, not errors of
        the calibration.

    Raises
    ------
    FitError
        If no record can be used.
    DescriptionError
        If packers exceed the gap, or a rig's load lies beyond the record.

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> x = 0.03 - np.abs(np.linspace(-0.03, 0.03, 1201))
    >>> force = 25e3 * np.maximum(x - 0.005, 0.0) + np.random.default_rng(1).normal(0.0, 1.0, x.size)
    >>> made = spring_map([jn.PressFile("spring.csv", x, force)])
    >>> made.shape, round(made.sections[0].rate.value / 25e3, 2), round(made.runs[0].contact.value, 4)
    ('linear', 1.0, 0.005)
    """
    if part not in get_args(Part):
        raise unknown(str(part), get_args(Part), what="part", where="part")
    findings: list[Finding] = []
    presses: list[Press] = []
    for item in as_press_files(files):
        if isinstance(item, UnreadFile):
            findings.append(_left_out(item.path, item.error))
            continue
        findings += item.findings
        try:
            presses.append(
                read_press(
                    Path(item.path).name,
                    item.deflection,
                    item.force,
                    item.time,
                    part=part,
                    stroke_positive=stroke_positive,
                    force_positive=force_positive,
                )
            )
        except JounceError as error:
            findings.append(_left_out(item.path, error))
    if not presses:
        raise FitError(
            "no record of a press can be used", where="files",
            found="; ".join(item.message for item in findings[:3]) or "nothing",
        )  # fmt: skip
    used = _alike(presses, findings)
    groups = by_speed(used)
    curves = tuple(curve_of(group) for group in groups)
    shape: Shape
    shape, sections, knees = shape_of(used if part == "spring" else groups[0])
    if part == "bump-stop":
        shape, knees = "progressive", ()
    law = _stop_law(used, curves[0]) if part == "bump-stop" else None
    effect = _speed_effect(curves)
    findings += [item for press in used for item in press.findings]
    made = SpringMap(
        part, curves, shape, sections, knees, effect, law,
        tuple(press.summary() for press in used), (),
    )  # fmt: skip
    made = replace(made, gap=_gap(made, gap, packers, rig))
    made = replace(made, findings=(*findings, *_advice(made, used)))
    return made if rig is None else replace(made, rig_text=_in_rig(made, rig, used))


def _left_out(path: str | Path, error: JounceError) -> Finding:
    return finding("springs.file_left_out", Path(path).name, error=error)


def _stiffness(press: Press) -> float:
    """Return the mean stiffness (N/m) of a record over the upper half of its stroke."""
    stroke = next(s for s in press.strokes if s.is_loading)
    x, f = stroke.deflection - press.zero.place, stroke.force
    upper = (x > 0.5 * press.reach) & (x <= press.reach)
    return float(np.polyfit(x[upper], f[upper], 1)[0]) if np.count_nonzero(upper) > 2 else math.nan


def _alike(presses: list[Press], findings: list[Finding]) -> list[Press]:
    """Leave out records whose stiffness differs from the others' as a wrong unit makes it differ."""
    values = np.array([_stiffness(press) for press in presses])
    usual = float(np.nanmedian(values))
    factors = values / usual
    odd = [not 1.0 / _UNLIKE < factor < _UNLIKE for factor in factors]
    if not any(odd) or len(presses) < _ENOUGH:
        if any(odd):
            findings.append(
                finding("springs.files_differ", "files", float(np.nanmax(values) / np.nanmin(values)),
                        factor=float(np.nanmax(values) / np.nanmin(values)))
            )  # fmt: skip
        return presses
    findings += [
        finding("springs.unlike_others", press.file, float(factor), factor=float(factor))
        for press, factor, is_odd in zip(presses, factors, odd, strict=True)
        if is_odd
    ]
    return [press for press, is_odd in zip(presses, odd, strict=True) if not is_odd] or presses


def _speed_effect(curves: Sequence[PressCurve]) -> Estimate:
    """Estimate the relative change of the force for ten times the speed, from the slowest and the fastest curve."""
    timed = [curve for curve in curves if math.isfinite(curve.speed)]
    if len(timed) < 2:
        return Estimate(math.nan)
    reach = min(float(curve.deflection[-1]) for curve in timed)
    grid = np.linspace(*_COMMON, 14) * reach
    force, error = _on(grid, timed)
    logs = np.log(force.sum(axis=1))
    own = error.sum(axis=1) / force.sum(axis=1)  # neighbours share the error of the zero
    decades = math.log10(timed[-1].speed / timed[0].speed)
    slope = float(logs[-1] - logs[0]) / decades
    deviation = math.hypot(float(own[0]), float(own[-1])) / decades
    low, high = (math.expm1(slope + sign * _LEVEL * deviation) for sign in (-1.0, 1.0))
    return Estimate(math.expm1(slope), math.exp(slope) * deviation, (low, high))


def _stop_law(presses: Sequence[Press], curve: PressCurve) -> StopLaw:
    """Fit ``rate d + progression d^3`` to the slowest curve; cycles are replicates."""
    group = [press for press in presses if press.file in curve.files]
    fitted = _cubic(curve.deflection, curve.force)
    reach = float(curve.deflection[-1])
    grid = np.linspace(0.03, 0.99, 60) * reach
    numbers = []
    for press in group:
        forces, _ = cycle_forces(press, grid, window_of([press], reach, 0.02))
        mean = np.where(np.isfinite(forces[:, 1]), forces.mean(axis=1), forces[:, 0])
        numbers += [_cubic(grid[ok], row[ok]) for row in mean if (ok := np.isfinite(row)).any()]
    rate, progression = (
        mean_of_replicates([float(item[k]) for item in numbers], value=float(fitted[k]))
        for k in (0, 1)
    )
    law = fitted[0] * curve.deflection + fitted[1] * curve.deflection**3
    misses = float(np.abs(law - curve.force).max() / curve.force.max())
    return StopLaw(rate, progression, misses)


def _cubic(deflection: Array, force: Array) -> Array:
    """Fit a rate and a cubic term, both at least zero; a rate is above zero."""
    from scipy.optimize import nnls

    reach, height = float(deflection.max()), float(force.max())
    u = deflection / reach
    found, _ = nnls(np.column_stack([u, u**3]), force / height)
    return np.array([max(found[0], 1e-3) * height / reach, found[1] * height / reach**3])


def _gap(
    made: SpringMap, gap: float | str | None, packers: float | str | None, rig: str | None
) -> float | None:
    """Return the gap (m) of a bump stop with its packers."""
    thickness = 0.0 if packers is None else to_si(packers, "m", where="packers")
    if made.part == "spring":
        if gap is not None or packers is not None:
            raise DescriptionError(
                "a spring has neither gap nor packers", where="gap, packers",
                allowed="with part = bump-stop",
            )  # fmt: skip
        return None
    given = None if gap is None else to_si(gap, "m", where="gap")
    if given is None and rig is not None:
        given = load(rig).parameters().get("strut.bump_stop.gap")
    if given is None:
        if packers is not None or rig is not None:
            raise DescriptionError(
                "the gap without packers is not known", where="gap",
                hint="Give it, or a rig with a bump stop.",
            )  # fmt: skip
        return None
    if not 0.0 <= thickness < math.inf:
        raise DescriptionError(
            "invalid thickness", where="packers", found=f"{thickness:g} m", allowed="0 m or more"
        )
    if thickness > given:
        raise DescriptionError(
            "the packers are thicker than the gap", where="packers", found=f"{thickness:g} m",
            allowed=Phrase("up to {gap:g} m", gap=given),
        )  # fmt: skip
    return given - thickness


def _advice(made: SpringMap, presses: Sequence[Press]) -> Iterator[Finding]:
    """Name what the map shows, and what it leaves open."""
    curve = made.curve
    reach, height = float(curve.deflection[-1]), float(curve.force[-1])
    if reach > _FARTHEST:
        yield finding("springs.far", "files", reach, deflection=reach)
    stiffness = height / reach
    if not _RATES[0] < stiffness < _RATES[1]:
        yield finding("springs.implausible", "files", stiffness, rate=stiffness)
    for knee in made.knees:
        low, high = knee.deflection.interval or (knee.deflection.value,) * 2
        yield finding(
            _KNEES[knee.kind], "curve", knee.deflection.value,
            deflection=knee.deflection.value, low=low, high=high, force=knee.force.value,
        )  # fmt: skip
    if not curve.has_unloading:
        yield finding("springs.no_unloading", "files")
    elif made.part == "spring" and curve.loss_factor.value > _LOSES:
        yield finding(
            "springs.hysteresis", "curve", curve.loss_factor.value, share=curve.loss_factor.value,
            force=float(np.nanmax(curve.hysteresis)),
        )  # fmt: skip
    if made.part == "bump-stop":
        yield from _stop_advice(made)
    if made.speed_effect.interval is not None:
        low, high = made.speed_effect.interval
        code = "springs.no_speed_effect" if made.speed_effect.has(0.0) else "springs.speed_effect"
        yield finding(
            code,
            "curves",
            made.speed_effect.value,
            share=made.speed_effect.value,
            low=low,
            high=high,
        )
    if sum(len(press.pairs) for press in presses) == 1:
        yield finding("springs.one_cycle", presses[0].file)


def _stop_advice(made: SpringMap) -> Iterator[Finding]:
    """Name what the law of a rig leaves out of a bump stop."""
    curve = made.curve
    if curve.has_unloading:
        yield finding(
            "springs.stop_hysteresis", "curve", curve.loss_factor.value,
            share=curve.loss_factor.value, force=float(np.nanmax(curve.hysteresis)),
        )  # fmt: skip
    if made.law is not None and made.law.misses > _MISSES:
        yield finding("springs.stop_law_misses", "law", made.law.misses, share=made.law.misses)
    if len([item for item in made.curves if math.isfinite(item.speed)]) < 2:
        yield finding("springs.speed_unknown", "curves")


def _in_rig(made: SpringMap, rig: str, presses: Sequence[Press]) -> str:
    """Return the text of a rig file with the law, and a comment about its source at the top."""
    described = load(rig)
    files = ", ".join(press.file for press in presses)
    if made.part == "bump-stop":
        changes: dict[str, Any] = {"strut.bump_stop": made.bump_stop}
        place = "strut.bump_stop"
    else:
        place = "strut.spring"
        changes = {
            place: _spring_table(made, described.model_dump(by_alias=True, exclude_none=True))
        }
    path = rig_path(rig)
    text = updated_text(
        path.read_text(encoding="utf-8"), described.with_changes(changes), str(path)
    )
    return f"# {place}: {_provenance(made)}; {files}\n{text}"


def _provenance(made: SpringMap) -> str:
    """Write how a law was measured."""
    curve = made.curve
    half = float(np.nanmax(0.5 * (curve.high - curve.low)))
    speed = "" if math.isnan(curve.speed) else f" at {curve.speed:.4g} m/s"
    return (
        f"{made.shape} {made.part} measured on a press{speed} up to {1e3 * float(curve.deflection[-1]):.4g} mm; "
        f"95 % interval of the force within +-{half:.3g} N"
    )


def _spring_table(made: SpringMap, rig: Mapping[str, Any]) -> dict[str, Any]:
    """Return the table of a spring for a rig: a curve begins at the deflection of the rig's preload."""
    old = rig.get("strut", {}).get("spring")
    if old is None:
        raise OutputError("the rig has no spring at its strut", where="--rig")
    kept = {key: value for key, value in old.items() if key not in ("rate", "curve")}
    table = made.spring
    preload = float(kept.get("preload") or 0.0)
    if "rate" in table or preload == 0.0 or "free_length" in kept:
        return {**kept, **table}
    curve = made.curve
    if not curve.force[0] <= preload < curve.force[-1]:
        raise DescriptionError(
            "the preload of the rig lies beyond the record", where="strut.spring.preload",
            found=f"{preload:g} N",
            allowed=Phrase("{low:g} to {high:g} N", low=curve.force[0], high=curve.force[-1]),
        )  # fmt: skip
    begin = float(np.interp(preload, curve.force, curve.deflection))
    shifted = {
        "kind": "table",
        "deflection": (curve.deflection - begin).tolist(),
        "force": (np.maximum.accumulate(curve.force) - preload).tolist(),
    }
    return {**kept, "curve": shifted}
