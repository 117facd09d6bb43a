"""``jounce sweep``: from a study to shards, statistics, pictures and report; what stops it, and what is refused."""

from __future__ import annotations

import csv
import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.core.optional import how_to_install
from jounce.variants import shards, workers

STUDY = """schema = "jounce.sweep/1"
rig = "audi-a6-quarter-car"
metrics = ["rms sprung.az", "max tyre.force"]

[trial]
speed = "10 m/s"
duration = "0.5 s"
road = {kind = "half-sine", height = "10 mm", length = "1 m"}

[design]
kind = "sobol"
count = 32
seed = 3

[vary]
"strut.damper.coefficient" = "40 %"
"sprung.mass" = ["400 kg", "520 kg"]
"""


@pytest.fixture
def study(tmp_path: Path):
    def write(text: str = STUDY) -> Path:
        file = tmp_path / "study.toml"
        file.write_text(text, encoding="utf-8")
        return file

    return write


def test_a_sweep_that_is_interrupted_goes_on_to_the_same_results(
    cli, study, tmp_path: Path, monkeypatch
) -> None:
    monkeypatch.setattr(shards, "_size", lambda *_: 8)
    run, worked = workers.shard_of, []

    def interrupted(work, task, threads):
        if task.number == 2 and len(worked) == 2:
            raise KeyboardInterrupt
        worked.append(task.number)
        return run(work, task, threads)

    monkeypatch.setattr(workers, "shard_of", interrupted)
    file = study()
    outcome = cli("sweep", file, "--out", "out")
    assert outcome.exit_code == 130
    assert "--resume goes on" in outcome.err
    assert worked == [0, 1]
    assert jn.load_sweep(tmp_path / "out").sizes["variant"] == 16
    assert sorted(one.name for one in (tmp_path / "out").iterdir()) == ["shards", "sweep.json"]
    refused = cli("sweep", file, "--out", "out")
    assert refused.exit_code == 2
    assert "2 of 4 shards" in refused.err
    worked.append(-1)
    outcome = cli("sweep", file, "--out", "out", "--resume", "--json")
    assert outcome.exit_code == 0, outcome.err
    assert worked == [0, 1, -1, 2, 3]
    found = outcome.json["summary"]
    assert (found["count"], found["ran"], found["failed"]) == (32, 32, {})
    assert outcome.json == json.loads(
        (tmp_path / "out" / "summary.json").read_text(encoding="utf-8")
    )
    whole = jn.simulate_many(
        jn.load("audi-a6-quarter-car"),
        jn.Trial(speed=10.0, duration=0.5, road=jn.HalfSine(height=0.01, length=1.0)),
        jn.sobol({"strut.damper.coefficient": "40 %", "sprung.mass": [400.0, 520.0]}, 32, seed=3),
        metrics=["rms sprung.az", "max tyre.force"],
    )
    (first, _) = found["metrics"]
    values = whole["rms sprung.az"].to_numpy()
    assert first["mean"] == pytest.approx(values.mean(), rel=1e-12)
    assert first["standard_deviation"] == pytest.approx(values.std(ddof=1), rel=1e-12)
    assert (first["least_at"], first["greatest_at"]) == (values.argmin(), values.argmax())
    low, high = first["percentiles"]["50"]["interval"]
    assert low < first["percentiles"]["50"]["value"] < high
    assert first["percentiles"]["5"]["interval"] is None  # of 32, too few to tell
    with (tmp_path / "out" / "variants.csv").open(encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    assert [int(row["variant"]) for row in rows] == list(range(32))
    assert np.array([float(row["rms sprung.az [m/s^2]"]) for row in rows]) == pytest.approx(
        values, rel=1e-12
    )
    page = (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
    assert f"jounce sweep {file}" not in page  # what was typed is known from the shell only
    for words in (
        "32 of 32 variants ran",
        "What rms sprung.az depends on",
        "greatest rms sprung.az (variant",
        "seed = 3",
    ):
        assert words in page
    for name in ("tornado", "scatter", "parallel"):
        assert (tmp_path / "out" / f"{name}.png").stat().st_size > 5000


def test_variants_without_a_run_are_told(cli, study) -> None:
    list_ = 'kind = "list"\n[vary]\n"sprung.mass" = [400, 450, -5]\n'
    text = STUDY[: STUDY.index('kind = "sobol"')] + list_
    outcome = cli("sweep", study(text), "--out", "out")
    assert outcome.exit_code == 0
    assert "2 of 3 variants ran" in outcome.out
    assert "Variants without a run" in outcome.out
    assert "sprung.mass" in outcome.out
    outcome = cli(
        "sweep", study(text.replace("[400, 450, -5]", "[-1, -2]")), "--out", "none", "--json"
    )
    assert outcome.exit_code == 1
    assert outcome.json["summary"]["ran"] == 0
    assert outcome.json["summary"]["metrics"] == []


WRONG = {
    "a path": (
        '"sprung.mass" =',
        '"sprung.mas" =',
        "study.toml, line 17: vary.sprung.mas",
        "sprung.mass",
    ),
    "a spread": (
        '"40 %"',
        '"forty"',
        "study.toml, line 16: vary.strut.damper.coefficient",
        "invalid share",
    ),
    "an empty range": (
        '["400 kg", "520 kg"]',
        '["520 kg", "520 kg"]',
        "line 17: vary.sprung.mass",
        "invalid range",
    ),
    "a unit": ('"400 kg"', '"400 m"', "line 17: vary.sprung.mass[0]", "wrong unit"),
    "a metric": ("max tyre.force", "maximum tyre.force", "study.toml, line 3: metrics", "'max'"),
    "a quantity of kinematics": (
        "max tyre.force",
        "range toe",
        "study.toml, line 3: metrics",
        "jn.sweep_variants",
    ),
    "no results to store": (
        'metrics = ["rms sprung.az", "max tyre.force"]\n',
        "",
        "study.toml: metrics",
        "no results are stored",
    ),
    "a count": ("count = 32", "", "study.toml", "needs a count"),
    "a kind": ('"sobol"', '"sobel"', "study.toml, line 11: design.kind", "'sobol'"),
    "a seed": ("seed = 3", "seed = -3", "study.toml, line 13: design.seed", "0"),
    "a trial": ('speed = "10 m/s"', 'sped = "10 m/s"', "study.toml, line 6: trial.sped", "speed"),
    "a road": ('"half-sine"', '"half-sin"', "study.toml, line 8: trial.road.kind", "half-sine"),
    "a rig": (
        '"audi-a6-quarter-car"',
        '"audi-a6-quarter"',
        "study.toml: rig",
        "audi-a6-quarter-car",
    ),
    "a schema": ("jounce.sweep/1", "jounce.sweep/2", "study.toml", "jounce.sweep/1"),
    "an empty study": (STUDY, "", "study.toml", "empty"),
}


@pytest.mark.parametrize("name", WRONG)
def test_what_is_wrong_is_said_with_its_line(cli, study, tmp_path: Path, name: str) -> None:
    old, new, where, named = WRONG[name]
    assert old in STUDY
    file = study(STUDY.replace(old, new))
    outcome = cli("sweep", file, "--out", "out", "--json")
    assert outcome.exit_code == 2
    assert where in outcome.json["error"]["message"]
    assert named in outcome.json["error"]["message"]
    assert outcome.err.count("jounce: ") == 1
    assert not (tmp_path / "out").exists()
    checked = cli("check", file, "--json")
    assert checked.exit_code == 2
    if name != "a schema":  # there any of all kinds would do
        assert outcome.json["error"]["message"] in checked.json["files"][0]["problems"]


def test_check_tells_what_a_study_is(cli, study) -> None:
    outcome = cli("check", study(), "--json")
    assert outcome.exit_code == 0
    assert (
        outcome.json["files"][0]["what"]
        == "sweep of audi-a6-quarter-car: 32 variants of 2 numbers, 2 metrics"
    )
    assert cli("sweep", study(), "--out", "out", "--resume", "--force").exit_code == 2


def test_roads_are_tables_files_or_classes(study, tmp_path: Path) -> None:
    from jounce.variants.study import read_sweep

    inline = 'road = {kind = "half-sine", height = "10 mm", length = "1 m"}'
    as_table = read_sweep(study()).work.study.trial
    (tmp_path / "bump.toml").write_text(
        'kind = "half-sine"\nheight = "10 mm"\nlength = "1 m"\n', encoding="utf-8"
    )
    assert (
        read_sweep(study(STUDY.replace(inline, 'road = "bump.toml"'))).work.study.trial == as_table
    )
    rough = read_sweep(study(STUDY.replace(inline, 'road = "iso:C:7"'))).work.study.trial.road
    assert (rough.class_, rough.seed, rough.length) == ("C", 7, 5.0)
    rows = "".join(f"{k / 100},{1e-3 * (k % 7)}\n" for k in range(60))
    (tmp_path / "base.csv").write_text(f"time [s], road.z [m]\n{rows}", encoding="utf-8")
    shaken = STUDY.replace(inline, 'excitation = "base.csv"').replace('speed = "10 m/s"\n', "")
    assert read_sweep(study(shaken)).work.study.trial.excitation.file == tmp_path / "base.csv"


def script(file: Path, out: Path, count: int) -> list[str]:
    """A process that sweeps with shards of so many variants."""
    code = (
        "import signal, sys\nfrom jounce.variants import shards\nfrom jounce.cli import main, sweep\n"
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"  # whoever runs the tests may ignore it
        f"shards._size = lambda *_: {count}\nsweep._write = lambda *_: ()\n"
        f"words = ['sweep', {str(file)!r}, '--out', {str(out)!r}, *sys.argv[1:]]\n"
        "if __name__ == '__main__':\n    sys.exit(main(words))\n"
    )
    own = out.parent / "process.py"
    own.write_text(code, encoding="utf-8")
    return [sys.executable, str(own)]


def shards_of(out: Path) -> set[str]:
    return (
        {file.name for file in (out / "shards").glob("*.nc")}
        if (out / "shards").is_dir()
        else set()
    )


def until(condition, seconds: float = 60.0) -> None:
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.01)


ALONE = STUDY.replace('["rms sprung.az", "max tyre.force"]', '["Wk sprung.az"]').replace(
    "count = 32", "count = 512"
)
ALONE = ALONE.replace('"0.5 s"', '"2.5 s"')


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGINT])
@pytest.mark.parametrize("options", [[], ["--workers", "2"]], ids=["here", "processes"])
def test_a_process_that_is_ended_leaves_whole_shards(study, tmp_path: Path, how, options) -> None:
    file, out = study(ALONE), tmp_path / "out"
    process = subprocess.Popen(
        [*script(file, out, 16), *options], stderr=subprocess.PIPE, text=True
    )
    until(lambda: len(shards_of(out)) >= 3 or process.poll() is not None)
    process.send_signal(
        how
    )  # with a killed one its workers end, too: otherwise its stderr would stay open
    _, said = process.communicate(timeout=60)
    assert process.returncode == (130 if how == signal.SIGINT else -signal.SIGKILL), said
    assert how == signal.SIGKILL or "--resume goes on" in said
    kept = shards_of(out)
    assert 3 <= len(kept) < 32
    done = subprocess.run(
        [*script(file, out, 16), "--resume", *options], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert kept < shards_of(out)
    assert len(shards_of(out)) == 32
    found = jn.load_sweep(out)["Wk sprung.az"].to_numpy()
    direct = subprocess.run(
        [*script(file, tmp_path / "direct", 512)], capture_output=True, check=False
    )
    assert direct.returncode == 0
    np.testing.assert_array_equal(
        found, jn.load_sweep(tmp_path / "direct")["Wk sprung.az"].to_numpy()
    )


@pytest.mark.slow
@pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="finds its processes by /proc")
def test_a_worker_that_is_killed_is_replaced(study, tmp_path: Path) -> None:
    file, out = study(ALONE.replace("512", "1024")), tmp_path / "out"
    process = subprocess.Popen(
        [*script(file, out, 16), "--workers", "2"], stderr=subprocess.PIPE, text=True
    )
    until(lambda: len(shards_of(out)) >= 3 or process.poll() is not None)
    children = (
        Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text(encoding="utf-8").split()
    )
    spawned = [
        int(child)
        for child in children
        if "spawn_main" in Path(f"/proc/{child}/cmdline").read_text(encoding="utf-8")
    ]
    os.kill(spawned[0], signal.SIGKILL)
    _, said = process.communicate(timeout=120)
    assert process.returncode == 0, said
    assert len(shards_of(out)) == 64
    assert not np.any(np.isnan(jn.load_sweep(out)["Wk sprung.az"]))


