"""What a rig is driven over: the options of every command that simulates a trial."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import optional_quantity, positive_quantity, quantity
from jounce.core.errors import DescriptionError

if TYPE_CHECKING:
    from jounce.core.findings import Finding
    from jounce.parts import Rig
    from jounce.roads import Trial

RoadName = Annotated[
    str | None, typer.Option(help="A road: TOML, OpenCRG or table file, or a name of `jounce library`.")
]
DrivenSpeed = Annotated[str | None, typer.Option(help='Speed over the road, e.g. "1.95 m/s".')]
Duration = Annotated[str | None, typer.Option(help='Length of the run, e.g. "3 s".')]
ExcitationFile = Annotated[
    Path | None, typer.Option(help="Instead of road and speed: file with the columns time and road.z.")
]


RightRoad = Annotated[
    str | None, typer.Option("--right-road", help="Full cars: a road under the right wheels; else the left one's.")
]
PitchMoment = Annotated[
    str | None,
    typer.Option(
        "--pitch-moment", metavar="VALUE[@TIME]", help='Vehicles: on the body, nose down positive, "100 N*m@3 s".'
    ),
]
Deceleration = Annotated[
    str | None, typer.Option("--deceleration", metavar="VALUE[@TIME]", help='Vehicles: braking, "3 m/s^2@1 s".')
]
LateralAcceleration = Annotated[
    str | None,
    typer.Option("--lateral-acceleration", metavar="VALUE[@TIME]", help='Full cars: to the left, "4 m/s^2@1 s".'),
]


def trial_of(
    road: str | None,
    excitation: Path | None,
    speed_text: str | None,
    duration: str | None,
    *,
    where: str,
    right: str | None = None,
    loads: dict[str, str | None] | None = None,
) -> Trial:
    """Build the trial that the options of the command ``where`` describe; ``loads`` by their names in a trial."""
    from jounce.roads import Trial, load_road

    speed = optional_quantity(speed_text, "m/s", "--speed")

    if (road is None) == (excitation is None):
        raise DescriptionError(
            "give either a road or an excitation" if road is None else "a road and an excitation are given",
            where=where,
            allowed='--road ROAD --speed "1.95 m/s" --duration "3 s", or --excitation base.csv',
        )
    given: dict[str, Any] = {} if duration is None else {"duration": positive_quantity(duration, "s", "--duration")}
    given |= {name: _load(name, text) for name, text in (loads or {}).items() if text is not None}
    if excitation is not None:
        for option, text in (("--speed", speed_text), ("--right-road", right)):
            if text is not None:
                hint = f"Leave out {'the speed' if option == '--speed' else 'the road'}."
                raise DescriptionError("an excitation is in time already", where=option, hint=hint)
        return Trial(excitation=excitation, **given)
    for option, value, example in (("--speed", speed, "1.95 m/s"), ("--duration", duration, "3 s")):
        if value is None:
            raise DescriptionError(f"{option} is missing; a road needs it", allowed=f'{option} "{example}"')
    if speed is not None and speed <= 0.0:
        raise DescriptionError("out of range", where="--speed", found=f"{speed:g} m/s", allowed="above 0 m/s")
    driven = speed * given["duration"] if speed is not None else None
    if right is not None:
        given["right"] = load_road(right, length=driven)
    return Trial(road=load_road(str(road), length=driven), speed=speed, **given)


def _load(name: str, text: str) -> dict[str, float]:
    """Read ``VALUE`` or ``VALUE@TIME``: from the start of the run, or from a time on."""
    option = f"--{name.replace('_', '-')}"
    value, at, start = text.partition("@")
    found = {"value": quantity(value.strip(), "N*m" if name == "pitch_moment" else "m/s^2", option)}
    if at:
        found["start"] = quantity(start.strip(), "s", option)
        if found["start"] < 0.0:
            raise DescriptionError("out of range", where=option, found=start.strip(), allowed="a time of at least 0 s")
    return found


def trial_findings(trial: Trial, rig: Rig | None = None, *, output_step: float | None = None) -> list[Finding]:
    """Say what looks wrong with a trial: a road that ends before the run does, a load that never comes, ..."""
    from jounce.roads.trial import trial_findings as found

    return found(trial, rig, output_step=output_step)
