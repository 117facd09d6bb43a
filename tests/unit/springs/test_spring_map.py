"""Maps of springs and stops of known laws: truths inside intervals, what is found and said, and the law in a rig."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from presses import Helper, Press, RubberStop, linear, progressive, with_bind

import jounce as jn
from jounce.core.errors import DescriptionError, FitError
from jounce.springs.files import PressFile

SPEEDS = (0.002, 0.02, 0.2)


def record(part: object, rng: np.random.Generator, name: str = "press.csv", **options) -> PressFile:
    time, stroke, force = Press(**options).record(part, rng)
    return PressFile(name, stroke, force, time)


def stop_truth(stop: RubberStop, press: Press, grid: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Mean and half difference of the last cycle without noise, on a fine path."""
    count = 3000
    fine = replace(press, samples=count)
    time, d = fine.path()
    force = stop.forces(d, float(time[1]))
    begin = 2 * (fine.cycles - 1) * count
    up, down = slice(begin, begin + count + 1), slice(begin + count, begin + 2 * count + 1)
    loading = np.interp(grid, d[up], force[up])
    unloading = np.interp(grid, d[down][::-1], force[down][::-1])
    return 0.5 * (loading + unloading), 0.5 * (loading - unloading)


def codes(made: jn.SpringMap) -> set[str]:
    return {item.code for item in made.findings}


class Counts(dict[str, tuple[int, int]]):
    def add(self, name: str, inside: object) -> None:
        inside = np.atleast_1d(inside)
        before = self.get(name, (0, 0))
        self[name] = before[0] + int(inside.sum()), before[1] + inside.size


