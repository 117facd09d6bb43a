"""What sensors and users did on benches of the foreign simulator is named, or counted by the interval."""

from __future__ import annotations

from typing import Any

import foreign_benches
import foreign_counts
import foreign_faults
import pytest

import jounce as jn

DISTANCE, HIGH_PASS = "distance to the moving road", "after a high-pass filter"


def said(bench: Any, motions: Any, text: str, **options: Any) -> list[tuple[str, float]]:
    """Places and values of the findings of an update that hold a text."""
    start = foreign_benches.starts(bench, foreign_benches.true_values(bench, motions))
    trials = foreign_counts.fit_trials(bench, motions, start)
    found = jn.update_model(
        trials, foreign_counts.FREE, weights="normalised", align="lag", **options
    )
    return [
        (one.place, one.value)
        for one in found.findings
        if text in one.message and one.severity == "warning"
    ]


@pytest.mark.parametrize("ahead", [0.0, pytest.param(0.03, marks=pytest.mark.slow)])
@pytest.mark.slow
def test_a_laser_that_measures_to_the_road_is_named(ahead: float) -> None:
    bench = foreign_faults.with_laser(foreign_benches.drawn(3))
    (motions,) = foreign_benches.run([bench])
    assert said(bench, motions, DISTANCE) == []
    ((place, times),) = said(bench, foreign_faults.to_the_road(bench, motions, ahead), DISTANCE)
    assert place == foreign_faults.LASER
    assert times == pytest.approx(1.0, abs=0.1)


@pytest.mark.slow
def test_a_high_pass_that_nobody_stated_is_named() -> None:
    bench = foreign_benches.drawn(3)
    (motions,) = foreign_benches.run([bench])
    assert said(bench, motions, HIGH_PASS) == []
    ((place, corner),) = said(
        bench, foreign_faults.with_high_pass(motions, "sprung.az", 1.0), HIGH_PASS
    )
    assert place == "sprung.az"
    assert corner == pytest.approx(1.0, rel=0.3)


@pytest.mark.parametrize("factor", [1.1, pytest.param(0.9, marks=pytest.mark.slow)])
def test_a_wrong_height_is_named_and_no_wrong_value_is_called_identified(factor: float) -> None:
    bench = foreign_faults.stated_higher(foreign_benches.drawn(4), factor)
    (motions,) = foreign_benches.run([bench])
    line = foreign_counts.updated(bench, motions, {})
    ((_, _, message),) = [finding for finding in line["findings"] if finding[0] == "height"]
    assert ("lower" if factor > 1.0 else "higher") in message
    assert foreign_counts.wrongs(line) == []
