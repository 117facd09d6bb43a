"""What is said of trials, on both sides of every limit; and guards of heights that were measured."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest

from jounce.core.errors import DescriptionError, RecordingError
from jounce.parts import load
from jounce.parts.vehicles import track_width
from jounce.roads import HalfSine, Iso8608, Step, Table, Train, Trial
from jounce.roads.measured import HIGHEST, _check_heights, check_source
from jounce.roads.profile import _advance, passes, periodic_places
from jounce.roads.trial import FASTEST, trial_findings

BUMP = HalfSine(height="10 mm", length="60 mm", start="2 m")
FINE = Table(x=np.arange(0.0, 4.01, 0.1), height=np.zeros(41))


def said(trial: Trial, rig=None, **more) -> list[tuple[str, str]]:
    assert {one.severity for one in trial_findings(trial, rig, **more)} <= {"warning", "note"}
    return [(one.place, one.message) for one in trial_findings(trial, rig, **more)]


def test_a_run_that_ends_before_the_obstacle_begins() -> None:
    assert said(Trial(road=BUMP, speed=2.0, duration=1.01)) == []
    ((place, text),) = said(Trial(road=BUMP, speed=2.0, duration=1.0))
    assert place == "trial: road"
    assert text.startswith("the run ends before the obstacle begins, 2 m from the start")
    ((place, _),) = said(
        Trial(road=HalfSine(height=0.01, length=0.06), right=BUMP, speed=2.0, duration=0.9)
    )
    assert place == "trial: right"


def test_a_road_that_ends_before_the_run_does() -> None:
    assert said(Trial(road=FINE, speed=4.0, duration=1.0)) == []
    ((_, text),) = said(Trial(road=FINE, speed=4.0, duration=1.01))
    assert (
        text
        == "the road ends after 4 m, but the run covers 4.04 m; the remainder is level. Shorten the run."
    )
    assert (
        said(Trial(road=FINE.model_copy(update={"recurrence": 5.0}), speed=4.0, duration=9.0)) == []
    )


def test_points_too_far_apart_to_show_wheel_hop() -> None:
    slowest = 2.0 * 0.1 * FASTEST
    assert said(Trial(road=FINE, speed=1.001 * slowest, duration=1.0)) == []
    ((_, text),) = said(Trial(road=FINE, speed=2.0, duration=1.0))
    assert text.startswith(
        "its points, 0.1 m apart, contain nothing above 10 Hz at 2 m/s; wheel hop is at about 15 Hz"
    )


def test_obstacles_that_pass_between_two_samples() -> None:
    trial = Trial(road=BUMP, speed=2.0, duration=3.0)
    assert said(trial) == said(trial, output_step=0.0075) == []
    ((_, text),) = said(trial, output_step=0.0076)
    assert text.startswith(
        "the obstacle passes in 30 ms and the result has a sample every 7.6 ms; its peaks are missed"
    )
    assert said(Trial(road=Step(height=0.01), speed=2.0, duration=3.0), output_step=1.0) == []
    assert said(Trial(road=FINE, speed=3.5, duration=1.0), output_step=1.0) == []


def test_a_run_that_ends_before_the_rear_axle_meets_the_obstacle() -> None:
    car = load("audi-a6-half-car-4dof")
    enough = (2.0 + car.wheelbase) / 4.0
    assert said(Trial(road=BUMP, speed=4.0, duration=enough + 0.01), car) == []
    ((place, text),) = said(Trial(road=BUMP, speed=4.0, duration=enough - 0.01), car)
    assert place == "trial: duration"
    assert (
        text
        == f"the run ends before the rear axle, {car.wheelbase:g} m behind, meets the obstacle."
    )
    assert (
        said(Trial(road=BUMP, speed=4.0, duration=enough - 0.01), load("audi-a6-quarter-car")) == []
    )
    assert (
        said(Trial(road=FINE, speed=4.0, duration=0.5), car) == []
    )  # a course is met from the start


def test_loads_that_set_in_too_late() -> None:
    calm = {"road": BUMP, "speed": 4.0, "duration": 2.0}
    assert said(Trial(**calm, deceleration={"value": 3.0, "start": 1.99})) == []
    assert said(Trial(**calm, deceleration={"value": 0.0, "start": 3.0})) == []
    ((place, text),) = said(Trial(**calm, deceleration={"value": 3.0, "start": 2.5}))
    assert (place, text) == ("trial: deceleration", "it starts after the end of the run of 2 s.")
    assert (
        said(Trial(**calm, pitch_moment={"time": [0.5, 1.0, 1.5], "values": [0.0, 5.0, 0.0]})) == []
    )
    assert len(said(Trial(**calm, pitch_moment={"time": [2.5, 3.0], "values": [0.0, 5.0]}))) == 1


def test_both_sides_on_one_track_are_told() -> None:
    road = Iso8608(class_="C", length=60.0)
    car = load("audi-a6-full-car")
    assert said(Trial(road=road, right=road.other_track(), speed=20.0, duration=2.0), car) == []
    ((_, text),) = said(Trial(road=road, speed=20.0, duration=2.0), car)
    assert text.startswith("the left and the right wheels follow the same track")
    assert said(Trial(road=road, speed=20.0, duration=2.0), load("audi-a6-half-car-4dof")) == []
    assert said(Trial(road=road, speed=20.0, duration=2.0)) == []


def test_tracks_that_are_not_as_far_apart_as_the_wheels_are_told() -> None:
    for car in map(load, ("audi-a6-full-car", "formula-student-car")):
        wide = track_width(car)
        for share, told in ((0.94, True), (0.96, False), (1.04, False), (1.06, True)):
            road = Iso8608(class_="C", length=60.0, track=share * wide)
            found = said(Trial(road=road, right=road.other_track(), speed=20.0, duration=2.0), car)
            assert [place for place, text in found if "tracks are" in text] == [
                "trial: right"
            ] * told
    apart = Iso8608(class_="C", length=60.0, track=0.5)
    assert (
        said(
            Trial(road=apart.other_track(), speed=20.0, duration=2.0), load("audi-a6-half-car-4dof")
        )
        == []
    )


def test_times_of_obstacles_and_courses() -> None:
    train = Trial(road=Train(of=BUMP, count=3, pitch="0.5 m"), speed=2.0, duration=3.0)
    assert train.end() == train.obstacle_end() == pytest.approx(0.5 * (2.0 + 2 * 0.5 + 0.06))
    course = Trial(road=FINE, speed=2.0, duration=3.0)
    assert (course.end(), course.obstacle_end()) == (2.0, 0.0)


@pytest.mark.parametrize(
    ("height", "words"),
    [
        ([0.0, 0.0, 1.001, 0.0], r"a single height at u = 12 m stands out by 1 m"),
        ([0.0, 0.0, -1.001, 0.0], r"u = 12 m stands out"),
        ([250.0, 250.0, 251.001, 250.0], r"u = 12 m stands out by 1 m"),  # above the sea
        ([0.0, 0.0, 0.999, 0.0], None),
        ([0.0, 0.0, 1.5, 1.5], None),  # a bank, no spike
        ([0.0, 0.0, 2.5, 0.999], r"u = 12 m stands out by 2.5 m"),
        ([0.0, 0.0, 2.5, 1.001], None),
        ([0.0, HIGHEST, HIGHEST, HIGHEST], None),
        ([0.0, 1.0001 * HIGHEST, HIGHEST, HIGHEST], "heights above 10 km"),
        ([0.0, 2e-29, 0.0, 0.0], "heights below 1e-28 m"),
        ([0.0, 2e-28, 0.0, 0.0], None),
        ([0.0, math.nan, 0.0, 0.0], r"no height at u = 11 m for the lateral offset 0.3 m"),
    ],
)
def test_heights_that_no_survey_yields(height, words) -> None:
    road = SimpleNamespace(z=np.array(height)[:, None], u=np.arange(10.0, 14.0))
    if words is None:
        _check_heights(road, np.array(height), 0.3, "course.crg")
        return
    with pytest.raises(RecordingError, match=words):
        _check_heights(road, np.array(height), 0.3, "course.crg")


@pytest.mark.parametrize(
    ("second", "jumps"),
    [
        ("1,1.5", False),
        ("0.1,1.01", True),
        ("0.1,0.99", False),
        ("0.2,-2.1", True),
        ("0.2,1.99", False),
    ],
)
def test_padding_jumps(tmp_path, second, jumps) -> None:
    """More than a metre, and steeper than ten to one."""
    (tmp_path / "lane.csv").write_text(f"x [m],z [m]\n0,0\n{second}\n9,0\n")
    if jumps:
        with pytest.raises(
            RecordingError, match="the height jumps implausibly from row 1 to row 2; found"
        ):
            Table(file=tmp_path / "lane.csv")
    else:
        assert Table(file=tmp_path / "lane.csv").end() == 9.0


def test_sources_of_points() -> None:
    for count, interpolation in ((2, "linear"), (4, "cubic")):
        x = tuple(float(i) for i in range(count))
        check_source(None, {"x": x, "height": x}, interpolation)
        with pytest.raises(
            ValueError,
            match=f"{count - 1} points; {interpolation} interpolation needs at least {count}",
        ):
            check_source(None, {"x": x[1:], "height": x[1:]}, interpolation)


def test_how_far_a_run_may_go() -> None:
    rising = Table(x=[0.0, 4.0], height=[0.0, 0.1])
    assert FINE.ends_level()
    assert not rising.ends_level()
    for rise, is_level in ((0.95e-6, True), (-0.95e-6, True), (1.05e-6, False), (-1.05e-6, False)):
        assert Table(x=[0.0, 4.0], height=[0.2, 0.2 + rise]).ends_level() is is_level
    assert (
        HalfSine(height=0.01, length=0.06, recurrence=0.06).recurrence == 0.06
    )  # one behind the other
    FINE.check_covers(9.0, continue_level=True)
    FINE.check_covers(5.0, behind=1.0)
    with pytest.raises(
        DescriptionError, match=r"trial: .*found '5.1 m driven'; allowed: up to 5 m"
    ):
        FINE.check_covers(5.1, behind=1.0, where="trial")
    with pytest.raises(DescriptionError, match="shorter than the run"):
        rising.check_covers(4.1, continue_level=True)


@pytest.mark.parametrize("recurrence", [1.97, 2.0])
def test_loops_come_again_until_the_end(recurrence) -> None:
    places = [place for place, _ in passes(0.3, recurrence, 9.0)]
    np.testing.assert_allclose(places, 0.3 + recurrence * np.arange(len(places)))
    assert places[-1] >= 9.0 > places[-3]
    assert list(passes(0.3, None, 9.0)) == [(0.3, 0.0)]
    assert list(passes(12.0, recurrence, 9.0)) == [(12.0, 0.0)]
    both = [place for place, _ in periodic_places(0.5, recurrence, -3.0, 5.0)]
    assert both[0] <= -3.0 < both[0] + 3.0 * recurrence
    assert both[-1] >= 5.0 - recurrence
    np.testing.assert_allclose(np.mod(np.array(both) - 0.5 + 1e-9, recurrence), 0.0, atol=1e-8)


def test_pieces_cut_at_their_front_keep_their_heights() -> None:
    from jounce.core.segments import CIRCLE, POLYNOMIAL, SINE, Segments

    for kind, c in (
        (POLYNOMIAL, [0.1, 0.2, -0.3, 0.4]),
        (SINE, [0.1, 0.2, 3.0, 0.4]),
        (CIRCLE, [-0.9, 1.1, 0.4, 1.0]),
    ):
        whole = Segments(np.array([0.0, 1.0]), np.array([kind]), np.array([c]))
        cut = Segments(
            np.array([0.0, 0.7]), np.array([kind]), _advance(kind, np.array(c), 0.3)[None, :]
        )
        at = np.linspace(0.01, 0.69, 9)
        for one, other in zip(cut.evaluate(at), whole.evaluate(at + 0.3), strict=True):
            np.testing.assert_allclose(one, other, rtol=1e-12)


def test_what_a_lumped_car_leaves_out_in_a_bend_is_said():
    level = Table(x=[0.0, 30.0], height=[0.0, 0.0])
    bend = Trial(road=level, speed=20.0, duration=1.0, lateral_acceleration=4.0)
    straight = Trial(road=level, speed=20.0, duration=1.0)
    places = [
        [found.place for found in trial_findings(trial, load(name))]
        for trial, name in (
            (bend, "audi-a6-full-car"),
            (straight, "audi-a6-full-car"),
            (bend, "formula-student-car"),
        )
    ]
    assert ["trial: lateral_acceleration" in found for found in places] == [True, False, False]
