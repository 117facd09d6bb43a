"""Numbers by path, copies with other values, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import jounce as jn
from jounce import parts
from jounce.core.errors import DescriptionError
from jounce.parts.rig import result_unit_of, split_path, structure_of, unit_of

KART = parts.load("kart-quarter-car")
TABLE_TYRE = KART.with_changes(
    {
        "tyre.stiffness": None,
        "tyre.curve": {
            "kind": "table",
            "deflection": [0.0, 0.001, 0.003],
            "force": [0.0, 90.0, 350.0],
        },
    }
)
EVERYTHING = TABLE_TYRE.with_changes(
    {
        "strut.friction": {"force": 5.0},
        "guide.friction": {"force": 2.0},
        "strut.bump_stop": {"gap": 0.01, "rate": 6e4, "progression": 1e8},
        "strut.damper": {"velocity": [-1.0, 0.0, 1.0], "force": [-100.0, 0.0, 60.0]},
    }
)


def test_every_number_has_its_path():
    assert KART.parameters() == {
        "gravity": 9.81,
        "sprung.mass": 16.0,
        "unsprung.mass": 5.0,
        "strut.angle": pytest.approx(np.radians(26.0)),
        "strut.spring.rate": 22730.0,
        "strut.spring.preload": 0.0,
        "strut.damper.coefficient": 150.0,
        "tyre.stiffness": 138468.0,
        "tyre.damping_coefficient": 0.0,
    }


def test_tables_are_numbered():
    found = EVERYTHING.parameters()
    assert found["tyre.curve.force[1]"] == 90.0
    assert found["strut.damper.velocity[2]"] == 1.0
    assert found["guide.friction.regularisation_velocity"] == 0.002
    assert "tyre.stiffness" not in found


@pytest.mark.parametrize("rig", [KART, EVERYTHING], ids=["kart", "everything"])
def test_every_path_can_be_changed_and_only_it_changes(rig):
    before = rig.parameters()
    for path, value in before.items():
        changed = rig.with_changes({path: value + 1e-4})
        assert changed.parameters() == {**before, path: value + 1e-4}
    assert rig.parameters() == before, "nothing is ever mutated"


def test_frozen():
    with pytest.raises(
        DescriptionError,
        match=r"gravity: .* cannot be modified.*: with_changes\(\{'gravity': 1.0\}\)",
    ):
        KART.gravity = 1.0
    with pytest.raises(
        DescriptionError,
        match=r"rate: .* cannot be modified.*model_copy\(update=\{'rate': 1.0\}\).*rig.with_changes",
    ):
        KART.strut.spring.rate = 1.0
    with pytest.raises(DescriptionError, match=r"cannot be modified.*with_changes"):
        del KART.gravity
    with pytest.raises(DescriptionError, match=r"unknown field 'gravty'.*'gravity'"):
        KART.gravty = 1.0


def test_a_copy_with_other_fields_is_checked():
    assert KART.model_copy(update={"gravity": "1 g"}).gravity == pytest.approx(9.80665)
    for wrong in ({"sprung": 3}, {"sprug": KART.sprung}, {"gravity": "1 kg"}):
        with pytest.raises(DescriptionError):
            KART.model_copy(update=wrong)


def test_changes_read_units():
    changed = KART.with_changes(
        {"strut.spring.rate": "25 N/mm", "strut.angle": "10 deg", "gravity": "1 g"}
    )
    assert changed.strut.spring.rate == pytest.approx(25000.0)
    assert changed.strut.angle == pytest.approx(np.radians(10.0))
    assert changed.gravity == pytest.approx(9.80665)


def test_a_part_may_be_exchanged():
    changed = KART.with_changes(
        {"strut.damper": {"bump_coefficient": 80.0, "rebound_coefficient": 240.0}}
    )
    assert changed.strut.damper.kind == "bilinear"
    assert changed.strut.spring == KART.strut.spring


def test_bump_stop_may_stand_at_the_top():
    table = KART.model_dump(by_alias=True, exclude_none=True)
    moved = parts.QuarterCar.from_table({**table, "bump_stop": {"gap": "10 mm", "rate": "60 N/mm"}})
    assert moved.strut.bump_stop.gap == 0.01
    assert KART.strut.bump_stop is None


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        (
            {"strut.spring.rat": 1.0},
            "strut.spring.rat: unknown key; allowed: curve, preload, rate. Did you mean 'rate'?",
        ),
        ({"gravty": 1.0}, "gravty: unknown key.*Did you mean 'gravity'"),
        (
            {"strut.damper.force[0]": 1.0},
            r"strut.damper.force\[0\]: unknown parameter.*strut.damper.coefficient",
        ),
        ({"strut.spring.rate[0]": 1.0}, "unknown parameter"),
        (
            {"strut.spring.rate": "25 Nmm"},
            "strut.spring.rate: wrong unit; found '25 Nmm'.*converts to N/m",
        ),
        ({"strut.spring.rate": "25"}, "the unit is missing.*'25 N/m'"),
        ({"strut.spring.rate": "25 kg"}, "wrong unit"),
        ({"strut.spring.rate": -3.0}, "out of range; found -3.0; allowed: above 0 N/m"),
        ({"sprung.mass": "0 kg"}, "sprung.mass: out of range; found '0 kg'; allowed: above 0 kg"),
        ({"strut.angle": "80 deg"}, "out of range.*at least 0, at most 1.2 rad"),
        ({"tyre.damping_coefficient": -1.0}, "at least 0"),
        ({"strut.spring.rate": float("nan")}, "not a finite number"),
        ({"strut.spring.rate": float("inf")}, "not a finite number"),
        ({"strut.spring.rate": True}, "invalid physical value"),
        ({"strut.spring.rate": [1.0]}, "invalid physical value"),
        ({"strut.spring.rate": None}, "give exactly one of rate, curve; found none"),
        (
            {"strut.spring.curve": {"kind": "polynomial", "coefficients": [1.0]}},
            "exactly one.*found rate and curve",
        ),
        (
            {"tyre.curve": {"kind": "polynomial", "coefficients": [1.0]}},
            "exactly one.*found stiffness and curve",
        ),
        ({"tyre.lift_off": "maybe"}, "tyre.lift_off: input should be a valid boolean"),
        ({"tyre": 3}, "tyre: input should be a valid dictionary"),
        ({"strut.friction.force": "-5 N"}, "at least 0 N"),
        ({"strut.friction": {"force": 1.0, "regularisation_velocity": 0.0}}, "above 0 m/s"),
        ({"strut.bump_stop": {"gap": 0.01}}, "strut.bump_stop.rate: the key is missing"),
        ({"strut..x": 1.0}, "invalid path"),
        ({"": 1.0}, "invalid path"),
        ({"model": "half-car"}, "quarter-car"),
    ],
    ids=str,
)
def test_refused(changes, expected):
    with pytest.raises(DescriptionError, match=f"(?s){expected}"):
        KART.with_changes(changes)


DAMPER = "strut.damper"


@pytest.mark.parametrize(
    ("damper", "expected"),
    [
        (
            {"velocity": [0.0, 1.0, 1.0], "force": [0.0, 1.0, 2.0]},
            r"velocity\[2\] = 1 is not above velocity\[1\]",
        ),
        (
            {"velocity": [0.0, 1.0, 0.5], "force": [0.0, 1.0, 2.0]},
            r"velocity\[2\] = 0.5 is not above",
        ),
        (
            {"velocity": [0.0, 1.0], "force": [0.0, 1.0, 2.0]},
            "velocity has 2 points and force has 3",
        ),
        ({"velocity": [0.0], "force": [0.0]}, "at least 2"),
        ({"bump_coefficient": 1.0}, "rebound_coefficient: the key is missing"),
        ({"kind": "bouc-wen", "coefficient": 1.0}, "hysteretic_force: the key is missing"),
        (
            {
                "kind": "bouc-wen",
                "coefficient": 1.0,
                "hysteretic_force": 1.0,
                "rate": 1.0,
                "sigma": 0.4,
                "exponent": 1.0,
            },
            "at least 0.5",
        ),
        (
            {"kind": "tanhh", "coefficient": 1.0},
            "'tanhh'; allowed: linear, bilinear, blow-off, table, clicks, tanh, bouc-wen.*'tanh'",
        ),
        (
            {"coefficient": 1.0, "bump_coefficient": 2.0, "rebound_coefficient": 2.0},
            "coefficient: unknown key",
        ),
    ],
    ids=str,
)
def test_refused_dampers(damper, expected):
    with pytest.raises(DescriptionError, match=f"(?s)strut.damper.*{expected}"):
        KART.with_changes({DAMPER: damper})


@pytest.mark.parametrize(
    ("curve", "expected"),
    [
        (
            {"kind": "table", "deflection": [0.0, 0.0], "force": [0.0, 1.0]},
            r"deflection\[1\] = 0 is not above",
        ),
        ({"kind": "polynomial", "coefficients": []}, "coefficients"),
        ({"kind": "power", "coefficient": 1.0, "exponent": 0.0}, "exponent.*above 0"),
        ({"kind": "spline"}, "'spline'; allowed: polynomial, power, table"),
        ({"coefficients": [1.0]}, "the key 'kind', which selects the kind, is missing"),
    ],
    ids=str,
)
def test_refused_curves(curve, expected):
    with pytest.raises(DescriptionError, match=f"(?s)tyre.curve.*{expected}"):
        KART.with_changes({"tyre.stiffness": None, "tyre.curve": curve})


def test_refusal_of_a_damper_speaks_english():
    with pytest.raises(DescriptionError) as caught:
        KART.with_changes({DAMPER: {"kind": "tanhh"}})
    assert "damper_kind" not in str(caught.value)


@pytest.mark.parametrize("number", [np.int64(25000), np.float32(25000.0)], ids=["int64", "float32"])
def test_numbers_of_arrays_are_numbers(number):
    assert KART.with_changes({"strut.spring.rate": number}).strut.spring.rate == 25000.0


def test_float64_is_a_number():
    assert (
        KART.with_changes({"strut.spring.rate": np.float64(25000.0)}).strut.spring.rate == 25000.0
    )


def test_paths_are_split():
    assert split_path("tyre.curve.coefficients[1]") == ["tyre", "curve", "coefficients", 1]
    assert split_path("a[0][12].b-c") == ["a", 0, 12, "b-c"]


def test_units_by_path():
    units = {path: unit_of(EVERYTHING, path) for path in EVERYTHING.parameters()}
    assert units["strut.bump_stop.progression"] == "N/m^3"
    assert units["guide.friction.regularisation_velocity"] == "m/s"
    assert units["tyre.curve.deflection[1]"] == "m"
    assert units["strut.damper.force[0]"] == "N"
    assert units["gravity"] == "m/s^2"
    assert "1" not in units.values()


def test_structure_is_blind_to_numbers_only():
    assert structure_of(KART) == structure_of(
        KART.with_changes(dict.fromkeys(KART.parameters(), 0.5))
    )
    assert structure_of(KART) == structure_of(KART.model_copy(update={"source": "another, 3"}))
    others = [
        {"tyre.lift_off": False},
        {"strut.friction": {"force": 1.0}},
        {"strut.spring": {"curve": None, "rate": 1.0, "preload": 1.0}},
        {"strut.damper": {"velocity": [0.0, 1.0], "force": [0.0, 1.0]}},
        {"strut.damper": {"velocity": [0.0, 1.0, 2.0], "force": [0.0] * 3}},
    ]
    structures = [structure_of(KART.with_changes(change)) for change in others]
    assert structures[2] == structure_of(KART)
    assert len({structure_of(KART), *structures}) == 5


@given(st.floats(-1e30, 1e30).filter(lambda x: x == 0.0 or abs(x) > 1e-300))
def test_structure_of_any_number(value):
    assert structure_of(KART.with_changes({"strut.spring.preload": value})) == structure_of(KART)


def test_library():
    shipped = parts.library()
    assert {"kart-quarter-car", "audi-a6-quarter-car"} <= set(shipped)
    for name, path in shipped.items():
        rig = parts.load(name)
        assert parts.load(path) == rig
        assert rig.source, name
        starts = tuple(rig.parameters())
        assert all(
            any(path == part or path.startswith((f"{part}.", f"{part}[")) for path in starts)
            for part in rig.estimated
        )


def test_unknown_rig():
    with pytest.raises(
        DescriptionError, match=r"(?s)kart-quarter-cat.*Did you mean 'kart-quarter-car'"
    ):
        parts.load("kart-quarter-cat")
    with pytest.raises(DescriptionError, match="no such file"):
        parts.load("missing.toml")


@pytest.mark.parametrize(
    "changes", [{1: 2.0}, {None: 2.0}, [("strut.spring.rate", 2.0)], "strut.spring.rate", None]
)
def test_what_is_no_change_is_told(changes: object) -> None:
    with pytest.raises(DescriptionError, match=r"changes: no changes are given; .*values by path"):
        parts.load("kart-quarter-car").with_changes(changes)


def test_coefficients_of_curves_are_shown_in_the_unit_of_their_power() -> None:
    cubic = {"curve": {"kind": "polynomial", "coefficients": [1.4e5, 0.0, 3.0e6]}}
    rig = jn.load("kart-quarter-car").with_changes({"tyre": cubic})
    shown = [result_unit_of(rig, f"tyre.curve.coefficients[{i}]") for i in range(3)]
    assert shown == ["N/m", "N/m^2", "N/m^3"]
    assert unit_of(rig, "tyre.curve.coefficients[2]") == "1"  # what a file takes
    assert result_unit_of(rig, "sprung.mass") == "kg"
