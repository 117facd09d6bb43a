from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

RIG = jn.load("reference-double-wishbone")
TRAVEL = np.linspace(-0.06, 0.06, 13)


def test_a_batch_is_its_single_sweeps() -> None:
    random = np.random.default_rng(5)
    paths = ("hardpoints.upper_ball_joint[1]", "hardpoints.tie_rod_inner[2]", "strut.spring.rate", "wheel.camber")
    base = RIG.parameters()
    changes = {path: base[path] * (1.0 + 0.01 * random.standard_normal(4)) for path in paths}
    batch = jn.sweep_variants(RIG, changes, TRAVEL)
    assert np.array_equal(batch["reached"], [13] * 4)
    for k in range(4):
        single = jn.sweep_travel(RIG.with_changes({path: float(values[k]) for path, values in changes.items()}), TRAVEL)
        for name in single.data_vars:
            assert np.array_equal(batch[name].to_numpy()[k], single[name].to_numpy()), name
    assert batch["strut.spring.rate"].attrs["units"] == "N/m"
    assert np.array_equal(batch["wheel.camber"], changes["wheel.camber"])


def test_chosen_quantities_only() -> None:
    batch = jn.sweep_variants(RIG, {"wheel.camber": [0.0, 0.01]}, TRAVEL, quantities=["steer", "camber"])
    assert set(batch.data_vars) == {"steer", "camber", "reached"}


def test_out_of_reach_is_missing_and_does_not_spoil_the_next() -> None:
    batch = jn.sweep_variants(RIG, {"hardpoints.upper_ball_joint[1]": [0.69, 0.74, 0.69]}, np.linspace(-0.3, 0.24, 28))
    reached = batch["reached"].to_numpy()
    assert reached[0] == reached[2] != reached[1]
    assert reached[0] < 28
    assert np.array_equal(batch["camber"][0], batch["camber"][2], equal_nan=True)


@pytest.mark.parametrize(
    ("changes", "text"),
    [
        ({}, "no variants"),
        ({"hardpoints.upper_ball[0]": [0.0]}, "no such parameter"),
        ({"sprung.mass": [300.0]}, "does not enter the kinematics"),
        ({"wheel.camber": [np.nan]}, "not a finite number"),
        ({"wheel.camber": []}, "not a list of finite numbers"),
        ({"wheel.camber": [0.0], "wheel.toe": [0.0, 0.1]}, "different lengths"),
    ],
)
def test_bad_changes_are_refused(changes: dict[str, list[float]], text: str) -> None:
    with pytest.raises(jn.DescriptionError, match=text):
        jn.sweep_variants(RIG, changes, TRAVEL)


def test_unknown_quantities_are_refused() -> None:
    with pytest.raises(jn.DescriptionError, match="no such quantity"):
        jn.sweep_variants(RIG, {"wheel.camber": [0.0]}, TRAVEL, quantities=["cambre"])


@pytest.mark.parametrize(
    ("name", "size"),
    [
        ("reference-double-wishbone", 0.06),
        ("generic-mcpherson", 0.06),
        ("sedan-multi-link", 0.06),
        ("formula-student-front", 0.03),
    ],
)
def test_wide_steps_stay_on_the_branch_of_fine_ones(name: str, size: float) -> None:
    """Random mechanisms up to their ends of travel: poses far apart are those of poses close together."""
    random = np.random.default_rng(3)
    rig = jn.load(name)
    base = {path: value for path, value in rig.parameters().items() if path.startswith("hardpoints.")}
    changes = {path: value + random.uniform(-size, size, 400) for path, value in base.items()}
    names = ["camber", "steer", "spring_length"]
    wide = jn.sweep_variants(rig, changes, np.linspace(-4.0, 4.0, 11) * size, quantities=names)
    fine = jn.sweep_variants(rig, changes, np.linspace(-4.0, 4.0, 201) * size, quantities=names)
    for quantity in names:
        one, other = wide[quantity].to_numpy(), fine[quantity].to_numpy()[:, ::20]
        both = np.isfinite(one) & np.isfinite(other)
        assert both.mean() > 0.6
        assert np.mean(np.isfinite(one) != np.isfinite(other)) < 1e-3
        assert np.max(np.abs(one - other)[both]) < 1e-8
