"""What enveloping must do: nulls of the mean, the circle on a step, cams on an edge; convergence; brute force."""

from __future__ import annotations

import numpy as np
import pytest

from jounce.roads import (
    CircularSegment,
    Enveloped,
    HalfCylinder,
    HalfSine,
    Iso8608,
    Pothole,
    Ramp,
    Rectangle,
    Sine,
    Step,
    Triangle,
    Versine,
)

R, CONTACT = 0.3, 0.12


def circle(of, **fields):
    return Enveloped(of=of, method="rigid-circle", radius=R, **fields)


@pytest.mark.parametrize("waves", [1, 2, 3])
def test_the_mean_feels_nothing_of_waves_that_fit_into_the_contact(waves) -> None:
    long = Enveloped(
        of=Sine(amplitude=0.01, wavelength=CONTACT / waves, length=6, start=1),
        method="moving-average",
        contact_length=CONTACT,
    )
    assert np.abs(long.height_at(np.linspace(2, 6, 999))).max() < 1e-7


@pytest.mark.parametrize("wavelength", [0.1, 0.2, 0.5, 2.0])
def test_the_mean_weakens_waves_by_the_sinc(wavelength) -> None:
    x = np.linspace(3.0, 9.0, 2000)
    waves = Sine(amplitude=0.01, wavelength=wavelength, length=11, start=1)
    felt = Enveloped(of=waves, method="moving-average", contact_length=CONTACT)
    gain = np.sinc(CONTACT / wavelength)
    np.testing.assert_allclose(felt.height_at(x), gain * waves.height_at(x), rtol=0, atol=1e-7)


def test_the_mean_of_lines_is_exact() -> None:
    felt = Enveloped(
        of=Rectangle(height=0.02, length=0.05, start=1),
        method="moving-average",
        contact_length=CONTACT,
    )
    # a cleat shorter than the contact becomes a trapezoid of height h l / L
    assert felt.segments(2.0).edges == pytest.approx([0.0, 0.94, 0.99, 1.06, 1.11, 2.0], abs=1e-12)
    assert felt.height_at([0.94, 0.99, 1.02, 1.06, 1.11]) == pytest.approx(
        [0, 0.02 * 0.05 / 0.12] + [0.02 * 0.05 / 0.12] * 2 + [0], abs=1e-14
    )
    ramp = Enveloped(
        of=Ramp(height=1.0, length=10, start=1), method="moving-average", contact_length=CONTACT
    )
    s = np.linspace(-0.06, 0.06, 50)  # the foot becomes a parabola
    np.testing.assert_allclose(
        ramp.height_at(1 + s), 0.1 * (s + 0.06) ** 2 / 0.24, rtol=0, atol=1e-14
    )


@pytest.mark.parametrize("h", [0.01, 0.05, 0.1, 0.2])
def test_a_circle_on_a_step(h) -> None:
    felt = circle(Step(height=h, start=2), step=R / 80)
    begin = 2.0 - np.sqrt(2 * R * h - h * h)
    assert felt.segments(5.0).edges[1] == pytest.approx(begin, abs=1e-9)
    x = np.linspace(begin, 2.0, 1000, endpoint=False)
    np.testing.assert_allclose(
        felt.height_at(x), h - R + np.sqrt(R**2 - (2 - x) ** 2), rtol=0, atol=2e-7 * (1 + 50 * h**2)
    )
    np.testing.assert_allclose(
        felt.slope_at(x), (2 - x) / np.sqrt(R**2 - (2 - x) ** 2), rtol=0, atol=1e-4 * (1 + 50 * h)
    )
    assert felt.height_at([begin - 1e-6, 2.0, 2.3]) == pytest.approx([0.0, h, h], abs=1e-12)
    down = circle(Step(height=-h, start=2), step=R / 80)  # the same edge, the other way round
    np.testing.assert_allclose(
        down.height_at(2.0 + x[::-1] - begin), felt.height_at(2.0 + begin - x[::-1]) - h, atol=1e-5
    )


