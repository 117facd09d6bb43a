"""Trials: a road at a speed, or an excitation in time."""

from __future__ import annotations

import numpy as np
import pytest

from jounce.core.errors import DescriptionError, JounceError, RecordingError
from jounce.parts import load
from jounce.roads import (
    Excitation,
    HalfCylinder,
    HalfSine,
    Kerb,
    Ramp,
    Rectangle,
    Step,
    Train,
    Trial,
)
from jounce.roads.trial import trial_findings

ROAD = HalfSine(height="10 mm", length="60 mm", start="0.2 m")
T = tuple(np.linspace(0.0, 0.5, 26).tolist())
Z = tuple((0.01 * np.sin(2 * np.pi * 4 * np.array(T))).tolist())


def test_a_road_is_driven_at_a_constant_speed() -> None:
    trial = Trial(road=ROAD, speed="1.95 m/s", duration="3 s")
    segments = trial.segments()
    np.testing.assert_allclose(segments.edges, [0.0, 0.2 / 1.95, 0.26 / 1.95, 3.0], rtol=1e-14)
    t = np.linspace(0.0, 3.0, 3001)
    height, velocity = segments.evaluate(t)
    np.testing.assert_allclose(height, ROAD.height_at(1.95 * t), rtol=0, atol=1e-15)
    assert np.abs(velocity).max() == pytest.approx(
        1.95 * 0.01 * np.pi / 0.06, rel=1e-3
    )  # dz/dt = v dh/dx
    assert trial.end() == pytest.approx(0.26 / 1.95, rel=1e-14)


@pytest.mark.parametrize(
    ("speed", "pitch", "frequency"),
    [
        (1.97, 0.10, 19.7),
        (2.01, 0.15, 13.4),
        (1.92, 0.15, 12.8),
        (1.99, 0.20, 9.95),
        (2.01, 0.20, 10.05),
    ],
)
def test_pass_frequencies_of_table_2(speed, pitch, frequency) -> None:
    # domain A8 and A9: v / x of the trials on profile B
    trial = Trial(road=Train(of=ROAD, count=5, pitch=pitch), speed=speed, duration=3)
    starts = trial.segments().edges[1:-1:2]
    assert 1.0 / np.diff(starts) == pytest.approx([frequency] * 4, rel=5e-4)


def test_an_excitation_is_a_smooth_curve_through_its_samples() -> None:
    trial = Trial(excitation=Excitation(time=T, height=Z))
    assert trial.duration == 0.5
    height, velocity = trial.segments().evaluate(np.array(T[:-1]))
    np.testing.assert_allclose(height, Z[:-1], rtol=0, atol=1e-16)
    fine = np.linspace(0.0, 0.4999, 2000)
    height, velocity = trial.segments().evaluate(fine)
    np.testing.assert_allclose(height, 0.01 * np.sin(8 * np.pi * fine), rtol=0, atol=2e-5)
    np.testing.assert_allclose(velocity, 0.08 * np.pi * np.cos(8 * np.pi * fine), rtol=0, atol=8e-3)
    inner = np.array(T[1:-1])
    left, right = (trial.segments().evaluate(inner + side * 1e-9)[1] for side in (-1, 1))
    np.testing.assert_allclose(left, right, rtol=0, atol=1e-6)


def test_lines_are_an_option_and_the_last_height_is_held() -> None:
    trial = Trial(excitation=Excitation(time=T, height=Z, interpolation="linear"), duration="2 s")
    t = np.linspace(0, 2, 500)
    np.testing.assert_allclose(
        trial.segments().evaluate(t)[0], np.interp(t, T, Z), rtol=0, atol=1e-16
    )
    assert (trial.duration, trial.end()) == (2.0, 0.5)
    assert trial.segments().edges[[0, -1]].tolist() == [0.0, 2.0]


def test_time_zero_is_the_start_of_the_trial() -> None:
    late = Trial(
        excitation=Excitation(time=np.array(T) + 0.3, height=Z[::-1], interpolation="linear")
    )
    assert late.duration == pytest.approx(0.8, abs=1e-15)
    assert late.segments().evaluate(np.array([0.0, 0.2]))[0].tolist() == [Z[-1], Z[-1]]
    early = Trial(excitation=Excitation(time=np.array(T) - 0.3, height=Z))
    whole = Trial(excitation=Excitation(time=T, height=Z))
    t = np.linspace(0.0, 0.199, 100)
    np.testing.assert_allclose(
        early.segments().evaluate(t)[0], whole.segments().evaluate(t + 0.3)[0], rtol=0, atol=1e-15
    )
    assert early.segments().edges[0] == 0.0
    with pytest.raises(DescriptionError, match=r"last time is -0\.5 s; it must be after 0"):
        Trial(excitation=Excitation(time=np.array(T) - 1.0, height=Z))


