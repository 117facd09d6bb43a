"""Whether this process may start others that import its main script, as workers do on every system."""

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
    """Reason why workers cannot be started here; None if they can.

    A worker imports the script that asked for it. Where that comes to the same call again, no worker ever begins.
    """
    if multiprocessing.current_process().daemon:
        return JounceError(
            "a worker of a pool cannot start workers of its own",
            where="workers",
            allowed="1 inside of it",
            hint="The pool around it shares the work already.",
        )
    line = _unguarded_line()
    if not line:
        return None
    return JounceError(
        "the script has no main guard: each worker would import it, and come to this call again",
        where=f"workers: {line}",
        allowed='the call inside `if __name__ == "__main__":`, or workers=1',
    )


def check_workers() -> None:
    """Refuse to start workers where they cannot be started."""
    error = refusal()
    if error is not None:
        raise error


class NoWorkersError(JounceError):
    """Processes that the system does not start."""


@contextmanager
def starting_workers() -> Iterator[None]:
    """Start worker processes in a block; if the system refuses, the error says what is missing.

    The workers never hear Ctrl-C or a closed terminal, not even while they load: the first process tells them when to
    stop. Nor does the process in which Python counts semaphores, whose successor would print a traceback.

    This process is interrupted when the block ends: another thread may receive the signal that this one blocks, and a
    worker whose parent stops before it has sent the first message would print a traceback.
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
                hint="One process needs none.",
            ) from error
        finally:
            if block:
                block(signal.SIG_SETMASK, before)


def _lacking(error: Exception) -> str:
    """Where the system keeps what workers need and was refused: their semaphores lie in shared memory."""
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
    """File and line of the main script that is running now, if workers would run it, too; otherwise nothing."""
    main = sys.modules.get("__main__")
    name = getattr(getattr(main, "__spec__", None), "name", "")
    if (
        main is None or name.rpartition(".")[2] == "__main__"
    ):  # workers do not import `python -m package`
        return ""
    if getattr(
        sys, "frozen", False
    ):  # the application itself is started again, and its script has no source there
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
