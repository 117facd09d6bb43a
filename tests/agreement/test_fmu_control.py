"""A component FMU in the loop does what the same law of jounce does, in this process and in a child."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

fmu_component = pytest.importorskip("fmu_component")
from jounce.control.fmu import FmuControl  # noqa: E402

if not fmu_component.can_be_made():
    pytest.skip("no compiler", allow_module_level=True)

TRIAL = jn.Trial(
    road=jn.HalfSine(height="30 mm", length="0.5 m", start="0.5 m"),
    speed="10 m/s",
    duration="0.5 s",
)
INPUTS = {"v_body": "sprung.vz", "v_strut": "strut.velocity"}


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    folder = tmp_path_factory.mktemp("component")

    def make(version, **more):
        return str(
            fmu_component.write(
                folder / f"{version}.fmu", version, fmu_component.binary(version, folder), **more
            )
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
        return run, float(
            np.abs(run["unsprung.z"].values[: len(own)] - own[: run.sizes["time"]]).max()
            / np.ptp(own)
        )

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
    assert any(
        finding.startswith("warning") and "higher rate" in finding
        for finding in coarse.attrs["findings"]
    )


@pytest.mark.parametrize("hold", ["zero", "first"])
def test_a_coupling_that_is_unstable_is_refused(damped, hold) -> None:
    """What is refused swings to the limit of its force, what is allowed does not."""
    with pytest.raises(jn.SimulationError, match="coupling is unstable") as refused:
        damped(60.0, hold=hold, rate=1000.0)
    assert (
        np.abs(damped(60.0, check=False, hold=hold, rate=1000.0)[0]["command"].values).max() == 1e6
    )
    allowed = float(str(refused.value).partition("allowed: ")[2].partition(" Hz")[0])
    assert np.abs(damped(60.0, hold=hold, rate=allowed)[0]["command"].values).max() < 1e5
    with pytest.raises(jn.SimulationError, match=r"grow at any rate.*signs"):
        damped(-1.0, hold=hold, rate=1000.0)


SPRING = {"deflection": "strut.deflection"}
TYRE = {"deflection": "tyre.deflection", "rate": "actuator.velocity"}


@pytest.fixture(scope="module")
def element(made):
    """A run with an element in an FMU; its numbers are those of the FMU."""

    def drive(rig, place, trial=TRIAL, numbers=None, **fields):
        law = FmuControl(
            file=made(3), inputs=TYRE if place == "tyre" else SPRING, output="load", trusted=True,
            actuator=jn.ActiveActuator(in_place_of=place), parameters=numbers or {}, **fields,
        )  # fmt: skip
        return jn.simulate(rig, trial, control=law, tolerance=1e-7)

    return drive


@pytest.fixture(scope="module")
def stiff_and_soft():
    """The Audi, and one with a softer spring and tyre, whose place others take."""
    rig = jn.load("audi-a6-quarter-car")
    changed = {"strut.spring.rate": 0.7, "tyre.stiffness": 0.7}
    return rig, {
        place: rig.with_changes({path: share * rig.parameters()[path]})
        for place, (path, share) in zip(("spring", "tyre"), changed.items(), strict=True)
    }


@pytest.mark.parametrize(
    ("place", "hold", "order"), [("spring", "zero", 1), ("spring", "first", 2), ("tyre", "zero", 1)]
)
def test_springs_and_tyres_converge_to_those_in_the_equations(
    stiff_and_soft, element, place, hold, order
) -> None:
    """From the same rest, with the tyre off the road for a while."""
    rig, soft = stiff_and_soft
    own = jn.simulate(rig, TRIAL, tolerance=1e-7)
    numbers = {
        "spring": {"stiffness": rig.strut.spring.rate},
        "tyre": {
            "stiffness": rig.tyre.stiffness,
            "damping": rig.tyre.damping_coefficient,
            "pulls": 0.0,
        },
    }[place]
    errors = []
    for rate in (1000.0, 2000.0):
        run = element(soft[place], place, numbers=numbers, hold=hold, rate=rate)
        for channel in ("sprung.z", "unsprung.z", "tyre.deflection", "strut.force", "tyre.force"):
            assert run[channel].values[0] == pytest.approx(
                own[channel].values[0], rel=1e-7, abs=1e-9
            )
        assert run["tyre.force"].values.min() == 0.0
        assert run.attrs["events"] == own.attrs["events"]
        error = np.abs(run["unsprung.z"].values - own["unsprung.z"].values).max()
        errors.append(float(error) / np.ptp(own["unsprung.z"].values))
    assert 0.95 * 2**order < errors[0] / errors[1] < 1.05 * 2**order
    assert errors[1] < (0.005 if order == 1 else 2e-5)


def test_a_rig_rests_where_the_fmu_carries_it(stiff_and_soft, element) -> None:
    """On a stiffening spring with preload: its law at rest gives the static load, and the rig stays there."""
    rig, _ = stiff_and_soft
    still = jn.Trial(road=jn.Flat(), speed="1 m/s", duration="0.3 s")
    load = float(jn.simulate(rig, still)["strut.force"].values[0])
    run = element(
        rig,
        "spring",
        still,
        numbers={"stiffness": 20e3, "preload": 600.0, "cubic": 4e6},
        rate=1000.0,
    )
    d = run["strut.deflection"].values[0]
    assert 600.0 + 20e3 * d + 4e6 * d**3 == pytest.approx(load, rel=1e-9)
    assert np.ptp(run["sprung.z"].values) < 1e-9
    assert not any(finding.startswith("warning") for finding in run.attrs["findings"])


def test_changes_from_rest_keep_the_rigs_own_load(stiff_and_soft, element) -> None:
    """A line through rest with the stiff rate moves the soft car as the stiff one moves."""
    rig, soft = stiff_and_soft
    own = jn.simulate(rig, TRIAL, tolerance=1e-7)["sprung.z"].values
    fields = {"from_rest": True, "rate": 4000.0, "hold": "first"}
    run = element(soft["spring"], "spring", numbers={"stiffness": rig.strut.spring.rate}, **fields)[
        "sprung.z"
    ].values
    np.testing.assert_allclose(run - run[0], own - own[0], rtol=0.0, atol=1e-5 * np.ptp(own))
    with pytest.raises(jn.SimulationError, match=r"not zero there; found '50 N'"):
        element(soft["spring"], "spring", numbers={"preload": 50.0}, **fields)


def test_a_stop_in_an_fmu_is_the_stop(made, stiff_and_soft) -> None:
    """The rig has none; of another tool's it feels nothing before the gap is closed."""
    rig, _ = stiff_and_soft
    law = FmuControl(
        file=made(3), inputs=SPRING, output="load", actuator=jn.ActiveActuator(in_place_of="stops"), trusted=True,
    )  # fmt: skip
    own = jn.simulate(rig, TRIAL)["sprung.z"].values
    np.testing.assert_allclose(
        jn.simulate(rig, TRIAL, control=law)["sprung.z"].values, own, rtol=0.0, atol=1e-7
    )
    firm = law.model_copy(
        update={"parameters": {"stiffness": 1e5, "preload": -13e3, "pulls": 0.0}, "rate": 1000.0}
    )
    run = jn.simulate(rig, TRIAL, control=firm)
    felt = run["actuator.force"].values
    assert felt.max() > 1000.0
    np.testing.assert_allclose(
        felt, np.fmax(1e5 * run["strut.deflection"].values - 13e3, 0.0), rtol=0.0, atol=1e-3
    )


