"""Damper laws fitted to measured displacement, velocity and force."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Annotated, Any, Literal, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from jounce.core.catalogue import Severity
from jounce.core.errors import FitError, unknown
from jounce.core.findings import Finding
from jounce.core.results import Shows
from jounce.core.samples import as_samples
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.identify.decay import zigzag
from jounce.identify.estimate import Estimate, central_differences, linear_least_squares, r_squared, uncertainty
from jounce.identify.low_pass import low_pass_corner
from jounce.identify.noise import lost_samples, noise_of, quantum_of
from jounce.identify.signs import ForcePositive, Signs, StrokePositive, closed_part, damper_signs, sign_of
from jounce.recordings.carried import as_recording, clock_of, damper_channels
from jounce.recordings.quality import clipped_share, frozen_samples

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

VelocityFrom = Literal["recorded", "displacement"]
LawName = Literal["linear", "bilinear", "polynomial", "tanh-hysteretic", "bouc-wen"]
LAWS: tuple[LawName, ...] = get_args(LawName)
_VELOCITY_LAWS = ("linear", "bilinear", "polynomial")


# the record -----------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class DamperMotion:
    """Displacement, velocity and force of a damper while it moves, compression positive.

    ``displacement`` (m) counts from ``centre`` (m), the middle of the stroke in the record; ``force`` (N) is positive
    where it resists compression. ``velocity_resolution`` is the smallest difference between two recorded velocities
    (m/s), 0 where they are not quantised. ``signs`` are those of the record it was read from.
    """

    time: Array
    displacement: Array
    velocity: Array
    force: Array
    centre: float
    cycles: float
    velocity_resolution: float
    signs: Signs

    @property
    def stroke(self) -> float:
        """Largest minus smallest displacement [m]."""
        return float(np.ptp(self.displacement))

    @property
    def peak_velocity(self) -> float:
        """Largest speed [m/s]."""
        return float(np.abs(self.velocity).max())


def read_motion(
    displacement: ArrayLike,
    velocity: ArrayLike | None,
    force: ArrayLike,
    time: ArrayLike,
    *,
    velocity_from: VelocityFrom = "recorded",
    stroke_positive: StrokePositive | None = None,
    force_positive: ForcePositive | None = None,
    name: str = "damper",
) -> tuple[DamperMotion, list[Finding]]:
    """Check a damper record (m, m/s, N, s), make compression positive and cut off the rest at both ends.

    Without a velocity, or with ``velocity_from="displacement"``, the derivative of the displacement is used: central
    differences, or slopes of cubics through as many samples as its noise asks for, since noise in a velocity makes
    coefficients too small. A recorded velocity counts as the displacement does. How the record counts is stated or
    found, with findings: :mod:`jounce.identify.signs`.

    Raises
    ------
    FitError
        Unequal lengths, fewer than 50 samples, NaN, time that does not increase, no motion, less than one cycle.
    """
    if velocity_from not in ("recorded", "displacement"):
        raise unknown(str(velocity_from), ("recorded", "displacement"), what="velocity_from", where=name)
    columns = {
        "displacement": (displacement, "m"),
        "velocity": (velocity, "m/s"),
        "force": (force, "N"),
        "time": (time, "s"),
    }
    arrays = {
        key: as_samples(value, si, where=f"{name}: {key}", error=FitError)
        for key, (value, si) in columns.items()
        if value is not None or key != "velocity"
    }
    _check(arrays, name)
    sign_of(stroke_positive, "stroke", where=name), sign_of(force_positive, "force", where=name)
    findings: list[Finding] = []
    x, f, t = arrays["displacement"], arrays["force"], arrays["time"]
    lost = _without_dropouts(arrays, name, findings)
    x = arrays["displacement"]
    derivative = np.asarray(np.gradient(x, t))
    resolution = 0.0
    uses_derivative = "velocity" not in arrays or velocity_from == "displacement"
    if "velocity" in arrays:
        arrays["velocity"] = _as_the_stroke(arrays["velocity"], derivative, name, findings)
        resolution = _check_velocity(arrays["velocity"], derivative, t, velocity_from, name, findings)
    else:
        findings.append(Finding(name, "note", "no velocity was given: the derivative of the displacement is used."))
    v = _rate(x, t, derivative, name, findings) if uses_derivative else arrays["velocity"]
    findings += [*_out_of_range({"displacement": x, "force": f}, name)]
    if uses_derivative and (jumps := lost_samples(t, x)):
        text = (
            f"the displacement jumps at {jumps} places as if samples were missing there, though the time goes on: the "
            "derivative is wrong there and everywhere too large; give the recorded time, or the velocity."
        )
        findings.append(Finding(name, "problem", text, float(jumps)))
    first, last = _moving_part(x, name, findings)
    sound = np.flatnonzero(~lost[first:last]) + first
    x, v, f, t, derivative = (column[sound] for column in (x, v, f, t, derivative))
    cycles = _cycles(x)
    if cycles < 0.95:
        raise FitError("less than one cycle of motion", where=name, found=f"{cycles:g} cycles", allowed="at least 1")
    signs = damper_signs(
        x, derivative, f, stroke_positive=stroke_positive, force_positive=force_positive, name=name, findings=findings
    )
    x, v, f = signs.stroke * x, signs.stroke * v, signs.force * f
    centre = 0.5 * float(x.max() + x.min())
    return DamperMotion(t, x - centre, v, f, centre, cycles, resolution, signs), findings


def _check(arrays: dict[str, Array], name: str) -> None:
    lengths = {key: value.shape for key, value in arrays.items()}
    if len(set(lengths.values())) > 1 or any(value.ndim != 1 for value in arrays.values()):
        raise FitError("the columns are not of the same length", where=name, found=str(lengths))
    if len(arrays["time"]) < 50:
        raise FitError("too few samples", where=name, found=len(arrays["time"]), allowed="at least 50")
    for key, value in arrays.items():
        bad = np.flatnonzero(~np.isfinite(value))
        if len(bad):
            raise FitError("a value is missing or not finite", where=name, found=f"{key}, sample {bad[0] + 1}")
    if np.any(np.diff(arrays["time"]) <= 0.0):
        place = int(np.argmax(np.diff(arrays["time"]) <= 0.0)) + 2
        raise FitError("the time does not increase", where=name, found=f"sample {place}")
    if np.ptp(arrays["displacement"]) == 0.0 or np.ptp(arrays["force"]) == 0.0:
        raise FitError("displacement or force never changes", where=name, hint="Are these the right columns?")


def _without_dropouts(arrays: dict[str, Array], name: str, findings: list[Finding]) -> NDArray[np.bool_]:
    """Mark what the logger lost while the machine moved, and bridge the displacement there for its derivative."""
    lost = np.zeros(len(arrays["time"]), bool)
    for column in ("displacement", "velocity", "force"):
        if column in arrays and (marks := frozen_samples(arrays[column])).any():
            text = (
                f"the {column} stands still at {np.count_nonzero(marks)} samples while the record goes on, and jumps: "
                "dropouts of the logger, which were left out."
            )
            findings.append(Finding(name, "warning", text, float(np.count_nonzero(marks))))
            lost |= marks
            if column == "displacement":
                time, bridged = arrays["time"], arrays[column].copy()
                bridged[marks] = np.interp(time[marks], time[~marks], bridged[~marks])
                arrays[column] = bridged
                lost |= np.convolve(marks, np.ones(2 * _BESIDE + 1), mode="same") > 0.0
    return lost


_BESIDE = 8  # samples beside a bridge whose derivative it spoils


def _out_of_range(columns: Mapping[str, Array], name: str) -> list[Finding]:
    """Columns that lie flat at their limits, entered by a jump: no law can tell what was there."""
    found = []
    for column, values in columns.items():
        share = clipped_share(values)
        if share > _CLIPPED:
            flat = f"{100.0 * share:.2g} % of the samples of the {column} lie flat at its limits"
            if column == "force":
                text = f"{flat}: the load cell or its amplifier was out of range, and every law fitted to it is wrong; "
                found.append(Finding(name, "problem", text + "measure again with a larger range.", share))
            else:
                text = f"{flat}: does the machine dwell there, or was the sensor out of range? Then the law is wrong."
                found.append(Finding(name, "warning", text, share))
    return found


_CLIPPED = 2e-3  # of the samples


def _as_the_stroke(velocity: Array, derivative: Array, name: str, findings: list[Finding]) -> Array:
    """Give the velocity with the sign of the displacement's derivative."""
    gain = float(velocity @ derivative) / float(derivative @ derivative)
    if gain > -0.5:
        return velocity
    text = (
        f"the recorded velocity is {gain:.3g} times the derivative of the displacement: it was recorded with the other "
        "sign and has been reversed."
    )
    findings.append(Finding(name, "warning", text, gain))
    return -velocity


