from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.kinematics.sweeps import grid, sweep_values


@pytest.mark.parametrize(
    ("travel", "rack"),
    [
        (np.linspace(-0.04, 0.04, 5), np.array([0.0])),
        (np.array([0.02, 0.03]), np.array([-0.02, 0.01])),
        (np.array([-0.03, -0.02]), np.linspace(-0.01, 0.03, 5)),
        (np.array([0.0]), np.array([0.0])),
    ],
)
def test_every_pair_is_visited_once_after_its_neighbour(
    travel: np.ndarray, rack: np.ndarray
) -> None:
    layout = grid(travel, rack)
    assert sorted(layout.place) == list(range(len(travel) * len(rack)))
    wanted = np.array([(z, y) for z in travel for y in rack])
    assert np.array_equal(layout.targets, wanted[layout.place])
    rows, columns = np.divmod(layout.place, len(rack))
    for i, parent in enumerate(layout.before):
        assert parent < i
        if parent >= 0:  # one step along one of the two
            assert abs(rows[i] - rows[parent]) + abs(columns[i] - columns[parent]) == 1
    assert np.sum(layout.before == -1) == 1


def test_the_walk_starts_nearest_to_design() -> None:
    layout = grid(np.array([-0.03, 0.01, 0.05]), np.array([-0.02, 0.004]))
    assert tuple(layout.targets[0]) == (0.01, 0.004)


@pytest.mark.parametrize(
    ("values", "text"),
    [
        ([], "not a list of values"),
        ([[0.0, 1.0]], "invalid physical value"),
        (np.zeros((1, 2)), "not a list of values"),
        ([0.0, np.nan], "not a finite number"),
        ([0.0, np.inf], "not a finite number"),
        ([0.0, 0.02, 0.01], "are not monotonic"),
        ([0.0, 0.0], "are not monotonic"),
        ([0.02, 0.0, 0.01], "are not monotonic"),
        ([0.02, 0.0, 0.0], "are not monotonic"),
        (["x"], "not a number with a unit"),
    ],
)
def test_bad_values_are_refused(values: object, text: str) -> None:
    with pytest.raises(DescriptionError, match=text) as caught:
        sweep_values(values, "wheel travel")  # type: ignore[arg-type]
    assert "wheel travel" in str(caught.value)


def test_one_number_is_one_value() -> None:
    assert np.array_equal(sweep_values(0.02, "wheel travel"), [0.02])


def test_too_many_pairs_are_refused() -> None:
    with pytest.raises(DescriptionError, match="too many"):
        grid(np.linspace(-0.1, 0.1, 2000), np.linspace(-0.1, 0.1, 2000))


def test_text_is_read_as_a_range() -> None:
    found = sweep_values("-80 mm:80 mm:4 mm", "wheel travel")
    assert found == pytest.approx(np.linspace(-0.08, 0.08, 41), abs=1e-15)
    assert found[20] == 0.0
    assert np.array_equal(sweep_values("20 mm", "wheel travel"), [0.02])
    assert np.array_equal(
        sweep_values("-0.01:0.015:0.01", "wheel travel"), [-0.01, 0.0, 0.01]
    )  # 15 mm is not met
    assert sweep_values("-2 deg:2 deg:2 deg", "roll", "rad") == pytest.approx(
        np.radians([-2.0, 0.0, 2.0]), abs=1e-12
    )
    assert np.array_equal(sweep_values("80 mm:-80 mm:-4 mm", "wheel travel"), found[::-1])
    with pytest.raises(DescriptionError, match="does not lead"):
        sweep_values("80 mm:-80 mm:4 mm", "wheel travel")


def test_a_path_has_the_poses_of_the_grid_pair_by_pose_in_any_order() -> None:
    rig = jn.load("formula-student-front")
    travel, rack = np.array([0.01, -0.01, 0.0, 0.02]), np.array([0.005, -0.02, 0.0, 0.02])
    path = jn.sweep_path(rig, travel, rack, points=True)
    crossed = jn.sweep_travel(rig, np.sort(travel), np.sort(rack), points=True)
    for k in range(4):
        own = crossed.sel(wheel_travel=travel[k], rack_travel=rack[k], method="nearest")
        for name in ("camber", "steer", "caster_trail", "tie_rod_outer.x"):
            assert float(path[name][k]) == pytest.approx(float(own[name]), abs=1e-10)
    assert path["wheel_travel"].to_numpy() == pytest.approx(travel)
    one = jn.sweep_path(rig, travel, 0.0)
    assert np.all(one["rack_travel"] == 0.0)


def test_pairs_behind_one_out_of_reach_are_found() -> None:
    path = jn.sweep_path(jn.load("reference-double-wishbone"), [0.0, -0.3, 0.01], [0.0, 0.0, 0.0])
    assert np.isfinite(path["camber"].to_numpy()).tolist() == [True, False, True]
    assert path.attrs["status"] == "end_of_travel"


def test_paths_of_different_lengths_are_refused() -> None:
    with pytest.raises(
        jn.DescriptionError, match="rack travel and wheel travel have different lengths"
    ):
        jn.sweep_path(jn.load("formula-student-front"), [0.0, 0.01], [0.0, 0.01, 0.02])
