"""Exports of damper dynos under their names, units, signs and header blocks: read, or refused with why."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tests.unit.dampers.dyno_files import INCH, KILO, POUND, peaks, sine, written
from tests.unit.dampers.shim_stack import ShimDamper

import jounce as jn
from jounce.core.errors import FitError
from jounce.dampers.files import common_settings

DAMPER = ShimDamper()
SPEEDS = (0.025, 0.05, 0.1, 0.2, 0.35, 0.5)
LONG, ONCE = sine(DAMPER, 0.25), sine(DAMPER, 0.25, cycles=1)
T, X, V, F = (LONG[key] for key in "txvf")
V_PEAK, BUMP, REBOUND = peaks(DAMPER, SPEEDS, gas=False)
BUMP_GAS, REBOUND_GAS = BUMP + DAMPER.gas, REBOUND + DAMPER.gas
US_HEAD = """Test name,"Front left"
Serial,A-1234
Test date,3/14/2019
Stroke,2.00 in
Gas pressure,150 psi
Clicks,8
Temp,104 F
Valving,"1.35 x 4, 1.2"
"""
DE_HEAD = "Prüfstand\tMTS 850\nDämpfer\tVL\nTemperatur [°C]\t25,0\nGasdruck [bar]\t10\n"


def curve_of(tmp_path: Path, text: str, name: str = "run.csv", **options) -> jn.DamperMap:
    file = tmp_path / name
    file.write_text(text)
    return jn.damper_map([file], **options)


def codes(made: jn.DamperMap) -> set[str]:
    return {item.code.removeprefix("dampers.") for item in made.findings}


def check(made: jn.DamperMap, within: float = 0.02) -> None:
    """Forces of every setting are those of the valves and seals, without gas."""
    assert made.settings
    for item in made.settings:
        damper = DAMPER.with_clicks(item.settings.get("clicks_of_test", 0))
        truth = damper.valves(item.velocity) + damper.friction * np.sign(item.velocity)
        assert np.abs(item.force - truth).max() < within * np.abs(truth).max()


RECORDS = {
    "inches_and_pounds": written(
        [
            ("Time (sec)", T),
            ("Displacement (in)", X / INCH),
            ("Velocity (in/sec)", V / INCH),
            ("Force (lbs)", F / POUND),
            ("Temp (F)", 100.0 + 0.0 * T),
        ],
        head=US_HEAD,
    ),
    "german": written(
        [
            ("Zeit [s]", T),
            ("Weg [mm]", 1e3 * X),
            ("Geschwindigkeit [mm/s]", 1e3 * V),
            ("Kraft [N]", F),
        ],
        mark="\t",
        comma=True,
        head=DE_HEAD,
    ),
    "row_of_units": written(
        [("Time", T), ("Stroke", 1e3 * X), ("Force", F / 10.0)], mark=";", units="s;mm;daN"
    ),
    "tension_in_kilograms": written(
        [("Time [s]", T), ("Position [mm]", -1e3 * X), ("Load [kg]", -F / KILO)]
    ),
    "short_names": written(
        [("Time (s)", T), ("Pos (mm)", 1e3 * X), ("Vel (mm/s)", 1e3 * V), ("Load (N)", F)]
    ),
    "kilonewtons": written(
        [("Time (ms)", 1e3 * T), ("Displacement (mm)", 1e3 * X), ("Force (kN)", F / 1e3)]
    ),
    "absolute_velocity": written(
        [
            ("Time (s)", T),
            ("Displacement (mm)", 1e3 * X),
            ("Velocity abs (mm/s)", 1e3 * np.abs(V)),
            ("Force (N)", F),
        ]
    ),
    "one_load_cell": written(
        [("Time (s)", T), ("Displacement (mm)", 1e3 * X), ("Compression Force (N)", F)]
    ),
    "gas_force_beside": written(
        [
            ("Time (s)", T),
            ("Displacement (in)", X / INCH),
            ("Force (lbs)", F / POUND),
            ("Gas Force (lbs)", 0.0 * F + 33.0),
        ]
    ),
    "command_beside": written(
        [
            ("Time (s)", T),
            ("Command Position (mm)", 1e3 * X + 1.0),
            ("Actual Position (mm)", 1e3 * X),
            ("Force (N)", F),
        ]
    ),
    "no_time": written(
        [("Displacement(mm)", 1e3 * X), ("Velocity(mm/s)", 1e3 * V), ("Force(N)", F)], mark="  "
    ),
    "one_cycle_no_time": written(
        [
            ("Position (in)", ONCE["x"] / INCH),
            ("Velocity (in/s)", ONCE["v"] / INCH),
            ("Force (lbf)", ONCE["f"] / POUND),
        ],
        head=US_HEAD,
    ),
    "one_cycle_no_direction": written(
        [
            ("Displacement (mm)", 1e3 * ONCE["x"]),
            ("Velocity abs (mm/s)", 1e3 * np.abs(ONCE["v"])),
            ("Force (N)", ONCE["f"]),
        ]
    ),
}


@pytest.mark.parametrize("name", RECORDS)
def test_records_and_loops_are_read_by_the_words_and_units_of_their_columns(
    tmp_path: Path, name: str
) -> None:
    made = curve_of(tmp_path, RECORDS[name])
    check(made)
    (run,) = made.runs
    assert (run.motion, run.cycles) == ("sine", 1 if name.startswith("one_cycle") else 3)
    (item,) = made.settings
    assert item.gas_force.has(DAMPER.gas)
    assert ("time_rebuilt" in codes(made)) == ("no_" in name)
    assert ("one_cycle" in codes(made)) == name.startswith("one_cycle")
    assert np.isnan(item.low).all() == name.startswith("one_cycle")
    assert run.peak_velocity == pytest.approx(0.25, rel=0.01)


def test_conditions_are_those_of_columns_then_of_the_header(tmp_path: Path) -> None:
    made = curve_of(tmp_path, RECORDS["inches_and_pounds"], "front_4clicks.csv")
    (item,) = made.settings
    assert item.settings == pytest.approx(
        {"clicks": 8.0, "gas_pressure": 150 * 6894.757, "temperature": 273.15 + 340.0 / 9.0}
    )
    assert "name_differs" in codes(made)
    stated = curve_of(
        tmp_path, RECORDS["inches_and_pounds"], "x.csv", settings={"x.csv": {"clicks": 3}}
    )
    assert stated.settings[0].settings == {"clicks": 3.0}
    (item,) = curve_of(tmp_path, RECORDS["german"], "vl.txt").settings
    assert item.settings == pytest.approx({"temperature": 298.15, "gas_pressure": 1e6})


def test_several_speeds_in_one_file_are_records_of_one_setting(tmp_path: Path) -> None:
    runs = [sine(DAMPER, peak, cycles=1) for peak in (0.05, 0.1, 0.25)]
    x, v, f = (np.concatenate([run[key] for run in runs]) for key in "xvf")
    columns = [("Displacement (mm)", 1e3 * x), ("Velocity (mm/s)", 1e3 * v), ("Force (N)", f)]
    target = ("Test Velocity (mm/s)", np.repeat([50.0, 100.0, 250.0], 400))
    blocks = [
        written(
            [(name, values[k * 400 : (k + 1) * 400]) for name, values in columns], head=f"Speed,{k}"
        )
        for k in range(3)
    ]
    for text in (written([target, *columns]), "\n".join(blocks)):
        made = curve_of(tmp_path, text)
        check(made)
        assert [run.peak_velocity for run in made.runs] == pytest.approx(
            [0.05, 0.1, 0.25], rel=0.01
        )
        assert len({run.file for run in made.runs}) == 3
    table = jn.damper_map([tmp_path / "run.csv"], {"run.csv": {"clicks": 2}})
    assert table.settings[0].settings == {"clicks": 2.0}


PEAKS = {
    "both_positive": written(
        [
            ("Velocity (in/s)", V_PEAK / INCH),
            ("Compression (lbs)", BUMP / POUND),
            ("Rebound (lbs)", -REBOUND / POUND),
        ],
        head=US_HEAD,
    ),
    "rebound_negative": written(
        [
            ("Velocity (in/s)", V_PEAK / INCH),
            ("Comp Force (lbf)", BUMP / POUND),
            ("Reb Force (lbf)", REBOUND / POUND),
        ]
    ),
    "german": written(
        [("v [mm/s]", 1e3 * V_PEAK), ("Druck [N]", BUMP), ("Zug [N]", -REBOUND)],
        mark=";",
        comma=True,
        head="Dämpfer;VR\nGasdruck;12 bar",
    ),
    "a_velocity_for_each_side": written(
        [
            ("Comp Vel (mm/s)", 1e3 * V_PEAK),
            ("Comp Force (N)", BUMP),
            ("Reb Vel (mm/s)", -1e3 * V_PEAK),
            ("Reb Force (N)", REBOUND),
        ]
    ),
    "one_column": written(
        [
            ("Velocity (m/s)", np.r_[-V_PEAK[::-1], V_PEAK]),
            ("Force (kN)", np.r_[REBOUND[::-1], BUMP] / 1e3),
        ]
    ),
    "unsigned": written(
        [("Velocity (mm/s)", 1e3 * np.r_[V_PEAK, V_PEAK]), ("Force (N)", np.r_[BUMP, REBOUND])]
    ),
    "tension_positive": written(
        [("Velocity (mm/s)", 1e3 * V_PEAK), ("Bump (N)", -BUMP), ("Reb (N)", -REBOUND)]
    ),
    "reversed": written(
        [("Velocity (mm/s)", 1e3 * np.r_[V_PEAK, -V_PEAK]), ("Force (N)", -np.r_[BUMP, REBOUND])]
    ),
    "gas_inside": written(
        [
            ("Velocity (in/sec)", V_PEAK / INCH),
            ("Comp (lbs)", BUMP_GAS / POUND),
            ("Reb (lbs)", REBOUND_GAS / POUND),
            ("Gas Force (lbs)", 0.0 * V_PEAK + DAMPER.gas / POUND),
        ]
    ),
    "gas_inside_tension_positive": written(
        [("Velocity (mm/s)", 1e3 * V_PEAK), ("Comp (N)", -BUMP_GAS), ("Reb (N)", -REBOUND_GAS)],
        head=f"Gas force,{DAMPER.gas} N",
    ),
    "gas_at_rest": written(
        [
            ("Velocity (mm/s)", 1e3 * np.r_[0.0, V_PEAK]),
            ("Comp (N)", np.r_[DAMPER.gas, BUMP_GAS]),
            ("Reb (N)", np.r_[DAMPER.gas, REBOUND_GAS]),
        ]
    ),
    "gas_taken_out": written(
        [("Velocity (mm/s)", 1e3 * V_PEAK), ("Comp (N)", BUMP), ("Reb (N)", REBOUND)],
        head=f"Gas force,{DAMPER.gas} N",
    ),
    "target_beside": written(
        [
            ("Target (in/s)", V_PEAK / INCH),
            ("Velocity (in/s)", V_PEAK / INCH),
            ("Comp (lbs)", BUMP / POUND),
            ("Reb (lbs)", -REBOUND / POUND),
        ]
    ),
    "stroke_beside": written(
        [
            ("Stroke (mm)", 50.0 + V_PEAK),
            ("Velocity (mm/s)", 1e3 * V_PEAK),
            ("Comp (N)", BUMP),
            ("Reb (N)", REBOUND),
        ]
    ),
    "both_branches": written(
        [
            ("Velocity (mm/s)", 1e3 * V_PEAK),
            ("Comp Open (N)", 1.05 * BUMP),
            ("Comp Closed (N)", 0.95 * BUMP),
            ("Reb Open (N)", 1.05 * REBOUND),
            ("Reb Closed (N)", 0.95 * REBOUND),
        ]
    ),
}


@pytest.mark.parametrize("name", PEAKS)
def test_tables_of_peak_forces_are_curves_and_say_what_they_do_not_show(
    tmp_path: Path, name: str
) -> None:
    made = curve_of(tmp_path, PEAKS[name])
    check(made)
    (item,) = made.settings
    assert item.velocity == pytest.approx(np.r_[-V_PEAK[::-1], V_PEAK], rel=1e-3)
    assert (made.reading, made.runs) == ("peak", ())
    assert np.isnan([item.friction.value, item.lag.value, item.gas_stiffness.value]).all()
    assert np.isnan(item.low).all()
    said = codes(made)
    assert "peaks_only" in said
    gas = {"gas_inside", "gas_inside_tension_positive", "gas_at_rest", "gas_taken_out"}
    assert ("peaks_gas_unknown" in said) == (name not in gas)
    assert ("peaks_with_gas" in said) == (name in gas - {"gas_taken_out"})
    assert ("peaks_reversed" in said) == (name == "reversed")
    assert ("peaks_by_force" in said) == (name == "unsigned")
    if name in gas:
        assert item.gas_force.value == pytest.approx(DAMPER.gas, rel=1e-3)


def test_stated_signs_exchange_bump_and_rebound_where_only_signs_tell_them(tmp_path: Path) -> None:
    both_ways = 1e3 * np.r_[V_PEAK, V_PEAK]
    text = written([("Velocity (mm/s)", both_ways), ("Force (N)", -np.r_[BUMP, REBOUND])])
    check(curve_of(tmp_path, text, force_positive="tension"))
    both = written(
        [("Velocity (mm/s)", -1e3 * np.r_[V_PEAK, -V_PEAK]), ("Force (N)", -np.r_[BUMP, REBOUND])]
    )
    check(curve_of(tmp_path, both, stroke_positive="extension"))
    check(curve_of(tmp_path, PEAKS["tension_positive"], force_positive="tension"))


def test_repeated_peak_tables_have_intervals_and_clicks_a_map(tmp_path: Path) -> None:
    for clicks in (0, 4, 8):
        for seed in (1, 2, 3):
            v, bump, rebound = peaks(DAMPER.with_clicks(clicks), SPEEDS, gas=False, seed=seed)
            text = written([("Velocity (mm/s)", 1e3 * v), ("Comp (N)", bump), ("Reb (N)", rebound)])
            (tmp_path / f"c{clicks}_{seed}.csv").write_text(text)
    made = jn.damper_map(tmp_path)
    assert made.clicks == (0.0, 4.0, 8.0)
    truths = [
        DAMPER.with_clicks(c).valves(item.velocity) + DAMPER.friction * np.sign(item.velocity)
        for c, item in zip(made.clicks, made.settings, strict=True)
    ]
    inside = [
        (item.low <= truth) & (truth <= item.high)
        for item, truth in zip(made.settings, truths, strict=True)
    ]
    assert np.mean(inside) > 0.85
    assert made.at(2.0).force[0] == pytest.approx(0.5 * (truths[0][0] + truths[1][0]), rel=0.01)
    rig = jn.load("kart-quarter-car").with_changes({"strut.damper": made.damper})
    assert rig.strut.damper.clicks == 4.0


def test_clicks_in_a_column_are_settings_and_a_side_may_have_fewer_rows(tmp_path: Path) -> None:
    rows = ["Clicks,Velocity (mm/s),Comp (N),Reb (N)"]
    for clicks in (0, 4):
        v, bump, rebound = peaks(DAMPER.with_clicks(clicks), SPEEDS, gas=False)
        rows += [f"{clicks},{1e3 * a},{b},{r}" for a, b, r in zip(v, bump, rebound, strict=True)]
    made = curve_of(tmp_path, "\n".join(rows) + "\n")
    assert made.clicks == (0.0, 4.0)
    short = PEAKS["rebound_negative"].rstrip().rpartition(",")[0] + ",\n"
    made = curve_of(tmp_path, short)
    check(made)
    assert len(made.settings[0].velocity) == 11


POSITION = 0.0249 * np.r_[np.linspace(-1.0, 1.0, 200), np.linspace(1.0, -1.0, 200)]
SPEED = 0.25 * np.sqrt(1.0 - (POSITION / 0.025) ** 2) * np.repeat([1.0, -1.0], 200)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        (
            written([("Time (s)", T), ("Displacement (V)", 2.5 + 50.0 * X), ("Force (N)", F)]),
            r"the displacement has no unit, or one of something else; found 'Displacement \[V\]'",
        ),
        (
            written([("Time", T), ("Displacement", X), ("Force", F)]),
            "the (force|displacement) has no unit",
        ),
        (
            written([("Speed", V_PEAK), ("Bump", BUMP), ("Reb", REBOUND)]),
            "force has no unit.*found 'Bump, Reb'",
        ),
        (
            written(
                [
                    ("Crank angle (deg)", ONCE["angle"]),
                    ("Displacement (mm)", ONCE["x"]),
                    ("Force (N)", ONCE["f"]),
                ]
            ),
            "neither time nor velocity",
        ),
        (
            written([("Velocity (mm/s)", 1e3 * ONCE["v"]), ("Force (N)", ONCE["f"])]),
            "a loop of force over velocity without displacement",
        ),
        (
            written(
                [
                    ("Position (mm)", 1e3 * POSITION),
                    ("Velocity (mm/s)", 1e3 * SPEED),
                    ("Force (N)", 900.0 * SPEED),
                ]
            ),
            "the rows are not equally spaced",
        ),
        (
            written(
                [
                    ("Time (s)", T),
                    ("Displacement (mm)", X),
                    ("Comp (N)", np.maximum(F, 0.0)),
                    ("Reb (N)", np.minimum(F, 0.0)),
                ]
            ),
            "the column of the force cannot be told",
        ),
        (
            written(
                [
                    ("Velocity (mm/s)", 1e3 * V_PEAK),
                    ("Comp Max (N)", BUMP),
                    ("Comp Avg (N)", 0.9 * BUMP),
                    ("Reb (N)", REBOUND),
                ]
            ),
            "the column of the force cannot be told; found 'Comp Max",
        ),
        (
            written(
                [("Velocity (mm/s)", 1e3 * V_PEAK), ("Position (V)", V_PEAK), ("Force (N)", BUMP)]
            ),
            "the displacement has no unit",
        ),
    ],
)
def test_what_cannot_be_told_is_refused(tmp_path: Path, text: str, says: str) -> None:
    with pytest.raises(FitError, match=says):
        curve_of(tmp_path, text)


def test_a_loop_without_time_takes_a_stated_sample_time(tmp_path: Path) -> None:
    from jounce.dampers.files import chosen_dyno_files

    file = tmp_path / "angle.csv"
    file.write_text(written([("Displacement (mm)", 1e3 * X), ("Force (N)", F)]))
    check(jn.damper_map(chosen_dyno_files([str(file)], sample_time=float(T[1]))))


def test_peak_tables_give_way_to_records_of_their_setting(tmp_path: Path) -> None:
    (tmp_path / "c2_loop.csv").write_text(RECORDS["short_names"])
    (tmp_path / "c2_peaks.csv").write_text(PEAKS["rebound_negative"])
    made = jn.damper_map(tmp_path)
    assert [item.files for item in made.settings] == [("c2_loop.csv",)]
    assert "peaks_and_records" in codes(made)


def test_a_damper_that_warms_up_stays_at_one_setting(tmp_path: Path) -> None:
    """A channel of the temperature must not make each record a setting of its own."""
    for k, peak in enumerate((0.1, 0.2, 0.4)):
        run = sine(DAMPER, peak)
        temperature = 30.0 + 3.0 * k + 0.01 * np.arange(len(run["t"])) / 100.0
        columns = [
            ("Time (s)", run["t"]),
            ("Displacement (mm)", 1e3 * run["x"]),
            ("Force (N)", run["f"]),
            ("Temp (C)", temperature),
        ]
        (tmp_path / f"run{k}.csv").write_text(written(columns))
    made = jn.damper_map(tmp_path)
    (item,) = made.settings
    assert item.settings["temperature"] == pytest.approx(306.2, abs=0.1)
    assert made.reading == "peak"
    check(made)
    apart = common_settings([{"temperature": 293.15}, {"temperature": 313.15}])
    assert apart[0] != apart[1]


def test_files_of_one_name_in_two_folders_are_both_used(tmp_path: Path) -> None:
    for folder in ("a", "b", "c"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "run.csv").write_text(RECORDS["short_names"])
    assert len(jn.damper_map(tmp_path).runs) == 3


def test_damaged_files_are_a_finding_each(tmp_path: Path) -> None:
    whole = RECORDS["short_names"]
    (tmp_path / "a.csv").write_text(whole)
    (tmp_path / "cut.csv").write_text(whole[: len(whole) // 3 + 7])
    (tmp_path / "head.csv").write_text(whole[:60])
    (tmp_path / "empty.csv").write_text("")
    (tmp_path / "notes.txt").write_text("front damper, 8 clicks, see photos\n")
    (tmp_path / "book.xlsx").write_bytes(b"PK\x03\x04junk")
    made = jn.damper_map(tmp_path)
    check(made)
    left = {Path(item.place).name for item in made.findings if item.code == "dampers.file_left_out"}
    assert left == {"cut.csv", "head.csv", "empty.csv", "notes.txt", "book.xlsx"}


def test_a_run_that_never_becomes_steady_is_named(tmp_path: Path) -> None:
    growing = T / T[-1]
    columns = [("Displacement (mm)", 1e3 * X * growing), ("Force (N)", F * growing)]
    made = curve_of(tmp_path, written([("Time (s)", T), *columns]))
    assert "not_steady" in codes(made)
