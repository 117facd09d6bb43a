"""All examples of public docstrings, run by several threads of one process at once: a program for test_threads.py.

Usage: python threads_run.py SEED THREADS [KEEP] [NAME ...]

Every thread runs all examples in an order of its own, each in a namespace of its own, and holds what each line gives
against what the docstring says, which is what a single thread gives. KEEP bounds the stores of models (0: all kept).
"""

from __future__ import annotations

import ast
import contextlib
import doctest
import faulthandler
import io
import json
import random
import sys
import threading
import traceback
from typing import Any

import jounce as jn
from jounce.core.remembered import Recent

FLAGS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
PROCESS_WIDE = {"use_units"}
"""What sets something for the whole process, which no other thread can do without."""


def examples() -> dict[str, doctest.DocTest]:
    """Examples of all public functions and classes, by name."""
    found: dict[str, doctest.DocTest] = {}
    finder = doctest.DocTestFinder(recurse=True)
    for name in jn.__all__:
        thing = getattr(jn, name)
        if name in PROCESS_WIDE or not getattr(thing, "__module__", "").startswith("jounce"):
            continue
        for test in finder.find(
            thing, name, module=False, globs=vars(sys.modules[thing.__module__])
        ):
            if test.examples:
                found[test.name] = test
    return found


def run(test: doctest.DocTest) -> str:
    """Run an example; give what differs from the docstring, or nothing.

    ``doctest`` itself puts its own stream in the place of the process's; here `print` writes to one of this call.
    """
    shown = io.StringIO()

    def write(*words: Any, sep: str = " ", end: str = "\n") -> None:
        shown.write(sep.join(map(str, words)) + end)

    space: dict[str, Any] = {**test.globs, "print": write, "__name__": "__main__"}
    for line in test.examples:
        shown.seek(0)
        shown.truncate()
        try:
            *statements, last = ast.parse(line.source).body
            if not isinstance(last, ast.Expr):
                statements, last = [*statements, last], None
            exec(compile(ast.Module(statements, []), "<example>", "exec"), space)  # noqa: S102
            if last is not None:
                value = eval(compile(ast.Expression(last.value), "<example>", "eval"), space)  # noqa: S307
                if value is not None:
                    write(repr(value))
        except Exception as error:  # noqa: BLE001
            if line.exc_msg is None or not doctest.OutputChecker().check_output(
                line.exc_msg,
                "".join(traceback.format_exception_only(error)),
                FLAGS | doctest.IGNORE_EXCEPTION_DETAIL,
            ):
                return f"{line.source.strip()}: {type(error).__name__}: {error}"
            continue
        if not doctest.OutputChecker().check_output(line.want, shown.getvalue(), FLAGS):
            return f"{line.source.strip()}: {shown.getvalue().strip()} for {line.want.strip()}"
    return ""


def main(seed: int, threads: int, keep: int, names: list[str]) -> dict[str, Any]:
    known = examples()
    wanted = names or list(known)
    if unknown := set(wanted) - known.keys():
        sys.exit(f"no examples: {sorted(unknown)}")
    if keep:
        Recent.most = keep
    wrong: dict[str, str] = {}
    begin = threading.Barrier(threads)

    def work(number: int) -> None:
        order = list(wanted)
        random.Random(f"{seed} {number}").shuffle(order)
        begin.wait()
        for name in order:
            if result := run(known[name]):
                wrong[name] = result

    workers = [threading.Thread(target=work, args=(number,)) for number in range(threads)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    return {"examples": len(wanted), "wrong": wrong}


if __name__ == "__main__":
    faulthandler.enable()
    seed, threads, keep, *names = sys.argv[1:]
    with contextlib.suppress(BrokenPipeError):
        json.dump(main(int(seed), int(threads), int(keep), names), sys.stdout)
