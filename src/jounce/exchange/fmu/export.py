"""A rig as a Functional Mock-up Unit."""

from __future__ import annotations

import hashlib
import io
import uuid
import zipfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np

from jounce.control.controller import CallbackController
from jounce.control.fmu.platforms import PLATFORMS, this_platform
from jounce.control.program import Program, program, values
from jounce.core.errors import OutputError, SimulationError
from jounce.core.findings import Finding
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.core.units import Unit
from jounce.core.writing import check_writable, working_folder, write_atomically
from jounce.exchange.fmu import build as native
from jounce.exchange.fmu.description import FILE, Head, build_description, description, page, terminals
from jounce.exchange.fmu.graphs import graphs_of, header, source
from jounce.exchange.fmu.reference import NOTE, reference
from jounce.exchange.fmu.variables import Variables, list_variables
from jounce.parts import Rig
from jounce.parts.rig import quantity_at
from jounce.simulation.compiled import compile_rig
from jounce.simulation.controlled import AnyControl, Loop, close_loop, command_names
from jounce.simulation.prepare import dead_band
from jounce.simulation.statics import find_equilibrium, state_scale

_MOTION = 0.01  # m, the motion whose size of each state is its nominal value
_BAND = 10.0  # how many times the band of our own events an importer is given: it locates events less sharply
_OLDEST = (1980, 1, 1, 0, 0, 0)  # the first day that archives know: the same file for the same rig
_NAME = "jounce"
_ICON = Path(__file__).parent / "icon" / "icon.png"


@dataclass(frozen=True)
class FmuExport(Plain):
    """What was written.

    Attributes
    ----------
    path : Path
        The FMU.
    version : int
        Of FMI, 2 or 3.
    platforms : tuple of str
        Platforms with a binary.
    compiler : str
        ``zig``, ``cc``, or empty where only the sources are in the file.
    inputs, outputs : tuple of str
        Names of the variables to connect.
    states, parameters, indicators : int
        Counts.
    findings : tuple of Finding
        What the importer must know.
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


def export_fmu(
    rig: Rig,
    path: Path | str,
    *,
    version: Literal[2, 3] = 3,
    platforms: Sequence[str] | None = None,
    control: AnyControl | None = None,
    adjoint: bool = True,
    force: bool = False,
) -> FmuExport:
    """Write a rig as an FMU for model exchange and co-simulation (FMI 2.0 or 3.0).

    The FMU holds the equations that :func:`jounce.simulate` integrates, as C and compiled. Its inputs are the heights
    of the roads (m, up) with their rates and the loads of driving; its outputs the channels; every number of the rig
    is a tunable parameter ``rig.<path>`` (SI). It starts in static equilibrium. The same rig gives the same bytes.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle.
    path : Path or str
        File to write, ``.fmu``.
    version : {2, 3}
        Of FMI.
    platforms : sequence of str, optional
        Platforms to compile for (see :data:`jounce.control.fmu.platforms.PLATFORMS`); this machine's by default. All
        but this machine's need the extra ``fmu``; none (``()``) gives the sources alone.
    control : Controller, str, Path or callable, optional
        Controls the struts, as in :func:`jounce.simulate`; it becomes a sampled part of the FMU.
    adjoint : bool
        Give adjoint derivatives, too (FMI 3.0): larger code.
    force : bool
        Overwrite an existing file.

    Returns
    -------
    FmuExport
        What was written, with findings.

    Raises
    ------
    OutputError
        When the file exists, when no compiler makes a platform that was asked for, and for names that collide.
    SimulationError
        When there is no equilibrium, and for a controller that is a Python function.

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
        raise OutputError("no such version of FMI", where="version", found=version, allowed="2, 3")
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
                hint="Install the extra fmu (pip install 'jounce[fmu]') to compile for every platform.",
            )
        text = "no compiler was found: the FMU holds sources only; compile on the target or install the extra fmu"
        findings.append(Finding(str(file), "warning", text))
        wanted = ()
    model = _Model(rig, control)
    findings += model.findings
    graphs = graphs_of(
        model.compiled.model, model.law.function if model.law else None, adjoint=adjoint and version == 3
    )
    variables = model.variables()
    code = source(graphs)
    whole = {"measured": model.measured, "command": model.command_tracks}
    shared = {name: (native.C / name).read_bytes() for name in sorted(_c_files(version))}
    digest = hashlib.sha256(b"".join(shared.values()))
    digest.update((code + header(graphs, "", model.numbers, whole, model.period) + str(variables)).encode())
    token = f"{{{uuid.UUID(bytes=digest.digest()[:16])}}}"
    head_text = header(graphs, token, model.numbers, whole, model.period)
    has_adjoint = "adjoint" in graphs.functions
    head = Head(model.name, f"Suspension model {model.name}", f"jounce {_version()}", token, has_adjoint, sources=True)
    files = {"modelDescription.xml": description(version, variables, head)}
    with working_folder() as folder:
        (folder / "model.c").write_text(code, encoding="utf-8")
        (folder / "model.h").write_text(head_text, encoding="utf-8")
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
    notes = _NOTES if not model.command_names else _NOTES + _CONTROL_NOTE.format(1.0 / model.period)
    try:
        files["extra/jounce/reference.csv"] = reference(rig, model.compiled.facts, control)
        notes += NOTE
    except SimulationError as error:  # it has an equilibrium, and is a model for whoever can run it
        text = f"no reference run is in the FMU: {error}"
        findings.append(Finding(str(file), "warning", text))
    files["documentation/index.html"] = page(variables, head, notes)
    write_atomically(file, _zipped(files), force=force)
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
    return [name for name in names if name.startswith(("core.", f"fmi{version}"))]


