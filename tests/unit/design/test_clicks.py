"""Clicks for a target: exact at measured clicks, the nearest between them; closed forms of damping ratios."""

from __future__ import annotations

import json
import math
from itertools import product
from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError, RecordingError
from jounce.design.damper_targets import chosen_target, steady_force
from jounce.parts.dampers import BlowOffDamper, BoucWenDamper
from jounce.parts.files import rig_path

SPEEDS = (-0.4, -0.2, -0.1, -0.05, 0.05, 0.1, 0.2, 0.4)
WHEEL = {"motion_ratio": 0.9, "sprung_mass": 60.0, "wheel_rate": 24e3}


def write(folder: Path, force, settings, names=("clicks",), half: float = 1.0) -> Path:
    file = folder / "map.csv"
    rows = [",".join([*names, "velocity", "force", "low", "high"])]
    for setting in settings:
        for v in SPEEDS:
            load = force(*setting, v)
            rows.append(
                ",".join(f"{x:.12g}" for x in (*setting, v, load, load - half, load + half))
            )
    file.write_text("\n".join(rows), encoding="utf-8")
    return file


def digressive(clicks: float, v: float) -> float:
    """Force of a law that jounce knows, with coefficients that fall by clicks."""
    law = BlowOffDamper(**blow_off(clicks))
    return float(law.forces(np.array([v]))[0])


def blow_off(clicks: float) -> dict[str, float]:
    softer = 1.0 - 0.04 * clicks
    return {
        "bump_blow_off_force": 100.0 * softer, "bump_blow_off_velocity": 0.1,
        "bump_high_speed_coefficient": 300.0 * softer, "rebound_blow_off_force": 180.0 * softer,
        "rebound_blow_off_velocity": 0.1, "rebound_high_speed_coefficient": 500.0 * softer,
    }  # fmt: skip


def digressing(low: float, high: float, v: float) -> float:
    """Force of two slopes (N s/m) below and beyond 0.1 m/s, the same in both directions."""
    return math.copysign(low * min(abs(v), 0.1) + high * max(abs(v) - 0.1, 0.0), v)


def sided(bump: float, rebound: float, v: float) -> float:
    return (800.0 - 30.0 * bump if v > 0.0 else 1500.0 - 60.0 * rebound) * v


@pytest.mark.parametrize("clicks", [0, 8, 16])
def test_a_law_at_measured_clicks_is_recovered_exactly(tmp_path: Path, clicks: int):
    file = write(tmp_path, digressive, [(c,) for c in (0, 8, 16)])
    chosen = jn.choose_clicks(file, {"kind": "blow-off", **blow_off(clicks)})
    assert chosen.best.clicks == {"clicks": float(clicks)}
    assert chosen.best.is_measured
    assert chosen.best.misfit < 1e-9
    assert np.abs(chosen.residual).max() < 1e-6
    assert chosen.combinations == 17
    assert not [item for item in chosen.findings if item.severity == "warning"]


@pytest.mark.parametrize("wanted", [2.4, 5.5001, 11.9])
def test_between_clicks_the_nearest_is_chosen(tmp_path: Path, wanted: float):
    file = write(tmp_path, digressive, [(c,) for c in (0, 8, 16)])
    chosen = jn.choose_clicks(file, {"kind": "blow-off", **blow_off(wanted)})
    assert chosen.best.clicks == {"clicks": float(round(wanted))}
    away = abs(0.04 * (wanted - round(wanted)) / (1.0 - 0.04 * wanted))
    assert chosen.best.misfit == pytest.approx(away, rel=1e-6)
    assert "design.clicks_between" in {item.code for item in chosen.findings}
    low, high = chosen.best.misfit_interval
    assert low < chosen.best.misfit < high
    misfits = [item.misfit for item in chosen.choices]
    assert misfits == sorted(misfits)


