"""What all tests share: reproducible random examples and a cache of compiled models that is thrown away."""

from __future__ import annotations

import os
import shutil
import tempfile

import hypothesis
import pytest

hypothesis.settings.register_profile("jounce", derandomize=True, deadline=None, max_examples=60)
hypothesis.settings.load_profile("jounce")

_CACHE = pytest.StashKey[str]()


def pytest_configure(config: pytest.Config) -> None:
    folder = tempfile.mkdtemp(prefix="jounce-tests-")
    config.stash[_CACHE] = folder
    os.environ["JOUNCE_CACHE_DIR"] = folder  # also for the processes that tests start


def pytest_unconfigure(config: pytest.Config) -> None:
    shutil.rmtree(config.stash[_CACHE], ignore_errors=True)
