"""Controlled runs: a controller adapted to a rig, and its law in the loop."""

from __future__ import annotations

import struct
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from jounce.control.actuators import ActiveActuator, AnyActuator
from jounce.control.controller import (
    CallbackController,
    Controller,
    Regulator,
    RunSetting,
    as_controller,
)
from jounce.control.design import CornerModel
from jounce.control.laws import Passive
from jounce.control.program import Program, program, sensor_noise, values
from jounce.core.errors import JounceError, SimulationError
from jounce.core.findings import Finding
from jounce.core.phrases import Phrase
from jounce.core.remembered import Recent
from jounce.core.segments import Segments, flat
from jounce.core.text import qualify
from jounce.core.types import Array, Complex
from jounce.kernel.engine import Callback, Feedback, feedback
from jounce.kernel.native import Native, compile_functions
from jounce.parts import Rig
from jounce.simulation.balance import balanced_commands
from jounce.simulation.compiled import Compiled, compile_rig
from jounce.simulation.corner_models import corner_models
from jounce.simulation.linear_model import numbers_without_friction
from jounce.simulation.prepare import PreparedRun
from jounce.simulation.settings import MAX_STEPS
from jounce.simulation.statics import Equilibrium, find_equilibrium, for_small_motions

AnyControl = Controller | str | Path | Callable[..., Any]
_FAR, _AT_LEAST = (
    1e3,
    10.0,
)  # typical motions, and m or rad, beyond which a closed loop counts as diverged
_COMMAND = "command"
_HALVES = 12  # halvings of the period in search of a stable one: a factor of 4096
_NEARER, _DAMPED = (
    "give the rig's own element numbers nearer to it",
    "let the rig's own damper stay",
)
_GROWING = 1e-3  # 1/s: a slower growing pole counts as rounding (6 % in a minute)


@dataclass(frozen=True)
class ControlLoop:
    """A controller adapted to a rig.

    Attributes
    ----------
    controllers : dict
        Controller of each corner, with defaults of its actuator filled in.
    models : dict
        Quarter car of each corner, used to design gains.
    raised : list
        Time (s) and exception if a Python controller failed in the last run.
    regulators : list
        Regulators called in the last run by a Python controller.
    """

    controllers: dict[str, Controller]
    models: dict[str, CornerModel]
    raised: list[tuple[float, BaseException]] = field(default_factory=list)
    regulators: list[Regulator] = field(default_factory=list)

    @property
    def findings(self) -> list[Finding]:
        """Findings about the controller of the last run."""
        return [item for regulator in self.regulators for item in regulator.findings]

    @property
    def corners(self) -> tuple[str, ...]:
        """Names of the corners."""
        return tuple(self.controllers)

    @property
    def first(self) -> Controller:
        """The first controller; all have the same structure, rate and noise."""
        return next(iter(self.controllers.values()))

    @property
    def actuator(self) -> AnyActuator:
        """Actuator of the first corner."""
        return self.first.actuator

    def parameters(self, compiled: Compiled) -> dict[str, float]:
        """Return the model's actuator parameters by path; corners of an axle share theirs."""
        numbers = {}
        for path in compiled.facts.parameters:
            place, _, name = (
                path.rpartition("actuator.") if path.startswith("actuator.") else _split(path)
            )
            if name:
                corner = next(corner for corner in self.corners if corner.startswith(place))
                numbers[path] = self.controllers[corner].actuator.plant_numbers[name]
        return numbers

    @property
    def element(self) -> str | None:
        """The spring, stops or tyre whose force is computed by an external program; None without one."""
        return self.actuator.in_place_of if isinstance(self.actuator, ActiveActuator) else None

    def with_rest(
        self, compiled: Compiled, signals: Sequence[Segments], p: Array | None = None
    ) -> list[Segments]:
        """Return the signals of a run, with commands before the first control instant, at parameter values ``p``."""
        driven = list(signals)
        tracks = _tracks(compiled, self)
        for corner, track in zip(self.corners, tracks, strict=True):
            driven[track] = flat(
                float(driven[track].edges[-1]), self.controllers[corner].actuator.rest
            )
        if self.element is None or p is None:
            return driven
        for track, force in zip(tracks, _in_balance(self, compiled, p, driven), strict=True):
            driven[track] = flat(float(driven[track].edges[-1]), force)
        return driven

    def around(
        self, compiled: Compiled, prepared: PreparedRun, signals: Sequence[Segments]
    ) -> PreparedRun:
        """Add the law to a prepared run."""
        pieces = np.array(_tracks(compiled, self), dtype=np.int64)
        law = _Law(self.with_rates(prepared.equilibrium), compiled, prepared, signals, pieces)
        control = prepared.control._replace(scale=self._scale(compiled, prepared.control.scale))
        return replace(prepared, control=control, feedback=law.feedback, begin=law.start)

    def with_rates(self, rest: Equilibrium | None) -> ControlLoop:
        """Return the same loop; a missing control rate is derived from the rig at rest."""
        if rest is None:
            return self
        fastest = rest.fastest_oscillation
        return replace(
            self,
            controllers={
                corner: law.with_rate_for(fastest) for corner, law in self.controllers.items()
            },
        )

    def _scale(self, compiled: Compiled, scale: Array) -> Array:
        """Return typical sizes of the states; those of the actuators follow from their limits."""
        sizes = scale.copy()
        for i, name in enumerate(compiled.facts.states):
            place, _, word = name.rpartition("actuator.")
            if word in ("coefficient", "force", "voltage", "force rate"):
                corner = next(
                    corner for corner in self.corners if corner.startswith(place.removesuffix("."))
                )
                actuator = self.controllers[corner].actuator
                sizes[i] = 0.1 * max(map(abs, actuator.limits))
                if word == "force rate":
                    sizes[i] *= 2.0 * np.pi * getattr(actuator, "bandwidth")  # noqa: B009 - it has a bandwidth
        return sizes


