from __future__ import annotations

import numpy as np
import pytest

from jounce.core.errors import RecordingError
from jounce.core.units import conversion_factor
from jounce.recordings import recording
from jounce.recordings.schema import (
    QUANTITIES,
    channel_unit,
    channels_of,
    check_recording,
    describe,
    extremes,
    place_of,
    quantity_of,
)

TIME = np.arange(5) * 0.001


def test_variables_carry_unit_words_and_place() -> None:
    run = recording(
        TIME,
        {
            "front_left.wheel.az": (np.arange(5.0), "m/s^2", ""),
            "pitch_rate": (TIME, "rad/s", "rate"),
        },
    )
    assert run["front_left.wheel.az"].attrs == {
        "units": "m/s^2",
        "long_name": "vertical acceleration, front left wheel",
        "place": "front_left.wheel",
    }
    assert run["pitch_rate"].attrs == {"units": "rad/s", "long_name": "rate", "place": ""}
    assert run["time"].attrs["units"] == "s"
    assert run["front_left.wheel.az"].dims == ("time",)
    check_recording(run)


def test_channels_can_be_selected_by_time() -> None:
    run = recording(TIME, {"sprung.z": (TIME * 2.0, "m", "")})
    assert float(run["sprung.z"].sel(time=0.003)) == pytest.approx(0.006, abs=1e-15)


def test_float_arrays_are_not_copied() -> None:
    values = np.zeros(5)
    run = recording(TIME, {"sprung.z": (values, "m", "")})
    assert np.shares_memory(run["sprung.z"].values, values)


def test_wrong_length_names_the_channel() -> None:
    with pytest.raises(
        RecordingError, match=r"sprung\.z: .*different numbers of samples.*\(4,\).*\(5,\)"
    ):
        recording(TIME, {"sprung.z": (np.zeros(4), "m", "")})


@pytest.mark.parametrize(
    ("name", "unit"),
    [
        ("sprung.az", "m/s^2"),
        ("unsprung.vz", "m/s"),
        ("road.z", "m"),
        ("tyre.force", "N"),
        ("strut.deflection", "m"),
        ("strut.deflection_velocity", "m/s"),
        ("front.suspension_deflection", "m"),
        ("road.slope", "1"),
        ("pitch_rate", "rad/s"),
        ("time", "s"),
    ],
)
def test_unit_by_last_word(name: str, unit: str) -> None:
    assert channel_unit(name) == unit


def test_unknown_quantity_has_a_near_match() -> None:
    assert quantity_of("sprung.colour") == ""
    with pytest.raises(RecordingError, match=r"strut\.defletion: .*Did you mean 'deflection'"):
        channel_unit("strut.defletion")
    with pytest.raises(RecordingError):
        channel_unit("")


@pytest.mark.parametrize("name", QUANTITIES)
def test_every_quantity_has_an_si_unit_and_words(name: str) -> None:
    unit, words = QUANTITIES[name]
    assert conversion_factor(unit, unit) == 1.0
    assert words
    assert channel_unit(f"place.{name}") == unit


def test_place_and_words() -> None:
    assert place_of("front_left.wheel.az") == "front_left.wheel"
    assert place_of("pitch") == ""
    assert describe("pitch") == "pitch angle"
    assert describe("a.unheard_of") == "unheard of, a"


def good() -> dict[str, tuple[np.ndarray, str, str]]:
    return {"sprung.az": (np.arange(5.0), "m/s^2", "")}


def test_check_refuses_what_is_no_recording() -> None:
    run = recording(TIME, good())
    with pytest.raises(RecordingError, match="no time coordinate"):
        check_recording(run.drop_vars("time"))
    other = run.copy(deep=True)
    other["time"].attrs["units"] = "ms"
    with pytest.raises(
        RecordingError,
        match=r"time has the wrong unit; found 'ms'; allowed: an attribute 'units' of 's'",
    ):
        check_recording(other)
    with pytest.raises(RecordingError, match="does not increase"):
        check_recording(recording(TIME[::-1].copy(), good()))
    with pytest.raises(
        RecordingError,
        match=r"sprung\.az: the channel has a different unit; found 'g'; allowed: m/s\^2",
    ):
        check_recording(recording(TIME, {"sprung.az": (TIME, "g", "")}))
    with pytest.raises(RecordingError, match=r"a\.nc: sprung\.az: sample 3 is not a finite number"):
        check_recording(
            recording(TIME, {"sprung.az": (np.array([0.0, 0.0, np.nan, 0.0, 0.0]), "m/s^2", "")}),
            where="a.nc",
        )
    with pytest.raises(RecordingError, match="not a signal over time"):
        check_recording(run.assign({"mass": 1.0}))
    with pytest.raises(RecordingError, match="has no unit"):
        check_recording(run.assign({"sprung.vz": ("time", TIME)}))


def test_extremes_with_their_times() -> None:
    channels = {"tyre.force": (np.array([5.0, 9.0, -1.0, 9.0]), "N", "")}
    assert extremes(np.array([0.0, 0.1, 0.2, 0.3]), channels)["tyre.force"] == {
        "unit": "N", "static": 5.0,
        "minimum": -1.0, "time_of_minimum": 0.2, "maximum": 9.0, "time_of_maximum": 0.1,
    }  # fmt: skip


def test_channels_are_found_at_every_corner() -> None:
    names = ["front.tyre.force", "rear.tyre.force", "rear.old_tyre.force", "body.az"]
    assert channels_of("tyre.force", names) == names[:2]
    assert channels_of("body.az", [*names, "front.body.az"]) == ["body.az"]
    assert channels_of("sprung.az", names) == []
