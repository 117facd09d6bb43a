"""Magnitudes that no suspension reaches are a problem that names the likely unit; what suspensions do is not."""

from __future__ import annotations

import numpy as np
import pytest

from jounce.recordings.plausibility import REACHES, implausible
from jounce.recordings.schema import QUANTITIES, channel_unit

STEP = 0.001
TIME = np.arange(5000) * STEP
WAVE = np.sin(2.0 * np.pi * 1.7 * TIME)
USUAL = {  # true signals in SI
    "stroke": 0.0125 * WAVE,
    "sprung.az": 3.0 * WAVE,
    "unsprung.az": 60.0 * WAVE,
    "strut.deflection": 0.03 * WAVE,
    "strut.deflection_velocity": 0.4 * WAVE,
    "tyre.force": 4000.0 + 900.0 * WAVE,
    "front_left.camber": 0.02 * WAVE,
    "pitch_rate": 0.2 * WAVE,
    "sprung.z": 0.02 * WAVE,
    "speed": 20.0 + WAVE,
    "platform.frequency": np.linspace(25.0, 0.5, 5000),
    "damper.pressure": 3e6 + 1e5 * WAVE,
}


def test_usual_suspensions_have_no_findings() -> None:
    for name, values in USUAL.items():
        for size in (0.3, 1.0, 3.0):
            assert implausible({name: size * values}, STEP, where="a.csv") == []
    assert set(REACHES) <= set(QUANTITIES)


@pytest.mark.parametrize(
    ("name", "said", "true", "says"),
    [
        ("stroke", "m", "mm", "is its unit mm or cm rather than m"),
        ("sprung.az", "m/s^2", "mm/s^2", "mm/s^2"),
        ("sprung.az", "m/s^2", "mg", "mg"),
        ("unsprung.az", "m/s^2", "mg", "mg"),
        ("unsprung.az", "g", "mg", "mg"),
        ("strut.deflection", "m", "mm", "is its unit mm rather than m"),
        ("strut.deflection", "m", "cm", "is its unit cm"),
        ("strut.deflection_velocity", "m/s", "mm/s", "mm/s"),
        ("tyre.force", "kN", "N", "is its unit N or lbf rather than kN"),
        (
            "front_left.camber",
            "rad",
            "deg",
            "",
        ),  # 1.1 degrees taken for radians are below 1.6: not told
        ("pitch_rate", "rad/s", "deg/s", ""),
        ("sprung.z", "m", "mm", "is its unit mm or cm rather than m"),
        ("speed", "m/s", "mm/s", "mm/s"),
        ("platform.frequency", "Hz", "rpm", "is its unit rpm rather than Hz"),
        ("damper.pressure", "MPa", "Pa", "is its unit Pa"),
        ("stroke", "mm", "m", "is its unit m"),
    ],
)
def test_the_likely_unit_is_named(name: str, said: str, true: str, says: str) -> None:
    from jounce.core.units import conversion_factor

    si = channel_unit(name)
    wrong = USUAL[name] * conversion_factor(said, si) / conversion_factor(true, si)
    found = implausible({name: wrong}, STEP, where="a.csv", written={name: said})
    if not says:
        assert found == []
        return
    (finding,) = found
    assert says in finding.message
    assert f"rather than {said}" in finding.message
    assert finding.severity == (
        "problem" if abs(wrong).max() > abs(USUAL[name]).max() else "warning"
    )
    assert finding.place == f"a.csv: {name}"
    assert finding.value is not None


MOTIONS, RATES, FORCES = (
    ("deflection", "displacement", "stroke", "travel"),
    ("velocity", "vz"),
    ("force", "load"),
)
LIMITS = [  # quantities, number, what no suspension reaches, below which a number is suspicious, SI
    (MOTIONS, "range", 1.5, 1e-4),
    ((*MOTIONS, "z"), "rate", 30.0, None),
    (("ax", "ay", "acceleration", "az"), "mean", 30.0, None),
    (("ax", "ay", "acceleration"), "r.m.s.", 1000.0, None),
    (("az",), "r.m.s.", 1000.0, 0.01),
    (("deflection_velocity", *RATES), "r.m.s.", 30.0, 1e-3),
    (("speed", "vx", "vy"), "peak", 150.0, None),
    (FORCES, "peak", 1e6, 10.0),
    (("moment", "torque"), "peak", 1e6, None),
    (("camber", "toe", "pitch", "roll"), "peak", 1.6, None),
    (("steer",), "peak", 20.0, None),
    (("phase_angle",), "peak", 6.3, None),
    (("pitch_rate", "roll_rate", "yaw_rate"), "r.m.s.", 20.0, None),
    (("pitch_acceleration", "roll_acceleration"), "r.m.s.", 2000.0, None),
    (("pressure",), "peak", 2e8, None),
    (("frequency",), "peak", 500.0, None),
    (("adhesion",), "peak", 1.5, None),
    (("sprung.az", "body.az", "seat.az", "chassis.az"), "r.m.s.", 100.0, 0.01),
]


