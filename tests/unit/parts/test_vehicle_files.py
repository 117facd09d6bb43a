"""Vehicle files: what they hold, what is refused and how, paths and changes, text and back."""

from __future__ import annotations

import pytest

import jounce as jn
from jounce import parts
from jounce.parts.files import VEHICLES, rig_text
from jounce.parts.rig import unit_of

HALF = """
schema = "jounce.vehicle/1"
model = "half-car"
[body]
mass = "1636 kg"
pitch_inertia = "2500 kg*m^2"
[front]
distance = "1.29 m"
spring_rate = "28000 N/m"
damping_coefficient = "3000 N*s/m"
[rear]
distance = "1.62 m"
spring_rate = "21000 N/m"
damping_coefficient = "2500 N*s/m"
"""
NAMES = ("audi-a6-half-car", "sldemo-half-car", "audi-a6-half-car-4dof", "audi-a6-full-car")
FULL = parts.library()["audi-a6-full-car"].read_text(encoding="utf-8")


def loaded(tmp_path, text: str):
    file = tmp_path / "car.toml"
    file.write_text(text, encoding="utf-8")
    return jn.load(file)


def test_the_file_of_the_issue_is_the_shipped_car(tmp_path):
    car = loaded(tmp_path, HALF)
    assert type(car) is jn.HalfCar
    assert car.compat == "physical"
    assert car.parameters() == jn.load("audi-a6-half-car").parameters()
    assert car.wheelbase == pytest.approx(2.91, abs=1e-15)
    assert car.corners == ("front", "rear")


@pytest.mark.parametrize("name", NAMES)
def test_shipped_vehicles(name, tmp_path):
    car = jn.load(name)
    assert isinstance(car, jn.Vehicle)
    assert type(car) is VEHICLES[car.model]
    assert car.source
    for path in car.estimated:
        assert path in car.parameters(), path
    assert loaded(tmp_path, rig_text(car)) == car
    for path in car.parameters():
        assert unit_of(car, path) in {"m", "kg", "kg*m^2", "N/m", "N*s/m", "m/s^2"}, path


def test_wheels_stand_where_they_stand():
    full, half = jn.load("audi-a6-full-car"), jn.load("audi-a6-half-car")
    assert {corner: tuple(place) for corner, place in full.wheels.items()} == {
        "front_left": (0.0, 1),
        "front_right": (0.0, -1),
        "rear_left": (full.wheelbase, 1),
        "rear_right": (full.wheelbase, -1),
    }
    assert [tuple(place) for place in half.wheels.values()] == [(0.0, 0), (half.wheelbase, 0)]
    for compat in ("simulink", "sign-corrected"):
        both = half.with_changes({"compat": compat})
        assert [tuple(place) for place in both.wheels.values()] == [(0.0, 0), (0.0, 0)]
        assert both.wheelbase == half.wheelbase


def test_changes_leave_the_car_alone():
    car = jn.load("audi-a6-full-car")
    other = car.with_changes(
        {"front.spring_rate": "30 N/mm", "rear.tyre.lift_off": False, "front.bump_stop": STOP}
    )
    assert other.front.spring_rate == 30e3
    assert other.front.bump_stop.gap == 0.1
    assert other.rear.tyre.lift_off is False
    assert car.front.spring_rate == 28e3
    assert car.front.bump_stop is None


STOP = {"gap": "100 mm", "rate": "100 N/mm"}


def test_constants_are_laws_of_their_own():
    axle = jn.load("audi-a6-full-car").front
    assert axle.spring_law.rate == 28e3
    assert axle.spring_law.preload == 0.0
    assert axle.damper_law.coefficient == 3e3


def test_a_table_in_place_of_a_constant(tmp_path):
    text = FULL.replace(
        'spring_rate = "28000 N/m"', 'spring = {rate = "28000 N/m", preload = "100 N"}'
    )
    text = text.replace(
        'damping_coefficient = "2500 N*s/m"',
        'damper = {bump_coefficient = "1500 N*s/m", rebound_coefficient = "3500 N*s/m"}',
    )
    car = loaded(tmp_path, text)
    assert car.front.spring_law.preload == 100.0
    assert car.rear.damper_law.kind == "bilinear"
    assert "rear.damper.rebound_coefficient" in car.parameters()
    assert "rear.damping_coefficient" not in car.parameters()


def test_built_in_python_and_written():
    axle = {"distance": 1.0, "spring_rate": 2e4, "damping_coefficient": 1e3}
    car = jn.HalfCar(body={"mass": "1 t", "pitch_inertia": 2000.0}, front=axle, rear=axle)
    assert rig_text(car).startswith('schema = "jounce.vehicle/1"\nmodel = "half-car"\n')


