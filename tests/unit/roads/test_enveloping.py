"""Enveloped roads: fields, windows, names in files."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.interpolate import CubicHermiteSpline

from jounce.core.errors import DescriptionError
from jounce.core.segments import CIRCLE, POLYNOMIAL, SINE, Segments
from jounce.roads import (
    Enveloped,
    HalfSine,
    Iso8608,
    Rectangle,
    Sine,
    SineSum,
    Step,
    Table,
    Train,
    contact_length,
    read_roads,
)
from jounce.roads.enveloping import _area, _cubic, _curvature, _move_to_crossing

CLEAT = Rectangle(height="20 mm", length="40 mm", start="1 m")
METHODS = [
    {"method": "moving-average", "contact_length": 0.12},
    {"method": "rigid-circle", "radius": 0.3},
    {"method": "tandem-cam", "radius": 0.3, "contact_length": 0.12},
]


@pytest.mark.parametrize("fields", METHODS, ids=lambda f: f["method"])
def test_windows_of_one_road_agree(fields) -> None:
    for of in (
        CLEAT,
        Train(of=CLEAT, count=3, pitch=0.3),
        Iso8608(class_="E", length=4, start="-1 m"),
        SineSum(),
    ):
        road = Enveloped(of=of, **fields)
        x = np.linspace(0.0, 2.9, 800)
        height = road.height_at(x)
        np.testing.assert_allclose(road.segments(3.0).evaluate(x)[0], height, rtol=0, atol=2e-5)
        last = np.linspace(2.9, 3.0, 40)
        np.testing.assert_allclose(
            road.segments(3.0).evaluate(last)[0], road.segments(4.0).evaluate(last)[0], atol=2e-5
        )
        rear = road.segments(3.0, behind=2.6)
        np.testing.assert_allclose(rear.evaluate(x)[0], road.height_at(x - 2.6), rtol=0, atol=2e-5)
        assert (np.diff(rear.edges) > 0).all()
        assert rear.edges[[0, -1]].tolist() == [0.0, 3.0]


@pytest.mark.parametrize("fields", METHODS, ids=lambda f: f["method"])
def test_a_level_road_stays_level_and_a_lifted_one_is_lifted(fields) -> None:
    flat = Enveloped(of=Table(x=[0, 10], height=[0.3, 0.3]), **fields).segments(10.0)
    assert np.abs(flat.evaluate(np.linspace(0, 10, 99))[0] - 0.3).max() < 1e-12
    road = Enveloped(of=Step(height=0.02, start=1), **fields)
    assert road.height_at([1.0 - road.reach(), 1.0 + road.reach() + 1e-9]) == pytest.approx(
        [0.0, 0.02], abs=1e-9
    )
    assert road.end() == pytest.approx(1.0 + road.reach())


@pytest.mark.parametrize("fields", METHODS, ids=lambda f: f["method"])
def test_a_belt_loop_and_a_train_of_felt_obstacles(fields) -> None:
    belt = Enveloped(
        of=Rectangle(height="20 mm", length="40 mm", start="1 m", recurrence="1.97 m"), **fields
    )
    assert (belt.start, belt.recurrence) == (1.0, 1.97)
    x = np.linspace(0.5, 1.6, 200)
    np.testing.assert_allclose(belt.height_at(x + 1.97), belt.height_at(x), rtol=0, atol=2e-6)
    one = Enveloped(of=CLEAT, **fields)
    train = Train(of=one, count=2, pitch="1.5 m")
    np.testing.assert_allclose(train.height_at(x), one.height_at(x), rtol=0, atol=2e-6)
    np.testing.assert_allclose(train.height_at(x + 1.5), one.height_at(x), rtol=0, atol=2e-6)


def test_plain_form_gives_the_road_back() -> None:
    for fields in METHODS:
        road = Enveloped(of=CLEAT, **fields)
        assert Enveloped.model_validate_json(road.model_dump_json()) == road


def test_roads_in_files_are_named() -> None:
    roads = read_roads(
        {
            "felt": {
                "kind": "enveloped",
                "of": "bump",
                "method": "rigid-circle",
                "radius": "0.3 m",
            },
            "bump": {"kind": "half-sine", "height": "10 mm", "length": "60 mm", "start": "1 m"},
        }
    )
    assert roads["felt"].of == HalfSine(height=0.01, length=0.06, start=1.0)
    with pytest.raises(DescriptionError, match="the enveloped contains itself: 'felt' of 'felt'"):
        read_roads(
            {"felt": {"kind": "enveloped", "of": "felt", "method": "rigid-circle", "radius": 0.3}}
        )


@pytest.mark.parametrize(
    ("fields", "says"),
    [
        ({"method": "moving-average"}, "the method 'moving-average' needs contact_length"),
        ({"method": "moving-average", "contact_length": 0.1, "radius": 0.3}, "does not use radius"),
        ({"method": "rigid-circle", "radius": 0}, "radius: out of range"),
        ({"method": "tandem-cam", "radius": 0.3}, "the method 'tandem-cam' needs contact_length"),
        ({"method": "string", "radius": 0.3}, "method: "),
        (
            {"method": "rigid-circle", "radius": 0.3, "start": 3.0},
            "start belongs to the inner road",
        ),
        ({"method": "rigid-circle", "radius": 0.3, "cam_exponent": 1.0}, "cam with sharp corners"),
        ({}, "method: the key is missing"),
    ],
)
def test_refuses(fields, says) -> None:
    with pytest.raises(DescriptionError, match=says):
        Enveloped(of=CLEAT, **fields)


def test_a_wall_is_refused() -> None:
    with pytest.raises(DescriptionError, match="the wheel meets a wall"):
        Enveloped(
            of=Step(height="0.35 m", start="1 m"), method="rigid-circle", radius="0.3 m"
        ).segments(3.0)


def test_length_of_the_contact() -> None:
    # domain D3: a = R0 [q1 sqrt(Fz/(cz R0)) + q2 Fz/(cz R0)], q1 = .671, q2 = .733
    share = 4000.0 / (200e3 * 0.32)
    assert contact_length(4000.0, 200e3, 0.32) == pytest.approx(
        0.64 * (0.671 * share**0.5 + 0.733 * share), rel=1e-12
    )
    for wrong in ((0.0, 200e3, 0.32), (4e3, 0.0, 0.32), (4e3, 200e3, -0.1)):
        with pytest.raises(DescriptionError, match="a loaded tyre needs positive values"):
            contact_length(*wrong)
    assert contact_length(0.5, 0.25, 0.5, linear=1.0, root=0.5) == pytest.approx(0.5 * 2.0 + 4.0)


def test_how_far_a_tyre_feels() -> None:
    cams = Enveloped(of=CLEAT, **METHODS[2])
    assert (cams.cam_length, cams.cam_height, cams.cam_exponent, cams.cam_distance) == (
        1.471,
        0.9622,
        1.5174,
        0.8335,
    )
    reaches = [Enveloped(of=CLEAT, **fields).reach() for fields in METHODS]
    assert reaches == pytest.approx([0.06, 0.3, 0.3 * 1.471 + 0.5 * 0.8335 * 0.12])


@pytest.mark.source(
    kind="program",
    key="scipy",
    of="ride and roughness",
    where="scipy.interpolate.CubicHermiteSpline",
    tolerance="rounding; slopes by differences",
    compares="curvatures and cubics of a road that a tyre feels",
)
def test_curvatures_and_cubics_are_those_of_their_definitions() -> None:
    edges = np.array([0.0, 1.0, 2.5])
    coefficients = np.array([[0.1, 0.02, 7.0, 0.4], [0.05, 0.3, -0.2, 0.07]])
    road = Segments(edges, np.array([SINE, POLYNOMIAL]), coefficients)
    piece, x, step = np.array([0, 0, 1, 1]), np.array([0.2, 0.7, 1.4, 2.2]), 1e-5
    slopes = [road.on_pieces(piece, x + side * step)[1] for side in (-1.0, 1.0)]
    np.testing.assert_allclose(
        _curvature(road, piece, x), (slopes[1] - slopes[0]) / (2.0 * step), rtol=1e-7
    )
    spline = CubicHermiteSpline([2.0, 2.5], [0.3, 0.7], [-0.4, 0.9])
    ends = (np.array([0.3]), np.array([-0.4])), (np.array([0.7]), np.array([0.9]))
    for share in (0.3, 0.5, 0.8):
        expected = float(spline(2.0 + 0.5 * share))
        assert float(_cubic(np.array([0.5]), *ends, share)[0]) == pytest.approx(expected, rel=1e-12)


def test_kinks_lie_where_tangents_meet() -> None:
    """Rows x, height, slope and contact of three kinks: one within, one beyond the end, one that is none."""
    begin = np.array([[1.0, 1.0, 3.0], [0.2, 0.2, 0.5], [0.3, 0.3, 0.1], [0.9, 0.9, 2.9]])
    end = np.array([[1.1, 1.1, 3.2], [0.215, 0.24, 0.52], [-0.2, -0.2, 0.1], [1.2, 1.2, 3.3]])
    before, after = _move_to_crossing(begin, end)
    x = 1.0 + (0.215 + 0.2 * 0.1 - 0.2) / 0.5
    np.testing.assert_allclose(before[0], [x, 1.1, 3.1])
    np.testing.assert_array_equal(after[0], before[0])
    np.testing.assert_allclose(before[1], [0.2 + 0.3 * (x - 1.0), 0.23, 0.51])
    np.testing.assert_allclose(after[1], [before[1, 0], 0.24, 0.51])
    np.testing.assert_array_equal(before[2:], begin[2:])
    np.testing.assert_array_equal(after[2:], end[2:])


def test_small_kinks_are_found_and_kept() -> None:
    """In a shallow hollow the contact of a circle jumps by an eighth of a step: twice the radius times the slope."""
    steep = 0.0085
    hollow = Table(x=[0.0, 1.01, 3.0], height=[1.01 * steep, 0.0, 1.99 * steep])
    felt = Enveloped(of=hollow, method="rigid-circle", radius=0.3, step=0.04).segments(2.9)
    assert np.abs(felt.edges - 1.01).min() < 1e-8
    np.testing.assert_allclose(
        felt.evaluate(np.array([1.0099, 1.0101]))[1], [-steep, steep], rtol=1e-9
    )


def test_areas_are_the_integrals_of_heights() -> None:
    """Of a cubic, a wave and an arc that bends up; the middle one is taken up to its end."""
    edges = np.array([0.0, 1.0, 2.5, 3.0])
    coefficients = np.array([[0.1, 0.2, -0.7, 0.4], [0.05, 0.3, 2.0, 0.7], [0.9, 0.8, 0.3, -1.0]])
    road = Segments(edges, np.array([POLYNOMIAL, SINE, CIRCLE]), coefficients)
    piece, x = np.arange(3), np.array([0.8, 2.5, 2.9])
    for found, begin, end, one in zip(_area(road, piece, x), edges, x, piece, strict=False):
        at = np.linspace(begin, end, 20_001)
        height = road.on_pieces(np.full(at.size, one), at)[0]
        assert found == pytest.approx(np.trapezoid(height, at), rel=1e-7)


def test_the_last_piece_of_a_window_is_as_true_as_the_others() -> None:
    """Steps so long that every piece must be cut until it is within the tolerance."""
    waves = Sine(amplitude=0.01, wavelength=1.0, length=10.0)
    felt = Enveloped(of=waves, method="rigid-circle", radius=0.2, step=0.5)
    fine = Enveloped(of=waves, method="rigid-circle", radius=0.2, step=0.002)
    x = np.linspace(0.0, 2.9, 2901)
    np.testing.assert_allclose(
        felt.segments(2.9).evaluate(x)[0], fine.height_at(x), rtol=0, atol=3e-6
    )
