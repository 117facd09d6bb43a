"""Damper laws: each is a weighted sum of known columns, some of which depend on a few shape parameters."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from jounce.core.errors import FitError, unknown
from jounce.core.types import Array
from jounce.identify.damper_motion import DamperMotion

LAWS = ("linear", "bilinear", "polynomial", "tanh-hysteretic", "bouc-wen")


@dataclass(frozen=True)
class DamperLaw:
    """A force law F = sum of weights * columns(displacement, velocity, shapes).

    Attributes
    ----------
    name : str
        One of :data:`LAWS`.
    weights : tuple of (str, str)
        Names and units of the factors of the columns.
    shapes : tuple of (str, str)
        Names and units of the parameters that change the columns; all but ``displacement_coupling`` are searched
        logarithmically.
    columns : callable
        ``(displacement (n,) [m], velocity (n,) [m/s], shapes (s,)) -> (n, w)``.
    starts : array (m, s)
        Shapes to start the search from.
    bounds : (array (s,), array (s,))
        Smallest and largest shapes.
    not_negative : tuple of str
        Weights that cannot be negative.
    remembers : bool
        Whether the force depends on the way before, so that the first swing only sets the state.
    table : callable
        Parameters by name -> damper table as written in a rig file.
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


_NONE = np.zeros((1, 0))
_UNBOUND = (np.zeros(0), np.zeros(0))


def damper_law(
    name: str, motion: DamperMotion, *, degree: int = 3, odd: bool = False, friction: bool = False
) -> DamperLaw:
    """Make a law ready for a motion.

    Parameters
    ----------
    name : {"linear", "bilinear", "polynomial", "tanh-hysteretic", "bouc-wen"}
        Which law.
    motion : DamperMotion
        Sets scales: start values, range of the table, velocity at which dry friction is regularised.
    degree : int
        Degree of the polynomial [1], 1 to 9.
    odd : bool
        Polynomial with odd powers only.
    friction : bool
        Linear, bilinear and polynomial laws: add dry friction F_c tanh(v / v_r).

    Returns
    -------
    DamperLaw
        Parameters in SI.

    Raises
    ------
    DescriptionError
        An unknown law.
    FitError
        A degree out of range, or friction asked of a law that has it already.
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
    return DamperLaw(name, (*names, *extra, ("offset", "N")), (), columns, _NONE, _UNBOUND, flags, False, table)


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