@pytest.mark.parametrize("interpolation", ["cubic", "linear"])
def test_heights_that_count_from_the_first_one(tmp_path, interpolation) -> None:
    raised = 0.31 + np.array([float(z) for z in Excitation(time=T, height=Z).height])
    from_rest = Excitation(time=T, height=raised, interpolation=interpolation, datum="rest")
    wanted = Excitation(time=T, height=raised - raised[0], interpolation=interpolation)
    time = np.linspace(0.0, 1.2 * T[-1], 50)
    mine, theirs = (Trial(excitation=one, duration="2 s").segments() for one in (from_rest, wanted))
    np.testing.assert_allclose(mine.evaluate(time)[0], theirs.evaluate(time)[0], atol=1e-15)
    as_written = Trial(excitation=Excitation(time=T, height=raised)).segments()
    assert as_written.evaluate(np.array([0.0]))[0] == pytest.approx(raised[0])
    file = tmp_path / "base.csv"
    file.write_text(
        "time [s], road.z [m]\n" + "".join(f"{t},{z}\n" for t, z in zip(T, raised, strict=True))
    )
    (said,) = Excitation(file=file).findings()
    assert (said.severity, said.value) == ("warning", pytest.approx(raised[0]))
    assert 'datum = "rest" measures them from their start' in said.message
    assert Excitation(file=file, datum="rest").findings() == []
    assert Excitation(file=file, datum="rest").profile().before == 0.0


def test_an_excitation_from_a_file(tmp_path) -> None:
    file = tmp_path / "base.csv"
    rows = [f"{t:.6f},{1e3 * z:.9f}" for t, z in zip(T, Z, strict=True)]
    file.write_text("\n".join(["time [s],road.z [mm]", *rows]))
    from_file = Trial(excitation=str(file)).segments()
    from_arrays = Trial(excitation=Excitation(time=T, height=Z)).segments()
    np.testing.assert_allclose(from_file.coefficients, from_arrays.coefficients, rtol=0, atol=1e-5)
    assert (
        Trial(excitation={"file": file, "interpolation": "linear"}).excitation.interpolation
        == "linear"
    )


@pytest.mark.parametrize(
    ("fields", "says"),
    [
        ({}, "neither a road nor an excitation is given"),
        ({"duration": 3}, "neither a road nor an excitation is given"),
        (
            {"road": ROAD, "excitation": Excitation(time=T, height=Z)},
            "both a road and an excitation are given",
        ),
        ({"road": ROAD, "duration": 3}, "the speed is missing"),
        ({"road": ROAD, "speed": 2}, "the duration is missing"),
        (
            {"road": ROAD, "speed": 0, "duration": 3},
            "speed: out of range; found 0; allowed: above 0 m/s",
        ),
        ({"road": ROAD, "speed": "-1 m/s", "duration": 3}, "speed: out of range"),
        ({"road": ROAD, "speed": "7 km", "duration": 3}, "speed: wrong unit"),
        ({"road": ROAD, "speed": 2, "duration": "0 s"}, "duration: out of range"),
        ({"road": ROAD, "speed": 2, "duration": float("inf")}, "duration: not a finite number"),
        ({"excitation": Excitation(time=T, height=Z), "speed": 2}, "leave out the speed"),
        (
            {"road": {"kind": "half-sine", "height": 1}, "speed": 2, "duration": 3},
            r"road\.length: the key is missing",
        ),
        ({"road": "A", "speed": 2, "duration": 3}, "^road: "),
        ({"road": ROAD, "sped": 2, "duration": 3}, r"sped: unknown key.*Did you mean 'speed'"),
        (
            {"excitation": {"time": T, "height": Z[1:]}},
            "excitation: time has 26 values and height has 25",
        ),
        (
            {"excitation": {"time": T[:3], "height": Z[:3]}},
            "3 samples; an excitation needs at least 4",
        ),
        (
            {"excitation": {"time": T[:3], "height": Z[:3], "interpolation": "linear"}},
            "needs at least 4",
        ),
        ({"excitation": {}}, "excitation: no points; give time and height, or file"),
        (
            {"excitation": {"time": [0, 1, 1, 2], "height": [0, 0, 0, 0]}},
            r"time\[2\] = 1 is not above time\[1\] = 1",
        ),
        ({"excitation": {"time": [0] * 4, "height": [0] * 4}}, r"time\[1\] = 0 is not above"),
        (
            {"excitation": {"time": [0, 1, 2, 3], "height": [0, 0, float("nan"), 0]}},
            r"height\[2\]: not a finite number",
        ),
    ],
)
def test_refuses(fields, says) -> None:
    with pytest.raises(DescriptionError, match=says):
        Trial(**fields)


