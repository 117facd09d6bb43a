"""A project's folder that somebody else made: what is odd in it hides itself, and nothing outside of it is touched."""

from __future__ import annotations

import json
import os
import shutil
import socket
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

from jounce.core.errors import DescriptionError, OutputError

pytest.importorskip("fastapi")
from jounce.web import kept
from jounce.web.jobs import Jobs
from jounce.web.project import Project
from jounce.web.studies import swept, write_study
from jounce.web.tasks import task_of

posix = pytest.mark.skipif(sys.platform == "win32", reason="Windows has no pipes in folders")
RIG = 'schema = "jounce.rig/1"\nmodel = "quarter-car"\n'
RUN = {
    "road": {"kind": "half-sine", "height": "10 mm", "length": "60 mm"},
    "speed": "2 m/s",
    "duration": "0.2 s",
}
DEEP = 100_000
ABOUT = {"kind": "sweep", "asked": {}, "title": "Sweep", "begun": 1.0, "out": "swept", "page": ""}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A project beside a secret."""
    (tmp_path / "outside").mkdir()
    (tmp_path / "outside" / "secret.txt").write_text("secret")
    (tmp_path / "project").mkdir()
    return tmp_path / "project"


@pytest.fixture(autouse=True)
def _outside_stays(folder: Path) -> Iterator[None]:
    outside = folder.parent / "outside"
    yield
    assert [one.name for one in outside.iterdir()] == ["secret.txt"]
    assert (outside / "secret.txt").read_text() == "secret"


@pytest.fixture(autouse=True)
def _nobody_waits() -> Iterator[None]:
    """A pipe that is opened keeps a test waiting for ever: then its name is printed, and the run ends."""
    import faulthandler

    faulthandler.dump_traceback_later(300.0, exit=True)
    yield
    faulthandler.cancel_dump_traceback_later()


def _nested(place: Path, depth: int = 2000) -> None:
    """So many folders in one another, which no path is long enough for."""
    place.mkdir(parents=True)
    here = os.open(place, os.O_RDONLY)
    for _ in range(depth):
        os.mkdir("a", dir_fd=here)
        inner = os.open("a", os.O_RDONLY, dir_fd=here)
        os.close(here)
        here = inner
    os.close(here)


@pytest.fixture
def nested(folder: Path) -> Iterator[Callable[[Path], None]]:
    """Make such folders, and take them away: pytest cannot."""
    yield _nested
    subprocess.run(["rm", "-rf", str(folder)], check=True)


def _socket(place: Path) -> None:
    own = socket.socket(socket.AF_UNIX)
    before = Path.cwd()
    os.chdir(place.parent)  # a name of a socket is short
    try:
        own.bind(place.name)
    finally:
        os.chdir(before)
        own.close()


def _large(place: Path) -> None:
    with place.open("wb") as stream:
        stream.truncate(10**12)


ODD: dict[str, Callable[[Path], object]] = {
    "pipe": os.mkfifo if hasattr(os, "mkfifo") else Path.mkdir,
    "link outside": lambda place: place.symlink_to("../" * 9 + "etc/passwd"),
    "link to itself": lambda place: place.symlink_to(place.name),
    "link to a folder outside": lambda place: place.symlink_to(place.parents[3] / "outside"),
    "new file outside": lambda place: place.symlink_to(place.parents[3] / "outside" / "new"),
    "device": lambda place: place.symlink_to("/dev/zero"),
    "folder": Path.mkdir,
    "socket": _socket,
    "large": _large,
    "not UTF-8": lambda place: place.write_bytes(b'{"title": "\xff"}'),
    "half a character": lambda place: place.write_text('{"title": "\\ud800", "begun": 1.0}'),
    "no number": lambda place: place.write_text(
        '{"begun": NaN, "ended": Infinity, "at": 1e999, "when": 1e999}'
    ),
    "deep": lambda place: place.write_text("[" * DEEP + "]" * DEEP),
    "a list": lambda place: place.write_text("[1, 2]"),
    "of another kind": lambda place: place.write_text(
        '{"begun": [], "title": 1, "code": {}, "at": "x", "when": {}}'
    ),
    "half": lambda place: place.write_text('{"beg'),
}


def _plain(jobs: Jobs) -> list[dict[str, Any]]:
    """What the page gets of all jobs: it must read it."""

    def refuse(constant: str) -> None:
        raise AssertionError(constant)

    return list(
        json.loads(json.dumps(jobs._all(), ensure_ascii=False).encode(), parse_constant=refuse)
    )


@posix
@pytest.mark.parametrize("kind", ODD)
@pytest.mark.parametrize(
    "name",
    [
        "job.json",
        "end.json",
        "progress.json",
        "result.json",
        "problems.txt",
        "alive",
        "cancel",
        "report.html",
    ],
)
def test_an_odd_file_of_a_job_hides_that_job_at_most(folder: Path, name: str, kind: str) -> None:
    place = folder / ".jounce" / "jobs"
    for job in ("20260101-000000-abcdef", "000002-abcdef"):
        (place / job).mkdir(parents=True)
        (place / job / "job.json").write_text(json.dumps(ABOUT))
    odd = place / "20260101-000000-abcdef" / name
    odd.unlink(missing_ok=True)
    ODD[kind](odd)
    jobs = Jobs(Project(folder))
    found = {one["id"]: one for one in _plain(jobs)}
    assert found["000002-abcdef"]["state"] == "stopped"
    assert name != "job.json" or list(found) == ["000002-abcdef"]
    assert "root:" not in json.dumps(found)
    if name == "job.json":
        with pytest.raises(DescriptionError, match="no such job"):
            jobs.cancel(odd.parent.name)
        return
    jobs.result(odd.parent.name)
    page = jobs.page(odd.parent.name)
    assert page is None or page.lstat().st_size == 10**12 or page.read_bytes()
    assert jobs.cancel(odd.parent.name)["state"] != "running"
    jobs.forget(odd.parent.name)
    assert [one["id"] for one in _plain(jobs)] == ["000002-abcdef"]


@posix
def test_folders_that_are_no_jobs_are_left_out(
    folder: Path, nested: Callable[[Path], None]
) -> None:
    place = folder / ".jounce" / "jobs"
    (place / "000001-abcdef").mkdir(parents=True)
    (place / "000001-abcdef" / "job.json").write_text(json.dumps(ABOUT))
    for name in (
        b"\xff",
        b"000009-\xff",
        b"x",
        b"000009-abc\n",
        b"999999999999-ab",
        b"000009-..",
        b"000009-AB",
    ):
        (place / os.fsdecode(name)).mkdir()
        (place / os.fsdecode(name) / "job.json").write_text(json.dumps(ABOUT))
    (place / "000003-abc").symlink_to(folder.parent / "outside")
    (place / "000004-abc").symlink_to("000001-abcdef")
    (place / "000005-abc").write_text("")
    nested(place / "000006-abc")
    (place / "000006-abc" / "job.json").write_text(json.dumps(ABOUT))
    jobs = Jobs(Project(folder))
    assert [one["id"] for one in _plain(jobs)] == ["000006-abc", "000001-abcdef"]
    for name in (
        "000003-abc",
        "000004-abc",
        "000005-abc",
        "\udcff",
        "..",
        "",
        "000001-abcdef/../000001-abcdef",
    ):
        with pytest.raises((DescriptionError, OutputError)):
            jobs.cancel(name)
    try:
        jobs.forget("000006-abc")
    except OutputError as error:
        assert "cannot be removed" in error.what  # noqa: PT017 - newer Pythons remove it
    jobs.forget("000001-abcdef")


@posix
@pytest.mark.parametrize(
    "kind", ["pipe", "link outside", "link to a folder outside", "link to itself", "not UTF-8"]
)
@pytest.mark.parametrize(
    "where", [".jounce", ".jounce/jobs", ".jounce/history", ".jounce/versions"]
)
def test_where_the_workbench_keeps_its_own_it_follows_no_link(
    folder: Path, where: str, kind: str
) -> None:
    """The project is shown all the same; what cannot be done is refused, and says what stands there."""
    place = folder / where
    place.parent.mkdir(exist_ok=True)
    if "outside" in kind:
        place.symlink_to(folder.parent / "outside", target_is_directory=True)
    else:
        ODD[kind](place)
    (folder / "rig.toml").write_text(RIG)
    project = Project(folder)
    assert [one.path for one in project.entries()] == ["rig.toml"]
    assert (Jobs(project).all(), kept.history(project)) == ([], [])
    was = project.read("rig.toml").digest
    for known, act in (
        ("jobs", lambda: Jobs(project).begin(task_of({"kind": "new-campaign", "out": "mine"}))),
        ("versions", lambda: project.write("rig.toml", f"{RIG}#\n", was)),
        ("history", lambda: kept.keep(project, "kart-quarter-car", {}, RUN, "run")),
    ):
        if where in (".jounce", f".jounce/{known}"):
            with pytest.raises((OutputError, OSError)) as refused:
                act()
            assert not isinstance(refused.value, OutputError) or where in str(refused.value)
    assert (folder / "rig.toml").read_text() == RIG or where in (".jounce/jobs", ".jounce/history")


@posix
def test_versions_that_lead_elsewhere_are_neither_read_nor_taken_away(folder: Path) -> None:
    """A link in their place had the user's own files counted as old versions."""
    (folder / "a.toml").write_text(RIG)
    for k in range(60):
        (folder / "mine").mkdir(exist_ok=True)
        (folder / "mine" / f"{1700000000000 + k}-{k:08x}.toml").write_text(RIG)
    versions = folder / ".jounce" / "versions"
    versions.mkdir(parents=True)
    (versions / "a.toml").symlink_to("../../mine")
    project = Project(folder)
    with pytest.raises(OutputError, match="a link occupies"):
        project.write("a.toml", f"{RIG}#\n", project.read("a.toml").digest)
    assert len(list((folder / "mine").iterdir())) == 60
    (versions / "a.toml").unlink()
    (versions / "a.toml").mkdir()
    for k, name in enumerate(["pipe", "link outside", "folder", "not UTF-8", "large"]):
        ODD[name](versions / "a.toml" / f"170000000000{k}-abcdef0{k}.toml")
        with pytest.raises(DescriptionError, match="no such version"):
            project.version(f"a.toml@170000000000{k}-abcdef0{k}")
    (versions / "a.toml" / "notes.toml").write_text("mine")
    project.write("a.toml", f"{RIG}#\n", project.read("a.toml").digest)
    assert project.version(project.versions("a.toml")[0].name)[1] == RIG
    assert (versions / "a.toml" / "notes.toml").read_text() == "mine"


