"""A 3-D corner with one coordinate: with a fixed rack and ideal joints, a suspension has only wheel travel.

Forces, masses and channels then depend on the wheel's travel alone. :func:`sampled_corner` computes them for driven
poses; :func:`reduced_corner` is the corner with polynomials of travel in their place. The equations are exact for these
functions: with the body's height z and the travel s, the suspension has the kinetic energy
1/2 M z'^2 + P(s) z' s' + 1/2 m(s) s'^2, and every force acts along a length that is one of these functions.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import casadi as ca

from jounce.mechanics import Model, System
from jounce.mechanics.driven import DrivenMechanism, Quasistatic
from jounce.mechanics.facts import HALF, MIDDLE, of_travel
from jounce.models.attachments import contact_point, tyre_law, undeformed_radius
from jounce.models.channels import show_tyre
from jounce.models.corner import (
    add_both_alike,
    add_torsion_bar,
    build_linkage,
    show_motions,
    show_wheel,
    strut_forces,
)
from jounce.models.linkage import (
    DescribedSuspension,
    ElementLength,
    Linkage,
    Reached,
    hang_on_guide,
)
from jounce.parts.corners import Corner

MASS, MOMENTUM, INERTIA = "mass", "momentum", "inertia"
"""Mass of the suspension, and its upward momentum (kg) and twice its energy (kg) at unit travel rate."""


@dataclass(frozen=True)
class SampledCorner:
    """Functions of (q, u, p, m) of a corner whose travel, height of the body and rack are driven.

    ``pose`` is for ``kernel.poses``, ``output`` returns the quantities ``names``; ``tracks`` are the inputs u, ``p``
    the values of ``parameters``; ``start`` is the design pose. ``tangent`` returns a function for the slopes of all
    quantities along a change of tracks and parameters, which is passed after the coordinates; the pose follows it.
    """

    pose: ca.Function
    output: ca.Function
    names: tuple[str, ...]
    tracks: tuple[str, ...]
    parameters: tuple[str, ...]
    start: tuple[float, ...]
    tangent: Callable[[], ca.Function]


@dataclass
class Watched(Linkage):
    """A linkage that records the requested quantities of its pose."""

    seen: dict[str, ca.SX] = field(default_factory=dict)

    def of_pose(self, name: str, formula: Callable[[Linkage], ca.SX]) -> ca.SX:
        """Return a quantity of the pose by its formula."""
        self.seen[name] = formula(self)
        return self.seen[name]


def sampled_corner(rig: Corner) -> SampledCorner:
    """Return the pose quantities of a reduced corner; the values in ``rig`` matter only through its structure."""
    mechanism = Quasistatic(gravity=ca.SX(0.0))
    travel, heave = mechanism.track("travel"), mechanism.track("heave")
    rack = mechanism.track("rack") if getattr(rig, "steering", None) is not None else None
    linkage = build_linkage(
        rig, mechanism, hang_on_guide(mechanism, "vertical"), rack=rack, kind=Watched
    )
    height = mechanism.coordinate_named("sprung.distance")
    mechanism.condition("heave", height - heave.value)
    centre = linkage.wheel_centre
    rise = centre.value[2] - linkage.number("hardpoints.wheel_centre[2]")
    mechanism.condition("wheel_travel", rise - height - travel.value)
    driven = DrivenMechanism(mechanism, [travel, heave] if rack is None else [travel, heave, rack])
    _see(linkage)
    along = driven.along(0)
    v = driven.statics.v
    matrix = sum(
        (inertia.matrix(v) for inertia in mechanism.complete().collection.inertias), ca.SX(*v.shape)
    )
    travel_rate, height_rate = along(v), driven.along(1)(v)
    masses = {
        MASS: height_rate.T @ matrix @ height_rate,
        MOMENTUM: height_rate.T @ matrix @ travel_rate,
        INERTIA: travel_rate.T @ matrix @ travel_rate,
    }
    body = linkage.number("sprung.mass")  # not part of the suspension
    quantities = {
        **{name: ca.substitute(mass, body, 0.0) for name, mass in masses.items()},
        **linkage.seen,
    }
    return sampling_functions(mechanism, driven, quantities)


def sampling_functions(
    mechanism: Quasistatic, driven: DrivenMechanism, quantities: dict[str, ca.SX]
) -> SampledCorner:
    """Create the functions that sample quantities of a driven pose at unit travel rate."""
    output = driven.along(0)(ca.vertcat(*quantities.values()))
    made = {"pose": driven.pose(), "output": output}
    used = {symbol.name() for symbol in ca.symvar(ca.vertcat(*made.values()))}
    parameters = {
        path: symbol for path, symbol in mechanism.parameter_symbols().items() if path in used
    }
    arguments = [
        driven.statics.q,
        ca.vertcat(*(track.value for track in driven.tracks)),
        ca.vertcat(*parameters.values()),
        ca.SX.sym("m", 1),
    ]
    functions = {
        name: ca.Function(name, arguments, [ca.cse(ca.densify(part))])
        for name, part in made.items()
    }

    def tangent() -> ca.Function:
        numbers = ca.vertcat(*arguments[1:3])
        change = ca.SX.sym("change", numbers.shape[0])
        slopes = ca.cse(ca.densify(driven.follow(output, numbers, change)))
        return ca.Function("tangent", [ca.vertcat(arguments[0], change), *arguments[1:]], [slopes])

    tracks = tuple(track.value.name() for track in driven.tracks)
    named = tuple(quantities), tracks, tuple(parameters), tuple(driven.statics.start)
    return SampledCorner(functions["pose"], functions["output"], *named, tangent)


def _see(linkage: Watched) -> None:
    """Request all quantities that the reduced corner needs."""
    linkage.line("spring")
    if linkage.damper_stands_apart:
        linkage.line("damper")
    add_torsion_bar(linkage)
    add_both_alike(linkage)
    show_wheel(linkage)
    if linkage.rig.tyre.law == "radial":
        _lean(linkage)


def _lean(linkage: DescribedSuspension) -> ca.SX:
    """Return the cosine of the wheel's inclination."""
    return linkage.of_pose("tyre.upright", lambda whole: contact_point(whole, ca.SX(0.0))[1])


