"""Mutations of models and roads of other programs: refused, or read as something that can be."""

from __future__ import annotations

import io
import re
import zipfile
from collections import Counter
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from corpus.judging import is_clear
from corpus.mutations import SEED, mutated

_FILES = Path(__file__).parents[2] / "files"
SAMPLES = {
    "Chrono: double wishbone": "chrono/HMMWV_DoubleWishboneFront_mapShock.json",
    "Chrono: strut": "chrono/MacPhersonStrut.json",
    "Chrono: multi-link": "chrono/Sedan_MultiLink.json",
    "tyre: Pacejka": "tyre_tir/audi_Pac02Tire.tir",
    "tyre: with tables": "tyre_tir/mf_185_80R14.tir",
    "Adams": "adams_car/made_up.cdb/subsystems.tbl/front.sub",
    "hardpoints: list": "hardpoints/strut.txt",
    "hardpoints: keys": "hardpoints/explorer.yaml",
    "hardpoints: front view": "hardpoints/vsusp.url",
    "MJCF": "mjcf/corner.xml",
    "OpenCRG: text": "road_crg/handmade_curved.crg",
    "OpenCRG: options": "road_crg/handmade_sloped_opts.crg",
    "OpenCRG: binary": "road_crg/halfround_4in.crg",
    "OpenCRG: reference": "road_crg/fileref_mods.crg",
    "road table": "",
    "FMU": "",
}
"""A good file of each kind."""
_DESCRIPTION = """<?xml version="1.0"?>
<fmiModelDescription fmiVersion="3.0" modelName="valve" instantiationToken="1">
<CoSimulation modelIdentifier="valve"/>
<UnitDefinitions><Unit name="mm/s"><BaseUnit m="1" s="-1" factor="0.001"/></Unit></UnitDefinitions>
<ModelVariables><Float64 name="v" valueReference="1" causality="input" unit="mm/s" start="0"/>
<Float64 name="gain" valueReference="2" causality="parameter" start="1.5"/>
<Float64 name="force" valueReference="3" causality="output"/></ModelVariables></fmiModelDescription>"""


@cache
def content_of(name: str) -> tuple[str, bytes]:
    """Name and content of a good file."""
    if SAMPLES[name]:
        content = (_FILES / SAMPLES[name]).read_bytes()
        return Path(SAMPLES[name]).name, re.sub(rb"\.\./crg-txt/\w+", b"handmade_curved", content)
    if name == "FMU":
        with zipfile.ZipFile(buffer := io.BytesIO(), "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr(
                zipfile.ZipInfo("modelDescription.xml", (1980, 1, 1, 0, 0, 0)), _DESCRIPTION
            )
            archive.writestr(
                zipfile.ZipInfo("binaries/x86_64-linux/valve.so", (1980, 1, 1, 0, 0, 0)),
                b"no library",
            )
        return "part.fmu", buffer.getvalue()
    x = np.arange(300) * 0.05
    rows = "".join(f"{one:.3f}, {0.01 * np.sin(one):.9f}\n" for one in x)
    return "road.csv", f"x [m], z [m]\n{rows}".encode()


def reader_of(name: str) -> str:
    """The kind of a file, before the colon of its name."""
    return name.partition(":")[0]


def cases(count: int, seed: int = SEED) -> list[tuple[str, int, int]]:
    """Sample, number and seed of so many mutations of the files of each kind, which its samples share."""
    kinds = Counter(map(reader_of, SAMPLES))
    return [
        (name, number, seed)
        for name in SAMPLES
        for number in range(-(-count // kinds[reader_of(name)]))
    ]


def _chrono(file: Path) -> Any:
    from jounce.parts.importers import import_chrono

    return import_chrono(file)[0].model_dump_json()


def _tyre(file: Path) -> Any:
    from jounce.parts.importers import read_tir

    return repr(read_tir(file).tyre())


def _road(file: Path) -> Any:
    from jounce.roads import load_road

    road = load_road(file)
    height = road.segments(road.end()).evaluate(np.linspace(0.0, road.end(), 50))[0]
    assert np.isfinite(height).all()
    return road.end(), height.tolist()


def _adams(file: Path) -> Any:
    from jounce.parts.importers import import_adams

    return import_adams(file)[0].model_dump_json()


def _hardpoints(file: Path) -> Any:
    from jounce.parts.importers import import_hardpoints

    return import_hardpoints(file)[0].model_dump_json()


def _mjcf(file: Path) -> Any:
    from jounce.parts.importers import import_mjcf

    return import_mjcf(file)[0].model_dump_json()


def _fmu(file: Path) -> Any:
    from jounce.control import read_fmu

    return {**read_fmu(file).to_dict(), "findings": []}


_READ: dict[str, Callable[[Path], Any]] = {
    ".json": _chrono, ".tir": _tyre, ".crg": _road, ".csv": _road, ".fmu": _fmu,
    ".txt": _hardpoints, ".yaml": _hardpoints, ".url": _hardpoints, ".xml": _mjcf, ".sub": _adams,
}  # fmt: skip


@cache
def truth_of(name: str) -> Any:
    """What the good file is read as."""
    file = Path(content_of(name)[0])
    file.write_bytes(content_of(name)[1])
    return _READ[file.suffix](file)


def verdict(case: tuple[str, int, int]) -> tuple[str, str]:
    """What reading one mutation gives."""
    from jounce.core.errors import JounceError

    name, number, seed = case
    for other in (_FILES / "road_crg").glob("*.crg"):  # those that others refer to
        if not Path(other.name).exists():
            Path(other.name).write_bytes(other.read_bytes())
    truth = truth_of(name)
    file, whole = Path(content_of(name)[0]), content_of(name)[1]
    kind, content = mutated(whole, seed, number)
    file.write_bytes(content)
    try:
        found = _READ[file.suffix](file)
    except JounceError as error:
        return ("refused" if is_clear(str(error), file.name) else "unclear"), f"{kind}: {error}"
    except Exception as error:  # noqa: BLE001 - whatever it is, it is a crash
        return "crashed", f"{kind}: {type(error).__name__}: {error}"
    finally:
        file.write_bytes(whole)
    if found == truth:
        return "right", kind
    if kind == "cut" and file.suffix == ".crg":
        return "silently wrong", f"{kind}: a road of {found[0]} m, not {truth[0]} m"
    return "undetectable", f"{kind}: other values"
