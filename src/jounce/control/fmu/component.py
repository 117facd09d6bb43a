"""Read the description of an FMU of another tool, and unpack its files within limits."""

from __future__ import annotations

import atexit
import errno
import math
import re
import shutil
import stat
import zipfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import ClassVar
from xml.etree import ElementTree as ET

from jounce.control.fmu.platforms import PLATFORMS, this_platform
from jounce.core.errors import DescriptionError
from jounce.core.files import State, existing_file, state_of
from jounce.core.findings import Finding, finding
from jounce.core.markup import parse_xml
from jounce.core.phrases import Phrase
from jounce.core.serialise import Plain
from jounce.core.turns import turn
from jounce.core.units import base_units, conversion_factor, is_unit
from jounce.core.writing import lasting_folder

_MOST_FILES, _MOST_BYTES, _LONGEST_DESCRIPTION = (
    20_000,
    1_000_000_000,
    50_000_000,
)  # bytes: no archive fills the disk
_BASES = ("kg", "m", "s", "A", "K", "mol", "cd")  # an angle is one whether it says so or not
REALS = ("Real", "Float64", "Float32")
"""Types of real numbers."""
WHOLE = (
    "Boolean", "Integer", "Enumeration", "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64", "UInt64",
)  # fmt: skip
"""Types of whole numbers, of which a Boolean has two."""
_CHUNK = 1 << 20  # bytes read at once


@dataclass(frozen=True)
class FmuVariable(Plain):
    """One variable of an FMU.

    Attributes
    ----------
    name : str
        As the FMU has it.
    kind : str
        Type: ``Real``, ``Float64``, ``Boolean`` and so on.
    causality, variability : str
        As FMI has them.
    unit : str
        Of the FMU's values; empty where it has none.
    start : str
        Value before anyone sets it, as written; empty where there is none.
    text : str
        What it is.
    reference : int
        Value reference.
    dimensions : tuple of int
        Elements along each dimension of an array (FMI 3.0), with its structural parameters at their starts; empty for
        a single value.
    """

    left_out = ("reference",)
    name: str
    kind: str
    causality: str
    variability: str
    unit: str
    start: str
    text: str
    reference: int
    dimensions: tuple[int, ...] = ()

    @property
    def size(self) -> int:
        """How many values it has."""
        return math.prod(self.dimensions)

    @property
    def shape(self) -> str:
        """Its type in a message, with the dimensions of an array."""
        return (
            f"{self.kind}[{', '.join(map(str, self.dimensions))}]" if self.dimensions else self.kind
        )

    @property
    def is_number(self) -> bool:
        """Whether its values are numbers: real, whole, of an enumeration, or 0 and 1."""
        return self.is_whole or self.kind in REALS

    @property
    def is_whole(self) -> bool:
        """Whether its values are whole numbers, or 0 and 1."""
        return self.kind in WHOLE


@dataclass(frozen=True)
class _Unit:
    """What one unit is in SI: ``si = factor * value + offset``, of these powers; none where the FMU does not say."""

    factor: float
    offset: float
    powers: Mapping[str, int] | None


