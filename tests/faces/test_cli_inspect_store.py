"""The lane's store from the command line: import, watch, reevaluate, history, search, export, verify; damage."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from jounce.inspection.archive.store import Store
from jounce.inspection.limits import shipped_limits

CAR = """schema = "jounce.rig/1"
model = "quarter-car"
sprung = {mass = "400 kg"}
unsprung = {mass = "40 kg"}
strut = {spring = {rate = "25 N/mm"}, damper = {coefficient = "1000 N*s/m"}}
tyre = {stiffness = "200 N/mm"}
"""

LISTENING = """
import signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)  # what was started in the background ignores it
from jounce.cli import main
raise SystemExit(main(sys.argv[1:]))
"""


@pytest.fixture(scope="session")
def simulated(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A record of one wheel, made once."""
    from jounce.cli import main

    folder = tmp_path_factory.mktemp("simulated")
    (folder / "car.toml").write_text(CAR, encoding="utf-8")
    rig, record = str(folder / "car.toml"), str(folder / "one.csv")
    assert main(["inspect", "simulate", rig, "--method", "egea", "--out", record, "--json"]) == 0
    return folder / "one.csv"


@pytest.fixture
def lane(simulated: Path, tmp_path: Path) -> Path:
    """Three inspections of one car, one of another, with what the lane wrote beside them."""
    folder = tmp_path / "lane"
    folder.mkdir()
    cars = (
        ("a", "B-AB 123", 2024),
        ("b", "B-AB 123", 2025),
        ("c", "B-AB 123", 2026),
        ("d", "M-X 1", 2026),
    )
    for name, plate, year in cars:
        shutil.copy(simulated, folder / f"{name}.csv")
        told = (
            f'plate_number = "{plate}"\ndate = {year}-06-01\naxle = "front"\nvehicle = "Audi A6"\n'
        )
        (folder / f"{name}.toml").write_text(told, encoding="utf-8")
    return folder


def test_import_counts_the_warnings_of_a_record() -> None:
    from jounce.inspection.archive.lane import ImportedRecord
    from jounce.inspection.archive.storing import ImportedRecords
    from jounce.report.stores import imported_records_page

    kept = (
        ImportedRecord("a.csv", 1, True, "pass"),
        ImportedRecord("b.csv", 2, True, "fail", "", 2),
    )
    assert list(map(str, kept)) == ["accepted 1 a.csv: pass", "accepted 2 b.csv: fail, 2 warnings"]
    pages = [
        imported_records_page(ImportedRecords("lane.sqlite", records, {}), title="")
        for records in (kept, kept[:1])
    ]
    assert str(pages).count("column findings") == 1


def files_of(lane: Path) -> list[Path]:
    return sorted(lane.glob("*.csv"))


def imported(cli, lane: Path, *words: object):
    return cli(
        "inspect",
        "import",
        *files_of(lane),
        "--store",
        "lane.sqlite",
        "--tester",
        "egea-specsus2018",
        *words,
    )


def test_import_acknowledges_every_record_once(cli, lane) -> None:
    first = imported(cli, lane)
    assert [line.split()[:2] for line in first.out.splitlines()[:4]] == [
        ["accepted", str(n)] for n in (1, 2, 3, 4)
    ]
    again = imported(cli, lane, "--json").json
    assert [(one["number"], one["is_new"]) for one in again["records"]] == [
        (n, False) for n in (1, 2, 3, 4)
    ]
    store = Store("lane.sqlite")
    assert [len(store.gradings(number)) for number in store.numbers()] == [1] * 4
    assert store.content(1) == ((lane / "a.csv").read_bytes(), (lane / "a.toml").read_bytes())
    wheel = store.newest_grading(1).result["wheels"][0]
    assert wheel["grade"]["egea"]
    assert wheel["verdict"] == "pass"


def test_what_cannot_be_graded_is_stored_with_its_reason_and_exit_code_2(
    cli, tmp_path: Path
) -> None:
    (tmp_path / "bad.csv").write_text(
        '# plate_number = "B 1"\ntime [s], left.plate.z [mm], left.plate.force [N]\n0,1,x\n0.01,1,2\n'
    )
    (tmp_path / "empty.csv").write_text("")
    found = cli(
        "inspect",
        "import",
        "bad.csv",
        "empty.csv",
        "--store",
        "lane.sqlite",
        "--tester",
        "eusama",
        "--json",
    )
    assert found.exit_code == 2
    (record,) = found.json["records"]
    assert record["verdict"] == "not graded"
    assert record["problem"].startswith(
        "bad.csv, line 3: column 'left.plate.force [N]': text in a number column"
    )
    assert "the file is empty" in found.json["failed"]["empty.csv"]
    shown = cli(
        "inspect",
        "search",
        "--store",
        "lane.sqlite",
        "--plate",
        "b1",
        "--verdict",
        "not graded",
        "--json",
    ).json
    assert [one["name"] for one in shown["records"]] == ["bad.csv"]