@posix
@pytest.mark.parametrize("kind", ODD)
def test_an_odd_run_of_the_history_is_left_out(folder: Path, kind: str) -> None:
    project = Project(folder)
    kept.keep(project, "kart-quarter-car", {}, RUN, "run")
    ODD[kind](folder / ".jounce" / "history" / "odd.json")
    found = kept.history(project)
    assert [one["path"] for one in found] == ["runs/run.nc"]
    json.dumps(found, allow_nan=False).encode()


@posix
@pytest.mark.parametrize("kind", ODD)
@pytest.mark.parametrize(
    "name", ["rig.toml", "run.csv", "page.html", "x/sweep.json", "results.json", "notes.txt"]
)
def test_an_odd_file_of_a_project_hides_itself_at_most(folder: Path, name: str, kind: str) -> None:
    (folder / "good.toml").write_text(RIG)
    (folder / name).parent.mkdir(exist_ok=True)
    place = folder / name
    if "outside" in kind:
        place.symlink_to(folder.parent / "outside")
    else:
        ODD[kind](place)
    entries = Project(folder).entries()
    assert "good.toml" in [one.path for one in entries]
    json.dumps([vars(one) for one in entries], ensure_ascii=False, allow_nan=False).encode()


@posix
def test_names_that_are_no_text_hide_themselves(folder: Path) -> None:
    for name in (
        b"good.toml",
        b"\xff.toml",
        b"\xed\xa0\x80.csv",
        b"in\xff/rig.toml",
        b"line\nbreak.toml",
    ):
        place = folder / os.fsdecode(name)
        place.parent.mkdir(exist_ok=True)
        place.write_text(RIG)
    entries = Project(folder).entries()
    assert [one.path for one in entries] == ["good.toml", "line\nbreak.toml"]


