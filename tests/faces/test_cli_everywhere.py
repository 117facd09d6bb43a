"""What every command has: units that are shown, long tables, pages opened, completion, help in the field's words."""

from __future__ import annotations

import io
import re
import sys
import webbrowser
from pathlib import Path

import pytest
from rich.console import Console

import jounce as jn
from jounce.cli import main
from jounce.cli.entry import _command
from jounce.cli.everywhere import VIEW, open_pages, word_of
from jounce.cli.reply import Elapsed, console, show_findings, table
from jounce.cli.tables import FittedTable
from jounce.core.display import current_units
from jounce.core.findings import Finding
from jounce.core.phrases import Phrase
from jounce.core.waiting import Stage, progress_through

RIG = "kart-quarter-car"


def commands(
    command: object = None, path: tuple[str, ...] = ()
) -> list[tuple[tuple[str, ...], object]]:
    command = command or _command()
    inner = getattr(command, "commands", None)
    if inner is None:
        return [(path, command)]
    return [found for name, one in inner.items() for found in commands(one, (*path, name))]


def test_help_names_values_in_words_and_never_in_types(cli) -> None:
    seen = set()
    for path, command in commands():
        for one in command.params:
            if one.param_type_name == "option":
                seen.add(one.metavar)
                assert (
                    one.metavar == ""
                    if one.is_flag
                    else re.fullmatch(r"[^<>]*[A-Z|][^<>]*", one.metavar)
                ), (
                    path,
                    one.opts,
                )
    assert {"SPEED", "RANGE", "FILE", "DIR", "TIME", "metric|imperial", "svg|png|paper"} <= seen
    for words in (("kinematics",), ("fit", "stiffness"), ("ride",)):
        assert not re.search(r"<\w+(\[\w+\])?>", cli(*words, "--help").out)


def test_a_line_reads_only_the_command_that_it_begins_with(cli) -> None:
    every = _command().commands
    for word, one in every.items():
        assert [*_command(word).commands] == [word]
        assert [*getattr(_command(word).commands[word], "commands", {})] == [
            *getattr(one, "commands", {})
        ]
    for word in ("mdoes", "--version", ""):
        assert [*_command(word).commands] == [*every]
    assert "modes" in cli("mdoes").err
    assert all(word in cli("--help").out for word in every)


def test_word_of_leaves_what_a_command_says() -> None:
    [simulate] = [command for path, command in commands() if path == ("simulate",)]
    words = {one.opts[0]: word_of(one, str) for one in simulate.params}
    assert words["--set"] == "PATH=VALUE"
    assert words["--duration"] == "TIME"
    assert words["--output-step"] == "STEP"
    assert words["rig"] == "RIG"


def test_versions_of_what_it_runs_on(cli) -> None:
    found = cli("--version", "--json").json
    assert {
        "jounce",
        "python",
        "casadi",
        "llvmlite",
        "numba",
        "numpy",
        "scipy",
        "system",
        "cache",
        "cache_unusable",
    } == set(found)
    assert found["numpy"]
    text = cli("--version").out
    assert text == cli("version").out
    assert text.startswith(f"jounce {found['jounce']}\n")