def covered(seeds: range) -> Counts:
    """Count truths inside their intervals: springs of three kinds and rubber stops, with all that presses do."""
    counts = Counts()
    for seed in seeds:
        rng = np.random.default_rng(seed)
        offsets = {
            "force_offset": rng.uniform(-30.0, 30.0), "stroke_offset": rng.uniform(-0.02, 0.02),
            "force_noise": rng.uniform(0.5, 3.0), "free": rng.uniform(0.004, 0.01),
            "signs": [(1, 1), (-1, -1), (-1, 1), (1, -1)][seed % 4],
        }  # fmt: skip
        if seed % 3 == 2:
            _count_stop(counts, rng, offsets)
        else:
            _count_spring(counts, rng, offsets, (linear, progressive, Helper)[seed // 3 % 3])
    return counts


def _count_spring(
    counts: Counts, rng: np.random.Generator, offsets: dict, kind: Callable[..., object]
) -> None:
    friction, backlash = rng.uniform(0.0, 6.0), rng.uniform(0.0, 1e-4)
    rate = rng.uniform(15e3, 90e3)
    if kind is linear:
        law, rates = linear(rate), [rate]
    elif kind is progressive:
        law, rates = progressive(rate, rate * rng.uniform(5.0, 15.0), 0.0), []
    else:
        law = Helper(rate * rng.uniform(0.2, 0.6), rate, rng.uniform(0.1, 0.3) * rate * 0.03)
        rates = [law.soft, rate]
    given = [
        record(law, rng, f"{k}.csv", speed=speed, friction=friction, backlash=backlash, **offsets)
        for k, speed in enumerate((0.004, 0.02))
    ]
    made = jn.spring_map(given)
    for curve in made.curves:
        beyond = curve.deflection > 0.002  # friction turns round at contact
        truth = law(curve.deflection)
        counts.add("force", ((curve.low <= truth) & (truth <= curve.high))[beyond])
    counts.add(
        "shape", made.shape == {linear: "linear", progressive: "progressive"}.get(kind, "helper")
    )
    for section, truth in zip(made.sections, rates, strict=False):
        counts.add("rate", section.rate.has(truth))
    for knee in made.knees if kind is Helper else ():
        counts.add("knee", knee.deflection.has(law.knee))
        counts.add("block load", knee.force.has(law.block))
        counts.add("helper", knee.helper_rate is not None and knee.helper_rate.has(law.helper))
    counts.add("no effect of speed", made.speed_effect.has(0.0))


def _count_stop(counts: Counts, rng: np.random.Generator, offsets: dict) -> None:
    stop = RubberStop(
        rng.uniform(40.0, 120.0), rng.uniform(60.0, 110.0), softening=rng.uniform(0.1, 0.4)
    )
    shared = {"stroke": 0.025, "cycles": 5, **offsets}
    given = [record(stop, rng, f"{v}.csv", speed=v, **shared) for v in SPEEDS]
    made = jn.spring_map(given, part="bump-stop")
    for curve, speed in zip(made.curves, SPEEDS, strict=True):
        force, half = stop_truth(stop, Press(speed=speed, **shared), curve.deflection)
        counts.add("stop", (curve.low <= force) & (force <= curve.high))
        counts.add("hysteresis", (curve.hysteresis_low <= half) & (half <= curve.hysteresis_high))
    between = made.at(0.006)
    force, _ = stop_truth(stop, Press(speed=0.006, **shared), between.deflection)
    counts.add("between speeds", (between.low <= force) & (force <= between.high))


def hold(counts: Counts, share: float) -> None:
    inside, every = (sum(column) for column in zip(*counts.values(), strict=True))
    assert inside / every >= share, counts


@pytest.mark.slow
def test_truths_are_inside_their_intervals_on_a_hundred_parts() -> None:
    counts = covered(range(300, 400))
    hold(counts, 0.92)
    assert all(inside / every >= 0.8 for inside, every in counts.values()), counts


def test_truths_are_inside_their_intervals() -> None:
    hold(covered(range(106, 109)), 0.85)  # few parts: a helper twice, and a stop


def test_intervals_are_of_use() -> None:
    rng = np.random.default_rng(4)
    made = jn.spring_map([record(linear(30e3), rng)])
    assert (made.curve.high - made.curve.low)[-1] < 0.005 * made.curve.force[-1]
    low, high = made.sections[0].rate.interval
    assert high - low < 0.003 * 30e3


@pytest.mark.parametrize("signs", [(1, 1), (-1, -1), (-1, 1), (1, -1)])
def test_signs_are_found_and_said(signs: tuple[int, int]) -> None:
    made = jn.spring_map([record(linear(30e3), np.random.default_rng(1), signs=signs)])
    assert made.sections[0].rate.value == pytest.approx(30e3, rel=2e-3)
    assert ("springs.stroke_reversed" in codes(made)) == (signs[0] < 0)
    assert ("springs.force_reversed" in codes(made)) == (signs[1] < 0)
    run = made.runs[0]
    assert (run.stroke_positive == "extension") == (signs[0] < 0)
    assert (run.force_positive == "tension") == (signs[1] < 0)


def test_coil_bind_is_found_behind_a_helper() -> None:
    law = with_bind(Helper(15e3, 60e3, 300.0), 0.046, 2e6)
    made = jn.spring_map([record(law, np.random.default_rng(2), force_noise=0.5)])
    assert [knee.kind for knee in made.knees] == ["helper", "bind"]
    assert made.knees[1].deflection.value == pytest.approx(0.046, abs=2e-4)
    assert {"springs.helper", "springs.bind"} <= codes(made)
    plain = jn.spring_map([record(with_bind(linear(30e3), 0.044, 3e6), np.random.default_rng(2))])
    assert [knee.kind for knee in plain.knees] == ["bind"]
    assert plain.sections[0].rate.value == pytest.approx(30e3, rel=3e-3)
    assert "curve" in plain.spring  # a rate alone would hide the bind


def test_a_saturated_load_cell_is_said_and_cut_off() -> None:
    given = record(linear(30e3), np.random.default_rng(3))
    top = 1000.0 + 15.0
    cut = replace(given, force=np.minimum(given.force, top))
    made = jn.spring_map([cut])
    (said,) = [item for item in made.findings if item.code == "springs.saturated"]
    assert said.severity == "problem"
    assert made.curve.deflection[-1] < 1000.0 / 30e3
    assert made.sections[0].rate.value == pytest.approx(30e3, rel=3e-3)


def test_records_without_free_travel_say_that_their_zero_is_open() -> None:
    rng = np.random.default_rng(5)
    loaded = record(lambda d: linear(30e3)(d + 0.01), rng, free=0.0, force_offset=0.0)
    made = jn.spring_map([loaded])
    assert "springs.starts_loaded" in codes(made)
    assert made.curve.force[0] == pytest.approx(300.0, rel=0.05)
    unloaded = jn.spring_map([record(linear(30e3), rng, free=0.0, force_offset=5.0)])
    assert "springs.no_free_travel" in codes(unloaded)
    assert unloaded.runs[0].contact.interval is None


def test_backlash_cancels_and_is_said_with_its_interval() -> None:
    made = jn.spring_map([record(linear(30e3), np.random.default_rng(6), backlash=8e-4)])
    (said,) = [item for item in made.findings if item.code == "springs.lost_motion"]
    assert said.value == pytest.approx(8e-4, rel=0.1)
    truth = 30e3 * made.curve.deflection
    assert np.abs(made.curve.force - truth)[2:].max() < 0.004 * truth[-1]


def test_friction_is_hysteresis() -> None:
    made = jn.spring_map([record(linear(30e3), np.random.default_rng(7), friction=60.0)])
    assert np.median(made.curve.hysteresis) == pytest.approx(60.0, rel=0.05)
    assert "springs.hysteresis" in codes(made)


def test_a_stop_softens_and_stiffens_with_speed() -> None:
    rng = np.random.default_rng(8)
    shared = {"stroke": 0.025, "cycles": 5, "force_noise": 0.5}
    given = [record(RubberStop(), rng, f"{v}.csv", speed=v, **shared) for v in SPEEDS]
    made = jn.spring_map(given, part="bump-stop", gap="30 mm", packers="8 mm")
    assert {"springs.first_cycle", "springs.speed_effect", "springs.stop_hysteresis"} <= codes(made)
    assert [curve.speed for curve in made.curves] == pytest.approx(SPEEDS, rel=0.02)
    low, high = made.speed_effect.interval
    assert 0.0 < low < high
    upper = np.linspace(0.3, 0.95, 14) * made.curve.deflection[-1]
    ends = [
        stop_truth(RubberStop(), Press(speed=v, **shared), upper)[0].sum()
        for v in (SPEEDS[0], SPEEDS[-1])
    ]
    assert low < np.sqrt(ends[1] / ends[0]) - 1.0 < high
    stop = made.bump_stop
    assert stop["gap"] == pytest.approx(0.022)
    law = stop["rate"] * made.curve.deflection + stop["progression"] * made.curve.deflection**3
    assert np.abs(law - made.curve.force).max() == pytest.approx(
        made.law.misses * made.curve.force.max(), rel=1e-6
    )
    for speed in (SPEEDS[0], "20 mm/s", SPEEDS[-1]):
        assert made.at(speed).force[-1] > 300.0
    with pytest.raises(DescriptionError, match="not among the loading speeds"):
        made.at("1 m/s")


def test_bad_files_are_findings_and_the_others_are_used(tmp_path: Path) -> None:
    rng = np.random.default_rng(9)
    for k in range(3):
        time, stroke, force = Press().record(linear(30e3), rng)
        _write(tmp_path / f"good_{k}.csv", time, stroke, force)
    _write(tmp_path / "newton_as_kilo.csv", time, stroke, 1e3 * force)
    _write(tmp_path / "still.csv", time, 0.0 * stroke, force)
    _write(tmp_path / "short.csv", time[:20], stroke[:20], force[:20])
    (tmp_path / "volts.csv").write_text("time [s],u [V]\n0,1\n1,2\n", encoding="utf-8")
    made = jn.spring_map([tmp_path])
    left = {item.place: item.code for item in made.findings}
    assert left["newton_as_kilo.csv"] == "springs.unlike_others"
    assert {left[name] for name in ("still.csv", "short.csv", "volts.csv")} == {
        "springs.file_left_out"
    }
    assert sorted(run.file for run in made.runs) == ["good_0.csv", "good_1.csv", "good_2.csv"]
    with pytest.raises(FitError, match="no record of a press can be used"):
        jn.spring_map([tmp_path / "volts.csv"])


def test_two_files_in_other_units_are_named() -> None:
    rng = np.random.default_rng(10)
    given = record(linear(30e3), rng, "a.csv")
    other = replace(given, path="b.csv", force=given.force / 9.81)
    assert "springs.files_differ" in codes(jn.spring_map([given, other]))
    kilo = replace(given, force=given.force * 1e3)
    assert "springs.implausible" in codes(jn.spring_map([kilo]))


def test_without_time_and_without_unloading() -> None:
    given = record(linear(30e3), np.random.default_rng(11), cycles=1)
    half = len(given.force) // 2
    loading = PressFile("up.csv", given.deflection[:half], given.force[:half])
    made = jn.spring_map([loading])
    assert {"springs.no_unloading", "springs.one_cycle"} <= codes(made)
    assert not made.curve.has_unloading
    assert np.isnan(made.curve.speed)
    assert made.sections[0].rate.interval is None
    with pytest.raises(DescriptionError, match="no time"):
        made.at(0.01)


def test_the_law_enters_a_rig_with_its_source(tmp_path: Path) -> None:
    rng = np.random.default_rng(12)
    given = record(progressive(20e3, 3e5, 0.0), rng, "mine.csv", force_noise=0.3)
    made = jn.spring_map([given], rig="kart-quarter-car")
    assert "mine.csv" in made.rig_text.splitlines()[0]
    file = tmp_path / "kart.toml"
    file.write_text(made.rig_text, encoding="utf-8")
    curve = jn.load(file).strut.spring.curve
    assert np.interp(0.03, curve.deflection, curve.force) == pytest.approx(870.0, rel=5e-3)
    file.write_text(
        made.rig_text.replace("[strut.spring]", "[strut.spring]\npreload = 250.0"), encoding="utf-8"
    )
    loaded = jn.load("kart-quarter-car").with_changes({"strut.spring.preload": 250.0})
    preloaded = tmp_path / "preloaded.toml"
    jn.save(loaded, preloaded)
    shifted = jn.spring_map([given], rig=str(preloaded)).rig_text
    file.write_text(shifted, encoding="utf-8")
    spring = jn.load(file).strut.spring
    begin = (-20e3 + np.sqrt(20e3**2 + 4.0 * 3e5 * 250.0)) / (2.0 * 3e5)
    at = np.interp(0.01, spring.curve.deflection, spring.curve.force) + spring.preload
    assert at == pytest.approx(20e3 * (begin + 0.01) + 3e5 * (begin + 0.01) ** 2, rel=1e-2)


@pytest.mark.parametrize(
    ("options", "match"),
    [
        ({"part": "damper"}, "unknown part"),
        ({"gap": 0.01}, "neither gap nor packers"),
        ({"part": "bump-stop", "packers": "3 mm"}, "gap without packers"),
        ({"part": "bump-stop", "gap": "5 mm", "packers": "9 mm"}, "thicker than the gap"),
        ({"part": "bump-stop", "gap": "5 mm", "packers": "-1 mm"}, "invalid thickness"),
        ({"stroke_positive": "down"}, "stroke_positive"),
    ],
)
def test_refusals(options: dict[str, object], match: str) -> None:
    given = record(linear(30e3), np.random.default_rng(13), cycles=2)
    with pytest.raises((DescriptionError, FitError), match=match):
        jn.spring_map([given], **options)


def test_figure_page_and_table() -> None:
    made = jn.spring_map([record(Helper(15e3, 60e3, 300.0), np.random.default_rng(14))])
    figure = jn.plots.figure_of(made)
    assert [axis.get_ylabel() for axis in figure.axes] == ["force [N]", "rate [N/mm]"]
    from jounce.report.springs import spring_map_page

    assert spring_map_page(made, title="Spring").title == "Spring"
    rows = made.table().splitlines()
    assert len(rows) == 1 + len(made.curve.deflection)
    plain = made.to_dict()
    assert plain["spring"]["curve"]["kind"] == "table"
    assert plain["bump_stop"] is None


def _write(file: Path, time: np.ndarray, stroke: np.ndarray, force: np.ndarray) -> None:
    rows = np.column_stack([time, 1e3 * stroke, force])
    np.savetxt(
        file, rows, delimiter=",", header="time [s],displacement [mm],force [N]", comments=""
    )
