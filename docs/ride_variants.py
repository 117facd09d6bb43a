"""Faulty records of known rides, and their findings: counts for a page and a test."""

from __future__ import annotations

import itertools
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

from jounce.core.errors import JounceError
from jounce.recordings import read_recording
from jounce.ride.metrics import ride_metrics

HIDDEN = ("m/s² called g", "g called m/s²")
"""Kinds of mistakes that leave a ride on another road, where the level does not tell."""
RATE, DURATION, MARGIN = 500.0, 40.0, 0.05
CORNERS = {  # body and wheel in kg, spring in N/m, damper in N s/m, tyre in N/m
    "car": (350.0, 40.0, 22e3, 1.6e3, 200e3),
    "van": (600.0, 60.0, 40e3, 3.0e3, 300e3),
    "kart": (40.0, 8.0, 30e3, 400.0, 140e3),
}
ROADS = {"good": 64e-6, "poor": 256e-6}  # m^3 at 0.1 cycles/m
SPEEDS = (12.0, 25.0)
Columns = dict[str, np.ndarray]
Signals = dict[str, tuple[np.ndarray, str]]


def ride(corner: str, road: str, speed: float, seed: int) -> Columns:
    """Accelerations of a linear quarter car over a random road, exact at each frequency; a period of 40 s."""
    body, wheel, spring, damper, tyre = CORNERS[corner]
    draw = np.random.default_rng([seed, round(speed), len(corner)])
    count = round(RATE * DURATION)
    f = np.fft.rfftfreq(count, 1.0 / RATE)[1:]
    s = 2j * np.pi * f
    density = ROADS[road] * (f / speed / 0.1) ** -2.0 / speed  # m^2/Hz
    z = np.sqrt(0.5 * density / DURATION) * count * np.exp(2j * np.pi * draw.random(f.size))
    z = z / (1.0 + s / (2.0 * np.pi * speed / 0.3))  # the contact patch
    strut = spring + damper * s
    whole = (wheel * s**2 + strut + tyre) * (body * s**2 + strut) - strut**2
    moved = {
        "sprung.az": strut * tyre / whole * z,
        "unsprung.az": (body * s**2 + strut) * tyre / whole * z,
    }
    found = {
        name: np.fft.irfft(np.concatenate([[0.0], s**2 * one]), count)
        for name, one in moved.items()
    }
    return {
        "time": np.arange(count) / RATE,
        **{n: a + 0.02 * draw.normal(size=count) for n, a in found.items()},
    }


def filtered(values: np.ndarray, corner: float, order: int, *, high: bool = False) -> np.ndarray:
    """A Butterworth filter, by its response at each frequency."""
    f = np.fft.rfftfreq(values.size, 1.0 / RATE)
    s = 1j * np.maximum(f, 1e-9) / corner
    poles = np.exp(1j * np.pi * (2.0 * np.arange(order) + order + 1.0) / (2.0 * order))
    gain = np.prod([1.0 / ((1.0 / s if high else s) - pole) for pole in poles], axis=0)
    return np.asarray(np.fft.irfft(gain * np.fft.rfft(values), values.size))


