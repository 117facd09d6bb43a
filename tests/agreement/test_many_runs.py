"""Variants side by side against the same variants one by one, which is what `simulate` does."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.variants import few_channels, side_by_side
from jounce.variants import many as module

pytestmark = pytest.mark.usefixtures("optimised")

METRICS = {
    "audi-a6-quarter-car": [
        "rms sprung.az",
        "mean tyre.force",
        "min tyre.force",
        "range strut.deflection",
    ],
    "audi-a6-half-car": ["rms body.az", "max strut.deflection", "rms sprung.az"],
    "audi-a6-full-car": ["rms body.az", "range tyre.force", "mean strut.deflection"],
}
SPREADS = {
    "audi-a6-quarter-car": {
        "strut.damper.coefficient": "50 %", "tyre.stiffness": "20 %", "sprung.mass": ["400 kg", "520 kg"],
    },
    "audi-a6-half-car": {"body.mass": "20 %", "front.spring_rate": "30 %", "rear.damping_coefficient": "30 %"},
    "audi-a6-full-car": {"body.mass": "20 %", "front.tyre.stiffness": "20 %"},
}  # fmt: skip


def course(
    grade: str = "A", speed: str = "20 m/s", duration: str = "2 s", seed: int = 1
) -> jn.Trial:
    return jn.Trial(
        road=jn.Iso8608(**{"class": grade}, seed=seed, length="100 m"),
        speed=speed,
        duration=duration,
    )


@pytest.fixture
def one_by_one(monkeypatch):
    def run(*arguments, **keywords):
        with monkeypatch.context() as patch:
            patch.setattr(module, "sums_side_by_side", lambda *_: None)
            found = jn.simulate_many(*arguments, **keywords)
        assert found.attrs["side_by_side"] == 0
        return found

    return run


def same(first, second, rel=1e-11):
    for name in first.data_vars:
        if name != "reason":
            scale = float(np.nanmax(np.abs(second[name])))
            assert first[name].values == pytest.approx(
                second[name].values, rel=rel, abs=rel * scale, nan_ok=True
            ), name


@pytest.mark.parametrize("name", METRICS)
def test_side_by_side_gives_what_single_runs_give(name, one_by_one):
    rig, trial, design = jn.load(name), course(), jn.sobol(SPREADS[name], 20, seed=2)
    found = jn.simulate_many(rig, trial, design, metrics=METRICS[name])
    assert found.attrs["side_by_side"] == 20
    same(found, one_by_one(rig, trial, design, metrics=METRICS[name]))


def test_jumps_of_the_road_blow_side_by_side_as_in_single_runs(one_by_one):
    rig, asked = jn.load("audi-a6-quarter-car"), ["rms sprung.az", "max sprung.z", "min tyre.force"]
    trial = jn.Trial(
        road=jn.Rectangle(height="10 mm", length="60 mm", start="1 m"), speed=5.0, duration=0.6
    )
    design = jn.sobol(
        {"sprung.mass": "20 %", "tyre.damping_coefficient": ["0 N*s/m", "1000 N*s/m"]}, 8, seed=2
    )
    found = jn.simulate_many(rig, trial, design, metrics=asked)
    assert found.attrs["side_by_side"] == 8
    same(found, one_by_one(rig, trial, design, metrics=asked), rel=1e-9)  # of slopes of 1e5


def test_what_sweeps_over_one_trial_share_is_no_others(one_by_one):
    """What is laid out for a rig over a trial is kept beside the trial: another rig or step has its own."""
    rig, trial, design = (
        jn.load("audi-a6-quarter-car"),
        course(),
        jn.sobol({"sprung.mass": "20 %"}, 8),
    )
    first = jn.simulate_many(rig, trial, design, metrics="rms sprung.az")
    softer = rig.with_changes({"strut.spring.rate": "15 N/mm"})
    for other, step in ((softer, 1e-3), (rig, 2e-3)):
        found = jn.simulate_many(other, trial, design, metrics="rms sprung.az", output_step=step)
        assert found.attrs["side_by_side"] == 8
        same(found, one_by_one(other, trial, design, metrics="rms sprung.az", output_step=step))
    assert jn.simulate_many(rig, trial, design, metrics="rms sprung.az").identical(first)


def test_a_number_beyond_what_was_allowed_before_is_looked_at_again():
    """Ranges that a description was found to allow are remembered; those that reach beyond them are not."""
    rig, trial = jn.load("audi-a6-quarter-car"), course()
    masses = {"sprung.mass": np.linspace(300.0, 500.0, 8)}
    assert not jn.simulate_many(rig, trial, masses, metrics="rms sprung.az").attrs["outside"]
    masses["sprung.mass"][3] = -1.0
    found = jn.simulate_many(rig, trial, masses, metrics="rms sprung.az")
    assert [bool(reason) for reason in found["reason"].values] == [i == 3 for i in range(8)]
    assert "sprung.mass" in str(found["reason"].values[3])


@pytest.mark.parametrize("step", [1e-4, 2e-3, 1e-2])
def test_samples_as_close_or_far_apart_as_wanted(step, one_by_one):
    """A long step is cut into parts; edges of the road lie anywhere between samples."""
    rig, design = jn.load("audi-a6-quarter-car"), jn.sobol({"strut.damper.coefficient": "30 %"}, 8)
    arguments = (rig, course(speed="7.3 m/s"), design)
    found = jn.simulate_many(*arguments, metrics=METRICS["audi-a6-quarter-car"], output_step=step)
    assert found.attrs["side_by_side"] == 8
    same(found, one_by_one(*arguments, metrics=METRICS["audi-a6-quarter-car"], output_step=step))


@pytest.mark.parametrize("seed", range(4))
def test_variants_whose_tyres_lift_off_come_back_to_the_others(seed, one_by_one):
    rig, trial = jn.load("audi-a6-quarter-car"), course("D", "25 m/s", seed=seed)
    design = jn.sobol(
        {"strut.damper.coefficient": "90 %", "sprung.mass": ["200 kg", "1500 kg"]}, 24, seed=seed
    )
    found = jn.simulate_many(rig, trial, design, metrics=["min tyre.force", "rms sprung.az"])
    alone = one_by_one(rig, trial, design, metrics=["min tyre.force", "rms sprung.az"])
    same(found, alone)
    lifted = int(np.sum(alone["min tyre.force"].values == 0.0))
    assert 0 < lifted < 24
    assert found.attrs["side_by_side"] == 24


LAWS = {
    "two-slope damper": {
        "strut.damper": {"bump_coefficient": 1200.0, "rebound_coefficient": 3500.0}
    },
    "damper of a table, tyre with damping": {
        "strut.damper": {
            "velocity": [-1.0, -0.2, -0.05, 0.05, 0.2, 1.0],
            "force": [-2500.0, -1200.0, -400.0, 300.0, 700.0, 1500.0],
        },
        "tyre.damping_coefficient": 300.0,
    },
    "stop": {"strut.bump_stop": {"gap": "20 mm", "rate": "100 N/mm"}},
}
OBSTACLES = {
    "lines": lambda seed: jn.Iso8608(class_="E", seed=seed, length="60 m", step="7 cm"),
    "cubics": lambda seed: jn.Table(
        x=np.linspace(1.0, 9.0, 40),
        height=0.03 * np.r_[0.0, np.random.default_rng(seed).normal(size=38), 0.0],
        interpolation="cubic",
    ),
    "sines": lambda seed: jn.Train(
        of=jn.HalfSine(height="60 mm", length=f"{0.5 + 0.1 * seed} m", start="1.3 m"),
        count=4,
        pitch="3.1 m",
    ),
    "steps": lambda seed: jn.Step(height=f"{-20 - 20 * seed} mm", start="1.0007 m"),
}


def events_of(rig, trial, design, metrics, one_by_one):
    """Compare both ways, of which the first must be side by side; give the number of events of the rig itself."""
    found, alone = (
        run(rig, trial, design, metrics=metrics) for run in (jn.simulate_many, one_by_one)
    )
    same(found, alone)
    assert found.attrs["side_by_side"] == found.sizes["variant"]
    return jn.simulate(rig, trial).attrs["events"]


@pytest.mark.parametrize("road", OBSTACLES)
@pytest.mark.parametrize("law", LAWS)
def test_events_of_all_kinds_on_all_roads(law, road, one_by_one):
    rig = jn.load("audi-a6-quarter-car").with_changes(LAWS[law])
    trial = jn.Trial(road=OBSTACLES[road](2), speed="17.3 m/s", duration="0.6 s")
    design = jn.sobol({"sprung.mass": "30 %", "tyre.stiffness": "20 %"}, 6, seed=3)
    metrics = ["rms sprung.az", "min tyre.force", "max strut.force", "mean strut.deflection"]
    assert events_of(rig, trial, design, metrics, one_by_one) > 1


def test_four_wheels_that_lift_off_each_for_itself(one_by_one):
    rig, road = (
        jn.load("audi-a6-full-car"),
        jn.Iso8608(class_="E", seed=4, length="60 m", step="5 cm"),
    )
    trial = jn.Trial(road=road, right=road.other_track(), speed="22 m/s", duration="0.6 s")
    design = jn.sobol({"body.mass": "20 %", "front.spring_rate": "20 %"}, 6, seed=3)
    assert events_of(rig, trial, design, ["rms body.az", "min tyre.force"], one_by_one) > 20


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(60))
def test_random_cases_side_by_side_are_those_one_by_one(seed, one_by_one):
    """A touch that lasts a tenth of a millisecond may be seen by one way only: so in one of these 960 variants."""
    random = np.random.default_rng(seed)
    law, road = random.choice(list(LAWS)), random.choice(list(OBSTACLES))
    rig = jn.load("audi-a6-quarter-car").with_changes(LAWS[law])
    trial = jn.Trial(
        road=OBSTACLES[road](seed % 7), speed=float(random.uniform(4.0, 30.0)), duration="2 s"
    )
    spreads = {"sprung.mass": "40 %", "tyre.stiffness": "30 %", "unsprung.mass": "20 %"}
    design, metrics = (
        jn.latin_hypercube(spreads, 16, seed=seed),
        ["rms sprung.az", "min tyre.force", "max strut.force"],
    )
    found, alone = (
        run(rig, trial, design, metrics=metrics) for run in (jn.simulate_many, one_by_one)
    )
    assert found.attrs["side_by_side"] >= 8  # others touch a stop at rest, or are too fast
    same(found, alone, rel=1e-4)
    off = np.abs(found["rms sprung.az"] / alone["rms sprung.az"] - 1.0) > 1e-9
    assert int(off.sum()) <= 1


def test_results_keep_the_values_that_were_run():
    """Whoever goes on with his array, or changes the results, changes nothing of the other."""
    masses = np.linspace(400.0, 500.0, 5)
    found = jn.simulate_many(
        jn.load("audi-a6-quarter-car"), course(), {"sprung.mass": masses}, metrics=["rms sprung.az"]
    )
    masses += 1000.0
    assert found["sprung.mass"].values.tolist() == [400.0, 425.0, 450.0, 475.0, 500.0]
    found["sprung.mass"].values[:] = 0.0
    assert masses.min() == 1400.0


def test_results_do_not_depend_on_threads():
    rig, design = (
        jn.load("audi-a6-quarter-car"),
        jn.sobol({"strut.damper.coefficient": "50 %"}, 300),
    )
    runs = [
        jn.simulate_many(rig, course(), design, metrics=["rms sprung.az"], threads=n)
        for n in (1, 2, 3)
    ]
    assert all(run.identical(runs[0]) for run in runs)


def test_who_is_interrupted_leaves_nothing_to_the_other_threads(monkeypatch):
    rig, trial, design = (
        jn.load("audi-a6-quarter-car"),
        course(),
        jn.sobol({"sprung.mass": "20 %"}, 2000),
    )
    asked = []

    def follow(work):
        asked.append(work)
        raise KeyboardInterrupt

    monkeypatch.setattr(side_by_side.lanes, "follow", follow)
    with pytest.raises(KeyboardInterrupt):
        jn.simulate_many(rig, trial, design, metrics="rms sprung.az", threads=3)
    assert 1 <= len(asked) <= 3


@pytest.fixture
def however_short(monkeypatch):
    """Threads share runs that are too short to be worth it."""
    monkeypatch.setattr(module, "_LONG", -1.0)


@pytest.mark.usefixtures("however_short")
def test_mechanisms_are_shared_by_threads_and_are_those_of_simulate():
    rig = jn.load("kart-double-wishbone")
    trial = jn.Trial(
        road=jn.HalfSine(height="10 mm", length="60 mm", start="0.1 m"),
        speed="1.95 m/s",
        duration="0.2 s",
    )
    z = rig.parameters()["hardpoints.upper_ball_joint[2]"]
    changes = {
        "strut.spring.rate": [20e3, 22e3, 1.0, 26e3, 28e3, 0.9],
        "hardpoints.upper_ball_joint[2]": [z, z + 2e-3, z, z - 1e-3, z, z],
    }
    arguments = (rig, trial, changes)
    runs = [
        jn.simulate_many(*arguments, metrics="max tyre.force", threads=count) for count in (1, 3)
    ]
    assert runs[0].identical(runs[1])
    assert [bool(reason) for reason in runs[0]["reason"].values] == [
        False,
        False,
        True,
        False,
        False,
        True,
    ]
    for i in (0, 1, 3):
        run = jn.simulate(
            rig.with_changes({path: values[i] for path, values in changes.items()}), trial
        )
        expected = float(
            run["tyre.force"].max()
        )  # to the tolerance: steps of a block fall elsewhere
        assert float(runs[0]["max tyre.force"][i]) == pytest.approx(expected, rel=1e-7)


@pytest.mark.parametrize(("long", "alone"), [(-1.0, 2), (1e9, 7)])
def test_threads_share_what_is_long(monkeypatch, long, alone):
    monkeypatch.setattr(module, "_LONG", long)
    taken, shared = [], []
    monkeypatch.setattr(
        module, "share", lambda items, _, workers: shared.append((list(items), workers))
    )
    module._share_out(range(7), taken.extend, 3)
    assert taken == list(range(alone))
    assert shared == ([([2, 3, 4, 5, 6], 3)] if alone == 2 else [])
    module._share_out(range(7), taken.extend, 1)
    assert taken[alone:] == list(range(7))
    module._share_out([], taken.extend, 0)


def test_over_circles_variants_step_side_by_side():
    rig = jn.load("audi-a6-quarter-car")
    road = jn.HalfCylinder(radius="20 mm", start="1 m")
    trial = jn.Trial(road=road, speed="10 m/s", duration="0.5 s")
    many = jn.simulate_many(
        rig, trial, jn.sobol({"sprung.mass": "10 %"}, 16), metrics="max sprung.az"
    )
    assert many.attrs["side_by_side"] == 16
    for mass, value in zip(
        many["sprung.mass"].values[::15], many["max sprung.az"].values[::15], strict=True
    ):
        run = jn.simulate(rig.with_changes({"sprung.mass": float(mass)}), trial, tolerance=1e-8)
        assert value == pytest.approx(float(run["sprung.az"].max()), rel=1e-5)
    found = jn.simulate_many(
        rig, trial, {"strut.damper.coefficient": [1000.0, 2000.0]}, metrics=["max sprung.az"]
    )
    single = [
        float(
            jn.simulate(rig.with_changes({"strut.damper.coefficient": c}), trial)["sprung.az"].max()
        )
        for c in (1000.0, 2000.0)
    ]
    assert found["max sprung.az"].values.tolist() == single


def test_numbers_that_contradict_each_other_only_together_are_refused_each_by_itself():
    """Each column is allowed beside the rig's other numbers: only both together leave no ascending table."""
    table = {"velocity": [-1.0, -0.2, 0.2, 1.0], "force": [-2000.0, -400.0, 400.0, 2000.0]}
    rig = jn.load("audi-a6-quarter-car").with_changes({"strut.damper": table})
    first, second = [0.1, 0.3, 0.9], [1.0, 0.95, 0.5]
    changes = {"strut.damper.velocity[2]": first, "strut.damper.velocity[3]": second}
    found = jn.simulate_many(
        rig, course(speed="1 m/s", duration="0.2 s"), changes, metrics="rms sprung.az"
    )
    assert [bool(reason) for reason in found["reason"].values] == [False, False, True]
    assert np.isfinite(found["rms sprung.az"].values).tolist() == [True, True, False]