@posix
def test_folders_that_nobody_can_walk_hide_themselves(
    folder: Path, nested: Callable[[Path], None]
) -> None:
    """Two thousand in one another, below a sweep, a campaign's pattern and plainly."""
    (folder / "good.toml").write_text(RIG)
    for name in ("plain", "swept", ".jounce/versions"):
        nested(folder / name / "deep")
    (folder / "swept" / "sweep.json").write_text("{}")
    (folder / "loop").symlink_to(".", target_is_directory=True)
    project = Project(folder)
    assert {one.path for one in project.entries()} == {"good.toml", "swept"}
    project.write("good.toml", f"{RIG}#\n", project.read("good.toml").digest)
    assert len(project.versions("good.toml")) == 1


@posix
@pytest.mark.skipif(
    hasattr(os, "geteuid") and os.geteuid() != 0, reason="only root can become somebody else"
)
def test_files_and_folders_that_nobody_may_look_at_hide_themselves(
    folder: Path, tmp_path: Path
) -> None:
    """As somebody else than root, whom every folder is open to."""
    (folder / "good.toml").write_text(RIG)
    for name, mode in (("listed", 0o744), ("entered", 0o711), ("closed", 0o700)):
        (folder / name / "swept").mkdir(parents=True)
        (folder / name / "rig.toml").write_text(RIG)
        (folder / name / "swept" / "sweep.json").write_text("{}")
        (folder / name).chmod(mode)
    (folder / "mine.toml").write_text(RIG)
    (folder / "mine.toml").chmod(0o600)
    script = """if True:
        import os, sys
        from jounce.web.project import Project
        from jounce.web.jobs import Jobs
        from jounce.variants.shards import read_kept
        "".encode("utf-8-sig")  # loaded before nothing of this interpreter can be read any more
        os.setgid(65534); os.setuid(65534)
        project = Project(sys.argv[1])
        print(sorted(one.path for one in project.entries()), Jobs(project).all())"""
    (folder / ".jounce" / "jobs").mkdir(parents=True)
    (folder / ".jounce" / "jobs").chmod(0o700)
    for one in (tmp_path, *tmp_path.parents):
        if one != Path("/") and not one.stat().st_mode & 0o005:
            one.chmod(one.stat().st_mode | 0o755)
    done = subprocess.run(
        [sys.executable, "-c", script, str(folder)], capture_output=True, text=True, check=False
    )
    assert (done.stdout, done.returncode) == ("['good.toml'] []\n", 0), done.stderr[-2000:]


