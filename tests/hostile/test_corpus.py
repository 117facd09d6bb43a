"""The corpus of bad inputs: each is refused clearly, told with a finding, or harmless; none crashes, hangs or lies."""

from __future__ import annotations

import shlex
import sys
from collections import Counter
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest
from corpus import commands, descriptions, files, judging, models, outputs, recordings
from corpus.__main__ import PARTS, TITLES
from corpus.judging import BAD, judge
from corpus.mutations import KINDS

from jounce.operations.checks import _SCHEMAS
from jounce.recordings import READERS

pytestmark = pytest.mark.skipif(
    sys.platform == "win32", reason="limits of memory and time are a thing of POSIX"
)

FAST = {"files": 2, "descriptions": 80, "commands": 24, "outputs": 23}
"""Every so many-th case is tried by the fast tests; of files, so many of each."""

FOUND = {
    "files": [("mat73", 24, 16180), ("mat73", 86, 16180), ("parquet", 928, 16180)],
    "descriptions": [
        ("limits", 4, "left out"),
        ("campaign", 54, "truth"),
        ("sweep", 12, "long integer"),
        ("optimisation", 10, "table"),
    ],
}
"""What was bad when a seed was fresh, one of each kind."""


def judged(part: str, cases: list[Any]) -> None:
    found = list(judge(f"corpus.{part}", cases))
    assert len(found) == len(cases)
    bad = [(case, verdict, said[:500]) for case, verdict, said in found if verdict in BAD]
    assert not bad, f"{len(bad)} of {len(found)}:\n" + "\n".join(map(str, bad[:20]))
    refused = Counter(verdict for _, verdict, _ in found)
    assert refused["refused"] > len(cases) // 4, refused


@pytest.mark.slow
@pytest.mark.parametrize("part", PARTS)
def test_the_whole_corpus(part: str) -> None:
    judged(part, import_module(f"corpus.{part}").cases(*PARTS[part]))


@pytest.mark.slow
def test_right_uses_are_right(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for name, base in commands.BASES.items():
        if name not in commands.SLOW:
            words = shlex.split(outputs.USES.get(name, base))
            with outputs.folder_for(name):
                code, _, said = commands.said_by(words)
            assert code == 0 or name.startswith("campaign "), (
                name,
                said,
            )  # whose template's numbers are its user's


def test_a_part_of_the_files() -> None:
    names = recordings.names()
    cases = [
        (name, 7 * k + i, files.SEED) for i, name in enumerate(names) for k in range(FAST["files"])
    ]
    judged("files", [*cases, *FOUND["files"]])


def test_a_part_of_the_models() -> None:
    names = models.SAMPLES
    judged(
        "models",
        [
            (name, 5 * k + i, models.SEED)
            for i, name in enumerate(names)
            for k in range(FAST["files"])
        ],
    )


def test_a_part_of_the_descriptions() -> None:
    judged("descriptions", [*descriptions.cases()[:: FAST["descriptions"]], *FOUND["descriptions"]])


def test_a_part_of_the_commands() -> None:
    quick = [
        case
        for case in commands.cases()
        if case[0] in ("check", "modes", "iri", "bench speed", "fit stiffness")
    ]
    judged("commands", quick[:: FAST["commands"] // 4])


def test_a_part_of_the_outputs() -> None:
    quick = ("simulate", "import chrono", "campaign new", "inspect import", "inspect export")
    chosen = [
        case
        for case in outputs.cases()
        if case[0] in quick and case[1] not in ("--report", "--figure")
    ]
    judged("outputs", chosen[:: FAST["outputs"]])


def test_every_format_of_every_output_is_in_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What a command says to a suffix that nobody knows are the suffixes that are tried."""
    monkeypatch.chdir(tmp_path)
    for name, option in {target[:2] for target in outputs.targets()}:
        known = outputs.suffixes(name, option)
        if known not in ((".sqlite",), ("",)):
            with outputs.folder_for(name):
                code, _, said = commands.said_by(
                    outputs.words((name, option, ".unknown", ""), "x.unknown")
                )
            assert code == 2, (name, option)
            found = said.partition("allowed: ")[2].rstrip(".\n").split(", ")
            assert {*found} - {".mp4"} == {*known}, (name, option, said)


def test_every_reader_kind_and_command_is_in_it() -> None:
    assert {recordings.reader_of(name) for name in recordings.names()} == {
        reader.name for reader in READERS
    }
    assert all(
        recordings.sample(name).reader == recordings.reader_of(name) for name in recordings.names()
    )
    assert set(commands.BASES) == set(commands.commands())
    schemas = {name.removeprefix("jounce.").removesuffix("/1") for name in _SCHEMAS}
    assert schemas == {name.partition(" ")[0].strip(":") for name in descriptions.KINDS} - {
        "full",
        "header",
    }
    assert len(KINDS) == 8


def test_it_has_the_size_that_is_told() -> None:
    cases = len(commands.cases()) + len(descriptions.cases(*PARTS["descriptions"]))
    assert cases >= 1400
    for module in (files, models):
        of = recordings.reader_of if module is files else models.reader_of
        counts = Counter(
            of(name) for name, _, _ in module.cases(*PARTS[module.__name__.partition(".")[2]])
        )
        assert min(counts.values()) >= 2000, counts


@pytest.mark.parametrize("part", PARTS)
def test_the_page_tells_what_is_tried_and_that_nothing_is_bad(part: str) -> None:
    page = (Path(__file__).parents[2] / "docs" / "explanation" / "robustness.md").read_text(
        encoding="utf-8"
    )
    _, _, told = page.partition(f"### {TITLES[part]}")
    rows = [
        line.strip("| ").split(" | ")
        for line in told.split("###")[0].splitlines()
        if line.startswith("|")
    ]
    heads, whole = rows[0], next(row for row in rows if row[0] == "**all**")
    numbers = {head: int(count) for head, count in zip(heads[1:], whole[1:], strict=True)}
    assert all(numbers[verdict] == 0 for verdict in BAD)
    assert numbers["tried"] == sum(numbers.values()) - numbers["tried"]
    assert {row[0] for row in rows[2:]} - {"**all**"} == {
        case[0] for case in import_module(f"corpus.{part}").cases(*PARTS[part])
    }


JUDGED = """
import os, time

def verdict(case):
    if case == "crash":
        os.abort()
    if case == "loop":
        while True:
            pass
    if case == "sleep":
        time.sleep(60.0)
    if case == "memory":
        bytearray(10**11)
    return case, "said"
"""


@pytest.mark.slow
def test_the_judge_finds_what_ends_stands_still_and_takes_too_much(tmp_path, monkeypatch) -> None:
    (tmp_path / "judged_here.py").write_text(JUDGED)
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setattr(judging, "CPU", 1)
    asked = ["refused", "crash", "right", "loop", "sleep", "memory", "flagged"]
    found = [verdict for _, verdict, _ in judge("judged_here", asked, clock=6.0)]
    assert found == ["refused", "crashed", "right", "hung", "hung", "crashed", "flagged"]


@pytest.mark.parametrize(
    "text", ["internal error: x in a.csv", "a.csv: " + "x" * 5000, "somewhere: wrong"]
)
def test_what_is_no_clear_message(text: str) -> None:
    assert not judging.is_clear(text, "a.csv")
