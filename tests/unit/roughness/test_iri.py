from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.linalg import expm

import jounce as jn
from jounce.roughness.iri import (
    SPEED,
    base_samples,
    golden_car_response,
    iri,
    read_profile,
    rectified_slope,
    state_transition,
)

X = np.arange(0.0, 250.1, 0.25)
Z = 0.002 * np.cumsum(np.random.default_rng(1).normal(size=X.size))


def plain_loop(height: np.ndarray, spacing: float) -> np.ndarray:
    """The algorithm as it is printed: one step after the other."""
    count = max(2, int(0.25 / spacing + 0.5) + 1) - 1
    system = np.array(
        [
            [0, 1, 0, 0],
            [-63.3, -6, 63.3, 6],
            [0, 0, 0, 1],
            [63.3 / 0.15, 6 / 0.15, -716.3 / 0.15, -6 / 0.15],
        ]
    )
    step = expm(system * spacing / SPEED)
    drive = np.linalg.solve(system, (step - np.eye(4)) @ np.array([0, 0, 0, 653.0 / 0.15]))
    state = (
        np.array([1.0, 0.0, 1.0, 0.0])
        * (np.interp(11.0, spacing * np.arange(height.size), height) - height[0])
        / 11
    )
    found = []
    for i in range(height.size - count):
        state = step @ state + drive * (height[i + count] - height[i]) / (count * spacing)
        found.append(abs(state[0] - state[2]))
    return np.array(found)


@pytest.mark.source(
    kind="computed",
    of="ride and roughness",
    key="wtp-46",
    where="the algorithm as printed, one step after the other",
    tolerance="rounding",
)
@pytest.mark.parametrize("spacing", [0.05, 0.1, 0.25, 0.3])
def test_blocks_give_what_the_loop_gives(spacing: float) -> None:
    np.testing.assert_allclose(
        rectified_slope(Z, spacing), plain_loop(Z, spacing), rtol=1e-9, atol=1e-13
    )


@pytest.mark.parametrize(
    ("spacing", "count"),
    [
        (0.001, 250),
        (0.05, 5),
        (0.1, 3),
        (0.1 + 1e-12, 3),
        (0.125, 2),
        (0.2, 1),
        (0.25, 1),
        (0.5, 1),
    ],
)
def test_base_of_the_slope(spacing: float, count: int) -> None:
    # K = max(2, int(0.25/dx + 0.5) + 1) points
    assert base_samples(spacing) == count


def test_a_slope_alone_is_smooth() -> None:
    assert iri(X, 583.0 + 0.05 * X).iri_m_per_km == pytest.approx(0.0, abs=1e-8)
    assert iri(X, np.zeros_like(X)).iri_m_per_km == 0.0


@pytest.mark.parametrize(("spacing", "base"), [(0.25, 0.25), (0.05, 0.25)])
def test_a_settled_sinusoid_has_the_gain_of_the_car(spacing: float, base: float) -> None:
    x = np.arange(0.0, 4000.0, spacing)
    trace = 1e3 * rectified_slope(0.01 * np.sin(2.0 * np.pi * x / 15.4), spacing)
    expected = 1e3 * abs(golden_car_response(15.4)) * np.sinc(base / 15.4) * 4.0 * 0.01 / 15.4
    assert expected == pytest.approx(3.9855, abs=6e-5)
    start = round(1000.0 / spacing)
    mean = trace[start : start + round(154.0 * 16.0 / spacing)].mean()  # whole waves
    assert mean == pytest.approx(
        expected * np.sinc(spacing / 15.4), rel=5e-5
    )  # slopes are held between the samples


def test_state_transition_is_the_matrix_exponential() -> None:
    half, drive = state_transition(0.125)
    whole, _ = state_transition(0.25)
    np.testing.assert_allclose(half @ half, whole, atol=1e-12)
    np.testing.assert_allclose(
        half @ np.array([1.0, 0, 1.0, 0]) + drive, [1.0, 0, 1.0, 0], atol=1e-12
    )  # on a ramp


