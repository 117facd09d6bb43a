"""``jounce kinematics``: sweeps of travel, rack and roll, files, pictures, and what one can get wrong."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import jounce as jn

RIG = "reference-double-wishbone"
TRAVEL = ("--travel", "-80 mm:80 mm:4 mm")


def test_json_is_one_object_of_quantities(cli) -> None:
    outcome = cli("kinematics", RIG, *TRAVEL, "--json")
    assert outcome.exit_code == 0
    assert outcome.err == ""
    found = outcome.json
    assert set(found["camber"]) == {"units", "values"}
    assert found["wheel_travel"]["units"] == "m"
    assert found["wheel_travel"]["values"] == pytest.approx(np.linspace(-0.08, 0.08, 41), abs=1e-15)
    assert found["wheel_travel"]["values"][20] == 0.0
    expected = jn.sweep_travel(jn.load(RIG), found["wheel_travel"]["values"])
    for name in (
        "camber",
        "steer",
        "caster",
        "kingpin_inclination",
        "caster_trail",
        "scrub_radius",
        "motion_ratio",
    ):
        assert found[name]["values"] == expected[name].to_numpy().tolist()
    assert all(len(item["values"]) == 41 for item in found.values())


def test_table_for_people(cli) -> None:
    outcome = cli("kinematics", RIG, *TRAVEL)
    assert outcome.exit_code == 0
    assert "roll_centre_height" in outcome.out
    assert "41 poses" in outcome.out
    assert "-2.3572" in outcome.out or "80 mm" in outcome.out
    assert "nan" not in outcome.out


def test_rack_as_one_value_as_range_and_alone(cli) -> None:
    one = cli("kinematics", RIG, *TRAVEL, "--rack", "10 mm", "--json").json
    assert one["rack_travel"]["values"] == [0.01] * 41
    pairs = cli("kinematics", RIG, *TRAVEL, "--rack", "-20 mm:20 mm:10 mm", "--json").json
    assert np.shape(pairs["camber"]["values"]) == (41, 5)
    assert np.array(pairs["camber"]["values"])[:, 3] == pytest.approx(
        np.array(one["camber"]["values"]), abs=1e-12
    )
    alone = cli("kinematics", RIG, "--rack", "-20 mm:20 mm:10 mm", "--json").json
    assert alone["steer"]["values"] == pytest.approx(
        np.array(pairs["steer"]["values"])[20], abs=1e-12
    )
    lifted = cli(
        "kinematics", RIG, "--rack", "-20 mm:20 mm:10 mm", "--travel", "0.08", "--json"
    ).json
    assert lifted["steer"]["values"] == pytest.approx(
        np.array(pairs["steer"]["values"])[40], abs=1e-12
    )


def test_roll_and_steering_of_an_axle(cli) -> None:
    rolled = cli("kinematics", RIG, "--roll", "-2 deg:2 deg:1 deg", "--json").json
    assert np.degrees(rolled["roll_angle"]["values"]) == pytest.approx([-2, -1, 0, 1, 2], abs=1e-9)
    assert rolled["roll_stiffness"]["units"] == "N*m/rad"
    steered = cli("kinematics", RIG, "--rack", "-20 mm:20 mm:20 mm", "--axle", "--json").json
    assert steered["left.steer"]["values"][0] == pytest.approx(
        -steered["right.steer"]["values"][2], abs=1e-12
    )


def test_vehicle_adds_percentages(cli) -> None:
    words = ("axle=rear", "wheelbase=2.7 m", "centre_of_mass_height=550 mm", "brake_share=0.4")
    options = [word for text in words for word in ("--vehicle", text)]
    found = cli("kinematics", RIG, *TRAVEL, *options, "--json").json
    rise = (
        found["motion_ratio"]["values"][20] / found["motion_ratio_contact"]["values"][20]
    )  # of the contact patch
    assert found["anti_squat"]["values"][20] == pytest.approx(
        2.7 / 0.55 * 0.0592816 / rise, rel=1e-5
    )


def test_points_of_all_poses(cli) -> None:
    found = cli("kinematics", RIG, *TRAVEL, "--points", "--json").json
    assert found["lower_ball_joint.z"]["values"][20] == pytest.approx(0.140, abs=1e-12)
    assert cli("kinematics", RIG, "--roll", "-1 deg:1 deg:1 deg", "--points").exit_code == 2


def test_changes_are_swept(cli) -> None:
    plain = cli("kinematics", RIG, *TRAVEL, "--json").json
    moved = cli(
        "kinematics", RIG, *TRAVEL, "--json", "--set", "hardpoints.tie_rod_inner[2]=190 mm"
    ).json
    assert moved["bump_steer"]["values"][20] != plain["bump_steer"]["values"][20]


def test_files_and_pictures(cli, tmp_path: Path) -> None:
    for file in (sweep := tmp_path / "sweep.nc", sheet := tmp_path / "curves" / "wheel.png"):
        file.parent.mkdir(exist_ok=True)
        file.write_bytes(b"mine")
    for words in (("--out", "sweep.nc"), ("--figure", "curves")):
        refused = cli("kinematics", RIG, *TRAVEL, *words)
        assert refused.exit_code == 2
        assert "--force" in refused.err
    assert sweep.read_bytes() == sheet.read_bytes() == b"mine"
    assert (
        cli(
            "kinematics", RIG, *TRAVEL, "--out", "sweep.nc", "--figure", "curves", "--force"
        ).exit_code
        == 0
    )
    with xr.open_dataset(tmp_path / "sweep.nc", engine="h5netcdf") as read:
        assert read["camber"].shape == (41,)
        assert read["camber"].attrs["units"] == "rad"
    sheets = [file.read_bytes() for file in (tmp_path / "curves").iterdir()]
    assert len(sheets) > 5
    assert all(drawn.startswith(b"\x89PNG") for drawn in sheets)


def test_travel_beyond_reach_keeps_the_rest(cli, tmp_path: Path) -> None:
    outcome = cli(
        "kinematics", RIG, "--travel", "-300 mm:80 mm:4 mm", "--out", "sweep.csv", "--json"
    )
    assert outcome.exit_code == 2
    assert outcome.err.count("\n") == 1
    assert "end of its travel at wheel travel -245 mm" in outcome.err
    assert "upper_ball_joint" in outcome.err
    values = outcome.json["wheel_travel"]["values"]
    assert values[0] == pytest.approx(-0.244)
    assert len((tmp_path / "sweep.csv").read_text(encoding="utf-8").splitlines()) == len(values) + 1


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (("--travel", "80 mm:-80 mm:4 mm"), "does not lead from the first to the last value"),
        (("--travel", "10 mm:10 mm:4 mm"), "range is empty"),
        (("--travel", "-80 mm:80 mm:-4 mm"), "does not lead from the first to the last value"),
        (("--travel", "-80 mm:80 mm:0 mm"), "invalid step"),
        (("--travel", "-80 mm:80 mm"), "invalid range"),
        (("--travel", "-80 mm:80 mm:1 nm"), "too many"),
        (("--travel", ""), "invalid range"),
        (("--travel", "-80 deg:80 deg:4 deg"), "wrong unit"),
        (("--travel", "500 mm"), "no pose of the sweep can be reached"),
        ((), "nothing to sweep is given"),
        (("--axle",), "nothing to sweep is given"),
        (
            ("--roll", "-2 deg:2 deg:1 deg", "--travel", "0 mm"),
            "wheel travel follows from the roll angle and cannot be set",
        ),
        (("--roll", "-2 deg:2 deg:1 deg", "--rack", "-1 mm:1 mm:1 mm"), "only a single value"),
        (("--roll", "80 deg"), "too steep"),
        ((*TRAVEL, "--vehicle", "axle=front"), "wheelbase"),
        ((*TRAVEL, "--set", "hardpoints.upper=1"), "hardpoints.upper"),
        ((*TRAVEL, "--out", "sweep.xlsx"), "not written in this format"),
    ],
)
def test_mistakes_get_one_clear_message(cli, words: tuple[str, ...], text: str) -> None:
    outcome = cli("kinematics", RIG, *words)
    assert outcome.exit_code == 2
    assert text in outcome.err
    assert outcome.out == ""


def test_a_lumped_rig_is_refused(cli) -> None:
    outcome = cli("kinematics", "kart-quarter-car", *TRAVEL, "--json")
    assert outcome.exit_code == 2
    assert "a lumped rig has no kinematics" in outcome.err
    assert outcome.json["error"]["kind"] == "DescriptionError"


def test_a_trailing_arm_has_no_steering_rows(cli) -> None:
    found = cli("kinematics", "semi-trailing-arm", *TRAVEL, "--json").json
    assert "camber" in found
    assert not {"caster", "scrub_radius", "steer_gain", "kingpin_inclination"} & set(found)
    assert cli("kinematics", "semi-trailing-arm", "--rack", "-1 mm:1 mm:1 mm").exit_code == 2


def test_an_axle_pose_by_pose_with_a_right_corner_of_its_own(cli, tmp_path) -> None:
    rig = jn.load("formula-student-front")
    other = jn.save(
        rig.mirrored().with_changes({"hardpoints.upper_ball_joint[1]": "-541 mm"}),
        tmp_path / "right.toml",
    )
    given = [
        "--heave",
        "-10 mm:0 mm:5 mm",
        "--roll",
        "1 deg",
        "--pitch",
        "0.5 deg",
        "--rack",
        "3 mm",
    ]
    outcome = cli("kinematics", "formula-student-front", *given, "--right", str(other), "--json")
    assert outcome.exit_code == 0, outcome.err
    wanted = jn.sweep_axle(
        rig,
        right=jn.load(other),
        heave=[-0.01, -0.005, 0.0],
        roll=np.radians(1.0),
        pitch=np.radians(0.5),
        rack=0.003,
    )
    for name in ("right.camber_to_ground", "left.wheel_travel", "track"):
        assert outcome.json[name]["values"] == pytest.approx(
            wanted[name].to_numpy().tolist(), abs=1e-12
        ), name
    table = cli(
        "kinematics",
        "formula-student-front",
        "--left-travel",
        "10 mm",
        "--right-travel",
        "-5 mm:5 mm:5 mm",
    )
    assert table.exit_code == 0
    assert "roll_angle" in table.out


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--heave", "0 mm", "--travel", "0 mm"], "--left-travel"),
        (["--heave", "0 mm", "--left-travel", "1 mm"], "a body attitude are both given"),
        (["--handwheel", "90 deg"], "the rack has no handwheel"),
        (["--pitch", "0 mm"], "rad"),
        (["--heave", "0 mm", "--right", "formula-student-front"], "not a right corner"),
    ],
)
def test_bad_poses_of_an_axle_are_refused(cli, arguments, message: str) -> None:
    outcome = cli("kinematics", "formula-student-front", *arguments)
    assert outcome.exit_code == 2
    assert message in outcome.err


def test_poses_of_a_log_are_swept_one_by_one(cli, tmp_path) -> None:
    log = tmp_path / "log.csv"
    log.write_text(
        "# a lap\ntime [s], travel [mm], rack [mm]\n0, 0, 0\n0.1, 8, -3\n0.2, 5, -12\n",
        encoding="utf-8",
    )
    outcome = cli("kinematics", "formula-student-front", "--poses", str(log), "--json")
    assert outcome.exit_code == 0, outcome.err
    wanted = jn.sweep_path(
        jn.load("formula-student-front"), [0.0, 0.008, 0.005], [0.0, -0.003, -0.012]
    )
    for name in ("camber", "rack_travel", "wheel_travel"):
        assert outcome.json[name]["values"] == wanted[name].to_numpy().tolist()
    table = cli("kinematics", "formula-student-front", "--poses", str(log))
    assert table.exit_code == 0, table.err
    assert "over pose" in table.out
    log.write_text("roll [deg], heave [mm]\n0, 0\n1, -4\n", encoding="utf-8")
    axle = cli("kinematics", "formula-student-front", "--poses", str(log), "--json")
    assert axle.json["roll_angle"]["values"] == pytest.approx([0.0, np.radians(1.0)])
    for text, message in (
        ("speed [m/s]\n1\n", "the poses are neither those of a wheel"),
        ("travel [deg]\n1\n", "travel"),
        ("travel\n1\n", "no unit"),
        ("travel [mm], roll [deg]\n1, 1\n", "the poses are neither those of a wheel"),
        ("travel [m]\n20\n", "Millimetres meant"),
    ):
        log.write_text(text, encoding="utf-8")
        refused = cli("kinematics", "formula-student-front", "--poses", str(log))
        assert refused.exit_code == 2
        assert message in refused.err, text
    both = cli("kinematics", "formula-student-front", "--poses", str(log), "--travel", "0 mm")
    assert "not available for individual poses" in both.err
