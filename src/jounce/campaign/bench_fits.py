"""Fits of single components to bench files: a damper law, the damping of free decays, a stiffness."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from jounce.campaign.characterise import read_force_deflection
from jounce.core.errors import DescriptionError, OutputError, RecordingError, nearest
from jounce.core.files import matching_files
from jounce.core.findings import Finding
from jounce.core.operation import Count, File, MadeBy, Mark, Number, Switch, Texts, operation
from jounce.core.phrases import Phrase
from jounce.core.serialise import Plain, to_plain
from jounce.core.shown import Shown
from jounce.core.typed import positive_quantity, quantity
from jounce.core.types import Array
from jounce.core.waiting import progress_through
from jounce.identify.damper import damper_curve, fit_damper
from jounce.identify.damper_laws import LawName
from jounce.identify.damper_record import VelocityFrom
from jounce.identify.damper_result import DamperCurve, DamperResult
from jounce.identify.decay import CombinedDecay, DecayResult, Drag, combine_decays, fit_decay
from jounce.identify.force_deflection import Branch, ForceDeflectionTrial
from jounce.identify.motion import (
    MOTIONS,
    QUANTITY_OF_UNIT,
    MeasuredMotion,
    motion_of,
    unit_in_words,
)
from jounce.identify.motion import Quantity as MotionQuantity
from jounce.identify.signs import (
    ForcePositive,
    StrokePositive,
    check_stroke,
    compression_positive,
    sign_of,
)
from jounce.identify.stiffness import Intercept, Law, StiffnessResult, fit_stiffness
from jounce.parts import load, rig_path
from jounce.parts.files import changed_text
from jounce.parts.rig import unit_of
from jounce.recordings.formats import TableFormat
from jounce.recordings.options import (
    COLUMNS,
    VARIABLE,
    AnyRecordFile,
    AnyRecordFiles,
    as_record_file,
)

if TYPE_CHECKING:
    import xarray as xr

STROKE_SIGN = Mark(
    "Positive direction of the stroke; default: compression.", "compression|extension"
)
FORCE_SIGN = Mark("Positive direction of the force; default: compression.", "compression|tension")
LONGEST = 10.0
"""Deflection (m) above which a number without unit is refused."""


def title_of(files: Sequence[Path]) -> str:
    """Return the name of the file, or of the first and last of several."""
    return files[0].stem if len(files) == 1 else f"{files[0].stem} to {files[-1].stem}"


# damper ---------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class MeasuredDamper(Plain):
    """A damper law with the record that it was fitted to.

    Attributes
    ----------
    fit : DamperResult
        Fitted law.
    curve : DamperCurve
        Measured and fitted force for comparison.
    findings : tuple of Finding
        Findings of the reader and of the fit.
    """

    fit: DamperResult
    curve: DamperCurve
    findings: tuple[Finding, ...]

    def __str__(self) -> str:
        return str(self.fit)

    def to_dict(self) -> dict[str, Any]:
        """Return the law as plain values, SI."""
        return {**to_plain(self.fit), "findings": to_plain(self.findings)}


@operation(
    "fit damper",
    echo={"file": "record"},
    offers=("figure", "report"),
    page="jounce.report.fits:measured_damper_page",
    title="{record}",
    doing="fitting",
    example="jounce fit damper record.csv --law bouc-wen",
)
def fit_measured_damper(
    record: AnyRecordFile,
    law: Annotated[
        LawName, Mark("linear, bilinear, blow-off, polynomial, tanh-hysteretic or bouc-wen.")
    ] = "linear",
    *,
    degree: Annotated[int, Count("Degree of the polynomial.", least=1, most=9)] = 3,
    odd: Annotated[bool, Switch("Use odd powers only.")] = False,
    friction: Annotated[bool, Switch("Add dry friction to a law of velocity.")] = False,
    velocity_from: Annotated[
        VelocityFrom,
        Mark("recorded, or displacement to differentiate it even if a velocity was recorded."),
    ] = "recorded",
    stroke_positive: Annotated[StrokePositive | None, STROKE_SIGN] = None,
    force_positive: Annotated[ForcePositive | None, FORCE_SIGN] = None,
) -> MeasuredDamper:
    """Fit a damper law to a record of imposed motion and force.

    Stroke and force are positive in compression, unless the options state otherwise. The signs are checked against the
    record (a damper dissipates energy, gas pressure extends it); the fitted law is positive in compression.

    Parameters
    ----------
    record : RecordFile, str or Path
        Record with channels ``displacement`` (m), ``force`` (N), over time (s), and ``velocity`` (m/s) if recorded.
    law : {"linear", "bilinear", "blow-off", "polynomial", "tanh-hysteretic", "bouc-wen"}
        Damper law to fit.
    degree : int
        Degree of a polynomial law.
    odd, friction : bool
        Whether a polynomial has odd powers only, and whether dry friction is fitted in addition to a velocity law.
    velocity_from : {"recorded", "displacement"}
        Source of the velocity: the recorded channel, or the derivative of the displacement.
    stroke_positive, force_positive : str, optional
        Positive direction of the stroke ("compression", "extension") and of the force ("compression", "tension").

    Returns
    -------
    MeasuredDamper
        Law as returned by :func:`jounce.fit_damper`, SI.

    Raises
    ------
    RecordingError
        If displacement or force is missing in the record.

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> time = np.arange(0.0, 4.0, 2e-3)
    >>> stroke = 0.01 * np.sin(9.0 * time)
    >>> channels = {"displacement": (stroke, "m", ""), "force": (45.0 * np.cos(9.0 * time), "N", "")}
    >>> record = jn.RecordFile("sine.csv", jn.recording(time, channels))
    >>> round(fit_measured_damper(record).fit.parameters["coefficient"].value)
    500
    """
    given = as_record_file(record)
    data = given.data
    for name in ("displacement", "force"):
        if name not in data:
            raise RecordingError(
                Phrase("no column {name!r}", name=name),
                where=str(given.path),
                found=", ".join(map(str, data.data_vars)),
                hint=Phrase("Name its column: --columns {name}='COLUMN [unit]'.", name=name),
            )
    velocity = data["velocity"].to_numpy() if "velocity" in data else None
    measured = (
        data["displacement"].to_numpy(),
        velocity,
        data["force"].to_numpy(),
        data["time"].to_numpy(),
    )
    fit = fit_damper(
        *measured,
        law=law,
        degree=degree,
        odd=odd,
        friction=friction,
        velocity_from=velocity_from,
        stroke_positive=stroke_positive,
        force_positive=force_positive,
        name=Path(given.path).name,
    )
    curve = damper_curve(fit, *measured, velocity_from=velocity_from)
    return MeasuredDamper(fit, curve, (*given.findings, *fit.findings))


# decay ----------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class MeasuredDecays(Plain):
    """Damping from free decays, with their records.

    Attributes
    ----------
    fit : DecayResult or CombinedDecay
        Damping from a single decay, or from all decays combined.
    decays : mapping of str to (DecayResult, ndarray, ndarray)
        Result of each decay by file name, with its time (s) and recorded signal (SI), shape (n,).
    title : str
        Short form of the file names.
    findings : tuple of Finding
        Findings of the reader and of the fits.
    """

    fit: DecayResult | CombinedDecay
    decays: Mapping[str, tuple[DecayResult, Array, Array]]
    title: str
    findings: tuple[Finding, ...]

    def __str__(self) -> str:
        return str(self.fit)

    def to_dict(self) -> dict[str, Any]:
        """Return the damping as plain values, SI; keys distinguish forces from torques."""
        unknown = {"value": None, "standard_error": None, "interval": None}
        force = f"coulomb_{MOTIONS[self.fit.motion].force_word}"
        names = {name: name for name in _ESTIMATES} | {"coulomb_force": force}
        decrement = self.fit.logarithmic_decrement
        return {
            "motion": self.fit.motion,
            **{key: to_plain(getattr(self.fit, name)) or unknown for name, key in names.items()},
            "logarithmic_decrement": decrement.value,
            "logarithmic_decrement_standard_error": decrement.standard_error,
            "equivalent_damping_ratio": self.fit.equivalent_damping_ratio.value,
            "decrements": list(getattr(self.fit, "decrements", ())),
            "cycles": self.fit.cycles,
            "r2": getattr(self.fit, "r2", None),
            "findings": to_plain(self.findings),
        }


_ESTIMATES = (
    "damping_ratio",
    "damping_coefficient",
    "coulomb_force",
    "quadratic_drag",
    "natural_frequency_hz",
    "equilibrium",
    "stiffness",
)


@operation(
    "fit decay",
    named={"begin": "from", "end": "to"},
    echo={"files": "measured", "channel": "channel"},
    offers=("figure", "report"),
    check="jounce.campaign.bench_fits:check_decay",
    page="jounce.report.fits:measured_decays_page",
    title="{result.title}",
    doing="fitting",
    example='jounce fit decay decay_1.csv --channel sprung.z --mass "16 kg"',
)
def fit_measured_decays(
    records: AnyRecordFiles,
    channel: Annotated[
        str, Mark("Displacement, velocity or acceleration, e.g. sprung.z, or an angle or its rate.")
    ],
    *,
    mass: Annotated[
        float | str | None,
        Number('Oscillating mass, e.g. "16 kg".', "MASS", "kg", is_positive=True),
    ] = None,
    inertia: Annotated[
        float | str | None,
        Number(
            'Moment of inertia of a rotating part (angle, rate gyro), e.g. "0.8 kg*m^2".',
            "INERTIA",
            "kg*m^2",
            is_positive=True,
        ),
    ] = None,
    stiffness: Annotated[
        float | str | None,
        Mark("Known stiffness to compare with the one from mass and frequency.", "STIFFNESS"),
    ] = None,
    begin: Annotated[
        float | str | None, Number('Ignore samples before this time, e.g. "1.2 s".', "TIME", "s")
    ] = None,
    end: Annotated[
        float | str | None, Number("Ignore samples after this time.", "TIME", "s")
    ] = None,
    quadratic_drag: Annotated[
        Drag, Mark("Also fit quadratic drag; auto: if the record shows it.", "auto|yes|no")
    ] = "auto",
    stroke_positive: Annotated[StrokePositive | None, STROKE_SIGN] = None,
    progress: Callable[[str], None] = lambda _: None,
) -> MeasuredDecays:
    """Separate viscous damping, dry friction and quadratic drag in a free decay.

    For a pendulum or another rotating part, give the inertia instead of the mass; results are then in N m, N m s/rad
    and N m/rad. The damping does not depend on the sign of the record; the equilibrium of a deflection is positive in
    compression.

    Parameters
    ----------
    records : sequence of RecordFile, str or Path
        Recordings of free decays; several are combined.
    channel : str
        Recorded channel: a displacement (m), velocity (m/s) or acceleration (m/s^2), or an angle (rad) or its rates.
    mass, inertia : float or str, optional
        Oscillating mass (kg) for translation, or moment of inertia about the axis (kg m^2) for rotation.
    stiffness : float or str, optional
        Known stiffness (N/m or N m/rad), compared with the stiffness from mass and frequency.
    begin, end : float or str, optional
        Window of the record to use, s.
    quadratic_drag : {"auto", "yes", "no"}
        Whether to fit quadratic drag; "auto" fits it if the record shows it.
    stroke_positive : {"compression", "extension"}, optional
        Positive direction of a recorded stroke.
    progress : callable
        Called with a text that describes the current step.

    Returns
    -------
    MeasuredDecays
        Results as returned by :func:`jounce.fit_decay`, SI.

    Raises
    ------
    RecordingError
        If the channel is missing or does not describe a motion.
    DescriptionError
        If mass or inertia is missing.

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> time = np.arange(0.0, 4.0, 2e-3)
    >>> swing = 0.02 * np.exp(-3.7 * time) * np.cos(33.7 * time)
    >>> record = jn.RecordFile("decay.csv", jn.recording(time, {"sprung.z": (swing, "m", "")}))
    >>> round(fit_measured_decays([record], "sprung.z", mass="16 kg").fit.damping_coefficient.value, 1)
    118.4
    """
    check_stroke(channel, stroke_positive, where="stroke_positive")
    files = [as_record_file(record) for record in records]
    paths = [Path(file.path) for file in files]
    names = [
        path.name if len({other.name for other in paths}) == len(paths) else str(path)
        for path in paths
    ]
    decays: dict[str, tuple[DecayResult, Array, Array]] = {}
    for number, (name, file) in enumerate(zip(names, files, strict=True), 1):
        progress(
            progress_through(
                "fitting {which} of {count}: {name}", number, len(files), name=Path(file.path).name
            )
        )
        data = compression_positive(file.data, stroke_positive, None)
        signal, kind = _motion_in(data, channel, str(file.path))
        motion, time = motion_of(kind), data["time"].to_numpy()
        known = (
            None
            if stiffness is None
            else positive_quantity(str(stiffness), motion.stiffness, "stiffness")
        )
        fit = fit_decay(
            time,
            signal,
            **_inertia(mass, inertia, motion, channel),
            stiffness=known,
            quantity=kind,
            begin=begin,
            end=end,
            quadratic_drag=quadratic_drag,
            name=Path(file.path).name,
        )
        decays[name] = fit, time, signal
    fits = [fit for fit, _, _ in decays.values()]
    together = fits[0] if len(fits) == 1 else combine_decays(fits)
    notes = [note for file in files for note in file.findings]
    return MeasuredDecays(together, decays, title_of(paths), (*notes, *together.findings))


def check_decay(
    *,
    measured: Sequence[str],
    channel: str,
    stroke_positive: Any,
    figure: Path | None,
    **_others: Any,
) -> None:
    """Refuse invalid signs, and a figure of more than one decay."""
    sign_of(stroke_positive, "stroke", where="--stroke-positive")
    check_stroke(channel, stroke_positive, where="--stroke-positive")
    count = len(matching_files(measured, "FILE"))
    if figure is not None and count > 1:
        raise OutputError(
            "a figure shows only one decay",
            where="--figure",
            found=f"{count} files",
            hint="Use --report for several files.",
        )


def _inertia(
    mass: float | str | None, inertia: float | str | None, motion: MeasuredMotion, channel: str
) -> dict[str, float]:
    """Return the mass (translation) or the moment of inertia (rotation) as an argument of the fit."""
    given = {"mass": mass, "inertia": inertia}
    own = given.pop(motion.inertia_word)
    ((other, wrong),) = given.items()
    if own is None or wrong is not None:
        raise DescriptionError(
            Phrase(
                "the {inertia_word} of the oscillating body is required",
                inertia_word=Phrase(motion.inertia_word),
            )
            if own is None
            else Phrase("no {other} swings here", other=other),
            where=motion.inertia_word if own is None else other,
            found=f"{channel} is {'an angle or its rate' if motion.name == 'rotation' else 'a motion along a line'}",
            allowed=Phrase(
                '--{inertia_word} "NUMBER {inertia}"',
                inertia_word=motion.inertia_word,
                inertia=motion.inertia,
            ),
        )
    return {motion.inertia_word: positive_quantity(str(own), motion.inertia, motion.inertia_word)}


def _motion_in(data: xr.Dataset, channel: str, file: str) -> tuple[Array, MotionQuantity]:
    """Return the samples of the channel and their kind of motion."""
    names = [str(name) for name in data.data_vars]
    if channel not in names:
        raise RecordingError(
            Phrase("no channel {channel!r}", channel=channel),
            where=file,
            found=", ".join(names),
            hint=nearest(channel, names) or "Name the column with --columns.",
        )
    unit = data[channel].attrs["units"]
    if unit not in QUANTITY_OF_UNIT:
        raise RecordingError(
            "invalid motion",
            where=f"{file}: {channel}",
            found=unit,
            allowed="a displacement, velocity or acceleration, or an angle and its derivatives",
        )
    return data[channel].to_numpy(), QUANTITY_OF_UNIT[unit]


# stiffness ------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class BenchFiles(Shown):
    """Trials of a test machine as read: files, trials, and the reader's findings."""

    files: Sequence[Path]
    trials: Sequence[ForceDeflectionTrial]
    findings: Sequence[Finding] = ()