def variants(run: Columns) -> Iterator[tuple[str, str, Signals, dict[str, str]]]:
    """Kind and name of a variant, its channels with units, and options of its reader."""
    body, wheel = run["sprung.az"], run["unsprung.az"]

    def of(
        one: np.ndarray, other: np.ndarray = wheel, unit: str = "m/s^2", factor: float = 1.0
    ) -> Signals:
        return {"sprung.az": (one * factor, unit), "unsprung.az": (other * factor, unit)}

    yield "right", "as it is", of(body), {}
    for sign in (-1.0, 1.0):
        yield "sign, datum", f"sign {sign:g}", of(sign * body, sign * wheel), {}
        yield "sign, datum", f"gravity {sign:g}", of(body + sign * 9.81, wheel + sign * 9.81), {}
    for unit, factor in (("g", 1.0 / 9.80665), ("mg", 1e3 / 9.80665), ("mm/s^2", 1e3)):
        yield "unit", unit, of(body, unit=unit, factor=factor), {}
    yield "m/s² called g", "g", of(body, unit="g"), {}
    yield "g called m/s²", "m/s^2", of(body, factor=1.0 / 9.80665), {}
    yield "rate", "s called ms", of(body), {"time": "ms"}
    for step in (2, 5):
        yield (
            "rate",
            f"held for {step}",
            of(np.repeat(body[::step], step), np.repeat(wheel[::step], step)),
            {},
        )
    for lost, held in itertools.product((20, 1000, 5000), (0.0, None)):
        cut = body.copy()
        cut[4000 : 4000 + lost] = cut[4000] if held is None else held
        yield "dropout", f"{lost} samples of {held}", of(cut), {}
    for part in (0.01, 0.1, 0.5, 1.0, 1.7):
        step = part * float(body.std())
        yield "quantisation", f"{part:g} r.m.s.", of(np.round(body / step) * step), {}
    limit = 1.2 * float(body.std())
    yield "clipped", "at 1.2 r.m.s.", of(np.clip(body, -limit, limit)), {}
    for order, corner in itertools.product((1, 2, 4), (5.0, 10.0, 40.0)):
        yield "low pass", f"{corner:g} Hz, order {order}", of(filtered(body, corner, order)), {}
    for order, corner in itertools.product((1, 2, 4), (0.3, 1.0, 3.0)):
        yield (
            "high pass",
            f"{corner:g} Hz, order {order}",
            of(filtered(body, corner, order, high=True)),
            {},
        )
    yield "exchanged", "body and wheel", of(wheel, body), {}


def judge(signals: Signals, time: np.ndarray, unit_of_time: str, true: float, folder: Path) -> str:
    """Right (within 5 % of the weighted acceleration), refused, reported, or silently wrong."""
    file = folder / "ride.csv"
    head = ",".join(
        [f"time [{unit_of_time}]", *(f"{name} [{unit}]" for name, (_, unit) in signals.items())]
    )
    np.savetxt(
        file,
        np.column_stack([time, *(one for one, _ in signals.values())]),
        "%.7g",
        ",",
        header=head,
        comments="",
    )
    try:
        run, notes = read_recording(file)
        found = ride_metrics(
            run,
            start="mean",
            settling=2.0 if unit_of_time == "s" else 0.0,
            metrics=["weighted_rms"],
        )
    except JounceError:
        return "refused"
    if abs(found.value("weighted_rms", "sprung.az") / true - 1.0) < MARGIN:
        return "right"
    return (
        "told"
        if any(one.severity != "note" for one in (*notes, *found.findings))
        else "silently wrong"
    )


def outcomes(
    corners: tuple[str, ...] = tuple(CORNERS), say: Callable[[str], None] = lambda _text: None
) -> dict[str, dict[str, list[str]]]:
    """Names of the variants by kind and outcome."""
    counted: dict[str, dict[str, list[str]]] = {}
    with tempfile.TemporaryDirectory() as folder:
        for corner, road, speed in itertools.product(corners, ROADS, SPEEDS):
            say(f"{corner}, {road} road, {speed:g} m/s")
            run = ride(corner, road, speed, 3)
            from jounce.recordings import recording

            plain = recording(run["time"], {"sprung.az": (run["sprung.az"], "m/s^2", "")})
            true = ride_metrics(plain, start="mean", settling=2.0, metrics=["weighted_rms"]).value(
                "weighted_rms"
            )
            for kind, name, signals, how in variants(run):
                outcome = judge(signals, run["time"], how.get("time", "s"), true, Path(folder))
                by_outcome = counted.setdefault(kind, {})
                by_outcome.setdefault(outcome, []).append(
                    f"{corner}, {road}, {speed:g} m/s: {name}"
                )
    return counted
