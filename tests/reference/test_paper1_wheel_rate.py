"""Wheel rate and body frequency of the prototype by strut angle (spring 22730 N/m, tyre 138468 N/m, 16 kg).

Computed from wheel rate = rate cos^2(angle) and sqrt(k/m)/2 pi, alone and with the tyre in series; printed digits.
"""

from __future__ import annotations

import numpy as np
import pytest

import jounce
from jounce import parts

pytestmark = pytest.mark.source(
    kind="computed",
    of="quarter car",
    key="quarter-car-prototype",
    where="section 5: spring, tyre, strut angles; closed form",
    tolerance="half a unit of the last printed digit",
)

KART = parts.load("kart-quarter-car")
# strut angle deg: wheel rate N/m, Hz on a rigid tyre, Hz with the tyre in series
TABLE = {
    10: (22044.6, 5.908, 5.487),
    16: (21003.1, 5.766, 5.373),
    21: (19810.8, 5.600, 5.238),
    26: (18362.0, 5.392, 5.066),
    30: (17047.5, 5.195, 4.902),
}


@pytest.mark.parametrize("angle", TABLE)
def test_wheel_rate_from_statics(angle):
    """10 N more on the body lower it by 10 N over wheel rate and tyre in series."""
    rate, _, _ = TABLE[angle]
    rig = KART.with_changes({"strut.angle": f"{angle} deg"})
    heavier = rig.with_changes({"sprung.mass": 16.0 + 10.0 / 9.81})
    before, after = jounce.equilibrium(rig), jounce.equilibrium(heavier)
    sunk = (before["sprung.z"] - before["unsprung.z"]) - (after["sprung.z"] - after["unsprung.z"])
    assert 10.0 / sunk == pytest.approx(rate, abs=0.051)
    assert (before["sprung.z"] - after["sprung.z"]) * (
        rate * 138468.0 / (rate + 138468.0)
    ) == pytest.approx(10.0, rel=1e-5)


@pytest.mark.parametrize("angle", TABLE)
def test_body_frequency(angle):
    """A wheel without mass and a strut without damping leave one mass on one or two springs."""
    _, rigid, in_series = TABLE[angle]
    light = KART.with_changes(
        {"strut.angle": f"{angle} deg", "unsprung.mass": 1e-5, "strut.damper.coefficient": 0.0}
    )
    assert jounce.modes(light)[0].frequency_hz == pytest.approx(in_series, abs=0.00051)
    stiff = light.with_changes({"tyre.stiffness": 1e12})
    assert jounce.modes(stiff)[0].frequency_hz == pytest.approx(rigid, abs=0.00051)


@pytest.mark.no_source
def test_damping_follows_the_same_square():
    """A strut at 26 deg is an upright one with rate and coefficient times cos^2."""
    square = np.cos(np.radians(26.0)) ** 2
    upright = KART.with_changes(
        {
            "strut.angle": 0.0,
            "strut.spring.rate": 22730.0 * square,
            "strut.damper.coefficient": 150.0 * square,
        }
    )
    for a, b in zip(jounce.modes(KART), jounce.modes(upright), strict=True):
        assert (a.frequency_hz, a.damping_ratio) == pytest.approx(
            (b.frequency_hz, b.damping_ratio), rel=1e-10
        )
