"""Trains of obstacles, and the set of all roads."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from jounce.core.units import PositiveLength
from jounce.roads.enveloping import Enveloped
from jounce.roads.iso8608 import Iso8608, SineSum
from jounce.roads.measured import Crg, Table
from jounce.roads.obstacles import (
    CircularSegment,
    Flat,
    HalfCylinder,
    HalfSine,
    Kerb,
    Pothole,
    Ramp,
    Rectangle,
    Step,
    Trapezoid,
    Triangle,
    Versine,
)
from jounce.roads.profile import Profile, repeated
from jounce.roads.road import Road
from jounce.roads.sweeps import Sine, SineSweep


class Train(Road):
    """The same obstacle several times, at a pitch from start to start.

    Steps and ramps climb: each stands on the level that the one before left. ``start`` and ``recurrence`` are those of
    ``of`` unless the train has its own; the positions within the train do not depend on them.

    Attributes
    ----------
    of : Road
        The obstacle, itself a train if you like.
    count : int
        How many.
    pitch : float
        Distance in m from the start of one to the start of the next, at least the obstacle's length.

    Examples
    --------
    >>> train = Train(of=HalfSine(height="10 mm", length="60 mm", start="0.2 m"), count=5, pitch="0.10 m")
    >>> train.start, round(train.end() - train.start, 12)
    (0.2, 0.46)
    """

    kind: Literal["train"] = "train"
    of: AnyRoad
    count: int = Field(ge=1, le=1_000_000, strict=True)
    pitch: PositiveLength

    def check(self) -> None:
        """Refuse overlaps; take over what belongs to the obstacle."""
        for name in ("start", "recurrence"):
            if name not in self.model_fields_set:
                object.__setattr__(self, name, getattr(self.of, name))
        length = self.of.profile().span
        if self.count > 1 and self.pitch < length * (1.0 - 1e-9):
            raise ValueError(
                f"the obstacles overlap: pitch {self.pitch:g} m (start to start) is shorter than the length "
                f"{length:g} m of one; allowed: a pitch of at least {length:g} m"
            )

    def profile(self) -> Profile:
        """Pieces of the whole train."""
        return repeated(self.of.profile(), self.count, self.pitch)


AnyRoad = Annotated[
    Flat
    | HalfSine
    | Versine
    | Rectangle
    | Trapezoid
    | Triangle
    | HalfCylinder
    | CircularSegment
    | Step
    | Ramp
    | Kerb
    | Pothole
    | Sine
    | SineSweep
    | SineSum
    | Iso8608
    | Table
    | Crg
    | Train
    | Enveloped,
    Field(discriminator="kind"),
]
Train.model_rebuild()
Enveloped.model_rebuild(_types_namespace={"AnyRoad": AnyRoad})

ROADS: dict[str, type[Road]] = {
    road.model_fields["kind"].default: road
    for road in (
        Flat,
        HalfSine,
        Versine,
        Rectangle,
        Trapezoid,
        Triangle,
        HalfCylinder,
        CircularSegment,
        Step,
        Ramp,
        Kerb,
        Pothole,
        Sine,
        SineSweep,
        SineSum,
        Iso8608,
        Table,
        Crg,
        Train,
        Enveloped,
    )
}