@pytest.mark.parametrize("is_whole", [True, False], ids=["grid", "star"])
def test_every_combination_of_two_adjusters_is_tried(tmp_path: Path, is_whole: bool):
    settings = (
        list(product((0, 8, 16), (0, 10, 20)))
        if is_whole
        else [(8, 10), (0, 10), (16, 10), (8, 0), (8, 20)]
    )
    file = write(tmp_path, sided, settings, ("bump clicks", "rebound clicks"))
    target = {"bump_coefficient": 800.0 - 30.0 * 5, "rebound_coefficient": 1500.0 - 60.0 * 13}
    chosen = jn.choose_clicks(file, target, best=3)
    assert chosen.best.clicks == {"bump_clicks": 5.0, "rebound_clicks": 13.0}
    assert chosen.best.misfit < 1e-9
    assert (chosen.combinations, chosen.are_all_tried, len(chosen.choices)) == (17 * 21, True, 3)
    assert chosen.damper["kind"] == "table"
    code = "design.clicks_between" if is_whole else "design.clicks_added"
    assert code in {item.code for item in chosen.findings}


def test_among_very_many_combinations_the_best_is_found(tmp_path: Path):
    """Four adjusters of 41 clicks: 2.8 million combinations, searched two adjusters at a time."""

    def force(low_b: float, high_b: float, low_r: float, high_r: float, v: float) -> float:
        low, high = (low_b, high_b) if v > 0.0 else (low_r, high_r)
        return digressing(900.0 - 10.0 * low, 500.0 - 8.0 * high, v)

    base = (20, 20, 20, 20)
    settings = [base, *(tuple(c if k == i else 20 for i in range(4)) for k in range(4) for c in (0, 40))]  # fmt: skip
    names = [f"{s} speed {d} clicks" for d in ("bump", "rebound") for s in ("low", "high")]
    file = write(tmp_path, force, settings, names)
    truth = (7, 31, 12, 3)
    velocity = (-0.4, -0.1, 0.0, 0.1, 0.4)
    law = {"velocity": velocity, "force": [force(*truth, v) if v else 0.0 for v in velocity]}
    chosen = jn.choose_clicks(file, law)
    assert tuple(chosen.best.clicks.values()) == truth
    assert not chosen.are_all_tried
    assert chosen.combinations == 41**4


def test_damping_ratios_at_the_wheel_have_their_closed_form(tmp_path: Path):
    """A linear damper c has the ratio c i^2 / (2 sqrt(k m)) at all speeds."""
    file = write(tmp_path, lambda c, v: (1200.0 - 50.0 * c) * v, [(c,) for c in (0, 5, 10)])
    critical = 2.0 * math.sqrt(24e3 * 60.0)
    ratio = (1200.0 - 50.0 * 7) * 0.9**2 / critical
    chosen = jn.choose_clicks(file, jn.WheelDamping.low_and_high(ratio, ratio), **WHEEL)
    assert chosen.best.clicks == {"clicks": 7.0}
    assert chosen.best.misfit < 1e-9
    assert chosen.ratios["ratio"] == pytest.approx([ratio] * len(SPEEDS))
    assert chosen.compared == "ratio"
    worse = chosen.choices[1]
    assert worse.rms_ratio == pytest.approx(50.0 * 0.9**2 / critical)


def test_low_and_high_speed_are_slopes_below_and_beyond_the_knee():
    wheel = jn.DampedWheel(**WHEEL)
    target = jn.WheelDamping.low_and_high(0.6, 0.8, 0.3, 0.4, knee="0.1 m/s")
    at = 0.9 * np.array([-0.3, -0.1, -0.05, 0.05, 0.1, 0.3])
    shares = np.array([-0.8 * 0.1 - 0.4 * 0.2, -0.08, -0.04, 0.03, 0.06, 0.06 + 0.3 * 0.2])
    assert target.force(at, wheel) == pytest.approx(shares * wheel.critical_coefficient / 0.9)
    table = jn.WheelDamping((-0.1, 0.1), (0.5, 0.5))
    assert np.isnan(table.force(0.2, wheel))


