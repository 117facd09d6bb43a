"""Reading of FMU descriptions of other tools, and unpacking with size limits."""

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
)  # bytes: limits so that no archive fills the disk
_BASES = ("kg", "m", "s", "A", "K", "mol", "cd")  # rad is ignored: FMUs may omit it
REALS = ("Real", "Float64", "Float32")
"""Types of real numbers."""
WHOLE = (
    "Boolean", "Integer", "Enumeration", "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64", "UInt64",
)  # fmt: skip
"""Types of whole numbers; a Boolean is 0 or 1."""
_CHUNK = 1 << 20  # bytes per read


@dataclass(frozen=True)
class FmuVariable(Plain):
    """One variable of an FMU.

    Attributes
    ----------
    name : str
        Name in the FMU.
    kind : str
        Type: ``Real``, ``Float64``, ``Boolean`` and so on.
    causality, variability : str
        As defined by FMI.
    unit : str
        Unit of the FMU's values, or empty.
    start : str
        Start value as written in the file, or empty.
    text : str
        Description.
    reference : int
        Value reference.
    dimensions : tuple of int
        Number of elements along each dimension of an array (FMI 3.0), for the start values of structural parameters;
        empty for a scalar.
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
        """Number of values."""
        return math.prod(self.dimensions)

    @property
    def shape(self) -> str:
        """Type with array dimensions, for messages."""
        return (
            f"{self.kind}[{', '.join(map(str, self.dimensions))}]" if self.dimensions else self.kind
        )

    @property
    def is_number(self) -> bool:
        """Whether its values are numbers: real, integer, enumeration or Boolean."""
        return self.is_whole or self.kind in REALS

    @property
    def is_whole(self) -> bool:
        """Whether its values are integers, enumerations or Booleans."""
        return self.kind in WHOLE


@dataclass(frozen=True)
class _Unit:
    """Conversion of a unit, ``si = factor * value + offset``, with its base powers, or None if the FMU omits them."""

    factor: float
    offset: float
    powers: Mapping[str, int] | None


@dataclass(frozen=True)
class FmuComponent(Plain):
    """Description of an FMU, read from its file.

    Attributes
    ----------
    path : Path
        The FMU.
    version : int
        Version of FMI, 2 or 3.
    name, tool : str
        Name of the model, and of the tool that generated it.
    inputs, outputs, parameters : tuple of FmuVariable
        Variables to connect, and parameters to set before a run.
    structural_parameters : tuple of FmuVariable
        Parameters that define array sizes; they keep their start values.
    platforms : tuple of str
        Platforms with a binary, as FMI 3.0 names them.
    can_step, can_be_integrated : bool
        Whether it supports co-simulation, and model exchange.
    findings : tuple of Finding
        Problems that prevent a run on this machine.
    token, identifier : str
        Instantiation token (GUID), and name of the binary.
    units : mapping
        SI conversions of the FMU's units.
    is_once : bool
        Whether a process can have only one instance.
    fixed_step : float or None
        Internal step, s, or None; the control period must be a multiple of it.
    needs_tool : bool
        Whether it requires its tool on the machine that runs it.

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
        """Return factor and offset from SI values in ``si`` to the FMU's unit: ``own = factor * value + offset``.

        A variable without a unit is in SI. Raises a DescriptionError for an incompatible unit.
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
                "the unit does not match",
                where=f"{self.path}: {variable.name}",
                found=variable.unit,
                allowed=Phrase("a unit that converts to {si}", si=si),
                hint="Connect it to a different channel.",
            )
        return 1.0 / unit.factor, -unit.offset / unit.factor

    def si_unit(self, variable: FmuVariable) -> str:
        """Return the SI unit of a variable, or ``"1"`` if the FMU does not define it."""
        unit = self.units.get(variable.unit)
        if unit is None or unit.powers is None:
            return variable.unit if is_unit(variable.unit) else "1"
        return "*".join(f"{base}^{power}" for base, power in unit.powers.items() if power) or "1"

    def binary(self) -> str:
        """Return the path of this machine's binary in the archive, or raise a DescriptionError if it cannot be run."""
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
    """Read the description of a Functional Mock-up Unit of any tool, without running it.

    Parameters
    ----------
    path : Path or str
        The ``.fmu`` file, FMI 2.0 or 3.0.

    Returns
    -------
    FmuComponent
        Inputs, outputs and parameters with units, platforms, and problems that prevent a run on this machine.

    Raises
    ------
    DescriptionError
        For a file that is not an FMU, a damaged archive, paths outside it, excessive sizes, or an unsupported version.

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
                "it contains no modelDescription.xml", where=str(file), allowed="an FMU"
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
    """Convert all archive errors to a DescriptionError; each compression method raises its own."""
    try:
        yield
    except DescriptionError:
        raise
    except (
        Exception
    ) as error:  # from lzma, bz2, zlib, struct, or for encrypted and unknown archives
        if isinstance(error, OSError) and error.errno in (
            errno.ENOSPC,
            errno.EDQUOT,
            errno.EROFS,
            errno.EACCES,
        ):
            raise  # an error of the disk that receives the files
        text = " ".join(str(error).split()) or type(error).__name__
        allowed = "an FMU (a ZIP file)"
        raise DescriptionError(
            Phrase("not a readable archive: {text}", text=text),
            where=str(file),
            allowed=allowed,
        ) from None


def _members(archive: zipfile.ZipFile, where: str) -> dict[str, zipfile.ZipInfo]:
    """Return the files of an archive by name; refuse links, paths outside it, and too many or too large files."""
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
            what = "a link in the archive" if is_link else "a path outside the archive"
            raise DescriptionError(
                what, where=where, found=name, allowed="plain files within the FMU"
            )
        if name in members:
            raise DescriptionError("the archive contains a file twice", where=where, found=name)
        members[name] = info
    return members


def _parse(text: bytes, where: str) -> ET.Element:
    try:
        return parse_xml(text)
    except (ET.ParseError, ValueError, LookupError) as error:
        raise DescriptionError(
            Phrase(
                "its modelDescription.xml is not valid XML of an FMU: {error}", error=str(error)
            ),
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
            "unsupported version of FMI",
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
    """Return the number of elements along a dimension: fixed, or the start value of its structural parameter."""
    said = dimension.get("start") or sizes.get(dimension.get("valueReference", ""), "")
    if not re.fullmatch("[0-9]{1,18}", said):
        raise DescriptionError(
            "an array without a size", where=where, found=said, allowed="a whole number"
        )
    return int(said)


def _start(typed: ET.Element) -> str:
    """Return the start value as written; strings of FMI 3.0 have it in a child element."""
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
            raise DescriptionError("a unit with a factor of 0", where=place)
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
                    left -= len(piece)  # sizes stated in an archive may be wrong
                    if left < 0:
                        raise DescriptionError("too large for an FMU", where=str(file))
                    out.write(piece)
