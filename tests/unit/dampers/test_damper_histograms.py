"""Histograms from the track: closed forms, what must hold for any record, what noise does, and what is found."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.special import ndtr

import jounce as jn
from jounce.core.errors import DescriptionError, RecordingError
from jounce.dampers.corners import guess_channels
from jounce.dampers.traces import differentiator, velocity_of

CORNERS = ("front_left", "front_right", "rear_left", "rear_right")
RATE = 1000.0


def recorded(
    travels: Mapping[str, np.ndarray], rate: float = RATE, unit: str = "m", **attributes: object
) -> xr.Dataset:
    """Return a record of travels, by corner."""
    count = len(next(iter(travels.values())))
    channels = {
        f"{corner}.damper.travel" if "." not in corner and " " not in corner else corner: (
            travel, unit, "",
        )
        for corner, travel in travels.items()
    }  # fmt: skip
    return jn.recording(np.arange(count) / rate, channels, attributes=attributes)


def wave(
    amplitude: float, frequency: float, seconds: float = 60.0, rate: float = RATE
) -> np.ndarray:
    return amplitude * np.sin(2.0 * np.pi * frequency * np.arange(0.0, seconds, 1.0 / rate))


def rough(seed: int, size: float, seconds: float = 60.0, rate: float = RATE) -> np.ndarray:
    """Return Gaussian travel from 1 to 15 Hz, of an r.m.s. velocity."""
    count = int(seconds * rate)
    frequency = np.fft.rfftfreq(count, 1.0 / rate)
    random = np.random.default_rng(seed)
    spectrum = random.normal(size=(2, frequency.size)) * ((frequency > 1.0) & (frequency < 15.0))
    travel = np.fft.irfft(spectrum[0] + 1j * spectrum[1], count)
    velocity = np.gradient(travel) * rate
    return np.asarray(travel * size / velocity.std())


def zones(made: jn.DamperHistograms, corner: str, section: str = "whole") -> np.ndarray:
    record = made.records[0]
    return made.data["zone_share"].sel(record=record, section=section, corner=corner).to_numpy()


def codes(made: jn.DamperHistograms) -> list[str]:
    return [item.code.removeprefix("dampers.") for item in made.findings]


# closed forms ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("amplitude", "frequency"), [(0.01, 2.0), (0.002, 12.07), (0.03, 0.5)])
def test_a_sine_has_the_shares_of_the_arcsine_law(amplitude: float, frequency: float) -> None:
    made = jn.damper_histograms(recorded({"front_left": wave(amplitude, frequency)}))
    fastest = 2.0 * np.pi * frequency * amplitude
    low = np.arcsin(min(0.025 / fastest, 1.0)) / np.pi
    assert zones(made, "front_left") == pytest.approx([0.5 - low, low, low, 0.5 - low], abs=2e-3)
    travel = made.data["travel_share"].squeeze(("record", "section", "corner"))
    middles = travel["travel"].to_numpy()
    half = 0.5 * float(middles[1] - middles[0])
    law = (
        np.arcsin(np.clip((middles + half) / amplitude, -1.0, 1.0))
        - np.arcsin(np.clip((middles - half) / amplitude, -1.0, 1.0))
    ) / np.pi
    assert travel.to_numpy() == pytest.approx(law, abs=4e-3)


def test_gaussian_motion_has_gaussian_shares_within_their_intervals() -> None:
    """Of 4 corners and 20 roads, 95 % intervals contain the share of low speed that the process has."""
    truth = 2.0 * ndtr(0.025 / 0.05) - 1.0
    inside = []
    for road in range(20):
        travels = {
            name: rough(4 * road + k, 0.05, seconds=40.0, rate=200.0)
            for k, name in enumerate(CORNERS)
        }
        made = jn.damper_histograms(recorded(travels, rate=200.0))
        halves = made.data["zone_share_half"].squeeze("record")
        for corner in CORNERS:
            low = zones(made, corner)[1:3]
            half = halves.sel(corner=corner).to_numpy()[1:3]
            inside += (np.abs(low - 0.5 * truth) < half).tolist()
    assert 0.9 < np.mean(inside) < 0.995


def test_the_velocity_is_that_of_the_travel_up_to_the_passband_without_a_shift() -> None:
    for rate in (100.0, 200.0, 1000.0, 5000.0):
        made = differentiator(rate, min(60.0, 0.4 * rate))
        t = np.arange(4000) / rate
        for share in (0.1, 0.5, 0.95):
            turn = 2.0 * np.pi * share * made.passband
            velocity = velocity_of(0.01 * np.sin(turn * t), made)
            truth = 0.01 * turn * np.cos(turn * t)
            assert np.abs(velocity - truth)[400:-400].max() < 0.0101 * 0.01 * turn


@pytest.mark.parametrize("count", [8, 9, 63, 64, 4095, 4096, 4097, 8193, 20000])
def test_a_ramp_has_its_slope_from_the_first_sample_to_the_last(count: int) -> None:
    velocity = velocity_of(0.2 * np.arange(count) / 500.0 + 7.0, differentiator(500.0, 60.0))
    assert velocity.shape == (count,)
    assert np.abs(velocity - 0.2).max() < (1e-3 if count > 63 else 0.03)


# noise ----------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("rate", [200.0, 1000.0])
def test_the_noise_of_the_velocity_is_that_of_the_formula(rate: float) -> None:
    noise = np.random.default_rng(2).normal(0.0, 1e-4, 200_000)
    made = differentiator(rate, 60.0)
    velocity = velocity_of(noise, made)
    assert velocity.std() == pytest.approx(1e-4 * made.noise_gain, rel=0.01)
    formula = np.sqrt(8.0 * np.pi**2 * made.cutoff**3 / (3.0 * rate))
    assert made.noise_gain == pytest.approx(formula, rel=0.15)  # of an ideal cut-off


@pytest.mark.parametrize("size", [0.03, 0.1])
def test_the_effect_of_noise_is_told_within_a_third(size: float) -> None:
    """What the noise did to the share of low speed, known from the same record without it."""
    clean = rough(3, size, seconds=200.0)
    noisy = clean + np.random.default_rng(4).normal(0.0, 1e-4, clean.size)
    before, after = (
        jn.damper_histograms(recorded({"front_left": travel})) for travel in (clean, noisy)
    )
    done = (zones(after, "front_left") - zones(before, "front_left"))[1:3].sum()
    told = float(after.data["noise_share"].squeeze().sel(zone=["low bump", "low rebound"]).sum())
    assert done < -1e-4
    assert told == pytest.approx(done, rel=0.35)
    assert float(after.data["velocity_noise"].item()) == pytest.approx(
        1e-4 * differentiator(RATE, 60.0).noise_gain, rel=0.1
    )


def test_noise_that_changes_low_speed_is_a_finding_and_a_lower_cutoff_helps() -> None:
    noisy = rough(5, 0.02) + np.random.default_rng(6).normal(0.0, 3e-4, 60_000)
    run = recorded({"front_left": noisy})
    assert "noise_matters" in codes(jn.damper_histograms(run))
    assert "noise_matters" not in codes(jn.damper_histograms(run, cutoff="25 Hz"))


# what must hold for any record ----------------------------------------------------------------------------------------


@settings(max_examples=15, deadline=None)
@given(
    st.integers(0, 10**6),
    st.floats(2e-3, 1.0),
    st.floats(0.01, 0.2),
    st.sampled_from((100.0, 250.0, 1000.0)),
)
def test_shares_sum_to_one_and_a_turned_sensor_swaps_bump_and_rebound(
    seed: int, size: float, low: float, rate: float
) -> None:
    travel = rough(seed, size, seconds=20.0, rate=rate) + 1e-5 * np.random.default_rng(seed).normal(
        size=int(20.0 * rate)
    )
    run = recorded({"front_left": travel, "rear_left": 1.3 * travel}, rate=rate)
    made = jn.damper_histograms(run, low_speed=low)
    turned = jn.damper_histograms(run, low_speed=low, reversed_corners="all")
    for name in ("travel", "velocity", "zone"):
        sums = made.data[f"{name}_share"].sum("zone" if name == "zone" else name)
        assert sums.to_numpy() == pytest.approx(1.0)
    assert zones(made, "rear_left") == pytest.approx(zones(turned, "rear_left")[::-1], abs=2e-3)
    velocity = made.data["velocity_share"].to_numpy()
    assert velocity == pytest.approx(turned.data["velocity_share"].to_numpy()[..., ::-1], abs=5e-3)


def test_zones_and_bins_of_velocity_agree_and_laps_make_up_the_whole() -> None:
    run = recorded({"front_left": rough(7, 0.08)}, beacons=np.array([0.0, 20.0, 40.0, 59.999]))
    made = jn.damper_histograms(run)
    data = made.data.squeeze(("record", "corner"))
    assert made.sections == ["whole", "lap 1", "lap 2", "lap 3"]
    for section in made.sections:
        shares = data["velocity_share"].sel(section=section)
        slow = np.abs(shares["velocity"]) < 0.025
        assert float(shares[slow].sum()) == pytest.approx(
            zones(made, "front_left", section)[1:3].sum()
        )
    laps = data["zone_share"].sel(section=made.sections[1:])
    whole = (laps * data["duration"].sel(section=made.sections[1:])).sum("section") / 60.0
    assert whole.to_numpy() == pytest.approx(zones(made, "front_left"), abs=1e-4)


def test_wheel_travel_is_damper_travel_over_the_motion_ratio() -> None:
    run = recorded({name: rough(k, 0.1) for k, name in enumerate(CORNERS)})
    wheel = jn.damper_histograms(
        run, shown_at="wheel", motion_ratio={"front": 0.5, "rear_left": 0.8}, low_speed=0.05
    )
    damper = jn.damper_histograms(run, low_speed=0.025)
    assert zones(wheel, "front_left") == pytest.approx(zones(damper, "front_left"), abs=1e-5)
    assert wheel.measured_at == {
        "front_left": "wheel", "front_right": "wheel", "rear_left": "wheel", "rear_right": "damper",
    }  # fmt: skip
    assert "no_motion_ratio" in codes(wheel)


def test_balance_is_front_minus_rear() -> None:
    travels = {name: rough(k, 0.05 * (1 + k // 2)) for k, name in enumerate(CORNERS)}
    made = jn.damper_histograms(recorded(travels))
    front, rear = (
        np.mean([zones(made, f"{axle}_{side}") for side in ("left", "right")], axis=0)
        for axle in ("front", "rear")
    )
    assert made.data["balance"].squeeze().to_numpy() == pytest.approx(front - rear)
    assert float(made.data["velocity_ratio"].item()) == pytest.approx(0.5, rel=0.01)


def test_a_model_beside_is_counted_in_the_same_bins() -> None:
    run = recorded({"front_left": rough(1, 0.05)})
    same = jn.damper_histograms(run, beside=run)
    assert same.records == ["recording", "model"]
    assert same.data["velocity_overlap"].to_numpy() == pytest.approx(1.0)
    raised = jn.damper_histograms(run, beside=recorded({"front_left": 0.1 + rough(1, 0.05)}))
    assert raised.data["travel_overlap"].to_numpy() == pytest.approx(1.0, abs=0.05)
    assert "model_shifted" in codes(raised)
    other = jn.damper_histograms(run, beside=recorded({"front_left": rough(2, 0.2)}))
    assert (other.data["velocity_overlap"].sel(record="recording") < 0.6).all()
    with pytest.raises(RecordingError, match="no travel of a damper"):
        jn.damper_histograms(run, beside=recorded({"sprung.z": rough(1, 0.1)}))


# what is found --------------------------------------------------------------------------------------------------------


@pytest.fixture
def travels() -> dict[str, np.ndarray]:
    return {name: 0.03 + rough(k, 0.06) for k, name in enumerate(CORNERS)}


def test_a_clean_record_has_no_warning(travels: dict[str, np.ndarray]) -> None:
    assert codes(jn.damper_histograms(recorded(travels))) == ["no_laps"]


@pytest.mark.parametrize("rate", [100.0, 200.0, 1000.0])
def test_spikes_and_dropouts_are_mended(rate: float) -> None:
    clean = 0.03 + rough(3, 0.06, rate=rate)
    for first, length, size in ((1000, 1, 0.05), (3000, 1, -0.06), (4000, 3, 0.08)):
        spoilt = clean.copy()
        spoilt[first : first + length] += size
        made, truth = (
            jn.damper_histograms(recorded({"front_left": travel}, rate=rate))
            for travel in (spoilt, clean)
        )
        assert "spikes" in codes(made), (first, length, size)
        for name in ("largest_bump_velocity", "largest_travel", "least_travel"):
            difference = abs(float(made.data[name].item()) - float(truth.data[name].item()))
            assert difference < 0.02 * abs(float(truth.data[name].item()))


def test_hard_hits_are_no_spikes() -> None:
    """A damper that is driven at 5 m/s, and one that stops hard."""
    for rate in (200.0, 1000.0):
        t = np.arange(0.0, 20.0, 1.0 / rate)
        hit = 0.05 * np.exp(-(((t - 10.0) / 0.015) ** 2)) + rough(1, 0.05, 20.0, rate)
        made = jn.damper_histograms(recorded({"front": hit}, rate=rate))
        assert codes(made) == ["no_laps"]


def test_channels_that_cannot_be_used_are_one_finding_each(travels: dict[str, np.ndarray]) -> None:
    def found(**changed: np.ndarray) -> list[str]:
        made = jn.damper_histograms(recorded(travels | changed))
        others = [name for name in CORNERS if name not in changed]
        assert set(others) <= set(made.corners)
        return [code for code in codes(made) if code != "no_laps"]

    count = len(travels["front_left"])
    noise = np.random.default_rng(0).normal(0.0, 2e-5, count)
    stuck = travels["front_left"].copy()
    stuck[20_000:30_000] = stuck[20_000]
    jumped = travels["rear_left"] + 0.03 * (np.arange(count) > 40_000)
    holes = travels["front_right"].copy()
    holes[1000:1200] = np.nan
    assert found(front_left=np.full(count, 0.02)) == ["dead"]
    assert found(front_left=0.02 + noise) == ["dead"]
    assert found(front_left=stuck) == ["stuck"]
    assert found(front_left=travels["front_left"] + 0.05) == ["offset"]
    assert found(front_left=1e3 * travels["front_left"]) == ["no_travel_of_suspension"]
    assert found(front_right=holes) == ["gaps"]
    assert set(found(rear_left=jumped)) <= {"level_jumps", "drifts", "offset"}
    assert "level_jumps" in found(rear_left=jumped)
    assert found(rear_left=np.minimum(travels["rear_left"], 0.031)) == ["at_upper_end"]


def test_stretches_without_motion_of_a_channel_do_not_count(travels: dict[str, np.ndarray]) -> None:
    stuck = dict(travels)
    stuck["front_left"] = travels["front_left"].copy()
    stuck["front_left"][20_000:40_000] = 0.03
    made = jn.damper_histograms(recorded(stuck))
    truth = jn.damper_histograms(recorded(travels))
    assert zones(made, "front_left") == pytest.approx(zones(truth, "front_left"), abs=0.02)


def test_a_travel_beyond_the_stroke_is_named(travels: dict[str, np.ndarray]) -> None:
    assert "beyond_stroke" in codes(jn.damper_histograms(recorded(travels), stroke="2 mm"))
    assert "beyond_stroke" not in codes(jn.damper_histograms(recorded(travels), stroke="75 mm"))


def test_velocities_without_sign_are_not_used(travels: dict[str, np.ndarray]) -> None:
    speed = np.abs(np.gradient(travels["front_left"]) * RATE)
    run = recorded(travels)
    beside = run.assign({"front_left.damper.velocity": ("time", speed, {"units": "m/s"})})
    assert "sign_lost_derived" in codes(jn.damper_histograms(beside))
    alone = beside.drop_vars("front_left.damper.travel")
    made = jn.damper_histograms(alone)
    assert "sign_lost" in codes(made)
    assert "front_left" not in made.corners


def test_a_velocity_as_recorded_is_counted(travels: dict[str, np.ndarray]) -> None:
    velocity = np.gradient(travels["front_left"]) * RATE
    run = jn.recording(
        np.arange(velocity.size) / RATE, {"front_left.damper.velocity": (velocity, "m/s", "")}
    )
    made = jn.damper_histograms(run)
    truth = jn.damper_histograms(recorded({"front_left": travels["front_left"]}))
    assert zones(made, "front_left") == pytest.approx(zones(truth, "front_left"), abs=1e-3)
    assert not np.isfinite(made.data["travel_share"].to_numpy()).any()
    assert made.cutoff == {"recording": 0.0}


def test_a_car_that_stands_still_is_named(travels: dict[str, np.ndarray]) -> None:
    noise = np.random.default_rng(1).normal(0.0, 1e-5, 30_000)
    parked = {name: np.concatenate([travel[0] + noise, travel]) for name, travel in travels.items()}
    assert "stands_still" in codes(jn.damper_histograms(recorded(parked)))
    assert "stands_still" not in codes(jn.damper_histograms(recorded(parked), begin="30 s"))


# laps and sectors -----------------------------------------------------------------------------------------------------


def test_laps_of_a_counter_and_sectors_of_distances() -> None:
    count = 100 * 200
    time = np.arange(count) / 200.0
    run = recorded({"front_left": rough(1, 0.05, 100.0, 200.0)}, rate=200.0)
    run = run.assign(
        {
            "Lap Number": ("time", np.floor((time + 10.0) / 30.0), {"units": ""}),
            "body.speed": ("time", np.full(count, 20.0), {"units": "m/s"}),
        }
    )
    made = jn.damper_histograms(run)
    assert made.sections == ["whole", "lap 1", "lap 2"]
    assert made.data["duration"].sel(section="lap 1").item() == pytest.approx(30.0, abs=0.01)
    sectors = jn.damper_histograms(run, division="sectors", sector_ends=["200 m", 500.0])
    assert sectors.sections == ["whole", "sector 1", "sector 2", "sector 3"]
    assert sectors.data["duration"].squeeze().to_numpy() == pytest.approx(
        [100.0, 20.0, 30.0, 10.0], abs=0.05
    )
    without = run.drop_vars("Lap Number")
    assert codes(jn.damper_histograms(without, division="sectors", sector_ends=[200.0])) == [
        "no_sectors"
    ]
    assert codes(jn.damper_histograms(without, division="whole")) == []


def test_sectors_of_a_channel() -> None:
    run = recorded({"front_left": rough(1, 0.05)})
    number = 1.0 + (np.arange(60_000) // 10_000) % 3
    run = run.assign({"Sector": ("time", number, {"units": ""})})
    made = jn.damper_histograms(run, division="sectors")
    assert made.sections == ["whole", "sector 1", "sector 2", "sector 3"]
    assert made.data["duration"].squeeze().to_numpy() == pytest.approx([60.0, 20.0, 20.0, 20.0])


# files and names ------------------------------------------------------------------------------------------------------

NAMES = {
    "logger": ["Damper Pos FL [mm]", "Damper Pos FR [mm]", "Damper Pos RL [mm]", "Damper Pos RR [mm]"],
    "simulator": ["LFshockDefl [m]", "RFshockDefl [m]", "LRshockDefl [m]", "RRshockDefl [m]"],
    "german": ["Federweg VL [mm]", "Federweg VR [mm]", "Federweg HL [mm]", "Federweg HR [mm]"],
    "potentiometers": ["SUSPFL [mm]", "SUSPFR [mm]", "SUSPRL [mm]", "SUSPRR [mm]"],
    "words": [f"{end} {side} Shock Travel [in]" for end in ("Front", "Rear") for side in ("Left", "Right")],
    "jounce": [f"{name}.strut.deflection [m]" for name in CORNERS],
}  # fmt: skip


@pytest.mark.parametrize("names", NAMES.values(), ids=NAMES)
def test_corners_are_guessed_from_the_names_of_loggers(names: list[str], tmp_path: Path) -> None:
    factor = {"mm": 1e3, "m": 1.0, "in": 1.0 / 0.0254}[names[0][names[0].index("[") + 1 : -1]]
    travels = [rough(k, 0.05, 20.0, 200.0) for k in range(4)]
    others = ["Wheel Speed FL [km/h]", "Brake Press FL [bar]", "Damper Temp FL [C]", "Steer Pot [V]"]  # fmt: skip
    columns = [np.arange(4000) / 200.0, *(factor * x for x in travels), *([np.ones(4000)] * 4)]
    file = tmp_path / "outing.csv"
    header = ",".join(["time [s]", *names, *others])
    np.savetxt(file, np.column_stack(columns), "%.9g", ",", header=header, comments="")
    made = jn.damper_histograms(file, division="whole")
    assert tuple(made.corners) == CORNERS
    truth = jn.damper_histograms(
        recorded(dict(zip(CORNERS, travels, strict=True)), rate=200.0), division="whole"
    )
    for corner in CORNERS:
        assert zones(made, corner) == pytest.approx(zones(truth, corner), abs=1e-3)
    assert ("channels_guessed" in codes(made)) == (names != NAMES["jounce"])


def test_names_of_other_channels_are_no_corners() -> None:
    others = [
        ("Wheel Speed FL", "km/h"), ("Tyre Temp FL", "C"), ("Damper Force FL", "N"), ("Ride Height FL", "mm"),
        ("Brake Pos", "mm"), ("Throttle Pot", "mm"), ("front_left.tyre.deflection", "m"), ("sprung.z", "m"),
    ]  # fmt: skip
    assert [
        match.column for match in guess_channels(others).values() if match.corner != "damper"
    ] == []


def test_volts_and_missing_units_are_findings_and_the_other_corners_are_used(
    tmp_path: Path,
) -> None:
    travels = [1e3 * rough(k, 0.05, 20.0, 200.0) for k in range(4)]
    file = tmp_path / "outing.csv"
    header = "time [s],Damper FL [mm],Damper FR [V],Damper RL,Damper RR [mm],Lap [-]"
    table = np.column_stack([np.arange(4000) / 200.0, *travels, np.arange(4000) // 1000])
    np.savetxt(file, table, "%.6g", ",", header=header, comments="")
    made = jn.damper_histograms(file)
    assert made.corners == ["front_left", "rear_right"]
    assert made.sections == ["whole", "lap 1", "lap 2"]
    assert {"not_calibrated", "lacks_unit", "channels_guessed"} <= set(codes(made))
    named = jn.damper_histograms(file, channels={"RL": "Damper RL [mm]"})
    assert named.corners == ["front_left", "rear_left", "rear_right"]
    assert "lacks_unit" not in codes(named)


def test_sensors_calibrate_columns_in_volts(tmp_path: Path) -> None:
    travel = 0.03 + rough(1, 0.05, 20.0, 200.0)
    volts = 0.5 + 40.0 * travel
    file, sensors = tmp_path / "outing.csv", tmp_path / "sensors.toml"
    table = np.column_stack([np.arange(4000) / 200.0, volts])
    np.savetxt(file, table, "%.9g", ",", header="time [s],Damper FL [V]", comments="")
    sensors.write_text(
        'schema = "jounce.sensors/1"\n[sensors."front_left.damper.travel"]\ncolumn = "Damper FL"\n'
        'sensitivity = "40 mV/mm"\nzero = "0.5 V"\n'
    )
    made = jn.damper_histograms(file, sensors=sensors, division="whole")
    assert made.corners == ["front_left"]
    assert float(made.data["mean_travel"].item()) == pytest.approx(0.03, abs=1e-3)
    assert "not_calibrated" not in codes(made)


def test_one_bad_file_is_a_finding_and_none_good_is_an_error(tmp_path: Path) -> None:
    good, bad = tmp_path / "good.csv", tmp_path / "bad.csv"
    jn.write_recording(recorded({"front_left": rough(1, 0.05, 5.0)}), good)
    bad.write_text("time [s],speed [m/s]\n" + "\n".join(f"{k},1" for k in range(20)))
    made = jn.damper_histograms([str(good), str(bad)])
    assert (made.records, "file_left_out" in codes(made)) == (["good.csv"], True)
    with pytest.raises(RecordingError, match="no travel of a damper"):
        jn.damper_histograms(str(bad))
    for wrong in ({"records": [good, "lost.csv"]}, {"records": good, "beside": "lost.nc"}):
        with pytest.raises(RecordingError, match="no such file"):
            jn.damper_histograms(**wrong)
    both = jn.damper_histograms([str(good), str(good)])
    assert both.records == ["good.csv", "good.csv (2)"]


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"division": "turns"}, "division"),
        ({"low_speed": "20 m/s"}, "no damper is that fast"),
        ({"channels": {"middle": "x"}}, "corner"),
        ({"motion_ratio": {"front": -1.0}}, "motion_ratio"),
        ({"sector_ends": [500.0, 200.0]}, "ascend"),
        ({"reversed_corners": ["boot"]}, "corner"),
        ({"cutoff": 0.0}, "cutoff"),
        ({"begin": "900 s"}, "too few samples"),
    ],
)
def test_wrong_options_are_refused_in_one_message(options: dict[str, object], words: str) -> None:
    run = recorded({"front_left": rough(1, 0.05, 5.0)})
    with pytest.raises((DescriptionError, RecordingError)) as caught:
        jn.damper_histograms(run, **options)
    assert words in str(caught.value)


def test_the_table_has_all_shares_and_plain_data_all_quantities() -> None:
    made = jn.damper_histograms(recorded({name: rough(k, 0.05) for k, name in enumerate(CORNERS)}))
    rows = [line.split(",") for line in made.table().splitlines()[1:]]
    for quantity in ("travel [m]", "velocity [m/s]"):
        shares = [float(row[-1]) for row in rows if row[2] == "rear_left" and row[3] == quantity]
        assert sum(shares) == pytest.approx(1.0)
    plain = made.to_dict()
    assert plain["zone_share"]["dimensions"] == ["record", "section", "corner", "zone"]
    assert plain["velocity"]["units"] == "m/s"
    assert plain["findings"][0]["code"] == "dampers.no_laps"
