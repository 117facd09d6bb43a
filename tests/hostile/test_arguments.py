"""Every public function with every argument replaced by others of another kind: a right result or one clear message.

The good arguments are those of the docstring's example. What a call with one wrong argument may end in: a result, an
error of jounce, or, with arguments that fit their annotations, an error of what the user gave (a function of theirs).
"""

from __future__ import annotations

import doctest
import inspect
import signal
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import FrameType
from typing import Any

import numpy as np
import pandas as pd
import pytest

import jounce as jn

FUNCTIONS = [name for name in jn.__all__ if inspect.isfunction(getattr(jn, name))]
LONG = {
    *(
        "adjust_report",
        "animate",
        "bands",
        "campaign_next_trials",
        "campaign_posterior",
        "clearances",
        "compliance",
    ),
    *(
        "compare_rides",
        "compare_tests",
        "design_kinematics",
        "kinematic_spread",
        "load_case_table",
        "next_trials",
    ),
    *("run_audi_a6", "run_campaign", "virtual_bench"),
}
"""Whose examples take more than a second."""
ENOUGH = 0.1  # s: what still runs then was not refused

RIG = jn.load("kart-quarter-car")
TRIAL = jn.Trial(road=jn.Step(height="10 mm"), speed="3 m/s", duration="0.2 s")
RUN = jn.simulate(RIG, TRIAL)
WRONG: list[Any] = [
    None, RUN, RUN["sprung.az"], pd.DataFrame({"a": [1.0, 2.0]}), pd.Series([1.0, 2.0]), RIG, TRIAL, TRIAL.road,
    jn.load("audi-a6-half-car"), jn.Finding("a", "note", "b"), "", "typo", "3 kg", "a\0b", Path("nowhere.toml"), Path(),
    [], [1.0, 2.0], ["a", "b"], [[[1]]], {}, {"a": 1}, {"sprung.mass": None}, {1, 2}, range(3), 0, -1, 1.5, True,
    float("nan"), float("inf"), 10**400, 1 + 2j, b"x", object(), ..., np.ones((3, 2)), np.array(["a"]),
]  # fmt: skip


class Enough(BaseException):
    """The time is over."""


@contextmanager
def at_most(seconds: float) -> Iterator[None]:
    def end(_: int, frame: FrameType | None) -> None:
        raise Enough

    before = signal.signal(signal.SIGALRM, end)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)


def example_of(name: str, monkeypatch: pytest.MonkeyPatch) -> dict[str, Any]:
    """Arguments of the first call of a function in its own example."""
    function = getattr(jn, name)
    own, calls = inspect.unwrap(function), list[inspect.BoundArguments]()

    def spy(*arguments: Any, **options: Any) -> Any:
        calls.append(inspect.signature(own).bind(*arguments, **options))
        return function(*arguments, **options)

    with monkeypatch.context() as patch:
        patch.setattr(jn, name, spy)
        names = {**vars(sys.modules[own.__module__]), name: spy}
        for test in doctest.DocTestFinder(recurse=False).find(own, globs=names):
            doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(
                test, out=lambda _: None, clear_globs=False
            )
    found = dict(calls[0].arguments)
    return found | found.pop("changes", {}) if name == "controller" else found


def faults(name: str, good: dict[str, Any]) -> tuple[int, list[str]]:
    """How many calls were made, and those that ended in neither a result nor a clear message."""
    function, count, found = getattr(jn, name), 0, []
    parameters = inspect.signature(function).parameters
    overwrites = {"force": True} if "force" in parameters else {}
    for parameter in parameters.values():
        if parameter.kind is parameter.VAR_KEYWORD:
            continue
        for wrong in WRONG:
            count += 1
            try:
                with at_most(ENOUGH):
                    function(**{**good, **overwrites, parameter.name: wrong})
            except (jn.JounceError, Enough):
                pass
            except Exception as error:  # noqa: BLE001 - any of them is a fault
                if isinstance(error, SystemError) and isinstance(error.__cause__, Enough):
                    continue  # the end of the time inside of a library in C
                found.append(
                    f"{name}({parameter.name}={str(wrong)[:40]!r}): {type(error).__name__}: {error}"[
                        :200
                    ]
                )
    return count, found


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="ends calls by a signal of POSIX")
@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("name", [name for name in FUNCTIONS if name not in LONG])
def test_every_argument_of_another_kind_gives_a_result_or_a_clear_message(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    count, found = faults(name, example_of(name, monkeypatch))
    assert count >= len(WRONG)
    assert found == []


def test_a_bare_error_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(jn, "road_psd", lambda road: np.zeros(1)[road])
    assert any("IndexError" in text for text in faults("road_psd", {"road": 0})[1])


def test_the_list_of_long_ones_is_true() -> None:
    assert set(FUNCTIONS) >= LONG
    assert len(FUNCTIONS) - len(LONG) > 100
