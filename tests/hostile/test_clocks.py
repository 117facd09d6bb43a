"""Clocks that stand still, run backwards or are centuries off: what changed is seen, and nothing stops."""

from __future__ import annotations

import os
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest

from jounce.inspection.archive.store import Store
from jounce.inspection.archive.watching import FolderWatch
from jounce.roads import load_road
from jounce.roads.trial import Excitation

DATES = {"1901": -(2**31), "1970": 0, "2286": 10_000_000_000, "2446": 15_032_385_535}
ROWS = "".join(f"{k / 100},{{}}\n" for k in range(40))


def table(head: str, height: float) -> str:
    return head + ROWS.replace("{}", f"{height:.3f}")


@pytest.mark.parametrize("date", DATES)
def test_a_watch_goes_on_whatever_date_a_file_has(tmp_path: Path, date: str) -> None:
    file = tmp_path / "a.csv"
    file.write_text("time [s], left.plate.z [mm]\n0, 1\n")
    os.utime(file, (DATES[date], DATES[date]))
    with closing(Store(tmp_path / "lane.sqlite")) as store:
        watch = FolderWatch(tmp_path, store, settle=0.0)
        assert [one.file.name for one in watch.look()] == ["a.csv"]
        assert watch.look() == []
    with closing(Store(tmp_path / "lane.sqlite")) as store:
        assert FolderWatch(tmp_path, store, settle=0.0).look() == []


def test_a_watch_sees_another_record_of_the_same_size_and_date(tmp_path: Path) -> None:
    """Testers whose clock has no battery write every record at the same time of 1970, under the same name."""
    file = tmp_path / "lane.csv"
    with closing(Store(tmp_path / "lane.sqlite")) as store:
        watch = FolderWatch(tmp_path, store, settle=0.0)
        for content in (
            "time [s], left.plate.z [mm]\n0, 1\n",
            "time [s], left.plate.z [mm]\n0, 2\n",
        ):
            file.write_text(content)
            os.utime(file, (100, 100))
            assert [one.file.name for one in watch.look()] == ["lane.csv"]
        assert watch.look() == []


def test_roads_and_excitations_of_the_same_size_and_date_are_read_again(tmp_path: Path) -> None:
    road, shaken = tmp_path / "road.csv", tmp_path / "base.csv"
    for height in (0.001, 0.002):
        road.write_text(table("x [m], z [m]\n", height))
        shaken.write_text(table("time [s], road.z [m]\n", height))
        for file in (road, shaken):
            os.utime(file, (100, 100))
        found = load_road(road).segments(0.3).evaluate(np.array([0.2]))[0]
        mapped = Excitation(file=shaken, columns={"road.z": "road.z [m]"})
        assert found == pytest.approx([height])
        assert [one.profile().before for one in (Excitation(file=shaken), mapped)] == pytest.approx(
            [height] * 2
        )