@pytest.mark.parametrize(
    "about",
    [
        {"count": 10**18, "shard": 1},
        {"count": 1e308, "shard": 1},
        {"count": float("inf"), "shard": 1},
        {"count": 1, "shard": 0},
        {"count": "1", "shard": "x"},
        {"count": [1], "shard": 1},
    ],
    ids=str,
)
def test_a_sweep_of_any_size_may_be_claimed(folder: Path, about: dict[str, Any]) -> None:
    from jounce.variants.shards import SCHEMA

    (folder / "swept").mkdir()
    whole = {"schema": SCHEMA, "study": {}, **about}
    (folder / "swept" / "sweep.json").write_text(json.dumps(whole))
    (entry,) = Project(folder).entries()
    assert (entry.path, entry.count) == ("swept", None)
    with pytest.raises(OutputError, match="does not describe a sweep"):
        swept(Project(folder), "swept")


@posix
def test_a_shard_that_is_a_pipe_or_damaged_is_no_shard(folder: Path) -> None:
    from hashlib import sha256

    from jounce.core.errors import JounceError
    from jounce.variants.shards import SCHEMA
    from jounce.variants.zarr_shards import checksum

    place = folder / "swept" / "shards"
    place.mkdir(parents=True)
    about = {"schema": SCHEMA, "count": 2, "shard": 1, "study": {}}
    (folder / "swept" / "sweep.json").write_text(json.dumps(about))
    os.mkfifo(place / f"000000.{sha256(b'').hexdigest()[:32]}.nc")
    assert swept(Project(folder), "swept")["finished"] == 0
    (place / f"000001.{checksum(b'no more')}.nc").write_bytes(b"no more")
    with pytest.raises(JounceError):
        swept(Project(folder), "swept")


