"""Maps of dampers of known physics: what is inside the intervals, which files are refused, and the law for a rig."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from tests.unit.dampers.shim_stack import ShimDamper, Side, record

import jounce as jn
from jounce.core.errors import DescriptionError, FitError, RecordingError
from jounce.dampers.files import settings_in_name

SPEEDS = (0.05, 0.1, 0.2, 0.4, 0.8)


def records(damper: ShimDamper, rng: np.random.Generator, clicks=(0,), speeds=SPEEDS, **options):
    return [
        jn.RecordFile(f"c{c}_{speed}.csv", record(damper.with_clicks(c), speed, rng, **options))
        for c in clicks
        for speed in speeds
    ]


def with_force(data: xr.Dataset, force: np.ndarray) -> xr.Dataset:
    return data.assign(force=data["force"].copy(data=force))


def valves(damper: ShimDamper, clicks: float, velocity: np.ndarray) -> np.ndarray:
    return damper.with_clicks(clicks).valves(velocity) + damper.friction * np.sign(velocity)


def random_damper(rng: np.random.Generator) -> ShimDamper:
    sides = [
        Side(rng.uniform(3e-6, 1e-5), rng.uniform(2e5, 1.2e6), rng.uniform(1.5e-10, 6e-10))
        for _ in range(2)
    ]
    return ShimDamper(
        *sides,
        rng.uniform(60, 250),
        rng.uniform(100, 1500),
        rng.uniform(0, 25),
        rng.uniform(0, 3e-3),
    )


def covered(seeds: range) -> dict[str, tuple[int, int]]:
    """Count truths inside their intervals, by quantity."""
    counts: dict[str, tuple[int, int]] = {}

    def count(name: str, inside: object) -> None:
        inside = np.atleast_1d(inside)
        before = counts.get(name, (0, 0))
        counts[name] = before[0] + int(inside.sum()), before[1] + inside.size

    for seed in seeds:
        rng = np.random.default_rng(seed)
        damper, clicks = random_damper(rng), (0, 4, 8)
        given = records(
            damper, rng, clicks, noise=rng.uniform(1, 8), seconds=15,
            with_velocity=bool(rng.integers(2)), signs=[(1, 1), (-1, -1), (-1, 1), (1, -1)][seed % 4],
        )  # fmt: skip
        made = jn.damper_map(given, reading=("peak", "continuous")[seed % 2])
        for item in made.settings:
            truth = valves(damper, item.settings["clicks"], item.velocity)
            count("force", (item.low <= truth) & (truth <= item.high))
            count("gas force", item.gas_force.has(damper.gas))
            count("gas stiffness", item.gas_stiffness.has(damper.gas_stiffness))
            count("friction", item.friction.has(damper.friction))
            count("lag", item.lag.has(damper.lag))
        for place in (2.0, 6.0):
            curve = made.at(place)
            truth = valves(damper, place, curve.velocity)
            count("between clicks", (curve.low <= truth) & (truth <= curve.high))
    return counts


def hold(counts: dict[str, tuple[int, int]], share: float) -> None:
    assert {"force", "gas force", "friction", "lag", "between clicks"} <= counts.keys()
    inside, all_of = (sum(column) for column in zip(*counts.values(), strict=True))
    assert inside / all_of >= share, counts


def test_truths_are_inside_their_intervals():
    hold(covered(range(100, 103)), 0.92)


@pytest.mark.slow
def test_truths_are_inside_their_intervals_on_a_hundred_dampers():
    counts = covered(range(200, 300))
    hold(counts, 0.92)
    assert all(inside / all_of >= 0.85 for inside, all_of in counts.values()), counts


def test_intervals_are_of_use():
    rng = np.random.default_rng(7)
    made = jn.damper_map(records(ShimDamper(), rng, (0, 4, 8), seconds=15))
    for item in made.settings:
        fast = np.abs(item.velocity) > 0.15
        assert np.all((item.high - item.low)[fast] < 0.1 * np.abs(item.force)[fast])
    assert made.reading == "peak"
    assert made.clicks == (0.0, 4.0, 8.0)


def rubbing(frequency: float, digits: str) -> xr.Dataset:
    """A damper like the bicycle's of the kart paper, of which hardly more than friction is left; its seals creep."""
    rng = np.random.default_rng(1)
    t = np.arange(0.0, 12.0, 1e-3)
    x = 0.02 * np.sin(2.0 * np.pi * frequency * t)
    v = 0.04 * np.pi * frequency * np.cos(2.0 * np.pi * frequency * t)
    force = 38.0 * np.tanh(v / 4e-3) + 25.0 * v + rng.normal(0.0, 0.8, len(t))
    written = np.array([float(format(value, digits)) for value in x])
    return jn.recording(t, {"displacement": (written, "m", ""), "force": (force, "N", "")})


