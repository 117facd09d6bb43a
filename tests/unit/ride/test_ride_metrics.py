from __future__ import annotations

import re
from types import SimpleNamespace

import numpy as np
import pytest

import jounce as jn
from jounce.core.serialise import to_json, to_plain
from jounce.core.units import to_si
from jounce.recordings import recording
from jounce.ride import comfort
from jounce.ride.catalogue import CATALOGUE, Choices, peak_use
from jounce.ride.metrics import by_corner, gaps_of, ride_metrics
from jounce.ride.weighting import weight

TIME = np.arange(0.0, 40.0 + 5e-4, 1e-3)
WAVE = np.sin(2.0 * np.pi * 5.0 * TIME)

SI = {"m", "s", "kg", "rad", "N", "J", "W", "Pa", "Hz"}


def recorded(**channels: np.ndarray):
    """A recording; a double underscore in a name stands for a dot."""
    units = {"az": "m/s^2", "ax": "m/s^2", "deflection": "m", "velocity": "m/s", "force": "N"}
    units |= {"damper_force": "N", "pitch_acceleration": "rad/s^2"}
    named = {name.replace("__", "."): values for name, values in channels.items()}
    return recording(
        TIME, {name: (values, units[name.rpartition(".")[2]], "") for name, values in named.items()}
    )


@pytest.mark.parametrize("row", CATALOGUE, ids=lambda row: row.name)
def test_every_row_says_what_it_is(row) -> None:
    assert re.fullmatch(r"[a-z]+(_[a-z]+)*", row.name)
    assert to_si(f"1 {row.unit}" if row.unit != "1" else 1.0, row.unit) == 1.0
    assert set(re.findall("[A-Za-z]+", row.unit)) <= SI
    assert row.label
    assert row.source
    assert row.is_not
    assert row.needs
    assert row.scope in {"motion", "rotation", "comfort", "point", "corner"}


def test_names_are_unique() -> None:
    assert len({row.name for row in CATALOGUE}) == len(CATALOGUE)


def test_accelerations_are_found_by_their_names() -> None:
    run = recorded(
        body__az=WAVE,
        body__ax=0.5 * WAVE,
        front__unsprung__az=9.0 * WAVE,
        body__pitch_acceleration=WAVE,
    )
    found = ride_metrics(run, settling="10 s")
    assert {v.place for v in found.values if v.metric == "rms_acceleration"} == {
        "body.az",
        "body.ax",
        "front.unsprung.az",
    }
    assert {v.place for v in found.values if v.metric == "weighted_rms"} == {"body.az", "body.ax"}
    assert found.value("rms_acceleration", "front.unsprung.az") == pytest.approx(
        9.0 * np.sqrt(0.5), rel=1e-6
    )
    # gains of ISO 8041-1 at 5.0119 Hz: Wk 1.039, Wd 0.4081; here at 5 Hz
    assert found.value("weighted_rms", "body.az") == pytest.approx(1.039 * np.sqrt(0.5), rel=1e-3)
    assert found.value("weighted_rms", "body.ax") == pytest.approx(
        0.409 * 0.5 * np.sqrt(0.5), rel=2e-3
    )
    assert found.value("daily_exposure", "body.ax") == pytest.approx(
        1.4 * found.value("weighted_rms", "body.ax")
    )
    total = np.hypot(found.value("weighted_rms", "body.az"), found.value("weighted_rms", "body.ax"))
    assert found.value("vibration_total_value", "body") == pytest.approx(total)
    assert found.comfort == {"body": comfort.comfort_words(total)}
    # We falls as 1/f
    assert found.value("weighted_rms_angular_acceleration") == pytest.approx(
        0.2 * np.sqrt(0.5), rel=0.05
    )
    assert found.duration == pytest.approx(30.0)


