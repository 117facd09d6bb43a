"""Testers of shock absorbers as descriptions: the shipped ones, and files that are refused."""

from __future__ import annotations

import pytest

from jounce.core.errors import DescriptionError
from jounce.parts import load
from jounce.parts.testers import Tester, library, load_tester
from jounce.parts.vehicles import axle_from, axle_of

GOOD = """schema = "jounce.tester/1"
kind = "sprung-plate"
method = "theta"
stroke = "6.5 mm"
plate_mass = "20 kg"
plate_spring_rate = "50 N/mm"
programme = {start_frequency = "12 Hz"}
[columns]
"left.plate.z" = "s_left [mm]"
"""


@pytest.mark.parametrize("name", ["eusama", "egea-specsus2018", "theta-msd3000", "boge"])
def test_every_shipped_tester_says_what_is_estimated(name):
    tester = load_tester(name)
    assert tester.source
    known = {"stroke", "plate_mass", "plate_spring_rate", "plate_damping_coefficient"}
    for path in tester.estimated:
        table, _, field = path.partition(".")
        assert path in known or hasattr(getattr(tester, table), field), path


def test_the_shipped_names_are_these():
    assert sorted(library()) == ["boge", "egea-specsus2018", "eusama", "theta-msd3000"]


def test_egea_holds_longer_under_more_load():
    programme = load_tester("egea-specsus2018").programme
    assert programme.hold(5000.0) == pytest.approx(1.2 + 0.16e-3 * 5000.0, rel=1e-12)
    assert programme.length(5000.0) == pytest.approx(2.0 + 25.0 / 2.5, rel=1e-12)


def test_columns_of_the_records_are_in_the_same_file(tmp_path):
    file = tmp_path / "lane.toml"
    file.write_text(GOOD)
    tester = load_tester(file)
    assert tester.columns == {"left.plate.z": "s_left [mm]"}
    assert tester.name == "lane"
    assert tester.amplitude == pytest.approx(3.25e-3, rel=1e-12)


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ('stroke = "6.5 mm"', 'stroke = "-6 mm"', "above 0"),
        ('stroke = "6.5 mm"', 'stroke = "6 kg"', "wrong unit"),
        ('plate_spring_rate = "50 N/mm"', "", "plate_spring_rate"),
        ('kind = "sprung-plate"', 'kind = "rigid-plate"', "a rigid plate must not have it"),
        ('kind = "sprung-plate"', 'kind = "rigid"', "rigid-plate"),
        ('method = "theta"', 'method = "thetta"', "theta"),
        ('start_frequency = "12 Hz"', 'start_frequency = "12 Hz", run_down = "free"', "inertia"),
        (
            'start_frequency = "12 Hz"',
            'start_frequency = "12 Hz", rundown = "free"',
            "Did you mean 'run_down'",
        ),
        (
            "[columns]",
            'limits = {wheel_load_min = "9 kN", wheel_load_max = "1 kN"}\n[columns]',
            "not below",
        ),
        ("jounce.tester/1", "jounce.rig/1", "schema"),
    ],
)
def test_bad_files_are_refused_with_a_reason(tmp_path, old, new, says):
    file = tmp_path / "bad.toml"
    assert old in GOOD
    file.write_text(GOOD.replace(old, new))
    with pytest.raises(DescriptionError, match=says):
        load_tester(file)


def test_an_unknown_tester_is_named_with_the_nearest():
    with pytest.raises(DescriptionError, match="Did you mean 'eusama'"):
        load_tester("eusamma")


def test_changes_make_a_copy():
    tester = load_tester("eusama")
    changed = tester.with_changes({"stroke": "8 mm", "programme.sweep_rate": "1 Hz/s"})
    assert (changed.amplitude, changed.programme.sweep_rate) == (
        pytest.approx(0.004, rel=1e-12),
        1.0,
    )
    assert tester.amplitude == 0.003
    with pytest.raises(DescriptionError):
        tester.with_changes({"stroke": "-8 mm"})
    with pytest.raises(DescriptionError):
        tester.with_changes({"plates.stroke": "8 mm"})
    assert isinstance(changed, Tester)


def test_an_axle_carries_its_share_of_the_body():
    car = load("audi-a6-full-car")
    axle = axle_of(car, "rear")
    share = car.front.distance / car.wheelbase
    assert axle.mass == pytest.approx(share * car.body.mass, rel=1e-12)
    assert axle.roll_inertia == pytest.approx(share * car.body.roll_inertia, rel=1e-12)
    assert axle.anti_roll_bar_rate == car.rear.anti_roll_bar_rate
    assert not axle.estimated
    assert "roll_inertia" in axle_of(load("audi-a6-half-car-4dof"), "front").estimated


def test_two_quarter_cars_keep_their_loads_as_an_axle():
    light, heavy = (
        load("audi-a6-quarter-car"),
        load("audi-a6-quarter-car").with_changes({"sprung.mass": 500.0}),
    )
    axle = axle_from(light, heavy, track=1.5)
    assert axle.mass * axle.right.distance / 1.5 == pytest.approx(light.sprung.mass, rel=1e-12)
    assert axle.mass * axle.left.distance / 1.5 == pytest.approx(heavy.sprung.mass, rel=1e-12)


def test_cars_without_tyres_have_no_axle_for_a_tester():
    with pytest.raises(DescriptionError, match="no tyres"):
        axle_of(load("audi-a6-half-car"), "front")
    with pytest.raises(DescriptionError, match="front, rear"):
        axle_of(load("audi-a6-full-car"), "middle")
