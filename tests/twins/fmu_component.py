"""The component FMU of ``tests/files/fmu/component.c``, made by the system's compiler, with descriptions to order."""

from __future__ import annotations

import subprocess
import zipfile
from functools import cache
from pathlib import Path

from jounce.control.fmu.platforms import PLATFORMS, this_platform
from jounce.exchange.fmu import build

SOURCE = Path(__file__).parents[1] / "files" / "fmu" / "component.c"
UNITS = """<UnitDefinitions>
<Unit name="mm/s"><BaseUnit m="1" s="-1" factor="0.001"/></Unit><Unit name="m/s"/>
<Unit name="kN.s/m"><BaseUnit kg="1" s="-1" factor="1000"/></Unit><Unit name="N.s/m"><BaseUnit kg="1" s="-1"/></Unit>
<Unit name="daN"><BaseUnit kg="1" m="1" s="-2" factor="10"/></Unit>
<Unit name="mm"><BaseUnit m="1" factor="0.001"/></Unit><Unit name="N/mm"><BaseUnit kg="1" s="-2" factor="1000"/></Unit>
<Unit name="N"><BaseUnit kg="1" m="1" s="-2"/></Unit></UnitDefinitions>"""
VARIABLES = (
    ("v_body", "Real", "input", "mm/s", "0"),
    ("v_strut", "Real", "input", "m/s", "0"),
    ("gain", "Real", "parameter", "kN.s/m", "1"),
    ("mistake", "Integer", "parameter", "", "0"),
    ("coefficient", "Real", "output", "N.s/m", ""),
    ("force", "Real", "output", "daN", ""),
    ("spare", "Real", "input", "", "2.5"),
    ("is_on", "Boolean", "parameter", "", "true"),
    ("steps", "Real", "output", "", ""),
    ("deflection", "Real", "input", "mm", "0"),
    ("rate", "Real", "input", "m/s", "0"),
    ("stiffness", "Real", "parameter", "N/mm", "0"),
    ("damping", "Real", "parameter", "N.s/m", "0"),
    ("preload", "Real", "parameter", "N", "0"),
    ("cubic", "Real", "parameter", "", "0"),
    ("pulls", "Real", "parameter", "", "1"),
    ("load", "Real", "output", "N", ""),
)


def can_be_made() -> bool:
    """Whether there is a compiler."""
    return build.compiler_for((this_platform(),)) is not None


@cache
def binary(version: int, folder: Path, source: Path = SOURCE) -> bytes:
    """The compiled component."""
    compiler = build.compiler_for((this_platform(),))
    assert compiler is not None
    out = folder / f"{source.stem}{version}"
    words = [
        *compiler[1],
        "-std=c99",
        "-O1",
        "-fPIC",
        "-shared",
        f"-DVERSION={version}",
        f"-I{build.C}",
        str(source),
    ]
    subprocess.run([*words, "-o", str(out), "-lm"], check=True, capture_output=True)
    return out.read_bytes()


def description(version: int, *, step: str = "", units: str = UNITS, **changes: str) -> str:
    """Text of the model description; ``changes`` are other units of variables."""
    step = step or '<CoSimulation modelIdentifier="component"/>'
    kinds = {"Real": "Float64", "Integer": "Int32"}
    rows = []
    for reference, (name, kind, causality, usual, start) in enumerate(VARIABLES):
        unit = changes.get(name, usual)
        more = (f' unit="{unit}"' if unit else "") + (f' start="{start}"' if start else "")
        head = f'name="{name}" valueReference="{reference}" causality="{causality}"'
        if version == 2:
            rows.append(f"<ScalarVariable {head}><{kind}{more}/></ScalarVariable>")
        else:
            rows.append(f"<{kinds.get(kind, kind)} {head}{more}/>")
    token = "guid" if version == 2 else "instantiationToken"
    return (
        f'<?xml version="1.0"?><fmiModelDescription fmiVersion="{version}.0" modelName="component" {token}="component">'
        f"{step}{units}<ModelVariables>{''.join(rows)}</ModelVariables></fmiModelDescription>"
    )


def write(path: Path, version: int, library: bytes, text: str = "", **more: bytes) -> Path:
    """Write the FMU; ``more`` are further files by name."""
    here = this_platform()
    folder = here if version == 3 else PLATFORMS[here].fmi2
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("modelDescription.xml", text or description(version))
        if library:
            archive.writestr(f"binaries/{folder}/component{PLATFORMS[here].suffix}", library)
        for name, content in more.items():
            archive.writestr(name, content)
    return path