def test_without_a_tester_nothing_is_guessed_and_reevaluate_takes_one(cli, lane) -> None:
    text = (lane / "a.csv").read_text()
    kept = [line for line in text.splitlines(keepends=True) if not line.startswith("# tester")]
    assert (
        cli("inspect", "import", lane / "b.csv", "--store", "named.sqlite").exit_code == 0
    )  # its header names one
    (lane / "a.csv").write_text("".join(kept))
    found = cli("inspect", "import", lane / "a.csv", "--store", "lane.sqlite", "--json")
    assert (found.exit_code, found.json["records"][0]["verdict"]) == (2, "not graded")
    assert "no tester" in found.json["records"][0]["problem"]
    again = cli(
        "inspect", "reevaluate", "--store", "lane.sqlite", "--tester", "egea-specsus2018", "--json"
    )
    assert again.exit_code == 0
    assert again.json["added"] == 1
    wheels = Store("lane.sqlite").newest_grading(1).result["wheels"]
    assert [wheel["verdict"] for wheel in wheels] == ["pass"]


def test_reevaluate_under_stricter_limits_adds_gradings(cli, lane, tmp_path: Path) -> None:
    imported(cli, lane)
    same = cli("inspect", "reevaluate", "--store", "lane.sqlite", "--workers", "1", "--json").json
    assert (same["records"], same["added"], same["unchanged"]) == (4, 0, 4)
    text = shipped_limits().read_text(encoding="utf-8")
    (tmp_path / "strict.toml").write_text(
        text.replace('version = "1"', 'version = "2"'), encoding="utf-8"
    )
    words = ("inspect", "reevaluate", "--store", "lane.sqlite", "--limits", "strict.toml", "--json")
    found = cli(*words, "--workers", "2").json
    assert (found["added"], found["failed"]) == (4, {})
    store = Store("lane.sqlite")
    first, second = store.gradings(1)
    assert first.limits != second.limits
    values = [[wheel["adhesion"] for wheel in one.result["wheels"]] for one in (first, second)]
    assert values[0] == values[1]
    read_again = cli(*words, "--from-files", "--workers", "1").json
    assert (read_again["added"], read_again["unchanged"]) == (0, 4)


def test_limits_that_are_wrong_change_nothing(cli, lane, tmp_path: Path) -> None:
    imported(cli, lane)
    (tmp_path / "bad.toml").write_text('schema = "jounce.limits/1"\nversion = 1\n')
    found = cli("inspect", "reevaluate", "--store", "lane.sqlite", "--limits", "bad.toml", "--json")
    assert found.exit_code == 2
    assert "bad.toml" in found.json["error"]["message"]
    assert [len(Store("lane.sqlite").gradings(n)) for n in (1, 2, 3, 4)] == [1] * 4
    missing = cli("inspect", "reevaluate", "--store", "none.sqlite")
    assert (missing.exit_code, "no such store" in missing.err, Path("none.sqlite").exists()) == (
        2,
        True,
        False,
    )


def test_history_search_export(cli, lane) -> None:
    imported(cli, lane)
    found = cli(
        "inspect", "history", "--plate", "b ab 123", "--store", "lane.sqlite", "--figure", "h.svg",
        "--report", "h.html", "--json",
    ).json  # fmt: skip
    assert [one["date"] for one in found["wheels"]] == ["2024-06-01", "2025-06-01", "2026-06-01"]
    assert {one["quantity"] for one in found["trends"]} == {
        "adhesion",
        "phase_angle_min_deg",
        "theta_road",
    }
    assert all(
        abs(one["change_per_year"]) < 1e-9 for one in found["trends"]
    )  # three times the same record
    assert Path("h.svg").read_text().startswith("<?xml")
    page = Path("h.html").read_text(encoding="utf-8")
    assert found["report"] == "h.html"
    assert all(text in page for text in ("2024-06-01", "adhesion", "%", "Change per year"))
    assert (
        "Change per year"
        in cli("inspect", "history", "--plate", "b ab 123", "--store", "lane.sqlite").out
    )
    shown = cli("inspect", "search", "--store", "lane.sqlite", "--since", "2026-01-01")
    assert "2 records" in shown.out
    assert (
        "4 records"
        in cli("inspect", "search", "--store", "lane.sqlite", "--tester", "egea-specsus2018").out
    )
    assert (
        cli(
            "inspect", "export", "--store", "lane.sqlite", "--out", "x.csv", "--plate", "M-X*"
        ).exit_code
        == 0
    )
    assert len(Path("x.csv").read_text().splitlines()) == 2
    assert cli("inspect", "verify", "--store", "lane.sqlite", "--json").json["problems"] == []


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("history", "--plate", "HH-1"), "no record of this number plate"),
        (
            ("history", "--plate", "M-X 1", "--figure", "h.xls"),
            "figures are not written in this format",
        ),
        (("search", "--verdict", "passed"), "Did you mean 'pass'?"),
        (("search", "--since", "1.1.2026"), "--since: not a date"),
        (("export", "--out", "lane.xls"), "tables are not written in this format"),
        (("export", "--out", "nowhere/lane.csv"), "output folder does not exist"),
        (("import", "none.csv"), "none.csv: no such file"),
        (("import", "lane/a.csv", "--tester", "eusamma"), "Did you mean 'eusama'?"),
        (("watch", "nowhere"), "no such folder"),
        (("watch", "lane", "--interval", "0 s"), "--interval: out of range"),
    ],
)
def test_wrong_requests_are_one_message(cli, lane, words, said) -> None:
    imported(cli, lane)
    found = cli("inspect", *words, "--store", "lane.sqlite")
    assert found.exit_code == 2
    assert said in found.err
    assert found.err.count("jounce: ") == 1


