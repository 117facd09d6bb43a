"""Where each check of a record begins to speak: on both sides of its limit, and the numbers in its sentence."""

from __future__ import annotations

import numpy as np
import pytest

from jounce.inspection import checks
from jounce.inspection.signals import WheelSignals
from jounce.parts.testers import load_tester

EGEA, THETA = load_tester("egea-specsus2018"), load_tester("theta-msd3000")


def wheel(height=None, *, load=4000.0, seconds=10.0, rate=1000.0, plate=20.0) -> WheelSignals:
    time = np.arange(round(seconds * rate) + 1) / rate
    if height is not None:
        height = height * np.sin(2.0 * np.pi * 5.0 * time)
    return WheelSignals("left", time, np.full(time.size, 4000.0), height, None, load, plate)


def codes(findings) -> list[str]:
    return [f"{one.severity}: {one.code}" for one in findings]


@pytest.mark.parametrize(
    ("half", "force", "seconds", "tester", "expected"),
    [
        (3e-3, 4e3, 1.999, EGEA, ["problem: too_short"]),
        (3e-3, 4e3, 2.0, EGEA, []),
        (None, 4e3, 10.0, EGEA, []),
        (0.11, 99.0, 10.0, None, ["problem: columns_swapped"]),
        (0.11, 101.0, 10.0, None, []),
        (0.09, 99.0, 10.0, None, []),
        (0.0, 4e3, 10.0, EGEA, ["problem: plate_still"]),
        (3e-3 * 1.118 / 25.4, 4e3, 10.0, EGEA, ["problem: height_unit"]),
        (3e-3 * 1.122 / 25.4, 4e3, 10.0, EGEA, ["problem: stroke_wrong"]),
        (3e-3 * 1e-3, 4e3, 10.0, EGEA, ["problem: height_unit"]),
        (3e-3 * 0.1, 4e3, 10.0, EGEA, ["problem: height_unit"]),
        (3.0, 4e3, 10.0, EGEA, ["problem: height_unit"]),
        (3e-3 * 0.69, 4e3, 10.0, EGEA, ["problem: stroke_wrong"]),
        (3e-3 * 0.71, 4e3, 10.0, EGEA, ["warning: stroke_off"]),
        (3e-3 * 1.39, 4e3, 10.0, EGEA, ["warning: stroke_off"]),
        (3e-3 * 1.41, 4e3, 10.0, EGEA, ["problem: stroke_wrong"]),
        (3e-3 + 0.49 * EGEA.limits.stroke_tolerance, 4e3, 10.0, EGEA, []),
        (3e-3 + 0.51 * EGEA.limits.stroke_tolerance, 4e3, 10.0, EGEA, ["warning: stroke_off"]),
        (0.5 * THETA.stroke * 0.149, 4e3, 10.0, THETA, ["problem: stroke_unit"]),
        (0.5 * THETA.stroke * 0.151, 4e3, 10.0, THETA, []),
        (0.5 * THETA.stroke * 29.9, 4e3, 10.0, THETA, []),
        (0.5 * THETA.stroke * 30.1, 4e3, 10.0, THETA, ["problem: stroke_unit"]),
        (0.5 * THETA.stroke * 30.1, 4e3, 10.0, None, []),
    ],
)
def test_columns(half, force, seconds, tester, expected) -> None:
    found = checks.check_columns(wheel(half, seconds=seconds), np.array([0.0, -force]), tester)
    assert codes(found) == expected
    if found and "stroke" in found[0].words:
        assert found[0].words["stroke"] == pytest.approx(2e3 * half, rel=1e-3)  # mm
        assert found[0].words.get("expected", 1e3 * EGEA.stroke) in (
            1e3 * EGEA.stroke,
            1e3 * THETA.stroke,
        )


def test_a_height_far_from_its_zero_is_a_force() -> None:
    one = wheel(0.01)
    for middle, expected in (
        (0.29, []),
        (0.31, ["problem: columns_swapped"]),
        (-0.31, ["problem: columns_swapped"]),
    ):
        moved = WheelSignals("left", one.time, one.force, one.height + middle, None, None, 20.0)
        assert codes(checks.check_columns(moved, np.array([50.0]), None)) == expected


