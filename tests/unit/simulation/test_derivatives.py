"""Gradients of objectives: against central differences, and what is refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.recordings import check_recording

TRIAL = jn.Trial(
    road=jn.HalfSine(height="10 mm", length="100 mm", start="0.1 m"),
    speed="1.95 m/s",
    duration="0.4 s",
)
WISHBONES = jn.load(Path(__file__).parents[2] / "files" / "prototype-double-wishbone.toml")
QUARTER = jn.load("kart-quarter-car")
TEN = (
    "hardpoints.strut_bottom[2]",
    "hardpoints.upper_ball_joint[1]",
    "hardpoints.lower_ball_joint[1]",
    "hardpoints.tie_rod_outer[2]",
    "hardpoints.lower_arm_front[2]",
    "sprung.mass",
    "bodies.upright.mass",
    "strut.spring.rate",
    "strut.damper.coefficient",
    "tyre.stiffness",
)
WEIGHTS = {"sprung.az": 2.0, "tyre.force": 1e-4, "wheel.camber": 1e3}


def central(rig, path, objective, compiled=(), **options):
    """Slope by central differences of the value; ``compiled`` is a choice of parameters that has code already."""
    value = rig.parameters()[path]
    step = 1e-5 * max(abs(value), 1e-2)
    ahead, behind = (
        jn.gradient(
            rig.with_changes({path: value + sign * step}),
            TRIAL,
            compiled or [path],
            objective,
            tolerance=1e-11,
            **options,
        )
        for sign in (1, -1)
    )
    return (ahead.value - behind.value) / (2.0 * step)


@pytest.mark.parametrize("lift_off", [False, True])
def test_ten_parameters_of_the_double_wishbone(lift_off):
    rig = WISHBONES.with_changes({"tyre.lift_off": lift_off})
    found = jn.gradient(rig, TRIAL, TEN, WEIGHTS, tolerance=1e-8)
    assert tuple(found.gradient) == TEN
    for path in TEN:
        assert found.gradient[path] == pytest.approx(central(rig, path, WEIGHTS, TEN), rel=2e-5)


def test_value_is_the_weighted_mean_square():
    run = jn.simulate(WISHBONES, TRIAL)  # what slopes are of
    expected = {name: weight * float(np.mean(run[name] ** 2)) for name, weight in WEIGHTS.items()}
    found = jn.gradient(WISHBONES, TRIAL, ["sprung.mass"], WEIGHTS)
    assert found.channels == pytest.approx(expected, rel=1e-9)
    assert found.value == pytest.approx(sum(expected.values()), rel=1e-9)


def test_against_a_recording():
    measured = jn.simulate(QUARTER.with_changes({"tyre.stiffness": 150e3}), TRIAL)[
        ["sprung.az", "unsprung.az"]
    ]
    measured = measured.isel(time=slice(20, None, 3))  # starts later, at another rate
    weights = {"unsprung.az": 0.5}
    run = jn.simulate(QUARTER, TRIAL, method="explicit").isel(time=slice(20, None, 3))
    found = jn.gradient(
        QUARTER, TRIAL, ["tyre.stiffness", "unsprung.mass"], measured, weights=weights
    )
    assert found.value == pytest.approx(
        0.5 * float(((run - measured)["unsprung.az"] ** 2).sum()), rel=1e-6
    )
    for path, slope in found.gradient.items():
        assert slope == pytest.approx(
            central(QUARTER, path, measured, weights=weights, compiled=tuple(found.gradient)),
            rel=1e-4,
        )
    whole = jn.gradient(QUARTER, TRIAL, ["tyre.stiffness"], measured)
    assert set(whole.channels) == {"sprung.az", "unsprung.az"}


def test_at_the_truth_there_is_no_slope():
    measured = jn.simulate(QUARTER, TRIAL, method="explicit")[["sprung.z"]]
    found = jn.gradient(QUARTER, TRIAL, ["tyre.stiffness"], measured)
    assert found.value < 1e-25
    assert abs(found.gradient["tyre.stiffness"]) < 1e-20


def test_sensitivities_are_the_slopes_of_the_channels():
    paths = ["strut.spring.rate", "hardpoints.strut_top[1]"]
    found = jn.sensitivities(WISHBONES, TRIAL, paths, tolerance=1e-8)
    assert found["sprung.z"].dims == ("parameter", "time")
    assert found["parameter_units"].values.tolist() == ["N/m", "m"]
    assert found["tyre.force"].attrs["units"] == "N"
    step = 1e-6
    value = WISHBONES.parameters()[paths[1]]
    ahead, behind = (
        jn.simulate(WISHBONES.with_changes({paths[1]: value + sign * step}), TRIAL, tolerance=1e-11)
        for sign in (1, -1)
    )
    for channel in ("sprung.z", "strut.force", "wheel.camber", "unsprung.az"):
        expected = (ahead[channel] - behind[channel]) / (2 * step)
        error = float(np.abs(found[channel].sel(parameter=paths[1]) - expected).max())
        assert error < 2e-5 * float(np.abs(expected).max()), channel


@pytest.mark.parametrize(
    ("parameters", "objective", "options", "message"),
    [
        (["strut.spring.rat"], {"sprung.az": 1.0}, {}, "strut.spring.rate"),
        ([], {"sprung.az": 1.0}, {}, "at least one"),
        ("strut.spring.rate", {"sprung.az": 1.0}, {}, "a list of"),
        (["sprung.mass", "sprung.mass"], {"sprung.az": 1.0}, {}, "each only once"),
        (["sprung.mass"], {"sprung.ay": 1.0}, {}, "sprung.az"),
        (["sprung.mass"], {"sprung.az": -1.0}, {}, "0 or more"),
        (["sprung.mass"], {"sprung.az": np.nan}, {}, "0 or more"),
        (["sprung.mass"], {"sprung.az": 1.0}, {"output_step": 0.0}, "output_step"),
        (["sprung.mass"], {"sprung.az": 1.0}, {"tolerance": 0.0}, "tolerance"),
    ],
)
def test_what_is_refused(parameters, objective, options, message):
    with pytest.raises(jn.JounceError, match=message):
        jn.gradient(QUARTER, TRIAL, parameters, objective, **options)


@pytest.mark.usefixtures("units_kept")
def test_recordings_that_are_refused():
    measured = jn.simulate(QUARTER, TRIAL)[["sprung.az"]]
    later = measured.assign_coords(time=measured["time"] + 1.0)
    with pytest.raises(jn.SimulationError, match="does not fit"):
        jn.gradient(QUARTER, TRIAL, ["sprung.mass"], later)
    broken = measured.copy(deep=True)
    broken["sprung.az"][3] = np.nan
    with pytest.raises(jn.RecordingError, match="sample 4 is not a finite number"):
        jn.gradient(QUARTER, TRIAL, ["sprung.mass"], broken)
    with pytest.raises(jn.JounceError, match="weights"):
        jn.gradient(QUARTER, TRIAL, ["sprung.mass"], measured, weights={"unsprung.az": 1.0})


@pytest.mark.usefixtures("units_kept")
@pytest.mark.parametrize(
    ("change", "text"),
    [
        (
            lambda run: run.assign(
                {"sprung.az": (1e3 * run["sprung.az"]).assign_attrs(units="mm/s^2")}
            ),
            "found 'mm/s",
        ),
        (
            lambda run: run.assign({"sprung.az": run["sprung.az"].assign_attrs({"units": None})}),
            "has no unit",
        ),
        (
            lambda run: run.assign_coords(time=("time", run["time"].values / 1e3, {"units": "ks"})),
            "found 'ks'",
        ),
        (lambda run: run.assign_coords(time=("time", run["time"].values)), "time has no unit"),
        (
            lambda run: run.assign({"sprung.az": run["sprung.az"] + 1j * run["sprung.az"]}),
            "not real numbers",
        ),
    ],
)
def test_measured_data_are_checked_as_by_an_update(change, text: str) -> None:
    measured = change(jn.simulate(QUARTER, TRIAL)[["sprung.az"]])
    with pytest.raises(jn.RecordingError, match=text):
        jn.gradient(QUARTER, TRIAL, ["sprung.mass"], measured)
    with pytest.raises(jn.RecordingError, match=text):
        jn.update_model([jn.FitTrial("a", QUARTER, TRIAL, measured)], {"sprung.mass": "10 %"})


@pytest.mark.parametrize(
    "change",
    [
        lambda run: run.assign({"sprung.az": run["sprung.az"].assign_attrs(units="m/s**2")}),
        lambda run: run.assign({"sprung.az": run["sprung.az"].assign_attrs(units="m s-2")}),
        lambda run: run.assign_coords(
            time=("time", np.round(1e9 * run["time"].values).astype("m8[ns]"))
        ),
        lambda run: run.assign_coords(
            time=np.datetime64("2026-03-29") + np.round(1e9 * run["time"]).astype("m8[ns]")
        ),
    ],
)
def test_measured_data_count_however_units_and_times_are_written(change) -> None:
    softer = jn.simulate(QUARTER.with_changes({"sprung.mass": 1.05 * QUARTER.sprung.mass}), TRIAL)[
        ["sprung.az"]
    ]
    plain = jn.gradient(QUARTER, TRIAL, ["sprung.mass"], softer)
    check_recording(jn.FitTrial("a", QUARTER, TRIAL, change(softer)).measured)
    found = jn.gradient(QUARTER, TRIAL, ["sprung.mass"], change(softer))
    assert found.gradient == pytest.approx(plain.gradient, rel=1e-9)