def test_workers_that_are_ended_again_and_again_are_told(monkeypatch) -> None:
    from concurrent.futures.process import BrokenProcessPool

    def broken(*_):
        raise BrokenProcessPool
        yield

    monkeypatch.setattr(workers, "_run_pool", broken)
    with pytest.raises(
        jn.JounceError,
        match="repeatedly killed from outside; found '3 times in a row, 1 shards left'",
    ):
        list(workers.on_processes(2, None, [workers.Task(0, 0, {}, "")]))


SCHEDULER = [
    sys.executable,
    "-m",
    "distributed.cli.dask_scheduler",
    "--host",
    "127.0.0.1",
    "--port",
    "0",
    "--no-dashboard",
]
WORKER = [
    sys.executable,
    "-m",
    "distributed.cli.dask_worker",
    "--nthreads",
    "1",
    "--no-nanny",
    "--no-dashboard",
]


@pytest.fixture
def cluster(tmp_path: Path):
    """A scheduler and two workers, each a process of its own, as on several machines: address and processes."""
    pytest.importorskip("distributed")
    about, said = tmp_path / "scheduler.json", (tmp_path / "cluster.txt").open("w")
    started = [
        subprocess.Popen([*SCHEDULER, "--scheduler-file", str(about)], stdout=said, stderr=said)
    ]
    until(lambda: about.is_file() and about.read_text(encoding="utf-8").endswith("}"))
    address = json.loads(about.read_text(encoding="utf-8"))["address"]
    started += [
        subprocess.Popen(
            [*WORKER, "--local-directory", str(tmp_path / f"w{k}"), address],
            stdout=said,
            stderr=said,
        )
        for k in range(2)
    ]
    yield address, started
    for one in reversed(started):
        one.kill()
        one.wait(timeout=30)
    said.close()


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
def test_a_cluster_of_which_a_worker_is_killed_gives_the_same_results(
    study, tmp_path: Path, cluster
) -> None:
    address, started = cluster
    file, out = study(ALONE), tmp_path / "out"
    process = subprocess.Popen(
        [*script(file, out, 16), "--cluster", address], stderr=subprocess.PIPE, text=True
    )
    until(lambda: len(shards_of(out)) >= 3 or process.poll() is not None)
    started[1].kill()
    _, said = process.communicate(timeout=300)
    assert process.returncode == 0, said
    assert len(shards_of(out)) == 32
    direct = subprocess.run(
        script(file, tmp_path / "direct", 512), capture_output=True, check=False
    )
    assert direct.returncode == 0
    name = "Wk sprung.az"
    np.testing.assert_array_equal(
        jn.load_sweep(out)[name].values, jn.load_sweep(tmp_path / "direct")[name].values
    )


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
def test_a_scheduler_that_goes_away_leaves_what_is_finished(study, tmp_path: Path, cluster) -> None:
    address, started = cluster
    file, out = study(ALONE), tmp_path / "out"
    process = subprocess.Popen(
        [*script(file, out, 16), "--cluster", address], stderr=subprocess.PIPE, text=True
    )
    until(lambda: len(shards_of(out)) >= 3 or process.poll() is not None)
    started[0].kill()
    _, said = process.communicate(timeout=300)
    assert process.returncode == 2, said
    assert "the scheduler is no longer reachable" in said
    kept = shards_of(out)
    assert 3 <= len(kept) < 32
    done = subprocess.run(
        [*script(file, out, 16), "--resume"], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert kept < shards_of(out)


class FakeCluster:
    """What is asked of a client: whether there are workers, and what they run on."""

    def __init__(self, versions: dict[str, str] | Exception) -> None:
        self.scheduler, self.versions = self, versions
        self.address = "tcp://10.0.0.5:8786"

    def wait_for_workers(self, _count: int, timeout: float) -> None:
        if self.versions == {}:
            raise TimeoutError(timeout)

    def run(self, function):
        if isinstance(self.versions, Exception):
            raise self.versions
        return {"tcp://10.0.0.6:1": function(), "tcp://10.0.0.7:1": {**function(), **self.versions}}


@pytest.mark.parametrize(
    ("versions", "said"),
    [
        ({}, "no worker has joined the cluster.*dask worker tcp://10.0.0.5:8786"),
        (
            {"jounce": "0.0.9"},
            "10.0.0.7:1: a worker has different versions; found 'jounce 0.0.9 there, ",
        ),
        ({"python": "3.8"}, "python 3.8 there"),
        (
            ModuleNotFoundError("No module named 'jounce'", name="jounce"),
            "missing on a worker; found 'jounce'",
        ),
    ],
)
def test_what_is_wrong_with_a_cluster_is_told(versions, said) -> None:
    pytest.importorskip("distributed")
    with pytest.raises(jn.JounceError, match=said):
        workers.check_cluster(FakeCluster(versions))


def test_a_scheduler_that_is_not_there(cli, study, tmp_path: Path, monkeypatch) -> None:
    pytest.importorskip("distributed")
    monkeypatch.setattr(workers, "_PATIENCE", 0.3)
    for address in ("tcp://127.0.0.1:1", "nonsense://x"):
        outcome = cli("sweep", study(), "--out", "out", "--cluster", address)
        assert outcome.exit_code == 2
        assert f"{address}: the scheduler does not answer" in outcome.err
    assert cli("sweep", study(), "--out", "out", "--cluster", "x", "--workers", 2).exit_code == 2
    assert not (tmp_path / "out").exists()


def test_without_the_extra_it_is_said_what_to_install(cli, study, monkeypatch) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    outcome = cli("sweep", study(), "--out", "out", "--cluster", "tcp://127.0.0.1:8786")
    assert outcome.exit_code == 2
    assert how_to_install("cluster") in outcome.err


def test_a_range_beyond_what_is_allowed_is_refused_with_its_line(
    cli, study, tmp_path: Path
) -> None:
    text = STUDY.replace('["400 kg", "520 kg"]', '["-1 kg", "2 kg"]')
    outcome = cli("sweep", study(text), "--out", "out")
    assert outcome.exit_code == 2
    line = text.splitlines().index('"sprung.mass" = ["-1 kg", "2 kg"]') + 1
    assert (
        f"line {line}: vary.sprung.mass: the spread exceeds the allowed range, from -1 to 2 kg"
        in outcome.err
    )
    assert "above 0 kg" in outcome.err
    assert not (tmp_path / "out").exists()
