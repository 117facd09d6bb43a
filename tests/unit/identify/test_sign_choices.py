"""Which column of a damper record is turned, by what was stated, what gas pushes and what could be swapped."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from jounce.core.findings import Finding, finding
from jounce.identify.estimate import Estimate
from jounce.identify.signs import (
    Signs,
    _Choice,
    _sign,
    _unlike,
    closed_part,
    damper_signs,
    likeness,
    static_force,
)

Told = list[tuple[str, str, float | None]]


def asked(choice: _Choice, *, turned: bool) -> tuple[Signs, Told]:
    told: Told = []

    def add(code: str, value: float | None = None, /, **numbers: object) -> None:
        item = finding(code, "a.csv", value, **numbers)
        told.append((item.severity, item.message, item.value))

    return (choice.reverse_one if turned else choice.dissipating)(add), told


@pytest.mark.parametrize("stroke", [False, True])
@pytest.mark.parametrize("force", [False, True])
@pytest.mark.parametrize("gas", [-1, 0, 1])
@pytest.mark.parametrize("unlike", [False, True])
def test_a_column_that_is_turned_is_named_with_the_reason(
    stroke: bool, force: bool, gas: int, unlike: bool
) -> None:
    signs, ((severity, text, value),) = asked(
        _Choice(Signs(1, 1), stroke, force, gas, gas * 60.0, unlike), turned=True
    )
    by_gas = "stroke" if gas > 0 else "force"
    column = {(True, False): "force", (False, True): "stroke"}.get((stroke, force), by_gas)
    assert signs == (Signs(-1, 1) if column == "stroke" else Signs(1, -1))
    assert f"the {column} was recorded with the opposite sign" in text
    rest = gas * 60.0 * (-1.0 if column == "force" else 1.0)
    assert value == (rest if gas else None)
    reasons = {
        ", though its sign was stated": stroke and force,
        ", since the sign of the other column was stated": stroke != force,
        f", since a gas force of {rest:.3g} N then pushes outwards": not (stroke or force)
        and gas != 0,
        ", or the stroke was: the record cannot decide": not (stroke or force)
        and gas == 0
        and unlike,
        f"; but then the force at rest pulls inwards ({rest:.3g} N)": gas != 0 and rest < 0.0,
    }
    assert {words: words in text for words in reasons} == reasons
    assert severity == ("problem" if (stroke and force) or (gas and rest < 0.0) else "warning")
    state = "extension" if column == "stroke" else "tension"
    assert text.endswith(f". The {column} has been reversed: state {column}_positive = {state!r}.")


def test_columns_that_agree_are_questioned_where_swapping_them_would_matter() -> None:
    for stroke, force, gas, unlike in itertools.product(
        (False, True), (False, True), (-1, 0, 1), (False, True)
    ):
        signs, told = asked(
            _Choice(Signs(1, -1), stroke, force, gas, gas * 60.0, unlike), turned=False
        )
        assert signs == Signs(1, -1)
        stated = stroke or force
        if not unlike or gas > 0 or (stated and gas == 0):
            assert told == []
            continue
        ((severity, text, value),) = told
        assert (severity, value) == ("warning", -60.0 if gas else None)
        assert ("where gas would push outwards" in text) == (gas < 0)
        assert ("the record contains no gas force to identify them" in text) == (gas == 0)
        assert ("Check what was stated." in text) == stated


def test_what_shows_how_a_record_counts() -> None:
    wave = np.sin(np.linspace(0.0, 20.0, 400))
    for size, sign in ((0.099, 0), (0.101, 1)):  # half a percent of the range of 20 N
        assert _sign(Estimate(size), 10.0 * np.sign(wave)) == sign
        assert _sign(Estimate(-size), 10.0 * np.sign(wave)) == -sign
    assert _sign(Estimate(3.0, 2.0, (-1.0, 7.0)), wave) == 0
    assert _sign(Estimate(3.0, 1.0, (1.0, 5.0)), wave) == 1
    for ratio, unlike in ((1.05, False), (1.07, True)):  # 3 % of their sum
        force = np.where(wave > 0.0, ratio, 1.0) * wave
        assert _unlike(wave, force + 3.0, 3.0) == unlike
        assert _unlike(-wave, -force, 0.0) == unlike
    assert not _unlike(np.abs(wave), wave, 0.0)


def test_the_force_at_rest_is_told_from_damping_friction_and_spring() -> None:
    time = np.arange(4000) * 1e-3
    x, v = 0.03 + 0.02 * np.sin(9.0 * time), 0.18 * np.cos(9.0 * time)
    force = (
        60.0
        + 900.0 * (x - 0.03)
        + 500.0 * np.maximum(v, 0.0)
        + 2000.0 * np.minimum(v, 0.0)
        + 25.0 * np.tanh(v / 0.0018)
    )
    fast = (
        3e4 * np.maximum(np.abs(v) - 0.04, 0.0) ** 2
    )  # what a valve does beyond a fifth of the largest speed
    assert static_force(x, v, force + fast).value == pytest.approx(60.0, rel=1e-6)
    few = slice(
        None, None, 19
    )  # fewer than 30 of its samples are slow: those within two fifths are taken
    assert (
        np.count_nonzero(np.abs(v[few]) <= 0.036) < 30 <= np.count_nonzero(np.abs(v[few]) <= 0.072)
    )
    faster = 3e4 * np.maximum(np.abs(v) - 0.075, 0.0) ** 2
    assert static_force(x[few], v[few], (force + faster)[few]).value == pytest.approx(
        60.0, rel=1e-4
    )


def test_likeness_has_the_sign_of_a_record() -> None:
    wave = np.sin(np.arange(300) * 0.1) * np.exp(-np.arange(300) / 100.0)
    assert likeness(wave[3:], wave[:-3], 5) == pytest.approx(1.0, abs=1e-3)
    assert likeness(-wave[3:], wave[:-3], 5) == pytest.approx(-1.0, abs=1e-3)
    assert likeness(np.ones(300), wave, 5) == likeness(wave, np.ones(300), 5) == 0.0
    assert likeness(wave[:17], wave[:17], 5) == 0.0  # 5 either way and 8 samples
    assert likeness(wave[:18], wave[:18], 5) == pytest.approx(1.0)


@pytest.mark.parametrize("end", [3.6, 4.0, 4.4])
@pytest.mark.parametrize("begin", [0.0, 0.25])
def test_gas_does_no_work_however_a_record_ends(begin: float, end: float) -> None:
    """Gas of ten times the damping force, over a path that does not close, was taken for a damper that gives energy."""
    angle = 2.0 * np.pi * np.linspace(begin, end, 3000)
    for sign in (1.0, -1.0):
        findings: list[Finding] = []
        x, v = sign * np.sin(angle), sign * np.cos(angle)
        found = damper_signs(
            x, v, 10.0 + v, stroke_positive=None, force_positive=None, name="a", findings=findings
        )
        assert (found.stroke, found.force, findings) == (1, 1, [])


@pytest.mark.parametrize(("share", "told"), [(0.021, False), (0.019, True), (-0.019, True)])
def test_what_does_hardly_any_work_is_no_damper(share: float, told: bool) -> None:
    """A spring, whose force is a quarter of a period off the velocity, and a little damping."""
    angle = np.arange(4000) * (2.0 * np.pi / 1000.0)
    x, v = np.sin(angle), np.cos(angle)
    part, closed = share, closed_part(x)
    for _ in range(20):  # the work over that of the sizes, which the damping is a part of
        force, rate = (x + part * v)[closed], v[closed]
        force -= force.mean()
        part *= share / (float(force @ rate) / float(np.abs(force) @ np.abs(rate)))
    findings: list[Finding] = []
    damper_signs(
        x, v, x + part * v, stroke_positive=None, force_positive=None, name="a", findings=findings
    )
    idle = [one.value for one in findings if "hardly any work" in one.message]
    assert idle == ([pytest.approx(share)] if told else [])
