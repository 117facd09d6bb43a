"""The workbench says in German what the library finds: every message that its sources can make has a translation."""

from __future__ import annotations

import json
import re
from functools import cache
from itertools import chain, product

from jounce.inspection import reasons
from jounce.inspection.limits import load_limits
from jounce.inspection.methods import QUANTITIES
from rules import ROOT
from rules.finding_templates import german_of, progress_of

CATALOGUE: dict[str, dict[str, str]] = json.loads(
    (ROOT / "viewer" / "src" / "workbench" / "findings.json").read_text(encoding="utf-8")
)
LIBRARY = ROOT / "src" / "jounce"


def _fits(template: str, message: str) -> bool:
    """Whether a message, or another template, is what a template can become."""
    return _pattern(template).fullmatch(message) is not None


@cache
def _pattern(template: str) -> re.Pattern[str]:
    return re.compile(".*?".join(map(re.escape, template.split("#"))), re.DOTALL)


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
