"""Settings of an update that would be ignored, or end in nonsense, are refused with a message."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import jounce as jn
from jounce.core.waiting import watched_by

RIG = jn.load("kart-quarter-car")
TRIAL = jn.Trial(
    road=jn.HalfSine(height="10 mm", length="60 mm", start="0.1 m"),
    speed="1.95 m/s",
    duration="0.3 s",
)


@pytest.fixture(scope="module")
def trials() -> list[jn.FitTrial]:
    measured = jn.simulate(RIG.with_changes({"strut.spring.rate": "23 N/mm"}), TRIAL)[
        ["sprung.az", "unsprung.az"]
    ]
    return [jn.FitTrial("one", RIG, TRIAL, measured)]


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        (
            {"channels": ["sprung.az", "unsprng.az"]},
            r"channels: unknown channel 'unsprng.az'.*mean 'unsprung.az'",
        ),
        (
            {"weights": {"sprng.az": 1.0}},
            r"weights: unknown channel 'sprng.az'.*Did you mean 'sprung.az'",
        ),
        (
            {"weights": {"sprung.az": -1.0}},
            r"weights: sprung.az: invalid weight; found -1.0; allowed: 0 or more",
        ),
        ({"weights": {"sprung.az": float("nan")}}, "weights: sprung.az: invalid weight"),
        ({"weights": {"tyre.force": 1.0}}, r"one: no channel of the recording has a weight; found"),
        ({"starts": 0}, "invalid number of starts; found 0; allowed: 1 or more"),
        ({"align": "lag", "lag_bound": 0.0}, "invalid largest lag"),
        ({"align": "lags"}, "unknown alignment; found 'lags'"),
        ({"method": "bgfs"}, "unknown method; found 'bgfs'; allowed: bfgs, least-squares"),
        ({"tolerance": -1e-8}, "tolerance: invalid tolerance; found -1e-08; allowed: 1e-13 to 0.1"),
    ],
)
def test_impossible_settings_are_refused(trials, settings, message):
    with pytest.raises(jn.JounceError, match=message):
        jn.update_model(trials, {"strut.spring.rate": "10 %"}, **settings)


def test_recordings_that_cannot_be_compared_are_refused(trials):
    free, measured = {"strut.spring.rate": "10 %"}, trials[0].measured
    obstacle = (0.1 + 0.06) / 1.95
    for changed, message in (
        (
            measured.sel(time=slice(None, obstacle - 2e-3)),
            r"one: the recording ends before the obstacle pass does",
        ),
        (
            measured.rename({"sprung.az": "a.az", "unsprung.az": "b.az"}),
            r"the recording contains no channel of",
        ),
        (
            measured.isel(time=slice(-2, None)),
            r"fewer data than parameters; found '4 samples'; allowed: at least 5",
        ),
    ):
        more = {"align": "lag"} if "fewer" in message else {}
        all_free = (
            free | dict.fromkeys(("sprung.mass", "unsprung.mass", "tyre.stiffness"), "10 %")
            if more
            else free
        )
        with pytest.raises(jn.FitError, match=message):
            jn.update_model([jn.FitTrial("one", RIG, TRIAL, changed)], all_free, **more)
    with pytest.raises(jn.FitError, match="no trial to fit"):
        jn.update_model([], free)


def test_steps_of_a_search_are_told_to_who_watches(trials):
    steps: list[dict[str, Any]] = []
    with watched_by(steps.append):
        found = jn.update_model(trials, {"strut.spring.rate": "10 %"})
    assert [one["evaluation"] for one in steps] == list(range(1, found.evaluations + 1))
    assert steps[-1]["objective"] <= min(one["objective"] for one in steps) * (1.0 + 1e-6)
    last = steps[-1]["parameters"]["strut.spring.rate"]
    assert last["value"] == pytest.approx(found.parameters["strut.spring.rate"].value, rel=1e-3)
    assert last["lower"] < last["value"] < last["upper"]


def test_a_weight_of_zero_leaves_a_channel_out(trials):
    weighted = jn.update_model(
        trials, {"strut.spring.rate": "10 %"}, weights={"sprung.az": 1.0, "unsprung.az": 0.0}
    )
    alone = jn.update_model(trials, {"strut.spring.rate": "10 %"}, channels=["sprung.az"])
    assert weighted.objective_before == pytest.approx(alone.objective_before, rel=1e-12)
    assert weighted.parameters["strut.spring.rate"].value == pytest.approx(23000.0, rel=1e-4)


def test_a_frequency_response_names_what_it_has():
    model = jn.linearise(RIG)
    with pytest.raises(
        jn.DescriptionError, match=r"unknown output 'sprung.zz'.*Did you mean 'sprung.z'"
    ):
        model.frequency_response([1.0], "sprung.zz")
    with pytest.raises(jn.DescriptionError, match=r"unknown track 'road'.*allowed: road.z"):
        model.frequency_response([1.0], "sprung.z", "road")


def told(results: jn.UpdateResult) -> str:
    return " | ".join(f"{one.place}: {one.message}" for one in results.findings)


@pytest.fixture(scope="module")
def passed() -> tuple[jn.Rig, jn.Trial, Any]:
    """A rig, a trial, and a record of the same rig with another spring."""
    rig = jn.load("kart-quarter-car")
    trial = jn.Trial(
        road=jn.HalfSine(height=0.01, length=0.06, start=0.2), speed=1.95, duration=0.6
    )
    truth = rig.with_changes({"strut.spring.rate": 25e3})
    return rig, trial, jn.simulate(truth, trial)[["sprung.az", "strut.deflection"]]


def updated(passed: tuple[jn.Rig, jn.Trial, Any], *records: Any) -> jn.UpdateResult:
    rig, trial, _ = passed
    trials = [jn.FitTrial(f"trial {i}", rig, trial, record) for i, record in enumerate(records, 1)]
    return jn.update_model(trials, {"strut.spring.rate": "30 %"})


def test_a_record_that_the_model_does_not_explain_is_told(
    passed: tuple[jn.Rig, jn.Trial, Any],
) -> None:
    """A wrong speed, a scale of 1000, and a dead channel gave values and intervals without a word."""
    rig, trial, record = passed
    assert "explains little" not in told(updated(passed, record))
    slower = trial.model_copy(update={"speed": 1.5})
    assert "sprung.az: the updated model explains little of the record in trial 1 (R² " in told(
        updated((rig, slower, record), record)
    )
    for factor in (0.0, 1000.0):
        scaled = record.assign(
            {
                "strut.deflection": record["strut.deflection"].copy(
                    data=factor * record["strut.deflection"]
                )
            }
        )
        found = updated(passed, record, scaled)
        assert (
            "strut.deflection: the updated model explains little of the record in trial 2"
            in told(found)
        )


def test_a_delay_that_was_not_asked_for_is_told(passed: tuple[jn.Rig, jn.Trial, Any]) -> None:
    """Three milliseconds made the spring a sixth softer, with a narrow interval and without a word."""
    record = passed[2]
    late = record.copy(deep=True)
    for name in late.data_vars:
        late[name] = late[name].shift(time=3, fill_value=float(late[name][0]))
    assert "lags the updated model" not in told(updated(passed, record))
    found = updated(passed, late)
    assert abs(found.parameters["strut.spring.rate"].value - 25e3) > 500.0
    assert "in trial 1" in told(found)
    assert 'fit with align = "lag"' in told(found)


def test_copies_of_a_record_are_told(passed: tuple[jn.Rig, jn.Trial, Any]) -> None:
    found = updated(passed, passed[2], passed[2].copy(deep=True))
    assert "trial 2: contains the same numbers as trial 1: a copy is not a repetition" in told(
        found
    )


def test_what_is_no_recording_is_refused_by_what_is_wrong(
    passed: tuple[jn.Rig, jn.Trial, Any],
) -> None:
    record = passed[2]
    gap = record.copy(deep=True)
    gap["sprung.az"][50] = np.nan
    in_g = record.copy(deep=True)
    in_g["sprung.az"].attrs["units"] = "g"
    for wrong, text in (
        (gap, "trial 1: sprung.az: sample 51 is not a finite number"),
        (in_g, "a different unit; found 'g'; allowed: m/s"),
        (record.isel(time=slice(None, None, -1)), "time does not increase"),
        (record.isel(time=slice(0, 0)), "too few samples; found 0"),
        (record.isel(time=slice(0, 1)), "too few samples; found 1"),
    ):
        with pytest.raises(jn.JounceError, match=text):
            updated(passed, wrong)