BAD = {
    "negative wheelbase": (
        '"1.29 m"',
        '"-1.29 m"',
        "line 8: front.distance: out of range; found '-1.29 m'; allowed: above 0 m",
    ),
    "no distance at all": ('"1.29 m"', "0", "front.distance: out of range"),
    "missing key": (
        'pitch_inertia = "2500 kg*m^2"\n',
        "",
        "line 4: body.pitch_inertia: the key is missing",
    ),
    "missing axle": (HALF[HALF.index("[rear]") :], "", "rear: the key is missing"),
    "misspelt form": ("[body]", 'compat = "simulnik"\n[body]', "compat: .*Did you mean 'simulink'"),
    "form with a blank": (
        "[body]",
        'compat = "sign corrected"\n[body]',
        "Did you mean 'sign-corrected'",
    ),
    "misspelt model": (
        '"half-car"',
        '"half-cra"',
        "unknown model 'half-cra'.*Did you mean 'half-car'",
    ),
    "no model": ('model = "half-car"\n', "", "the key 'model' is missing; allowed: half-car, "),
    "a rig's schema": ("vehicle/1", "rig/1", 'schema = "jounce.vehicle/1"'),
    "later schema": ("vehicle/1", "vehicle/2", "found 'jounce.vehicle/2'"),
    "misspelt key": (
        "spring_rate",
        "springrate",
        "line 9: front.springrate: unknown key.*Did you mean 'spring_rate'",
    ),
    "NaN": ('"1636 kg"', "nan", "body.mass: not a finite number"),
    "infinite": ('"1636 kg"', "inf", "body.mass: not a finite number"),
    "wrong unit": (
        '"1636 kg"',
        '"1636 N"',
        "body.mass: wrong unit; found '1636 N'; allowed: a unit that converts to kg",
    ),
    "no unit": ('"1636 kg"', '"1636"', "the unit is missing"),
    "driving damper": ('"3000 N*s/m"', '"-3000 N*s/m"', "front.damping_coefficient: out of range"),
    "soft spring": ('"28000 N/m"', '"0 N/m"', "front.spring_rate: out of range"),
    "mass without weight": ('"1636 kg"', '"0 kg"', "body.mass: out of range"),
    "wheel of a half car": (
        "[rear]",
        '[rear]\nunsprung_mass = "4 kg"',
        "rear.unsprung_mass: unknown key",
    ),
    "third axle": ("[rear]", "[middle]\n[rear]", "middle: unknown key"),
    "height below the road": ("[front]", 'height = "-0.5 m"\n[front]', "body.height: out of range"),
}


@pytest.mark.parametrize("case", BAD)
def test_refused(case, tmp_path):
    old, new, message = BAD[case]
    assert old in HALF
    with pytest.raises(jn.DescriptionError, match=message) as caught:
        loaded(tmp_path, HALF.replace(old, new, 1))
    assert str(tmp_path / "car.toml") in str(caught.value)


BAD_FULL = {
    "no track": ('track = "1.54 m"\n', "", "front.track: the key is missing"),
    "negative track": ('track = "1.54 m"', 'track = "-1.54 m"', "front.track: out of range"),
    "no roll inertia": (
        'roll_inertia = "600 kg*m^2"\n',
        "",
        "body.roll_inertia: the key is missing",
    ),
    "negative bar": ('"12 N/mm"', '"-12 N/mm"', "front.anti_roll_bar_rate: out of range"),
    "form": (
        'model = "full-car"',
        'model = "full-car"\ncompat = "simulink"',
        "compat: unknown key",
    ),
    "two dampers": (
        'spring_rate = "28',
        'damper = {coefficient = 3}\nspring_rate = "28',
        "damping_coefficient and damper",
    ),
    "no damper": (
        'damping_coefficient = "3000 N*s/m"\n',
        "",
        "exactly one of damping_coefficient, damper; found none",
    ),
    "tyre by the old key": ("tyre = {stiffness", "tyre = {stiffnes", "Did you mean 'stiffness'"),
    "stop without rate": (
        "[rear]",
        '[front.bump_stop]\ngap = "20 mm"\n[rear]',
        "front.bump_stop.rate: the key is missing",
    ),
}


@pytest.mark.parametrize("case", BAD_FULL)
def test_full_cars_refused(case, tmp_path):
    old, new, message = BAD_FULL[case]
    assert old in FULL
    with pytest.raises(jn.DescriptionError, match=message):
        loaded(tmp_path, FULL.replace(old, new, 1))


@pytest.mark.parametrize(
    ("car", "loads", "message"),
    [
        ("audi-a6-half-car", {"deceleration": 3.0}, "trial: deceleration.*Give body.height"),
        (
            "audi-a6-half-car-4dof",
            {"lateral_acceleration": 3.0},
            "trial: lateral_acceleration.*allowed: pitch_moment, dec",
        ),
        ("kart-quarter-car", {"pitch_moment": 3.0}, "trial: pitch_moment.*the road only"),
        ("audi-a6-half-car", {"right": jn.Flat()}, "right is for full cars"),
        ("kart-quarter-car", {"right": jn.Flat()}, "right is for full cars"),
    ],
)
def test_what_a_model_does_not_feel_is_refused(car, loads, message):
    with pytest.raises(jn.SimulationError, match=message) as caught:
        jn.simulate(jn.load(car), jn.Trial(road=jn.Flat(), speed=1.0, duration=0.1, **loads))
    assert "lateral" not in message or "body.height" not in str(caught.value)


def test_a_full_car_without_height_says_how_to_corner():
    car = jn.load("audi-a6-full-car").with_changes({"body.height": None})
    trial = jn.Trial(road=jn.Flat(), speed=1.0, duration=0.1, lateral_acceleration=3.0)
    with pytest.raises(jn.SimulationError, match=r"Give body\.height"):
        jn.simulate(car, trial)
