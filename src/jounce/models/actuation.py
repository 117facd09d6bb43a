"""A controlled corner: an actuator that replaces or assists its damper, or a force that replaces another element."""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca

from jounce.control.actuators import (
    OWN,
    RATE,
    ActiveActuator,
    AnyActuator,
    MagnetorheologicalDamper,
    Replaced,
    SemiActiveDamper,
)
from jounce.mechanics import System
from jounce.mechanics.elements import damper_force


def controlled_force(
    system: System,
    actuator: AnyActuator | None,
    deflection: ca.SX,
    velocity: ca.SX,
    passive: Callable[[], ca.SX],
) -> ca.SX:
    """Return the force (N, compression positive) of a strut's damper and actuator; add ``command`` and its outputs.

    Call it within the prefix of the wheel. Only the structure of the actuator matters. ``passive`` returns the force of
    the strut's own damper, and is called only if that damper remains.
    """
    if actuator is None or (isinstance(actuator, ActiveActuator) and actuator.in_place_of):
        return passive()
    command = system.track("command").value
    system.output("command", command, actuator.unit, _COMMANDS[actuator.kind])
    if isinstance(actuator, ActiveActuator):
        force = _active(system, actuator, command)
        total = force if actuator.replaces_damper else passive() + force
    elif isinstance(actuator, SemiActiveDamper):
        force = total = (
            _lagged_command(system, actuator.lag > 0.0, "actuator.coefficient", command) * velocity
        )
    else:
        force = total = _magnetorheological(system, actuator, command, deflection, velocity)
    system.output("actuator.force", force, "N", "force of the actuator, compression positive")
    return total


def element_force(
    system: System,
    actuator: AnyActuator | None,
    what: Replaced,
    own: ca.SX,
    rate: ca.SX,
    acting: ca.SX | float = 1.0,
) -> ca.SX:
    """Return the force (N, compression positive) of an element, plus the command if an actuator replaces it.

    The command is the difference between the replacing force and the ``own`` force. The latter thus bridges the time
    until the next command and gives statics and events a stiffness. ``rate`` is that of the deflection (m/s);
    ``acting`` is 1 while the element's own law applies, 0 while it is out of contact.
    """
    if not isinstance(actuator, ActiveActuator) or actuator.in_place_of != what:
        return own
    command = system.track("command").value
    system.output(
        "command",
        command,
        actuator.unit,
        f"force in place of the {what}, less that of the rig's own",
    )
    system.output(
        f"actuator.{OWN}", acting * own, "N", f"force of the rig's own {what}, compression positive"
    )
    system.output(
        f"actuator.{RATE}", rate, "m/s", f"deflection rate of the {what}, compression positive"
    )
    if what != "tyre":  # its force is ``tyre.force``, with lift-off
        system.output(
            "actuator.force",
            own + command,
            "N",
            f"force in place of the {what}, compression positive",
        )
    return own + command


def replaced_tyre(
    system: System, actuator: AnyActuator | None, rate: ca.SX
) -> Callable[[ca.SX, ca.SX], ca.SX] | None:
    """:func:`element_force` for a tyre, in the form of ``tyre_force``; None if the tyre keeps its own force."""
    if not isinstance(actuator, ActiveActuator) or actuator.in_place_of != "tyre":
        return None
    return lambda own, acting: element_force(system, actuator, "tyre", own, rate, acting)


_COMMANDS = {
    "semi-active": "commanded damping coefficient",
    "active": "commanded force, compression positive",
    "magnetorheological": "commanded voltage",
}


def _lagged_command(system: System, lags: bool, name: str, command: ca.SX) -> ca.SX:
    """Return a command after a first-order lag, or without delay."""
    if not lags:
        return command
    state = system.internal_state(name)
    system.set_internal_rate(name, (command - state) / system.parameter("actuator.lag"))
    return state


def _active(system: System, actuator: ActiveActuator, command: ca.SX) -> ca.SX:
    if actuator.bandwidth is None:
        return _lagged_command(system, actuator.lag > 0.0, "actuator.force", command)
    force, rate = (
        system.internal_state("actuator.force"),
        system.internal_state("actuator.force rate"),
    )
    frequency = 2.0 * ca.pi * system.parameter("actuator.bandwidth")
    damping = 2.0 * system.parameter("actuator.damping_ratio") * frequency
    system.set_internal_rate("actuator.force", rate)
    system.set_internal_rate(
        "actuator.force rate", frequency**2 * (command - force) - damping * rate
    )
    return force


def _magnetorheological(
    system: System,
    actuator: MagnetorheologicalDamper,
    command: ca.SX,
    deflection: ca.SX,
    velocity: ca.SX,
) -> ca.SX:
    voltage = _lagged_command(system, actuator.lag > 0.0, "actuator.voltage", command)
    share = voltage / system.parameter("actuator.maximum")

    def number(name: str) -> ca.SX:
        off, on = (system.parameter(f"actuator.{end}.{name}") for end in ("off", "on"))
        return off + share * (on - off)

    return damper_force(system, actuator.off, "actuator", deflection, velocity, number)
