"""The command line as a process: help, usage errors, exit codes, what stdout holds."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, get_type_hints

import pytest
from typer.main import get_command

from jounce.cli import entry, main
from jounce.cli.reply import PIPE_CLOSED
from jounce.parts import library

HEAVY = {
    "casadi",
    "matplotlib",
    "numba",
    "numpy",
    "pandas",
    "pint",
    "pydantic",
    "scipy",
    "xarray",
    "tomlkit",
}
COMMANDS = [
    ("demo",),
    ("campaign", "run"),
    ("campaign", "new"),
    ("simulate",),
    ("modes",),
    ("adjust",),
    ("plot",),
    ("check",),
    ("library",),
    ("import", "chrono"),
    ("fit", "stiffness"),
    ("fit", "decay"),
    ("fit", "damper"),
    ("bench", "speed"),
    ("bench", "drive"),
    ("bench", "scale"),
    ("bench", "springs"),
    ("study", "proving-ground"),
    ("study", "lumped-vs-spatial"),
    ("version",),
]
SCRIPT = Path(sys.executable).with_name("jounce")


def jounce(*words: object, folder: Path | None = None) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [SCRIPT, *map(str, words)], capture_output=True, text=True, check=False, cwd=folder
    )


def plain(text: str) -> str:
    return re.sub(r"\s+", " ", re.sub(r"\x1b\[[0-9;]*m|[│╭╮╰╯─]", " ", text))


def test_help_lists_every_command_and_loads_nothing_heavy() -> None:
    code = "import sys; from jounce.cli import main; main(['--help']); print(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    *help_text, names = done.stdout.splitlines()
    assert {name.partition(".")[0] for name in names.split()} & HEAVY == set()
    assert {words[0] for words in COMMANDS} <= set(plain("\n".join(help_text)).split())


def test_three_options_write_files() -> None:
    def files(command: Any) -> Iterator[str]:
        for inner in getattr(command, "commands", {}).values():
            yield from files(inner)
        kinds = get_type_hints(command.callback) if command.callback else {}
        yield from (one.opts[0] for one in command.params if "Path" in str(kinds.get(one.name)))

    written = {name for name in files(get_command(entry.application())) if name.startswith("--")}
    read = {"--excitation", "--database"}
    assert written == {"--out", "--figure", "--report"} | read


@pytest.mark.parametrize("words", COMMANDS, ids=" ".join)
def test_every_command_has_json_and_an_example(words: tuple[str, ...], cli) -> None:
    outcome = cli(*words, "--help")
    text = plain(outcome.out)
    assert outcome.exit_code == 0
    assert "--json" in text
    assert f"Example: jounce {' '.join(words)}" in text
    assert "[default: ...]" not in text


def test_text_in_brackets_survives_the_help(cli) -> None:
    assert 'force="F [kN]"' in plain(cli("fit", "stiffness", "--help").out)


def test_version_as_a_process() -> None:
    done = jounce("version", "--json")
    assert done.returncode == 0
    assert json.loads(done.stdout)["jounce"]
    assert done.stderr == ""


def test_bad_input_as_a_process(tmp_path: Path) -> None:
    done = jounce("modes", "no-such-rig.toml", "--json", folder=tmp_path)
    assert done.returncode == 2
    assert done.stderr == "jounce: no-such-rig.toml: no such file. Check the path and the name.\n"
    error = json.loads(done.stdout)["error"]
    assert (error["kind"], error["where"]) == ("DescriptionError", "no-such-rig.toml")
    assert error["what"] == "no such file"


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (
            ("simulate", "kart-quarter-car", "--sped", "2"),
            "no such option: --sped. Did you mean '--speed'?",
        ),
        (
            ("plot", "run.nc", "--channels", "z"),
            "no such option: --channels. Give the value without --channels.",
        ),
        (("simulatte",), "Did you mean 'simulate'"),
        (("fit", "stifness"), "Did you mean 'stiffness'?"),
        (("fit", "decay", "x.csv", "--chanel", "z"), "Did you mean '--channel'?"),
        (
            ("simulate",),
            "Missing argument 'RIG': a vehicle or rig file, or a name of `jounce library`.",
        ),
        (("campaign", "run", "campaign.toml"), "Missing option '--out': folder for report"),
        (("fit", "stiffness", "a.csv", "--degree", "two"), "--degree"),
    ],
)
def test_misuse_is_explained(words: tuple[str, ...], message: str, cli) -> None:
    outcome = cli(*words)
    assert outcome.exit_code == 2
    assert message in outcome.err
    assert "--help`" in outcome.err
    assert outcome.out == ""
    as_json = cli(*words, "--json")
    assert as_json.exit_code == 2
    assert as_json.json["error"]["kind"] == "UsageError"
    assert message in as_json.json["error"]["message"]


def test_groups_without_a_command_show_their_help(cli) -> None:
    for words in ((), ("fit",), ("bench",), ("campaign",)):
        outcome = cli(*words)
        assert outcome.exit_code == 2
        assert "Usage:" in outcome.out + outcome.err


def test_crash_asks_for_a_report(cli, monkeypatch: pytest.MonkeyPatch) -> None:
    def crash(*words: object) -> None:
        raise ZeroDivisionError("by hand")

    monkeypatch.setattr("jounce.parts.options.load", crash)
    outcome = cli("modes", "kart-quarter-car", "--json")
    assert outcome.exit_code == 1
    assert "ZeroDivisionError: by hand" in outcome.err
    assert "Please report it" in outcome.err
    assert outcome.json["error"]["kind"] == "unexpected"


def test_debug_shows_the_traceback(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def crash(*words: object) -> None:
        raise ZeroDivisionError("by hand")

    monkeypatch.setattr("jounce.parts.options.load", crash)
    assert main(["modes", "kart-quarter-car", "--debug"]) == 1
    assert "Traceback" in capsys.readouterr().err


def test_interrupted_run_leaves_nothing(
    cli, bump: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupt(*words: object, **options: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("jounce.simulation.trial_run.solve", interrupt)
    outcome = cli(
        "simulate",
        "kart-quarter-car",
        "--road",
        bump,
        "--speed",
        2,
        "--duration",
        1,
        "--out",
        "run.nc",
    )
    assert outcome.exit_code == 130
    assert "no file is left half-written" in outcome.err
    assert [file.name for file in tmp_path.iterdir()] == ["bump.toml"]


@pytest.mark.parametrize(
    "words", [("fit", "decay", "--channel", "sprung.z", "--mass", "16 kg"), ("modes", "ä.toml")]
)
def test_terminal_without_unicode(words: tuple[str, ...], decay_file: Path) -> None:
    given = [*words, decay_file] if words[0] == "fit" else [*words, "--json"]
    environment = {**os.environ, "PYTHONIOENCODING": "ascii"}
    done = subprocess.run([SCRIPT, *given], capture_output=True, check=False, env=environment)
    assert done.returncode == (0 if words[0] == "fit" else 2)
    assert b"Traceback" not in done.stderr
    if words[0] == "modes":
        assert json.loads(done.stdout)["error"]["where"] == "ä.toml"


@pytest.mark.parametrize(
    ("environment", "shown"),
    [
        ({"LC_ALL": "C"}, "Prüfling-車.toml"),
        (
            {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"},
            r"Pr\xfcfling-\u8eca.toml",
        ),
        ({"LC_ALL": "C.UTF-8", "PYTHONIOENCODING": "ascii"}, r"Pr\xfcfling-\u8eca.toml"),
        ({"LC_ALL": "C.UTF-8", "PYTHONIOENCODING": "latin-1"}, r"Prüfling-\u8eca.toml"),
    ],
    ids=["C", "C without UTF-8", "ASCII", "Latin 1"],
)
@pytest.mark.some(2)
def test_names_of_files_are_shown_whole(
    tmp_path: Path, environment: dict[str, str], shown: str
) -> None:
    """In messages and in tables, as wide as they are; where letters cannot be shown, two names are still two."""
    (tmp_path / "Prüfling-車.toml").write_text(
        library()["kart-quarter-car"].read_text(encoding="utf-8")
    )
    known = {
        name: value
        for name, value in os.environ.items()
        if not name.startswith(("LC_", "LANG", "PYTHONIO"))
    }
    words = [SCRIPT, "check", "Prüfling-車.toml", "nö-車.toml"]
    done = subprocess.run(
        words, capture_output=True, check=False, env=known | environment, cwd=tmp_path
    )
    read = environment.get("PYTHONIOENCODING", "utf-8")
    table = done.stdout.decode(read).splitlines()
    assert [line.count(shown) for line in table if "ling" in line] == [1]
    assert len({len(line.rstrip("\n").rstrip()) for line in table if line.startswith("|")}) <= 1
    words = [SCRIPT, "modes", "Prüfling-車.tomI"]
    done = subprocess.run(
        words, capture_output=True, check=False, env=known | environment, cwd=tmp_path
    )
    assert shown.replace(".toml", ".tomI") in done.stderr.decode(read)


def test_reader_that_goes_away_is_no_error() -> None:
    read, write = os.pipe()
    os.close(read)
    done = subprocess.run(
        [SCRIPT, "library"], stdout=write, stderr=subprocess.PIPE, text=True, check=False
    )
    os.close(write)
    assert done.stderr == ""
    assert done.returncode == PIPE_CLOSED


def test_file_that_cannot_be_written_is_explained(
    cli, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*words: object, **options: object) -> None:
        raise OSError(28, "No space left on device", "run.nc")

    monkeypatch.setattr("jounce.roads.options.trial_of_options", full)
    outcome = cli("simulate", "kart-quarter-car")
    assert outcome.exit_code == 2
    assert "run.nc: No space left on device" in outcome.err


def test_json_is_alone_on_stdout(cli, monkeypatch: pytest.MonkeyPatch) -> None:
    """What a library prints meanwhile goes to stderr."""

    def chatter(*words: object) -> dict[str, float]:
        print("chatter")  # noqa: T201
        return {}

    monkeypatch.setattr("jounce.ride.modal.equilibrium", chatter)
    outcome = cli("modes", "kart-quarter-car", "--json")
    assert outcome.json["equilibrium"] == {}
    assert "chatter" in outcome.err


def test_application_is_built_once_per_call() -> None:
    assert entry.application() is not entry.application()


def test_module_ends_with_the_exit_code_of_the_command() -> None:
    done = subprocess.run(
        [sys.executable, "-m", "jounce", "modes", "no-such-rig"], capture_output=True, check=False
    )
    assert done.returncode == 2


def test_matrices_get_one_thread_unless_the_user_says_otherwise():
    code = "import os; from jounce.cli import main; main(['version']); print(os.environ['OPENBLAS_NUM_THREADS'])"
    bare = {name: value for name, value in os.environ.items() if "THREADS" not in name}
    for told, used in ((bare, "1"), (bare | {"OPENBLAS_NUM_THREADS": "3"}, "3")):
        done = subprocess.run(
            [sys.executable, "-c", code], env=told, capture_output=True, text=True, check=True
        )
        assert done.stdout.splitlines()[-1] == used
