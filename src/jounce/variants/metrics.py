"""Metrics of a run, named by words: ``rms sprung.az``, ``max tyre.force``, ``Wk sprung.az``.

All of them are sums over samples, except the weightings of ISO 2631-1, which need the time history of the channel.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.errors import DescriptionError, nearest, unknown
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.recordings.schema import channels_of
from jounce.ride.weighting import WEIGHTINGS, check_duration, weight

if TYPE_CHECKING:
    from jounce.variants.side_by_side import Sums

WORDS = {
    "rms": "root mean square about the value at rest",
    "mean": "mean",
    "min": "least value",
    "max": "greatest value",
    "range": "greatest less least value",
}
"""First words of metrics, in addition to the names of weightings."""


@dataclass(frozen=True)
class RunMetric:
    """A metric of a run, computed from a channel.

    Attributes
    ----------
    text : str
        Text of the metric, with the full name of the channel.
    word : str
        One of ``WORDS``, or a weighting.
    channel : str
        Name of the channel.
    unit : str
        SI unit.
    """

    text: str
    word: str
    channel: str
    unit: str

    @property
    def long_name(self) -> str:
        """Label."""
        what = (
            WORDS.get(self.word)
            or f"root mean square, weighted by {self.word}, about the value at rest"
        )
        return f"{self.channel}: {what}"

    @property
    def needs_course(self) -> bool:
        """Whether it needs all samples, not only sums over them."""
        return self.word not in WORDS


def read_metrics(texts: Sequence[str] | str, units: Mapping[str, str]) -> list[RunMetric]:
    """Read metrics; ``units`` has the SI unit of every channel. A metric of all corners becomes one per corner."""
    metrics: list[RunMetric] = []
    for text in [texts] if isinstance(texts, str) else texts:
        words = str(text).split()
        if len(words) != 2:
            raise DescriptionError(
                "invalid metric", where="metrics", found=text, allowed="e.g. 'rms sprung.az'"
            )
        if words[0] not in WORDS and words[0] not in WEIGHTINGS:
            known = (*WORDS, *WEIGHTINGS)
            raise DescriptionError(
                Phrase("no such metric of a channel: {words!r}", words=words[0]),
                where="metrics",
                found=text,
                allowed=", ".join(known),
                hint=nearest(words[0], known),
            )
        channels = channels_of(words[1], list(units))
        if not channels:
            raise _unknown_channel(words[1], units)
        metrics += [
            RunMetric(f"{words[0]} {name}", words[0], name, units[name]) for name in channels
        ]
    return list({metric.text: metric for metric in metrics}.values())


def check_durations(metrics: Iterable[RunMetric], durations: Iterable[float]) -> None:
    """Reject weightings if the runs (s) are too short for them."""
    shortest = min(map(float, durations))
    for metric in metrics:
        if metric.needs_course:
            check_duration(metric.word, shortest, where=metric.text)


def _unknown_channel(name: str, units: Mapping[str, str]) -> DescriptionError:
    from jounce.kinematics.catalogue import CATALOGUE

    error = unknown(name, units, what="channel", where="metrics")
    if name not in {row.name for row in CATALOGUE}:
        return error
    hint = Phrase(
        "{name} is a kinematic quantity, not a channel of a run: use jn.sweep_variants.",
        name=name,
    )
    return DescriptionError(error.what, where=error.where, allowed=error.allowed, hint=hint)


def of_sums(word: str, sums: Sums, channel: int) -> Array:
    """Return a metric of every variant from sums of a channel about its value at rest."""
    if word == "rms":
        return np.asarray(np.sqrt(sums.square[:, channel]))
    if word == "range":
        return np.asarray(sums.most[:, channel] - sums.least[:, channel])
    result = {"mean": "mean", "min": "least", "max": "most"}[word]
    return np.asarray(sums.rest[:, channel] + getattr(sums, result)[:, channel])


def of_course(metric: RunMetric, values: Array, rest: float, output_step: float) -> float:
    """Return a metric of the samples of a channel (``output_step`` s apart) with the value ``rest`` at rest."""
    return float(of_courses(metric, (values - rest)[None, :], np.array([rest]), output_step)[0])


def of_courses(metric: RunMetric, courses: Array, rest: Array, output_step: float) -> Array:
    """Return a metric of each row of samples, from which the values at rest have been subtracted."""
    if metric.needs_course:
        felt = [weight(row, 1.0 / output_step, metric.word) for row in courses]
        return np.array([float(np.sqrt(np.mean(row**2))) for row in felt])
    if metric.word == "rms":
        return np.asarray(np.sqrt(np.einsum("ij,ij->i", courses, courses) / courses.shape[1]))
    if metric.word == "range":
        return np.asarray(np.ptp(courses, axis=1))
    if metric.word == "mean":
        return np.asarray(rest + courses.mean(axis=1))
    return np.asarray(rest + (courses.min(axis=1) if metric.word == "min" else courses.max(axis=1)))
