"""A synthetic axle: straight laws of toe, camber and movement, as the files of a rig write them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import numpy as np
import pytest

TRACK = 1.5
LOAD, RATE = 4000.0, 30e3
TOE, CAMBER, SCRUB = -0.08, -0.35, 0.05
"""Change of toe and camber (rad/m) and of half the track (1) with wheel travel."""
GIVE, LEAN = 1e-6, -1.5e-6
"""Movement of the contact point (m/N) outwards, and camber (rad/N), under an outward force."""
SIDES = {"L": 1.0, "R": -1.0}


def loop(to: float, cycles: int = 1, steps: int = 10) -> np.ndarray:
    """Input 0 -> to -> -to -> 0, a number of times."""
    quarter = np.arange(steps) / steps
    wave = np.concatenate([quarter, 1 - quarter, -quarter, quarter - 1])
    return to * np.append(np.tile(wave, cycles), 0.0)


def columns(test: str, u: np.ndarray) -> dict[str, np.ndarray]:
    """Columns of a synthetic sheet in ISO signs, mm, deg and N, for an input in SI."""
    sheet: dict[str, np.ndarray] = {}
    for letter, side in SIDES.items():
        out = {"lateral-in-phase": side, "lateral-opposed": 1.0}.get(test, 0.0) * u  # outward force
        z = {"bounce": 1.0, "roll": side * TRACK / 2}.get(test, 0.0) * u
        steer = u / 0.14 if test == "steer" else 0.0 * u
        sheet |= {
            f"Toe {letter} [deg]": np.degrees(0.002 + TOE * z + 2e-7 * out - side * steer),
            f"Camber {letter} [deg]": np.degrees(-0.01 + CAMBER * z + LEAN * out),
            f"WC Y {letter} [mm]": 1e3 * side * (0.9 * SCRUB * z + 0.6 * GIVE * out),
            f"WC Z {letter} [mm]": 950.0 * z,
            f"Contact Patch Y {letter} [mm]": 1e3 * side * (SCRUB * z + GIVE * out),
            f"Contact Patch Z {letter} [mm]": 1e3 * z,
            f"Fz {letter} [N]": LOAD + RATE * z,
            f"Fy {letter} [N]": side * out,
        }
    if test == "roll":
        sheet["Roll Angle [deg]"] = np.degrees(u)
    if test == "steer":
        sheet["Rack Travel [mm]"] = 1e3 * u
    return sheet


INPUTS = {"bounce": 0.05, "roll": 0.05, "steer": 0.04}


class SyntheticRig:
    """Writes files of the synthetic axle."""

    TRACK, LOAD, RATE, TOE, CAMBER, SCRUB, GIVE, LEAN = (
        TRACK, LOAD, RATE, TOE, CAMBER, SCRUB, GIVE, LEAN)  # fmt: skip

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    @staticmethod
    def loop(to: float, cycles: int = 1, steps: int = 10) -> np.ndarray:
        return loop(to, cycles, steps)

    @staticmethod
    def columns(test: str, u: np.ndarray | None = None) -> dict[str, np.ndarray]:
        return columns(test, loop(INPUTS.get(test, 2000.0)) if u is None else u)

    def write(
        self, name: str, sheet: Mapping[str, Sequence[float] | np.ndarray], above: str = ""
    ) -> Path:
        """Write columns as a text file with semicolons."""
        file = self.folder / name
        rows = zip(*sheet.values(), strict=True)
        lines = [
            ";".join(sheet),
            *(";".join(f"{float(cell):.12g}" for cell in row) for row in rows),
        ]
        file.write_text(above + "\n".join(lines) + "\n", encoding="utf-8")
        return file

    def write_test(
        self, test: str, change: Callable[[dict[str, np.ndarray]], None] | None = None, **more: str
    ) -> Path:
        """Write a test, after a change of its columns."""
        sheet = self.columns(test)
        if change is not None:
            change(sheet)
        return self.write(f"{test}.csv", sheet, **more)


@pytest.fixture
def rig(tmp_path: Path) -> SyntheticRig:
    return SyntheticRig(tmp_path)