def test_other_weightings_may_be_chosen() -> None:
    run = recorded(body__az=WAVE, seat__az=WAVE)
    found = ride_metrics(run, weighting={"seat.az": "Wd"}, settling=10.0)
    ratio = found.value("weighted_rms", "seat.az") / found.value("weighted_rms", "body.az")
    assert ratio == pytest.approx(0.4081 / 1.039, rel=3e-3)
    slow = ride_metrics(run, weighting={"z": "Wf"}, settling=10.0)
    assert slow.value("weighted_rms", "body.az") < 1e-3
    swell = ride_metrics(recorded(body__az=3.0 * np.sin(2.0 * np.pi * 0.2 * TIME)))
    assert swell.value("msdv_z") > 5.0
    assert swell.value("motion_sickness") == pytest.approx(
        swell.value("msdv_z") / 300.0, rel=1e-12
    )  # annex D.1
    with pytest.raises(jn.DescriptionError, match="unknown weighting 'Wq'"):
        ride_metrics(run, weighting={"z": "Wq"})
    with pytest.raises(jn.DescriptionError, match="unknown channel or axis 'sprung"):
        ride_metrics(run, weighting={"sprung.az": "Wk"})


def test_what_settles_does_not_count_but_is_remembered() -> None:
    shaken = np.where(TIME < 10.0, 5.0 * WAVE, WAVE)
    run = recorded(body__az=shaken)
    assert ride_metrics(run, settling=12.0).value("rms_acceleration") == pytest.approx(
        np.sqrt(0.5), rel=1e-6
    )
    assert ride_metrics(run).value("rms_acceleration") > 1.5
    after = weight(shaken, 1000.0, "Wk")[12_000:]
    assert ride_metrics(run, settling=12.0).value("vdv") == pytest.approx(
        comfort.vdv(after, 1000.0), rel=1e-9
    )


@pytest.mark.parametrize("settling", ["40 s", "41 s", "-1 s"])
def test_nothing_left_is_an_error(settling: str) -> None:
    with pytest.raises(jn.RecordingError, match="no part of the record remains"):
        ride_metrics(recorded(body__az=WAVE), settling=settling)


def corner_run():
    load = 4000.0 + 1000.0 * WAVE
    lifting = np.maximum(4000.0 * (1.0 + 1.5 * WAVE), 0.0)
    deflection = 0.05 + 0.02 * WAVE
    rate = 0.02 * 2.0 * np.pi * 5.0 * np.cos(2.0 * np.pi * 5.0 * TIME)
    return recorded(
        front_left__strut__deflection=deflection,
        front_left__strut__velocity=rate,
        front_left__strut__force=20e3 * deflection + 1500.0 * rate,
        front_left__tyre__force=load,
        rear_right__tyre__force=lifting,
        rear_right__strut__deflection=deflection,
    )


