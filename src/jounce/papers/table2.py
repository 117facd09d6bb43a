"""The sixteen trials of the quarter-car prototype paper (its Table 2), in two readings.

The table is only available as text in which merged cells are shifted. As printed (``literal``), the cells of angle,
pressure and obstacle are one row below their speed from trial 4 on, the rows are in the order 1-11, 14, 15, 16, 12,
13, and there is one row more than there are speeds.

``reconstructed`` moves those three columns up by one row. Evidence: the text states that trials 9-16 were run at
0.25 MPa, and shows trial 9 as the example of that pressure. The trials then form two equal blocks of eight, one for
each pressure (the single obstacle at three speeds, three trains, the single obstacle at 16 and 10 degrees), which is
also consistent with the unusual order of rows. One ambiguity remains: "0.25" is printed next to the first "16 degrees"
cell, which taken literally would put trials 7 and 8 at 0.25 MPa, contrary to the text; ``reconstructed`` follows the
text.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import jounce as jn

Variant = Literal["reconstructed", "literal"]
_HIGH, _LOW = 310e3, 250e3  # Pa, as printed


@dataclass(frozen=True)
class Table2Row:
    """One trial: its passage speed (m/s, printed with two decimals) and the settings of the rig.

    The strut's angle to the vertical is in rad, the tyre pressure in Pa. The obstacle is a single one (A) or a series
    of five (B) with a ``pitch`` from start to start in m.
    """

    number: int
    speed: float
    strut_angle: float
    tyre_pressure: float
    obstacle: Literal["A", "B"]
    pitch: float | None

    @property
    def road(self) -> str:
        """Name of the obstacle course: ``A``, or ``B`` with its pitch in centimetres, e.g. ``B10``."""
        return "A" if self.pitch is None else f"B{round(100.0 * self.pitch)}"


_SPEEDS = {
    1: 1.95, 2: 2.86, 3: 3.79, 4: 1.97, 5: 1.92, 6: 1.99, 7: 2.03, 8: 2.06,
    9: 1.92, 10: 2.90, 11: 3.87, 12: 2.03, 13: 1.97, 14: 2.01, 15: 2.01, 16: 2.01,
}  # fmt: skip
_Setting = tuple[float, float, float | None]  # angle (deg), pressure (Pa), pitch (m)
_HIGH_A: _Setting = (26.0, _HIGH, None)
_LOW_A: _Setting = (26.0, _LOW, None)
_SETTINGS: dict[str, dict[int, _Setting]] = {
    "reconstructed": dict.fromkeys((1, 2, 3), _HIGH_A)
    | {4: (26.0, _HIGH, 0.10), 5: (26.0, _HIGH, 0.15), 6: (26.0, _HIGH, 0.20)}
    | {7: (16.0, _HIGH, None), 8: (10.0, _HIGH, None)}
    | dict.fromkeys((9, 10, 11), _LOW_A)
    | {12: (16.0, _LOW, None), 13: (10.0, _LOW, None)}
    | {14: (26.0, _LOW, 0.10), 15: (26.0, _LOW, 0.15), 16: (26.0, _LOW, 0.20)},
    "literal": dict.fromkeys((1, 2, 3, 4), _HIGH_A)
    | {5: (26.0, _HIGH, 0.10), 6: (26.0, _HIGH, 0.15), 7: (26.0, _HIGH, 0.20)}
    | {8: (16.0, _LOW, None), 9: (10.0, _LOW, None)}
    | dict.fromkeys((10, 11, 14), _LOW_A)
    | {15: (26.0, _LOW, 0.10), 16: (26.0, _LOW, 0.15), 12: (26.0, _LOW, 0.20)}
    | {13: (16.0, _LOW, None)},
}


def table2(variant: Variant = "reconstructed") -> tuple[Table2Row, ...]:
    """Return the sixteen trials of Table 2 by rising number, in the consistent reading or with the cells as printed.

    As printed, an empty cell repeats the one above; the last row, which has no speed, is not a trial.

    Examples
    --------
    >>> rows = table2()
    >>> [row.number for row in rows if row.tyre_pressure == 250e3]
    [9, 10, 11, 12, 13, 14, 15, 16]
    >>> rows[3].road, table2("literal")[3].road
    ('B10', 'A')
    """
    if variant not in _SETTINGS:
        allowed = ", ".join(_SETTINGS)
        raise jn.DescriptionError(
            f"unknown reading of Table 2 {variant!r}", where="table2", allowed=allowed
        )
    rows = [
        Table2Row(
            number,
            _SPEEDS[number],
            math.radians(angle),
            pressure,
            "A" if pitch is None else "B",
            pitch,
        )
        for number, (angle, pressure, pitch) in _SETTINGS[variant].items()
    ]
    return tuple(sorted(rows, key=lambda row: row.number))
