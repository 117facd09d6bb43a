"""Residuals of a record after a fit, and the fault that they resemble: a delay, a scale error, a drift.

Fitted values compensate for such a fault as far as possible, and their intervals do not include it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from jounce.core.findings import Finding, finding
from jounce.core.types import Array
from jounce.identify.estimate import correlation_time
from jounce.identify.lags import Shifted, best_lag
from jounce.identify.signals import noise_of
from jounce.recordings.quality import clipped_share
from jounce.recordings.schema import channel_unit

_DELAY, _SCALE, _DRIFT = (
    0.35,
    0.5,
    0.5,
)  # share of the residual above which the explaining fault is reported
_SAMPLES, _GAIN, _RANGE = (
    0.3,
    0.05,
    0.01,
)  # in samples, of 1, of the range of the record: smaller faults do no harm
_CLIPPED = 1e-3  # of the samples at the limits of a sensor
_LOUD, _ALIKE, _MATTERS = (
    2.0,
    4.0,
    0.01,
)  # times the noise, samples of correlation, of the variance of the record


@dataclass(frozen=True)
class LeftOver:
    """One channel of one trial: record and reading of the updated model, shape (n,) each, SI; ``rate`` in Hz.

    ``noise`` is the standard deviation of the channel's noise if it is known.
    """

    trial: str
    measured: Array
    read: Array
    rate: float
    noise: float | None = None

    @property
    def rest(self) -> Array:
        """Measured signal minus reading, less the mean."""
        rest: Array = self.measured - self.read
        return np.asarray(rest - rest.mean())

    @property
    def shape(self) -> Array:
        """Reading of the model, less its mean."""
        return np.asarray(self.read - self.read.mean())


def faults(
    channel: str, parts: Sequence[LeftOver], longest: float, *, is_aligned: bool
) -> list[Finding]:
    """Report the fault of a channel's records that would explain most of the residual of all trials.

    ``longest`` is the largest delay considered (s). With ``is_aligned`` each trial already has a lag, and a delay is
    that of this channel behind the others.
    """
    left = sum(float(part.rest @ part.rest) for part in parts)
    trials = _some([part.trial for part in parts])
    if (
        left <= 0.0
        or len(parts[0].read) < _FEWEST
        or any(np.ptp(part.read) == 0.0 for part in parts)
    ):
        return []
    clipped = max(clipped_share(part.measured) for part in parts)
    if clipped > _CLIPPED:
        return [finding("identify.sensor_out_of_range", channel, clipped, share=clipped)]
    candidates = [
        _scale(channel, parts, left, trials),
        _drift(channel, parts, left, trials),
        _delay(channel, parts, left, trials, longest, is_aligned=is_aligned),
    ]
    return (
        [max(causes, key=lambda cause: cause[0])[1]]
        if (causes := [cause for cause in candidates if cause is not None])
        else []
    )


_FEWEST = 20  # samples, below which no pattern is looked for


def _some(names: Sequence[str]) -> str:
    return ", ".join(names[:4]) + (f" and {len(names) - 4} more" if len(names) > 4 else "")


def _scale(
    channel: str, parts: Sequence[LeftOver], left: float, trials: str
) -> tuple[float, Finding] | None:
    size = sum(float(part.shape @ part.shape) for part in parts)
    more = sum(float(part.rest @ part.shape) for part in parts) / size
    share = more**2 * size / left
    if share < _SCALE or abs(more) < _GAIN:
        return None
    return share, finding(
        "identify.gain_off", channel, 1.0 + more, factor=1.0 + more, trials=trials, share=share
    )


def _drift(
    channel: str, parts: Sequence[LeftOver], left: float, trials: str
) -> tuple[float, Finding] | None:
    shares, rises = 0.0, []
    for part in parts:
        place = np.linspace(-0.5, 0.5, len(part.rest))
        rises.append(float(part.rest @ place) / float(place @ place))
        shares += rises[-1] ** 2 * float(place @ place)
    rise = max(rises, key=abs)
    reach = max(float(np.ptp(part.read)) for part in parts)
    if shares / left < _DRIFT or abs(rise) < _RANGE * reach:
        return None
    return shares / left, finding(
        "identify.drift",
        channel,
        rise,
        rise=rise,
        unit=channel_unit(channel),
        trials=trials,
        share=shares / left,
    )


def _delay(
    channel: str,
    parts: Sequence[LeftOver],
    left: float,
    trials: str,
    longest: float,
    *,
    is_aligned: bool,
) -> tuple[float, Finding] | None:
    rate = min(part.rate for part in parts)
    beside = [
        Shifted.of(part.measured, part.read[:, None], 1.0, part.rate, offset=True) for part in parts
    ]
    is_alike = len({(len(part.read), part.rate) for part in parts}) == 1
    lag = (
        best_lag(beside, longest)
        if is_alike
        else float(np.median([best_lag([shifted], longest) for shifted in beside]))
    )
    after = 0.0
    for part, shifted in zip(parts, beside, strict=True):
        rest = part.measured - shifted.at(lag)[0][:, 0]
        after += float(np.sum((rest - rest.mean()) ** 2))
    share = 1.0 - after / left
    if share < _DELAY or abs(lag) * rate < _SAMPLES:
        return None
    code = {
        (True, False): "identify.later_than_model",
        (False, False): "identify.earlier_than_model",
        (True, True): "identify.later_than_channels",
        (False, True): "identify.earlier_than_channels",
    }[lag > 0.0, is_aligned]
    return share, finding(code, channel, lag, lag=abs(lag), trials=trials, share=share)


def beyond_noise(parts: Sequence[LeftOver]) -> float | None:
    """Return the ratio of the residuals to the noise of the records, or None if no relevant pattern remains."""
    noises = [noise_of(part.measured) if part.noise is None else part.noise for part in parts]
    noise = float(np.sqrt(np.mean(np.square(noises))))
    rest = float(np.sqrt(np.mean(np.concatenate([part.rest for part in parts]) ** 2)))
    size = float(
        np.sqrt(
            np.mean(np.concatenate([part.measured - part.measured.mean() for part in parts]) ** 2)
        )
    )
    alike = float(np.median([correlation_time(part.rest) for part in parts]))
    if rest < _LOUD * noise or alike < _ALIKE or rest**2 < _MATTERS * size**2:
        return None
    return rest / max(noise, 1e-3 * rest)
