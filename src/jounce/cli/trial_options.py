"""What a rig is driven over: the options of every command that simulates a trial."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import optional_quantity, positive_quantity
from jounce.core.errors import DescriptionError

if TYPE_CHECKING:
    from jounce.core.findings import Finding
    from jounce.roads import Trial

RoadName = Annotated[
    str | None, typer.Option(help="A road: TOML, OpenCRG or table file, or a name of `jounce library`.")
]
DrivenSpeed = Annotated[str | None, typer.Option(help='Speed over the road, e.g. "1.95 m/s".')]
Duration = Annotated[str | None, typer.Option(help='Length of the run, e.g. "3 s".')]
ExcitationFile = Annotated[
    Path | None, typer.Option(help="Instead of road and speed: file with the columns time and road.z.")
]


def trial_of(
    road: str | None, excitation: Path | None, speed_text: str | None, duration: str | None, *, where: str
) -> Trial:
    """Build the trial that the options of the command ``where`` describe."""
    from jounce.roads import Trial, load_road

    speed = optional_quantity(speed_text, "m/s", "--speed")

    if (road is None) == (excitation is None):
        raise DescriptionError(
            "give either a road or an excitation" if road is None else "a road and an excitation are given",
            where=where,
            allowed='--road ROAD --speed "1.95 m/s" --duration "3 s", or --excitation base.csv',
        )
    given: dict[str, Any] = {} if duration is None else {"duration": positive_quantity(duration, "s", "--duration")}
    if excitation is not None:
        if speed is not None:
            raise DescriptionError("an excitation is in time already", where="--speed", hint="Leave out the speed.")
        return Trial(excitation=excitation, **given)
    for option, value, example in (("--speed", speed, "1.95 m/s"), ("--duration", duration, "3 s")):
        if value is None:
            raise DescriptionError(f"{option} is missing; a road needs it", allowed=f'{option} "{example}"')
    if speed is not None and speed <= 0.0:
        raise DescriptionError("out of range", where="--speed", found=f"{speed:g} m/s", allowed="above 0 m/s")
    return Trial(road=load_road(str(road)), speed=speed, **given)


def trial_findings(trial: Trial) -> list[Finding]:
    """Say when the run ends before anything happens."""
    from jounce.core.findings import Finding

    if trial.road is None or trial.speed is None or trial.road.start < trial.speed * trial.duration:
        return []
    text = (
        f"the run ends before the obstacle begins, {trial.road.start:g} m from the start; drive longer or start nearer."
    )
    return [Finding("--duration", "warning", text, trial.duration)]