def test_a_circle_on_a_bar_runs_on_the_sum_of_the_radii() -> None:
    r = 0.1
    felt = circle(HalfCylinder(radius=r, start=1), step=R / 80)
    half = np.sqrt((R + r) ** 2 - R**2)
    edges = felt.segments(3.0).edges
    assert np.abs(edges - (1.1 - half)).min() < 1e-9
    x = np.linspace(1.1 - half, 1.1 + half, 999)
    np.testing.assert_allclose(
        felt.height_at(x), np.sqrt((R + r) ** 2 - (x - 1.1) ** 2) - R, rtol=0, atol=1e-7
    )


def test_a_circle_bridges_a_short_hole() -> None:
    felt = circle(Rectangle(height=-0.1, length=0.2, start=1))
    # it rests on both edges in the middle: R - sqrt(R^2 - (l/2)^2) deep
    assert felt.height_at(1.1) == pytest.approx(np.sqrt(R**2 - 0.1**2) - R, abs=1e-8)
    long = circle(Rectangle(height=-0.02, length=1.0, start=1))
    assert long.height_at(1.5) == pytest.approx(-0.02, abs=1e-12)


def test_a_circle_on_a_slope_is_lifted_by_a_constant() -> None:
    m = 0.5
    felt = circle(Ramp(height=2.0, length=4.0, start=1))
    x = np.linspace(2.0, 4.0, 50)
    np.testing.assert_allclose(
        felt.height_at(x), m * (x - 1) + R * (np.sqrt(1 + m * m) - 1), rtol=0, atol=1e-10
    )


CAMS = [{"method": "rigid-circle"}, {"method": "tandem-cam", "contact_length": CONTACT}]


@pytest.mark.parametrize("fields", CAMS)
@pytest.mark.parametrize(
    "of",
    [
        Versine(height=0.04, length=0.4, start=1.3),
        Step(height=0.1, start=1.6),
        Sine(amplitude=0.02, wavelength=0.2, length=0.8, start=1.2),
    ],
    ids=lambda of: of.kind,
)
def test_pieces_are_within_micrometres_of_the_truth(fields, of) -> None:
    x = np.linspace(1.0, 2.2, 3001)
    fine = Enveloped(of=of, radius=R, step=R / 640, **fields).height_at(x)
    for n in (3, 8, 80):  # an eighth of the radius is the default
        assert (
            np.abs(Enveloped(of=of, radius=R, step=R / n, **fields).height_at(x) - fine).max()
            < 3e-6
        )


@pytest.mark.parametrize("fields", CAMS)
def test_the_error_falls_with_the_fourth_power_of_the_step(fields) -> None:
    x = np.linspace(1.0, 2.2, 3001)
    of = Versine(height=-0.02, length=0.8, start=1.1)
    fields = {**fields, "of": of, "radius": R, "tolerance": 1.0}  # nothing is cut
    fine = Enveloped(step=R / 1280, **fields).height_at(x)
    errors = [np.abs(Enveloped(step=R / n, **fields).height_at(x) - fine).max() for n in (10, 40)]
    assert 3.0 < np.log(errors[0] / errors[1]) / np.log(4.0) < 4.3


def brute(of, cam, x):
    """Highest of a million points of the road under the cam."""
    at = np.linspace(x.min() - cam.a, x.max() + cam.a, 300_001)
    height = of.height_at(at)
    return np.array(
        [
            np.max(height[near := np.abs(at - place) < cam.a] + cam.drop(at[near] - place))
            for place in x
        ]
    )


