"""Long records of the workbench: read once, in a process that loads little, and seen with their peaks."""

from __future__ import annotations

import json
import os
import shlex
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from time import sleep
from typing import Any

import h5netcdf
import logger_files
import numpy as np
import pytest

from jounce.cli import main
from jounce.core.errors import JounceError

pytest.importorskip("fastapi")
pytest.importorskip("pydantic")

COUNT, PEAK = 100_000, 77_777


def _written(file: Path) -> None:
    """Two channels at 1 kHz with one peak of one sample; the second is packed, with a gap."""
    time = 5.0 + np.arange(COUNT) / 1000.0
    with h5netcdf.File(file, "w") as netcdf:
        netcdf.dimensions = {"time": COUNT}
        for name, values, attributes in (
            ("time", time, {"units": "s"}),
            ("a", np.where(np.arange(COUNT) == PEAK, 9.0, np.sin(time)), {"units": "m/s^2", "_FillValue": np.nan}),
            ("b", np.where(np.arange(COUNT) == 3, -1, 8).astype("i2"),
             {"units": "N", "scale_factor": 0.25, "add_offset": 1.0, "_FillValue": np.int16(-1)}),
        ):  # fmt: skip
            one = netcdf.create_variable(
                name, ("time",), values.dtype, values, fillvalue=attributes.get("_FillValue")
            )
            one.attrs.update(
                {key: value for key, value in attributes.items() if key != "_FillValue"}
            )


@pytest.fixture
def opened(tmp_path: Path) -> Any:
    from jounce.web.jobs import Jobs
    from jounce.web.project import Project
    from jounce.web.records import Records

    _written(tmp_path / "long.nc")
    project = Project(tmp_path)
    jobs = Jobs(project)
    records = Records(project, jobs)
    yield records, jobs
    records.end()
    jobs.end()


def test_a_long_record_is_opened_without_waiting_for_what_it_does_not_need(
    opened: Any, tmp_path: Path
) -> None:
    records, jobs = opened
    found = records.open("long.nc")
    assert (
        jobs.ready is None
    )  # the process that loads all that commands need was not started for it
    assert found.about["channels"] == [{"name": "a", "unit": "m/s^2"}, {"name": "b", "unit": "N"}]
    assert (found.about["count"], found.about["first"], found.about["even"]) == (COUNT, 5.0, True)
    (scene,) = found.viewer(["a", "b"], 5.0, 5.0 + COUNT / 1000.0, 50).scenes
    first, second = (pane.curves[0].values for pane in scene.panes)
    assert len(first) == 100  # two values a column
    assert np.max(first) == 9.0
    assert scene.x[int(np.argmax(first))] == pytest.approx(
        5.0 + PEAK / 1000.0, abs=COUNT / 1000.0 / 50
    )
    assert set(np.unique(second)) == {3.0}  # 8 x 0.25 + 1, and no gap among the extremes
    (near,) = found.viewer(["b"], 5.0, 5.010, 50).scenes
    assert np.isnan(near.panes[0].curves[0].values[3])