@dataclass
class _Tabulated(DescribedSuspension):
    """A suspension described completely by polynomials of its travel ``x`` (from -1 to 1)."""

    rig: Corner
    mechanism: System
    x: ca.SX
    degree: int

    def of_pose(self, name: str, formula: Callable[[Linkage], ca.SX]) -> ca.SX:  # noqa: ARG002 - it has no pose
        """Return the polynomial, with separate sums of even and odd powers that can be computed in parallel."""
        given = [self.number(path) for path in of_travel(name, self.degree)]
        square = self.x * self.x
        even, odd = (ca.SX(0.0), ca.SX(0.0))
        for number in reversed(given[::2]):
            even = even * square + number
        for number in reversed(given[1::2]):
            odd = odd * square + number
        return even + self.x * odd

    def press(self, reached: Reached, force: ca.SX) -> None:
        """Apply a force (N, N m) that increases a quantity."""
        self.mechanism.force(reached.value(self), force)

    def quantity(self, name: str) -> ca.SX:
        """Return a quantity that is not a formula of the pose alone."""
        return self.of_pose(name, lambda whole: whole.wheel_centre.value)

    def stretch(self, element: str) -> ElementLength:
        """Return the length of the spring or the damper."""
        length = self.quantity(f"{element if self.damper_stands_apart else 'spring'}.length")
        return ElementLength(length, self.mechanism.rate_of(length), self.design_length(element))


@dataclass(frozen=True)
class HangingMass:
    """A suspension with one coordinate, its travel, on a body that moves along z: rates and masses (see above)."""

    rates: ca.SX
    mass: ca.SX
    momentum: ca.SX
    inertia: ca.SX
    momentum_rate: ca.SX
    inertia_rate: ca.SX

    def matrix(self, v: ca.SX) -> ca.SX:
        """Mass matrix."""
        jacobian = ca.jacobian(self.rates, v)
        rows = (ca.horzcat(self.mass, self.momentum), ca.horzcat(self.momentum, self.inertia))
        return jacobian.T @ ca.vertcat(*rows) @ jacobian

    def bias(self, v: ca.SX) -> ca.SX:
        """Return the inertial force at constant travel rate, due to the curved paths of all masses."""
        travelling = self.rates[1]
        bent = ca.vertcat(self.momentum_rate * travelling, 0.5 * self.inertia_rate * travelling)
        return ca.jacobian(self.rates, v).T @ bent


def reduced_corner(rig: Corner, degree: int) -> Model:
    """Write the equations of a corner with polynomials of travel of a degree; channels are those of the full corner."""
    system = System()
    gravity, number = system.parameter("gravity"), system.parameter
    road = system.track("road.z")
    heave = ca.SX(0.0) if rig.guide == "fixed" else system.coordinate("sprung.z")
    centre = system.coordinate("unsprung.z")
    rising, travel = system.rate_of(heave), centre - heave
    travelling = system.rate_of(travel)
    linkage = _Tabulated(rig, system, (travel - number(MIDDLE)) / number(HALF), degree)
    system.output("road.z", road.value, "m", "road height under the wheel")
    _hang(linkage, gravity, rising, travelling)
    if rig.guide != "fixed":
        system.point_mass(number("sprung.mass"), heave)
        system.force(heave, -number("sprung.mass") * gravity)
    spring, damper = linkage.stretch("spring"), linkage.stretch("damper")
    for line, force in zip((spring, damper), strut_forces(linkage, spring, damper), strict=True):
        system.load(line.rate, force)
    add_torsion_bar(linkage)
    add_both_alike(linkage)
    upright = _lean(linkage) if rig.tyre.law == "radial" else ca.SX(1.0)
    deflection = (
        undeformed_radius(linkage)
        - (number("hardpoints.wheel_centre[2]") + centre - road.value) / upright
    )
    rate = system.rate_of(deflection)
    force = tyre_law(linkage, deflection, rate)
    system.load(-rate, force)
    show_tyre(system, deflection, force / upright)
    show_motions(linkage, centre, heave)
    return system.finish()


def _hang(linkage: _Tabulated, gravity: ca.SX, rising: ca.SX, travelling: ca.SX) -> None:
    """Add the masses of the suspension and their weights to the body."""
    system = linkage.mechanism
    mass, momentum, inertia = (
        system.parameter(of_travel(MASS, 0)[0]),
        *map(linkage.quantity, (MOMENTUM, INERTIA)),
    )
    rates = ca.vertcat(rising, travelling)
    system.inertia(
        HangingMass(
            rates, mass, momentum, inertia, system.rate_of(momentum), system.rate_of(inertia)
        )
    )
    system.load(mass * rising + momentum * travelling, -gravity)
