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
@pytest.mark.some(4)
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
    assert "low-pass filter" in said(rides.filtered(body, 5.0, 2))
    assert "high-pass filter" in said(rides.filtered(body, 3.0, 2, high=True))
    assert "swapped" in said(wheel, body)
    step = 1.7 * body.std()
    assert "coarse" in said(np.round(body / step) * step)
    assert "m/s^2 given as g" in said(40.0 / body.std() * body)
    assert list(doubts({"seat.az": rides.filtered(body, 5.0, 2)}, rides.RATE)) == []
    short = round(9.0 * rides.RATE)
    assert "pass" not in "".join(
        one.message for one in doubts({"sprung.az": rides.filtered(body, 5.0, 2)[:short]}, 500.0)
    )


@pytest.mark.slow
def test_of_a_car_only_what_no_file_tells_is_silent(rides: ModuleType) -> None:
    counted = rides.outcomes(("car",))
    silent = {kind for kind, found in counted.items() if "silently wrong" in found}
    assert silent == set(rides.HIDDEN)
    assert set(counted["right"]) == set(counted["sign, datum"]) == set(counted["unit"]) == {"right"}
    assert set(counted["exchanged"]) == {"told"}


@pytest.mark.parametrize("corner", ["van", "kart"])
@pytest.mark.parametrize(
    ("what", "corner_hz", "order", "high"),
    [
        ("low", 5.0, 1, False),
        ("low", 10.0, 1, False),
        ("second-order low", 10.0, 2, False),
        ("high", 3.0, 1, True),
    ],
)
def test_a_body_behind_a_gentle_filter_follows_its_wheel_otherwise(
    rides: ModuleType, corner: str, what: str, corner_hz: float, order: int, high: bool
) -> None:
    run = rides.ride(corner, "good", 25.0, 5)
    body, wheel = run["sprung.az"], run["unsprung.az"]
    behind = rides.filtered(body, corner_hz, order, high=high)
    found = [
        one
        for one in doubts({"sprung.az": behind, "unsprung.az": wheel}, rides.RATE)
        if "follows" in one.message
    ]
    assert [f"after a {what}-pass filter at about" in one.message for one in found] == [True]
    assert found[0].value == pytest.approx(corner_hz, rel=0.1)
    assert list(doubts({"sprung.az": body, "unsprung.az": wheel}, rides.RATE)) == []


def test_a_body_that_shakes_by_itself_is_not_taken_for_filtered(rides: ModuleType) -> None:
    run, other = rides.ride("car", "good", 25.0, 5), rides.ride("car", "good", 25.0, 6)
    behind = rides.filtered(other["sprung.az"], 5.0, 1)
    found = doubts({"sprung.az": behind, "unsprung.az": run["unsprung.az"]}, rides.RATE)
    assert not [one for one in found if "follows" in one.message]
