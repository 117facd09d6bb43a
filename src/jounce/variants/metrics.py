"""Metrics of a run, named by words: ``rms sprung.az``, ``max tyre.force``, ``Wk sprung.az``.

All of them are sums over samples, except the weightings of ISO 2631-1, ``absorbed_power`` and ``shock``, which need
the time history of the channel.
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
from jounce.ride import absorbed_power as power
from jounce.ride.weighting import WEIGHTINGS, check_duration, weight

if TYPE_CHECKING:
    from jounce.variants.side_by_side import Sums

WORDS = {
    "rms": "root mean square about the value at rest",
    "mean": "mean",
    "min": "least value",
    "max": "greatest value",
    "range": "greatest less least value",
    "peak": "largest magnitude about the value at rest",
}
"""First words of metrics that are sums, in addition to the names of weightings."""
BODY_WORDS = {
    "absorbed_power": "power that a seated person absorbs",
    "shock": "largest magnitude below 30 Hz",
}
"""First words of metrics of vertical accelerations, which need their time history."""
_VERTICAL = "m/s^2"


@dataclass(frozen=True)
class RunMetric:
    """A metric of a run, computed from a channel.

    Attributes
    ----------
    text : str
        Text of the metric, with the full name of the channel.
    word : str
        One of ``WORDS`` or ``BODY_WORDS``, or a weighting.
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
            or BODY_WORDS.get(self.word)
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
        known = (*WORDS, *BODY_WORDS, *WEIGHTINGS)
        if words[0] not in known:
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
        metrics += [_metric_of(words[0], name, units[name]) for name in channels]
    return list({metric.text: metric for metric in metrics}.values())


def _metric_of(word: str, channel: str, unit: str) -> RunMetric:
    if word in BODY_WORDS and unit != _VERTICAL:
        raise DescriptionError(
            Phrase("{word} is defined only for accelerations", word=word),
            where="metrics",
            found=f"{channel} in {unit}",
            allowed="e.g. 'absorbed_power sprung.az'",
        )
    return RunMetric(f"{word} {channel}", word, channel, "W" if word == "absorbed_power" else unit)


def check_durations(metrics: Iterable[RunMetric], durations: Iterable[float]) -> None:
    """Reject weightings and mean powers if the runs (s) are too short for them."""
    shortest = min(map(float, durations))
    for metric in metrics:
        if metric.word == "absorbed_power":
            power.check_length(shortest, where=metric.text)
        elif metric.word in WEIGHTINGS:
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
    if word == "peak":
        return np.asarray(np.maximum(sums.most[:, channel], -sums.least[:, channel]))
    result = {"mean": "mean", "min": "least", "max": "most"}[word]
    return np.asarray(sums.rest[:, channel] + getattr(sums, result)[:, channel])


def of_course(metric: RunMetric, values: Array, rest: float, output_step: float) -> float:
    """Return a metric of the samples of a channel (``output_step`` s apart) with the value ``rest`` at rest."""
    return float(of_courses(metric, (values - rest)[None, :], np.array([rest]), output_step)[0])


def of_courses(
    metric: RunMetric, courses: Array, rest: Array, output_step: float, first: int = 0
) -> Array:
    """Return a metric of each row of samples, from which the values at rest have been subtracted.

    Filters see all samples; those before ``first`` do not count.
    """
    if metric.needs_course:
        return np.array([_filtered(metric.word, row, 1.0 / output_step, first) for row in courses])
    courses = courses[:, first:]
    if metric.word == "rms":
        return np.asarray(np.sqrt(np.einsum("ij,ij->i", courses, courses) / courses.shape[1]))
    if metric.word == "range":
        return np.asarray(np.ptp(courses, axis=1))
    if metric.word == "peak":
        return np.asarray(np.abs(courses).max(axis=1))
    if metric.word == "mean":
        return np.asarray(rest + courses.mean(axis=1))
    return np.asarray(rest + (courses.min(axis=1) if metric.word == "min" else courses.max(axis=1)))


def _filtered(word: str, course: Array, rate: float, first: int) -> float:
    """Return a metric of a filtered course (rate in Hz) from its sample ``first`` on."""
    if word == "shock":
        return float(np.abs(power.shock_course(course, rate)[first:]).max())
    if word == "absorbed_power":
        return float(np.mean(power.power_course(course, rate)[first:]))
    return float(np.sqrt(np.mean(weight(course, rate, word)[first:] ** 2)))
