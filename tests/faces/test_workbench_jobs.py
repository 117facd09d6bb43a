"""Long work of the workbench: in processes of its own, known from the disk, and kept to the folder."""

from __future__ import annotations

import json
import os
import shlex
import signal
import socket
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any

import pytest

from jounce.cli.reply import followed_by, progress
from jounce.core.errors import DescriptionError, JounceError, OutputError
from jounce.core.files import always_below, existing_file
from jounce.core.waiting import progress_through
from jounce.web.jobs import _is_over
from jounce.web.project import Project
from jounce.web.tasks import spec_of, task_of

uvicorn = pytest.importorskip("uvicorn")
client = pytest.importorskip("websockets.sync.client")
TOKEN = "a-token-of-these-tests"
STUDY = """schema = "jounce.sweep/1"
rig = "kart-quarter-car"
metrics = ["max sprung.az"]
trial = {speed = "2 m/s", duration = "1 s", road = {kind = "half-sine", height = "10 mm", length = "60 mm"}}
design = {kind = "monte-carlo", count = COUNT}
vary = {"strut.spring.rate" = "20 %"}
"""


def _jobs(folder: Path) -> Any:
    from jounce.web.jobs import Jobs

    return Jobs(Project(folder))


def _ended(jobs: Any, name: str, seconds: float = 120.0) -> dict[str, Any]:
    end = time.monotonic() + seconds
    while (state := jobs.state(name))["state"] in ("running", "cancelling"):
        assert time.monotonic() < end
        time.sleep(0.05)
    return dict(state)


SWEEP = {"kind": "sweep", "study": "study.toml", "out": "swept"}
HOSTILE = ["--help", "--out=/etc", "$(id)", "; rm -rf .", "\n--force", "../../x"]


@pytest.mark.parametrize("text", HOSTILE)
def test_what_a_field_holds_is_never_another_option(tmp_path, text):
    (tmp_path / "a.csv").write_text("")
    project = Project(tmp_path)
    fields = {
        "vehicle": "kart-quarter-car",
        "road": text,
        "speed": text,
        "duration": text,
        "control": [text],
    }
    for task in (
        {"kind": "compare", **fields, "changes": {text: text}},
        {
            "kind": "pareto",
            "vehicle": "kart-quarter-car",
            "free": {text: text},
            "road": text,
            "speed": text,
        },
        {
            "kind": "evaluate",
            "records": ["a.csv"],
            "tester": "eusama",
            "plate": text,
            "methods": [text],
        },
        {
            "kind": "decay",
            "files": ["a.csv"],
            "mass": text,
            "channel": text,
            "columns": {text: text},
        },
    ):
        doing = spec_of(task_of(task), project)
        options = [word for word in doing.words if text in word]
        assert options
        assert all(word.startswith("--") and "=" in word.partition(text)[0] for word in options)
    tester = {"kind": "evaluate", "records": ["a.csv"], "tester": text}
    with pytest.raises(DescriptionError, match="unknown tester"):
        spec_of(task_of(tester), project)


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("±30 %", "±30 %"),
        ("1..3 mm", ("1 mm", "3 mm")),
        ("1 mm..3 cm", ("1 mm", "3 cm")),
        ("300..6000", (300.0, 6000.0)),
        ("-1e-3 .. 2 mm", ("-1e-3 mm", "2 mm")),
    ],
)
def test_bounds_mean_in_python_what_they_mean_on_the_command_line(tmp_path, text, meant):
    task = {"kind": "pareto", "vehicle": "kart-quarter-car", "free": {"tyre.stiffness": text}}
    assert f"{{'tyre.stiffness': {meant!r}}}" in spec_of(task_of(task), Project(tmp_path)).python


def _by_python_and_command(
    folder: Path, task: dict[str, Any], cli: Any, **more: Any
) -> tuple[dict[str, Any], dict[str, Any]]:
    """What Python leaves in its names, then what the command prints; ``more`` is asked of the command only."""
    names: dict[str, Any] = {}
    exec(spec_of(task_of(task), Project(folder)).python, names)  # noqa: S102 - that is what it is for
    return names, cli(*spec_of(task_of(task | more), Project(folder)).words, "--json").json


def _plain(found: Any) -> Any:
    from jounce.core.serialise import to_json

    return json.loads(to_json(found))


def test_python_of_a_fit_gives_what_its_command_gives(tmp_path, cli, spring_files, decay_file):
    """Signs, windows and units are those of the form; what Python printed is read by nobody."""
    for file in spring_files:  # a machine that counts pulling and extension as positive
        head, *rows = file.read_text().splitlines()
        turned = [",".join(str(-float(one)) for one in row.split(",")) for row in rows]
        file.write_text("\n".join([head.replace("displacement", "way"), *turned, ""]))
    stiffness = {"kind": "stiffness", "files": [one.name for one in spring_files], "columns": {"displacement": "way"},
                 "stroke_positive": "extension", "force_positive": "tension", "discard_below": "2 mm"}  # fmt: skip
    names, told = _by_python_and_command(tmp_path, stiffness, cli)
    assert told["stiffness"]["value"] == pytest.approx(22730.0, rel=1e-3)
    assert told["stiffness"]["value"] == pytest.approx(
        names["result"].fit.stiffness.value, rel=1e-12
    )
    decay = {
        "kind": "decay",
        "files": [decay_file.name],
        "mass": "16 kg",
        "begin": "0.21 s",
        "end": "1.5 s",
    }
    names, told = _by_python_and_command(tmp_path, decay, cli)
    assert told["damping_ratio"]["value"] == pytest.approx(
        names["result"].fit.damping_ratio.value, rel=1e-12
    )
    assert told["coulomb_force"]["value"] == pytest.approx(
        names["result"].fit.coulomb_force.value, rel=1e-12
    )


