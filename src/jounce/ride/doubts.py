"""Whether accelerations of a ride are what they are called: told by their level, their steps and their spectrum."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from jounce.core.findings import Finding
from jounce.core.types import Array

_BODY, _WHEEL = ("sprung", "body", "chassis"), ("unsprung", "wheel")
_SHORTEST = 10.0  # s: spectra of shorter records say little
_EMPTY = 20.0  # dB below the strongest octave; simulated bodies of cars and karts lie at most 16 dB below it
_FALLING = 11.0  # dB from the octave above 8 Hz to the next; simulated bodies fall by at most 7
_STEEP = 15.0  # dB from the octave below 1 Hz to that above; roads and suspensions make at most 14 of them
_TRAVELS = {_BODY: (0.7, 0.06), _WHEEL: (4.0, 0.025)}
"""Frequency (Hz) above which a motion is that of the suspension or tyre, and r.m.s. of it (m) that no vehicle has."""
_STEPS = 0.02  # share of a signal's power that steps of its resolution may add
_EXCHANGED = 2.0


def doubts(accelerations: Mapping[str, Array], rate: float) -> Iterator[Finding]:
    """Look for vertical accelerations that a ride does not make.

    Parameters
    ----------
    accelerations : mapping of str to ndarray of shape (n,)
        Signals in m/s^2 by channel name, those that end with ``az``.
    rate : float
        Samples per second, Hz.

    Yields
    ------
    Finding
        A warning for motions larger than suspension and tyre allow (m/s^2 called g), empty bands (filters), coarse
        steps, and a body that is shaken more than the wheel below it (exchanged channels).

    Examples
    --------
    >>> time = np.arange(2000) / 200.0
    >>> [found.message for found in doubts({"sprung.az": 40.0 * np.sin(8.0 * time)}, 200.0)][0]
    'above 0.7 Hz it means a motion of 449 mm r.m.s., and no suspension lets a body move so; is it m/s^2 called g?'
    """
    for name, values in accelerations.items():
        parts = name.split(".")
        kind = next((kind for kind in (_WHEEL, _BODY) if any(part in kind for part in parts)), None)
        moved = values - values.mean()
        power = float(moved @ moved) / moved.size
        if kind is None or power == 0.0:
            continue
        yield from _steps(name, values, power)
        if moved.size >= _SHORTEST * rate * (1.0 - 1e-9):
            frequency, density = _spectrum(moved, rate)
            yield from _travel(name, frequency, density, kind)
            if kind is _BODY:
                yield from _empty_bands(name, frequency, density)
    yield from _exchanged(accelerations)


def _spectrum(moved: Array, rate: float) -> tuple[Array, Array]:
    from scipy import signal

    frequency, density = signal.welch(moved, rate, nperseg=min(round(8.0 * rate), moved.size), detrend="linear")
    return np.asarray(frequency), np.asarray(density)


def _steps(name: str, values: Array, power: float) -> Iterator[Finding]:
    step = float(np.diff(np.unique(values)).min())
    share = step**2 / 12.0 / power
    if share > _STEPS:
        text = (
            f"its steps of {step:.3g} m/s^2 are coarse beside its {power**0.5:.3g} m/s^2 r.m.s.: they alone make "
            f"{100.0 * share:.2g} % of its power; choose a smaller range of the sensor or logger"
        )
        yield Finding(name, "warning", text, step)


def _travel(name: str, frequency: Array, density: Array, kind: tuple[str, ...]) -> Iterator[Finding]:
    lowest, most = _TRAVELS[kind]
    inside = frequency > lowest
    moved = float(np.sqrt(np.sum(density[inside] / (2.0 * np.pi * frequency[inside]) ** 4) * frequency[1]))
    if moved > most:
        what = "suspension lets a body" if kind is _BODY else "tyre lets a wheel"
        text = f"above {lowest:g} Hz it means a motion of {1e3 * moved:.3g} mm r.m.s., and no {what} move so; is it "
        yield Finding(name, "warning", text + "m/s^2 called g?", moved)


def _empty_bands(name: str, frequency: Array, density: Array) -> Iterator[Finding]:
    level = {
        low: 10.0 * np.log10(max(float(np.sum(density[(frequency >= low) & (frequency < 2.0 * low)])), 1e-300))
        for low in (0.5, 1.0, 2.0, 4.0, 8.0, 16.0)
        if 2.0 * low <= frequency[-1]
    }
    strongest = max(level.values())
    if 16.0 in level and (strongest - level[16.0] > _EMPTY or level[8.0] - level[16.0] > _FALLING):
        text = (
            f"from 16 to 32 Hz it is {strongest - level[16.0]:.0f} dB below its strongest octave, where wheels still "
            "shake a body: has a low pass (or a slow sensor) taken it away? Then weighted values are too small"
        )
        yield Finding(name, "warning", text, strongest - level[16.0])
    if 1.0 in level and level[1.0] - level[0.5] > _STEEP:
        text = (
            f"from the octave above 1 Hz to that below it falls by {level[1.0] - level[0.5]:.0f} dB, as behind a high "
            "pass (AC coupling): then the motion of the body is missing, and weighted values are too small"
        )
        yield Finding(name, "warning", text, level[1.0] - level[0.5])


def _exchanged(accelerations: Mapping[str, Array]) -> Iterator[Finding]:
    for name, values in accelerations.items():
        body = name.replace("unsprung.", "sprung.").replace("wheel.", "sprung.")
        if body != name and body in accelerations:
            ratio = float(accelerations[body].std()) / max(float(values.std()), 1e-300)
            if ratio > _EXCHANGED:
                text = f"it is shaken {ratio:.3g} times as much as {name}: were the two exchanged?"
                yield Finding(body, "warning", text, ratio)
