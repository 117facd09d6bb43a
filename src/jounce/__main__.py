"""The command ``jounce`` as a process of its own, also ``python -m jounce``."""

from __future__ import annotations

import gc
import sys


def run() -> int:
    """Run the command line of this process; give its exit code.

    A command loads hundreds of thousands of small objects, hardly any of which are garbage. The garbage collector
    therefore runs rarely, and not at all when the process ends.
    """
    if getattr(sys, "frozen", False):  # workers are this application, started again
        import multiprocessing

        multiprocessing.freeze_support()
    try:
        return _run()
    except KeyboardInterrupt as error:  # before it is handled, or while another one is answered
        from jounce.core.interrupts import leave, signal_of

        leave(signal_of(error), None)


def _run() -> int:
    from jounce.core.interrupts import handle_interrupts, interrupt, leave

    handle_interrupts(leave)
    gc.set_threshold(50_000)
    if not any(word.startswith("--cluster") for word in sys.argv):
        sys.modules.setdefault("dask", None)  # type: ignore[arg-type]  # xarray loads it wherever it is installed: 0.3 s
    from jounce.cli import main
    from jounce.web import command  # noqa: F401 - it adds the command that opens the workbench

    handle_interrupts(interrupt)
    code = main()
    handle_interrupts(leave)
    gc.freeze()
    return code


if __name__ == "__main__":
    raise SystemExit(run())
