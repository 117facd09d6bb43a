"""What holds for every road: slope = derivative, edges ascend, windows agree."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from jounce.roads import (
    ROADS,
    CircularSegment,
    Crg,
    Enveloped,
    Flat,
    HalfCylinder,
    Iso8608,
    Kerb,
    Pothole,
    Sine,
    SineSum,
    SineSweep,
    Table,
    Train,
    Trapezoid,
    Trial,
)

heights = st.floats(-0.05, 0.05).filter(
    lambda h: h == 0.0 or abs(h) > 1e-9
)  # m: circles of 1e10 m radius are rounding
lengths = st.floats(0.02, 2.0)
starts = st.floats(0.0, 3.0).filter(lambda x: x == 0.0 or x > 1e-9)


OTHERS = {Flat, Crg, Enveloped, Iso8608, SineSum, Train}
"""Roads that are no single obstacle; each has tests of its own, here or in tests/unit/roads."""
DRAWS = {
    "height": heights,
    "amplitude": heights,
    "length": lengths,
    "radius": lengths,
    "start": starts,
    "shape": st.sampled_from(["linear", "cosine"]),
}
"""What a field of an obstacle may be; those of a road of a new form are added to them."""


def table(draw, _):
    points = sorted(draw(st.sets(st.integers(0, 400), min_size=5, max_size=9)))
    own = {
        "x": [0.01 * point for point in points],
        "height": [draw(heights) for _ in points],
        "start": draw(starts),
    }
    return own | {"interpolation": draw(st.sampled_from(["linear", "cubic"]))}


DEPENDENT = {
    Trapezoid: lambda _, own: {"ramp": 0.3 * own["length"]},
    Sine: lambda draw, own: {"wavelength": 0.4 * own["length"], "phase": draw(lengths)},
    SineSweep: lambda _, own: {
        "first_wavelength": own["length"],
        "last_wavelength": 0.3 * own["length"],
    },
    Kerb: lambda _, own: {"edge_radius": 0.5 * abs(own["height"])},
    Pothole: lambda draw, _: {"depth": 0.01 + abs(draw(heights)), "edge_radius": 0.009},
    HalfCylinder: lambda _, own: {"radius": 0.5 * own["radius"]},
    CircularSegment: lambda _, own: {"height": 0.49 * own["length"] * own["height"] / 0.05},
    Table: table,
}
"""Fields that depend on others, or have a law of their own."""
OBSTACLES = [road for road in ROADS.values() if road not in OTHERS]


def fields_of(draw, road):
    """Fields of an obstacle of any class, drawn by their names."""
    own = {
        name: draw(DRAWS[name]) for name in road.model_fields if name in DRAWS and road is not Table
    }
    own |= DEPENDENT.get(road, lambda *_: {})(draw, own)
    lacking = [
        name for name, field in road.model_fields.items() if field.is_required() and name not in own
    ]
    assert not lacking, (
        f"say in DRAWS or DEPENDENT what {', '.join(lacking)} of a {road.__name__} is"
    )
    return own


@st.composite
def obstacles(draw):
    road = draw(st.sampled_from(OBSTACLES))
    return road(**fields_of(draw, road))


@st.composite
def roads(draw):
    one = draw(obstacles())
    if draw(st.booleans()):
        pitch = one.profile().span + draw(st.sampled_from([0.0, 0.3]))
        one = Train(of=one, count=draw(st.integers(1, 4)), pitch=max(pitch, 0.1))
    whole = one.profile()
    if abs(whole.after - whole.before) < 1e-9 and draw(st.booleans()):
        one = one.model_copy(
            update={"recurrence": max(whole.span, 0.1) + draw(st.sampled_from([0.0, 1.0]))}
        )
    return one


@pytest.mark.parametrize("road", OBSTACLES, ids=lambda road: road.__name__)
@settings(deadline=None, max_examples=5)
@given(st.data())
def test_every_obstacle_joins_these_tests(road, data) -> None:
    made = road(**fields_of(data.draw, road))
    assert made.height_at(made.end() + 1.0) == made.profile().after


@settings(deadline=None, max_examples=200)
@given(roads(), st.floats(0.5, 30.0))
def test_slope_is_the_derivative_of_the_height_between_edges(road, distance) -> None:
    segments = road.segments(distance)
    left, right = segments.edges[:-1], segments.edges[1:]
    for share in (0.25, 0.5, 0.8):
        x = left + share * (right - left)
        step = 1e-4 * (right - left)
        x, step = x[step > 1e-9], step[step > 1e-9]
        numeric = (segments.evaluate(x + step)[0] - segments.evaluate(x - step)[0]) / (2.0 * step)
        slope = segments.evaluate(x)[1]
        np.testing.assert_allclose(
            slope, numeric, rtol=1e-4, atol=1e-6 + 1e-15 / step.min(initial=1.0)
        )


@settings(deadline=None, max_examples=200)
@given(roads(), st.floats(0.5, 30.0), st.floats(0.2, 40.0))
def test_edges_ascend_and_every_view_gives_the_same_heights(road, distance, speed) -> None:
    segments = road.segments(distance)
    assert segments.edges[0] == 0.0
    assert segments.edges[-1] == distance
    assert (np.diff(segments.edges) > 0.0).all()
    assert len(segments.kind) == len(segments.coefficients) == len(segments.edges) - 1
    x = 0.5 * (segments.edges[:-1] + segments.edges[1:])  # never at a jump
    heights_there = segments.evaluate(x)[0]
    np.testing.assert_allclose(road.height_at(x), heights_there, rtol=0, atol=1e-9)
    trial = Trial(road=road, speed=speed, duration=distance / speed)
    np.testing.assert_allclose(
        trial.segments().evaluate(x / speed)[0], heights_there, rtol=0, atol=1e-9
    )


@settings(deadline=None, max_examples=100)
@given(obstacles(), st.floats(0.01, 1.0))
def test_after_the_end_the_road_is_level(road, beyond) -> None:
    after = road.profile().after
    assert road.height_at(road.end() + beyond) == after
    assert road.slope_at(road.end() + beyond) == 0.0


@settings(deadline=None, max_examples=30)
@given(roads(), st.floats(0.1, 0.5), st.sampled_from(["rigid-circle", "tandem-cam"]))
def test_a_wheel_never_sinks_into_the_road(road, radius, method) -> None:
    fields = {"contact_length": 0.3 * radius} if method == "tandem-cam" else {}
    felt = Enveloped(of=road, method=method, radius=radius, **fields)
    segments = felt.segments(6.0)
    assert (np.diff(segments.edges) > 0.0).all()
    x = np.linspace(0.0, 5.999, 700)
    height = segments.evaluate(x)[0]
    reach = felt.reach()
    edges = road.segments(8.0 + reach, behind=1.0 + reach).edges - 1.0 - reach
    around = road.height_at(
        np.concatenate([np.linspace(-reach, 6.0 + reach, 60_001), edges, edges - 1e-9])
    )
    assert height.max() <= around.max() + 1e-5
    assert height.min() >= around.min() - 1e-5
    if method == "rigid-circle":
        under = (
            x + np.linspace(-0.3, 0.3, 7)[:, None] * radius
        )  # points of the road beside the lowest one
        depth = radius - np.sqrt(radius**2 - (under - x) ** 2)
        assert (height - (road.height_at(under) - depth)).min() > -1e-5


@settings(deadline=None, max_examples=30)
@given(roads(), st.floats(0.02, 0.4))
@example(HalfCylinder(start=0.0, radius=0.875), 0.03125)
def test_the_mean_over_the_contact_keeps_the_area(road, length) -> None:
    felt = Enveloped(of=road, method="moving-average", contact_length=length).segments(6.0)
    x = np.linspace(0.0, 5.999, 300)
    edges = road.segments(7.0, behind=0.5).edges - 0.5
    beside = np.concatenate(
        [side * np.geomspace(1e-9, 0.05, 300) for side in (-1.0, 1.0)]
    )  # humps may begin upright
    near = np.clip((edges[1:-1, None] + beside).ravel(), -0.5, 6.5)
    at = np.unique(np.concatenate([np.linspace(-0.5, 6.5, 30_001), near]))
    height = road.height_at(at)
    area = np.concatenate([[0.0], np.cumsum(0.5 * (height[1:] + height[:-1]) * np.diff(at))])
    mean = (np.interp(x + 0.5 * length, at, area) - np.interp(x - 0.5 * length, at, area)) / length
    np.testing.assert_allclose(felt.evaluate(x)[0], mean, rtol=0, atol=2e-5)


@settings(deadline=None, max_examples=30)
@given(
    st.sampled_from("ABCDEFGH"),
    st.floats(5.0, 300.0),
    st.floats(0.02, 0.3),
    st.integers(0, 2**40),
    st.sampled_from(["left", "right"]),
    st.sampled_from(["linear", "cubic"]),
)
def test_rough_roads_are_level_at_both_ends_and_finite(
    name, length, step, seed, side, interpolation
) -> None:
    road = Iso8608(
        class_=name, length=length, step=step, seed=seed, side=side, interpolation=interpolation
    )
    x, height = road.points()
    assert (x[0], x[-1], height[0], height[-1]) == (0.0, length, 0.0, 0.0)
    assert np.isfinite(height).all()
    assert (np.diff(x) <= step * (1 + 1e-9)).all()
    inside = 0.5 * (x[1:] + x[:-1])
    between = road.height_at(inside)
    assert (
        np.abs(between - 0.5 * (height[1:] + height[:-1])).max()
        <= 0.6 * np.abs(np.diff(height)).max() + 1e-12
    )
    np.testing.assert_array_equal(road.points()[1], height)