def test_a_damper_that_only_rubs_is_called_so():
    given = [jn.RecordFile(f"{f}.csv", rubbing(f, ".5g")) for f in (0.5, 1.0, 2.0, 3.0)]
    made = jn.damper_map(given)
    (item,) = made.settings
    assert item.friction.has(38.0)
    assert item.friction.standard_error < 1.5
    (told,) = (each for each in made.findings if each.code == "dampers.friction_rules")
    assert "not viscous" in str(told)
    # Rounding to five digits makes the ends of the stroke flat: nothing was out of range.
    assert not any("limits" in str(each) for each in made.findings)


def test_a_map_written_beside_its_records_is_no_record(tmp_path):
    for frequency in (1.0, 2.0, 3.0):
        jn.write_recording(rubbing(frequency, ".9g"), tmp_path / f"{frequency}.nc")
    made = jn.damper_map(tmp_path)
    table = tmp_path / "map.csv"
    table.write_text(made.table(), encoding="utf-8")
    again = jn.damper_map(tmp_path)
    assert again.findings == made.findings
    assert again.table() == made.table()
    with pytest.raises(FitError, match="a map, no record"):
        jn.damper_map([table])


def test_a_stroke_out_of_range_is_still_told():
    record = rubbing(1.0, ".5g")
    cut = record["displacement"].clip(-0.019, 0.019)
    made = jn.damper_map([jn.RecordFile("cut.csv", record.assign(displacement=cut))])
    assert sum("flat at its limits" in str(each) for each in made.findings) == 1


@pytest.mark.parametrize("signs", [(1, 1), (-1, -1), (-1, 1), (1, -1)])
def test_signs_are_found_from_the_gas_force(signs):
    rng = np.random.default_rng(3)
    made = jn.damper_map(records(ShimDamper(), rng, speeds=(0.1, 0.2, 0.4, 0.8), signs=signs))
    (item,) = made.settings
    truth = valves(ShimDamper(), 0, item.velocity)
    assert np.abs(item.force - truth).max() < 0.02 * np.abs(truth).max()
    codes = {finding.code for finding in made.findings}
    assert ("dampers.both_signs_reversed" in codes) == (signs == (-1, -1))


def test_plateaus_of_a_triangle_are_read_at_their_velocity():
    rng = np.random.default_rng(1)
    damper = replace(ShimDamper(), lag=0.0)
    given = []
    for speed in (0.1, 0.3, 0.6):
        t = np.arange(0.0, 10.0, 1e-3)
        phase = (t * speed / 0.05 + 0.3) % 2.0
        x = 0.05 * np.abs(phase - 1.0) - 0.025
        v = np.where(phase < 1.0, -speed, speed)
        force = damper.on_rig(x, v, np.zeros_like(v)) + rng.standard_normal(len(t))
        channels = {
            "displacement": (x, "m", ""),
            "velocity": (v, "m/s", ""),
            "force": (force, "N", ""),
        }
        given.append(jn.RecordFile(f"{speed}.csv", jn.recording(t, channels)))
    made = jn.damper_map(given)
    assert [run.motion for run in made.runs] == ["triangle"] * 3
    (item,) = made.settings
    assert item.velocity == pytest.approx([-0.6, -0.3, -0.1, 0.1, 0.3, 0.6], rel=1e-3)
    truth = (
        valves(damper, 0, item.velocity) + damper.gas
    )  # nothing in a triangle tells the force at rest
    assert item.force == pytest.approx(truth, rel=0.01)
    assert "dampers.gas_unknown" in {finding.code for finding in made.findings}