LOW, HIGH = EGEA.limits.wheel_load_min, EGEA.limits.wheel_load_max


@pytest.mark.parametrize(
    ("load", "measured", "expected"),
    [
        (None, 299.0, ["problem: no_wheel_load"]),
        (None, 301.0, ["warning: load_out_of_range", "warning: load_from_signal"]),
        (None, 29.9e3, ["warning: load_out_of_range", "warning: load_from_signal"]),
        (None, 30.1e3, ["problem: no_wheel_load"]),
        (LOW, LOW, []),
        (LOW - 1.0, LOW, ["warning: load_out_of_range"]),
        (HIGH, HIGH, []),
        (HIGH + 1.0, HIGH, ["warning: load_out_of_range"]),
        (4e3, 4e3 * 1.0199, []),
        (4e3, 4e3 * 0.9799, ["warning: load_off"]),
        (4e3, 4e3 * 1.0799, ["warning: load_off"]),
        (4e3, 4e3 * 0.9199, ["problem: load_contradicts"]),
        (4e3, 4e3 * 0.22481 * 1.059, ["problem: force_unit"]),
        (4e3, 4e3 * 0.22481 * 1.061, ["problem: load_contradicts"]),
        (4e3, 4e3 * 1.49e-3, ["problem: force_unit"]),
        (4e3, 4e3 * 1.51e-3, ["problem: load_contradicts"]),
        (4e3, 4e3 * 9.80665, ["problem: load_unit"]),
        (4e3, 4e3 * 4.4482, ["problem: load_unit"]),
    ],
)
def test_static_load(load, measured, expected) -> None:
    found = checks.check_load(wheel(load=load), measured, EGEA)
    assert codes(found) == expected
    for one in found:
        if one.code == "load_off":
            assert one.words["percent"] == pytest.approx(100.0 * (measured / 4e3 - 1.0))
        if one.code == "load_contradicts":
            assert one.words["offset"] == pytest.approx(measured - 4e3)
    assert (
        not checks.check_load(wheel(load=measured), measured, None)
        or load is None
        or measured < 300.0
    )


@pytest.mark.parametrize(
    ("ratio", "unit"),
    [
        (0.2248, "pounds (lbf)"),
        (0.1019, "kilograms (kgf)"),
        (0.0999, "daN"),
        (0.001, "kN"),
        (4.45, ""),
        (1.0, None),
    ],
)
def test_units_of_forces(ratio, unit) -> None:
    assert checks._unit_of(ratio) == unit


@pytest.mark.parametrize(
    ("measured", "expected"),
    [
        ((4e3 * 1.029, 3e3), []),
        ((4e3 * 1.031, 3e3 * 1.031), []),  # unlike offsets
        ((3e3 * 1.019, 4e3), ["problem: sides_swapped"]),
        ((3e3 * 1.021, 4e3), []),
        ((4.4e3, 3.4e3), ["problem: both_offset"]),
        ((4.4e3, 3.361e3), ["problem: both_offset"]),
        ((4.4e3, 3.359e3), []),
        ((4e3 * 0.1, 3e3 * 0.1), []),  # each wheel says of which unit it is
        ((4e3 * 0.1, 3.4e3), []),
    ],
)
def test_both_wheels(measured, expected) -> None:
    loads, both = {"left": 4e3, "right": 3e3}, dict(zip(("left", "right"), measured, strict=True))
    found = checks.check_pair(loads, both)
    assert codes(found) == expected
    if expected == ["problem: both_offset"]:
        assert found[0].words["offset"] == pytest.approx(0.5 * (sum(measured) - 7e3))
    assert checks.check_pair(loads, {"left": measured[0]}) == []
    assert checks.check_pair({**loads, "right": None}, both) == []


