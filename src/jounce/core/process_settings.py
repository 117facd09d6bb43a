"""Temporary changes of process-wide settings, by one thread at a time.

If two threads saved and restored such a setting in an interleaved order, it would stay changed.
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from threading import RLock
from typing import Any

PROCESS_SETTINGS: Any = RLock()
"""Lock held while warning filters, logging levels or matplotlib's style are changed."""

if hasattr(os, "register_at_fork"):
    os.register_at_fork(
        after_in_child=PROCESS_SETTINGS._at_fork_reinit
    )  # the thread that held it is not in the child


@contextmanager
def collect_warnings() -> Iterator[list[warnings.WarningMessage]]:
    """Collect the warnings of a block instead of showing them."""
    with PROCESS_SETTINGS, warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        yield caught
