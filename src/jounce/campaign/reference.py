"""A published result that a campaign states, with its source."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import Field

from jounce.core.description import Description, Whole
from jounce.core.units import PositiveSpeed, Unit

Share = Annotated[float, Unit("1", at_least=-10.0, at_most=1.0)]


class ReferenceUpdate(Description):
    """Published results of one update.

    Attributes
    ----------
    update : str
        Name of the corresponding update of this campaign.
    reduction : float or None
        Reduction of the objective (1) from the published start values.
    iterations : int or None
        Number of iterations.
    represents : tuple of str or None
        Channels that the published model is said to represent.
    parameters : dict
        Published value with its unit, by parameter path.
    """

    update: str
    reduction: Share | None = None
    iterations: Annotated[Whole, Field(ge=0)] | None = None
    represents: tuple[str, ...] | None = None
    parameters: dict[str, Any] = {}


class Reference(Description):
    """A published result to compare a campaign with.

    Attributes
    ----------
    source : str
        Publication.
    update : tuple of ReferenceUpdate
        Published results of each update.
    best_speeds : tuple of float
        Speeds (m/s) at which the published model is said to be best.
    """

    source: str = Field(min_length=1)
    update: tuple[ReferenceUpdate, ...] = ()
    best_speeds: tuple[PositiveSpeed, ...] = ()
