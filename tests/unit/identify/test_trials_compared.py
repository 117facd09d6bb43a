"""One trial of three that is another one than it was said to be, channels exchanged, masses not as stated."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import jounce as jn
from jounce.identify.estimate import estimate
from jounce.identify.stated_masses import loads_held_against_masses, off_together

RIG = jn.load("kart-quarter-car")
TRUTH = {"strut.spring.rate": 24e3, "strut.damper.coefficient": 135.0, "tyre.stiffness": 142e3}
FREE = {"strut.spring.rate": "20 %", "strut.damper.coefficient": "50 %", "tyre.stiffness": "20 %"}
ROAD = jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m")


@cache
def run(speed: float, changes: tuple[tuple[str, float], ...]) -> Any:
    truth = RIG.with_changes({**TRUTH, **dict(changes)})
    return jn.simulate(truth, jn.Trial(road=ROAD, speed=speed, duration="0.8 s"), tolerance=1e-8)


def trials(
    second: Mapping[str, float],
    *,
    others: Mapping[str, float] | None = None,
    swapped: tuple[int, ...] = (),
) -> Any:
    rng, found = np.random.default_rng(2), []
    for k, speed in enumerate((1.2, 1.95, 2.86)):
        changes = second if k == 1 else others or {}
        measured = run(speed, tuple(changes.items()))[["sprung.az", "unsprung.az"]].copy(deep=True)
        for name, noise in (("sprung.az", 0.1), ("unsprung.az", 0.5)):
            measured[name].values[:] += noise * rng.normal(size=measured[name].size)
        if k in swapped:
            body = measured["sprung.az"].values.copy()
            measured["sprung.az"].values[:] = measured["unsprung.az"].values
            measured["unsprung.az"].values[:] = body
        trial = jn.Trial(road=ROAD, speed=speed, duration="0.8 s")
        found.append(jn.FitTrial(f"trial {k + 1}", RIG, trial, measured))
    return found


def told(made: Any) -> dict[str, str]:
    found = jn.update_model(made, FREE, weights="normalised")
    return {one.place: one.message for one in found.findings if one.severity == "warning"} | {
        f"why {one.place}": one.message
        for one in found.findings
        if "in this trial alone" in one.message
    }


def test_sound_trials_are_left_alone() -> None:
    assert told(trials({})) == {}


@pytest.mark.parametrize(
    ("change", "named"),
    [
        ({"tyre.stiffness": 0.85 * 142e3}, "tyre.stiffness -1"),
        ({"tyre.stiffness": 1.15 * 142e3}, "tyre.stiffness +1"),
        ({"sprung.mass": 1.08 * 16.0}, ""),
    ],
)
def test_the_trial_that_disagrees_is_named(change: dict[str, float], named: str) -> None:
    found = told(trials(change))
    assert "does not agree with the other trials" in found["trial 2"]
    assert found.get("why trial 2", "").startswith(named)
    assert not {"trial 1", "trial 3"} & set(found)


@pytest.mark.parametrize(
    ("swapped", "where"), [((1,), "in trial 2:"), ((0, 1, 2), "in trial 1, trial 2, trial 3:")]
)
def test_exchanged_channels_are_named(swapped: tuple[int, ...], where: str) -> None:
    (message,) = [
        text for place, text in _exchanged(trials({}, swapped=swapped)) if place == "sprung.az"
    ]
    assert f"appears to be swapped with unsprung.az {where}" in message


def _exchanged(made: Any) -> list[tuple[str, str]]:
    found = jn.update_model(made, FREE, weights="normalised")
    return [(one.place, one.message) for one in found.findings if "swapped" in one.message]


@pytest.mark.parametrize(
    ("change", "body"),
    [
        ({"sprung.mass": 1.08 * 16.0}, 21.0 * 17.28 / 22.28),
        ({"unsprung.mass": 5.5}, 21.0 * 16.0 / 21.5),
    ],
)
def test_masses_that_the_data_prefer_are_told_by_their_ratio(
    change: dict[str, float], body: float
) -> None:
    message = told(trials(change, others=change))["masses"]
    assert "other masses would reduce the residual to" in message
    preferred = re.search(r"sprung\.mass ([\d.]+) kg for 16", message)
    assert preferred is not None
    assert float(preferred[1]) == pytest.approx(body, rel=3e-3)


def test_the_scale_of_rates_is_that_of_the_masses_unless_something_else_knows_it() -> None:
    def notes(**options: Any) -> list[str]:
        found = jn.update_model(
            trials({}), options.pop("free", FREE), weights="normalised", doubt=jn.Doubt(), **options
        )
        return [one.message for one in found.findings if one.place == "masses"]

    (note,) = notes()
    assert "is set by the stated masses (± " in note
    prior = {**FREE, "strut.spring.rate": {"bounds": "20 %", "prior": ["24 N/mm", "0.1 N/mm"]}}
    assert notes(free=prior) == []


def test_a_mass_that_is_added_in_one_trial_stays_as_it_is() -> None:
    """A free mass is that without it; as a common factor 2.6 kg would grow with the mass."""
    made, (first, _, third) = [], trials({})
    for one, changes in ((first, {}), (third, {"sprung.mass": 16.8 + 2.6})):
        truth = RIG.with_changes({**TRUTH, "sprung.mass": 16.8, **changes})
        measured = jn.simulate(truth, one.trial, tolerance=1e-8)[["sprung.az", "unsprung.az"]]
        rig = RIG.with_changes({"sprung.mass": 16.0 + 2.6}) if changes else RIG
        added = {"sprung.mass": 2.6} if changes else {}
        made.append(jn.FitTrial(one.name, rig, one.trial, measured, added=added))
    free = {"sprung.mass": "15 %", **FREE}
    found = jn.update_model(made, free, weights="normalised")
    values = {path: one.value for path, one in found.parameters.items()}
    # the unsprung mass is as stated, so that the scale is known
    assert values == pytest.approx({"sprung.mass": 16.8, **TRUTH}, rel=1e-4)
    turned = jn.update_model(made[::-1], free, weights="normalised")
    assert {path: one.value for path, one in turned.parameters.items()} == pytest.approx(
        values, rel=1e-4
    )


@cache
def heavier(share: float, load: bool) -> Any:
    """An update with doubt on three trials whose masses are larger than stated, weighed or not."""
    change = {"sprung.mass": share * 16.0, "unsprung.mass": share * 5.0}
    made = trials(change, others=change)
    made = [replace(one, wheel_load=share * 21.0 * 9.80665 if load else None) for one in made]
    return jn.update_model(made, FREE, weights="normalised", doubt=jn.Doubt(), starts=1)


def test_a_wheel_load_at_rest_sets_the_scale_of_masses_and_rates() -> None:
    alone, weighed = heavier(1.05, load=False), heavier(1.05, load=True)
    for path in ("strut.spring.rate", "tyre.stiffness"):
        before, after = (found.discrepancy.parameters[path] for found in (alone, weighed))
        assert before.interval[1] < 1.01 * TRUTH[path], path
        assert after.interval[0] < TRUTH[path] < after.interval[1], path
        assert after.half_width < 0.75 * before.half_width, path
    told = [one for one in weighed.findings if one.place == "trial 1: wheel_load"]
    assert [round(100.0 * one.value) for one in told] == [5]
    assert not [one for one in weighed.findings if "set by the stated masses" in one.message]


def test_no_rate_is_identified_more_tightly_than_the_mass_it_hangs_on() -> None:
    found = heavier(1.05, load=False).discrepancy
    masses = [found.nuisances[f"{body}.mass"] for body in ("sprung", "unsprung")]
    scale = min(1.96 * one.standard_error for one in masses)
    for path in FREE:
        law = found.parameters[path]
        assert law.half_width / law.value > 0.99 * scale, path


def test_a_wheel_load_is_one_of_a_single_wheel() -> None:
    car = SimpleNamespace(name="trial 1", rig=jn.load("sldemo-half-car"), wheel_load=3000.0)
    with pytest.raises(jn.FitError, match="one wheel"):
        loads_held_against_masses([car])


BENCH = {path: estimate(value, 0.002 * value, 10.0) for path, value in TRUTH.items()}


def said_of(
    factors: Mapping[str, float], contradicted: tuple[str, ...], angle: float = 0.0
) -> list[str]:
    found = {path: factor * TRUTH[path] for path, factor in factors.items()}
    return [one.message for one in off_together(found, BENCH, contradicted, angle)]


def test_rates_that_are_off_by_one_factor_name_the_masses_or_the_angle() -> None:
    spring, damper, tyre = FREE
    (both,) = said_of({spring: 0.92, tyre: 0.93}, (spring, tyre))
    assert "masses +8.1 % from the stated ones" in both
    assert "strut angle" not in both
    (strut,) = said_of({spring: 0.92, damper: 0.92}, (spring, damper), np.radians(26.0))
    assert "strut angle of 30.4 deg" in strut
    assert np.cos(np.radians(30.4)) ** 2 == pytest.approx(
        0.92 * np.cos(np.radians(26.0)) ** 2, rel=2e-3
    )
    assert said_of({spring: 0.92, tyre: 1.08}, (spring, tyre)) == []
    assert said_of({spring: 0.92, tyre: 0.99}, (spring, tyre)) == []
    assert said_of({spring: 0.92, damper: 0.92, tyre: 1.0}, (spring, damper)) == []
    assert said_of({spring: 0.92}, (spring,)) == []


def test_masses_that_are_wrong_are_named_by_bench_values_of_an_update() -> None:
    change = {"sprung.mass": 1.12 * 16.0, "unsprung.mass": 1.12 * 5.0}
    made = trials(change, others=change)
    found = jn.update_model(
        made, FREE, weights="normalised", doubt=jn.Doubt(), bench=BENCH, starts=1
    )
    (message,) = [one.message for one in found.findings if "nearly the same factor" in one.message]
    share = re.search(r"masses \+([\d.]+) %", message)
    assert share is not None
    assert float(share[1]) == pytest.approx(12.0, abs=0.5)