@pytest.mark.pages
def test_python_of_a_test_and_its_evaluation_gives_what_the_command_gives(tmp_path, cli):
    """With the plate of the tester, which a force is compensated for, the vehicle and the limits."""
    tested = {
        "kind": "test",
        "vehicle": "audi-a6-half-car-4dof",
        "tester": "egea-specsus2018",
        "out": "axle.csv",
    }
    names, told = _by_python_and_command(tmp_path, tested | {"wear": "0.3"}, cli)
    assert told["wheels"][0]["phase_angle_min_deg"] == pytest.approx(
        names["result"].axle.to_dict()["wheels"][0]["phase_angle_min_deg"]
    )
    names, told = _by_python_and_command(
        tmp_path, tested | {"wheel": "left", "out": "left.csv"}, cli
    )
    assert told["phase_angle_min_deg"] == pytest.approx(
        names["result"].tests[0].wheel.to_dict()["phase_angle_min_deg"]
    )
    asked = {"kind": "evaluate", "records": ["axle.csv"], "tester": "egea-specsus2018", "methods": ["eusama"],
             "vehicle": "audi-a6-half-car-4dof"}  # fmt: skip
    names, told = _by_python_and_command(tmp_path, asked, cli)
    (axle,) = names["result"].graded.axles
    assert told["deciding"] == ["eusama"] == list(axle.deciding)
    assert told["wheels"] == _plain(axle.to_dict()["wheels"])


@pytest.mark.pages
def test_python_of_a_store_gives_what_its_commands_give(tmp_path, cli):
    """Each keeps the same records, with what was typed about them; either finds what the other kept."""
    car = {"vehicle": "audi-a6-half-car-4dof", "tester": "egea-specsus2018"}
    for wear, name in (("0", "new.csv"), ("0.5", "worn.csv")):
        cli(
            *spec_of(
                task_of({"kind": "test", **car, "wear": wear, "out": name}), Project(tmp_path)
            ).words,
            "--json",
        )
    for name, date in (("new.csv", "2025-05-06"), ("worn.csv", "2026-05-06")):
        asked = {
            "kind": "evaluate",
            "records": [name],
            "plate": "B-Ö 1",
            "date": date,
            "inspector": "Ada",
            **car,
        }
        names, told = _by_python_and_command(
            tmp_path, asked | {"store": "python.sqlite"}, cli, store="command.sqlite", language="de"
        )
        assert told["wheels"] == _plain(names["result"].graded.axles[0].to_dict()["wheels"])
    for store in ("python.sqlite", "command.sqlite"):
        names, told = _by_python_and_command(
            tmp_path, {"kind": "history", "store": store, "plate": "bö1"}, cli
        )
        flat = [{**one, **one.pop("values")} for one in _plain(names["result"].visits)]
        assert told["wheels"] == [{key: one[key] for key in told["wheels"][0]} for one in flat]
        assert told["trends"] == _plain(names["result"].trends)
        assert [one["date"] for one in told["wheels"]] == 2 * ["2025-05-06"] + 2 * ["2026-05-06"]
        searched = {
            "kind": "search",
            "store": store,
            "tester": car["tester"],
            "since": "2026-01-01",
        }
        names, told = _by_python_and_command(tmp_path, searched, cli)
        (one,) = names["result"].records
        assert [
            (record["plate"], record["vehicle"], record["verdict"]) for record in told["records"]
        ] == [("B-Ö 1", "audi-a6-half-car-4dof", one.grading.verdict)]


@pytest.mark.pages
@pytest.mark.parametrize(
    ("asked", "seconds"),
    [
        (
            {
                "road": "iso:C:3",
                "duration": "3 s",
                "control": ["passive", "skyhook, passive"],
                "seed": 3,
            },
            3.0,
        ),
        (
            {
                "road": "iso:b",
                "speed": "40 m/s",
                "changes": {"strut.damper.coefficient": "200 N*s/m"},
            },
            20.0,
        ),
        ({"road": "road.csv", "speed": "5 m/s"}, 4.0),
    ],
)
def test_python_of_rides_gives_what_its_command_gives(tmp_path, cli, asked, seconds):
    """Where nothing is said of how long, both drive as long; controllers may stand behind one another."""
    rows = "\n".join(f"{0.05 * i:.2f},{abs(10.0 - i % 20):.1f}" for i in range(401))
    (tmp_path / "road.csv").write_text(f"x [m],z [mm]\n{rows}\n")
    names, told = _by_python_and_command(
        tmp_path, {"kind": "compare", "vehicle": "kart-quarter-car", **asked}, cli
    )
    assert told["duration"] - told["settling"] == pytest.approx(seconds)
    assert [one["merits"] for one in told["runs"]] == [
        _plain(one.merits) for one in names["result"].rides
    ]
    assert [one["control"] for one in told["runs"]] == [
        one.control for one in names["result"].rides
    ]


