"""What is to be seen of a model: channels that many models have, named and described alike."""

from __future__ import annotations

import casadi as ca

from jounce.mechanics import System

TURNS = {"pitch": "nose down", "roll": "right side down"}
"""Angles of a body, and which way they count."""


def show_height(system: System, name: str, z: ca.SX, text: str, height: str = ", height") -> None:
    """Let a height be seen, with velocity and acceleration."""
    system.output(f"{name}.z", z, "m", f"{text}{height}")
    system.output(f"{name}.vz", system.rate_of(z), "m/s", f"{text}, vertical velocity")
    system.output(f"{name}.az", system.acceleration_of(z), "m/s^2", f"{text}, vertical acceleration")


def show_turn(system: System, turn: str, angle: ca.SX) -> None:
    """Let pitch or roll of the body be seen, with rate and acceleration."""
    system.output(f"body.{turn}", angle, "rad", f"body {turn}, {TURNS[turn]} positive")
    system.output(f"body.{turn}_rate", system.rate_of(angle), "rad/s", f"body {turn} rate")
    system.output(f"body.{turn}_acceleration", system.acceleration_of(angle), "rad/s^2", f"body {turn} acceleration")


def show_strut(
    system: System, deflection: ca.SX, velocity: ca.SX, force: ca.SX, what: str = "strut force", since: str = ""
) -> None:
    """Let a strut be seen; ``what`` its force is, and from where (``since``) its deflection counts."""
    system.output("strut.deflection", deflection, "m", f"strut deflection{since}, compression positive")
    system.output("strut.velocity", velocity, "m/s", "strut deflection rate, bump positive")
    system.output("strut.force", force, "N", f"{what}, compression positive")


def show_tyre(system: System, deflection: ca.SX, force: ca.SX, of: str = "") -> None:
    """Let a tyre be seen."""
    system.output("tyre.deflection", deflection, "m", "tyre deflection from undeformed, compression positive")
    system.output("tyre.force", force, "N", f"contact force{of}, compression positive")