def test_one_variant_that_the_description_forbids_leaves_the_others_side_by_side():
    rig, trial = jn.load("audi-a6-quarter-car"), course(speed="1 m/s", duration="0.2 s")
    masses = [400.0, 420.0, -1.0, 440.0, 460.0, 480.0]
    found = jn.simulate_many(rig, trial, {"sprung.mass": masses}, metrics="rms sprung.az")
    assert found.attrs["side_by_side"] == 5
    assert [bool(reason) for reason in found["reason"].values] == [
        False,
        False,
        True,
        False,
        False,
        False,
    ]
    sound = [mass for mass in masses if mass > 0.0]
    others = jn.simulate_many(rig, trial, {"sprung.mass": sound}, metrics="rms sprung.az")[
        "rms sprung.az"
    ].values
    assert np.delete(found["rms sprung.az"].values, 2).tolist() == others.tolist()


@pytest.mark.usefixtures("however_short")
@pytest.mark.parametrize("control", [None, "skyhook"])
def test_trials_that_differ_are_shared_by_threads(control):
    rig = jn.load("audi-a6-quarter-car")
    changes = {
        "trial.speed": [10.0, 12.0, 14.0, 14.0, 10.0],
        "sprung.mass": [400.0, 420.0, -1.0, 460.0, 480.0],
    }
    given = {"metrics": ["rms sprung.az", "max tyre.force"], "control": control}
    one, more = (
        jn.simulate_many(rig, course(duration="0.2 s"), changes, **given, threads=count)
        for count in (1, 3)
    )
    assert one.identical(more)
    assert [bool(reason) for reason in one["reason"].values] == [False, False, True, False, False]
    assert np.isfinite(one["rms sprung.az"].values).tolist() == [True, True, False, True, True]


