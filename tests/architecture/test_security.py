"""Supply and trust: what `SECURITY.md` promises has a test, pins are installed with hashes, the audit notices."""

from __future__ import annotations

import ast
import importlib.util
import re
import sys
from pathlib import Path
from types import ModuleType

import pytest

from rules import ROOT

_NAMED = re.compile(r"`(tests/[\w/]+\.py)::(\w+)`")


def names_in(file: Path) -> set[str]:
    if not file.is_file():
        return set()
    tree = ast.parse(file.read_text(encoding="utf-8"))
    return {
        node.name
        for node in ast.walk(tree)
        if isinstance(node, ast.FunctionDef) and node.name.startswith("test_")
    }


def without_test(text: str, root: Path = ROOT) -> list[str]:
    """Named tests that do not exist, and items of a list that name none."""
    missing = [
        f"{file}::{name}"
        for file, name in _NAMED.findall(text)
        if name not in names_in(root / file)
    ]
    items = re.split(r"^(?=- |#)", text, flags=re.MULTILINE)
    return missing + [
        item.strip() for item in items if item.startswith("- ") and not _NAMED.search(item)
    ]


def test_each_promise_names_tests_that_exist() -> None:
    text = (ROOT / "SECURITY.md").read_text(encoding="utf-8")
    assert len(_NAMED.findall(text)) > 20
    own = "- Your own Python code: jounce calls the functions that you pass to it."
    assert without_test(text) == [own]  # a warning, and no promise


def test_promises_without_a_test_are_noticed() -> None:
    bad = "- **Files.** They are safe.\n- Sound (`tests/architecture/test_security.py::test_of_nothing`).\n"
    assert without_test(bad) == [
        "tests/architecture/test_security.py::test_of_nothing",
        "- **Files.** They are safe.",
    ]


def installations(makefile: str) -> list[str]:
    """Words after each ``pip install`` of a Makefile."""
    whole = makefile.replace("\\\n", " ")
    return [
        line.split("pip install", 1)[1]
        for line in whole.splitlines()
        if re.search(r"\bpip install\b", line)
    ]


def loose(makefile: str) -> list[str]:
    """Installations that could fetch what has no hash, or build what is fetched."""
    pinned = ("--require-hashes", "--no-deps", "--only-binary :all:")
    own = ("--no-deps", "--no-build-isolation", "--editable .")
    return [
        one
        for one in installations(makefile)
        if not any(all(word in one for word in all_) for all_ in (pinned, own))
    ]


def test_only_wheels_with_hashes_are_installed() -> None:
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    assert len(installations(makefile)) == 2
    assert loose(makefile) == []
    assert loose(
        "\tpip install -r x.txt\n\tpip install --require-hashes --no-deps \\\n  --only-binary :all: -r y.txt\n"
    ) == [" -r x.txt"]


@pytest.fixture(scope="module")
def audit() -> ModuleType:
    spec = importlib.util.spec_from_file_location("audit", ROOT / "requirements" / "audit.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["audit"] = module
    spec.loader.exec_module(module)
    return module


ADVISORY = (
    '[[advisory]]\npackage = "left"\nid = "X-1"\nmended_in = "1.10.0"\nwhat = "it runs files"\n'
)


def folder_with(folder: Path, version: str) -> Path:
    (folder / "advisories.toml").write_text(f"as_of = 2026-11-22\n{ADVISORY}", encoding="utf-8")
    (folder / "runtime.txt").write_text(
        f"left=={version} \\\n    --hash=sha256:0\nright==1.0\n", encoding="utf-8"
    )
    return folder


def test_a_closed_network_is_said_and_no_failure(
    audit: ModuleType, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert audit.main("/no/such/python", folder_with(tmp_path, "1.10")) == 0
    said = capsys.readouterr().out
    assert (
        "OFFLINE: no service could be asked; 2 pins were held against a list of 1 advisories of 2026-11-22"
        in said
    )
    assert audit.main(sys.executable, tmp_path) == 0  # there is no pip-audit
    assert "OFFLINE" in capsys.readouterr().out


def test_a_listed_version_is_noticed(
    audit: ModuleType, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert audit.main(None, folder_with(tmp_path, "1.9.9")) == 1
    assert "vulnerable: left 1.9.9: X-1, it runs files; mended in 1.10.0" in capsys.readouterr().out


def test_skipped_packages_are_not_known_ones(audit: ModuleType) -> None:
    skipped = {"name": "left", "skip_reason": "not found"}
    sound: dict[str, object] = {"name": "right", "version": "1", "vulns": []}
    bad = {"name": "down", "version": "2", "vulns": [{"id": "Y-1", "fix_versions": ["3"]}]}
    assert audit.answered({"dependencies": [skipped]}) == audit.Answer((), 0, 1)
    assert audit.answered({"dependencies": [sound, bad]}) == audit.Answer(
        ("down 2: Y-1; mended in 3",), 2, 0
    )


@pytest.mark.parametrize(
    ("one", "two", "before"),
    [("1.9", "1.10", True), ("1.10", "1.10.0", False), ("2", "1.9", False)],
)
def test_versions_are_compared_by_their_numbers(
    audit: ModuleType, one: str, two: str, before: bool
) -> None:
    assert audit.is_before(one, two) == before
