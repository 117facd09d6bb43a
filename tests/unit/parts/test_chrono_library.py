"""The shipped corners of Project Chrono are what the importer gives; run this file to write them anew."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from jounce.core.writing import write_atomically
from jounce.parts import library, load, rig_findings
from jounce.parts.importers import import_chrono

FILES = Path(__file__).parents[2] / "files" / "chrono"
CHRONO = "github.com/projectchrono/chrono, BSD-3-Clause"
# name: file, what other files of the same vehicle say (m, kg, N/m), and which; see SOURCE.md beside the shipped rigs
SHIPPED: dict[str, tuple[str, dict[str, float], str]] = {
    "hmmwv-front": (
        "HMMWV_DoubleWishboneFront_mapShock",
        {"wheel_radius": 0.4699, "wheel_mass": 56.4, "tyre_stiffness": 326332.0},
        "; wheel and tyre of the same vehicle",
    ),
    "sedan-double-wishbone": (
        "Sedan_DoubleWishbone",
        {"wheel_radius": 0.3266, "wheel_mass": 24.7, "sprung_mass": 312.5},
        "; wheel radius and mass and a quarter of the body of the same vehicle",
    ),
    "audi-double-wishbone": (
        "audi_DoubleWishbone",
        {"wheel_radius": 0.344, "tyre_stiffness": 280835.0, "sprung_mass": 316.7},
        "; tyre and share of the body of the same vehicle",
    ),
    "suv-front": (
        "suv_DoubleWishboneFront",
        {
            "wheel_radius": 0.409,
            "wheel_mass": 56.4,
            "tyre_stiffness": 248316.0,
            "sprung_mass": 561.3,
        },
        "; wheel, tyre and share of the body of the same vehicle",
    ),
    "van-front": (
        "van_DoubleWishboneFront",
        {
            "wheel_radius": 0.376,
            "wheel_mass": 31.8,
            "tyre_stiffness": 175000.0,
            "sprung_mass": 627.2,
        },
        "; wheel, tyre (185/80 R14) and share of the body of the same vehicle",
    ),
    "polaris-front": (
        "Polaris_Front_DoubleWishbone",
        {"wheel_radius": 0.330229, "wheel_mass": 33.9, "tyre_stiffness": 172246.0},
        "; wheel and tyre of the same vehicle",
    ),
    "generic-mcpherson": ("MacPhersonStrut", {}, ""),
    "sedan-multi-link": (
        "Sedan_MultiLink",
        {"wheel_radius": 0.3266, "wheel_mass": 24.7, "sprung_mass": 312.5},
        "; wheel radius and mass and a quarter of the body of the same vehicle",
    ),
    "generic-double-wishbone-curve": ("DoubleWishboneCurve", {}, ""),
}


def imported(name: str) -> tuple[Any, str]:
    file, values, more = SHIPPED[name]
    label = import_chrono(FILES / f"{file}.json")[0].source.partition(",")[0]
    rig, _, text = import_chrono(
        FILES / f"{file}.json", **values, source=f"{label} ({file}.json), {CHRONO}{more}"
    )
    return rig, text


@pytest.mark.parametrize("name", SHIPPED)
def test_shipped_file_is_what_the_importer_writes(name: str):
    rig, text = imported(name)
    assert library()[name].read_text(encoding="utf-8") == text, (
        "run python tests/unit/parts/test_chrono_library.py"
    )
    assert load(name) == rig
    assert CHRONO in rig.source


@pytest.mark.parametrize("name", SHIPPED)
def test_findings_of_shipped_rigs_are_known(name: str):
    known = {"suv-front": ["strut.rebound_stop.gap"], "polaris-front": ["hardpoints.strut_top"]}
    assert [finding.place for finding in rig_findings(load(name))] == known.get(name, [])


if __name__ == "__main__":
    for shipped in SHIPPED:
        folder = library()["kart-quarter-car"].parent
        write_atomically(folder / f"{shipped}.toml", imported(shipped)[1], force=True)
