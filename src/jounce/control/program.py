"""A controller written out for all corners of a car: one function from measurements to commands."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import casadi as ca
import numpy as np

from jounce.control.actuators import Means, held_back
from jounce.control.controller import Controller
from jounce.control.design import CornerModel
from jounce.core.types import Array
from jounce.parts.rig import structure_of


@dataclass(frozen=True)
class Program:
    """The law of all corners as a graph, and the names of its numbers.

    Attributes
    ----------
    function : casadi.Function
        Of (memory, measurements and time, numbers, nothing); gives the commands, then the next memory.
    channels : tuple of str
        What is measured.
    numbers : tuple of str
        Names: those of the law, after the corner's name.
    memory : int
        Length of the memory; its last elements are the commands of the instant before.
    """

    function: ca.Function
    channels: tuple[str, ...]
    numbers: tuple[str, ...]
    memory: int


_programs: dict[tuple[object, ...], Program] = {}


def program(controller: Controller, corners: tuple[str, ...]) -> Program:
    """Write a controller out; controllers that differ in numbers only share one.

    Parameters
    ----------
    controller : Controller
        Resolved or not: only its structure matters.
    corners : tuple of str
        Places of the wheels; ``("",)`` for a quarter car.
    """
    key = (type(controller).__name__, structure_of(controller), corners)
    if key not in _programs:
        _programs[key] = _written(controller, corners)
    return _programs[key]


def _written(controller: Controller, corners: tuple[str, ...]) -> Program:
    channels: dict[str, ca.SX] = {}
    numbers: dict[str, ca.SX] = {}
    kept = [[ca.SX.sym(f"memory{i}") for i in range(controller.memory_size)] for _ in corners]
    last = [ca.SX.sym("last") for _ in corners]
    commands, memories = [], []
    for corner, own, before in zip(corners, kept, last, strict=True):
        seen, number = _asked(channels, corner), _asked(numbers, corner)
        means = Means(controller.actuator, seen, number, before)
        decision = controller.decide(seen, own, number, means)
        command = decision.command
        if controller.actuator.rate_limit is not None:
            command = held_back(command, before, number("rate_limit"))
        commands.append(command)
        memories.extend(decision.memory)
    memory = ca.vertcat(*(symbol for group in kept for symbol in group), *last)
    measured = ca.vertcat(*channels.values(), ca.SX.sym("t"))
    result = ca.densify(ca.vertcat(*commands, *memories, *commands))
    inputs = [memory, measured, ca.vertcat(*numbers.values()), ca.SX(0, 1)]
    function = ca.Function("control", inputs, [ca.cse(result)])
    return Program(function, tuple(channels), tuple(numbers), memory.shape[0])


def _asked(known: dict[str, ca.SX], corner: str) -> Callable[[str], ca.SX]:
    """Symbols by name, made when they are first asked for."""

    def symbol(name: str) -> ca.SX:
        full = f"{corner}.{name}" if corner else name
        return known.setdefault(full, ca.SX.sym(full))

    return symbol


def values(controllers: Mapping[str, Controller], models: Mapping[str, CornerModel], names: tuple[str, ...]) -> Array:
    """Numbers of a program.

    Parameters
    ----------
    controllers : mapping
        Corner to its controller, resolved for it.
    models : mapping
        Corner to what it is.
    names : tuple of str
        Of the program.
    """
    known: dict[str, float] = {}
    for corner, controller in controllers.items():
        prefix = f"{corner}." if corner else ""
        actuator = controller.actuator
        low, high = actuator.limits
        found = {**actuator.plant_numbers, **controller.numbers(models[corner]), "minimum": low, "maximum": high}
        found["static_deflection"] = models[corner].static_deflection
        if actuator.rate_limit is not None:
            found["rate_limit"] = actuator.rate_limit / controller.rate
        known |= {prefix + name: value for name, value in found.items()}
    return np.array([known[name] for name in names])


def sensor_noise(noise: Mapping[str, float], seed: int, channels: tuple[str, ...], instants: int) -> Array:
    """White noise of the sensors, shape (instants, channels), SI; no rows where there is none.

    Parameters
    ----------
    noise : mapping
        Standard deviation by channel without its corner, or with it.
    seed : int
        Of the noise.
    channels : tuple of str
        What is measured.
    instants : int
        Control instants of the run.
    """
    spread = np.array([noise.get(name, noise.get(_word(name), 0.0)) for name in channels])
    if not np.any(spread > 0.0):
        return np.zeros((0, len(channels)))
    return np.asarray(np.random.default_rng(seed).standard_normal((instants, len(channels))) * spread)


def _word(channel: str) -> str:
    """Channel without its corner: the last two words."""
    return re.sub(r"^.*?([^.]+\.[^.]+)$", r"\1", channel)
