"""What the tests of the faces share: the command line as a function, and small measured files."""

from __future__ import annotations

import json
import shutil
import threading
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import jounce as jn
from jounce.cli import main
from jounce.web import command as _workbench  # noqa: F401 - it adds its command

Cli = Callable[..., "Outcome"]
CHROMIUM = shutil.which("chromium") or shutil.which("google-chrome")


@dataclass(frozen=True)
class Outcome:
    exit_code: int
    out: str
    err: str

    @property
    def json(self) -> dict[str, Any]:
        """The one strict JSON object on stdout."""

        def refuse(constant: str) -> None:
            raise AssertionError(f"{constant} is not JSON")

        found = json.loads(self.out, parse_constant=refuse)
        assert isinstance(found, dict)
        return found


@pytest.fixture
def cli(capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Cli:
    """Run ``jounce`` with words in an empty folder."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("COLUMNS", raising=False)  # what runs the tests side by side sets it

    def run(*words: object) -> Outcome:
        capsys.readouterr()
        exit_code = main([str(word) for word in words])
        out, err = capsys.readouterr()
        assert "Traceback" not in out + err
        return Outcome(exit_code, out, err)

    return run


@pytest.fixture
def bump(tmp_path: Path) -> Path:
    file = tmp_path / "bump.toml"
    file.write_text(
        'kind = "half-sine"\nheight = "10 mm"\nlength = "60 mm"\nstart = "0.2 m"\n',
        encoding="utf-8",
    )
    return file


@pytest.fixture
def spring_files(tmp_path: Path) -> list[Path]:
    """Three trials of a spring of 22.73 N/mm, with its unloading branch."""
    way = np.concatenate([np.linspace(0.0, 15.0, 31), np.linspace(14.5, 0.0, 30)])
    files = []
    for i, rate in enumerate((22.70, 22.73, 22.76), 1):
        file = tmp_path / f"spring_{i}.csv"
        rows = "\n".join(f"{x:.6g}, {rate * x:.8g}" for x in way)
        file.write_text(f"displacement [mm], force [N]\n{rows}\n", encoding="utf-8")
        files.append(file)
    return files


@pytest.fixture
def decay_file(tmp_path: Path) -> Path:
    """Free decay of 16 kg: damping ratio 0.11, 14.71 N of dry friction, 33.9 rad/s."""
    from jounce.identify.free_response import DecayParameters, decay_response

    time = np.arange(0.0, 2.0, 1e-3)
    height = decay_response(
        time, DecayParameters(33.9, 0.11, 0.8e-3, 0.0, 0.2, 0.020), "displacement"
    )
    file = tmp_path / "decay.csv"
    rows = "\n".join(f"{t:.4f}, {1e3 * z:.12g}" for t, z in zip(time, height, strict=True))
    file.write_text(f"time [s], sprung.z [mm]\n{rows}\n", encoding="utf-8")
    return file


@pytest.fixture
def rig_text() -> str:
    return (
        'schema = "jounce.rig/1"\nmodel = "quarter-car"\n[sprung]\nmass = "16 kg"\n[unsprung]\nmass = "5 kg"\n'
        '[strut]\nspring = {rate = "22.73 N/mm"}\ndamper = {coefficient = "150 N*s/m"}\n'
        '[tyre]\nstiffness = "138468 N/m"\n'
    )


CAMPAIGN = """schema = "jounce.campaign/1"
rig = "rig.toml"
[bench.spring]
files = ["spring_*.csv"]
[roads.A]
kind = "half-sine"
height = "10 mm"
length = "60 mm"
start = "0.2 m"
[[trial]]
number = 1
speed = "1.95 m/s"
road = "A"
recording = "trial_1.csv"
use = "fit"
[[trial]]
number = 2
speed = "3.79 m/s"
road = "A"
recording = "trial_2.csv"
[[update]]
name = "damper"
free = {"strut.damper.coefficient" = "50 %"}
trials = [1]
"""


@pytest.fixture
def campaign(bump: Path, spring_files: list[Path], rig_text: str, tmp_path: Path) -> Path:
    """A small campaign whose recordings come from a rig with another damper."""
    (tmp_path / "rig.toml").write_text(rig_text, encoding="utf-8")
    rig = jn.load(tmp_path / "rig.toml").with_changes({"strut.damper.coefficient": 180.0})
    for number, speed in ((1, "1.95 m/s"), (2, "3.79 m/s")):
        run = jn.simulate(rig, jn.Trial(road=jn.load_road(bump), speed=speed, duration="0.4 s"))
        jn.write_recording(run[["sprung.az", "unsprung.az"]], tmp_path / f"trial_{number}.csv")
    file = tmp_path / "campaign.toml"
    file.write_text(CAMPAIGN, encoding="utf-8")
    return file


@pytest.fixture(scope="module")
def workbench(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[tuple[Path, int]]:
    """A project's folder and the port of the workbench served over it, whose token is the ``TOKEN`` of the module."""
    import uvicorn

    from jounce.web.app import create_app
    from jounce.web.serving import _listening

    folder = tmp_path_factory.mktemp("project")
    listening = _listening(0)
    port = listening.getsockname()[1]
    ready = threading.Event()
    app = create_app(folder, token=request.module.TOKEN, port=port, ready=ready.set)
    config = uvicorn.Config(
        app, log_level="error", ws="websockets-sansio", timeout_graceful_shutdown=1
    )
    server = uvicorn.Server(config)
    thread = threading.Thread(target=server.run, kwargs={"sockets": [listening]}, daemon=True)
    thread.start()
    assert ready.wait(30)
    yield folder, port
    server.should_exit = True
    thread.join(10)
    listening.close()


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    """Chromium, for whoever opens pages in it."""
    sync_api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    if CHROMIUM is None:
        pytest.skip("Chromium is not installed")
    with sync_api.sync_playwright() as playwright:
        made = playwright.chromium.launch(
            executable_path=CHROMIUM, args=["--no-sandbox", "--disable-quic"]
        )
        yield made
        made.close()
