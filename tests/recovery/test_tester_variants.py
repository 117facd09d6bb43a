"""Records of testers, spoilt in every way: what a record can tell is told, and sound ones get no warning."""

from __future__ import annotations

import foreign_testers
import make_records
import numpy as np
import pytest
from foreign_records import PLAIN, high_pass, low_pass, steps_of
from foreign_testers import EGEA, THETA, axle

from jounce.inspection import evaluate
from jounce.inspection.record import read_record
from jounce.parts.testers import load_tester

SOUND = {
    "lift_off",
    "phase_after_lift_off",
    "phase_below_zero",
    "phase_at_end",
    "lift_off_left_out",
    "channels_apart",  # much dry friction looks so on a sprung plate, and damping ratios are wrong by it
}
"""What is said of wheels that are odd, not of their records."""


@pytest.fixture(scope="module")
def codes_of(tmp_path_factory):
    """Codes of the warnings and problems of a record, by way of its file."""

    def read(one):
        file = tmp_path_factory.mktemp("lane") / "lane.csv"
        file.write_text(one.text(), encoding="utf-8")
        tester = load_tester(one.tester)
        run, notes = read_record(file, tester)
        found = evaluate(run, tester)
        said = [
            *notes,
            *found.findings,
            *(finding for wheel in found.wheels for finding in wheel.findings),
        ]
        return {finding.code for finding in said if finding.severity != "note"}

    return read


def _height(one, change):
    one.z = {side: change(values) for side, values in one.z.items()}


def _both(one, change):
    _height(one, change)
    one.f = {side: change(values) for side, values in one.f.items()}


def _cut(one, rows):
    kept = np.ones(one.time.size, bool)
    kept[4000 : 4000 + rows] = False
    _both(one, lambda values: values[kept])
    one.time = one.time[: np.count_nonzero(kept)]


def _low(one):
    _both(one, lambda values: low_pass(values, 1000.0, 40.0, 2))


def _coupled(one, corner, order):
    _height(one, lambda values: high_pass(values, 1000.0, corner, order))


def _held(one):
    _both(one, lambda values: values[np.arange(values.size) // 2 * 2])


def _exchanged(one):
    one.z, one.order = {"left": one.z["right"], "right": one.z["left"]}, '"together"'


def _turned(one):
    one.f = {side: -values for side, values in one.f.items()}


def _coarse(one):
    one.f = {side: steps_of(values, 400.0) for side, values in one.f.items()}


def _late(one):
    one.f = {side: low_pass(values, 1000.0, 40.0, 1) for side, values in one.f.items()}


def _slow(one):
    one.time = 0.95 * one.time


@pytest.mark.parametrize(
    ("tester", "car", "spoil", "code"),
    [
        (EGEA, "hatchback", _low, "stroke_falls"),
        (EGEA, "estate", lambda one: _coupled(one, 2.0, 2), "stroke_rises"),
        (EGEA, "estate", lambda one: _coupled(one, 5.0, 1), "stroke_rises"),
        (EGEA, "hatchback", lambda one: _cut(one, 20), "rows_missing"),
        (EGEA, "estate", lambda one: _cut(one, 1000), "rows_missing"),
        (EGEA, "van", _held, "recordings.held"),
        (EGEA, "van", _exchanged, "force_elsewhere"),
        (EGEA, "estate", _turned, "force_sign"),
        (EGEA, "hatchback", _coarse, "force_coarse"),
        (THETA, "hatchback", lambda one: _height(one, lambda v: 0.8 * v), "exciter_off"),
        (THETA, "estate", lambda one: _coupled(one, 0.5, 2), "exciter_off"),
        (THETA, "hatchback", _slow, "frequency_off"),
        (THETA, "estate", _late, "channels_apart"),
    ],
)  # fmt: skip
def test_a_cause_has_its_finding(codes_of, tester, car, spoil, code):
    one = axle(tester, car)
    spoil(one)
    assert code in codes_of(one.record("", ""))


def test_a_force_in_very_coarse_steps_ends_nothing(codes_of):
    one = axle(THETA, "hatchback")  # its exciter seems to turn where no sample is
    one.f = {side: steps_of(values, 1000.0) for side, values in one.f.items()}
    assert {"force_coarse", "load_contradicts"} & codes_of(one.record("", ""))


@pytest.mark.parametrize("tester", [EGEA, THETA])
def test_a_sound_record_has_no_finding(codes_of, tester):
    for car in foreign_testers.CARS:
        one = axle(tester, car, 0.01, 2).record(PLAIN, car)
        assert codes_of(one) == set(), car
        assert make_records.judged_test(one) == "right", car


def test_a_record_of_odd_wheels_is_sound(codes_of):
    for one in list(foreign_testers.odd_wheels())[1::3]:
        assert codes_of(one) <= SOUND, one.name


def test_a_value_that_is_wrong_would_be_seen():
    one = axle(EGEA, "estate").record(PLAIN, "")
    one.truth["left"]["adhesion"] -= 0.1
    assert make_records.judged_test(one) == "silent"
