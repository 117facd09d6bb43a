"""Studies of hardpoints: points that may move, wanted curves, limits that must hold."""

from __future__ import annotations

import re
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field, model_validator

from jounce.core.description import Description, Seed, Whole
from jounce.core.errors import as_found
from jounce.core.misplaced import error_at
from jounce.core.phrases import Phrase
from jounce.core.units import NonNegativeLength, Unit
from jounce.kinematics.clearances import Rim, Solid
from jounce.kinematics.sweeps import AxleLayout

NAME = r"[A-Za-z][\w-]*"
"""Names of rigs in a study of several: files are named after them, and paths begin with them."""
SCHEMA: Literal["jounce.design/1"] = "jounce.design/1"
Quantitative = Any
"""A text with a unit, or a number in SI: which unit it has is known where the quantity is."""
Corners = tuple[Any, ...]
Share = Annotated[float, Unit("1")]


USUAL_TOLERANCES = {
    "m": 1e-3,
    "rad": float(np.radians(0.05)),
    "1": 0.01,
    "rad/m": float(np.radians(0.5)),
    "N/m": 500.0,
    "m/rad": 1e-3,
}
"""Tolerances of targets that give none, by their SI unit: 1 mm, 0.05 deg, 1 %, 0.5 deg/m, 0.5 N/mm, 1 mm/rad."""


class FreePoint(Description):
    """A hardpoint, one coordinate of it, or another number of the rig, that the search may move.

    ``point`` is its path: ``hardpoints.tie_rod_inner`` for all three coordinates, ``hardpoints.tie_rod_inner[2]`` for
    one. ``within`` (m) is how far each coordinate may go to either side; ``box`` has its lower and its upper corner
    instead. ``along`` is a direction, x, y, z, of any length, or the name of a hardpoint towards which it shows: the
    point moves on that line, ``within`` to either side; towards the other end of a link that is the link's length.
    ``tied`` lists points (or coordinates) that move by the same, on the other side of a car as in a mirror; with a
    minus before it, ``-hardpoints.lower_arm_rear[2]``, by the opposite. In a study of several rigs a path begins with
    the name of one: ``front.hardpoints.tie_rod_inner``.
    """

    point: str
    within: Any = None
    box: Corners | None = Field(default=None, min_length=2, max_length=2)
    along: str | tuple[Share, Share, Share] | None = None
    tied: tuple[str, ...] = ()

    @model_validator(mode="after")
    def _check_bounds(self) -> FreePoint:
        if (self.within is None) == (self.box is None):
            raise ValueError(
                Phrase(
                    'give either within = "15 mm" or box = [[lower corner], [upper corner]] of {point}',
                    point=self.point,
                )
            )
        if self.along is not None:
            if self.box is not None:
                raise error_at(
                    ("box",), "a line has no box", allowed="within, to either side along it"
                )
            if not any(self.along) and not isinstance(self.along, str):
                raise error_at(("along",), "not a direction", found=as_found([0, 0, 0]))
            if self.point.endswith("]"):
                raise error_at(
                    ("along",), "one coordinate moves along its axis", allowed="a point of three"
                )
        return self


class KinematicTarget(Description):
    """A wanted value or curve of a quantity of the catalogue.

    ``value`` is wanted within ``tolerance`` to either side; ``values`` are those of a curve, one a pose; ``at_least``
    and ``at_most`` are limits. ``at`` is a pose: a travel, or ``{travel = ..., rack = ..., roll = ...}``; ``over`` a
    range, of wheel travel (m) or of roll (an angle), or of the rack with ``along = "rack"``. Without both it is the
    design pose. ``slope`` wants the value of the slope of a straight line through the curve instead. ``tolerance`` is
    from where it is met, by default what is usual for its unit (``USUAL_TOLERANCES``). ``weight`` multiplies its share
    in a compromise, ``must`` makes it a constraint that holds in one. ``goal`` names what it belongs to where goals
    compete. ``rig`` says whose target it is in a study of several; ``right`` names the right corner of a rolled or
    steered axle that is not the mirror image of it.
    """

    quantity: str
    value: Quantitative | None = None
    values: tuple[Quantitative, ...] | None = None
    at_least: Quantitative | None = None
    at_most: Quantitative | None = None
    tolerance: Quantitative | None = None
    weight: Annotated[float, Unit("1", above=0.0)] = 1.0
    at: Quantitative = None
    over: str | tuple[Quantitative, ...] | None = None
    along: Literal["travel", "rack", "roll"] | None = None
    slope: bool = False
    must: bool = False
    goal: str | None = None
    rig: str | None = None
    right: str | None = None

    @model_validator(mode="after")
    def _check_form(self) -> KinematicTarget:
        wanted = [name for name in ("value", "values") if getattr(self, name) is not None]
        limits = self.at_least is not None or self.at_most is not None
        if len(wanted) + limits != 1:
            what = Phrase(
                "give one of value, values, or limits (at_least, at_most) for {name}",
                name=self.quantity,
            )
            raise error_at(
                (), what, found=Phrase(", ".join([*wanted, *["limits"] * limits]) or "none")
            )
        if self.at is not None and self.over is not None:
            raise error_at(
                ("over",),
                "a target stands at one pose or over a range",
                found=Phrase("both at and over"),
            )
        if self.values is not None and self.over is None:
            raise error_at(("values",), "values are those of a curve; allowed with over")
        if self.slope and (self.over is None or self.values is not None):
            raise error_at(("slope",), "the slope of a curve needs over, and one value")
        return self


