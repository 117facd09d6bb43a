"""Studies of hardpoints: movable points, target curves and constraints."""

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
"""Names of rigs in a study of several: used as file names and as prefixes of paths."""
SCHEMA: Literal["jounce.design/1"] = "jounce.design/1"
Quantitative = Any
"""A text with a unit, or a number in SI; the unit depends on the quantity."""
Corners = tuple[Any, ...]
Share = Annotated[float, Unit("1")]


USUAL_TOLERANCES = {
    "m": 1e-3,
    "rad": float(np.radians(0.05)),
    "1": 0.01,
    "rad/m": float(np.radians(0.5)),
    "N/m": 500.0,
    "m/rad": 1e-3,
    "rad/N": float(np.radians(0.01)) / 1e3,
    "m/N": 1e-7,
    "rad/(N*m)": float(np.radians(0.01)) / 100.0,
}
"""Default tolerances of targets, by their SI unit: 1 mm, 0.05 deg, 1 %, 0.5 deg/m, 0.5 N/mm, 1 mm/rad; of K&C tests
0.01 deg/kN, 0.1 mm/kN, and 0.01 deg per 100 N m."""


class FreePoint(Description):
    """A hardpoint, one of its coordinates, or another parameter of the rig that the search may change.

    ``point`` is its path: ``hardpoints.tie_rod_inner`` for all three coordinates, ``hardpoints.tie_rod_inner[2]`` for
    one. ``within`` (m) is the range of each coordinate to either side; ``box`` has the lower and the upper corner
    instead. ``along`` is a direction x, y, z of any length, or the name of a hardpoint that gives the direction: the
    point moves on that line, ``within`` to either side. With the other end of a link as ``along``, this changes the
    link's length. ``tied`` lists points (or coordinates) that move by the same amount, mirrored on the other side of
    the car; with a minus sign, ``-hardpoints.lower_arm_rear[2]``, by the opposite amount. In a study of several rigs a
    path begins with the name of a rig: ``front.hardpoints.tie_rod_inner``.
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
                    ("box",),
                    "box does not apply to a point on a line",
                    allowed="within, the distance to either side along the line",
                )
            if not any(self.along) and not isinstance(self.along, str):
                raise error_at(("along",), "invalid direction", found=as_found([0, 0, 0]))
            if self.point.endswith("]"):
                raise error_at(
                    ("along",),
                    "a single coordinate moves only along its own axis",
                    allowed="a point with three coordinates",
                )
        return self


class KinematicTarget(Description):
    """A target value or curve of a quantity of the catalogue, or a row of a K&C sheet.

    ``value`` is the target value; ``values`` are those of a curve, one per pose; ``at_least`` and ``at_most`` are
    limits. ``at`` is a pose: a travel, or ``{travel = ..., rack = ..., roll = ...}``; ``over`` is a range of wheel
    travel (m), of roll (an angle), or of the rack with ``along = "rack"``. Without ``at`` and ``over`` the target
    applies to the design pose. With ``slope``, the value applies to the slope of a straight line fitted to the curve.
    The target is met within ``tolerance`` to either side; the default depends on the unit (``USUAL_TOLERANCES``).
    ``weight`` multiplies its share in a compromise; ``must`` makes it a constraint. ``goal`` names the goal to which it
    belongs if goals compete. ``rig`` names its rig in a study of several; ``right`` names the right corner of a rolled
    or steered axle if it is not the mirror image of the left one.

    With ``test``, the name of a K&C test, the target is the slope of a line through ``quantity`` (``toe`` of the left
    wheel, ``right.toe``, ``rack_force``) over half of the test's range, or over ``over``: half of the range of the
    line, or its ends. ``at`` is the travel, or travel and rack, before the test.
    """

    quantity: str
    test: str | None = None
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
        if self.at is not None and self.over is not None and self.test is None:
            raise error_at(
                ("over",),
                "a target applies at one pose or over a range",
                found=Phrase("both at and over are given"),
            )
        if self.values is not None and self.over is None:
            raise error_at(("values",), "values describe a curve and need over")
        if self.test is not None:
            for name in ("values", "along", "right"):
                if getattr(self, name) is not None:
                    raise error_at(
                        (name,), "does not apply to a test, whose slope is a single value"
                    )
            return self
        if self.slope and (self.over is None or self.values is not None):
            raise error_at(("slope",), "the slope of a curve needs over and a single value")
        return self


class Spread(Description):
    """Manufacturing tolerances of the parts; a tolerance is two standard deviations of a normal distribution.

    ``points`` (m) applies to each coordinate of pickup points and joints, ``links`` (m) to the length of each link,
    ``stiffnesses`` (a share, 0.15 for 15 %) to all stiffnesses of each bushing and link; ``exact`` has individual
    tolerances by the name of a point or the inner point of a link. ``adjust`` names the adjustments that can be made
    afterwards, see :data:`jounce.kinematics.adjustments.SETTINGS`. ``cars`` is the number of cars built, drawn with
    ``seed``.

    Examples
    --------
    >>> Spread(points="0.5 mm", links="0.3 mm", adjust=["tie_rod_length"]).links
    0.0003
    """

    points: NonNegativeLength = 0.0
    links: NonNegativeLength = 0.0
    stiffnesses: Annotated[float, Unit("1", at_least=0.0, at_most=0.9)] = 0.0
    exact: dict[str, NonNegativeLength] = {}
    adjust: tuple[str, ...] = ()
    cars: Annotated[Whole, Field(ge=2, le=100_000)] = 300
    seed: Seed = 0


class KinematicStudy(Description):
    """A study of hardpoints from targets: the ``rig`` (a file, or the name of a shipped rig), free points, targets.

    ``rigs`` has several rigs by name instead, such as both axles of a car or both sides of an axle; their points may be
    tied. ``vehicle`` has the vehicle data of the axle, for anti-effects and Ackermann; ``vehicles`` has them by the
    name of a rig. ``starts`` is the number of searches, from the rig and from points within the boxes, drawn with
    ``seed``. ``spread`` has the manufacturing tolerances; ``shapes`` are bodies by name for targets of the quantity
    ``clearance(one, other)``.
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
                    ("rigs",), "invalid rig name", found=name, allowed="letters, digits, _ and -"
                )
        if self.rigs is None and self.vehicles is not None:
            raise error_at(
                ("vehicles",),
                "only a study of several rigs has several vehicles",
                allowed="a table [vehicle]",
            )
        if self.rigs is not None and self.vehicle is not None:
            raise error_at(
                ("vehicle",),
                "the vehicle data do not name their rig",
                allowed="tables [vehicles.<name of a rig>]",
            )
        return self

    def files_by_rig(self) -> dict[str, str]:
        """Return files by the name of each rig; a single rig has the name ""."""
        return dict(self.rigs) if self.rigs else {"": str(self.rig)}

    def around(self) -> dict[str, AxleLayout]:
        """Return the vehicle data by the name of the rig."""
        return {"": self.vehicle} if self.vehicle is not None else dict(self.vehicles or {})


def coordinate(path: str) -> int | None:
    """Return the coordinate index at the end of a path; None for a whole point.

    >>> coordinate("hardpoints.tie_rod_inner[2]"), coordinate("hardpoints.tie_rod_inner")
    (2, None)
    """
    index = re.search(r"\[(\d+)\]$", path)
    return int(index[1]) if index else None
