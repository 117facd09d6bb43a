"""Recordings zeroed at rest, counted as the model does, or from anywhere, against models that count from undeformed."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

import jounce as jn
from jounce.identify.datum import QuietStart, with_datums

pytestmark = pytest.mark.usefixtures("units_kept")
RIG = jn.load("kart-quarter-car")
TRUTH = RIG.with_changes(
    {
        "strut.spring.rate": "21.5 N/mm",
        "tyre.stiffness": "130 N/mm",
        "strut.damper.coefficient": 110.0,
    }
)
TRIAL = jn.Trial(
    road=jn.HalfSine(height="10 mm", length="60 mm", start="0.6 m"),
    speed="1.95 m/s",
    duration="1.2 s",
)
FREE = {
    "strut.spring.rate": "20 %",
    "tyre.stiffness": "20 %",
    "strut.damper.coefficient": [50.0, 300.0],
}
HEIGHTS = ["sprung.z", "unsprung.z", "strut.deflection", "tyre.deflection"]


@cache
def true_run():
    return jn.simulate(TRUTH, TRIAL, tolerance=1e-9)


def recorded(names, offset):
    """The truth's channels with a constant taken off: "rest", or a number in m or N."""
    return true_run()[names].map(
        lambda signal: signal - (signal[0] if offset == "rest" else offset)
    )


def exact(result):
    for path, parameter in result.parameters.items():
        assert parameter.value == pytest.approx(TRUTH.parameters()[path], rel=1e-4), path
        assert not parameter.at_bound


def said(result, channel):
    return [f for f in result.findings if f.place == channel and "datum" in f.message]


@pytest.mark.parametrize("channel", HEIGHTS)
@pytest.mark.parametrize(
    ("offset", "datum"), [("rest", "rest"), (0.0, "undeformed"), (0.7, "free offset")]
)
def test_heights_of_any_datum_give_the_exact_truth(channel, offset, datum):
    update = jn.update_model(
        [jn.FitTrial("one", RIG, TRIAL, recorded([channel], offset))], FREE, method="least-squares"
    )
    exact(update)
    assert [f'datum "{datum}"' in f.message for f in said(update, channel)] == [True]
    assert said(update, channel)[0].severity == ("warning" if datum == "free offset" else "note")


@pytest.mark.parametrize("channel", ["strut.force", "tyre.force"])
@pytest.mark.parametrize("offset", ["rest", 0.0, 5e3])
def test_load_cells_of_any_datum_give_the_exact_truth(channel, offset):
    exact(jn.update_model([jn.FitTrial("one", RIG, TRIAL, recorded([channel], offset))], FREE))


def test_accelerometers_that_show_gravity():
    with_gravity = recorded(["sprung.az"], -9.81)
    update = jn.update_model([jn.FitTrial("one", RIG, TRIAL, with_gravity)], FREE)
    exact(update)
    assert "free offset" in said(update, "sprung.az")[0].message
    assert not said(
        jn.update_model([jn.FitTrial("one", RIG, TRIAL, recorded(["sprung.az"], 0.0))], FREE),
        "sprung.az",
    )


def test_a_stated_datum_is_kept_even_if_wrong():
    """Zeroed at rest, stated as undeformed: the parameters run away, which is what the default prevents."""
    sensors = {"sprung.z": jn.Sensor(datum="undeformed")}
    update = jn.update_model(
        [jn.FitTrial("one", RIG, TRIAL, recorded(["sprung.z"], "rest"), sensors)], FREE
    )
    assert not said(update, "sprung.z")
    assert any(parameter.at_bound for parameter in update.parameters.values())


@pytest.mark.parametrize("datum", ["rest", "free offset"])
def test_a_stated_datum_holds_without_a_word(datum):
    sensors = {"unsprung.z": jn.Sensor(datum=datum, gain=2.0, orientation=-1)}
    measured = jn.apply_sensors(true_run()[["unsprung.z"]], sensors)
    update = jn.update_model([jn.FitTrial("one", RIG, TRIAL, measured, sensors)], FREE)
    exact(update)
    assert not said(update, "unsprung.z")


def test_a_record_that_begins_in_motion_has_a_free_offset():
    late = recorded(["sprung.z"], "rest").sel(time=slice(0.33, None))
    update = jn.update_model([jn.FitTrial("one", RIG, TRIAL, late)], FREE)
    exact(update)
    assert "free offset" in said(update, "sprung.z")[0].message


def test_starts_that_say_different_things_leave_the_offset_of_each_trial_free():
    measured = {
        "one": recorded(["sprung.z"], "rest"),
        "two": recorded(["sprung.z"], 0.0),
        "three": recorded(["sprung.z"], 0.2),
    }
    update = jn.update_model(
        [jn.FitTrial(name, RIG, TRIAL, data) for name, data in measured.items()], FREE
    )
    exact(update)
    (finding,) = said(update, "sprung.z")
    assert 'datum "free offset" taken from the start of one, two, three' in finding.message
    assert "the starts of the trials contradict each other" in finding.message


@pytest.mark.parametrize(("offset", "datum"), [("rest", "rest"), (0.0, "undeformed")])
def test_one_sensor_has_one_datum_also_where_a_record_begins_in_motion(offset, datum):
    whole = recorded(["sprung.z"], offset)
    begun = whole.isel(time=slice(320, None))  # on the obstacle
    begun = begun.assign_coords(time=begun["time"])
    trials = [jn.FitTrial("one", RIG, TRIAL, whole), jn.FitTrial("two", RIG, TRIAL, begun)]
    decided, findings = with_datums(trials)
    assert [trial.sensors["sprung.z"].datum for trial in decided] == [datum, datum]
    taken, moving = [one.message for one in findings if "datum" in one.message]
    assert f'datum "{datum}" taken from the start of one:' in taken
    assert (
        moving
        == "begins in motion in two; the datum of the trials that begin at rest applies there"
    )


@pytest.mark.parametrize(
    ("recorded", "datum"),
    [
        (0.0, "rest"),
        (-0.0009, "rest"),
        (-0.010, "undeformed"),
        (-0.007, "undeformed"),
        (-0.004, "free offset"),
        (None, "free offset"),
    ],
)
def test_how_close_a_zero_must_be(recorded, datum):
    assert QuietStart(recorded, 0.0, -0.010, 0.0, 1e-9).datum() == datum
    turned = QuietStart(None if recorded is None else -recorded, 0.0, 0.010, 0.0, 1e-9)
    assert turned.datum() == datum


def test_noise_at_the_start_is_no_offset():
    noisy = recorded(["sprung.az"], 0.0)
    noisy["sprung.az"] += np.random.default_rng(3).normal(0.0, 2.0, noisy["sprung.az"].shape)
    assert not said(jn.update_model([jn.FitTrial("one", RIG, TRIAL, noisy)], FREE), "sprung.az")


@pytest.mark.parametrize(
    "channel", ["sprung.z", "strut.deflection", "sprung.az", "unsprung.az", "tyre.force"]
)
def test_a_turned_channel_is_named(channel):
    for align in (None, "lag"):
        right = jn.update_model(
            [jn.FitTrial("one", RIG, TRIAL, recorded([channel], "rest"))], FREE, align=align
        )
        assert not [f for f in right.findings if f.code == "identify.channel_turned"]
    turned = jn.update_model([jn.FitTrial("one", RIG, TRIAL, -recorded([channel], "rest"))], FREE)
    (named,) = [f for f in turned.findings if f.code == "identify.channel_turned"]
    assert (named.place, named.severity) == (channel, "warning")
