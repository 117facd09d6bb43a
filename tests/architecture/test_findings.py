"""One catalogue of findings: what the sources find stands in it, what stands in it is found, in both languages."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from jounce.core.catalogue import catalogue_of, sentence
from jounce.core.findings import Finding, finding, finding_of
from rules import ROOT
from rules.finding_codes import codes_in, fields_of, made_in, texts_in

LIBRARY = ROOT / "src" / "jounce"
PACKAGES = {file.parent.name for file in LIBRARY.glob("*/findings.toml")}
ROWS = {
    name if package == "inspection" else f"{package}.{name}": row  # whose codes carry no package
    for package in PACKAGES
    for name, row in catalogue_of(package).rows.items()
}
SOURCES = [file for file in LIBRARY.rglob("*.py") if "finding(" in file.read_text(encoding="utf-8")]


def test_every_code_of_the_sources_stands_in_the_catalogue_and_the_reverse() -> None:
    used = {code for file in LIBRARY.rglob("*.py") for code in codes_in(file, PACKAGES)}
    used |= {code for file in (LIBRARY / "inspection").rglob("*.py") for code in texts_in(file)}
    assert sorted(ROWS.keys() - used) == []
    made = [made for file in SOURCES for made in made_in(file)]
    assert len(made) > 40
    assert [one for one in made if one.code is not None and one.code not in ROWS] == []


def test_every_call_fills_in_what_its_sentence_has() -> None:
    made = [
        made
        for file in SOURCES
        for made in made_in(file)
        if made.code is not None and made.names is not None
    ]
    assert [
        one for one in made if one.names and not fields_of(ROWS[one.code].en).keys() <= one.names
    ] == []


@pytest.mark.parametrize("code", sorted(ROWS))
def test_both_languages_are_filled_with_the_same(code: str) -> None:
    row = ROWS[code]
    assert fields_of(row.en) == fields_of(row.de)
    assert row.en != row.de or row.en == "{error}"


@given(st.sampled_from(sorted(ROWS)), st.data())
def test_every_row_can_be_said_with_whatever_is_found(code: str, data: st.DataObject) -> None:
    """Numbers of any size, none, and names; a file gives back the same sentences."""
    numbers = {}
    for name, spec in fields_of(ROWS[code].en).items():
        number = spec.partition(" ")[0][-1:] in tuple("efgd")
        size = st.integers(-(10**6), 10**6) if spec.endswith("d") else st.floats(-1e9, 1e9)
        numbers[name] = data.draw(size if number else st.text() | size)
    found = finding(code, "somewhere", 1.0, **numbers)
    again = finding_of(
        {name: getattr(found, name) for name in ("place", "severity", "message", "code", "numbers")}
    )
    assert again.sentence("de") == found.sentence("de") == sentence(code, numbers, "de")
    without = sentence(code, dict.fromkeys(numbers), "de")
    assert all(f"{{{name}" not in without for name in numbers)


def test_german_is_written_with_its_words_units_and_comma() -> None:
    steep = finding("parts.steep_angle", "wheel.toe", 0.35, angle=0.35)
    assert (steep.sentence("en"), steep.value) == (
        "20.1 deg is a lot; were degrees given as rad?",
        0.35,
    )
    assert steep.sentence("de", decimal=",") == "20,1 ° ist viel; wurden Grad als rad angegeben?"
    away = finding(
        "parts.springs_away", "strut", travel=0.05, direction="bump", needed=1e3, present=900.0
    )
    assert away.sentence("de").startswith(
        "Das statische Gleichgewicht liegt etwa 50 mm Radhub (Einfedern) von"
    )


def test_a_finding_without_a_code_that_is_known_is_its_text() -> None:
    assert Finding("a", "note", "as it was").sentence("de") == "as it was"
    assert finding_of(
        {"place": "a", "severity": "note", "message": "of another jounce", "code": "parts.no_such"}
    ).sentence("de")


def test_codes_and_fields_are_read_from_the_sources(tmp_path: Path) -> None:
    file = tmp_path / "finds.py"
    file.write_text(
        'finding("parts.steep", place, x, severity="note", a=1)\nfinding("parts.x" if a else "parts.y", p, **b)\n'
    )
    assert [(made.code, made.names) for made in made_in(file)] == [
        ("parts.steep", {"a"}),
        (None, None),
    ]
    assert codes_in(file, {"parts"}) == {"parts.steep", "parts.x", "parts.y"}
    assert fields_of("{a:.3g mm} of {b!r}") == {"a": ".3g mm", "b": ""}
