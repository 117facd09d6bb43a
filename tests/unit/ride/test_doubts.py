"""Accelerations that no ride makes are told, those of rides are not: truths made in NumPy alone."""

from __future__ import annotations

from types import ModuleType

import numpy as np
import pytest

from jounce.ride.doubts import doubts


@pytest.fixture(scope="module")
def rides() -> ModuleType:
    import ride_variants

    return ride_variants


@pytest.mark.parametrize("corner", ["car", "van", "kart"])
@pytest.mark.parametrize("road", ["good", "poor"])
@pytest.mark.parametrize("speed", [8.0, 12.0, 25.0])
def test_a_ride_is_not_doubted_and_its_wrong_records_are(
    rides: ModuleType, corner: str, road: str, speed: float
) -> None:
    run = rides.ride(corner, road, speed, 5)
    body, wheel = run["sprung.az"], run["unsprung.az"]

    def said(one: np.ndarray, other: np.ndarray = wheel) -> str:
        found = list(doubts({"sprung.az": one, "unsprung.az": other}, rides.RATE))
        assert {finding.severity for finding in found} <= {"warning"}
        return "; ".join(finding.message for finding in found)

    assert said(body) == said(-body + 9.81) == ""
    assert "low pass" in said(rides.filtered(body, 5.0, 2))
    assert "high pass" in said(rides.filtered(body, 3.0, 2, high=True))
    assert "exchanged" in said(wheel, body)
    step = 1.7 * body.std()
    assert "coarse" in said(np.round(body / step) * step)
    assert "m/s^2 called g" in said(40.0 / body.std() * body)
    assert list(doubts({"seat.az": rides.filtered(body, 5.0, 2)}, rides.RATE)) == []
    short = round(9.0 * rides.RATE)
    assert "pass" not in "".join(
        one.message for one in doubts({"sprung.az": rides.filtered(body, 5.0, 2)[:short]}, 500.0)
    )


def test_of_a_car_only_what_no_file_tells_is_silent(rides: ModuleType) -> None:
    counted = rides.outcomes(("car",))
    assert {kind for kind, found in counted.items() if "silently wrong" in found} == {
        "m/s² called g", "g called m/s²", "high pass"
    }  # fmt: skip
    silent = [name for found in counted.values() for name in found.get("silently wrong", ())]
    assert all("order 1" in name or ": g" in name or ": m/s^2" in name for name in silent)
    assert set(counted["right"]) == set(counted["sign, datum"]) == set(counted["unit"]) == {"right"}
    assert set(counted["exchanged"]) == {"told"}