def _split(path: str) -> tuple[str, str, str]:
    place, mark, name = path.partition(".actuator.")
    return (place.partition(".")[0], mark, name) if mark else ("", "", "")


def _command(corner: str) -> str:
    return qualify(corner, _COMMAND)


def _tracks(compiled: Compiled, loop: ControlLoop) -> list[int]:
    """Return the indices of the tracks of all commands."""
    tracks = compiled.facts.tracks
    if loop.element is not None and any(_command(corner) not in tracks for corner in loop.corners):
        raise SimulationError(
            Phrase(
                "the rig has no {element} that a force could replace",
                element=loop.element,
            ),
            where="control: actuator: in_place_of",
            allowed="a different rig, or a different element",
        )
    return [tracks.index(_command(corner)) for corner in loop.corners]


def _in_balance(
    loop: ControlLoop, compiled: Compiled, p: Array, signals: Sequence[Segments]
) -> Array:
    """Return the commands (N) at which an external element balances the rest of the rig."""
    tracks = zip(compiled.facts.tracks, signals, strict=True)
    still = compiled.inputs(
        {name: float(signal.evaluate(signal.edges[:1])[0][0]) for name, signal in tracks}
    )
    law = loop.with_rates(find_equilibrium(compiled, p, still))
    assert isinstance(law.first, CallbackController)
    setting = RunSetting(
        law.controllers, law.models, _units(compiled), 1, lambda _, times: np.zeros(len(times))
    )
    columns = np.array(_tracks(compiled, loop), dtype=np.int64) * compiled.facts.track_order
    return balanced_commands(
        law.first.regulator(setting), compiled, p, still, columns, law.first.place
    )[0]


def _units(compiled: Compiled) -> dict[str, str]:
    return {output.name: output.unit for output in compiled.facts.outputs}


def close_loop(rig: Rig, control: AnyControl | None) -> ControlLoop | None:
    """Adapt a controller (an object, name, file or Python function) to a rig or vehicle.

    Return None without a controller and for the passive rig (``Passive()``). Refuse unknown controllers and those that
    do not suit the rig's corners.
    """
    controller = None if control is None else as_controller(control)
    if controller is None or (
        isinstance(controller, Passive) and controller.damping_coefficient is None
    ):
        return None
    models = corner_models(rig)
    if controller.needs_wheel and any(model.unsprung_mass <= 0.0 for model in models.values()):
        raise SimulationError(
            Phrase("the law {name!r} needs wheels with mass and tyre", name=controller.name),
            where="control",
            found=f"massless axles ({type(rig).__name__})",
            allowed="skyhook, pid and others that only need the body, or a model with wheels",
        )
    return ControlLoop(
        {corner: controller.complete_for(model) for corner, model in models.items()}, models
    )


