"""A campaign on a rig with hardpoints: known values come back, with and without noise; the shipped one end to end."""

from __future__ import annotations

import tomllib

import numpy as np
import pytest

import jounce as jn
from jounce.campaign import run_campaign
from jounce.core.errors import DescriptionError
from jounce.core.units import to_si
from jounce.design.lumping import lump
from jounce.operations.checks import check_file
from jounce.papers import demo, virtual_bench
from jounce.papers.table2 import table2
from jounce.papers.virtual_bench import campaign_texts, shipped_truth, true_pass
from jounce.parts import rig_from_table
from jounce.parts.variants import strut_angle, with_strut_angle
from jounce.recordings import write_recording
from jounce.report.campaign import lumped_model as lumped_section
from jounce.report.page import PageTable

KART = jn.load("kart-double-wishbone")
TRUTH = {"strut.spring.rate": 23.9e3, "strut.damper.coefficient": 139.0, "tyre.stiffness": 131e3}
FREE = {"strut.spring.rate": "10 %", "strut.damper.coefficient": "10 %", "tyre.stiffness": "10 %"}
BUMP = jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m")
SENSORS = {
    "sprung.az": jn.Sensor(high_pass="0.5 Hz", low_pass="250 Hz", noise=0.15, bias=0.04, gain=1.01),
    "unsprung.az": jn.Sensor(
        high_pass="0.5 Hz", low_pass="250 Hz", noise=0.8, bias=-0.15, gain=0.99
    ),
}
IDEAL = {name: sensor.model_copy(update={"noise": 0.0}) for name, sensor in SENSORS.items()}


def recorded(degrees, speed, sensors, seed=None):
    """One trial of the rig with the true values at a strut angle, as its sensors give it."""
    trial = jn.Trial(road=BUMP, speed=speed, duration="0.6 s")
    truth = with_strut_angle(KART.with_changes(TRUTH), f"{degrees} deg")
    run = jn.simulate(truth, trial, tolerance=1e-9)[list(sensors)]
    return trial, jn.apply_sensors(run, sensors, seed=seed)


def fit(sensors, seed=None, tolerance=1e-9):
    trials = []
    for degrees, speed in ((26, 1.95), (16, 2.86)):
        trial, measured = recorded(
            degrees, speed, sensors, None if seed is None else seed + degrees
        )
        rig = with_strut_angle(KART, f"{degrees} deg")
        trials.append(jn.FitTrial(f"{degrees} deg", rig, trial, measured, sensors))
    return jn.update_model(trials, FREE, tolerance=tolerance)


def test_values_of_a_3d_rig_come_back_without_noise():
    found = fit(IDEAL)
    for path, value in TRUTH.items():
        assert found.parameters[path].value == pytest.approx(value, rel=1e-6), path
        assert not found.parameters[path].at_bound
    assert found.objective_after < 1e-9 * found.objective_before


def test_intervals_cover_the_values_of_a_3d_rig_with_noise():
    hits = dict.fromkeys(TRUTH, 0)
    count = 20
    for seed in range(count):
        found = fit(SENSORS, seed=1000 * seed, tolerance=1e-6)
        for path, value in TRUTH.items():
            low, high = found.parameters[path].interval
            hits[path] += low <= value <= high
            assert found.parameters[path].value == pytest.approx(value, rel=0.05)
            assert high - low < 0.1 * value
    for path, number in hits.items():
        assert number >= 16, path  # binomial(20, 0.95): below 16 with probability 0.003


# --- a campaign file -----------------------------------------------------------------------------------------------

CAMPAIGN = """
schema = "jounce.campaign/1"
rig = "rig.toml"
[bench.spring]
files = ["spring.csv"]
[bench.tyre."0.31 MPa"]
files = ["tyre.csv"]
[roads.A]
kind = "half-sine"
height = "10 mm"
length = "60 mm"
start = "0.2 m"
[[trial]]
number = 1
speed = "1.95 m/s"
strut_angle = "26 deg"
road = "A"
recording = "1.csv"
use = "fit"
[[trial]]
number = 2
speed = "2.86 m/s"
strut_angle = "16 deg"
tyre_pressure = "0.31 MPa"
road = "A"
recording = "2.csv"
[[update]]
name = "all"
free = {"strut.spring.rate" = "10 %", "strut.damper.coefficient" = "10 %", "tyre.stiffness" = "10 %"}
"""

