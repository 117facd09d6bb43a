"""Sign conventions of a test machine for stroke and force, stated or detected; jounce takes compression as positive.

Physics determines part of them. A damper dissipates, so the product of stroke and force sign is known. Its gas pressure
pushes outwards, so a static force in mid-stroke shows the sign of the force. A reversed stroke, alone or together with
the force, swaps bump and rebound, which nothing else in the record shows.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, get_args

import numpy as np

from jounce.core.errors import DescriptionError, unknown
from jounce.core.findings import Finding, finding
from jounce.core.types import Array
from jounce.identify.estimate import Estimate, linear_least_squares
from jounce.recordings.schema import quantity_of
from jounce.recordings.signals import correlation_coefficients

if TYPE_CHECKING:
    import xarray as xr

StrokePositive = Literal["compression", "extension"]
ForcePositive = Literal["compression", "tension"]

_SLOW = 0.2  # of the peak speed: the part of a record that shows the force at rest
_SMALL = 0.005  # share of the range of the force below which a static force is not a gas force
_PULLS = 0.05  # share of the range of the force: neither gas nor hysteresis causes such a pull
_UNLIKE = 0.03  # difference of bump and rebound over their sum, from which swapping them matters
_CLEAR = 0.1  # by which an opposite must be clearer than a likeness
_IDLE = 0.02  # ratio of work to the integral of absolute power below which the part is not a damper


@dataclass(frozen=True)
class Signs:
    """Signs of stroke and force: +1 as in jounce (compression positive), -1 reversed."""

    stroke: int = 1
    force: int = 1

    @property
    def stroke_positive(self) -> StrokePositive:
        """Positive direction of the stroke, in words."""
        return "compression" if self.stroke > 0 else "extension"

    @property
    def force_positive(self) -> ForcePositive:
        """Positive direction of the force, in words."""
        return "compression" if self.force > 0 else "tension"


def sign_of(positive: str | None, kind: Literal["stroke", "force"], *, where: str = "") -> int:
    """Convert "compression" (or None) to +1, "extension" of a stroke or "tension" of a force to -1.

    >>> sign_of("extension", "stroke"), sign_of(None, "force")
    (-1, 1)
    """
    allowed = get_args(StrokePositive if kind == "stroke" else ForcePositive)
    if positive is not None and positive not in allowed:
        raise unknown(str(positive), allowed, what=f"{kind}_positive", where=where)
    return 1 if positive in (None, "compression") else -1


_STROKES = ("deflection", "deflection_velocity", "displacement", "stroke", "travel")
_FORCES = ("force", "load")


def compression_positive(
    recording: xr.Dataset,
    stroke_positive: StrokePositive | None,
    force_positive: ForcePositive | None,
) -> xr.Dataset:
    """Return a recording with deflections, strokes, travels and forces positive in compression, reversed as stated."""
    signs = dict.fromkeys(_STROKES, sign_of(stroke_positive, "stroke"))
    signs |= dict.fromkeys(_FORCES, sign_of(force_positive, "force"))
    turned = {
        name: (variable.dims, -variable.to_numpy(), variable.attrs)
        for name, variable in recording.data_vars.items()
        if signs.get(quantity_of(str(name))) == -1
    }
    return recording.assign(turned) if turned else recording


def check_stroke(channel: str, stroke_positive: StrokePositive | None, *, where: str) -> None:
    """Raise an error for a stroke sign stated for a channel that is not a stroke (a height is positive upwards)."""
    if stroke_positive is not None and quantity_of(channel) not in _STROKES:
        raise DescriptionError(
            "the channel is not a stroke, so its sign cannot be stated",
            where=where,
            found=channel,
            allowed="a deflection, displacement, stroke or travel",
            hint="Damping does not depend on the sign; leave it out.",
        )


def likeness(measured: Array, simulated: Array, most: int) -> float:
    """Return the correlation of two signals with the largest magnitude over shifts up to ``most`` samples [1].

    >>> round(likeness(np.sin(np.arange(99.0)), -np.sin(np.arange(99.0)), 2), 3)
    -1.0
    """
    if len(measured) < 2 * most + 8 or np.ptp(measured) == 0.0 or np.ptp(simulated) == 0.0:
        return 0.0
    alike = float(correlation_coefficients(measured, simulated, most).max())
    opposite = float(correlation_coefficients(-measured, simulated, most).max())
    return alike if alike >= opposite - _CLEAR else -opposite


def turned_channel(name: str, like: float, trials: list[str]) -> Finding:
    """Report a channel whose sign is opposite to the model's."""
    return finding(
        "identify.channel_turned", name, like, trials=", ".join(trials), correlation=like
    )


def closed_part(stroke: Array) -> slice:
    """Return the samples from the first to the last crossing of mid-stroke, as complete cycles if there are any.

    Over these samples gas and springs do no net work, regardless of the start and end of the record.

    >>> closed_part(np.array([0.0, 2.0, 0.0, -2.0, 1.0, 2.0, 1.0]))
    slice(0, 4, None)
    """
    above = stroke > 0.5 * float(stroke.max() + stroke.min())
    passes = np.flatnonzero(above[1:] != above[:-1])
    if len(passes) < 2:
        return slice(None)
    alike = passes[above[passes] == above[passes[0]]]
    return slice(int(passes[0]), int(alike[-1] if len(alike) > 1 else passes[-1]) + 1)


