"""A controller compiled for all corners of a car: one function from measurements to commands."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import casadi as ca
import numpy as np

from jounce.control.actuators import Instant, Lookup, clip
from jounce.control.controller import Controller
from jounce.control.design import CornerModel
from jounce.core.remembered import Recent
from jounce.core.types import Array
from jounce.parts.rig import structure_of


@dataclass(frozen=True)
class Program:
    """Law of all corners as a CasADi function, and the names of its parameters.

    Attributes
    ----------
    function : casadi.Function
        Function of (memory, measurements and time, parameters, empty) that returns commands, then the next memory.
    channels : tuple of str
        Measured channels.
    numbers : tuple of str
        Names of parameters, prefixed by the corner.
    memory : int
        Size of the memory; its last elements are the previous commands.
    """

    function: ca.Function
    channels: tuple[str, ...]
    numbers: tuple[str, ...]
    memory: int


_programs: Recent[Program] = Recent()


def program(controller: Controller, corners: tuple[str, ...]) -> Program:
    """Compile a controller for its corners (``("",)`` for a quarter car); cached by structure."""
    key = (type(controller), structure_of(controller), corners)
    return _programs.of(key, lambda: _write_program(controller, corners))


def _write_program(controller: Controller, corners: tuple[str, ...]) -> Program:
    channels: dict[str, ca.SX] = {}
    numbers: dict[str, ca.SX] = {}

    def symbols(known: dict[str, ca.SX], corner: str) -> Lookup:
        """Return a lookup that creates symbols at first use."""
        prefix = f"{corner}." if corner else ""
        return lambda name: known.setdefault(prefix + name, ca.SX.sym(prefix + name))

    memory_symbols = [
        [ca.SX.sym(f"memory{i}") for i in range(controller.memory_size)] for _ in corners
    ]
    last = [ca.SX.sym("last") for _ in corners]
    commands: list[ca.SX] = []
    memories: list[ca.SX] = []
    for corner, own, before in zip(corners, memory_symbols, last, strict=True):
        now = Instant(symbols(channels, corner), symbols(numbers, corner), before, own)
        decision = controller.decide(now)
        command = decision.command
        if controller.actuator.rate_limit is not None:
            step = now.number("rate_limit")
            command = clip(command, before - step, before + step)
        commands.append(command)
        memories.extend(decision.memory)
    memory = ca.vertcat(*(symbol for group in memory_symbols for symbol in group), *last)
    measured = ca.vertcat(*channels.values(), ca.SX.sym("t"))
    result = ca.densify(ca.vertcat(*commands, *memories, *commands))
    inputs = [memory, measured, ca.vertcat(*numbers.values()), ca.SX(0, 1)]
    function = ca.Function("control", inputs, [ca.cse(result)])
    return Program(function, tuple(channels), tuple(numbers), memory.shape[0])


def values(
    controllers: Mapping[str, Controller], models: Mapping[str, CornerModel], names: tuple[str, ...]
) -> Array:
    """Return the parameters of a program in the order of ``names``, SI, from resolved controllers and corner models."""
    known: dict[str, float] = {}
    for corner, controller in controllers.items():
        prefix = f"{corner}." if corner else ""
        actuator = controller.actuator
        low, high = actuator.limits
        own_numbers = {
            **actuator.plant_numbers,
            **controller.numbers(models[corner]),
            "minimum": low,
            "maximum": high,
        }
        own_numbers["static_deflection"] = models[corner].static_deflection
        if actuator.rate_limit is not None:
            own_numbers["rate_limit"] = actuator.rate_limit / controller.rate
        known |= {prefix + name: value for name, value in own_numbers.items()}
    return np.array([known[name] for name in names])


def sensor_noise(
    noise: Mapping[str, float], seed: int, channels: tuple[str, ...], instants: int
) -> Array:
    """Return white sensor noise, shape (instants, channels), SI; shape (0, channels) without noise.

    ``noise`` is the standard deviation by channel; a channel without its corner applies to every corner.
    """
    without_corner = (".".join(name.split(".")[-2:]) for name in channels)
    spread = np.array(
        [
            noise.get(name, noise.get(word, 0.0))
            for name, word in zip(channels, without_corner, strict=True)
        ]
    )
    if not np.any(spread > 0.0):
        return np.zeros((0, len(channels)))
    return np.asarray(
        np.random.default_rng(seed).standard_normal((instants, len(channels))) * spread
    )
