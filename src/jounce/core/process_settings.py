"""Settings of the whole process that are changed for a moment: by one thread at a time.

Two threads that save and restore such a setting in turns would leave it changed for ever.
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from threading import RLock
from typing import Any

PROCESS_SETTINGS: Any = RLock()
"""Held while filters of warnings, levels of logging, or matplotlib's style are other ones."""

if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=PROCESS_SETTINGS._at_fork_reinit)  # its thread stayed behind


@contextmanager
def collect_warnings() -> Iterator[list[warnings.WarningMessage]]:
    """Collect the warnings of a block instead of showing them."""
    with PROCESS_SETTINGS, warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        yield caught