def test_a_crank_is_told_from_a_sine():
    t = np.arange(0.0, 10.0, 1e-3)
    phase, rod = 8.0 * t, 0.08
    x = 0.025 * np.cos(phase) + np.sqrt(rod**2 - (0.025 * np.sin(phase)) ** 2)
    v = np.gradient(x, t)
    given = [
        jn.RecordFile("crank.csv", jn.recording(t, {"displacement": (x, "m", ""), "force": (900 * v, "N", "")}))
    ]  # fmt: skip
    assert [run.motion for run in jn.damper_map(given).runs] == ["crank"]


def test_one_bad_file_is_named_and_the_others_are_used(tmp_path: Path):
    rng = np.random.default_rng(5)
    for file in records(ShimDamper(), rng, speeds=(0.1, 0.2, 0.4)):
        jn.write_recording(file.data, tmp_path / str(file.path))
    text = (tmp_path / "c0_0.2.csv").read_text()
    (tmp_path / "volts.csv").write_text(text.replace("[m]", "[V]"))
    (tmp_path / "cut.csv").write_text(text[: len(text) // 900])
    (tmp_path / "c0_thousand.csv").write_text(text.replace("force [N]", "force [kN]"))
    made = jn.damper_map(tmp_path)
    assert len(made.runs) == 3
    left = {item.place: item.code for item in made.findings if item.code.startswith("dampers.")}
    assert left == {
        "volts.csv": "dampers.file_left_out",
        "cut.csv": "dampers.file_left_out",
        "c0_thousand.csv": "dampers.unlike_others",
    }


def test_a_record_in_kilonewtons_and_one_turned_round_are_left_out():
    rng = np.random.default_rng(5)
    given = records(ShimDamper(gas=0.0), rng, speeds=(0.1, 0.2, 0.3, 0.4))
    big = with_force(given[1].data, 1000.0 * given[1].data["force"].to_numpy())
    turned = with_force(given[2].data, -given[2].data["force"].to_numpy())
    turned["displacement"] = turned["displacement"].copy(data=-turned["displacement"].to_numpy())
    made = jn.damper_map(
        [*given, jn.RecordFile("c0_kN.csv", big), jn.RecordFile("c0_turned.csv", turned)]
    )
    codes = {
        finding.place: finding.code for finding in made.findings if finding.severity == "problem"
    }
    assert codes == {
        "c0_kN.csv": "dampers.unlike_others",
        "c0_turned.csv": "dampers.bump_is_rebound",
    }
    assert len(made.runs) == 4


def test_fade_missing_force_and_unlike_repeats_are_named():
    rng = np.random.default_rng(2)
    hot = record(ShimDamper(), 0.4, rng, seconds=30)
    hot = with_force(hot, hot["force"].to_numpy() * (1.0 - 0.1 * hot["time"].to_numpy() / 30.0))
    made = jn.damper_map([jn.RecordFile("hot.csv", hot)])
    assert {"dampers.fades"} <= {finding.code for finding in made.findings}
    assert made.runs[0].fade.value == pytest.approx(-0.105, abs=0.01)

    empty = record(ShimDamper(), 0.4, rng, seconds=10, with_velocity=True)
    x, v = empty["displacement"].to_numpy(), empty["velocity"].to_numpy()
    noise = 3.0 * rng.standard_normal(len(v))
    lost = (v > 0.0) & (x < -0.015)  # 10 mm after the reversal into bump
    empty = with_force(empty, np.where(lost, ShimDamper().gas + noise, empty["force"].to_numpy()))
    made = jn.damper_map([jn.RecordFile("cavitates.csv", empty)])
    (travel,) = [item for item in made.findings if item.code == "dampers.dead_travel"]
    assert travel.value == pytest.approx(0.010, abs=0.003)

    twice = [
        jn.RecordFile("c4_a.csv", record(ShimDamper(), 0.4, rng)),
        jn.RecordFile("c4_b.csv", record(ShimDamper().with_clicks(3), 0.4, rng)),
    ]
    made = jn.damper_map(twice)
    assert "dampers.repeats_differ" in {finding.code for finding in made.findings}
    assert made.settings[0].repeatability > 0.03


@pytest.mark.parametrize("seed", [0, 5])
def test_a_sound_damper_gives_no_alarm(seed: int):
    """Slow loops are open by the gas, fast ones by the oil: neither is cavitation, nor a reversed sign."""
    rng = np.random.default_rng(seed)
    made = jn.damper_map(records(random_damper(rng), rng, seconds=15, noise=5.0))
    assert [item for item in made.findings if item.code.startswith("dampers.")] == []
    assert len(made.runs) == len(SPEEDS)


def test_settings_come_from_the_table_before_names(tmp_path: Path):
    rng = np.random.default_rng(4)
    given = records(ShimDamper(), rng, (0, 4), speeds=(0.2,))
    table = tmp_path / "settings.csv"
    table.write_text("file;clicks;temperature [degC];gas pressure [bar]\nc0_0.2.csv;6;40;10\n")
    made = jn.damper_map(given, table)
    by_file = {item.files[0]: item.settings for item in made.settings}
    assert by_file["c0_0.2.csv"] == pytest.approx(
        {"clicks": 6.0, "temperature": 313.15, "gas_pressure": 1e6}
    )
    assert by_file["c4_0.2.csv"] == {"clicks": 4.0}
    assert "dampers.not_in_table" in {finding.code for finding in made.findings}
    stated = jn.damper_map(given, {"c0_0.2": {"clicks": 1}, "c4_0.2": {"clicks": 2}})
    assert stated.clicks == (1.0, 2.0)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("name,clicks\na,1\n", "names of the files"),
        ("file,colour\na,1\n", "unknown setting"),
        ("file,temperature [mm]\na,1\n", "temperature"),
    ],
)
def test_a_wrong_table_of_settings_is_refused(tmp_path: Path, text: str, message: str):
    table = tmp_path / "settings.csv"
    table.write_text(text)
    rng = np.random.default_rng(4)
    with pytest.raises((RecordingError, DescriptionError), match=message):
        jn.damper_map(records(ShimDamper(), rng, speeds=(0.2,)), table)


