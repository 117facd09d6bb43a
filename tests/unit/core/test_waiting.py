"""Who waits is told for what and how long; what is ready at once is told nobody."""

from __future__ import annotations

import logging
import time
from types import SimpleNamespace

import pytest

from jounce.core import waiting
from jounce.core.waiting import heard_by, report_work


@pytest.fixture(autouse=True)
def impatient(monkeypatch):
    monkeypatch.setattr(waiting, "LOGGED_EVERY", 0.02)
    monkeypatch.setattr(waiting, "SHOWN_EVERY", 0.01)


def wait_for(ready, seconds=10.0):
    end = time.monotonic() + seconds
    while not ready() and time.monotonic() < end:
        time.sleep(0.005)
    assert ready()


def test_a_long_wait_is_logged_again_and_again_with_its_time(caplog):
    with caplog.at_level(logging.WARNING, "jounce"), report_work("compiling the model"):
        wait_for(lambda: len(caplog.messages) >= 3)
    assert set(caplog.messages) <= {f"compiling the model, {i} s" for i in range(11)}
    count = len(caplog.messages)
    time.sleep(0.05)
    assert len(caplog.messages) == count  # it has ended


def test_how_far_it_has_come_is_asked_each_time(caplog):
    done = iter(range(10_000))
    with (
        caplog.at_level(logging.WARNING, "jounce"),
        report_work(lambda: f"design {next(done)} of many"),
    ):
        wait_for(lambda: len(caplog.messages) >= 2)
    assert caplog.messages[0].startswith("design 0 of many, ")
    assert caplog.messages[1].startswith("design 1 of many, ")


def test_the_longer_it_lasts_the_fewer_lines_say_so(caplog, monkeypatch):
    """Each comes when twice the time of the last one has passed, but not later than half a minute after it."""
    passed = [0.0]

    def sleep(seconds):  # a minute and more is over at once, and time stands still then
        passed[0] += seconds if passed[0] < 100.0 else 0.0
        time.sleep(0.0 if passed[0] < 100.0 else 0.005)

    monkeypatch.setattr(waiting, "LOGGED_EVERY", 2.0)
    monkeypatch.setattr(waiting, "SHOWN_EVERY", 0.5)
    monkeypatch.setattr(waiting, "time", SimpleNamespace(sleep=sleep, monotonic=lambda: passed[0]))
    with caplog.at_level(logging.WARNING, "jounce"), report_work("compiling the model"):
        wait_for(lambda: passed[0] >= 100.0)
    assert caplog.messages == [f"compiling the model, {i} s" for i in (2, 4, 8, 16, 32, 62, 92)]


def test_a_short_one_is_not(caplog, monkeypatch):
    monkeypatch.setattr(waiting, "LOGGED_EVERY", 60.0)
    with report_work("compiling the model"):
        pass
    assert not caplog.messages


def test_whoever_listens_is_told_instead_and_when_it_is_done(caplog):
    heard = []
    with heard_by(heard.append), report_work("compiling"):
        wait_for(lambda: heard)
    assert heard[-1] is None
    assert set(heard[:-1]) <= {f"compiling, {i} s" for i in range(11)}
    assert not caplog.messages
    with report_work("compiling"):
        pass
    assert heard[-1] is None


def test_a_part_of_a_wait_is_not_told_again():
    heard = []
    with heard_by(heard.append), report_work("whole"), report_work("part"):
        wait_for(lambda: heard)
    assert not [text for text in heard if text and "part" in text]


def test_an_error_ends_it():
    heard = []

    def fail():
        with report_work("compiling"):
            wait_for(lambda: heard)
            raise ValueError("no code")

    with heard_by(heard.append), pytest.raises(ValueError, match="no code"):
        fail()
    assert heard[-1] is None
    with heard_by(heard.append), report_work("again"):
        wait_for(lambda: any(text and text.startswith("again") for text in heard))


def test_compiling_a_model_is_told(monkeypatch, tmp_path):
    from jounce.kernel import native
    from jounce.models import build
    from jounce.parts import load
    from jounce.simulation.programs import plain_program

    monkeypatch.setenv("JOUNCE_CACHE_DIR", str(tmp_path))
    heard, program = [], plain_program(build(load("kart-quarter-car")))
    real = native._emit
    monkeypatch.setattr(native, "_emit", lambda *given: wait_for(lambda: heard) or real(*given))
    with heard_by(heard.append):
        native.compile_functions(program.functions, program.step)
    assert heard[0] == "compiling the model (once on this machine), 0 s"
