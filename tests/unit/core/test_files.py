"""Files that a user names: a path before a shipped file, a folder is none, and every refusal says what to do."""

from __future__ import annotations

from pathlib import Path

import pytest

from jounce.core.errors import DescriptionError, RecordingError
from jounce.core.files import existing_file, find_file, shipped_files

SHIPPED = {"soft": Path("library/soft.toml"), "stiff": Path("library/stiff.toml")}


def test_a_file_of_the_users_own_comes_before_a_shipped_one(tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "stiff").write_text("own")
    (tmp_path / "soft").mkdir()
    assert find_file("stiff", SHIPPED, "rig") == Path("stiff")
    assert find_file("soft", SHIPPED, "rig") == SHIPPED["soft"]  # a folder is no rig
    assert find_file("none.toml", SHIPPED, "rig") == Path(
        "none.toml"
    )  # the reader says that it is missing


def test_an_unknown_name_is_refused_with_the_nearest_one() -> None:
    says = (
        r"sof: no such file, and no rig of that name in the library; "
        r"allowed: a path to a .toml file, or one of soft, stiff"
    )
    with pytest.raises(DescriptionError, match=rf"{says}\. Did you mean 'soft'\?"):
        find_file("sof", SHIPPED, "rig")


def test_missing_files_and_folders_are_told_apart(tmp_path) -> None:
    with pytest.raises(
        RecordingError, match=r"none\.csv: no such file\. Check the path and the name\."
    ):
        existing_file(tmp_path / "none.csv", RecordingError)
    with pytest.raises(DescriptionError, match="a folder, not a file"):
        existing_file(tmp_path)


def test_shipped_files_are_known_by_their_names() -> None:
    assert {"eusama", "boge"} <= set(shipped_files("jounce.parts", "library/testers"))
    assert shipped_files("jounce.parts", "library", ".csv") == {}
