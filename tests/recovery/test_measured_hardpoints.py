"""Hardpoints from measured poses: synthetic readings of a known rig, of which 95 % intervals cover 95 %."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

FRONT = "formula-student-front"
MOVED = {
    "hardpoints.tie_rod_inner[2]": 0.004,
    "hardpoints.upper_arm_front[2]": -0.006,
    "hardpoints.upper_arm_rear[2]": 0.005,
    "hardpoints.upper_ball_joint[1]": -0.004,
}
NOISE = {"toe": np.radians(0.01), "camber": np.radians(0.02), "wheel_centre_x": 1e-4}
TRAVEL = np.linspace(-0.03, 0.03, 31)
RACK = np.where(np.arange(31) % 2 == 0, 0.0, 0.005)
OFFSET = 0.005  # rad of camber


@pytest.fixture(scope="module")
def truth() -> tuple[jn.Rig, dict[str, np.ndarray]]:
    rig = jn.load(FRONT)
    before = rig.parameters()
    other = rig.with_changes({path: before[path] + shift for path, shift in MOVED.items()})
    swept = jn.sweep_path(other, TRAVEL, RACK)
    return other, {name: swept[name].to_numpy() for name in NOISE}


def readings(truth: dict[str, np.ndarray], seed: int) -> dict[str, np.ndarray]:
    random = np.random.default_rng(seed)
    found = {
        name: values + random.normal(0.0, NOISE[name], len(TRAVEL))
        for name, values in truth.items()
    }
    found["camber"] = found["camber"] + OFFSET
    return {"wheel_travel": TRAVEL, "rack_travel": RACK} | found


def test_intervals_cover_the_truth(truth) -> None:
    rig, values = truth
    seeds, covered = 40, np.zeros(len(MOVED) + 1)
    for seed in range(seeds):
        found = jn.fit_hardpoints(
            FRONT,
            readings(values, seed),
            dict.fromkeys(MOVED, "15 mm"),
            offsets=["camber"],
            starts=1,
        )
        covered += [
            *(found.numbers[path].has(rig.parameters()[path]) for path in MOVED),
            found.offsets["camber"].has(OFFSET),
        ]
    # of 40 draws at 95 %: 33 or fewer happen once in two thousand, all of one number cover once in eight
    assert np.all(covered >= 34), covered
    assert covered.sum() <= 0.99 * seeds * len(covered)


def test_noise_that_is_given_and_poses_without_a_reading(truth) -> None:
    rig, values = truth
    table = readings(values, 7)
    table["toe"] = np.where(np.arange(31) % 5 == 0, np.nan, table["toe"])
    found = jn.fit_hardpoints(
        FRONT,
        table,
        dict.fromkeys(MOVED, "15 mm"),
        noise={"toe": "0.01 deg", "camber": "0.02 deg", "wheel_centre_x": 1e-4},
        offsets=["camber"],
        starts=2,
    )
    assert found.agreed == 2
    for path in MOVED:
        assert found.numbers[path].value == pytest.approx(rig.parameters()[path], abs=2e-3), path
    assert (
        found.rig.parameters()["hardpoints.tie_rod_inner[2]"]
        == found.numbers["hardpoints.tie_rod_inner[2]"].value
    )
    assert (
        found.quantities["toe"].rms_after < 1.5 * NOISE["toe"] < found.quantities["toe"].rms_before
    )
    assert not found.findings


def test_a_model_that_does_not_explain_the_readings_says_so(truth) -> None:
    _, values = truth
    table = readings(values, 3)
    table["toe"] = table["toe"] + np.radians(0.3) * np.sin(400.0 * TRAVEL)
    found = jn.fit_hardpoints(
        FRONT, table, {"hardpoints.tie_rod_inner[2]": "15 mm"}, noise={"toe": "0.01 deg"}, starts=1
    )
    assert any("does not explain" in str(finding) for finding in found.findings)


def test_points_that_the_readings_do_not_tell_have_no_interval() -> None:
    """The spring's upper end to one side is all other points to the other."""
    rig = jn.load(FRONT)
    table = {
        "wheel_travel": TRAVEL,
        "spring_length": jn.sweep_travel(rig, TRAVEL)["spring_length"].to_numpy(),
    }
    others = [
        f"hardpoints.{name}[1]"
        for name in rig.hardpoints.given()
        if name not in ("strut_top", "wheel_centre")
    ]
    free = [
        {"point": "hardpoints.strut_top[1]", "within": "5 mm"},
        {"point": "hardpoints.wheel_centre[1]", "tied": others, "within": "5 mm"},
    ]
    found = jn.fit_hardpoints(FRONT, table, free, noise={"spring_length": "0.1 mm"}, starts=1)
    assert [one.interval for one in found.numbers.values()] == [None, None]
    assert any(finding.code == "design.undetermined" for finding in found.findings)


