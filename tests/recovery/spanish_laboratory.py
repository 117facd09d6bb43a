"""A laboratory unlike `raw_laboratory`: Spanish tables, weights and dial gauges, millivolts, a tyre that damps a lot.

It shares no code with jounce. Tabs and decimal commas, pressures in psi in names, speeds in a workbook, no pulses.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import openpyxl
from numpy.typing import NDArray
from scipy import signal

Array = NDArray[np.float64]
GRAVITY, STEP, RATE, BEFORE, LASTS = 9.81, 2e-4, 1000, 3.0, 6.0
TABLE = (
    (1, 1.95, 26, 0.31),
    (2, 2.86, 26, 0.31),
    (3, 3.79, 26, 0.31),
    (7, 2.03, 16, 0.31),
    (9, 1.92, 26, 0.25),
)
PSI = {0.31: 45, 0.25: 36}
SETTINGS = """schema = "jounce.laboratory/1"
sprung_mass = "16 kg"
unsprung_mass = "4.9 kg"
obstacle = {height = "10 mm", length = "60 mm"}
belt = {length = "1.97 m"}
trials = "ensayos.xlsx"
[channels]
"masa suspendida" = {measures = "sprung.az", sensitivity = "10 mV/(m/s^2)", high_pass = "1.5 Hz"}
"masa no suspendida" = {measures = "unsprung.az", sensitivity = "2 mV/(m/s^2)", high_pass = "1.5 Hz", orientation = -1}
"""


@dataclass(frozen=True)
class Truth:
    """What is behind the records, SI."""

    spring: float = 22300.0
    damper: float = 178.0
    tyre: float = 137e3
    soft_tyre: float = 124e3
    tyre_damping: float = 45.0
    sprung: float = 16.05
    unsprung: float = 4.87


def driven(truth: Truth) -> tuple[Array, Array]:
    """Accelerations of both masses at every step, shape (n, 2, trials), by fixed steps of Runge and Kutta."""
    speed = np.array([row[1] for row in TABLE])
    lever = np.cos(np.radians([row[2] for row in TABLE])) ** 2
    tyre = np.array([truth.tyre if row[3] > 0.3 else truth.soft_tyre for row in TABLE])
    phase = np.linspace(0.2, 1.6, len(TABLE))
    steps = round((BEFORE + LASTS) / STEP)

    def road(t: float) -> tuple[Array, Array]:
        u = np.mod(phase + speed * t, 1.97) / 0.06
        on = u < 1.0
        rise = 0.01 * np.pi / 0.06 * speed * np.cos(np.pi * u)
        return np.where(on, 0.01 * np.sin(np.pi * u), 0.0), np.where(on, rise, 0.0)

    def slopes(z: Array, t: float) -> Array:
        height, rise = road(t)
        strut = truth.spring * lever * (z[2] - z[0]) + truth.damper * lever * (z[3] - z[1])
        deflection = height - z[2]
        contact = np.maximum(tyre * deflection + truth.tyre_damping * (rise - z[3]), 0.0) * (
            deflection > 0.0
        )
        return np.stack(
            (
                z[1],
                strut / truth.sprung - GRAVITY,
                z[3],
                (contact - strut) / truth.unsprung - GRAVITY,
            )
        )

    weight = (truth.sprung + truth.unsprung) * GRAVITY
    z = np.stack(
        (
            -truth.sprung * GRAVITY / (truth.spring * lever) - weight / tyre,
            0 * tyre,
            -weight / tyre,
            0 * tyre,
        )
    )
    seen = np.empty((steps, 2, len(TABLE)))
    for i in range(steps):
        t = i * STEP
        a = slopes(z, t)
        seen[i] = a[1], a[3]
        b = slopes(z + 0.5 * STEP * a, t + 0.5 * STEP)
        c = slopes(z + 0.5 * STEP * b, t + 0.5 * STEP)
        d = slopes(z + STEP * c, t + STEP)
        z = z + STEP / 6.0 * (a + 2.0 * b + 2.0 * c + d)
    return np.arange(steps) * STEP, seen


def write(truth: Truth, folder: Path) -> None:
    """Write the folder of the laboratory: records, tests on a press with a dial gauge, workbook and settings."""
    folder.mkdir(parents=True)
    draw = np.random.default_rng(4)
    _, seen = driven(truth)
    high = signal.butter(1, 1.5, "high", fs=1.0 / STEP, output="sos")
    low = signal.butter(4, 400.0, fs=1.0 / STEP, output="sos")
    every, first = round(1.0 / (STEP * RATE)), round(BEFORE * RATE)
    for k, (number, _, _, pressure) in enumerate(TABLE):
        columns = []
        for channel, gain in ((0, 10.0), (1, -2.0)):
            volts = (
                gain
                * signal.sosfilt(low, signal.sosfilt(high, seen[:, channel, k]))[::every][first:]
            )
            columns.append(volts + 4.0 + 0.4 * draw.standard_normal(volts.size))
        time = np.arange(columns[0].size) / RATE
        _table(folder / f"ensayo{number:02d}_{PSI[pressure]}psi.txt", "tiempo (s)\tmasa suspendida (mV)\tmasa no "
               "suspendida (mV)", [time, *columns], f"Laboratorio de Vehículos\nEnsayo nº {number}\n\n")  # fmt: skip
    tests = [("resorte", truth.spring, 15.0)]
    tests += [
        (f"neumatico_{PSI[p]}psi_", rate, 10.0)
        for p, rate in ((0.31, truth.tyre), (0.25, truth.soft_tyre))
    ]
    for name, rate, stroke in tests:
        for repeat in (1, 2, 3):
            way = np.concatenate(
                [np.arange(0.0, stroke + 0.1, 0.5), np.arange(stroke - 0.5, -0.1, -0.5)]
            )
            load = rate * 1e-3 * way / 9.80665 * (
                1.0 + 0.003 * draw.standard_normal()
            ) + 0.1 * draw.standard_normal(way.size)
            _table(folder / f"{name}{repeat}.txt", "desplazamiento (mm)\tcarga (kg)", [way, load])
    book = openpyxl.Workbook()
    sheet = book.active
    sheet.append(["Tabla 2: Ensayos experimentales"])
    sheet.merge_cells("A1:E1")
    sheet.append(
        [
            "Ensayo",
            "Velocidad de paso [m/s]",
            "Ángulo del amortiguador [°]",
            "Presión [MPa]",
            "Perfil",
        ]
    )
    for row in TABLE:
        sheet.append([*row, "A"])
    book.save(folder / "ensayos.xlsx")
    (folder / "ajustes.toml").write_text(SETTINGS, encoding="utf-8")


def _table(file: Path, head: str, columns: list[Array], before: str = "") -> None:
    rows = "\n".join(
        "\t".join(f"{value:.5g}" for value in row) for row in zip(*columns, strict=True)
    )
    file.write_bytes(f"{before}{head}\n{rows}\n".replace(".", ",").encode("latin-1"))