def _check_velocity(
    velocity: Array, derivative: Array, time: Array, source: str, name: str, findings: list[Finding]
) -> float:
    """Compare the recorded velocity with the derivative of the displacement; give its resolution [m/s]."""
    power = float(derivative @ derivative)
    gain = float(velocity @ derivative) / power
    slope = np.gradient(derivative, time)
    delay = -float((velocity - derivative) @ slope) / float(slope @ slope)
    step = float(np.median(np.diff(time)))
    if abs(gain - 1.0) > 0.05:
        text = f"the recorded velocity is {gain:.3g} times the derivative of the displacement: check units and signs."
        findings.append(Finding(name, "problem", text, gain))
    elif abs(delay) > 0.2 * step and source == "recorded":
        text = (
            f"the recorded velocity is {1e3 * delay:.3g} ms ({delay / step:.2f} samples) behind the displacement, "
            "as a backward difference is; compare with velocity_from='displacement', a central difference."
        )
        findings.append(Finding(name, "warning", text, delay))
    resolution = quantum_of(np.round(velocity, 9))
    if resolution > 1e-3 * float(np.abs(velocity).max()):
        text = (
            f"the velocity is recorded in steps of {1e3 * resolution:.3g} mm/s: motion below a few of these is "
            "not resolved."
        )
        findings.append(Finding(name, "note", text, resolution))
    return resolution


def _rate(x: Array, t: Array, plain: Array, name: str, findings: list[Finding]) -> Array:
    """Derivative of a displacement (m/s), over as many samples as its noise asks for; ``plain`` is over three."""
    steps = np.diff(t)
    step = float(np.median(steps))
    turns = np.diff(zigzag(_calmed(x), 0.05 * float(np.ptp(x))))[1:]
    widest = int(_WIDEST * turns.min()) if len(turns) else 0
    noise = max(noise_of(x), quantum_of(x) / math.sqrt(12.0))
    if float(np.ptp(steps)) > 0.01 * step:
        widest = 0
    power = float(np.mean((_slope(x, widest) / step) ** 2 if widest > 1 else plain**2))

    def share(half: int) -> float:
        weights = _weights_of_slope(half) if half > 1 else np.array([0.5, 0.5])
        white = noise**2 * float(weights @ weights)
        return max(white, (0.5 * quantum_of(x) / (2 * half + 1)) ** 2) / (step**2 * power)

    half = 1
    while share(half) > _CALM and half < widest:
        half = min(max(half + 1, int(1.2 * half)), widest)
    left = share(half)
    if half > 1:
        text = f"the derivative of the displacement is taken over {2 * half + 1} samples, as its noise asks for."
        findings.append(Finding(name, "note", text, float(2 * half + 1)))
    if left > _NOISY:
        text = (
            f"noise of the displacement (about {1e3 * noise:.2g} mm) is some {100.0 * left:.2g} % of the mean square "
            "of its derivative, and coefficients come out too small by about as much: give a velocity, or filter it."
        )
        findings.append(Finding(name, "warning", text, left))
    return plain if half == 1 else _slope(x, half) / step


