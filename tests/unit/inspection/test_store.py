"""The record store: idempotence, gradings that add up, several writers, damage, other databases."""

from __future__ import annotations

import os
import random
import shutil
import sqlite3
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import pytest

from jounce.core import writing
from jounce.core.errors import DescriptionError, JounceError, OutputError, RecordingError
from jounce.inspection.archive import database
from jounce.inspection.archive.database import DamagedStoreError
from jounce.inspection.archive.entries import Grading, RecordEntry, digest_of, plate_key
from jounce.inspection.archive.store import Store

PASS = Grading("pass", "limits 1", "0.1", {"adhesion": 0.6})
FAIL = Grading("fail", "limits 2", "0.1", {"adhesion": 0.6})


def entry(i: int = 0, **known: object) -> RecordEntry:
    content = f"record {i}\n".encode() + random.Random(i).randbytes(3000)
    return RecordEntry(
        f"{i}.csv", content, **{"plate": f"B-AB {i}", "date": f"2026-01-{1 + i % 28:02}", **known}
    )


@pytest.fixture(params=["file", "sqlite:///", "sqlite+pysqlite:///"])
def location(request, tmp_path: Path) -> str:
    """A file, and the same through a database URL; the last takes the way of every other database."""
    return ("" if request.param == "file" else request.param) + str(tmp_path / "lane.sqlite")


def test_a_store_that_cannot_be_made_is_one_message_and_leaves_nothing(
    tmp_path: Path, monkeypatch
) -> None:
    made = []

    def fails(engine: object) -> None:
        made.append([file.name for file in tmp_path.iterdir()])
        raise sqlite3.OperationalError("disk I/O error")

    monkeypatch.setattr(database, "create_tables", fails)
    with pytest.raises(
        OutputError, match=r"lane\.sqlite: the store cannot be used: disk I/O error"
    ):
        Store(str(tmp_path / "lane.sqlite"))
    assert made
    assert all(
        name.startswith(".jounce-") for name in made[0]
    )  # what the next process sweeps, were this one killed
    assert list(tmp_path.iterdir()) == []


def test_what_a_process_left_that_was_killed_when_the_store_had_its_name_goes(
    tmp_path: Path,
) -> None:
    Store(str(tmp_path / "lane.sqlite")).close()
    left = tmp_path / f".jounce-{writing._machine()}-{os.getpid()}-000000-x.sqlite-wal"
    left.write_bytes(b"")
    writing._sweep.cache_clear()
    Store(str(tmp_path / "lane.sqlite"), read_only=True).close()
    assert left.exists()
    Store(str(tmp_path / "lane.sqlite")).close()
    assert left.exists() == (os.name != "posix")
    writing._sweep.cache_clear()


def test_record_comes_back_as_it_came_in(location) -> None:
    store = Store(location)
    one = entry(
        1,
        sidecar=b'axle = "rear"',
        tester="eusama",
        tester_table={"stroke": 6e-3},
        methods=("egea", "eusama"),
    )
    number, is_new = store.accept(one, PASS)
    assert is_new
    assert store.content(number) == (one.content, one.sidecar)
    known = store.entry(number)
    assert (known.tester_table, known.vehicle_table, known.methods) == (
        {"stroke": 6e-3},
        None,
        ("egea", "eusama"),
    )
    assert store.gradings(number) == [PASS]
    assert Store(location).records()[0].grading == PASS
    assert store.problems() == []


def test_same_bytes_are_one_record_whatever_their_name(location) -> None:
    store = Store(location)
    number, _ = store.accept(entry(1), PASS)
    assert store.accept(replace(entry(1), name="copy.csv", plate="other"), FAIL) == (number, False)
    assert store.gradings(number) == [PASS]
    assert store.accept(replace(entry(1), sidecar=b""), None)[1]
    assert digest_of(b"ab", b"c") != digest_of(b"a", b"bc") != digest_of(b"abc", None)


