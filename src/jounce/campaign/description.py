"""Campaign files: bench measurements, trials, and updates."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field, field_validator, model_validator

from jounce.campaign.belt import Belt, Passage
from jounce.campaign.reference import Reference
from jounce.core.description import Description, Whole, read_description
from jounce.core.phrases import Phrase
from jounce.core.units import (
    NonNegativeLength,
    NonNegativeMass,
    PositiveSpeed,
    PositiveTime,
    Unit,
    to_si,
)
from jounce.identify.doubt import Doubt
from jounce.identify.signs import ForcePositive, StrokePositive
from jounce.recordings import Sensor
from jounce.recordings.formats import RecordingFormat, TableFormat
from jounce.roads.trial import ExcitationDatum

Angle = Annotated[float, Unit("rad")]
Pressure = Annotated[float, Unit("Pa", above=0.0)]
PlainTime = Annotated[float, Unit("s")]
NonNegativeNumber = Annotated[float, Unit("1", at_least=0.0)]


class StiffnessBench(TableFormat):
    """Force-deflection trials of one component; columns ``displacement`` and ``force``."""

    files: tuple[str, ...] = Field(min_length=1)
    law: Literal["linear", "polynomial", "power", "monotone-spline"] = "linear"
    degree: Annotated[Whole, Field(ge=1, le=6)] = 3
    discard_below: NonNegativeLength = 0.0
    intercept: Literal["drop", "shift", "keep"] = "drop"
    branch: Literal["loading", "unloading", "both"] = "loading"
    stroke_positive: StrokePositive | None = None
    force_positive: ForcePositive | None = None


class DecayBench(RecordingFormat):
    """Free decays of the sprung mass. ``support``: the wheel stands on its tyre, or the hub is blocked.

    ``method`` selects the source of the damper's coefficient: the viscous part separated from dry friction, or the
    logarithmic decrement of the paper, which treats all losses as viscous.
    """

    files: tuple[str, ...] = Field(min_length=1)
    channel: str = "sprung.z"
    support: Literal["tyre", "blocked"] = "tyre"
    from_: PlainTime | None = Field(default=None, alias="from")
    to: PlainTime | None = None
    quadratic_drag: Literal["auto", "yes", "no"] = "auto"
    method: Literal["viscous-and-coulomb", "logarithmic-decrement"] = "viscous-and-coulomb"
    stroke_positive: StrokePositive | None = None


class Bench(Description):
    """Component measurements; every table is optional. Tyre tables are named by their pressure."""

    spring: StiffnessBench | None = None
    tyre: dict[str, StiffnessBench] = {}
    decay: DecayBench | None = None

    @field_validator("tyre")
    @classmethod
    def _named_by_pressure(cls, tables: dict[str, StiffnessBench]) -> dict[str, StiffnessBench]:
        for name in tables:
            to_si(name, "Pa", where="bench.tyre")
        return tables


def _as_file_entry(value: object) -> object:
    return {"file": value} if isinstance(value, str) else value


class InputFile(RecordingFormat):
    """A measured input of a trial: a file with ``time`` and one channel; a string is short for ``{file = string}``."""

    file: str


class ExcitationFile(InputFile):
    """The measured height of the support; ``datum`` is its zero, as in `Excitation`."""

    datum: ExcitationDatum = "undeformed"


AnInput = Annotated[InputFile | None, BeforeValidator(_as_file_entry)]
AnExcitation = Annotated[ExcitationFile | None, BeforeValidator(_as_file_entry)]


class TrialEntry(RecordingFormat):
    """One run over the obstacle course (or on a shaker) and its recording."""

    number: Whole
    speed: PositiveSpeed | None = None
    from_: PlainTime | None = Field(default=None, alias="from")
    to: PlainTime | None = None
    passage: Passage = "all"
    road: str | None = None
    excitation: AnExcitation = None
    actuator_force: AnInput = None
    strut_angle: Angle | None = None
    tyre_pressure: Pressure | None = None
    recording: str
    stroke_positive: StrokePositive | None = None
    force_positive: ForcePositive | None = None
    use: Literal["fit", "hold-out"] = "hold-out"
    duration: PositiveTime | None = None
    added_mass: NonNegativeMass = 0.0
    wheel_load: Annotated[float, Unit("N", above=0.0)] | None = None
    changes: dict[str, Any] = {}
    adjustments: dict[str, Any] = {}

    @model_validator(mode="after")
    def _road_or_excitation(self) -> TrialEntry:
        if (self.excitation is None) == (self.road is None):
            raise ValueError("give either road and speed, or excitation")
        if self.from_ is not None and self.to is not None and self.to <= self.from_:
            raise ValueError(
                Phrase(
                    "from ({from_:g} s) is not before to ({to:g} s)", from_=self.from_, to=self.to
                )
            )
        return self


class UpdateEntry(Description):
    """One updating strategy: free parameters, their bounds, and the trials to fit."""

    name: str
    free: dict[str, Any]
    trials: tuple[Whole, ...] | Literal["fit"] = "fit"
    method: Literal["bfgs", "least-squares"] = "least-squares"
    start_from: str | None = None
    tyre_law: Literal["as-rig", "polynomial"] = "as-rig"
    weights: Literal["printed", "normalised"] | dict[str, NonNegativeNumber] = "printed"
    channels: tuple[str, ...] | None = None
    align: Literal["lag"] | None = None
    nuisances: dict[str, Any] = {}
    starts: Annotated[Whole, Field(ge=1, le=1000)] | None = None


class Campaign(Description):
    """A whole bench campaign."""

    schema_: Literal["jounce.campaign/1"] = Field(alias="schema")
    title: str = "Bench campaign"
    synthetic: str = ""
    estimated: tuple[str, ...] = ()
    rig: str
    bench: Bench = Bench()
    belt: Belt | None = None
    sensors: dict[str, Sensor] = {}
    doubt: Doubt = Doubt()
    roads: dict[str, Any] = {}
    trial: tuple[TrialEntry, ...] = Field(min_length=1)
    update: tuple[UpdateEntry, ...] = ()
    reference: Reference | None = None

    @model_validator(mode="after")
    def _consistent(self) -> Campaign:
        has_pulses = self.belt is not None and self.belt.has_pulses
        slow = [
            trial.number for trial in self.trial if trial.road is not None and trial.speed is None
        ]
        if slow and not has_pulses:
            raise ValueError(
                Phrase(
                    (
                        "the speed of trial {slow} is missing; a road needs a speed, or radius, pulses and column "
                        "in [belt]"
                    ),
                    slow=slow[0],
                )
            )
        numbers = [entry.number for entry in self.trial]
        twice = {number for number in numbers if numbers.count(number) > 1}
        if twice:
            raise ValueError(Phrase("trial number {twice} is given twice", twice=min(twice)))
        names: list[str] = []
        for entry in self.update:
            if entry.name in names:
                raise ValueError(Phrase("two updates are named {name!r}", name=entry.name))
            if entry.start_from is not None and entry.start_from not in names:
                earlier = ", ".join(names) or "none"
                raise ValueError(
                    Phrase(
                        "update {name!r} starts from {start_from!r}; earlier updates: {earlier}",
                        name=entry.name,
                        start_from=entry.start_from,
                        earlier=earlier,
                    )
                )
            if isinstance(entry.trials, tuple) and set(entry.trials) - set(numbers):
                missing = min(set(entry.trials) - set(numbers))
                raise ValueError(
                    Phrase(
                        "update {name!r} uses trial {missing}, which does not exist",
                        name=entry.name,
                        missing=missing,
                    )
                )
            names.append(entry.name)
        for published in self.reference.update if self.reference is not None else ():
            if published.update not in names:
                raise ValueError(
                    f"reference names update {published.update!r}; updates: {', '.join(names) or 'none'}"
                )
        return self


def load_campaign(path: Path | str) -> tuple[Campaign, str]:
    """Read a campaign file; return the campaign and the text of the file.

    Parameters
    ----------
    path : path
        TOML file; file names in it are relative to its folder.

    Raises
    ------
    DescriptionError
        If the file is invalid; the message names file, line, path, value and allowed values.
    """
    return read_description(Campaign, path, "jounce.campaign/1")
