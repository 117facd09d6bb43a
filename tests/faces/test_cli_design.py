"""``jounce design`` through its entry point."""

from __future__ import annotations

import re
from html import unescape
from pathlib import Path

import pytest

import jounce as jn
from jounce.plots import number

QUARTER = ("design", "optimise", "audi-a6-quarter-car", "--set", "tyre.damping_coefficient=0")
DAMPER = "strut.damper.coefficient"
ON_C = ("--road", "iso:C", "--speed", "20 m/s")


def test_springs(cli):
    done = cli(
        "design", "springs", "sldemo-half-car", "--frequency", "1.43828 Hz", "--damping-ratio", "0.4",
        "--rear-damping-ratio", "43 %", "--out", "springs.toml", "--json",
    )  # fmt: skip
    assert done.exit_code == 0
    front, rear = done.json["wheels"]
    assert front["wanted"]["spring_rate"] == pytest.approx(28e3, rel=1e-4)
    assert rear["wanted"]["spring_rate"] == pytest.approx(21e3, rel=1e-4)
    assert rear["wanted"]["damping_ratio"] == pytest.approx(0.43)
    assert (
        done.json["changes"]["front.damping_coefficient"] == front["wanted"]["damping_coefficient"]
    )
    written = jn.load("springs.toml")
    assert written.parameters()["front.spring_rate"] == pytest.approx(28e3, rel=1e-4)
    shown = cli(
        "design", "springs", "kart-quarter-car", "--frequency", "4 Hz", "--damping-ratio", "0.2"
    )
    assert "present" in shown.out
    assert "target" in shown.out


def words_of(page: str) -> str:
    """What a page shows: its text without markup and scripts."""
    text = re.sub(
        r"<(script|style)\b.*?</\1>", " ", Path(page).read_text(encoding="utf-8"), flags=re.DOTALL
    )
    return " ".join(unescape(re.sub(r"<[^>]+>", " ", text)).split())


def test_optimise(cli):
    done = cli(
        *QUARTER, "--free", f"{DAMPER}=500..5000 N*s/m", "--objective", "sprung.az", *ON_C, "--json"
    )
    assert done.exit_code == 0
    assert done.json["values"][DAMPER] == pytest.approx(
        1559.081, abs=1e-3
    )  # k sqrt((m_s + m_u) / k_t)
    assert done.json["converged"] is True
    assert done.json["derivatives"] == "exact"
    tight = cli(
        *QUARTER, "--free", f"{DAMPER}=500..5000", "--objective", "sprung.az=2", "--objective", "tyre.force=1",
        "--limit", "strut.deflection=9 mm", "--limit", "mode 1 frequency=1..2 Hz", *ON_C,
        "--figure", "best.svg", "--out", "best.toml", "--report", "best.html",
    )  # fmt: skip
    assert tight.exit_code == 0, tight.err
    assert "holds the design" in tight.out
    assert "converged" in tight.out
    assert Path("best.svg").read_text(encoding="utf-8").startswith("<?xml")
    text = words_of("best.html")
    assert "Best design on" in text
    assert "holds the design" in text  # the limit that is active
    assert "the start violates a limit" in text  # 11.3 mm
    assert "no design better" not in text
    assert "Numbers of the design" in text
    assert "# audi-a6-quarter-car, best for sprung.az, tyre.force" in Path("best.toml").read_text(
        encoding="utf-8"
    )


def test_optimise_on_a_simulated_road(cli, bump):
    done = cli(
        "design", "optimise", "kart-quarter-car", "--free", f"{DAMPER}=±80 %", "--objective", "sprung.az",
        "--road", bump, "--speed", "1.95 m/s", "--duration", "0.6 s", "--json",
    )  # fmt: skip
    assert done.exit_code == 0, done.err
    assert done.json["driven"] == "a simulated trial"
    assert done.json["value"] < 1.0