def of_size(number: str, size: float) -> np.ndarray:
    """A signal whose number is the size, and whose others are as small as that allows."""
    if number == "mean":
        return np.full(TIME.size, size)
    if number == "range":
        return np.linspace(0.0, size, TIME.size)
    if number == "rate":
        return 0.5 * STEP * size * (-1.0) ** np.arange(TIME.size)
    return size * (-1.0) ** np.arange(TIME.size)


@pytest.mark.parametrize(("names", "number", "most", "least"), LIMITS)
def test_limits_are_where_they_are_said_to_be(
    names: tuple[str, ...], number: str, most: float, least: float | None
) -> None:
    for name in names:
        places = name if "." in name else f"left.{name}"
        assert implausible({places: of_size(number, 0.99 * most)}, STEP, where="") == []
        (finding,) = implausible({places: of_size(number, 1.01 * most)}, STEP, where="")
        assert (finding.severity, finding.value) == (
            "problem",
            pytest.approx(1.01 * most, rel=1e-3),
        )
        si = channel_unit(name) + "/s" * (number == "rate")
        said = "changes by" if number == "rate" else f"the {number} is"
        assert (
            f"{said} {1.01 * most:.3g} {si}, but no suspension exceeds {most:g} {si}"
            in finding.message
        )
        if least is None:
            continue
        for size, told in ((1.01, False), (0.99, True), (0.0101, True), (0.0099, False)):
            small = {places: of_size(number, size * least)}
            found = implausible(small, STEP, where="", written={places: channel_unit(name)})
            assert [(one.severity, one.value) for one in found] == [
                ("warning", pytest.approx(size * least, rel=1e-3))
            ] * told
            assert implausible(small, STEP, where="") == []  # simulated, not read


def test_limits_of_time_of_work_and_of_rates() -> None:
    for step, told in (
        (0.2, ""),
        (0.21, "ms"),
        (190.0, "ms"),
        (210.0, "µs"),
        (2e-4, ""),
        (1e-5, "a larger one"),
    ):
        found = implausible({"sprung.az": WAVE}, step, where="")
        assert [told in one.message for one in found] == [True] * bool(told)
        assert [one.place for one in found] == ["time"] * bool(told)
    turn = np.cos(2.0 * np.pi * 1.7 * TIME)
    for frequency, size in (
        (1.6, 8e3),
        (3.2, 2e4 / 3.2),
    ):  # J a cycle: the work, then the power of 20 kW
        wave, other = np.sin(2.0 * np.pi * frequency * TIME), np.cos(2.0 * np.pi * frequency * TIME)
        for share, told in ((0.97, 0), (1.03, 1)):
            channels = {"travel": 0.05 * other, "force": share * size / (np.pi * 0.05) * wave}
            found = implausible(channels, STEP, where="a.csv")
            assert [one.value for one in found] == [pytest.approx(share * size, rel=2e-3)] * told
    for share, told in ((0.103, 0), (0.097, 1), (9.7, 0), (10.3, 1)):
        moved = {"left.z": 0.01 * WAVE, "left.vz": share * 2.0 * np.pi * 1.7 * 0.01 * turn}
        found = implausible(moved, STEP, where="a.csv")
        assert [one.place for one in found] == ["a.csv: left.vz"] * told
        assert (
            implausible({"road.z": moved["left.z"], "road.vz": moved["left.vz"]}, STEP, where="")
            == []
        )
        assert (
            implausible({"left.z": moved["left.z"], "right.vz": moved["left.vz"]}, STEP, where="")
            == []
        )