@pytest.mark.pages
def test_rides_over_each_other_are_those_of_python_and_command(tmp_path, cli):
    """Of vehicles with one corner, two axles and four corners, what is alike stands in one pane."""
    import jounce as jn
    from jounce.web.rides import alike, overlaid

    drive = {"road": "iso:C", "duration": "3 s", "seed": 2}
    kart, car = (
        {"vehicle": "kart-quarter-car", **drive},
        {"vehicle": "audi-a6-half-car-4dof", **drive},
    )
    soft = kart | {"changes": {"strut.spring.rate": "15 N/mm"}, "control": "skyhook"}
    task = task_of({"kind": "overlay", "rides": [kart, soft, car]})
    doing, names = spec_of(task, Project(tmp_path)), {}  # type: tuple[Any, dict[str, Any]]
    exec(doing.python, names)  # noqa: S102
    assert doing.question is not None
    found = overlaid(
        doing.question
        | {"rides": [*doing.question["rides"], doing.question["rides"][0] | {"control": "none"}]}
    )
    assert list(found["failed"]) == ["kart-quarter-car, none"]
    time, spectra = (
        {pane["name"]: pane for pane in viewer["scenes"][0]["panes"]}
        for viewer in found["content"]["viewers"]
    )
    assert [curve["label"] for curve in time["body.az"]["curves"]] == list(names["rides"])
    assert len(time["front.tyre.force"]["curves"]) == 3
    assert len(time["rear.tyre.force"]["curves"]) == 1
    assert [name for name, pane in time.items() if pane["shown"]] == [
        "body.az",
        "front.strut.deflection",
        "front.tyre.force",
    ]
    assert spectra["front.strut.deflection"]["unit"] == "mm/√Hz"
    assert len(found["notes"]) == 2
    runs, _ = alike(names["runs"])
    one, two, three = runs.values()
    assert (
        one["body.az"] == names["rides"]["kart-quarter-car, passive"].evaluated_run["sprung.az"]
    ).all()
    assert float(abs(two["body.az"] - one["body.az"]).max()) > 0.1
    assert "front.sprung.az" in three
    for words in map(shlex.split, doing.command.splitlines()):
        assert cli(*words[1:], "--json").exit_code == 0
    for k, ride in enumerate(names["rides"].values(), 1):
        written, _ = jn.read_recording(tmp_path / f"ride-{k}.nc")
        assert (
            float(
                abs(
                    written["road.z" if k < 3 else "front.road.z"]
                    - ride.run["road.z" if k < 3 else "front.road.z"]
                ).max()
            )
            == 0.0
        )
    same = spec_of(task_of({"kind": "overlay", "rides": [kart, soft]}), Project(tmp_path))
    assert same.command.splitlines()[-1] == "jounce plot ride-1.nc ride-2.nc --figure=rides.png"
    assert cli(*shlex.split(same.command.splitlines()[-1])[1:]).exit_code == 0


@pytest.mark.pages
def test_python_of_best_designs_gives_what_its_command_gives(tmp_path, cli):
    free = {"strut.damper.coefficient": "300..6000"}
    task = {"kind": "pareto", "vehicle": "audi-a6-quarter-car", "free": free, "points": 3, "road": "iso:B",
            "limit": {"strut.deflection": "20 mm"}}  # fmt: skip
    names, told = _by_python_and_command(tmp_path, task, cli)
    plain = _plain(names["result"].to_dict())
    assert {key: told[key] for key in ("comfort", "holding", "numbers")} == {
        key: plain[key] for key in ("comfort", "holding", "numbers")
    }
    assert len(plain["comfort"]) == 3


@pytest.mark.pages
def test_python_of_studies_gives_what_their_commands_give(tmp_path, cli):
    import jounce as jn

    (tmp_path / "study.toml").write_text(STUDY.replace("COUNT", "3").replace('"1 s"', '"0.3 s"'))
    names, told = _by_python_and_command(tmp_path, SWEEP, cli, force=True)
    assert told == _plain(names["result"].to_dict()) | {"out": told["out"]}
    (tmp_path / "design.toml").write_text(
        'schema = "jounce.design/1"\nrig = "formula-student-front"\nstarts = 1\n'
        '[[free]]\npoint = "hardpoints.tie_rod_inner"\nwithin = "15 mm"\n'
        '[[target]]\nquantity = "toe"\nover = "-20 mm:20 mm:20 mm"\nvalue = "0 deg"\ntolerance = "0.1 deg"\n'
    )
    design = {"kind": "design", "study": "design.toml", "out": "designed"}
    names, told = _by_python_and_command(tmp_path, design, cli, out="by command")
    assert told["moved"] == _plain(names["result"].to_dict())["moved"]
    assert jn.load(tmp_path / "designed" / "rig.toml") == jn.load(
        tmp_path / "by command" / "rig.toml"
    )
    campaign = {"kind": "new-campaign", "out": "mine"}
    names, told = _by_python_and_command(tmp_path, campaign, cli, out="theirs")
    assert (tmp_path / "mine" / "campaign.toml").read_text() == (
        tmp_path / "theirs" / "campaign.toml"
    ).read_text()


@pytest.mark.pages
def test_python_of_a_campaign_gives_what_its_command_gives(tmp_path, cli, campaign):
    task = {"kind": "campaign", "campaign": campaign.name, "out": "out"}
    names, told = _by_python_and_command(tmp_path, task, cli, force=True)
    plain = _plain(names["result"].to_dict())
    assert {key: told[key] for key in plain} == plain


@pytest.mark.pages
def test_python_of_a_preview_reads_what_the_page_shows(tmp_path, cli, decay_file):
    from jounce.web.questions import preview

    (tmp_path / "turned.csv").write_text(decay_file.read_text().replace("sprung.z", "way"))
    task = task_of({"kind": "preview", "files": ["turned.csv"], "columns": {"sprung.z": "way"}})
    names: dict[str, Any] = {}
    exec(spec_of(task, Project(tmp_path)).python, names)  # noqa: S102
    (viewer,) = preview(task.model_dump())["content"]["viewers"]
    assert "sprung.z" in json.dumps(viewer)
    assert set(names["record"].data_vars) == {"sprung.z"}
    assert float(abs(names["record"]["sprung.z"]).max()) == pytest.approx(0.02, rel=0.05)


