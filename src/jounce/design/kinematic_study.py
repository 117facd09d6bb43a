"""What a designer of a suspension asks: points that may move, curves that are wanted, limits that must hold."""

from __future__ import annotations

import re
from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from jounce.core.description import Description, misplaced
from jounce.core.units import Unit
from jounce.kinematics.sweeps import AxleLayout

SCHEMA: Literal["jounce.design/1"] = "jounce.design/1"
Quantitative = Any
"""A text with a unit, or a number in SI: which unit it has is known where the quantity is."""
Corners = tuple[Any, ...]
Share = Annotated[float, Unit("1")]


class FreePoint(Description):
    """A hardpoint, one coordinate of it, or another number of the rig, that the search may move.

    ``point`` is its path: ``hardpoints.tie_rod_inner`` for all three coordinates, ``hardpoints.tie_rod_inner[2]`` for
    one. ``within`` (m) is how far each coordinate may go to either side; ``box`` has its lower and its upper corner
    instead. ``along`` is a direction, x, y, z, of any length: the point moves on that line, ``within`` to either side.
    ``tied`` lists points (or coordinates) that move by the same.
    """

    point: str
    within: Any = None
    box: Corners | None = Field(default=None, min_length=2, max_length=2)
    along: tuple[Share, Share, Share] | None = None
    tied: tuple[str, ...] = ()

    @model_validator(mode="after")
    def _is_bounded(self) -> FreePoint:
        if (self.within is None) == (self.box is None):
            raise ValueError(f'give either within = "15 mm" or box = [[lower corner], [upper corner]] of {self.point}')
        if self.along is not None:
            if self.box is not None:
                raise misplaced(("box",), "a line has no box; allowed: within, to either side along it")
            if not any(self.along):
                raise misplaced(("along",), "not a direction; found [0, 0, 0]")
            if self.point.endswith("]"):
                raise misplaced(("along",), "one coordinate moves along its axis; allowed: a point of three")
        return self


class KinematicTarget(Description):
    """A wanted value or curve of a quantity of the catalogue.

    ``value`` is wanted within ``tolerance`` to either side; ``values`` are those of a curve, one a pose; ``at_least``
    and ``at_most`` are limits. ``at`` is a pose: a travel, or ``{travel = ..., rack = ..., roll = ...}``; ``over`` a
    range, of wheel travel (m) or of roll (an angle), or of the rack with ``along = "rack"``. Without both it is the
    design pose. ``slope`` wants the value of the slope of a straight line through the curve instead. ``weight``
    multiplies its share in a compromise.
    """

    quantity: str
    value: Quantitative | None = None
    values: tuple[Quantitative, ...] | None = None
    at_least: Quantitative | None = None
    at_most: Quantitative | None = None
    tolerance: Quantitative
    weight: Annotated[float, Unit("1", above=0.0)] = 1.0
    at: Quantitative = None
    over: str | tuple[Quantitative, ...] | None = None
    along: Literal["travel", "rack", "roll"] | None = None
    slope: bool = False

    @model_validator(mode="after")
    def _asks_one_thing(self) -> KinematicTarget:
        wanted = [name for name in ("value", "values") if getattr(self, name) is not None]
        limits = self.at_least is not None or self.at_most is not None
        if len(wanted) + limits != 1:
            raise ValueError(
                f"give one of value, values, or limits (at_least, at_most) for {self.quantity}; found "
                f"{', '.join([*wanted, *(['limits'] if limits else [])]) or 'none'}"
            )
        if self.at is not None and self.over is not None:
            raise misplaced(("over",), "a target stands at one pose or over a range; found both at and over")
        if self.values is not None and self.over is None:
            raise misplaced(("values",), "values are those of a curve; allowed with over")
        if self.slope and (self.over is None or self.values is not None):
            raise misplaced(("slope",), "the slope of a curve needs over, and one value")
        return self


class KinematicStudy(Description):
    """A study of hardpoints from targets: the ``rig`` (a file, or the name of a shipped one), what is free, wanted.

    ``vehicle`` is the car around the axle, for anti-effects and Ackermann; ``starts`` searches begin at the rig and at
    places of the boxes drawn with ``seed``.
    """

    schema_: Literal["jounce.design/1"] = Field(default=SCHEMA, alias="schema")
    rig: str
    free: tuple[FreePoint, ...] = Field(min_length=1)
    target: tuple[KinematicTarget, ...] = Field(min_length=1)
    vehicle: AxleLayout | None = None
    starts: Annotated[int, Field(ge=1, le=10_000)] = 8
    seed: Annotated[int, Field(ge=0)] = 0


def coordinate(path: str) -> int | None:
    """Coordinate that a path ends with: 2 for ``hardpoints.tie_rod_inner[2]``; None for a whole point.

    >>> coordinate("hardpoints.tie_rod_inner[2]"), coordinate("hardpoints.tie_rod_inner")
    (2, None)
    """
    found = re.search(r"\[(\d+)\]$", path)
    return int(found[1]) if found else None
