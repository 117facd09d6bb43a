"""What a campaign knows: fitted tyre values reach every trial, decays are motions."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.campaign.characterise import (
    Knowledge,
    _has_value,
    _quantity,
    bench_values,
    characterise,
    tyre_of,
)
from jounce.campaign.description import Bench
from jounce.identify.estimate import Estimate
from jounce.identify.update import UpdatedParameter

LOW, HIGH = 250e3, 310e3


def curved(*coefficients: float) -> jn.Rig:
    kart = jn.load("kart-quarter-car")
    table = kart.model_dump(by_alias=True, exclude_none=True)
    curve = {"kind": "polynomial", "coefficients": list(coefficients)}
    return type(kart).from_table({**table, "tyre": {"curve": curve}})


def fitted(initial: float, value: float) -> UpdatedParameter:
    return UpdatedParameter(
        initial, value, None, None, 0.0, 2.0 * value, at_bound=False, unit="N/m"
    )


@pytest.mark.parametrize("initial", [0.0, 4e6])
def test_a_fitted_tyre_coefficient_reaches_the_trials_whatever_its_start_was(initial):
    rig = curved(120e3, initial)
    path = "tyre.curve.coefficients[1]"
    known = Knowledge(rig, {HIGH: tyre_of(rig)}).after({path: fitted(initial, 5e6)}, [HIGH])
    assert known.rig.parameters()[path] == pytest.approx(5e6)
    assert known.rig_for(None, HIGH, {}).parameters()[path] == pytest.approx(5e6)


def test_a_start_above_zero_is_scaled_at_each_pressure():
    known = Knowledge(curved(120e3), {HIGH: tyre_of(curved(120e3)), LOW: tyre_of(curved(100e3))})
    path = "tyre.curve.coefficients[0]"
    known = known.after({path: fitted(120e3, 132e3)}, [HIGH, LOW])
    assert known.rig_for(None, HIGH, {}).parameters()[path] == pytest.approx(132e3)
    assert known.rig_for(None, LOW, {}).parameters()[path] == pytest.approx(110e3)


def test_a_force_is_no_free_decay():
    assert [_quantity(f"sprung.{name}") for name in ("z", "vz", "az")] == [
        "displacement",
        "velocity",
        "acceleration",
    ]
    with pytest.raises(jn.RecordingError, match=r"channel 'tyre.force': invalid motion; found 'N'"):
        _quantity("tyre.force")


def test_a_spring_that_carries_nothing_is_measured_all_the_same(tmp_path: Path) -> None:
    """A torsion bar may carry more than the body weighs: the static force of the spring is none to look for."""
    rows = "".join(f"{x},{22.7 * x}\n" for x in range(16))
    (tmp_path / "spring.csv").write_text(f"displacement [mm], force [N]\n{rows}", encoding="utf-8")
    bar = {"stiffness": 60.0, "preload": 60.0, "on": "lower_arm"}
    rig = jn.load("kart-double-wishbone").with_changes({"torsion_bar": bar})
    found, knowledge = characterise(rig, Bench(spring={"files": ["spring.csv", "*.csv"]}), tmp_path)
    assert not found.failed
    assert knowledge.rig.parameters()["strut.spring.rate"] == pytest.approx(22700.0)
    assert found.spring is not None
    assert found.spring.operating_deflection is None
    assert len(found.spring.trials) == 1  # a file that two patterns match is no repetition


def test_a_bench_result_that_is_a_problem_replaces_nothing(tmp_path: Path) -> None:
    x = np.linspace(0.0, 20.0, 41)
    rows = "".join(f"{d},{22.7 * d * (1.0 - d / 25.0)}\n" for d in x)
    (tmp_path / "spring.csv").write_text(f"displacement [mm], force [N]\n{rows}", encoding="utf-8")
    rig = jn.load("kart-quarter-car")
    bench = Bench(spring={"files": ["spring.csv"], "law": "polynomial"})
    found, knowledge = characterise(rig, bench, tmp_path)
    assert knowledge.rig == rig
    assert found.replaced == []
    (kept,) = [one for one in found.findings if "not used" in one.message]
    assert (kept.place, kept.severity) == ("bench.spring", "problem")
    assert "does not rise everywhere" in kept.message
    assert bench_values(found, rig, None) == {}
    assert _has_value(found, "here", (), Estimate(500.0, 249.0, None))
    assert not _has_value(found, "here", (), Estimate(500.0, 251.0, None))
    assert (
        found.findings[-1].message
        == "not used, the described value applies: 500 ± 2.5e+02 is no value"
    )


def test_a_mass_is_added_in_one_trial_only() -> None:
    known = Knowledge(jn.load("kart-quarter-car"))
    assert known.rig_for(None, None, {"sprung.mass": 15.0}, 2.6).parameters()["sprung.mass"] == 17.6
    assert known.rig.parameters()["sprung.mass"] == 16.0