@pytest.mark.parametrize("path", ["../study.toml", "/etc/hostname", "link.toml", "", "."])
def test_jobs_keep_to_the_folder(tmp_path, path):
    folder = tmp_path / "project"
    folder.mkdir()
    for name in ("study.toml", "a.csv"):
        (folder / name).write_text("")
        (tmp_path / name).write_text("secret")
    (folder / "link.toml").symlink_to(tmp_path / "study.toml")
    project = Project(folder)
    for task in (
        {"kind": "sweep", "study": path, "out": "swept"},
        {"kind": "sweep", "study": "study.toml", "out": path},
        {"kind": "campaign", "campaign": path, "out": "out"},
        {"kind": "design", "study": "study.toml", "out": path},
        {"kind": "evaluate", "records": [path], "tester": "eusama"},
        {"kind": "search", "store": path},
        {"kind": "preview", "files": [path]},
        {"kind": "new-campaign", "out": path},
    ):
        with pytest.raises(JounceError):
            spec_of(task_of(task), project)


def test_bad_requests_of_jobs_are_told(tmp_path):
    with pytest.raises(DescriptionError, match="not describe a job"):
        task_of({"kind": "shell", "command": "ls"})
    with pytest.raises(DescriptionError, match="not describe a job"):
        task_of({**SWEEP, "more": 1})
    with pytest.raises(DescriptionError, match=r"decay\.mass"):
        task_of({"kind": "decay", "files": ["a.csv"]})
    (tmp_path / "swept").write_text("")
    (tmp_path / "study.toml").write_text("")
    with pytest.raises(DescriptionError, match="a file, not a folder"):
        spec_of(task_of(SWEEP), Project(tmp_path))
    for name in ("../jobs", "x/y", ".hidden", "none"):
        with pytest.raises(DescriptionError, match="no such job"):
            _jobs(tmp_path).state(name)


def test_a_process_that_works_for_others_reads_below_a_folder_in_every_thread(
    tmp_path, monkeypatch
):
    monkeypatch.setattr("jounce.core.files._ALWAYS", {})
    inside = tmp_path / "project" / "a.toml"
    inside.parent.mkdir()
    for file in (inside, tmp_path / "secret.toml"):
        file.write_text("")
    always_below(inside.parent)
    found: list[object] = []

    def read() -> None:
        found.append(existing_file(inside))
        try:
            existing_file(tmp_path / "secret.toml")
        except DescriptionError as error:
            found.append(error.what)

    thread = threading.Thread(target=read)
    thread.start()
    thread.join()
    assert found == [inside, "outside of the folder that may be read"]


def test_whoever_runs_a_command_for_others_is_told_how_far_it_is():
    heard: list[tuple[str, float | None]] = []
    with followed_by(lambda line: heard.append((line.said, line.share()))), progress() as say:
        say(progress_through("testing {which} of {count}", 1, 4))
        say(progress_through("testing {which} of {count}", 3, 4))
    assert heard == [("testing 1 of 4", 0.0), ("testing 3 of 4", 0.5)]


def test_a_job_fails_with_its_reason_and_another_ends_well(tmp_path):
    """A server that was begun since knows both from the disk."""
    jobs = _jobs(tmp_path)
    (tmp_path / "study.toml").write_text(
        STUDY.replace("COUNT", "3").replace("kart-quarter-car", "kart-quarter")
    )
    failed = jobs.begin(task_of(SWEEP))
    assert (failed["state"], failed["command"]) == (
        "running",
        "jounce sweep study.toml --out=swept",
    )
    with pytest.raises(OutputError, match="is writing to this folder"):
        jobs.begin(task_of(SWEEP))
    jobs.prepare()  # as where a page is open: the next one is split from a process that has loaded everything
    while sys.platform == "linux" and not jobs._has_loaded():
        time.sleep(0.05)
    well = jobs.begin(task_of({"kind": "new-campaign", "out": "mine"}))
    assert list(jobs.processes) == (
        [failed["id"]] if sys.platform == "linux" else [failed["id"], well["id"]]
    )
    state = _ended(jobs, failed["id"])
    assert state["state"] == "failed"
    assert "kart-quarter-car" in state["error"]
    assert "Traceback" not in state["error"]
    assert _ended(jobs, well["id"])["state"] == "done"
    again = _jobs(tmp_path)
    assert [(one["state"], one["title"]) for one in again.all()] == [
        ("done", "Campaign to start from in mine"), ("failed", "Sweep study"),
    ]  # fmt: skip
    assert "campaign.toml" in again.result(well["id"])["files"]
    assert again.again(failed["id"]).resume
    jobs.end()
    again.forget(failed["id"])
    assert [one["id"] for one in again.all()] == [well["id"]]
    assert (tmp_path / "mine" / "campaign.toml").is_file()


def test_a_job_whose_process_is_gone_is_stopped_not_running(tmp_path):
    folder = tmp_path / ".jounce" / "jobs" / "20260101-000000-abcdef"
    folder.mkdir(parents=True)
    about = {
        "kind": "sweep",
        "asked": SWEEP,
        "title": "Sweep",
        "begun": 1.0,
        "out": "swept",
        "page": "",
    }
    (folder / "job.json").write_text(json.dumps(about))
    (folder / "progress.json").write_text(
        json.dumps({"at": 5.0, "said": "simulating", "share": 0.25})
    )
    (folder / "alive").touch()
    (state,) = _jobs(tmp_path).all()
    assert (state["state"], state["share"], state["ended"]) == ("stopped", 0.25, 5.0)
    assert "was killed" in state["error"]
    (folder / "progress.json").write_text("half a f")  # nothing on the disk is trusted to be whole
    (folder / "end.json").write_text("[1, 2]")
    (state,) = _jobs(tmp_path).all()
    assert state["state"] == "stopped"