def test_curved_lumped_models_step_side_by_side():
    """A damper without a kink, and a tyre whose force is a polynomial: nothing of it is linear."""
    rig = jn.load("audi-a6-quarter-car").with_changes(
        {
            "strut.damper": {
                "kind": "tanh",
                "coefficient": 800.0,
                "stiffness": 0.0,
                "force": 300.0,
                "slope": 12.0,
            },
            "tyre.stiffness": None,
            "tyre.curve": {"kind": "polynomial", "coefficients": [1.8e5, 2e6]},
        }
    )
    trial, words = course(duration="2.5 s"), ["rms sprung.az", "min tyre.force", "Wk sprung.az"]
    masses = np.linspace(400.0, 520.0, 17)
    many = jn.simulate_many(rig, trial, {"sprung.mass": masses}, metrics=words)
    assert many.attrs["side_by_side"] == 17
    for i in (0, 16):
        one = jn.simulate_many(
            rig, trial, {"sprung.mass": masses[i : i + 1]}, metrics=words, tolerance=1e-8
        )
        assert one.attrs["side_by_side"] == 0
        for word in words:
            assert float(many[word][i]) == pytest.approx(float(one[word][0]), rel=1e-5)


@pytest.mark.parametrize("name", METRICS)
def test_runs_of_a_few_channels_are_those_of_all(name, monkeypatch):
    rig, trial = jn.load(name), course(duration="1 s")
    changes = {
        "trial.speed": [20.0, 10.0, 30.0],
        "trial.duration": [0.5, 1.0, 0.5],
        "trial.road.seed": [1, 2, 3],
    }
    every = jn.simulate_many(rig, trial, changes, metrics=METRICS[name])
    assert np.all(every["reason"].values == "")
    monkeypatch.setattr(few_channels, "LEAST", 1)
    found = jn.simulate_many(rig, trial, changes, metrics=METRICS[name])
    same(found, every, rel=1e-13)


