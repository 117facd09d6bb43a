"""All that can be asked of a 3-D corner: hardpoints, joint reactions, energies, what is left open of the loops."""

from __future__ import annotations

import casadi as ca

from jounce.models.linkage import Linkage

_AXES = ("x", "y", "z")


def show_hardpoints(linkage: Linkage) -> None:
    """Let every hardpoint be seen, m, ground axes."""
    for name, body in linkage.owners.items():
        place = body.frame.point(linkage.hardpoint(name)).value
        for i, axis in enumerate(_AXES):
            linkage.mechanism.output(f"{name}.{axis}", place[i], "m", f"{name.replace('_', ' ')}, {axis}")


def show_reactions(linkage: Linkage) -> None:
    """Let force and torque of every joint on its second body be seen, N and N m, ground axes."""
    mechanism = linkage.mechanism
    for joint in (*mechanism.joints, *mechanism.closures):
        mechanism.watch_reaction(joint)


def show_bushings(linkage: Linkage) -> None:
    """Let the force of every bushing on the suspension be seen, N, ground axes."""
    for point, (force, _) in linkage.bushings.items():
        for i, axis in enumerate(_AXES):
            text = f"{point.replace('_', ' ')}, force of the bushing on the suspension along {axis}"
            linkage.mechanism.output(f"{point}.f{axis}", force[i], "N", text)


def show_energy(linkage: Linkage, elements: dict[str, tuple[ca.SX, ca.SX]], road_power: ca.SX) -> None:
    """Let energies be seen, J: kinetic, of weights, what each element has taken up and what the road has put in.

    ``elements`` holds force (N) and the rate (m/s) it works against.
    """
    mechanism = linkage.mechanism
    mechanism.watch_energy()
    powers = {name: (force * rate, f"energy taken up by the {name}") for name, (force, rate) in elements.items()}
    powers["road"] = road_power, "energy put in by the road"
    for name, (power, text) in powers.items():
        channel = f"energy.{name}"
        taken = mechanism.internal_state(channel)
        mechanism.set_internal_rate(channel, power)
        mechanism.output(channel, taken, "J", text)