@pytest.mark.parametrize("is_begun", [False, True])
def test_a_job_that_went_with_its_server_is_stopped_at_once(tmp_path, is_begun):
    """The next server called it running for fifteen seconds, and refused to begin it again."""
    folder = tmp_path / ".jounce" / "jobs" / "20260101-000000-abcdef"
    folder.mkdir(parents=True)
    (tmp_path / "study.toml").write_text("")
    about = {
        "kind": "sweep",
        "asked": SWEEP,
        "title": "Sweep",
        "begun": time.time(),
        "out": "swept",
        "page": "",
    }
    (folder / "job.json").write_text(json.dumps(about))
    if is_begun:
        (folder / "alive").touch()
    jobs = _jobs(tmp_path)
    assert [one["state"] for one in jobs.all()] == ["stopped"]
    again = jobs.begin(jobs.again(folder.name))
    assert again["state"] == "running"
    jobs.cancel(again["id"])
    _ended(jobs, again["id"])


def test_a_job_is_the_newest_and_lasts_as_long_as_it_does_whatever_clocks_say(
    tmp_path, monkeypatch
):
    from jounce.web import jobs as module

    folder = tmp_path / ".jounce" / "jobs"
    for name in ("20991231-235959-999-abcdef", "000007-abcdef"):
        (folder / name).mkdir(parents=True)
        (folder / name / "job.json").write_text(json.dumps({"begun": 1.0, "title": name}))
    jobs = _jobs(tmp_path)
    began = [jobs.begin(task_of({"kind": "new-campaign", "out": "a"}))]
    hour = time.time() - 3600.0
    monkeypatch.setattr(module.time, "time", lambda: hour)
    began.append(jobs.begin(task_of({"kind": "new-campaign", "out": "b"})))
    assert [one["id"] for one in _jobs(tmp_path).all()] == [
        began[1]["id"], began[0]["id"], "20991231-235959-999-abcdef", "000007-abcdef"
    ]  # fmt: skip
    for one in began:
        state = _ended(jobs, one["id"])
        assert 0.0 < state["lasted"] < 120.0
    assert state["ended"] - state["begun"] > 1000.0  # by the clock that jumped


def test_a_version_and_a_run_are_the_newest_whatever_clocks_say(tmp_path, monkeypatch):
    from jounce.web import kept
    from jounce.web import project as module

    project = Project(tmp_path)
    run = {
        "road": {"kind": "half-sine", "height": "1 mm", "length": "60 mm"},
        "speed": "2 m/s",
        "duration": "0.05 s",
    }
    was, now = "", time.time()
    for k in range(4):
        monkeypatch.setattr(module.time, "time_ns", lambda k=k: int(1e9 * (now - 3600.0 * k)))
        monkeypatch.setattr(module.time, "time", lambda k=k: now - 3600.0 * k)
        was = project.write("a.toml", f"k = {k}\n", was).digest
        kept.keep(project, "kart-quarter-car", {}, run, f"run {k}")
    texts = [project.version(one.name)[1] for one in project.versions("a.toml")]
    assert texts == ["k = 2\n", "k = 1\n", "k = 0\n"]
    assert [one["path"] for one in kept.history(project)] == [
        f"runs/run {k}.nc" for k in (3, 2, 1, 0)
    ]


def test_a_save_that_failed_leaves_one_version(tmp_path, monkeypatch):
    from jounce.core import writing
    from jounce.web import project as module

    project = Project(tmp_path)
    was = project.write("a.toml", "k = 1\n").digest

    def refuse(file: Path, *_: Any, **__: Any) -> Path:
        if file == tmp_path / "a.toml":
            raise OSError(28, "No space left on device")
        return writing.write_atomically(file, *_, **__)

    for _ in range(2):
        with monkeypatch.context() as full:
            full.setattr(module, "write_atomically", refuse)
            with pytest.raises(OSError, match="No space"):
                project.write("a.toml", "k = 2\n", was)
    project.write("a.toml", "k = 2\n", was)
    assert [project.version(one.name)[1] for one in project.versions("a.toml")] == ["k = 1\n"]


def test_two_who_look_at_once_do_not_take_each_other_for_the_one_who_works(tmp_path):
    from jounce.core.locking import hold, is_held

    file = tmp_path / "alive"
    file.touch()
    looks = hold(file, shared=True)
    assert looks is not None
    assert is_held(file) is (sys.platform == "win32")
    assert hold(file) is None  # whoever is to work waits for a moment
    os.close(looks)