@pytest.mark.parametrize("least", [1, few_channels.LEAST])
def test_what_runs_away_is_said(least, monkeypatch):
    monkeypatch.setattr(few_channels, "LEAST", least)
    road = jn.Ramp(height="200 m", length="1 m")
    rig = jn.load("audi-a6-quarter-car").with_changes({"tyre.lift_off": False})
    trial = jn.Trial(road=road, speed="20 m/s", duration="1 s")
    found = jn.simulate_many(rig, trial, {"sprung.mass": [400.0, 500.0]}, metrics="max sprung.az")
    assert all("it stopped after" in reason for reason in found["reason"].values)
    assert np.all(np.isnan(found["max sprung.az"].values))


@pytest.mark.parametrize("least", [1, few_channels.LEAST])
def test_channels_over_time_are_those_of_simulate(least, monkeypatch):
    monkeypatch.setattr(few_channels, "LEAST", least)
    rig, trial = jn.load("audi-a6-quarter-car"), course(duration="0.5 s")
    found = jn.simulate_many(
        rig, trial, {"sprung.mass": ["400 kg", "500 kg"]}, outputs="tyre.force"
    )
    for variant, mass in enumerate((400.0, 500.0)):
        run = jn.simulate(rig.with_changes({"sprung.mass": mass}), trial)
        assert found["tyre.force"].values[variant].tolist() == run["tyre.force"].values.tolist()
    assert found["tyre.force"].attrs["units"] == "N"
    assert found["sprung.mass"].attrs["units"] == "kg"


