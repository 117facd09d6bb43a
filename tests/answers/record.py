"""Record what commands answer, and compare it with what they answered before.

    python tests/answers/record.py FILE.json             record answers of all lines of commands.txt
    python tests/answers/record.py FILE.json --compare   print what differs from the record; exit code 1 if data differ

A rewrite that is meant to change no behaviour is checked against a record made before it. Data (`--json`), exit codes,
errors and options must stay; texts of tables are listed separately, since they may change on purpose. `answers.json`
is such a record: golden, from our own runs, no validation. Numbers are equal within 1e-4 of their size, since
processors round differently.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import json
import os
import re
import shlex
import sys
import tempfile
import time
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np

import jounce as jn
from jounce.cli import main
from jounce.cli.entry import _command
from jounce.cli.reply import Reply, console
from jounce.web import command as _workbench  # noqa: F401 - it adds its command

HERE, SOURCE = Path(__file__).parent, Path(jn.__file__).parent
TOLERANCE = 1e-4  # of the size of a number
LONG = 6  # items: a longer list is recorded by a few of them
VARYING = {
    "cache", "system", "python", "created", "date", "digest", "seconds", "elapsed", "imported", "jounce", "commit",
    "casadi", "llvmlite", "numba", "numpy", "scipy", "sha256", "file_digest", "cpu_seconds", "stored", "changed",
}  # fmt: skip
"""Keys whose values differ from run to run."""


def make_files(folder: Path) -> None:
    """Write what the commands read."""
    for name, text in json.loads((HERE / "files.json").read_text(encoding="utf-8")).items():
        (folder / name).write_text(text, encoding="utf-8")
    way = np.concatenate([np.linspace(0.0, 15.0, 31), np.linspace(14.5, 0.0, 30)])
    for number, rate in enumerate((22.70, 22.76), 1):
        write_csv(
            folder / f"spring_{number}.csv", {"displacement [mm]": way, "force [N]": rate * way}
        )
    time_, draw = np.arange(0.0, 4.0, 2e-3), np.random.default_rng(1)
    swing = 20.0 * np.exp(-3.7 * time_) * np.cos(33.7 * time_) + 0.02 * draw.standard_normal(
        time_.size
    )
    write_csv(folder / "decay.csv", {"time [s]": time_, "sprung.z [mm]": swing})
    stroke = 10.0 * np.sin(2.0 * np.pi * 1.5 * time_)
    velocity = 10.0 * 2.0 * np.pi * 1.5 * np.cos(2.0 * np.pi * 1.5 * time_)
    force = np.where(velocity > 0.0, 0.5, 1.1) * velocity + 0.2 * draw.standard_normal(time_.size)
    write_csv(
        folder / "damper.csv", {"time [s]": time_, "displacement [mm]": stroke, "force [N]": force}
    )
    time_ = np.arange(0.0, 20.0, 5e-3)
    shake = np.convolve(draw.standard_normal(time_.size + 40), np.hanning(41), "valid")[
        : time_.size
    ]
    write_csv(folder / "lap.csv", {"time [s]": time_, "AccZ [m/s^2]": shake})
    way = np.arange(0.0, 200.0, 0.25)
    write_csv(
        folder / "track.csv",
        {"distance [m]": way, "height [mm]": np.cumsum(draw.standard_normal(way.size))},
    )
    rig = jn.load("formula-student-front").with_changes({"hardpoints.tie_rod_inner[2]": 0.145})
    sweep = jn.sweep_travel(rig, np.linspace(-0.02, 0.02, 5))
    columns = {
        "wheel_travel [mm]": 1e3 * np.linspace(-0.02, 0.02, 5),
        "toe [deg]": np.degrees(sweep["toe"].values),
    }
    write_csv(folder / "poses.csv", columns)


def write_csv(file: Path, columns: Mapping[str, Any]) -> None:
    """Write columns of numbers below their names."""
    rows = zip(*columns.values(), strict=True)
    lines = [",".join(columns), *(",".join(f"{value:.9g}" for value in row) for row in rows)]
    file.write_text("\n".join([*lines, ""]), encoding="utf-8")


def answers(words: str) -> Iterator[tuple[str, dict[str, Any]]]:
    """Run the commands that begin with some words in an empty folder; give each line with its answer."""
    lines = (HERE / "commands.txt").read_text(encoding="utf-8").splitlines()
    lines = [line for line in lines if line.strip() and line.startswith(words)]
    with tempfile.TemporaryDirectory() as name, contextlib.chdir(name):
        make_files(Path(name))
        for line in lines:
            if not line.startswith("#"):
                yield line, answer(shlex.split(line), name)


def answer(words: list[str], folder: str) -> dict[str, Any]:
    """Run one command line; give its exit code, its data, its text and what it wrote."""
    shown: list[str] = []
    usual = Reply.show

    def show(reply: Reply) -> int:
        text = io.StringIO()
        with contextlib.redirect_stdout(text):
            reply.draw(console())
        shown.append(text.getvalue())
        return usual(reply)

    before, out, err = set(files(Path())), io.StringIO(), io.StringIO()
    Reply.show = show  # type: ignore[method-assign]
    try:
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            code = main([*words, "--json"])
    finally:
        Reply.show = usual  # type: ignore[method-assign]
    try:
        data = json.loads(out.getvalue())
    except json.JSONDecodeError:
        data = out.getvalue().splitlines()
    written = sorted(set(files(Path())) - before)
    found = {
        "exit": code,
        "data": condensed(data),
        "errors": [line for line in err.getvalue().splitlines() if not _PROGRESS.search(line)],
        "written": written,
    }
    text = (
        json.dumps({**found, "text": shown})
        .replace(folder, "HERE")
        .replace(str(SOURCE), "SOURCE")
        .replace(str(Path.home()), "HOME")
    )
    plain: dict[str, Any] = json.loads(text)
    return plain


_PROGRESS = re.compile(r", \d+ s$")


def files(folder: Path) -> Iterator[str]:
    """Names of all files of a folder, without temporary ones."""
    for file in folder.rglob("*"):
        if file.is_file() and not any(part.startswith(".") for part in file.parts):
            yield file.as_posix()


def condensed(value: Any) -> Any:
    """The same data with long lists cut, and without what differs from run to run."""
    if isinstance(value, Mapping):
        return {key: condensed(item) for key, item in value.items() if key not in VARYING}
    if isinstance(value, list):
        if len(value) <= LONG:
            return [condensed(item) for item in value]
        if all(isinstance(item, int | float) for item in value):
            return {
                "count": len(value),
                "first": value[0],
                "last": value[-1],
                "sum": float(np.sum(value)),
            }
        return {"count": len(value), "first": condensed(value[0]), "last": condensed(value[-1])}
    return value


def options() -> dict[str, Any]:
    """Names, defaults and kinds of the options of every command."""
    found: dict[str, Any] = {}

    def visit(command: Any, words: tuple[str, ...]) -> None:
        for name, inner in getattr(command, "commands", {}).items():
            visit(inner, (*words, name))
        found[" ".join(words)] = {
            " ".join(one.opts): [
                one.required,
                one.multiple if hasattr(one, "multiple") else one.nargs,
                str(one.default),
            ]
            for one in command.params
        }

    visit(_command(), ())
    return found


def differences(old: Any, new: Any, place: str = "") -> Iterator[str]:
    """Name the places at which two answers differ."""
    if isinstance(old, Mapping) and isinstance(new, Mapping):
        for key in [*old, *(key for key in new if key not in old)]:
            if key in ("code", "numbers", "german") and key not in old:
                continue  # findings and reasons have them since the record was made
            if key not in old or key not in new:
                yield f"{place}.{key}: {'added' if key in new else 'lost'}"
            else:
                yield from differences(old[key], new[key], f"{place}.{key}")
    elif isinstance(old, list) and isinstance(new, list) and len(old) == len(new):
        for index, (before, after) in enumerate(zip(old, new, strict=True)):
            yield from differences(before, after, f"{place}[{index}]")
    elif (
        isinstance(old, float | int) and isinstance(new, float | int) and not isinstance(old, bool)
    ):
        if abs(old - new) > TOLERANCE * max(abs(old), abs(new)) + 1e-9:
            yield f"{place}: {old!r} -> {new!r}"
    elif isinstance(old, str) and isinstance(new, str):
        if _NUMBER.sub(_rounded, old) != _NUMBER.sub(_rounded, new):
            yield f"{place}: {old!r} -> {new!r}"
    elif old != new:
        yield f"{place}: {old!r} -> {new!r}"


_NUMBER = re.compile(r"-?\d+\.\d+(?:e-?\d+)?|[0-9a-f]{12,64}|\d{4}-\d\d-\d\dT[\d:.+Z]+")


def _rounded(match: re.Match[str]) -> str:
    try:
        return f"{float(match[0]):.3g}"
    except ValueError:
        return "…"


def compare(old: Mapping[str, Any], new: Mapping[str, Any]) -> int:
    """Print what differs; 1 where it is more than texts of tables."""
    data, texts = [], []
    for line in dict.fromkeys((*old["answers"], *new["answers"])):
        if line not in old["answers"] or line not in new["answers"]:
            data.append(f"{line}: {'not recorded before' if line in new['answers'] else 'not run'}")
            continue
        for difference in differences(old["answers"][line], new["answers"][line]):
            (texts if difference.startswith(".text") else data).append(f"{line}\n    {difference}")
    data += [f"options: {difference}" for difference in differences(old["options"], new["options"])]
    lines = [*texts, f"{len(texts)} texts differ", "", *data, f"{len(data)} data differ"]
    sys.stdout.write("\n".join([*lines, ""]))
    return int(bool(data))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("file", type=Path, help="the record")
    parser.add_argument(
        "--compare", action="store_true", help="compare with the record instead of writing it"
    )
    parser.add_argument(
        "--only", default="", metavar="WORDS", help="compare only commands that begin so"
    )
    asked = parser.parse_args()
    os.environ.pop("COLUMNS", None)
    started, found = time.process_time(), {}
    for line_, answer_ in answers(asked.only):
        found[line_] = answer_
        sys.stderr.write(f"{time.process_time() - started:7.1f} s  {answer_['exit']}  {line_}\n")
    record = {"options": options(), "answers": found}
    if asked.compare:
        old = json.loads(asked.file.read_text(encoding="utf-8"))
        old["answers"] = {
            line: row for line, row in old["answers"].items() if line.startswith(asked.only)
        }
        sys.exit(compare(old, record))
    rows = [
        f" {json.dumps(line)}: {json.dumps(row, ensure_ascii=False)}" for line, row in found.items()
    ]
    text = (
        '{"options": '
        + json.dumps(record["options"])
        + ',\n"answers": {\n'
        + ",\n".join(rows)
        + "}}\n"
    )
    asked.file.write_text(text, encoding="utf-8")