@pytest.mark.parametrize("operation", ["write_atomically", "write_recording"])
def test_a_run_whose_keeping_was_cut_off_is_kept_by_keeping_it_again(
    tmp_path, monkeypatch, operation
):
    """A process was killed before, between, or after the two files: of those it left, none is lost or in the way."""
    from jounce import recordings
    from jounce.web import kept

    class KilledError(BaseException):
        pass

    run = {
        "road": {"kind": "half-sine", "height": "1 mm", "length": "60 mm"},
        "speed": "2 m/s",
        "duration": "0.05 s",
    }
    place = recordings if operation == "write_recording" else kept
    whole = getattr(place, operation)

    def killed(*given: Any, **named: Any) -> Any:
        if is_late:
            whole(*given, **named)
        raise KilledError

    for is_late in (False, True):
        project, title = Project(tmp_path), f"run {is_late}"
        monkeypatch.setattr(place, operation, killed)
        with pytest.raises(KilledError):
            kept.keep(project, "kart-quarter-car", {}, run, title)
        monkeypatch.setattr(place, operation, whole)
        path = f"runs/{title}.nc"
        if (tmp_path / path).exists():
            assert [one["path"] for one in kept.history(project)] == [path]
        else:
            assert kept.keep(project, "kart-quarter-car", {}, run, title)["path"] == path
        assert path in [one["path"] for one in kept.history(project)]
        (tmp_path / path).unlink()


def _asked(
    port: int, method: str, path: str, body: Any = None, token: str | None = TOKEN
) -> tuple[int, Any]:
    import http.client

    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=120)
    headers = {"Authorization": f"Bearer {token}"} if token else {}
    if isinstance(body, dict):
        body, headers["Content-Type"] = json.dumps(body), "application/json"
    connection.request(method, path, body, headers)
    answer = connection.getresponse()
    content = answer.read()
    connection.close()
    is_json = (answer.getheader("content-type") or "").startswith("application/json")
    return answer.status, json.loads(content) if is_json else (content, dict(answer.getheaders()))


def test_uploads_are_kept_as_they_are_and_replace_nothing(workbench):
    folder, port = workbench
    content = b"time [s],sprung.z [mm]\n" + b"".join(
        b"%.3f,%d\n" % (0.001 * i, i % 7) for i in range(50)
    )
    before = {one for one in folder.rglob("*") if one.is_file()}
    assert _asked(port, "PUT", "/api/upload?path=new/run.csv", content)[0] == 200
    assert (folder / "new" / "run.csv").read_bytes() == content
    for other in (b"other", bytes(len(content))):
        assert _asked(port, "PUT", "/api/upload?path=new/run.csv", other)[0] == 409
    assert (
        _asked(port, "PUT", "/api/upload?path=new/run.csv", content)[0] == 200
    )  # the same file, dropped again
    for path in ("../out.csv", "%2Fetc%2Fx.csv", "x.sh", "x.html", ".csv", "a%00b.csv"):
        status, answer = _asked(port, "PUT", f"/api/upload?path={path}", b"x")
        assert status in (409, 422), answer
    assert (folder / "new" / "run.csv").read_bytes() == content
    assert {one for one in folder.rglob("*") if one.is_file()} - before == {
        folder / "new" / "run.csv"
    }
    assert not (folder.parent / "out.csv").exists()
    with socket.create_connection(("127.0.0.1", port), timeout=10) as plain:
        head = f"PUT /api/upload?path=big.csv HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nAuthorization: Bearer {TOKEN}\r\n"
        plain.sendall(f"{head}Content-Length: 250000001\r\n\r\n".encode())
        assert plain.recv(100).split()[1] == b"413"
    assert _asked(port, "PUT", "/api/upload?path=y.csv", b"x", token=None)[0] == 401
    entries = _asked(port, "GET", "/api/project")[1]["entries"]
    assert [one["path"] for one in entries if folder / one["path"] not in before] == ["new/run.csv"]


def test_what_would_be_read_is_shown_before_it_is_read(workbench):
    folder, port = workbench
    (folder / "spring.csv").write_text(
        "way [mm];F [kN]\n" + "\n".join(f"{-i};{-0.02 * i}" for i in range(20))
    )
    asked = {"kind": "preview", "form": "force-deflection", "files": ["spring.csv"]}
    status, answer = _asked(port, "POST", "/api/ask", asked)
    assert status == 200
    found = answer["result"]
    assert [(one["name"], one["unit"], one["least"]) for one in found["columns"]] == [
        ("way", "mm", -19),
        ("F", "kN", -0.38),
    ]
    assert "displacement" in found["problem"]
    columns = {"displacement": "way", "force": "F"}
    turned = {"stroke_positive": "extension", "force_positive": "tension"}
    found = _asked(port, "POST", "/api/ask", asked | {"columns": columns} | turned)[1]["result"]
    assert found["problem"] is None
    assert (found["points"]["x"][10], found["points"]["y"][10]) == (
        pytest.approx(10.0),
        pytest.approx(200.0),
    )
    (folder / "bad.mat").write_bytes(b"\x00\xff" * 300)
    status, answer = _asked(port, "POST", "/api/ask", {"kind": "preview", "files": ["bad.mat"]})
    assert status == 422
    assert "bad.mat" in answer["error"]["text"]
    assert "Traceback" not in str(answer)


def test_results_of_sweeps_are_read_apart(workbench, monkeypatch):
    """A damaged HDF5 file ends the process that reads it: not the server."""
    from jounce.variants import shards
    from jounce.variants.study import run_sweep

    folder, port = workbench
    (folder / "study.toml").write_text(STUDY.replace("COUNT", "3"))
    run_sweep(
        folder / "study.toml", folder / "apart", command="jounce sweep study.toml --out=apart"
    )

    def read_here(_: bytes) -> None:
        raise AssertionError("read in the server's process")

    monkeypatch.setattr(shards, "_dataset", read_here)
    status, found = _asked(port, "GET", "/api/sweep?folder=apart")
    assert (status, found["finished"], len(found["variants"])) == (200, 3, 3)
    assert _asked(port, "GET", "/api/sweep?folder=..")[0] == 422
    status, found = _asked(port, "GET", "/api/sweep?folder=nowhere")
    assert (status, "contains no sweep" in str(found)) == (409, True)
    shard = next((folder / "apart").rglob("*.nc"))
    content = b"\x89HDF\r\n\x1a\n" + b"damaged" * 100
    shard.rename(
        shard.with_name(f"{shard.name.split('.')[0]}.{shards.checksum(content)}.nc")
    ).write_bytes(content)
    status, found = _asked(port, "GET", "/api/sweep?folder=apart")
    assert status == 422
    assert "apart" in str(found)