@posix
def test_a_study_is_tried_in_a_file_of_its_own(folder: Path) -> None:
    """The name that it had was known: a link, or a pipe, could lie there."""
    study = {"rig": "kart-quarter-car", "trial": RUN, "design": {"kind": "grid"}, "metrics": ["max sprung.az"],
             "vary": {"strut.spring.rate": ["20 N/mm"]}}  # fmt: skip
    (folder / ".study.trial.toml").symlink_to(folder.parent / "outside" / "new.toml")
    os.mkfifo(folder / ".other.trial.toml")
    for name in ("study", "other"):
        assert write_study(Project(folder), f"{name}.toml", study)["count"] == 1


def test_of_two_who_save_at_once_one_is_refused(folder: Path) -> None:
    """Both had read the same file: both were told that theirs is saved, and one was gone."""
    project = Project(folder)
    was = project.write("rig.toml", RIG).digest
    for turn in range(20):
        texts = [f"{RIG}# {turn} {who}\n" for who in range(4)]
        start = threading.Barrier(4)

        def save(text: str, was: str = was, start: threading.Barrier = start) -> str:
            start.wait()
            try:
                return project.write("rig.toml", text, was).digest
            except OutputError:
                return ""

        with ThreadPoolExecutor(4) as four:
            saved = [one for one in four.map(save, texts) if one]
        assert len(saved) == 1
        was = saved[0]
        assert project.read("rig.toml").digest == was


def test_of_two_servers_that_save_at_once_one_is_refused(folder: Path) -> None:
    project = Project(folder)
    project.write("rig.toml", 'n = "0"\n')
    script = """if True:
        import sys
        from jounce.web.project import Project
        from jounce.core.errors import OutputError
        project, saved = Project(sys.argv[1]), 0
        while saved < 50:
            now = project.read("rig.toml")
            number = int(now.text.split('"')[1])
            try:
                project.write("rig.toml", f'n = "{number + 1}"\\n', now.digest)
                saved += 1
            except OutputError:
                pass"""
    both = [subprocess.Popen([sys.executable, "-c", script, str(folder)]) for _ in range(2)]
    assert [one.wait(120) for one in both] == [0, 0]
    assert project.read("rig.toml").text == 'n = "100"\n'


def test_of_two_who_keep_a_run_under_one_title_one_is_refused(folder: Path) -> None:
    """The history said of the run that was kept what the other was made of."""
    project = Project(folder)

    def keep(mass: float) -> dict[str, Any] | None:
        try:
            return kept.keep(project, "kart-quarter-car", {"sprung.mass": mass}, RUN, "run")
        except OutputError:
            return None

    with ThreadPoolExecutor(2) as both:
        (made,) = [one for one in both.map(keep, (16.0, 20.0)) if one]
    assert kept.history(project) == [made]
    shutil.rmtree(folder / ".jounce")
    assert kept.history(project) == []
    again = keep(
        made["changes"]["sprung.mass"]
    )  # it was written, and nothing of it into the history
    assert again is not None
    assert kept.history(project) == [again]
    assert keep(made["changes"]["sprung.mass"]) is None
    shutil.rmtree(folder / ".jounce")
    assert keep(1.0) is None  # another run