def test_corners_are_found_by_their_names() -> None:
    found = ride_metrics(
        corner_run(),
        travel=("60 mm", "40 mm"),
        stop_gap={"front": "65 mm", "rear_right": ["1 mm", 0.1]},
    )
    here = "front_left"
    assert found.value("dynamic_load_coefficient", here) == pytest.approx(
        0.25 * np.sqrt(0.5), rel=1e-9
    )
    assert found.value("dynamic_load_rms", here) == pytest.approx(1000.0 * np.sqrt(0.5), rel=1e-9)
    assert found.value("minimum_wheel_load", here) == pytest.approx(3000.0)
    assert found.value("adhesion", here) == pytest.approx(0.75)
    assert found.value("lift_off_time", here) == 0.0
    # mean of (1 + c sin)^4 over a period: 1 + 3 c^2 + 3/8 c^4 with c = 0.25
    assert found.value("road_stress_factor", here) == pytest.approx(
        1.0 + 3.0 * 0.25**2 + 0.375 * 0.25**4, rel=1e-9
    )
    assert found.value("travel_rms", here) == pytest.approx(0.02 * np.sqrt(0.5), rel=1e-9)
    assert found.value("travel_peak_to_peak", here) == pytest.approx(0.04)
    assert found.value("travel_utilisation", here) == pytest.approx(0.5)
    assert found.value("travel_utilisation_rms", here) == pytest.approx(
        0.2 * np.sqrt(0.5), rel=1e-9
    )
    assert found.value("travel_utilisation_peak_to_peak", here) == pytest.approx(0.4)
    assert found.value("bump_stop_hits", here) == 200.0
    share = (np.pi - 2.0 * np.arcsin(0.75)) / (2.0 * np.pi)
    assert found.value("bump_stop_time", here) == pytest.approx(
        share, abs=6e-3
    )  # 200 samples a period
    assert found.value("bump_stop_hits", "rear_right") == 0.0
    assert found.value("rebound_stop_hits", "rear_right") == 0.0
    closed = ride_metrics(corner_run(), stop_gap={"front": "45 mm"})  # the mean deflection is 50 mm
    assert closed.value("bump_stop_hits", here) == 201.0  # once a period, and at the start
    power = (
        1500.0 * (0.02 * 2.0 * np.pi * 5.0) ** 2 / 2.0
    )  # the spring's part cancels over whole periods
    assert found.value("dissipated_power", here) == pytest.approx(power, rel=1e-6)
    assert found.value("dissipated_power") == found.value(
        "dissipated_power", here
    )  # the other corner has none
    notes = [one.place for one in found.findings if "dissipated power" in one.message]
    assert notes == [here]
    others = ride_metrics(corner_run(), metrics=["travel_rms"]).findings
    assert not any("dissipated power" in one.message for one in others)
    off = (np.pi - 2.0 * np.arcsin(1.0 / 1.5)) / (2.0 * np.pi)
    assert found.value("lift_off_time", "rear_right") == pytest.approx(off, abs=6e-3)
    assert found.value("adhesion", "rear_right") == 0.0


def test_travel_up_to_the_stops() -> None:
    found = ride_metrics(corner_run(), stop_gap=(0.01, 0.09))
    assert found.value("travel_utilisation", "front_left") == pytest.approx(
        0.5
    )  # 20 mm of 90 - 50 mm
    assert found.value("travel_utilisation_peak_to_peak", "front_left") == pytest.approx(0.4)


def test_a_damper_force_counts_before_that_of_the_strut() -> None:
    run = corner_run()
    name = "front_left.strut.damper_force"
    run[name] = run["front_left.strut.velocity"] * 1000.0
    run[name].attrs = {"units": "N", "long_name": "", "place": "front_left.strut"}
    found = ride_metrics(run)
    assert found.value("dissipated_power", "front_left") == pytest.approx(
        1000.0 * (0.2 * np.pi) ** 2 / 2.0, rel=1e-6
    )
    assert not any("dissipated power" in finding.message for finding in found.findings)


def test_stops_of_the_description() -> None:
    rig = jn.load("kart-quarter-car").with_changes({"strut.bump_stop": {"gap": 0.012, "rate": 2e5}})
    trial = jn.Trial(
        road=jn.HalfSine(height="10 mm", length="60 mm"), speed="1.95 m/s", duration="0.6 s"
    )
    run = jn.simulate(rig, trial)
    found = ride_metrics(run, rig, metrics=["bump_stop_hits"])
    expected = np.count_nonzero(
        np.diff((run["strut.deflection"].to_numpy() > 0.012).astype(int)) == 1
    )
    assert found.value("bump_stop_hits") == expected > 0
    assert len(found.values) == 1


