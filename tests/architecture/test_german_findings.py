"""The workbench says in German what the library finds: every message that its sources can make has a translation."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

import jounce.inspection.methods  # noqa: F401 - adds the sentences of its methods
from jounce.core.units import Unit
from jounce.inspection.findings import SENTENCES
from rules import ROOT
from rules.finding_templates import german_of, templates_of

CATALOGUE: dict[str, dict[str, str]] = json.loads(
    (ROOT / "viewer" / "src" / "workbench" / "findings.json").read_text(encoding="utf-8")
)
SOURCES = {
    "rigs": [ROOT / "src" / "jounce" / "parts" / "advice.py"],
    "recordings": sorted((ROOT / "src" / "jounce" / "recordings").glob("*.py")),
}


def _fits(template: str, message: str) -> bool:
    """Whether a message, or another template, is what a template can become."""
    return re.fullmatch(".+?".join(map(re.escape, template.split("#"))), message, re.DOTALL) is not None


@pytest.mark.parametrize("of", SOURCES)
def test_every_finding_has_its_german_and_no_german_is_left_over(of: str) -> None:
    said = {template for file in SOURCES[of] for template in templates_of(file)}
    assert len(said) > 20  # the sources were read
    known = CATALOGUE[of]
    assert [one for one in sorted(said) if not any(_fits(one, english) for english in known)] == []
    own = Unit("N/m").question(22.73)
    assert [one for one in known if not any(_fits(template, one) for template in said) and not _fits(one, own)] == []


@pytest.mark.parametrize("of", [*SOURCES, "words"])
def test_both_languages_are_filled_with_as_much(of: str) -> None:
    assert [one for one, german in CATALOGUE[of].items() if one.count("#") != german.count("#")] == []


def test_what_an_inspection_finds_is_said_as_in_its_protocol() -> None:
    """Written anew where this fails: the left side of the comparison, as the catalogue's part `inspection`."""
    said = [german_of(one.en, one.de) for one in SENTENCES.values()]
    assert dict(one for one in said if one) == CATALOGUE["inspection"]


def test_a_message_is_read_from_its_source(tmp_path: Path) -> None:
    file = tmp_path / "finds.py"
    file.write_text(
        "def looks(x, other):\n"
        "    text = f'it is {x:g} m'\n"
        "    yield Finding('a', 'note', text + (f' at {x}' if x else '; why?'))\n"
        '    text = f\'{"low" if x else "high"} by {x} %\'\n'
        "    yield _warn('b', text, x)\n"
        "    yield Finding('c', 'note', other)\n"
    )
    assert templates_of(file) == {"it is # m at #", "it is # m; why?", "low by # %", "high by # %"}
    assert german_of("the {name} is longer by {value:.3g} mm", "um {value:.3g} mm länger: {name}") == (
        "the # is longer by # mm",
        "um #2 mm länger: #1",
    )
