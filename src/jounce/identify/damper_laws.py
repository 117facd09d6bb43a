"""Damper laws for fitting: linear weights of columns, and the shape parameters of the columns."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import FitError, unknown
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.identify.damper_record import DamperMotion
from jounce.identify.estimate import Estimate, central_differences, uncertainty
from jounce.identify.hysteresis_path import bouc_wen_path
from jounce.parts.dampers import (
    BilinearDamper,
    BlowOffDamper,
    BoucWenDamper,
    DamperLaw,
    LinearDamper,
    SampledPoint,
    TanhDamper,
    as_damper,
    damper_kind,
)
from jounce.parts.rig import unit_of_field

LawName = Literal["linear", "bilinear", "blow-off", "polynomial", "tanh-hysteretic", "bouc-wen"]
LAWS: tuple[LawName, ...] = get_args(LawName)
_DESCRIBED: dict[str, type[DamperLaw]] = {
    "linear": LinearDamper,
    "bilinear": BilinearDamper,
    "blow-off": BlowOffDamper,
    "tanh-hysteretic": TanhDamper,
    "bouc-wen": BoucWenDamper,
}


@dataclass(frozen=True)
class AlongPath(SampledPoint):
    """Operating points in the order in which a damper passes through them.

    ``start`` is the state at the first point. By default it is the state that the stroke before the first reversal
    leaves.
    """

    start: float | None = None

    def state(self, name: str, rate: Callable[[Any], Any]) -> Array:  # noqa: ARG002 - of its closed steps
        """Follow the normalised Bouc-Wen state along the path."""
        x, start = np.ascontiguousarray(self.deflection), self.start
        if start is None:
            # Noise at a turn moves the first samples, but not by a twentieth of the stroke.
            start = -float(np.sign(x[np.argmax(np.abs(x - x[0]) > 0.05 * np.ptp(x))] - x[0]))
        shapes = {shape: float(self.number(shape)) for shape in BoucWenDamper.shapes}
        return bouc_wen_path(x, start=start, **shapes)


def harmonic_energy(
    damper: DamperLaw | Mapping[str, Any], amplitude: float, frequency: float
) -> float:
    """Compute the work that a damper dissipates per cycle of steady-state harmonic motion.

    Parameters
    ----------
    damper : DamperLaw or mapping
        A law (``rig.strut.damper``) or its table, such as ``strut.damper`` of a rig file or ``DamperResult.damper``.
    amplitude : float
        Amplitude of the stroke about the design length [m].
    frequency : float
        Frequency of the motion [Hz].

    Returns
    -------
    float
        Energy [J], not negative for a dissipative law.

    Raises
    ------
    DescriptionError
        A table that is not a damper law.

    Examples
    --------
    >>> round(harmonic_energy({"coefficient": 1000.0}, 0.02, 1.0), 4), round(1000.0 * np.pi * 2 * np.pi * 0.02**2, 4)
    (7.8957, 7.8957)
    """
    law = as_damper(damper)
    phase = np.linspace(
        0.0, 4.0 * np.pi, 2 * _CYCLE + 1
    )  # the first cycle initialises the state of a law with memory
    x, v = amplitude * np.sin(phase), 2.0 * np.pi * frequency * amplitude * np.cos(phase)
    power = (law.evaluate(AlongPath(partial(getattr, law), v, x, start=0.0)) * v)[_CYCLE:]
    return float(np.trapezoid(power, phase[_CYCLE:])) / (2.0 * np.pi * frequency)


_CYCLE = 2000  # samples of a cycle


@dataclass(frozen=True)
class FittedLaw:
    """A force law F = sum of weights * columns(displacement, velocity, shapes).

    ``weights`` and ``shapes`` map names to units: of the factors of the columns, and of the parameters that the columns
    depend on. The search for the shapes has the ``starts`` (one row each) and ``bounds``; positive shapes are searched
    on a logarithmic scale. Weights in ``not_negative`` cannot be negative. The force of a ``hysteretic`` law depends on
    more than the velocity. That of a law that ``remembers`` depends on the path, so the first swing only initialises
    its state. ``table`` converts parameters by name to the damper table of a rig file.
    """

    name: str
    weights: tuple[tuple[str, str], ...]
    columns: Callable[[Array, Array, Array], Array]
    table: Callable[[Mapping[str, float]], dict[str, Any]]
    shapes: tuple[tuple[str, str], ...] = ()
    starts: Array = field(default_factory=lambda: np.zeros((1, 0)))
    bounds: tuple[Array, Array] = (np.zeros(0), np.zeros(0))
    not_negative: tuple[str, ...] = ()
    hysteretic: bool = False
    remembers: bool = False

    @property
    def may_be_negative(self) -> NDArray[np.bool_]:
        """Mark the shapes that may be negative; they are searched on a linear scale."""
        return self.bounds[0] < 0.0


def damper_law(
    name: str, motion: DamperMotion, *, degree: int = 3, odd: bool = False, friction: bool = False
) -> FittedLaw:
    """Make a law scaled to a motion, which sets start values, table range and friction regularisation.

    ``friction`` adds dry friction F_c tanh(v / v_r) to laws without hysteresis.

    Raises
    ------
    DescriptionError
        An unknown law.
    FitError
        A degree out of range, or friction for a law that already contains it.
    """
    if name not in LAWS:
        raise unknown(str(name), LAWS, what="damper law")
    law = (
        _polynomial(motion, degree, odd)
        if name == "polynomial"
        else _law_of_rig_files(name, motion)
    )
    if not law.hysteretic:
        return _with_offset(law, motion, friction)
    if friction:
        raise FitError(
            Phrase("the law {name!r} already contains dry friction", name=name),
            allowed="friction only with F(v) laws",
        )
    return law


def regularisation_velocity(motion: DamperMotion) -> float:
    """Return the regularisation velocity of friction [m/s]: 1 % of the peak, or two steps of the record if larger."""
    return max(0.01 * motion.peak_velocity, 2.0 * motion.velocity_resolution)


def _law_of_rig_files(name: str, motion: DamperMotion) -> FittedLaw:
    """Make one of the laws that rig files support."""
    kind = _DESCRIBED[name]

    def columns(x: Array, v: Array, shapes: Array) -> Array:
        numbers = dict(zip(kind.shapes, shapes, strict=True))
        matrix = np.empty((len(v), len(kind.weights)))
        for i, column in enumerate(kind.basis(AlongPath(numbers.__getitem__, v, x))):
            matrix[:, i] = column
        return matrix

    def table(values: Mapping[str, float]) -> dict[str, Any]:
        numbers = {key: values[key] for key in kind.model_fields if key != "kind"}
        word = kind.model_fields["kind"].default
        return numbers if damper_kind(numbers) == word else {"kind": word, **numbers}

    units = {key: unit_of_field(value).si for key, value in kind.model_fields.items()}
    starts, least, most = kind.search(
        motion.stroke, motion.peak_velocity, motion.velocity_resolution
    )
    return FittedLaw(
        name,
        tuple((key, units[key]) for key in kind.weights),
        columns,
        table,
        tuple((key, units[key]) for key in kind.shapes),
        starts,
        (least, most),
        kind.not_negative,
        kind.hysteretic,
        kind.remembers,
    )


def _polynomial(motion: DamperMotion, degree: int, odd: bool) -> FittedLaw:
    """Make a polynomial in the velocity, which a rig file stores as a table over the recorded velocity range."""
    if not 1 <= degree <= 9:
        raise FitError("invalid degree of the polynomial", found=degree, allowed="1 to 9")
    powers = [p for p in range(1, degree + 1) if p % 2 or not odd]

    def table(values: Mapping[str, float]) -> dict[str, Any]:
        speed = np.linspace(float(motion.velocity.min()), float(motion.velocity.max()), 41)
        speed = np.unique(np.append(speed, 0.0))
        force = sum(values[f"a{p}"] * speed**p for p in powers)
        return {"velocity": speed.tolist(), "force": np.asarray(force).tolist()}

    return FittedLaw(
        "polynomial",
        tuple((f"a{p}", f"N*(s/m)^{p}") for p in powers),
        lambda _x, v, _shapes: np.column_stack([v**p for p in powers]),
        table,
    )


def _with_offset(law: FittedLaw, motion: DamperMotion, friction: bool) -> FittedLaw:
    """Extend a law by a static force and, optionally, dry friction."""
    slow = regularisation_velocity(motion)

    def columns(x: Array, v: Array, shapes: Array) -> Array:
        sliding = [np.tanh(v / slow)] if friction else []
        return np.column_stack([law.columns(x, v, shapes), *sliding, np.ones_like(v)])

    extra = (("friction_force", "N"),) if friction else ()
    not_negative = (*law.not_negative, *(key for key, _ in extra))
    weights = (*law.weights, *extra, ("offset", "N"))
    return replace(law, weights=weights, columns=columns, not_negative=not_negative)


def _weights(law: FittedLaw, columns: Array, force: Array) -> tuple[Array, NDArray[np.bool_]]:
    """Return the best factors of the columns, with negative ones clipped at zero, and a mask of free ones."""
    free = np.ones(columns.shape[1], bool)
    scale = np.maximum(np.linalg.norm(columns, axis=0), 1e-300)
    factors = np.zeros(columns.shape[1])
    for _ in range(3):
        factors = np.zeros(columns.shape[1])
        factors[free] = (
            np.linalg.lstsq(columns[:, free] / scale[free], force, rcond=None)[0] / scale[free]
        )
        wrong = [
            i
            for i, (key, _) in enumerate(law.weights)
            if key in law.not_negative and factors[i] < 0.0
        ]
        if not wrong:
            break
        free[wrong] = False
        factors[wrong] = 0.0
    return factors, free


def _encode(law: FittedLaw, shapes: Array) -> Array:
    """Encode shape parameters for the search: logarithms, except for signed parameters."""
    return np.array(
        [
            value / bound if is_signed else math.log(value)
            for is_signed, value, bound in zip(
                law.may_be_negative, shapes, law.bounds[1], strict=True
            )
        ]
    )


def _decode(law: FittedLaw, coded: Array) -> Array:
    return np.array(
        [
            value * bound if is_signed else math.exp(value)
            for is_signed, value, bound in zip(
                law.may_be_negative, coded, law.bounds[1], strict=True
            )
        ]
    )


def search(
    law: FittedLaw, motion: DamperMotion, used: slice
) -> tuple[Array, Array, NDArray[np.bool_], tuple[str, ...]]:
    """Return weights, shapes, the mask of free parameters, and the names of parameters at a bound."""
    from scipy.optimize import least_squares

    size = float(motion.force.std())

    def misfit(coded: Array) -> Array:
        columns = law.columns(motion.displacement, motion.velocity, _decode(law, coded))[used]
        return np.asarray(
            (columns @ _weights(law, columns, motion.force[used])[0] - motion.force[used]) / size
        )

    shapes, inside = law.starts[0], np.zeros(0, bool)
    if law.shapes:
        low, high = _encode(law, law.bounds[0]), _encode(law, law.bounds[1])
        starts = [np.clip(_encode(law, start), low + 1e-6, high - 1e-6) for start in law.starts]
        starts.sort(key=lambda start: float((misfit(start) ** 2).sum()))
        optima = [
            least_squares(
                misfit, start, bounds=(low, high), diff_step=1e-4, xtol=1e-8, ftol=1e-9, max_nfev=60
            )
            for start in starts[:4]
        ]
        best = min(optima, key=lambda optimum: float(optimum.cost))
        shapes = _decode(law, best.x)
        inside = (best.x > low + 1e-3) & (best.x < high - 1e-3)
    columns = law.columns(motion.displacement, motion.velocity, shapes)[used]
    weights, free = _weights(law, columns, motion.force[used])
    every = np.concatenate([free, inside])
    names = [key for key, _ in (*law.weights, *law.shapes)]
    return (
        weights,
        shapes,
        every,
        tuple(key for key, is_free in zip(names, every, strict=True) if not is_free),
    )


def estimates(
    law: FittedLaw,
    motion: DamperMotion,
    used: slice,
    values: Array,
    residual: Array,
    free: NDArray[np.bool_],
) -> list[Estimate]:
    """Return weights and shapes with their uncertainty, which parameters at a bound do not have."""
    weights, shapes = values[: len(law.weights)], values[len(law.weights) :]

    def force(point: Array) -> Array:
        return np.asarray(
            (law.columns(motion.displacement, motion.velocity, point) @ weights)[used]
        )

    jacobian = law.columns(motion.displacement, motion.velocity, shapes)[used]
    if len(shapes):
        # signed parameters may be near zero: their step is a share of their range
        steps = 1e-3 * np.maximum(
            np.abs(shapes), 1e-2 * np.where(law.may_be_negative, law.bounds[1], 0.0)
        )
        jacobian = np.column_stack([jacobian, central_differences(force, shapes, steps)])
    known = uncertainty(jacobian[:, free], residual).estimates(values[free])
    remaining = iter(known)
    return [
        next(remaining) if is_free else Estimate(float(v))
        for v, is_free in zip(values, free, strict=True)
    ]