@pytest.mark.parametrize(
    ("content", "says"),
    [
        (
            "time [s],road.z [mm]\n0,0\n1,0\n0.5,0\n2,1\n",
            r"time does not increase from row 2 to row 3",
        ),
        (
            "time [s],road.z [mm]\n0,0\n0,0\n0,0\n0,1\n",
            r"time does not increase from row 1 to row 2",
        ),
        ("time [s],road.z [mm]\n0,0\n1,0\n2,1\n", "too few rows; found 3; allowed: at least 4"),
        ("time [s],z [mm]\n0,0\n1,0\n2,1\n3,1\n", r"no column 'road\.z'"),
        ("time [s],road.z [N]\n0,0\n1,0\n2,1\n3,1\n", r"column 'road\.z \[N\]': wrong unit"),
        (
            "time [s],road.z [mm]\n0,0\n1,NaN\n2,1\n3,1\n",
            r"base\.csv, line 3: column 'road\.z \[mm\]': not a finite",
        ),
    ],
)
def test_refuses_excitation_files(tmp_path, content, says) -> None:
    (tmp_path / "base.csv").write_text(content)
    with pytest.raises(JounceError, match=says):
        Trial(excitation=tmp_path / "base.csv")


def test_refuses_a_missing_excitation(tmp_path) -> None:
    for make in (
        lambda: Trial(excitation=tmp_path / "base.csv"),
        lambda: Excitation(file=tmp_path / "base.csv"),
    ):
        with pytest.raises(RecordingError, match="no such file"):
            make()
    with pytest.raises(
        DescriptionError, match="sample_time: only applies to a file, and none is given; give file"
    ):
        Excitation(time=T, height=Z, sample_time="1 ms")


def test_a_trial_is_equal_to_what_its_plain_form_gives_back() -> None:
    for trial in (
        Trial(road=ROAD, speed=2, duration=3),
        Trial(excitation=Excitation(time=T, height=Z)),
    ):
        assert Trial.model_validate_json(trial.model_dump_json()) == trial


def test_jumps_under_massless_axles_are_told() -> None:
    roads = {
        True: Step(height=0.02, start=5.0),
        False: HalfSine(height=0.02, length=1.0, start=5.0),
    }
    for jumps, road in roads.items():
        found = trial_findings(Trial(road=road, speed=10.0, duration=2.0), load("audi-a6-half-car"))
        assert any("the road jumps" in one.message for one in found) == jumps


def test_the_blow_of_a_tyre_s_damper_at_a_jump_is_told() -> None:
    rig = load("audi-a6-quarter-car")  # its tyre has 1000 N s/m
    up = Rectangle(height=0.01, length=0.06, start=1.0)
    for road, blow in (
        (up, 10.0),
        (Step(height=-0.01, start=1.0), None),
        (Ramp(height=0.01, length=0.1), None),
    ):
        found = [
            item
            for item in trial_findings(Trial(road=road, speed=5.0, duration=1.0), rig)
            if "impulse" in item.message
        ]
        assert [one.value for one in found] == ([] if blow is None else [pytest.approx(blow)])
    undamped = rig.with_changes({"tyre.damping_coefficient": 0.0})
    assert not trial_findings(Trial(road=up, speed=5.0, duration=1.0), undamped)
    car, right = load("audi-a6-full-car"), Train(of=up, count=2, pitch=0.06)
    found = trial_findings(
        Trial(road=HalfSine(height=0.02, length=1.0), right=right, speed=5.0, duration=1.0), car
    )
    assert [one.value for one in found] == [pytest.approx(100.0 * 0.01)]


def test_a_damped_tyre_on_an_upright_edge_is_told() -> None:
    rig = load("audi-a6-quarter-car")
    roads = {
        True: HalfCylinder(radius=0.01, start=1.0),
        False: Kerb(height=-0.02, edge_radius=0.02, start=1.0),
    }
    for upright, road in roads.items():  # a kerb down falls upright: there the tyre leaves it
        found = trial_findings(Trial(road=road, speed=5.0, duration=1.0), rig)
        assert ["rises vertically" in one.message for one in found] == [True] * upright
    undamped = rig.with_changes({"tyre.damping_coefficient": 0.0})
    assert not trial_findings(Trial(road=roads[True], speed=5.0, duration=1.0), undamped)