class _Law:
    """The control law in the form that the engine calls."""

    def __init__(
        self,
        loop: ControlLoop,
        compiled: Compiled,
        prepared: PreparedRun,
        signals: Sequence[Segments],
        tracks: NDArray[np.int64],
    ) -> None:
        self._loop, self._compiled, self._prepared, self._signals = (
            loop,
            compiled,
            prepared,
            signals,
        )
        self._rest_commands = prepared.still[tracks * compiled.facts.track_order]
        self._begin: list[Callable[[], None]] = []
        pieces = prepared.problem.tracks.first[tracks]
        first, times = loop.first, prepared.out.times
        duration = float(times[-1] - times[0])
        if first.rate * duration > MAX_STEPS:
            raise SimulationError(
                "too many control instants",
                where="control: rate",
                found=f"{first.rate:g} Hz for {duration:g} s",
                allowed=Phrase("at most {max_steps} instants per run", max_steps=MAX_STEPS),
                hint="Lower the control rate or shorten the run.",
            )
        self._instants = int(np.ceil((times[-1] - times[0]) * first.rate - 1e-9)) + 1
        self._pieces = pieces
        self.feedback = self._python() if isinstance(first, CallbackController) else self._native()

    def start(self) -> None:
        """Begin a run: set the commands to those at rest and clear the memory."""
        control = self.feedback
        control.instants[0] = 0
        control.memory[:] = 0.0
        if control.memory.shape[1]:
            control.memory[0, -len(self._rest_commands) :] = self._rest_commands
        self._prepared.problem.tracks.coefficients[self._pieces, 0] = self._rest_commands
        for begin in self._begin:
            begin()

    @cached_property
    def _rest_outputs(self) -> Array:
        prepared = self._prepared
        if prepared.equilibrium is None:
            raise AssertionError("a controlled run must start from rest")
        where = (
            prepared.equilibrium.x,
            prepared.still,
            prepared.problem.p,
            prepared.equilibrium.modes,
        )
        return self._compiled.evaluate("output", *where)

    def _around(
        self, law: int, channels: tuple[str, ...], p: Array, memory: int, *, from_rest: bool
    ) -> Feedback:
        prepared, first = self._prepared, self._loop.first
        names, n_q = self._compiled.output_names, self._compiled.facts.counts[0]
        missing = [name for name in channels if name not in names]
        if missing:
            raise SimulationError(
                Phrase(
                    "the law {name!r} needs a channel that the model does not have", name=first.name
                ),
                where="control",
                found=", ".join(missing),
                allowed="a law that needs other channels, or a model with separate wheels",
            )
        select = np.array([names.index(name) for name in channels], dtype=np.int64)
        bound = np.full(self._compiled.state_count, np.inf)
        bound[:n_q] = np.maximum(10.0 * _FAR * prepared.control.scale[:n_q], _AT_LEAST)
        for channel in first.noise:
            if not any(name == channel or name.endswith(f".{channel}") for name in names):
                raise SimulationError(
                    "noise is given for a channel that the model does not have",
                    where="control: noise",
                    found=channel,
                    allowed=", ".join(names),
                )
        return feedback(
            law,
            1.0 / first.rate,
            pieces=self._pieces,
            select=select,
            offset=self._rest_outputs[select] if from_rest else np.zeros(len(select)),
            noise=sensor_noise(first.noise, first.seed, channels, self._instants),
            bound=bound,
            p=p,
            counts=(memory, prepared.problem.inputs, len(names)),
        )

    def _native(self) -> Feedback:
        loop = self._loop
        law = program(loop.first, loop.corners)
        address = _compiled_law(law.function).address["control"]
        p = values(loop.controllers, loop.models, law.numbers)
        return self._around(address, law.channels, p, law.memory, from_rest=True)

    def _python(self) -> Feedback:
        loop, first = self._loop, self._loop.first
        assert isinstance(first, CallbackController)
        setting = RunSetting(
            loop.controllers, loop.models, _units(self._compiled), self._instants, self._road
        )
        regulator = first.regulator(setting)
        loop.regulators[:] = [regulator]
        feedback: list[Feedback] = []

        def call() -> None:
            put(result, 0, *regulator(measured()))

        def fail() -> None:
            feedback[0].result[:] = np.nan
            loop.raised[:] = (
                [(float(feedback[0].measured[-1]), callback.raised)] if callback.raised else []
            )

        callback = Callback(call, fail)
        memory = np.zeros(1)
        feedback.append(
            self._around(
                callback.address, regulator.channels, memory, 0, from_rest=regulator.from_rest
            )
        )
        result, measured = feedback[0].result.ravel().data, feedback[0].measured.tolist
        put = struct.Struct(f"{len(result)}d").pack_into
        self._begin += [regulator.start, loop.raised.clear]
        self._callback = callback
        return feedback[0]

    def _road(self, corner: str, times: Array) -> Array:
        """Return the height (m) of the road under a wheel, constant after the run."""
        track = qualify(corner, "road.z")
        signal = self._signals[self._compiled.facts.tracks.index(track)]
        return signal.evaluate(np.minimum(times, signal.edges[-1]))[0]