def test_low_speeds_count_as_much_as_high_ones_when_ratios_are_compared(tmp_path: Path):
    """Clicks trade low against high speed: forces decide for high, ratios for low."""

    def force(c: float, v: float) -> float:
        return digressing(600.0 + 60.0 * c, 600.0 + 10.0 * c, v)

    file = write(tmp_path, force, [(c,) for c in range(11)])
    law = {"kind": "blow-off"} | {
        f"{side}_{name}": value for side in ("bump", "rebound")
        for name, value in (("blow_off_force", 60.0), ("blow_off_velocity", 0.1), ("high_speed_coefficient", 700.0))
    }  # fmt: skip
    by_force = jn.choose_clicks(file, law, **WHEEL)
    by_ratio = jn.choose_clicks(file, law, compare="ratio", **WHEEL)
    assert by_force.best.clicks["clicks"] > by_ratio.best.clicks["clicks"]


def test_a_histogram_decides_which_speeds_count(tmp_path: Path):
    def force(c: float, v: float) -> float:
        return digressing(600.0 + 40.0 * c, 600.0 - 20.0 * c, v)

    file = write(tmp_path, force, [(c,) for c in (0, 5, 10)])
    slow = jn.choose_clicks(file, {"coefficient": 800.0}, shares={-0.08: 0.5, 0.08: 0.5})
    assert slow.best.clicks == {"clicks": 5.0}
    assert slow.best.misfit < 1e-9
    histogram = tmp_path / "histogram.csv"
    histogram.write_text("velocity [mm/s],share [%]\n-80,40\n80,40\n-900,10\n900,10\n")
    beyond = jn.choose_clicks(file, {"coefficient": 800.0}, shares=histogram)
    assert beyond.best.clicks == slow.best.clicks
    (item,) = [item for item in beyond.findings if item.code == "design.histogram_beyond_map"]
    assert item.value == pytest.approx(0.2)
    counted = tmp_path / "counted.csv"
    counted.write_text(
        "record,section,corner,quantity,from,to,share\n"
        "a,whole,front_left,velocity [m/s],-0.1,-0.06,0.5\na,whole,front_left,velocity [m/s],0.06,0.1,0.5\n"
        "a,whole,front_left,travel [m],0,1,1\na,lap 1,front_left,velocity [m/s],0.3,0.4,1\n"
        "a,whole,rear_left,velocity [m/s],0.3,0.4,1\n"
    )
    front = jn.choose_clicks(file, {"coefficient": 800.0}, shares=counted, corner="front")
    assert front.velocity == pytest.approx([-0.08, 0.08])
    assert front.best.clicks == slow.best.clicks
    with pytest.raises(DescriptionError, match="several corners"):
        jn.choose_clicks(file, {"coefficient": 800.0}, shares=counted)
    with pytest.raises(DescriptionError, match="no corners"):
        jn.choose_clicks(file, {"coefficient": 800.0}, shares={0.1: 1.0}, corner="front")
    with pytest.raises(DescriptionError, match="no histogram with this corner"):
        jn.choose_clicks(file, {"coefficient": 800.0}, corner="front")
    with pytest.raises(DescriptionError, match="unknown corner"):
        jn.choose_clicks(file, {"coefficient": 800.0}, shares=counted, corner="middle")
    with pytest.raises(DescriptionError, match="no velocity of the histogram"):
        jn.choose_clicks(file, {"coefficient": 800.0}, shares={2.0: 1.0})


