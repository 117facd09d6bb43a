"""The Gymnasium environment: passes the library's own check, repeats, rewards what it should."""

from __future__ import annotations

import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import jounce as jn
from jounce.control import ActiveActuator
from jounce.simulation.environment import ride_environment

TRIAL = jn.Trial(
    road=jn.HalfSine(height="30 mm", length="0.5 m", start="1 m"), speed="10 m/s", duration="0.5 s"
)


def random_trial(generator: np.random.Generator) -> jn.Trial:
    road = jn.HalfSine(height=float(generator.uniform(0.01, 0.05)), length="0.5 m", start="1 m")
    return jn.Trial(road=road, speed="10 m/s", duration="0.5 s")


@pytest.mark.parametrize("name", ["audi-a6-quarter-car", "audi-a6-half-car", "audi-a6-full-car"])
@pytest.mark.parametrize("trial", [TRIAL, random_trial])
def test_gymnasium_accepts_it(name: str, trial: object) -> None:
    check_env(ride_environment(jn.load(name), trial), skip_render_check=True)


def episode(
    environment: object, action: float, seed: int = 0
) -> tuple[float, int, dict[str, object]]:
    environment.reset(seed=seed)
    total, steps, truncated, info = 0.0, 0, False, {}
    while not truncated:
        _, reward, terminated, truncated, info = environment.step(
            np.array([action], dtype=np.float32)
        )
        assert not terminated
        total, steps = total + reward, steps + 1
    return total, steps, info


def test_episode_ends_with_the_trial_and_repeats() -> None:
    environment = ride_environment(jn.load("audi-a6-quarter-car"), TRIAL, rate=50.0)
    first, second = episode(environment, 0.3), episode(environment, 0.3)
    assert first == second
    assert first[1] == 25
    assert first[2]["time"] == pytest.approx(0.5)


def test_cost_is_the_mean_square_of_the_run() -> None:
    rig = jn.load("audi-a6-quarter-car")
    environment = ride_environment(rig, TRIAL, cost={"sprung.az": 2.0}, actuator=ActiveActuator())
    total, steps, info = episode(environment, 0.0)  # no force: the passive rig
    run = jn.simulate(rig, TRIAL)
    assert -total / steps == pytest.approx(
        2.0 * float((run["sprung.az"][1:] ** 2).mean()), rel=1e-3
    )
    assert info["commands"] == {"": 0.0}


def test_seeds_choose_the_road() -> None:
    environment = ride_environment(jn.load("audi-a6-quarter-car"), random_trial)
    totals = [episode(environment, 0.0, seed)[0] for seed in (1, 2, 1)]
    assert totals[0] == totals[2] != totals[1]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"observed": ["sprung.colour"]}, "unknown channel 'sprung.colour'"),
        ({"cost": {"sprung.colour": 1.0}}, "unknown channel 'sprung.colour'"),
        ({"cost": {"sprung.az": -1.0}}, "invalid weight"),
        ({"rate": 0.0}, "invalid rate"),
    ],
)
def test_bad_options_are_refused(options: dict[str, object], message: str) -> None:
    with pytest.raises(jn.JounceError, match=message):
        ride_environment(jn.load("audi-a6-quarter-car"), TRIAL, **options)
