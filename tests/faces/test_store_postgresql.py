"""The lane's store on PostgreSQL: a private server, started for these tests where its programs are installed."""

from __future__ import annotations

import contextlib
import importlib.util
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from itertools import count
from pathlib import Path

import pytest

from jounce.core.errors import OutputError, RecordingError
from jounce.inspection.archive.entries import Grading, RecordEntry
from jounce.inspection.archive.store import Store

PASSWORD = "gehe1m:nis"
WRITTEN = "gehe1m%3Anis"
PASS = Grading("pass", "limits 1", "0.1", {"adhesion": 0.6})
SHUT_DOWN_FAST, WAIT = 2, 60.0


def programs() -> Path | None:
    """Folder of the newest PostgreSQL's programs."""
    installed = sorted(
        Path("/usr/lib/postgresql").glob("*/bin/initdb"), key=lambda file: int(file.parts[-3])
    )
    on_path = shutil.which("initdb")
    return installed[-1].parent if installed else Path(on_path).parent if on_path else None


class Server:
    """A cluster of its own in a new folder, reached through a socket in it."""

    def __init__(self, folder: Path, binaries: Path) -> None:
        self.folder, self._binaries, self._process = folder, binaries, None
        self._names = count()
        self._account = {}
        if os.geteuid() == 0:  # PostgreSQL refuses to be root
            self._account = {"user": "nobody", "extra_groups": []}
            shutil.chown(folder, "nobody")
        secret = folder / "password"
        secret.write_text(PASSWORD, encoding="utf-8")
        words = [
            "-D",
            folder / "data",
            "-U",
            "lane",
            "-A",
            "scram-sha-256",
            "--pwfile",
            secret,
            "-E",
            "UTF8",
            "-N",
        ]
        self._run("initdb", *words, "--locale=C")
        self.start()

    def _run(self, name: str, *words: object) -> None:
        command = [str(self._binaries / name), *map(str, words)]
        subprocess.run(
            command, check=True, capture_output=True, cwd=self.folder, timeout=WAIT, **self._account
        )

    def start(self) -> None:
        words = [
            "-D",
            self.folder / "data",
            "-k",
            self.folder,
            "-c",
            "listen_addresses=",
            "-c",
            "fsync=off",
        ]
        with (self.folder / "log").open("ab") as log:
            self._process = subprocess.Popen(
                [str(self._binaries / "postgres"), *map(str, words)],
                cwd=self.folder, stdout=log, stderr=log, **self._account,
            )  # fmt: skip
        end = time.monotonic() + WAIT
        while True:
            with contextlib.suppress(subprocess.CalledProcessError):
                self._run("pg_isready", "-h", self.folder)
                return
            assert time.monotonic() < end, (self.folder / "log").read_text()
            time.sleep(0.05)

    def stop(self) -> None:
        self._process.send_signal(SHUT_DOWN_FAST)
        self._process.wait(WAIT)

    def url(self, database: str, password: str = WRITTEN) -> str:
        return f"postgresql+psycopg://lane:{password}@/{database}?host={self.folder}"

    def sql(self, statement: str, database: str = "postgres") -> None:
        import psycopg

        with psycopg.connect(
            host=str(self.folder), user="lane", password=PASSWORD, dbname=database
        ) as connection:
            connection.autocommit = True
            connection.execute(statement)

    def new_database(self) -> str:
        name = f"lane_{next(self._names)}"
        self.sql(f"CREATE DATABASE {name}")
        return self.url(name)


@pytest.fixture(scope="module")
def server() -> Iterator[Server]:
    binaries = programs()
    if binaries is None:
        pytest.skip("PostgreSQL is not installed here (no initdb)")
    if importlib.util.find_spec("psycopg") is None:
        pytest.skip("its driver is not installed here (the extra postgresql)")
    folder = Path(
        tempfile.mkdtemp(prefix="jounce-pg-", dir="/tmp")
    )  # a socket's path must be short
    try:
        started = Server(folder, binaries)
        yield started
        started.stop()
    finally:
        shutil.rmtree(folder, ignore_errors=True)


@pytest.fixture
def opened() -> Iterator[Callable[..., Store]]:
    """Open a store that is closed after the test."""
    stores: list[Store] = []

    def open_one(location: str, **how: bool) -> Store:
        stores.append(Store(location, **how))
        return stores[-1]

    yield open_one
    for store in stores:
        store.close()


@pytest.fixture
def database(server: Server) -> str:
    return server.new_database()


def entry(i: int = 0, **known: object) -> RecordEntry:
    content = f"record {i}\n".encode() + bytes(range(256))
    return RecordEntry(
        f"{i}.csv", content, **{"plate": f"B-AB {i}", "date": f"2026-01-{1 + i % 28:02}", **known}
    )


