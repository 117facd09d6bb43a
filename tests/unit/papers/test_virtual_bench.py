"""The virtual bench: deterministic files, honest headers, and a truth that characterisation finds again."""

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import OutputError
from jounce.identify.force_deflection import ForceDeflectionTrial
from jounce.identify.stiffness import fit_stiffness
from jounce.papers import virtual_bench
from jounce.papers.table2 import table2
from jounce.papers.virtual_bench import (
    BenchPlan,
    course,
    make_measurements,
    measurement_texts,
    shipped_truth,
    true_pass,
)
from jounce.recordings import read_columns, read_recording
from jounce.roads import HalfSine, Train

SMALL = BenchPlan(spring_trials=2, tyre_trials=1, decays=1, trials=table2()[:1], duration=0.5)

TRUTH = shipped_truth()
SPRING_RATE = TRUTH.true_rig().strut.spring.rate


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
        != measurement_texts(
            BenchPlan(spring_trials=1, tyre_trials=0, decays=0, trials=(), seed=1)
        )["bench/spring_1.csv"]
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
    assert spring.stiffness.interval[0] < SPRING_RATE < spring.stiffness.interval[1]
    assert 0.003 < spring.loss_factor < 0.03
    # quarter-car prototype paper, section 8: linear fits of the tyre above 2 mm
    for pattern, published in (("tyre_031_*.csv", 138468.0), ("tyre_025_*.csv", 125800.0)):
        tyre = fit_stiffness(bench_trials(tmp_path, pattern), discard_below=0.002)
        low, high = tyre.stiffness.interval
        assert low < published < high
        assert (high - low) / published < 0.06


@pytest.mark.slow
def test_intervals_of_the_spring_rate_cover_the_truth_on_most_benches():
    hits, count = 0, 60
    for seed in range(count):
        made = measurement_texts(BenchPlan(tyre_trials=0, decays=0, trials=(), seed=seed))
        trials = [
            ForceDeflectionTrial(
                *(np.loadtxt(text.splitlines()[2:], delimiter=",").T * [[1e-3], [1.0]]), name
            )
            for name, text in made.items()
        ]
        low, high = fit_stiffness(trials).stiffness.interval
        hits += low <= SPRING_RATE <= high
    assert 52 <= hits <= 60  # binomial(60, 0.95): below 52 with probability 0.005


def test_the_standing_tyre_is_soft_at_first_and_the_rolling_one_is_not(tmp_path):
    x, force = virtual_bench.tyre_cycle(0.010, 201, 310e3, 1.0)
    start, later = force[20] / x[20], (force[160] - force[80]) / (x[160] - x[80])  # 1 mm; 4 to 8 mm
    assert start < 0.75 * later
    rolling = TRUTH.curve_at(310e3)
    assert 0.85 * later < rolling[0] < later


def test_recordings_hold_the_channels_at_the_stated_rate(tmp_path):
    make_measurements(tmp_path, SMALL)
    run, findings = read_recording(tmp_path / "trials" / "01.csv")
    assert findings == []
    assert set(run.data_vars) == {"sprung.az", "unsprung.az"}
    assert len(run["time"]) == 501
    rest = run.sel(time=slice(0.0, 0.08))  # before the obstacle: bias and noise only
    for name, sensor in TRUTH.sensors.items():
        values = rest[name].to_numpy()
        noise, bias = (float(text.split()[0]) for text in (sensor.noise, sensor.bias))  # m/s^2
        assert np.std(values) == pytest.approx(noise, rel=0.25)
        assert np.mean(values) == pytest.approx(bias, abs=4.0 * noise / np.sqrt(len(values)))


