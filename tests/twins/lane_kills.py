"""Kills importing processes at random moments and looks at what they leave; run by the test of crash safety.

Each round forks two importers that write into one store at once, through the command line. One of them is killed at
a random moment, often the other one, too. What was acknowledged on stdout must be in the store, byte for byte, with
its grading; nothing may be there in half. Some rounds start with a new store, so that its making is killed as well.

    python lane_kills.py FOLDER KILLS SEED [URL]    URL of a server's database, in which databases may be made
"""

from __future__ import annotations

import contextlib
import json
import os
import random
import signal
import sys
import time
from pathlib import Path

from jounce.cli import main
from jounce.inspection.archive.store import Store

FILES = 12


def new_store(folder: Path, name: str, server: str) -> str:
    """Where the next store will be: a file, or a database that is empty."""
    if not server:
        return str(folder / f"{name}.sqlite")
    from sqlalchemy import create_engine, make_url

    engine = create_engine(server, isolation_level="AUTOCOMMIT")
    with engine.connect() as connection:
        connection.exec_driver_sql(f"CREATE DATABASE kills_{name}")
    engine.dispose()
    return make_url(server).set(database=f"kills_{name}").render_as_string(hide_password=False)


def is_made(store: str) -> bool:
    if "://" not in store:
        return Path(store).exists()
    from sqlalchemy import create_engine, inspect

    engine = create_engine(store)
    tables = inspect(engine).get_table_names()
    engine.dispose()
    assert len(tables) in (0, 7), f"half a store: {tables}"
    return bool(tables)


def fork_importer(files: list[Path], store: str, out: Path) -> int:
    child = os.fork()
    if child == 0:
        with contextlib.suppress(BaseException):
            handle = os.open(out, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
            os.dup2(handle, 1)
            sys.stdout = os.fdopen(1, "w")
            main(["inspect", "import", *map(str, files), "--store", store])
        os._exit(0)
    return child


def acknowledged(out: Path) -> dict[str, int]:
    """Number by file of the whole lines on stdout."""
    lines = out.read_text().splitlines(keepends=True) if out.exists() else []
    words = [
        line.split()
        for line in lines
        if line.endswith("\n") and line.startswith(("accepted ", "known "))
    ]
    return {word[2].rstrip(":"): int(word[1]) for word in words}


def check_round(store: str, files: list[Path], told: dict[str, int]) -> int:
    """Everything acknowledged is there and whole; give the number of records of this round."""
    if not is_made(store):
        assert not told, "acknowledged without a store"
        return 0
    opened = Store(store, read_only=True)
    assert opened.problems() == []
    numbers = opened.numbers()
    for name, number in told.items():
        assert opened.content(number)[0] == Path(name).read_bytes()
    contents = {file.read_bytes() for file in files}
    for number in numbers[-len(files) :]:
        assert len(opened.gradings(number)) == 1, f"record {number} without its grading"
        assert opened.newest_grading(number).verdict == "not graded"
        opened.entry(number)
    found = sum(opened.content(number)[0] in contents for number in numbers[-len(files) :])
    opened.close()
    assert found >= len(told)
    return found


def write_files(folder: Path, name: str, rng: random.Random) -> list[Path]:
    files = []
    for i in range(2 * FILES):
        file = folder / f"{name}_{i}.csv"
        rows = "\n".join(str(rng.random()) for _ in range(rng.randrange(10, 4000)))
        file.write_text(f'# plate_number = "B {i}"\ntime [s], left.plate.z [mm]\n{rows}\n')
        files.append(file)
    return files


def undisturbed_time(folder: Path, rng: random.Random, server: str) -> float:
    """Time (s) of a round that nobody kills; everything is imported and compiled before it."""
    files = write_files(folder, "warm", rng)
    for name in ("cold", "warm"):
        store = new_store(folder, name, server)
        start = time.monotonic()
        main(["inspect", "import", *map(str, files), "--store", store, "--json"])
    return time.monotonic() - start


def run(folder: Path, kills: int, seed: int, server: str = "") -> dict[str, int]:
    rng = random.Random(seed)
    with Path(os.devnull).open("w") as nowhere, contextlib.redirect_stdout(nowhere):
        longest = undisturbed_time(folder, rng, server)
    seen = {
        "kills": 0,
        "rounds": 0,
        "in_the_middle": 0,
        "acknowledged": 0,
        "stored": 0,
        "unacknowledged": 0,
    }
    store, everything = new_store(folder, "0", server), {}
    while seen["kills"] < kills:
        seen["rounds"] += 1
        if seen["rounds"] % 10 == 0:
            store, everything = new_store(folder, str(seen["rounds"]), server), {}
        files = write_files(folder, str(seen["rounds"]), rng)
        outs = [folder / "first.out", folder / "second.out"]
        for out in outs:
            out.unlink(missing_ok=True)
        children = [
            fork_importer(files[k * FILES : (k + 1) * FILES], store, outs[k]) for k in (0, 1)
        ]
        time.sleep(rng.uniform(0.0, longest))
        for k, child in enumerate(children):
            if k == 0 or rng.random() < 0.7:
                os.kill(child, signal.SIGKILL)
            ended = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
            killed = ended == -signal.SIGKILL
            seen["kills"] += killed
            seen["in_the_middle"] += killed and 0 < len(acknowledged(outs[k])) < FILES
        told = acknowledged(outs[0]) | acknowledged(outs[1])
        stored = check_round(store, files, told)
        seen["acknowledged"] += len(told)
        seen["stored"] += stored
        seen["unacknowledged"] += stored - len(told)
        everything |= told
    opened = Store(store)  # and one can go on writing
    for name, number in everything.items():
        assert opened.content(number)[0] == Path(name).read_bytes()
    opened.close()
    return seen


if __name__ == "__main__":
    sys.stdout.write(
        json.dumps(run(Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]), *sys.argv[4:]))
    )
