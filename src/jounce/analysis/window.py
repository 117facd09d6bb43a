"""Statistics and distribution of the samples between two instants, for channels of any length."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np
from numpy.typing import ArrayLike, NDArray

from jounce.core.errors import RecordingError
from jounce.core.phrases import Phrase
from jounce.core.results import Shows
from jounce.core.samples import as_samples
from jounce.core.serialise import Plain
from jounce.core.types import Array

_CHUNK = 1 << 18  # samples that are summed at a time, in double precision
_MOST_BINS = 200


@dataclass(frozen=True)
class WindowStatistics(Plain):
    """Level and range of the samples in a window, in the unit of the channel.

    Attributes
    ----------
    samples, missing : int
        Number of samples with a value, and without one (gaps), 1.
    minimum, maximum : float
        Extremes.
    mean, rms : float
        Mean and root mean square of the samples; each sample counts once, whatever the steps of time.
    standard_deviation : float
        Root mean square deviation from the mean.
    """

    samples: Annotated[int, Shows("samples")]
    missing: Annotated[int, Shows("missing samples")]
    minimum: float
    maximum: float
    mean: float
    rms: float
    standard_deviation: float


@dataclass(frozen=True)
class Histogram(Plain):
    """Distribution of the samples in a window.

    Attributes
    ----------
    edges : ndarray, shape (n + 1,)
        Edges of the bins, ascending, in the unit of the channel. A bin includes its lower edge, the last
        both.
    counts : ndarray of int, shape (n,)
        Number of samples in each bin (1).
    """

    edges: Array
    counts: NDArray[np.int64]

    @property
    def shares(self) -> Array:
        """Share (1) of the samples in each bin: the share of time at a constant rate."""
        return np.asarray(self.counts / max(1, int(self.counts.sum())), dtype=float)


def window_statistics(values: ArrayLike, *, where: str = "window") -> WindowStatistics:
    """Compute the statistics of samples, all of which are read; gaps (NaN) are counted and left out.

    `describe_channels` gives the same of every channel of a recording, with confidence intervals.

    Parameters
    ----------
    values : array_like, shape (n,)
        Samples in any one unit (SI in recordings of jounce); a memory-mapped array is read in pieces.
    where : str
        Location named in errors.

    Returns
    -------
    WindowStatistics
        In the unit of ``values``.

    Raises
    ------
    RecordingError
        If there is no sample with a value.

    Examples
    --------
    >>> found = window_statistics([3.0, -1.0, float("nan"), 4.0])
    >>> found.samples, found.missing, found.minimum, found.maximum, found.mean
    (3, 1, -1.0, 4.0, 2.0)
    """
    given = values if isinstance(values, np.ndarray) else as_samples(values, where=where)
    pieces = [given[start : start + _CHUNK] for start in range(0, given.size, _CHUNK)]
    count, total, low, high = 0, 0.0, np.inf, -np.inf
    for piece in pieces:
        finite = _finite(piece)
        if finite.size:
            count, total = count + finite.size, total + float(finite.sum())
            low, high = min(low, float(finite.min())), max(high, float(finite.max()))
    if not count:
        raise RecordingError(
            "the window contains no sample", where=where, hint="Move the cursors apart."
        )
    mean = total / count
    variance = sum(float(np.square(_finite(piece) - mean).sum()) for piece in pieces) / count
    mean = min(max(mean, low), high)  # rounding
    return WindowStatistics(
        count,
        given.size - count,
        low,
        high,
        mean,
        float(np.hypot(mean, np.sqrt(variance))),
        float(np.sqrt(variance)),
    )


def histogram(
    values: ArrayLike,
    bins: int = 40,
    *,
    limits: tuple[float, float] | None = None,
    where: str = "histogram",
) -> Histogram:
    """Count samples in bins of equal width; gaps (NaN), and samples outside the limits, are left out.

    Parameters
    ----------
    values : array_like, shape (n,)
        Samples in any one unit (SI in recordings of jounce).
    bins : int
        Number of bins, 1 to 200.
    limits : (float, float), optional
        Outer edges, in the unit of ``values``; by default the minimum and the maximum.
    where : str
        Location named in errors.

    Returns
    -------
    Histogram
        Edges in the unit of ``values``, and counts. Samples of a constant channel are in the middle bin.

    Raises
    ------
    RecordingError
        If there is no sample with a value, or the number of bins is out of range.

    Examples
    --------
    >>> histogram([0.0, 0.1, 0.9, 1.0, 1.0], bins=2).counts.tolist()
    [2, 3]
    """
    if not 1 <= bins <= _MOST_BINS:
        raise RecordingError(
            "not a number of bins",
            where=where,
            found=bins,
            allowed=Phrase("1 to {most_bins}", most_bins=_MOST_BINS),
        )
    given = values if isinstance(values, np.ndarray) else as_samples(values, where=where)
    found = window_statistics(given, where=where)
    low, high = (found.minimum, found.maximum) if limits is None else limits
    if high - low <= 1e-12 * max(abs(low), abs(high)):
        half = 0.5 * (abs(low) or 1.0)
        low, high = low - half, high + half
    counts = np.zeros(bins, np.int64)
    for start in range(0, given.size, _CHUNK):
        piece = _finite(given[start : start + _CHUNK])
        counts += np.histogram(piece, bins, (low, high))[0]
    return Histogram(np.linspace(low, high, bins + 1), counts)


def _finite(piece: NDArray[np.generic]) -> Array:
    values = np.asarray(piece, dtype=float)
    finite = np.isfinite(values)
    return values if finite.all() else values[finite]