class Spread(Description):
    """How exactly parts are made: a tolerance is two standard deviations of a normal distribution.

    ``points`` (m) is that of each coordinate of pickup points and joints, ``links`` (m) that of the length of each
    link; ``exact`` has others by the name of a point or the inner point of a link. ``adjust`` names what can be
    set afterwards, see :data:`jounce.kinematics.adjustments.SETTINGS`. ``cars`` are built, drawn with ``seed``.

    Examples
    --------
    >>> Spread(points="0.5 mm", links="0.3 mm", adjust=["tie_rod_length"]).links
    0.0003
    """

    points: NonNegativeLength = 0.0
    links: NonNegativeLength = 0.0
    exact: dict[str, NonNegativeLength] = {}
    adjust: tuple[str, ...] = ()
    cars: Annotated[Whole, Field(ge=2, le=100_000)] = 300
    seed: Seed = 0


class KinematicStudy(Description):
    """A study of hardpoints from targets: the ``rig`` (a file, or the name of a shipped one), what is free, wanted.

    ``rigs`` are several by name instead, both axles of a car or both sides of an axle, whose points may be tied.
    ``vehicle`` is the car around the axle, for anti-effects and Ackermann; ``vehicles`` has one by the name of a rig.
    ``starts`` searches begin at the rig and at places of the boxes drawn with ``seed``. ``spread`` says how exactly
    the parts are made, ``shapes`` are bodies by name for targets of their ``clearance(one, other)``.
    """

    schema_: Literal["jounce.design/1"] = Field(default=SCHEMA, alias="schema")
    rig: str | None = None
    rigs: dict[str, str] | None = None
    free: tuple[FreePoint, ...] = Field(min_length=1)
    target: tuple[KinematicTarget, ...] = Field(min_length=1)
    vehicle: AxleLayout | None = None
    vehicles: dict[str, AxleLayout] | None = None
    starts: Annotated[Whole, Field(ge=1, le=10_000)] = 8
    seed: Annotated[Whole, Field(ge=0)] = 0
    spread: Spread | None = None
    shapes: dict[str, Solid | Rim] | None = None

    @model_validator(mode="after")
    def _check_rigs(self) -> KinematicStudy:
        if (self.rig is None) == (not self.rigs):
            raise ValueError(
                'give either rig = "front.toml", or a table [rigs] with a name for each'
            )
        for name in self.rigs or ():
            if not re.fullmatch(NAME, name):
                raise error_at(
                    ("rigs",), "not a name of a rig", found=name, allowed="letters, digits, _ and -"
                )
        if self.rigs is None and self.vehicles is not None:
            raise error_at(
                ("vehicles",), "only several rigs have several", allowed="a table [vehicle]"
            )
        if self.rigs is not None and self.vehicle is not None:
            raise error_at(
                ("vehicle",), "whose is it?", allowed="tables [vehicles.<name of a rig>]"
            )
        return self

    def files_by_rig(self) -> dict[str, str]:
        """Files by the name of each rig; one alone has no name."""
        return dict(self.rigs) if self.rigs else {"": str(self.rig)}

    def around(self) -> dict[str, AxleLayout]:
        """Cars by the name of the rig."""
        return {"": self.vehicle} if self.vehicle is not None else dict(self.vehicles or {})


def coordinate(path: str) -> int | None:
    """Coordinate that a path ends with: 2 for ``hardpoints.tie_rod_inner[2]``; None for a whole point.

    >>> coordinate("hardpoints.tie_rod_inner[2]"), coordinate("hardpoints.tie_rod_inner")
    (2, None)
    """
    index = re.search(r"\[(\d+)\]$", path)
    return int(index[1]) if index else None