@pytest.mark.parametrize(
    ("table", "options", "words"),
    [
        ({"toe": [0.0, 0.0]}, {}, "no poses"),
        ({"wheel_travel": [0.0, 0.01, 0.02]}, {}, "nothing was measured"),
        ({"wheel_travel": [0.0, 0.01, 0.02], "tow": [0.0, 0.0, 0.0]}, {}, "'toe'"),
        ({"wheel_travel": [0.0, 0.01, 0.02], "toe": [0.0, 0.0]}, {}, "one reading per pose"),
        ({"wheel_travel": [0.0, 0.01, 0.5], "toe": [0.0, 0.0, 0.0]}, {}, "does not reach"),
        ({"wheel_travel": [0.0, 10.0, 20.0], "toe": [0.0, 0.0, 0.0]}, {}, "metres"),
        (
            {"wheel_travel": [0.0, 0.01, 0.02], "toe": [0.0, 0.0, 0.0]},
            {"offsets": ["camber"]},
            "camber",
        ),
        (
            {"wheel_travel": [0.0, 0.01, 0.02], "toe": [0.0, 0.0, 0.0]},
            {"noise": {"toe": "1 mm"}},
            "mm",
        ),
        ({"wheel_travel": [0.0], "toe": [0.0]}, {}, "fewer readings"),
        (
            {"wheel_travel": [0.0, 0.01, 0.02], "damper_length": [0.2, 0.2, 0.2]},
            {"starts": 0},
            "1 or more",
        ),
    ],
)
def test_what_cannot_be_fitted(table: dict, options: dict, words: str) -> None:
    with pytest.raises(jn.JounceError, match=words):
        jn.fit_hardpoints(FRONT, table, {"hardpoints.tie_rod_inner[2]": "10 mm"}, **options)


def test_a_number_that_changes_nothing_measured_is_refused() -> None:
    table = {"wheel_travel": [0.0, 0.01, 0.02], "toe": [0.0, 0.0, 0.0]}
    with pytest.raises(jn.DescriptionError, match="no effect on any measured"):
        jn.fit_hardpoints(FRONT, table, {"hardpoints.strut_top[1]": "10 mm"})


def test_readings_with_units_count_as_those_in_si(truth) -> None:
    import xarray as xr

    table = readings(truth[1], 7)
    units = {"wheel_travel": ("mm", 1e3), "rack_travel": ("mm", 1e3), "toe": ("deg", 180.0 / np.pi)}
    free = dict.fromkeys(MOVED, "15 mm")
    plain = jn.fit_hardpoints(FRONT, table, free, offsets=["camber"], starts=1)
    for name, (unit, factor) in units.items():
        table[name] = xr.DataArray(factor * table[name], dims="pose", attrs={"units": unit})
    found = jn.fit_hardpoints(FRONT, table, free, offsets=["camber"], starts=1)
    for path in MOVED:
        assert found.numbers[path].value == pytest.approx(plain.numbers[path].value, rel=1e-6)