def test_segments_share_the_state_and_make_up_the_whole() -> None:
    assert [s.end for s in iri(X, Z).segments] == [100.0, 200.0, 250.0]
    found = iri(X, Z, segment="60 m")
    assert [(s.start, s.end, s.partial) for s in found.segments] == [
        (0.0, 60.0, False),
        (60.0, 120.0, False),
        (120.0, 180.0, False),
        (180.0, 240.0, False),
        (240.0, 250.0, True),
    ]
    lengths = np.array([s.end - s.start for s in found.segments])
    mean = np.average([s.iri_m_per_km for s in found.segments], weights=lengths)
    assert mean == pytest.approx(found.iri_m_per_km, rel=1e-12)
    alone = iri(X[240:481], Z[240:481])
    assert (
        abs(alone.iri_m_per_km / found.segments[1].iri_m_per_km - 1.0) > 1e-4
    )  # started anew it differs


def test_whole_segments_are_not_partial() -> None:
    assert [s.partial for s in iri(X[:801], Z[:801], segment=100.0).segments] == [False, False]
    fine = iri(0.05 * np.arange(4001), np.interp(0.05 * np.arange(4001), X, Z), segment=100.0)
    assert [(s.start, s.end, s.partial) for s in fine.segments] == [
        (0.0, 100.0, False),
        (100.0, 200.0, False),
    ]


def test_a_profile_shorter_than_a_segment_is_partial() -> None:
    found = iri(X[:101], Z[:101])
    assert [(s.end, s.partial) for s in found.segments] == [(25.0, True)]
    assert "partial" in str(found)
    assert found.segments[0].iri_m_per_km == pytest.approx(found.iri_m_per_km, rel=1e-12)


def test_height_and_place_do_not_matter() -> None:
    assert iri(X + 478.0, Z + 583.0).iri_m_per_km == pytest.approx(iri(X, Z).iri_m_per_km, rel=1e-9)
    assert iri(X, 2.0 * Z).iri_m_per_km == pytest.approx(2.0 * iri(X, Z).iri_m_per_km, rel=1e-12)


def changed(values: np.ndarray, row: int, value: float) -> np.ndarray:
    copy = values.copy()
    copy[row] = value
    return copy


@pytest.mark.parametrize(
    ("x", "z", "text"),
    [
        (X[::-1], Z, "the distance decreases"),
        (changed(X, 7, X[6]), Z, "distance does not increase at row 8"),
        (changed(X, 7, X[7] + 0.01), Z, "not evenly spaced: see row"),
        (np.concatenate([X[:500], X[501:]]), Z[:-1], "see row 501; found 'a step of 0.5 m'"),
        (
            X,
            changed(Z, 3, np.nan),
            "1 values are not finite numbers, the first at row 4; found 'nan'. Fill the gap",
        ),
        (
            X,
            np.where(X > 240.0, np.nan, Z),
            "not finite numbers, the first at row 962; found 'nan'. Cut off the padding",
        ),
        (
            X,
            changed(Z, -2, np.nan),
            "1 values are not finite numbers, the first at row 1000; found 'nan'. Fill the gap",
        ),
        (X, np.full_like(X, np.nan), "1001 values are not finite"),
        (
            X[:45],
            Z[:45],
            "too short for the roughness index; found '11 m'; allowed: at least 11.25 m",
        ),
        (X[:2], Z[:2], "too few samples"),
        (1e3 * X, Z, "too far apart for the roughness index; found '250 m'"),
        (1e-3 * X, Z, "too short"),
        (X, 1e3 * Z, "these heights are implausible for a road"),
        (X, Z[:-1], "not two columns of the same length"),
    ],
)
def test_bad_profiles_are_one_message(x: np.ndarray, z: np.ndarray, text: str) -> None:
    with pytest.raises(jn.RecordingError) as caught:
        iri(x, z, place="track.csv")
    assert text in str(caught.value)
    assert str(caught.value).startswith("track.csv")
    assert "\n" not in str(caught.value)


def test_the_shortest_profile() -> None:
    assert iri(X[:46], Z[:46]).iri_m_per_km > 0.0