@pytest.mark.parametrize(
    ("words", "harm"),
    [
        *((("import", "lane/a.csv"), harm) for harm in ("truncated", "flipped", "text", "empty")),
        (("search",), "flipped"),
        (("reevaluate",), "truncated"),
        (("watch", "lane", "--once"), "empty"),
        (("verify",), "truncated"),
    ],
)
def test_a_damaged_store_is_reported_and_never_overwritten(cli, lane, words, harm) -> None:
    store = Path("lane.sqlite")
    opened = Store(store)
    opened.close()
    content = bytearray(store.read_bytes())
    if harm == "flipped":
        content[4096:4200] = bytes(value ^ 0xFF for value in content[4096:4200])
    broken = {
        "truncated": bytes(content[:9000]),
        "flipped": bytes(content),
        "text": b"plate;date\n",
        "empty": b"",
    }[harm]
    store.write_bytes(broken)
    found = cli("inspect", *words, "--store", store, "--json")
    assert found.exit_code == 2
    assert found.json["error"]["kind"] == "DamagedStoreError"
    assert store.read_bytes() == broken


def test_watch_once_takes_what_is_there(cli, lane) -> None:
    words = (
        "inspect",
        "watch",
        lane,
        "--store",
        "lane.sqlite",
        "--tester",
        "egea-specsus2018",
        "--once",
    )
    found = cli(*words, "--settle", "0.05 s", "--json").json
    assert [one["number"] for one in found["records"]] == [1, 2, 3, 4]
    assert cli(*words, "--settle", "0 s", "--json").json["records"] == []  # remembered
    assert len(files_of(lane)) == 4


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGTERM])
def test_watch_ends_cleanly_when_asked_to(lane, tmp_path: Path, how: signal.Signals) -> None:
    for name in "bcd":
        (lane / f"{name}.csv").unlink()
    words = [
        "inspect",
        "watch",
        str(lane),
        "--store",
        str(tmp_path / "w.sqlite"),
        "--settle",
        "0 s",
        "--interval",
        "50 ms",
        "--tester",
        "egea-specsus2018",
    ]
    process = subprocess.Popen(
        [sys.executable, "-c", LISTENING, *words],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert process.stdout.readline().startswith("accepted 1 ")
    process.send_signal(how)
    out, err = process.communicate(timeout=30)
    said = [
        line for line in err.splitlines() if not line.startswith("reading ")
    ]  # on a loaded machine
    assert (process.returncode, out.strip(), said) == (0, "1 new, 0 already known", [])


@pytest.mark.skipif(not hasattr(os, "fork"), reason="importers are forked")
@pytest.mark.slow
def test_two_hundred_kills_lose_nothing_and_leave_nothing_in_half(tmp_path: Path) -> None:
    script = Path(__file__).parents[1] / "twins" / "lane_kills.py"
    words = [sys.executable, str(script), str(tmp_path), "200", str(int(time.time()) % 1000)]
    done = subprocess.run(
        words, capture_output=True, text=True, check=False, env={**os.environ, "PYTHONWARNINGS": ""}
    )
    assert done.returncode == 0, done.stderr[-2000:]
    seen = json.loads(done.stdout)
    assert seen["kills"] >= 200
    assert seen["in_the_middle"] >= 20
    assert seen["stored"] >= seen["acknowledged"] > 200


def test_a_time_to_settle_below_zero_is_refused(cli, lane, tmp_path: Path) -> None:
    said = ("inspect", "watch", lane, "--store", tmp_path / "s.sqlite", "--settle=-1 s", "--once")
    outcome = cli(*said)
    assert outcome.exit_code == 2
    assert "--settle: out of range; found '-1 s'; allowed: 0 s or more" in outcome.err
    assert not (tmp_path / "s.sqlite").exists()


@pytest.mark.parametrize(
    ("what", "said"), [("lane/a.csv", "a file, not a folder"), ("nowhere", "no such folder")]
)
def test_watching_no_folder_leaves_no_store_behind(cli, lane, what: str, said: str) -> None:
    found = cli("inspect", "watch", what, "--store", "lane.sqlite", "--once")
    assert (found.exit_code, said in found.err) == (2, True)
    assert not [*Path().glob("lane.sqlite*")]
