"""One trial of three that is another one than it was said to be, channels exchanged, masses that are not as stated."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np
import pytest

import jounce as jn

RIG = jn.load("kart-quarter-car")
TRUTH = {"strut.spring.rate": 24e3, "strut.damper.coefficient": 135.0, "tyre.stiffness": 142e3}
FREE = {"strut.spring.rate": "20 %", "strut.damper.coefficient": "50 %", "tyre.stiffness": "20 %"}
ROAD = jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m")


@cache
def run(speed: float, changes: tuple[tuple[str, float], ...]) -> Any:
    truth = RIG.with_changes({**TRUTH, **dict(changes)})
    return jn.simulate(truth, jn.Trial(road=ROAD, speed=speed, duration="0.8 s"), tolerance=1e-8)


def trials(
    second: Mapping[str, float], *, others: Mapping[str, float] | None = None, swapped: tuple[int, ...] = ()
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
        f"why {one.place}": one.message for one in found.findings if "in it alone" in one.message
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


@pytest.mark.parametrize(("swapped", "where"), [((1,), "in trial 2:"), ((0, 1, 2), "in trial 1, trial 2, trial 3:")])
def test_exchanged_channels_are_named(swapped: tuple[int, ...], where: str) -> None:
    (message,) = [text for place, text in _exchanged(trials({}, swapped=swapped)) if place == "sprung.az"]
    assert f"looks exchanged with unsprung.az {where}" in message


def _exchanged(made: Any) -> list[tuple[str, str]]:
    found = jn.update_model(made, FREE, weights="normalised")
    return [(one.place, one.message) for one in found.findings if "exchanged" in one.message]


@pytest.mark.parametrize(
    ("change", "body"),
    [({"sprung.mass": 1.08 * 16.0}, 21.0 * 17.28 / 22.28), ({"unsprung.mass": 5.5}, 21.0 * 16.0 / 21.5)],
)
def test_masses_that_the_data_prefer_are_told_by_their_ratio(change: dict[str, float], body: float) -> None:
    message = told(trials(change, others=change))["masses"]
    assert "other masses would leave" in message
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
    assert {path: one.value for path, one in turned.parameters.items()} == pytest.approx(values, rel=1e-4)
