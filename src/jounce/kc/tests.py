"""The tests of a kinematics-and-compliance laboratory: what each moves or loads, its unit, sign and usual range."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

Kind = Literal["heights", "roll", "rack", "lateral", "longitudinal", "aligning"]


@dataclass(frozen=True)
class KCTest:
    """A test: its input and unit (SI), its usual range, and for loads the share of each wheel and where they act.

    ``through`` is where a horizontal force acts: at the contact point or at the wheel centre. ``one_sided`` loads run
    from zero to the end of the range and back, and do not change sign.
    """

    name: str
    kind: Kind
    what: str
    positive: str
    unit: str
    range: float
    shares: tuple[float, float] = (1.0, 1.0)
    through: Literal["contact_point", "wheel_centre"] = "contact_point"
    direction: float = 1.0
    one_sided: bool = False
    trail: float = 0.0


_ROLL = math.radians(3.0)
_EACH = "force of the road on each tyre"
_LATERAL = "to the left (+y)"
_REARWARD = "rearward"
_FORWARD = "forward (+x)"
_MOMENT = "moment of the road on each tyre"
TESTS = {
    test.name: test
    for test in (
        KCTest("bounce", "heights", "height of both pads", "up, bump", "m", 0.05),
        KCTest("roll", "roll", "angle of the pads, axle load constant", "left pad up", "rad", _ROLL),
        KCTest("steer", "rack", "rack travel", "to the left (+y)", "m", 0.04),
        KCTest("lateral-in-phase", "lateral", _EACH, _LATERAL, "N", 2000.0),
        KCTest("lateral-opposed", "lateral", _EACH, "outward", "N", 2000.0, (1.0, -1.0)),
        KCTest(
            "lateral-left", "lateral", "force of the road on the left tyre", _LATERAL, "N", 2000.0,
            (1.0, 0.0),
        ),
        KCTest(
            "lateral-right", "lateral", "force of the road on the right tyre", _LATERAL, "N",
            2000.0, (0.0, 1.0),
        ),
        KCTest(
            "lateral-trail", "lateral", f"{_EACH}, behind the contact point", _LATERAL, "N", 2000.0,
            trail=0.03,
        ),
        KCTest(
            "braking", "longitudinal", f"{_EACH}, brakes at the wheels", _REARWARD, "N", 2000.0,
            direction=-1.0, one_sided=True,
        ),
        KCTest(
            "braking-inboard", "longitudinal", f"{_EACH}, brakes on the body", _REARWARD, "N",
            2000.0, through="wheel_centre", direction=-1.0, one_sided=True,
        ),
        KCTest(
            "driving", "longitudinal", f"{_EACH}, driven by shafts", _FORWARD, "N", 2000.0,
            through="wheel_centre", one_sided=True,
        ),
        KCTest(
            "driving-hub", "longitudinal", f"{_EACH}, driven by hub motors", _FORWARD, "N", 2000.0,
            one_sided=True,
        ),
        KCTest("aligning-in-phase", "aligning", _MOMENT, "about +z", "N*m", 100.0),
        KCTest(
            "aligning-opposed", "aligning", _MOMENT, "left about +z, right about -z", "N*m", 100.0,
            (1.0, -1.0),
        ),
    )
}  # fmt: skip
"""All tests by name, in the order of the sheet."""