def test_an_element_without_equilibrium_or_stability_is_refused(stiff_and_soft, element) -> None:
    rig, soft = stiff_and_soft
    for numbers, what in (
        ({}, r"no static equilibrium.*FMU; found '-4513 N"),
        ({"stiffness": -20e3}, "grow at any rate"),
    ):
        with pytest.raises(jn.SimulationError, match=what):
            element(rig, "spring", numbers=numbers)
    with pytest.raises(jn.SimulationError, match="coupling is unstable"):
        element(
            soft["tyre"],
            "tyre",
            numbers={"stiffness": 100.0 * rig.tyre.stiffness, "pulls": 0.0},
            rate=200.0,
        )
    with pytest.raises(jn.SimulationError, match="the rig has no tyre that a force could replace"):
        element(jn.load("audi-a6-half-car"), "tyre")


def test_a_tyre_of_another_radius_is_told(stiff_and_soft, element) -> None:
    rig, _ = stiff_and_soft
    numbers = {"stiffness": rig.tyre.stiffness, "preload": 2e3}
    found = element(rig, "tyre", numbers=numbers, rate=2000.0).attrs["findings"]
    assert any(
        "off the road, where the force has no effect on the wheel: compare the radii" in finding
        for finding in found
    )


def test_axles_have_numbers_of_their_own(element) -> None:
    """The half car with both its springs in FMUs moves as it does without."""
    rig = jn.load("audi-a6-half-car-4dof")
    own = jn.simulate(rig, TRIAL, tolerance=1e-7)
    rates = {axle: f"{getattr(rig, axle).spring_rate} N/m" for axle in ("front", "rear")}
    run = element(
        rig.with_changes({"front.spring_rate": 20e3, "rear.spring_rate": 30e3}), "spring",
        numbers={"stiffness": rates}, hold="first", rate=1000.0,
    )  # fmt: skip
    for channel in ("body.z", "body.pitch"):
        np.testing.assert_allclose(
            run[channel], own[channel], rtol=0.0, atol=1e-4 * np.ptp(own[channel].values)
        )


