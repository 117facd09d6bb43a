"""The virtual bench: deterministic files, honest headers, and a truth that characterisation finds again."""

import tomllib

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import OutputError
from jounce.identify.force_deflection import ForceDeflectionTrial
from jounce.identify.stiffness import fit_stiffness
from jounce.papers import virtual_bench
from jounce.papers.table2 import table2
from jounce.papers.virtual_bench import SENSORS, BenchPlan, course, make_measurements, measurement_texts, true_pass
from jounce.recordings import read_columns, read_recording
from jounce.roads import HalfSine, Train

SMALL = BenchPlan(spring_trials=2, tyre_trials=1, decays=1, trials=table2()[:1], duration=0.5)


@pytest.fixture(scope="module")
def texts():
    return measurement_texts(BenchPlan(duration=1.0))


def bench_trials(folder, pattern):
    found = []
    for file in sorted((folder / "bench").glob(pattern)):
        table, findings = read_columns(file, {"displacement": "m", "force": "N"})
        assert findings == []
        found.append(ForceDeflectionTrial(table["displacement"], table["force"], file.name))
    return found


def test_same_plan_gives_the_same_bytes(tmp_path):
    for name in ("one", "two"):
        make_measurements(tmp_path / name, SMALL)
    one, two = (sorted((tmp_path / name).rglob("*.*")) for name in ("one", "two"))
    assert len(one) == 2 + 2 + 1 + 1 + 1  # springs, tyres at two pressures, decay, pass, truth
    assert [file.name for file in one] == [file.name for file in two]
    assert [file.read_bytes() for file in one] == [file.read_bytes() for file in two]


def test_another_seed_gives_other_noise():
    assert (
        measurement_texts(SMALL)["bench/spring_1.csv"]
        != measurement_texts(BenchPlan(spring_trials=1, tyre_trials=0, decays=0, trials=(), seed=1))[
            "bench/spring_1.csv"
        ]
    )


def test_every_file_says_that_it_is_synthetic(texts):
    assert len(texts) == 5 + 3 * 2 + 4 + 16
    for text in texts.values():
        assert text.startswith("# Synthetic: ")


def test_what_exists_is_not_overwritten_and_nothing_else_is_written(tmp_path):
    (tmp_path / "bench").mkdir()
    (tmp_path / "bench" / "spring_2.csv").write_text("mine")
    with pytest.raises(OutputError, match="spring_2"):
        make_measurements(tmp_path, SMALL)
    assert [file.name for file in tmp_path.rglob("*.*")] == ["spring_2.csv"]
    make_measurements(tmp_path, SMALL, force=True)
    assert (tmp_path / "bench" / "spring_2.csv").read_text().startswith("# Synthetic")


def test_spring_and_tyre_slopes_lie_in_the_intervals_found(tmp_path):
    make_measurements(tmp_path, BenchPlan(trials=(), decays=0))
    spring = fit_stiffness(bench_trials(tmp_path, "spring_*.csv"))
    assert spring.stiffness.interval[0] < virtual_bench.SPRING_RATE < spring.stiffness.interval[1]
    assert 0.003 < spring.loss_factor < 0.03
    # quarter-car prototype paper, section 8: linear fits of the tyre above 2 mm
    for pattern, published in (("tyre_031_*.csv", 138468.0), ("tyre_025_*.csv", 125800.0)):
        tyre = fit_stiffness(bench_trials(tmp_path, pattern), discard_below=0.002)
        low, high = tyre.stiffness.interval
        assert low < published < high
        assert (high - low) / published < 0.06


def test_intervals_of_the_spring_rate_cover_the_truth_on_most_benches():
    hits, count = 0, 60
    for seed in range(count):
        made = measurement_texts(BenchPlan(tyre_trials=0, decays=0, trials=(), seed=seed))
        trials = [
            ForceDeflectionTrial(*(np.loadtxt(text.splitlines()[2:], delimiter=",").T * [[1e-3], [1.0]]), name)
            for name, text in made.items()
        ]
        low, high = fit_stiffness(trials).stiffness.interval
        hits += low <= virtual_bench.SPRING_RATE <= high
    assert 52 <= hits <= 60  # binomial(60, 0.95): below 52 with probability 0.005


