"""Mistakes on the benches of ``foreign_benches``: what a sensor or a user did, and nobody stated. NumPy only."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import foreign_benches
import numpy as np
from foreign_benches import Bench, Chain, Motion

LASER = "sprung.z"


def with_laser(bench: Bench) -> Bench:
    """The bench with a laser that measures the height of the body, beside its accelerometers."""
    chains = {**bench.rides[0].chains, LASER: Chain(corner=200.0, noise=5e-5)}
    rides = [
        replace(ride, chains=chains, delays={**ride.delays, LASER: 0.0}) for ride in bench.rides
    ]
    return replace(bench, rides=rides, channels=(*foreign_benches.CHANNELS[:2], LASER))


def to_the_road(bench: Bench, motions: Sequence[Motion], ahead: float = 0.0) -> list[Motion]:
    """Motions whose laser measures to the road, ``ahead`` (m) of the wheel's centre, as it passes below."""
    found = []
    for ride, motion in zip(bench.rides, motions, strict=True):
        recorded = motion.recorded[LASER]
        time = np.arange(len(recorded)) / foreign_benches.RATE - ride.delays.get(LASER, 0.0)
        way, _ = foreign_benches.travelled(ride.driven, np.maximum(time, 0.0))
        height, _ = foreign_benches.height_and_slope(ride.driven.road, way + ahead)
        found.append(replace(motion, recorded={**motion.recorded, LASER: recorded - height}))
    return found


def with_high_pass(motions: Sequence[Motion], channel: str, corner: float) -> list[Motion]:
    """Motions of which a channel is seen through a high pass of first order with its ``corner`` (Hz)."""
    found = []
    for motion in motions:
        record, seen = motion.recorded[channel], np.zeros(len(motion.recorded[channel]))
        left = np.exp(-2.0 * np.pi * corner / foreign_benches.RATE)
        for i, step in enumerate(np.diff(record), 1):
            seen[i] = left * seen[i - 1] + np.sqrt(left) * step
        found.append(replace(motion, recorded={**motion.recorded, channel: seen}))
    return found


def stated_higher(bench: Bench, factor: float) -> Bench:
    """The bench whose user states the obstacles too high by a ``factor``."""
    return replace(
        bench, roads=[replace(road, height=factor * road.height) for road in bench.roads]
    )
