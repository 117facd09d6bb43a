"""Channels of models: those shared by many models, and the optional ones of a 3-D corner."""

from __future__ import annotations

import casadi as ca

from jounce.mechanics import Mechanism, System
from jounce.models.linkage import Linkage

TURNS = {"pitch": "nose down", "roll": "right side down"}
"""Angles of a body and their sign conventions."""


def show_height(system: System, name: str, z: ca.SX, text: str, height: str = ", height") -> None:
    """Add channels of a height, with velocity and acceleration."""
    system.output(f"{name}.z", z, "m", f"{text}{height}")
    system.output(f"{name}.vz", system.rate_of(z), "m/s", f"{text}, vertical velocity")
    system.output(
        f"{name}.az", system.acceleration_of(z), "m/s^2", f"{text}, vertical acceleration"
    )


def show_turn(system: System, turn: str, angle: ca.SX) -> None:
    """Add channels of the body's pitch or roll, with rate and acceleration."""
    system.output(f"body.{turn}", angle, "rad", f"body {turn}, {TURNS[turn]} positive")
    system.output(f"body.{turn}_rate", system.rate_of(angle), "rad/s", f"body {turn} rate")
    system.output(
        f"body.{turn}_acceleration",
        system.acceleration_of(angle),
        "rad/s^2",
        f"body {turn} acceleration",
    )


def show_strut(
    system: System,
    deflection: ca.SX,
    velocity: ca.SX,
    force: ca.SX,
    what: str = "strut force",
    since: str = "",
) -> None:
    """Add the channels of a strut; ``what`` describes its force, ``since`` the zero of its deflection."""
    system.output(
        "strut.deflection", deflection, "m", f"strut deflection{since}, compression positive"
    )
    system.output("strut.velocity", velocity, "m/s", "strut deflection rate, bump positive")
    system.output("strut.force", force, "N", f"{what}, compression positive")


def show_tyre(system: System, deflection: ca.SX, force: ca.SX, of: str = "") -> None:
    """Add channels of a tyre."""
    system.output(
        "tyre.deflection", deflection, "m", "tyre deflection from undeformed, compression positive"
    )
    system.output("tyre.force", force, "N", f"contact force{of}, compression positive")


def show_hardpoints(linkage: Linkage) -> None:
    """Add channels of every hardpoint, m, ground axes."""
    for name, body in linkage.owners.items():
        place = body.frame.point(linkage.hardpoint(name)).value
        show_point(linkage.mechanism, name, linkage.carrier.place(place))


def show_point(system: System, name: str, place: ca.SX) -> None:
    """Add channels of a point, m, ground axes."""
    for i, axis in enumerate("xyz"):
        system.output(f"{name}.{axis}", place[i], "m", f"{name.replace('_', ' ')}, {axis}")


def show_reactions(mechanism: Mechanism) -> None:
    """Add channels of every joint's force and torque on its second body, N and N m, ground axes."""
    for joint in (*mechanism.joints, *mechanism.closures):
        mechanism.watch_reaction(joint)


def show_bushings(linkage: Linkage) -> None:
    """Add channels of the force of every bushing on the suspension, N, ground axes."""
    for point, (force, _) in linkage.bushings.items():
        along = linkage.carrier.outward(force)
        for i, axis in enumerate("xyz"):
            text = f"{point.replace('_', ' ')}, force of the bushing on the suspension along {axis}"
            linkage.mechanism.output(f"{point}.f{axis}", along[i], "N", text)


def show_energy(
    linkage: Linkage, elements: dict[str, tuple[ca.SX, ca.SX]], road_power: ca.SX
) -> None:
    """Add energy channels, J: kinetic, of weights, stored or dissipated by each element, and supplied by the road.

    ``elements`` maps each element to its force (N) and rate (m/s).
    """
    mechanism = linkage.mechanism
    mechanism.watch_energy()
    powers = {
        name: (force * rate, f"energy absorbed by the {name}")
        for name, (force, rate) in elements.items()
    }
    powers["road"] = road_power, "energy supplied by the road"
    for name, (power, text) in powers.items():
        channel = f"energy.{name}"
        taken = mechanism.internal_state(channel)
        mechanism.set_internal_rate(channel, power)
        mechanism.output(channel, taken, "J", text)