def test_a_histogram_of_the_track_is_taken_as_it_is_at_damper_or_wheel(tmp_path: Path):
    """A triangle of 80 mm/s spends its time at 80 mm/s in both directions."""
    t = np.arange(0.0, 30.0, 2e-3)
    travel = 0.02 * np.abs((t * 2.0) % 2.0 - 1.0)  # 40 mm/s
    data = jn.recording(t, {"front_left.damper.travel": (2.0 * travel, "m", "")})
    counted = jn.damper_histograms(data, measured_at="damper")
    file = write(tmp_path, lambda c, v: (1200.0 - 50.0 * c) * v, [(c,) for c in (0, 5, 10)])
    chosen = jn.choose_clicks(file, {"coefficient": 900.0}, shares=counted)
    usual = float(np.abs(chosen.velocity) @ chosen.weight)
    assert usual == pytest.approx(0.08, rel=0.1)
    (tmp_path / "histograms.csv").write_text(counted.table(), encoding="utf-8")
    read = jn.choose_clicks(file, {"coefficient": 900.0}, shares=tmp_path / "histograms.csv")
    assert read.velocity == pytest.approx(chosen.velocity)
    assert read.weight == pytest.approx(chosen.weight)
    at_wheel = jn.damper_histograms(data, measured_at="wheel")
    with pytest.raises(DescriptionError, match="needs the motion ratio"):
        jn.choose_clicks(file, {"coefficient": 900.0}, shares=at_wheel)
    slower = jn.choose_clicks(file, {"coefficient": 900.0}, shares=at_wheel, **WHEEL)
    assert np.abs(slower.velocity) @ slower.weight == pytest.approx(0.9 * usual, rel=0.02)


def test_targets_out_of_reach_are_said_with_where_and_how_much(tmp_path: Path):
    file = write(tmp_path, lambda c, v: (1200.0 - 50.0 * c) * v, [(c,) for c in (0, 5, 10)])
    chosen = jn.choose_clicks(file, {"bump_coefficient": 400.0, "rebound_coefficient": 1500.0})
    found = {item.code: item for item in chosen.findings}
    assert found["design.target_too_soft"].place == "bump"
    assert found["design.target_too_soft"].value == pytest.approx(0.4 * (700.0 - 400.0))
    assert found["design.target_too_hard"].place == "rebound"
    assert found["design.target_too_hard"].value == pytest.approx(0.4 * (1500.0 - 1200.0))
    harder = jn.choose_clicks(file, {"coefficient": 2000.0})
    assert "design.clicks_at_end" in {item.code for item in harder.findings}
    assert harder.best.clicks == {"clicks": 0.0}


def test_choices_that_intervals_do_not_tell_apart_are_named(tmp_path: Path):
    law = {"coefficient": 1200.0 - 50.0 * 5}

    def force(c: float, v: float) -> float:
        return (1200.0 - 50.0 * c) * v

    sure = jn.choose_clicks(write(tmp_path, force, [(c,) for c in (0, 5, 10)], half=0.5), law)
    assert [item.is_as_good for item in sure.choices] == [True, False, False, False, False]
    wide = jn.choose_clicks(write(tmp_path, force, [(c,) for c in (0, 5, 10)], half=15.0), law)
    assert wide.choices[1].is_as_good
    assert "design.clicks_as_good" in {item.code for item in wide.findings}
    unknown = jn.choose_clicks(write(tmp_path, force, [(c,) for c in (0, 10)]), law)
    assert unknown.best.misfit_interval is None
    assert "design.clicks_without_interval" in {item.code for item in unknown.findings}


def test_the_rig_is_written_with_the_clicks_and_its_comments(tmp_path: Path):
    file = write(tmp_path, lambda c, v: (400.0 - 20.0 * c) * v, [(c,) for c in (0, 8, 16)])
    rig = tmp_path / "rig.toml"
    text = rig_path("kart-quarter-car").read_text(encoding="utf-8")
    rig.write_text(text, encoding="utf-8")
    chosen = jn.choose_clicks(file, rig)
    made = tmp_path / "set.toml"
    made.write_text(chosen.rig_text, encoding="utf-8")
    law = jn.load(made).strut.damper
    assert (law.kind, law.clicks) == ("clicks", chosen.best.clicks["clicks"])
    assert law.forces(np.array([0.2])) == pytest.approx(chosen.best.force[-2:-1])
    assert rig.read_text(encoding="utf-8") == text
    assert "# as built" in chosen.rig_text
    assert chosen.wheel.motion_ratio == pytest.approx(math.cos(jn.load(rig).strut.angle))
    plain = jn.choose_clicks(file, {"coefficient": 200.0})
    with pytest.raises(DescriptionError, match="no rig is given"):
        _ = plain.rig_text