def test_the_standing_tyre_is_soft_at_first_and_the_rolling_one_is_not(tmp_path):
    x, force = virtual_bench.tyre_cycle(0.010, 201, 310e3, 1.0)
    start, later = force[20] / x[20], (force[160] - force[80]) / (x[160] - x[80])  # 1 mm; 4 to 8 mm
    assert start < 0.75 * later
    rolling = virtual_bench.TYRE_CURVES[310e3]
    assert 0.85 * later < rolling[0] < later


def test_recordings_hold_the_channels_at_the_stated_rate(tmp_path):
    make_measurements(tmp_path, SMALL)
    run, findings = read_recording(tmp_path / "trials" / "01.csv")
    assert findings == []
    assert set(run.data_vars) == {"sprung.az", "unsprung.az"}
    assert len(run["time"]) == 501
    rest = run.sel(time=slice(0.0, 0.08))  # before the obstacle: bias and noise only
    for name, sensor in SENSORS.items():
        values = rest[name].to_numpy()
        assert np.std(values) == pytest.approx(sensor.noise, rel=0.25)
        assert np.mean(values) == pytest.approx(sensor.bias, abs=4.0 * sensor.noise / np.sqrt(len(values)))


def test_truth_file_holds_the_values_behind_the_files(tmp_path):
    make_measurements(tmp_path, SMALL)
    truth = tomllib.loads((tmp_path / "truth.toml").read_text())
    assert truth["spring_rate"] == virtual_bench.SPRING_RATE
    assert truth["tyre"]["coefficients"]["0.25 MPa"] == list(virtual_bench.TYRE_CURVES[250e3])
    assert truth["trial"]["1"]["speed"] == true_pass(table2()[0]).speed
    assert truth["friction"]["guide"] == jn.load(write_rig(tmp_path)).guide_friction.force


def write_rig(folder):
    import tomlkit

    table = virtual_bench.true_rig().model_dump(by_alias=True, exclude_none=True)
    file = folder / "true-rig.toml"
    file.write_text(tomlkit.dumps(table))
    return file


@pytest.mark.parametrize("row", table2(), ids=lambda row: f"trial-{row.number}")
def test_the_true_speed_rounds_to_the_printed_one(row):
    truth = true_pass(row)
    assert round(truth.speed, 2) == row.speed
    assert abs(truth.lag) <= 0.6e-3


def test_courses_are_those_of_the_campaign():
    rows = {row.road: row for row in table2()}
    assert set(rows) == {"A", "B10", "B15", "B20"}
    assert course(rows["A"]) == HalfSine(height="10 mm", length="60 mm", start="0.2 m")
    assert course(rows["B15"]) == Train(of=course(rows["A"]), count=5, pitch="0.15 m")


def test_the_contact_patch_keeps_the_area_of_the_obstacle_and_lowers_its_crest():
    road, speed = HalfSine(height="10 mm", length="60 mm", start="0.2 m"), 2.0
    path = virtual_bench.wheel_path(road, speed, 1.0)
    time, height = np.array(path.time), np.array(path.height)
    half = 0.5 * virtual_bench.CONTACT_LENGTH
    # mean of h sin(pi x / l) over +-half around the crest
    crest = 0.010 * np.sin(np.pi * half / 0.060) / (np.pi * half / 0.060)
    assert height.max() == pytest.approx(crest, rel=1e-3)
    slowed = 1.0 - virtual_bench.SPEED_DROP  # the belt slows down at the foot; it recovers little within the obstacle
    area = np.trapezoid(height, time) * speed
    assert area == pytest.approx(0.010 * 0.060 * 2.0 / np.pi / slowed, rel=1e-3)
    assert np.all(np.diff(time) > 0.0)


def test_a_train_slows_the_belt_at_every_obstacle():
    row = next(row for row in table2() if row.road == "B20")
    road = course(row)
    path = virtual_bench.wheel_path(road, 2.0, 3.0)
    height, time = np.array(path.height), np.array(path.time)
    crests = time[1:-1][(height[1:-1] > height[:-2]) & (height[1:-1] > height[2:]) & (height[1:-1] > 0.008)]
    assert len(crests) == 5
    late = crests - (0.2 + 0.03 + 0.2 * np.arange(5)) / 2.0
    assert np.all(np.diff(late) > 0.0)
    assert 2e-3 < late[-1] < 8e-3