def test_cache_that_cannot_be_named_is_none(cli, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("JOUNCE_CACHE_DIR", "not/absolute")
    assert cli("version", "--json").json["cache"] is None
    assert "cache none" in cli("version").out
    assert (
        "not kept, every process makes its own: JOUNCE_CACHE_DIR is no absolute path"
        in cli("version").out
    )


def test_cache_that_cannot_be_written_is_said(
    cli, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("JOUNCE_CACHE_DIR", str(tmp_path / "cache"))
    assert cli("version", "--json").json["cache_unusable"] is None
    (tmp_path / "cache").touch()  # no folder: as read-only as can be, for root, too
    assert f"{tmp_path / 'cache'} cannot be written" in " ".join(cli("version").out.split())


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish", "powershell"])
def test_a_shell_gets_its_script_and_names_of_the_library(
    shell: str, cli, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert "_JOUNCE_COMPLETE" in cli("completion", shell).out
    assert "_JOUNCE_COMPLETE" in cli("completion", shell, "--json").json["script"]
    line = "jounce simulate kart-q"
    for name, value in {
        "_JOUNCE_COMPLETE": f"complete_{shell}",
        "COMP_WORDS": line,
        "COMP_CWORD": "2",
        "_TYPER_COMPLETE_ARGS": line,
        "_TYPER_COMPLETE_FISH_ACTION": "get-args",
        "_TYPER_COMPLETE_WORD_TO_COMPLETE": "kart-q",
    }.items():
        monkeypatch.setenv(name, value)
    capsys.readouterr()
    assert main([]) == 0
    answer = capsys.readouterr().out
    assert RIG in answer
    assert "kart-double-wishbone" not in answer


def test_another_shell_is_refused_with_those_there_are(cli) -> None:
    outcome = cli("completion", "csh")
    assert outcome.exit_code == 2
    assert "'powershell'" in outcome.err


def test_completion_is_installed_where_the_shell_looks(
    cli, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("HOME", str(tmp_path))
    assert cli("completion", "fish", "--install").out.startswith(f"installed: {tmp_path}")
    [file] = tmp_path.rglob("*.fish")
    assert "_JOUNCE_COMPLETE" in file.read_text(encoding="utf-8")


def test_completion_without_a_home_is_printed_only(cli, monkeypatch: pytest.MonkeyPatch) -> None:
    def nowhere() -> Path:
        raise RuntimeError(
            "Could not determine home directory."
        )  # as pathlib says it of a user without an entry

    monkeypatch.setattr(Path, "home", nowhere)
    outcome = cli("completion", "bash", "--install")
    assert outcome.exit_code == 2
    assert "the home folder" in outcome.err
    assert "without --install" in outcome.err
    assert cli("completion", "bash").exit_code == 0


def test_tables_in_imperial_units_and_json_in_si(cli, bump: Path) -> None:
    run = ("simulate", RIG, "--road", bump, "--speed", "20 m/s", "--duration", "0.1 s")
    shown = re.sub(r"[ \n]+", " ", cli(*run, "--units", "imperial").out)
    assert "at 44.74 mph" in shown
    static = {"strut.force": "39.26", "sprung.z": "−0.3951"}  # 174.634 N, -10.0359 mm
    for name, text in static.items():
        assert re.search(rf"{re.escape(name)} +(lbf|in) +{re.escape(text)}", shown), name
    assert not re.search(r" (N|m|m/s|m/s\^2) ", shown)
    assert cli(*run, "--units", "imperial", "--json").json == cli(*run, "--json").json
    assert current_units() == "metric"  # the next command line begins anew
    assert " N " in cli(*run).out


def test_parameters_of_a_rig_in_imperial_units(cli) -> None:
    words = ("check", RIG, "--parameters")
    shown = [line.split() for line in cli(*words, "--units", "imperial").out.splitlines()]
    assert ["strut.spring.rate", "129.792", "lbf/in"] in shown  # 22.73 N/mm
    assert ["sprung.mass", "35.274", "lb"] in shown
    assert ["strut.spring.rate", "22730", "N/m"] in [
        line.split() for line in cli(*words).out.splitlines()
    ]


def printed(rows: list[tuple[str, float]], width: int = 100) -> list[str]:
    """Lines of a table as it is printed, without empty ones."""
    out = Console(file=io.StringIO(), width=width)
    out.print(table("Rates", ("name", "spring rate N/m"), rows))
    return [line.strip() for line in out.file.getvalue().splitlines() if line.strip()]


def test_a_terminal_gets_the_first_rows_and_all_on_demand(monkeypatch: pytest.MonkeyPatch) -> None:
    rows = [(f"row {i}", float(i)) for i in range(40)]
    above = 3  # title, header, line
    assert len(printed(rows)) == above + 40  # piped
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True, raising=False)
    cut = printed(rows)
    assert len(cut) == above + 21
    assert cut[-1] == "… and 20 more rows: --all"
    assert len(printed(rows[:25])) == above + 25
    monkeypatch.setattr(VIEW, "every_row", True)
    assert len(printed(rows)) == above + 40


def test_a_narrow_table_breaks_no_number() -> None:
    header = ("hardpoint of the lower arm", *(f"quantity number {k}" for k in range(6)))
    rows = [["hardpoints.lower_ball_joint[2]", *(f"{1234.5678 + k:.4f}" for k in range(6))]]
    for width in (40, 60, 80, 200):
        out = Console(file=io.StringIO(), width=width)
        out.print(FittedTable("Arm", header, rows))
        text = out.file.getvalue()
        assert max(map(len, text.splitlines())) <= width
        assert all(cell in text for cell in rows[0][1:])
        assert (text.count("hardpoints.") == 1) == (width == 200)  # each part names the row


def test_a_page_is_opened_and_a_missing_one_said(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    opened: list[str] = []
    monkeypatch.setattr(webbrowser, "open", lambda uri: not opened.append(uri))
    page, folder = tmp_path / "run.html", tmp_path / "results"
    folder.mkdir()
    for file in (page, folder / "report.html"):
        file.touch()
    open_pages({"report": str(page)})  # not asked for
    monkeypatch.setattr(VIEW, "opens", True)
    open_pages({"out": None, "figure": "a.png", "more": [{"report": page}]})
    open_pages({"out": str(folder)})
    assert opened == [page.as_uri(), (folder / "report.html").as_uri()]
    open_pages({"out": str(tmp_path / "run.nc"), "report": "gone.html"})
    said = "jounce: --open: no page was written. Ask for one, e.g. with --report page.html.\n"
    assert capsys.readouterr().err == said
    monkeypatch.setattr(webbrowser, "open", lambda _: False)
    open_pages({"report": str(page)})
    assert f"no browser was found. Open {page} in one." in capsys.readouterr().err


def test_only_what_writes_pages_opens_them(cli) -> None:
    asked = {path: "open_" in {one.name for one in command.params} for path, command in commands()}
    assert asked[("simulate",)]
    assert asked[("demo",)]
    assert asked[("animate",)]
    assert not asked[("check",)]
    assert cli("check", "x.toml", "--open").exit_code == 2


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (
            ("kinematics", "kart-double-wishbone", "--travel", "-20:20:2"),
            "20 m of travel; a bare number is in metres",
        ),
        (("kinematics", "kart-double-wishbone", "--roll", "-4:4:1"), "-4 rad is implausible"),
        (
            ("simulate", RIG, "--road", "bump.toml", "--speed", "195", "--duration", "1"),
            "'195 km/h', or '195 m/s'",
        ),
        (
            (
                "simulate",
                RIG,
                "--road",
                "bump.toml",
                "--speed",
                "2",
                "--duration",
                "1",
                "--output-step",
                "1",
            ),
            "1 s is implausible",
        ),
        (
            ("modes", RIG, "--set", "strut.spring.rate=22.73"),
            "--set strut.spring.rate: 22.73 N/m is implausible",
        ),
        (("modes", RIG, "--set", "sprung.mass=250000"), "250000 kg is implausible"),
        (("bench", "springs", "soft=22.73", "hard=33"), "22.73 N/m is implausible"),
        (("bench", "springs", "--strut-angle", "26"), "--strut-angle: 26 rad is implausible"),
        (("adjust", "kart-double-wishbone", "--camber=-2"), "--camber: -2 rad is implausible"),
        (("fit", "stiffness", "x.csv", "--discard-below", "20"), "'20 mm', or '20 m'"),
    ],
    ids=lambda value: value if isinstance(value, str) else " ".join(value),
)
def test_bare_numbers_that_cannot_be_meant_are_questioned(words, message, cli, bump: Path) -> None:
    rows = "".join(
        f"{x},{22.7 * x}\n" for x in range(30)
    )  # whether its unit is of length or angle, the file says
    bump.with_name("x.csv").write_text(f"displacement [mm],force [N]\n{rows}", encoding="utf-8")
    outcome = cli(*words)
    assert outcome.exit_code == 2
    assert message in outcome.err
    assert outcome.out == ""


def test_what_can_be_meant_or_has_its_unit_is_taken(cli) -> None:
    assert cli("modes", RIG, "--set", "strut.spring.rate=25000").exit_code == 0
    assert cli("modes", RIG, "--set", "strut.spring.rate=22.73 N/m").exit_code == 0
    assert cli("modes", RIG, "--set", "strut.spring.preload=0").exit_code == 0


@pytest.mark.parametrize(
    "words",
    [
        ("simulate", RIG, "--road", "bump.toml", "--speed", "1,95 m/s", "--duration", "1"),
        ("modes", RIG, "--set", "strut.spring.rate=22,73 N/mm"),
        ("kinematics", "kart-double-wishbone", "--travel", "-20,5 mm:20,5 mm:1 mm"),
        ("design", "springs", RIG, "--frequency", "2", "--damping-ratio", "0,3"),
    ],
    ids=" ".join,
)
def test_a_decimal_comma_is_named(words, cli, bump: Path) -> None:
    outcome = cli(*words)
    assert outcome.exit_code == 2
    assert "a comma in a number" in outcome.err
    assert "Use a decimal point and no thousands separator: '" in outcome.err


def test_time_passed_and_time_left() -> None:
    now = [0.0]
    line = Elapsed(lambda: now[0])
    line.say("loading")
    now[0] = 3.0
    assert line.text() == "loading · 3 s"
    line.say(progress_through("trial {which} of {count}: {name}", 1, 4, name="a"))
    assert line.text() == "trial 1 of 4: a · 3 s"
    now[0] = 13.0
    line.say(progress_through("trial {which} of {count}: {name}", 2, 4, name="b"))
    assert line.text() == "trial 2 of 4: b · 13 s, 25 %, about 30 s left"
    now[0] = 18.0
    assert line.text() == "trial 2 of 4: b · 18 s, 25 %, about 25 s left"
    line.say(
        Stage("testing: {percent:.0f} %", share=0.5, percent=50.0)
    )  # another phase: how much of the whole that is, nobody knows
    assert line.text() == "testing: 50 % · 18 s"
    line.waits = "compiling"
    assert line.text().startswith("compiling · 18 s")


def test_stages_count_by_their_part_of_the_whole() -> None:
    line = Elapsed(lambda: 0.0, ["bench", "update*3", "compare*2", "writing|write"])
    shares = []
    for text in (
        "bench: spring",
        progress_through("update: {which} of {count}", 2, 3),
        progress_through("compare trial {which} of {count}", 2, 2),
        "write the report",
    ):
        line.say(text)
        shares.append(line.share())
    assert shares == pytest.approx([0.0, 2.0 / 7.0, 5.0 / 7.0, 6.0 / 7.0])


def test_progress_through_several_stages_never_goes_back_and_promises_no_time() -> None:
    now = [0.0]
    line = Elapsed(lambda: now[0], ["bench", "update", "compare", "writing|write|draw"])
    assert (line.share(), line.stage()) == (None, None)
    shares = []
    for text in (
        Phrase("bench: {parts}", parts="spring"),
        progress_through("update {which} of {count}", 1, 2),
        progress_through("update {which} of {count}", 2, 2),
        progress_through("compare trial {which} of {count}", 1, 4),
        progress_through("compare trial {which} of {count}", 3, 4),
        "compare: lumped model",
        "write: results",
        progress_through("draw: figure {which} of {count}", 2, 4),
        "writing the report",
    ):
        now[0] += 5.0
        line.say(text)
        shares.append(line.share())
        assert line.left() is None
    assert shares == pytest.approx([0, 0.25, 0.375, 0.5, 0.625, 0.625, 0.75, 0.8125, 0.8125])
    assert line.stage() == (4, 4)
    assert line.text() == "writing the report · 45 s, stage 4 of 4"


def test_sizes_of_files_that_cannot_be_meant_are_questioned(
    cli, tmp_path: Path, rig_text: str
) -> None:
    (tmp_path / "high.toml").write_text(
        'kind = "half-sine"\nheight = 35\nlength = "60 mm"\n', encoding="utf-8"
    )
    (tmp_path / "soft.toml").write_text(rig_text.replace('"22.73 N/mm"', "22.73"), encoding="utf-8")
    (tmp_path / "good.toml").write_text(rig_text, encoding="utf-8")
    outcome = cli("check", "high.toml", "soft.toml", "good.toml", "--json").json
    high, soft, good = (item["notes"] for item in outcome["files"])
    assert high == [
        'warning: high.toml: height: 35 m: a number without a unit is in m; did you mean "35 mm"?'
    ]
    assert soft == [
        "warning: soft.toml: strut.spring.rate: 22.73 N/m: a number without a unit is in N/m; "
        'did you mean "22.73 N/mm"?'
    ]
    assert good == []
    asked = cli("modes", "soft.toml").err
    assert 'did you mean "22.73 N/mm"?' in asked


def test_speeds_that_cannot_be_meant_are_questioned() -> None:
    from jounce.roads.trial import trial_findings

    road = jn.HalfSine(height="10 mm", length="60 mm")
    [found] = trial_findings(jn.Trial(road=road, speed=195.0, duration=1.0))
    assert (found.place, found.value) == ("trial: speed", 195.0)
    assert found.message == '195 m/s: a number without a unit is in m/s; did you mean "195 km/h"?'
    assert trial_findings(jn.Trial(road=road, speed=19.5, duration=1.0)) == []
    lifted = jn.Trial(
        road=jn.Sine(amplitude=20.0, wavelength=1.0, length=5.0), speed=1.0, duration=1.0
    )
    assert [one.place for one in trial_findings(lifted)] == ["trial: road: amplitude"]


def test_what_is_said_of_several_places_in_the_same_words_is_one_line(capsys):
    said = [Finding(f"{name}.csv", "note", "decimal commas were read") for name in "abca"]
    show_findings(console(), [*said, Finding("b.csv", "warning", "decimal commas were read")])
    assert capsys.readouterr().out.splitlines() == [
        "note: a.csv, b.csv, c.csv: decimal commas were read",
        "warning: b.csv: decimal commas were read",
    ]
