"""Reading a tester's file: header lines, the file beside it, mapped columns, units; what cannot be read says why."""

from __future__ import annotations

import numpy as np
import pytest

from jounce.core.errors import DescriptionError, RecordingError
from jounce.inspection import calibrate_plate, evaluate, read_record
from jounce.inspection.record import is_simulated, missing_plates, read_facts, wheels_of, with_facts
from jounce.inspection.signals import plate_acceleration, plate_mass_of
from jounce.parts.testers import load_tester

COLUMNS = "time [s], left.plate.z [mm], left.plate.force [N]"


def write(folder, text, *, name="lane.csv", columns=COLUMNS, rows=None):
    rows = [f"{i / 1000}, {i % 7 - 3}, {4000 + i % 5}" for i in range(20)] if rows is None else rows
    file = folder / name
    file.write_text("\n".join([*text, columns, *rows]) + "\n", encoding="utf-8")
    return file


def test_files_that_name_no_plate_are_no_tester_records(tmp_path):
    facts = '# left.static_load = "4316 N"'
    assert missing_plates(write(tmp_path, [facts, ""])) is None
    spring = tmp_path / "spring.csv"
    spring.write_text("# made by us\ndisplacement [mm],force [N]\n1,2\n")
    why = missing_plates(spring)
    assert why == "no plate force in its first line: displacement [mm],force [N]"
    assert "Plattenkraft" in why.german()
    for name, content in (("empty.csv", ""), ("run.vbo", "[header]\ntime\n")):
        (tmp_path / name).write_text(content)
        assert missing_plates(tmp_path / name) == "it names no plate force"
    (tmp_path / "hidden.mat").write_bytes(b"MATLAB 5.0 MAT-file")  # compressed names are not read
    assert missing_plates(tmp_path / "hidden.mat") is None


def test_header_lines(tmp_path):
    text = [
        '# left.static_load = "4.3164 kN"',
        '# left.plate_mass = "18 kg"',
        '# axle = "rear"',
        "# date = 2024-05-06",
    ]
    text += [
        '# wheel_order = ["left", "right"]',
        '# plate_number = "KE-123AB"',
        "# made by the lane",
    ]
    record, findings = read_record(write(tmp_path, text))
    expected = {
        "axle": "rear",
        "date": "2024-05-06",
        "wheel_order": "left, right",
        "plate_number": "KE-123AB",
    }
    assert record.attrs == expected | {"left.static_load": 4316.4, "left.plate_mass": 18.0}
    assert record["left.plate.z"].values[:2].tolist() == [-0.003, -0.002]
    assert wheels_of(record) == ("left",)
    assert findings == []


def test_file_beside_it_and_lines_that_win(tmp_path):
    file = write(tmp_path, ['# left.static_load = "5 kN"'])
    (tmp_path / "lane.toml").write_text(
        'axle = "front"\n[left]\nstatic_load = "4 kN"\nplate_mass = "21 kg"\n'
    )
    record, _ = read_record(file)
    assert record.attrs == {"axle": "front", "left.static_load": 5000.0, "left.plate_mass": 21.0}
    (tmp_path / "lane.toml").write_text("axle = front")
    with pytest.raises(DescriptionError, match=r"lane\.toml: not valid TOML"):
        read_record(file)


def test_unknown_keys_and_lines_are_said(tmp_path):
    text = ['# left.static_lod = "4 kN"', "# operator = Jan Novak", '# humidity = "40 %"']
    _, findings = read_record(write(tmp_path, text))
    assert [one.severity for one in findings] == ["warning", "warning", "note"]
    assert "'operator = Jan Novak' was ignored" in findings[0].message
    assert "Did you mean 'left.static_load'?" in findings[1].message


def test_columns_of_a_tester(tmp_path):
    tester = load_tester("eusama").model_copy(
        update={
            "columns": {"time": "t [ms]", "left.plate.z": "S1 [mm]", "left.plate.force": "F1 [daN]"}
        }
    )
    rows = [f"{i}, {i % 7 - 3}, {400 + i % 5}" for i in range(20)]
    record, _ = read_record(write(tmp_path, [], columns="t, S1, F1", rows=rows), tester)
    assert float(record["time"][1]) == 0.001
    assert record["left.plate.force"].values[:2].tolist() == [4000.0, 4010.0]


