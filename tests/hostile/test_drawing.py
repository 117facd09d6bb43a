"""What was computed is on the disk before anything is drawn, and a drawing that fails is one finding of the reply."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import jounce.report.campaign as campaign_report
from jounce.cli import main
from jounce.core.errors import OutputError
from jounce.core.findings import DrawingError
from jounce.plots import figures
from jounce.plots.fits import damper_loops
from jounce.report import Page, Paragraph, Picture, Section, render, write_page

NAMES = {
    "mathtext": "$x^{$ \\frac",
    "length": "Größe " * 70,
    "page": "</svg><script>alert(1)</script>{{ 7 * 7 }}&amp;",
    "underscore": "_hidden",
}


@pytest.fixture(scope="module")
def campaign(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The commented campaign, without its update."""
    folder = tmp_path_factory.mktemp("mine") / "mine"
    assert main(["campaign", "new", str(folder)]) == 0
    file = folder / "campaign.toml"
    file.write_text(file.read_text(encoding="utf-8").split("# --- updates")[0], encoding="utf-8")
    return file


@pytest.fixture
def said(capsys: pytest.CaptureFixture[str]) -> Any:
    capsys.readouterr()
    return lambda: json.loads(capsys.readouterr().out)


def test_names_are_never_markup_and_never_lose_results(
    campaign: Path, tmp_path: Path, said: Any
) -> None:
    folder = tmp_path / "named"
    shutil.copytree(campaign.parent, folder)
    file = folder / campaign.name
    text = file.read_text(encoding="utf-8").replace(
        '"My bench campaign"', json.dumps(" ".join(NAMES.values()))
    )
    text = text.replace('road = "A"', 'road = "$x^{$ \\\\frac"').replace(
        "[roads.A]", '[roads."$x^{$ \\\\frac"]'
    )
    text = text.replace('of = "A"', 'of = "$x^{$ \\\\frac"')
    update = (
        'free = {"strut.damper.coefficient" = "50 %"}\nmethod = "least-squares"\ntrials = [1]\n'
    )
    text += "".join(
        f"[[update]]\nname = {json.dumps(name)}\n{update}"
        for name in (NAMES["length"], NAMES["page"])
    )
    file.write_text(text, encoding="utf-8")
    out = tmp_path / "out"
    assert main(["campaign", "run", str(file), "--out", str(out), "--json"]) == 0
    plain = said()
    assert [one["name"] for one in plain["updates"]] == [NAMES["length"], NAMES["page"]]
    assert plain == {
        **json.loads((out / "results.json").read_text(encoding="utf-8")),
        "is_complete": True,
        "out": str(out),
    }
    page = (out / "report.html").read_text(encoding="utf-8")
    assert "alert(1)" in page
    assert "<script>alert" not in page
    assert "7 * 7" in page
    assert NAMES["mathtext"] in page
    assert len(list(out.glob("rig-*.toml"))) == 2


def test_a_figure_and_a_section_that_fail(
    campaign: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, said: Any
) -> None:
    out = tmp_path / "out"
    draw = render.chart_html

    def fails(chart: Any) -> Any:
        assert json.loads((out / "results.json").read_text(encoding="utf-8"))["trials"]
        if chart.name == "roads":
            raise ValueError("no glyph for $")
        return draw(chart)

    def no_validation(_: object) -> None:
        raise ZeroDivisionError("scale")

    monkeypatch.setattr(render, "chart_html", fails)
    monkeypatch.setattr(campaign_report, "validation", no_validation)
    assert (
        main(["campaign", "run", str(campaign), "--out", str(out), "--figure", "svg", "--json"])
        == 1
    )
    plain = said()
    problems = [one for one in plain["findings"] if one["severity"] == "problem"]
    assert [one["place"] for one in problems] == ["Validation", "figure roads"]
    assert "ZeroDivisionError: scale" in problems[0]["message"]
    assert plain["is_complete"]
    page = (out / "report.html").read_text(encoding="utf-8")
    assert "could not be drawn: ZeroDivisionError: scale" in page
    assert "This figure could not be drawn: Height profiles" in page
    assert len(list((out / "figures").glob("*.svg"))) > 2
    assert not (out / "figures" / "roads.svg").exists()


