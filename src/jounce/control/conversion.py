"""What a law wishes, turned into the command of an actuator: clipped to what the actuator can do."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import casadi as ca

from jounce.control.actuators import ActiveActuator, AnyActuator, SemiActiveDamper
from jounce.parts.elements import TanhDamper

Lookup = Callable[[str], ca.SX]
"""Symbol of a channel or a number by its name."""
_TURN = 0.02  # m/s over which a hysteretic force is taken to turn over, where its state is not measured


@dataclass(frozen=True)
class Means:
    """An actuator as a law sees it at one instant.

    Attributes
    ----------
    actuator : SemiActiveDamper, ActiveActuator or MagnetorheologicalDamper
        Only its structure matters.
    seen : callable
        Channel of the corner to its symbol.
    number : callable
        Name of a number to its symbol: ``minimum``, ``maximum`` (N s/m, N or V), those of the actuator.
    last : casadi.SX
        Command of the instant before.
    """

    actuator: AnyActuator
    seen: Lookup
    number: Lookup
    last: ca.SX

    def command_for_force(self, force: ca.SX) -> ca.SX:
        """Command that comes nearest to a strut force (N, compression positive).

        A damper gives what it can: forces against its velocity only, within its bounds.
        """
        low, high = self.number("minimum"), self.number("maximum")
        if isinstance(self.actuator, ActiveActuator):
            return _clipped(force, low, high)
        velocity = self.seen("strut.velocity")
        if isinstance(self.actuator, SemiActiveDamper):
            resisting = force * velocity > 0.0
            wanted = force * velocity / ca.fmax(velocity * velocity, 1e-12)
            return ca.if_else(resisting, _clipped(wanted, low, high), low)
        off, on = self._law("off", velocity), self._law("on", velocity)
        share = (force - off) * (on - off) / ca.fmax((on - off) ** 2, 1e-12)
        return low + (high - low) * _clipped(share, 0.0, 1.0)

    def command_for_coefficient(self, coefficient: ca.SX) -> ca.SX:
        """Command that makes a strut's damping coefficient, N s/m."""
        if isinstance(self.actuator, SemiActiveDamper):
            return _clipped(coefficient, self.number("minimum"), self.number("maximum"))
        return self.command_for_force(coefficient * self.seen("strut.velocity"))

    def command_for_level(self, level: ca.SX) -> ca.SX:
        """Command between the softest (0) and the firmest (1) setting of a damper."""
        low, high = self.number("minimum"), self.number("maximum")
        return low + (high - low) * level

    def force_of(self, command: ca.SX) -> ca.SX:
        """Strut force (N) that a command makes at once, as far as it is known."""
        if isinstance(self.actuator, ActiveActuator):
            return command
        velocity = self.seen("strut.velocity")
        if isinstance(self.actuator, SemiActiveDamper):
            return command * velocity
        off, on = self._law("off", velocity), self._law("on", velocity)
        low, high = self.number("minimum"), self.number("maximum")
        return off + (on - off) * (command - low) / (high - low)

    def _law(self, end: str, velocity: ca.SX) -> ca.SX:
        """Force (N) of a magneto-rheological damper at one end of its voltage."""

        def number(name: str) -> ca.SX:
            return self.number(f"{end}.{name}")

        deflection = self.seen("strut.deflection") + self.number("static_deflection")
        linear = number("coefficient") * velocity + number("stiffness") * deflection + number("offset")
        if isinstance(getattr(self.actuator, end), TanhDamper):
            lagged = velocity + number("displacement_coupling") * deflection
            return linear + number("force") * ca.tanh(number("slope") * lagged)
        return linear + number("hysteretic_force") * ca.tanh(velocity / _TURN)


def held_back(command: ca.SX, last: ca.SX, step: ca.SX) -> ca.SX:
    """A command that changes by at most ``step`` from one instant to the next."""
    return _clipped(command, last - step, last + step)


def _clipped(x: ca.SX, low: ca.SX | float, high: ca.SX | float) -> ca.SX:
    return ca.fmin(ca.fmax(x, low), high)