def test_settings_in_names():
    assert settings_in_name("rear_12clicks_run3.csv") == {"clicks": 12.0}
    assert settings_in_name("LF C8 T25.csv") == pytest.approx(
        {"clicks": 8.0, "temperature": 298.15}
    )
    assert settings_in_name("150psi.csv") == pytest.approx({"gas_pressure": 1034213.6}, rel=1e-5)
    assert settings_in_name("record_2024.csv") == {}
    assert settings_in_name("accel3_test4.csv") == {}


def test_nothing_to_read_is_refused(tmp_path: Path):
    with pytest.raises(RecordingError, match="no records in this folder"):
        jn.damper_map(tmp_path)
    with pytest.raises(RecordingError, match="no such file"):
        jn.damper_map([tmp_path / "a.csv"])
    (tmp_path / "a.csv").write_text("nothing")
    with pytest.raises(FitError, match="no record of a damper"):
        jn.damper_map(tmp_path)


def test_the_map_is_a_law_whose_clicks_move_like_any_number():
    rng = np.random.default_rng(7)
    made = jn.damper_map(records(ShimDamper(), rng, (0, 4, 8)))
    rig = jn.load("kart-quarter-car").with_changes({"strut.damper": made.damper})
    assert rig.strut.damper.clicks == 4.0
    law = rig.with_changes({"strut.damper.clicks": 2.0}).strut.damper
    curve = made.at(2.0)
    steady = curve.force - made.settings[0].friction.value * np.sign(curve.velocity)
    assert law.forces(curve.velocity) == pytest.approx(steady, abs=0.02 * np.abs(steady).max())
    with pytest.raises(DescriptionError, match="not among the clicks that were measured"):
        rig.with_changes({"strut.damper.clicks": 9.0})
    with pytest.raises(DescriptionError, match="not among the clicks"):
        made.at(8.5)


