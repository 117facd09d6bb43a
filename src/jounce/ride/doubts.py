"""Plausibility of ride accelerations, judged by their level, resolution and spectrum."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping

import numpy as np

from jounce.core.findings import Finding, finding
from jounce.core.types import Array, Complex

_BODY, _WHEEL = ("sprung", "body", "chassis"), ("unsprung", "wheel")
_SHORTEST = 10.0  # s; shorter records have too few averages of 8 s
_EMPTY = 20.0  # dB below the strongest octave; simulated bodies of cars and karts are at most 16 dB below it
_FALLING = 11.0  # dB from the octave above 8 Hz to the next; simulated bodies fall by at most 7
_STEEP = 15.0  # dB from the octave below 1 Hz to that above; roads and suspensions cause at most 14
_TRAVELS = {_BODY: (0.7, 0.06), _WHEEL: (4.0, 0.025)}
"""Frequency (Hz) above which suspension or tyre determines the motion, and an implausible r.m.s. motion (m)."""
_STEPS = 0.02  # share of a signal's power that its resolution may add (step^2 / 12)
_EXCHANGED = (
    2.0  # r.m.s. of body over wheel; a suspension isolates, so the ratio is well below 1 on a road
)
_RESPONSE = (0.7, 30.0)  # Hz: band in which the response of body to wheel is fitted
_FEWEST_LINES = 20  # lines in that band: at least ten per fitted parameter
_COHERENT = 0.9  # median coherence (1) below which noise decides the fit
_FAR, _CLOSE, _BETTER = 0.2, 0.12, 0.5  # 1
"""Residual without a filter, residual with one, and their ratio, from which a filter is reported."""


def doubts(accelerations: Mapping[str, Array], rate: float) -> Iterator[Finding]:
    """Report vertical accelerations that a ride does not produce.

    Parameters
    ----------
    accelerations : mapping of str to ndarray of shape (n,)
        Vertical accelerations in m/s^2 by channel name (suffix ``az``).
    rate : float
        Sample rate, Hz.

    Yields
    ------
    Finding
        A warning for motions beyond suspension and tyre (g recorded as m/s^2), empty bands (filters), coarse
        resolution, a body shaken more than the wheel below it (exchanged channels), and a body whose response to
        its wheel fits spring and damper only behind a filter.

    Examples
    --------
    >>> time = np.arange(2000) / 200.0
    >>> [finding.message for finding in doubts({"sprung.az": 40.0 * np.sin(8.0 * time)}, 200.0)][0]
    'above 0.7 Hz it implies a motion of 449 mm r.m.s., more than any suspension allows; are m/s^2 given as g?'
    """
    for name, values in accelerations.items():
        parts = name.split(".")
        kind = next((kind for kind in (_WHEEL, _BODY) if any(part in kind for part in parts)), None)
        centred = values - values.mean()
        power = float(centred @ centred) / centred.size
        if kind is None or power == 0.0:
            continue
        yield from _check_steps(name, values, power)
        if centred.size >= _SHORTEST * rate * (1.0 - 1e-9):
            frequency, density = _spectrum(centred, rate)
            yield from _check_travel(name, frequency, density, kind)
            if kind is _BODY:
                yield from _check_bands(name, frequency, density)
    for wheel, body in _pairs(accelerations):
        yield from _check_exchange(wheel, body, accelerations)
        yield from _check_filter(wheel, body, accelerations, rate)


def _pairs(names: Iterable[str]) -> Iterator[tuple[str, str]]:
    """Yield channels of wheels, each with that of the body above it."""
    for name in names:
        body = name.replace("unsprung.", "sprung.").replace("wheel.", "sprung.")
        if body != name and body in names:
            yield name, body


def _spectrum(centred: Array, rate: float) -> tuple[Array, Array]:
    from scipy import signal

    frequency, density = signal.welch(
        centred, rate, nperseg=min(round(8.0 * rate), centred.size), detrend="linear"
    )
    return np.asarray(frequency), np.asarray(density)


def _check_steps(name: str, values: Array, power: float) -> Iterator[Finding]:
    step = float(np.diff(np.unique(values)).min())
    share = step**2 / 12.0 / power
    if share > _STEPS:
        yield finding("ride.coarse_steps", name, step, step=step, rms=power**0.5, share=share)


def _check_travel(
    name: str, frequency: Array, density: Array, kind: tuple[str, ...]
) -> Iterator[Finding]:
    lowest, most = _TRAVELS[kind]
    inside = frequency > lowest
    motion = float(
        np.sqrt(np.sum(density[inside] / (2.0 * np.pi * frequency[inside]) ** 4) * frequency[1])
    )
    if motion > most:
        code = "ride.body_travels" if kind is _BODY else "ride.wheel_travels"
        yield finding(code, name, motion, lowest=lowest, motion=motion)


def _check_bands(name: str, frequency: Array, density: Array) -> Iterator[Finding]:
    level = {
        low: 10.0
        * np.log10(
            max(float(np.sum(density[(frequency >= low) & (frequency < 2.0 * low)])), 1e-300)
        )
        for low in (0.5, 1.0, 2.0, 4.0, 8.0, 16.0)
        if 2.0 * low <= frequency[-1]
    }
    strongest = max(level.values())
    if 16.0 in level and (strongest - level[16.0] > _EMPTY or level[8.0] - level[16.0] > _FALLING):
        yield finding(
            "ride.band_empty", name, strongest - level[16.0], fall=strongest - level[16.0]
        )
    if 1.0 in level and level[1.0] - level[0.5] > _STEEP:
        yield finding("ride.high_pass", name, level[1.0] - level[0.5], fall=level[1.0] - level[0.5])


def _check_exchange(wheel: str, body: str, accelerations: Mapping[str, Array]) -> Iterator[Finding]:
    ratio = float(accelerations[body].std()) / max(float(accelerations[wheel].std()), 1e-300)
    if ratio > _EXCHANGED:
        yield finding("ride.exchanged", body, ratio, ratio=ratio, wheel=wheel)


def _check_filter(
    wheel: str, body: str, accelerations: Mapping[str, Array], rate: float
) -> Iterator[Finding]:
    """Report a filter in one channel if the body follows its wheel through spring, damper and a filter."""
    given, answer = accelerations[wheel], accelerations[body]
    if given.size < _SHORTEST * rate * (1.0 - 1e-9) or min(np.ptp(given), np.ptp(answer)) == 0.0:
        return
    frequency, transfer, coherence = _transfer(given, answer, rate)
    if frequency.size < _FEWEST_LINES or float(np.median(coherence)) < _COHERENT:
        return
    residual_without, _ = _fit(frequency, transfer, coherence)
    for kind in _FILTERS:
        residual, corner = _fit(frequency, transfer, coherence, kind)
        if residual_without > _FAR and residual < min(_CLOSE, _BETTER * residual_without):
            yield finding(
                "ride.filtered",
                body,
                corner,
                wheel=wheel,
                filter=f"{kind}-pass filter",
                corner=corner,
                left=residual,
                plain=residual_without,
            )
            return


def _transfer(given: Array, answer: Array, rate: float) -> tuple[Array, Complex, Array]:
    """Return frequencies (n,) in Hz, response (n,) of one signal to another (1) and coherence (n,) (1)."""
    from scipy import signal

    length = min(round(4.0 * rate), given.size)
    frequency, cross = signal.csd(given, answer, rate, nperseg=length, detrend="linear")
    _, power = signal.welch(given, rate, nperseg=length, detrend="linear")
    _, output_power = signal.welch(answer, rate, nperseg=length, detrend="linear")
    # Anti-alias filters begin to act at 0.4 of the sample rate.
    inside = (frequency >= _RESPONSE[0]) & (frequency <= min(_RESPONSE[1], 0.4 * rate))
    cross, power, output_power = cross[inside], power[inside], output_power[inside]
    return frequency[inside], cross / power, np.abs(cross) ** 2 / (power * output_power)


_FILTERS: dict[str, tuple[Callable[[Complex], Complex], float]] = {
    "low": (lambda s: 1.0 / (1.0 + s), 10.0),
    "second-order low": (lambda s: 1.0 / (1.0 + np.sqrt(2.0) * s + s**2), 10.0),
    "high": (lambda s: s / (1.0 + s), 1.0),
}
"""Response of each kind of filter (1) at s over its corner frequency, and the initial corner (Hz)."""


def _fit(
    frequency: Array, transfer: Complex, coherence: Array, what: str = ""
) -> tuple[float, float]:
    """Fit a body on spring and damper, optionally behind a filter, to a response (n,) at frequencies (n,) in Hz.

    Returns the residual, as the r.m.s. logarithm of the ratio (1), and the corner in Hz.
    """
    from scipy.optimize import least_squares

    s = 2j * np.pi * frequency
    weight = coherence / np.sqrt(float(coherence @ coherence))

    def gap(logs: Array) -> Array:
        strut = np.exp(2.0 * logs[0]) + np.exp(logs[1]) * s
        model = strut / (s**2 + strut)
        if what:
            model = model * _FILTERS[what][0](1j * frequency * np.exp(-logs[2]))
        ratio = np.log(model / transfer) * weight
        return np.concatenate([ratio.real, ratio.imag])

    low, high = [-5.0, -5.0, np.log(0.01)], [10.0, 10.0, np.log(1e3)]
    count, corner = (3, np.log(_FILTERS[what][1])) if what else (2, 0.0)
    # bounce and wheel hop, Hz: two starts, since the error has two minima
    starts = (
        [np.log(2.0 * np.pi * own), np.log(np.pi * own), corner][:count] for own in (1.2, 5.0)
    )
    fits = (
        least_squares(gap, start, bounds=(low[:count], high[:count]), max_nfev=60)
        for start in starts
    )
    best = min(fits, key=lambda fit: float(fit.cost))
    return float(np.sqrt(2.0 * best.cost)), float(np.exp(best.x[2])) if what else 0.0
