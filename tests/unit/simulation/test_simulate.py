"""What ``simulate`` promises: channels, units, times, starts away from rest, and outcomes."""

from __future__ import annotations

import numpy as np
import pytest

import jounce
from jounce import parts
from jounce.core.errors import SimulationError
from jounce.models import build
from jounce.simulation import prepare as run_module
from jounce.simulation.compiled import compile_model, compile_rig
from jounce.simulation.problem import excitation
from jounce.simulation.settings import output_times

KART = parts.load("kart-quarter-car")
TRIAL = jounce.Trial(
    road=jounce.HalfSine(height="10 mm", length="60 mm", start="0.2 m"),
    speed="1.95 m/s",
    duration="1 s",
)


@pytest.mark.parametrize(
    ("duration", "step", "count", "last"),
    [
        (1.0, 1e-3, 1001, 1.0),
        (0.3, 0.1, 4, 0.3),
        (0.35, 0.1, 5, 0.35),
        (0.05, 0.1, 2, 0.05),
        (3.0, 1e-3, 3001, 3.0),
    ],
)
def test_output_times(duration, step, count, last):
    times = output_times(duration, step)
    assert len(times) == count
    assert times[0] == 0.0
    assert times[-1] == pytest.approx(last, rel=1e-15)
    assert np.all(np.diff(times) > 0.0)


def test_recording():
    run = jounce.simulate(KART, TRIAL)
    assert run.sizes == {"time": 1001}
    assert run["time"].attrs["units"] == "s"
    assert run.attrs["status"] == "completed"
    assert run.attrs["events"] > 0
    for name, channel in run.data_vars.items():
        assert channel.attrs["units"]
        assert channel.attrs["long_name"]
        assert channel.attrs["place"] == name.rpartition(".")[0]
        assert np.isfinite(channel).all()


def test_starts_at_rest_and_until_the_obstacle_nothing_moves():
    run = jounce.simulate(KART, TRIAL)
    before = run.where(run["time"] < 0.2 / 1.95 - 1e-9, drop=True)
    assert float(abs(before["sprung.az"]).max()) < 1e-9
    assert float(before["tyre.force"].std()) < 1e-9
    assert float(before["sprung.z"][0]) == pytest.approx(
        jounce.equilibrium(KART)["sprung.z"], rel=1e-12
    )


def test_channels_agree_with_each_other():
    """Velocities are slopes of heights, accelerations of velocities; deflections are differences."""
    run = jounce.simulate(KART, TRIAL, output_step=1e-4, tolerance=1e-8)
    for body in ("sprung", "unsprung"):
        z, v, a = (run[f"{body}.{quantity}"].values for quantity in ("z", "vz", "az"))
        assert np.max(np.abs(np.gradient(z, 1e-4)[1:-1] - v[1:-1])) < 1e-3 * np.max(np.abs(v)) * 2
        assert np.max(
            np.abs(np.cumsum(0.5 * (a[1:] + a[:-1])) * 1e-4 - (v[1:] - v[0]))
        ) < 1e-3 * np.max(np.abs(v))
    cos = np.cos(np.radians(26.0))
    assert run["strut.deflection"].values == pytest.approx(
        cos * (run["unsprung.z"] - run["sprung.z"]).values, abs=1e-15
    )
    assert run["tyre.deflection"].values == pytest.approx(
        (run["road.z"] - run["unsprung.z"]).values, abs=1e-15
    )
    newton = 5.0 * (run["unsprung.az"] + 9.81) + cos * run["strut.force"] - run["tyre.force"]
    assert float(abs(newton).max()) < 1e-9


def test_offset_starts_a_decay():
    level = jounce.Trial(road=jounce.Flat(), speed=1.0, duration=1.0)
    run = jounce.simulate(KART, level, offset={"sprung.z": 0.005, "unsprung.vz": 0.1})
    rest = jounce.equilibrium(KART)
    assert float(run["sprung.z"][0]) == pytest.approx(rest["sprung.z"] + 0.005, abs=1e-15)
    assert float(run["unsprung.vz"][0]) == pytest.approx(0.1)
    assert float(abs(run["sprung.z"][-1] - rest["sprung.z"])) < 1e-3


def test_offset_that_is_no_state():
    with pytest.raises(SimulationError, match=r"sprung\.zz: not a state of the model.*sprung\.z"):
        jounce.simulate(KART, TRIAL, offset={"sprung.zz": 0.1})


def test_free_parameter_that_is_none():
    with pytest.raises(
        SimulationError,
        match=r"strut\.sprung\.rate: not a parameter of the model.*strut\.spring\.rate",
    ):
        compile_model(build(KART), ("strut.sprung.rate",))


def test_a_model_is_compiled_once():
    assert compile_model(build(KART)) is compile_model(
        build(KART.with_changes({"sprung.mass": 20.0}))
    )


def test_run_that_does_not_reach_its_end(monkeypatch):
    monkeypatch.setattr(run_module, "MAX_STEPS", 20)
    with pytest.raises(SimulationError, match=r"did not reach its end.*step budget"):
        jounce.simulate(KART, TRIAL, method="explicit")
    run = jounce.simulate(KART, TRIAL, method="explicit", check=False)
    assert run.attrs["status"] == "too_many_steps"


