"""The page on records that are wrong: what a file can tell is told, for every command."""

from __future__ import annotations

import json

import make_records
import pytest


def test_nothing_in_the_counts_of_the_page_is_silently_wrong():
    kept = json.loads(make_records.FILE.read_text(encoding="utf-8"))
    assert list(kept) == list(make_records.COMMANDS)
    for command, found in kept.items():
        counts = found["counts"]
        assert (counts["silent"], counts["false alarm"], found["names"]) == (0, 0, []), command
        assert counts["right"] > 0.3 * sum(counts.values())


@pytest.mark.slow
@pytest.mark.parametrize("command", make_records.COMMANDS)
def test_the_counts_of_the_page_are_true(command):
    kept = json.loads(make_records.FILE.read_text(encoding="utf-8"))[command]
    assert json.loads(json.dumps(make_records.counted(make_records.COMMANDS[command]()))) == kept
