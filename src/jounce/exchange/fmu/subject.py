"""Content of FMUs: a rig, a rig on a tester, a controller or a mechanism, with start values."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Literal

import casadi as ca
import numpy as np

from jounce.control.controller import CallbackController
from jounce.control.program import Program, program, values
from jounce.core.errors import DescriptionError, SimulationError
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.core.units import Unit
from jounce.exchange.fmu.reference import Given, of_mechanism, of_rig, of_tester
from jounce.exchange.fmu.variables import Variables, list_variables
from jounce.mechanics import Mechanism, System, assemble
from jounce.parts import Rig
from jounce.parts.rig import quantity_at
from jounce.parts.testers import Tester
from jounce.parts.vehicles import FullCar, HalfCar4DOF, axle_of
from jounce.simulation.compiled import Compiled, compile_model, compile_rig
from jounce.simulation.controlled import AnyControl, ControlLoop, close_loop, command_names
from jounce.simulation.prepare import dead_band
from jounce.simulation.statics import find_equilibrium, state_scale
from jounce.testers.rig import rig_on_tester, tester_numbers

_MOTION = 0.01  # m, typical motion for the nominal values of the states
_BAND = 10.0  # event band relative to jounce's: importers locate events less accurately
_MECHANISM_BAND = 1e-12  # m, m/s: event band of switches of unknown scale
_NOTHING: dict[str, Array] = {"g0": np.zeros(0), "memory0": np.zeros(0), "rest0": np.zeros(0)}


@dataclass(frozen=True)
class Subject:
    """A model with the start values of its FMU.

    Attributes
    ----------
    name : str
        Name of the model.
    compiled : Compiled
        Equations of the model.
    numbers : dict
        Initial arrays of the C code.
    parameters : dict
        Name in the FMU by path of the parameter.
    quantities : dict
        Unit and range by path.
    reference : Given or None
        Function that computes the reference run.
    at_rest : bool
        Whether it starts in static equilibrium by default.
    law, period, measured, commands
        Built-in controller: function, control period (s), indices of the measured outputs, names of the inputs it sets.
    track_units : dict
        SI units of inputs that do not define their unit.
    sampled : bool
        Whether inputs are read only at control instants, without their rates.
    findings : list of Finding
        Notes for users of the FMU.
    """

    name: str
    compiled: Compiled
    numbers: dict[str, Array]
    parameters: dict[str, str]
    quantities: dict[str, Unit]
    reference: Given | None
    at_rest: bool = True
    law: Program | None = None
    period: float = 1.0
    measured: list[int] = field(default_factory=list)
    commands: tuple[str, ...] = ()
    track_units: dict[str, str] = field(default_factory=dict)
    sampled: bool = False
    findings: list[Finding] = field(default_factory=list)

    @property
    def command_tracks(self) -> list[int]:
        """Indices of the inputs that the controller sets."""
        return [self.compiled.facts.tracks.index(name) for name in self.commands]

    def variables(self) -> Variables:
        """List the variables of the FMU."""
        names = self.law.numbers if self.law else ()
        gains = dict(zip(names, map(float, self.numbers["g0"]), strict=True))
        start = {name: self.numbers[f"{name}0"] for name in "xup"}
        return list_variables(
            self.compiled.model,
            start,
            self.quantities,
            self.commands,
            gains,
            names=self.parameters,
            at_rest=self.at_rest,
            units=self.track_units,
            sampled=self.sampled,
        )


def subject_of(
    model: Rig | Mechanism,
    control: AnyControl | None = None,
    tester: Tester | None = None,
    axle: Literal["front", "rear"] = "front",
    *,
    controller_only: bool = False,
) -> Subject:
    """Return the content of an FMU; refuse incompatible options."""
    if isinstance(model, Mechanism):
        for word, given in (
            ("control", control),
            ("tester", tester),
            ("controller", controller_only or None),
        ):
            if given is not None:
                raise DescriptionError(
                    Phrase("a mechanism has no {word}", word=word),
                    where=word,
                    allowed="rigs and vehicles",
                )
        return _of_mechanism(model)
    if controller_only and (tester is not None or control is None):
        raise DescriptionError(
            "--controller-only needs a controller",
            where="control",
            allowed="a controller without a tester",
        )
    if controller_only:
        return _of_controller(model, control)
    if tester is None:
        return _of_rig(model, control)
    if control is not None:
        raise DescriptionError(
            "a rig on a tester is not controlled",
            where="control",
            allowed="a controller, or a tester",
        )
    return _on_tester(
        axle_of(model, axle) if isinstance(model, (FullCar, HalfCar4DOF)) else model, tester
    )


def _name(rig: Rig) -> str:
    return str(getattr(rig, "name", "") or getattr(rig, "model", "") or type(rig).__name__)


def _quantities(rig: Rig, paths: Sequence[str]) -> dict[str, Unit]:
    """Return units and ranges by path; parameters of an actuator are dimensionless."""
    known = rig.parameters()
    return {path: quantity_at(rig, path) if path in known else Unit("1") for path in paths}


def _of_rig(rig: Rig, control: AnyControl | None) -> Subject:
    loop = close_loop(rig, control)
    compiled = compile_rig(rig, actuator=loop.actuator if loop else None)
    findings: list[Finding] = []
    law, gains = _law(loop, findings)
    corners = loop.corners if loop else ()
    names = command_names(corners) if loop else ()
    rests = {
        name: loop.controllers[corner].actuator.rest
        for corner, name in zip(corners, names, strict=True)
        if loop
    }
    measured = [_place(name, compiled.output_names) for name in law.channels] if law else []
    p = compiled.parameter_values(
        {**rig.parameters(), **(loop.parameters(compiled) if loop else {})}
    )
    memory = np.zeros(law.memory if law else 0)
    if law:
        memory[len(memory) - len(rests) :] = list(rests.values())
    numbers = _at_rest(compiled, p, compiled.inputs(rests))
    measured_values = compiled.evaluate("output", numbers["x0"], numbers["u0"], p, numbers["m0"])[
        measured
    ]
    paths = compiled.facts.parameters
    return Subject(
        _name(rig), compiled, {**numbers, "g0": gains, "memory0": memory, "rest0": measured_values},
        {path: f"rig.{path}" for path in paths}, _quantities(rig, paths), partial(of_rig, rig, compiled.facts, control),
        law=law, period=1.0 / loop.first.rate if loop else 1.0, measured=measured, commands=names, findings=findings,
    )  # fmt: skip


def _of_controller(rig: Rig, control: AnyControl | None) -> Subject:
    """Return the controller of a rig alone: channels are inputs, commands are outputs, without continuous states."""
    loop = close_loop(rig, control)
    if loop is None:
        raise DescriptionError(
            "passive is not a controller",
            where="control",
            found="passive",
            allowed="a law",
        )
    findings: list[Finding] = []
    law, gains = _law(loop, findings)
    assert law is not None
    known = {
        output.name: output.unit
        for output in compile_rig(rig, actuator=loop.actuator).facts.outputs
    }
    names = command_names(loop.corners)
    system = System()
    system.point_mass(ca.SX(1.0), system.coordinate("idle"))  # equations need a state
    for channel in law.channels:
        _place(channel, tuple(known))
        system.output(channel, system.track(channel).value, known[channel], "")
    for name in names:
        system.track(name)
    compiled = compile_model(system.finish())
    rests = {
        name: loop.controllers[corner].actuator.rest
        for corner, name in zip(loop.corners, names, strict=True)
    }
    memory = np.zeros(law.memory)
    memory[len(memory) - len(rests) :] = list(rests.values())
    numbers = {
        "x0": np.zeros(2), "u0": compiled.inputs(rests), "p0": np.zeros(0), "m0": np.zeros(0), "scale": np.ones(2),
        "band": np.zeros(0), "g0": gains, "memory0": memory, "rest0": np.zeros(len(law.channels)),
    }  # fmt: skip
    units = {
        **{channel: known[channel] for channel in law.channels},
        **dict.fromkeys(names, loop.actuator.unit),
    }
    findings.append(finding("exchange.changes_from_rest", "inputs"))
    return Subject(
        f"{loop.first.name} for {_name(rig)}", compiled, numbers, {}, {}, None, at_rest=False, law=law,
        period=1.0 / loop.first.rate, measured=list(range(len(law.channels))), commands=names, track_units=units,
        sampled=True, findings=findings,
    )  # fmt: skip


def _on_tester(rig: Rig, tester: Tester) -> Subject:
    on = rig_on_tester(rig, tester)
    compiled, own = on.compiled, tester_numbers(tester)
    p = compiled.parameter_values({**rig.parameters(), **own})
    paths = compiled.facts.parameters
    quantities = _quantities(rig, paths)
    for path in own:
        where = path.removeprefix("tester.")
        known = (
            where in ("amplitude", "drive.motor.stall_torque")
            or getattr(tester, where, None) is not None
        )
        if path in quantities:
            quantities[path] = _TESTER.get(where) or (
                quantity_at(tester, where) if known else Unit("1")
            )
    numbers = {**_at_rest(compiled, p, compiled.inputs()), **_NOTHING}
    return Subject(
        f"{_name(rig)} on {tester.name or 'a tester'}", compiled, numbers,
        {path: path if path in own else f"rig.{path}" for path in paths}, quantities, partial(of_tester, on),
    )  # fmt: skip


_TESTER = {"amplitude": Unit("m", at_least=0.0)}
"""Units of tester parameters that are not fields of its description."""


def _of_mechanism(mechanism: Mechanism) -> Subject:
    """Return a mechanism in its design pose with closed loops; importers may request static equilibrium."""
    every = mechanism.with_values({})
    lacking = [name for name in mechanism.parameters if name not in every]
    if lacking:
        raise SimulationError(
            "some parameters have no value",
            where=", ".join(lacking),
            hint="Set them in the parts of the mechanism.",
        )
    model = mechanism.model("refuse", values=every, inputs=dict.fromkeys(mechanism.tracks, 0.0))
    p = np.array([every[name] for name in model.parameters])
    compiled = compile_model(model)
    u = compiled.inputs(0.0)
    x = assemble(model, p, u, None).x
    m = compiled.sides(x, u, compiled.extend(p))
    pace = np.abs(np.linalg.eigvals(compiled.evaluate("rate_x", x, u, p, m)))
    n_q, n_v = compiled.facts.counts
    scale = np.ones(len(x))
    scale[:n_q], scale[n_q : n_q + n_v] = (
        _MOTION,
        _MOTION * max(1.0, float(np.max(pace, initial=0.0))),
    )
    band = np.full(len(m), _BAND * _MECHANISM_BAND)
    numbers = {"x0": x, "u0": u, "p0": p, "m0": m, "scale": scale, "band": band}
    units = {path: Unit(mechanism.units.get(path, "1")) for path in model.parameters}
    return Subject(
        "mechanism", compiled, {**numbers, **_NOTHING}, {path: f"mechanism.{path}" for path in model.parameters}, units,
        partial(of_mechanism, mechanism), at_rest=False,
    )  # fmt: skip


def _at_rest(compiled: Compiled, p: Array, u: Array) -> dict[str, Array]:
    """Return start values of a model in equilibrium, the scale of its states and the bands of its switches."""
    rest = find_equilibrium(compiled, p, u)
    scale = state_scale(rest, *compiled.facts.counts, _MOTION)
    band = _BAND * dead_band(compiled, p, rest, scale, u)
    return {"x0": rest.x, "u0": u, "p0": p, "m0": rest.modes, "scale": scale, "band": band}


def _law(loop: ControlLoop | None, findings: list[Finding]) -> tuple[Program | None, Array]:
    if loop is None:
        return None, np.zeros(0)
    if isinstance(loop.first, CallbackController):
        raise SimulationError(
            "a controller without a formula (a Python function, a different FMU) cannot be part of an FMU",
            where="control",
            found=loop.first.name,
            allowed="a law of jounce, such as skyhook or lqr; or export the rig alone and connect the law outside",
        )
    if loop.first.noise:
        findings.append(finding("exchange.without_noise", "control: noise"))
    made = program(loop.first, loop.corners)
    return made, values(loop.controllers, loop.models, made.numbers)


def _place(channel: str, names: Sequence[str]) -> int:
    if channel not in names:
        raise SimulationError(
            "the law needs a channel that the model does not have",
            where="control",
            found=channel,
            allowed=", ".join(names),
        )
    return names.index(channel)