@pytest.mark.parametrize(
    ("text", "columns", "error", "message"),
    [
        (
            [],
            "time [s], left.plate.z [in], left.plate.force [lb]",
            DescriptionError,
            "'lb' is a mass; write 'lbf'",
        ),
        (
            [],
            "time [s], left.plate.z [N], left.plate.force [mm]",
            DescriptionError,
            "converts to m",
        ),
        ([], "time [s], left.plate.z, left.plate.force [N]", RecordingError, "no unit"),
        (
            [],
            "time [s], left.plate.z [mm], lft.plate.force [N]",
            RecordingError,
            "Did you mean 'left.plate.force'",
        ),
        (['# left.static_load = "4.3"'], COLUMNS, DescriptionError, "the unit is missing"),
        (['# left.static_load = "-4 kN"'], COLUMNS, DescriptionError, "out of range"),
        (['# left.static_load = "430 kg"'], COLUMNS, DescriptionError, "a unit that converts to N"),
        (['# axle = "middle"'], COLUMNS, DescriptionError, "unknown axle"),
        (['# wheel_order = "up, down"'], COLUMNS, DescriptionError, "unknown order of the wheels"),
    ],
)
def test_headers_that_cannot_be_used(tmp_path, text, columns, error, message):
    with pytest.raises(error, match=message):
        read_record(write(tmp_path, text, columns=columns))


def test_inches_and_pounds_are_converted(tmp_path):
    record, _ = read_record(
        write(tmp_path, [], columns="time [s], left.plate.z [in], left.plate.force [lbf]")
    )
    assert record["left.plate.z"].values[0] == pytest.approx(-3.0 * 0.0254)
    assert record["left.plate.force"].values[0] == pytest.approx(4000.0 * 4.4482216152605)


def test_gap_and_jitter_in_a_file(tmp_path):
    rows = [f"{i / 1000}, {i % 7}, 4000" for i in range(20)]
    with pytest.raises(RecordingError, match="not a finite number"):
        read_record(write(tmp_path, [], rows=[*rows[:9], "0.009, nan, 4000", *rows[10:]]))
    with pytest.raises(RecordingError, match="jitters"):
        read_record(write(tmp_path, [], rows=[*rows[:9], "0.0094, 1, 4000", *rows[10:]]))
    with pytest.raises(RecordingError, match="no such file"):
        read_record(tmp_path / "missing.csv")


def test_facts_must_be_numbers_with_units():
    facts, findings = read_facts({"right.static_load": np.float64(3000.0), "vehicle": "a6"})
    assert facts == {"right.static_load": 3000.0, "vehicle": "a6"}
    assert findings == []


def test_file_and_memory_give_the_same(tmp_path, twin, left_record, eusama):
    car = twin.Car(c=1500.0)
    time, height, force, _ = twin.rigid_record(car, twin.Programme(), mp=20.0, fine=4)
    rows = [f"{t:.3f}, {1e3 * z:.6f}, {f:.3f}" for t, z, f in zip(time, height, force, strict=True)]
    file = write(tmp_path, [f'# left.static_load = "{car.static_load} N"'], rows=rows)
    read = evaluate(read_record(file, eusama)[0], eusama).wheel("left")
    kept = evaluate(left_record(time, height, force, car.static_load), eusama).wheel("left")
    assert read.adhesion == pytest.approx(kept.adhesion, abs=1e-5)
    assert read.phase_angle_min_deg == pytest.approx(kept.phase_angle_min_deg, abs=1e-2)


