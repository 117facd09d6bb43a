"""The page on validation says what tests find: every test with an outside source is on it, and what it keeps holds."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import numpy as np
import pytest

from rules import ROOT
from rules.evidence import CAPABILITIES, KINDS, Seen, held, kept

ROW = {
    "kind": "published",
    "of": "half car",
    "key": "a",
    "where": "Table 2",
    "tolerance": "digits",
    "compares": "modes",
}


def test_every_test_with_a_source_is_on_the_page(
    collected: set[str] | None,
    sources: dict[str, dict[str, str] | None],
    request: pytest.FixtureRequest,
) -> None:
    if collected is None:
        pytest.skip("only a run of all tests collects all of them")
    assert {name for name, row in sources.items() if row} == set(kept())


def test_what_is_kept_is_still_written() -> None:
    """Without a run: tests that the page names exist, their sources are in the bibliography."""
    keys = set(
        re.findall(
            r"^@\w+\{([\w-]+),", (ROOT / "references.bib").read_text(encoding="utf-8"), re.MULTILINE
        )
    )
    rows = kept()
    assert len(rows) > 80
    for name, row in rows.items():
        file, _, test = name.partition("::")
        tree = ast.parse((ROOT / file).read_text(encoding="utf-8"))
        assert test in {one.name for one in tree.body if isinstance(one, ast.FunctionDef)}, name
        assert row["kind"] in KINDS
        assert row["of"] in CAPABILITIES
        assert row["key"] in keys or (row["kind"] == "computed" and not row["key"]), name
        assert 0.0 <= row["share"] <= 1.0001, name
        assert row["values"] >= row["least"] > 0


@pytest.mark.parametrize(
    "file", [*(ROOT / "tests").glob("reference/*.py"), *(ROOT / "tests").glob("measured/*.py")]
)
def test_files_of_references_name_their_source(file: Path) -> None:
    assert "\npytestmark = pytest.mark.source(\n" in file.read_text(encoding="utf-8")


def test_comparisons_are_seen() -> None:
    seen = Seen()
    with seen.watching():
        assert pytest.approx(2.0, abs=0.1) == 2.05
        assert np.array([1.0, 2.0]) == pytest.approx(np.array([1.0, 2.0]), rel=1e-3)
        assert {"a": pytest.approx(1.0)} == {"a": 1.0}
        assert pytest.approx((1.0, 3.0)) == (1.0, 3.0)
        assert pytest.approx(8.0) != 7.0  # what fails, or chooses, is no evidence
        np.testing.assert_allclose([1.0, 1.01], [1.0, 1.0], rtol=0.0, atol=0.02)
    assert seen.count == 8
    assert (seen.worst["ours"], seen.worst["theirs"]) in {(2.05, 2.0), (1.01, 1.0)}
    assert seen.worst["share"] == pytest.approx(0.5)
    assert seen.room == pytest.approx(0.1)


def seen(share: float, count: int = 2, room: float = 0.1) -> Seen:
    found = Seen()
    found.count, found.room = count, room
    found.worst |= {"ours": share * room, "share": share}
    return found


def test_what_agrees_worse_than_the_page_is_rejected() -> None:
    row = {**ROW, "share": 0.4, "least": 2, "room": 0.1}
    assert (
        held(row, ROW, seen(0.4)) == held(row, ROW, seen(0.49)) == held(row, ROW, seen(0.1)) == ""
    )
    assert "is not on the page" in held(None, ROW, seen(0.4))
    assert held(row, ROW, seen(0.51)) == "takes 0.51 of what is allowed, the page says 0.4"
    assert held(row, {**ROW, "where": "Table 3"}, seen(0.4)) == "says another where than the page"
    assert held({**row, "share": 1e-9}, ROW, seen(1e-3)) == ""  # rounding is that of the machine
    assert (
        held({**row, "share": 1e-9, "room": 1e-14}, ROW, seen(0.3, room=1e-14)) == ""
    )  # of a number of about 1
    assert "takes 0.5" in held({**row, "share": 1e-9, "room": 1e-14}, ROW, seen(0.5, room=1e-14))


def test_what_compares_less_or_allows_more_than_the_page_is_rejected() -> None:
    row = {**ROW, "share": 0.4, "least": 2, "room": 0.1}
    assert held(row, ROW, seen(0.4, count=3)) == held(row, ROW, seen(0.4, room=0.05)) == ""
    assert (
        held(row, ROW, seen(0.4, count=1)) == "compares fewer numbers than the page says, 1 for 2"
    )
    assert held(row, ROW, seen(0.04, room=1.0)) == "allows 1, the page says 0.1"