def test_broken_run_holds_no_invented_samples(monkeypatch):
    monkeypatch.setattr(run_module, "MAX_STEPS", 20)
    run = jounce.simulate(KART, TRIAL, method="explicit", check=False)
    late = run["sprung.z"].values[-10:] if run.sizes["time"] == 1001 else np.full(1, np.nan)
    assert np.isnan(late).all()


@pytest.mark.parametrize("step", [0.0, -1e-3, float("nan")])
def test_impossible_output_steps(step):
    with pytest.raises(SimulationError, match="step"):
        jounce.simulate(KART, TRIAL, output_step=step)


@pytest.mark.parametrize("tolerance", [0.0, -1e-5, float("nan")])
def test_impossible_tolerances(tolerance):
    with pytest.raises(SimulationError, match="tolerance"):
        jounce.simulate(KART, TRIAL, tolerance=tolerance)


def test_remembered_fresh_and_sliced_times_are_the_same_to_the_loops():
    compiled = compile_rig(KART)
    signal = excitation(compiled.facts, KART, TRIAL)
    p, fresh = compiled.parameter_values(KART.parameters()), np.linspace(0.0, 1.0, 1001)
    remembered = fresh.copy()
    remembered.setflags(write=False)
    sliced = np.linspace(0.0, 1.0, 2001)[::2]
    runs = [
        run_module.solve(compiled, p, signal, times).states for times in (fresh, remembered, sliced)
    ]
    assert np.array_equal(runs[0], runs[1])
    assert np.array_equal(sliced, fresh)
    assert np.array_equal(runs[0], runs[2])


def test_a_run_repeated_is_the_same_run_whatever_is_remembered():
    from jounce.simulation.compiled import compile_rig

    trial = jounce.Trial(
        road=jounce.HalfSine(height="10 mm", length="60 mm", start="0.2 m"),
        speed="1.95 m/s",
        duration="1 s",
    )
    rig = jounce.load("kart-quarter-car")
    first = jounce.simulate(rig, trial)
    kept = first.copy(deep=True)
    other = jounce.simulate(rig.with_changes({"sprung.mass": "90 kg"}), trial)
    assert not np.array_equal(other["sprung.z"], first["sprung.z"])
    again = jounce.simulate(rig, trial)
    assert again.identical(first)
    compile_rig(rig).equilibria.clear()
    assert jounce.simulate(jounce.load("kart-quarter-car"), trial.model_copy()).identical(kept)
    again["sprung.z"][:] = 0.0
    assert first.identical(kept)


def test_states_of_rest_are_remembered_as_far_as_everything_is(monkeypatch):
    """A server met another one with every drag of a slider, and kept 256 of each of its models."""
    from jounce.core.remembered import Recent
    from jounce.simulation.compiled import compile_rig

    monkeypatch.setattr(Recent, "most", 3)
    rig = jounce.load("kart-double-wishbone")
    for mass in range(10, 20):
        jounce.equilibrium(rig.with_changes({"sprung.mass": float(mass)}))
    assert len(compile_rig(rig).equilibria._kept) == 3


def test_a_road_file_that_changes_between_two_runs_is_read_again(tmp_path):
    file = tmp_path / "road.csv"
    file.write_text("x [m], z [mm]\n0, 0\n0.5, 10\n1, 0\n")
    trial = jounce.Trial(road=jounce.roads.Table(file=file), speed="2 m/s", duration="0.4 s")
    rig = jounce.load("kart-quarter-car")
    first = jounce.simulate(rig, trial)
    file.write_text("x [m], z [mm]\n0, 0\n0.5, 20.0\n1, 0\n")
    second = jounce.simulate(rig, trial)
    assert float(second["road.z"].max()) == pytest.approx(2.0 * float(first["road.z"].max()))


def test_what_is_shared_between_runs_cannot_be_changed():
    from jounce.simulation.compiled import compile_rig
    from jounce.simulation.settings import RunSettings
    from jounce.simulation.statics import find_equilibrium

    assert RunSettings().times(1.0) is RunSettings().times(1)
    with pytest.raises(ValueError, match="read-only"):
        RunSettings().times(1.0)[0] = 1.0
    rig = jounce.load("kart-quarter-car")
    compiled = compile_rig(rig)
    rest = find_equilibrium(
        compiled, compiled.parameter_values(rig.parameters()), compiled.inputs()
    )
    for name in ("x", "slope", "balance"):
        with pytest.raises(ValueError, match="read-only"):
            getattr(rest, name)[0] = 1.0


@pytest.mark.parametrize("method", ["auto", "implicit", "explicit"])
@pytest.mark.parametrize("mass", [1e-12, 1e-10])
def test_slips_in_units_that_no_run_can_follow_are_told_at_once(mass: float, method: str) -> None:
    """A wheel of 1e-12 kg swings at 70 MHz: the run would end after all its steps, ten seconds later."""
    rig = jounce.load("kart-quarter-car").with_changes({"unsprung.mass": mass})
    trial = jounce.Trial(
        road=jounce.HalfSine(height=0.01, length=0.06, start=0.2), speed=2.0, duration=3.0
    )
    with pytest.raises(
        SimulationError, match=r"too fast for a run of this length; found '\S+ Hz for 3 s"
    ) as caught:
        jounce.simulate(rig, trial, method=method)
    assert method == "explicit" or caught.value.where == "unsprung.z"
    assert "Check masses and stiffnesses" in str(caught.value)