AnyBenchFiles = Annotated[
    "BenchFiles | Sequence[str | Path]",
    MadeBy(
        "jounce.campaign.bench_fits:read_bench_files", "jounce.campaign.bench_fits:trials_in_python"
    ),
]
"""Trials of a test machine; user interfaces request files, columns and signs."""


def read_bench_files(
    measured: Annotated[
        Sequence[str | Path],
        Texts("Trials: columns displacement and force, or angle and torque.", "FILES"),
    ],
    columns: Annotated[Any, COLUMNS] = None,
    variable: Annotated[str, VARIABLE] = "",
    stroke_positive: Annotated[StrokePositive | None, STROKE_SIGN] = None,
    force_positive: Annotated[ForcePositive | None, FORCE_SIGN] = None,
) -> BenchFiles:
    """Read trials of a test machine.

    Parameters
    ----------
    measured : sequence of str or Path
        File names or patterns; the files have the columns displacement and force, or angle and torque.
    columns : mapping, optional
        Name of the column for each quantity.
    variable : str
        Variable, group or sheet to read from the file.
    stroke_positive, force_positive : str, optional
        Positive direction of the stroke ("compression", "extension") and of the force ("compression", "tension").

    Returns
    -------
    BenchFiles
        Trials in SI.

    Raises
    ------
    RecordingError
        If no file matches or a file does not contain such a trial.

    Examples
    --------
    >>> read_bench_files(["no-*.csv"])
    Traceback (most recent call last):
        ...
    jounce.core.errors.RecordingError: FILES: no file matches; found 'no-*.csv'. Check the folder and the pattern.
    """
    sign_of(stroke_positive, "stroke", where="stroke_positive")
    sign_of(force_positive, "force", where="force_positive")
    files = matching_files([str(name) for name in measured], "FILES")
    table = TableFormat(columns=columns or {}, variable=variable)
    motions = tuple(MOTIONS.values())
    return BenchFiles(
        files, *read_force_deflection(files, table, stroke_positive, force_positive, motions)
    )