def test_records_come_back_as_they_came_in(opened, database) -> None:
    store = opened(database)
    given = entry(
        7,
        sidecar=b'plate_number = "B-AB 7"\n',
        tester_table={"kind": "rigid-plate"},
        signals=b"\0\1",
    )
    assert store.accept(given, PASS) == (1, True)
    assert store.accept(given, PASS) == (1, False)
    store.add_gradings(
        [(1, Grading("fail", "limits 2", "0.1", {"adhesion": 0.2, "text": "a\0b\ud800"}))]
    )
    assert store.content(1) == (given.content, given.sidecar)
    assert store.signals(1) == b"\0\1"
    assert store.entry(1).tester_table == {"kind": "rigid-plate"}
    assert [found.verdict for found in store.gradings(1)] == ["pass", "fail"]
    assert [
        found.plate
        for found in store.records(plate="b ab*", since="2026-01-08", until="2026-01-08")
    ] == ["B-AB 7"]
    assert store.problems() == []


def test_texts_that_are_none_are_stored_all_the_same(opened, database) -> None:
    store = opened(database)
    store.accept(RecordEntry("a\udcff\0.csv", b"1", plate="B\0-1"), PASS)
    store.note_watched("/lane/a\udcff.csv", 1, 2, "no\0record")
    assert [found.name for found in store.records(plate="B1")] == ["a\ufffd\ufffd.csv"]
    assert store.watched_files() == {"/lane/a\ufffd.csv": (1, 2)}
    assert store.problems() == []