@dataclass(frozen=True)
class FmuComponent(Plain):
    """Description of an FMU, as its file states it.

    Attributes
    ----------
    path : Path
        The FMU.
    version : int
        Of FMI, 2 or 3.
    name, tool : str
        Of the model, and what made it.
    inputs, outputs, parameters : tuple of FmuVariable
        What can be connected, and what can be set before a run.
    structural_parameters : tuple of FmuVariable
        What sizes its arrays, and keeps its start here.
    platforms : tuple of str
        Platforms with a binary, as FMI 3.0 names them.
    can_step, can_be_integrated : bool
        Whether it is made for co-simulation, and for model exchange.
    findings : tuple of Finding
        What stands in the way of a run here.
    token, identifier : str
        What ties description and binary together, and the binary's name.
    units : mapping
        What the FMU's units are in SI.
    is_once : bool
        Whether a process can have one instance only.
    fixed_step : float or None
        Step inside, s, of which the control period is a multiple; None where it has none.
    needs_tool : bool
        Whether what made it must be installed where it runs.

    Examples
    --------
    >>> import tempfile
    >>> import jounce as jn
    >>> file = tempfile.mkdtemp() + "/kart.fmu"
    >>> _ = jn.export_fmu(jn.load("kart-quarter-car"), file, platforms=())
    >>> [(v.name, v.unit) for v in jn.read_fmu(file).inputs]
    [('road.z', 'm'), ('road.vz', 'm/s')]
    """

    left_out: ClassVar[tuple[str, ...]] = (
        "token",
        "identifier",
        "units",
        "is_once",
        "fixed_step",
        "needs_tool",
    )
    path: Path
    version: int
    name: str
    tool: str
    inputs: tuple[FmuVariable, ...]
    outputs: tuple[FmuVariable, ...]
    parameters: tuple[FmuVariable, ...]
    structural_parameters: tuple[FmuVariable, ...]
    platforms: tuple[str, ...]
    can_step: bool
    can_be_integrated: bool
    findings: tuple[Finding, ...]
    token: str
    identifier: str
    units: Mapping[str, _Unit] = field(repr=False)
    is_once: bool
    fixed_step: float | None
    needs_tool: bool = False

    def conversion(self, variable: FmuVariable, si: str) -> tuple[float, float]:
        """Factor and offset from SI values in ``si`` to the FMU's own: ``own = factor * value + offset``.

        Where the variable has no unit its values are SI. A DescriptionError refuses a unit of something else.
        """
        if not variable.unit:
            return 1.0, 0.0
        unit = self.units.get(variable.unit, _Unit(1.0, 0.0, None))
        if unit.powers is None:
            return 1.0 / conversion_factor(
                variable.unit, si, where=f"{self.path}: {variable.name}"
            ), 0.0
        wanted = base_units(si)
        if any(unit.powers.get(base, 0) != wanted.get(base, 0) for base in _BASES):
            raise DescriptionError(
                "the unit does not fit",
                where=f"{self.path}: {variable.name}",
                found=variable.unit,
                allowed=Phrase("a unit that converts to {si}", si=si),
                hint="Connect it to another channel.",
            )
        return 1.0 / unit.factor, -unit.offset / unit.factor

    def si_unit(self, variable: FmuVariable) -> str:
        """The SI unit that values of a variable are given in; ``"1"`` where the FMU does not say."""
        unit = self.units.get(variable.unit)
        if unit is None or unit.powers is None:
            return variable.unit if is_unit(variable.unit) else "1"
        return "*".join(f"{base}^{power}" for base, power in unit.powers.items() if power) or "1"

    def binary(self) -> str:
        """Place of this machine's binary in the archive; a DescriptionError says why it cannot be run here."""
        where = str(self.path)
        if not self.can_step:
            raise DescriptionError(
                "the FMU is for model exchange only: it needs an integrator, and contains none",
                where=where,
                allowed="FMUs for co-simulation",
                hint="Export it again for co-simulation.",
            )
        for item in self.findings:
            if item.severity == "problem":
                raise DescriptionError(item.message.rstrip("."), where=where, allowed=_ALLOWED)
        here = this_platform()
        folder = here if self.version == 3 else PLATFORMS[here].fmi2
        return f"binaries/{folder}/{self.identifier}{PLATFORMS[here].suffix}"


_ALLOWED = "FMUs for co-simulation with a binary for this machine"


def read_fmu(path: Path | str) -> FmuComponent:
    """Read the description of a Functional Mock-up Unit of any tool; nothing of it is run.

    Parameters
    ----------
    path : Path or str
        The ``.fmu`` file, FMI 2.0 or 3.0.

    Returns
    -------
    FmuComponent
        Inputs, outputs and parameters with their units, platforms, and what stands in the way of a run here.

    Raises
    ------
    DescriptionError
        For what is no FMU, a damaged archive, names that lead out of it, sizes beyond all limits, and other versions.

    Examples
    --------
    >>> import tempfile
    >>> import jounce as jn
    >>> file = tempfile.mkdtemp() + "/kart.fmu"
    >>> _ = jn.export_fmu(jn.load("kart-quarter-car"), file, platforms=(), version=2)
    >>> read_fmu(file).version
    2
    """
    file = existing_file(path)
    with _refuse_damaged(file), zipfile.ZipFile(file) as archive:
        members = _members(archive, str(file))
        if "modelDescription.xml" not in members:
            raise DescriptionError(
                "no modelDescription.xml is in it", where=str(file), allowed="an FMU"
            )
        info = members["modelDescription.xml"]
        if info.file_size > _LONGEST_DESCRIPTION:
            most = Phrase(
                "up to {longest_description} MB",
                longest_description=_LONGEST_DESCRIPTION // 1_000_000,
            )
            raise DescriptionError("its description is too large", where=str(file), allowed=most)
        text = archive.read(info)
    return _component(file, _parse(text, str(file)), members)