def trials_in_python(measured: Sequence[str], **options: Any) -> str:
    """Return a Python expression for the trials.

    >>> trials_in_python(["spring_1.csv"]), trials_in_python(["spring_1.csv"], force_positive="tension")
    ("['spring_1.csv']", "jn.read_bench_files(['spring_1.csv'], force_positive='tension')")
    """
    texts = "".join(f", {name}={value!r}" for name, value in options.items())
    return f"jn.read_bench_files({measured!r}{texts})" if options else repr(measured)


@dataclass(frozen=True)
class MeasuredStiffness(Plain):
    """A stiffness with the trials that it was fitted to.

    Attributes
    ----------
    fit : StiffnessResult
        Fitted stiffness.
    measured : BenchFiles
        Measured trials.
    rig_text : str
        Text of a rig file with the fitted rate; empty if no rig was given.
    findings : tuple of Finding
        Findings of the reader and of the fit.
    """

    fit: StiffnessResult
    measured: BenchFiles
    rig_text: str = field(default="", repr=False)
    findings: tuple[Finding, ...] = ()

    @property
    def title(self) -> str:
        """Short form of the file names."""
        return title_of(self.measured.files)

    def __str__(self) -> str:
        return str(self.fit)

    def to_dict(self) -> dict[str, Any]:
        """Return the stiffness as plain values, SI."""
        files = [str(file) for file in self.measured.files]
        return {"files": files, **to_plain(self.fit), "findings": to_plain(self.findings)}