TRUE_RIG = shipped_truth().true_rig()
SPRING_RATE = TRUE_RIG.strut.spring.rate
STRUT_FRICTION, GUIDE_FRICTION = TRUE_RIG.strut.friction.force, TRUE_RIG.guide_friction.force


@pytest.fixture
def folder(tmp_path):
    """A campaign whose bench says what the rig's file says, and whose recordings are ideal."""
    from importlib import resources

    (tmp_path / "rig.toml").write_text(
        (resources.files("jounce.parts") / "library" / "kart-double-wishbone.toml").read_text()
    )
    (tmp_path / "campaign.toml").write_text(CAMPAIGN)
    for name, slope in (("spring", 23.0), ("tyre", 135.0)):
        rows = "\n".join(f"{x},{slope * x}" for x in np.linspace(0.0, 10.0, 41))
        (tmp_path / f"{name}.csv").write_text(f"displacement [mm], force [N]\n{rows}\n")
    for number, degrees, speed in ((1, 26, 1.95), (2, 16, 2.86)):
        _, run = recorded(degrees, speed, {"sprung.az": jn.Sensor(), "unsprung.az": jn.Sensor()})
        write_recording(run, tmp_path / f"{number}.csv")
    return tmp_path


def test_campaign_on_a_3d_rig_finds_its_values_and_keeps_its_file(folder):
    result = run_campaign(folder / "campaign.toml")
    assert result.is_complete
    assert {item.path: round(item.measured, 6) for item in result.characterisation.replaced} == {
        "strut.spring.rate": 23000.0,
        "tyre.stiffness": 135000.0,
    }
    found = result.strategies[0].update.parameters
    for path, value in TRUTH.items():
        assert found[path].value == pytest.approx(
            value, rel=2e-3
        )  # recordings are rounded to what CSV holds
    assert [trial.after.verdict for trial in result.trials] == ["holds", "holds"]
    assert result.start.strut.spring.free_length == KART.strut.spring.free_length
    assert list(result.strategies[0].rig_texts) == [
        "",
        "0.31 MPa",
    ]  # one trial does not state its pressure
    text = result.strategies[0].rig_texts[""]
    assert (
        rig_from_table(tomllib.loads(text)).parameters()
        == result.strategies[0].knowledge.rig.parameters()
    )
    assert "# the seat is threaded: preload is continuous" in text
    assert 'free_length = "207.955 mm"' in text


def test_what_looks_wrong_in_the_rig_is_a_finding_of_the_campaign(folder):
    rig = folder / "rig.toml"
    rig.write_text(
        rig.read_text().replace(
            'damper = {coefficient = "150 N*s/m"}', "damper = {coefficient = 150}"
        )
    )
    assert not [
        f for f in run_campaign(folder / "campaign.toml").findings if f.place.startswith("rig.toml")
    ]
    rig.write_text(rig.read_text().replace('camber = "0 deg"', "camber = -1"))
    found = [
        f for f in run_campaign(folder / "campaign.toml").findings if f.place.startswith("rig.toml")
    ]
    assert [f.place for f in found] == ["rig.toml: wheel.camber"]


def test_each_trial_runs_at_its_own_angle(folder):
    result = run_campaign(folder / "campaign.toml")
    knowledge = result.strategies[0].knowledge
    angles = [
        strut_angle(knowledge.rig_for(entry.strut_angle, None, {}))
        for entry in result.campaign.trial
    ]
    assert np.degrees(angles) == pytest.approx([26.0, 16.0])


def test_an_angle_over_thirty_degrees_is_a_finding(folder):
    file = folder / "campaign.toml"
    file.write_text(file.read_text().replace('"16 deg"', '"31 deg"'))
    found = [f for f in run_campaign(file).findings if "Adams" in f.message]
    assert [f.place for f in found] == ["trial 2: strut_angle"]


