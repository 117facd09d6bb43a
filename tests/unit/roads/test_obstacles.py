"""Obstacles against their closed forms, written out here a second time."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.core.segments import CIRCLE, POLYNOMIAL, SINE
from jounce.roads import (
    CircularSegment,
    Flat,
    HalfCylinder,
    HalfSine,
    Ramp,
    Rectangle,
    Step,
    Trapezoid,
    Triangle,
    Versine,
)

H, L = 0.010, 0.060
S = np.linspace(0.0, L, 241)[1:-1]  # inside, neither foot


@pytest.mark.parametrize(
    ("obstacle", "height", "slope"),
    [
        (
            HalfSine(height=H, length=L),
            H * np.sin(np.pi * S / L),
            H * np.pi / L * np.cos(np.pi * S / L),
        ),
        (
            Versine(height=H, length=L),
            0.5 * H * (1 - np.cos(2 * np.pi * S / L)),
            H * np.pi / L * np.sin(2 * np.pi * S / L),
        ),
        (Rectangle(height=H, length=L), np.full_like(S, H), np.zeros_like(S)),
        (
            Triangle(height=H, length=L),
            H * (1 - np.abs(2 * S / L - 1)),
            2 * H / L * np.where(S < L / 2, 1.0, -1.0),
        ),
        (
            Trapezoid(height=H, length=L, ramp=0.02),
            H * np.clip(np.minimum(S, L - S) / 0.02, 0, 1),
            H / 0.02 * (1.0 * (S < 0.02) - 1.0 * (S >= 0.04)),
        ),
        (
            HalfCylinder(radius=L / 2),
            np.sqrt((L / 2) ** 2 - (S - L / 2) ** 2),
            -(S - L / 2) / np.sqrt((L / 2) ** 2 - (S - L / 2) ** 2),
        ),
        (Ramp(height=H, length=L), H * S / L, np.full_like(S, H / L)),
        (
            Ramp(height=H, length=L, shape="cosine"),
            0.5 * H * (1 - np.cos(np.pi * S / L)),
            0.5 * H * np.pi / L * np.sin(np.pi * S / L),
        ),
    ],
    ids=lambda value: getattr(value, "kind", ""),
)
@pytest.mark.parametrize("start", [0.0, 0.2])
def test_heights_and_slopes_are_the_formulas(obstacle, height, slope, start) -> None:
    road = obstacle.model_copy(update={"start": start})
    kinks = (
        np.isclose(S, L / 2, atol=1e-9)
        | np.isclose(S, 0.02, atol=1e-9)
        | np.isclose(S, 0.04, atol=1e-9)
    )
    np.testing.assert_allclose(road.height_at(start + S), height, rtol=0, atol=1e-15)
    np.testing.assert_allclose(road.slope_at(start + S)[~kinks], slope[~kinks], rtol=0, atol=1e-11)
    assert road.end() == pytest.approx(start + L, abs=1e-15)


def test_a_circular_segment_is_part_of_a_circle_through_feet_and_crest() -> None:
    # domain D2 (Watts hump 3.7 m x 0.1 m): R = (l^2/4 + h^2)/(2h) = (3.4225 + 0.01)/0.2 = 17.1625 m
    hump = CircularSegment(height=0.1, length=3.7)
    radius = 17.1625
    x = np.linspace(0.01, 3.69, 101)
    expected = np.sqrt(radius**2 - (x - 1.85) ** 2) - (radius - 0.1)
    np.testing.assert_allclose(hump.height_at(x), expected, rtol=0, atol=1e-13)
    assert hump.profile().coefficients[0, 1] == pytest.approx(radius, rel=1e-14)
    np.testing.assert_allclose(
        hump.height_at([0.0, 1.85, 3.7]), [0.0, 0.1, 0.0], rtol=0, atol=1e-13
    )


def test_the_highest_circular_segment_is_a_half_cylinder() -> None:
    x = np.linspace(0.0, 0.06, 61)
    segment = CircularSegment(height=0.03, length=0.06)
    np.testing.assert_allclose(
        segment.height_at(x), HalfCylinder(radius=0.03).height_at(x), rtol=0, atol=1e-15
    )
    with pytest.raises(
        DescriptionError, match=r"height 0\.031 m exceeds that of a half-cylinder.*up to 0\.03 m"
    ):
        CircularSegment(height=0.031, length=0.06)
    with pytest.raises(DescriptionError, match=r"height -0\.031 m exceeds"):
        CircularSegment(height=-0.031, length=0.06)
    assert CircularSegment(height=0.0, length=1.0).height_at(0.5) == 0.0


@pytest.mark.parametrize(
    "obstacle",
    [
        HalfSine(height=-H, length=L),
        Versine(height=-H, length=L),
        Rectangle(height=-H, length=L),
        Triangle(height=-H, length=L),
        Trapezoid(height=-H, length=L, ramp=0.01),
        CircularSegment(height=-H, length=L),
        Ramp(height=-H, length=L),
        Step(height=-H),
    ],
    ids=lambda road: road.kind,
)
def test_a_negative_height_is_the_mirrored_obstacle(obstacle) -> None:
    x = np.linspace(-0.1, 0.2, 301)
    mirrored = obstacle.model_copy(update={"height": H})
    np.testing.assert_allclose(obstacle.height_at(x), -mirrored.height_at(x), rtol=0, atol=1e-16)
    assert obstacle.height_at(0.5 * L) == pytest.approx(-mirrored.height_at(0.5 * L), abs=1e-16)
    assert obstacle.height_at(0.5 * L) < -0.004


def test_level_before_and_after() -> None:
    x = np.array([-5.0, 0.0, 0.99, 1.5, 40.0])
    for closed in (
        HalfSine(height=H, length=L, start=1.0),
        HalfCylinder(radius=0.05, start=1.0),
        Flat(),
    ):
        assert closed.height_at(x).tolist() == [0.0] * 5
        assert closed.slope_at(x).tolist() == [0.0] * 5
    for open_ended in (Step(height=H, start=1.0), Ramp(height=H, length=0.3, start=1.0)):
        assert open_ended.height_at(x).tolist() == [0.0, 0.0, 0.0, H, H]


def test_edges_stand_at_every_kink_and_jump() -> None:
    road = Trapezoid(height=H, length=0.3, ramp=0.1, start=0.2)
    np.testing.assert_allclose(
        road.segments(1.0).edges, [0.0, 0.2, 0.3, 0.4, 0.5, 1.0], rtol=0, atol=1e-15
    )
    cleat = Rectangle(height=H, length=L, start=0.2).segments(1.0)
    assert cleat.kind.tolist() == [POLYNOMIAL] * 3
    assert cleat.coefficients[:, 0].tolist() == [0.0, H, 0.0]
    assert HalfSine(height=H, length=L).segments(1.0).kind.tolist() == [SINE, POLYNOMIAL]
    assert HalfCylinder(radius=0.03, start=0.1).segments(1.0).kind.tolist() == [
        POLYNOMIAL,
        CIRCLE,
        POLYNOMIAL,
    ]
    assert Step(height=H, start=0.5).segments(1.0).edges.tolist() == [0.0, 0.5, 1.0]
    assert (
        len(Trapezoid(height=H, length=0.2, ramp=0.1).segments(0.2).kind) == 2
    )  # ramps meet: no plateau


def test_pieces_stop_at_the_distance_asked_for() -> None:
    road = Triangle(height=H, length=1.0, start=0.5)
    assert road.segments(0.3).edges.tolist() == [0.0, 0.3]
    assert road.segments(0.75).edges.tolist() == [0.0, 0.5, 0.75]
    assert road.segments(1.2).edges.tolist() == [0.0, 0.5, 1.0, 1.2]
    for distance in (0.0, -1.0, np.nan, np.inf):
        with pytest.raises(DescriptionError, match="above 0 m"):
            road.segments(distance)


def test_a_wheel_that_starts_on_an_obstacle_starts_at_its_height() -> None:
    assert Rectangle(height=H, length=L).segments(1.0).evaluate(np.array([0.0]))[0].tolist() == [H]
    assert Step(height=H).segments(1.0).edges.tolist() == [0.0, 1.0]
    assert Step(height=H).height_at(0.0) == H


def test_an_obstacle_recurs_with_the_belt_loop() -> None:
    # domain A1: belt loop 1.97 m; at 1.95 m/s it comes again every 1.010 s
    road = HalfSine(height=H, length=L, start=0.2, recurrence="1.97 m")
    x = np.linspace(0.0, 1.96, 300)
    for lap in (1, 2, 7):
        np.testing.assert_allclose(
            road.height_at(x + lap * 1.97), road.height_at(x), rtol=0, atol=1e-13
        )
    edges = road.segments(6.0).edges
    np.testing.assert_allclose(edges[1:-1], [0.2, 0.26, 2.17, 2.23, 4.14, 4.2], rtol=0, atol=1e-12)
    assert np.diff(road.segments(6.0).in_time(1.95).edges[[1, 3]])[0] == pytest.approx(
        1.010, abs=5e-4
    )
    assert road.end() == 0.26


def test_an_obstacle_as_long_as_the_loop_leaves_no_gap() -> None:
    road = Versine(height=H, length="0.3 m", recurrence="300 mm")
    segments = road.segments(0.9)
    assert segments.kind.tolist() == [SINE] * 3
    np.testing.assert_allclose(segments.edges, [0.0, 0.3, 0.6, 0.9], rtol=0, atol=1e-15)
    assert (
        np.diff(HalfSine(height=H, length=0.1, recurrence=0.1).segments(100.0).edges) > 0.0
    ).all()


@pytest.mark.parametrize(
    ("build", "says"),
    [
        (
            lambda: HalfSine(height=H, length=0),
            r"length: out of range; found 0; allowed: above 0 m",
        ),
        (lambda: HalfSine(height="10 mm", length="-60 mm"), "length: out of range"),
        (lambda: HalfSine(height="10", length=L), "height: the unit is missing"),
        (lambda: HalfSine(height="10 N", length=L), "height: wrong unit"),
        (lambda: HalfSine(height=float("nan"), length=L), "height: not a finite number"),
        (lambda: HalfSine(height=H, length=L, start="-1 m"), "start: out of range"),
        (lambda: HalfSine(height=H, lenght=L), r"lenght: unknown key.*Did you mean 'length'"),
        (
            lambda: HalfSine(height=H, length=L, recurrence="59 mm"),
            r"recurrence 0\.059 m is shorter",
        ),
        (lambda: HalfSine(height=H, length=L, recurrence=0), "recurrence: out of range"),
        (
            lambda: Step(height=H, recurrence=2),
            r"cannot recur: it ends 0\.01 m higher than it begins",
        ),
        (lambda: Ramp(height=H, length=L, recurrence=2), "cannot recur"),
        (
            lambda: Ramp(height=H, length=L, shape="round"),
            r"shape: .*'linear' or 'cosine'; found 'round'",
        ),
        (
            lambda: Trapezoid(height=H, length=L, ramp=0.031),
            r"two ramps of 0\.031 m do not fit.*up to 0\.03 m",
        ),
        (lambda: Trapezoid(height=H, length=L, ramp=0), "ramp: out of range"),
        (lambda: HalfCylinder(radius=-0.1), "radius: out of range"),
        (lambda: Flat().height_at([0.0, np.nan]), "invalid distance"),
    ],
)
def test_refuses(build, says) -> None:
    with pytest.raises(DescriptionError, match=f"(?s){says}"):
        build()


def test_shapes_of_arguments_are_kept() -> None:
    road = HalfSine(height=H, length=L)
    assert np.shape(road.height_at(0.03)) == ()
    assert road.height_at(np.zeros((2, 3))).shape == (2, 3)
    assert road.slope_at([]).shape == (0,)


@pytest.mark.parametrize(
    "change", [{"speed": 1e-12}, {"speed": 1e-300}, {"duration": 1e-300}, {"duration": 5e-324}]
)
def test_a_course_shorter_than_rounding_is_level(change: dict[str, float]) -> None:
    """It was an internal error."""
    trial = jn.Trial(
        **{"road": jn.HalfSine(height="5 mm", length="0.1 m"), "speed": 1.0, "duration": 0.3}
        | change
    )
    found = trial.segments(0.0, "left")
    assert found.edges.tolist() == [0.0, trial.duration]
    assert not np.any(found.coefficients)