def test_what_is_absent_says_why() -> None:
    found = ride_metrics(recorded(front__strut__deflection=0.05 + 0.02 * WAVE))
    reasons = {(item.metric, item.place): item.reason for item in found.absent}
    assert reasons["weighted_rms", ""] == "no channel ax or ay or az"
    assert reasons["dissipated_power", "front"] == "no channel front.strut.force"
    assert reasons["bump_stop_hits", "front"] == "no bump stop's gap is given"
    assert "nor the gaps of both stops" in reasons["travel_utilisation", "front"]
    assert found.value("travel_rms") == pytest.approx(0.02 * np.sqrt(0.5), rel=1e-9)
    with pytest.raises(jn.RecordingError, match="no channel ax or ay or az"):
        found.value("mtvv")
    with pytest.raises(jn.RecordingError, match="no bump stop's gap is given"):
        found.value("bump_stop_hits")


def test_a_short_record_gives_what_it_can() -> None:
    run = recorded(body__az=WAVE).isel(time=slice(0, 2001))
    found = ride_metrics(run)
    assert found.value("rms_acceleration") == pytest.approx(np.sqrt(0.5), rel=1e-6)
    reason = next(item.reason for item in found.absent if item.metric == "weighted_rms")
    assert reason.startswith(
        "the measurement is too short for Wk; found '2 s'; allowed: 2.5 s or more"
    )
    with pytest.raises(
        jn.RecordingError, match=r"weighted_rms: the metric is not available: .* too short for Wk"
    ):
        ride_metrics(run, metrics=["weighted_rms"])
    just = recorded(body__az=WAVE).isel(time=slice(0, 2501))
    assert ride_metrics(just, metrics=["weighted_rms"]).value("weighted_rms") > 0.5


def test_metrics_may_be_chosen() -> None:
    found = ride_metrics(recorded(body__az=WAVE), metrics=["vdv", "weighted_rms"])
    assert [item.metric for item in found.values] == ["weighted_rms", "vdv"]
    assert found.absent == ()
    with pytest.raises(jn.DescriptionError, match=r"unknown metric 'vdw'.*Did you mean 'vdv'\?"):
        ride_metrics(recorded(body__az=WAVE), metrics=["vdw"])


def test_advice_reaches_the_reader() -> None:
    shock = 0.05 * WAVE + np.where(abs(TIME - 20.0) < 0.01, 30.0, 0.0)
    found = ride_metrics(recorded(body__az=shock), settling=5.0)
    assert any("crest factor" in finding.message for finding in found.findings)
    assert "crest factor" in str(found)


def test_gravity_in_the_signal_is_noticed() -> None:
    run = recorded(body__az=9.81 + WAVE)
    loud = ride_metrics(run)
    assert any("offset of 9.81 m/s^2" in finding.message for finding in loud.findings)
    quiet = ride_metrics(run, start="mean", settling=5.0)
    assert not any("offset" in finding.message for finding in quiet.findings)
    assert quiet.value("weighted_rms") == pytest.approx(1.039 * np.sqrt(0.5), rel=1e-3)
    assert loud.value("mtvv") > 2.0 * quiet.value("mtvv")
    for metric, is_told in (("rms_acceleration", False), ("weighted_rms", True)):
        some = ride_metrics(run, metrics=[metric]).findings
        assert any("offset" in finding.message for finding in some) is is_told


def test_coarse_sampling_is_noticed() -> None:
    found = ride_metrics(recorded(body__az=WAVE).isel(time=slice(None, None, 10)))
    assert any(
        "sampled at 100 Hz: the content that Wk passes above 50 Hz is missing" in f.message
        for f in found.findings
    )
    for rate, is_told in (
        (49.0, False),
        (50.0, True),
        (125.0, True),
        (127.0, False),
    ):  # of 63.1 Hz, the upper limit
        time = np.arange(0.0, 10.0, 1.0 / rate)
        found = ride_metrics(
            recording(time, {"body.az": (np.sin(30.0 * time), "m/s^2", "")})
        ).findings
        assert any("sampled at" in finding.message for finding in found) is is_told, rate
    with_reason = ride_metrics(recorded(body__az=WAVE).isel(time=slice(None, None, 40)))
    assert any("sample rate is too low" in item.reason for item in with_reason.absent)


