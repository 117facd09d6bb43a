"""What is promised is tried: every version of Python in the classifiers, by workflows and by `make test-machines`."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest
import yaml

import interpreters
import run
from rules import ROOT

WORKFLOWS = {
    file.name: yaml.safe_load(file.read_text(encoding="utf-8"))
    for file in ROOT.glob(".github/workflows/*")
}
TARGETS = set(
    re.findall(r"^([a-z-]+):(?!=)", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE)
)


@pytest.mark.parametrize("job", ["tests", "installed"])
def test_workflows_run_every_promised_version_on_every_system(job: str) -> None:
    matrix = WORKFLOWS["tests.yml"]["jobs"][job]["strategy"]["matrix"]
    assert matrix["python"] == run.promised()
    assert {"ubuntu-latest", "windows-latest", "macos-latest"} <= set(matrix["system"])
    assert "ubuntu-24.04-arm" in {
        *matrix["system"],
        *(one["system"] for one in matrix.get("include", ())),
    }


def test_workflows_call_targets_that_there_are() -> None:
    jobs = [job for workflow in WORKFLOWS.values() for job in workflow["jobs"].values()]
    steps = [
        step["run"]
        for job in jobs
        for step in job["steps"]
        if step.get("run", "").startswith("make ")
    ]
    assert len(steps) > 5
    for step in steps:
        assert {
            word for word in shlex.split(re.sub(r"\$\{\{.*?\}\}", "", step))[1:] if "=" not in word
        } <= TARGETS
    [machines] = [step for step in steps if "test-machines" in step]
    matrix = WORKFLOWS["tests.yml"]["jobs"]["versions"]["strategy"]["matrix"]
    assert 'MACHINES="--quick ${{ matrix.machine }}"' in machines
    assert set(matrix["machine"]) <= {one.name for one in run.MACHINES}


def test_the_style_is_that_of_the_oldest_version() -> None:
    configuration = run.configuration()
    assert configuration["project"]["requires-python"] == f">={run.OLDEST}"
    assert configuration["tool"]["mypy"]["python_version"] == run.OLDEST
    assert configuration["tool"]["ruff"]["target-version"] == f"py{run.OLDEST.replace('.', '')}"


@pytest.fixture
def kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A version manager whose shim is on the path and answers nothing, as none of its versions is selected."""

    def program(file: Path, text: str) -> None:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(f"#!/bin/sh\n{text}\n", encoding="utf-8")
        file.chmod(0o755)

    program(tmp_path / "shims" / "python3.99", "echo 'python3.99: command not found' >&2; exit 127")
    program(tmp_path / "versions" / "3.99.1" / "bin" / "python3.99", "echo 3.99 there")
    program(tmp_path / "versions" / "3.99.0" / "bin" / "python3.99", "echo 3.98 damaged")
    monkeypatch.setenv("PATH", str(tmp_path / "shims"))
    monkeypatch.setattr(interpreters, "KEPT", (tmp_path / "versions",))
    interpreters.place_of.cache_clear()
    return tmp_path


@pytest.mark.skipif(
    not Path("/bin/sh").exists(), reason="the version manager is a script of the shell"
)
def test_an_interpreter_that_a_version_manager_keeps_is_found(kept: Path) -> None:
    place = interpreters.place_of("3.99", kept / "no-uv")
    assert place == interpreters.Place(str(kept / "versions" / "3.99.1" / "bin" / "python3.99"))


def test_a_promised_version_that_was_not_run_is_in_the_summary(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(run, "BUILD", tmp_path)
    monkeypatch.setattr(run, "place_of", lambda *_: None)
    monkeypatch.setattr("sys.argv", ["run.py", "--quick"])
    assert run.main() == 0  # what is not there is no failure, and is said
    summary = (tmp_path / "summary.txt").read_text(encoding="utf-8")
    for version in set(run.promised()) - {run.HERE}:
        assert f"Python {version}: promised, and not run" in summary
    assert f"{run.RED}lowest: not run" in capsys.readouterr().out
    assert 'grep "not run" build/machines/summary.txt' in (ROOT / ".ci" / "run").read_text(
        encoding="utf-8"
    )


@pytest.mark.parametrize(
    ("says", "ends"),
    [("exit 0", "passed in "), ("echo no root; exit 77", "not run: no root"), ("exit 1", "FAILED")],
)
def test_what_is_played_in_the_checkout_leaves_it_there(
    tmp_path: Path, monkeypatch, says: str, ends: str
) -> None:
    script = tmp_path / "tests" / "machines" / "debian.sh"
    script.parent.mkdir(parents=True)
    script.write_text(f"#!/bin/sh\n{says}\n", encoding="utf-8")
    script.chmod(0o755)
    monkeypatch.setattr(run, "ROOT", tmp_path)
    monkeypatch.setattr(run, "BUILD", tmp_path)
    [blis] = [one for one in run.MACHINES if one.name == "debian-blis-serial"]
    [(_, result)] = run.results([blis], quick=True)
    assert result.startswith(ends)
    assert script.exists()


def test_other_processors_are_played_and_rounding_in_every_change() -> None:
    rounded = [one for one in run.MACHINES if "--rounded" in one.arguments]
    assert {f"--rounding-noise={seed}" for seed in range(1, 6)} <= {
        word for one in rounded for word in one.arguments
    }
    kinds = {one.name.partition("-")[0] for one in rounded}
    by_hand = {"debian", "threads", "x86"}
    assert kinds - by_hand == {one.name.partition("-")[0] for one in rounded if one.quick}
    assert {"noise", "threads", "debian"} <= kinds
    assert not any(
        "OPENBLAS_CORETYPE" in one.environment for one in rounded
    )  # some machines need the one they have