def test_an_angle_for_a_strut_that_guides_the_wheel_is_refused_before_any_work(folder):
    file = folder / "campaign.toml"
    file.write_text(file.read_text().replace('rig = "rig.toml"', 'rig = "generic-mcpherson"'))
    with pytest.raises(
        DescriptionError, match=r"trial\[0\].strut_angle \(number 1\): a McPherson strut guides"
    ):
        run_campaign(file)
    assert any("McPherson strut guides" in problem for problem in check_file(file).problems)


def test_a_measured_intercept_goes_into_the_free_length(folder):
    """A spring that carries 23 N at the start of its trial is 1 mm longer than the file says."""
    rows = "\n".join(f"{x},{23.0 * x + (23.0 if x else 0.0)}" for x in np.linspace(0.0, 10.0, 41))
    (folder / "spring.csv").write_text(f"displacement [mm], force [N]\n{rows}\n")
    file = folder / "campaign.toml"
    kept = file.read_text().replace(
        '["spring.csv"]', '["spring.csv"]\nintercept = "keep"\ndiscard_below = "0.1 mm"'
    )
    file.write_text(kept)
    start = run_campaign(file).start
    assert start.strut.spring.free_length == pytest.approx(
        KART.strut.spring.free_length + 1e-3, abs=2e-5
    )
    assert start.strut.spring.rate == pytest.approx(23e3, rel=1e-6)


@pytest.mark.parametrize("support", ["tyre", "blocked"])
def test_damping_of_a_3d_strut_is_recovered_from_a_decay(tmp_path, support):
    """Light wheel and arms, small amplitude: what the method neglects; the motion ratio is the linkage's own."""
    light = {f"bodies.{name}.mass": 0.01 for name in ("lower_arm", "upper_arm", "upright")}
    rig = with_strut_angle(KART.with_changes({**light, "tyre.lift_off": False}), "16 deg")
    inertia = {name: body.inertia for name, body in rig.body_masses().items()}
    rig = rig.with_changes(
        {
            f"bodies.{n}.inertia.{e}": 1e-3 * getattr(i, e)
            for n, i in inertia.items()
            for e in ("xx", "yy", "zz")
        }
        | {
            f"bodies.upright.inertia.{e}": 1e-3 * getattr(inertia["upright"], e)
            for e in ("xz", "yz")
        }
    )
    rig = rig.with_changes({"tyre.stiffness": 1e7}) if support == "blocked" else rig
    trial = jn.Trial(road=jn.Flat(), speed="1 m/s", duration="1.5 s")
    laden = jn.linearise(rig.with_changes({"sprung.mass": 18.0})).equilibrium
    rest = jn.linearise(rig).equilibrium
    run = jn.simulate(
        rig,
        trial,
        offset={n: v - rest[n] for n, v in laden.items() if v != rest[n]},
        tolerance=1e-8,
    )
    write_recording(run[["sprung.z"]], tmp_path / "decay.csv")
    from jounce.campaign.characterise import characterise
    from jounce.campaign.description import Bench

    start = rig.with_changes({"strut.damper.coefficient": 100.0})
    found, knowledge = characterise(
        start, Bench(decay={"files": ["decay.csv"], "support": support}), tmp_path
    )
    assert not found.failed
    assert knowledge.rig.strut.damper.coefficient == pytest.approx(150.0, rel=0.02)


# --- the shipped campaign ------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def shipped(shipped_folder):
    return run_campaign(shipped_folder / "campaign.toml")


@pytest.mark.examples
def test_shipped_campaign_runs_the_double_wishbone(shipped):
    assert shipped.is_complete
    assert shipped.rig.model == "double-wishbone"
    assert [strategy.update.name for strategy in shipped.strategies] == [
        f"strategy {i}" for i in (1, 2, 3, 4)
    ]
    for strategy in shipped.strategies:
        assert 10.0 < strategy.update.reduction_percent < 95.0
        for label, text in strategy.rig_texts.items():
            assert "# the seat is threaded" in text
            known = strategy.knowledge.rig_for(None, to_si(label, "Pa"), {})
            assert rig_from_table(tomllib.loads(text)).parameters() == known.parameters()