def _zipped(files: dict[str, bytes]) -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(zipfile.ZipInfo(name, _OLDEST), content, zipfile.ZIP_DEFLATED)
    return buffer.getvalue()


_NOTES = """<h2>How to connect it</h2>
<p>Connect the height of the road under each wheel (<code>road.z</code>, m, up) and its rate (<code>road.vz</code>).
A rate that nobody gives, or that stays zero, is taken from the values: in co-simulation from the last two
communication points, in model exchange from the last accepted step.</p>
<p>The FMU starts in static equilibrium under its inputs and parameters at the start; with
<code>settings.start_at_rest</code> off it starts from the states that are set. All values are SI; z is up,
deflections and forces are positive in compression.</p>
"""
_CONTROL_NOTE = "<p>The controller inside sees its channels and sets its commands {0:g} times a second.</p>\n"


class _Model:
    """A rig with what its FMU starts from."""

    def __init__(self, rig: Rig, control: AnyControl | None) -> None:
        self._rig = rig
        self.findings: list[Finding] = []
        loop = close_loop(rig, control)
        self.compiled = compile_rig(rig, actuator=loop.actuator if loop else None)
        self._parameters = {**rig.parameters(), **(loop.parameters(self.compiled) if loop else {})}
        self.command_names = command_names(loop.corners) if loop else ()
        facts = self.compiled.facts
        self.command_tracks = [facts.tracks.index(name) for name in self.command_names]
        commands = {}
        if loop:
            commands = {
                name: loop.controllers[corner].actuator.rest
                for corner, name in zip(loop.corners, self.command_names, strict=True)
            }
        self.law, gains = self._law(loop)
        self.period = 1.0 / loop.first.rate if loop else 1.0
        names = self.compiled.output_names
        self.measured = [_place(name, names) for name in self.law.channels] if self.law else []
        self.numbers = self._start(commands, gains)

    @property
    def name(self) -> str:
        """What the model is called: the rig's own name where it has one."""
        return str(getattr(self._rig, "name", "") or getattr(self._rig, "model", "") or type(self._rig).__name__)

    def _law(self, loop: Loop | None) -> tuple[Program | None, Array]:
        if loop is None:
            return None, np.zeros(0)
        if isinstance(loop.first, CallbackController):
            raise SimulationError(
                "a controller that runs in Python cannot be part of an FMU",
                where="control",
                found=loop.first.name,
                allowed="a law of jounce, such as skyhook or lqr; or export the rig alone and connect the law outside",
            )
        if loop.first.noise:
            text = "the FMU's controller measures without the noise of its sensors"
            self.findings.append(Finding("control: noise", "note", text))
        made = program(loop.first, loop.corners)
        return made, values(loop.controllers, loop.models, made.numbers)

    def _start(self, commands: dict[str, float], gains: Array) -> dict[str, Array]:
        compiled, law = self.compiled, self.law
        n_q, n_v = compiled.facts.counts
        p = compiled.parameter_values(self._parameters)
        u = compiled.inputs(commands)
        rest = find_equilibrium(compiled, p, u)
        scale = state_scale(rest, n_q, n_v, _MOTION)
        band = _BAND * dead_band(compiled, p, rest, scale, u)
        seen = compiled.evaluate("output", rest.x, u, p, rest.modes)[self.measured] if law else np.zeros(0)
        memory = np.zeros(law.memory if law else 0)
        if law:
            memory[len(memory) - len(commands) :] = list(commands.values())
        return {
            "x0": rest.x, "u0": u, "p0": p, "m0": rest.modes, "g0": gains, "memory0": memory, "rest0": seen,
            "scale": scale, "band": band,
        }  # fmt: skip

    def variables(self) -> Variables:
        """What an importer sees."""
        facts = self.compiled.facts
        quantities = {path: self._quantity(path) for path in facts.parameters}
        names = self.law.numbers if self.law else ()
        gains = dict(zip(names, map(float, self.numbers["g0"]), strict=True))
        start = {name: self.numbers[f"{name}0"] for name in "xup"}
        return list_variables(self.compiled.model, start, quantities, self.command_names, gains)

    def _quantity(self, path: str) -> Unit:
        """Unit and range of a number; those of an actuator that the rig does not have are not known."""
        return quantity_at(self._rig, path) if path in self._rig.parameters() else Unit("1")


def _place(channel: str, names: Sequence[str]) -> int:
    if channel not in names:
        raise SimulationError(
            "the law needs a channel that the model does not have",
            where="control",
            found=channel,
            allowed=", ".join(names),
        )
    return names.index(channel)
