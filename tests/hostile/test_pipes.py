"""Pipes in the place of files: each is read once, whatever its content; results may still be written to one."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
import time
from importlib import resources
from pathlib import Path

import pytest
from corpus.outputs import folder_for, targets, words

from jounce.cli import main, pipes

HAS_NAMES = os.path.exists("/dev/fd")  # noqa: PTH110 - it is no path of ours
pytestmark = pytest.mark.skipif(not HAS_NAMES, reason="there are no names of open files")
COMMAND = [sys.executable, "-m", "jounce"]
RIG = (resources.files("jounce.parts") / "library" / "kart-quarter-car.toml").read_bytes()
CSV = b"# of a bench\ntime [s],x [mm]\n" + b"".join(
    b"%.2f,%.3f\n" % (0.01 * i, i % 7) for i in range(60)
)
ROAD = b'schema = "jounce.road/1"\nkind = "step"\nheight = "10 mm"\nstart = "1 m"\n'


def run(words, folder, content=b""):
    """Run a command that reads some content from its standard input."""
    environment = {**os.environ, "TMPDIR": str(folder)}
    ended = subprocess.run(
        [*COMMAND, *words],
        cwd=folder,
        env=environment,
        input=content,
        capture_output=True,
        check=False,
    )
    assert not list(folder.glob(".jounce-*"))
    return ended


@pytest.fixture
def written(tmp_path, request):
    """A short run in a format, as bytes."""
    file = tmp_path / f"run{request.param}"
    words = [
        "simulate",
        "kart-quarter-car",
        "--road",
        "detrended_rms_course_1in",
        "--speed",
        "2 m/s",
    ]
    assert run([*words, "--duration", "0.2 s", "--out", file.name], tmp_path).returncode == 0
    content = file.read_bytes()
    file.unlink()
    return content


@pytest.mark.parametrize("name", ["/dev/stdin", "/dev/fd/0"])
def test_a_rig(tmp_path, name):
    ended = run(["modes", name, "--json"], tmp_path, RIG)
    assert ended.returncode == 0, ended.stderr
    assert b"stdin.toml" in ended.stdout


def test_a_rig_from_a_file_and_a_socket(tmp_path):
    file = tmp_path / "rig"
    file.write_bytes(RIG)
    with file.open("rb") as opened:
        ended = subprocess.run(
            [*COMMAND, "modes", "/dev/stdin"], stdin=opened, capture_output=True, check=False
        )
    assert ended.returncode == 0, ended.stderr


def test_the_shell_s_own_pipes(tmp_path):
    (tmp_path / "rig.toml").write_bytes(RIG)
    line = f"{sys.executable} -m jounce check <(cat rig.toml) <(cat rig.toml) --json"
    ended = subprocess.run(["bash", "-c", line], cwd=tmp_path, capture_output=True, check=False)
    assert ended.returncode == 0, ended.stderr
    assert ended.stdout.count(b"quarter-car with") == 2


@pytest.mark.parametrize(
    ("content", "kind"),
    [(CSV, b"recording"), (ROAD, b"road"), (RIG, b"rig")],
    ids=["text", "road", "rig"],
)
def test_what_a_pipe_holds_is_seen_from_its_content(tmp_path, content, kind):
    ended = run(["check", "/dev/stdin", "--json"], tmp_path, content)
    assert ended.returncode == 0, ended.stderr
    assert b'"kind": "%s"' % kind in ended.stdout


@pytest.mark.parametrize(
    "written",
    [
        ".nc",
        ".csv",
        ".xlsx",
        *(pytest.param(x, marks=pytest.mark.slow) for x in (".parquet", ".mat")),
    ],
    indirect=True,
)
def test_recordings(tmp_path, written):
    ended = run(["check", "/dev/stdin", "--json"], tmp_path, written)
    assert ended.returncode == 0, ended.stderr
    assert b"sprung.az" in ended.stdout or b"recording" in ended.stdout


def test_an_option_and_a_result(tmp_path):
    words = [
        "simulate",
        "kart-quarter-car",
        "--road=/dev/stdin",
        "--speed",
        "2 m/s",
        "--duration",
        "1 s",
        "--json",
    ]
    ended = run(words, tmp_path, ROAD)
    assert ended.returncode == 0, ended.stderr


def filled(pipe, content):
    """Write into a pipe as another program does; give the thread."""
    os.mkfifo(pipe)
    thread = threading.Thread(target=pipe.write_bytes, args=(content,))
    thread.start()
    return thread


@pytest.mark.parametrize("name", ["rig", "rig.toml"])
def test_a_pipe_that_has_a_name(tmp_path, name):
    thread = filled(tmp_path / name, RIG)
    ended = run(["modes", name, "--json"], tmp_path)
    thread.join()
    assert ended.returncode == 0, ended.stderr


def test_two_pipes_of_one_name_and_an_option(tmp_path):
    both = [tmp_path / folder / "a" for folder in ("rigs", "roads")]
    for pipe in both:
        pipe.parent.mkdir()
    threads = [filled(pipe, content) for pipe, content in zip(both, (RIG, ROAD), strict=True)]
    asked = [
        "simulate",
        "rigs/a",
        "--road=roads/a",
        "--speed",
        "2 m/s",
        "--duration",
        "1 s",
        "--json",
    ]
    ended = run(asked, tmp_path)
    for thread in threads:
        thread.join()
    assert ended.returncode == 0, ended.stderr


def test_a_pipe_into_which_nobody_writes_keeps_nobody_waiting(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(pipes, "_PATIENCE", 0.1)
    os.mkfifo(tmp_path / "rig.toml")
    assert main(["modes", str(tmp_path / "rig.toml")]) == 2
    assert "no process writes into this pipe" in capsys.readouterr().err


def test_who_has_opened_a_pipe_may_take_any_time_to_write(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(pipes, "_PATIENCE", 0.1)
    pipe = tmp_path / "rig.toml"
    os.mkfifo(pipe)

    def write():
        with pipe.open("wb") as stream:
            time.sleep(0.5)
            stream.write(RIG[:20])
            stream.flush()
            stream.write(RIG[20:])

    thread = threading.Thread(target=write)
    thread.start()
    assert main(["modes", str(pipe)]) == 0, capsys.readouterr().err
    thread.join()


@pytest.mark.parametrize("target", [t for t in targets() if t[1] != "FOLDER"], ids=" ".join)
def test_no_output_takes_the_place_of_a_pipe(target, tmp_path_factory, monkeypatch, capsys):
    """A pipe that others hold was replaced under --force."""
    monkeypatch.chdir(
        tmp_path_factory.getbasetemp()
    )  # where the files of all targets are made once
    command, option, suffix = target
    with folder_for(command):
        pipe = Path(f"x{suffix}")
        os.mkfifo(pipe)
        place = "there already" if option == "--store" else "there already, --force"
        code = main(words((command, option, suffix, place), pipe.name))
        assert code == 2
        assert pipe.is_fifo()
        said = capsys.readouterr().err
        assert said.count("jounce: ") == 1
        assert (
            "a pipe or a device" in said
            or "is a file, not a folder" in said
            or "not a file" in said
        )


@pytest.mark.parametrize("name", ["/dev/stdout", "/dev/fd/1", "/dev/null"])
def test_devices_are_no_outputs(name, tmp_path):
    if Path(name).is_file() and not Path(name).is_symlink():
        pytest.skip(f"somebody has put a file in the place of {name}")
    asked = [
        "simulate",
        "kart-quarter-car",
        "--road",
        "detrended_rms_course_1in",
        "--speed",
        "2 m/s",
    ]
    ended = run([*asked, "--duration", "0.2 s", "--out", name, "--force"], tmp_path)
    assert ended.returncode == 2
    assert b"a pipe or a device, which a file cannot replace" in ended.stderr
    assert b"--json" in ended.stderr


@pytest.mark.parametrize(
    ("name", "what"), [("folder", b"a folder, not a file"), ("/dev/null", b"a pipe or a device")]
)
def test_what_is_no_file_is_named(tmp_path, name, what):
    (tmp_path / "folder").mkdir()
    ended = run(["modes", name], tmp_path)
    assert ended.returncode == 2
    assert b": %s" % what in ended.stderr


def test_damaged_content_is_refused(tmp_path):
    for content in (b"", b"PK\x03\x04nothing", b"\xff\xfe\x00", b"\x89HDF\r\n"):
        ended = run(["check", "/dev/stdin"], tmp_path, content)
        assert ended.returncode in (1, 2), ended.stdout
        assert b"internal error" not in ended.stdout + ended.stderr
