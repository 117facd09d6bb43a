"""Errors go to other processes and are copied whole, whatever their constructors take."""

from __future__ import annotations

import copy
import importlib
import inspect
import multiprocessing
import pickle
import pkgutil
import threading
from typing import Any

import pytest

import jounce
from jounce.core.errors import JounceError
from jounce.core.findings import DrawingError, Finding
from jounce.web.jobs import Refused

MADE: dict[type[Exception], Exception] = {
    DrawingError: DrawingError(
        [Finding("a.svg", "problem", "not drawn."), Finding("b.svg", "problem", "neither")]
    ),
    Refused: Refused({"text": "a.toml: no such file.", "what": "no such file", "where": "a.toml"}),
}


def kinds() -> list[type[Exception]]:
    """Every error class of jounce."""
    found = set()
    for module in pkgutil.walk_packages(jounce.__path__, "jounce."):
        if not module.name.endswith("__main__"):
            for value in vars(importlib.import_module(module.name)).values():
                if (
                    inspect.isclass(value)
                    and issubclass(value, Exception)
                    and value.__module__.startswith("jounce.")
                ):
                    found.add(value)
    return sorted(found, key=lambda kind: kind.__qualname__)


def made(kind: type[Exception]) -> Exception:
    if issubclass(kind, JounceError) and kind not in MADE:
        return kind(
            "too heavy",
            where="sprung.mass",
            found=threading.Lock(),
            allowed="0 to 9 kg",
            hint="Measure it.",
        )
    return MADE.get(kind) or kind("some text")


def facts(error: Exception) -> dict[str, Any]:
    return {name: value for name, value in vars(error).items() if name != "found"}


@pytest.mark.parametrize("kind", kinds(), ids=lambda kind: kind.__qualname__)
def test_an_error_is_the_same_after_pickle_and_copy(kind: type[Exception]) -> None:
    error = made(kind)
    for again in [
        copy.copy(error),
        copy.deepcopy(error),
        *(pickle.loads(pickle.dumps(error, p)) for p in range(6)),
    ]:
        assert (type(again), str(again), again.args, facts(again)) == (
            kind,
            str(error),
            error.args,
            facts(error),
        )


def fail(number: int) -> None:
    raise MADE[DrawingError]


def test_a_pool_of_processes_gives_the_error_of_its_worker() -> None:
    with (
        multiprocessing.get_context("spawn").Pool(1) as pool,
        pytest.raises(DrawingError, match=r"a.svg: not drawn; "),
    ):
        pool.map_async(fail, [1]).get(timeout=240.0)
