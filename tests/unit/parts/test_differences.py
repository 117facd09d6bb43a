"""What differs between descriptions: only that, with units, and with digits that tell the values apart."""

from __future__ import annotations

import pytest

import jounce as jn

RIG = jn.load("kart-quarter-car")


def test_only_what_differs_is_listed_with_its_unit() -> None:
    others = {
        "stiff": RIG.with_changes({"strut.spring.rate": "25 N/mm"}),
        "heavy": RIG.with_changes({"sprung.mass": "60 kg"}),
    }
    listed = jn.compare_descriptions({"as it is": RIG} | others)
    rate, mass = RIG.parameters()["strut.spring.rate"], RIG.parameters()["sprung.mass"]
    assert listed.names == ("as it is", "stiff", "heavy")
    assert {row.path: (row.unit, row.values) for row in listed.rows} == {
        "sprung.mass": ("kg", (mass, mass, 60.0)),
        "strut.spring.rate": ("N/m", (rate, 25e3, rate)),
    }


def test_equal_descriptions_and_remarks_do_not_differ() -> None:
    remarked = RIG.model_copy(update={"source": "from elsewhere"})
    listed = jn.compare_descriptions({"one": RIG, "other": remarked})
    assert listed.rows == ()
    assert str(listed) == "one, other: no differences"


def test_rounding_of_other_units_is_no_difference() -> None:
    rate = RIG.parameters()["strut.spring.rate"]
    same = RIG.with_changes({"strut.spring.rate": rate * (1.0 + 2e-16 * 4)})
    assert jn.compare_descriptions({"one": RIG, "other": same}).rows == ()


def test_close_values_get_the_digits_that_tell_them_apart() -> None:
    moved = {"z": 125.5, "a little": 125.501}
    rig = jn.load("kart-double-wishbone")
    path = "hardpoints.wheel_centre[2]"
    rigs = {name: rig.with_changes({path: f"{z} mm"}) for name, z in moved.items()}
    (row,) = jn.compare_descriptions(rigs).rows
    assert row.cells() == (("125.500", "125.501"), "mm")


def test_parts_of_other_kinds_differ_in_what_each_has() -> None:
    other = jn.load("formula-student-front")
    listed = jn.compare_descriptions({"kart": jn.load("kart-double-wishbone"), "car": other})
    values = {row.path: row.values for row in listed.rows}
    assert values["strut.damper.kind"] == ("linear", "bilinear")
    assert values["strut.damper.coefficient"][1] is None
    assert values["strut.on"] == ("lower_arm", "rocker")
    assert {row.path: row.cells() for row in listed.rows}["strut.spring.preload"] == (
        ("–", "1047"),
        "N",
    )


def test_trials_are_compared_too() -> None:
    def trial(speed: str) -> jn.Trial:
        return jn.Trial(
            road=jn.HalfSine(height="10 mm", length="60 mm"), speed=speed, duration="1 s"
        )

    (row,) = jn.compare_descriptions({"slow": trial("2 m/s"), "fast": trial("3 m/s")}).rows
    assert (row.path, row.unit, row.values) == ("speed", "m/s", (2.0, 3.0))


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"one": RIG}, "nothing to compare"),
        ({"one": RIG, "other": "rig.toml"}, "not a description"),
    ],
)
def test_what_cannot_be_compared_is_refused(given: dict, said: str) -> None:
    with pytest.raises(jn.DescriptionError, match=said):
        jn.compare_descriptions(given)