@pytest.mark.parametrize(
    ("share", "expected"),
    [
        (0.998, ["warning: samples_few"]),
        (0.9995, []),
        (1.0, []),
        (0.1999, ["problem: samples_too_few"]),
    ],
)
def test_sampling(share, expected) -> None:
    wanted = EGEA.limits.sampling_frequency_min
    assert wanted == 1000.0
    found = checks.check_sampling(wheel(rate=share * wanted), EGEA)
    assert codes(found) == expected
    assert all(one.words["wanted"] == wanted for one in found)


def clipped(flat: int, of: int = 4000, at: float = 5e3, sign: float = 1.0) -> np.ndarray:
    """A force that lies at a limit for some samples in a row, entered by jumps like those beside it times two."""
    force = 4e3 + 800.0 * np.sin(2.0 * np.pi * np.arange(of) / 40.0)
    force[100 : 100 + flat] = at
    return 4e3 + sign * (force - 4e3)


@pytest.mark.parametrize(
    ("force", "expected"),
    [
        (clipped(5), []),
        (clipped(6), ["warning: clipped"]),
        (clipped(40), ["warning: clipped"]),
        (clipped(41), ["problem: saturated"]),
        (clipped(41, sign=-1.0), ["problem: saturated"]),
        (np.maximum(clipped(20), 3.99e3) - 3.99e3, ["warning: clipped"]),  # below: lift-off
    ],
)
def test_clipping(force, expected) -> None:
    found = checks.check_clipping(force, 4e3, "left.plate.force")
    assert codes(found) == expected
    for one in found:
        limit = one.words["limit"]
        assert one.words["percent"] == pytest.approx(
            100.0 * np.count_nonzero(force == limit) / force.size
        )


@pytest.mark.parametrize(
    ("samples", "level", "plate", "expected"),
    [
        (8, 0.0, 20.0, ["problem: dropout"]),
        (7, 0.0, 20.0, []),
        (30, 0.0, 0.0, []),
        (30, 0.049 * 4e3, 20.0, ["problem: dropout"]),
        (30, 0.051 * 4e3, 20.0, []),
    ],
)
def test_dropouts(samples, level, plate, expected) -> None:
    force = 4e3 + 500.0 * np.sin(np.arange(2000) * 0.1)
    force[700 : 700 + samples] = level
    force[50:54] = 0.0
    found = checks.check_dropout(force, wheel(plate=plate), 4e3)
    assert codes(found) == expected
    if found:
        assert (found[0].words["force"], found[0].words["time"]) == (
            level,
            pytest.approx(samples),
        )  # N, ms


def test_the_other_plate() -> None:
    def found(other, order=""):
        return codes(checks.check_other_plate("left", (1000, 9000), other, 1e-3, order))

    assert found(None) == found((8501, 20000)) == found((0, 1499)) == []
    assert found((8499, 20000)) == found((0, 1501)) == ["warning: other_running"]
    assert found((0, 1501), "together") == ["note: other_together"]


def test_order_of_the_wheels() -> None:
    def found(order, left, right):
        return codes(checks.check_order(order, {"left": left, "right": right}))

    assert found("left, right", (0, 100), (200, 300)) == []
    assert found("left, right", (200, 300), (0, 100)) == ["problem: order_contradicts"]
    assert found("right,left", (200, 300), (0, 100)) == []
    assert found("left, right", (50, 300), (0, 100)) == ["problem: order_contradicts"]
    assert found("left, right", (49, 300), (0, 100)) == []  # both run
    assert found("left, right", (200, 300), None) == found("together", (200, 300), (0, 100)) == []
    assert found("", (200, 300), (0, 100)) == ["note: order_missing"]
    assert found("", (49, 300), (0, 100)) == found("", None, (0, 100)) == []


