"""The command ``jounce`` as a process of its own, also ``python -m jounce``."""

from __future__ import annotations

import gc
import sys


def run() -> int:
    """Run the command line of this process; give its exit code.

    What a command loads are hundreds of thousands of small objects, and hardly one of them is garbage: Python looks for
    it seldom, and not at all when the process ends.
    """
    if getattr(sys, "frozen", False):  # workers are this application, started again
        import multiprocessing

        multiprocessing.freeze_support()
    gc.set_threshold(50_000)
    if not any(word.startswith("--cluster") for word in sys.argv):
        sys.modules.setdefault("dask", None)  # type: ignore[arg-type]  # xarray loads it wherever it is installed: 0.3 s
    try:
        from jounce.cli import main

        code = main()
    except KeyboardInterrupt:  # while the commands are loaded
        sys.stderr.write("jounce: interrupted; no file is left half-written.\n")
        code = 130
    gc.freeze()
    return code


if __name__ == "__main__":
    raise SystemExit(run())
