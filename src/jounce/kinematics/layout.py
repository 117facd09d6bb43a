"""What of the vehicle the percentages of anti-dive, anti-lift and anti-squat need beyond the corner."""

from __future__ import annotations

from typing import Annotated, Literal

from jounce.core.description import Description
from jounce.core.types import Array
from jounce.core.units import PositiveLength, Unit

_Share = Annotated[float, Unit("1", at_least=0.0, at_most=1.0)]


class AxleLayout(Description):
    """The car around a corner, for shares of load transfer that the suspension's geometry carries.

    ``axle`` says which one the corner belongs to; ``wheelbase`` (m), ``centre_of_mass_height`` (m, above the ground);
    ``brake_share`` is this axle's share of the braking force (outboard brakes).

    Examples
    --------
    >>> AxleLayout(axle="front", wheelbase="2.7 m", centre_of_mass_height="550 mm", brake_share=0.65).wheelbase
    2.7
    """

    axle: Literal["front", "rear"]
    wheelbase: PositiveLength
    centre_of_mass_height: PositiveLength
    brake_share: _Share


ROWS = {
    "anti_dive": "share of the braking dive that the front geometry takes",
    "anti_lift": "share of the braking lift that the rear geometry takes",
    "anti_squat": "share of the driving squat that the rear geometry takes, drive torque reacted by the body",
}
SIGN = "positive: against the body's motion; 1 is all of it"


def shares(vehicle: AxleLayout, contact: Array, centre: Array) -> dict[str, Array]:
    """Shares of the load transfer that the geometry carries (domain: brake and drive forces at the wheel).

    Parameters
    ----------
    vehicle : AxleLayout
        Dimensions (m) and brake share.
    contact, centre : ndarray
        dx/dz [1] of the contact patch with the wheel locked, and of the wheel centre.

    Returns
    -------
    dict
        ``anti_dive`` for a front axle, ``anti_lift`` and ``anti_squat`` for a rear one; 1 is all of it.
    """
    lever = vehicle.wheelbase / vehicle.centre_of_mass_height
    if vehicle.axle == "front":
        return {"anti_dive": vehicle.brake_share * lever * contact}
    return {"anti_lift": -vehicle.brake_share * lever * contact, "anti_squat": -lever * centre}
