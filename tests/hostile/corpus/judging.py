"""What became of a bad input, and the child process with limits that finds out."""

from __future__ import annotations

import json
import os
import select
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

MEMORY, CPU, CLOCK = 2_000_000_000, 10, 300.0
"""Bytes, seconds of processor time, and seconds by the clock that a case may take."""
LONGEST = 4500  # characters of a message
GOOD = ("refused", "flagged", "right", "accepted")
BAD = ("crashed", "hung", "unclear", "silently wrong")
VERDICTS = (*GOOD, "undetectable", *BAD)


def judge(
    module: str, names: Sequence[Any], *, clock: float = CLOCK
) -> Iterator[tuple[Any, str, str]]:
    """Run cases by the function ``verdict`` of a module in children; give each name, its verdict and what was said.

    A child runs one case after the other. Where it ends or stands still, that is the verdict of the case that it was
    on, and another child goes on behind it.
    """
    left = list(names)
    while left:
        with tempfile.TemporaryDirectory(prefix="jounce-corpus-") as folder:
            asked = [sys.executable, "-c", _CHILD, module, str(MEMORY), str(CPU)]
            environment = {
                **os.environ,
                "PYTHONPATH": os.pathsep.join(path for path in sys.path if path),
            }
            with (
                Path(folder, "stderr").open("w+b") as said,
                subprocess.Popen(asked, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=said, cwd=folder,
                                 env=environment) as child,
            ):  # fmt: skip
                assert child.stdin is not None
                assert child.stdout is not None
                for index, name in enumerate(left):
                    try:
                        child.stdin.write(json.dumps(name).encode() + b"\n")
                        child.stdin.flush()
                        ready, _, _ = select.select([child.stdout], [], [], clock)
                        line = child.stdout.readline() if ready else b""
                    except BrokenPipeError:
                        ready, line = [child.stdout], b""
                    if line:
                        yield name, *json.loads(line)
                        continue
                    child.kill()
                    code = child.wait()
                    said.seek(0)
                    told = said.read().decode(errors="replace")[-300:]
                    hung = not ready or code == -24  # SIGXCPU
                    yield name, "hung" if hung else "crashed", f"exit code {code} {told}"
                    left = left[index + 1 :]
                    break
                else:
                    left = []
                    child.stdin.close()
                    child.wait()


_CHILD = """
import importlib, json, os, resource, sys
answers = os.fdopen(os.dup(1), "w")
os.dup2(2, 1)
cases = importlib.import_module(sys.argv[1])
def taken():  # bytes that are reserved already, 0 where the system does not tell
    try:
        with open("/proc/self/statm") as told:
            return int(told.read().split()[5]) * resource.getpagesize()
    except OSError:
        return 0
resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
for line in sys.stdin:
    resource.setrlimit(resource.RLIMIT_DATA, (taken() + int(sys.argv[2]), resource.RLIM_INFINITY))
    used = resource.getrusage(resource.RUSAGE_SELF)
    soft = int(used.ru_utime + used.ru_stime) + 1 + int(sys.argv[3])
    resource.setrlimit(resource.RLIMIT_CPU, (soft, resource.RLIM_INFINITY))
    print(json.dumps(cases.verdict(json.loads(line))), file=answers, flush=True)
"""


def is_clear(message: str, *places: str) -> bool:
    """Whether a refusal says where it is about, in a length that can be read, and was foreseen."""
    return (
        len(message) <= LONGEST
        and any(place in message for place in places)
        and not any(
            text in message for text in ("internal error", "an unexpected reason", "Traceback")
        )
    )


def counted(found: Sequence[tuple[str, str]]) -> dict[str, Counter[str]]:
    """Verdicts by group."""
    counts: dict[str, Counter[str]] = {}
    for group, verdict in found:
        counts.setdefault(group, Counter())[verdict] += 1
    return counts


def table(counts: dict[str, Counter[str]], title: str) -> str:
    """The counts as a table of Markdown, with their sum."""
    shown = [
        verdict
        for verdict in VERDICTS
        if verdict in BAD or any(count[verdict] for count in counts.values())
    ]
    rows = {**counts, "**all**": sum(counts.values(), Counter())}
    lines = [f"| {title} | tried | {' | '.join(shown)} |", f"|---|{'---:|' * (len(shown) + 1)}"]
    for name, count in rows.items():
        lines.append(
            f"| {name} | {count.total()} | {' | '.join(str(count[verdict]) for verdict in shown)} |"
        )
    return "\n".join(lines)


def timed(run: Callable[[], Any]) -> tuple[Any, float]:
    """What a call gives, and the seconds that it took."""
    start = time.monotonic()
    return run(), time.monotonic() - start