class TestPlateInertia:
    def test_mass_of_the_header_counts(self, twin, left_record, eusama):
        """A plate of 20 kg at 3 mm and 12 Hz would else add 340 N, 8 % of the load."""
        car = twin.Car()
        time, height, force, contact = twin.rigid_record(car, twin.Programme(), mp=26.0, fine=4)
        right = evaluate(
            left_record(time, height, force, car.static_load, **{"left.plate_mass": 26.0}), eusama
        )
        bare = evaluate(
            left_record(time, height, contact, car.static_load, **{"left.plate_mass": 0.0}), eusama
        )
        wrong = evaluate(left_record(time, height, force, car.static_load), eusama)
        assert right.wheel("left").adhesion == pytest.approx(bare.wheel("left").adhesion, abs=3e-4)
        assert abs(wrong.wheel("left").adhesion - bare.wheel("left").adhesion) > 0.01
        cell = eusama.model_copy(update={"force_cell": "contact"})
        at_tyre = evaluate(left_record(time, height, contact, car.static_load), cell).wheel("left")
        assert at_tyre.adhesion == pytest.approx(bare.wheel("left").adhesion, abs=1e-6)

    def test_calibration_finds_the_mass(self, twin, left_record, eusama):
        programme = twin.Programme()
        time = twin.grid(programme.duration, 8000.0)
        height = 3e-3 * np.sin(programme.angle(time))
        inertia = np.gradient(np.gradient(height, time), time)
        rng = np.random.default_rng(5)
        noise = rng.normal(0.0, 20.0, time.size // 8 + 1)
        force = (17.3 * inertia)[::8] + 160.0 + noise
        found = calibrate_plate(left_record(time[::8], height[::8], force), eusama)
        assert found.plate_mass == pytest.approx(17.3, abs=0.03)
        assert abs(found.plate_mass - 17.3) < 4.0 * found.standard_error + 0.02
        assert found.is_passed
        assert found.allowed_per_hz == 4.0

    def test_loose_plate_fails_its_calibration(self, twin, left_record, eusama):
        programme = twin.Programme()
        time = twin.grid(programme.duration, 1000.0)
        height = 3e-3 * np.sin(programme.angle(time))
        bad = 17.3 * np.gradient(np.gradient(height, time), time) + 30e3 * height
        assert not calibrate_plate(left_record(time, height, bad), eusama).is_passed

    def test_calibration_needs_a_run_down(self, left_record):
        time = np.arange(3000) / 1000.0
        with pytest.raises(RecordingError, match="does not pass through the band"):
            calibrate_plate(left_record(time, 3e-3 * np.sin(157.0 * time), np.sin(157.0 * time)))
        with pytest.raises(RecordingError, match="does not move"):
            calibrate_plate(left_record(time, 0.0 * time, np.sin(157.0 * time)))

    @pytest.mark.parametrize(
        ("facts", "cell", "mass"),
        [
            ({}, "under-plate", 20.0),
            ({"left.plate_mass": 0.0}, "under-plate", 0.0),
            ({"left.plate_mass": 18.0}, "contact", 0.0),
        ],
    )
    def test_whose_mass_counts(self, eusama, facts, cell, mass):
        tester = eusama.model_copy(update={"force_cell": cell, "plate_mass": 20.0})
        assert plate_mass_of(facts, "left", tester) == mass
        assert plate_mass_of(facts, "left", None) == facts.get("left.plate_mass", 0.0)
        assert plate_mass_of(facts, "right", tester) == (0.0 if cell == "contact" else 20.0)

    @pytest.mark.parametrize("rate", [300.0, 700.0, 1000.0, 2000.0])
    def test_acceleration_of_a_polynomial_is_exact(self, rate):
        """Polynomials of order 7, except at both ends, where the last value that is known stays."""
        time = np.arange(60) / rate
        u = time / time[-1]
        found = plate_acceleration(u**7 - 2.0 * u**4 + 3.0 * u**2, rate)
        expected = (42.0 * u**5 - 24.0 * u**2 + 6.0) / time[-1] ** 2
        half = max((2 * round(0.5 * (0.021 * rate - 1.0)) + 1) // 2, 4)
        np.testing.assert_allclose(
            found[half:-half], expected[half:-half], rtol=1e-6, atol=1e-6 * expected.max()
        )
        assert set(found[:half]) == {found[half]}
        assert set(found[-half:]) == {found[-half - 1]}
        assert not plate_acceleration(u[: 2 * half + 1], rate).any()


@pytest.mark.parametrize(
    ("facts", "refused"),
    [
        ({"vehicle": "a" * 2000}, False),
        ({"vehicle": "a" * 2001}, True),
        ({"vehicle": 1e14}, False),
        ({"vehicle": 1e15}, True),
        ({"vehicle": "a\0"}, True),
        ({"left.plate_mass": 0.0}, False),
        ({"left.plate_mass": -1.0}, True),
        ({"left.static_load": 0.0}, True),
        ({"left.tyre_pressure": 0.0}, True),
    ],
)
def test_entries_that_are_out_of_range(facts, refused):
    if refused:
        with pytest.raises(DescriptionError):
            read_facts(facts)
    else:
        assert read_facts(facts)[1] == []


def test_what_is_told_of_a_record_takes_the_place_of_its_header(left_record):
    record = left_record(
        np.arange(3.0), np.zeros(3), np.ones(3), date="2026-11-21", plate_number="A 1"
    )
    again, findings = with_facts(
        record, {"date": "2026-11-22", "plate_number": "A 1", "place": "here"}
    )
    assert (again.attrs["date"], again.attrs["place"], record.attrs["date"]) == (
        "2026-11-22",
        "here",
        "2026-11-21",
    )
    assert [one.words for one in findings] == [
        {"key": "date", "header": "2026-11-21", "given": "2026-11-22"}
    ]
    with pytest.raises(DescriptionError, match="not a date"):
        with_facts(record, {"date": "soon"})
    told = (
        {"simulated": "yes"},
        {"comment": "simulated, seed 3"},
        {"comment": "not simulated, seed 3"},
        {},
    )
    assert [is_simulated(facts) for facts in told] == [True, True, False, False]