@contextmanager
def _refuse_damaged(file: Path) -> Iterator[None]:
    """Turn any error of an archive into one refusal: each compression method raises its own."""
    try:
        yield
    except DescriptionError:
        raise
    except Exception as error:  # of lzma, bz2, zlib, struct, or of encrypted and unknown archives
        if isinstance(error, OSError) and error.errno in (
            errno.ENOSPC,
            errno.EDQUOT,
            errno.EROFS,
            errno.EACCES,
        ):
            raise  # of the disk that receives the files
        text = " ".join(str(error).split()) or type(error).__name__
        allowed = "an FMU (a ZIP file)"
        raise DescriptionError(
            Phrase("not an archive that can be read: {text}", text=text),
            where=str(file),
            allowed=allowed,
        ) from None


def _members(archive: zipfile.ZipFile, where: str) -> dict[str, zipfile.ZipInfo]:
    """Files of an archive by name; refuse links, paths that lead out of it, and too many or too large files."""
    files = [info for info in archive.infolist() if not info.orig_filename.endswith("/")]
    size = sum(info.file_size for info in files)
    if len(files) > _MOST_FILES or size > _MOST_BYTES:
        raise DescriptionError(
            "too large for an FMU",
            where=where,
            found=f"{len(files)} files of {size / 1e6:.4g} MB together, unpacked",
            allowed=Phrase(
                "{most_files} files of {most_bytes:g} MB together",
                most_files=_MOST_FILES,
                most_bytes=_MOST_BYTES / 1e6,
            ),
        )
    members: dict[str, zipfile.ZipInfo] = {}
    for info in files:
        name = info.orig_filename
        parts = name.split("/")
        is_link = stat.S_ISLNK(info.external_attr >> 16)
        if is_link or ".." in parts or "" in parts or any(sign in name for sign in "\\:\0"):
            what = "a link in the archive" if is_link else "a path that leads out of the archive"
            raise DescriptionError(
                what, where=where, found=name, allowed="plain files within the FMU"
            )
        if name in members:
            raise DescriptionError("a file is twice in the archive", where=where, found=name)
        members[name] = info
    return members


def _parse(text: bytes, where: str) -> ET.Element:
    try:
        return parse_xml(text)
    except (ET.ParseError, ValueError, LookupError) as error:
        raise DescriptionError(
            Phrase("its modelDescription.xml is not XML of an FMU: {error}", error=str(error)),
            where=where,
        ) from None


def _component(
    file: Path, root: ET.Element, members: Mapping[str, zipfile.ZipInfo]
) -> FmuComponent:
    where = str(file)
    said = root.get("fmiVersion", "")
    version = {"2.0": 2, "3.0": 3}.get(said[:3])
    if root.tag != "fmiModelDescription" or version is None:
        raise DescriptionError(
            "another version of FMI",
            where=where,
            found=said or root.tag,
            allowed="2.0, 3.0",
            hint="Export it again.",
        )
    step = root.find("CoSimulation")
    able = step if step is not None else root.find("ModelExchange")
    identifier = "" if able is None else able.get("modelIdentifier", "")
    variables = _variables(root, version, where)
    platforms = tuple(
        name
        for name, kind in PLATFORMS.items()
        if f"binaries/{name if version == 3 else kind.fmi2}/{identifier}{kind.suffix}" in members
    )
    options = {} if step is None else step.attrib
    pace = _number(options.get("fixedInternalStepSize"), where)
    if pace is not None and pace < 0.0:
        raise DescriptionError("its fixed step is negative", where=where, found=f"{pace:g} s")
    findings = []
    if this_platform() not in platforms:
        code = "control.no_binary" if platforms else "control.sources_only"
        findings.append(
            finding(code, where, machine=this_platform(), platforms=", ".join(platforms))
        )
    needs_tool = options.get("needsExecutionTool") in ("true", "1")
    if needs_tool:
        findings.append(
            finding("control.tool", where, tool=root.get("generationTool") or "that made it")
        )
    if step is None:
        findings.append(finding("control.model_exchange", where))
    return FmuComponent(
        file,
        version,
        root.get("modelName", ""),
        root.get("generationTool", ""),
        tuple(v for v in variables if v.causality == "input"),
        tuple(v for v in variables if v.causality == "output"),
        tuple(v for v in variables if v.causality == "parameter"),
        tuple(v for v in variables if v.causality == "structuralParameter"),
        platforms,
        step is not None,
        root.find("ModelExchange") is not None,
        tuple(findings),
        root.get("guid" if version == 2 else "instantiationToken", ""),
        identifier,
        _units(root, where),
        options.get("canBeInstantiatedOnlyOncePerProcess") in ("true", "1"),
        pace,
        needs_tool,
    )


