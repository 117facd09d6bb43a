"""``jounce fit``: what the JSON holds, and every damaged measurement."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.operations.index import operations
from jounce.operations.request import Request
from jounce.parts import load

ESTIMATE = {"value", "standard_error", "interval"}


def test_stiffness(cli, spring_files: list[Path]) -> None:
    asked = ("--report", "spring.html", "--figure", "spring.svg")
    outcome = cli("fit", "stiffness", *spring_files, "--load", "175 N", *asked, "--json")
    assert outcome.exit_code == 0
    found = outcome.json
    assert {"stiffness", "intercept", "loss_factor", "trials", "findings"} <= set(found)
    assert set(found["stiffness"]) == ESTIMATE == set(found["intercept"])
    assert found["stiffness"]["value"] == pytest.approx(22730.0, rel=1e-6)
    assert found["stiffness"]["interval"][0] < 22730.0 < found["stiffness"]["interval"][1]
    assert found["repeatability"] == pytest.approx(30.0, rel=1e-6)  # of 22700, 22730, 22760 N/m
    assert found["loss_factor"] == pytest.approx(0.0, abs=1e-9)  # both branches are one line
    assert [trial["name"] for trial in found["trials"]] == [file.name for file in spring_files]
    assert found["operating_deflection"] == pytest.approx(175.0 / 22730.0, rel=1e-3)
    assert (found["report"], found["figure"]) == ("spring.html", "spring.svg")
    page = Path("spring.html").read_text(encoding="utf-8")
    assert "22.730" in page
    assert all(file.name in page for file in spring_files)
    assert Path("spring.svg").read_text(encoding="utf-8").startswith("<?xml")
    again = cli("fit", "stiffness", *spring_files, *asked)
    assert again.exit_code == 2
    assert "exists" in again.err


def test_stiffness_as_a_table(cli, spring_files: list[Path]) -> None:
    outcome = cli("fit", "stiffness", *spring_files, "--law", "polynomial", "--degree", 2)
    assert outcome.exit_code == 0
    assert "polynomial law" in outcome.out
    assert "spring_2.csv" in outcome.out
    assert "coefficient 2" in outcome.out


def test_patterns_that_no_shell_expanded(cli, spring_files: list[Path]) -> None:
    assert len(cli("fit", "stiffness", "spring_*.csv", "--json").json["trials"]) == len(
        spring_files
    )
    outcome = cli("fit", "stiffness", "tyre_*.csv")
    assert outcome.exit_code == 2
    assert "no file matches; found 'tyre_*.csv'" in outcome.err


def test_columns_are_mapped(cli, tmp_path: Path) -> None:
    rows = "\n".join(f"{0.02273 * i}; {i}" for i in range(16))
    (tmp_path / "bench.csv").write_text(f"F; way [mm]\n{rows}\n", encoding="utf-8")
    words = ("fit", "stiffness", "bench.csv", "--columns", "displacement=way", "--json")
    found = cli(*words, "--columns", "force=F [kN]").json
    assert found["stiffness"]["value"] == pytest.approx(22730.0, rel=1e-6)
    without = cli(*words, "--columns", "force=F")
    assert without.exit_code == 2
    assert "the column has no unit" in without.err


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--law", "polynomal"), "Did you mean 'polynomial'?"),
        (("--intercept", "dorp"), "Did you mean 'drop'?"),
        (("--branch", "up"), "allowed: both, loading, unloading"),
        (("--discard-below", "2"), "no points remain after discarding"),  # 2 m
        (("--discard-below", "2 N"), "--discard-below: wrong unit"),
        (("--columns", "strain=x [mm]"), "allowed: displacement, force"),
        (("--columns", "force"), "--columns: not NAME=VALUE"),
    ],
)
def test_bad_choices(words: tuple[str, ...], message: str, cli, spring_files: list[Path]) -> None:
    outcome = cli("fit", "stiffness", *spring_files, *words)
    assert outcome.exit_code == 2
    assert message in outcome.err


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (None, "bench.csv: no such file"),
        ("", "bench.csv: the file is empty"),
        ("displacement [mm], force [N]\n", "bench.csv, line 1: a header but no rows of numbers"),
        ("displacement [mm], load [N]\n0, 0\n1, 22\n", "bench.csv: no column 'force'"),
        (
            "displacement [mm], force\n0, 0\n1, 22\n2, 44\n",
            "bench.csv: column 'force': the column has no unit",
        ),
        (
            "displacement [mm], force [mm]\n0, 0\n1, 22\n2, 44\n",
            "bench.csv: column 'force [mm]': wrong unit",
        ),
        ("displacement [mm], force [N]\n0, 0\n1, nan\n2, 44\n", "bench.csv, line 3"),
        ("displacement [mm], force [N]\n0, 0\n1, much\n2, 44\n", "bench.csv, line 3"),
        ("displacement [mm], force [N]\n0, 0, 5\n1, 22, 5\n2, 44, 5\n", "bench.csv, line 2"),
        ("displacement [mm], force [N]\n0; 0\n1; 22\n2; 44\n", "bench.csv, line 2"),
        ("0, 0\n1, 22\n2, 44\n", "bench.csv, line 1: the header is missing"),
        ("displacement [mm], force [N]\n1, 0\n1, 22\n1, 44\n", "the deflection never changes"),
        ("displacement [mm], force [N]\n0, 0\n1, 22\n", "too few points"),
    ],
)
def test_damaged_trials(content: str | None, message: str, cli, tmp_path: Path) -> None:
    if content is not None:
        (tmp_path / "bench.csv").write_text(content, encoding="utf-8")
    outcome = cli("fit", "stiffness", "bench.csv", "--json")
    assert outcome.exit_code == 2
    assert message in outcome.err
    assert outcome.err.count("\n") == 1
    assert message in outcome.json["error"]["message"]


def test_decay(cli, decay_file: Path) -> None:
    outcome = cli("fit", "decay", decay_file, "--channel", "sprung.z", "--mass", "16 kg", "--json")
    assert outcome.exit_code == 0
    found = outcome.json
    keys = (
        "damping_ratio",
        "damping_coefficient",
        "coulomb_force",
        "natural_frequency_hz",
        "equilibrium",
    )
    assert all(set(found[key]) == ESTIMATE for key in keys)
    assert found["damping_ratio"]["value"] == pytest.approx(0.11, rel=1e-6)
    assert found["coulomb_force"]["value"] == pytest.approx(
        16 * 33.9**2 * 0.8e-3, rel=1e-6
    )  # m w^2 x_c
    assert found["damping_coefficient"]["value"] == pytest.approx(2 * 0.11 * 33.9 * 16, rel=1e-6)
    assert (
        found["logarithmic_decrement"] > 0.70
    )  # friction makes it larger than 2 pi 0.11 / sqrt(1 - 0.11^2) = 0.695
    assert found["cycles"] >= 2
    assert isinstance(found["findings"], list)


def test_decay_as_a_table_with_a_known_stiffness(cli, decay_file: Path) -> None:
    words = ("fit", "decay", decay_file, "--channel", "sprung.z", "--mass", "16 kg", "--stiffness")
    outcome = cli(*words, "25 N/mm")
    assert outcome.exit_code == 0
    assert "dry friction force" in outcome.out
    assert "check mass, stiffness at the wheel" in outcome.out  # 16 kg (33.9 rad/s)^2 = 18.4 N/mm
    assert "check mass, stiffness at the wheel" not in cli(*words, "18.39 N/mm").out


def test_several_decays_are_combined(cli, decay_file: Path, tmp_path: Path) -> None:
    other = tmp_path / "again.csv"
    other.write_bytes(decay_file.read_bytes())
    words = ("fit", "decay", decay_file, other, "--channel", "sprung.z", "--mass", "16 kg")
    found = cli(*words, "--report", "decays.html", "--json").json
    page = (tmp_path / "decays.html").read_text(encoding="utf-8")
    assert "2 free decays combined" in page
    assert all(f"{name}.csv" in page for name in ("decay", "again"))
    refused = cli(*words, "--figure", "decays.svg")
    assert refused.exit_code == 2
    assert "a figure shows only one decay" in refused.err
    assert found["damping_ratio"]["value"] == pytest.approx(0.11, rel=1e-6)
    assert found["files"] == [str(decay_file), str(other)]


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("time [s]", "time [m]", "column 'time [m]': wrong unit"),
        ("time [s]", "clock [s]", "no column 'time'"),
        ("sprung.z [mm]", "sprung.z", "column 'sprung.z': the column has no unit"),
        (
            "sprung.z [mm]",
            "unsprung.z [mm]",
            "no channel 'sprung.z'; found 'unsprung.z'. Did you mean 'unsprung.z'?",
        ),
        ("0.0030, ", "0.0010, ", "decay.csv"),  # time runs back
        ("0.0030, ", "0.0034, ", "decay.csv"),  # 40 % of the step
        ("0.0030, ", "nan, ", "decay.csv, line 5"),
        ("0.0030, ", "soon, ", "decay.csv, line 5"),
    ],
)
def test_damaged_decays(old: str, new: str, message: str, cli, decay_file: Path) -> None:
    decay_file.write_text(
        decay_file.read_text(encoding="utf-8").replace(old, new, 1), encoding="utf-8"
    )
    outcome = cli("fit", "decay", decay_file, "--channel", "sprung.z", "--mass", "16 kg")
    assert outcome.exit_code == 2
    assert outcome.out == ""
    assert message in outcome.err


def test_all_zero_time(cli, tmp_path: Path) -> None:
    rows = "\n".join(f"0, {i % 7}" for i in range(50))
    (tmp_path / "decay.csv").write_text(f"time [s], sprung.z [mm]\n{rows}\n", encoding="utf-8")
    outcome = cli("fit", "decay", "decay.csv", "--channel", "sprung.z", "--mass", "16 kg")
    assert outcome.exit_code == 2
    assert "decay.csv: time" in outcome.err
    assert "zero in every row" in outcome.err


@pytest.mark.parametrize(
    ("mass", "message"),
    [
        ("-16 kg", "--mass: out of range; found '-16 kg'; allowed: above 0 kg"),
        ("16 N", "--mass: wrong unit; found 'N'; allowed: a unit that converts to kg"),
        ("heavy", "--mass: not a number with a unit"),
    ],
)
def test_bad_mass(mass: str, message: str, cli, decay_file: Path) -> None:
    outcome = cli("fit", "decay", decay_file, "--channel", "sprung.z", "--mass", mass)
    assert outcome.exit_code == 2
    assert message in outcome.err


def test_channel_that_is_no_motion(cli, tmp_path: Path) -> None:
    rows = "\n".join(f"{0.001 * i:.3f}, {i % 7}" for i in range(50))
    (tmp_path / "force.csv").write_text(f"time [s], tyre.force [N]\n{rows}\n", encoding="utf-8")
    outcome = cli("fit", "decay", "force.csv", "--channel", "tyre.force", "--mass", "16 kg")
    assert outcome.exit_code == 2
    assert "invalid motion; found 'N'" in outcome.err


@pytest.fixture
def damper_file(tmp_path: Path) -> Path:
    """A bilinear damper of 300 N s/m in bump and 900 in rebound, at 6 rad/s and 20 mm."""
    rows = ["time [s], displacement [mm], velocity [mm/s], force [N]"]
    for i in range(400):
        t = 0.01 * i
        velocity = 0.12 * math.cos(6.0 * t)
        force = (300.0 if velocity > 0.0 else 900.0) * velocity
        rows.append(f"{t:.2f}, {20.0 * math.sin(6.0 * t):.9g}, {1e3 * velocity:.9g}, {force:.9g}")
    file = tmp_path / "damper.csv"
    file.write_text("\n".join(rows), encoding="utf-8")
    return file


def test_damper(cli, damper_file: Path) -> None:
    asked = ("--report", "damper.html", "--figure", "damper.svg")
    found = cli("fit", "damper", damper_file, "--law", "bilinear", *asked, "--json").json
    assert "bump coefficient" in Path("damper.html").read_text(encoding="utf-8")
    assert Path("damper.svg").read_text(encoding="utf-8").startswith("<?xml")
    assert found["parameters"]["bump_coefficient"]["value"] == pytest.approx(300.0, rel=1e-6)
    assert found["parameters"]["rebound_coefficient"]["value"] == pytest.approx(900.0, rel=1e-6)
    assert found["units"]["bump_coefficient"] == "N*s/m"
    assert found["r2"] == pytest.approx(1.0, abs=1e-9)
    linear = cli("fit", "damper", damper_file, "--json").json
    assert 0.9 < linear["r2"] < 0.97


def test_fitted_damper_can_be_set(cli, damper_file: Path, bump: Path) -> None:
    text = cli("fit", "damper", damper_file, "--law", "bilinear").out
    table = next(line for line in text.splitlines() if "damper = {" in line).partition("= ")[2]
    words = (
        "--road",
        bump,
        "--speed",
        "2 m/s",
        "--duration",
        "0.2 s",
        "--set",
        f"strut.damper={table}",
    )
    assert cli("simulate", "kart-quarter-car", *words).exit_code == 0


def test_damper_record_from_matlab(cli) -> None:
    """A record of Labcontrol: displacement, velocity and force are the columns of one matrix without units."""
    file = Path(__file__).parent.parent / "files" / "mr_damper_labcontrol" / "ensaio.A.1.mat"
    where = (
        "time=Tout [s], displacement=x_F(:,1) [mm], velocity=x_F(:,2) [mm/s], force=x_F(:,3) [N]"
    )
    found = cli(
        "fit", "damper", file, "--columns", where, "--law", "tanh-hysteretic", "--json"
    ).json
    assert 0.98 < found["r2"] < 1.0
    assert found["damper"]["kind"] == "tanh"


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--law", "bilinaer"), "Did you mean 'bilinear'?"),
        (("--columns", "force=load [N]"), "damper.csv: no column 'load'"),
        (("--velocity-from", "record"), "Did you mean 'recorded'?"),
        (("--law", "polynomial", "--degree", "0"), "degree"),
    ],
)
def test_bad_damper_choices(words: tuple[str, ...], message: str, cli, damper_file: Path) -> None:
    outcome = cli("fit", "damper", damper_file, *words)
    assert outcome.exit_code == 2
    assert message in outcome.err


def test_damper_record_without_force(cli, decay_file: Path) -> None:
    outcome = cli("fit", "damper", decay_file)
    assert outcome.exit_code == 2
    assert "decay.csv: no column 'displacement'" in outcome.err
    assert "--columns displacement='COLUMN [unit]'" in outcome.err


@pytest.mark.parametrize(
    ("stroke", "force"), [("compression", "tension"), ("extension", "compression")]
)
def test_damper_record_of_other_signs(stroke: str, force: str, cli, damper_file: Path) -> None:
    """The file counts both in compression: a wrong statement about one is a problem; the table says how it was read."""
    found = cli(
        "fit",
        "damper",
        damper_file,
        "--law",
        "bilinear",
        "--stroke-positive",
        stroke,
        "--force-positive",
        force,
    )
    assert "though its sign was stated" in " ".join(found.out.split())
    assert "positive in compression (bump)" in found.out


@pytest.mark.parametrize(
    "words", [("--stroke-positive", "tension"), ("--force-positive", "extension")]
)
def test_unknown_signs(
    words: tuple[str, str], cli, damper_file: Path, spring_files: list[Path]
) -> None:
    for command in (("damper", damper_file), ("stiffness", *spring_files)):
        outcome = cli("fit", *command, *words)
        assert outcome.exit_code == 2
        assert "compression" in outcome.err


def test_the_sign_of_a_height_cannot_be_stated(cli, decay_file: Path) -> None:
    outcome = cli(
        "fit",
        "decay",
        decay_file,
        "--channel",
        "sprung.z",
        "--mass",
        "16 kg",
        "--stroke-positive",
        "extension",
    )
    assert outcome.exit_code == 2
    assert "not a stroke" in outcome.err


def test_european_files_and_irregular_time_on_the_command_line(
    cli, decay_file: Path, tmp_path: Path
) -> None:
    rows = decay_file.read_text(encoding="utf-8").splitlines()
    names = [name.strip() for name in rows[0].split(",")]
    loose = [row for i, row in enumerate(rows[1:]) if i % 7]  # every seventh sample is missing
    text = "\n".join([";".join(names), *(row.replace(",", ";").replace(".", ",") for row in loose)])
    (tmp_path / "loose.csv").write_text(text, encoding="utf-8")
    command = ("fit", "decay", "loose.csv", "--channel", "sprung.z", "--mass", "16 kg", "--json")
    refused = cli(*command)
    assert refused.exit_code == 2
    assert "resample fills the gap" in refused.err
    outcome = cli(*command, "--resample", "10 ms")
    assert outcome.exit_code == 0
    truth = cli(
        "fit", "decay", decay_file, "--channel", "sprung.z", "--mass", "16 kg", "--json"
    ).json
    for name in ("natural_frequency_hz", "damping_coefficient"):
        assert outcome.json[name]["value"] == pytest.approx(truth[name]["value"], rel=0.02)
    messages = " ".join(found["message"] for found in outcome.json["findings"])
    assert "decimal commas were read as decimal points" in messages
    assert "the largest gap in the recorded time is" in messages
    wrong = cli(*command, "--resample", "10 mm")
    assert (wrong.exit_code, "--resample" in wrong.err) == (2, True)


def test_a_rate_is_written_into_a_rig_with_its_interval_and_source(
    cli, spring_files: list[Path]
) -> None:
    asked = ("fit", "stiffness", *spring_files, "--rig", "kart-quarter-car")
    outcome = cli(*asked, "--out", "rig.toml", "--json")
    assert outcome.exit_code == 0
    assert outcome.json["out"] == "rig.toml"
    assert load("rig.toml").parameters()["strut.spring.rate"] == pytest.approx(22730.0, rel=1e-6)
    first = Path("rig.toml").read_text(encoding="utf-8").splitlines()[0]
    assert first.startswith("# strut.spring.rate: 22730 N/m, 95 % interval 226")
    assert "linear law of spring_1 to spring_" in first
    again = cli(*asked, "--out", "rig.toml")
    assert (again.exit_code, "exists" in again.err) == (2, True)
    alone = cli(*asked)
    assert (alone.exit_code, "--rig and --out" in alone.err) == (2, True)
    wrong = cli(*asked, "--out", "other.toml", "--part", "strut.spring.rat")
    assert (wrong.exit_code, Path("other.toml").exists()) == (2, False)


def _turned(tmp_path: Path) -> list[Path]:
    """A rate gyro on a pendulum, and a part that is twisted three times."""
    import numpy as np

    from jounce.identify.free_response import DecayParameters, decay_response

    t = np.arange(0.0, 3.0, 2e-3)
    rate = decay_response(t, DecayParameters(23.0, 0.03, 1.4e-3, 0.0, 0.1, 0.2), "angular_velocity")
    files = [tmp_path / "gyro.csv", *(tmp_path / f"twist_{k}.csv" for k in range(3))]
    np.savetxt(
        files[0],
        np.column_stack([t, np.degrees(rate)]),
        "%.9g",
        ",",
        header="time [s],arm.rate [deg/s]",
        comments="",
    )
    angle = np.linspace(0.0, 8.0, 40)
    for k, file in enumerate(files[1:]):
        torque = (5200.0 + 10.0 * k) * np.radians(angle)
        head = "angle [deg],torque [N*m]"
        np.savetxt(file, np.column_stack([angle, torque]), "%.9g", ",", header=head, comments="")
    return files


def test_a_rate_gyro_has_an_inertia(cli, tmp_path: Path) -> None:
    gyro = _turned(tmp_path)[0]
    asked = (
        "fit",
        "decay",
        gyro,
        "--channel",
        "arm.angular_velocity",
        "--columns",
        "arm.angular_velocity=arm.rate",
    )
    found = cli(*asked, "--inertia", "0.8 kg*m^2", "--stiffness", "423.2 N*m/rad", "--json").json
    assert found["motion"] == "rotation"
    assert found["coulomb_torque"]["value"] == pytest.approx(0.8 * 23.0**2 * 1.4e-3, rel=1e-3)
    assert found["stiffness"]["value"] == pytest.approx(0.8 * 23.0**2, rel=1e-4)
    assert "coulomb_force" not in found
    shown = cli(*asked, "--inertia", "0.8 kg*m^2", "--report", "gyro.html", "--figure", "gyro.svg")
    assert "N·m·s/rad" in shown.out
    page = Path("gyro.html").read_text(encoding="utf-8")
    assert "dry friction torque" in page
    assert "stiffness from inertia" in page
    for wrong in (
        ("--mass", "1 kg"),
        (),
        ("--mass", "1 kg", "--inertia", "1 kg*m^2"),
        ("--inertia", "1 kg"),
    ):
        refused = cli(*asked, *wrong)
        assert refused.exit_code == 2
        assert "kg*m^2" in refused.err


def test_torque_over_angle_on_the_command_line(
    cli, tmp_path: Path, spring_files: list[Path]
) -> None:
    twists = _turned(tmp_path)[1:]
    asked = ("fit", "stiffness", *twists, "--discard-below", "1 deg", "--load", "400 N*m")
    found = cli(*asked, "--json").json
    assert (found["motion"], found["stiffness"]["value"]) == (
        "rotation",
        pytest.approx(5210.0, rel=1e-6),
    )
    shown = cli(*asked, "--report", "twist.html", "--figure", "twist.svg")
    assert "stiffness [N·m/rad]" in shown.out
    assert "Torque against angle" in Path("twist.html").read_text(encoding="utf-8")
    mixed = cli("fit", "stiffness", twists[0], spring_files[0])
    assert (mixed.exit_code, "not fitted together" in mixed.err) == (2, True)
    rig = cli(*asked, "--rig", "kart-quarter-car", "--out", "rig.toml")
    assert (rig.exit_code, "this part needs N/m" in rig.err) == (2, True)
    mapped = cli("fit", "stiffness", twists[0], "--columns", "angle=angle [rad]")
    assert (mapped.exit_code, "a different unit" in mapped.err) == (2, True)


CALIBRATION = "displacement [mm],ch3 [V]\n0,0.401\n10,1.402\n20,2.399\n40,4.401\n"


def test_calibration(cli, tmp_path: Path) -> None:
    (tmp_path / "laser.csv").write_text(CALIBRATION, encoding="utf-8")
    found = cli(
        "fit",
        "calibration",
        "laser.csv",
        "--figure",
        "laser.svg",
        "--report",
        "laser.html",
        "--json",
    ).json
    low, high = found["sensitivity"]["interval"]
    assert low < 100.0 < high
    assert found["sensitivity"]["value"] == pytest.approx(99.99, abs=0.01)
    assert found["gain_doubt"] == pytest.approx(
        found["sensitivity"]["standard_error"] / found["sensitivity"]["value"]
    )
    assert found["residual"] == pytest.approx(0.0017 / 4.0, rel=0.05)
    assert (found["file"], found["figure"], found["report"]) == (
        "laser.csv",
        "laser.svg",
        "laser.html",
    )
    shown = cli("fit", "calibration", "laser.csv").out
    assert re.search(r"sensitivity +99\.986 +0\.051 +99\.77 to 100\.21 +V/m", shown)
    assert 'sensitivity = "99.9857 V/(m)"' in shown


def test_calibration_by_tilting_from_a_workbook(cli, tmp_path: Path) -> None:
    book = pytest.importorskip("openpyxl").Workbook()
    for row in (["angle [deg]", "ch0 [mV]"], [0, 2601], [90, 2500], [180, 2400]):
        book.active.append(row)
    book.save(tmp_path / "tilt.xlsx")
    found = cli("fit", "calibration", "tilt.xlsx", "--json").json
    assert (found["quantity_unit"], found["recorded_unit"]) == ("m/s^2", "V")
    assert found["reference"] == pytest.approx([9.80665, 0.0, -9.80665])
    assert found["sensitivity"]["value"] == pytest.approx(0.1005 / 9.80665)


@pytest.mark.parametrize(
    ("content", "words", "message"),
    [
        (
            "load [N],out [V]\n5,1\n5,1.1\n",
            (),
            "cal.csv: equal reference values cannot determine a sensitivity; found '5'",
        ),
        ("load [N],out [V]\n0,1\n5,1\n", (), "a constant reading; found '1'"),
        (
            "load [N],out [V]\n5,1\n",
            (),
            "cal.csv: too few points; found '1 and 1'; allowed: two or more pairs",
        ),
        (
            "load [N],out\n0,1\n5,2\n",
            (),
            "no column of readings with its unit; found 'load [N], out'",
        ),
        ("load [N],out\n0,1\n5,2\n", (), "State the unit: --columns recorded='out [V]'."),
        ("load,out [V]\n0,1\n5,2\n", (), "State the unit: --columns reference='load [N]'."),
        (
            "load [kg],out [V]\n0,1\n5,2\n",
            ("--columns", "reference=load"),
            "found 'load [kg]'",
        ),
        (
            "load [N],out [V]\n0,1\n5,2\n",
            ("--columns", "size=load"),
            "unknown column of a calibration 'size'",
        ),
        ("load [N],out [V]\n0,1\n5,2\n", ("--columns", "reference=weight"), "no column 'weight'"),
        (
            "load [N],out [V]\n0,1\n5,x\n",
            (),
            "cal.csv, line 3: column 'out [V]': text in a number column",
        ),
        ("", (), "cal.csv: the file is empty"),
    ],
)
def test_calibrations_that_tell_nothing(
    content: str, words: tuple[str, ...], message: str, cli, tmp_path: Path
) -> None:
    (tmp_path / "cal.csv").write_text(content, encoding="utf-8")
    outcome = cli("fit", "calibration", "cal.csv", *words, "--json")
    assert outcome.exit_code == 2
    assert message in outcome.err
    assert outcome.json["error"]["message"] in outcome.err


@pytest.fixture
def poses(tmp_path: Path) -> str:
    travel = np.linspace(-0.03, 0.03, 13)
    rig = jn.load("formula-student-front").with_changes(
        {"hardpoints.tie_rod_inner[2]": "151 mm"}
    )  # synthetic: a truth
    toe = np.degrees(jn.sweep_travel(rig, travel)["toe"].to_numpy()) + np.random.default_rng(
        1
    ).normal(0.0, 0.01, 13)
    rows = [f"{1e3 * at:.1f},{angle:.4f}" for at, angle in zip(travel, toe, strict=True)]
    (tmp_path / "poses.csv").write_text(
        "\n".join(["wheel_travel [mm],toe [deg]", *rows, ""]), encoding="utf-8"
    )
    return "poses.csv"


def test_hardpoints_are_the_same_by_command_job_and_python(cli, poses: str) -> None:
    free = {"hardpoints.tie_rod_inner[2]": "10 mm"}
    words = (
        "fit",
        "hardpoints",
        "formula-student-front",
        poses,
        "--free",
        "hardpoints.tie_rod_inner[2]=10 mm",
    )
    found = cli(
        *words, "--starts", 1, "--out", "updated.toml", "--figure", "toe.svg", "--json"
    ).json
    low, high = found["numbers"]["hardpoints.tie_rod_inner[2]"]["interval"]
    assert low < 0.151 < high
    updated = jn.load("updated.toml").parameters()["hardpoints.tie_rod_inner[2]"]
    assert updated == pytest.approx(found["numbers"]["hardpoints.tie_rod_inner[2]"]["value"])
    request = Request(
        operations()["fit hardpoints"],
        {"rig": "formula-student-front", "measured": poses, "free": free, "starts": 1},
    )
    names: dict[str, object] = {}
    exec(request.python(), names)  # noqa: S102 - that is what it is for
    assert names["result"].to_dict()["numbers"] == found["numbers"]
    assert request.words()[2:4] == ["formula-student-front", poses]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--offset", "camber"), "--offset: unknown measured quantity 'camber'; allowed: toe"),
        (("--starts", "0"), "--starts: invalid number of searches; found 0"),
        (("--noise", "toe=1mm"), "noise: toe: wrong unit"),
        (("--out", "rig.csv"), "rig.csv"),
    ],
)
def test_bad_choices_for_hardpoints(words: tuple[str, ...], message: str, cli, poses: str) -> None:
    free = ("--free", "hardpoints.tie_rod_inner[2]=10 mm")
    outcome = cli("fit", "hardpoints", "formula-student-front", poses, *free, *words)
    assert outcome.exit_code == 2
    assert message in outcome.err