@operation(
    "fit stiffness",
    named={"operating_force": "load"},
    offers=("rig_text", "figure", "report"),
    check="jounce.campaign.bench_fits:check_stiffness",
    page="jounce.report.fits:measured_stiffness_page",
    title="{result.title}",
    doing="fitting",
    example='jounce fit stiffness tyre_031_*.csv --discard-below "2 mm" --intercept drop --load "206 N"',
)
def fit_measured_stiffness(
    trials: AnyBenchFiles,
    law: Annotated[Law, Mark("linear, polynomial, power or monotone-spline.")] = "linear",
    *,
    degree: Annotated[int, Count("Degree of the polynomial.", least=1, most=9)] = 3,
    discard_below: Annotated[
        float | str | None,
        Mark('Ignore smaller deflections, e.g. "2 mm", or angles.', "DEFLECTION"),
    ] = None,
    intercept: Annotated[
        Intercept,
        Mark("Intercept: drop (F = k x), shift (F = k (x - x0)) or keep (F = k x + b, a preload)."),
    ] = "drop",
    branch: Annotated[Branch, Mark("loading, unloading or both.")] = "loading",
    operating_force: Annotated[
        float | str | None,
        Mark(
            'Static load of the part, e.g. "206 N", or torque; a finding warns if the fit does not cover it.',
            "LOAD",
        ),
    ] = None,
    rig: Annotated[
        str | None, File("Rig to write the rate into: name or file.", "RIG", ("parts",))
    ] = None,
    part: Annotated[
        str | None, Mark("Rate of the rig to replace; strut.spring.rate by default.", "PART")
    ] = None,
) -> MeasuredStiffness:
    """Fit the stiffness of a spring, a tyre or a torsional component to repeated trials.

    Stroke and force are positive in compression, unless the options or the record state otherwise. Files with the
    columns angle and torque give a rate in N m/rad.

    Parameters
    ----------
    trials : BenchFiles or sequence of str or Path
        Measured trials, or the names of their files.
    law : {"linear", "polynomial", "power", "monotone-spline"}
        Force law to fit.
    degree : int
        Degree of a polynomial law.
    discard_below : float or str, optional
        Deflection below which points are ignored, m or rad.
    intercept : {"drop", "shift", "keep"}
        Treatment of the force at zero deflection.
    branch : {"loading", "unloading", "both"}
        Part of each trial that is fitted.
    operating_force : float or str, optional
        Static load of the part, N or N m.
    rig : str, optional
        Rig into whose file the rate is written, SI.
    part : str, optional
        Rate of the rig to replace, ``strut.spring.rate`` by default.

    Returns
    -------
    MeasuredStiffness
        Stiffness as returned by :func:`jounce.fit_stiffness`, SI.

    Raises
    ------
    OutputError
        If the part of the rig does not accept such a rate.

    Examples
    --------
    >>> import numpy as np
    >>> from jounce.identify.force_deflection import Branch, ForceDeflectionTrial
    >>> x = np.linspace(0.0, 0.015, 31)
    >>> measured = BenchFiles([Path("spring.csv")], [ForceDeflectionTrial(x, 22.7e3 * x, "spring.csv")])
    >>> round(fit_measured_stiffness(measured).fit.stiffness.value)
    22700
    """
    measured = trials if isinstance(trials, BenchFiles) else read_bench_files(trials)
    motion = MOTIONS[measured.trials[0].motion]
    longest = LONGEST if motion.name == "translation" else None
    fit = fit_stiffness(
        measured.trials,
        law=law,
        degree=degree,
        discard_below=_optional_quantity(discard_below, motion.deflection, "discard_below", longest)
        or 0.0,
        intercept=intercept,
        branch=branch,
        operating_force=_optional_quantity(operating_force, motion.force, "operating_force"),
    )
    source = f"{fit.law} law of {title_of(measured.files)}"
    text = "" if rig is None else _with_rate(fit, rig, part or "strut.spring.rate", source)
    return MeasuredStiffness(fit, measured, text, (*measured.findings, *fit.findings))