def test_weighted_metrics_are_those_of_the_ride_metrics():
    from jounce.ride.weighting import weight

    rig, trial = jn.load("audi-a6-quarter-car"), course(duration="3 s")
    found = jn.simulate_many(rig, trial, {"sprung.mass": [460.0]}, metrics="Wk sprung.az")
    run = jn.simulate(rig, trial)["sprung.az"].values
    assert float(found["Wk sprung.az"][0]) == pytest.approx(
        float(np.sqrt(np.mean(weight(run, 1000.0, "Wk") ** 2))), rel=1e-9
    )


@pytest.mark.parametrize("word", ["Wk", "Wd", "We", "Wc", "Wf"])
def test_runs_too_short_for_a_weighting_are_refused_as_ride_metrics_refuses_them(word):
    rig, trial = jn.load("audi-a6-quarter-car"), course(duration="2 s")
    with pytest.raises(
        jn.RecordingError, match=f"too short for {word}; found '2 s'; allowed: "
    ) as many:
        jn.simulate_many(
            rig, trial, {"sprung.mass": [460.0]}, metrics=["rms sprung.az", f"{word} sprung.az"]
        )
    with pytest.raises(jn.RecordingError) as one:
        jn.ride_metrics(jn.simulate(rig, trial), weighting={"z": word}, metrics=["weighted_rms"])
    with pytest.raises(jn.RecordingError) as best:
        jn.optimise(
            rig, {"strut.damper.coefficient": (500.0, 3000.0)}, f"sprung.az {word}", trial=trial
        )
    for error in (one, best):
        assert str(many.value).partition("measurement")[2].rstrip(".") in str(error.value)
    changes = {"trial.duration": [2.0, 30.0]}
    with pytest.raises(jn.RecordingError, match=f"too short for {word}; found '2 s'"):
        jn.simulate_many(rig, trial, changes, metrics=f"{word} sprung.az")