def test_exposure_is_held_against_the_directive() -> None:
    run = recorded(body__az=WAVE)
    short, long = (ride_metrics(run, exposure=time) for time in ("1 h", "16 h"))
    assert short.value("daily_exposure") == pytest.approx(long.value("daily_exposure") / 4.0)
    (told,) = (f.message for f in long.findings if "A(8)" in f.message)
    assert told.startswith("for 16 h a day A(8) is ")
    assert "above the action value" in told
    assert not any("A(8)" in f.message for f in short.findings)


def test_results_can_be_stored() -> None:
    found = ride_metrics(corner_run())
    plain = to_plain(found)
    assert plain["values"][0].keys() == {"metric", "place", "value", "unit", "label"}
    assert "NaN" not in to_json(found)
    assert "dynamic_load_coefficient" in str(found)


def test_text_has_one_table_for_each_kind_of_place() -> None:
    run = recorded(
        body__az=WAVE,
        front__strut__deflection=0.05 + 0.02 * WAVE,
        rear__strut__deflection=0.02 * WAVE,
    )
    lines = str(ride_metrics(run, settling=10.0)).splitlines()
    assert lines[0] == "Ride metrics of 30 s at 1000 Hz (10 s left out)"
    assert lines[1].split() == ["body.az"]
    assert ["front", "rear"] in [line.split() for line in lines]
    assert ["travel_rms", "m", "0.01414", "0.01414"] in [line.split() for line in lines]
    assert sum("no bump stop's gap is given" in line for line in lines) == 1
    assert "absent: dissipated_power (front, rear): no channel strut.force" in lines


@pytest.mark.parametrize(
    ("options", "text"),
    [
        ({"start": "gravity"}, "unknown start of the record 'gravity'"),
        ({"travel": {"middle": (0.1, 0.1)}}, "unknown corner 'middle'"),
        ({"travel": (0.1, 0.1, 0.1)}, "two values are required"),
        ({"stop_gap": "5 s"}, "wrong unit"),
        ({"settling": "5 m"}, "wrong unit"),
    ],
)
def test_bad_options(options, text: str) -> None:
    with pytest.raises(jn.DescriptionError) as caught:
        ride_metrics(corner_run(), **options)
    assert text in str(caught.value)


def test_bad_recordings() -> None:
    run = recorded(body__az=WAVE)
    with pytest.raises(jn.RecordingError, match="a different unit"):
        ride_metrics(run.assign({"body.az": run["body.az"].assign_attrs(units="g")}))
    with pytest.raises(jn.RecordingError, match="not a finite number"):
        ride_metrics(recorded(body__az=np.where(TIME > 30.0, np.nan, WAVE)))
    uneven = run.assign_coords(time=("time", TIME**1.01, {"units": "s"}))
    with pytest.raises(jn.RecordingError):
        ride_metrics(uneven)


def test_negative_travel_is_a_reason() -> None:
    found = ride_metrics(corner_run(), stop_gap=(0.0, 0.02))
    reasons = {item.reason for item in found.absent if item.metric == "travel_utilisation"}
    assert len(reasons) == 1
    assert (
        "the available travel is not positive; found '0.05 m in rebound, -0.03 m in bump'"
        in reasons.pop()
    )


def test_places_must_be_clear() -> None:
    found = ride_metrics(corner_run())
    with pytest.raises(
        jn.DescriptionError, match="the place is ambiguous; allowed: 'front_left', 'rear_right'"
    ):
        found.value("adhesion")
    with pytest.raises(jn.DescriptionError, match="no value at 'front'"):
        found.value("adhesion", "front")
    with pytest.raises(jn.DescriptionError, match="unknown metric"):
        found.value("adhesions")


