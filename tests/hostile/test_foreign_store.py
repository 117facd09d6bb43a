"""Stores of others: what they name records never leaves the folder in which a record is read."""

from __future__ import annotations

from pathlib import Path

import pytest

from jounce.core.errors import JounceError
from jounce.inspection.archive import lane
from jounce.inspection.archive.entries import RecordEntry
from jounce.parts.testers import load_tester

NAMES = [
    "",
    ".",
    "..",
    "../../evil.csv",
    "/etc/evil.csv",
    "a\0b.csv",
    "x" * 300 + ".csv",
    "..\\evil.csv",
    "-rf.csv",
]


@pytest.mark.parametrize("name", NAMES)
def test_names_of_records_stay_within_the_folder_they_are_read_in(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    inner = tmp_path / "a" / "b"
    inner.mkdir(parents=True)
    seen: list[Path] = []

    class Here:
        def __enter__(self) -> Path:
            return inner

        def __exit__(self, *_: object) -> None:
            seen.extend(tmp_path.rglob("*"))

    monkeypatch.setattr(lane, "working_folder", Here)
    entry = RecordEntry(name, b"time [s], left.plate.z [mm]\n0, 1\n", b"plate_number = 'B 1'\n")
    with pytest.raises(JounceError):
        lane.read_entry(entry, load_tester("eusama"))
    assert {file.parent for file in seen if file.is_file()} == {inner}
