"""A package that is missing is named with a command that brings it, wherever jounce came from."""

from __future__ import annotations

import importlib
import json
import sys
from importlib import metadata
from pathlib import Path

import pytest

from jounce.core.optional import MissingPackageError, hide_from_others, how_to_install, require

NEEDED = ["numpy>=1.26", "typst>=0.13; extra == 'pdf'", "sqlalchemy>=2.0; extra == 'store'",
          "psycopg[binary]>=3.2; extra == 'postgresql'", "sqlalchemy>=2.0; extra == \"postgresql\""]  # fmt: skip


def installed(monkeypatch: pytest.MonkeyPatch, source: dict[str, object] | None) -> None:
    class Installed:
        requires = NEEDED

        def read_text(self, name: str) -> str | None:
            assert name == "direct_url.json"
            return None if source is None else json.dumps(source)

    monkeypatch.setattr(metadata, "distribution", lambda name: {"jounce": Installed()}[name])


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    made = tmp_path / "my tools" / "jounce"
    made.mkdir(parents=True)
    (made / "pyproject.toml").touch()
    return made


def test_from_a_folder_it_is_that_folder(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    installed(monkeypatch, {"url": folder.as_uri(), "dir_info": {}})
    assert how_to_install("pdf") == f"pip install '{folder}[pdf]'"
    installed(monkeypatch, {"url": folder.as_uri(), "dir_info": {"editable": True}})
    assert how_to_install("pdf") == f"pip install -e '{folder}[pdf]'"


@pytest.mark.parametrize(
    "source",
    [
        None,
        {"url": "file:///gone/jounce", "dir_info": {}},
        {"url": "file:///at/jounce-0.1.0-py3-none-any.whl", "archive_info": {}},
        {"url": "https://example.org/jounce.git", "vcs_info": {"vcs": "git"}},
    ],
)
def test_from_anywhere_else_it_is_what_the_extra_needs(
    monkeypatch: pytest.MonkeyPatch, source: dict[str, object] | None
) -> None:
    installed(monkeypatch, source)
    assert how_to_install("pdf") == "pip install 'typst>=0.13'"
    assert how_to_install("postgresql") == "pip install 'psycopg[binary]>=3.2' 'sqlalchemy>=2.0'"


def test_of_sources_that_are_not_installed_it_is_the_folder_one_stands_in(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def nothing(name: str) -> None:
        raise metadata.PackageNotFoundError(name)

    monkeypatch.setattr(metadata, "distribution", nothing)
    assert how_to_install("pdf") == "pip install '.[pdf]'"


def test_the_error_says_it(monkeypatch: pytest.MonkeyPatch) -> None:
    installed(monkeypatch, None)
    monkeypatch.setitem(sys.modules, "typst", None)
    with pytest.raises(
        MissingPackageError,
        match=r"'typst' is not installed\. Install the package with: pip install 'typst>=0.13'",
    ):
        require("typst", "pdf")


def test_a_hidden_package_is_missing_for_others_and_is_there_on_request(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.delitem(sys.modules, "wave", raising=False)
    hide_from_others("wave", "json")
    with pytest.raises(ModuleNotFoundError):
        importlib.import_module("wave")
    assert require("wave", "io").__name__ == "wave"
    assert importlib.import_module("json").dumps([1]) == "[1]"  # what is in use stays