def test_reports_stand_in_a_place_of_their_own(workbench):
    folder, port = workbench
    (folder / "evil.html").write_text("<script>fetch('/api/project')</script>")
    status, (content, headers) = _asked(port, "GET", "/api/document?path=evil.html")
    assert (status, content) == (200, b"<script>fetch('/api/project')</script>")
    policy = {name.lower(): text for name, text in headers.items()}["content-security-policy"]
    assert policy.startswith("sandbox allow-scripts;")
    assert "allow-same-origin" not in policy
    assert "default-src 'none'" in policy
    assert "connect-src" not in policy
    for path in ("spring.csv", "../x.html", "none.html"):
        assert _asked(port, "GET", f"/api/document?path={path}")[0] == 422
    assert _asked(port, "GET", "/api/reports/none")[0] == 422
    assert _asked(port, "GET", "/api/document?path=evil.html", token=None)[0] == 401


def test_jobs_are_followed_by_who_has_the_token_and_the_origin(workbench):
    _, port = workbench
    address = f"ws://127.0.0.1:{port}/api/live"
    known = {"Authorization": f"Bearer {TOKEN}"}
    for headers, origin in (
        ({}, None),
        (known, "http://evil.example"),
        ({"Authorization": "Bearer x"}, None),
    ):
        with (
            pytest.raises(Exception, match="403"),
            client.connect(address, additional_headers=headers, origin=origin),
        ):
            pass
    for offered in (
        [TOKEN],
        ["jounce"],
        ["jounce", "x"],
        [TOKEN, "jounce"],
        ["jounce", TOKEN, "x"],
    ):
        with pytest.raises(Exception, match="403"), client.connect(address, subprotocols=offered):
            pass
    with pytest.raises(Exception, match="403"):
        client.connect(address, additional_headers={"Cookie": f"jounce-{port}={TOKEN}"})
    with client.connect(
        address, subprotocols=["jounce", TOKEN], origin=f"http://127.0.0.1:{port}"
    ) as socket_:
        assert socket_.response.headers["Sec-WebSocket-Protocol"] == "jounce"
        assert json.loads(socket_.recv(timeout=10)) == []
    with client.connect(
        address, additional_headers=known, origin=f"http://127.0.0.1:{port}"
    ) as socket_:
        assert json.loads(socket_.recv(timeout=10)) == []


@pytest.mark.slow
def test_a_sweep_outlives_its_server_and_goes_on_where_it_was_cancelled(tmp_path):
    """The server is killed while the job is still running; the next one knows it, cancels it, and resumes it."""
    (tmp_path / "study.toml").write_text(STUDY.replace("COUNT", "120000"))

    def started() -> tuple[subprocess.Popen[str], int, str]:
        command = [sys.executable, "-m", "jounce", "serve", str(tmp_path), "--no-open", "--json"]
        process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        assert process.stdout is not None
        with process.stdout:
            line = json.loads(process.stdout.readline())
        return process, int(line["url"].split(":")[2].split("/")[0]), line["token"]

    def until(good: Any) -> dict[str, Any]:
        for _ in range(1200):
            state = _asked(port, "GET", f"/api/jobs/{name}", token=token)[1]
            if good(state):
                return dict(state)
            time.sleep(0.1)
        raise AssertionError(state)

    server, port, token = started()
    try:
        name = _asked(port, "POST", "/api/jobs", SWEEP, token=token)[1]["id"]
        until(lambda state: state["share"])
        server.send_signal(signal.SIGKILL)
        server.wait()
        server, port, token = started()
        before = until(lambda state: (state["share"] or 0.0) > 0.05)
        assert before["state"] == "running"
        assert before["left"] > 0.0
        running = _asked(port, "GET", "/api/jobs?running=true", token=token)[1]
        assert [one["id"] for one in running] == [name]
        _asked(port, "POST", f"/api/jobs/{name}/cancel", {}, token=token)
        assert (
            until(lambda state: state["state"] not in ("running", "cancelling"))["state"]
            == "cancelled"
        )
        kept = len(list((tmp_path / "swept" / "shards").glob("*.nc")))
        assert kept
        state = _asked(port, "POST", f"/api/jobs/{name}/again", {}, token=token)[1]
        assert shlex.split(state["command"])[-1] == "--resume"
        name = state["id"]
        done = until(lambda state: state["state"] != "running")
        assert (done["state"], done["has_page"]) == ("done", True)
        assert done["result"]["summary"]["ran"] == 120_000
    finally:
        server.kill()
        server.wait()
    assert os.listdir(tmp_path / ".jounce" / "jobs")  # noqa: PTH208


