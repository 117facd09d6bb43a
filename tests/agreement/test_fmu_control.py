"""A component FMU in the loop does what the same law of jounce does, in this process and in a child."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

fmu_component = pytest.importorskip("fmu_component")
from jounce.control.fmu import FmuControl  # noqa: E402

if not fmu_component.can_be_made():
    pytest.skip("no compiler", allow_module_level=True)

TRIAL = jn.Trial(road=jn.HalfSine(height="30 mm", length="0.5 m", start="0.5 m"), speed="10 m/s", duration="0.5 s")
INPUTS = {"v_body": "sprung.vz", "v_strut": "strut.velocity"}


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    folder = tmp_path_factory.mktemp("component")

    def make(version, **more):
        return str(
            fmu_component.write(folder / f"{version}.fmu", version, fmu_component.binary(version, folder), **more)
        )

    return make


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize("trusted", [False, True])
def test_a_skyhook_in_an_fmu_is_the_skyhook(made, version, trusted) -> None:
    rig = jn.load("audi-a6-quarter-car")
    damper = jn.SemiActiveDamper(minimum=300.0, maximum=4000.0)
    own = jn.simulate(rig, TRIAL, control=jn.Skyhook(damping_coefficient=4000.0, actuator=damper))
    ratio = float(jn.corner_models(rig)[""].motion_ratio)
    law = FmuControl(
        file=made(version), inputs=INPUTS, output="coefficient", actuator=damper, trusted=trusted,
        parameters={"gain": f"{4.0 / ratio} kN*s/m"},
    )  # fmt: skip
    other = jn.simulate(rig, TRIAL, control=law)
    assert np.ptp(own["command"].values) > 3000.0
    np.testing.assert_allclose(other["command"], own["command"], rtol=1e-9)
    np.testing.assert_allclose(other["sprung.z"], own["sprung.z"], rtol=0.0, atol=1e-12)
    assert any("spare = 2.5" in finding for finding in other.attrs["findings"])
    again = jn.simulate(rig, TRIAL, control=law)  # it begins anew
    np.testing.assert_array_equal(again["command"], other["command"])


@pytest.mark.parametrize("rate", [1000.0, 4000.0])
def test_a_damper_in_an_fmu_is_the_damper_sampled(made, rate) -> None:
    """The force of a period is that of its begin: half a period late, so that the difference falls with the period."""
    rig = jn.load("audi-a6-quarter-car")
    c = rig.strut.damper.coefficient
    own = jn.simulate(rig, TRIAL)
    actuator = jn.ActiveActuator(lag=0.0, force_limit=1e5, in_place_of_damper=True)
    law = FmuControl(
        file=made(3), inputs={"v_strut": "strut.velocity"}, output="force", actuator=actuator, rate=rate, trusted=True,
        parameters={"gain": c},
    )  # fmt: skip
    run = jn.simulate(rig, TRIAL, control=law)
    error = float(np.abs(run["sprung.z"] - own["sprung.z"]).max()) / np.ptp(own["sprung.z"].values)
    assert 1e-5 * 1000.0 / rate < error < 4e-3 * 1000.0 / rate
    free = jn.simulate(rig, TRIAL, control=law.model_copy(update={"parameters": {"gain": 0.0}}))
    undamped = jn.simulate(rig.with_changes({"strut.damper.coefficient": 0.0}), TRIAL)
    np.testing.assert_allclose(free["sprung.z"], undamped["sprung.z"], rtol=0.0, atol=1e-6)


@pytest.fixture(scope="module")
def damped(made):
    """The Audi over the bump with its damper in an FMU, ``times`` as firm, and the range-related error of the wheel."""
    rig = jn.load("audi-a6-quarter-car")
    actuator = jn.ActiveActuator(lag=0.0, force_limit=1e6, in_place_of_damper=True)
    own = jn.simulate(rig, TRIAL, tolerance=1e-7)["unsprung.z"].values

    def drive(times=1.0, check=True, **fields):
        law = FmuControl(
            file=made(3), inputs={"v_strut": "strut.velocity"}, output="force", actuator=actuator, trusted=True,
            parameters={"gain": times * rig.strut.damper.coefficient}, **fields,
        )  # fmt: skip
        run = jn.simulate(rig, TRIAL, control=law, tolerance=1e-7, check=check)
        return run, float(np.abs(run["unsprung.z"].values[: len(own)] - own[: run.sizes["time"]]).max() / np.ptp(own))

    return drive


@pytest.mark.parametrize(("hold", "order"), [("zero", 1), ("first", 2)])
def test_a_held_force_converges_with_the_period(damped, hold, order) -> None:
    """Orders of zero- and first-order hold."""
    coarse, fine = (damped(hold=hold, rate=rate)[1] for rate in (500.0, 1000.0))
    assert 0.95 * 2**order < coarse / fine < 1.05 * 2**order
    assert fine < {"zero": 0.02, "first": 0.001}[hold]


def test_a_force_without_a_rate_follows_the_fastest_mode(damped) -> None:
    """The wheel turns by at most 0.05 rad in a period: 0.5 ms; what holding makes of the work is said."""
    run, _ = damped()
    assert any("held for 0.5 ms" in finding for finding in run.attrs["findings"])
    assert np.unique(run["command"].values[100:110]).size == 10
    coarse, _ = damped(rate=50.0)
    assert any(finding.startswith("warning") and "higher rate" in finding for finding in coarse.attrs["findings"])


@pytest.mark.parametrize("hold", ["zero", "first"])
def test_a_coupling_that_is_unstable_is_refused(damped, hold) -> None:
    """What is refused swings to the limit of its force, what is allowed does not."""
    with pytest.raises(jn.SimulationError, match="coupling is unstable") as refused:
        damped(60.0, hold=hold, rate=1000.0)
    assert np.abs(damped(60.0, check=False, hold=hold, rate=1000.0)[0]["command"].values).max() == 1e6
    allowed = float(str(refused.value).partition("allowed: ")[2].partition(" Hz")[0])
    assert np.abs(damped(60.0, hold=hold, rate=allowed)[0]["command"].values).max() < 1e5
    with pytest.raises(jn.SimulationError, match=r"grow at any rate.*signs"):
        damped(-1.0, hold=hold, rate=1000.0)


def test_every_corner_of_a_car_has_its_own_instance(made) -> None:
    rig = jn.load("audi-a6-half-car-4dof")
    law = FmuControl(file=made(2), inputs=INPUTS, output="coefficient", trusted=True)
    own = jn.simulate(rig, TRIAL, control="passive")
    run = jn.simulate(rig, TRIAL, control=law)
    front, rear = (run[f"{corner}.command"].values for corner in ("front", "rear"))
    assert np.abs(front - rear).max() > 100.0
    assert own.sizes == run.sizes


@pytest.mark.parametrize("law", ["skyhook", pytest.param("lqr", marks=pytest.mark.slow)])
def test_a_controller_that_we_wrote_drives_our_car(tmp_path, law) -> None:
    """Of a half car: the law leaves jounce as an FMU of its own, and comes back."""
    rig = jn.load("audi-a6-half-car-4dof")
    made = jn.export_fmu(rig, tmp_path / "law.fmu", control=law, controller_only=True, version=2)
    assert set(made.outputs) == {"front.command", "rear.command"}
    assert made.parameters > 0
    own = jn.simulate(rig, TRIAL, control=law)
    actuator = jn.controller(law).actuator
    fields = {"rate": jn.controller(law).rate, **({} if actuator is None else {"actuator": actuator})}
    other = jn.simulate(rig, TRIAL, control=FmuControl(file=str(made.path), from_rest=True, trusted=True, **fields))
    for channel in ("front.command", "rear.command", "body.z"):
        assert np.ptp(own[channel].values) > 0.0
        np.testing.assert_allclose(other[channel], own[channel], rtol=1e-9, atol=1e-9 * np.ptp(own[channel].values))


def test_a_controller_alone_is_valid_and_named(tmp_path) -> None:
    validation = pytest.importorskip("fmpy.validation")
    made = jn.export_fmu(jn.load("audi-a6-quarter-car"), tmp_path / "law.fmu", control="skyhook", controller_only=True)
    assert validation.validate_fmu(str(made.path)) == []
    assert "sprung.vz" in made.inputs
    assert not any(name.endswith("_rate") for name in made.inputs)
    about = jn.read_fmu(made.path)
    assert {v.name: v.unit for v in (*about.inputs, *about.outputs)}["sprung.vz"] == "m/s"
    for control in (None, "passive"):
        with pytest.raises(jn.DescriptionError, match="controller"):
            jn.export_fmu(jn.load("audi-a6-quarter-car"), tmp_path / "no.fmu", control=control, controller_only=True)