def test_what_is_seen_of_a_record_is_told_in_python_and_as_a_command(
    opened: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    records, _ = opened
    rows = "".join(f"{0.01 * i:.2f}, {i}, {i % 7}\n" for i in range(50))
    (tmp_path / "of a bench.csv").write_text(f"time [s], up [mm], sprung.z [mm]\n{rows}")
    about = {"channels": [{"name": "up", "unit": "mm"}, {"name": "sprung.z", "unit": "mm"}]}
    equivalents = records.equivalents("of a bench.csv", about, ["up", "sprung.z"])
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {}
    exec(equivalents["python"], names)  # noqa: S102 - that is what it is for
    assert list(names["recording"]) == ["sprung.z"]
    assert len(names["figure"].axes) == 1
    assert "to be mapped with columns={...}: ['up']\n" in equivalents["python"]
    assert main(shlex.split(equivalents["command"])[1:]) == 0
    assert (tmp_path / "record.png").is_file()


@pytest.mark.parametrize(
    "channels",
    [
        [("up", "mm"), ("down", "mm")],
        [("sprung.z", "")],
        [("sprung.z", "N"), ("unsprung.z", "mm")],
        [("sprung.z", "mm"), ("sprung.z #2", "mm")],
        [("up\nraise SystemExit", "mm"), ("a\u2028raise SystemExit", "mm")],
    ],
    ids=["unknown", "no unit", "wrong unit", "twice", "lines"],
)
def test_of_columns_that_must_be_mapped_nothing_is_told_that_fails(
    opened: Any, channels: list[tuple[str, str]]
) -> None:
    records, _ = opened
    about = {"channels": [{"name": name, "unit": unit} for name, unit in channels]}
    equivalents = records.equivalents("bench.csv", about, [name for name, _ in channels])
    exec(equivalents["python"], {})  # noqa: S102 - that is what it is for
    assert any(repr(name) in equivalents["python"] for name, _ in channels)
    assert equivalents["command"] == ""


def test_what_is_left_out_of_a_record_is_told_and_equal_names_are_told_apart(
    tmp_path: Path,
) -> None:
    from jounce.recordings.readers import READERS
    from jounce.web.levels import write_levels
    from jounce.web.project import RECORDS

    file = tmp_path / "gaps.csv"
    file.write_text("time [s],a [mm],a [mm],b [N]\n0,1,5,1\n0.1,2,6,nan\n0.2,3,7,3\n")
    found = write_levels(file, tmp_path / "kept")
    assert [one["name"] for one in found["channels"]] == ["a", "a #2"]
    (told,) = found["left_out"]
    assert told.startswith("gaps.csv, line 3: column 'b [N]': not a finite number")
    assert set(RECORDS) == {suffix for known in READERS for suffix in known.suffixes}


def test_files_of_loggers_and_test_rigs_are_opened(opened: Any, tmp_path: Path) -> None:
    records, _ = opened
    time = np.arange(400) / 200.0
    wave = 12.0 * np.sin(9.0 * time)
    rows = [
        f"8 {100000 + t:010.3f} +3119.37 -00059.48 {90.0 + w:.3f}"
        for t, w in zip(time, wave, strict=True)
    ]
    table = "".join(f"{t:.3f},{w:.6f}\n" for t, w in zip(time, wave, strict=True))
    files = {
        "a.rsp": logger_files.rpc_file([("Damper FL", "mm", wave)], 0.005, extra={"SAMPLES": 400}),
        "a.ld": logger_files.ld_file([("Damper FL", "mm", 200, (7, 4), wave)]),
        "a.vbo": logger_files.vbo_text(rows, names="sats time lat long velocity", titles=["a"]).encode(),
        "a.sst": logger_files.sst_file(wave + 100.0, wave + 100.0, 200),
        "aim.csv": f'"Format","AiM CSV File"\n"Venue","Fuji"\n\n"Time","Damper FL"\n"s","mm"\n\n{table}'.encode(),
        "dl1.csv": f"Time (s),Damper FL (mm)\n{table}".encode(),
    }  # fmt: skip
    for name, content in files.items():
        (tmp_path / name).write_bytes(content)
        about = records.open(name).about
        assert (about["count"], about["even"], about["unit"]) == (400, True, "s"), name
        known = {channel["name"]: channel["unit"] for channel in about["channels"]}
        assert known.get("Damper FL") == "mm" or {"velocity", "fork"} & set(known), name


def test_a_file_that_cannot_be_read_is_told_without_its_folder() -> None:
    from jounce.core.errors import OutputError
    from jounce.web.project import unusable

    told = unusable(OSError(28, "No space left on device", "/secret/x"), "x")
    assert isinstance(told, OutputError)
    assert str(told).startswith("x: cannot be read or written; found 'No space left on device'.")


@pytest.fixture
def here(opened: Any) -> tuple[Any, list[str]]:
    """Records that are read in this process, and which were."""
    from jounce.web.levels import write_levels

    records, jobs = opened
    asked: list[str] = []

    def ask(doing: Any) -> None:
        asked.append(doing.title)
        write_levels(Path(doing.question["file"]), Path(doing.question["folder"]))

    jobs.ask = ask
    return records, asked


def test_what_was_read_stays_until_the_file_changes(here: Any, tmp_path: Path) -> None:
    records, asked = here
    folder = records.open("long.nc").folder
    assert records.open("long.nc").folder == folder
    assert asked == ["Reading long.nc"]
    with (tmp_path / "long.nc").open("ab") as stream:
        stream.write(b"\0")
    assert records.open("long.nc").folder != folder
    assert asked == 2 * ["Reading long.nc"]


def test_another_record_of_the_same_size_and_time_is_another_record(
    here: Any, tmp_path: Path
) -> None:
    """As ``cp -p`` leaves it, or an archive that is unpacked."""
    records, asked = here
    names = []
    for name in ("first", "other"):
        (tmp_path / "new.csv").write_text(f"time [s],{name} [mm]\n0,1\n0.1,2\n")
        os.utime(tmp_path / "new.csv", (1e9, 1e9))
        shutil.copy2(tmp_path / "new.csv", tmp_path / "run.csv")
        names += [one["name"] for one in records.open("run.csv").about["channels"]]
    assert names == ["first", "other"]
    assert len(asked) == 2


def test_a_record_is_recognised_by_its_content_where_a_disk_tells_nothing_else(
    here: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Some keep whole seconds, no date of a change and no number of a file."""
    records, _ = here
    monkeypatch.setattr("jounce.web.records.state_of", lambda file: (0, file.stat().st_size, 0, 0))
    names = []
    for name in ("first", "other"):
        (tmp_path / "run.csv").write_text(f"time [s],{name} [mm]\n0,1\n0.1,2\n")
        names += [one["name"] for one in records.open("run.csv").about["channels"]]
    assert names == ["first", "other"]


def test_what_a_folder_brings_along_is_not_taken_for_what_was_read(tmp_path: Path) -> None:
    """Levels that somebody else left in the project say what they like: channels, numbers, more than there is."""
    from jounce.web.jobs import Jobs
    from jounce.web.project import Project
    from jounce.web.records import Records

    (tmp_path / "run.csv").write_text("time [s],true [mm]\n0,1\n0.1,2\n")
    jobs = Jobs(Project(tmp_path))
    first = Records(jobs.project, jobs)
    folder = first.open("run.csv").folder
    about = json.loads((folder / "about.json").read_text())
    about["channels"] = [{"name": "invented", "unit": "N"}]
    for place in {folder, tmp_path / ".jounce" / "levels" / folder.name}:
        if place != folder:
            shutil.copytree(folder, place)
        (place / "about.json").write_text(json.dumps(about))
        np.save(place / "0.npy", np.array([7.0, 8.0], np.float32))
    found = Records(jobs.project, jobs).open("run.csv")
    assert found.about["channels"] == [{"name": "true", "unit": "mm"}]
    (scene,) = found.viewer(["true"], 0.0, 1.0, 50).scenes
    assert list(scene.panes[0].curves[0].values) == [1.0, 2.0]


def test_the_last_few_records_stay_until_the_server_ends(
    here: Any, tmp_path: Path, monkeypatch
) -> None:
    records, asked = here
    monkeypatch.setattr("jounce.web.records._MOST_KEPT", 2)
    for name in ("a.csv", "b.csv", "c.csv", "a.csv"):
        if not (tmp_path / name).exists():
            (tmp_path / name).write_text("time [s],x [mm]\n0,1\n0.1,2\n")
        records.open(name)
    assert [one.removeprefix("Reading ") for one in asked] == ["a.csv", "b.csv", "c.csv"]
    assert len(list(records.folder.iterdir())) == 2
    records.end()
    assert not records.folder.exists()


def test_two_who_ask_at_once_have_a_record_read_once(here: Any) -> None:
    """Else the second would write what the first looks at."""
    records, asked = here
    read = records.jobs.ask

    def slowly(doing: Any) -> None:
        sleep(0.2)
        read(doing)

    records.jobs.ask = slowly
    with ThreadPoolExecutor(2) as both:
        list(both.map(records.open, 2 * ["long.nc"]))
    assert asked == ["Reading long.nc"]


def test_a_damaged_record_is_refused_and_nothing_stays(here: Any, tmp_path: Path) -> None:
    records, _ = here
    (tmp_path / "bad.nc").write_bytes(b"\x89HDF\r\n\x1a\n no more")
    with pytest.raises(JounceError, match="not a netCDF file, or damaged"):
        records.open("bad.nc")
    assert list(records.folder.iterdir()) == []


def test_a_record_that_is_not_packed_is_read_with_few_libraries(tmp_path: Path) -> None:
    """xarray, pandas and SciPy take longer to load than ten million samples to read."""
    time = np.arange(1000) / 1000.0
    with h5netcdf.File(tmp_path / "plain.nc", "w") as netcdf:
        netcdf.dimensions = {"time": 1000}
        netcdf.create_variable("time", ("time",), float, time).attrs["units"] = "s"
        netcdf.create_variable(
            "a", ("time",), "f4", np.sin(time).astype("f4"), fillvalue=np.float32(np.nan)
        )
    script = """import sys, pathlib
from jounce.web import worker, questions
from jounce.web.levels import write_levels
write_levels(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
print(*sorted({"xarray", "pandas", "scipy", "matplotlib", "numba"} & set(sys.modules)))"""
    words = [sys.executable, "-c", script, str(tmp_path / "plain.nc"), str(tmp_path / "kept")]
    done = subprocess.run(words, capture_output=True, text=True, check=True)
    assert done.stdout.split() == []