def test_rounding_at_rest_has_no_rate() -> None:
    """As a run on a flat road gives it: NumPy warned of correlations, and a velocity was 1e15 times too large."""
    noise = 4e-18 * np.sin(np.arange(TIME.size))
    for moved in (np.full(TIME.size, -0.00148778), np.zeros(TIME.size)):
        assert implausible({"unsprung.z": moved, "unsprung.vz": noise}, STEP, where="") == []


@pytest.mark.parametrize("name", ["sprung.az", "wheel.az"])
def test_gravity_is_looked_for_in_a_second_of_record(name: str) -> None:
    for mean, samples, told in (
        (0.981, 1000, 1),
        (1.019, 1000, 1),
        (0.979, 1000, 0),
        (1.021, 1000, 0),
        (1.0, 999, 0),
    ):
        values = mean + 0.3 * (-1.0) ** np.arange(2 * (samples // 2) + samples % 2) * (
            np.arange(samples) < 998
        )
        found = implausible({name: values}, STEP, where="a.csv", written={name: "m/s^2"})
        assert [one.place for one in found] == [f"a.csv: {name}"] * told


def test_a_unit_that_cannot_be_read_gives_no_advice_of_another() -> None:
    (finding,) = implausible(
        {"stroke": 12.45 * WAVE}, STEP, where="", written={"stroke": "furlongs per egg"}
    )
    assert finding.message.endswith("; check its unit")
    assert implausible({"stroke": np.array([9.0])}, STEP, where="") == []  # one number is no motion


def test_the_numbers_of_the_wrong_records() -> None:
    """10 000 m/s^2 mean, a stroke of 24.9 m, 12.7 kJ a cycle."""
    (mean,) = implausible({"sprung.az": 9806.65 + 100.0 * WAVE}, STEP, where="")
    assert mean.value == pytest.approx(9806.65, rel=1e-3)
    assert "is its unit mm/s^2" in mean.message
    (stroke,) = implausible({"stroke": 12.45 * WAVE}, STEP, where="")
    assert "the range is 24.9 m" in stroke.message
    size = 12.7e3 / (np.pi * 0.0125)  # area of the ellipse of force over stroke
    force = size * np.cos(2.0 * np.pi * 1.7 * TIME)
    (work,) = implausible({"displacement": 0.0125 * WAVE, "force": force}, STEP, where="")
    assert work.value == pytest.approx(12.7e3, rel=0.1)
    assert work.severity == "problem"
    assert implausible({"displacement": 0.0125 * WAVE, "force": 0.02 * force}, STEP, where="") == []


def test_a_step_of_time_at_which_no_suspension_moves() -> None:
    for step, unit in ((1.0, "ms"), (1000.0, "µs"), (1e-6, "a larger one")):
        (finding,) = implausible({"sprung.az": WAVE}, step, where="a.csv")
        assert unit in finding.message
        assert (finding.place, finding.severity) == ("a.csv: time", "problem")


def test_velocity_and_displacement_that_contradict_each_other() -> None:
    rate = 2.0 * np.pi * 1.7 * 0.0125 * np.cos(2.0 * np.pi * 1.7 * TIME)
    channels = {"stroke": 0.0125 * WAVE, "velocity": rate}
    assert implausible(channels, STEP, where="") == []
    for factor in (0.001, 25.4, 100.0):
        (finding,) = implausible({**channels, "velocity": factor * rate}, STEP, where="")
        assert finding.value == pytest.approx(factor, rel=0.05)
        assert "times the rate of stroke" in finding.message
    noisy = np.random.default_rng(1).normal(0.0, 1e-4, TIME.size)
    assert (
        implausible(
            {"stroke": 0.0125 * WAVE + noisy, "velocity": rate + 100.0 * noisy}, STEP, where=""
        )
        == []
    )


def test_gravity_in_g_under_a_header_in_metres() -> None:
    (finding,) = implausible(
        {"sprung.az": 1.002 + 0.1 * WAVE}, STEP, where="", written={"sprung.az": "m/s^2"}
    )
    assert "is this gravity, with the unit g" in finding.message


def test_roads_may_climb_and_columns_need_no_time() -> None:
    assert implausible({"road.z": 300.0 * WAVE, "road.x": 1e5 * WAVE}, STEP, where="") == []
    (finding,) = implausible({"displacement": np.linspace(0.0, 40.0, 20)}, None, where="tyre.csv")
    assert "is its unit mm or cm rather than m" in finding.message
