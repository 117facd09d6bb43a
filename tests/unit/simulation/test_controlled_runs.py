"""Controlled runs: what comes out, what a Python controller may answer, what stops a run."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.control import (
    PID,
    ActiveActuator,
    Passive,
    PythonControl,
    SemiActiveDamper,
    Skyhook,
    controller,
)
from jounce.simulation.controlled import closed_loop_poles
from jounce.simulation.environment import Stepper

TRIAL = jn.Trial(
    road=jn.HalfSine(height="30 mm", length="0.5 m", start="1 m"), speed="10 m/s", duration="0.6 s"
)
CORNERS = ("front_left", "front_right", "rear_left", "rear_right")


@pytest.fixture(scope="module")
def rig() -> jn.Rig:
    return jn.load("audi-a6-quarter-car")


def test_channels_of_the_actuators_come_along(rig: jn.Rig) -> None:
    run = jn.simulate(rig, TRIAL, control="skyhook")
    assert (run["command"].attrs["units"], run["actuator.force"].attrs["units"]) == ("N*s/m", "N")
    assert set(jn.simulate(rig, TRIAL).data_vars) == set(run.data_vars) - {
        "command",
        "actuator.force",
    }


def test_every_corner_of_a_vehicle_has_its_own() -> None:
    run = jn.simulate(jn.load("audi-a6-full-car"), TRIAL, control="lqr")
    assert [name for name in run.data_vars if name.endswith("command")] == [
        f"{corner}.command" for corner in CORNERS
    ]
    assert run["rear_left.command"].attrs["units"] == "N"


def test_passive_is_the_rig_as_it_is(rig: jn.Rig) -> None:
    run, same = jn.simulate(rig, TRIAL, control="passive"), jn.simulate(rig, TRIAL)
    assert run.identical(same)


def test_runs_repeat_exactly(rig: jn.Rig) -> None:
    law = PID(noise={"sprung.vz": 0.01}, seed=7)
    first, second = (jn.simulate(rig, TRIAL, control=law) for _ in range(2))
    assert first.identical(second)


def test_measurement_holds_all_channels_and_the_time(rig: jn.Rig) -> None:
    seen: list[tuple[dict[str, float], float]] = []

    def watch(measurement: dict[str, float], t: float) -> float:
        seen.append((measurement, t))
        return 1500.0

    run = jn.simulate(rig, TRIAL, control=PythonControl(function=watch, rate=100.0))
    assert [t for _, t in seen] == pytest.approx(np.arange(60) * 0.01)
    assert set(seen[0][0]) == set(run.data_vars)
    at = run.sel(time=[t for _, t in seen], method="nearest")
    for channel in (
        "sprung.vz",
        "tyre.force",
        "strut.deflection",
    ):  # continuous ones: no change at the instant
        values = [measurement[channel] for measurement, _ in seen]
        np.testing.assert_allclose(values, at[channel], rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("answer", [dict.fromkeys(CORNERS, 900.0), [900.0] * 4, np.full(4, 900.0)])
def test_answers_for_a_vehicle(answer: object) -> None:
    run = jn.simulate(jn.load("audi-a6-full-car"), TRIAL, control=lambda _measurement, _t: answer)
    assert float(run["front_left.command"][-1]) == 900.0


@pytest.mark.parametrize("answer", [1000, np.float64(1000.0), [1000.0], {"": 1000.0}])
def test_answers_for_one_corner(rig: jn.Rig, answer: object) -> None:
    assert (
        float(jn.simulate(rig, TRIAL, control=lambda _measurement, _t: answer)["command"][-1])
        == 1000.0
    )


@pytest.mark.parametrize("answer", [[1.0, 2.0], "firm", None, {"front": 1.0}, []])
def test_answers_that_are_no_command(rig: jn.Rig, answer: object) -> None:
    with pytest.raises(
        jn.SimulationError,
        match=r"control function at t = 0 s: the controller did not return a valid command",
    ):
        jn.simulate(rig, TRIAL, control=lambda _measurement, _t: answer)


def test_a_number_is_not_enough_for_a_vehicle() -> None:
    with pytest.raises(
        jn.SimulationError, match="4 numbers: a dict or a sequence for front_left, front_right"
    ):
        jn.simulate(jn.load("audi-a6-full-car"), TRIAL, control=lambda _measurement, _t: 1000.0)


def test_an_exception_is_told_once_with_its_time(rig: jn.Rig) -> None:
    def broken(measurement: dict[str, float], t: float) -> float:
        if t > 0.2:
            raise KeyError("sprung.vx")
        return measurement["strut.velocity"]

    with pytest.raises(
        jn.SimulationError, match=r"at t = 0\.201 s: the controller raised KeyError: 'sprung\.vx'"
    ) as error:
        jn.simulate(rig, TRIAL, control=broken)
    assert isinstance(error.value.__cause__, KeyError)
    assert (
        jn.simulate(rig, TRIAL, control=lambda _measurement, _t: 1000.0).attrs["status"]
        == "completed"
    )


def test_an_interrupt_goes_through(rig: jn.Rig) -> None:
    def stop(measurement: dict[str, float], t: float) -> float:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        jn.simulate(rig, TRIAL, control=stop)


def test_a_command_that_is_no_number_ends_the_run(rig: jn.Rig) -> None:
    def vanishing(measurement: dict[str, float], t: float) -> float:
        return float("nan") if t > 0.3 else 1000.0

    with pytest.raises(jn.SimulationError, match=r"0\.3 s: the controller gave no finite command"):
        jn.simulate(rig, TRIAL, control=vanishing)
    run = jn.simulate(rig, TRIAL, control=vanishing, check=False)
    assert run.attrs["status"] == "no_command"
    assert 0.29 < float(run["time"][-1]) < 0.302


def test_unstable_linear_loop_is_refused_before_it_runs(rig: jn.Rig) -> None:
    law = PID(proportional=-9000.0, actuator=ActiveActuator(force_limit=1e9))
    assert closed_loop_poles(rig, law)[0].real > 1.0
    with pytest.raises(
        jn.SimulationError,
        match="pid: the closed loop is unstable: small motions grow; found 'a pole at",
    ):
        jn.simulate(rig, TRIAL, control=law)


def test_diverging_loop_is_stopped_and_dated(rig: jn.Rig) -> None:
    def push(measurement: dict[str, float], t: float) -> float:
        return 3e4 * measurement["sprung.vz"]

    law = PythonControl(function=push, actuator=ActiveActuator(force_limit=1e12))
    with pytest.raises(
        jn.SimulationError, match=r"stopped after.* '?0\.\d+ s: the closed loop diverges"
    ):
        jn.simulate(rig, TRIAL, control=law)
    run = jn.simulate(rig, TRIAL, control=law, check=False)
    assert run.attrs["status"] == "diverged"
    assert 0.1 < float(run["time"][-1]) < 0.6


def test_every_shipped_linear_law_is_stable_on_the_lumped_library() -> None:
    pytest.importorskip("slycot")
    names = ("audi-a6-quarter-car", "kart-quarter-car", "audi-a6-half-car-4dof", "audi-a6-full-car")
    for name in (*names, "reference-double-wishbone"):
        for law in ("active-skyhook", "pid", "lqr", "lqg", "h-infinity"):
            assert closed_loop_poles(jn.load(name), law)[0].real < 1e-3, (name, law)


def test_poles_of_dampers_are_not_asked_for(rig: jn.Rig) -> None:
    for law in ("skyhook", "active-mpc", "passive"):
        with pytest.raises(jn.SimulationError, match="not a linear law with an active actuator"):
            closed_loop_poles(rig, law)


def test_massless_axles_refuse_laws_that_need_a_wheel() -> None:
    with pytest.raises(jn.SimulationError, match="'lqr' needs wheels with mass and tyre"):
        jn.simulate(jn.load("audi-a6-half-car"), TRIAL, control="lqr")
    assert (
        jn.simulate(jn.load("audi-a6-half-car"), TRIAL, control="skyhook").attrs["status"]
        == "completed"
    )


def test_noise_on_a_channel_that_is_not_there(rig: jn.Rig) -> None:
    with pytest.raises(jn.SimulationError, match=r"does not have; found 'rear\.sprung\.az'"):
        jn.simulate(rig, TRIAL, control=Skyhook(noise={"rear.sprung.az": 0.1}))


def test_gravity_says_what_a_corner_carries() -> None:
    rig = jn.load("audi-a6-quarter-car").with_changes({"gravity": 0.0})
    with pytest.raises(jn.SimulationError, match="without gravity"):
        jn.simulate(rig, TRIAL, control="skyhook")


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"control": Skyhook(rate=1e9)}, "too many control instants"),
        ({"control": controller("mpc", rate=1e4)}, "the plan has too many steps"),
        ({"control": "skyhook", "method": "implicit"}, "controlled runs need the explicit method"),
        ({"control": "skyhok"}, "unknown controller 'skyhok'.*Did you mean 'skyhook'"),
        ({"control": 3}, "not a controller"),
    ],
)
def test_what_no_run_can_follow_is_refused(
    rig: jn.Rig, options: dict[str, object], message: str
) -> None:
    with pytest.raises(jn.JounceError, match=message):
        jn.simulate(rig, TRIAL, **options)


def test_a_held_body_is_not_controlled() -> None:
    rig = jn.load("reference-double-wishbone")
    table = {**rig.model_dump(by_alias=True, exclude_none=True), "guide": "fixed"}
    with pytest.raises(jn.SimulationError, match="nothing to control: the body is fixed"):
        jn.simulate(type(rig).from_table(table), TRIAL, control="skyhook")


def test_mechanisms_are_controlled_like_lumped_corners() -> None:
    rig = jn.load("reference-double-wishbone")
    passive, skyhook = jn.simulate(rig, TRIAL), jn.simulate(rig, TRIAL, control="skyhook")
    assert float(skyhook["sprung.az"].std()) < 0.9 * float(passive["sprung.az"].std())
    assert float((skyhook["actuator.force"] * skyhook["strut.velocity"]).min()) >= 0.0


def test_steps_make_the_same_run(rig: jn.Rig) -> None:
    damper = SemiActiveDamper(minimum=300.0, maximum=4000.0)
    run = jn.simulate(
        rig, TRIAL, control=Passive(damping_coefficient=2000.0, actuator=damper, rate=100.0)
    )
    stepper = Stepper(rig, TRIAL, damper, 100.0, samples=10)
    for _ in range(2):  # also after a new start
        stepper.start()
        parts = []
        while not stepper.is_finished:
            parts.append(stepper.step(np.array([2000.0])))
        for channel in ("sprung.z", "tyre.force"):
            found = np.hstack(parts)[stepper.channels.index(channel)]
            expected = run[channel].to_numpy()
            np.testing.assert_allclose(found, expected[1:], atol=1e-6 * np.ptp(expected))
    with pytest.raises(jn.SimulationError, match="the run is over"):
        stepper.step(np.array([2000.0]))


@pytest.mark.parametrize("commands", [[np.nan], [1.0, 2.0], []])
def test_steps_refuse_what_is_no_command(rig: jn.Rig, commands: list[float]) -> None:
    stepper = Stepper(rig, TRIAL, SemiActiveDamper(), 100.0)
    stepper.start()
    with pytest.raises(jn.SimulationError, match="1 finite numbers"):
        stepper.step(np.array(commands))


def test_detail_of_the_numbers_does_not_recompile(rig: jn.Rig) -> None:
    first = jn.simulate(rig, TRIAL, control=Skyhook(damping_coefficient=2000.0))
    second = jn.simulate(rig, TRIAL, control=controller("skyhook", damping_coefficient=3000.0))
    assert float(abs(first["command"] - second["command"]).max()) > 10.0
