"""The passenger car's corner on a plate: modes, and response at 5 Hz.

Computed from the equations of motion with 460 kg on 45 kg (assumed), 38 N/mm, 2 N s/mm, tyre 300 N/mm with and without
the printed tyre damping of 1 N s/mm; printed digits. Contact force per plate amplitude in N/mm.
"""

from __future__ import annotations

import numpy as np
import pytest

import jounce
from jounce import parts

pytestmark = pytest.mark.source(
    kind="computed",
    of="quarter car",
    key="suspension-system",
    where="Table 1, 45 kg of wheel assumed; equations solved beside jounce",
    tolerance="half a unit of the last printed digit",
)

AUDI = parts.load("audi-a6-quarter-car")
MODES = {1000.0: ((1.3749, 0.2022), (13.672, 0.3930)), 0.0: ((1.3766, 0.2010), (13.655, 0.2641))}
AT_5_HZ = {1000.0: (0.1729, 0.9905, 1.0689, 73.79), 0.0: (0.1774, 1.0162, 1.0966, 75.70)}


@pytest.mark.parametrize("coefficient", MODES)
def test_modes(coefficient):
    found = jounce.modes(AUDI.with_changes({"tyre.damping_coefficient": coefficient}))
    for mode, (frequency, ratio) in zip(found, MODES[coefficient], strict=True):
        assert mode.frequency_hz == pytest.approx(
            frequency, abs=0.00051 if frequency > 10 else 0.000051
        )
        assert mode.damping_ratio == pytest.approx(ratio, abs=0.000051)


@pytest.mark.parametrize("coefficient", AT_5_HZ)
def test_response_at_5_hz(coefficient):
    model = jounce.linearise(AUDI.with_changes({"tyre.damping_coefficient": coefficient}))
    body, wheel, strut, force = (
        abs(model.frequency_response([5.0], name)[0])
        for name in ("sprung.z", "unsprung.z", "strut.deflection", "tyre.force")
    )
    expected = AT_5_HZ[coefficient]
    assert (body, wheel, strut) == pytest.approx(expected[:3], abs=0.000051)
    assert force * 1e-3 == pytest.approx(expected[3], abs=0.0051)


def test_static_deflections():
    """Spring and tyre act in series: 118.75 mm and 15.04 mm for 460 kg, together 133.79 mm."""
    rest = jounce.equilibrium(AUDI.with_changes({"unsprung.mass": 1e-6}))
    assert rest["strut.deflection"] * 1e3 == pytest.approx(118.75, abs=0.0051)
    assert rest["tyre.deflection"] * 1e3 == pytest.approx(15.04, abs=0.0051)
    assert -rest["sprung.z"] * 1e3 == pytest.approx(133.79, abs=0.0051)
    assert rest["tyre.force"] == pytest.approx(4512.6, abs=0.051)


def test_the_plate_at_5_hz_in_time():
    """A run of some seconds settles to the response of the linear model."""
    time = np.linspace(0.0, 6.0, 1201)
    plate = jounce.Excitation(time=tuple(time), height=tuple(1e-3 * np.sin(2 * np.pi * 5.0 * time)))
    run = jounce.simulate(AUDI, jounce.Trial(excitation=plate), tolerance=1e-6)
    steady = run["unsprung.z"].where(run["time"] > 5.0, drop=True)
    assert float(steady.max() - steady.min()) / 2e-3 == pytest.approx(0.9905, abs=0.001)