_laws: Recent[tuple[object, Native]] = Recent()


def _compiled_law(function: Any) -> Native:
    """Return the native code of a law; the cache keeps the law alive to prevent reuse of its address."""
    return _laws.of(id(function), lambda: (function, compile_functions({"control": function})))[1]


def raise_controller_error(loop: ControlLoop) -> None:
    """Raise the exception of a Python controller in a run as a single error with its time."""
    if not loop.raised:
        return
    t, error = loop.raised[0]
    if isinstance(error, JounceError) or not isinstance(error, Exception):
        raise error
    what = f"the controller raised {type(error).__name__}: {error}"
    raise SimulationError(what, where=f"control function at t = {t:.6g} s") from error


def command_names(corners: Sequence[str]) -> tuple[str, ...]:
    """Return the command channels of corners."""
    return tuple(_command(corner) for corner in corners)


def closed_loop_poles(rig: Rig, control: AnyControl) -> Complex:
    """Compute the poles of a rig with a linear law, at the control instants, about static equilibrium.

    Sampling and holding by the law are exact; limits of the actuator and dry friction are ignored.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle.
    control : Controller, str or Path
        A linear law with an active actuator.

    Returns
    -------
    ndarray of complex
        1/s, by descending real part; a positive real part means growth. Poles beyond half the control rate are aliased.

    Raises
    ------
    SimulationError
        For a law with a damper (it can only dissipate), or one that is not linear.

    Examples
    --------
    >>> from jounce.parts import load
    >>> bool(closed_loop_poles(load("audi-a6-quarter-car"), "active-skyhook")[0].real < 0.0)
    True
    """
    loop = close_loop(rig, control)
    if loop is None or not is_linear(loop):
        raise SimulationError(
            "not a linear law with an active actuator",
            where="control",
            found="none" if loop is None else f"{loop.first.name}, {loop.actuator.kind}",
            allowed="active-skyhook, pid, lqr, lqg, h-infinity with an active actuator",
        )
    compiled = compile_rig(rig, actuator=loop.actuator)
    p = compiled.parameter_values({**numbers_without_friction(rig), **loop.parameters(compiled)})
    still = compiled.inputs(0.0)
    return poles(loop, compiled, p, find_equilibrium(compiled, p, still), still)


def is_linear(loop: ControlLoop) -> bool:
    """Whether the law is a formula with a force actuator: apart from limits, such a loop is linear."""
    return isinstance(loop.actuator, ActiveActuator) and not isinstance(
        loop.first, CallbackController
    )


def poles(
    loop: ControlLoop, compiled: Compiled, p: Array, rest: Equilibrium, still: Array
) -> Complex:
    """Compute the poles (1/s) of a loop at rest, by descending real part; ``still`` are the inputs."""
    law = program(loop.first, loop.corners)
    slopes = _slopes(law, values(loop.controllers, loop.models, law.numbers))
    return _sampled_poles(
        loop, compiled, p, rest, still, law.channels, slopes, 1.0 / loop.first.rate
    )