def test_gradings_are_added_and_the_newest_counts(location) -> None:
    store = Store(location)
    numbers = [store.accept(entry(i), PASS)[0] for i in range(3)]
    store.add_gradings([(number, FAIL) for number in numbers[:2]])
    assert [record.grading.verdict for record in store.records()] == ["fail", "fail", "pass"]
    assert [record.number for record in store.records(verdict="pass")] == numbers[2:]
    assert store.gradings(numbers[0]) == [PASS, FAIL]


def test_a_batch_of_gradings_goes_in_whole_or_not_at_all(tmp_path: Path) -> None:
    store = Store(tmp_path / "lane.sqlite")
    number, _ = store.accept(entry(), PASS)
    with pytest.raises(Exception, match="FOREIGN KEY"):
        store.add_gradings([(number, FAIL), (99, FAIL)])
    assert store.gradings(number) == [PASS]


def test_search(location) -> None:
    store = Store(location)
    for i in range(5):
        store.accept(entry(i, tester="eusama" if i % 2 else "boge"), PASS)
    store.accept(entry(9, plate="", date=""), None)
    assert [record.name for record in store.records(plate="b ab3")] == ["3.csv"]
    assert len(store.records(plate="B-A*")) == 5
    assert (
        len(store.records(plate="%")) == 1
    )  # only the one without a plate: a wildcard of SQL means nothing
    assert [record.name for record in store.records(since="2026-01-02", until="2026-01-03")] == [
        "1.csv",
        "2.csv",
    ]
    assert [record.name for record in store.records(tester="eusama")] == ["1.csv", "3.csv"]
    assert plate_key("ö-x 1") == "ÖX1"


def test_read_only_store_refuses_to_write(location) -> None:
    Store(location).accept(entry(), PASS)
    store = Store(location, read_only=True)
    with pytest.raises(OutputError, match="reading only"):
        store.accept(entry(1), PASS)
    assert len(store.records()) == 1


def test_no_store_is_made_for_reading(tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match="no such store"):
        Store(tmp_path / "lane.sqlite", read_only=True)
    with pytest.raises(OutputError, match="folder"):
        Store(tmp_path / "nowhere" / "lane.sqlite")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("location", ["nosuch://x/y", "://", "oracle+nosuch://x"])
def test_a_location_that_means_nothing_is_refused(location) -> None:
    with pytest.raises(DescriptionError, match="database"):
        Store(location)


def test_readers_do_not_wait_for_a_writer(tmp_path: Path) -> None:
    file = tmp_path / "lane.sqlite"
    store = Store(file)
    store.accept(entry(), PASS)
    writer = sqlite3.connect(file, isolation_level=None)
    writer.execute("BEGIN IMMEDIATE")
    assert len(store.records()) == len(Store(file, read_only=True).records()) == 1
    writer.close()