def test_many_writers_at_once_lose_nothing_and_make_the_tables_once(opened, database) -> None:
    def write(k: int) -> None:
        store = opened(database)
        for i in range(8):
            store.accept(
                entry(i // 2 if k % 2 else 10 * k + i, tester_table={"of": i}), PASS
            )  # some of them the same
            store.note_watched(f"/lane/{i}.csv", k, i)

    with ThreadPoolExecutor(4) as pool:
        list(pool.map(write, range(4)))
    store = opened(database)
    assert len(store.numbers()) == 8 + 8 + 4 - 4
    assert [len(store.gradings(number)) for number in store.numbers()] == [1] * 16
    assert len(store.watched_files()) == 8
    assert store.problems() == []


def test_a_store_goes_on_after_its_server_was_away(server: Server, opened, database) -> None:
    store = opened(database)
    store.accept(entry(1), PASS)
    server.stop()
    try:
        with pytest.raises(OutputError, match="the store cannot be used") as caught:
            store.accept(entry(2), PASS)
        assert caught.value.where == store.location
        with pytest.raises(OutputError, match="Check the server"):
            opened(database, read_only=True)
    finally:
        server.start()
    assert store.accept(entry(2), PASS) == (2, True)
    assert len(store.numbers()) == 2


def test_a_reader_needs_no_right_to_write(server: Server, opened, database) -> None:
    opened(database).accept(entry(), PASS)
    name = database.partition("@/")[2].partition("?")[0]
    server.sql("CREATE ROLE guest LOGIN PASSWORD 'guest'")
    server.sql("GRANT SELECT ON ALL TABLES IN SCHEMA public TO guest", name)
    guest = server.url(name).replace(f"lane:{WRITTEN}", "guest:guest")
    assert len(opened(guest, read_only=True).records()) == 1
    with pytest.raises(OutputError, match="permission denied"):
        opened(guest).accept(entry(1), PASS)


def test_another_database_is_left_alone(server: Server, opened, database) -> None:
    name = database.partition("@/")[2].partition("?")[0]
    with pytest.raises(RecordingError, match="a different kind of database; found 'no table'"):
        opened(database, read_only=True)
    server.sql("CREATE TABLE records (number integer)", name)
    with pytest.raises(RecordingError, match="a different kind of database; found 'records'"):
        opened(database)
    server.sql("DROP TABLE records", name)
    opened(database)
    server.sql("UPDATE about SET value = 'jounce.store/0'", name)
    with pytest.raises(RecordingError, match=r"a different version; found 'jounce\.store/0'"):
        opened(database)


def test_altered_rows_are_reported(server: Server, opened, database) -> None:
    store = opened(database)
    store.accept(entry(1), PASS)
    store.accept(entry(2), PASS)
    server.sql(
        "UPDATE results SET verdict = 'fail' WHERE record = 2",
        database.partition("@/")[2].partition("?")[0],
    )
    assert store.problems() == ["a grading of record 2 is damaged"]
    assert [found.name for found in store.readable_records()[0]] == ["1.csv", "2.csv"]


@pytest.fixture(scope="module")
def records(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Two inspections of a car, one of another."""
    import jounce as jn
    from jounce.parts.testers import load_tester
    from jounce.testers.testing import simulate_test

    folder, tester = tmp_path_factory.mktemp("records"), load_tester("eusama")
    files = []
    for i, (plate, year) in enumerate((("B-AB 123", 2025), ("B-AB 123", 2026), ("M-X 1", 2026))):
        run = simulate_test(
            jn.load("audi-a6-quarter-car"), tester, wheel="left", noise=0.01, seed=i, truth=False
        )
        head = f'# tester = "eusama"\n# plate_number = "{plate}"\n# date = {year}-06-01\n# axle = "front"\n'
        head += f'# left.static_load = "{run.attrs["left.static_load"]} N"\n'
        rows = zip(
            *(run[name].to_numpy() for name in ("time", "left.plate.z", "left.plate.force")),
            strict=True,
        )
        table = "\n".join(f"{t:.3f}, {1e3 * z:.4f}, {force:.1f}" for t, z, force in rows)
        files.append(folder / f"{i}.csv")
        files[-1].write_text(
            f"{head}time [s], left.plate.z [mm], left.plate.force [N]\n{table}\n", encoding="utf-8"
        )
    return files


def test_the_whole_lane(cli, database, records, tmp_path: Path) -> None:
    (tmp_path / "lane").mkdir()
    shutil.copy(records[2], tmp_path / "lane")
    evaluated = cli(
        "inspect", "evaluate", records[0], "--tester", "eusama", "--store", database, "--json"
    )
    assert evaluated.json["store"]["records"] == [1]
    done = cli("inspect", "import", *records[:2], "--store", database)
    assert done.out.splitlines()[-1] == "1 new, 1 already known"
    watched = cli("inspect", "watch", "lane", "--once", "--settle", "0 s", "--store", database)
    assert watched.out.startswith("accepted 3 lane/2.csv")
    again = cli(
        "inspect", "reevaluate", "--store", database, "--from-files", "--workers", "2", "--json"
    )
    assert (again.json["records"], again.json["unchanged"], again.json["failed"]) == (3, 3, {})
    history = cli("inspect", "history", "--plate", "b ab 123", "--store", database, "--json")
    assert history.json["records"] == [1, 2]
    assert (
        len(
            cli("inspect", "search", "--store", database, "--since", "2026-01-01", "--json").json[
                "records"
            ]
        )
        == 2
    )
    exported = cli("inspect", "export", "--store", database, "--out", "lane.csv", "--json")
    assert exported.json["rows"] == 3
    verified = cli("inspect", "verify", "--store", database)
    assert verified.out.strip().endswith("sound, 3 records")
    for outcome in (evaluated, done, watched, again, history, exported, verified):
        assert outcome.exit_code == 0
        assert WRITTEN not in outcome.out + outcome.err
        assert PASSWORD not in outcome.out + outcome.err


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (("host=", "host=/nowhere"), "No such file or directory"),
        ((WRITTEN, "wr0ng-one"), "password authentication failed"),
        (("@/lane", "@/nolane"), "does not exist"),
        (("postgresql+psycopg", "postgresql+nodriver"), "unknown kind of database"),
        (("@/", "@host:port/"), "the database address cannot be read"),
        (("%3A", ":@"), ""),
    ],
)
@pytest.mark.parametrize("words", [("search",), ("reevaluate",), ("import", "0.csv")])
def test_what_is_wrong_with_the_server_is_one_line_without_the_password(
    cli, database, records, tmp_path: Path, change, said, words
) -> None:
    shutil.copy(records[0], tmp_path)
    outcome = cli("inspect", *words, "--store", database.replace(*change))
    assert (outcome.exit_code, outcome.out) == (2, "")
    assert len(outcome.err.strip().splitlines()) == 1
    assert said in outcome.err
    for secret in ("gehe1m", "nis", "wr0ng"):
        assert secret not in outcome.err


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "fork"), reason="importers are forked")
@pytest.mark.parametrize("kills", [2, pytest.param(60, marks=pytest.mark.slow)])
def test_killed_importers_lose_nothing_and_leave_nothing_in_half(
    server: Server, tmp_path: Path, kills: int
) -> None:
    script = Path(__file__).parents[1] / "twins" / "lane_kills.py"
    words = [
        sys.executable,
        str(script),
        str(tmp_path),
        str(kills),
        str(int(time.time()) % 1000),
        server.url("postgres"),
    ]
    done = subprocess.run(
        words, capture_output=True, text=True, check=False, env={**os.environ, "PYTHONWARNINGS": ""}
    )
    assert done.returncode == 0, done.stderr[-2000:]
    seen = json.loads(done.stdout)
    assert seen["kills"] >= kills
    assert seen["stored"] >= seen["acknowledged"]
