"""A stored protocol opens again as it was graded; what would be another grading is refused."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import jounce as jn
from jounce.core.errors import DescriptionError, RecordingError
from jounce.inspection.archive.store import Store
from jounce.testers.testing import write_test


@pytest.fixture(scope="module")
def lane(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("lane")
    _, record = jn.simulate_axle(jn.load("audi-a6-full-car"), "egea-specsus2018")
    write_test(record, folder / "front.csv")
    jn.evaluate_inspection(
        [folder / "front.csv"],
        "egea-specsus2018",
        store=folder / "lane.sqlite",
        plate="B-AB 123",
        date="2026-11-21",
        reports=[folder / "first.html"],
    )
    (folder / "front.csv").unlink()  # the store has it
    return folder


def test_a_stored_protocol_has_the_values_of_the_first(lane: Path, tmp_path: Path) -> None:
    again = jn.open_inspection([1], lane / "lane.sqlite", reports=[tmp_path / "again.html"])
    assert again.numbers == (1,)
    first, second = (
        json.loads(file.read_text()) for file in (lane / "first.json", tmp_path / "again.json")
    )
    assert second["axles"] == first["axles"]
    assert "B-AB 123" in (tmp_path / "again.html").read_text()


def test_what_is_no_record_or_was_graded_otherwise_is_refused(lane: Path) -> None:
    store = lane / "lane.sqlite"
    with pytest.raises(DescriptionError, match="not the number of a record"):
        jn.open_inspection(["first"], store)
    with pytest.raises(DescriptionError, match="too many records"):
        jn.open_inspection([1, 2, 3], store)
    with pytest.raises(RecordingError, match="no such record"):
        jn.open_inspection([7], store)
    opened = Store(store)
    newest = opened.newest_grading(1)
    assert newest is not None
    from dataclasses import replace

    opened.add_gradings([(1, replace(newest, limits="limits of another year"))])
    opened.close()
    with pytest.raises(RecordingError, match="the stored grading differs"):
        jn.open_inspection([1], store)