def _variables(root: ET.Element, version: int, where: str) -> list[FmuVariable]:
    declared = {}
    for kind in root.iterfind("TypeDefinitions/*"):
        typed = kind if version == 3 else next(iter(kind), kind)
        declared[kind.get("name", "")] = typed.get("unit", "")
    variables, names = [], set[str]()
    sizes = {
        row.get("valueReference", ""): row.get("start", "")
        for row in root.iterfind("ModelVariables/*")
        if row.get("causality") == "structuralParameter"
    }
    for row in root.iterfind("ModelVariables/*"):
        typed = (
            row
            if version == 3
            else next((child for child in row if child.tag != "Annotations"), row)
        )
        unit = typed.get("unit") or declared.get(typed.get("declaredType", ""), "")
        try:
            reference = int(row.get("valueReference", ""))
        except ValueError:
            reference = -1
        if not 0 <= reference < 2**32:
            place = f"{where}: {row.get('name')}"
            raise DescriptionError(
                "no value reference", where=place, found=row.get("valueReference")
            )
        if row.get("name", "") in names:
            raise DescriptionError(
                "two variables have the same name", where=where, found=row.get("name", "")
            )
        names.add(row.get("name", ""))
        variables.append(
            FmuVariable(
                row.get("name", ""),
                typed.tag,
                row.get("causality", "local"),
                row.get("variability", ""),
                unit,
                _start(typed),
                row.get("description", ""),
                reference,
                tuple(
                    _elements(child, sizes, f"{where}: {row.get('name')}")
                    for child in row.iterfind("Dimension")
                ),
            )
        )
    return variables


def _elements(dimension: ET.Element, sizes: Mapping[str, str], where: str) -> int:
    """Number of elements along a dimension: as written, or the start of the structural parameter that it names."""
    said = dimension.get("start") or sizes.get(dimension.get("valueReference", ""), "")
    if not re.fullmatch("[0-9]{1,18}", said):
        raise DescriptionError(
            "an array without a size", where=where, found=said, allowed="a whole number"
        )
    return int(said)


def _start(typed: ET.Element) -> str:
    """Start value as it is written; a text of FMI 3.0 has it in a child element."""
    row = typed.find("Start")
    return typed.get("start", "") if row is None else row.get("value", "")


def _units(root: ET.Element, where: str) -> dict[str, _Unit]:
    units = {}
    for unit in root.iterfind("UnitDefinitions/Unit"):
        base, name = unit.find("BaseUnit"), unit.get("name", "")
        if base is None:
            units[name] = _Unit(1.0, 0.0, None)
            continue
        place = f"{where}: unit {name}"
        factor, offset = (_number(base.get(word), place) for word in ("factor", "offset"))
        powers = {
            base_unit: int(_number(base.get(base_unit), place) or 0.0)
            for base_unit in (*_BASES, "rad")
        }
        factor = 1.0 if factor is None else factor
        if factor == 0.0:
            raise DescriptionError("a unit of factor 0", where=place)
        units[name] = _Unit(factor, offset or 0.0, powers)
    return units


def _number(text: str | None, where: str) -> float | None:
    if text is None:
        return None
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise DescriptionError("not a number", where=where, found=text)
    return number


_unpacked: dict[tuple[str, State], Path] = {}


def unpack(component: FmuComponent) -> Path:
    """Unpack binary and resources of an FMU, once per file, into a folder that is removed when the process ends."""
    wanted = component.binary()
    key = str(component.path.resolve()), state_of(component.path)
    with turn(key):
        if key not in _unpacked:
            folder = lasting_folder()
            atexit.register(shutil.rmtree, folder, ignore_errors=True)
            _extract(component.path, folder, wanted.rpartition("/")[0] + "/")
            _unpacked[key] = folder
        return _unpacked[key]


def _extract(file: Path, folder: Path, binaries: str) -> None:
    (folder / "resources").mkdir()
    left = _MOST_BYTES
    with _refuse_damaged(file), zipfile.ZipFile(file) as archive:
        for name, info in _members(archive, str(file)).items():
            if not name.startswith((binaries, "resources/")):
                continue
            target = folder.joinpath(*name.split("/"))
            target.parent.mkdir(parents=True, exist_ok=True)
            with archive.open(info) as content, target.open("wb") as out:
                while piece := content.read(min(_CHUNK, left + 1)):
                    left -= len(piece)  # the sizes that an archive states may be wrong
                    if left < 0:
                        raise DescriptionError("too large for an FMU", where=str(file))
                    out.write(piece)
