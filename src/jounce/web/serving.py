"""A server for one folder, on this machine only."""

from __future__ import annotations

import asyncio
import contextlib
import gc
import importlib
import logging
import os
import secrets
import socket
import sys
import threading
import time
from collections.abc import Callable, Iterator
from hashlib import sha256
from pathlib import Path

from jounce.core.errors import DescriptionError, OutputError
from jounce.core.optional import hide_from_others, require
from jounce.core.remembered import Recent
from jounce.web.memory import give_memory_back


def serve(
    folder: Path | str, *, port: int = 0, ready: Callable[[str, str], None] | None = None
) -> None:
    """Serve the workbench of a folder until the process is stopped (Ctrl-C, SIGTERM).

    Parameters
    ----------
    folder : path
        Project folder; the page cannot read or write anything outside it.
    port : int
        Port on 127.0.0.1. 0 selects the folder's fixed port, so that the browser's stored settings apply, or a free
        one.
    ready : callable
        Called once the server is ready, with the address to open (including its token) and the token for scripts.

    Raises
    ------
    DescriptionError
        If the path is not a folder.
    OutputError
        If the port is in use.
    MissingPackageError
        Without FastAPI and uvicorn (extra ``web``).

    Examples
    --------
    >>> serve("my-car", port=8123)  # doctest: +SKIP
    """
    if not Path(folder).is_dir():
        raise DescriptionError(
            "not a folder",
            where=str(folder),
            hint="Create the folder, or name the folder that contains your files.",
        )
    hide_from_others(*_UNUSED)
    uvicorn = require("uvicorn", "web")
    from jounce.kernel.apart import compiling_apart
    from jounce.web.app import create_app

    trim = give_memory_back()
    listening = _listening(port) if port else _usual(folder)
    number = listening.getsockname()[1]
    token = secrets.token_urlsafe(32)
    address = f"http://127.0.0.1:{number}/?token={token}"
    app = create_app(
        folder, token=token, port=number, ready=lambda: ready(address, token) if ready else None
    )
    require("websockets", "web")
    config = uvicorn.Config(app, log_level="warning", access_log=False, server_header=False, ws="websockets-sansio",
                            timeout_graceful_shutdown=1)  # fmt: skip
    logging.getLogger("uvicorn.error").addFilter(_is_trouble)
    try:
        with compiling_apart(), _within_bounds(trim):
            uvicorn.Server(config).run(sockets=[listening])
    except KeyboardInterrupt:
        pass  # normal termination
    finally:
        listening.close()


def _is_trouble(record: logging.LogRecord) -> bool:
    """Whether a line of the server's log is relevant: requests aborted by shutdown are not."""
    is_cut_off = record.exc_info is not None and isinstance(
        record.exc_info[1], asyncio.CancelledError
    )
    return not (is_cut_off or "timeout graceful shutdown exceeded" in str(record.msg))


_MOST_MODELS = 8  # of each kind; a model takes up to 2 MB, and 10 ms to reload
_PAUSE = 2.0  # s
_LONGEST_IMPORT = 10.0  # s
_IDLE = 0.05  # s of processor time: maximum in a pause
_USED, _BUSY = (
    0.2,
    1.0,
)  # minimum since memory was given back, and since the last garbage collection
_UNUSED = ("bottleneck", "dask", "numexpr", "pyarrow")
"""Packages that pandas and xarray import if they are installed: 60 MB, of which no answer of the server needs any."""
_LATER = ("xarray", "h5netcdf", "jounce.operations.checks", "jounce.variants.study")


@contextlib.contextmanager
def _within_bounds(trim: Callable[[], object]) -> Iterator[None]:
    """Limit the number of cached models, and import modules, collect garbage and return memory while idle.

    By default Python collects garbage whenever the number of objects grows by a quarter, which delays a response.
    """
    before, Recent.most = Recent.most, _MOST_MODELS
    ended = threading.Event()
    tidying = threading.Thread(
        target=_tidy_in_pauses, args=(ended, trim), name="pauses", daemon=True
    )
    tidying.start()
    try:
        yield
    finally:
        ended.set()
        tidying.join(
            _LONGEST_IMPORT
        )  # an import interrupted by the end of the process prints a traceback
        Recent.most = before


def _tidy_in_pauses(ended: threading.Event, trim: Callable[[], object]) -> None:
    """Import modules that the first run, recording, saved file and study need; collect garbage, return memory."""
    later = iter(_LATER)
    before = given = collected = time.process_time()
    while not ended.wait(_PAUSE):
        if time.process_time() - before < _IDLE:
            if name := next(later, None):
                importlib.import_module(name)
            if time.process_time() - collected > _BUSY:
                gc.collect()
                collected = time.process_time()
            if time.process_time() - given > _USED:
                trim()
                given = time.process_time()
        before = time.process_time()


def usual_port(folder: Path | str) -> int:
    """Return the default port of a folder, which is the same every time."""
    place = os.path.normcase(Path(folder).resolve())
    return (
        20_000 + int.from_bytes(sha256(place.encode()).digest()[:4]) % 10_000
    )  # below the ephemeral ports


def _usual(folder: Path | str) -> socket.socket:
    try:
        return _listening(usual_port(folder))
    except OutputError:  # in use by another process
        return _listening(0)


def _listening(port: int) -> socket.socket:
    # With TCP given explicitly, data are sent at once; otherwise a kept connection waits 40 ms for each response.
    listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM, socket.IPPROTO_TCP)
    if (
        sys.platform != "win32"
    ):  # a server that stopped a moment ago leaves connections in TIME_WAIT on its port
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listener.bind(("127.0.0.1", port))
    except (OSError, OverflowError) as error:
        listener.close()
        what = "no such port" if isinstance(error, OverflowError) else "the port is not available"
        hint = "Choose another port, or omit it to use a free one."
        raise OutputError(
            what, where="--port", found=port, allowed="0 to 65535", hint=hint
        ) from None
    listener.listen(64)
    return listener
