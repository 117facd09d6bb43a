"""What comes with an extra is asked for before the work, with the way to install it; the rest goes without."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from jounce.core.optional import how_to_install
from jounce.report.render import figures_here

PDF = f"'typst' is not installed.*{re.escape(how_to_install('pdf'))}"
RECORD = "time [s], left.plate.z [mm], left.plate.force [N]\n" + "".join(
    f"{i / 1000}, {i % 7}, {i}\n" for i in range(50)
)


@pytest.fixture
def without_typst(monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(sys.modules, "typst", None)
    Path("record.csv").write_text(RECORD, encoding="utf-8")


DRIVEN = ("--speed", "5 m/s", "--duration", "1 s")
WORK = ("jounce.campaign.run_campaign", "jounce.papers.demo.run_demo")


@pytest.mark.parametrize(
    "words",
    [
        ("demo", "--out", "out", "--report", "pdf"),
        ("demo", "--out", "out", "--figure", "png"),
        ("campaign", "run", "campaign.toml", "--out", "out", "--report", "pdf"),
        ("inspect", "evaluate", "record.csv", "--tester", "eusama", "--report", "out.pdf"),
        (
            "ride",
            "kart-quarter-car",
            "--road",
            "detrended_rms_course_1in",
            *DRIVEN,
            "--report",
            "out.pdf",
        ),
    ],
    ids=" ".join,
)
def test_pdf_and_png_are_refused_before_the_work(cli, without_typst, monkeypatch, words):
    def worked(*_, **__):
        raise AssertionError("the work has begun")

    for name in WORK:
        monkeypatch.setattr(name, worked)
    outcome = cli(*words)
    assert outcome.exit_code == 2
    assert re.search(PDF, " ".join(outcome.err.split()))
    assert sorted(file.name for file in Path.cwd().iterdir()) == ["record.csv"]


def test_figures_beside_a_page_are_those_that_can_be_written(without_typst):
    assert figures_here() == ("svg",)


def test_figures_beside_a_page_are_all_where_all_is_installed():
    assert figures_here() == ("svg", "png")


SCRIPT = """
import sys
sys.modules["sqlalchemy"] = None
from jounce.cli import main
print(main(sys.argv[1:]))
"""


@pytest.mark.parametrize(
    ("words", "needed"),
    [
        (("search", "--store", "lane.db"), True),
        (("evaluate", "record.csv", "--tester", "eusama", "--store", "lane.db"), True),
        (("evaluate", "record.csv", "--tester", "eusama"), False),
    ],
    ids=["search", "evaluate and store", "evaluate"],
)
def test_only_a_store_needs_a_database(tmp_path, words, needed):
    (tmp_path / "record.csv").write_text(RECORD, encoding="utf-8")
    command = [sys.executable, "-c", SCRIPT, "inspect", *words]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
    said = " ".join(done.stderr.split())
    assert done.stdout.endswith("2\n"), done.stdout  # no wheel can be graded by such a record
    assert (
        ("'sqlalchemy' is not installed" in said) == (how_to_install("store") in said) == needed
    ), said
    assert not (tmp_path / "lane.db").exists()