@pytest.mark.parametrize(
    ("segment", "text"), [("0.1 m", "too short"), ("-1 m", "too short"), ("2 s", "wrong unit")]
)
def test_bad_segments(segment: str, text: str) -> None:
    with pytest.raises(jn.JounceError, match=text):
        iri(X, Z, segment=segment)


def test_what_weakens_the_index_is_said() -> None:
    assert iri(X, Z).findings == ()
    assert "0.3 m or less" in iri(2.0 * X, Z).findings[0].message
    rough = iri(X, Z * 50.0 / iri(X, Z).iri_m_per_km)
    assert rough.findings[0].value == pytest.approx(50.0)
    assert "smoother than any built road" in iri(X, 1e-3 * Z).findings[0].message
    assert iri(X, 0.0 * Z).findings == ()


def test_limits_of_what_a_road_can_be() -> None:
    usual = iri(X, Z).iri_m_per_km
    for limit, direction in ((0.1, -1.0), (30.0, 1.0)):  # m/km: smoother, rougher than any road
        within, beyond = (
            iri(X, Z * limit / usual * (1.0 + 0.01 * side * direction)) for side in (-1.0, 1.0)
        )
        assert within.findings == ()
        assert [finding.value for finding in beyond.findings] == [
            pytest.approx(limit * (1.0 + 0.01 * direction))
        ]
    assert iri(X, Z * 297.0 / usual).iri_m_per_km == pytest.approx(297.0)
    with pytest.raises(
        jn.RecordingError, match="allowed: at most 300 m/km; the roughest tracks have about 30"
    ):
        iri(X, Z * 303.0 / usual)
    assert iri(changed(X, 7, X[7] + 0.99e-2 * 0.25), Z).iri_m_per_km == pytest.approx(usual)
    with pytest.raises(jn.RecordingError, match="within 1 %"):
        iri(changed(X, 7, X[7] + 1.01e-2 * 0.25), Z)


def test_profiles_with_and_without_a_header(tmp_path: Path) -> None:
    bare, headed, other = (tmp_path / name for name in ("bare.txt", "headed.csv", "other.csv"))
    bare.write_text("# measured\n0.00 1.5\n0.25 1.6\n\n0.50 1.7\n", encoding="utf-8")
    headed.write_text("z [mm]; x [cm]\n1500; 0\n1600; 25\n1700; 50\n", encoding="utf-8")
    other.write_text("station, elevation\n0, 1.5\n0.25, 1.6\n0.5, 1.7\n", encoding="utf-8")
    mapped = {"x": "station [m]", "z": "elevation [m]"}
    for file, columns, notes in ((bare, None, 1), (headed, None, 0), (other, mapped, 0)):
        x, z, findings = read_profile(file, columns=columns)
        np.testing.assert_allclose(x, [0.0, 0.25, 0.5])
        np.testing.assert_allclose(z, [1.5, 1.6, 1.7])
        assert len(findings) == notes


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("0 1\n0.25 nan\n", "line 2: not a finite number"),
        ("0 1\n0.25\n", "line 2: two numbers are required"),
        ("0 1\n0.25 one\n", "line 2: two numbers are required"),
        ("x [m], z [m]\n0, 1\n0.25, nan\n", "line 3"),
        ("x [m], z [s]\n0, 1\n0.25, 1\n", "wrong unit"),
        ("x, z\n0, 1\n0.25, 1\n", "the column has no unit"),
        ("distance [m], z [m]\n0, 1\n0.25, 1\n", "no column 'x'"),
        ("", "the file is empty"),
    ],
)
def test_bad_files_are_one_message(text: str, message: str, tmp_path: Path) -> None:
    file = tmp_path / "track.csv"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(jn.JounceError) as caught:
        read_profile(file)
    assert message in str(caught.value)


def test_an_opencrg_road_is_read_at_its_offset() -> None:
    x, z, findings = read_profile("detrended_rms_course_1in")
    assert (x[1], x[-1], findings) == (0.05, 504.75, [])
    assert iri(x, z).base == pytest.approx(0.25)
    with pytest.raises(jn.RecordingError, match="only OpenCRG roads have lateral offsets"):
        read_profile("track.csv", lateral_offset=1.0)