def test_speeds_seeds_and_controllers_vary():
    rig, trial = jn.load("audi-a6-quarter-car"), course(duration="1 s")
    found = jn.simulate_many(
        rig,
        trial,
        {"trial.speed": ["10 m/s", "20 m/s"], "trial.road.seed": [1, 5]},
        metrics="rms sprung.az",
    )
    for i, (speed, seed) in enumerate(((10.0, 1), (20.0, 5))):
        run = jn.simulate(rig, course(speed=f"{speed} m/s", duration="1 s", seed=seed))[
            "sprung.az"
        ].values
        assert float(found["rms sprung.az"][i]) == pytest.approx(
            float(np.sqrt(np.mean(run**2))), rel=1e-3
        )
    held = jn.simulate_many(
        rig, trial, {"control.rate": ["50 Hz", "1 kHz"]}, metrics="rms sprung.az", control="skyhook"
    )
    run = jn.simulate(rig, trial, control="skyhook")["sprung.az"].values
    expected = float(np.sqrt(np.mean((run - run[0]) ** 2)))
    assert float(held["rms sprung.az"][1]) == pytest.approx(expected, rel=1e-12)
    assert float(held["rms sprung.az"][0]) != pytest.approx(expected, rel=1e-3)


def test_a_spread_of_seeds_gives_whole_ones_that_all_run():
    seeds = jn.sobol({"trial.road.seed": [1, 4]}, 8, seed=1)
    found = jn.simulate_many(
        jn.load("audi-a6-quarter-car"), course(duration="0.2 s"), seeds, metrics="rms sprung.az"
    )
    assert sorted(found["trial.road.seed"].values) == [1, 1, 2, 2, 3, 3, 4, 4]
    assert set(found["reason"].values) == {""}


