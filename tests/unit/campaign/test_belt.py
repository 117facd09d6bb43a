"""Speeds of all trials beside each other: exchanged records, a belt of another length, pulses that disagree."""

from __future__ import annotations

import pytest

from jounce.campaign.belt import TrialOnBelt, common_speed_errors, exchanged_trials, loop_length
from jounce.identify.passages import Passages

SPEEDS = {1: 1.95, 2: 2.86, 3: 3.79, 4: 2.03}


def facts(speed: float, noted: float | None, pulses: float | None = None) -> TrialOnBelt:
    return TrialOnBelt(noted, pulses, speed, None, Passages((0.5, 1.5), (0.99, 0.99), speed, 1.0))


def trials(
    recurrence: float = 1.0, pulses: float | None = 1.0, *, noted: bool = True
) -> dict[int, TrialOnBelt]:
    """Trials whose speeds by recurrence and by pulses are so many times the noted ones."""
    return {
        number: facts(
            recurrence * speed, speed if noted else None, None if pulses is None else pulses * speed
        )
        for number, speed in SPEEDS.items()
    }


@pytest.mark.parametrize("pulses", [1.01, None])
def test_a_length_that_no_speed_agrees_with_is_doubted(pulses: float | None) -> None:
    (said,), is_in_doubt = common_speed_errors(trials(2.5 / 1.97, pulses), 2.5)
    assert is_in_doubt
    assert said.severity == "problem"
    assert said.numbers["fits"] == pytest.approx(1.97)


def test_pulses_that_neither_notes_nor_recurrence_agree_with_are_named() -> None:
    (said,), is_in_doubt = common_speed_errors(trials(0.985, 0.5), 1.97)
    assert not is_in_doubt
    assert (said.code, said.value) == ("campaign.pulses_off", pytest.approx(1.97))


@pytest.mark.parametrize("recurrence", [0.93, 0.985, 1.0, 1.01])
def test_slip_is_no_error(recurrence: float) -> None:
    assert common_speed_errors(trials(recurrence, 1.0), 1.97) == ([], False)


def test_one_wrong_note_is_no_common_error() -> None:
    some = {**trials(), 2: facts(2.86, 3.4, 2.86)}
    assert common_speed_errors(some, 1.97) == ([], False)
    assert common_speed_errors({1: facts(2.5, 1.95)}, 1.97) == ([], False)


@pytest.mark.parametrize(
    ("first", "second"), [((1.921, 1.95), (1.944, 1.92)), ((3.79, 1.95), (1.95, 3.8))]
)
def test_records_exchanged_by_their_speeds(
    first: tuple[float, float], second: tuple[float, float]
) -> None:
    (said,) = exchanged_trials({1: facts(*first), 9: facts(*second), 2: facts(2.86, 2.86)})
    assert said.place == "trials 1 and 9"


def test_speeds_noted_badly_are_not_exchanged() -> None:
    assert (
        exchanged_trials(
            {
                1: facts(1.99, 1.95),
                2: facts(2.00, 2.04),
                3: facts(1.951, 1.95),
                4: facts(1.921, 1.92),
            }
        )
        == []
    )


def test_the_length_of_a_belt_follows_from_speeds_and_passages() -> None:
    met = [
        ([0.3 + k * 1.97 / speed for k in range(5) if k != 2], speed)
        for speed in (1.95, 2.86, 3.79)
    ]
    length, scatter = loop_length(met)
    assert length == pytest.approx(1.97)
    assert scatter < 1e-9
    assert loop_length([([0.3], 1.95), ([0.1, 1.1], 1.97)]) is None