def damper_signs(
    stroke: Array,
    velocity: Array,
    force: Array,
    *,
    stroke_positive: str | None,
    force_positive: str | None,
    name: str,
    findings: list[Finding],
) -> Signs:
    """Find the signs of a damper record from statements and physics; findings name a reversed column.

    ``velocity`` is the derivative of the ``stroke`` as recorded. Stated signs are used if the damper then dissipates.
    By default compression is positive, and a finding of severity "warning" reports if the record contradicts this, or
    if bump and rebound differ and the record cannot confirm it.
    """
    stated = Signs(
        sign_of(stroke_positive, "stroke", where=name),
        sign_of(force_positive, "force", where=name),
    )

    def add(code: str, value: float | None = None, /, **numbers: Any) -> None:
        findings.append(finding(code, name, value, **numbers))

    x, v, f = stated.stroke * stroke, stated.stroke * velocity, stated.force * force
    part = closed_part(x)
    pushed, moved = f[part] - f[part].mean(), v[part]
    work, sizes = float(pushed @ moved), float(np.abs(pushed) @ np.abs(moved))
    if abs(work) < _IDLE * sizes:
        add("identify.force_without_work", work / sizes, share=work / sizes)
        return stated
    rest = static_force(x, v, f)
    gas = _sign(rest, f)
    unlike = _unlike(v, f, rest.value if gas else 0.0) or rest.value < -_PULLS * float(np.ptp(f))
    chosen = _Choice(
        stated, stroke_positive is not None, force_positive is not None, gas, rest.value, unlike
    )
    return (chosen.dissipating if work > 0.0 else chosen.reverse_one)(add)


@dataclass(frozen=True)
class _Choice:
    """Information for the choice of signs; ``gas`` is the sign of the static force as stated, 0 without one."""

    stated: Signs
    stroke_is_stated: bool
    force_is_stated: bool
    gas: int
    rest: float
    unlike: bool  # or the gas pulls

    def dissipating(self, add: Callable[..., None]) -> Signs:
        """Choose signs if stroke and force agree: both are correct, or both are reversed."""
        stated = self.stroke_is_stated or self.force_is_stated
        if not self.unlike or self.gas > 0 or (stated and not self.gas):
            return self.stated
        if self.gas < 0:
            code = "identify.stated_signs_of_gas" if stated else "identify.signs_of_gas"
            add(code, self.rest, rest=self.rest)
        else:
            add("identify.bump_or_rebound")
        return self.stated

    def reverse_one(self, add: Callable[..., None]) -> Signs:
        """Choose signs if stroke and force contradict each other: one is reversed, and the gas force shows which."""
        both = self.stroke_is_stated and self.force_is_stated
        if self.stroke_is_stated != self.force_is_stated:
            column = "force" if self.stroke_is_stated else "stroke"
        else:
            column = "stroke" if self.gas > 0 else "force"
        signs = (
            Signs(-self.stated.stroke, self.stated.force)
            if column == "stroke"
            else Signs(self.stated.stroke, -self.stated.force)
        )
        rest = self.rest * (-1 if column == "force" else 1)
        why: Finding | str = ""
        if both:
            why = finding("identify.though_stated", "")
        elif self.stroke_is_stated or self.force_is_stated:
            why = finding("identify.as_other_stated", "")
        elif self.gas:
            why = finding("identify.as_gas_pushes", "", rest=rest)
        elif self.unlike:
            why = finding("identify.or_the_stroke", "")
        pulls = bool(self.gas) and rest < 0.0
        but = finding("identify.gas_pulls", "", rest=rest) if pulls else ""
        way = signs.stroke_positive if column == "stroke" else signs.force_positive
        code = "identify.signs_contradict_stated" if both or pulls else "identify.signs_contradict"
        key = f"{column}_positive"
        add(code, rest if self.gas else None, column=column, why=why, but=but, key=key, way=way)
        return signs


def static_force(stroke: Array, velocity: Array, force: Array) -> Estimate:
    """Estimate the static force in mid-stroke (N) from slow motion, without damping, friction and spring."""
    peak = float(np.abs(velocity).max())
    for share in (_SLOW, 2.0 * _SLOW, 1.0):
        slow = np.abs(velocity) <= share * peak
        if np.count_nonzero(slow) >= 30:
            break
    x, v = stroke[slow] / float(np.ptp(stroke)), velocity[slow] / peak
    centre = 0.5 * float(stroke.max() + stroke.min()) / float(np.ptp(stroke))
    columns = [
        np.ones_like(v),
        x - centre,
        np.maximum(v, 0.0),
        np.minimum(v, 0.0),
        np.tanh(v / 0.01),
    ]
    coefficients, _, spread = linear_least_squares(np.column_stack(columns), force[slow])
    return spread.estimates(coefficients)[0]


def _sign(rest: Estimate, force: Array) -> int:
    """Return the sign of a static force, 0 if it is not significant."""
    if abs(rest.value) < _SMALL * float(np.ptp(force)) or (
        rest.interval is not None and rest.has(0.0)
    ):
        return 0
    return 1 if rest.value > 0.0 else -1


def _unlike(velocity: Array, force: Array, rest: float) -> bool:
    """Whether bump and rebound differ enough for a swap to matter."""
    bump, rebound = velocity > 0.0, velocity < 0.0
    if not bump.any() or not rebound.any():
        return False
    sizes = [
        abs(float((force[part] - rest) @ velocity[part])) / float(velocity[part] @ velocity[part])
        for part in (bump, rebound)
    ]
    return abs(sizes[0] - sizes[1]) > _UNLIKE * sum(sizes)
