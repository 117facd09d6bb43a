"""Rides over roads by name: a vehicle driven with controllers, and controllers compared."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any

from jounce.control import CONTROLS
from jounce.core.errors import DescriptionError
from jounce.core.operation import Count, File, Number, Switch, Texts, operation
from jounce.core.trust import trusting
from jounce.parts import Rig, as_rig
from jounce.parts.options import AnyRig
from jounce.ride.study import (
    DEFAULT_DURATION,
    AnyControl,
    Progress,
    RideStudy,
    RideTrial,
    all_controls,
    compare_rides,
    iso_trial,
    road_trial,
)
from jounce.roads import load_road
from jounce.roads.loading import class_and_seed, is_class

COMPARED_DURATION = "20 s"
_TO_THE_END = (
    "otherwise until the rear axle reaches the end of the road, the front axle being a wheelbase beyond it, or until "
    "the front axle reaches it if the road ends at another height than it begins."
)
ROAD = File(
    "A class of ISO 8608 (iso:A to iso:H), a road file, or a name of `jounce library`.",
    shipped=("roads",),
)
SPEED = Number('Speed over the road, e.g. "20 m/s".', "SPEED", "m/s", is_positive=True)
SEED = Count("Seed of the random road.", least=0)
TRUST = Switch(
    "Run FMUs of controllers in the process of the run: faster, and a crash ends all of it."
)
_OPTIONS: dict[str, Any] = {
    "named": {"rig": "vehicle", "changes": "set", "controls": "control"},
    "echo": {"vehicle": "vehicle", "changes": "set", "road": "road", "seed": "seed"},
    "page": "jounce.report:ride_page",
    "doing": "driving",
}


def check_single_recording(out: Path | None, control: Sequence[str] | None, **_: object) -> None:
    """Raise an error for a single output file if several rides are requested."""
    names = named_controls(control or ["passive"])
    if out is not None and len(names) > 1:
        listed = ", ".join(map(str, names))
        raise DescriptionError(
            "a file can hold only one run",
            where="--out",
            found=listed,
            allowed="a single --control with --out",
        )


@operation(
    "ride",
    **_OPTIONS,
    offers=("recording", "figure", "report"),
    check="jounce.ride.drives:check_single_recording",
    figure="jounce.plots.design:study_spectra",
    title="{vehicle}{result.driven} on {road} at {result.at_speed}",
    example='jounce ride audi-a6-full-car --road iso:C --speed "20 m/s" --control skyhook',
)
def ride_road(
    rig: AnyRig,
    road: Annotated[str, ROAD],
    speed: Annotated[float | str, SPEED],
    *,
    controls: Annotated[
        Sequence[AnyControl] | None,
        Texts(
            "A controller (see `jounce compare --help`), its file, or all; passive by default. Repeat it.",
            "CONTROL",
        ),
    ] = None,
    duration: Annotated[
        float | str | None,
        Number(
            f"Time over the road; by default 60 s on ISO roads, {_TO_THE_END}",
            "TIME",
            "s",
            is_positive=True,
        ),
    ] = None,
    seed: Annotated[int, SEED] = 0,
    trust: Annotated[bool, TRUST] = False,
    progress: Progress = lambda _: None,
) -> RideStudy:
    """Drive a vehicle over a rough road: ride metrics and, on ISO roads, those of the linear model.

    Parameters
    ----------
    rig : Rig, str or Path
        Rig or vehicle, its file or its name in the library.
    road : str
        A class of ISO 8608 (``"iso:C"``, with a seed ``"iso:C:7"``), a road file, or its name in the library.
    speed : float or str
        m/s.
    controls : sequence of Controller, str, Path or callable, optional
        Controllers as for :func:`jounce.compare_rides`; ``"all"`` selects all built-in ones. Passive by default.
    duration : float or str, optional
        Time over the road, s; by default 60 s on ISO roads, otherwise until the last axle reaches the road's end.
    seed : int
        Seed of the random road, 0 or more.
    trust : bool
        Whether FMUs of controllers run in this process: faster, and a crash ends all of it.
    progress : callable
        Receives a message for each ride.

    Returns
    -------
    RideStudy
        Rides, and the reasons of those that failed.

    Raises
    ------
    DescriptionError
        For unknown roads and controllers, two different seeds, and numbers out of range.

    Examples
    --------
    >>> study = ride_road("audi-a6-quarter-car", "iso:B", "20 m/s", duration="5 s")
    >>> study.rides[0].control, 0.2 < study.rides[0].merits["comfort"] < 0.8
    ('passive', True)
    """
    rig = as_rig(rig)
    names = named_controls(controls or ["passive"])
    with trusting(trust):
        return compare_rides(
            rig, trial_over(rig, road, speed, duration, seed), names, progress=progress
        )


@operation(
    "compare",
    **_OPTIONS,
    faces={"speed": "20 m/s"},
    offers=("figure", "report"),
    title="{vehicle} on {road} at {result.at_speed}",
    example="jounce compare audi-a6-half-car-4dof --control all --figure trade-off.png",
)
def compare_controllers(
    rig: AnyRig,
    controls: Annotated[
        Sequence[AnyControl] | None,
        Texts(f"all, or controllers by name or file: {', '.join(CONTROLS)}. Repeat it.", "CONTROL"),
    ] = None,
    *,
    road: Annotated[str, ROAD] = "iso:C",
    speed: Annotated[float | str, SPEED] = 20.0,
    duration: Annotated[
        float | str | None,
        Number(
            f"Time over the road; by default 20 s on ISO roads, {_TO_THE_END}",
            "TIME",
            "s",
            is_positive=True,
        ),
    ] = None,
    seed: Annotated[int, SEED] = 0,
    trust: Annotated[bool, TRUST] = False,
    progress: Progress = lambda _: None,
) -> RideStudy:
    """Compare controllers over one road: comfort, travel and road holding, as a table and a plot of the trade-off.

    Parameters
    ----------
    rig : Rig, str or Path
        Rig or vehicle, its file or its name in the library.
    controls : sequence of Controller, str, Path or callable, optional
        As for :func:`ride_road`; by default all built-in ones.
    road : str
        As for :func:`ride_road`.
    speed : float or str
        m/s.
    duration : float or str, optional
        Time over the road, s; by default 20 s on ISO roads, otherwise until the last axle reaches the road's end.
    seed : int
        Seed of the random road, 0 or more.
    trust : bool
        As for :func:`ride_road`.
    progress : callable
        Receives a message for each ride.

    Returns
    -------
    RideStudy
        Rides, and the reasons of those that failed.

    Examples
    --------
    >>> study = compare_controllers("audi-a6-quarter-car", ["passive", "skyhook"], duration="5 s")
    >>> study.ride("skyhook").merits["comfort"] < study.ride("passive").merits["comfort"]
    True
    """
    lasting = COMPARED_DURATION if duration is None and is_class(road) else duration
    shared: dict[str, Any] = {
        "duration": lasting,
        "seed": seed,
        "trust": trust,
        "progress": progress,
    }
    return ride_road(rig, road, speed, controls=controls or ["all"], **shared)


def named_controls(given: Sequence[AnyControl]) -> list[AnyControl]:
    """Return controllers in the given order without duplicates; a text may name several, ``all`` selects all.

    >>> named_controls(["passive, skyhook", "passive"])
    ['passive', 'skyhook']
    """
    parts = [
        part for item in given for part in (item.split(",") if isinstance(item, str) else [item])
    ]
    names = [part.strip() if isinstance(part, str) else part for part in parts]
    named = [name for name in names if name != ""]
    if not named:
        raise DescriptionError(
            "no controller is named", where="--control", allowed="a controller, its file, or all"
        )
    return list(
        dict.fromkeys(
            control for name in named for control in (all_controls() if name == "all" else (name,))
        )
    )


def trial_over(
    rig: Rig, road: str, speed: float | str, duration: float | str | None = None, seed: int = 0
) -> RideTrial:
    """Return the trial of a vehicle over a class of ISO 8608, a road file, or a road of the library."""
    if not is_class(road):
        return road_trial(rig, load_road(road), speed, duration=duration)
    name, own = class_and_seed(road)
    if own is not None and seed not in (0, own):
        raise DescriptionError(
            "two different seeds are given",
            where="--seed",
            found=f"{seed}, and {own} in --road {road}",
        )
    lasting = DEFAULT_DURATION if duration is None else duration
    return iso_trial(rig, name, speed, duration=lasting, seed=seed if own is None else own)