@pytest.mark.slow
@pytest.mark.parametrize("place", ["spring", "tyre"])
def test_a_3d_corner_with_an_element_in_an_fmu(element, place) -> None:
    """Of the same law: the spring about its load at design, the tyre with its damping."""
    rig = jn.load("kart-double-wishbone")
    own = jn.simulate(rig, TRIAL, tolerance=1e-7)
    rate, stiffness = rig.strut.spring.rate, rig.tyre.stiffness
    bottom, top = (np.array(getattr(rig.hardpoints, f"strut_{end}")) for end in ("bottom", "top"))
    preload = rate * (rig.strut.spring.free_length - np.linalg.norm(top - bottom))
    numbers = {
        "spring": {"stiffness": rate, "preload": preload},
        "tyre": {"stiffness": stiffness, "damping": rig.tyre.damping_coefficient, "pulls": 0.0},
    }[place]
    softer = {
        "spring": {"strut.spring.rate": 0.9 * rate},
        "tyre": {"tyre.stiffness": 0.9 * stiffness},
    }[place]
    runs = [
        element(rig.with_changes(softer), place, numbers=numbers, rate=rate)
        for rate in (2000.0, 4000.0)
    ]
    for channel in ("sprung.z", "unsprung.z"):
        there = own[channel].values
        coarse, fine = (
            float(np.abs(run[channel].values - there).max() / np.ptp(there)) for run in runs
        )
        assert 1.8 < coarse / fine < 2.2
        assert fine < 5e-3


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
    fields = {
        "rate": jn.controller(law).rate,
        **({} if actuator is None else {"actuator": actuator}),
    }
    other = jn.simulate(
        rig, TRIAL, control=FmuControl(file=str(made.path), from_rest=True, trusted=True, **fields)
    )
    for channel in ("front.command", "rear.command", "body.z"):
        assert np.ptp(own[channel].values) > 0.0
        np.testing.assert_allclose(
            other[channel], own[channel], rtol=1e-9, atol=1e-9 * np.ptp(own[channel].values)
        )


def test_a_controller_alone_is_valid_and_named(tmp_path) -> None:
    validation = pytest.importorskip("fmpy.validation")
    made = jn.export_fmu(
        jn.load("audi-a6-quarter-car"),
        tmp_path / "law.fmu",
        control="skyhook",
        controller_only=True,
    )
    assert validation.validate_fmu(str(made.path)) == []
    assert "sprung.vz" in made.inputs
    assert not any(name.endswith("_rate") for name in made.inputs)
    about = jn.read_fmu(made.path)
    assert {v.name: v.unit for v in (*about.inputs, *about.outputs)}["sprung.vz"] == "m/s"
    for control in (None, "passive"):
        with pytest.raises(jn.DescriptionError, match="controller"):
            jn.export_fmu(
                jn.load("audi-a6-quarter-car"),
                tmp_path / "no.fmu",
                control=control,
                controller_only=True,
            )
