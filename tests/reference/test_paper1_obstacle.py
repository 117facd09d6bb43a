"""The quarter-car prototype over its obstacle: peaks computed from the stated equations, with and without lift-off.

Values: independent computation with 16 kg on 5 kg, wheel rate 18362 N/m (22730 N/m at 26 deg), damping ratio 0.15 of
the sprung mass on the wheel rate, tyre 138468 N/m (published), half-sine of 10 mm on 60 mm (assumed; the paper's
obstacle section is lost), at the paper's three speeds. Three significant digits were given.
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
    where="springs, tyre and speeds of sections 3 to 6; obstacle assumed; equations solved beside jounce",
    tolerance="three digits",
)

# speed: peak |sprung.az| m/s^2 and largest rise of the body mm with lift-off; the same without
PEAKS = {
    1.95: (19.8, 12.94, 26.5, 5.60),
    2.86: (20.7, 13.34, 26.0, 4.05),
    3.79: (19.9, 12.18, 22.3, 3.14),
}
WHEEL_DAMPING = 2.0 * 0.15 * np.sqrt(18362.0 * 16.0)  # 162.6 N s/m at the wheel
KART = parts.load("kart-quarter-car").with_changes(
    {
        "strut.damper.coefficient": WHEEL_DAMPING / np.cos(np.radians(26.0)) ** 2
    }  # 201.3 N s/m in the strut
)


@pytest.mark.parametrize("start", [0.0, 0.1, 0.5])
@pytest.mark.parametrize("speed", PEAKS)
def test_peaks(speed, start):
    """Where the obstacle begins does not matter."""
    trial = jounce.Trial(
        road=jounce.HalfSine(height=0.01, length=0.06, start=start), speed=speed, duration=1.5
    )
    *with_lift_off, acceleration, rise = PEAKS[speed]
    for changes, (peak, height) in (
        ({}, with_lift_off),
        ({"tyre.lift_off": False}, (acceleration, rise)),
    ):
        run = jounce.simulate(KART.with_changes(changes), trial, output_step=2e-4)
        assert float(abs(run["sprung.az"]).max()) == pytest.approx(peak, abs=0.051)
        assert float(run["sprung.z"].max() - run["sprung.z"][0]) * 1e3 == pytest.approx(
            height, abs=0.0051
        )
        assert (float(run["tyre.force"].min()) == 0.0) == (not changes)


@pytest.mark.no_source
def test_without_lift_off_the_tyre_would_pull():
    trial = jounce.Trial(road=jounce.HalfSine(height=0.01, length=0.06), speed=1.95, duration=1.0)
    run = jounce.simulate(KART.with_changes({"tyre.lift_off": False}), trial)
    assert float(run["tyre.force"].min()) < -100.0


@pytest.mark.parametrize(
    ("stiffness", "expected"),
    [
        (138468.0, ((5.078, 0.1235), (28.12, 0.0985))),
        (125800.0, ((5.048, None), (26.97, None))),
    ],
)
def test_modes(stiffness, expected):
    """Body bounce and wheel hop at 0.31 and 0.25 MPa, Hz and damping ratio; four digits were given."""
    found = jounce.modes(KART.with_changes({"tyre.stiffness": stiffness}))
    for mode, (frequency, ratio) in zip(found, expected, strict=True):
        assert mode.frequency_hz == pytest.approx(
            frequency, abs=0.0051 if frequency > 10 else 0.00051
        )
        if ratio is not None:
            assert mode.damping_ratio == pytest.approx(ratio, abs=0.000051)