@pytest.mark.parametrize(
    "of",
    [
        HalfSine(height=0.02, length=0.1, start=1),
        pytest.param(Triangle(height=0.03, length=0.1, start=1), marks=pytest.mark.slow),
        pytest.param(CircularSegment(height=0.05, length=0.3, start=1), marks=pytest.mark.slow),
        pytest.param(
            Pothole(depth=0.05, length=0.5, edge_radius=0.02, start=1), marks=pytest.mark.slow
        ),
        pytest.param(Versine(height=-0.05, length=0.3, start=1), marks=pytest.mark.slow),
        Rectangle(height=0.02, length=0.03, start=1),
        Iso8608(class_="G", length=3, run_in=0, seed=2, band=(0.3, 5)),
        pytest.param(
            Iso8608(class_="G", length=3, run_in=0, seed=2, band=(0.3, 5), interpolation="cubic"),
            marks=pytest.mark.slow,
        ),
    ],
    ids=lambda of: of.kind,
)
@pytest.mark.some(3)
def test_envelopes_are_those_of_a_million_points(of) -> None:
    x = np.linspace(0.65, 1.85, 121)
    felt = circle(of, step=R / 40)
    np.testing.assert_allclose(felt.height_at(x), brute(of, felt._cam(), x), rtol=0, atol=5e-6)
    cams = Enveloped(of=of, method="tandem-cam", radius=R, contact_length=CONTACT, step=R / 40)
    half = 0.5 * 0.8335 * CONTACT
    front, rear = brute(of, cams._cam(), x + half), brute(of, cams._cam(), x - half)
    np.testing.assert_allclose(cams.height_at(x), 0.5 * (front + rear), rtol=0, atol=6e-6)
    slope = cams.effective_slope_at(x)
    np.testing.assert_allclose(slope, (front - rear) / (2 * half), rtol=0, atol=4e-4)


def test_cams_on_an_edge() -> None:
    # domain D3: |u/a|^c + |w/b|^c = 1 with a = 1.471 R0, b = .9622 R0, c = 1.5174, distance .8335 L
    felt = Enveloped(
        of=Step(height=0.02, start=2),
        method="tandem-cam",
        radius=R,
        contact_length=CONTACT,
        step=R / 200,
    )
    a, b, c, half = 1.471 * R, 0.9622 * R, 1.5174, 0.5 * 0.8335 * CONTACT
    first = 2.0 - half - a * (1.0 - (1.0 - 0.02 / b) ** c) ** (1.0 / c)
    assert felt.segments(4.0).edges[1] == pytest.approx(first, abs=1e-8)
    u = 0.03
    one = 0.02 + b * (1.0 - (u / a) ** c) ** (1.0 / c) - b
    assert felt.height_at(2.0 - half - u) == pytest.approx(
        0.5 * one, abs=1e-6
    )  # the rear cam is still on the level
    assert felt.effective_slope_at(2.0 - half - u) == pytest.approx(one / (2 * half), abs=1e-5)


def test_a_short_bump_is_felt_longer_and_a_large_one_as_it_is() -> None:
    x = np.linspace(0.0, 20.0, 20001)
    bump = Versine(height=0.05, length=10, start=5)
    for fields in (
        {"method": "rigid-circle", "radius": R},
        {"method": "moving-average", "contact_length": CONTACT},
    ):
        np.testing.assert_allclose(
            Enveloped(of=bump, **fields).height_at(x), bump.height_at(x), rtol=0, atol=1e-4
        )


def test_a_smaller_tolerance_is_kept() -> None:
    x = np.linspace(0.6, 1.9, 3000)
    of = Sine(amplitude=0.02, wavelength=0.2, length=1.1, start=0.7)
    fine = circle(of, step=R / 640, tolerance=1e-9).height_at(x)
    for tolerance in (1e-4, 1e-5, 1e-7):
        felt = circle(of, step=R, tolerance=tolerance)
        assert np.abs(felt.height_at(x) - fine).max() < 3.0 * tolerance
    assert len(circle(of, tolerance=1e-7).segments(3.0).kind) > len(
        circle(of, tolerance=1e-5).segments(3.0).kind
    )