def test_geometries_that_cannot_be_assembled_are_rows_with_their_reasons():
    rig = jn.load("audi-double-wishbone")
    trial = jn.Trial(
        road=jn.HalfSine(height="50 mm", length="500 mm", start="1 m"),
        speed="8 m/s",
        duration="0.3 s",
    )
    moved = ("lower_ball_joint[1]", "upper_ball_joint[2]", "strut_bottom[1]")
    design = jn.sobol({f"hardpoints.{point}": "±900 mm" for point in moved}, 32, seed=1)
    many = jn.simulate_many(rig, trial, design, metrics=["max tyre.force"])
    lost = many["reason"].to_numpy() != ""
    assert 8 <= lost.sum() < 32
    assert np.array_equal(np.isnan(many["max tyre.force"].to_numpy()), lost)


def test_a_variant_that_does_not_run_is_a_row_with_its_reason():
    rig = jn.load("audi-a6-quarter-car")
    found = jn.simulate_many(
        rig,
        course(duration="0.2 s"),
        {"sprung.mass": [460.0, -1.0], "trial.speed": [20.0, 20.0]},
        metrics="rms sprung.az",
    )
    assert found["reason"].values[0] == ""
    assert "sprung.mass" in found["reason"].values[1]
    assert np.isfinite(found["rms sprung.az"].values).tolist() == [True, False]
    wrong = jn.simulate_many(
        rig, course(duration="0.2 s"), {"trial.road.seed": [1.0, 1.5]}, metrics="rms sprung.az"
    )
    assert "seed" in wrong["reason"].values[1]
    assert np.isfinite(wrong["rms sprung.az"].values[0])


@pytest.mark.parametrize(
    ("variants", "keywords", "said"),
    [
        ({"sprung.mas": [1.0]}, {}, "sprung.mass"),
        ({"trial.sped": [1.0]}, {}, "speed"),
        ({"speed": [1.0]}, {}, "Did you mean 'trial.speed'"),
        ({"control.rate": [1.0]}, {}, "there is no controller"),
        ({"sprung.mass": [1.0, 2.0], "unsprung.mass": [1.0]}, {}, "different lengths"),
        ({"sprung.mass": "16 kg"}, {}, "not a list of values"),
        ({"sprung.mass": []}, {}, "not a list of values"),
        ({"sprung.mass": ["16 m"]}, {}, "kg"),
        ({"sprung.mass": [float("nan")]}, {}, "finite"),
        ({}, {}, "no parameter to vary is given"),
        (5, {}, "no parameter to vary is given"),
        ({1: [100.0]}, {}, "no parameter to vary is given"),
        ({"sprung.mass": [400.0]}, {"metrics": []}, "no results to store"),
        (
            {"sprung.mass": [400.0]},
            {"metrics": "rms sprung.az", "threads": -1},
            "invalid number of threads",
        ),
        ({"trial.duration": [1.0, 2.0]}, {}, "of different lengths"),
        ({"sprung.mass": [400.0]}, {"metrics": "rms"}, "invalid metric"),
        ({"sprung.mass": [400.0]}, {"metrics": "rns sprung.az"}, "rms"),
        ({"sprung.mass": [400.0]}, {"metrics": "rms sprung.ax"}, "sprung.az"),
        ({"sprung.mass": [400.0]}, {"outputs": ["sprung.ax"]}, "sprung.az"),
        ({"sprung.mass": np.linspace(400, 500, 100_000)}, {}, "too many samples"),
    ],
)
def test_bad_input_gets_one_clear_message(variants, keywords, said):
    with pytest.raises(DescriptionError) as caught:
        jn.simulate_many(jn.load("audi-a6-quarter-car"), course(), variants, **keywords)
    assert said in str(caught.value)
