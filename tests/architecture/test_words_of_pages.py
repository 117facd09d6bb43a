"""German of the pages: each text has a translation, and none has two, which a JSON reader would not notice."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

WORDS = Path(__file__).parents[2] / "viewer" / "src" / "workbench"


def keys_given_twice(text: str) -> list[str]:
    twice: list[str] = []

    def look(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        names = [name for name, _ in pairs]
        twice.extend(name for k, name in enumerate(names) if name in names[:k])
        return dict(pairs)

    json.loads(text, object_pairs_hook=look)
    return twice


@pytest.mark.parametrize("file", ["german.json", "terms.json"])
def test_no_text_is_translated_twice(file: str) -> None:
    assert keys_given_twice((WORDS / file).read_text(encoding="utf-8")) == []


def test_the_check_notices_a_key_given_twice() -> None:
    assert keys_given_twice('{"a": 1, "b": {"c": 1, "c": 2}, "a": 3}') == ["c", "a"]


LITERAL = re.compile(r'\btr\(\s*"((?:[^"\\]|\\.)*)"')


def texts_without_german(code: str, german: dict[str, str]) -> list[str]:
    return [
        text
        for text in map(json.loads, (f'"{t}"' for t in LITERAL.findall(code)))
        if text not in german
    ]


@pytest.mark.parametrize("file", sorted(WORDS.rglob("*.ts")), ids=lambda file: file.name)
def test_each_text_of_a_page_has_german(file: Path) -> None:
    german = json.loads((WORDS / "german.json").read_text(encoding="utf-8"))
    assert texts_without_german(file.read_text(encoding="utf-8"), german) == []


def test_the_check_notices_a_text_without_german() -> None:
    assert texts_without_german('a(tr("x"), tr(\n  "y #", z))', {"x": "X"}) == ["y #"]