def test_a_study_is_written_when_it_is_whole_and_its_variants_are_shown_as_runs(tmp_path):
    """Values are in the units that are shown; each variant opens as the run that it was."""
    from jounce.parts.files import library
    from jounce.variants.study import run_sweep
    from jounce.web.studies import swept, write_study

    project = Project(tmp_path)
    road = {"kind": "half-sine", "height": "10 mm", "length": "60 mm", "start": "0.1 m"}
    study = {
        "rig": "kart-quarter-car",
        "trial": {"speed": "2 m/s", "duration": "0.4 s", "road": road},
        "design": {"kind": "grid"},
        "vary": {"strut.spring.rate": ["20 N/mm", "25 N/mm"]},
        "metrics": ["max strut.deflection"],
    }
    wrong = study | {"vary": {"strut.spring.rat": ["20 N/mm"]}}
    with pytest.raises(DescriptionError, match=r"^study.toml, line \d+: vary.strut.spring.rat: "):
        write_study(project, "study.toml", wrong)
    assert list(tmp_path.iterdir()) == []
    made = write_study(project, "study.toml", study)
    assert made["count"] == 2
    with pytest.raises(OutputError, match="the file already exists"):
        write_study(project, "study.toml", study)
    write_study(project, "study.toml", study, made["digest"])
    (tmp_path / "rig.toml").write_bytes(library()["kart-quarter-car"].read_bytes())
    apart = write_study(project, "studies/other.toml", study | {"rig": "rig.toml"})
    assert (apart["count"], 'rig = "../rig.toml"' in apart["text"]) == (
        2,
        True,
    )  # found from where the study lies
    run_sweep(
        tmp_path / "study.toml", tmp_path / "swept", command="jounce sweep study.toml --out=swept"
    )
    found = swept(project, "swept")
    rate, deflection = found["columns"]
    assert (rate["name"], rate["unit"], rate["values"], rate["is_number"]) == (
        "strut.spring.rate",
        "N/mm",
        [20.0, 25.0],
        True,
    )
    assert (deflection["unit"], deflection["is_number"]) == ("mm", False)
    assert 1.0 < deflection["values"][1] < deflection["values"][0] < 100.0
    assert found["summary"]["metrics"][0]["mean"] * 1e3 == pytest.approx(
        sum(deflection["values"]) / 2
    )
    assert found["run"] == {
        "rig": "kart-quarter-car",
        "road": road,
        "speed": "2 m/s",
        "duration": "0.4 s",
    }
    with pytest.raises(OutputError, match="contains no sweep"):
        swept(project, "nowhere")
    with pytest.raises(DescriptionError, match="not a path in this project"):
        swept(project, "..")


def test_measured_files_are_entered_into_a_campaign_that_stays_whole(tmp_path):
    import jounce as jn
    from jounce.web.campaigns import enter_file, overview

    project = Project(tmp_path)
    jn.new_campaign(tmp_path / "mine")
    path = "mine/campaign.toml"
    before = (tmp_path / path).read_text()
    shown = overview(project, path)
    assert [one["name"] for one in shown["bench"]] == ["spring", "decay", "tyre at 0.31 MPa"]
    assert shown["bench"][0]["found"] == ["mine/bench/spring_1.csv", "mine/bench/spring_2.csv"]
    assert (shown["mass"], shown["trials"][0]["file"]) == ("16 kg", "mine/trials/01.csv")

    new = tmp_path / "mine" / "bench" / "soft.csv"
    new.write_text("s [mm],F [N]\n0,0\n10,200\n")
    fields = {
        "files": ["mine/bench/soft.csv"],
        "columns": {"displacement": "s", "force": "F"},
        "discard_below": "1 mm",
    }
    enter_file(project, path, "tyre", {**fields, "pressure": "0.2 MPa", "stroke_positive": ""})
    enter_file(project, path, "spring", {"files": ["mine/bench/soft.csv"]})
    enter_file(
        project,
        path,
        "decay",
        {"files": ["mine/bench/decay_1.csv"], "replace": True, "columns": {"time": "time"}},
    )
    enter_file(
        project,
        path,
        "trial",
        {"recording": "mine/trials/02.csv", "road": "A", "speed": "2 m/s", "use": "fit"},
    )
    campaign, text = jn.campaign.load_campaign(tmp_path / path)
    assert campaign.bench.tyre["0.2 MPa"].columns == {"displacement": "s", "force": "F"}
    assert campaign.bench.tyre["0.2 MPa"].discard_below == pytest.approx(1e-3)
    assert campaign.bench.decay.files == ("bench/decay_1.csv",)
    assert campaign.bench.spring.files == ("bench/spring_*.csv", "bench/soft.csv")
    assert (campaign.trial[-1].number, campaign.trial[-1].recording) == (5, "trials/02.csv")
    assert all(line in text for line in before.splitlines() if line.lstrip().startswith("#"))

    for use, wrong in (
        ("spring", {"law": "cubic"}),
        (
            "spring",
            {"files": ["mine/bench/soft.csv"], "columns": {"force": "F"}},
        ),  # those that are there have others
        ("spring", {"files": ["mine/bench/soft.csv"], "discard_below": "1 kg"}),
        ("tyre", {"files": ["mine/bench/soft.csv"]}),
        ("trial", {"recording": "mine/trials/02.csv", "road": "A", "speed": "2 m/s", "number": 1}),
        ("trial", {"recording": "../secret.csv", "road": "A", "speed": "2 m/s"}),
    ):
        with pytest.raises(DescriptionError):
            enter_file(project, path, use, wrong)
    assert (tmp_path / path).read_text() == text


def test_what_a_page_asks_is_not_waited_for_when_the_server_ends(tmp_path: Path) -> None:
    """Ctrl-C waited for the whole patience of a question, two minutes and more, as nobody works on it any more."""
    closing = threading.Event()
    closing.set()
    begun = time.monotonic()
    assert _is_over(tmp_path, 60.0, closing) is False
    assert time.monotonic() - begun < 30.0