@pytest.mark.parametrize(
    ("drift", "expected"),
    [
        (0.049, []),
        (-0.051, ["warning: slips"]),
        (0.199, ["warning: slips"]),
        (-0.201, ["problem: slips"]),
    ],
)
def test_wandering(drift, expected) -> None:
    """Mean forces of turns at 10 Hz stay off for two seconds of five; over the whole test less than a half counts."""
    frequency, mean = np.full(50, 10.0), np.full(50, 4e3)
    mean[20:40] += drift * 4e3
    found = checks.check_wandering(mean, frequency, 4e3, "left")
    assert codes(found) == expected
    if found:
        assert found[0].words["percent"] == pytest.approx(100.0 * drift, rel=1e-6)
    hopping = checks.check_wandering(mean, frequency, 4e3, "left", hops=True)
    assert [one.words["percent"] for one in hopping] == (
        [pytest.approx(40.0 * drift)] if abs(0.4 * drift) > 0.05 else []
    )
    assert checks.check_wandering(mean[20:31], frequency[:11], 4e3, "left") == []
    assert codes(checks.check_wandering(mean[20:32], frequency[:12], 4e3, "left")) == expected
    assert checks.check_wandering(mean, np.full(50, 5.99), 4e3, "left") == []


def test_a_short_shove_is_no_slip() -> None:
    """Half a second of 8 % is 4 % over a swing of the body."""
    frequency, mean = np.full(50, 10.0), np.full(50, 4e3)
    mean[20:25] *= 1.08
    assert checks.check_wandering(mean, frequency, 4e3, "left") == []


def test_strokes_of_a_plate_that_is_not_rigid() -> None:
    frequency = np.linspace(25.0, 6.0, 39)
    for spread, expected in ((1.29, []), (1.31, ["problem: not_rigid"])):
        inside = (frequency > 7.0) & (frequency < 24.0)
        strokes = np.where(inside & (frequency < 15.0), 6e-3 * spread, 6e-3)
        strokes[~inside] = 0.1
        found = checks.check_rigid(strokes, frequency, "left.plate.z")
        assert codes(found) == expected
        if found:
            assert found[0].words == pytest.approx({"low": 6.0, "high": 6.0 * spread})
        assert (
            checks.check_rigid(
                strokes[inside][::3][:11], frequency[inside][::3][:11], "left.plate.z"
            )
            == []
        )


def test_testers_of_the_header() -> None:
    assert checks.check_tester("", EGEA) == checks.check_tester("own", None) == []
    assert (
        checks.check_tester("egea-specsus2018", EGEA) == checks.check_tester(EGEA.name, EGEA) == []
    )
    assert codes(checks.check_tester("eusama", EGEA)) == ["note: other_tester"]
    assert codes(checks.check_tester("our lane", EGEA)) == ["note: other_tester"]
    found = checks.check_tester("theta-msd3000", EGEA)
    assert codes(found) == ["problem: other_kind"]
    assert (found[0].words["kind"], found[0].words["own"]) == ("sprung-plate", "rigid-plate")


def test_values_that_are_no_numbers_are_counted() -> None:
    time = np.arange(100) * 0.01
    values = np.where(np.isin(np.arange(100), (30, 31)), np.nan, 1.0)
    one = np.where(np.arange(100) == 7, np.inf, 1.0)
    found = checks.check_finite({"a": values, "b": one, "c": time}, time)
    assert [(f.place, f.words["count"], f.words["time"], f.code) for f in found] == [
        ("a", 2, pytest.approx(0.3), "samples_missing"), ("b", 1, pytest.approx(0.07), "sample_missing"),
    ]  # fmt: skip


@pytest.mark.parametrize(("jump", "expected"), [(14.9, []), (15.1, ["problem: saturated"])])
def test_a_force_that_stays_at_its_top_is_entered_by_a_jump(
    jump: float, expected: list[str]
) -> None:
    """Beside 10 N from sample to sample one and a half times as much is a jump."""
    up = 4e3 + 10.0 * np.arange(80)
    force = np.concatenate([up, np.full(6, up[-1] + jump), up[::-1]])
    assert codes(checks.check_clipping(force, 4e3, "left.plate.force")) == expected
    assert (
        codes(checks.check_clipping(force[:86], 4e3, "left.plate.force")) == expected
    )  # entered, not left
