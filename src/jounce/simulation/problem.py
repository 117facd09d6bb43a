"""Inputs of a model from a trial: the road under each wheel and the manoeuvre loads."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jounce.core.errors import SimulationError
from jounce.core.remembered import once_per_object
from jounce.core.segments import Segments, flat
from jounce.mechanics.facts import ROAD, ModelFacts, is_road
from jounce.parts import Rig
from jounce.parts.vehicles import Place, Vehicle
from jounce.roads import Flat, Trial
from jounce.roads.trial import LOADS, is_lasting

if TYPE_CHECKING:
    from jounce.control.actuators import ActiveActuator

_ONE_WHEEL = {"": Place(0.0, 1)}


def excitation(
    facts: ModelFacts, rig: Rig, trial: Trial, free: tuple[str, ...] = ()
) -> list[Segments]:
    """Return every track of a model against time (s), in the model's order.

    ``free`` are parameters by which a run is differentiated, or that vary under the same tracks. Trials with an input
    that the model ignores are refused, as are free parameters on which the tracks depend.
    """
    _refuse_unfelt(facts, rig, trial)
    (_lasting_ground if is_lasting(trial) else _refuse_unknown_ground)(trial)
    _refuse_shifts(rig, trial, free)
    wheels = rig.wheels if isinstance(rig, Vehicle) else _ONE_WHEEL
    tracks = []
    for track in facts.tracks:
        if is_road(track):
            place = wheels[track.removesuffix(ROAD).removesuffix(".")]
            tracks.append(
                trial.segments(place.behind, place.side).with_ramps(
                    _SHORTEST * max(1.0, trial.duration)
                )
            )
        elif track == COMMAND and trial.actuator_force is not None:
            tracks.append(trial.actuator_force.segments(trial.duration))
        else:
            tracks.append(trial.load(track) if track in LOADS else flat(trial.duration))
    return tracks


MOVES_TRACKS = ("front.distance", "rear.distance")
"""Parameters of a vehicle on which the tracks depend: they determine when the rear axle reaches the road."""

_SHORTEST = 1e-9  # share of a run: a thousand times the resolution of time
COMMAND = "command"  # the track of an actuator


def force_actuator(trial: Trial) -> ActiveActuator | None:
    """Return the actuator of a trial with a known force, which follows its command immediately; None without one."""
    if trial.actuator_force is None:
        return None
    from jounce.control.actuators import ActiveActuator

    return ActiveActuator(lag=0.0)


def _refuse_unknown_ground(trial: Trial) -> None:
    """Refuse a drive beyond the end of a road that ends at a different height: its continuation is unknown."""
    for name, road in (("road", trial.road), ("right", trial.right)):
        if road is not None and trial.speed is not None:
            road.check_covers(
                trial.speed * trial.duration, where=f"trial: {name}", continue_level=True
            )


_lasting_ground = once_per_object(_refuse_unknown_ground)


def _refuse_unfelt(facts: ModelFacts, rig: Rig, trial: Trial) -> None:
    for load in trial.loads:
        if load not in facts.tracks:
            missing = isinstance(rig, Vehicle) and (
                load == "deceleration" or any(wheel.side for wheel in _sides(rig))
            )
            hint = "Give body.height, the height of its centre of gravity." if missing else ""
            raise SimulationError(
                "the model has no such input",
                where=f"trial: {load}",
                allowed=", ".join(track for track in facts.tracks if not is_road(track))
                or "the road only",
                hint=hint,
            )
    if trial.actuator_force is not None and COMMAND not in facts.tracks:
        raise SimulationError(
            "the model has no actuator for a given force",
            where="trial: actuator_force",
            allowed="a single corner with a strut",
        )
    if trial.right is not None and not any(place.side for place in _sides(rig)):
        raise SimulationError(
            "a road under the right wheels is not supported",
            where="trial: right",
            found=getattr(rig, "model", ""),
            allowed="road only; right is for full cars",
        )


def _refuse_shifts(rig: Rig, trial: Trial, free: tuple[str, ...]) -> None:
    """Refuse derivatives by the wheelbase on a road: it also delays the rear axle."""
    shifting = [path for path in free if path in MOVES_TRACKS]
    if (
        not shifting
        or not isinstance(rig, Vehicle)
        or trial.road is None
        or isinstance(trial.road, Flat)
    ):
        return
    if any(place.behind for place in rig.wheels.values()):
        raise SimulationError(
            (
                "derivatives by the wheelbase are not available on a road: the wheelbase determines when "
                "the rear axle meets the road"
            ),
            where=f"parameters: {shifting[0]}",
            allowed="other parameters; this one only on a flat road, with an excitation over time, or without delay",
            hint="Use the difference of two runs.",
        )


def _sides(rig: Rig) -> list[Place]:
    return list(rig.wheels.values()) if isinstance(rig, Vehicle) else []
