"""Export of a rig as a Functional Mock-up Unit."""

from __future__ import annotations

import hashlib
import io
import uuid
import zipfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, Literal

from jounce.control.fmu.platforms import PLATFORMS, this_platform
from jounce.core.errors import DescriptionError, OutputError, SimulationError, unknown
from jounce.core.findings import Finding, finding
from jounce.core.operation import Count, File, MadeBy, Mark, Switch, Texts, operation
from jounce.core.optional import how_to_install
from jounce.core.phrases import Phrase
from jounce.core.serialise import Plain
from jounce.core.writing import check_writable, working_folder, write_atomically
from jounce.exchange.fmu import build as native
from jounce.exchange.fmu.description import (
    FILE,
    Head,
    build_description,
    description,
    page,
    terminals,
)
from jounce.exchange.fmu.graphs import graphs_of, header, source
from jounce.exchange.fmu.reference import reference
from jounce.exchange.fmu.subject import subject_of
from jounce.mechanics import Mechanism
from jounce.parts import Rig, as_rig
from jounce.parts.testers import Tester, load_tester
from jounce.simulation.controlled import AnyControl

_OLDEST = (1980, 1, 1, 0, 0, 0)  # earliest date of ZIP archives: equal rigs produce equal files
_NAME = "jounce"
_ICON = Path(__file__).parent / "icon" / "icon.png"


@dataclass(frozen=True)
class FmuExport(Plain):
    """Result of an export.

    Attributes
    ----------
    path : Path
        The FMU written.
    version : int
        Version of FMI, 2 or 3.
    platforms : tuple of str
        Platforms with a binary.
    compiler : str
        ``zig``, ``cc``, or empty if the file contains only sources.
    inputs, outputs : tuple of str
        Names of the variables to connect.
    states, parameters, indicators : int
        Counts.
    findings : tuple of Finding
        Notes for users of the FMU.
    """

    path: Path
    version: int
    platforms: tuple[str, ...]
    compiler: str
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    states: int
    parameters: int
    indicators: int
    findings: tuple[Finding, ...]


_AXLES = ("front", "rear")


def check_fmu(
    *, sources_only: bool, platform: Any, axle: str | None, tester: str | None, **_others: Any
) -> None:
    """Refuse platforms together with ``sources_only``, and an axle without a tester."""
    if sources_only and platform:
        what = "--platform requires compilation, which --sources-only disables"
        raise DescriptionError(what, found=platform, hint="Omit one of them.")
    if axle is not None and axle not in _AXLES:
        raise unknown(axle, _AXLES, what="axle", where="--axle")
    if axle is not None and tester is None:
        raise DescriptionError(
            "--axle applies only to testers",
            where="--axle",
            found=axle,
            allowed="--axle with --tester",
        )


