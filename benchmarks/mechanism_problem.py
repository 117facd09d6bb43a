"""The 3-D benchmark problem shared by all peers: the prototype's double wishbone over an obstacle.

Numbers come from ``tests/files/prototype``: model, obstacle and converged references for three speeds and both tyres.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

FILES = Path(__file__).parent.parent / "tests" / "files" / "prototype"
SPEEDS = (1.95, 2.86, 3.79)
TYRES = ("bilateral", "unilateral")
DURATION, SAMPLES = 3.0, 3001
TIMES = np.linspace(0.0, DURATION, SAMPLES)


@dataclass(frozen=True)
class Case:
    """One run: the model with one kind of tyre at one speed."""

    tyre: str
    speed: float

    @cached_property
    def model(self) -> dict[str, Any]:
        return json.loads((FILES / "double_wishbone.json").read_text(encoding="utf-8"))

    @cached_property
    def points(self) -> dict[str, Array]:
        return {name: np.array(point) for name, point in self.model["hardpoints"].items()}

    @property
    def unilateral(self) -> bool:
        return self.tyre == "unilateral"

    def inertia(self, body: str) -> tuple[float, Array, Array]:
        """Mass, centre of mass and inertia tensor about it, in design axes."""
        entry = self.model["bodies"][body]
        xx, yy, zz, xy, xz, yz = entry["inertia"]
        return (
            entry["mass"],
            np.array(entry["com"]),
            np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]),
        )

    @property
    def bump(self) -> tuple[float, float, float]:
        """Height (m), angular frequency of the half-sine (rad/s) and start (s)."""
        road = self.model["road"]
        return road["height"], np.pi * self.speed / road["length"], road["t_start"]

    @property
    def edges(self) -> tuple[float, float]:
        """Times at which the bump begins and ends, s."""
        _, wave, start = self.bump
        return start, start + np.pi / wave

    def road(self, t: Array) -> Array:
        """Height of the road, m."""
        height, wave, start = self.bump
        begin, end = self.edges
        return np.where((t > begin) & (t < end), height * np.sin(wave * (t - start)), 0.0)

    @cached_property
    def reference(self) -> tuple[Array, Array]:
        """Displacements of body and wheel centre, m."""
        with np.load(FILES / f"double_wishbone_{self.tyre}_{self.speed}.npz") as stored:
            return stored["zs"], stored["zu"]

    def error(self, zs: Array, zu: Array) -> float:
        """The larger of the two relative errors: largest difference over largest displacement."""
        pairs = zip((zs, zu), self.reference, strict=True)
        return max(float(np.abs(got - true).max() / np.abs(true).max()) for got, true in pairs)
