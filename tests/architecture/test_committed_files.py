"""Committed files: no registry addresses, no machine paths, complete pins, a bibliography that can be read."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from rules import CONFIGURATION, ROOT
from rules.addresses import address_problems, committed_files


@pytest.mark.skipif(not (ROOT / ".git").exists(), reason="not under version control")
def test_no_addresses_of_registries_or_machines() -> None:
    foreign = ROOT / "tests" / "files"  # copied unchanged from their sources
    files = [file for file in committed_files(ROOT) if not file.is_relative_to(foreign)]
    assert ROOT / "pyproject.toml" in files
    assert [problem for file in files for problem in address_problems(file)] == []


@pytest.mark.parametrize(
    "parts",
    [
        ("--index", "-url http://mirror/simple"),
        ("https://py", "pi.org/simple/jounce"),
        ("https://files.python", "hosted.org/packages/x.whl"),
        ('"resolved": "https://registry.', 'npmjs.org/three"'),
        ("/ho", "me/anna/jounce/rig.toml"),
        ("path = '/wo", "rk/main'"),
        ("/ro", "ot/.cache"),
    ],
)
def test_addresses_are_noticed(tmp_path: Path, parts: tuple[str, str]) -> None:
    file = tmp_path / "file.txt"
    file.write_text("fine\n" + "".join(parts) + "\n", encoding="utf-8")
    assert len(address_problems(file)) == 1
    assert f"{file}:2" in address_problems(file)[0]


def test_harmless_text_is_left_alone(tmp_path: Path) -> None:
    file = tmp_path / "file.txt"
    file.write_text(
        "of work/time, N/m, ~/.cache/jounce, /usr/bin/env, https://doi.org/10.5281/zenodo.4445334\n"
    )
    assert address_problems(file) == []


@pytest.mark.parametrize(
    "file", sorted((ROOT / "requirements").glob("*.txt")), ids=lambda file: file.stem
)
def test_pins_are_exact_and_hashed(file: Path) -> None:
    blocks = re.split(
        r"\n(?=[A-Za-z])",
        re.sub(r"^\s*#.*\n", "", file.read_text(encoding="utf-8"), flags=re.MULTILINE),
    )
    assert blocks
    for block in blocks:
        assert re.match(r"[A-Za-z0-9_.-]+==\S+ ", block), block[:60]
        assert "--hash=sha256:" in block


def test_direct_dependencies_are_pinned() -> None:
    groups = {
        "runtime": CONFIGURATION["project"]["dependencies"],
        **CONFIGURATION["dependency-groups"],
    }
    for group, wanted in groups.items():
        pinned = (ROOT / "requirements" / f"{group}.txt").read_text(encoding="utf-8").lower()
        for requirement in wanted:
            name = re.split(r"[<>=!~ ]", requirement)[0].lower().replace("_", "-")
            assert re.search(rf"^{re.escape(name)}==", pinned, re.MULTILINE), (
                f"{group}: {name} (run `make pins`)"
            )


def test_bibliography_has_unique_complete_entries() -> None:
    text = (ROOT / "references.bib").read_text(encoding="utf-8")
    entries = re.findall(r"^@\w+\{([\w-]+),\n(.*?)^\}", text, re.MULTILINE | re.DOTALL)
    keys = [key for key, _ in entries]
    assert len(keys) == len(set(keys)) == text.count("\n@") + text.startswith("@")
    for key, body in entries:
        assert re.search(r"^  title +=", body, re.MULTILINE), key