def test_many_writers_at_once_lose_nothing(location) -> None:
    Store(location)

    def write(k: int) -> None:
        store = Store(location)
        for i in range(8):
            store.accept(
                entry(i // 2 if k % 2 else 10 * k + i, tester_table={"of": i}), PASS
            )  # some of them the same
        store.close()

    with ThreadPoolExecutor(4) as pool:
        list(pool.map(write, range(4)))
    store = Store(location)
    assert len(store.numbers()) == 8 + 8 + 4 - 4  # 0..7 and 20..27; 0..3 are among the first
    assert [len(store.gradings(number)) for number in store.numbers()] == [1] * 16
    assert store.problems() == []


_WRITER = """
import sys
from jounce.inspection.archive.store import Grading, RecordEntry, Store
store = Store(sys.argv[1])
for i in range(25):
    print(store.accept(RecordEntry(f"{i}", f"{sys.argv[2]} {i}".encode()), Grading("pass", "", "", {}))[0], flush=True)
"""


def test_two_processes_write_at_once_into_a_store_that_neither_finds(tmp_path: Path) -> None:
    file = tmp_path / "lane.sqlite"
    processes = [
        subprocess.Popen(
            [sys.executable, "-c", _WRITER, str(file), name], stdout=subprocess.PIPE, text=True
        )
        for name in ("a", "b")
    ]
    numbers = [
        int(line)
        for process in processes
        for line in process.communicate(timeout=60)[0].splitlines()
    ]
    assert sorted(numbers) == Store(file).numbers() == list(range(1, 51))
    assert [path.name for path in tmp_path.iterdir() if path.suffix == ".new"] == []


@pytest.fixture
def sound(tmp_path: Path) -> Path:
    """A closed store of 30 records."""
    store = Store(tmp_path / "sound.sqlite")
    for i in range(30):
        store.accept(entry(i), PASS)
    store.close()
    return tmp_path / "sound.sqlite"


@pytest.mark.parametrize("kept", [0, 1, 90, 100, 4096, 10000, 40960, -4096, -1])
def test_a_truncated_store_is_reported_and_left_alone(sound: Path, kept: int) -> None:
    content = sound.read_bytes()[:kept]
    sound.write_bytes(content)
    for read_only in (False, True):
        with pytest.raises(DamagedStoreError, match="left unchanged"):
            Store(sound, read_only=read_only)
    assert sound.read_bytes() == content


@pytest.mark.parametrize(
    "content", [b"plate,verdict\n", b"\0" * 8192, b"SQLite format 3\0" + b"\7" * 9000]
)
def test_another_file_is_never_overwritten(tmp_path: Path, content: bytes) -> None:
    file = tmp_path / "lane.sqlite"
    file.write_bytes(content)
    with pytest.raises(RecordingError):
        Store(file)
    assert file.read_bytes() == content


def test_another_database_is_never_written_to(tmp_path: Path) -> None:
    file = tmp_path / "music.sqlite"
    with closing(sqlite3.connect(file)) as connection, connection:
        connection.execute("CREATE TABLE songs (name)")
    connection.close()
    content = file.read_bytes()
    with pytest.raises(RecordingError, match=r"a different kind of database; found 'songs'"):
        Store(file)
    assert file.read_bytes() == content
    assert [path.name for path in tmp_path.iterdir()] == ["music.sqlite"]


def test_a_store_of_another_version_is_refused(sound: Path) -> None:
    with closing(sqlite3.connect(sound)) as connection, connection:
        connection.execute("UPDATE about SET value = 'jounce.store/9'")
    connection.close()
    with pytest.raises(RecordingError, match=r"a different version; found 'jounce.store/9'"):
        Store(sound)


def test_small_tables_are_checked_whenever_a_store_is_opened(sound: Path) -> None:
    with closing(sqlite3.connect(sound)) as connection, connection:
        (root,) = connection.execute(
            "SELECT rootpage FROM sqlite_master WHERE name = 'about'"
        ).fetchone()
    connection.close()
    content = bytearray(sound.read_bytes())
    content[(root - 1) * int.from_bytes(content[16:18], "big") + 7] ^= (
        4  # how many bytes lie loose in the page
    )
    sound.write_bytes(content)
    with pytest.raises(DamagedStoreError, match="Fragmentation"):
        Store(sound)


def test_flipped_bits_never_give_a_wrong_record_and_never_a_write(sound: Path) -> None:
    """Whatever bit is flipped: the store is refused, or a record is, or what comes out is what came in."""
    whole = sound.read_bytes()
    expected = [entry(i) for i in range(30)]
    rng, refused, noticed = random.Random(5), 0, 0
    for _ in range(60):
        content = bytearray(whole)
        place = rng.choice([rng.randrange(len(whole)), rng.randrange(4096, len(whole))])
        content[place] ^= 1 << rng.randrange(8)
        sound.write_bytes(content)
        try:
            store = Store(sound, read_only=True)
        except JounceError:
            refused += 1
        else:
            for number, one in enumerate(expected, 1):
                try:
                    assert store.content(number)[0] == one.content
                except RecordingError:
                    noticed += 1
            store.close()
        assert sound.read_bytes() == bytes(content)
    assert refused > 0
    assert noticed > 0


@pytest.mark.parametrize(
    ("text", "what"),
    [(b'{"adhesion": 0.6}', "a grading of record"), (b"B-AB 17", "the metadata of")],
)
def test_a_flipped_digit_never_becomes_another_verdict_or_car(
    sound: Path, text: bytes, what: str
) -> None:
    content = bytearray(sound.read_bytes())
    assert text in content
    for start in range(len(content)):
        if content.startswith(text, start):
            content[start + len(text) - 2] ^= 2
    sound.write_bytes(content)
    store = Store(sound, read_only=True)
    with pytest.raises(DamagedStoreError, match=what):
        store.records()
    assert any(what in problem for problem in store.problems())
    records, lost = Store(sound, damaged=True).readable_records()
    assert (len(records), len(lost)) == ((30, 30) if "grading" in what else (29, 1))
    assert what in lost[0]
    assert sound.read_bytes() == bytes(content)


@pytest.mark.parametrize("torn", [4096, 8192, 40960])
def test_what_can_be_read_of_a_torn_store_is_read(sound: Path, torn: int) -> None:
    content = sound.read_bytes()[:-torn]
    sound.write_bytes(content)
    with pytest.raises(DamagedStoreError):
        Store(sound)
    records, lost = Store(sound, damaged=True).readable_records()
    assert 15 < len(records) <= 30
    expected = {one.name: one.date for one in map(entry, range(30))}
    assert all(
        expected[record.name] == record.date and record.grading in (PASS, None)
        for record in records
    )
    assert len(lost) > 0 or len(records) == 30
    assert sound.read_bytes() == content


def test_a_store_can_be_copied_and_goes_on(sound: Path, tmp_path: Path) -> None:
    shutil.copy(sound, tmp_path / "copy.sqlite")
    store = Store(tmp_path / "copy.sqlite")
    assert store.accept(entry(99), FAIL) == (31, True)
    assert [record.number for record in store.records(verdict="fail")] == [31]


def test_packed_signals_are_the_same_bit_by_bit() -> None:
    import numpy as np

    from jounce.inspection.archive.entries import pack, unpack
    from jounce.recordings import recording

    rng = np.random.default_rng(3)
    time = np.arange(500) / 1000.0
    force = np.round(rng.normal(4000.0, 500.0, 500), 1)
    channels = {
        "left.plate.z": (np.round(rng.normal(0.0, 3.0, 500), 4) * 1e-3, "m", ""),
        "left.plate.force": (force, "N", ""),
        "right.plate.force": (rng.normal(size=500), "N", ""),  # no decimals
        "right.plate.z": (np.where(force > 4000.0, -0.0, np.nan), "m", ""),
    }
    record = recording(
        time, channels, attributes={"left.static_load": 4000.5, "plate_number": "Ö 1"}
    )
    again, findings = unpack(pack(record))
    for name in record.variables:
        assert again[name].values.tobytes() == record[name].values.tobytes(), name
    assert again.identical(record)
    assert findings == []
    packed = pack(record)
    for broken in (b"", packed[:-9], packed[:50] + b"?" + packed[51:]):
        with pytest.raises(RecordingError, match="packed"):
            unpack(broken)


class TestWithoutHardLinks:
    """File systems without hard links (FAT, some network shares) hold stores as well."""

    @pytest.fixture(autouse=True)
    def no_links(self, monkeypatch):
        def refuse(*_):
            raise PermissionError(1, "Operation not permitted")

        monkeypatch.setattr(Path, "hardlink_to", refuse)

    def test_store_is_made(self, tmp_path):
        with closing(Store(tmp_path / "lane.sqlite")) as store:
            assert store.numbers() == []
        assert [file.name for file in tmp_path.iterdir() if "sqlite-" not in file.name] == [
            "lane.sqlite"
        ]

    def test_claim_left_over_is_overcome(self, tmp_path, monkeypatch):
        monkeypatch.setattr(database, "_CLAIMED", 0.05)
        (tmp_path / ".lane.sqlite.claim").touch()
        with closing(Store(tmp_path / "lane.sqlite")) as store:
            assert store.numbers() == []
        assert not (tmp_path / ".lane.sqlite.claim").exists()

    def test_faster_process_wins(self, tmp_path):
        """What is there already is never replaced."""
        made, file = tmp_path / "made", tmp_path / "lane.sqlite"
        made.write_text("second")
        file.write_text("first")
        database._give_name(made, file)
        assert file.read_text() == "first"
