"""Settings of the process are as they were, however many threads change them for a moment."""

from __future__ import annotations

import logging
import threading
import warnings
from concurrent.futures import ThreadPoolExecutor

from jounce.core.process_settings import collect_warnings
from jounce.plots.figures import library, style
from jounce.recordings.readers import _quiet


def in_turns(context):
    """Two threads in one context: without a lock the second enters before the first leaves, and leaves after it."""
    first_inside, second_done = threading.Event(), threading.Event()

    def first():
        with context():
            first_inside.set()
            second_done.wait(0.2)

    def second():
        first_inside.wait(5.0)
        with context():
            second_done.set()
            first_left.wait(0.2)

    first_left = threading.Event()
    with ThreadPoolExecutor(2) as threads:
        one, other = threads.submit(lambda: (first(), first_left.set())), threads.submit(second)
        one.result(), other.result()


def test_filters_of_warnings():
    before = list(warnings.filters)
    in_turns(collect_warnings)
    assert warnings.filters == before


def test_levels_of_logging():
    before = logging.root.manager.disable
    in_turns(_quiet)
    assert logging.root.manager.disable == before


def test_style_of_figures():
    settings = library().rcParams
    before = settings["lines.linewidth"]
    settings["lines.linewidth"] = 7.5
    try:
        in_turns(style)
        assert settings["lines.linewidth"] == 7.5
    finally:
        settings["lines.linewidth"] = before
