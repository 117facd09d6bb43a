"""The workbench says in German what the library finds: every message that its sources can make has a translation."""

from __future__ import annotations

import json
import re
from functools import cache
from itertools import chain, product
from pathlib import Path

import pytest

from jounce.inspection import reasons
from jounce.inspection.limits import load_limits
from jounce.inspection.methods import QUANTITIES
from rules import ROOT
from rules.finding_templates import german_of, progress_of, templates_of

CATALOGUE: dict[str, dict[str, str]] = json.loads(
    (ROOT / "viewer" / "src" / "workbench" / "findings.json").read_text(encoding="utf-8")
)
LIBRARY = ROOT / "src" / "jounce"
PARTS = {
    "identification": ["identify"],
}
ON_NO_PAGE = {"identify/damper_findings.py", "identify/damper_record.py", "damper_signs", "dissipating", "turned"}
"""What only the command line does, modules and functions: laws of dampers from their records."""


def _said_in(places: list[str]) -> set[str]:
    """Every message of modules and of those in folders."""
    files = [file for place in places for file in (sorted((LIBRARY / place).rglob("*.py")) or [LIBRARY / place])]
    return {
        template
        for file in files
        if file.relative_to(LIBRARY).as_posix() not in ON_NO_PAGE
        for template in templates_of(file, but=ON_NO_PAGE)
    }


def _fits(template: str, message: str) -> bool:
    """Whether a message, or another template, is what a template can become."""
    return _pattern(template).fullmatch(message) is not None


@cache
def _pattern(template: str) -> re.Pattern[str]:
    return re.compile(".*?".join(map(re.escape, template.split("#"))), re.DOTALL)


@pytest.mark.parametrize("of", PARTS)
def test_every_finding_has_its_german_and_no_german_is_left_over(of: str) -> None:
    said = _said_in(PARTS[of])
    assert len(said) > 6  # the sources were read
    known = CATALOGUE[of]
    assert [one for one in sorted(said) if not any(_fits(one, english) for english in known)] == []
    assert [one for one in known if not any(_fits(template, one) for template in said)] == []


@pytest.mark.parametrize("of", [*PARTS, "words"])
def test_both_languages_are_filled_with_as_much(of: str) -> None:
    assert [one for one, german in CATALOGUE[of].items() if one.count("#") != german.count("#")] == []


def test_reasons_of_a_grading_are_said_as_in_its_protocol() -> None:
    """Written anew where this fails: the left side of the comparison, as the catalogue's part `reasons`."""
    said: dict[str, str] = {}
    sources, limits = (("Limits", "Grenzwerte"), None), load_limits()
    for kind, sentence in reasons._SENTENCES.items():
        verdicts = reasons.VERDICT_WORDS.values() if "{verdict}" in sentence.en else (None,)
        for verdict, source in product(verdicts, sources if "{limits}" in sentence.en else (None,)):
            both = [
                text.replace("{verdict}", str(verdict and verdict[i]))
                .replace("{limits}", f" {source[i]}: {{source}}." if source else "")
                .replace("{quantity} {value}", "{measured}")
                .replace("{quantity}: {value}", "{measured}")
                for i, text in enumerate(sentence)
            ]
            said |= dict([one] if kind != "finding" and (one := german_of(both[0], both[1], least=5)) else [])
    for table in (reasons.VERDICT_WORDS, reasons.SIDES, reasons.AXLES, reasons._ACROSS, reasons._DEFINITIONS):
        said |= {one.en: one.de for one in table.values()}
    for quantity in QUANTITIES.values():
        said |= {quantity.english: quantity.german, f"{quantity.english} #": f"{quantity.german} #"}
    for criterion in chain(limits.methods.values(), limits.conditions.values(), limits.differences.values()):
        said |= {criterion.cited("en"): criterion.cited("de")}
        said |= {band.words("en"): band.words("de") for band in criterion.bands}
    first, last = {"from #": "ab #", "above #": "über #"}, {"up to #": "bis einschließlich #", "below #": "unter #"}
    said |= first | last | {f"{a}, {b}": f"{first[a]}, {last[b]}" for a, b in product(first, last)}
    said |= {"any value": "jeder Wert", "# # (#); # # (#)": "# # (#); # # (#)"}
    whole = {one: german for one, german in said.items() if one != german or "(" in one}
    assert whole == CATALOGUE["reasons"]


def test_what_a_job_says_as_it_goes_on_has_its_german() -> None:
    files = [LIBRARY / "kernel" / "native.py", LIBRARY / "kernel" / "call.py", LIBRARY / "report" / "render.py"]
    commands = ("campaign", "derived", "design", "inspection")
    files += [file for file in (LIBRARY / "cli").glob("*.py") if file.stem in commands]
    packages = ("campaign", "design", "operations", "ride", "variants")
    files += [file for name in packages for file in (LIBRARY / name).glob("*.py")]
    said = {template for file in files for template in progress_of(file)}
    assert {"loading", "simulating # variants: # %", "compiling the loop # (once on this machine)"} <= said
    known = json.loads((ROOT / "viewer" / "src" / "workbench" / "german.json").read_text(encoding="utf-8"))
    assert [one for one in sorted(said) if not any(_fits(one, english) for english in known)] == []


def test_a_message_is_read_from_its_source(tmp_path: Path) -> None:
    file = tmp_path / "finds.py"
    file.write_text(
        "def looks(x, other):\n"
        "    text = f'it is {x:g} m'\n"
        "    yield Finding('a', 'note', text + (f' at {x}' if x else '; why?'))\n"
        '    text = f\'{"low" if x else "high"} by {x} %\'\n'
        "    yield _warn('b', text, x)\n"
        "    yield Finding('c', 'note', other)\n"
        "    def add(severity, said, value=None):\n"
        "        found.append(Finding('d', severity, said, value))\n"
        "    text = f'{x} m above'\n"
        "    if x:\n"
        "        text += f', as {other} is'\n"
        "    add('note', text)\n"
        "    add('note', SHORT.format(other))\n"
        "def _warn(place, said, x):\n"
        "    return Finding(place, 'warning', said, x)\n"
        "SHORT = 'short of {:.3g} m'\n"
        "def not_shown():\n"
        "    Finding('e', 'note', 'on no page')\n"
    )
    said = {"it is # m at #", "it is # m; why?", "low by # %", "high by # %"}
    assert templates_of(file, but={"not_shown"}) == said | {"# m above", "# m above, as # is", "short of # m"}
    assert german_of("the {name} is longer by {value:.3g} mm", "um {value:.3g} mm länger: {name}") == (
        "the # is longer by # mm",
        "um #2 mm länger: #1",
    )
