"""Files of full cars on 3-D corners: corners by name and by file, and what is wrong with them."""

from __future__ import annotations

import pytest

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.parts import FullCar3D, library

CAR = library()["formula-student-car"].read_text(encoding="utf-8")
CORNER = library()["formula-student-front"].read_text(encoding="utf-8")


def written(folder, change=("", ""), corner=None):
    file = folder / "car.toml"
    text = CAR if corner is None else CAR.replace('"formula-student-front"', corner)
    file.write_text(text.replace(*change) if change[0] else text, encoding="utf-8")
    return file


def message(file):
    with pytest.raises(DescriptionError) as error:
        jn.load(file)
    return str(error.value)


def test_a_corner_is_a_shipped_rig_or_a_file_beside_the_vehicle(tmp_path):
    (tmp_path / "own.toml").write_text(CORNER, encoding="utf-8")
    by_file, by_name = (
        jn.load(written(tmp_path, corner='"own.toml"')),
        jn.load("formula-student-car"),
    )
    assert by_file.front.corner == by_name.front.corner == jn.load("formula-student-front")
    assert by_name.parameters()["front.corner.tyre.stiffness"] == 105e3


def test_a_change_of_one_corner_is_one_of_its_axle():
    car = jn.load("formula-student-car").with_changes({"rear.corner.tyre.stiffness": "90 N/mm"})
    assert (car.front.corner.tyre.stiffness, car.rear.corner.tyre.stiffness) == (105e3, 90e3)


def test_a_corner_that_names_nothing_gets_the_nearest_name(tmp_path):
    said = message(written(tmp_path, corner='"formula-student-frnt"'))
    assert "car.toml, line 16: front.corner" in said
    assert "Did you mean 'formula-student-front'?" in said


@pytest.mark.parametrize(
    "corner", ['"kart-quarter-car"', '"audi-a6-full-car"', "3", '"none.toml"', '["a"]']
)
def test_what_is_no_corner_is_refused_where_it_stands(tmp_path, corner):
    assert "car.toml, line 16: front.corner" in message(written(tmp_path, corner=corner))


def test_errors_of_a_corner_are_said_of_its_own_file_and_line(tmp_path):
    wrong = CORNER.replace('stiffness = "105 N/mm"', 'stiffness = "-105 N/mm"')
    (tmp_path / "wrong.toml").write_text(wrong, encoding="utf-8")
    line = 1 + wrong.splitlines().index('stiffness = "-105 N/mm"')
    said = message(written(tmp_path, corner='"wrong.toml"'))
    assert f"wrong.toml, line {line}: tyre.stiffness" in said
    assert "car.toml" not in said


def test_a_corner_file_that_is_no_toml_is_named(tmp_path):
    (tmp_path / "broken.toml").write_text(CORNER.replace("[tyre]", "[tyre"), encoding="utf-8")
    assert "broken.toml: not valid TOML" in message(written(tmp_path, corner='"broken.toml"'))


def test_a_negative_distance_is_refused(tmp_path):
    said = message(written(tmp_path, change=('distance = "790 mm"', 'distance = "-790 mm"')))
    assert "front.distance: out of range; found '-790 mm'" in said


def test_a_right_corner_is_refused():
    car = jn.load("formula-student-car")
    table = car.model_dump(by_alias=True, exclude_none=True)
    table["front"]["corner"] = car.front.corner.mirrored().model_dump(
        by_alias=True, exclude_none=True
    )
    with pytest.raises(DescriptionError, match="the right one is its mirror"):
        FullCar3D.from_table(table)


def test_a_joint_has_three_coordinates():
    with pytest.raises(DescriptionError, match="three values along x, y and z"):
        jn.load("kart-whole-vehicle").with_changes({"body.joint": [0.0, 0.35]})


@pytest.mark.parametrize(
    ("change", "named"),
    [
        ({"body.mass": "250 kg"}, 2),
        ({"front.corner.tyre.stiffness": "90 N/mm"}, 1),
        ({"front.corner.hardpoints.tie_rod_inner[2]": "151 mm"}, 1),
    ],
)
def test_a_car_is_saved_over_a_file_that_names_its_corners(tmp_path, change, named):
    """The name stays where the corner is as it was; else its table takes the name's place."""
    (tmp_path / "own.toml").write_text(CORNER, encoding="utf-8")
    (tmp_path / "elsewhere").mkdir()
    file = written(tmp_path, corner='"own.toml"')
    car = jn.load(file).with_changes(change)
    there = jn.save(car, tmp_path / "elsewhere" / "car.toml", like=file)
    jn.save(car, file, force=True)
    assert jn.load(file) == jn.load(there) == car
    assert file.read_text(encoding="utf-8").count('corner = "own.toml"') == named
    assert there.read_text(encoding="utf-8").count('corner = "../own.toml"') == named
    assert CAR.splitlines()[0] in there.read_text(encoding="utf-8")


def test_a_named_corner_of_other_parts_becomes_a_table(tmp_path):
    car = jn.load("formula-student-car")
    strut = car.front.corner.strut.model_copy(update={"bump_stop": None})
    corner = car.front.corner.model_copy(update={"strut": strut})
    without = car.model_copy(update={"front": car.front.model_copy(update={"corner": corner})})
    file = jn.save(without, tmp_path / "car.toml", like="formula-student-car")
    assert jn.load(file) == without != car
