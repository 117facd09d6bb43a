"""Force over velocity at any clicks of the adjusters of a damper, between the settings that were measured."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import DescriptionError
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.identify.estimate import student_factor

if TYPE_CHECKING:
    from jounce.dampers.curves import DamperSetting

Indices = NDArray[np.intp]
LEVEL = student_factor(math.inf)
"""Half width of a 95 % interval in standard errors."""
_UNIFORM = math.sqrt(3.0)  # half width of a uniform distribution in standard deviations
_WHOLE = 1e-9  # clicks that differ by less are the same


def is_clicks(name: str) -> bool:
    """Whether a setting is the position of an adjuster: ``clicks``, ``bump_clicks``, ...

    >>> is_clicks("low_speed_bump_clicks"), is_clicks("temperature")
    (True, False)
    """
    return name == "clicks" or name.endswith("_clicks")


def adjusters_of(settings: Sequence[DamperSetting]) -> tuple[str, ...]:
    """Return the adjusters that were moved; none if a setting does not state them, or two state the same clicks."""
    names = [name for name in settings[0].settings if is_clicks(name)]
    if any(set(names) != set(filter(is_clicks, item.settings)) for item in settings):
        return ()
    moved = tuple(name for name in names if len({item.settings[name] for item in settings}) > 1)
    places = {tuple(item.settings[name] for name in moved) for item in settings}
    return moved if len(places) == len(settings) else ()


@dataclass(frozen=True)
class Adjusters:
    """Measured settings of a damper as points over its adjusters, with forces and standard errors over velocity.

    Between measured clicks forces are linear. With several adjusters, and not every combination measured, the effects
    of the adjusters on a setting from which each was moved alone are added.
    """

    names: tuple[str, ...]
    places: Array
    velocity: Array
    force: Array
    error: Array

    @cached_property
    def measured(self) -> tuple[Array, ...]:
        """Measured clicks of each adjuster, ascending."""
        return tuple(np.unique(column) for column in self.places.T)

    @property
    def is_whole_grid(self) -> bool:
        """Whether every combination of measured clicks was measured."""
        return len(self.places) == math.prod(len(values) for values in self.measured)

    @cached_property
    def base(self) -> int:
        """The setting from which most others differ in one adjuster only."""
        away = np.abs(self.places[:, np.newaxis] - self.places).astype(bool).sum(axis=2)
        return int(np.argmax((away == 1).sum(axis=0)))

    @cached_property
    def axes(self) -> tuple[Indices, ...]:
        """Settings that move one adjuster from the base alone, for each adjuster, by its clicks.

        Raises
        ------
        DescriptionError
            If an adjuster was never moved alone.
        """
        away = np.abs(self.places - self.places[self.base]) > _WHOLE
        axes = []
        for k, name in enumerate(self.names):
            others = np.delete(away, k, axis=1).any(axis=1)
            alone = np.flatnonzero(~others)
            if len(alone) < len(self.measured[k]) and len(alone) < 2:
                raise DescriptionError(
                    Phrase("no records move {name} alone", name=words_of(name)),
                    where=name,
                    hint="Measure each adjuster from one setting of the others, or every combination.",
                )
            axes.append(alone[np.argsort(self.places[alone, k])])
        return tuple(axes)

    @cached_property
    def known(self) -> tuple[Array, ...]:
        """Clicks of each adjuster between which forces are interpolated, ascending."""
        if self.is_whole_grid:
            return self.measured
        return tuple(self.places[axis, k] for k, axis in enumerate(self.axes))

    @cached_property
    def reach(self) -> tuple[tuple[float, float], ...]:
        """Lowest and highest clicks of each adjuster between which forces are known."""
        return tuple((float(values[0]), float(values[-1])) for values in self.known)

    def weights(self, places: Array) -> Array:
        """Return the share of each measured setting in the force at clicks (places, adjusters): (places, settings)."""
        if self.is_whole_grid:
            return self._of_grid(places)
        weights = np.zeros((len(places), len(self.places)))
        weights[:, self.base] = 1.0 - len(self.names)
        for k, axis in enumerate(self.axes):
            weights[:, axis] += _between(self.places[axis, k], places[:, k])
        same = np.abs(places[:, np.newaxis] - self.places).max(axis=2) < _WHOLE
        known = same.any(axis=1)
        weights[known] = same[known]
        return weights

    def _of_grid(self, places: Array) -> Array:
        weights = np.ones((len(places), len(self.places)))
        for k, values in enumerate(self.measured):
            share = _between(values, places[:, k])
            weights *= share[:, np.searchsorted(values, self.places[:, k])]
        return weights

    def at(self, places: Array) -> tuple[Array, Array]:
        """Return forces (N) and their standard errors at clicks (places, adjusters); NaN where nothing tells the error.

        The error adds those of the measured settings, that of interpolation between clicks, and, where effects of
        several adjusters are added, by how much they would differ if they multiplied.
        """
        weights = self.weights(places)
        variance = weights**2 @ self.error**2
        for k in range(len(self.names)):
            share = _between(self.known[k], places[:, k]).max(axis=1)[:, np.newaxis]
            with np.errstate(invalid="ignore"):
                bow = 4.0 * share * (1.0 - share) * self._bow(k)
            variance = variance + np.where(share > 1.0 - _WHOLE, 0.0, bow**2)
        if not self.is_whole_grid:
            measured = np.max(weights, axis=1, keepdims=True) > 1.0 - _WHOLE
            variance = variance + np.where(measured, 0.0, self._together(places) ** 2)
        return weights @ self.force, np.sqrt(variance)

    def _bow(self, k: int) -> Array:
        """Return the usual error (N) of linear interpolation half-way between neighbours, at each velocity.

        Neighbours at twice the distance err four times as much if the force bends evenly.
        """
        errors = []
        for line in self._lines(k):
            known, force = self.places[line, k], self.force[line]
            for i in range(1, len(line) - 1):
                share = (known[i] - known[i - 1]) / (known[i + 1] - known[i - 1])
                errors.append(force[i] - (1.0 - share) * force[i - 1] - share * force[i + 1])
        if not errors:
            return np.full(len(self.velocity), math.nan)
        bow: Array = np.sqrt(np.mean(np.square(errors), axis=0)) / 4.0
        return bow

    def _lines(self, k: int) -> list[Indices]:
        """Return the settings along one adjuster, by its clicks: one line for each place of the others."""
        if not self.is_whole_grid:
            return [self.axes[k]]
        others = np.delete(self.places, k, axis=1)
        lines = []
        for place in np.unique(others, axis=0):
            line = np.flatnonzero((others == place).all(axis=1))
            lines.append(line[np.argsort(self.places[line, k])])
        return lines

    def _together(self, places: Array) -> Array:
        """Return by how much the effects of two adjusters would differ if they multiplied, as a standard error (N).

        Settings that move several adjusters from the base, if there are some, tell at least how wrong a sum is.
        """
        base = self.force[self.base]
        size = np.where(np.abs(base) > 0.0, np.abs(base), 1.0)
        moves = [
            _between(self.places[axis, k], places[:, k]) @ self.force[axis] - base
            for k, axis in enumerate(self.axes)
        ]
        error = np.zeros((len(places), len(self.velocity)))
        for effect, other in combinations(moves, 2):
            error += (effect * other / size / _UNIFORM) ** 2
        moved = (np.abs(places - self.places[self.base]) > _WHOLE).sum(axis=1) > 1
        error = np.sqrt(error)
        off = self._off_axes()
        if len(off):
            sums = (
                sum(
                    _between(self.places[axis, k], self.places[off, k]) @ self.force[axis]
                    for k, axis in enumerate(self.axes)
                )
                - (len(self.names) - 1) * base
            )
            error = np.maximum(error, np.sqrt(np.mean((self.force[off] - sums) ** 2, axis=0)))
        return np.where(moved[:, np.newaxis], error, 0.0)

    def _off_axes(self) -> Indices:
        """Return the settings inside the reach that move several adjusters from the base."""
        low, high = np.array(self.reach).T
        inside = ((self.places >= low) & (self.places <= high)).all(axis=1)
        on_axes = np.isin(np.arange(len(self.places)), np.concatenate(self.axes))
        return np.flatnonzero(inside & ~on_axes)


def adjusters_over(settings: Sequence[DamperSetting], velocity: Array) -> Adjusters:
    """Put the forces of settings over velocities (m/s) and the adjusters that were moved.

    Raises
    ------
    DescriptionError
        If the settings state no clicks, or several the same.
    """
    names = adjusters_of(settings)
    if not names:
        raise DescriptionError(
            "the records state no clicks", where="clicks",
            hint="State the settings of each file in a table: file, clicks.",
        )  # fmt: skip
    places = np.array([[item.settings[name] for name in names] for item in settings])
    force = np.stack([np.interp(velocity, item.velocity, item.force) for item in settings])
    half = np.stack(
        [np.interp(velocity, item.velocity, 0.5 * (item.high - item.low)) for item in settings]
    )
    return Adjusters(names, places, velocity, force, half / LEVEL)


def place_of(adjusters: Adjusters, clicks: float | Mapping[str, float]) -> Array:
    """Return clicks as a row of places; refuse what lies outside the measured ones.

    Raises
    ------
    DescriptionError
        For clicks beyond the measured ones, unknown adjusters and those that are missing.
    """
    given = dict(clicks) if isinstance(clicks, Mapping) else {adjusters.names[0]: clicks}
    if set(given) != set(adjusters.names):
        raise DescriptionError(
            "clicks of each adjuster are required",
            where="clicks", found=", ".join(given), allowed=", ".join(adjusters.names),
        )  # fmt: skip
    for name, (low, high) in zip(adjusters.names, adjusters.reach, strict=True):
        if not low <= given[name] <= high:
            raise DescriptionError(
                "not among the clicks that were measured", where=name, found=f"{given[name]:g}",
                allowed=Phrase("{low:g} to {high:g}", low=low, high=high),
            )  # fmt: skip
    return np.array([[float(given[name]) for name in adjusters.names]])


def words_of(name: str) -> str:
    """Write the name of an adjuster.

    >>> words_of("low_speed_bump_clicks"), words_of("clicks")
    ('low-speed bump clicks', 'clicks')
    """
    return (
        name.replace("low_speed", "low-speed").replace("high_speed", "high-speed").replace("_", " ")
    )


def _between(known: Array, places: Array) -> Array:
    """Return the shares of two neighbours in each place: (places, known)."""
    upper = np.clip(np.searchsorted(known, places), 1, max(len(known) - 1, 1))
    shares = np.zeros((len(places), len(known)))
    if len(known) == 1:
        return shares + 1.0
    share = (places - known[upper - 1]) / (known[upper] - known[upper - 1])
    row = np.arange(len(places))
    shares[row, upper - 1] = 1.0 - share
    shares[row, upper] += share
    return shares