_CALM, _NOISY = 1e-4, 1e-2  # of the mean square of a velocity: noise that does no harm, and that is told
_WIDEST = 0.05  # of half a cycle: samples on either side over which a cubic follows the motion


def _calmed(x: Array) -> Array:
    """Average over a hundredth of a cycle or so, in which turning points are looked for."""
    width = max(1, len(x) // 2000) | 1
    return np.convolve(np.pad(x, width // 2, mode="edge"), np.ones(width) / width, mode="valid")


def _weights_of_slope(half: int) -> Array:
    """What the slope (a sample) of the cubic through ``2 half + 1`` samples in its middle takes of each of them."""
    place = np.arange(-half, half + 1) / half
    weights: Array = np.linalg.pinv(place[:, None] ** np.arange(4.0))[1] / half
    return weights


def _slope(x: Array, half: int) -> Array:
    """Slope (a sample) of cubics through ``2 half + 1`` samples, at the ends of the first and the last of them."""
    place = np.arange(-half, half + 1) / half
    inside = np.convolve(x, _weights_of_slope(half)[::-1], mode="valid")
    ends = [
        np.polyval(np.polyder(np.polyfit(place, part, 3)), place) / half
        for part in (x[: 2 * half + 1], x[-2 * half - 1 :])
    ]
    return np.concatenate([ends[0][:half], inside, ends[1][half + 1 :]])


def _moving_part(displacement: Array, name: str, findings: list[Finding]) -> tuple[int, int]:
    """First and last sample of the motion; short rests at the ends are kept."""
    still = 2e-3 * float(np.ptp(displacement))
    away = np.flatnonzero(np.abs(displacement - displacement[0]) > still)
    back = np.flatnonzero(np.abs(displacement - displacement[-1]) > still)
    first, last = max(int(away[0]) - 1, 0), min(int(back[-1]) + 2, len(displacement))
    first = first if first > 5 else 0
    last = last if len(displacement) - last > 5 else len(displacement)
    left_out = first + len(displacement) - last
    if left_out:
        text = f"{left_out} samples at rest at the ends were left out: at rest the force says nothing about velocity."
        findings.append(Finding(name, "note", text, float(left_out)))
    return first, last


def _cycles(displacement: Array, *, is_closed: bool = False) -> float:
    """Number of cycles: half the crossings of the middle, or the path over twice the stroke where that is more.

    What ``is_closed`` begins and ends at a crossing, which are one more than those within.
    """
    stroke = float(np.ptp(displacement))
    side = displacement - 0.5 * float(displacement.max() + displacement.min())
    clear = np.sign(side[np.abs(side) > 0.1 * stroke])
    turns = displacement[[*zigzag(displacement, 0.05 * stroke), len(displacement) - 1]]
    path = float(np.abs(np.diff(turns)).sum())
    return max(0.5 * float(np.count_nonzero(np.diff(clear)) + is_closed), path / (2.0 * stroke))


# laws -----------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class DamperLaw:
    """A force law F = sum of weights * columns(displacement, velocity, shapes).

    ``weights`` and ``shapes`` hold names and units of the factors of the columns and of the parameters that change the
    columns; shapes other than ``displacement_coupling`` are searched logarithmically, from ``starts`` (one row each)
    and within ``bounds``. Weights in ``not_negative`` cannot be negative. A law that ``remembers`` has a force that
    depends on the path so far, so the first swing only sets its state. ``table`` makes the damper table of a rig file
    from the parameters by name.
    """

    name: str
    weights: tuple[tuple[str, str], ...]
    shapes: tuple[tuple[str, str], ...]
    columns: Callable[[Array, Array, Array], Array]
    starts: Array
    bounds: tuple[Array, Array]
    not_negative: tuple[str, ...]
    remembers: bool
    table: Callable[[Mapping[str, float]], dict[str, Any]]


def damper_law(
    name: str, motion: DamperMotion, *, degree: int = 3, odd: bool = False, friction: bool = False
) -> DamperLaw:
    """Make a law for a motion, which sets its scales: start values, range of the table, friction regularisation.

    ``friction`` adds dry friction F_c tanh(v / v_r) to linear, bilinear and polynomial laws.

    Raises
    ------
    DescriptionError
        An unknown law.
    FitError
        A degree out of range, or friction for a law that has it already.
    """
    if name not in LAWS:
        raise unknown(str(name), LAWS, what="damper law")
    if name in ("tanh-hysteretic", "bouc-wen"):
        if friction:
            raise FitError(f"the law {name!r} contains dry friction already", allowed="friction only with F(v) laws")
        return _tanh(motion) if name == "tanh-hysteretic" else _bouc_wen(motion)
    if name == "polynomial" and not 1 <= degree <= 9:
        raise FitError("unusable degree of the polynomial", found=degree, allowed="1 to 9")
    return _velocity_law(name, motion, degree, odd, friction)


def regularisation_velocity(motion: DamperMotion) -> float:
    """Speed below which dry friction is smoothed [m/s]: 1 % of the peak, or two steps of the record if larger."""
    return max(0.01 * motion.peak_velocity, 2.0 * motion.velocity_resolution)


def _velocity_law(name: str, motion: DamperMotion, degree: int, odd: bool, friction: bool) -> DamperLaw:
    powers = [1] if name == "linear" else [p for p in range(1, degree + 1) if p % 2 or not odd]
    slow = regularisation_velocity(motion)
    extra = (("friction_force", "N"),) if friction else ()
    names: tuple[tuple[str, str], ...]
    if name == "bilinear":
        names = (("bump_coefficient", "N*s/m"), ("rebound_coefficient", "N*s/m"))
    elif name == "linear":
        names = (("coefficient", "N*s/m"),)
    else:
        names = tuple((f"a{p}", f"N*(s/m)^{p}") for p in powers)

    def columns(_x: Array, v: Array, _shapes: Array) -> Array:
        parts = [np.maximum(v, 0.0), np.minimum(v, 0.0)] if name == "bilinear" else [v**p for p in powers]
        parts += [np.tanh(v / slow)] if friction else []
        return np.column_stack([*parts, np.ones_like(v)])

    def table(values: Mapping[str, float]) -> dict[str, Any]:
        if name == "linear":
            return {"coefficient": values["coefficient"]}
        if name == "bilinear":
            return {key: values[key] for key in ("bump_coefficient", "rebound_coefficient")}
        speed = np.linspace(float(motion.velocity.min()), float(motion.velocity.max()), 41)
        speed = np.unique(np.append(speed, 0.0))
        force = sum(values[f"a{p}"] * speed**p for p in powers)
        return {"velocity": speed.tolist(), "force": np.asarray(force).tolist()}

    flags = ("friction_force",) if friction else ()
    no_shapes, no_bounds = np.zeros((1, 0)), (np.zeros(0), np.zeros(0))
    weights = (*names, *extra, ("offset", "N"))
    return DamperLaw(name, weights, (), columns, no_shapes, no_bounds, flags, False, table)


def _tanh(motion: DamperMotion) -> DamperLaw:
    def columns(x: Array, v: Array, shapes: Array) -> Array:
        slope, coupling = shapes
        return np.column_stack([v, x, np.tanh(slope * (v + coupling * x)), np.ones_like(v)])

    def table(values: Mapping[str, float]) -> dict[str, Any]:
        keys = ("coefficient", "stiffness", "force", "slope", "displacement_coupling", "offset")
        return {"kind": "tanh", **{key: values[key] for key in keys}}

    speed, reach = motion.peak_velocity, 0.5 * motion.stroke
    couplings = np.array([-0.3, -0.1, 0.0, 0.1, 0.3]) * speed / reach
    starts = np.array([[slope / speed, coupling] for slope in (1.5, 5.0, 15.0, 50.0) for coupling in couplings])
    limit = 10.0 * speed / reach
    finest = 0.5 / max(motion.velocity_resolution, 1e-3 * speed)
    return DamperLaw(
        "tanh-hysteretic",
        (("coefficient", "N*s/m"), ("stiffness", "N/m"), ("force", "N"), ("offset", "N")),
        (("slope", "s/m"), ("displacement_coupling", "1/s")),
        columns,
        starts,
        (np.array([0.2 / speed, -limit]), np.array([max(finest, 100.0 / speed), limit])),
        ("coefficient", "force"),
        False,
        table,
    )


def _bouc_wen(motion: DamperMotion) -> DamperLaw:
    from jounce.identify.hysteresis_path import bouc_wen_path

    def columns(x: Array, v: Array, shapes: Array) -> Array:
        rate, sigma, exponent = (float(shape) for shape in shapes)
        side = np.sign(x[np.argmax(np.abs(x - x[0]) > 0.05 * np.ptp(x))] - x[0])
        state = bouc_wen_path(np.ascontiguousarray(x), rate, sigma, exponent, -float(side))
        return np.column_stack([v, x, state, np.ones_like(v)])

    def table(values: Mapping[str, float]) -> dict[str, Any]:
        keys = ("coefficient", "stiffness", "hysteretic_force", "rate", "sigma", "exponent", "offset")
        return {"kind": "bouc-wen", **{key: values[key] for key in keys}}

    rates = np.array([4.0, 20.0, 100.0, 500.0]) / motion.stroke
    starts = np.array([[r, sigma, n] for r in rates for sigma in (0.6, 2.0, 20.0) for n in (1.1, 2.0)])
    return DamperLaw(
        "bouc-wen",
        (("coefficient", "N*s/m"), ("stiffness", "N/m"), ("hysteretic_force", "N"), ("offset", "N")),
        (("rate", "1/m"), ("sigma", "1"), ("exponent", "1")),
        columns,
        starts,
        (np.array([0.3 / motion.stroke, 0.5, 1.0]), np.array([1e4 / motion.stroke, 1e3, 10.0])),
        ("coefficient", "hysteretic_force"),
        True,
        table,
    )


# fit ------------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class DamperResult(Shown):
    """A damper law found from a record.

    Attributes
    ----------
    law : str
        Name of the law.
    parameters : dict of str to Estimate
        By name, SI; the standard errors allow for autocorrelated residuals. Without interval: at a bound.
    units : dict of str to str
        Unit of each parameter.
    nrmse : float
        Root mean square of measured minus fitted force, over the range (largest minus smallest) of the force [1].
    r2 : float
        Share of the variance of the force explained [1].
    rms_residual : float
        [N].
    energy_per_cycle, fitted_energy_per_cycle : float
        Work done on the damper per cycle, measured and by the law [J].
    cycles : float
        Cycles fitted [1].
    samples : int
        Samples fitted [1].
    displacement_centre : float
        Middle of the stroke in the record, compression positive [m]: displacement in the law is counted from there.
    stroke_positive : {"compression", "extension"}
        How the record counts the stroke, as stated or found. The law itself counts compression positive.
    force_positive : {"compression", "tension"}
        How the record counts the force.
    damper : dict
        Table to write under ``strut.damper`` in a rig, SI, bump positive. F(v) laws leave the offset out: it is a
        static force and belongs to the preload.
    friction : dict or None
        Table to write under ``strut.friction`` (N, m/s); None when the law has none.
    findings : tuple of Finding
        Doubts about record and law.
    """

    law: Annotated[str, Shows("law")]
    parameters: Annotated[dict[str, Estimate], Shows("", lambda fit: fit.units)]
    units: dict[str, str]
    nrmse: Annotated[float, Shows("residual, of the force range", "%", 3)]
    r2: Annotated[float, Shows("R²", "1", 6)]
    rms_residual: Annotated[float, Shows("r.m.s. residual", "N")]
    energy_per_cycle: Annotated[float, Shows("energy per cycle", "J")]
    fitted_energy_per_cycle: Annotated[float, Shows("energy per cycle of the law", "J")]
    cycles: Annotated[float, Shows("cycles", "1")]
    samples: Annotated[int, Shows("samples")]
    displacement_centre: float
    stroke_positive: Annotated[StrokePositive, Shows("positive stroke of the record")]
    force_positive: Annotated[ForcePositive, Shows("positive force of the record")]
    damper: dict[str, Any]
    friction: dict[str, float] | None
    findings: tuple[Finding, ...]


@dataclass(frozen=True)
class DamperCurve(Shown):
    """Measured and fitted force side by side, for drawing.

    Attributes
    ----------
    time, displacement, velocity, measured, fitted : array (n,)
        [s], [m] from the middle of the stroke, [m/s], [N], [N].
    """

    time: Array
    displacement: Array
    velocity: Array
    measured: Array
    fitted: Array


def fit_damper(  # noqa: PLR0913 - each is a choice of its own
    displacement: ArrayLike | xr.Dataset | pd.DataFrame,
    velocity: ArrayLike | None = None,
    force: ArrayLike | None = None,
    time: ArrayLike | None = None,
    *,
    law: LawName = "linear",
    degree: int = 3,
    odd: bool = False,
    friction: bool = False,
    velocity_from: VelocityFrom = "recorded",
    stroke_positive: StrokePositive | None = None,
    force_positive: ForcePositive | None = None,
    name: str = "damper",
) -> DamperResult:
    """Fit a damper law to a record of imposed motion and force.

    ``linear``: F = c v + F0. ``bilinear``: c_bump for v > 0, c_rebound for v < 0. ``polynomial``: F = F0 + sum a_i v^i.
    ``tanh-hysteretic``: F = c v + k x + f tanh(slope (v + coupling x)) + F0. ``bouc-wen``: F = c v + k x + f z + F0,
    ``z' = rate (v - sigma |v| |z|^(n-1) z + (sigma - 1) v |z|^n)``, the normalised form, whose parameters are unique.
    Shape parameters are searched from many starts; the factors are solved for exactly at each step.

    Parameters
    ----------
    displacement : array (n,), Dataset or DataFrame
        [m], compression positive unless stated otherwise, any zero; or alone, a recording or a table (``name [unit]``)
        in which one place has a displacement, a force and, where it was recorded, a velocity.
    velocity : array (n,) or None
        [m/s], of the same sign as the displacement; None: the derivative of the displacement.
    force : array (n,)
        [N], positive where it resists compression unless stated otherwise.
    time : array (n,)
        [s], increasing; not needed beside channels of a recording, which carry it.
    law : {"linear", "bilinear", "polynomial", "tanh-hysteretic", "bouc-wen"}
        See above.
    degree : int
        Of the polynomial [1].
    odd : bool
        Polynomial with odd powers only.
    friction : bool
        Add dry friction to an F(v) law.
    velocity_from : {"recorded", "displacement"}
        Which velocity the law sees.
    stroke_positive : {"compression", "extension"} or None
        Which way the displacement counts. None: compression, unless the record contradicts it; a finding says what was
        turned, or what nothing in the record could confirm.
    force_positive : {"compression", "tension"} or None
        Which way the force counts, likewise.
    name : str
        File or channel, used in messages.

    Returns
    -------
    DamperResult
        Parameters in SI with standard errors.

    Raises
    ------
    FitError
        A record that cannot be used; see :func:`jounce.identify.damper.read_motion`.
    DescriptionError
        An unknown law.

    References
    ----------
    Kwok et al. (2006), Sensors and Actuators A 132, 441-451; Ikhouane and Rodellar (2007), Systems with Hysteresis.

    Examples
    --------
    >>> t = np.arange(0.0, 4.0, 0.01)
    >>> x, v = 0.02 * np.sin(6.0 * t), 0.12 * np.cos(6.0 * t)
    >>> result = fit_damper(x, v, np.where(v > 0.0, 300.0, 900.0) * v, t, law="bilinear")
    >>> [round(estimate.value) for estimate in result.parameters.values()]
    [300, 900, 0]
    """
    motion, findings = read_motion(
        *_carried(displacement, velocity, force, time, name),
        velocity_from=velocity_from,
        stroke_positive=stroke_positive,
        force_positive=force_positive,
        name=name,
    )
    chosen = damper_law(law, motion, degree=degree, odd=odd, friction=friction)
    used = _fitted_part(motion) if chosen.remembers else slice(None)
    weights, shapes, free, at_bound = _search(chosen, motion, used)
    names = [*chosen.weights, *chosen.shapes]
    values = np.concatenate([weights, shapes])
    fitted = chosen.columns(motion.displacement, motion.velocity, shapes) @ weights
    residual = (motion.force - fitted)[used]
    estimates = _estimates(chosen, motion, used, values, residual, free)
    parameters = {key: one for (key, _), one in zip(names, estimates, strict=True)}
    plain = {key: one.value for key, one in parameters.items()}
    measured, x = motion.force[used], motion.displacement[used]
    cycles = motion.cycles - (0.5 if chosen.remembers else 0.0)
    closed = closed_part(x)
    turned = _cycles(x[closed], is_closed=closed != slice(None))
    rms = float(np.sqrt(np.mean(residual**2)))
    table = {
        "force": max(plain.get("friction_force", 0.0), 0.0),
        "regularisation_velocity": regularisation_velocity(motion),
    }
    result = DamperResult(
        law=law,
        parameters=parameters,
        units=dict(names),
        nrmse=rms / float(np.ptp(measured)),
        r2=r_squared(measured, residual),
        rms_residual=rms,
        energy_per_cycle=float(np.trapezoid(measured[closed], x[closed])) / turned,
        fitted_energy_per_cycle=float(np.trapezoid(fitted[used][closed], x[closed])) / turned,
        cycles=cycles,
        samples=len(residual),
        displacement_centre=motion.centre,
        stroke_positive=motion.signs.stroke_positive,
        force_positive=motion.signs.force_positive,
        damper=chosen.table(plain),
        friction=table if friction else None,
        findings=(),
    )
    findings += damper_advice(result, motion, at_bound, name)
    findings += _changes(motion.velocity[used] / motion.peak_velocity, fitted[used], residual, result, name)
    findings += _logged(motion, fitted, parameters["offset"].value, name)
    return replace(result, findings=tuple(findings))


def _carried(
    displacement: Any, velocity: Any, force: Any, time: Any, name: str
) -> tuple[ArrayLike, ArrayLike | None, ArrayLike, ArrayLike]:
    """A record with what its data carry: channels of a recording their time, a recording or a table all."""
    if force is None and velocity is None and not hasattr(displacement, "dtype"):
        displacement, velocity, force = damper_channels(as_recording(displacement, where=name), where=name)
    if force is None:
        raise FitError("the force is missing", where=name, allowed="displacement, velocity or None, force, time")
    return displacement, velocity, force, clock_of((displacement, force), where=name) if time is None else time


def damper_curve(
    result: DamperResult,
    displacement: ArrayLike | xr.Dataset | pd.DataFrame,
    velocity: ArrayLike | None = None,
    force: ArrayLike | None = None,
    time: ArrayLike | None = None,
    *,
    velocity_from: VelocityFrom = "recorded",
) -> DamperCurve:
    """Evaluate a fitted law on a record, the one it was fitted to or another one (a hold-out).

    Parameters
    ----------
    result : DamperResult
        The fitted law.
    displacement, velocity, force, time : array (n,), Dataset or DataFrame
        A record as for :func:`fit_damper` [m, m/s, N, s], which counts stroke and force as the fitted one did;
        displacement is counted from the middle of its own stroke.
    velocity_from : {"recorded", "displacement"}
        Which velocity the law sees.

    Returns
    -------
    DamperCurve
        The moving part of the record with the law's force.

    Examples
    --------
    >>> t = np.arange(0.0, 2.0, 1e-3)
    >>> x, v = 0.02 * np.sin(2.0 * np.pi * t), 0.04 * np.pi * np.cos(2.0 * np.pi * t)
    >>> curve = damper_curve(fit_damper(x, v, 1500.0 * v, t, law="linear"), x, v, 1500.0 * v, t)
    >>> bool(np.allclose(curve.fitted, curve.measured))
    True
    """
    motion, _ = read_motion(
        *_carried(displacement, velocity, force, time, "damper"),
        velocity_from=velocity_from,
        stroke_positive=result.stroke_positive,
        force_positive=result.force_positive,
    )
    powers = [int(key[1:]) for key in result.parameters if key[0] == "a" and key[1:].isdigit()]
    law = damper_law(
        result.law,
        motion,
        degree=max(powers, default=1),
        odd=all(power % 2 for power in powers),
        friction=result.friction is not None,
    )
    values = {key: one.value for key, one in result.parameters.items()}
    shapes = np.array([values[key] for key, _ in law.shapes])
    weights = np.array([values[key] for key, _ in law.weights])
    fitted = law.columns(motion.displacement, motion.velocity, shapes) @ weights
    return DamperCurve(motion.time, motion.displacement, motion.velocity, motion.force, fitted)


def _fitted_part(motion: DamperMotion) -> slice:
    """Leave out the first swing, which only brings a law with a memory into its state."""
    turns = zigzag(motion.displacement, 0.1 * motion.stroke)
    return slice(turns[1] if len(turns) > 2 else 0, None)


def _weights(law: DamperLaw, columns: Array, force: Array) -> tuple[Array, NDArray[np.bool_]]:
    """Best factors of the columns, those that cannot be negative cut at zero; and which of them are free."""
    free = np.ones(columns.shape[1], bool)
    scale = np.maximum(np.linalg.norm(columns, axis=0), 1e-300)
    found = np.zeros(columns.shape[1])
    for _ in range(3):
        found = np.zeros(columns.shape[1])
        found[free] = np.linalg.lstsq(columns[:, free] / scale[free], force, rcond=None)[0] / scale[free]
        wrong = [i for i, (key, _) in enumerate(law.weights) if key in law.not_negative and found[i] < 0.0]
        if not wrong:
            break
        free[wrong] = False
        found[wrong] = 0.0
    return found, free


def _coded(law: DamperLaw, shapes: Array) -> Array:
    """Shape parameters as the search sees them: logarithms, but for the coupling, which has a sign."""
    return np.array(
        [
            value / bound if key == "displacement_coupling" else math.log(value)
            for (key, _), value, bound in zip(law.shapes, shapes, law.bounds[1], strict=True)
        ]
    )


def _decoded(law: DamperLaw, coded: Array) -> Array:
    return np.array(
        [
            value * bound if key == "displacement_coupling" else math.exp(value)
            for (key, _), value, bound in zip(law.shapes, coded, law.bounds[1], strict=True)
        ]
    )


def _search(
    law: DamperLaw, motion: DamperMotion, used: slice
) -> tuple[Array, Array, NDArray[np.bool_], tuple[str, ...]]:
    """Weights, shapes, which parameters are free, and the names of those at a bound."""
    from scipy.optimize import least_squares

    size = float(motion.force.std())

    def misfit(coded: Array) -> Array:
        columns = law.columns(motion.displacement, motion.velocity, _decoded(law, coded))[used]
        return np.asarray((columns @ _weights(law, columns, motion.force[used])[0] - motion.force[used]) / size)

    shapes, inside = law.starts[0], np.zeros(0, bool)
    if law.shapes:
        low, high = _coded(law, law.bounds[0]), _coded(law, law.bounds[1])
        starts = [np.clip(_coded(law, start), low + 1e-6, high - 1e-6) for start in law.starts]
        starts.sort(key=lambda start: float((misfit(start) ** 2).sum()))
        found = [
            least_squares(misfit, start, bounds=(low, high), diff_step=1e-4, xtol=1e-8, ftol=1e-9, max_nfev=60)
            for start in starts[:4]
        ]
        best = min(found, key=lambda one: float(one.cost))
        shapes = _decoded(law, best.x)
        inside = (best.x > low + 1e-3) & (best.x < high - 1e-3)
    columns = law.columns(motion.displacement, motion.velocity, shapes)[used]
    weights, free = _weights(law, columns, motion.force[used])
    every = np.concatenate([free, inside])
    names = [key for key, _ in (*law.weights, *law.shapes)]
    return weights, shapes, every, tuple(key for key, is_free in zip(names, every, strict=True) if not is_free)


def _estimates(
    law: DamperLaw, motion: DamperMotion, used: slice, values: Array, residual: Array, free: NDArray[np.bool_]
) -> list[Estimate]:
    weights, shapes = values[: len(law.weights)], values[len(law.weights) :]

    def force(point: Array) -> Array:
        return np.asarray((law.columns(motion.displacement, motion.velocity, point) @ weights)[used])

    jacobian = law.columns(motion.displacement, motion.velocity, shapes)[used]
    if len(shapes):
        # the coupling, which has a sign, may be near zero: its step is then a share of its range
        signed = np.array([key == "displacement_coupling" for key, _ in law.shapes])
        steps = 1e-3 * np.maximum(np.abs(shapes), 1e-2 * np.where(signed, law.bounds[1], 0.0))
        jacobian = np.column_stack([jacobian, central_differences(force, shapes, steps)])
    known = uncertainty(jacobian[:, free], residual).estimates(values[free])
    remaining = iter(known)
    return [next(remaining) if is_free else Estimate(float(v)) for v, is_free in zip(values, free, strict=True)]


# findings -------------------------------------------------------------------------------------------------------------


def hysteresis_share(motion: DamperMotion) -> float:
    """How far the force at one velocity depends on whether the velocity rises or falls.

    R.m.s. difference between both over velocity bins, relative to the range of the force [1]; 0 for any F(v).
    """
    rising = np.gradient(motion.velocity, motion.time) > 0.0
    edges = np.linspace(-0.9, 0.9, 22) * motion.peak_velocity
    place = np.digitize(motion.velocity, edges)
    gaps = []
    for index in range(1, len(edges)):
        up, down = motion.force[(place == index) & rising], motion.force[(place == index) & ~rising]
        if len(up) >= 2 and len(down) >= 2:
            noise = up.var(ddof=1) / len(up) + down.var(ddof=1) / len(down)
            gaps.append(max(float((up.mean() - down.mean()) ** 2 - noise), 0.0))
    return float(np.sqrt(np.mean(gaps))) / float(np.ptp(motion.force)) if gaps else 0.0


def damper_advice(result: DamperResult, motion: DamperMotion, at_bound: tuple[str, ...], name: str) -> list[Finding]:
    """Findings about a fitted law; ``at_bound`` names the parameters that ended at a limit of their range."""
    findings: list[Finding] = []

    def add(severity: Severity, text: str, value: float | None = None) -> None:
        findings.append(Finding(name, severity, text, value))

    parameters = result.parameters
    if result.law in _VELOCITY_LAWS:
        hysteresis = hysteresis_share(motion)
        if hysteresis > 0.04:
            text = (
                f"the force differs by {100.0 * hysteresis:.0f} % of its range between rising and falling velocity: "
                "hysteresis, which no F(v) law can reproduce; try 'tanh-hysteretic' or 'bouc-wen'."
            )
            add("warning", text, hysteresis)
        offset = parameters["offset"]
        if offset.interval and not offset.has(0.0):
            text = (
                f"the force has an offset of {offset.value:.3g} N (gas pressure, spring, load-cell zero), not part "
                "of the damper table: put it into the preload."
            )
            add("note", text, offset.value)
        for key in ("coefficient", "bump_coefficient", "rebound_coefficient"):
            if key in parameters and parameters[key].value < 0.0:
                add("problem", f"{key} is negative: the law would feed energy into the motion.", parameters[key].value)
        if result.friction is None:
            step, speed = _force_step(motion) or (None, 0.0)
            if step is not None and speed > regularisation_velocity(motion):
                text = (
                    f"the force rises steeply up to some {speed:.2g} m/s, by about {step:.3g} N, and slower beyond: a "
                    "degressive valve rather than dry friction; 'tanh-hysteretic' follows it."
                )
                add("warning", text, step)
            elif step is not None:
                text = (
                    f"the force jumps by about +-{step:.3g} N where the velocity changes sign: dry friction; fit with "
                    "friction=True or a hysteretic law."
                )
                add("warning", text, step)
        if "force" in result.damper and np.any(np.diff(result.damper["force"]) < 0.0):
            add("warning", "the fitted curve falls with rising velocity in places; lower the degree.")
    for key in at_bound:
        text = (
            f"{key} ended at the limit of its range ({parameters[key].value:.4g} {result.units[key]}): the "
            "record does not determine it."
        )
        add("warning", text, parameters[key].value)
    for key, one in parameters.items():
        vague = one.standard_error is not None and one.standard_error > 0.5 * abs(one.value)
        if vague and key in ("sigma", "rate", "exponent", "slope"):
            text = (
                f"{key} = {one.value:.3g} +- {one.standard_error:.2g} {result.units[key]} is poorly determined: the "
                "record has too few samples where the force reverses."
            )
            add("note", text, one.standard_error)
    if result.cycles < 3.0:
        add("note", f"only {result.cycles:.1f} cycles: the standard errors rest on few repetitions.", result.cycles)
    if result.r2 < 0.9:
        text = f"the law explains only {100.0 * result.r2:.0f} % of the force; try another one and compare the curves."
        add("warning", text, result.r2)
    return findings


_FADED, _DRIFTED = 0.05, 0.03  # of the force of the law, and of the range of the force, over the record
_FAR, _FEW = 12.0, 0.02  # times the usual residual, share of the samples: a spike, and how many may be spikes


def _changes(speed: Array, fitted: Array, residual: Array, result: DamperResult, name: str) -> list[Finding]:
    """What changed while the record was taken: a damper that warms up, a zero that drifts; and spikes.

    ``speed`` is the velocity over its peak; the force of the law may err as it grows, which is no change in time.
    """
    findings: list[Finding] = []
    usual = float(np.median(np.abs(residual))) / 0.6745
    spikes = np.abs(residual) > _FAR * usual
    theirs = float(np.sum(residual[spikes] ** 2)) / max(float(residual @ residual), 1e-300)
    if usual > 0.0 and 0 < np.count_nonzero(spikes) < _FEW * len(residual) and theirs > 0.5:
        text = (
            f"{np.count_nonzero(spikes)} samples lie more than {_FAR:g} times the usual residual from the law and make "
            f"{100.0 * theirs:.0f} % of its sum of squares: spikes of the logger? Remove them."
        )
        findings.append(Finding(name, "warning", text, float(np.count_nonzero(spikes))))
        speed, fitted, residual = speed[~spikes], fitted[~spikes], residual[~spikes]
    reach = float(np.ptp(fitted))
    if result.cycles < 2.0 or reach <= 0.0:
        return findings
    place, force = np.linspace(-0.5, 0.5, len(residual)), fitted - fitted.mean()
    bent = [force * np.abs(speed), np.maximum(speed, 0.0), np.minimum(speed, 0.0)]
    columns = np.column_stack([place, place * force / reach, np.ones_like(force), force, *bent])
    drift, share = linear_least_squares(columns, residual)[0][:2] * (1.0, 1.0 / reach)
    if abs(share) > _FADED:
        way = "falls" if share < 0.0 else "grows"
        text = (
            f"the damping {way} by {100.0 * abs(share):.0f} % from the first to the last sample (oil that warms up?): "
            "the law is that of the middle of the record, and its interval does not count the change; fit parts of it."
        )
        findings.append(Finding(name, "warning", text, share))
    if abs(drift) > _DRIFTED * reach:
        text = (
            f"the force at rest drifts by {drift:.3g} N from the first to the last sample (load cell, or gas that "
            "warms up): intervals are wide for it and the offset is that of the middle; take the drift off."
        )
        findings.append(Finding(name, "warning", text, drift))
    return findings


_COARSE = 0.25  # of the force on one side
_NEAR = 12.0  # times the frequency of the motion, below which a low pass makes bump and rebound alike


def _logged(motion: DamperMotion, fitted: Array, offset: float, name: str) -> list[Finding]:
    """What the logger did to the force: steps as large as the force itself, a low pass near the motion."""
    findings: list[Finding] = []
    step, force = quantum_of(motion.force), fitted - offset
    side = min(float(force.max()), -float(force.min()))
    if step > _COARSE * side > 0.0:
        text = (
            f"the force is recorded in steps of {step:.3g} N, and one side has {side:.3g} N: rounding is no noise, and "
            "coefficients may be off by more than their intervals; measure with a finer range, or faster."
        )
        findings.append(Finding(name, "warning", text, step))
    time = motion.time
    frequency = motion.cycles / float(time[-1] - time[0])
    rate = 1.0 / float(np.median(np.diff(time)))
    reach = float(np.ptp(motion.force))
    if corner := low_pass_corner(motion.force - fitted, rate, frequency, reach=reach, step=step, near=_NEAR):
        text = (
            f"the noise of the force ends at some {corner:.2g} Hz, near the {frequency:.2g} Hz of the motion: a low "
            "pass of the logger, which blurs the change from bump to rebound; both come out too equal. Measure with "
            "a wider one, or slower."
        )
        findings.append(Finding(name, "warning", text, corner))
    return findings


def _force_step(motion: DamperMotion) -> tuple[float, float] | None:
    """Step of the force at zero velocity [N] that a velocity curve needs to fit well, and how fast it is taken [m/s].

    Dry friction changes sides within the regularisation; a degressive valve takes its time to open.
    """
    v = motion.velocity / motion.peak_velocity
    smooth = np.column_stack([np.ones_like(v), np.maximum(v, 0.0), np.minimum(v, 0.0)])

    def fitted(*more: Array) -> tuple[float, float]:
        columns = np.column_stack([smooth, *more])
        found = np.linalg.lstsq(columns, motion.force, rcond=None)[0]
        return float((motion.force - columns @ found).std()), float(found[-1])

    sharp = regularisation_velocity(motion)
    without, (left, step) = fitted()[0], fitted(np.tanh(motion.velocity / sharp))
    if step <= 0.02 * float(np.ptp(motion.force)) or left >= 0.8 * without:
        return None
    knees = [share * motion.peak_velocity for share in (0.05, 0.1, 0.2, 0.4)]
    soft, height, knee = min((*fitted(np.tanh(motion.velocity / knee)), knee) for knee in knees if knee > 2.0 * sharp)
    return (height, knee) if soft < 0.9 * left else (step, sharp)
