"""A rig on a tester: native code, static equilibrium, runs with given exciter angles, linear response."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from jounce.core.errors import SimulationError
from jounce.core.segments import Segments, flat
from jounce.core.text import qualify
from jounce.core.types import Array
from jounce.kernel.engine import flatten
from jounce.mechanics.motions import constant
from jounce.parts.corners import Corner
from jounce.parts.rig import Rig, structure_of
from jounce.parts.testers import Tester
from jounce.parts.vehicles import FrontViewAxle, QuarterCar
from jounce.simulation.compiled import Compiled, compile_described
from jounce.simulation.prepare import PreparedRun, prepare, room
from jounce.simulation.result import Solution, samples_reached
from jounce.simulation.settings import RunSettings
from jounce.simulation.statics import Equilibrium, state_scale
from jounce.testers.model import ANGLE, MOTOR, PlateForm, tester_model

_LONGEST = 0.8  # rad of exciter rotation per step at a tolerance of 1e-5


@dataclass(frozen=True)
class TesterRig:
    """A compiled rig on a tester."""

    rig: Rig
    tester: Tester
    form: PlateForm  # design of the plates
    compiled: Compiled  # native code
    prepared: PreparedRun  # prepared run, used for its numbers only
    rest: Equilibrium  # static equilibrium with exciters at angle 0

    @property
    def places(self) -> tuple[str, ...]:
        """Names of the wheels: ``("",)``, or left and right of an axle."""
        return places_of(self.rig)

    @cached_property
    def static(self) -> dict[str, float]:
        """Values of all outputs at rest, SI."""
        rest, prepared = self.rest, self.prepared
        values = self.compiled.evaluate(
            "output", rest.x, prepared.still, prepared.problem.p, rest.modes
        )
        return dict(zip(self.compiled.output_names, map(float, values), strict=True))

    @cached_property
    def scale(self) -> Array:
        """Typical size of each state for motions of the plate's amplitude."""
        return state_scale(self.rest, *self.compiled.facts.counts, self.tester.amplitude)

    def static_load(self, place: str = "") -> float:
        """Return the contact force of a wheel at rest, N."""
        return self.static[channel(place, "tyre.force")]

    def run(
        self,
        angles: Mapping[str, Segments],
        times: Array,
        *,
        start: Mapping[str, float] | None = None,
        fastest: float = 0.0,
        tolerance: float = RunSettings.tolerance,
    ) -> Solution:
        """Simulate with given exciter angles (rad over s; motor share of free exciters), from rest or ``start``.

        Angles are keyed by wheel; other exciters are at rest at mean height. Output times are in s, states of ``start``
        in SI; ``fastest`` is the maximum rate of the angles, rad/s.
        """
        prepared, facts = self.prepared, self.compiled.facts
        signals = [angles.get(_place_of(track), constant(0.0)) for track in facts.tracks]
        pieces = flatten(signals)
        problem = prepared.problem
        x, modes = self.rest.x.copy(), self.rest.modes
        if start is not None:
            x = np.array([start.get(name, x[i]) for i, name in enumerate(facts.states)])
            inputs = np.zeros_like(prepared.still)
            inputs[:: facts.track_order] = [signal.evaluate(times[:1])[0][0] for signal in signals]
            sides = self.compiled.evaluate(
                "switch", x, inputs, problem.p, np.ones(len(facts.switches))
            )
            modes = (sides > 0.0).astype(float)
        longest = prepared.control.longest
        if fastest > 0.0:
            longest = min(
                longest,
                _LONGEST * (tolerance / RunSettings.tolerance) ** 0.125 * 2.0 * np.pi / fastest,
            )
        control = prepared.control._replace(
            scale=0.1 * self.scale,
            longest=longest,
            tolerance=prepared.control.tolerance * tolerance / RunSettings.tolerance,
        )
        problem = problem._replace(
            tracks=pieces, piece=pieces.first[:-1].copy(), m=modes.copy(), x0=x
        )
        solution = replace(
            prepared,
            problem=problem,
            control=control,
            modes=modes,
            out=room(self.compiled, times),
            exact=None,
        ).run()
        samples_reached(solution, facts, check=True)
        return solution


def rig_on_tester(
    rig: Rig, tester: Tester, free: tuple[str, ...] = (), *, blocked: bool = False
) -> TesterRig:
    """Compile a rig on a tester.

    The exciters of the wheels in ``free`` (``""``, ``"left"``, ``"right"``) are moved by their drive's inertia;
    ``blocked`` omits the springs of sprung plates, as on the road. Raises SimulationError for a rig that cannot be
    tested or has no equilibrium.
    """
    check_rig(rig)
    form = PlateForm(tester.kind == "sprung-plate" and not blocked, free)
    compiled = compile_described(
        ("tester", type(rig).__name__, structure_of(rig), form), lambda: tester_model(rig, form)
    )
    p = compiled.parameter_values({**rig.parameters(), **tester_numbers(tester)})
    still = [flat(1.0) for _ in compiled.facts.tracks]
    prepared = prepare(compiled, p, still, np.array([0.0, 1.0]), tolerance=RunSettings.tolerance)
    assert prepared.equilibrium is not None  # runs from equilibrium have one
    return TesterRig(rig, tester, form, compiled, prepared, prepared.equilibrium)


def tester_numbers(tester: Tester) -> dict[str, float]:
    """Return the parameters of a tester's model by path, SI."""
    drive = tester.drive
    motor = drive.motor if drive is not None else None
    return {
        "tester.amplitude": tester.amplitude,
        "tester.plate_mass": tester.plate_mass,
        "tester.plate_spring_rate": tester.plate_spring_rate or 0.0,
        "tester.plate_damping_coefficient": tester.plate_damping_coefficient or 0.0,
        "tester.drive.inertia": drive.inertia if drive else 0.0,
        "tester.drive.friction_torque": drive.friction_torque if drive else 0.0,
        "tester.drive.viscous_friction": drive.viscous_friction if drive else 0.0,
        "tester.drive.motor.stall_torque": motor.stall_torque if motor else 0.0,
        "tester.drive.motor.no_load_frequency": motor.no_load_frequency if motor else 1.0,
    }


def check_rig(rig: Rig) -> None:
    """Raise an error for a rig that cannot be placed on a tester."""
    if isinstance(rig, (QuarterCar, FrontViewAxle, Corner)):
        return
    raise SimulationError(
        "this rig cannot be placed on a tester",
        where="rig",
        found=getattr(rig, "model", type(rig).__name__),
        allowed="a quarter car, a 3-D corner, or one axle of a full-car or half-car-4dof",
        hint="Name the axle. A half car without unsprung masses has no tyres.",
    )


def places_of(rig: Rig) -> tuple[str, ...]:
    """Return the wheels of a rig on a tester: ``("",)``, or left and right of an axle."""
    return ("left", "right") if isinstance(rig, FrontViewAxle) else ("",)


def channel(place: str, name: str) -> str:
    """Return a channel name prefixed with its wheel."""
    return qualify(place, name)


def _place_of(track: str) -> str:
    return track.removesuffix(ANGLE).removesuffix(MOTOR).removesuffix(".")