def test_truth_file_holds_the_values_behind_the_files(tmp_path):
    make_measurements(tmp_path, SMALL)
    truth = jn.load_truth(tmp_path / "truth.toml")
    assert truth.model_copy(update={"passes": {}}) == TRUTH
    assert truth.passes["1"].speed == true_pass(table2()[0]).speed
    assert make_measurements(tmp_path / "again", SMALL, truth)
    for file in ("bench/tyre_025_1.csv", "bench/decay_1.csv", "trials/01.csv", "truth.toml"):
        assert (tmp_path / "again" / file).read_bytes() == (tmp_path / file).read_bytes()


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
    half = 0.5 * TRUTH.belt.contact_length
    # mean of h sin(pi x / l) over +-half around the crest
    crest = 0.010 * np.sin(np.pi * half / 0.060) / (np.pi * half / 0.060)
    assert height.max() == pytest.approx(crest, rel=1e-3)
    slowed = (
        1.0 - TRUTH.belt.speed_drop
    )  # the belt slows down at the foot; it recovers little within the obstacle
    area = np.trapezoid(height, time) * speed
    assert area == pytest.approx(0.010 * 0.060 * 2.0 / np.pi / slowed, rel=1e-3)
    assert np.all(np.diff(time) > 0.0)


def test_a_train_slows_the_belt_at_every_obstacle():
    row = next(row for row in table2() if row.road == "B20")
    road = course(row)
    path = virtual_bench.wheel_path(road, 2.0, 3.0)
    height, time = np.array(path.height), np.array(path.time)
    crests = time[1:-1][
        (height[1:-1] > height[:-2]) & (height[1:-1] > height[2:]) & (height[1:-1] > 0.008)
    ]
    assert len(crests) == 5
    late = crests - (0.2 + 0.03 + 0.2 * np.arange(5)) / 2.0
    assert np.all(np.diff(late) > 0.0)
    assert 2e-3 < late[-1] < 8e-3


def heights(path, time):
    """Height that an excitation has between its samples, too."""
    pieces = path.profile()
    k = np.clip(np.searchsorted(pieces.edges, time, side="right") - 1, 0, len(pieces.edges) - 2)
    assert set(pieces.kind) <= {0}  # polynomials in the distance from the left edge
    x, c = time - pieces.edges[k], pieces.coefficients[k]
    return c[:, 0] + x * (c[:, 1] + x * (c[:, 2] + x * c[:, 3]))


@pytest.mark.parametrize("patch", ["12 mm", "1 mm", "0 mm"])
@pytest.mark.parametrize("number", [1, 3, 4, 16])
def test_the_belt_is_level_where_no_obstacle_is(number, patch):
    row = table2()[number - 1]
    truth = TRUTH.with_changes({"belt.contact_length": patch})
    road = course(row, truth)
    path = virtual_bench.wheel_path(road, row.speed, 3.0, truth)
    time = np.linspace(0.0, 3.0, 60001)
    height = heights(path, time)
    before, after = time < (road.start - 0.010) / row.speed, time > (road.end() + 0.03) / row.speed
    assert before.sum() > 1000
    assert after.sum() > 1000
    assert np.abs(height[before | after]).max() < 1e-8
    assert 0.0097 < height.max() < 0.0101
    assert height.min() > -1e-4


def test_another_truth_gives_other_recordings_and_says_so(tmp_path):
    free = TRUTH.with_changes(
        {
            "rig.strut.damper": {"coefficient": "104 N*s/m"},
            "rig.strut.friction.force": "0 N",
            "sensors": {"unsprung.az": {"noise": "0.1 m/s^2"}},
            "tyre": {},
            "rig.tyre": {"stiffness": "120 N/mm"},
        }
    )
    made = measurement_texts(SMALL, free)
    assert made["trials/01.csv"].splitlines()[1] == "time [s],unsprung.az [m/s^2]"
    assert made["bench/decay_1.csv"] != measurement_texts(SMALL)["bench/decay_1.csv"]
    x, force = virtual_bench.tyre_cycle(0.010, 201, 250e3, 1.0, free)
    assert force[200] / (x[200] - 0.45e-3) == pytest.approx(120e3, rel=1e-3)
    rig = free.true_rig(250e3)
    assert (rig.strut.damper.coefficient, rig.strut.friction.force, rig.tyre.stiffness) == (
        104.0,
        0.0,
        120e3,
    )