def _sampled_poles(
    loop: ControlLoop,
    compiled: Compiled,
    p: Array,
    rest: Equilibrium,
    still: Array,
    channels: tuple[str, ...],
    slopes: tuple[Array, Array],
    period: float,
) -> Complex:
    """Compute the poles of a loop with a sampled law from its period and (commands, memory) slopes."""
    from scipy.linalg import expm

    facts, names = compiled.facts, compiled.output_names
    columns = [facts.tracks.index(name) * facts.track_order for name in command_names(loop.corners)]
    rows = [names.index(name) for name in channels]
    rest = for_small_motions(compiled, rest, p, still)
    where = (rest.x, still, p, rest.modes)
    along = compiled.slopes("u", *where)
    B, D = (rest.pick @ along["rate"])[:, columns], along["output"][np.ix_(rows, columns)]
    C = compiled.slopes("x", *where)["output"][rows] @ rest.lift
    n, m = B.shape
    augmented = np.zeros((n + m, n + m))
    augmented[:n, :n], augmented[:n, n:] = rest.reduced, B
    F, H = np.split(expm(augmented * period)[:n], [n], axis=1)
    by_memory, by_channels = slopes
    u_x, u_memory, u_u = by_channels[:m] @ C, by_memory[:m], by_channels[:m] @ D
    next_x, next_memory, next_u = by_channels[m:] @ C, by_memory[m:], by_channels[m:] @ D
    transition = np.block(
        [[F + H @ u_x, H @ u_memory, H @ u_u], [next_x, next_memory, next_u], [u_x, u_memory, u_u]]
    )
    rates = np.log(np.linalg.eigvals(transition).astype(complex) + 1e-300) / period
    return np.asarray(rates[np.argsort(-rates.real)])


def _slopes(law: Program, p: Array) -> tuple[Array, Array]:
    """Return slopes of (commands, next memory) by memory and measurements, at rest."""
    function = law.function
    memory, measured, numbers, nothing = (
        ca.SX.sym(f"i{i}", function.size1_in(i)) for i in range(function.n_in())
    )
    result = function(memory, measured, numbers, nothing)
    slopes = [ca.jacobian(result, memory), ca.jacobian(result, measured)]
    evaluate = ca.Function(
        "slopes", [memory, measured, numbers], [ca.densify(part) for part in slopes]
    )
    by_memory, by_channels = evaluate(
        np.zeros(function.size1_in(0)), np.zeros(function.size1_in(1)), p
    )
    return np.asarray(by_memory), np.asarray(by_channels)[:, :-1]  # the last input is the time


def check_stable(
    loop: ControlLoop, compiled: Compiled, p: Array, rest: Equilibrium, still: Array
) -> None:
    """Refuse a linear loop with a growing pole; arguments as for :func:`poles`."""
    if not is_linear(loop):
        return
    worst = poles(loop, compiled, p, rest, still)[0]
    if worst.real > _GROWING:
        raise SimulationError(
            "the closed loop is unstable: small motions grow",
            where=f"control: {loop.first.name}",
            found=f"a pole at {worst.real:.3g} 1/s, {abs(worst.imag) / (2.0 * np.pi):.3g} Hz",
            hint="Use smaller gains, a faster actuator or a higher control rate (check=False runs it anyway).",
        )


def check_coupling(loop: ControlLoop, compiled: Compiled, p: Array, prepared: PreparedRun) -> None:
    """Refuse an FMU whose force is held so long that small motions grow; arguments as for :func:`poles`."""
    rest, regulator = prepared.equilibrium, next(iter(loop.regulators), None)
    if regulator is None or rest is None or not isinstance(loop.actuator, ActiveActuator):
        return
    outputs = compiled.evaluate("output", rest.x, prepared.still, p, rest.modes)
    slopes = regulator.answer(outputs[prepared.feedback.select] - prepared.feedback.offset)
    if slopes is None or not all(np.all(np.isfinite(part)) for part in slopes):
        return

    def worst(period: float) -> complex:
        where = (loop, compiled, p, rest, prepared.still, regulator.channels, slopes, period)
        return complex(_sampled_poles(*where)[0])

    period = prepared.feedback.period
    pole = worst(period)
    if pole.real <= _GROWING:
        return
    finer = next(
        (period / 2**i for i in range(1, _HALVES) if worst(period / 2**i).real <= _GROWING), None
    )
    growing = f"{1.0 / period:.6g} Hz, at which {abs(pole.imag) / (2.0 * np.pi):.3g} Hz grow with {pole.real:.3g} 1/s"
    if finer is not None:
        raise SimulationError(
            "the coupling is unstable: a force held for a whole period feeds small motions",
            where="control: rate",
            found=growing,
            allowed=Phrase("{finer:.6g} Hz or more", finer=1.0 / finer),
            hint=f"Or {_NEARER if loop.element else _DAMPED} (check=False runs it all the same).",
        )
    raise SimulationError(
        "the closed loop is unstable: small motions grow at any rate",
        where=f"control: {loop.first.name}",
        found=growing,
        hint="Check the signs: forces are positive in compression (check=False runs the FMU anyway).",
    )