def _optional_quantity(
    value: float | str | None, unit: str, where: str, most: float | None = None
) -> float | None:
    return None if value is None else quantity(str(value), unit, where, most=most)


def check_stiffness(*, rig: Any, part: str | None, out: Path | None, **_others: Any) -> None:
    """Refuse a rig without an output file, and a part without a rig."""
    if (rig is None) != (out is None):
        raise OutputError(
            "--rig and --out must be given together",
            where="--rig",
            allowed="--rig and --out",
        )
    if part is not None and rig is None:
        raise OutputError(
            "a part is named without a rig",
            where="--part",
            found=part,
            allowed="--part with --rig and --out",
        )


def _with_rate(fit: StiffnessResult, rig: str, part: str, source: str) -> str:
    """Return the text of a rig file with a measured rate, and a comment about its source at the top."""
    rate, motion, described = fit.stiffness, MOTIONS[fit.motion], load(rig)
    if part in described.parameters() and (takes := unit_of(described, part)) != motion.stiffness:
        raise OutputError(
            "the part has no such rate",
            where="--part",
            found=f"{unit_in_words(motion.stiffness)} for {part}",
            allowed=Phrase(
                "a part whose stiffness is in {stiffness}; this part needs {takes}",
                stiffness=unit_in_words(motion.stiffness),
                takes=unit_in_words(takes),
            ),
        )
    text = changed_text(rig_path(rig).read_text(encoding="utf-8"), described, {part: rate.value})
    low, high = rate.interval or (rate.value, rate.value)
    unit = unit_in_words(motion.stiffness)
    doubt = f"95 % interval {low:.6g} to {high:.6g} {unit}" if rate.interval else "interval unknown"
    return f"# {part}: {rate.value:.6g} {unit}, {doubt}; {source}\n{text}"
