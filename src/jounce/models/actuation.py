"""A strut under control: an actuator in place of its damper or beside it."""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca

from jounce.control.actuators import ActiveActuator, AnyActuator, MagnetorheologicalDamper, SemiActiveDamper
from jounce.mechanics import System
from jounce.mechanics.elements import damper_force


def controlled_force(
    system: System,
    actuator: AnyActuator | None,
    deflection: ca.SX,
    velocity: ca.SX,
    passive: Callable[[], ca.SX],
) -> ca.SX:
    """Force (N, compression positive) of the damper of a strut and its actuator; adds ``command`` and what it shows.

    To be called within the place of the wheel; of the actuator only the structure matters. ``passive`` gives the force
    of the strut's own damper, and is called only where that damper is there.
    """
    if actuator is None:
        return passive()
    command = system.track("command").value
    system.output("command", command, actuator.unit, _COMMANDS[actuator.kind])
    if isinstance(actuator, ActiveActuator):
        force = _active(system, actuator, command)
        total = force if actuator.replaces_damper else passive() + force
    elif isinstance(actuator, SemiActiveDamper):
        force = total = _arrived(system, actuator.lag > 0.0, "actuator.coefficient", command) * velocity
    else:
        force = total = _magnetorheological(system, actuator, command, deflection, velocity)
    system.output("actuator.force", force, "N", "force of the actuator, compression positive")
    return total


_COMMANDS = {
    "semi-active": "commanded damping coefficient",
    "active": "commanded force, compression positive",
    "magnetorheological": "commanded voltage",
}


def _arrived(system: System, lags: bool, name: str, command: ca.SX) -> ca.SX:
    """A command behind a first-order lag, or at once."""
    if not lags:
        return command
    state = system.internal_state(name)
    system.set_internal_rate(name, (command - state) / system.parameter("actuator.lag"))
    return state


def _active(system: System, actuator: ActiveActuator, command: ca.SX) -> ca.SX:
    if actuator.bandwidth is None:
        return _arrived(system, actuator.lag > 0.0, "actuator.force", command)
    force, rate = system.internal_state("actuator.force"), system.internal_state("actuator.force rate")
    frequency = 2.0 * ca.pi * system.parameter("actuator.bandwidth")
    damping = 2.0 * system.parameter("actuator.damping_ratio") * frequency
    system.set_internal_rate("actuator.force", rate)
    system.set_internal_rate("actuator.force rate", frequency**2 * (command - force) - damping * rate)
    return force


def _magnetorheological(
    system: System, actuator: MagnetorheologicalDamper, command: ca.SX, deflection: ca.SX, velocity: ca.SX
) -> ca.SX:
    voltage = _arrived(system, actuator.lag > 0.0, "actuator.voltage", command)
    share = voltage / system.parameter("actuator.maximum")

    def number(name: str) -> ca.SX:
        off, on = (system.parameter(f"actuator.{end}.{name}") for end in ("off", "on"))
        return off + share * (on - off)

    return damper_force(system, actuator.off, "actuator", deflection, velocity, number)