@pytest.mark.parametrize(("clicks", "within"), [(2.5, 1e-5), (6.0, 1e-5), (4.0, 1e-3)])
def test_slopes_by_clicks_are_those_of_differences(clicks: float, within: float):
    """At measured clicks both sides bend differently, so that differences are right to first order only."""
    rng = np.random.default_rng(7)
    made = jn.damper_map(records(ShimDamper(), rng, (0, 4, 8), speeds=(0.1, 0.3, 0.6)))
    rig = jn.load("kart-quarter-car").with_changes(
        {"strut.damper": {**made.damper, "clicks": clicks}}
    )
    road = jn.HalfSine(height="10 mm", length="60 mm")
    trial = jn.Trial(road=road, speed="2 m/s", duration="0.3 s")
    path, channel, step = "strut.damper.clicks", "sprung.z", 0.01
    ends = [
        jn.simulate(rig.with_changes({path: clicks + way * step}), trial)[channel].to_numpy()
        for way in (0.5, -0.5)
    ]
    difference = (ends[0] - ends[1]) / step
    exact = jn.sensitivities(rig, trial, [path])[channel].sel(parameter=path).to_numpy()
    assert np.abs(difference).max() > 1e-6
    assert np.abs(exact - difference).max() < within * np.abs(difference).max()


def test_conditions_that_differ_with_the_clicks_are_named():
    rng = np.random.default_rng(7)
    given = records(ShimDamper(), rng, (0, 4), speeds=(0.2,))
    stated = {
        "c0_0.2": {"clicks": 0, "temperature": "20 degC"},
        "c4_0.2": {"clicks": 4, "temperature": "60 degC"},
    }
    codes = [item.code for item in jn.damper_map(given, stated).findings]
    assert codes.count("dampers.conditions_differ") == 1
    assert "dampers.conditions_differ" not in [item.code for item in jn.damper_map(given).findings]


def test_without_clicks_nothing_is_interpolated():
    rng = np.random.default_rng(7)
    given = [jn.RecordFile(f"run{k}.csv", record(ShimDamper(), 0.3, rng)) for k in (1, 2)]
    made = jn.damper_map(given)
    assert made.clicks == ()
    assert made.damper["kind"] == "table"
    with pytest.raises(DescriptionError, match="no clicks"):
        made.at(2.0)
    two = jn.damper_map(records(ShimDamper(), rng, (0, 4), speeds=(0.2, 0.4)))
    assert np.isnan(
        two.at(2.0).low
    ).all()  # two settings do not tell how the force bends between them


def test_an_unknown_reading_is_refused_and_less_than_two_cycles_are_read():
    rng = np.random.default_rng(7)
    with pytest.raises(DescriptionError, match="reading"):
        jn.damper_map(records(ShimDamper(), rng, speeds=(0.2,)), reading="pvp")
    once = jn.damper_map([jn.RecordFile("once.csv", record(ShimDamper(), 0.2, rng, seconds=1.2))])
    (item,) = once.settings
    assert np.isfinite(item.force).all()
    assert item.low.shape == item.force.shape
