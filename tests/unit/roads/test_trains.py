"""Trains: lengths, edges, stairs, what they take over from their obstacle."""

from __future__ import annotations

import numpy as np
import pytest

from jounce.core.errors import DescriptionError
from jounce.roads import HalfSine, Ramp, Rectangle, Step, Table, Train, Triangle

A = HalfSine(height="10 mm", length="60 mm", start="0.2 m")


@pytest.mark.parametrize("pitch", [0.10, 0.15, 0.20])
def test_train_length_is_four_pitches_and_one_obstacle(pitch) -> None:
    # domain A8: train length = 4 x + l for the five obstacles of profile B, x = 0.10, 0.15, 0.20 m (Table 2)
    train = Train(of=A, count=5, pitch=pitch)
    assert train.end() - train.start == pytest.approx(4 * pitch + 0.06, abs=1e-14)
    x = np.linspace(0.0, 1.5, 4001)
    expected = sum(A.height_at(x - k * pitch) for k in range(5))
    np.testing.assert_allclose(train.height_at(x), expected, rtol=0, atol=1e-15)
    starts = 0.2 + pitch * np.arange(5)
    np.testing.assert_allclose(
        train.segments(2.0).edges[1:-1], np.sort([*starts, *(starts + 0.06)]), rtol=0, atol=1e-14
    )


def test_touching_obstacles_leave_no_gap_and_no_jump() -> None:
    train = Train(of=Triangle(height=0.01, length="60 mm"), count=40, pitch="0.06 m")
    segments = train.segments(3.0)
    assert len(segments.kind) == 81
    assert (np.diff(segments.edges) > 0.02).all()


def test_start_and_recurrence_come_from_the_obstacle_unless_given() -> None:
    belt = A.model_copy(update={"recurrence": 1.97})
    assert Train(of=belt, count=5, pitch=0.1).start == 0.2
    assert Train(of=belt, count=5, pitch=0.1).recurrence == 1.97
    own = Train(of=belt, count=5, pitch=0.1, start="1 m", recurrence="3 m")
    assert (own.start, own.recurrence) == (1.0, 3.0)
    np.testing.assert_allclose(own.height_at([1.03, 4.03, 7.43]), [0.01] * 3, rtol=0, atol=1e-12)
    assert Train(of=belt, count=1, pitch=1, recurrence=None).recurrence is None


def test_steps_and_ramps_climb() -> None:
    stairs = Train(of=Step(height="0.1 m"), count=3, pitch="0.5 m", start="1 m")
    assert stairs.height_at([0.9, 1.0, 1.6, 2.0, 9.0]).round(15).tolist() == [
        0.0,
        0.1,
        0.2,
        0.3,
        0.3,
    ]
    assert stairs.end() == 2.0
    ramps = Train(of=Ramp(height=-0.1, length=1), count=2, pitch=2)
    np.testing.assert_allclose(
        ramps.height_at([0.5, 1.5, 2.5, 9]), [-0.05, -0.1, -0.15, -0.2], rtol=0, atol=1e-15
    )
    with pytest.raises(DescriptionError, match="cannot recur"):
        Train(of=Step(height=0.1), count=3, pitch=0.5, recurrence=10)


def test_trains_of_trains_and_of_tables() -> None:
    groups = Train(of=Train(of=A, count=2, pitch=0.1), count=2, pitch=1.0, start=0.0)
    x = np.linspace(0, 2, 1001)
    expected = sum(A.height_at(x + 0.2 - at) for at in (0.0, 0.1, 1.0, 1.1))
    np.testing.assert_allclose(groups.height_at(x), expected, rtol=0, atol=1e-14)
    waves = Train(of=Table(x=[0.5, 1.0, 1.5], height=[0.0, 0.01, 0.0]), count=3, pitch=1.0)
    assert waves.height_at([0.4, 1.0, 1.5, 2.0, 3.0, 4.0]).round(15).tolist() == [
        0.0,
        0.01,
        0.0,
        0.01,
        0.01,
        0.0,
    ]
    assert waves.end() == 3.5


def test_recurring_trains_repeat_as_a_whole() -> None:
    train = Train(of=A, count=5, pitch=0.15, recurrence=1.97)
    x = np.linspace(0, 1.96, 500)
    np.testing.assert_allclose(
        train.height_at(x + 3 * 1.97), train.height_at(x), rtol=0, atol=1e-13
    )


@pytest.mark.parametrize(
    ("options", "says"),
    [
        (
            {"count": 5, "pitch": "59 mm"},
            r"overlap: the pitch 0\.059 m .* shorter than the obstacle length 0\.06 m.*at least 0\.06 m",
        ),
        ({"count": 0, "pitch": 1}, "count: .*greater than or equal to 1"),
        ({"count": 2.5, "pitch": 1}, "count: .*valid integer"),
        ({"count": True, "pitch": 1}, "count: .*valid integer"),
        ({"count": 2, "pitch": 0}, "pitch: out of range"),
        ({"count": 2}, "pitch: the key is missing"),
        (
            {"count": 5, "pitch": 0.1, "recurrence": 0.45},
            r"recurrence 0\.45 m is shorter than its length 0\.46 m",
        ),
    ],
)
def test_refuses(options, says) -> None:
    with pytest.raises(DescriptionError, match=says):
        Train(of=A, **options)


def test_of_may_be_a_table_with_errors_at_its_path() -> None:
    table = {"kind": "rectangle", "height": "10 mm", "length": "60 mm"}
    assert Train(of=table, count=1, pitch=1).of == Rectangle(height=0.01, length=0.06)
    with pytest.raises(
        DescriptionError,
        match=r"^of\.lenght: unknown key; allowed: height, kind, length, recurrence, s",
    ):
        Train(of={"kind": "rectangle", "height": 1, "length": 1, "lenght": 1}, count=1, pitch=1)
    with pytest.raises(
        DescriptionError, match=r"^of: unknown kind 'rectangel'; .*Did you mean 'rectangle'\?$"
    ):
        Train(of={"kind": "rectangel"}, count=1, pitch=1)
    with pytest.raises(
        DescriptionError, match=r"^of: the key 'kind', which selects the kind, is missing"
    ):
        Train(of={"height": 1}, count=1, pitch=1)


def test_a_train_is_equal_to_what_its_plain_form_gives_back() -> None:
    train = Train(of=A, count=5, pitch=0.1)
    assert Train.model_validate(train.model_dump()) == train
    assert Train.model_validate_json(train.model_dump_json()) == train