def test_a_page_that_fails_leaves_results_and_says_so_in_its_place(tmp_path: Path) -> None:
    def page() -> Page:
        assert (tmp_path / "out" / "results.json").read_text() == "{}"
        raise MemoryError

    with pytest.raises(DrawingError, match="could not be drawn: MemoryError"):
        write_page(page, tmp_path / "out", files={"results.json": "{}"})
    assert sorted(file.name for file in (tmp_path / "out").iterdir()) == [
        "report.html",
        "results.json",
    ]
    assert "Not drawn yet" in (tmp_path / "out" / "report.html").read_text()
    write_page(lambda: Page("done", ()), tmp_path / "out", files={"results.json": "[]"}, force=True)
    assert "Not drawn yet" not in (tmp_path / "out" / "report.html").read_text()
    with pytest.raises(OutputError, match="not empty") as caught:
        write_page(page, tmp_path / "out", files={"results.json": "{}"})
    assert not isinstance(caught.value, DrawingError)
    assert (tmp_path / "out" / "results.json").read_text() == "[]"


KILLED = """
import os, sys
from jounce.report import write_page
write_page(lambda: os._exit(9), sys.argv[1], files={"results.json": "{}"})
"""


def test_a_process_that_ends_while_it_draws(tmp_path: Path) -> None:
    ran = subprocess.run([sys.executable, "-c", KILLED, str(tmp_path / "out")], check=False)
    assert ran.returncode == 9
    assert (tmp_path / "out" / "results.json").read_text() == "{}"


def test_two_figures_of_one_name_are_still_refused(tmp_path: Path) -> None:
    pictures = tuple(
        Picture(figures.new_figure(1.0), "same", "A figure.", "A figure.") for _ in range(2)
    )
    with pytest.raises(OutputError, match="two figures have the same name"):
        write_page(
            Page("twice", (Section("Both", (Paragraph("two"), *pictures)),)), tmp_path / "out"
        )


COMMANDS = [
    [
        "ride",
        "kart-quarter-car",
        "--road",
        "iso:A",
        "--speed",
        "10 m/s",
        "--duration",
        "3 s",
        "--out",
        "run.csv",
    ],
    [
        "compare",
        "kart-quarter-car",
        "--control",
        "passive",
        "--speed",
        "10 m/s",
        "--duration",
        "3 s",
    ],
]


@pytest.mark.parametrize("command", COMMANDS, ids=lambda command: command[0])
def test_commands_tell_what_they_computed_where_the_figure_fails(
    command: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, said: Any
) -> None:
    def fails(*_: object, **__: object) -> None:
        raise ValueError("no glyph")

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(figures, "render_figure", fails)
    assert main([*command, "--figure", "out.png", "--json"]) == 1
    plain = said()
    assert plain["figure"] is None
    (problem,) = (one for one in plain["findings"] if one["severity"] == "problem")
    assert "could not be drawn: ValueError: no glyph" in problem["message"]
    assert plain["vehicle"] == "kart-quarter-car"
    assert len(plain) > 8
    assert [file.name for file in tmp_path.iterdir()] == (["run.csv"] if "--out" in command else [])


def test_a_protocol_that_fails_leaves_its_values(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from jounce.inspection import Inspection, WheelResult
    from jounce.inspection.grading import grade
    from jounce.report import protocol, write_protocol

    def fails(*_: object, **__: object) -> None:
        raise RuntimeError("no fonts")

    monkeypatch.setattr(protocol, "fill_template", fails)
    wheels = [
        WheelResult(side, static_load=4e3, phase_angle_min_deg=51.0) for side in ("left", "right")
    ]
    graded = grade(Inspection(tuple(wheels), methods=("egea",)))
    with pytest.raises(DrawingError, match="no fonts"):
        write_protocol(graded, tmp_path / "car.html", about={"vehicle": "A6"})
    assert [file.name for file in tmp_path.iterdir()] == ["car.json"]
    assert json.loads((tmp_path / "car.json").read_text(encoding="utf-8"))["about"] == {
        "vehicle": "A6"
    }


def test_long_names_leave_room_and_an_underscore_hides_nothing() -> None:
    velocity = [-1.0, 0.0, 1.0]
    figure = damper_loops(
        [], velocity, velocity, {NAMES["underscore"]: velocity}, title=NAMES["length"] * 3
    )
    svg = figures.render_figure(figure, [".svg"])[".svg"].decode()
    assert NAMES["underscore"] in svg
    assert NAMES["length"][:100] in svg
    assert "…" in svg