@pytest.mark.examples
def test_shipped_rig_is_the_librarys_with_friction_to_be_found(shipped):
    own = shipped.rig.parameters()
    differs = {path for path, value in KART.parameters().items() if own[path] != value}
    assert differs == {"tyre.damping_coefficient"}
    assert {path for path in own if path not in KART.parameters()} == {
        f"{place}.{key}"
        for place in ("strut.friction", "guide_friction")
        for key in ("force", "regularisation_velocity")
    }


@pytest.mark.examples
def test_shipped_campaign_finds_spring_friction_and_lags(shipped):
    found = shipped.strategies[-1].update
    assert found.parameters["strut.spring.rate"].value == pytest.approx(SPRING_RATE, rel=0.03)
    ratio = lump(KART).damper_ratio
    dry = sum(
        f * found.parameters[p].value
        for p, f in (("strut.friction.force", ratio), ("guide_friction.force", 1.0))
    )
    assert dry == pytest.approx(GUIDE_FRICTION + STRUT_FRICTION * ratio, rel=0.35)
    rows = {row.number: row for row in table2()}
    for number in (1, 3, 8, 9):  # single obstacles; in trains the slowing belt adds to the lag
        assert found.lags[f"trial {number}"] == pytest.approx(
            true_pass(rows[number]).lag, abs=0.6e-3
        )


@pytest.mark.examples
def test_the_linkage_explains_more_of_the_wheel_than_two_masses(shipped, quick_look):
    """Both campaigns look at the same recordings; single obstacles, held out, errors in the mean."""
    quick, _ = quick_look

    def misfit(result):
        held = [t for t in result.trials if t.entry.use == "hold-out" and t.obstacle_pitch is None]
        return np.mean(
            [channel.nrmse for trial in held for channel in trial.after.channels.values()]
        )

    assert misfit(shipped) < misfit(quick)
    assert misfit(shipped) > 0.03  # the bench is richer than either


@pytest.mark.examples
def test_report_says_where_the_lumped_model_differs(shipped):
    found = shipped.lumped
    assert {peak.trial for peak in found.peaks} == {f"trial {i}" for i in range(1, 17)}
    assert all(abs(peak.relative) < 0.1 for peak in found.peaks)
    assert found.lumping.damper_ratio == pytest.approx(np.cos(np.radians(26.0)), rel=1e-3)
    plain = shipped.to_dict()["lumped"]
    assert {
        "rows",
        "peaks",
        "lumping",
        "lumped",
        "travel",
        "motion_ratio",
        "wheel_rate",
    } <= plain.keys()
    section = lumped_section(found)
    tables = [block for block in section.blocks if isinstance(block, PageTable)]
    assert [len(table.rows) for table in tables] == [11, 3, 48]
    assert all(len(row) == len(table.header) for table in tables for row in table.rows)


def test_a_lumped_rig_has_no_such_section(folder):
    file = folder / "campaign.toml"
    text = file.read_text().replace('rig = "rig.toml"', 'rig = "kart-quarter-car"')
    file.write_text(text)
    result = run_campaign(file)
    assert result.lumped is None
    assert result.to_dict()["lumped"] is None


def test_quick_look_differs_from_the_campaign_in_the_rig_only():
    texts = campaign_texts()
    full, quick = (tomllib.loads(texts[name]) for name in ("campaign.toml", "quick-look.toml"))
    assert (full.pop("rig"), quick.pop("rig")) == ("rig.toml", "quarter-car.toml")
    full.pop("title"), quick.pop("title")
    written = str(full).replace("guide_friction.force", "guide.friction.force")
    assert written == str(quick)


@pytest.mark.parametrize(("quick", "name"), [(False, "campaign.toml"), (True, "quick-look.toml")])
def test_demo_runs_the_campaign_that_is_asked_for(tmp_path, monkeypatch, quick, name):
    monkeypatch.setattr(virtual_bench, "measurement_texts", lambda *_, **__: {})
    monkeypatch.setattr(jn, "run_campaign", lambda file, **_: file, raising=False)
    folder, file = demo.run_demo(tmp_path / "here", quick=quick)
    assert (folder, file.name) == (tmp_path / "here", name)
    assert sorted(p.name for p in file.parent.iterdir()) == [
        "campaign.toml",
        "quarter-car.toml",
        "quick-look.toml",
        "rig.toml",
        "truth.toml",
    ]