def test_pareto(cli):
    done = cli(
        "design", "pareto", "audi-a6-quarter-car", "--free", f"{DAMPER}=300..6000", "--points", "5",
        "--figure", "front.png", "--report", "front.html", "--json",
    )  # fmt: skip
    assert done.exit_code == 0, done.err
    plain = done.json
    assert len(plain["comfort"]) == len(plain["numbers"][DAMPER]) == 5
    assert plain["comfort"] == sorted(plain["comfort"])
    assert plain["holding"] == sorted(plain["holding"], reverse=True)
    assert {mark["kind"] for mark in plain["marks"]} == {"present", "closed form", "searched"}
    assert Path("front.png").stat().st_size > 10_000
    assert plain["report"] == "front.html"
    text = words_of("front.html")
    assert all(f"{number(value)}" in text for value in plain["comfort"])
    assert "closed form" in text
    again = cli(
        "design",
        "pareto",
        "audi-a6-quarter-car",
        "--free",
        f"{DAMPER}=300..6000",
        "--figure",
        "front.png",
    )
    assert again.exit_code == 2
    assert "--force" in again.err
    shown = cli(
        "design", "pareto", "audi-a6-quarter-car", "--free", f"{DAMPER}=300..6000", "--points", "4"
    )
    assert "Pareto front, comfort to road holding" in shown.out
    assert "best damper for comfort" in shown.out


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (
            ("springs", "kart-quarter-car", "--frequency", "1.2 m", "--damping-ratio", "0.3"),
            "wrong unit",
        ),
        (
            ("springs", "kart-quarter-car", "--frequency", "1.2 Hz", "--damping-ratio", "-0.3"),
            "at least 0",
        ),
        (
            ("springs", "kart-quarter-car", "--frequency", "", "--damping-ratio", "0.3"),
            "--frequency",
        ),
        (
            ("springs", "kart-quarter-car", "--frequency", "1e-300", "--damping-ratio", "0.3"),
            "an implausibly low frequency",
        ),
        (
            ("springs", "kart-double-wishbone", "--frequency", "1.2 Hz", "--damping-ratio", "0.3"),
            "lumped_from",
        ),
        (
            (
                "springs",
                "kart-quarter-car",
                "--frequency",
                "4",
                "--damping-ratio",
                "0.3",
                "--out",
                "a.json",
            ),
            ".toml",
        ),
        ((*QUARTER[1:], "--free", DAMPER, "--objective", "sprung.az", *ON_C), "not NAME=VALUE"),
        (
            (*QUARTER[1:], "--free", f"{DAMPER}=9..9", "--objective", "sprung.az", *ON_C),
            "lower bound must be below",
        ),
        (
            (*QUARTER[1:], "--free", "strut.dmper=9..99", "--objective", "sprung.az", *ON_C),
            "unknown parameter",
        ),
        (
            (*QUARTER[1:], "--free", f"{DAMPER}=±9 %", "--objective", "sprung.a", *ON_C),
            "unknown metric",
        ),
        (
            (*QUARTER[1:], "--free", f"{DAMPER}=±9 %", "--objective", "sprung.az=x", *ON_C),
            "not a number",
        ),
        (
            (
                *QUARTER[1:],
                "--free",
                f"{DAMPER}=±9 %",
                "--objective",
                "sprung.az",
                *ON_C,
                "--band",
                "3",
            ),
            "invalid band",
        ),
        (
            (
                *QUARTER[1:],
                "--free",
                f"{DAMPER}=±9 %",
                "--objective",
                "sprung.az",
                "--limit",
                "strut.deflection=1 mm",
                *ON_C,
            ),
            "no design within the bounds meets all limits",
        ),
        (
            (
                *QUARTER[1:],
                "--free",
                f"{DAMPER}=±9 %",
                "--objective",
                "sprung.az",
                "--road",
                "iso:K",
                "--speed",
                "20",
            ),
            "class",
        ),
        (
            ("pareto", "audi-a6-half-car", "--free", "front.spring_rate=±9 %"),
            "unknown metric 'tyre.force'",
        ),
        (
            ("pareto", "audi-a6-quarter-car", "--free", f"{DAMPER}=±9 %", "--points", "1"),
            "number of points",
        ),
        (
            ("pareto", "audi-a6-quarter-car", "--free", f"{DAMPER}=±9 %", "--figure", "a.txt"),
            "not written in this format",
        ),
    ],
)
def test_bad_requests_are_one_message(cli, words, text):
    if words[0] not in ("springs", "pareto"):
        words = ("optimise", *words[1:])
    done = cli("design", *words)
    assert done.exit_code == 2, done.out
    assert text in done.err
    assert done.err.count("\n") <= 2


def test_a_study_file_says_all_of_an_optimisation(cli, tmp_path):
    (tmp_path / "study.toml").write_text(
        'schema = "jounce.optimisation/1"\nrig = "audi-a6-quarter-car"\n'
        'free = {"strut.damper.coefficient" = ["500 N*s/m", "5000 N*s/m"]}\nobjective = "p95 sprung.az"\n'
        'cases = {rough = {road = "C", speed = "20 m/s"}}\nspread = {"sprung.mass" = "10 %"}\nsamples = 4\n',
        encoding="utf-8",
    )
    found = cli("design", "optimise", "study.toml", "--out", "best.toml", "--json")
    assert found.exit_code == 0, found.err
    assert found.json["converged"]
    assert (tmp_path / "best.toml").is_file()
    assert "study.toml" in cli("check", "study.toml").out
    told = cli("design", "optimise", "study.toml", "--objective", "sprung.az")
    assert told.exit_code == 2
    assert "a study file defines" in told.err
    assert cli("design", "optimise", "audi-a6-quarter-car").exit_code == 2


def test_a_study_of_three_metrics_is_a_front_of_them(cli, tmp_path):
    (tmp_path / "study.toml").write_text(
        'schema = "jounce.optimisation/1"\nrig = "audi-a6-quarter-car"\npoints = 3\n'
        'free = {"strut.damper.coefficient" = ["500 N*s/m", "5000 N*s/m"]}\n'
        'front = ["rough: sprung.az", "rough: tyre.force", "rough: strut.deflection"]\n'
        'cases = {rough = {road = "C", speed = "20 m/s"}}\n',
        encoding="utf-8",
    )
    outputs = ("--figure", "front.png", "--report", "front.html")
    found = cli("design", "optimise", "study.toml", *outputs, "--json")
    assert found.exit_code == 0, found.err
    assert set(found.json["goals"]) == {
        "rough: sprung.az",
        "rough: tyre.force",
        "rough: strut.deflection",
    }
    assert (tmp_path / "front.png").stat().st_size > 10_000
    page = (tmp_path / "front.html").read_text(encoding="utf-8")
    assert "as it is" in page
    assert "designs on the front" in page
    assert "as it is" in cli("design", "optimise", "study.toml").out
    assert cli("design", "optimise", "study.toml", "--out", "best.toml").exit_code == 2