@operation(
    "export fmu",
    named={"changes": "set", "path": "out", "version": "fmi", "platforms": "platform"},
    faces={"axle": None},
    python_only=("adjoint",),
    echo={"rig": "rig", "control": "control", "tester": "tester", "out": "out"},
    check="jounce.exchange.fmu.export:check_fmu",
    page="jounce.report.exchange:fmu_page",
    title="{rig}",
    doing="writing the FMU",
    example="jounce export fmu kart-quarter-car --out kart.fmu",
)
def export_fmu(  # noqa: PLR0913 - each is an option of the command
    rig: Annotated[
        Rig | str | Path | Mechanism,
        MadeBy("jounce.parts.options:rig_of_options", "jounce.parts.options:rig_in_python"),
    ],
    path: Annotated[Path | str, File("File to write.", "CAR.fmu")],
    *,
    version: Annotated[Literal[2, 3], Count("Version of FMI: 2 or 3.")] = 3,
    platforms: Annotated[
        Sequence[str] | None,
        Texts(
            "Compile for x86_64-linux, aarch64-linux, x86_64-windows, x86_64-darwin or aarch64-darwin; repeatable. "
            "Default: this machine. Others need the extra fmu.",
            "PLATFORM",
        ),
    ] = None,
    sources_only: Annotated[bool, Switch("Do not compile: the FMU contains only C code.")] = False,
    control: Annotated[
        AnyControl | None,
        Mark("Controller to include: a name such as skyhook, or a file.", "CONTROL"),
    ] = None,
    tester: Annotated[
        Tester | Path | str | None,
        Mark("Put the rig on a shock absorber tester: a name such as eusama, or a file.", "TESTER"),
    ] = None,
    axle: Annotated[
        Literal["front", "rear"],
        Mark("Axle of a vehicle on the tester: front or rear. Default: front.", "AXLE"),
    ] = "front",
    controller_only: Annotated[
        bool, Switch("Write only the controller, tuned for the rig.")
    ] = False,
    adjoint: bool = True,
    force: Annotated[bool, Switch("Overwrite existing output.")] = False,
) -> FmuExport:
    """Write a rig or vehicle as a Functional Mock-up Unit: model exchange and co-simulation in one file.

    The FMU contains the equations that :func:`jounce.simulate` integrates, as C code and compiled. Its inputs are road
    heights (m, up) with their rates, and driving loads; its outputs are the channels. All parameters of the rig are
    tunable parameters ``rig.<path>`` (SI). It starts in static equilibrium. Equal rigs produce identical files.

    Parameters
    ----------
    rig : Rig, str, Path or Mechanism
        Rig or vehicle, its file or its name; or a mechanism with a value for each parameter (``mechanism.<path>``),
        which starts in its design pose.
    path : Path or str
        File to write, ``.fmu``.
    version : {2, 3}
        Version of FMI.
    platforms : sequence of str, optional
        Platforms to compile for (see :data:`jounce.control.fmu.platforms.PLATFORMS`); by default that of this
        machine. Other platforms need the extra ``fmu``. Without platforms (``()``), the FMU contains only sources.
    sources_only : bool
        Do not compile, as without platforms.
    control : Controller, str, Path or callable, optional
        Controller of the struts, as in :func:`jounce.simulate`; it becomes a sampled part of the FMU.
    tester : Tester, Path or str, optional
        Put the rig on a shock absorber tester. Inputs are exciter angles (rad) with their rates; parameters
        are ``tester.<name>``.
    axle : {"front", "rear"}
        Axle of a vehicle on the tester.
    controller_only : bool
        Write only ``control``, tuned for the rig. Inputs are its measured channels, as changes from static equilibrium;
        outputs are its commands.
    adjoint : bool
        Add adjoint derivatives (FMI 3.0); this makes the code larger.
    force : bool
        Overwrite an existing file.

    Returns
    -------
    FmuExport
        The file written, and findings.

    Raises
    ------
    OutputError
        If the file exists, if no compiler is available for a requested platform, or if names collide.
    SimulationError
        If there is no equilibrium, for a controller that is a Python function, or for a rig that no tester accepts.
    DescriptionError
        For a controller together with a mechanism or a tester.

    Examples
    --------
    >>> import tempfile
    >>> import jounce as jn
    >>> made = jn.export_fmu(jn.load("kart-quarter-car"), tempfile.mkdtemp() + "/kart.fmu", platforms=())
    >>> made.inputs
    ('road.z', 'road.vz')
    """
    file = check_writable(path, what="FMUs", suffixes=(".fmu",), force=force)
    if version not in (2, 3):
        raise OutputError("unknown FMI version", where="version", found=version, allowed="2, 3")
    rig = rig if isinstance(rig, Mechanism) else as_rig(rig)
    platforms = () if sources_only else platforms
    wanted = (this_platform(),) if platforms is None else tuple(dict.fromkeys(platforms))
    compiler = native.compiler_for(wanted)
    findings = []
    if wanted and compiler is None:
        if platforms is not None:
            raise OutputError(
                "no compiler for this platform",
                where="export",
                found=", ".join(wanted),
                allowed=this_platform(),
                hint=Phrase(
                    "Install the extra fmu ({how_to_install}) to compile for every platform.",
                    how_to_install=how_to_install("fmu"),
                ),
            )
        findings.append(finding("exchange.no_compiler", str(file)))
        wanted = ()
    model = subject_of(
        rig,
        control,
        load_tester(tester) if isinstance(tester, (str, Path)) else tester,
        axle,
        controller_only=controller_only,
    )
    findings += model.findings
    law = model.law.function if model.law else None
    graphs = graphs_of(model.compiled.model, law, adjoint=adjoint and version == 3)
    variables = model.variables()
    code = source(graphs)
    whole = {"measured": model.measured, "command": model.command_tracks}
    shared = {name: (native.C / name).read_bytes() for name in sorted(_c_files(version))}
    digest = hashlib.sha256(b"".join(shared.values()))
    digest.update(
        (
            code
            + header(graphs, "", model.numbers, whole, model.period, model.at_rest)
            + str(variables)
        ).encode()
    )
    token = f"{{{uuid.UUID(bytes=digest.digest()[:16])}}}"
    head_text = header(graphs, token, model.numbers, whole, model.period, model.at_rest)
    has_adjoint = "adjoint" in graphs.functions
    head = Head(
        model.name,
        f"Suspension model {model.name}",
        f"jounce {_version()}",
        token,
        has_adjoint,
        sources=True,
    )
    files = {"modelDescription.xml": description(version, variables, head)}
    with working_folder() as folder:
        (folder / "model.c").write_text(code, encoding="utf-8", newline="\n")
        (folder / "model.h").write_text(head_text, encoding="utf-8", newline="\n")
        for platform in wanted:
            assert compiler is not None
            target = PLATFORMS[platform]
            place = f"binaries/{platform if version == 3 else target.fmi2}/{FILE}{target.suffix}"
            files[place] = native.compile_library(folder, version, platform, compiler)
    files |= {f"sources/{name}": content for name, content in shared.items()}
    files |= {"sources/model.c": code.encode(), "sources/model.h": head_text.encode()}
    if version == 3:
        files["sources/buildDescription.xml"] = build_description()
        files["terminalsAndIcons/terminalsAndIcons.xml"] = terminals(variables)
        files["terminalsAndIcons/icon.png"] = _ICON.read_bytes()
    else:
        files["model.png"] = _ICON.read_bytes()
    notes = _LAW_NOTES if controller_only else _NOTES
    notes += _CONTROL_NOTE.format(1.0 / model.period) if model.commands else ""
    try:
        if model.reference is not None:
            files["extra/jounce/reference.csv"], note = reference(model.reference)
            notes += note
    except SimulationError as error:  # the FMU is still valid: other programs may simulate it
        findings.append(finding("exchange.no_reference_run", str(file), error=error))
    files["documentation/index.html"] = page(variables, head, notes)
    write_atomically(file, _zip_files(files), force=force)
    return FmuExport(
        file,
        version,
        wanted,
        compiler[0] if compiler and wanted else "",
        tuple(v.name for v in variables.everything if v.causality == "input"),
        tuple(v.name for v in variables.outputs),
        len(variables.derivatives),
        sum(v.causality == "parameter" for v in variables.everything),
        len(variables.indicators),
        tuple(findings),
    )


def _version() -> str:
    from importlib.metadata import version

    return version("jounce")


def _c_files(version: int) -> list[str]:
    names = [file.name for file in native.C.iterdir()]
    return [name for name in names if name.startswith(("core.", "pairs.", f"fmi{version}"))]


def _zip_files(files: dict[str, bytes]) -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(zipfile.ZipInfo(name, _OLDEST), content, zipfile.ZIP_DEFLATED)
    return buffer.getvalue()


_NOTES = """<h2>How to connect it</h2>
<p>Connect the height of the road under each wheel (<code>road.z</code>, m, up) and its rate (<code>road.vz</code>).
If a rate is not connected or stays zero, it is computed from the values: in co-simulation from the last two
communication points, in model exchange from the last accepted step.</p>
<p>The FMU starts in static equilibrium under its initial inputs and parameters; with
<code>settings.start_at_rest</code> off it starts from the given states. All values are SI; z is up,
deflections and forces are positive in compression.</p>
"""
_LAW_NOTES = """<h2>How to connect it</h2>
<p>Connect the measured channels, as changes from static equilibrium (SI; z is up, compression positive), and the
commands.</p>
"""
_CONTROL_NOTE = "<p>The built-in controller reads its channels and sets its commands {0:g} times per second.</p>\n"
