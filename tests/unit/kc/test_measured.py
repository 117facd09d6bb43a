"""Measured K&C sheets from synthetic files: every column, sign and unit comes back, and every mistake is a finding."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import scipy.io

import jounce as jn
from jounce.core.errors import DescriptionError, RecordingError
from jounce.core.findings import findings_of
from jounce.core.workbooks import workbook_of

TESTS = ("bounce", "roll", "steer", "lateral-in-phase", "lateral-opposed")
SERIOUS = ("warning", "problem")


def codes(sheet: jn.KcSheet, *, serious: bool = True) -> set[str]:
    return {item.code for item in sheet.findings if not serious or item.severity in SERIOUS}


def assert_equal_sheets(sheet: jn.KcSheet, other: jn.KcSheet) -> None:
    assert list(sheet) == list(other)
    for name, test in sheet.items():
        np.testing.assert_allclose(test["input"], other[name]["input"], atol=1e-12)
        assert set(test.data_vars) == set(other[name].data_vars)
        for quantity in test.data_vars:
            np.testing.assert_allclose(
                test[quantity], other[name][quantity], atol=1e-8, err_msg=quantity
            )


# --- layout


def test_a_sheet_has_names_units_and_signs_of_jounce(rig: Any) -> None:
    sheet = jn.read_kc([rig.write_test(test) for test in TESTS], convention="iso")
    assert list(sheet) == list(TESTS)
    assert codes(sheet) == set()
    bounce = sheet["bounce"]
    assert bounce["input"].attrs["units"] == "m"
    assert bounce["left.toe"].attrs["units"] == "rad"
    assert float(bounce["input"].max()) == pytest.approx(0.05)
    slopes = jn.kc_slopes(bounce)["slope"]
    assert float(slopes.sel(quantity="left.toe")) == pytest.approx(rig.TOE, rel=1e-6)
    assert float(slopes.sel(quantity="left.steer")) == pytest.approx(-rig.TOE, rel=1e-6)
    assert float(slopes.sel(quantity="right.wheel_centre_y")) == pytest.approx(
        -0.9 * rig.SCRUB, rel=1e-6
    )
    assert float(slopes.sel(quantity="right.vertical_force")) == pytest.approx(rig.RATE, rel=1e-6)
    assert float(bounce["left.toe"].sel(sample=0)) == pytest.approx(0.002)  # angles stay totals
    opposed = jn.kc_slopes(sheet["lateral-opposed"])["slope"]
    assert float(opposed.sel(quantity="right.camber")) == pytest.approx(rig.LEAN, rel=1e-6)
    assert float(opposed.sel(quantity="right.contact_point_y")) == pytest.approx(
        -rig.GIVE, rel=1e-6
    )
    steer = sheet["steer"]
    assert float(jn.kc_slopes(steer)["slope"].sel(quantity="right.steer")) == pytest.approx(
        1 / 0.14
    )
    assert sheet["roll"]["input"].attrs["units"] == "rad"


@pytest.mark.parametrize("convention", ["j670e", "adams-car"])
def test_a_sheet_in_other_axes_is_the_same(rig: Any, tmp_path: Path, convention: str) -> None:
    """The same axle, written with axes turned by hand."""
    plain = jn.read_kc([rig.write_test(test) for test in TESTS], convention="iso")
    turned = {
        "j670e": ("WC Y", "WC Z", "Contact Patch Y", "Contact Patch Z", "Fz", "Fy", "Rack"),
        "adams-car": ("WC Y", "Contact Patch Y", "Fy", "Rack", "Roll"),
    }[convention]

    def turn(sheet: dict[str, np.ndarray]) -> None:
        for heading, values in sheet.items():
            if heading.startswith(turned):
                sheet[heading] = -values

    files = [rig.write_test(test, turn) for test in TESTS]
    sheet = jn.read_kc(files, convention=convention)
    assert_equal_sheets(plain, sheet)
    assert codes(sheet) == set()


def test_a_sheet_of_the_mirrored_axle_is_mirrored(rig: Any) -> None:
    """Left and right exchanged with y reversed: a symmetric axle reads the same in bounce."""
    plain = jn.read_kc(rig.write_test("bounce"), convention="iso")["bounce"]

    def mirror(sheet: dict[str, np.ndarray]) -> None:
        for heading in [name for name in sheet if " L " in name]:
            other = heading.replace(" L ", " R ")
            sign = -1.0 if " Y " in heading or heading.startswith("Fy") else 1.0
            sheet[heading], sheet[other] = sign * sheet[other], sign * sheet[heading]

    mirrored = jn.read_kc(rig.write_test("bounce", mirror), convention="iso")["bounce"]
    for name in plain.data_vars:
        np.testing.assert_allclose(plain[name], mirrored[name], atol=1e-12)


def test_a_convention_may_be_given_by_its_directions_or_in_the_file(rig: Any) -> None:
    def turn(sheet: dict[str, np.ndarray]) -> None:
        for heading, values in sheet.items():
            if heading.startswith(("Fy", "Fz")):
                sheet[heading] = -values

    plain = jn.read_kc(rig.write_test("lateral-opposed"), convention="iso")
    on_road = jn.read_kc(
        rig.write_test("lateral-opposed", turn), convention={"forces": "tyre-on-road"}
    )
    assert_equal_sheets(plain, on_road)

    def down(sheet: dict[str, np.ndarray]) -> None:
        for heading, values in sheet.items():
            if heading.startswith(("WC", "Contact", "F")):
                sheet[heading] = -values

    stated = jn.read_kc(rig.write_test("lateral-opposed", down, above="Rig 3, axes to SAE J670e\n"))
    assert_equal_sheets(plain, stated)
    assert "kc.convention_assumed" not in codes(stated, serious=False)
    silent = jn.read_kc(rig.write_test("lateral-opposed"))
    assert "kc.convention_assumed" in codes(silent, serious=False)


# --- files


def test_one_text_file_may_have_all_tests(rig: Any) -> None:
    apart = jn.read_kc([rig.write_test(test) for test in TESTS], convention="iso")
    text = "Axle 7, rig 3\n\n" + "\n".join(
        f"Test: {test}\n" + (rig.folder / f"{test}.csv").read_text() for test in TESTS
    )
    file = rig.folder / "all.txt"
    file.write_text(text)
    together = jn.read_kc(file, convention="iso")
    assert_equal_sheets(apart, together)


def test_an_error_in_a_section_names_its_line_and_stops_no_other(rig: Any) -> None:
    lines = ["Test: bounce", "Travel L [mm];Toe L [deg]", "-10;0.1", "0;0", "10;-0.1", "",
             "Test: roll", "Toe L [deg];Toe R [deg]", "1;1", "2;2", "Test: steer",
             "Rack Travel [mm];Toe L [deg];Toe R [deg]", "-10;2;-2", "0;0;0", "10;x;2"]  # fmt: skip
    file = rig.folder / "all.csv"
    file.write_text("\n".join(lines) + "\n")
    sheet = jn.read_kc(file, convention="iso")
    assert list(sheet) == ["bounce", "steer"]
    problems = [item for item in sheet.findings if item.severity == "problem"]
    assert [item.code for item in problems] == ["kc.unread", "kc.column_left_out"]
    assert "no column with the input of this test" in problems[0].message
    assert "line 15" in problems[1].message


def test_a_workbook_has_a_test_on_each_sheet(rig: Any) -> None:
    apart = jn.read_kc([rig.write_test(test) for test in TESTS], convention="iso")
    sheets = {
        test: [list(rig.columns(test)), *np.column_stack([*rig.columns(test).values()]).tolist()]
        for test in TESTS
    }
    file = rig.folder / "rig.xlsx"
    file.write_bytes(workbook_of(sheets | {"Notes": [["made by hand"]]}))
    assert_equal_sheets(apart, jn.read_kc(file, convention="iso"))


def test_a_matlab_file_has_a_struct_for_each_test(rig: Any) -> None:
    plain = jn.read_kc([rig.write_test("bounce"), rig.write_test("roll")], convention="iso")
    named = {
        test: {
            heading.replace(" [", "_").rstrip("]").replace(" ", "_"): values
            for heading, values in rig.columns(test).items()
        }
        for test in ("bounce", "roll")
    }
    file = rig.folder / "rig.mat"
    scipy.io.savemat(file, named)
    sheet = jn.read_kc(file, convention="iso")
    assert_equal_sheets(plain, sheet)


def test_what_cannot_be_read_at_all_is_an_error(rig: Any) -> None:
    empty = rig.folder / "empty.csv"
    empty.write_text("")
    with pytest.raises(RecordingError, match="the file is empty"):
        jn.read_kc(empty)
    with pytest.raises(RecordingError, match="no test is recognised"):
        jn.read_kc(rig.write("a.csv", {"Toe L [deg]": [1.0, 2.0, 3.0], "AUX": [1.0, 2.0, 3.0]}))
    with pytest.raises(RecordingError, match="does not move"):
        jn.read_kc(rig.write("bounce.csv", {"Travel [mm]": [1.0, 1.0], "toe [deg]": [1.0, 2.0]}))
    with pytest.raises(RecordingError, match=r"missing\.csv"):
        jn.read_kc(rig.folder / "missing.csv")
    with pytest.raises(RecordingError, match="the columns of two axles"):
        jn.read_kc(
            rig.write("bounce.csv", {"LF_Travel (mm)": [1.0, 2.0], "LR_Travel (mm)": [1.0, 2.0]})
        )


def test_one_axle_of_two_is_chosen(rig: Any) -> None:
    both = {"LF_Travel (mm)": [-1.0, 0.0, 9.0], "LR_Travel (mm)": [-2.0, 0.0, 5.0]}
    file = rig.write("bounce.csv", both)
    assert float(jn.read_kc(file, axle="rear")["bounce"]["input"].max()) == pytest.approx(0.005)


# --- channel maps


def test_a_map_reads_any_headings(rig: Any, tmp_path: Path) -> None:
    plain = jn.read_kc(rig.write_test("lateral-opposed"), convention="iso")
    known = rig.columns("lateral-opposed")
    odd = {f"ch{i}": values for i, values in enumerate(known.values())}
    odd["ch0"] = (
        2.5 - 60.0 * odd["ch0"]
    )  # toe of the left wheel in minutes of arc, reversed, with an offset
    file = rig.write("Run 07.csv", odd)
    text = ['schema = "jounce.kc-map/1"', 'convention = "iso"', "[tests]",
            '"Run 07" = "lateral-opposed"', "[columns]"]  # fmt: skip
    names = {"Toe": "toe", "Camber": "camber", "WC Y": "wheel_centre_y", "WC Z": "wheel_centre_z",
             "Contact Patch Y": "contact_point_y", "Contact Patch Z": "contact_point_z",
             "Fz": "vertical_force", "Fy": "lateral_force"}  # fmt: skip
    for i, heading in enumerate(known):
        name, _, unit = heading.partition(" [")
        wheel = {"L": "left", "R": "right"}[name[-1]]
        text.append(f'ch{i} = "{wheel}.{names[name[:-2]]} [{unit[:-1]}]"')
    text[5] = 'ch0 = {quantity = "toe", wheel = "left", unit = "arcmin", sign = -1, offset = 2.5}'
    map_file = tmp_path / "rig.toml"
    map_file.write_text("\n".join(text) + "\n")
    sheet = jn.read_kc(file, map_file)
    assert_equal_sheets(plain, sheet)
    assert codes(sheet, serious=False) <= {"kc.no_zero"}


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('[columns]\nch0 = "left.tow [deg]"', "unknown quantity"),
        ('[columns]\nch0 = "left.rack_travel [mm]"', "belongs to no wheel"),
        ('[tests]\na = "bouncing"', "unknown test"),
        ('convention = "din"', "unknown convention"),
        ('[columns]\nch0 = "?"', "not a column"),
        ("speed = 3", "speed"),
    ],
)
def test_wrong_maps_are_refused_with_their_line(tmp_path: Path, text: str, message: str) -> None:
    file = tmp_path / "rig.toml"
    file.write_text(f'schema = "jounce.kc-map/1"\n{text}\n')
    with pytest.raises(DescriptionError, match=message) as error:
        jn.read_kc(tmp_path / "a.csv", file)
    assert "rig.toml" in str(error.value)


def test_a_proposed_map_reads_its_file_and_names_what_it_did_not_recognise(
    rig: Any, tmp_path: Path
) -> None:
    file = rig.write_test("roll", lambda sheet: sheet.update(AUX=sheet["Fy L [N]"]))
    proposal = jn.kc_map(file)
    assert proposal.unrecognised == ("AUX",)
    assert proposal.map.tests == {"roll": "roll"}
    saved = tmp_path / "map.toml"
    saved.write_text(proposal.to_toml())
    assert '# "AUX" = ""' in saved.read_text()
    assert_equal_sheets(jn.read_kc(file), jn.read_kc(file, saved))
    assert "kc.not_recognised" in codes(jn.read_kc(file), serious=False)


def test_units_that_no_heading_has_are_assumed_and_named(rig: Any) -> None:
    file = rig.write("bounce.csv", {"travel": [-20.0, 0.0, 20.0], "camber": [0.5, 0.0, -0.5]})
    sheet = jn.read_kc(file)
    assert codes(sheet) == {"kc.unit_assumed"}
    message = next(item.message for item in sheet.findings if item.code == "kc.unit_assumed")
    assert "travel [mm], camber [deg]" in message
    assert float(sheet["bounce"]["left.camber"][0]) == pytest.approx(np.radians(0.5))


# --- a workshop


def test_ten_rows_of_dial_gauges_are_the_bounce_test_of_a_wheel(rig: Any) -> None:
    travel = np.linspace(-30.0, 30.0, 10)
    toe = 0.002 + rig.TOE * 1e-3 * travel
    base = 400.0
    gauges = {
        "travel [mm]": travel,
        "toe front gauge [mm]": 3.0 - base / 2 * np.tan(toe),
        "toe rear gauge [mm]": 3.0 + base / 2 * np.tan(toe),
        "gauge base [mm]": np.full(10, base),
    }
    sheet = jn.read_kc(rig.write("front right corner.csv", gauges))
    assert list(sheet) == ["bounce"]
    np.testing.assert_allclose(sheet["bounce"]["right.toe"], toe, atol=1e-9)
    slope = jn.kc_slopes(sheet["bounce"])["slope"].sel(quantity="right.toe")
    assert float(slope) == pytest.approx(rig.TOE, rel=1e-6)
    assert codes(sheet) == set()
    del gauges["gauge base [mm]"]
    file = rig.write("front right corner.csv", gauges)
    assert "kc.column_left_out" in codes(jn.read_kc(file))
    stated = jn.read_kc(file, jn.KcMap(gauge_base="400 mm"))
    np.testing.assert_allclose(stated["bounce"]["right.toe"], toe, atol=1e-9)


def test_toe_as_a_distance_over_the_rim_is_an_angle(rig: Any) -> None:
    file = rig.write(
        "left.csv",
        {
            "travel [mm]": [-20, 0, 20],
            "toe [mm]": [1.0, 0.0, -1.0],
            "rim diameter [mm]": [400.0] * 3,
        },
    )
    toe = jn.read_kc(file)["bounce"]["left.toe"]
    np.testing.assert_allclose(toe, [0.0025, 0.0, -0.0025], rtol=1e-5)


def test_a_blank_reading_is_a_gap(rig: Any) -> None:
    file = rig.folder / "left.csv"
    file.write_text("travel [mm];toe [deg];camber [deg]\n-20;0.1;1\n0;;0\n20;-0.1;-1\n40;-0.2;-2\n")
    test = jn.read_kc(file)["bounce"]
    assert np.isnan(test["left.toe"].values).tolist() == [False, True, False, False]
    assert float(jn.kc_slopes(test)["slope"].sel(quantity="left.toe")) == pytest.approx(
        np.radians(-5.0), rel=1e-6
    )


# --- zeros, loops, drift


def test_movements_are_zeroed_where_the_input_is_zero(rig: Any) -> None:
    def shift(sheet: dict[str, np.ndarray]) -> None:
        sheet["WC Y L [mm]"] = sheet["WC Y L [mm]"] + 712.0

    sheet = jn.read_kc(rig.write_test("lateral-opposed", shift), convention="iso")
    moved = sheet["lateral-opposed"]["left.wheel_centre_y"]
    assert moved.attrs["zero"] == pytest.approx(0.712)
    assert float(moved[0]) == pytest.approx(0.0, abs=1e-12)


def test_heights_above_the_floor_are_zeroed_at_the_first_sample_and_said(rig: Any) -> None:
    def lift(sheet: dict[str, np.ndarray]) -> None:
        for heading, values in sheet.items():
            if " Z " in heading:
                sheet[heading] = values + 300.0

    sheet = jn.read_kc(rig.write_test("bounce", lift), convention="iso")
    assert codes(sheet) == {"kc.height_zeroed"}
    assert float(sheet["bounce"]["input"][0]) == 0.0
    np.testing.assert_allclose(
        sheet["bounce"]["left.contact_point_z"], sheet["bounce"]["input"], atol=1e-12
    )


def test_drift_between_cycles_is_removed_and_named(rig: Any) -> None:
    u = rig.loop(2000.0, 3, 40)
    clean = rig.columns("lateral-opposed", u)
    drifting = dict(clean)
    drifting["Toe L [deg]"] = clean["Toe L [deg]"] + np.linspace(0.0, 0.05, u.size)
    first, second = (
        jn.read_kc(rig.write("lateral-opposed.csv", sheet), convention="iso")
        for sheet in (clean, drifting)
    )
    assert "kc.drift_removed" not in codes(first, serious=False)
    assert "kc.drift_removed" in codes(second, serious=False)
    toe = second["lateral-opposed"]["left.toe"]
    assert toe.attrs["drift"] == pytest.approx(np.radians(0.05) / (u.size - 1), rel=1e-6)
    np.testing.assert_allclose(toe, first["lateral-opposed"]["left.toe"], atol=1e-9)


def test_hysteresis_is_measured_and_named(rig: Any) -> None:
    u = rig.loop(2000.0, 2, 20)
    sheet = rig.columns("lateral-opposed", u)
    rising = np.gradient(u) > 0.0
    sheet["Toe L [deg]"] = sheet["Toe L [deg]"] + np.where(rising, -0.004, 0.004)
    read = jn.read_kc(rig.write("lateral-opposed.csv", sheet), convention="iso")
    test = read["lateral-opposed"]
    assert test["left.toe"].attrs["hysteresis"] == pytest.approx(np.radians(0.008), rel=0.01)
    assert "kc.hysteresis" in codes(read, serious=False)
    assert set(test["direction"].values.tolist()) == {1, -1}


def test_noise_of_readings_is_an_attribute(rig: Any) -> None:
    u = rig.loop(2000.0, 2, 200)
    sheet = rig.columns("lateral-opposed", u)
    random = np.random.default_rng(3)
    sheet["Toe L [deg]"] = sheet["Toe L [deg]"] + random.normal(0.0, 0.002, u.size)
    test = jn.read_kc(rig.write("lateral-opposed.csv", sheet), convention="iso")["lateral-opposed"]
    assert test["left.toe"].attrs["noise"] == pytest.approx(np.radians(0.002), rel=0.1)


# --- mistakes


def reverse(*headings: str) -> Any:
    def change(sheet: dict[str, np.ndarray]) -> None:
        for heading in headings:
            sheet[heading] = -sheet[heading]

    return change


def scale(factor: float, start: str) -> Any:
    def change(sheet: dict[str, np.ndarray]) -> None:
        for heading, values in sheet.items():
            if heading.startswith(start):
                sheet[heading] = factor * values

    return change


def exchange(*starts: str) -> Any:
    def change(sheet: dict[str, np.ndarray]) -> None:
        for start in starts:
            left, right = (next(h for h in sheet if h.startswith(f"{start} {s}")) for s in "LR")
            sheet[left], sheet[right] = sheet[right], sheet[left]

    return change


def double(sheet: dict[str, np.ndarray]) -> None:
    sheet["Camber R [deg]"] = sheet["Toe R [deg]"]


@pytest.mark.parametrize(
    ("test", "change", "code"),
    [
        ("lateral-in-phase", reverse("Fy L [N]", "Fy R [N]"), "kc.against_force"),
        ("lateral-opposed", reverse("Contact Patch Y L [mm]"), "kc.against_force"),
        ("bounce", reverse("Camber R [deg]"), "kc.not_mirrored"),
        ("bounce", reverse("WC Y R [mm]"), "kc.not_mirrored"),
        ("roll", reverse("Camber L [deg]"), "kc.not_mirrored"),
        ("bounce", reverse("Fz L [N]", "Fz R [N]"), "kc.load_negative"),
        ("bounce", reverse("Contact Patch Z L [mm]", "Contact Patch Z R [mm]"), "kc.load_falls"),
        ("roll", exchange("Fz"), "kc.wheels_exchanged"),
        ("lateral-opposed", scale(1e-3, "F"), "kc.load_too_small"),
        ("lateral-opposed", scale(1e3, "Fy"), "kc.too_large"),
        ("bounce", scale(1e3, "Contact Patch Z"), "kc.too_large"),
        ("bounce", scale(1e-3, "Contact Patch Z"), "kc.input_too_small"),
        ("steer", scale(180.0 / np.pi, "Toe"), "kc.too_large"),
        ("bounce", scale(180.0 / np.pi, "Camber"), "kc.too_large"),
        ("lateral-opposed", scale(180.0 / np.pi, "Camber"), "kc.turns_too_far"),
        ("steer", scale(6.0, "Rack"), "kc.handwheel_as_rack"),
        ("bounce", double, "kc.doubled"),
    ],
)
def test_a_mistake_is_one_finding(rig: Any, test: str, change: Any, code: str) -> None:
    assert codes(jn.read_kc(rig.write_test(test), convention="iso")) == set()
    sheet = jn.read_kc(rig.write_test(test, change), convention="iso")
    assert code in codes(sheet)
    assert code in {item.code for item in findings_of(sheet[test].attrs)}
    for item in sheet.findings:
        assert item.sentence("de") != item.message


def test_wheels_exchanged_in_roll_contradict_bounce(rig: Any) -> None:
    bounce = rig.write_test("bounce")
    files = [bounce, rig.write_test("roll", exchange("Toe", "Camber"))]
    sheet = jn.read_kc(files, convention="iso")
    found = [item for item in sheet.findings if item.code == "kc.wheels_exchanged"]
    assert [item.numbers["columns"] for item in found] == [
        ["left.toe", "right.toe"],
        ["left.camber", "right.camber"],
    ]
    assert codes(jn.read_kc([bounce, rig.write_test("roll")], convention="iso")) == set()


def test_a_roll_angle_of_the_body_is_turned_and_said(rig: Any) -> None:
    sheet = jn.read_kc(rig.write_test("roll", reverse("Roll Angle [deg]")), convention="iso")
    assert "kc.roll_of_body" in codes(sheet, serious=False)
    assert float(sheet["roll"]["input"][5]) > 0.0
    assert float(sheet["roll"]["left.wheel_centre_z"][5]) > 0.0


def test_roll_without_an_angle_needs_the_track(rig: Any) -> None:
    file = rig.write_test("roll", lambda sheet: sheet.pop("Roll Angle [deg]"))
    with pytest.raises(RecordingError, match="needs the track"):
        jn.read_kc(file, convention="iso")
    sheet = jn.read_kc(file, convention="iso", track="1.5 m")
    assert float(sheet["roll"]["input"].max()) == pytest.approx(np.arctan(0.05), rel=1e-9)


def test_an_angle_in_the_column_of_the_rack_is_refused(rig: Any) -> None:
    sheet = rig.columns("steer")
    sheet["Rack Travel [deg]"] = sheet.pop("Rack Travel [mm]") * 12.0
    file = rig.write("steer.csv", sheet)
    with pytest.raises(RecordingError, match="no column with the input"):
        jn.read_kc(file, convention="iso")
    mapped = jn.read_kc(file, {"Rack Travel [deg]": "handwheel_angle [deg]"}, convention="iso")
    assert mapped["steer"]["input"].attrs["units"] == "rad"


def test_two_columns_of_one_quantity_contradict_or_agree(rig: Any) -> None:
    other = rig.write_test(
        "bounce", lambda sheet: sheet.update({"toe_left (deg)": 2.0 * sheet["Toe L [deg]"]})
    )
    sheet = jn.read_kc(other, convention="iso")
    assert codes(sheet) == {"kc.columns_contradict"}
    assert "left.toe" not in sheet["bounce"]
    same = rig.write_test(
        "bounce", lambda sheet: sheet.update({"toe_left (deg)": sheet["Toe L [deg]"]})
    )
    sheet = jn.read_kc(same, convention="iso")
    assert codes(sheet) == set()
    assert "left.toe" in sheet["bounce"]


def test_one_reversed_force_is_not_the_load_of_the_test(rig: Any) -> None:
    file = rig.write_test("lateral-opposed", reverse("Fy R [N]"))
    with pytest.raises(RecordingError, match=r"not loaded as in this test.*opposite forces"):
        jn.read_kc(file, convention="iso")


def test_missing_tests_are_named(rig: Any) -> None:
    sheet = jn.read_kc(
        [rig.write_test(test) for test in TESTS if test != "steer"], convention="iso"
    )
    missing = next(item for item in sheet.findings if item.code == "kc.tests_missing")
    assert "steer" in missing.message
    assert "roll" not in missing.numbers["names"]


def test_a_test_is_recognised_by_what_moves(rig: Any) -> None:
    for test in TESTS:
        sheet = jn.read_kc(rig.write("run.csv", rig.columns(test)), convention="iso")
        assert list(sheet) == [test]
        assert "kc.test_recognised" in codes(sheet, serious=False)


@pytest.mark.parametrize("name", ["mcpherson-elastic", "solid-axle"])
def test_files_of_simulated_tests_are_read_as_they_are(name: str, tmp_path: Path) -> None:
    """Their parts have loads of their own, which are no forces of the road; the input is the column of that name."""
    sheet = jn.kc_sheet(name)
    files = {file: text for file, text in sheet.files().items() if file.startswith("tests/")}
    for file, text in files.items():
        (tmp_path / Path(file).name).write_text(str(text))
    read = jn.read_kc(sorted(tmp_path.iterdir()))
    assert set(read) == set(sheet.tests)
    for test, own in sheet.tests.items():
        assert read[test]["input"].values == pytest.approx(own["input"].values, rel=1e-10)
        for quantity in ("left.toe", "right.camber", "left.vertical_force", "left.lateral_force"):
            assert read[test][quantity].values == pytest.approx(
                own[quantity].values, rel=1e-9, abs=1e-12
            )
    verdicts = jn.compare_kc(sheet.tests, read)["verdict"].values
    assert set(verdicts) <= {"within", "not judged"}
    assert (verdicts == "within").sum() > 100


def test_a_column_without_a_wheel_does_not_replace_the_input(tmp_path: Path) -> None:
    rows = "\n".join(f"{100 * k},{0.01 * k},{k % 3}" for k in range(-5, 6))
    (tmp_path / "lateral in phase.csv").write_text(f"input [N],Toe L [deg],Fy [N]\n{rows}\n")
    read = jn.read_kc(tmp_path / "lateral in phase.csv")["lateral-in-phase"]
    assert read["input"].values == pytest.approx(100.0 * np.arange(-5, 6))


# --- two files


def split(rig: Any, test: str, rows: slice = slice(None), names: tuple[str, str] = ("l", "r")):
    """Write the columns of each wheel to a file of its own, those of the axle to both."""
    sheet = rig.columns(test)
    words = {"l": {"L", "Left", "left", "LF"}, "r": {"R", "Right", "right", "RF"}}
    files = []
    for wheel, other, name in (("l", "r", names[0]), ("r", "l", names[1])):
        own = {
            heading: values[rows] if wheel == "r" else values
            for heading, values in sheet.items()
            if not words[other] & {*heading.replace("_", " ").replace("[", " ").split()}
        }
        files.append(rig.write(name, own))
    assert 0 < len(own) < len(sheet)
    return files


@pytest.mark.parametrize("test", ["bounce", "roll", "lateral-opposed"])
@pytest.mark.parametrize("rows", [slice(None), slice(None, None, 2)])
def test_both_wheels_of_a_test_may_have_a_file_each(rig: Any, test: str, rows: slice) -> None:
    files = split(rig, test, rows, (f"{test} run 1.csv", f"{test} run 2.csv"))
    sheet = jn.read_kc(files, convention="iso")
    whole = jn.read_kc(rig.write_test(test), convention="iso")
    assert "kc.wheels_joined" in codes(sheet, serious=False)
    assert "kc.test_twice" not in codes(sheet)
    assert set(sheet[test].data_vars) == set(whole[test].data_vars)
    got, expected = (jn.kc_slopes(each[test])["slope"] for each in (sheet, whole))
    for quantity in expected["quantity"].values:
        assert float(got.sel(quantity=quantity)) == pytest.approx(
            float(expected.sel(quantity=quantity)), rel=1e-3, abs=1e-9
        )


@pytest.mark.parametrize("test", ["lateral-opposed", "lateral-in-phase"])
def test_two_unnamed_files_tell_together_which_test_they_are(rig: Any, test: str) -> None:
    sheet = jn.read_kc(split(rig, test, names=("run 1.csv", "run 2.csv")), convention="iso")
    assert list(sheet) == [test]
    assert "kc.wheels_by_row" in codes(sheet, serious=False)


def test_the_map_says_which_wheel_a_file_has(rig: Any) -> None:
    z = np.linspace(-0.03, 0.03, 13)
    files = [
        rig.write(name, {"travel [mm]": 1e3 * z, "toe [deg]": gain * z})
        for name, gain in (("run 1.csv", 5.0), ("run 2.csv", 7.0))
    ]
    rows = {"wheels": {"run 1": "right", "run 2.csv": "left"}}
    bounce = jn.read_kc(files, rows, convention="iso")["bounce"]
    slopes = np.degrees(jn.kc_slopes(bounce)["slope"])
    assert float(slopes.sel(quantity="left.toe")) == pytest.approx(7.0)
    assert float(slopes.sel(quantity="right.toe")) == pytest.approx(5.0)


def test_the_same_wheel_twice_is_still_said(rig: Any) -> None:
    z = np.linspace(-0.03, 0.03, 13)
    files = [
        rig.write(name, {"Travel L [mm]": 1e3 * z, "Toe L [deg]": 5.0 * z})
        for name in ("bounce 1.csv", "bounce 2.csv")
    ]
    assert "kc.test_twice" in codes(jn.read_kc(files, convention="iso"))
