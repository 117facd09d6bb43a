"""German of messages: each row translates a text of the sources, and fills in what the English does."""

from __future__ import annotations

import ast
import inspect
import string
import tomllib
from tomllib import _parser
from typing import Any

import pytest

from jounce.core.errors import DescriptionError, unknown
from jounce.core.phrases import Phrase, german_of
from rules import ROOT

LIBRARY = ROOT / "src" / "jounce"
ROWS = {
    (file.parent.name, english): german
    for file in sorted(LIBRARY.glob("*/phrases.toml"))
    for english, german in tomllib.loads(file.read_text(encoding="utf-8")).items()
}


def literals(source: str) -> set[str]:
    return {
        node.value
        for node in ast.walk(ast.parse(source))
        if isinstance(node, ast.Constant) and isinstance(node.value, str)
    }


def fields_of(text: str) -> set[Any] | None:
    """Names and formats of the fields of a template; None where braces are something else."""
    try:
        fields = {
            (name, spec) for _, name, spec, _ in string.Formatter().parse(text) if name is not None
        }
    except ValueError:
        return None
    return fields if all(name.isidentifier() for name, _ in fields) else None


def test_every_row_translates_a_text_of_the_sources() -> None:
    """A sentence that was changed in the code alone would be English again, and nobody would notice."""
    known = {
        text
        for file in LIBRARY.rglob("*.py")
        for text in literals(file.read_text(encoding="utf-8"))
    }
    known |= literals(inspect.getsource(_parser))  # of Python's TOML
    assert sorted(english for _, english in ROWS if english not in known) == []


def test_no_row_stands_twice() -> None:
    texts = [english for _, english in ROWS]
    assert len(texts) > 200
    assert len(texts) == len(set(texts))


@pytest.mark.parametrize("english", sorted(english for _, english in ROWS if "{" in english))
def test_german_fills_in_what_the_english_does(english: str) -> None:
    german = next(german for (_, text), german in ROWS.items() if text == english)
    assert fields_of(english) == fields_of(german)


def test_an_error_is_german_part_by_part() -> None:
    error = unknown("bumb", ["bump"], what="road", where="trial.toml")
    assert str(error) == "trial.toml: unknown road 'bumb'; allowed: bump. Did you mean 'bump'?"
    assert (
        german_of(error.message())
        == "trial.toml: Straße 'bumb' ist nicht bekannt; zulässig: bump. Ist 'bump' gemeint?"
    )
    found = DescriptionError(
        "out of range", where="road", found="road", allowed=Phrase("above {bound:g}", bound=0.5)
    )
    assert (
        german_of(found.message())
        == "road: außerhalb des Bereichs; gefunden 'road'; zulässig: über 0.5."
    )


def test_what_has_no_german_says_so() -> None:
    error = DescriptionError("a sentence that nobody translated", where="out of range")
    assert error.message().german() is None
