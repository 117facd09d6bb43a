"""Progress is said in German: every text that the sources can show has a row in a catalogue of phrases."""

from __future__ import annotations

import re
import tomllib

from jounce.core.phrases import Phrase, german_of
from jounce.core.waiting import Waiting, progress_through
from rules import ROOT
from rules.progress_templates import progress_of

LIBRARY = ROOT / "src" / "jounce"
NAMES = {"#", "#: #"}
"""Texts of names alone, which have no language."""


def test_progress_has_german() -> None:
    files = [
        LIBRARY / "kernel" / "native.py",
        LIBRARY / "kernel" / "call.py",
        LIBRARY / "report" / "render.py",
    ]
    commands = ("campaign", "derived", "design", "inspection", "pictures", "study")
    files += [file for file in (LIBRARY / "cli").glob("*.py") if file.stem in commands]
    packages = (
        "campaign",
        "design",
        "identify",
        "inspection",
        "operations",
        "plots",
        "report",
        "ride",
        "variants",
    )
    files += [file for name in packages for file in (LIBRARY / name).rglob("*.py")]
    shown = {template for file in files for template in progress_of(file)} - NAMES
    assert {
        "loading",
        "simulating # variants: # %",
        "compiling the loop # (once on this machine)",
    } <= shown
    rows = [
        tomllib.loads(file.read_text(encoding="utf-8")) for file in LIBRARY.glob("*/phrases.toml")
    ]
    known = {re.sub(r"\{[^}]*\}", "#", english) for table in rows for english in table}
    assert sorted(shown - known) == []


def test_what_operations_do_has_german() -> None:
    texts = {
        text
        for file in LIBRARY.rglob("*.py")
        for text in re.findall(
            r'^ +doing="([^"]+)"', file.read_text(encoding="utf-8"), re.MULTILINE
        )
    }
    assert len(texts) > 15
    assert sorted(text for text in texts if german_of(text) is None) == []


def test_the_time_waited_stands_behind_the_german() -> None:
    waiting = Waiting(
        Phrase("compiling the model ({once})", once=Phrase("once on this machine")), 4.2
    )
    assert waiting == "compiling the model (once on this machine), 4 s"
    assert waiting.what.german() == "kompiliert das Modell (einmal auf diesem Rechner)"
    progress = progress_through(
        "compare trial {which} of {count}: {name}", 2, 5, name=Phrase("trial {number}", number=7)
    )
    assert progress.german() == "vergleicht Versuch 2 von 5: Versuch 7"
