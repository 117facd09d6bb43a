from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

RIG = jn.load("reference-double-wishbone")
TRAVEL = np.linspace(-0.06, 0.06, 13)


def test_a_batch_is_its_single_sweeps() -> None:
    random = np.random.default_rng(5)
    paths = (
        "hardpoints.upper_ball_joint[1]",
        "hardpoints.tie_rod_inner[2]",
        "strut.spring.rate",
        "wheel.camber",
    )
    base = RIG.parameters()
    changes = {path: base[path] * (1.0 + 0.01 * random.standard_normal(4)) for path in paths}
    batch = jn.sweep_variants(RIG, changes, TRAVEL)
    assert np.array_equal(batch["reached"], [13] * 4)
    for k in range(4):
        single = jn.sweep_travel(
            RIG.with_changes({path: float(values[k]) for path, values in changes.items()}), TRAVEL
        )
        for name in single.data_vars:
            assert np.array_equal(batch[name].to_numpy()[k], single[name].to_numpy()), name
    assert batch["strut.spring.rate"].attrs["units"] == "N/m"
    assert np.array_equal(batch["wheel.camber"], changes["wheel.camber"])


def test_chosen_quantities_only() -> None:
    batch = jn.sweep_variants(
        RIG, {"wheel.camber": [0.0, 0.01]}, TRAVEL, quantities=["steer", "camber"]
    )
    assert set(batch.data_vars) == {"steer", "camber", "reached"}


def test_out_of_reach_is_missing_and_does_not_spoil_the_next() -> None:
    batch = jn.sweep_variants(
        RIG, {"hardpoints.upper_ball_joint[1]": [0.69, 0.74, 0.69]}, np.linspace(-0.3, 0.24, 28)
    )
    reached = batch["reached"].to_numpy()
    assert reached[0] == reached[2] != reached[1]
    assert reached[0] < 28
    assert np.array_equal(batch["camber"][0], batch["camber"][2], equal_nan=True)


@pytest.mark.parametrize(
    ("changes", "text"),
    [
        ({}, "no variants"),
        ({"hardpoints.upper_ball[0]": [0.0]}, "unknown parameter"),
        ({"sprung.mass": [300.0]}, "has no effect on the kinematics"),
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
    base = {
        path: value for path, value in rig.parameters().items() if path.startswith("hardpoints.")
    }
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


CAR = jn.AxleLayout(axle="front", wheelbase=2.7, centre_of_mass_height=0.55, brake_share=0.6)


# points, racks, axles -------------------------------------------------------------------------------------------------


def test_points_racks_and_pairs_of_both() -> None:
    base = np.array(RIG.hardpoints.tie_rod_inner)
    places = [base.tolist(), ["2 mm", float(base[1]), float(base[2]) + 0.003]]
    batch = jn.sweep_variants(
        RIG, {"hardpoints.tie_rod_inner": places}, [-0.02, 0.0, 0.03], rack="-10 mm:10 mm:10 mm"
    )
    assert batch["steer"].dims == ("variant", "wheel_travel", "rack_travel")
    assert batch["hardpoints.tie_rod_inner[0]"].to_numpy().tolist() == [base[0], 0.002]
    for k, place in enumerate(places):
        single = jn.sweep_travel(
            RIG.with_changes({"hardpoints.tie_rod_inner": place}),
            [-0.02, 0.0, 0.03],
            [-0.01, 0.0, 0.01],
        )
        assert batch["rack_travel"].to_numpy() == pytest.approx(
            single["rack_travel"].to_numpy(), abs=1e-15
        )
        for name in ("steer", "camber_gain", "steer_gain"):
            assert np.array_equal(batch[name].to_numpy()[k], single[name].to_numpy()), name
    assert batch["reached"].to_numpy().tolist() == [9, 9]


def test_axles_in_roll_and_steered() -> None:
    changes = {"hardpoints.upper_ball_joint[2]": [0.45, 0.46], "strut.spring.rate": [25e3, 30e3]}
    names = ["roll_centre_height", "roll_stiffness", "left.camber_to_ground"]
    roll, rack = np.radians([-2.0, 0.0, 1.0]), [-0.02, 0.0, 0.01]
    batch = jn.sweep_variants(RIG, changes, roll=roll, quantities=names)
    turned = jn.sweep_variants(RIG, changes, 0.01, rack=rack, axle=True, vehicle=CAR)
    for k in range(2):
        rig = RIG.with_changes({path: values[k] for path, values in changes.items()})
        rolled, steered = jn.sweep_roll(rig, roll), jn.sweep_steering(rig, rack, 0.01, vehicle=CAR)
        for name in names:
            assert batch[name].to_numpy()[k] == pytest.approx(rolled[name].to_numpy(), rel=1e-12), (
                name
            )
        for name in ("ackermann", "mean_steer", "right.camber"):
            assert turned[name].to_numpy()[k] == pytest.approx(
                steered[name].to_numpy(), rel=1e-12, nan_ok=True
            ), name
    assert set(batch.data_vars) == {*names, "reached"}
    assert turned["mean_steer"].dims == ("variant", "rack_travel")
    far = jn.sweep_variants(RIG, changes, roll=[-1.0, 0.0], quantities=names)
    assert far["reached"].to_numpy().tolist() == [1, 1]
    assert np.isnan(far["roll_stiffness"].to_numpy()[:, 0]).all()
    assert np.isfinite(far["roll_stiffness"].to_numpy()[:, 1]).all()


@pytest.mark.parametrize(
    ("given", "text"),
    [
        ({"roll": 0.01, "travel": 0.0}, "wheel travel follows from the roll"),
        ({"roll": 2.0}, "too steep"),
        ({"axle": True}, "nothing to sweep is given"),
        ({"axle": True, "rack": [0.0, 0.01], "travel": [0.0, 0.01]}, "only a single value"),
        ({"roll": 0.01, "quantities": ["roll_center"]}, "no such quantity"),
        (
            {
                "vehicle": jn.AxleLayout(
                    axle="rear", wheelbase=2.0, centre_of_mass_height=0.5, brake_share=0.4
                )
            },
            "steered axle",
        ),
    ],
)
def test_bad_axles_of_variants(given, text: str) -> None:
    with pytest.raises(jn.DescriptionError, match=text):
        jn.sweep_variants(RIG, {"wheel.camber": [0.0]}, **given)


@pytest.mark.parametrize(
    ("changes", "text"),
    [
        ({"hardpoints.tie_rod_inner": [0.1, 0.2, 0.3]}, "not a list of positions"),
        ({"hardpoints.tie_rod_inner": [[0.1, 0.2, np.nan]]}, "not a finite number"),
        (
            {"hardpoints.tie_rod_inner": [[0.1, 0.2, 0.3]], "hardpoints.tie_rod_inner[0]": [0.1]},
            "given twice",
        ),
        ({"hardpoints.tie_rod_inner": [[-106.0, 101.6, 110.0]]}, "106 m.*Millimetres meant"),
        ({"hardpoints.tie_rod_inner[2]": [0.11, 112.0]}, "112 m.*Millimetres meant"),
    ],
)
def test_bad_places_are_refused(changes, text: str) -> None:
    with pytest.raises(jn.DescriptionError, match=text):
        jn.sweep_variants(RIG, changes, TRAVEL)
