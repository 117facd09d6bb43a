"""German of the pages: no text has two translations, which a JSON reader would not notice."""

from __future__ import annotations

import json
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
