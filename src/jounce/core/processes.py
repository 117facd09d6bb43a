"""Check whether this process can start workers, which import its main script on every system."""

from __future__ import annotations

import ast
import errno
import linecache
import multiprocessing
import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

from jounce.core.errors import NO_THREAD, JounceError
from jounce.core.interrupts import interrupt_after


def refusal() -> JounceError | None:
    """Return the reason why workers cannot be started here; None if they can.

    A worker imports the script that started it. If the import reaches the same call again, no worker ever begins.
    """
    if multiprocessing.current_process().daemon:
        return JounceError(
            "a worker of a pool cannot start workers of its own",
            where="workers",
            allowed="1 within a worker process",
            hint="The surrounding pool already distributes the work.",
        )
    line = _unguarded_line()
    if not line:
        return None
    return JounceError(
        "the script has no main guard: each worker would import it and reach this call again",
        where=f"workers: {line}",
        allowed='the call inside `if __name__ == "__main__":`, or workers=1',
    )


def check_workers() -> None:
    """Raise an error if workers cannot be started here."""
    error = refusal()
    if error is not None:
        raise error


class NoWorkersError(JounceError):
    """The system refused to start processes."""


@contextmanager
def starting_workers() -> Iterator[None]:
    """Start worker processes in a block; if the system refuses, the error names the missing resource.

    The workers ignore Ctrl-C and a closed terminal, even while they load: the main process stops them. So does Python's
    resource tracker, whose replacement would otherwise print a traceback.

    Interrupts of this process are delayed until the block ends: a different thread may receive the signal that this one
    blocks, and a worker whose parent stops before its first message would print a traceback.
    """
    with interrupt_after():
        block = getattr(signal, "pthread_sigmask", None)
        before = block(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGHUP}) if block else None
        try:
            yield
        except (OSError, RuntimeError) as error:
            if isinstance(error, RuntimeError) and str(error) != NO_THREAD:
                raise
            refused = getattr(error, "strerror", None) or str(error)
            raise NoWorkersError(
                "no worker processes can be started",
                where=_lacking(error),
                found=refused,
                hint="A single process needs no workers.",
            ) from error
        finally:
            if block:
                block(signal.SIG_SETMASK, before)


def _lacking(error: Exception) -> str:
    """Return the resource that workers lack: their semaphores are in shared memory."""
    number = getattr(error, "errno", None)
    if sys.platform == "linux" and number in (
        errno.EROFS,
        errno.ENOSPC,
        errno.EACCES,
        errno.ENOENT,
    ):
        return "/dev/shm"
    return (
        "the limit of open files (ulimit -n)"
        if number == errno.EMFILE
        else "the limit of processes (ulimit -u)"
    )


def _unguarded_line() -> str:
    """File and line of the main script, if workers would run this line as well; otherwise an empty text."""
    main = sys.modules.get("__main__")
    name = getattr(getattr(main, "__spec__", None), "name", "")
    if (
        main is None or name.rpartition(".")[2] == "__main__"
    ):  # workers do not import `python -m package`
        return ""
    if getattr(
        sys, "frozen", False
    ):  # a frozen application starts itself again, and its script has no source file
        return ""
    frame: FrameType | None = sys._getframe()
    while frame is not None and not (
        frame.f_globals is vars(main) and frame.f_code.co_name == "<module>"
    ):
        frame = frame.f_back
    if frame is None or not hasattr(main, "__file__"):
        return ""
    file, line = frame.f_code.co_filename, frame.f_lineno
    try:
        tree = ast.parse("".join(linecache.getlines(file)))
    except SyntaxError:
        return ""
    guards = [
        node
        for node in ast.walk(tree)
        if isinstance(node, ast.If) and "__name__" in ast.unparse(node.test)
    ]
    is_guarded = any(node.lineno <= line <= (node.end_lineno or node.lineno) for node in guards)
    return "" if is_guarded else f"{file}, line {line}"