@pytest.mark.parametrize("rig", ["kart-quarter-car", "kart-double-wishbone"])
def test_a_bench_whose_truth_is_the_model_gives_what_the_model_gives(tmp_path, rig):
    """No sensors, no belt, no scatter: the recording of a pass is the simulation of it."""
    made = jn.virtual_bench(tmp_path / "made", jn.BenchTruth(rig=rig), duration=1.0)
    measured, _ = read_recording(made.parent / "trials" / "02.csv")
    row = table2()[1]
    trial = jn.Trial(road=course(row, jn.BenchTruth(rig=rig)), speed=row.speed, duration=1.0)
    run = jn.simulate(jn.with_strut_angle(jn.load(rig), row.strut_angle), trial)
    for name in ("sprung.az", "unsprung.az"):
        wanted = run[name].to_numpy()
        assert np.abs(measured[name].to_numpy() - wanted).max() < 0.02 * np.abs(wanted).max()


@pytest.mark.parametrize(
    ("arguments", "problem"),
    [
        ({"changes": {"belt.speed": 1.0}}, "belt.speed: unknown key.*speed_drop"),
        ({"changes": {"rig.strut.friction.force": "-1 N"}}, "strut.friction.force: out of range"),
        ({"seed": -1}, "seed"),
        ({"duration": 0.4}, "before the obstacles are passed"),
        ({"truth": "nothing.toml"}, "nothing.toml"),
        ({"changes": {"obstacle.start": "0 mm"}}, "begins too early"),
    ],
)
def test_what_cannot_be_is_refused_and_nothing_is_written(tmp_path, arguments, problem):
    with pytest.raises(jn.JounceError, match=problem):
        jn.virtual_bench(tmp_path / "made", **arguments)
    assert not (tmp_path / "made").exists()


def test_a_change_within_an_element_leaves_it_to_others_and_survives_its_file(tmp_path):
    """In a file the tables of whole elements stand behind the numbers within them; whole elements still come first."""
    given = {"force": "5 N", "regularisation_velocity": "1 mm/s"}
    truth = jn.BenchTruth(
        rig="kart-quarter-car", changes={"strut.friction": given, "strut.friction.force": "2 N"}
    )
    assert truth.true_rig().strut.friction.force == 2.0
    assert given["force"] == truth.changes["strut.friction"]["force"] == "5 N"
    (tmp_path / "truth.toml").write_text(
        virtual_bench.truth_text(BenchPlan(trials=()), truth), encoding="utf-8"
    )
    assert jn.load_truth(tmp_path / "truth.toml").true_rig() == truth.true_rig()
    renewed = truth.with_changes({"rig.strut.friction": {"force": "3 N"}})
    assert renewed.true_rig().strut.friction.force == 3.0


def test_a_rig_s_changes_leave_what_was_given_as_it_was():
    given = {"force": "5 N"}
    jn.load("kart-quarter-car").with_changes(
        {"strut.friction": given, "strut.friction.force": "0 N"}
    )
    assert given == {"force": "5 N"}


def test_vehicles_do_not_stand_on_the_bench():
    with pytest.raises(jn.DescriptionError, match="a quarter car or a corner"):
        jn.BenchTruth(rig="audi-a6-half-car")


def test_a_rig_object_and_a_rig_beside_the_truth_are_taken(tmp_path):
    lumped = jn.lumped_from(jn.load("kart-double-wishbone"))
    assert jn.BenchTruth(rig=lumped).true_rig() == lumped
    texts = virtual_bench.campaign_texts()
    (tmp_path / "quarter-car.toml").write_text(texts["quarter-car.toml"])
    (tmp_path / "truth.toml").write_text('schema = "jounce.truth/1"\nrig = "quarter-car.toml"\n')
    assert jn.load_truth(tmp_path / "truth.toml").true_rig().model == "quarter-car"
