"""The workbench says in German how far a job is: every text that the sources can make has a translation."""

from __future__ import annotations

import json
import re
from functools import cache

from rules import ROOT
from rules.progress_templates import progress_of

LIBRARY = ROOT / "src" / "jounce"


def _fits(template: str, message: str) -> bool:
    """Whether a message, or another template, is what a template can become."""
    return _pattern(template).fullmatch(message) is not None


@cache
def _pattern(template: str) -> re.Pattern[str]:
    return re.compile(".*?".join(map(re.escape, template.split("#"))), re.DOTALL)


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