def test_a_ride_that_no_vehicle_gives_is_a_problem() -> None:
    """Accelerations of mm/s^2 taken for m/s^2: motion sickness of far more than everybody."""
    time = np.arange(20_000) * 0.01
    heave = 0.9 * np.sin(2.0 * np.pi * 0.2 * time)
    usual = ride_metrics(recording(time, {"sprung.az": (heave, "m/s^2", "")}), settling=0.0)
    assert [found for found in usual.findings if found.severity == "problem"] == []
    wrong = ride_metrics(
        recording(time, {"sprung.az": (1000.0 * heave, "m/s^2", "")}), settling=0.0
    )
    assert wrong.value("motion_sickness") > 3.73
    problems = [found for found in wrong.findings if found.severity == "problem"]
    assert any(
        "no suspension exceeds" in found.message and "mm/s^2" in found.message for found in problems
    )
    assert any(found.code == "ride.sick_people" for found in problems)
    once = usual.value("motion_sickness")
    for share in (0.98, 1.02):
        shaken = ride_metrics(
            recording(time, {"sprung.az": (share / once * heave, "m/s^2", "")}),
            metrics=["motion_sickness"],
        )
        told = [found.value for found in shaken.findings if "of people being sick" in found.message]
        assert told == ([pytest.approx(share)] if share > 1.0 else [])


def test_travel_and_gaps_by_corner() -> None:
    corners = ["front_left", "front_right", "rear_left"]
    given = {"front": "50 mm", "front_right": ("60 mm", None)}
    assert by_corner(given, corners, "travel") == {
        "front_left": (None, 0.05),
        "front_right": (0.06, None),
    }
    assert by_corner(None, corners, "travel") == {}
    assert by_corner(0.04, corners, "travel") == dict.fromkeys(corners, (None, 0.04))
    gaps = {
        "front.rebound_stop.gap": 0.01,
        "front.bump_stop.gap": 0.02,
        "rear.bump_stop.gap": 0.04,
        "rear.track": 1.5,
    }
    car = SimpleNamespace(parameters=lambda: gaps)
    assert gaps_of(car, ["front_left", "rear"]) == {
        "front_left": (0.01, 0.02),
        "rear": (None, 0.04),
    }
    quarter = SimpleNamespace(parameters=lambda: {"strut.bump_stop.gap": 0.03})
    assert gaps_of(quarter, [""]) == {"": (None, 0.03)}
    assert gaps_of(None, corners) == {}


def test_the_side_with_less_room_counts() -> None:
    deflection = np.array([0.03, 0.0, -0.02, 0.0, 0.03]) + 0.05  # mean: 0.0525
    assert peak_use(deflection, 0.04, 0.1) == pytest.approx((0.0525 - 0.03) / 0.04)
    assert peak_use(deflection, 0.1, 0.04) == pytest.approx((0.08 - 0.0525) / 0.04)
    # a bump travel alone does not say how far it may rebound: the stops do
    found = ride_metrics(corner_run(), travel="30 mm", stop_gap=(0.01, 0.09))
    assert found.value("travel_utilisation_peak_to_peak", "front_left") == pytest.approx(0.4)


def test_the_last_two_samples_are_left() -> None:
    found = ride_metrics(recorded(body__az=WAVE), settling=39.9999, metrics=["rms_acceleration"])
    assert found.duration == pytest.approx(1e-3)
    assert ride_metrics(
        recorded(body__az=WAVE), settling=1.0004, metrics=["vdv"]
    ).duration == pytest.approx(38.999)


def test_what_is_chosen_by_default() -> None:
    """Nothing settles, a working day, and a tyre lifts where its load is nought."""
    plain = Choices()
    assert (plain.settling, plain.exposure, plain.lift_off_load) == (0.0, 8.0 * 3600.0, 0.0)
    found = ride_metrics(recorded(tyre__force=4000.0 + 3999.5 * WAVE, body__az=WAVE))
    assert (found.value("lift_off_time"), found.settling) == (0.0, 0.0)
    assert found.value("daily_exposure") == pytest.approx(found.value("weighted_rms"))
    assert found.value("minimum_wheel_load") == pytest.approx(0.5)