def test_targets_come_from_fits_and_designs(tmp_path: Path):
    file = write(tmp_path, lambda c, v: (3200.0 - 100.0 * c) * v, [(c,) for c in (0, 8, 16)])
    answer = tmp_path / "fit.json"
    answer.write_text(json.dumps({"law": "linear", "damper": {"kind": "linear", "coefficient": 2400.0}}))  # fmt: skip
    assert jn.choose_clicks(file, answer).best.clicks == {"clicks": 8.0}
    designed = jn.design_springs("audi-a6-quarter-car", "1.2 Hz", 0.3)
    wanted = designed.rig.strut.damper.coefficient
    chosen = jn.choose_clicks(file, designed)
    assert chosen.best.clicks["clicks"] == round(np.clip((3200.0 - wanted) / 100.0, 0, 16))
    assert chosen.rig.strut.spring.rate == designed.rig.strut.spring.rate
    answer.write_text("nonsense")
    with pytest.raises(DescriptionError, match="no damper law in this file"):
        jn.choose_clicks(file, answer)


def test_a_law_with_a_state_is_taken_in_steady_motion():
    law = BoucWenDamper(
        coefficient=500.0, hysteretic_force=80.0, rate=400.0, sigma=1.0, exponent=1.0, offset=50.0
    )
    v = np.array([-0.2, 0.2])
    assert steady_force(law, None, v) == pytest.approx([-180.0, 180.0])


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({}, "a target is required, and only one"),
        ({"target": "a.toml", "bump": 0.3}, "a target is required, and only one"),
        ({"bump": 0.3}, "--rebound is required"),
        ({"bump": 0.3, "rebound": -1.0}, "out of range"),
    ],
)
def test_wrong_targets_of_a_command_are_refused(options: dict[str, object], message: str):
    with pytest.raises(DescriptionError, match=message):
        chosen_target(**options)


def test_wrong_calls_are_refused(tmp_path: Path):
    file = write(tmp_path, lambda c, v: (1200.0 - 50.0 * c) * v, [(c,) for c in (0, 5, 10)])
    target = jn.WheelDamping.low_and_high(0.3, 0.4)
    with pytest.raises(DescriptionError, match="damping ratios need motion ratio"):
        jn.choose_clicks(file, target)
    with pytest.raises(DescriptionError, match="required together"):
        jn.choose_clicks(file, target, motion_ratio=0.9)
    with pytest.raises(DescriptionError, match="no target for a damper"):
        jn.choose_clicks(file, 3.0)
    with pytest.raises(DescriptionError, match="several dampers"):
        jn.choose_clicks(file, "formula-student-car")
    with pytest.raises(DescriptionError, match="act at the wheel"):
        jn.choose_clicks(file, target, rig="audi-a6-full-car")
    with pytest.raises(DescriptionError, match="no such file"):
        jn.choose_clicks(file, target, rig="no.json")
    with pytest.raises(DescriptionError, match="unknown comparison"):
        jn.choose_clicks(file, target, compare="energy", **WHEEL)
    with pytest.raises(DescriptionError, match="no velocity in common"):
        jn.choose_clicks(file, jn.WheelDamping((-0.01, 0.01), (0.3, 0.3)), **WHEEL)
    with pytest.raises(DescriptionError, match="the map has no clicks"):
        jn.choose_clicks(write(tmp_path, lambda c, v: c * v, [(3,)]), {"coefficient": 1.0})
    with pytest.raises(DescriptionError, match="above 0"):
        jn.DampedWheel(0.9, -60.0, 24e3)
    with pytest.raises(DescriptionError, match="ascend, without zero"):
        jn.WheelDamping((0.0, 0.1), (0.3, 0.3))
    ratios = tmp_path / "ratios.csv"
    ratios.write_text("speed,force\n0.1,3\n")
    with pytest.raises(RecordingError, match="one column ratio"):
        jn.read_damping_ratios(ratios)
