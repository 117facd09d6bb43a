"""Values to sweep over, the order in which a walk visits them, and what stopped it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import DescriptionError
from jounce.core.types import Array
from jounce.core.units import to_si

Values = float | str | Sequence[float] | Array
"""Values to sweep over: numbers in SI, or text such as "-80 mm:80 mm:4 mm" (first, last, step)."""
_MOST = 1_000_000
_WHOLE = 1e-9  # share of a step by which the end of a range may miss it


@dataclass(frozen=True)
class Grid:
    """Pairs of travel and rack travel in the order of the walk, which starts at the one nearest to design.

    Attributes
    ----------
    shape : tuple of int
        Numbers of travel and rack values.
    place : ndarray of int, shape (n,)
        Where in the flattened grid each target of the walk belongs.
    targets : ndarray, shape (n, 2)
        Travel and rack travel (m) of each target.
    before : ndarray of int, shape (n,)
        The target that each one continues from; -1 for the design pose.
    """

    shape: tuple[int, int]
    place: NDArray[np.intp]
    targets: Array
    before: NDArray[np.int64]


def text_range(text: str, unit: str, where: str) -> Array:
    """Read ``"first:last:step"``, or one value, into SI; the last value is part of it when the steps meet it."""
    parts = [part.strip() for part in text.split(":")]
    if len(parts) not in (1, 3) or not all(parts):
        raise DescriptionError("not a range", where=where, found=text, allowed='"first:last:step", or one value')
    numbers = [_quantity(part, unit, where) for part in parts]
    if len(numbers) == 1:
        return np.array(numbers)
    first, last, step = numbers
    if step <= 0.0:
        raise DescriptionError("not a step", where=where, found=text, allowed="a step above 0, the third part")
    if last <= first:
        raise DescriptionError(
            "the range is empty" if last == first else "the range runs backwards",
            where=where,
            found=text,
            allowed="a first value below the last one",
            hint="Exchange them, or give one value.",
        )
    count = (last - first) / step + _WHOLE
    if count > _MOST:
        raise DescriptionError("too many values", where=where, found=f"{count:.3g}", allowed=f"at most {_MOST}")
    return np.round(first + step * np.arange(int(count) + 1), 12)


def _quantity(text: str, unit: str, where: str) -> float:
    try:
        return to_si(float(text), unit, where=where)
    except ValueError:
        return to_si(text, unit, where=where)


def sweep_values(values: Values, name: str, unit: str = "m") -> Array:
    """Check values to sweep over: finite, ascending, at least one; text is read as a range."""
    if isinstance(values, str):
        return text_range(values, unit, name)
    try:
        checked = np.atleast_1d(np.asarray(values, dtype=np.float64))
    except (TypeError, ValueError):
        raise DescriptionError("not numbers", where=name, found=values, allowed="numbers in SI") from None
    if checked.ndim != 1 or not len(checked):
        raise DescriptionError(
            "not a list of values", where=name, found=f"shape {checked.shape}", allowed="(n,), n > 0"
        )
    if not np.all(np.isfinite(checked)):
        raise DescriptionError("not a finite number", where=name, found=checked[~np.isfinite(checked)][0])
    falls = np.flatnonzero(np.diff(checked) <= 0.0)
    if len(falls):
        i = int(falls[0])
        raise DescriptionError(
            "the values do not ascend",
            where=f"{name}[{i + 1}]",
            found=f"{checked[i + 1]:g} after {checked[i]:g}",
            allowed="ascending values, each once",
            hint="Sort them, or exchange the ends of the range.",
        )
    if len(checked) > _MOST:
        raise DescriptionError("too many values", where=name, found=len(checked), allowed=f"at most {_MOST}")
    return checked


def grid(travel: Array, rack: Array) -> Grid:
    """Lay out a walk: along the rack at the travel nearest to design, and from each of those along the travel."""
    if len(travel) * len(rack) > _MOST:
        raise DescriptionError(
            "too many poses", where="travel, rack", found=len(travel) * len(rack), allowed=f"at most {_MOST}"
        )
    rows, parents = _chain(travel), _parents(travel)
    columns, starts = _chain(rack), _parents(rack)
    place = [rows[0] * len(rack) + column for column in columns]
    before = list(starts)
    for c, column in enumerate(columns):
        first = len(place) - 1  # target k > 0 of this column lies at first + k
        place += [row * len(rack) + column for row in rows[1:]]
        before += [c if parent == 0 else first + parent for parent in parents[1:]]
    pairs = np.array(np.meshgrid(travel, rack, indexing="ij")).reshape(2, -1).T
    order = np.array(place, dtype=np.intp)
    return Grid((len(travel), len(rack)), order, np.ascontiguousarray(pairs[order]), np.array(before, dtype=np.int64))


def _chain(values: Array) -> list[int]:
    """Indices from the value nearest to zero upwards, then downwards."""
    middle = int(np.argmin(np.abs(values)))
    return [middle, *range(middle + 1, len(values)), *range(middle - 1, -1, -1)]


def _parents(values: Array) -> list[int]:
    """Place in the chain that each place continues from."""
    middle = int(np.argmin(np.abs(values)))
    up, down = len(values) - 1 - middle, middle
    return [-1, *range(up), *([0, *range(up + 1, up + down)] if down else [])]
